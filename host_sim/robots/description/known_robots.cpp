#include <host_sim/robots/description/known_robots.hpp>

#include <robots/robots.hpp>

namespace description {
namespace {

template <class Visit>
void for_each(Visit&& visit) {
  robots::All::for_each(visit);
  robots::Trees::for_each(visit);
  robots::Published::for_each(visit);
  robots::SharedDrives::for_each(visit);
}

}  // namespace

std::vector<std::string> known_robots() {
  std::vector<std::string> names;
  for_each([&](auto robot) { names.emplace_back(robot.name); });
  return names;
}

Description known_robot(const std::string& name) {
  Description found;
  for_each([&](auto robot) {
    if (name == robot.name) found = from_robot<typename decltype(robot)::Robot>();
  });
  if (found.size() > 0) return found;
  std::string names;
  for (const auto& known : known_robots())
    names += (names.empty() ? "" : ", ") + known;
  throw Refused("no robot is called '" + name + "'; there are " + names);
}

}  // namespace description
