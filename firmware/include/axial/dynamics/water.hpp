// Kept for who includes it: base/water.hpp.
#pragma once

#include <axial/base/water.hpp>
