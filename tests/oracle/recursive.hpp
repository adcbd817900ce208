// A second reference for long chains (hundreds of links), where Lagrange's O(N^4) is too slow: recursive Newton-Euler
// and articulated bodies with dense 6x6 matrices, every quantity about the origin of frame 0 and in its axes, so that
// nothing is ever transformed. Use quad: world coordinates lose digits that quad has to spare. The tests check it
// against the Lagrangian oracle and against 30-digit figures. It shares only the poses of the links with lagrange.hpp.
#pragma once

#include <oracle/chain.hpp>

namespace oracle {

/// As inverse_dynamics, in O(N), for loads without springs and with a tip wrench only.
template <class T>
Vector<T> recursive_inverse_dynamics(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd,
                                     const Vector<T>& qdd, const Load<T>& load = {});

/// As forward_dynamics, in O(N).
template <class T>
Vector<T> recursive_forward_dynamics(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd,
                                     const Vector<T>& tau, const Load<T>& load = {});

}  // namespace oracle
