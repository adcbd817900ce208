// Rotors as spinning bodies of robots whose joints share drives, against Lagrange's equations of all bodies, rotors
// among them, with each coupling as a constraint with a multiplier, in 113 bits; power.
#include <oracle/moving_base.hpp>

#include <property/batches/batched_states.hpp>
#include "drawn_couplings.hpp"
#include "rotor_axis.hpp"

namespace {

using namespace constrained;

/// A robot that numbers alone describe, its rotors about any axis on any link inboard of their joints.
template <int Number>
struct Spinning {
  static constexpr auto chain = [] {
    auto chain = property::Coupled<Number>::chain;
    for (int i = 0; i < chain.size; ++i) {
      auto& link = chain.links[i];
      const auto number = [&](int k) { return property::drawn_number(Number, 700 + 10 * i + k); };
      link.gear = number(0) > 0.0 ? 12.0 : -17.0;
      if (number(1) < -0.4) continue;  // its joint's axis, on the parent
      for (int axis = 0; axis < 3; ++axis)
        link.rotor_axis[axis] = number(2 + axis);
      int carrier = chain.parent(i);
      while (carrier >= 0 && number(6 + carrier) > 0.3)
        carrier = chain.parent(carrier);
      link.rotor_carrier = carrier;
    }
    return chain;
  }();
};

/// A robot's arm whose belt's motor stands on the base, and whose differential's motors lie in the forearm.
struct Bevelled {
  // A line a group of values.
  // clang-format off
  static constexpr auto chain = axial::chain(axial::gravity(0.5, 1.0, -9.5),
      revolute().mass(6).com(0.1, 0.02, 0.05).inertia_com(0.2, 0.25, 0.3, 0.01, 0.0, 0.02).rotor_inertia(5e-4, 20),
      revolute().alpha_deg(-90).a(0.1).mass(5).com(0.2, 0, 0.01).inertia_com(0.1, 0.15, 0.12)
          .rotor_inertia(4e-4, -30).rotor_axis(0, 1, 2),
      revolute().a(0.4).mass(3).com(0.02, 0.1, 0).inertia_com(0.06, 0.05, 0.07, 0.0, 0.004)
          .rotor_inertia(3e-4, 25).rotor_axis(1, 1, 0, 0).driven_by(1, -1.0),
      revolute().alpha_deg(90).d(0.35).mass(1).com(0, 0.01, 0.05).inertia_com(0.01, 0.01, 0.005)
          .rotor_inertia(1e-4, 15).rotor_axis(0, 1, 0, 2),
      revolute().alpha_deg(-90).mass(0.5).com(0.01, 0, 0.02).inertia_com(0.002, 0.003, 0.002)
          .rotor_inertia(1e-4, 15).rotor_axis(0.6, 0.8, 0, 2),
      differential());
  // clang-format on
};

}  // namespace

namespace constrained {

template <>
inline Couplings by_hand<Bevelled>() {
  return couplings(5, {0, 1, 2, 3, 4},
                   {{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, -1, 1, 0, 0}, {0, 0, 0, 0.5, 0.5}, {0, 0, 0, 0.5, -0.5}});
}

}  // namespace constrained

namespace {

template <class R>
Couplings couplings_of(const R*) {
  return by_hand<R>();
}
template <int Number>
Couplings couplings_of(const Spinning<Number>*) {
  return drawn_couplings<Number>();
}
template <class R>
Constrained spinning(const oracle::Load<quad>& load = {}) {
  return Constrained::with_rotors<R>(couplings_of(static_cast<const R*>(nullptr)), property::rotor_axes<R>(), load);
}

template <class T, class Found>
void expect_close(const Found& found, int n, const Vector<quad>& wanted, double size) {
  EXPECT_LE(error_in(wanted, size, convert<quad>(Vector<T>(found.values, found.values + n))), tolerance<T>);
}

/// The motion of a robot's drives, in both arithmetics.
template <class S, class T>
struct State {
  explicit State(const Motion& x)
      : u(property::joints<S, T>(x.u)), ud(property::joints<S, T>(x.ud)), udd(property::joints<S, T>(x.udd)) {
    const int n = int(x.u.size());
    at = convert<quad>(property::vector(u, n)), speed = convert<quad>(property::vector(ud, n));
    turn = convert<quad>(property::vector(udd, n)), rest = Vector<quad>(x.u.size(), quad(0));
  }
  Joints<S, T> u, ud, udd;
  Vector<quad> at, speed, turn, rest;
};

template <class R, class T, class... Features>
void expect_rotors(unsigned seed, int states, const oracle::Load<quad>& load = {}) {
  using S = Scene<R, Gravity, RotorInertia, RotorDynamics, Features...>;
  const auto exact = spinning<R>(load);
  const int m = exact.drives();
  ASSERT_EQ(m, joint_count<S>);
  oracle::RandomChains random(seed);
  const auto in = inputs<S, T>();
  for (int state = 0; state < states; ++state) {
    SCOPED_TRACE(state);
    const State<R, T> x(motion<R>(random, exact.owner()));
    const auto efforts = exact.inverse(x.at, x.speed, x.turn);
    const double size = oracle::largest(efforts);
    const auto tau = inverse_dynamics<S>(x.u, x.ud, x.udd, in);
    expect_close<T>(tau, m, efforts, size);
    expect_close<T>(bias_torque<S>(x.u, x.ud, in), m, exact.inverse(x.at, x.speed, x.rest), size);
    expect_close<T>(gravity_torque<S>(x.u, in), m, exact.inverse(x.at, x.rest, x.rest), size);
    EXPECT_LE(oracle::relative_error(oracle::elements(property::matrix(mass_matrix<S>(x.u, in))),
                                     oracle::elements(exact.mass(x.at))),
              tolerance<T>);
    const auto answer = forward_dynamics<S>(x.u, x.ud, tau, in);
    EXPECT_TRUE(answer.status.ok()) << int(answer.status.code);
    const auto wanted = exact.forward(x.at, x.speed, convert<quad>(property::vector(tau)));
    expect_close<T>(answer, m, wanted, oracle::largest(wanted));
  }
}
template <class T>
void expect_of_robots(unsigned seed) {
  expect_rotors<robots::ScaraQuill, T>(seed, 20);
  expect_rotors<robots::Palletiser, T>(seed + 1, 6);
  expect_rotors<robots::WristArm, T>(seed + 2, 20);
  expect_rotors<robots::Gripper, T>(seed + 3, 20);
  expect_rotors<Followers, T>(seed + 4, 20);
  expect_rotors<Bevelled, T>(seed + 5, 20);
}
template <int... Number>
void expect_of_random_couplings(std::integer_sequence<int, Number...>) {
  (expect_rotors<Spinning<Number>, double>(100U + unsigned(Number), 5), ...);
  (expect_rotors<Spinning<Number>, double, Looped>(200U + unsigned(Number), 5), ...);
}

using SpinningModel = Model<10, Gravity, RotorInertia, RotorDynamics, SharedDrives>;
template <class R>
void expect_model(unsigned seed) {
  SpinningModel model;
  model.set_gravity(R::chain.gravity.x, R::chain.gravity.y, R::chain.gravity.z);
  for (const LinkParameters& link : R::chain.links)
    ASSERT_TRUE(model.add(link));
  const auto exact = spinning<R>();
  const int m = exact.drives();
  oracle::RandomChains random(seed);
  for (int state = 0; state < 5; ++state) {
    const State<SpinningModel, double> x(motion<R>(random, exact.owner()));
    const auto efforts = exact.inverse(x.at, x.speed, x.turn);
    const auto tau = inverse_dynamics(model, x.u, x.ud, x.udd);
    expect_close<double>(tau, m, efforts, oracle::largest(efforts));
    EXPECT_LE(oracle::relative_error(oracle::elements(property::matrix(mass_matrix(model, x.u), m)),
                                     oracle::elements(exact.mass(x.at))),
              tolerance<double>);
    const auto answer = forward_dynamics(model, x.u, x.ud, tau);
    EXPECT_TRUE(answer.status.ok());
    const auto wanted = exact.forward(x.at, x.speed, convert<quad>(property::vector(tau, m)));
    expect_close<double>(answer, m, wanted, oracle::largest(wanted));
  }
}

}  // namespace

TEST(DrivenRotors, AreBodiesWithConstraintsInDouble) { expect_of_robots<double>(1); }
TEST(DrivenRotors, AreBodiesWithConstraintsInFloat) { expect_of_robots<float>(11); }
TEST(DrivenRotors, OfRandomCouplingsAreBodiesWithConstraints) {
  expect_of_random_couplings(std::make_integer_sequence<int, 10>{});
}
TEST(DrivenRotors, LoopedAndWithFullParametersAreTheSame) {
  expect_rotors<Bevelled, double, Looped>(31, 10);
  expect_rotors<robots::Palletiser, double, Looped>(32, 5);
  expect_rotors<Bevelled, double, FullParameters, CompositeBody>(33, 10);
}
TEST(DrivenRotors, CarryFrictionSpringsAndWrenches) {
  auto load = load_on_links(Followers::chain.size);
  load.tip = {}, load.friction = load.springs = true;
  expect_rotors<Followers, double, Friction, JointSprings, ExternalWrenches>(41, 20, load);
}
TEST(DrivenRotors, OfARunTimeModelAreBodiesWithConstraints) {
  expect_model<Bevelled>(51);
  expect_model<Followers>(52);
  expect_model<robots::Palletiser>(53);
  expect_model<Spinning<3>>(54);
}

namespace {

/// Efforts along a direction and in time, against differences of those of all bodies: exact to some 15 digits.
template <class R, class S>
void expect_slopes_and_rates(unsigned seed) {
  const auto exact = spinning<R>();
  const int m = exact.drives();
  oracle::RandomChains random(seed);
  const quad h = quad(1) / quad(1LL << 26);
  for (int state = 0; state < 3; ++state) {
    SCOPED_TRACE(state);
    const State<R, double> x(motion<R>(random, exact.owner())), by(motion<R>(random, exact.owner()));
    const auto sum = [](Vector<quad> a, quad t, const Vector<quad>& b) {
      for (std::size_t k = 0; k < a.size(); ++k)
        a[k] += t * b[k];
      return a;
    };
    const auto quotient = [](const Vector<quad>& a, const Vector<quad>& b, quad over) {
      Vector<quad> d;
      for (std::size_t k = 0; k < a.size(); ++k)
        d.push_back((a[k] - b[k]) / over);
      return d;
    };
    const auto along = [&](quad t) {
      return exact.inverse(sum(x.at, t, by.at), sum(x.speed, t, by.speed), sum(x.turn, t, by.turn));
    };
    const auto in_time = [&](quad t) {  // whose third and fourth derivatives are those of `by`
      return exact.inverse(
          sum(sum(sum(sum(x.at, t, x.speed), t * t / 2, x.turn), t * t * t / 6, by.speed), t * t * t * t / 24, by.turn),
          sum(sum(sum(x.speed, t, x.turn), t * t / 2, by.speed), t * t * t / 6, by.turn),
          sum(sum(x.turn, t, by.speed), t * t / 2, by.turn));
    };
    const auto here = along(0);
    const auto expect = [&](const auto& found, const Vector<quad>& wanted) {
      EXPECT_LE(error_in(wanted, oracle::largest(wanted), convert<quad>(property::vector(found, m))), 1e-11);
    };
    const MotionDirection<R, double> direction{by.u, by.ud, by.udd};
    const auto slope = inverse_dynamics_along<S>(x.u, x.ud, x.udd, direction);
    expect(slope.tau, here), expect(slope.dtau, quotient(along(h), along(-h), h + h));
    const auto first = torque_rates<S>(x.u, x.ud, x.udd, by.ud);
    const auto both = torque_rates<S>(x.u, x.ud, x.udd, by.ud, by.udd);
    const auto after = in_time(h), before = in_time(-h);
    expect(first.tau, here), expect(first.taud, quotient(after, before, h + h));
    expect(both.tau, here), expect(both.taud, quotient(after, before, h + h));
    expect(both.taudd, quotient(quotient(after, here, h), quotient(here, before, h), h));
  }
}

}  // namespace

TEST(DrivenRotors, AlongADirectionAndInTimeAreSlopesOfBodiesWithConstraints) {
  expect_slopes_and_rates<Bevelled, Scene<Bevelled, Gravity, RotorInertia, RotorDynamics>>(91);
  expect_slopes_and_rates<Bevelled, Scene<Bevelled, Gravity, RotorInertia, RotorDynamics, Looped>>(92);
  expect_slopes_and_rates<Followers, Scene<Followers, Gravity, RotorInertia, RotorDynamics>>(93);
}

// d(kinetic energy)/dt = ud . tau, the energy being that of all bodies along any motion of the drives.
TEST(DrivenRotors, PowerIsWhatTheKineticEnergyGains) {
  using R = Bevelled;
  using S = Scene<R, RotorInertia, RotorDynamics>;
  const auto exact = spinning<R>();
  oracle::RandomChains random(61);
  for (int state = 0; state < 20; ++state) {
    const State<R, double> x(motion<R>(random, exact.owner()));
    const auto energy = [&](quad t) {
      Vector<quad> u = x.at, ud = x.speed;
      for (std::size_t k = 0; k < u.size(); ++k)
        u[k] += t * (x.speed[k] + t / 2 * x.turn[k]), ud[k] += t * x.turn[k];
      return oracle::kinetic_energy(exact.chain(), exact.positions(u), exact.g() * ud);
    };
    const auto tau = inverse_dynamics<S>(x.u, x.ud, x.udd);
    double power = 0.0, size = 0.0;
    for (int k = 0; k < 5; ++k)
      power += x.ud[k] * tau[k], size += std::abs(x.ud[k] * tau[k]);
    const quad h = quad(1) / quad(1LL << 40);
    EXPECT_NEAR(double((energy(h) - energy(-h)) / (h + h)), power, 1e-13 * size);
  }
}
TEST(DrivenRotors, OfABaseThatMovesTurnWithIt) {
  using R = Bevelled;
  using S = Scene<R, RuntimeGravity, BaseMotion, RotorInertia, RotorDynamics>;
  using Compact = Scene<R, RuntimeGravity, BaseMotion, RotorInertia, RotorDynamics, Looped>;
  const auto exact = spinning<R>();
  auto bodies = exact.chain();
  bodies.gravity = {quad(-3), quad(2.5), quad(8)};
  const oracle::BaseMotion<quad> base{
      {quad(0.75), quad(-1.25), quad(0.5)}, {quad(-2), quad(1.5), quad(3)}, {quad(4), quad(-1), quad(2.5)}};
  Inputs<S, double> in{};
  in.gravity = {-3, 2.5, 8}, in.base_motion = {{0.75, -1.25, 0.5}, {-2, 1.5, 3}, {4, -1, 2.5}};
  Inputs<Compact, double> again{};
  again.gravity = in.gravity, again.base_motion = in.base_motion;
  oracle::RandomChains random(71);
  for (int state = 0; state < 10; ++state) {
    const State<R, double> x(motion<R>(random, exact.owner()));
    const auto of_joints = oracle::inverse_dynamics_on_moving_base(bodies, base, exact.positions(x.at),
                                                                   exact.g() * x.speed, exact.g() * x.turn);
    Vector<quad> wanted(5, quad(0));
    for (int i = 0; i < exact.joints(); ++i)
      for (int k = 0; k < 5; ++k)
        wanted[std::size_t(k)] += exact.g()(i, k) * of_joints[std::size_t(i)];
    const double size = oracle::largest(wanted);
    expect_close<double>(inverse_dynamics<S>(x.u, x.ud, x.udd, in), 5, wanted, size);
    expect_close<double>(inverse_dynamics<Compact>(x.u, x.ud, x.udd, again), 5, wanted, size);
  }
}
TEST(DrivenRotors, OfABatchAreThoseOfEachState) {
  using R = Bevelled;
  using S = Scene<R, Gravity, RotorInertia, RotorDynamics>;
  const property::BatchedStates<R> states(81);
  const auto& [x, lanes] = states;
  const auto tau = inverse_dynamics<S>(x[0], x[1], x[2]);
  const auto back = forward_dynamics<S>(x[0], x[1], tau);
  for (int lane = 0; lane < 2; ++lane) {
    const auto alone = inverse_dynamics<S>(lanes[lane][0], lanes[lane][1], lanes[lane][2]);
    for (int k = 0; k < 5; ++k) {
      EXPECT_NEAR(tau[k][lane], alone[k], 1e-12);
      EXPECT_NEAR(back[k][lane], lanes[lane][2][k], 1e-10);
    }
  }
}
