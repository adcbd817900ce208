// A URDF as Orocos KDL has it, read from the text a second time: by nothing that reads it for the description.
#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/import/reference.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <tinyxml.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <set>
#include <sstream>

namespace importer {
namespace {

using Of = Change::Of;
using Three = std::array<double, 3>;

std::vector<double> numbers(const char* text) {
  std::istringstream words(text == nullptr ? "" : text);
  words.imbue(std::locale::classic());
  std::vector<double> result;
  for (double value = 0.0; words >> value;)
    result.push_back(value);
  return result;
}
const char* attribute(const TiXmlElement* element, const char* tag, const char* name) {
  const auto* child = element != nullptr ? element->FirstChildElement(tag) : nullptr;
  return child != nullptr ? child->Attribute(name) : nullptr;
}
double one(const TiXmlElement* element, const char* tag, const char* name, double missing = 0.0) {
  const auto found = numbers(attribute(element, tag, name));
  return found.empty() ? missing : found[0];
}
std::string word(const char* text) { return description::harmless(text == nullptr ? "" : text); }

/// Numbers of the text, as they are written or as they are said to be read. Remembers how far the latter are off.
class Numbers {
 public:
  Numbers(const std::vector<Change>& changes, double& angle, double& length)
      : changes_(changes), angle_(angle), length_(length) {}

  Three operator()(const TiXmlElement* element, const char* tag, const char* name, Of of, const std::string& owner,
                   Three missing = {}) {
    const auto written = numbers(attribute(element, tag, name));
    Three result = missing;
    std::copy_n(written.begin(), std::min<std::size_t>(3, written.size()), result.begin());
    const Three before = result;
    for (const auto& change : changes_)
      if (change.of == of && change.name == owner) take(change, result[change.index]);
    remember(of, before, result);
    return result;
  }

 private:
  static void take(const Change& change, double& value) {
    if (change.written != value)
      throw description::Refused("'" + change.name + "': a number is said to be changed that the file has not");
    value = change.read;
  }
  void remember(Of of, const Three& before, const Three& after) {
    const auto norm = [](const Three& v) { return std::hypot(v[0], v[1], v[2]); };
    const Three off{after[0] - before[0], after[1] - before[1], after[2] - before[2]};
    if (of == Of::joint_turn)
      host_sim::note_size(angle_, norm(off));
    else if (of == Of::joint_xyz)
      host_sim::note_size(length_, norm(off));
    else if (of == Of::joint_axis)
      host_sim::note_size(angle_, norm(off) / norm(before));
    else
      for (const double each : off)
        host_sim::note_size(angle_, each);
  }

  const std::vector<Change>& changes_;
  double &angle_, &length_;
};

KDL::Frame frame(const Three& xyz, const Three& rpy) {
  return {KDL::Rotation::RPY(rpy[0], rpy[1], rpy[2]), KDL::Vector(xyz[0], xyz[1], xyz[2])};
}

class ReferenceReader {
 public:
  ReferenceReader(const std::string& text, const ReadingOptions& options, const std::vector<Change>& changes,
                  Reference& result)
      : options_(options), result_(result), read_(changes, result.changed_angle, result.changed_length) {
    document_.Parse(text.c_str());
    robot_ = document_.FirstChildElement("robot");
    for (auto* e = robot_->FirstChildElement("link"); e != nullptr; e = e->NextSiblingElement("link"))
      links_[word(e->Attribute("name"))] = e;
    for (auto* e = robot_->FirstChildElement("joint"); e != nullptr; e = e->NextSiblingElement("joint"))
      carrier_[word(attribute(e, "child", "link"))] = e, joints_[word(e->Attribute("name"))] = e;
  }

  void read(const std::vector<std::string>& order) {
    root_ = options_.root.empty() ? links_.begin()->first : word(options_.root.c_str());
    while (options_.root.empty() && carrier_.count(root_) != 0)
      root_ = parent_of(root_);
    for (std::string at = word(options_.tip.c_str()); !at.empty() && at != root_ && carrier_.count(at) != 0;
         at = parent_of(at))
      path_.insert(at);
    add_children(root_, "root");
    if (std::set<std::string>(order.begin(), order.end()) != moving_)
      throw description::Refused("the joints that move are not those of the file");
    for (const auto& joint : order) {
      result_.joints.push_back(segment_name(word(attribute(joints_.at(joint), "child", "link"))));
      add_limits(joint);
    }
    read_laws();
    add_drives(order);
  }

 private:
  std::string parent_of(const std::string& link) const { return word(attribute(carrier_.at(link), "parent", "link")); }
  bool has_tip() const { return !options_.tip.empty(); }
  bool holds(const TiXmlElement& joint, const std::string& child) const {
    return (has_tip() && path_.count(child) == 0) ||
           (options_.hold_mimic && joint.FirstChildElement("mimic") != nullptr);
  }

  void add_children(const std::string& link, const std::string& segment) {
    for (auto* e = robot_->FirstChildElement("joint"); e != nullptr; e = e->NextSiblingElement("joint")) {
      const std::string child = word(attribute(e, "child", "link"));
      if (word(attribute(e, "parent", "link")) != link) continue;
      if (has_tip() && link == root_ && path_.count(child) == 0) continue;  // carried by nothing that moves
      result_.tree.addSegment(segment_of(*e, child), segment);
      add_children(child, segment_name(child));
    }
  }
  KDL::Segment segment_of(const TiXmlElement& joint, const std::string& child) {
    const std::string name = word(joint.Attribute("name")), type = word(joint.Attribute("type"));
    const auto body = body_of(child);
    const Three by = read_(nullptr, "", "", Of::joint_turn, name);
    const KDL::Vector turn(by[0], by[1], by[2]);
    KDL::Frame origin =
        frame(read_(&joint, "origin", "xyz", Of::joint_xyz, name), read_(&joint, "origin", "rpy", Of::joint_rpy, name));
    const double angle = std::sqrt(KDL::dot(turn, turn));  // KDL takes what is below 1e-6 for nothing
    if (angle > 0.0) origin.M = KDL::Rotation::Rot2(turn / angle, angle) * origin.M;
    if (type == "fixed") return KDL::Segment(segment_name(child), KDL::Joint(name, KDL::Joint::Fixed), origin, body);
    const Three a = read_(&joint, "axis", "xyz", Of::joint_axis, name, {1.0, 0.0, 0.0});
    const auto slides = type == "prismatic" ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
    const KDL::Joint moves(name, origin.p, origin.M * KDL::Vector(a[0], a[1], a[2]), slides);
    if (!holds(joint, child)) {
      moving_.insert(name);
      return KDL::Segment(segment_name(child), moves, origin, body);
    }
    if (type != "floating" && type != "planar") origin = moves.pose(held_at(joint, type)) * KDL::Frame(origin.M);
    return KDL::Segment(segment_name(child), KDL::Joint(name, KDL::Joint::Fixed), origin, body);
  }
  double held_at(const TiXmlElement& joint, const std::string& type) const {
    const double at = options_.hold_mimic ? one(&joint, "mimic", "offset") : 0.0;
    const double lower = one(&joint, "limit", "lower"), upper = one(&joint, "limit", "upper");
    const bool limited = type != "continuous" && lower <= upper && (lower != 0.0 || upper != 0.0);
    return limited ? std::min(std::max(at, lower), upper) : at;
  }
  KDL::RigidBodyInertia body_of(const std::string& link) {
    const auto* inertial = links_.at(link)->FirstChildElement("inertial");
    if (inertial == nullptr) return KDL::RigidBodyInertia::Zero();
    const auto entry = [&](const char* name) { return one(inertial, "inertia", name); };
    const auto xyz = numbers(attribute(inertial, "origin", "xyz"));
    const Three centre{xyz.size() > 0 ? xyz[0] : 0.0, xyz.size() > 1 ? xyz[1] : 0.0, xyz.size() > 2 ? xyz[2] : 0.0};
    return frame(centre, read_(inertial, "origin", "rpy", Of::inertial_rpy, link)) *
           KDL::RigidBodyInertia(one(inertial, "mass", "value"), KDL::Vector::Zero(),
                                 KDL::RotationalInertia(entry("ixx"), entry("iyy"), entry("izz"), entry("ixy"),
                                                        entry("ixz"), entry("iyz")));
  }

  void add_limits(const std::string& name) {
    const auto* joint = joints_.at(name);
    WrittenLimits limits;
    limits.lower = one(joint, "limit", "lower"), limits.upper = one(joint, "limit", "upper");
    limits.positions = word(joint->Attribute("type")) != "continuous" && (limits.lower != 0.0 || limits.upper != 0.0);
    limits.speed = one(joint, "limit", "velocity"), limits.effort = one(joint, "limit", "effort");
    limits.damping = one(joint, "dynamics", "damping"), limits.friction = one(joint, "dynamics", "friction");
    limits.backward = limits.friction;
    result_.limits.push_back(limits);
  }

  /// Two joints by the sum and the difference of two drives, or by two drives, the second one past the first.
  struct Pair {
    bool sum = false;
    std::string joints[2];
    double reductions[2] = {1.0, 1.0};
  };
  void read_laws() {
    for (const auto* above : {static_cast<const TiXmlElement*>(robot_), robot_->FirstChildElement("ros2_control")})
      for (auto* level = above; level != nullptr;
           level = level == robot_ ? nullptr : level->NextSiblingElement("ros2_control"))
        for (auto* e = level->FirstChildElement("transmission"); e != nullptr;
             e = e->NextSiblingElement("transmission"))
          read_law(*e);
  }
  static std::string text_of(const TiXmlElement& element, const char* tag) {
    const auto* child = element.FirstChildElement(tag);
    return child != nullptr ? word(child->GetText()) : "";
  }
  void read_law(const TiXmlElement& element) {
    std::string type = text_of(element, "type") + text_of(element, "plugin");
    if (type.empty()) type = word(element.Attribute("type"));
    const auto ends = [&](const char* law) {
      const std::string name = law;
      return type.size() >= name.size() && type.compare(type.size() - name.size(), name.size(), name) == 0;
    };
    Pair pair;
    pair.sum = ends("DifferentialTransmission");
    if (!pair.sum && !ends("FourBarLinkageTransmission")) return;
    std::vector<std::pair<std::string, const TiXmlElement*>> found;
    for (auto* e = element.FirstChildElement("joint"); e != nullptr; e = e->NextSiblingElement("joint"))
      found.emplace_back(e->Attribute("role") != nullptr ? word(e->Attribute("role")) : text_of(*e, "role"), e);
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < 2 && k < found.size(); ++k) {
      pair.joints[k] = word(found[k].second->Attribute("name"));
      if (moving_.count(pair.joints[k]) == 0) return;  // the other one is its own
      for (const char* tag : {"mechanical_reduction", "mechanicalReduction"})
        if (const auto ratio = numbers(text_of(*found[k].second, tag).c_str()); !ratio.empty())
          pair.reductions[k] = ratio[0];
    }
    pairs_.push_back(pair);
  }
  /// A joint's position with one drive at 1, the others at 0; with no drive named, all at 0.
  double position(const std::string& joint, const std::string& drive) const {
    const auto at = [&](const std::string& name) { return name == drive ? 1.0 : 0.0; };
    for (const Pair& p : pairs_) {
      const double first = at(p.joints[0]), second = at(p.joints[1]);
      const double a = (p.sum ? (first + second) / 2.0 : first) / p.reductions[0];
      if (p.joints[0] == joint) return a;
      if (p.joints[1] == joint) return (p.sum ? (first - second) / 2.0 : second - a) / p.reductions[1];
    }
    const auto* leader = attribute(joints_.at(joint), "mimic", "joint");
    if (leader == nullptr) return at(joint);
    return one(joints_.at(joint), "mimic", "offset") +
           one(joints_.at(joint), "mimic", "multiplier", 1.0) * position(word(leader), drive);
  }
  void add_drives(const std::vector<std::string>& order) {
    result_.ratios.assign(order.size(), {}), result_.rotors.assign(order.size(), 0.0);
    for (const auto& joint : order)
      result_.offsets.push_back(position(joint, ""));
    for (const auto& drive : order) {
      if (joints_.at(drive)->FirstChildElement("mimic") != nullptr) continue;
      ++result_.drives;
      for (std::size_t i = 0; i < order.size(); ++i)
        result_.ratios[i].push_back(position(order[i], drive) - result_.offsets[i]);
    }
  }

  const ReadingOptions& options_;
  Reference& result_;
  Numbers read_;
  TiXmlDocument document_;
  const TiXmlElement* robot_ = nullptr;
  std::map<std::string, const TiXmlElement*> links_, joints_, carrier_;  ///< carrier_: the joint of a link
  std::string root_;
  std::set<std::string> path_, moving_;
  std::vector<Pair> pairs_;
};

}  // namespace

Reference reference_of(const std::string& text, const ReadingOptions& options, const std::vector<Change>& changes,
                       const axial::GravityVector& gravity, const std::vector<std::string>& joint_order,
                       const std::string& tool_link) {
  Reference result;
  result.gravity = {gravity.x, gravity.y, gravity.z};
  const double rounding = 1e-12;
  result.changed_angle_bound =
      rounding + (options.snap ? std::max(nearly_right, options.right_angles) : options.right_angles);
  ReferenceReader(text, options, changes, result).read(joint_order);
  if (!tool_link.empty()) result.tool_segment = segment_name(tool_link);
  return result;
}

}  // namespace importer
