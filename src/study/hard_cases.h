#pragma once
// Scenes in which arithmetic is hard: contact that begins, ends or has no size, numbers of any magnitude,
// laws that jump. Each says what must hold all the same, measures it, and is run by `drawbead accuracy
// --hard-cases` and by the tests alike.
#include "force/evaluation.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

enum class NumberType : uint8_t { float64, float32 };
std::string_view name(NumberType); ///< "double" or "float"

/// |measured − expected| ≤ bound holds or the case fails; a NaN fails.
struct HardCaseResult {
    double measured = 0;
    double expected = 0; ///< of a violation: its size, from the law's own formula; else 0
    double bound = 0;

    bool as_expected() const;
};

struct HardCase {
    std::string_view name;
    Law law = Law::manual;
    NumberType number = NumberType::float64;
    std::string_view scene;     ///< one sentence
    std::string_view invariant; ///< one sentence; what is measured is how far it is missed
    std::string_view guard;     ///< FILE: the code without which the case would fail; empty: none alone
    bool violated = false;      ///< the law itself breaks the invariant, by HardCaseResult::expected
    HardCaseResult (*measure)() = nullptr;

    std::string id() const; ///< NAME.LAW.NUMBER, which no two cases share
};

/// All cases in a fixed order.
std::span<const HardCase> hard_cases();

} // namespace drawbead
