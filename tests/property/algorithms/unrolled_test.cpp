// Twenty random chains as types: the unrolled form equals the looped one and the oracle.
#include <cases/to_axial.hpp>

#include <property/support.hpp>

namespace {

// A constexpr generator (Knuth's MMIX congruence), so that the compiler draws the chain.
class Random {
 public:
  constexpr explicit Random(unsigned seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
  constexpr double uniform(double low, double high) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + (high - low) * static_cast<double>(state_ >> 40) / 16777216.0;
  }
  constexpr int below(int count) { return static_cast<int>(uniform(0.0, 1.0) * count); }

 private:
  std::uint64_t state_;
};

constexpr axial::Link random_link(Random& r) {
  constexpr double twists[] = {0, 90, -90, 180, 37, -64};
  auto link = (r.below(3) == 0 ? axial::prismatic() : axial::revolute()).alpha_deg(twists[r.below(6)]);
  if (r.below(2) == 0) link = link.a(r.uniform(-0.5, 0.5));
  if (r.below(2) == 0) link = link.d(r.uniform(-0.5, 0.5));
  if (r.below(2) == 0) link = link.theta_deg(twists[r.below(6)]);
  link =
      link.mass(r.uniform(0.25, 8)).com(r.uniform(-0.2, 0.2), r.below(2) * r.uniform(-0.2, 0.2), r.uniform(-0.2, 0.2));
  link = link.inertia_com(r.uniform(0.05, 0.1), r.uniform(0.05, 0.1), r.uniform(0.05, 0.1),
                          r.below(2) * r.uniform(-0.02, 0.02), 0.0, r.uniform(-0.02, 0.02));
  return r.below(2) == 0 ? link : link.rotor_inertia(r.uniform(0, 2e-4), 100);
}

constexpr axial::Link random_branch(Random& r, const axial::Link& link) {
  constexpr double turns[] = {0, 90, -90, 180, 53, -28};
  const double gamma = turns[r.below(6)];
  return link.branch_deg(gamma, r.below(3) * r.uniform(-0.25, 0.25));
}

template <int N>
constexpr axial::Chain<N> random_chain(unsigned seed, bool tree) {
  Random r(seed);
  axial::Chain<N> chain;
  chain.gravity = {r.uniform(-9, 9), 0.0, r.uniform(-9, 9)};
  for (int i = 0; i < N; ++i) {
    auto link = random_link(r).parent(tree ? r.below(i + 1) - 1 : i - 1);
    if (tree && r.below(3) > 0) link = random_branch(r, link);
    chain.links[i] = link.parameters();
  }
  return chain;
}

template <unsigned Seed>
struct RandomRobot {
  static constexpr int joints = 1 + static_cast<int>(Seed) % 12;
  static constexpr auto chain = random_chain<joints>(Seed, Seed % 5 == 0);
};

template <unsigned Seed>
struct SeedOf {
  using Robot = RandomRobot<Seed>;
};

template <class S>
class Unrolled : public testing::Test {};
using Seeds = testing::Types<SeedOf<0>, SeedOf<1>, SeedOf<2>, SeedOf<3>, SeedOf<4>, SeedOf<5>, SeedOf<6>, SeedOf<7>,
                             SeedOf<8>, SeedOf<9>, SeedOf<10>, SeedOf<11>, SeedOf<12>, SeedOf<13>, SeedOf<14>,
                             SeedOf<15>, SeedOf<16>, SeedOf<17>, SeedOf<18>, SeedOf<20>>;
TYPED_TEST_SUITE(Unrolled, Seeds);

}  // namespace

TYPED_TEST(Unrolled, EqualsLoopedAndOracle) {
  using namespace axial;
  using oracle::quad;
  using R = typename TypeParam::Robot;
  using L = Scene<R, Gravity, RotorInertia, Looped, ArticulatedBody>;
  using A = Scene<R, Gravity, RotorInertia, ArticulatedBody>;
  using C = Scene<R, Gravity, RotorInertia, CompositeBody>;
  constexpr int n = R::chain.size;
  const auto chain = oracle::of_robot<quad, R>();
  oracle::RandomChains random(n);
  for (int k = 0; k < 10; ++k) {
    const auto q_ = random.vector(n, 3.0), qd_ = random.vector(n, 2.0), qdd_ = random.vector(n, 4.0);
    const auto q = property::joints<R, double>(q_), qd = property::joints<R, double>(qd_),
               qdd = property::joints<R, double>(qdd_);
    const auto tau = inverse_dynamics<R>(q, qd, qdd);
    const auto reference = oracle::inverse_dynamics(chain, oracle::convert<quad>(q_), oracle::convert<quad>(qd_),
                                                    oracle::convert<quad>(qdd_));
    EXPECT_LE(oracle::relative_error(property::vector(tau), reference), 1e-13);
    EXPECT_LE(oracle::relative_error(property::vector(inverse_dynamics<L>(q, qd, qdd)), property::vector(tau)), 1e-13);
    EXPECT_LE(oracle::relative_error(oracle::convert<quad>(property::matrix(mass_matrix<R>(q))),
                                     oracle::mass_matrix(chain, oracle::convert<quad>(q_))),
              1e-13);
    const auto acceleration = forward_dynamics<A>(q, qd, tau), looped = forward_dynamics<L>(q, qd, tau),
               composite = forward_dynamics<C>(q, qd, tau);
    const oracle::Vector<double> ours(acceleration.values, acceleration.values + n);
    EXPECT_LE(oracle::relative_error(ours, qdd_), 1e-10);
    EXPECT_LE(oracle::relative_error(oracle::Vector<double>(looped.values, looped.values + n), ours), 1e-10);
    EXPECT_LE(oracle::relative_error(oracle::Vector<double>(composite.values, composite.values + n), ours), 1e-9);
  }
}
