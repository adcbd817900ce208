// What water does to a body: added mass, buoyancy and drag, as a robot's author declares them.
#pragma once

#include <axial/scalar/language.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Water about a body in axes of its frame; diagonals, about the centre of buoyancy. Scenes that name Underwater see
/// it.
struct WaterParameters {
  double added_mass[3] = {0.0, 0.0, 0.0};                     ///< kg
  double added_inertia[3] = {0.0, 0.0, 0.0};                  ///< kg m^2
  double displaced_mass = 0.0;                                ///< kg of water
  double centre[3] = {0.0, 0.0, 0.0};                         ///< m, centre of buoyancy
  double drag_linear[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};     ///< N s/m (3), N m s/rad (3)
  double drag_quadratic[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};  ///< N s^2/m^2 (3), N m s^2/rad^2 (3)
};

}  // namespace axial

#include <axial/options/end.hpp>
