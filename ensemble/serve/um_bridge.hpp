#pragma once
// The protocol of UM-Bridge 1.0 (L. Seelinger et al., Journal of Open Source Software 8 (2023) 4748): requests as text
// to questions, answers to text. No sockets, no clock.
//
//     GET /Info, POST /ModelInfo, /InputSizes, /OutputSizes, /Evaluate; an error is
//     {"error": {"type": "InvalidInput", "message": "a sentence"}} with the status 400, of the model's side 500.
//
// One model, "forward": one list of all inputs to one list of all outputs, and with {"standard_errors": true} in the
// request's config a second list with the standard error of each. Beside the protocol, GET / says what the inputs and
// outputs are.

#include <string>
#include <string_view>
#include <variant>

#include "serve/served_model.hpp"

namespace floes {

struct HttpReply {
    int status = 200;
    std::string body;  ///< JSON
};

/// `answer` to the question, as text.
HttpReply reply(const ModelQuestion& question, const ModelAnswer& answer);
HttpReply reply(const ModelError& error);

class UmBridge {
  public:
    static constexpr const char* model_name = "forward";

    explicit UmBridge(ServedModel model) : model_(std::move(model)) {}

    /// The reply to a request, or the question that has to be answered first. What is wrong with a request is a reply.
    std::variant<HttpReply, ModelQuestion> take(std::string_view method, std::string_view path,
                                                std::string_view body) const;

  private:
    ServedModel model_;
};

}  // namespace floes
