// What firmware/apps/controlled_stop prints on a board, on the host, for float and fixed point; without costs.
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <cinttypes>
#include <cstdio>

#include <firmware/apps/controlled_stop/broken_pair.hpp>
#include <firmware/apps/controlled_stop/sequence.hpp>

#include "../property/fixed/without_costs.hpp"

namespace {

template <class Robot, class T>
void print(const char* number) {
  const auto all = axial::apps::controlled_stop::report<Robot, T>(property::WithoutCosts{});
  std::printf("controlled-stop%s-%s,%016" PRIx64 ",%d\n", number, Robot::name, all.hash, all.to_rest);
  const auto broken = axial::apps::broken_pair::report<Robot, T>();
  std::printf("broken-pair%s-%s,%016" PRIx64 ",%d,%d,%d\n", number, Robot::name, broken.hash, broken.soonest,
              broken.latest, broken.refused);
}

}  // namespace

int main() {
  print<robots::Scara, float>("");
  print<robots::Scara, axial::Fixed32>("-fixed");
  print<robots::Puma560, float>("");
  print<robots::Puma560, axial::Fixed32>("-fixed");
}
