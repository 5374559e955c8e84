#include "report/catalogue.h"

#include "cli/commands.h"
#include "rules/rule.h"

#include <set>
#include <unistd.h>

namespace drawbead {

std::vector<std::string> rule_words(bool names) {
    std::vector<std::string> words;
    std::set<std::string> families;
    for (const Rule& rule : registry()) {
        words.emplace_back(rule.info.code);
        families.emplace(rule.info.family());
    }
    words.insert(words.end(), families.begin(), families.end());
    words.emplace_back("ALL");
    if (names)
        for (const Rule& rule : registry())
            words.emplace_back(rule.info.name);
    return words;
}

int run(const RulesCommand& command) {
    std::vector<RuleInfo> rules;
    for (const Rule& rule : registry())
        rules.push_back(rule.info);
    FileSink out(STDOUT_FILENO, "standard output");
    if (command.json)
        write_catalogue_json(out, rules, tool_version());
    else
        write_catalogue_text(out, rules);
    return finish(out);
}

} // namespace drawbead
