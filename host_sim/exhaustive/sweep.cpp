#include <host_sim/exhaustive/sweep.hpp>

#include <axial/scalar/integer.hpp>

#include <oracle/scalar.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>

namespace exhaustive {

namespace {

/// Of equal errors the first argument's, whatever thread finds it.
void keep(double& extreme, std::uint32_t& at, double error, std::uint32_t argument) {
  at = error == extreme ? std::min(at, argument) : argument, extreme = error;
}

}  // namespace

void Finding::add(const Errors& errors, std::uint32_t count, std::uint32_t first, std::size_t part) {
  constexpr std::size_t lanes = 4;  // independent of each other, so that the processor need not wait for the last
  std::array<double, lanes> most{}, least{}, all{}, squares{};
  for (std::size_t i = 0; i < block; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const double error = errors[i + k];
      most[k] = std::max(most[k], error), least[k] = std::min(least[k], error);
      all[k] += error, squares[k] += error * error;
    }
  const double largest = *std::max_element(most.begin(), most.end());
  const double smallest = *std::min_element(least.begin(), least.end());
  const auto argument_of = [&](double error) {
    return first + std::uint32_t(std::find(errors.begin(), errors.end(), error) - errors.begin());
  };
  if (largest >= highest) keep(highest, highest_at, largest, argument_of(largest));
  if (smallest <= lowest) keep(lowest, lowest_at, smallest, argument_of(smallest));
  upper[part] = std::max(upper[part], largest), lower[part] = std::min(lower[part], smallest);
  sum += std::accumulate(all.begin(), all.end(), 0.0);
  sum_of_squares += std::accumulate(squares.begin(), squares.end(), 0.0), arguments += count;
}

void Finding::add(const Finding& other) {
  if (other.highest >= highest) keep(highest, highest_at, other.highest, other.highest_at);
  if (other.lowest <= lowest) keep(lowest, lowest_at, other.lowest, other.lowest_at);
  for (std::size_t i = 0; i < upper.size(); ++i)
    upper[i] = std::max(upper[i], other.upper[i]), lower[i] = std::min(lower[i], other.lower[i]);
  sum += other.sum, sum_of_squares += other.sum_of_squares, arguments += other.arguments, broken += other.broken;
}

namespace {

using oracle::quad;
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

quad radians(std::uint32_t bam) { return oracle::right_angle<quad>() * static_cast<quad>(bam) * 0x1p-30; }

/// Exact sine or cosine of a block's first angle: units of the last bit, and what they leave.
struct Start {
  double units, rest, value;
  explicit Start(quad exact)
      : units{std::nearbyint(static_cast<double>(exact) * 0x1p30)},
        rest{static_cast<double>(exact - static_cast<quad>(units) * 0x1p-30)},
        value{static_cast<double>(exact)} {}
};

/// Of the angles by which a block's others are ahead of its first one: sine, and 1 - cosine.
struct Offsets {
  Errors sine, versine;
  Offsets() {
    for (std::uint32_t i = 0; i < block; ++i) {
      const quad half = oracle::sin(radians(i) / 2);
      sine[i] = static_cast<double>(oracle::sin(radians(i))), versine[i] = static_cast<double>(2 * half * half);
    }
  }
};

using Results = std::array<std::int32_t, block>;

/// Sine and cosine of a block.
struct Pairs {
  std::uint32_t first;
  Results sines, cosines;
  explicit Pairs(std::uint32_t number) : first{number * block} {
    for (std::uint32_t i = 0; i < block; ++i) {
      const auto pair = axial::integer::sincos(first + i);
      sines[i] = pair.sin, cosines[i] = pair.cos;
    }
  }
};

/// Errors against f(a + b) = f(a) + f'(a) sin b - f(a) (1 - cos b), for f = sin, f' = cos or f = cos, f' = -sin. What
/// is added to f(a) is below 2^-17.3 and comes of five roundings to 53 bits, so it errs by less than 2^-68; f(a) is
/// exact in its units, and to 2^-84 in their rest.
void compare(Finding& found, const Results& results, const Start& f, double slope, std::uint32_t number) {
  static const Offsets offsets;
  Errors errors;
  for (std::uint32_t i = 0; i < block; ++i) {
    const double ahead = slope * offsets.sine[i] - f.value * offsets.versine[i];
    errors[i] = (results[i] - f.units) * 0x1p-30 - (f.rest + ahead);
  }
  found.add(errors, block, number * block, number / ((1U << 20) / parts));
}

void compare_with_exact(std::vector<Finding>& found, const Pairs& pairs, std::uint32_t number) {
  const Start sine(oracle::sin(radians(pairs.first))), cosine(oracle::cos(radians(pairs.first)));
  compare(found[0], pairs.sines, sine, cosine.value, number);
  compare(found[1], pairs.cosines, cosine, -sine.value, number);
}

/// Whether sin(-x) = -sin(x), cos(-x) = cos(x) holds in a block and in the one that mirrors all its angles but the
/// first.
void compare_with_mirrored(std::vector<Finding>& found, const Pairs& pairs, const Pairs& mirrored) {
  std::uint32_t odd = 0, even = 0;  // where they are not
  for (std::uint32_t i = 1; i < block; ++i)
    odd += mirrored.sines[block - i] != -pairs.sines[i], even += mirrored.cosines[block - i] != pairs.cosines[i];
  for (const Pairs* each : {&pairs, &mirrored}) {
    const auto minus_first = axial::integer::sincos(0U - each->first);
    odd += minus_first.sin != -each->sines[0], even += minus_first.cos != each->cosines[0];
  }
  found[0].broken += odd, found[1].broken += even;
}

void visit_angles(std::vector<Finding>& found, std::uint32_t number) {
  const std::uint32_t mirror = (1U << 20) - 1 - number;
  const Pairs pairs(number), mirrored(mirror);
  compare_with_exact(found, pairs, number);
  compare_with_exact(found, mirrored, mirror);
  compare_with_mirrored(found, pairs, mirrored);
}

/// The error of a mantissa m is (m d - 2^exponent) / d, whose dividend is exact; nothing errs at 0.
void visit_reciprocals(std::vector<Finding>& found, std::uint32_t number) {
  const std::uint32_t first = number * block, missing = first == 0;
  std::uint32_t broken = 0;
  Errors errors{};
  for (std::uint32_t i = missing; i < block; ++i) {
    const std::uint32_t d = first + i;
    const auto r = axial::integer::reciprocal(static_cast<std::int32_t>(d));
    broken += !(r.mantissa >> 30 == 1 && r.exponent >= 31 && r.exponent <= 61);
    const auto excess =
        static_cast<std::int64_t>(std::uint64_t{r.mantissa} * d - (std::uint64_t{1} << (r.exponent & 63)));
    errors[i] = static_cast<double>(excess) / d;
  }
  found[0].broken += broken;
  found[0].add(errors, block - missing, first, number / ((1U << 19) / parts));
}

}  // namespace

std::vector<Finding> sweep_angles(unsigned threads, std::uint32_t stride, const Report& report) {
  constexpr double bound = axial::integer::sincos_error;
  return sweep({finding("sine", "1", bound), finding("cosine", "1", bound)}, 1U << 19, threads, stride, report,
               visit_angles);
}

std::vector<Finding> sweep_reciprocals(unsigned threads, std::uint32_t stride, const Report& report) {
  return sweep({finding("reciprocal", "units of the mantissa", 1.0)}, 1U << 19, threads, stride, report,
               visit_reciprocals);
}

}  // namespace exhaustive
