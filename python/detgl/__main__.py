"""The command `detgl`: `python -m detgl run script.py`, `detgl run -- program`, `detgl doctor`."""

import os
import sys

from . import libraries


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["run"]:
        # What `detgl run` is given first is a program, a script, or `-m module` of this Python.
        at = next((at for at, text in enumerate(arguments[1:], 1) if text != "--glu"), len(arguments))
        rest = arguments[at:]
        if rest and (rest[0].endswith(".py") or rest[0] in ("-m", "-c")):
            arguments = [*arguments[:at], "--", sys.executable, *rest]
    program = str(libraries() / "detgl")
    os.execv(program, [program, *arguments])


if __name__ == "__main__":
    main()
