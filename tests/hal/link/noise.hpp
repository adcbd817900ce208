#pragma once
/// Bytes as a bad line delivers them.

#include <cstdint>
#include <random>
#include <vector>

#include <hal/link/messages.hpp>

namespace axial::hal::link::noise {

using Bytes = std::vector<std::uint8_t>;

template <class Message>
Bytes wire(const Message& message, std::uint32_t sequence, std::uint32_t session = no_session) {
  const WireBytes encoded = encode_message(message, sequence, session);
  return Bytes(encoded.bytes.begin(), encoded.bytes.begin() + static_cast<std::ptrdiff_t>(encoded.size));
}

inline Bytes random_bytes(std::mt19937& random, std::size_t most) {
  Bytes bytes(random() % (most + 1));
  const unsigned zeros_in_256 = 1u << random() % 8;
  for (auto& byte : bytes)
    byte = random() % 256 < zeros_in_256 ? 0 : static_cast<std::uint8_t>(random());
  return bytes;
}

/// A frame spoilt in one of the ways that a line or a sender spoils it: cut short, bits flipped, bytes lost, bytes
/// inserted, two frames run together, or no frame at all.
inline Bytes spoilt(std::mt19937& random, Bytes frame) {
  const auto place = [&] { return static_cast<std::ptrdiff_t>(random() % frame.size()); };
  switch (random() % 6) {
    case 0:
      frame.resize(random() % frame.size());
      return frame;
    case 1:
      frame[static_cast<std::size_t>(place())] ^= static_cast<std::uint8_t>(1u << random() % 8);
      return frame;
    case 2:
      frame.erase(frame.begin() + place());
      return frame;
    case 3:
      frame.insert(frame.begin() + place(), static_cast<std::uint8_t>(random()));
      return frame;
    case 4:
      frame.insert(frame.begin() + place(), frame.begin(), frame.end());
      return frame;
    default:
      return random_bytes(random, 300);
  }
}

}  // namespace axial::hal::link::noise
