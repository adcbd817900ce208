// The shape of the number systems: whole steps of RNEA and ABA over a fixed-point type whose quantities have unequal
// exponents. The kernels are the ones that float runs; only the link view differs.
#include <gtest/gtest.h>
#include <axial/axial.hpp>

#include "../scalar/prototype_fixed.hpp"

namespace {

using namespace axial;
using prototype::Acc;
using prototype::from;
using prototype::Fx;
using prototype::Unit;

// One exponent a quantity.
constexpr int exponent(quantity::AngularVelocity) { return -27; }
constexpr int exponent(quantity::AngularAcceleration) { return -23; }
constexpr int exponent(quantity::LinearAcceleration) { return -24; }
constexpr int exponent(quantity::Moment) { return -22; }
constexpr int exponent(quantity::Force) { return -21; }
constexpr int exponent(quantity::RotationalInertia) { return -29; }
constexpr int exponent(quantity::FirstMoment) { return -28; }
constexpr int exponent(quantity::Mass) { return -27; }
constexpr int exponent(quantity::JointInertia) { return -29; }
constexpr int exponent(quantity::AngularGain) { return -25; }
constexpr int exponent(quantity::LinearGain) { return -25; }
constexpr int exponent(quantity::JointEffort) { return -22; }
constexpr int exponent(quantity::JointAcceleration) { return -20; }
constexpr int length_exponent = -30;

// sum<Q>(terms...): every term into 12 bits below the result's format, one rounding at the end.
struct FixedRounding {
  template <int E, int F>
  static constexpr std::int64_t align(Fx<F> x) {
    return prototype::shifted(x.raw, E - F);
  }
  template <int E, int F>
  static constexpr std::int64_t align(Acc<F> x) {
    return prototype::shifted(x.raw, E - F);
  }
  template <int E>
  static constexpr std::int64_t align(Zero) {
    return 0;
  }

  template <class Q, class... X>
  static constexpr auto sum(Q quantity, const X&... terms) {
    if constexpr ((is_scalar_v<X> && ...)) {
      return round<exponent(Q{})>(terms...);
    } else {
      return Vec3{sum(quantity, terms.x...), sum(quantity, terms.y...), sum(quantity, terms.z...)};
    }
  }
  template <int E, class... X>
  static constexpr auto round(const X&... terms) {
    if constexpr ((is_zero_v<X> && ...))
      return Zero{};
    else
      return Fx<E>{static_cast<std::int32_t>(prototype::shifted((align<E - 12>(terms) + ...), 12))};
  }
};

// The same general link over doubles and over fixed point.
template <class Numbers>
struct TestLink : Numbers::Rounding {
  static constexpr bool unrolled = true;
  using N = Numbers;
  auto x() const { return x_screw(N::unit(std::cos(0.7)), N::unit(std::sin(0.7)), N::length(0.35)); }
  static auto body() {
    return RigidInertia{N::mass(2.5), Vec3{N::moment(0.2), N::moment(-0.1), N::moment(0.15)},
                        Sym3{N::inertia(0.11), N::inertia(0.13), N::inertia(0.09), N::inertia(0.01), N::inertia(-0.02),
                             N::inertia(0.005)}};
  }
  static auto differences() { return Vec3{N::inertia(0.09 - 0.13), N::inertia(0.11 - 0.09), N::inertia(0.13 - 0.11)}; }
  static Zero rotor() { return {}; }
};

struct Doubles {
  using Rounding = Plain;
  static double unit(double v) { return v; }
  static double length(double v) { return v; }
  static double mass(double v) { return v; }
  static double moment(double v) { return v; }
  static double inertia(double v) { return v; }
  static double speed(double v) { return v; }
  static double spin(double v) { return v; }
  static double acceleration(double v) { return v; }
  static double effort(double v) { return v; }
  static double couple(double v) { return v; }
  static double force(double v) { return v; }
};
struct Fixeds {
  using Rounding = FixedRounding;
  static auto unit(double v) { return from<-30>(v); }
  static auto length(double v) { return from<length_exponent>(v); }
  static auto mass(double v) { return from<exponent(quantity::Mass{})>(v); }
  static auto moment(double v) { return from<exponent(quantity::FirstMoment{})>(v); }
  static auto inertia(double v) { return from<exponent(quantity::RotationalInertia{})>(v); }
  static auto speed(double v) { return from<exponent(quantity::AngularVelocity{})>(v); }
  static auto spin(double v) { return from<exponent(quantity::AngularAcceleration{})>(v); }
  static auto acceleration(double v) { return from<exponent(quantity::LinearAcceleration{})>(v); }
  static auto effort(double v) { return from<exponent(quantity::JointEffort{})>(v); }
  static auto couple(double v) { return from<exponent(quantity::Moment{})>(v); }
  static auto force(double v) { return from<exponent(quantity::Force{})>(v); }
};

template <class N>
auto parent_motion() {
  const TestLink<N> link;
  const Vec3 w{N::speed(0.8), N::speed(-1.1), N::speed(0.6)};
  const Vec3 dw{N::spin(2.0), N::spin(-3.0), N::spin(1.5)};
  const auto p = products(w, link);
  return rnea::Motion{w, dw, Vec3{N::acceleration(1.0), N::acceleration(2.0), N::acceleration(9.5)}, p,
                      rotation_acceleration(w, dw, p, link)};
}

// One whole RNEA step: motion, Newton-Euler, and the force at the parent (p x f included).
template <class N, class Joint>
auto rnea_step(Joint joint) {
  const TestLink<N> link;
  const auto screw = z_screw(N::unit(std::cos(-0.4)), N::unit(std::sin(-0.4)), N::length(0.25));
  const auto motion = [&] {
    if constexpr (std::is_same_v<Joint, Revolute>)
      return rnea::move(joint, link, screw, parent_motion<N>(), N::speed(1.2), N::spin(-2.5));
    else
      return rnea::move(joint, link, screw, parent_motion<N>(), N::speed(1.2), N::acceleration(-2.5));
  }();
  const auto force = rnea::newton_euler(link, link.body(), link.differences(), motion);
  return to_parent(link.x(), to_parent(screw, force, link), link);
}

// The reflection with its reciprocal, and the congruence of what it yields.
template <class N, class Joint>
auto aba_step(Joint joint) {
  const TestLink<N> link;
  const auto screw = z_screw(N::unit(std::cos(-0.4)), N::unit(std::sin(-0.4)), N::length(0.25));
  const auto inertia = articulated(link.body());
  const ForceVector bias{Vec3{N::couple(1.0), N::couple(-2.0), N::couple(0.5)},
                         Vec3{N::force(3.0), N::force(1.0), N::force(-4.0)}};
  const MotionVector zeta{Vec3{N::spin(0.5), N::spin(-0.7), Zero{}},
                          Vec3{N::acceleration(0.3), N::acceleration(1.1), N::acceleration(-0.2)}};
  const auto r = reflection(joint, link, inertia, bias, zeta, N::effort(6.0), N::mass(3.0));
  const auto n = to_parent(link.x(), to_parent(screw, r.inertia, link), link);
  return std::make_tuple(n, to_parent(link.x(), to_parent(screw, r.bias, link), link), r.free);
}

double value(double x) { return x; }
template <int E>
double value(Fx<E> x) {
  return x.value();
}

// Every stored quantity is rounded to 2^-20 of its unit or finer; a handful of roundings meet in a result.
constexpr double tolerance = 3e-5;

template <class A, class B>
void expect_near(const A& fixed, const B& reference) {
  EXPECT_NEAR(value(fixed), value(reference), tolerance);
}
template <class A, class B, class C, class D, class E, class F>
void expect_near(const Vec3<A, B, C>& u, const Vec3<D, E, F>& v) {
  expect_near(u.x, v.x), expect_near(u.y, v.y), expect_near(u.z, v.z);
}
template <class A, class B, class C, class D>
void expect_near(const ForceVector<A, B>& u, const ForceVector<C, D>& v) {
  expect_near(u.moment, v.moment), expect_near(u.force, v.force);
}
template <class I, class J>
void expect_inertia_near(const I& a, const J& b) {
  for (auto pair : {std::make_pair(&a.angular, &b.angular)}) {
    expect_near(Vec3{pair.first->xx, pair.first->yy, pair.first->zz},
                Vec3{pair.second->xx, pair.second->yy, pair.second->zz});
    expect_near(Vec3{pair.first->xy, pair.first->xz, pair.first->yz},
                Vec3{pair.second->xy, pair.second->xz, pair.second->yz});
  }
  expect_near(a.coupling.x, b.coupling.x), expect_near(a.coupling.y, b.coupling.y),
      expect_near(a.coupling.z, b.coupling.z);
  expect_near(Vec3{a.linear.xx, a.linear.yy, a.linear.zz}, Vec3{b.linear.xx, b.linear.yy, b.linear.zz});
  expect_near(Vec3{a.linear.xy, a.linear.xz, a.linear.yz}, Vec3{b.linear.xy, b.linear.xz, b.linear.yz});
}

template <class Joint>
void expect_aba_step_agrees(Joint joint) {
  const auto [inertia, bias, free] = aba_step<Fixeds>(joint);
  const auto [inertia_reference, bias_reference, free_reference] = aba_step<Doubles>(joint);
  expect_inertia_near(inertia, inertia_reference);
  expect_near(bias, bias_reference);
  EXPECT_NEAR(value(free), value(free_reference), 1e-3);  // 1/D has 20 bits and is about 11
}

}  // namespace

namespace prototype {
// D is bounded from below by the link's own inertia: a proved range has no singular joint.
template <int E, class Scale>
auto resistance(const Fx<E>& d, const Scale&) {
  struct {
    Fx<-20> inverse;
    bool singular = false;
  } result{reciprocal(d)};
  return result;
}
}  // namespace prototype

TEST(NumberSystem, FixedPointRunsTheRneaStepOfARevoluteLink) {
  expect_near(rnea_step<Fixeds>(Revolute{}), rnea_step<Doubles>(Revolute{}));
}

TEST(NumberSystem, FixedPointRunsTheRneaStepOfAPrismaticLink) {
  expect_near(rnea_step<Fixeds>(Prismatic{}), rnea_step<Doubles>(Prismatic{}));
}

TEST(NumberSystem, FixedPointRunsTheReflectionOfARevoluteJoint) { expect_aba_step_agrees(Revolute{}); }

TEST(NumberSystem, FixedPointRunsTheReflectionOfAPrismaticJoint) { expect_aba_step_agrees(Prismatic{}); }

TEST(NumberSystem, FixedPointResultsAreNotZero) {  // the comparisons above would accept zeros where all is small
  EXPECT_GT(std::abs(value(rnea_step<Fixeds>(Revolute{}).moment.z)), 0.1);
  EXPECT_GT(std::abs(value(std::get<2>(aba_step<Fixeds>(Revolute{})))), 1.0);
}
