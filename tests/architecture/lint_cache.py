"""What was found clean before and has not changed: a file for each, named after all that the finding rests on.

Only clean results are kept, so a finding is looked for, and told, each time. They lie beside those of the compiler's cache: who keeps
or clears the one does so with the other.
"""

import hashlib
import os
import time

DAYS_UNUSED = 30


def folder_of_user():
    """In the compiler's cache, whose own files have folders of one character."""
    home = os.environ.get("HOME", "/nonexistent")
    return os.path.join(os.environ.get("CCACHE_DIR") or os.path.join(home, ".cache", "ccache"), "lint")


def key_of(*parts):
    """Of bytes, each with its length, as otherwise ("ab", "c") would be ("a", "bc")."""
    digest = hashlib.blake2b(digest_size=20)
    for part in parts:
        digest.update(str(len(part)).encode() + b":" + part)
    return digest.hexdigest()


class CleanResults:
    """A folder that cannot be written is an empty one that stays empty."""

    def __init__(self, folder):
        self.folder = folder
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError:
            pass

    def has(self, key):
        """And it was used now."""
        try:
            os.utime(os.path.join(self.folder, key))
            return True
        except OSError:
            return False

    def add(self, key):
        try:
            with open(os.path.join(self.folder, key), "w", encoding="utf-8"):
                pass
        except OSError:
            pass

    def forget_unused(self):
        """Those that nobody asked for in a month."""
        try:
            for entry in list(os.scandir(self.folder)):
                if entry.stat().st_mtime < time.time() - DAYS_UNUSED * 86400:
                    os.remove(entry.path)
        except OSError:
            pass
