// What may stand for joint values in a call: arrays (float[6], std::array<float, 6>, a std::span of known length, a
// pointer with its length) and numbers in braces; and what is said where arguments do not fit, or are out of order.
// Last a call on arrays and braces, whatever the algorithm (macros: a function's name is no parameter of a template).
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scene/joint_roles.hpp>
#include <axial/scene/refused_calls.hpp>
#include <axial/scene/scene.hpp>

#include <axial/options/begin.hpp>

/// What each kernel on arrays says where they do not fit (a macro: static_assert takes a literal only).
#define AXIAL_ARRAYS_FIT                                                                                     \
  "axial: joint values are axial::Joints, or arrays with one number for each joint, all of float or all of " \
  "double, as many as the kernel names; the length of a pointer is given by axial::pointed<N>(pointer)"

namespace axial {

/// A pointer to N numbers, for kernels that take joint values: `inverse_dynamics<Arm>(pointed<6>(q), ...)`. The length
/// is the caller's word.
template <int N, class T>
struct Pointed {
  static constexpr std::size_t extent = N;                           ///< as std::span has it
  const T* numbers;                                                  ///< N of them
  [[nodiscard]] constexpr const T* data() const { return numbers; }  ///< as std::span has it
};
/// Says how many numbers a pointer points to: pointed<6>(q).
template <int N, class T>
[[nodiscard]] constexpr Pointed<N, T> pointed(const T* numbers) {
  return {numbers};
}

namespace detail {

/// Length of what holds numbers, as far as its type tells: an array, what has data() and a constant size (std::array,
/// std::span<T, N>, Pointed); 0 for a pointer, a std::vector and others whose length a run tells; -1 for no array.
///@{
template <class A, class = void>
inline constexpr int plain_length = std::is_pointer_v<A> ? 0 : -1;
template <class T, std::size_t N>
inline constexpr int plain_length<T[N], void> = static_cast<int>(N);
template <class A, class = void>
inline constexpr int length_by_extent = 0;
template <class A>
inline constexpr int length_by_extent<A, std::enable_if_t<(A::extent < 1000000)>> = static_cast<int>(A::extent);
template <class A, class = void>
inline constexpr int length_by_size = length_by_extent<A>;
template <class A>
inline constexpr int length_by_size<A, std::enable_if_t<(std::tuple_size<A>::value > 0)>> =
    static_cast<int>(std::tuple_size<A>::value);
template <class A>
inline constexpr int plain_length<A, std::void_t<decltype(std::declval<const A&>().data())>> = length_by_size<A>;
///@}

template <class A>
inline constexpr bool is_plain_array = plain_length<A> >= 0;
template <class S, class T>
inline constexpr bool is_plain_array<Inputs<S, T>> = false;  // nobody looks inside: what they refuse is said at a call

/// The first number of an array.
template <class A>
constexpr const auto* first_of(const A& given) {
  if constexpr (std::is_array_v<A>)
    return &given[0];
  else if constexpr (std::is_pointer_v<A>)
    return given;
  else
    return given.data();
}

/// Numbers of an argument: of an array or of joint values; void of other inputs.
///@{
template <class A, class = void>
struct NumberOf {
  using type = void;
};
template <class A>
struct NumberOf<A, std::enable_if_t<is_plain_array<A>>> {
  using type = std::decay_t<decltype(*first_of(std::declval<const A&>()))>;
};
template <class S, class T, class Role>
struct NumberOf<Joints<S, T, Role>, void> {
  using type = T;
};
template <class A>
struct NumberOf<A, std::void_t<typename A::Base, typename A::Role>> : NumberOf<typename A::Base> {};
template <class A>
using number_of = typename NumberOf<A>::type;
///@}

template <class A, class T>
inline constexpr bool fits_number = std::is_void_v<number_of<A>> || std::is_same_v<number_of<A>, T>;
template <class A, int N>
inline constexpr bool fits_length = plain_length<A> == -1 || plain_length<A> == N;

/// How many of the arguments are joint values.
template <class... A>
inline constexpr int joint_values_among = (0 + ... + static_cast<int>(!std::is_void_v<number_of<A>>));

/// Whether there are `count` joint values, and at most one other input with them, and every array has a number for each
/// joint of S, all of float or all of double; where not, each kernel asserts it itself: from a function of its own the
/// sentence would stand behind a line more of the compiler's.
template <class S, int count, class... A>
inline constexpr bool takes_arrays = joint_values_among<A...> == count && sizeof...(A) <= count + 1 &&
                                     (true && ... &&
                                      fits_length<A, joint_count<S>>)&&((true && ... && fits_number<A, float>) ||
                                                                        (true && ... && fits_number<A, double>));

/// Joint values of an array; other inputs as they are.
template <class S, class A>
AXIAL_INLINE constexpr auto as_joint_values(const A& given) {
  if constexpr (is_plain_array<A>) {
    Joints<robot_of<S>, number_of<A>> values{};
    const auto* numbers = first_of(given);
    for (int i = 0; i < joint_count<S>; ++i)
      values[i] = numbers[i];
    return values;
  } else {
    return given;
  }
}

/// What braces become where a kernel takes joint values: a number for each joint, none narrowed. A compiler deduces no
/// type from braces, so that this is the default of the type of each argument.
template <class S, class T = float, class Each = std::make_index_sequence<joint_count<S>>>
struct Braces;
template <class S, class T, std::size_t... I>
struct Braces<S, T, std::index_sequence<I...>> {
  static constexpr std::size_t extent = sizeof...(I);
  T values[extent];
  [[nodiscard]] constexpr const T* data() const { return values; }
  constexpr Braces(Repeated<I, T>... given) : values{given...} {}
  // Counts are parameters, so that a compiler says what they are.
  template <class... V, std::size_t numbers = sizeof...(V), std::size_t joints = sizeof...(I),
            class = std::enable_if_t<numbers != joints && (true && ... && std::is_arithmetic_v<V>)>>
  constexpr Braces(V...) : values{} {
    static_assert(numbers == joints, "axial: braces hold one number for each joint");
  }
};

template <class A>
inline constexpr bool is_braces = false;
template <class S, class T, class Each>
inline constexpr bool is_braces<Braces<S, T, Each>> = true;

/// Whether one of the joint values of a call is an array, braces or a lone number, of which the same sentence is said.
/// Beside braces a number is no argument, but the scalar that was named: inverse_dynamics<Arm, double>({...}, ...).
template <class... A>
inline constexpr bool is_any_number = (false || ... || std::is_arithmetic_v<A>);
template <class... A>
inline constexpr bool is_any_plain = (false || ... || is_braces<A>)
                                         ? !is_any_number<A...>
                                         : is_any_number<A...> || (false || ... || is_plain_array<A>);

/// The first arguments of a call.
template <class... A>
struct First {};
/// A call over S, of numbers T (void: of float or double), whose first arguments have the roles that are `Wanted`.
template <class T, class S, class Wanted, class Arguments, class... In>
struct Call;
template <class T, class S, class Wanted, class... A, class... In>
struct Call<T, S, Wanted, First<A...>, In...> {
  /// Joint values are none, or say that they belong elsewhere. A fourth may be the last.
  static constexpr bool stands_in = (is_any_plain<A...> || is_out_of_order<Wanted, A...>)&&(
      Wanted::size < 5 || joint_values_among<A...> == Wanted::size);
  static constexpr bool fits =
      !is_any_plain<A..., In...> ||
      (takes_arrays<S, Wanted::size, A..., In...> && (std::is_void_v<T> || (true && ... && fits_number<A, T>)));
  static constexpr bool in_order = !is_out_of_order<Wanted, A..., In...>;
};
/// Whether a call that is not of joint values alone is taken, or refused.
template <class Call, bool taken, bool stands_in = Call::stands_in>
struct Chosen {};
template <class Call, bool taken>
struct Chosen<Call, taken, true> : std::enable_if<(Call::fits && Call::in_order) == taken, int> {};
template <class Call, bool taken>
using IfTaken = typename Chosen<Call, taken>::type;

/// What a call answers whose arguments are refused: a class, so that a compiler says why where it is called; an empty
/// answer, so that it says nothing more. Clang leaves out what stands behind a sentence, and the base.
template <class Call, class Answer>
struct RefusedArguments : Answer {
  template <class Any>
  constexpr operator Any() const {
    return {};
  }
  constexpr float operator[](int) const { return {}; }
  static_assert(Call::fits, AXIAL_ARRAYS_FIT);
  static_assert(Call::in_order, AXIAL_ROLES_MIXED);
};

}  // namespace detail
}  // namespace axial

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
