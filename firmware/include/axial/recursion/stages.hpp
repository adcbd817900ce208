// Stages of a kernel as functions of their own, where numbers ask for that: each then has a stack frame of its own.
#pragma once

#include <axial/recursion/passes.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// How kernels over numbers T are cut into functions; a number system may have its own way.
template <class T>
struct StagesOver {
  template <class Links>
  static constexpr bool apart = false;  ///< whether stages, and steps where a stage says so, are functions of their own
};
/// Whether the stages of forward dynamics over these links are functions of their own.
template <class Links>
inline constexpr bool stages_apart = StagesOver<typename Links::Scalar>::template apart<Links>;

/// f(), as a function of its own.
template <class F>
[[gnu::noinline]] constexpr auto called(const F& f) {
  return f();
}
/// f(), as a function of its own where `apart`.
template <bool apart, class F>
AXIAL_INLINE constexpr auto stage(const F& f) {
  if constexpr (apart)
    return called(f);
  else
    return f();
}

// An inward pass whose steps write into one place each, so that a step is all that a frame has to hold.
template <class Links, class Own, class Joint>
struct InwardByCalls : Inward<Links, Own, Joint> {
  template <int I, class Values>
  [[gnu::noinline]] constexpr void step(Values& values) const {
    values[Index<I>{}] = this->joint(Index<I>{}, loaded(this->own(Index<I>{}), this->template loads<I, I + 1>(values)));
  }
  template <int... I>
  AXIAL_INLINE constexpr auto run(std::integer_sequence<int, I...>) const {
    constexpr int last = Links::capacity - 1;
    Slots<LeftBy<InwardByCalls, I>...> values{};
    (step<last - I>(values), ...);
    return values;
  }
};

/// inward() over unrolled links, each step as a function of its own.
template <class Links, class Own, class Joint>
AXIAL_INLINE constexpr auto inward_by_steps(const Links&, const Own& own, const Joint& joint) {
  return InwardByCalls<Links, Own, Joint>{{own, joint}}.run(std::make_integer_sequence<int, Links::capacity>{});
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
