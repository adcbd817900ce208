#include <host_sim/plants/loop/controllers.hpp>
#include <host_sim/plants/loop/on_host.hpp>

#include <host_sim/boards/emulator/qemu.hpp>
#include <host_sim/boards/link/firmware.hpp>

#include <firmware/apps/tracking/controller.hpp>
#include <robots/robots.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace host_sim::loop {

namespace {

class Emulated : public Controller {
 public:
  Emulated(const Board& board, const std::string& image) : emulator_(board, image), firmware_(emulator_.serial()) {}

  void take(const link::Derivatives& derivatives) override { firmware_.send_derivatives(derivatives); }

  link::Torque answer(const link::Measurement& measurement, const link::SetPoint& wanted) override {
    try {
      return firmware_.torque(measurement, wanted);
    } catch (const std::runtime_error& error) {
      const std::string words = emulator_.console();
      throw std::runtime_error(error.what() + (words.empty() ? "" : "\nthe emulator printed: " + words));
    }
  }

 private:
  Emulator emulator_;
  Firmware firmware_;
};

}  // namespace

bool is_fixed(const std::string& number) {
  if (number == "float") return false;
  if (number == "fixed32") return true;
  throw std::runtime_error("unknown number '" + number + "'; there are: float, fixed32");
}

std::unique_ptr<Controller> emulated(const std::string& board, const std::string& app, const std::string& robot) {
  const Board chosen = read_board(board);
  return std::make_unique<Emulated>(chosen, image_path(chosen, app, robot));
}

namespace {

using Factory = std::unique_ptr<Controller> (*)(bool fixed);
struct Entry {
  const char* robot;
  Factory make;
  bool shares_drives;
};

template <class Robot>
std::unique_ptr<Controller> host(bool fixed) {
  if (fixed) return std::make_unique<OnHost<axial::apps::TrackingController<Robot, axial::Fixed32>>>();
  return std::make_unique<OnHost<axial::apps::TrackingController<Robot, float>>>();
}

template <class... Robots>
std::vector<Entry> entries(::robots::List<Robots...>) {
  return {{Robots::name, host<Robots>, axial::detail::shares_drives_in<typename axial::scene_of<Robots>::Robot>}...};
}

using Tracked = ::robots::List<::robots::Scara, ::robots::Puma560, ::robots::ScaraQuill, ::robots::Palletiser,
                               ::robots::WristArm, ::robots::Gripper>;

Factory find(const std::string& robot) {
  std::string names;
  for (const Entry& entry : entries(Tracked{})) {
    if (entry.robot == robot) return entry.make;
    names += (names.empty() ? "" : ", ") + std::string(entry.robot);
  }
  throw std::runtime_error("no loop is closed around '" + robot + "'; there are: " + names);
}

}  // namespace

std::vector<std::string> robots() {
  std::vector<std::string> names;
  for (const Entry& entry : entries(Tracked{}))
    names.emplace_back(entry.robot);
  return names;
}

std::vector<std::string> robots_of_single_drives() {
  std::vector<std::string> names;
  for (const Entry& entry : entries(Tracked{}))
    if (!entry.shares_drives) names.emplace_back(entry.robot);
  return names;
}

std::unique_ptr<Controller> on_host(const std::string& robot, const std::string& number) {
  return find(robot)(is_fixed(number));
}

std::unique_ptr<Controller> in_firmware(const std::string& board, const std::string& robot, const std::string& number) {
  (void)find(robot);
  return emulated(board, is_fixed(number) ? "tracking-fixed" : "tracking", robot);
}

std::uint32_t last_places(float a, float b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<std::uint32_t>::max();
  const auto ordered = [](float x) {
    std::int32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return bits < 0 ? std::int64_t{std::numeric_limits<std::int32_t>::min()} - bits : std::int64_t{bits};
  };
  const std::int64_t apart = ordered(a) - ordered(b);
  return static_cast<std::uint32_t>(apart < 0 ? -apart : apart);
}

link::Torque Both::answer(const link::Measurement& measurement, const link::SetPoint& wanted) {
  const link::Torque theirs = board_.answer(measurement, wanted), ours = host_.answer(measurement, wanted);
  for (std::size_t i = 0; i < theirs.joints; ++i)
    worst = std::max(worst, last_places(theirs.tau[i], ours.tau[i]));
  if (theirs.status != ours.status)
    throw std::runtime_error("board and host give different statuses: " + std::to_string(theirs.status) + " and " +
                             std::to_string(ours.status));
  least = std::min(least, theirs.count), most = std::max(most, theirs.count);
  return theirs;
}

}  // namespace host_sim::loop
