// The units in which M of drives that joints share, or of joints, is solved in words, by what bounds its inverse.
#pragma once

#include <axial/dynamics/mass_matrix.hpp>
#include <axial/fixed/formats/drive_formats.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// What of M udd = left in words no state changes. A drive is a joint where joints share none. M'(k, l) = M(k, l) /
/// 2^(scale[k] + scale[l]) is at most 1, in words of 30 bits behind the point; 1 <= mobility' = mobility 2^scale bounds
/// what its elimination makes: pivots are at least 1 / mobility'^2, gains at most mobility', and for a vector w with
/// sum mobility' |w| <= 1 no component passes 1 on the way in, and mobility'[k] on the way out. (w^T M'^-1 w is at most
/// the square of that sum, and what is left of w[k] has a share of it, over its pivot.)
/// `Formats` are those of accelerations.
template <class S, class Word, class Formats = FreeAccelerations<subject_of<S, Stored<Word>>, Stored<Word>>>
struct DriveUnits {
  using T = Stored<Word>;
  using Sizes = SizesOf<S, Word>;
  using Answers = Formats;
  static constexpr int size = joint_count<S>, bits = 30;
  static constexpr int most_gain_bits = 18;  ///< of which gains leave words enough behind the point
  static constexpr int solves = 3;           ///< each leaves what words lose of the one before

  int scale[size] = {};           ///< M(k, k) <= 4^scale
  double mobility[size] = {};     ///< of the scaled matrix
  int gain_bits[size] = {};       ///< gains and scaled accelerations of drive k are below 2^gain_bits
  int norm_bits[size] = {};       ///< size mobility' <= 2^norm_bits
  std::int32_t least[size] = {};  ///< half of the least pivot
  int down[size][size] = {};      ///< shift of M's words to those of M'
  int residual[size] = {};        ///< exponent of tau - bias - M udd
  int product[size][size] = {};   ///< shift of products of words of M and of accelerations to it
  int given[size] = {};           ///< shift of tau - bias to it
  bool resisted = true;           ///< whether all of this is known

  static constexpr DriveUnits chosen() {
    DriveUnits u;
    for (int k = 0; k < size; ++k)
      u.resist(k);
    for (int k = 0; k < size && u.resisted; ++k)
      u.set_residual(k);
    return u;
  }

 private:
  constexpr void resist(int k) {
    constexpr double room = 1.0 + 1.0 / 4096.0;
    const double inertia = room * Sizes::inertia(k);
    scale[k] = -100;
    while (power_of_two(2 * scale[k]) < inertia)
      ++scale[k];
    mobility[k] = Sizes::mobility(k) * power_of_two(scale[k]);
    resisted = resisted && mobility[k] < power_of_two(most_gain_bits - 1);
    if (!resisted) return;
    gain_bits[k] = bits_up_to(2.0 * mobility[k]), norm_bits[k] = bits_up_to(size * mobility[k]);
    const double half = power_of_two(bits - 1) / (mobility[k] * mobility[k]);
    least[k] = half > 1.0 ? static_cast<std::int32_t>(half) : 1;
  }
  // As fine as a sum of products, of which each leaves room for sixteen, and tau - bias have bits for.
  constexpr void set_residual(int k) {
    constexpr int finest = 24, terms = 4;
    const int own = EffortsOf<S, T>::exponent(k);
    residual[k] = own + finest;
    for (int l = 0; l < size; ++l) {
      const int exponent = MassMatrixOf<S, T>::exponent(k, l);
      down[k][l] = smaller(exponent + scale[k] + scale[l] - bits, 31);
      residual[k] = smaller(residual[k], exponent + Answers::exponent(l) - terms);
    }
    for (int l = 0; l < size; ++l)
      product[k][l] = smaller(MassMatrixOf<S, T>::exponent(k, l) + Answers::exponent(l) - residual[k], 63);
    given[k] = residual[k] - own;
  }
};
template <class S, class Word, class Units = DriveUnits<S, Word>>
inline constexpr auto drive_units = Units::chosen();

}  // namespace axial::detail

#include <axial/options/end.hpp>
