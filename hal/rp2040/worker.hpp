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

/// The second core does one job at a time, beside this one: no interrupts, no counter, no guard below its stack but a
/// word that is looked at. Where it does not answer, or runs the program itself, this core does them.
/// Port: as of Jobs; the `vectors` that the other core starts with, and whether the `other_is_free`.
template <class Port>
class SecondCoreWorker {
 public:
  static void start() {
    if (!Port::other_is_free) return;
    stack_[0] = unused;
    void (*const entry)() = serve;
    const auto top = reinterpret_cast<std::uintptr_t>(stack_ + words);
    there_ = launch(Port::mailbox(), {Port::vectors, top, reinterpret_cast<std::uintptr_t>(entry)}, Port::signal);
  }
  static void begin(void (*job)(void*), void* with) {
    if (!there_) return job(with);
    busy_ = true;
    Jobs<Port>::post(reinterpret_cast<std::uintptr_t>(job), reinterpret_cast<std::uintptr_t>(with));
  }
  static void join() {
    if (busy_) Jobs<Port>::join();
    busy_ = false;
  }
  static bool stack_intact() { return !there_ || stack_[0] == unused; }

 private:
  [[noreturn]] static void serve() {
    for (;;)
      Jobs<Port>::serve([](std::uint32_t job, std::uint32_t with) {
        reinterpret_cast<void (*)(void*)>(job)(reinterpret_cast<void*>(with));
      });
  }

  static constexpr std::uint32_t unused = 0x5AFE5AFE;
  static constexpr std::size_t words = 2048;  // 8 KiB; the step of an arm of seven joints in words takes 3.1
  alignas(8) inline static std::uint32_t stack_[words];
  inline static bool there_ = false, busy_ = false;
};

}  // namespace axial::hal::rp2040
