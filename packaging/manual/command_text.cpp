#include "command_text.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace floes::manual {

namespace {

/// Makes the parts of --help, which CLI11 keeps to its formatter.
class Parts : public CLI::Formatter {
  public:
    Parts() = default;

    OptionText option(const CLI::Option& option, const std::string& group) const {
        const bool positional = option.get_positional();
        return {.names = CLI::detail::split(make_option_name(&option, positional), ','),
                .values = CLI::detail::trim_copy(make_option_opts(&option)),
                .description = make_option_desc(&option),
                .choices = choices(option.get_type_name()),
                .group = group,
                .takes_value = option.get_items_expected_max() > 0,
                .positional = positional};
    }

    std::string usage(const CLI::App& verb, const std::string& name) const {
        return make_usage(&verb, name).substr(sizeof("Usage: ") - 1);
    }

  private:
    /// "TEXT:{none,process}" -> none, process.
    static std::vector<std::string> choices(const std::string& type) {
        const std::size_t begin = type.find('{');
        const std::size_t end = type.find('}', begin);
        if (begin == std::string::npos || end == std::string::npos) return {};
        return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
    }
};

void add_options(const CLI::App& app, const Parts& parts, std::vector<OptionText>& options) {
    const std::string group = app.get_name().empty() && app.get_parent() != nullptr ? app.get_description() : "";
    for (const CLI::Option* option : app.get_options({}))
        if (!option->get_group().empty() && (group.empty() || option != app.get_help_ptr()))
            options.push_back(parts.option(*option, group));
    for (const CLI::App* inner : app.get_subcommands({}))
        if (inner->get_name().empty()) add_options(*inner, parts, options);  // an option group
}

VerbText text_of(const CLI::App& app, const std::string& name, const std::string& command) {
    const Parts parts;
    VerbText text{name, app.get_description(), parts.usage(app, command), app.get_footer(), {}, {}};
    while (!text.usage.empty() && text.usage.back() == '\n') text.usage.pop_back();
    add_options(app, parts, text.options);
    return text;
}

}  // namespace

std::vector<VerbText> verbs_of(const CLI::App& program) {
    std::vector<VerbText> verbs{text_of(program, "floes", "floes")};
    for (const CLI::App* verb : program.get_subcommands({})) {
        if (verb->get_group().empty()) continue;
        const std::string name = verb->get_name();
        const std::size_t place = verbs.size();
        verbs.push_back(text_of(*verb, name, fmt::format("floes {}", name)));
        for (const CLI::App* inner : verb->get_subcommands({})) {
            if (inner->get_name().empty()) continue;  // an option group
            const std::string both = fmt::format("{} {}", name, inner->get_name());
            verbs.push_back(text_of(*inner, both, fmt::format("floes {}", both)));
            verbs[place].inner.push_back(inner->get_name());
        }
    }
    return verbs;
}

}  // namespace floes::manual
