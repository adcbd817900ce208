// expect: axial: friction that sticks has no smooth_speed()
#include <axial/axial.hpp>
#include <axial/simulation/sticking.hpp>

struct Block {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::gravity(0, 0, 0), axial::prismatic().mass(2.0).coulomb(5.0));
#else
  static constexpr auto chain =
      axial::chain(axial::gravity(0, 0, 0), axial::prismatic().mass(2.0).coulomb(5.0).smooth_speed(0.01));
#endif
};
using Scene = axial::Scene<Block, axial::Friction>;

int main() {
  axial::Motion<Scene, float> x;
  return static_cast<int>(axial::advance<axial::StickingEuler>(x, 1e-3F, axial::Held<Scene, float>{}).code);
}
