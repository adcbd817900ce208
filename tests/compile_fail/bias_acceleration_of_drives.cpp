// expect: columns of drives are no axes
#include <axial/axial.hpp>
#include <robots/scara_quill.hpp>

#ifdef MENDED
using R = axial::JointCoordinates<robots::ScaraQuill>;
#else
using R = robots::ScaraQuill;
#endif

auto bias(const axial::Joints<R, float>& q, const axial::Joints<R, float>& qd) {
  return axial::bias_acceleration(axial::jacobian<R>(q), qd);
}
