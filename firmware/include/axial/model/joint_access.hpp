// How kernels read and write joint values, whatever the number system.
#pragma once

#include <axial/model/fixed_formats.hpp>
#include <axial/model/fixed_inputs.hpp>

namespace axial {

/// Joint values as the kernels over `links` (or whatever else has a Scalar) read them.
template <class Links, class Values>
AXIAL_INLINE constexpr const Values& read(const Links&, const Values& values) {
  return values;
}
template <class Links, class S, class Word, class Role>
AXIAL_INLINE constexpr auto read(const Links&, const Joints<S, Stored<Word>, Role>& values) {
  using Values = Joints<S, Stored<Word>, Role>;
  return detail::FixedView<robot_of<S>, typename Links::Scalar, Values, Role>{values};
}

/// Efforts to fill, in the format of the scene.
template <class Links>
AXIAL_INLINE constexpr auto no_efforts(const Links&) {
  using Scene = typename Links::Scene;
  return EffortsOf<Scene, typename detail::StoredAs<typename Links::Scalar>::type>{};
}

/// values[i] = x, rounded into the format of the values.
template <class Links, class Values, class I, class X>
AXIAL_INLINE constexpr void write(const Links&, Values& values, I i, const X& x) {
  using Scalar = typename Links::Scalar;
  if constexpr (is_number_v<Scalar>) {
    values[i] = static_cast<Scalar>(x);
  } else {
    using Result = Fx<Values::exponent(I::value), Scalar>;
    if constexpr (is_structural_v<X>)
      values.values[I::value] = {Result(x).raw};
    else
      values.values[I::value] = {round_to<Result::exponent>(x).raw};
  }
}

}  // namespace axial
