// A scenario in 32-bit fixed point, of a robot that the compiler knows: the split articulated bodies, which are the
// route of fixed point.
#pragma once

#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <firmware/apps/number_systems.hpp>
#include <oracle/compare.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/recursive.hpp>
#include <stability/fixed/declared.hpp>
#include <stability/fixed/rows.hpp>
#include <stdexcept>

namespace stability {

/// Robot R in the state of a scenario of its chain; a source each (robot.cpp.in).
template <class R>
class FixedScenario {
 public:
  explicit FixedScenario(const Scenario& scenario) : scenario_(scenario) {
    const auto own = oracle::of_robot<double, R>();
    for (int i = 0; i < own.size(); ++i)
      if (!same(own[i], scenario.chain[i])) throw std::logic_error("not the chain of " + scenario.name);
  }

  /// The reference solves what fixed point was given: the nearest positions, speeds and efforts that it holds.
  Row row() const {
    const auto q = axial::apps::nearest_positions<R, T>(joints(scenario_.q));
    const auto qd = axial::apps::nearest<axial::Velocities<R, T>>(joints(scenario_.qd));
    const auto tau = axial::apps::nearest<axial::EffortsOf<R, T>>(joints(scenario_.tau));
    const auto result = axial::forward_dynamics<R, T>(q, qd, tau);
    const auto wanted =
        oracle::recursive_forward_dynamics(oracle::of_robot<quad, R>(), positions(q), exact(qd), exact(tau));
    Row row{scenario_.name,         scenario_.family, "fixed32", name_of(Route::split_articulated_body),
            name_of(result.status), scenario_.size()};
    row.condition = condition(scenario_.chain, scenario_.q);
    row.absolute = scenario_.measure == cases::Measure::absolute;
    row.forward = oracle::relative_error(exact(result), wanted) * (row.absolute ? oracle::largest(wanted) : 1.0);
    row.backward = std::nan("");
    row.pass = result.status.ok();
    return row;
  }

 private:
  using T = axial::Fixed32;

  static bool same(const oracle::Link<double>& a, const oracle::Link<double>& b) {
    const auto equal = [](const oracle::Vec3<double>& u, const oracle::Vec3<double>& v) {
      return u.x == v.x && u.y == v.y && u.z == v.z;
    };
    return a.alpha == b.alpha && a.a == b.a && a.d == b.d && a.mass == b.mass && equal(a.com, b.com) &&
           equal(a.inertia.c0, b.inertia.c0) && equal(a.inertia.c1, b.inertia.c1) &&
           equal(a.inertia.c2, b.inertia.c2) && a.rotor_inertia == b.rotor_inertia;
  }
  static axial::Joints<R, double> joints(const oracle::Vector<double>& values) {
    axial::Joints<R, double> result{};
    for (int i = 0; i < R::chain.size; ++i)
      result[i] = values[static_cast<std::size_t>(i)];
    return result;
  }
  template <class Values>
  static cases::Values exact(const Values& values) {
    cases::Values result;
    for (int i = 0; i < R::chain.size; ++i)
      result.push_back(quad(values[i].raw) * quad(std::ldexp(1.0, -Values::exponent(i))));
    return result;
  }
  template <class Values>
  static cases::Values positions(const Values& values) {
    cases::Values result;
    for (int i = 0; i < R::chain.size; ++i)  // all of them turn: a turn is 2^32
      result.push_back(quad(values[i].raw) * oracle::right_angle<quad>() / quad(0x1p30));
    return result;
  }

  const Scenario& scenario_;
};

}  // namespace stability
