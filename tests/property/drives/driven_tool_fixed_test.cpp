// J^T w of joints that share drives in fixed point: the product of its words whatever they are, and within its
// certified error of J G, both in 113 bits and G by hand.
#include <robots/robots.hpp>

#include "constrained.hpp"
#include "driven_robots.hpp"
#include "driven_states.hpp"

namespace {

using namespace axial;
using constrained::quad;
using T = Fixed32;
using Push = ForceVector<Vec3<T>, Vec3<T>>;

/// A robot with a declared wrench at its tip and a tool beside the last axis.
template <class R>
struct Pushed {
  static constexpr const char* name = R::name;
  static constexpr auto chain = [] {
    auto c = R::chain;
    c.tip_wrench_limit = tip_wrench_limit(60.0, 12.0);
    c.tool = tool(0.05, -0.02, 0.15);
    return c;
  }();
};

template <class R>
class DrivenTool {
 public:
  using Robot = Pushed<R>;
  using State = exhaustive::FixedState<Robot, T>;
  using F = InputFormats<Robot, T>;
  static constexpr int drives = joint_count<Robot>;
  static constexpr int turn = direction_exponent<T> - column_headroom<Robot>,
                       length = length_exponent<Robot, T> - column_headroom<Robot>;

  static quad part(const Vec3<T>& v, int i, int exponent) {
    return quad((i == 0 ? v.x.raw : i == 1 ? v.y.raw : v.z.raw) * detail::power_of_two(-exponent));
  }
  static double off(const WrenchEfforts<Robot, T>& tau, int k, quad exact) {
    return std::fabs(static_cast<double>(quad(property::real(tau, k)) - exact));
  }
  State next(int k) {
    auto state = exhaustive::next_state<State>(random, static_cast<std::uint64_t>(k % 4));
    property::hold_joints<Robot>(state, true);
    return state;
  }
  std::int32_t word() { return static_cast<std::int32_t>(random.bits()); }
  /// As long as declared, any way.
  Vec3<T> vector(double most, int exponent) {
    const double x = word(), y = word(), z = word(), size = std::hypot(x, y, z);
    const auto of = [&](double v) { return T{static_cast<std::int32_t>(std::ldexp(most * v / size, exponent))}; };
    return {of(x), of(y), of(z)};
  }

  /// In units of the result.
  void expect_products(int states) {
    constexpr std::int32_t ends[] = {INT32_MAX, INT32_MIN};
    double worst = 0.0;
    for (int s = 0; s < states; ++s) {
      const auto j = jacobian<Robot>(next(s).q);
      const auto any = [&] { return T{s % 2 == 0 ? ends[word() & 1] : word()}; };
      const Push w{{any(), any(), any()}, {any(), any(), any()}};
      const auto tau = transpose_times(j, w);
      for (int k = 0; k < drives; ++k) {
        quad exact = 0;
        for (int c = 0; c < 3; ++c)
          exact += part(j[k].angular, c, turn) * part(w.moment, c, F::tip_moment) +
                   part(j[k].linear, c, length) * part(w.force, c, F::tip_force);
        worst = std::fmax(worst, std::ldexp(off(tau, k, exact), tau.exponent(k)));
      }
    }
    EXPECT_LE(worst, 0.5 + 1e-6) << R::name;
    EXPECT_GT(worst, 0.4) << R::name;
  }
  /// Against the Jacobian of the joints times G.
  template <class G, class Chain, class Positions>
  void expect_certified(int states, const G& g, const Chain& chain, const Positions& positions) {
    constexpr auto bound = error_bound<Robot, T>(algorithm::TransposeTimes{});
    double nearest[drives] = {};
    for (int s = 0; s < states; ++s) {
      const auto state = next(s);
      const Push w{vector(F::wrench.moment, F::tip_moment), vector(F::wrench.force, F::tip_force)};
      const auto j = jacobian<Robot>(state.q);
      if (!j.status.ok()) continue;
      const auto tau = transpose_times(j, w);
      oracle::Vector<quad> u;
      for (int k = 0; k < drives; ++k)
        u.push_back(quad(property::real(state.q, k)));
      const auto exact = oracle::tool_jacobian(chain, positions(u));
      for (int k = 0; k < drives; ++k) {
        oracle::Vector<quad> unit(std::size_t(drives), quad(0));
        unit[std::size_t(k)] = 1;
        const auto angular = exact.angular * (g * unit), linear = exact.linear * (g * unit);
        quad effort = 0;
        for (int c = 0; c < 3; ++c)
          effort += angular[std::size_t(c)] * part(w.moment, c, F::tip_moment) +
                    linear[std::size_t(c)] * part(w.force, c, F::tip_force);
        nearest[k] = std::fmax(nearest[k], off(tau, k, effort) / bound[k]);
      }
    }
    for (int k = 0; k < drives; ++k) {
      EXPECT_LE(nearest[k], 1.0) << R::name << " " << k;
      EXPECT_GT(nearest[k], 0.002) << R::name << " " << k;
      std::printf("%s %d: %.3f of its certified error\n", R::name, k, nearest[k]);
    }
  }

 private:
  exhaustive::Random random{17};
};

template <class R>
void expect_tool() {
  DrivenTool<R> tool;
  tool.expect_products(2000);
  const auto exact = constrained::Constrained::of<R>();
  auto chain = exact.chain();
  chain.tool = oracle::of_robot<quad, Pushed<R>>().tool;
  tool.expect_certified(600, exact.g(), chain, [&](const auto& u) { return exact.positions(u); });
}

}  // namespace

TEST(TransposeTimesOfDrives, IsTheProductOfItsWordsAndWithinItsCertifiedError) {
  expect_tool<robots::WristArm>();
  expect_tool<robots::ScaraQuill>();
  expect_tool<robots::Palletiser>();
}
