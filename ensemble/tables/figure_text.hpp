#pragma once
// A figure as characters, for terminals: areas, lines and dots, to scale, without words.

#include <string>

#include "tables/figure.hpp"

namespace floes {

enum class Letters { ascii, unicode };

/// At most `columns` wide and `rows` high, with a scale bar and what the signs mean as the last lines. Of a figure with
/// one scale for both axes in m; a character is taken for twice as high as wide. Areas of ice are seen apart where a
/// dot of a quarter of a character lies between them.
std::string figure_text(const Figure& figure, int columns, int rows, Letters letters);

}  // namespace floes
