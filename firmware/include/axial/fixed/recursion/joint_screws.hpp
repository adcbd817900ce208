// sine_cosines() in fixed point: of the angles themselves.
#pragma once

#include <axial/fixed/links/fixed_links.hpp>
#include <axial/recursion/joint_screws.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Words with the exponent InputFormats::sine_cosine.
template <class S, class Word>
struct PairsOf<S, Stored<Word>> {
  using T = Stored<Word>;
  AXIAL_INLINE static constexpr void fill(const Positions<robot_of<S>, T>& q, Joints<robot_of<S>, SinCos<T>>& turns) {
    check_fixed_scene<scene_of<S>, Word>();
    using A = ArithmeticOf<scene_of<S>, Word>;
    for (int i = 0; i < joint_count<S>; ++i) {
      const bool turns_it = detail::described_by<S>::chain.links[i].type == JointType::revolute;
      const auto pair = sincos(Bam<A>{turns_it ? static_cast<std::int32_t>(q[i].raw) : 0});
      turns[i] = {{pair.sin.raw}, {pair.cos.raw}};
    }
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
