#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/description/coordinates.hpp>

#include <algorithm>
#include <utility>

namespace description {
namespace {

axial::Angle half_turned(const axial::Angle& angle) {
  return canonical_angle(static_cast<long double>(angle.radians) + 3.14159265358979323846264338327950288L);
}
axial::Angle negated(const axial::Angle& angle) { return canonical_angle(-static_cast<long double>(angle.radians)); }

// -0 would be written as such.
double negated(double value) { return value == 0.0 ? 0.0 : -value; }
void negate(double& value) { value = negated(value); }

// Components along y and z of the frame change their sign.
void turn(double (&vector)[3]) { negate(vector[1]), negate(vector[2]); }

void swap_negated(double& low, double& high) {
  const double before = low;
  low = negated(high), high = negated(before);
}

void turn_body(axial::LinkParameters& link) {
  turn(link.com);
  negate(link.inertia_com[3]), negate(link.inertia_com[4]);
}

// The row Rx(alpha) Tx(a) Rz(theta) Tz(d), seen from a frame that is turned: Rz and Tz change their sense there.
void turn_row_before(axial::LinkParameters& link) {
  link.gamma = negated(link.gamma);
  negate(link.b);
  link.alpha = half_turned(link.alpha);
}
void turn_row(axial::LinkParameters& link) {
  link.alpha = half_turned(link.alpha);
  link.theta = negated(link.theta);
  negate(link.d);
}

void turn_drive(axial::LinkParameters& link) {
  swap_negated(link.position_min, link.position_max);
  swap_negated(link.coulomb_backward, link.coulomb_forward);
  negate(link.spring_rest);
  for (double& component : link.rotor_axis)
    negate(component);
}

// Rx(pi) before a pose.
void turn(axial::FixedPose& pose) {
  for (int i = 3; i < 9; ++i)
    negate(pose.rotation[i]);
  turn(pose.position);
}

int carrier(const Description& robot, int joint) {
  const int given = robot.links[static_cast<std::size_t>(joint)].parameters.rotor_carrier;
  return given == axial::LinkParameters::previous ? robot.parent(joint) : given;
}

}  // namespace

void shift_zero(Description& robot, int joint, double offset) {
  axial::LinkParameters& link = robot.links[static_cast<std::size_t>(joint)].parameters;
  if (link.type == axial::JointType::prismatic)
    link.d -= offset;
  else
    link.theta = canonical_angle(static_cast<long double>(link.theta.radians) - static_cast<long double>(offset));
  link.position_min += offset, link.position_max += offset;
  if (link.spring_stiffness != 0.0) link.spring_rest += offset;
}

void turn_axis(Description& robot, int joint) {
  for (int i = 0; i < robot.size(); ++i) {
    axial::LinkParameters& link = robot.links[static_cast<std::size_t>(i)].parameters;
    if (robot.parent(i) == joint) turn_row_before(link);
    if (carrier(robot, i) == joint) turn(link.rotor_axis);
  }
  axial::LinkParameters& own = robot.links[static_cast<std::size_t>(joint)].parameters;
  turn_row(own), turn_body(own), turn_drive(own);
  if (joint + 1 == robot.size()) turn(robot.tool);
}

}  // namespace description
