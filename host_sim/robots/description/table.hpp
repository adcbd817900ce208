// A robot as a table of Denavit-Hartenberg rows in a small JSON file (README.md), classical or modified.
#pragma once

#include <host_sim/robots/description/description.hpp>

#include <string>

namespace description {

/// The rows as the file has them: lengths, angles, bodies and poses in the frames of the file's own convention.
struct Table {
  bool classical = false;  ///< Rz(theta) Tz(d) Tx(a) Rx(alpha); else modified: Rx(alpha) Tx(a) Rz(theta) Tz(d)
  Description robot;
};

/// Throws Refused with file, link, value and remedy.
Table read_table(const std::string& path);
/// The same from text; `from` names it in messages and as the default source.
Table parse_table(const std::string& text, const std::string& from);

/// In MDH frames: a classical table's a and alpha lead on to the next joint, its bodies are carried to MDH frames.
Description to_mdh(const Table& table);

/// The content of a file of at most 16 MiB. Throws Refused.
std::string read_text(const std::string& path);

}  // namespace description
