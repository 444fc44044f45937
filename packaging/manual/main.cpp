// Writes floes' manual pages and completions: floes_manual FOLDER VERSION DATE

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "cli/commands.hpp"
#include "command_text.hpp"

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("usage: floes_manual FOLDER VERSION DATE\n", stderr);
        return 2;
    }
    floes::CommandLine line(floes::program_description);
    floes::add_verbs(line, {});
    const auto verbs = floes::manual::verbs_of(line.app());
    std::filesystem::create_directories(argv[1]);
    for (const auto& pages : {floes::manual::man_pages(verbs, argv[2], argv[3]), floes::manual::completions(verbs)}) {
        for (const floes::manual::Page& page : pages) {
            std::ofstream file(std::filesystem::path(argv[1]) / page.name, std::ios::binary);
            file << page.text;
            if (!file.flush()) {
                std::fprintf(stderr, "floes_manual: %s could not be written in %s\n", page.name.c_str(), argv[1]);
                return 1;
            }
        }
    }
    return 0;
}
