// hil-<robot>: a controller's image on one emulated board, its arm on another, in lock-step; the same loop around an
// arm on this host; what becomes of faults of the line between them.
#include <firmware/apps/run/motion.hpp>
#include <firmware/apps/tracking/controller.hpp>
#include <host_sim/plants/loop/cycle.hpp>
#include <host_sim/plants/loop/on_host.hpp>
#include <host_sim/plants/two_boards/board_arm.hpp>
#include <host_sim/plants/two_boards/faults.hpp>
#include <host_sim/plants/two_boards/same_source.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/progress.hpp>
#include <host_sim/tools/output/table.hpp>
#include <host_sim/tools/output/verdict.hpp>

#include <robot.hpp>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace {

using namespace host_sim;
using axial::apps::Robot;

constexpr double tracking_difference = 0.02;  // of the tool's error beside that around the host's arm
constexpr std::uint32_t most_places = 4;      // of float between a board and this host
constexpr std::size_t drawn_ticks = 4000;
constexpr bool own = AXIAL_HAS_CYCLE == 0;
constexpr const char* image_name = own ? "own" : Robot::name;
constexpr int count = axial::joint_count<Robot>;  // of joints, or of drives that they share
constexpr auto joints = static_cast<std::size_t>(count);
constexpr bool rigid = std::is_same_v<axial::apps::plant::MechanicsOf<Robot>, axial::apps::plant::NoMechanics>;
constexpr bool shares_drives = axial::detail::shares_drives_in<axial::scene_of<Robot>::Robot>;

struct Options {
  std::string controller = "stm32f405", plant = "stm32f405", number = "float", plant_number = "float", output, json;
  std::string controller_port, plant_port;  ///< of boards on the desk
  double seconds = 2.0;
  double carried = 0.0;  ///< kg, through the second and third quarter of the motion
  bool faults = false;
};

/// The robot's cycle; a header's robot moves smoothly inside its limits, from where its joints turn back.
Trajectory course() {
  if constexpr (!own) return loop::cycle_of(Robot::name);
  constexpr double pi = 3.14159265358979323846;
  constexpr int ticks = 16000;  // four periods of the slowest joint, whole ones of every other
  Trajectory all;
  for (int k = 0; k < ticks; ++k) {
    SetPoint point;
    for (int i = 0; i < count; ++i) {
      const auto m = axial::apps::run::motion<Robot>(i, 0.5 * pi / axial::apps::run::rate(i) + k * loop::control_tick);
      point.q.push_back(m.q), point.qd.push_back(m.qd), point.qdd.push_back(m.qdd);
    }
    all.push_back(point);
  }
  return all;
}

[[maybe_unused]] simulation::Model model() {
  simulation::Model m;
  for (int i = 0; i < Robot::chain.size; ++i) {
    auto link = Robot::chain.links[i];
    link.parent = Robot::chain.parent(i) < 0 ? axial::LinkParameters::base : Robot::chain.parent(i);
    link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
    if (!m.add(link)) throw std::runtime_error("an arm has twelve joints at most");
  }
  const auto& g = Robot::chain.gravity;
  m.set_gravity(g.x, g.y, g.z), m.set_base(Robot::chain.base.pose), m.set_tool(Robot::chain.tool.pose);
  return m;
}

[[maybe_unused]] std::vector<axial::LinkParameters> links() {
  return {Robot::chain.links, Robot::chain.links + Robot::chain.size};
}

std::unique_ptr<loop::Controller> controller_on_host(bool fixed) {
  if (fixed) return std::make_unique<loop::OnHost<axial::apps::TrackingController<Robot, axial::Fixed32>>>();
  return std::make_unique<loop::OnHost<axial::apps::TrackingController<Robot, float>>>();
}

std::string app(const char* name, const std::string& number) {
  return std::string(name) + (loop::is_fixed(number) ? "-fixed" : "");
}

struct Result {
  loop::Tracking boards, host;
  std::uint32_t places = 0, controller_most = 0, plant_most = 0;
  long told = 0;
  double ticks_a_second = 0.0, difference = 0.0;
};

class TwoBoards {
 public:
  explicit TwoBoards(const Options& options) : options_(options), cycle_(course()) {
    situation_.robot = Robot::name, situation_.seconds = options.seconds;
  }

  Result run(CsvFile& file) {
    BoardOnLine controller(options_.controller, app("tracking", options_.number), image_name, options_.controller_port);
    BoardOnLine plant(options_.plant, app("arm", options_.plant_number), image_name, options_.plant_port);
    expect_image(controller, "controller", options_.controller), expect_image(plant, "plant", options_.plant);
    rearm(controller, options_.controller_port), rearm(plant, options_.plant_port);
    try {
      return run(controller, plant, file);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(error.what() + said("the controller", controller) + said("the plant", plant));
    }
  }
  std::vector<two_boards::FaultRow> faults() {
    Progress progress("faults of the line", two_boards::fault_count());
    return two_boards::faults_of_line({options_.controller, app("tracking", options_.number), options_.plant,
                                       app("arm", options_.plant_number), image_name},
                                      cycle_, [&](std::size_t done) { progress.at(done); });
  }

 private:
  using BoardOnLine = two_boards::BoardOnLine;
  using Carry = std::function<void(const link::ArmLoad&)>;
  struct HostArm {
    std::shared_ptr<loop::Arm> arm;
    Carry carry;
  };
  /// A board on the desk may run whatever it was given last.
  static void expect_image(const BoardOnLine& board, const std::string& who, const std::string& name) {
    const auto& hello = board.firmware.hello();
    if (hello.robot == link::make_name(Robot::name) && hello.board == link::make_name(name.c_str())) return;
    throw std::runtime_error("the " + who + "'s board runs an image of " + hello.robot.data() + " for " +
                             hello.board.data() + ", not of " + Robot::name + " for " + name);
  }
  /// Drives that were held when the port was opened may have been disabled since: a session anew, now that both boards
  /// are there.
  static void rearm(BoardOnLine& board, const std::string& port) {
    if (!port.empty() && !board.firmware.try_session(std::chrono::seconds(2)))
      throw std::runtime_error("the board at " + port + " answers no more");
  }
  static std::string said(const std::string& who, const BoardOnLine& board) {
    const std::string words = board.console();
    return words.empty() ? "" : "\n" + who + " printed: " + words;
  }

  Result run(BoardOnLine& controller, BoardOnLine& plant, CsvFile& file) {
    Result result;
    two_boards::BoardController on_board(controller);
    const auto beside = controller_on_host(loop::is_fixed(options_.number));
    loop::Both both(on_board, *beside);
    two_boards::BoardArm arm(plant, cycle_.front(), two_boards::slides_of<Robot>(), tool);
    const auto start = std::chrono::steady_clock::now();
    result.boards = follow(arm, both, "two boards", file, [&](const auto& load) { arm.carry(load); });
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    result.ticks_a_second = static_cast<double>(result.boards.ticks) / took.count();
    result.places = both.worst, result.controller_most = both.most;
    result.plant_most = arm.most(), result.told = arm.told();
    const auto again = controller_on_host(loop::is_fixed(options_.number));
    const HostArm hosts = arm_on_host();
    result.host = follow(*hosts.arm, *again, "the host's plant", file, hosts.carry);
    result.difference = result.boards.tool_rms / result.host.tool_rms - 1.0;
    return result;
  }

  static axial::Vec3<double> tool(const std::vector<double>& q) {
    axial::Joints<Robot, double> values{};
    std::copy(q.begin(), q.end(), values.values);
    return axial::forward_kinematics<Robot>(values).tool.position;
  }
  /// What a robot's Mechanics add, and drives that joints share, are known to the image's own source alone.
  HostArm arm_on_host() const {
    if constexpr (rigid && !shares_drives) {
      return {loop::arm_on_host(situation_, cycle_.front(), model(), links()), {}};
    } else {
      auto arm = std::make_shared<two_boards::SameSourceArm<Robot>>(cycle_.front(), tool);
      return {arm, [arm](const link::ArmLoad& load) { arm->carry(load); }};
    }
  }

  loop::Tracking follow(loop::Arm& arm, loop::Controller& controller, const char* name, CsvFile& file,
                        const Carry& carry) {
    std::size_t done = 0;
    const auto all = static_cast<std::size_t>(std::lround(1000.0 * options_.seconds));
    const link::ArmLoad load{static_cast<float>(options_.carried), {}, {}};
    Progress progress(name, all);
    return loop::follow(
        situation_, cycle_, 0, arm, controller,
        [&](const SetPoint& wanted, const loop::JointState& now, const link::Measurement&, const link::Torque& answer) {
          progress.at(++done);
          if (options_.carried > 0.0 && done == all / 4) carry(load);
          if (options_.carried > 0.0 && done == 3 * all / 4) carry({});
          if (done > drawn_ticks) return;
          file.cell(name), file.cell(static_cast<double>(done - 1) * 1e-3);
          for (std::size_t i = 0; i < joints; ++i)
            file.cell(wanted.q[i]), file.cell(wanted.q[i] - now.q[i], 5);
          for (std::size_t i = 0; i < joints; ++i)
            file.cell(static_cast<double>(answer.tau[i]));
          file.end_row();
        });
  }

  const Options& options_;
  Trajectory cycle_;
  loop::Case situation_;
};

nlohmann::json row_of(const Options& options, const Result& r) {
  return {{"robot", Robot::name},
          {"board", options.controller},
          {"scalar", options.number},
          {"plant_board", options.plant},
          {"plant_scalar", options.plant_number},
          {"seconds", options.seconds},
          {"carried_kg", options.carried},
          {"ticks", r.boards.ticks},
          {"ticks_per_s", r.ticks_a_second},
          {"tool_error_rms", r.boards.tool_rms},
          {"tool_error_max", r.boards.tool_largest},
          {"joint_error_rms", r.boards.rms},
          {"host_tool_error_rms", r.host.tool_rms},
          {"host_tool_error_max", r.host.tool_largest},
          {"host_joint_error_rms", r.host.rms},
          {"difference", r.difference},
          {"last_places", r.places},
          {"refused", r.boards.refused},
          {"told", r.told},
          {"instructions", r.controller_most},
          {"plant_instructions", r.plant_most}};
}
nlohmann::json row_of(const Options& options, const two_boards::FaultRow& row) {
  return {{"robot", Robot::name},
          {"board", options.controller},
          {"scalar", options.number},
          {"plant_board", options.plant},
          {"plant_scalar", options.plant_number},
          {"fault", row.fault},
          {"ends", row.ends},
          {"held", row.held},
          {"found", row.found}};
}

std::string micrometres(double metres) { return significant(1e6 * metres, 3); }

void print(const Result& r) {
  Table table({"arm", "tool RMS, um", "largest, um"});
  table.add({"on its board", micrometres(r.boards.tool_rms), micrometres(r.boards.tool_largest)});
  table.add({"on the host", micrometres(r.host.tool_rms), micrometres(r.host.tool_largest)});
  std::printf(
      "%sdifference of the RMS: %s %%; %ld ticks, %s a second; the controller's board and its source on the host "
      "differ by "
      "%u last places at most\n",
      table.text().c_str(), significant(100.0 * r.difference, 2).c_str(), r.boards.ticks,
      significant(r.ticks_a_second, 3).c_str(), r.places);
}

void judge(Verdict& verdict, const Options& options, const Result& r) {
  verdict.expect(std::fabs(r.difference) <= tracking_difference,
                 "the tracking error is another than around the host's arm");
  verdict.expect(r.places <= (loop::is_fixed(options.number) ? 0 : most_places), "board and host give other torques");
  verdict.expect(r.boards.refused == 0, "set-points were refused");
  verdict.expect(r.told == 0, "the arm's board had something to say");
}

int run(const Options& options) {
  if (options.faults && !(options.controller_port + options.plant_port).empty())
    throw std::runtime_error("--faults starts its boards anew for each: emulated ones, not those at a port");
  if (options.carried > 0.0 && !axial::apps::plant::has_payload<axial::apps::plant::MechanicsOf<Robot>>)
    throw std::runtime_error(std::string(Robot::name) +
                             " takes no load: name 'static constexpr bool payload = true;' in its Mechanics "
                             "(doc/guides/two_boards.md)");
  make_folder(options.output);
  const std::string stem = options.output + "/hil-" + Robot::name;
  auto rows = nlohmann::json::array();
  Verdict verdict("hil");
  TwoBoards two(options);
  {
    std::vector<std::string> header{"loop", "time"};
    for (std::size_t i = 1; i <= joints; ++i)
      header.push_back("q" + std::to_string(i)), header.push_back("error" + std::to_string(i));
    for (std::size_t i = 1; i <= joints; ++i)
      header.push_back("torque" + std::to_string(i));
    CsvFile file(stem + ".csv", header);
    const Result result = two.run(file);
    print(result), judge(verdict, options, result);
    rows.push_back(row_of(options, result));
  }
  if (options.faults) {
    Table table({"fault of the line", "ends", "did"});
    for (const auto& row : two.faults()) {
      table.add({row.fault, row.ends, row.held ? "yes" : row.found});
      verdict.expect(row.held, row.fault + ": " + row.found);
      rows.push_back(row_of(options, row));
    }
    std::printf("%s", table.text().c_str());
  }
  write_json(stem + ".json", rows);
  if (!options.json.empty()) write_json(options.json, rows);
  run_plot("loop.py", {stem + ".csv", stem + ".json"});
  std::printf("\npicture  %s.png\ndata     %s.csv, %s.json\n", stem.c_str(), stem.c_str(), stem.c_str());
  return verdict.status();
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  options.output = "output/hil";
  CommandLine line("a controller on one board, its arm on another", "hil");
  line.option("--controller", options.controller, "folder of hal/boards").show_default();
  line.option("--plant", options.plant, "likewise").show_default();
  line.option("--number", options.number, "of the controller: float or fixed32").show_default();
  line.option("--plant-number", options.plant_number, "of the plant").show_default();
  line.option("--controller-port", options.controller_port, "path[:baud] of the controller's board on the desk");
  line.option("--plant-port", options.plant_port, "likewise");
  line.option("--seconds", options.seconds, "of motion").show_default().range(0.001, 3600.0);
  line.option("--carry", options.carried, "kg, taken at a quarter of the motion and put down at three").range(0.0, 1e3);
  line.flag("--faults", options.faults, "besides, faults of the line");
  line.option("--output", options.output, "folder of CSV, JSON and picture").show_default();
  line.option("--json", options.json, "one more copy of the figures");
  return line.run(count, arguments, [&] { return run(options); });
}
