#pragma once
// A section as HTML, as tables/section writes it as text. For this room only.

#include <string>
#include <string_view>

#include "findings/answer.hpp"
#include "tables/section.hpp"

namespace floes {

/// Title, words, table, notes and figures, for below the heading `heading`; the title is left out if that begins with
/// it. Tables of many rows are closed at first. Empty for a section without anything for people.
std::string section_html(const Section& told, std::string_view heading);

/// The answer as a section of a page.
std::string answer_html(const std::string& heading, const CampaignAnswer& answer);

}  // namespace floes
