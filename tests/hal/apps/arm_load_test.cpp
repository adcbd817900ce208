// An arm that a board stands in for takes a load and puts it down.

#include "arm_fixture.hpp"

namespace axial::apps {
namespace {

/// Takes and puts down what it is told to.
struct Laden : robots::Scara {
  static constexpr const char* name = "laden";
  struct Mechanics {
    static constexpr bool payload = true;
  };
};
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

}  // namespace
}  // namespace axial::apps
