"""One binary for every x86-64: instructions of AVX stand in the kernels for AVX alone, and these kernels leave nothing
that the linker could put in the place of another function of the same name.

    kernels.py BUILD_FOLDER PROGRAM
"""

import pathlib
import re
import subprocess
import sys

build, program = pathlib.Path(sys.argv[1]), sys.argv[2]
faults = []

kernels = sorted(build.glob("CMakeFiles/floes_*.dir/generated/*/kernels_avx*.cpp.o"))
if len(kernels) != 4:
    sys.exit(f"four objects with AVX were expected, and there are {[str(path) for path in kernels]}")
own = set()
for path in kernels:
    for line in subprocess.run(["nm", str(path)], capture_output=True, text=True, check=True).stdout.splitlines():
        kind, name = line.split()[-2:]
        own.add(name)
        if kind in "WVu":
            faults.append(f"{path.name} has {name}, which the linker may take for the whole program")

listing = subprocess.Popen(["objdump", "-d", "--no-show-raw-insn", program], stdout=subprocess.PIPE, text=True)
function, wide = "", set()
for line in listing.stdout:
    if line.endswith(">:\n"):
        function = line[line.index("<") + 1:-3]
    elif "%ymm" in line or "%zmm" in line:
        wide.add(function)
if listing.wait() or not wide:
    sys.exit(f"{program} could not be read, or has no kernel of AVX")
# The optimizer's own pieces of a function end in .part.0, .constprop.0 or .cold.
for name in sorted(wide):
    if re.sub(r"\.(part|constprop|isra|cold|lto_priv).*", "", name) not in {re.sub(r"\..*", "", each) for each in own}:
        faults.append(f"{name} has instructions of AVX, and is no kernel")

print("\n".join(faults) or f"{len(wide)} functions with AVX, all of them kernels")
sys.exit(bool(faults))
