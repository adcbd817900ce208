// Result files: CSV, JSON, and pictures drawn from them by Debian's own Python.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <fstream>
#include <string>
#include <vector>

namespace host_sim {

/// Rows of comma separated numbers below a header line. Throws std::runtime_error when the file cannot be written.
class CsvFile {
 public:
  CsvFile(const std::string& path, const std::vector<std::string>& header);

  /// Appends a cell with so many significant digits; 9 hold a float exactly.
  void cell(double value, int digits = 9);
  void cell(const std::string& text);
  void end_row();

 private:
  std::ofstream file_;
  bool first_ = true;
};

/// Creates the folder when it is missing; throws std::runtime_error when that is impossible.
void make_folder(const std::string& path);

/// Throws std::runtime_error when the file cannot be written.
void write_json(const std::string& path, const nlohmann::json& value);

/// Runs host_sim/figures/plot/<script> with arguments; throws std::runtime_error with its messages when it fails.
void run_plot(const std::string& script, const std::vector<std::string>& arguments);

}  // namespace host_sim
