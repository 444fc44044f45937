#include "wire/local_link.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {

LocalLink::LocalLink() : topology_(make_topology(std::array<CoreMask, 1>{affinity_of_this_process()}, 0)) {}

void LocalLink::send(int to, Tag tag, std::vector<std::byte> bytes) {
    if (to != 0) throw RunError(fmt::format("There is no rank {}: this process is alone.", to));
    waiting_.push_back({0, tag, std::move(bytes)});
}

std::optional<Message> LocalLink::poll() {
    if (waiting_.empty()) return std::nullopt;
    Message message = std::move(waiting_.front());
    waiting_.pop_front();
    return message;
}

}  // namespace floes
