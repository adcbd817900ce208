// What the property tests share: library values as oracle vectors, seeded states.
#pragma once

#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <oracle/compare.hpp>
#include <oracle/convert.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/random_chain.hpp>

namespace property {

template <class S, class T>
axial::Joints<S, T> joints(const oracle::Vector<double>& source) {
  axial::Joints<S, T> result{};
  for (std::size_t i = 0; i < source.size(); ++i)
    result[static_cast<int>(i)] = static_cast<T>(source[i]);
  return result;
}
template <class S, class T>
oracle::Vector<T> vector(const axial::Joints<S, T>& source, int size = axial::joint_count<S>) {
  return oracle::Vector<T>(source.values, source.values + size);
}
template <class S, class T>
oracle::Matrix<T> matrix(const axial::MassMatrix<S, T>& source, int size = axial::joint_count<S>) {
  oracle::Matrix<T> result(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      result(i, j) = source(i, j);
  return result;
}

/// A state inside a robot's declared limits; all numbers are floats.
struct State {
  oracle::Vector<double> q, qd, qdd;
};
template <class Robot>
State random_state(oracle::RandomChains& random) {
  State s;
  for (int i = 0; i < Robot::chain.size; ++i) {
    const auto& l = Robot::chain.links[i];
    s.q.push_back(random.uniform(l.position_min, l.position_max));
    s.qd.push_back(random.uniform(-l.speed_limit, l.speed_limit));
    s.qdd.push_back(random.uniform(-l.acceleration_limit, l.acceleration_limit));
  }
  return s;
}

}  // namespace property
