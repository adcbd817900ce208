/** \file
 * The version of these headers, for C and C++: AXIAL_VERSION in words, AXIAL_VERSION_NUMBER to compare.
 * What stays the same between versions: doc/guides/versions.md. */
#ifndef AXIAL_VERSION_H
#define AXIAL_VERSION_H

/** Major, minor and patch. Before 1.0 a new minor version may ask a program to be changed, a patch never does. */
#define AXIAL_VERSION_MAJOR 0
#define AXIAL_VERSION_MINOR 1 /**< see AXIAL_VERSION_MAJOR */
#define AXIAL_VERSION_PATCH 0 /**< see AXIAL_VERSION_MAJOR */

/** "major.minor.patch". */
#define AXIAL_VERSION "0.1.0"

/** major * 10000 + minor * 100 + patch: `#if AXIAL_VERSION_NUMBER >= 100`. */
#define AXIAL_VERSION_NUMBER (AXIAL_VERSION_MAJOR * 10000 + AXIAL_VERSION_MINOR * 100 + AXIAL_VERSION_PATCH)

#endif
