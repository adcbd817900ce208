#include <hal/link/frame.hpp>

#include <map>

#include <gtest/gtest.h>

#include "noise.hpp"

namespace axial::hal::link {
namespace {

using noise::Bytes;

Bytes encode(std::uint8_t type, std::uint32_t sequence, const Bytes& payload) {
  Bytes out(wire_size(payload.size()));
  out.resize(encode_frame({type, sequence, payload.data(), payload.size()}, out.data()));
  return out;
}

/// The last event but `none` that `bytes` cause.
FrameEvent feed(FrameDecoder& decoder, const Bytes& bytes) {
  FrameEvent last = FrameEvent::none;
  for (const std::uint8_t byte : bytes) {
    const FrameEvent event = decoder.feed(byte);
    if (event != FrameEvent::none) last = event;
  }
  return last;
}

/// A frame around a body that the caller spells out, its CRC right.
Bytes framed(Bytes body) {
  const std::uint32_t crc = crc32(body.data(), body.size());
  for (unsigned shift = 0; shift < 32; shift += 8)
    body.push_back(static_cast<std::uint8_t>(crc >> shift));
  Bytes out(cobs_size(body.size()) + 2);
  CobsWriter writer(out.data() + 1);
  writer.start();
  for (const std::uint8_t byte : body)
    writer.put(byte);
  out.resize(writer.size() + 2);
  out.back() = delimiter;
  return out;
}

void expect_frame(const FrameDecoder& decoder, std::uint8_t type, std::uint32_t sequence, const Bytes& payload) {
  const FrameView frame = decoder.frame();
  EXPECT_EQ(frame.type, type);
  EXPECT_EQ(frame.sequence, sequence);
  EXPECT_EQ(Bytes(frame.payload, frame.payload + frame.length), payload);
}

TEST(Frame, HasTheDocumentedBytes) {
  const Bytes body = {2, 0x78, 0x56, 0x34, 0x12, 3, 0, 'a', 'b', 'c'};
  EXPECT_EQ(encode(2, 0x12345678, {'a', 'b', 'c'}), framed(body));
}

TEST(Frame, RoundTripsEveryLength) {
  std::mt19937 random(1);
  FrameDecoder decoder;
  for (std::size_t length = 0; length <= max_payload; ++length) {
    Bytes payload(length);
    for (auto& byte : payload)
      byte = static_cast<std::uint8_t>(random() % 3 == 0 ? 0 : random());
    const auto sequence = static_cast<std::uint32_t>(random());
    const Bytes wire = encode(7, sequence, payload);
    ASSERT_LE(wire.size(), wire_size(length));
    ASSERT_EQ(feed(decoder, wire), FrameEvent::frame) << "length " << length;
    expect_frame(decoder, 7, sequence, payload);
  }
}

TEST(Frame, OneDelimiterBetweenFramesIsEnough) {
  FrameDecoder decoder;
  Bytes wire = encode(1, 1, {1});
  const Bytes second = encode(1, 2, {2});
  wire.insert(wire.end(), second.begin() + 1, second.end());
  EXPECT_EQ(feed(decoder, wire), FrameEvent::frame);
  expect_frame(decoder, 1, 2, {2});
}

TEST(Frame, NamesEachFault) {
  FrameDecoder decoder;
  const Bytes good = encode(2, 9, {1, 2, 3, 4});

  Bytes cut = good;
  cut.erase(cut.end() - 3, cut.end() - 1);
  EXPECT_EQ(feed(decoder, cut), FrameEvent::bad_cobs);

  EXPECT_EQ(feed(decoder, framed({1, 2, 3})), FrameEvent::truncated);
  EXPECT_EQ(feed(decoder, framed({2, 0, 0, 0, 0, 9, 0, 'x'})), FrameEvent::bad_length);
  EXPECT_EQ(feed(decoder, framed(Bytes(header_size + max_payload + 1, 5))), FrameEvent::oversized);

  Bytes flipped = good;
  flipped[2] ^= 0x40;
  EXPECT_EQ(feed(decoder, flipped), FrameEvent::bad_crc);

  EXPECT_EQ(feed(decoder, {0, 0, 0, 0}), FrameEvent::none);
  EXPECT_EQ(feed(decoder, good), FrameEvent::frame);
}

/// One frame of each session, as a line delivers them.
Bytes encode_in(std::uint32_t session) {
  const std::uint8_t payload[] = {1, 0, 3};
  Bytes out(wire_size(sizeof payload));
  out.resize(encode_frame({2, 9, payload, sizeof payload, session}, out.data()));
  return out;
}

TEST(Frame, OfAnotherSessionIsABadCrc) {
  FrameDecoder decoder;
  decoder.set_session(0x80000001);
  EXPECT_EQ(feed(decoder, encode_in(0x80000001)), FrameEvent::frame);
  EXPECT_EQ(decoder.frame().session, 0x80000001u);
  EXPECT_EQ(feed(decoder, encode_in(no_session)), FrameEvent::frame) << "what opens a session belongs to none";
  EXPECT_EQ(decoder.frame().session, no_session);
  for (unsigned bit = 0; bit < 32; ++bit)
    EXPECT_EQ(feed(decoder, encode_in(0x80000001 ^ 1u << bit)), FrameEvent::bad_crc) << bit;
  decoder.set_session(7);
  EXPECT_EQ(feed(decoder, encode_in(0x80000001)), FrameEvent::bad_crc);
}

TEST(Frame, TheSessionIsTheCrcs) {
  const Bytes plain = encode_in(no_session), marked = encode_in(0xFF);
  ASSERT_EQ(plain.size(), marked.size()) << "it costs no byte";
  EXPECT_EQ(static_cast<std::uint8_t>(plain[plain.size() - 5] ^ marked[marked.size() - 5]), 0xFF);
}

TEST(Frame, LongGarbageWithoutADelimiterIsOneOversizedFrame) {
  FrameDecoder decoder;
  EXPECT_EQ(feed(decoder, Bytes(100000, 0x11)), FrameEvent::none);
  EXPECT_EQ(feed(decoder, {0}), FrameEvent::oversized);
}

TEST(Frame, AGoodFrameAfterAnyGarbageIsDecoded) {
  constexpr unsigned seed = 20240918;
  std::mt19937 random(seed);
  FrameDecoder decoder;
  std::map<FrameEvent, int> seen;
  for (std::uint32_t round = 0; round < 100000; ++round) {
    const Bytes payload = noise::random_bytes(random, max_payload);
    ++seen[feed(decoder, noise::spoilt(random, encode(2, round, payload)))];
    ASSERT_EQ(feed(decoder, encode(3, round, payload)), FrameEvent::frame) << "seed " << seed << ", round " << round;
    expect_frame(decoder, 3, round, payload);
  }
  for (const FrameEvent event : {FrameEvent::bad_cobs, FrameEvent::truncated, FrameEvent::oversized,
                                 FrameEvent::bad_length, FrameEvent::bad_crc}) {
    EXPECT_GT(seen[event], 0) << "the garbage never caused event " << static_cast<int>(event);
  }
}

}  // namespace
}  // namespace axial::hal::link
