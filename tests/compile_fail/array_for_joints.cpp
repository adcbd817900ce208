// expect: joint values are axial::Joints, or arrays with one number for each joint
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Values = float[3];
#else
using Values = float[6];
#endif

auto effort(const Values& q) { return axial::inverse_dynamics<robots::Scara>(q, q, q); }
