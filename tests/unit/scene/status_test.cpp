// Every code has a text of its own, in constant expressions too, and so does a number that is no code.
#include <axial/scene/status_text.hpp>

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace {

using axial::Status;
using axial::status_text;
using Code = Status::Code;

constexpr int codes = 17;  // of the enumeration; the compiler asks status_text() for each that is added (-Wswitch)

TEST(StatusText, EveryCodeHasATextOfItsOwn) {
  std::set<std::string> texts;
  for (int code = 0; code < codes; ++code)
    texts.insert(status_text(static_cast<Code>(code)));
  EXPECT_EQ(texts.size(), std::size_t{codes});
  EXPECT_EQ(texts.count(""), 0u);
}

TEST(StatusText, UnknownNumbersHaveOneToo) {
  const std::string unknown = status_text(static_cast<Code>(codes));
  EXPECT_EQ(unknown, "unknown status code");
  EXPECT_EQ(status_text(static_cast<Code>(255)), unknown);
}

TEST(StatusText, OfAStatusIsThatOfItsCode) {
  constexpr Status status{Code::speed_limit, 3};
  constexpr const char* text = status_text(status);
  EXPECT_STREQ(text, status_text(Code::speed_limit));
  EXPECT_STREQ(status_text(Status{}), "ok");
}

TEST(Status, IsMetWhereOnlyTheAnswerWasLimited) {
  for (int code = 0; code < codes; ++code) {
    const auto c = static_cast<Code>(code);
    const bool limited =
        c == Code::effort_limit || c == Code::effort_rate || c == Code::command_limit || c == Code::current_limit;
    EXPECT_EQ((Status{c, -1}.met()), c == Code::ok || limited) << code;
  }
}

}  // namespace
