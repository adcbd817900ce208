// Counts of one robot. What is listed here is what ./axial counts knows; a new algorithm is a line in count().
#pragma once

#include <axial/cost.hpp>
#include <axial/transmissions/shared_drives.hpp>
#include <host_sim/figures/counts/forms.hpp>
#include <host_sim/figures/counts/rows.hpp>
#include <robots/models/models.hpp>

#include <type_traits>

namespace counts {

/// A robot with a spring behind every joint, and a motor where it declares none. How stiff and how heavy they are does
/// not count.
template <class R>
struct Sprung {
  static constexpr auto chain = [] {
    auto chain = R::chain;
    for (auto& link : chain.links) {
      link.stiffness = 1e4;
      if (!(link.rotor_inertia > 0.0)) link.rotor_inertia = 1e-4, link.gear = 100.0;
    }
    return chain;
  }();
};
/// Scenes of elastic joints: those that a robot declares, or all where it declares none.
template <class R, class... Features>
using ElasticScene =
    Bare<std::conditional_t<axial::elastic::is_elastic<R>(), R, Sprung<R>>, axial::ElasticJoints, Features...>;

template <class R>
class RobotRows {
 public:
  std::vector<Row> count() {
    both_parameters(axial::algorithm::inverse_dynamics);
    both_parameters(axial::algorithm::bias);
    both_parameters(axial::algorithm::gravity);
    both_parameters(axial::algorithm::mass_matrix);
    both_parameters(axial::algorithm::separation);
    add<Bare<R>>(axial::algorithm::separated_torque, "base");
    if constexpr (std::is_same_v<R, robots::Scara>) {
      add<Bare<R>>(axial::algorithm::closed_form, "base");
      add<Bare<R>>(axial::algorithm::closed_form_separation, "base");
    }
    for_each_form<R>([&](auto form) { forward_dynamics(form); });
    chosen_forward_dynamics();
    both_parameters(axial::algorithm::inverse_dynamics_derivatives);
    both_parameters(axial::algorithm::forward_dynamics_derivatives);
    both_parameters(axial::algorithm::torque_rates);
    if constexpr (!shares_drives<R>) {
      add<ElasticScene<R, axial::FullParameters>>(axial::algorithm::elastic_feedforward, "full");
      add<ElasticScene<R>>(axial::algorithm::elastic_feedforward, "base");
    }
    return rows_;
  }

 private:
  // A constant expression: the compiler writes down the figure and generates no code for the kernel.
  template <class S, class Algorithm>
  Row& add(Algorithm, const char* parameters) {
    constexpr axial::Operations cost = axial::cost<S>(Algorithm{});
    rows_.push_back({R::name, Algorithm::name, parameters, cost});
    return rows_.back();
  }
  template <class Algorithm>
  void both_parameters(Algorithm algorithm) {
    add<Bare<R, axial::FullParameters>>(algorithm, "full");
    add<Bare<R>>(algorithm, "base");
  }
  template <class F>
  void forward_dynamics(const F& form) {
    Row& row = add<typename F::Scene>(axial::algorithm::forward_dynamics, form.parameters);
    row.algorithm = form.algorithm;
    row.route = form.algorithm;
  }
  // What forward_dynamics<R> is by itself: one of the rows above, by another name.
  void chosen_forward_dynamics() {
    Row& row = add<Bare<R>>(axial::algorithm::forward_dynamics, "");
    row.route = name_of(axial::forward_dynamics_route<R>);
    row.parameters = axial::forward_dynamics_route<R> == axial::Route::composite_body ? "base" : "full";
  }

  std::vector<Row> rows_;
};

}  // namespace counts
