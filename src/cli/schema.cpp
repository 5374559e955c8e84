#include "cli/schema.h"

#include "cli/commands.h"
#include "cli/nearest.h"

namespace drawbead {

int run(const SchemaCommand& command) {
    std::vector<std::string> names;
    std::string list;
    for (const Schema& schema : schemas()) {
        if (schema.name == command.name) return print(schema.text);
        names.emplace_back(schema.name);
        list += (list.empty() ? "" : ", ") + names.back();
    }
    std::string help = did_you_mean(command.name, names);
    if (help.empty()) help = "there is: " + list;
    say_error({"no schema '" + command.name + "'", "", 0, 0, help});
    return exit_failed;
}

} // namespace drawbead
