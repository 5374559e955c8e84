#pragma once
// Decks from the disk and from standard input.
#include "base/result.h"
#include "cli/options.h"
#include "deck/deck.h"
#include "findings/report.h"

#include <memory>
#include <string>

namespace drawbead {

/// The disk, with one file's bytes replaced by text that is already in memory: a deck from standard input,
/// whose includes are looked up beside the name that it was given.
class OverlayReader final : public FileReader {
public:
    OverlayReader(std::string path, std::string text);
    Result<FileBytes> read(const std::string& path) override;
    bool exists(const std::string& path) override;
    std::string identity(const std::string& path) override;
    bool changed_since_read(const std::string& path) override;

private:
    DiskReader disk_;
    std::string path_, identity_, text_;
};

/// A deck by the name that messages use, and what reads it and its includes.
struct DeckSource {
    std::string name;
    std::unique_ptr<FileReader> reader;
};
/// `path` is a file, or `-` for standard input, which is then read.
Result<DeckSource> deck_source(const std::string& path, const ReadArguments&);

ReadOptions read_options(const ReadArguments&, unsigned threads);
/// -j as given; 0 means all cores.
unsigned thread_count(const ReadArguments&);

/// A deck that could not be read, and why.
DeckResult failed_deck(std::string path, std::string failure, std::string help = {});
/// Says on standard error why.
void say_failure(const DeckResult&);

} // namespace drawbead
