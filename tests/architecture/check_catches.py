#!/usr/bin/env python3
"""Exceptions are caught in the places that ARCHITECTURE.md ("Errors") names, and in no others.

PLACES says for each kind of place which files have how many catches of it. Fails on a catch in
another file, on one more in one of these, and on a number that is too high: who takes a catch away lowers it.
With --count prints how many there are in how many files.
"""

import collections
import pathlib
import sys

from source_files import OUTSIDE, count_in_code, end, texts

PLACES = {
    "a program ends, and its exit code says how": {
        "cli/main.cpp": 4,
        "cli/command_line.cpp": 3,
    },
    "a task is run": {
        "worker/run_task.cpp": 12,
        "worker/task_io.h": 2,
    },
    "a request is handled": {
        "coordinator/request_handler.cpp": 3,
        "coordinator/request_client_files.cpp": 1,
        "coordinator/request_replies.cpp": 2,
        "coordinator/file_orders.cpp": 6,
        "coordinator/kept_files.cpp": 1,
        "coordinator/views/status_server.cpp": 1,
        "dashboard/farm_desk.cpp": 1,
        "dashboard/fetched_answers.cpp": 2,
    },
    "a loop goes on without the one that failed": {
        "coordinator/server.cpp": 7,
        "coordinator/authenticator.cpp": 1,
        "worker/client.cpp": 6,
        "cli/farm_view.cpp": 1,
        "cli/pool_command.cpp": 2,
        "cli/local_job.cpp": 3,
        "cli/run_folder.cpp": 1,
        "cli/watched_farm.cpp": 1,
        "dashboard/farm_desk.cpp": 1,
    },
    "a disk is full or gone, and the caller waits or says so": {
        "coordinator/guarded_database.cpp": 4,
        "store/artifact_store.cpp": 1,
        "store/database_file.cpp": 1,
        "store/job_database.cpp": 1,
        "worker/file_exchange.cpp": 1,
        "worker/store_probe.cpp": 2,
    },
    "damage is looked for": {
        "cli/deliver_files.cpp": 1,
        "cli/probe.cpp": 2,
        "store/database_backup.cpp": 2,
        "store/store_check.cpp": 1,
        "worker/output_upload.cpp": 1,
    },
    "another library's exception becomes one of ours": {
        "cli/coordinator_connection.cpp": 4,
        "mesh/job_file/job_section.cpp": 1,
        "proto/authorized_keys.cpp": 1,
        "proto/wire.cpp": 1,
    },
}


def count(text):
    """How many catches the text of a file has; comments and texts have none."""
    return count_in_code(r"\bcatch\s*\(", text)


def catches(root):
    """file -> how many catches, of the files that have any."""
    found = {name: count(text) for name, text in texts(root, without=OUTSIDE).items()}
    return {name: number for name, number in found.items() if number}


def check(found, places):
    """What is wrong with the files of catches(), a line each."""
    allowed = collections.Counter()
    for files in places.values():
        allowed.update(files)
    wrong = []
    for name in sorted(found.keys() | allowed.keys()):
        has, may = found.get(name, 0), allowed[name]
        if has > may:
            wrong.append(f"{name}: {has} catches, {may} are allowed; return what is expected, and let the rest through")
        elif has < may:
            wrong.append(f"{name}: {has} catches, {may} are allowed; lower the number in check_catches.py")
    return wrong


def main():
    found = catches(pathlib.Path("."))
    if "--count" in sys.argv[1:]:
        print(f"{sum(found.values())} catches in {len(found)} files")
    end(check(found, PLACES))


if __name__ == "__main__":
    main()
