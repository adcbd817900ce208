// Payload and wrench at the tip in bounds: as large as the robot declares them, in whatever direction.
#pragma once

#include <axial/fixed/balls/composite.hpp>
#include <axial/fixed/bounds/mechanism.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// A run-time payload: its declared limits, and the exponents of its words.
struct Load {
  Number mass{};             ///< kg
  double com_reach = 0.0;    ///< m
  double inertia = 0.0;      ///< kg m^2, norm about the centre of mass
  int com_exponent = 0;      ///< of the centre's components
  int inertia_exponent = 0;  ///< of the entries of the inertia
};

/// Run-time inputs in bounds.
struct GivenLoads {
  Load payload{};                                          ///< on the last link
  ForceVector<BoundedVector, BoundedVector> tip_wrench{};  ///< N m, N
};

/// Kernels read them as they are.
///@{
template <class Scene, class Scalar>
constexpr const Load& read_payload(const Load& load) {
  return load;
}
template <class Scene, class Scalar>
constexpr const ForceVector<BoundedVector, BoundedVector>& read_wrench(
    const ForceVector<BoundedVector, BoundedVector>& wrench) {
  return wrench;
}
///@}

namespace detail {

// A word's exponent by the largest value of an input (fixed_inputs.hpp).
constexpr int input_exponent(double most, const WordRounding& r) {
  return axial::detail::fitting_exponent(most, r.capacity());
}
constexpr BoundedVector given(double norm, const WordRounding& r) {
  const Ball any{norm, 0.0};
  return {{any, any, any}, input_exponent(norm, r), false, &r};
}
constexpr GivenLoads given_loads(const LoadRange& l, const WordRounding& r) {
  const double reach = l.payload_mass > 0.0 ? l.payload_moment / l.payload_mass : 0.0;
  const double inertia = (l.payload_inertia - l.payload_moment * reach) / 3.0;
  return {{word_of({l.payload_mass, 0.0}, input_exponent(l.payload_mass, r)), reach, inertia, input_exponent(reach, r),
           input_exponent(inertia, r)},
          {given(l.tip_moment, r), given(l.tip_force, r)}};
}
constexpr double rounding_of_product(int a, int b, int exponent, const WordRounding& r) {
  Terms terms;
  terms.add_product(a + b);
  return terms.rounding(exponent, r);
}

}  // namespace detail

/// A payload about the origin of the last link's frame: h = m c, and by the parallel-axis theorem J = J_com + (c.c) m -
/// h c^T. An entry rounds its own sum and what h and the squares were rounded to.
template <class Link>
constexpr Body payload_inertia(const Link& link, const Load& load) {
  using namespace quantity;
  const WordRounding& r = link.rounding();
  const int h = link.exponent(FirstMoment{}), j = link.exponent(RotationalInertia{});
  const double moment = load.mass.bound.size * load.com_reach;
  const double of_h = detail::rounding_of_product(load.mass.exponent, load.com_exponent, h, r);
  const double of_square = detail::rounding_of_product(h, load.com_exponent, j, r);
  const double of_entry = r.move(load.inertia_exponent, j);
  const double entry = 2.0 * (of_h * load.com_reach + of_square) + of_entry;
  const Ball inertia{3.0 * load.inertia + moment * load.com_reach, 3.0 * entry};
  // Words whose products round, also where the link's own share of them is zero.
  const Ball some{0.0, 1e-300};
  const Number first = word_of(some, h), entries = word_of(some, j);
  return {load.mass,
          {first, first, first, {moment, detail::root3 * of_h}},
          {{entries, entries, entries, entries, entries, entries}, inertia}};
}

}  // namespace axial::bounds

#include <axial/options/end.hpp>
