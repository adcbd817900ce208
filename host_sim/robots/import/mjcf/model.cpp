#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/import/mjcf/model.hpp>
#include <host_sim/robots/import/mjcf/shapes.hpp>
#include <host_sim/robots/import/right_angles.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace importer::mjcf {
namespace {

constexpr const char* joint_words =
    "type group pos axis springdamper limited actuatorfrclimited solreflimit solimplimit solreffriction "
    "solimpfriction stiffness range actuatorfrcrange actuatorgravcomp margin ref springref armature damping "
    "frictionloss user";

constexpr std::size_t most_parts = 5000;

class ModelReader {
 public:
  explicit ModelReader(Model& model) : m_(model) {}

  void read() {
    check_sections();
    m_.bodies.push_back({}), m_.children.push_back({});
    m_.bodies[0].name = "world", m_.bodies[0].place = m_.root.place, m_.bodies[0].named = true;
    m_.body_of_name["world"] = 0;
    for (const auto& section : m_.root.children)
      if (section.name == "worldbody") read_children(section, 0, {}, "");
    for (const auto& section : m_.root.children)
      for (const auto& element : section.children)
        if (section.name == "tendon" && element.find("name") != nullptr)
          m_.tendon_of_name[*element.find("name")] = &element;
    m_.length_digit = digit_.value();
  }

 private:
  void check_sections() {
    static const std::set<std::string> read{"compiler", "option", "default", "worldbody",
                                            "equality", "tendon", "actuator"},
        passed{"size",       "visual", "statistic", "asset",  "contact",
               "deformable", "sensor", "keyframe",  "custom", "extension"};
    std::set<std::string> found;
    for (const auto& section : m_.root.children) {
      const Attributes a({&section});
      if (passed.count(section.name) != 0)
        found.insert(section.name);
      else if (read.count(section.name) == 0)
        a.refuse("is no section of an MJCF", "mend its name, or take it out");
      if (section.name == "deformable" && !section.children.empty() && section.children[0].name == "flex")
        a.refuse("has bodies that are not rigid", "take them out");
    }
    std::string list;
    for (const auto& name : found)
      list += (list.empty() ? "" : ", ") + name;
    if (!list.empty()) m_.notes.push_back("sections that are no part of rigid joints are not read: " + list);
  }

  void read_children(const Element& of, int body, const Pose& frame, const std::string& childclass) {
    for (const auto& child : of.children) {
      if (child.name == "body")
        read_body(child, body, frame, childclass);
      else if (child.name == "frame")
        read_frame(child, body, frame, childclass);
      else
        read_part(child, body, frame, childclass);
    }
  }
  void read_frame(const Element& element, int body, const Pose& frame, const std::string& childclass) {
    const Attributes a({&element});
    a.allow("childclass pos quat axisangle euler xyaxes zaxis");
    for (const auto& child : element.children)
      if (child.name == "inertial") Attributes({&child}).refuse("stands in a frame", "put it into the body itself");
    read_children(element, body, frame * pose_of(a, m_.settings), class_of(element, childclass));
  }
  std::string class_of(const Element& element, const std::string& childclass) const {
    const auto* own = element.find("childclass");
    if (own != nullptr) m_.defaults->check(element, *own);
    return own != nullptr ? *own : childclass;
  }
  void read_body(const Element& element, int parent, const Pose& frame, const std::string& childclass) {
    const Attributes a({&element});
    a.allow("childclass pos quat axisangle euler xyaxes zaxis mocap gravcomp user sleep");
    const int index = static_cast<int>(m_.bodies.size());
    BodyNode body;
    body.named = element.find("name") != nullptr;
    body.name = a.word("name", "body" + std::to_string(index)), body.place = element.place, body.parent = parent;
    count(a, m_.bodies.size(), "bodies");
    if (!m_.body_of_name.emplace(body.name, index).second)
      a.refuse("the name '" + body.name + "' stands twice", "give each body its own");
    body.pose = frame * pose_of(a, m_.settings), see(a, "pos"), check_turn(a, body.name);
    if (a.number("gravcomp", 0.0) != 0.0)
      m_.notes.push_back("gravcomp of body '" + body.name +
                         "' is not taken over: its weight is held by the joints, as that of the others");
    m_.bodies.push_back(body), m_.children.push_back({});
    m_.children[static_cast<std::size_t>(parent)].push_back(index);
    read_children(element, index, {}, class_of(element, childclass));
  }
  static void count(const Attributes& a, std::size_t found, const std::string& things) {
    if (found > most_parts)
      a.refuse("is one too many: at most " + std::to_string(most_parts) + ' ' + things + " are read",
               "give the robot without its surroundings");
  }
  void check_turn(const Attributes& a, const std::string& body) {
    for (const double angle : a.numbers("euler", 0, 3))
      if (std::abs(angle) * static_cast<double>(m_.settings.angle) > 6.2832)
        m_.warnings.push_back({false, body, "euler is '" + a.word("euler", "") + "', more than a turn",
                               "give degrees, or <compiler angle=\"radian\"/> and radians"});
  }
  void see(const Attributes& a, const std::string& name) {
    const auto values = a.numbers(name, 0, 3);
    std::istringstream words(a.word(name, ""));
    std::string word;
    for (std::size_t k = 0; k < values.size() && words >> word; ++k)
      digit_.see(word, values[k]);
  }

  void read_part(const Element& e, int index, const Pose& frame, const std::string& childclass) {
    auto& body = m_.bodies[static_cast<std::size_t>(index)];
    static const std::set<std::string> unknown{"composite", "flexcomp", "replicate", "attach", "plugin"};
    if (e.name == "inertial") {
      body.inertial = Attributes({&e});
    } else if (e.name == "geom") {
      body.geoms.push_back({m_.defaults->of(e, "geom", childclass), frame});
    } else if (e.name == "site") {
      body.sites.push_back({m_.defaults->of(e, "site", childclass), frame});
      if (const auto* name = e.find("name"); name != nullptr) m_.body_of_site[*name] = index;
    } else if (e.name == "joint" || e.name == "freejoint") {
      read_joint(e, index, frame, childclass);
    } else if (unknown.count(e.name) != 0) {
      Attributes({&e}).refuse("makes bodies that are not written here",
                              "import what MuJoCo makes of it: load the file there and save it (mj_saveLastXML)");
    } else if (e.name != "camera" && e.name != "light") {
      Attributes({&e}).refuse("is no part of a body", "mend its name, or take it out");
    }
  }
  void read_joint(const Element& e, int body_index, const Pose& frame, const std::string& childclass) {
    auto& body = m_.bodies[static_cast<std::size_t>(body_index)];
    const bool free_joint = e.name == "freejoint";
    const Attributes a = free_joint ? Attributes({&e}) : m_.defaults->of(e, "joint", childclass);
    a.allow(free_joint ? "group align" : joint_words);
    count(a, m_.joint_of_name.size() + 1, "joints");
    const std::string type = free_joint ? "free" : a.one_of("type", {"hinge", "slide", "ball", "free"});
    const std::string name =
        e.find("name") != nullptr ? *e.find("name") : "joint" + std::to_string(m_.joint_of_name.size());
    if (!m_.joint_of_name.emplace(name, std::make_pair(body_index, body.joints.size())).second)
      a.refuse("the name '" + name + "' stands twice", "give each joint its own");
    if (body.parent < 0) a.refuse("moves the world", "put it into a body");
    if (type == "free" && (body.parent != 0 || body.moves()))
      a.refuse("is free, in a body that is not free itself", "put free joints alone into bodies of the world");
    if (type == "free") {
      body.free = true, body.free_joint = name;
      return;
    }
    if (body.free) a.refuse("stands beside a free joint", "a free joint is alone in its body");
    body.joints.push_back({a, name, e.find("name") != nullptr, type});
    place(body.joints.back(), frame), read_range(body.joints.back());
  }
  void place(JointNode& joint, const Pose& frame) {
    const auto& a = joint.attributes;
    joint.anchor = frame.rotation * vector_of(a, "pos") + frame.position, see(a, "pos");
    if (joint.type == "ball") return;
    const Vector axis = a.has("axis") ? vector_of(a, "axis") : Vector(Vector::UnitZ());
    if (!(axis.norm() > 1e-9L && axis.norm() < 1e9L))
      a.refuse("axis is '" + a.word("axis", "") + "'", "give a direction, such as axis=\"0 0 1\"");
    joint.axis = frame.rotation * axis.normalized();
    joint.zero = a.number("ref", 0.0) * unit(joint);
    if (const auto both = a.numbers("springdamper", 2, 2); !both.empty() && both[0] > 0.0 && both[1] > 0.0)
      a.refuse("springdamper is '" + a.word("springdamper", "") + "': MuJoCo chooses a spring for the inertia",
               "give stiffness and damping");
  }
  double unit(const JointNode& joint) const { return joint.turns() ? static_cast<double>(m_.settings.angle) : 1.0; }
  void read_range(JointNode& joint) const {
    if (joint.type == "ball") return;
    const auto& a = joint.attributes;
    const auto range = a.numbers("range", 2, 2);
    const std::string limited = a.one_of("limited", {"auto", "true", "false"});
    const bool given = !range.empty() && (range[0] != 0.0 || range[1] != 0.0);
    if (limited == "auto" && given && !m_.settings.limits_by_range)
      a.refuse("range is '" + a.word("range", "") + "' and limited is not given, with autolimits='false'",
               "give limited=\"true\" or \"false\"");
    joint.limited = limited == "true" || (limited == "auto" && given && range[0] < range[1]);
    if (joint.limited && (range.empty() || !(range[0] < range[1])))
      a.refuse("range is '" + a.word("range", "") + "': upside down", "give the lower one first");
    if (joint.limited) joint.lower = range[0] * unit(joint), joint.upper = range[1] * unit(joint);
  }

  Model& m_;
  LengthDigit digit_;
};

Body turned(const Body& body, const Pose& by) {
  return {body.mass, by.rotation * body.com + by.position, by.rotation * body.inertia * by.rotation.transpose()};
}
std::vector<Body> shapes_of(const BodyNode& body, const Settings& settings) {
  std::vector<Body> shapes;
  for (const auto& geom : body.geoms)
    if (const auto shape = body_of_geom(geom.attributes, settings)) shapes.push_back(turned(*shape, geom.frame));
  return shapes;
}
bool is_from_geoms(const BodyNode& body, const Settings& settings) {
  return settings.inertia_from_geoms == "true" || (settings.inertia_from_geoms == "auto" && !body.inertial);
}

}  // namespace

void read_model(const std::string& text, const std::string& from, Model& model) {
  model.root = read_elements(text, from);
  model.name = model.root.find("model") != nullptr ? *model.root.find("model") : "";
  model.settings = settings_of(model.root);
  model.defaults.emplace(model.root);
  ModelReader(model).read();
}

Body inertia_of(const BodyNode& body, const Settings& settings) {
  std::vector<Body> shapes;
  if (is_from_geoms(body, settings)) shapes = shapes_of(body, settings);
  if (!shapes.empty()) return bounded(merged(shapes), settings);
  return bounded(body.inertial ? body_of_inertial(*body.inertial, settings) : Body{}, settings);
}
bool is_diagonalised(const BodyNode& body, const Settings& settings) {
  return settings.balance || settings.least_moment > 0.0 || (body.inertial && body.inertial->has("fullinertia")) ||
         (is_from_geoms(body, settings) && body.geoms.size() > 1);
}

}  // namespace importer::mjcf
