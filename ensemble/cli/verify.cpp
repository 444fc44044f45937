// floes verify: whether campaign files, records and journals are as they were written.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/verify_file.hpp"
#include "tables/data_rows.hpp"

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
    std::vector<DataRows> all{
        make_rows<FileVerdict>("files", verdicts,
                               {{"file", [](const FileVerdict& one) { return Datum(one.file); }},
                                {"kind", [](const FileVerdict& one) { return Datum(one.kind); }},
                                {"state", [](const FileVerdict& one) { return Datum(state_word(one)); }},
                                {"checked", [](const FileVerdict& one) { return Datum(one.counts); }},
                                {"digest", [](const FileVerdict& one) { return Datum(one.digest); }},
                                {"whole", [](const FileVerdict& one) { return Datum(one.whole); }},
                                {"remedy", [](const FileVerdict& one) { return Datum(one.remedy); }}})};
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
        all.push_back(make_list(fmt::format("files/{}/faults", k), verdicts[k].faults));
        all.push_back(make_list(fmt::format("files/{}/notes", k), verdicts[k].notes));
    }
    return json(all);
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

void add_verify(CommandLine& line) {
    struct Options {
        std::vector<std::string> files;
        std::string format = "table";
    };
    auto options = std::make_shared<Options>();
    Verb verb =
        line.verb("verify", "Check that campaign files, records and journals are as they were written, byte by byte");
    verb.option("files", options->files, "Campaign files (.h5), records of floes replay, journals (.journal)")
        .required();
    verb.option("--format", options->format, "table or json").one_of({"table", "json"}).shows_default();
    verb.footer(
        "Exit status: 0 all good, 1 one is damaged, 2 none is damaged but one is no file of floes, or of a\nnewer "
        "one.");
    verb.runs([options] { return verify(options->files, options->format); });
}

}  // namespace floes
