// What the drives and encoders of an arm that a board stands in for do besides: noise, answers that come late, drives
// that joints share.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <robots/scara_quill.hpp>

#include "arm_fixture.hpp"

namespace axial::apps {
namespace {

// --- noise

/// Drives that are not exact, but for the first.
struct Noisy : robots::Scara {
  static constexpr const char* name = "noisy";
  struct Mechanics {
    static constexpr double torque_noise[] = {0.0, 0.05, 0.2};
  };
};
class NoisyArm : public ArmApp<Noisy, float> {
 protected:
  /// What acted on the slide beside its weight, of each tick, N: of its changes of speed.
  std::vector<double> forces(int ticks) {
    open(link::Mode::lock_step);
    double last = static_cast<double>(tell(link::ArmAction::place, pose).speed[2]);
    std::vector<double> all;
    for (int k = 1; k <= ticks; ++k) {
      const auto speed = static_cast<double>(ask(balance, static_cast<std::uint32_t>(k)).speed[2]);
      all.push_back((speed - last) * 1e3 * static_cast<double>(slide)), last = speed;
    }
    return all;
  }
};
TEST_F(NoisyArm, ExertsNoiseOfTheDeclaredDeviationAroundWhatIsAsked) {
  const auto found = forces(4000);
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

TEST_F(NoisyArm, MeetsTheSameNoiseAgainWhereItIsPlacedAnew) {
  const auto once = forces(20), again = forces(20);
  EXPECT_EQ(once, again);
  EXPECT_NE(once[0], once[1]);
}

TEST_F(NoisyArm, HasNoNoiseWhereItsDrivesAreOff) {
  open(link::Mode::lock_step);
  tell(link::ArmAction::place, pose);
  link::Encoders found{};
  for (std::uint32_t k = 1; k <= 20; ++k)
    found = ask({}, k, DrivePhase::running);
  EXPECT_NE(found.speed[1], 0.0F);
  open(link::Mode::lock_step);  // anew: drives are off until efforts come
  tell(link::ArmAction::place, {});
  tell(link::ArmAction::push, {0.0F, 0.0F, -slide * earth});
  send(framed(efforts({nan_of}, DrivePhase::running), 1));  // no good efforts yet
  const auto off = answer<link::Encoders>().value();
  EXPECT_EQ(off.speed[1], 0.0F);
}

TEST(DriveNoise, IsTheSameInWords) {
  using S = Scene<robots::Scara, Gravity, RotorInertia>;
  plant::DriveNoise<S, float, Noisy::Mechanics> numbers;
  plant::DriveNoise<S, Fixed32, Noisy::Mechanics> words;
  for (int k = 0; k < 50; ++k) {
    EffortsOf<S, float> one{};
    EffortsOf<S, Fixed32> other{};
    numbers.add(one), words.add(other);
    EXPECT_EQ(one[0], 0.0F);
    EXPECT_NE(one[2], 0.0F);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(to_real<float>(other)[i], one[i], 1e-6F) << i;
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
/// What happens at index k is what late encoders tell at k + 3.
template <class Number, class X>
void expect_late(const std::vector<X>& motion) {
  plant::ArmEncoders<Late, Number> late;
  plant::ArmEncoders<Prompt, Number> prompt;
  late.place(motion[0]), prompt.place(motion[0]);
  std::vector<std::array<std::int32_t, 3>> told;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    if (k > 0) late.follow(motion[k]), prompt.follow(motion[k]);
    told.push_back({prompt.counts(0), prompt.counts(1), prompt.counts(2)});
    const std::size_t then = k < 3 ? 0 : k - 3;
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(late.counts(i), told[then][static_cast<std::size_t>(i)]) << k;
      EXPECT_TRUE(late.speeds(motion[k])[i] == motion[then].qd[i]) << k;
    }
  }
  EXPECT_NE(told[20], told[17]);
}
TEST(LateEncoders, AnswerWhatWasThreeTicksAgo) {
  std::vector<CompensatedMotion<Late, float>> numbers(21);
  std::vector<Motion<Late, Fixed32>> words(21);
  for (int k = 0; k < 21; ++k) {
    const auto at = static_cast<std::size_t>(k);
    for (int i = 0; i < 3; ++i) {
      numbers[at].q[i] = 0.01F * static_cast<float>(k), numbers[at].qd[i] = static_cast<float>(k + i);
      words[at].q[i].raw = 1'000'000 * k, words[at].qd[i].raw = 1000 * k + i;
    }
  }
  expect_late<float>(numbers), expect_late<Fixed32>(words);
}

// --- joints that share drives

/// Encoders are the drives', nut and spline of the quill; each counts 10^7 per unit over all of its turns.
template <class Number>
class QuillArm : public ArmApp<robots::ScaraQuill, Number> {};
TYPED_TEST_SUITE(QuillArm, Numbers);

TYPED_TEST(QuillArm, MovesByTheEffortsOfItsDrives) {
  constexpr JointValues start = {0.3F, -0.4F, 30.0F, 0.2F}, tau = {3.0F, -1.5F, -0.03F, 0.05F};
  Joints<robots::ScaraQuill, double> u{}, efforts{};
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    u[i] = static_cast<double>(start[k]), efforts[i] = static_cast<double>(tau[k]);
  }
  const auto a = forward_dynamics<robots::ScaraQuill>(u, {}, efforts);
  this->open(link::Mode::lock_step);
  const auto placed = this->tell(link::ArmAction::place, start);
  const auto found = this->ask(tau, 1);  // 1 ms from rest
  EXPECT_EQ(found.status, byte_of(link::TorqueStatus::ok));
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(placed.position[k], u[i] * slide_counts, 40.0) << i << ", of a float";
    EXPECT_NEAR(static_cast<double>(found.speed[k]), 1e-3 * a[i], 1e-4 * std::fabs(1e-3 * a[i])) << i;
    EXPECT_NEAR(found.position[k] - placed.position[k], 0.5e-6 * a[i] * slide_counts, 2.0) << i;
    EXPECT_GT(std::fabs(a[i]), 1.0) << i;
  }
}

// Stops stand at what the drives declare, not at the joints whose numbers they bear: the nut turns far beyond 0.2.
TEST(StopsOfDrives, StandAtTheLimitsOfTheDrives) {
  using S = Scene<robots::ScaraQuill, Gravity, RotorInertia>;
  const Held<S, double> held{};
  const WithEndStops<S, double, Held<S, double>> stops(held, {1e3, 1.0});
  const auto pushed = [&](double nut) {
    Positions<robots::ScaraQuill, double> u{};
    u[2] = nut;
    EffortsOf<S, double> tau{};
    Inputs<S, double> in{};
    DriveStiffness<S, double> told{};
    stops(Instant<S, double>{u, {}, 0.0}, tau, in, told);
    return tau[2];
  };
  EXPECT_EQ(pushed(69.5), 0.0);
  EXPECT_NEAR(pushed(70.5), -500.0, 1e-9);
  EXPECT_NEAR(pushed(-71.0), 1000.0, 1e-9);
}

}  // namespace
}  // namespace axial::apps
