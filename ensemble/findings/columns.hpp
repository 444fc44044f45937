#pragma once
// A table of text whose columns are as wide as they need to be; what a width does not hold comes below.

#include <string>
#include <vector>

namespace floes {

/// `rows`: equally long, the first one the heading, at least a label and one column. Labels are flush left, columns
/// flush right. Columns beyond `width` characters come in tables below, labels repeated. Letters outside ASCII take one
/// place each.
std::string columns(const std::vector<std::vector<std::string>>& rows, int width);

/// Characters on the screen: UTF-8 continuation bytes take none.
std::size_t places(const std::string& text);

}  // namespace floes
