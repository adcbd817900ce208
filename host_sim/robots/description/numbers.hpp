// Numbers as text, in no locale.
#pragma once

#include <string>

namespace description {

/// The shortest decimal that reads back as this very double; nan, inf and -inf by these names.
std::string number(double value);
/// The same to so many significant digits.
std::string number(double value, int digits);

}  // namespace description
