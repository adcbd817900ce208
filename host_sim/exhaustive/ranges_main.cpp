// Overflows, certified errors and bounds of fixed point, robot by robot, over as many states as there is time for.
#include <host_sim/exhaustive/fixed_quantities.hpp>
#include <host_sim/output/files.hpp>
#include <host_sim/output/table.hpp>
#include <robots/robots.hpp>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace {

using namespace axial;
using nlohmann::ordered_json;

struct Options {
  std::uint64_t states = 1000000, seed = 1;
  unsigned processes = 2;
  std::string robot = "all", commit;
};

/// Overflows over all states: in processes, since the count of overflows is one a process.
template <class Part>
std::uint64_t in_processes(const Options& options, const char* text, const Part& part) {
  std::uint64_t all = 0;
  std::vector<std::pair<pid_t, int>> children;
  for (unsigned k = 0; k < options.processes; ++k) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
      constexpr int parts = 100;
      std::uint64_t found = 0;
      for (int p = 0; p < parts; ++p) {
        found += part(options.states / options.processes / parts,
                      options.seed * 1000003U + k * 1009U + static_cast<unsigned>(p));
        if (k == 0 && isatty(2) != 0) std::fprintf(stderr, "\r%s %d %%", text, p + 1);
      }
      if (k == 0) std::fprintf(stderr, isatty(2) != 0 ? "\n" : "%s done\n", text);
      const bool told = write(ends[1], &found, sizeof found) == static_cast<ssize_t>(sizeof found);
      _exit(told ? 0 : 1);
    }
    close(ends[1]);
    children.emplace_back(child, ends[0]);
  }
  for (const auto& [child, end] : children) {
    std::uint64_t found = 0;
    const bool heard = read(end, &found, sizeof found) == static_cast<ssize_t>(sizeof found);
    int status = 0;
    waitpid(child, &status, 0);
    close(end);
    if (!heard || status != 0) throw std::runtime_error("a process ended early");
    all += found;
  }
  return all;
}

ordered_json row(const Options& options, const char* subject, const char* robot) {
  return {{"subject", subject},
          {"robot", robot},
          {"command", "./axial exhaustive --ranges --states " + std::to_string(options.states)},
          {"compiler", "g++ " __VERSION__},
          {"flags", AXIAL_EXHAUSTIVE_FLAGS},
          {"commit", options.commit}};
}

template <template <class, class> class Kernel, class S, class T>
void add_overflows(const Options& options, const char* mode, ordered_json& rows, bool& holds) {
  using R = robot_of<S>;
  const std::string text = std::string(R::name) + ", " + Kernel<S, T>::name + ", " + mode + ":";
  const std::uint64_t found = in_processes(options, text.c_str(), exhaustive::overflows<Kernel, S, T>);
  auto one = row(options, "overflow", R::name);
  one["kernel"] = Kernel<S, T>::name, one["arithmetic"] = mode;
  one["states"] = options.states / options.processes / 100 * 100 * options.processes;
  one["overflows"] = found, one["pass"] = found == 0;
  holds = holds && found == 0;
  rows.push_back(one);
}

template <class R, class... More>
using Checked = Scene<R, Gravity, RotorInertia, RangeCheck, More...>;

template <class R>
void add_all_overflows(const Options& options, ordered_json& rows, bool& holds) {
  add_overflows<exhaustive::InverseDynamics, Checked<R>, Fixed32>(options, "32 bits, nearest", rows, holds);
  add_overflows<exhaustive::InverseDynamics, Checked<R, HighWord>, Fixed32>(options, "32 bits, high word", rows, holds);
  add_overflows<exhaustive::InverseDynamics, Checked<R>, Fixed16>(options, "16 bits, nearest", rows, holds);
  add_overflows<exhaustive::ForwardDynamics, Checked<R>, Fixed32>(options, "32 bits, nearest", rows, holds);
  if constexpr (std::is_same_v<R, robots::Scara>)
    add_overflows<exhaustive::ClosedForm, Checked<R>, Fixed32>(options, "32 bits, nearest", rows, holds);
}

template <class R>
void add_errors(const Options& options, ordered_json& rows, bool& holds) {
  const std::uint64_t states = std::min<std::uint64_t>(options.states, 200000);
  const int steps = static_cast<int>(states / 10);
  const auto seen = exhaustive::errors<exhaustive::InverseDynamics, R, Fixed32>(states, options.seed);
  for (int i = 0; i < R::chain.size; ++i) {
    const auto& joint = seen[static_cast<std::size_t>(i)];
    const double bound = exhaustive::certified<R, Fixed32>(i);
    const double found = exhaustive::adversary<R, Fixed32>(i, steps, options.seed);
    auto one = row(options, "certified error", R::name);
    one["joint"] = i, one["states"] = states, one["error"] = joint.fixed, one["error_float"] = joint.in_float;
    one["largest"] = joint.largest, one["certified"] = bound;
    one["error_searched"] = found * bound;
    one["looseness"] = bound / std::fmax(joint.fixed, found * bound);
    one["pass"] = joint.fixed <= bound && found <= 1.0;
    holds = holds && one["pass"].get<bool>();
    rows.push_back(one);
  }
  for (const auto& quantity : exhaustive::bounded) {
    auto one = row(options, "bound", R::name);
    double nearest = 0.0;
    for (int i = 0; i < R::chain.size; ++i)
      nearest = std::fmax(nearest, exhaustive::nearness<R>(quantity, i, steps, options.seed));
    one["quantity"] = quantity.name, one["nearest"] = nearest, one["pass"] = nearest <= 1.0 + 1e-12;
    holds = holds && one["pass"].get<bool>();
    rows.push_back(one);
  }
}

void print(const ordered_json& rows) {
  host_sim::Table overflow({"robot", "kernel", "arithmetic", "states", "overflows"});
  host_sim::Table error({"robot", "joint", "worst error", "float", "worst by search", "certified", "looseness"});
  host_sim::Table bound({"robot", "quantity", "nearest to its bound"});
  const auto number = [](const ordered_json& value) { return host_sim::significant(value.get<double>(), 3); };
  for (const auto& one : rows) {
    const std::string robot = one["robot"];
    if (one["subject"] == "overflow")
      overflow.add({robot, one["kernel"], one["arithmetic"], host_sim::grouped(one["states"].get<std::uint64_t>()),
                    std::to_string(one["overflows"].get<std::uint64_t>())});
    else if (one["subject"] == "bound")
      bound.add({robot, one["quantity"], number(one["nearest"])});
    else
      error.add({robot, std::to_string(one["joint"].get<int>()), number(one["error"]), number(one["error_float"]),
                 number(one["error_searched"]), number(one["certified"]), number(one["looseness"])});
  }
  for (const auto* table : {&overflow, &error, &bound})
    std::printf("%s\n", table->text().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("overflows, certified errors and bounds of fixed point");
  Options options;
  std::string json;
  app.add_option("--states", options.states)->check(CLI::Range(std::uint64_t{1000}, std::uint64_t{1} << 40));
  app.add_option("--processes", options.processes)->check(CLI::Range(1, 64));
  app.add_option("--seed", options.seed);
  app.add_option("--robot", options.robot);
  app.add_option("--json", json);
  app.add_option("--commit", options.commit);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    ordered_json rows = ordered_json::array();
    bool holds = true, known = false;
    const auto visit = [&](auto robot) {
      using R = typename decltype(robot)::Robot;
      if (options.robot != "all" && options.robot != R::name) return;
      known = true;
      add_all_overflows<R>(options, rows, holds);
      add_errors<R>(options, rows, holds);
    };
    robots::All::for_each(visit), robots::Published::for_each(visit);
    if (!known) throw std::runtime_error("no robot is called '" + options.robot + "'");
    print(rows);
    if (!json.empty()) host_sim::write_json(json, rows);
    if (!holds) std::fprintf(stderr, "exhaustive: a bound does not hold\n");
    return holds ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "exhaustive: %s\n", error.what());
    return 1;
  }
}
