// expect: axial needs C++17: pass -std=c++17 or -std=gnu++17
// within: 3 lines
// at most: 9 lines
// standard: gnu++14
#include <axial/axial.hpp>
#ifndef MENDED
using Trouble = axial::NothingOfThisIsSaid;
#endif
