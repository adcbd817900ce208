// A call on arrays and braces, whatever the algorithm (macros: a function's name is no parameter of a template).
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/calls/arguments.hpp>

#include <axial/options/begin.hpp>

// NOLINTBEGIN(bugprone-macro-parentheses): types, packs and names, around which there are none
/// The first arguments of a call, so many: what EACH makes of a type, its value and X.
///@{
#define AXIAL_ARGUMENTS_1(EACH, X) EACH(A, a, X)
#define AXIAL_ARGUMENTS_2(EACH, X) AXIAL_ARGUMENTS_1(EACH, X), EACH(B, b, X)
#define AXIAL_ARGUMENTS_3(EACH, X) AXIAL_ARGUMENTS_2(EACH, X), EACH(C, c, X)
#define AXIAL_ARGUMENTS_4(EACH, X) AXIAL_ARGUMENTS_3(EACH, X), EACH(D, d, X)
#define AXIAL_ARGUMENTS_5(EACH, X) AXIAL_ARGUMENTS_4(EACH, X), EACH(E, e, X)
#define AXIAL_DEDUCED(A, a, X) class A = detail::Braces<AXIAL_UNPACKED X>
#define AXIAL_LISTED(A, a, X) A
#define AXIAL_GIVEN(A, a, X) const A& a
#define AXIAL_READ(A, a, S) detail::as_joint_values<S>(a)
#define AXIAL_UNPACKED(...) __VA_ARGS__
///@}

/// Calls where any of the joint values are arrays or braces: `called` on joint values of S behind what is `passed`, and
/// the refusal of arguments that do not fit or are out of order. `head` are the first parameters of the template,
/// `declared` the first of the function; T is void where arrays may be of float or of double.
#define AXIAL_CALL_ON_ARRAYS(name, count, order, answer, head, S, T, braces, declared, passed, called)                 \
  template <AXIAL_UNPACKED head, AXIAL_ARGUMENTS_##count(AXIAL_DEDUCED, braces), class... In,                          \
            class Call =                                                                                               \
                detail::Call<T, S, detail::Of##order, detail::First<AXIAL_ARGUMENTS_##count(AXIAL_LISTED, )>, In...>,  \
            detail::IfTaken<Call, true> = 0>                                                                           \
  [[nodiscard]] constexpr auto name(AXIAL_UNPACKED declared AXIAL_ARGUMENTS_##count(AXIAL_GIVEN, ), const In&... in) { \
    return AXIAL_UNPACKED called(AXIAL_UNPACKED passed AXIAL_ARGUMENTS_##count(AXIAL_READ, S), in...);                 \
  }                                                                                                                    \
  template <AXIAL_UNPACKED head, AXIAL_ARGUMENTS_##count(AXIAL_DEDUCED, braces), class... In,                          \
            class Call =                                                                                               \
                detail::Call<T, S, detail::Of##order, detail::First<AXIAL_ARGUMENTS_##count(AXIAL_LISTED, )>, In...>,  \
            detail::IfTaken<Call, false> = 0>                                                                          \
  [[nodiscard]] detail::RefusedArguments<Call, AXIAL_UNPACKED answer> name(                                            \
      AXIAL_UNPACKED declared AXIAL_ARGUMENTS_##count(AXIAL_GIVEN, ), const In&... in);

/// Rows of registry.hpp as calls, over a scene and over a run-time model.
///@{
#define AXIAL_ON_ARRAYS(name, count, order, answer, ...) \
  AXIAL_CALL_ON_ARRAYS(name, count, order, (answer<S, float>), (class S), S, void, (S), (), (), (name<S>))
#define AXIAL_OF_A_JOINT_ON_ARRAYS(name, count, order)                                                    \
  AXIAL_CALL_ON_ARRAYS(name, count, order, (detail::Refused), (class S, int Joint), S, void, (S), (), (), \
                       (name<S, Joint>))
#define AXIAL_OF_CHOICE_ON_ARRAYS(name, count, order, answer, ...)                                               \
  AXIAL_CALL_ON_ARRAYS(name, count, order, (answer<S, float>), (class S, class... Wanted), S, void, (S), (), (), \
                       (name<S, Wanted...>))
#define AXIAL_OVER_A_MODEL_ON_ARRAYS(name, count, order, answer, ...)                                                  \
  AXIAL_CALL_ON_ARRAYS(name, count, order, (answer<M, float>), (int N, class... F, class M = Model<N, F...>), M, void, \
                       (M), (const Model<N, F...>& model, ), (model, ), (name))
#define AXIAL_OF_CHOICE_OVER_A_MODEL_ON_ARRAYS(name, count, order, answer, ...)                      \
  AXIAL_CALL_ON_ARRAYS(name, count, order, (answer<M, float>),                                       \
                       (class... Wanted, int N, class... F, class M = Model<N, F...>), M, void, (M), \
                       (const Model<N, F...>& model, ), (model, ), (name<Wanted...>))
#define AXIAL_OF_A_STATE_ON_ARRAYS(name, count, order, state, answer)                                                  \
  AXIAL_CALL_ON_ARRAYS(name, count, order, (answer<S, T>), (class S, class T), S, T, (S, T), (state<S, T> & memory, ), \
                       (memory, ), (name<S>))
///@}
// NOLINTEND(bugprone-macro-parentheses)

#include <axial/options/end.hpp>
