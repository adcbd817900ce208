// Inverse dynamics in fixed point.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/fixed/links/fixed_links.hpp>
#include <axial/fixed/recursion/steps.hpp>
