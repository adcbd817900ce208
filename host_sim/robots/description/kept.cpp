#include <host_sim/robots/description/kept.hpp>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace description {
namespace {

constexpr const char* mark = "// kept";

std::string trimmed(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
    text.pop_back();
  const auto first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first);
}

/// The code of a line: no comment, no comma behind it.
std::string code_of(const std::string& line) {
  std::string code = trimmed(line.substr(0, line.find("//")));
  while (!code.empty() && (code.back() == ',' || code.back() == ' '))
    code.pop_back();
  return code;
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The joint of a comment such as "// 2: elbow moves fore"; empty for other lines.
std::string joint_of(const std::string& line) {
  const std::string text = trimmed(line);
  std::size_t at = 3;
  while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0)
    ++at;
  const auto end = text.find(" moves ");
  if (text.rfind("// ", 0) != 0 || at == 3 || text.compare(at, 2, ": ") != 0 || end == std::string::npos) return "";
  return text.substr(at + 2, end - at - 2);
}

/// A call from `at` on: its name stands behind a dot or "axial::", its brackets match.
struct Call {
  std::size_t begin = 0, end = 0;
  std::string name;
};
std::vector<Call> calls_of(const std::string& row) {
  std::vector<Call> calls;
  int depth = 0;
  std::size_t word = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool in_word = std::isalnum(static_cast<unsigned char>(row[i])) != 0 || row[i] == '_';
    if (row[i] == '(' && depth++ == 0) calls.push_back({word, i, row.substr(word, i - word)});
    if (row[i] == ')' && --depth == 0) calls.back().end = i + 1;
    if (!in_word) word = i + 1;
  }
  return calls;
}

}  // namespace

Kept kept_lines(const std::string& header) {
  Kept kept;
  std::istringstream lines(header);
  std::string line, joint;
  while (std::getline(lines, line)) {
    if (const std::string next = joint_of(line); !next.empty()) joint = next;
    if (ends_with(trimmed(line), mark) && !code_of(line).empty()) kept[joint].push_back(code_of(line));
  }
  return kept;
}

std::set<std::string> quantities_of(const std::vector<std::string>& lines) {
  std::set<std::string> names;
  for (const auto& line : lines)
    for (const auto& call : calls_of(line))
      names.insert(call.name);
  return names;
}

std::string without(const std::string& row, const std::set<std::string>& quantities) {
  std::string result = row;
  const auto calls = calls_of(row);
  for (auto call = calls.rbegin(); call != calls.rend(); ++call)
    if (quantities.count(call->name) != 0 && call->begin > 0)
      result.erase(call->begin - 1, call->end - call->begin + 1);
  return result;
}

std::vector<std::string> lines_that_are_lost(const std::string& before, const std::string& now) {
  const auto codes = [](const std::string& text) {
    std::vector<std::string> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      if (const std::string code = code_of(line); !code.empty()) all.push_back(code);
    return all;
  };
  const auto left = codes(now);
  std::vector<std::string> lost;
  for (const auto& code : codes(before))
    if (std::find(left.begin(), left.end(), code) == left.end()) lost.push_back(code);
  return lost;
}

}  // namespace description
