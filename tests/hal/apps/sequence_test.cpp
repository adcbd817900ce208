#include <firmware/apps/feedforward/sequence.hpp>

namespace axial::apps {
namespace {

using Verdict = Sequence::Verdict;
constexpr std::uint32_t window = hal::link::sequence_window;

constexpr Verdict second(std::uint32_t start, std::uint32_t number) {
  Sequence sequence;
  sequence.restart(start);
  return sequence.take(number);
}

static_assert(second(5, 6) == Verdict::next && second(5, 5 + window) == Verdict::next);
static_assert(second(5, 5) == Verdict::old && second(5, 4) == Verdict::old);
static_assert(second(5, 6 + window) == Verdict::far_ahead && second(5, 5u + 0x7FFFFFFFu) == Verdict::far_ahead);
static_assert(second(5, 6u + 0x7FFFFFFFu) == Verdict::old && second(0, 0xFFFFFFFF) == Verdict::old);
static_assert(second(0xFFFFFFFF, 0) == Verdict::next && second(0xFFFFFFFF, window - 1) == Verdict::next);
static_assert(second(0xFFFFFFFF, window) == Verdict::far_ahead);

/// What is refused leaves no trace: the next number is the next number.
constexpr bool refusals_leave_no_trace() {
  Sequence sequence;
  sequence.restart(100);
  return sequence.take(101) == Verdict::next && sequence.take(5000) == Verdict::far_ahead &&
         sequence.take(99) == Verdict::old && sequence.last() == 101 && sequence.gaps() == 0 &&
         sequence.take(102) == Verdict::next && sequence.take(105) == Verdict::next && sequence.gaps() == 2;
}
static_assert(refusals_leave_no_trace());

constexpr bool a_session_counts_its_own_gaps() {
  Sequence sequence;
  sequence.restart(0);
  sequence.take(10);
  sequence.restart(500);
  return sequence.gaps() == 0 && sequence.last() == 500 && sequence.take(501) == Verdict::next;
}
static_assert(a_session_counts_its_own_gaps());

}  // namespace
}  // namespace axial::apps
