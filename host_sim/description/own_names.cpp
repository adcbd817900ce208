#include <host_sim/description/own_names.hpp>
#include <host_sim/description/table.hpp>

#include <filesystem>
#include <regex>
#include <sstream>

namespace description {

void take_names(Description& robot, const std::string& header) {
  robot.source = std::filesystem::path(header).filename().string();  // no path of a machine
  std::istringstream lines(read_text(header));
  const std::regex named(R"(\s*// (\d+): (.+) moves (.+))");
  for (std::string line; std::getline(lines, line);)
    if (std::smatch found; std::regex_match(line, found, named))
      if (const std::size_t i = std::stoul(found[1].str()); i < robot.links.size())
        robot.links[i].joint = found[2].str(), robot.links[i].name = found[3].str();
}

}  // namespace description
