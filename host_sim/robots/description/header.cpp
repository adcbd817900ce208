#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/description/header.hpp>
#include <host_sim/robots/description/numbers.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <iterator>

namespace description {
namespace {

/// Arguments of a call, each the shortest decimal that reads back as the same double.
std::string argument(double value) {
  if (std::isinf(value)) return std::string(value < 0.0 ? "-" : "") + "axial::LinkParameters::unlimited";
  const std::string text = number(value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}
std::string arguments(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : ", ") + argument(value);
  return text;
}
std::string call(const std::string& name, std::initializer_list<double> values) {
  return "." + name + "(" + arguments(values) + ")";
}
std::string call_unless_zero(const std::string& name, double value) { return value == 0.0 ? "" : call(name, {value}); }
std::string call_if_finite(const std::string& name, double value) {
  return std::isfinite(value) ? call(name, {value}) : "";
}

/// `.alpha_deg(-90)`, `.alpha(1.2)`; `more` is what follows inside the brackets.
std::string angle(const std::string& name, const axial::Angle& value, const std::string& more = "") {
  if (const auto degrees = exact_degrees(value)) return "." + name + "_deg(" + number(*degrees) + more + ")";
  return "." + name + "(" + arguments({value.radians}) + more + ")";
}
std::string angle_unless_zero(const std::string& name, const axial::Angle& value) {
  return is_zero(value) ? "" : angle(name, value);
}

/// The rows of one link, without those that say nothing.
class LinkText {
 public:
  explicit LinkText(const axial::LinkParameters& p) : p_(p) {}

  std::string text(const std::string& parent, const std::vector<std::string>& kept, const std::string& comma) const {
    const auto given = quantities_of(kept);
    std::string result = "      axial::" + without(geometry(parent), given);
    for (const auto& row : {body(), shared_drives(), drive(), friction(), limits()})
      if (const std::string left = without(row, given); !left.empty()) result += "\n          " + left;
    for (std::size_t i = 0; i < kept.size(); ++i)
      result += "\n          " + kept[i] + (i + 1 < kept.size() ? "" : comma) + "  // kept";
    return result + (kept.empty() ? comma : "");
  }

  /// Mass, centre of mass and inertia.
  std::string body() const {
    const double *c = p_.com, *j = p_.inertia_com;
    const bool has_com = c[0] != 0.0 || c[1] != 0.0 || c[2] != 0.0;
    std::string row = has_com ? call("mass", {p_.mass}) : call_unless_zero("mass", p_.mass);
    if (has_com) row += call("com", {c[0], c[1], c[2]});
    if (any_inertia()) {
      const bool products = j[3] != 0.0 || j[4] != 0.0 || j[5] != 0.0;
      row += products ? call("inertia_com", {j[0], j[1], j[2], j[3], j[4], j[5]})
                      : call("inertia_com", {j[0], j[1], j[2]});
    }
    if (needs_acceptance(p_)) row += ".accept(axial::as_published)";
    return row;
  }

 private:
  bool any_inertia() const {
    return std::any_of(p_.inertia_com, p_.inertia_com + 6, [](double v) { return v != 0.0; });
  }

  std::string geometry(const std::string& parent) const {
    std::string row = p_.type == axial::JointType::revolute ? "revolute()" : "prismatic()";
    row += parent;
    if (!is_zero(p_.gamma) || p_.b != 0.0) row += angle("branch", p_.gamma, ", " + arguments({p_.b}));
    row += call_unless_zero("a", p_.a) + angle_unless_zero("alpha", p_.alpha);
    return row + call_unless_zero("d", p_.d) + angle_unless_zero("theta", p_.theta);
  }
  std::string drive() const {
    std::string row;
    if (p_.rotor_inertia != 0.0) row += call("rotor_inertia", {p_.rotor_inertia, p_.gear});
    row += rotor_axis();
    if (p_.spring_stiffness != 0.0) row += call("spring", {p_.spring_stiffness, p_.spring_rest});
    return row;
  }
  std::string rotor_axis() const {
    const double* z = p_.rotor_axis;
    if (z[0] == 0.0 && z[1] == 0.0 && z[2] == 0.0) return "";
    if (p_.rotor_carrier == axial::LinkParameters::previous) return call("rotor_axis", {z[0], z[1], z[2]});
    const std::string carrier = p_.rotor_carrier < 0 ? "axial::LinkParameters::base" : std::to_string(p_.rotor_carrier);
    return ".rotor_axis(" + arguments({z[0], z[1], z[2]}) + ", " + carrier + ")";
  }
  std::string shared_drives() const {
    const auto& d = p_.drives;
    if (d.follows) return ".mimic(" + std::to_string(d.of[0]) + ratio_and_offset() + ")";
    std::string row = d.complete ? ".passive()" : "";
    for (int n = 0; n < d.count; ++n)
      row += ".driven_by(" + std::to_string(d.of[n]) + ", " + argument(d.ratio[n]) + ")";
    return row;
  }
  std::string ratio_and_offset() const {
    const auto& d = p_.drives;
    if (d.offset != 0.0) return ", " + arguments({d.ratio[0], d.offset});
    return d.ratio[0] == 1.0 ? "" : ", " + argument(d.ratio[0]);
  }
  std::string friction() const {
    std::string row = call_unless_zero("viscous", p_.viscous);
    if (p_.coulomb_forward != 0.0 || p_.coulomb_backward != 0.0)
      row += p_.coulomb_forward == -p_.coulomb_backward ? call("coulomb", {p_.coulomb_forward})
                                                        : call("coulomb", {p_.coulomb_forward, p_.coulomb_backward});
    if (p_.static_friction != 0.0) row += call("stribeck", {p_.static_friction, p_.stribeck_speed});
    return row + call_unless_zero("smooth_speed", p_.smooth_speed);
  }
  std::string limits() const {
    std::string row;
    if (std::isfinite(p_.position_min) || std::isfinite(p_.position_max))
      row += call("position_limits", {p_.position_min, p_.position_max});
    row += call_if_finite("speed_limit", p_.speed_limit);
    row += call_if_finite("acceleration_limit", p_.acceleration_limit);
    return row + call_if_finite("effort_limit", p_.effort_limit) + drive_limits();
  }
  std::string drive_limits() const {
    if (!p_.has_drive_limits()) return "";
    return call("drive_limits", {p_.drive_min, p_.drive_max, p_.drive_speed_limit, p_.drive_acceleration_limit});
  }

  const axial::LinkParameters& p_;
};

/// `axial::base_body()...`, of a base that floats.
std::string base_body_part(const Description& robot) {
  return robot.base_body ? "axial::base_body()" + LinkText(*robot.base_body).body() : "";
}

std::string parent_call(const Description& robot, int i) {
  const int parent = robot.parent(i);
  if (parent == i - 1) return "";
  return parent < 0 ? ".parent(axial::LinkParameters::base)" : ".parent(" + std::to_string(parent) + ")";
}

bool is_identity(const axial::FixedPose& pose) {
  const axial::FixedPose none;
  return std::equal(pose.rotation, pose.rotation + 9, none.rotation) &&
         std::equal(pose.position, pose.position + 3, none.position);
}

/// `axial::base(...)`, with the rotation only where there is one; nothing for the identity.
std::string pose_part(const std::string& name, const axial::FixedPose& pose) {
  if (is_identity(pose)) return "";
  const double *r = pose.rotation, *p = pose.position;
  const std::string position = arguments({p[0], p[1], p[2]});
  axial::FixedPose shifted;
  std::copy(p, p + 3, shifted.position);
  if (std::equal(r, r + 9, shifted.rotation)) return "axial::" + name + "(" + position + ")";
  return "axial::" + name + "(axial::FixedPose{{" + arguments({r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]}) +
         "},\n                                   {" + position + "}})";
}

/// Everything but the links, first in the chain. A kept part replaces one of the same name.
std::string frame_parts(const Description& robot, const std::vector<std::string>& kept) {
  const auto& g = robot.gravity;
  const auto given = quantities_of(kept);
  std::string text;
  const auto add = [&](const std::string& part) {
    const auto names = quantities_of({part});
    if (!part.empty() && given.count(*names.begin()) == 0) text += "      " + part + ",\n";
  };
  add("axial::gravity(" + arguments({g.x, g.y, g.z}) + ")");
  add(frames_are_far(robot) ? "axial::accept(axial::as_published)" : "");
  add(pose_part("base", robot.base)), add(pose_part("tool", robot.tool)), add(base_body_part(robot));
  const auto& load = robot.payload_limit;
  if (load.declared) add("axial::payload_limit(" + arguments({load.mass, load.com_reach, load.inertia}) + ")");
  const auto& wrench = robot.tip_wrench_limit;
  if (wrench.declared) add("axial::tip_wrench_limit(" + arguments({wrench.force, wrench.moment}) + ")");
  if (robot.tool_limit.declared) add("axial::tool_limit(" + arguments({robot.tool_limit.reach}) + ")");
  for (const auto& line : kept)
    text += "      " + line + ",  // kept\n";
  return text;
}

std::vector<std::string> kept_of(const Kept& kept, const std::string& joint) {
  const auto found = kept.find(joint);
  return found == kept.end() ? std::vector<std::string>{} : found->second;
}

std::string link_parts(const Description& robot, const Kept& kept) {
  std::string text;
  for (int i = 0; i < robot.size(); ++i) {
    const Link& link = robot.links[static_cast<std::size_t>(i)];
    const std::string comma = i + 1 < robot.size() ? "," : "";
    text += "      // " + std::to_string(i) + ": " + harmless(link.joint) + " moves " + harmless(link.name) + "\n" +
            LinkText(link.parameters).text(parent_call(robot, i), kept_of(kept, harmless(link.joint)), comma) + "\n";
  }
  return text;
}

std::string drives_of(const Description& robot) {
  return shares_drives(robot) ? " of " + std::to_string(drive_matrix(robot).drives) + " drives" : "";
}

std::string leading_comment(const Description& robot, const std::vector<Finding>& warnings,
                            const std::vector<std::string>& figures, const Kept& kept) {
  const std::string name = robot.name.empty() ? "robot" : robot.name;
  std::string text =
      comment_lines("", name + ": " + std::to_string(robot.size()) + " joints" + drives_of(robot) + ", MDH frames.") +
      "//\n";
  text += comment_lines("source:   ", robot.source.empty() ? "not said" : robot.source);
  for (const auto& note : robot.notes)
    text += comment_lines("read:     ", note);
  for (const auto& assumption : robot.assumptions)
    text += comment_lines("assumed:  ", assumption);
  for (const auto& line : robot.fitted)
    text += comment_lines("fitted:   ", line);
  for (const auto& warning : warnings)
    text += comment_lines("warning:  ", warning.text());
  for (const auto& figure : figures)
    text += comment_lines("verified: ", figure);
  std::size_t count = 0;
  for (const auto& entry : kept)
    count += entry.second.size();
  if (count > 0)
    text += comment_lines("kept:     ", std::to_string(count) + " written by hand, which nothing verified");
  return text + comment_lines("yours:    ", "a line that ends in '// kept' stays when this file is written again");
}

std::string words(const Description& robot, bool capitals, const std::string& between) {
  std::string text;
  bool start = true;
  for (const char c : robot.name) {
    const auto letter = static_cast<unsigned char>(c);
    if (letter < 128 && std::isalnum(letter) != 0) {
      if (start && !text.empty()) text += between;
      text += static_cast<char>(capitals && start ? std::toupper(letter) : capitals ? c : std::tolower(letter));
    }
    start = !(letter < 128 && std::isalnum(letter) != 0);
  }
  const std::string fallback = capitals ? "Robot" : "robot";
  if (text.empty()) return fallback;
  return std::isdigit(static_cast<unsigned char>(text[0])) != 0 ? fallback + between + text : text;
}

void refuse_other_joints(const Description& robot, const Kept& kept) {
  for (const auto& entry : kept) {
    const bool known =
        entry.first.empty() || std::any_of(robot.links.begin(), robot.links.end(),
                                           [&](const Link& link) { return harmless(link.joint) == entry.first; });
    if (!known)
      throw Refused("kept line '" + entry.second[0] + "' stands at joint '" + entry.first +
                    "', which this robot has not; take the line out, or put it at another joint");
  }
}

/// The include that a robot needs: of the library as it is, or of its one header.
constexpr const char* includes =
    "#pragma once\n\n#ifndef AXIAL_ONE_HEADER\n#if __has_include(<axial/robot/chain.hpp>)\n#include "
    "<axial/robot/chain.hpp>\n"
    "#else\n#include \"axial.hpp\"  // of ./axial amalgamate\n#endif\n#endif\n\n";

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.flush();
  if (!file) throw Refused("cannot write '" + path + "'; is there such a folder, and may it be written?");
}

}  // namespace

std::string type_name(const Description& robot) { return words(robot, true, ""); }
std::string plain_name(const Description& robot) { return words(robot, false, "_"); }

std::string header(const Description& robot, const std::vector<std::string>& figures, const Kept& kept) {
  const auto warnings = check(robot);
  const std::string doubtful = lines_to_accept(warnings);
  if (!doubtful.empty()) throw Refused(doubtful);
  refuse_other_joints(robot, kept);
  return leading_comment(robot, warnings, figures, kept) + includes + "namespace robots {\n\nstruct " +
         type_name(robot) + " {\n  static constexpr const char* name = \"" + plain_name(robot) +
         "\";\n\n  // A line a group of values.\n  // clang-format off\n  static constexpr auto chain = "
         "axial::chain(\n" +
         frame_parts(robot, kept_of(kept, "")) + link_parts(robot, kept) +
         "  );\n  // clang-format on\n};\n\n}  // namespace robots\n";
}

Rewritten write_header(const std::string& path, const Description& robot, const std::vector<std::string>& figures) {
  const std::string before = text_of(path);
  Rewritten result{kept_lines(before), {}, ""};
  const std::string now = header(robot, figures, result.kept);
  result.lost = lines_that_are_lost(before, now);
  if (!result.lost.empty()) write_text(result.before = path + ".before", before);
  write_text(path, now);
  return result;
}

std::string said_of(const std::string& path, const Rewritten& rewritten) {
  constexpr std::size_t most = 5;
  std::string text;
  for (const auto& entry : rewritten.kept)
    for (const auto& line : entry.second)
      text += "kept:     " + line + (entry.first.empty() ? "" : " at " + entry.first) + "\n";
  if (rewritten.lost.empty()) return text;
  const bool one = rewritten.lost.size() == 1;
  text += std::to_string(rewritten.lost.size()) + (one ? " line" : " lines") + " of the old " + path +
          (one ? " is" : " are") + " not in the new one, which may be your changes; it is saved as " +
          rewritten.before + "\n";
  for (std::size_t i = 0; i < rewritten.lost.size() && i < most; ++i)
    text += "  " + rewritten.lost[i] + "\n";
  return text + "  (a line that ends in '// kept' stays)\n";
}

}  // namespace description
