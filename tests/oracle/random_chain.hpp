// Seeded random chains and states for tests. Every number is a float, so that float, double and quad solve one problem.
#pragma once

#include <oracle/as_float.hpp>
#include <oracle/chain.hpp>
#include <random>

namespace oracle {

class RandomChains {
 public:
  explicit RandomChains(unsigned seed) : engine_(seed) {}

  /// Uniform in [low, high], rounded to float. Independent of the standard library's distributions.
  double uniform(double low, double high) {
    const double unit = static_cast<double>(engine_()) / 4294967296.0;
    return as_float(low + (high - low) * unit);
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

  /// Serial chain of n links: mixed joints, right-angle and general twists, positive definite inertias, some rotors.
  Chain<double> chain(int n) {
    Chain<double> result;
    for (int i = 0; i < n; ++i)
      result.links.push_back(link(i - 1));
    result.gravity = point(9.0);
    return result;
  }
  /// The same with random parents: a tree.
  Chain<double> tree(int n) {
    Chain<double> result = chain(n);
    for (int i = 1; i < n; ++i)
      result.links[std::size_t(i)].parent = below(i + 1) - 1;
    return result;
  }
  /// A tree with branch screws, right-angle and general, on most of its links.
  Chain<double> branched_tree(int n) {
    Chain<double> result = tree(n);
    for (auto& link : result.links)
      if (below(4) > 0) link.gamma = twist(), link.b = below(4) > 0 ? uniform(-0.5, 0.5) : 0.0;
    return result;
  }
  Vector<double> vector(int n, double size) {
    Vector<double> result;
    for (int i = 0; i < n; ++i)
      result.push_back(uniform(-size, size));
    return result;
  }
  Wrench<double> wrench(double size) { return {point(size), point(size)}; }

 private:
  Vec3<double> point(double size) {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }
  double twist() {
    const int quarters = below(6) - 1;  // -90, 0, 90 or 180 degrees, or a general angle
    return quarters < 3 ? quarters * right_angle<double>() : uniform(-3.0, 3.0);
  }
  Link<double> link(int parent) {
    Link<double> result;
    result.parent = parent;
    result.type = below(3) == 0 ? Joint::prismatic : Joint::revolute;
    result.alpha = twist(), result.a = uniform(-0.5, 0.5), result.d = uniform(-0.5, 0.5);
    result.theta = uniform(-3.0, 3.0);
    result.mass = uniform(0.25, 8.0), result.com = point(0.25);
    const double xx = uniform(0.05, 0.1), yy = uniform(0.05, 0.1), zz = uniform(0.05, 0.1);
    const double xy = uniform(-0.02, 0.02), xz = uniform(-0.02, 0.02), yz = uniform(-0.02, 0.02);
    result.inertia = symmetric(xx, yy, zz, xy, xz, yz);
    if (below(2) == 0) result.rotor_inertia = uniform(0.0, 0.0002), result.gear = 100.0;
    return result;
  }

  std::mt19937 engine_;
};

}  // namespace oracle
