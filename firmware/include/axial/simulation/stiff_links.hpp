// Kept for who includes it: simulation/system.hpp.
#pragma once

#include <axial/simulation/system.hpp>
