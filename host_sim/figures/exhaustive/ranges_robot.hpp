// What `./axial exhaustive --ranges` asks of one robot; a source per robot instantiates it (ranges_robot.cpp.in).
#pragma once

#include <host_sim/figures/exhaustive/fixed_quantities.hpp>
#include <host_sim/figures/exhaustive/processes.hpp>
#include <host_sim/figures/exhaustive/ranges_rows.hpp>
#include <host_sim/tools/analysis/largest.hpp>
#include <robots/robots.hpp>

#include <algorithm>
#include <cmath>

namespace exhaustive {

inline ordered_json row(const Options& options, const char* subject, const char* robot) {
  return {{"subject", subject},
          {"robot", robot},
          {"command", "./axial exhaustive --ranges --states " + std::to_string(options.states)},
          {"compiler", "g++ " __VERSION__},
          {"flags", AXIAL_EXHAUSTIVE_FLAGS},
          {"commit", options.commit}};
}

template <template <class, class> class Kernel, class S, class T>
void add_overflows(const Options& options, const char* mode, ordered_json& rows, bool& holds) {
  using R = axial::robot_of<S>;
  const std::string text = std::string(R::name) + ", " + Kernel<S, T>::name + ", " + mode + ":";
  const std::uint64_t found = in_processes(options, text.c_str(), overflows<Kernel, S, T>);
  auto one = row(options, "overflow", R::name);
  one["kernel"] = Kernel<S, T>::name, one["arithmetic"] = mode;
  one["states"] = options.states / options.processes / 100 * 100 * options.processes;
  one["overflows"] = found, one["pass"] = found == 0;
  holds = holds && found == 0;
  rows.push_back(one);
}

template <class R, class... More>
using Checked = axial::Scene<R, axial::Gravity, axial::RotorInertia, axial::RangeCheck, More...>;

template <class R>
void add_all_overflows(const Options& options, ordered_json& rows, bool& holds) {
  add_overflows<InverseDynamics, Checked<R>, axial::Fixed32>(options, "32 bits, nearest", rows, holds);
  add_overflows<InverseDynamics, Checked<R, axial::HighWord>, axial::Fixed32>(options, "32 bits, high word", rows,
                                                                              holds);
  add_overflows<InverseDynamics, Checked<R>, axial::Fixed16>(options, "16 bits, nearest", rows, holds);
  add_overflows<ForwardDynamics, Checked<R>, axial::Fixed32>(options, "32 bits, nearest", rows, holds);
  if constexpr (std::is_same_v<R, robots::Scara>)
    add_overflows<ClosedForm, Checked<R>, axial::Fixed32>(options, "32 bits, nearest", rows, holds);
}

template <class R>
void add_errors(const Options& options, ordered_json& rows, bool& holds) {
  const std::uint64_t states = std::min<std::uint64_t>(options.states, 200000);
  const int steps = static_cast<int>(states / 10);
  const auto seen = errors<InverseDynamics, R, axial::Fixed32>(states, options.seed);
  for (int i = 0; i < R::chain.size; ++i) {
    const auto& joint = seen[static_cast<std::size_t>(i)];
    const double bound = certified<R, axial::Fixed32>(i);
    const double found = adversary<R, axial::Fixed32>(i, steps, options.seed);
    auto one = row(options, "certified error", R::name);
    one["joint"] = i, one["states"] = states, one["error"] = joint.fixed, one["error_float"] = joint.in_float;
    one["largest"] = joint.largest, one["certified"] = bound;
    one["error_searched"] = found * bound;
    one["looseness"] = bound / std::fmax(joint.fixed, found * bound);
    const bool pass = joint.fixed <= bound && found <= 1.0;
    one["pass"] = pass, holds = holds && pass;
    rows.push_back(one);
  }
  for (const auto& quantity : bounded) {
    auto one = row(options, "bound", R::name);
    double nearest = 0.0;
    for (int i = 0; i < R::chain.size; ++i)
      host_sim::note_size(nearest, nearness<R>(quantity, i, steps, options.seed));
    one["quantity"] = quantity.name, one["nearest"] = nearest;
    const bool pass = nearest <= 1.0 + 1e-12;
    one["pass"] = pass, holds = holds && pass;
    rows.push_back(one);
  }
}

}  // namespace exhaustive
