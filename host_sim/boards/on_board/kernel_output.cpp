#include <host_sim/boards/on_board/kernel_output.hpp>

#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace host_sim {

namespace {

using Cells = std::vector<std::string>;

Cells split(const std::string& line) {
  Cells cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');)
    cells.push_back(cell);
  return cells;
}

/// The number whose bits are 8 (float) or 16 (double) hexadecimal digits.
double from_bits(const std::string& digits) {
  std::size_t used = 0;
  const std::uint64_t bits = std::stoull(digits, &used, 16);
  if (used != digits.size() || (used != 8 && used != 16)) throw std::invalid_argument(digits);
  const auto short_bits = static_cast<std::uint32_t>(bits);
  float narrow = 0.0F;
  double wide = 0.0;
  std::memcpy(&narrow, &short_bits, sizeof narrow);
  std::memcpy(&wide, &bits, sizeof wide);
  return used == 8 ? static_cast<double>(narrow) : wide;
}

std::vector<double> numbers(const Cells& cells, std::size_t begin, std::size_t end) {
  std::vector<double> values;
  for (std::size_t i = begin; i < end; ++i)
    values.push_back(from_bits(cells.at(i)));
  return values;
}

SetPoint state_from(const Cells& cells) {
  const std::size_t n = (cells.size() - 2) / 3;
  if (cells.size() != 2 + 3 * n) throw std::invalid_argument("state");
  return {0.0, numbers(cells, 2, 2 + n), numbers(cells, 2 + n, 2 + 2 * n), numbers(cells, 2 + 2 * n, 2 + 3 * n)};
}

Evaluation evaluation_from(const Cells& cells) {
  return {cells.at(0), cells.at(2), std::stoul(cells.at(3)), static_cast<unsigned>(std::stoul(cells.at(4))),
          numbers(cells, 5, cells.size())};
}

/// True at the line that ends a complete output.
bool take(KernelOutput& output, const Cells& cells) {
  const std::string& head = cells.at(0);
  if (head == "end") return true;
  if (head == "board") {
    output.counter = cells.at(2);
  } else if (head == "state") {
    output.states.push_back(state_from(cells));
  } else if (head != "robot" && head != "stack" && head != "range") {
    output.evaluations.push_back(evaluation_from(cells));
    if (output.evaluations.back().state >= output.states.size()) throw std::invalid_argument("unknown state");
  }
  return false;
}

}  // namespace

KernelOutput parse_kernel_output(const std::string& text) {
  KernelOutput output;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    try {
      if (take(output, split(line))) return output;
    } catch (const std::logic_error&) {
      throw std::runtime_error("the kernels image printed a line of another format: " + line);
    }
  }
  throw std::runtime_error("the output of the kernels image ends early");
}

}  // namespace host_sim
