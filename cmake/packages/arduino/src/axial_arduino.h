// What a sketch includes: the IDE finds a library by a header of its first folder.
#pragma once
#include <axial/axial.hpp>
