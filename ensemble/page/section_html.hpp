#pragma once
// Sections as HTML and figures as SVG, in one style for light and dark, screen and print. Cases have the colours of
// Okabe and Ito, which are safe for colour-blind readers.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "findings/answer.hpp"
#include "findings/page_one.hpp"
#include "tables/figure.hpp"
#include "tables/section.hpp"
#include "tables/units.hpp"

namespace floes {

/// Light colours by name, of page and picture alike.
inline constexpr std::string_view light_colours =
    "--ink:#1b1f24;--soft:#57606a;--ground:#fff;--grid:#e4e7ea;--ice:#d7e6f2;--water:#e8f1f8;"
    "--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#cc79a7;--c4:#b58900;--c5:#56b4e9";

/// How the parts of pictures look, by the names of colours.
inline constexpr std::string_view picture_style = R"(
img,svg{max-width:100%;height:auto;font:12px system-ui,sans-serif}
svg text{fill:var(--ink)}svg .label{fill:var(--soft)}svg .grid{stroke:var(--grid);fill:none}
svg .frame{stroke:var(--soft);fill:none}svg .line{fill:none;stroke:var(--ink);stroke-width:1.5}
svg .thin{stroke-width:.6}svg .thick{stroke-width:3}svg .dashed{stroke-dasharray:6 4}svg .dotted{stroke-dasharray:1.5 3}
svg .dot{fill:var(--ink)}svg .faint{fill-opacity:.45}svg .area{stroke:none}svg .veil{fill-opacity:.15}
svg .ice{fill:var(--ice);stroke:var(--soft);stroke-width:.6}svg .sheet{fill:var(--soft);fill-opacity:.35}
svg .broken{fill:var(--c1);fill-opacity:.7}svg .water{fill:var(--water)}
svg .structure{fill:var(--c4);stroke:var(--ink);stroke-width:.8}
svg .line.c0{stroke:var(--c0)}svg .line.c1{stroke:var(--c1)}svg .line.c2{stroke:var(--c2)}
svg .line.c3{stroke:var(--c3)}svg .line.c4{stroke:var(--c4)}svg .line.c5{stroke:var(--c5)}
svg .dot.c0,svg .area.c0,svg text.c0{fill:var(--c0)}svg .dot.c1,svg .area.c1,svg text.c1{fill:var(--c1)}
svg .dot.c2,svg .area.c2,svg text.c2{fill:var(--c2)}svg .dot.c3,svg .area.c3,svg text.c3{fill:var(--c3)}
svg .dot.c4,svg .area.c4,svg text.c4{fill:var(--c4)}svg .dot.c5,svg .area.c5,svg text.c5{fill:var(--c5)}
svg .key{font-weight:600}svg .halo{paint-order:stroke;stroke:var(--ground);stroke-width:3px}svg .heat{fill:var(--c1);shape-rendering:crispEdges}svg .cold{fill:var(--c0);shape-rendering:crispEdges}
svg .mild{fill:var(--c2);shape-rendering:crispEdges}svg .void{fill:var(--grid)}svg .small{font-size:10px}
)";

/// Of the page alone, behind its light colours.
inline constexpr std::string_view page_style = R"(
@media(prefers-color-scheme:dark){:root{--ink:#e6e9ec;--soft:#9aa4ae;--ground:#14181c;--grid:#2b3239;--ice:#31485c;
--water:#1b2935;--c0:#4ba3dc;--c1:#f08a4b;--c2:#3cc79d;--c3:#e3a3c4;--c4:#d9b13b;--c5:#8fd0f5}}
body{font:16px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--ground);max-width:76rem;margin:2rem auto;
padding:0 1rem}p,ul,figcaption{max-width:60rem}.two{columns:2 28rem;column-gap:2.5rem}.two ul{margin:0}
h1{font-size:1.7rem;line-height:1.2}h2{font-size:1.2rem;margin-top:2.4rem;border-bottom:1px solid var(--grid)}
h3{font-size:1rem;margin-bottom:.2rem}ul{margin-top:.2rem;padding-left:1.2rem}.title p{margin:.1rem 0}.quote{border-left:.3rem solid var(--c0);padding:.1rem 0 .1rem .8rem;font-size:1.08rem}
.drawn table{width:100%}.drawn th{vertical-align:bottom;max-width:8rem}.drawn svg{display:block;margin-left:auto}
.drawn td.words{text-align:right;color:var(--soft);max-width:9rem}.drawn .scales td{border:0;color:var(--soft);font-size:.75rem;padding-top:0}
.drawn.few table{width:auto}.drawn.few svg{display:inline-block;vertical-align:middle;margin-left:.7rem}.drawn.few td,.drawn.few th{padding-left:2rem}
.drawn.few td:first-child,.drawn.few th:first-child{padding-left:.45rem}.scale{display:flex;justify-content:space-between;width:110px;margin-left:auto}.scale i{font-style:normal}
.warning{border-left:.3rem solid var(--c1);padding-left:.6rem;margin:.4rem 0}
.appendix{margin-top:3rem;font-size:1.4rem}
figure{margin:1rem 0}figcaption,.note{color:var(--soft);font-size:.9rem}
.bar{display:inline-flex;width:9rem;height:.7rem;background:var(--grid)}.bar i{background:var(--c2)}.bar .bad{background:var(--c1)}
.panels{display:flex;flex-wrap:wrap;gap:.6rem}
table{border-collapse:collapse;font-size:.88rem;font-variant-numeric:tabular-nums}
.wide{overflow-x:auto}th,td{padding:.2rem .45rem;text-align:right;border-bottom:1px solid var(--grid);vertical-align:top}
th:first-child,td:first-child{text-align:left}td small{color:var(--soft)}td{white-space:nowrap}td.words{white-space:normal;text-align:left}
pre{overflow-x:auto;background:var(--water);padding:.7rem;font-size:.8rem}code{font-size:.9em}
@media(max-width:600px){.drawn tr{display:block;border-bottom:1px solid var(--grid);padding:.4rem 0}.drawn tr:first-child,.drawn .scales{display:none}
.drawn td{display:flex;gap:.5rem;align-items:center;justify-content:flex-end;border:0;max-width:none!important}.drawn td::before{content:attr(data-head);margin-right:auto;color:var(--soft);white-space:normal;text-align:left;max-width:40%}
.drawn td:first-child{font-weight:600}.drawn td:first-child::before{content:none}.drawn td:first-child{justify-content:flex-start}
.drawn svg{margin:0;flex:none;width:80px}figure{overflow-x:auto}figure>svg{max-width:none;min-width:560px}}
@page{size:A4;margin:14mm}@page first{size:A4 landscape;margin:12mm}
@media print{html{font-size:11px}body{font-size:1rem;margin:0;max-width:none}:root{--ink:#000;--ground:#fff}
.first{page:first}p,ul,figcaption{max-width:none}.drawn svg,.scale{width:19mm}.drawn table{font-size:.8rem}h1,h2,h3,summary{break-after:avoid}figure,tr,.panels svg{break-inside:avoid}p,li{orphans:3;widows:3}
h2{margin-top:1.2rem}figure{margin:.5rem 0}figure img{max-height:8cm;width:auto}figure svg{max-width:13cm}.panels svg{max-width:6cm}
figure figcaption{break-before:avoid}table{font-size:.62rem}th,td{padding:.1rem .3rem}.wide{overflow-x:visible}}
)";

inline std::string section(const std::string& title, const std::string& body) {
    return fmt::format("<section><h2>{}</h2>\n{}</section>\n", markup_escaped(title), body);
}

/// Nothing without a picture.
inline std::string figure(const std::string& svg, const std::string& caption) {
    if (svg.empty()) return "";
    return fmt::format("<figure>\n{}<figcaption>{}</figcaption></figure>\n", svg, markup_escaped(caption));
}

/// Pictures side by side, as many as there is room for.
inline std::string panels(const std::vector<std::string>& svgs, const std::string& caption) {
    std::string all;
    for (const std::string& one : svgs) all += one;
    return all.empty() ? "" : figure("<div class=\"panels\">\n" + all + "</div>\n", caption);
}

/// `anchor`: which part of the words stands at x: "start", "middle" or "end".
inline std::string svg_text(double x, double y, std::string_view words, std::string_view anchor,
                            std::string_view style) {
    return fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", style, x, y, anchor,
                       markup_escaped(words));
}

inline std::string paragraph(const std::string& text) {
    return fmt::format("<p>{}</p>\n", markup_escaped(text));
}

inline std::string note(const std::string& text) {
    return fmt::format("<p class=\"note\">{}</p>\n", markup_escaped(text));
}

inline std::string listed(const std::vector<std::string>& sentences) {
    std::string items;
    for (const std::string& one : sentences) items += fmt::format("<li>{}</li>\n", markup_escaped(one));
    return "<ul>\n" + items + "</ul>\n";
}

/// A whole page: no scripts, no external resources. `head`: further elements of its head.
inline std::string html_page(const std::string& title, const std::string& head, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n{}"
        "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>:root{{color-scheme:light "
        "dark;{}}}{}{}</style></head>\n<body>\n{}</body></html>\n",
        head, markup_escaped(title), light_colours, picture_style, page_style, body);
}

// A section as HTML, as tables/section writes it as text. For this module only.

/// Title, words, table, notes and figures, for below the heading `heading`; the title is left out if that begins with
/// it. Tables of many rows are closed at first. Empty for a section without anything for people.
std::string section_html(const Section& told, std::string_view heading, const Units& units = {});

/// The first page as a section: what is wrong, the table, the sentence, what to type, and the conditions.
std::string page_one_html(const std::string& heading, const PageOne& page, const CampaignAnswer& answer,
                          const Units& units);

// Sections as one self-contained HTML page, and one figure as a file of its own.

/// No scripts, no external resources, for light and dark screens and for print. `command`: that makes the page.
std::string sections_page(const std::string& title, std::span<const Section> sections, const std::string& command,
                          const Units& units = {});

/// An SVG file with the styles of the pages.
std::string figure_file(const Figure& figure, const Units& units = {});

/// The title, words, notes and figures of a section below each other, as one such file.
std::string figures_file(const Section& told);

// A figure as SVG. Its styles are classes of the page's style sheet, so that it works on light and dark screens and on
// paper. For this module only.

/// Multiples of the axis's step, or of 1, 2 or 5 times a power of ten, from low to high, at most about `most` of them;
/// decades on a logarithmic axis.
std::vector<double> ticks(const Axis& axis, int most);

std::string svg(const Figure& figure, const Units& units = {});

}  // namespace floes
