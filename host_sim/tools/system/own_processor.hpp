// One processor for processes that wait for each other all the time.
#pragma once

#include <host_sim/tools/system/descriptor.hpp>

#include <sched.h>

namespace host_sim {

/// Keeps this thread and the processes that it starts on one processor: one that no other OwnProcessor has, or, where
/// all are taken, the one on which it runs. None interrupts another there: who is woken runs when the other waits.
/// Lifted by the destructor, for this thread. Where the system refuses, nothing changes.
class OwnProcessor {
 public:
  OwnProcessor();
  ~OwnProcessor();
  OwnProcessor(const OwnProcessor&) = delete;
  OwnProcessor& operator=(const OwnProcessor&) = delete;

 private:
  int choose();

  cpu_set_t allowed_{};
  bool known_;
  int policy_;
  Descriptor claim_;
};

}  // namespace host_sim
