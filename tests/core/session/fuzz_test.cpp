// SPDX-License-Identifier: Apache-2.0
// JSON documents of a session under damage: they may be refused, but nothing crashes, throws or grows.
#include "core/session/performer_file.h"
#include "core/session/session_json.h"
#include "tests/support/fuzzing.h"

namespace noctule::test {
namespace {

TEST(FuzzSession, DamagedDocuments) {
    Session session;
    session.name = "Stage tests";
    session.performers.resize(2);
    session.performers[0].name = "Ada";
    session.performers[1].name = "Grace";
    for (const std::string name : {"walk_001", "walk_002", "turn_001"}) {
        session.takes.emplace_back().name = name;
        session.takes.back().file = "takes/" + name + ".noctule";
    }
    session.shots.push_back({"Walk, straight line", 2});
    const std::vector<std::string> examples{toJson(session).dump()};
    int64_t read = 0;
    feedDamaged(examples, 3000, 32 * 1024, [&](const std::string& text, int64_t) {
        read += sessionFromText(text, "fuzz").ok() ? 1 : 0;
        const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
        if (!json.is_discarded())
            (void)performerFromJson(json, "fuzz");
    });
    EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace noctule::test
