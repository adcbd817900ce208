// A serial line with whatever goes wrong on it.
#pragma once

#include <host_sim/boards/emulator/serial_line.hpp>

#include <algorithm>
#include <functional>
#include <vector>

namespace host_sim::two_boards {

using Bytes = std::vector<std::uint8_t>;
/// Makes of bytes on their way what arrives of them; of none nothing changes.
using Fault = std::function<void(Bytes&)>;

/// A line that is referred to, and faults of it in either direction.
class FaultyLine : public SerialLine {
 public:
  explicit FaultyLine(SerialLine& line) : line_(line) {}

  /// A frame a call.
  void write(const std::uint8_t* bytes, std::size_t count) override {
    Bytes sent(bytes, bytes + count);
    if (outward) outward(sent);
    if (!sent.empty()) line_.write(sent.data(), sent.size());
  }
  std::size_t read(std::uint8_t* bytes, std::size_t capacity, std::chrono::milliseconds limit) override {
    if (arrived_.empty()) {
      arrived_.resize(capacity);
      arrived_.resize(line_.read(arrived_.data(), capacity, limit));
      if (inward && !arrived_.empty()) inward(arrived_);
    }
    const std::size_t count = std::min(capacity, arrived_.size());
    std::copy(arrived_.begin(), arrived_.begin() + static_cast<std::ptrdiff_t>(count), bytes);
    arrived_.erase(arrived_.begin(), arrived_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }

  Fault outward, inward;

 private:
  SerialLine& line_;
  Bytes arrived_;
};

}  // namespace host_sim::two_boards
