"""Turns off each effect of the plan wrongly, one at a time, and expects a test to notice.

    mutate_plan.py BUILD_FOLDER

Builds the tests of the evaluator with src/force/plan.cpp changed; the file is put back at the end."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLAN = ROOT / "src" / "force" / "plan.cpp"
ANCHOR = "        return std::move(plan_);\n"
EFFECTS = ["window", "search", "normal", "ramp", "thickness", "reset", "ft_ramp", "variation", "viscous",
           "incremental", "stick_reset", "moving", "deforming_blank", "moving_tool", "edge", "energy"]


def build(folder):
    subprocess.run(["cmake", "--build", folder, "--target", "test_force", "test_scene"], check=True,
                   stdout=subprocess.DEVNULL)


def passes(folder):
    return all(subprocess.run([f"{folder}/tests/{room}/test_{room}", *names], stdout=subprocess.DEVNULL,
                              check=False).returncode == 0
               for room, names in (("force", []), ("scene", ["evaluation*"])))


def main():
    folder = sys.argv[1]
    text = PLAN.read_text()
    assert text.count(ANCHOR) == 1
    survivors = []
    try:
        for effect in EFFECTS:
            PLAN.write_text(text.replace(ANCHOR, f"        plan_[Effect::{effect}].verdict = V::off;\n" + ANCHOR))
            build(folder)
            if passes(folder):
                survivors.append(effect)
            print(effect, "survives" if effect in survivors else "is noticed", flush=True)
    finally:
        PLAN.write_text(text)
    build(folder)
    if not passes(folder):
        sys.exit("the tests fail without a change too")
    if survivors:
        sys.exit("nobody notices that these are off: " + ", ".join(survivors))


if __name__ == "__main__":
    main()
