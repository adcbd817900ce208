// Inverse dynamics in fixed point.
#pragma once

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/fixed/dynamics/drives.hpp>
#include <axial/fixed/dynamics/joint_screws.hpp>
#include <axial/fixed/links/fixed_links.hpp>
