#pragma once
/// A queue of bytes between one interrupt and the main loop: one producer, one consumer, no lock.

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace axial::hal {

/// Holds up to `capacity` bytes, a power of two up to 32768. The counters run freely and wrap; their difference is
/// the fill. The producer alone writes `head_`, the consumer alone `tail_`.
template <std::size_t capacity>
class ByteRing {
  static_assert(capacity > 0 && capacity <= 32768 && (capacity & (capacity - 1)) == 0,
                "choose a power of two up to 32768 as the capacity");

 public:
  /// Producer. False, and nothing stored, when full.
  bool push(std::uint8_t byte) {
    const std::uint16_t head = head_.load(std::memory_order_relaxed);
    if (static_cast<std::uint16_t>(head - tail_.load(std::memory_order_acquire)) >= capacity) return false;
    bytes_[head % capacity] = byte;
    head_.store(static_cast<std::uint16_t>(head + 1u), std::memory_order_release);
    return true;
  }

  /// Consumer. False when empty.
  bool pop(std::uint8_t& byte) {
    const std::uint16_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_.load(std::memory_order_acquire)) return false;
    byte = bytes_[tail % capacity];
    tail_.store(static_cast<std::uint16_t>(tail + 1u), std::memory_order_release);
    return true;
  }

  bool empty() const { return head_.load(std::memory_order_acquire) == tail_.load(std::memory_order_acquire); }

 private:
  std::atomic<std::uint16_t> head_{0}, tail_{0};
  std::uint8_t bytes_[capacity]{};
};

}  // namespace axial::hal
