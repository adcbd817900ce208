// import: a robot's description becomes a verified constexpr header.
#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/description/header.hpp>
#include <host_sim/robots/import/importer.hpp>
#include <host_sim/tools/output/command_line.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>

namespace {

struct Arguments {
  std::string file, output, json;
  std::vector<double> gravity;
  bool strict = false;
  importer::Options options;
};

/// Numbers of the file that are read as others.
nlohmann::json changes(const importer::Imported& imported) {
  static constexpr const char* kinds[] = {"rpy of joint",  "xyz of joint", "axis of joint", "rpy of inertial of link",
                                          "turn of joint", "angle of row", "length of row", "rotation of"};
  nlohmann::json list = nlohmann::json::array();
  for (const auto& change : imported.changes)
    list.push_back({{"of", std::string(kinds[static_cast<int>(change.of)]) + " " + change.name},
                    {"index", change.index},
                    {"written", change.written},
                    {"read", change.read}});
  return list;
}

nlohmann::json engine(const importer::EngineFigures& figures) {
  if (figures.engine.empty()) return {{"name", ""}, {"why_not", figures.why_not}};
  return {{"name", figures.engine}, {"states", figures.states}, {"bound", figures.bound},
          {"pose", figures.pose},   {"torque", figures.torque}, {"mass_matrix", figures.mass_matrix},
          {"body", figures.body},   {"joint", figures.joint}};
}

nlohmann::json to_json(const importer::Result& result, const std::string& header) {
  const auto& robot = result.imported.robot;
  const auto& figures = result.figures;
  nlohmann::json warnings = nlohmann::json::array(), joints = nlohmann::json::array();
  bool masses = false;
  for (const auto& warning : result.imported.warnings)
    warnings.push_back({{"link", warning.link}, {"what", warning.what}, {"remedy", warning.remedy}});
  for (const auto& link : robot.links)
    joints.push_back(link.joint), masses = masses || link.parameters.mass > 0.0;
  return {{"name", robot.name},
          {"source", robot.source},
          {"header", header},
          {"joints", joints},
          {"masses", masses},
          {"notes", robot.notes},
          {"assumptions", robot.assumptions},
          {"warnings", warnings},
          {"states", figures.states},
          {"seed", figures.seed},
          {"pose_error", figures.pose},
          {"torque_error", figures.torque},
          {"mass_matrix_error", figures.mass_matrix},
          {"body_error", figures.body},
          {"engine", engine(figures.engine)},
          {"changes", changes(result.imported)},
          {"within_bounds", figures.good()}};
}

void write_json(const std::string& path, const nlohmann::json& value) {
  std::ofstream file(path);
  file << value.dump(2) << '\n';
  file.flush();
  if (!file) throw description::Refused("cannot write '" + path + "'; is there such a folder?");
}

void print(const importer::Result& result) {
  const auto& robot = result.imported.robot;
  std::printf("%s: %d joints", robot.name.c_str(), robot.size());
  if (description::shares_drives(robot)) std::printf(", %d drives", description::drive_matrix(robot).drives);
  std::printf("\n");
  for (const auto& note : robot.notes)
    std::printf("read:     %s\n", note.c_str());
  for (const auto& assumption : robot.assumptions)
    std::printf("assumed:  %s\n", assumption.c_str());
  for (const auto& line : result.figures.lines())
    std::printf("verified: %s\n", line.c_str());
  for (const auto& warning : result.imported.warnings)
    std::fprintf(stderr, "import: warning: %s\n", warning.text().c_str());
}

int import_robot(Arguments& arguments) {
  if (!arguments.gravity.empty())
    arguments.options.gravity = {arguments.gravity[0], arguments.gravity[1], arguments.gravity[2]};
  const auto result = importer::import_file(arguments.file, arguments.options);
  const auto& robot = result.imported.robot;
  print(result);
  const std::string output = arguments.output.empty() ? description::plain_name(robot) + ".hpp" : arguments.output;
  if (!arguments.json.empty()) write_json(arguments.json, to_json(result, output));
  if (!result.figures.engine.good())
    throw description::Refused(arguments.file + ": not written: " + result.figures.engine.engine +
                               " understands the file otherwise, as the figures above say; import what it makes of "
                               "it: load the file there and save it (MuJoCo's mj_saveLastXML, gz sdf -p)");
  if (!result.figures.good())
    throw description::Refused(arguments.file +
                               ": not written: the figures above miss their bounds; axes that are almost "
                               "parallel put frames far away: see --snap");
  if (!description::lines_to_accept(result.imported.warnings).empty())
    throw description::Refused(arguments.file +
                               ": not written: axial does not compile what the warnings with --as-published are "
                               "about; correct it, or keep it with that option");
  if (arguments.strict && !result.imported.warnings.empty())
    throw description::Refused(arguments.file + ": not written: there are warnings, and --strict was given");
  const auto rewritten = description::write_header(output, robot, result.figures.lines());
  std::fputs(description::said_of(output, rewritten).c_str(), stderr);
  std::printf("written:  %s (robots::%s)\n", output.c_str(), description::type_name(robot).c_str());
  return 0;
}

}  // namespace

int main(int count, char** given) {
  Arguments arguments;
  auto& options = arguments.options;
  host_sim::CommandLine line("a URDF, an MJCF, an SDF or a Denavit-Hartenberg table as a verified header", "import");
  line.option("file", arguments.file, "URDF, MJCF, SDF, or JSON table").required();
  line.option("--engine", options.engine,
              "to ask MuJoCo about an MJCF, the folder of npm's mujoco-js; DART about an SDF, the program dart_engine");
  line.option("--root", options.reading.root, "link to start from; default: the URDF's root");
  line.option("--tip", options.reading.tip, "link to end at, its frame is the tool's; default: every branch");
  line.option("--name", options.name, "name of the robot; default: the file's");
  line.option("-o,--output", arguments.output, "the header; default: <name>.hpp");
  line.option("--json", arguments.json, "figures, assumptions, warnings");
  line.option("--gravity", arguments.gravity, "m/s^2 in axes of the root link; default 0 0 -9.81").expected(3);
  line.option("--right-angles", options.reading.right_angles,
              "rad within which an angle or an axis is one of a multiple of 90 degrees; 0: as written")
      .show_default()
      .range(0.0, 0.01);
  line.flag("--snap", options.reading.snap,
            "make joints' angles and axes exact that are within 0.005 rad of a multiple of 90 degrees");
  line.option("--to-speed", options.assumed.seconds_to_speed, "s to full speed, where no acceleration limit is given")
      .show_default()
      .range(1e-3, 1e3);
  line.option("--position-limit", options.assumed.position,
              "rad or m either way, where none is given or it is left blank as 0")
      .range(0.0, 1e6);
  line.option("--speed-limit", options.assumed.speed, "rad/s or m/s, where none is given").range(0.0, 1e6);
  line.option("--effort-limit", options.assumed.effort, "N m or N, where none is given; default: unlimited")
      .range(0.0, 1e9);
  line.option("--states", options.states, "random states to verify on").show_default().range(1, 100000);
  line.option("--seed", options.seed, "of those states").show_default();
  line.flag("--as-published", options.as_published,
            "keep inertias, lengths and limits that no robot should have: .accept(axial::as_published)");
  line.flag("--hold-mimic", options.reading.hold_mimic,
            "hold joints that mimic another one where that is 0, and carry their bodies along");
  line.flag("--strict", arguments.strict, "write nothing where there are warnings");
  return line.run(count, given, [&] { return import_robot(arguments); });
}
