#include <host_sim/robots/import/bodies.hpp>

namespace importer {

Body body_of(const SourceLink& link, const Pose& pose) {
  if (!link.has_inertial) return {};
  const Pose inertial{orthonormal(link.inertial.rotation.data()),
                      {link.inertial.position[0], link.inertial.position[1], link.inertial.position[2]}};
  const auto& j = link.inertia;
  Matrix tensor;
  tensor << j[0], j[3], j[4], j[3], j[1], j[5], j[4], j[5], j[2];
  const Pose centre = pose * inertial;
  return {link.mass, centre.position, centre.rotation * tensor * centre.rotation.transpose()};
}

Body merged(const std::vector<Body>& bodies) {
  if (bodies.size() == 1) return bodies.front();
  Body sum;
  for (const Body& body : bodies) {
    sum.mass += body.mass;
    sum.com += body.mass * body.com;
  }
  sum.com = sum.mass > 0.0L ? Vector(sum.com / sum.mass) : Vector(Vector::Zero());
  for (const Body& body : bodies) {
    const Vector way = body.com - sum.com;
    sum.inertia += body.inertia + body.mass * (way.dot(way) * Matrix::Identity() - way * way.transpose());
  }
  return sum;
}

}  // namespace importer
