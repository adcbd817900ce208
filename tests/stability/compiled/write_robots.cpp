// Writes every scenario of 12 joints and fewer as a robot that the compiler knows: sources robots_1.cpp ... of a
// folder.
#include <cases/scenarios.hpp>
#include <cases/to_axial.hpp>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace {

constexpr int most_joints = 12;

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}
template <class... X>
std::string call(const char* name, const X&... x) {
  std::string arguments;
  ((arguments += (arguments.empty() ? "" : ", ") + number(x)), ...);
  return std::string(".") + name + "(" + arguments + ")";
}
std::string turn(const std::string& name, double radians) {
  int quarters = 0;
  if (oracle::is_right_angle(radians, quarters))
    return quarters == 0 ? "" : call((name + "_deg").c_str(), 90.0 * quarters);
  return call(name.c_str(), radians);
}

std::string link(const oracle::Link<double>& l, int index) {
  if (l.parent != index - 1 || l.gamma != 0.0 || l.b != 0.0) throw std::invalid_argument("no tree is written here");
  const axial::LinkParameters p = cases::to_axial(l);
  std::string text = l.type == oracle::Joint::revolute ? "axial::revolute()" : "axial::prismatic()";
  text += turn("alpha", l.alpha) + turn("theta", l.theta);
  if (l.a != 0.0) text += call("a", l.a);
  if (l.d != 0.0) text += call("d", l.d);
  if (l.rotor_inertia > 0.0) text += call("rotor_inertia", l.rotor_inertia, l.gear);
  const double(&j)[6] = p.inertia_com;
  if (l.mass > 0.0)
    text += call("mass", l.mass) + call("com", l.com.x, l.com.y, l.com.z) +
            call("inertia_com", j[0], j[1], j[2], j[3], j[4], j[5]);
  return text;
}

std::string robot(const std::string& name, const oracle::Chain<double>& chain) {
  const auto& g = chain.gravity;
  std::string text =
      "struct " + name + " {\n  static constexpr auto chain = axial::chain(axial::accept(axial::as_published), ";
  text += "axial::gravity(" + number(g.x) + ", " + number(g.y) + ", " + number(g.z) + ")";
  for (int i = 0; i < chain.size(); ++i)
    text += ",\n      " + link(chain[i], i);
  return text + ");\n};\n";
}

// Scenarios are dealt out, so that the long ones are not all in one source.
void write(int part, int parts, const std::string& folder) {
  std::ostringstream robots, entries;
  int index = 0;
  for (const auto& scenario : cases::scenarios()) {
    if (scenario.size() > most_joints || ++index % parts != part - 1) continue;
    const std::string name = "Scenario" + std::to_string(index);
    robots << robot(name, scenario.chain);
    entries << "  if (name == \"" << scenario.name << "\") return compiled<" << name << ">;\n";
  }
  std::ofstream file(folder + "/robots_" + std::to_string(part) + ".cpp");
  file << "#include <stability/compiled/row.hpp>\n\nnamespace {\n"
       << robots.str() << "}  // namespace\n\nnamespace stability {\ntemplate <>\nCompiled compiled_robot<" << part
       << ">(const std::string& name) {\n"
       << entries.str() << "  return {};\n}\n}  // namespace stability\n";
  if (!file.flush()) throw std::runtime_error("cannot write to " + folder);
}

}  // namespace

int main(int count, char** values) try {
  if (count != 3) throw std::invalid_argument("usage: stability_write_robots PARTS FOLDER");
  const int parts = std::stoi(values[1]);
  for (int part = 1; part <= parts; ++part)
    write(part, parts, values[2]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
