#pragma once
// JSON reports of `check`, read back for `merge`.
#include "base/result.h"
#include "findings/report.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

struct ReadReport {
    std::string path, tool_version;
    std::optional<Shard> shard;
    std::vector<DeckResult> decks;
    bool interrupted = false;
    uint64_t asked = 0; ///< decks that were to be checked
};

/// A file by schemas/report.schema.json. Members that are not known are passed over; one that is missing or
/// of another kind is an error that names it.
Result<ReadReport> read_report(const std::string& path);
/// The same of the bytes of one; `path` is for messages.
Result<ReadReport> parse_report(std::string_view text, const std::string& path);

} // namespace drawbead
