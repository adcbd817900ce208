// Mass and inertia of MJCF bodies: as given, or of the shapes that are fixed to them.
#pragma once

#include <host_sim/robots/import/bodies.hpp>
#include <host_sim/robots/import/mjcf/settings.hpp>

#include <optional>

namespace importer::mjcf {

/// The body of a geom, in the frame of the MJCF body that it is fixed to; nothing where its group does not count, or it
/// has no mass. By its mass or its density; on its surface alone where shellinertia says so. Refuses a mesh, and sizes
/// that are missing or not above 0.
std::optional<Body> body_of_geom(const Attributes& geom, const Settings& settings);

/// The body of an <inertial>.
Body body_of_inertial(const Attributes& inertial, const Settings& settings);

/// The same with least mass and moments, and balanced where the settings ask for it.
Body bounded(const Body& body, const Settings& settings);

}  // namespace importer::mjcf
