#include "keys/write.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace floes {
namespace {

constexpr std::size_t text_width = 110;

/// `text` in lines of at most text_width characters, each beginning with "# ".
std::string comment(std::string_view text) {
    std::string lines;
    std::string line = "#";
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        if (line.size() > 1 && line.size() + 1 + word.size() > text_width) {
            lines += line + "\n";
            line = "#";
        }
        (line += " ") += word;
        begin = end + 1;
    }
    return lines + line + "\n";
}

/// Long lists (profiles, poses) continue on lines of their own.
std::string broken_literal(const Key& key) {
    std::string text = literal(key);
    if (!std::holds_alternative<RowsField>(key.field) || text.size() < text_width) return text;
    std::string broken = "[\n    [";
    for (std::size_t begin = 2; begin < text.size() - 1;) {
        const std::size_t end = text.find("], [", begin);
        if (end == std::string::npos) return broken + text.substr(begin, text.size() - 1 - begin) + ",\n]";
        broken += text.substr(begin, end - begin) + "],\n    [";
        begin = end + 4;
    }
    return broken;
}

/// What the key does, and with which other setting if it needs one.
std::string meaning(const Key& key) {
    if (key.only_with.empty()) return std::string(key.doc);
    return fmt::format("{} Only with {}.", key.doc, key.only_with);
}

/// Escapes "|", which would end a cell of a Markdown table.
std::string cell(std::string_view given) {
    std::string text(given);
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
    return text;
}

}  // namespace

std::string write_tables(std::span<const Key> keys, const TableTitles& titles, Comments comments) {
    std::string text;
    std::string_view table;
    for (const Key& key : keys) {
        if (key.part) continue;
        if (key.table() != table) {
            table = key.table();
            if (!text.empty()) text += "\n";
            const auto title = titles.find(std::string(table));
            if (comments == Comments::all && title != titles.end()) text += comment(title->second);
            text += fmt::format("[{}]\n", table);
        }
        if (comments == Comments::all) {
            text += "\n" + comment(meaning(key)) +
                    comment(fmt::format("Allowed: {}. Source: {}.", allowed(key), key.source));
        }
        // A key without effect is not set: it would be refused.
        const bool idle = comments == Comments::all && key.idle();
        text += fmt::format("{}{} = {}\n", idle ? "# " : "", key.name(), broken_literal(key));
    }
    return text;
}

std::string reference_markdown(std::span<const Key> keys, const TableTitles& titles) {
    std::string text;
    std::string_view table;
    for (const Key& key : keys) {
        if (key.table() != table) {
            table = key.table();
            text += fmt::format("{}## [{}]\n\n", text.empty() ? "" : "\n", table);
            const auto title = titles.find(std::string(table));
            if (title != titles.end()) text += title->second + "\n\n";
            text += "| key | default | allowed | meaning | source of the default |\n|---|---|---|---|---|\n";
        }
        text += fmt::format("| `{}` | `{}` | {} | {} | {} |\n", key.path, literal(key), cell(allowed(key)),
                            cell(meaning(key)), cell(key.source));
    }
    return text;
}

std::string canonical_text(std::span<const Key> keys) {
    std::vector<std::string> lines;
    for (const Key& key : keys) lines.push_back(fmt::format("{} = {}\n", key.path, exact_text(key)));
    std::ranges::sort(lines);
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
}

std::vector<std::string> key_differences(std::span<const Key> there, std::span<const Key> here) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < there.size(); ++i) {
        if (there[i].derived()) continue;  // the keys that it sets differ, too
        if (exact_text(there[i]) == exact_text(here[i])) {
            for (std::string& line : key_differences(there[i].before, here[i].before)) lines.push_back(std::move(line));
        } else {
            lines.push_back(fmt::format("{}: {} there, {} here", there[i].path, literal(there[i]), literal(here[i])));
        }
    }
    return lines;
}

}  // namespace floes
