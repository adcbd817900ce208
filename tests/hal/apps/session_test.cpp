#include <firmware/apps/feedforward/session.hpp>

#include <gtest/gtest.h>

#include <set>

namespace axial::apps {
namespace {

constexpr std::uint32_t entropy = 0x12345678;

constexpr Session booted(std::uint32_t with = entropy) {
  Session session;
  session.boot(with);
  return session;
}

static_assert(!booted().is_open() && booted().id() != hal::link::no_session);

constexpr bool opens(std::uint32_t off) {
  Session session = booted();
  const std::uint32_t before = session.id();
  const bool opened = session.open(before + off, 7, entropy);
  return opened && session.is_open() && session.id() != before;
}
static_assert(opens(0) && !opens(1) && !opens(0x80000000));

constexpr bool another_name_changes_nothing() {
  Session session = booted();
  const std::uint32_t before = session.id();
  return !session.open(before + 1, 7, entropy) && session.id() == before && !session.is_open();
}
static_assert(another_name_changes_nothing());

constexpr bool a_reset_closes() {
  Session session = booted();
  session.open(session.id(), 7, entropy);
  session.boot(entropy);
  return !session.is_open();
}
static_assert(a_reset_closes());

constexpr std::uint32_t opened(std::uint32_t nonce, std::uint32_t with) {
  Session session = booted();
  session.open(session.id(), nonce, with);
  return session.id();
}
static_assert(opened(7, entropy) != opened(8, entropy), "the host's nonce makes the session");
static_assert(opened(7, entropy) != opened(7, entropy + 1), "and so does the board");
static_assert(booted(1).id() != booted(2).id());

/// The same start again and again opens a session each time that no frame of an earlier one fits.
TEST(Session, NoIdentifierComesTwiceInARow) {
  Session session = booted();
  std::set<std::uint32_t> seen{session.id()};
  for (int i = 0; i < 10000; ++i) {
    ASSERT_TRUE(session.open(session.id(), 7, entropy));
    ASSERT_NE(session.id(), hal::link::no_session);
    ASSERT_TRUE(seen.insert(session.id()).second) << i;
  }
}

}  // namespace
}  // namespace axial::apps
