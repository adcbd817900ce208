// expect: elastic_feedforward takes joints as elastic
#include <axial/axial.hpp>

struct Arm {
  static constexpr auto chain = axial::chain(axial::revolute().mass(1).com(0.5, 0, 0).stiffness(1000));
};
#ifdef MENDED
using S = axial::Scene<Arm, axial::Gravity, axial::ElasticJoints>;
#else
using S = axial::Scene<Arm, axial::Gravity>;
#endif

auto drive(const axial::Joints<Arm, float>& q) { return axial::elastic_feedforward<S>(q, q, q, q, q); }
