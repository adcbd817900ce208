// A contender of the benchmark as an engine: a state at a time.
#pragma once

#include <bench/contender.hpp>
#include <stability/peers/engine.hpp>

namespace stability {

/// Make: (const oracle::Chain<double>&, const bench::States&) -> std::unique_ptr<bench::Contender>.
template <class Make>
class ContenderEngine : public Engine {
 public:
  ContenderEngine(const oracle::Chain<double>& chain, Make make) : chain_(chain), make_(make) {
    const std::vector<double> still(chain.links.size(), 0.0);
    make_(chain_, bench::States{chain.size(), 1, still, still, still, still});  // throws here if at all
  }
  oracle::Vector<double> accelerations(const oracle::Vector<double>& q, const oracle::Vector<double>& qd,
                                       const oracle::Vector<double>& tau) override {
    return make_(chain_, bench::States{chain_.size(), 1, q, qd, std::vector<double>(q.size(), 0.0), tau})->result(0);
  }

 private:
  oracle::Chain<double> chain_;
  Make make_;
};

template <class Make>
Peer contender_peer(const char* name, Make make) {
  return {name, Scalar::in_double, [make](const oracle::Chain<double>& chain) -> std::unique_ptr<Engine> {
            return std::make_unique<ContenderEngine<Make>>(chain, make);
          }};
}

}  // namespace stability
