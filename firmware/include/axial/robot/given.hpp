// What has been said of a link so far: which quantities, which of them twice, and whether its numbers are accepted.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Says that numbers which no robot should have are kept as their source gives them: `.accept(axial::as_published)` of
/// a link, `axial::accept(axial::as_published)` among the parts of chain() for the whole robot.
struct AsPublished {};
inline constexpr AsPublished as_published{};  ///< for accept()

namespace detail {

/// What a link's builder names, in the order of Problem's "twice".
enum class Quantity : unsigned char {
  a,
  alpha,
  d,
  theta,
  mass,
  com,
  inertia,
  rotor_inertia,
  rotor_axis,
  viscous,
  coulomb,
  stribeck,
  smooth_speed,
  spring,
  stiffness,
  position_limits,
  speed_limit,
  acceleration_limit,
  effort_limit,
  parent,
  branch,
  added_mass,
  buoyancy,
  drag_linear,
  drag_quadratic,
  count
};

/// Filled by a link's builder, read by the checks of chain().
struct Given {
  unsigned once = 0, twice = 0;       ///< a bit for each Quantity
  bool accepted = false;              ///< as published
  bool inertia_about_origin = false;  ///< which was shifted by the mass and com that were known then
  bool body_after_inertia = false;    ///< and then these came
  bool degrees_of_a_slide = false;    ///< position_limits_deg() of a prismatic joint

  constexpr bool has(Quantity quantity) const { return (once >> static_cast<unsigned>(quantity) & 1U) != 0; }
  constexpr void note(Quantity quantity) {
    const unsigned mark = 1U << static_cast<unsigned>(quantity);
    twice |= once & mark, once |= mark;
    if (inertia_about_origin && (quantity == Quantity::mass || quantity == Quantity::com)) body_after_inertia = true;
  }
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
