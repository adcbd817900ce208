// What firmware/apps/fixed prints on a board, on the host, and robots whose joints share drives; costs are 0.
#include <robots/palletiser.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>
#include <robots/wrist_arm.hpp>

#include <cinttypes>
#include <cstdio>

#include <firmware/apps/fixed/golden.hpp>

#include "without_costs.hpp"

namespace {

using namespace axial::apps::fixed;

template <class R>
void put(const Golden& g) {
  std::printf("fixed,%s,%s,%s,%016" PRIx64 ",%u,%u\n", g.kernel, R::name, g.arithmetic, g.hash, g.least, g.most);
}
template <class R>
void print() {
  all_golden<R>(property::WithoutCosts{}, put<R>), all_golden_derivatives<R>(property::WithoutCosts{}, put<R>);
  all_golden_looped<R>(property::WithoutCosts{}, put<R>);
}
template <class R>
void print_drives() {
  all_golden_drives<R>(property::WithoutCosts{}, put<R>);
}

}  // namespace

int main() {
  print<robots::Scara>();
  print<robots::Puma560>();
  print_drives<robots::WristArm>();
  print_drives<robots::Palletiser>();
  std::puts("end");
}
