// A file that lives as long as a test.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace host_sim::test {

class TemporaryFile {
 public:
  TemporaryFile(const std::string& ending, const std::string& content) {
    std::string name = (std::filesystem::temp_directory_path() / "axial-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    path_ = (folder_ / ("file" + ending)).string();
    std::ofstream(path_) << content;
  }
  ~TemporaryFile() { std::filesystem::remove_all(folder_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::filesystem::path folder_;
  std::string path_;
};

}  // namespace host_sim::test
