#pragma once
/// What an arm does besides moving as a rigid body with its rotors. A robot names it in a struct of its own, and what
/// it does not name costs nothing:
///
///   struct MyArm {
///     static constexpr auto chain = ...;
///     struct Mechanics {
///       // Friction as the chain declares it; dry friction sticks.
///       static constexpr bool friction = true;
///       // Springs, likewise, in float; as stiff as you like.
///       static constexpr bool springs = true;
///       // N m/rad and N m s/rad beyond its position limits; in fixed point they do not yield.
///       static constexpr axial::EndStops stops{1e5, 30.0};  // <axial/simulation/end_stops.hpp>
///       // Joints with a stiffness() stand behind springs, in float.
///       static constexpr bool elastic = true;
///       // Taken and put down on command.
///       static constexpr bool payload = true;
///       // N m or N, standard deviation, drawn anew each ms.
///       static constexpr double torque_noise[] = {0.1, 0, 0};
///       // A turn; on slides steps of a metre over 2^bits.
///       static constexpr int encoder_bits = 14;
///       // ms until positions and speeds are answered.
///       static constexpr int encoder_delay = 1;
///       // rad or m between a motor's encoder and its joint.
///       static constexpr double backlash[] = {1e-3, 0, 0};
///     };
///   };

#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/sticking.hpp>
#include <axial/simulation/end_stops.hpp>
#include <axial/simulation/sticking.hpp>

#include <cstdint>
#include <type_traits>

namespace axial::apps::plant {

struct NoMechanics {};
template <class R, class = void>
struct NamedMechanics {
  using type = NoMechanics;
};
template <class R>
struct NamedMechanics<R, std::void_t<typename R::Mechanics>> {
  using type = typename R::Mechanics;
};
template <class R>
using MechanicsOf = typename NamedMechanics<R>::type;

// What a struct M names, else nothing.
///@{
template <class M, class = void>
inline constexpr bool has_friction = false;
template <class M>
inline constexpr bool has_friction<M, std::void_t<decltype(M::friction)>> = M::friction;

template <class M, class = void>
inline constexpr bool has_springs = false;
template <class M>
inline constexpr bool has_springs<M, std::void_t<decltype(M::springs)>> = M::springs;

template <class M, class = void>
inline constexpr bool has_elastic = false;
template <class M>
inline constexpr bool has_elastic<M, std::void_t<decltype(M::elastic)>> = M::elastic;

template <class M, class = void>
inline constexpr bool has_stops = false;
template <class M>
inline constexpr bool has_stops<M, std::void_t<decltype(M::stops)>> = true;

template <class M, class = void>
inline constexpr bool has_payload = false;
template <class M>
inline constexpr bool has_payload<M, std::void_t<decltype(M::payload)>> = M::payload;

template <class M, class = void>
inline constexpr bool has_noise = false;
template <class M>
inline constexpr bool has_noise<M, std::void_t<decltype(M::torque_noise)>> = true;

template <class M, class = void>
inline constexpr bool has_backlash = false;
template <class M>
inline constexpr bool has_backlash<M, std::void_t<decltype(M::backlash)>> = true;

template <class M, class = void>
inline constexpr int encoder_bits = 32;
template <class M>
inline constexpr int encoder_bits<M, std::void_t<decltype(M::encoder_bits)>> = M::encoder_bits;

template <class M, class = void>
inline constexpr int encoder_delay = 0;
template <class M>
inline constexpr int encoder_delay<M, std::void_t<decltype(M::encoder_delay)>> = M::encoder_delay;
///@}

/// The scene of a robot and of what it names.
///@{
template <class S, bool named, class Feature>
struct WithFeature {
  using type = S;
};
template <class R, class... Features, class Feature>
struct WithFeature<Scene<R, Features...>, true, Feature> {
  using type = Scene<R, Features..., Feature>;
};
template <class R, class M = MechanicsOf<R>>
struct ArmScene {
  using Rigid = Scene<R, Gravity, RotorInertia>;
  using Rubbing = typename WithFeature<Rigid, has_friction<M>, Friction>::type;
  using Sprung = typename WithFeature<Rubbing, has_springs<M>, JointSprings>::type;
  using type = typename WithFeature<Sprung, has_payload<M>, Payload>::type;
};
template <class R>
using ArmSceneOf = typename ArmScene<R>::type;
///@}

/// What is stiff by itself, by `substeps` steps a tick of 1 ms.
template <class R, int substeps>
struct OwnStiffness {
  static constexpr double step = 1e-3 / substeps;
  static constexpr double stiffness[joint_count<R>] = {}, damping[joint_count<R>] = {};
};

/// Who moves it: friction that sticks, stops and whatever is stiff by implicit steps, all else by Runge-Kutta.
template <class R, class Number, int substeps, class M = MechanicsOf<R>>
struct ArmMethod {
  static constexpr bool stiff = has_springs<M> || has_elastic<M> || has_stops<M>;
  using type =
      std::conditional_t<has_friction<M>, StickingEuler, std::conditional_t<stiff, LinearlyImplicitEuler, RungeKutta4>>;
};
template <class R, class Word, int substeps, class M>
struct ArmMethod<R, Stored<Word>, substeps, M> {
  using type = std::conditional_t<has_friction<M> || has_stops<M>, StickingFor<OwnStiffness<R, substeps>>, RungeKutta4>;
};

}  // namespace axial::apps::plant
