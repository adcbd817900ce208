// Single joints near the end of their means: ST6, ST7, ST9, ST11, ST17.
#include <cases/scenario_parts.hpp>

namespace cases {

using namespace parts;

namespace {

/// z-y-x joints through one point, all mass in the third link; the second joint eps away from gimbal lock.
Scenario wrist(const std::string& name, int exponent, double rotor, double gate_double, double gate_float) {
  oracle::Chain<double> chain;
  chain.gravity = {0.0, -9.8125, 0.0};
  for (int i = 0; i < 3; ++i) {
    chain.links.push_back(i < 2 ? body(i - 1, 0.0, {}, diagonal(0.0, 0.0, 0.0))
                                : body(i - 1, 1.0, {0.5, 0.25, 0.0}, diagonal(1.0, 1.0, 1.0)));
    chain.links.back().alpha = i == 0 ? 0.0 : -oracle::right_angle<double>();
    chain.links.back().rotor_inertia = rotor;
  }
  Scenario scenario = at_rest(name, chain, gate_double, gate_float);
  scenario.q = {0.5, -power_of_two(exponent), 0.25}, scenario.qd = {0.5, -0.25, 0.75};
  return scenario;
}

/// Two slides on one axis.
Scenario slides(const char* name, double first, double second) {
  oracle::Chain<double> chain;
  chain.gravity = {0.0, 0.0, -9.8125};
  for (const double mass : {first, second}) {
    chain.links.push_back(body(chain.size() - 1, mass, {}, diagonal(0.0, 0.0, 0.0)));
    chain.links.back().type = oracle::Joint::prismatic;
  }
  Scenario scenario = at_rest(name, chain, 0.0, 1e-6);
  scenario.tau = {1.0, 2.0}, scenario.singular = first == 0.0;
  return scenario;
}

/// Three cubes in a row; gravity pulls along the row where it is straight.
Scenario cubes(const std::string& name, double m1, double m2, double m3, double side) {
  oracle::Chain<double> chain;
  chain.gravity = {9.75, 0.0, 0.0};
  for (const double mass : {m1, m2, m3}) {
    const double inertia = as_float(mass * side * side / 6.0);
    chain.links.push_back(
        body(chain.size() - 1, mass, {as_float(side / 2), 0.0, 0.0}, diagonal(inertia, inertia, inertia)));
    chain.links.back().a = chain.size() == 1 ? 0.0 : as_float(side);
  }
  return at_rest(name, chain, 0.0, 0.0);
}

Scenario around_one_axis(const std::string& name, double twist) {
  oracle::Chain<double> chain;
  chain.gravity = {0.0, -9.8125, 0.0};
  const double light = power_of_two(-20);
  const auto arm = slender(1.0, 1.0 / 384.0, 17.0 / 768.0);
  chain.links = {body(-1, 1.0, {0.25, 0.0, 0.0}, arm), body(0, light, {}, diagonal(light, light, light)),
                 body(1, 1.0, {0.25, 0.0, 0.0}, arm)};
  chain.links[1].alpha = chain.links[2].alpha = twist, chain.links[1].a = 0.5;
  Scenario scenario = at_rest(name, chain, 1e-14, 1e-6);
  scenario.q = {0.5, 0.25, -0.5}, scenario.qd = {0.0, 0.0, 1.0};
  return scenario;
}

Scenario arm_with_far_com(int exponent) {
  const double arm = power_of_two(exponent), inertia = power_of_two(-10);
  oracle::Chain<double> chain;
  chain.gravity = {0.0, -9.8125, 0.0};
  chain.links.push_back(body(-1, 1.0, {arm, 0.0, 0.0}, diagonal(inertia, inertia, inertia)));
  chain.links.push_back(body(0, 1.0, {0.25, 0.0, 0.0}, diagonal(inertia, inertia, inertia)));
  chain.links[1].a = arm;
  Scenario scenario = at_rest("S11_farcom_" + power(exponent), chain, 1e-14, 1e-6);
  scenario.q = {0.5, -0.25}, scenario.qd = {0.25, 0.5};
  return scenario;
}

}  // namespace

std::vector<Scenario> gimbal() {
  std::vector<Scenario> all;
  for (const int e : {-2, -5, -8, -11, -14})
    all.push_back(wrist("S06_zyx_massless_eps" + power(e), e, 0.0, 1e-14, 1e-6));
  all.push_back(wrist("S06_zyx_eps2^-11_rot2^-10", -11, power_of_two(-10), 1e-14, 1e-6));
  return all;
}

std::vector<Scenario> gimbal_with_rotors() {
  std::vector<Scenario> all;
  for (const int e : {-2, -5, -8, -11, -14})
    all.push_back(wrist("S17_zyx_eps" + power(e) + "_rot2^-20", e, power_of_two(-20), 2e-13, 5e-5));
  return all;
}

Scenario massless_elbow(double side, double elbow) {
  Scenario scenario = cubes("S07_3R_m001_0.1deg", 0.0, 0.0, 1.0, side);
  scenario.q[1] = as_float(elbow);
  scenario.in_double.forward = 1e-9, scenario.in_float.forward = std::numeric_limits<double>::infinity();
  return scenario;
}

std::vector<Scenario> massless_links() {
  const double side = as_float(0.2);
  Scenario straight = cubes("S07_3R_m001_straight(sing)", 0.0, 0.0, 1.0, side);
  straight.singular = true;
  return {slides("S07_PP_mA2^-10_mB2^30", power_of_two(-10), power_of_two(30)),
          slides("S07_PP_mA0_mB1(singular)", 0.0, 1.0),
          straight,
          massless_elbow(side, oracle::right_angle<double>() / 900.0),
          cubes("S07_3R_m101", 1.0, 0.0, 1.0, side),
          cubes("S07_3R_m011", 0.0, 1.0, 1.0, side)};
}

std::vector<Scenario> coaxial() {
  return {around_one_axis("S09_coaxial_I2^-20", 0.0), around_one_axis("S09_nearcoaxial_2^-10rad", power_of_two(-10))};
}

std::vector<Scenario> far_com() {
  return {arm_with_far_com(4), arm_with_far_com(8), arm_with_far_com(10), arm_with_far_com(12)};
}

}  // namespace cases
