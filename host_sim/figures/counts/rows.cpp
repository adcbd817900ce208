#include <host_sim/figures/counts/rows.hpp>

#include <counted.hpp>
#include <stdexcept>

namespace counts {

std::vector<Row> rows(const std::string& robot) {
  std::vector<Row> result;
  std::string names;
  Counted::for_each([&](auto named) {
    names += std::string(" ") + named.name;
    if (!robot.empty() && robot != named.name) return;
    const auto own = rows_of<typename decltype(named)::Robot>();
    result.insert(result.end(), own.begin(), own.end());
  });
  if (result.empty()) throw std::invalid_argument("unknown robot '" + robot + "'; there are:" + names);
  return result;
}

}  // namespace counts
