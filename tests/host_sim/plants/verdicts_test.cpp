// Each promise that a program of closed loops makes of its rows, broken by itself, ends it with status 1.
#include <host_sim/plants/loop/verdicts.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using namespace host_sim;
using namespace host_sim::loop;

/// The status of a program whose row is this one, changed.
template <class R>
int status_of(R row, void (*expectations)(Verdict&, const R&), const std::function<void(R&)>& change) {
  change(row);
  Verdict verdict("test");
  expectations(verdict, row);
  return verdict.status();
}
Row row_of(const char* name, double ratio) {
  Row row;
  row.name = name, row.ratio = ratio;
  return row;
}
PushRow pushed() {
  PushRow row;
  row.controller = "lqr", row.board = "stm32f405", row.situation.push = {0.1};
  row.recovery.seconds = back_within, row.recovery.effort = 1.0, row.recovery.most = 167'999;
  return row;
}
int of_filter(const std::function<void(VelocityErrors&)>& change, std::uint32_t instructions = 167'999) {
  VelocityErrors errors;
  errors.filter = {1.0, 2.0, 1.0}, errors.difference = {30.0, 20.0, 30.0};
  change(errors);
  Verdict verdict("test");
  expect_filter(verdict, errors, instructions, filter_ratio);
  return verdict.status();
}

}  // namespace

TEST(Verdict, OneFailureIsEnoughWhereverItStands) {
  for (int failing = -1; failing < 3; ++failing) {
    Verdict verdict("test");
    for (int i = 0; i < 3; ++i)
      verdict.expect(i != failing, "this one fails");
    EXPECT_EQ(verdict.status(), failing < 0 ? 0 : 1) << failing;
  }
}
TEST(LoopVerdicts, OfFeedForward) {
  const Row good = row_of("exact parameters", tracking_ratio);
  const auto status = [&](const std::function<void(Row&)>& change) {
    return status_of<Row>(good, expect_tracking, change);
  };
  EXPECT_EQ(status([](Row&) {}), 0);
  EXPECT_EQ(status([](Row& r) { r.ratio = 19.9; }), 1);
  EXPECT_EQ(status([](Row& r) { r.tracking.refused = 1; }), 1);
  EXPECT_EQ(status([](Row& r) { r.ratio = 0.0, r.situation.feeds_forward = false; }), 0) << "feedback alone";
  EXPECT_EQ(status([](Row& r) { r.ratio = 2.0, r.name = "parameters 10 % off"; }), 0);
}
TEST(LoopVerdicts, OfElasticJoints) {
  const Row good = row_of("harmonic drives", elastic_ratio);
  const auto status = [&](const std::function<void(Row&)>& change) {
    return status_of<Row>(good, expect_elastic, change);
  };
  EXPECT_EQ(status([](Row&) {}), 0);
  EXPECT_EQ(status([](Row& r) { r.ratio = 9.9; }), 1);
  EXPECT_EQ(status([](Row& r) { r.ratio = std::nan(""); }), 1);
  EXPECT_EQ(status([](Row& r) { r.tracking.refused = 1; }), 1);
  EXPECT_EQ(status([](Row& r) { r.ratio = 0.0, r.situation.as_rigid = true; }), 0) << "rigid feed-forward";
  EXPECT_EQ(status([](Row& r) { r.ratio = 2.0, r.name = "stiffness"; }), 0);
}
TEST(LoopVerdicts, OfPushes) {
  const auto status = [&](const std::function<void(PushRow&)>& change) {
    return status_of<PushRow>(pushed(), expect_recovery, change);
  };
  EXPECT_EQ(status([](PushRow&) {}), 0);
  EXPECT_EQ(status([](PushRow& r) { r.recovery.tracking.refused = 1; }), 1);
  EXPECT_EQ(status([](PushRow& r) { r.recovery.effort = 1.001; }), 1);
  EXPECT_EQ(status([](PushRow& r) { r.recovery.seconds = 0.501; }), 1);
  EXPECT_EQ(status([](PushRow& r) { r.recovery.seconds = 1.0, r.situation.push.clear(); }), 0) << "was not pushed";
  EXPECT_EQ(status([](PushRow& r) { r.recovery.seconds = 1.0, r.controller = "pd"; }), 0) << "promises nothing";
  EXPECT_EQ(status([](PushRow& r) { r.recovery.effort = 1.001, r.controller = "pd"; }), 1) << "but limits";
  EXPECT_EQ(status([](PushRow& r) { r.recovery.most = 168'000; }), 1);
  EXPECT_EQ(status([](PushRow& r) { r.recovery.most = 168'000, r.board = "host"; }), 0);
}
TEST(LoopVerdicts, OfTheFilter) {
  EXPECT_EQ(of_filter([](VelocityErrors&) {}), 0);
  EXPECT_EQ(of_filter([](VelocityErrors& e) { e.filter[1] = 2.1; }), 1) << "the joint that it helps least";
  EXPECT_EQ(of_filter([](VelocityErrors& e) { e.tracking.refused = 1; }), 1);
  EXPECT_EQ(of_filter([](VelocityErrors&) {}, 168'000), 1);
}
