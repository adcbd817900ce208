// Random arms of the kinds that eliminations lose digits on: rods, heavy and light tips, alternating masses,
// near-coaxial and near-gimbal wrists, slides, trees, rotors, links of very unequal scale.
#pragma once

#include <axial/axial.hpp>
#include <cmath>
#include <oracle/random_chain.hpp>
#include <vector>

namespace property {

enum class Family { arm, rods, heavy_tip, light_tip, alternating, coaxial, gimbal, slides, tree, rotors, scales };
inline constexpr int families = 11;
inline constexpr const char* family_names[families] = {
    "arm", "rods", "heavy tip", "light tip", "alternating", "coaxial", "gimbal", "slides", "tree", "rotors", "scales"};

/// A chain's description: its links, base first, and free fall.
struct Description {
  std::vector<axial::Link> links;
  double gravity[3] = {0.0, 0.0, -9.81};
};

/// Makes them, seeded.
class Arms {
 public:
  explicit Arms(unsigned seed) : random_(seed) {}

  Description arm(Family family, int n) {
    Description result;
    if (random_.below(2) == 0) result.gravity[1] = -9.81, result.gravity[2] = 0.0;
    planar_ = random_.below(2) == 0;
    for (int i = 0; i < n; ++i)
      result.links.push_back(link(family, i, n));
    return result;
  }
  double uniform(double low, double high) { return random_.uniform(low, high); }
  double over_decades(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

 private:
  axial::Link link(Family family, int i, int n) {
    switch (family) {
      case Family::rods:
      case Family::heavy_tip:
      case Family::light_tip:
      case Family::alternating:
        return rod(family, i, n);
      case Family::coaxial:
        return wrist(i, i < 3 ? uniform(0.05, 0.4) : 0.0, i < 3 ? twist() : over_decades(1e-2, 10.0));
      case Family::gimbal:
        return wrist(i, i > 0 && i < 3 ? uniform(0.1, 0.4) : 0.0, i == 0 ? 0.0 : i % 2 == 0 ? 90.0 : -90.0);
      default:
        return general(family, i);
    }
  }
  double twist() {
    const int quarters = random_.below(6);  // 0 twice as often as a right angle of either sign; else oblique
    return quarters < 2 ? 0.0 : quarters == 2 ? 90.0 : quarters == 3 ? -90.0 : uniform(-179.0, 179.0);
  }
  static axial::Link box(const axial::Link& link, double mass, double x, double y, double z) {
    return link.mass(mass).inertia_com(mass * (y * y + z * z), mass * (x * x + z * z), mass * (x * x + y * y));
  }
  axial::Link rod(Family family, int i, int n) {
    double mass = 1.0;
    if (family == Family::heavy_tip && i + 1 == n) mass = over_decades(2.0, 100.0);
    if (family == Family::light_tip && i + 1 == n) mass = over_decades(1e-3, 0.5);
    if (family == Family::alternating && i % 2 == 1) mass = over_decades(5.0, 100.0);
    const double turn = i == 0 || planar_ ? 0.0 : i % 2 == 1 ? 90.0 : -90.0;
    return axial::revolute()
        .a(i > 0 ? 1.0 : 0.0)
        .alpha_deg(turn)
        .mass(mass)
        .com(0.5, 0.0, 0.0)
        .inertia_com(mass / 1024.0, mass / 12.0, mass / 12.0);
  }
  axial::Link wrist(int i, double a, double alpha_deg) {
    const double mass = i < 3 ? over_decades(1.0, 10.0) : over_decades(0.05, 2.0);
    const auto at = axial::revolute().a(a).alpha_deg(alpha_deg).d(i == 3 ? uniform(0.1, 0.4) : 0.0);
    return box(at, mass, uniform(0.02, 0.1), uniform(0.02, 0.1), uniform(0.02, 0.1))
        .com(i < 3 ? uniform(0.0, 0.3) : uniform(-0.01, 0.01), 0.0, uniform(-0.05, 0.05));
  }
  axial::Link general(Family family, int i) {
    const bool slide = random_.below(100) < (family == Family::slides ? 60 : 15);
    const double scale = family == Family::scales ? over_decades(0.01, 100.0) : 1.0,
                 mass = scale * over_decades(0.2, 10.0);
    const double size = family == Family::scales ? over_decades(0.05, 1.0) : 0.3;
    auto at = (slide ? axial::prismatic().position_limits(-0.5, 0.5) : axial::revolute())
                  .a(i > 0 && random_.below(2) == 0 ? uniform(-0.5, 0.5) : 0.0)
                  .d(random_.below(2) == 0 ? uniform(-0.5, 0.5) : 0.0)
                  .alpha_deg(i > 0 ? twist() : 0.0);
    if (family == Family::rotors) at = at.rotor_inertia(mass * over_decades(0.01, 1.0), 1.0);
    if (family == Family::tree && i > 1 && random_.below(5) < 2)
      at = at.parent(random_.below(i)).branch_deg(uniform(-179.0, 179.0), uniform(0.0, 0.3));
    return box(at, mass, uniform(0.05, 0.2), uniform(0.05, 0.2), uniform(0.05, 0.2))
        .com(uniform(-size, size), uniform(-size, size), uniform(-size, size));
  }

  oracle::RandomChains random_;
  bool planar_ = false;
};

}  // namespace property
