// Products where the processor multiplies 32 by 32 bits into 32 only: four products of halves.
#pragma once
#include <axial/scalar/language.hpp>

#include <cstdint>

#include <axial/scalar/inline.hpp>

#include <axial/options/begin.hpp>

namespace axial::integer::detail {

AXIAL_INLINE constexpr std::uint32_t low_half(std::uint32_t a) { return a & 0xFFFFU; }
AXIAL_INLINE constexpr std::int32_t low_half(std::int32_t a) { return a & 0xFFFF; }

/// floor(a b / 2^32). No sum leaves the word, because (2^16 - 1)^2 + 2^16 - 1 < 2^32 and, with signs,
/// 2^15 (2^16 - 1) + 2^16 - 1 < 2^31. Word is std::int32_t or std::uint32_t.
template <class Word>
AXIAL_INLINE constexpr Word high_word_by_halves(Word a, Word b) {
  const Word al = low_half(a), bl = low_half(b), ah = a >> 16, bh = b >> 16;
  const std::uint32_t lowest = static_cast<std::uint32_t>(al) * static_cast<std::uint32_t>(bl);
  const Word first = al * bh + static_cast<Word>(lowest >> 16);
  const Word second = ah * bl + low_half(first);
  return ah * bh + (first >> 16) + (second >> 16);
}

AXIAL_INLINE constexpr std::uint64_t product_by_halves(std::int32_t a, std::int32_t b) {
  const std::uint32_t low = static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b);
  return (static_cast<std::uint64_t>(high_word_by_halves(a, b)) << 32) | low;
}

#ifdef __ARM_ARCH_6M__

/// Where the compiler does better than the statements below: on constants, or when a half is known to be zero. What is
/// known shows only after inlining, so __builtin_constant_p must not initialise a constant: that is evaluated at once.
AXIAL_INLINE constexpr bool has_known_zero_half(std::int32_t a) {
  return __builtin_constant_p(a) && ((a & 0xFFFF) == 0 || (a >> 16) == 0);
}
AXIAL_INLINE constexpr bool compiler_does_better(std::int32_t a, std::int32_t b) {
  return __builtin_is_constant_evaluated() || (__builtin_constant_p(a) && __builtin_constant_p(b)) ||
         has_known_zero_half(a) || has_known_zero_half(b);
}

// One statement per product: the compiler's own carries cost a third more, and in pieces it moves registers about.
// clang-format off
// Partial products of a and b: `lowest`, the mixed products t and u, and in b the highest.
#define AXIAL_QUARTERS(lowest) \
  ".syntax unified\n\t" \
  "uxth %[t], %[a]\n\t" \
  "uxth %[u], %[b]\n\t" \
  "asrs %[a], %[a], #16\n\t" \
  "asrs %[b], %[b], #16\n\t" \
  "movs " lowest ", %[t]\n\t" \
  "muls " lowest ", %[u], " lowest "\n\t" \
  "muls %[t], %[b], %[t]\n\t" \
  "muls %[u], %[a], %[u]\n\t" \
  "muls %[b], %[a], %[b]\n\t"
#define AXIAL_MIXED(add, carry, low, high, mixed, free) \
  "lsls " free ", " mixed ", #16\n\t" \
  "asrs " mixed ", " mixed ", #16\n\t" \
  add " " low ", " low ", " free "\n\t" \
  carry " " high ", " high ", " mixed "\n\t"
#define AXIAL_BOTH_MIXED "adds %[t], %[t], %[u]\n\t"  // narrow operands only
#define AXIAL_MULTIPLY(mixed) \
  std::uint32_t low, t, u; \
  asm(AXIAL_QUARTERS("%[low]") mixed \
      : [low] "=&l"(low), [a] "+l"(a), [b] "+l"(b), [t] "=&l"(t), [u] "=&l"(u) : : "cc"); \
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(b)) << 32) | low
#define AXIAL_ACCUMULATE(add, carry, mixed) \
  auto low = static_cast<std::uint32_t>(sum), high = static_cast<std::uint32_t>(sum >> 32); \
  std::uint32_t t, u, v; \
  asm(AXIAL_QUARTERS("%[v]") add " %[low], %[low], %[v]\n\t" carry " %[high], %[high], %[b]\n\t" mixed \
      : [low] "+l"(low), [high] "+l"(high), [a] "+l"(a), [b] "+l"(b), [t] "=&l"(t), [u] "=&l"(u), [v] "=&l"(v) \
      : : "cc"); \
  return (static_cast<std::uint64_t>(high) << 32) | low
#define AXIAL_HIGH_WORD(mixed) \
  std::uint32_t t, u, v; \
  asm(AXIAL_QUARTERS("%[v]") "lsrs %[v], %[v], #16\n\t" "adds %[t], %[t], %[v]\n\t" mixed \
      "asrs %[u], %[u], #16\n\t" "adds %[b], %[b], %[u]\n\t" \
      : [a] "+l"(a), [b] "+l"(b), [t] "=&l"(t), [u] "=&l"(u), [v] "=&l"(v) : : "cc"); \
  return b

#if !defined(AXIAL_MULTIPLY_BY_CALL) || AXIAL_MULTIPLY_BY_CALL == 0
/// a b. 17 instructions; narrow: 14.
template <bool narrow>
AXIAL_INLINE inline std::uint64_t product_by_assembler(std::int32_t a, std::int32_t b) {
  if constexpr (narrow) {
    AXIAL_MULTIPLY(AXIAL_BOTH_MIXED AXIAL_MIXED("adds", "adcs", "%[low]", "%[b]", "%[t]", "%[a]"));
  } else {
    AXIAL_MULTIPLY(AXIAL_MIXED("adds", "adcs", "%[low]", "%[b]", "%[t]", "%[a]")
                   AXIAL_MIXED("adds", "adcs", "%[low]", "%[b]", "%[u]", "%[a]"));
  }
}
/// sum + a b. 19 instructions; narrow: 16.
template <bool narrow>
AXIAL_INLINE inline std::uint64_t sum_by_assembler(std::uint64_t sum, std::int32_t a, std::int32_t b) {
  if constexpr (narrow) {
    AXIAL_ACCUMULATE("adds", "adcs", AXIAL_BOTH_MIXED AXIAL_MIXED("adds", "adcs", "%[low]", "%[high]", "%[t]", "%[v]"));
  } else {
    AXIAL_ACCUMULATE("adds", "adcs", AXIAL_MIXED("adds", "adcs", "%[low]", "%[high]", "%[t]", "%[v]")
                     AXIAL_MIXED("adds", "adcs", "%[low]", "%[high]", "%[u]", "%[v]"));
  }
}
/// sum - a b. 19 instructions; narrow: 16.
template <bool narrow>
AXIAL_INLINE inline std::uint64_t difference_by_assembler(std::uint64_t sum, std::int32_t a, std::int32_t b) {
  if constexpr (narrow) {
    AXIAL_ACCUMULATE("subs", "sbcs", AXIAL_BOTH_MIXED AXIAL_MIXED("subs", "sbcs", "%[low]", "%[high]", "%[t]", "%[v]"));
  } else {
    AXIAL_ACCUMULATE("subs", "sbcs", AXIAL_MIXED("subs", "sbcs", "%[low]", "%[high]", "%[t]", "%[v]")
                     AXIAL_MIXED("subs", "sbcs", "%[low]", "%[high]", "%[u]", "%[v]"));
  }
}
#endif
/// floor(a b / 2^32). 17 instructions; narrow: 14.
template <bool narrow>
AXIAL_INLINE inline std::int32_t high_word_by_assembler(std::int32_t a, std::int32_t b) {
  if constexpr (narrow) {
    AXIAL_HIGH_WORD("adds %[u], %[u], %[t]\n\t");
  } else {
    AXIAL_HIGH_WORD("uxth %[v], %[t]\n\t" "adds %[u], %[u], %[v]\n\t" "asrs %[t], %[t], #16\n\t" "adds %[b], %[b], %[t]\n\t");
  }
}
// clang-format on

#undef AXIAL_QUARTERS
#undef AXIAL_MIXED
#undef AXIAL_BOTH_MIXED
#undef AXIAL_MULTIPLY
#undef AXIAL_ACCUMULATE
#undef AXIAL_HIGH_WORD

#endif

}  // namespace axial::integer::detail

#include <axial/options/end.hpp>
