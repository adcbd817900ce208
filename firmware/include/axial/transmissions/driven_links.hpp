// Links of a robot whose joints share drives: joint values on one side, values of drives on the other.
#pragma once

#include <axial/transmissions/roles.hpp>

#include <axial/options/begin.hpp>

namespace axial {
/// What kernels get for a robot whose joints share drives: its joints, its drives, and G between them. Those that know
/// it (DrivenKernels) read values of drives, compute with joints and answer for drives.
template <class SceneType, class ScalarType, class Parameters>
struct DrivenLinks : driven::PlainDrives<ScalarType> {
  using Scene = SceneType;                                         ///< of the drives
  using Scalar = ScalarType;                                       ///< the number
  using Value = ScalarType;                                        ///< as joint values hold it
  using JointScene = typename detail::SceneOfJoints<Scene>::type;  ///< of the joints
  using JointRobot = typename JointScene::Robot;                   ///< the joints
  using JointValues = Joints<JointRobot, Scalar>;                  ///< one per joint
  static constexpr bool unrolled = true;                           ///< of the drives
  static constexpr int size = JointRobot::chain.size;              ///< number of joints
  static constexpr int capacity = Scene::Robot::chain.size;        ///< number of drives
  static constexpr const auto& matrix =
      detail::drive_matrix_of_scene(static_cast<const Scene*>(nullptr));  ///< G and q0

  /// The joints, as links of their own that a recursion walks over.
  template <class Recursion = recursion::NewtonEuler>
  AXIAL_INLINE static constexpr auto joints() {
    return links_of<JointScene, Scalar, Parameters, Recursion>();
  }
  /// The drives: rotor and friction of each.
  AXIAL_INLINE static constexpr auto drives() { return StaticLinks<Scene, Scalar, FullParameters>{}; }

  /// G u + q0.
  template <class U>
  AXIAL_INLINE static constexpr JointValues positions(const U& u) {
    JointValues q{};
    each_joint([&](auto i) AXIAL_INLINE {
      using Step = JointStep<decltype(i)::value>;
      if constexpr (Step::is_taken())
        q[i] = stepped(Step{}, q, u);
      else
        q[i] = static_cast<Scalar>(row<decltype(i)::value>(u) +
                                   literal<Scalar>([] { return matrix.offset[decltype(i)::value]; }));
    });
    return q;
  }
  /// G times speeds or accelerations of drives.
  template <class U>
  AXIAL_INLINE static constexpr JointValues rates(const U& ud) {
    JointValues qd{};
    each_joint([&](auto i) AXIAL_INLINE { qd[i] = static_cast<Scalar>(row<decltype(i)::value>(ud)); });
    return qd;
  }
  using driven::PlainDrives<ScalarType>::rates;
  /// Rates of the joints that are computed where a kernel reads them: ahead of it they would wait in memory. A common
  /// factor of a row stands outside, from where it goes into a sum.
  template <class U>
  struct RateView {
    const U& of_drives;  ///< speeds or accelerations
    /// Rate of joint i.
    template <class I>
    AXIAL_INLINE constexpr Scalar operator[](I) const {
      constexpr int i = I::value;
      if constexpr (matrix.common_factor(i) != 1.0)
        return static_cast<Scalar>(literal<Scalar>([] { return matrix.common_factor(I::value); }) *
                                   signed_sum<i>(of_drives));
      else
        return static_cast<Scalar>(row<i>(of_drives));
    }
  };
  /// Rates for a kernel: a view of them where every link has its own type.
  template <class U>
  AXIAL_INLINE static constexpr auto kernel_rates(const U& ud) {
    if constexpr (decltype(joints())::unrolled && !std::is_same_v<U, NoMotion>)
      return RateView<U>{ud};
    else
      return rates(ud);
  }
  /// What every drive feels of values of the joints.
  template <class Values>
  AXIAL_INLINE static constexpr auto actuator_efforts(const Values& values) {
    Joints<typename Scene::Robot, Scalar> all{};
    each_drive([&](auto k) AXIAL_INLINE {
      using Step = DriveStep<decltype(k)::value>;
      if constexpr (Step::value().from >= 0)
        all[k] = stepped(Step{}, all, values);
      else
        all[k] = static_cast<Scalar>(actuator_effort<decltype(k)::value>(values));
    });
    return all;
  }
  /// What drive K feels of values of the joints: column K of G times them.
  template <int K, class Values>
  AXIAL_INLINE static constexpr auto actuator_effort(const Values& values) {
    return driven::sum_of<size>([&](auto i) AXIAL_INLINE {
      constexpr int I = decltype(i)::value;
      return literal<Scalar>([] { return matrix.ratio[I][K]; }) * values[I];
    });
  }
  /// Overload that takes the drive as an index.
  template <class K, class Values>
  AXIAL_INLINE static constexpr auto actuator_effort(K, const Values& values) {
    return actuator_effort<K::value>(values);
  }
  AXIAL_INLINE static constexpr int joint_count() { return size; }  ///< number of joints
  /// G(joint, drive) as a number.
  AXIAL_INLINE static constexpr Scalar ratio(int joint, int drive) {
    return NumberTraits<Scalar>::constant(matrix.ratio[joint][drive]);
  }
  /// x + y, where a number system with formats waits for the sum's rounding.
  template <class X, class Y>
  AXIAL_INLINE static constexpr auto add(const X& x, const Y& y) {
    return x + y;
  }
  /// Entry (I, J) of M of the joints.
  template <int I, int J, class M>
  AXIAL_INLINE static constexpr const Scalar& entry(const M& m) {
    return m(I, J);
  }
  /// A component of a Jacobian's column by drive K, from those by joints.
  template <int K, class Get>
  AXIAL_INLINE static constexpr Scalar column_part(const Get& get) {
    JointValues component{};
    for (int i = 0; i < size; ++i)
      component[i] = get(i);
    return static_cast<Scalar>(actuator_effort<K>(component));
  }
  /// Calls f(k) for every drive.
  template <class F>
  AXIAL_INLINE static constexpr void each_drive(const F& f) {
    each(f, std::make_integer_sequence<int, capacity>{});
  }
  /// Calls f(i) for every joint.
  template <class F>
  AXIAL_INLINE static constexpr void each_joint(const F& f) {
    each(f, std::make_integer_sequence<int, size>{});
  }

  /// Where a kernel that does not know drives asks for links, values or efforts.
  ///@{
  template <class I>
  static constexpr auto link(I i) {
    static_cast<void>(Walkable<DrivenLinks>{});
    return drives().link(i);
  }
  template <class Values>
  static constexpr const Values& read(const Values& values) {
    static_cast<void>(Walkable<DrivenLinks>{});
    return values;
  }
  template <class Links = DrivenLinks>
  static constexpr auto no_efforts() {
    static_cast<void>(Walkable<Links>{});
    return JointValues{};
  }
  ///@}

 private:
  // One value more by an earlier one: of a joint from drives, or of a drive from joints.
  template <class Step, class Done, class U>
  AXIAL_INLINE static constexpr Scalar stepped(Step, const Done& done, const U& u) {
    return static_cast<Scalar>(literal<Scalar>([] { return Step::value().sign; }) * done[Step::value().from] +
                               literal<Scalar>([] { return Step::value().unit; }) * u[Step::value().at]);
  }
  template <int I>
  struct JointStep {
    static constexpr RowStep value() { return matrix.joint_step(I); }
    static constexpr bool is_taken() {
      constexpr int from = value().from;
      return from >= 0 && matrix.offset[I] == 0.0 && matrix.offset[from < 0 ? I : from] == 0.0;
    }
  };
  template <int K>
  struct DriveStep {
    static constexpr RowStep value() { return matrix.drive_step(K); }
  };
  template <int I, class U>
  AXIAL_INLINE static constexpr auto signed_sum(const U& u) {
    return driven::sum_of<capacity>([&](auto k) AXIAL_INLINE {
      constexpr double ratio = matrix.ratio[I][decltype(k)::value];
      return literal<Scalar>([] { return ratio > 0.0 ? 1.0 : ratio < 0.0 ? -1.0 : 0.0; }) * u[k];
    });
  }
  template <int I, class U>
  AXIAL_INLINE static constexpr auto row(const U& u) {
    return driven::sum_of<capacity>([&](auto k) AXIAL_INLINE {
      return literal<Scalar>([] { return matrix.ratio[I][decltype(k)::value]; }) * u[k];
    });
  }
  template <class F, int... I>
  AXIAL_INLINE static constexpr void each(const F& f, std::integer_sequence<int, I...>) {
    (f(Index<I>{}), ...);
  }
};

/// Links of a robot whose joints share drives.
template <class R, class... Features, class T, class Parameters, class Recursion>
struct LinksOf<Scene<DriveCoordinates<R>, Features...>, T, Parameters, Recursion> {
  /// joints and drives
  AXIAL_INLINE static constexpr auto links() {
    using Default = std::conditional_t<std::is_same_v<Parameters, FullParameters>, FullParameters, BaseParameters>;
    return DrivenLinks<Scene<DriveCoordinates<R>, Features...>, T, Default>{};
  }
};

/// True for DrivenLinks, which stand for joints that share drives.
template <class S, class T, class P>
inline constexpr bool is_driven<DrivenLinks<S, T, P>> = true;

}  // namespace axial

#include <axial/options/end.hpp>
