// The exponents of poses and Jacobians.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/links/fixed_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {
template <class Links>
constexpr int length_format() {
  using OfJoints = decltype(execute<JointLinks>(std::declval<const Links&>()));
  return decltype(std::declval<OfJoints>().link(Index<0>{}))::format.length;
}
}  // namespace detail

/// Exponent of the lengths (m) that kinematics answers in fixed point T.
template <class S, class T>
inline constexpr int length_exponent =
    detail::length_format<decltype(links_of<S, T, FullParameters, recursion::Kinematics>())>();
/// Exponent of entries of the rotations and directions that kinematics answers in fixed point T.
template <class T>
inline constexpr int direction_exponent = 8 * static_cast<int>(sizeof(typename T::Word)) - 2;

}  // namespace axial

#include <axial/options/end.hpp>
