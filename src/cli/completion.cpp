#include "base/nearest.h"
#include "cli/commands.h"

#include <algorithm>

namespace drawbead {

namespace {

using Sketches = std::vector<CommandSketch>;
using Value = OptionSketch::Value;

std::string joined(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += between;
        text += word;
    }
    return text;
}

std::vector<std::string> names_of(const OptionSketch& option) {
    std::vector<std::string> names;
    if (!option.short_name.empty()) names.push_back(option.short_name);
    if (!option.long_name.empty()) names.push_back(option.long_name);
    return names;
}

std::vector<std::string> names_of(const Sketches& commands) {
    std::vector<std::string> names;
    for (const CommandSketch& command : commands)
        names.push_back(command.name);
    return names;
}

/// `text` with every character of `special` behind a backslash, for the inside of single quotes.
std::string quoted(std::string_view text, std::string_view special = "") {
    std::string out;
    for (const char c : text) {
        if (c == '\'') {
            out += "'\\''";
            continue;
        }
        if (special.find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
    return out;
}

/// The compgen arguments that make the words of an option or argument.
std::string bash_source(const OptionSketch& option) {
    switch (option.value) {
    case Value::choice:
        return "-W '" + joined(option.choices, " ") + "'";
    case Value::file:
        return "-f";
    case Value::folder:
        return "-d";
    case Value::any:
    case Value::none:
        break;
    }
    return "-W ''";
}

std::string bash_script(const Sketches& commands) {
    std::string text =
        "# bash completion of drawbead: source it, or put it into the folder of your completions\n"
        "_drawbead() {\n"
        "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= i\n"
        "    # --option=value comes as three words\n"
        "    if [[ $current == = ]]; then current=; elif [[ $before == = ]]; then "
        "before=${COMP_WORDS[COMP_CWORD-2]}; fi\n"
        "    for ((i = 1; i < COMP_CWORD; i++)); do\n"
        "        case ${COMP_WORDS[i]} in\n"
        "            " +
        joined(names_of(commands), "|") +
        ") command=${COMP_WORDS[i]}; break ;;\n"
        "        esac\n"
        "    done\n"
        "    _drawbead_words() { mapfile -t COMPREPLY < <(compgen \"$@\" -- \"$current\"); }\n"
        "    case $command:$before in\n";
    for (const CommandSketch& command : commands)
        for (const OptionSketch& option : command.options) {
            if (option.value == Value::none) continue;
            std::vector<std::string> labels;
            for (const std::string& name : names_of(option))
                labels.push_back(command.name + ':' + name);
            text += "        " + joined(labels, "|") + ") _drawbead_words " + bash_source(option) +
                    "; return ;;\n";
        }
    text += "    esac\n"
            "    case $command in\n"
            "        '') _drawbead_words -W '" +
            joined(names_of(commands), " ") + " --help --version' ;;\n";
    for (const CommandSketch& command : commands) {
        std::vector<std::string> options;
        for (const OptionSketch& option : command.options)
            for (const std::string& name : names_of(option))
                options.push_back(name);
        text += "        " + command.name + ") if [[ $current == -* ]]; then _drawbead_words -W '" +
                joined(options, " ") + "'";
        if (command.positional) text += "; else _drawbead_words " + bash_source(*command.positional);
        text += "; fi ;;\n";
    }
    return text + "    esac\n"
                  "}\n"
                  "complete -o filenames -F _drawbead drawbead\n";
}

std::string zsh_action(const OptionSketch& option) {
    switch (option.value) {
    case Value::choice:
        return ":value:(" + joined(option.choices, " ") + ")";
    case Value::file:
        return ":file:_files";
    case Value::folder:
        return ":folder:_files -/";
    case Value::any:
        return ":value: ";
    case Value::none:
        break;
    }
    return "";
}

std::string zsh_script(const Sketches& commands) {
    std::string text = "#compdef drawbead\n"
                       "# zsh completion of drawbead: put it as _drawbead into a folder of $fpath\n"
                       "_drawbead() {\n"
                       "    local -a commands\n"
                       "    commands=(\n";
    for (const CommandSketch& command : commands)
        text += "        '" + command.name + ":" + quoted(command.help, ":\\") + "'\n";
    text +=
        "    )\n"
        "    if (( CURRENT == 2 )); then\n"
        "        _describe command commands\n"
        "        _arguments '--help[Print this help and leave]' '--version[Print the version and leave]'\n"
        "        return\n"
        "    fi\n"
        "    local command=$words[2]\n"
        "    shift words\n"
        "    (( CURRENT-- ))\n"
        "    case $command in\n";
    for (const CommandSketch& command : commands) {
        text += "        " + command.name + ")\n            _arguments";
        for (const OptionSketch& option : command.options) {
            const std::vector<std::string> names = names_of(option);
            text += " \\\n                ";
            // One that may be repeated is not taken off the list: "*".
            const std::string rest =
                "[" + quoted(option.help, "[]:\\") + "]" + quoted(zsh_action(option)) + "'";
            if (names.size() > 1)
                text += "'(" + joined(names, " ") + ")'{" + joined(names, ",") + "}'" + rest;
            else
                text += "'*" + joined(names, "") + rest;
        }
        if (command.positional)
            text += " \\\n                '*" + quoted(zsh_action(*command.positional)) + "'";
        text += " ;;\n";
    }
    return text + "    esac\n"
                  "}\n"
                  // Autoloaded, the file is the function's first call; sourced, it only defines it.
                  "if [[ $funcstack[1] == _drawbead ]]; then _drawbead \"$@\"; else compdef _drawbead "
                  "drawbead; fi\n";
}

std::string fish_source(const OptionSketch& option) {
    switch (option.value) {
    case Value::choice:
        return " -x -a '" + joined(option.choices, " ") + "'";
    case Value::file:
        return " -r -F";
    case Value::folder:
        return " -x -a '(__fish_complete_directories)'";
    case Value::any:
        return " -x";
    case Value::none:
        break;
    }
    return "";
}

std::string fish_script(const Sketches& commands) {
    std::string text =
        "# fish completion of drawbead: put it as drawbead.fish into a folder of completions\n"
        "complete -c drawbead -f\n"
        "complete -c drawbead -n __fish_use_subcommand -l help -d 'Print this help and leave'\n"
        "complete -c drawbead -n __fish_use_subcommand -l version -d 'Print the version and leave'\n";
    for (const CommandSketch& command : commands) {
        text += "complete -c drawbead -n __fish_use_subcommand -a " + command.name + " -d '" +
                quoted(command.help, "\\") + "'\n";
        const std::string start =
            "complete -c drawbead -n '__fish_seen_subcommand_from " + command.name + "'";
        for (const OptionSketch& option : command.options) {
            text += start;
            if (!option.short_name.empty()) text += " -s " + option.short_name.substr(1);
            if (!option.long_name.empty()) text += " -l " + option.long_name.substr(2);
            text += fish_source(option) + " -d '" + quoted(option.help, "\\") + "'\n";
        }
        if (!command.positional) continue;
        if (command.positional->value == Value::choice)
            text += start + " -a '" + joined(command.positional->choices, " ") + "'\n";
        else
            text += start + " -F\n";
    }
    return text;
}

} // namespace

int run(const CompletionCommand& command) {
    const std::vector<std::string> shells{"bash", "zsh", "fish"};
    const Sketches commands = describe_command_line();
    if (command.shell == "bash") return print(bash_script(commands));
    if (command.shell == "zsh") return print(zsh_script(commands));
    if (command.shell == "fish") return print(fish_script(commands));
    std::string help = did_you_mean(command.shell, shells);
    if (help.empty()) help = "there is: " + joined(shells, ", ");
    say_error({"no completion script for '" + command.shell + "'", "", 0, 0, help});
    return exit_failed;
}

} // namespace drawbead
