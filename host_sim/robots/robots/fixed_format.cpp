#include <host_sim/robots/robots/fixed_format.hpp>

#include <host_sim/robots/robots/driven_robot.hpp>
#include <host_sim/robots/robots/robot.hpp>

#include <axial/fixed.hpp>
#include <robots/robots.hpp>

#include <cmath>

namespace host_sim {

namespace {

/// Beyond half a unit: angles are rounded to 2^-20 of theirs.
constexpr double border_slack = 1.0 + 0x1p-19;

template <class Values>
std::vector<double> half_units() {
  std::vector<double> halves;
  for (int i = 0; i < Values::size; ++i)
    halves.push_back(border_slack * std::ldexp(0.5, -Values::exponent(i)));
  return halves;
}

template <class Robot>
std::vector<double> half_units_of_positions() {
  std::vector<double> halves = half_units<axial::Positions<Robot, axial::Fixed32>>();
  const double half_angle = border_slack * 0x1p-33 * 2.0 * std::acos(-1.0);
  for (std::size_t i = 0; i < halves.size(); ++i)
    if (DrivesOf<Robot>::chain.links[i].type == axial::JointType::revolute) halves[i] = half_angle;
  return halves;
}

template <class Robot>
std::vector<double> certified_errors() {
  std::vector<double> errors;
  for (const double error : axial::error_bound<Robot>(axial::algorithm::inverse_dynamics).of)
    errors.push_back(error);
  return errors;
}

template <class Robot>
FixedFormat format_of() {
  using axial::Fixed32;
  return {half_units_of_positions<Robot>(), half_units<axial::Velocities<Robot, Fixed32>>(),
          half_units<axial::Accelerations<Robot, Fixed32>>(), certified_errors<Robot>()};
}

}  // namespace

FixedFormat fixed32_format(const std::string& robot) {
  FixedFormat format;
  const auto take = [&](auto named) {
    if (robot == named.name) format = format_of<typename decltype(named)::Robot>();
  };
  robots::All::for_each(take);
  robots::SharedDrives::for_each(take);
  if (format.q.empty()) find_robot(robot);  // says which there are
  return format;
}

}  // namespace host_sim
