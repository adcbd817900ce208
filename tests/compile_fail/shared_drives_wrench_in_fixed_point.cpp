// expect: J^T w of joints that share drives has no formats in fixed point
#include <axial/fixed.hpp>
#include <robots/gripper.hpp>

struct Pushed {
  static constexpr auto chain = [] {
    auto c = robots::Gripper::chain;
    c.tip_wrench_limit = axial::tip_wrench_limit(10.0, 1.0);
    return c;
  }();
};
#ifdef MENDED
using T = float;
#else
using T = axial::Fixed32;
#endif

auto efforts(const axial::Positions<Pushed, T>& u, const axial::ForceVector<axial::Vec3<T>, axial::Vec3<T>>& wrench) {
  return axial::transpose_times(axial::jacobian<Pushed>(u), wrench);
}
