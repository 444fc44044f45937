#pragma once
// Other programs of this machine, which are started and never waited for longer than said: squeue, ffmpeg, a browser.

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace floes {

using Seconds = std::chrono::duration<double>;

/// Whether such a program can be started: a path, or a name that is looked for in PATH.
bool is_program(const std::string& name);

/// Killed at the end of its lifetime if it still runs then.
class StartedProgram {
  public:
    /// Descriptors that the program gets; -1: nothing to read, and nobody who reads.
    struct Streams {
        int in = -1;
        int out = -1;
        int errors = -1;
    };

    /// `words`: the program and its arguments.
    StartedProgram(std::vector<std::string> words, const Streams& streams);
    StartedProgram(const StartedProgram&) = delete;
    StartedProgram& operator=(const StartedProgram&) = delete;
    ~StartedProgram() { kill(); }

    /// Why it could not be started, in the system's words; empty: it was.
    const std::string& fault() const { return fault_; }
    /// Whether it ended within that time; what still runs then is killed.
    bool wait(Seconds longest);
    void kill();
    bool ended();
    /// Its exit status, or 128 and its signal; only after it ended by itself.
    int status() const { return *status_; }

  private:
    pid_t process_ = -1;
    std::string fault_;
    std::optional<int> status_;
};

/// What a program said that ran to its end.
struct ProgramAnswer {
    std::string fault;          ///< why it could not be started; empty: it was
    std::optional<int> status;  ///< as of StartedProgram; none: it took longer, and was killed
    std::string output;         ///< the first 4096 bytes of it

    bool good() const { return status && *status == 0; }
};

/// Runs a program that reads nothing, and whose errors nobody sees.
ProgramAnswer answer_of(std::vector<std::string> words, Seconds longest);

}  // namespace floes
