// Writes what our congruence of an inertia costs beside a dense one and a planar rotation's, as JSON on standard
// output.
#include <host_sim/figures/counts/congruence_rows.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>

int main() {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const auto& row : counts::congruence_rows())
    array.push_back({{"congruence", row.congruence},
                     {"mul", row.cost.mul},
                     {"add", row.cost.add},
                     {"scenario", "rods, straight, zigzag and curled"},
                     {"links", row.links},
                     {"error_float", row.in_float},
                     {"error_double", row.in_double}});
  std::printf("%s\n", array.dump(1).c_str());
}
