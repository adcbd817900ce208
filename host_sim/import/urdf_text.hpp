// What a URDF's text must be before urdfdom sees it.
#pragma once

#include <string>

namespace importer {

/// Throws description::Refused, naming link or joint, value and remedy: an empty file, XML that is malformed or nested
/// too deeply, no robot element, names missing or twice, joints between links that are not there, links with two
/// parents, no root or several, loops, types and mimic joints that are not known.
void check_urdf_text(const std::string& text, const std::string& from);

}  // namespace importer
