#include <host_sim/robots/description/json_reader.hpp>
#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/description/poses.hpp>
#include <host_sim/robots/description/table.hpp>

#include <axial/robot/classical.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace description {
namespace {

const std::vector<std::string> robot_keys = {"name", "source", "convention",    "gravity", "base",
                                             "tool", "notes",  "payload_limit", "links"};
const std::vector<std::string> link_keys = {"name",
                                            "joint_name",
                                            "type",
                                            "parent",
                                            "alpha",
                                            "alpha_deg",
                                            "a",
                                            "d",
                                            "theta",
                                            "theta_deg",
                                            "gamma",
                                            "gamma_deg",
                                            "b",
                                            "mass",
                                            "com",
                                            "inertia_com",
                                            "inertia_origin",
                                            "rotor_inertia",
                                            "gear",
                                            "viscous",
                                            "coulomb",
                                            "stribeck",
                                            "smooth_speed",
                                            "spring",
                                            "position_limits",
                                            "position_limits_deg",
                                            "speed_limit",
                                            "acceleration_limit",
                                            "effort_limit"};

class LinkReader {
 public:
  LinkReader(const JsonObject& row, bool classical, Link& link) : row_(row), classical_(classical), link_(link) {}

  void read(const Description& before) {
    row_.allow(link_keys);
    type(), parent(before), geometry(), body(), drive(), friction(), limits();
  }

 private:
  axial::LinkParameters& p() { return link_.parameters; }

  void type() {
    const std::string type = row_.text("type", "");
    if (type != "revolute" && type != "prismatic")
      row_.refuse("type is '" + type + "'", "give \"type\": \"revolute\" or \"prismatic\"");
    p().type = type == "revolute" ? axial::JointType::revolute : axial::JointType::prismatic;
  }
  void parent(const Description& before) {
    p().parent = before.size() - 1;
    if (!row_.has("parent")) return;
    if (classical_) row_.refuse("a classical table has no parent", "it is serial; describe a tree in modified rows");
    const std::string name = row_.text("parent", "");
    p().parent = axial::LinkParameters::base;
    if (name == "base") return;
    const auto at =
        std::find_if(before.links.begin(), before.links.end(), [&](const Link& l) { return l.name == name; });
    if (at == before.links.end())
      row_.refuse("no link before it is called '" + name + "'", "parent is \"base\" or the name of an earlier link");
    p().parent = static_cast<int>(at - before.links.begin());
  }
  void geometry() {
    p().alpha = row_.angle("alpha"), p().theta = row_.angle("theta"), p().gamma = row_.angle("gamma");
    p().a = row_.number("a", 0.0), p().d = row_.number("d", 0.0), p().b = row_.number("b", 0.0);
    if (classical_ && (row_.has("gamma") || row_.has("gamma_deg") || row_.has("b")))
      row_.refuse("a classical table has neither gamma nor b", "describe a tree in modified rows");
  }
  void body() {
    p().mass = row_.number("mass", 0.0);
    const auto com = row_.numbers("com", {3});
    std::copy(com.begin(), com.end(), p().com);
    if (row_.has("inertia_com") && row_.has("inertia_origin"))
      row_.refuse("both inertia_com and inertia_origin are given", "keep one");
    const bool origin = row_.has("inertia_origin");
    const auto j = row_.numbers(origin ? "inertia_origin" : "inertia_com", {3, 6});
    std::copy(j.begin(), j.end(), p().inertia_com);
    if (origin) to_centre();
  }
  void to_centre() {
    const double *c = p().com, *j = p().inertia_com;
    const auto shifted =
        axial::revolute().mass(p().mass).com(c[0], c[1], c[2]).inertia_origin(j[0], j[1], j[2], j[3], j[4], j[5]);
    std::copy(shifted.parameters().inertia_com, shifted.parameters().inertia_com + 6, p().inertia_com);
  }
  void drive() {
    p().rotor_inertia = row_.number("rotor_inertia", 0.0), p().gear = row_.number("gear", 1.0);
    const auto spring = row_.numbers("spring", {2});
    if (!spring.empty()) p().spring_stiffness = spring[0], p().spring_rest = spring[1];
  }
  void friction() {
    p().viscous = row_.number("viscous", 0.0), p().smooth_speed = row_.number("smooth_speed", 0.0);
    if (row_.has("coulomb") && row_.member("coulomb").is_number()) {
      p().coulomb_forward = row_.number("coulomb", 0.0), p().coulomb_backward = -p().coulomb_forward;
    } else {
      const auto both = row_.numbers("coulomb", {2});
      if (!both.empty()) p().coulomb_forward = both[0], p().coulomb_backward = both[1];
    }
    const auto stribeck = row_.numbers("stribeck", {2});
    if (!stribeck.empty()) p().static_friction = stribeck[0], p().stribeck_speed = stribeck[1];
  }
  void limits() {
    constexpr double degree = 3.14159265358979323846 / 180.0;
    const bool degrees = row_.has("position_limits_deg");
    if (degrees && row_.has("position_limits"))
      row_.refuse("both position_limits and position_limits_deg are given", "keep one");
    if (degrees && p().type == axial::JointType::prismatic)
      row_.refuse("a prismatic joint has position_limits_deg", "give position_limits in metres");
    const auto range = row_.numbers(degrees ? "position_limits_deg" : "position_limits", {2});
    if (!range.empty()) p().position_min = range[0], p().position_max = range[1];
    if (degrees) p().position_min *= degree, p().position_max *= degree;
    constexpr double none = axial::LinkParameters::unlimited;
    p().speed_limit = row_.number("speed_limit", none), p().effort_limit = row_.number("effort_limit", none);
    p().acceleration_limit = row_.number("acceleration_limit", none);
  }

  const JsonObject& row_;
  bool classical_;
  Link& link_;
};

axial::FixedPose read_pose(const JsonObject& of, const std::string& key) {
  if (!of.has(key)) return {};
  const JsonObject pose(of.member(key), key);
  pose.allow({"xyz", "rpy", "rpy_deg", "rotation"});
  if (pose.has("rpy") + pose.has("rpy_deg") + pose.has("rotation") > 1)
    pose.refuse("more than one of rpy, rpy_deg and rotation is given", "keep one");
  axial::FixedPose result;
  const auto xyz = pose.numbers("xyz", {3}), rotation = pose.numbers("rotation", {9});
  std::copy(xyz.begin(), xyz.end(), result.position);
  std::copy(rotation.begin(), rotation.end(), result.rotation);
  const bool degrees = pose.has("rpy_deg");
  const auto rpy = pose.numbers(degrees ? "rpy_deg" : "rpy", {3});
  if (!rpy.empty()) set_rotation(result, rpy[0], rpy[1], rpy[2], degrees);
  if (!is_rotation(result)) pose.refuse("rotation is not orthonormal", "give a rotation matrix, row by row");
  return result;
}

void read_robot(const JsonObject& file, Description& robot, const std::string& from) {
  robot.name = file.text("name", ""), robot.source = file.text("source", from.substr(from.find_last_of("/\\") + 1)),
  robot.notes = file.texts("notes");
  if (robot.name.empty()) file.refuse("name is missing", "give \"name\": \"my_arm\"");
  const auto g = file.numbers("gravity", {3});
  if (!g.empty())
    robot.gravity = {g[0], g[1], g[2]};
  else
    robot.assumptions.push_back("gravity (0, 0, -9.81) m/s^2 in frame 0: the file gives none");
  robot.base = read_pose(file, "base"), robot.tool = read_pose(file, "tool");
  const auto load = file.numbers("payload_limit", {3});
  if (!load.empty()) robot.payload_limit = axial::payload_limit(load[0], load[1], load[2]);
}

void read_links(const JsonObject& file, Table& table, const std::string& from) {
  if (!file.has("links") || !file.member("links").is_array() || file.member("links").empty())
    file.refuse("there are no links", "give \"links\": [{\"type\": \"revolute\", ...}, ...]");
  std::set<std::string> names{"base"};
  for (const auto& row : file.member("links")) {
    const std::string number = std::to_string(table.robot.size() + 1);
    const JsonObject unnamed(row, from + ": link " + number);
    Link link;
    link.name = unnamed.text("name", "link" + number), link.joint = unnamed.text("joint_name", "joint" + number);
    if (!names.insert(link.name).second)
      unnamed.refuse("the name '" + link.name + "' is taken", "give each link its own");
    LinkReader(JsonObject(row, from + ": link '" + link.name + "'"), table.classical, link).read(table.robot);
    table.robot.links.push_back(link);
  }
}

}  // namespace

std::string read_text(const std::string& path) {
  constexpr std::streamsize most = 16 << 20;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf()) || file.bad())
    throw Refused("cannot read '" + path + "'; is there such a file, is it not empty, and may it be read?");
  if (static_cast<std::streamsize>(text.tellp()) > most)
    throw Refused(path + ": more than 16 MiB; a description of a robot is smaller");
  return text.str();
}

Table parse_table(const std::string& text, const std::string& from) {
  const auto json = parse_json(text, from);
  const JsonObject file(json, from);
  file.allow(robot_keys);
  const std::string convention = file.text("convention", "");
  if (convention != "classical" && convention != "modified")
    file.refuse("convention is '" + convention + "'", "give \"convention\": \"classical\" or \"modified\"");
  Table table;
  table.classical = convention == "classical";
  read_robot(file, table.robot, from);
  read_links(file, table, from);
  return table;
}

Table read_table(const std::string& path) { return parse_table(read_text(path), path); }

Description to_mdh(const Table& table) {
  Description robot = table.robot;
  if (!table.classical) return robot;
  axial::detail::FarEnd end{};
  for (Link& link : robot.links) {
    auto& p = link.parameters;
    const auto before = end;
    end = {p.alpha, p.a};
    end.carry(p);
    p.alpha = before.alpha, p.a = before.a;
  }
  robot.tool = end.carried(robot.tool);
  robot.payload_limit.com_reach += end.a < 0.0 ? -end.a : end.a;
  robot.notes.push_back("a classical table: centres of mass and inertias were carried to MDH frames");
  return robot;
}

}  // namespace description
