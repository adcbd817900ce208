// One line on standard error that says how far a long step is.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace host_sim {

/// On a terminal a line that counts up; elsewhere a line every ten seconds, so that a log stays readable.
class Progress {
 public:
  Progress(std::string text, std::size_t total) : text_(static_cast<std::string&&>(text)), total_(total) {}
  ~Progress() {
    if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void at(std::size_t done) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + (terminal_ ? std::chrono::milliseconds(100) : std::chrono::seconds(10));
    const std::size_t percent = total_ == 0 ? 100 : 100 * done / total_;
    std::fprintf(stderr, terminal_ ? "\r%s %zu %% (%zu of %zu)" : "%s %zu %% (%zu of %zu)\n", text_.c_str(), percent,
                 done, total_);
    shown_ = true;
  }

 private:
  std::string text_;
  std::size_t total_;
  bool terminal_ = ::isatty(STDERR_FILENO) == 1, shown_ = false;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace host_sim
