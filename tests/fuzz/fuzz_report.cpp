// A report of any bytes, as `merge` reads it: no crash, no hang, an error that says something.
#include "cli/report_reader.h"

#include <cstdlib>

using namespace drawbead;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Result<ReadReport> report = parse_report(text, "r.json");
    if (!report && report.error().message.empty()) std::abort();
    return 0;
}
