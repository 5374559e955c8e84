#include "literate.h"

#include "rules/fix.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace drawbead::literate {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);)
        parts.push_back(part);
    return parts;
}

std::string trimmed(std::string text) {
    text.erase(0, text.find_first_not_of(" \t"));
    text.erase(text.find_last_not_of(" \t") + 1);
    return text;
}

std::vector<std::string> codes_in(const std::string& list) {
    std::vector<std::string> codes;
    for (const std::string& code : split(list, ','))
        if (!trimmed(code).empty()) codes.push_back(trimmed(code));
    return codes;
}

Line marked_line(const std::string& text, std::size_t number) {
    Line line{text, number, {}};
    const std::size_t mark = text.find("# expect:");
    if (mark == std::string::npos) return line;
    line.expected = codes_in(text.substr(mark + 9));
    line.text = text.substr(0, mark);
    line.text.erase(line.text.find_last_not_of(' ') + 1);
    return line;
}

struct FrameBlock {
    std::string key; ///< "/NODE", "/INTER/TYPE8/1"
    File lines;      ///< with the header
};

/// "/INTER/TYPE8/1/5" -> "/INTER/TYPE8/1", "/GRNOD/NODENS/2" -> "/GRNOD/2": groups, surfaces … of one id
/// replace each other, whatever their type.
std::string key_of_header(const std::string& header) {
    const std::vector<std::string> parts = split(trimmed(header), '/');
    std::string key;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const bool id = !parts[i].empty() && parts[i].find_first_not_of("0123456789 ") == std::string::npos;
        if (id) return key + "/" + trimmed(parts[i]);
        if (i == 1 || parts[1] == "INTER") key += "/" + trimmed(parts[i]);
    }
    return key;
}

std::vector<FrameBlock> blocks_of(const File& lines) {
    std::vector<FrameBlock> blocks;
    for (const Line& line : lines) {
        if (blocks.empty() || (!line.text.empty() && line.text[0] == '/'))
            blocks.push_back({line.text.empty() || line.text[0] != '/' ? "" : key_of_header(line.text), {}});
        blocks.back().lines.push_back(line);
    }
    return blocks;
}

bool is_table(const std::string& key) {
    const std::vector<std::string> parts = split(key, '/');
    static const std::set<std::string> tables{"NODE", "SHELL", "SH3N", "BRICK", "TETRA4", "PENTA6"};
    return parts.size() > 1 && tables.count(parts[1]) != 0;
}

std::string row_id(const Line& line) {
    return line.text.empty() || line.text[0] == '#' || line.text[0] == '/' ? ""
                                                                           : trimmed(line.text.substr(0, 10));
}

File completed(const File& fragment, const std::string& version, const std::vector<std::string>& dropped) {
    File frame;
    for (const std::string& text : split(text_of_file(DRAWBEAD_TESTS_DIR "/rules/frames/bead.rad"), '\n'))
        frame.push_back({text, 0, {}});
    if (!version.empty())
        frame[3].text = std::string(10 - std::min<std::size_t>(version.size(), 10), ' ') + version;

    std::vector<FrameBlock> blocks = blocks_of(frame);
    for (const std::string& header : dropped) {
        const std::string key = key_of_header(header);
        const auto gone =
            std::remove_if(blocks.begin(), blocks.end(), [&](const auto& b) { return b.key == key; });
        blocks.erase(gone, blocks.end());
    }
    for (const FrameBlock& given : blocks_of(fragment)) {
        auto same = std::find_if(blocks.begin(), blocks.end(), [&](const FrameBlock& b) {
            return b.key == given.key && b.lines.front().number == 0;
        });
        if (same != blocks.end() && is_table(given.key)) {
            std::set<std::string> ids;
            for (const Line& line : given.lines)
                ids.insert(row_id(line));
            ids.erase("");
            const auto replaced =
                std::remove_if(same->lines.begin(), same->lines.end(),
                               [&](const Line& line) { return ids.count(row_id(line)) != 0; });
            same->lines.erase(replaced, same->lines.end());
            blocks.insert(same + 1, given);
        } else if (same != blocks.end()) {
            *same = given;
        } else {
            const auto last = std::find_if(blocks.begin(), blocks.end(),
                                           [](const FrameBlock& b) { return b.key == "/END"; });
            blocks.insert(last, given);
        }
    }
    File all;
    for (const FrameBlock& block : blocks)
        all.insert(all.end(), block.lines.begin(), block.lines.end());
    return all;
}

/// "key=value" words after the language of a fence.
std::map<std::string, std::string> options_of(const std::string& fence) {
    std::map<std::string, std::string> options;
    std::istringstream in(fence.substr(3));
    for (std::string word; in >> word;) {
        const std::size_t equal = word.find('=');
        if (equal == std::string::npos)
            options[options["language"].empty() ? "language" : word] = word;
        else
            options[word.substr(0, equal)] = word.substr(equal + 1);
    }
    return options;
}

/// Where a finding stands: file and line of the fence, or "frame".
struct Spot {
    std::string file;
    std::size_t line = 0;
};

Spot spot_of(const Example& example, const Finding& finding) {
    const ResolvedPlace& place = finding.places.front();
    const auto file = example.files.find(place.file);
    if (file == example.files.end() || place.line == 0 || place.line > file->second.size())
        return {place.file, 0};
    const std::size_t number = file->second[place.line - 1].number;
    return number == 0 ? Spot{"frame", 0} : Spot{place.file, number};
}

std::string key_of(const Spot& spot, const std::string& code) {
    return spot.line == 0 ? spot.file + ": " + code
                          : spot.file + " line " + std::to_string(spot.line) + ": " + code;
}

} // namespace

std::string text_of_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

bool Example::expects(const std::string& code) const {
    if (expected_in_frame.count(code) != 0) return true;
    for (const auto& [name, file] : files)
        for (const Line& line : file)
            if (std::find(line.expected.begin(), line.expected.end(), code) != line.expected.end())
                return true;
    return false;
}

Document read_document(const std::string& path) {
    Document document;
    document.path = path;
    document.lines = split(text_of_file(path), '\n');
    std::map<std::string, File> files;
    for (std::size_t i = 0; i < document.lines.size(); ++i) {
        const std::string& line = document.lines[i];
        if (line.rfind("# ", 0) == 0 && document.code.empty()) {
            std::istringstream(line.substr(2)) >> document.code >> document.name;
        } else if (line.rfind("## ", 0) == 0) {
            document.headings.push_back(line.substr(3));
        } else if (line.rfind("```", 0) == 0) {
            const std::size_t begin = i + 1;
            std::size_t end = begin;
            while (end < document.lines.size() && document.lines[end] != "```")
                ++end;
            if (end == document.lines.size()) {
                document.error = "line " + std::to_string(i + 1) + ": the fence is not closed";
                return document;
            }
            auto options = options_of(line);
            if (options["language"] == "radioss") {
                File file;
                for (std::size_t k = begin; k < end; ++k)
                    file.push_back(marked_line(document.lines[k], k - begin + 1));
                if (options.count("file") != 0) {
                    files[options["file"]] = file;
                } else {
                    const bool whole = !file.empty() && (file[0].text.rfind("#RADIOSS", 0) == 0 ||
                                                         file[0].text.rfind("/BEGIN", 0) == 0);
                    Example example;
                    example.page_line = i + 1;
                    example.end = end + 1;
                    for (const std::string& code : codes_in(options["expect"]))
                        example.expected_in_frame.insert(code);
                    example.files = std::exchange(files, {});
                    example.files["deck.rad"] =
                        whole ? file : completed(file, options["version"], codes_in(options["drop"]));
                    document.examples.push_back(std::move(example));
                }
            } else if (options["language"] == "diff" && !document.examples.empty()) {
                document.examples.back().diff_begin = begin;
                document.examples.back().diff_end = end;
                document.examples.back().diff_unsafe = options.count("unsafe") != 0;
            } else if (options["language"] == "text" && !document.examples.empty()) {
                document.examples.back().text_begin = begin;
                document.examples.back().text_end = end;
            }
            i = end;
        }
    }
    return document;
}

std::map<std::string, std::string> texts_of(const Example& example) {
    std::map<std::string, std::string> texts;
    for (const auto& [name, file] : example.files)
        for (const Line& line : file)
            texts[name] += line.text + "\n";
    return texts;
}

namespace {

MemoryReader reader_of(const std::map<std::string, std::string>& texts) {
    MemoryReader reader;
    for (const auto& [name, text] : texts)
        reader.add(name, text);
    return reader;
}

} // namespace

Repair repair(const Example& example, const std::string& code, bool unsafe) {
    std::map<std::string, std::string> texts = texts_of(example);
    FixOptions options;
    options.selection.select = {code};
    options.choices.unsafe = unsafe;
    MemoryReader reader = reader_of(texts);
    const FixOutcome outcome = run_fixes("deck.rad", reader, {}, options);
    Repair repair;
    for (const AppliedFix& fix : outcome.applied)
        repair.applied.push_back(fix.title);
    for (const DeclinedFix& fix : outcome.declined)
        repair.declined.push_back(fix.why);
    for (const FixedFile& file : outcome.files) {
        for (const std::string& line : split(unified_diff(file.path, file.original, file.edits), '\n')) {
            if (line.rfind("--- ", 0) == 0 || line.rfind("+++ ", 0) == 0) continue;
            repair.diff.push_back(line.rfind("@@", 0) == 0 ? "@@" : line);
        }
        texts[file.path] = std::string(file.text);
    }
    MemoryReader fixed = reader_of(texts);
    const FixOutcome again = run_fixes("deck.rad", fixed, {}, options);
    repair.settled =
        !again.changed() && std::none_of(again.before.findings.begin(), again.before.findings.end(),
                                         [&](const Finding& f) { return f.code == code; });
    return repair;
}

DeckResult run_texts(const std::map<std::string, std::string>& texts, const Limits& limits) {
    MemoryReader reader = reader_of(texts);
    CheckOptions options;
    options.limits = limits;
    return check_deck("deck.rad", reader, {}, options);
}

DeckResult run(const Example& example, unsigned threads, const Limits& limits) {
    MemoryReader reader = reader_of(texts_of(example));
    CheckOptions options;
    options.threads = threads;
    options.limits = limits;
    return check_deck("deck.rad", reader, {}, options);
}

std::vector<std::string> differences(const Example& example, const DeckResult& result) {
    if (result.failed()) return {"the deck cannot be read: " + result.failure};
    std::map<std::string, std::string> found; // with the message, for whoever reads the failure
    for (const Finding& finding : result.findings)
        found.emplace(key_of(spot_of(example, finding), finding.code), finding.message);
    std::set<std::string> expected;
    for (const std::string& code : example.expected_in_frame)
        expected.insert(key_of({"frame", 0}, code));
    for (const auto& [name, file] : example.files)
        for (const Line& line : file)
            for (const std::string& code : line.expected)
                expected.insert(key_of({name, line.number}, code));

    std::vector<std::string> different;
    for (const auto& [key, message] : found)
        if (expected.count(key) == 0) different.push_back("not expected: " + key + " " + message);
    for (const std::string& key : expected)
        if (found.count(key) == 0) different.push_back("not found: " + key);
    return different;
}

std::vector<std::string> text_of(const Example& example, const DeckResult& result, const std::string& code) {
    std::vector<std::string> text;
    for (const Finding& f : result.findings) {
        if (f.code != code) continue;
        const Spot spot = spot_of(example, f);
        std::string line = spot.file + ":";
        if (spot.line != 0)
            line += std::to_string(spot.line) + ":" + std::to_string(f.places.front().column) + ":";
        line += " " + std::string(name(f.severity)) + ": " + f.code + " " + f.name + ": " + f.message;
        for (const FixOffer& fix : f.fixes)
            line += " [fix: " + fix.title + "]";
        text.push_back(line);
        for (const std::string& note : f.notes)
            text.push_back("  note: " + note);
        if (!f.help.empty()) text.push_back("  help: " + f.help);
    }
    return text;
}

} // namespace drawbead::literate
