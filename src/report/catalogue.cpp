#include "report/catalogue.h"

#include "report/json.h"
#include "report/table.h"

namespace drawbead {

void write_catalogue_text(OutputSink& out, const std::vector<RuleInfo>& rules) {
    std::vector<std::vector<std::string>> rows{{"code", "name", "severity", "fix", "summary"}};
    for (const RuleInfo& rule : rules) {
        const std::string_view fix = rule.fix == FixAvailability::none ? "-" : name(rule.fix);
        rows.push_back({std::string(rule.code), std::string(rule.name), std::string(name(rule.severity)),
                        std::string(fix), std::string(rule.summary)});
    }
    out.write(text_table(rows));
}

void write_catalogue_json(OutputSink& out, const std::vector<RuleInfo>& rules,
                          std::string_view tool_version) {
    JsonWriter json(out);
    json.begin_object();
    json.member("tool", "drawbead");
    json.member("version", tool_version);
    json.key("rules");
    json.begin_array();
    for (const RuleInfo& rule : rules) {
        json.begin_object();
        json.member("code", rule.code);
        json.member("name", rule.name);
        json.member("family", rule.family());
        json.member("severity", name(rule.severity));
        json.member("fix", name(rule.fix));
        json.key("starter_message");
        if (rule.starter_message)
            json.value(rule.starter_message);
        else
            json.null();
        json.member("summary", rule.summary);
        json.end();
    }
    json.end();
    json.end();
}

} // namespace drawbead
