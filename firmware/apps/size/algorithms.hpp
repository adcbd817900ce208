#pragma once
/// What can be probed, by the names of matrix.txt: scenes, and algorithms on a scene. An algorithm takes any struct
/// with the members that it reads (argument.hpp has them all), so that a host can judge the very same calls.

#include <cstddef>
#include <type_traits>

#include <axial/axial.hpp>
#include <firmware/apps/elastic/elastic_robot.hpp>

namespace axial::apps::size {

namespace scenes {
template <class Robot, class... Tags>
using bare = Scene<Robot, Gravity, RotorInertia, Tags...>;
template <class Robot, class... Tags>
using without_gravity = Scene<Robot, RotorInertia, Tags...>;
template <class Robot, class... Tags>
using without_rotors = Scene<Robot, Gravity, Tags...>;
template <class Robot, class... Tags>
using friction = Scene<Robot, Gravity, RotorInertia, Friction, Tags...>;
template <class Robot, class... Tags>
using payload = Scene<Robot, Gravity, RotorInertia, Payload, Tags...>;
template <class Robot, class... Tags>
using tip_wrench = Scene<Robot, Gravity, RotorInertia, TipWrench, Tags...>;
template <class Robot, class... Tags>
using external_wrenches = Scene<Robot, Gravity, RotorInertia, ExternalWrenches, Tags...>;
template <class Robot, class... Tags>
using runtime_gravity = Scene<Robot, RuntimeGravity, RotorInertia, Tags...>;
template <class Robot, class... Tags>
using base_motion = Scene<Robot, Gravity, RotorInertia, BaseMotion, Tags...>;
template <class Robot, class... Tags>
using sine_cosines = Scene<Robot, Gravity, RotorInertia, SineCosines, Tags...>;
template <class Robot, class... Tags>
using full_parameters = Scene<Robot, Gravity, RotorInertia, FullParameters, Tags...>;
template <class Robot, class... Tags>
using base_parameters = Scene<Robot, Gravity, RotorInertia, BaseParameters, Tags...>;
/// Behind harmonic drives of 12 Hz, but for robots that declare a stiffness themselves. Joints that share drives are
/// refused as they are.
template <class Robot, class... Tags>
using elastic = Scene<
    std::conditional_t<axial::elastic::is_elastic<Robot>() || Robot::chain.shares_drives(), Robot, Elastic<Robot, 12>>,
    Gravity, RotorInertia, ElasticJoints, Tags...>;
}  // namespace scenes

/// The scene's run-time inputs, taken from the argument.
template <class S, class A>
constexpr auto inputs_of(const A& a) {
  Inputs<S, typename A::Number> in{};
  if constexpr (S::template has<Payload>) in.payload = a.payload;
  if constexpr (S::template has<TipWrench>) in.tip_wrench = a.tip_wrench;
  if constexpr (S::template has<ExternalWrenches>) in.wrenches = a.wrenches;
  if constexpr (S::template has<RuntimeGravity>) in.gravity = a.gravity;
  if constexpr (S::template has<BaseMotion>) in.base_motion = a.base_motion;
  if constexpr (S::template has<SineCosines>) in.turns = a.turns;
  return in;
}

/// The integers of the bare robot's efforts stand for the scene's, and joint values of a robot for those of the same
/// one with springs; other numbers have one type for all scenes. No copy, which would be counted; what reads this view
/// is compiled apart from what wrote the numbers, or without assumptions about types (-Og).
template <class To, class From>
const To& same_words(const From& efforts) {
  static_assert(sizeof(To) == sizeof(From));
  return *static_cast<const To*>(static_cast<const void*>(&efforts));
}

/// A scene with one tag more.
template <class S, class Tag>
struct Tagged;
template <class Robot, class... Features, class Tag>
struct Tagged<Scene<Robot, Features...>, Tag> {
  using type = Scene<Robot, Features..., Tag>;
};

/// An algorithm on the members that its order of joint values names. Accelerations and efforts stand for the motion's
/// third and fourth derivative.
///@{
template <class S, class A, class F>
AXIAL_INLINE inline auto called(axial::detail::OfPosition, const A& a, const F& f) {
  return f(a.q, inputs_of<S>(a));
}
template <class S, class A, class F>
AXIAL_INLINE inline auto called(axial::detail::OfState, const A& a, const F& f) {
  return f(a.q, a.qd, inputs_of<S>(a));
}
template <class S, class A, class F>
AXIAL_INLINE inline auto called(axial::detail::OfMotion, const A& a, const F& f) {
  return f(a.q, a.qd, a.qdd, inputs_of<S>(a));
}
template <class S, class A, class F>
AXIAL_INLINE inline auto called(axial::detail::OfDriven, const A& a, const F& f) {
  return f(a.q, a.qd, same_words<EffortsOf<S, typename A::Number>>(a.tau), inputs_of<S>(a));
}
template <class S, class A, class F>
AXIAL_INLINE inline auto called(axial::detail::OfHighest, const A& a, const F& f) {
  using Values = Joints<robot_of<S>, typename A::Number>;
  const auto of = [](const auto& values) -> const Values& { return same_words<Values>(values); };
  return f(of(a.q), of(a.qd), of(a.qdd), of(a.qdd), of(a.tau), inputs_of<S>(a));
}
///@}

/// The algorithms of axial/calls/registry.hpp.
namespace listed {
#define AXIAL_PROBED(function, count, order, answer, type, value)                                 \
  struct value {                                                                                  \
    template <class S, class A>                                                                   \
    static auto run(const A& a) {                                                                 \
      return called<S>(axial::detail::Of##order{}, a,                                             \
                       [](const auto&... at) AXIAL_INLINE { return axial::function<S>(at...); }); \
    }                                                                                             \
  };
AXIAL_ALGORITHMS(AXIAL_PROBED)
AXIAL_ALGORITHMS_OF_CHOICE(AXIAL_PROBED)
#undef AXIAL_PROBED
}  // namespace listed

/// Those, and what is probed of others, or otherwise.
namespace algorithms {

using namespace listed;

/// The effort of the last joint alone.
struct joint_torque {
  template <class S, class A>
  static auto run(const A& a) {
    return axial::joint_torque<S, joint_count<S> - 1>(a.q, a.qd, a.qdd, inputs_of<S>(a));
  }
};

template <class Route>
struct forward_dynamics_by {
  template <class S, class A>
  static auto run(const A& a) {
    return listed::forward_dynamics::run<typename Tagged<S, Route>::type>(a);
  }
};
using forward_dynamics_articulated_body = forward_dynamics_by<ArticulatedBody>;
using forward_dynamics_split_articulated_body = forward_dynamics_by<SplitArticulatedBody>;
using forward_dynamics_composite_body = forward_dynamics_by<CompositeBody>;

/// The torque and its change along a direction of the argument's own numbers: they cost what others would.
struct inverse_dynamics_along {
  template <class S, class A>
  static auto run(const A& a) {
    return axial::inverse_dynamics_along<S>(a.q, a.qd, a.qdd, {a.qdd, a.q, a.qd}, inputs_of<S>(a));
  }
};

/// The accelerations and their change, likewise.
struct forward_dynamics_along {
  template <class S, class A>
  static auto run(const A& a) {
    return axial::forward_dynamics_along<S>(a.q, a.qd, a.tau, {a.qdd, a.q, a.qd}, inputs_of<S>(a));
  }
};

/// All columns, each times the speeds: what power a unit of its parameter takes.
struct torque_regressor {
  template <class S, class A>
  static auto run(const A& a) {
    const auto y = axial::torque_regressor<S>(a.q, a.qd, a.qdd, inputs_of<S>(a));
    struct {
      typename A::Number of[decltype(y)::columns];
    } powers{};
    for (int column = 0; column < y.columns; ++column)
      for (int i = 0; i < y.size; ++i)
        powers.of[column] = powers.of[column] + y(i, column) * a.qd[i];
    return powers;
  }
};

struct forward_kinematics {
  template <class S, class A>
  static auto run(const A& a) {
    return axial::forward_kinematics<S>(a.q).tool;
  }
};

struct jacobian {
  template <class S, class A>
  static auto run(const A& a) {
    return axial::jacobian<S>(a.q);
  }
};

/// The torque from separated terms.
struct separated_torque {
  template <class S, class A>
  static auto run(const A& a) {
    return torque(terms<S>(a), a.qd, a.qdd);
  }

 private:
  /// Whatever numbers stand in the inputs: they cost what others would.
  template <class S, class A>
  static const auto& terms(const A& a) {
    using Terms = Separated<S, typename A::Number>;
    static_assert(sizeof(Terms) <= sizeof a.terms);
    return *reinterpret_cast<const Terms*>(a.terms);
  }
};

/// Separated and summed at once.
struct torque_by_separation {
  template <class S, class A>
  static auto run(const A& a) {
    return torque(separate<S>(a.q, inputs_of<S>(a)), a.qd, a.qdd);
  }
};

struct closed_form_separation {
  template <class S, class A>
  static auto run(const A& a) {
    return closed_form::scara<robot_of<S>>(a.q);
  }
};

struct closed_form {
  template <class S, class A>
  static auto run(const A& a) {
    return axial::closed_form::scara_torque<S>(a.q, a.qd, a.qdd);
  }
};

/// A control step: inverse dynamics with limits. Its memory is static here, so that it shows as RAM.
struct feedforward {
  template <class S, class A>
  static auto run(const A& a) {
    static FeedforwardState<S, typename A::Number> state{};
    return axial::feedforward<S>(state, a.q, a.qd, a.qdd, inputs_of<S>(a));
  }
};

}  // namespace algorithms

}  // namespace axial::apps::size
