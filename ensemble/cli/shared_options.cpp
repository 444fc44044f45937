#include "cli/commands.hpp"

namespace floes {

CLI::Option* add_overrides(CLI::App& verb, std::vector<std::string>& overrides) {
    // One value for each --set: the next word is an argument of the verb.
    return verb.add_option("--set", overrides, "key=value: override a key of the file; may be repeated")
        ->type_size(1)
        ->allow_extra_args(false);
}

void add_format(CLI::App& verb, std::string& format) {
    verb.add_option("--format", format, "table, json or csv")
        ->check(CLI::IsMember({"table", "json", "csv"}))
        ->capture_default_str();
}

void add_window(CLI::App& verb, std::string& window) {
    verb.add_option("--window", window,
                    "Analysis window: given (as configured), or auto (from the start of the steady state, found in "
                    "the histories)")
        ->check(CLI::IsMember({"given", "auto"}))
        ->capture_default_str();
}

}  // namespace floes
