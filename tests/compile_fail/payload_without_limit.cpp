// expect: axial::payload_limit(mass, com_reach, inertia) to its chain
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0), axial::payload_limit(1.0, 0.1, 0.01));
#else
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0));
#endif
};
using Scene = axial::Scene<Robot, axial::Gravity, axial::Payload>;

axial::Joints<Robot, float> drive(axial::FeedforwardState<Scene, float>& state, const axial::Joints<Robot, float>& q,
                                  const axial::Inputs<Scene, float>& in) {
  return axial::feedforward<Scene>(state, q, q, q, in).tau;
}
