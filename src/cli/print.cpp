#include "cli/commands.h"

#include <unistd.h>

namespace drawbead {

std::string_view tool_version() {
    return DRAWBEAD_VERSION;
}

int finish(FileSink& out) {
    const Result<void> written = out.finish();
    if (written) return exit_clean;
    if (!out.reader_gone()) say_error(written.error());
    return exit_failed;
}

int print(std::string_view text) {
    FileSink out(STDOUT_FILENO, "standard output");
    out.write(text);
    return finish(out);
}

int run(const PrintCommand& command) {
    return print(command.text);
}

} // namespace drawbead
