// Begins a header's own code, behind its includes; end.hpp ends it. Without #pragma once: each header has the pair.
//
// GCC compiles what stands between them with the options that the published figures are for, whatever the user's own
// are: unoptimised, forced inlining makes a stack slot of every temporary (doc/guides/any_build.md). The options go
// with each function and template, wherever it is instantiated; the user's own code keeps the user's.
// AXIAL_USER_OPTIONS turns this off.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored \
    "-Wsign-conversion"  // GCC 12 warns of each array that is as long as a template's int says
#ifndef AXIAL_WARN_SHADOW
#pragma GCC diagnostic ignored "-Wshadow"  // a parameter q is no mistake where the user's q is a global
#endif
#ifndef AXIAL_USER_OPTIONS
#pragma GCC push_options
#ifdef __NO_INLINE__
#pragma GCC optimize("inline")  // which O2 does not bring back where the user's -O0 took it away
#endif
#pragma GCC optimize("O2", "no-schedule-insns", "no-tree-ter", "rename-registers")
#ifndef __ARM_ARCH_6M__
#pragma GCC optimize("live-range-shrinkage")  // on a Cortex-M0 it makes fixed point spill
#endif
#if __FINITE_MATH_ONLY__ || defined __ASSOCIATIVE_MATH__ || defined __RECIPROCAL_MATH__ || defined __NO_SIGNED_ZEROS__
#pragma GCC optimize("no-unsafe-math-optimizations", "no-finite-math-only", "signed-zeros")
#pragma GCC optimize("no-associative-math", "no-reciprocal-math")
#endif  // else not even named: GCC inlines no function whose options are not the caller's to the letter
#elif __FINITE_MATH_ONLY__
#define AXIAL_OPTIONS_SET_BACK
#pragma GCC push_options
#pragma GCC optimize("no-unsafe-math-optimizations", "no-finite-math-only", "signed-zeros")
#pragma GCC optimize("no-associative-math", "no-reciprocal-math")
#endif
#endif
