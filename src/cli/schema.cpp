#include "cli/schema.h"

#include "base/nearest.h"
#include "cli/commands.h"
#include "config/options.h"

namespace drawbead {

int run(const SchemaCommand& command) {
    if (command.name == "config") return print(config_schema()); // made from the table of options
    std::vector<std::string> names{"config"};
    std::string list = names.front();
    for (const Schema& schema : schemas()) {
        if (schema.name == command.name) return print(schema.text);
        names.emplace_back(schema.name);
        list += ", " + names.back();
    }
    std::string help = did_you_mean(command.name, names);
    if (help.empty()) help = "there is: " + list;
    say_error({"no schema '" + command.name + "'", "", 0, 0, help});
    return exit_failed;
}

} // namespace drawbead
