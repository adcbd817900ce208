#include <host_sim/tools/system/process.hpp>
#include <host_sim/tools/system/temporary_folder.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <signal.h>

namespace {

using host_sim::Process;
using host_sim::TemporaryFolder;
using std::chrono::milliseconds;

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(Process, GivesStatusAndOutput) {
  const TemporaryFolder folder;
  Process process({"sh", "-c", "echo out; echo err >&2; exit 7"}, folder.file("output"));
  EXPECT_EQ(process.wait(milliseconds(10000)), 7);
  EXPECT_EQ(content(folder.file("output")), "out\nerr\n");
}

TEST(Process, SaysWhenAProgramIsMissing) {
  const TemporaryFolder folder;
  EXPECT_THROW(Process({"no-such-program-anywhere"}, folder.file("output")), std::runtime_error);
}

TEST(Process, WaitEndsInTime) {
  const TemporaryFolder folder;
  Process process({"sleep", "60"}, folder.file("output"));
  EXPECT_FALSE(process.wait(milliseconds(20)).has_value());
}

TEST(Process, ReportsADeadlySignal) {
  const TemporaryFolder folder;
  Process process({"sh", "-c", "kill -TERM $$"}, folder.file("output"));
  EXPECT_EQ(process.wait(milliseconds(10000)), 128 + SIGTERM);
}

/// Also one that ignores the polite request.
TEST(Process, DoesNotOutliveItsOwner) {
  const TemporaryFolder folder;
  {
    Process process({"sh", "-c", "trap '' TERM; echo $$; while :; do sleep 0.05; done"}, folder.file("output"));
    while (content(folder.file("output")).find('\n') == std::string::npos)
      process.wait(milliseconds(5));
  }
  EXPECT_NE(::kill(static_cast<pid_t>(std::stoi(content(folder.file("output")))), 0), 0);
}

}  // namespace
