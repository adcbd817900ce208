#include <host_sim/robots/trajectory/files.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace host_sim {

namespace {

std::ifstream open(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot be read");
  return file;
}

Cycle cycle_from_json(const nlohmann::json& json) {
  Cycle cycle;
  cycle.robot = json.at("robot").get<std::string>();
  cycle.tick = json.value("tick_s", cycle.tick);
  cycle.jerk_time = json.value("jerk_time_s", cycle.jerk_time);
  cycle.utilisation = json.value("utilisation", cycle.utilisation);
  cycle.smooth = json.value("smooth", cycle.smooth);
  for (const auto& point : json.at("way_points"))
    cycle.way_points.push_back(
        {point.at("name").get<std::string>(), point.at("q").get<std::vector<double>>(), point.value("dwell_s", 0.0)});
  return cycle;
}

void check_timing(const Cycle& cycle) {
  if (!(cycle.tick > 0.0)) throw std::runtime_error("tick_s must be > 0");
  if (!(cycle.jerk_time > 0.0)) throw std::runtime_error("jerk_time_s must be > 0");
  if (!(cycle.utilisation > 0.0 && cycle.utilisation <= 1.0)) throw std::runtime_error("utilisation must be in (0, 1]");
  for (const WayPoint& point : cycle.way_points)
    if (!(point.dwell >= 0.0 && point.dwell <= 3600.0)) throw std::runtime_error("dwell_s must be 0 to 3600");
}

std::vector<double> numbers(const std::string& line) {
  std::vector<double> values;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, ',');) {
    std::size_t used = 0;
    values.push_back(std::stod(cell, &used));
    if (cell.find_first_not_of(" \t\r", used) != std::string::npos) throw std::invalid_argument(cell);
    if (!std::isfinite(values.back())) throw std::invalid_argument(cell);
  }
  return values;
}

SetPoint set_point_from(const std::vector<double>& row, int joints) {
  if (row.size() != static_cast<std::size_t>(1 + 3 * joints)) throw std::invalid_argument("columns");
  const auto group = [&](int k) {
    return std::vector<double>(row.begin() + 1 + k * joints, row.begin() + 1 + (k + 1) * joints);
  };
  return {row[0], group(0), group(1), group(2), {}, {}};
}

void check_positions(const Trajectory& trajectory, const std::vector<JointLimits>& limits) {
  for (const SetPoint& point : trajectory)
    for (std::size_t i = 0; i < limits.size(); ++i)
      if (!(point.q[i] >= limits[i].position_min && point.q[i] <= limits[i].position_max))
        throw std::runtime_error("joint " + std::to_string(i + 1) + " is outside its position limits at " +
                                 std::to_string(point.time) + " s");
}

Trajectory load(const std::string& path, const std::string& robot, const std::vector<JointLimits>& limits,
                const std::function<Trajectory(const Cycle&)>& planned) {
  if (path.size() > 4 && path.substr(path.size() - 4) == ".csv")
    return read_set_points(path, static_cast<int>(limits.size()));
  const Cycle cycle = read_cycle(path);
  if (cycle.robot != robot) throw std::runtime_error("is for " + cycle.robot + ", not for " + robot);
  return planned(cycle);
}

}  // namespace

Cycle read_cycle(const std::string& path) {
  std::ifstream file = open(path);
  try {
    const Cycle cycle = cycle_from_json(nlohmann::json::parse(file));
    check_timing(cycle);
    return cycle;
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("not a cycle of way-points: ") + error.what());
  }
}

Trajectory read_set_points(const std::string& path, int joints) {
  std::ifstream file = open(path);
  Trajectory trajectory;
  std::string line;
  std::getline(file, line);
  for (int number = 2; std::getline(file, line); ++number) {
    try {
      trajectory.push_back(set_point_from(numbers(line), joints));
    } catch (const std::logic_error&) {
      throw std::runtime_error("line " + std::to_string(number) + " is not time, q, qd, qdd of " +
                               std::to_string(joints) + " joints: " + std::to_string(1 + 3 * joints) +
                               " finite numbers");
    }
  }
  if (trajectory.empty()) throw std::runtime_error("no set-points after the header line");
  return trajectory;
}

Trajectory load_trajectory(const std::string& path, const std::string& robot, const std::vector<JointLimits>& limits) {
  return load_trajectory(path, robot, limits, [&](const Cycle& cycle) { return plan(cycle, limits); });
}

Trajectory load_trajectory(const std::string& path, const std::string& robot, const std::vector<JointLimits>& limits,
                           const std::function<Trajectory(const Cycle&)>& planned) {
  try {
    Trajectory trajectory = load(path, robot, limits, planned);
    check_positions(trajectory, limits);
    return trajectory;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace host_sim
