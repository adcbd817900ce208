// Kept for who includes it: fixed/simulation/motion.hpp.
#pragma once

#include <axial/fixed/simulation/motion.hpp>
