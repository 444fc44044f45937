#include "forecast/master_clock.hpp"

#include <algorithm>

namespace floes {

Processors::Processors(int count) {
    for (int i = 0; i < count; ++i) free_at_.push(0.0);
}

double Processors::run(double ready, double work) {
    if (free_at_.empty() || work <= 0) return ready + work;
    const double end = std::max(ready, free_at_.top()) + work;
    free_at_.pop();
    free_at_.push(end);
    return end;
}

double notice_delay(const DriverCosts& costs, double silence) {
    return 0.5 * std::clamp(silence, 0.0, costs.longest_pause);
}

MasterClock::MasterClock(const DriverCosts& costs, Processors& processors, double begin)
    : costs_(costs),
      processors_(processors),
      now_(begin),
      last_sync_(begin),
      next_publish_(begin + costs.publish_interval) {}

void MasterClock::notice(double ready, bool asleep) {
    tend(ready);
    if (ready > now_) now_ = ready + (asleep ? notice_delay(costs_, ready - now_) : 0.0);
}

void MasterClock::work(double seconds) {
    now_ = processors_.run(now_, seconds);
    busy_ += seconds;
}

void MasterClock::keep(double bytes) {
    ++members_;
    bytes_ += bytes;
    synced_ = false;
    published_ = false;
}

void MasterClock::finish() {
    tend(now_);
    work(2 * costs_.sync);  // the last records and the end of the session
    publish();
}

void MasterClock::tend(double until) {
    const double sync_due = last_sync_ + costs_.sync_interval;
    if (!synced_ && sync_due <= std::max(until, now_)) {
        now_ = std::max(now_, sync_due);
        work(costs_.sync);
        last_sync_ = now_;
        synced_ = true;
    }
    if (!published_ && next_publish_ <= std::max(until, now_)) {
        now_ = std::max(now_, next_publish_);
        const double begin = now_;
        publish();
        const double took = now_ - begin;
        const double rest = costs_.publish_share > 0 ? took / costs_.publish_share : 0.0;
        next_publish_ = now_ + std::max(costs_.publish_interval, rest);
    }
}

void MasterClock::publish() {
    work(costs_.publish + costs_.publish_per_member * members_ + costs_.publish_per_byte * bytes_);
    published_ = true;
}

}  // namespace floes
