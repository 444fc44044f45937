#include "cli/commands.hpp"

namespace floes {

Option add_overrides(OptionList& verb, std::vector<std::string>& overrides) {
    // One value for each --set: the next word is an argument of the verb.
    return verb.option("--set", overrides, "key=value: override a key of the file; may be repeated").one_each();
}

void add_format(OptionList& verb, std::string& format) {
    verb.option("--format", format, "table, json or csv").one_of({"table", "json", "csv"}).shows_default();
}

void add_window(OptionList& verb, std::string& window) {
    verb.option("--window", window,
                "Analysis window: given (as configured), or auto (from the start of the steady state, found in "
                "the histories)")
        .one_of({"given", "auto"})
        .shows_default();
}

}  // namespace floes
