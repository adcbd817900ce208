// Motions in 32-bit words of robots that nobody tuned for, beside the same steps of the oracle's accelerations in
// double: what is off is what words lose.
#include <axial/fixed/simulation/integrators.hpp>

#include <oracle/convert.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/recursive.hpp>

#include <property/untuned/untuned_reference.hpp>

namespace property {
namespace {

constexpr double h = 0x1p-12;  // s, exact
constexpr int steps = 16, runs = 60;
/// Of the largest declared acceleration: three to thirty times what was seen.
constexpr double allowed = 1e-5;

/// The oracle's motion, by either method.
class Reference {
 public:
  Reference(const oracle::Chain<double>& chain, oracle::Vector<double> start, oracle::Vector<double> speeds)
      : q(std::move(start)), qd(std::move(speeds)), chain_(chain) {}
  void step(axial::SemiImplicitEuler, const oracle::Vector<double>& tau) {
    move(qd, h, accelerations(q, qd, tau)), move(q, h, qd);
  }
  void step(axial::RungeKutta4, const oracle::Vector<double>& tau) {
    oracle::Vector<double> rates[4] = {}, slopes[4] = {};
    constexpr double reach[] = {0.0, h / 2, h / 2, h};
    for (int k = 0; k < 4; ++k) {
      auto at = q;
      rates[k] = qd;
      if (k > 0) move(at, reach[k], rates[k - 1]), move(rates[k], reach[k], slopes[k - 1]);
      slopes[k] = accelerations(at, rates[k], tau);
    }
    constexpr double share[] = {h / 6, h / 3, h / 3, h / 6};
    for (int k = 0; k < 4; ++k)
      move(q, share[k], rates[k]), move(qd, share[k], slopes[k]);
  }
  oracle::Vector<double> q, qd;

 private:
  oracle::Vector<double> accelerations(const oracle::Vector<double>& at, const oracle::Vector<double>& speeds,
                                       const oracle::Vector<double>& tau) const {
    return oracle::recursive_forward_dynamics(chain_, at, speeds, tau);
  }
  static void move(oracle::Vector<double>& x, double by, const oracle::Vector<double>& rate) {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += by * rate[i];
  }
  const oracle::Chain<double>& chain_;
};

template <class R>
class Moving : public testing::Test {
 protected:
  using Base = UntunedReference<R>;
  using S = axial::Scene<R, axial::Gravity, axial::RotorInertia>;
  using Words = axial::Motion<S, axial::Fixed32>;

  const UntunedReference<R> robot;
  const oracle::Chain<double> chain = oracle::of_robot<double, R>();

  static oracle::Vector<double> vector(const typename Base::Values& x) {
    return oracle::Vector<double>(x.values, x.values + R::chain.size);
  }
  /// Whether a motion from a state stayed inside all limits; what it is off, over what is allowed after its time.
  template <class Method>
  bool follow(typename Base::State state, double& worst) const {
    Base::hold_positions(state);
    for (int i = 0; i < R::chain.size; ++i)
      state.qd[i].raw /= 4, state.qdd[i].raw /= 4;
    const auto q = Base::values(state.q, true), qd = Base::values(state.qd);
    axial::Held<S, axial::Fixed32> held;
    const auto tau = axial::inverse_dynamics(robot.model(), q, qd, Base::values(state.qdd));
    for (int i = 0; i < R::chain.size; ++i)
      held.tau[i].raw = axial::detail::to_word<std::int32_t>(tau[i], held.tau.exponent(i));
    Words x;
    x.q = state.q, x.qd = state.qd;
    Reference reference(chain, vector(q), vector(qd));
    const auto efforts = vector(Base::values(held.tau));
    for (int k = 0; k < steps; ++k) {
      if (!axial::advance<Method>(x, h, held).ok()) return false;
      reference.step(Method{}, efforts);
    }
    worst = std::fmax(worst, error(x, reference));
    return true;
  }

 private:
  static double error(const Words& x, const Reference& reference) {
    double largest = 0.0, worst = 0.0;
    for (const auto& link : R::chain.links)
      largest = std::fmax(largest, link.acceleration_limit);
    const auto q = Base::values(x.q, true), qd = Base::values(x.qd);
    constexpr double time = h * steps, turn = 6.283185307179586;
    for (int i = 0; i < R::chain.size; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      const double far = q[i] - reference.q[joint], fast = qd[i] - reference.qd[joint];
      const double off = Base::State::turns(i) ? std::remainder(far, turn) : far;
      worst = std::fmax(worst, std::fabs(off) / (allowed * largest * time * time));
      worst = std::fmax(worst, std::fabs(fast) / (2.0 * allowed * largest * time));
    }
    return worst;
  }
};
using Robots = testing::Types<Drawn<0, 3, 3>, Drawn<1, 6, 4>, Drawn<2, 5, 3>, Drawn<4, 6, 3>, Drawn<5, 4, 3>>;
TYPED_TEST_SUITE(Moving, Robots);

TYPED_TEST(Moving, InWordsIsTheOraclesMotion) {
  exhaustive::Random random(11);
  int followed = 0;
  double worst = 0.0;
  for (std::uint64_t k = 0; k < runs; ++k) {
    const auto state = exhaustive::next_state<typename UntunedReference<TypeParam>::State>(random, 4 * k);
    followed += this->template follow<axial::RungeKutta4>(state, worst) ? 1 : 0;
    followed += this->template follow<axial::SemiImplicitEuler>(state, worst) ? 1 : 0;
  }
  std::printf("%s: %d motions of %d, off by %.1e of what is allowed\n", TypeParam::name, followed, 2 * runs, worst);
  EXPECT_GE(followed, runs / 2) << "too few to say anything";
  EXPECT_LE(worst, 1.0);
  EXPECT_GT(worst, 0.0);
}

}  // namespace
}  // namespace property
