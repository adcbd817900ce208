// Every name of a link's builder writes its own fields and no other.
#include <gtest/gtest.h>
#include <axial/robot/classical.hpp>
#include <axial/robot/link.hpp>
#include <vector>

using namespace axial;

namespace {

/// All fields as numbers, in the order of LinkParameters.
std::vector<double> fields(const LinkParameters& p) {
  const auto& w = p.water;
  std::vector<double> all = {
      double(p.type), double(p.parent), p.b, p.gamma.radians, p.a, p.alpha.radians, p.d, p.theta.radians, p.mass};
  all.insert(all.end(), p.com, p.com + 3);
  all.insert(all.end(), p.inertia_com, p.inertia_com + 6);
  all.insert(all.end(), p.rotor_axis, p.rotor_axis + 3);
  all.push_back(double(p.rotor_carrier));
  all.insert(all.end(), {p.rotor_inertia, p.gear, p.viscous, p.coulomb_forward, p.coulomb_backward, p.static_friction,
                         p.stribeck_speed, p.smooth_speed, p.spring_stiffness, p.spring_rest, p.stiffness,
                         p.position_min, p.position_max, p.speed_limit, p.acceleration_limit, p.effort_limit});
  all.insert(all.end(), w.added_mass, w.added_mass + 3);
  all.insert(all.end(), w.added_inertia, w.added_inertia + 3);
  all.push_back(w.displaced_mass);
  all.insert(all.end(), w.centre, w.centre + 3);
  all.insert(all.end(), w.drag_linear, w.drag_linear + 6);
  all.insert(all.end(), w.drag_quadratic, w.drag_quadratic + 6);
  return all;
}

/// `built` is a plain link but for what `write` writes into its fields.
template <class Built, class Write>
void expect_only(const char* name, const Built& built, const Write& write) {
  LinkParameters expected = revolute().parameters();
  write(expected);
  const auto is = fields(built.parameters()), should = fields(expected);
  for (std::size_t k = 0; k < is.size(); ++k)
    EXPECT_EQ(is[k], should[k]) << name << ", field " << k;
}
#define EXPECT_ONLY(call, ...) expect_only(#call, revolute().call, [](LinkParameters& p) { __VA_ARGS__; })
#define EXPECT_CLASSICAL(call, ...) \
  expect_only(#call, classical_revolute().call, [](LinkParameters& p) { __VA_ARGS__; })

}  // namespace

TEST(LinkBuilder, GeometryWritesItsOwnFields) {
  EXPECT_ONLY(a(2), p.a = 2);
  EXPECT_ONLY(a_previous(2), p.a = 2);
  EXPECT_ONLY(alpha(0.5), p.alpha = Angle::from_radians(0.5));
  EXPECT_ONLY(alpha_deg(30), p.alpha = Angle::from_degrees(30));
  EXPECT_ONLY(alpha_previous(0.5), p.alpha = Angle::from_radians(0.5));
  EXPECT_ONLY(alpha_previous_deg(30), p.alpha = Angle::from_degrees(30));
  EXPECT_ONLY(d(2), p.d = 2);
  EXPECT_ONLY(theta(0.5), p.theta = Angle::from_radians(0.5));
  EXPECT_ONLY(theta_deg(30), p.theta = Angle::from_degrees(30));
  EXPECT_ONLY(branch(0.5, 2), p.gamma = Angle::from_radians(0.5), p.b = 2);
  EXPECT_ONLY(branch_deg(30, 2), p.gamma = Angle::from_degrees(30), p.b = 2);
  EXPECT_ONLY(parent(3), p.parent = 3);
  EXPECT_CLASSICAL(a(2), p.a = 2);
  EXPECT_CLASSICAL(alpha(0.5), p.alpha = Angle::from_radians(0.5));
  EXPECT_CLASSICAL(alpha_deg(30), p.alpha = Angle::from_degrees(30));
  EXPECT_EQ(prismatic().parameters().type, JointType::prismatic);
  EXPECT_EQ(classical_prismatic().parameters().type, JointType::prismatic);
}

TEST(LinkBuilder, BodiesWriteTheirOwnFields) {
  EXPECT_ONLY(mass(2), p.mass = 2);
  EXPECT_ONLY(com(1, 2, 3), p.com[0] = 1, p.com[1] = 2, p.com[2] = 3);
  EXPECT_ONLY(inertia_com(1, 2, 3), p.inertia_com[0] = 1, p.inertia_com[1] = 2, p.inertia_com[2] = 3);
  const auto whole = revolute().mass(1).inertia_com(1, 2, 3, 0.25, 0.5, 0.75).parameters();
  EXPECT_EQ(whole.inertia_com[3], 0.25);
  EXPECT_EQ(whole.inertia_com[4], 0.5);
  EXPECT_EQ(whole.inertia_com[5], 0.75);
}

TEST(LinkBuilder, InertiaAboutTheOriginIsMovedToTheCentre) {
  // 2 kg at (1, 2, 4) and nothing about its centre.
  const auto p = revolute().mass(2).com(1, 2, 4).inertia_origin(40, 34, 10, -4, -8, -16).parameters();
  for (const double entry : p.inertia_com)
    EXPECT_EQ(entry, 0.0);
}

TEST(LinkBuilder, DrivesWriteTheirOwnFields) {
  EXPECT_ONLY(rotor_inertia(2), p.rotor_inertia = 2);
  EXPECT_ONLY(rotor_inertia(2, 50), p.rotor_inertia = 2, p.gear = 50);
  EXPECT_ONLY(rotor_axis(1, 2, 3), p.rotor_axis[0] = 1, p.rotor_axis[1] = 2, p.rotor_axis[2] = 3);
  EXPECT_ONLY(rotor_axis(1, 0, 0, 4), p.rotor_axis[0] = 1, p.rotor_carrier = 4);
  EXPECT_ONLY(viscous(2), p.viscous = 2);
  EXPECT_ONLY(coulomb(2), p.coulomb_forward = 2, p.coulomb_backward = -2);
  EXPECT_ONLY(coulomb(2, -1), p.coulomb_forward = 2, p.coulomb_backward = -1);
  EXPECT_ONLY(stribeck(2, 3), p.static_friction = 2, p.stribeck_speed = 3);
  EXPECT_ONLY(smooth_speed(2), p.smooth_speed = 2);
  EXPECT_ONLY(spring(2), p.spring_stiffness = 2);
  EXPECT_ONLY(spring(2, 3), p.spring_stiffness = 2, p.spring_rest = 3);
  EXPECT_ONLY(stiffness(2), p.stiffness = 2);
}

TEST(LinkBuilder, LimitsWriteTheirOwnFields) {
  EXPECT_ONLY(position_limits(-1, 2), p.position_min = -1, p.position_max = 2);
  EXPECT_ONLY(speed_limit(2), p.speed_limit = 2);
  EXPECT_ONLY(acceleration_limit(2), p.acceleration_limit = 2);
  EXPECT_ONLY(effort_limit(2), p.effort_limit = 2);
}

TEST(LinkBuilder, WaterWritesItsOwnFields) {
  EXPECT_ONLY(
      added_mass(1, 2, 3, 4, 5, 6), for (int i = 0; i < 3; ++i) {
        p.water.added_mass[i] = i + 1;
        p.water.added_inertia[i] = i + 4;
      });
  EXPECT_ONLY(buoyancy(1, 2, 3, 4), p.water.displaced_mass = 1, p.water.centre[0] = 2, p.water.centre[1] = 3,
              p.water.centre[2] = 4);
  EXPECT_ONLY(
      drag_linear(1, 2, 3, 4, 5, 6), for (int i = 0; i < 6; ++i) { p.water.drag_linear[i] = i + 1; });
  EXPECT_ONLY(
      drag_quadratic(1, 2, 3, 4, 5, 6), for (int i = 0; i < 6; ++i) { p.water.drag_quadratic[i] = i + 1; });
}
