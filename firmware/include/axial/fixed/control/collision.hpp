// Kept for who includes it: fixed/control/momentum_observer.hpp.
#pragma once

#include <axial/fixed/control/momentum_observer.hpp>
