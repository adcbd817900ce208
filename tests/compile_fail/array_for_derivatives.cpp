// expect: axial: joint values are axial::Joints, or arrays with one number for each joint
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Numbers = float[3];
#else
using Numbers = float[4];
#endif

float slope(const Numbers& q);
float slope(const Numbers& q) { return axial::inverse_dynamics_derivatives<robots::Scara>(q, q, q).dtau_dq(0, 0); }
