/// memcpy, memmove, memset and memcmp, as a compiler may call them, at every alignment: on some boards they are ours.

#include <cstring>

#include "check.hpp"

namespace axial::apps {
namespace {

constexpr std::size_t room = 24, most = 11;

struct Bytes {
  alignas(4) std::uint8_t at[room];
};

constexpr Bytes counted() {
  Bytes bytes{};
  for (std::size_t i = 0; i < room; ++i)
    bytes.at[i] = static_cast<std::uint8_t>(i + 1);
  return bytes;
}

/// Keeps the compiler from doing the work itself.
std::size_t opaque(std::size_t value) {
  asm volatile("" : "+r"(value));
  return value;
}

bool same(const Bytes& a, const Bytes& b) {
  for (std::size_t i = 0; i < room; ++i) {
    if (a.at[i] != b.at[i]) return false;
  }
  return true;
}

/// What moving leaves, byte by byte.
Bytes moved(std::size_t to, std::size_t from, std::size_t bytes) {
  const Bytes before = counted();
  Bytes after = before;
  for (std::size_t i = 0; i < bytes; ++i)
    after.at[to + i] = before.at[from + i];
  return after;
}

void check_places(Checks& check, std::size_t to, std::size_t from, std::size_t bytes) {
  const Bytes source = counted();
  Bytes copy = source, move = source, set = source, expected_set = source;
  std::memcpy(copy.at + to, source.at + from, opaque(bytes));
  std::memmove(move.at + to, move.at + from, opaque(bytes));
  std::memset(set.at + to, 0xA5, opaque(bytes));
  for (std::size_t i = 0; i < bytes; ++i)
    expected_set.at[to + i] = 0xA5;
  check.that(same(copy, moved(to, from, bytes)), "memcpy copies, and nothing else");
  check.that(same(move, moved(to, from, bytes)), "memmove copies what overlaps");
  check.that(same(set, expected_set), "memset sets, and nothing else");
}

}  // namespace

void check_memory(Checks& check) {
  for (std::size_t to = 0; to < 8; ++to)
    for (std::size_t from = 0; from < 8; ++from)
      for (std::size_t bytes = 0; bytes <= most; ++bytes)
        check_places(check, to, from, bytes);
  const Bytes a = counted();
  Bytes b = a;
  b.at[7] = 0x80;
  check.that(std::memcmp(a.at, b.at, opaque(7)) == 0, "memcmp looks no further");
  check.that(std::memcmp(a.at, b.at, opaque(8)) < 0 && std::memcmp(b.at, a.at, opaque(8)) > 0,
             "memcmp compares bytes without a sign");
}

}  // namespace axial::apps
