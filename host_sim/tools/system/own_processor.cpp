#include <host_sim/tools/system/own_processor.hpp>

#include <cstddef>
#include <cstdio>

#include <sys/socket.h>
#include <sys/un.h>

namespace host_sim {

namespace {

/// A claim of a processor, given up when the descriptor closes: a name that the kernel gives to one socket at a time.
Descriptor claim(int processor) {
  Descriptor socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;  // a first character of 0: in no folder
  const int length = std::snprintf(address.sun_path + 1, sizeof address.sun_path - 1, "axial-processor-%d", processor);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + static_cast<std::size_t>(length));
  if (::bind(socket.value(), reinterpret_cast<const sockaddr*>(&address), size) != 0) return Descriptor();
  return socket;
}

void keep_on(int processor) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(processor, &one);
  ::sched_setaffinity(0, sizeof one, &one);
}

void schedule(int policy) {
  const sched_param none{};
  ::sched_setscheduler(0, policy, &none);
}

}  // namespace

OwnProcessor::OwnProcessor()
    : known_(::sched_getaffinity(0, sizeof allowed_, &allowed_) == 0), policy_(::sched_getscheduler(0)) {
  if (const int processor = choose(); processor >= 0) keep_on(processor);
  if (policy_ == SCHED_OTHER) schedule(SCHED_BATCH);
}

OwnProcessor::~OwnProcessor() {
  if (policy_ == SCHED_OTHER) schedule(SCHED_OTHER);
  if (known_) ::sched_setaffinity(0, sizeof allowed_, &allowed_);
}

int OwnProcessor::choose() {
  if (!known_) return -1;
  for (int processor = 0; processor < CPU_SETSIZE; ++processor) {
    if (!CPU_ISSET(processor, &allowed_)) continue;
    claim_ = claim(processor);
    if (claim_.value() >= 0) return processor;
  }
  return ::sched_getcpu();
}

}  // namespace host_sim
