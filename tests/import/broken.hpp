#pragma once
/// Descriptions of which one place is wrong.

#include <gtest/gtest.h>
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

inline void expect_says(const std::string& message, const std::string& says) {
  EXPECT_NE(message.find(says), std::string::npos) << "message: '" << message.substr(0, 300) << "', expected: " << says;
}

}  // namespace broken
