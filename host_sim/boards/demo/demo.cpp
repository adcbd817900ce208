#include <host_sim/boards/demo/demo.hpp>

#include <host_sim/boards/demo/summary.hpp>
#include <host_sim/boards/emulator/qemu.hpp>
#include <host_sim/robots/trajectory/files.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <stdexcept>

namespace host_sim {

namespace {

std::string trajectory_file(const DemoOptions& options, const Robot& robot) {
  if (!options.trajectory.empty()) return options.trajectory;
  const char* const folder =
      robot.shares_drives() ? "/host_sim/robots/trajectories/shared_drives/" : "/host_sim/robots/trajectories/";
  return AXIAL_ROOT + std::string(folder) + robot.name + ".json";
}

Trajectory trajectory_of(const DemoOptions& options, const Robot& robot) {
  const std::string path = trajectory_file(options, robot);
  if (!robot.shares_drives()) return load_trajectory(path, robot.name, robot.limits);
  const auto positions = [&](const std::vector<double>& u) { return joint_positions(robot, u); };
  return load_trajectory(path, robot.name, robot.limits, [&](const Cycle& cycle) {
    return plan_of_drives(cycle, robot.limits, robot.moved, positions);
  });
}

const char* app_of(const std::string& number) {
  if (number == "float") return "feedforward";
  if (number == "fixed32") return "feedforward-fixed";
  throw std::runtime_error("unknown number '" + number + "'; there are: float, fixed32");
}

/// What the emulator printed belongs to the message when the conversation with it breaks.
Recording record(const Board& board, const std::string& image, const Robot& robot, const Trajectory& trajectory) {
  Emulator emulator(board, image);
  try {
    return stream(emulator.serial(), robot, trajectory);
  } catch (const std::runtime_error& error) {
    const std::string words = emulator.console();
    throw std::runtime_error(error.what() + (words.empty() ? "" : "\nthe emulator printed: " + words));
  }
}

std::vector<std::string> header(int joints, const std::string& counts) {
  std::vector<std::string> names = {"time"};
  for (const char* group : {"q", "qd", "qdd", "torque", "error"})
    for (int i = 1; i <= joints; ++i)
      names.push_back(group + std::to_string(i));
  names.push_back(counts);
  return names;
}

void write_csv(const std::string& path, const Recording& recording, int joints, const std::string& counts) {
  CsvFile file(path, header(joints, counts));
  for (const Sample& s : recording.samples) {
    file.cell(s.asked.time);
    for (const auto* group : {&s.asked.q, &s.asked.qd, &s.asked.qdd, &s.torque})
      for (const double value : *group)
        file.cell(value);
    for (std::size_t i = 0; i < s.torque.size(); ++i)
      file.cell(s.torque[i] - s.exact[i], 4);
    file.cell(s.count);
    file.end_row();
  }
}

void write_files(const DemoOptions& options, const Recording& recording, const Summary& summary) {
  make_folder(options.output);
  const std::string suffix = options.number == "float" ? "" : "-" + options.number;
  const std::string stem = options.output + "/" + summary.robot.name + "-" + summary.board.name + suffix;
  write_csv(stem + ".csv", recording, summary.robot.joints(), summary.board.counts);
  write_json(stem + ".json", to_json(summary));
  if (!options.json.empty()) write_json(options.json, to_json(summary));
  if (!options.without_picture) run_plot("demo.py", {stem + ".csv", stem + ".json"});
  std::printf("\n");
  if (!options.without_picture) std::printf("picture  %s.png\n", stem.c_str());
  std::printf("data     %s.csv, %s.json\n", stem.c_str(), stem.c_str());
}

}  // namespace

int run_demo(const DemoOptions& options) {
  const Robot robot = find_robot(options.robot);
  const Board board = read_board(options.board);
  const Trajectory trajectory = trajectory_of(options, robot);
  const std::string image = image_path(board, app_of(options.number), robot.name);

  const Recording recording = record(board, image, robot, trajectory);
  const Summary summary = summarise(recording, robot, board, image, options.number);
  std::printf("%s", describe(summary).c_str());
  write_files(options, recording, summary);
  if (within_bound(summary)) return 0;
  for (std::size_t i = 0; i < summary.joints.size(); ++i)
    if (!(summary.joints[i].largest() <= summary.bounds[i]))
      std::fprintf(stderr, "demo: %s %zu: the largest error is above its bound of %s %s\n", robot.noun(), i + 1,
                   significant(summary.bounds[i]).c_str(), robot.effort_unit(static_cast<int>(i)));
  return 1;
}

}  // namespace host_sim
