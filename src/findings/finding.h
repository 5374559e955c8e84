#pragma once
// What a check says: values that own everything they say, with no pointer into deck or model.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

enum class Severity : uint8_t { info, warning, error };
enum class FixAvailability : uint8_t { none, unsafe, sometimes_safe, safe };

std::string_view name(Severity);        ///< "error", "warning", "info"
std::string_view name(FixAvailability); ///< "none", "unsafe", "sometimes safe", "safe"
std::optional<Severity> severity_from(std::string_view name);

/// What is known of a rule before it runs. `page` is its Markdown page, embedded at build time.
struct RuleInfo {
    std::string_view code;    ///< "SRF001"
    std::string_view name;    ///< "segment-normal-away-from-bead"
    std::string_view summary; ///< one sentence without a full stop
    Severity severity = Severity::warning;
    FixAvailability fix = FixAvailability::none;
    int starter_message = 0; ///< the Starter message that it foresees, 0 when none
    std::string_view page{};

    std::string_view family() const { return code.substr(0, 3); }
};

/// A place in a file, resolved. `file` is as the user knows it; lines and columns count bytes from 1;
/// `end_column` is one past the last byte.
struct ResolvedPlace {
    std::string file;
    uint64_t line = 0;
    uint32_t column = 0, end_column = 0;
    std::string snippet; ///< the line, at most 160 bytes, control bytes replaced
    /// The columns in Unicode code points, a byte that is no UTF-8 being one; 0 where they are as in bytes.
    uint32_t character_column = 0, end_character_column = 0;

    uint32_t in_characters() const { return character_column ? character_column : column; }
    uint32_t end_in_characters() const { return end_character_column ? end_character_column : end_column; }
};

/// A number with its unit: "excess force", 4800, "N".
struct Measure {
    std::string name;
    double value = 0;
    std::string unit;
};

/// Ids of what a finding is about: all are counted, at most 100 are listed.
struct EntityList {
    static constexpr std::size_t most = 100;
    uint64_t count = 0;
    std::vector<int64_t> ids;
    uint64_t digest = 0; ///< of all of them, in whatever order they came: a sum of their hashes

    void add(int64_t id) { add(id, static_cast<uint64_t>(id)); }
    /// An id that depends on where things stand in the deck, with a key for fingerprints that does not.
    void add(int64_t id, uint64_t key) {
        ++count;
        digest += mixed(key);
        if (ids.size() < most) ids.push_back(id);
    }
    /// Every bit of the result depends on every bit of the key (the finaliser of SplitMix64).
    static constexpr uint64_t mixed(uint64_t key) {
        key += 0x9e3779b97f4a7c15u;
        key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9u;
        key = (key ^ (key >> 27)) * 0x94d049bb133111ebu;
        return key ^ (key >> 31);
    }
};

struct Entities {
    EntityList nodes, segments, elements;
};

/// A change of a file as it was before: `removed` bytes at `offset` became `text`. `where` has the place of
/// those bytes without a file name and a snippet; they end at `end_line`, whose columns its end columns
/// count.
struct FileEdit {
    uint64_t offset = 0, removed = 0;
    ResolvedPlace where;
    uint64_t end_line = 0;
    std::string text;
};
struct FileChange {
    std::string path;
    std::vector<FileEdit> edits;
};

struct FixOffer {
    std::string title;
    FixAvailability applicability = FixAvailability::safe; ///< safe or unsafe
    std::vector<FileChange> changes = {};                  ///< what it would do; empty where not asked for
};

struct Finding {
    std::string code, name;
    Severity severity = Severity::warning;
    std::string message; ///< lower case, no full stop, with ids, values and units
    std::optional<int64_t> interface_id;
    std::vector<ResolvedPlace> places; ///< the first is the primary one, at most 100
    uint64_t place_count = 0;          ///< of all places, listed or not
    Entities entities;
    std::vector<Measure> measured;
    std::vector<std::string> notes; ///< consequences
    std::string help;               ///< what to do
    std::vector<FixOffer> fixes;
    std::string
        fingerprint; ///< 16 hexadecimal digits from code, interface and entity ids, never line numbers
};

/// Hash of code, interface and all entity ids, whatever their order; stable between versions and machines.
std::string fingerprint(std::string_view code, std::optional<int64_t> interface_id, const Entities&,
                        std::string_view discriminator);

} // namespace drawbead
