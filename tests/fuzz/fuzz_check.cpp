// The whole of `check` on any bytes: no crash, no hang, findings with places that exist.
#include "files.h"
#include "rules/check.h"

#include <cstdlib>

using namespace drawbead;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    MemoryReader files = files_from(data, size);
    ReadOptions reading;
    reading.max_files = 100;
    const DeckResult result = check_deck(fuzz_main, files, reading, {});
    if (result.failed() && !result.findings.empty()) std::abort();
    for (const Finding& finding : result.findings) {
        if (finding.message.empty() || finding.places.empty() || finding.fingerprint.size() != 16)
            std::abort();
        for (const ResolvedPlace& place : finding.places)
            if (place.line == 0 || place.column == 0 || place.file.empty()) std::abort();
    }
    return 0;
}
