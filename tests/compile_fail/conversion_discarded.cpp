// expect: ignoring return value of
// within: 5 lines
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

int main() {
  const axial::Joints<robots::Scara, float> q{};
#ifdef MENDED
  const auto answer = axial::to_fixed<axial::Positions<robots::Scara, axial::Fixed32>>(q);
  static_cast<void>(answer);
#else
  axial::to_fixed<axial::Positions<robots::Scara, axial::Fixed32>>(q);
#endif
}
