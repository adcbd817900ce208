// elastic: an arm behind harmonic drives follows its motion by the feed-forward of elastic joints, and by that of rigid
// ones with the same gains.
#include <host_sim/boards/on_board/provenance.hpp>
#include <host_sim/plants/loop/elastic.hpp>
#include <host_sim/plants/loop/verdicts.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

using namespace host_sim::loop;

constexpr int harmonic = 12;  // Hz, of the image
constexpr std::uint32_t most_places = 4;

struct Options {
  std::string robot = "puma560", board = "stm32f405", number = "float", output = "output/elastic", json, provenance;
  double seconds = 4.0;
  bool sweep = false, check = false;
};

struct ElasticRow {
  Row row;
  std::uint32_t count = 0;  ///< instructions of an answer at most, where a board counts
};

ElasticRow measured(const Options& options, const std::string& name, const Case& situation, bool on_board) {
  const auto who = on_board ? elastic_in_firmware(options.board, situation.robot)
                            : elastic_on_host(situation.robot, situation.resonance);
  ElasticRow result{{situation, on_board ? options.board : "host", options.number, name, {}, 0.0}, 0};
  result.row.tracking = follow(situation, *who, [&](const auto&, const auto&, const auto&, const link::Torque& answer) {
    result.count = std::max(result.count, answer.count);
  });
  if (!on_board) result.count = 0;
  return result;
}

/// The same situation by the feed-forward of elastic joints and of rigid ones.
void add_pair(std::vector<ElasticRow>& rows, const Options& options, const std::string& name, Case situation,
              bool on_board = false) {
  situation.as_rigid = false;
  auto elastic = measured(options, name, situation, on_board);
  situation.as_rigid = true;
  const auto rigid = measured(options, name, situation, on_board);
  elastic.row.ratio = rigid.row.tracking.tool_rms / elastic.row.tracking.tool_rms;
  rows.push_back(elastic);
  rows.push_back(rigid);
}

Case base_case(const Options& options) {
  Case c;
  c.robot = options.robot, c.seconds = options.seconds, c.resonance = harmonic;
  return c;
}

std::vector<ElasticRow> sweep(const Options& options) {
  std::vector<ElasticRow> rows;
  for (const int resonance : resonances()) {
    Case c = base_case(options);
    c.resonance = resonance;
    add_pair(rows, options, "stiffness", c);
  }
  Case soft = base_case(options), wrong = soft, damped = soft, coarse = soft, late = soft;
  soft.stiffness_error = -0.1, wrong.parameter_error = 0.02, damped.damping_ratio = 0.05, coarse.encoder_bits = 16;
  late.delay = 1;
  add_pair(rows, options, "springs 10 % softer than believed", soft);
  add_pair(rows, options, "parameters 2 % off", wrong);
  add_pair(rows, options, "transmissions damped by 5 %", damped);
  add_pair(rows, options, "encoders of 16 bits", coarse);
  add_pair(rows, options, "torques 1 ms late", late);
  return rows;
}

void print(const std::vector<ElasticRow>& rows) {
  host_sim::Table table({"situation", "resonance, Hz", "torques by", "feed-forward", "tool RMS, um", "largest, um",
                         "rigid / elastic", "instructions"});
  for (const auto& [r, count] : rows)
    table.add({r.name, std::to_string(r.situation.resonance), r.board, r.situation.as_rigid ? "rigid" : "elastic",
               host_sim::significant(1e6 * r.tracking.tool_rms, 3),
               host_sim::significant(1e6 * r.tracking.tool_largest, 3),
               r.ratio > 0.0 ? host_sim::significant(r.ratio, 3) : "", count > 0 ? std::to_string(count) : ""});
  std::printf("%s", table.text().c_str());
}

nlohmann::json to_json(const std::vector<ElasticRow>& rows) {
  std::vector<Row> plain;
  for (const auto& r : rows)
    plain.push_back(r.row);
  nlohmann::json list = host_sim::loop::to_json(plain);
  for (std::size_t i = 0; i < rows.size(); ++i)
    list[i]["count_most"] = rows[i].count;
  return list;
}

int measure(const Options& options) {
  host_sim::make_folder(options.output);
  std::vector<ElasticRow> rows;
  add_pair(rows, options, "harmonic drives", base_case(options), true);
  if (options.sweep) {
    const auto more = sweep(options);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  print(rows);
  if (!options.provenance.empty()) host_sim::write_json(options.provenance, host_sim::provenance());
  const std::string data = options.output + "/elastic-" + options.robot + ".json";
  for (const std::string& path : {data, options.json})
    if (!path.empty()) host_sim::write_json(path, to_json(rows));
  std::printf("\ndata  %s\n", data.c_str());
  host_sim::Verdict verdict("elastic");
  for (const auto& r : rows)
    expect_elastic(verdict, r.row);
  return verdict.status();
}

int check(const Options& options) {
  const auto board = elastic_in_firmware(options.board, options.robot), host = elastic_on_host(options.robot, harmonic);
  Both both(*board, *host);
  const auto tracking = follow(base_case(options), both);
  std::printf("%s on %s: %u to %u instructions, tool error %.3g um; board and host differ by %u last places at most\n",
              options.robot.c_str(), options.board.c_str(), both.least, both.most, 1e6 * tracking.tool_rms, both.worst);
  return both.worst <= most_places && tracking.refused == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  host_sim::CommandLine line("an arm with elastic joints follows its motion", "elastic");
  line.option("--robot", options.robot, "scara or puma560").show_default();
  line.option("--board", options.board, "folder of hal/boards").one_of({"stm32f405"}).show_default();
  line.option("--number", options.number, "what the controller computes in").one_of({"float"}).show_default();
  line.option("--seconds", options.seconds, "of motion").show_default().range(0.001, 3600.0);
  line.flag("--sweep", options.sweep, "besides, other stiffnesses and wrong models, on the host");
  line.flag("--check", options.check, "only hold the image to the same source on the host");
  line.option("--output", options.output, "folder of JSON").show_default();
  line.option("--json", options.json, "one more copy of the figures");
  line.option("--provenance", options.provenance, "file for compilers, flags and commit");
  return line.run(count, arguments, [&] { return options.check ? check(options) : measure(options); });
}
