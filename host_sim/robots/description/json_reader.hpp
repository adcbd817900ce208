// Strict reading of JSON objects: every key known, every number finite, every error with its place.
#pragma once

#include <host_sim/robots/description/description.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace description {

/// Parses a JSON text. Throws Refused where it is malformed, nested deeper than 8, or has a key twice.
nlohmann::json parse_json(const std::string& text, const std::string& from);

/// An object of a file, and what to call it in messages. All members throw Refused.
class JsonObject {
 public:
  JsonObject(const nlohmann::json& value, std::string place);

  /// Refuses keys that are not among these.
  void allow(const std::vector<std::string>& keys) const;
  bool has(const std::string& key) const { return value_.contains(key); }
  std::string text(const std::string& key, const std::string& otherwise) const;
  std::vector<std::string> texts(const std::string& key) const;
  double number(const std::string& key, double otherwise) const;
  /// A list of numbers whose length is one of `sizes`; empty where the key is missing.
  std::vector<double> numbers(const std::string& key, const std::vector<std::size_t>& sizes) const;
  /// `key` in radians or `key`_deg in degrees, 0 where both are missing; both are refused.
  axial::Angle angle(const std::string& key) const;
  const nlohmann::json& member(const std::string& key) const { return value_.at(key); }
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const;

 private:
  double finite(const nlohmann::json& value, const std::string& key) const;

  const nlohmann::json& value_;
  std::string place_;
};

}  // namespace description
