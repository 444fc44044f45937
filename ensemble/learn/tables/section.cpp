#include "tables/section.hpp"

#include <fmt/ranges.h>

#include "tables/prose.hpp"

namespace floes {
namespace {

/// Each part ends in a newline.
std::string joined(const std::vector<std::string>& parts) {
    return fmt::format("{}", fmt::join(parts, "\n"));
}

std::string table_text(const Section& section, int width) {
    if (section.table.empty()) return "";
    Table all = section.table;
    all.insert(all.end(), section.folded.begin(), section.folded.end());
    return section.layout == Section::Layout::panels ? text_panels(all, width) : text_columns(all, width);
}

}  // namespace

std::string text(std::span<const Section> sections, int width) {
    std::vector<std::string> parts;
    for (const Section& one : sections) {
        std::string part = one.title.empty() ? "" : one.title + "\n\n";
        part += wrapped(one.before, width) + table_text(one, width) + wrapped(one.after, width);
        if (!one.table.empty() && one.after.empty() && !one.notes.empty()) part += '\n';
        for (const std::string& note : one.notes) part += wrapped(note, width) + "\n";
        part += wrapped(one.missing, width);
        if (!part.empty()) parts.push_back(std::move(part));
    }
    return joined(parts);
}

std::string csv(std::span<const Section> sections) {
    std::vector<std::string> parts;
    for (const Section& one : sections) {
        for (const DataRows& records : one.records) {
            std::string part = csv(records);
            if (!part.empty()) parts.push_back(std::move(part));
        }
    }
    return joined(parts);
}

std::string json(std::span<const Section> sections) {
    std::vector<DataRows> all;
    for (const Section& one : sections) all.insert(all.end(), one.records.begin(), one.records.end());
    return json(all);
}

}  // namespace floes
