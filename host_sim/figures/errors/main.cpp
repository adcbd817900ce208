// Writes the errors of the kernels as JSON on standard output.
#include <host_sim/figures/errors/errors.hpp>
#include <host_sim/tools/output/command_line.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace {

nlohmann::ordered_json to_json(const std::vector<errors::Row>& rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const errors::Row& row : rows) {
    const errors::Kernel& kernel = row.kernel;
    nlohmann::ordered_json object{
        {"robot", kernel.robot},     {"scene", kernel.scene},      {"algorithm", kernel.algorithm},
        {"variant", kernel.variant}, {"scalar", kernel.scalar},    {"states", row.states},
        {"error", row.error},        {"error_rms", row.error_rms}, {"joints", row.joints}};
    if (row.error_torque) object["error_torque"] = *row.error_torque;
    if (row.certified) object["error_certified"] = *row.certified;
    for (const errors::Block& block : row.blocks)
      object["blocks"][block.name] = {{"error", block.error},
                                      {"error_in_state", block.error_in_state},
                                      {"error_in_most_states", block.error_in_most_states},
                                      {"error_uncancelled", block.error_uncancelled}};
    all.push_back(object);
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  host_sim::CommandLine line("errors of every algorithm in every number system", "errors");
  errors::Choice choice;
  line.option("--robot", choice.robot, "only this robot");
  line.option("--algorithm", choice.algorithm, "only this algorithm, by its name in firmware/apps/size/matrix.txt");
  line.option("--scalar", choice.scalar, "only this number system");
  return line.run(argc, argv, [&] {
    std::printf("%s\n", to_json(errors::rows(choice)).dump(1).c_str());
    return 0;
  });
}
