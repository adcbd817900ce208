// What one lane of a batch's answers holds, and what one state's: lists of numbers and statuses to compare.
#pragma once

#include <axial/batch.hpp>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <property/support.hpp>

namespace property {

inline double number_in(double x, int) { return x; }
inline double number_in(float x, int) { return static_cast<double>(x); }
template <class T, int N>
double number_in(const axial::Batch<T, N>& x, int lane) {
  return static_cast<double>(x[lane]);
}
inline axial::Status status_in(const axial::Status& status, int) { return status; }
template <class T, int N>
axial::Status status_in(const axial::BatchStatus<T, N>& status, int lane) {
  return status[lane];
}

/// Everything that kernels answered for one state.
class Answers {
 public:
  struct Number {
    const char* kernel;
    double value, size;  ///< `size` is the largest value of the same answer
  };
  std::vector<Number> numbers;
  std::vector<axial::Status> statuses;

  template <class Answer>
  void add(const char* kernel, const Answer& answer, int lane) {
    const std::size_t begin = numbers.size();
    kernel_ = kernel, lane_ = lane;
    list(answer);
    if constexpr (has_status(static_cast<const Answer*>(nullptr))) statuses.push_back(status_in(answer.status, lane));
    double size = 0.0;
    for (std::size_t i = begin; i < numbers.size(); ++i)
      size = std::fmax(size, std::fabs(numbers[i].value));
    for (std::size_t i = begin; i < numbers.size(); ++i)
      numbers[i].size = size;
  }

 private:
  template <class Answer>
  static constexpr auto has_status(const Answer* answer) -> decltype(answer->status, true) {
    return true;
  }
  static constexpr bool has_status(const void*) { return false; }

  template <class T>
  void number(const T& x) {
    numbers.push_back({kernel_, number_in(x, lane_), 0.0});
  }
  template <class T>
  void vector(const axial::Vec3<T>& v) {
    number(v.x), number(v.y), number(v.z);
  }
  template <class T>
  void pose(const axial::WorldPose<T>& pose) {
    vector(pose.rotation.x), vector(pose.rotation.y), vector(pose.rotation.z), vector(pose.position);
  }
  template <class T, int N, int M>
  void square(const T (&values)[N][M]) {
    for (const auto& row : values)
      for (const T& x : row)
        number(x);
  }
  template <class S, class T>
  void list(const axial::Joints<S, T>& values) {
    for (const T& x : values.values)
      number(x);
  }
  template <class S, class T>
  void list(const axial::FloatingDynamics<S, T>& answer) {
    list(static_cast<const axial::Joints<S, T>&>(answer));
    vector(answer.base_acceleration.angular), vector(answer.base_acceleration.linear);
  }
  template <class S, class T>
  void list(const axial::MassMatrix<S, T>& m) {
    for (int i = 0; i < m.size; ++i)
      for (int j = 0; j <= i; ++j)
        number(m(i, j));
  }
  template <class S, class T>
  void list(const axial::Separated<S, T>& terms) {
    square(terms.A), square(terms.B), square(terms.C);
    for (const T& x : terms.G)
      number(x);
  }
  template <class S, class T>
  void list(const axial::MomentumTerms<S, T>& terms) {
    list(terms.momentum), list(terms.drift);
  }
  template <class S, class T>
  void list(const axial::ForwardKinematics<S, T>& answer) {
    for (const auto& frame : answer.frames)
      pose(frame);
    pose(answer.tool);
  }
  template <class S, class T>
  void list(const axial::Jacobian<S, T>& answer) {
    for (const auto& column : answer.columns)
      vector(column.angular), vector(column.linear);
  }

  const char* kernel_ = "";
  int lane_ = 0;
};

inline void expect_statuses(const Answers& got, const Answers& wanted) {
  ASSERT_EQ(got.statuses.size(), wanted.statuses.size());
  for (std::size_t i = 0; i < got.statuses.size(); ++i) {
    EXPECT_EQ(got.statuses[i].code, wanted.statuses[i].code) << i;
    EXPECT_EQ(got.statuses[i].joint, wanted.statuses[i].joint) << i;
  }
}
inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
inline void expect_same_bits(const Answers& got, const Answers& wanted) {
  ASSERT_EQ(got.numbers.size(), wanted.numbers.size());
  for (std::size_t i = 0; i < got.numbers.size(); ++i)
    EXPECT_PRED2(same_bits, got.numbers[i].value, wanted.numbers[i].value) << got.numbers[i].kernel;
  expect_statuses(got, wanted);
}
/// The same bits where no multiply-add is fused, for compilers fuse in a batch what they do not in one state; else to
/// `rounding`, relative to the largest number of an answer.
inline void expect_agreement(const Answers& got, const Answers& wanted, double rounding) {
#if defined(__FMA__) || defined(__aarch64__)
  ASSERT_EQ(got.numbers.size(), wanted.numbers.size());
  for (std::size_t i = 0; i < got.numbers.size(); ++i)
    EXPECT_NEAR(got.numbers[i].value, wanted.numbers[i].value, rounding * wanted.numbers[i].size)
        << got.numbers[i].kernel;
  expect_statuses(got, wanted);
#else
  static_cast<void>(rounding);
  expect_same_bits(got, wanted);
#endif
}

}  // namespace property
