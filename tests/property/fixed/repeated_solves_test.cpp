// Forward dynamics that solves more than once, in fixed point: the same bits whether its stages are functions of their
// own or not. This source is compiled for processors that multiply 32 by 32 bits into 64, and for those that do not.
#include <gtest/gtest.h>
#include <firmware/apps/fixed/golden.hpp>
#include <robots/panda.hpp>

#include <property/untuned/untuned_robots.hpp>

namespace {

using axial::Fixed32;
using axial::apps::fixed::Hash;
using axial::apps::fixed::next_call;
using axial::apps::fixed::Random;

constexpr int states = 400;

template <class Answer>
void add(Hash& hash, const Answer& answer, int joints) {
  for (int i = 0; i < joints; ++i)
    hash.add(answer[i].raw);
  hash.add(static_cast<std::int32_t>(answer.status.code));
}

/// Hash of what `solve` answers to the fixed sequence of states.
template <class R, class Solve>
std::uint64_t bits_of(const Solve& solve) {
  Random random;
  Hash hash;
  for (int k = 0; k < states; ++k) {
    const auto call = next_call<R, Fixed32>(random, k);
    const auto answer = solve(call.q, call.qd, call.tau);
    add(hash, answer, R::chain.size);
    if constexpr (std::is_same_v<decltype(answer), const axial::CertifiedDynamics<R, Fixed32>>)
      for (int i = 0; i < R::chain.size; ++i)
        hash.add(answer.bound[i].raw);
  }
  return hash.value();
}
template <class R>
std::uint64_t bits_of_forward_dynamics() {
  return bits_of<R>([](const auto&... in) { return axial::forward_dynamics<R>(in...); });
}
template <class R>
std::uint64_t bits_of_certified_dynamics() {
  return bits_of<R>([](const auto&... in) { return axial::certified_forward_dynamics<R, Fixed32>(in...); });
}

TEST(RepeatedSolves, TwoOfAnArmOfSevenJoints) {
  EXPECT_EQ(bits_of_forward_dynamics<robots::Panda>(), 0x8d6059b9186478c4U);
  EXPECT_EQ(bits_of_certified_dynamics<robots::Panda>(), 0x4b4c7f93f4a1bb3eU);
}

TEST(RepeatedSolves, SeveralWhereADriveIsMagnified) {
  EXPECT_EQ((bits_of_forward_dynamics<property::SixJoints<4, 0>>()), 0xba407aabc9287011U);
}

}  // namespace
