// A scenario by the route that a robot of its chain takes by default.
#pragma once

#include <axial/axial.hpp>
#include <stability/compiled/rows.hpp>

namespace stability {

/// Solves a scenario of R's chain.
template <class R, class T>
Answer solve_default(const Scenario& scenario) {
  axial::Joints<R, T> q{}, qd{}, tau{};
  for (int i = 0; i < q.size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    q[i] = static_cast<T>(scenario.q[k]), qd[i] = static_cast<T>(scenario.qd[k]);
    tau[i] = static_cast<T>(scenario.tau[k]);
  }
  const auto result = axial::forward_dynamics<R>(q, qd, tau);
  return {oracle::Vector<double>(result.values, result.values + q.size), result.status};
}
template <class R>
Answer solve_compiled(const Scenario& scenario, Scalar scalar) {
  return scalar == Scalar::in_double ? solve_default<R, double>(scenario) : solve_default<R, float>(scenario);
}

/// A robot that the compiler knows: solves a scenario in a number type; the form of forward dynamics that it takes.
struct Compiled {
  Answer (*solve)(const Scenario&, Scalar) = nullptr;
  Route route = Route::articulated_body;
};
template <class R>
constexpr Compiled compiled{&solve_compiled<R>, axial::forward_dynamics_route<R> == axial::Route::composite_body
                                                    ? Route::composite_body
                                                    : Route::articulated_body};
/// The robot of the scenario of that name, of one of the written sources; one without a solver where it has none.
template <int part>
Compiled compiled_robot(const std::string& name);

}  // namespace stability
