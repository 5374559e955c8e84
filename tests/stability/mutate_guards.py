"""Takes one guard after the other out of the code, and expects the hard case that names it to fail.

    mutate_guards.py FOLDER [--jobs N] [--compiler CXX]

FOLDER is emptied and holds a copy of the sources in which every guard can be switched off by the environment
variable DRAWBEAD_MUTANT, so that one build serves all mutants. The sources themselves are not touched."""

import argparse
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
FLAGS = ["-std=c++20", "-O1", "-ffp-contract=off", "-pthread", "-w"]
SOURCES = ["base/*.cpp", "geometry/*.cpp", "bead/*.cpp", "contact/*.cpp", "study/hard_*.cpp",
           *(f"force/{name}.cpp" for name in ("evaluator", "manual_run", "solver_run", "solver_block",
                                              "solver_block_avx2", "motion", "moving_surface", "plan",
                                              "time_table"))]
SWITCH = """#pragma once
#include <cstdlib>
inline bool drawbead_mutant(int number) {
    static const int at_work = [] {
        const char* text = std::getenv("DRAWBEAD_MUTANT");
        return text ? std::atoi(text) : 0;
    }();
    return at_work == number;
}
"""

# The hard case that must fail, a file, the guard between « and » in text that stands there once, and what takes
# its place. A guard that ends with ; is a statement, others are expressions.
GUARDS = []


def guard(case, file, text, instead):
    GUARDS.append((case, file, text, instead))


MANUAL = "force/manual_law.h"
guard("reversal-each-step.manual.double", MANUAL, "out.restraint = «std::clamp(trial, -limit, limit)»;", "trial")
guard("plateau-edge.manual.double", MANUAL,
      "out.ramp = «std::min(out.penetration / depth, Real(1))»;\n        out.normal_force = P", "out.penetration / depth")
guard("restraint-past-depth.manual.double", MANUAL, "depth > 0 ? «std::min(out.penetration / depth, Real(1))» :",
      "out.penetration / depth")
guard("soft-blank.manual.double", MANUAL, "out.normal_force = «std::min(at.stiffness * out.penetration, P)»;",
      "at.stiffness * out.penetration")
guard("negative-depth.manual.double", MANUAL, "const Real depth = «std::max(bead.depth, Real(0))»;", "bead.depth")
guard("negative-Ft.manual.double", MANUAL, ": «std::max(bead.ft_first, Real(0))»;", "bead.ft_first")
guard("negative-Fn.manual.double", MANUAL, ": «std::max(bead.fn_first, Real(0))»;", "bead.fn_first")
guard("limit-crosses-zero.manual.double", MANUAL,
      "first + s_fraction * (last - first), «Real(0)»);", "Real(-1e30)")
guard("last-value-zero.manual.double", MANUAL, "std::max(«last == 0» ?", "false")
guard("Fn-last-alone.manual.double", MANUAL, "E.normal && «bead.fn_first != 0»;", "true")
guard("lift-off.manual.double", MANUAL, "{\n        «q = 0;»\n        return out;", "")
guard("beside-the-edge.manual.double", MANUAL, "if («!at.on_surface» ||", "false")
guard("no-stiffness.manual.double", MANUAL, "out.slip = «at.stiffness > 0» ?", "true")
guard("perpendicular-bead.manual.double", MANUAL, "v = «largest > 0» ?", "true")
guard("huge-speed.manual.double", MANUAL,
      "out.restraint = «std::clamp(std::sqrt(at.stiffness * at.mass) * speed, -limit, limit)»;",
      "std::sqrt(at.stiffness * at.mass) * speed")
guard("any-magnitude.manual.double", MANUAL, "if («!(size > 1 / far && size < far)»)", "!(size > 0)")

SOLVER = "force/solver_law.h"
guard("huge-speed.solver.double", SOLVER,
      "out.restraint = «min(vv * sqrt(k * mass * per_L2), out.ft_limit)» * face;", "vv * sqrt(k * mass * per_L2)")
guard("pressed-past-depth.solver.double", SOLVER,
      "out.normal_force = «select(plateau, out.normal_force, node.slope * out.penetration * L)»;",
      "node.slope * out.penetration * L")
guard("restraint-past-depth.solver.double", SOLVER, "select(acts, «select(plateau, one, share)», one)", "share")
guard("out-of-reach.solver.double", SOLVER, "const MaskOf<Real> acts = «out.penetration > none»;",
      "out.penetration > -Real(1e30)")
guard("last-value-zero.solver.double", SOLVER, "return «last == 0» ? Real(first)", "false")
guard("no-stiffness.solver.double", SOLVER, "(force - p) / «max(Real(1e-20), under)»;", "under")
guard("no-step.solver.double", SOLVER, "k + «select(is_zero(node.dt), none, damper * (one / node.dt))»;",
      "damper * (one / node.dt)")
guard("coincident-nodes.solver.double", SOLVER, "const Real L2 = «max(dot(T, T), Real(1e-20))»;", "dot(T, T)")
guard("any-direction.solver.double", SOLVER, "const MaskOf<Real> backwards = «along < none»;", "along < along")
guard("point-segment.solver.double", SOLVER, "whole / «max(Real(1e-30), norm(whole))»;", "norm(whole)")
guard("line-segment.solver.double", SOLVER, "return «select(is_zero(under), none, over / under)»;", "over / under")
guard("triangle.solver.double", SOLVER, "const MaskOf<Real> triangle = «is_zero(a[2])»;", "a[2] < a[2]")
guard("beside-across.solver.double", SOLVER, "at.xi = select(at.inside, «max(-one, min(at.xi, one))», at.xi);",
      "at.xi")
guard("beside-along.solver.double", SOLVER, "at.eta = select(at.inside, «max(-one, min(at.eta, one))», at.eta);",
      "at.eta")
guard("lifted-beside-contact.solver.double", SOLVER, "state.stored = «only(e * T, state.stored)»;", "e * T")

CLOSEST = "geometry/closest_point.cpp"
guard("closest-point-segment.manual.double", CLOSEST,
      "double t = «!(along > 0) ? 0.0 : !(along < squared_length) ? 1.0 : along / squared_length»;",
      "std::clamp(along / squared_length, 0.0, 1.0)")
guard("closest-triangle.manual.double", CLOSEST, "«if (length == 0) continue;»", "")
guard("closest-corner.manual.double", CLOSEST, "«if ((1 - t) * length <= tolerance) t = 1;»", "")
guard("closest-concave.manual.double", CLOSEST, "const bool planar = «convex» &&", "true")
guard("closest-second-root.manual.double", CLOSEST, "«if (std::abs(xi) > 1 || std::abs(eta) > 1) continue;»", "")
guard("closest-any-size.manual.double", CLOSEST, "if («!extreme»)", "true")

SHAPE = "geometry/segment_shape.cpp"
guard("closest-line-segment.manual.double", SHAPE, "return «length > 0» ? a / length", "true")
guard("closest-collinear-corner.manual.double", SHAPE, "if («norm(product) > 1e-12 * scale»)", "true")

SURFACE = "contact/closest_segment.cpp"
guard("closest-shared-edge.manual.double", SURFACE, "c.inside : «c.segment < best->segment»", "c.segment > best->segment")
guard("closest-foot-inside.manual.double", SURFACE, "(«c.inside != best->inside» ?", "false")
guard("closest-edge-margin.manual.double", "contact/closest_segment.h", "«offset <= 0.05»;", "offset < 0.05")
guard("closest-shrunk-edge.manual.double", SURFACE, "hit.offset = «size > 0» ?", "true")
guard("closest-nothing.manual.double", SURFACE, "if («!best») {", "false")
guard("closest-behind.manual.double", SURFACE, "hit.d = «along < 0» ?", "false")

SEARCH = "contact/solver_search.cpp"
guard("project-point-segment.solver.double", SEARCH, "hit.xi = «xi_below == 0» ?", "false")
guard("project-point-triangle.solver.double", SEARCH, "hit.eta = «s.a[0] == 0» ?", "false")
guard("tie-between-nodes.solver.double", SEARCH, "|| «(squared == closest && node < nearest)»)", "false")
guard("tie-between-segments.solver.double", SEARCH,
      "|| «(b == best && mesh.segment[s] < mesh.segment[track.segment])»)", "false")
guard("collapsed-segment.solver.double", "contact/segment_corner.h", "return «std::isnan(b1 + b2)» ?", "false")
TRACKS = "contact/rigid_tracks.cpp"
guard("region-coincident-nodes.solver.double", TRACKS, "out.margin = «margin > 0» ?", "true")
guard("region-tie-of-nodes.solver.double", TRACKS, "|| «(squared == closest && one < nearest)»)", "false")
guard("region-tie-of-segments.solver.double", TRACKS,
      "«(one.least == best.least && mesh_.segment[s] < mesh_.segment[segment])»)", "false")
guard("tributary-without-length.solver.double", SEARCH, "const double l2 = «std::max(dot(t, t), 1e-20)»;", "dot(t, t)")
guard("depth-absent.solver.double", SEARCH, "«if (!(depth > 0)) return 1;»", "")
guard("reach-without-size.solver.double", "contact/segment_mesh.cpp", "return «reach > 0» ? reach", "true")

STIFFNESS = "contact/blank_stiffness.cpp"
guard("solid-without-volume.solver.double", STIFFNESS, "return «volume > 0» ?", "true")
guard("slope-of-void.solver.double", STIFFNESS, "ramp > smallest_k && «smallest_k != 0» ?", "true")
guard("slope-without-depth.solver.double", STIFFNESS, "if («depth <= 1e-20») return", "depth < 0")
guard("slope-past-the-table.solver.double", STIFFNESS, "«if (bead_node >= segments) return {};»\n    if (slope.kind",
      "if (bead_node >= k_in_storage_order.size()) return 0.0;")

LINE = "bead/bead_line.cpp"
guard("line-one-place.manual.double", LINE, "|| «!(s_total > 0)») return", "false")
guard("line-last-zero.solver.double", LINE, "if («last == 0» ||", "false")
guard("line-Fn-last-alone.solver.double", LINE, "return «first == 0» ? 0", "false")

MANUAL_RUN = "force/manual_run.cpp"
guard("window-empty.manual.double", MANUAL_RUN, "return t >= bead_.t_start && «t < bead_.t_stop»;",
      "t <= bead_.t_stop")
guard("one-place.manual.double", MANUAL_RUN, "s = «length > 0» ? s / length", "true")
guard("solid-faces.manual.double", MANUAL_RUN, "if («stiffness.half_thickness > 0»)", "true")
guard("void-dissipation.manual.double", MANUAL_RUN, "const double slip = «b.k > 0» ?", "true")
guard("void-work.manual.double", MANUAL_RUN, "const double change = «b.k > 0» ?", "true")
guard("void-stored.manual.double", MANUAL_RUN, "if («now_[i].k > 0»)", "true")
guard("void-lift-off.manual.double", MANUAL_RUN, "if (incremental_ && «k > 0»)", "true")
guard("triangle-masses.manual.double", MANUAL_RUN, "corners = «is_triangle(nodes)» ?", "false")
guard("pressing-only.manual.double", MANUAL_RUN, "const double mean = «way != 0» ?", "true")

SOLVER_RUN = "force/solver_run.cpp"
guard("window-empty.solver.double", SOLVER_RUN, "if («t < bead_.t_start || t > bead_.t_stop»)",
      "t < bead_.t_start || t >= bead_.t_stop")
guard("one-place.solver.double", SOLVER_RUN, "has(Effect::variation) && «s_.back() > 0» ?", "true")
guard("one-place-capacity.solver.double", SOLVER_RUN, "const double share = «length > 0» ?", "true")
guard("void-stored.solver.double", "force/solver_block_kernel.h",
      "const auto holds = «both(segment.stiffness > none, abs(f.ft_limit) > none)»;", "abs(f.ft_limit) > none")
guard("Fn-last-alone.solver.double", SOLVER_RUN, "«if (law_.fn_first == 0) law_.fn_last = 0;»", "")

MOTION = "force/motion.cpp"
guard("repeated-times.solver.double", MOTION, "out.velocity[n] = «spread > 0» ?", "true")
guard("repeated-times-displacement.solver.double", MOTION, "if (displaced && «dt[n] > 0»)", "true")


def switched(folder):
    """The copy, with every guard behind its switch."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "src", folder / "src", ignore=shutil.ignore_patterns("rules", "cli", "model", "deck"))
    shutil.copy(ROOT / "tests" / "stability" / "run_case.cpp", folder)
    (folder / "switch.h").write_text(SWITCH)
    edits = {}
    for number, (_, file, text, instead) in enumerate(GUARDS, 1):
        before, guarded, after = text.replace("»", "«").split("«")
        whole = (ROOT / "src" / file).read_text()
        if whole.count(before + guarded + after) != 1:
            sys.exit(f"src/{file}: this stands there {whole.count(before + guarded + after)} times, not once:\n"
                     + before + guarded + after)
        at = whole.index(before + guarded + after) + len(before)
        code = (f"if (drawbead_mutant({number})) {{ {instead} }} else {{ {guarded} }}" if guarded.endswith(";") else
                f"(drawbead_mutant({number}) ? ({instead}) : ({guarded}))")
        edits.setdefault(file, []).append((at, at + len(guarded), code))
    for file, changes in edits.items():
        changes.sort(reverse=True)
        if any(low[1] > high[0] for high, low in zip(changes, changes[1:])):
            sys.exit(f"src/{file}: two guards overlap")
        whole = (ROOT / "src" / file).read_text()
        for begin, end, code in changes:
            whole = whole[:begin] + code + whole[end:]
        (folder / "src" / file).write_text(whole)


def build(folder, compiler, jobs):
    sources = sorted({path for pattern in SOURCES for path in (folder / "src").glob(pattern)})
    sources.append(folder / "run_case.cpp")

    def compile_one(source):
        target = source.with_suffix(".o")
        subprocess.run([compiler, *FLAGS, "-include", folder / "switch.h", "-I", folder / "src", "-c", source, "-o",
                        target], check=True)
        return target

    # The large ones first.
    sources.sort(key=lambda path: ("force" not in path.parts and "study" not in path.parts, path))
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        objects = list(pool.map(compile_one, sources))
    program = folder / "run_case"
    subprocess.run([compiler, "-pthread", *objects, "-o", program], check=True)
    return program


def run(program, number, cases):
    """Exit status of these cases with one mutant; None when they take too long."""
    try:
        return subprocess.run([program, *cases], env={**os.environ, "DRAWBEAD_MUTANT": str(number)}, timeout=60,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode
    except subprocess.TimeoutExpired:
        return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--compiler", default="g++")
    options = parser.parse_args()
    folder = options.folder.resolve()
    started = time.monotonic()
    switched(folder)
    program = build(folder, options.compiler, options.jobs)
    built = time.monotonic()

    if run(program, 0, sorted({case for case, *_ in GUARDS})) != 0:
        subprocess.run([program], check=False)
        sys.exit("cases fail, or are not known, with every guard in its place")
    survivors = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        states = pool.map(lambda item: run(program, item[0], [item[1][0]]), enumerate(GUARDS, 1))
        for (case, file, *_), status in zip(GUARDS, states):
            said = {0: "survives", 1: "is noticed", None: "hangs"}.get(status, "crashes")
            if status == 0:
                survivors.append(f"{file}, {case}")
            print(f"{case}: without its guard in {file}: {said}", flush=True)
    print(f"{len(GUARDS)} guards: {built - started:.0f} s to build, {time.monotonic() - built:.0f} s to run")
    if survivors:
        sys.exit("nobody notices that these guards are gone:\n" + "\n".join(survivors))


if __name__ == "__main__":
    main()
