/// Integer primitives: this processor's bits are those that the compiler finds, which the host compares with the truth;
/// and their cost is the same for every argument.

#include <array>

#include <axial/fixed/words/integer.hpp>

#include "check.hpp"

namespace axial::apps {
namespace {

using hal::Board;
namespace I = axial::integer;

/// One operation: operands in, bits out.
struct Operands {
  std::int64_t sum;
  std::int32_t a, b;
};
using Bits = std::uint64_t;
constexpr Bits pair(std::uint32_t high, std::uint32_t low) { return (Bits{high} << 32) | low; }

struct Nothing {
  static constexpr const char* name = "nothing";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    return pair(static_cast<std::uint32_t>(x.a), static_cast<std::uint32_t>(x.b));
  }
};
struct Multiply {
  static constexpr const char* name = "multiply";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) { return static_cast<Bits>(I::multiply(x.a, x.b)); }
};
struct MultiplyHigh {
  static constexpr const char* name = "multiply_high";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    return pair(0, static_cast<std::uint32_t>(I::multiply_high(x.a, x.b)));
  }
};
struct MultiplyHighUnsigned {
  static constexpr const char* name = "multiply_high_unsigned";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    return pair(0, I::multiply_high_unsigned(static_cast<std::uint32_t>(x.a), static_cast<std::uint32_t>(x.b)));
  }
};
struct Accumulate {
  static constexpr const char* name = "accumulate";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) { return static_cast<Bits>(I::accumulate(x.sum, x.a, x.b)); }
};
struct Deduct {
  static constexpr const char* name = "deduct";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) { return static_cast<Bits>(I::deduct(x.sum, x.a, x.b)); }
};
/// Factors halved are narrow; -2^31 becomes 2^30 once and -2^30 once.
template <class General>
struct Narrow;
template <>
struct Narrow<Multiply> {
  static constexpr const char* name = "multiply_narrow";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    return static_cast<Bits>(I::multiply<I::Factors::narrow>(x.a >> 1, -(x.b >> 1)));
  }
};
template <>
struct Narrow<MultiplyHigh> {
  static constexpr const char* name = "multiply_high_narrow";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    return pair(0, static_cast<std::uint32_t>(I::multiply_high<I::Factors::narrow>(x.a >> 1, -(x.b >> 1))));
  }
};
template <>
struct Narrow<Accumulate> {
  static constexpr const char* name = "accumulate_narrow";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    return static_cast<Bits>(I::accumulate<I::Factors::narrow>(x.sum, x.a >> 1, -(x.b >> 1)));
  }
};
template <>
struct Narrow<Deduct> {
  static constexpr const char* name = "deduct_narrow";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    return static_cast<Bits>(I::deduct<I::Factors::narrow>(x.sum, x.a >> 1, -(x.b >> 1)));
  }
};
struct SineCosine {
  static constexpr const char* name = "sincos";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    const auto both = I::sincos(static_cast<std::uint32_t>(x.a));
    return pair(static_cast<std::uint32_t>(both.sin), static_cast<std::uint32_t>(both.cos));
  }
};
struct Reciprocal {
  static constexpr const char* name = "reciprocal";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    const std::int32_t positive = static_cast<std::int32_t>(static_cast<std::uint32_t>(x.a) >> 1) | 1;
    const auto r = I::reciprocal(positive);
    return pair(r.mantissa, static_cast<std::uint32_t>(r.exponent));
  }
};

/// Factors of which the compiler knows one, some with half of their bits zero: it chooses other instructions then.
template <std::int32_t factor>
struct Known {
  static constexpr const char* name = "known";
  AXIAL_INLINE static constexpr Bits of(const Operands& x) {
    const auto high = static_cast<std::uint32_t>(I::multiply_high(x.a, factor));
    return static_cast<Bits>(I::accumulate(x.sum, x.a, factor)) ^
           static_cast<Bits>(I::deduct(I::multiply(factor, x.b), factor, x.a)) ^ pair(high, 0);
  }
};

constexpr int corners = 22, samples = corners * corners + 300;

/// Corners of words and of halves by one another; then seeded words of every length (xorshift32, as in states.hpp).
constexpr auto make_operands() {
  constexpr std::int32_t corner[corners] = {
      0,          1,          -1,          2,           0x7FFF,      -0x7FFF,        0x8000,     -0x8000,
      0xFFFF,     -0xFFFF,    0x10000,     -0x10000,    0x10001,     0x3FFF8001,     0x40000000, -0x40000000,
      0x7FFF0000, 0x7FFFFFFF, -0x7FFFFFFF, -0x7FFF8000, -0x7FFF0001, -0x7FFFFFFF - 1};
  std::array<Operands, samples> all{};
  std::uint32_t random = 0x20240921;
  const auto next = [&random] {
    random ^= random << 13, random ^= random >> 17, random ^= random << 5;
    return random;
  };
  for (int i = 0; i < samples; ++i) {
    const auto high = static_cast<std::int32_t>(next());
    const bool is_corner = i < corners * corners;
    all[i] = {static_cast<std::int64_t>(pair(static_cast<std::uint32_t>(high), next())),
              is_corner ? corner[i / corners] : static_cast<std::int32_t>(next()) >> i % 31,
              is_corner ? corner[i % corners] : static_cast<std::int32_t>(next()) >> i % 29};
  }
  return all;
}

constexpr auto operands = make_operands();

/// All results in one word (Fowler, Noll, Vo 1991), because tables of them would not fit.
constexpr Bits first = 0xCBF29CE484222325;
constexpr Bits joined(Bits all, Bits next) { return (all ^ next) * 0x100000001B3; }

template <class Operation>
constexpr Bits expected() {
  Bits all = first;
  for (const auto& each : operands)
    all = joined(all, Operation::of(each));
  return all;
}

struct Call {
  Operands operands;
  Bits bits;
};

/// Not inlined, and its argument comes by an opaque pointer: nothing is computed ahead.
template <class Operation>
[[gnu::noinline]] void run(void* call) {
  auto& c = *static_cast<Call*>(call);
  c.bits = Operation::of(c.operands);
}

void print_count(const char* name, std::uint32_t count) {
  for (const char* text : {"count,", name, ","})
    Board::print(text);
  Board::print(hal::decimal(count).text);
  Board::print("\n");
}

template <class Operation>
void check_operation(Checks& check) {
  constexpr Bits right = expected<Operation>();
  Bits found = first;
  std::uint32_t least = ~0U, most = 0;
  for (const auto& each : operands) {
    Call call{each, 0};
    const std::uint32_t count = Board::Counter::count(run<Operation>, &call);
    least = count < least ? count : least, most = count > most ? count : most;
    found = joined(found, call.bits);
  }
  check.that(found == right, Operation::name);
  check.equal(most, least, "every argument costs the same");
  print_count(Operation::name, most);
}

template <std::int32_t... factor>
void check_known_factors(Checks& check) {
  (check_operation<Known<factor>>(check), ...);
}

}  // namespace

void check_integers(Checks& check) {
  check_operation<Nothing>(check);
  check_operation<Multiply>(check), check_operation<Narrow<Multiply>>(check);
  check_operation<MultiplyHigh>(check), check_operation<Narrow<MultiplyHigh>>(check);
  check_operation<MultiplyHighUnsigned>(check);
  check_operation<Accumulate>(check), check_operation<Narrow<Accumulate>>(check);
  check_operation<Deduct>(check), check_operation<Narrow<Deduct>>(check);
  check_operation<SineCosine>(check);
  check_operation<Reciprocal>(check);
  check_known_factors<0, 1, -1, 0x1234, -0x1234, 0x12340000, -0x12340000, 0x12345678, -0x7FFFFFFF - 1>(check);
}

}  // namespace axial::apps
