#include <stability/fixed/declared.hpp>
#include <stability/fixed/rows.hpp>

namespace stability {
namespace {

template <class... R>
struct Robots {
  static std::vector<Row> rows(const std::string& filter) {
    std::vector<Row> result;
    for (const Scenario& scenario : cases::scenarios())
      if (scenario.name.find(filter) != std::string::npos) (add<R>(scenario, result), ...);
    return result;
  }

 private:
  template <class Robot>
  static void add(const Scenario& scenario, std::vector<Row>& rows) {
    if (scenario.name == Robot::name) rows.push_back(fixed_row<Robot>(scenario));
  }
};

using namespace declared;
using Declared = Robots<Rods, Arm<HeavyTip>, Arm<LightTip>, Wrist, Arm<SmallRotors>, Arm<LargeRotors>, Arm<Fast>,
                        Arm<Tiny>, Arm<Held>, Arm<Nominal>>;

}  // namespace

std::vector<Row> fixed_rows(const std::string& filter) { return Declared::rows(filter); }

}  // namespace stability
