#pragma once
// A deck: its files, its blocks in the solver's order, and what holds where. Knows no keyword of mechanics.
#include "deck/card.h"
#include "deck/file_reader.h"
#include "deck/place.h"
#include "deck/scope.h"
#include "deck/source_file.h"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// One option: its header line and the text up to the next keyword line of the same file. An `#include` line
/// in the middle does not end it.
struct Block {
    std::string_view keyword; ///< "GRNOD/NODENS": fields between the first slash and the id
    int64_t id = 0;   ///< as written (parameters replaced), without the scope's offset; 1 when not given
    int64_t unit = 0; ///< unit id, 0 when none
    bool id_given = false;
    Span header; ///< the keyword line without its line end
    Span text;   ///< everything after the header line
    ScopeId scope{};
};

/// What the reader noticed, for rules and messages; never fatal.
struct Notice {
    enum class Kind : uint8_t {
        include_missing,
        include_unreadable,
        include_cycle,
        include_too_deep,
        include_outside_root,
        include_text_dropped, ///< data before the first keyword of an included file
        data_after_enddata,
        version_unknown, ///< taken as the newest by the solver
        version_too_old, ///< 41 to 44: read as far as real readers go
        version_in_include,
        submodel_version, ///< Vnnn on //SUBMODEL, which readers do not apply
        unit_not_understood,
        unknown_parameter,
        bad_parameter,    ///< its value or expression cannot be evaluated; no subject: it has no card, or no
                          ///< name
        keyword_indented, ///< blanks before the slash
        header_id_overflow,
        encrypted, ///< block content cannot be read
        end_missing,
        submodel_not_closed,
        offset_not_understood, ///< on the card of a //SUBMODEL; `detail` says which, and what is read
    };
    Kind kind;
    Span place;
    std::string subject; ///< path, name or text that it is about
    std::string detail;  ///< e.g. the operating system's reason
};

struct ReadOptions {
    unsigned threads = 1;
    std::string include_root;              ///< when not empty, no include may lie outside of it
    std::vector<std::string> include_path; ///< further folders to look for includes in
    uint32_t max_depth = 50;
    uint32_t max_files = 20000; ///< instances, so that doubling includes cannot explode
};

class Deck {
public:
    /// Reads the main file and its includes. An error only when the main file cannot be read or holds no
    /// /BEGIN.
    static Result<Deck> read(const std::string& path, FileReader&, const ReadOptions& = {});

    const std::string& path() const { return path_; }
    std::span<const std::unique_ptr<SourceFile>> files() const { return files_; }
    const SourceFile& file(FileId id) const { return *files_[index(id)]; }
    std::span<const Block> blocks() const { return blocks_; }
    const Scope& scope(ScopeId id) const { return scopes_[index(id)]; }
    const Scope& root() const { return scopes_.front(); }
    std::size_t scope_count() const { return scopes_.size(); }
    const UnitSystem& work_units() const { return work_; }
    std::span<const Notice> notices() const { return notices_; }
    const std::string& run_name() const { return run_name_; }

    std::string_view text(const Span& s) const { return file(s.file).text(s.begin, s.end); }
    SourceFile::Position at(const Span& s) const { return file(s.file).at(s.begin); }

    /// Looked up in the scope, its parents, then among the global ones.
    const Parameter* parameter(ScopeId, std::string_view name) const;
    /// The unit system of a `/UNIT/id`; nullptr when there is none.
    const UnitSystem* unit(int64_t id) const;
    /// Factor from the written number to the deck's work units, for an option of `scope` with this unit id
    /// (0: the submodel's, then the scope's own). Empty when the unit id is unknown.
    std::optional<double> factor(ScopeId, int64_t unit, Dimension) const;

    /// Ids as the solver knows them: written id plus the scope's offset, 0 stays 0.
    static int64_t global_id(int64_t written, int64_t offset) {
        return written == 0 ? 0 : written < 0 ? written - offset : written + offset;
    }

private:
    friend class DeckReader;
    std::string path_;
    std::string run_name_;
    std::vector<std::unique_ptr<SourceFile>> files_;
    std::deque<std::string> strings_; ///< expanded header texts
    std::vector<Block> blocks_;
    std::vector<Scope> scopes_;
    ParameterTable global_parameters_;
    std::map<int64_t, UnitSystem> units_;
    UnitSystem work_;
    std::vector<Notice> notices_;
};

/// Walks the data lines of a block: comment lines and directive lines with their continuations are left out,
/// blank lines are not.
class DataLines {
public:
    DataLines(const Deck&, const Span& text);
    DataLines(const Deck& deck, const Block& block) : DataLines(deck, block.text) {}

    /// The next data line without its line end (CR removed); false at the end.
    bool next(Span& line);
    /// As `next`, leaving out lines of blanks only.
    bool next_filled(Span& line);
    std::string_view text(const Span& line) const { return bytes_.substr(line.begin, line.end - line.begin); }

private:
    std::string_view bytes_;
    FileId file_;
    uint64_t at_, end_;
};

} // namespace drawbead
