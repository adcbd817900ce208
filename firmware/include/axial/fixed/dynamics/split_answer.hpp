// The split form's answer in fixed point: in formats that hold whatever efforts can do, or where those lose too much in
// the declared motion, of a drive that is magnified as far as it leaves room.
#pragma once

#include <axial/dynamics/free_response.hpp>
#include <axial/fixed/dynamics/drive_scale.hpp>
#include <axial/fixed/recursion/steps.hpp>

#include <axial/options/begin.hpp>

namespace axial::aba {

/// Joint accelerations of one solve as words, each at the exponent of its link.
template <class Links>
struct Solved {
  std::int32_t raw[Links::capacity] = {};  ///< one per joint
  int lost = -1;                           ///< first joint that is near singular or beyond its formats, -1 for none
};

/// One solve of (tau - bias) / 2^halvings; `room` sees its vectors.
template <class Links, class Screws, class Structure, class Tau, class Bias, bool apart = detail::stages_apart<Links>>
AXIAL_INLINE constexpr Solved<Links> solved(const Links& links, const Screws& screws, const Structure& structure,
                                            const Tau& tau, const Bias& bias, int halvings, Headroom& room) {
  if constexpr (apart) {
    return detail::called([&]() AXIAL_INLINE {
      return solved<Links, Screws, Structure, Tau, Bias, false>(links, screws, structure, tau, bias, halvings, room);
    });
  } else {
    Solved<Links> result;
    const auto drive = drive_over(links, tau, bias, halvings);
    if constexpr (Links::halvings() > 0) for_each_link(links, [&](auto i) AXIAL_INLINE { room(drive[i]); });
    result.lost = respond(links, screws, structure, drive, room,
                          [&](auto i, const auto& own) AXIAL_INLINE { result.raw[i] = own.raw; });
    return result;
  }
}

/// How many times its declared acceleration a joint's answer may be and still be right to a thousandth of the largest
/// declared one. In formats for the declared motion what a solve loses grows with its answer: no search found more than
/// two thirds of that at one and a half times. In formats that hold whatever efforts can do it is a few of their units.
template <class Links>
constexpr double trusted_times() {
  return Links::halvings() > 0 ? 1.5 : 256.0;
}
/// Whether an answer of joint I at an exponent is beyond that: never where one solve serves, whose formats hold little
/// more than what is declared.
template <class Links, int I, int exponent>
AXIAL_INLINE constexpr bool is_beyond_trust(std::int32_t raw) {
  constexpr double limit =
      Links::Scene::Robot::chain.links[I].acceleration_limit * trusted_times<Links>() * detail::power_of_two(exponent);
  if constexpr ((Links::halvings() > 0 || Links::second_solve()) && limit < 2147483647.0)
    return detail::is_less(static_cast<std::int32_t>(limit), raw ^ (raw >> 31));
  else
    return false;
}
/// The status of a solve that lost joint `lost`, or where that is -1, names the first joint beyond trust.
template <class Links>
AXIAL_INLINE constexpr Status answered_status(int lost, bool scaled, int beyond) {
  const Status plain = status_of<Links>(lost, scaled);
  const bool kept = is_negative(lost), beyond_trust = !is_negative(beyond), named = kept & beyond_trust;
  return status_from(select(named, static_cast<int>(Status::Code::acceleration_limit), static_cast<int>(plain.code)),
                     select(named, beyond, plain.joint));
}

/// In fixed point: a first solve, whose ranges are proved; then, where formats have bits to spare, one as much larger
/// as the first leaves room for. The second is taken where it agrees with the first, so that the answer never strays
/// from the proved one.
struct AnswerInRanges {
  /// Writes the accelerations under tau - bias.
  template <class Links, class Screws, class Structure, class Tau, class Bias, class A>
  AXIAL_INLINE static constexpr Status of(const Links& links, const Screws& screws, const Structure& structure,
                                          const Tau& tau, const Bias& bias, A& qdd) {
    using S = typename Links::Scalar;
    constexpr int solves = Links::second_solve() ? 2 : 1;
    const int halvings = halvings_of(links, tau, bias);
    Solved<Links> all[solves];
    int magnified = 0;
    for (int k = 0; k < solves; ++k) {  // a loop, so that the code is there once
      Headroom room(magnified);
      all[k] = solved(links, screws, structure, tau, bias, halvings - magnified, room);
      if (k + 1 < solves) magnified = select(is_negative(all[0].lost), room.magnification(), 0);
    }
    int lost = all[0].lost, beyond = -1;
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      constexpr int exponent = decltype(links.link(i))::format.joint_acceleration;
      const std::int32_t first = all[0].raw[i], second = all[solves - 1].raw[i];
      const std::int32_t moved = detail::moved_down<S>(second, static_cast<unsigned char>(magnified));
      const auto apart =
          static_cast<std::int32_t>(static_cast<std::uint32_t>(moved) - static_cast<std::uint32_t>(first));
      const int agreement = static_cast<int>(is_negative(all[solves - 1].lost)) &
                            static_cast<int>(detail::is_less(apart, second_solve_tolerance)) &
                            static_cast<int>(detail::is_less(-second_solve_tolerance, apart));
      const bool agrees = agreement != 0;
      const int net = halvings - select(agrees, magnified, 0);
      const std::int64_t whole =
          detail::rescaled_word<S, solves == 1>(static_cast<typename S::Word>(select(agrees, second, first)), net);
      bool spilt = false;
      const Fx<exponent, S> held{detail::held_in_word<S>(spilt, whole)};
      links.write_limited(qdd, i, held, spilt);
      lost = first_found(lost, spilt, static_cast<int>(i));
      beyond = first_found(beyond, is_beyond_trust<Links, i, A::exponent(i)>(qdd.values[i].raw), static_cast<int>(i));
    });
    constexpr int usual = Links::usual_halvings();
    return answered_status<Links>(lost, halvings > usual, beyond);
  }
};

/// The smaller of two shifts, without a branch.
AXIAL_INLINE constexpr int least_of(int a, int b) { return select(detail::is_less(a, b), a, b); }

/// Solves of a drive that is halved Links::halvings() times at first: the first of them is right in few bits, so that
/// each is counted on for twelve doublings.
template <class Links>
constexpr int solves_of() {
  constexpr int bits = 12;
  return 2 + (Links::halvings() - 1) / bits;
}
/// Doublings of the first drive that words have bits for on the way from efforts to the formats of the links.
template <class Links, class Tau, class Bias, int... I>
constexpr int most_magnified(std::integer_sequence<int, I...>) {
  constexpr int wanted = doublings_of<Links>();
  int most = wanted;
  ((most =
        least_of(most, detail::magnification_limit<wanted>(Bias::exponent(I) + Links::halvings() -
                                                               decltype(Links::link(Index<I>{}))::format.joint_effort,
                                                           Bias::exponent(I) - Tau::exponent(I)))),
   ...);
  return most;
}

/// In fixed point, in formats for the declared motion: a first solve of the drive halved so often that whatever efforts
/// do fits; then solves of as much more of it as the one before left room for. One in which a vector comes within a bit
/// of its format does not count, and leaves a status.
struct AnswerMagnified {
  /// Writes the accelerations under tau - bias.
  template <class Links, class Screws, class Structure, class Tau, class Bias, class A>
  AXIAL_INLINE static constexpr Status of(const Links& links, const Screws& screws, const Structure& structure,
                                          const Tau& tau, const Bias& bias, A& qdd) {
    using S = typename Links::Scalar;
    using Words = Stored<typename S::Word>;
    constexpr int most = most_magnified<Links, EffortsOf<typename Links::Scene, Words>,
                                        Joints<typename Links::Scene, Words, role::MotionEffort>>(
        std::make_integer_sequence<int, Links::capacity>{});
    const int halvings = halvings_of(links, tau, bias);
    Solved<Links> best;
    int magnified = 0, more = 0, lost = -1, beyond = -1;
    for (int k = 0; k < solves_of<Links>(); ++k) {  // a loop, so that the code is there once
      Headroom room(magnified + more);
      const Solved<Links> next = solved(links, screws, structure, tau, bias, halvings - magnified - more, room);
      const bool good = room.kept();
      lost = first_found(first_found(lost, !is_negative(next.lost), next.lost), !good, 0);
      magnified += select(good, more, 0);
      for_each_link(links, [&](auto i) AXIAL_INLINE { best.raw[i] = select(good, next.raw[i], best.raw[i]); });
      more = least_of(select(good, room.template magnification<3>(), 0), most - magnified);
    }
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      constexpr int up = A::exponent(i) - decltype(links.link(i))::format.joint_acceleration + Links::halvings();
      const int shift = up + halvings - magnified;
      const int held = least_of(select(detail::is_less(shift, -31), -31, shift), 30);
      bool spilt = false;
      const auto whole = detail::rescaled_word<S, false>(static_cast<typename S::Word>(best.raw[i]), held);
      qdd.values[i] = {detail::held_in_word<S>(spilt, whole)};
      lost = first_found(lost, spilt, static_cast<int>(i));
      beyond = first_found(beyond, is_beyond_trust<Links, i, A::exponent(i)>(qdd.values[i].raw), static_cast<int>(i));
    });
    constexpr int usual = Links::usual_halvings();
    return answered_status<Links>(lost, halvings > usual, beyond);
  }
};

/// How words answer: in one solve or two where formats have the room, or magnified step by step.
template <class Word, bool nearest, bool high, bool checked>
struct SplitAnswer<Arithmetic<Word, nearest, high, checked>> {
  /// the way over these links
  template <class Links>
  using Over = std::conditional_t<(Links::halvings() > 0), AnswerMagnified, AnswerInRanges>;
};

}  // namespace axial::aba

#include <axial/options/end.hpp>
