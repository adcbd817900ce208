// The exponents of poses and Jacobians.
#pragma once

#include <axial/fixed/links/fixed_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Exponents of what kinematics answers in fixed point T: of lengths (m), and of entries of rotations and directions.
template <class S, class T>
inline constexpr int length_exponent =
    decltype(links_of<S, T, FullParameters, recursion::Kinematics>().link(Index<0>{}))::format.length;
/// The same of entries of rotations and directions.
template <class T>
inline constexpr int direction_exponent = 8 * static_cast<int>(sizeof(typename T::Word)) - 2;

}  // namespace axial

#include <axial/options/end.hpp>
