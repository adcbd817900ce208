// expect: joint values are axial::Joints<Robot, float>, not an array
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Values = axial::Joints<robots::Scara, float>;
#else
using Values = float[3];
#endif

auto effort(const Values& q) { return axial::inverse_dynamics<robots::Scara>(q, q, q); }
