// Where forward dynamics is left to choose its form, it is at most sixteen times less exact than ABA, or within 1e-6 of
// the largest acceleration: over the families of arm_families.hpp, by the rule that the compiler applies to a robot's
// type (elimination_loss.hpp), applied here to run-time models, so that hundreds of arms need no compiler each.
#include <gtest/gtest.h>
#include <cstdio>
#include <cstdlib>
#include <oracle/as_float.hpp>
#include "arm_families.hpp"

using namespace axial;

namespace {

constexpr int most_joints = 12;
using ByBodies = Model<most_joints, Gravity, RotorInertia, ArticulatedBody>;
using ByElimination = Model<most_joints, Gravity, RotorInertia, CompositeBody>;

template <class M>
M model_of(const property::Description& arm) {
  M model;
  for (const auto& link : arm.links)
    EXPECT_TRUE(model.add(link));
  model.set_gravity(arm.gravity[0], arm.gravity[1], arm.gravity[2]);
  return model;
}
std::vector<LinkParameters> parameters(const property::Description& arm) {
  std::vector<LinkParameters> result;
  for (const auto& link : arm.links)
    result.push_back(link.parameters());
  return result;
}

// The compiler's rule: elimination_loss<Scene>() of a robot with these links.
double loss(const property::Description& arm) {
  const auto model = model_of<ByBodies>(arm);
  const auto links = parameters(arm);
  const int n = static_cast<int>(links.size());
  double worst = 0.0;
  for (int sample = 0; sample < detail::loss_samples; ++sample) {
    Joints<ByBodies, float> q{};
    Joints<ByBodies, double> exact{};
    for (int i = 0; i < n; ++i)
      exact[i] = q[i] = static_cast<float>(detail::sampled_position(links.data(), n, sample, i));
    worst =
        std::max(worst, detail::elimination_error<most_joints>(mass_matrix(model, exact), mass_matrix(model, q), n));
  }
  return worst;
}

struct Errors {
  double bodies = 0.0, elimination = 0.0;  // relative to the largest acceleration, worst of all states
  int refused = 0;                         // states in which the elimination says that it is not exact
};

// States of one kind: at rest or moving, anywhere or stretched, under efforts of one size or such that accelerate
// alike.
Errors errors(const property::Description& arm, property::Arms& random, int kind, int states) {
  const auto bodies = model_of<ByBodies>(arm);
  const auto elimination = model_of<ByElimination>(arm);
  const auto links = parameters(arm);
  const int n = static_cast<int>(links.size());
  const double speed = kind % 2 == 1 ? 2.0 : 0.0, range = kind / 2 % 2 == 1 ? 0.3 : 3.14;
  Errors worst;
  for (int s = 0; s < states; ++s) {
    Joints<ByBodies, double> q{}, qd{}, tau{};
    for (int i = 0; i < n; ++i) {
      q[i] = links[std::size_t(i)].type == JointType::prismatic ? random.uniform(-0.5, 0.5)
                                                                : random.uniform(-range, range);
      qd[i] = random.uniform(-speed, speed), tau[i] = random.uniform(-10.0, 10.0);
    }
    if (kind >= 4) {
      tau = inverse_dynamics(bodies, q, qd, tau);
      for (int i = 0; i < n; ++i)
        tau[i] = oracle::as_float(tau[i]);
    }
    Joints<ByBodies, float> qf{}, qdf{}, tauf{};
    Joints<ByElimination, float> qe{}, qde{}, taue{};
    for (int i = 0; i < n; ++i) {
      qe[i] = qf[i] = static_cast<float>(q[i]), qde[i] = qdf[i] = static_cast<float>(qd[i]);
      taue[i] = tauf[i] = static_cast<float>(tau[i]);
    }
    const auto exact = forward_dynamics(bodies, q, qd, tau);
    const auto a = forward_dynamics(bodies, qf, qdf, tauf);
    const auto c = forward_dynamics(elimination, qe, qde, taue);
    double largest = 0.0, of_a = 0.0, of_c = 0.0;
    for (int i = 0; i < n; ++i) {
      largest = std::max(largest, std::abs(exact[i]));
      of_a = std::max(of_a, std::abs(static_cast<double>(a[i]) - exact[i]));
      of_c = std::max(of_c, std::abs(static_cast<double>(c[i]) - exact[i]));
    }
    worst.bodies = std::max(worst.bodies, of_a / largest);
    if (c.status.ok())
      worst.elimination = std::max(worst.elimination, of_c / largest);
    else
      ++worst.refused;
  }
  return worst;
}

constexpr int kinds = 6;

bool is_eliminated(const property::Description& arm) {
  return loss(arm) <= detail::acceptable_loss(parameters(arm).data(), static_cast<int>(arm.links.size()));
}
/// The largest error of an eliminated arm over what is allowed: sixteen times ABA's, or 1e-6.
double share_of_allowed(const property::Description& arm, property::Arms& random) {
  double most = 0.0;
  for (int kind = 0; kind < kinds; ++kind) {
    const auto worst = errors(arm, random, kind, 40);
    most = std::max(most, worst.elimination / std::max(16.0 * worst.bodies, 1e-6));
    EXPECT_EQ(worst.refused, 0) << "a route that is taken by default is not called inaccurate";
  }
  return most;
}
constexpr int arms_per_family = 28;

// Of how many seeds the long run is: AXIAL_ROUTE_SEEDS asks for more.
unsigned route_seeds() {
  const char* asked = std::getenv("AXIAL_ROUTE_SEEDS");
  return asked != nullptr ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10)) : 12;
}

}  // namespace

TEST(DefaultRoute, EliminatesWhereThatLosesLittle) {
  property::Arms random(20261);
  int eliminated = 0;
  for (int f = 0; f < property::families; ++f)
    for (int k = 0; k < arms_per_family; ++k) {
      const auto arm = random.arm(static_cast<property::Family>(f), 2 + k % 11);
      if (!is_eliminated(arm)) continue;
      ++eliminated;
      EXPECT_LE(share_of_allowed(arm, random), 1.0)
          << property::family_names[f] << ", " << arm.links.size() << " joints, loss " << loss(arm);
    }
  EXPECT_GE(eliminated, property::families * arms_per_family / 4) << "a rule that never eliminates is no choice";
}

// The rule samples configurations: of many arms few are worse elsewhere, and none by much.
TEST(DefaultRoute, IsSeldomBeyondWhatIsAllowedAndNeverByMuch) {
  int eliminated = 0, beyond = 0;
  double worst = 0.0;
  const unsigned seeds = route_seeds();
  for (unsigned seed = 1000; seed < 1000 + seeds; ++seed) {
    property::Arms random(seed);
    for (int f = 0; f < property::families; ++f)
      for (int k = 0; k < arms_per_family; ++k) {
        const auto arm = random.arm(static_cast<property::Family>(f), 2 + k % 11);
        if (!is_eliminated(arm)) continue;
        const double share = share_of_allowed(arm, random);
        ++eliminated, beyond += share > 1.0 ? 1 : 0;
        worst = std::max(worst, share);
      }
  }
  std::printf("%u seeds: %d arms of %u are eliminated, %d go beyond what is allowed, by a factor of %.1f at most\n",
              seeds, eliminated, seeds * property::families * arms_per_family, beyond, worst);
  EXPECT_LE(beyond, 1 + eliminated / 250);
  EXPECT_LE(worst, 4.0);
}

// Where an elimination is asked for by name it says when it loses more than it may: 2^13 roundings.
TEST(DefaultRoute, AnEliminationThatIsAskedForSaysWhenItLosesTooMuch) {
  property::Arms random(20262);
  int refused = 0;
  for (int f = 0; f < property::families; ++f)
    for (int k = 0; k < 11; ++k) {
      const auto arm = random.arm(static_cast<property::Family>(f), 2 + k);
      for (int kind = 0; kind < kinds; ++kind) {
        const auto worst = errors(arm, random, kind, 10);
        EXPECT_LE(worst.elimination, 8192.0 * 0x1p-24)
            << property::family_names[f] << ", " << arm.links.size() << " joints";
        refused += worst.refused;
      }
    }
  EXPECT_GT(refused, 100);
}

namespace {

template <int N, int last_kg, int right_angles>
struct Rods {
  static constexpr Link rod(int i) {
    const double kg = i + 1 == N ? last_kg : 1.0;
    return revolute()
        .a(i > 0 ? 1.0 : 0.0)
        .alpha_deg(right_angles * (i % 2 == 1 ? 90.0
                                   : i > 0    ? -90.0
                                              : 0.0))
        .mass(kg)
        .com(0.5, 0.0, 0.0)
        .inertia_com(kg / 1024.0, kg / 12.0, kg / 12.0);
  }
  template <int... I>
  static constexpr auto rods(std::integer_sequence<int, I...>) {
    return axial::chain(gravity(0.0, -9.81, 0.0), rod(I)...);
  }
  static constexpr auto chain = rods(std::make_integer_sequence<int, N>{});
};

}  // namespace

TEST(DefaultRoute, OfRodsIsAba) {
  static_assert(forward_dynamics_route<Rods<7, 6, 0>> == Route::articulated_body);
  static_assert(forward_dynamics_route<Rods<9, 1, 0>> == Route::articulated_body);
  static_assert(forward_dynamics_route<Rods<9, 1, 1>> == Route::articulated_body);
  static_assert(forward_dynamics_route<Scene<Rods<7, 6, 0>, Gravity, Looped>> == Route::articulated_body);
  using R = Rods<7, 6, 0>;
  property::Arms random(20263);
  double worst = 0.0;
  for (int s = 0; s < 500; ++s) {
    Joints<R, double> q{}, qd{}, tau{};
    Joints<R, float> qf{}, qdf{}, tauf{};
    for (int i = 0; i < q.size; ++i) {
      qf[i] = static_cast<float>(q[i] = random.uniform(-3.0, 3.0)),
      qdf[i] = static_cast<float>(qd[i] = random.uniform(-1.0, 1.0));
      tauf[i] = static_cast<float>(tau[i] = random.uniform(-20.0, 20.0));
    }
    const auto exact = forward_dynamics<Scene<R, Gravity, ArticulatedBody, Looped>>(q, qd, tau);
    const auto a = forward_dynamics<R>(qf, qdf, tauf);
    ASSERT_TRUE(a.status.ok());
    double largest = 0.0, error = 0.0;
    for (int i = 0; i < q.size; ++i) {
      largest = std::max(largest, std::abs(exact[i]));
      error = std::max(error, std::abs(static_cast<double>(a[i]) - exact[i]));
    }
    worst = std::max(worst, error / largest);
  }
  EXPECT_LE(worst, 2e-5);
}

// Loops over a table: the elimination is the faster one up to 12 joints.
TEST(DefaultRoute, OfLoopsTurnsAtTwelveJoints) {
  constexpr auto twelve = detail::looped_cost<Rods<12, 1, 1>>(), thirteen = detail::looped_cost<Rods<13, 1, 1>>();
  EXPECT_LT(twelve.composite, twelve.articulated);
  EXPECT_GE(thirteen.composite, thirteen.articulated);
}
