// Urdfs, MJCFs and tables with bytes and values changed: see fuzz.hpp.
#include "fuzz.hpp"
#include "arms.hpp"

namespace {

using fuzzing::fuzz;
using fuzzing::rounds;

TEST(Fuzz, BytesOfUrdfs) {
  fuzz(arms::urdf, [](fuzzing::Mutator& m, const std::string& text) { return m.bytes(text); });
}
TEST(Fuzz, ValuesOfUrdfs) {
  fuzz(arms::urdf, [](fuzzing::Mutator& m, const std::string& text) { return m.values(text); });
}
// Most of these are imported, which takes longer than a refusal.
TEST(Fuzz, BytesOfMjcfs) {
  fuzz(
      arms::mjcf, [](fuzzing::Mutator& m, const std::string& text) { return m.bytes(text); }, rounds() / 3);
}
TEST(Fuzz, ValuesOfMjcfs) {
  fuzz(
      arms::mjcf, [](fuzzing::Mutator& m, const std::string& text) { return m.values(text); }, rounds() / 3);
}
TEST(Fuzz, BytesOfTables) {
  fuzz(arms::table, [](fuzzing::Mutator& m, const std::string& text) { return m.bytes(text); });
}
TEST(Fuzz, ValuesOfTables) {
  fuzz(arms::table, [](fuzzing::Mutator& m, const std::string& text) { return m.values(text); });
}

}  // namespace
