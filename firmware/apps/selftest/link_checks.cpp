/// The link's code on the target: check value of the CRC, a round trip, a frame after garbage.

#include <hal/link/messages.hpp>

#include "check.hpp"

namespace axial::apps {
namespace {

namespace link = hal::link;

bool decodes(link::FrameDecoder& decoder, const link::WireBytes& wire, link::SetPoint& out) {
  link::FrameEvent event = link::FrameEvent::none;
  for (std::size_t i = 0; i < wire.size; ++i) {
    const link::FrameEvent next = decoder.feed(wire.bytes[i]);
    if (next != link::FrameEvent::none) event = next;
  }
  return event == link::FrameEvent::frame && decode_message(decoder.frame(), out);
}

}  // namespace

void check_link(Checks& check) {
  const std::uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  check.equal(link::crc32(digits, sizeof digits), 0xCBF43926u, "the CRC has its check value");

  link::SetPoint sent{}, received{};
  sent.joints = link::max_joints;
  for (std::size_t i = 0; i < sent.joints; ++i)
    sent.qd[i] = static_cast<float>(i) * 0.1f;
  const link::WireBytes wire = encode_message(sent, 7);
  link::FrameDecoder decoder;
  check.that(decodes(decoder, wire, received), "a frame comes back");
  check.that(received.qd == sent.qd, "with the same bits");
  constexpr std::uint8_t garbage[] = {0x42, 0x00, 0xFF, 0x01, 0x01};
  for (const std::uint8_t byte : garbage)
    decoder.feed(byte);
  check.that(decodes(decoder, wire, received), "and after garbage too");
}

}  // namespace axial::apps
