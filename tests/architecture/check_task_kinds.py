#!/usr/bin/env python3
"""Where kinds of tasks are named: a new kind touches few places, and this counts them.

Fails when a file names every kind that is not one of EVERY_KIND, when a file names a kind that is not in
ONE_KIND, when a place of these tables is none any more, when a file has a list of kinds as texts, and
when ARCHITECTURE.md tells another number of files for a new kind. Tests and benches may name what they
want, and a kind's own contract that kind. Run in the root of the repository, or with that as argument.
"""

import re

from source_files import OUTSIDE, end, root_of_arguments, texts

# What a new kind needs besides files of its own (tasks/KIND_contract.cpp, worker/KIND_task.h and .cpp): a line
# in the list, and what may follow it.
EVERY_KIND = {
    "tasks/task_kind.h",
    "coordinator/decisions/job_decisions.cpp",
}

# What knows some kinds for what they are, each for a reason of its own.
ONE_KIND = {
    # the graph
    "coordinator/decisions/cosmetic_graph.cpp", "coordinator/decisions/loop_graph.cpp",
    "coordinator/decisions/task_graph.cpp", "coordinator/decisions/job_cosmetics.cpp",
    "coordinator/decisions/job_demand.cpp", "coordinator/decisions/job_finished.cpp",
    "coordinator/decisions/job_further_cuts.cpp", "coordinator/decisions/job_outlook.cpp",
    "coordinator/decisions/file_needs.cpp", "coordinator/decisions/job_files.cpp",
    # what people are told: cuts, leaves, the result
    "coordinator/decisions/job_status.cpp", "coordinator/decisions/job_workers.cpp",
    "coordinator/decisions/mesh_share.cpp", "coordinator/decisions/task_reuse.cpp",
    "coordinator/views/running_tasks.cpp", "coordinator/request_replies.cpp", "coordinator/space_watch.cpp",
    "json/job_share.cpp", "cli/progress_display.cpp",
    # the first and the last: what was submitted, and what it became
    "store/rows.h",
    # what their sizes are; a new kind may say that in its own file (cost_of)
    "worker/task_cost.cpp", "worker/task_cost.h",
}


def kinds_of(header):
    """The names in the list of kinds."""
    body = re.search(r"#define TETFARM_TASK_KINDS\(KIND\)((?:.*\\\n)*.*)", header).group(1)
    return re.findall(r"KIND\((\w+)\)", body)


def named_kinds(text, kinds):
    """Those that the text names as enumerators, or lists."""
    return set(re.findall(r"\b(?:TaskKind::|KIND\()(\w+)", text)) & set(kinds)


def quoted_kinds(text, kinds):
    return {kind for kind in kinds if f'"{kind}"' in text}


def check(files, architecture):
    """The complaints, a line each. `files`: path in the repository -> text."""
    kinds = kinds_of(files["tasks/task_kind.h"])
    errors = []
    every, some = set(), set()
    for path, text in sorted(files.items()):
        if path.split("/")[0] in OUTSIDE:
            continue
        named = named_kinds(text, kinds)
        own = re.fullmatch(r"tasks/(\w+)_contract\.h", path)
        if own and named == {own.group(1)}:
            continue
        if len(named) == len(kinds) and path not in ONE_KIND:
            every.add(path)
        elif named:
            some.add(path)
        if len(quoted_kinds(text, kinds)) > len(kinds) / 2:
            errors.append(f"{path}: a list of the kinds of tasks as texts; tasks/task_kind.h has them")
    errors += [f"{path}: names every kind of task; see {__file__}" for path in sorted(every - EVERY_KIND)]
    errors += [f"{path}: does not name every kind of task any more" for path in sorted(EVERY_KIND - every)]
    errors += [f"{path}: names kinds of tasks; ask their traits, or see {__file__}"
               for path in sorted(some - ONE_KIND)]
    errors += [f"{path}: names no kind of task any more" for path in sorted(ONE_KIND - some)]
    told = re.search(r"\*\*A kind of task\*\*[^\n]*?(\d+) existing files", architecture)
    if not told or int(told.group(1)) != len(EVERY_KIND):
        errors.append(f"ARCHITECTURE.md does not say that a kind of task touches {len(EVERY_KIND)} existing files")
    for path in sorted(EVERY_KIND):
        if path not in architecture:
            errors.append(f"ARCHITECTURE.md does not name {path} among what a kind of task touches")
    return errors


def main():
    root = root_of_arguments()
    files = texts(root)
    errors = check(files, (root / "ARCHITECTURE.md").read_text(encoding="utf-8"))
    end(errors, f"{len(files)} files, {len(errors)} complaints about kinds of tasks")


if __name__ == "__main__":
    main()
