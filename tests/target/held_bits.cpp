// What firmware/apps/held prints on a board, on the host; without costs.
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <cinttypes>
#include <cstdio>

#include <firmware/apps/held/sequence.hpp>

#include "../property/fixed/without_costs.hpp"

namespace {

template <class Robot>
void print() {
  const auto all = axial::apps::held::report<Robot>(property::WithoutCosts{});
  std::printf("held-%s,%016" PRIx64 ",%d,%d\n", Robot::name, all.hash, all.stuck, all.stopped);
}

}  // namespace

int main() {
  print<robots::Scara>();
  print<robots::Puma560>();
}
