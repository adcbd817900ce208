#pragma once
/// States at which a kernel that branched on data would show it: every second one is made of corners of the number
/// system and of the robot's limits, the others lie inside the limits.

#include <axial/axial.hpp>

#include <cstdint>
#include <limits>

#include "../states.hpp"

namespace axial::apps::kernels {

/// What a kernel is called with.
template <class Robot>
struct Call {
  MotionState<Robot, float> state{};
  Joints<Robot, float> tau{};
};

inline constexpr float corners[] = {0.0f,
                                    -0.0f,
                                    1.0f,
                                    -1.0f,
                                    0.78539816f,  // eighths, quarters, halves of a turn
                                    -0.78539816f,
                                    1.57079633f,
                                    -1.57079633f,
                                    3.14159265f,
                                    -3.14159265f,
                                    6.28318531f,
                                    1e-40f,  // denormal
                                    -1e-40f,
                                    std::numeric_limits<float>::min(),
                                    1e6f,
                                    -1e12f,
                                    1e30f,
                                    std::numeric_limits<float>::max(),
                                    std::numeric_limits<float>::infinity(),
                                    -std::numeric_limits<float>::infinity(),
                                    std::numeric_limits<float>::quiet_NaN()};
inline constexpr int corner_count = sizeof corners / sizeof corners[0];

/// One of the corners, or a limit of the joint.
inline float next_corner(Random& random, float limit) {
  const int index = static_cast<int>((random.symmetric() + 1.0f) * (0.5f * (corner_count + 2)));
  return index < corner_count ? corners[index] : index == corner_count ? limit : -limit;
}

/// The first calls have one corner everywhere; of the rest every second one mixes them.
template <class Robot>
Call<Robot> next_call(Random& random, int index) {
  Call<Robot> call{next_state<Robot, float>(random), {}};
  for (int i = 0; i < joint_count<Robot>; ++i) {
    auto& [q, qd, qdd] = call.state;
    const auto& joint = reach_of<Robot>.joints[i];
    call.tau[i] = 100.0f * random.symmetric();
    if (index < corner_count) {
      q[i] = qd[i] = qdd[i] = call.tau[i] = corners[index];
    } else if (index % 2 == 0) {
      q[i] = next_corner(random, joint.middle + joint.position);
      qd[i] = next_corner(random, joint.speed);
      qdd[i] = next_corner(random, joint.acceleration);
      call.tau[i] = next_corner(random, 100.0f);
    }
  }
  return call;
}

}  // namespace axial::apps::kernels
