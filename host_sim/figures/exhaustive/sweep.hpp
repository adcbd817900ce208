// Errors of the integer primitives over all their arguments: sine and cosine within 2^-68, reciprocals to 53 bits.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace exhaustive {

constexpr std::uint32_t block = 4096;  // consecutive arguments that are compared at once
using Errors = std::array<double, block>;

/// What one result showed over a range of arguments. Errors are computed minus exact, in `unit`.
struct Finding {
  std::string subject, unit;
  double bound;                        // what the header promises
  double highest = 0.0, lowest = 0.0;  // most positive and most negative error
  std::uint32_t highest_at = 0, lowest_at = 0;
  double sum = 0.0, sum_of_squares = 0.0;
  std::uint64_t arguments = 0, broken = 0;  // broken: symmetry or normalisation that does not hold
  std::vector<double> upper{}, lower{};     // extremes of equal parts of the range

  /// Errors of `count` consecutive arguments, all of one part; 0 where there is none.
  void add(const Errors&, std::uint32_t count, std::uint32_t first, std::size_t part);
  void add(const Finding&);
  double worst() const { return highest > -lowest ? highest : -lowest; }
  std::uint32_t worst_at() const { return highest > -lowest ? highest_at : lowest_at; }
  bool holds() const { return worst() <= bound && broken == 0; }
};

using Report = std::function<void(std::size_t done, std::size_t all)>;

/// Sine and cosine of every `stride`-th block of 4096 of the 2^31 angles below half a turn, and of the blocks that
/// mirror them above; errors are absolute.
std::vector<Finding> sweep_angles(unsigned threads, std::uint32_t stride, const Report&);
/// Reciprocals of every `stride`-th block of 4096 of the 2^31 integers but 0; errors in units of the mantissa.
std::vector<Finding> sweep_reciprocals(unsigned threads, std::uint32_t stride, const Report&);

}  // namespace exhaustive
