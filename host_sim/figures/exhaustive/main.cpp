// Runs the integer primitives over all their arguments.
#include <host_sim/figures/exhaustive/sweep.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/progress.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace {

using exhaustive::Finding;

nlohmann::ordered_json row(const Finding& f, const std::string& commit) {
  const auto n = static_cast<double>(f.arguments);
  return {{"subject", f.subject},
          {"unit", f.unit},
          {"arguments", f.arguments},
          {"error", f.worst()},
          {"at", f.worst_at()},
          {"error_highest", f.highest},
          {"error_lowest", f.lowest},
          {"error_mean", f.sum / n},
          {"error_rms", std::sqrt(f.sum_of_squares / n)},
          {"bound", f.bound},
          {"broken", f.broken},
          {"pass", f.holds()},
          {"command", "./axial exhaustive"},
          {"compiler", "g++ " __VERSION__},
          {"flags", AXIAL_EXHAUSTIVE_FLAGS},
          {"commit", commit}};
}

void print(const std::vector<Finding>& findings) {
  host_sim::Table table({"subject", "arguments", "largest error", "at", "rms error", "bound", "symmetry broken"});
  for (const Finding& f : findings)
    table.add({f.subject, host_sim::grouped(f.arguments), host_sim::significant(f.worst(), 4),
               std::to_string(f.worst_at()),
               host_sim::significant(std::sqrt(f.sum_of_squares / static_cast<double>(f.arguments)), 3),
               host_sim::significant(f.bound), std::to_string(f.broken)});
  std::fputs(table.text().c_str(), stdout);
}

template <class Sweep>
void append(std::vector<Finding>& all, const char* text, Sweep sweep, unsigned threads, std::uint32_t stride) {
  std::size_t total = (std::size_t{1} << 20) / stride;
  host_sim::Progress progress(text, total);
  const auto part = sweep(threads, stride, [&](std::size_t done, std::size_t of) { progress.at(done * total / of); });
  all.insert(all.end(), part.begin(), part.end());
}

void write(const std::vector<Finding>& findings, const std::string& commit, const std::string& output,
           const std::string& json) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array(), envelopes = rows;
  for (const Finding& f : findings) {
    rows.push_back(row(f, commit));
    envelopes.push_back({{"subject", f.subject}, {"bound", f.bound}, {"upper", f.upper}, {"lower", f.lower}});
  }
  host_sim::make_folder(output);
  host_sim::write_json(output + "/sincos_exhaustive.json", rows);
  host_sim::write_json(output + "/sincos_envelopes.json", envelopes);
  if (!json.empty()) host_sim::write_json(json, rows);
  host_sim::run_plot("exhaustive.py", {output + "/sincos_envelopes.json", output + "/sincos_exhaustive"});
}

}  // namespace

int main(int argc, char** argv) {
  host_sim::CommandLine line("every argument of the integer primitives", "exhaustive");
  std::string output = "output/exhaustive", json, commit;
  unsigned threads = 2;
  std::uint32_t stride = 1;
  line.option("--output", output);
  line.option("--json", json);
  line.option("--commit", commit);
  line.option("--threads", threads).range(1, 64);
  line.option("--stride", stride).range(1, 1 << 16);
  return line.run(argc, argv, [&] {
    std::vector<Finding> findings;
    append(findings, "sine and cosine, blocks of 4096 angles:", exhaustive::sweep_angles, threads, stride);
    append(findings, "reciprocal, blocks of 2048 integers:", exhaustive::sweep_reciprocals, threads, stride);
    print(findings);
    write(findings, commit, output, json);
    bool holds = true;
    for (const Finding& f : findings) {
      if (!f.holds()) std::fprintf(stderr, "exhaustive: %s breaks its bound or symmetry\n", f.subject.c_str());
      holds = holds && f.holds();
    }
    return holds ? 0 : 1;
  });
}
