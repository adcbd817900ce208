// What is wrong, doubtful or missing in a description: link, value, remedy.
#pragma once

#include <host_sim/robots/description/description.hpp>

namespace description {

/// One problem. Errors cannot be used: the numbers mean nothing. Of warnings, some must be accepted: axial compiles
/// such a link only with `.accept(axial::as_published)`; the others miss by little what matter can have, or leave a
/// joint without resistance.
struct Finding {
  bool error = false;
  std::string link;  ///< empty: the whole robot
  std::string what;  ///< with the value
  std::string remedy;
  bool must_be_accepted = false;  ///< and the description does not say yet that it is kept as published

  std::string text() const;  ///< "link 'x': what; remedy"
};

/// The largest number of metres, kilograms or kg m^2 that is taken for a robot's.
constexpr double largest_number = 1e9;
inline bool usable(double value) { return value >= -largest_number && value <= largest_number; }  // false for NaN

/// All findings, link by link.
std::vector<Finding> findings(const Description& robot);

/// One link's body alone: mass, centre of mass and inertia about it.
std::vector<Finding> body_findings(const std::string& link, const axial::LinkParameters& p, bool as_published);

/// Whether axial compiles this link, as a header writes it, only with `.accept(axial::as_published)`.
bool needs_acceptance(const axial::LinkParameters& p);

/// Whether base, tool or reach of the payload do.
bool frames_are_far(const Description& robot);

/// What to do about numbers that no robot should have, or that they are kept.
std::string correct_or_keep(bool as_published, const std::string& correct);

/// Lines of the findings that must be accepted.
std::string lines_to_accept(const std::vector<Finding>& found);

/// Lines of the findings that are errors, or of those that are warnings.
std::string lines(const std::vector<Finding>& found, bool errors);

/// Throws Refused with every error; returns the warnings.
std::vector<Finding> check(const Description& robot);

}  // namespace description
