#include <host_sim/boards/demo/recording.hpp>

#include <host_sim/tools/output/progress.hpp>

#include <stdexcept>

namespace host_sim {

namespace {

template <class Array>
std::vector<double> widened(const Array& values, std::size_t count) {
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count)};
}

const char* status_text(std::uint8_t status) {
  switch (static_cast<link::TorqueStatus>(status)) {
    case link::TorqueStatus::ok:
      return "ok";
    case link::TorqueStatus::not_finite:
      return "the set-point is not finite";
    case link::TorqueStatus::outside_limits:
      return "the set-point is outside the limits";
    case link::TorqueStatus::effort_limited:
      return "the torque was cut to the effort limit";
    case link::TorqueStatus::watchdog:
      return "no set-point came in time";
    case link::TorqueStatus::disabled:
      return "the drives are disabled";
    case link::TorqueStatus::not_measured:
      return "no measurement came with the set-point";
  }
  return "unknown status";
}

void check_status(const link::Torque& torque, const SetPoint& point, const Robot& robot) {
  if (torque.status == static_cast<std::uint8_t>(link::TorqueStatus::ok)) return;
  throw std::runtime_error("the firmware says at " + std::to_string(point.time) + " s, " + robot.noun() + " " +
                           std::to_string(torque.joint + 1) + ": " + status_text(torque.status));
}

Sample exchange(Firmware& firmware, const Robot& robot, const SetPoint& point) {
  const link::SetPoint sent = to_message(point);
  const link::Torque answer = firmware.torque(sent);
  check_status(answer, point, robot);
  const std::size_t n = sent.joints;
  Sample sample{{point.time, widened(sent.q, n), widened(sent.qd, n), widened(sent.qdd, n)},
                widened(answer.tau, n),
                {},
                answer.count};
  sample.exact = exact_torque(robot, sample.asked);
  return sample;
}

void check_hello(const link::Hello& hello, const Robot& robot) {
  if (hello.robot != link::make_name(robot.name.c_str()) || hello.joints != robot.joints())
    throw std::runtime_error(std::string("the image is for ") + hello.robot.data() + ", not for " + robot.name);
}

/// Nothing may have been lost or refused on the way, even if every answer came.
void check_stats(const link::Stats& stats, std::size_t sent) {
  std::uint32_t faults = stats.gaps + stats.refused;
  for (const std::uint32_t count : stats.counters)
    faults += count;
  if (faults != 0 || stats.set_points != sent)
    throw std::runtime_error("the firmware counted " + std::to_string(stats.set_points) + " of " +
                             std::to_string(sent) + " set-points and " + std::to_string(faults) + " faults");
}

}  // namespace

Recording stream(SerialLine& line, const Robot& robot, const Trajectory& trajectory) {
  Firmware firmware(line);
  Recording recording{{}, firmware.hello(), {}};
  check_hello(recording.hello, robot);
  Progress progress("streaming set-points", trajectory.size());
  for (const SetPoint& point : trajectory) {
    recording.samples.push_back(exchange(firmware, robot, point));
    progress.at(recording.samples.size());
  }
  recording.stats = firmware.stats();
  check_stats(recording.stats, trajectory.size());
  return recording;
}

}  // namespace host_sim
