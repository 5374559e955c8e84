#pragma once
// What goes to people rather than into results: messages, colours, progress.
#include "base/result.h"
#include "cli/options.h"

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace drawbead {

enum ExitStatus : int {
    exit_clean = 0,
    exit_findings = 1,
    exit_failed = 2, ///< could not do the work: usage, an unreadable deck, output that cannot be written
    exit_bug = 3,    ///< an internal check of ours failed
};

/// Whether to colour what is written to `descriptor`: the mode, then NO_COLOR, then CLICOLOR_FORCE, then
/// whether it is a terminal.
bool wants_colour(ColourMode mode, int descriptor);

/// A line on standard error. Errors of writing to it are nobody's to hear.
void say(std::string_view line);
/// "drawbead: error: message; help", or with the place of the Error in front.
void say_error(const Error&);

/// "[12/3000] 40/s, 1 min 15 s left  path" on standard error, when that is a terminal and the run takes
/// longer than half a second. Not for several threads at once.
class Progress {
public:
    Progress(bool enabled, std::size_t total);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(std::size_t done, std::string_view path);
    /// Takes the line away, before anything else is printed.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    bool enabled_;
    bool shown_ = false;
    std::size_t total_;
    Clock::time_point start_, next_;
};

} // namespace drawbead
