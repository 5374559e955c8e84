#include "report/json.h"

#include "report/utf8.h"

#include <cassert>
#include <charconv>
#include <cmath>

namespace drawbead {

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

std::string JsonWriter::noted(std::string_view text) {
    std::string quoted = json_string(text);
    if (damaged_ && quoted.find("\xef\xbf\xbd") != std::string::npos) damaged_->emplace_back(text);
    return quoted;
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
