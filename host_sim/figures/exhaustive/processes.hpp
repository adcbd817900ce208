// What `./axial exhaustive --ranges` counts, in processes: the library's count of overflows is one a process.
#pragma once

#include <host_sim/figures/exhaustive/ranges_rows.hpp>

#include <sys/wait.h>
#include <unistd.h>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <utility>
#include <vector>

namespace exhaustive {

/// A process' states are drawn in so many parts, for its line of progress, each by a seed of its own.
constexpr int parts = 100;

/// All that `part(states, seed)` counts in the parts of process k.
template <class Part>
std::uint64_t counted(const Options& options, unsigned k, const char* text, const Part& part) {
  std::uint64_t found = 0;
  for (int p = 0; p < parts; ++p) {
    found += part(options.states / options.processes / parts,
                  options.seed * 1000003U + k * 1009U + static_cast<unsigned>(p));
    if (k == 0 && isatty(2) != 0) std::fprintf(stderr, "\r%s %d %%", text, p + 1);
  }
  if (k == 0) std::fprintf(stderr, isatty(2) != 0 ? "\n" : "%s done\n", text);
  return found;
}

/// All that `part(states, seed)` counts over all states. Throws std::runtime_error where a process did not tell.
template <class Part>
std::uint64_t in_processes(const Options& options, const char* text, const Part& part) {
  std::vector<std::pair<pid_t, int>> children;
  for (unsigned k = 0; k < options.processes; ++k) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
      const std::uint64_t found = counted(options, k, text, part);
      const bool told = write(ends[1], &found, sizeof found) == static_cast<ssize_t>(sizeof found);
      _exit(told ? 0 : 1);
    }
    close(ends[1]);
    children.emplace_back(child, ends[0]);
  }
  std::uint64_t all = 0;
  bool heard = true;
  for (const auto& [child, end] : children) {
    std::uint64_t found = 0;
    heard = read(end, &found, sizeof found) == static_cast<ssize_t>(sizeof found) && heard;
    int status = 0;
    waitpid(child, &status, 0);
    close(end);
    heard = heard && status == 0;
    all += found;
  }
  if (!heard) throw std::runtime_error("a process ended early");
  return all;
}

}  // namespace exhaustive
