#include <host_sim/exhaustive/sweep.hpp>

#include <axial/scalar/integer.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>

namespace exhaustive {

void Finding::add(const double* errors, std::uint32_t count, std::uint32_t first, std::size_t part) {
  double most = 0.0, least = 0.0, all = 0.0, squares = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    most = std::max(most, errors[i]), least = std::min(least, errors[i]);
    all += errors[i], squares += errors[i] * errors[i];
  }
  const auto argument_of = [=](double error) {
    return first + std::uint32_t(std::find(errors, errors + count, error) - errors);
  };
  if (most > highest) highest = most, highest_at = argument_of(most);
  if (least < lowest) lowest = least, lowest_at = argument_of(least);
  upper[part] = std::max(upper[part], most), lower[part] = std::min(lower[part], least);
  sum += all, sum_of_squares += squares, arguments += count;
}

void Finding::add(const Finding& other) {
  if (other.highest > highest) highest = other.highest, highest_at = other.highest_at;
  if (other.lowest < lowest) lowest = other.lowest, lowest_at = other.lowest_at;
  for (std::size_t i = 0; i < upper.size(); ++i)
    upper[i] = std::max(upper[i], other.upper[i]), lower[i] = std::min(lower[i], other.lower[i]);
  sum += other.sum, sum_of_squares += other.sum_of_squares, arguments += other.arguments, broken += other.broken;
}

namespace {

constexpr std::uint32_t block = 4096;
constexpr std::size_t parts = 1024;

Finding finding(const char* subject, const char* unit, double bound) {
  Finding f{subject, unit, bound};
  f.upper.resize(parts), f.lower.resize(parts);
  return f;
}

/// Calls visit(findings, block's number) for every stride-th block, each thread with findings of its own.
template <class Visit>
std::vector<Finding> sweep(std::vector<Finding> findings, std::uint32_t blocks, unsigned threads, std::uint32_t stride,
                           const Report& report, Visit visit) {
  std::atomic<std::uint32_t> next{0};
  const std::uint32_t all = (blocks + stride - 1) / stride;
  std::vector<std::vector<Finding>> of_thread(threads, findings);
  const auto work = [&](unsigned thread) {
    for (std::uint32_t i = next++; i < all; i = next++) {
      visit(of_thread[thread], i * stride);
      if (thread == 0) report(i, all);
    }
  };
  std::vector<std::thread> others;
  for (unsigned thread = 1; thread < threads; ++thread)
    others.emplace_back(work, thread);
  work(0);
  for (auto& thread : others)
    thread.join();
  for (const auto& part : of_thread)
    for (std::size_t i = 0; i < findings.size(); ++i)
      findings[i].add(part[i]);
  return findings;
}

using Errors = std::array<double, block>;

struct Direction {
  long double sine, cosine;
};

Direction direction(std::uint64_t bam) {
  const long double angle = std::ldexp(6.28318530717958647692528676655900577L * static_cast<long double>(bam), -32);
  return {std::sin(angle), std::cos(angle)};
}

/// Directions of one block's angles, by adding its first angle to those of a table: an order faster than the library,
/// and as exact as long double to 2^-62.
const std::array<Direction, block>& offsets() {
  static const auto table = [] {
    std::array<Direction, block> all{};
    for (std::uint32_t i = 0; i < block; ++i)
      all[i] = direction(i);
    return all;
  }();
  return table;
}

void compare_with_mirrored(std::vector<Finding>& found, std::uint32_t first) {
  std::uint32_t odd = 0, even = 0;  // where they are not
  for (std::uint32_t bam = first; bam < first + block; ++bam) {
    const auto pair = axial::integer::sincos(bam), mirrored = axial::integer::sincos(0U - bam);
    odd += mirrored.sin != -pair.sin, even += mirrored.cos != pair.cos;
  }
  found[0].broken += odd, found[1].broken += even;
}

void visit_angles(std::vector<Finding>& found, std::uint32_t number) {
  const std::uint32_t first = number * block;
  const std::size_t part = number / ((1U << 20) / parts);
  const Direction base = direction(first);
  const auto& offset = offsets();
  Errors sines, cosines;
  for (std::uint32_t i = 0; i < block; ++i) {
    const auto pair = axial::integer::sincos(first + i);
    const long double sine = base.sine * offset[i].cosine + base.cosine * offset[i].sine;
    const long double cosine = base.cosine * offset[i].cosine - base.sine * offset[i].sine;
    sines[i] = static_cast<double>(pair.sin * 0x1p-30L - sine);
    cosines[i] = static_cast<double>(pair.cos * 0x1p-30L - cosine);
  }
  found[0].add(sines.data(), block, first, part);
  found[1].add(cosines.data(), block, first, part);
  if (first <= 1U << 31) compare_with_mirrored(found, first);  // each pair once
}

void visit_reciprocals(std::vector<Finding>& found, std::uint32_t number) {
  const std::size_t part = number / ((1U << 19) / parts);
  const std::uint32_t first = std::max(number * block, 1U), count = number * block + block - first;
  Errors errors;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t d = first + i;
    const auto r = axial::integer::reciprocal(static_cast<std::int32_t>(d));
    found[0].broken += !(r.mantissa >> 30 == 1 && r.exponent >= 31 && r.exponent <= 61);
    errors[i] = static_cast<double>(r.mantissa - static_cast<long double>(std::uint64_t{1} << (r.exponent & 63)) / d);
  }
  found[0].add(errors.data(), count, first, part);
}

}  // namespace

std::vector<Finding> sweep_angles(unsigned threads, std::uint32_t stride, const Report& report) {
  constexpr double bound = axial::integer::sincos_error;
  offsets();
  return sweep({finding("sine", "1", bound), finding("cosine", "1", bound)}, 1U << 20, threads, stride, report,
               visit_angles);
}

std::vector<Finding> sweep_reciprocals(unsigned threads, std::uint32_t stride, const Report& report) {
  return sweep({finding("reciprocal", "units of the mantissa", 1.0)}, 1U << 19, threads, stride, report,
               visit_reciprocals);
}

}  // namespace exhaustive
