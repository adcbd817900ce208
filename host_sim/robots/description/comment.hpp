// Text of others inside a C++ comment or string.
#pragma once

#include <string>

namespace description {

/// Printable ASCII without what could end or continue a comment or a string: every other character becomes a dot, a
/// backslash a slash, a quotation mark an apostrophe.
std::string harmless(const std::string& text);

/// Lines of a comment, each "// " and at most 120 columns: `head`, then the text, indented as the head is wide.
std::string comment_lines(const std::string& head, const std::string& text);

}  // namespace description
