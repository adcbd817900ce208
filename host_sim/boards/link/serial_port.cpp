#include <host_sim/boards/link/serial_port.hpp>

#include <cerrno>
#include <cstring>
#include <map>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace host_sim {

namespace {

const std::map<std::string, speed_t> speeds = {{"115200", B115200},   {"230400", B230400},   {"460800", B460800},
                                               {"500000", B500000},   {"921600", B921600},   {"1000000", B1000000},
                                               {"1500000", B1500000}, {"2000000", B2000000}, {"3000000", B3000000}};

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw std::runtime_error("the serial port " + path + ": " + why);
}

struct Device {
  std::string path;
  speed_t speed;
};
Device device_of(const std::string& text) {
  const auto colon = text.rfind(':');
  const std::string baud = colon == std::string::npos ? "2000000" : text.substr(colon + 1);
  const auto found = speeds.find(baud);
  if (found != speeds.end()) return {text.substr(0, colon), found->second};
  std::string known;
  for (const auto& [each, speed] : speeds)
    known += (known.empty() ? "" : ", ") + each;
  refuse(text, "there is no rate '" + baud + "'; there are: " + known);
}

void make_raw(const std::string& path, int port, speed_t speed) {
  termios settings{};
  if (::tcgetattr(port, &settings) != 0) refuse(path, "it is no serial port");
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
  settings.c_cc[VMIN] = 0, settings.c_cc[VTIME] = 0;
  if (::cfsetspeed(&settings, speed) != 0 || ::tcsetattr(port, TCSANOW, &settings) != 0)
    refuse(path, std::string("it does not take this rate: ") + std::strerror(errno));
  if (::ioctl(port, TIOCEXCL) != 0 || ::tcflush(port, TCIOFLUSH) != 0) refuse(path, std::strerror(errno));
}

/// Whether it may be read or written, as `events` says; false when it may not in time.
bool wait_for(const std::string& path, int port, short events, std::chrono::milliseconds limit) {
  pollfd entry{port, events, 0};
  int ready = 0;
  do {
    ready = ::poll(&entry, 1, static_cast<int>(limit.count()));
  } while (ready < 0 && errno == EINTR);
  if (ready > 0 && (entry.revents & events) == 0) refuse(path, "it is gone");
  return ready > 0;
}

}  // namespace

SerialPort::SerialPort(const std::string& device)
    : path_(device_of(device).path), port_(::open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
  if (port_.value() < 0) refuse(path_, std::strerror(errno));
  make_raw(path_, port_.value(), device_of(device).speed);
}

void SerialPort::write(const std::uint8_t* bytes, std::size_t count) {
  while (count > 0) {
    if (!wait_for(path_, port_.value(), POLLOUT, std::chrono::seconds(5))) refuse(path_, "it takes no bytes");
    const ssize_t sent = ::write(port_.value(), bytes, count);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent <= 0) refuse(path_, "it is gone");
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
}

std::size_t SerialPort::read(std::uint8_t* bytes, std::size_t capacity, std::chrono::milliseconds limit) {
  if (!wait_for(path_, port_.value(), POLLIN, limit)) return 0;
  const ssize_t received = ::read(port_.value(), bytes, capacity);
  if (received < 0 && (errno == EINTR || errno == EAGAIN)) return 0;
  if (received <= 0) refuse(path_, "it is gone");
  return static_cast<std::size_t>(received);
}

}  // namespace host_sim
