// Whether forward dynamics was asked of numbers, and answered with numbers.
#pragma once

#include <axial/links/inputs_soundness.hpp>
#include <axial/recursion/forward_result.hpp>
#include <axial/recursion/passes.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

// A joint's position where its sine is not given: pairs are looked at with the other inputs. Scenes without these are
// told apart outside the lambda: clang 14 looks into branches of one that its scene leaves out.
template <class Links, class T, class Q, class I>
AXIAL_INLINE constexpr void collect_position(Soundness<T>& all, const Links& links, const Q& q, I i) {
  if constexpr (Links::Scene::template has<SineCosines>) {
    links.link(i).on_joint([&](auto kind) AXIAL_INLINE {
      if constexpr (!std::is_same_v<decltype(kind), Revolute>) all.position(kind, q[i]);
    });
  } else {
    links.link(i).on_joint([&](auto kind) AXIAL_INLINE { all.position(kind, q[i]); });
  }
}

/// Collects what forward dynamics is asked of. Efforts need no look: each is a term of its joint's acceleration.
struct AskedState {
  using Roles = axial::Roles<role::Position, role::Velocity>;  ///< of its arguments
  /// what there is to say of it
  template <class Links, class Input, class Q, class V>
  AXIAL_INLINE static constexpr auto run(const Links& links, const Input& in, const Q& q, const V& qd) {
    {  // in a block of its own, or compilers place it otherwise
      Soundness<typename Links::Scalar> all;
      for_each_link(links, [&](auto i) AXIAL_INLINE { collect_position(all, links, q, i); });
      for_each_link(links, [&](auto i) AXIAL_INLINE { all.number(qd[i]); });
      collect_inputs(all, links, in);
      return all;
    }
  }
};
/// The same of any links.
template <class Links, class... Arguments>
AXIAL_INLINE constexpr auto collected_request(const Links& links, Arguments&&... arguments) {
  return execute<AskedState>(links, arguments...);
}

/// The status of an answer that a solver calls `solved`: what is not finite, and angles without exact sines, come
/// first.
template <class Links, class T, class A>
AXIAL_INLINE constexpr auto sound_status(const Links& links, Soundness<T> all, const A& qdd,
                                         const StatusOf<T>& solved) {
  for_each_link(execute<Actuators>(links), [&](auto i) AXIAL_INLINE { all.number(qdd[i]); });
  if constexpr (Links::Scene::template has<FloatingBase>) collect(all, qdd.base_acceleration);
  if constexpr (has_run_time_inputs<typename Links::Scene, T>)
    return first_trouble(all.status(), solved);
  else
    return first_trouble(all.of_numbers(), solved);
}

/// The state and the inputs of a solve, looked at before it: while they are in registers. Here nothing wraps, so that
/// answers are looked at too; a number system with formats tells by the state alone.
template <class S, class T>
class StateCheck {
 public:
  AXIAL_INLINE constexpr StateCheck(const Inputs<S, T>& in, const Positions<robot_of<S>, T>& q,
                                    const Velocities<robot_of<S>, T>& qd)
      : asked_(collected_request(links_of<S, T>(), in, q, qd)) {}
  /// Puts what is wrong with the state, the inputs or the answer into the answer's status.
  template <class Result>
  AXIAL_INLINE constexpr void judge(Result& result) const {
    result.status = sound_status(links_of<S, T>(), asked_, result, result.status);
  }
  /// The same of an answer of which there is more: `more` collects it.
  template <class Result, class More>
  AXIAL_INLINE constexpr void judge(Result& result, const More& more) const {
    auto all = asked_;
    more(all);
    result.status = sound_status(links_of<S, T>(), all, result, result.status);
  }
  /// Puts what is beyond the formats into a status: nothing.
  AXIAL_INLINE constexpr void name(StatusOf<T>&) const {}

 private:
  Soundness<typename decltype(links_of<S, T>())::Scalar> asked_;
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
