// An arm whose steps another core makes, at the latest that it may.

#include "arm_fixture.hpp"

namespace axial::apps {
namespace {

/// Does a job no sooner than it is waited for: the latest that a core beside this one may.
struct LateWorker {
  static constexpr bool is_beside = true;
  inline static void (*job)(void*) = nullptr;
  inline static void* with = nullptr;
  static void start() {}
  static void begin(void (*what)(void*), void* with_what) {
    EXPECT_EQ(job, nullptr) << "one job at a time";
    job = what, with = with_what;
  }
  static void join() {
    ASSERT_NE(job, nullptr) << "nothing is being done";
    job(with);
    job = nullptr;
  }
  static bool stack_intact() { return true; }
};
class SharedArm : public ArmApp<robots::Scara, float, LateWorker> {
 protected:
  ~SharedArm() override { LateWorker::job = nullptr; }
};

TEST_F(SharedArm, AnswersTheSameInLockStep) {
  const auto expected = Answers<robots::Scara, float>{}.of(20);
  const auto found = Answers<robots::Scara, float, LateWorker>{}.of(20);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(found[k].position, expected[k].position) << k;
    EXPECT_EQ(found[k].speed, expected[k].speed) << k;
    EXPECT_EQ(found[k].status, expected[k].status) << k;
  }
}

TEST_F(SharedArm, TellsOfTheTickBeforeInFreeRunning) {
  open(link::Mode::free_running);
  tell(link::ArmAction::place, pose);
  send(framed(efforts({}, DrivePhase::running), 1));
  tick();
  const auto first = answer<link::Encoders>().value();
  EXPECT_EQ(first.speed[2], 0.0F) << "this tick's steps are still being made";
  EXPECT_NE(LateWorker::job, nullptr);
  send(framed(efforts({}, DrivePhase::running), 2));
  tick();
  EXPECT_NEAR(answer<link::Encoders>()->speed[2], 1e-3F * earth, 1e-6F);
  tell(link::ArmAction::place, pose);
  EXPECT_EQ(LateWorker::job, nullptr) << "it was waited for before the arm was placed";
  EXPECT_EQ(tell(link::ArmAction::go).speed[2], 0.0F);
}

}  // namespace
}  // namespace axial::apps
