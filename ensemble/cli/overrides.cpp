#include "cli/commands.hpp"

namespace floes {

CLI::Option* add_overrides(CLI::App& verb, std::vector<std::string>& overrides) {
    // One value for each --set: the next word is an argument of the verb.
    return verb.add_option("--set", overrides, "key=value: override a key of the file; may be repeated")
        ->type_size(1)
        ->allow_extra_args(false);
}

}  // namespace floes
