#include <bench/peers.hpp>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainhdsolver_vereshchagin.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <oracle/kdl_model.hpp>
#include <stdexcept>

namespace bench {
namespace {

KDL::Vector vector_of(const oracle::Vec3<double>& v) { return {v.x, v.y, v.z}; }

void check(int error) {
  if (error < 0) throw std::runtime_error("a KDL solver failed with error " + std::to_string(error));
}

struct KdlState {
  KDL::JntArray q, qd, qdd, tau;
};

std::vector<KdlState> kdl_states(const States& states) {
  const auto values = [&](const std::vector<double>& all, int state) {
    KDL::JntArray result(static_cast<unsigned>(states.joints));
    for (unsigned i = 0; i < result.rows(); ++i)
      result(i) = all[std::size_t(state) * result.rows() + i];
    return result;
  };
  std::vector<KdlState> result;
  for (int k = 0; k < states.count; ++k)
    result.push_back({values(states.q, k), values(states.qd, k), values(states.qdd, k), values(states.tau, k)});
  return result;
}

// Solve: a callable (const KdlState&), whose result values() lists.
class Kdl : public Contender {
 public:
  Kdl(const oracle::Chain<double>& chain, const States& states)
      : model_(oracle::to_kdl(chain)),
        states_(kdl_states(states)),
        no_wrenches_(model_.getNrOfSegments(), KDL::Wrench::Zero()),
        none_(model_.getNrOfJoints()),
        answer_(model_.getNrOfJoints()) {}

  void run(int first, int count) override {
    for (int k = first; k < first + count; ++k)
      solve(states_[std::size_t(k)]);
  }
  std::vector<double> result(int state) override {
    solve(states_[std::size_t(state)]);
    return answer();
  }

 protected:
  virtual void solve(const KdlState& state) = 0;
  virtual std::vector<double> answer() const {
    return std::vector<double>(answer_.data.data(), answer_.data.data() + answer_.rows());
  }

  KDL::Chain model_;
  std::vector<KdlState> states_;
  KDL::Wrenches no_wrenches_;
  KDL::JntArray none_, answer_;
};

class KdlInverse : public Kdl {
 public:
  KdlInverse(Algorithm algorithm, const oracle::Chain<double>& chain, const States& states)
      : Kdl(chain, states), algorithm_(algorithm), solver_(model_, vector_of(chain.gravity)) {}

 protected:
  void solve(const KdlState& s) override {
    const auto& qd = algorithm_ == Algorithm::gravity ? none_ : s.qd;
    const auto& qdd = algorithm_ == Algorithm::inverse_dynamics ? s.qdd : none_;
    check(solver_.CartToJnt(s.q, qd, qdd, no_wrenches_, answer_));
  }

 private:
  Algorithm algorithm_;
  KDL::ChainIdSolver_RNE solver_;
};

class KdlMassMatrix : public Kdl {
 public:
  KdlMassMatrix(const oracle::Chain<double>& chain, const States& states)
      : Kdl(chain, states),
        solver_(model_, vector_of(chain.gravity)),
        matrix_(static_cast<int>(model_.getNrOfJoints())) {}

 protected:
  void solve(const KdlState& s) override { check(solver_.JntToMass(s.q, matrix_)); }
  std::vector<double> answer() const override {
    std::vector<double> result;
    for (unsigned i = 0; i < matrix_.rows(); ++i)
      for (unsigned j = 0; j < matrix_.columns(); ++j)
        result.push_back(matrix_(i, j));
    return result;
  }

 private:
  KDL::ChainDynParam solver_;
  KDL::JntSpaceInertiaMatrix matrix_;
};

class KdlForward : public Kdl {
 public:
  KdlForward(const oracle::Chain<double>& chain, const States& states)
      : Kdl(chain, states), solver_(model_, vector_of(chain.gravity)) {}

 protected:
  void solve(const KdlState& s) override { check(solver_.CartToJnt(s.q, s.qd, s.tau, no_wrenches_, answer_)); }

 private:
  KDL::ChainFdSolver_RNE solver_;
};

// Its gravity has the opposite sign.
class KdlVereshchagin : public Kdl {
 public:
  KdlVereshchagin(const oracle::Chain<double>& chain, const States& states)
      : Kdl(chain, states),
        solver_(model_, KDL::Twist(-vector_of(chain.gravity), KDL::Vector::Zero()), constraints),
        directions_(constraints),
        setpoints_(constraints),
        constraint_torques_(model_.getNrOfJoints()) {
    KDL::SetToZero(directions_);
  }

 protected:
  void solve(const KdlState& s) override {
    check(solver_.CartToJnt(s.q, s.qd, answer_, directions_, setpoints_, no_wrenches_, s.tau, constraint_torques_));
  }

 private:
  static constexpr unsigned constraints = 1;  // the fewest that it takes; its direction is zero
  KDL::ChainHdSolver_Vereshchagin solver_;
  KDL::Jacobian directions_;
  KDL::JntArray setpoints_, constraint_torques_;
};

}  // namespace

std::unique_ptr<Contender> make_kdl(Algorithm algorithm, const oracle::Chain<double>& chain, const States& states) {
  if (algorithm == Algorithm::mass_matrix) return std::make_unique<KdlMassMatrix>(chain, states);
  if (is_forward(algorithm)) return std::make_unique<KdlForward>(chain, states);
  return std::make_unique<KdlInverse>(algorithm, chain, states);
}

std::unique_ptr<Contender> make_vereshchagin(const oracle::Chain<double>& chain, const States& states) {
  return std::make_unique<KdlVereshchagin>(chain, states);
}

}  // namespace bench
