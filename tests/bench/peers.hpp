// Debian's binaries of other people's libraries as contenders, in double.
#pragma once

#include <bench/contender.hpp>
#include <oracle/chain.hpp>

namespace bench {

/// Orocos KDL: ChainIdSolver_RNE (also for gravity and bias), ChainDynParam, ChainFdSolver_RNE (M by composite bodies,
/// then L D L^T).
std::unique_ptr<Contender> make_kdl(Algorithm algorithm, const oracle::Chain<double>& chain, const States& states);
/// Orocos KDL's O(N) solver, without constraints: forward dynamics.
std::unique_ptr<Contender> make_vereshchagin(const oracle::Chain<double>& chain, const States& states);
/// DART's Skeleton. It has no rotor inertia: the chain must be without.
std::unique_ptr<Contender> make_dart(Algorithm algorithm, const oracle::Chain<double>& chain, const States& states);

}  // namespace bench
