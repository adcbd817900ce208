// Long chains and telescopes: ST1, ST2, ST3, ST13, ST15, ST16.
#include <cases/scenario_parts.hpp>
#include <oracle/random_chain.hpp>

namespace cases {

using namespace parts;

namespace {

/// The file's state where it holds the scenario, else positions, speeds and efforts drawn up to these sizes.
void draw_state(Scenario& scenario, double q, double qd, double tau) {
  for (const StiffScenario& known : load_stiff_scenarios())
    if (known.name == scenario.name) {
      scenario.q = known.q, scenario.qd = known.qd, scenario.tau = known.tau;
      return;
    }
  const int n = scenario.size();
  oracle::RandomChains random(static_cast<unsigned>(n));
  scenario.q = random.vector(n, q), scenario.qd = random.vector(n, qd);
  if (tau > 0.0) scenario.tau = random.vector(n, tau);
}

Scenario rods_at_rest(const char* kind, int n) {
  oracle::Chain<double> chain;
  chain.gravity = {0.0, -9.8125, 0.0};
  const double across = as_float(1.0 / 12.0), along = power_of_two(-10);
  for (int i = 0; i < n; ++i) {
    chain.links.push_back(body(i - 1, 1.0, {0.5, 0.0, 0.0}, diagonal(along, across, across)));
    chain.links.back().a = i == 0 ? 0.0 : 1.0;
  }
  return at_rest(named("S01", kind, n), chain, 1e-14, 2e-6);
}

Scenario zigzag_rods(int n) {
  Scenario scenario = rods_at_rest("zigzag", n);
  for (int i = 0; i < n; ++i)
    scenario.q[std::size_t(i)] = i == 0 ? -0.375 : i % 2 ? 0.75 : -0.75;
  return scenario;
}

Scenario curled_rods(int n) {
  Scenario scenario = rods_at_rest("curled", n);
  for (int i = 1; i < n; ++i)
    scenario.q[std::size_t(i)] = as_float(4.0 * oracle::right_angle<double>() / n);
  return scenario;
}

Scenario moving_rods(int n) {
  Scenario scenario = rods_at_rest("moving", n);
  draw_state(scenario, 0.5, 1.0, 0.0);
  return scenario;
}

Scenario boxes(int n) {
  oracle::Chain<double> chain;
  chain.gravity = {1.0, -2.0, -9.25};
  const auto inertia = diagonal(as_float(0.625 / 384.0), as_float(2.125 / 384.0), as_float(2.5 / 384.0));
  for (int i = 0; i < n; ++i) {
    chain.links.push_back(body(i - 1, 1.0, {0.125, 0.03125, 0.0625}, inertia));
    chain.links.back().d = 0.125;
    if (i > 0) chain.links.back().alpha = (i % 2 ? 1 : -1) * oracle::right_angle<double>(), chain.links.back().a = 0.25;
  }
  Scenario scenario = at_rest(named("S02", "3d_alternating", n), chain, 1e-14, 1e-5);
  draw_state(scenario, 3.0, 1.0, 2.0);
  return scenario;
}

/// Link i is of size ratio^i.
Scenario of_sizes(const char* kind, int ratio, int n, double gate_double, double gate_float) {
  oracle::Chain<double> chain;
  chain.gravity = {0.0, -9.8125, 1.0};
  for (int i = 0; i < n; ++i) {
    const double size = power_of_two(ratio * i), mass = size * size * size;
    chain.links.push_back(
        body(i - 1, mass, {size / 2, 0.0, 0.0}, slender(mass * size * size, 1.0 / 96.0, 17.0 / 192.0)));
    chain.links.back().alpha = i % 2 ? oracle::right_angle<double>() : 0.0;
    chain.links.back().a = i == 0 ? 0.0 : power_of_two(ratio * (i - 1));
  }
  Scenario scenario = at_rest(named("S03", kind, n), chain, gate_double, gate_float);
  scenario.q = alternating(n, 0.5), scenario.qd.assign(scenario.q.size(), 0.25);
  return scenario;
}

Scenario growing(int n, double gate_double) {
  Scenario scenario = of_sizes("grow", 1, n, gate_double, std::numeric_limits<double>::infinity());
  scenario.in_double.backward = 1e-14;
  return scenario;
}

/// Masses times 8^exponent from link to link; every joint is driven by the weight of a kilogram a m/s^2.
Scenario telescope(const char* name, int exponent) {
  oracle::Chain<double> chain;
  chain.gravity = {0.0, 0.0, -9.8125};
  Scenario scenario;
  for (int i = 0; i < 10; ++i) {
    chain.links.push_back(body(i - 1, power_of_two(3 * exponent * i), {}, diagonal(0.0, 0.0, 0.0)));
    chain.links.back().type = oracle::Joint::prismatic, chain.links.back().d = 0.125;
  }
  scenario = at_rest(name, chain, 0.0, 1e-6);
  for (std::size_t i = 0; i < 10; ++i)
    scenario.q[i] = as_float(0.0125 * static_cast<double>(i)), scenario.tau[i] = chain.links[i].mass;
  return scenario;
}

Scenario heavy_and_light(int n) {
  oracle::Chain<double> chain;
  chain.gravity = {0.0, -9.8125, 0.0};
  for (int i = 0; i < n; ++i) {
    const double mass = power_of_two(i % 2 ? 10 : -10);
    chain.links.push_back(body(i - 1, mass, {0.25, 0.0, 0.0625}, slender(mass, 1.0 / 384.0, 17.0 / 768.0)));
    chain.links.back().alpha = i % 3 == 1 ? oracle::right_angle<double>() : 0.0;
    chain.links.back().a = i == 0 ? 0.0 : 0.5;
  }
  Scenario scenario = at_rest(named("S16", "heavylight", n), chain, 1e-14, 5e-6);
  scenario.q = alternating(n, 0.5);
  scenario.qd.assign(scenario.q.size(), 0.5), scenario.tau.assign(scenario.q.size(), 0.25);
  return scenario;
}

}  // namespace

std::vector<Scenario> rods() {
  std::vector<Scenario> all;
  for (const int n : {10, 30, 100, 300})
    append(all, {rods_at_rest("straight", n), zigzag_rods(n), curled_rods(n), moving_rods(n)});
  return all;
}

std::vector<Scenario> spatial_chains() { return {boxes(12), boxes(50), boxes(100)}; }

std::vector<Scenario> size_ratios() {
  const double hopeless = std::numeric_limits<double>::infinity();
  return {of_sizes("taper", -1, 10, 1e-14, 1e-5), of_sizes("taper", -1, 20, 1e-14, 1e-5), growing(10, 1e-8),
          growing(20, hopeless)};
}

std::vector<Scenario> opposing_drives() {
  Scenario scenario = zigzag_rods(10);
  scenario.name = "S13_alttorque_2^20_N10", scenario.family = "ST13";
  scenario.tau = alternating(10, power_of_two(20)), scenario.in_float.forward = 5e-6;
  return {scenario};
}

std::vector<Scenario> telescopes() {
  return {telescope("S15_telescope_N10", 0), telescope("S15_telescope_taper_N10", -1),
          telescope("S15_telescope_grow_N10", 1)};
}

std::vector<Scenario> mass_ratios() { return {heavy_and_light(10), heavy_and_light(20)}; }

}  // namespace cases
