// Kept for who includes it: batch/batch_status.hpp.
#pragma once

#include <axial/batch/batch_status.hpp>
