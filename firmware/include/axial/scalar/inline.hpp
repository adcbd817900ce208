// How the kernels reach the code that hand-written scalars would give.
#pragma once
#include <axial/scalar/language.hpp>

/// Marks every step of a kernel. GCC keeps an aggregate in registers only if each function that touches it is inlined
/// before its scalars are replaced, and if the aggregate is not const (GCC 12 refuses to split a "read-only" one): so
/// steps are forced inline, and local vectors and inertias are `auto`, not `const auto`. On a Cortex-M4F that took the
/// Puma's torque from 1893 instructions to 900. What a user calls is not marked, but for access to values: the compiler
/// may share it.
/// Defined empty, it leaves the choice to the compiler: for programs that count operations instead of running fast, and
/// where kernels are not optimised, because there each temporary of each step would have a place on the stack of its
/// own.
#ifndef AXIAL_INLINE
#if defined(__OPTIMIZE__) || (!defined(__clang__) && !defined(AXIAL_USER_OPTIONS))
#define AXIAL_INLINE __attribute__((always_inline))
#else
#define AXIAL_INLINE
#endif
#endif

// GCC optimises kernels at any level (options/begin.hpp). Clang cannot, and a microcontroller should know.
#if defined(__clang__) && !defined(__OPTIMIZE__) && !defined(AXIAL_USER_OPTIONS) && \
    (defined(__arm__) || defined(__riscv)) && !defined(__unix__)
#pragma message( \
    "axial: without optimisation Clang makes kernels tens of times slower: -O1 for what calls them (any_build.md)")
#endif
