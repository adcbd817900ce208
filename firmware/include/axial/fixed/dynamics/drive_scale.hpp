// What forward dynamics does with efforts beyond those that its formats are made for: the solve is linear in them, so
// it takes them in halves, quarters, ... and doubles the answer; and of efforts that leave bits unused, in multiples.
#pragma once

#include <axial/fixed/links/shared_view.hpp>
#include <axial/recursion/passes.hpp>
#include <axial/spatial/spatial_vector.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

inline constexpr int most_halvings = 5, most_doublings = 12;

/// limit 2^k without its last bit, at most what a word holds.
template <std::int64_t limit, int k>
inline constexpr std::uint32_t half_of = [] {
  constexpr std::int64_t most = (std::numeric_limits<std::uint32_t>::max)();
  return static_cast<std::uint32_t>(limit > most >> k ? most : (limit << k) >> 1);
}();

/// Halvings that bring |x| to `limit` or below, to two units, at most most_halvings; the same instructions whatever
/// they are. |x| < 2^32, so that without its last bit it is compared as a word.
template <std::int64_t limit, int... K>
AXIAL_INLINE constexpr int halvings(std::int64_t x, std::integer_sequence<int, K...>) {
  const auto half = static_cast<std::int32_t>(x >> 1);
  const auto size = static_cast<std::uint32_t>(half ^ (half >> 31));
  return (0 + ... + static_cast<int>(half_of<limit, K> < size));
}

/// tau - bias in units of tau's word, |result| < 2^32; the bias may be finer.
template <int E, int F, class S>
AXIAL_INLINE constexpr std::int64_t difference(const Fx<E, S>& tau, const Fx<F, S>& bias) {
  return std::int64_t{tau.raw} - (bias.raw >> (F - E));
}
/// tau - bias in units of the bias, exact.
template <int E, int F, class S>
AXIAL_INLINE constexpr std::int64_t exact_difference(const Fx<E, S>& tau, const Fx<F, S>& bias) {
  static_assert(F - E < 31);
  return integer::multiply(static_cast<std::int32_t>(tau.raw), std::int32_t{1} << (F - E)) - bias.raw;
}

/// Left shift that leaves every shift of `divided` one to the right, as far as 33 bits and `finer` leave room for it.
constexpr int room_of(int doublings, int down, int finer) {
  const int wanted = doublings - down;
  return wanted < 0 ? 0 : smaller(wanted, 30 - finer);
}
/// How many of the doublings `divided` has bits for on the way to an exponent that is lower by `down`.
template <int doublings>
constexpr int magnification_limit(int down, int finer) {
  return smaller(down + room_of(doublings, down, finer), doublings);
}
/// x / 2^shift from exponent E at exponent F, |x| < 2^(33 + finer); shift from
/// -magnification_limit<doublings>(E - F, finer) to most_halvings.
template <int F, int E, class S, int finer = 0, int doublings = most_doublings>
AXIAL_INLINE constexpr Fx<F, S> divided(std::int64_t x, int shift) {
  constexpr int room = room_of(doublings, E - F, finer);
  static_assert(
      E - F + room + most_halvings < 63,
      "axial: declared efforts and what forward dynamics makes of them differ by more than fixed point can hold");
  return {static_cast<typename S::Word>(shifted_by(x * (std::int64_t{1} << room), shift + (E - F + room)))};
}

/// 2^shift x, rounded where shift is negative, which it never is if `up`.
template <class S, bool up>
AXIAL_INLINE constexpr std::int64_t rescaled_word(typename S::Word x, int shift) {
  if constexpr (up) {
    return integer::multiply(x, std::int32_t{1} << shift);
  } else {
    const int left = select(is_negative(shift), 0, shift), right = left - shift;
    return integer::multiply(moved_down<S>(x, static_cast<unsigned char>(right)), std::int32_t{1} << left);
  }
}

}  // namespace detail

/// Halvings that bring what drives the joints, tau - bias, within what the formats are made for.
template <class Links, class Tau, class Bias>
AXIAL_INLINE constexpr int halvings_of(const Links& links, const Tau& tau, const Bias& bias) {
  int shift = 0;
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    constexpr std::int64_t limit = Links::template drive_limit<i>(decltype(tau[i])::exponent);
    const int own = detail::halvings<limit>(detail::difference(tau[i], bias[i]),
                                            std::make_integer_sequence<int, detail::most_halvings>{});
    shift = select(detail::is_less(shift, own), own, shift);
  });
  return shift;
}

/// Doublings of a drive that is halved Links::halvings() times at first: back to itself, and more where it is small.
template <class Links>
constexpr int doublings_of() {
  return Links::halvings() > 0 ? detail::doublings_after(Links::halvings()) : detail::most_doublings;
}

/// (tau - bias) / 2^shift of all joints, in the links' formats for a drive that is halved `Links::halvings()` times.
template <class Links, class Tau, class Bias>
AXIAL_INLINE constexpr auto drive_over(const Links& links, const Tau& tau, const Bias& bias, int shift) {
  return map_links(links, [&](auto i) AXIAL_INLINE {
    using Fine = decltype(bias[i]);
    using S = typename Links::Scalar;
    constexpr int to = decltype(links.link(i))::format.joint_effort, from = Fine::exponent + Links::halvings();
    constexpr int finer = Fine::exponent - decltype(tau[i])::exponent;
    return detail::divided<to, from, S, finer, doublings_of<Links>()>(detail::exact_difference(tau[i], bias[i]), shift);
  });
}

/// Watches how far vectors stay inside their formats, for the same drive may be solved once more 2^magnification times
/// as large: then less is lost to rounding.
class Headroom {
 public:
  static constexpr int most = detail::most_doublings;  ///< largest magnification, as an exponent of 2

  /// Headroom of a drive that is magnified already, by 2^magnified.
  AXIAL_INLINE constexpr explicit Headroom(int magnified) : magnified_(magnified) {}
  /// the drive's magnification, as an exponent of 2
  AXIAL_INLINE constexpr int magnified() const { return magnified_; }
  /// Sees vectors of one link.
  template <class... V>
  AXIAL_INLINE constexpr void operator()(const V&... vectors) {
    (see(vectors), ...);
  }
  /// Whether every component has a bit to spare: what would not fit its format is seen by that.
  AXIAL_INLINE constexpr bool kept() const { return seen_ >> 30 == 0; }
  /// Bits that every component has left but for `spare`: the sign; a component from a norm; sums on the way; and the
  /// rounding of the first solve. One fewer is enough where the next solve is looked at, too.
  template <int spare = 4>
  AXIAL_INLINE constexpr int magnification() const {
    const int left = integer::detail::leading_zeros(seen_ | 1U) - spare;
    const int some = select(detail::is_less(0, left), left, 0);
    return select(detail::is_less(most, some), most, some);
  }

 private:
  AXIAL_INLINE constexpr void see(Zero) {}
  template <int E, class S>
  AXIAL_INLINE constexpr void see(const Fx<E, S>& x) {
    seen_ |= static_cast<std::uint32_t>(x.raw ^ (x.raw >> (S::bits - 1)));
  }
  template <class X, class Y, class Z>
  AXIAL_INLINE constexpr void see(const Vec3<X, Y, Z>& v) {
    see(v.x), see(v.y), see(v.z);
  }
  template <class N, class F>
  AXIAL_INLINE constexpr void see(const ForceVector<N, F>& f) {
    see(f.moment), see(f.force);
  }
  template <class W, class V>
  AXIAL_INLINE constexpr void see(const MotionVector<W, V>& m) {
    see(m.angular), see(m.linear);
  }
  std::uint32_t seen_ = 0;
  int magnified_;
};

}  // namespace axial

#include <axial/options/end.hpp>
