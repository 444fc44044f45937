#!/usr/bin/python3
"""Runs floes_dispatch over many settings: what the driver costs, and how well `floes plan` foretells real runs.

    bench/dispatch.py build/release/bench/floes_dispatch OUTPUT.json [--rounds 3] [--folder FOLDER]

Members sleep, so a machine of two cores can host many ranks. Prints the costs for ensemble/run/plan.cpp
(processor times, the least of all rounds) and a table of real and foretold wall time (the least of all rounds). The
journal is written in FOLDER: its disk is the one that is measured.
"""

import argparse
import json
import os
import statistics
import subprocess
import tempfile
import time

SMALL = 111  # steps: a record of 3 kB
LARGE = 11502  # steps: a record of 276 kB, as of configs/table3.toml
# ranks, writers, members, milliseconds, steps
SETTINGS = [
    (1, 1, 20000, 0, SMALL), (2, 1, 20000, 0, SMALL), (8, 1, 20000, 0, SMALL), (32, 1, 20000, 0, SMALL),
    (1, 1, 2000, 1, SMALL), (2, 1, 4000, 1, SMALL), (8, 1, 10000, 1, SMALL), (32, 1, 20000, 1, SMALL),
    (1, 1, 300, 10, SMALL), (2, 1, 600, 10, SMALL), (8, 1, 2400, 10, SMALL), (32, 1, 9600, 10, SMALL),
    (1, 1, 30, 100, SMALL), (2, 1, 60, 100, SMALL), (8, 1, 240, 100, SMALL), (32, 1, 960, 100, SMALL),
    (1, 1, 400, 0, LARGE), (2, 1, 400, 0, LARGE), (8, 1, 400, 100, LARGE),
    (8, 8, 20000, 0, SMALL), (32, 4, 9600, 10, SMALL), (64, 4, 3840, 100, SMALL), (64, 16, 3840, 100, SMALL),
    (64, 4, 1280, 300, LARGE),
    (4, 4, 20000, 0, SMALL), (16, 16, 20000, 0, SMALL), (4, 4, 800, 0, LARGE), (8, 8, 800, 0, LARGE), (16, 16, 800, 0, LARGE),
]


def run(program, setting, folder):
    ranks, writers, members, milliseconds, steps = setting
    command = [program, str(members), str(milliseconds), str(steps), "1", str(writers), folder]
    if ranks > 1:
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-n", str(ranks)] + command
    begin = time.monotonic()
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    whole = time.monotonic() - begin
    lines = sorted((json.loads(line) for line in text.splitlines()), key=lambda line: line["rank"])
    result = lines[0]
    result["whole_s"] = whole
    result["steps"] = steps
    result["load_average"] = os.getloadavg()[0]
    for name in ("message_thread_processor_s", "crew_processor_s"):
        result["workers_" + name] = sum(line[name] for line in lines[1:])
    return result


def sync_time(folder):
    """Median time of fdatasync after 1 MB, s."""
    times = []
    with open(os.path.join(folder, "sync"), "ab") as file:
        for _ in range(15):
            file.write(os.urandom(1_000_000))
            file.flush()
            begin = time.monotonic()
            os.fdatasync(file.fileno())
            times.append(time.monotonic() - begin)
    return statistics.median(times)


def costs(results, sync):
    """Of DriverCosts, from the least of every time."""
    def least(ranks, steps, value, writers=1):
        return min(value(one) for one in results if one["ranks"] == ranks and one["steps"] == steps
                   and one["writers"] == writers and not one["member_s"])

    def of_workers(ranks, steps, which):
        """For each member that they computed."""
        return least(ranks, steps,
                     lambda one: one[f"workers_{which}_processor_s"] / (one["members"] - one["own_members"]))

    def publishing(one):
        same = [other for other in results if (other["members"], other["steps"]) == (one["members"], one["steps"])]
        return min(other["publish_processor_s"] for other in same)

    def thread(one):
        if one["writers"] > 1:  # all of which publish, beside their message threads
            return one["message_thread_processor_s"] - one["file_processor_s"]["orders"] - one["file_processor_s"]["index"]
        return one["message_thread_processor_s"] - publishing(one)

    def of_hands(writers, part):
        return least(writers, SMALL, lambda one: one["file_processor_s"][part], writers=writers)

    def digests_a_piece():
        # Each writer opens all pieces: so many squared times; the values are digested once.
        return (of_hands(16, "digests") - of_hands(4, "digests")) / (16 * 16 - 4 * 4)

    large = next(one["record_bytes"] for one in results if one["steps"] == LARGE)
    own = least(1, SMALL, lambda one: thread(one) / one["members"])
    other = least(8, SMALL, lambda one: (thread(one) - own * one["own_members"]) / (one["members"] - one["own_members"]))
    kept = least(8, SMALL, lambda one: (thread(one) - own * one["own_members"]) / one["in_parts"], writers=8)
    read_small = least(1, SMALL, lambda one: one["read_processor_s"] / one["members"])
    read_large = least(1, LARGE, lambda one: one["read_processor_s"] / one["members"])
    keep = (least(1, LARGE, lambda one: thread(one) / one["members"]) - own) / large
    receive = (least(2, LARGE, lambda one: (thread(one) - (own + keep * large) * one["own_members"])
                     / (one["members"] - one["own_members"])) - other) / large - keep
    small = next(one["record_bytes"] for one in results if one["steps"] == SMALL)
    publish_small = least(1, SMALL, lambda one: publishing(one) / one["members"])
    read_byte = (read_large - read_small) / (large - small)
    publish_byte = least(1, LARGE, lambda one: publishing(one) / one["members"] - publish_small) / (large - small)
    report = of_workers(8, SMALL, "message_thread")
    report_large = of_workers(2, LARGE, "message_thread")

    file = (of_hands(16, "pieces") - of_hands(4, "pieces")) / 12  # of the same members
    index = (of_hands(16, "index") - of_hands(4, "index")) / 12

    def launch(ranks):
        return min(one["whole_s"] - one["inside_s"] for one in results if one["ranks"] == ranks)

    member = of_workers(8, SMALL, "crew")  # its history is too short to be packed

    def message(which):
        return min(one["message_s"][which] for one in results if one["ranks"] > 1)

    return {
        "start_up": launch(1), "start_up_per_rank": (launch(32) - launch(2)) / 30,
        "send": message("send"), "assign": other / 4, "receive": message("receive"), "answer": other * 3 / 4,
        "own_member": own, "kept": kept - other / 4,
        "receive_per_byte": max(receive, 0), "keep_per_byte": keep, "sync": sync, "publish_per_member": publish_small - small * publish_byte,
        "publish_per_byte": publish_byte, "read_per_member": read_small - small * read_byte, "read_per_byte": read_byte,
        "order_per_member": of_hands(4, "orders") / 20000,
        "publish": file, "index": of_hands(4, "index") - file - 4 * index, "index_per_piece": index,
        "digest_per_piece": digests_a_piece(),
        "digest_per_member": (of_hands(4, "digests") - 4 * 4 * digests_a_piece()) / 20000,
        "digest_texts": (of_hands(4, "digest_of_texts") - 4 * digests_a_piece()) / 20000,
        "member": member, "member_per_byte": (of_workers(2, LARGE, "crew") - member) / large,
        "report": report, "report_per_byte": max(report_large - report, 0) / large,
    }


def table(results):
    print("| ranks | writers | member, ms | record, kB | members | real, s | plan, s | plan / real | real, members/s |")
    print("|---|---|---|---|---|---|---|---|---|")
    for setting in SETTINGS:
        ranks, writers, members, milliseconds, steps = setting
        same = [one for one in results if (one["ranks"], one["writers"], one["members"], round(1e3 * one["member_s"]),
                                           one["steps"]) == setting]
        real = min(one["wall_s"] for one in same)
        plan = same[0]["predicted_wall_s"]
        rate = max(one["members_per_s"] for one in same)
        print(f"| {ranks} | {writers} | {milliseconds} | {same[0]['record_bytes'] / 1e3:.0f} | {members} | {real:.2f} | {plan:.2f} "
              f"| {plan / real:.2f} | {rate:.0f} |")


def table_of_files(results):
    """Of campaign files by many hands."""
    print("| writers | record, kB | members | processor time, s | plan, s | plan / real |")
    print("|---|---|---|---|---|---|")
    for ranks, writers, members, milliseconds, steps in SETTINGS:
        if writers == 1 or milliseconds:
            continue
        same = [one for one in results if (one["ranks"], one["writers"], one["members"], one["steps"])
                == (ranks, writers, members, steps) and not one["member_s"]]
        real = min(sum(one["file_processor_s"][part] for part in ("orders", "pieces", "index", "digests")) for one in same)
        plan = same[0]["predicted_file_processor_s"]
        print(f"| {writers} | {same[0]['record_bytes'] / 1e3:.0f} | {members} | {real:.2f} | {plan:.2f} | {plan / real:.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("output")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--folder", help="on the disk to be measured; this folder's when not given", default=".")
    options = parser.parse_args()
    results = []
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        for _ in range(options.rounds):
            results += [run(options.program, setting, folder) for setting in SETTINGS]
        sync = sync_time(folder)
    with open(options.output, "w", encoding="utf-8") as file:
        json.dump({"sync_s": sync, "runs": results}, file, indent=1)
    for name, value in costs(results, sync).items():
        print(f".{name} = {value:.2g},")
    print()
    table(results)
    print()
    table_of_files(results)


if __name__ == "__main__":
    main()
