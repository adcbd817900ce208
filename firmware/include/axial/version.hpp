// The version of the library as constants; its macros are in version.h, which C reads, too.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/version.h>

#include <axial/options/begin.hpp>

namespace axial {

/// major * 10000 + minor * 100 + patch.
inline constexpr int version_number = AXIAL_VERSION_NUMBER;
/// "major.minor.patch".
inline constexpr char version_text[] = AXIAL_VERSION;

}  // namespace axial

#include <axial/options/end.hpp>
