// Derivatives of forward dynamics in words from those of inverse dynamics, with a bound of each.
#pragma once

#include <axial/fixed/derivatives/derivative_units.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Stands for bounds that nobody asked for.
struct NoBounds {
  struct Matrix {};
  Matrix M_inverse, dqdd_dq, dqdd_dqd;
};
/// A bound in words, the largest where the answer is not known.
AXIAL_INLINE constexpr std::int32_t bound_word(std::int64_t off, bool known) {
  constexpr std::int32_t most = (std::numeric_limits<std::int32_t>::max)();
  return static_cast<std::int32_t>(select_wide(known & fits_word(off), off, most));
}

/// One solve at a state: everything in the units of DerivativeUnits.
template <class S, class T>
struct DerivativeSolve {
  using C = Certificate<S, T>;
  static constexpr int size = C::size;
  /// Row sums of |1 - M B|, and the share of what a joint declares that its acceleration can be off, for an answer to
  /// be called accurate.
  static constexpr std::int64_t slight_spread = std::int64_t{1} << (MassInverse<size>::defect_bits - 10);
  static constexpr std::int64_t slight_drift = std::int64_t{1} << 23, largest_drift = std::int64_t{1} << 28;

  MassInverse<size> system{};
  std::int64_t correction[size] = {}, bound[size] = {};  ///< of the accelerations
  std::int32_t lack[size] = {};  ///< of efforts that are off by no more, B makes what the correction can be
  std::int64_t drift = 0;  ///< how far the exact accelerations can be from those of the Jacobians, of half of 2^30
  bool known = true;       ///< whether accelerations are bounded
  int spilt = -1;          ///< first joint one of whose entries does not fit its format

  /// B by the structure's answers.
  constexpr void set_inverse(const Positions<robot_of<S>, T>& q, const Inputs<S, T>& in) {
    const auto links = links_of<scene_of<S>, T, FullParameters, recursion::ArticulatedBodiesAtRest>();
    const auto screws = joint_screws(links, in, links.read(q));
    const auto structure = aba::structure_at_rest(links, in, screws);
    for (int j = 0; j < size; ++j) {
      std::int32_t column[size] = {};
      const int drive = unit_response<2>(links, screws, structure, j, column);
      set_column(certificate_of<S, T>, j, column, drive);
    }
  }
  /// B by an elimination of M, of which `columns` are solutions for unit efforts.
  constexpr void set_columns(const std::int32_t (&columns)[size][size]) {
    constexpr const auto& looped = looped_columns<S, T>;
    for (int j = 0; j < size; ++j) {
      set_column(looped, j, columns[j], looped.drive[j]);
    }
  }
  /// Refines B by M and bounds what it lacks.
  template <class M>
  constexpr void hold_against(const M& mass) {
    constexpr const auto& units = derivative_units<S, T>.mass;
    for (int i = 0; i < size; ++i)
      for (int k = 0; k < size; ++k)
        system.mass[i][k] = mass(i, k).raw >> units.down[i][k];
    for (int k = 0; k < 2; ++k) {
      if (k == 1) system.refine();
      system.find_defects(units);
    }
    system.bound();
  }
  /// Solves for what tau - needs leaves of the accelerations.
  template <class Tau>
  constexpr void correct(const Tau& tau, const Tau& needs) {
    constexpr const auto& units = derivative_units<S, T>;
    constexpr std::int64_t limit = MassInverse<size>::right_sides;
    std::int32_t left[size] = {};
    for (int i = 0; i < size; ++i) {
      const std::int64_t apart = std::int64_t{tau[i].raw} - needs[i].raw;
      const std::int64_t wide = in_equation(i, apart);
      const bool fits = is_less_wide(wide_magnitude(wide), limit);
      known = known & fits;
      left[i] = static_cast<std::int32_t>(wide & -static_cast<std::int64_t>(fits));
    }
    system.find_lack(left, units.effort_error, lack);
    for (int i = 0; i < size; ++i) {
      correction[i] = system.solved(i, left);
      bound[i] = system.off(i, lack);
      const std::int64_t apart = wide_magnitude(correction[i]) + bound[i];
      const bool close = is_less_wide(apart, largest_drift);
      known = known & close;
      drift = select_wide(is_less_wide(drift, apart), apart, drift);
    }
    drift = select_wide(known, drift, largest_drift);
  }
  /// Whether what is left of M^-1 and of the accelerations is slight.
  [[nodiscard]] constexpr bool is_accurate() const {
    bool all = is_less_wide(drift, slight_drift + 1);
    for (int i = 0; i < size; ++i)
      all = all & is_less_wide(system.spread[i], slight_spread + 1);
    return all;
  }
  /// M^-1 is B.
  template <class Matrix, class Bounds>
  constexpr void write_inverse(Matrix& values, Bounds& bounds, bool answered) {
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) {
        const int finer = Matrix::exponent(i, j) + EquationsOf<S, T>::exponent(j) - C::Requests::exponent(i);
        bool fits = true, bounded = true;
        const std::int64_t value = moved_wide(system.inverse[i][j], system.shift[j] - finer, fits);
        const bool is_held = put(i, values(i, j), value, fits, answered);
        if constexpr (is_asked<Bounds>) {
          const std::int64_t off = moved_wide(system.loss(i, j), MassInverse<size>::loss_bits - finer, bounded) + 2;
          bounds(i, j) = {bound_word(off, is_held & bounded)};
        }
      }
  }
  /// A Jacobian of forward dynamics: -B times that of inverse dynamics, which accelerations that are off move as
  /// `moves` says.
  template <class By, class From, class Drift, class Matrix, class Bounds>
  constexpr void write_slopes(By by, const From& from, const Drift& moves, Matrix& values, Bounds& bounds,
                              bool answered) {
    constexpr const auto& sides = right_hand_sides<S, typename T::Word, By, EquationsOf<S, T>>;
    for (int j = 0; j < size; ++j) {
      std::int32_t right[size] = {}, lacks[size] = {};
      for (int i = 0; i < size; ++i)
        right[i] = -(from(i, j).raw >> sides.down[i][j]);
      bool bounded = true;
      if constexpr (is_asked<Bounds>) bounded = find_lack<Matrix>(by, j, right, moves, lacks);
      for (int i = 0; i < size; ++i) {
        const int coarser = C::Requests::exponent(i) + sides.scale[j] - Matrix::exponent(i, j);
        bool fits = true, held = bounded;
        const std::int64_t value = moved_wide(system.solved(i, right), coarser, fits);
        const bool is_held = put(i, values(i, j), value, fits, answered);
        if constexpr (is_asked<Bounds>) {
          const std::int64_t off = moved_wide(system.off(i, lacks), coarser, held) + moves.off(i, j) + 2;
          bounds(i, j) = {bound_word(select_wide(sides.filled[j], off, 0), is_held & held)};
        }
      }
    }
  }

 private:
  template <class Shifts>
  AXIAL_INLINE constexpr void set_column(const Shifts& c, int j, const std::int32_t* column, int drive) {
    set_shifted_column<size>(c, system, j, column, drive);
    const bool above = is_less(-1, system.shift[j]), below = is_less(system.shift[j], 64);
    system.proved = system.proved & above & below;
  }
  AXIAL_INLINE static constexpr std::int64_t in_equation(int i, std::int64_t effort) {
    constexpr const auto& units = derivative_units<S, T>;
    const std::int64_t raised = effort * (std::int64_t{1} << units.effort_up[i]);
    if constexpr (scene_of<S>::template has<Looped>)
      return wide_shifted_by(raised, looped_columns<S, T>.effort_down[i]);
    else
      return raised;
  }
  template <class Bounds>
  static constexpr bool is_asked = !std::is_same_v<Bounds, NoBounds::Matrix>;

  /// What column j of a Jacobian lacks as a right-hand side; false where that is more than words bound.
  template <class Matrix, class By, class Drift>
  constexpr bool find_lack(By by, int j, const std::int32_t (&right)[size], const Drift& moves,
                           std::int32_t (&lacks)[size]) const {
    constexpr const auto& units = derivative_units<S, T>;
    constexpr const auto& sides = right_hand_sides<S, typename T::Word, By, EquationsOf<S, T>>;
    std::int32_t error[size] = {}, largest[size] = {};
    std::int64_t shifted[size] = {};
    bool bounded = moves.bounded;
    for (int i = 0; i < size; ++i) {
      const std::int32_t own = units.errors(by, j)[i];
      const std::int64_t all = std::int64_t{own} + moves.noise(own, sides.down[i][j]) + 1;
      const std::int64_t most = all + moves.spread(system.spread[i]);
      const bool fits = is_less_wide(most, MassInverse<size>::right_sides);
      bounded = bounded & fits;
      error[i] = static_cast<std::int32_t>(all & -static_cast<std::int64_t>(fits));
      largest[i] = static_cast<std::int32_t>(most & -static_cast<std::int64_t>(fits));
      bool held = true;
      const int finer = Matrix::exponent(i, j) - C::Requests::exponent(i) - sides.scale[j];
      const std::int64_t shift = moved_wide(moves.off(i, j), finer, held);
      shifted[i] = select_wide(held, shift, std::int64_t{1} << 60);
    }
    system.find_lack(right, largest, lacks);
    system.lower_lack(units.mass, right, error, moves.moved(), shifted, lacks);
    return bounded;
  }
  /// The word of an entry of row i, 0 where it is not known; whether it is.
  template <class Value>
  constexpr bool put(int i, Value& value, std::int64_t wide, bool fits, bool answered) {
    const bool held = fits & fits_word(wide), given = answered & held;
    spilt = first_found(spilt, answered & !held, i);
    value = {static_cast<std::int32_t>(wide & -static_cast<std::int64_t>(given))};
    return given;
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
