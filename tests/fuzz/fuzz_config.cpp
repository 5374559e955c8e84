// A configuration of any bytes: no crash, no hang; what is read can be shown, and what is shown read again.
#include "config/settings.h"

#include <cstdlib>

using namespace drawbead;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Result<Config> config = parse_config(text, "c.yaml");
    if (!config) {
        if (config.error().message.empty()) std::abort();
        return 0;
    }
    const Settings settings = settle(&*config, "a/b_0000.rad", {});
    const Result<Config> again = parse_config(show(settings, "a/b_0000.rad"), "c.yaml");
    if (!again || !(settle(&*again, "a/b_0000.rad", {}).rule_limits() == settings.rule_limits()))
        std::abort();
    return 0;
}
