#include <host_sim/plants/real_time/rows.hpp>

#include <nlohmann/json.hpp>

namespace host_sim::real_time {

std::vector<Row> rows() {
  std::vector<Row> all;
  for (const auto& some : {puma560_rows(), scara_rows(), swing_rows()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

nlohmann::json to_json(const std::vector<Row>& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const Row& r : rows) {
    const bool free = r.energy_drift > 0.0;
    all.push_back({{"board", "host"},
                   {"robot", r.robot},
                   {"scalar", r.scalar},
                   {"method", r.method},
                   {"motion", r.motion},
                   {"step_s", r.step},
                   {"steps_per_s", nullptr},
                   {"real_time_factor", nullptr},
                   {"error", free ? nlohmann::json() : nlohmann::json(r.error)},
                   {"energy_drift", free ? nlohmann::json(r.energy_drift) : nlohmann::json()},
                   {"gate", r.gate},
                   {"pass", r.pass()},
                   {"instructions", nullptr},
                   {"microseconds", nullptr},
                   {"kind", nullptr}});
  }
  return all;
}

}  // namespace host_sim::real_time
