// A, B, C, G of the Automatic Separation Method against first principles: M and its derivatives from Jacobians.
#include <cases/to_axial.hpp>
#include <robots/robots.hpp>

#include "scene_robot.hpp"

namespace {

using oracle::quad;
using property::joints;

constexpr double tolerance = 1e-12;
constexpr double sum_double = 1e-13, sum_float = 1e-5;

/// The four matrices of one configuration, in the layout of Separated.
template <class T>
struct Terms {
  oracle::Matrix<T> A, B, C;
  oracle::Vector<T> G;
};

// Christoffel's symbols of the oracle's mass matrix.
Terms<quad> reference(const oracle::Chain<quad>& chain, const oracle::Vector<quad>& q) {
  const int n = chain.size();
  const auto dM = oracle::mass_matrix_derivatives(chain, q);
  const auto d = [&](int i, int j, int k) { return dM[std::size_t(k)](i, j); };
  Terms<quad> t{oracle::mass_matrix(chain, q), oracle::Matrix<quad>(n, n > 1 ? n * (n - 1) / 2 : 1),
                oracle::Matrix<quad>(n, n), oracle::gravity_torque(chain, q)};
  for (int i = 0; i < n; ++i) {
    for (int j = 0, pair = 0; j < n; ++j) {
      t.C(i, j) = d(i, j, j) - d(j, j, i) / 2;
      for (int k = j + 1; k < n; ++k, ++pair)
        t.B(i, pair) = d(i, j, k) + d(i, k, j) - d(j, k, i);
    }
  }
  return t;
}

template <class S, class T>
Terms<T> terms(const axial::Separated<S, T>& s, int n) {
  Terms<T> t{oracle::Matrix<T>(n, n), oracle::Matrix<T>(n, n > 1 ? n * (n - 1) / 2 : 1), oracle::Matrix<T>(n, n), {}};
  for (int i = 0; i < n; ++i) {
    t.G.push_back(s.G[i]);
    for (int j = 0, pair = 0; j < n; ++j) {
      t.A(i, j) = s.A[i][j], t.C(i, j) = s.C[i][j];
      for (int k = j + 1; k < n; ++k, ++pair)
        t.B(i, pair) = s.B[i][s.pair(j, k)];
    }
  }
  return t;
}

double largest_difference(const oracle::Matrix<double>& ours, const oracle::Matrix<quad>& exact) {
  double worst = 0.0;
  for (int i = 0; i < exact.rows(); ++i)
    for (int j = 0; j < exact.columns(); ++j)
      worst = std::fmax(worst, static_cast<double>(oracle::abs(quad(ours(i, j)) - exact(i, j))));
  return worst;
}
double largest_of(const oracle::Matrix<quad>& m) { return oracle::largest(oracle::elements(m)); }

// A, B and C relative to the largest coefficient of the three (B and C may vanish), G to its own; returns the worst.
double expect_equal(const Terms<double>& ours, const Terms<quad>& exact) {
  const double scale = std::fmax(largest_of(exact.A), std::fmax(largest_of(exact.B), largest_of(exact.C)));
  const double errors[] = {largest_difference(ours.A, exact.A) / scale, largest_difference(ours.B, exact.B) / scale,
                           largest_difference(ours.C, exact.C) / scale, oracle::relative_error(ours.G, exact.G)};
  double worst = 0.0;
  for (int i = 0; i < 4; ++i) {
    EXPECT_LE(errors[i], tolerance) << "ABCG"[i];
    worst = std::fmax(worst, errors[i]);
  }
  return worst;
}

// dA/dt - 2 C(q, qd) is skew, C(q, qd) being made of Christoffel's symbols: its symmetric part, per unit of the largest
// inertia, vanishes.
double symmetric_part(const Terms<double>& ours, const oracle::Chain<quad>& chain, const oracle::Vector<quad>& q,
                      const oracle::Vector<double>& qd) {
  const int n = chain.size();
  const auto dM = oracle::mass_matrix_derivatives(chain, q);
  const auto pair = [n](int j, int k) { return j * n - j * (j + 1) / 2 + k - j - 1; };
  const auto symbol = [&](int i, int j, int k) {
    return j == k ? ours.C(i, j) : ours.B(i, j < k ? pair(j, k) : pair(k, j)) / 2;
  };
  double worst = 0.0, largest = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      quad rate = 0, both = 0;
      for (int k = 0; k < n; ++k) {
        rate += dM[std::size_t(k)](i, j) * quad(qd[std::size_t(k)]);
        both += (quad(symbol(i, j, k)) + quad(symbol(j, i, k))) * quad(qd[std::size_t(k)]);
      }
      worst = std::fmax(worst, static_cast<double>(oracle::abs(rate - both)));
      largest = std::fmax(largest, std::fabs(ours.A(i, j)));
    }
  return largest > 0.0 ? worst / largest : worst;
}

template <class R>
class Separation : public testing::Test {};
using Robots = testing::Types<robots::Scara, robots::ScaraRrpr, robots::Puma560, robots::Panda, robots::Planar2r>;
TYPED_TEST_SUITE(Separation, Robots);

template <class S, class T>
double sum_error(const property::State& s) {
  using R = axial::robot_of<S>;
  const auto q = joints<R, T>(s.q), qd = joints<R, T>(s.qd), qdd = joints<R, T>(s.qdd);
  const auto rnea = axial::inverse_dynamics<S>(q, qd, qdd);
  return oracle::relative_error(property::vector(axial::torque(axial::separate<S>(q), qd, qdd)),
                                oracle::convert<quad>(oracle::convert<double>(property::vector(rnea))));
}

}  // namespace

TYPED_TEST(Separation, EqualsTheOracle) {
  const auto chain = oracle::of_robot<quad, TypeParam>();
  oracle::RandomChains random(26);
  double worst = 0.0, skew = 0.0;
  for (int k = 0; k < 100; ++k) {
    const auto s = property::random_state<TypeParam>(random);
    const auto q = oracle::convert<quad>(s.q);
    const auto ours = terms(axial::separate<TypeParam>(joints<TypeParam, double>(s.q)), chain.size());
    worst = std::fmax(worst, expect_equal(ours, reference(chain, q)));
    skew = std::fmax(skew, symmetric_part(ours, chain, q, s.qd));
  }
  EXPECT_LE(skew, tolerance);
  std::printf("worst relative error %.1e; symmetric part of dA/dt - 2C %.1e\n", worst, skew);
}

TYPED_TEST(Separation, SumsToInverseDynamics) {
  using Compact = axial::Scene<TypeParam, axial::Gravity, axial::RotorInertia, axial::Looped>;
  oracle::RandomChains random(27);
  double worst = 0.0, worst_float = 0.0;
  for (int k = 0; k < 500; ++k) {
    const auto s = property::random_state<TypeParam>(random);
    worst = std::fmax(worst, sum_error<TypeParam, double>(s));
    worst_float = std::fmax(worst_float, sum_error<TypeParam, float>(s));
    EXPECT_LE((sum_error<Compact, double>(s)), sum_double);
  }
  EXPECT_LE(worst, sum_double);
  EXPECT_LE(worst_float, sum_float);
  std::printf("worst difference to RNEA: double %.1e, float %.1e\n", worst, worst_float);
}

TYPED_TEST(Separation, PartsAreThoseOfTheWhole) {
  oracle::RandomChains random(28);
  const auto q = joints<TypeParam, float>(property::random_state<TypeParam>(random).q);
  const auto all = axial::separate<TypeParam>(q);
  const auto A = axial::separate_A<TypeParam>(q);
  const auto B = axial::separate_B<TypeParam>(q);
  const auto C = axial::separate_C<TypeParam>(q);
  const auto G = axial::separate_G<TypeParam>(q);
  for (int i = 0; i < all.size; ++i) {
    EXPECT_EQ(all.G[i], G.G[i]);
    for (int j = 0; j < all.size; ++j) {
      EXPECT_EQ(all.A[i][j], A.A[i][j]);
      EXPECT_EQ(all.C[i][j], C.C[i][j]);
    }
    for (int pair = 0; pair < all.pairs; ++pair)
      EXPECT_EQ(all.B[i][pair], B.B[i][pair]);
  }
}

namespace {

using Model = axial::Model<16>;

void expect_random_equal_to_oracle(bool tree, int chains) {
  oracle::RandomChains random(tree ? 31 : 30);
  double worst = 0.0;
  for (int k = 0; k < chains; ++k) {
    const int n = 1 + k % 16;
    const auto source = tree ? random.branched_tree(n) : random.chain(n);
    const auto q = random.vector(n, 3.0), qd = random.vector(n, 2.0), qdd = random.vector(n, 4.0);
    SCOPED_TRACE(testing::Message() << "chain " << k << " of " << n << " joints");
    const auto chain = oracle::convert<quad>(source);
    const Model model = cases::to_model<Model>(source);
    const auto separated = axial::separate(model, joints<Model, double>(q));
    const auto ours = terms(separated, n);
    worst = std::fmax(worst, expect_equal(ours, reference(chain, oracle::convert<quad>(q))));
    EXPECT_LE(symmetric_part(ours, chain, oracle::convert<quad>(q), qd), tolerance);
    const auto tau = axial::torque(model, separated, joints<Model, double>(qd), joints<Model, double>(qdd));
    const auto exact = oracle::inverse_dynamics(chain, oracle::convert<quad>(q), oracle::convert<quad>(qd),
                                                oracle::convert<quad>(qdd));
    EXPECT_LE(oracle::relative_error(property::vector(tau, n), exact), tolerance);
  }
  std::printf("worst relative error %.1e\n", worst);
}

// Whatever a scene names, the terms sum to its inverse dynamics.
template <class S>
void expect_scene_sums() {
  using R = property::Everything;
  oracle::RandomChains random(33);
  for (int k = 0; k < 20; ++k) {
    const auto q = joints<R, double>(random.vector(4, 3.0)), qd = joints<R, double>(random.vector(4, 2.0)),
               qdd = joints<R, double>(random.vector(4, 4.0));
    auto in = property::Fill::inputs<S, double>(q);
    if constexpr (S::template has<axial::Payload>) in.payload = {1.5, {0.1, -0.2, 0.3}, {0.1, 0.2, 0.25}};
    const auto tau = axial::torque(axial::separate<S>(q, in), qd, qdd);
    EXPECT_LE(
        oracle::relative_error(property::vector(tau),
                               oracle::convert<quad>(property::vector(axial::inverse_dynamics<S>(q, qd, qdd, in)))),
        sum_double);
  }
}

}  // namespace

TEST(SeparationOfRandomChains, EqualsTheOracle) { expect_random_equal_to_oracle(false, 200); }
TEST(SeparationOfRandomTrees, EqualsTheOracle) { expect_random_equal_to_oracle(true, 100); }

TEST(SeparationOfScenes, SumsToInverseDynamics) {
  using namespace axial;
  using R = property::Everything;
  expect_scene_sums<Scene<R, RotorInertia>>();
  expect_scene_sums<Scene<R, RuntimeGravity, Friction, JointSprings>>();
  expect_scene_sums<Scene<R, Gravity, RotorInertia, Payload, SineCosines>>();
  expect_scene_sums<Scene<R, Gravity, RotorInertia, TipWrench, JointSprings, FullParameters>>();
  expect_scene_sums<Scene<R, Gravity, Friction, ExternalWrenches, Payload, Looped>>();
}
