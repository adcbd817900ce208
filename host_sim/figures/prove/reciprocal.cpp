#include <host_sim/figures/prove/primitives.hpp>
#include <host_sim/figures/prove/recorded.hpp>

#include <axial/fixed/words/integer_reciprocal.hpp>

namespace prove {
namespace {

/// The kernel's polynomial before its roundings, by Horner's rule: near 1 / x for 1/2 <= x <= 1.
Real near_reciprocal(const Real& x) {
  const auto c = [](double raw) { return Real::constant(raw / 4096.0); };
  return c(23170.0) - x * (c(48158.0) - x * (c(43614.0) - x * c(14538.0)));
}
/// x near_reciprocal(x) - 1: Chebyshev's T4(u), which stays within 1, and what the coefficients' last bits leave.
Real excess(const Real& x) {
  const auto c = [](double raw) { return Real::constant(raw * 0x1p-22); };
  const Real u = Real::constant(4.0) * x - Real::constant(3.0),
             t2 = Real::constant(2.0) * (u * u) - Real::constant(1.0);
  const Real t4 = Real::constant(2.0) * (t2 * t2) - Real::constant(1.0);
  return c(-547.0) - c(7269.0) * t4 - u * (c(320.0) + c(56.0) * u);
}

constexpr std::uint32_t least = 1U << 30, last_pieces = 0x7FC00000;

}  // namespace

std::vector<Arc> mantissas() { return {{least, least}, {least + 1, last_pieces - 1}, {last_pieces, 2 * least - 1}}; }

Statement reciprocal_statement(const Arc& range) {
  Statement s;
  Program::activate(&s.program);
  Formula::activate(&s.formula);
  const auto here = static_cast<std::int32_t>(range.first);
  const int input = s.program.input("d", here, range.first, range.last);
  s.known[input] = 32 - __builtin_clz(range.first);
  const int result = axial::integer::detail::reciprocal_words<Uint32>(Int32{here, input}).mantissa.settled();
  s.known[result] = 30;
  s.likeness = 1e-3L;  // of the polynomial's words
  const Real d = Real::variable("d"), exact = Real::constant(1.0) / d;
  s.reciprocal = {exact.term(), d.term(), near_reciprocal(d).term(), excess(d).term()};
  s.results.push_back({"mantissa", result, exact.term(), reciprocal_bound});
  if (range.first != range.last) s.split = "d";
  return s;
}

}  // namespace prove
