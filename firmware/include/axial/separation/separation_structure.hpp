// Which coefficients of the separated terms are not zero, as the compiler finds by running the kernel once.
#pragma once

#include <axial/separation/separation.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace separation {

/// Which coefficients of a scene are not zero for every q.
template <class S>
struct Present : Separated<S, bool> {
  /// whether a value differs from zero by type
  template <class V>
  static constexpr bool is = !is_zero_v<V>;
  template <class V>
  constexpr void inertia(int i, int j, const V&) {
    this->A[i][j] = this->A[j][i] = is<V>;
  }  ///< notes A(i, j)
  template <class V>
  constexpr void product(int i, int j, int k, const V&) {
    this->B[i][this->pair(j, k)] = is<V>;
  }  ///< notes B(i; j k)
  template <class V>
  constexpr void square(int i, int j, const V&) {
    this->C[i][j] = is<V>;
  }  ///< notes C(i, j)
  template <class V>
  constexpr void rest(int i, const V&) {
    this->G[i] = is<V>;
  }  ///< notes G(i)
};

/// Coefficients of drives that joints share: what the joints' and G make of them.
template <class S>
constexpr auto driven_present_terms();
/// Found by types alone, so at any q: the compiler runs the algorithm once over zeros.
template <class S>
constexpr auto present_terms() {
  if constexpr (detail::shares_drives_in<typename scene_of<S>::Robot>) {
    return driven_present_terms<S>();
  } else {
    constexpr auto links = links_of<S, double, BaseParameters>();
    Present<S> found{};
    run(links, Inputs<S, double>{}, Joints<robot_of<S>, double>{},
        map_links(links, [&](auto i) { return links.link(i).z(0.0); }), found);
    return found;
  }
}
/// Coefficients of a scene that are not zero for every q.
template <class S>
inline constexpr auto present = present_terms<S>();

}  // namespace separation
}  // namespace axial

#include <axial/options/end.hpp>
