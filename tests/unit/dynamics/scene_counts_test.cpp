// What each feature of a scene costs, and that it costs nothing where it is not named or has nothing to do.
#include <gtest/gtest.h>

#include <axial/cost.hpp>
#include <cstdio>
#include <ostream>

#include "generic_robots.hpp"

using namespace axial;
using generic::Robot;

namespace axial {
static void PrintTo(const Operations& o, std::ostream* out) {
  *out << o.mul << "M " << o.add << "A " << o.div << "D " << o.sincos << "T";
}
}  // namespace axial

namespace {

constexpr int general = 37;

template <class S>
Operations torque() {
  return cost<S>(algorithm::inverse_dynamics);
}
template <class S>
Operations acceleration() {
  return cost<S>(algorithm::forward_dynamics);
}

/// Joint values of which the first is x.
template <class J, class T>
constexpr J first_of(const T& x) {
  J values{};
  values[0] = x;
  return values;
}

template <int I>
struct OneTorque {
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const In& in) {
    return first_of<J>(joint_torque<S, I>(q, qd, qdd, in));
  }
};
template <int I>
struct OneGravityTorque {
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J&, const J&, const In& in) {
    return first_of<J>(gravity_torque<S, I>(q, in));
  }
};

Operations operator-(const Operations& a, const Operations& b) {
  return {a.mul - b.mul, a.add - b.add, a.div - b.div, a.sincos - b.sincos};
}

// The same three links with drives that differ in one thing.
template <class Change>
constexpr Chain<3> with_drive(const Change& change) {
  Chain<3> chain = generic::chain<3>(general, false);
  change(chain.links[1]);
  return chain;
}
struct Viscous {
  static constexpr auto chain = with_drive([](auto& p) { p.viscous = 0.3; });
};
struct Coulomb {
  static constexpr auto chain = with_drive([](auto& p) { p.coulomb_forward = 0.3, p.coulomb_backward = -0.2; });
};
struct Stribeck {
  static constexpr auto chain = with_drive([](auto& p) {
    p.coulomb_forward = 0.3, p.coulomb_backward = -0.2, p.static_friction = 0.4, p.stribeck_speed = 0.05;
  });
};
struct Smooth {
  static constexpr auto chain =
      with_drive([](auto& p) { p.coulomb_forward = 0.3, p.coulomb_backward = -0.2, p.smooth_speed = 0.01; });
};
struct Sprung {
  static constexpr auto chain = with_drive([](auto& p) { p.spring_stiffness = 3.0, p.spring_rest = 0.2; });
};
template <int Joint>
struct Geared {
  static constexpr auto chain = [] {
    Chain<3> c = generic::chain<3>(general, false);
    c.links[Joint].rotor_inertia = 2e-4, c.links[Joint].gear = 50.0;
    return c;
  }();
};

// The general chain on a body of its own.
template <int N>
struct OnABody {
  static constexpr auto chain = [] {
    Chain<N> c = generic::chain<N>(general, false);
    c.base_body = generic::link(revolute(), N, true).parameters();
    c.has_base_body = true;
    return c;
  }();
};
// The general chain in water: every constant declared, or none.
template <int N, bool Declared>
struct InWater {
  static constexpr auto chain = [] {
    Chain<N> c = generic::chain<N>(general, false);
    for (int i = 0; Declared && i < N; ++i) {
      const double k = 1.0 + 0.01 * i;
      Link water = revolute().added_mass(0.51 * k, 1.52 * k, 2.53 * k, 0.14 * k, 0.25 * k, 0.36 * k);
      water = water.buoyancy(1.87 * k, 0.11 * k, 0.06 * k, 0.14 * k);
      water = water.drag_linear(2.1 * k, 3.2 * k, 1.3 * k, 0.24 * k, 0.35 * k, 0.16 * k);
      c.links[i].water =
          water.drag_quadratic(8.1 * k, 12.2 * k, 16.3 * k, 0.54 * k, 0.25 * k, 0.17 * k).parameters().water;
    }
    return c;
  }();
};
struct SolveOfTheBase {
  template <class S, class J, class In>
  static constexpr auto run(const J& a, const J& b, const J& c, const In&) {
    const auto sym = [](const J& j) { return Sym3<Counting>{j[0], j[1], j[2], j[3], j[4], j[5]}; };
    const Mat3<Vec3<Counting>> coupling{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}, {b[6], b[7], b[8]}};
    const ForceVector bias{Vec3{a[6], a[7], a[8]}, Vec3{c[6], c[7], c[8]}};
    const auto solved = free_motion<Counting>(Plain{}, ArticulatedInertia{sym(a), coupling, sym(c)}, bias,
                                              CompositeScale{Counting{}, Counting{}, Counting{}});
    const auto& [w, v] = solved.acceleration;
    return J{w.x, w.y, w.z, v.x, v.y, v.z, {}, {}, {}};
  }
};

template <class R, class... F>
Operations extra() {
  return torque<Scene<R, Gravity, F...>>() - torque<Scene<R, Gravity>>();
}

}  // namespace

TEST(SceneCounts, NamingWhatTheRobotDoesNotDeclareIsFree) {
  using R = Robot<3, general>;
  EXPECT_EQ((extra<R, Friction, JointSprings, RotorInertia>()), Operations{});
  EXPECT_EQ((acceleration<Scene<R, Gravity, Friction, JointSprings, RotorInertia>>()),
            (acceleration<Scene<R, Gravity>>()));
}

TEST(SceneCounts, DeclaringWhatTheSceneDoesNotNameIsFree) {
  const auto bare = torque<Scene<Robot<3, general>, Gravity>>();
  EXPECT_EQ((torque<Scene<Stribeck, Gravity>>()), bare);
  EXPECT_EQ((torque<Scene<Sprung, Gravity>>()), bare);
  EXPECT_EQ((torque<Scene<Geared<1>, Gravity>>()), bare);
}

TEST(SceneCounts, FrictionCostsWhatEachLinkDeclares) {
  EXPECT_EQ((extra<Viscous, Friction>()), (Operations{1, 1, 0, 0}));
  EXPECT_EQ((extra<Coulomb, Friction>()), (Operations{0, 1, 0, 0}));
  EXPECT_EQ((extra<Stribeck, Friction>()), (Operations{3, 3, 1, 0}));
  EXPECT_EQ((extra<Smooth, Friction>()), (Operations{5, 2, 0, 0}));
}

TEST(SceneCounts, ASpringCostsOneMultiplication) {
  EXPECT_EQ((extra<Sprung, JointSprings>()), (Operations{1, 2, 0, 0}));
}

TEST(SceneCounts, ForwardDynamicsPaysTheSameForItsDrives) {
  const auto bare = acceleration<Scene<Stribeck, Gravity>>();
  EXPECT_EQ((acceleration<Scene<Stribeck, Gravity, Friction>>() - bare), (Operations{3, 3, 1, 0}));
  EXPECT_EQ((acceleration<Scene<Sprung, Gravity, JointSprings>>() - bare), (Operations{1, 2, 0, 0}));
}

// On the first turning joint a rotor is part of the link's own inertia; further out it is not.
TEST(SceneCounts, TheFirstRotorIsFoldedIntoItsLink) {
  EXPECT_EQ((extra<Geared<0>, RotorInertia>()), Operations{});
  EXPECT_EQ((extra<Geared<1>, RotorInertia>()), (Operations{1, 1, 0, 0}));
  EXPECT_EQ((extra<Geared<0>, RotorInertia, FullParameters>() - extra<Geared<0>, FullParameters>()),
            (Operations{1, 1, 0, 0}));
}

TEST(SceneCounts, SineCosinesAreHandedIn) {
  using R = Robot<6, general>;
  const auto own = torque<Scene<R, Gravity>>(), handed = torque<Scene<R, Gravity, SineCosines>>();
  EXPECT_EQ(own - handed, (Operations{0, 0, 0, 5}));
  EXPECT_EQ((acceleration<Scene<R, Gravity, SineCosines>>().sincos), 0);
}

TEST(SceneCounts, AVectorKnownAtRunTimeCostsMoreThanADeclaredOne) {
  using R = Robot<3, general>;
  const auto none = torque<Scene<R>>(), declared = torque<Scene<R, Gravity>>(),
             given = torque<Scene<R, RuntimeGravity>>(), moving = torque<Scene<R, RuntimeGravity, BaseMotion>>();
  EXPECT_LT(none.mul + none.add, declared.mul + declared.add);
  EXPECT_LT(declared.mul + declared.add, given.mul + given.add);
  EXPECT_LT(given.mul + given.add, moving.mul + moving.add);
}

// The first link's forces off its axis, which no joint feels, are not carried on.
TEST(SceneCounts, WrenchesAreAddedWhereTheyAreFelt) {
  using R = Robot<3, general>;
  EXPECT_EQ((extra<R, ExternalWrenches>()), (Operations{0, 13, 0, 0}));
}

// The last joint needs the motion of all links but the force of one, the first joint all but its own.
TEST(SceneCounts, OneJointsTorqueCostsNothingOfTheOthers) {
  using R = Robot<6, general>;
  const auto whole = torque<R>(), last = cost<R>(OneTorque<5>{}), first = cost<R>(OneTorque<0>{});
  EXPECT_LT(2 * (last.mul + last.add), whole.mul + whole.add);
  EXPECT_LE(first.mul + first.add, whole.mul + whole.add);
  const auto all_gravity = cost<R>(algorithm::gravity), tip = cost<R>(OneGravityTorque<5>{});
  EXPECT_LT(tip.mul + tip.add, all_gravity.mul + all_gravity.add);
}

TEST(SceneCounts, TheSolveOfAFreeBase) {
  const auto solve = cost<Robot<9, 0>>(SolveOfTheBase{});
  std::printf("6x6 solve: %d M, %d A, %d D\n", solve.mul, solve.add, solve.div);
  EXPECT_EQ(solve, (Operations{86, 65, 6, 0}));
}

// Above a base that moves as it is told: the first link's congruence and inertia, the body's own bias, the solve.
TEST(SceneCounts, AFreeBaseCostsTheSameWhateverItCarries) {
  const auto extra_of = [](auto robot) {
    using R = decltype(robot);
    return acceleration<Scene<R, axial::FloatingBase>>() - acceleration<Scene<R, axial::BaseMotion, ArticulatedBody>>();
  };
  const auto three = extra_of(OnABody<3>{}), six = extra_of(OnABody<6>{});
  std::printf("free base: %d M, %d A, %d D more than a given one\n", six.mul, six.add, six.div);
  EXPECT_EQ(three, six);
  EXPECT_EQ(six, (Operations{212, 208, 6, 0}));
}

TEST(SceneCounts, ABodyThatTheSceneDoesNotFloatIsFree) {
  EXPECT_EQ((acceleration<OnABody<3>>()), (acceleration<Robot<3, general>>()));
  EXPECT_EQ((torque<OnABody<3>>()), (torque<Robot<3, general>>()));
}

TEST(SceneCounts, WaterCostsWhatTheLinksDeclare) {
  using None = InWater<3, false>;
  EXPECT_EQ((torque<Scene<None, axial::Underwater>>()), (torque<Scene<None>>()));
  EXPECT_EQ((acceleration<Scene<None, axial::Underwater, ArticulatedBody>>()),
            (acceleration<Scene<None, ArticulatedBody>>()));
  EXPECT_EQ((torque<InWater<3, true>>()), (torque<None>())) << "unnamed, it is nothing";
  const auto per_link = [](auto more, auto less, auto count) {
    return count(more, Scene<decltype(more), axial::Gravity, axial::Underwater, ArticulatedBody>{}) -
           count(less, Scene<decltype(less), axial::Gravity, axial::Underwater, ArticulatedBody>{}) -
           (count(more, Scene<decltype(more), axial::Gravity, ArticulatedBody>{}) -
            count(less, Scene<decltype(less), axial::Gravity, ArticulatedBody>{}));
  };
  const auto id =
      per_link(InWater<6, true>{}, InWater<5, true>{}, [](auto, auto scene) { return torque<decltype(scene)>(); });
  const auto fd = per_link(InWater<6, true>{}, InWater<5, true>{},
                           [](auto, auto scene) { return acceleration<decltype(scene)>(); });
  std::printf("a link's water: %d M %d A of the torque, %d M %d A of the acceleration\n", id.mul, id.add, fd.mul,
              fd.add);
  EXPECT_EQ(id, (Operations{89, 72, 0, 0}));
  EXPECT_EQ(fd, (Operations{86, 66, 0, 0}));
}
