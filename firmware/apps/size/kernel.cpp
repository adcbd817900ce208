/// One kernel in a translation unit of its own: the robot by <robot.hpp>, the rest by the build's definitions.

#include <robot.hpp>

#include <new>

#include "../number_systems.hpp"
#include "algorithms.hpp"
#include "argument.hpp"

namespace axial::apps::size {
namespace {

using System = number_systems::AXIAL_PROBE_NUMBERS;
using Chosen = System::scene<scenes::AXIAL_PROBE_SCENE, Robot AXIAL_PROBE_TAGS>;
using Given = Argument<Robot, System::Number>;
using Result = decltype(algorithms::AXIAL_PROBE_ALGORITHM::run<Chosen>(std::declval<const Given&>()));
static_assert(sizeof(Result) <= Given::largest_result, "make room for the result in argument.hpp");

}  // namespace
}  // namespace axial::apps::size

/// What is measured, from its first instruction to its return.
extern "C" void axial_kernel(void* argument) {
  using namespace axial::apps::size;
  auto& a = *static_cast<Given*>(argument);
  ::new (static_cast<void*>(a.result)) Result(algorithms::AXIAL_PROBE_ALGORITHM::run<Chosen>(a));
}
