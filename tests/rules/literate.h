#pragma once
// Pages with decks in them that are run. A page is Markdown; its fences are
//
//   ```radioss [version=2021] [drop=/BCS/1,…] [expect=CODE,…]   a deck: a whole one when it begins with
//   #RADIOSS or
//                               /BEGIN, else blocks that replace or join those of the frame (frames/bead.rad)
//   ```radioss file=NAME        another file of the next deck
//   ```text                     the exact text of what the page's rule says of the deck before it
//   ```diff [unsafe]            what the page's rule repairs in that deck, in hunks without their places
//
// `# expect: CODE, CODE` at the end of a line says that exactly these rules find something on the line; it
// and the blanks before it are taken away before the deck is read. `expect=` says it of lines that only the
// frame has.
//
// A block of the fence replaces the frame's block of the same family and id (/GRNOD/NODE/2 takes the place of
// /GRNOD/NODENS/2), and of the same type for /INTER. Tables (/NODE, /SHELL/1 …) join
// instead, and their rows replace the frame's rows of the same id.
#include "findings/report.h"
#include "rules/limits.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace drawbead::literate {

struct Line {
    std::string text;
    std::size_t number = 0; ///< in its fence, from 1; 0 for a line of the frame
    std::vector<std::string> expected;
};
using File = std::vector<Line>;

/// One deck of a page, ready to be read.
struct Example {
    std::size_t page_line = 0;         ///< of its opening fence
    std::map<std::string, File> files; ///< with "deck.rad" the main one
    std::set<std::string> expected_in_frame;
    std::optional<std::size_t> text_begin,
        text_end; ///< lines of the page inside the ```text fence: [begin, end)
    std::optional<std::size_t> diff_begin, diff_end; ///< the same of the ```diff fence
    bool diff_unsafe = false;
    std::size_t end = 0; ///< the line of the page after the closing fence of the deck

    bool expects(const std::string& code) const;
};

struct Document {
    std::string path;
    std::string code, name; ///< from the title "# CODE name"
    std::vector<std::string> lines, headings;
    std::vector<Example> examples;
    std::string error; ///< why it could not be understood
};

Document read_document(const std::string& path);

/// What is found in the example, by all rules.
DeckResult run(const Example&, unsigned threads = 1, const Limits& = {});

/// The texts of its files by name; the main one is "deck.rad".
std::map<std::string, std::string> texts_of(const Example&);
/// What is found in such files.
DeckResult run_texts(const std::map<std::string, std::string>&, const Limits& = {});

/// "line 3: SYN001" of what was expected and not found or found and not expected; empty when all is well.
std::vector<std::string> differences(const Example&, const DeckResult&);

/// What the rule `code` says of the example, one line per finding, its notes and help below, line numbers of
/// the fence.
std::vector<std::string> text_of(const Example&, const DeckResult&, const std::string& code);

/// What `fix` does with the example when only the rule `code` is selected.
struct Repair {
    std::vector<std::string> diff;              ///< lines
    std::vector<std::string> applied, declined; ///< titles, reasons
    bool settled = false; ///< the rule is silent afterwards, and a second run has nothing to do
};
Repair repair(const Example&, const std::string& code, bool unsafe);

std::string text_of_file(const std::string& path);

} // namespace drawbead::literate
