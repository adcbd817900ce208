// A chain as Orocos KDL has it, for those who call KDL themselves.
#pragma once

#include <kdl/chain.hpp>
#include <oracle/chain.hpp>

namespace oracle {

/// One KDL segment a joint, which is what KDL solves fastest: the joint, its z-screw and the next row's x-screw. Rotor
/// inertia is KDL's joint inertia. Serial chains only (std::invalid_argument otherwise).
KDL::Chain to_kdl(const Chain<double>& chain);

}  // namespace oracle
