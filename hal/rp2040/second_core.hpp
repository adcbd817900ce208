#pragma once
/// The RP2040's second core, which its boot ROM leaves asleep until the first tells it what to execute.
/// Source: RP2040 Datasheet, 2.3.1.4 (the mailboxes between the cores), 2.8.2 (launching code on core 1).

#include <cstddef>
#include <cstdint>

#include <hal/clock.hpp>

namespace axial::hal::rp2040 {

struct MailboxRegisters {
  volatile std::uint32_t status, write, read;
};
constexpr std::uint32_t mailbox_offset = 0x50;  // from SIO's first register

namespace mailbox_status {
constexpr std::uint32_t has_word = 1u << 0, has_room = 1u << 1;
}

/// What the second core starts with.
struct Launch {
  std::uint32_t vectors, stack, entry;  ///< `entry` with bit 0 set, as of every function in Thumb
};

/// One word there and the same word back. `signal()` wakes the other core (SEV).
template <class Mailbox, class Signal>
bool exchange(Mailbox& mailbox, std::uint32_t word, Signal signal) {
  if (!wait_until([&] { return (mailbox.status & mailbox_status::has_room) != 0; })) return false;
  mailbox.write = word;
  signal();
  return wait_until([&] { return (mailbox.status & mailbox_status::has_word) != 0; }) && mailbox.read == word;
}

template <class Mailbox>
void drain(Mailbox& mailbox) {
  constexpr int words = 8;  // that a mailbox holds
  for (int i = 0; i < words && (mailbox.status & mailbox_status::has_word) != 0; ++i)
    static_cast<void>(std::uint32_t{mailbox.read});
}

/// False where the other core does not answer as its boot ROM does: it runs already, or there is none. The sequence
/// starts anew after a wrong answer, a few times.
template <class Mailbox, class Signal>
bool launch(Mailbox& mailbox, const Launch& what, Signal signal) {
  constexpr int attempts = 4;
  const std::uint32_t words[] = {0, 0, 1, what.vectors, what.stack, what.entry};
  for (int attempt = 0; attempt < attempts; ++attempt) {
    std::size_t answered = 0;
    for (const std::uint32_t word : words) {
      if (word == 0) {
        drain(mailbox);
        signal();
      }
      if (!exchange(mailbox, word, signal)) break;
      ++answered;
    }
    if (answered == sizeof words / sizeof *words) return true;
  }
  return false;
}

}  // namespace axial::hal::rp2040
