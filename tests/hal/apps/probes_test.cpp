// What images and the host share to ask kernels: words nearest to numbers, corners, the scene of a run.
#include <firmware/apps/kernels/corners.hpp>
#include <firmware/apps/number_systems.hpp>
#include <firmware/apps/run/scene.hpp>

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace axial::apps {
namespace {

constexpr auto most = std::numeric_limits<std::int16_t>::max(), least = std::numeric_limits<std::int16_t>::min();
constexpr std::int16_t word(double value, int exponent) { return nearest_raw<std::int16_t>(value, exponent); }

static_assert(word(1.25, 3) == 10 && word(-1.25, 3) == -10 && word(5.0, -1) == 3 && word(-5.0, -1) == -3);
static_assert(word(32766.4, 0) == 32766 && word(-32767.4, 0) == -32767);
static_assert(word(32767.0, 0) == most && word(1e9, 0) == most && word(1.0, 15) == most);
static_assert(word(-32768.0, 0) == least && word(-1e9, 0) == least && word(-1.0, 15) == least);

constexpr double half_turn = 3.14159265358979323846;
static_assert(nearest_bam(0.0) == 0 && nearest_bam(half_turn / 2) == 0x40000000 &&
              nearest_bam(-half_turn / 4) == -0x20000000);
static_assert(nearest_bam(half_turn) == std::numeric_limits<std::int32_t>::min(), "half a turn either way");
static_assert(nearest_bam(2.5 * half_turn) == 0x40000000 && nearest_bam(-1.5 * half_turn) == 0x40000000);

/// A joint of each kind of resistance beside one that has none.
template <class Change>
struct OneJoint {
  static constexpr auto chain = axial::chain(revolute().mass(1.0), Change::of(revolute().a(0.5).mass(1.0)));
};
struct None {
  static constexpr Link of(Link link) { return link; }
};
struct Viscous {
  static constexpr Link of(Link link) { return link.viscous(0.5); }
};
struct Stribeck {
  static constexpr Link of(Link link) { return link.coulomb(1.0).stribeck(1.5, 0.1); }
};
struct Smooth {
  static constexpr Link of(Link link) { return link.coulomb(1.0).smooth_speed(0.01); }
};
struct Sprung {
  static constexpr Link of(Link link) { return link.spring(10.0, 0.1); }
};
template <class Change>
constexpr bool floats_friction = run::with_friction<OneJoint<Change>, false>;
template <class Change>
constexpr bool fixes_friction = run::with_friction<OneJoint<Change>, true>;

static_assert(!floats_friction<None> && !fixes_friction<None> && !floats_friction<Sprung>);
static_assert(floats_friction<Viscous> && fixes_friction<Viscous>);
static_assert(floats_friction<Stribeck> && !fixes_friction<Stribeck>, "fixed point has no such curve");
static_assert(floats_friction<Smooth> && !fixes_friction<Smooth>);
static_assert(run::with_springs<OneJoint<Sprung>, false> && !run::with_springs<OneJoint<Sprung>, true>);
static_assert(!run::with_springs<OneJoint<Viscous>, false>);

std::uint32_t bits(float x) {
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

TEST(Corners, AreAllDrawnAndTheLimitsToo) {
  constexpr float limit = 12.5F;  // no corner
  std::set<std::uint32_t> expected{bits(limit), bits(-limit)}, drawn;
  for (const float corner : kernels::corners)
    expected.insert(bits(corner));
  Random random(20261127u);
  for (int k = 0; k < 10000; ++k)
    drawn.insert(bits(kernels::next_corner(random, limit)));
  EXPECT_EQ(drawn, expected);
}

}  // namespace
}  // namespace axial::apps
