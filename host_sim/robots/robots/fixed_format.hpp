// How exact the firmware's fixed point is: what it rounds at its border, and what is certified of its torques.
#pragma once

#include <string>
#include <vector>

namespace host_sim {

/// One value per joint, or per drive that joints share.
struct FixedFormat {
  std::vector<double> q, qd, qdd;  ///< half a unit of the formats: what a set-point is moved by at most; rad or m, s
  std::vector<double> torque;      ///< certified error of the torque for the motion as rounded, N m or N
};

/// Of the 32-bit words of a robot's feed-forward, rounded to nearest, products exact. Throws as find_robot() does.
FixedFormat fixed32_format(const std::string& robot);

}  // namespace host_sim
