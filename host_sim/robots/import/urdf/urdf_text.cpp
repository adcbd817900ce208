#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/import/right_angles.hpp>
#include <host_sim/robots/import/urdf/urdf_text.hpp>
#include <host_sim/robots/import/xml_text.hpp>

#include <tinyxml.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <set>
#include <sstream>

namespace importer {
namespace {

using description::harmless;

/// What of an element, or below it, only xacro understands; empty for a URDF. One that xacro has expanded may still
/// declare its namespace.
std::string xacro_in(const TiXmlElement& element) {
  if (element.ValueStr().rfind("xacro:", 0) == 0) return "<" + element.ValueStr() + ">";
  for (const auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next())
    for (const char* begin : {"${", "$("})
      if (attribute->ValueStr().find(begin) != std::string::npos)
        return std::string(attribute->Name()) + "=\"" + attribute->ValueStr() + "\"";
  for (const auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    if (const std::string found = xacro_in(*child); !found.empty()) return found;
  return "";
}

class Checker {
 public:
  Checker(const TiXmlElement& robot, const std::string& from) : robot_(robot), from_(from) {}

  void run() {
    each("link", [&](const TiXmlElement& link) {
      const std::string name = name_of(link, "link");
      if (!links_.insert(name).second) refuse("the link name '" + name + "' stands twice", "give each link its own");
    });
    if (links_.empty()) refuse("there is no <link>", "a robot has a link for its base and one for each joint");
    each("joint", [&](const TiXmlElement& joint) { check_joint(joint); });
    check_roots();
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const {
    throw description::Refused(from_ + ": " + what + "; " + remedy);
  }
  template <class Visit>
  void each(const char* tag, Visit visit) const {
    for (auto* e = robot_.FirstChildElement(tag); e != nullptr; e = e->NextSiblingElement(tag))
      visit(*e);
  }
  std::string name_of(const TiXmlElement& element, const std::string& what) const {
    const char* name = element.Attribute("name");
    if (name == nullptr || *name == '\0')
      refuse("the <" + what + "> at line " + std::to_string(element.Row()) + " has no name", "give name=\"...\"");
    return harmless(name);
  }
  std::string link_named_by(const TiXmlElement& joint, const std::string& joint_name, const char* end) const {
    const auto* element = joint.FirstChildElement(end);
    const char* link = element != nullptr ? element->Attribute("link") : nullptr;
    const std::string here = "joint '" + joint_name + "': ";
    if (link == nullptr) refuse(here + "has no " + end, "give <" + std::string(end) + " link=\"...\"/>");
    if (links_.count(harmless(link)) == 0)
      refuse(here + end + " link '" + harmless(link) + "' is missing", "add the link or mend the name");
    return harmless(link);
  }
  void check_type(const TiXmlElement& joint, const std::string& name) const {
    static const std::set<std::string> known{"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};
    const char* type = joint.Attribute("type");
    if (type == nullptr || known.count(type) == 0)
      refuse("joint '" + name + "': type '" + harmless(type == nullptr ? "" : type) + "' is not known",
             "give revolute, continuous, prismatic or fixed");
  }
  void check_rpy(const TiXmlElement& joint, const std::string& name) const {
    constexpr double turn = 6.2831853071796;
    const auto* origin = joint.FirstChildElement("origin");
    const char* rpy = origin != nullptr ? origin->Attribute("rpy") : nullptr;
    if (rpy == nullptr) return;
    std::istringstream numbers(rpy);
    numbers.imbue(std::locale::classic());
    for (double angle = 0.0; numbers >> angle;)
      if (std::abs(angle) > turn)
        refuse("joint '" + name + "': rpy is '" + harmless(rpy) + "' rad, more than a turn", "give radians");
  }
  void check_joint(const TiXmlElement& joint) {
    const std::string name = name_of(joint, "joint");
    if (!joints_.insert(name).second) refuse("the joint name '" + name + "' stands twice", "give each joint its own");
    check_type(joint, name), check_rpy(joint, name);
    const std::string parent = link_named_by(joint, name, "parent"), child = link_named_by(joint, name, "child");
    if (parent == child) refuse("joint '" + name + "': link '" + child + "' is its own parent", "name two links");
    if (!carried_by_.emplace(child, name).second)
      refuse("link '" + child + "' is carried by two joints, '" + carried_by_[child] + "' and '" + name + "': a loop",
             "cut the loop; a link has one parent: a parallelogram's rods are branches that mimic its joints, while a "
             "four-bar of unequal sides or a delta is not linear and not computed");
    parent_of_[child] = parent;
  }
  void check_roots() const {
    std::string roots;
    int count = 0;
    for (const auto& link : links_)
      if (parent_of_.count(link) == 0) roots += (count++ ? ", " : "") + link;
    if (count == 0) refuse("there is no root: the links form a loop", "one link, the base, has no parent");
    if (count > 1 && roots.size() > 200) roots = roots.substr(0, 200) + " ...";
    if (count > 1) refuse("there are " + std::to_string(count) + " roots: " + roots, "join them with fixed joints");
    for (const auto& link : links_)
      check_reaches_root(link);
  }
  void check_reaches_root(const std::string& link) const {
    std::string at = link;
    for (std::size_t steps = 0; parent_of_.count(at) != 0; ++steps) {
      if (steps > links_.size())
        refuse("link '" + link + "' hangs on a loop, not on the root", "cut the loop; every link leads to the base");
      at = parent_of_.at(at);
    }
  }

  const TiXmlElement& robot_;
  const std::string& from_;
  std::set<std::string> links_, joints_;
  std::map<std::string, std::string> carried_by_, parent_of_;
};

std::array<double, 3> three(const TiXmlElement* element, const char* attribute) {
  std::array<double, 3> values{};
  const char* text = element != nullptr ? element->Attribute(attribute) : nullptr;
  if (text == nullptr) return values;
  std::istringstream numbers(text);
  numbers.imbue(std::locale::classic());
  for (double& value : values)
    numbers >> value;
  return values;
}

}  // namespace

WrittenNumbers written_numbers(const std::string& text) {
  TiXmlDocument document;
  document.Parse(text.c_str());
  const auto* robot = document.FirstChildElement("robot");
  WrittenNumbers result;
  LengthDigit digit;
  for (auto* e = robot->FirstChildElement("joint"); e != nullptr; e = e->NextSiblingElement("joint")) {
    const auto* origin = e->FirstChildElement("origin");
    result.joint_rpy[harmless(e->Attribute("name"))] = three(origin, "rpy");
    const char* xyz = origin != nullptr ? origin->Attribute("xyz") : nullptr;
    const auto lengths = three(origin, "xyz");
    std::istringstream words(xyz != nullptr ? xyz : "");
    std::string word;
    for (std::size_t k = 0; k < 3 && words >> word; ++k)
      digit.see(word, lengths[k]);
  }
  for (auto* e = robot->FirstChildElement("link"); e != nullptr; e = e->NextSiblingElement("link"))
    if (const auto* inertial = e->FirstChildElement("inertial"); inertial != nullptr)
      result.inertial_rpy[harmless(e->Attribute("name"))] = three(inertial->FirstChildElement("origin"), "rpy");
  result.length_digit = digit.value();
  return result;
}

std::string with_blank_limits(const std::string& text) {
  TiXmlDocument document;
  document.Parse(text.c_str());
  auto* robot = document.FirstChildElement("robot");
  for (auto* e = robot->FirstChildElement("joint"); e != nullptr; e = e->NextSiblingElement("joint")) {
    const std::string type = e->Attribute("type");
    auto* limit = e->FirstChildElement("limit");
    if (limit == nullptr && (type == "revolute" || type == "prismatic"))
      limit = e->InsertEndChild(TiXmlElement("limit"))->ToElement();
    for (const char* part : {"effort", "velocity"})
      if (limit != nullptr && limit->Attribute(part) == nullptr) limit->SetAttribute(part, "0");
  }
  TiXmlPrinter printer;
  document.Accept(&printer);
  return printer.Str();
}

void check_urdf_text(const std::string& text, const std::string& from) {
  TiXmlDocument document;
  parse_xml(text, from, document);
  if (const auto* first = document.RootElement(); first != nullptr)
    if (const std::string found = xacro_in(*first); !found.empty())
      throw description::Refused(from + ": this is xacro, not a URDF yet: " + harmless(found) +
                                 "; expand it first: xacro robot.urdf.xacro > robot.urdf (the program is part of ROS)");
  const auto* robot = document.FirstChildElement("robot");
  if (robot == nullptr) throw description::Refused(from + ": there is no <robot> element; give a URDF or a JSON table");
  Checker(*robot, from).run();
}

}  // namespace importer
