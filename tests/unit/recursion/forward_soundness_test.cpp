// Every number that goes into forward dynamics is looked at, also one that the answer does not depend on.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>
#include <cstring>

using namespace axial;

namespace {

using Code = Status::Code;

struct Arm {  // the slide goes along the first axis: its position and both speeds do not matter to the efforts
  static constexpr auto chain =
      axial::chain(gravity(0, 0, -10), base_body().mass(3).inertia_com(1, 1, 1), axial::payload_limit(1, 1, 1),
                   revolute().mass(1).com(0.5, 0, 0).inertia_com(0.1, 0.1, 0.1),
                   prismatic().mass(1).com(0.25, 0, 0).inertia_com(0.1, 0.1, 0.1).buoyancy(1, 0.1, 0, 0));
};

constexpr double bad[] = {NAN, INFINITY, -INFINITY};

template <class S, class T>
struct Asked {
  Positions<Arm, T> q{T(0.5), T(0.25)};
  Velocities<Arm, T> qd{T(1), T(-1)};
  EffortsOf<S, T> tau{};
  Inputs<S, T> in{};

  Asked() {
    if constexpr (S::template has<SineCosines>) in.turns = sine_cosines<Arm>(q);
  }
  [[nodiscard]] Status status() const { return forward_dynamics<S>(q, qd, tau, in).status; }
};

/// `slot` counts numbers of type T from the start of the inputs.
template <class In, class T>
void poison(In& in, std::size_t slot, T value) {
  std::memcpy(reinterpret_cast<char*>(&in) + slot * sizeof value, &value, sizeof value);
}

template <class S, class T>
void expect_states_are_seen() {
  EXPECT_TRUE((Asked<S, T>{}.status().ok()));
  for (const double x : bad)
    for (int i = 0; i < 2; ++i)
      for (int which = 0; which < 3; ++which) {
        Asked<S, T> asked;
        T& number = which == 0 ? asked.q[i] : which == 1 ? asked.qd[i] : asked.tau[i];
        number = static_cast<T>(x);
        EXPECT_EQ(asked.status().code, Code::not_finite) << "joint " << i << ", " << which << ", " << x;
        EXPECT_EQ(asked.status().joint, -1);
      }
}

template <class S, class T>
void expect_inputs_are_seen() {
  static_assert(sizeof(Inputs<S, T>) % sizeof(T) == 0);
  for (std::size_t slot = 0; slot < sizeof(Inputs<S, T>) / sizeof(T); ++slot)
    for (const double x : bad) {
      Asked<S, T> asked;
      poison(asked.in, slot, static_cast<T>(x));
      EXPECT_EQ(asked.status().code, Code::not_finite) << "number " << slot << " is " << x;
    }
}

}  // namespace

TEST(ForwardSoundness, LooksAtEveryPositionSpeedAndEffort) {
  expect_states_are_seen<Scene<Arm, Gravity, ArticulatedBody>, float>();
  expect_states_are_seen<Scene<Arm, Gravity, ArticulatedBody>, double>();
  expect_states_are_seen<Scene<Arm, Gravity, SplitArticulatedBody>, double>();
  expect_states_are_seen<Scene<Arm, Gravity, CompositeBody>, double>();
  expect_states_are_seen<Scene<Arm, Gravity, CompositeBody, Looped>, double>();
}

TEST(ForwardSoundness, LooksAtEveryRunTimeInput) {
  expect_inputs_are_seen<Scene<Arm, RuntimeGravity, ArticulatedBody>, double>();
  expect_inputs_are_seen<Scene<Arm, Gravity, BaseMotion, ArticulatedBody>, double>();
  expect_inputs_are_seen<Scene<Arm, Gravity, TipWrench, CompositeBody>, double>();
  expect_inputs_are_seen<Scene<Arm, Gravity, ExternalWrenches, ArticulatedBody>, double>();
  expect_inputs_are_seen<Scene<Arm, Gravity, Payload, ArticulatedBody>, double>();
}

TEST(ForwardSoundness, LooksAtWhatAFreeBaseIsGiven) {
  using S = Scene<Arm, RuntimeGravity, FloatingBase, BaseWrench, Underwater, VelocityThroughWater>;
  const auto seen = [](auto&& change) {
    Asked<S, double> asked;
    change(asked.in);
    return asked.status().code;
  };
  EXPECT_EQ(seen([](auto&) {}), Code::ok);
  for (const double x : bad) {
    EXPECT_EQ(seen([=](auto& in) { in.base_motion.angular_velocity.y = x; }), Code::not_finite);
    EXPECT_EQ(seen([=](auto& in) { in.base_wrench.force.x = x; }), Code::not_finite);
    EXPECT_EQ(seen([=](auto& in) { in.base_wrench.moment.z = x; }), Code::not_finite);
    EXPECT_EQ(seen([=](auto& in) { in.velocity_through_water.z = x; }), Code::not_finite);
    EXPECT_EQ(seen([=](auto& in) { in.gravity.x = x; }), Code::not_finite);
    EXPECT_EQ(seen([=](auto& in) { in.base_motion.linear_acceleration.x = x; }), Code::ok) << "it is the answer";
  }
}

TEST(ForwardSoundness, PairsStandForPositions) {
  using S = Scene<Arm, Gravity, SineCosines, ArticulatedBody>;
  for (const double x : bad) {
    Asked<S, double> sine, cosine, turn, slide, unused;
    sine.in.turns[0].sin = x, cosine.in.turns[0].cos = x, turn.q[0] = x, slide.q[1] = x, unused.in.turns[1].sin = x;
    EXPECT_EQ(sine.status().code, Code::not_finite);
    EXPECT_EQ(cosine.status().code, Code::not_finite);
    EXPECT_EQ(slide.status().code, Code::not_finite);
    EXPECT_EQ(turn.status().code, Code::ok) << "nobody reads it";
    EXPECT_EQ(unused.status().code, Code::ok) << "a slide has no pair";
  }
}

TEST(ForwardSoundness, OverflowOnTheWayIsNotAnAnswer) {
  using S = Scene<Arm, Gravity, ArticulatedBody>;
  Asked<S, float> asked;
  asked.tau[0] = 3e38F;
  EXPECT_EQ(asked.status().code, Code::not_finite);
}

TEST(ForwardSoundness, AnAngleOfTooManyTurnsIsToldAndASlideIsNoAngle) {
  using S = Scene<Arm, Gravity, ArticulatedBody>;
  Asked<S, float> turn, slide;
  turn.q[0] = -1e5F, slide.q[1] = 1e5F;
  EXPECT_EQ(turn.status().code, Code::angle_range);
  EXPECT_EQ(slide.status().code, Code::ok);
}

TEST(ForwardSoundness, GoesBeforeWhatTheSolverSays) {
  using M = Model<2, Gravity>;
  M model;
  ASSERT_TRUE(model.add(revolute()));
  ASSERT_TRUE(model.add(revolute().mass(1).inertia_com(1, 1, 1)));
  const Joints<M, double> still{}, bent{0.0, 1e9}, none{NAN, 0.0};
  const auto code = [&](const auto& q) { return forward_dynamics(model, q, still, still).status; };
  EXPECT_EQ(code(still).code, Code::near_singular);
  EXPECT_EQ(code(still).joint, 0);
  EXPECT_EQ(code(bent).code, Code::angle_range);
  EXPECT_EQ(code(bent).joint, -1);
  EXPECT_EQ(code(none).code, Code::not_finite);
}
