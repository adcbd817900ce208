// What firmware/apps/fixed prints on a board, on the host; costs are 0.
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <cinttypes>
#include <cstdio>

#include <firmware/apps/fixed/golden.hpp>

namespace {

struct Nothing {
  template <class Code>
  std::uint32_t operator()(Code& code) const {
    code();
    return 0;
  }
};

template <class R>
void print() {
  axial::apps::fixed::all_golden<R>(Nothing{}, [](const axial::apps::fixed::Golden& g) {
    std::printf("fixed,%s,%s,%s,%016" PRIx64 ",%u,%u\n", g.kernel, R::name, g.arithmetic, g.hash, g.least, g.most);
  });
}

}  // namespace

int main() {
  print<robots::Scara>();
  print<robots::Puma560>();
  std::puts("end");
}
