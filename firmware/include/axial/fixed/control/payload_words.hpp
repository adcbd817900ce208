// Kept for who includes it: fixed/control/payload_estimator.hpp.
#pragma once

#include <axial/fixed/control/payload_estimator.hpp>
