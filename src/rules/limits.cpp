#include "rules/limits.h"

#include <algorithm>
#include <array>

namespace drawbead {

std::string LimitInfo::key() const {
    std::string hyphened(identifier);
    std::replace(hyphened.begin(), hyphened.end(), '_', '-');
    return hyphened;
}

std::span<const LimitInfo> limit_table() {
#define DRAWBEAD_ROW(rule, key, value, least, most, unit, text)                                              \
    LimitInfo{#rule, #key, &Limits::rule##_##key, value, least, most, unit, text},
    static constexpr std::array table{DRAWBEAD_LIMITS(DRAWBEAD_ROW)};
#undef DRAWBEAD_ROW
    return table;
}

} // namespace drawbead
