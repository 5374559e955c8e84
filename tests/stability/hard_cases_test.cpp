// Every hard case of src/study is a test of its own.
#include "study/hard_cases.h"

#include <catch2/catch.hpp>

#include <deque>
#include <set>

using namespace drawbead;

namespace {

class HardCaseTest final : public Catch::ITestInvoker {
public:
    explicit HardCaseTest(const HardCase& one) : case_(one) {}
    void invoke() const override {
        const HardCaseResult result = case_.measure();
        INFO(case_.scene << ' ' << case_.invariant);
        INFO("measured " << result.measured << ", expected " << result.expected << " to " << result.bound);
        CHECK(result.as_expected());
        // A violation has a size, and what must hold has none.
        CHECK(case_.violated == (std::abs(result.expected) > result.bound));
    }

private:
    HardCase case_;
};

const bool registered = [] {
    static std::deque<std::string> names; // Catch keeps references
    for (const HardCase& one : hard_cases())
        Catch::AutoReg(new HardCaseTest(one), CATCH_INTERNAL_LINEINFO, "",
                       Catch::NameAndTags{names.emplace_back(one.id()), "[hard]"});
    return true;
}();

} // namespace

TEST_CASE("hard cases: names are unique, and every guard has a case of its own") {
    CHECK(registered);
    std::set<std::string> ids;
    std::set<std::string_view> names, guards;
    for (const HardCase& one : hard_cases()) {
        CHECK(ids.insert(one.id()).second);
        CHECK_FALSE(one.scene.empty());
        CHECK_FALSE(one.invariant.empty());
        names.insert(one.name);
        if (!one.guard.empty()) guards.insert(one.guard);
    }
    CHECK(names.size() >= 60);
    CHECK(guards.size() >= 30);
}
