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
  using namespace axial::apps::fixed;
  const auto put = [](const Golden& g) {
    std::printf("fixed,%s,%s,%s,%016" PRIx64 ",%u,%u\n", g.kernel, R::name, g.arithmetic, g.hash, g.least, g.most);
  };
  all_golden<R>(property::WithoutCosts{}, put), all_golden_derivatives<R>(property::WithoutCosts{}, put);
}

}  // namespace

int main() {
  print<robots::Scara>();
  print<robots::Puma560>();
  std::puts("end");
}
