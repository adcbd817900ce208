// expect: dry friction jumps at rest and has no rate
#include <axial/axial.hpp>
#include <robots/scara.hpp>

using R = robots::Scara;
#ifdef MENDED
using S = axial::Scene<R, axial::Gravity>;
#else
using S = axial::Scene<R, axial::Gravity, axial::Friction>;
#endif

auto rates(const axial::Joints<R, float>& q) { return axial::torque_rates<S>(q, q, q, q, q); }
