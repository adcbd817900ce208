// Products on a Cortex-M0 by a call each, for parts with little flash: 4 bytes per product instead of 34 to 38, and 4
// instructions more. AXIAL_MULTIPLY_BY_CALL chooses them.
#pragma once
#include <axial/scalar/language.hpp>

#include <cstdint>

#include <axial/scalar/inline.hpp>

#include <axial/options/begin.hpp>

namespace axial::integer::detail {

/// Defines a product as a procedure. Arguments and results lie where the procedure call standard has them, but of the
/// registers that it gives away only
// those of the factors change: what surrounds a product stays in its registers.
// clang-format off
#define AXIAL_BY_CALL(name, add, carry) \
  [[gnu::naked, gnu::noinline]] inline void name() { \
    asm(".syntax unified\n\t" \
        "push {r4, r5, r6, lr}\n\t" \
        "uxth r4, r2\n\t" \
        "uxth r5, r3\n\t" \
        "asrs r2, r2, #16\n\t" \
        "asrs r3, r3, #16\n\t" \
        "movs r6, r4\n\t" \
        "muls r6, r5, r6\n\t" \
        "muls r4, r3, r4\n\t" \
        "muls r5, r2, r5\n\t" \
        "muls r3, r2, r3\n\t" \
        add " r0, r0, r6\n\t" \
        carry " r1, r1, r3\n\t" \
        "lsls r6, r4, #16\n\t" \
        "asrs r4, r4, #16\n\t" \
        add " r0, r0, r6\n\t" \
        carry " r1, r1, r4\n\t" \
        "lsls r6, r5, #16\n\t" \
        "asrs r5, r5, #16\n\t" \
        add " r0, r0, r6\n\t" \
        carry " r1, r1, r5\n\t" \
        "pop {r4, r5, r6, pc}"); \
  }
AXIAL_BY_CALL(add_product, "adds", "adcs")
AXIAL_BY_CALL(subtract_product, "subs", "sbcs")
#undef AXIAL_BY_CALL
// clang-format on

template <void routine()>
AXIAL_INLINE inline std::uint64_t call(std::uint64_t sum, std::int32_t a, std::int32_t b) {
  register std::uint64_t result asm("r0") = sum;
  register std::int32_t first asm("r2") = a, second asm("r3") = b;
  asm("bl %c[routine]" : "+l"(result), "+l"(first), "+l"(second) : [routine] "i"(routine) : "lr", "cc");
  return result;
}

/// a b, sum + a b and sum - a b. 4 instructions more than in place.
///@{
template <bool narrow>
AXIAL_INLINE inline std::uint64_t product_by_assembler(std::int32_t a, std::int32_t b) {
  return call<add_product>(0, a, b);
}
template <bool narrow>
AXIAL_INLINE inline std::uint64_t sum_by_assembler(std::uint64_t sum, std::int32_t a, std::int32_t b) {
  return call<add_product>(sum, a, b);
}
template <bool narrow>
AXIAL_INLINE inline std::uint64_t difference_by_assembler(std::uint64_t sum, std::int32_t a, std::int32_t b) {
  return call<subtract_product>(sum, a, b);
}
///@}

}  // namespace axial::integer::detail

#include <axial/options/end.hpp>
