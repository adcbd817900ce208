// Links over which Newton and Euler's recursion differentiates itself: those of a table keep numbers with derivatives.
#pragma once

#include <axial/links/links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// A link of a table that keeps numbers with derivatives; its constants are plain ones.
template <class Number, class Link>
struct DifferentiatedLink : Link {
  /// The form in which this view keeps a result.
  template <class V>
  AXIAL_INLINE static constexpr auto shape(const V& v) {
    return v.template dense<Number>();
  }
};
/// Links of a table that keep numbers with derivatives.
template <class Number, class Links>
struct DifferentiatedTable : Links {
  using Dense = Number;  ///< what kernels keep
  AXIAL_INLINE constexpr auto link(int i) const {
    return DifferentiatedLink<Number, decltype(Links::link(i))>{Links::link(i)};
  }  ///< link i as algorithms see it
};
/// Links that may keep numbers with derivatives: those that the compiler knows keep whatever type comes.
template <class Number, class Links>
AXIAL_INLINE constexpr auto differentiated(const Links& links) {
  if constexpr (Links::unrolled)
    return links;
  else
    return DifferentiatedTable<Number, Links>{links};
}

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>
