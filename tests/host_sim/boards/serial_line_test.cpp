// The emulated serial line, between the ends of a socket pair: what comes, what does not come in time, and its end.
#include <host_sim/boards/emulator/serial_line.hpp>

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include <sys/socket.h>
#include <sys/time.h>

namespace {

using namespace std::chrono_literals;
using host_sim::Descriptor;
using host_sim::SerialLine;

class SerialLines : public testing::Test {
 protected:
  SerialLines() {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    const timeval patience{5, 0};  // a read that would wait for ever is an error by then
    EXPECT_EQ(::setsockopt(ends[0], SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience), 0);
    host = SerialLine(Descriptor(ends[0])), board = SerialLine(Descriptor(ends[1]));
  }
  SerialLine host, board;
  std::array<std::uint8_t, 8> bytes{};
};

}  // namespace

TEST_F(SerialLines, ASilentLineIsReadForAsLongAsAskedAndNoLonger) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(host.read(bytes.data(), bytes.size(), 30ms), 0u);
  const auto waited = std::chrono::steady_clock::now() - begin;
  EXPECT_GE(waited, 29ms);
  EXPECT_LT(waited, 3s);
}
TEST_F(SerialLines, WhatCameIsReadAtOnceAndInOrder) {
  const std::array<std::uint8_t, 5> sent{1, 2, 3, 4, 5};
  board.write(sent.data(), sent.size());
  EXPECT_EQ(host.read(bytes.data(), 2, 0ms), 2u);
  EXPECT_EQ(host.read(bytes.data() + 2, 6, 0ms), 3u);
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 8>{1, 2, 3, 4, 5}));
}
TEST_F(SerialLines, TheEndOfTheOtherSideIsSaid) {
  board = SerialLine();
  EXPECT_THROW(host.read(bytes.data(), bytes.size(), 1s), std::runtime_error);
  EXPECT_THROW(host.write(bytes.data(), bytes.size()), std::runtime_error);
}
