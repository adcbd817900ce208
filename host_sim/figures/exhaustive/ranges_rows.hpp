// Rows of `./axial exhaustive --ranges`.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace exhaustive {

using nlohmann::ordered_json;

struct Options {
  std::uint64_t states = 1000000, seed = 1;
  unsigned processes = 2;
  std::string robot = "all", commit;
  bool overflows_only = false;
};

/// Adds the overflows of a robot's kernels, and unless options say otherwise its errors and bounds; `holds` becomes
/// false where one is not as certified. A specialisation per robot, each in a source of its own.
template <class R>
void add_rows(const Options& options, ordered_json& rows, bool& holds);

}  // namespace exhaustive
