#include <algorithm>
#include <cases/case_file.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <oracle/compare.hpp>
#include <oracle/convert.hpp>

namespace cases {
namespace {

using json = nlohmann::json;

const std::filesystem::path data_folder = AXIAL_TEST_DATA;

json read(const std::string& name) {
  std::ifstream file(data_folder / (name + ".json"));
  if (!file) throw std::runtime_error("no such case file: " + name);
  return json::parse(file);
}

/// A number, or the decimal digits of one, as the exact double that the file means.
double number(const json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

oracle::Vec3<quad> vec3(const json& v) { return {number(v[0]), number(v[1]), number(v[2])}; }

oracle::Pose<quad> pose(const json& rows) {
  const auto column = [&](std::size_t j) {
    return oracle::Vec3<quad>{number(rows[0][j]), number(rows[1][j]), number(rows[2][j])};
  };
  return {{column(0), column(1), column(2)}, column(3)};
}

oracle::Mat3<quad> inertia(const json& v) {
  return oracle::symmetric<quad>(number(v[0]), number(v[1]), number(v[2]), number(v[3]), number(v[4]), number(v[5]));
}

/// Friction is given on the motor side: viscous times gear^2, Coulomb times |gear| on the joint side.
void set_drive(oracle::Link<quad>& link, const json& row) {
  const quad gear = number(row.at("gear"));
  link.rotor_inertia = number(row.at("rotor_inertia")), link.gear = gear;
  link.viscous = gear * gear * quad(number(row.at("viscous")));
  link.coulomb_forward = oracle::abs(gear) * quad(number(row.at("coulomb")[0]));
  link.coulomb_backward = oracle::abs(gear) * quad(number(row.at("coulomb")[1]));
}

oracle::Link<quad> link(const json& row, int parent) {
  oracle::Link<quad> result;
  result.type = row.at("type") == "P" ? oracle::Joint::prismatic : oracle::Joint::revolute;
  result.parent = parent;
  result.alpha = number(row.at("alpha")), result.a = number(row.at("a"));
  result.d = number(row.at("d")), result.theta = number(row.at("theta"));
  result.mass = number(row.at("m")), result.com = vec3(row.at("com")), result.inertia = inertia(row.at("I_com"));
  set_drive(result, row);
  return result;
}

oracle::Chain<quad> chain(const json& source) {
  oracle::Chain<quad> result;
  for (const json& row : source.at("links"))
    result.links.push_back(link(row, result.size() - 1));
  result.gravity = vec3(source.at("gravity"));
  if (source.contains("base")) result.base = pose(source["base"]);
  if (source.contains("tool")) result.tool = pose(source["tool"]);
  return result;
}

oracle::Vector<double> numbers(const json& source, const char* key, std::size_t count) {
  if (!source.contains(key)) return oracle::Vector<double>(count, 0.0);
  oracle::Vector<double> result;
  for (const json& value : source[key])
    result.push_back(number(value));
  return result;
}

/// Elements of nested arrays in order; digits are read in quad.
void flatten(const json& value, Values& result) {
  if (value.is_array()) {
    for (const json& inner : value)
      flatten(inner, result);
  } else {
    result.push_back(value.is_string() ? oracle::parse(value.get<std::string>()) : quad(value.get<double>()));
  }
}

std::map<std::string, Values> quantities(const json& source) {
  std::map<std::string, Values> result;
  for (const auto& [key, value] : source.items())
    flatten(value, result[key]);
  return result;
}

State state(const json& source, std::size_t joints) {
  State result;
  result.id = source.at("id");
  result.q = numbers(source, "q", joints), result.qd = numbers(source, "qd", joints);
  result.qdd = numbers(source, "qdd", joints);
  if (source.contains("tau_in")) result.tau = numbers(source, "tau_in", joints);
  result.load.friction = source.value("friction", false);
  const auto wrench = oracle::convert<quad>(numbers(source, "wrench_tip", 6));
  result.load.tip = {{wrench[0], wrench[1], wrench[2]}, {wrench[3], wrench[4], wrench[5]}};
  if (source.contains("gravity")) result.gravity = vec3(source["gravity"]);
  result.expect = quantities(source.at("expect")), result.reference = quantities(source.at("ref"));
  const json& tolerance = source.at("tol");
  for (const auto& entry : result.expect)
    result.tolerance[entry.first] = (tolerance.is_object() ? tolerance.at(entry.first) : tolerance).get<double>();
  return result;
}

}  // namespace

const State& CaseFile::state(const std::string& id) const {
  for (const State& state : states)
    if (state.id == id) return state;
  throw std::out_of_range("no such state: " + id);
}

oracle::Chain<quad> CaseFile::chain_at(const State& state) const {
  oracle::Chain<quad> result = chain;
  if (state.gravity) result.gravity = *state.gravity;
  return result;
}

double CaseFile::scale(const std::string& quantity) const {
  double result = 0.0;
  for (const State& state : states)
    for (const auto* figures : {&state.reference, &state.expect})
      if (const auto found = figures->find(quantity); found != figures->end())
        result = std::max(result, oracle::largest(found->second));
  return result > 0.0 ? result : 1.0;
}

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".json" && read(name).value("schema", "") == "mdh-case/1") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

CaseFile load_case(const std::string& name) {
  const json source = read(name);
  CaseFile file;
  file.name = name, file.chain = chain(source);
  for (const json& entry : source.at("cases"))
    file.states.push_back(state(entry, file.chain.links.size()));
  return file;
}

std::vector<StiffScenario> load_stiff_scenarios() {
  std::vector<StiffScenario> result;
  const json file = read("stiff_scenarios");
  for (const json& source : file.at("scenarios")) {
    StiffScenario scenario;
    scenario.name = source.at("name");
    scenario.chain = oracle::convert<double>(chain(source));
    const std::size_t joints = scenario.chain.links.size();
    scenario.q = numbers(source, "q", joints), scenario.qd = numbers(source, "qd", joints);
    scenario.tau = numbers(source, "tau", joints);
    if (source.contains("qdd_ref")) flatten(source["qdd_ref"], scenario.qdd);
    result.push_back(scenario);
  }
  return result;
}

std::vector<PrintedFigures> load_misprint() {
  std::vector<PrintedFigures> result;
  const json file = read("scara_djuric_rrp");
  for (const json& row : file.at("negative_control_printed_eq82"))
    result.push_back({row.at("id"), number(row.at("a11_printed")), number(row.at("tau1_printed"))});
  return result;
}

}  // namespace cases
