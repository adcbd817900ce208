// Axial masses: slides that move apart from all else give their mass up to the parent, and no kernel feels it.
#include <gtest/gtest.h>
#include <axial/axial.hpp>

#include <cmath>

using namespace axial;

namespace {

constexpr Link turn(double a) {
  return revolute().a(a).mass(2.0).com(0.1, 0.03, 0.02).inertia_com(0.02, 0.03, 0.04, 0.001, 0.002, 0.003);
}
constexpr Link slide(double a) {
  return prismatic().a(a).mass(1.3).com(0.02, -0.01, 0.05).inertia_com(0.01, 0.012, 0.005, 0.0005, 0.0, -0.0004);
}

// A slide behind two parallel turns, upside down, with a rotor.
struct Drill {
  static constexpr auto chain = axial::chain(gravity(1.0, -2.0, -9.0), turn(0.0), turn(0.4),
                                             slide(0.3).alpha_deg(180.0).rotor_inertia(1e-5, 60.0));
};
// A wrist outboard of the slide, whose axes are not parallel to it.
struct Wristed {
  static constexpr auto chain = axial::chain(gravity(1.0, -2.0, -9.0), turn(0.0), slide(0.3).theta_deg(30.0),
                                             turn(0.2).alpha_deg(90.0), turn(0.1).alpha(0.4).rotor_inertia(1e-5, 60.0));
};
// Two slides on branches of one turning body, each of which is apart from the other.
struct Fork {
  static constexpr auto chain = axial::chain(gravity(1.0, -2.0, -9.0), turn(0.0), slide(0.3).parent(0),
                                             slide(0.2).parent(0).branch_deg(50.0, 0.1), turn(0.15));
};
// None is apart: a slide inboard, a slide outboard, an axis that is not parallel.
struct Stacked {
  static constexpr auto chain = axial::chain(gravity(1.0, -2.0, -9.0), slide(0.0), turn(0.2), slide(0.3));
};
struct Gantry {
  static constexpr auto chain =
      axial::chain(gravity(1.0, -2.0, -9.0), turn(0.0), slide(0.2), slide(0.3).alpha_deg(90.0));
};
struct Leaning {
  static constexpr auto chain = axial::chain(gravity(1.0, -2.0, -9.0), turn(0.0), turn(0.3), slide(0.2).alpha(0.3));
};

template <class S, int I>
constexpr bool axial_mass = decltype(links_of<S, double, BaseParameters>().link(Index<I>{}))::has_axial_mass;
static_assert(axial_mass<Drill, 2> && axial_mass<Wristed, 1> && axial_mass<Fork, 1> && axial_mass<Fork, 2>);
static_assert(axial_mass<Stacked, 0> == false && !axial_mass<Stacked, 2>);
static_assert(!axial_mass<Gantry, 1> && !axial_mass<Gantry, 2> && !axial_mass<Leaning, 2>);
// A payload or water may hang on the slide; a base that moves accelerates it along its axis.
static_assert(!axial_mass<Scene<Drill, RotorInertia, Payload>, 2> &&
              !axial_mass<Scene<Drill, RotorInertia, Underwater>, 2> &&
              !axial_mass<Scene<Drill, RotorInertia, BaseMotion>, 2>);

constexpr double tolerance = 1e-13;  ///< of the largest value: some hundred roundings
template <class A, class B>
void expect_near(const A& seen, const B& expected, const char* what) {
  double size = 1.0;
  for (int i = 0; i < A::size; ++i)
    size = std::fmax(size, std::fabs(expected[i]));
  for (int i = 0; i < A::size; ++i)
    EXPECT_NEAR(seen[i], expected[i], tolerance * size) << what << ' ' << i;
}

template <class R>
class AxialMasses : public testing::Test {};
using Robots = testing::Types<Drill, Wristed, Fork, Stacked, Gantry, Leaning>;
TYPED_TEST_SUITE(AxialMasses, Robots);

}  // namespace

TYPED_TEST(AxialMasses, AreNotFelt) {
  using R = TypeParam;
  using Base = Scene<R, Gravity, RotorInertia, TipWrench, CompositeBody>;
  using Full = Scene<R, Gravity, RotorInertia, TipWrench, ArticulatedBody, FullParameters>;
  Joints<R, double> q{}, qd{}, x{};
  for (int i = 0; i < q.size; ++i)
    q[i] = 0.3 + 0.4 * i, qd[i] = 1.5 - 0.7 * i, x[i] = 2.0 - 1.1 * i;
  Inputs<Base, double> in{};
  Inputs<Full, double> same{};
  in.tip_wrench = {{0.3, -0.2, 0.1}, {1.0, 2.0, -3.0}}, same.tip_wrench = in.tip_wrench;

  expect_near(inverse_dynamics<Base>(q, qd, x, in), inverse_dynamics<Full>(q, qd, x, same), "inverse dynamics");
  expect_near(gravity_torque<Base>(q, in), gravity_torque<Full>(q, same), "gravity");
  const auto solved = forward_dynamics<Base>(q, qd, x, in), expected = forward_dynamics<Full>(q, qd, x, same);
  ASSERT_TRUE(solved.status.ok() && expected.status.ok());
  expect_near(solved, expected, "forward dynamics");
  const auto momenta = momentum_terms<Base>(q, qd, in);
  const auto full_momenta = momentum_terms<Full>(q, qd, same);
  expect_near(momenta.momentum, full_momenta.momentum, "momenta");
  expect_near(momenta.drift, full_momenta.drift, "drift");
  expect_near(torque(separate<Base>(q, in), qd, x), inverse_dynamics<Full>(q, qd, x, same), "separation");
  const auto m = mass_matrix<Base>(q, in);
  const auto full_m = mass_matrix<Full>(q, same);
  for (int i = 0; i < q.size; ++i)
    for (int j = 0; j <= i; ++j)
      EXPECT_NEAR(m(i, j), full_m(i, j), tolerance * 10.0) << i << ' ' << j;
}
