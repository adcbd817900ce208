#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/import/urdf/transmissions.hpp>

#include <tinyxml.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <vector>

namespace importer {
namespace {

using description::harmless;
using description::number;
using Law = SourceTransmission::Law;

std::string text_below(const TiXmlElement& element, const char* tag) {
  const auto* child = element.FirstChildElement(tag);
  const char* text = child != nullptr ? child->GetText() : nullptr;
  return text == nullptr ? "" : harmless(text);
}
std::string attribute(const TiXmlElement& element, const char* name) {
  const char* text = element.Attribute(name);
  return text == nullptr ? "" : harmless(text);
}

/// One end of a transmission: a joint or an actuator.
struct End {
  std::string name, role;
  double reduction = 1.0, offset = 0.0;
};

class Element {
 public:
  Element(const TiXmlElement& element, const std::string& from) : element_(element), from_(from) {
    name_ = attribute(element, "name");
    for (const char* tag : {"type", "plugin"})
      if (type_.empty()) type_ = text_below(element, tag);
    if (type_.empty()) type_ = attribute(element, "type");
    joints_ = ends("joint"), actuators_ = ends("actuator");
  }

  void add_to(SourceTree& tree) const {
    if (is("SimpleTransmission")) return add_simple(tree);
    const bool differential = is("DifferentialTransmission");
    if (!differential && !is("FourBarLinkageTransmission")) {
      add_unknown(tree);
    } else if (joints_.size() != 2) {
      refuse("has " + std::to_string(joints_.size()) + " joints", "its law is that of two joints and two actuators");
    } else if (check(tree)) {
      tree.transmissions.push_back({name_,
                                    differential ? Law::differential : Law::four_bar,
                                    {joints_[0].name, joints_[1].name},
                                    {joints_[0].reduction, joints_[1].reduction}});
      tell(tree, differential);
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const {
    throw description::Refused(from_ + ": " + here() + what + "; " + remedy);
  }
  std::string here() const { return "transmission '" + name_ + "': "; }
  bool is(const std::string& law) const {
    return type_.size() >= law.size() && type_.compare(type_.size() - law.size(), law.size(), law) == 0;
  }
  /// A simple transmission's numbers are told and go into nothing, so that one that is none needs no refusal.
  double value(const TiXmlElement& end, const char* tag, double missing) {
    const std::string text = text_below(end, tag);
    if (text.empty()) return missing;
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    double result = 0.0;
    std::string rest;
    if (words >> result && !(words >> rest)) return result;
    if (!is("SimpleTransmission")) refuse(std::string(tag) + " is '" + text + "'", "give a number");
    unread_ = std::string(tag) + " '" + text + "'";
    return missing;
  }
  /// Ends in the order of their roles, joint1 before joint2; where roles are missing, as they stand.
  std::vector<End> ends(const char* tag) {
    std::vector<End> found;
    for (auto* e = element_.FirstChildElement(tag); e != nullptr; e = e->NextSiblingElement(tag)) {
      End end{attribute(*e, "name"), attribute(*e, "role"), 1.0, 0.0};
      if (end.role.empty()) end.role = text_below(*e, "role");
      end.reduction = value(*e, "mechanicalReduction", value(*e, "mechanical_reduction", 1.0));
      end.offset = value(*e, "offset", 0.0);
      if (!(std::abs(end.reduction) > 1e-9 && std::abs(end.reduction) < 1e9))
        refuse("reduction of '" + end.name + "' is " + number(end.reduction), "give a number that is not 0");
      found.push_back(end);
    }
    std::stable_sort(found.begin(), found.end(), [](const End& a, const End& b) { return a.role < b.role; });
    return found;
  }

  void add_simple(SourceTree& tree) const {
    if (joints_.size() != 1 || actuators_.empty()) return;
    if (!unread_.empty()) {
      tree.notes.push_back(here() + unread_ + " is not a number: a gear in .rotor_inertia(J, gear) at joint '" +
                           joints_[0].name + "' is yours to give");
      return;
    }
    const double gear = joints_[0].reduction * actuators_[0].reduction;
    if (gear != 1.0)
      tree.notes.push_back(here() + "reduction " + number(gear) + ", the gear in .rotor_inertia(J, " + number(gear) +
                           ") at joint '" + joints_[0].name + "'");
  }
  void add_unknown(SourceTree& tree) const {
    if (joints_.size() > 1)
      refuse(
          "type '" + type_ + "' moves several joints by a law that is not known, or that is not linear",
          "take the element out for a drive a joint; a linear law is written by .driven_by() in the header, one of a "
          "four-bar of unequal sides or a delta is not computed");
    tree.notes.push_back(here() + "type '" + type_ + "' is not known: joint and drive are taken one to one");
  }
  /// Whether it couples joints that move here.
  bool check(SourceTree& tree) const {
    for (const End& end : joints_) {
      const auto found = std::find_if(tree.links.begin(), tree.links.end(), [&](const SourceLink& link) {
        return link.joint.moves() && link.joint.name == end.name;
      });
      if (found == tree.links.end()) {
        tree.notes.push_back(here() + "joint '" + end.name + "' does not move here: the other one is taken as its own");
        return false;
      }
      if (!found->joint.leader.empty())
        refuse("joint '" + end.name + "' mimics '" + found->joint.leader + "' and has drives", "keep one of them");
      for (const auto& other : tree.transmissions)
        if (other.joints[0] == end.name || other.joints[1] == end.name)
          refuse("joint '" + end.name + "' is in transmission '" + other.name + "' too", "name each joint once");
    }
    if (joints_[0].name == joints_[1].name) refuse("both joints are '" + joints_[0].name + "'", "name two joints");
    return true;
  }
  void tell(SourceTree& tree, bool differential) const {
    tree.notes.push_back(here() + "joints '" + joints_[0].name + "' and '" + joints_[1].name +
                         (differential ? "' are moved by the sum and the difference of two drives"
                                       : "' are moved by two drives, the second one past the first (the linear law "
                                         "of a four-bar linkage, that of a parallelogram)"));
    for (const End& actuator : actuators_)
      if (actuator.reduction != 1.0)
        tree.notes.push_back(here() + "reduction " + number(actuator.reduction) + " of actuator '" + actuator.name +
                             "' is the gear of its rotor: a drive's values are those behind it");
    for (const End& end : joints_)
      if (end.offset != 0.0)
        tree.notes.push_back(here() + "offset " + number(end.offset) + " of joint '" + end.name +
                             "' is left to where its drives count from");
  }

  const TiXmlElement& element_;
  const std::string& from_;
  std::string name_, type_, unread_;
  std::vector<End> joints_, actuators_;
};

void read_below(const TiXmlElement& parent, const std::string& from, SourceTree& tree) {
  for (auto* e = parent.FirstChildElement("transmission"); e != nullptr; e = e->NextSiblingElement("transmission"))
    Element(*e, from).add_to(tree);
}

}  // namespace

void read_transmissions(const std::string& text, const std::string& from, SourceTree& tree) {
  TiXmlDocument document;
  document.Parse(text.c_str());
  const auto* robot = document.FirstChildElement("robot");
  if (robot == nullptr) return;
  read_below(*robot, from, tree);
  for (auto* e = robot->FirstChildElement("ros2_control"); e != nullptr; e = e->NextSiblingElement("ros2_control"))
    read_below(*e, from, tree);
}

}  // namespace importer
