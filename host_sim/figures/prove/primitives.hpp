// The integer primitives: sine and cosine of an arc of angles, reciprocals of a range of integers.
#pragma once

#include <host_sim/figures/prove/script.hpp>

#include <cstdint>
#include <vector>

namespace prove {

/// How far minimax polynomials are from sine and cosine: proved by Coq's Interval (approximation.v).
inline constexpr double sine_approximation = 1.7e-12, cosine_approximation = 5.4e-11;

/// What is proved of sine and cosine, and what the arms build on. All arguments were run as well: they find 6.3e-10
/// (integer::sincos_error), which is the roundings' worst meeting, and no interval knows that they do not meet worse.
inline constexpr double sine_bound = 7.5e-10;

/// Binary angles first..last between neighbouring multiples of an eighth of a turn, or one such multiple.
struct Arc {
  std::uint32_t first = 0, last = 0;
};
/// All of one turn.
std::vector<Arc> arcs();

enum class Wave { sine, cosine };
/// The words that integer::sincos makes of an arc's angles, against sine or cosine.
Statement wave_statement(Wave wave, const Arc& arc);

/// One unit of a reciprocal's mantissa, as integer::reciprocal promises.
inline constexpr double reciprocal_bound = 0x1p-30;

/// Integers of 31 bits: 2^30, where the mantissa does not hold what it should, and the others, those apart that need
/// more pieces. Shorter integers are shifted up first: the rest of the program is the same.
std::vector<Arc> mantissas();
/// The mantissa that integer::reciprocal makes of integers of one length, against 1 / d, 1/2 <= d < 1.
Statement reciprocal_statement(const Arc& range);

}  // namespace prove
