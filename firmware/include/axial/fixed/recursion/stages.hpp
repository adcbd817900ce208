// Stages of kernels in fixed point: functions of their own where registers are few.
#pragma once

#include <axial/fixed/words/arithmetic.hpp>
#include <axial/fixed/words/integer_product.hpp>
#include <axial/recursion/stages.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Whether the processor puts products together from halves, and has eight registers for them.
inline constexpr bool has_few_registers = AXIAL_LONG_MULTIPLY == 0;

/// Solves that are repeated find what they share in registers, or with few of those on the stack: 4.7 kB of seven
/// joints, where stage by stage it is less than 1 kB at a time, in less code. A single solve of a smaller arm gains by
/// what it knows of the other stages.
template <class Word, bool nearest, bool high, bool checked>
struct StagesOver<Arithmetic<Word, nearest, high, checked>> {
  template <class Links>
  static constexpr bool apart = has_few_registers &&
                                (Links::halvings() > 0 || Links::second_solve());  ///< as in recursion/stages.hpp
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
