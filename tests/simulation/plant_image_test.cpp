// The image that integrates a robot, on the host's board: it makes what the host makes, step by step.
#include <firmware/apps/plant/plant.hpp>
#include <host_sim/plants/real_time/board.hpp>
#include <robots/scara.hpp>

#include <gtest/gtest.h>

#include <sstream>

#include <hal/host/board.hpp>

using namespace host_sim::real_time;
using axial::hal::HostBoard;
using R = robots::Scara;

namespace {

/// Efforts that differ from tick to tick, from a pose where the arm is bent.
Driven<R> motion(int ticks) {
  Driven<R> driven;
  driven.start = {0.3, -0.5, 0.1}, driven.travel = {1.0, 1.0, 1.0};
  for (int k = 0; k < ticks; ++k)
    driven.efforts.push_back({2.0 + 0.25 * k, -1.0 + 0.125 * k, -12.25 - 0.0625 * k});
  return driven;
}

template <class T>
struct Board : image::Plant<HostBoard, R, T> {
  using Base = image::Plant<HostBoard, R, T>;
  using Base::Base;
  template <class Method>
  static void step(void* plant) {
    static_cast<Base*>(plant)->template move<Method>();
  }
};

std::vector<Reported> states_of(const std::string& printed) {
  std::vector<Reported> states;
  std::istringstream lines(printed);
  for (std::string line, cell; std::getline(lines, line);) {
    if (line.rfind("state,", 0) != 0) continue;
    std::istringstream cells(line.substr(6));
    std::getline(cells, cell, ',');
    states.push_back({std::stoul(cell), {}});
    while (std::getline(cells, cell, ','))
      states.back().words.push_back(static_cast<std::uint32_t>(std::stoul(cell, nullptr, 16)));
  }
  return states;
}

/// What the board prints of a motion.
template <class T>
std::string printed(std::vector<std::uint32_t> words) {
  HostBoard::fresh();
  HostBoard::state.count = 17;
  words.resize(image::input_words<R>);
  Board<T> plant(words.data());
  plant.run(Board<T>::template step<axial::SemiImplicitEuler>, Board<T>::template step<axial::RungeKutta4>);
  return HostBoard::state.printed;
}

template <class T>
struct PlantImage : testing::Test {
  using OnHost = OnBoard<R, T>;
  const Driven<R> driven = motion(4);
  const OnHost host{driven};
};
using Numbers = testing::Types<float, axial::Fixed32>;
TYPED_TEST_SUITE(PlantImage, Numbers, );

}  // namespace

TYPED_TEST(PlantImage, HasTheHostsBitsByEveryMethodAndStep) {
  for (const bool runge_kutta : {false, true})
    for (std::uint32_t choice = 0; choice < image::choices; ++choice) {
      const auto count = static_cast<std::uint32_t>(image::steps_per_tick[choice]);
      const Steps steps{runge_kutta, choice, 6 * count, 1};  // two ticks more than there are efforts
      const auto states = states_of(printed<TypeParam>(this->host.words(steps)));
      ASSERT_EQ(states.size(), 6 * count);
      EXPECT_EQ(states.back().steps, 6 * count);
      const auto judged = this->host.judge(steps, states, {});
      EXPECT_TRUE(judged.same_bits) << runge_kutta << ", " << count;
      EXPECT_EQ(judged.difference, 0.0);
    }
}

TYPED_TEST(PlantImage, TellsEverySoManySteps) {
  const Steps all{true, 0, 6, 1}, some{true, 0, 6, 3};
  const auto each = states_of(printed<TypeParam>(this->host.words(all)));
  const auto few = states_of(printed<TypeParam>(this->host.words(some)));
  ASSERT_EQ(few.size(), 2U);
  EXPECT_EQ(few[0].words, each[2].words);
  EXPECT_EQ(few[1].words, each[5].words);
  const auto text = printed<TypeParam>(this->host.words(some));
  EXPECT_NE(text.find("count,17\nstate,3,"), std::string::npos);
  EXPECT_NE(text.find("\nsteps,6,17,17\n"), std::string::npos);
}

TYPED_TEST(PlantImage, AStateIsAllOfItsWords) {
  image::MotionOf<R, TypeParam> x;
  std::uint32_t word = 0;
  image::each_word(x, [&](auto& value) { image::put_word(value, ++word); });
  EXPECT_EQ(word, image::state_words<R>);
  for (int i = 0; i < 3; ++i) {
    const auto joint = static_cast<std::uint32_t>(i);
    EXPECT_EQ(image::word_of(x.q[i]), 1 + joint);
    EXPECT_EQ(image::word_of(x.qd[i]), 4 + joint);
    EXPECT_EQ(image::word_of(x.q_rest[i]), 7 + joint);
    EXPECT_EQ(image::word_of(x.qd_rest[i]), 10 + joint);
  }
}

// From the middle of a motion, with what rounding left: what a model of the core's timing is shown.
TYPED_TEST(PlantImage, GoesOnWhereAStateLeftOff) {
  auto words = this->host.words({true, 0, 4, 1});
  const auto each = states_of(printed<TypeParam>(words));
  const std::size_t start = image::head_words, efforts = start + image::state_words<R>;
  words[image::steps] = 1, words[image::effort_ticks] = 1;
  std::copy(each[1].words.begin(), each[1].words.end(), words.begin() + static_cast<std::ptrdiff_t>(start));
  std::copy_n(words.begin() + static_cast<std::ptrdiff_t>(efforts + std::size_t{2} * 3), 3,
              words.begin() + static_cast<std::ptrdiff_t>(efforts));
  EXPECT_EQ(states_of(printed<TypeParam>(words)).at(0).words, each[2].words);
}

TYPED_TEST(PlantImage, FallsFreelyWithoutEfforts) {
  const OnBoard<R, TypeParam> host(this->driven.start);
  const auto states = states_of(printed<TypeParam>(host.words({true, 0, 10, 10})));
  ASSERT_EQ(states.size(), 1U);
  EXPECT_TRUE(host.judge({true, 0, 10, 10}, states, {}).same_bits);
  EXPECT_LT(host.energy_drift(states), 1e-5) << "J; what falls exchanges 6e-3";
}

// Half g t^2 of the slide, which points down, in 4 ms; a kilogram at the end turns no joint.
TYPED_TEST(PlantImage, FallsAsFarAsTheBooksSay) {
  const OnBoard<R, TypeParam> host(this->driven.start);
  const std::vector<axial::Joints<R, double>> reference(4, {0.3, -0.5, 0.1});
  const Steps steps{true, 0, 4, 1};
  const auto judged = host.judge(steps, states_of(printed<TypeParam>(host.words(steps))), reference);
  ASSERT_EQ(judged.errors.size(), 4U);
  constexpr double fallen = 0.5 * 9.8125 * 0.004 * 0.004;  // m
  EXPECT_NEAR(judged.positions.back()[0], 0.3, 1e-7);
  EXPECT_NEAR(judged.positions.back()[2], 0.1 + fallen, 1e-8);
  EXPECT_NEAR(judged.errors.back(), fallen, 1e-7) << "off where it began, by the largest joint's way";
}

TYPED_TEST(PlantImage, AWrongBitIsSeen) {
  const Steps steps{true, 0, 4, 1};
  auto states = states_of(printed<TypeParam>(this->host.words(steps)));
  states[2].words[1] ^= 64U;
  const auto judged = this->host.judge(steps, states, {});
  EXPECT_FALSE(judged.same_bits);
  states[2].words[1] ^= 64U;
  states[3].words[2] ^= 64U;
  EXPECT_FALSE(this->host.judge(steps, states, {}).same_bits);
  EXPECT_GT(this->host.judge(steps, states, {}).difference, 0.0);
}
