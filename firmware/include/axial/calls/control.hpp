// Kept for who includes it: calls/on_arrays.hpp.
#pragma once

#include <axial/calls/on_arrays.hpp>
