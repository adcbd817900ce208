#include <host_sim/tools/output/files.hpp>

#include <host_sim/tools/output/table.hpp>
#include <host_sim/tools/system/process.hpp>
#include <host_sim/tools/system/temporary_folder.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace host_sim {

namespace {

constexpr auto plot_limit = std::chrono::seconds(120);

std::ofstream create(const std::string& path) {
  std::ofstream file(path);
  if (!file) throw std::runtime_error("cannot write " + path);
  return file;
}

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

CsvFile::CsvFile(const std::string& path, const std::vector<std::string>& header) : file_(create(path)) {
  for (const std::string& name : header)
    cell(name);
  end_row();
}

void CsvFile::cell(double value, int digits) { cell(significant(value, digits)); }

void CsvFile::cell(const std::string& text) {
  if (!first_) file_ << ',';
  file_ << text;
  first_ = false;
}

void CsvFile::end_row() {
  file_ << '\n';
  first_ = true;
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error("cannot make folder " + path + ": " + error.message());
}

void write_json(const std::string& path, const nlohmann::json& value) { create(path) << value.dump(2) << '\n'; }

void run_plot(const std::string& script, const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  std::vector<std::string> command = {"/usr/bin/python3", "-E",
                                      std::string(AXIAL_ROOT) + "/host_sim/figures/plot/" + script};
  command.insert(command.end(), arguments.begin(), arguments.end());
  Process process(command, folder.file("messages"));
  const auto status = process.wait(plot_limit);
  if (!status || *status != 0)
    throw std::runtime_error("drawing failed (" + script + "): " + content(folder.file("messages")));
}

}  // namespace host_sim
