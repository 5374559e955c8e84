// Repairs of any deck, damaged further: the result is read again, a second repair changes nothing.
#include "files.h"
#include "rules/fix.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

using namespace drawbead;

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

/// Numbers that follow from the input alone, so that an input stays a deck and nothing else.
class Dice {
public:
    explicit Dice(std::string_view text) {
        for (const char c : text)
            state_ = (state_ ^ static_cast<unsigned char>(c)) * 1099511628211u;
    }
    std::size_t below(std::size_t count) {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return count > 0 ? static_cast<std::size_t>(state_ % count) : 0;
    }

private:
    uint64_t state_ = 14695981039346656037u;
};

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        lines.emplace_back(text.substr(begin, end - begin));
        begin = end;
    }
    return lines;
}

/// As people damage a deck: lines lost, doubled or exchanged, ids exchanged, a number overwritten.
std::string damaged(std::string_view text, Dice& dice) {
    std::vector<std::string> lines = lines_of(text);
    for (std::size_t times = dice.below(4); times > 0 && !lines.empty(); --times) {
        const std::size_t at = dice.below(lines.size()), other = dice.below(lines.size());
        std::string& line = lines[at];
        switch (dice.below(5)) {
        case 0:
            lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
            break;
        case 1:
            lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(other), std::string(line));
            break;
        case 2:
            std::swap(line, lines[other]);
            break;
        case 3: // two cells of ten columns
            if (line.size() > 30) std::swap_ranges(line.begin(), line.begin() + 10, line.begin() + 10);
            break;
        default:
            if (const std::size_t digit = line.find_first_of("0123456789"); digit != std::string::npos)
                line[digit] = "0123456789.-eE "[dice.below(15)];
        }
    }
    std::string out;
    for (const std::string& line : lines)
        out += line;
    return out;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    const std::string_view all(reinterpret_cast<const char*>(data), size);
    Dice dice(all);
    const std::string text = damaged(all, dice);
    MemoryReader files = files_from(reinterpret_cast<const uint8_t*>(text.data()), text.size());
    ReadOptions reading;
    reading.max_files = 100;
    FixOptions options;
    options.choices.unsafe = dice.below(2) == 1;
    options.choices.normals = dice.below(2) == 1 ? NormalsMode::elements : NormalsMode::surfaces;
    const FixOutcome outcome = run_fixes(fuzz_main, files, reading, options);
    if (outcome.before.failed()) {
        require(!outcome.changed());
        return 0;
    }
    require(outcome.changed() != outcome.applied.empty());
    report_of(outcome, true);
    if (!outcome.changed()) return 0;
    for (const FixedFile& file : outcome.files)
        files.add(file.path, std::string(file.text));
    const FixOutcome again = run_fixes(fuzz_main, files, reading, options);
    require(!again.before.failed());
    // What is left to do was left by the limit of the rounds.
    require(!again.changed() || outcome.rounds >= options.most_rounds);
    require(again.before.findings.size() == outcome.after.findings.size());
    return 0;
}
