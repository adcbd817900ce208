#include <algorithm>
#include <cmath>
#include <oracle/compare.hpp>
#include <oracle/random_chain.hpp>
#include <stability/rows.hpp>

namespace stability {
namespace {

constexpr unsigned seed = 7;

Row row_of(const Scenario& scenario, const Reference& reference, Route route, Scalar scalar) {
  const Answer answer = solve(scenario, route, scalar);
  Row row{scenario.name, scenario.family, name_of(scalar), name_of(route), name_of(answer.status), scenario.size()};
  row.condition = reference.condition, row.absolute = scenario.measure == cases::Measure::absolute;
  const bool reported = !answer.status.ok(), finite = is_finite(answer.qdd);
  if (scenario.singular) {
    row.pass = reported && finite;
    return row;
  }
  row.forward = forward_error(scenario, reference, answer.qdd);
  row.backward = backward_error(scenario, reference, answer.qdd);
  row.gate = gate_of(scenario, reference.condition, route, scalar);
  row.pass = row.forward <= row.gate.forward && row.backward <= row.gate.backward && (finite || reported);
  return row;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The nominal arm with a slide in it.
Scenario arm_with_slide() {
  Scenario scenario = cases::nominal_arm();
  auto& link = scenario.chain.links[2];
  link.type = oracle::Joint::prismatic;
  scenario.name += "_with_slide", scenario.tau = {5.0, -3.0, 2.0, 1.0, -1.0, 0.5};
  return scenario;
}

/// Largest change of an acceleration, relative; those of slides scaled back.
double change(const Scenario& scenario, const oracle::Vector<double>& plain, oracle::Vector<double> scaled,
              int length) {
  for (std::size_t i = 0; i < scaled.size(); ++i)
    if (scenario.chain.links[i].type == oracle::Joint::prismatic) scaled[i] = std::ldexp(scaled[i], -length);
  return oracle::relative_error(scaled, plain);
}

Row scaling_row(const Scenario& scenario, Route route, Scalar scalar) {
  const auto plain = solve(scenario, route, scalar);
  double worst = 0.0;
  for (const int mass : {-20, 0, 20})
    for (const int length : {-10, 0, 10}) {
      const auto answer = solve(cases::scaled(scenario, length, mass, true), route, scalar);
      worst = std::max(worst, change(scenario, plain.qdd, answer.qdd, length));
    }
  Row row{"S12_bits_" + scenario.name.substr(4),
          "ST12",
          name_of(scalar),
          name_of(route),
          name_of(plain.status),
          scenario.size()};
  row.condition = condition(scenario.chain, scenario.q);
  row.forward = worst, row.gate.forward = 0.0, row.pass = worst == 0.0;
  return row;
}

void append(std::vector<Row>& all, const std::vector<Row>& more) { all.insert(all.end(), more.begin(), more.end()); }

bool contains(const std::string& name, const std::string& part) { return name.find(part) != std::string::npos; }

}  // namespace

bool is_finite(const oracle::Vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

cases::Gate gate_of(const Scenario& scenario, double condition, Route route, Scalar scalar) {
  const cases::Gate own = scalar == Scalar::in_double ? scenario.in_double : scenario.in_float;
  if (route == Route::articulated_body || scenario.measure == cases::Measure::absolute) return own;
  cases::Gate gate;
  const double lost = condition * epsilon_of(scalar);
  // The condition speaks of the solve alone: near cond 1 the rounding of M and of the bias needs the family's gate.
  if (lost < sensible) gate.forward = std::max(2.0 * lost, own.forward);
  return gate;
}

std::vector<Row> rows_of(const Scenario& scenario) {
  const Reference reference = reference_of(scenario);
  std::vector<Row> rows;
  for (const Scalar scalar : scalars)
    for (const Route route : routes)
      rows.push_back(row_of(scenario, reference, route, scalar));
  return rows;
}

std::vector<Row> median_rows(int instances) {
  oracle::RandomChains random(seed);
  std::vector<std::vector<double>> errors(2);
  std::vector<Row> rows;
  const Scenario nominal = cases::massless_links()[3];
  for (const Scalar scalar : scalars) {
    const auto status = solve(nominal, Route::articulated_body, scalar).status;
    rows.push_back({nominal.name + "_median", nominal.family, name_of(scalar), name_of(Route::articulated_body),
                    name_of(status), nominal.size(), condition(nominal.chain, nominal.q)});
  }
  for (int k = 0; k < instances; ++k) {
    const Scenario elbow = cases::massless_elbow(random.uniform(0.1, 0.4), oracle::right_angle<double>() / 900.0);
    const Reference reference = reference_of(elbow, false);
    for (const Scalar scalar : scalars) {
      const Answer answer = solve(elbow, Route::articulated_body, scalar);
      errors[static_cast<std::size_t>(scalar)].push_back(forward_error(elbow, reference, answer.qdd));
    }
  }
  for (const Scalar scalar : scalars) {
    Row& row = rows[static_cast<std::size_t>(scalar)];
    row.forward = median(errors[static_cast<std::size_t>(scalar)]);
    row.gate.forward = scalar == Scalar::in_double ? 1e-9 : 1e-6, row.pass = row.forward <= row.gate.forward;
  }
  return rows;
}

std::vector<Row> scaling_rows() {
  std::vector<Row> rows;
  for (const Scenario& scenario : {cases::nominal_arm(), arm_with_slide()})
    for (const Scalar scalar : scalars)
      for (const Route route : routes)
        rows.push_back(scaling_row(scenario, route, scalar));
  return rows;
}

std::vector<Row> all_rows(const std::string& filter, const std::function<void(const std::string&)>& progress) {
  std::vector<Row> all;
  for (const Scenario& scenario : cases::scenarios())
    if (contains(scenario.name, filter)) {
      progress(scenario.name);
      append(all, rows_of(scenario));
    }
  for (const auto& more : {median_rows(), scaling_rows()})
    std::copy_if(more.begin(), more.end(), std::back_inserter(all),
                 [&](const Row& row) { return contains(row.scenario, filter); });
  return all;
}

}  // namespace stability
