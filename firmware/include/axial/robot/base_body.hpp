// The rigid body that is fixed to frame 0 of a robot on a floating base.
#pragma once

#include <axial/robot/link.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Fluent description of that body, in axes of frame 0, with the names that a Link has; start with base_body().
class BaseBody {
 public:
  constexpr BaseBody() = default;

  constexpr const LinkParameters& parameters() const { return body_.parameters(); }  ///< the description as fields
  constexpr const detail::Given& given() const { return body_.given(); }             ///< for chain()'s checks

  /// Mass in kg.
  constexpr BaseBody mass(double kg) const { return BaseBody(body_.mass(kg)); }
  /// Centre of mass in m, in frame 0.
  constexpr BaseBody com(double x, double y, double z) const { return BaseBody(body_.com(x, y, z)); }
  /// Inertia tensor in kg m^2 about the centre of mass, axes of frame 0; products are tensor entries.
  constexpr BaseBody inertia_com(double xx, double yy, double zz, double xy = 0.0, double xz = 0.0,
                                 double yz = 0.0) const {
    return BaseBody(body_.inertia_com(xx, yy, zz, xy, xz, yz));
  }
  /// Inertia tensor in kg m^2 about the origin of frame 0; give mass and com before it.
  constexpr BaseBody inertia_origin(double xx, double yy, double zz, double xy = 0.0, double xz = 0.0,
                                    double yz = 0.0) const {
    return BaseBody(body_.inertia_origin(xx, yy, zz, xy, xz, yz));
  }
  /// What water does to it, as for a Link, in axes of frame 0.
  constexpr BaseBody added_mass(double mx, double my, double mz, double ix = 0.0, double iy = 0.0,
                                double iz = 0.0) const {
    return BaseBody(body_.added_mass(mx, my, mz, ix, iy, iz));
  }
  /// Mass of the water that it displaces (kg) and its centre of buoyancy (m, frame 0).
  constexpr BaseBody buoyancy(double displaced_kg, double x, double y, double z) const {
    return BaseBody(body_.buoyancy(displaced_kg, x, y, z));
  }
  /// Linear drag along (N s/m) and about (N m s/rad) the axes, at the centre of buoyancy.
  constexpr BaseBody drag_linear(double x, double y, double z, double rx = 0.0, double ry = 0.0,
                                 double rz = 0.0) const {
    return BaseBody(body_.drag_linear(x, y, z, rx, ry, rz));
  }
  /// Quadratic drag along (N s^2/m^2) and about (N m s^2/rad^2) the axes, at the centre of buoyancy.
  constexpr BaseBody drag_quadratic(double x, double y, double z, double rx = 0.0, double ry = 0.0,
                                    double rz = 0.0) const {
    return BaseBody(body_.drag_quadratic(x, y, z, rx, ry, rz));
  }

  /// Keeps numbers that no body should have, as their source gives them; as for a Link.
  constexpr BaseBody accept(AsPublished) const { return BaseBody(body_.accept(as_published)); }

 private:
  constexpr explicit BaseBody(const Link& body) : body_(body) {}

  Link body_{JointType::revolute};  // its joint and its drive mean nothing
};

/// The body that is fixed to frame 0: what a FloatingBase moves with the links.
constexpr BaseBody base_body() { return {}; }

}  // namespace axial

#include <axial/options/end.hpp>
