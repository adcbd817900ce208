#include <stability/fixed/declared.hpp>
#include <stability/fixed/rows.hpp>

namespace stability {
namespace {

using namespace declared;

/// A gate is twice what was seen, so that a change shows: the same bits come out of every build.
struct Entry {
  const char* scenario;
  double gate;
  Row (*row)(const Scenario&);
};
constexpr Entry entries[] = {{"S01_straight_N10", 3e-4, fixed_row<Rods>},
                             {"S04_heavytip_2^0", 5e-5, fixed_row<Arm<HeavyTip>>},
                             {"S05_lighttip_2^-10", 3e-5, fixed_row<Arm<LightTip>>},
                             {"S06_zyx_eps2^-11_rot2^-10", 1e-3, fixed_row<Wrist>},
                             {"S08_rotor_2^10", 8e-8, fixed_row<Arm<LargeRotors>>},
                             {"S10_speed_2^5", 4e-5, fixed_row<Arm<Fast>>},
                             {"S14_hold_gravity", 2e-5, fixed_row<Arm<Nominal>>},
                             {"S00_arm6_nominal", 9e-6, fixed_row<Arm<Nominal>>}};

}  // namespace

std::vector<Row> fixed_rows(const std::string& filter) {
  std::vector<Row> rows;
  for (const Scenario& scenario : cases::scenarios())
    for (const Entry& entry : entries)
      if (scenario.name == entry.scenario && scenario.name.find(filter) != std::string::npos) {
        Row row = entry.row(scenario);
        row.gate.forward = entry.gate, row.pass = row.pass && row.forward <= entry.gate;
        rows.push_back(row);
      }
  return rows;
}

}  // namespace stability
