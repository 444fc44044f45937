#include "hydro/mooring_sections.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

#include "hydro/rows.hpp"

namespace floes {

namespace {

/// The words by which MoorDyn and MoorPy know a section. The first that fits counts.
constexpr std::array<std::pair<std::string_view, std::string_view>, 25> section_words{{
    {"LINE TYPES", "types"},
    {"LINE DICTIONARY", "types"},
    {"ROD TYPES", "rod types"},
    {"ROD DICTIONARY", "rod types"},
    {"RODS", "rods"},
    {"ROD LIST", "rods"},
    {"ROD PROPERTIES", "rods"},
    {"BODIES", "bodies"},
    {"BODY LIST", "bodies"},
    {"BODY PROPERTIES", "bodies"},
    {"EXTERNAL LOADS", "external loads"},
    {"FAILURE", "failures"},
    {"SYROPE", "syrope"},
    {"CONTROL", "control"},
    {"POINT", "points"},
    {"CONNECTION", "points"},
    {"NODE PROPERTIES", "points"},
    {"OPTIONS", "options"},
    {"OUTPUT", "outputs"},
    {"NEED THIS LINE", "end"},
    {"END", "end"},
    {"MOORDYN", "title"},
    {"LINES", "lines"},
    {"LINE PROPERTIES", "lines"},
    {"LINE LIST", "lines"},
}};

/// Its name, if a line begins a section; none otherwise.
std::optional<MooringSection> section_at(std::string_view line, std::size_t number) {
    if (line.find("---") == std::string_view::npos) return {};
    std::string title;
    for (const std::string& word : words_of(line)) {
        std::string plain = word;
        std::erase(plain, '-');
        if (!plain.empty()) title += (title.empty() ? "" : " ") + plain;
    }
    const std::string text = upper(title);
    const auto known = std::ranges::find_if(section_words, [&](const auto& one) {
        return one.first == "END" ? text.starts_with(one.first) : text.find(one.first) != std::string::npos;
    });
    const std::string name = title.empty() ? "end" : known == section_words.end() ? title : std::string(known->second);
    return MooringSection{name, title, number};
}

/// Lines of names and units at the beginning of a section.
bool is_table(const std::string& name) {
    constexpr std::array<std::string_view, 9> tables{"types", "rod types",      "rods",     "bodies", "points",
                                                     "lines", "external loads", "failures", "control"};
    return std::ranges::find(tables, name) != tables.end();
}

/// Without what is behind a sign of a comment.
std::vector<std::string> words_before_comment(std::string_view line) {
    std::vector<std::string> words = words_of(line);
    const auto comment = std::ranges::find_if(words, [](const std::string& word) {
        return std::string_view("!#%").find(word.front()) != std::string_view::npos;
    });
    words.erase(comment, words.end());
    return words;
}

/// What stands between brackets: "s or 0" of "(s or 0)".
std::vector<std::string> units_in(std::string_view line) {
    std::vector<std::string> units;
    for (std::size_t open = line.find('('); open != std::string_view::npos; open = line.find('(', open + 1))
        units.emplace_back(line.substr(open + 1, line.find(')', open) - open - 1));
    return units;
}

std::vector<MooringSection> sections_of(std::string_view text, const std::string& file) {
    std::vector<MooringSection> found;
    std::size_t number = 0;
    int header = 0;  // lines of names and units still to come
    for (const std::string_view line : lines_of(text)) {
        ++number;
        if (std::optional<MooringSection> section = section_at(line, number)) {
            found.push_back(std::move(*section));
            header = is_table(found.back().name) ? 2 : 0;
            continue;
        }
        if (found.empty() || words_of(line).empty()) continue;
        if (header == 2) {
            for (const std::string& word : words_of(line)) found.back().columns.push_back(upper(word));
        } else if (header == 1) {
            found.back().units = units_in(line);
            found.back().units_line = number;
            if (found.back().units.empty())
                throw InputError(
                    "{}:{}: is to be the units of the columns above, as (m) or (-); MoorDyn skips this line", file,
                    number);
        } else if (std::vector<std::string> words = words_before_comment(line); !words.empty()) {
            const std::size_t columns = found.back().columns.size();
            if (columns > 0 && words.size() > columns)
                throw InputError("{}:{}: has {} words for the {} columns of its table; a comment begins with #", file,
                                 number, words.size(), columns);
            found.back().rows.push_back({number, std::move(words)});
        }
        header = std::max(header - 1, 0);
    }
    return found;
}

}  // namespace

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

bool is_mooring_file(std::string_view text) {
    std::size_t number = 0;
    return std::ranges::any_of(lines_of(text), [&](std::string_view line) {
        const std::optional<MooringSection> section = section_at(line, ++number);
        return section && (section->name == "types" || section->name == "lines" || section->name == "points");
    });
}

MooringSections::MooringSections(std::string_view text, std::string file)
    : file_(std::move(file)), sections_(sections_of(text, file_)) {
    const bool ends = !sections_.empty() && sections_.back().name == "end" &&
                      (!sections_.back().title.empty() || text.ends_with('\n') || text.ends_with('\r'));
    if (!ends)
        throw InputError(
            "{}: does not end with the line that MoorDyn needs there, --- need this line ---; was the file cut off?",
            file_);
}

double MooringSections::number(const MooringRow& row, std::size_t column, const char* name) const {
    if (column >= row.words.size()) throw wrong(row, "has {} words and no {}", row.words.size(), name);
    const std::optional<double> value = number_of(row.words[column]);
    if (!value || !std::isfinite(*value))
        throw wrong(row, "has {} for {}, which is no number", row.words[column], name);
    return *value;
}

std::vector<const MooringSection*> MooringSections::all(const std::string& name) const {
    std::vector<const MooringSection*> found;
    for (const MooringSection& section : sections_)
        if (section.name == name) found.push_back(&section);
    return found;
}

std::vector<const MooringSection*> MooringSections::need(const std::string& name) const {
    std::vector<const MooringSection*> found = all(name);
    if (found.empty())
        throw InputError("{}: has no section of {}; it is to be a file of MoorDyn or MoorPy", file_,
                         name == "types" ? "line types" : name);
    return found;
}

void MooringSections::refuse_other_unit(const MooringSection& section, std::size_t column, const char* unit) const {
    if (column >= section.units.size()) return;
    const std::string& said = section.units[column];
    const bool none = said.find_first_not_of("-#, ") == std::string::npos;
    if (none || upper(words_of(said).front()) == upper(unit)) return;
    throw InputError("{}:{}: has its column {} in ({}), and MoorDyn reads it in ({})", file_, section.units_line,
                     column < section.columns.size() ? section.columns[column] : std::to_string(column + 1), said,
                     unit);
}

}  // namespace floes
