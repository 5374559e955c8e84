#include "report/bead_table.h"

#include "cli/commands.h"
#include "cli/reading.h"
#include "scene/table.h"

#include <unistd.h>

namespace drawbead {

namespace {

void write(const TableCommand& command, OutputSink& out, const DeckTable& table) {
    switch (command.format) {
    case TableFormat::text:
        return write_table_text(out, table);
    case TableFormat::csv:
        return write_table_csv(out, table);
    case TableFormat::json:
        return write_table_json(out, table, tool_version());
    }
}

/// Interface ids of the deck, for who asked for another one.
std::string ids_of(const Model& model) {
    std::string list;
    for (const Drawbead& bead : model.drawbeads())
        list += (list.empty() ? "" : ", ") + std::to_string(bead.id);
    return list;
}

} // namespace

int run(const TableCommand& command) {
    const Result<DeckSource> source = deck_source(command.path, command.reading);
    if (!source) {
        say_failure(failed_deck(command.path, source.error().message));
        return exit_failed;
    }
    const unsigned threads = thread_count(command.reading);
    const Result<Deck> deck =
        Deck::read(source->name, *source->reader, read_options(command.reading, threads));
    if (!deck) {
        Error error = deck.error();
        if (error.path.empty()) error.path = source->name;
        say_error(error);
        return exit_failed;
    }
    const Model model = Model::build(*deck, needs_contact, threads);
    ContactOptions options;
    options.layer_ratio = 0;
    options.threads = threads;
    DeckTable table = table_of(model, contact_of(model, options), command.interface_id);
    table.path = source->name;
    if (command.interface_id && table.beads.empty()) {
        const std::string ids = ids_of(model);
        say_error({"no /INTER/TYPE8 with id " + std::to_string(*command.interface_id), source->name, 0, 0,
                   ids.empty() ? "the deck has none" : "there is: " + ids});
        return exit_failed;
    }

    std::unique_ptr<FileSink> out = std::make_unique<FileSink>(STDOUT_FILENO, "standard output");
    if (!command.file.empty()) {
        Result<std::unique_ptr<FileSink>> file = FileSink::replace(command.file);
        if (!file) {
            say_error(file.error());
            return exit_failed;
        }
        out = std::move(*file);
    }
    write(command, *out, table);
    for (const std::string& warning : table.warnings)
        say(source->name + ": warning: " + warning);
    return finish(*out);
}

} // namespace drawbead
