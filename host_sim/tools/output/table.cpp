#include <host_sim/tools/output/table.hpp>

#include <algorithm>
#include <cstdio>

namespace host_sim {

namespace {

std::string padded(const std::string& cell, std::size_t width, bool right) {
  const std::string blanks(width - std::min(width, cell.size()), ' ');
  return right ? blanks + cell : cell + blanks;
}

}  // namespace

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  return widths;
}

bool Table::numeric(std::size_t column) const {
  return std::all_of(rows_.begin() + 1, rows_.end(), [&](const auto& row) {
    return row[column].empty() || row[column].find_first_of("0123456789") == 0 || row[column].front() == '-';
  });
}

std::string Table::text() const {
  const auto width = widths();
  std::string text;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (std::size_t c = 0; c < width.size(); ++c)
      text += (c == 0 ? "" : "  ") + padded(rows_[r][c], width[c], numeric(c));
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
    if (r > 0) continue;
    for (std::size_t c = 0; c < width.size(); ++c)
      text += (c == 0 ? "" : "  ") + std::string(width[c], '-');
    text += '\n';
  }
  return text;
}

std::string significant(double value, int digits) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  return buffer;
}

std::string grouped(unsigned long value) {
  std::string digits = std::to_string(value);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), " ");
  return digits;
}

}  // namespace host_sim
