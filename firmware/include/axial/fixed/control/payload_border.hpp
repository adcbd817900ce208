// A payload at the border between real numbers and fixed point.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/control/limits.hpp>
#include <axial/fixed/words/real_words.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A payload after a conversion, and whether it is one that the robot may carry.
template <class Word>
struct ConvertedPayload {
  PayloadBody<Stored<Word>> load{};  ///< in the formats of InputFormats
  Status status{};                   ///< payload_limit, not_finite; about no joint
};

/// A payload (kg, m and kg m^2 in the last link's frame; mounted_payload() brings it there) in the formats of the
/// scene's robot, each number to nearest. One that is no payload, or beyond what the robot declares, has a status; then
/// in.payload keeps the one before. Integers alone, as to_fixed().
template <class S, class Word, class T>
[[nodiscard]] constexpr ConvertedPayload<Word> to_fixed_payload(const PayloadBody<T>& load) {
  using F = InputFormats<detail::described_by<S>, Stored<Word>>;
  bool finite = true;
  const auto nearest = [&finite](const T& x, int exponent) {
    finite = finite & is_finite(x);
    return Stored<Word>{detail::to_word<Word>(x, exponent)};
  };
  const auto com = [&](const T& x) { return nearest(x, F::payload_com); };
  const auto inertia = [&](const T& x) { return nearest(x, F::payload_inertia); };
  const auto& j = load.inertia_com;
  ConvertedPayload<Word> result;
  result.load = {nearest(load.mass, F::payload_mass),
                 {com(load.com.x), com(load.com.y), com(load.com.z)},
                 {inertia(j.xx), inertia(j.yy), inertia(j.zz), inertia(j.xy), inertia(j.xz), inertia(j.yz)}};
  result.status = finite ? check_payload<S>(result.load) : Status{Status::Code::not_finite, -1};
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
