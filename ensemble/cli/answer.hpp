#pragma once
// What verbs give: results as text for the width of standard output, files, and words for a user who waits.

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/started_program.hpp"
#include "tables/figure_text.hpp"
#include "tables/section.hpp"

namespace floes {

/// Characters on a line of standard output: of the terminal, otherwise the environment's COLUMNS, otherwise 100; at
/// least 40.
int terminal_width();

/// The lines of a text that are not empty.
std::vector<std::string> filled_lines(std::string_view text);

/// Whether the terminal shows more than ASCII, as the environment has it.
Letters letters_of_terminal();

/// The sections in that format: "table", "json" or "csv".
std::string written(const std::vector<Section>& sections, const std::string& format, const Units& units = {});

/// Those on standard output.
void print(const std::vector<Section>& sections, const std::string& format, const Units& units = {});

/// A sentence for the user on standard error, beside the answer: "floes: a.svg is written".
template <class... Values>
void note(fmt::format_string<Values...> sentence, Values&&... values) {
    const std::string text = fmt::format(sentence, std::forward<Values>(values)...);
    std::fputs(("floes: " + text + "\n").c_str(), stderr);
}

/// A file of ensemble/cli/starters or arrays by its name, as it was when the program was built.
std::optional<std::string_view> starter(std::string_view name);

/// Makes a file of that text; one that exists is never touched. Throws InputError.
void write_new(const std::filesystem::path& path, const std::string& text);

/// Throws InputError, with what to do, unless a file can be written at `path`: its folder is there and permits it, and
/// so is the program that a .pdf or a film needs. For verbs that work for long before they write.
void expect_place(const std::filesystem::path& path);

// Writes a page that a browser may be reading at the same time.

/// Writes a temporary file and renames it, so that a reader finds either the old page or the new one. A path that ends
/// with .pdf gets the page as a browser of this machine prints it (FLOES_BROWSER names one). Throws RunError if the
/// file cannot be written or the browser does not print it in time, InputError where there is no browser.
void write_page(const std::filesystem::path& path, const std::string& page, Seconds longest_print = Seconds(300));

// The progress of one long computation on standard error: a line that is updated on a terminal, elsewhere a new line
// every ten seconds.

class ProgressLine {
  public:
    /// what: "computing member 3".
    explicit ProgressLine(std::string what);
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine();  // ends the live line

    /// done: share, 0-1. Says "computing member 3: 47 %, 14 s left" if that is due.
    void show(double done);

  private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    bool live_;
    bool open_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_ = Clock::now();
};

// A note for a user who has to wait.

/// Prints on `out`, once, what the program is doing, if the object still exists after `patience`.
class WaitingNote {
  public:
    WaitingNote(std::ostream& out, std::string doing, std::chrono::milliseconds patience = std::chrono::seconds(2));

  private:
    std::mutex mutex_;
    std::condition_variable_any over_;
    std::jthread waiting_;  // the last: it ends before what it uses
};

}  // namespace floes
