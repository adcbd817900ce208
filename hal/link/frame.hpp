#pragma once
/// Frames: a delimiter, the stuffed body, a delimiter. Body: type, sequence number, payload length, payload, CRC-32 xor
/// session. README.md has the table.

#include <array>
#include <cstddef>
#include <cstdint>

#include <hal/link/cobs.hpp>
#include <hal/link/crc32.hpp>

namespace axial::hal::link {

constexpr std::uint8_t delimiter = 0;
constexpr std::size_t header_size = 7, crc_size = 4;
constexpr std::size_t max_payload = 96;

constexpr std::size_t body_size(std::size_t payload) { return header_size + payload + crc_size; }

/// Bytes on the wire of a frame, at most.
constexpr std::size_t wire_size(std::size_t payload) { return cobs_size(body_size(payload)) + 2; }
constexpr std::size_t max_wire_size = wire_size(max_payload);

/// Session number of frames that belong to none: what opens one.
constexpr std::uint32_t no_session = 0;

/// A frame in someone else's memory.
struct FrameView {
  std::uint8_t type;
  std::uint32_t sequence;
  const std::uint8_t* payload;
  std::size_t length;
  std::uint32_t session = no_session;
};

/// Writes a frame into `out`, which has room for wire_size(frame.length) bytes; returns the bytes written.
constexpr std::size_t encode_frame(const FrameView& frame, std::uint8_t* out) {
  out[0] = delimiter;
  CobsWriter stuffed(out + 1);
  Crc32 crc;
  stuffed.start();
  const auto put = [&](std::uint32_t byte) {
    crc.add(static_cast<std::uint8_t>(byte));
    stuffed.put(static_cast<std::uint8_t>(byte));
  };
  put(frame.type);
  for (unsigned shift = 0; shift < 32; shift += 8)
    put(frame.sequence >> shift & 0xFFu);
  put(frame.length & 0xFFu);
  put(frame.length >> 8 & 0xFFu);
  for (std::size_t i = 0; i < frame.length; ++i)
    put(frame.payload[i]);
  const std::uint32_t check = crc.value() ^ frame.session;
  for (unsigned shift = 0; shift < 32; shift += 8)
    stuffed.put(static_cast<std::uint8_t>(check >> shift & 0xFFu));
  out[1 + stuffed.size()] = delimiter;
  return stuffed.size() + 2;
}

/// What a piece of the byte stream turned out to be. A frame of another session is a bad CRC.
enum class FrameEvent : std::uint8_t { none, frame, bad_cobs, truncated, oversized, bad_length, bad_crc };

/// Finds frames in a byte stream. Any garbage costs at most the frame that it touches: whatever was collected is judged
/// at the next delimiter, and a frame begins with one.
class FrameDecoder {
 public:
  /// From now on frames of this session, and of none, are good.
  constexpr void set_session(std::uint32_t session) { session_ = session; }

  /// Takes the next byte. After `frame`, frame() is valid until the next call. Other events name the first fault of
  /// the piece that ended here.
  constexpr FrameEvent feed(std::uint8_t byte) {
    if (byte != delimiter) {
      collect(byte);
      return FrameEvent::none;
    }
    const FrameEvent event = started_ ? judge() : FrameEvent::none;
    cobs_ = {};
    collected_ = size_;
    size_ = 0;
    started_ = false;
    return event;
  }

  constexpr FrameView frame() const {
    return {body_[0], little_endian_4(1), body_.data() + header_size, collected_ - body_size(0), mark_};
  }

 private:
  constexpr void collect(std::uint8_t coded) {
    started_ = true;
    std::uint8_t byte = 0;
    if (!cobs_.take(coded, byte) || size_ > body_.size()) return;
    if (size_ < body_.size()) body_[size_] = byte;
    ++size_;  // one past the end marks too long a piece
  }

  constexpr FrameEvent judge() {
    if (size_ > body_.size()) return FrameEvent::oversized;
    if (!cobs_.complete()) return FrameEvent::bad_cobs;
    if (size_ < body_size(0)) return FrameEvent::truncated;
    const std::size_t length = body_[5] | static_cast<std::size_t>(body_[6]) << 8;
    if (body_size(length) != size_) return FrameEvent::bad_length;
    const std::size_t checked = size_ - crc_size;
    mark_ = crc32(body_.data(), checked) ^ little_endian_4(checked);
    return mark_ == no_session || mark_ == session_ ? FrameEvent::frame : FrameEvent::bad_crc;
  }

  constexpr std::uint32_t little_endian_4(std::size_t at) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value |= std::uint32_t{body_[at + i]} << (8 * i);
    return value;
  }

  std::array<std::uint8_t, body_size(max_payload)> body_{};
  std::size_t size_ = 0, collected_ = 0;
  std::uint32_t session_ = no_session;
  std::uint32_t mark_ = no_session;  // the session for which the last frame's CRC is right
  bool started_ = false;
  CobsReader cobs_{};
};

}  // namespace axial::hal::link
