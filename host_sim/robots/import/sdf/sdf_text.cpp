#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/sdf/sdf_text.hpp>
#include <host_sim/robots/import/xml_text.hpp>

#include <tinyxml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace importer::sdf_text {
namespace {

using description::harmless;
using description::Refused;
namespace fs = std::filesystem;

constexpr int most_parts = 3000;

/// What an element may have: read, read of which there may be several, and left unread; anything else is refused.
struct Rule {
  const char *once, *often, *left;
};
const std::map<std::string, Rule> rules{
    {"sdf", {"", "world model", "light actor"}},
    {"world",
     {"gravity wind", "model frame include",
      "physics atmosphere gui light scene spherical_coordinates state actor plugin road population magnetic_field "
      "audio"}},
    {"model",
     {"pose static enable_wind", "link joint frame model include", "self_collide allow_auto_disable plugin gripper"}},
    {"link",
     {"pose inertial gravity kinematic velocity_decay enable_wind", "",
      "must_be_base_link self_collide collision visual sensor light battery audio_sink audio_source particle_emitter "
      "projector plugin"}},
    {"inertial", {"pose mass inertia", "", ""}},
    {"inertia", {"ixx ixy ixz iyy iyz izz", "", ""}},
    {"joint",
     {"pose parent child axis axis2 thread_pitch screw_thread_pitch gearbox_ratio gearbox_reference_body", "",
      "physics sensor plugin"}},
    {"axis", {"xyz use_parent_model_frame dynamics limit mimic", "", "initial_position"}},
    {"axis2", {"xyz use_parent_model_frame dynamics limit mimic", "", "initial_position"}},
    {"dynamics", {"damping friction spring_reference spring_stiffness", "", ""}},
    {"limit", {"lower upper effort velocity", "", "stiffness dissipation"}},
    {"mimic", {"multiplier offset reference", "", ""}},
    {"frame", {"pose", "", ""}},
    {"include", {"uri name pose static placement_frame", "", "plugin"}},
    {"wind", {"linear_velocity", "", ""}},
    {"velocity_decay", {"linear angular", "", ""}}};

/// How many numbers an element holds: 0 is none of them.
std::size_t numbers_in(const std::string& name, const std::string& above) {
  if (name == "pose") return 6;
  if (name == "gravity") return above == "world" ? 3 : 0;
  static const std::set<std::string> threes{"xyz", "linear_velocity"}, ones{"mass",
                                                                            "ixx",
                                                                            "ixy",
                                                                            "ixz",
                                                                            "iyy",
                                                                            "iyz",
                                                                            "izz",
                                                                            "damping",
                                                                            "friction",
                                                                            "spring_reference",
                                                                            "spring_stiffness",
                                                                            "lower",
                                                                            "upper",
                                                                            "effort",
                                                                            "velocity",
                                                                            "multiplier",
                                                                            "offset",
                                                                            "reference",
                                                                            "linear",
                                                                            "angular"};
  return threes.count(name) != 0 ? 3 : ones.count(name);
}
bool may_be_infinite(const std::string& above) { return above == "limit"; }

bool has_word(const char* words, const std::string& word) {
  return (" " + std::string(words) + " ").find(" " + word + " ") != std::string::npos;
}
std::string attribute(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value != nullptr ? harmless(value) : "";
}
std::string text_of(const TiXmlElement& element) {
  const char* text = element.GetText();
  return text != nullptr ? harmless(text) : "";
}
std::optional<double> number_of(const std::string& word) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  for (const std::string& infinite : {std::string("inf"), std::string("+inf"), std::string("-inf")})
    if (word == infinite) return word[0] == '-' ? -HUGE_VAL : HUGE_VAL;
  double value = 0.0;
  return stream >> value && stream.peek() == std::char_traits<char>::eof() ? std::optional<double>(value)
                                                                           : std::nullopt;
}

/// Files that libsdformat finds: each is written once, where only it is looked for.
class Checker {
 public:
  Checker(const std::string& from, const host_sim::TemporaryFolder& scratch)
      : folder_(fs::path(from).parent_path()), scratch_(scratch) {}

  Checked run(const std::string& text, const std::string& from) {
    std::error_code error;
    above_.push_back(fs::weakly_canonical(from, error));
    result_.text = checked(text, from).text;
    say();
    return result_;
  }

 private:
  struct File {
    std::string text;  ///< as libsdformat gets it
    int parts = 0;     ///< links, joints, frames and models, with those of files that it includes
  };

  [[noreturn]] static void refuse(const std::string& place, const std::string& what, const std::string& remedy) {
    throw Refused(place + ": " + what + "; " + remedy);
  }
  std::string place_of(const TiXmlElement& element) const {
    return file_.back() + ", line " + std::to_string(element.Row());
  }
  /// "arm.sdf, line 12: link 'upper'": the element, or the nearest one around it that has a name.
  std::string here(const TiXmlElement& element) const {
    const auto* named = &element;
    while (attribute(*named, "name").empty() && named->Parent() != nullptr && named->Parent()->ToElement() != nullptr)
      named = named->Parent()->ToElement();
    const std::string name = attribute(*named, "name");
    return place_of(element) + ": " + (name.empty() ? "" : named->ValueStr() + " '" + name + "'") +
           (named == &element ? "" : std::string(name.empty() ? "" : ", ") + "<" + harmless(element.ValueStr()) + ">");
  }

  File checked(const std::string& text, const std::string& from) {
    TiXmlDocument document;
    parse_xml(text, from, document);
    auto* root = document.RootElement();
    if (root == nullptr || root->ValueStr() != "sdf")
      throw Refused(from + ": there is no <sdf> element; give an SDF, by itself what is none");
    file_.push_back(from), parts_.push_back(0);
    check_version(*root);
    check_element(*root);
    // As it was understood here, without what is not read.
    TiXmlPrinter printer;
    printer.SetStreamPrinting();
    document.Accept(&printer);
    File result{printer.Str(), parts_.back()};
    file_.pop_back(), parts_.pop_back();
    return result;
  }
  void check_version(const TiXmlElement& root) const {
    const std::string version = attribute(root, "version");
    const int minor = version.rfind("1.", 0) == 0 ? std::atoi(version.c_str() + 2) : -1;
    if (minor < 4 || minor > 12)
      refuse(place_of(root), "version is '" + version + "'",
             "give an SDF of version 1.4 to 1.12; gz sdf -p writes a newer one of an older one");
  }

  void check_element(TiXmlElement& element) {
    const std::string name = element.ValueStr(),
                      above = element.Parent()->ToElement() != nullptr ? element.Parent()->ToElement()->ValueStr() : "";
    if (name == "link" || name == "joint" || name == "frame" || name == "model") count(element, 1);
    if (name == "include") include(element);
    if (attribute(element, "auto") == "true" || attribute(element, "auto") == "1")
      refuse(here(element), "its mass and inertia are those of its shapes, which are not computed here",
             "give <mass> and <inertia>");
    if (const auto n = numbers_in(name, above); n > 0) check_numbers(element, n, above);
    const auto rule = rules.find(name);
    if (rule == rules.end()) return;
    std::set<std::string> seen;
    TiXmlElement* next = nullptr;
    for (auto* e = element.FirstChildElement(); e != nullptr; e = next) {
      next = e->NextSiblingElement();
      const std::string word = e->ValueStr();
      if (is_left(*e, rule->second, name)) {
        element.RemoveChild(e);
        continue;
      }
      if (!has_word(rule->second.often, word)) {
        if (!has_word(rule->second.once, word))
          refuse(here(*e), "is not known in <" + name + ">",
                 "correct its name, or take it out if no motion depends on it");
        if (!seen.insert(word).second) refuse(here(*e), "stands twice in <" + name + ">", "leave the one that counts");
      }
      check_element(*e);
    }
  }
  /// Whether it is not read, which is said.
  bool is_left(const TiXmlElement& element, const Rule& rule, const std::string& above) {
    const std::string name = element.ValueStr();
    const bool scenery = name == "include" && above == "world" && is_away(element);
    if (name.find(':') == std::string::npos && !has_word(rule.left, name) && !scenery) return false;
    const auto* uri = element.FirstChildElement("uri");
    left_.insert(harmless(name) + (name == "plugin" ? " '" + attribute(element, "filename") + "'"
                                   : scenery        ? " '" + text_of(*uri) + "', which is not there"
                                                    : ""));
    return true;
  }
  void count(const TiXmlElement& element, int parts) {
    parts_.back() += parts;
    if (parts_.back() > most_parts)
      refuse(here(element),
             "is one too many: at most " + std::to_string(most_parts) + " models, links, joints and frames are read",
             "give the robot without its surroundings");
  }

  void check_numbers(const TiXmlElement& element, std::size_t wanted, const std::string& above) {
    const std::string text = text_of(element), name = element.ValueStr();
    const bool quaternion = attribute(element, "rotation_format") == "quat_xyzw";
    wanted = quaternion ? 7 : wanted;
    std::istringstream words(text);
    std::vector<double> values;
    for (std::string word; words >> word;) {
      const auto value = number_of(word);
      if (!value || (!std::isfinite(*value) && !may_be_infinite(above)))
        refuse(here(element), name + " is '" + text + "': '" + word + "' is no number",
               "give numbers as 1.5 with a point and spaces between");
      values.push_back(*value);
    }
    if (values.empty() && name == "pose") return;  // at its place
    if (values.size() != wanted)
      refuse(here(element), name + " is '" + text + "': " + std::to_string(values.size()) + " numbers",
             "give " + std::to_string(wanted));
    if (name == "pose" && !quaternion && attribute(element, "degrees") != "true" &&
        attribute(element, "degrees") != "1")
      check_turns(element, values);
  }
  void check_turns(const TiXmlElement& element, const std::vector<double>& values) {
    for (std::size_t k = 3; k < 6; ++k) {
      if (std::abs(values[k]) <= 6.2832) continue;
      const auto* owner = element.Parent()->ToElement();
      result_.warnings.push_back({false, attribute(*owner, "name"),
                                  "pose is '" + text_of(element) + "', more than a turn: angles are radians",
                                  "give radians, or degrees=\"true\""});
      return;
    }
  }

  // --- files that are included

  static std::string scheme_of(const std::string& uri) {
    const auto end = uri.find("://");
    return end == std::string::npos ? "" : uri.substr(0, end + 3);
  }
  /// Whether it is of the net, or a model of others' folders: beside the robots of a world it is scenery.
  bool is_away(const TiXmlElement& element) const {
    const auto* uri = element.FirstChildElement("uri");
    const std::string name = uri != nullptr ? text_of(*uri) : "", scheme = scheme_of(name);
    if (scheme == "model://") {
      std::error_code error;
      const auto path =
          included_path(place_of(element), models_folder(name.substr(scheme.size())), name.substr(scheme.size()));
      return !fs::exists(path, error);
    }
    return !scheme.empty() && scheme != "file://";
  }
  /// Models lie in the folder of the file, or beside it where it is a model's itself.
  fs::path models_folder(const std::string& name) const {
    std::error_code error;
    const bool beside = fs::exists(folder_ / "model.config", error) && !fs::exists(folder_ / name, error);
    return beside ? (folder_.empty() ? fs::path("..") : folder_ / "..") : folder_;
  }
  void include(TiXmlElement& element) {
    auto* uri = element.FirstChildElement("uri");
    const std::string name = uri != nullptr ? text_of(*uri) : "", place = place_of(element), scheme = scheme_of(name);
    if (name.empty()) refuse(place, "<include> has no <uri>", "give a file, or a folder with a model.config");
    if (!scheme.empty() && scheme != "model://" && scheme != "file://")
      refuse(place, "'" + name + "' is outside of the folder", "put it beside the file that includes it");
    const std::string path = name.substr(scheme.size());
    const fs::path file = file_of(place, scheme == "model://" ? models_folder(path) : folder_, path);
    std::error_code error;
    const fs::path there = fs::weakly_canonical(file, error);
    if (std::find(above_.begin(), above_.end(), there) != above_.end())
      refuse(place, "file '" + path + "' includes itself, by way of others", "take one <include> out");
    auto found = files_.find(there);
    if (found == files_.end()) {
      above_.push_back(there);
      const File read = checked(description::read_text(file.string()), file.string());
      above_.pop_back();
      const std::string copy = scratch_.file(std::to_string(files_.size()) + ".sdf");
      std::ofstream(copy) << read.text;
      found = files_.emplace(there, std::make_pair(copy, read.parts)).first;
    }
    count(element, found->second.second);
    uri->Clear();
    uri->LinkEndChild(new TiXmlText(found->second.first.c_str()));  // the document's
  }
  fs::path file_of(const std::string& place, const fs::path& folder, const std::string& name) const {
    std::error_code error;
    fs::path path = included_path(place, folder, name);
    if (fs::is_directory(path, error))
      path = included_path(place, folder, name + "/" + model_file(place, folder, name));
    if (!fs::is_regular_file(path, error))
      refuse(place, "file '" + name + "' is not there", "put it beside the file, or take <include> out");
    return path;
  }
  /// Of a folder: its model.config names one file per version, the newest last.
  static std::string model_file(const std::string& place, const fs::path& folder, const std::string& name) {
    std::error_code error;
    const fs::path config = included_path(place, folder, name + "/model.config");
    if (!fs::is_regular_file(config, error)) return "model.sdf";
    TiXmlDocument document;
    parse_xml(description::read_text(config.string()), config.string(), document);
    std::string last = "model.sdf";
    if (const auto* root = document.RootElement(); root != nullptr)
      for (auto* e = root->FirstChildElement("sdf"); e != nullptr; e = e->NextSiblingElement("sdf"))
        last = text_of(*e);
    return last;
  }

  void say() {
    std::string all;
    for (const auto& name : left_)
      all += (all.empty() ? "" : ", ") + name;
    if (!all.empty()) result_.notes.push_back("not read: " + all);
  }

  fs::path folder_;
  const host_sim::TemporaryFolder& scratch_;
  std::vector<fs::path> above_;                            ///< files around the one that is read
  std::map<fs::path, std::pair<std::string, int>> files_;  ///< where they are written, and their parts
  std::vector<std::string> file_;
  std::vector<int> parts_;
  std::set<std::string> left_;
  Checked result_;
};

}  // namespace

Checked check(const std::string& text, const std::string& from, const host_sim::TemporaryFolder& folder) {
  return Checker(from, folder).run(text, from);
}

}  // namespace importer::sdf_text
