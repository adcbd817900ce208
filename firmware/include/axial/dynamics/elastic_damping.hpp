// Kept for who includes it: elastic/elastic_damping.hpp.
#pragma once

#include <axial/elastic/elastic_damping.hpp>
