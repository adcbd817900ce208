// How much eliminating M(q) loses against ABA, over the whole chain or tree: what route.hpp judges by.
#pragma once

#include <axial/dynamics/elimination_error.hpp>
#include <axial/dynamics/plain_mass_matrix.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

inline constexpr int loss_samples = 12;  ///< configurations at which the error is computed

/// Where joint `joint` stands in configuration `sample` of them: inside its limits; without limits a revolute joint
/// anywhere on its circle, a slide as far as the arm's links are long. The first one is the arm as it is drawn.
constexpr double sampled_position(const LinkParameters* links, int size, int sample, int joint) {
  constexpr double half_turn = 3.14159265358979, unlimited = LinkParameters::unlimited;
  const auto& link = links[joint];
  double reach = half_turn;
  if (link.type == JointType::prismatic) {
    reach = 0.0;
    for (int i = 0; i < size; ++i)
      reach += magnitude(links[i].a) + magnitude(links[i].d);
  }
  const double low = link.position_min > -unlimited ? link.position_min : -reach;
  const double high = link.position_max < unlimited ? link.position_max : low + 2.0 * reach;
  if (sample == 0) return low > 0.0 ? low : high < 0.0 ? high : 0.0;
  const double step = 0.6180339887498949 + 0.1234567891 * joint;  // no two joints in step
  const double place = 0.25 + step * sample * (joint + 1);
  return low + (place - static_cast<double>(static_cast<int>(place))) * (high - low);
}

/// What of a scene M(q) feels, in the looped form.
template <class Scene, class... Features>
using FeltScene = std::conditional_t<Scene::template has<RotorInertia>,
                                     axial::Scene<typename Scene::Robot, Looped, RotorInertia, Features...>,
                                     axial::Scene<typename Scene::Robot, Looped, Features...>>;

// The declared payload at its largest, its centre of mass along one axis after the other.
template <class Robot, class T>
constexpr PayloadBody<T> largest_payload(int sample) {
  constexpr PayloadLimit limit = Robot::chain.payload_limit;
  const T arm = static_cast<T>(limit.com_reach), none = T(0), j = static_cast<T>(limit.inertia);
  const int axis = sample % 3;
  return {static_cast<T>(limit.mass),
          {axis == 0 ? arm : none, axis == 1 ? arm : none, axis == 2 ? arm : none},
          {j, j, j, none, none, none}};
}

template <class Scene, bool loaded, class T>
constexpr auto sampled_matrix(int sample) {
  using Robot = typename Scene::Robot;
  Positions<robot_of<Scene>, T> q{};
  for (int i = 0; i < Robot::chain.size; ++i)  // in double too the angle that float has
    q[i] = static_cast<T>(static_cast<float>(sampled_position(Robot::chain.links, Robot::chain.size, sample, i)));
  if constexpr (loaded) {
    Inputs<FeltScene<Scene, Payload>, T> in{};
    in.payload = largest_payload<Robot, T>(sample);
    return PlainMassMatrix<FeltScene<Scene, Payload>, T>(q, in);
  } else {
    return PlainMassMatrix<FeltScene<Scene>, T>(q, no_inputs<FeltScene<Scene>, T>());
  }
}

/// Roundings of the largest acceleration that an elimination may lose where it is taken by default: sixteen times what
/// ABA loses of itself on well-conditioned arms, which grows with their joints to four roundings at seven of them. Half
/// as much where joints slide and axes are not all parallel: then slides and turns accelerate each other, and unlike
/// units are of unlike sizes.
constexpr double acceptable_loss(const LinkParameters* links, int size) {
  bool slides = false, twisted = false;
  for (int i = 0; i < size; ++i) {
    slides = slides || links[i].type == JointType::prismatic;
    twisted = twisted || magnitude(links[i].alpha.sin) > 0.0;
  }
  return (slides && twisted ? 32.0 : 64.0) * (size < 7 ? size : 7) / 7.0;
}
template <class Robot>
constexpr auto parents_of() {
  Parents<Robot::chain.size> parents;
  for (int i = 0; i < Robot::chain.size; ++i)
    parents.of[i] = Robot::chain.parent(i);
  return parents;
}

/// The error at one configuration, or something above `enough` where it is more than that: M in float is not computed
/// where M in double tells.
template <class Scene, bool loaded>
constexpr double loss_at(int sample, double enough) {
  constexpr int n = Scene::Robot::chain.size;
  const auto exact = sampled_matrix<Scene, loaded, double>(sample);
  const ScaledInverse<n> inverse(exact, parents_of<typename Scene::Robot>(), n);
  if (!inverse.invertible()) return infinite_loss;
  if (inverse.least_error() > enough) return inverse.least_error();
  return inverse.error(exact, sampled_matrix<Scene, loaded, float>(sample));
}
/// The same as a constant, one per configuration: compilers bound the steps of each.
template <class Scene, bool loaded, int sample>
inline constexpr double sampled_loss = loss_at<Scene, loaded>(sample, acceptable_loss(Scene::Robot::chain.links,
                                                                                      Scene::Robot::chain.size));

/// Whether no configuration from `sample` on loses more than is accepted. The first one that does decides.
template <class Scene, bool loaded, int sample = 0>
constexpr bool loses_little_from() {
  constexpr double most = acceptable_loss(Scene::Robot::chain.links, Scene::Robot::chain.size);
  if constexpr (sample == loss_samples)
    return true;
  else if constexpr (sampled_loss<Scene, loaded, sample> <= most)
    return loses_little_from<Scene, loaded, sample + 1>();
  else
    return false;
}
/// Whether an elimination of the scene's M(q) stays within what is accepted over the sampled configurations. A run-time
/// payload counts as none and at the declared maximum; where none is declared it may lose anything.
template <class Scene>
constexpr bool decide_elimination_loses_little() {
  if constexpr (Scene::template has<Payload> && !Scene::Robot::chain.payload_limit.declared)
    return false;
  else if constexpr (!loses_little_from<Scene, false>())
    return false;
  else if constexpr (Scene::template has<Payload>)
    return loses_little_from<Scene, true>();
  else
    return true;
}
template <class Scene>
inline constexpr bool elimination_loses_little = decide_elimination_loses_little<Scene>();

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
