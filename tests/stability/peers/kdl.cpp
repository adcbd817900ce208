#include <bench/peers.hpp>
#include <stability/peers/contender.hpp>

namespace stability {

std::vector<Peer> kdl_peers() {
  return {contender_peer("kdl",
                         [](const auto& chain, const auto& states) {
                           return bench::make_kdl(bench::Algorithm::forward_dynamics, chain, states);
                         }),
          contender_peer("kdl_vereshchagin", [](const auto& chain, const auto& states) {
            return bench::make_vereshchagin(chain, states);
          })};
}

}  // namespace stability
