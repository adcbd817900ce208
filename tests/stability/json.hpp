// Rows as objects with the fields that every row of ./axial stability has; numbers that are none become null.
#pragma once

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace stability {

using Json = nlohmann::ordered_json;

inline Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

/// What a cell of a table shows.
inline std::string cell(double x) {
  char text[16];
  std::snprintf(text, sizeof text, std::isfinite(x) ? "%.1e" : "-", x);
  return text;
}

inline void write(const std::string& file, const Json& rows) {
  std::ofstream stream(file);
  stream << rows.dump(1) << '\n';
  if (!stream.flush()) throw std::runtime_error("cannot write " + file);
}

}  // namespace stability
