#!/usr/bin/env python3
"""What cpack makes can be installed, works where it was installed, and can be removed again.

  check_packages.py SOURCE BUILD

The packages of Debian are made from a build folder whose program is there, and installed with dpkg in a folder of their
own, in place of the root of a system; so this takes no network, and no other system. The tarball is unpacked. Ends with 77
where a program is missing or nobody may install, unless CI is set, and with 1 when something is not as it should be.
"""

import contextlib
import gzip
import json
import os
import pathlib
import re
import shutil
import socket
import stat
import subprocess
import sys
import tempfile

SKIPPED = 77
NEEDED = ("cpack", "dpkg", "dpkg-deb", "dpkg-shlibdeps", "systemd-analyze", "systemd-sysusers", "systemd-tmpfiles", "strip")
# Whose scripts are run here and look for the root in $DPKG_ROOT; nothing that packages depend on is there.
DPKG_OPTIONS = ("--force-script-chrootless", "--force-depends", "--force-confold",
                "--force-unsafe-io")
WRITTEN_BY_SYSUSERS = {"etc/passwd", "etc/group", "etc/shadow", "etc/gshadow", "etc/.pwd.lock"}
RUN = """
import sys, tetfarm
result = tetfarm.run(sys.argv[1], "out", workers=2)
print(result.elements > 1000, tetfarm.__file__)
"""


class Wrong(Exception):
    """Something is not as it should be."""


def require(condition, what):
    if not condition:
        raise Wrong(what)


def run(words, **options):
    done = subprocess.run([str(word) for word in words], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False, **options)
    require(done.returncode == 0, f"{' '.join(str(word) for word in words)} ends with {done.returncode}:\n{done.stdout}")
    return done.stdout


def make_packages(build, folder):
    run(["cpack", "--config", build / "CPackConfig.cmake", "-B", folder, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip"],
        cwd=build)
    return {path.name.split("_")[0] if path.suffix == ".deb" else "tarball": path
            for path in folder.iterdir() if path.is_file()}


class Root:
    """A folder in place of the root of a system."""

    def __init__(self, folder):
        self.folder = folder
        for name in ("var/lib/dpkg/info", "var/lib/dpkg/updates", "var/log", "etc"):
            (folder / name).mkdir(parents=True)
        (folder / "var/lib/dpkg/status").touch()

    def __truediv__(self, name):
        return self.folder / name

    def dpkg(self, *words):
        return run(["dpkg", f"--root={self.folder}", *DPKG_OPTIONS, *words])

    def files(self):
        """All but those of dpkg, as paths below the root."""
        paths = (path.relative_to(self.folder).as_posix() for path in self.folder.rglob("*"))
        return {path for path in paths if not path.startswith(("var/lib/dpkg", "var/log"))}


def check_program(source, root):
    program = root / "usr/bin/tetfarm"
    told = json.loads(run([program, "version", "--json"]))
    fields = run(["dpkg-query", f"--admindir={root / 'var/lib/dpkg'}", "-W", "-f", "${Version} ${Depends}", "tetfarm"])
    require(fields.startswith(told["version"] + "-"), f"the version of the package: {fields}")
    for library in ("libc6", "libzmq5", "libstdc++6"):
        require(library in fields, f"{library} is not among what the package depends on: {fields}")
    for page, words in (("man1/tetfarm.1", []), ("man1/tetfarm-run.1", ["run"]), ("man5/tetfarm-job.5", ["job"]),
                        ("man8/tetfarm-coordinator.8", ["coordinator"])):
        text = gzip.decompress((root / f"usr/share/man/{page}.gz").read_bytes()).decode()
        require(text == run([program, "man", *words]), f"{page}.gz is not what the program prints")
    documents = root / "usr/share/doc/tetfarm"
    for name in ("copyright", "changelog.gz", "changelog.Debian.gz", "docs/job_file.md", "examples/deploy/README.md"):
        require((documents / name).is_file(), f"{name} is not among the documents")
    changes = gzip.decompress((documents / "changelog.gz").read_bytes()).decode()
    require(changes == (source / "CHANGELOG.md").read_text(encoding="utf-8"), "changelog.gz is not CHANGELOG.md")
    for name in ("bash-completion/completions/tetfarm", "zsh/vendor-completions/_tetfarm",
                 "fish/vendor_completions.d/tetfarm.fish"):
        require((root / "usr/share" / name).is_file(), f"{name} is not there")


def check_run(program, module, examples, folder):
    """The example through the installed module and the installed program."""
    folder.mkdir()
    job = examples / "cube_sphere/cube_sphere.toml"
    run([program, "run", job, "-o", "by_itself", "--progress", "none"], cwd=folder)
    said = run([sys.executable, "-c", RUN, job], cwd=folder,
               env={**os.environ, "TETFARM": str(program), "PYTHONPATH": str(module)})
    require(said.strip() == f"True {module}/tetfarm/__init__.py", f"the installed module says {said}")
    require((folder / "out/cube_sphere.vtkhdf").read_bytes() == (folder / "by_itself/cube_sphere.vtkhdf").read_bytes(),
            "the module and the program give different meshes")


def check_services(root):
    user = next((line for line in (root / "etc/passwd").read_text().splitlines() if line.startswith("tetfarm:")), "")
    require(user, "there is no user tetfarm")
    for name in ("var/lib/tetfarm", "etc/tetfarm/keys"):
        found = (root / name).stat()
        require(stat.S_IMODE(found.st_mode) == 0o700, f"{name} may be entered by others")
        require(found.st_uid == int(user.split(":")[2]), f"{name} does not belong to the user tetfarm")
    units = root / "usr/lib/systemd/system"
    # With the program where it lies here.
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for path in units.iterdir():
            text = path.read_text(encoding="utf-8")
            require("ExecStart=/usr/bin/tetfarm " in text, f"{path.name} starts another program")
            # A template is looked at as one of its services.
            (folder / path.name.replace("@.", "@1.")).write_text(
                text.replace("/usr/bin/tetfarm", str(root / "usr/bin/tetfarm")), encoding="utf-8")
        said = run(["systemd-analyze", "verify", "--man=no", "--recursive-errors=no", *sorted(folder.iterdir())])
        require(not said.strip(), f"systemd-analyze says {said}")


def check_coordinator(root):
    """It starts as the unit has it and with the settings as installed, but for the root and the ports."""
    unit = settings_of(root / "usr/lib/systemd/system/tetfarm-coordinator.service")
    settings = settings_of(root / "etc/tetfarm/coordinator.conf")
    require(settings["LISTEN"].startswith("tcp://127.0.0.1:"), "other hosts can reach the coordinator as installed")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    settings["LISTEN"] = "tcp://127.0.0.1:*"
    settings["OPTIONS"] = settings["OPTIONS"].replace(":8080", f":{port}")
    command = unit["ExecStart"].replace("$OPTIONS", settings["OPTIONS"])
    command = re.sub(r"\$\{(\w+)\}", lambda name: settings[name.group(1)], command)
    words = [str(root / word[1:]) if word.startswith("/") else word for word in command.split()]
    name, value = unit["Environment"].split("=", 1)
    coordinator = subprocess.Popen(words, env={**os.environ, name: str(root / value[1:])}, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    said = []
    for line in coordinator.stdout:
        said.append(line)
        if line.startswith("listening on"):
            coordinator.terminate()
    require(coordinator.wait() == 0 and any(line.startswith("listening on") for line in said),
            f"{' '.join(words)} says {''.join(said)}")
    shutil.rmtree(root / "var/lib/tetfarm")
    (root / "var/lib/tetfarm").mkdir()


def settings_of(path):
    lines = (line for line in path.read_text(encoding="utf-8").splitlines() if "=" in line and not line.startswith("#"))
    return dict(line.split("=", 1) for line in lines)


def check_upgrade(root, packages):
    """What was changed in /etc, and what services wrote, is there afterwards."""
    settings = root / "etc/tetfarm/coordinator.conf"
    settings.write_text("STORE=/shared/farm\n", encoding="utf-8")
    (root / "etc/tetfarm/keys/coordinator.key").write_text("secret", encoding="utf-8")
    root.dpkg("-i", packages["tetfarm"], packages["tetfarm-coordinator"])
    require(settings.read_text(encoding="utf-8") == "STORE=/shared/farm\n", "an upgrade changed coordinator.conf")
    require((root / "etc/tetfarm/keys/coordinator.key").is_file(), "an upgrade removed a key")


def check_removal(root):
    # As Python leaves it that root starts.
    (root / "usr/lib/python3/dist-packages/tetfarm/__pycache__").mkdir(exist_ok=True)
    (root / "usr/lib/python3/dist-packages/tetfarm/__pycache__/jobs.cpython-311.pyc").touch()
    root.dpkg("--remove", "tetfarm-coordinator", "tetfarm")
    require((root / "etc/tetfarm/coordinator.conf").is_file(), "a removal that is no purge removes settings")
    root.dpkg("--purge", "tetfarm-coordinator", "tetfarm")
    left = {path for path in root.files() if "tetfarm" in path}
    require(left == {"etc/tetfarm", "etc/tetfarm/keys", "etc/tetfarm/keys/coordinator.key"},
            f"after a purge with a key: {sorted(left)}")
    shutil.rmtree(root / "etc/tetfarm")
    left = {path for path in root.files() if (root / path).is_file()} - WRITTEN_BY_SYSUSERS
    require(not {path for path in left if not path.endswith("-")}, f"after a purge: {sorted(left)}")


def check_tarball(path, folder):
    """Unpacked anywhere, also where the path has a blank."""
    folder.mkdir()
    run(["tar", "-xf", path, "-C", folder])
    top, = folder.iterdir()
    for name in ("bin/tetfarm", "share/man/man1/tetfarm.1", "share/doc/tetfarm/LICENSE",
                 "share/doc/tetfarm/examples/LICENSE-Apache-2.0"):
        require((top / name).is_file(), f"{name} is not in the tarball")
    require({path.name for path in top.iterdir()} == {"bin", "lib", "share"}, "there is more in the tarball")
    require(not (top / "include").exists(), "the library is in the tarball")
    check_run(top / "bin/tetfarm", top / "lib/python3/dist-packages", top / "share/doc/tetfarm/examples",
              folder / "work")


@contextlib.contextmanager
def told_when_wrong():
    try:
        yield
    except Wrong as wrong:
        print(wrong)
        sys.exit(1)


def main():
    source, build = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    missing = [name for name in NEEDED if shutil.which(name) is None]
    if missing or os.geteuid() != 0:
        print(f"missing: {', '.join(missing)}" if missing else "only root can install packages")
        sys.exit(1 if os.environ.get("CI") else SKIPPED)
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    with told_when_wrong(), tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        packages = make_packages(build, folder / "packages")
        require(set(packages) == {"tetfarm", "tetfarm-coordinator", "tarball"}, f"packages: {sorted(packages)}")
        root = Root(folder / "root")
        root.dpkg("-i", packages["tetfarm"], packages["tetfarm-coordinator"])
        check_program(source, root)
        check_run(root / "usr/bin/tetfarm", root / "usr/lib/python3/dist-packages",
                  root / "usr/share/doc/tetfarm/examples", folder / "work")
        check_services(root)
        check_coordinator(root)
        check_upgrade(root, packages)
        check_removal(root)
        check_tarball(packages["tarball"], folder / "un packed")
        print(", ".join(f"{path.name}: {path.stat().st_size} bytes" for path in packages.values()))


if __name__ == "__main__":
    main()
