// Who computes the torques: an image in QEMU, or the same source on the host.
#pragma once

#include <hal/link/messages.hpp>

#include <memory>
#include <string>
#include <vector>

namespace host_sim::loop {

namespace link = axial::hal::link;

class Controller {
 public:
  virtual ~Controller() = default;
  /// Told before each answer where the motion has four derivatives; nothing to most controllers.
  virtual void take(const link::Derivatives&) {}
  /// What the encoders say and what is wanted, to the torque that answers. Throws std::runtime_error when none comes.
  virtual link::Torque answer(const link::Measurement& measurement, const link::SetPoint& wanted) = 0;
};

/// Robots that have a tracking image.
std::vector<std::string> robots();
/// Those of them whose joints share no drives: regulators and observers have images of these.
std::vector<std::string> robots_of_single_drives();

/// `number`: float or fixed32. Throw std::runtime_error that names what there is.
std::unique_ptr<Controller> on_host(const std::string& robot, const std::string& number);
std::unique_ptr<Controller> in_firmware(const std::string& board, const std::string& robot, const std::string& number);

/// An image in QEMU: `app`-`robot`.
std::unique_ptr<Controller> emulated(const std::string& board, const std::string& app, const std::string& robot);
/// Whether a number is fixed32; throws where it is neither that nor float.
bool is_fixed(const std::string& number);

/// Units in the last place between two floats; the largest number where one is not finite.
std::uint32_t last_places(float a, float b);

/// An image in QEMU and the same source on the host, told the same; the image's torques drive.
class Both : public Controller {
 public:
  Both(Controller& board, Controller& host) : board_(board), host_(host) {}  // both are referred to
  void take(const link::Derivatives& derivatives) override { board_.take(derivatives), host_.take(derivatives); }
  /// The image's answer. Throws std::runtime_error where the statuses differ, too.
  link::Torque answer(const link::Measurement& measurement, const link::SetPoint& wanted) override;

  std::uint32_t worst = 0;                     ///< last places between their torques, at most
  std::uint32_t least = 0xFFFFFFFF, most = 0;  ///< instructions of the image's answers

 private:
  Controller &board_, &host_;
};

}  // namespace host_sim::loop
