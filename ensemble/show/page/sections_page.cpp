#include "page/sections_page.hpp"

#include "page/html_parts.hpp"
#include "page/plot.hpp"
#include "page/section_html.hpp"

namespace floes {

std::string sections_page(const std::string& title, std::span<const Section> sections, const std::string& command) {
    std::string body = fmt::format("<h1>{}</h1>\n", html_escaped(title));
    for (const Section& one : sections) body += section_html(one, title);
    body += section("How it was computed", fmt::format("<pre>{}</pre>\n", html_escaped(command)));
    return html_page(title, "", body);
}

std::string figure_file(const Figure& figure) {
    std::string drawn = svg(figure);
    const std::size_t end = drawn.find('>') + 1;
    drawn.insert(end, fmt::format("<style>{}</style>", page_style));
    drawn.insert(drawn.find(' '), " xmlns=\"http://www.w3.org/2000/svg\"");
    return drawn;
}

}  // namespace floes
