#include <algorithm>
#include <cmath>
#include <oracle/convert.hpp>
#include <oracle/random_chain.hpp>
#include <oracle/recursive.hpp>
#include <stability/ablation.hpp>
#include <stability/measure.hpp>
#include <stability/textbook.hpp>

namespace stability {
namespace {

constexpr const char* shown[] = {"S01_zigzag_N100",           "S01_curled_N100",           "S01_moving_N100",
                                 "S01_moving_N300",           "S02_3d_alternating_N100",   "S03_taper_N20",
                                 "S06_zyx_massless_eps2^-14", "S06_zyx_eps2^-11_rot2^-10", "S11_farcom_2^10",
                                 "S12_scale_L2^-20_m2^-60",   "S16_heavylight_N10",        "S17_zyx_eps2^-8_rot2^-20",
                                 "S17_zyx_eps2^-14_rot2^-20"};

struct Named {
  const char* name;
  Variant variant;
};
constexpr Named variants[] = {{"textbook", {}},
                              {"1", {true}},
                              {"2", {false, Update::gain}},
                              {"2p", {false, Update::prescaled}},
                              {"3", {false, Update::quotient, true}},
                              {"1+2", {true, Update::gain}},
                              {"1+3", {true, Update::quotient, true}},
                              {"2+3", {false, Update::gain, true}},
                              {"1+2p+3", {true, Update::prescaled, true}},
                              {"1+2+3", {true, Update::gain, true}},
                              {"1+2+3'", {true, Update::gain, true, false}},
                              {"1+2+3, dense", {true, Update::gain, true, true, true}}};

oracle::Vector<double> in_world_axes(const Scenario& s) {
  return oracle::recursive_forward_dynamics(s.chain, s.q, s.qd, s.tau);
}

/// The same scenario in instances: one, or random sizes of it.
std::vector<Scenario> instances_of(const std::string& name) {
  std::vector<Scenario> result;
  if (name == "S07_3R_m001_0.1deg_median") {
    oracle::RandomChains random(7);
    for (int k = 0; k < 300; ++k)
      result.push_back(cases::massless_elbow(random.uniform(0.1, 0.4), oracle::right_angle<double>() / 900.0));
    return result;
  }
  for (const Scenario& scenario : cases::scenarios())
    if (scenario.name == name) result.push_back(scenario);
  return result;
}

template <class Solve>
double median_error(const std::vector<Scenario>& instances, const std::vector<Reference>& references, Solve solve) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < instances.size(); ++k)
    errors.push_back(forward_error(instances[k], references[k], solve(instances[k])));
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
  return errors[errors.size() / 2];
}

void add_scenario(std::vector<AblationRow>& rows, const std::string& name) {
  const auto instances = instances_of(name);
  std::vector<Reference> references;
  for (const Scenario& scenario : instances)
    references.push_back(reference_of(scenario, false));
  for (const Scalar scalar : scalars) {
    const auto add = [&](const char* variant, auto solve) {
      rows.push_back({name, name_of(scalar), variant, median_error(instances, references, solve)});
    };
    for (const Named& named : variants)
      add(named.name, [&](const Scenario& s) {
        return scalar == Scalar::in_double ? textbook<double>(s, named.variant) : textbook<float>(s, named.variant);
      });
    if (scalar == Scalar::in_double) add("textbook, world axes", in_world_axes);
    add("axial", [&](const Scenario& s) { return solve(s, Route::articulated_body, scalar).qdd; });
  }
}

}  // namespace

std::vector<AblationRow> ablation() {
  std::vector<AblationRow> rows;
  for (const char* name : shown)
    add_scenario(rows, name);
  add_scenario(rows, "S07_3R_m001_0.1deg_median");
  return rows;
}

}  // namespace stability
