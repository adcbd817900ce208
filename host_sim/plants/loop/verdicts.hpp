// What is expected of a closed loop, row by row.
#pragma once

#include <host_sim/plants/loop/observers.hpp>
#include <host_sim/plants/loop/pushes.hpp>
#include <host_sim/tools/output/verdict.hpp>

#include <algorithm>

namespace host_sim::loop {

constexpr std::uint32_t core_Hz = 168'000'000, ticks_a_second = 1000;
constexpr double tracking_ratio = 20.0;  // tool error of feedback alone over that with feed-forward
constexpr double elastic_ratio = 10.0;   // that of rigid joints' feed-forward over that of elastic ones'
constexpr double back_within = 0.5;      // s
// Of the velocity errors of differences over those of the filter: of counts of 2^-14 turns, and of steps of 2^-14 of a
// drive's unit, which differences know 2 pi times as well.
constexpr double filter_ratio = 10.0, filter_ratio_of_drives = 2.0;

/// Of `name`, which has the exact parameters, `asked` says whether its ratio is promised.
inline void expect_ratio(Verdict& verdict, const Row& row, const char* name, bool asked, double needed) {
  verdict.expect(row.tracking.refused == 0, row.name + ": answers were refused");
  if (row.name == name && asked)
    verdict.expect(row.ratio >= needed, row.name + ": the error is not cut " + std::to_string(needed) + "-fold, but " +
                                            std::to_string(row.ratio) + "-fold");
}
inline void expect_tracking(Verdict& verdict, const Row& row) {
  expect_ratio(verdict, row, "exact parameters", row.situation.feeds_forward, tracking_ratio);
}
inline void expect_elastic(Verdict& verdict, const Row& row) {
  expect_ratio(verdict, row, "harmonic drives", !row.situation.as_rigid, elastic_ratio);
}

inline bool fits_a_tick(std::uint32_t instructions) { return instructions < core_Hz / ticks_a_second; }

/// Torques keep their limits; the regulator brings the arm back in time, and computes in time on a board.
inline void expect_recovery(Verdict& verdict, const PushRow& row) {
  const std::string who = row.controller + ", " + row.name + ": ";
  verdict.expect(row.recovery.tracking.refused == 0, who + "answers were refused");
  verdict.expect(row.recovery.effort <= 1.0 + 1e-6, who + "a torque is beyond its limit");
  if (row.controller != "lqr") return;
  const bool back = row.situation.push.empty() || row.recovery.seconds <= back_within;
  verdict.expect(back, who + "the arm did not come back in time");
  verdict.expect(row.board == "host" || fits_a_tick(row.recovery.most), who + "an answer takes longer than a tick");
}

/// Of the joint that the filter helps least: the error of differences over its own.
inline double least_ratio(const VelocityErrors& errors) {
  double least = errors.difference[0] / errors.filter[0];
  for (std::size_t i = 1; i < errors.filter.size(); ++i)
    least = std::min(least, errors.difference[i] / errors.filter[i]);
  return least;
}
inline void expect_filter(Verdict& verdict, const VelocityErrors& errors, std::uint32_t instructions, double needed) {
  verdict.expect(errors.tracking.refused == 0, "answers were refused");
  verdict.expect(fits_a_tick(instructions), "an answer takes longer than a tick");
  verdict.expect(least_ratio(errors) >= needed, "the filter is hardly better than differences");
}

}  // namespace host_sim::loop
