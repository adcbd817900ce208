#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stability/compiled/rows.hpp>
#include <stability/peers/child.hpp>
#include <stability/peers/compare.hpp>
#include <stdexcept>

namespace stability {
namespace {

struct Instance {
  Scenario scenario;
  Reference reference;
  double in_double, in_float;  ///< our errors: of ABA and of the form that is taken by default, the larger one
};

std::vector<Instance> instances_of(const Scenario& scenario, int count) {
  std::vector<Instance> result;
  for (int k = 0; k < count; ++k) {
    Instance instance{cases::perturbed(scenario, static_cast<unsigned>(k + 1)), {}, 0.0, 0.0};
    instance.reference = reference_of(instance.scenario, false);
    const auto error = [&](Scalar scalar) {
      double worst = 0.0;
      for (const Route route : {Route::articulated_body, default_route(scenario.name)}) {
        const auto answer = solve(instance.scenario, route, scalar);
        worst = std::max(worst, forward_error(instance.scenario, instance.reference, answer.qdd));
      }
      return worst;
    };
    instance.in_double = error(Scalar::in_double), instance.in_float = error(Scalar::in_float);
    result.push_back(std::move(instance));
  }
  return result;
}

double error_of(const Peer& peer, const Instance& instance) {
  const Scenario& s = instance.scenario;
  const auto engine = peer.load(s.chain);
  try {
    return forward_error(s, instance.reference, engine->accelerations(s.q, s.qd, s.tau));
  } catch (const std::exception&) {
    return HUGE_VAL;  // it solves no such chain
  }
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

/// The answer to a scenario that has none.
std::string said(const Peer& peer, const Scenario& s) {
  const auto answer = in_child([&] { return peer.load(s.chain)->accelerations(s.q, s.qd, s.tau); });
  if (!answer || answer->empty()) return "by ending the process";
  std::string text;
  for (const double x : *answer) {
    char number[16];
    std::snprintf(number, sizeof number, "%.3g", x);
    text += (text.empty() ? "" : ", ") + std::string(number);
  }
  return text;
}

/// Of the scenario itself, then of its instances; all infinite where the engine ended the process.
std::vector<double> errors_of(const Peer& peer, const Scenario& scenario, const std::vector<Instance>& instances) {
  const auto errors = in_child([&] {
    std::vector<double> result = {error_of(peer, {scenario, reference_of(scenario, false), 0.0, 0.0})};
    for (const Instance& instance : instances)
      result.push_back(error_of(peer, instance));
    return result;
  });
  return errors && !errors->empty() ? *errors : std::vector<double>(instances.size() + 1, HUGE_VAL);
}

Comparison named(const Peer& peer, const Scenario& s) {
  Comparison row;
  row.scenario = s.name, row.family = s.family, row.engine = peer.name, row.scalar = name_of(peer.scalar);
  row.joints = s.size(), row.absolute = s.measure == cases::Measure::absolute;
  return row;
}

Comparison compare(const Peer& peer, const Scenario& s, const std::vector<Instance>& instances) {
  const double least = 8.0 * epsilon_of(peer.scalar);
  std::vector<double> theirs = errors_of(peer, s, instances), ours, ratios;
  const double nominal = theirs.front();
  theirs.erase(theirs.begin());
  for (const Instance& instance : instances) {
    ours.push_back(peer.scalar == Scalar::in_double ? instance.in_double : instance.in_float);
    ratios.push_back(std::max(ours.back(), least) / std::max(theirs[ours.size() - 1], least));
  }
  Comparison row = named(peer, s);
  row.instances = static_cast<int>(instances.size());
  row.nominal_error = nominal;
  row.engine_error = median(theirs), row.our_error = median(ours), row.ratio = median(ratios);
  row.excluded = s.name.find("S03_grow") == 0;
  row.pass = row.excluded || row.ratio <= admissible_ratio;
  return row;
}

}  // namespace

std::vector<Comparison> compare(const Scenario& scenario, const std::vector<Peer>& peers, int instances) {
  std::vector<Comparison> rows;
  const auto drawn = instances_of(scenario, scenario.singular ? 0 : instances);
  for (const Peer& peer : peers) {
    try {
      peer.load(scenario.chain);
    } catch (const std::invalid_argument&) {
      continue;  // the engine has no model of it
    }
    if (scenario.singular) {
      rows.push_back(named(peer, scenario));
      rows.back().said = said(peer, scenario), rows.back().pass = true;
    } else {
      rows.push_back(compare(peer, scenario, drawn));
    }
  }
  return rows;
}

std::vector<Peer> all_peers() {
  std::vector<Peer> all;
  for (const auto family : {kdl_peers, dart_peers, simbody_peers, bullet_peers})
    for (Peer& peer : family())
      all.push_back(std::move(peer));
  return all;
}

}  // namespace stability
