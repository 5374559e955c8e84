#include "deck/keyword_line.h"

#include "deck/number.h"

#include <algorithm>

namespace drawbead {

namespace {

bool is_digits(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The leading token of a field when it is an id: digits or &name. Text behind it does not count.
std::string_view id_token(std::string_view field) {
    const std::string_view text = trim(field);
    const std::string_view token = text.substr(0, text.find_first_of(" \t"));
    if (is_digits(token)) return token;
    if (token.size() > 1 && token[0] == '&') return token;
    return {};
}

std::string_view line_at(std::string_view bytes, uint64_t offset) {
    const std::size_t end = std::min(bytes.find('\n', offset), bytes.size());
    return bytes.substr(offset, end - offset);
}

bool starts_with_include(std::string_view line) {
    constexpr std::string_view word = "#include";
    if (line.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const char c = line[i];
        if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c) != word[i]) return false;
    }
    return true;
}

/// Takes a continuation mark off the end of a piece of a path.
bool take_continuation(std::string_view& piece) {
    for (const std::string_view mark :
         {std::string_view("&"), std::string_view(" +"), std::string_view("...")}) {
        if (piece.size() <= mark.size() || piece.substr(piece.size() - mark.size()) != mark) continue;
        piece.remove_suffix(mark.size());
        return true;
    }
    return false;
}

} // namespace

uint64_t byte_order_mark(std::string_view file) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return file.substr(0, mark.size()) == mark ? mark.size() : 0;
}

KeywordLine cut_keyword_line(std::string_view line) {
    KeywordLine result;
    std::size_t at = 1;
    // "//SUBMODEL" keeps one slash in its keyword.
    const std::size_t keyword_begin = at;
    if (at < line.size() && line[at] == '/') ++at;
    std::size_t keyword_end = line.size();
    while (at <= line.size()) {
        const std::size_t slash = std::min(line.find('/', at), line.size());
        const std::string_view field = line.substr(at, slash - at);
        if (result.id.empty()) {
            if (const std::string_view id = id_token(field); !id.empty()) {
                result.id = id;
                keyword_end = at - 1;
            } else {
                // "NODE      12": an id that lacks its slash.
                const std::string_view text = trim(field);
                const std::size_t blank = text.find_first_of(" \t");
                if (blank != std::string_view::npos && is_digits(trim(text.substr(blank)))) {
                    result.id = trim(text.substr(blank));
                    keyword_end = static_cast<std::size_t>(text.data() - line.data()) + blank;
                }
            }
        } else if (result.unit.empty() && !id_token(field).empty()) {
            // Readers lose a unit id that is padded with blanks.
            if (!field.empty() && field[0] != ' ' && field[0] != '\t') result.unit = id_token(field);
        } else if (!trim(field).empty()) {
            result.rest = trim(line.substr(at));
            break;
        }
        at = slash + 1;
    }
    keyword_end = std::max(keyword_end, keyword_begin);
    std::string_view keyword = trim(line.substr(keyword_begin, keyword_end - keyword_begin));
    while (!keyword.empty() && (keyword.back() == '/' || keyword.back() == ' '))
        keyword.remove_suffix(1);
    // Text after a keyword without an id ("/END of deck") is not part of it; a padded last field is
    // ("/UNIT/LENGTH/     mm").
    if (result.id.empty()) {
        std::size_t from = 0;
        while (from < keyword.size() && keyword[from] != ' ' && keyword[from] != '\t')
            ++from;
        if (from > 0 && keyword[from - 1] == '/')
            from = std::min(keyword.find_first_not_of(" \t", from), keyword.size());
        keyword = keyword.substr(0, keyword.find_first_of(" \t", from));
    }
    result.keyword = keyword;
    return result;
}

std::optional<IncludeDirective> include_at(std::string_view bytes, uint64_t offset) {
    const std::string_view first = line_at(bytes, offset);
    if (!starts_with_include(first)) return std::nullopt;
    IncludeDirective directive;
    uint64_t at = offset;
    std::string_view line = first;
    directive.run_on =
        first.size() > 8 && std::string_view(" \t\r'\"").find(first[8]) == std::string_view::npos;
    std::string_view piece = trim(first.substr(8));
    for (;;) {
        const bool more = take_continuation(piece);
        directive.path += trim(piece);
        at = std::min<uint64_t>(at + line.size() + 1, bytes.size());
        if (at == bytes.size()) break;
        line = line_at(bytes, at);
        const bool plus = !line.empty() && line[0] == '+';
        if (!more && !plus) break;
        if (!line.empty() && (line[0] == '/' || line[0] == '#')) break;
        piece = trim(plus ? line.substr(1) : line);
    }
    directive.next = at;
    std::erase_if(directive.path, [](char c) { return c == '\'' || c == '"'; });
    return directive;
}

} // namespace drawbead
