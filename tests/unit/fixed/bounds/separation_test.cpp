// The operators of separation on bounds against the kernel's own on numbers, as transfer_test.cpp has the others.
#include "fine_link.hpp"

namespace {

using namespace axial;
using namespace bounds_test;

// A body whose inertia has eigenvalues of any sign, which regrouped parameters bring about.
struct AnyBody {
  SplitBall moment;
  Ball inertia;
  double mass;

  static AnyBody any(std::mt19937_64& random) {
    return {any_bound(random), {any_size(random), random() % 2 == 0 ? 0.0 : 1e-3}, any_size(random)};
  }
  bounds::CompositeBody bounded_body() const {
    return {bounds::literal_of(mass), bounded(moment), bounds::word_of(inertia, fine), inertia};
  }
};
// R diag(a, b, c) R^T, R a turn about z, or about y.
Sym3<double> of_eigenvalues(double norm, Choice& c) {
  const double a = norm * c.next(), b = norm * c.next(), z = norm * c.next(), q = M_PI * c.next();
  const double cos = std::cos(q), sin = std::sin(q);
  const double first = cos * cos * a + sin * sin * b, second = sin * sin * a + cos * cos * b,
               couple = cos * sin * (a - b);
  if (c.next() > 0.0) return {first, z, second, 0.0, couple, 0.0};
  return {first, second, z, couple, 0.0, 0.0};
}
Sym3<double> any_inertia(double norm, Choice& c) {
  return c.next() > 0.0 ? of_eigenvalues(norm, c) : symmetric(norm, c);
}
using PlainBody = RigidInertia<double, Vector, Sym3<double>>;
struct BodySample {
  PlainBody exact, computed;
};
BodySample body_sample(const AnyBody& body, Choice& c) {
  const Sample h = sample(body.moment, c);
  const Sym3<double> j = any_inertia(body.inertia.size, c);
  return {{body.mass, h.exact, j}, {body.mass, h.computed, added(j, any_inertia(body.inertia.error, c))}};
}

// The nearness of moment and force, each part's larger.
template <class F>
Nearness of_forces(const ForceVector<BoundedVector, BoundedVector>& bound, const F& exact, const F& computed) {
  Nearness moment = nearness(bound.moment.bound, exact.moment, computed.moment);
  const Nearness force = nearness(bound.force.bound, exact.force, computed.force);
  for (std::size_t part = 0; part < moment.of.size(); ++part)
    moment.of[part] = std::fmax(moment.of[part], force.of[part]);
  return moment;
}
using PlainForce = ForceVector<Vector, Vector>;

// Force of a product of two rates, w being the motion of the inner one.
template <class Kind>
Nearness search_products(std::mt19937_64& random) {
  const AnyBody body = AnyBody::any(random);
  const SplitBall w = any_bound(random);
  const auto bound = product_force(Kind{}, FineLink{}, body.bounded_body(), bounded(w));
  return climb(
      [&](Choice& c) {
        const BodySample b = body_sample(body, c);
        const Sample s = sample(w, c);
        const PlainForce exact = separation::product_force(Kind{}, Plain{}, b.exact, s.exact);
        return of_forces(bound, exact, PlainForce(separation::product_force(Kind{}, Plain{}, b.computed, s.computed)));
      },
      random());
}
template <class Kind>
void expect_weights(double near) {
  std::mt19937_64 random(13);
  double nearest = 0.0;
  for (int shape = 0; shape < 60; ++shape) {
    const AnyBody body = AnyBody::any(random);
    const SplitBall a = any_bound(random);
    const Ball bound = weight(Kind{}, body.bounded_body(), bounded(a)).bound;
    const Nearness seen = climb(
        [&](Choice& c) {
          const BodySample b = body_sample(body, c);
          const Sample s = sample(a, c);
          const double exact = separation::weight(Kind{}, b.exact, s.exact);
          const double off = separation::weight(Kind{}, b.computed, s.computed) - exact;
          return Nearness{{ratio(std::fabs(exact), bound.size), ratio(std::fabs(off), bound.error)}};
        },
        random());
    EXPECT_LE(seen.of[0], 1.0 + 1e-6);
    EXPECT_LE(seen.of[1], 1.0 + 1e-6);
    nearest = std::fmax(nearest, std::fmin(seen.of[0], seen.of[1]));
  }
  EXPECT_GT(nearest, near);
}

/// Notes what it is told to leave room for.
struct RoomyLink : FineLink {
  mutable double inertia = 0.0, moment = 0.0;
  void leave_room(quantity::RotationalInertia, double size) const { inertia = size; }
  void leave_room(quantity::FirstMoment, double size) const { moment = size; }
};

}  // namespace

TEST(Products, OfTwoVectors) {
  std::mt19937_64 random(12);
  double by_parts = 0.0, by_wholes = 0.0;
  for (int shape = 0; shape < 120; ++shape) {
    const bool parts = random() % 2 == 0;
    SplitBall u = any_bound(random), v = any_bound(random);
    if (!parts) {  // of no direction: the wholes bound the product, the parts do not
      u = {u.whole, u.whole, u.whole}, v = {v.whole, v.whole, v.whole};
    }
    const Ball bound = dot(bounded(u), bounded(v)).bound;
    const Nearness seen = climb(
        [&](Choice& c) {
          const Sample a = sample(u, c), b = sample(v, c);
          const double exact = dot(a.exact, b.exact), off = dot(a.computed, b.computed) - exact;
          return Nearness{{ratio(std::fabs(exact), bound.size), ratio(std::fabs(off), bound.error)}};
        },
        random());
    EXPECT_LE(seen.of[0], 1.0 + 1e-6);
    EXPECT_LE(seen.of[1], 1.0 + 1e-6);
    double& nearest = parts ? by_parts : by_wholes;
    nearest = std::fmax(nearest, std::fmin(seen.of[0], seen.of[1]));
  }
  EXPECT_GT(by_parts, 0.85);
  EXPECT_GT(by_wholes, 0.85);
}
TEST(SeparatedForces, OfTheSquareOfARate) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const AnyBody body = AnyBody::any(random);
        const auto bound = square_force(Revolute{}, body.bounded_body());
        return climb(
            [&](Choice& c) {
              const BodySample b = body_sample(body, c);
              const PlainForce exact = separation::square_force(Revolute{}, b.exact);
              return of_forces(bound, exact, PlainForce(separation::square_force(Revolute{}, b.computed)));
            },
            random());
      },
      0.0);
}
TEST(SeparatedForces, OfTheProductOfTwoRatesOfATurningJoint) {
  std::mt19937_64 random(14);
  Nearness nearest;
  for (int shape = 0; shape < 60; ++shape) {
    const Nearness seen = search_products<Revolute>(random);
    for (std::size_t part = 0; part < nearest.of.size(); ++part) {
      EXPECT_LE(seen.of[part], 1.0 + 1e-6);
      nearest.of[part] = std::fmax(nearest.of[part], seen.of[part]);
    }
  }
  for (const double part : nearest.of)
    EXPECT_GT(part, 0.8);
}
TEST(SeparatedForces, OfTheProductOfTwoRatesOfASlide) {
  expect_bounds([](std::mt19937_64& random) { return search_products<Prismatic>(random); }, 0.9);
}
TEST(SeparatedForces, AgainstGravity) {
  expect_weights<Revolute>(0.9);
  expect_weights<Prismatic>(0.9);
}
TEST(SeparatedForces, ComeOfAUnitOfTheRate) {
  const Vector along{0.0, 0.0, 1.0};
  const Nearness seen = nearness(bounds::detail::unit_along(exact_rounding).bound, along, along);
  EXPECT_TRUE(bounds::detail::unit_along(exact_rounding).is_literal) << "a product with it rounds as the other factor";
  EXPECT_EQ(seen.of[1], 1.0);
  EXPECT_EQ(seen.of[2], 1.0);
}
// Entries that the kernel adds up before it multiplies: (jyy - jxx) + jzz and twice a first moment.
TEST(SeparatedForces, HaveRoomForTheSumsThatTheyMultiply) {
  std::mt19937_64 random(15);
  for (int shape = 0; shape < 20; ++shape) {
    const AnyBody body = AnyBody::any(random);
    RoomyLink link;
    (void)product_force(Revolute{}, link, body.bounded_body(), bounded(any_bound(random)));
    const Nearness seen = climb(
        [&](Choice& c) {
          const BodySample b = body_sample(body, c);
          const Sym3<double>& j = b.exact.inertia;
          const double second = std::fmax(std::fabs(j.yy - j.xx + j.zz), 2.0 * std::fabs(j.xy));
          const Vector& h = b.exact.first_moment;
          return Nearness{{second / link.inertia, ratio(2.0 * std::fmax(std::fabs(h.x), std::fabs(h.z)), link.moment)}};
        },
        random());
    EXPECT_LE(seen.of[0], 1.0 + 1e-12);
    EXPECT_LE(seen.of[1], 1.0 + 1e-12);
    EXPECT_GT(seen.of[0], 0.95);
  }
}
