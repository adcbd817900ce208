// Joint values as unrolled kernels over words read them.
#pragma once

#include <axial/fixed/formats/joint_formats.hpp>
#include <axial/links/link_view.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Joint values as kernels read them: with their formats, or angles.
template <class Robot, class S, class Values, class Role>
struct FixedView {
  const Values& values;
  template <int I>
  AXIAL_INLINE constexpr auto operator[](Index<I>) const {
    return Fx<Values::exponent(I), S>{values.values[I].raw};
  }
};
template <class Robot, class S, class Values>
struct FixedView<Robot, S, Values, role::Position> {
  const Values& values;
  template <int I>
  AXIAL_INLINE constexpr auto operator[](Index<I>) const {
    if constexpr (Robot::chain.links[I].type == JointType::revolute)
      return Bam<S>{values.values[I].raw};
    else
      return position<Values::exponent(I)>(values.values[I].raw);
  }

 private:
  template <int E>
  AXIAL_INLINE static constexpr auto position(std::int32_t raw) {
    constexpr int dropped = 32 - S::bits;  // a position has 32 bits in any word
    return Fx<E - dropped, S>{static_cast<typename S::Word>(raw >> dropped)};
  }
};

}  // namespace detail

/// What joint values in fixed point have in common, whoever shares formats.
template <class SceneType, class S>
struct WordValues {
  static constexpr Status::Code lost_code = Status::Code::saturated;  ///< ranges are proved: no joint is near singular

  /// Values that carry no format: none at all.
  template <class Values>
  AXIAL_INLINE static constexpr const Values& read(const Values& values) {
    return values;
  }
  /// Efforts to fill, in the format of the scene.
  AXIAL_INLINE static constexpr auto no_efforts() { return EffortsOf<SceneType, Stored<typename S::Word>>{}; }
};

}  // namespace axial

#include <axial/options/end.hpp>
