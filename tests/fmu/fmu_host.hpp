#pragma once
// A host of FMUs, as small as one can be: unpacks the archive, opens the library and calls its functions, which it
// declares by itself as the standards do. Both versions look the same from here.

#include <dlfcn.h>
#include <zlib.h>

#include <cstdarg>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace floes {

enum class HostStatus { ok, warning, discard, error, fatal };

// The archive.

struct ZippedFile {
    unsigned version = 0, method = 0;
    std::string bytes;
};

inline unsigned little_endian(const std::string& text, std::size_t at, int bytes) {
    unsigned value = 0;
    for (int k = bytes; k-- > 0;)
        value = value << 8 | static_cast<unsigned char>(text.at(at + static_cast<std::size_t>(k)));
    return value;
}

/// By name, as the central directory lists them.
inline std::map<std::string, ZippedFile> unzipped(const std::string& archive) {
    std::map<std::string, ZippedFile> files;
    const std::size_t end = archive.size() - 22;
    if (little_endian(archive, end, 4) != 0x06054b50) throw std::runtime_error("no zip archive");
    std::size_t at = little_endian(archive, end + 16, 4);
    for (unsigned left = little_endian(archive, end + 10, 2); left > 0; --left) {
        ZippedFile file{little_endian(archive, at + 6, 2), little_endian(archive, at + 10, 2), {}};
        const unsigned crc = little_endian(archive, at + 16, 4);
        const unsigned packed = little_endian(archive, at + 20, 4);
        const unsigned length = little_endian(archive, at + 28, 2);
        const std::string name = archive.substr(at + 46, length);
        const std::size_t local = little_endian(archive, at + 42, 4);
        if (little_endian(archive, local, 4) != 0x04034b50) throw std::runtime_error("no local header");
        const std::size_t begin =
            local + 30 + little_endian(archive, local + 26, 2) + little_endian(archive, local + 28, 2);
        file.bytes.resize(little_endian(archive, at + 24, 4));
        z_stream stream{};
        inflateInit2(&stream, -MAX_WBITS);
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(archive.data() + begin));
        stream.avail_in = packed;
        stream.next_out = reinterpret_cast<Bytef*>(file.bytes.data());
        stream.avail_out = static_cast<uInt>(file.bytes.size());
        const int done = inflate(&stream, Z_FINISH);
        inflateEnd(&stream);
        if (done != Z_STREAM_END ||
            crc32(0, reinterpret_cast<const Bytef*>(file.bytes.data()), static_cast<uInt>(file.bytes.size())) != crc)
            throw std::runtime_error("damaged: " + name);
        files[name] = std::move(file);
        at += 46 + length + little_endian(archive, at + 30, 2) + little_endian(archive, at + 32, 2);
    }
    return files;
}

// The library.

/// An FMU whose archive lies unpacked in a folder, and whose library is open.
class OpenFmu {
  public:
    OpenFmu(const std::string& archive, int version) : version_(version) {
        for (const auto& [name, file] : unzipped(archive)) {
            const std::filesystem::path path = folder_ / name;
            std::filesystem::create_directories(path.parent_path());
            std::ofstream(path, std::ios::binary) << file.bytes;
        }
        const std::string library = version == 2 ? "binaries/linux64/floes.so" : "binaries/x86_64-linux/floes.so";
        library_ = dlopen((folder_ / library).c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library_ == nullptr) throw std::runtime_error(dlerror());
    }
    OpenFmu(const OpenFmu&) = delete;
    OpenFmu& operator=(const OpenFmu&) = delete;
    ~OpenFmu() { dlclose(library_); }

    int version() const { return version_; }
    std::string resources() const { return (folder_ / "resources").string(); }

    template <class Function>
    Function* function(const std::string& name) const {
        void* found = dlsym(library_, ("fmi" + std::to_string(version_) + name).c_str());
        if (found == nullptr) throw std::runtime_error("no function " + name);
        return reinterpret_cast<Function*>(found);
    }

  private:
    int version_;
    TemporaryFolder folder_;
    void* library_ = nullptr;
};

struct Callbacks2 {
    void (*logger)(void*, const char*, int, const char*, const char*, ...);
    void* (*allocate)(std::size_t, std::size_t);
    void (*release)(void*);
    void (*finished)(void*, int);
    void* environment;
};

class HostedInstance {
  public:
    /// May be null: is_there().
    HostedInstance(const OpenFmu& fmu, const std::string& token, std::string resources = {}) : fmu_(fmu) {
        if (fmu.version() == 2) {
            if (resources.empty()) resources = "file://" + fmu.resources();
            callbacks_ = {log_2, nullptr, nullptr, nullptr, this};
            using Make = void*(const char*, int, const char*, const char*, const Callbacks2*, int, int);
            instance_ =
                fmu.function<Make>("Instantiate")("one", 1, token.c_str(), resources.c_str(), &callbacks_, 0, 1);
        } else {
            if (resources.empty()) resources = fmu.resources() + "/";
            using Make = void*(const char*, const char*, const char*, bool, bool, bool, bool, const unsigned*,
                               std::size_t, void*, void (*)(void*, int, const char*, const char*), void*);
            instance_ = fmu.function<Make>("InstantiateCoSimulation")(
                "one", token.c_str(), resources.c_str(), false, true, false, false, nullptr, 0, this, log_3, nullptr);
        }
    }
    HostedInstance(const HostedInstance&) = delete;
    HostedInstance& operator=(const HostedInstance&) = delete;
    ~HostedInstance() { fmu_.function<void(void*)>("FreeInstance")(instance_); }

    bool is_there() const { return instance_ != nullptr; }
    const std::string& said() const { return said_; }  ///< last, in the log

    HostStatus initialize(double start = 0, double stop = -1) {
        const HostStatus entered = enter(start, stop);
        return entered == HostStatus::ok ? call("ExitInitializationMode") : entered;
    }
    HostStatus enter(double start = 0, double stop = -1) {
        if (fmu_.version() == 3)
            return status(fmu_.function<int(void*, bool, double, double, bool, double)>("EnterInitializationMode")(
                instance_, false, 0, start, stop >= 0, stop));
        fmu_.function<int(void*, int, double, double, int, double)>("SetupExperiment")(instance_, 0, 0, start,
                                                                                       stop >= 0, stop);
        return call("EnterInitializationMode");
    }
    HostStatus call(const std::string& name) { return status(fmu_.function<int(void*)>(name)(instance_)); }
    HostStatus step(double at, double length) {
        if (fmu_.version() == 2)
            return status(fmu_.function<int(void*, double, double, int)>("DoStep")(instance_, at, length, 1));
        bool event = false;
        bool early = false;
        return status(fmu_.function<int(void*, double, double, bool, bool*, bool*, bool*, double*)>("DoStep")(
            instance_, at, length, true, &event, &over_, &early, &last_time_));
    }
    /// After a step that was discarded.
    bool is_over() {
        if (fmu_.version() == 3) return over_;
        int over = 0;
        fmu_.function<int(void*, int, int*)>("GetBooleanStatus")(instance_, 3, &over);
        return over != 0;
    }
    double last_time() {
        if (fmu_.version() == 3) return last_time_;
        double time = -1;
        fmu_.function<int(void*, int, double*)>("GetRealStatus")(instance_, 2, &time);
        return time;
    }

    HostStatus set(unsigned reference, double value) {
        if (fmu_.version() == 2)
            return status(fmu_.function<int(void*, const unsigned*, std::size_t, const double*)>("SetReal")(
                instance_, &reference, 1, &value));
        return status(fmu_.function<int(void*, const unsigned*, std::size_t, const double*, std::size_t)>("SetFloat64")(
            instance_, &reference, 1, &value, 1));
    }
    HostStatus set(unsigned reference, int value) {
        if (fmu_.version() == 2)
            return status(fmu_.function<int(void*, const unsigned*, std::size_t, const int*)>("SetInteger")(
                instance_, &reference, 1, &value));
        return status(fmu_.function<int(void*, const unsigned*, std::size_t, const int*, std::size_t)>("SetInt32")(
            instance_, &reference, 1, &value, 1));
    }
    HostStatus set(unsigned reference, const std::string& text) {
        const char* value = text.c_str();
        if (fmu_.version() == 2)
            return status(fmu_.function<int(void*, const unsigned*, std::size_t, const char* const*)>("SetString")(
                instance_, &reference, 1, &value));
        return status(fmu_.function<int(void*, const unsigned*, std::size_t, const char* const*, std::size_t)>(
            "SetString")(instance_, &reference, 1, &value, 1));
    }
    HostStatus get(unsigned reference, double& value) {
        if (fmu_.version() == 2)
            return status(fmu_.function<int(void*, const unsigned*, std::size_t, double*)>("GetReal")(
                instance_, &reference, 1, &value));
        return status(fmu_.function<int(void*, const unsigned*, std::size_t, double*, std::size_t)>("GetFloat64")(
            instance_, &reference, 1, &value, 1));
    }
    double real(unsigned reference) {
        double value = 0;
        if (get(reference, value) != HostStatus::ok) throw std::runtime_error(said_);
        return value;
    }
    int integer(unsigned reference) {
        int value = -1;
        if (fmu_.version() == 2)
            fmu_.function<int(void*, const unsigned*, std::size_t, int*)>("GetInteger")(instance_, &reference, 1,
                                                                                        &value);
        else
            fmu_.function<int(void*, const unsigned*, std::size_t, int*, std::size_t)>("GetInt32")(
                instance_, &reference, 1, &value, 1);
        return value;
    }

    /// Serialized.
    std::vector<char> saved() {
        void* state = nullptr;
        std::size_t size = 0;
        if (status(fmu_.function<int(void*, void**)>(state_name("Get"))(instance_, &state)) != HostStatus::ok)
            throw std::runtime_error(said_);
        fmu_.function<int(void*, void*, std::size_t*)>("Serialized" + kind() + "Size")(instance_, state, &size);
        std::vector<char> bytes(size);
        fmu_.function<int(void*, void*, char*, std::size_t)>("Serialize" + kind())(instance_, state, bytes.data(),
                                                                                   size);
        fmu_.function<int(void*, void**)>(state_name("Free"))(instance_, &state);
        if (state != nullptr) throw std::runtime_error("a state that was freed is still there");
        return bytes;
    }
    HostStatus set_saved(const std::vector<char>& bytes) {
        void* state = nullptr;
        const std::string name = (fmu_.version() == 2 ? "DeSerialize" : "Deserialize") + kind();
        fmu_.function<int(void*, const char*, std::size_t, void**)>(name)(instance_, bytes.data(), bytes.size(),
                                                                          &state);
        const HostStatus found = status(fmu_.function<int(void*, void*)>(state_name("Set"))(instance_, state));
        fmu_.function<int(void*, void**)>(state_name("Free"))(instance_, &state);
        return found;
    }

  private:
    std::string kind() const { return fmu_.version() == 2 ? "FMUstate" : "FMUState"; }
    std::string state_name(const std::string& verb) const { return verb + kind(); }
    static HostStatus status(int value) { return static_cast<HostStatus>(value); }

    static void log_2(void* self, const char*, int, const char*, const char* format, ...) {
        std::va_list values;
        va_start(values, format);
        char text[2000];
        std::vsnprintf(text, sizeof text, format, values);
        va_end(values);
        static_cast<HostedInstance*>(self)->said_ = text;
    }
    static void log_3(void* self, int, const char*, const char* text) {
        static_cast<HostedInstance*>(self)->said_ = text;
    }

    const OpenFmu& fmu_;
    Callbacks2 callbacks_{};
    void* instance_ = nullptr;
    std::string said_;
    bool over_ = false;
    double last_time_ = -1;
};

}  // namespace floes
