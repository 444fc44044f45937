#include <fmt/format.h>

#include "tables/table.hpp"

namespace floes {

std::string html_table(const Table& table) {
    std::string rows;
    for (const std::vector<Cell>& row : table) {
        const char* kind = rows.empty() ? "th" : "td";
        rows += "<tr>";
        for (const Cell& cell : row) {
            std::string content = (cell.value.starts_with("  ") ? "&emsp;" : "") + html_escaped(cell.value);
            for (const auto& below : {cell.range, cell.further})
                if (below) content += fmt::format("<br><small>{}</small>", html_escaped(*below));
            rows += fmt::format("<{0}>{1}</{0}>", kind, content);
        }
        rows += "</tr>\n";
    }
    return "<div class=\"wide\"><table>" + rows + "</table></div>\n";
}

std::string html_escaped(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '&':
                escaped += "&amp;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

}  // namespace floes
