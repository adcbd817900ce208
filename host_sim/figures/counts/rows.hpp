// What every algorithm costs for every robot and count model.
#pragma once

#include <axial/scalar/counting.hpp>

#include <string>
#include <vector>

namespace counts {

/// One algorithm, one robot.
struct Row {
  std::string robot, algorithm, parameters;
  axial::Operations cost;
  std::string route = {};  ///< of forward dynamics, else empty
};

/// Rows of robot R: gravity, and rotors where it declares them. Each robot is a source of its own (robot.cpp.in).
template <class R>
std::vector<Row> rows_of();

/// Rows of every robot and count model, in the order of robots/robots.hpp and robots/models/models.hpp. An empty name
/// stands for all; throws for an unknown one.
std::vector<Row> rows(const std::string& robot = {});

}  // namespace counts
