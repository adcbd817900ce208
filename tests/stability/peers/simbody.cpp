#include <Simbody.h>

#include <stability/peers/engine.hpp>
#include <stdexcept>

namespace stability {
namespace {

using SimTK::Vec3;

Vec3 vec3(const oracle::Vec3<double>& v) { return {v.x, v.y, v.z}; }

class Simbody : public Engine {
 public:
  explicit Simbody(const oracle::Chain<double>& chain) : gravity_(vec3(chain.gravity)), matter_(system_) {
    SimTK::MobilizedBody parent = matter_.Ground();
    for (const auto& link : chain.links) {
      if (link.rotor_inertia != 0.0) throw std::invalid_argument("no rotor inertia here");
      masses_.push_back(link.mass), centres_.push_back(vec3(link.com));
      parent = add(parent, link);
    }
    state_ = system_.realizeTopology();
    system_.realizeModel(state_);
  }

  oracle::Vector<double> accelerations(const oracle::Vector<double>& q, const oracle::Vector<double>& qd,
                                       const oracle::Vector<double>& tau) override {
    const int n = static_cast<int>(q.size());
    SimTK::Vector efforts(n);
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      state_.updQ()[i] = q[k], state_.updU()[i] = qd[k], efforts[i] = tau[k];
    }
    system_.realize(state_, SimTK::Stage::Dynamics);
    SimTK::Vector_<SimTK::SpatialVec> forces(n + 1, SimTK::SpatialVec(Vec3(0), Vec3(0))), unused;
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      matter_.getMobilizedBody(SimTK::MobilizedBodyIndex(i + 1))
          .applyForceToBodyPoint(state_, centres_[k], masses_[k] * gravity_, forces);
    }
    SimTK::Vector answer;
    matter_.calcAcceleration(state_, efforts, forces, answer, unused);
    oracle::Vector<double> result;
    for (int i = 0; i < n; ++i)
      result.push_back(answer[i]);
    return result;
  }

 private:
  SimTK::MobilizedBody add(SimTK::MobilizedBody& parent, const oracle::Link<double>& link) {
    const auto& I = link.inertia;
    const SimTK::Inertia about_com(I.c0.x, I.c1.y, I.c2.z, I.c0.y, I.c0.z, I.c1.z);
    const Vec3 com = vec3(link.com);
    const SimTK::MassProperties mass(link.mass, com, about_com.shiftFromMassCenter(com, link.mass));
    const SimTK::Rotation about_x(link.alpha, SimTK::XAxis), about_z(link.theta, SimTK::ZAxis);
    const SimTK::Transform fixed =
        SimTK::Transform(about_x, Vec3(link.a, 0, 0)) * SimTK::Transform(about_z, Vec3(0, 0, link.d));
    if (link.type == oracle::Joint::revolute)
      return SimTK::MobilizedBody::Pin(parent, fixed, SimTK::Body::Rigid(mass), SimTK::Transform());
    const SimTK::Transform x_to_z(SimTK::Rotation(-SimTK::Pi / 2, SimTK::YAxis));  // its slides go along x
    return SimTK::MobilizedBody::Slider(parent, fixed * x_to_z, SimTK::Body::Rigid(mass), x_to_z);
  }

  Vec3 gravity_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::State state_;
  std::vector<double> masses_;
  std::vector<Vec3> centres_;
};

}  // namespace

std::vector<Peer> simbody_peers() {
  return {{"simbody", Scalar::in_double, [](const oracle::Chain<double>& chain) -> std::unique_ptr<Engine> {
             return std::make_unique<Simbody>(chain);
           }}};
}

}  // namespace stability
