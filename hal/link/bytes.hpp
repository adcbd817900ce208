#pragma once
/// Numbers as little-endian bytes, written and read explicitly: no struct is laid over memory.

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace axial::hal::link {

/// Appends to a buffer. What does not fit is dropped and `ok()` becomes false.
class ByteWriter {
 public:
  ByteWriter(std::uint8_t* bytes, std::size_t capacity) : bytes_(bytes), capacity_(capacity) {}

  void operator()(std::uint8_t value) {
    if (size_ < capacity_) bytes_[size_] = value;
    ++size_;
  }
  void operator()(std::uint16_t value) {
    (*this)(static_cast<std::uint8_t>(value & 0xFFu));
    (*this)(static_cast<std::uint8_t>(value >> 8));
  }
  /// Not inlined: a hello has fourteen of them.
  [[gnu::noinline]] void operator()(std::uint32_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8)
      (*this)(static_cast<std::uint8_t>(value >> shift & 0xFFu));
  }
  void operator()(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    (*this)(bits);
  }

  std::size_t size() const { return size_; }
  bool ok() const { return size_ <= capacity_; }

 private:
  std::uint8_t* bytes_;
  std::size_t capacity_, size_ = 0;
};

/// Reads from a buffer. Past its end zeros come, and `complete()` is false.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* bytes, std::size_t count) : bytes_(bytes), count_(count) {}

  void operator()(std::uint8_t& value) {
    value = at_ < count_ ? bytes_[at_] : std::uint8_t{0};
    ++at_;
  }
  void operator()(std::uint16_t& value) {
    std::uint8_t low = 0, high = 0;
    (*this)(low);
    (*this)(high);
    value = static_cast<std::uint16_t>(low | high << 8);
  }
  void operator()(std::uint32_t& value) {
    value = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
      std::uint8_t byte = 0;
      (*this)(byte);
      value |= std::uint32_t{byte} << shift;
    }
  }
  void operator()(float& value) {
    std::uint32_t bits = 0;
    (*this)(bits);
    std::memcpy(&value, &bits, sizeof value);
  }

  /// Every byte was read and none was missing.
  bool complete() const { return at_ == count_; }

 private:
  const std::uint8_t* bytes_;
  std::size_t count_, at_ = 0;
};

}  // namespace axial::hal::link
