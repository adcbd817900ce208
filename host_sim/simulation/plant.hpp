// What acts on a plant besides gravity: a controller, end stops, ground under the tip. In double.
#pragma once

#include <host_sim/simulation/models.hpp>

#include <functional>
#include <optional>

namespace host_sim::simulation {

template <class T>
using Instant = axial::Instant<Model, T>;
template <class T>
using Stiffness = axial::DriveStiffness<Model, T>;

/// Efforts of a controller at an instant; one that is stiff says how stiff, for implicit steps.
template <class T>
using Control = std::function<void(const Instant<T>&, Values<T>& tau, Stiffness<T>&)>;

/// A spring and a damper beyond each declared position limit: N m/rad and N m s/rad (N/m, N s/m). The damper acts in
/// the stop alone and never pulls.
struct EndStops {
  double stiffness = 0.0, damping = 0.0;
};

/// Ground at a height (m) in the world below the tool point, with a force of Hunt and Crossley: k depth (1 - 3/2 c
/// v_z), never pulling, and Coulomb friction smoothed by tanh(v / slip_speed).
struct Ground {
  double height = 0.0, stiffness = 1e5, dissipation = 0.5;  ///< m, N/m, s/m
  double friction = 0.8, slip_speed = 1e-3;                 ///< of the normal force, m/s
};

struct Surroundings {
  EndStops stops;
  std::optional<Ground> ground;
};

/// A robot in its surroundings under a controller: a drive for axial::advance, and for the references.
class Plant {
 public:
  Plant(const Model& model, const std::vector<axial::LinkParameters>& links, const Surroundings& surroundings,
        Control<double> control);
  /// Without end stops.
  Plant(const Model& model, const Surroundings& surroundings, Control<double> control);

  const Model& model() const { return model_; }
  void operator()(const Instant<double>& at, Values<double>& tau, axial::Inputs<Model, double>& in,
                  Stiffness<double>& stiffness) const;
  /// Force on the tool point in world axes, N.
  axial::Vec3<double> ground_force(const Values<double>& q, const Values<double>& qd) const;

 private:
  void add_stops(const Instant<double>& at, Values<double>& tau, Stiffness<double>& stiffness) const;
  void add_ground(const Instant<double>& at, axial::Inputs<Model, double>& in, Stiffness<double>& stiffness) const;

  Model model_;
  Values<double> low_{}, high_{};
  Surroundings surroundings_;
  Control<double> control_;
};

}  // namespace host_sim::simulation
