// floes verify: whether campaign files, records and journals are as they were written.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/verify_file.hpp"

namespace floes {
namespace {

constexpr const char* state_words[]{"good", "damaged", "not of floes", "of a newer floes"};

const char* state_word(const FileVerdict& verdict) {
    return state_words[static_cast<std::size_t>(verdict.state)];
}

std::string text_of(const FileVerdict& verdict) {
    std::string head;
    for (const std::string& part : {verdict.kind, verdict.counts})
        if (!part.empty()) head += ", " + part;
    if (!verdict.digest.empty()) head += ", digest " + verdict.digest;
    std::string text = fmt::format("{}: {}{}\n", verdict.file, state_word(verdict), head);
    for (const std::vector<std::string>* sentences : {&verdict.faults, &verdict.notes})
        for (const std::string& one : *sentences) text += fmt::format("  {}\n", one);
    for (const std::string& one : {verdict.whole, verdict.remedy})
        if (!one.empty()) text += fmt::format("  {}\n", one);
    return text;
}

std::string json_of(const std::vector<FileVerdict>& verdicts) {
    auto files = nlohmann::ordered_json::array();
    for (const FileVerdict& one : verdicts)
        files.push_back({{"file", one.file},
                         {"kind", one.kind},
                         {"state", state_word(one)},
                         {"checked", one.counts},
                         {"digest", one.digest},
                         {"faults", one.faults},
                         {"notes", one.notes},
                         {"whole", one.whole},
                         {"remedy", one.remedy}});
    // What is quoted of a damaged file need not be UTF-8.
    return nlohmann::ordered_json{{"files", files}}.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
           "\n";
}

int verify(const std::vector<std::string>& files, const std::string& format) {
    std::vector<FileVerdict> verdicts;
    for (const std::string& file : files) {
        verdicts.push_back(verify_file(file));
        if (format == "table") std::fputs(text_of(verdicts.back()).c_str(), stdout);
    }
    if (format == "json") std::fputs(json_of(verdicts).c_str(), stdout);
    const auto any = [&](FileState state) { return std::ranges::count(verdicts, state, &FileVerdict::state) > 0; };
    return any(FileState::damaged) ? 1 : any(FileState::not_of_floes) || any(FileState::newer) ? 2 : 0;
}

}  // namespace

void add_verify(CLI::App& program, int& exit_status) {
    struct Options {
        std::vector<std::string> files;
        std::string format = "table";
    };
    auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand(
        "verify", "Check that campaign files, records and journals are as they were written, byte by byte");
    verb->add_option("files", options->files, "Campaign files (.h5), records of floes replay, journals (.journal)")
        ->required();
    verb->add_option("--format", options->format, "table or json")
        ->check(CLI::IsMember({"table", "json"}))
        ->capture_default_str();
    verb->footer(
        "Exit status: 0 all good, 1 one is damaged, 2 none is damaged but one is no file of floes, or of a\nnewer "
        "one.");
    verb->callback([options, &exit_status] { exit_status = verify(options->files, options->format); });
}

}  // namespace floes
