// A load that an arm picks up and puts down at speed is no contact to the observer, and contacts are still found.
// Torques are those of Lagrange's equations of a planar arm with a load, written out by hand (Craig 2005, section 6.7,
// with centres of mass anywhere on the links).
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <cmath>
#include <random>

using namespace axial;

namespace {

struct Arm {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0), payload_limit(3.0, 0.6, 0.1),
                                             revolute()
                                                 .mass(4.0)
                                                 .com(0.2, 0, 0)
                                                 .inertia_com(0.01, 0.06, 0.06)
                                                 .position_limits(-3, 3)
                                                 .speed_limit(4)
                                                 .acceleration_limit(40)
                                                 .effort_limit(150),
                                             revolute()
                                                 .a(0.5)
                                                 .mass(2.5)
                                                 .com(0.15, 0, 0)
                                                 .inertia_com(0.01, 0.03, 0.03)
                                                 .position_limits(-3, 3)
                                                 .speed_limit(4)
                                                 .acceleration_limit(40)
                                                 .effort_limit(60));
};
using S = Scene<Arm, Gravity, RotorInertia, Payload>;

struct Watching {
  static constexpr double period = 1e-3, gain = 200.0;
  static constexpr double fraction = 0.023, uncertainty = 0.08, release = 0.5;
  static constexpr int confirm = 2, calm = 20;
};
constexpr double noise = 0.15;  // N m, of a measured torque

struct Load {
  double mass = 0.0, com = 0.0, inertia = 0.0;
};
struct Instant {
  double q[2], qd[2], qdd[2];
};

/// Torque of the drives for a motion under a load.
void torque(const Instant& s, const Load& p, double (&tau)[2]) {
  constexpr double l1 = 0.5, m1 = 4.0, c1 = 0.2, i1 = 0.06, m2 = 2.5, c2 = 0.15, i2 = 0.03, g = 9.81;
  const double mass = m2 + p.mass, moment = m2 * c2 + p.mass * p.com;
  const double inertia = i2 + m2 * c2 * c2 + p.inertia + p.mass * p.com * p.com;
  const double cross = l1 * moment * std::cos(s.q[1]), bend = l1 * moment * std::sin(s.q[1]);
  const double m11 = i1 + m1 * c1 * c1 + mass * l1 * l1 + inertia + 2.0 * cross, m12 = inertia + cross;
  const double weight2 = g * moment * std::cos(s.q[0] + s.q[1]);
  tau[0] = m11 * s.qdd[0] + m12 * s.qdd[1] - bend * (2.0 * s.qd[0] * s.qd[1] + s.qd[1] * s.qd[1]) +
           g * (m1 * c1 + mass * l1) * std::cos(s.q[0]) + weight2;
  tau[1] = m12 * s.qdd[0] + inertia * s.qdd[1] + bend * s.qd[0] * s.qd[0] + weight2;
}

/// A drawn motion, load and contact.
struct Drawn {
  double amplitude[2], rate[2], phase[2], middle[2];
  Load load;
  double up = 0.0, down = 0.0, touch = 0.0, push[2] = {};
  bool pours = false;  ///< the load runs out evenly between `up` and `down`, instead of being put down

  explicit Drawn(std::mt19937& engine) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto between = [&](double low, double high) { return low + (high - low) * unit(engine); };
    for (int i = 0; i < 2; ++i) {
      rate[i] = between(3.0, 8.0), amplitude[i] = between(1.0, 3.5) / rate[i], phase[i] = between(0.0, 6.28);
      middle[i] = between(-1.0, 1.0);
    }
    load = {between(0.3, 2.5), between(0.1, 0.4), between(0.0, 0.02)};
    up = 0.001 * std::floor(between(100.0, 300.0)), down = 0.001 * std::floor(between(400.0, 600.0));
    touch = 0.001 * std::floor(between(650.0, 750.0));
    const int joint = static_cast<int>(engine() % 2);
    push[joint] = (engine() % 2 == 0 ? 0.05 : -0.05) * Arm::chain.links[joint].effort_limit;
  }
  Instant at(double t) const {
    Instant s{};
    for (int i = 0; i < 2; ++i) {
      const double x = rate[i] * t + phase[i];
      s.q[i] = middle[i] + amplitude[i] * std::sin(x), s.qd[i] = amplitude[i] * rate[i] * std::cos(x);
      s.qdd[i] = -amplitude[i] * rate[i] * rate[i] * std::sin(x);
    }
    return s;
  }
  /// The load within the millisecond that ends at `t`.
  Load carried(double t) const {
    if (!(t > up + 5e-4) || (t > down + 5e-4)) return {};
    if (!pours) return load;
    const double share = (down - t) / (down - up);
    return {share * load.mass, load.com, share * load.inertia};
  }
  bool touched(double t) const { return t > touch + 5e-4; }
};

template <class T>
Inputs<S, T> inputs(const Load& load) {
  Inputs<S, T> in;
  if constexpr (is_stored_v<T>) {
    const PayloadBody<double> body{load.mass, {load.com, 0, 0}, {0, 0, load.inertia, 0, 0, 0}};
    in.payload = to_fixed_payload<S, std::int32_t>(body).load;
  } else {
    in.payload.mass = static_cast<T>(load.mass), in.payload.com.x = static_cast<T>(load.com);
    in.payload.inertia_com.zz = static_cast<T>(load.inertia);
  }
  return in;
}
template <class Values, class T>
Values values(const double (&x)[2]) {
  Joints<Arm, double> all{x[0], x[1]};
  if constexpr (is_stored_v<T>) {
    return to_fixed<Values>(all).values;
  } else {
    return {static_cast<T>(x[0]), static_cast<T>(x[1])};
  }
}

/// False samples before the contact, and how many samples after its begin it is found.
struct Seen {
  int false_samples = 0, delay = -1;
};

template <class T>
Seen watch(const Drawn& drawn, std::mt19937& engine, bool told) {
  std::normal_distribution<double> unsure(0.0, noise);
  ObserverState<S, T, Watching> observer;
  CollisionState detector;
  Seen seen;
  Load last{};
  for (int k = 1; k <= 800; ++k) {
    const double t = k * Watching::period;
    const Load load = drawn.carried(t);
    double begin[2], middle[2], end[2], mean[2];
    const Instant before = drawn.at(t - Watching::period), now = drawn.at(t);
    torque(before, load, begin), torque(drawn.at(t - 0.5 * Watching::period), load, middle), torque(now, load, end);
    for (int i = 0; i < 2; ++i) {
      mean[i] = (begin[i] + 4.0 * middle[i] + end[i]) / 6.0 + unsure(engine);
      if (drawn.touched(t)) mean[i] -= drawn.push[i];
    }
    const auto in = inputs<T>(load);
    if (told && (load.mass < last.mass || load.mass > last.mass)) {
      EXPECT_TRUE(
          change_load<S>(observer, values<Positions<Arm, T>, T>(before.q), values<Velocities<Arm, T>, T>(before.qd), in)
              .ok());
    }
    last = load;
    EXPECT_TRUE(observe<S>(observer, values<Positions<Arm, T>, T>(now.q), values<Velocities<Arm, T>, T>(now.qd),
                           values<EffortsOf<S, T>, T>(mean), in)
                    .ok());
    const bool found = detect<S, T, Watching>(detector, observer.residual).detected;
    if (!drawn.touched(t))
      seen.false_samples += found ? 1 : 0;
    else if (found && seen.delay < 0)
      seen.delay = static_cast<int>(std::lround((t - drawn.touch) / Watching::period));
  }
  return seen;
}

template <class T>
class ChangingLoad : public testing::Test {
 protected:
  static constexpr int motions = 100;
  static constexpr unsigned seed = 20261126;

  template <class Change>
  void expect_seen(bool told, const Change& change) {
    std::mt19937 engine(seed);
    for (int k = 0; k < motions; ++k) {
      Drawn drawn(engine);
      change(drawn);
      const Seen seen = watch<T>(drawn, engine, told);
      EXPECT_EQ(seen.false_samples, 0) << "motion " << k << " of seed " << seed;
      EXPECT_GE(seen.delay, 1) << "missed, motion " << k << " of seed " << seed;
      EXPECT_LE(seen.delay, 10) << "motion " << k << " of seed " << seed;
    }
  }
};
using Numbers = testing::Types<float, double, Fixed32>;
TYPED_TEST_SUITE(ChangingLoad, Numbers);

}  // namespace

TYPED_TEST(ChangingLoad, IsNoContactAndContactsAreFound) {
  this->expect_seen(false, [](Drawn&) {});
}
TYPED_TEST(ChangingLoad, IsNoContactWhereTheObserverIsTold) {
  this->expect_seen(true, [](Drawn&) {});
}
// The contact begins with the load, or two samples before.
TYPED_TEST(ChangingLoad, HidesNoContactThatBeginsWithIt) {
  int before = 0;
  this->expect_seen(false, [&](Drawn& drawn) { drawn.touch = drawn.up - 0.001 * (before++ % 3); });
}
// A load that changes at every sample is one that the observer must be told of: else it would start anew for ever.
TYPED_TEST(ChangingLoad, ThatIsPouredHidesNoContact) {
  this->expect_seen(true, [](Drawn& drawn) {
    drawn.pours = true, drawn.touch = drawn.up + 0.05;
    drawn.load.mass = std::fmin(drawn.load.mass, 1.0);
  });
}
