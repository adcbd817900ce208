#include <cases/scenarios.hpp>
#include <oracle/convert.hpp>
#include <oracle/random_chain.hpp>
#include <oracle/recursive.hpp>

namespace cases {
namespace {

using oracle::Vector;

double as_float(double x) { return static_cast<double>(static_cast<float>(x)); }

std::string named(const char* family, const char* kind, int n) {
  return std::string(family) + "_" + kind + "_N" + std::to_string(n);
}
std::string power(int exponent) { return "2^" + std::to_string(exponent); }

oracle::Mat3<double> diagonal(double xx, double yy, double zz) { return oracle::symmetric(xx, yy, zz, 0.0, 0.0, 0.0); }

oracle::Link<double> body(int parent, double mass, oracle::Vec3<double> com, const oracle::Mat3<double>& inertia) {
  oracle::Link<double> link;
  link.parent = parent, link.mass = mass, link.com = com, link.inertia = inertia;
  return link;
}

Scenario at_rest(std::string name, oracle::Chain<double> chain, double gate_double, double gate_float) {
  const Vector<double> zero(chain.links.size(), 0.0);
  return {std::move(name), std::move(chain), zero, zero, zero, gate_double, gate_float};
}

Scenario rods_at_rest(const char* kind, int n) {
  oracle::Chain<double> chain;
  chain.gravity = {0.0, -9.8125, 0.0};
  const double across = as_float(1.0 / 12.0), along = std::ldexp(1.0, -10);
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
  for (const StiffScenario& known : load_stiff_scenarios())
    if (known.name == scenario.name) {
      scenario.q = known.q, scenario.qd = known.qd;
      return scenario;
    }
  oracle::RandomChains random(static_cast<unsigned>(n));
  scenario.q = random.vector(n, 0.5), scenario.qd = random.vector(n, 1.0);
  return scenario;
}

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
  scenario.q = {0.5, -std::ldexp(1.0, exponent), 0.25}, scenario.qd = {0.5, -0.25, 0.75};
  return scenario;
}

Scenario arm_with_far_com(int exponent) {
  const double arm = std::ldexp(1.0, exponent), inertia = std::ldexp(1.0, -10);
  oracle::Chain<double> chain;
  chain.gravity = {0.0, -9.8125, 0.0};
  chain.links.push_back(body(-1, 1.0, {arm, 0.0, 0.0}, diagonal(inertia, inertia, inertia)));
  chain.links.push_back(body(0, 1.0, {0.25, 0.0, 0.0}, diagonal(inertia, inertia, inertia)));
  chain.links[1].a = arm;
  Scenario scenario = at_rest("S11_farcom_" + power(exponent), chain, 1e-14, 1e-6);
  scenario.q = {0.5, -0.25}, scenario.qd = {0.25, 0.5};
  return scenario;
}

void append(std::vector<Scenario>& all, const std::vector<Scenario>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::vector<Scenario> rods() {
  std::vector<Scenario> all;
  for (const int n : {10, 30, 100, 300})
    append(all, {rods_at_rest("straight", n), zigzag_rods(n), curled_rods(n)});
  append(all, {moving_rods(30), moving_rods(100)});
  return all;
}

std::vector<Scenario> gimbal() {
  std::vector<Scenario> all;
  for (const int e : {-2, -5, -8, -11, -14})
    all.push_back(wrist("S06_zyx_massless_eps" + power(e), e, 0.0, 1e-14, 1e-6));
  all.push_back(wrist("S06_zyx_eps2^-11_rot2^-10", -11, std::ldexp(1.0, -10), 1e-14, 1e-6));
  return all;
}

std::vector<Scenario> gimbal_with_rotors() {
  std::vector<Scenario> all;
  for (const int e : {-2, -5, -8, -11, -14})
    all.push_back(wrist("S17_zyx_eps" + power(e) + "_rot2^-20", e, std::ldexp(1.0, -20), 2e-13, 5e-5));
  return all;
}

std::vector<Scenario> far_com() {
  return {arm_with_far_com(4), arm_with_far_com(8), arm_with_far_com(10), arm_with_far_com(12)};
}

Scenario nominal_arm() {
  constexpr double masses[] = {8.0, 6.0, 4.0, 2.0, 1.0, 0.5};
  constexpr double a[] = {0.0, 0.0625, 0.4375, 0.0625, 0.0, 0.0}, d[] = {0.5, 0.0, 0.125, 0.4375, 0.0, 0.125};
  constexpr int quarters[] = {0, 1, 0, 1, -1, 1};
  const double slim = as_float(1.0 / 384.0), wide = as_float(5.0 / 768.0);  // a box of 1 kg
  oracle::Chain<double> chain;
  chain.gravity = {0.0, 0.0, -9.8125};
  for (int i = 0; i < 6; ++i) {
    const auto inertia = diagonal(as_float(masses[i] * slim), as_float(masses[i] * wide), as_float(masses[i] * wide));
    chain.links.push_back(body(i - 1, masses[i], {0.0625, -0.03125, 0.125}, inertia));
    chain.links.back().alpha = quarters[i] * oracle::right_angle<double>();
    chain.links.back().a = a[i], chain.links.back().d = d[i];
  }
  Scenario scenario = at_rest("S00_arm6_nominal", chain, 1e-14, 2e-6);
  scenario.q = {0.25, -0.75, 1.25, 0.5, -1.0, 0.375}, scenario.qd = {0.5, -0.25, 0.75, -1.0, 1.25, 0.5};
  return scenario;
}

Scenario scaled(const Scenario& scenario, int length, int mass, bool with_gravity) {
  const double metre = std::ldexp(1.0, length), kilogram = std::ldexp(1.0, mass);
  Scenario result = scenario;
  result.name = "S12_scale_L" + power(length) + "_m" + power(mass);
  if (with_gravity) result.chain.gravity = metre * result.chain.gravity;
  for (auto& link : result.chain.links) {
    const double inertia = kilogram * metre * metre;
    link.a *= metre, link.d *= metre, link.com = metre * link.com, link.mass *= kilogram;
    link.inertia = {inertia * link.inertia.c0, inertia * link.inertia.c1, inertia * link.inertia.c2};
    link.rotor_inertia *= inertia;
  }
  for (double& tau : result.tau)
    tau *= kilogram * metre * metre;
  return result;
}

std::vector<Scenario> scaled_arm() {
  const Scenario arm = nominal_arm();
  return {scaled(arm, -10, -30, false), scaled(arm, -20, -60, false), scaled(arm, 10, 30, false)};
}

std::vector<Scenario> scenarios() {
  std::vector<Scenario> all;
  for (const auto& family : {rods(), gimbal(), far_com(), scaled_arm(), gimbal_with_rotors()})
    append(all, family);
  return all;
}

Values reference_acceleration(const Scenario& scenario) {
  const auto quads = [](const Vector<double>& v) { return oracle::convert<quad>(v); };
  return oracle::recursive_forward_dynamics(oracle::convert<quad>(scenario.chain), quads(scenario.q),
                                            quads(scenario.qd), quads(scenario.tau));
}

}  // namespace cases
