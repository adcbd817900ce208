// Searches for the inputs that come nearest to a bound: random ones first, then steps from the best.
#pragma once

#include <axial/fixed/balls/vector.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace bounds_test {

using axial::Ball;
using axial::SplitBall;
using Vector = axial::Vec3<double>;

/// Numbers in [-1, 1] that choose one input; each is asked for in turn.
class Choice {
 public:
  static constexpr int most = 64;  ///< numbers that an input may ask for
  double next() { return of_[at_++]; }
  void rewind() { at_ = 0; }
  /// Anything, half of the numbers at an end of their range.
  void draw(std::mt19937_64& random) {
    for (double& x : of_)
      x = held(std::uniform_real_distribution<double>(-2.0, 2.0)(random));
  }
  void step(std::mt19937_64& random, double size) {
    for (double& x : of_)
      if (random() % 4 == 0) x = held(x + std::normal_distribution<double>(0.0, size)(random));
  }

 private:
  static double held(double x) { return std::fmin(1.0, std::fmax(-1.0, x)); }
  std::array<double, most> of_{};
  int at_ = 0;
};

/// A vector and its computed value, each within a bound and its error; at full length where the choice is at an end.
struct Sample {
  Vector exact{}, computed{};
};

inline Vector vector_within(double across, double along, double whole, Choice& choice) {
  const double angle = M_PI * choice.next(), radius = across * choice.next(), z = along * choice.next();
  const double norm = std::hypot(radius, z), fit = norm > whole ? whole / norm : 1.0;
  return {radius * std::cos(angle) * fit, radius * std::sin(angle) * fit, z * fit};
}
inline Vector plus(const Vector& u, const Vector& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
inline Vector minus(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
inline Sample sample(const SplitBall& b, Choice& choice) {
  const Vector exact = vector_within(b.across.size, b.along.size, b.whole.size, choice);
  return {exact, plus(exact, vector_within(b.across.error, b.along.error, b.whole.error, choice))};
}
struct Scalar {
  double exact = 0.0, computed = 0.0;
};
inline Scalar sample(const Ball& b, Choice& choice) {
  const double exact = b.size * choice.next();
  return {exact, exact + b.error * choice.next()};
}

/// How near a result comes to each part of its bound, sizes first, then errors.
struct Nearness {
  std::array<double, 6> of{};
};
inline double ratio(double value, double bound) { return bound > 0.0 ? value / bound : value > 1e-14 ? 1e9 : 0.0; }
inline double across(const Vector& v) { return std::hypot(v.x, v.y); }
inline double whole(const Vector& v) { return std::hypot(across(v), v.z); }
inline Nearness nearness(const SplitBall& b, const Vector& exact, const Vector& computed) {
  const Vector off = minus(computed, exact);
  return {{ratio(across(exact), b.across.size), ratio(std::fabs(exact.z), b.along.size),
           ratio(whole(exact), b.whole.size), ratio(across(off), b.across.error),
           ratio(std::fabs(off.z), b.along.error), ratio(whole(off), b.whole.error)}};
}

/// The largest nearness of each part that a search finds, whatever the inputs. `run(choice)` gives a Nearness.
template <class Run>
Nearness climb(const Run& run, std::uint64_t seed, int starts = 400, int steps = 60) {
  std::mt19937_64 random(seed);
  Nearness best;
  const auto at = [&run](Choice& choice) {
    choice.rewind();
    return run(choice);
  };
  for (std::size_t part = 0; part < best.of.size(); ++part) {
    Choice top;
    double reached = 0.0;
    for (int start = 0; start < starts; ++start) {
      Choice choice;
      choice.draw(random);
      if (const double r = at(choice).of[part]; r > reached) reached = r, top = choice;
    }
    for (int step = 0; step < steps; ++step) {
      Choice choice = top;
      choice.step(random, 0.3 * std::pow(0.95, step));
      if (const double r = at(choice).of[part]; r > reached) reached = r, top = choice;
    }
    best.of[part] = reached;
  }
  return best;
}

/// Bounds of random shape: some parts zero, some a thousand times others.
inline SplitBall any_bound(std::mt19937_64& random) {
  const auto size = [&random] {
    const double x = std::uniform_real_distribution<double>(-3.0, 1.0)(random);
    return random() % 3 == 0 ? 0.0 : std::pow(10.0, x);
  };
  const auto error = [&](double largest) { return 1e-3 * largest * (random() % 3 == 0 ? 0.0 : size()); };
  const double a = size(), b = size();
  const Ball across{a, error(1.0)}, along{b, error(1.0)};
  return axial::detail::split(across, along);
}

/// No result exceeds its bound, whatever the shapes of the inputs' bounds, and the nearest comes to `near` of each
/// part; `search(random)` draws the bounds and climbs.
template <class Search>
void expect_bounds(const Search& search, double near, int shapes = 60) {
  std::mt19937_64 random(20261123);
  Nearness nearest;
  for (int shape = 0; shape < shapes; ++shape) {
    const Nearness seen = search(random);
    for (std::size_t part = 0; part < nearest.of.size(); ++part) {
      EXPECT_LE(seen.of[part], 1.0 + 1e-6) << "part " << part << ", shape " << shape;
      nearest.of[part] = std::fmax(nearest.of[part], seen.of[part]);
    }
  }
  for (std::size_t part = 0; part < nearest.of.size(); ++part)
    EXPECT_GE(nearest.of[part], near) << "no input comes near part " << part << " of the bound";
}

}  // namespace bounds_test
