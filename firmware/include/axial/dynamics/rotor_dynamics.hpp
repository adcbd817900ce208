// Kept for who includes it: transmissions/rotor_dynamics.hpp.
#pragma once

#include <axial/transmissions/rotor_dynamics.hpp>
