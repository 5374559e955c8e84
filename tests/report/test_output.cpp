#include "report/output.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

using namespace drawbead;
namespace fs = std::filesystem;

namespace {

/// A folder that is gone at the end of the test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (fs::temp_directory_path() / "drawbead-XXXXXX").string();
        path = ::mkdtemp(pattern.data());
    }
    ~TemporaryFolder() { fs::remove_all(path); }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
    fs::path path;
};

std::string content(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

} // namespace

TEST_CASE("a file appears only when it is complete") {
    TemporaryFolder folder;
    const std::string path = folder.path / "report.json";
    {
        Result<std::unique_ptr<FileSink>> sink = FileSink::replace(path);
        REQUIRE(sink);
        (*sink)->write("new");
        CHECK_FALSE(fs::exists(path));
        CHECK((*sink)->finish());
    }
    CHECK(content(path) == "new");
    ::chmod(path.c_str(), 0640);
    {
        Result<std::unique_ptr<FileSink>> sink = FileSink::replace(path);
        REQUIRE(sink);
        (*sink)->write("given up");
        (*sink)->flush();
    }
    CHECK(content(path) == "new");
    CHECK(folder.files() == 1);
    Result<std::unique_ptr<FileSink>> sink = FileSink::replace(path);
    REQUIRE(sink);
    (*sink)->write(std::string(200000, 'x'));
    CHECK((*sink)->finish());
    CHECK(content(path) == std::string(200000, 'x'));
    struct stat status {};
    REQUIRE(::stat(path.c_str(), &status) == 0);
    CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("a link keeps pointing at the file that is replaced") {
    TemporaryFolder folder;
    std::ofstream(folder.path / "target") << "old";
    fs::create_symlink("target", folder.path / "link");
    Result<std::unique_ptr<FileSink>> sink = FileSink::replace(folder.path / "link");
    REQUIRE(sink);
    (*sink)->write("new");
    CHECK((*sink)->finish());
    CHECK(fs::is_symlink(folder.path / "link"));
    CHECK(content(folder.path / "target") == "new");
}

TEST_CASE("what cannot be written is said") {
    TemporaryFolder folder;
    Result<std::unique_ptr<FileSink>> lost = FileSink::replace(folder.path / "no" / "report.json");
    REQUIRE_FALSE(lost);
    CHECK(lost.error().message == "cannot write: No such file or directory");
    Result<std::unique_ptr<FileSink>> is_folder = FileSink::replace(folder.path);
    REQUIRE_FALSE(is_folder);
    CHECK(is_folder.error().message == "cannot write: Is a directory");
}

TEST_CASE("a full disk is noticed") {
    Result<std::unique_ptr<FileSink>> sink = FileSink::replace("/dev/full");
    REQUIRE(sink);
    (*sink)->write("x");
    const Result<void> written = (*sink)->finish();
    REQUIRE_FALSE(written);
    CHECK(to_string(written.error()) == "/dev/full: error: cannot write: No space left on device");
    CHECK_FALSE((*sink)->reader_gone());
}

TEST_CASE("a closed pipe is noticed") {
    std::signal(SIGPIPE, SIG_IGN);
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    ::close(ends[0]);
    FileSink sink(ends[1], "pipe");
    sink.write(std::string(100000, 'x')); // more than the buffer: noticed without finish
    CHECK(sink.failed());
    CHECK(sink.reader_gone());
    CHECK_FALSE(sink.finish());
    ::close(ends[1]);
}
