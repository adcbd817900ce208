// expect: axial: joint values are axial::Joints, or arrays with one number for each joint
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Number = float;
#else
using Number = double;
#endif

bool step(axial::FeedforwardState<robots::Scara, float>& state, const Number (&q)[3]);
bool step(axial::FeedforwardState<robots::Scara, float>& state, const Number (&q)[3]) {
  return axial::feedforward<robots::Scara>(state, q, q, q).status.ok();
}
