// Tables as text.
#pragma once

#include <string>
#include <vector>

namespace host_sim {

/// Rows of cells under a header. Numbers are aligned to the right, words to the left.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{static_cast<std::vector<std::string>&&>(header)} {}
  void add(std::vector<std::string> row) { rows_.push_back(static_cast<std::vector<std::string>&&>(row)); }

  /// Columns padded with blanks, a rule under the header.
  std::string text() const;

 private:
  std::vector<std::size_t> widths() const;
  bool numeric(std::size_t column) const;

  std::vector<std::vector<std::string>> rows_;
};

/// With so many significant digits.
std::string significant(double value, int digits = 3);
/// With thin groups of three: 1 048 576.
std::string grouped(unsigned long value);

}  // namespace host_sim
