#include <bench/peers.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <iostream>
#include <stdexcept>

namespace bench {
namespace {

namespace dd = dart::dynamics;

Eigen::Vector3d vector_of(const oracle::Vec3<double>& v) { return {v.x, v.y, v.z}; }

// Rx(alpha) Tx(a), and the constant part of Rz(theta) Tz(d).
Eigen::Isometry3d fixed_pose(const oracle::Link<double>& link) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.rotate(Eigen::AngleAxisd(link.alpha, Eigen::Vector3d::UnitX())).translate(Eigen::Vector3d(link.a, 0, 0));
  pose.rotate(Eigen::AngleAxisd(link.theta, Eigen::Vector3d::UnitZ())).translate(Eigen::Vector3d(0, 0, link.d));
  return pose;
}

dd::Inertia inertia_of(const oracle::Link<double>& link) {
  const auto& I = link.inertia;
  dd::Inertia inertia;
  inertia.setMass(link.mass);
  inertia.setLocalCOM(vector_of(link.com));
  inertia.setMoment(I.c0.x, I.c1.y, I.c2.z, I.c0.y, I.c0.z, I.c1.z);
  return inertia;
}

template <class Joint>
dd::BodyNode* add(dd::Skeleton& skeleton, dd::BodyNode* parent, const oracle::Link<double>& link, int i) {
  typename Joint::Properties joint;
  joint.mName = "joint" + std::to_string(i);
  joint.mAxis = Eigen::Vector3d::UnitZ();
  joint.mT_ParentBodyToJoint = fixed_pose(link);
  const dd::BodyNode::Properties body(dd::BodyNode::AspectProperties("link" + std::to_string(i), inertia_of(link)));
  return skeleton.createJointAndBodyNodePair<Joint>(parent, joint, body).second;
}

// DART warns of each massless link on std::cerr; that its results are right is checked later.
class Silence {
 public:
  Silence() : before_(std::cerr.rdbuf(nullptr)) {}
  ~Silence() {
    std::cerr.rdbuf(before_);
    std::cerr.clear();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::streambuf* before_;
};

dd::SkeletonPtr skeleton_of(const oracle::Chain<double>& chain) {
  const Silence silence;
  auto skeleton = dd::Skeleton::create();
  skeleton->setGravity(vector_of(chain.gravity));
  dd::BodyNode* parent = nullptr;
  for (int i = 0; i < chain.size(); ++i) {
    if (chain[i].rotor_inertia != 0.0) throw std::invalid_argument("DART has no rotor inertia");
    const bool turns = chain[i].type == oracle::Joint::revolute;
    parent = turns ? add<dd::RevoluteJoint>(*skeleton, parent, chain[i], i)
                   : add<dd::PrismaticJoint>(*skeleton, parent, chain[i], i);
  }
  return skeleton;
}

struct DartState {
  Eigen::VectorXd q, qd, x;
};

class Dart : public Contender {
 public:
  Dart(Algorithm algorithm, const oracle::Chain<double>& chain, const States& states)
      : algorithm_(algorithm), skeleton_(skeleton_of(chain)) {
    const auto values = [&](const std::vector<double>& all, int state) {
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(all.data() + state * states.joints, states.joints));
    };
    const auto& x = is_forward(algorithm) ? states.tau : states.qdd;
    for (int k = 0; k < states.count; ++k)
      states_.push_back({values(states.q, k), values(states.qd, k), values(x, k)});
  }

  void run(int first, int count) override {
    for (int k = first; k < first + count; ++k)
      solve(states_[std::size_t(k)]);
  }
  std::vector<double> result(int state) override {
    solve(states_[std::size_t(state)]);
    switch (algorithm_) {
      case Algorithm::inverse_dynamics:
        return list(skeleton_->getForces());
      case Algorithm::gravity:
        return list(skeleton_->getGravityForces());
      case Algorithm::bias:
        return list(skeleton_->getCoriolisAndGravityForces());
      case Algorithm::mass_matrix:
        return list(skeleton_->getMassMatrix());
      default:
        return list(skeleton_->getAccelerations());
    }
  }

 private:
  // Setting a position marks everything that depends on it as stale; the getters compute.
  void solve(const DartState& s) {
    skeleton_->setPositions(s.q);
    if (algorithm_ == Algorithm::gravity) return static_cast<void>(skeleton_->getGravityForces());
    if (algorithm_ == Algorithm::mass_matrix) return static_cast<void>(skeleton_->getMassMatrix());
    skeleton_->setVelocities(s.qd);
    if (algorithm_ == Algorithm::bias) return static_cast<void>(skeleton_->getCoriolisAndGravityForces());
    if (algorithm_ == Algorithm::inverse_dynamics) {
      skeleton_->setAccelerations(s.x);
      skeleton_->computeInverseDynamics();
    } else {
      skeleton_->setForces(s.x);
      skeleton_->computeForwardDynamics();
    }
  }
  static std::vector<double> list(const Eigen::MatrixXd& m) {  // symmetric, so either order
    return std::vector<double>(m.data(), m.data() + m.size());
  }

  Algorithm algorithm_;
  dd::SkeletonPtr skeleton_;
  std::vector<DartState> states_;
};

}  // namespace

std::unique_ptr<Contender> make_dart(Algorithm algorithm, const oracle::Chain<double>& chain, const States& states) {
  return std::make_unique<Dart>(algorithm, chain, states);
}

}  // namespace bench
