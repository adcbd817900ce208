// Any tree of joints as MDH rows.
#pragma once

#include <host_sim/import/imported.hpp>
#include <host_sim/import/source_tree.hpp>

namespace importer {

/// Frame 0 shares origin height and z axis with the source's root; a link's x axis is the common normal to its main
/// child's axis (the child that carries most joints), other children leave by gamma and b (Khalil and Kleinfinger
/// 1986). The sign of a normal keeps theta within 90 degrees. Parallel axes have d = 0. Links on fixed joints are
/// merged into the moving one that carries them. Limits that are missing stay missing. Gravity is in axes of the
/// source's root.
Imported to_mdh(const SourceTree& source, const axial::GravityVector& gravity);

}  // namespace importer
