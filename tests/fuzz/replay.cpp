// replay CORPUS SECONDS [DICTIONARY]: what a target does with its corpus and then, for so many seconds, with seeded
// changes of it, in the order that the seed gives. For default tests, which have no libFuzzer. An input that ends the
// program is left in the file "finding".

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "fuzz/fuzz.hpp"
#include "support/file_bytes.hpp"

namespace {

using Input = std::string;

constexpr unsigned longest_input = 10;      // s
constexpr rlim_t most_memory = 1ULL << 30;  // bytes
constexpr std::size_t largest_input = 1 << 16;

const Input* current = nullptr;  // for the handler of signals

void leave_finding(int signal) {
    const int file = ::open("finding", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file >= 0 && current != nullptr && ::write(file, current->data(), current->size()) < 0) ::_exit(3);
    ::_exit(128 + signal);
}

void run(const Input& input) {
    current = &input;
    ::alarm(longest_input);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

std::vector<Input> corpus_of(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::vector<Input> corpus;
    for (const auto& path : paths) corpus.push_back(floes::file_text(path));
    return corpus;
}

/// The words in quotes, without escapes.
std::vector<Input> words_of(const std::filesystem::path& dictionary) {
    std::vector<Input> words;
    std::ifstream file(dictionary);
    for (std::string line; std::getline(file, line);) {
        const std::size_t open = line.find('"');
        const std::size_t close = line.rfind('"');
        if (line.starts_with('#') || close == std::string::npos || close <= open) continue;
        Input word = line.substr(open + 1, close - open - 1);
        if (word.find("\\x") != std::string::npos) continue;
        std::erase(word, '\\');
        words.push_back(word);
    }
    return words;
}

class Changer {
  public:
    Changer(const std::vector<Input>& corpus, const std::vector<Input>& words) : corpus_(corpus), words_(words) {}

    Input next() {
        Input input = one_of(corpus_);
        for (std::size_t changes = 1 + below(6); changes > 0; --changes) change(input);
        if (input.size() > largest_input) input.resize(largest_input);
        return input;
    }

  private:
    std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }
    const Input& one_of(const std::vector<Input>& list) { return list[below(list.size())]; }

    void change(Input& input) {
        const std::size_t at = below(input.size() + 1);
        const std::size_t length = below(std::min<std::size_t>(input.size() - at, 64) + 1);
        switch (below(9)) {
            case 0:
                if (at < input.size()) input[at] = static_cast<char>(input[at] ^ (1 << below(8)));
                break;
            case 1:
                if (at < input.size()) input[at] = static_cast<char>(random_());
                break;
            case 2:
                input.erase(at, length);
                break;
            case 3:
                input.insert(at, input.substr(at, length));
                break;
            case 4:
                input.insert(at, 1 + below(8), static_cast<char>(random_()));
                break;
            case 5:
                put_number(input, at);
                break;
            case 6:
                if (!words_.empty()) input.insert(at, one_of(words_));
                break;
            case 7:
                if (!words_.empty()) input.replace(at, length, one_of(words_));
                break;
            default:
                input.replace(at, input.size() - at, tail(one_of(corpus_)));
        }
    }

    /// A length or a count that few programs expect.
    void put_number(Input& input, std::size_t at) {
        constexpr std::uint64_t numbers[]{0, 1, 127, 128, 255, 1 << 16, 1ULL << 31, 1ULL << 32, 1ULL << 62, ~0ULL};
        const std::uint64_t number = numbers[below(std::size(numbers))];
        for (std::size_t k = 0; k < sizeof number && at + k < input.size(); ++k)
            input[at + k] = static_cast<char>(number >> (8 * k));
    }

    Input tail(const Input& input) { return input.substr(below(input.size() + 1)); }

    std::mt19937_64 random_;
    const std::vector<Input>& corpus_;
    const std::vector<Input>& words_;
};

void bound_memory() {
#ifndef __SANITIZE_ADDRESS__  // whose shadow is larger
    const rlimit limit{most_memory, most_memory};
    ::setrlimit(RLIMIT_DATA, &limit);
#endif
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) return 2;
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM}) std::signal(signal, leave_finding);
    bound_memory();
    const std::vector<Input> corpus = corpus_of(arguments[1]);
    const std::vector<Input> words = count > 3 ? words_of(arguments[3]) : std::vector<Input>{};
    if (corpus.empty()) return 2;
    for (const Input& input : corpus) run(input);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(std::stoi(arguments[2]));
    std::uint64_t changed = 0;
    for (Changer changer(corpus, words); std::chrono::steady_clock::now() < end; ++changed) run(changer.next());
    std::printf("%zu inputs of the corpus, %llu changed ones\n", corpus.size(),
                static_cast<unsigned long long>(changed));
    return 0;
}
