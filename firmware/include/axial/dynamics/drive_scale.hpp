// What forward dynamics does with efforts beyond those that its formats are made for: the solve is linear in them, so
// it takes them in halves, quarters, ... and doubles the answer.
#pragma once

#include <axial/dynamics/passes.hpp>

namespace axial {

/// What drives the joints besides the bias, divided by 2^shift; floating point needs no shift.
template <class Values, class Shift>
struct ScaledDrive {
  Values values{};
  Shift shift{};
};
template <class Values, class Shift>
ScaledDrive(Values, Shift) -> ScaledDrive<Values, Shift>;

namespace detail {

inline constexpr int most_halvings = 5;

/// Halvings that bring |x| to `limit` or below, at most most_halvings; the same instructions whatever they are.
template <int... K>
AXIAL_INLINE constexpr int halvings(std::int64_t x, std::int64_t limit, std::integer_sequence<int, K...>) {
  const std::int64_t sign = x >> 63, size = (x ^ sign) - sign;
  return (0 + ... + static_cast<int>(is_less(limit << K, size)));
}

template <int E, class S>
AXIAL_INLINE constexpr std::int64_t difference(const Fx<E, S>& a, const Fx<E, S>& b) {
  return std::int64_t{a.raw} - std::int64_t{b.raw};
}

/// x / 2^shift from exponent E at exponent F.
template <int F, int E, class S>
AXIAL_INLINE constexpr Fx<F, S> divided(std::int64_t x, int shift) {
  constexpr int room = 24;  // 33 bits and these are still a double word
  static_assert(E - F + room > 0 && E - F + room + most_halvings < 63);
  return {static_cast<typename S::Word>(shifted_by(x * (std::int64_t{1} << room), shift + (E - F + room)))};
}

}  // namespace detail

/// tau - bias of all joints, in halves where that is needed.
template <class Links, class Tau, class Bias>
AXIAL_INLINE constexpr auto scaled_drive(const Links& links, const Tau& tau, const Bias& bias) {
  if constexpr (is_number_v<typename Links::Scalar>) {
    return ScaledDrive{map_links(links, [&](auto i) AXIAL_INLINE { return tau[i] - bias[i]; }), Zero{}};
  } else {
    int shift = 0;
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      constexpr std::int64_t limit = Links::template drive_limit<i>(decltype(tau[i])::exponent);
      const int own = detail::halvings(detail::difference(tau[i], bias[i]), limit,
                                       std::make_integer_sequence<int, detail::most_halvings>{});
      shift = select(detail::is_less(shift, own), own, shift);
    });
    auto values = map_links(links, [&](auto i) AXIAL_INLINE {
      using From = decltype(tau[i]);
      constexpr int to = decltype(links.link(i))::format.joint_effort;
      return detail::divided<to, From::exponent, typename Links::Scalar>(detail::difference(tau[i], bias[i]), shift);
    });
    return ScaledDrive{values, shift};
  }
}

/// A joint's acceleration under the whole drive; `lost` where it does not fit.
template <class X>
AXIAL_INLINE constexpr const X& unscaled(bool&, const X& x, Zero) {
  return x;
}
template <int E, class S>
AXIAL_INLINE constexpr Fx<E, S> unscaled(bool& lost, const Fx<E, S>& x, int shift) {
  const std::int64_t whole = integer::multiply(x.raw, std::int32_t{1} << shift);
  return {detail::held_in_word<S>(lost, whole)};
}

/// Whether efforts were taken in parts.
AXIAL_INLINE constexpr bool is_scaled(Zero) { return false; }
AXIAL_INLINE constexpr bool is_scaled(int shift) { return shift > 0; }

}  // namespace axial
