// What firmware/apps/fixed prints on a board, on the host; costs are 0.
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <cinttypes>
#include <cstdio>

#include <firmware/apps/fixed/golden.hpp>

#include "without_costs.hpp"

namespace {

template <class R>
void print() {
  axial::apps::fixed::all_golden<R>(property::WithoutCosts{}, [](const axial::apps::fixed::Golden& g) {
    std::printf("fixed,%s,%s,%s,%016" PRIx64 ",%u,%u\n", g.kernel, R::name, g.arithmetic, g.hash, g.least, g.most);
  });
}

}  // namespace

int main() {
  print<robots::Scara>();
  print<robots::Puma560>();
  std::puts("end");
}
