#include <host_sim/boards/demo/summary.hpp>

#include <host_sim/boards/demo/bounds.hpp>
#include <host_sim/tools/analysis/joint_scales.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

namespace host_sim {

namespace {

std::string library_of(const link::Hello& hello) {
  const auto v = hello.library;
  return std::to_string(v / 10000) + "." + std::to_string(v / 100 % 100) + "." + std::to_string(v % 100);
}

bool is_fixed(const Summary& s) { return s.number == "fixed32"; }

std::string table_of_errors(const Summary& s) {
  std::vector<std::string> names = {s.robot.noun(),     "unit",        "largest torque", "largest error", "RMS error",
                                    "largest relative", "RMS relative"};
  if (is_fixed(s)) names.push_back("bound");
  Table table(names);
  for (std::size_t i = 0; i < s.joints.size(); ++i) {
    const ErrorStatistics& e = s.joints[i];
    std::vector<std::string> row = {std::to_string(i + 1),
                                    s.robot.effort_unit(static_cast<int>(i)),
                                    significant(e.scale(), 4),
                                    significant(e.largest()),
                                    significant(e.rms()),
                                    significant(relative(s, i, e.largest())),
                                    significant(relative(s, i, e.rms()))};
    if (is_fixed(s)) row.push_back(significant(s.bounds[i]));
    table.add(row);
  }
  return table.text();
}

std::string cost_lines(const Summary& s) {
  const std::string said = s.board.counts + " per torque";
  return said + std::string(25 - said.size(), ' ') + grouped(s.counts.min) + " to " + grouped(s.counts.max) +
         "  (counted in " + s.board.emulator_name + (s.board.counts == "cycles" ? ")\n" : "; not cycles)\n") +  //
         "flash                    " + grouped(s.image.flash) + " of " + grouped(s.board.flash_bytes) + " bytes\n" +
         "RAM                      " + grouped(s.image.ram) + " of " + grouped(s.board.ram_bytes) + " bytes\n" +
         "stack, deepest use       " + grouped(s.stack) + " bytes\n";
}

}  // namespace

Summary summarise(const Recording& recording, const Robot& robot, const Board& board, const std::string& image,
                  const std::string& number) {
  Summary summary{
      robot, board, std::vector<ErrorStatistics>(robot.limits.size()), {}, number, {}, {}, image_size(image)};
  for (const Sample& sample : recording.samples) {
    for (std::size_t i = 0; i < sample.torque.size(); ++i)
      summary.joints[i].add(sample.torque[i], sample.exact[i]);
    summary.counts.add(sample.count);
  }
  for (const ErrorStatistics& joint : summary.joints)
    summary.scales.push_back(joint.scale());
  summary.scales = joint_scales(summary.scales);
  summary.bounds = is_fixed(summary) ? fixed32_bounds(recording, robot) : float_bounds(summary.scales);
  summary.hello = recording.hello;
  summary.stack = recording.stats.stack_bytes;
  summary.set_points = recording.samples.size();
  summary.duration = recording.samples.back().asked.time;
  return summary;
}

double relative(const Summary& summary, std::size_t joint, double error) {
  return error == 0.0 ? 0.0 : error / summary.scales[joint];
}

bool within_bound(const Summary& summary) {
  for (std::size_t i = 0; i < summary.joints.size(); ++i)
    if (!(summary.joints[i].largest() <= summary.bounds[i])) return false;
  return true;
}

std::string describe(const Summary& s) {
  return "axial " + library_of(s.hello) + ": " + s.robot.name + " on " + s.board.name +
         (is_fixed(s) ? ", 32-bit fixed point," : "") + " in " + s.board.emulator_name + ": " + grouped(s.set_points) +
         " set-points, " + significant(s.duration) + " s of motion\n\n" + table_of_errors(s) + "\n" + cost_lines(s);
}

nlohmann::json to_json(const Summary& s) {
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t i = 0; i < s.joints.size(); ++i) {
    const ErrorStatistics& e = s.joints[i];
    rows.push_back({{"axial", library_of(s.hello)},
                    {"robot", s.robot.name},
                    {"board", s.board.name},
                    {"scalar", s.number},
                    {"joint", i + 1},
                    {"values_of", s.robot.noun()},
                    {"unit", s.robot.effort_unit(static_cast<int>(i))},
                    {"torque_max", e.scale()},
                    {"torque_scale", s.scales[i]},
                    {"error_max", e.largest()},
                    {"error_max_relative", relative(s, i, e.largest())},
                    {"error_rms", e.rms()},
                    {"error_rms_relative", relative(s, i, e.rms())},
                    {"error_bound_relative", relative(s, i, s.bounds[i])},
                    {"emulator", s.board.emulator_name},
                    {s.board.counts + "_min", s.counts.min},
                    {s.board.counts + "_max", s.counts.max},
                    {"flash_bytes", s.image.flash},
                    {"ram_bytes", s.image.ram},
                    {"stack_bytes", s.stack},
                    {"set_points", s.set_points}});
  }
  return rows;
}

}  // namespace host_sim
