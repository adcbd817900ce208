// axial: rigid-body dynamics for microcontrollers. The umbrella header.
#pragma once

#include <axial/dynamics/inverse_dynamics.hpp>
