#include "base/nearest.h"
#include "cli/commands.h"
#include "config/options.h"
#include "rules/rule.h"

namespace drawbead {

int run(const ExplainCommand& command) {
    const Rule* rule = find_rule(command.rule);
    if (!rule) rule = find_rule(upper_case(command.rule));
    if (rule) return print(rule->info.page);

    if (command.rule == "configuration") return print(config_page());

    std::vector<std::string> words{"configuration"};
    for (const Rule& known : registry()) {
        words.emplace_back(known.info.code);
        words.emplace_back(known.info.name);
    }
    std::string help = did_you_mean(command.rule, words);
    if (help.empty()) help = "'drawbead rules' lists all";
    say_error({"no rule '" + command.rule + "'", "", 0, 0, help});
    return exit_failed;
}

} // namespace drawbead
