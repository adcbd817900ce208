// The standard inertial parameters of a link and its drive, in which joint torque is linear.
#pragma once

#include <axial/robot/link_parameters.hpp>

#include <array>
#include <string>
#include <vector>

namespace host_sim::identification {

/// Of one link, in this order (C. G. Atkeson, C. H. An, J. M. Hollerbach, IJRR 5(3), 1986): mass m (kg), first moment
/// m c (kg m), inertia about the origin of the link's frame (kg m^2, tensor entries), then of its drive on the joint's
/// side: gear^2 J (kg m^2 or kg), viscous friction (N m s/rad or N s/m), Coulomb effort forward and backward (N m or
/// N).
inline constexpr std::array<const char*, 14> parameter_names = {
    "m", "mx", "my", "mz", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz", "rotor", "viscous", "forward", "backward"};
inline constexpr int parameters_per_link = static_cast<int>(parameter_names.size());
inline constexpr int inertial_parameters = 10;
using Parameters = std::array<double, parameters_per_link>;

Parameters to_parameters(const axial::LinkParameters& link);

/// A link with these parameters and everything else as it was; a massless link keeps its centre of mass at the origin.
axial::LinkParameters with_parameters(axial::LinkParameters link, const Parameters& parameters);

/// The link without what is identified: geometry, limits, springs and static friction stay.
axial::LinkParameters without_parameters(const axial::LinkParameters& link);

}  // namespace host_sim::identification
