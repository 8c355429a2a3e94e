"""The table of recovery_peers.py --real: the closed surfaces of TETFARM_DATA, a whole run of ours beside tetgen's.

Ours: `tetfarm run -j 1`, from the file to the mesh on disk, user and system time of it and its children. Theirs:
`tetgen -pYq1.4NEFV`, which keeps the boundary as it is and writes nothing. Medians of the rounds, in which the two
take turns. Surfaces that ours refuses or that take longer than the limit are rows that say so.
"""

import csv
import gzip
import os
import pathlib
import re
import resource
import shutil
import signal
import statistics
import struct
import subprocess
import tempfile
import time


def cpu_seconds(command, folder, timeout_s):
    """Exit code (None: out of time), CPU seconds with children, what was printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          start_new_session=True) as process:
        try:
            out = process.communicate(timeout=timeout_s)[0]
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return None, timeout_s, ""
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return process.returncode, spent, out


def surfaces(data, models):
    """(model, file) of the closed surfaces that the manifest calls valid."""
    with open(pathlib.Path(data) / "MANIFEST.csv", encoding="utf-8") as manifest:
        for row in csv.DictReader(manifest):
            is_valid = row["closed"] == row["oriented"] == "yes" and row["self_intersections"] == "0"
            if not is_valid or (models and row["model"] not in models):
                continue
            folder = pathlib.Path(data) / row["model"]
            names = [n for n in row["files"].split() if re.search(r"\.(stl|off)(\.gz)?$", n) and "*" not in n]
            # Files without a packing first: tetgen reads no other.
            found = sorted((folder / n for n in names if (folder / n).exists()), key=lambda f: f.suffix == ".gz")
            if found:
                yield row["model"], found[0]


def unpacked(file, folder):
    if file.suffix != ".gz":
        return shutil.copy(file, folder)
    target = pathlib.Path(folder) / file.stem
    with gzip.open(file) as source, open(target, "wb") as out:
        shutil.copyfileobj(source, out)
    return target


def corners_of_stl(path):
    data = pathlib.Path(path).read_bytes()
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        for i in range(count):
            x = struct.unpack_from("<12f", data, 84 + 50 * i)
            yield from (x[3:6], x[6:9], x[9:12])
        return
    for line in data.decode("latin1").splitlines():
        words = line.split()
        if words and words[0].lower() == "vertex":
            yield tuple(map(float, words[1:4]))


def as_off(path):
    """tetgen does not read binary STL; OFF holds each node once."""
    path = pathlib.Path(path)
    if path.suffix == ".off":
        return path.name
    corners = list(corners_of_stl(path))
    number = {}
    for corner in corners:
        number.setdefault(corner, len(number))
    lines = [f"OFF\n{len(number)} {len(corners) // 3} 0"]
    lines += [" ".join(map(repr, node)) for node in number]
    lines += ["3 " + " ".join(str(number[c]) for c in corners[i:i + 3]) for i in range(0, len(corners), 3)]
    target = path.with_suffix(".off")
    target.write_text("\n".join(lines) + "\n", encoding="ascii")
    return target.name


def smallest_angle(text):
    found = re.search(r"Smallest dihedral:\s*([\d.e+-]+)", text)
    return float(found.group(1)) if found else None


def our_angle(program, folder):
    done = subprocess.run([program, "quality", "--json", "out"], cwd=folder, capture_output=True, text=True,
                          check=False)
    found = re.search(r'"min_dihedral[a-z_]*":\s*([\d.e+-]+)', done.stdout)
    return float(found.group(1)) if found else None


def shown(code, seconds):
    if code is None:
        return f"> {seconds:g}"
    return f"{seconds:.2f}" if code == 0 else f"exit {code}"


def row_of(options, model, file):
    with tempfile.TemporaryDirectory(prefix="real_recovery.") as folder:
        surface = pathlib.Path(unpacked(file, folder)).name
        their_surface = as_off(pathlib.Path(folder) / surface)
        ours, theirs, our_code, their_code, angles = [], [], 0, 0, [None, None]
        for _ in range(options.rounds):
            shutil.rmtree(pathlib.Path(folder) / "out", ignore_errors=True)
            command = [options.tetfarm, "run", surface, "-j", "1", "-o", "out", "--progress", "none", "--subdomains",
                       str(options.subdomains), *options.extra.split()]
            our_code, spent, _ = cpu_seconds(command, folder, options.timeout)
            ours.append(spent)
            their_code, spent, said = cpu_seconds([options.tetgen, "-pYq1.4NEFV", their_surface], folder, options.timeout)
            theirs.append(spent)
            angles = [our_angle(options.tetfarm, folder), smallest_angle(said)]
            if our_code is None:
                break
        a, b = statistics.median(ours), statistics.median(theirs)
        bar = max(3 * b, 1)
        is_met = our_code == 0 and (a <= bar or their_code != 0)
        print(f"| {model} | {shown(our_code, a)} | {shown(their_code, b)} | {a / b:.1f} | "
              + " | ".join("" if x is None else f"{x:.3g}" for x in angles)
              + f" | {'yes' if is_met else 'no'} |", flush=True)
        return is_met


def compare_real(options):
    print(f"{time.strftime('%Y-%m-%d')}, {options.subdomains} sub-domain(s) {options.extra}, medians of "
          f"{options.rounds}, CPU s of whole processes\n")
    print("| surface | ours | tetgen -pYq1.4 | ours / theirs | our smallest angle | theirs | within 3 times or 1 s |\n"
          "|---|--:|--:|--:|--:|--:|---|")
    met = [row_of(options, model, file) for model, file in surfaces(options.data, options.models)]
    print(f"\n{sum(met)} of {len(met)} within 3 times tetgen's time, or 1 s.")
    return 0 if all(met) else 1
