// Angles of many turns: constant angles of joints cost none of their digits, in any form and with pairs from the
// caller.
#include <axial/fixed.hpp>
#include <cases/to_axial.hpp>
#include <robots/two_arm.hpp>

#include <property/support.hpp>

namespace {

using namespace axial;
using oracle::quad;

/// Constant angles of every kind: oblique, a quarter turn, none.
struct OffsetLinks {
  static constexpr Link body(const Link& link) {
    return link.mass(1.5).com(0.1, -0.05, 0.02).inertia_com(0.02, 0.03, 0.025).rotor_inertia(1e-4, 50);
  }
  static constexpr Link limited(const Link& link) {
    return body(link).position_limits(-3, 3).speed_limit(3).acceleration_limit(10).effort_limit(60);
  }
};
struct Offset : OffsetLinks {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -6.0, -7.5), limited(revolute().theta(0.3)),
                   limited(revolute().a(0.4).alpha_deg(90).theta(-0.7)), limited(revolute().a(0.3).theta_deg(90)),
                   limited(revolute().a(0.2).alpha_deg(-90).theta_deg(120)), limited(revolute().a(0.2).d(0.1)));
};

struct Errors {
  double poses = 0.0, efforts = 0.0, masses = 0.0, separated = 0.0;
  void take(const Errors& e) {
    poses = std::fmax(poses, e.poses), efforts = std::fmax(efforts, e.efforts), masses = std::fmax(masses, e.masses);
    separated = std::fmax(separated, e.separated);
  }
};

template <class T>
oracle::Vector<T> entries(const WorldPose<T>& pose) {
  const auto& R = pose.rotation;
  const auto& p = pose.position;
  return {R.x.x, R.x.y, R.x.z, R.y.x, R.y.y, R.y.z, R.z.x, R.z.y, R.z.z, p.x, p.y, p.z};
}
oracle::Vector<quad> entries(const oracle::Pose<quad>& pose) {
  const auto& R = pose.rotation;
  const auto& p = pose.position;
  return {R.c0.x, R.c1.x, R.c2.x, R.c0.y, R.c1.y, R.c2.y, R.c0.z, R.c1.z, R.c2.z, p.x, p.y, p.z};
}

/// What kernels answer at a state, against the oracle's.
struct Answers {
  oracle::Vector<quad> pose, effort, mass;
};
template <class T, class Pose, class Tau, class M>
Errors errors_of(const Answers& right, const Pose& pose, const Tau& tau, const M& m, int n) {
  Errors e;
  e.poses = oracle::relative_error(entries<T>(pose), right.pose);
  e.efforts = oracle::relative_error(oracle::Vector<T>(tau.values, tau.values + n), right.effort);
  oracle::Vector<T> mass;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      mass.push_back(m(i, j));
  e.masses = oracle::relative_error(mass, right.mass);
  return e;
}

template <class S, class T>
Errors errors_of_scene(const Answers& right, const oracle::Vector<double>& q_, const oracle::Vector<double>& qd_,
                       const oracle::Vector<double>& qdd_) {
  using R = robot_of<S>;
  const auto q = property::joints<R, T>(q_), qd = property::joints<R, T>(qd_), qdd = property::joints<R, T>(qdd_);
  Inputs<S, T> in;
  if constexpr (scene_of<S>::template has<SineCosines>) in.turns = sine_cosines<R>(q);
  auto e = errors_of<T>(right, forward_kinematics<S>(q, in).tool, inverse_dynamics<S>(q, qd, qdd, in),
                        mass_matrix<S>(q, in), joint_count<S>);
  const auto effort = torque(separate<S>(q, in), qd, qdd);
  e.separated = oracle::relative_error(property::vector(effort), right.effort);
  return e;
}

template <class R, class T>
Errors errors_of_model(const Answers& right, const oracle::Vector<double>& q_, const oracle::Vector<double>& qd_,
                       const oracle::Vector<double>& qdd_) {
  constexpr int n = joint_count<R>;
  const auto model = cases::to_model<Model<n>>(oracle::of_robot<double, R>());
  using M = Model<n>;
  const auto q = property::joints<M, T>(q_), qd = property::joints<M, T>(qd_), qdd = property::joints<M, T>(qdd_);
  return errors_of<T>(right, forward_kinematics(model, q).tool, inverse_dynamics(model, q, qd, qdd),
                      mass_matrix(model, q), n);
}

template <class T>
void expect_small(const Errors& e, const char* form, double size) {
  // Five joints, each with a sine good to 1.5 units of 2^-24 (or one of 2^-53), and the products of both.
  const double most = 16.0 * static_cast<double>(std::numeric_limits<T>::epsilon()) / 2.0;
  EXPECT_LE(e.poses, most) << form << " at +-" << size << " rad";
  EXPECT_LE(e.efforts, most) << form << " at +-" << size << " rad";
  EXPECT_LE(e.masses, most) << form << " at +-" << size << " rad";
  EXPECT_LE(e.separated, most) << form << " at +-" << size << " rad";
}

template <class R, class T>
void expect_exact_at(double size) {
  using Given = Scene<R, Gravity, RotorInertia, SineCosines>;
  using Compact = Scene<R, Gravity, RotorInertia, Looped>;
  constexpr int n = joint_count<R>;
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(7);
  Errors unrolled, given, looped, model;
  for (int k = 0; k < 12; ++k) {
    const auto q = random.vector(n, size), qd = random.vector(n, 2.0), qdd = random.vector(n, 4.0);
    const auto exact = oracle::convert<quad>(q);
    const Answers right{entries(oracle::tool_pose(chain, exact)),
                        oracle::inverse_dynamics(chain, exact, oracle::convert<quad>(qd), oracle::convert<quad>(qdd)),
                        oracle::elements(oracle::mass_matrix(chain, exact))};
    unrolled.take(errors_of_scene<R, T>(right, q, qd, qdd));
    given.take(errors_of_scene<Given, T>(right, q, qd, qdd));
    looped.take(errors_of_scene<Compact, T>(right, q, qd, qdd));
    model.take(errors_of_model<R, T>(right, q, qd, qdd));
  }
  expect_small<T>(unrolled, "unrolled", size);
  expect_small<T>(given, "given pairs", size);
  expect_small<T>(looped, "looped", size);
  expect_small<T>(model, "model", size);
}

template <class R>
class ManyTurns : public testing::Test {};
using Robots = testing::Types<Offset, robots::TwoArm>;
TYPED_TEST_SUITE(ManyTurns, Robots);

}  // namespace

TYPED_TEST(ManyTurns, CostNoDigitInFloat) {
  for (double size : {3.0, 43.0, 1000.0, 9900.0})
    expect_exact_at<TypeParam, float>(size);
}

TYPED_TEST(ManyTurns, CostNoDigitInDouble) {
  for (double size : {3.0, 43.0, 9.9e5})
    expect_exact_at<TypeParam, double>(size);
}

// Pairs from the caller are turned by theta in fixed point too, within the certified error.
TEST(GivenPairs, OfJointsWithConstantAnglesInFixedPoint) {
  using S = Scene<Offset, Gravity, RotorInertia, SineCosines>;
  constexpr auto bound = error_bound<S>(algorithm::inverse_dynamics);
  oracle::RandomChains random(11);
  for (int k = 0; k < 200; ++k) {
    const auto state = property::random_state<Offset>(random);
    const auto request = to_fixed_request<Offset, std::int32_t>(property::joints<Offset, double>(state.q),
                                                                property::joints<Offset, double>(state.qd),
                                                                property::joints<Offset, double>(state.qdd));
    const auto q = to_real<double>(request.q), qd = to_real<double>(request.qd), qdd = to_real<double>(request.qdd);
    Inputs<S, Fixed32> in;
    for (int i = 0; i < joint_count<S>; ++i) {
      in.turns[i].sin.raw = static_cast<std::int32_t>(std::lrint(std::ldexp(std::sin(q[i]), 30)));
      in.turns[i].cos.raw = static_cast<std::int32_t>(std::lrint(std::ldexp(std::cos(q[i]), 30)));
    }
    const auto tau = to_real<double>(inverse_dynamics<S>(request.q, request.qd, request.qdd, in));
    const auto exact = inverse_dynamics<Offset>(q, qd, qdd);
    for (int i = 0; i < joint_count<S>; ++i)
      EXPECT_LE(std::fabs(tau[i] - exact[i]), bound.of[i]) << "joint " << i;
  }
}
