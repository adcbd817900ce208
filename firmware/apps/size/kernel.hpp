#pragma once
/// What a generated source calls for each of its kernels: the robot by <robot.hpp>, the rest by the build's
/// definitions.

#include <robot.hpp>

#include <new>
#include <utility>

#include "../number_systems.hpp"
#include "algorithms.hpp"
#include "argument.hpp"

namespace axial::apps::size {

using System = number_systems::AXIAL_PROBE_NUMBERS;

/// An algorithm on a scene, from the harness's argument into its room for a result.
template <class Algorithm, class Chosen>
AXIAL_INLINE inline void run(void* argument) {
  using Given = Argument<Robot, System::Number>;
  using Result = decltype(Algorithm::template run<Chosen>(std::declval<const Given&>()));
  static_assert(sizeof(Result) <= Given::largest_result, "make room for the result in argument.hpp");
  auto& a = *static_cast<Given*>(argument);
  ::new (static_cast<void*>(a.result)) Result(Algorithm::template run<Chosen>(a));
}

}  // namespace axial::apps::size
