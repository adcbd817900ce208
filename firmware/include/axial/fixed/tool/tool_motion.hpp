// J^T w in fixed point: formats that hold whatever words a wrench has, and certified errors.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/bounds/kinematics.hpp>
#include <axial/fixed/dynamics/kinematics.hpp>
#include <axial/fixed/error_bound.hpp>
#include <axial/tool/tool_motion.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace bounds {

/// A wrench at the tool, known by the norms of its moment and force and by their exponents.
struct WrenchNorms {
  double moment, force;                 ///< N m, N
  int moment_exponent, force_exponent;  ///< of their words
};

/// Efforts of a wrench: the kernel, run on bounds.
template <int N>
constexpr Row<NumberSum, N> wrench_efforts(const JacobianBounds<N>& columns, const WrenchNorms& w,
                                           const WordRounding& r) {
  const ForceVector wrench{detail::anywhere({w.moment, 0.0}, w.moment_exponent, &r),
                           detail::anywhere({w.force, 0.0}, w.force_exponent, &r)};
  Row<NumberSum, N> efforts{};
  for (int i = 0; i < N; ++i)
    efforts[i] = along_motion(columns.columns[i], wrench);
  return efforts;
}

}  // namespace bounds

namespace detail {

template <class R>
constexpr void check_wrench_efforts() {
  static_assert(
      described_by<R>::chain.tip_wrench_limit.declared,
      "axial: fixed point leaves room for the declared tip wrench; add axial::tip_wrench_limit(force, moment) "
      "to the robot's chain");
}

/// Bounds of a robot's Jacobian with any tool that it has room for: a Jacobian does not say which tool it is of.
template <class R, class Word>
constexpr auto jacobian_with_any_tool() {
  constexpr const WordRounding& r = joint_rounding<Word>;
  const auto of_joints = [](auto m) {
    m.loads.tool_offset = m.loads.tool_reach;
    return bounds::jacobian_bounds(m, r, kinematics_ranges(m, r, Wanted::formats));
  };
  if constexpr (has_shared_drives<R>)
    return DriveErrors<R, Stored<Word>>::by_drives(of_joints(mechanism_of<JointsOf<R>, FullParameters>),
                                                   length_exponent<R, Stored<Word>>, r);
  else
    return of_joints(mechanism_of<scene_of<R>, FullParameters>);
}

/// Exponents of J^T w: they hold every wrench that words can say.
template <class R, class Word>
constexpr auto wrench_effort_exponents() {
  check_wrench_efforts<R>();
  using F = InputFormats<described_by<R>, Stored<Word>>;
  constexpr const WordRounding& r = joint_rounding<Word>;
  constexpr double most = root3 * (r.capacity() + 1.0);
  const auto efforts =
      bounds::wrench_efforts(jacobian_with_any_tool<R, Word>(),
                             {most * r.ulp(F::tip_moment), most * r.ulp(F::tip_force), F::tip_moment, F::tip_force}, r);
  return per_joint<joint_count<R>>([&](int i) { return r.exponent(efforts[i].bound.largest()); });
}
template <class R, class Word>
inline constexpr auto exponents_of<R, Word, role::WrenchEffort> = wrench_effort_exponents<R, Word>();

template <class R, class Word, int... I>
constexpr WrenchEfforts<R, Stored<Word>> wrench_efforts(const Jacobian<R, Stored<Word>>& jacobian,
                                                        const ForceVector<Vec3<Stored<Word>>, Vec3<Stored<Word>>>& w,
                                                        std::integer_sequence<int, I...>) {
  using T = Stored<Word>;
  using S = ArithmeticOf<scene_of<R>, Word>;
  const auto wrench = read_wrench<scene_of<R>, S>(w);
  WrenchEfforts<R, T> tau{};
  const auto write = [&](auto i) AXIAL_INLINE {
    const MotionVector column{in_format<direction_exponent<T> - column_headroom<R>, S>(jacobian[i].angular),
                              in_format<length_exponent<R, T> - column_headroom<R>, S>(jacobian[i].linear)};
    tau.values[i] = {round_to<WrenchEfforts<R, T>::exponent(i)>(along_motion(column, wrench)).raw};
  };
  (write(Index<I>{}), ...);
  return tau;
}

}  // namespace detail

/// J^T w in fixed point: the wrench in the formats of a tip wrench (InputFormats, by the robot's tip_wrench_limit()),
/// the efforts in their own, WrenchEfforts::exponent(). No wrench of words overflows, with a Jacobian whose status is
/// ok; how far efforts are off, error_bound(algorithm::TransposeTimes{}) tells.
template <class R, class Word>
[[nodiscard]] constexpr WrenchEfforts<R, Stored<Word>> transpose_times(
    const Jacobian<R, Stored<Word>>& jacobian, const ForceVector<Vec3<Stored<Word>>, Vec3<Stored<Word>>>& wrench) {
  return detail::wrench_efforts(jacobian, wrench, std::make_integer_sequence<int, joint_count<R>>{});
}

namespace algorithm {
struct TransposeTimes {};  ///< transpose_times() of jacobian()
struct ToolPose {};        ///< tool of forward_kinematics()
}  // namespace algorithm

/// Error bounds of the tool's origin and of each entry of its rotation, declared or (RuntimeTool) as its words say.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr bounds::ToolError error_bound(algorithm::ToolPose) {
  static_assert((detail::check_bound<S, recursion::Kinematics>(), true));
  return detail::ErrorsOf<S, T>::tool();
}

/// Error bounds of J^T w, N m or N, for a wrench that the robot declares, taken as its words say; the errors of the
/// Jacobian of scene S are in them.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::TransposeTimes) {
  using R = robot_of<S>;
  using F = InputFormats<detail::described_by<S>, T>;
  static_assert((detail::check_bound<S, recursion::Kinematics>(), detail::check_wrench_efforts<R>(), true));
  const auto of_product = rounding_of<detail::ArithmeticOf<scene_of<R>, typename T::Word>>();
  const auto efforts =
      bounds::wrench_efforts(detail::ErrorsOf<S, T>::jacobian(),
                             {F::wrench.moment + WordRounding::ulp(F::tip_moment),
                              F::wrench.force + WordRounding::ulp(F::tip_force), F::tip_moment, F::tip_force},
                             of_product);
  ErrorBound<joint_count<S>> bound;
  for (int i = 0; i < bound.size; ++i)
    bound.of[i] = efforts[i].bound.error + efforts[i].terms.rounding(WrenchEfforts<R, T>::exponent(i), of_product);
  return bound;
}

}  // namespace axial

#include <axial/options/end.hpp>
