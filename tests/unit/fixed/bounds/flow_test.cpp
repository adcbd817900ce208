// What derivatives carry, on bounds against the kernels' own operators on numbers: no input exceeds a size or an error,
// and a search comes near both.
#include <axial/fixed/bounds/flow.hpp>
#include <axial/fixed/bounds/loads.hpp>

#include "fine_link.hpp"

namespace {

using namespace axial;
using namespace bounds_test;
using bounds::literal_of;
using bounds::Number;
using bounds::word_of;

using Matrix = Mat3<Vector>;

Matrix outer(double size, const Vector& u, const Vector& v) { return {size * u.x * v, size * u.y * v, size * u.z * v}; }
Vector unit(Choice& c) {
  const Vector v = vector_within(1.0, 1.0, 1.0, c);
  const double length = whole(v);
  return length > 0.0 ? (1.0 / length) * v : Vector{0.0, 0.0, 1.0};
}
// A general matrix of at most that norm.
Matrix general(double norm, Choice& c) {
  const double share = norm * c.next();
  const Vector u = unit(c), v = unit(c), s = unit(c), t = unit(c);
  return outer(share, u, v) + outer(norm - std::fabs(share), s, t);
}
Matrix less(const Matrix& a, const Matrix& b) { return {minus(a.x, b.x), minus(a.y, b.y), minus(a.z, b.z)}; }
// What a matrix does to a unit vector, no more than its norm.
double reach(const Matrix& m, Choice& c) { return whole(m * unit(c)); }

struct FlowSample {
  MassFlow<Matrix, Vector> exact, computed;
};
struct FlowBound {
  Ball moment;
  SplitBall momentum;

  static FlowBound any(std::mt19937_64& random) {
    return {{any_size(random), random() % 2 == 0 ? 0.0 : 1e-3 * any_size(random)}, any_bound(random)};
  }
  bounds::BoundedFlow bounded() const { return {{moment, fine, &exact_rounding}, bounds_test::bounded(momentum)}; }
  FlowSample sample(Choice& c) const {
    const Sample p = bounds_test::sample(momentum, c);
    const Matrix m = general(moment.size, c), off = general(moment.error, c);
    return {{m, p.exact}, {m + off, p.computed}};
  }
};
// How near a flow comes to its bound: the matrix' size and error, then the vector's whole.
Nearness nearness_of(const bounds::BoundedFlow& bound, const MassFlow<Matrix, Vector>& exact,
                     const MassFlow<Matrix, Vector>& computed, Choice& c) {
  const SplitBall& p = bound.momentum.bound;
  return {{ratio(reach(exact.moment, c), bound.moment.bound.size),
           ratio(reach(less(computed.moment, exact.moment), c), bound.moment.bound.error),
           ratio(whole(exact.momentum), p.whole.size),
           ratio(whole(minus(computed.momentum, exact.momentum)), p.whole.error), 1.0, 1.0}};
}
// Each part of a force.
Nearness nearness_of(const SplitBall& moment, const SplitBall& force, const Vector& n, const Vector& n_off,
                     const Vector& f, const Vector& f_off) {
  const Nearness of_moment = nearness(moment, n, n_off), of_force = nearness(force, f, f_off);
  return {{of_moment.of[0], of_moment.of[1], of_moment.of[3], of_moment.of[4], of_force.of[2], of_force.of[5]}};
}

template <class Axis>
void expect_flows(double near) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const FlowBound given = FlowBound::any(random);
        const Ball shift{any_size(random), random() % 2 == 0 ? 0.0 : 1e-3};
        const double error = random() % 2 == 0 ? 0.0 : 1e-4;
        const Number entry = word_of({1.0, error}, fine);
        const AxialScrew<Axis, Number, Number, Number> screw{entry, entry, word_of(shift, fine)};
        const bounds::BoundedFlow bound = to_parent(screw, given.bounded(), FineLink{});
        return climb(
            [&](Choice& c) {
              const FlowSample s = given.sample(c);
              const Scalar p = sample(shift, c);
              const double q = M_PI * c.next(), cos = std::cos(q), sin = std::sin(q);
              const double c_off = cos + error * c.next(), s_off = sin + error * c.next();
              return nearness_of(
                  bound, to_parent(AxialScrew<Axis, double, double, double>{cos, sin, p.exact}, s.exact),
                  to_parent(AxialScrew<Axis, double, double, double>{c_off, s_off, p.computed}, s.computed), c);
            },
            random());
      },
      near);
}

}  // namespace

TEST(Products, OfTwoVectorsCrosswise) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall u = any_bound(random), v = any_bound(random);
        const SplitBall bound = axial::detail::tightened(cross(bounded(u), bounded(v)).bound);
        return climb(
            [&](Choice& c) {
              const Sample a = sample(u, c), b = sample(v, c);
              return nearness(bound, cross(a.exact, b.exact), cross(a.computed, b.computed));
            },
            random());
      },
      0.6);
}
TEST(Flows, OfALinkByItsMoments) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall w = any_bound(random), v = any_bound(random);
        const double m = any_size(random);
        const Vector h{any_size(random), 0.0, -any_size(random)};
        const double s = any_size(random);
        // Of a thin rod in a random plane: S = s n n^T, whose norm is its only entry's in its own axes.
        const Sym3<double> second =
            random() % 2 == 0 ? Sym3<double>{s, 0.0, 0.0, 0.0, 0.0, 0.0} : Sym3<double>{0.0, s, 0.0, 0.0, 0.0, 0.0};
        const auto of = [](double x) { return literal_of(x); };
        const DoubledMoments<Number, bounds::ConstantVector, bounds::ConstantInertia> doubled{
            of(m),
            {of(h.x), of(h.y), of(h.z), {}},
            {{of(second.xx), of(second.yy), of(second.zz), of(second.xy), of(second.xz), of(second.yz)}, {}}};
        const auto bound = mass_flow(FineLink{}, doubled, bounded(w), bounded(v));
        return climb(
            [&](Choice& c) {
              const Sample a = sample(w, c), b = sample(v, c);
              const DoubledMoments<double, Vector, Sym3<double>> known{m, h, second};
              return nearness_of(bound, mass_flow(Plain{}, known, a.exact, b.exact),
                                 mass_flow(Plain{}, known, a.computed, b.computed), c);
            },
            random());
      },
      0.6);
}
// s (1 - 2 n n^T): of all matrices of that norm the one whose second moments, tr(J) 1 - 2 J, are the largest.
Sym3<double> mirror(double norm, Choice& c) {
  const double s = norm * c.next();
  const Vector n = unit(c);
  return {s - 2.0 * s * n.x * n.x, s - 2.0 * s * n.y * n.y, s - 2.0 * s * n.z * n.z,
          -2.0 * s * n.x * n.y,    -2.0 * s * n.x * n.z,    -2.0 * s * n.y * n.z};
}
// A component that the link has not is the payload's alone: a word, whose products round.
TEST(Payloads, RoundProductsOfEveryComponent) {
  const bounds::Load load{word_of({2.0, 0.0}, fine), 0.1, 0.05, fine, fine};
  const bounds::ConstantVector h = bounds::payload_inertia(FineLink{}, load).first_moment;
  const auto product = cross(h, bounded({{1.0, 0.0}, {1.0, 0.0}, {1.5, 0.0}}));
  EXPECT_GT(product.across.rounding(fine, exact_rounding), 0.0);
  EXPECT_GT(product.along.rounding(fine, exact_rounding), 0.0);
}

TEST(Flows, OfAPayloadByItsNorms) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall w = any_bound(random), v = any_bound(random);
        const Ball mass{any_size(random), 1e-4}, moment{any_size(random), 1e-3 * any_size(random)},
            inertia{any_size(random), 1e-3 * any_size(random)};
        const Number none = word_of({}, fine);
        const bounds::Body body{
            word_of(mass, fine), {none, none, none, moment}, {{none, none, none, none, none, none}, inertia}};
        const auto bound = mass_flow(FineLink{}, doubled_moments(FineLink{}, body), bounded(w), bounded(v));
        return climb(
            [&](Choice& c) {
              const Sample a = sample(w, c), b = sample(v, c);
              const Scalar m = sample(mass, c);
              const Vector h = vector_within(moment.size, moment.size, moment.size, c);
              const Vector h_off = plus(h, vector_within(moment.error, moment.error, moment.error, c));
              const Sym3<double> j = mirror(inertia.size, c), j_off = added(j, mirror(inertia.error, c));
              return nearness_of(
                  bound, mass_flow(Plain{}, doubled_moments(RigidInertia{m.exact, h, j}), a.exact, b.exact),
                  mass_flow(Plain{}, doubled_moments(RigidInertia{m.computed, h_off, j_off}), a.computed, b.computed),
                  c);
            },
            random());
      },
      0.5);
}
// Links of one mass: a constant of their table, beside moments that are words of it.
TEST(Flows, OfATableTakeTheErrorsOfItsWords) {
  static constexpr WordRounding tabled{32, true, false, 0.0, true};
  struct TabledLink : FineLink {
    const WordRounding& rounding() const { return tabled; }
  };
  const auto entry = [](double value) { return Number{{std::fabs(value), 1e-6}, value, fine, false}; };
  const bounds::Body body{literal_of(1.0),
                          {entry(0.1), entry(0.2), entry(-0.3), {}},
                          {{entry(2.0), entry(3.0), entry(4.0), entry(0.1), entry(0.2), entry(0.3)}, {}}};
  const auto moments = doubled_moments(TabledLink{}, body);
  EXPECT_DOUBLE_EQ(moments.mass.bound.size, 2.0);
  EXPECT_DOUBLE_EQ(moments.first.z.bound.size, 0.6);
  EXPECT_DOUBLE_EQ(moments.first.z.bound.error, 2e-6);
  EXPECT_DOUBLE_EQ(moments.second.of.xx.bound.size, 5.0);
  EXPECT_DOUBLE_EQ(moments.second.of.xx.bound.error, 3e-6);
  EXPECT_DOUBLE_EQ(moments.second.of.yz.bound.error, 2e-6);
}
TEST(Flows, ThroughTheJointsScrew) { expect_flows<ZAxis>(0.5); }
TEST(Flows, ThroughAnXScrew) { expect_flows<XAxis>(0.5); }
TEST(Flows, TakeAForceWhereTheirFrameTurns) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const FlowBound given = FlowBound::any(random);
        const SplitBall rate = axial::detail::split(any_bound(random).across, {});
        const auto bound = flow_force(given.bounded(), bounded(rate));
        return climb(
            [&](Choice& c) {
              const FlowSample s = given.sample(c);
              const Sample a = sample(rate, c);
              const auto exact = flow_force(s.exact, a.exact), computed = flow_force(s.computed, a.computed);
              return nearness_of(axial::detail::tightened(bound.moment.bound),
                                 axial::detail::tightened(bound.force.bound), exact.moment, computed.moment,
                                 exact.force, computed.force);
            },
            random());
      },
      0.5);
}
TEST(Flows, HaveAUnitForceAndARow) {
  for (const bool turns : {true, false})
    expect_bounds(
        [turns](std::mt19937_64& random) {
          const FlowBound given = FlowBound::any(random);
          const auto revolute = unit_flow_force(Revolute{}, given.bounded());
          const auto row = turns ? joint_row(Revolute{}, given.bounded()) : joint_row(Prismatic{}, given.bounded());
          return climb(
              [&](Choice& c) {
                const FlowSample s = given.sample(c);
                const auto exact = unit_flow_force(Revolute{}, s.exact),
                           computed = unit_flow_force(Revolute{}, s.computed);
                const Vector b = turns ? joint_row(Revolute{}, s.exact) : Vector(joint_row(Prismatic{}, s.exact));
                const Vector b_off =
                    turns ? joint_row(Revolute{}, s.computed) : Vector(joint_row(Prismatic{}, s.computed));
                const Nearness of_row = nearness(row.bound, b, b_off),
                               of_unit = nearness(revolute.moment.bound, exact.moment, computed.moment),
                               of_force = nearness(revolute.force.bound, exact.force, computed.force);
                return Nearness{
                    {of_row.of[2], of_row.of[5], of_unit.of[2], of_unit.of[5], of_force.of[2], of_force.of[5]}};
              },
              random());
        },
        0.5);
}
TEST(Flows, CompositeBodiesTakeTheForceOfAMotion) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall h = any_bound(random), angular = any_bound(random), linear = any_bound(random);
        const Ball inertia{any_size(random), 1e-3}, mass{any_size(random), 1e-4};
        const bounds::CompositeBody body{word_of(mass, fine), bounded(h), word_of(inertia, fine), inertia};
        const auto bound = inertial_force(body, bounds::BoundedMotion{bounded(angular), bounded(linear)});
        return climb(
            [&](Choice& c) {
              const Sample moment = sample(h, c), w = sample(angular, c), v = sample(linear, c);
              const Scalar m = sample(mass, c);
              const Sym3<double> j = symmetric(inertia.size, c), off = added(j, symmetric(inertia.error, c));
              const auto exact =
                  derivatives::inertial_force(RigidInertia{m.exact, moment.exact, j}, MotionVector{w.exact, v.exact});
              const auto computed = derivatives::inertial_force(RigidInertia{m.computed, moment.computed, off},
                                                                MotionVector{w.computed, v.computed});
              return nearness_of(axial::detail::tightened(bound.moment.bound),
                                 axial::detail::tightened(bound.force.bound), exact.moment, computed.moment,
                                 exact.force, computed.force);
            },
            random());
      },
      0.4);
}
// A matrix whose nine entries are each off by a step is off by three steps; where four are, by two.
TEST(Flows, RoundEveryEntry) {
  struct CoarseLink : FineLink {
    int exponent(quantity::FlowMoment) const { return 4; }
  };
  constexpr double step = 0x1p-5;  // half a unit
  const Number one = literal_of(1.0), none = literal_of(0.0);
  const SplitBall p = axial::detail::split({1.0, 0.0}, {1.0, 0.0});
  const BoundedVector momentum{p, 10, false, &exact_rounding};
  const bounds::BoundedFlow flow{{{1.0, 0.0}, 10, &exact_rounding}, momentum};
  const auto still = to_parent(z_screw(one, none, none), flow, CoarseLink{});
  EXPECT_GE(still.moment.bound.error, 3.0 * step);
  EXPECT_LE(still.moment.bound.error, 3.001 * step);
  const auto moved = to_parent(z_screw(one, none, word_of({1.0, 0.0}, 10)), flow, CoarseLink{});
  EXPECT_GE(moved.moment.bound.error, 5.0 * step);
  EXPECT_LE(moved.moment.bound.error, 5.1 * step);
  const DoubledMoments<Number, bounds::ConstantVector, bounds::ConstantInertia> body{
      one, {literal_of(0.3), none, none, {}}, {{literal_of(0.7), none, none, none, none, none}, {}}};
  EXPECT_GE(mass_flow(CoarseLink{}, body, momentum, momentum).moment.bound.error, 3.0 * step);
  // By 45 degrees: the couples with the axis and the plane are rounded where they were, besides.
  const Number half = word_of({0.7071067811865476, 0.0}, 8);
  const bounds::BoundedFlow coarse{{{1.0, 0.0}, 4, &exact_rounding}, momentum};
  const auto turned = to_parent(z_screw(half, half, none), coarse, CoarseLink{});
  EXPECT_GE(turned.moment.bound.error, 2.0 * 1.4142135 * step) << "two entries of the plane, two of a couple";
}
TEST(Axes, TakeAcrossAndDoubled) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall v = any_bound(random);
        const auto bound = bounds::doubled(bounds::across(bounded(v)));
        EXPECT_EQ(bound.exponent, fine - 1) << "twice the word is the word at one exponent less";
        return climb(
            [&](Choice& c) {
              const Sample s = sample(v, c);
              const Vector exact = derivatives::doubled(Vector(derivatives::across(s.exact)));
              const Vector computed = derivatives::doubled(Vector(derivatives::across(s.computed)));
              Nearness n = nearness(bound.bound, exact, computed);
              n.of[1] = n.of[4] = 1.0;  // nothing is along the axis
              return n;
            },
            random());
      },
      0.9);
}

// A slide behind an oblique twist: its mass times a direction is a constant of the model, which no turn rounds.
TEST(Turns, OfConstantsByConstantsRoundNothing) {
  const SplitBall v = axial::detail::split({0.0, 0.0}, {2.5, 0.0});
  const BoundedVector constant{v, 0, true, &exact_rounding};
  for (const auto& turned :
       {to_parent(x_screw(literal_of(0.6), literal_of(0.8), literal_of(0.0)), constant),
        to_parent(z_screw(literal_of(0.6), literal_of(0.8), literal_of(0.0)),
                  to_parent(x_screw(literal_of(0.6), literal_of(0.8), literal_of(0.0)), constant))}) {
    EXPECT_TRUE(turned.is_literal);
    EXPECT_EQ(turned.bound.whole.error, 0.0);
  }
}
// Links that turn about parallel axes: what is zero has no error, in whatever format.
TEST(Rotations, KeepAnAxisThatKeepsItsDirection) {
  struct CoarseLink : FineLink {
    int exponent(quantity::AngularAcceleration) const { return 4; }
  };
  const BoundedVector w{axial::detail::split({}, {3.0, 0.0}), 10, false, &exact_rounding};
  const BoundedVector dw{axial::detail::split({}, {5.0, 0.0}), 4, false, &exact_rounding};
  const auto u = rotation_acceleration(w, dw, products(w, CoarseLink{}), CoarseLink{});
  EXPECT_GT(u.entry, 0.0);
  EXPECT_EQ(bounds::third_column(u).bound.whole.error, 0.0);
}
