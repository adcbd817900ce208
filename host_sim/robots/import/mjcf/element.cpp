#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/mjcf/element.hpp>
#include <host_sim/robots/import/xml_text.hpp>

#include <tinyxml.h>

#include <filesystem>
#include <set>

namespace importer::mjcf {
namespace {

using description::harmless;
namespace fs = std::filesystem;

class FileReader {
 public:
  explicit FileReader(const std::string& from) : folder_(fs::path(from).parent_path()) {
    seen_.insert(fs::path(from).filename().string());
  }

  Element read(const std::string& text, const std::string& from) {
    TiXmlDocument document;
    parse_xml(text, from, document);
    const auto* root = document.RootElement();
    const std::string name = root != nullptr ? root->ValueStr() : "";
    if (name != "mujoco" && name != "mujocoinclude")
      throw description::Refused(from + ": there is no <mujoco> element; give an MJCF");
    return converted(*root, from);
  }

 private:
  [[noreturn]] static void refuse(const std::string& place, const std::string& what, const std::string& remedy) {
    throw description::Refused(place + ": " + what + "; " + remedy);
  }
  Element converted(const TiXmlElement& given, const std::string& from) {
    if (++count_ > 100000)
      refuse(from, "has more than 100000 elements with what it includes", "give the robot without its surroundings");
    Element result{harmless(given.ValueStr()), from + ", line " + std::to_string(given.Row()), {}, {}};
    for (const auto* a = given.FirstAttribute(); a != nullptr; a = a->Next())
      result.attributes.emplace_back(harmless(a->Name()), harmless(a->ValueStr()));
    for (const auto* e = given.FirstChildElement(); e != nullptr; e = e->NextSiblingElement())
      if (e->ValueStr() == "include")
        include(*e, result.place, from, result.children);
      else
        result.children.push_back(converted(*e, from));
    return result;
  }
  void include(const TiXmlElement& given, const std::string& above, const std::string& from,
               std::vector<Element>& children) {
    const char* file = given.Attribute("file");
    const std::string place = from + ", line " + std::to_string(given.Row()), name = file != nullptr ? file : "";
    if (name.empty()) refuse(place, "<include> has no file", "give file=\"...\", a file beside " + above);
    const fs::path path = included_path(place, folder_, name);
    if (!fs::is_regular_file(path))
      refuse(place, "file '" + harmless(name) + "' is not there", "put it beside the file, or take <include> out");
    if (!seen_.insert(fs::path(name).lexically_normal().string()).second)
      refuse(place, "file '" + harmless(name) + "' is included already", "include each file once, and none in itself");
    const Element root = read(description::read_text(path.string()), path.string());
    children.insert(children.end(), root.children.begin(), root.children.end());
  }
  fs::path folder_;
  std::set<std::string> seen_;
  int count_ = 0;
};

}  // namespace

const std::string* Element::find(const std::string& attribute) const {
  for (const auto& entry : attributes)
    if (entry.first == attribute) return &entry.second;
  return nullptr;
}

Element read_elements(const std::string& text, const std::string& from) { return FileReader(from).read(text, from); }

}  // namespace importer::mjcf
