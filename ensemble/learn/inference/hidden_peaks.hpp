#pragma once
// Peaks that a higher one nearby hides.
//
// Declustered peaks are at least a time s apart, taken from the highest down. Of events that come independently at rate
// λ some are lost in this way, the more the lower they are: taking events in the order of their height and leaving out
// each that is nearer than s to one taken before is A. Rényi's parking of cars of length s (1958), where the height is
// the order in which the cars come. So where events come at rate λ, declustered peaks come at rate θ(λ s)/s with
//   θ(u) = ∫ from 0 to u of exp(-2 ∫ from 0 to t of (1 - e^-v)/v dv) dt,
// and a share θ'(λ s) of the events of that height is seen. θ tends to 0.7476.

namespace floes {

/// Events for each declustered peak at the height that `kept` declustered peaks exceed in one separation s, on average:
/// 1 / θ'(u) where θ(u) = kept. At least 1; for `kept` above θ(3) = 0.62, where hardly an event is seen, that at u = 3.
double events_per_peak(double kept);

}  // namespace floes
