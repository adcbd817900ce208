#include <gtest/gtest.h>
#include <axial/links/model.hpp>
#include <axial/recursion/passes.hpp>
#include <robots/puma560.hpp>

using namespace axial;

namespace {

// Base -> 0 -> 1 -> 2, and 3 branches off 0.
struct Fork {
  static constexpr auto chain =
      axial::chain(revolute().mass(1), revolute().mass(1), revolute().mass(1), revolute().mass(1).parent(0));
};

struct Sum {
  double value = 0.0;
  template <class T>
  constexpr Sum dense() const {
    return *this;
  }
};
constexpr Sum operator+(Sum a, Sum b) { return {a.value + b.value}; }
struct Sent {
  Sum total{};
  Sum on_parent{};
};

template <class Links>
void expect_walks_the_fork(const Links& links) {
  const auto depth = outward(links, Sum{0.0}, [](auto, const Sum& parent) { return Sum{parent.value + 1.0}; });
  const auto size = inward(
      links, [](auto) { return Sum{1.0}; },
      [](auto, const Sum& total) {
        return Sent{total, total};
      });
  const double depths[] = {1, 2, 3, 2}, sizes[] = {4, 2, 1, 1};
  for_each_link(links, [&](auto i) {
    EXPECT_EQ(depth[i].value, depths[i]) << i;
    EXPECT_EQ(size[i].total.value, sizes[i]) << i;
  });
}

}  // namespace

TEST(Passes, WalkATreeUnrolled) { expect_walks_the_fork(links_of<Fork, double>()); }
TEST(Passes, WalkATreeLooped) { expect_walks_the_fork(links_of<Scene<Fork, Looped>, double>()); }

TEST(Passes, MapKeepsTheTypeOfEveryLink) {
  const auto links = links_of<robots::Puma560, float>();
  const auto twists = map_links(links, [&](auto i) { return links.link(i).x(); });
  static_assert(std::is_same_v<decltype(twists[Index<1>{}].sin), MinusOne>, "alpha2 = -90 degrees");
  static_assert(std::is_same_v<decltype(twists[Index<2>{}].cos), One>, "alpha3 = 0");
  SUCCEED();
}
