#pragma once
// Contents of the messages between master and workers. Tags without a function here carry nothing (dismiss, farewell,
// stop_request) or plain text (campaign, trouble).

#include <string>
#include <string_view>
#include <vector>

#include "core/bytes.hpp"
#include "run/crew.hpp"
#include "store/member_record.hpp"

namespace floes {

/// A worker introduces itself.
struct Hello {
    int cores = 1;  ///< number of members it computes at a time
    std::string host;
    std::string fingerprint;  ///< of the campaign as it read it
    int pid = 0;              ///< of its process
};

/// A finished member.
struct Answer {
    int number = 0;
    MemberRecord record;
};

Bytes encode(const Hello& hello);
Bytes encode(const std::vector<Assignment>& assignments);
Bytes encode(const std::vector<Answer>& answers);
Bytes encode_status(int exit_status);
Bytes encode_text(std::string_view text);

// Each throws RunError if the bytes are malformed.
Hello decode_hello(const Bytes& bytes);
std::vector<Assignment> decode_assignments(const Bytes& bytes);
std::vector<Answer> decode_answers(const Bytes& bytes);
int decode_status(const Bytes& bytes);
std::string decode_text(const Bytes& bytes);

}  // namespace floes
