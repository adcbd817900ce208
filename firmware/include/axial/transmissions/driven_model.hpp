// A run-time model whose joints share drives: Model<N, ..., SharedDrives>.
#pragma once

#include <axial/links/model.hpp>
#include <axial/transmissions/driven_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
/// The scene of a model's joints: what belongs to drives is left to them.
template <class Scene>
struct SceneOfModelJoints;
template <class M, class... Features>
struct SceneOfModelJoints<Scene<M, Features...>> {
  using type = typename WithoutDrives<Scene<M>, Features...>::type;
};
}  // namespace detail

/// What kernels get for it: as DrivenLinks, with G filled at run time.
template <class SceneType, class ScalarType, class JointLinks, class DriveLinks, int N>
class DrivenModelLinks : public driven::PlainDrives<ScalarType> {
 public:
  using Scene = SceneType;                         ///< of the drives
  using Scalar = ScalarType;                       ///< the number
  using Value = ScalarType;                        ///< as joint values hold it
  using JointScene = typename JointLinks::Scene;   ///< of the joints
  using JointRobot = typename JointScene::Robot;   ///< the joints
  using JointValues = Joints<JointRobot, Scalar>;  ///< one per joint
  static constexpr bool unrolled = false;          ///< loops walk over joints and drives
  static constexpr int capacity = N;               ///< number of drives, at most

  /// The links refer to the model.
  constexpr DrivenModelLinks(const JointLinks& joints, const DriveLinks& drives, const DriveMatrix<N>& matrix)
      : joints_(joints), drives_(drives), matrix_(matrix) {}

  /// The joints, as links of their own that any recursion walks over.
  template <class Recursion = recursion::NewtonEuler>
  constexpr const JointLinks& joints() const {
    return joints_;
  }
  constexpr const DriveLinks& drives() const { return drives_; }  ///< rotor and friction of each drive
  constexpr int size() const { return matrix_.drives; }           ///< number of drives
  constexpr int joint_count() const { return joints_.size(); }    ///< number of joints
  constexpr int owner(int k) const { return matrix_.owner[k]; }   ///< index of the joint that owns drive k
  /// G(joint, drive) as a number.
  constexpr Scalar ratio(int joint, int drive) const { return number(matrix_.ratio[joint][drive]); }
  /// G u + q0.
  template <class U>
  constexpr JointValues positions(const U& u) const {
    JointValues q = rates(u);
    for (int i = 0; i < joint_count(); ++i)
      q[i] = q[i] + number(matrix_.offset[i]);
    return q;
  }
  /// G times speeds or accelerations of drives.
  template <class U>
  constexpr JointValues rates(const U& ud) const {
    JointValues qd{};
    for (int i = 0; i < joint_count(); ++i)
      for (int k = 0; k < size(); ++k)
        if (matrix_.is_moved(i, k)) qd[i] = qd[i] + number(matrix_.ratio[i][k]) * ud[k];
    return qd;
  }
  using driven::PlainDrives<ScalarType>::rates;
  /// What drive k feels of values of the joints.
  template <class Values>
  constexpr Scalar actuator_effort(int k, const Values& values) const {
    Scalar sum(Zero{});
    for (int i = 0; i < joint_count(); ++i)
      if (matrix_.is_moved(i, k)) sum = sum + number(matrix_.ratio[i][k]) * values[i];
    return sum;
  }
  /// What every drive feels of values of the joints.
  template <class Values>
  constexpr Joints<JointRobot, Scalar> actuator_efforts(const Values& values) const {
    Joints<JointRobot, Scalar> all{};
    for (int k = 0; k < size(); ++k)
      all[k] = actuator_effort(k, values);
    return all;
  }
  /// Rates for a kernel.
  template <class U>
  constexpr auto kernel_rates(const U& ud) const {
    return rates(ud);
  }
  /// A component of a Jacobian's column by drive k, from those by joints.
  template <class Get>
  constexpr Scalar column_part(int k, const Get& get) const {
    JointValues component{};
    for (int i = 0; i < joint_count(); ++i)
      component[i] = get(i);
    return actuator_effort(k, component);
  }
  /// Calls f(k) for every drive.
  template <class F>
  constexpr void each_drive(const F& f) const {
    for (int k = 0; k < size(); ++k)
      f(k);
  }
  /// m = G^T M G and the rotors, M of the joints.
  template <class M, class Drives>
  constexpr void reduce(const M& joints, Drives& m) const {
    for (int l = 0; l < size(); ++l) {
      JointValues column{};  // M G
      for (int i = 0; i < joint_count(); ++i)
        for (int j = 0; j < joint_count(); ++j)
          if (matrix_.is_moved(j, l)) column[i] = column[i] + joints(i, j) * number(matrix_.ratio[j][l]);
      for (int k = l; k < size(); ++k)
        m(k, l) = actuator_effort(k, column);
      m(l, l) = m(l, l) + drives_.link(l).rotor();
    }
  }

 private:
  static constexpr Scalar number(double x) { return NumberTraits<Scalar>::constant(x); }

  JointLinks joints_;
  DriveLinks drives_;
  const DriveMatrix<N>& matrix_;
};

/// True for DrivenModelLinks, which stand for joints that share drives.
template <class S, class T, class J, class D, int N>
inline constexpr bool is_driven<DrivenModelLinks<S, T, J, D, N>> = true;

namespace detail {

/// Which drives move which joints, and what each drive is by itself.
template <class Model, int N>
struct ModelDrives<Model, N, true> {
  constexpr bool take(const LinkParameters& link, int index) {
    given_[index] = link, count_ = index + 1;
    matrix_ = drive_matrix_of(given_);
    while (matrix_.drives > 0 && matrix_.owner[matrix_.drives - 1] >= count_)  // links that are not there yet
      --matrix_.drives;
    for (int k = 0; k < matrix_.drives; ++k) {
      LinkParameters drive = drive_by_itself(given_[matrix_.owner[k]], false);
      drive.rotor_carrier = LinkParameters::previous;
      rotors_[k] = link_constants(drive, k - 1), frictions_[k] = drive_constants(drive);
    }
    return true;
  }
  constexpr int size(int) const { return matrix_.drives; }
  constexpr bool sound(int joints) const {
    for (int i = 0; i < joints; ++i) {
      if (!matrix_.is_there(i) || matrix_.mover_of(i) < 0) return false;
      const JointDrives& drives = given_[i].drives;
      for (int n = 0; n < drives.count; ++n)
        if (drives.of[n] >= joints) return false;
    }
    return matrix_.independent;
  }
  template <class T>
  constexpr auto links(const Model& model) const {
    using Scene = typename Model::Scene;
    using Joint = typename SceneOfModelJoints<Scene>::type;
    const auto joints = model.template joint_links<Joint, T>();
    const TableLinks<Scene, T, double, N> drives(rotors_, frictions_, matrix_.drives, nowhere_);
    return DrivenModelLinks<Scene, T, std::decay_t<decltype(joints)>, std::decay_t<decltype(drives)>, N>(joints, drives,
                                                                                                         matrix_);
  }

 private:
  LinkParameters given_[N] = {};
  DriveMatrix<N> matrix_{};
  TreeLinkConstants<double> rotors_[N] = {};
  DriveConstants<double> frictions_[N] = {};
  Placement nowhere_{};
  int count_ = 0;
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
