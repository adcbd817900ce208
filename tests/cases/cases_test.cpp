// Every implementation against every validation case: other people's published figures, and 30-digit references.
#include <gtest/gtest.h>

#include <algorithm>
#include <cases/implementation.hpp>
#include <cstdio>

namespace cases {
namespace {

ImplementationList implementations() {
  ImplementationList all = references();
  for (const auto& implementation : library())
    all.push_back(implementation);
  return all;
}

double largest_difference(const Values& actual, const Values& expected) {
  if (actual.size() != expected.size()) return HUGE_VAL;
  double worst = 0.0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const double difference = static_cast<double>(oracle::abs(actual[i] - expected[i]));
    if (!(difference <= worst)) worst = difference == difference ? difference : HUGE_VAL;
  }
  return worst;
}

std::string scientific(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", value);
  return text;
}

class Implementations : public testing::TestWithParam<std::shared_ptr<const Implementation>> {
 protected:
  const Implementation& implementation() const { return *GetParam(); }

  /// Every figure of a state that the implementation answers; what a published figure may be off by itself is added.
  void check(const CaseFile& file, const State& state, bool published) {
    for (const auto& [quantity, expected] : published ? state.expect : state.reference) {
      const auto actual = implementation().evaluate(file, state, quantity);
      if (!actual) continue;
      const double own = published ? state.tolerance.at(quantity) : 0.0;
      const double scale = file.scale(quantity), error = largest_difference(*actual, expected);
      EXPECT_LE(error, own + implementation().tolerance() * scale) << state.id << " " << quantity << " scale " << scale;
      if (!published) worst = std::max(worst, error / scale);
    }
  }
  void check_all(bool published) {
    for (const std::string& name : case_names()) {
      SCOPED_TRACE(name);
      const CaseFile file = load_case(name);
      for (const State& state : file.states)
        check(file, state, published);
    }
  }

  double worst = 0.0;
};

TEST_P(Implementations, MatchThirtyDigitReferences) {
  check_all(false);
  RecordProperty("worst_relative_error", scientific(worst));
}

TEST_P(Implementations, MatchPublishedFigures) { check_all(true); }

INSTANTIATE_TEST_SUITE_P(Cases, Implementations, testing::ValuesIn(implementations()),
                         [](const auto& info) { return std::string(info.param->name()); });

TEST(Cases, AreAllThere) { EXPECT_EQ(case_names().size(), 25U); }

TEST(Cases, LibraryAnswersEveryQuantity) {
  for (const std::string& name : case_names()) {
    const CaseFile file = load_case(name);
    for (const State& state : file.states)
      for (const auto& figure : state.reference)
        for (const auto& implementation : library())
          EXPECT_TRUE(implementation->evaluate(file, state, figure.first)) << name << " " << figure.first;
  }
}

/// Where the misprint shows, an implementation must stay away from it; whether it showed.
bool told_apart(const std::optional<Values>& actual, quad correct, double printed) {
  constexpr double separation = 1e-3;  // the misprint is off by m3 a1 a2 cos(theta2): 0.04 or more in these states
  if (!actual || std::fabs(printed - static_cast<double>(correct)) < separation) return false;
  EXPECT_GT(std::fabs(static_cast<double>(actual->front()) - printed), separation);
  return true;
}

/// Negative control: equation (82) as the paper prints it, with m2 + m3 for m2 + 2 m3, must be reproduced by nobody.
TEST(Cases, NobodyMatchesTheMisprintedScara) {
  const CaseFile file = load_case("scara_djuric_rrp");
  for (const auto& implementation : implementations()) {
    SCOPED_TRACE(implementation->name());
    int shown = 0;
    for (const PrintedFigures& printed : load_misprint()) {
      const State& state = file.state(printed.id);
      const auto answer = [&](const char* quantity) { return implementation->evaluate(file, state, quantity); };
      shown += told_apart(answer("M"), state.reference.at("M").front(), printed.a11);
      shown += told_apart(answer("tau"), state.reference.at("tau").front(), printed.tau1);
    }
    EXPECT_GE(shown, 2);
  }
}

}  // namespace
}  // namespace cases
