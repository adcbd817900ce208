#include <host_sim/tools/output/table.hpp>

#include <gtest/gtest.h>

namespace {

using host_sim::Table;

Table table() {
  Table table({"name", "count"});
  table.add({"a", "1 024"});
  table.add({"longer", "7"});
  return table;
}

TEST(Table, TextAlignsWordsLeftAndNumbersRight) {
  EXPECT_EQ(table().text(),
            "name    count\n"
            "------  -----\n"
            "a       1 024\n"
            "longer      7\n");
}

TEST(Table, GroupsOfThree) {
  EXPECT_EQ(host_sim::grouped(0), "0");
  EXPECT_EQ(host_sim::grouped(999), "999");
  EXPECT_EQ(host_sim::grouped(1000), "1 000");
  EXPECT_EQ(host_sim::grouped(1048576), "1 048 576");
}

TEST(Table, SignificantDigits) {
  EXPECT_EQ(host_sim::significant(0.000123456), "0.000123");
  EXPECT_EQ(host_sim::significant(2.0 / 3.0, 9), "0.666666667");
}

}  // namespace
