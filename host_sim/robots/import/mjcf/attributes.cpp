#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/import/mjcf/attributes.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace importer::mjcf {
namespace {

std::optional<double> number_of(const std::string& word) {
  const char *begin = word.data() + (word[0] == '+' ? 1 : 0), *end = word.data() + word.size();
  double value = 0.0;
  const auto read = std::from_chars(begin, end, value);
  // What is too small for a double is 0.
  if (read.ptr != end || (read.ec != std::errc{} && word.find("e-") == std::string::npos)) return std::nullopt;
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

const Element* Attributes::owner(const std::string& name) const {
  for (const auto* element : elements_)
    if (element->find(name) != nullptr) return element;
  return nullptr;
}
std::string Attributes::here() const {
  const auto* name = elements_[0]->find("name");
  return elements_[0]->place + ": " + elements_[0]->name + (name != nullptr ? " '" + *name + "'" : "");
}
void Attributes::refuse(const std::string& what, const std::string& remedy) const {
  throw description::Refused(here() + ": " + what + "; " + remedy);
}
std::string Attributes::word(const std::string& name, const std::string& otherwise) const {
  const auto* element = owner(name);
  return element != nullptr ? *element->find(name) : otherwise;
}
std::string Attributes::one_of(const std::string& name, const std::vector<std::string>& words) const {
  std::string given = word(name, words[0]);
  if (std::find(words.begin(), words.end(), given) == words.end())
    refuse(name + " is '" + given + "'", "give one of " + listed(words));
  return given;
}
bool Attributes::flag(const std::string& name, bool otherwise) const {
  return one_of(name, otherwise ? std::vector<std::string>{"true", "false"}
                                : std::vector<std::string>{"false", "true"}) == "true";
}
std::vector<double> Attributes::numbers(const std::string& name, std::size_t least, std::size_t most) const {
  const auto* element = owner(name);
  if (element == nullptr) return {};
  std::istringstream words(*element->find(name));
  std::vector<double> result;
  for (std::string next; words >> next;) {
    const auto value = number_of(next);
    if (!value)
      refuse(name + " is '" + *element->find(name) + "': '" + next + "' is no number",
             "give numbers as 1.5, with a point and spaces between");
    result.push_back(*value);
  }
  if (result.size() < least || result.size() > most)
    refuse(name + " is '" + *element->find(name) + "': " + std::to_string(result.size()) + " numbers",
           "give " + std::to_string(least) + (least == most ? "" : " to " + std::to_string(most)));
  return result;
}
double Attributes::number(const std::string& name, double otherwise) const {
  const auto found = numbers(name, 1, 1);
  return found.empty() ? otherwise : found[0];
}
void Attributes::allow(const std::string& words) const {
  for (const auto* element : elements_)
    for (const auto& entry : element->attributes)
      if ((" name class " + words + " ").find(" " + entry.first + " ") == std::string::npos)
        refuse("attribute " + entry.first + "='" + entry.second + "' is not known here, and may change the dynamics",
               "take it out if it does not, or mend its name");
}
std::string Attributes::only_one(const std::vector<std::string>& names) const {
  for (const auto* element : elements_) {
    std::vector<std::string> found;
    for (const auto& name : names)
      if (element->find(name) != nullptr) found.push_back(name);
    if (found.size() > 1) refuse(listed(found) + " are given together", "keep one of them");
    if (!found.empty()) return found[0];
  }
  return "";
}

bool is_actuator(const std::string& name) {
  static const std::vector<std::string> kinds{"general",  "motor",  "position", "velocity", "intvelocity", "damper",
                                              "cylinder", "muscle", "adhesion", "plugin",   "dcmotor"};
  return std::find(kinds.begin(), kinds.end(), name) != kinds.end();
}

Defaults::Defaults(const Element& root) {
  classes_["main"];
  for (const auto& section : root.children)
    if (section.name == "default") add(section, "", true);
}
void Defaults::add(const Element& element, const std::string& parent, bool top) {
  const auto* given = element.find("class");
  if (given == nullptr && !top)
    throw description::Refused(element.place + ": a nested <default> has no class; give class=\"...\"");
  if (!top && classes_.count(*given) != 0)
    throw description::Refused(element.place + ": class '" + *given +
                               "' is there already; give each class its own name");
  if (top && given != nullptr && *given != "main") classes_[*given].parent = "main";  // another name for it
  const std::string name = top ? "main" : *given;
  auto& own = classes_[name];
  own.parent = parent;
  for (const auto& child : element.children)
    if (child.name != "default") {
      auto& all = own.elements[is_actuator(child.name) ? "actuator" : child.name];
      all.insert(all.begin(), &child);
    }
  for (const auto& child : element.children)
    if (child.name == "default") add(child, name, false);
}
void Defaults::check(const Element& element, const std::string& name) const {
  if (classes_.count(name) == 0)
    throw description::Refused(element.place + ": class '" + name + "' is not there; add <default class=\"" + name +
                               "\"> or mend the name");
}
Attributes Defaults::of(const Element& element, const std::string& kind, const std::string& childclass) const {
  const auto* own = element.find("class");
  std::string name = own != nullptr ? *own : childclass.empty() ? "main" : childclass;
  check(element, name);
  std::vector<const Element*> elements{&element};
  for (; !name.empty(); name = classes_.at(name).parent) {
    const auto& of = classes_.at(name).elements;
    if (const auto found = of.find(kind); found != of.end())
      elements.insert(elements.end(), found->second.begin(), found->second.end());
  }
  return Attributes(elements);
}

}  // namespace importer::mjcf
