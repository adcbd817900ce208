// Forward dynamics of joints that share drives in fixed point: M and the bias of the drives in words, each with its
// certified error; M udd = rest eliminated once, and refined by what the answer leaves of it.
#pragma once

#include <axial/fixed/dynamics/inverse_dynamics.hpp>
#include <axial/fixed/dynamics/mass_matrix.hpp>
#include <axial/fixed/formats/drive_units.hpp>
#include <axial/fixed/recursion/steps.hpp>
#include <axial/fixed/words/wide_words.hpp>
#include <axial/transmissions/shared_drives.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// Joints that an elimination leaves out: none.
struct NoneHeld {
  AXIAL_INLINE constexpr bool operator()(int) const { return false; }
};

/// M eliminated (L^T D L, Featherstone 2008, section 6.5) in DriveUnits, whose bounds hold every word, and solutions.
/// Joints that are `held` keep the acceleration that they are given: a part of M is no harder to solve than the whole.
template <class S, class Word, class OwnUnits = DriveUnits<S, Word>, class Held = NoneHeld>
class DriveSolve : Held {
 public:
  using Units = OwnUnits;
  using Matrix = MassMatrixOf<S, Stored<Word>>;
  using A = ArithmeticOf<scene_of<S>, Word>;
  static constexpr int size = Units::size, bits = Units::bits;
  static constexpr bool holds = !std::is_same_v<Held, NoneHeld>;
  static constexpr const auto& u = drive_units<S, Word, Units>;

  /// Eliminates M from the last drive on.
  AXIAL_INLINE constexpr explicit DriveSolve(const Matrix& m, const Held& held = {}) : Held(held), m_(m) {
    std::int32_t left[size][size] = {};
    for (int k = 0; k < size; ++k)
      for (int l = 0; l <= k; ++l)
        left[k][l] = m(k, l).raw >> u.down[k][l];
    for (int k = size; k-- > 0;)
      eliminate(left, k);
  }
  /// The innermost drive whose inertia is lost in rounding, -1 for none. It is held, too.
  [[nodiscard]] AXIAL_INLINE constexpr int lost() const { return lost_; }

  /// M'^-1 w in words of bits - gain_bits[k] behind the point, in place.
  AXIAL_INLINE constexpr void solve(std::int32_t (&w)[size]) const {
    for (int k = size; k-- > 0;)
      for (int i = 0; i < k; ++i)
        w[i] = narrowed<A>(w[i] - wide_rounded(integer::multiply(gain_[k][i], w[k]), bits - u.gain_bits[k]));
    for (int k = 0; k < size; ++k) {
      std::int64_t own = wide_rounded(integer::multiply(w[k], mantissa_[k]), shift_[k]);
      for (int i = 0; i < k; ++i)
        own -= wide_rounded(integer::multiply(gain_[k][i], w[i]), bits - u.gain_bits[i]);
      w[k] = narrowed<A>(own);
    }
  }
  /// What accelerations, in words, leave of `left`, efforts in their words; all to `size` units.
  AXIAL_INLINE constexpr void residual(const std::int64_t (&left)[size], const std::int32_t (&x)[size],
                                       std::int64_t (&r)[size]) const {
    for (int k = 0; k < size; ++k) {
      r[k] = wide_raised(left[k], u.given[k]);
      for (int l = 0; l < size; ++l)
        r[k] -= wide_shifted_by(integer::multiply(m_(k, l).raw, x[l]), u.product[k][l]);
    }
  }
  /// Accelerations, in words; `spilt` is the first drive whose word does not hold its own.
  AXIAL_INLINE constexpr void accelerations(const std::int64_t (&left)[size], std::int32_t (&x)[size],
                                            int& spilt) const {
    for (int s = 0; s < Units::solves; ++s)
      improve(left, x, spilt);
  }
  /// Accelerations by one solve of what those at hand leave.
  AXIAL_INLINE constexpr void improve(const std::int64_t (&left)[size], std::int32_t (&x)[size], int& spilt) const {
    std::int64_t r[size] = {};
    residual(left, x, r);
    if constexpr (holds)
      for (int k = 0; k < size; ++k)
        r[k] = select_wide(is_held(k), 0, r[k]);
    spilt = -1;
    correct(r, x, spilt);
  }

 private:
  const Matrix& m_;
  std::int32_t gain_[size][size] = {}, mantissa_[size] = {};
  int shift_[size] = {}, lost_ = -1;

  AXIAL_INLINE constexpr bool is_held(int k) const { return Held::operator()(k); }
  AXIAL_INLINE constexpr void eliminate(std::int32_t (&left)[size][size], int k) {
    const bool resists = !is_less_wide(left[k][k], u.least[k]), held = is_held(k), kept = resists & !held;
    const auto inverse = integer::reciprocal(static_cast<std::int32_t>(select_wide(kept, left[k][k], 1)));
    lost_ = select(resists | held, lost_, k);
    mantissa_[k] = static_cast<std::int32_t>(inverse.mantissa) & -static_cast<std::int32_t>(kept);
    shift_[k] = inverse.exponent - bits + u.gain_bits[k];
    for (int i = 0; i < k; ++i)
      gain_[k][i] = narrowed<A>(wide_rounded(integer::multiply(left[k][i], mantissa_[k]), shift_[k]));
    for (int i = 0; i < k; ++i)
      for (int j = 0; j <= i; ++j)
        left[i][j] =
            narrowed<A>(left[i][j] - wide_rounded(integer::multiply(gain_[k][i], left[k][j]), bits - u.gain_bits[k]));
  }
  /// x + M^-1 r, r as large as words hold it.
  AXIAL_INLINE constexpr void correct(const std::int64_t (&r)[size], std::int32_t (&x)[size], int& spilt) const {
    int most = -1000;
    for (int k = 0; k < size; ++k) {
      const int own = wide_bits(r[k]) + u.norm_bits[k] - u.residual[k] - u.scale[k];
      most = static_cast<int>(select_wide(is_less_wide(most, own), own, most));
    }
    std::int32_t w[size] = {};
    bool fits = true;
    for (int k = 0; k < size; ++k)
      w[k] = narrowed<A>(moved_wide(r[k], u.residual[k] + u.scale[k] - bits + most, fits));
    solve(w);
    for (int k = 0; k < size; ++k) {
      const int down = bits - u.gain_bits[k] - most + u.scale[k] - Units::Answers::exponent(k);
      bool held = true, over = false;
      const std::int64_t whole = moved_wide(wide_raised(w[k], 1), down, held);
      x[k] = held_in_word<A>(over, x[k] + ((whole + 1) >> 1));
      spilt = first_found(spilt, over | !held, k);
    }
  }
};

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
    execute<rnea::InverseDynamics>(motion, in, u, ud, NoMotion{}, bias);
    execute<crba::CompositeMatrix>(bodies, in, u, m);
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
