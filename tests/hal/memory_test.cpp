#include <hal/memory.hpp>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace axial::hal {
namespace {

/// A stack of `size` words, of which the last `used` were written to.
std::vector<std::uint32_t> stack(std::size_t size, std::size_t used) {
  std::vector<std::uint32_t> words(size, stack_paint);
  std::fill(words.end() - static_cast<std::ptrdiff_t>(used), words.end(), 0u);
  return words;
}

TEST(StackMeter, FindsTheDeepestWordAgainAndAgainAndLooksAtAPartACall) {
  constexpr std::size_t part = 128;
  for (const std::size_t free : {std::size_t{0}, std::size_t{1}, part - 1, part, part + 1, 7 * part}) {
    std::vector<std::uint32_t> words = stack(free + 200, 200);
    StackMeter meter(words.data(), words.data() + words.size());
    for (const std::size_t used : {std::size_t{200}, free + 200}) {
      words[words.size() - used] = 0;
      std::uint32_t bytes = 0;
      std::size_t looks = 1;
      while (!meter.look(bytes))
        ++looks;
      EXPECT_EQ(bytes, 4 * used);
      EXPECT_EQ(looks, (words.size() - used) / part + 1);
    }
  }
}

TEST(StackMeter, NothingUsedIsNothing) {
  const std::vector<std::uint32_t> words = stack(100, 0);
  std::uint32_t bytes = 1;
  EXPECT_TRUE(StackMeter(words.data(), words.data() + words.size()).look(bytes));
  EXPECT_EQ(bytes, 0u);
}

}  // namespace
}  // namespace axial::hal
