#include <host_sim/robots/description/own_comments.hpp>
#include <host_sim/robots/description/table.hpp>

#include <filesystem>
#include <regex>
#include <sstream>

namespace description {
namespace {

void take_names(Description& robot, const std::string& text) {
  std::istringstream lines(text);
  const std::regex named(R"(\s*// (\d+): (.+) moves (.+))");
  for (std::string line; std::getline(lines, line);)
    if (std::smatch found; std::regex_match(line, found, named))
      if (const std::size_t i = std::stoul(found[1].str()); i < robot.links.size())
        robot.links[i].joint = found[2].str(), robot.links[i].name = found[3].str();
}

/// Whether a line without an indent goes on with what a remark says: somebody wrote it by hand.
bool is_unfinished(const std::string* remark) { return remark != nullptr && !remark->empty() && remark->back() != '.'; }

/// Remarks go on over lines that are indented, and over others as long as their sentence has no end.
void take_remarks(Description& robot, const std::string& text) {
  std::istringstream lines(text);
  const std::regex begins(R"(// ([a-z]+):\s+(.*\S)\s*)"), goes_on(R"(//( +)(\S.*?)\s*)");
  std::string* remark = nullptr;  // that the next line may go on with
  const auto begin = [&](const std::string& head, const std::string& said) {
    auto* all = head == "read" ? &robot.notes : head == "assumed" ? &robot.assumptions : nullptr;
    remark = all == nullptr ? nullptr : &all->emplace_back(said);
  };
  for (std::string line; std::getline(lines, line) && line.rfind("//", 0) == 0;) {
    std::smatch found;
    if (std::regex_match(line, found, begins))
      begin(found[1].str(), found[2].str());
    else if (std::regex_match(line, found, goes_on) && (found[1].length() > 1 || is_unfinished(remark))) {
      if (remark != nullptr) *remark += " " + found[2].str();
    } else
      remark = nullptr;
  }
}

}  // namespace

void take_comments(Description& robot, const std::string& header) {
  robot.source = std::filesystem::path(header).filename().string();  // no path of a machine
  const std::string text = read_text(header);
  take_names(robot, text);
  take_remarks(robot, text);
}

}  // namespace description
