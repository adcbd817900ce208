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

/// An error in words, from above; the largest that is of use where it is more.
constexpr std::int32_t rounded_up(double x) {
  constexpr double most = 1073741823.0;
  return x < most ? static_cast<std::int32_t>(x) + 1 : static_cast<std::int32_t>(most);
}

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

/// Writes the corrected answer and its bound: x(i) is what was answered in units of the system, `down(i)` bits finer
/// than the answer's words. `known` says whether there is one; true where every bound is below its `tight`.
template <int size, class Answer, class System, class X, class Down>
AXIAL_INLINE constexpr bool publish_in_words(Answer& answer, const System& system, const std::int64_t (&tight)[size],
                                             bool known, const X& x, const Down& down) {
  constexpr std::int64_t most = (std::numeric_limits<std::int32_t>::max)();
  constexpr int finest = 31;
  bool all_tight = known;
  for (int i = 0; i < size; ++i) {
    const int own = down(i), right = own < 0 ? 0 : own > finest ? finest : own;
    const int left = own < 0 ? smaller(-own, finest) : 0;
    const std::int64_t bound = ((system.bound[i] >> right) + (right > 0 ? 2 : 0)) * (std::int64_t{1} << left);
    const std::int64_t value = ((x(i) + system.correction[i]) >> right) * (std::int64_t{1} << left);
    const bool bound_fits = is_less_wide(bound, most), value_fits = is_less_wide(wide_magnitude(value), most);
    const bool fits = bound_fits & value_fits & known;
    answer.bound.values[i] = {static_cast<std::int32_t>(select_wide(fits, bound, most))};
    answer.values[i] = {static_cast<std::int32_t>(select_wide(fits, value, answer.values[i].raw))};
    all_tight = all_tight & fits & !is_less_wide(tight[i], system.bound[i]);
  }
  return all_tight;
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
