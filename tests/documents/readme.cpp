// README.md: a whole program. It finds qdd again and a safe torque, or returns 1.
#include <gtest/gtest.h>
#define main readme_main
#include "readme-1.inc"
#undef main

TEST(Readme, ExampleRuns) { EXPECT_EQ(readme_main(), 0); }
