// Kept for who includes it: scene/runtime_tool.hpp.
#pragma once

#include <axial/scene/runtime_tool.hpp>
