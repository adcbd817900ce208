#include <host_sim/robots/description/comment.hpp>

#include <sstream>

namespace description {

std::string harmless(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '\\' ? '/' : c == '"' ? '\'' : c < ' ' || c > '~' || c == '?' ? '.' : c;
  return result;
}

std::string comment_lines(const std::string& head, const std::string& text) {
  constexpr std::size_t columns = 120;
  std::istringstream words(harmless(text));
  std::string result, line = "// " + head, word;
  const std::string indent = "// " + std::string(head.size(), ' ');
  bool empty = true;
  while (words >> word) {
    if (!empty && line.size() + 1 + word.size() > columns) result += line + "\n", line = indent, empty = true;
    line += (empty ? "" : " ") + word;
    empty = false;
  }
  return result + line + "\n";
}

}  // namespace description
