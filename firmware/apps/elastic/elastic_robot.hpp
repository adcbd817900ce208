#pragma once
/// Arms behind harmonic drives: a robot of robots/ with elastic joints, whose stiffness is assumed.

#include <axial/axial.hpp>

namespace axial::apps {

/// The links of `Robot` behind springs so stiff that each joint, its motor locked and the others rigid in the middle of
/// their travel, swings at `resonance` Hz: K_i = (2 pi f)^2 M_ii of the links alone. Harmonic drives lie at 10 to 20.
/// A robot that declares no rotors gets motors as heavy as its links, gear^2 J = M_ii. Both are assumptions, no figures
/// of a manufacturer.
template <class Of, int resonance>
struct Elastic {
  static constexpr const char* name = Of::name;
  static constexpr auto chain = [] {
    constexpr double w = 2.0 * 3.14159265358979323846 * resonance;
    auto chain = Of::chain;
    Joints<Of, double> middle{};
    for (int i = 0; i < chain.size; ++i)
      middle[i] = 0.5 * (chain.links[i].position_min + chain.links[i].position_max);
    const auto mass = mass_matrix<Scene<Of, Gravity>>(middle);
    for (int i = 0; i < chain.size; ++i) {
      auto& link = chain.links[i];
      link.stiffness = w * w * mass(i, i);
      if (!(link.rotor_inertia > 0.0)) link.rotor_inertia = mass(i, i), link.gear = 1.0;
    }
    return chain;
  }();
};

}  // namespace axial::apps
