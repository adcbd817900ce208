// A small robot that declares everything a scene can name, and every scene's inputs in numbers that float holds
// exactly.
#pragma once

#include <oracle/moving_base.hpp>

#include <property/support.hpp>

namespace property {

/// Four general links: a slide among turns, branches on the base and on the slide, every kind of friction, springs,
/// rotors.
struct Everything {
  // A line a group of values.
  // clang-format off
  static constexpr auto chain = axial::chain(
      axial::gravity(1.5, -2.25, -9.5),
      axial::revolute().branch(-0.3, 0.125).alpha(0.4).a(0.125).d(0.25)
          .mass(4.5).com(0.0625, -0.03125, 0.125).inertia_com(0.25, 0.1875, 0.21875, 0.015625, -0.03125, 0.0078125)
          .rotor_inertia(0.0001220703125, 64)
          .viscous(0.375).coulomb(1.25, -0.75).stribeck(2.0, 0.25).smooth_speed(0.5).spring(12.0, 0.25),
      axial::prismatic().alpha_deg(90).a(0.25).d(0.125).theta(0.3)
          .mass(2.5).com(0.03125, 0.0625, -0.125).inertia_com(0.0625, 0.09375, 0.078125, 0.0, 0.015625, 0.0)
          .rotor_inertia(0.00048828125, 32).viscous(24.0).coulomb(6.0).spring(200.0, 0.0625),
      axial::revolute().branch(0.7, 0.1875).alpha_deg(-90).d(0.1875).theta(-0.7)
          .mass(1.5).com(-0.0625, 0.03125, 0.09375).inertia_com(0.03125, 0.0234375, 0.0390625, 0.00390625, 0.0, 0.0078125)
          .coulomb(0.5, -0.25).smooth_speed(1.0).rotor_inertia(0.000030517578125, 96),
      axial::revolute().alpha(1.1).a(0.0625)
          .mass(0.75).com(0.03125, 0.0, 0.0625).inertia_com(0.0078125, 0.00390625, 0.005859375)
          .coulomb(0.25).stribeck(0.375, 0.5).spring(1.5));
  // clang-format on
};

/// Gives a number to every input that a scene has.
class Fill {
 public:
  template <class S, class T>
  static axial::Inputs<S, T> inputs(const axial::Joints<axial::robot_of<S>, T>& q) {
    using Scene = axial::scene_of<S>;
    axial::Inputs<S, T> in;
    if constexpr (Scene::template has<axial::RuntimeGravity>) in.gravity = {T(-3), T(2.5), T(8)};
    if constexpr (Scene::template has<axial::BaseMotion>)
      in.base_motion = {{T(0.75), T(-1.25), T(0.5)}, {T(-2), T(1.5), T(3)}, {T(4), T(-1), T(2.5)}};
    if constexpr (Scene::template has<axial::TipWrench>)
      in.tip_wrench = {{T(0.5), T(-0.25), T(0.75)}, {T(3), T(-2), T(5)}};
    if constexpr (Scene::template has<axial::ExternalWrenches>)
      for (int i = 0; i < 4; ++i)
        in.wrenches[i] = {{T(0.5 * i), T(-1), T(0.25)}, {T(2), T(i), T(-1.5)}};
    if constexpr (Scene::template has<axial::SineCosines>)
      for (int i = 0; i < 4; ++i)
        in.turns[i] = axial::sincos(q[i]);
    return in;
  }

  /// The same as the oracle sees it; a moving base apart.
  template <class S>
  static oracle::Load<oracle::quad> load() {
    using oracle::quad;
    using Scene = axial::scene_of<S>;
    oracle::Load<quad> load;
    load.friction = Scene::template has<axial::Friction>;
    load.springs = Scene::template has<axial::JointSprings>;
    if constexpr (Scene::template has<axial::TipWrench>)
      load.tip = {{quad(3), quad(-2), quad(5)}, {quad(0.5), quad(-0.25), quad(0.75)}};
    if constexpr (Scene::template has<axial::ExternalWrenches>)
      for (int i = 0; i < 4; ++i)
        load.links.push_back({{quad(2), quad(i), quad(-1.5)}, {quad(0.5 * i), quad(-1), quad(0.25)}});
    return load;
  }
  template <class S>
  static oracle::BaseMotion<oracle::quad> base_motion() {
    if constexpr (!axial::scene_of<S>::template has<axial::BaseMotion>) return {};
    return {{0.75, -1.25, 0.5}, {-2, 1.5, 3}, {4, -1, 2.5}};
  }
  template <class S, class Robot>
  static oracle::Chain<oracle::quad> chain() {
    using Scene = axial::scene_of<S>;
    auto chain = oracle::of_robot<oracle::quad, Robot>();
    if (!Scene::template has<axial::RotorInertia>) chain = oracle::without_rotors(chain);
    if (Scene::template has<axial::RuntimeGravity>)
      chain.gravity = {-3, 2.5, 8};
    else if (!Scene::template has<axial::Gravity>)
      chain.gravity = {};
    return chain;
  }
};

}  // namespace property
