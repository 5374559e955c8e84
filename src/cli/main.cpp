#include "cli/commands.h"

#include <csignal>
#include <exception>
#include <fcntl.h>
#include <new>
#include <string>
#include <unistd.h>

namespace {

int run_command_line(int argc, const char* const* argv) {
    using namespace drawbead;
    const std::variant<Command, UsageError> parsed = parse_command_line(argc, argv);
    if (const UsageError* error = std::get_if<UsageError>(&parsed)) {
        say_error({error->message, "", 0, 0, error->help});
        return exit_failed;
    }
    return std::visit([](const auto& command) { return run(command); }, std::get<Command>(parsed));
}

/// A file that is opened must not become standard output because that was closed.
void occupy_standard_descriptors() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) >= 0) continue;
        // The lowest free one is this one. Results for a closed output have to fail.
        if (::open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY) != descriptor) return;
    }
}

} // namespace

int main(int argc, char** argv) {
    occupy_standard_descriptors();
    // A closed pipe shall be a failed write, which every command looks at, not the end of the process.
    std::signal(SIGPIPE, SIG_IGN);
    int status = drawbead::exit_bug;
    try {
        status = run_command_line(argc, argv);
    } catch (const std::bad_alloc&) {
        drawbead::say("drawbead: error: out of memory");
        status = drawbead::exit_failed;
    } catch (const std::exception& error) {
        drawbead::say(std::string("drawbead: internal error, please report it: ") + error.what());
    }
    // Everything is written; giving back the memory of a large deck would only cost time.
    ::_exit(status);
}
