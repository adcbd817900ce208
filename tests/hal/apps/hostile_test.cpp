// What asks every call of hostile numbers: it knows what it drew, and an ok beside NaN or infinity is wrong.
#include <firmware/apps/hostile/draw.hpp>
#include <robots/scara.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace {

using namespace axial;
using namespace axial::apps;

template <class T>
class HostileDraw : public testing::Test {};
using NumberTypes = testing::Types<float, double>;
TYPED_TEST_SUITE(HostileDraw, NumberTypes);

template <class T>
bool usual(const Vec3<T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// How often all that `drawn` has drawn was finite, of 1000; the draw says so each time.
template <class Drawn>
int finite_of(const Drawn& drawn) {
  Draw draw;
  int finite = 0;
  for (int k = 0; k < 1000; ++k) {
    draw.next();
    const bool is_finite = drawn(draw);
    EXPECT_EQ(draw.finite(), is_finite) << k;
    finite += is_finite;
  }
  return finite;
}
void expect_both(int finite) {
  EXPECT_GE(finite, 250) << "one in four is what a robot may see";
  EXPECT_LT(finite, 1000);
}

}  // namespace

TYPED_TEST(HostileDraw, SeesWhatIsNoNumberWhereverItStands) {
  using T = TypeParam;
  using Limits = std::numeric_limits<T>;
  const std::array<T, 4> good{T(0), -Limits::max(), Limits::denorm_min(), Limits::min()};
  EXPECT_TRUE((all_finite<T>(good, good[0], good)));
  for (const T bad : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
    for (std::size_t i = 0; i < good.size(); ++i) {
      auto spoilt = good;
      spoilt[i] = bad;
      EXPECT_FALSE(all_finite<T>(spoilt)) << i;
      EXPECT_FALSE((all_finite<T>(spoilt, good, good)));
      EXPECT_FALSE((all_finite<T>(good, spoilt, good)));
      EXPECT_FALSE((all_finite<T>(good, good, spoilt)));
    }
}
TYPED_TEST(HostileDraw, KnowsWhetherAllThatItDrewWasFinite) {
  using T = TypeParam;
  using R = robots::Scara;
  using Laden = Scene<R, RuntimeGravity, Payload, TipWrench>;
  using Carried = Scene<R, Gravity, BaseMotion, RuntimeTool>;
  expect_both(finite_of([](Draw& draw) { return std::isfinite(draw.number<T>(1.0)); }));
  expect_both(finite_of([](Draw& draw) { return usual(draw.vector<T>(1.0)); }));
  expect_both(finite_of([](Draw& draw) {
    const auto load = draw.load<T>();
    return std::isfinite(load.mass) && usual(load.com) && std::isfinite(load.inertia_com.xx);
  }));
  expect_both(finite_of([](Draw& draw) {
    const auto q = draw.joints<Joints<R, T>>(1.0);
    bool all = true;
    for (const T x : q.values)
      all &= std::isfinite(x);
    return all;
  }));
  expect_both(finite_of([](Draw& draw) {
    const auto in = draw.inputs<Laden, T>();
    const bool load =
        std::isfinite(in.payload.mass) && usual(in.payload.com) && std::isfinite(in.payload.inertia_com.xx);
    return usual(in.gravity) && load && usual(in.tip_wrench.moment) && usual(in.tip_wrench.force);
  }));
  expect_both(finite_of([](Draw& draw) {
    const auto in = draw.inputs<Carried, T>();
    const auto& base = in.base_motion;
    return usual(base.angular_velocity) && usual(base.angular_acceleration) && usual(base.linear_acceleration) &&
           usual(in.tool.position);
  }));
  expect_both(finite_of([](Draw& draw) {
    const auto in = draw.inputs<Scene<R, SineCosines>, T>();
    bool all = true;
    for (int i = 0; i < joint_count<R>; ++i)
      all &= std::isfinite(in.turns[i].sin) && std::isfinite(in.turns[i].cos);
    return all;
  }));
}
TEST(HostileVerdict, OkIsRightWhereAllThatWasAskedAndAnsweredIsFinite) {
  const Status ok{}, refused{Status::Code::not_finite, 0};
  for (const bool asked : {true, false})
    for (const bool answered : {true, false}) {
      EXPECT_EQ(judged(refused, asked, answered), Verdict::refused);
      EXPECT_EQ(judged(ok, asked, answered), asked && answered ? Verdict::right : Verdict::wrong);
    }
}
