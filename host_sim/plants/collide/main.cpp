// collide: a simulated Panda with and without contacts; CSV, JSON, a picture; fails when a claim does.
#include <host_sim/plants/collide/collide.hpp>
#include <host_sim/plants/collide/payload.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace {

using host_sim::collide::Instant;
using host_sim::collide::PayloadRow;
using host_sim::collide::Row;

constexpr double weighing = 60.0;                   // s
constexpr double allowed_delay = 0.010;             // s
constexpr double drawn_from = 0.4, drawn_to = 8.0;  // s of the motion with contacts, in the CSV

struct Options {
  double seconds = 600.0;
  unsigned seed = 3;
  std::string output = "output/collide", json;
};

nlohmann::json to_json(const std::vector<Row>& rows) {
  auto all = nlohmann::json::array();
  for (const Row& r : rows)
    all.push_back({{"subject", "collisions"},
                   {"robot", "panda"},
                   {"scalar", r.scalar},
                   {"seconds", r.seconds},
                   {"contacts", r.contacts},
                   {"missed", r.missed},
                   {"delay_median_s", r.median()},
                   {"delay_max_s", r.longest()},
                   {"false_alarms", r.false_alarms},
                   {"refused", r.refused},
                   {"headroom", r.headroom}});
  return all;
}

void print(const std::vector<Row>& rows) {
  host_sim::Table table({"scalar", "motion, s", "contacts", "missed", "delay, median, ms", "largest, ms",
                         "false alarms", "quiet residual / threshold"});
  for (const Row& r : rows)
    table.add({r.scalar, host_sim::significant(r.seconds, 4), std::to_string(r.contacts), std::to_string(r.missed),
               host_sim::significant(1e3 * r.median()), host_sim::significant(1e3 * r.longest()),
               std::to_string(r.false_alarms), host_sim::significant(r.headroom, 2)});
  std::printf("%s", table.text().c_str());
}

nlohmann::json to_json(const std::vector<PayloadRow>& rows) {
  auto all = nlohmann::json::array();
  for (const PayloadRow& r : rows)
    all.push_back({{"subject", "payload"},
                   {"robot", r.robot},
                   {"scalar", "float"},
                   {"seconds", r.seconds},
                   {"mass_kg", r.mass},
                   {"mass_error_kg", r.mass_error},
                   {"mass_deviation_kg", r.mass_deviation},
                   {"moment_error_kg_m", r.moment_error},
                   {"ready_s", r.ready},
                   {"refused", r.refused}});
  return all;
}

void print(const std::vector<PayloadRow>& rows) {
  host_sim::Table table({"robot", "payload, kg", "motion, s", "sure after, s", "error of mass, kg", "its deviation, kg",
                         "error of first moment, kg m"});
  for (const PayloadRow& r : rows)
    table.add({r.robot, host_sim::significant(r.mass), host_sim::significant(r.seconds), host_sim::significant(r.ready),
               host_sim::significant(r.mass_error, 2), host_sim::significant(r.mass_deviation, 2),
               host_sim::significant(r.moment_error, 2)});
  std::printf("\n%s", table.text().c_str());
}

// Half of what an estimate may deviate by and still be called sure.
bool good(const PayloadRow& r) {
  return r.sure && r.refused == 0 && std::fabs(r.mass_error) < 0.025 && r.moment_error < 0.01;
}

bool good(const Row& r) {
  return r.contacts > 0 && r.missed == 0 && r.false_alarms == 0 && r.refused == 0 && r.longest() <= allowed_delay;
}

void write(host_sim::CsvFile& file, const Instant& now) {
  if (now.time < drawn_from || now.time > drawn_to) return;
  file.cell(now.time, 6);
  for (int i = 0; i < 7; ++i)
    file.cell(now.external[i], 4), file.cell(now.residual[i], 4), file.cell(now.threshold[i], 4);
  file.cell(now.detected ? 1.0 : 0.0, 1);
  file.end_row();
}

std::vector<std::string> header() {
  std::vector<std::string> names{"time"};
  for (int i = 1; i <= 7; ++i)
    for (const char* name : {"external", "residual", "threshold"})
      names.push_back(name + std::to_string(i));
  names.push_back("detected");
  return names;
}

int measure(const Options& options) {
  host_sim::make_folder(options.output);
  const std::string stem = options.output + "/collide";
  std::vector<Row> rows;
  {
    host_sim::CsvFile file(stem + ".csv", header());
    rows.push_back(host_sim::collide::run("float", options.seconds, options.seed,
                                          [&file](const Instant& now) { write(file, now); }));
  }
  rows.push_back(host_sim::collide::run("fixed32", options.seconds, options.seed));
  print(rows);
  const auto payloads = host_sim::collide::weigh(weighing, options.seed);
  print(payloads);
  auto json = to_json(rows);
  for (const auto& row : to_json(payloads))
    json.push_back(row);
  host_sim::write_json(stem + ".json", json);
  if (!options.json.empty()) host_sim::write_json(options.json, json);
  host_sim::run_plot("collide.py", {stem + ".csv"});
  std::printf("\npicture  %s.png\ndata     %s.csv, %s.json\n", stem.c_str(), stem.c_str(), stem.c_str());
  bool all = true;
  for (const Row& r : rows)
    if (!good(r)) {
      all = false;
      std::fprintf(stderr, "collide: %s: a contact was missed or found after more than %g ms, or there was none\n",
                   r.scalar.c_str(), 1e3 * allowed_delay);
    }
  for (const PayloadRow& r : payloads)
    if (!good(r)) {
      all = false;
      std::fprintf(stderr, "collide: %s: a payload of %g kg was not weighed to 25 g and 10 g m\n", r.robot.c_str(),
                   r.mass);
    }
  return all ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  host_sim::CommandLine line("contacts of a simulated Panda and what a momentum observer makes of them", "collide");
  line.option("--seconds", options.seconds, "of motion without contacts, and again with them")
      .show_default()
      .range(3.0, 36000.0);
  line.option("--seed", options.seed, "of the motion and the noise").show_default();
  line.option("--output", options.output, "folder of CSV, JSON and picture").show_default();
  line.option("--json", options.json, "one more copy of the rows");
  return line.run(count, arguments, [&] { return measure(options); });
}
