// The robot of a header as a description: what its type does not tell, but its comments.
#pragma once

#include <host_sim/robots/description/description.hpp>

#include <string>

namespace description {

/// Names of joints and links as a generated header's comments have them ("// 0: shoulder moves upper_arm"), the notes
/// and assumptions of its leading comment ("// read: ", "// assumed: "), and the file's name as the source.
void take_comments(Description& robot, const std::string& header);

}  // namespace description
