// SPDX-License-Identifier: Apache-2.0
#include "core/session/shot_list.h"

#include "core/session/session_json.h"
#include "tests/core/session/session_folder.h"

namespace noctule::test {
namespace {

TEST(ShotList, ComesFromPastedText) {
    const auto shots = shotsFromText(
        "Walk, straight line x2\r\n"
        "- Reach, high and low\n"
        "\n"
        "3) Turn, both ways 3x\n"
        "\xE2\x80\xA2 Sit and stand (3)\n"
        "Step over a box\t2\n"
        "   \n"
        "Kick, each leg \xC3\x97"
        "2\n"
        "Walk, straight line\n"
        "Take 5");
    const std::vector<Shot> expected{
        {"Walk, straight line", 2}, {"Reach, high and low", 1}, {"Turn, both ways", 3}, {"Sit and stand", 3},
        {"Step over a box", 2},     {"Kick, each leg", 2},      {"Take 5", 1}};
    EXPECT_EQ(shots, expected);
}

TEST(ShotList, WantsAtLeastOneAndAtMostNinetyNine) {
    EXPECT_EQ(shotsFromText("Walk x0").at(0).wanted, 1);
    EXPECT_EQ(shotsFromText("Walk x99").at(0).wanted, 99);
    EXPECT_EQ(shotsFromText("Walk x100").at(0).name, "Walk x100");
    EXPECT_TRUE(shotsFromText("").empty());
    EXPECT_TRUE(shotsFromText("x3").at(0).name == "x3");
}

TEST(ShotList, AsTextIsReadBackTheSame) {
    const std::vector<Shot> shots{{"Walk, straight line", 2}, {"Sit", 1}};
    EXPECT_EQ(textOf(shots), "Walk, straight line x2\nSit\n");
    EXPECT_EQ(shotsFromText(textOf(shots)), shots);
}

TEST(ShotList, KeepsWhatOnlyTheFileKnows) {
    Shot walk{"Walk", 1, {{"camera", "left"}}};
    const auto edited = withUnknownMembers(shotsFromText("Sit\nWalk x4"), {walk});
    EXPECT_EQ(edited.at(1).unknown["camera"], "left");
    EXPECT_EQ(edited.at(1).wanted, 4);
    EXPECT_TRUE(edited.at(0).unknown.empty());
}

Session sessionOf(const std::vector<Shot>& shots, const std::vector<std::string>& takes_of) {
    Session session;
    session.shots = shots;
    for (const std::string& shot : takes_of) {
        session.takes.emplace_back();
        session.takes.back().shot = shot;
    }
    return session;
}

TEST(ShotList, CountsTakesThatAreKept) {
    Session session = sessionOf({{"Walk", 2}, {"Sit", 1}}, {"Walk", "Sit", "Sit", "", "Run"});
    EXPECT_EQ(keptTakes(session, "Sit"), 2);
    EXPECT_EQ(progressOf(session).kept, 2) << "the second take of Sit is not wanted";
    EXPECT_EQ(progressOf(session).wanted, 3);
    session.takes[0].state = TakeState::kDamaged;
    EXPECT_EQ(keptTakes(session, "Walk"), 0);
}

TEST(ShotList, TheShotThatIsDue) {
    const std::vector<Shot> shots{{"Walk", 2}, {"Sit", 1}, {"Turn", 1}};
    EXPECT_EQ(dueShot(sessionOf({}, {}), -1), -1);
    EXPECT_EQ(dueShot(sessionOf(shots, {}), -1), 0);
    EXPECT_EQ(dueShot(sessionOf(shots, {"Walk"}), 0), 0);
    EXPECT_EQ(dueShot(sessionOf(shots, {"Sit"}), 1), 2);
    EXPECT_EQ(dueShot(sessionOf(shots, {"Turn"}), 2), 0) << "what was left out before";
    EXPECT_EQ(dueShot(sessionOf(shots, {"Walk", "Walk", "Sit", "Turn"}), 1), -1);
}

TEST(ShotList, NamesTakesByItsFirstWord) {
    EXPECT_EQ(takeBaseOf({"Turn, both ways", 1}), "turn");
    EXPECT_EQ(takeBaseOf({"Sit and stand", 1}), "sit");
    EXPECT_EQ(takeBaseOf({"T-pose/arms", 1}), "t-pose");
}

class ShotListFile : public SessionFolder {};

TEST_F(ShotListFile, StandsInTheSessionAndTakesNameTheirShot) {
    Session session = newSession();
    session.shots = {{"Turn, both ways", 3, {{"camera", "left"}}}, {"Sit", 1}};
    ASSERT_TRUE(saveSession(session));
    makeTake(takes() / "turn_001.noctule", kCreated, "", "Turn, both ways");
    const Session again = opened();
    EXPECT_EQ(again.shots, session.shots);
    EXPECT_EQ(again.takes.at(0).shot, "Turn, both ways");
    EXPECT_EQ(keptTakes(again, "Turn, both ways"), 1);
    EXPECT_FALSE(toJson(again)["takes"][0].contains("shot")) << "the take's file says it";
}

TEST_F(ShotListFile, RefusesAShotWithoutANameOrWithoutTakes) {
    newSession();
    auto json = nlohmann::json::parse(text(folder() / "session.json"));
    json["shots"] = {{{"name", "Sit"}, {"takes", 0}}};
    EXPECT_FALSE(sessionFromJson(json, "session.json"));
    json["shots"] = {{{"takes", 1}}};
    const auto refused = sessionFromJson(json, "session.json");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("shot 1"), std::string::npos) << refused.error().message;
    json.erase("shots");
    EXPECT_TRUE(sessionFromJson(json, "session.json")->shots.empty());
}

}  // namespace
}  // namespace noctule::test
