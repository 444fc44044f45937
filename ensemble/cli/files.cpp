#include "cli/files.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign_file/publish.hpp"
#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "core/shell_word.hpp"
#include "run/parts.hpp"
#include "store/file_calls.hpp"
#include "store/journal.hpp"

namespace floes {

namespace {

namespace fs = std::filesystem;

std::string first_bytes(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string bytes(512, '\0');
    in.read(bytes.data(), std::ssize(bytes));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}

/// A campaign file that is not there.
std::string missing(const fs::path& path) {
    const fs::path journal = journal_path(path);
    if (given_file(journal) != GivenFile::journal) return fmt::format("there is no file {}.", path.string());
    const std::string so_far = fs::path(path).replace_extension("").string() + "_so_far.h5";
    return fmt::format(
        "there is no file {0} yet, but its journal {1} has the members that are done: floes run CONFIG.toml -o {0} "
        "--resume computes the rest and writes the file; floes merge {0} -o {2} writes one of what is done.",
        path.string(), journal.string(), so_far);
}

std::string what_it_is(const fs::path& path, GivenFile kind) {
    const std::string name = path.string();
    const std::string campaign_file = fs::path(path).replace_extension(".h5").string();
    switch (kind) {
        case GivenFile::nothing:
            return missing(path);
        case GivenFile::folder:
            return fmt::format("{} is a folder; give a campaign file in it, the .h5 that floes run wrote.", name);
        case GivenFile::unreadable:
            return fmt::format("{} may not be read by you; its owner has to permit it (chmod).", name);
        case GivenFile::journal:
            return fmt::format("{} is the journal of a campaign; give its campaign file, {}.", name, campaign_file);
        case GivenFile::text:
            if (path.extension() == ".toml")
                return fmt::format("{0} is a configuration, not a campaign file; floes run {0} -o {1} makes {1}.", name,
                                   campaign_file);
            return fmt::format("{} is a text, not a campaign file; give the .h5 that floes run wrote.", name);
        case GivenFile::hdf5:
        case GivenFile::other:
            break;
    }
    return fmt::format("{} is no campaign file; give the .h5 that floes run wrote.", name);
}

}  // namespace

GivenFile given_file(const fs::path& path) {
    constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
    std::error_code unknown;
    if (fs::is_directory(path, unknown)) return GivenFile::folder;
    if (!fs::exists(path, unknown)) return GivenFile::nothing;
    if (::access(path.c_str(), R_OK) != 0) return GivenFile::unreadable;
    const std::string bytes = first_bytes(path);
    if (bytes.starts_with(hdf5_signature)) return GivenFile::hdf5;
    if (bytes.starts_with(journal_format::magic)) return GivenFile::journal;
    const bool control =
        std::ranges::any_of(bytes, [](unsigned char c) { return c < 32 && c != '\n' && c != '\t' && c != '\r'; });
    return control || bytes.empty() ? GivenFile::other : GivenFile::text;
}

void expect_campaign_file(const fs::path& path) {
    const GivenFile kind = given_file(path);
    if (kind != GivenFile::hdf5) throw InputError(what_it_is(path, kind));
}

GivenCampaign::GivenCampaign(const std::vector<std::string>& files) : path_(files.front()) {
    for (const std::string& file : files) words_ += (words_.empty() ? "" : " ") + shell_word(file);
    if (files.size() == 1) {
        expect_campaign_file(path_);
        return;
    }
    const Parts parts(std::vector<fs::path>(files.begin(), files.end()));
    tell_parts(parts);
    std::string folder = (fs::temp_directory_path() / "floes-parts-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr)
        throw RunError(fmt::format("no folder can be made in {} to merge the parts in ({}); TMPDIR names another.",
                                   fs::temp_directory_path().string(), std::strerror(errno)));
    path_ = fs::path(folder) / (parts.campaign().name + ".h5");
    merged_ = true;
    try {
        publish(path_, parts.campaign(), parts.members(), parts.sessions(), parts.calibrations());
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(path_.parent_path(), ignored);
        throw;
    }
}

GivenCampaign::~GivenCampaign() {
    std::error_code ignored;
    if (merged_) fs::remove_all(path_.parent_path(), ignored);
}

void tell_parts(const Parts& parts) {
    std::vector<std::string> sentences = parts.remarks();
    sentences.push_back(parts.missing_parts());
    sentences.push_back(parts.missing_members());
    for (const std::string& sentence : sentences)
        if (!sentence.empty()) fmt::print(stderr, "floes: {}\n", sentence);
}

void expect_no_other_file(const fs::path& path) {
    const GivenFile kind = given_file(path);
    std::error_code unknown;
    const bool empty_file = fs::is_regular_file(path, unknown) && fs::is_empty(path, unknown);
    if (empty_file && !fs::exists(journal_path(path), unknown))
        throw InputError(
            fmt::format("{} is an empty file, not a campaign that could be continued; delete it, or -o "
                        "names another file for the campaign.",
                        path.string()));
    if (kind == GivenFile::nothing || kind == GivenFile::hdf5 || empty_file) return;
    fs::path other = fs::path(path).replace_extension(".h5");
    if (other == path) other.replace_filename(path.stem().string() + "_campaign.h5");
    throw InputError(fmt::format("{} is {} and stays as it is; -o names another file for the campaign, as {}.",
                                 path.string(),
                                 kind == GivenFile::folder    ? "a folder"
                                 : kind == GivenFile::journal ? "a journal"
                                                              : "no campaign file",
                                 other.string()));
}

void write_new(const fs::path& path, const std::string& text) {
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() < 0 && errno == EEXIST)
        throw InputError(fmt::format("{} exists already and is left as it is; give another name.", path.string()));
    if (file.get() < 0)
        throw InputError(fmt::format("{} cannot be written: {}. The folder must exist and permit it.", path.string(),
                                     std::strerror(errno)));
    try {
        write_all(file, path, std::as_bytes(std::span(text)));
    } catch (const RunError&) {
        std::error_code ignored;
        fs::remove(path, ignored);
        throw;
    }
}

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
}

namespace {

/// Takes the file away that it names, unless it was renamed.
class AsideFile {
  public:
    explicit AsideFile(fs::path path) : path_(std::move(path)) {}
    AsideFile(const AsideFile&) = delete;
    AsideFile& operator=(const AsideFile&) = delete;
    ~AsideFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

[[noreturn]] void refuse_page(const fs::path& path, const std::string& reason) {
    throw RunError(
        fmt::format("{} cannot be written ({}); does the folder exist, and has it free space?", path.string(), reason));
}

/// The exit status of a program with these words, which says nothing here; none where there is no such program.
std::optional<int> status_of(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
    pid_t process = -1;
    const int error = ::posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) return std::nullopt;
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Prints the page in the file `from` to the file `to`. Our pages have no scripts and load nothing, so the browser
/// needs no sandbox, which it would not get as root or in a container.
void print_page(const fs::path& from, const fs::path& to, const fs::path& named) {
    std::vector<std::string> browsers{"chromium", "chromium-browser", "google-chrome", "google-chrome-stable",
                                      "microsoft-edge"};
    if (const char* given = std::getenv("FLOES_BROWSER"); given != nullptr && *given != '\0') browsers = {given};
    for (const std::string& browser : browsers) {
        const std::optional<int> status =
            status_of({browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer",
                       "--print-to-pdf-no-header", "--print-to-pdf=" + fs::absolute(to).string(),
                       "file://" + fs::absolute(from).string()});
        if (!status) continue;
        if (*status != 0 || !first_bytes(to).starts_with("%PDF"))
            throw RunError(fmt::format("{} could not print {} (exit status {}); write {} and print it from a browser.",
                                       browser, named.string(), *status,
                                       fs::path(named).replace_extension(".html").string()));
        return;
    }
    throw InputError(fmt::format(
        "{} would be printed by a browser, and {} cannot be started. Install one of Chromium's kind, name it with "
        "FLOES_BROWSER, or write {} and print it yourself.",
        named.string(), fmt::join(browsers, ", "), fs::path(named).replace_extension(".html").string()));
}

}  // namespace

void write_page(const fs::path& path, const std::string& page) {
    const fs::path target = target_of(path);
    const bool printed = target.extension() == ".pdf";
    const AsideFile aside(target.string() + (printed ? ".tmp.html" : ".tmp"));
    std::ofstream file(aside.path(), std::ios::binary);
    file << page;
    file.close();
    if (!file) refuse_page(path, std::strerror(errno));
    const AsideFile print(target.string() + ".tmp.pdf");
    if (printed) print_page(aside.path(), print.path(), path);
    std::error_code error;
    fs::rename(printed ? print.path() : aside.path(), target, error);
    if (error) refuse_page(path, error.message());
}

std::string typed_program(const std::string& program) {
    const char* launcher = std::getenv("FLOES_LAUNCHER");
    if (launcher != nullptr) return shell_word(launcher);
    return program.empty() ? "floes" : shell_word(program);
}

}  // namespace floes
