#include "cli/reading.h"

#include "base/parallel.h"
#include "cli/interrupt.h"
#include "cli/terminal.h"

#include <cerrno>
#include <system_error>
#include <unistd.h>

namespace drawbead {

namespace {

Result<std::string> read_standard_input() {
    std::string text;
    constexpr std::size_t step = std::size_t{1} << 20;
    for (;;) {
        const std::size_t size = text.size();
        text.resize(size + step);
        const ssize_t count = ::read(STDIN_FILENO, text.data() + size, step);
        text.resize(size + (count > 0 ? static_cast<std::size_t>(count) : 0));
        if (count == 0) return text;
        if (count < 0 && errno == EINTR && interrupt_signal() != 0)
            return Error{"interrupted while reading standard input", "", 0, 0, ""};
        if (count < 0 && errno != EINTR)
            return Error{"cannot read standard input: " + std::generic_category().message(errno), "", 0, 0,
                         ""};
    }
}

} // namespace

OverlayReader::OverlayReader(std::string path, std::string text)
    : path_(std::move(path)), identity_(disk_.exists(path_) ? disk_.identity(path_) : path_),
      text_(std::move(text)) {}

Result<FileBytes> OverlayReader::read(const std::string& path) {
    if (identity(path) == identity_) return FileBytes(text_);
    return disk_.read(path);
}

bool OverlayReader::exists(const std::string& path) {
    return path == path_ || disk_.exists(path);
}

std::string OverlayReader::identity(const std::string& path) {
    if (path == path_) return identity_;
    return disk_.exists(path) ? disk_.identity(path) : path;
}

bool OverlayReader::changed_since_read(const std::string& path) {
    return identity(path) != identity_ && disk_.changed_since_read(path);
}

Result<DeckSource> deck_source(const std::string& path, const ReadArguments& arguments) {
    if (path != "-") return DeckSource{path, std::make_unique<DiskReader>()};
    const std::string name = arguments.stdin_filename.empty() ? "<stdin>" : arguments.stdin_filename;
    Result<std::string> text = read_standard_input();
    if (!text) return text.error();
    return DeckSource{name, std::make_unique<OverlayReader>(name, std::move(*text))};
}

ReadOptions read_options(const ReadArguments& arguments, unsigned threads) {
    ReadOptions options;
    options.threads = threads;
    options.include_root = arguments.include_root;
    options.include_path = arguments.include_path;
    return options;
}

unsigned thread_count(const ReadArguments& arguments) {
    return arguments.threads ? arguments.threads : available_threads();
}

DeckResult failed_deck(std::string path, std::string failure, std::string help) {
    DeckResult result;
    result.path = std::move(path);
    result.failure = std::move(failure);
    result.failure_help = std::move(help);
    return result;
}

void say_failure(const DeckResult& deck) {
    const ResolvedPlace& place = deck.failure_place;
    say_error({deck.failure, place.file.empty() ? deck.path : place.file, place.line, place.column,
               deck.failure_help});
}

} // namespace drawbead
