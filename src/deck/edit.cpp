#include "deck/edit.h"

#include "base/parallel.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>
#include <tuple>

namespace drawbead {

namespace {

constexpr uint64_t the_end = std::numeric_limits<uint64_t>::max();

/// Insertions stand before a replacement that begins at their place.
auto key(const Edit& e) {
    return std::tuple(e.at.file, e.at.begin, e.at.size() > 0);
}

/// A part of an edited text: bytes of the original, or new ones.
struct Piece {
    bool original = false;
    uint64_t begin = 0, end = 0; ///< of the original, or of `text`
    std::string_view text;

    uint64_t size() const { return end - begin; }
};

/// The text that edits make of an original of unknown length: the last piece goes on to the end.
std::vector<Piece> pieces_of(const EditList& edits) {
    std::vector<Piece> pieces;
    pieces.reserve(2 * edits.size() + 1);
    uint64_t at = 0;
    for (const Edit& e : edits) {
        if (e.at.begin > at) pieces.push_back({true, at, e.at.begin, {}});
        if (!e.text.empty()) pieces.push_back({false, 0, e.text.size(), e.text});
        at = e.at.end;
    }
    pieces.push_back({true, at, the_end, {}});
    return pieces;
}

/// Walks pieces by their place in the edited text.
class Walk {
public:
    explicit Walk(const std::vector<Piece>& pieces) : pieces_(pieces) {}

    /// Moves on to a place of the edited text, handing over what lies between.
    template <class Take>
    void to(uint64_t place, Take&& take) {
        while (at_ < place) {
            const Piece& piece = pieces_[next_];
            const uint64_t count = std::min(piece.size() - used_, place - at_);
            Piece part = piece;
            part.begin += used_;
            part.end = part.begin + count;
            take(part);
            at_ += count;
            used_ += count;
            if (used_ == piece.size()) ++next_, used_ = 0;
        }
    }
    template <class Take>
    void rest(Take&& take) {
        for (; next_ < pieces_.size(); ++next_, used_ = 0) {
            Piece part = pieces_[next_];
            part.begin += used_;
            take(part);
        }
    }

private:
    const std::vector<Piece>& pieces_;
    std::size_t next_ = 0;
    uint64_t used_ = 0, at_ = 0;
};

EditList edits_of(const std::vector<Piece>& pieces, FileId file) {
    EditList edits;
    std::string text;
    uint64_t at = 0;
    for (const Piece& piece : pieces) {
        if (!piece.original) {
            text += piece.text.substr(piece.begin, piece.size());
            continue;
        }
        if (piece.begin != at || !text.empty()) edits.push_back({{file, at, piece.begin}, std::move(text)});
        text.clear();
        at = piece.end;
    }
    return edits;
}

EditList then_in_file(const EditList& first, const EditList& second, FileId file) {
    const std::vector<Piece> between = pieces_of(first);
    std::vector<Piece> result;
    Walk walk(between);
    const auto keep = [&](const Piece& piece) { result.push_back(piece); };
    for (const Edit& e : second) {
        walk.to(e.at.begin, keep);
        if (!e.text.empty()) result.push_back({false, 0, e.text.size(), e.text});
        walk.to(e.at.end, [](const Piece&) {});
    }
    walk.rest(keep);
    return edits_of(result, file);
}

uint64_t line_begin(std::string_view bytes, uint64_t at) {
    if (at == 0) return 0;
    const std::size_t newline = bytes.rfind('\n', at - 1);
    return newline == std::string_view::npos ? 0 : newline + 1;
}

/// Just after the newline of the line that holds `at`, or the end.
uint64_t line_end(std::string_view bytes, uint64_t at) {
    const std::size_t newline = bytes.find('\n', at);
    return newline == std::string_view::npos ? bytes.size() : newline + 1;
}

uint64_t lines_in(std::string_view text) {
    return static_cast<uint64_t>(std::count(text.begin(), text.end(), '\n')) +
           (!text.empty() && text.back() != '\n');
}

/// Whole lines that are replaced by others.
struct LineChange {
    uint64_t begin = 0, end = 0; ///< of the original, at line borders
    std::string text;
};

/// Edits widened to whole lines; those that meet on a line are one.
std::vector<LineChange> line_changes(std::string_view bytes, const EditList& edits) {
    std::vector<LineChange> changes;
    for (std::size_t i = 0; i < edits.size();) {
        LineChange change;
        change.begin = line_begin(bytes, edits[i].at.begin);
        uint64_t at = change.begin;
        bool joined = false; ///< the next edit begins on the last line of this one
        do {
            const Edit& e = edits[i];
            change.text += bytes.substr(at, e.at.begin - at);
            change.text += e.text;
            at = e.at.end;
            const bool at_line_begin = change.text.empty() || change.text.back() == '\n';
            const bool whole = at == 0 || bytes[at - 1] == '\n';
            change.end = at_line_begin && whole ? at : line_end(bytes, at);
            // What is inserted at the end of a last line without line end belongs to that line.
            const bool open = change.end == bytes.size() && change.end > 0 && bytes[change.end - 1] != '\n';
            const uint64_t reach = change.end != at || open ? change.end + open : change.end + 1;
            ++i;
            joined = i < edits.size() && edits[i].at.begin < reach;
        } while (joined);
        change.text += bytes.substr(at, change.end - at);
        if (changes.empty() || changes.back().end != change.begin) {
            changes.push_back(std::move(change));
        } else {
            changes.back().end = change.end;
            changes.back().text += change.text;
        }
    }
    return changes;
}

void write_lines(std::string_view text, char mark, bool last, std::string& out) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = line_end(text, at);
        out += mark;
        out += text.substr(at, end - at);
        at = end;
    }
    if (last && !text.empty() && text.back() != '\n') out += "\n\\ No newline at end of file\n";
}

} // namespace

void sort_edits(EditList& edits) {
    std::stable_sort(edits.begin(), edits.end(),
                     [](const Edit& a, const Edit& b) { return key(a) < key(b); });
}

bool in_order(const EditList& edits) {
    for (std::size_t i = 0; i < edits.size(); ++i) {
        if (edits[i].at.end < edits[i].at.begin) return false;
        if (i == 0) continue;
        const Edit &a = edits[i - 1], &b = edits[i];
        if (key(b) < key(a)) return false;
        if (a.at.file == b.at.file && a.at.end > b.at.begin) return false;
    }
    return true;
}

bool compatible(const EditList& a, const EditList& b) {
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        const Span &p = a[i].at, &q = b[j].at;
        const bool either_inserts = p.size() == 0 || q.size() == 0;
        const auto before = [&](const Span& x, const Span& y) {
            return x.file < y.file ||
                   (x.file == y.file && (either_inserts ? x.end < y.begin : x.end <= y.begin));
        };
        if (before(p, q))
            ++i;
        else if (before(q, p))
            ++j;
        else
            return false;
    }
    return true;
}

EditList of_file(const EditList& edits, FileId file) {
    EditList out;
    for (const Edit& e : edits)
        if (e.at.file == file) out.push_back(e);
    return out;
}

uint64_t edited_size(std::string_view bytes, const EditList& edits) {
    uint64_t size = bytes.size();
    for (const Edit& e : edits)
        size = size - e.at.size() + e.text.size();
    return size;
}

void write_edited(std::string_view bytes, const EditList& edits, char* out, unsigned threads) {
    assert(in_order(edits));
    struct Copy {
        const char* from;
        uint64_t to, size;
    };
    constexpr uint64_t most = uint64_t{4} << 20;
    std::vector<Copy> copies;
    uint64_t at = 0, to = 0;
    const auto put = [&](std::string_view text) {
        for (uint64_t done = 0; done < text.size(); done += most) {
            const uint64_t size = std::min<uint64_t>(most, text.size() - done);
            copies.push_back({text.data() + done, to, size});
            to += size;
        }
    };
    for (const Edit& e : edits) {
        put(bytes.substr(at, e.at.begin - at));
        put(e.text);
        at = e.at.end;
    }
    put(bytes.substr(at));
    // Pieces of about one size, whatever the edits are.
    std::vector<std::size_t> begin{0};
    uint64_t size = 0;
    for (std::size_t i = 0; i < copies.size(); ++i) {
        size += copies[i].size;
        if (size < most && i + 1 != copies.size()) continue;
        begin.push_back(i + 1);
        size = 0;
    }
    parallel_for(threads, begin.size() - 1, [&](std::size_t piece) {
        for (std::size_t i = begin[piece]; i < begin[piece + 1]; ++i)
            std::memcpy(out + copies[i].to, copies[i].from, copies[i].size);
    });
}

std::string edited(std::string_view bytes, const EditList& edits) {
    std::string out(edited_size(bytes, edits), '\0');
    write_edited(bytes, edits, out.data());
    return out;
}

EditList then(const EditList& first, const EditList& second) {
    assert(in_order(first) && in_order(second));
    std::vector<FileId> files;
    for (const EditList* list : {&first, &second})
        for (const Edit& e : *list)
            if (files.empty() || files.back() != e.at.file) files.push_back(e.at.file);
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    EditList out;
    for (const FileId file : files) {
        EditList both = then_in_file(of_file(first, file), of_file(second, file), file);
        std::move(both.begin(), both.end(), std::back_inserter(out));
    }
    return out;
}

EditList minimal(std::string_view bytes, const EditList& edits) {
    EditList out;
    for (const Edit& e : edits) {
        const std::string_view old = bytes.substr(e.at.begin, e.at.size());
        std::size_t front = 0, back = 0;
        const std::size_t most = std::min(old.size(), e.text.size());
        while (front < most && old[front] == e.text[front])
            ++front;
        while (back < most - front && old[old.size() - 1 - back] == e.text[e.text.size() - 1 - back])
            ++back;
        if (front == old.size() && front == e.text.size()) continue;
        out.push_back({{e.at.file, e.at.begin + front, e.at.end - back},
                       e.text.substr(front, e.text.size() - front - back)});
    }
    return out;
}

std::string unified_diff(std::string_view path, std::string_view bytes, const EditList& given) {
    constexpr uint64_t context = 3;
    const EditList edits = minimal(bytes, given);
    const std::vector<LineChange> changes = line_changes(bytes, edits);
    if (changes.empty()) return {};
    // A name with blanks is ended by a tab.
    const std::string end_of_name = path.find(' ') == std::string_view::npos ? "\n" : "\t\n";
    std::string out = "--- a/" + std::string(path) + end_of_name + "+++ b/" + std::string(path) + end_of_name;

    const auto back = [&](uint64_t at, uint64_t lines, uint64_t least) {
        for (; lines > 0 && at > least; --lines)
            at = line_begin(bytes, at - 1);
        return at;
    };
    const auto on = [&](uint64_t at, uint64_t lines) {
        for (; lines > 0 && at < bytes.size(); --lines)
            at = line_end(bytes, at);
        return at;
    };
    uint64_t counted = 0, line = 1; // the line that begins at byte `counted`
    int64_t shift = 0;              // lines added so far
    for (std::size_t i = 0; i < changes.size();) {
        std::size_t last = i;
        while (last + 1 < changes.size() && on(changes[last].end, 2 * context) >= changes[last + 1].begin)
            ++last;
        const uint64_t begin = back(changes[i].begin, context, i == 0 ? 0 : changes[i - 1].end);
        const uint64_t end = on(changes[last].end, context);
        line += lines_in(bytes.substr(counted, begin - counted));
        counted = begin;
        std::string body;
        uint64_t at = begin, added = 0, removed = 0;
        for (std::size_t k = i; k <= last; ++k) {
            const LineChange& c = changes[k];
            write_lines(bytes.substr(at, c.begin - at), ' ', false, body);
            write_lines(bytes.substr(c.begin, c.end - c.begin), '-', c.end == bytes.size(), body);
            write_lines(c.text, '+', c.end == bytes.size(), body);
            added += lines_in(c.text);
            removed += lines_in(bytes.substr(c.begin, c.end - c.begin));
            at = c.end;
        }
        write_lines(bytes.substr(at, end - at), ' ', end == bytes.size(), body);
        const uint64_t old_count = lines_in(bytes.substr(begin, end - begin));
        const uint64_t new_count = old_count + added - removed;
        const auto range = [](uint64_t first, uint64_t count) {
            return std::to_string(count == 0 ? first - 1 : first) +
                   (count == 1 ? "" : "," + std::to_string(count));
        };
        out += "@@ -" + range(line, old_count) + " +" +
               range(static_cast<uint64_t>(static_cast<int64_t>(line) + shift), new_count) + " @@\n" + body;
        shift += static_cast<int64_t>(added) - static_cast<int64_t>(removed);
        i = last + 1;
    }
    return out;
}

} // namespace drawbead
