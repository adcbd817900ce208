#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/couplings.hpp>
#include <host_sim/robots/import/importer.hpp>
#include <host_sim/robots/import/mjcf/mjcf_reader.hpp>
#include <host_sim/robots/import/right_angles.hpp>
#include <host_sim/robots/import/sdf/sdf_reader.hpp>
#include <host_sim/robots/import/to_mdh.hpp>
#include <host_sim/robots/import/urdf/urdf_reader.hpp>
#include <host_sim/robots/import/urdf/urdf_text.hpp>
#include <host_sim/robots/import/xml_text.hpp>

#include <axial/robot/classical.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace importer {
namespace {

using description::Finding;

/// A file's own words before each line of a list.
[[noreturn]] void refuse(const std::string& from, const std::string& lines) {
  std::string text = from + ": ";
  for (const char c : lines)
    text += c == '\n' ? "\n" + from + ": " : std::string(1, c);
  throw description::Refused(text);
}

/// What a header says of its source: the folder is of this machine alone.
std::string file_name(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

void check(Imported& imported, const std::string& from, std::vector<Finding> found) {
  const auto errors = description::lines(found, true);
  if (!errors.empty()) refuse(from, errors);
  for (auto& finding : found)
    imported.warnings.push_back(finding);
}

/// Bodies as the file has them, before any is merged into another: what of them axial refuses is said of the sum.
std::vector<Finding> source_findings(const SourceTree& source) {
  std::vector<Finding> found;
  for (const auto& link : source.links) {
    for (const double v : link.joint.origin.position)
      if (!(std::abs(v) <= description::largest_number))
        found.push_back({true, link.name, "joint '" + link.joint.name + "': origin is beyond 1e9 m", "give metres"});
    if (!link.has_inertial) continue;
    axial::LinkParameters body;
    body.mass = link.mass;
    std::memcpy(body.com, link.inertial.position.data(), sizeof body.com);
    std::memcpy(body.inertia_com, link.inertia.data(), sizeof body.inertia_com);
    for (auto& finding : description::body_findings(link.name, body, false)) {
      finding.must_be_accepted = false;
      found.push_back(finding);
    }
  }
  return found;
}

/// Of the description: what was not said of the source's bodies one by one.
std::vector<Finding> other_findings(const description::Description& robot, const SourceTree* source) {
  std::vector<Finding> found;
  for (const auto& finding : description::findings(robot)) {
    bool said = false;
    if (source != nullptr)
      for (const auto& link : source->links)
        said = said || (link.name == finding.link && (link.has_inertial || link.between) &&
                        finding.what.rfind("joint '", 0) != 0);
    if (!said || finding.error || finding.must_be_accepted) found.push_back(finding);
  }
  return found;
}

/// What was said of a body already is not said again of the link that is this body alone.
void drop_repeated(std::vector<Finding>& earlier, const std::vector<Finding>& now) {
  const auto repeated = [&](const Finding& finding) {
    return std::any_of(now.begin(), now.end(), [&](const Finding& other) { return other.text() == finding.text(); });
  };
  earlier.erase(std::remove_if(earlier.begin(), earlier.end(), repeated), earlier.end());
}

bool branches(const description::Description& robot) {
  for (int i = 0; i < robot.size(); ++i)
    if (robot.parent(i) != i - 1) return true;
  return false;
}

/// Without --tip, on a chain: the one link at its end, if there is one and it does not move any further.
void choose_tool(SourceTree& source, const Imported& imported) {
  if (source.tool >= 0 || branches(imported.robot)) return;
  const int last = imported.robot.size() - 1;
  std::vector<bool> carries(source.links.size());
  for (const auto& link : source.links)
    if (link.parent >= 0) carries[static_cast<std::size_t>(link.parent)] = true;
  int found = 0;
  for (std::size_t i = 0; i < source.links.size(); ++i)
    if (!carries[i] && imported.frames[i].link == last) ++found, source.tool = static_cast<int>(i);
  if (found != 1) source.tool = -1;
  if (source.tool >= 0)
    source.notes.push_back("tool: frame of link '" + source.links[static_cast<std::size_t>(source.tool)].name +
                           "', the chain's only end");
}

/// With what only states show: joints that no mass resists.
Result verified(Imported& imported, const Reference& reference, const Options& options) {
  Result result{imported, verify(imported, reference, options.seed, options.states)};
  const auto said = [&](const std::string& what) {
    return std::any_of(result.imported.warnings.begin(), result.imported.warnings.end(),
                       [&](const Finding& finding) { return finding.what == what; });
  };
  for (const int i : result.figures.unresisted) {
    const auto& link = imported.robot.links[static_cast<std::size_t>(i)];
    if (said("joint '" + link.joint + "' moves nothing that has inertia")) continue;
    result.imported.warnings.push_back(
        {false, link.name,
         "joint '" + link.joint + "' is resisted by 0 kg m^2: what it carries has no inertia about it",
         "give the link's inertia about the joint's axis, or .rotor_inertia(); forward dynamics and cost need one"});
  }
  return result;
}

/// Of a tree whose warnings are its reader's: rows, couplings, findings. `source` is settled, and has its tool.
Imported described(SourceTree& source, const axial::GravityVector& gravity, const std::string& from,
                   const Options& options) {
  Imported imported;
  imported.warnings = source.warnings;
  check(imported, from, source_findings(source));
  const auto near = nearness_of(options.reading, source.length_digit);
  choose_tool(source, to_mdh(source, gravity, near));
  const auto warnings = imported.warnings;
  for (const auto& line : sentences(source.changes, near))
    source.notes.push_back(line);
  imported = to_mdh(source, gravity, {0.0});  // settled once
  imported.warnings = warnings, imported.changes = source.changes;
  imported.robot.as_published = options.as_published;
  couple(source, imported.robot);
  const auto found = other_findings(imported.robot, &source);
  drop_repeated(imported.warnings, found);
  check(imported, from, found);
  for (std::size_t i = 0; i < imported.frames.size(); ++i)
    imported.frames[i].name = i == 0 && !source.floating ? "root" : segment_name(source.links[i].name);
  return imported;
}

std::string source_of(const SourceTree& source, const std::string& from, const std::string& format,
                      const std::string& parts) {
  std::string text = file_name(from) + " (" + format + "), " + parts + " of '" + source.links[0].name + "'";
  if (source.tool >= 0)
    text += " to '" + source.links[static_cast<std::size_t>(source.tool)].name + "', whose frame is the tool's";
  return text;
}
std::vector<std::string> joints_of(const description::Description& robot) {
  std::vector<std::string> joints;
  for (const auto& link : robot.links)
    joints.push_back(link.joint);
  return joints;
}

Result import_urdf(const std::string& text, const std::string& from, const Options& options) {
  auto source = read_urdf(text, from, options.reading);
  const auto gravity = options.gravity.value_or(axial::GravityVector{});
  auto imported = described(source, gravity, from, options);
  auto& robot = imported.robot;
  robot.source = source_of(source, from, "URDF", "links");
  std::vector<std::string> assumed;
  if (!options.gravity) assumed.push_back("gravity of 9.81 m/s^2 along -z of link '" + source.links[0].name + "'");
  assumed.push_back(std::string(description::no_rotors) + ": a URDF has none");
  robot.assumptions.insert(robot.assumptions.begin(), assumed.begin(), assumed.end());
  const std::string tool = source.tool > 0 ? source.links[static_cast<std::size_t>(source.tool)].name : "";
  const auto reference = reference_of(text, options.reading, source.changes, gravity, joints_of(robot), tool);
  return verified(imported, reference, options);
}

/// What the header says of rotors: an armature is one, on the joint's side.
void say_rotors(description::Description& robot) {
  std::string without;
  for (const auto& link : robot.links)
    if (link.parameters.rotor_inertia == 0.0 && !link.parameters.drives.follows)
      without += (without.empty() ? "" : ", ") + link.joint;
  if (!without.empty())
    robot.assumptions.insert(robot.assumptions.begin(),
                             std::string(description::no_rotors) + ", where a joint has no armature: " + without);
}

/// Joints that --snap alone would turn, in a file of which the reader names none.
std::vector<Finding> nearly_right_joints(SourceTree source, const axial::GravityVector& gravity,
                                         const ReadingOptions& options) {
  const auto near = nearness_of(options, source.length_digit);
  to_mdh(source, gravity, {near.angle, true, near.length});
  std::map<std::string, double> turns;  // of joints, rad
  for (const auto& change : source.changes)
    if (change.of == Change::Of::joint_turn) turns[change.name] = std::hypot(turns[change.name], change.read);
  std::vector<Finding> found;
  for (const auto& [joint, turn] : turns)
    if (turn > near.of_joints()) found.push_back(nearly_right_joint(joint, turn));
  return found;
}

/// Of a format that has an engine of its own, which `program` runs.
Result import_engine_tree(const EngineTree& read, const std::string& format, const std::string& parts,
                          const std::vector<std::string>& program, const std::string& from, const Options& options) {
  const auto gravity = options.gravity.value_or(read.gravity);
  auto source = read.tree;  // what of it is near a special value becomes it
  auto imported = described(source, gravity, from, options);
  for (const auto& joint : nearly_right_joints(read.tree, gravity, options.reading))
    imported.warnings.push_back(joint);
  auto& robot = imported.robot;
  robot.source = source_of(source, from, format, parts);
  robot.assumptions.insert(robot.assumptions.begin(), read.assumptions.begin(), read.assumptions.end());
  auto result =
      verified(imported, reference_of(source, read.tree, options.reading, gravity, joints_of(robot)), options);
  result.figures.against = "against Orocos KDL on the tree of the file's " + parts + ", on ";
  result.figures.engine = ask_engine(program, from, read, options.seed, options.states);
  return result;
}

Result import_mjcf(const std::string& text, const std::string& from, const Options& options) {
  std::vector<std::string> program;
  if (!options.engine.empty()) program = {"node", AXIAL_MUJOCO_SCRIPT, options.engine};
  auto result = import_engine_tree(read_mjcf(text, from, options.reading), "MJCF", "bodies", program, from, options);
  say_rotors(result.imported.robot);
  return result;
}

Result import_sdf(const std::string& text, const std::string& from, const Options& options) {
  std::vector<std::string> program;
  if (!options.engine.empty()) program = {options.engine};
  auto read = read_sdf(text, from, options.reading);
  if (options.gravity) read.assumptions.clear();
  read.assumptions.push_back(std::string(description::no_rotors) + ": an SDF has none");
  return import_engine_tree(read, "SDF", "links", program, from, options);
}

/// m: how fine a table's lengths are written.
double length_digit_of(const description::Table& table) {
  LengthDigit digit;
  for (const auto& link : table.robot.links)
    for (const double length : {link.parameters.a, link.parameters.d, link.parameters.b})
      digit.see(description::number(length), length);
  return digit.value();
}

Result import_table(const std::string& text, const std::string& from, const Options& options) {
  if (!options.reading.root.empty() || !options.reading.tip.empty() || options.gravity)
    throw description::Refused(
        from +
        ": --root, --tip and --gravity are for a URDF, an MJCF or an SDF; a table is imported whole, with its own");
  auto table = description::parse_table(text, from);
  Imported imported;
  const auto near = nearness_of(options.reading, length_digit_of(table));
  auto changed = table_right_angles(table, near);
  imported.warnings = changed.warnings, imported.changes = changed.changes;
  imported.robot = description::to_mdh(table);
  imported.robot.as_published = options.as_published;
  check(imported, from, description::findings(imported.robot));
  for (int i = 0; i < imported.robot.size(); ++i) {
    TrackedFrame tracked{segment_name(i + 1), i, {}};
    const auto& p = table.robot.links[static_cast<std::size_t>(i)].parameters;
    if (table.classical) tracked.pose = axial::detail::FarEnd{p.alpha, p.a}.carried({});
    imported.frames.push_back(tracked);
  }
  return verified(imported, reference_of(text, imported.changes, near.of_joints()), options);
}

/// By its first element: the wrong kind says what it is.
Result import_xml(const std::string& text, const std::string& from, const Options& options) {
  static const std::map<std::string, std::string> others{
      {"mujocoinclude", "a part of an MJCF, which another file includes"},
      {"gazebo", "an SDF of a version before 1.3"},
      {"COLLADA", "a COLLADA mesh"},
      {"launch", "a launch file of ROS"},
      {"html", "a page of the web"}};
  const std::string first = first_element(text);
  if (first == "mujoco") return import_mjcf(text, from, options);
  if (first == "sdf") return import_sdf(text, from, options);
  if (const auto other = others.find(first); other != others.end())
    throw description::Refused(from + ": this is " + other->second +
                               ", there is no <robot> element; give a URDF, an MJCF, an SDF or a JSON table");
  return import_urdf(text, from, options);
}

}  // namespace

Result import_text(const std::string& text, const std::string& from, const Options& options) {
  const auto first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string::npos && (text[first] == '{' || text[first] == '[');
  Result result = json ? import_table(text, from, options) : import_xml(text, from, options);
  auto& robot = result.imported.robot;
  if (!options.name.empty()) robot.name = options.name;
  assume_limits(robot, options.assumed);
  if (description::shares_drives(robot)) assume_drive_limits(robot);
  return result;
}

Result import_file(const std::string& path, const Options& options) {
  return import_text(description::read_text(path), path, options);
}

}  // namespace importer
