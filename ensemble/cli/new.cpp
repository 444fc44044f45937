#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "campaign/variations.hpp"
#include "cli/commands.hpp"
#include "cli/config.hpp"
#include "cli/files.hpp"
#include "core/error.hpp"
#include "core/shell_word.hpp"

// floes new: the configuration that a first campaign begins with.

namespace floes {

namespace {

struct NewOptions {
    std::string file;
    bool full_scale = false;
    bool moored = false;
    bool design = false;
    bool paper = false;
};

/// The text of the configuration `name`, which floes config --check accepts.
std::string text_of(const NewOptions& options, const std::string& name) {
    const char* file = options.full_scale ? "full_scale.toml"
                       : options.moored   ? "moored.toml"
                       : options.design   ? "design.toml"
                       : options.paper    ? "paper.toml"
                                          : "tank.toml";
    std::string text{starter(file).value()};
    constexpr std::string_view placeholder = "CONFIG.toml";
    return text.replace(text.find(placeholder), placeholder.size(), name);
}

int make(const NewOptions& options) {
    const std::filesystem::path path = options.file;
    if (path.extension() != ".toml")
        throw InputError(fmt::format("{} is to be a configuration, whose name ends with .toml.", options.file));
    write_new(path, text_of(options, path.filename().string()));
    std::printf("%s\n", options.file.c_str());
    const std::string result = std::filesystem::path(path).replace_extension(".h5").filename().string();
    fmt::print(stderr, "floes: edit it, then floes run {0}, and floes summarize {1}\n", shell_word(options.file),
               shell_word(result));
    return 0;
}

}  // namespace

void add_new(CommandLine& line) {
    auto options = std::make_shared<NewOptions>();
    Verb verb = line.verb("new", "Write a configuration to begin with: the keys that everybody sets");
    verb.option("config", options->file, "The configuration to make (CONFIG.toml)").required();
    Option full_scale =
        verb.flag("--full-scale", options->full_scale, "A floater of 70 m in floes of 20 m, instead of model ice");
    Option design = verb.flag("--design", options->design, "A design over two keys: how the load depends on them");
    Option paper = verb.flag("--paper", options->paper, "The paper's Table 3, with few arrangements");
    Option moored =
        verb.flag("--moored", options->moored, "A moored hull that floats among floes of mixed shapes, at full scale");
    design.excludes(full_scale);
    paper.excludes(full_scale).excludes(design);
    moored.excludes(full_scale).excludes(design).excludes(paper);
    verb.runs([options] { return make(*options); });
}

// floes vary: the configuration of a study that varies what the model leaves open, one input at a time.

namespace {

struct VaryOptions {
    std::string file;
    std::string case_name;
    std::vector<std::string> overrides;
};

int vary(const VaryOptions& options) {
    const Campaign campaign = load_campaign(options.file, options.overrides);
    std::fputs(variations_text(campaign, chosen_case(campaign, options.case_name)).c_str(), stdout);
    return 0;
}

}  // namespace

void add_vary(CommandLine& line) {
    auto options = std::make_shared<VaryOptions>();
    Verb verb = line.verb("vary", "Write a study of what the model leaves open: friction, strength, water, channel");
    verb.option("config", options->file, "The configuration (CONFIG.toml)").required();
    verb.option("--case", options->case_name, "The case to vary, if there are several");
    verb.option("--set", options->overrides, "key=value: override a key of the file; may be repeated");
    verb.footer(
        "The study goes to standard output. It has the case as it is and some twenty others, each with one input\n"
        "changed as far as it is usually unknown; edit it as you know better. Eight arrangements and more say "
        "something.\n\n"
        "  floes vary my.toml --set campaign.arrangements=12 > varied.toml\n"
        "  floes run varied.toml\n"
        "  floes summarize varied.h5 --parts model");
    verb.runs([options] { return vary(*options); });
}

}  // namespace floes
