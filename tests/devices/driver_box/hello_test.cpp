// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/hello.h"

#include "core/suit/default_suit.h"
#include "devices/driver_box/json_members.h"
#include "tests/devices/driver_box/link_data.h"

namespace noctule::link {
namespace {

using Json = nlohmann::json;

Json goldenJson(Type type) {
    const Bytes payload = goldenFrame(type).payload();
    return Json::parse(payload.begin(), payload.end());
}

Result<Hello> readJson(const Json& json) {
    return readHello(bytesOf(json.dump()), "box");
}

TEST(Hello, ReadsTheGoldenOne) {
    const Result<Hello> hello = readHello(goldenFrame(Type::kHello).payload(), "box");
    ASSERT_TRUE(hello) << hello.error().text();
    EXPECT_EQ(hello->serial, "NB-000777");
    EXPECT_EQ(hello->sample_rate_hz, 150000);
    EXPECT_EQ(hello->drive_hz, 40000);
    EXPECT_FALSE(hello->streaming);
    EXPECT_TRUE(hello->suit_is_placed);
    ASSERT_EQ(hello->boardCount(), 2);
    EXPECT_EQ(hello->suit.boards[1].id, "l_hand");
    EXPECT_TRUE(hello->suit.boards[1].has_magnetometer);
    EXPECT_EQ(hello->suit.sources.at(0).serial, "NS-0214");
    const Bytes again = toPayload(*hello);
    const Json json = Json::parse(again.begin(), again.end());
    const Json golden = goldenJson(Type::kHello);
    for (const auto& [name, value] : golden.items())
        if (name != "suit") {
            EXPECT_EQ(json.at(name), value) << name;
        }
}

TEST(Hello, WriteReadEqual) {
    Hello hello;
    hello.minor = 3;
    hello.model = "virtual";
    hello.serial = "NB-1";
    hello.firmware = "1.2.0";
    hello.name = "B\xC3\xBChne";
    hello.sample_rate_hz = 140000;
    hello.adc_bits = 12;
    hello.pulse_interval_samples = 1120;
    hello.pulse_cycles = 8;
    hello.drive_hz = 40450.5;
    hello.streaming = true;
    hello.features = {"zstd", "humidity"};
    hello.suit = defaultSuit();
    const Result<Hello> again = readHello(toPayload(hello), "box");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(toPayload(*again), toPayload(hello));
    EXPECT_TRUE(again->streaming);
    EXPECT_EQ(again->boardCount(), 18);
    EXPECT_TRUE(again->hasFeature("zstd"));
    EXPECT_FALSE(again->hasFeature("magic"));
}

TEST(Hello, OtherProtocolsAreRefusedAndHigherMinorsAreNot) {
    Json json = goldenJson(Type::kHello);
    json["minor"] = 7;
    json["later_member"] = {1, 2, 3};
    EXPECT_TRUE(readJson(json));
    for (const Json& protocol : {Json(2), Json(0), Json(1.5)}) {
        json["protocol"] = protocol;
        const Result<Hello> refused = readJson(json);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
        EXPECT_NE(refused.error().message.find("protocol " + protocol.dump()), std::string::npos);
    }
}

TEST(Hello, NamesWhatIsWrong) {
    for (const char* member : {"protocol", "serial", "sample_rate_hz", "suit"}) {
        Json json = goldenJson(Type::kHello);
        json.erase(member);
        const Result<Hello> read = readJson(json);
        ASSERT_FALSE(read) << member;
        EXPECT_NE(read.error().message.find("box: "), std::string::npos);
    }
    const std::vector<std::pair<const char*, Json>> bad = {
        {"serial", ""},           {"serial", 7},     {"sample_rate_hz", -1},  {"sample_rate_hz", 1.5},
        {"sample_rate_hz", 1e30}, {"adc_bits", 99},  {"streaming", "yes"},    {"features", 3},
        {"drive_hz", "loud"},     {"suit", Json(1)}, {"suit", Json::array()}, {"pulse_interval_samples", 0}};
    for (const auto& [member, value] : bad) {
        Json json = goldenJson(Type::kHello);
        json[member] = value;
        EXPECT_FALSE(readJson(json)) << member << value;
    }
}

TEST(Hello, ASuitOfSerialNumbersIsPlacedByOurs) {
    Json json = goldenJson(Type::kHello);
    for (Json& board : json["suit"]["boards"])
        board = {{"id", board["id"]},
                 {"serial", board["serial"]},
                 {"stream", board["stream"]},
                 {"segment", nullptr}};
    for (Json& source : json["suit"]["sources"])
        source = {{"id", source["id"]}, {"serial", source["serial"]}};
    const Result<Hello> hello = readJson(json);
    ASSERT_TRUE(hello) << hello.error().text();
    EXPECT_FALSE(hello->suit_is_placed);
    Json half = goldenJson(Type::kHello);
    half["suit"]["boards"][1]["q_segment_board"] = nullptr;
    EXPECT_FALSE(readJson(half)->suit_is_placed);
    EXPECT_TRUE(readJson(goldenJson(Type::kHello))->suit_is_placed);
    EXPECT_FALSE(readHello(toPayload(*hello), "box")->suit_is_placed);
    Suit own = readHello(goldenFrame(Type::kHello).payload(), "box")->suit;
    std::swap(own.boards[0], own.boards[1]);
    own.name = "own";
    const Result<Suit> placed = placedBySerial(hello->suit, own);
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->boards[0].id, "chest");
    EXPECT_EQ(placed->boards[0].segment, "Chest");
    EXPECT_EQ(placed->sources[0].segment, "Hips");
    EXPECT_EQ(placed->boards[0].has_magnetometer, hello->suit.boards[0].has_magnetometer);
    Suit with_field = hello->suit;
    for (Board& board : with_field.boards)
        board.has_magnetometer = !board.has_magnetometer;
    const Result<Suit> sends = placedBySerial(with_field, own);
    ASSERT_TRUE(sends);
    for (size_t board = 0; board < with_field.boards.size(); ++board)
        EXPECT_EQ(sends->boards[board].has_magnetometer, with_field.boards[board].has_magnetometer)
            << "what the box sends it alone knows";
    own.boards[0].serial = "NB-004199";
    const Result<Suit> unknown = placedBySerial(hello->suit, own);
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.find("NB-004107"), std::string::npos);
}

TEST(Hello, DamagedTextNeverBreaksTheReader) {
    const Bytes golden = goldenFrame(Type::kHello).payload();
    std::mt19937 random(9);
    for (int i = 0; i < 3000; ++i) {
        Bytes payload = golden;
        for (uint64_t flips = 1 + random() % 3; flips > 0; --flips)
            payload[random() % payload.size()] ^= static_cast<uint8_t>(1 << (random() % 8));
        if (i % 5 == 0)
            payload.resize(random() % payload.size());
        const Result<Hello> read = readHello(payload, "box");
        EXPECT_TRUE(read.ok() || !read.error().message.empty());
    }
    EXPECT_FALSE(readHello(Bytes(500'000, '['), "box"));
    // As deep as a frame can be: nothing may recurse into it.
    std::string deep(golden.begin(), golden.end());
    deep.insert(1, "\"deep\":" + std::string(500'000, '[') + std::string(500'000, ']') + ",");
    EXPECT_TRUE(readHello(bytesOf(deep), "box"));
    int levels = 0;
    const Json parsed = parseObject(bytesOf(deep));
    for (const Json* at = &parsed["deep"]; at->is_array() && !at->empty(); at = &at->front())
        ++levels;
    EXPECT_LT(levels, 20);
    EXPECT_FALSE(readHello(bytesOf("{\"protocol\":1,\"serial\":\"\xFF\"}"), "box"));
    EXPECT_FALSE(readHello({}, "box"));
}

TEST(Announcement, WriteReadEqual) {
    const Result<Announcement> golden = readAnnouncement(goldenFrame(Type::kAnnounce).payload(), "lan");
    ASSERT_TRUE(golden);
    EXPECT_EQ(*golden, (Announcement{"NB-000777", "Vector box", "vector", 41941, 150000, 2, 1, false}));
    EXPECT_EQ(*readAnnouncement(toPayload(*golden), "lan"), *golden);
    EXPECT_FALSE(readAnnouncement(bytesOf(R"({"protocol":1,"serial":"x","tcp_port":70000})"), "lan"));
    EXPECT_FALSE(readAnnouncement(bytesOf(R"({"protocol":2,"serial":"x"})"), "lan"));
    EXPECT_FALSE(readAnnouncement(bytesOf("{}"), "lan"));
}

TEST(Settings, WriteReadEqual) {
    const Result<Settings> golden = readSettings(goldenFrame(Type::kSet).payload());
    ASSERT_TRUE(golden);
    EXPECT_EQ(*golden, (Settings{1200, std::vector<int>{0}, std::nullopt, std::nullopt}));
    const Settings all{1100, std::vector<int>{}, 12, "Halle 2"};
    EXPECT_EQ(*readSettings(toPayload(all)), all);
    EXPECT_EQ(*readSettings(toPayload(Settings{})), Settings{});
    for (const char* bad : {"[]", "", R"({"enabled_sources":3})", R"({"enabled_sources":[-1]})",
                            R"({"enabled_sources":["0"]})", R"({"pulse_cycles":0})", R"({"name":1})"})
        EXPECT_FALSE(readSettings(bytesOf(bad))) << bad;
}

}  // namespace
}  // namespace noctule::link
