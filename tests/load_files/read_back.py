#!/usr/bin/python3
"""Loads that floes export wrote, read back as their programs would and compared with the campaign file; and what it refuses.

    read_back.py FLOES SYNTHETIC_FILE
"""

import math
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy

FLOES, SYNTHETIC = sys.argv[1:3]
FAULTS = []


def check(holds, sentence):
    if not holds:
        FAULTS.append(sentence)


def export(*words, status=0):
    done = subprocess.run([FLOES, "export", *words], capture_output=True, text=True)
    check(done.returncode == status, f"export {' '.join(words)} ends with {done.returncode}: {done.stderr}")
    return done.stdout.split(), " ".join(done.stderr.split())


def refused(sentence, *words):
    said = export(*words, status=2)[1]
    check(sentence in said, f"export {' '.join(words)} says: {said}")


def table(path):
    """Rows of a CSV file behind its legend and its names, and the names."""
    lines = [line for line in pathlib.Path(path).read_text().splitlines() if not line.startswith("#")]
    return lines[0].split(","), numpy.array([[float(value) for value in line.split(",")] for line in lines[1:]])


def stored(file, member):
    """Step, and the force along X, Y and Z of a hull that is towed straight on; sums of steps from the start."""
    with h5py.File(file) as held:
        case = held["members/case"][member]
        step = held["cases/time_step"][case] * held["cases/history_stride"][case]
        surge, sway, heave = (held["history"][name][member] for name in ("surge_load", "sway_load", "heave_load"))
    there = ~numpy.isnan(surge)
    return step, numpy.array([-surge[there], -sway[there], heave[there]])


def impulse_until(step, force, time):
    sums = numpy.concatenate([numpy.zeros((3, 1)), numpy.cumsum(force, axis=1) * step], axis=1)
    places = step * numpy.arange(sums.shape[1])
    return numpy.array([numpy.interp(time, places, one) for one in sums])


def test_csv(folder, file):
    names, rows = (export(file, "--member", "3", "--for", "csv", "-o", f"{folder}/a.csv"), table(f"{folder}/a.csv"))[1]
    step, force = stored(file, 3)
    check(names == ["from_s", "to_s", "FX_N", "FY_N", "FZ_N"], f"csv names {names}")
    check(rows.shape[0] == force.shape[1] and numpy.allclose(rows[:, 2:].T, force, rtol=1e-8, atol=1e-6), "csv values")
    export(file, "--member", "3", "--for", "csv", "-o", f"{folder}/b.csv", "--step", "0.07", "--from", "0.31", "--to", "1.9")
    rows = table(f"{folder}/b.csv")[1]
    check(rows.shape[0] == 22, f"csv has {rows.shape[0]} cells of 0.07 s in 1.59 s")
    for cell in rows:
        expected = impulse_until(step, force, 0.31 + cell[1]) - impulse_until(step, force, 0.31 + cell[0])
        check(numpy.allclose(cell[2:] * 0.07, expected, rtol=1e-7, atol=1e-6), f"impulse of the cell from {cell[0]} s")


class Info:
    """What OrcaFlex gives an external function."""

    def __init__(self, name, time):
        self.DataName, self.SimulationTime, self.Value = name, time, None


def test_orcaflex(folder, file):
    export(file, "--member", "3", "--for", "orcaflex", "-o", f"{folder}/ice.py", "--step", "0.05", "--tow-towards", "180")
    module = {}
    exec(pathlib.Path(folder, "ice.py").read_text(), module)
    force = -table((export(file, "--member", "3", "--for", "csv", "-o", f"{folder}/c.csv", "--step", "0.05"),
                    f"{folder}/c.csv")[1])[1][:, 2:4] / 1000
    function = module["IceLoad"]()

    def value(name, time):
        info = Info(name, time)
        (function.Calculate if time > 0 else function.Initialise)(info)
        return info.Value

    for k in range(len(force)):
        for axis, letter in enumerate("XY"):
            found = value(f"GlobalAppliedForce{letter}[1]", 0.05 * (k + 0.5))
            check(math.isclose(found, force[k][axis], rel_tol=1e-7, abs_tol=1e-9), f"orcaflex {letter} of cell {k}")
    check(math.isclose(value("GlobalAppliedForceX[2]", -8.0), force[0][0], rel_tol=1e-7), "orcaflex while it builds up")
    check(math.isclose(value("GlobalAppliedForceX[2]", 1e4), force[-1][0], rel_tol=1e-7), "orcaflex after the end")
    middle = value("GlobalAppliedForceX[1]", 0.05)
    check(math.isclose(middle, (force[0][0] + force[1][0]) / 2, rel_tol=1e-7), "orcaflex between two values")
    check(value("GlobalAppliedMomentX[1]", 1.0) == 0.0, "orcaflex moment")
    try:
        value("LocalAppliedForceX[1]", 1.0)
        check(False, "a load in the earth's axes is given along the hull's")
    except Exception as said:
        check("IceLoad gives" in str(said), f"orcaflex says {said}")


def test_choice(folder, file):
    """Members 0, 3, 6, ... are of the first case, 4 failed and 7 is missing; their loads grow with their numbers."""
    out = f"{folder}/all.csv"
    made = export(file, "--all", "--for", "csv", "-o", out)[0]
    numbers = sorted(int(path.rpartition("_")[2].removesuffix(".csv")) for path in made)
    check(numbers == [0, 1, 2, 3, 5, 6, 8, 9, 10, 11], f"--all gives {numbers}")
    check(export(file, "--all", "--case", "stiff", "--arrangement", "0", "--for", "csv", "-o", out)[0] == [out], "one of all")
    said = export(file, "--worst", "--for", "csv", "-o", out)[1]
    check("member 11. Chosen: of the campaign it has the largest load of a step in the window" in said, f"--worst: {said}")
    said = export(file, "--quantile", "0.5", "--case", "soft", "--for", "csv", "-o", out, "--averaging-s", "0.4")[1]
    check("member 3. Chosen: of 4 members of case soft" in said and "has rank 2 from the least" in said
          and "So few members do not bound that quantile." in said, f"--quantile: {said}")
    check("Chosen: of 4 members" in pathlib.Path(out).read_text(), "the file says why its member was chosen")
    made = export(file, "--quantile", "0.5", "--for", "csv", "-o", out, "--averaging-s", "0.4")[0]
    check(len(made) == 3, f"--quantile gives one of each case: {made}")


def test_openfast(folder, file):
    """What gives the load its place stays as its reader completed it, and is of that load alone."""
    out, control = f"{folder}/ice.dat", pathlib.Path(folder, "ice_StC.dat")
    ask = [file, "--member", "1", "--for", "openfast", "-o", out]
    check(export(*ask)[0] == [out, str(control)], "two files for openfast")
    control.write_text(control.read_text().replace("0   StC_P_Z", "-5   StC_P_Z"))
    check("stays as it is" in export(*ask)[1] and "-5   StC_P_Z" in control.read_text(), "the place is lost")
    refused("is not of a load in these axes", *ask, "--axes", "hull")
    refused("and for this version", *ask[:-3], "openfast4", *ask[-2:])


def test_refusals(folder, file):
    out = ["--for", "csv", "-o", f"{folder}/r.csv"]
    refused("has no member 99: its members are 0 to 11", file, "--member", "99", *out)
    refused("Member 4 failed and has no load", file, "--member", "4", *out)
    refused("Member 7 is not in", file, "--member", "7", *out)
    refused("Which member?", file, *out)
    refused("There is no case hard", file, "--all", "--case", "hard", *out)
    refused("There is no arrangement 9", file, "--all", "--arrangement", "9", *out)
    refused("Give one of --member, --worst, --quantile and --all", file, "--all", "--worst", *out)
    refused("without them --worst takes the load of a step", file, "--worst", "--averaging-s", "2", *out)
    refused("--set and --motion are of an FMU", file, "--worst", "--set", "structure.speed_m_s=0.2", *out)
    refused("An FMU (--fmu) steps at the scale and in the axes of its configuration", "my.toml", "--fmu", f"{folder}/a.fmu",
            "--scale", "36")
    refused("leave --case and --arrangement out", file, "--member", "1", "--case", "soft", *out)
    refused("give one of them", file, "--member", "1", "--of", "load", *out)
    refused("Case open: no mean over 1 s lies in its window of 0.8 s", file, "--quantile", "0.5", *out)
    refused("stored as means over 0.02 s (a time step)", file, "--member", "1", *out, "--step", "0.01")
    refused("there is no whole step of 0.5 s of the run, which goes from 0 s to 2.2 s", file, "--member", "1", *out, "--step",
            "0.5", "--from", "2")
    refused("there is no whole step", file, "--member", "1", *out, "--to", "3")
    refused("would be a file for openfast: give a name that ends with .dat or .txt", file, "--member", "1", "--for",
            "openfast", "-o", f"{folder}/a.h5")
    refused("there is no simo; allowed are csv, openfast, openfast4, subdyn", file, "--member", "1", "--for", "simo", "-o",
            f"{folder}/a.csv")
    refused("knows loads in the earth's axes only", file, "--member", "1", "--for", "subdyn", "-o", f"{folder}/a.csv",
            "--axes", "hull")
    refused("give one", file, "--member", "1", *out, "--axes", "hull", "--tow-towards", "90")
    refused("there is no file", f"{folder}/none.h5", "--member", "1", *out)
    check(not pathlib.Path(folder, "r.csv").exists(), "what is refused leaves a file")


def main():
    with tempfile.TemporaryDirectory() as folder:
        file = f"{folder}/synthetic.h5"
        subprocess.run([SYNTHETIC, file], check=True, stdout=subprocess.DEVNULL)
        for test in (test_csv, test_orcaflex, test_choice, test_openfast, test_refusals):
            test(folder, file)
    for fault in FAULTS:
        print(fault)
    return 1 if FAULTS else 0


if __name__ == "__main__":
    sys.exit(main())
