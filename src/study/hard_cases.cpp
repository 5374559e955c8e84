#include "study/hard_cases.h"

#include "study/hard_case_table.h"

namespace drawbead {

std::string_view name(NumberType number) {
    return number == NumberType::float64 ? "double" : "float";
}

bool HardCaseResult::as_expected() const {
    return std::abs(measured - expected) <= bound;
}

std::string HardCase::id() const {
    return std::string(name) + "." + std::string(drawbead::name(law)) + "." +
           std::string(drawbead::name(number));
}

std::span<const HardCase> hard_cases() {
    static const std::vector<HardCase> all = [] {
        std::vector<HardCase> cases;
        for (const auto& table : {manual_kernel_cases(), solver_kernel_cases(), closest_point_cases(),
                                  solver_search_cases(), bead_line_cases(), run_cases()})
            for (const HardCaseRow& row : table) {
                HardCase one{row.name,      row.law,   NumberType::float64, row.scene,
                             row.invariant, row.guard, row.violated,        row.in_double};
                if (row.in_double) cases.push_back(one);
                one.number = NumberType::float32;
                one.measure = row.in_float;
                if (row.in_float) cases.push_back(one);
            }
        return cases;
    }();
    return all;
}

} // namespace drawbead
