#include <firmware/apps/feedforward/sequence.hpp>

namespace axial::apps {
namespace {

constexpr bool second_is_accepted(std::uint32_t first, std::uint32_t second) {
  Sequence sequence;
  return sequence.accept(first) && sequence.accept(second);
}

static_assert(second_is_accepted(5, 6) && second_is_accepted(5, 500));
static_assert(!second_is_accepted(5, 5) && !second_is_accepted(5, 4));
static_assert(second_is_accepted(0xFFFFFFFF, 0) && !second_is_accepted(0, 0xFFFFFFFF));
static_assert(second_is_accepted(0, 0x7FFFFFFF) && !second_is_accepted(0, 0x80000000));

}  // namespace
}  // namespace axial::apps
