// floes show: what a configuration says, to scale, before anything is computed.

#include <algorithm>
#include <iostream>

#include "campaign/case_words.hpp"
#include "cli/commands.hpp"
#include "findings/scene.hpp"
#include "page/section_html.hpp"
#include "tables/figure_text.hpp"

namespace floes {

namespace {

struct ShowOptions {
    std::string file;
    std::string case_name;
    int arrangement = 0;
    std::string output;
    std::vector<std::string> overrides;
};

/// Those that are drawn: the case that is named, or the first.
std::size_t drawn_case(const Campaign& campaign, const std::string& name) {
    if (name.empty()) return 0;
    return static_cast<std::size_t>(&chosen_case(campaign, name) - campaign.cases.data());
}

std::string command_of(const ShowOptions& options) {
    std::string words = fmt::format("floes show {} -o {}", shell_word(options.file), shell_word(options.output));
    if (!options.case_name.empty()) words += " --case " + shell_word(options.case_name);
    if (options.arrangement > 0) words += fmt::format(" --arrangement {}", options.arrangement);
    for (const std::string& one : options.overrides) words += " --set " + shell_word(one);
    return words;
}

std::string in_terminal(const Section& told) {
    constexpr int rows = 30;
    const int width = terminal_width();
    const Letters letters = letters_of_terminal();
    std::string all = text(std::vector{told}, width) + "\n";
    for (const Figure& figure : told.figures) {
        const bool plan = &figure == &told.figures.front();
        all += figure_text(figure, plan ? width : width / 2, plan ? rows : rows / 2, letters) + "\n";
    }
    return all;
}

/// With what else is odd about the case.
Section drawn(const Campaign& campaign, std::size_t of_case, int arrangement) {
    Section told = scene(campaign, of_case, arrangement);
    for (const std::string& sentence : advice(Campaign{{campaign.name}, {campaign.cases[of_case]}}))
        told.notes.push_back("But " + sentence);
    return told;
}

/// The first cases that do not look like one before.
std::vector<Section> drawn_cases(const Campaign& campaign, int arrangement) {
    constexpr std::size_t most = 6;
    std::vector<Section> sections;
    std::vector<std::string> pictures;
    for (std::size_t k = 0; k < std::min(most, campaign.cases.size()); ++k) {
        Section told = drawn(campaign, k, arrangement);
        std::string picture = figures_file({.figures = told.figures});
        if (std::ranges::find(pictures, picture) != pictures.end()) continue;
        pictures.push_back(std::move(picture));
        sections.push_back(std::move(told));
    }
    return sections;
}

int show(const ShowOptions& options) {
    const Campaign campaign = load_campaign(options.file, options.overrides);
    const WaitingNote patience(std::cerr, "laying the floes");
    const bool of_all = options.case_name.empty() && campaign.cases.size() > 1;
    const std::filesystem::path path = options.output;
    if (!path.empty()) expect_place(path);
    if (of_all && !path.empty() && path.extension() != ".svg") {
        const std::vector<Section> sections = drawn_cases(campaign, options.arrangement);
        write_page(path, sections_page(campaign.name, sections, command_of(options)));
    } else {
        Section told = drawn(campaign, drawn_case(campaign, options.case_name), options.arrangement);
        if (of_all)
            told.before +=
                fmt::format("Drawn is the first case; --case names another: {}.\n", name_list(case_names(campaign)));
        if (path.empty()) {
            std::fputs(in_terminal(told).c_str(), stdout);
            return 0;
        }
        write_page(path, path.extension() == ".svg"
                             ? figures_file(told)
                             : sections_page(campaign.name, std::vector{told}, command_of(options)));
        for (const std::string& sentence : told.notes) note("{}", sentence);
    }
    std::printf("%s\n", options.output.c_str());
    return 0;
}

}  // namespace

void add_show(CommandLine& line) {
    auto options = std::make_shared<ShowOptions>();
    Verb verb = line.verb("show", "Draw what a configuration says, to scale, before anything is computed");
    verb.option("config", options->file, "The configuration (CONFIG.toml)").required();
    verb.option("-o,--output", options->output,
                "What to make: .svg a picture, .html a page of all cases that look different, up to six, .pdf the same "
                "printed by a browser of Chromium's kind; default: the terminal's own picture")
        .file_ending({".svg", ".html", ".htm", ".pdf"});
    verb.option("--case", options->case_name, "The case to draw; default: the first, of a page all");
    verb.option("--arrangement", options->arrangement, "Its arrangement").not_negative().shows_default();
    add_overrides(verb, options->overrides);
    verb.footer(
        "Hull, first arrangement, banks, moorings, and the way with what of it is measured. What is seldom meant is "
        "also said\nin words: ice far ahead of the hull, a line that leads across it.\n\n"
        "  floes show my.toml\n"
        "  floes show my.toml -o my.svg --case thick\n"
        "  floes show my.toml -o my.html --set structure.start_m=1.2");
    verb.runs([options] { return show(*options); });
}

}  // namespace floes
