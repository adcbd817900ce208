#include <cases/scenario_parts.hpp>
#include <oracle/convert.hpp>
#include <oracle/random_chain.hpp>
#include <oracle/recursive.hpp>

namespace cases {

using namespace parts;

Scenario scaled(const Scenario& scenario, int length, int mass, bool with_gravity) {
  const double metre = power_of_two(length), kilogram = power_of_two(mass), inertia = kilogram * metre * metre;
  Scenario result = scenario;
  result.name = "S12_scale_L" + power(length) + "_m" + power(mass);
  if (with_gravity) result.chain.gravity = metre * result.chain.gravity;
  for (std::size_t i = 0; i < result.q.size(); ++i) {
    auto& link = result.chain.links[i];
    link.a *= metre, link.d *= metre, link.b *= metre, link.com = metre * link.com, link.mass *= kilogram;
    link.inertia = {inertia * link.inertia.c0, inertia * link.inertia.c1, inertia * link.inertia.c2};
    const bool turns = link.type == oracle::Joint::revolute;
    link.rotor_inertia *= turns ? inertia : kilogram;
    result.tau[i] *= turns ? inertia : kilogram * metre;
    if (!turns) result.q[i] *= metre, result.qd[i] *= metre;
  }
  return result;
}

namespace {

/// The gravity torque, rounded to float.
oracle::Vector<double> holding_torque(const Scenario& scenario) {
  const Values still(scenario.q.size(), quad(0));
  const auto exact = oracle::recursive_inverse_dynamics(oracle::convert<quad>(scenario.chain),
                                                        oracle::convert<quad>(scenario.q), still, still);
  oracle::Vector<double> result;
  for (const quad& tau : exact)
    result.push_back(as_float(static_cast<double>(tau)));
  return result;
}

}  // namespace

Scenario perturbed(const Scenario& scenario, unsigned seed) {
  oracle::RandomChains random(seed);
  const auto vary = [&](double& x) { x = as_float(x * random.uniform(1.0 - 0.0625, 1.0 + 0.0625)); };
  Scenario result = scenario;
  for (auto& link : result.chain.links) {
    for (double* x : {&link.a, &link.d, &link.mass, &link.com.x, &link.com.y, &link.com.z, &link.rotor_inertia})
      vary(*x);
    const double factor = random.uniform(1.0 - 0.0625, 1.0 + 0.0625);
    for (auto* column : {&link.inertia.c0, &link.inertia.c1, &link.inertia.c2})
      *column = {as_float(factor * column->x), as_float(factor * column->y), as_float(factor * column->z)};
  }
  for (auto* values : {&result.q, &result.qd, &result.tau})
    for (double& x : *values)
      vary(x);
  if (result.equilibrium) result.tau = holding_torque(result);
  return result;
}

std::vector<Scenario> gravity_hold() {
  Scenario hold = nominal_arm();
  hold.name = "S14_hold_gravity", hold.family = "ST14", hold.qd.assign(6, 0.0);
  hold.measure = Measure::absolute, hold.equilibrium = true;
  hold.in_double = {1e-13}, hold.in_float = {2e-5};
  hold.tau = holding_torque(hold);
  return {hold};
}

std::vector<Scenario> scenarios() {
  std::vector<Scenario> all = {nominal_arm()};
  for (const auto family :
       {rods, spatial_chains, size_ratios, heavy_tips, light_tips, gimbal, massless_links, rotors, coaxial, high_speeds,
        far_com, scaled_arm, opposing_drives, gravity_hold, telescopes, mass_ratios, gimbal_with_rotors})
    append(all, family());
  return all;
}

Values reference_acceleration(const Scenario& scenario) {
  const auto quads = [](const oracle::Vector<double>& v) { return oracle::convert<quad>(v); };
  return oracle::recursive_forward_dynamics(oracle::convert<quad>(scenario.chain), quads(scenario.q),
                                            quads(scenario.qd), quads(scenario.tau));
}

}  // namespace cases
