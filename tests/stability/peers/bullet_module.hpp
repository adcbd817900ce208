// What a build of Bullet offers through C: its two builds have the same symbols and cannot be linked together.
#pragma once

extern "C" {

/// Serial chain of N links, each 14 numbers: slides (0 or 1), alpha, a, d, mass, com (3), principal moments about the
/// com (3), 3 spare. qdd receives N accelerations.
void axial_bullet_accelerations(int links, const double* chain, const double* gravity, const double* q,
                                const double* qd, const double* tau, double* qdd);
}

constexpr int bullet_numbers_a_link = 14;
