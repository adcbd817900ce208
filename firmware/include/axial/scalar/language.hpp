// The language that axial is written in, and the arithmetic: every header comes here before it includes anything else.
#pragma once
#if __cplusplus < 201703L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 201703L)
#error "axial needs C++17: pass -std=c++17 or -std=gnu++17 to the compiler, or a later standard (C sources: axial.h)"
#include "nothing more: see the error above"  // ends the compiler, which goes on behind #error
#endif
#if defined(__clang__) && __FINITE_MATH_ONLY__
#error "axial tells of NaN, which Clang leaves out by -ffast-math, -Ofast, -ffinite-math-only: add -fno-fast-math"
#include "nothing more: see the error above"
#endif
