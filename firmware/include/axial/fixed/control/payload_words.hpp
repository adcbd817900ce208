// A payload's estimate as words, and as the scene's Payload takes it in fixed point.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/control/payload_estimator.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// An estimate in fixed point: value = raw 2^-exponent. What the declared payload has no room for is held at the
/// largest word, and the status is payload_limit.
template <class S, class Word>
struct PayloadWords {
  using Formats = InputFormats<detail::described_by<S>, Stored<Word>>;  ///< of the scene's inputs
  static constexpr int mass_exponent = Formats::payload_mass;           ///< of the mass
  static constexpr int com_exponent = Formats::payload_com;             ///< of the centre of mass
  static constexpr int first_moment_exponent =
      Formats::of(Formats::load.mass * Formats::load.com_reach);  ///< of the first moment
  Stored<Word> mass{};                                            ///< kg
  Vec3<Stored<Word>> first_moment{};                              ///< kg m, about the last link's origin in its axes
  PayloadBody<Stored<Word>> body{};  ///< as the scene's Payload takes it: a body of no extent, or none
  Status status{};                   ///< of the estimate; payload_limit beyond the declared one
};

/// An estimate as words, cut to a unit. Constant time. The robot declares its payload_limit(). Feed-forward refuses a
/// body beyond that, as any other.
template <class S, class Word = std::int32_t>
[[nodiscard]] constexpr PayloadWords<S, Word> payload_words(const PayloadEstimate<Scaled>& estimate) {
  static_assert(sizeof(Word) == 4, "axial: payload words are of Fixed32");
  static_assert(detail::described_by<S>::chain.payload_limit.declared,
                "axial: a payload's words take their formats from the declared payload; add axial::payload_limit(mass, "
                "com_reach, inertia) to the robot's chain");
  using Words = PayloadWords<S, Word>;
  bool lost = false;
  const auto at = [&lost](int exponent, const Vec3<Scaled>& v) {
    return Vec3<Stored<Word>>{
        {v.x.as_word(exponent, lost)}, {v.y.as_word(exponent, lost)}, {v.z.as_word(exponent, lost)}};
  };
  Words words;
  words.mass.raw = estimate.mass.as_word(Words::mass_exponent, lost);
  words.first_moment = at(Words::first_moment_exponent, estimate.first_moment);
  const auto body = estimate.body();
  words.body.mass.raw = body.mass.as_word(Words::mass_exponent, lost);
  words.body.com = at(Words::com_exponent, body.com);
  const int beyond = select(estimate.status.ok() & lost, static_cast<int>(Status::Code::payload_limit),
                            static_cast<int>(estimate.status.code));
  words.status.code = static_cast<Status::Code>(beyond);
  return words;
}

}  // namespace axial

#include <axial/options/end.hpp>
