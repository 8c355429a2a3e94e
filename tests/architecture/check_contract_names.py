#!/usr/bin/env python3
"""Fields of contracts are named in the contracts, and nowhere else in the rules of the graph or the tasks.

Reads the names of all fields out of tasks/KIND_contract.cpp. Fails when a source of coordinator/ or worker/
has one of them as a text: it is to read or make the contract's struct, or ask field_name() for the name. A
figure for people may be called as a field of another kind is: io.number("tets", …) in a task whose contract
has no such number. FIGURES lists what is no field though it is called like one. Fails too when the table in
proto/protocol.md leaves out a field of a kind. Run in the root of the repository, or with that as argument.
"""

import re

from source_files import end, root_of_arguments, texts

ROOMS = ("coordinator/", "worker/")
PROTOCOL = "proto/protocol.md"

# Texts that are no fields: file -> texts. One that is not there any more is a complaint.
FIGURES = {
    # What people are told, under names of its own: the status, its result, metrics.
    "coordinator/decisions/job_status.cpp": {"parts", "elements"},
    "coordinator/views/farm_metrics.cpp": {"reason"},
    "coordinator/views/query_answers.cpp": {"tets"},
    # A place in the scratch folder; the job file that all jobs of one surface share.
    "coordinator/surface_roots.cpp": {"surface"},
    "worker/inspect_task.cpp": {"settings", "surface"},
    # One of several such figures; a value, or a key, of the job file.
    "worker/assemble_task.cpp": {"elements"},
    "worker/job_layers.cpp": {"tets"},
    "worker/job_pml.cpp": {"tets"},
    "worker/job_forecast.cpp": {"spacing"},
    # What a finite state of the worker is called.
    "worker/decisions/worker_phases.cpp": {"left"},
}

DESCRIBE = re.compile(r"void (\w+)(Given|Made)::describe\(ContractFields& .*?\) \{(.*?)\n?\}\n", re.DOTALL)
FIELD = re.compile(r'fields\.(file|files|count|amount|flag|text)\(\s*"(\w+:?)"|\{"(\w+:)", &')
TOLD = re.compile(r'io\.(number|text)\(\s*"(\w+)"')
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
TEXT = re.compile(r'"((?:\\.|[^"\\\n])*)"')
NUMBERS = ("count", "amount", "flag")


def fields_of(files):
    """{(kind, side): {name: how it travels}} of all contracts; a name of files of leaves ends in ':'."""
    contracts = {}
    for path, text in files.items():
        if not re.fullmatch(r"tasks/\w+_contract\.cpp", path) or path == "tasks/task_contract.cpp":
            continue
        kind = path.split("/")[1].removesuffix("_contract.cpp")
        for _, side, body in DESCRIBE.findall(text):
            contracts[kind, side] = {one or of_leaves: how or "files" for how, one, of_leaves in FIELD.findall(body)}
    return contracts


def is_for_people(path, how, name, contracts):
    """Whether a task may say so beside its contract."""
    kind = path.split("/")[-1].removesuffix("_task.cpp")
    own = contracts.get((kind, "Made"), {}).get(name)
    return own not in (NUMBERS if how == "number" else ("text",))


def named_fields(path, text, contracts, names):
    """The texts of a file that are names of fields, figures for people left out."""
    code = COMMENT.sub("", text)
    for how, name in TOLD.findall(code):
        if path.endswith("_task.cpp") and is_for_people(path, how, name, contracts):
            code = re.sub(rf'io\.{how}\(\s*"{name}"', "", code)
    # Such as "core:" before a number; "core" alone is no field.
    return {found for found in TEXT.findall(code) if found in names}


def untold_fields(contracts, protocol):
    """Complaints about fields that the row of their kind in the table of protocol.md leaves out."""
    rows = dict(re.findall(r"^\| ([A-Z]+) (\|.*)$", protocol, re.MULTILINE))
    complaints = []
    for (kind, _), fields in sorted(contracts.items()):
        told = set(re.findall(r"\w+(?::(?=HEAP))?", rows.get(kind.upper(), "")))
        complaints += [f"{PROTOCOL}: the row of {kind} leaves out {name}" for name in fields if name not in told]
    return complaints


def check(files, protocol):
    """The complaints, a line each. `files`: path in the repository -> text; `protocol`: that of PROTOCOL."""
    contracts = fields_of(files)
    names = {name for fields in contracts.values() for name in fields}
    complaints = []
    for path, text in sorted(files.items()):
        if not path.startswith(ROOMS):
            continue
        allowed = FIGURES.get(path, set())
        found = named_fields(path, text, contracts, names)
        complaints += [f"{path}: names the field \"{name}\" of a contract; see {__file__}"
                       for name in sorted(found - allowed)]
        complaints += [f"{path}: has no \"{name}\" any more; see {__file__}" for name in sorted(allowed - found)]
    complaints += [f"{path}: is no source any more; see {__file__}" for path in sorted(FIGURES) if path not in files]
    return complaints + untold_fields(contracts, protocol)


def main():
    root = root_of_arguments()
    files = texts(root)
    complaints = check(files, (root / PROTOCOL).read_text(encoding="utf-8"))
    end(complaints, f"{len(fields_of(files))} contracts, {len(complaints)} complaints about names of their fields")


if __name__ == "__main__":
    main()
