// What firmware/apps/fixed prints on a board, on the host, robots whose joints share drives, and motions; costs are 0.
#include <robots/palletiser.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>
#include <robots/wrist_arm.hpp>

#include <cinttypes>
#include <cstdio>

#include <firmware/apps/fixed/golden.hpp>

#include "without_costs.hpp"

#ifndef AXIAL_GOLDEN_PART
#define AXIAL_GOLDEN_PART 0  // all; or a part, which a compiler has the memory for
#endif

namespace {

using namespace axial::apps::fixed;

template <class R>
void put(const Golden& g) {
  std::printf("fixed,%s,%s,%s,%016" PRIx64 ",%u,%u\n", g.kernel, R::name, g.arithmetic, g.hash, g.least, g.most);
}
/// Whether this program has a part.
constexpr bool has(int part) { return AXIAL_GOLDEN_PART == 0 || AXIAL_GOLDEN_PART == part; }

template <class R>
void print() {
  if constexpr (has(1)) all_golden<R>(property::WithoutCosts{}, put<R>);
  if constexpr (has(2)) all_golden_derivatives<R>(property::WithoutCosts{}, put<R>);
  if constexpr (has(3)) all_golden_looped<R>(property::WithoutCosts{}, put<R>);
}
template <class R, int Part>
void print_drives() {
  if constexpr (has(Part)) all_golden_drives<R>(property::WithoutCosts{}, put<R>);
}

template <class R>
void print_motions() {
  if constexpr (has(6)) all_golden_motions<R>(property::WithoutCosts{}, put<R>);
}

}  // namespace

int main() {
  print<robots::Scara>();
  print<robots::Puma560>();
  print_drives<robots::WristArm, 4>();
  print_drives<robots::Palletiser, 5>();
  print_motions<robots::Scara>();
  print_motions<robots::Puma560>();
  std::puts("end");
}
