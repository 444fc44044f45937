#include "cli/write_page.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/error.hpp"

namespace floes {

void write_page(const std::filesystem::path& path, const std::string& page) {
    const std::filesystem::path aside = path.string() + ".tmp";
    const auto refuse = [&](const std::string& reason) {
        std::error_code ignored;
        std::filesystem::remove(aside, ignored);
        throw RunError(fmt::format("{} cannot be written ({}); does the folder exist, and has it free space?",
                                   path.string(), reason));
    };
    std::ofstream file(aside, std::ios::binary);
    file << page;
    file.close();
    if (!file) refuse(std::strerror(errno));
    std::error_code error;
    std::filesystem::rename(aside, path, error);
    if (error) refuse(error.message());
}

}  // namespace floes
