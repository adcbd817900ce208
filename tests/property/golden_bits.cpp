// What firmware/apps/fixed prints on a board, on the host, robots whose joints share drives, and motions; costs are 0.
#include <axial/fixed/simulation/integrators.hpp>
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

/// Motions of as many steps from as many states, by efforts at random: words, what rounding left, statuses.
template <class R, class Method, class T>
void print_motions(const char* kernel, const char* arithmetic) {
  using S = axial::Scene<R, axial::Gravity, axial::RotorInertia>;
  constexpr int motions = 16, steps = 64;
  Random random;
  Hash hash;
  for (int k = 0; k < motions; ++k) {
    auto call = next_call<S, T>(random, k);
    axial::Motion<S, T> x;
    x.q = call.q;
    for (int i = 0; i < R::chain.size; ++i)
      x.qd[i].raw = static_cast<typename T::Word>(call.qd[i].raw / 4);
    for (int step = 0; step < steps; ++step) {
      if (step % 8 == 0) call = next_call<S, T>(random, k);
      const auto status = axial::advance<Method>(x, 1e-3 / (k + 1), axial::Held<S, T>{call.tau, {}});
      hash.add(static_cast<std::int32_t>(status.code)), hash.add(status.joint);
    }
    add_words(hash, x.q), add_words(hash, x.qd);
    for (int i = 0; i < R::chain.size; ++i)
      hash.add(x.q_rest[i]), hash.add(x.qd_rest[i]);
    hash.add(static_cast<std::int32_t>(x.steps));
  }
  put<R>({kernel, arithmetic, hash.value(), 0, 0});
}
template <class R>
void print_all_motions() {
  if constexpr (has(6)) {
    print_motions<R, axial::RungeKutta4, axial::Fixed32>("runge_kutta_4", "32_nearest");
    print_motions<R, axial::SemiImplicitEuler, axial::Fixed32>("semi_implicit", "32_nearest");
  }
}

}  // namespace

int main() {
  print<robots::Scara>();
  print<robots::Puma560>();
  print_drives<robots::WristArm, 4>();
  print_drives<robots::Palletiser, 5>();
  print_all_motions<robots::Scara>();
  print_all_motions<robots::Puma560>();
  std::puts("end");
}
