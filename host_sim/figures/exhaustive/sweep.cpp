#include <host_sim/figures/exhaustive/sweep.hpp>

#include <axial/fixed/words/integer.hpp>

#include <oracle/scalar.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>

// What runs for every argument, for wider registers too where the processor has them: the same results, sooner. Not
// under sanitizers, which are not there yet when the choice is made.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define EXHAUSTIVE_WIDE [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define EXHAUSTIVE_WIDE
#endif

namespace exhaustive {

namespace {

/// Of equal errors the first argument's, whatever thread finds it.
void keep(double& extreme, std::uint32_t& at, double error, std::uint32_t argument) {
  at = error == extreme ? std::min(at, argument) : argument, extreme = error;
}

/// Of a block's errors.
struct Summary {
  double largest = 0.0, smallest = 0.0, sum = 0.0, squares = 0.0;
};

EXHAUSTIVE_WIDE Summary summary(const Errors& errors) {
  constexpr std::size_t lanes = 16;  // independent of each other, so that the processor need not wait for the last
  std::array<double, lanes> most{}, least{}, all{}, squares{};
  for (std::size_t i = 0; i < block; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const double error = errors[i + k];
      most[k] = most[k] > error ? most[k] : error, least[k] = least[k] < error ? least[k] : error;
      all[k] += error, squares[k] += error * error;
    }
  return {*std::max_element(most.begin(), most.end()), *std::min_element(least.begin(), least.end()),
          std::accumulate(all.begin(), all.end(), 0.0), std::accumulate(squares.begin(), squares.end(), 0.0)};
}

}  // namespace

void Finding::add(const Errors& errors, std::uint32_t count, std::uint32_t first, std::size_t part) {
  const Summary of = summary(errors);
  const auto argument_of = [&](double error) {
    return first + std::uint32_t(std::find(errors.begin(), errors.end(), error) - errors.begin());
  };
  if (of.largest >= highest) keep(highest, highest_at, of.largest, argument_of(of.largest));
  if (of.smallest <= lowest) keep(lowest, lowest_at, of.smallest, argument_of(of.smallest));
  upper[part] = std::max(upper[part], of.largest), lower[part] = std::min(lower[part], of.smallest);
  sum += of.sum, sum_of_squares += of.squares, arguments += count;
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

EXHAUSTIVE_WIDE void compute_pairs(std::uint32_t first, Results& sines, Results& cosines) {
  for (std::uint32_t i = 0; i < block; ++i) {
    const auto pair = axial::integer::sincos(first + i);
    sines[i] = pair.sin, cosines[i] = pair.cos;
  }
}

/// Sine and cosine of a block.
struct Pairs {
  std::uint32_t first;
  Results sines, cosines;
  explicit Pairs(std::uint32_t number) : first{number * block} { compute_pairs(first, sines, cosines); }
};

/// Errors against f(a + b) = f(a) + f'(a) sin b - f(a) (1 - cos b), for f = sin, f' = cos or f = cos, f' = -sin. What
/// is added to f(a) is below 2^-17.3 and comes of five roundings to 53 bits, so it errs by less than 2^-68; f(a) is
/// exact in its units, and to 2^-84 in their rest.
EXHAUSTIVE_WIDE void compare(Errors& errors, const Results& results, const Start& f, double slope,
                             const Offsets& offsets) {
  for (std::uint32_t i = 0; i < block; ++i) {
    const double ahead = slope * offsets.sine[i] - f.value * offsets.versine[i];
    errors[i] = (results[i] - f.units) * 0x1p-30 - (f.rest + ahead);
  }
}

void compare(Finding& found, const Results& results, const Start& f, double slope, std::uint32_t number) {
  static const Offsets offsets;
  Errors errors;
  compare(errors, results, f, slope, offsets);
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

/// The error of a mantissa m is (m d - 2^exponent) / d, whose dividend is exact; nothing errs at 0. Returns how many
/// are not normalised.
EXHAUSTIVE_WIDE std::uint32_t compare(Errors& errors, std::uint32_t first) {
  std::uint32_t broken = 0;
  for (std::uint32_t i = 0; i < block; ++i) {
    const std::uint32_t d = first + i + (first + i == 0);
    const auto r = axial::integer::reciprocal(static_cast<std::int32_t>(d));
    broken += r.mantissa >> 30 != 1 || r.exponent < 31 || r.exponent > 61;
    const auto excess =
        static_cast<std::int64_t>(std::uint64_t{r.mantissa} * d - (std::uint64_t{1} << (r.exponent & 63)));
    errors[i] = static_cast<double>(excess) / d;
  }
  return broken;
}

void visit_reciprocals(std::vector<Finding>& found, std::uint32_t number) {
  const std::uint32_t first = number * block, missing = first == 0;
  Errors errors;
  found[0].broken += compare(errors, first);
  if (missing) errors[0] = 0.0;
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
