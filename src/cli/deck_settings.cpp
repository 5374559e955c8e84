#include "cli/deck_settings.h"

#include "cli/commands.h"
#include "cli/selection.h"
#include "report/text.h"

#include <filesystem>
#include <set>

namespace drawbead {

Result<DeckSettings> DeckSettings::of(const std::vector<DeckPath>& decks, const ConfigArguments& config,
                                      const ReadArguments& reading, const CommandChoices& choices) {
    const Result<Selection> selection = selection_of(choices.select, choices.ignore);
    if (!selection) return selection.error();
    DeckSettings out;
    const Origin here{"command line", 0, 0};
    if (!selection->select.empty()) out.command_line_.select = {selection->select, here};
    if (!selection->ignore.empty()) out.command_line_.ignore = {selection->ignore, here};
    if (choices.fail_on_given) out.command_line_.fail_on = {word_of(choices.fail_on), here};
    if (!reading.include_path.empty()) out.command_line_.include_path = {reading.include_path, here};
    ConfigFinder finder(config.file, config.isolated);
    for (const DeckPath& deck : decks) {
        out.names_.push_back(deck.path == "-" && !reading.stdin_filename.empty() ? reading.stdin_filename
                                                                                 : deck.path);
        if (deck.failed()) {
            out.configs_.emplace_back();
            continue;
        }
        const auto found = finder.find(out.names_.back());
        if (!found) return found.error();
        out.configs_.push_back(*found);
    }
    return out;
}

std::vector<std::string> DeckSettings::files() const {
    std::set<std::string> paths;
    for (const auto& config : configs_)
        if (config) paths.insert(config->path);
    return {paths.begin(), paths.end()};
}

Settings DeckSettings::of(std::size_t deck) const {
    return settle(configs_[deck].get(), names_[deck], command_line_);
}

Settings DeckSettings::of_files(std::size_t deck) const {
    return settle(configs_[deck].get(), names_[deck], {});
}

int DeckSettings::show(const std::vector<DeckPath>& decks) const {
    std::string text;
    int status = exit_clean;
    for (std::size_t i = 0; i < decks.size(); ++i) {
        if (decks[i].failed()) {
            say_error({decks[i].failure, decks[i].path, 0, 0, decks[i].help});
            status = exit_failed;
            continue;
        }
        if (!text.empty()) text += "---\n";
        text += drawbead::show(of(i), names_[i]);
    }
    const int printed = print(text);
    return printed == exit_clean ? status : printed;
}

Result<KnownFindings> KnownFindings::of(const std::string& baseline, const std::string& write_baseline) {
    KnownFindings out;
    if (!baseline.empty()) {
        Result<Baseline> read = Baseline::read(baseline);
        std::error_code failure;
        const bool made_now = baseline == write_baseline && !std::filesystem::exists(baseline, failure);
        if (!read && !made_now) return read.error();
        out.read_ = read ? std::move(*read) : Baseline(baseline);
        out.read_path_ = baseline;
    }
    if (!write_baseline.empty()) {
        std::error_code failure;
        out.before_ = Baseline(write_baseline);
        if (std::filesystem::is_regular_file(write_baseline, failure)) {
            Result<Baseline> before = Baseline::read(write_baseline);
            if (!before) return before.error();
            out.before_ = std::move(*before);
        }
        Result<std::unique_ptr<FileSink>> sink = FileSink::replace(write_baseline);
        if (!sink) return sink.error();
        out.sink_ = std::move(*sink);
        out.written_ = Baseline(write_baseline);
        out.written_path_ = write_baseline;
    }
    return out;
}

void KnownFindings::take(DeckResult& result, const Selection& run) {
    if (written_) return written_->learn(result, run);
    if (!read_) return;
    read_->apply(result, run);
    constexpr uint64_t most = 5;
    for (const BaselineEntry& entry : result.gone) {
        if (gone_++ < most)
            gone_list_ += (gone_list_.empty() ? "" : "; ") + terminal_safe(result.path) + " " + entry.code +
                          (entry.interface_id ? " of interface " + std::to_string(*entry.interface_id) : "") +
                          (entry.count > 1 ? ", " + std::to_string(entry.count) + " times" : "");
    }
}

int KnownFindings::finish(bool quiet) {
    if (written_) {
        const auto change = written_->write(*before_, *sink_);
        if (!change) {
            say_error(change.error());
            return exit_failed;
        }
        if (!quiet)
            say(written_path_ + ": " + how_many(change->findings, "known finding") + " of " +
                how_many(change->decks, "deck") + ", " + std::to_string(change->added) + " added, " +
                std::to_string(change->removed) + " removed");
        return exit_clean;
    }
    if (gone_ > 0 && !quiet)
        say(read_path_ + ": " + how_many(gone_, "known finding") + (gone_ == 1 ? " is" : " are") +
            " gone: " + gone_list_ + (gone_ > 5 ? "; …" : "") + "; --write-baseline takes " +
            (gone_ == 1 ? "it" : "them") + " out");
    return exit_clean;
}

} // namespace drawbead
