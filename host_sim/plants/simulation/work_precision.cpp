#include <host_sim/plants/simulation/work_precision.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

namespace host_sim::simulation {

namespace {

constexpr double tolerance = 1e-12;
constexpr long most_work = 270'000;  // evaluations of one row

/// Seconds of this process on a processor, whatever else runs.
double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::vector<axial::LinkParameters> without_friction(const std::string& robot) {
  auto links = robot_links(robot);
  for (auto& link : links)
    link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
  return links;
}

Problem swinging(const std::string& robot, const Start& start) {
  return {"smooth", robot, model_of(robot, without_friction(robot)), start, {}, 0.5, false, true};
}

Problem sprung(const std::string& name, int exponent, double damping, double seconds) {
  const double stiffness = std::ldexp(1.0, exponent);
  Problem p{
      name, "arm6 2^" + std::to_string(exponent), sprung_arm(stiffness, nominal_pose(), damping), {}, {}, seconds, true,
      true};
  p.start.q = nominal_pose();
  for (int i = 0; i < 6; ++i)
    p.start.q[i] += i % 2 == 0 ? 0.01 : -0.01;
  return p;
}

Problem dropped() {
  Surroundings surroundings;
  surroundings.ground = Ground{};
  const Plant plant(leg(), surroundings,
                    [](const Instant<double>& at, Values<double>& tau, Stiffness<double>& stiffness) {
                      tau[1] = -40.0 * (at.q[1] - 2.2) - at.qd[1];
                      tau[2] = -40.0 * (at.q[2] + 1.2) - at.qd[2];
                      stiffness.stiffness[1] = stiffness.stiffness[2] = 40.0;
                      stiffness.damping[1] = stiffness.damping[2] = 1.0;
                    });
  Problem p{"contact", "leg 1e5", leg(), {}, plant, 0.5, true, false};
  p.start.q = {0.55, 2.2, -1.2};
  return p;
}

struct End {
  Values<double> q{};
  std::string by;
};

template <class X>
Motion<double> moved(const Problem& p, Method method, long steps) {
  using T = typename X::Scalar;
  X x;
  x.q = narrowed<T>(p.start.q), x.qd = narrowed<T>(p.start.qd);
  Drive<T> drive = [](const auto&, auto&, auto&, auto&) {};
  if constexpr (std::is_same_v<T, double>)
    if (p.drive) drive = p.drive;
  run(method, p.model, x, static_cast<T>(p.seconds / static_cast<double>(steps)), steps, drive, [](const X&) {});
  return exact_state(x);
}

End reference_end(const Problem& p) {
  const bool contact = p.name == "contact";  // its end is known better than error control finds it
  if (!has_references() || contact) {
    const long steps = contact ? 500'000 : most_work;
    return {moved<Motion<double>>(p, Method::rk4, steps).q, "rk4"};
  }
  Motion<double> start;
  start.q = p.start.q, start.qd = p.start.qd;
  const Drive<double> none = [](const auto&, auto&, auto&, auto&) {};
  const auto method = p.stiff && p.name != "springs" ? ReferenceMethod::cvode_bdf : ReferenceMethod::arkode_erk;
  const auto result = reference(method, p.model, start, p.seconds, p.drive ? p.drive : none, tolerance);
  return {result.end.q, method == ReferenceMethod::cvode_bdf ? "cvode_bdf" : "arkode_erk"};
}

double apart(const Model& model, const Values<double>& a, const Values<double>& b) {
  double worst = 0.0;
  for (int i = 0; i < model.size(); ++i)
    worst = std::isfinite(a[i]) ? std::max(worst, std::fabs(a[i] - b[i])) : std::numeric_limits<double>::infinity();
  return worst;
}

/// Seconds of one forward dynamics of the puma560 in double, the smallest mean of several rounds.
double reference_kernel_time() {
  const Model model = robot_model("puma560");
  Values<double> q{0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, qd{};
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 20; ++round) {
    constexpr int calls = 20000;
    const double begin = now();
    for (int k = 0; k < calls; ++k)
      q[0] += 1e-9 * axial::forward_dynamics(model, q, qd, Values<double>{}, {})[0];
    best = std::min(best, (now() - begin) / calls);
  }
  return best;
}

template <class X>
WorkRow measured(const Problem& p, Method method, long steps, const End& end, double kernel) {
  using T = typename X::Scalar;
  constexpr bool compensated = std::is_same_v<X, CompensatedMotion<T>>;
  const double begin = now();
  const auto x = moved<X>(p, method, steps);
  const double took = now() - begin;
  WorkRow row{p.name,
              p.robot,
              sizeof(T) == 4 ? "float" : "double",
              std::string(name(method)) + (compensated ? ", compensated" : ""),
              p.seconds / static_cast<double>(steps),
              p.seconds,
              apart(p.model, x.q, end.q),
              steps * evaluations(method),
              took / kernel,
              false,
              end.by};
  if (!(row.error < 10.0)) row.error = std::numeric_limits<double>::infinity();
  return row;
}

void add_rows(std::vector<WorkRow>& rows, const Problem& p, double kernel) {
  const End end = reference_end(p);
  for (const Method method : methods)
    for (long steps = 64; steps * evaluations(method) <= most_work; steps *= 4) {
      rows.push_back(measured<Motion<double>>(p, method, steps, end, kernel));
      if (!p.by_float) continue;
      rows.push_back(measured<Motion<float>>(p, method, steps, end, kernel));
      rows.push_back(measured<CompensatedMotion<float>>(p, method, steps, end, kernel));
    }
}

void mark_pareto(std::vector<WorkRow>& rows) {
  for (WorkRow& row : rows) {
    row.pareto = std::isfinite(row.error);
    for (const WorkRow& other : rows) {
      if (other.subject != row.subject || other.robot != row.robot) continue;
      const bool as_good = other.error <= row.error && other.work <= row.work;
      if (as_good && (other.error < row.error || other.work < row.work)) row.pareto = false;
    }
  }
}

}  // namespace

std::vector<Problem> problems() {
  return {swinging("scara", {{0.3, -0.5, 0.05}, {2.0, -1.0, 0.1}}),
          swinging("puma560", {{0.2, -0.7, 2.2, 0.3, 0.4, 0.0}, {1.0, 0.5, -1.0, 0.5, -0.5, 1.0}}),
          sprung("springs", 14, 0.0, 0.1),
          sprung("damped_springs", 14, 256.0, 0.05),
          sprung("damped_springs", 20, 4096.0, 0.02),
          dropped()};
}

std::vector<WorkRow> work_precision(const std::function<void(const std::string&)>& progress) {
  const double kernel = reference_kernel_time();
  std::vector<WorkRow> rows;
  for (const Problem& p : problems()) {
    progress(p.name + ", " + p.robot);
    add_rows(rows, p, kernel);
  }
  mark_pareto(rows);
  return rows;
}

nlohmann::json to_json(const std::vector<WorkRow>& rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const WorkRow& r : rows)
    list.push_back({{"subject", "simulation, " + r.subject},
                    {"robot", r.robot},
                    {"scalar", r.scalar},
                    {"variant", r.variant},
                    {"board", "host"},
                    {"error", std::isfinite(r.error) ? r.error : std::numeric_limits<double>::max()},
                    {"diverged", !std::isfinite(r.error)},
                    {"work", r.work},
                    {"unit_of_work", "kernel calls"},
                    {"time_ratio", r.time_ratio},
                    {"step", r.step},
                    {"seconds", r.seconds},
                    {"reference", r.reference},
                    {"pareto", r.pareto}});
  return list;
}

}  // namespace host_sim::simulation
