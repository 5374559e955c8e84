"""Turns off each effect of the plan wrongly, one at a time, and expects a test to notice.

    mutate_plan.py BUILD_FOLDER

Builds the tests of the evaluator once, with src/force/plan.cpp changed so that a variable of the environment says which
effect is off; the file is put back, and built again, at the end."""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLAN = ROOT / "src" / "force" / "plan.cpp"
ANCHOR = "        return std::move(plan_);\n"
SWITCH = """        if (const char* number = std::getenv("DRAWBEAD_MUTANT"))
            plan_.effect[static_cast<std::size_t>(std::atoi(number))].verdict = V::off;
"""
# As drawbead::Effect.
EFFECTS = ["window", "search", "normal", "ramp", "thickness", "reset", "ft_ramp", "variation", "viscous",
           "incremental", "stick_reset", "moving", "deforming_blank", "moving_tool", "edge", "energy"]


def build(folder):
    subprocess.run(["cmake", "--build", folder, "--target", "test_force", "test_scene"], check=True,
                   stdout=subprocess.DEVNULL)


def passes(folder, number=None):
    environment = dict(os.environ) if number is None else {**os.environ, "DRAWBEAD_MUTANT": str(number)}
    return all(subprocess.run([f"{folder}/tests/{room}/test_{room}", *names], stdout=subprocess.DEVNULL,
                              env=environment, check=False).returncode == 0
               for room, names in (("force", []), ("scene", ["evaluation*"])))


def main():
    folder = sys.argv[1]
    text = PLAN.read_text()
    assert text.count(ANCHOR) == 1
    survivors = []
    try:
        PLAN.write_text("#include <cstdlib>\n" + text.replace(ANCHOR, SWITCH + ANCHOR))
        build(folder)
        if not passes(folder):
            sys.exit("the tests fail without a change too")
        for number, effect in enumerate(EFFECTS):
            if passes(folder, number):
                survivors.append(effect)
            print(effect, "survives" if effect in survivors else "is noticed", flush=True)
    finally:
        PLAN.write_text(text)
        build(folder)
    if survivors:
        sys.exit("nobody notices that these are off: " + ", ".join(survivors))


if __name__ == "__main__":
    main()
