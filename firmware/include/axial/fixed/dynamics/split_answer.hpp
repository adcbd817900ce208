// The split form's answer in fixed point: words of proved ranges, solved once more where they have bits to spare.
#pragma once

#include <axial/dynamics/split_form.hpp>
#include <axial/fixed/dynamics/drive_scale.hpp>

namespace axial {
namespace aba {

/// Joint accelerations of one solve as words, each at the exponent of its link.
template <class Links>
struct Solved {
  std::int32_t raw[Links::capacity] = {};  ///< one a joint
  int lost = -1;                           ///< first joint that is near singular or beyond its formats, -1 for none
};

/// One solve of (tau - bias) / 2^halvings; `room` sees its vectors.
template <class Links, class Screws, class Structure, class Tau, class Bias>
AXIAL_INLINE constexpr Solved<Links> solved(const Links& links, const Screws& screws, const Structure& structure,
                                            const Tau& tau, const Bias& bias, int halvings, Headroom& room) {
  Solved<Links> result;
  result.lost = respond(links, screws, structure, drive_over(links, tau, bias, halvings), room,
                        [&](auto i, const auto& own) AXIAL_INLINE { result.raw[i] = own.raw; });
  return result;
}

/// In fixed point: a first solve, whose ranges are proved; then, where formats have bits to spare, one as much larger
/// as the first leaves room for. The second is taken where it agrees with the first, so that the answer never strays
/// from the proved one.
template <class Links, class Screws, class Structure, class Tau, class Bias, class A>
AXIAL_INLINE constexpr Status answer_in_ranges(const Links& links, const Screws& screws, const Structure& structure,
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
  int lost = all[0].lost;
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    constexpr int exponent = decltype(links.link(i))::format.joint_acceleration;
    const std::int32_t first = all[0].raw[i], second = all[solves - 1].raw[i];
    const std::int32_t near = detail::moved_down<S>(second, static_cast<unsigned char>(magnified));
    const auto apart = static_cast<std::int32_t>(static_cast<std::uint32_t>(near) - static_cast<std::uint32_t>(first));
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
  });
  return status_of<Links>(lost, halvings > 0);
}

template <class Word, bool nearest, bool high, bool checked>
struct SplitAnswer<Arithmetic<Word, nearest, high, checked>> {
  /// Writes the accelerations under tau - bias.
  template <class Links, class Screws, class Structure, class Tau, class Bias, class A>
  AXIAL_INLINE static constexpr Status of(const Links& links, const Screws& screws, const Structure& structure,
                                          const Tau& tau, const Bias& bias, A& qdd) {
    return answer_in_ranges(links, screws, structure, tau, bias, qdd);
  }
};

}  // namespace aba
}  // namespace axial
