#!/usr/bin/python3
"""Writes docs/configuration.md and schemas/config.schema.json from the program's table of options.

    docs/make_configuration.py PROGRAM          writes both
    docs/make_configuration.py PROGRAM --check  one line for each that is not what would be written; status 1 then
"""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
FILES = {"docs/configuration.md": ["explain", "configuration"], "schemas/config.schema.json": ["schema", "config"]}


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    stale = 0
    for name, command in FILES.items():
        text = subprocess.run([sys.argv[1], *command], check=True, stdout=subprocess.PIPE).stdout
        path = ROOT / name
        if path.exists() and path.read_bytes() == text:
            continue
        if sys.argv[2:]:
            print(f"{name} is not current: run docs/make_configuration.py")
            stale = 1
        else:
            path.write_bytes(text)
    sys.exit(stale)


if __name__ == "__main__":
    main()
