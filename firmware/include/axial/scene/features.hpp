// What a scene can name. What it does not name adds no instruction, no byte and no argument. doc/guides/scenes.md is
// the table.
#pragma once

#include <axial/scalar/sincos.hpp>
#include <axial/spatial/inertia.hpp>
#include <axial/spatial/spatial_vector.hpp>

#include <axial/options/begin.hpp>

namespace axial {

template <class S, class T, class Role = void>
struct Joints;  // joints.hpp

namespace detail {
// What inputs start with; number systems without a NaN or with formats say it their way.
template <class Robot, class T>
struct DeclaredGravity : NumberTraits<T> {};
template <class T>
struct UnknownTurn {
  static constexpr T value() { return NumberTraits<T>::constant(std::numeric_limits<double>::quiet_NaN()); }
};
// Whose values are one per link: the robot's, or its joints' where they share drives (transmissions/roles.hpp).
template <class Robot>
struct LinksOwner {
  using type = Robot;
};
}  // namespace detail

/// Base of every tag that a Scene may list. A tag with a run-time input declares its own `Input<Robot, T>`.
template <class Tag>
struct Feature {
  /// No run-time input.
  template <class Robot, class T>
  struct Input {};
};

/// A load rigidly fixed to the last link, known at run time.
template <class T>
struct PayloadBody {
  T mass{};               ///< kg
  Vec3<T> com{};          ///< m, in the last link's frame
  Sym3<T> inertia_com{};  ///< kg m^2 about com, axes of the last link's frame
};

/// Given motion of frame 0, in its own axes.
template <class T>
struct GivenMotion {
  Vec3<T> angular_velocity{};      ///< rad/s, axes of frame 0
  Vec3<T> angular_acceleration{};  ///< rad/s^2, axes of frame 0
  Vec3<T> linear_acceleration{};   ///< m/s^2, of frame 0's origin, without gravity
};

/// Gravity as the robot declares it.
struct Gravity : Feature<Gravity> {};

/// Gravity known at run time, for a tilted or moving base: input `gravity`, acceleration of free fall in axes of frame
/// 0, m/s^2. Starts as the robot declares it; for a run-time model as NaN, until given.
struct RuntimeGravity : Feature<RuntimeGravity> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input {
    Vec3<T> gravity = declared<Robot>(0);  ///< m/s^2, axes of frame 0

   private:
    template <class R>
    static constexpr auto declared(int) -> decltype(R::chain.gravity, Vec3<T>{}) {
      using N = detail::DeclaredGravity<R, T>;
      return {N::constant(R::chain.gravity.x), N::constant(R::chain.gravity.y), N::constant(R::chain.gravity.z)};
    }
    template <class R>
    static constexpr Vec3<T> declared(...) {
      const T unknown = NumberTraits<T>::constant(std::numeric_limits<double>::quiet_NaN());
      return {unknown, unknown, unknown};
    }
  };
};

/// A base that moves as it is told: input `base_motion`. Torques and accelerations follow; M(q) does not change.
struct BaseMotion : Feature<BaseMotion> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input {
    GivenMotion<T> base_motion{};  ///< starts at rest
  };
};

/// A base that is free to move: the rigid body that the robot declares with axial::base_body() is fixed to frame 0.
/// Input `base_motion` as for BaseMotion: forward dynamics takes the angular velocity from it and finds the
/// accelerations; inverse dynamics and base_wrench take all. doc/guides/moving_base.md.
struct FloatingBase : Feature<FloatingBase> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input : BaseMotion::Input<Robot, T> {};
};

/// Force that the environment (thrusters, a contact) exerts on a floating base: axes and origin of frame 0, input
/// `base_wrench`.
struct BaseWrench : Feature<BaseWrench> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input {
    ForceVector<Vec3<T>, Vec3<T>> base_wrench{};  ///< N m, N; starts as 0
  };
};

/// Links and base body in still water: added mass, buoyancy (where gravity is named), drag. doc/guides/moving_base.md.
struct Underwater : Feature<Underwater> {};

/// Velocity of the origin of frame 0 through the water, input `velocity_through_water`, m/s in axes of frame 0: its own
/// less that of a steady, uniform current. For an underwater base that moves, or a fixed one in a current.
struct VelocityThroughWater : Feature<VelocityThroughWater> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input {
    Vec3<T> velocity_through_water{};  ///< m/s, starts as 0
  };
};

/// gear^2 J of each drive on its own joint.
struct RotorInertia : Feature<RotorInertia> {};

/// Rotors as bodies that spin on the links that carry them, beside RotorInertia (doc/guides/rotors.md).
struct RotorDynamics : Feature<RotorDynamics> {};

namespace detail {
/// Stops the compiler where a scene names RotorDynamics and what computes it is not included.
template <class Scene, bool named = Scene::template has<RotorDynamics>>
struct RotorsIncluded {
  static_assert(
      !named,
      "axial: rotors as bodies are a header of their own: add #include <axial/transmissions/rotor_dynamics.hpp>");
};
}  // namespace detail

/// Friction as the links declare it, on the joint side: viscous, Coulomb, Stribeck; 0 at rest.
struct Friction : Feature<Friction> {};

/// Springs across the joints as the links declare them: the drive exerts stiffness (q - rest position) besides.
struct JointSprings : Feature<JointSprings> {};

/// Transmissions as elastic as the links declare them: elastic_feedforward() asks for it, others take joints as rigid.
struct ElasticJoints : Feature<ElasticJoints> {};

/// Force that the environment exerts on the last link: axes and origin of its frame, input `tip_wrench`.
struct TipWrench : Feature<TipWrench> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input {
    ForceVector<Vec3<T>, Vec3<T>> tip_wrench{};  ///< N m, N; starts as 0
  };
};

/// Forces that the environment exerts on every link i: axes and origin of its frame, input `wrenches[i]`.
struct ExternalWrenches : Feature<ExternalWrenches> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input {
    Joints<typename detail::LinksOwner<Robot>::type, ForceVector<Vec3<T>, Vec3<T>>> wrenches{};  ///< N m, N; start as 0
  };
};

/// A run-time load on the last link, input `payload`.
struct Payload : Feature<Payload> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input {
    PayloadBody<T> payload{};  ///< starts as none
  };
};

/// Sine-cosine pairs of the joint positions from the caller (encoder tables, a CORDIC, sine_cosines() shared by several
/// algorithms): input `turns[i]`, of q without the offset theta; ignored for prismatic joints. NaN until given
/// (in fixed point, with the exponent InputFormats::sine_cosine, 0).
struct SineCosines : Feature<SineCosines> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input {
    Joints<typename detail::LinksOwner<Robot>::type, SinCos<T>> turns = unknown();  ///< one per joint

   private:
    static constexpr auto unknown() {
      Joints<typename detail::LinksOwner<Robot>::type, SinCos<T>> turns{};
      for (auto& turn : turns.values)
        turn.sin = turn.cos = detail::UnknownTurn<T>::value();
      return turns;
    }
  };
};

/// Loops over a table of links instead of unrolling: small code for small flash, and for long chains.
struct Looped : Feature<Looped> {};

/// For a run-time Model: no link has a branch (add() refuses one), so that no time goes into branch screws that are not
/// there. A robot's type says so by itself.
struct Unbranched : Feature<Unbranched> {};

/// For a run-time Model: joints may share drives (add() refuses such links without it), and values are those of the
/// drives. The chain of a robot's type says so by itself. Include <axial/transmissions/driven_model.hpp> for it.
struct SharedDrives : Feature<SharedDrives> {};

/// Inertial parameters regrouped at compile time (base_parameters.hpp): the default of inverse dynamics, its gravity
/// and bias parts, and the mass matrix. Naming it makes forward dynamics use them too: cheaper, but links become
/// differences of large numbers, so only short, well-conditioned arms stay exact.
struct BaseParameters : Feature<BaseParameters> {};

/// Every link's own inertial parameters, for all algorithms: the default of forward dynamics.
struct FullParameters : Feature<FullParameters> {};

/// Forward dynamics by the articulated-body algorithm of McMillan and Orin 1995: exact whatever the conditioning.
struct ArticulatedBody : Feature<ArticulatedBody> {};

/// Forward dynamics by the bias torque and an articulated-body pass of the structure at rest: loses less in narrow
/// number systems where speeds and gravity are moderate.
struct SplitArticulatedBody : Feature<SplitArticulatedBody> {};

/// Forward dynamics by the bias torque, composite bodies and an elimination that follows the tree: the cheapest for
/// short, well-conditioned arms.
struct CompositeBody : Feature<CompositeBody> {};

/// Fixed point: results are rounded down instead of to nearest, which saves an addition each.
struct RoundDown : Feature<RoundDown> {};

/// Fixed point: of a product only the upper word is kept, rounded down: cheaper, above all on cores without a long
/// multiply, and less exact.
struct HighWord : Feature<HighWord> {};

/// Fixed point, for tests on a host: sums do not wrap, and results that do not fit their format are counted in
/// `axial::range_overflows`. Same results where nothing overflows.
struct RangeCheck : Feature<RangeCheck> {};

}  // namespace axial

#include <axial/options/end.hpp>
