// Mass, first moment and inertia of a body in bounds: constants of the model, and what a payload adds to them at most.
#pragma once

#include <axial/fixed/balls/vector.hpp>
#include <axial/spatial/inertia.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// A constant vector of known components, and whatever may be added to it: a payload's share, the rounding of words.
struct ConstantVector {
  Number x{}, y{}, z{};  ///< components
  Ball loose{};          ///< norm of what is added, of any direction

  /// Length of the part across the joint's axis.
  constexpr double side() const { return detail::hypotenuse(x.bound.size, y.bound.size); }
  /// Length of the part along it.
  constexpr double height() const { return z.bound.size; }
  /// Everything that no direction is known of: the errors of the components are.
  constexpr Ball unknown() const {
    const double error = detail::hypotenuse(detail::hypotenuse(x.bound.error, y.bound.error), z.bound.error);
    return {loose.size, loose.error + error};
  }
};

/// A constant symmetric matrix. Its difference from the known entries is bounded by its spectral norm.
struct ConstantInertia {
  Sym3<Number> of{};  ///< kg m^2
  Ball loose{};       ///< kg m^2

  /// A bound of the known entries' spectral norm: the largest row sum.
  constexpr double norm() const {
    const auto size = [](const Number& x) { return x.bound.size; };
    return axial::detail::largest_row({size(of.xx), size(of.yy), size(of.zz), size(of.xy), size(of.xz), size(of.yz)});
  }
  /// Sum of the entries' errors, which bounds that of the norm.
  constexpr double error() const {
    return loose.error + of.xx.bound.error + of.yy.bound.error + of.zz.bound.error +
           2.0 * (of.xy.bound.error + of.xz.bound.error + of.yz.bound.error);
  }
};

/// A body as kernels see it.
using Body = RigidInertia<Number, ConstantVector, ConstantInertia>;

/// A structural zero, or a number.
///@{
constexpr Number number_of(Zero) { return literal_of(0.0); }
constexpr const Number& number_of(const Number& x) { return x; }
///@}

/// h x a of a first moment: across, h's part across times a's along and the other way round; along, both parts across.
constexpr VectorSum cross(const ConstantVector& h, const BoundedVector& v) {
  const SplitBall& a = v.bound;
  VectorSum product{detail::split(h.side() * a.along + h.height() * a.across, h.side() * a.across), {}, {}};
  const Ball rest = h.unknown() * a.whole;
  product.bound = product.bound + SplitBall{rest, rest, rest};
  const double across = a.across.largest(), along = a.along.largest();
  add_product(product.across, worse(h.x, h.y), v.exponent, along), add_product(product.across, h.z, v.exponent, across);
  add_product(product.along, h.x, v.exponent, across), add_product(product.along, h.y, v.exponent, across);
  return product;
}

}  // namespace axial::bounds

#include <axial/options/end.hpp>
