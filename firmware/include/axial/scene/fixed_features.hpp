// Kept for who includes it: scene/features.hpp.
#pragma once

#include <axial/scene/features.hpp>
