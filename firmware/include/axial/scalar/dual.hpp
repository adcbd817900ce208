// Kept for who includes it: scalar/taylor.hpp.
#pragma once

#include <axial/scalar/taylor.hpp>
