#pragma once
// Every kind of message between ranks. What stands in each: driver/messages.hpp.

namespace floes {

enum class Tag : int {
    // master -> worker
    campaign = 1,  ///< the resolved configuration; the first message a worker gets
    assign = 2,    ///< compute this member
    dismiss = 3,   ///< abandon what you hold and say farewell
    leave = 4,     ///< the run is over; end with this exit status
    part = 5,      ///< ranks are missing: leave, when told to, without waiting for anybody; see Link::abandon()
    // worker -> master
    hello = 11,         ///< what the worker understood of the campaign, and its cores
    answer = 12,        ///< a finished member
    farewell = 13,      ///< every answer of this worker has been sent
    stop_request = 14,  ///< the worker got a signal to stop
    trouble = 15,       ///< the worker cannot go on; a sentence
    // either way
    alive = 21,  ///< nothing but a sign of life
};

}  // namespace floes
