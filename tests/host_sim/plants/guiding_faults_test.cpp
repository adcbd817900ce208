// Faults in the loop of the hand-guiding image, on the host with a tick of a millisecond: what doc/guides/safety.md
// lists, while a hand guides and while set-points are tracked. Every effort of every tick is looked at: none changes
// faster than declared while the drives are enabled.
#include <firmware/apps/hand_guiding/controller.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <robots/puma560.hpp>
#include <robots/scara.hpp>

using axial::DrivePhase;
using axial::FallBackTimes;
using axial::Fixed32;
using axial::apps::HandGuidingController;

namespace {

namespace link = axial::hal::link;

const float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr FallBackTimes times{20, 100, 2000};  // of a board with a tick of a millisecond

}  // namespace

namespace {

/// The controller on a played board: requests and ticks as they come, every millisecond looked at.
template <class Robot_, class Number_>
struct Case {
  using Robot = Robot_;
  using Number = Number_;
};

template <class C>
class Faults : public testing::Test {
 protected:
  using Robot = typename C::Robot;
  static constexpr int n = Robot::chain.size;

  Faults() {
    job_.set_times(times);
    for (int i = 0; i < n; ++i) {
      const auto& l = Robot::chain.links[i];
      at_[i] = l.position_min + 0.4 * (l.position_max - l.position_min);
      declared_[i] = 2.0 * l.effort_limit / 100.0;
    }
  }

  link::Measurement measured(bool tracks) const {
    link::Measurement m{};
    m.joints = n;
    m.feeds_forward = tracks ? 1 : 0;
    for (int i = 0; i < n; ++i) {
      const bool slides = Robot::chain.links[i].type == axial::JointType::prismatic;
      m.position[std::size_t(i)] = static_cast<std::int32_t>(
          std::llround(slides ? at_[i] * 1e7 : std::ldexp(std::remainder(at_[i] / 6.283185307179586, 1.0), 32)));
    }
    return m;
  }
  /// A set-point a little ahead of the arm.
  link::SetPoint wanted(double ahead = 0.02) const {
    link::SetPoint point{};
    point.joints = n;
    for (int i = 0; i < n; ++i) {
      const auto& l = Robot::chain.links[i];
      point.q[std::size_t(i)] = static_cast<float>(at_[i] + ahead * (l.position_max - l.position_min));
      point.qd[std::size_t(i)] = static_cast<float>(0.3 * l.speed_limit);
      point.qdd[std::size_t(i)] = static_cast<float>((i % 2 == 0 ? 0.5 : -0.5) * l.acceleration_limit);
    }
    return point;
  }

  /// A tick of the board, with a request or none.
  void tick(const link::Measurement* measurement = nullptr, const link::SetPoint* point = nullptr) {
    job_.advance(1);
    if (measurement != nullptr) job_.measure(*measurement);
    if (point != nullptr) {
      job_.load(*point);
      job_.compute();
      job_.settle(*point);
      job_.store(told_);
    }
    look();
  }
  void ask(bool tracks, const link::SetPoint& point) {
    const auto m = measured(tracks);
    tick(&m, &point);
  }
  void follow(int ticks, bool tracks = true) {
    for (int k = 0; k < ticks; ++k)
      ask(tracks, wanted());
  }
  void wait(int ticks) {
    for (int k = 0; k < ticks; ++k)
      tick();
  }

  /// The torque now, no farther from the last one than declared, unless the drives are off.
  void look() {
    link::Torque now{};
    job_.store_exerted(now);
    const bool on = job_.phase() != DrivePhase::idle && job_.phase() != DrivePhase::disabled;
    for (int i = 0; i < n; ++i) {
      const double tau = static_cast<double>(now.tau[std::size_t(i)]), change = std::fabs(tau - last_[i]);
      if (on)
        EXPECT_LE(change, declared_[i] * (1.0 + 1e-5)) << "joint " << i << ", tick " << ticks_;
      else
        EXPECT_EQ(tau, 0.0);
      if (change > 0.9 * declared_[i]) ++fast_;
      last_[i] = tau;
    }
    ++ticks_;
  }
  void expect_weight() const {
    const auto& weight = axial::gravity_torque<axial::apps::GuidedScene<Robot>, double>(at_, load());
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(last_[i], weight[i], 1e-4 * Robot::chain.links[i].effort_limit) << "joint " << i;
  }
  static auto load() {
    axial::Inputs<axial::apps::GuidedScene<Robot>, double> in;
    in.payload = axial::mounted_payload<Robot>(axial::apps::gripper);
    return in;
  }

  HandGuidingController<Robot, typename C::Number> job_;
  axial::Joints<Robot, double> at_{};
  double declared_[12] = {}, last_[12] = {};
  link::Torque told_{};
  long ticks_ = 0, fast_ = 0;
};
using Cases = testing::Types<Case<robots::Scara, float>, Case<robots::Scara, Fixed32>, Case<robots::Puma560, float>,
                             Case<robots::Puma560, Fixed32>>;
TYPED_TEST_SUITE(Faults, Cases);

link::TorqueStatus status_of(const link::Torque& torque) { return static_cast<link::TorqueStatus>(torque.status); }

}  // namespace

TYPED_TEST(Faults, ASilentLineFadesHoldsAndDisables) {
  for (const bool tracks : {false, true}) {
    this->follow(200, tracks);
    EXPECT_EQ(this->job_.phase(), DrivePhase::running);
    this->wait(times.patience + times.ramp + 1);
    EXPECT_EQ(this->job_.phase(), DrivePhase::holding);
    this->expect_weight();
    this->wait(times.hold);
    EXPECT_EQ(this->job_.phase(), DrivePhase::disabled);
    this->job_.restart();
  }
  EXPECT_GT(this->fast_, 0) << "something was slowed";
}

TYPED_TEST(Faults, RequestsThatGoBadHoldThenFadeAsSilence) {
  for (const bool tracks : {false, true})
    for (int kind = 0; kind < 3; ++kind) {
      this->follow(200, tracks);
      auto bad = this->wanted();
      if (kind == 0) bad.qdd[1] = not_a_number;
      if (kind == 1) bad.qd[0] = 1e9F;
      if (kind == 2) bad.q[1] = -1e9F;
      for (int k = 0; k < times.patience + times.ramp + 1; ++k) {
        this->ask(tracks, bad);
        EXPECT_EQ(status_of(this->told_),
                  kind == 0 ? link::TorqueStatus::not_finite : link::TorqueStatus::outside_limits);
      }
      EXPECT_EQ(this->job_.phase(), DrivePhase::holding);
      this->expect_weight();
      for (int k = 0; k < times.hold; ++k)
        this->ask(tracks, bad);
      EXPECT_EQ(this->job_.phase(), DrivePhase::disabled);
      this->job_.restart();
    }
}

TYPED_TEST(Faults, MeasurementsThatStopOrGoWrongAreAsSilence) {
  for (const bool wrong : {false, true}) {
    this->follow(200);
    auto nowhere = this->measured(true);
    nowhere.position[0] = wrong ? std::numeric_limits<std::int32_t>::min() : 0;
    for (int k = 0; k < times.patience + times.ramp + 1; ++k) {
      const auto point = this->wanted();
      this->tick(wrong ? &nowhere : nullptr, &point);
      EXPECT_EQ(status_of(this->told_), wrong ? link::TorqueStatus::outside_limits : link::TorqueStatus::not_measured);
    }
    EXPECT_EQ(this->job_.phase(), DrivePhase::holding);
    this->expect_weight();
    this->wait(times.hold);
    EXPECT_EQ(this->job_.phase(), DrivePhase::disabled);
    this->job_.restart();
  }
}

TYPED_TEST(Faults, AFirstRequestThatIsRefusedHoldsWhereTheEncodersSeeTheArm) {
  auto bad = this->wanted();
  bad.qdd[0] = not_a_number;
  const auto unknown = this->wanted();
  this->tick(nullptr, &unknown);
  EXPECT_EQ(status_of(this->told_), link::TorqueStatus::not_measured);
  EXPECT_EQ(this->job_.phase(), DrivePhase::idle) << "nothing is known";
  this->ask(true, bad);
  EXPECT_EQ(this->job_.phase(), DrivePhase::holding);
  this->wait(200);
  this->expect_weight();
}

TYPED_TEST(Faults, AGoodRequestEndsTheFallBackWithoutAStep) {
  for (const int late : {1, times.ramp / 2, static_cast<int>(times.ramp) + 50}) {
    this->follow(200);
    this->wait(times.patience + late);
    EXPECT_NE(this->job_.phase(), DrivePhase::running);
    this->follow(1, false);
    EXPECT_EQ(this->job_.phase(), DrivePhase::running);
    if (late > times.ramp) this->expect_weight();  // what was exerted goes on, not what was wanted before the pause
    this->follow(50, late % 2 == 0);
  }
}

TYPED_TEST(Faults, AStartLetsNoArmFall) {
  this->follow(200);
  this->wait(times.patience + times.ramp + 1);
  this->job_.restart();
  this->wait(10);
  EXPECT_EQ(this->job_.phase(), DrivePhase::holding);
  this->expect_weight();
}

TYPED_TEST(Faults, AnEncoderThatSlipsChangesNothingFast) {
  this->follow(200, false);
  auto slipped = this->measured(false);
  slipped.position[1] += 300'000'000;
  const auto point = this->wanted();
  for (int k = 0; k < 100; ++k)
    this->tick(&slipped, &point);
  for (int k = 0; k < 100; ++k) {
    auto tracked = k % 2 == 0 ? slipped : this->measured(true);
    tracked.feeds_forward = 1;
    this->tick(&tracked, &point);
  }
}

TYPED_TEST(Faults, AHandTakesOverAndGivesBackWithoutAStep) {
  for (int k = 0; k < 300; ++k)
    this->follow(1, k / 3 % 2 == 0);
  EXPECT_EQ(this->job_.phase(), DrivePhase::running);
  this->follow(200, false);
  this->expect_weight();
}
