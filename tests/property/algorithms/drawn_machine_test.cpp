// Two machines of robots/gallery that the commit draws (AXIAL_DRAWN); gallery_test.cpp has all.
#include <tuple>

#include "machines.hpp"

#ifndef AXIAL_DRAWN
#define AXIAL_DRAWN 0U  // a mutant is compiled without the build
#endif

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

template <class Robot>
void expect_couplings_by_hand() {
  const auto wanted = constrained::by_hand<Robot>();
  constexpr const auto& found = axial::detail::drive_matrix<Robot>;
  ASSERT_EQ(found.drives, wanted.g.columns());
  for (int i = 0; i < wanted.g.rows(); ++i)
    for (int k = 0; k < wanted.g.columns(); ++k)
      EXPECT_EQ(found.ratio[i][k], static_cast<double>(wanted.g(i, k))) << Robot::name << ", joint " << i;
}

}  // namespace

TEST(MachinesThatShareDrives, AreCoupledAsTheirFilesSay) {
  expect_couplings_by_hand<robots::Robotiq2f85>();
  expect_couplings_by_hand<robots::Mg400>();
}

}  // namespace property
