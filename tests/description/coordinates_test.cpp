#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/description/coordinates.hpp>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <vector>

namespace {

using description::Description;
using Positions = std::array<double, 4>;

constexpr double tolerance = 1e-13;  // some dozens of roundings of numbers below 3

// A tree: two links behind the second one; a slide; bodies and drives without any symmetry.
Description robot() {
  Description made;
  made.name = "tree";
  const auto add = [&](const axial::LinkParameters& link) { made.links.push_back({"link", "joint", link}); };
  axial::LinkParameters link;
  link.mass = 2.0;
  link.com[0] = 0.1, link.com[1] = -0.2, link.com[2] = 0.3;
  const double inertia[] = {0.3, 0.4, 0.5, 0.01, -0.02, 0.03};
  std::copy(inertia, inertia + 6, link.inertia_com);
  link.a = 0.3, link.d = 0.2;
  link.alpha = axial::Angle::from_degrees(90.0), link.theta = axial::Angle::from_radians(0.4);
  link.position_min = -1.0, link.position_max = 2.0;
  link.coulomb_forward = 3.0, link.coulomb_backward = -2.0;
  link.spring_stiffness = 5.0, link.spring_rest = 0.25;
  add(link);
  link.alpha = axial::Angle::from_radians(-0.7);
  link.rotor_axis[0] = 0.6, link.rotor_axis[1] = 0.0, link.rotor_axis[2] = 0.8;  // carried by the first link
  add(link);
  link.rotor_axis[1] = 0.5;  // by the second
  link.type = axial::JointType::prismatic;
  add(link);
  link.type = axial::JointType::revolute;
  link.parent = 1, link.b = 0.15, link.gamma = axial::Angle::from_radians(0.3);
  add(link);
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.5, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).matrix();
  for (int i = 0; i < 9; ++i)
    made.tool.rotation[i] = turned(i / 3, i % 3);
  made.tool.position[0] = 0.1, made.tool.position[1] = 0.2, made.tool.position[2] = 0.4;
  return made;
}

// Frames of the links in frame 0, by the row's definition.
std::vector<Eigen::Isometry3d> frames(const Description& made, const Positions& q) {
  const auto x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  std::vector<Eigen::Isometry3d> found;
  for (int i = 0; i < made.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const axial::LinkParameters& p = made.links[k].parameters;
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    if (made.parent(i) >= 0) frame = found[static_cast<std::size_t>(made.parent(i))];
    const bool slides = p.type == axial::JointType::prismatic;
    frame.rotate(Eigen::AngleAxisd(p.gamma.radians, z)).translate(p.b * z);
    frame.rotate(Eigen::AngleAxisd(p.alpha.radians, x)).translate(p.a * x);
    frame.rotate(Eigen::AngleAxisd(p.theta.radians + (slides ? 0.0 : q[k]), z))
        .translate((p.d + (slides ? q[k] : 0.0)) * z);
    found.push_back(frame);
  }
  return found;
}

Eigen::Matrix3d inertia(const axial::LinkParameters& p) {
  const double* j = p.inertia_com;
  Eigen::Matrix3d made;
  made << j[0], j[3], j[4], j[3], j[1], j[5], j[4], j[5], j[2];
  return made;
}

// Bodies, the tool and rotors stand and point where they did.
void expect_same(const Description& before, const Positions& q, const Description& after, const Positions& read) {
  const auto old = frames(before, q), now = frames(after, read);
  for (std::size_t i = 0; i < old.size(); ++i) {
    const auto &p = before.links[i].parameters, &n = after.links[i].parameters;
    const Eigen::Vector3d com = old[i] * Eigen::Vector3d(p.com), new_com = now[i] * Eigen::Vector3d(n.com);
    EXPECT_LT((com - new_com).norm(), tolerance) << "body " << i;
    const Eigen::Matrix3d turned = old[i].linear() * inertia(p) * old[i].linear().transpose();
    EXPECT_LT((turned - now[i].linear() * inertia(n) * now[i].linear().transpose()).norm(), tolerance) << "body " << i;
  }
  Eigen::Matrix3d tool, new_tool;
  for (int i = 0; i < 9; ++i)
    tool(i / 3, i % 3) = before.tool.rotation[i], new_tool(i / 3, i % 3) = after.tool.rotation[i];
  EXPECT_LT((old.back().linear() * tool - now.back().linear() * new_tool).norm(), tolerance);
  const Eigen::Vector3d at = old.back() * Eigen::Vector3d(before.tool.position);
  EXPECT_LT((at - now.back() * Eigen::Vector3d(after.tool.position)).norm(), tolerance);
}

constexpr Positions somewhere = {0.3, -0.6, 0.2, 0.9};

TEST(Coordinates, ANewZeroMovesNothing) {
  for (int joint = 0; joint < 4; ++joint) {
    Description made = robot();
    description::shift_zero(made, joint, 0.125);
    Positions read = somewhere;
    read[static_cast<std::size_t>(joint)] += 0.125;
    expect_same(robot(), somewhere, made, read);
    const auto& link = made.links[static_cast<std::size_t>(joint)].parameters;
    EXPECT_EQ(link.position_min, -0.875);
    EXPECT_EQ(link.position_max, 2.125);
    EXPECT_EQ(link.spring_rest, 0.375);
  }
}

TEST(Coordinates, ATurnedAxisMovesNothing) {
  for (int joint = 0; joint < 4; ++joint) {
    Description made = robot();
    description::turn_axis(made, joint);
    Positions read = somewhere;
    read[static_cast<std::size_t>(joint)] *= -1.0;
    expect_same(robot(), somewhere, made, read);
    const auto& link = made.links[static_cast<std::size_t>(joint)].parameters;
    EXPECT_EQ(link.position_min, -2.0);
    EXPECT_EQ(link.position_max, 1.0);
    EXPECT_EQ(link.coulomb_forward, 2.0);
    EXPECT_EQ(link.coulomb_backward, -3.0);
    EXPECT_EQ(link.spring_rest, -0.25);
  }
}

TEST(Coordinates, ATurnedAxisTurnsTheRotorsThatItCarriesAndItsOwn) {
  const auto direction = [](const Description& made, std::size_t rotor, std::size_t carrier, const Positions& q) {
    return Eigen::Vector3d(frames(made, q)[carrier].linear() *
                           Eigen::Vector3d(made.links[rotor].parameters.rotor_axis));
  };
  Description made = robot();
  description::turn_axis(made, 1);
  Positions read = somewhere;
  read[1] *= -1.0;
  // The joint's own rotor turns by -q of before: about the opposite axis. The next one's is carried along, as it was.
  EXPECT_LT((direction(robot(), 1, 0, somewhere) + direction(made, 1, 0, read)).norm(), tolerance);
  EXPECT_LT((direction(robot(), 2, 1, somewhere) - direction(made, 2, 1, read)).norm(), tolerance);
}

TEST(Coordinates, TurnedTwiceIsTheSameDescription) {
  for (int joint = 0; joint < 4; ++joint) {
    Description made = robot();
    description::turn_axis(made, joint);
    description::turn_axis(made, joint);
    expect_same(robot(), somewhere, made, somewhere);
    EXPECT_NEAR(made.links[3].parameters.b, 0.15, 0.0);
  }
}

TEST(Coordinates, RightAnglesStayExact) {
  Description made = robot();
  description::turn_axis(made, 0);
  EXPECT_EQ(description::exact_degrees(made.links[0].parameters.alpha), -90.0);
}

}  // namespace
