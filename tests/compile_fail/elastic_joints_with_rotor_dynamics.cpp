// expect: elastic_feedforward leaves out how rotors turn with their links
#include <axial/axial.hpp>

struct Arm {
  static constexpr auto chain =
      axial::chain(axial::revolute().mass(1).com(0.5, 0, 0).rotor_inertia(1e-4, 100).stiffness(1000));
};
#ifdef MENDED
using S = axial::Scene<Arm, axial::Gravity, axial::RotorInertia, axial::ElasticJoints>;
#else
using S = axial::Scene<Arm, axial::Gravity, axial::RotorInertia, axial::RotorDynamics, axial::ElasticJoints>;
#endif

auto drive(const axial::Joints<Arm, float>& q) { return axial::elastic_feedforward<S>(q, q, q, q, q); }
