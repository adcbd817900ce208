#pragma once
/// Whatever is done to a description, the importer refuses it or imports it: it never crashes and never hangs.
/// AXIAL_FUZZ_ROUNDS in the environment sets how many are tried of each kind (default 1500).

#include <host_sim/robots/description/header.hpp>
#include <host_sim/robots/import/importer.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <string>

namespace fuzzing {

constexpr unsigned seed = 20240607;

inline int rounds() {
  const char* given = std::getenv("AXIAL_FUZZ_ROUNDS");
  return given != nullptr ? std::atoi(given) : 1500;
}

class Mutator {
 public:
  explicit Mutator(unsigned with) : random_(with) {}

  std::size_t below(std::size_t bound) { return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random_); }

  /// Bytes changed, removed, repeated or cut off.
  std::string bytes(std::string text) {
    for (std::size_t i = 0, count = 1 + below(8); i < count && text.size() > 2; ++i) {
      const std::size_t at = below(text.size());
      const std::size_t length = std::min(text.size() - at, 1 + below(30));
      switch (below(5)) {
        case 0:
          text[at] = static_cast<char>(below(256));
          break;
        case 1:
          text.erase(at, length);
          break;
        case 2:
          text.insert(below(text.size()), text.substr(at, length));
          break;
        case 3:
          text[at] = "<>/\"'{}[],:-.e0 9"[below(17)];
          break;
        default:
          if (below(10) == 0) text.resize(at);
      }
    }
    return text;
  }

  /// Quoted texts and numbers replaced by others of the text, or by what numbers should not be.
  std::string values(std::string text) {
    static const char* const others[] = {
        "nan",          "-1",         "0",        "1e308",    "-1e308",
        "1e-320",       "1e9",        "",         "1,5",      "0 0 0",
        "1e8 -1e8 1e8", "base",       "upper",    "fore",     "tool0",
        "fixed",        "continuous", "floating", "revolute", "3.14159 1.5708 -3.14159",
        "null",         "true",       "[]"};
    for (std::size_t i = 0, count = 1 + below(4); i < count; ++i) {
      const auto [begin, end] = value_from(text, below(text.size()));
      if (end > begin) text.replace(begin, end - begin, others[below(std::size(others))]);
    }
    return text;
  }

 private:
  /// The first number or quoted text from here on.
  static std::pair<std::size_t, std::size_t> value_from(const std::string& text, std::size_t at) {
    const std::size_t begin = text.find_first_of("0123456789\"", at);
    if (begin == std::string::npos) return {0, 0};
    if (text[begin] != '"') {
      const std::size_t end = text.find_first_not_of("0123456789.e-", begin);
      return {begin, end == std::string::npos ? text.size() : end};
    }
    const std::size_t end = text.find('"', begin + 1);
    return {begin + 1, end == std::string::npos ? begin + 1 : end};
  }

  std::mt19937 random_;
};

/// Imported, or refused with a message.
inline void try_import(const std::string& text) {
  importer::Options options;
  options.states = 1;
  try {
    const auto result = importer::import_text(text, "fuzzed", options);
    if (result.figures.good()) {
      EXPECT_FALSE(description::header(result.imported.robot, {}).empty());
    }
  } catch (const description::Refused& refused) {
    EXPECT_NE(std::string(refused.what()), "");
  } catch (const std::exception& error) {
    FAIL() << error.what() << "\n" << text;
  }
}

template <class Change>
void fuzz(const char* text, Change change, int times = rounds()) {
  constexpr auto longest = std::chrono::seconds(5);  // a file of this size takes a millisecond
  for (int i = 0; i < times; ++i) {
    Mutator mutator(seed + static_cast<unsigned>(i));
    const std::string broken = change(mutator, text);
    const auto begin = std::chrono::steady_clock::now();
    try_import(broken);
    ASSERT_LT(std::chrono::steady_clock::now() - begin, longest) << broken;
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

}  // namespace fuzzing
