#!/usr/bin/env python3
"""The boundary of the flow round NACA 0012 with a sharp trailing edge, as loops of points for `tetfarm plane`:

    naca0012.py FOLDER

writes FOLDER/naca0012.xy, of chord 1 from (0, 0) to (1, 0), FOLDER/flap.xy, the same profile with a chord of 0.3 behind a slot of
2 % and turned down by 10 degrees, and FOLDER/farfield.xy, a circle of radius 30 round (0.5, 0).
"""

import math
import pathlib
import sys

POINTS = 60  # round the profile, closest at both ends
FAR_POINTS = 60
RADIUS = 30
FLAP_CHORD = 0.3
FLAP_NOSE = (0.995, -0.028)
FLAP_DEG = 10


def half_thickness(x):
    return 0.6 * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)


def profile():
    """From the trailing edge along the upper side to the nose, and back along the lower one."""
    for i in range(POINTS):
        angle = 2 * math.pi * i / POINTS
        x = 0.5 * (1 + math.cos(angle))
        yield x, math.copysign(half_thickness(x) if i else 0, math.sin(angle))


def flap():
    along = math.cos(math.radians(FLAP_DEG)), -math.sin(math.radians(FLAP_DEG))
    for x, y in profile():
        x, y = FLAP_CHORD * x, FLAP_CHORD * y
        yield FLAP_NOSE[0] + x * along[0] - y * along[1], FLAP_NOSE[1] + x * along[1] + y * along[0]


def far_field():
    for i in range(FAR_POINTS):
        angle = 2 * math.pi * i / FAR_POINTS
        yield 0.5 + RADIUS * math.cos(angle), RADIUS * math.sin(angle)


def main():
    folder = pathlib.Path(sys.argv[1])
    for name, points in (("naca0012.xy", profile()), ("flap.xy", flap()), ("farfield.xy", far_field())):
        (folder / name).write_text("".join(f"{x!r} {y!r}\n" for x, y in points), encoding="ascii")


if __name__ == "__main__":
    main()
