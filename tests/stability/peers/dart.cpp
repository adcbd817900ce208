#include <bench/peers.hpp>
#include <stability/peers/contender.hpp>

namespace stability {

std::vector<Peer> dart_peers() {
  return {contender_peer("dart", [](const auto& chain, const auto& states) {
    return bench::make_dart(bench::Algorithm::forward_dynamics, chain, states);
  })};
}

}  // namespace stability
