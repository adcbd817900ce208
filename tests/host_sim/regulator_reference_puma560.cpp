// The reference of a regulator, of the Puma 560.
#define AXIAL_REFERENCE_OF robots::Puma560
#include "regulator_reference.cpp"
