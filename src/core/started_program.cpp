#include "core/started_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "core/descriptor.hpp"

namespace floes {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds between_looks{10};
constexpr std::size_t most_output = 4096;

bool is_executable(const std::string& path) {
    struct stat found {};
    return ::stat(path.c_str(), &found) == 0 && S_ISREG(found.st_mode) && ::access(path.c_str(), X_OK) == 0;
}

Clock::time_point after(Seconds time) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
}

}  // namespace

bool is_program(const std::string& name) {
    if (name.find('/') != std::string::npos) return is_executable(name);
    const char* path = std::getenv("PATH");
    std::string folders = path != nullptr ? path : "";
    for (std::size_t at = 0; at <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', at), folders.size());
        const std::string folder = folders.substr(at, end - at);
        if (is_executable((folder.empty() ? "." : folder) + "/" + name)) return true;
        at = end + 1;
    }
    return false;
}

StartedProgram::StartedProgram(std::vector<std::string> words, const Streams& streams) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    const std::array given{streams.in, streams.out, streams.errors};
    for (int stream = 0; stream < 3; ++stream) {
        const int descriptor = given[static_cast<std::size_t>(stream)];
        if (descriptor >= 0)
            ::posix_spawn_file_actions_adddup2(&actions, descriptor, stream);
        else
            ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
    }
    // A run that outlives its readers ignores SIGPIPE, which other programs do not expect.
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t defaults;
    ::sigemptyset(&defaults);
    ::sigaddset(&defaults, SIGPIPE);
    ::posix_spawnattr_setsigdefault(&attributes, &defaults);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    const int error = ::posix_spawnp(&process_, arguments[0], &actions, &attributes, arguments.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error == 0) return;
    process_ = -1;
    fault_ = std::strerror(error);
}

bool StartedProgram::ended() {
    if (process_ < 0) return true;
    int status = 0;
    const pid_t found = ::waitpid(process_, &status, WNOHANG);
    if (found == 0 || (found < 0 && errno == EINTR)) return false;
    process_ = -1;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return true;
}

bool StartedProgram::wait(Seconds longest) {
    for (const auto end = after(longest); !ended(); std::this_thread::sleep_for(between_looks)) {
        if (Clock::now() < end) continue;
        kill();
        return false;
    }
    return true;
}

void StartedProgram::kill() {
    constexpr Seconds longest_end{2};  // a process that waits for a dead file system does not even die of SIGKILL
    if (ended()) return;
    ::kill(process_, SIGKILL);
    for (const auto end = after(longest_end); !ended() && Clock::now() < end;)
        std::this_thread::sleep_for(between_looks);
    process_ = -1;
    status_.reset();
}

ProgramAnswer answer_of(std::vector<std::string> words, Seconds longest) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {std::strerror(errno), {}, {}};
    const Descriptor read_end(ends[0]);
    Descriptor write_end(ends[1]);
    StartedProgram program(std::move(words), {.out = write_end.get()});
    write_end.close();
    if (!program.fault().empty()) return {program.fault(), {}, {}};
    ProgramAnswer answer;
    const auto end = after(longest);
    // A process that it left behind may keep the pipe open, so its own end counts, too.
    for (bool over = false, open = true; open && Clock::now() < end;) {
        pollfd wait{read_end.get(), POLLIN, 0};
        if (::poll(&wait, 1, over ? 0 : static_cast<int>(between_looks.count())) <= 0) {
            if (over) break;
            over = program.ended();
            continue;
        }
        std::array<char, most_output> piece{};
        const ssize_t size = ::read(read_end.get(), piece.data(), piece.size());
        open = size > 0 || (size < 0 && errno == EINTR);
        if (size > 0)
            answer.output.append(piece.data(),
                                 std::min(static_cast<std::size_t>(size), most_output - answer.output.size()));
    }
    if (program.wait(end - Clock::now())) answer.status = program.status();
    return answer;
}

}  // namespace floes
