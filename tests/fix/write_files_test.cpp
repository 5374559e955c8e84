// Files are replaced as a whole, or not at all.
#include "fix/write_files.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/stat.h>

using namespace drawbead;
namespace fs = std::filesystem;

namespace {

class Folder {
public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "fixXXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path_); }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(path_), fs::directory_iterator{}));
    }

private:
    fs::path path_;
};

void write(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}
std::string text_of(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

bool nobody(const std::string&) {
    return false;
}

} // namespace

TEST_CASE("several files are replaced, with their permissions, and through links") {
    const Folder folder;
    write(folder / "a.rad", "old a");
    write(folder / "b.inc", "old b");
    REQUIRE(::chmod((folder / "a.rad").c_str(), 0640) == 0);
    fs::create_symlink("b.inc", folder / "link.inc");
    REQUIRE(replace_files({{folder / "a.rad", "old a", "new a"}, {folder / "link.inc", "old b", "new b"}},
                          nobody));
    CHECK(text_of(folder / "a.rad") == "new a");
    CHECK(text_of(folder / "b.inc") == "new b");
    CHECK(fs::is_symlink(folder / "link.inc"));
    struct stat status {};
    REQUIRE(::stat((folder / "a.rad").c_str(), &status) == 0);
    CHECK((status.st_mode & 07777) == 0640);
    CHECK(folder.files() == 3);
}

TEST_CASE("a file that changed meanwhile stops all of them") {
    const Folder folder;
    write(folder / "a.rad", "old a");
    write(folder / "b.inc", "other");
    const std::vector<FileToWrite> files{{folder / "a.rad", "old a", "new a"},
                                         {folder / "b.inc", "old b", "new b"}};
    const auto by_content = replace_files(files, nobody);
    REQUIRE_FALSE(by_content);
    CHECK(by_content.error().message == "the file was changed by somebody else while it was being repaired");
    CHECK(by_content.error().path == folder / "b.inc");
    write(folder / "b.inc", "old b");
    CHECK_FALSE(replace_files(files, [&](const std::string& path) { return path == folder / "a.rad"; }));
    CHECK(text_of(folder / "a.rad") == "old a");
    CHECK(text_of(folder / "b.inc") == "old b");
    CHECK(folder.files() == 2);
}

TEST_CASE("what cannot be written leaves everything as it was") {
    const Folder folder;
    write(folder / "a.rad", "old a");
    fs::create_directory(folder / "b.inc");
    const auto result =
        replace_files({{folder / "a.rad", "old a", "new a"}, {folder / "b.inc", "", "new b"}}, nobody);
    REQUIRE_FALSE(result);
    CHECK(result.error().path == folder / "b.inc");
    CHECK(text_of(folder / "a.rad") == "old a");
    CHECK(folder.files() == 2);
    CHECK_FALSE(write_file(folder / "none/c.rad", "c", folder / "a.rad"));
}

TEST_CASE("a new file has the permissions of the one it comes from") {
    const Folder folder;
    write(folder / "a.rad", "a");
    REQUIRE(::chmod((folder / "a.rad").c_str(), 0600) == 0);
    REQUIRE(write_file(folder / "out.rad", "text", folder / "a.rad"));
    CHECK(text_of(folder / "out.rad") == "text");
    struct stat status {};
    REQUIRE(::stat((folder / "out.rad").c_str(), &status) == 0);
    CHECK((status.st_mode & 07777) == 0600);
}
