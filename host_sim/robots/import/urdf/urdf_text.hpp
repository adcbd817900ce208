// What a URDF's text must be before urdfdom sees it, and what urdfdom does not hand on.
#pragma once

#include <array>
#include <map>
#include <string>

namespace importer {

/// Throws description::Refused, naming link or joint, value and remedy: an empty file, XML that is malformed or nested
/// too deeply, no robot element, names missing or twice, joints between links that are not there, links with two
/// parents, no root or several, loops, types and mimic joints that are not known.
void check_urdf_text(const std::string& text, const std::string& from);

/// What urdfdom gives back as a quaternion or not at all.
struct WrittenNumbers {
  std::map<std::string, std::array<double, 3>> joint_rpy, inertial_rpy;  ///< rad, by joint and by link, harmless names
  double length_digit = 1e-6;                                            ///< m, of joints' origins
};
/// Of a text that was checked.
WrittenNumbers written_numbers(const std::string& text);

/// The text with a blank limit (all 0) where a joint needs one and has none, or one with parts left out: urdfdom
/// refuses those, and blank ones are taken for not given.
std::string with_blank_limits(const std::string& text);

}  // namespace importer
