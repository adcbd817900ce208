// Each operator on bounds against the kernels' own operators on numbers: no input exceeds a size or an error, and a
// search comes near both. Rounding is left out here (units of 2^-900); terms_test.cpp has it.
#include "fine_link.hpp"

namespace {

using namespace axial;
using namespace bounds_test;
using bounds::literal_of;
using bounds::Number;
using bounds::word_of;

// A body's rotation: w and dw with their errors, and its U with the rounding of entries and, it may be, a third column
// of its own.
struct Rotation {
  SplitBall w, dw;
  double entry = 0.0;
  SplitBall axis_error;
  bool apart = false;

  static Rotation any(std::mt19937_64& random) {
    Rotation r{
        any_bound(random), any_bound(random), random() % 2 == 0 ? 0.0 : 1e-3 * any_size(random), {}, random() % 2 == 0};
    if (r.apart) r.axis_error = any_bound(random);
    return r;
  }
  bounds::Spin spin() const {
    const FineLink link;
    const auto p = products(bounded(w), link);
    auto u = rotation_acceleration(bounded(w), bounded(dw), p, link);
    if (apart) {
      SplitBall axis = u.axis;
      u = rotation_acceleration(bounded(w), bounded(dw), p, bounded(bounds::detail::with_errors_of(axis, axis_error)),
                                link);
    } else {
      u.axis = rounded(u.axis, entry);
    }
    u.entry = entry;
    return u;
  }
};
struct RotationSample {
  Vector w, dw, w_off, dw_off, p, p_off;
  Mat3<Vector> u, u_off;
};
Vector shaken(const Vector& v, double step, Choice& c) {
  return plus(v, {step * c.next(), step * c.next(), step * c.next()});
}
RotationSample rotation_sample(const Rotation& r, Choice& c) {
  const Sample w = sample(r.w, c), dw = sample(r.dw, c);
  RotationSample s{w.exact, dw.exact, w.computed, dw.computed, {}, {}, {}, {}};
  s.p = products(s.w, Plain{}), s.p_off = shaken(products(s.w_off, Plain{}), r.entry, c);
  s.u = rotation_acceleration(s.w, s.dw, s.p, Plain{});
  const Vector p = products(s.w_off, Plain{});
  Mat3<Vector> u = rotation_acceleration(s.w_off, s.dw_off, p, Plain{});
  s.u_off = {shaken(u.x, r.entry, c), shaken(u.y, r.entry, c), shaken(u.z, r.entry, c)};
  if (r.apart) {
    const SplitBall& e = r.axis_error;
    const Vector off = vector_within(e.across.error, e.along.error, e.whole.error, c);
    s.u_off.x.z = s.u.x.z + off.x, s.u_off.y.z = s.u.y.z + off.y, s.u_off.z.z = s.u.z.z + off.z;
  }
  return s;
}

}  // namespace

TEST(Turns, AboutTheJointKeepAcrossAlongAndWhole) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall v = any_bound(random);
        const double error = random() % 2 == 0 ? 0.0 : 1e-3;
        const Number entry = word_of({1.0, error}, fine);
        const auto bound = to_child(z_screw(entry, entry, literal_of(0.0)), bounded(v)).bound;
        return climb(
            [&](Choice& c) {
              const Sample s = sample(v, c);
              const double q = M_PI * c.next(), cos = std::cos(q), sin = std::sin(q);
              const double c_off = cos + error * c.next(), s_off = sin + error * c.next();
              return nearness(bound, to_child(z_screw(cos, sin, 0.0), s.exact),
                              to_child(z_screw(c_off, s_off, 0.0), s.computed));
            },
            random());
      },
      0.9);
}
TEST(Turns, AboutXExchangeAcrossAndAlong) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall v = any_bound(random);
        const double alpha = 3.0 * any_size(random), cos = std::cos(alpha), sin = std::sin(alpha);
        const auto screw = x_screw(literal_of(cos), literal_of(sin), literal_of(0.0));
        const SplitBall down = to_child(screw, bounded(v)).bound;
        return climb(
            [&](Choice& c) {
              const Sample s = sample(v, c);
              return nearness(down, to_child(x_screw(cos, sin, 0.0), s.exact),
                              to_child(x_screw(cos, sin, 0.0), s.computed));
            },
            random());
      },
      0.9);
}
TEST(Products, OfAShiftAndAForceOnBothAxes) {
  for (const bool about_z : {true, false})
    expect_bounds(
        [about_z](std::mt19937_64& random) {
          const SplitBall f = any_bound(random);
          const Ball shift{any_size(random), random() % 2 == 0 ? 0.0 : 1e-3};
          const Number l = word_of(shift, fine), one = literal_of(1.0), none = literal_of(0.0);
          const SplitBall bound = about_z ? cross_shift(z_screw(one, none, l), bounded(f)).bound
                                          : cross_shift(x_screw(one, none, l), bounded(f)).bound;
          return climb(
              [&](Choice& c) {
                const Sample s = sample(f, c);
                const Scalar d = sample(shift, c);
                if (about_z)
                  return nearness(bound, cross_shift(z_screw(1.0, 0.0, d.exact), s.exact),
                                  cross_shift(z_screw(1.0, 0.0, d.computed), s.computed));
                return nearness(bound, cross_shift(x_screw(1.0, 0.0, d.exact), s.exact),
                                cross_shift(x_screw(1.0, 0.0, d.computed), s.computed));
              },
              random());
        },
        about_z ? 0.0 : 0.9);
}
TEST(Products, OfANumberAndAVector) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall v = any_bound(random);
        const Ball factor{any_size(random), 1e-3};
        const SplitBall bound = (word_of(factor, fine) * bounded(v)).bound;
        return climb(
            [&](Choice& c) {
              const Sample s = sample(v, c);
              const Scalar k = sample(factor, c);
              return nearness(bound, k.exact * s.exact, k.computed * s.computed);
            },
            random());
      },
      0.9);
}
TEST(Products, WithTheJointsRate) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall v = any_bound(random);
        const Ball rate{any_size(random), 1e-3};
        const SplitBall bound = cross_z(bounded(v), word_of(rate, fine)).bound;
        return climb(
            [&](Choice& c) {
              const Sample s = sample(v, c);
              const Scalar k = sample(rate, c);
              return nearness(bound, cross_z(s.exact, k.exact), cross_z(s.computed, k.computed));
            },
            random());
      },
      0.0);
}
TEST(Products, OfTwoVectorsAlongTheJoint) {
  std::mt19937_64 random(11);
  double nearest = 0.0;
  for (int shape = 0; shape < 60; ++shape) {
    const SplitBall u = any_bound(random), v = any_bound(random);
    const Ball bound = axial_product(bounded(u), bounded(v)).bound;
    const Nearness seen = climb(
        [&](Choice& c) {
          const Sample a = sample(u, c), b = sample(v, c);
          const double exact = momentum::axial_product(a.exact, b.exact);
          const double off = momentum::axial_product(a.computed, b.computed) - exact;
          return Nearness{{ratio(std::fabs(exact), bound.size), ratio(std::fabs(off), bound.error)}};
        },
        random());
    EXPECT_LE(seen.of[0], 1.0 + 1e-6);
    EXPECT_LE(seen.of[1], 1.0 + 1e-6);
    nearest = std::fmax(nearest, std::fmin(seen.of[0], seen.of[1]));
  }
  EXPECT_GT(nearest, 0.9);
}
TEST(Products, OfAFirstMomentAndAnAcceleration) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall a = any_bound(random), h = any_bound(random);
        const Ball loose{random() % 2 == 0 ? 0.0 : any_size(random), random() % 2 == 0 ? 0.0 : 1e-3};
        const bounds::ConstantVector moment{literal_of(h.across.size), literal_of(0.0), literal_of(h.along.size),
                                            loose};
        const SplitBall bound = cross(moment, bounded(a)).bound;
        return climb(
            [&](Choice& c) {
              const Sample s = sample(a, c);
              const Vector known{h.across.size, 0.0, h.along.size};
              const Vector more = vector_within(loose.size, loose.size, loose.size, c);
              const Vector off = vector_within(loose.error, loose.error, loose.error, c);
              const Vector exact = plus(known, more);
              return nearness(bound, cross(exact, s.exact), cross(plus(exact, off), s.computed));
            },
            random());
      },
      0.6);
}
TEST(Rotations, MovePointsOfABody) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const Rotation r = Rotation::any(random);
        const SplitBall h = any_bound(random);
        const Ball loose{random() % 2 == 0 ? 0.0 : any_size(random), random() % 2 == 0 ? 0.0 : 1e-3};
        const bounds::ConstantVector moment{literal_of(h.across.size), literal_of(0.0), literal_of(h.along.size),
                                            loose};
        const SplitBall bound = (r.spin() * moment).bound;
        return climb(
            [&](Choice& c) {
              const RotationSample s = rotation_sample(r, c);
              const Vector known{h.across.size, 0.0, h.along.size};
              const Vector exact = plus(known, vector_within(loose.size, loose.size, loose.size, c));
              const Vector off = plus(exact, vector_within(loose.error, loose.error, loose.error, c));
              return nearness(bound, s.u * exact, s.u_off * off);
            },
            random());
      },
      0.6, 120);
}
TEST(Rotations, TurnTheAxisOfAJoint) {
  for (const bool parallel : {true, false})
    expect_bounds(
        [parallel](std::mt19937_64& random) {
          const Rotation r = Rotation::any(random);
          const SplitBall bound = (r.spin() * bounds::AxisInParent{true, parallel}).bound;
          return climb(
              [&](Choice& c) {
                const RotationSample s = rotation_sample(r, c);
                const Vector axis = parallel ? Vector{0.0, 0.0, 1.0} : Vector{0.6, 0.8, 0.0};
                return nearness(bound, s.u * axis, s.u_off * axis);
              },
              random());
        },
        parallel ? 0.6 : 0.3, 120);
}
TEST(Rotations, AnyEntryIsBelowTheirStrength) {
  std::mt19937_64 random(5);
  for (int shape = 0; shape < 100; ++shape) {
    const Rotation r = Rotation::any(random);
    const Ball bound = r.spin().strength();
    const Nearness seen = climb(
        [&](Choice& c) {
          const RotationSample s = rotation_sample(r, c);
          const Vector any = vector_within(1.0, 1.0, 1.0, c);
          return Nearness{
              {ratio(whole(s.u * any), bound.size), ratio(whole(minus(s.u_off * any, s.u * any)), bound.error)}};
        },
        random(), 300, 60);
    EXPECT_LE(seen.of[0], 1.0 + 1e-6) << shape;
    EXPECT_LE(seen.of[1], 1.0 + 1e-6) << shape;
  }
}
TEST(Rotations, GiveABodyItsMoment) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const Rotation r = Rotation::any(random);
        const auto entry = [&random] {
          return random() % 3 == 0 ? 0.0 : any_size(random) * (random() % 2 == 0 ? 1.0 : -1.0);
        };
        const Sym3<double> j{entry(), entry(), entry(), entry(), entry(), entry()};
        const Ball loose{random() % 2 == 0 ? 0.0 : any_size(random), random() % 2 == 0 ? 0.0 : 1e-3};
        const bounds::ConstantInertia inertia{{literal_of(j.xx), literal_of(j.yy), literal_of(j.zz), literal_of(j.xy),
                                               literal_of(j.xz), literal_of(j.yz)},
                                              loose};
        const Vec3<Number> d{literal_of(j.zz - j.yy), literal_of(j.xx - j.zz), literal_of(j.yy - j.xx)};
        const auto spin = r.spin();
        const auto w = bounded(r.w), dw = bounded(r.dw);
        const SplitBall bound = rotational_moment(inertia, d, dw, products(w, FineLink{}), spin).bound;
        const auto moment = [](const Sym3<double>& of, const Vector& rate, const Vector& p, const Mat3<Vector>& u) {
          return rotational_moment(of, Vec3{of.zz - of.yy, of.xx - of.zz, of.yy - of.xx}, rate, p, u);
        };
        return climb(
            [&](Choice& c) {
              const RotationSample s = rotation_sample(r, c);
              const double more = loose.size * c.next(), off = loose.error * c.next();
              const Sym3<double> exact{j.xx + more, j.yy + more, j.zz - more, j.xy, j.xz, j.yz};
              const Sym3<double> computed{exact.xx + off, exact.yy - off, exact.zz + off, j.xy, j.xz, j.yz};
              return nearness(bound, moment(exact, s.dw, s.p, s.u), moment(computed, s.dw_off, s.p_off, s.u_off));
            },
            random());
      },
      0.4, 120);
}
TEST(Rotations, FollowFromTheAxis) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall w = any_bound(random), axis = any_bound(random);
        const Ball along{any_size(random), 1e-3}, qdd{any_size(random), 1e-3};
        const double step = 1e-3 * any_size(random);
        bounds::Products p = products(bounded(w), FineLink{});
        p.rounding = step;
        const SplitBall bound =
            angular_acceleration(FineLink{}, p, bounded(axis), word_of(along, fine), word_of(qdd, fine)).bound;
        return climb(
            [&](Choice& c) {
              const Sample s = sample(w, c), a = sample(axis, c);
              const Scalar z = sample(along, c), joint = sample(qdd, c);
              const Vector p_exact = products(s.exact, Plain{}), p_off = shaken(products(s.computed, Plain{}), step, c);
              return nearness(bound, angular_acceleration(Plain{}, p_exact, a.exact, z.exact, joint.exact),
                              angular_acceleration(Plain{}, p_off, a.computed, z.computed, joint.computed));
            },
            random());
      },
      0.6);
}

namespace {

template <class Axis>
void expect_composites(double near) {
  expect_bounds(
      [](std::mt19937_64& random) {
        const SplitBall h = any_bound(random);
        const Ball inertia{any_size(random), random() % 2 == 0 ? 0.0 : 1e-3},
            shift{any_size(random), random() % 2 == 0 ? 0.0 : 1e-3};
        const double mass = any_size(random), error = random() % 2 == 0 ? 0.0 : 1e-4;
        const Number turn = word_of({1.0, error}, fine);
        const AxialScrew<Axis, Number, Number, Number> screw{turn, turn, word_of(shift, fine)};
        const bounds::CompositeBody body{literal_of(mass), bounded(h), word_of(inertia, fine), inertia};
        const auto bound = to_parent(screw, body, FineLink{});
        return climb(
            [&](Choice& c) {
              const Sample moment = sample(h, c);
              const Scalar p = sample(shift, c);
              const double q = M_PI * c.next(), cos = std::cos(q), sin = std::sin(q);
              const double c_off = cos + error * c.next(), s_off = sin + error * c.next();
              const Sym3<double> j = symmetric(inertia.size, c), off = added(j, symmetric(inertia.error, c));
              const auto exact = to_parent(AxialScrew<Axis, double, double, double>{cos, sin, p.exact},
                                           RigidInertia{mass, moment.exact, j});
              const auto computed = to_parent(AxialScrew<Axis, double, double, double>{c_off, s_off, p.computed},
                                              RigidInertia{mass, moment.computed, off});
              Nearness seen = nearness(bound.first_moment.bound, exact.first_moment, computed.first_moment);
              seen.of[0] = ratio(norm(exact.inertia), bound.inertia.bound.size);
              seen.of[3] = ratio(norm(added(computed.inertia, exact.inertia, -1.0)), bound.inertia.bound.error);
              seen.of[1] = std::fmax(seen.of[1], ratio(std::fabs(exact.inertia.zz), bound.axis.size));
              seen.of[4] =
                  std::fmax(seen.of[4], ratio(std::fabs(computed.inertia.zz - exact.inertia.zz), bound.axis.error));
              return seen;
            },
            random());
      },
      near, 120);
}

}  // namespace

TEST(Composites, BehindTheJointsScrew) { expect_composites<ZAxis>(0.3); }
TEST(Composites, BehindTheScrewAboutX) { expect_composites<XAxis>(0.3); }
