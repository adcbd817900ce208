// expect: ignoring return value of
#include <axial/axial.hpp>
#include <robots/scara.hpp>

int main() {
  const axial::Joints<robots::Scara, float> q{};
#ifdef MENDED
  const auto answer = axial::forward_dynamics<robots::Scara>(q, q, q);
  static_cast<void>(answer);
#else
  axial::forward_dynamics<robots::Scara>(q, q, q);
#endif
}
