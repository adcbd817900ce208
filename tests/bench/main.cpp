// Races every kernel against its peers. Usage: see --help; ./axial bench runs it for each compiler.
#include <benchmark/benchmark.h>
#include <algorithm>
#include <bench/catalogue.hpp>
#include <cstdio>
#include <fstream>
#include <host_sim/tools/output/command_line.hpp>
#include <nlohmann/json.hpp>
#include <regex>

namespace {

struct Options {
  bool quick = false, list = false;
  std::string json, filter = ".*";
  int rounds() const { return quick ? 21 : 101; }
  int repetitions() const { return quick ? 1 : 5; }
};

// Google Benchmark runs the repetitions in random order; what we keep is in the duels.
class Progress : public benchmark::BenchmarkReporter {
 public:
  explicit Progress(std::size_t total) : total_(total) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    done_ += runs.size();
    const auto now = std::chrono::steady_clock::now();
    if (now < next_ && done_ < total_) return;
    next_ = now + std::chrono::seconds(5);
    std::fprintf(stderr, "timing: %zu of %zu\n", done_, total_);
  }

 private:
  std::size_t total_, done_ = 0;
  std::chrono::steady_clock::time_point next_{};
};

int disagreeing(std::vector<bench::Duel>& duels) {
  int count = 0;
  for (auto& duel : duels) {
    const double error = bench::disagreement(duel);
    if (error <= duel.tolerance) continue;
    std::fprintf(stderr, "%s: the peer's result differs from ours by %.2g, more than %.2g\n", duel.name().c_str(),
                 error, duel.tolerance);
    ++count;
  }
  return count;
}

void race(std::vector<bench::Duel>& duels, const Options& options) {
  const auto repetitions = std::to_string(options.repetitions());
  std::vector<std::string> arguments = {"bench", "--benchmark_enable_random_interleaving=true",
                                        "--benchmark_repetitions=" + repetitions};
  std::vector<char*> pointers;
  for (auto& argument : arguments)
    pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  for (auto& duel : duels) {
    bench::prepare(duel);
    benchmark::RegisterBenchmark(duel.name().c_str(),
                                 [&duel](benchmark::State& state) {
                                   for (auto _ : state)
                                     state.SetIterationTime(bench::round(duel));
                                 })
        ->UseManualTime()
        ->Iterations(options.rounds());
  }
  Progress progress(duels.size() * static_cast<std::size_t>(options.repetitions()));
  benchmark::RunSpecifiedBenchmarks(&progress);
}

// Of one evaluation: a neighbour on the machine only ever adds.
double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

nlohmann::json row_of(const bench::Duel& duel) {
  const auto ratio = bench::median_of(duel.ratios);
  return {{"robot", duel.robot},
          {"joints", duel.joints},
          {"algorithm", duel.algorithm},
          {"scalar", duel.scalar},
          {"peer", duel.peer},
          {"compiler", AXIAL_BENCH_COMPILER},
          {"ratio", ratio.value},
          {"ratio_low", ratio.low},
          {"ratio_high", ratio.high},
          {"rounds", duel.ratios.size()},
          {"ns_noise", least(duel.ours_ns)},
          {"peer_ns_noise", least(duel.peer_ns)}};
}

void print(const nlohmann::json& rows) {
  std::printf("%-28s %-11s %-7s %-17s %8s %18s %10s %10s\n", "algorithm", "robot", "scalar", "peer", "ratio",
              "95 % interval", "ns (noise)", "peer's ns");
  for (const auto& row : rows)
    std::printf("%-28s %-11s %-7s %-17s %8.2f %8.2f .. %6.2f %10.0f %10.0f\n",
                row["algorithm"].get<std::string>().c_str(), row["robot"].get<std::string>().c_str(),
                row["scalar"].get<std::string>().c_str(), row["peer"].get<std::string>().c_str(),
                row["ratio"].get<double>(), row["ratio_low"].get<double>(), row["ratio_high"].get<double>(),
                row["ns_noise"].get<double>(), row["peer_ns_noise"].get<double>());
}

int run(const Options& options) {
  auto duels = bench::all_duels();
  const std::regex wanted(options.filter);
  duels.erase(std::remove_if(duels.begin(), duels.end(),
                             [&](const auto& duel) { return !std::regex_search(duel.name(), wanted); }),
              duels.end());
  if (duels.empty()) throw std::runtime_error("no benchmark matches " + options.filter);
  if (options.list) {
    for (const auto& duel : duels)
      std::puts(duel.name().c_str());
    return 0;
  }
  std::fprintf(stderr, "comparing the results of %zu duels\n", duels.size());
  if (disagreeing(duels) > 0) return 1;
  race(duels, options);
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& duel : duels)
    rows.push_back(row_of(duel));
  print(rows);
  if (!options.json.empty()) {
    std::ofstream file(options.json);
    file << rows.dump(2) << '\n';
    if (!file.flush()) throw std::runtime_error("cannot write " + options.json);
  }
  return 0;
}

}  // namespace

int main(int count, char** values) {
  Options options;
  host_sim::CommandLine line("Races axial's kernels against Orocos KDL and DART.");
  line.flag("--quick", options.quick, "fewer rounds");
  line.flag("--list", options.list, "print the names and stop");
  line.option("--filter", options.filter,
              "only names (algorithm/robot/scalar/peer) that this regular expression finds");
  line.option("--json", options.json, "write the rows as an array of objects");
  return line.run(count, values, [&] { return run(options); });
}
