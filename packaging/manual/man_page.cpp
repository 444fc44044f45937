// Manual pages in the macros of man(7).

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "command_text.hpp"

namespace floes::manual {

namespace {

/// Text that no macro or escape is seen in.
std::string plain(const std::string& text) {
    std::string out;
    if (!text.empty() && (text.front() == '.' || text.front() == '\'')) out = "\\&";
    for (const char c : text) {
        if (c == '\\') {
            out += "\\e";
        } else if (c == '-') {
            out += "\\-";
        } else {
            out += c;
        }
    }
    return out;
}

/// Paragraphs; indented lines stand as they are.
std::string paragraphs(const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    bool example = false;
    for (std::string line; std::getline(lines, line);) {
        const bool indented = line.starts_with("  ");
        if (indented && !example) out += ".PP\n.RS 4\n.nf\n";
        if (!indented && example) out += ".fi\n.RE\n";
        if (line.empty() && !example && !out.empty()) out += ".PP\n";
        example = indented;
        if (!line.empty()) out += plain(line.substr(indented ? 2 : 0)) + "\n";
    }
    if (example) out += ".fi\n.RE\n";
    // A paragraph before an example would be empty.
    for (std::size_t at = out.find(".PP\n.PP\n"); at != std::string::npos; at = out.find(".PP\n.PP\n"))
        out.erase(at, 4);
    return out;
}

std::string options_section(const std::vector<OptionText>& options, bool positional, const char* title) {
    std::string out;
    std::string group;
    for (const OptionText& option : options) {
        if (option.positional != positional) continue;
        if (option.group != group) out += fmt::format(".PP\n{}:\n", plain(option.group));
        group = option.group;
        std::vector<std::string> names;
        for (const std::string& name : option.names) names.push_back(fmt::format("\\fB{}\\fR", plain(name)));
        out += fmt::format(".TP\n{}{}{}\n{}\n", fmt::join(names, ", "), option.values.empty() ? "" : " ",
                           plain(option.values), plain(option.description));
    }
    return out.empty() ? out : fmt::format(".SH {}\n{}", title, out);
}

/// The description without the name that it may begin with.
std::string one_line(const VerbText& verb) {
    const std::string begin = verb.name + ": ";
    return verb.description.starts_with(begin) ? verb.description.substr(begin.size()) : verb.description;
}

/// "floes-laboratory-plate".
std::string page_name(const VerbText& verb) {
    std::string name = verb.name == "floes" ? verb.name : "floes-" + verb.name;
    std::ranges::replace(name, ' ', '-');
    return name;
}

}  // namespace

std::vector<Page> man_pages(const std::vector<VerbText>& verbs, const std::string& version, const std::string& date) {
    std::vector<Page> pages;
    for (const VerbText& verb : verbs) {
        const bool program = verb.name == "floes";
        const std::string name = page_name(verb);
        std::string text = fmt::format(".TH {} 1 {} \"floes {}\" \"floes\"\n", plain(name), date, version);
        text += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n\\fB{}\\fR\n", plain(name), plain(one_line(verb)),
                            plain(verb.usage));
        text += options_section(verb.options, true, "ARGUMENTS") + options_section(verb.options, false, "OPTIONS");
        if (program || !verb.inner.empty()) text += ".SH VERBS\n";
        for (const VerbText& other : verbs)
            if (&other != &verb && (program || other.name.starts_with(verb.name + " ")))
                text += fmt::format(".TP\n\\fB{}\\fR(1)\n{}\n", plain(page_name(other)), plain(other.description));
        if (!verb.footer.empty()) text += ".SH DESCRIPTION\n" + paragraphs(verb.footer);
        if (!program) text += ".SH SEE ALSO\n\\fBfloes\\fR(1)\n";
        pages.push_back({name + ".1", text});
    }
    return pages;
}

}  // namespace floes::manual
