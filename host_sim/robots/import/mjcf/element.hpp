// The elements of an MJCF with what it includes, each with the place where it stands.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace importer::mjcf {

/// Names and values are printable ASCII, whatever the file has.
struct Element {
  std::string name;
  std::string place;  ///< "arm.xml, line 12"
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<Element> children;

  /// The value of an attribute, or null.
  const std::string* find(const std::string& attribute) const;
};

/// The root of a text, files that it includes in their places. Throws description::Refused for what is no MJCF: no
/// text, malformed or nested too deeply, more elements than any robot has, another root; and for files that are
/// included twice, are not there or lie outside the folder of `from`.
Element read_elements(const std::string& text, const std::string& from);

}  // namespace importer::mjcf
