// floes new: the configuration that a first campaign begins with.

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "cli/commands.hpp"
#include "cli/starter.hpp"
#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "records/file_calls.hpp"

namespace floes {
namespace {

struct NewOptions {
    std::string file;
    bool full_scale = false;
    bool design = false;
    bool paper = false;
};

Starter starter_of(const NewOptions& options) {
    if (options.full_scale) return Starter::full_scale;
    if (options.design) return Starter::design;
    return options.paper ? Starter::paper : Starter::tank;
}

/// Makes the file; one that exists is never touched.
void write_new(const std::filesystem::path& path, const std::string& text) {
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() < 0 && errno == EEXIST)
        throw InputError(fmt::format("{} exists already and is left as it is; give another name.", path.string()));
    if (file.get() < 0)
        throw InputError(fmt::format("{} cannot be written: {}. The folder must exist and permit it.", path.string(),
                                     std::strerror(errno)));
    write_all(file, path, std::as_bytes(std::span(text)));
}

int make(const NewOptions& options) {
    const std::filesystem::path path = options.file;
    if (path.extension() != ".toml")
        throw InputError(fmt::format("{} is to be a configuration, whose name ends with .toml.", options.file));
    write_new(path, starter_text(starter_of(options), path.filename().string()));
    std::printf("%s\n", options.file.c_str());
    const std::string result = std::filesystem::path(path).replace_extension(".h5").filename().string();
    fmt::print(stderr, "floes: edit it, then floes run {0}, and floes summarize {1}\n", options.file, result);
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
    design.excludes(full_scale);
    paper.excludes(full_scale).excludes(design);
    verb.runs([options] { return make(*options); });
}

}  // namespace floes
