#include "keys/write.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/text.hpp"

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
    return fmt::format("{}", fmt::join(lines, ""));
}

namespace {

constexpr std::size_t longest_value = 100;  // letters that a sentence quotes whole

/// From where the two differ.
std::string quoted_from(const std::string& text, std::size_t at) {
    const bool cut = at > 0;
    const std::string_view rest = std::string_view(text).substr(at);
    return fmt::format("{}{}{}", cut ? "…" : "", beginning(rest, longest_value / 2),
                       rest.size() > longest_value / 2 ? "…" : "");
}

/// "50 there, 20 here"; of long texts and lists the first difference: "row 7, the first of 3 that differ, is [1, 2]
/// there, [1, 3] here".
std::string difference(const Key& there, const Key& here) {
    const std::string one = literal(there);
    const std::string other = literal(here);
    if (one.size() <= longest_value && other.size() <= longest_value)
        return fmt::format("{} there, {} here", one, other);
    const std::vector<std::string> all_there = items(there);
    const std::vector<std::string> all_here = items(here);
    const std::size_t common = std::min(all_there.size(), all_here.size());
    std::size_t first = common;
    std::size_t count = std::max(all_there.size(), all_here.size()) - common;
    for (std::size_t k = common; k-- > 0;) {
        if (all_there[k] == all_here[k]) continue;
        first = k;
        ++count;
    }
    if (count > 0) {
        const auto item = [&](const std::vector<std::string>& all) {
            return first < all.size() ? quoted_from(all[first], 0) : "none";
        };
        const char* what = std::holds_alternative<RowsField>(here.field) ? "row" : "number";
        return fmt::format(
            "{} {}{} is {} there, {} here{}", what, first + 1,
            count > 1 ? fmt::format(", the first of {} that differ,", count) : "", item(all_there), item(all_here),
            all_there.size() != all_here.size()
                ? fmt::format(" (the list has {} {}s there, {} here)", all_there.size(), what, all_here.size())
                : "");
    }
    std::size_t at = static_cast<std::size_t>(std::ranges::mismatch(one, other).in1 - one.begin());
    at = beginning(one, at).size();  // no letter is cut apart
    return fmt::format("from letter {} on, {} there, {} here", at + 1, quoted_from(one, at), quoted_from(other, at));
}

}  // namespace

std::vector<std::string> key_differences(std::span<const Key> there, std::span<const Key> here) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < there.size(); ++i) {
        if (there[i].derived()) continue;  // the keys that it sets differ, too
        if (exact_text(there[i]) == exact_text(here[i])) {
            for (std::string& line : key_differences(there[i].before, here[i].before)) lines.push_back(std::move(line));
        } else {
            lines.push_back(fmt::format("{}: {}", there[i].path, difference(there[i], here[i])));
        }
    }
    return lines;
}

}  // namespace floes
