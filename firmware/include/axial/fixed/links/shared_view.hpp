// Joint values where all links share their formats: read from, and written to, a format per joint.
#pragma once

#include <axial/fixed/links/fixed_values.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// A joint's position where a table holds joints of both kinds.
template <int Length, class S>
struct SharedPosition {
  Bam<S> angle{};
  Fx<Length, S> length{};
};
template <int Length, class S>
AXIAL_INLINE constexpr Bam<S> joint_angle(const SharedPosition<Length, S>& q) {
  return q.angle;
}
template <int Length, class S>
AXIAL_INLINE constexpr Fx<Length, S> joint_length(const SharedPosition<Length, S>& q) {
  return q.length;
}

/// How far words of one role, in a format per joint, are from a common one.
template <class Values, int Shared>
struct Shifts {
  static constexpr int size = Values::size;
  unsigned char of[size] = {};
  bool any = false;

  static constexpr Shifts chosen() {
    Shifts shifts;
    for (int i = 0; i < size; ++i) {
      const int shift = Values::exponent(i) - Shared;
      shifts.of[i] = static_cast<unsigned char>(shift > 0 ? shift : 0);
      shifts.any = shifts.any || shift > 0;
    }
    return shifts;
  }
};
template <class Values, int Shared>
inline constexpr auto shifts_of = Shifts<Values, Shared>::chosen();

/// x 2^-shift as the arithmetic rounds, with no branch on the shift.
template <class S>
AXIAL_INLINE constexpr typename S::Word moved_down(std::int32_t x, unsigned char shift) {
  const std::int32_t half = S::nearest ? static_cast<std::int32_t>((std::uint32_t{1} << shift) >> 1) : 0;
  return static_cast<typename S::Word>((x >> shift) + static_cast<std::int32_t>((x & half) != 0));
}

/// x 2^(up - down), one of them 0, where the result fits.
template <class S>
AXIAL_INLINE constexpr typename S::Word moved_either_way(typename S::Word x, unsigned char down, unsigned char up) {
  using Bits = typename S::Bits;
  const typename S::Wide lower = moved_down<S>(x, down);
  return narrowed<S>(static_cast<Bits>(static_cast<Bits>(lower) << up));
}

/// The least exponent of values, at which all of them fit.
template <class Values>
constexpr int shared_exponent() {
  int least = Values::exponent(0);
  for (int i = 1; i < Values::size; ++i)
    least = smaller(least, Values::exponent(i));
  return least;
}

/// Joint values as kernels in shared formats read them.
template <class Links, class Values, class Role>
struct SharedView {
  using S = typename Links::Scalar;
  const Values& values;

  static constexpr int exponent = shared_exponent<Values>();
  AXIAL_INLINE constexpr auto operator[](int i) const {
    constexpr const auto& shifts = shifts_of<Values, exponent>;
    if constexpr (shifts.any)
      return Fx<exponent, S>{moved_down<S>(values.values[i].raw, shifts.of[i])};
    else
      return Fx<exponent, S>{values.values[i].raw};
  }
};
template <class Links, class Values>
struct SharedView<Links, Values, role::Position> {
  using S = typename Links::Scalar;
  using Columns = typename Links::SharedColumns;
  static constexpr int length = Links::Formats::format.length;
  const Values& values;

  AXIAL_INLINE constexpr auto operator[](int i) const {
    const std::int32_t raw = values.values[i].raw;
    if constexpr (!Columns::any_prismatic)
      return Bam<S>{raw};
    else
      return SharedPosition<length, S>{{raw}, {moved_down<S>(raw, shifts_of<Values, length>.of[i])}};
  }
};

}  // namespace detail

/// The members of PlainValues over arithmetic S, for links that share their formats.
template <class Links, class SceneType, class S>
struct SharedValues : WordValues<SceneType, S> {
  using WordValues<SceneType, S>::read;
  /// Words in the formats that all links share.
  template <class R, class Word, class Role>
  AXIAL_INLINE static constexpr auto read(const Joints<R, Stored<Word>, Role>& values) {
    return detail::SharedView<Links, Joints<R, Stored<Word>, Role>, Role>{values};
  }
  /// From the format that all joints share into joint i's own, which is as fine or finer: nothing is lost.
  template <class Values, int E>
  AXIAL_INLINE static constexpr void write(Values& values, int i, const Fx<E, S>& x) {
    values.values[i] = {detail::moved_either_way<S>(x.raw, 0, detail::shifts_of<Values, E>.of[i])};
  }
  /// values[i] = x - y, rounded once into the least of the joints' formats.
  template <class Values, class X, class Y>
  AXIAL_INLINE static constexpr void write_difference(Values& values, int i, const X& x, const Y& y) {
    write(values, i, round_to<detail::shared_exponent<Values>()>(x - y));
  }
  /// A pose, or a motion, of kinematics as words.
  template <class V>
  AXIAL_INLINE static constexpr auto stored(const V& v) {
    return detail::stored_at<Links::Formats::format.length, S>(v);
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
