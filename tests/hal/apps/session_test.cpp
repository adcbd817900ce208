#include <firmware/apps/feedforward/session.hpp>

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace axial::apps {
namespace {

constexpr std::uint32_t entropy = 0x12345678;

constexpr Session booted(std::uint32_t with = entropy) {
  Session session;
  session.boot(with);
  return session;
}

static_assert(!booted().is_open() && booted().id() != hal::link::no_session);

/// One that the first start, which opens none, has made an identifier for.
constexpr Session asked(std::uint32_t with = entropy) {
  Session session = booted();
  session.open(session.id(), 7, with);
  return session;
}
static_assert(!asked().is_open() && asked().id() != booted().id());
static_assert(asked(1).id() != asked(2).id(), "when the first start came is in it");

constexpr bool opens(std::uint32_t off) {
  Session session = asked();
  const std::uint32_t before = session.id();
  const bool opened = session.open(before + off, 7, entropy);
  return opened && session.is_open() && session.id() != before;
}
static_assert(opens(0) && !opens(1) && !opens(0x80000000));

constexpr bool another_name_changes_nothing() {
  Session session = asked();
  const std::uint32_t before = session.id();
  return !session.open(before + 1, 7, entropy) && session.id() == before && !session.is_open();
}
static_assert(another_name_changes_nothing());

constexpr bool a_reset_closes() {
  Session session = asked();
  session.open(session.id(), 7, entropy);
  session.boot(entropy);
  return !session.is_open() && !session.open(session.id(), 7, entropy);
}
static_assert(a_reset_closes());

constexpr std::uint32_t opened(std::uint32_t nonce, std::uint32_t with) {
  Session session = asked();
  session.open(session.id(), nonce, with);
  return session.id();
}
static_assert(opened(7, entropy) != opened(8, entropy), "the host's nonce makes the session");
static_assert(opened(7, entropy) != opened(7, entropy + 1), "and so does the board");
static_assert(booted(1).id() != booted(2).id());

/// The same start again and again opens a session each time that no frame of an earlier one fits.
TEST(Session, NoIdentifierComesTwiceInARow) {
  Session session = asked();
  std::set<std::uint32_t> seen{session.id()};
  for (int i = 0; i < 10000; ++i) {
    ASSERT_TRUE(session.open(session.id(), 7, entropy));
    ASSERT_NE(session.id(), hal::link::no_session);
    ASSERT_TRUE(seen.insert(session.id()).second) << i;
  }
}

/// The entropy for which the checksum of (identifier, nonce, entropy) is `wanted`: a checksum is affine in each bit.
std::uint32_t entropy_for(std::uint32_t id, std::uint32_t nonce, std::uint32_t wanted) {
  const auto mixed = [&](std::uint32_t with) {
    std::uint8_t bytes[12];
    const std::uint32_t words[] = {id, nonce, with};
    for (std::size_t i = 0; i < 12; ++i)
      bytes[i] = static_cast<std::uint8_t>(words[i / 4] >> (8 * (i % 4)));
    return hal::link::crc32(bytes, 12);
  };
  std::uint32_t left = wanted ^ mixed(0), columns[32], bits[32], found = 0;
  for (unsigned k = 0; k < 32; ++k)
    columns[k] = mixed(1u << k) ^ mixed(0), bits[k] = 1u << k;
  for (unsigned row = 0; row < 32; ++row) {
    unsigned pivot = row;
    while (pivot < 31 && (columns[pivot] >> row & 1u) == 0)
      ++pivot;
    std::swap(columns[row], columns[pivot]), std::swap(bits[row], bits[pivot]);
    for (unsigned k = 0; k < 32; ++k)
      if (k != row && (columns[k] >> row & 1u) != 0) columns[k] ^= columns[row], bits[k] ^= bits[row];
  }
  for (unsigned row = 0; row < 32; ++row)
    if ((left >> row & 1u) != 0) left ^= columns[row], found ^= bits[row];
  EXPECT_EQ(mixed(found), wanted);
  return found;
}

TEST(Session, AnIdentifierThatWouldComeAgainIsPassedOver) {
  Session session = asked();
  const std::uint32_t before = session.id();
  ASSERT_TRUE(session.open(before, 7, entropy_for(before, 7, before)));
  EXPECT_EQ(session.id(), before + 1);
  ASSERT_TRUE(session.open(before + 1, 7, entropy_for(before + 1, 7, hal::link::no_session)));
  EXPECT_EQ(session.id(), hal::link::no_session + 1);
}

}  // namespace
}  // namespace axial::apps
