#pragma once
// Peaks that a higher one nearby hides.
//
// Declustered peaks are at least a time s apart and taken from the highest down. So some independent events are lost,
// the lower they are the more. To take events in the order of height, and to leave out each that is closer than s to
// one taken before, is A. Rényi's parking problem (1958): cars of length s arrive in the order of height. Events at
// rate λ therefore give declustered peaks at rate θ(λ s)/s with
//   θ(u) = ∫ from 0 to u of exp(-2 ∫ from 0 to t of (1 - e^-v)/v dv) dt,
// and a share θ'(λ s) of the events of that height is seen. θ tends to 0.7476.

namespace floes {

/// Events for each declustered peak at the height that `kept` declustered peaks exceed in one separation s, on average:
/// 1 / θ'(u) where θ(u) = kept. At least 1; for `kept` above θ(3) = 0.62, where hardly an event is seen, that at u = 3.
double events_per_peak(double kept);

}  // namespace floes
