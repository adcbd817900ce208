// How kernels read and write joint values, whatever the number system.
#pragma once

#include <axial/fixed/formats/input_formats.hpp>
#include <axial/fixed/links/shared_view.hpp>
#include <axial/spatial/pose.hpp>

namespace axial {

/// Joint values as the kernels over `links` (or whatever else has a Scalar) read them.
template <class Links, class Values>
AXIAL_INLINE constexpr const Values& read(const Links&, const Values& values) {
  return values;
}
/// Fixed point: words with their formats, indexed as the links are.
template <class Links, class S, class Word, class Role>
AXIAL_INLINE constexpr auto read(const Links&, const Joints<S, Stored<Word>, Role>& values) {
  using Values = Joints<S, Stored<Word>, Role>;
  if constexpr (detail::shares_formats<Links>)
    return detail::SharedView<Links, Values, Role>{values};
  else
    return detail::FixedView<robot_of<S>, typename Links::Scalar, Values, Role>{values};
}

/// Efforts to fill, in the format of the scene.
template <class Links>
AXIAL_INLINE constexpr auto no_efforts(const Links&) {
  using Scene = typename Links::Scene;
  return EffortsOf<Scene, typename detail::StoredAs<typename Links::Scalar>::type>{};
}

namespace detail {
/// From the format that all joints share into joint i's own, which is as fine or finer: nothing is lost.
template <class Values, int E, class S>
AXIAL_INLINE constexpr void write_shared(Values& values, int i, const Fx<E, S>& x) {
  values.values[i] = {moved_either_way<S>(x.raw, 0, shifts_of<Values, E>.of[i])};
}
}  // namespace detail

/// values[i] = x, rounded into the format of the values.
template <class Links, class Values, class I, class X>
AXIAL_INLINE constexpr void write(const Links&, Values& values, I i, const X& x) {
  using Scalar = typename Links::Scalar;
  if constexpr (is_number_v<Scalar>) {
    values[i] = static_cast<Scalar>(x);
  } else if constexpr (detail::shares_formats<Links>) {
    detail::write_shared(values, i, x);
  } else {
    using Result = Fx<Values::exponent(I::value), Scalar>;
    if constexpr (is_structural_v<X>)
      values.values[I::value] = {Result(x).raw};
    else
      values.values[I::value] = {round_to<Result::exponent>(x).raw};
  }
}

/// The same where the format of the values may be too small for x: then the largest word, and `lost` is set.
template <class Links, class Values, class I, class X>
AXIAL_INLINE constexpr void write_limited(const Links& links, Values& values, I i, const X& x, bool& lost) {
  if constexpr (!detail::IsFx<X>::value || detail::shares_formats<Links>) {
    write(links, values, i, x);
  } else if constexpr (X::exponent >= Values::exponent(I::value)) {
    write(links, values, i, x);
  } else {
    values.values[I::value] = {saturated<Values::exponent(I::value)>(lost, x).raw};
  }
}

namespace detail {

template <int E, class S, class X>
AXIAL_INLINE constexpr auto stored_at(const X& x) {
  if constexpr (IsVec3<X>::value)
    return Vec3{stored_at<E, S>(x.x), stored_at<E, S>(x.y), stored_at<E, S>(x.z)};
  else if constexpr (is_structural_v<X>)
    return Stored<typename S::Word>{Fx<E, S>(x).raw};
  else
    return Stored<typename S::Word>{round_to<E>(x).raw};
}

}  // namespace detail

/// A pose and a motion of kinematics as results hold them: plain numbers, or words with the exponents
/// `direction_exponent` and `length_exponent`.
template <class Links, class R, class P>
AXIAL_INLINE constexpr auto stored(const Links& links, const Pose<R, P>& pose) {
  using S = typename Links::Scalar;
  if constexpr (is_number_v<S>) {
    return pose.template dense<S>();
  } else {
    constexpr int length = decltype(links.link(Index<0>{}))::format.length;
    const auto& r = pose.rotation;
    return Pose{Mat3{detail::stored_at<S::unit, S>(r.x), detail::stored_at<S::unit, S>(r.y),
                     detail::stored_at<S::unit, S>(r.z)},
                detail::stored_at<length, S>(pose.position)};
  }
}
/// A motion in the formats of a Jacobian's columns.
template <class Links, class W, class V>
AXIAL_INLINE constexpr auto stored(const Links& links, const MotionVector<W, V>& motion) {
  using S = typename Links::Scalar;
  if constexpr (is_number_v<S>) {
    return motion.template dense<S>();
  } else {
    constexpr int length = decltype(links.link(Index<0>{}))::format.length;
    return MotionVector{detail::stored_at<S::unit, S>(motion.angular), detail::stored_at<length, S>(motion.linear)};
  }
}

}  // namespace axial
