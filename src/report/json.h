#pragma once
// JSON as a stream: nothing is kept but the nesting.
#include "report/output.h"

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// Text as a JSON string with its quotes. Bytes that are not UTF-8 become U+FFFD.
std::string json_string(std::string_view text);
/// The shortest text that reads back as the same number; "null" for NaN and infinities, which JSON lacks.
std::string json_number(double value);

/// Writes one document with two blanks per level; a Layout::line object or array stands on one line with all
/// it holds. Keys and values must come in an order that makes sense: it is asserted, not reported.
class JsonWriter {
public:
    enum class Layout : uint8_t { block, line };

    explicit JsonWriter(OutputSink& out) : out_(out) {}

    void begin_object(Layout layout = Layout::block) { begin('{', layout); }
    void begin_array(Layout layout = Layout::block) { begin('[', layout); }
    void end();
    void key(std::string_view name);

    void value(std::string_view text) { raw(noted(text)); }
    void value(const char* text) { value(std::string_view(text)); }
    void value(bool truth) { raw(truth ? "true" : "false"); }
    void value(double number) { raw(json_number(number)); }
    template <std::integral T>
    void value(T number) {
        raw(std::to_string(number));
    }
    void null() { raw("null"); }

    /// From now on every text in whose JSON U+FFFD stands is appended to `list` as it is, so that its bytes
    /// are not lost; nullptr: no longer.
    void note_damaged(std::vector<std::string>* list) { damaged_ = list; }

    template <class T>
    void member(std::string_view name, const T& v) {
        key(name);
        value(v);
    }
    /// Of numbers or strings, on one line.
    template <class List>
    void member_list(std::string_view name, const List& list) {
        key(name);
        begin_array(Layout::line);
        for (const auto& v : list)
            value(v);
        end();
    }

private:
    struct Level {
        char close;
        bool one_line;
        bool empty = true;
    };
    void begin(char open, Layout layout);
    void raw(std::string_view text);
    std::string noted(std::string_view text);
    void separate();
    void new_line();

    OutputSink& out_;
    std::vector<Level> levels_;
    std::vector<std::string>* damaged_ = nullptr;
    bool after_key_ = false;
};

} // namespace drawbead
