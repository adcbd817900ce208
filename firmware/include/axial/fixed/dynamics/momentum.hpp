// Momenta in fixed point.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/momentum.hpp>
#include <axial/fixed/dynamics/inverse_dynamics.hpp>
#include <axial/fixed/limits/state_check.hpp>
