// Any tree of joints as MDH rows.
#pragma once

#include <host_sim/robots/import/imported.hpp>
#include <host_sim/robots/import/right_angles.hpp>
#include <host_sim/robots/import/source_tree.hpp>

namespace importer {

/// Frame 0 shares origin height and z axis with the source's root; a link's x axis is the common normal to its main
/// child's axis (the child that carries most joints), other children leave by gamma and b (Khalil and Kleinfinger
/// 1986). The sign of a normal keeps theta within 90 degrees. Parallel axes have d = 0. Links on fixed joints are
/// merged into the moving one that carries them, or into the base's body where the root floats. Limits that are missing
/// stay missing. Gravity is in axes of the source's root.
///
/// Where something is near, axes of joints are settled first, from the root outwards: turned onto the axes of the frame
/// that carries them, shifted onto its z axis, to its origin or to a length that the source writes. `source` has what
/// was changed afterwards, in its joints and among its changes.
Imported to_mdh(SourceTree& source, const axial::GravityVector& gravity, const Nearness& near);

}  // namespace importer
