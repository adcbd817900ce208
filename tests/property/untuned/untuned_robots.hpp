// Forty robots that nobody tuned for, drawn by the compiler: chains of one to eight joints with slides and oblique
// twists, from grams and millimetres to tonnes, very unequal limits, massless links with rotors, and arms of the
// stability scenarios with limits.
#pragma once

#include <axial/fixed.hpp>

namespace property {

/// splitmix64 (Steele, Lea and Flood 2014), for the compiler.
class Draw {
 public:
  constexpr explicit Draw(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15U + 12345U) {}
  constexpr double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }
  /// As likely in every octave: 10^uniform, by powers of two and a linear piece between them.
  constexpr double over_decades(double low, double high) {
    int octaves = 0;
    for (double x = low; x * 2.0 <= high; x *= 2.0)
      ++octaves;
    const double place = uniform(0.0, octaves + 0.999);
    const int whole = static_cast<int>(place);
    const double x = low * axial::detail::power_of_two(whole) * (1.0 + (place - whole));
    return x < high ? x : high;
  }
  constexpr int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }

 private:
  constexpr std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

/// What a drawn robot is like: its links' masses (kg) and sizes (m), each link's own or one for all, and its limits.
struct Kind {
  const char* name;
  double mass_low, mass_high, size_low, size_high;
  bool alike;            ///< whether one draw of size and mass serves all links
  double unequal;        ///< how far limits of joints may be apart, and efforts from what motions need
  int massless_percent;  ///< of links that have a rotor and nothing else
  int slides_percent;    ///< of joints
  bool rotors;           ///< whether every joint has one
};
inline constexpr Kind kinds[] = {{"arm", 0.5, 10.0, 0.1, 0.6, false, 2.0, 0, 15, false},
                                 {"small", 1e-3, 2e-2, 1e-3, 2e-2, false, 2.0, 0, 15, false},
                                 {"crane", 300.0, 2e4, 0.5, 5.0, false, 2.0, 0, 25, false},
                                 {"scales", 1e-2, 100.0, 0.02, 1.0, false, 4.0, 0, 20, false},
                                 {"unequal", 0.2, 10.0, 0.1, 0.6, false, 100.0, 0, 15, true},
                                 {"massless", 0.2, 10.0, 0.05, 0.5, false, 4.0, 40, 10, true},
                                 {"geared", 0.2, 10.0, 0.1, 0.5, true, 4.0, 0, 15, true}};

constexpr double twist_of(Draw& draw) {
  const int quarters = draw.below(6);
  return quarters < 2 ? 0.0 : quarters == 2 ? 90.0 : quarters == 3 ? -90.0 : draw.uniform(-179.0, 179.0);
}

/// Link i of n of a robot of a kind; its efforts are not limited yet.
constexpr axial::Link drawn_link(const Kind& kind, std::uint64_t seed, int i, int n) {
  Draw common(seed), draw(seed * 64 + 1 + static_cast<std::uint64_t>(i));
  Draw& scale = kind.alike ? common : draw;
  const double mass = scale.over_decades(kind.mass_low, kind.mass_high);
  const double size = scale.over_decades(kind.size_low, kind.size_high);
  const bool slide = draw.below(100) < kind.slides_percent;
  const bool massless = i + 1 < n && draw.below(100) < kind.massless_percent;
  auto link = (slide ? axial::prismatic().position_limits(-size, size) : axial::revolute().position_limits(-3.0, 3.0))
                  .a(i > 0 && draw.below(3) > 0 ? draw.uniform(-size, size) : 0.0)
                  .d(draw.below(2) == 0 ? draw.uniform(-size, size) : 0.0)
                  .alpha_deg(i > 0 ? twist_of(draw) : 0.0);
  const double x = draw.uniform(0.1, 0.5) * size, y = draw.uniform(0.1, 0.5) * size, z = draw.uniform(0.1, 0.5) * size;
  if (!massless)
    link = link.accept(axial::as_published)  // a crane's boom is beyond 1000 kg
               .mass(mass)
               .com(draw.uniform(-size, size), draw.uniform(-size, size), draw.uniform(-size, size))
               .inertia_com(mass * (y * y + z * z), mass * (x * x + z * z), mass * (x * x + y * y));
  const double inertia = slide ? mass : mass * size * size;
  if (kind.rotors || massless) link = link.rotor_inertia(inertia * draw.over_decades(0.01, 1.0), 1.0);
  const double spread = draw.over_decades(1.0 / kind.unequal, kind.unequal);
  const double speed = draw.over_decades(0.5, 4.0) * spread, pull = draw.over_decades(4.0, 40.0) * spread;
  return link.speed_limit(slide ? speed * size : speed).acceleration_limit(slide ? pull * size : pull);
}

/// Effort that a motion inside the limits needs of a joint, at most.
template <class Robot>
struct Needs {
  static constexpr auto ranges = axial::newton_euler_ranges(
      axial::mechanism_of<axial::scene_of<Robot>, axial::FullParameters>, axial::detail::joint_rounding<std::int32_t>);
  static constexpr double of(int i) { return ranges.range[i].joint_effort.size; }
};

/// A robot of kind K with N joints, without limits of its efforts.
template <int K, int N, int Seed>
struct Unlimited {
  static constexpr axial::Link link(int i) {
    return drawn_link(kinds[K], static_cast<std::uint64_t>(1000 * K + Seed), i, N);
  }
  template <int... I>
  static constexpr auto chain_of(std::integer_sequence<int, I...>) {
    return axial::chain(axial::gravity(0.0, Seed % 2 == 0 ? -9.81 : 0.0, Seed % 2 == 0 ? 0.0 : -9.81), link(I)...);
  }
  static constexpr auto chain = chain_of(std::make_integer_sequence<int, N>{});
};

/// The same with limits: a part or a multiple of what motions need.
template <int K, int N, int Seed>
struct Drawn {
  static constexpr const char* name = kinds[K].name;
  static constexpr axial::Link link(int i) {
    Draw draw(static_cast<std::uint64_t>(Seed * 977 + K * 31 + i));
    const double share = draw.over_decades(0.3, 1.5 * kinds[K].unequal);
    return Unlimited<K, N, Seed>::link(i).effort_limit(Needs<Unlimited<K, N, Seed>>::of(i) * share);
  }
  template <int... I>
  static constexpr auto chain_of(std::integer_sequence<int, I...>) {
    return axial::chain(axial::gravity(0.0, Seed % 2 == 0 ? -9.81 : 0.0, Seed % 2 == 0 ? 0.0 : -9.81), link(I)...);
  }
  static constexpr auto chain = chain_of(std::make_integer_sequence<int, N>{});
};

/// The limits of a scenario's arm, the same for all of its joints.
constexpr axial::Link limited(const axial::Link& link, double speed, double acceleration, double effort) {
  return link.position_limits(-2.0, 2.0).speed_limit(speed).acceleration_limit(acceleration).effort_limit(effort);
}

/// The six-jointed arm of the stability scenarios. Variants: 4 a heavy tip (ST4), 5 a light one (ST5), 8 rotors (ST8);
/// the number is the tip's mass or the rotors' inertia as an exponent of 2.
template <int Variant, int Exponent>
struct SixJoints {
  static constexpr const char* name = Variant == 4 ? "S04" : Variant == 5 ? "S05" : "S08";
  static constexpr axial::Link link(int i) {
    constexpr double a[] = {0.0, 0.0625, 0.4375, 0.0625, 0.0, 0.0}, d[] = {0.5, 0.0, 0.125, 0.4375, 0.0, 0.125};
    constexpr int quarters[] = {0, 1, 0, 1, -1, 1};
    constexpr double masses[] = {8.0, 6.0, 4.0, 2.0, 1.0, 0.5};
    constexpr double given = axial::detail::power_of_two(Exponent);
    const double m = Variant == 8 ? masses[i] : i == 5 ? given : Variant == 4 ? 0x1p-10 : masses[i];
    auto joint = axial::revolute().alpha_deg(90 * quarters[i]).a(a[i]).d(d[i]).mass(m);
    joint = limited(joint, 2.0,
                    Variant == 4                   ? 256.0
                    : Variant == 8 && Exponent > 5 ? 0.0625
                                                   : 32.0,
                    Variant == 4 ? 8.0 : 64.0);
    if (Variant == 8) joint = joint.rotor_inertia(given, 1.0);
    const double com = Variant == 4 ? 0.125 : 0.015625, across = m * com * com;
    if (i == 5 && Variant != 8) return joint.com(0.0, 0.0, com).inertia_com(across, across, across / 2);
    return joint.com(0.0625, -0.03125, 0.125).inertia_com(m / 384.0, m * 5.0 / 768.0, m * 5.0 / 768.0);
  }
  static constexpr auto chain =
      axial::chain(axial::gravity(0.0, 0.0, -9.8125), link(0), link(1), link(2), link(3), link(4), link(5));
};

/// The wrist of ST6: two massless links with rotors of 2^Exponent kg m^2 and a body of a kilogram.
template <int Exponent>
struct Wrist {
  static constexpr const char* name = "S06";
  static constexpr axial::Link link(int i) {
    const auto joint =
        limited(axial::revolute().alpha_deg(i == 0 ? 0 : -90).rotor_inertia(axial::detail::power_of_two(Exponent), 1.0),
                2.0, 16.0, 16.0);
    return i < 2 ? joint : joint.mass(1.0).com(0.5, 0.25, 0.0).inertia_com(1.0, 1.0, 1.0);
  }
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.8125, 0.0), link(0), link(1), link(2));
};

/// Heavy and light links in turn, ST16: 2^10 and 2^-10 kg.
template <int N>
struct HeavyAndLight {
  static constexpr const char* name = "S16";
  static constexpr axial::Link link(int i) {
    const double m = axial::detail::power_of_two(i % 2 == 0 ? -10 : 10);
    return limited(axial::revolute().a(i == 0 ? 0.0 : 0.5).alpha_deg(i % 3 == 1 ? 90 : 0), 1.0, 16.0, 65536.0)
        .mass(m)
        .com(0.25, 0.0, 0.0625)
        .inertia_com(m / 384.0, m * 17.0 / 768.0, m * 17.0 / 768.0)
        .accept(axial::as_published);  // of 1 024 kg
  }
  template <int... I>
  static constexpr auto chain_of(std::integer_sequence<int, I...>) {
    return axial::chain(axial::gravity(0.0, -9.8125, 0.0), link(I)...);
  }
  static constexpr auto chain = chain_of(std::make_integer_sequence<int, N>{});
};

}  // namespace property
