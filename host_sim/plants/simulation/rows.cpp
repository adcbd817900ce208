#include <host_sim/plants/simulation/rows.hpp>

#include <nlohmann/json.hpp>

#include <cmath>

namespace host_sim::simulation {

namespace {

nlohmann::json number(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); }

}  // namespace

Row gated(Row row) {
  row.pass = row.error <= row.gate;
  row.status = std::isfinite(row.error) ? "ok" : "not finite";
  return row;
}

nlohmann::json to_json(const std::vector<Row>& rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const Row& r : rows)
    list.push_back({{"scenario", r.scenario},
                    {"scalar", r.scalar},
                    {"route", r.route},
                    {"step", r.step},
                    {"seconds", r.seconds},
                    {"quantity", r.quantity},
                    {"forward_error", number(r.error)},
                    {"backward_error", nullptr},
                    {"gate", number(r.gate)},
                    {"pass", r.pass},
                    {"status", r.status}});
  return list;
}

}  // namespace host_sim::simulation
