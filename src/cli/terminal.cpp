#include "cli/terminal.h"

#include "report/text.h"

#include <cstdlib>
#include <sys/ioctl.h>
#include <unistd.h>

namespace drawbead {

namespace {

std::string_view environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

void to_standard_error(std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
        if (count <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
}

std::size_t terminal_width() {
    struct winsize size {};
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    return 80;
}

} // namespace

bool wants_colour(ColourMode mode, int descriptor) {
    if (mode != ColourMode::automatic) return mode == ColourMode::always;
    if (!environment("NO_COLOR").empty()) return false;
    const std::string_view force = environment("CLICOLOR_FORCE");
    if (!force.empty() && force != "0") return true;
    return ::isatty(descriptor) == 1 && environment("TERM") != "dumb";
}

void say(std::string_view line) {
    to_standard_error(std::string(line) + '\n');
}

void say_error(const Error& error) {
    say(terminal_safe((error.path.empty() ? "drawbead: " : "") + to_string(error)));
}

namespace {

/// "2 h 05 min", "3 min 20 s", "45 s".
std::string duration_text(double seconds) {
    const auto whole = static_cast<uint64_t>(seconds + 0.5);
    const auto two = [](uint64_t n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string(whole / 60) + " min " + two(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + two(whole / 60 % 60) + " min";
}

} // namespace

Progress::Progress(bool enabled, std::size_t total)
    : enabled_(enabled && total > 1 && ::isatty(STDERR_FILENO) == 1), total_(total), start_(Clock::now()),
      next_(start_ + std::chrono::milliseconds(500)) {}

void Progress::show(std::size_t done, std::string_view path) {
    if (!enabled_ || Clock::now() < next_) return;
    const Clock::time_point now = Clock::now();
    next_ = now + std::chrono::milliseconds(100);
    std::string line = "[" + std::to_string(done) + "/" + std::to_string(total_) + "] ";
    const double seconds = std::chrono::duration<double>(now - start_).count();
    if (done > 0 && done < total_) {
        const double rate = static_cast<double>(done) / seconds;
        const auto tenths = static_cast<uint64_t>(10 * rate + 0.5);
        line += std::to_string(tenths / 10);
        if (rate < 10) line += '.' + std::to_string(tenths % 10);
        line += "/s, " + duration_text(static_cast<double>(total_ - done) / rate) + " left  ";
    }
    line += terminal_safe(path);
    // One column stays free: a full line would wrap and could not be taken away.
    line.resize(std::min(line.size(), terminal_width() - 1));
    to_standard_error("\r\x1b[K" + line);
    shown_ = true;
}

void Progress::clear() {
    if (shown_) to_standard_error("\r\x1b[K");
    shown_ = false;
}

} // namespace drawbead
