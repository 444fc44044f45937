"""Bursts of a load: its autocorrelation at the time in which the structure is towed by one floe length."""
import numpy as np

# The windows of lags in which the highest autocorrelation is taken, as multiples of that time. All are equally wide: the
# highest of many values lies above their mean even where there are no bursts, and it does so in each of them alike.
WINDOWS = {"before": (0.55, 0.85), "burst": (0.85, 1.15), "after": (1.15, 1.45)}


def autocorrelation(load):
    """Autocorrelation of the load less its linear trend at lags of 0, 1, ... steps; 1 at lag 0."""
    steps = np.arange(len(load))
    rest = load - np.polyval(np.polyfit(steps, load, 1), steps)
    power = np.abs(np.fft.rfft(rest, 2 * len(rest))) ** 2
    sums = np.fft.irfft(power)[: len(rest)]
    return sums / (len(rest) - steps) / (sums[0] / len(rest))


def highest(correlation, step, period):
    """The highest autocorrelation in each window, and `burst_s`, the lag of that in the middle one. Times in s."""
    found = {}
    for name, (low, high) in WINDOWS.items():
        first, last = int(np.ceil(low * period / step)), int(high * period / step)
        lag = first + int(np.argmax(correlation[first : last + 1]))
        found[name] = correlation[lag]
        if name == "burst":
            found["burst_s"] = lag * step
    return found


def self_test():
    """Fails unless series of known autocorrelation give it back: 150 s of 0.02 s, period 8.57 s."""
    def expect(what, value, low, high):
        if not low <= value <= high:
            raise SystemExit(f"order_bursts: {what} is {value:.3f}, not between {low} and {high}")

    step, period = 0.02, 8.57
    time = np.arange(7500) * step
    # Noise from a sequence that is the same everywhere (a Weyl sequence through a hash), normal by Box and Muller.
    uniform = np.modf(np.abs(np.sin(np.arange(1, 15001) * 12.9898)) * 43758.5453)[0]
    white = np.sqrt(-2 * np.log(uniform[:7500] + 1e-12)) * np.cos(2 * np.pi * uniform[7500:])
    smooth = np.convolve(np.concatenate([white, white[:49]]), np.ones(50) / np.sqrt(50), mode="valid")  # means over 1 s

    # A wave alone correlates fully with itself a period later, although fewer steps overlap there.
    expect("a wave", highest(autocorrelation(np.cos(2 * np.pi * time / period)), step, period)["burst"], 0.98, 1.02)
    # A wave of variance 1/2 in noise of variance 1/2: autocorrelation 1/2 at the period. A trend must not add to it.
    wave = np.cos(2 * np.pi * time / period) + np.sqrt(0.5) * white + 0.05 * time
    found = highest(autocorrelation(wave), step, period)
    expect("a wave of half the variance", found["burst"], 0.45, 0.58)
    expect("its period", found["burst_s"], 0.95 * period, 1.05 * period)
    # Bursts of 1 s, one each period and 5 % more: found, and later by so much.
    bursts = (np.mod(time, 1.05 * period) < 1.0) + 0.1 * smooth
    found = highest(autocorrelation(bursts), step, period)
    expect("bursts 5 % late", found["burst"], 0.8, 1.05)
    expect("their period", found["burst_s"], 1.04 * period, 1.06 * period)
    # Bursts at 1.3 periods belong to another window.
    found = highest(autocorrelation((np.mod(time, 1.3 * period) < 1.0) + 0.1 * smooth), step, period)
    expect("bursts at 1.3 periods", found["after"], 0.8, 1.05)
    expect("their autocorrelation at one period", found["burst"], -0.3, 0.2)
    # Noise that lasts for a second has none, in no window.
    found = highest(autocorrelation(smooth), step, period)
    for name in WINDOWS:
        expect(f"noise, {name}", found[name], -0.1, 0.3)
