// The errors of one robot in one number system: the kernels' own source against quadruple precision.
#pragma once

#include <axial/fixed.hpp>
#include <host_sim/analysis/error_statistics.hpp>
#include <host_sim/errors/errors.hpp>
#include <host_sim/errors/given.hpp>

#include <algorithm>
#include <stdexcept>

namespace errors {

/// Every number of a result, exactly, in the order of the reference.
template <Job job, class S, class T, class Result>
Vector numbers_of(const Result& result) {
  constexpr int n = axial::joint_count<S>;
  Vector all;
  if constexpr (job == Job::mass_matrix) {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j)
        if constexpr (axial::is_stored_v<T>)
          all.push_back(exact(result(i, j), result.exponent(i, j)));
        else
          all.push_back(exact(result(i, j), 0));
  } else if constexpr (job == Job::pose || job == Job::jacobian) {
    int direction = 0, length = 0;
    if constexpr (axial::is_stored_v<T>)
      direction = axial::direction_exponent<T>, length = axial::length_exponent<S, T>;
    const auto append = [&](const auto& v, int exponent) {
      all.insert(all.end(), {exact(v.x, exponent), exact(v.y, exponent), exact(v.z, exponent)});
    };
    if constexpr (job == Job::pose) {
      append(result.rotation.x, direction), append(result.rotation.y, direction), append(result.rotation.z, direction);
      append(result.position, length);
    } else {
      for (int j = 0; j < n; ++j)
        append(result[j].angular, direction), append(result[j].linear, length);
    }
  } else {
    for (int i = 0; i < n; ++i)
      all.push_back(exact_of(result, i));
  }
  return all;
}

/// Of all numbers of all states, relative to their scales.
class Relative {
 public:
  explicit Relative(const std::vector<double>& scales) : scales_(scales) {}
  void add(const Vector& difference) {
    for (std::size_t i = 0; i < difference.size(); ++i)
      errors_.add(static_cast<double>(difference[i]) / (scales_[i] > 0.0 ? scales_[i] : 1.0), 0.0);
  }
  double largest() const { return errors_.largest(); }
  double rms() const { return errors_.rms(); }

 private:
  const std::vector<double>& scales_;
  host_sim::ErrorStatistics errors_;
};

inline Vector difference(Vector left, const Vector& right) {
  for (std::size_t i = 0; i < left.size(); ++i)
    left[i] -= right.at(i);
  return left;
}

/// What is proved of a torque, relative as the errors are.
template <Job job, class Algorithm, class S, class T>
std::optional<double> certified(const std::vector<double>& scales) {
  if constexpr (axial::is_stored_v<T> && (job == Job::torque || job == Job::bias || job == Job::gravity) &&
                !std::is_same_v<Algorithm, algorithms::torque_by_separation>) {
    double most = 0.0;
    const auto add = [&](const auto& bound) {
      for (int i = 0; i < axial::joint_count<S>; ++i)
        most = std::max(most, bound[i] / scales[std::size_t(i)]);
    };
    if constexpr (std::is_same_v<Algorithm, algorithms::closed_form>)
      add(axial::error_bound<S, T>(axial::algorithm::closed_form));
    else
      add(axial::error_bound<S, T>(axial::algorithm::inverse_dynamics));
    return most;
  } else {
    return {};
  }
}

template <class Result>
void refuse_bad_status(const Result& result, const Kernel& kernel) {
  if (result.status.ok()) return;
  throw std::runtime_error(kernel.robot + ", " + kernel.algorithm + " in " + kernel.scalar + ": status " +
                           std::to_string(static_cast<int>(result.status.code)));
}

/// Algorithm on scene S in numbers T.
template <class Algorithm, class S, class T>
Row row_of(const Kernel& kernel) {
  using R = axial::robot_of<S>;
  using Run = typename SceneOfKernel<Algorithm, S>::type;
  constexpr Job job = job_of<Algorithm>;
  auto& all = States<R, WordsOf<T>>::all();
  Reference& reference = all.reference();
  const auto& wanted = reference.results(job);
  Relative errors(reference.scales(job)), torques(reference.scales(Job::torque));
  int judged = 0;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (job == Job::acceleration && !all.declared(k)) continue;
    const auto result = Algorithm::template run<S>(in_numbers<R, T>(all.drawn()[k]));
    if constexpr (job == Job::acceleration) refuse_bad_status(result, kernel);
    const Vector off = difference(numbers_of<job, Run, T>(result), wanted[k]);
    errors.add(off), ++judged;
    if constexpr (job == Job::acceleration) torques.add(reference.torque_of(k, off));
  }
  Row row{kernel, judged, errors.largest(), errors.rms(), {}, certified<job, Algorithm, Run, T>(reference.scales(job))};
  if (job == Job::acceleration) row.error_torque = torques.largest();
  return row;
}

}  // namespace errors
