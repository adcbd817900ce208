// The nominal 6R arm and what becomes of it: ST4, ST5, ST8, ST10, ST12.
#include <cases/scenario_parts.hpp>

namespace cases {

using namespace parts;

namespace parts {

oracle::Chain<double> arm(const double (&masses)[6]) {
  constexpr double a[] = {0.0, 0.0625, 0.4375, 0.0625, 0.0, 0.0}, d[] = {0.5, 0.0, 0.125, 0.4375, 0.0, 0.125};
  constexpr int quarters[] = {0, 1, 0, 1, -1, 1};
  const double slim = as_float(1.0 / 384.0), wide = as_float(5.0 / 768.0);  // a box of 1 kg
  oracle::Chain<double> chain;
  chain.gravity = {0.0, 0.0, -9.8125};
  for (int i = 0; i < 6; ++i) {
    chain.links.push_back(body(i - 1, masses[i], {0.0625, -0.03125, 0.125}, slender(masses[i], slim, wide)));
    chain.links.back().alpha = quarters[i] * oracle::right_angle<double>();
    chain.links.back().a = a[i], chain.links.back().d = d[i];
  }
  return chain;
}

Scenario at_arm_state(std::string name, oracle::Chain<double> chain, double gate_double, double gate_float) {
  Scenario scenario = at_rest(std::move(name), std::move(chain), gate_double, gate_float);
  scenario.q = {0.25, -0.75, 1.25, 0.5, -1.0, 0.375}, scenario.qd = {0.5, -0.25, 0.75, -1.0, 1.25, 0.5};
  return scenario;
}

}  // namespace parts

namespace {

/// The last link becomes a tip whose centre of mass is `com` m out on its axis.
void set_tip(oracle::Chain<double>& chain, double mass, double com) {
  auto& tip = chain.links.back();
  const double across = mass * com * com;
  tip.mass = mass, tip.com = {0.0, 0.0, com}, tip.inertia = diagonal(across, across, across / 2);
}

Scenario with_heavy_tip(int exponent) {
  const double light = power_of_two(-10);
  auto chain = arm({light, light, light, light, light, light});
  set_tip(chain, power_of_two(exponent), 0.125);
  return at_arm_state("S04_heavytip_" + power(exponent), chain, 2e-13, 1e-4);
}

Scenario with_light_tip(int exponent) {
  auto chain = arm({8.0, 6.0, 4.0, 2.0, 1.0, 0.5});
  set_tip(chain, power_of_two(exponent), 0.015625);
  return at_arm_state("S05_lighttip_" + power(exponent), chain, 1e-14, 2e-6);
}

Scenario with_rotors(int exponent) {
  Scenario scenario = nominal_arm();
  scenario.name = "S08_rotor_" + power(exponent), scenario.family = "ST8";
  scenario.tau = {5.0, -3.0, 2.0, 1.0, -1.0, 0.5};
  for (auto& link : scenario.chain.links)
    link.rotor_inertia = power_of_two(exponent);
  return scenario;
}

Scenario at_speed(int exponent) {
  Scenario scenario = nominal_arm();
  scenario.name = "S10_speed_" + power(exponent), scenario.family = "ST10";
  for (double& qd : scenario.qd)
    qd *= power_of_two(exponent);
  return scenario;
}

}  // namespace

Scenario nominal_arm() {
  Scenario scenario = at_arm_state("S00_arm6_nominal", arm({8.0, 6.0, 4.0, 2.0, 1.0, 0.5}), 1e-14, 2e-6);
  scenario.family = "ST12";
  return scenario;
}

std::vector<Scenario> heavy_tips() {
  return {with_heavy_tip(0), with_heavy_tip(10), with_heavy_tip(20), with_heavy_tip(30)};
}
std::vector<Scenario> light_tips() { return {with_light_tip(-10), with_light_tip(-20), with_light_tip(-30)}; }
std::vector<Scenario> rotors() {
  return {with_rotors(-40), with_rotors(-20), with_rotors(0), with_rotors(10), with_rotors(20)};
}
std::vector<Scenario> high_speeds() { return {at_speed(5), at_speed(10)}; }
std::vector<Scenario> scaled_arm() {
  const Scenario arm = nominal_arm();
  return {scaled(arm, -10, -30, false), scaled(arm, -20, -60, false), scaled(arm, 10, 30, false)};
}

}  // namespace cases
