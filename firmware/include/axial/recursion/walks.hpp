// Walks over the links without a value each: from the tips to the base, from one link to the base.
#pragma once

#include <axial/recursion/passes.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Calls f(i) for every link, from the tips to the base.
template <class Links, int... I, class F>
AXIAL_INLINE constexpr void for_each_link_inwards(const IndexedLinks<Links, detail::All<I...>>&, const F& f) {
  (f(Index<Links::capacity - 1 - I>{}), ...);
}
/// Overload for looped links.
template <class Links, class F, detail::if_looped<Links> = 0>
AXIAL_INLINE constexpr void for_each_link_inwards(const Links& links, const F& f) {
  for (int i = links.size(); i-- > 0;)
    f(i);
}

/// Calls f(j) for every link between link i and the base, from its parent on.
template <class Links, class I, class F>
AXIAL_INLINE constexpr void for_each_ancestor(const Links& links, I i, const F& f) {
  if constexpr (Links::unrolled) {
    constexpr int parent = Links::template parent_of<I::value>;
    if constexpr (parent >= 0) {
      f(Index<parent>{});
      for_each_ancestor(links, Index<parent>{}, f);
    }
  } else {
    for (int j = links.parent_index(i); j >= 0; j = links.parent_index(j))
      f(j);
  }
}

}  // namespace axial

#include <axial/options/end.hpp>
