#!/usr/bin/python3
"""Every campaign that the pages quote, computed anew, and what is made of them.

    anew.py FLOES FOLDER             runs what FOLDER lacks, in the order below; stop it at will, and call it again
    anew.py FLOES FOLDER --hours 3   ends by then; a campaign that is under way goes on at the next call
    anew.py FLOES FOLDER --only A B  these alone, in this order; with --plan, too
    anew.py FLOES FOLDER --plan      only says what is left, and how long it takes on this machine's cores
    anew.py FLOES FOLDER --pages     of what is complete: its line of docs/campaigns.csv, data, tables and pictures of the
                                     pages, and for sentences that are written by hand FOLDER/NAME.txt, the whole summary
    anew.py --check                  fails if a configuration of configs/ is in no campaign below

FLOES: the program. Steps of --pages need packages-test-all.txt.
"""
import argparse
import csv
import os
import pathlib
import subprocess
import sys
import time

from told import told

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONFIGS = ROOT / "configs"
FIGURES = ROOT / "docs" / "figures"
COMPUTED = ROOT / "docs" / "campaigns.csv"

# Name of the file, configuration, and words that the page adds to `floes run`. Short campaigns come first, the long ones of
# jams last.
CAMPAIGNS = {name: (CONFIGS / f"{where}.toml", " ".join(words).split()) for name, where, *words in [
    ("smoke", "smoke"),
    ("level_ice", "level_ice"),
    ("level_support", "validation/level_support"),
    ("level_support_fast", "validation/level_support_fast"),
    ("moored_free", "moored_free"),
    ("turning_drift", "turning_drift"),
    ("design_sobol", "design_sobol"),
    ("barge", "barge"),
    ("wide_floe", "validation/wide_floe"),
    ("hull_pieces", "validation/hull_pieces"),
    ("water_channel", "validation/water_channel"),
    ("joints_channel", "validation/joints_channel"),
    ("joint_damping", "validation/joint_damping"),
    ("fracture_energy", "validation/fracture_energy"),
    ("replicates", "validation/replicates"),
    ("shelter", "validation/shelter"),
    ("sea_ice", "validation/sea_ice"),
    ("sea_ice_draws", "validation/sea_ice_draws"),
    ("sea_ice_chaos", "validation/sea_ice_chaos"),
    ("floating", "floating"),
    ("floating_ship", "validation/floating_ship"),
    ("floating_water", "validation/floating_water"),
    ("speed_cone", "validation/speed_cone"),
    ("grain_cone", "validation/grain_cone"),
    ("boundaries", "validation/boundaries"),
    ("contact_choices", "validation/contact_choices"),
    ("vary_channel", "validation/vary_channel"),
    ("compressed_field", "validation/compressed_field"),
    ("arch_gap", "validation/arch_gap"),
    ("friction_cone", "validation/friction_cone"),
    ("steps_speed", "validation/steps_speed"),
    ("resolution", "validation/resolution"),
    ("window", "validation/endless_window"),
    ("endless", "endless", "--set campaign.arrangements=20"),
    ("channel", "matching/channel"),
    ("moored", "moored"),
    ("platform", "moored_platform"),
    ("kulluk", "kulluk"),
    ("full_scale", "full_scale"),
    ("tank_walls", "validation/tank_walls"),
    ("fit_paper", "validation/fit_paper"),
    ("table3", "table3"),
    ("crystalline", "validation/crystalline"),
    ("tank", "table3_physical", "--set campaign.arrangements=1"),
    ("physical", "matching/physical"),
    ("order", "validation/order"),
    ("wall_far_end", "validation/wall_far_end"),
    ("sea_ice_wide", "validation/sea_ice_wide"),
    ("grain_full_scale", "validation/grain_full_scale"),
    ("level_cone", "level_cone"),
    ("level_ship", "level_ship"),
    ("widths", "validation/widths"),
    ("readings", "validation/readings"),
    ("shapes_endless", "validation/shapes_endless"),
    ("speed_wall", "validation/speed_wall"),
    ("grain_wall_unsolved", "validation/grain_wall_unsolved"),
    ("grain_wall", "validation/grain_wall"),
    ("gap", "validation/gap"),
    ("jam", "validation/jam"),
    ("level_case1_factors", "validation/level_case1_factors"),
    ("level_case1_wide", "validation/level_case1_wide"),
    ("level_case1", "validation/level_case1"),
]}

# What is made of them: the campaigns that a step needs whole, and its words behind docs/figures.
STEPS = [
    (["smoke"], "python_page.py {folder}/smoke.h5 --update"),
    (["sea_ice"], "sea_ice.py {folder}/sea_ice.h5"),
    (["sea_ice"], "polygons.py {floes} {folder}/sea_ice.h5"),
    (["joints_channel"], "ice.py --collect {folder}"),
    (["contact_choices", "resolution", "friction_cone", "jam"], "contact.py --collect {folder}"),
    (["water_channel", "boundaries"], "water.py --collect {folder}"),
    (["arch_gap", "compressed_field"], "trends.py --collect {folder} {floes}"),
    (["endless", "window"], "endless.py {folder}/endless.h5 {folder}/window.h5"),
    (["endless"], "design_load.py --collect {folder}/endless.h5 {floes}"),
    (["kulluk"], "kulluk.py {folder}/kulluk.h5"),
    (["table3", "fit_paper", "crystalline", "tank_walls", "vary_channel"], "validation.py --collect {folder} {floes}"),
    (["channel", "physical"], "matching.py --collect {folder} {floes}"),
    (["tank"], "replay.py {floes} {folder}/tank.h5"),
    (["level_case1", "level_case1_factors", "level_case1_wide"], "level_case1.py --collect {folder}"),
    (["order", "wall_far_end"], "order.py --collect {folder} --program {floes}"),
    ([], "froude.py --run {floes} {folder}"),
    ([], "gallery.py {floes} {folder}"),
    ([], "hulls.py {floes}"),
]
# Configurations that are no campaigns.
OTHERS = [CONFIGS / f"targets_{name}.toml" for name in ("channel", "channel_ten", "table3", "tank")]


def members_left(floes, folder, name):
    """Members that are not done, and the seconds that they take on two cores by `floes plan`."""
    config, words = CAMPAIGNS[name]
    plan = told(floes, "plan", config, "--cores", "2", *words)
    members, file = plan["members"], folder / f"{name}.h5"
    if file.exists():
        status = told(floes, "status", file)
        members = status["total"] - status["done"] - status["failed"]
    return members, members * plan["mean_run_time_s"] / 2


def run(floes, folder, hours, names):
    """Whether all of them are complete."""
    end = time.monotonic() + 3600 * hours
    for name in names:
        config, words = CAMPAIGNS[name]
        members, seconds = members_left(floes, folder, name)
        if members == 0:
            continue
        left = end - time.monotonic()
        if left < 30:
            return False
        print(f"{name}: {members} members, some {seconds / 60:.0f} minutes on two cores", flush=True)
        command = [floes, "run", config, "-o", folder / f"{name}.h5", "--resume", *words]
        limit = [] if hours == float("inf") else ["--time-left", f"{left:.0f}"]
        with open(folder / f"{name}.log", "a") as log:
            if subprocess.run([*command, *limit], stdout=log, stderr=log).returncode not in (0, 85):
                print(f"{name} did not end well: see {folder / name}.log", file=sys.stderr)
    return all(members_left(floes, folder, name)[0] == 0 for name in names)


def tell_plan(floes, folder, names):
    rows = [(name, *members_left(floes, folder, name)) for name in names]
    for name, members, seconds in rows:
        if members:
            print(f"{name:22}{members:6} members {seconds / 60:7.1f} min")
    print(f"{'together':22}{sum(row[1] for row in rows):6} members {sum(row[2] for row in rows) / 3600:7.1f} h on two cores")


def computed(file, name):
    """What stands of a campaign in docs/campaigns.csv."""
    import h5py  # which --check does not need

    with h5py.File(file) as campaign:
        by = campaign["provenance"].attrs
        seconds = campaign["provenance/cpu_time"][:]
        return {"campaign": name, "members": len(seconds), "date": by["date"][:10], "floes": by["floes"],
                "git_revision": by["git_revision"][:8], "core_minutes": f"{sum(seconds) / 60:.1f}"}


def write_computed(folder, names):
    with open(COMPUTED, newline="") as file:
        rows = {row["campaign"]: row for row in csv.DictReader(file)}
    rows |= {name: computed(folder / f"{name}.h5", name) for name in names}
    with open(COMPUTED, "w", newline="") as file:
        out = csv.DictWriter(file, ["campaign", "members", "date", "floes", "git_revision", "core_minutes"], lineterminator="\n")
        out.writeheader()
        out.writerows(rows[name] for name in CAMPAIGNS if name in rows)


def make_pages(floes, folder):
    whole = {name for name in CAMPAIGNS if (folder / f"{name}.h5").exists() and members_left(floes, folder, name)[0] == 0}
    waiting = {name for needed, _ in STEPS if not whole.issuperset(needed) for name in needed}  # their page is not made
    write_computed(folder, whole - waiting)
    for name in sorted(whole):
        with open(folder / f"{name}.txt", "w") as told:
            subprocess.run([floes, "summarize", folder / f"{name}.h5", "--full"], stdout=told, stderr=told)
    for needed, words in STEPS:
        if missing := [name for name in needed if name not in whole]:
            print(f"not yet, without {', '.join(missing)}: {words.split()[0]}")
            continue
        print(words.split()[0], flush=True)
        subprocess.run([FIGURES / words.split()[0], *(word.format(floes=floes, folder=folder) for word in words.split()[1:])],
                       check=True, cwd=ROOT)


def check():
    named = {config for config, _ in CAMPAIGNS.values()} | set(OTHERS)
    there = {path for pattern in ("*.toml", "validation/*.toml", "matching/*.toml") for path in CONFIGS.glob(pattern)}
    if named != there:
        sys.exit(f"docs/figures/anew.py names {sorted(map(str, named - there))} that are not there, and lacks "
                 f"{sorted(map(str, there - named))}")
    if unknown := {name for needed, _ in STEPS for name in needed} - set(CAMPAIGNS):
        sys.exit(f"docs/figures/anew.py has steps that need {sorted(unknown)}, which are no campaigns")
    if lacking := [words for _, words in STEPS if not os.access(FIGURES / words.split()[0], os.X_OK)]:
        sys.exit(f"docs/figures/anew.py has steps that are not there, or that cannot be run: {lacking}")


def main():
    if sys.argv[1:] == ["--check"]:
        return check()
    parser = argparse.ArgumentParser(description="Every campaign of the pages anew, and what is made of them.")
    parser.add_argument("floes", type=lambda text: str(pathlib.Path(text).resolve()))
    parser.add_argument("folder", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--hours", type=float, default=float("inf"))
    parser.add_argument("--only", nargs="+", choices=CAMPAIGNS, metavar="NAME", default=list(CAMPAIGNS))
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--plan", action="store_true")
    what.add_argument("--pages", action="store_true")
    given = parser.parse_args()
    given.folder.mkdir(exist_ok=True)
    if given.plan:
        tell_plan(given.floes, given.folder, given.only)
    elif given.pages:
        make_pages(given.floes, given.folder)
    elif not run(given.floes, given.folder, given.hours, given.only):
        print("not all are complete; call it again")


if __name__ == "__main__":
    main()
