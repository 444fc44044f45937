#pragma once
// Sections as one self-contained HTML page, and one figure as a file of its own.

#include <span>
#include <string>

#include "tables/section.hpp"

namespace floes {

/// No scripts, no external resources, for light and dark screens and for print. `command`: that makes the page.
std::string sections_page(const std::string& title, std::span<const Section> sections, const std::string& command);

/// An SVG file with the styles of the pages.
std::string figure_file(const Figure& figure);

}  // namespace floes
