// Writes the scripts that Gappa checks, and what they are about.
#include <host_sim/figures/prove/arm.hpp>
#include <host_sim/figures/prove/primitives.hpp>
#include <host_sim/figures/prove/step.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>

#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <nlohmann/json.hpp>

#include <fstream>
#include <functional>

namespace {

using prove::Goal;

struct Subject {
  std::string name;  ///< on the command line and in rows
  std::string part;  ///< of the name of its files
  std::function<prove::Statement()> statement;
  std::vector<double> ours;  ///< where that is not the bound to prove
};

template <class Robot, class Algorithm, class Run>
Subject arm(const std::string& name, Algorithm algorithm, Run run) {
  return {name, name, [=] { return prove::efforts_statement<Robot>(axial::error_bound<Robot>(algorithm), run); }, {}};
}

template <class Robot>
Subject newton_euler(const std::string& name) {
  return arm<Robot>(name, axial::algorithm::inverse_dynamics, [](const auto& q, const auto& qd, const auto& qdd) {
    return axial::inverse_dynamics<Robot>(q, qd, qdd);
  });
}

/// A joint's step, result by result: what one needs is not always what another one needs.
template <class Robot, int J>
void add_step(std::vector<Subject>& all, const std::string& name) {
  const prove::Statement whole = prove::step_statement<Robot, J>();
  for (std::size_t i = 0; i < whole.results.size(); ++i) {
    prove::Statement one = whole;
    one.results = {whole.results[i]};
    one.results[0].bound *= prove::boxes;
    all.push_back({name, name + "-" + std::to_string(i), [=] { return one; }, {whole.results[i].bound}});
  }
}

std::vector<Subject> subjects() {
  using robots::Scara;
  std::vector<Subject> all;
  for (const prove::Wave wave : {prove::Wave::sine, prove::Wave::cosine})
    for (const prove::Arc& arc : prove::arcs()) {
      const std::string name = wave == prove::Wave::sine ? "sine" : "cosine";
      all.push_back({name,
                     name + "-" + std::to_string(arc.first),
                     [=] { return prove::wave_statement(wave, arc); },
                     {axial::integer::sincos_error}});
    }
  for (const prove::Arc& range : prove::mantissas())
    all.push_back({"reciprocal",
                   "reciprocal-" + std::to_string(range.first),
                   [=] { return prove::reciprocal_statement(range); },
                   {}});
  all.push_back(arm<Scara>("scara_closed_form", axial::algorithm::closed_form,
                           [](const auto& q, const auto& qd, const auto& qdd) {
                             return axial::closed_form::scara_torque<Scara>(q, qd, qdd);
                           }));
  all.push_back(newton_euler<Scara>("scara_inverse_dynamics"));
  add_step<robots::Puma560, 2>(all, "puma560_joint3_step");
  all.push_back(newton_euler<robots::Puma560>("puma560_inverse_dynamics"));
  return all;
}

void write_script(const std::string& folder, const Subject& subject, const char* kind, const prove::Statement& s,
                  Goal goal) {
  std::ofstream file(folder + "/" + subject.part + "." + kind + ".g");
  file << prove::script_of(s, goal);
  if (!file.flush()) throw std::runtime_error("cannot write into " + folder);
}

nlohmann::ordered_json write_subject(const std::string& folder, const Subject& subject) {
  const prove::Statement s = subject.statement();
  write_script(folder, subject, "errors", s, Goal::errors);
  write_script(folder, subject, "words", s, Goal::words);
  write_script(folder, subject, "ask", s, Goal::ask);
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < s.results.size(); ++i)
    results.push_back({{"name", s.results[i].name},
                       {"bound", s.results[i].bound},
                       {"ours", subject.ours.empty() ? s.results[i].bound : subject.ours[i]}});
  return {{"subject", subject.name}, {"part", subject.part}, {"split", !s.split.empty()}, {"results", results}};
}

int write_all(const std::string& folder, const std::string& only) {
  nlohmann::ordered_json index = nlohmann::ordered_json::array();
  host_sim::make_folder(folder);
  for (const Subject& subject : subjects())
    if (only.empty() || subject.name == only) index.push_back(write_subject(folder, subject));
  if (index.empty()) throw std::runtime_error("no subject is called " + only);
  host_sim::write_json(folder + "/index.json", index);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  host_sim::CommandLine line("writes kernels as scripts of Gappa", "prove_scripts");
  std::string folder, only;
  line.option("--output", folder).required();
  line.option("--subject", only, "one subject; default all");
  return line.run(argc, argv, [&] { return write_all(folder, only); });
}
