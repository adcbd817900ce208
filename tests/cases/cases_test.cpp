// Every implementation against every validation case: other people's published figures, and 30-digit references.
#include <gtest/gtest.h>

#include <cases/implementation.hpp>

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

struct Pairing {
  std::shared_ptr<const Implementation> implementation;
  std::string file;
};
void PrintTo(const Pairing& pairing, std::ostream* out) {
  *out << pairing.implementation->name() << " " << pairing.file;
}

std::vector<Pairing> pairings() {
  std::vector<Pairing> all;
  for (const auto& implementation : implementations())
    for (const std::string& name : case_names())
      all.push_back({implementation, name});
  return all;
}

class Case : public testing::TestWithParam<Pairing> {
 protected:
  const Implementation& implementation() const { return *GetParam().implementation; }

  /// Largest error of one quantity over the states of the file, minus what each figure may be off by itself.
  void check(const std::map<std::string, Values>& figures, const State& state, bool published) {
    for (const auto& [quantity, expected] : figures) {
      const auto actual = implementation().evaluate(file, state, quantity);
      if (!actual) continue;
      const double own = published ? state.tolerance.at(quantity) : 0.0;
      const double scale = file.scale(quantity), error = largest_difference(*actual, expected);
      EXPECT_LE(error, own + implementation().tolerance() * scale) << state.id << " " << quantity << " scale " << scale;
      if (!published) worst = std::max(worst, error / scale);
    }
  }

  CaseFile file = load_case(GetParam().file);
  double worst = 0.0;
};

TEST_P(Case, MatchesThirtyDigitReferences) {
  for (const State& state : file.states)
    check(state.reference, state, false);
  RecordProperty("worst_relative_error", scientific(worst));
}

TEST_P(Case, MatchesPublishedFigures) {
  for (const State& state : file.states)
    check(state.expect, state, true);
}

INSTANTIATE_TEST_SUITE_P(Cases, Case, testing::ValuesIn(pairings()), [](const auto& info) {
  return std::string(info.param.implementation->name()) + "__" + info.param.file;
});

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
