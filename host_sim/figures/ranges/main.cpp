// Prints the bounds, formats and certified errors of fixed point.
#include <host_sim/figures/ranges/rows.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>
#include <host_sim/tools/output/table.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace {

using host_sim::significant;
using ranges::Choice;
using ranges::Row;

void print(const std::string& robot, const Choice& choice, const std::vector<Row>& rows) {
  std::printf("%s, %s: %d bits, rounded %s, %s; |quantity| <= bound, kept as an integer times 2^-exponent\n",
              robot.c_str(), choice.algorithm.c_str(), choice.word, choice.nearest ? "to nearest" : "down",
              choice.high_word ? "upper words of products" : "exact products");
  host_sim::Table table({"link", "quantity", "bound", "unit", "exponent", "resolution", "halvings", "certified error"});
  for (const Row& row : rows)
    table.add({std::to_string(row.link), row.quantity, significant(row.bound, 4), row.unit,
               std::to_string(row.exponent), significant(row.resolution()), std::to_string(row.halvings),
               row.error ? significant(*row.error) : ""});
  std::fputs((table.text() + "\n").c_str(), stdout);
}

nlohmann::ordered_json object(const Row& row, const Choice& choice) {
  return {{"robot", row.robot},
          {"algorithm", choice.algorithm},
          {"word", choice.word},
          {"rounding", choice.nearest ? "nearest" : "down"},
          {"multiply", choice.high_word ? "high_word" : "exact"},
          {"link", row.link},
          {"quantity", row.quantity},
          {"unit", row.unit},
          {"bound", row.bound},
          {"exponent", row.exponent},
          {"halvings", row.halvings},
          {"error", row.error ? nlohmann::ordered_json(*row.error) : nlohmann::ordered_json()}};
}

void run(const std::string& robot, const Choice& choice, const std::string& json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  auto robots = robot.empty() ? ranges::robots(choice.algorithm) : std::vector<std::string>{robot};
  if (robots.empty()) robots = ranges::robots();  // an algorithm that no robot knows: rows() names those that there are
  for (const std::string& name : robots) {
    const auto rows = ranges::rows(name, choice);
    print(name, choice, rows);
    for (const Row& row : rows)
      all.push_back(object(row, choice));
  }
  if (!json.empty()) host_sim::write_json(json, all);
}

}  // namespace

int main(int argc, char** argv) {
  host_sim::CommandLine line("bounds, formats and certified errors of fixed point", "ranges");
  Choice choice;
  std::string robot, json, rounding = "nearest", multiply = "exact";
  line.option("--robot", robot);
  line.option("--algorithm", choice.algorithm);
  line.option("--word", choice.word).one_of({"16", "32"});
  line.option("--rounding", rounding).one_of({"nearest", "down"});
  line.option("--multiply", multiply).one_of({"exact", "high_word"});
  line.option("--json", json);
  return line.run(argc, argv, [&] {
    choice.nearest = rounding == "nearest", choice.high_word = multiply == "high_word";
    run(robot, choice, json);
    return 0;
  });
}
