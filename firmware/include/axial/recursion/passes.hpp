// Passes over the links: outward (from the base), inward (from the tips). One form for unrolled and looped links.
#pragma once

#include <axial/links/links.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

template <int I, class V>
struct Slot {
  V value{};
};
template <int I, class V>
AXIAL_INLINE constexpr V& pick(Slot<I, V>& slot) {
  return slot.value;
}
template <int I, class V>
AXIAL_INLINE constexpr const V& pick(const Slot<I, V>& slot) {
  return slot.value;
}

template <class Indices, class... V>
struct SlotsOf;
template <int... I, class... V>
struct SlotsOf<std::integer_sequence<int, I...>, V...> : Slot<I, V>... {
  template <int K>
  AXIAL_INLINE constexpr auto& operator[](Index<K>) {
    return pick<K>(*this);
  }
  template <int K>
  AXIAL_INLINE constexpr const auto& operator[](Index<K>) const {
    return pick<K>(*this);
  }
};

}  // namespace detail

/// One value per link, each of its own type; `slots[Index<2>{}]`.
template <class... V>
struct Slots : detail::SlotsOf<std::make_integer_sequence<int, sizeof...(V)>, V...> {
  /// slots with one more
  template <class Next>
  using Append = Slots<V..., Next>;
};

/// One value per link, all of one type.
template <class V, int N>
struct Row {
  V values[N] = {};                                                  ///< one per link
  AXIAL_INLINE constexpr V& operator[](int i) { return values[i]; }  ///< value of link i; the index is not checked
  /// Value of link i; the index is not checked.
  AXIAL_INLINE constexpr const V& operator[](int i) const { return values[i]; }
};

namespace detail {

template <class Step, int I, class Parent>
using StepResult = std::decay_t<decltype(std::declval<const Step&>()(Index<I>{}, std::declval<const Parent&>()))>;

template <int P, class Root, class Values>
AXIAL_INLINE constexpr const auto& value_or_root(Index<P> parent, const Root& root, const Values& values) {
  if constexpr (P < 0)
    return root;
  else
    return values[parent];
}

// The type of every slot of an outward pass, found link by link.
template <class Links, class Root, class Step, class Found, int Rest>
struct Outward {
  static constexpr int I = Links::capacity - Rest;
  using Parent =
      decltype(value_or_root(Index<Links::template parent_of<I>>{}, std::declval<Root>(), std::declval<Found>()));
  using type =
      typename Outward<Links, Root, Step, typename Found::template Append<StepResult<Step, I, Parent>>, Rest - 1>::type;
};
template <class Links, class Root, class Step, class Found>
struct Outward<Links, Root, Step, Found, 0> {
  using type = Found;
};

template <int... I>
using All = std::integer_sequence<int, I...>;  // deduced, for what is inlined is copied once per function on the way
/// Selects the form of a pass for links that a loop walks over; stops the compiler at others.
template <class Links>
using if_looped = std::enable_if_t<(static_cast<void>(Walkable<Links>{}), !Links::unrolled), int>;

struct Itself {
  template <class Joint>
  constexpr Joint operator()(Joint joint) const {
    return joint;
  }
};
/// Kind of an unrolled link's joint: Revolute or Prismatic. What is called with it, not from on_joint(), the compiler
/// inlines two times less.
template <class Link>
using KindOfJoint = decltype(std::declval<const Link&>().on_joint(Itself{}));

}  // namespace detail

/// Calls f(i) for every link, outwards.
template <class Links, int... I, class F>
AXIAL_INLINE constexpr void for_each_link(const IndexedLinks<Links, detail::All<I...>>&, const F& f) {
  (f(Index<I>{}), ...);
}
/// Overload for looped links.
template <class Links, class F, detail::if_looped<Links> = 0>
AXIAL_INLINE constexpr void for_each_link(const Links& links, const F& f) {
  for (int i = 0; i < links.size(); ++i)
    f(i);
}

/// values[i] = f(i).
template <class Links, int... I, class F>
AXIAL_INLINE constexpr auto map_links(const IndexedLinks<Links, detail::All<I...>>&, const F& f) {
  return Slots<std::decay_t<decltype(f(Index<I>{}))>...>{{{f(Index<I>{})}...}};
}
/// Overload for looped links.
template <class Links, class F, detail::if_looped<Links> = 0>
AXIAL_INLINE constexpr auto map_links(const Links& links, const F& f) {
  Row<std::decay_t<decltype(f(0))>, Links::capacity> values;
  for (int i = 0; i < links.size(); ++i)
    values[i] = f(i);
  return values;
}

/// values[i] = step(i, value of the parent), the base's being `root`.
template <class Links, int... I, class Root, class Step>
AXIAL_INLINE constexpr auto outward(const IndexedLinks<Links, detail::All<I...>>&, const Root& root, const Step& step) {
  using namespace detail;
  typename Outward<Links, Root, Step, Slots<>, Links::capacity>::type values{};
  ((values[Index<I>{}] = step(Index<I>{}, value_or_root(Index<Links::template parent_of<I>>{}, root, values))), ...);
  return values;
}
/// Overload for looped links.
template <class Links, class Root, class Step, detail::if_looped<Links> = 0>
AXIAL_INLINE constexpr auto outward(const Links& links, const Root& root, const Step& step) {
  auto dense_root = root.template dense<typename Links::Dense>();
  Row<std::decay_t<decltype(step(0, dense_root))>, Links::capacity> values;
  for (int i = 0; i < links.size(); ++i) {
    const int parent = links.parent_index(i);
    values[i] = step(i, parent < 0 ? dense_root : values[parent]);
  }
  return values;
}

namespace detail {

struct NoLoad {};

template <class V>
AXIAL_INLINE constexpr auto loaded(const V& own, NoLoad) {
  return own;
}
template <class V, class W>
AXIAL_INLINE constexpr auto loaded(const V& own, const W& load) {
  return own + load;
}
AXIAL_INLINE constexpr NoLoad loaded(NoLoad, NoLoad) { return {}; }
template <class W>
AXIAL_INLINE constexpr auto loaded(NoLoad, const W& load) {
  return load;
}

template <class Pass, int I>
using LeftBy = decltype(std::declval<const Pass&>().template result_type<I>());

// The first link from C on that link I carries; `capacity` where there is none.
template <class Links, int I, int C>
constexpr int child_of() {
  if constexpr (C >= Links::capacity)
    return C;
  else
    return Links::template parent_of<C> == I ? C : child_of<Links, I, C + 1>();
}

// The pass over a tree of types: what the children of link I, from child C on, send to it.
template <class Links, class Own, class Joint>
struct Inward {
  const Own& own;
  const Joint& joint;

  template <int I, int From>
  AXIAL_INLINE constexpr auto loads_type() const {
    constexpr int child = child_of<Links, I, From>();
    if constexpr (child >= Links::capacity)
      return NoLoad{};
    else
      return loaded(loads_type<I, child + 1>(), result_type<child>().on_parent);
  }
  template <int I>
  AXIAL_INLINE constexpr auto result_type() const {
    return joint(Index<I>{}, loaded(own(Index<I>{}), loads_type<I, I + 1>()));
  }

  template <int I, int From, class Values>
  AXIAL_INLINE static constexpr auto loads(const Values& values) {
    constexpr int child = child_of<Links, I, From>();
    if constexpr (child >= Links::capacity)
      return NoLoad{};
    else
      return loaded(loads<I, child + 1>(values), values[Index<child>{}].on_parent);
  }
};

}  // namespace detail

/// From the tips to the base: left[i] = joint(i, own(i) + what the children sent). What joint() returns has a member
/// `sent`, the load on the parent in the parent's frame; nothing reads the load that a root link sends.
template <class Links, int... I, class Own, class Joint>
AXIAL_INLINE constexpr auto inward(const IndexedLinks<Links, detail::All<I...>>&, const Own& own, const Joint& joint) {
  using Pass = detail::Inward<Links, Own, Joint>;
  constexpr int last = Links::capacity - 1;
  Slots<detail::LeftBy<Pass, I>...> left{};
  ((left[Index<last - I>{}] = joint(
        Index<last - I>{}, detail::loaded(own(Index<last - I>{}), Pass::template loads<last - I, last - I + 1>(left)))),
   ...);
  return left;
}
/// Overload for looped links.
template <class Links, class Own, class Joint, detail::if_looped<Links> = 0>
AXIAL_INLINE constexpr auto inward(const Links& links, const Own& own, const Joint& joint) {
  Row<std::decay_t<decltype(own(0))>, Links::capacity> total;
  Row<std::decay_t<decltype(joint(0, own(0)))>, Links::capacity> left;
  for (int i = 0; i < links.size(); ++i)
    total[i] = own(i);
  for (int i = links.size(); i-- > 0;) {
    left[i] = joint(i, total[i]);
    if (const int parent = links.parent_index(i); parent >= 0) total[parent] = total[parent] + left[i].on_parent;
  }
  return left;
}

}  // namespace axial

#include <axial/options/end.hpp>
