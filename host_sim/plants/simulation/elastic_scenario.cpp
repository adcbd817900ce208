// Elastic joints that become rigid: a step of a millisecond, by which an implicit method resolves none of the springs
// beyond some 1e5 N m/rad.
#include <host_sim/plants/simulation/elastic.hpp>
#include <host_sim/plants/simulation/rows.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace host_sim::simulation {

namespace {

constexpr double h = 1.0 / 1024.0;
constexpr long steps = 256;
constexpr int first_exponent = 12, last_exponent = 52;  // of K, N m/rad

template <class T>
Drive<T> push(const std::vector<int>& where) {
  return [where](const Instant<T>& at, Values<T>& tau, auto&, auto&) {
    const T sway = T(8) * (at.time - T(16) * at.time * at.time * at.time);
    for (std::size_t i = 0; i < where.size(); ++i)
      tau[where[i]] = T(4) + sway;
  };
}

template <class T>
Motion<double> pushed(const Model& model, const Motion<double>& start, const std::vector<int>& where) {
  Motion<T> x;
  x.q = narrowed<T>(start.q), x.qd = narrowed<T>(start.qd);
  run(Method::linearly_implicit, model, x, static_cast<T>(h), steps, push<T>(where), [](const auto&) {});
  return exact_state(x);
}

std::vector<axial::LinkParameters> frictionless_puma() {
  auto links = robot_links("puma560");
  for (auto& link : links)
    link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
  return links;
}

Values<double> with_stiffness(double stiffness, bool narrow, const Motion<double>& start) {
  auto links = frictionless_puma();
  for (auto& link : links)
    link.stiffness = stiffness;
  const ElasticArm arm("puma560", links);
  const auto x = arm.state(start.q, start.qd);
  const std::vector<int> motors{0, 2, 4, 6, 8, 10};
  return arm.positions(narrow ? pushed<float>(arm.model(), x, motors) : pushed<double>(arm.model(), x, motors));
}

double apart(const Values<double>& a, const Values<double>& b) {
  double most = 0.0;
  for (int i = 0; i < 6; ++i)
    most = std::isfinite(a[i]) ? std::max(most, std::fabs(a[i] - b[i])) : std::numeric_limits<double>::infinity();
  return most;
}

}  // namespace

std::vector<Row> elastic_limit() {
  Motion<double> start;
  start.q = {0.25, -0.75, 2.25, 0.5, -0.5, 0.25}, start.qd = {0.5, -0.25, 0.5, 1.0, -1.0, 0.5};
  const Model rigid = model_of("puma560", frictionless_puma());
  const std::vector<int> all{0, 1, 2, 3, 4, 5};
  const auto exact = pushed<double>(rigid, start, all).q;
  constexpr double load = 36.0;  // N m, of which a K-th is left: twice what was measured, as the roundings are
  std::vector<Row> rows;
  for (int exponent = first_exponent; exponent <= last_exponent; exponent += 8) {
    const double stiffness = std::ldexp(1.0, exponent);
    for (const bool narrow : {false, true})
      rows.push_back(gated({"ST23_elastic_2^" + std::to_string(exponent), narrow ? "float" : "double",
                            name(Method::linearly_implicit), h, steps * h, "position against rigid joints', rad",
                            apart(with_stiffness(stiffness, narrow, start), exact),
                            load / stiffness + (narrow ? 1.5e-6 : 1e-14), false, ""}));
  }
  return rows;
}

}  // namespace host_sim::simulation
