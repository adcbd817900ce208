// expect: axial: the scene names run-time inputs (in.payload, ...)
// within: 6 lines
// at most: 12 lines
#include <axial/axial.hpp>

struct Robot {
  static constexpr auto chain =
      axial::chain(axial::gravity(0, 0, -9.81), axial::revolute().mass(1.0), axial::payload_limit(1.0, 0.1, 0.01));
};
using Scene = axial::Scene<Robot, axial::Gravity, axial::Payload>;

axial::Joints<Robot, float> hold(axial::SafeLoopState<Scene, float>& state, const axial::Joints<Robot, float>& q) {
#ifdef MENDED
  axial::Inputs<Scene, float> in;
  return axial::compensate_gravity<Scene>(state, q, in).tau;
#else
  return axial::compensate_gravity<Scene>(state, q).tau;
#endif
}
