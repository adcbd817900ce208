#include <host_sim/boards/emulator/serial_line.hpp>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace host_sim {

namespace {

bool wait_readable(int socket, std::chrono::milliseconds limit) {
  pollfd entry{socket, POLLIN, 0};
  int ready = 0;
  do {
    ready = ::poll(&entry, 1, static_cast<int>(limit.count()));
  } while (ready < 0 && errno == EINTR);
  return ready > 0;
}

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) throw std::runtime_error("path too long for a socket: " + path);
  std::memcpy(address.sun_path, path.data(), path.size());
  return address;
}

}  // namespace

void SerialLine::write(const std::uint8_t* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = ::send(socket_.value(), bytes, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) throw std::runtime_error("the emulator closed its serial line");
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
}

std::size_t SerialLine::read(std::uint8_t* bytes, std::size_t capacity, std::chrono::milliseconds limit) {
  if (!wait_readable(socket_.value(), limit)) return 0;
  const ssize_t received = ::recv(socket_.value(), bytes, capacity, 0);
  if (received <= 0) throw std::runtime_error("the emulator closed its serial line");
  return static_cast<std::size_t>(received);
}

SerialListener::SerialListener(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  const sockaddr_un address = address_of(path);
  const auto* generic = reinterpret_cast<const sockaddr*>(&address);
  if (::bind(socket_.value(), generic, sizeof address) != 0 || ::listen(socket_.value(), 1) != 0)
    throw std::runtime_error("cannot listen at " + path + ": " + std::strerror(errno));
}

bool SerialListener::wait(std::chrono::milliseconds limit) const { return wait_readable(socket_.value(), limit); }

SerialLine SerialListener::accept() const {
  Descriptor line(::accept4(socket_.value(), nullptr, nullptr, SOCK_CLOEXEC));
  if (line.value() < 0) throw std::runtime_error("cannot accept the emulator's serial line");
  return SerialLine(std::move(line));
}

}  // namespace host_sim
