// What the drives exert when requests stop, in fixed point.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/fall_back.hpp>
#include <axial/fixed/control/controlled_stop.hpp>
#include <axial/fixed/control/limits.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

template <class Word>
struct Blend<Stored<Word>> {
  /// `to`, and the share (in 2^-16) of what leads from it to `from`.
  static constexpr Stored<Word> of(const Stored<Word>& to, const Stored<Word>& from, std::uint32_t share) {
    const std::int64_t apart = std::int64_t{from.raw} - std::int64_t{to.raw};
    return {static_cast<Word>(to.raw + ((apart * static_cast<std::int32_t>(share)) >> 16))};
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
