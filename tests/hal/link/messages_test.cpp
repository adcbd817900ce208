#include <hal/link/messages.hpp>

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "noise.hpp"

namespace axial::hal::link {
namespace {

template <class Message>
bool round_trip(const Message& sent, Message& received) {
  FrameDecoder decoder;
  FrameEvent event = FrameEvent::none;
  for (const std::uint8_t byte : noise::wire(sent, 5)) {
    const FrameEvent next = decoder.feed(byte);
    if (next != FrameEvent::none) event = next;
  }
  return event == FrameEvent::frame && decode_message(decoder.frame(), received);
}

TEST(Messages, SetPointKeepsEveryBit) {
  SetPoint sent{}, received{};
  sent.joints = 7;
  for (std::size_t i = 0; i < sent.joints; ++i) {
    sent.q[i] = 0.1f * static_cast<float>(i);
    sent.qd[i] = -sent.q[i];
    sent.qdd[i] = 1e-30f;
  }
  sent.q[3] = std::numeric_limits<float>::quiet_NaN();
  sent.qd[0] = -std::numeric_limits<float>::infinity();
  ASSERT_TRUE(round_trip(sent, received));
  EXPECT_EQ(received.joints, sent.joints);
  for (std::size_t i = 0; i < sent.joints; ++i) {
    EXPECT_EQ(std::isnan(received.q[i]), std::isnan(sent.q[i]));
    EXPECT_TRUE(std::isnan(sent.q[i]) || received.q[i] == sent.q[i]);
    EXPECT_EQ(received.qd[i], sent.qd[i]);
    EXPECT_EQ(received.qdd[i], sent.qdd[i]);
  }
}

TEST(Messages, TorqueAndHelloRoundTrip) {
  Torque torque{}, torque_back{};
  torque.joints = 3;
  torque.tau = {1.5f, -2.0f, 3.0f};
  torque.count = 0xFEDCBA98;
  torque.status = static_cast<std::uint8_t>(TorqueStatus::outside_limits);
  torque.joint = 2;
  torque.overruns = 0xABCD;
  torque.phase = 3;
  ASSERT_TRUE(round_trip(torque, torque_back));
  EXPECT_EQ(torque_back.tau, torque.tau);
  EXPECT_EQ(torque_back.count, torque.count);
  EXPECT_EQ(torque_back.status, torque.status);
  EXPECT_EQ(torque_back.joint, torque.joint);
  EXPECT_EQ(torque_back.overruns, torque.overruns);
  EXPECT_EQ(torque_back.phase, torque.phase);

  Hello hello{}, hello_back{};
  hello.version = protocol_version;
  hello.joints = 4;
  hello.clock_Hz = 168000000;
  hello.robot = make_name("a_name_longer_than_the_field");
  hello.session = 0x11223344;
  hello.nonce = 0x55667788;
  hello.reset_cause = 3;
  hello.fault_address = 0x08001234;
  hello.library = 10203;
  ASSERT_TRUE(round_trip(hello, hello_back));
  EXPECT_EQ(hello_back.clock_Hz, hello.clock_Hz);
  EXPECT_STREQ(hello_back.robot.data(), "a_name_longer_t");
  EXPECT_EQ(hello_back.session, hello.session);
  EXPECT_EQ(hello_back.nonce, hello.nonce);
  EXPECT_EQ(hello_back.reset_cause, hello.reset_cause);
  EXPECT_EQ(hello_back.fault_address, hello.fault_address);
  EXPECT_EQ(hello_back.library, hello.library);
}

TEST(Messages, MeasurementsKeepTheirSign) {
  Measurement sent{}, back{};
  sent.joints = 3;
  sent.position = {-1, std::numeric_limits<std::int32_t>::min(), 7};
  sent.feeds_forward = 1;
  ASSERT_TRUE(round_trip(sent, back));
  EXPECT_EQ(back.joints, 3u);
  EXPECT_TRUE(back.position == sent.position);
  EXPECT_EQ(back.feeds_forward, 1);
}

TEST(Messages, AnArmsEncodersAndCommandsRoundTrip) {
  Encoders sent{}, back{};
  sent.joints = 3;
  sent.position = {-1, std::numeric_limits<std::int32_t>::min(), 7};
  sent.speed = {0.5f, -2.0f, 3.0f};
  sent.count = 0xFEDCBA98, sent.overruns = 0xABCD, sent.status = 2, sent.joint = 1, sent.phase = 3;
  ASSERT_TRUE(round_trip(sent, back));
  EXPECT_EQ(back.joints, 3u);
  EXPECT_EQ(back.position, sent.position);
  EXPECT_EQ(back.speed, sent.speed);
  EXPECT_EQ(back.count, sent.count);
  EXPECT_EQ(back.overruns, sent.overruns);
  EXPECT_EQ(back.status, 2);
  EXPECT_EQ(back.joint, 1);
  EXPECT_EQ(back.phase, 3);

  ArmCommand told{}, heard{};
  told.joints = 2, told.values = {1.5f, -0.25f}, told.action = static_cast<std::uint8_t>(ArmAction::blind);
  ASSERT_TRUE(round_trip(told, heard));
  EXPECT_EQ(heard.joints, 2u);
  EXPECT_EQ(heard.values, told.values);
  EXPECT_EQ(heard.action, 2);
}

TEST(Messages, ALoadsBytesStandInTheOrderOfTheProtocol) {
  const ArmLoad load{1.5f, {0.5f, -0.25f, 2.0f}, {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f}};
  ArmLoad back{};
  ASSERT_TRUE(round_trip(load, back));
  EXPECT_EQ(back.com, load.com);
  EXPECT_EQ(back.inertia, load.inertia);
  std::uint8_t bytes[max_payload];
  ByteWriter writer(bytes, sizeof bytes);
  ArmLoad copy = load;
  layout(writer, copy);
  ASSERT_EQ(writer.size(), 40u);
  const float order[] = {1.5f, 0.5f, -0.25f, 2.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f};
  for (std::size_t i = 0; i < 10; ++i) {
    float read = 0.0f;
    std::memcpy(&read, bytes + 4 * i, sizeof read);  // of a host whose lowest byte is first, as the line's
    EXPECT_EQ(read, order[i]) << i;
  }
}

TEST(Messages, EveryMessageFitsAFrame) {
  std::uint8_t out[max_payload];
  const auto size = [&](auto message) {
    ByteWriter writer(out, sizeof out);
    layout(writer, message);
    EXPECT_TRUE(writer.ok());
    return writer.size();
  };
  EXPECT_EQ(size(Hello{}), 78u);
  EXPECT_EQ(size(ErrorReply{}), 45u);
  EXPECT_EQ(size(Stats{}), 84u);
  EXPECT_EQ(size(Start{}), 9u);
  EXPECT_EQ(size(Injection{}), 5u);
  SetPoint full{};
  full.joints = max_joints;
  EXPECT_EQ(size(full), set_point_size(max_joints));
}

TEST(Messages, AWrongLengthIsRefused) {
  const std::uint8_t bytes[40]{};
  SetPoint set_point{};
  Torque torque{};
  Start start{};
  EXPECT_TRUE(decode_message({2, 0, bytes, 36}, set_point));
  EXPECT_FALSE(decode_message({2, 0, bytes, 35}, set_point));
  EXPECT_FALSE(decode_message({3, 0, bytes, 36}, set_point));
  EXPECT_TRUE(decode_message({3, 0, bytes, 21}, torque));
  EXPECT_FALSE(decode_message({3, 0, bytes, 20}, torque));
  EXPECT_FALSE(decode_message({3, 0, bytes, 5}, torque));
  EXPECT_TRUE(decode_message({8, 0, bytes, 9}, start));
  EXPECT_FALSE(decode_message({8, 0, bytes, 8}, start));
  EXPECT_FALSE(decode_message({8, 0, bytes, 10}, start));
  Measurement measurement{};
  EXPECT_TRUE(decode_message({9, 0, bytes, 13}, measurement));
  EXPECT_FALSE(decode_message({9, 0, bytes, 12}, measurement));
  EXPECT_FALSE(decode_message({9, 0, bytes, 37}, measurement));
  Encoders encoders{};
  EXPECT_TRUE(decode_message({12, 0, bytes, 33}, encoders));
  EXPECT_FALSE(decode_message({12, 0, bytes, 32}, encoders));
  EXPECT_FALSE(decode_message({12, 0, bytes, 8}, encoders));
  ArmCommand command{};
  EXPECT_TRUE(decode_message({13, 0, bytes, 13}, command));
  EXPECT_FALSE(decode_message({13, 0, bytes, 12}, command));
}

TEST(Messages, AsManyJointsAsThereMayBeAndNotOneMore) {
  const std::uint8_t bytes[12 * (max_joints + 1)]{};
  const auto decodes = [&](auto message, std::size_t length) {
    const bool decoded =
        decode_message({static_cast<std::uint8_t>(decltype(message)::type), 0, bytes, length}, message);
    EXPECT_TRUE(!decoded || message.joints == max_joints) << message.joints;
    return decoded;
  };
  EXPECT_TRUE(decodes(SetPoint{}, set_point_size(max_joints)));
  EXPECT_FALSE(decodes(SetPoint{}, set_point_size(max_joints + 1)));
  EXPECT_TRUE(decodes(Torque{}, torque_size(max_joints)));
  EXPECT_FALSE(decodes(Torque{}, torque_size(max_joints + 1)));
  EXPECT_TRUE(decodes(Measurement{}, measurement_size(max_joints)));
  EXPECT_FALSE(decodes(Measurement{}, measurement_size(max_joints + 1)));
  EXPECT_TRUE(decodes(Derivatives{}, derivatives_size(max_joints)));
  EXPECT_FALSE(decodes(Derivatives{}, derivatives_size(max_joints + 1)));
  EXPECT_TRUE(decodes(Encoders{}, encoders_size(max_joints)));
  EXPECT_FALSE(decodes(Encoders{}, encoders_size(max_joints + 1)));
  EXPECT_TRUE(decodes(ArmCommand{}, arm_command_size(max_joints)));
  EXPECT_FALSE(decodes(ArmCommand{}, arm_command_size(max_joints + 1)));
}

// 7 joints: 84 + 37 bytes of payload, 11 of header and CRC, 1 of stuffing and 2 delimiters each: 149 bytes, 1 490 bits.
static_assert(wire_size(set_point_size(7)) == 98 && wire_size(torque_size(7)) == 51);
static_assert(fits_tick(7, 1'490'000, 1000) && !fits_tick(7, 1'489'999, 1000));
// A measurement adds 29 + 14 bytes.
static_assert(fits_tick(7, 1'920'000, 1000, true) && !fits_tick(7, 1'919'999, 1000, true));
// A torque of 51 bytes, encoders of 65 + 14.
static_assert(arm_fits_tick(7, 1'300'000, 1000) && !arm_fits_tick(7, 1'299'999, 1000));

}  // namespace
}  // namespace axial::hal::link
