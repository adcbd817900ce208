// Which coefficients of the separated terms are not zero, as the compiler finds by running the kernel once.
#pragma once

#include <axial/separation/separation.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace separation {

/// Which coefficients of a scene are not zero for every q, and what notes them.
///@{
template <class S>
using Present = Separated<S, bool>;
template <class S>
using PresentTerms = const Collected<S, bool, double, Present<S>>;
///@}

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
    PresentTerms<S> terms{found};
    run(links, Inputs<S, double>{}, Joints<robot_of<S>, double>{},
        map_links(links, [&](auto i) { return links.link(i).z(0.0); }), terms);
    return found;
  }
}
/// Coefficients of a scene that are not zero for every q.
template <class S>
inline constexpr auto present = present_terms<S>();

}  // namespace separation
}  // namespace axial

#include <axial/options/end.hpp>
