// What an arm that a board stands in for does besides moving as rigid bodies: what its robot's Mechanics name.

#include <algorithm>
#include <cmath>
#include <vector>

#include <robots/scara_quill.hpp>

#include "arm_fixture.hpp"

namespace axial::apps {
namespace {

constexpr JointValues pose = {0.3F, -0.4F, 0.1F};

/// Two joints and a slide with all that there is.
struct Worn : robots::Scara {
  static constexpr const char* name = "worn";
  static constexpr auto chain = axial::chain(axial::gravity(0.0, 0.0, -9.8125),
                                             axial::revolute()
                                                 .mass(4.0)
                                                 .com(0.1875, 0.0, 0.0)
                                                 .inertia_com(0.0, 0.05, 0.05)
                                                 .position_limits(-2.5, 2.5)
                                                 .speed_limit(4.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(80.0)
                                                 .coulomb(2.0)
                                                 .viscous(0.1),
                                             axial::revolute()
                                                 .a(0.375)
                                                 .mass(2.5)
                                                 .com(0.15, 0.0, 0.0)
                                                 .inertia_com(0.0, 0.02, 0.02)
                                                 .position_limits(-2.6, 2.6)
                                                 .speed_limit(5.0)
                                                 .acceleration_limit(30.0)
                                                 .effort_limit(25.0)
                                                 .coulomb(1.0),
                                             axial::prismatic()
                                                 .a(0.3125)
                                                 .alpha_deg(180)
                                                 .mass(1.25)
                                                 .position_limits(0.0, 0.25)
                                                 .speed_limit(1.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(30.0)
                                                 .coulomb(15.0));
  struct Mechanics {
    static constexpr bool friction = true;
    static constexpr EndStops stops{1e5, 30.0};
    static constexpr int encoder_bits = 14;
    static constexpr double backlash[] = {0.02, 0.0, 0.001};
  };
};
using WornArm = ArmApp<Worn, float>;
constexpr std::uint32_t count = 1U << 18;  // of 14 bits a turn
constexpr std::int32_t slide_step = 610;   // 10^7 / 2^14

TEST_F(WornArm, StandsStillAgainstItsWeight) {
  open(link::Mode::lock_step);
  const auto first = tell(link::ArmAction::place, pose);
  link::Encoders last{};
  for (std::uint32_t k = 1; k <= 3000; ++k)
    last = ask({1.9F, -0.9F, 0.0F}, k);  // gravity's 12.3 N are less than the slide's 15
  EXPECT_EQ(last.position, first.position);
  EXPECT_EQ(last.speed, first.speed);
}

TEST_F(WornArm, CountsAsCoarselyAsItsEncoders) {
  open(link::Mode::lock_step);
  auto found = tell(link::ArmAction::place, pose);
  EXPECT_NEAR(found.position[0], static_cast<double>(pose[0]) * counts_a_rad, count / 2 + 1);
  for (std::uint32_t k = 1; k <= 50; ++k) {
    found = ask({9.0F, -5.0F, 29.0F}, k);
    EXPECT_EQ(static_cast<std::uint32_t>(found.position[0]) % count, 0U);
    EXPECT_EQ(static_cast<std::uint32_t>(found.position[1]) % count, 0U);
    EXPECT_EQ(found.position[2] % slide_step, 0);
  }
}

TEST_F(WornArm, HasPlayBetweenMotorAndJoint) {
  open(link::Mode::lock_step);
  const auto first = tell(link::ArmAction::place, {0.0F, 0.0F, 0.1F});
  std::uint32_t k = 0;
  link::Encoders found{};
  double way = 0.0;
  do
    found = ask({9.0F, 0.0F, 0.0F}, ++k), way += 1e-3 * static_cast<double>(found.speed[0]);
  while (found.position[0] == first.position[0] && k < 1000);
  EXPECT_NEAR(way, 0.01 + 0.5 * count / counts_a_rad, 2e-3) << "half of its play, and half a count";
  while (way < 0.1)
    found = ask({9.0F, 0.0F, 0.0F}, ++k), way += 1e-3 * static_cast<double>(found.speed[0]);
  EXPECT_NEAR(found.position[0] / counts_a_rad, way - 0.01, count / counts_a_rad);
}

TEST_F(WornArm, StaysBetweenItsStops) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, {2.0F, 0.0F, 0.1F});
  double most = 0.0;
  for (std::uint32_t k = 1; k <= 2000; ++k) {
    const auto found = ask({20.0F, 0.0F, 0.0F}, k);
    most = std::max(most, found.position[0] / counts_a_rad);
    EXPECT_LT(std::fabs(found.speed[0]), 10.0F);
  }
  EXPECT_GT(most, 2.49);
  EXPECT_LT(most, 2.53);
}

// --- a load

/// Takes and puts down what it is told to.
struct Laden : robots::Scara {
  static constexpr const char* name = "laden";
  struct Mechanics {
    static constexpr bool payload = true;
  };
};
constexpr float slide = 1.25F, earth = 9.8125F;  // kg, m/s^2
constexpr JointValues balance = {0.0F, 0.0F, -slide* earth};
const link::ArmLoad kilogram{1.0F, {0.1F, 0.0F, 0.0F}, {}};

template <class Number>
class LadenArm : public ArmApp<Laden, Number> {
 protected:
  link::Encoders carry(const link::ArmLoad& load) {
    this->send(this->framed(load, 0));
    return this->template answer<link::Encoders>().value();
  }
  /// So many ticks with the slide's own weight balanced.
  link::Encoders balanced(std::uint32_t ticks) {
    link::Encoders last{};
    while (ticks-- > 0)
      last = this->ask(balance, ++number_);
    return last;
  }
  bool refuses(const link::ArmLoad& load) {
    const std::uint32_t before = this->refused(link::Fault::bad_payload);
    this->send(this->framed(load, 0));
    return !this->template answer<link::Encoders>() && this->refused(link::Fault::bad_payload) == before + 1;
  }
  std::uint32_t number_ = 0;
};
using Numbers = ::testing::Types<float, double, Fixed32>;
TYPED_TEST_SUITE(LadenArm, Numbers);

TYPED_TEST(LadenArm, FallsUnderWhatItTakesAndHoldsOnceItIsPutDown) {
  this->open(link::Mode::lock_step);
  this->tell(link::ArmAction::place, pose);
  EXPECT_NEAR(this->balanced(100).speed[2], 0.0F, 1e-6F);
  EXPECT_EQ(this->carry(kilogram).status, byte_of(link::TorqueStatus::ok));
  const float fallen = this->balanced(50).speed[2];
  EXPECT_NEAR(fallen, 0.05F * earth * 1.0F / (slide + 1.0F), 1e-5F) << "(m + 1) a = (m + 1) g - m g";
  this->carry({});
  EXPECT_NEAR(this->balanced(50).speed[2], fallen, 1e-5F);
}

// Its moment of inertia about the first axis grows by that of a body at its place: a push turns it that much slower.
TYPED_TEST(LadenArm, TurnsSlowerByTheLoadsMomentOfInertia) {
  const auto turned = [this](const link::ArmLoad& load) {
    this->open(link::Mode::lock_step);
    this->tell(link::ArmAction::place, {});
    this->carry(load);
    return static_cast<double>(this->ask({1.0F, 0.0F, -slide * earth}, 1).speed[0]);  // after 1 ms from rest
  };
  // Two links in a line, q2 = 0: M = [[a + b + 2 c, b + c], [b + c, b]], of first principles.
  const double a1 = 0.375, a2 = 0.3125, m1 = 4.0, m2 = 2.5;
  const auto expected = [&](double tip, double at, double about) {
    const double link1 = m1 * a1 * a1 / 3.0, link2 = m2 * a2 * a2 / 3.0;
    const double reach = a2 + at;
    const double b = link2 + 1.25 * a2 * a2 + tip * reach * reach + about;
    const double c = a1 * (m2 * a2 / 2.0 + 1.25 * a2 + tip * reach);
    const double a = link1 + (m2 + 1.25 + tip) * a1 * a1;
    const double m11 = a + b + 2.0 * c, m12 = b + c, m22 = b;
    return 1e-3 * m22 / (m11 * m22 - m12 * m12);
  };
  EXPECT_NEAR(turned({}), expected(0.0, 0.0, 0.0), 2e-8);
  EXPECT_NEAR(turned({1.5F, {0.125F, 0.0F, 0.0F}, {0.01F, 0.01F, 0.04F, 0.0F, 0.0F, 0.0F}}), expected(1.5, 0.125, 0.04),
              2e-8);
}

TYPED_TEST(LadenArm, TakesNoLoadThatIsNone) {
  this->open(link::Mode::lock_step);
  this->tell(link::ArmAction::place, pose);
  this->carry(kilogram);
  EXPECT_TRUE(this->refuses({nan_of, {}, {}}));
  EXPECT_TRUE(this->refuses({-1.0F, {}, {}}));
  EXPECT_TRUE(this->refuses({1.0F, {0.3F, 0.0F, 0.0F}, {}})) << "of a reach of 0.25 m";
  EXPECT_TRUE(this->refuses({1.0F, {}, {0.06F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F}}));
  EXPECT_TRUE(this->refuses({1.0F, {0.0F, nan_of, 0.0F}, {}}));
  EXPECT_TRUE(this->refuses({2.1F, {}, {}})) << "2 kg are declared";
  EXPECT_NEAR(this->balanced(10).speed[2], 0.01F * earth / (slide + 1.0F), 1e-5F) << "the kilogram is still there";
  this->send(link::noise::wire(kilogram, 0));
  EXPECT_EQ(this->refused(link::Fault::no_session), 1U);
}

using PlainArm = ArmApp<robots::Scara, float>;
TEST_F(PlainArm, KnowsNoLoadsWhereItsRobotNamesNone) {
  open(link::Mode::lock_step);
  send(framed(kilogram, 0));
  EXPECT_EQ(refused(link::Fault::unknown_type), 1U);
}

// --- noise

/// Drives that are not exact, but for the first.
struct Noisy : robots::Scara {
  static constexpr const char* name = "noisy";
  struct Mechanics {
    static constexpr double torque_noise[] = {0.0, 0.05, 0.2};
  };
};
template <class Number>
class NoisyArm : public ArmApp<Noisy, Number> {
 protected:
  /// What acted on the slide beside its weight, of each tick, N: of its changes of speed.
  std::vector<double> forces(int ticks) {
    this->open(link::Mode::lock_step);
    double last = static_cast<double>(this->tell(link::ArmAction::place, pose).speed[2]);
    std::vector<double> all;
    for (int k = 1; k <= ticks; ++k) {
      const auto speed = static_cast<double>(this->ask(balance, static_cast<std::uint32_t>(k)).speed[2]);
      all.push_back((speed - last) * 1e3 * static_cast<double>(slide)), last = speed;
    }
    return all;
  }
};
TYPED_TEST_SUITE(NoisyArm, Numbers);

TYPED_TEST(NoisyArm, ExertsNoiseOfTheDeclaredDeviationAroundWhatIsAsked) {
  const auto found = this->forces(4000);
  double sum = 0.0, squares = 0.0, neighbours = 0.0, most = 0.0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    sum += found[k], squares += found[k] * found[k], most = std::max(most, std::fabs(found[k]));
    if (k > 0) neighbours += found[k] * found[k - 1];
  }
  const auto n = static_cast<double>(found.size());
  EXPECT_NEAR(sum / n, 0.0, 4.0 * 0.2 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 0.2, 0.008) << "3.6 deviations of the estimate";
  EXPECT_NEAR(neighbours / squares, 0.0, 4.0 / std::sqrt(n)) << "each tick's is its own";
  EXPECT_LT(most, 3.47 * 0.2);
  EXPECT_GT(most, 2.5 * 0.2);
}

TYPED_TEST(NoisyArm, MeetsTheSameNoiseAgainWhereItIsPlacedAnew) {
  const auto once = this->forces(20), again = this->forces(20);
  EXPECT_EQ(once, again);
  EXPECT_NE(once[0], once[1]);
}

TYPED_TEST(NoisyArm, HasNoNoiseWhereItsDrivesAreOff) {
  this->open(link::Mode::lock_step);
  this->tell(link::ArmAction::place, pose);
  link::Encoders found{};
  for (std::uint32_t k = 1; k <= 20; ++k)
    found = this->ask({}, k, DrivePhase::running);
  EXPECT_NE(found.speed[1], 0.0F);
  this->open(link::Mode::lock_step);  // anew: drives are off until efforts come
  this->tell(link::ArmAction::place, {});
  this->tell(link::ArmAction::push, {0.0F, 0.0F, -slide * earth});
  this->send(this->framed(efforts({nan_of}, DrivePhase::running), 1));  // no good efforts yet
  const auto off = this->template answer<link::Encoders>().value();
  EXPECT_EQ(off.speed[1], 0.0F);
}

using NoisyWords = NoisyArm<Fixed32>;
TEST_F(NoisyWords, DrawsWhatOtherNumberSystemsDraw) {
  const auto words = forces(50);
  plant::Draws draws;
  for (const double force : words) {
    draws.next(), draws.next();  // of the joints before it
    EXPECT_NEAR(force, 0.2 * draws.next() / plant::Draws::deviation, 1e-4);
  }
}

// --- late encoders

struct Late : robots::Scara {
  static constexpr const char* name = "late";
  struct Mechanics {
    static constexpr int encoder_delay = 3;
    static constexpr double backlash[] = {0.0, 1e-3, 0.0};
  };
};
struct Prompt : robots::Scara {
  static constexpr const char* name = "prompt";
  struct Mechanics {
    static constexpr double backlash[] = {0.0, 1e-3, 0.0};
  };
};
template <class R, class Number, class Worker = plant::OnThisCore>
class Answers : public ArmApp<R, Number, Worker> {
 public:
  void TestBody() override {}
  std::vector<link::Encoders> of(std::uint32_t ticks) {
    this->open(link::Mode::lock_step);
    std::vector<link::Encoders> all{this->tell(link::ArmAction::place, pose)};
    for (std::uint32_t k = 1; k <= ticks; ++k)
      all.push_back(this->ask({2.0F, -1.0F, 3.0F}, k));
    all.push_back(this->ask({2.0F, -1.0F, 3.0F}, ticks + 5));  // four left out
    return all;
  }
};
template <class Number>
void expect_late() {
  const auto late = Answers<Late, Number>{}.of(20), prompt = Answers<Prompt, Number>{}.of(20);
  for (std::size_t k = 0; k <= 20; ++k) {
    const auto& then = prompt[k < 3 ? 0 : k - 3];
    EXPECT_EQ(late[k].position, then.position) << k;
    EXPECT_EQ(late[k].speed, then.speed) << k;
  }
  EXPECT_NE(prompt[20].position, prompt[17].position);
}
TEST(LateEncoders, AnswerWhatWasThreeTicksAgo) { expect_late<float>(), expect_late<Fixed32>(); }

// --- joints that share drives

/// Encoders are the drives', nut and spline of the quill; each counts 10^7 per unit over all of its turns.
template <class Number>
class QuillArm : public ArmApp<robots::ScaraQuill, Number> {};
TYPED_TEST_SUITE(QuillArm, Numbers);

TYPED_TEST(QuillArm, MovesByTheEffortsOfItsDrives) {
  using S = Scene<robots::ScaraQuill, Gravity, RotorInertia>;
  constexpr JointValues start = {0.3F, -0.4F, 30.0F, 0.2F}, tau = {3.0F, -1.5F, -0.03F, 0.05F};
  this->open(link::Mode::lock_step);
  this->tell(link::ArmAction::place, start);
  Motion<S, double> x;
  Held<S, double> held{};
  for (int i = 0; i < 4; ++i) {
    x.q[i] = static_cast<double>(start[static_cast<std::size_t>(i)]);
    held.tau[i] = static_cast<double>(tau[static_cast<std::size_t>(i)]);
  }
  link::Encoders found{};
  for (std::uint32_t k = 1; k <= 50; ++k)
    found = this->ask(tau, k);
  EXPECT_EQ(found.status, byte_of(link::TorqueStatus::ok));
  for (int k = 0; k < 5000; ++k)
    EXPECT_TRUE(advance<RungeKutta4>(x, 1e-5, held).ok());
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(found.position[k] / static_cast<double>(slide_counts), x.q[i], 2e-7 + 1e-6 * std::fabs(x.q[i])) << i;
    EXPECT_NEAR(static_cast<double>(found.speed[k]), x.qd[i], 1e-5 * (1.0 + std::fabs(x.qd[i]))) << i;
    EXPECT_GT(std::fabs(x.qd[i]), 1e-2) << i;
  }
}

// Stops stand at what the drives declare, not at the joints whose numbers they bear: the nut turns far beyond 0.2.
struct StoppedQuill : robots::ScaraQuill {
  static constexpr const char* name = "stopped_quill";
  struct Mechanics {
    static constexpr EndStops stops{1e3, 1.0};
  };
};
class StoppedQuillArm : public ArmApp<StoppedQuill, float> {};
TEST_F(StoppedQuillArm, HasStopsAtTheLimitsOfItsDrives) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, {0.0F, 0.0F, 65.0F, 0.0F});
  double most = 0.0;
  for (std::uint32_t k = 1; k <= 1000; ++k)
    most = std::max(most, ask({0.0F, 0.0F, 0.2F, 0.0F}, k).position[2] / static_cast<double>(slide_counts));
  EXPECT_GT(most, 69.9);
  EXPECT_LT(most, 70.5);
}

// --- another core makes the steps

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
template <class Number>
class SharedArm : public ArmApp<robots::Scara, Number, LateWorker> {
 protected:
  ~SharedArm() override { LateWorker::job = nullptr; }
};
TYPED_TEST_SUITE(SharedArm, Numbers);

TYPED_TEST(SharedArm, AnswersTheSameInLockStep) {
  const auto expected = Answers<robots::Scara, TypeParam>{}.of(20);
  const auto found = Answers<robots::Scara, TypeParam, LateWorker>{}.of(20);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(found[k].position, expected[k].position) << k;
    EXPECT_EQ(found[k].speed, expected[k].speed) << k;
    EXPECT_EQ(found[k].status, expected[k].status) << k;
  }
}

TYPED_TEST(SharedArm, TellsOfTheTickBeforeInFreeRunning) {
  this->open(link::Mode::free_running);
  this->tell(link::ArmAction::place, pose);
  this->send(this->framed(efforts({}, DrivePhase::running), 1));
  this->tick();
  const auto first = this->template answer<link::Encoders>().value();
  EXPECT_EQ(first.speed[2], 0.0F) << "this tick's steps are still being made";
  EXPECT_NE(LateWorker::job, nullptr);
  this->send(this->framed(efforts({}, DrivePhase::running), 2));
  this->tick();
  EXPECT_NEAR(this->template answer<link::Encoders>()->speed[2], 1e-3F * earth, 1e-6F);
  this->tell(link::ArmAction::place, pose);
  EXPECT_EQ(LateWorker::job, nullptr) << "it was waited for before the arm was placed";
  EXPECT_EQ(this->tell(link::ArmAction::go).speed[2], 0.0F);
}

}  // namespace
}  // namespace axial::apps
