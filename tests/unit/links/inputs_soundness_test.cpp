// Every call with a status looks at every run-time input that its scene names, in float, double and fixed point.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/batch.hpp>
#include <axial/fixed.hpp>
#include <cmath>
#include <string>
#include <vector>

using namespace axial;

namespace {

struct Arm {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0), payload_limit(3.0, 0.5, 0.1), tool_limit(0.3),
                                             tip_wrench_limit(50.0, 20.0),
                                             revolute()
                                                 .mass(4.6)
                                                 .com(0.5, 0, 0)
                                                 .inertia_com(0.02, 0.05, 0.05)
                                                 .position_limits(-3, 3)
                                                 .speed_limit(3)
                                                 .acceleration_limit(20)
                                                 .effort_limit(200),
                                             prismatic()
                                                 .a(0.5)
                                                 .alpha_deg(90)
                                                 .mass(2)
                                                 .inertia_com(0.01, 0.01, 0.01)
                                                 .position_limits(-0.2, 0.2)
                                                 .speed_limit(1)
                                                 .acceleration_limit(5)
                                                 .effort_limit(200),
                                             revolute()
                                                 .alpha_deg(-90)
                                                 .a(0.1)
                                                 .mass(2.3)
                                                 .com(0.4, 0, 0)
                                                 .inertia_com(0.01, 0.03, 0.03)
                                                 .position_limits(-3, 3)
                                                 .speed_limit(3)
                                                 .acceleration_limit(20)
                                                 .effort_limit(75));
};
using S = Scene<Arm, RuntimeGravity, RotorInertia, SineCosines, Payload, RuntimeTool, TipWrench>;
struct Tuning {
  static constexpr double period = 1e-3, gain = 200.0;
};

constexpr double at[3] = {0.3, 0.05, -0.5};

/// Good inputs in numbers.
Inputs<S, double> good() {
  Inputs<S, double> in;
  for (int i = 0; i < 3; ++i)
    in.turns[i] = {std::sin(at[i]), std::cos(at[i])};
  in.payload = {1.0, {0.1, 0.02, 0.0}, {0.01, 0.02, 0.02, 0.001, 0.0, -0.002}};
  in.tip_wrench = {{1.0, -2.0, 0.5}, {5.0, 0.0, -3.0}};
  return in;
}

struct Call {
  const char* name;
  Status status;
};

/// What every call with a status says of a good state and of inputs.
template <class T, class State, class In>
std::vector<Call> all_calls(const State& r, const In& in) {
  FeedforwardState<S, T> forward;
  SafeLoopState<S, T> loop, tracked;
  ObserverState<S, T, Tuning> observer;
  const auto safe = feedforward<S>(forward, r.q, r.qd, r.qdd, in);  // its efforts keep accelerations small
  std::vector<Call> calls{
      {"feedforward", safe.status},
      {"compensate_gravity", compensate_gravity<S>(loop, r.q, in).status},
      {"track", track<S>(tracked, r, MeasuredMotion<S, T>{r.q, r.qd, {}}, TrackingGains<S, T>{}, in).status},
      {"observe", observe<S>(observer, r.q, r.qd, EffortsOf<S, T>{}, in)},
      {"forward_dynamics", forward_dynamics<S>(r.q, r.qd, safe.tau, in).status},
      {"forward_dynamics_derivatives", forward_dynamics_derivatives<S>(r.q, r.qd, safe.tau, in).qdd.status},
      {"forward_kinematics", forward_kinematics<S>(r.q, in).status},
      {"jacobian", jacobian<S>(r.q, in).status},
      {"jacobian of a link", jacobian<S, 1>(r.q, in).status},
      {"momentum_terms", momentum_terms<S>(r.q, r.qd, in).status},
  };
  FallBack<S, T> fall_back;
  calls.push_back({"hold_at", {fall_back.hold_at(r.q, in) ? Status::Code::ok : Status::Code::input_limit, -1}});
  if constexpr (is_stored_v<T>) {
    calls.push_back({"certified", certified_forward_dynamics<S>(r.q, r.qd, safe.tau, in).status});
  } else {
    using Batch4 = Batch<T, 4>;
    Inputs<S, Batch4> lanes;
    const auto all = [](const T& x) { return Batch4(x); };
    const auto vector = [&](const Vec3<T>& v) { return Vec3<Batch4>{all(v.x), all(v.y), all(v.z)}; };
    const auto& j = in.payload.inertia_com;
    lanes.gravity = vector(in.gravity);
    lanes.payload = {all(in.payload.mass),
                     vector(in.payload.com),
                     {all(j.xx), all(j.yy), all(j.zz), all(j.xy), all(j.xz), all(j.yz)}};
    lanes.tip_wrench = {vector(in.tip_wrench.moment), vector(in.tip_wrench.force)};
    const auto& axes = in.tool.rotation;
    lanes.tool = {{vector(axes.x), vector(axes.y), vector(axes.z)}, vector(in.tool.position)};
    Joints<Arm, Batch4> q{}, qd{}, tau{};
    for (int i = 0; i < 3; ++i)
      lanes.turns[i] = {all(in.turns[i].sin), all(in.turns[i].cos)}, q[i] = all(r.q[i]), qd[i] = all(r.qd[i]);
    calls.push_back({"a batch", forward_dynamics<S>(q, qd, tau, lanes).status[2]});
    calls.push_back({"mobility", tool_mobility<S>(r.q, in).status});
  }
  return calls;
}

template <class T>
std::vector<Call> calls_with(const Inputs<S, double>& in) {
  Joints<Arm, double> q{at[0], at[1], at[2]}, qd{0.1, 0.02, -0.2}, qdd{};
  if constexpr (is_stored_v<T>) {
    using F = InputFormats<Arm, T>;
    const auto word = [](double x, int exponent) {
      return T{static_cast<std::int32_t>(
          std::lrint(std::fmax(-0x1p31, std::fmin(x * std::ldexp(1.0, exponent), 0x1.fffffffcp30))))};
    };
    const auto vector = [&](const Vec3<double>& v, int e) { return Vec3<T>{word(v.x, e), word(v.y, e), word(v.z, e)}; };
    Inputs<S, T> words;
    for (int i = 0; i < 3; ++i)
      words.turns[i] = {word(in.turns[i].sin, F::sine_cosine), word(in.turns[i].cos, F::sine_cosine)};
    const auto& j = in.payload.inertia_com;
    const int e = F::payload_inertia;
    words.payload = {word(in.payload.mass, F::payload_mass),
                     vector(in.payload.com, F::payload_com),
                     {word(j.xx, e), word(j.yy, e), word(j.zz, e), word(j.xy, e), word(j.xz, e), word(j.yz, e)}};
    words.tip_wrench = {vector(in.tip_wrench.moment, F::tip_moment), vector(in.tip_wrench.force, F::tip_force)};
    words.gravity = vector(in.gravity, F::gravity);
    const auto& axes = in.tool.rotation;
    words.tool = {{vector(axes.x, F::sine_cosine), vector(axes.y, F::sine_cosine), vector(axes.z, F::sine_cosine)},
                  vector(in.tool.position, F::tool)};
    return all_calls<T>(to_fixed_request<S, std::int32_t>(q, qd, qdd), words);
  } else {
    const auto number = [](double x) { return static_cast<T>(x); };
    const auto vector = [&](const Vec3<double>& v) { return Vec3<T>{number(v.x), number(v.y), number(v.z)}; };
    Inputs<S, T> numbers;
    Request<S, T> r;
    for (int i = 0; i < 3; ++i) {
      numbers.turns[i] = {number(in.turns[i].sin), number(in.turns[i].cos)};
      r.q[i] = number(q[i]), r.qd[i] = number(qd[i]);
    }
    const auto& j = in.payload.inertia_com;
    numbers.payload = {number(in.payload.mass),
                       vector(in.payload.com),
                       {number(j.xx), number(j.yy), number(j.zz), number(j.xy), number(j.xz), number(j.yz)}};
    numbers.tip_wrench = {vector(in.tip_wrench.moment), vector(in.tip_wrench.force)};
    numbers.gravity = vector(in.gravity);
    const auto& axes = in.tool.rotation;
    numbers.tool = {{vector(axes.x), vector(axes.y), vector(axes.z)}, vector(in.tool.position)};
    return all_calls<T>(r, numbers);
  }
}

using In = Inputs<S, double>;
struct Fault {
  const char* what;
  void (*spoil)(In&);
  bool fixed = true;       ///< whether words can say it
  bool everywhere = true;  ///< or only in calls that hold states against declared limits too
};

const double nan = std::nan(""), inf = INFINITY;
const Fault faults[] = {
    {"a broken wire",
     [](In& in) {
       in.turns[0] = {0.0, 0.0};
     }},
    {"a pair off the circle", [](In& in) { in.turns[2].sin = 1.9; }},
    {"a pair far off the circle", [](In& in) { in.turns[2].sin = 3.0; }, false},
    {"a pair a thousandth too long", [](In& in) { in.turns[0].sin *= 1.004, in.turns[0].cos *= 1.004; }},
    {"a sine that is missing", [](In& in) { in.turns[0].sin = 0.0; }},
    {"a cosine that is missing", [](In& in) { in.turns[2].cos = 0.0; }},
    {"a sine NaN", [](In& in) { in.turns[2].sin = nan; }, false},
    {"a cosine infinite", [](In& in) { in.turns[0].cos = inf; }, false},
    {"a mass below 0", [](In& in) { in.payload.mass = -0.5; }},
    {"a mass NaN", [](In& in) { in.payload.mass = nan; }, false},
    {"a mass beyond the declared", [](In& in) { in.payload.mass = 3.01; }, true, false},
    {"a mass beyond any", [](In& in) { in.payload.mass = 1e7; }},
    {"a centre of mass beyond the declared", [](In& in) { in.payload.com.y = -0.51; }, true, false},
    {"a centre of mass infinite", [](In& in) { in.payload.com.z = -inf; }, false},
    {"an inertia below 0", [](In& in) { in.payload.inertia_com.zz = -0.01; }},
    {"an inertia NaN", [](In& in) { in.payload.inertia_com.yz = nan; }, false},
    {"an inertia beyond the declared", [](In& in) { in.payload.inertia_com.xx = 0.11; }, true, false},
    {"a wrench NaN", [](In& in) { in.tip_wrench.moment.x = nan; }, false},
    {"a wrench infinite", [](In& in) { in.tip_wrench.force.y = inf; }, false},
    {"a wrench beyond the declared", [](In& in) { in.tip_wrench.force.y = 60.0; }, true, false},
    {"a wrench beyond any", [](In& in) { in.tip_wrench.moment.y = -1e10; }},
    {"gravity NaN", [](In& in) { in.gravity.z = nan; }, false},
    {"gravity beyond any", [](In& in) { in.gravity.z = -2e3; }},
    {"a tool that is mirrored", [](In& in) { in.tool.rotation.y.y = -in.tool.rotation.y.y; }},
    {"a tool that is stretched", [](In& in) { in.tool.rotation.x.x *= 1.01; }},
    {"a tool NaN", [](In& in) { in.tool.rotation.z.y = nan; }, false},
    {"a tool beyond its reach", [](In& in) { in.tool.position.x = 0.31; }, true, false},
    {"a tool beyond any reach", [](In& in) { in.tool.position.x = 1e4; }},
};

template <class T>
class InputsOf : public testing::Test {};
using Numbers = testing::Types<float, double, Fixed32>;
TYPED_TEST_SUITE(InputsOf, Numbers);

constexpr int controlled = 4;  // of all_calls, and hold_at

}  // namespace

TYPED_TEST(InputsOf, ThatAreGoodPassEveryCall) {
  for (const Call& call : calls_with<TypeParam>(good()))
    EXPECT_TRUE(call.status.ok()) << call.name << " says " << static_cast<int>(call.status.code);
}

TYPED_TEST(InputsOf, ThatAreBadPassNone) {
  for (const Fault& fault : faults) {
    if (is_stored_v<TypeParam> && !fault.fixed) continue;
    auto in = good();
    fault.spoil(in);
    int k = 0;
    for (const Call& call : calls_with<TypeParam>(in)) {
      const bool judges = k++ < controlled || std::string(call.name) == "hold_at";
      if (!fault.everywhere && !judges && !is_stored_v<TypeParam>) continue;
      EXPECT_FALSE(call.status.met()) << call.name << ": " << fault.what;
    }
  }
}

namespace {

template <class Sc, class Spoil>
Status spoilt(const Spoil& spoil) {
  Joints<Arm, float> q{0.3F, 0.05F, -0.5F}, none{};
  Inputs<Sc, float> in;
  spoil(in);
  FeedforwardState<Sc, float> state;
  const Status forward = feedforward<Sc>(state, q, none, none, in).status;
  const Status solved = forward_dynamics<Sc>(q, none, none, in).status;
  EXPECT_EQ(forward.ok(), solved.ok());
  return forward;
}

}  // namespace

TEST(Inputs, OfMovingBasesAreLookedAt) {
  using M = Scene<Arm, RuntimeGravity, BaseMotion>;
  EXPECT_TRUE(spoilt<M>([](auto&) {}).ok());
  for (const float bad : {NAN, INFINITY, -INFINITY, 1e7F, -1e30F}) {
    EXPECT_FALSE(spoilt<M>([&](auto& in) { in.base_motion.angular_velocity.y = bad; }).ok()) << bad;
    EXPECT_FALSE(spoilt<M>([&](auto& in) { in.base_motion.angular_acceleration.x = bad; }).ok()) << bad;
    EXPECT_FALSE(spoilt<M>([&](auto& in) { in.base_motion.linear_acceleration.z = bad; }).ok()) << bad;
  }
}

TEST(Inputs, OfEveryLinkAreLookedAt) {
  using W = Scene<Arm, Gravity, ExternalWrenches>;
  EXPECT_TRUE(spoilt<W>([](auto& in) { in.wrenches[1].force.x = 40.0F; }).ok());
  for (int i = 0; i < 3; ++i)
    for (const float bad : {NAN, INFINITY, 1e10F, -1e20F}) {
      EXPECT_FALSE(spoilt<W>([&](auto& in) { in.wrenches[i].force.y = bad; }).ok()) << bad;
      EXPECT_FALSE(spoilt<W>([&](auto& in) { in.wrenches[i].moment.z = bad; }).ok()) << bad;
    }
}

TEST(Inputs, OfARunTimeModelAreLookedAt) {
  using M = Model<2, Gravity, Payload, SineCosines>;
  M model;
  model.set_gravity(0.0, -9.81, 0.0);
  for (int i = 0; i < 2; ++i)
    ASSERT_TRUE(model.add(Arm::chain.links[i]));
  Joints<M, double> q{0.3, 0.05}, none{};
  Inputs<M, double> in;
  in.turns[0] = {std::sin(0.3), std::cos(0.3)};
  EXPECT_TRUE(forward_dynamics(model, q, none, none, in).status.ok()) << "a slide's pair is ignored";
  EXPECT_TRUE(forward_kinematics(model, q, in).status.ok());
  in.turns[0].sin = 0.0;
  EXPECT_EQ(forward_dynamics(model, q, none, none, in).status.code, Status::Code::angle_range);
  EXPECT_EQ(forward_kinematics(model, q, in).status.code, Status::Code::angle_range);
  in.turns[0].sin = std::sin(0.3);
  in.payload.mass = -1.0;
  EXPECT_EQ(forward_dynamics(model, q, none, none, in).status.code, Status::Code::payload_limit);
}
