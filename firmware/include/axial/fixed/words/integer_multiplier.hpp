// One number times many.
#pragma once
#include <axial/scalar/language.hpp>

#include <cstdint>

#include <axial/fixed/words/integer_product.hpp>
#include <axial/scalar/inline.hpp>

#include <axial/options/begin.hpp>

namespace axial::integer::detail {

#if AXIAL_LONG_MULTIPLY == 0 && defined(__ARM_ARCH_6M__)

/// floor((2^16 high + low) a / 2^32) without signs, 17 instructions. The mixed sum's carry is its borrow plus 1, which
/// takes a register less than adding a carry to zero.
AXIAL_INLINE inline std::uint32_t high_word_by_assembler(std::uint32_t low, std::uint32_t high, std::uint32_t a) {
  std::uint32_t t, u;
  asm(".syntax unified\n\t"
      "uxth %[t], %[a]\n\t"
      "lsrs %[a], %[a], #16\n\t"
      "movs %[u], %[t]\n\t"
      "muls %[u], %[low], %[u]\n\t"
      "lsrs %[u], %[u], #16\n\t"
      "muls %[t], %[high], %[t]\n\t"
      "adds %[t], %[t], %[u]\n\t"
      "movs %[u], %[a]\n\t"
      "muls %[u], %[low], %[u]\n\t"
      "muls %[a], %[high], %[a]\n\t"
      "adds %[t], %[t], %[u]\n\t"
      "sbcs %[u], %[u]\n\t"
      "adds %[u], %[u], #1\n\t"
      "lsls %[u], %[u], #16\n\t"
      "lsrs %[t], %[t], #16\n\t"
      "adds %[a], %[a], %[t]\n\t"
      "adds %[a], %[a], %[u]\n\t"
      : [a] "+l"(a), [t] "=&l"(t), [u] "=&l"(u)
      : [low] "l"(low), [high] "l"(high)
      : "cc");
  return a;
}

#endif

/// floor(a b / 2^32) for one a and many b: where there is no long multiplication, the halves of a are made once. Bits
/// is std::uint32_t, or a word that brings its own multiply_high_unsigned.
template <class Bits>
class Multiplier {
 public:
  AXIAL_INLINE explicit constexpr Multiplier(Bits a) : a_{a}, low_{a & 0xFFFFU}, high_{a >> 16} {}
  AXIAL_INLINE constexpr Bits high() const { return high_; }
  AXIAL_INLINE constexpr Bits operator*(Bits b) const {
#if AXIAL_LONG_MULTIPLY == 0 && defined(__ARM_ARCH_6M__)
    if (!__builtin_is_constant_evaluated()) return high_word_by_assembler(low_, high_, b);
#endif
    return multiply_high_unsigned(a_, b);
  }
  AXIAL_INLINE constexpr Bits square() const {
#if AXIAL_LONG_MULTIPLY
    return multiply_high_unsigned(a_, a_);
#else
    return high_ * high_ + ((high_ * low_ + ((low_ * low_) >> 17)) >> 15);
#endif
  }

 private:
  [[maybe_unused]] Bits a_, low_, high_;  // which of them depends on the processor
};

}  // namespace axial::integer::detail

#include <axial/options/end.hpp>
