#include <host_sim/numbers/errors.hpp>

#include <robots/robots.hpp>

#include <stdexcept>

namespace numbers {
namespace {

using Compared = robots::List<robots::Scara, robots::Puma560, robots::Panda>;

}  // namespace

std::vector<std::string> robots() {
  std::vector<std::string> names;
  Compared::for_each([&](auto robot) { names.push_back(robot.name); });
  return names;
}

std::vector<Row> rows(const std::string& robot) {
  std::vector<Row> found;
  std::string all;
  Compared::for_each([&](auto named) {
    all += (all.empty() ? "" : ", ") + std::string(named.name);
    if (robot == named.name) found = rows_of<typename decltype(named)::Robot>();
  });
  if (found.empty()) throw std::runtime_error("unknown robot '" + robot + "'; there are: " + all);
  return found;
}

}  // namespace numbers
