// Forward dynamics of joints that share drives in fixed point: M and the bias of the drives in words, each with its
// certified error, and what the words of M make of the rest.
#pragma once

#include <axial/fixed/dynamics/drive_solve.hpp>
#include <axial/fixed/dynamics/inverse_dynamics.hpp>
#include <axial/fixed/recursion/steps.hpp>
#include <axial/transmissions/shared_drives.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

template <class S, class Word>
constexpr void check_driven_solve() {
  static_assert(8 * sizeof(Word) == 32,
                "axial: forward dynamics of joints that share drives in fixed point is that of Fixed32");
  static_assert(!scene_of<S>::template has<ArticulatedBody> && !scene_of<S>::template has<SplitArticulatedBody>,
                "axial: in fixed point joints that share drives are solved by composite bodies; take ArticulatedBody "
                "and SplitArticulatedBody out of the scene");
  static_assert(
      drive_units<S, Word>.resisted,
      "axial: forward dynamics of joints that share drives takes its formats from what each drive is resisted by; give "
      "every drive rotor_inertia() and name RotorInertia, or every link that it moves an inertia about its "
      "centre of mass (a slide: a mass); or compute this scene in float");
}

/// How many times its declared acceleration a drive's answer may be and still be right to a thousandth of that.
inline constexpr double trusted_drive_times = 2048.0;
/// That as words.
template <class S, class Word>
inline constexpr auto trusted_words = [] {
  using Answers = FreeAccelerations<subject_of<S, Stored<Word>>, Stored<Word>>;
  constexpr double most = 2147483647.0;
  Row<std::int32_t, joint_count<S>> words{};
  for (int k = 0; k < joint_count<S>; ++k) {
    const double limit = scene_of<S>::Robot::chain.links[k].acceleration_limit * trusted_drive_times *
                         power_of_two(Answers::exponent(k));
    words[k] = static_cast<std::int32_t>(limit < most ? limit : most);
  }
  return words;
}();

/// What drives have left to accelerate with, in words of efforts, and M of them.
template <class S, class Word>
struct DrivenSystem {
  using T = Stored<Word>;
  static constexpr int size = joint_count<S>;
  std::int64_t left[size] = {};
  MassMatrixOf<S, T> m{};

  template <class Q, class V, class Tau, class Input>
  AXIAL_INLINE constexpr DrivenSystem(const Input& in, const Q& u, const V& ud, const Tau& tau) {
    const auto motion = links_of<scene_of<S>, T, BaseParameters, recursion::NewtonEuler>();
    const auto bodies = links_of<scene_of<S>, T, BaseParameters, recursion::CompositeBodies>();
    EffortsOf<S, T> bias{};
    DrivenKernels<decltype(motion)>::efforts(motion, in, u, ud, NoMotion{}, bias);
    DrivenKernels<decltype(bodies)>::matrix_at(bodies, in, u, m);
    for (int k = 0; k < size; ++k)
      left[k] = std::int64_t{tau[k].raw} - bias[k].raw;
  }
};

/// The status of an answer of drives: the first that is lost, or that no word holds, or that is beyond trust.
template <class S, class Word>
AXIAL_INLINE constexpr Status driven_status(const std::int32_t* x, int lost, int spilt) {
  int beyond = -1;
  for (int k = 0; k < joint_count<S>; ++k)
    beyond = first_found(beyond, is_less_wide(trusted_words<S, Word>[k], word_magnitude(x[k])), k);
  const bool is_lost = !is_negative(lost), is_spilt = !is_negative(spilt), is_beyond = !is_negative(beyond);
  int code = select(is_beyond, static_cast<int>(Status::Code::acceleration_limit), static_cast<int>(Status::Code::ok));
  code = select(is_spilt, static_cast<int>(Status::Code::saturated), code);
  code = select(is_lost, static_cast<int>(Status::Code::near_singular), code);
  return status_from(code, select(is_lost, lost, select(is_spilt, spilt, beyond)));
}

}  // namespace detail

namespace driven {
/// Forward dynamics of drives in words.
template <class Scene, class S, class Parameters, class Recursion>
struct CompositeRigidBodies<FixedDrivenLinks<Scene, S, Parameters, Recursion>> {
  /// Accelerations of the drives.
  template <class Links, class Input, class Q, class V, class Tau, class A>
  AXIAL_INLINE static constexpr Status accelerations(const Links&, const Input& in, const Q& u, const V& ud,
                                                     const Tau& tau, A& udd) {
    using Word = typename S::Word;
    static_assert((detail::check_driven_solve<Scene, Word>(), true));
    const detail::DrivenSystem<Scene, Word> system(in, u, ud, tau);
    const detail::DriveSolve<Scene, Word> solve(system.m);
    std::int32_t x[Scene::Robot::chain.size] = {};
    int spilt = -1;
    solve.accelerations(system.left, x, spilt);
    for (int k = 0; k < Scene::Robot::chain.size; ++k)
      udd.values[k] = {static_cast<Word>(x[k])};
    return detail::driven_status<Scene, Word>(x, solve.lost(), spilt);
  }
};
}  // namespace driven
}  // namespace axial

#include <axial/options/end.hpp>
