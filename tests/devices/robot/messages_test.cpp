// SPDX-License-Identifier: Apache-2.0
// Datagrams and ROS messages: round trips, golden bytes, damage and noise.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "devices/robot/datagram.h"
#include "devices/robot/ros_messages.h"

namespace noctule::robot_link {
namespace {

using nlohmann::json;

Datagram exampleDatagram() {
    Datagram datagram;
    datagram.kind = DatagramKind::kState;
    datagram.sequence = 0x0102030405060708;
    datagram.time_ns = -5;
    datagram.joints_hash = hashOf({"shoulder", "elbow"});
    datagram.obeyed_sequence = 77;
    datagram.flags = kRefuses;
    datagram.q = {1.5, -0.25};
    datagram.v = {0, 3};
    return datagram;
}

TEST(Datagram, ComesBackAsItWas) {
    const Datagram sent = exampleDatagram();
    const auto back = decode(encode(sent));
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->kind, sent.kind);
    EXPECT_EQ(back->sequence, sent.sequence);
    EXPECT_EQ(back->time_ns, sent.time_ns);
    EXPECT_EQ(back->joints_hash, sent.joints_hash);
    EXPECT_EQ(back->obeyed_sequence, sent.obeyed_sequence);
    EXPECT_EQ(back->flags, sent.flags);
    EXPECT_EQ(back->q, sent.q);
    EXPECT_EQ(back->v, sent.v);
}

/// The layout of README.md, byte by byte.
TEST(Datagram, HasTheDocumentedLayout) {
    const std::vector<uint8_t> bytes = encode(exampleDatagram());
    ASSERT_EQ(bytes.size(), 56u + 2 * 16);
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "NRS1");
    EXPECT_EQ(bytes[4], 1);
    EXPECT_EQ(bytes[6], 2);
    EXPECT_EQ(bytes[8], 8);  // little endian
    EXPECT_EQ(bytes[15], 1);
    EXPECT_EQ(bytes[16], 0xFB);
    EXPECT_EQ(bytes[32], 77);
    EXPECT_EQ(bytes[40], 1);
    EXPECT_EQ(bytes[56 + 7], 0x3F);  // 1.5 is 3FF8000000000000
    EXPECT_EQ(bytes[56 + 6], 0xF8);
    EXPECT_EQ(hashOf({"a"}), 0x089BDC07B544E7B2u);  // FNV-1a of "a\n", calculated elsewhere
}

TEST(Datagram, DamageIsNoticed) {
    const std::vector<uint8_t> bytes = encode(exampleDatagram());
    for (size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        std::vector<uint8_t> damaged = bytes;
        damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ (1 << (bit % 8)));
        EXPECT_FALSE(decode(damaged)) << "bit " << bit;
    }
    for (size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(decode(std::span(bytes).first(size))) << size;
}

TEST(Datagram, ValuesThatAreNoNumbersAreRefused) {
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1000.5}) {
        Datagram datagram = exampleDatagram();
        datagram.v[1] = value;
        EXPECT_FALSE(decode(encode(datagram)));
    }
    Datagram query;
    query.kind = DatagramKind::kQuery;
    EXPECT_TRUE(decode(encode(query)));
    query.kind = DatagramKind::kCommand;
    EXPECT_FALSE(decode(encode(query)));
}

TEST(Datagram, NoiseIsNeverTaken) {
    std::mt19937 random(7);
    for (int i = 0; i < 20'000; ++i) {
        std::vector<uint8_t> noise(random() % 200);
        for (uint8_t& byte : noise)
            byte = static_cast<uint8_t>(random());
        if (noise.size() > 8) {
            const char* magic = "NRC1\x01";
            std::copy(magic, magic + 5, noise.begin());
            noise[5] = 0;
        }
        EXPECT_FALSE(decode(noise));
    }
}

TEST(RosMessages, CommandsComeBackByName) {
    RobotCommand command;
    command.q = {0.5, -1};
    command.v = {0.1, 0.2};
    const int64_t wall_ns = 1'700'000'000'123'456'789;
    for (const json& msg : {jointState({"a", "b"}, command.q, command.v, wall_ns),
                            jointTrajectory({"a", "b"}, command, 0.02, wall_ns)}) {
        const auto named = msg.contains("points") ? readJointTrajectory(msg) : readJointState(msg);
        ASSERT_TRUE(named) << named.error().text();
        EXPECT_EQ(named->wall_ns, wall_ns);
        std::vector<double> q, v;
        EXPECT_TRUE(sortInto({"b", "a"}, *named, q, v));
        EXPECT_EQ(q, (std::vector<double>{-1, 0.5}));
        EXPECT_EQ(v, (std::vector<double>{0.2, 0.1}));
        EXPECT_FALSE(sortInto({"a", "c"}, *named, q, v));
    }
    const json trajectory = jointTrajectory({"a", "b"}, command, 0.02, wall_ns);
    ASSERT_EQ(trajectory["points"].size(), 1u);
    EXPECT_EQ(trajectory["points"][0]["time_from_start"], (json{{"secs", 0}, {"nsecs", 20'000'000}}));
}

TEST(RosMessages, APoseComesBack) {
    const TipPose tip{"right", "torso", {1, 2, 3}, Quaterniond(0.5, 0.5, -0.5, 0.5)};
    const auto back = readPoseStamped(poseStamped(tip, 5));
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->frame, "torso");
    EXPECT_EQ(back->p_base_tip, tip.p_base_tip);
    EXPECT_LT(back->q_base_tip.angularDistance(tip.q_base_tip), 1e-12);
}

TEST(RosMessages, StampsOfRos2AreRead) {
    const auto named = readJointState(json::parse(
        R"({"header":{"stamp":{"sec":3,"nanosec":7}},"name":["a"],"position":[1],"velocity":[],"effort":[]})"));
    ASSERT_TRUE(named) << named.error().text();
    EXPECT_EQ(named->wall_ns, 3'000'000'007);
    EXPECT_EQ(named->v, std::vector<double>{0});
}

TEST(RosMessages, WhatIsWrongIsRefused) {
    for (const char* text :
         {"", "[]", "3", "{", R"({"op":3})", R"({"topic":"a"})", R"({"op":"publish","topic":[]})"})
        EXPECT_FALSE(readOperation(text)) << text;
    EXPECT_FALSE(readOperation(R"({"op":")" + std::string(kMostTextBytes, 'a') + "\"}"));
    EXPECT_FALSE(readOperation(R"({"op":"publish","msg":)" + std::string(100'000, '[') + "}"));
    for (const char* text :
         {"3", "{}", R"({"name":["a"],"position":[]})", R"({"name":["a"],"position":["1"]})",
          R"({"name":["a"],"position":[null]})", R"({"name":["a"],"position":[1e300]})",
          R"({"name":[1],"position":[1]})", R"({"name":["a"],"position":[1],"velocity":[1,2]})"})
        EXPECT_FALSE(readJointState(json::parse(text))) << text;
    for (const char* text :
         {"{}", R"({"joint_names":["a"],"points":[]})", R"({"joint_names":["a"],"points":[3]})",
          R"({"joint_names":["a"],"points":[{"positions":[1,2]}]})"})
        EXPECT_FALSE(readJointTrajectory(json::parse(text))) << text;
    for (const char* text :
         {"[]", "{}", R"({"pose":{"position":{"x":1,"y":2}}})",
          R"({"pose":{"position":{"x":1,"y":2,"z":3},"orientation":{"x":0,"y":0,"z":0,"w":0}}})"})
        EXPECT_FALSE(readPoseStamped(json::parse(text))) << text;
}

/// Any byte of a good message changed: it is refused, or what is read is finite and in range.
TEST(RosMessages, FuzzedTextNeverGivesBadValues) {
    RobotCommand command;
    command.q = {0.5, -1};
    command.v = {0.1, 0.2};
    const std::string good = publish("/t", jointState({"a", "b"}, command.q, command.v, 5));
    std::mt19937 random(11);
    int taken = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string text = good;
        for (unsigned change = 0; change <= random() % 4; ++change)
            text[random() % text.size()] = static_cast<char>(random());
        const auto operation = readOperation(text);
        if (!operation)
            continue;
        const auto named = readJointState(operation->msg);
        if (!named)
            continue;
        ++taken;
        EXPECT_TRUE(areSound(named->q, named->v, named->names.size()));
    }
    EXPECT_GT(taken, 100) << "the fuzzing changes too much to test anything";
}

}  // namespace
}  // namespace noctule::robot_link
