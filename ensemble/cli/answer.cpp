#include "cli/answer.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <ranges>
#include <span>

#include <fmt/ranges.h>

#include "cli/given.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "draw/film.hpp"
#include "run/progress.hpp"
#include "store/file_calls.hpp"

namespace floes {

namespace fs = std::filesystem;

int terminal_width() {
    int width = 100;
    winsize window{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0) {
        width = window.ws_col;
    } else if (const char* columns = std::getenv("COLUMNS")) {
        const int wished = std::atoi(columns);
        if (wished > 0) width = wished;
    }
    return std::max(width, 40);
}

std::vector<std::string> filled_lines(std::string_view text) {
    std::vector<std::string> lines;
    for (const auto line : std::views::split(text, '\n'))
        if (!line.empty()) lines.emplace_back(line.begin(), line.end());
    return lines;
}

Letters letters_of_terminal() {
    for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
        const char* value = std::getenv(name);
        if (value == nullptr || *value == '\0') continue;
        std::string words(value);
        std::ranges::transform(words, words.begin(), [](unsigned char c) { return std::tolower(c); });
        return words.find("utf-8") != std::string::npos || words.find("utf8") != std::string::npos ? Letters::unicode
                                                                                                   : Letters::ascii;
    }
    return Letters::ascii;
}

std::string written(const std::vector<Section>& sections, const std::string& format, const Units& units) {
    if (format == "json") return json(sections);
    return format == "csv" ? csv(sections) : text(sections, terminal_width(), units);
}

void print(const std::vector<Section>& sections, const std::string& format, const Units& units) {
    std::fputs(written(sections, format, units).c_str(), stdout);
}

void write_new(const fs::path& path, const std::string& text) {
    const OpenFile file(this_system(), this_system().open(path, O_WRONLY | O_CREAT | O_EXCL), path);
    if (file.get() == -EEXIST)
        throw InputError(fmt::format("{} exists already and is left as it is; give another name.", path.string()));
    if (file.get() < 0)
        throw InputError(fmt::format("{} cannot be written: {}. The folder must exist and permit it.", path.string(),
                                     std::strerror(-file.get())));
    try {
        write_all(file, std::as_bytes(std::span(text)));
    } catch (const RunError&) {
        std::error_code ignored;
        fs::remove(path, ignored);
        throw;
    }
}

namespace {

/// The browser that prints a page as the file `named`. Throws InputError where there is none.
std::string browser_for(const fs::path& named) {
    std::vector<std::string> browsers{"chromium", "chromium-browser", "google-chrome", "google-chrome-stable",
                                      "microsoft-edge"};
    if (const char* given = std::getenv("FLOES_BROWSER"); given != nullptr && *given != '\0') browsers = {given};
    const auto found = std::ranges::find_if(browsers, is_program);
    if (found != browsers.end()) return *found;
    throw InputError(fmt::format(
        "{} would be printed by a browser, and {} cannot be started. Install one of Chromium's kind, name it with "
        "FLOES_BROWSER, or write {} and print it yourself",
        named.string(), fmt::join(browsers, ", "), fs::path(named).replace_extension(".html").string()));
}

}  // namespace

void expect_place(const fs::path& path) {
    const fs::path target = target_of(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const auto refuse = [&](const std::string& why) {
        return InputError(
            fmt::format("{} cannot be written: {}; make the folder, or name another", path.string(), why));
    };
    std::error_code unknown;
    if (!fs::exists(folder, unknown)) throw refuse(fmt::format("there is no folder {}", folder.string()));
    if (!fs::is_directory(folder, unknown)) throw refuse(fmt::format("{} is no folder", folder.string()));
    if (fs::is_directory(target, unknown))
        throw InputError(fmt::format("{} is a folder; name a file in it", path.string()));
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw InputError(fmt::format("{} cannot be written: the folder {} does not permit it ({}); name another folder",
                                     path.string(), folder.string(), std::strerror(errno)));
    if (target.extension() == ".pdf") browser_for(path);
    expect_encoder(target);
}

namespace {

/// Prints the page in the file `from` to the file `to`. Our pages have no scripts and load nothing, so the browser
/// needs no sandbox, which it would not get as root or in a container.
void print_page(const fs::path& from, const fs::path& to, const fs::path& named, Seconds longest) {
    const std::string browser = browser_for(named);
    const ProgramAnswer answer = answer_of(
        {browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer", "--print-to-pdf-no-header",
         "--print-to-pdf=" + fs::absolute(to).string(), "file://" + fs::absolute(from).string()},
        longest);
    if (answer.good() && first_bytes(to).starts_with("%PDF")) return;
    const std::string why = !answer.fault.empty() ? answer.fault
                            : answer.status       ? fmt::format("exit status {}", *answer.status)
                                                  : fmt::format("it took longer than {:g} s", longest.count());
    throw RunError(fmt::format("{} could not print {} ({}); write {} and print it from a browser.", browser,
                               named.string(), why, fs::path(named).replace_extension(".html").string()));
}

}  // namespace

void write_page(const fs::path& path, const std::string& page, Seconds longest_print) {
    const fs::path target = target_of(path);
    const bool printed = target.extension() == ".pdf";
    const AsideFile aside(target.string() + (printed ? ".tmp.html" : ".tmp"));
    std::ofstream file(aside.path(), std::ios::binary);
    file << page;
    file.close();
    if (!file) throw not_written(path, std::strerror(errno));
    const AsideFile print(target.string() + ".tmp.pdf");
    if (printed) print_page(aside.path(), print.path(), path, longest_print);
    std::error_code error;
    fs::rename(printed ? print.path() : aside.path(), target, error);
    if (error) throw not_written(path, error.message());
}

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), live_(style_of_standard_error() == Progress::Style::live) {}

ProgressLine::~ProgressLine() {
    if (open_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double done) {
    const Clock::time_point now = Clock::now();
    if (now - last_ < (live_ ? std::chrono::milliseconds(500) : std::chrono::seconds(10)) || !(done > 0)) return;
    last_ = now;
    const double passed = std::chrono::duration<double>(now - begin_).count();
    const std::string text =
        fmt::format("{}: {:.0f} %, {} left", what_, 100 * done, duration_text(passed * (1 - done) / done));
    std::fputs((live_ ? "\r\033[K" + text : text + "\n").c_str(), stderr);
    open_ = live_;
}

WaitingNote::WaitingNote(std::ostream& out, std::string doing, std::chrono::milliseconds patience)
    : waiting_([this, &out, doing = std::move(doing), patience](const std::stop_token& stop) {
          std::unique_lock lock(mutex_);
          over_.wait_for(lock, stop, patience, [] { return false; });
          if (!stop.stop_requested()) out << "floes: " + doing + "\n" << std::flush;
      }) {}

}  // namespace floes
