// expect: joint values are axial::Joints, or arrays with one number for each joint
// within: 5 lines
// at most: 12 lines
#include <array>
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Number = float;
#else
using Number = int;
#endif

auto accelerate(const std::array<Number, 3>& q) { return axial::forward_dynamics<robots::Scara>(q, q, q); }
