#!/usr/bin/python3
"""Whether code that is compiled for AVX2 stays where it is asked for.

An inline function or a template that an AVX2 file and any other file both compile is one symbol to the linker, which keeps
either: the AVX2 one would then run on processors without AVX2.

usage: avx2_symbols.py NM ARCHIVE...
"""
import subprocess
import sys


def definitions(nm, archive):
    """(object, symbol) for each global or weak definition in an archive."""
    found, current = [], ""
    for line in subprocess.run([nm, "--defined-only", "--extern-only", archive], check=True, capture_output=True,
                               text=True).stdout.splitlines():
        words = line.split(None, 2)
        if len(words) == 3:
            found.append((current, words[2]))
        elif line.endswith(":"):
            current = line[:-1]
    return found


def main():
    nm, *archives = sys.argv[1:]
    elsewhere, avx2 = set(), {}
    for archive in archives:
        for name, symbol in definitions(nm, archive):
            if "_avx2." in name:
                avx2[symbol] = name
            else:
                elsewhere.add(symbol)
    if not avx2 or not elsewhere:
        sys.exit("no object of AVX2 code, or no other, was found")
    shared = sorted(symbol for symbol in avx2 if symbol in elsewhere)
    for symbol in shared:
        print(f"{avx2[symbol]} shares {symbol}")
    print(f"{len(avx2)} symbols of AVX2 code, {len(shared)} of them elsewhere too")
    sys.exit(1 if shared else 0)


if __name__ == "__main__":
    main()
