#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/import/xml_text.hpp>

#include <tinyxml.h>

#include <algorithm>
#include <cctype>
#include <system_error>

namespace importer {
namespace {

constexpr int deepest = 200;
constexpr std::ptrdiff_t most_elements = 100000;

bool starts_element(const std::string& text, std::size_t at) {
  return text[at] == '<' && std::isalpha(static_cast<unsigned char>(text[at + 1])) != 0;
}

/// Deepest nesting of elements, judged by brackets alone: the XML parser recurses.
int nesting(const std::string& text) {
  int depth = 0, found = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (starts_element(text, i)) ++depth;
    if ((text[i] == '<' && text[i + 1] == '/') || (text[i] == '/' && text[i + 1] == '>')) --depth;
    found = depth > found ? depth : found;
  }
  return found;
}

/// Behind a comment, a declaration or an instruction that begins here.
std::size_t behind(const std::string& text, std::size_t at) {
  const std::string end = text.compare(at, 4, "<!--") == 0 ? "-->" : ">";
  const auto found = text.find(end, at);
  return found == std::string::npos ? text.size() : found + end.size();
}

}  // namespace

void parse_xml(const std::string& text, const std::string& from, TiXmlDocument& document) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw description::Refused(from + ": the file is empty");
  if (text.find('\0') != std::string::npos)
    throw description::Refused(from + ": not a text; give a URDF, an MJCF, an SDF or a JSON table");
  if (nesting(text) > deepest)
    throw description::Refused(from + ": elements are nested too deeply for a robot's description");
  if (std::count(text.begin(), text.end(), '<') > most_elements)
    throw description::Refused(from + ": has more than " + std::to_string(most_elements) +
                               " elements; give the robot without its surroundings");
  document.Parse(text.c_str());
  if (document.Error())
    throw description::Refused(from + ": malformed XML at line " + std::to_string(document.ErrorRow()) + ", column " +
                               std::to_string(document.ErrorCol()) + ": " + document.ErrorDesc() +
                               " (xacro files are expanded first: xacro robot.urdf.xacro > robot.urdf)");
}

std::filesystem::path included_path(const std::string& place, const std::filesystem::path& folder,
                                    const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path here = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error), path = folder / name,
                 there = fs::weakly_canonical(fs::absolute(path), error), relative = there.lexically_relative(here);
  if (error || fs::path(name).is_absolute() || relative.empty() || *relative.begin() == "..")
    throw description::Refused(place + ": file '" + description::harmless(name) +
                               "' is outside of the folder; put it beside the file that includes it");
  return path;
}

std::string first_element(const std::string& text) {
  for (std::size_t at = text.find('<'); at != std::string::npos && at + 1 < text.size(); at = text.find('<', at)) {
    if (!starts_element(text, at)) {
      at = behind(text, at);
      continue;
    }
    const auto end = text.find_first_of(" \t\r\n/>", at);
    return text.substr(at + 1, std::min(end, text.size()) - at - 1);
  }
  return "";
}

}  // namespace importer
