// Kept for who includes it: fixed/control/tool_border.hpp.
#pragma once

#include <axial/fixed/control/tool_border.hpp>
