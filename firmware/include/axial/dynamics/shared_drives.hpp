// Kept for who includes it: transmissions/shared_drives.hpp.
#pragma once

#include <axial/transmissions/shared_drives.hpp>
