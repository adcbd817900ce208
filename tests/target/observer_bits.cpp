// What firmware/apps/observer prints on a board, on the host, for float and fixed point; without costs.
#include <robots/panda.hpp>

#include <cinttypes>
#include <cstdio>

#include <firmware/apps/observer/sequence.hpp>

#include "../property/fixed/without_costs.hpp"

namespace {

template <class T>
void print(const char* image) {
  using Scene = axial::Scene<robots::Panda, axial::Gravity, axial::RotorInertia>;
  const auto all = axial::apps::observer::report<Scene, T>(property::WithoutCosts{});
  std::printf("%s,%016" PRIx64 ",%d,%d\n", image, all.hash, all.refused, all.collisions);
  const auto load = axial::apps::observer::weighing<Scene, T>(property::WithoutCosts{});
  std::printf("%s-weighing,%016" PRIx64 ",%d\n", image, load.hash, load.ready);
}

}  // namespace

int main() {
  print<float>("observer-panda");
  print<axial::Fixed32>("observer-fixed-panda");
}
