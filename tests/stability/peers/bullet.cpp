#include <dlfcn.h>

#include <stability/peers/bullet_module.hpp>
#include <stability/peers/engine.hpp>
#include <stdexcept>

namespace stability {
namespace {

using Accelerations = decltype(&axial_bullet_accelerations);

Accelerations load(const char* file) {
  void* const module = dlmopen(LM_ID_NEWLM, file, RTLD_NOW | RTLD_LOCAL);
  void* const symbol = module == nullptr ? nullptr : dlsym(module, "axial_bullet_accelerations");
  if (symbol == nullptr) throw std::runtime_error(dlerror());
  return reinterpret_cast<Accelerations>(symbol);
}

class Bullet : public Engine {
 public:
  Bullet(Accelerations solve, const oracle::Chain<double>& chain) : solve_(solve) {
    for (const auto& link : chain.links) {
      const auto& I = link.inertia;
      const bool principal = I.c0.y == 0.0 && I.c0.z == 0.0 && I.c1.z == 0.0;
      if (link.rotor_inertia != 0.0 || link.theta != 0.0 || !principal)
        throw std::invalid_argument("no such link here");
      const double slides = link.type == oracle::Joint::prismatic ? 1.0 : 0.0;
      for (const double x : {slides, link.alpha, link.a, link.d, link.mass, link.com.x, link.com.y, link.com.z, I.c0.x,
                             I.c1.y, I.c2.z, 0.0, 0.0, 0.0})
        chain_.push_back(x);
    }
    gravity_[0] = chain.gravity.x, gravity_[1] = chain.gravity.y, gravity_[2] = chain.gravity.z;
  }
  oracle::Vector<double> accelerations(const oracle::Vector<double>& q, const oracle::Vector<double>& qd,
                                       const oracle::Vector<double>& tau) override {
    oracle::Vector<double> result(q.size());
    solve_(static_cast<int>(q.size()), chain_.data(), gravity_, q.data(), qd.data(), tau.data(), result.data());
    return result;
  }

 private:
  Accelerations solve_;
  std::vector<double> chain_;
  double gravity_[3];
};

Peer peer(const char* name, Scalar scalar, const char* file) {
  const Accelerations solve = load(file);
  return {name, scalar, [solve](const oracle::Chain<double>& chain) -> std::unique_ptr<Engine> {
            return std::make_unique<Bullet>(solve, chain);
          }};
}

}  // namespace

std::vector<Peer> bullet_peers() {
  return {peer("bullet", Scalar::in_double, AXIAL_BULLET_DOUBLE), peer("bullet", Scalar::in_float, AXIAL_BULLET_FLOAT)};
}

}  // namespace stability
