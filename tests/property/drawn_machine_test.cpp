// Two machines of robots/gallery that the commit draws (AXIAL_DRAWN); gallery_test.cpp has all.
#include <tuple>

#include "machines.hpp"

namespace property {
namespace {

template <class... All>
auto drawn(robots::List<All...>) {
  constexpr std::size_t n = sizeof...(All), first = AXIAL_DRAWN % n;
  using Every = std::tuple<All...>;
  return testing::Types<std::tuple_element_t<first, Every>, std::tuple_element_t<(first + n / 2) % n, Every>>{};
}
using Machines = decltype(drawn(robots::Gallery{}));
INSTANTIATE_TYPED_TEST_SUITE_P(Drawn, Machine, Machines, RobotName);

}  // namespace
}  // namespace property
