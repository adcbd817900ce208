// Console output of a kernels image, made up for the two-link arm, through to the rows of on_board.
#include <host_sim/boards/on_board/kernel_output.hpp>
#include <host_sim/boards/on_board/rows.hpp>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace {

using host_sim::KernelOutput;
using host_sim::parse_kernel_output;

// q = (0, 0.5), qd = (1, -2), qdd = (0, 0) as float bits; results 1.5 and -2 in both scalars.
const std::string head =
    "board,stm32f405,instructions,1\nrobot,2\nstate,0,00000000,3f000000,3f800000,c0000000,00000000,00000000\n";
const std::string rows =
    "inverse_dynamics,planar2r,float,0,300,3fc00000,c0000000\n"
    "inverse_dynamics,planar2r,double,0,9000,3ff8000000000000,c000000000000000\n";

TEST(KernelOutput, ReadsStatesAndResultsFromTheirBits) {
  const KernelOutput output = parse_kernel_output(head + rows + "stack,128\nend\n");
  EXPECT_EQ(output.counter, "instructions");
  ASSERT_EQ(output.states.size(), 1u);
  EXPECT_EQ(output.states[0].q, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(output.states[0].qd, (std::vector<double>{1.0, -2.0}));
  ASSERT_EQ(output.evaluations.size(), 2u);
  for (const auto& e : output.evaluations)
    EXPECT_EQ(e.result, (std::vector<double>{1.5, -2.0})) << e.scalar;
  EXPECT_EQ(output.evaluations[1].count, 9000u);
}

TEST(KernelOutput, RefusesAnOutputThatEndsEarly) { EXPECT_THROW(parse_kernel_output(head + rows), std::runtime_error); }

TEST(KernelOutput, RefusesLinesOfAnotherFormat) {
  for (const char* line : {"hard fault\n", "bias,planar2r,float,7,300,3fc00000\n", "bias,planar2r,float,0,300,3fc0\n",
                           "state,1,00000000\n", "bias,planar2r,float,0,x,3fc00000\n"})
    EXPECT_THROW(parse_kernel_output(head + line + "end\n"), std::runtime_error) << line;
}

/// Rows as the image would print them if it were exact: the oracle's own torque, once off by a millionth.
TEST(OnBoardRows, ErrorIsRelativeToTheJointsLargestTorque) {
  const host_sim::Robot robot = host_sim::find_robot("planar2r");
  KernelOutput output = parse_kernel_output(head + rows + "end\n");
  const auto exact = host_sim::exact_torque(robot, output.states[0]);
  for (auto& e : output.evaluations)
    e.result = exact;
  output.evaluations[0].result[1] *= 1.0 + 1e-6;
  const auto report = host_sim::rows_of(output, robot, "stm32f405");
  ASSERT_EQ(report.size(), 2u);  // by kernel and scalar: double comes first
  EXPECT_EQ(report[0].error, 0.0);
  EXPECT_NEAR(report[1].error, 1e-6, 1e-15);
}

TEST(OnBoardRows, JsonHasTheDocumentedFields) {
  const KernelOutput output = parse_kernel_output(head + rows + "end\n");
  const auto json = to_json(rows_of(output, host_sim::find_robot("planar2r"), "stm32f405"));
  for (const char* field : {"subject", "robot", "scalar", "variant", "board", "error", "work", "unit_of_work"})
    EXPECT_TRUE(json.at(0).contains(field)) << field;
}

}  // namespace
