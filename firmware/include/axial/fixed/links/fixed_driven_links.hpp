// Links of a robot whose joints share drives, in fixed point: words of drives on one side, words of joints on the
// other.
#pragma once

#include <axial/fixed/formats/drive_formats.hpp>
#include <axial/fixed/links/fixed_values.hpp>
#include <axial/transmissions/driven_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Positions have 32 bits in any word, and so has what makes those of joints.
using PositionArithmetic = Arithmetic<std::int32_t, true, false>;

/// The format that a drive's own terms, its Coulomb friction, are rounded to: that of its effort.
template <class Scene, class Parameters, class S>
struct DriveFormats {
  struct Table {
    static constexpr Ranges<Scene::Robot::chain.size> value = [] {
      Ranges<Scene::Robot::chain.size> all{};
      for (int k = 0; k < Scene::Robot::chain.size; ++k)
        all.format[k].joint_effort = exponents_of<Scene, typename S::Word, role::Effort>.of[k];
      return all;
    }();
    static constexpr int parent(int i) { return i - 1; }
  };
  template <int I>
  using Of = FormatRounding<S, Table, I>;
  template <class AnyScene, class AnyScalar>
  using Values = FixedValues<Scene, S>;
};

}  // namespace detail

/// DrivenLinks over words: joints by q = G u + q0, rounded once; angles wrap, so that q is exact to 1.5 units of 2^-32
/// turns whatever ratios there are, and drives' positions are numbers in the format of their limits, not angles.
template <class SceneType, class S, class Parameters, class Recursion>
struct FixedDrivenLinks {
  using Scene = SceneType;                                   ///< of the drives
  using Scalar = S;                                          ///< arithmetic
  using Value = Stored<typename S::Word>;                    ///< as joint values hold it
  using JointScene = detail::JointsOf<Scene>;                ///< of the joints
  using JointRobot = typename JointScene::Robot;             ///< the joints
  using JointValues = EffortsOf<JointScene, Value>;          ///< efforts of the joints
  static constexpr bool unrolled = true;                     ///< of the drives
  static constexpr int size = JointRobot::chain.size;        ///< number of joints
  static constexpr int capacity = Scene::Robot::chain.size;  ///< number of drives
  static constexpr const auto& matrix =
      detail::drive_matrix_of_scene(static_cast<const Scene*>(nullptr));  ///< G and q0

  /// The joints, as links of their own.
  template <class Of = Recursion>
  AXIAL_INLINE static constexpr auto joints() {
    return links_of<JointScene, Value, Parameters, Of>();
  }
  /// The drives: rotor and friction of each.
  AXIAL_INLINE static constexpr auto drives() {
    return StaticLinks<Scene, S, FullParameters, detail::DriveFormats<Scene, FullParameters, S>>{};
  }

  /// G u + q0.
  template <class U>
  AXIAL_INLINE static constexpr auto positions(const U& u) {
    Positions<JointRobot, Value> q{};
    each_joint([&](auto i) AXIAL_INLINE { q[i].raw = position<decltype(i)::value>(u); });
    return q;
  }
  /// G times speeds or accelerations of drives, in the joints' formats of the same role.
  template <class R, class Role>
  AXIAL_INLINE static constexpr auto rates(const Joints<R, Value, Role>& ud) {
    using Rates = Joints<JointRobot, Value, Role>;
    Rates qd{};
    const auto at = read_drives(ud);
    each_joint([&](auto i) AXIAL_INLINE { FixedValues<JointScene, S>::write(qd, i, row<decltype(i)::value>(at)); });
    return qd;
  }
  /// Nothing moves.
  AXIAL_INLINE static constexpr NoMotion rates(NoMotion) { return {}; }

  /// G times speeds or accelerations of drives, for a kernel.
  template <class V>
  AXIAL_INLINE static constexpr auto kernel_rates(const V& ud) {
    return rates(ud);
  }
  /// What drives feel of values of the joints is summed where they answer.
  template <class Values>
  AXIAL_INLINE static constexpr const Values& actuator_efforts(const Values& values) {
    return values;
  }
  /// Values of drives, or of joints, with their formats.
  template <class U>
  AXIAL_INLINE static constexpr auto read_drives(const U& u) {
    return FixedValues<Scene, S>::read(u);
  }
  /// Writes for drive k what it feels of values of the joints, and terms of its own, rounded once.
  template <class Values, class K, class AtJoints, class... Own>
  AXIAL_INLINE static constexpr void answer(Values& values, K k, const AtJoints& at_joints, const Own&... own) {
    const auto at = FixedValues<JointScene, S>::read(at_joints);
    FixedValues<Scene, S>::write(values, k, detail::lazy_sum(actuator_effort<K::value>(at), own...));
  }
  /// What drive K feels of values of the joints with their formats: a lazy sum.
  template <int K, class Values>
  AXIAL_INLINE static constexpr auto actuator_effort(const Values& values) {
    return sum<size>([&](auto i) AXIAL_INLINE { return ratio<S, decltype(i)::value, K>() * values[i]; });
  }
  /// A sum that waits for its rounding.
  template <class X, class Y>
  AXIAL_INLINE static constexpr auto add(const X& x, const Y& y) {
    return detail::lazy_sum(x, y);
  }
  /// Entry (I, J) of M of the joints, or of a Jacobian, with its format.
  template <int I, int J, class M>
  AXIAL_INLINE static constexpr auto entry(const M& m) {
    return Fx<M::exponent(I, J), S>{m(I, J).raw};
  }
  /// A component of a Jacobian's column by drive K, from those by joints: one format for all.
  template <int K, class Get>
  AXIAL_INLINE static constexpr Value column_part(const Get& get) {
    const auto all =
        sum<size>([&](auto i) AXIAL_INLINE { return ratio<S, decltype(i)::value, K>() * Fx<0, S>{get(i).raw}; });
    return {round_to<-column_headroom<Scene>>(all).raw};
  }
  /// Calls f(i) for every joint.
  template <class F>
  AXIAL_INLINE static constexpr void each_joint(const F& f) {
    each(f, std::make_integer_sequence<int, size>{});
  }
  /// Calls f(k) for every drive.
  template <class F>
  AXIAL_INLINE static constexpr void each_drive(const F& f) {
    each(f, std::make_integer_sequence<int, capacity>{});
  }

 private:
  // G(I, K) as a literal of an arithmetic.
  template <class Scalar, int I, int K>
  AXIAL_INLINE static constexpr auto ratio() {
    return literal<Scalar>([] { return matrix.ratio[I][K]; });
  }
  // The lazy sum of term(i) from i to count - 1.
  template <int count, int i = 0, class Term>
  AXIAL_INLINE static constexpr auto sum(const Term& term) {
    if constexpr (i == count)
      return Zero{};
    else
      return add(term(Index<i>{}), sum<count, i + 1>(term));
  }
  template <int I, class U>
  AXIAL_INLINE static constexpr std::int32_t position(const U& u) {
    using P = detail::PositionArithmetic;
    if constexpr (JointRobot::chain.links[I].type == JointType::revolute) {
      const auto turned = round_to<0>(row_of<I>(u, literal<P>([] { return detail::bam_per_radian; })));
      return turned_by(Bam<P>{turned.raw}, [] { return matrix.offset[I]; }).raw;
    } else {
      constexpr int exponent = Positions<JointRobot, Value>::exponent(I);
      return round_to<exponent>(add(row_of<I>(u, One{}), literal<P>([] { return matrix.offset[I]; }))).raw;
    }
  }
  // Row I of G times positions of drives, in units of 1 / unit.
  template <int I, class U, class Unit>
  AXIAL_INLINE static constexpr auto row_of(const U& u, Unit unit) {
    using P = detail::PositionArithmetic;
    return sum<capacity>([&](auto k) AXIAL_INLINE {
      return (ratio<P, I, decltype(k)::value>() * unit) * Fx<U::exponent(k), P>{u[k].raw};
    });
  }
  template <int I, class U>
  AXIAL_INLINE static constexpr auto row(const U& u) {
    return sum<capacity>([&](auto k) AXIAL_INLINE { return ratio<S, I, decltype(k)::value>() * u[k]; });
  }
  template <class F, int... I>
  AXIAL_INLINE static constexpr void each(const F& f, std::integer_sequence<int, I...>) {
    (f(Index<I>{}), ...);
  }
};

/// True for FixedDrivenLinks, which stand for joints that share drives.
template <class Scene, class S, class Parameters, class Recursion>
inline constexpr bool is_driven<FixedDrivenLinks<Scene, S, Parameters, Recursion>> = true;

}  // namespace axial

#include <axial/options/end.hpp>
