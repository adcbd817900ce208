#pragma once
/// Descriptions of which one place is wrong.

#include <host_sim/robots/import/importer.hpp>

#include <gtest/gtest.h>

#include <ctime>
#include <string>

namespace broken {

/// What was done to a sound arm, and what the message must say.
struct Broken {
  const char *find, *by, *says;
};

inline std::string changed(std::string text, const Broken& broken) {
  const auto at = text.find(broken.find);
  EXPECT_NE(at, std::string::npos) << broken.find;
  return text.replace(at, std::string(broken.find).size(), broken.by);
}

/// What is taken says nothing.
inline void expect_says(const std::string& message, const std::string& says) {
  EXPECT_TRUE(says.empty() ? message.empty() : message.find(says) != std::string::npos)
      << "message: '" << message.substr(0, 300) << "', expected: " << says;
}

/// What an import refuses a text with; empty where it is taken. A second at most, or so many.
inline std::string message_within(const std::string& text, const std::string& from, const importer::Options& options,
                                  int seconds = 1) {
  const auto begin = std::clock();  // of the processor: the machine may be busy
  std::string message;
  try {
    importer::import_text(text, from, options);
  } catch (const description::Refused& refused) {
    message = refused.what();
  }
  EXPECT_LT(std::clock() - begin, seconds * CLOCKS_PER_SEC) << message;
  return message;
}

}  // namespace broken
