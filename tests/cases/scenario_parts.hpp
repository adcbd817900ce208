// What the generators of scenarios.hpp share.
#pragma once

#include <cases/scenarios.hpp>
#include <cmath>
#include <oracle/as_float.hpp>

namespace cases::parts {

using oracle::as_float;
inline double power_of_two(int exponent) { return std::ldexp(1.0, exponent); }
inline std::string power(int exponent) { return "2^" + std::to_string(exponent); }
inline std::string named(const char* family, const char* kind, int n) {
  return std::string(family) + "_" + kind + "_N" + std::to_string(n);
}

inline oracle::Mat3<double> diagonal(double xx, double yy, double zz) {
  return oracle::symmetric(xx, yy, zz, 0.0, 0.0, 0.0);
}
/// The inertia of `mass` kg whose figures a kilogram are given.
inline oracle::Mat3<double> slender(double mass, double along, double across) {
  return diagonal(as_float(mass * along), as_float(mass * across), as_float(mass * across));
}

inline oracle::Link<double> body(int parent, double mass, oracle::Vec3<double> com,
                                 const oracle::Mat3<double>& inertia) {
  oracle::Link<double> link;
  link.parent = parent, link.mass = mass, link.com = com, link.inertia = inertia;
  return link;
}

/// A scenario of positions, speeds and efforts zero, with its gates on the forward error.
inline Scenario at_rest(std::string name, oracle::Chain<double> chain, double gate_double, double gate_float) {
  const oracle::Vector<double> zero(chain.links.size(), 0.0);
  Scenario result{std::move(name), std::move(chain), zero, zero, zero, {gate_double}, {gate_float}};
  result.family = "ST" + std::to_string(std::stoi(result.name.substr(1, 2)));
  return result;
}

inline oracle::Vector<double> alternating(int n, double first) {
  oracle::Vector<double> result;
  for (int i = 0; i < n; ++i)
    result.push_back(i % 2 ? -first : first);
  return result;
}

/// The nominal arm of stability scenarios with other masses; the sixth link may be replaced by the caller.
oracle::Chain<double> arm(const double (&masses)[6]);
/// The state that every scenario of the arm starts from.
Scenario at_arm_state(std::string name, oracle::Chain<double> chain, double gate_double, double gate_float);

inline void append(std::vector<Scenario>& all, const std::vector<Scenario>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace cases::parts
