// The certificate of forward dynamics of joints that share drives: what M of the drives in words, of proved error,
// makes of the answer and of an approximate inverse.
#pragma once

#include <axial/fixed/dynamics/driven_forward_dynamics.hpp>
#include <axial/fixed/dynamics/enclosure.hpp>
#include <axial/fixed/limits/state_check.hpp>
#include <axial/fixed/transmissions/driven_forward_error.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// What of a certificate no state changes: unknowns in words of answers, each equation in a unit in which entries of
/// M^-1 are below 1 as far as mobilities tell.
template <class S, class T>
struct DrivenEquations {
  using Units = DriveUnits<S, typename T::Word>;
  using Sizes = DriveSizes<S, typename T::Word>;
  static constexpr int size = Units::size;

  int unit[size] = {};                                  ///< exponent of each equation
  int column_shift[size] = {}, widest = 0;              ///< of solutions to words of answers
  int drive_shift[size] = {};                           ///< of right-hand sides to equations
  int product[size][size] = {};                         ///< of words of M times words of answers to equations
  std::int32_t bias[size] = {}, mass[size][size] = {};  ///< errors: of the bias in equations, of M in its words
  std::int64_t tight[size] = {};                        ///< a bound that is of use

  static constexpr DrivenEquations made() {
    constexpr const auto& u = drive_units<S, typename T::Word>;
    const auto errors = DriveErrors<S, T>::entries();
    const auto efforts = DriveErrors<S, T>::efforts(0.0);
    DrivenEquations c;
    for (int k = 0; k < size; ++k) {
      const int own = Units::Answers::exponent(k);
      c.unit[k] = smaller(u.residual[k], own + binary_exponent(Sizes::mobility(k) * Sizes::mobility(k)) + 1);
      c.column_shift[k] = own - (Units::bits - u.gain_bits[k] + u.scale[k]);
      c.widest = k == 0 || c.column_shift[k] > c.widest ? c.column_shift[k] : c.widest;
      c.drive_shift[k] = c.unit[k] - (Units::bits - u.scale[k]);
      c.bias[k] = rounded_up(efforts[k] * power_of_two(c.unit[k]));
      c.tight[k] = static_cast<std::int64_t>(Sizes::drive(k).acceleration_limit * power_of_two(own) / 128.0);
    }
    for (int k = 0; k < size; ++k)
      for (int l = 0; l < size; ++l) {
        const int exponent = MassMatrixOf<S, T>::exponent(k, l);
        c.product[k][l] = smaller(exponent + Units::Answers::exponent(l) - c.unit[k], 63);
        c.mass[k][l] = rounded_up((k > l ? errors[k][l] : errors[l][k]) * power_of_two(exponent));
      }
    return c;
  }
};
template <class S, class T>
inline constexpr auto driven_equations = DrivenEquations<S, T>::made();

/// Forward dynamics of drives with its certificate.
template <class S, class T>
class DrivenCertificate {
  using Word = typename T::Word;
  using Units = DriveUnits<S, Word>;
  using Solve = DriveSolve<S, Word>;
  static constexpr int size = Units::size;
  static constexpr const auto& c = driven_equations<S, T>;
  static constexpr const auto& u = drive_units<S, Word>;

 public:
  template <class Q, class V, class Tau, class Input>
  AXIAL_INLINE static constexpr CertifiedDynamics<S, T> answer(const Q& q, const V& qd, const Tau& tau,
                                                               const Input& in) {
    static_assert((check_driven_solve<S, Word>(), true));
    CertifiedDynamics<S, T> result{};
    const StateCheck<S, T> check(in, q, qd);
    const DrivenSystem<S, Word> given(in, q, qd, tau);
    const Solve solve(given.m);
    std::int32_t x[size] = {};
    int spilt = -1;
    solve.accelerations(given.left, x, spilt);
    result.status = driven_status<S, Word>(x, solve.lost(), spilt);
    for (int k = 0; k < size; ++k)
      result.values[k] = {x[k]};
    check.judge(result);

    Enclosure<size> system;
    for (int j = 0; j < size; ++j)
      set_inverse(system, given, solve, j);
    set_residual(system, given, solve, x);
    const bool answered = is_answer(result.status.code), known = system.enclose() & answered;
    const bool tight = publish_in_words<size>(
        result, system, c.tight, known, [&x](int k) AXIAL_INLINE { return x[k]; }, [](int) AXIAL_INLINE { return 0; });
    result.status = certified_status(result.status, true, tight);
    return result;
  }

 private:
  /// How far words of M can be off, in a row of it times a vector; every product is rounded down.
  AXIAL_INLINE static constexpr std::int64_t spread(int i, int k, std::int32_t x) {
    return wide_shifted_by(integer::multiply(c.mass[i][k], word_magnitude(x)), c.product[i][k]) + 2;
  }
  template <class System, class Given>
  AXIAL_INLINE static constexpr void set_inverse(System& system, const Given& given, const Solve& solve, int j) {
    std::int32_t column[size] = {};
    const int drive = Units::bits - u.norm_bits[j];
    column[j] = std::int32_t{1} << drive;
    solve.solve(column);
    set_shifted_column<size>(c, system, j, column, drive);
    std::int64_t made[size] = {};
    std::int32_t error[size] = {};
    constexpr std::int64_t most = std::int64_t{1} << 30;
    for (int i = 0; i < size; ++i) {
      std::int64_t off = 0;
      for (int k = 0; k < size; ++k) {
        made[i] += wide_shifted_by(integer::multiply(given.m(i, k).raw, system.inverse[k][j]), c.product[i][k]);
        off += spread(i, k, system.inverse[k][j]);
      }
      const bool fits = is_less_wide(off, most);
      system.proved = system.proved & fits;
      error[i] = static_cast<std::int32_t>(off & -static_cast<std::int64_t>(fits));
    }
    system.set_defects(j, made, error);
  }
  template <class System, class Given>
  AXIAL_INLINE static constexpr void set_residual(System& system, const Given& given, const Solve& solve,
                                                  const std::int32_t (&x)[size]) {
    std::int64_t r[size] = {};
    solve.residual(given.left, x, r);
    for (int k = 0; k < size; ++k) {
      system.residual[k] = wide_shifted_by(r[k], u.residual[k] - c.unit[k]);
      system.residual_error[k] = c.bias[k] + size + 1;
      for (int l = 0; l < size; ++l)
        system.residual_error[k] += spread(k, l, x[l]);
    }
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
