// How the kernels reach the code that hand-written scalars would give.
#pragma once

/// Marks every step of a kernel. GCC keeps an aggregate in registers only if each function that touches it is inlined
/// before its scalars are replaced, and if the aggregate is not const (GCC 12 refuses to split a "read-only" one): so
/// steps are forced inline, and local vectors and inertias are `auto`, not `const auto`. On a Cortex-M4F that took the
/// Puma's torque from 1893 instructions to 900. What a user calls is not marked: the compiler may share it.
/// Defined empty, it leaves the choice to the compiler: for programs that count operations instead of running fast.
#ifndef AXIAL_INLINE
#define AXIAL_INLINE __attribute__((always_inline))
#endif
