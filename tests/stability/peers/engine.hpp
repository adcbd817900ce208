// Forward dynamics of other people's engines, as Debian packs them, on a serial chain of the oracle.
#pragma once

#include <functional>
#include <memory>
#include <oracle/chain.hpp>
#include <stability/routes.hpp>
#include <string>

namespace stability {

/// An engine that holds one chain.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual oracle::Vector<double> accelerations(const oracle::Vector<double>& q, const oracle::Vector<double>& qd,
                                               const oracle::Vector<double>& tau) = 0;
};

struct Peer {
  std::string name;
  Scalar scalar;
  /// Throws std::invalid_argument for a chain that the engine has no model of (rotor inertia, say).
  std::function<std::unique_ptr<Engine>(const oracle::Chain<double>&)> load;
};

/// Orocos KDL: composite bodies with L D L^T (kdl), and its articulated bodies (kdl_vereshchagin).
std::vector<Peer> kdl_peers();
std::vector<Peer> dart_peers();
std::vector<Peer> simbody_peers();
/// Bullet's btMultiBody in both of its builds; each is loaded into a namespace of its own, as their symbols are the
/// same.
std::vector<Peer> bullet_peers();

}  // namespace stability
