#include "rules/suppressions.h"

#include "rules/check.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr std::string_view tool = "drawbead:";

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return out;
}

/// Whether the word names rules of the catalogue; codes and families become capitals.
bool is_known(std::string& word) {
    for (const std::string& one : {word, upper(word)})
        if (Selection known{{one}, {}}; !known.unknown()) {
            word = one;
            return true;
        }
    return false;
}

/// Reads a comment from left to right.
class CommentReader {
public:
    CommentReader(const Deck& deck, const Span& comment) : text_(deck.text(comment)), comment_(comment) {}

    /// Empty when the comment is none of ours: people write "# drawbead: left flange", too.
    std::optional<Suppression> read() {
        skip(1);
        skip_blanks();
        if (text_.substr(at_, tool.size()) != tool) return std::nullopt;
        skip(tool.size());
        skip_blanks();
        const std::size_t begin = at_;
        while (at_ < text_.size() && (is_letter(text_[at_]) || text_[at_] == '-'))
            ++at_;
        const std::string_view word = text_.substr(begin, at_ - begin);
        const bool bracket = at_ < text_.size() && text_[at_] == '[';
        if (!bracket && word != "ignore" && word != "ignore-file") return std::nullopt;
        Suppression out;
        out.comment = comment_;
        out.whole_file = word == "ignore-file";
        if (word != "ignore" && word != "ignore-file") {
            fail(out, begin, at_, "there is no " + quoted(word) + " for drawbead",
                 "write ignore[CODE] or ignore-file[CODE], and why");
            return out;
        }
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] != '[') {
            fail(out, begin, begin + word.size(), "it names no rule",
                 "write " + std::string(word) + "[CODE] and why");
            return out;
        }
        read_codes(out);
        return out;
    }

private:
    void skip(std::size_t count) { at_ = std::min(at_ + count, text_.size()); }
    void skip_blanks() {
        while (at_ < text_.size() && is_blank(text_[at_]))
            ++at_;
    }
    Span span(std::size_t begin, std::size_t end) const {
        return {comment_.file, comment_.begin + begin, comment_.begin + end};
    }
    void fail(Suppression& out, std::size_t begin, std::size_t end, std::string trouble, std::string help) {
        if (!out.trouble.empty()) return;
        out.trouble = std::move(trouble);
        out.help = std::move(help);
        out.trouble_at = span(begin, end);
    }

    void read_codes(Suppression& out) {
        const std::size_t open = at_, close = text_.find(']', open);
        if (close == std::string_view::npos)
            return fail(out, open, text_.size(), "the bracket is not closed", "write ] after the last code");
        for (std::size_t begin = open + 1; begin <= close;) {
            const std::size_t end = std::min(text_.find(',', begin), close);
            std::size_t first = begin, last = end;
            while (first < last && is_blank(text_[first]))
                ++first;
            while (last > first && is_blank(text_[last - 1]))
                --last;
            begin = end + 1;
            SuppressedCode code{std::string(text_.substr(first, last - first)), span(first, last)};
            if (code.word.empty()) {
                if (end == close && !out.codes.empty()) break; // a comma at the end
                fail(out, open, close + 1, "it names no rule", "write the code of a rule or of a family");
                continue;
            }
            code.known = is_known(code.word);
            if (!code.known)
                fail(out, first, last, "there is no rule or family " + quoted(code.word),
                     "'drawbead rules' lists all");
            out.codes.push_back(std::move(code));
        }
        const std::string_view rest = text_.substr(close + 1);
        out.has_reason = std::any_of(rest.begin(), rest.end(), [](char c) {
            return is_letter(c) || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
        });
    }

    std::string_view text_;
    Span comment_;
    std::size_t at_ = 0;
};

bool is_filled(std::string_view line) {
    return std::any_of(line.begin(), line.end(), [](char c) { return !is_blank(c); });
}

/// From the end of a comment to the end of the first line below that is neither blank nor a comment. A
/// directive such as #include is no comment.
Span text_below(const SourceFile& file, const Span& comment) {
    uint64_t begin = file.next_line(comment.begin);
    const std::vector<uint64_t>& marks = file.marks();
    for (uint64_t line = begin; line < file.bytes().size(); line = file.next_line(line)) {
        const std::string_view text = file.line_at(line);
        const bool mark = std::binary_search(marks.begin(), marks.end(), line);
        const bool comment_line = !text.empty() && (text[0] == '#' || text[0] == '$');
        if ((comment_line && !mark) || !is_filled(text)) continue;
        return {comment.file, begin, line + text.size() + 1}; // findings may stand at the end of a line
    }
    return {comment.file, begin, file.bytes().size()};
}

bool holds(const Span& outer, const Span& inner) {
    return outer.file == inner.file && outer.begin <= inner.begin && inner.begin < outer.end;
}

/// What a suppression speaks of, from the text below it.
void find_subject(const Deck& deck, const Model& model, Suppression& s) {
    const SourceFile& file = deck.file(s.comment.file);
    s.subject = s.whole_file ? Span{s.comment.file, 0, file.bytes().size() + 1} : text_below(file, s.comment);
    const Span found = s.subject;
    const auto defines = [&](const Block& block) { return holds(found, block.header); };
    for (const Block& block : deck.blocks())
        if (!s.whole_file && defines(block)) s.subject.end = std::max(s.subject.end, block.text.end);
    for (const Drawbead& bead : model.drawbeads())
        if (defines(deck.blocks()[bead.block])) s.interfaces.insert(bead.id);
    for (const Surface& surface : model.surfaces())
        if (defines(deck.blocks()[surface.block])) s.surfaces.insert(surface.id);
}

} // namespace

Suppressions read_suppressions(const Deck& deck, const Model& model) {
    Suppressions out;
    for (std::size_t i = 0; i < deck.files().size(); ++i) {
        const SourceFile& file = *deck.files()[i];
        for (const uint64_t begin : file.remarks()) {
            const Span comment{FileId{static_cast<uint32_t>(i)}, begin, begin + file.line_at(begin).size()};
            std::optional<Suppression> one = CommentReader(deck, comment).read();
            if (!one) continue;
            if (one->trouble.empty()) find_subject(deck, model, *one);
            out.all.push_back(std::move(*one));
        }
    }
    return out;
}

bool is_suppressed(Suppressions& suppressions, const Rule& rule, const Draft& draft) {
    bool suppressed = false;
    for (Suppression& s : suppressions.all) {
        if (!s.trouble.empty()) continue;
        const bool meant = holds(s.subject, draft.primary) ||
                           (draft.interface_id && s.interfaces.count(*draft.interface_id) != 0) ||
                           (draft.surface_id && s.surfaces.count(*draft.surface_id) != 0);
        if (!meant) continue;
        for (SuppressedCode& code : s.codes)
            if (Selection{{code.word}, {}}(rule.info)) suppressed = code.used = true;
    }
    return suppressed;
}

void judge_suppressions(Suppressions& suppressions, std::span<const Rule* const> run) {
    if (suppressions.all.empty()) return;
    const auto was_run = [&](const Rule& rule) {
        return std::any_of(run.begin(), run.end(),
                           [&](const Rule* r) { return r->info.code == rule.info.code; });
    };
    for (Suppression& s : suppressions.all)
        for (SuppressedCode& code : s.codes) {
            const Selection named{{code.word}, {}};
            for (const Rule& rule : registry())
                if (named(rule.info) && !was_run(rule)) code.judged = false;
        }
}

} // namespace drawbead
