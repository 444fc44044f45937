// Completions for bash, zsh and fish: words of a list, keys behind --set, cases of the campaign file on the line, files
// of the kind that a verb reads.

#include "completion_source.hpp"

namespace floes::manual {

std::vector<Page> completions(const std::vector<VerbText>& verbs) {
    return {{"floes.bash", bash(verbs)}, {"_floes", zsh(verbs)}, {"floes.fish", fish(verbs)}};
}

}  // namespace floes::manual
