// The coordinate of a joint, measured anew: from another zero, or about the axis turned around. The mechanism stays.
#pragma once

#include <host_sim/robots/description/description.hpp>

namespace description {

/// The robot where a drive reads q + `offset` (rad or m) when its joint stands at q: the offset of its row, its limits
/// and the rest of its spring follow.
void shift_zero(Description& robot, int joint, double offset);

/// The robot where a joint's axis points the other way, so that its position reads -q. Its frame is turned about x by
/// half a turn: Rz(-q) = Rx(pi) Rz(q) Rx(pi); all that is given in that frame is turned with it.
void turn_axis(Description& robot, int joint);

}  // namespace description
