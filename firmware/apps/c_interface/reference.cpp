/// The answers of the C++ interface, to be compared with those that C got.

#include <axial/control/feedforward.hpp>
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

#include "board.h"

namespace {

using robots::Scara;
using Real = axial::Joints<Scara, float>;

axial::FeedforwardState<Scara, float> state{};
axial::FeedforwardState<Scara, axial::Fixed32> fixed_state{};

Real real(const arm_joints& values) { return {values.of[0], values.of[1], values.of[2]}; }

void print_word(std::uint32_t word) {
  board_print(",");
  board_print_hex(word);
}
void print_status(const axial::Status& status) {
  print_word(static_cast<std::uint32_t>(status.code));
  print_word(static_cast<std::uint32_t>(status.joint));
}

}  // namespace

void print_reference(std::uint32_t row, const arm_joints* q, const arm_joints* qd, const arm_joints* qdd) {
  const auto safe = axial::feedforward<Scara>(state, real(*q), real(*qd), real(*qdd));
  const auto request = axial::to_fixed_request<Scara, std::int32_t>(real(*q), real(*qd), real(*qdd));
  const auto fixed = axial::feedforward<Scara>(fixed_state, request.q, request.qd, request.qdd);
  board_print("c++");
  print_word(row);
  for (const float& tau : safe.tau.values)
    print_word(__builtin_bit_cast(std::uint32_t, tau));
  print_status(safe.status);
  for (const auto& tau : fixed.tau.values)
    print_word(static_cast<std::uint32_t>(tau.raw));
  print_status(request.status);
  board_print("\n");
}
