// observers: the image whose feedback comes from an extended Kalman filter, beside the tracking image, which
// differences encoders.
#include <host_sim/plants/loop/verdicts.hpp>
#include <host_sim/plants/simulation/models.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace {

using namespace host_sim::loop;

constexpr int drawn_ticks = 1500;

struct Options {
  std::string robot = "puma560", board = "stm32f405", number = "float", output = "output/ekf", json;
  double seconds = 4.0;
  bool sweep = false, check = false;
};

/// Encoders of 14 bits that err by one of their counts.
Case noisy(const Options& options) {
  Case c;
  c.robot = options.robot, c.seconds = options.seconds, c.encoder_bits = 14, c.encoder_noise = 1.0;
  return c;
}

/// The image in QEMU drives; the same source on the host, told the same, says what the filter thinks.
class Watched : public Observer {
  std::unique_ptr<Controller> board_;
  std::unique_ptr<Observer> host_;

 public:
  explicit Watched(const Options& o)
      : board_(observer_in_firmware(o.board, o.robot)), host_(observer_on_host(o.robot)), both(*board_, *host_) {}
  link::Torque answer(const link::Measurement& measurement, const link::SetPoint& wanted) override {
    return both.answer(measurement, wanted);
  }
  std::vector<double> velocity() const override { return host_->velocity(); }

  Both both;
};

int judged(const Options& options, const Both& both, const VelocityErrors& errors) {
  std::printf(
      "%u to %u instructions; board and host differ by %u last places at most; velocities are at least %.1f times as "
      "exact as differences of a tick\n",
      both.least, both.most, both.worst, least_ratio(errors));
  host_sim::Verdict verdict("observers");
  verdict.expect(both.worst == 0, "image and host differ");
  expect_filter(verdict, errors, both.most,
                host_sim::simulation::shares_drives(options.robot) ? filter_ratio_of_drives : filter_ratio);
  return verdict.status();
}

int check(const Options& options) {
  Watched watched(options);
  const auto errors = observe(noisy(options), watched);
  return judged(options, watched.both, errors);
}

ObserverRow on_host_row(const std::string& controller, const std::string& name, const Case& situation) {
  const std::unique_ptr<Controller> who =
      controller == "ekf" ? observer_on_host(situation.robot) : on_host(situation.robot, "float");
  return {situation, controller, "host", name, observe(situation, *who), 0};
}

std::vector<ObserverRow> sweep(const Options& options) {
  const Case base = noisy(options);
  Case wrong = base, rough = base, coarse = base, fine = base;
  wrong.parameter_error = 0.05, wrong.seed = 3, rough.friction = true;
  coarse.encoder_bits = 12, fine.encoder_bits = 20, fine.encoder_noise = 0.0;
  std::vector<ObserverRow> rows;
  for (const char* controller : {"ekf", "pd"}) {
    rows.push_back(on_host_row(controller, "12 bits, a count of noise", coarse));
    rows.push_back(on_host_row(controller, "20 bits, no noise", fine));
    rows.push_back(on_host_row(controller, "14 bits, a count of noise, parameters 5 % off", wrong));
    if (declares_friction(options.robot))
      rows.push_back(on_host_row(controller, "14 bits, a count of noise, friction that the model lacks", rough));
  }
  return rows;
}

std::string largest(const std::vector<double>& errors) {
  return errors.empty() ? "" : host_sim::significant(1e3 * *std::max_element(errors.begin(), errors.end()), 3);
}

void print(const std::vector<ObserverRow>& rows) {
  host_sim::Table table({"encoders", "torques by", "loop", "velocity RMS, mrad/s: filter", "difference", "of ten ticks",
                         "torque change / limit", "tool RMS, um"});
  for (const ObserverRow& r : rows)
    table.add({r.name, r.board, r.controller, largest(r.errors.filter), largest(r.errors.difference),
               largest(r.errors.slow), host_sim::significant(r.errors.chatter, 2),
               host_sim::significant(1e6 * r.errors.tracking.tool_rms, 3)});
  std::printf("%s", table.text().c_str());
}

int measure(const Options& options) {
  host_sim::make_folder(options.output);
  const std::string stem = options.output + "/ekf-" + options.robot;
  const Case situation = noisy(options);
  Watched watched(options);
  std::vector<ObserverRow> rows;
  {
    host_sim::CsvFile file(stem + ".csv", {"time", "joint", "true", "filter", "difference", "ten"});
    int ticks = 0;
    const VelocityWatch draw = [&](double time, const auto& real, const auto& filter, const auto& one,
                                   const auto& ten) {
      if (++ticks > drawn_ticks) return;
      for (std::size_t i = 0; i < real.size(); ++i) {
        file.cell(time), file.cell(std::to_string(i + 1));
        for (const auto* velocity : {&real, &filter, &one, &ten})
          file.cell((*velocity)[i], 6);
        file.end_row();
      }
    };
    const std::string name = "14 bits, a count of noise";
    rows.push_back({situation, "ekf", options.board, name, observe(situation, watched, draw), watched.both.most});
    rows.push_back({situation, "pd", options.board, name,
                    observe(situation, *in_firmware(options.board, options.robot, "float")), 0});
  }
  if (options.sweep) {
    const auto more = sweep(options);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  print(rows);
  for (const std::string& path : {stem + ".json", options.json})
    if (!path.empty()) host_sim::write_json(path, to_json(rows));
  host_sim::run_plot("observers.py", {stem + ".csv", stem + ".json"});
  std::printf("\npicture  %s.png\ndata     %s.csv, %s.json\n", stem.c_str(), stem.c_str(), stem.c_str());
  return judged(options, watched.both, rows[0].errors);
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  host_sim::CommandLine line("a loop around an extended Kalman filter", "observers");
  line.option("--robot", options.robot, "scara, puma560 or wrist_arm").show_default();
  line.option("--board", options.board, "folder of hal/boards").one_of({"stm32f405"}).show_default();
  line.option("--number", options.number, "what the filter computes in").one_of({"float"}).show_default();
  line.option("--seconds", options.seconds, "of motion").show_default().range(0.2, 3600.0);
  line.flag("--sweep", options.sweep, "besides, other encoders and wrong models, on the host");
  line.flag("--check", options.check,
            "only hold the image to the same source on the host, and its velocities to differences");
  line.option("--output", options.output, "folder of CSV, JSON and picture").show_default();
  line.option("--json", options.json, "one more copy of the figures");
  return line.run(count, arguments, [&] { return options.check ? check(options) : measure(options); });
}
