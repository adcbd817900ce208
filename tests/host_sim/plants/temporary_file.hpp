// A file that lives as long as a test.
#pragma once

#include <host_sim/tools/system/temporary_folder.hpp>

#include <fstream>
#include <string>

namespace host_sim::test {

class TemporaryFile {
 public:
  TemporaryFile(const std::string& ending, const std::string& content) : path_(folder_.file("file" + ending)) {
    std::ofstream(path_) << content;
  }

  const std::string& path() const { return path_; }

 private:
  TemporaryFolder folder_;
  std::string path_;
};

}  // namespace host_sim::test
