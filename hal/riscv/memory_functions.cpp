/// The functions that a compiler may call without being asked to. Debian's C library for this core, picolibc, is a
/// gigabyte for every RISC-V there is; these are all that images take from one.

#include <cstddef>
#include <cstdint>

namespace {

using Word [[gnu::may_alias]] = std::uint32_t;

bool words_fit(std::uintptr_t a, std::uintptr_t b) { return (a | b) % sizeof(Word) == 0; }
std::uintptr_t place(const void* p) { return reinterpret_cast<std::uintptr_t>(p); }

}  // namespace

extern "C" {

void* memcpy(void* to, const void* from, std::size_t bytes) {
  auto* out = static_cast<unsigned char*>(to);
  const auto* in = static_cast<const unsigned char*>(from);
  if (words_fit(place(to), place(from))) {
    for (; bytes >= sizeof(Word); bytes -= sizeof(Word), out += sizeof(Word), in += sizeof(Word))
      *reinterpret_cast<Word*>(out) = *reinterpret_cast<const Word*>(in);
  }
  for (; bytes > 0; --bytes)
    *out++ = *in++;
  return to;
}

void* memmove(void* to, const void* from, std::size_t bytes) {
  if (place(to) <= place(from) || place(to) >= place(from) + bytes) return memcpy(to, from, bytes);
  auto* out = static_cast<unsigned char*>(to);
  const auto* in = static_cast<const unsigned char*>(from);
  while (bytes-- > 0)
    out[bytes] = in[bytes];
  return to;
}

void* memset(void* to, int value, std::size_t bytes) {
  auto* out = static_cast<unsigned char*>(to);
  const auto byte = static_cast<unsigned char>(value);
  if (words_fit(place(to), 0)) {
    for (; bytes >= sizeof(Word); bytes -= sizeof(Word), out += sizeof(Word))
      *reinterpret_cast<Word*>(out) = byte * 0x01010101u;
  }
  for (; bytes > 0; --bytes)
    *out++ = byte;
  return to;
}

int memcmp(const void* a, const void* b, std::size_t bytes) {
  const auto *left = static_cast<const unsigned char*>(a), *right = static_cast<const unsigned char*>(b);
  for (; bytes > 0; --bytes, ++left, ++right) {
    if (*left != *right) return *left - *right;
  }
  return 0;
}
}
