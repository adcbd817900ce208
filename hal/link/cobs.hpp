#pragma once
/// Consistent overhead byte stuffing: bytes without a zero, so that a zero can delimit frames.
/// Source: S. Cheshire and M. Baker, "Consistent Overhead Byte Stuffing", IEEE/ACM Trans. Networking 7(2), 1999.
///
/// The data and one virtual zero at its end are cut into blocks; a block is its length plus one (the code), then its
/// bytes. A block ends at a zero, which is not sent, or after 254 bytes (code 255), with no zero.

#include <cstddef>
#include <cstdint>

namespace axial::hal::link {

/// Bytes that `count` bytes need at most.
constexpr std::size_t cobs_size(std::size_t count) { return count + count / 254 + 1; }

/// Stuffs byte by byte into a buffer of at least cobs_size(count) bytes.
class CobsWriter {
 public:
  constexpr explicit CobsWriter(std::uint8_t* out) : out_(out) {}

  constexpr void put(std::uint8_t byte) {
    if (out_[code_] == full) open_block();
    if (byte == 0) {
      open_block();
    } else {
      out_[size_++] = byte;
      ++out_[code_];
    }
  }

  /// Bytes written so far; the result is complete after any `put`.
  constexpr std::size_t size() const { return size_; }

  constexpr void start() {
    size_ = 0;
    open_block();
  }

 private:
  static constexpr std::uint8_t full = 255;

  constexpr void open_block() {
    code_ = size_++;
    out_[code_] = 1;
  }

  std::uint8_t* out_;
  std::size_t code_ = 0, size_ = 0;
};

/// Unstuffs byte by byte; takes every byte but the delimiter.
class CobsReader {
 public:
  /// True when `byte` becomes the next byte of data.
  constexpr bool take(std::uint8_t coded, std::uint8_t& byte) {
    if (left_ > 0) {
      --left_;
      byte = coded;
      return true;
    }
    const bool zero = zero_before_block_;
    left_ = static_cast<std::uint8_t>(coded - 1);
    zero_before_block_ = coded != 255;
    byte = 0;
    return zero;
  }

  /// Whether the data may end here: no block owes a byte.
  constexpr bool complete() const { return left_ == 0; }

 private:
  std::uint8_t left_ = 0;
  bool zero_before_block_ = false;
};

}  // namespace axial::hal::link
