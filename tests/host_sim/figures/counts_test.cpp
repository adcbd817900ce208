// Operation counts of every robot and count model: exactly what is pinned, nowhere above openSYMORO, and below what a
// trace reached except where this file says so.
#include <gtest/gtest.h>
#include <axial/links/link_view.hpp>
#include <host_sim/figures/counts/rows.hpp>
#include <nlohmann/json.hpp>
#include <robots/models/models.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <tuple>

namespace {

using nlohmann::json;
using Key = std::tuple<std::string, std::string, std::string>;

json load(const std::string& file) { return json::parse(std::ifstream(std::string(AXIAL_ROOT) + "/" + file)); }

Key key(const json& row) { return {row.at("robot"), row.at("algorithm"), row.at("parameters")}; }

std::string text(const Key& key) { return std::get<0>(key) + " " + std::get<1>(key) + " " + std::get<2>(key); }

const std::map<Key, axial::Operations>& counted() {
  static const auto result = [] {
    std::map<Key, axial::Operations> all;
    for (const auto& row : counts::rows())
      all[{row.robot, row.algorithm, row.parameters}] = row.cost;
    return all;
  }();
  return result;
}

int total(const axial::Operations& o) { return o.mul + o.add; }
int total(const json& pair) { return pair.at(0).get<int>() + pair.at(1).get<int>(); }

// Calls check(row, our M + A, published M + A) for every published figure of that kind.
template <class Check>
void for_each_published(const char* kind, const Check& check) {
  const json file = load("doc/data/published_counts.json");
  int compared = 0;
  for (const json& row : file.at("rows"))
    if (row.contains(kind)) check(key(row), total(counted().at(key(row))), total(row.at(kind))), ++compared;
  EXPECT_GT(compared, 0);
}

}  // namespace

TEST(OperationCounts, AreThoseThatArePinned) {
  const json pins = load("tests/host_sim/figures/operation_counts.json");
  EXPECT_EQ(pins.size(), counted().size());
  for (const json& pin : pins) {
    SCOPED_TRACE(text(key(pin)));
    const axial::Operations& ours = counted().at(key(pin));
    EXPECT_EQ(ours.mul, pin.at("mul"));
    EXPECT_EQ(ours.add, pin.at("add"));
    EXPECT_EQ(ours.div, pin.at("div"));
    EXPECT_EQ(ours.sincos, pin.at("sincos"));
  }
}

TEST(OperationCounts, NowhereExceedOpenSymoro) {
  for_each_published("open_symoro", [](const Key& row, int ours, int published) {
    std::printf("%-50s %5d, %.0f %% below openSYMORO\n", text(row).c_str(), ours, 100.0 - 100.0 * ours / published);
    EXPECT_LE(ours, published) << text(row);
  });
}

// Misses are explained in doc/measurements/counts.md; whoever mends one takes it off this list.
TEST(OperationCounts, ReachWhatATraceReached) {
  const std::map<Key, int> missed_by{
      {{"model_puma560", "articulated_body", "base"}, 2},
      {{"model_rx90", "articulated_body", "base"}, 9},
  };
  for_each_published("reachable", [&](const Key& row, int ours, int published) {
    const auto missed = missed_by.find(row);
    EXPECT_LE(ours, published + (missed == missed_by.end() ? 0 : missed->second)) << text(row);
    if (missed != missed_by.end()) {
      EXPECT_GT(ours, published) << text(row) << " is reached now: take it off the list";
    }
  });
}

TEST(OperationCounts, OfTheScaraInClosedFormAreThePublishedOnesAtMost) {
  const json closed = load("doc/data/published_counts.json").at("closed_form");
  const auto& ours = counted().at({"scara", "closed_form", "base"});
  EXPECT_LE(ours.mul, closed.at("mul"));
  EXPECT_LE(ours.add, closed.at("add"));
  EXPECT_EQ(ours.sincos, closed.at("sincos"));
}

TEST(OperationCounts, OfForwardDynamicsAreThoseOfTheFormThatItTakes) {
  for (const auto& row : counts::rows())
    if (row.algorithm == "forward_dynamics") {
      EXPECT_EQ(row.cost, counted().at({row.robot, row.route, row.parameters})) << row.robot;
    }
}

TEST(OperationCounts, OfAnUnknownRobotAreRefused) {
  try {
    counts::rows("nobody");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("nobody"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("model_iiwa"), std::string::npos);
  }
}

// No constant of a count model may save what another robot of its structure would have to compute.
TEST(CountModels, HaveGenericConstants) {
  robots::Models::for_each([](auto named) {
    using R = typename decltype(named)::Robot;
    std::vector<double> seen;
    const auto expect_generic = [&](double value, const char* what) {
      for (const double other : {0.0, 1.0, -1.0})
        EXPECT_GT(std::fabs(value - other), 1e-9) << R::name << ' ' << what;
      for (const double other : seen)
        EXPECT_GT(std::fabs(std::fabs(value / other) - 1.0), 1e-9) << R::name << ' ' << what << ' ' << value;
      seen.push_back(value);
    };
    for (const auto& c : axial::detail::robot_constants<R>.links) {
      for (const double x : {c.mass, c.hx, c.hy, c.hz, c.jxx, c.jyy, c.jzz, c.jxy, c.jxz, c.jyz})
        expect_generic(x, "inertia");
      for (const double x : {c.a, c.d})
        if (x != 0.0) expect_generic(x, "length");
      EXPECT_EQ(c.rotor, 0.0);
    }
  });
}
