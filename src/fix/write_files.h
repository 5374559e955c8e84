#pragma once
// Several files of a deck in place of the old ones: all, or none.
#include "base/result.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

struct FileToWrite {
    std::string path;          ///< as the user knows it; a symbolic link is followed
    std::string_view original; ///< bytes that were read; the file must still hold them
    std::string_view text;     ///< the new ones
};

/// Writes each text beside its file, with the permissions of the old one, and puts it on the disk; when all
/// are complete, looks whether any file is no longer what was read (`changed` says so by path, and small
/// files are compared byte for byte), and renames them into place. Whatever fails before the first rename
/// leaves every file as it was and nothing beside them. Of several files second names hold the old bytes
/// until all are in place: a rename that fails is undone, and a process that dies between two renames loses
/// nothing.
Result<void> replace_files(const std::vector<FileToWrite>&,
                           const std::function<bool(const std::string& path)>& changed);

/// One file under a name that may be new, in the same way; with the permissions of `like` when it is new.
Result<void> write_file(const std::string& path, std::string_view text, const std::string& like);

} // namespace drawbead
