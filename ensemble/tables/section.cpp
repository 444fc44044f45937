#include "tables/section.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "tables/table.hpp"

namespace floes {
namespace {

/// Each part ends in a newline.
std::string joined(const std::vector<std::string>& parts) {
    return fmt::format("{}", fmt::join(parts, "\n"));
}

std::string results_text(const Results& results, int width, const Units& units) {
    Table table = shown_table(results, units);
    const Table folded = shown_table(results, units, Results::For::folded);
    if (table.empty()) return "";
    if (results.view == Results::View::side_by_side) return text_panels(table, width);
    if (!folded.empty()) table.insert(table.end(), folded.begin() + 1, folded.end());
    return text_columns(table, width);
}

std::string table_text(const Section& section, int width, const Units& units) {
    std::vector<std::string> parts;
    for (const Results& one : section.results)
        if (std::string part = results_text(one, width, units); !part.empty()) parts.push_back(std::move(part));
    return joined(parts);
}

}  // namespace

std::string text(std::span<const Section> sections, int width, const Units& units) {
    std::vector<std::string> parts;
    for (const Section& one : sections) {
        std::string part = one.title.empty() ? "" : one.title + "\n\n";
        const std::string tables = table_text(one, width, units);
        part += wrapped(one.before, width) + tables + wrapped(one.after, width);
        if (!tables.empty() && one.after.empty() && !one.notes.empty()) part += '\n';
        for (const std::string& note : one.notes) part += wrapped(note, width) + "\n";
        part += wrapped(one.missing, width);
        if (!part.empty()) parts.push_back(std::move(part));
    }
    return joined(parts);
}

std::string csv(std::span<const Section> sections) {
    std::vector<std::string> parts;
    for (const Section& one : sections) {
        for (const DataRows& records : records_of(one)) {
            std::string part = csv(records);
            if (!part.empty()) parts.push_back(std::move(part));
        }
    }
    return joined(parts);
}

std::string json(std::span<const Section> sections) {
    std::vector<DataRows> all;
    for (const Section& one : sections) {
        const std::vector<DataRows> own = records_of(one);
        all.insert(all.end(), own.begin(), own.end());
    }
    return json(all);
}

std::vector<DataRows> records_of(const Section& section) {
    std::vector<DataRows> records;
    for (const Results& one : section.results)
        if (std::ranges::any_of(one.columns, [](const ResultColumn& column) { return !column.key.empty(); }))
            records.push_back(data_rows(one));
    return records;
}

}  // namespace floes
