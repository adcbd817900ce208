// What firmware/apps/safe_loop prints on a board, on the host, for float and fixed point; without costs.
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <cinttypes>
#include <cstdio>

#include <firmware/apps/safe_loop/sequence.hpp>

#include "../property/fixed/without_costs.hpp"

namespace {

template <class Robot, class T>
void print(const char* number) {
  const auto all = axial::apps::safe_loop::report<Robot, T>(property::WithoutCosts{});
  std::printf("safe-loop%s-%s,%016" PRIx64 ",%d,%d\n", number, Robot::name, all.hash, all.met, all.refused);
}

template <class Robot>
void print() {
  print<Robot, float>("");
  print<Robot, axial::Fixed32>("-fixed");
}

}  // namespace

int main() {
  print<robots::Scara>();
  print<robots::Puma560>();
  print<robots::Panda>();
}
