#include "report/info.h"

#include "cli/commands.h"
#include "cli/reading.h"
#include "rules/check.h"

#include <unistd.h>

namespace drawbead {

namespace {

DeckResult describe(const InfoCommand& command) {
    const Result<DeckSource> source = deck_source(command.path, command.reading);
    if (!source) return failed_deck(command.path, source.error().message);
    return describe_deck(source->name, *source->reader,
                         read_options(command.reading, thread_count(command.reading)));
}

} // namespace

int run(const InfoCommand& command) {
    const DeckResult deck = describe(command);
    if (deck.failed()) {
        say_failure(deck);
        return exit_failed;
    }
    FileSink out(STDOUT_FILENO, "standard output");
    if (command.json)
        write_info_json(out, deck);
    else
        write_info_text(out, deck);
    return finish(out);
}

} // namespace drawbead
