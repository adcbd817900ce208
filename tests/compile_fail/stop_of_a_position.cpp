// expect: axial: a controlled stop begins with a motion
// within: 6 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

using Robot = robots::Scara;
struct Stop {
  static constexpr double period = 1e-3;
};

bool follow(axial::FallBack<Robot, float, Stop>& fall_back, const axial::Request<Robot, float>& wanted,
            const axial::Joints<Robot, float>& tau) {
#ifdef MENDED
  return fall_back.follow(wanted, tau);
#else
  return fall_back.follow(wanted.q, tau);
#endif
}
