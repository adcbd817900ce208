// What a program says of its own figures.
#pragma once

#include <cstdio>
#include <string>
#include <utility>

namespace host_sim {

/// Tells each expectation that fails, on standard error; one that failed is never forgotten.
class Verdict {
 public:
  explicit Verdict(std::string program) : program_(std::move(program)) {}
  void expect(bool held, const std::string& otherwise) {
    if (held) return;
    ++failed_;
    std::fprintf(stderr, "%s: %s\n", program_.c_str(), otherwise.c_str());
  }
  /// That a program ends with.
  [[nodiscard]] int status() const { return failed_ == 0 ? 0 : 1; }

 private:
  std::string program_;
  int failed_ = 0;
};

}  // namespace host_sim
