#pragma once
/// The second core as a worker beside the first: one job at a time, of which two words go there and one comes back.

#include <hal/rp2040/second_core.hpp>

namespace axial::hal::rp2040 {

/// What the two cores have between them, as one of them sees it. `signal()` wakes the other (SEV), `wait()` sleeps
/// until it does (WFE), `fence()` orders stores.
template <class Port>
struct Jobs {
  /// A job for the other core: what to do, and with what.
  static void post(std::uint32_t what, std::uint32_t with) {
    Port::fence();
    put(what), put(with);
    Port::signal();
  }
  /// Waits until the other core has done it. Without sleep: it is about to be.
  static void join() {
    static_cast<void>(take([] {}));
    Port::fence();
  }
  /// The other core's side: does the next job, once there is one.
  template <class Do>
  static void serve(const Do& job) {
    const std::uint32_t what = take(Port::wait), with = take(Port::wait);
    Port::fence();
    job(what, with);
    Port::fence();
    put(1);
  }

 private:
  static void put(std::uint32_t word) {
    while ((Port::mailbox().status & mailbox_status::has_room) == 0) {
    }
    Port::mailbox().write = word;
  }
  template <class Pause>
  static std::uint32_t take(Pause pause) {
    while ((Port::mailbox().status & mailbox_status::has_word) == 0)
      pause();
    return Port::mailbox().read;
  }
};

}  // namespace axial::hal::rp2040
