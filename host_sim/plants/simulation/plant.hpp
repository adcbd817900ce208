// What acts on a plant besides gravity: a controller, end stops, ground under the tip. In double.
#pragma once

#include <host_sim/plants/simulation/models.hpp>

#include <functional>
#include <optional>

namespace host_sim::simulation {

template <class T>
using Instant = axial::Instant<Model, T>;
template <class T>
using Stiffness = axial::DriveStiffness<Model, T>;

/// Efforts of a controller at an instant, of the joints or of the drives that they share; one that is stiff says how
/// stiff, for implicit steps.
template <class M>
using ControlOf = std::function<void(const axial::Instant<M, double>&, axial::Joints<M, double>& tau,
                                     axial::DriveStiffness<M, double>&)>;

/// A spring and a damper beyond each declared position limit, of joints and of drives that they share: N m/rad and N m
/// s/rad (N/m, N s/m). The damper acts in the stop alone and never pulls.
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

/// A robot in its surroundings under a controller: a drive for axial::advance, and for the references. M is Model or
/// DrivenModel.
template <class M>
class PlantOf {
 public:
  using Joints = axial::Joints<M, double>;             ///< of the model's values
  using Stiffness = axial::DriveStiffness<M, double>;  ///< likewise

  PlantOf(const M& model, const std::vector<axial::LinkParameters>& links, const Surroundings& surroundings,
          ControlOf<M> control);
  /// Without end stops.
  PlantOf(const M& model, const Surroundings& surroundings, ControlOf<M> control);

  const M& model() const { return model_; }
  void operator()(const axial::Instant<M, double>& at, Joints& tau, axial::Inputs<M, double>& in,
                  Stiffness& stiffness) const;
  /// Force on the tool point in world axes, N.
  axial::Vec3<double> ground_force(const Joints& q, const Joints& qd) const;

 private:
  /// Between two positions of q = ratio u + offset.
  struct Stop {
    double low, high, offset;
    Joints ratio;
  };
  void add_stops(const axial::Instant<M, double>& at, Joints& tau, Stiffness& stiffness) const;
  void add_ground(const axial::Instant<M, double>& at, axial::Inputs<M, double>& in, Stiffness& stiffness) const;

  M model_;
  std::vector<Stop> stops_;
  Surroundings surroundings_;
  ControlOf<M> control_;
};
extern template class PlantOf<Model>;
extern template class PlantOf<DrivenModel>;
using Plant = PlantOf<Model>;
using DrivenPlant = PlantOf<DrivenModel>;

}  // namespace host_sim::simulation
