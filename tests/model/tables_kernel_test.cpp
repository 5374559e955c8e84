#include "deck/number.h"
#include "model/line_kernels.h"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

using namespace drawbead;

namespace {

std::vector<Kernel> kernels() {
    std::vector<Kernel> all{Kernel::portable};
    if (runs_here(Kernel::avx2)) all.push_back(Kernel::avx2);
    return all;
}

/// Cells as decks, other programs and accidents write them.
class CellMaker {
public:
    explicit CellMaker(uint32_t seed) : random_(seed) {}

    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    bool often() { return below(64) != 0; }

    std::string digits(uint32_t count) {
        std::string text;
        for (uint32_t i = 0; i < count; ++i)
            text.push_back(static_cast<char>('0' + below(10)));
        return text;
    }
    std::string real_text() {
        if (!often()) return odd_text();
        std::string text = below(2) ? "-" : below(60) ? "" : "+";
        text += digits(below(30) ? 1 + below(8) : 0);
        if (below(8)) text += "." + digits(below(13));
        if (below(3) == 0) {
            text += "EEEEeEdD"[below(8)];
            if (below(4)) text += "+-"[below(2)];
            text += digits(1 + below(3));
        }
        return text;
    }
    /// Three cells as one fixed format writes them, now and then with one character off.
    std::string fixed_cells() {
        static const std::array<const char*, 6> formats{"%20.14E", "%20.13E", "%20.12e",
                                                        "%20.8f",  "%20.14f", "%20.0f"};
        const char* const format = formats[below(formats.size())];
        std::string cells;
        for (int k = 0; k < 3; ++k) {
            const double size = std::pow(10.0, static_cast<double>(below(below(4) ? 12 : 60)) - 5);
            const double value = (below(3) ? 1 : -1) * size * (below(1000000) + 0.5) / 1e6;
            std::array<char, 100> text;
            std::snprintf(text.data(), text.size(), format, value);
            cells += std::string(text.data()).substr(0, 20);
        }
        if (below(10) == 0) cells[below(60)] = " .-+E0"[below(6)];
        return cells;
    }
    std::string integer_text() {
        return often() || often() ? digits(1 + below(below(8) ? 9 : 11)) : odd_text();
    }
    /// Text in a cell of `width` columns, at any place in it.
    std::string cell(std::string text, uint32_t width) {
        if (text.size() > width) text.resize(width);
        const auto room = static_cast<uint32_t>(width - text.size());
        const uint32_t lead = below(3) ? room : below(room + 1);
        return std::string(lead, ' ') + text + std::string(room - lead, ' ');
    }
    std::string line_end() {
        switch (below(12)) {
        case 0:
            return "   \n";
        case 1:
            return "\r\n";
        case 2:
            return " \t\r\n";
        default:
            return "\n";
        }
    }
    /// What may stand behind the last cell.
    std::string rest() { return below(12) ? "" : below(2) ? "  x" : "                  0.75   "; }

private:
    std::string odd_text() {
        static const std::array<const char*, 22> texts{
            "",      "1.5-3",  "1 2",  "\t3",  "&length",  "-&length", "nan", "inf",
            "1e400", "1e-400", "1,2",  "0x10", "1.0E",     "--1",      "-",   ".",
            "1.2.3", "abc",    "1.5-", "-0",   "-0.0E-30", "4.9e-324"};
        return texts[below(texts.size())];
    }
    std::mt19937_64 random_;
};

uint64_t bits(double value) {
    return std::bit_cast<uint64_t>(value);
}

struct Line {
    std::size_t begin, end;
};
std::vector<Line> lines_of(const std::string& text) {
    std::vector<Line> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back({at, end});
        at = end + 1;
    }
    return lines;
}

/// A text of node lines; damaged ones among them.
std::string node_lines(uint32_t seed, uint32_t count) {
    CellMaker make(seed);
    std::string text;
    for (uint32_t i = 0; i < count; ++i) {
        std::string line = make.cell(make.integer_text(), 10);
        if (make.below(2))
            line += make.fixed_cells();
        else
            for (int k = 0; k < 3; ++k)
                line += make.cell(make.real_text(), 20);
        if (make.below(20) == 0) line.resize(make.below(71));
        if (make.below(40) == 0) line[make.below(static_cast<uint32_t>(line.size()) + 1)] = '\0';
        text += line + make.rest() + make.line_end();
    }
    if (make.below(2)) text.pop_back();
    return text;
}

/// Which lines a kernel takes, and their values, in the order of the text.
struct TakenNodes {
    std::vector<std::size_t> line;
    std::vector<uint32_t> id;
    std::vector<Vec3> x;
};
TakenNodes take_nodes(Kernel kernel, CellWidths widths, const std::string& text, std::size_t begin) {
    const std::vector<Line> lines = lines_of(text);
    TakenNodes taken;
    taken.id.resize(lines.size());
    taken.x.resize(lines.size());
    NodeRows rows{taken.id.data(), taken.x.data(), lines.size(), 0, 0, 1};
    LineRange range{text.data() + begin, text.data() + text.size(), text};
    std::size_t line = 0;
    while (lines[line].begin < begin)
        ++line;
    while (range.at < range.end) {
        const std::size_t before = rows.count;
        read_node_lines(kernel, widths, range, rows);
        for (std::size_t i = before; i < rows.count; ++i)
            taken.line.push_back(line++);
        if (range.at == range.end) break;
        REQUIRE(range.at == text.data() + lines[line].begin);
        ++line;
        range.at = line < lines.size() ? text.data() + lines[line].begin : range.end;
    }
    taken.id.resize(rows.count);
    taken.x.resize(rows.count);
    return taken;
}

} // namespace

TEST_CASE("node kernels agree with the exact reader to the last bit") {
    for (const Kernel kernel : kernels()) {
        uint64_t taken_lines = 0, all_lines = 0;
        for (uint32_t seed = 1; seed <= 40; ++seed) {
            const std::string text = node_lines(seed, 1500);
            const std::vector<Line> lines = lines_of(text);
            const TakenNodes taken = take_nodes(kernel, {}, text, 0);
            all_lines += lines.size();
            taken_lines += taken.line.size();
            uint64_t wrong = 0;
            std::string first_wrong;
            for (std::size_t i = 0; i < taken.line.size(); ++i) {
                const Line& at = lines[taken.line[i]];
                const std::string_view line = std::string_view(text).substr(at.begin, at.end - at.begin);
                const IntegerCell id = parse_integer(columns(line, 0, 10));
                const std::array<double, 3> x{taken.x[i].x, taken.x[i].y, taken.x[i].z};
                bool same = id.state == NumberState::ok && id.value == taken.id[i] &&
                            line.find_first_of(",&") == std::string_view::npos &&
                            is_blank(columns(line, 70, line.size()));
                for (std::size_t k = 0; k < 3; ++k) {
                    const RealCell cell = parse_real_slow(columns(line, 10 + 20 * k, 20));
                    same = same && (cell.state == NumberState::ok || cell.state == NumberState::blank) &&
                           bits(cell.value) == bits(x[k]);
                }
                wrong += !same;
                if (!same && first_wrong.empty()) first_wrong = std::string(line);
            }
            INFO("first wrong line: " << first_wrong);
            CHECK(wrong == 0);
        }
        // Plain lines must not be left to the slow reader.
        CHECK(taken_lines * 2 > all_lines);
    }
}

TEST_CASE("node kernels take every plain line") {
    const std::string head = "#RADIOSS STARTER\n/NODE\n";
    const std::vector<std::pair<std::string, Vec3>> plain{
        {"         1                 0.0                -1.5                 2.0", {0, -1.5, 2}},
        {"1         1.0                 2.0                 3.0                 ", {1, 2, 3}},
        {"         1                  .5                  3.               -7E+2", {0.5, 3, -700}},
        {"         1                 1.0", {1, 0, 0}},
        {"         1                                     2.0                   \r", {0, 2, 0}},
        {"         1 1.23456789012345678-0.00000000000000001                -0.0",
         {1.23456789012345678, -1e-17, -0.0}},
    };
    for (const Kernel kernel : kernels())
        for (const auto& [line, x] : plain) {
            const std::string text = head + line + "\n" + std::string(100, ' ') + "\n";
            const TakenNodes taken = take_nodes(kernel, {}, text, head.size());
            INFO(line);
            REQUIRE(taken.id.size() == 1);
            CHECK(taken.id[0] == 1);
            CHECK(bits(taken.x[0].x) == bits(x.x));
            CHECK(bits(taken.x[0].y) == bits(x.y));
            CHECK(bits(taken.x[0].z) == bits(x.z));
        }
}

TEST_CASE("node kernels cut touching numbers at the column") {
    const std::string head = "#RADIOSS STARTER\n/NODE\n";
    const std::string line = "        42               160.0-1.5258789062500E-05-1.52587890625000E-5";
    REQUIRE(line.size() == 70);
    for (const Kernel kernel : kernels()) {
        const std::string text = head + line + "\n" + std::string(100, '#') + "\n";
        const TakenNodes taken = take_nodes(kernel, {}, text, head.size());
        REQUIRE(taken.id == std::vector<uint32_t>{42});
        CHECK(taken.x[0] == Vec3{160.0, -1.52587890625e-05, -1.52587890625e-05});
    }
}

TEST_CASE("node kernels leave what is not plain") {
    const std::string head = "#RADIOSS STARTER\n/NODE\n";
    for (const std::string line : {
             "#        1                 0.0                 0.0                 0.0",
             "                                                                      ",
             "",
             "         0                 0.0                 0.0                 0.0",
             "        -1                 0.0                 0.0                 0.0",
             "2147483648                 0.0                 0.0                 0.0",
             "     1 2 3                 0.0                 0.0                 0.0",
             "         1               1.5-3                 0.0                 0.0",
             "         1                +1.5                 0.0                 0.0",
             "         1            1.0  2.0                 0.0                 0.0",
             "         1                 nan                 0.0                 0.0",
             "         1               1e400                 0.0                 0.0",
             "         1             &length                 0.0                 0.0",
             "         1\t                0.0                 0.0                 0.0",
             "         1                 0.0                 0.0                 0.0 7",
             "         1                 0.0                 0.0                 0.0,",
             "1,0.0,0.0,0.0",
             "         1               1.2.3                 0.0                 0.0",
             "         1                  1E                 0.0                 0.0",
             "         1                   -                 0.0                 0.0",
         })
        for (const Kernel kernel : kernels()) {
            const std::string text = head + line + "\n" + std::string(100, '#') + "\n";
            INFO(line);
            CHECK(take_nodes(kernel, {}, text, head.size()).id.empty());
        }
}

TEST_CASE("node kernels read the narrow columns of old decks") {
    const std::string head = "#RADIOSS STARTER\n/NODE\n";
    const std::string text = head + "       7             1.5            -2.5        1.25E+01\n";
    for (const Kernel kernel : kernels()) {
        const TakenNodes taken = take_nodes(kernel, {8, 16}, text, head.size());
        REQUIRE(taken.id == std::vector<uint32_t>{7});
        CHECK(taken.x[0] == Vec3{1.5, -2.5, 12.5});
    }
}

TEST_CASE("element kernels agree with the exact reader") {
    for (const Kernel kernel : kernels())
        for (const uint32_t cells : {4u, 5u, 7u, 9u}) {
            uint64_t taken_lines = 0, all_lines = 0;
            for (uint32_t seed = 1; seed <= 20; ++seed) {
                CellMaker make(seed);
                std::string text;
                for (int i = 0; i < 1000; ++i) {
                    std::string line;
                    for (uint32_t k = 0; k < cells; ++k)
                        line += make.cell(
                            make.below(60) ? make.digits(1 + make.below(9)) : make.integer_text(), 10);
                    if (make.below(20) == 0) line.resize(make.below(10 * cells + 1));
                    text += line + make.rest() + make.line_end();
                }
                const std::vector<Line> lines = lines_of(text);
                all_lines += lines.size();
                std::vector<uint32_t> values(cells * lines.size());
                std::vector<std::string_view> more(lines.size());
                LineRange range{text.data(), text.data() + text.size(), text};
                uint64_t wrong = 0;
                for (std::size_t line = 0; line < lines.size(); ++line) {
                    IdRows rows{values.data(), more.data(), cells, lines.size(), 0};
                    read_id_lines(kernel, {}, range, rows);
                    taken_lines += rows.count;
                    for (std::size_t i = 0; i < rows.count; ++i, ++line) {
                        std::string_view at = std::string_view(text).substr(
                            lines[line].begin, lines[line].end - lines[line].begin);
                        for (uint32_t k = 0; k < cells; ++k) {
                            const IntegerCell cell = parse_integer(columns(at, 10 * k, 10));
                            wrong += !(cell.state == NumberState::ok || cell.state == NumberState::blank) ||
                                     cell.value != values[i * cells + k];
                        }
                        wrong += values[i * cells] == 0 || at.find(',') != std::string_view::npos;
                        wrong += trim(columns(at, 10 * cells, at.size())) != trim(more[i]);
                    }
                    if (line < lines.size()) REQUIRE(range.at == text.data() + lines[line].begin);
                    range.at = line + 1 < lines.size() ? text.data() + lines[line + 1].begin : range.end;
                }
                CHECK(wrong == 0);
            }
            CHECK(taken_lines * 2 > all_lines);
        }
}

TEST_CASE("data lines are neither comments nor blank") {
    CHECK(count_data_lines("") == 0);
    CHECK(count_data_lines("1") == 1);
    CHECK(count_data_lines("1\n2\n") == 2);
    CHECK(count_data_lines("#1\n$2\n #3\n") == 1);
    CHECK(count_data_lines("\n   \n\t\r\n \r\n 5\r\n\n") == 1);
}
