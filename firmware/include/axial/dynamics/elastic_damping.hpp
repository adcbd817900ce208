// Kept for who includes it: transmissions/elastic_damping.hpp.
#pragma once

#include <axial/transmissions/elastic_damping.hpp>
