// The trace reader on any bytes: no crash, no hang, and what it takes is a trace in order.
#include "force/trace.h"

#include <cmath>
#include <cstdlib>

using namespace drawbead;

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto trace = parse_trace(text, "t.csv");
    if (!trace) {
        require(!trace.error().message.empty() && trace.error().line > 0);
        return 0;
    }
    require(!trace->rows.empty());
    for (std::size_t i = 0; i < trace->rows.size(); ++i) {
        const TraceRow& row = trace->rows[i];
        for (const double value : row.value)
            require(std::isfinite(value));
        if (i == 0) continue;
        const TraceRow& before = trace->rows[i - 1];
        require(row.line > before.line);
        const auto order = [](const TraceRow& r) {
            return std::array{r.integer(TraceColumn::ncycle), r.integer(TraceColumn::nin),
                              r.integer(TraceColumn::inod)};
        };
        require(order(before) < order(row));
    }
    return 0;
}
