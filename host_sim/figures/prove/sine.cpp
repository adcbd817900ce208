#include <host_sim/figures/prove/primitives.hpp>
#include <host_sim/figures/prove/recorded.hpp>

#include <axial/fixed/words/integer_sincos.hpp>

#include <cmath>

namespace prove {
namespace {

constexpr std::int64_t eighth = std::int64_t{1} << 29;

/// c0 - t (c1 - t (c2 - ...)), as the kernel nests it.
Real nested(const Real& t, const std::vector<double>& c) {
  Real sum = Real::constant(c.back());
  for (std::size_t i = c.size() - 1; i-- > 0;)
    sum = Real::constant(c[i]) - t * sum;
  return sum;
}

/// Minimax polynomials of sine and cosine of w eighths of a turn, 0 <= w <= 1, by Remez' exchange in 40 digits. The
/// kernel's coefficients are these to some last bits, which centre its roundings.
Real near_sine(const Real& w) {
  return w * nested(w * w, {0.785398163378806052, 0.080745511815160135, 0.00249039247884497959,
                            0.0000365714176659238459, 3.08563416692922074e-7});
}
Real near_cosine(const Real& w) {
  return Real::constant(1.0) - (w * w) * nested(w * w, {0.308425135838371722, 0.015854327751876864,
                                                        0.000325942007949781913, 3.53133465543485538e-6});
}

}  // namespace

std::vector<Arc> arcs() {
  std::vector<Arc> all;
  for (std::int64_t k = 0; k < 8; k += 2) {
    const auto at = [&](std::int64_t offset) { return static_cast<std::uint32_t>(k * eighth + offset); };
    all.push_back({at(0), at(eighth - 1)});
    all.push_back({at(eighth), at(eighth)});
    all.push_back({at(eighth + 1), at(2 * eighth - 1)});
  }
  return all;
}

Statement wave_statement(Wave wave, const Arc& arc) {
  Statement s;
  Program::activate(&s.program);
  Formula::activate(&s.formula);
  const std::uint32_t here = arc.first + (arc.last - arc.first) / 3;
  const int input = s.program.input("bam", here, arc.first, arc.last);
  s.known[input] = 29;
  const auto pair = axial::integer::detail::sincos_words<Int32>(Uint32{here, input});
  const int result = (wave == Wave::sine ? pair.sin : pair.cos).settled();
  s.known[result] = 30;
  s.likeness = 1e-2L;  // the last coefficients of sine have a few bits

  const bool ahead = arc.first % (2 * eighth) > eighth;  // where the nearest quarter turn lies
  const std::uint32_t nearest = (arc.first >> 30) + (ahead ? 1 : 0);
  const Real angle = Real::variable("bam"), turn = Real::constant(2.0 * nearest);
  const Real w = ahead ? turn - angle : angle - turn;
  const bool sine = (wave == Wave::sine) == (nearest % 2 == 0);
  const Real near = sine ? near_sine(w) : near_cosine(w);
  const double turns = static_cast<double>(here) * 0x1p-32 * 2.0 * 3.14159265358979323846;
  const double exact = wave == Wave::sine ? std::sin(turns) : std::cos(turns);
  const bool negative = exact < 0.0;
  const std::string name = sine ? "SINE" : "COSINE";
  s.variables.push_back({name, std::abs(exact), {}, near.term(), sine ? sine_approximation : cosine_approximation});
  const Real value = Real::variable(name);
  s.results.push_back({wave == Wave::sine ? "sine" : "cosine", result, (negative ? -value : value).term(), sine_bound});
  if (arc.first != arc.last) s.split = "bam";
  return s;
}

}  // namespace prove
