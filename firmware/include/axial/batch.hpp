// Several states at once, on a host: batches of floats and doubles as numbers of the library.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/axial.hpp>
#include <axial/batch/batch_joints.hpp>
#include <axial/batch/batch_status.hpp>
