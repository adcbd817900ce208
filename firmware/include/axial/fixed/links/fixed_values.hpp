// How kernels read and write joint values in fixed point: words with the formats of their roles.
#pragma once

#include <axial/fixed/formats/link_formats.hpp>
#include <axial/links/link_view.hpp>
#include <axial/scene/joint_products.hpp>
#include <axial/scene/status.hpp>
#include <axial/spatial/pose.hpp>

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

template <int E, class S, class X>
AXIAL_INLINE constexpr auto stored_at(const X& x) {
  if constexpr (is_vec3_v<X>)
    return Vec3{stored_at<E, S>(x.x), stored_at<E, S>(x.y), stored_at<E, S>(x.z)};
  else if constexpr (is_structural_v<X>)
    return Stored<typename S::Word>{Fx<E, S>(x).raw};
  else
    return Stored<typename S::Word>{round_to<E>(x).raw};
}
/// A pose and a motion of kinematics as words: directions, and lengths at the exponent `length`.
template <int length, class S, class R, class P>
AXIAL_INLINE constexpr auto stored_at(const Pose<R, P>& pose) {
  const auto& r = pose.rotation;
  return Pose{Mat3{stored_at<S::unit, S>(r.x), stored_at<S::unit, S>(r.y), stored_at<S::unit, S>(r.z)},
              stored_at<length, S>(pose.position)};
}
template <int length, class S, class W, class V>
AXIAL_INLINE constexpr auto stored_at(const MotionVector<W, V>& motion) {
  return MotionVector{stored_at<S::unit, S>(motion.angular), stored_at<length, S>(motion.linear)};
}

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

/// The members of PlainValues over arithmetic S, for links that have a type each.
template <class SceneType, class S>
struct FixedValues : WordValues<SceneType, S> {
  using WordValues<SceneType, S>::read;
  /// Words with their formats, indexed as the links are.
  template <class R, class Word, class Role>
  AXIAL_INLINE static constexpr auto read(const Joints<R, Stored<Word>, Role>& values) {
    return detail::FixedView<detail::described_by<R>, S, Joints<R, Stored<Word>, Role>, Role>{values};
  }
  /// values[i] = x, rounded into the format of the values.
  template <class Values, class I, class X>
  AXIAL_INLINE static constexpr void write(Values& values, I, const X& x) {
    using Result = Fx<Values::exponent(I::value), S>;
    if constexpr (is_structural_v<X>)
      values.values[I::value] = {Result(x).raw};
    else
      values.values[I::value] = {round_to<Result::exponent>(x).raw};
  }
  /// values[i] = x where the format of the values may be too small for x: then the largest word, and `lost` is set.
  template <class Values, class I, class X>
  AXIAL_INLINE static constexpr void write_limited(Values& values, I i, const X& x, bool& lost) {
    if constexpr (!detail::is_fx_v<X>)
      write(values, i, x);
    else if constexpr (X::exponent >= Values::exponent(I::value))
      write(values, i, x);
    else
      values.values[I::value] = {saturated<Values::exponent(I::value)>(lost, x).raw};
  }
  /// values[i] = x - y, rounded once.
  template <class Values, class I, class X, class Y>
  AXIAL_INLINE static constexpr void write_difference(Values& values, I i, const X& x, const Y& y) {
    write(values, i, x - y);
  }
};

namespace detail {
/// Products of words with their formats, each rounded once into that of the product.
template <class Scene, class Word>
struct JointProducts<Scene, Stored<Word>> {
  using Values = FixedValues<Scene, ArithmeticOf<Scene, Word>>;
  template <class A, class B, class Result>
  AXIAL_INLINE static constexpr void write(const A& a, const B& b, Result& products) {
    each(Values::read(a), Values::read(b), products, std::make_integer_sequence<int, Result::size>{});
  }

 private:
  template <class A, class B, class Result, int... I>
  AXIAL_INLINE static constexpr void each(const A& a, const B& b, Result& products, std::integer_sequence<int, I...>) {
    (Values::write(products, Index<I>{}, a[Index<I>{}] * b[Index<I>{}]), ...);
  }
};
}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
