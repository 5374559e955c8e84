#include "rules/syn/columns.h"

#include "deck/card.h"
#include "deck/number.h"

#include <algorithm>
#include <array>

namespace drawbead {

namespace {

struct Token {
    uint32_t begin, end;
};

/// The first tokens of a line, enough for all its cells; lists can have a million lines, so nothing is
/// allocated.
class Tokens {
public:
    explicit Tokens(std::string_view line) {
        for (std::size_t at = 0; at < line.size() && count_ < tokens_.size();) {
            while (at < line.size() && is_blank(line[at]))
                ++at;
            const std::size_t begin = at;
            while (at < line.size() && !is_blank(line[at]))
                ++at;
            if (at > begin) tokens_[count_++] = {static_cast<uint32_t>(begin), static_cast<uint32_t>(at)};
        }
    }
    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    const Token& operator[](std::size_t i) const { return tokens_[i]; }
    const Token* begin() const { return tokens_.data(); }
    const Token* end() const { return tokens_.data() + count_; }
    const Token& back() const { return tokens_[count_ - 1]; }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

    std::array<Token, 64> tokens_;
    std::size_t count_ = 0;
};

std::string_view text_of(std::string_view line, const Token& token) {
    return line.substr(token.begin, token.end - token.begin);
}

bool is_number(std::string_view text) {
    return parse_real(text).state == NumberState::ok;
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Index of the cell that holds a byte; ends.size() behind the last one.
std::size_t cell_of(std::span<const uint32_t> ends, uint32_t at) {
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), at) - ends.begin());
}

uint32_t first_of(std::span<const uint32_t> ends, std::size_t cell) {
    return cell == 0 ? 0 : ends[cell - 1];
}

/// "80,5 100,0": fixed columns with commas for points. A free-format line has no blanks around its numbers,
/// or blanks after its commas.
bool has_decimal_commas(std::string_view line, const Tokens& tokens) {
    if (line.find('.') != std::string_view::npos) return false;
    std::size_t commas = 0;
    for (const Token& token : tokens) {
        const std::string_view text = text_of(line, token);
        const auto count = std::count(text.begin(), text.end(), ',');
        if (count > 1) return false;
        if (count == 0) continue;
        const std::size_t at = text.find(',');
        if (at == 0 || at + 1 == text.size() || !is_digit(text[at - 1]) || !is_digit(text[at + 1]))
            return false;
        ++commas;
    }
    return commas != 0 && tokens.size() > 1;
}

/// Whether a line shows its numbers in other cells than it has them in, where tabs stop at every eighth
/// column.
bool misleads(std::string_view line, const Tokens& tokens, std::span<const uint32_t> ends) {
    uint32_t shown = 0, at = 0;
    for (const Token& token : tokens) {
        for (; at < token.begin; ++at)
            shown = line[at] == '\t' ? (shown / 8 + 1) * 8 : shown + 1;
        if (cell_of(ends, token.begin) != cell_of(ends, shown)) return true;
        shown += token.end - token.begin;
        at = token.end;
    }
    return false;
}

/// Two numbers that touch at `border`: the cell on either side is full, or the right one begins with a sign.
bool touch_rightly(std::string_view line, const Token& token, uint32_t left_begin, uint32_t border,
                   uint32_t right_end) {
    if (token.begin <= left_begin || token.end >= right_end) return true;
    const std::string_view right = text_of(line, {border, token.end});
    const std::string_view left = text_of(line, {token.begin, border});
    return (right[0] == '-' || right[0] == '+') && is_number(left) && is_number(right) &&
           std::string_view("eEdD").find(left.back()) == std::string_view::npos &&
           left.find('.') != std::string_view::npos;
}

} // namespace

std::optional<ColumnFault> column_fault(std::string_view line, std::span<const uint32_t> ends,
                                        uint32_t width) {
    using Fault = ColumnFault::Kind;
    const Tokens tokens(line);
    if (tokens.empty()) return std::nullopt;
    const auto fault = [&](Fault kind, const Token& token, std::size_t cell) {
        return ColumnFault{kind, token.begin, token.end, first_of(ends, std::min(cell, ends.size())) + 1};
    };
    if (line.find(',') != std::string_view::npos) {
        if (has_decimal_commas(line, tokens))
            for (const Token& token : tokens)
                if (text_of(line, token).find(',') != std::string_view::npos)
                    return fault(Fault::decimal_comma, token, cell_of(ends, token.begin));
        const std::vector<std::string_view> fields = free_fields(line);
        for (std::size_t i = ends.size(); i < fields.size(); ++i)
            if (is_number(fields[i])) {
                const auto begin = static_cast<uint32_t>(fields[i].data() - line.data());
                return fault(Fault::too_many, {begin, begin + static_cast<uint32_t>(fields[i].size())},
                             ends.size());
            }
        return std::nullopt;
    }
    const std::size_t tab = line.find('\t');
    if (tab != std::string_view::npos && tab < tokens.back().begin && misleads(line, tokens, ends)) {
        const auto at = static_cast<uint32_t>(tab);
        return fault(Fault::tab, {at, at + 1}, cell_of(ends, at));
    }
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        const std::string_view text = text_of(line, token);
        if (text[0] == '#' || text[0] == '$') break; // a remark behind the values
        if (token.begin >= width) {
            if (is_number(text)) return fault(Fault::over_width, token, ends.size());
            break;
        }
        const std::size_t cell = cell_of(ends, token.begin), last = cell_of(ends, token.end - 1);
        if (cell >= ends.size()) break;
        if (i > 0 && cell_of(ends, tokens[i - 1].begin) == cell &&
            cell_of(ends, tokens[i - 1].end - 1) == cell && is_number(text))
            return fault(Fault::several, token, cell);
        if (last == cell + 1) {
            const uint32_t right_end = last < ends.size() ? ends[last] : width;
            if (text[0] != '&' && is_digit(text.back() == '.' ? '0' : text.back()) &&
                !touch_rightly(line, token, first_of(ends, cell), ends[cell], right_end))
                return fault(Fault::straddle, token, cell);
        }
    }
    return std::nullopt;
}

namespace {

bool is_value(std::string_view text) {
    if (text.substr(0, 1) == "&" || text.substr(0, 2) == "-&") return true;
    return is_number(text);
}

bool is_id(std::string_view text) {
    if (text.substr(0, 1) == "&" || text.substr(0, 2) == "-&") return true;
    if (text[0] == '-') text.remove_prefix(1);
    return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

void put_right(std::string& line, uint32_t end, std::string_view text) {
    if (line.size() < end) line.resize(end, ' ');
    line.replace(end - text.size(), text.size(), text);
}

/// Tabs as an editor shows them.
std::string without_tabs(std::string_view line) {
    std::string text;
    for (const char c : line)
        if (c == '\t')
            text.append(8 - text.size() % 8, ' ');
        else
            text += c;
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

/// The cell of each token of a card: by their number when that is the number of fields, else the one that
/// holds most of the token. Empty when two meet or one is torn.
std::vector<std::size_t> cells_of_tokens(std::string_view line, const Tokens& tokens,
                                         std::span<const uint32_t> ends, std::span<const uint32_t> read) {
    std::vector<std::size_t> cells;
    if (tokens.size() == read.size()) {
        cells.assign(read.begin(), read.end());
        return cells;
    }
    for (const Token& token : tokens) {
        const std::size_t first = cell_of(ends, token.begin), last = cell_of(ends, token.end - 1);
        if (last >= ends.size() || last > first + 1) return {};
        std::size_t cell = first;
        if (last != first) {
            const uint32_t left = ends[first] - token.begin, right = token.end - ends[first];
            if (left == right) return {};
            cell = left > right ? first : last;
        }
        const bool is_read = std::find(read.begin(), read.end(), cell) != read.end();
        if (!is_read && parse_real(text_of(line, token)).value != 0) return {};
        if (!cells.empty() && cells.back() >= cell) return {};
        cells.push_back(cell);
    }
    return cells;
}

} // namespace

std::vector<std::string> fitted_line(std::string_view line, std::span<const uint32_t> ends, uint32_t width,
                                     std::span<const uint32_t> read) {
    const auto fault = column_fault(line, ends, width);
    if (!fault) return {std::string(line)};
    if (fault->kind == ColumnFault::Kind::decimal_comma || fault->kind == ColumnFault::Kind::tab) {
        std::string text = without_tabs(line);
        if (fault->kind == ColumnFault::Kind::decimal_comma) {
            text = line;
            std::replace(text.begin(), text.end(), ',', '.');
        }
        return column_fault(text, ends, width) ? std::vector<std::string>{} : std::vector{text};
    }
    const Tokens tokens(line);
    const bool free = fault->kind == ColumnFault::Kind::too_many;
    if (tokens.size() >= 64 || (free && !read.empty())) return {};
    std::vector<std::string> lines(1);
    if (read.empty()) {
        std::vector<std::string_view> ids;
        if (free) {
            ids = free_fields(line);
            std::erase_if(ids, [](std::string_view id) { return id.empty(); });
        } else {
            for (const Token& token : tokens)
                ids.push_back(text_of(line, token));
        }
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const std::size_t cell = i % ends.size();
            if (!is_id(ids[i]) || ids[i].size() > ends[cell] - first_of(ends, cell)) return {};
            if (i > 0 && cell == 0) lines.emplace_back();
            put_right(lines.back(), ends[cell], ids[i]);
        }
    } else {
        const std::vector<std::size_t> cells = cells_of_tokens(line, tokens, ends, read);
        if (cells.size() != tokens.size()) return {};
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            const std::string_view text = text_of(line, tokens[i]);
            if (!is_value(text) || text.size() > ends[cells[i]] - first_of(ends, cells[i])) return {};
            put_right(lines.back(), ends[cells[i]], text);
        }
    }
    for (const std::string& one : lines)
        if (column_fault(one, ends, width)) return {};
    return lines;
}

} // namespace drawbead
