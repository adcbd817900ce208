// Kept for who includes it: transmissions/driven_model.hpp.
#pragma once

#include <axial/transmissions/driven_model.hpp>
