// What a certified answer of forward dynamics in fixed point is, and what there is to say about one.
#pragma once

#include <axial/fixed/dynamics/enclosure.hpp>
#include <axial/fixed/formats/joint_formats.hpp>
#include <axial/recursion/forward_result.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Accelerations, how far each can be from the exact one, and what there is to say about them.
template <class S, class T>
struct CertifiedDynamics : ForwardDynamics<S, T> {
  FreeAccelerations<S, T> bound{};  ///< of each acceleration, in its format; the largest word where nothing is known
};

namespace detail {

/// Column j of the approximate inverse from such an answer: accelerations inside the limits, for their words have 31
/// bits there. `c` has the shifts of a Certificate.
template <int size, class Shifts, class System>
AXIAL_INLINE constexpr void set_shifted_column(const Shifts& c, System& system, int j, const std::int32_t* answer,
                                               int drive) {
  constexpr int bits = 30;
  std::int64_t wide[size] = {}, seen = 0;
  for (int i = 0; i < size; ++i) {
    const int behind = c.widest - c.column_shift[i], right = behind > bits ? smaller(behind - bits, 31) : 0;
    wide[i] = integer::multiply(answer[i] >> right, std::int32_t{1} << (behind > bits ? 0 : bits - behind));
    seen |= wide[i] ^ (wide[i] >> 63);
  }
  const auto top = static_cast<std::uint32_t>(seen >> bits);
  const int down = 31 - integer::detail::leading_zeros((top << 1) | 1U);
  for (int i = 0; i < size; ++i)
    system.inverse[i][j] = static_cast<std::int32_t>(wide_shifted_by(wide[i], down));
  system.shift[j] = drive + c.drive_shift[j] + bits - c.widest - down;
}

/// Whether the plain solve came to an answer, which may be beyond what is declared.
AXIAL_INLINE constexpr bool is_answer(Status::Code plain) {
  return (plain == Status::Code::ok) | (plain == Status::Code::rescaled) | (plain == Status::Code::acceleration_limit);
}
/// What status an answer has that the plain solve calls `plain`.
AXIAL_INLINE constexpr Status certified_status(Status plain, bool inside, bool tight) {
  const int short_of =
      select(inside, static_cast<int>(Status::Code::inaccurate), static_cast<int>(Status::Code::acceleration_limit));
  const int found = select(tight, static_cast<int>(plain.code), short_of);
  return {static_cast<Status::Code>(select(is_answer(plain.code), found, static_cast<int>(plain.code))),
          select(is_answer(plain.code) & (plain.code != Status::Code::acceleration_limit), -1, plain.joint)};
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
