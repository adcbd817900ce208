// Runs what may take the process down: some engines answer NaN by abort().
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <vector>

namespace stability {

/// The numbers that `work` returns, from a child process; nothing if that died. Its messages are dropped.
template <class Work>
std::optional<std::vector<double>> in_child(Work work) {
  int ends[2];
  std::fflush(nullptr);
  if (pipe(ends) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
    const std::vector<double> numbers = work();
    for (const double x : numbers)
      if (write(ends[1], &x, sizeof x) != static_cast<ssize_t>(sizeof x)) _exit(1);
    _exit(0);
  }
  close(ends[1]);
  std::vector<double> numbers;
  for (double x = 0.0; read(ends[0], &x, sizeof x) == static_cast<ssize_t>(sizeof x);)
    numbers.push_back(x);
  close(ends[0]);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0) return std::nullopt;
  return numbers;
}

}  // namespace stability
