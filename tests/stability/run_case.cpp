// Runs the hard cases that are named, or all, and says which fail: the program of mutate_guards.py.
#include "study/hard_cases.h"

#include <algorithm>
#include <cstdio>

int main(int argc, char** argv) {
    int found = 0, failed = 0;
    for (const drawbead::HardCase& one : drawbead::hard_cases()) {
        const std::string id = one.id();
        if (argc > 1 && std::find(argv + 1, argv + argc, id) == argv + argc) continue;
        ++found;
        const drawbead::HardCaseResult result = one.measure();
        if (result.as_expected()) continue;
        ++failed;
        std::printf("%s: %g, not %g to %g\n", id.c_str(), result.measured, result.expected, result.bound);
    }
    return found == 0 || (argc > 1 && found != argc - 1) ? 2 : failed > 0 ? 1 : 0;
}
