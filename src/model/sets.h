#pragma once
// /SET/GENERAL and /SET/COLLECT, cut into their clauses.
#include "model/entities.h"
#include "model/issue_log.h"
#include "model/members.h"
#include "model/option_reader.h"

#include <array>
#include <string>
#include <vector>

namespace drawbead {

/// One line of /SURF/SEG or of a SEG clause: global node ids (cut to 32 bits: no greater id exists), n4 = n3
/// when blank.
struct ListedSegment {
    std::array<int32_t, 4> node{};
    Span line;
};

struct SetClause {
    std::string key; ///< "PART", "NODENS", "SEG" … without its suffixes
    Span place;      ///< of the key
    bool supported = true;
    bool remove = false, intersect = false, reversed = false, all_faces = false;
    std::vector<Member> members;  ///< empty for SEG and NODENS
    std::vector<WrittenId> nodes; ///< of a NODENS clause, as written; empty when it is not supported
    ScopeId scope{};
    std::vector<ListedSegment> segments;
};

/// The clauses of a set, those of all /SET/COLLECT blocks of its id in deck order.
std::vector<SetClause> read_set(const Deck&, const OptionIndex&, BlockIndex, IssueLog&);

/// Where a segment stands on its line: from the first column on, as in /SURF/SEG, or behind the ten columns
/// of a clause's key.
enum class SegmentLine : uint8_t { plain, indented };

/// The nodes of one segment line: false when it names fewer than three.
bool read_segment(const Deck&, ScopeId, const Span& line, SegmentLine, IssueLog&, ListedSegment&);

} // namespace drawbead
