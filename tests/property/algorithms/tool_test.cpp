// What the tool feels: wrenches, bias acceleration and inertia of the task, against the oracle's Jacobians and masses
// in quadruple precision and against Orocos KDL.
#include <robots/robots.hpp>

#include <oracle/kdl_chain.hpp>

#include <property/support.hpp>

namespace {

using namespace axial;
using oracle::quad;
using property::joints;
using property::random_state;

constexpr int states = 200;
constexpr unsigned seed = 1987;

template <class T>
constexpr bool is_double = std::is_same_v<T, double>;

template <class T>
oracle::Vector<T> six(const MotionVector<Vec3<T>, Vec3<T>>& v) {
  return {v.angular.x, v.angular.y, v.angular.z, v.linear.x, v.linear.y, v.linear.z};
}
oracle::Vector<double> six(const oracle::Wrench<double>& w) {
  return {w.moment.x, w.moment.y, w.moment.z, w.force.x, w.force.y, w.force.z};
}

/// Rows 0 to 2 angular, 3 to 5 linear.
oracle::Matrix<quad> stacked(const oracle::Jacobian<quad>& j, int n) {
  oracle::Matrix<quad> all(6, n);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < n; ++k)
      all(i, k) = j.angular(i, k), all(i + 3, k) = j.linear(i, k);
  return all;
}
oracle::Vector<quad> product(const oracle::Matrix<quad>& m, const oracle::Vector<quad>& v, int rows) {
  oracle::Vector<quad> out(static_cast<std::size_t>(rows), quad(0));
  for (int i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < v.size(); ++k)
      out[static_cast<std::size_t>(i)] += m(i, static_cast<int>(k)) * v[k];
  return out;
}
/// (J(q + h qd) - J(q - h qd)) qd / 2h: with h = 1e-9 some 1e-16 of it, in 113 bits.
oracle::Vector<quad> bias_by_differences(const oracle::Chain<quad>& chain, const oracle::Vector<quad>& q,
                                         const oracle::Vector<quad>& qd) {
  const quad h = quad(1e-9);
  const int n = chain.size();
  auto ahead = q, behind = q;
  for (std::size_t i = 0; i < q.size(); ++i)
    ahead[i] += h * qd[i], behind[i] -= h * qd[i];
  const auto a = product(stacked(oracle::tool_jacobian(chain, ahead), n), qd, 6);
  const auto b = product(stacked(oracle::tool_jacobian(chain, behind), n), qd, 6);
  oracle::Vector<quad> out;
  for (std::size_t i = 0; i < 6; ++i)
    out.push_back((a[i] - b[i]) / (2 * h));
  return out;
}
/// Solves m x = b by Gauss' elimination.
oracle::Vector<quad> solved(oracle::Matrix<quad> m, oracle::Vector<quad> b) {
  const int n = static_cast<int>(b.size());
  for (int k = 0; k < n; ++k)
    for (int i = k + 1; i < n; ++i) {
      const quad gain = m(i, k) / m(k, k);
      for (int j = k; j < n; ++j)
        m(i, j) -= gain * m(k, j);
      b[std::size_t(i)] -= gain * b[std::size_t(k)];
    }
  for (int k = n; k-- > 0;) {
    for (int j = k + 1; j < n; ++j)
      b[std::size_t(k)] -= m(k, j) * b[std::size_t(j)];
    b[std::size_t(k)] /= m(k, k);
  }
  return b;
}
oracle::Matrix<quad> mobility(const oracle::Chain<quad>& chain, const oracle::Vector<quad>& q) {
  const int n = chain.size();
  const auto j = stacked(oracle::tool_jacobian(chain, q), n);
  const auto m = oracle::mass_matrix(chain, q);
  oracle::Matrix<quad> out(6, 6);
  for (int c = 0; c < 6; ++c) {
    oracle::Vector<quad> row;
    for (int k = 0; k < n; ++k)
      row.push_back(j(c, k));
    const auto x = product(j, solved(m, row), 6);
    for (int r = 0; r < 6; ++r)
      out(r, c) = x[std::size_t(r)];
  }
  return out;
}
template <class T>
oracle::Matrix<T> full(const ToolMatrix<T>& m) {
  oracle::Matrix<T> out(6, 6);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      out(i, j) = m(i, j);
  return out;
}
template <class T>
oracle::Matrix<quad> as_quad(const oracle::Matrix<T>& m) {
  oracle::Matrix<quad> out(6, 6);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      out(i, j) = quad(m(i, j));
  return out;
}

template <class R_, class T_>
struct Case {
  using R = R_;
  using T = T_;
};
template <class C>
class ToolOf : public testing::Test {};
using Cases = testing::Types<Case<robots::Scara, double>, Case<robots::ScaraRrpr, float>, Case<robots::Puma560, double>,
                             Case<robots::Puma560, float>, Case<robots::Panda, double>, Case<robots::Panda, float>,
                             Case<robots::TwoArm, double>, Case<robots::Planar2r, float>>;
TYPED_TEST_SUITE(ToolOf, Cases);

}  // namespace

TYPED_TEST(ToolOf, TransposeTimesIsTheVirtualWorkOfTheWrench) {
  using R = typename TypeParam::R;
  using T = typename TypeParam::T;
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(seed);
  double worst = 0.0;
  for (int k = 0; k < states; ++k) {
    const auto state = random_state<R>(random);
    const auto w = random.wrench(20.0);
    const auto j = stacked(oracle::tool_jacobian(chain, oracle::convert<quad>(state.q)), chain.size());
    oracle::Vector<quad> reference(static_cast<std::size_t>(chain.size()), quad(0));
    for (int i = 0; i < chain.size(); ++i)
      for (int r = 0; r < 6; ++r)
        reference[std::size_t(i)] += j(r, i) * quad(six(w)[std::size_t(r)]);
    const ForceVector<Vec3<T>, Vec3<T>> wrench{{T(w.moment.x), T(w.moment.y), T(w.moment.z)},
                                               {T(w.force.x), T(w.force.y), T(w.force.z)}};
    const auto tau = transpose_times(jacobian<R>(joints<R, T>(state.q)), wrench);
    worst = std::fmax(worst, oracle::relative_error(property::vector(tau), reference));
  }
  EXPECT_LE(worst, is_double<T> ? 1e-14 : 4e-6);
  EXPECT_GT(worst, 0.0);
}

TYPED_TEST(ToolOf, BiasAccelerationIsTheRateOfTheVelocityAtConstantJointRates) {
  using R = typename TypeParam::R;
  using T = typename TypeParam::T;
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(seed);
  double worst = 0.0;
  for (int k = 0; k < states; ++k) {
    const auto state = random_state<R>(random);
    const auto reference = bias_by_differences(chain, oracle::convert<quad>(state.q), oracle::convert<quad>(state.qd));
    const auto found = bias_acceleration(jacobian<R>(joints<R, T>(state.q)), joints<R, T>(state.qd));
    worst = std::fmax(worst, oracle::relative_error(six(found), reference));
  }
  EXPECT_LE(worst, is_double<T> ? 1e-13 : 4e-5);
  EXPECT_GT(worst, 0.0);
}

TYPED_TEST(ToolOf, VelocityIsTheJacobianTimesTheRates) {
  using R = typename TypeParam::R;
  using T = typename TypeParam::T;
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(seed);
  for (int k = 0; k < states; ++k) {
    const auto state = random_state<R>(random);
    const auto j = stacked(oracle::tool_jacobian(chain, oracle::convert<quad>(state.q)), chain.size());
    const auto found = tool_velocity(jacobian<R>(joints<R, T>(state.q)), joints<R, T>(state.qd));
    EXPECT_LE(oracle::relative_error(six(found), product(j, oracle::convert<quad>(state.qd), 6)),
              is_double<T> ? 1e-14 : 4e-6);
  }
}

TYPED_TEST(ToolOf, MobilityIsTheJacobianAroundTheInverseOfTheMassMatrix) {
  using R = typename TypeParam::R;
  using T = typename TypeParam::T;
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(seed);
  double worst = 0.0;
  for (int k = 0; k < states; ++k) {
    const auto state = random_state<R>(random);
    const auto found = tool_mobility<R>(joints<R, T>(state.q));
    EXPECT_TRUE(found.status.ok());
    worst =
        std::fmax(worst, oracle::relative_error(as_quad(full(found)), mobility(chain, oracle::convert<quad>(state.q))));
  }
  EXPECT_LE(worst, is_double<T> ? 1e-12 : 1e-3);
  EXPECT_GT(worst, 0.0);
}

namespace {

/// Over the task's directions, inertia times mobility is one; the mobility is the oracle's.
template <class R, class T>
void expect_inverse(const Directions& task, double tolerance) {
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(seed);
  int ok = 0;
  for (int k = 0; k < states; ++k) {
    const auto state = random_state<R>(random);
    const auto inertia = task_space_inertia(tool_mobility<R>(joints<R, T>(state.q)), task);
    const auto exact = mobility(chain, oracle::convert<quad>(state.q));
    if (!inertia.status.ok()) {
      EXPECT_EQ(inertia.status.code, Status::Code::near_singular);
      continue;
    }
    ++ok;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        quad sum = 0, size = 1;
        for (int l = 0; l < 6; ++l)
          if (task.of[l]) {
            const quad term = quad(inertia(i, l)) * exact(l, j);
            sum += term, size += term < 0 ? -term : term;
          }
        if (task.of[i] && task.of[j])
          EXPECT_NEAR(static_cast<double>(sum), i == j ? 1.0 : 0.0, tolerance * static_cast<double>(size));
        else
          EXPECT_EQ(inertia(i, j), T(0)) << "no direction of the task";
      }
  }
  EXPECT_GT(ok, states / 2);
}

}  // namespace

TEST(TaskSpaceInertia, IsTheInverseOfTheMobility) {
  expect_inverse<robots::Panda, double>(all_directions, 1e-9);
  expect_inverse<robots::Panda, float>(all_directions, 2e-2);
  expect_inverse<robots::Puma560, double>(all_directions, 1e-9);
  expect_inverse<robots::Puma560, float>(position_only, 1e-3);
  expect_inverse<robots::Scara, double>(position_only, 1e-9);
  expect_inverse<robots::ScaraRrpr, double>({{false, false, true, true, true, true}}, 1e-9);
}

// 4 kg at the end of a 2 m rod that turns about the origin: it feels m = 4 kg across and cannot move along.
namespace {
struct Rod {
  static constexpr auto chain = axial::chain(revolute().mass(4).com(2, 0, 0).rotor_inertia(0.5, 4), tool(2, 0, 0));
};
}  // namespace
TEST(TaskSpaceInertia, OfAPendulumIsItsMassAndItsRotor) {
  const auto mobility = tool_mobility<Rod>(Joints<Rod, double>{0.0});
  EXPECT_TRUE(mobility.status.ok());
  EXPECT_NEAR(mobility(4, 4), 4.0 / (4.0 * 4.0 + 0.5 * 16.0), 1e-15);
  const auto along = task_space_inertia(mobility, {{false, false, false, false, true, false}});
  EXPECT_TRUE(along.status.ok());
  EXPECT_NEAR(along(4, 4), 6.0, 1e-14) << "4 kg, and 8 kg m^2 at 2 m";
  const auto both = task_space_inertia(mobility, position_only);
  EXPECT_EQ(both.status.code, Status::Code::near_singular);
  EXPECT_EQ(both.status.joint, -1);
  EXPECT_EQ(both(4, 4), 0.0);
}

// The elbow of a planar arm of two equal links, nearly straight: along it the share that is left falls with the square
// of the angle.
TEST(TaskSpaceInertia, SaysWhereASingularityIsNear) {
  using R = robots::Planar2r;
  const Directions plane{{false, false, false, true, true, false}};
  for (const double angle : {1.0, 0.3}) {
    EXPECT_TRUE(task_space_inertia(tool_mobility<R>(Joints<R, double>{0.4, angle}), plane).status.ok()) << angle;
  }
  for (const double angle : {1e-3, 1e-9, 0.0, -1e-3}) {
    const auto inertia = task_space_inertia(tool_mobility<R>(Joints<R, double>{0.4, angle}), plane);
    EXPECT_EQ(inertia.status.code, Status::Code::near_singular) << angle;
    for (const double x : inertia.values)
      EXPECT_EQ(x, 0.0);
  }
  EXPECT_EQ(task_space_inertia(tool_mobility<R>(Joints<R, float>{NAN, 0.5F}), plane).status.code,
            Status::Code::not_finite);
}

namespace {
struct Massless {
  static constexpr auto chain = axial::chain(revolute().mass(1).com(1, 0, 0), revolute().a(1.0), tool(0.5, 0, 0));
};
}  // namespace
TEST(TaskSpaceInertia, NamesAJointThatNothingResists) {
  const auto mobility = tool_mobility<Massless>(Joints<Massless, double>{0.3, 0.7});
  EXPECT_EQ(mobility.status.code, Status::Code::near_singular);
  EXPECT_EQ(mobility.status.joint, 1);
  EXPECT_TRUE(std::isfinite(mobility(4, 4)));
  EXPECT_EQ(task_space_inertia(mobility, {{false, false, false, false, true, false}}).status.joint, 1);
}

TEST(ToolAgainstKdl, BiasAccelerationOnSerialRobots) {
  robots::for_each([&](auto entry) {
    using R = typename decltype(entry)::Robot;
    SCOPED_TRACE(entry.name);
    const oracle::KdlChain kdl(oracle::of_robot<double, R>());
    oracle::RandomChains random(seed);
    for (int k = 0; k < states; ++k) {
      const auto state = random_state<R>(random);
      const auto found = bias_acceleration(jacobian<R>(joints<R, double>(state.q)), joints<R, double>(state.qd));
      EXPECT_LE(oracle::relative_error(six(found), six(kdl.tool_bias_acceleration(state.q, state.qd))), 1e-13);
    }
  });
}

TEST(ToolAgainstKdl, BiasAccelerationOnRandomChains) {
  oracle::RandomChains random(seed);
  for (int n = 1; n <= 8; ++n) {
    const auto chain = random.chain(n);
    const oracle::KdlChain kdl(chain);
    const auto q = random.vector(n, 2.5), qd = random.vector(n, 2.0);
    const auto reference =
        bias_by_differences(oracle::convert<quad>(chain), oracle::convert<quad>(q), oracle::convert<quad>(qd));
    EXPECT_LE(oracle::relative_error(six(kdl.tool_bias_acceleration(q, qd)), reference), 1e-13) << n;
  }
}
