// Mimics and transmissions of a source as what the links of a description name, and what that leaves to drives.
#pragma once

#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/import/source_tree.hpp>

#include <functional>

namespace importer {

enum class LeaderFault { follows_itself, does_not_move };

/// Calls `refuse` for each joint that follows itself, by way of others or not, or one that does not move here.
void check_leaders(const SourceTree& tree, const std::function<void(const SourceJoint&, LeaderFault)>& refuse);

/// Names the drives of joints that share them. Friction of a joint that one drive moves goes to that drive; of others
/// it is left out, as are effort limits of joints that are none of a drive's own: both are named in the assumptions.
void couple(const SourceTree& source, description::Description& robot);

/// Fills limits of shared drives in: as far as their joints' limits let them go.
void assume_drive_limits(description::Description& robot);

}  // namespace importer
