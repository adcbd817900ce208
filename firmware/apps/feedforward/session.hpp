#pragma once
/// Sessions: which frames are meant for now. The firmware's boot and each `start` make a new identifier; whatever was
/// recorded, delayed or buffered before carries another. This guards against accidents, not against an attacker.

#include <cstdint>

#include <hal/link/crc32.hpp>
#include <hal/link/frame.hpp>

namespace axial::apps {

class Session {
 public:
  /// After a reset no session is open: the identifier is what the first `start` must name. `entropy` is whatever
  /// differs from one call to the next, across resets too.
  constexpr void boot(std::uint32_t entropy) {
    renew(0, entropy);
    open_ = was_asked_ = false;
  }

  /// Opens a session for a `start` that names this one; false, and nothing happens, for any other. The first since boot
  /// opens none but makes the identifier that the next must name: at boot a board may know nothing that differs from
  /// its last start, and a recorded `start` would fit.
  constexpr bool open(std::uint32_t named, std::uint32_t nonce, std::uint32_t entropy) {
    if (!was_asked_) {
      renew(nonce, entropy);
      was_asked_ = true;
      return false;
    }
    if (named != id_) return false;
    renew(nonce, entropy);
    open_ = true;
    return true;
  }

  constexpr std::uint32_t id() const { return id_; }
  constexpr bool is_open() const { return open_; }

 private:
  /// Never the last one, never that of frames without a session.
  constexpr void renew(std::uint32_t nonce, std::uint32_t entropy) {
    hal::link::Crc32 mix;
    const std::uint32_t words[] = {id_, nonce, entropy};
    for (const std::uint32_t word : words)
      for (unsigned shift = 0; shift < 32; shift += 8)
        mix.add(static_cast<std::uint8_t>(word >> shift & 0xFFu));
    std::uint32_t next = mix.value();
    while (next == id_ || next == hal::link::no_session)
      ++next;
    id_ = next;
  }

  std::uint32_t id_ = hal::link::no_session;
  bool open_ = false, was_asked_ = false;
};

}  // namespace axial::apps
