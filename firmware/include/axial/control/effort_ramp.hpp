// Kept for who includes it: control/gravity_compensation.hpp.
#pragma once

#include <axial/control/gravity_compensation.hpp>
