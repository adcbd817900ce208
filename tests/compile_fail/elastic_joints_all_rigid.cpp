// expect: no joint of the robot is elastic
#include <axial/axial.hpp>

struct Arm {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().mass(1).com(0.5, 0, 0).stiffness(1000));
#else
  static constexpr auto chain = axial::chain(axial::revolute().mass(1).com(0.5, 0, 0));
#endif
};

auto drive(const axial::Joints<Arm, float>& q) { return axial::elastic_feedforward<Arm>(q, q, q, q, q); }
