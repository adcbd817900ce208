// The kernels of the library's robots.
#pragma once

#include <bench/contender.hpp>

namespace bench {

/// DART has no rotors: it races against a scene without them.
enum class Rotors { with, without };

/// Specialised in a translation unit for each robot and scalar.
template <class Robot, class T>
std::unique_ptr<Contender> ours(Algorithm algorithm, Rotors rotors, const States& states);
/// The same for batches of states; null where they do not race.
template <class Robot, class T>
std::unique_ptr<Contender> batches(Algorithm algorithm, const States& states);

/// Derivatives of inverse or of forward dynamics, as the algorithm says.
template <class Robot, class T>
std::unique_ptr<Contender> derivatives(Algorithm algorithm, const States& states);

}  // namespace bench
