// What a scene can name beside the features of features.hpp where it computes in fixed point.
#pragma once

#include <axial/scene/features.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Fixed point: results are rounded down instead of to nearest, which saves an addition each.
struct RoundDown : Feature<RoundDown> {};

/// Fixed point: of a product only the upper word is kept, rounded down: cheaper, above all on cores without a long
/// multiply, and less exact.
struct HighWord : Feature<HighWord> {};

/// Fixed point, for tests on a host: sums do not wrap, and results that do not fit their format are counted in
/// `axial::range_overflows`. Same results where nothing overflows.
struct RangeCheck : Feature<RangeCheck> {};

}  // namespace axial

#include <axial/options/end.hpp>
