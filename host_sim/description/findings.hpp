// What is wrong, doubtful or missing in a description: link, value, remedy.
#pragma once

#include <host_sim/description/description.hpp>

namespace description {

/// One problem. Errors can not be used (axial would not compile them, or the numbers mean nothing); warnings are
/// bodies that matter can not have, or that leave a joint without resistance: published models in daily use have them.
struct Finding {
  bool error = false;
  std::string link;  ///< empty: the whole robot
  std::string what;  ///< with the value
  std::string remedy;

  std::string text() const;  ///< "link 'x': what; remedy"
};

/// The largest number of metres, kilograms or kg m^2 that is taken for a robot's.
constexpr double largest_number = 1e9;

/// All findings, link by link.
std::vector<Finding> findings(const Description& robot);

/// One link's body alone: mass, centre of mass and inertia about it.
std::vector<Finding> body_findings(const std::string& link, const axial::LinkParameters& p);

/// Lines of the findings that are errors, or of those that are warnings.
std::string lines(const std::vector<Finding>& found, bool errors);

/// Throws Refused with every error; returns the warnings.
std::vector<Finding> check(const Description& robot);

}  // namespace description
