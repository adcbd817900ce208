// Every line of the list of algorithms, without its name: what the calls that are made of it answer is the same.
#include <gtest/gtest.h>
#include <axial/algorithm.hpp>
#include <axial/axial.hpp>
#include <robots/planar2r.hpp>

#include <cstring>
#include <set>
#include <string>

namespace {

using namespace axial;
using robots::Planar2r;
using M = Model<2, Gravity, RotorInertia>;

constexpr float numbers[5][2] = {{0.4F, -0.7F}, {1.1F, -0.3F}, {2.0F, -1.0F}, {0.5F, 3.0F}, {-2.0F, 1.5F}};
template <class R>
Joints<R, float> values(int k) {
  return {numbers[k][0], numbers[k][1]};
}

// The arguments of a call, so many.
#define FIRST_1(OF) OF(0)
#define FIRST_2(OF) FIRST_1(OF), OF(1)
#define FIRST_3(OF) FIRST_2(OF), OF(2)
#define FIRST_5(OF) FIRST_3(OF), OF(3), OF(4)
#define AS_VALUES(k) values<Planar2r>(k)
#define OF_A_MODEL(k) values<M>(k)
#define AS_AN_ARRAY(k) numbers[k]

// Answers begin with a number.
template <class Answer>
float first_of(const Answer& answer) {
  float first = 0.0F;
  std::memcpy(&first, &answer, sizeof first);
  return first;
}
template <class Algorithm>
float as_a_value(Algorithm) {
  const Inputs<Planar2r, float> in{};
  const auto q = values<Planar2r>(0), qd = values<Planar2r>(1), x = values<Planar2r>(2);
  if constexpr (Algorithm::joint_values == 5)
    return first_of(Algorithm::template run<Planar2r>(
        q, qd, x, HigherDerivatives<Planar2r, float>{values<Planar2r>(3), values<Planar2r>(4)}, in));
  else
    return first_of(Algorithm::template run<Planar2r>(q, qd, x, in));
}

TEST(EveryAlgorithm, OnArraysAndAsAValueIsThatOnJointValues){
#define LISTED(function, count, order, answer, type, value)                                   \
  {                                                                                           \
    const float wanted = first_of(function<Planar2r>(FIRST_##count(AS_VALUES)));              \
    EXPECT_EQ(first_of(function<Planar2r>(FIRST_##count(AS_AN_ARRAY))), wanted) << #function; \
    EXPECT_EQ(as_a_value(algorithm::value), wanted) << #function;                             \
  }
    AXIAL_ALGORITHMS_OVER_MODELS(LISTED) AXIAL_ALGORITHMS_OF_CHOICE(LISTED)
#undef LISTED
}

TEST(EveryAlgorithm, OverAModelTakesArrays) {
  M model;
  for (const LinkParameters& link : Planar2r::chain.links)
    ASSERT_TRUE(model.add(link));
#define LISTED(function, count, order, answer, type, value)        \
  EXPECT_EQ(first_of(function(model, FIRST_##count(AS_AN_ARRAY))), \
            first_of(function(model, FIRST_##count(OF_A_MODEL))))  \
      << #function;
  AXIAL_ALGORITHMS_OVER_MODELS(LISTED)
  AXIAL_ALGORITHMS_OF_CHOICE(LISTED)
#undef LISTED
}

TEST(EveryAlgorithm, HasANameOfItsOwn) {
  std::set<std::string> names;
  int count_of_lines = 0;
#define LISTED(function, count, order, answer, type, value) names.insert(algorithm::value.name), ++count_of_lines;
  AXIAL_ALGORITHMS(LISTED)
  AXIAL_ALGORITHMS_OF_CHOICE(LISTED)
#undef LISTED
  EXPECT_EQ(static_cast<int>(names.size()), count_of_lines);
}

}  // namespace
