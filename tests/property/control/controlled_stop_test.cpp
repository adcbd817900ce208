// The efforts of a controlled stop, given to a plant that moves at every joint's full speed: it comes to rest, inside
// its limits, near where the stop wanted it. The plant is the oracle's recursion, integrated by Runge and Kutta's
// fourth order; the efforts are those that boards exert (tests/target/controlled_stop_test.py holds their bits).
#include <gtest/gtest.h>
#include <cmath>
#include <firmware/apps/controlled_stop/sequence.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/recursive.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <property/fixed/without_costs.hpp>

namespace {

using namespace axial;
using Vector = oracle::Vector<double>;

template <class R>
class Plant {
 public:
  Vector q, qd;
  explicit Plant(const oracle::Chain<double>& chain) : q(chain.links.size()), qd(chain.links.size()), chain_(chain) {}
  /// A millisecond under constant efforts.
  void move(const Vector& tau) {
    constexpr double h = 1e-3;
    const Vector a = at(q, qd, tau), v2 = sum(qd, 0.5 * h, a), b = at(sum(q, 0.5 * h, qd), v2, tau);
    const Vector v3 = sum(qd, 0.5 * h, b), c = at(sum(q, 0.5 * h, v2), v3, tau), v4 = sum(qd, h, c);
    const Vector d = at(sum(q, h, v3), v4, tau);
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] += h / 6.0 * (qd[i] + 2.0 * v2[i] + 2.0 * v3[i] + v4[i]);
      qd[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
    }
  }

 private:
  Vector at(const Vector& x, const Vector& v, const Vector& tau) const {
    return oracle::recursive_forward_dynamics(chain_, x, v, tau);
  }
  static Vector sum(Vector x, double h, const Vector& v) {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += h * v[i];
    return x;
  }
  oracle::Chain<double> chain_;
};

template <class R, class T>
struct Case {
  using Robot = R;
  using Number = T;
};
template <class C>
class ControlledStopInTheLoop : public testing::Test {};
using Cases = testing::Types<Case<robots::Scara, float>, Case<robots::Scara, Fixed32>, Case<robots::Puma560, float>,
                             Case<robots::Puma560, Fixed32>>;
TYPED_TEST_SUITE(ControlledStopInTheLoop, Cases);

template <class T, class Values>
auto real(const Values& values) {
  if constexpr (is_stored_v<T>)
    return to_real<double>(values);
  else
    return values;
}

}  // namespace

TYPED_TEST(ControlledStopInTheLoop, BringsAPlantFromFullSpeedToRestInsideItsLimits) {
  using R = typename TypeParam::Robot;
  using T = typename TypeParam::Number;
  namespace stops = axial::apps::controlled_stop;
  constexpr int n = R::chain.size;
  for (const bool forwards : {true, false}) {
    SCOPED_TRACE(forwards ? "forwards" : "backwards");
    Plant<R> plant(oracle::from_axial<double>(R::chain));
    for (int i = 0; i < n; ++i) {
      const auto& l = R::chain.links[i];
      plant.q[std::size_t(i)] = 0.5 * (l.position_min + l.position_max);
      plant.qd[std::size_t(i)] = (forwards ? 1.0 : -1.0) * l.speed_limit;
    }
    stops::Report all;
    axial::apps::fixed::Hash hash;
    bool rested = false;
    const auto see = [&](const auto& fall_back, int k) {
      Vector tau(n);
      const auto exerted = real<T>(fall_back.torque());
      for (int i = 0; i < n; ++i)
        tau[std::size_t(i)] = static_cast<double>(exerted[i]);
      if (fall_back.phase() == DrivePhase::holding && !rested) {
        rested = true;
        const auto wanted = real<T>(fall_back.wanted().q);
        for (int i = 0; i < n; ++i) {
          const auto& l = R::chain.links[i];
          const double range = l.position_max - l.position_min,
                       off = plant.q[std::size_t(i)] - static_cast<double>(wanted[i]);
          const double turn = l.type == JointType::revolute ? std::remainder(off, 6.283185307179586) : off;
          EXPECT_LE(std::fabs(plant.qd[std::size_t(i)]), 0.02 * l.speed_limit) << "joint " << i << " moves, tick " << k;
          EXPECT_LE(std::fabs(turn), 0.01 * range) << "joint " << i << " is elsewhere";
        }
      }
      if (rested) return;
      plant.move(tau);
      for (int i = 0; i < n; ++i) {
        EXPECT_GE(plant.q[std::size_t(i)], R::chain.links[i].position_min) << "joint " << i << ", tick " << k;
        EXPECT_LE(plant.q[std::size_t(i)], R::chain.links[i].position_max) << "joint " << i << ", tick " << k;
      }
    };
    stops::stop<R, T>(forwards, property::WithoutCosts{}, see, all, hash);
    EXPECT_TRUE(rested);
    std::printf("%d ticks to rest\n", all.to_rest);
  }
}
