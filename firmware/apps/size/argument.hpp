#pragma once
/// What a probe's harness hands to its kernel: every input that some kernel has, and room for any result.

#include <axial/axial.hpp>

#include <cstddef>

namespace axial::apps::size {

template <class Robot>
struct Argument {
  static constexpr std::size_t largest_result = 64 * sizeof(float);  // the mass matrix of eight joints

  Joints<Robot, float> q, qd, qdd, tau;
  PayloadBody<float> payload;
  ForceVector<Vec3<float>, Vec3<float>> tip_wrench;
  Vec3<float> gravity;
  GivenMotion<float> base_motion;
  Joints<Robot, ForceVector<Vec3<float>, Vec3<float>>> wrenches;
  Joints<Robot, SinCos<float>> turns;
  alignas(8) std::byte result[largest_result];
};

}  // namespace axial::apps::size
