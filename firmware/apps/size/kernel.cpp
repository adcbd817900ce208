/// One kernel in a translation unit of its own: the robot by <robot.hpp>, the rest by the build's definitions.

#include <robot.hpp>

#include <new>

#include "algorithms.hpp"

namespace axial::apps::size {
namespace {

using Chosen = scenes::AXIAL_PROBE_SCENE<Robot AXIAL_PROBE_TAGS>;
using Result = decltype(algorithms::AXIAL_PROBE_ALGORITHM::run<Chosen>(std::declval<const Argument<Robot>&>()));
static_assert(sizeof(Result) <= Argument<Robot>::largest_result, "make room for the result in argument.hpp");

}  // namespace
}  // namespace axial::apps::size

/// What is measured, from its first instruction to its return.
extern "C" void axial_kernel(void* argument) {
  using namespace axial::apps::size;
  auto& a = *static_cast<Argument<axial::apps::Robot>*>(argument);
  ::new (static_cast<void*>(a.result)) Result(algorithms::AXIAL_PROBE_ALGORITHM::run<Chosen>(a));
}
