#pragma once
// The parts of a page. For this room only.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "page/page_style.hpp"
#include "tables/table.hpp"

namespace floes {

inline std::string section(const std::string& title, const std::string& body) {
    return fmt::format("<section><h2>{}</h2>\n{}</section>\n", html_escaped(title), body);
}

/// Nothing without a picture.
inline std::string figure(const std::string& svg, const std::string& caption) {
    if (svg.empty()) return "";
    return fmt::format("<figure>\n{}<figcaption>{}</figcaption></figure>\n", svg, html_escaped(caption));
}

/// Pictures side by side, as many as there is room for.
inline std::string panels(const std::vector<std::string>& svgs, const std::string& caption) {
    std::string all;
    for (const std::string& one : svgs) all += one;
    return all.empty() ? "" : figure("<div class=\"panels\">\n" + all + "</div>\n", caption);
}

inline std::string paragraph(const std::string& text) {
    return fmt::format("<p>{}</p>\n", html_escaped(text));
}

inline std::string note(const std::string& text) {
    return fmt::format("<p class=\"note\">{}</p>\n", html_escaped(text));
}

inline std::string listed(const std::vector<std::string>& sentences) {
    std::string items;
    for (const std::string& one : sentences) items += fmt::format("<li>{}</li>\n", html_escaped(one));
    return "<ul>\n" + items + "</ul>\n";
}

/// A whole page: no scripts, no external resources. `head`: further elements of its head.
inline std::string html_page(const std::string& title, const std::string& head, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n{}"
        "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>{}</style></head>\n<body>\n{}</body></html>\n",
        head, html_escaped(title), page_style, body);
}

}  // namespace floes
