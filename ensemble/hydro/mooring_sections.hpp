#pragma once
// A file of MoorDyn or MoorPy as sections of rows of words.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace floes {

struct MooringRow {
    std::size_t line;  ///< of the file, from 1
    std::vector<std::string> words;
};

struct MooringSection {
    std::string name;   ///< "types", "points", "lines", "failures", "rods", "bodies", "options", "end", or its title
    std::string title;  ///< as the file has it
    std::size_t line;
    std::vector<std::string> columns{};  ///< upper case
    std::vector<std::string> units{};    ///< without brackets
    std::size_t units_line = 0;
    std::vector<MooringRow> rows{};
};

/// Whether a text has a section of such a file.
bool is_mooring_file(std::string_view text);

std::string upper(std::string text);

class MooringSections {
  public:
    /// Throws InputError for a file that does not end with a line of dashes as MoorDyn needs it, and for a table
    /// without its line of units.
    MooringSections(std::string_view text, std::string file);

    template <class... Values>
    InputError wrong(const MooringRow& row, fmt::format_string<Values...> what, Values&&... values) const {
        return InputError("{}:{}: {}", file_, row.line, fmt::format(what, std::forward<Values>(values)...));
    }

    /// The number in a column, counted from 0. Throws InputError for a word that is none.
    double number(const MooringRow& row, std::size_t column, const char* name) const;

    /// Sections of that name.
    std::vector<const MooringSection*> all(const std::string& name) const;
    /// The same; throws InputError if there is none.
    std::vector<const MooringSection*> need(const std::string& name) const;
    const std::vector<MooringSection>& sections() const { return sections_; }

    /// Throws InputError where a column has another unit than the one in which MoorDyn reads it.
    void refuse_other_unit(const MooringSection& section, std::size_t column, const char* unit) const;

    const std::string& file() const { return file_; }

  private:
    std::string file_;
    std::vector<MooringSection> sections_;
};

}  // namespace floes
