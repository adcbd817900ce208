#include <bench/serial.hpp>
#include <bench/states.hpp>

namespace bench {

oracle::Chain<double> serial_chain(int joints) {
  auto chain = oracle::without_rotors(oracle::RandomChains(seed).chain(joints));
  chain.links[0].alpha = chain.links[0].a = 0.0;
  return chain;
}

}  // namespace bench
