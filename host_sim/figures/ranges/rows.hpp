// What bounds every quantity of every link in fixed point, in which format it is kept, and how exact it is.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace ranges {

/// Which analysis: a recursion by the name of its algorithm, and how fixed point rounds.
struct Choice {
  std::string algorithm = "inverse_dynamics";  ///< one of algorithms()
  int word = 32;                               ///< bits: 16 or 32
  bool nearest = true;                         ///< or down
  bool high_word = false;                      ///< upper words of products, or all of them
};

/// One quantity of one link: |quantity| <= bound, the norm where it is a vector, and it is kept as an integer times
/// 2^-exponent; where forward dynamics has formats for the declared motion, the solve that must hold everything that
/// efforts can do keeps it 2^halvings times smaller. `error` bounds the difference between the computed and the exact
/// one; absent where no analysis gives it.
struct Row {
  std::string robot;
  int link;  ///< from 0, as in C++
  std::string quantity, unit;
  double bound;
  int exponent;
  std::optional<double> error;
  int halvings = 0;

  double resolution() const { return std::ldexp(1.0, -exponent); }
  /// Where the quantity may reach its bound.
  double coarsest_resolution() const { return std::ldexp(1.0, halvings - exponent); }
};

/// Names of the algorithms whose recursion has an analysis.
std::vector<std::string> algorithms();

/// Names of the robots: all that declare the limits that formats come from; those that an algorithm has formats for.
std::vector<std::string> robots();
std::vector<std::string> robots(const std::string& algorithm);

/// Rows of a robot's bare scene, link by link. Throws std::runtime_error that names what there is when the robot or the
/// algorithm is unknown.
std::vector<Row> rows(const std::string& robot, const Choice& choice);

}  // namespace ranges
