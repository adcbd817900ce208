// What holds for a whole MJCF: units, orders of angles, where inertia comes from; and poses by these.
#pragma once

#include <host_sim/robots/import/geometry.hpp>
#include <host_sim/robots/import/mjcf/attributes.hpp>

namespace importer::mjcf {

constexpr Real pi = 3.14159265358979323846264338327950288L;

struct Settings {
  Real angle = 0.0L;                             ///< rad of a unit of angle
  std::string sequence = "xyz";                  ///< of Euler angles; capitals: about axes that stay
  bool limits_by_range = true;                   ///< autolimits
  std::string inertia_from_geoms = "auto";       ///< true, false or auto: where there is no <inertial>
  bool balance = false;                          ///< moments that no body has become their mean
  double least_mass = 0.0, least_moment = 0.0;   ///< kg, kg m^2; of any body
  double total_mass = -1.0;                      ///< kg; > 0: all bodies together
  double first_group = 0.0, last_group = 5.0;    ///< of geoms that count
  std::vector<double> gravity{0.0, 0.0, -9.81};  ///< m/s^2, in the world
};

/// From <compiler> and <option>. Refuses what changes the dynamics and is not expressed: global coordinates, air and
/// water, passive efforts that are switched off.
Settings settings_of(const Element& root);

/// Where an element's frame is: pos and one of quat, axisangle, euler, xyaxes, zaxis.
Pose pose_of(const Attributes& element, const Settings& settings);
/// The same of a geom or a site, of which fromto may give both ends instead: the line from end to beginning is its z
/// axis. `half_length` is set then.
Pose pose_of(const Attributes& element, const Settings& settings, double& half_length);

/// A vector of three numbers, or zeros.
Vector vector_of(const Attributes& element, const std::string& name);

}  // namespace importer::mjcf
