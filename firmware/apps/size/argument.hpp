#pragma once
/// What a probe's harness hands to its kernel: every input that some kernel has, and room for any result.

#include <board.hpp>

#include <cstddef>

#include <axial/axial.hpp>

namespace axial::apps::size {

inline constexpr bool roomy = hal::Board::ram_bytes >= 16 * 1024;

/// Room for the largest of results: of derivatives, values of joints with a status and three matrices; of a regressor
/// that meets the speeds, ten columns a joint. Where RAM is short, for a mass matrix, of eight joints or more: a
/// SCARA's derivatives fit in.
template <class Robot>
constexpr std::size_t result_entries() {
  constexpr auto n = static_cast<std::size_t>(joint_count<Robot>);
  constexpr std::size_t derivatives = n * (3 * n + 1) + 2, columns = 10 * n;
  if (roomy) return derivatives > columns ? derivatives : columns;
  return n > 8 ? n * n : 64;
}

/// In numbers T: the values of joints, and room for the result.
template <class Robot, class T>
struct Argument {
  using Number = T;
  static constexpr std::size_t largest_result = result_entries<Robot>() * sizeof(T);

  Positions<Robot, T> q;
  Velocities<Robot, T> qd;
  Accelerations<Robot, T> qdd;
  Efforts<Robot, T> tau;
  alignas(8) std::byte result[largest_result];
};

/// In float: with the inputs of every scene, and room for separated terms where a board has it.
template <class Robot>
struct Argument<Robot, float> {
  using Number = float;
  static constexpr std::size_t terms_bytes = roomy ? sizeof(Separated<Robot, float>) : 4;
  static constexpr std::size_t result_bytes = result_entries<Robot>() * sizeof(float);
  static constexpr std::size_t largest_result = terms_bytes > result_bytes ? terms_bytes : result_bytes;

  Joints<Robot, float> q, qd, qdd, tau;
  PayloadBody<float> payload;
  ForceVector<Vec3<float>, Vec3<float>> tip_wrench;
  Vec3<float> gravity;
  GivenMotion<float> base_motion;
  Joints<Robot, ForceVector<Vec3<float>, Vec3<float>>> wrenches;
  Joints<Robot, SinCos<float>> turns;
  alignas(8) std::byte terms[terms_bytes];  ///< any numbers
  alignas(8) std::byte result[largest_result];
};

}  // namespace axial::apps::size
