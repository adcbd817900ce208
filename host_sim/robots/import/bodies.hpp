// Bodies that are fixed to each other, as one.
#pragma once

#include <host_sim/robots/import/geometry.hpp>
#include <host_sim/robots/import/source_tree.hpp>

#include <vector>

namespace importer {

/// Mass, centre of mass and inertia about it, in axes of some frame.
struct Body {
  Real mass = 0.0L;
  Vector com = Vector::Zero();
  Matrix inertia = Matrix::Zero();
};

/// The body of a link, in a frame in which the link's own frame has a pose.
Body body_of(const SourceLink& link, const Pose& pose);

/// All as one body, in the same frame.
Body merged(const std::vector<Body>& bodies);

}  // namespace importer
