// run: an image of any robot in its board's emulator, its torques printed and checked against the run-time model in
// double.
#include <host_sim/boards/emulator/qemu.hpp>
#include <host_sim/robots/description/description.hpp>
#include <host_sim/tools/analysis/largest.hpp>
#include <host_sim/tools/output/command_line.hpp>

#include <axial/axial.hpp>
#include <firmware/apps/run/motion.hpp>
#include <firmware/apps/run/scene.hpp>
#include <robot.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace {

using axial::apps::Robot;
using Model = axial::Model<description::most_links, axial::Gravity, axial::RotorInertia, axial::Friction,
                           axial::JointSprings, axial::SharedDrives>;

constexpr int joints = axial::joint_count<Robot>;

struct Options {
  std::string board = "stm32f405", number = "float", json, csv;
};

/// A line of the image: seconds, positions, torques.
struct Sample {
  double time = 0.0;
  std::vector<double> q, tau, exact;
};

double number_of(const std::string& cell) {
  std::size_t used = 0;
  const double value = std::stod(cell, &used);
  if (used != cell.size()) throw std::invalid_argument(cell);
  return value;
}

Sample sample_of(const std::string& line) {
  std::istringstream cells(line);
  std::string cell;
  std::vector<double> values;
  std::getline(cells, cell, ',');
  while (std::getline(cells, cell, ','))
    values.push_back(number_of(cell));
  if (values.size() != 1 + 2 * joints) throw std::runtime_error("the image printed: " + line);
  return {
      values[0], {values.begin() + 1, values.begin() + 1 + joints}, {values.begin() + 1 + joints, values.end()}, {}};
}

std::vector<Sample> samples_of(const std::string& console) {
  std::vector<Sample> samples;
  std::istringstream lines(console);
  std::string line;
  bool whole = false;
  while (std::getline(lines, line)) {
    if (line.rfind("torque,", 0) == 0) samples.push_back(sample_of(line));
    whole = whole || line == "end";
  }
  if (!whole || samples.size() != axial::apps::run::samples)
    throw std::runtime_error("the image did not print its whole motion but: " + console.substr(0, 400));
  return samples;
}

/// What the image's scene has of the robot's friction and springs.
struct Declared {
  bool friction, springs;
  std::string left_out;
};
Declared declared(bool fixed) {
  namespace run = axial::apps::run;
  Declared result{fixed ? run::with_friction<Robot, true> : run::with_friction<Robot, false>,
                  fixed ? run::with_springs<Robot, true> : run::with_springs<Robot, false>, ""};
  if (run::any_joint<Robot>(run::has_friction) && !result.friction)
    result.left_out = "friction (stribeck or smooth_speed)";
  if (run::any_joint<Robot>(run::has_spring) && !result.springs)
    result.left_out += std::string(result.left_out.empty() ? "" : " and ") + "springs";
  return result;
}

/// The robot as the image computes it.
description::Description evaluated(const Declared& declared) {
  auto robot = description::from_robot<Robot>();
  for (auto& link : robot.links) {
    auto& p = link.parameters;
    if (!declared.friction) p.viscous = p.coulomb_forward = p.coulomb_backward = p.static_friction = 0.0;
    if (!declared.springs) p.spring_stiffness = 0.0;
  }
  return robot;
}

std::string loads(const Declared& declared) {
  return std::string("gravity, rotors") + (declared.friction ? ", friction" : "") +
         (declared.springs ? ", springs" : "");
}

/// Torques of the same motion by the run-time model in double.
void add_exact(std::vector<Sample>& samples, const Declared& declared) {
  const auto model = description::to_model<Model>(evaluated(declared));
  for (Sample& sample : samples) {
    axial::Joints<Model, double> q{}, qd{}, qdd{};
    for (int i = 0; i < joints; ++i) {
      const auto motion = axial::apps::run::motion<Robot>(i, sample.time);
      q[i] = motion.q, qd[i] = motion.qd, qdd[i] = motion.qdd;
    }
    const auto tau = axial::inverse_dynamics(model, q, qd, qdd);
    for (int i = 0; i < joints; ++i)
      sample.exact.push_back(tau[i]);
  }
}

/// Largest error and largest torque, of whichever joint.
struct Verdict {
  double error = 0.0, largest = 0.0;
  double relative() const { return error == 0.0 ? 0.0 : error / largest; }
};

Verdict judge(const std::vector<Sample>& samples) {
  Verdict verdict;
  for (const Sample& sample : samples)
    for (std::size_t i = 0; i < joints; ++i) {
      host_sim::note_size(verdict.error, sample.tau[i] - sample.exact[i]);
      host_sim::note_size(verdict.largest, sample.exact[i]);
    }
  return verdict;
}

void print(const std::vector<Sample>& samples) {
  std::printf("%8s", "time, s");
  for (int i = 1; i <= joints; ++i)
    std::printf("%10s%d", "q", i);
  for (int i = 1; i <= joints; ++i)
    std::printf("%10s%d", "tau", i);
  for (const Sample& sample : samples) {
    std::printf("\n%8.3f", sample.time);
    for (const double q : sample.q)
      std::printf("%11.5f", q);
    for (const double tau : sample.tau)
      std::printf("%11.4f", tau);
  }
  std::printf("\n");
}

void write_csv(const std::string& path, const std::vector<Sample>& samples) {
  std::ofstream file(path);
  file << "time";
  for (const char* name : {"q", "tau", "exact"})
    for (int i = 1; i <= joints; ++i)
      file << ',' << name << i;
  file << '\n';
  file.precision(12);
  for (const Sample& sample : samples) {
    file << sample.time;
    for (const auto* values : {&sample.q, &sample.tau, &sample.exact})
      for (const double value : *values)
        file << ',' << value;
    file << '\n';
  }
  if (!file.flush()) throw std::runtime_error("cannot write '" + path + "'; is there such a folder?");
}

void write_json(const std::string& path, const Options& options, const std::string& scene, const Verdict& verdict,
                bool good) {
  std::ofstream file(path);
  file << nlohmann::json{{"robot", Robot::name},
                         {"board", options.board},
                         {"number", options.number},
                         {"scene", scene},
                         {"samples", axial::apps::run::samples},
                         {"largest_error", verdict.error},
                         {"largest_torque", verdict.largest},
                         {"relative_error", verdict.relative()},
                         {"within_bound", good}}
              .dump(2)
       << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write '" + path + "'; is there such a folder?");
}

int run(const Options& options) {
  const double bound = options.number == "float" ? 1e-5 : 1e-4;  // of the largest torque
  const auto board = host_sim::read_board(options.board);
  const auto console =
      host_sim::run_to_end(board, host_sim::image_path(board, "run", options.number), std::chrono::seconds(120));
  if (console.exit_status != 0)
    throw std::runtime_error("the image ended with " + std::to_string(console.exit_status) + ": " +
                             console.output.substr(0, 400));
  auto samples = samples_of(console.output);
  const auto scene = declared(options.number == "fixed32");
  add_exact(samples, scene);
  const auto verdict = judge(samples);
  const bool good = verdict.relative() <= bound;
  print(samples);
  std::printf(
      "\n%s on %s in %s, %s, with %s: largest error %.2g, %.2g of the largest torque %.4g (bound %g), against "
      "axial::Model in "
      "double\n",
      Robot::name, board.name.c_str(), board.emulator_name.c_str(), options.number.c_str(), loads(scene).c_str(),
      verdict.error, verdict.relative(), verdict.largest, bound);
  if (!scene.left_out.empty())
    std::fprintf(stderr, "run: fixed point has none of this: %s of %s are left out; --number float has them\n",
                 scene.left_out.c_str(), Robot::name);
  if (!options.csv.empty()) write_csv(options.csv, samples);
  if (!options.json.empty()) write_json(options.json, options, loads(scene), verdict, good);
  if (!good) std::fprintf(stderr, "run: the error is above its bound\n");
  return good ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  host_sim::CommandLine line("an image of any robot in its board's emulator", "run");
  line.option("--board", options.board, "folder of hal/boards").show_default();
  line.option("--number", options.number, "float or fixed32").show_default().one_of({"float", "fixed32"});
  line.option("--json", options.json, "the figures");
  line.option("--csv", options.csv, "time, positions, torques, exact torques");
  return line.run(count, arguments, [&] { return run(options); });
}
