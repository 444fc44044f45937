#pragma once
// What the cases of a campaign have in common, and what varies between them, in words. No case speaks for the others.

#include <string>
#include <variant>
#include <vector>

#include "findings/design_points.hpp"
#include "findings/summary.hpp"
#include "tables/section.hpp"

namespace floes {

// The conditions that decide the load together: structure wall, far end and contacts. A load without them means
// nothing.

/// "preset paper, friction in one direction, rigid with Γ 0.2".
Words contact_words(const ContactLaw& law);

/// One sentence for each condition; where cases differ, one for each value with the names of its cases.
std::vector<std::string> condition_lines(const Summary& summary);

/// A condition for programs.
struct Condition {
    std::string key;
    Datum (*value)(const CaseRow& row);
};

/// All of them.
std::vector<Condition> conditions();

/// "0.02", "0.02 to 0.04": the least and the largest of the values.
std::string range_text(const std::vector<double>& values);

/// A key in which cases differ, with its value in each.
struct VariedInput {
    std::string key;  ///< full path
    KeyWords words;
    bool logarithmic = false;                                    ///< an axis of a design that is
    std::vector<std::variant<double, std::string>> values = {};  ///< one a case, in its unit; "" without an effect

    /// In every case in which the key has an effect.
    bool numeric() const;
};

/// Of a design its axes, else every key in which the cases that it has an effect in differ, lists and profiles apart.
std::vector<VariedInput> varied_inputs(const Campaign& campaign);

/// A sentence for each key in which the cases that it has an effect in differ, "Varies: thickness 0.02 m (soft), 0.03 m
/// (stiff, open)."; of a design one for its axes. At most a handful, and then how many more.
std::vector<std::string> variation_lines(const Campaign& campaign, const Summary& summary);

}  // namespace floes
