#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacdotsolver.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <oracle/kdl_chain.hpp>
#include <oracle/kdl_model.hpp>
#include <stdexcept>

namespace oracle {
namespace {

KDL::Vector kdl(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
Vec3<double> from_kdl(const KDL::Vector& v) { return {v.x(), v.y(), v.z()}; }

KDL::Frame kdl(const Pose<double>& pose) {
  return {KDL::Rotation(kdl(pose.rotation.c0), kdl(pose.rotation.c1), kdl(pose.rotation.c2)), kdl(pose.position)};
}
Pose<double> from_kdl(const KDL::Frame& frame) {
  return {{from_kdl(frame.M.UnitX()), from_kdl(frame.M.UnitY()), from_kdl(frame.M.UnitZ())}, from_kdl(frame.p)};
}

KDL::JntArray kdl(const Vector<double>& values) {
  KDL::JntArray result(static_cast<unsigned>(values.size()));
  for (unsigned i = 0; i < values.size(); ++i)
    result(i) = values[i];
  return result;
}
Vector<double> from_kdl(const KDL::JntArray& values) {
  return Vector<double>(values.data.data(), values.data.data() + values.rows());
}

KDL::RigidBodyInertia kdl_inertia(const Link<double>& link) {
  const Mat3<double>& I = link.inertia;
  const KDL::RotationalInertia about_com(I.c0.x, I.c1.y, I.c2.z, I.c0.y, I.c0.z, I.c1.z);
  return KDL::RigidBodyInertia(link.mass, kdl(link.com), about_com);
}

// A row's x-screw stands in the segment before it; only the first link's stands in its own joint.
KDL::Joint kdl_joint(const Link<double>& link, const KDL::Frame& first) {
  const double scale = 1.0, offset = 0.0, rotor = link.gear * link.gear * link.rotor_inertia;
  const bool turns = link.type == Joint::revolute;
  if (first == KDL::Frame::Identity())
    return KDL::Joint(turns ? KDL::Joint::RotZ : KDL::Joint::TransZ, scale, offset, rotor);
  return KDL::Joint(first.p, first.M.UnitZ(), turns ? KDL::Joint::RotAxis : KDL::Joint::TransAxis, scale, offset,
                    rotor);
}

KDL::Frame x_screw(const Chain<double>& chain, int i) {
  if (i >= chain.size()) return KDL::Frame::Identity();
  const KDL::Frame branch(KDL::Rotation::RotZ(chain[i].gamma), KDL::Vector(0.0, 0.0, chain[i].b));
  return branch * KDL::Frame::DH_Craig1989(chain[i].a, chain[i].alpha, 0.0, 0.0);
}

void check(int error) {
  if (error < 0) throw std::runtime_error("KDL solver failed");
}

}  // namespace

KDL::Chain to_kdl(const Chain<double>& chain) {
  KDL::Chain result;
  KDL::Frame first = x_screw(chain, 0);
  for (int i = 0; i < chain.size(); ++i) {
    if (chain[i].parent != i - 1) throw std::invalid_argument("to_kdl: serial chains only");
    const auto next = x_screw(chain, i + 1);
    const auto z_screw = KDL::Frame::DH_Craig1989(0.0, 0.0, chain[i].d, chain[i].theta);
    const auto joint = kdl_joint(chain[i], first);
    result.addSegment(KDL::Segment(joint, first * z_screw * next, next.Inverse() * kdl_inertia(chain[i])));
    first = KDL::Frame::Identity();
  }
  return result;
}

struct KdlChain::Solvers {
  explicit Solvers(const Chain<double>& chain)
      : source(chain),
        model(to_kdl(chain)),
        parameters(model, kdl(chain.gravity)),
        inverse(model, kdl(chain.gravity)),
        forward(model, kdl(chain.gravity)),
        position(model),
        jacobian(model) {}

  unsigned joints() const { return model.getNrOfJoints(); }
  KDL::Wrenches wrenches(const Wrench<double>& tip) const {
    KDL::Wrenches result(model.getNrOfSegments(), KDL::Wrench::Zero());
    result.back() = KDL::Wrench(kdl(tip.force), kdl(tip.moment));
    return result;
  }
  KDL::Frame last_link(const Vector<double>& q) {
    KDL::Frame pose;
    check(position.JntToCart(kdl(q), pose));
    return pose;
  }

  Chain<double> source;
  KDL::Chain model;
  KDL::ChainDynParam parameters;
  KDL::ChainIdSolver_RNE inverse;
  KDL::ChainFdSolver_RNE forward;
  KDL::ChainFkSolverPos_recursive position;
  KDL::ChainJntToJacSolver jacobian;
};

KdlChain::KdlChain(const Chain<double>& chain) : solvers_(std::make_unique<Solvers>(chain)) {}
KdlChain::~KdlChain() = default;

Pose<double> KdlChain::tool_pose(const Vector<double>& q) const {
  return from_kdl(kdl(solvers_->source.base) * solvers_->last_link(q) * kdl(solvers_->source.tool));
}

Jacobian<double> KdlChain::tool_jacobian(const Vector<double>& q) const {
  KDL::Jacobian J(solvers_->joints());
  check(solvers_->jacobian.JntToJac(kdl(q), J));
  J.changeRefPoint(solvers_->last_link(q).M * kdl(solvers_->source.tool.position));
  J.changeBase(kdl(solvers_->source.base).M);
  const int n = static_cast<int>(J.columns());
  Jacobian<double> result{{3, n}, {3, n}};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < 3; ++i) {
      result.linear(i, j) = J(static_cast<unsigned>(i), static_cast<unsigned>(j));
      result.angular(i, j) = J(static_cast<unsigned>(i + 3), static_cast<unsigned>(j));
    }
  return result;
}

Wrench<double> KdlChain::tool_bias_acceleration(const Vector<double>& q, const Vector<double>& qd) const {
  KDL::Chain with_tool = solvers_->model;
  with_tool.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::Fixed), kdl(solvers_->source.tool)));
  KDL::ChainJntToJacDotSolver solver(with_tool);
  solver.setHybridRepresentation();
  KDL::Twist rate;
  check(solver.JntToJacDot(KDL::JntArrayVel(kdl(q), kdl(qd)), rate));
  rate = kdl(solvers_->source.base).M * rate;
  return {from_kdl(rate.vel), from_kdl(rate.rot)};
}

Matrix<double> KdlChain::mass_matrix(const Vector<double>& q) const {
  KDL::JntSpaceInertiaMatrix H(static_cast<int>(solvers_->joints()));
  check(solvers_->parameters.JntToMass(kdl(q), H));
  const int n = static_cast<int>(H.rows());
  Matrix<double> M(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      M(i, j) = H(static_cast<unsigned>(i), static_cast<unsigned>(j));
  return M;
}

Vector<double> KdlChain::coriolis_torque(const Vector<double>& q, const Vector<double>& qd) const {
  KDL::JntArray c(solvers_->joints());
  check(solvers_->parameters.JntToCoriolis(kdl(q), kdl(qd), c));
  return from_kdl(c);
}

Vector<double> KdlChain::gravity_torque(const Vector<double>& q) const {
  KDL::JntArray g(solvers_->joints());
  check(solvers_->parameters.JntToGravity(kdl(q), g));
  return from_kdl(g);
}

Vector<double> KdlChain::inverse_dynamics(const Vector<double>& q, const Vector<double>& qd, const Vector<double>& qdd,
                                          const Wrench<double>& tip) const {
  KDL::JntArray tau(solvers_->joints());
  check(solvers_->inverse.CartToJnt(kdl(q), kdl(qd), kdl(qdd), solvers_->wrenches(tip), tau));
  return from_kdl(tau);
}

Vector<double> KdlChain::forward_dynamics(const Vector<double>& q, const Vector<double>& qd, const Vector<double>& tau,
                                          const Wrench<double>& tip) const {
  KDL::JntArray qdd(solvers_->joints());
  check(solvers_->forward.CartToJnt(kdl(q), kdl(qd), kdl(tau), solvers_->wrenches(tip), qdd));
  return from_kdl(qdd);
}

}  // namespace oracle
