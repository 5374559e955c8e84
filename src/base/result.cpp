#include "base/result.h"

namespace drawbead {

std::string to_string(const Error& error) {
    std::string text;
    if (!error.path.empty()) {
        text += error.path;
        if (error.line) text += ":" + std::to_string(error.line);
        if (error.line && error.column) text += ":" + std::to_string(error.column);
        text += ": ";
    }
    text += "error: " + error.message;
    if (!error.help.empty()) text += "; " + error.help;
    return text;
}

} // namespace drawbead
