// Run-time inputs in fixed point against what the robot declares: the formats hold that much and no more. No branch.
#pragma once

#include <axial/fixed/formats/input_formats.hpp>
#include <axial/fixed/limits/fixed_limits.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

constexpr std::uint64_t square(std::int32_t x) { return integer::detail::as_unsigned(integer::multiply(x, x)); }

// Whether a vector is no longer than declared: to a unit, for its components were rounded.
template <class Word>
constexpr bool within_length(const Vec3<Stored<Word>>& v, double most, int exponent) {
  const auto longest = static_cast<std::uint64_t>(raw_limit<Word>(most, exponent)) + 1;
  return square(v.x.raw) + square(v.y.raw) + square(v.z.raw) <= longest * longest;
}

template <class Word>
constexpr bool within_magnitude(Stored<Word> x, double most, int exponent) {
  return RawMost<Word>{raw_limit<Word>(most, exponent)}.allows(x);
}

// A sine and a cosine of one angle, to 2^-10; pairs that nobody gave are none.
template <class Word>
constexpr bool is_turn(const SinCos<Stored<Word>>& turn, int exponent) {
  const std::uint64_t one = std::uint64_t{1} << (2 * exponent), slack = one >> 9;
  const std::uint64_t past = square(turn.sin.raw) + square(turn.cos.raw) - (one - slack);  // what is below is beyond
  return past <= 2 * slack;
}

// Whether x a + y b + z c >= 0, where |x| .. |z| < 2^30, |a| .. |c| < 2^62: by 31 bits of a .. c at a time.
constexpr bool is_sum_positive(const std::int32_t (&x)[3], const std::int64_t (&a)[3]) {
  std::int64_t high = 0, low = 0;
  for (int i = 0; i < 3; ++i) {
    high = integer::accumulate(high, x[i], static_cast<std::int32_t>(a[i] >> 31));
    low = integer::accumulate(low, x[i], static_cast<std::int32_t>(a[i] & (std::numeric_limits<std::int32_t>::max)()));
  }
  return high + (low >> 31) >= 0;
}

// Whether an inertia is one that a body can have, none of whose principal values is negative: one that is would make
// M(q) indefinite, and no format of forward dynamics holds then. By Sylvester's minors of the words' upper 30 bits and
// of two units more on the diagonal, for entries are rounded.
template <class Word>
constexpr bool is_not_negative(const Sym3<Stored<Word>>& j) {
  constexpr int dropped = sizeof(Word) == 4 ? 2 : 0, half = dropped == 0 ? 0 : 1 << (dropped - 1);
  const auto upper = [](const Stored<Word>& x, int more) {
    return static_cast<std::int32_t>((std::int64_t{x.raw} + half) >> dropped) + more;
  };
  const std::int32_t xx = upper(j.xx, 2), yy = upper(j.yy, 2), zz = upper(j.zz, 2);
  const std::int32_t xy = upper(j.xy, 0), xz = upper(j.xz, 0), yz = upper(j.yz, 0);
  const auto determinant = [](std::int32_t a, std::int32_t d, std::int32_t b, std::int32_t c) {
    return integer::deduct(integer::multiply(a, d), b, c);
  };
  const std::int64_t along_z = determinant(xx, yy, xy, xy);
  return (xx > 0) & (along_z > 0) &
         is_sum_positive({xz, yz, zz}, {determinant(xy, yz, xz, yy), determinant(xy, xz, yz, xx), along_z});
}

// Whether axes are a right-handed frame, each length, each product of two and the volume to 2^-11: roundings of 16 bits
// pass, a swap, a sign or a scale does not. By the words' upper 31 bits, where 1 is 2^30; what is far beyond counts as
// 0.
template <class Word>
constexpr bool is_frame(const Mat3<Vec3<Stored<Word>>>& axes) {
  constexpr int raised = 32 - 8 * static_cast<int>(sizeof(Word));
  constexpr std::int32_t one = std::int32_t{1} << 30, most = one + (one >> 11);
  const auto upper = [](const Stored<Word>& x) {
    const std::int32_t raw = x.raw * (std::int32_t{1} << raised);
    const bool inside = (raw <= most) & (raw >= -most);
    return raw & -static_cast<std::int32_t>(inside);
  };
  const std::int32_t e[3][3] = {{upper(axes.x.x), upper(axes.x.y), upper(axes.x.z)},
                                {upper(axes.y.x), upper(axes.y.y), upper(axes.y.z)},
                                {upper(axes.z.x), upper(axes.z.y), upper(axes.z.z)}};
  const auto is_near = [](std::int64_t x, std::int64_t wanted) {
    constexpr std::int64_t slack = std::int64_t{one} * (one >> 11);
    return (x - wanted <= slack) & (wanted - x <= slack);
  };
  constexpr std::int64_t unit = std::int64_t{one} * one;
  bool within = true;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) {
      std::int64_t sum = 0;
      for (int k = 0; k < 3; ++k)
        sum = integer::accumulate(sum, e[i][k], e[j][k]);
      within = within & is_near(sum, i == j ? unit : 0);
    }
  std::int64_t half_volume = 0;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const std::int64_t normal = integer::deduct(integer::multiply(e[0][l], e[1][m]), e[0][m], e[1][l]);
    half_volume = integer::accumulate(half_volume, static_cast<std::int32_t>(normal >> 31), e[2][k]);
  }
  return within & is_near(2 * half_volume, unit);
}

/// A payload in fixed point against the declared one.
template <class S, class Word>
constexpr bool payload_within(const PayloadBody<Stored<Word>>& load) {
  using F = InputFormats<detail::described_by<S>, Stored<Word>>;
  const auto& j = load.inertia_com;
  const bool mass = within_magnitude(load.mass, F::load.mass, F::payload_mass);
  const bool com = within_length(load.com, F::load.com_reach, F::payload_com), inertia = is_not_negative(j);
  bool within = (load.mass.raw >= 0) & mass & com & inertia;
  const Stored<Word> entries[] = {j.xx, j.yy, j.zz, j.xy, j.xz, j.yz};
  for (const auto& entry : entries) {
    const bool bounded = within_magnitude(entry, F::load.inertia, F::payload_inertia);
    within = within & bounded;
  }
  for (int i = 0; i < 3; ++i)
    within = within & (entries[i].raw >= 0);
  return within;
}

/// A run-time tool in fixed point against the declared reach.
template <class S, class Word>
constexpr bool tool_within(const Pose<Mat3<Vec3<Stored<Word>>>, Vec3<Stored<Word>>>& tool) {
  using F = InputFormats<detail::described_by<S>, Stored<Word>>;
  const bool reached = within_length(tool.position, F::tool_limit.reach, F::tool), framed = is_frame(tool.rotation);
  return reached & framed;
}

/// The other run-time inputs: what is beyond its format would be another number there.
template <class S, class Word>
constexpr Status check_fixed_inputs(const Inputs<S, Stored<Word>>& in) {
  using Scene = scene_of<S>;
  using F = InputFormats<detail::described_by<S>, Stored<Word>>;
  bool within = true;
  if constexpr (Scene::template has<TipWrench>) {
    const bool force = within_length(in.tip_wrench.force, F::wrench.force, F::tip_force);
    const bool moment = within_length(in.tip_wrench.moment, F::wrench.moment, F::tip_moment);
    within = force & moment;
  }
  if constexpr (Scene::template has<RuntimeGravity>) {
    constexpr auto g = detail::described_by<S>::chain.gravity;
    within = within & within_length(in.gravity, length_of(g.x, g.y, g.z), F::gravity);
  }
  if constexpr (Scene::template has<SineCosines>)
    for (int i = 0; i < std::decay_t<decltype(in.turns)>::size; ++i)
      within = within & (!turns_of<detail::described_by<S>>.of[i] | is_turn(in.turns[i], F::sine_cosine));
  if constexpr (Scene::template has<RuntimeTool>) within = within & tool_within<S>(in.tool);
  return {within ? Status::Code::ok : Status::Code::input_limit, -1};
}

}  // namespace axial::detail

#include <axial/options/end.hpp>
