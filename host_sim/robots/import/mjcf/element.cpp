#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/mjcf/element.hpp>
#include <host_sim/robots/import/xml_text.hpp>

#include <tinyxml.h>

#include <filesystem>
#include <set>
#include <system_error>

namespace importer::mjcf {
namespace {

using description::harmless;
namespace fs = std::filesystem;

class Reader {
 public:
  explicit Reader(const std::string& from) : folder_(fs::path(from).parent_path()) {
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
    const fs::path path = folder_ / name;
    check_inside(place, name, path);
    if (!seen_.insert(fs::path(name).lexically_normal().string()).second)
      refuse(place, "file '" + harmless(name) + "' is included already", "include each file once, and none in itself");
    const Element root = read(description::read_text(path.string()), path.string());
    children.insert(children.end(), root.children.begin(), root.children.end());
  }
  /// A file of the folder or below it, wherever links lead.
  void check_inside(const std::string& place, const std::string& name, const fs::path& path) const {
    std::error_code error;
    const fs::path folder = fs::weakly_canonical(folder_.empty() ? fs::path(".") : folder_, error);
    const fs::path there = fs::weakly_canonical(path, error), relative = there.lexically_relative(folder);
    if (error || fs::path(name).is_absolute() || relative.empty() || *relative.begin() == "..")
      refuse(place, "file '" + harmless(name) + "' is outside of the folder",
             "put it beside the file that includes it");
    if (!fs::is_regular_file(there, error))
      refuse(place, "file '" + harmless(name) + "' is not there", "put it beside the file, or take <include> out");
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

Element read_elements(const std::string& text, const std::string& from) { return Reader(from).read(text, from); }

}  // namespace importer::mjcf
