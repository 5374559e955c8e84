#include "report/json.h"

#include <cassert>
#include <charconv>
#include <cmath>

namespace drawbead {

namespace {

/// Length of the UTF-8 sequence that starts here, 0 when there is none: no overlong forms, no surrogates,
/// nothing above U+10FFFF.
std::size_t sequence_length(std::string_view text) {
    const auto at = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto continues = [&](std::size_t i) { return (at(i) & 0xc0u) == 0x80u; };
    const unsigned lead = at(0), second = at(1);
    if (lead < 0x80) return 1;
    if (lead >= 0xc2 && lead <= 0xdf) return continues(1) ? 2 : 0;
    if (lead >= 0xe0 && lead <= 0xef) {
        if (lead == 0xe0 && second < 0xa0) return 0;
        if (lead == 0xed && second > 0x9f) return 0;
        return continues(1) && continues(2) ? 3 : 0;
    }
    if (lead >= 0xf0 && lead <= 0xf4) {
        if (lead == 0xf0 && second < 0x90) return 0;
        if (lead == 0xf4 && second > 0x8f) return 0;
        return continues(1) && continues(2) && continues(3) ? 4 : 0;
    }
    return 0;
}

} // namespace

std::string json_string(std::string_view text) {
    std::string out = "\"";
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        const std::size_t length = sequence_length(text.substr(i));
        if (length == 0) {
            out += "\xef\xbf\xbd";
            ++i;
            continue;
        }
        switch (c) {
        case '"':
            out += "\\\"";
            break;
        case '\\':
            out += "\\\\";
            break;
        case '\n':
            out += "\\n";
            break;
        case '\r':
            out += "\\r";
            break;
        case '\t':
            out += "\\t";
            break;
        default:
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
                out += "\\u00";
                out += "0123456789abcdef"[static_cast<unsigned char>(c) >> 4];
                out += "0123456789abcdef"[static_cast<unsigned char>(c) & 15];
            } else {
                out += text.substr(i, length);
            }
        }
        i += length;
    }
    return out += '"';
}

std::string json_number(double value) {
    if (!std::isfinite(value)) return "null";
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    return {digits, end.ptr};
}

void JsonWriter::begin(char open, Layout layout) {
    separate();
    const bool one_line = layout == Layout::line || (!levels_.empty() && levels_.back().one_line);
    out_.write(open);
    levels_.push_back({open == '{' ? '}' : ']', one_line});
}

void JsonWriter::end() {
    assert(!levels_.empty() && !after_key_);
    const Level level = levels_.back();
    levels_.pop_back();
    if (!level.empty && !level.one_line) new_line();
    out_.write(level.close);
    if (levels_.empty()) out_.write('\n');
}

void JsonWriter::key(std::string_view name) {
    assert(!levels_.empty() && levels_.back().close == '}' && !after_key_);
    separate();
    out_.write(json_string(name));
    out_.write(": ");
    after_key_ = true;
}

void JsonWriter::raw(std::string_view text) {
    separate();
    out_.write(text);
}

/// What stands between this value or key and the one before.
void JsonWriter::separate() {
    if (after_key_) {
        after_key_ = false;
        return;
    }
    if (levels_.empty()) return;
    Level& level = levels_.back();
    if (!level.empty) out_.write(level.one_line ? ", " : ",");
    level.empty = false;
    if (!level.one_line) new_line();
}

void JsonWriter::new_line() {
    out_.write('\n');
    for (std::size_t i = 0; i < levels_.size(); ++i)
        out_.write("  ");
}

} // namespace drawbead
