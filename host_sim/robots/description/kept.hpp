// What somebody wrote into a generated header by hand: lines that end in "// kept" stay when it is written anew.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace description {

/// The calls of such lines, without comments and commas, by the joint below whose comment they stand; "" is the robot
/// as a whole (payload_limit, gravity, ...).
using Kept = std::map<std::string, std::vector<std::string>>;

/// Of a header's text.
Kept kept_lines(const std::string& header);

/// Quantities that lines give: "effort_limit" of ".effort_limit(30.0)". A kept line replaces what a source gives.
std::set<std::string> quantities_of(const std::vector<std::string>& lines);

/// A row of calls without those of some quantities: ".mass(2.0).com(0.1, 0, 0)" without mass is ".com(0.1, 0, 0)".
std::string without(const std::string& row, const std::set<std::string>& quantities);

/// Lines of code of a header that are not in another one, comments and commas aside.
std::vector<std::string> lines_that_are_lost(const std::string& before, const std::string& now);

}  // namespace description
