// The errors of one robot in one number system: the kernels' own source against quadruple precision.
#pragma once

#include <axial/fixed.hpp>
#include <host_sim/figures/errors/errors.hpp>
#include <host_sim/figures/errors/given.hpp>
#include <host_sim/tools/analysis/error_scales.hpp>
#include <host_sim/tools/analysis/error_statistics.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <stdexcept>

namespace errors {

/// Every number of a result, exactly, in the order of the reference.
template <class S, class T>
class Numbers {
 public:
  template <Job job, class Result>
  static Vector of(const Result& result) {
    Numbers numbers;
    if constexpr (job == Job::mass_matrix)
      numbers.add_triangle(result);
    else if constexpr (job == Job::pose)
      numbers.add_pose(result);
    else if constexpr (job == Job::jacobian)
      numbers.add_columns(result);
    else if constexpr (job == Job::torque_derivatives)
      numbers.add_joints(result.tau), numbers.add_matrices(result.M, result.dtau_dq, result.dtau_dqd);
    else if constexpr (job == Job::acceleration_derivatives)
      numbers.add_matrices(result.M_inverse, result.dqdd_dq, result.dqdd_dqd), numbers.add_joints(result.qdd);
    else if constexpr (job == Job::motors)
      numbers.add_joints(result.tau_m), numbers.add_joints(result.theta), numbers.add_joints(result.thetad),
          numbers.add_joints(result.tau_l);
    else
      numbers.add_joints(result);
    return numbers.all_;
  }

 private:
  static constexpr int n = axial::joint_count<S>;

  template <class Values>
  void add_joints(const Values& values) {
    for (int i = 0; i < n; ++i)
      all_.push_back(exact_of(values, i));
  }
  template <class Matrix>
  void add_row(const Matrix& matrix, int i, int columns) {
    for (int j = 0; j < columns; ++j)
      if constexpr (axial::is_stored_v<T>)
        all_.push_back(exact(matrix(i, j), matrix.exponent(i, j)));
      else
        all_.push_back(exact(matrix(i, j), 0));
  }
  template <class Matrix>
  void add_triangle(const Matrix& matrix) {
    for (int i = 0; i < n; ++i)
      add_row(matrix, i, i + 1);
  }
  template <class Matrix>
  void add_square(const Matrix& matrix) {
    for (int i = 0; i < n; ++i)
      add_row(matrix, i, n);
  }
  template <class Symmetric, class ByPosition, class ByVelocity>
  void add_matrices(const Symmetric& symmetric, const ByPosition& by_position, const ByVelocity& by_velocity) {
    add_triangle(symmetric), add_square(by_position), add_square(by_velocity);
  }
  template <class Vec>
  void add_vector(const Vec& v, int exponent) {
    all_.insert(all_.end(), {exact(v.x, exponent), exact(v.y, exponent), exact(v.z, exponent)});
  }
  template <class Pose>
  void add_pose(const Pose& pose) {
    add_vector(pose.rotation.x, direction()), add_vector(pose.rotation.y, direction());
    add_vector(pose.rotation.z, direction()), add_vector(pose.position, length());
  }
  template <class Columns>
  void add_columns(const Columns& columns) {
    int room = 0;  // columns by drives that joints share may be sums
    if constexpr (axial::is_stored_v<T>) room = axial::column_headroom<S>;
    for (int j = 0; j < n; ++j)
      add_vector(columns[j].angular, direction() - room), add_vector(columns[j].linear, length() - room);
  }
  static constexpr int direction() {
    if constexpr (axial::is_stored_v<T>) return axial::direction_exponent<T>;
    return 0;
  }
  static constexpr int length() {
    if constexpr (axial::is_stored_v<T>) return axial::length_exponent<S, T>;
    return 0;
  }

  Vector all_;
};

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

/// The blocks of a result apart.
class Blocks {
 public:
  Blocks(Job job, std::size_t joints, const std::vector<double>& scales) : scales_(scales) {
    for (const auto& block : host_sim::blocks_of(scaled_as(job), joints)) {
      ends_.push_back((ends_.empty() ? 0 : ends_.back()) + block.count);
      blocks_.push_back({block.name, 0.0, 0.0, 0.0, 0.0});
    }
    in_states_.resize(blocks_.size());
  }
  void add(const Vector& difference, const Vector& exact) {
    std::size_t begin = 0;
    for (std::size_t b = 0; b < blocks_.size(); begin = ends_[b++]) {
      const double off = largest(difference, begin, ends_[b]), here = largest(exact, begin, ends_[b]);
      blocks_[b].error = larger(blocks_[b].error, off / scales_[begin]);
      blocks_[b].error_uncancelled = larger(blocks_[b].error_uncancelled, off / std::max(here, scales_[begin] / 100));
      if (here > 0.0) in_states_[b].push_back(off / here <= DBL_MAX ? off / here : HUGE_VAL);
    }
  }
  std::vector<Block> all() {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      auto& errors = in_states_[b];
      if (errors.empty()) continue;
      std::sort(errors.begin(), errors.end());
      blocks_[b].error_in_state = errors.back();
      blocks_[b].error_in_most_states = errors[(errors.size() - 1) * 99 / 100];
    }
    return blocks_;
  }

 private:
  static double largest(const Vector& values, std::size_t begin, std::size_t end) {
    double most = 0.0;
    for (std::size_t i = begin; i < end; ++i)
      most = larger(most, static_cast<double>(oracle::abs(values[i])));
    return most;
  }
  /// NaN if either is.
  static double larger(double a, double b) { return a != a || b <= a ? a : b; }

  const std::vector<double>& scales_;
  std::vector<std::size_t> ends_;
  std::vector<Block> blocks_;
  std::vector<std::vector<double>> in_states_;  // of each block, the error of each state
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
        host_sim::note_size(most, bound[i] / scales[std::size_t(i)]);
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

inline void refuse_bad(const axial::Status& status, const Kernel& kernel) {
  if (status.ok()) return;
  throw std::runtime_error(kernel.robot + ", " + kernel.algorithm + " in " + kernel.scalar + ": status " +
                           std::to_string(static_cast<int>(status.code)));
}

/// What has no row where joints share drives: elastic joints; in fixed point loops, derivatives of forward dynamics,
/// and forward dynamics but that of 32 bits. Nor, in fixed point, derivatives of forward dynamics of more than eight
/// joints.
template <class Algorithm, class S, class T>
constexpr bool is_offered() {
  constexpr bool fixed = axial::is_stored_v<T>;
  constexpr int joints = axial::joint_count<S>;
  if (fixed && job_of<Algorithm> == Job::acceleration_derivatives && joints > 8) return false;
  if (!axial::detail::shares_drives_in<typename axial::scene_of<S>::Robot>) return true;
  using Run = axial::scene_of<typename SceneOfKernel<Algorithm, S>::type>;
  constexpr bool by_links = Run::template has<axial::ArticulatedBody> || Run::template has<axial::SplitArticulatedBody>;
  constexpr bool other = fixed && (sizeof(T) != 4 || by_links);
  constexpr Job job = job_of<Algorithm>;
  return job != Job::motors && !(fixed && job == Job::acceleration_derivatives) &&
         !(other && job == Job::acceleration) && !(fixed && axial::scene_of<S>::template has<axial::Looped>);
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
  Blocks blocks(job, axial::joint_count<R>, reference.scales(job));
  int judged = 0;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const bool limited = job == Job::acceleration || (job == Job::acceleration_derivatives && axial::is_stored_v<T>);
    if (limited && !all.declared(k)) continue;
    const auto result = Algorithm::template run<S>(in_numbers<R, T>(all.drawn()[k]));
    if constexpr (job == Job::acceleration && axial::is_stored_v<T>)
      if (axial::detail::shares_drives_in<typename axial::scene_of<S>::Robot> &&
          result.status.code == axial::Status::Code::position_limit)
        continue;  // inside the drives' limits a turning joint may be beyond its own
    if constexpr (job == Job::acceleration) refuse_bad(result.status, kernel);
    if constexpr (job == Job::acceleration_derivatives) refuse_bad(result.qdd.status, kernel);
    const Vector off = difference(Numbers<Run, T>::template of<job>(result), wanted[k]);
    errors.add(off), ++judged;
    if constexpr (job == Job::acceleration) torques.add(reference.torque_of(k, off));
    if constexpr (has_blocks(job)) blocks.add(off, wanted[k]);
  }
  const auto proved = certified<job, Algorithm, Run, T>(reference.scales(job));
  Row row{kernel, judged, errors.largest(), errors.rms(), {}, proved, {}, axial::joint_count<R>};
  if (job == Job::acceleration) row.error_torque = torques.largest();
  if (has_blocks(job)) row.blocks = blocks.all();
  return row;
}

/// Adds the row of a kernel that is offered.
template <class Algorithm, class S, class T>
void add_row(std::vector<Row>& rows, const Kernel& kernel) {
  if constexpr (is_offered<Algorithm, S, T>()) rows.push_back(row_of<Algorithm, S, T>(kernel));
}

}  // namespace errors
