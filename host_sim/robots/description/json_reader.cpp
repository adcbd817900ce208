#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/description/json_reader.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace description {
namespace {

constexpr int deepest = 8;

/// Told of every key while a text is parsed: keys of the objects that are open.
class KeyWatch {
 public:
  explicit KeyWatch(const std::string& from) : from_(from) {}

  bool operator()(int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > deepest) throw Refused(from_ + ": nested too deeply; see ./axial import --help for the format");
    if (event == Event::object_start) open_.emplace_back();
    if (event == Event::object_end) open_.pop_back();
    if (event == Event::key && !open_.back().insert(parsed.get<std::string>()).second)
      throw Refused(from_ + ": the key \"" + parsed.get<std::string>() + "\" stands twice in one object; keep one");
    return true;
  }

 private:
  const std::string& from_;
  std::vector<std::set<std::string>> open_;
};

std::string shown(const nlohmann::json& value) {
  const std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

nlohmann::json parse_json(const std::string& text, const std::string& from) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw Refused(from + ": the file is empty");
  try {
    return nlohmann::json::parse(text, KeyWatch(from));
  } catch (const nlohmann::json::exception& error) {
    std::string what = error.what();
    what.erase(0, what.find(']') == std::string::npos ? 0 : what.find(']') + 2);
    throw Refused(from + ": not JSON: " + what + "; numbers are written as 1.5, neither 1,5 nor nan");
  }
}

JsonObject::JsonObject(const nlohmann::json& value, std::string place) : value_(value), place_(std::move(place)) {
  if (!value.is_object()) refuse("is " + shown(value), "give an object: {\"key\": value, ...}");
}

void JsonObject::refuse(const std::string& what, const std::string& remedy) const {
  throw Refused(place_ + ": " + what + "; " + remedy);
}

void JsonObject::allow(const std::vector<std::string>& keys) const {
  for (const auto& item : value_.items())
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
      refuse("the key \"" + item.key() + "\" is not known", "there are " + joined(keys));
}

std::string JsonObject::text(const std::string& key, const std::string& otherwise) const {
  if (!has(key)) return otherwise;
  if (!value_[key].is_string()) refuse(key + " is " + shown(value_[key]), "give a text in quotation marks");
  return value_[key].get<std::string>();
}

std::vector<std::string> JsonObject::texts(const std::string& key) const {
  std::vector<std::string> result;
  if (!has(key)) return result;
  if (!value_[key].is_array()) refuse(key + " is " + shown(value_[key]), "give a list of texts");
  for (const auto& entry : value_[key]) {
    if (!entry.is_string()) refuse(key + " has " + shown(entry), "give a list of texts");
    result.push_back(entry.get<std::string>());
  }
  return result;
}

double JsonObject::finite(const nlohmann::json& value, const std::string& key) const {
  if (!value.is_number()) refuse(key + " is " + shown(value), "give a number");
  const auto number = value.get<double>();
  if (!std::isfinite(number)) refuse(key + " is not finite", "give a number that a double holds");
  return number;
}

double JsonObject::number(const std::string& key, double otherwise) const {
  return has(key) ? finite(value_[key], key) : otherwise;
}

std::vector<double> JsonObject::numbers(const std::string& key, const std::vector<std::size_t>& sizes) const {
  std::vector<double> result;
  if (!has(key)) return result;
  const auto& list = value_[key];
  if (!list.is_array() || std::find(sizes.begin(), sizes.end(), list.size()) == sizes.end()) {
    std::vector<std::string> counts;
    for (const auto size : sizes)
      counts.push_back(std::to_string(size));
    refuse(key + " is " + shown(list), "give a list of so many numbers: " + joined(counts));
  }
  for (const auto& entry : list)
    result.push_back(finite(entry, key));
  return result;
}

axial::Angle JsonObject::angle(const std::string& key) const {
  const std::string degrees = key + "_deg";
  if (has(key) && has(degrees)) refuse("both " + key + " and " + degrees + " are given", "keep one");
  if (!has(degrees)) {
    constexpr double turn = 6.2831853071796;
    if (std::abs(number(key, 0.0)) > turn)
      refuse(key + " is " + shown(value_[key]) + " rad, more than a turn", "give radians, or degrees as " + degrees);
    return canonical_angle(number(key, 0.0));
  }
  const double value = number(degrees, 0.0);
  if (std::abs(value) > 360.0) refuse(degrees + " is " + shown(value_[degrees]), "give -360 to 360 degrees");
  return axial::Angle::from_degrees(value);
}

}  // namespace description
