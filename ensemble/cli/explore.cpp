// floes explore: the members of a campaign on one page that can be asked.

#include <iostream>
#include <sstream>

#include "campaign_file/read.hpp"
#include "cli/commands.hpp"
#include "draw/explore_page.hpp"
#include "findings/evidence.hpp"

namespace floes {

namespace {

/// What is printed: where the page is.
std::string explore(const std::vector<std::string>& files, const std::string& wanted) {
    const GivenCampaign given(files);
    const std::filesystem::path output =
        wanted.empty() ? std::filesystem::path(files.front()).stem().string() + "_explore.html" : wanted;
    expect_place(output);
    const CampaignFile file(given.path());
    const WaitingNote patience(std::cerr, "reading the members and their histories");
    std::ostringstream page;
    write_explore_page(page, read_evidence(file), file, {.file = given.words()});
    write_page(output, page.str());
    return output.string() + "\n";
}

}  // namespace

void add_explore(CommandLine& line) {
    auto files = std::make_shared<std::vector<std::string>>();
    auto output = std::make_shared<std::string>();
    Verb verb = line.verb("explore", "Write one page on which members can be brushed, picked and compared");
    verb.option("campaign", *files, "The campaign file (CAMPAIGN.h5), or the parts of one").required();
    verb.option("-o,--output", *output, "The page; default: CAMPAIGN_explore.html in this folder")
        .file_ending({".html", ".htm"});
    verb.footer(
        "Points over any two quantities or inputs, histograms by case, load histories and parallel coordinates; what\n"
        "is brushed in one is marked in all. A member that is picked shows its numbers and the commands that replay\n"
        "it. The page asks nothing of the network, and stays quick up to 100,000 members.\n\n"
        "  floes explore my.h5 -o explore.html");
    verb.prints([files, output] { return explore(*files, *output); });
}

}  // namespace floes
