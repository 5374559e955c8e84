#pragma once
// Changes of a deck's text as replacements of byte ranges: every byte outside of them stays.
#include "deck/place.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// Replaces the bytes of `at` by `text`. An empty range inserts before its place, an empty text deletes.
struct Edit {
    Span at;
    std::string text;
    friend bool operator==(const Edit&, const Edit&) = default;
};
/// Edits of one or more files. In order: ascending by file and place, no two ranges overlapping. Insertions
/// at one place stand in the order in which they appear in the text, before a replacement that begins there.
using EditList = std::vector<Edit>;

/// Sorts by file and place; insertions at one place keep their order.
void sort_edits(EditList&);
/// Whether the list is in order as above.
bool in_order(const EditList&);
/// Whether two lists in order can be made together: no byte is replaced by both, and neither inserts inside
/// or at the borders of what the other one replaces. Insertions of both at the same place do not go together.
bool compatible(const EditList&, const EditList&);

/// The edits of one file.
EditList of_file(const EditList&, FileId);

/// `bytes` with the edits of one file made (in order; their FileId is not looked at).
std::string edited(std::string_view bytes, const EditList& edits);
/// Length of that.
uint64_t edited_size(std::string_view bytes, const EditList& edits);
/// The same into memory of edited_size() bytes, on several threads.
void write_edited(std::string_view bytes, const EditList& edits, char* out, unsigned threads = 1);

/// One list for two rounds: `second` refers to the text that `first` made, the result to the original text
/// of `first`. Both in order, files as in `first`.
EditList then(const EditList& first, const EditList& second);

/// Edits of one file without what they leave as it is: common bytes at their ends, and edits that change
/// nothing.
EditList minimal(std::string_view bytes, const EditList& edits);

/// The edits of one file as a unified diff with three lines of context, for `patch -p1` and `git apply`.
/// `path` is written behind a/ and b/. Empty when nothing changes. CRLF and a missing last newline are kept.
std::string unified_diff(std::string_view path, std::string_view bytes, const EditList& edits);

} // namespace drawbead
