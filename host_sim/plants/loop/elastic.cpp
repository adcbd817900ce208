#include <host_sim/plants/loop/elastic.hpp>
#include <host_sim/plants/loop/on_host.hpp>

#include <firmware/apps/elastic/controller.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <stdexcept>

namespace host_sim::loop {

namespace {

using Factory = std::unique_ptr<Controller> (*)();
struct Entry {
  int resonance;
  Factory make;
};

template <class Robot, int resonance>
std::unique_ptr<Controller> made() {
  using axial::apps::Elastic;
  return std::make_unique<OnHost<axial::apps::ElasticController<Elastic<Robot, resonance>>>>();
}
template <class Robot, int... resonance>
std::vector<Entry> entries_of(std::integer_sequence<int, resonance...>) {
  return {{resonance, made<Robot, resonance>}...};
}
template <class Robot>
std::vector<Entry> entries() {
  return entries_of<Robot>(std::integer_sequence<int, 8, 12, 20, 40, 80, 160>{});
}

[[noreturn]] void refuse(const std::string& robot) {
  throw std::runtime_error("no arm with elastic joints is driven as '" + robot + "'; there are: scara, puma560");
}

}  // namespace

std::vector<int> resonances() {
  std::vector<int> all;
  for (const Entry& e : entries<::robots::Scara>())
    all.push_back(e.resonance);
  return all;
}

std::unique_ptr<Controller> elastic_on_host(const std::string& robot, int resonance) {
  if (robot != "scara" && robot != "puma560") refuse(robot);
  for (const Entry& e : robot == "scara" ? entries<::robots::Scara>() : entries<::robots::Puma560>())
    if (e.resonance == resonance) return e.make();
  throw std::runtime_error("no controller on the host is for joints of " + std::to_string(resonance) + " Hz");
}

std::unique_ptr<Controller> elastic_in_firmware(const std::string& board, const std::string& robot) {
  if (robot != "scara" && robot != "puma560") refuse(robot);
  return emulated(board, "elastic", robot);
}

}  // namespace host_sim::loop
