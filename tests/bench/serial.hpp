// Serial chains of 2 to 64 joints: how the cost grows.
#pragma once

#include <bench/contender.hpp>
#include <oracle/chain.hpp>

namespace bench {

constexpr int serial_joints[] = {2, 4, 8, 16, 32, 64};

/// Seeded: mixed joints, right-angle and general twists, no rotors (DART has none).
oracle::Chain<double> serial_chain(int joints);

/// axial::Model, the looped form, in double; std::invalid_argument for a number of joints that is not listed.
std::unique_ptr<Contender> ours_serial(Algorithm algorithm, const oracle::Chain<double>& chain, const States& states);

}  // namespace bench
