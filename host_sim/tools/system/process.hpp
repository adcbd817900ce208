// A child process that never outlives its owner.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace host_sim {

/// Runs a program with its output in a file. The destructor ends it, and the kernel does should this process die.
class Process {
 public:
  /// Throws std::runtime_error when the program cannot be started.
  Process(const std::vector<std::string>& command, const std::string& output_file);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Exit status once it has ended (128 + signal when killed by one); empty while it runs.
  std::optional<int> exit_status();
  /// Waits for the end; empty when it has not come in time.
  std::optional<int> wait(std::chrono::milliseconds limit);

 private:
  pid_t id_ = -1;
  std::optional<int> status_;
};

}  // namespace host_sim
