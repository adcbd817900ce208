// The unrolled form against Lagrange's equations, with every kind of twist between joints of either kind.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/lagrange.hpp>

using namespace axial;

namespace {

constexpr auto bodied(const Link& link) {
  return link.mass(2).com(0.1, -0.2, 0.3).inertia_com(0.5, 0.6, 0.7, 0.1, 0.05, -0.1);
}

struct Turns {
  static constexpr auto chain =
      axial::chain(gravity(1, 2, -9), bodied(revolute().alpha_deg(90).d(0.2)), bodied(revolute().alpha_deg(-90).a(0.3)),
                   bodied(revolute().alpha_deg(180).a(0.1).d(-0.1)), bodied(revolute().alpha(0.5).a(0.2)),
                   bodied(revolute().alpha_deg(0).a(0.25).theta_deg(90)));
};
struct Slides {
  static constexpr auto chain =
      axial::chain(gravity(1, 2, -9), bodied(prismatic().alpha_deg(90)), bodied(revolute().alpha_deg(90).a(0.3)),
                   bodied(prismatic().alpha_deg(-90).a(0.1).d(0.2).theta_deg(90)), bodied(revolute().alpha(0.5).d(0.1)),
                   bodied(prismatic().alpha(-0.3).a(0.2).rotor_inertia(0.01, 10)));
};

struct Bare {
  static constexpr auto chain = axial::chain(gravity(1, 2, -9), bodied(revolute()), revolute().alpha(0.5).a(0.2));
};
struct Laden {
  static constexpr auto chain =
      axial::chain(gravity(1, 2, -9), bodied(revolute()), bodied(revolute().alpha(0.5).a(0.2)));
};

template <class R>
void expect_lagrange() {
  using J = Joints<R, double>;
  const auto chain = oracle::of_robot<double, R>();
  for (int k = 0; k < 8; ++k) {
    J q{}, qd{}, qdd{};
    for (int i = 0; i < J::size; ++i)
      q[i] = 0.3 * i - 0.7 * k + 0.1, qd[i] = 1.0 - 0.4 * i + 0.2 * k, qdd[i] = 0.5 * i - 1.0 + 0.3 * k;
    const auto vector = [](const J& x) { return oracle::Vector<double>(x.values, x.values + J::size); };
    const auto expected = oracle::inverse_dynamics(chain, vector(q), vector(qd), vector(qdd));
    const auto found = inverse_dynamics<R>(q, qd, qdd);
    for (int i = 0; i < J::size; ++i)
      EXPECT_NEAR(found[i], expected[std::size_t(i)], 1e-11) << "state " << k << ", joint " << i;
  }
}

}  // namespace

TEST(InverseDynamics, OfTurnsAtEveryKindOfTwistIsLagranges) { expect_lagrange<Turns>(); }
TEST(InverseDynamics, OfSlidesAmongThemIsLagranges) { expect_lagrange<Slides>(); }

TEST(InverseDynamics, APayloadIsABodyOfTheLastLink) {
  using S = Scene<Bare, Gravity, Payload>;
  Inputs<S, double> in{};
  const auto& body = Laden::chain.links[1];
  const auto& j = body.inertia_com;
  in.payload = {body.mass, {body.com[0], body.com[1], body.com[2]}, {j[0], j[1], j[2], j[3], j[4], j[5]}};
  const Joints<Bare, double> q{0.4, -1.1}, qd{0.7, -0.9}, qdd{1.5, 2.5};
  const auto carried = inverse_dynamics<S>(q, qd, qdd, in);
  const auto own = inverse_dynamics<Laden>(Joints<Laden, double>{0.4, -1.1}, Joints<Laden, double>{0.7, -0.9},
                                           Joints<Laden, double>{1.5, 2.5});
  for (int i = 0; i < 2; ++i)
    EXPECT_NEAR(carried[i], own[i], 1e-13) << i;
}
