// A folder for files that nobody keeps.
#pragma once

#include <string>

namespace host_sim {

/// The destructor removes it with all it holds.
class TemporaryFolder {
 public:
  /// Throws std::runtime_error when there is no room for it.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace host_sim
