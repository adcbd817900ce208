// An SDF's text before libsdformat reads it: what it does not say well, follows anywhere, or passes over.
#pragma once

#include <host_sim/robots/description/findings.hpp>
#include <host_sim/tools/system/temporary_folder.hpp>

#include <string>
#include <vector>

namespace importer::sdf_text {

/// A text that libsdformat may read: what is not read is taken out, files that are included stand in `folder`, each
/// checked like the text itself.
struct Checked {
  std::string text;
  std::vector<std::string> notes;              ///< what is not read
  std::vector<description::Finding> warnings;  ///< angles that are more than a turn
};

/// Throws description::Refused with file, line, element, value and remedy: another format or an old version, elements
/// that are not known or stand twice, what is no number, more links than are imported, files outside of the folder of
/// `from`, or in circles.
Checked check(const std::string& text, const std::string& from, const host_sim::TemporaryFolder& folder);

}  // namespace importer::sdf_text
