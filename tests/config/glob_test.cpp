#include "config/glob.h"

#include <catch2/catch.hpp>

using namespace drawbead;

TEST_CASE("patterns of paths") {
    struct Case {
        const char *pattern, *path;
        bool matches;
    };
    for (const Case& one : {Case{"*.rad", "a/b/hood_0000.rad", true},
                            {"hood*", "a/hood_0000.rad", true},
                            {"hood*", "hood/a.rad", false},
                            {"a/*.rad", "a/b.rad", true},
                            {"a/*.rad", "a/b/c.rad", false},
                            {"a/**", "a/b/c.rad", true},
                            {"a/**/c.rad", "a/c.rad", true},
                            {"a/**/c.rad", "a/x/y/c.rad", true},
                            {"**/b/*", "a/b/c.rad", true},
                            {"**/b/*", "b/c.rad", true},
                            {"a/", "a/b/c.rad", true},
                            {"a/", "ab/c.rad", false},
                            {"./a/*", "a/c.rad", true},
                            {"../a/*", "../a/c.rad", true},
                            {"a/[bc].rad", "a/c.rad", true},
                            {"a/?.rad", "a/cc.rad", false},
                            {"**", "a/b", true},
                            {"", "a", false},
                            {"a/b", "a/b/c", false},
                            {"./", "a/b.rad", true},
                            {".", "a", false},
                            {"/", "a", false}}) {
        INFO(one.pattern << " and " << one.path);
        CHECK(path_matches(one.pattern, one.path) == one.matches);
    }
}
