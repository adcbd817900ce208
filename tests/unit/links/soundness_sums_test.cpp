#include <gtest/gtest.h>
#include <axial/links/soundness.hpp>
#include <cmath>
#include <limits>

using namespace axial;

namespace {

using Code = Status::Code;

template <class T>
class SoundnessSums : public testing::Test {
 public:
  using Limits = std::numeric_limits<T>;
  static Code of_angles(std::initializer_list<T> angles) {
    Soundness<T> s;
    for (const T& q : angles)
      s.angle(q);
    return s.status().code;
  }
  static Code of_numbers(std::initializer_list<T> numbers) {
    Soundness<T> s;
    for (const T& x : numbers)
      s.number(x);
    return s.status().code;
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(SoundnessSums, Reals);

}  // namespace

TYPED_TEST(SoundnessSums, NothingIsSound) {
  EXPECT_EQ(this->of_numbers({}), Code::ok);
  EXPECT_EQ(Soundness<TypeParam>{}.status().joint, -1);
}

TYPED_TEST(SoundnessSums, NaNAndInfinityAreFoundWhereverTheyStand) {
  using T = TypeParam;
  for (const T bad : {T(NAN), T(-NAN), T(INFINITY), T(-INFINITY)}) {
    for (const auto& numbers : {std::initializer_list<T>{bad, T(1), T(2)}, {T(1), bad, T(2)}, {T(1), T(2), bad}}) {
      EXPECT_EQ(this->of_angles(numbers), Code::not_finite) << bad;
      EXPECT_EQ(this->of_numbers(numbers), Code::not_finite) << bad;
    }
    Soundness<T> slide, turn;
    slide.position(Prismatic{}, bad), turn.position(Revolute{}, bad);
    EXPECT_EQ(slide.status().code, Code::not_finite);
    EXPECT_EQ(turn.status().code, Code::not_finite);
  }
}

TYPED_TEST(SoundnessSums, OppositeInfinitiesDoNotCancel) {
  EXPECT_EQ(this->of_numbers({TypeParam(INFINITY), TypeParam(-INFINITY)}), Code::not_finite);
  EXPECT_EQ(this->of_angles({TypeParam(INFINITY), TypeParam(-INFINITY)}), Code::not_finite);
}

TYPED_TEST(SoundnessSums, NumbersMayBeAsLargeAsTheyLikeWhileTheirSumIsFinite) {
  using T = TypeParam;
  const T most = std::numeric_limits<T>::max();
  EXPECT_EQ(this->of_numbers({most, -most, T(1e30), -std::numeric_limits<T>::denorm_min()}), Code::ok);
  EXPECT_EQ(this->of_numbers({most, most}), Code::not_finite);
  Soundness<T> slide;
  slide.position(Prismatic{}, T(1e30));
  EXPECT_EQ(slide.status().code, Code::ok) << "a slide's position is no angle";
}

TYPED_TEST(SoundnessSums, TheLargestAnglesThemselvesAreInRange) {
  using T = TypeParam;
  const T most = largest_angles<T>, more = most * T(1.000002);  // a little more than a last bit of an upper word
  EXPECT_EQ(most, sizeof(T) == 4 ? T(8192) : T(524288));
  for (const T sign : {T(1), T(-1)}) {
    EXPECT_EQ(this->of_angles({sign * most}), Code::ok);
    EXPECT_EQ(this->of_angles({sign * more}), Code::angle_range);
  }
  EXPECT_EQ(this->of_angles({-more, more}), Code::angle_range) << "opposite angles do not cancel";
  Soundness<T> turn;
  turn.position(Revolute{}, -more);
  EXPECT_EQ(turn.status().code, Code::angle_range);
}

TYPED_TEST(SoundnessSums, NotFiniteGoesBeforeLargeAngles) {
  using T = TypeParam;
  Soundness<T> s;
  s.angle(T(4) * largest_angles<T>), s.number(T(NAN)), s.number(Zero{});
  EXPECT_EQ(s.status().code, Code::not_finite);
  EXPECT_EQ(s.status().joint, -1);
}

TYPED_TEST(SoundnessSums, IsAConstant) {
  using T = TypeParam;
  constexpr Status status = [] {
    Soundness<T> s;
    s.angle(T(1)), s.number(T(2)), s.number(Zero{});
    return s.status();
  }();
  static_assert(status.ok());
}
