#!/usr/bin/python3
"""What a run spends its processor time on: samples by name of function, as a table.

    bench/profile.py [--docs docs/performance.md] -- build/release/floes run my.toml -o my.h5 --threads 1
    bench/profile.py -- build/release/bench/floes_bench --benchmark_filter='^Member/direct_physical'

Needs `perf`. Samples are of the processor's clock, so other load on the machine does not count.
"""

import argparse
import re
import subprocess
import sys
import tempfile

import all as paired

# The first part that a function or its library fits.
PARTS = [
    ("solving rows", r"solve_all_direct|for_each_direct_row|add_velocity_changes|start_direct_contacts|pass_to_piece|"
                     r"apply_compliance|velocity_changes|::sweep|solve_all_normals|solve_frictions|solve_all_cones|"
                     r"solve_cones|solve_normals|start_contacts|to_contacts|from_contacts|piece_motion"),
    ("Bullet's collision detection, and the structure's shape", r"libBullet|libLinearMath|\bbt[A-Z]|dBoxBox2|Frustum|"
                                                                r"ConvexSolid|SolidShape|cullPoints2"),
    ("our collision detection", r"NearPairs|IceContacts|ContactStore|TouchingPoints|TouchingPoint|least_overlap|find_overlap|face_gap|"
                                r"touch_by_|clip_to_rectangle|spread_evenly|HullContacts|bounds_of|look_closer|"
                                r"needsCollision|collect_manifolds|PieceDispatcher|every_face|every_pair_of_edges|"
                                r"LaneEngine::read|LaneEngine::write_contacts|box_face_gap|find_box_overlap|reach_along|gap_along|look_at_edges|fill_points|fill_friction_start|solvable|"
                                r"seen_from_a|LaneEngine::find_contacts|pair<unsigned"),
    ("bodies to and fro", r"write_bodies|read_forces|World::state|World::apply|FroudeUnits::to_si\(floes::Body|"
                          r"FroudeUnits::to_own|read_states|add_force|put_fields|WaterLanes::set|WaterLanes::wrench|"
                          r"advance_bodies|prepare_bodies|turn_frames|LaneSystem::state|LaneEngine::state|LaneEngine::apply|"
                          r"nearest_rotation|Eigen::"),
    ("water", r"gauss|[Ww]ater|drag|buoyan|box_of|submerged|exposed"),
    ("preparing rows, joints, reactions, breakage", r"prepare|press|joint|reaction|Reaction|compliant_body|direct_arm|store_arm|"
                                     r"ContactOrder|finish|touching|make_row|raised|failure|break_joints|limits|"
                                     r"set_friction|begin_local|to_pieces|from_pieces|DirectFloes|DirectContacts|"
                                     r"ContactRows|tangents|cover"),
]
MARKS = ("<!-- profile -->", "<!-- end profile -->")


def samples(command):
    """Share of each function, %, as (library and function, share)."""
    with tempfile.NamedTemporaryFile() as data:
        subprocess.run(["perf", "record", "-e", "cpu-clock", "-o", data.name, *command], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        report = subprocess.run(["perf", "report", "-i", data.name, "--stdio", "--no-children", "-F",
                                 "overhead,dso,symbol", "-t", "|"], check=True, capture_output=True, text=True).stdout
    for line in report.splitlines():
        found = re.match(r"\s*([0-9.]+)%?\s*\|(.*)", line)
        if found:
            yield found.group(2), float(found.group(1))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--docs")
    options.add_argument("command", nargs="+")
    options = options.parse_args()
    shares = dict.fromkeys([name for name, _ in PARTS] + ["the rest"], 0.0)
    for function, share in samples(options.command):
        shares[next((name for name, words in PARTS if re.search(words, function)), "the rest")] += share
    if not any(shares.values()):
        sys.exit("perf recorded nothing.")
    text = "\n| share of samples | % |\n|---|---|\n"
    text += "".join(f"| {name} | {share:.0f} |\n" for name, share in shares.items()) + "\n"
    print(text, end="")
    if options.docs:
        paired.put_between_marks(options.docs, text, MARKS)


if __name__ == "__main__":
    main()
