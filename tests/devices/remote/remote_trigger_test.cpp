// SPDX-License-Identifier: Apache-2.0
#include "devices/remote/remote_trigger.h"

#include <gtest/gtest.h>

#include <QNetworkDatagram>
#include <chrono>
#include <random>
#include <thread>

namespace noctule {
namespace {

using Kind = CaptureMessage::Kind;

/// As a capture program writes it.
QByteArray startMessage(const char* name, int packet_id) {
    return QByteArray(
               "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n<CaptureStart>"
               "<Name VALUE=\"") +
           name +
           "\"/><Notes VALUE=\"knee &amp; hip\"/><Description VALUE=\"second try\"/>"
           "<DatabasePath VALUE=\"D:/Captures/Take\"/><Delay VALUE=\"33\"/><PacketID VALUE=\"" +
           QByteArray::number(packet_id) + "\"/></CaptureStart>" + QByteArray(1, '\0');
}

QByteArray stopMessage(const char* name, int packet_id) {
    return QByteArray("<CaptureStop RESULT=\"SUCCESS\"><Name VALUE=\"") + name + "\"/><PacketID VALUE=\"" +
           QByteArray::number(packet_id) + "\"/></CaptureStop>";
}

TEST(CaptureMessages, AreReadAsOthersWriteThem) {
    EXPECT_EQ(readCaptureMessage(startMessage("dance", 33360)),
              (CaptureMessage{Kind::kStart, "dance", "knee & hip", "second try", "33360"}));
    EXPECT_EQ(readCaptureMessage(stopMessage("dance", 33361)),
              (CaptureMessage{Kind::kStop, "dance", "", "", "33361"}));
    EXPECT_EQ(readCaptureMessage("<CaptureStart><TimeCode VALUE=\"12:00:00:00\"/></CaptureStart>\n\0junk"),
              (CaptureMessage{Kind::kStart, "", "", "", ""}));
    EXPECT_EQ(
        readCaptureMessage("<CaptureStart>\n  <Name VALUE=\" \xC3\xA4 1 \" />\n</CaptureStart>\n")->name,
        "\xC3\xA4 1");
}

TEST(CaptureMessages, AnythingElseIsNone) {
    const QByteArray whole = startMessage("dance", 1);
    const int text = whole.indexOf('\0');
    for (int length = 0; length < text; ++length)
        EXPECT_FALSE(readCaptureMessage(whole.left(length))) << length;
    for (const char* other :
         {"", "hello", "<CaptureRun/>", "<CaptureStart><Name VALUE=\"a\"></CaptureStart>",
          "<x><CaptureStart/></x>", "<CaptureStart/><CaptureStop/>",
          "<!DOCTYPE a [<!ENTITY b \"c\">]><CaptureStart><Name VALUE=\"&b;\"/></CaptureStart>"})
        EXPECT_FALSE(readCaptureMessage(other)) << other;
    EXPECT_FALSE(
        readCaptureMessage("<CaptureStart>" + QByteArray(kMostMessageBytes, ' ') + "</CaptureStart>"));
    std::mt19937 random(7);
    for (int round = 0; round < 20'000; ++round) {
        QByteArray damaged = whole;
        for (int i = 0; i < 3; ++i)
            damaged[static_cast<int>(random() % static_cast<unsigned>(text))] = static_cast<char>(random());
        (void)readCaptureMessage(damaged);
    }
}

/// A trigger, what it told, and a program that sends to it.
struct Stage {
    explicit Stage(const std::string& only_from = "") {
        auto listening = RemoteTrigger::listen({0, only_from}, [this](const CaptureMessage& message) {
            const std::lock_guard lock(mutex);
            told.push_back(message);
        });
        EXPECT_TRUE(listening) << listening.error().text();
        trigger = std::move(*listening);
    }
    void send(const QByteArray& datagram) {
        EXPECT_EQ(sender.writeDatagram(datagram, QHostAddress::LocalHost, trigger->port()), datagram.size());
    }
    /// Waits until so many datagrams were handled.
    RemoteTrigger::Counts handled(int64_t count) const {
        RemoteTrigger::Counts counts;
        for (int i = 0; i < 1000; ++i) {
            counts = trigger->counts();
            if (counts.told + counts.repeated + counts.malformed + counts.from_others >= count)
                break;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return counts;
    }
    std::string names() const {
        const std::lock_guard lock(mutex);
        std::string text;
        for (const CaptureMessage& message : told)
            text += (message.kind == Kind::kStart ? "+" : "-") + message.name + " ";
        return text;
    }

    mutable std::mutex mutex;
    std::vector<CaptureMessage> told;
    QUdpSocket sender;
    std::unique_ptr<RemoteTrigger> trigger;
};

TEST(RemoteTriggerTest, EveryMessageIsToldOnce) {
    Stage stage;
    for (int i = 0; i < 3; ++i)
        stage.send(startMessage("walk", 10));
    for (int i = 0; i < 3; ++i)
        stage.send(stopMessage("walk", 11));
    stage.send(startMessage("run", 11));  // other programs count for themselves
    stage.send(startMessage("walk", 10));
    const auto counts = stage.handled(8);
    EXPECT_EQ(stage.names(), "+walk -walk +run ");
    EXPECT_EQ(counts.told, 3);
    EXPECT_EQ(counts.repeated, 5);
}

TEST(RemoteTriggerTest, MessagesWithoutAPacketNumberAreAllTold) {
    Stage stage;
    for (int i = 0; i < 2; ++i)
        stage.send("<CaptureStop><Name VALUE=\"walk\"/></CaptureStop>");
    EXPECT_EQ(stage.handled(2).told, 2);
}

TEST(RemoteTriggerTest, WhatIsNoMessageIsCountedAndLeftOut) {
    Stage stage;
    stage.send("hello");
    stage.send(QByteArray(20'000, '<'));
    stage.send("");
    stage.send(startMessage("walk", 1).left(100));
    stage.send(startMessage("walk", 1));
    const auto counts = stage.handled(5);
    EXPECT_EQ(counts.malformed, 4);
    EXPECT_EQ(stage.names(), "+walk ");
}

TEST(RemoteTriggerTest, OthersThanTheOneNamedAreNotHeard) {
    Stage stage("10.1.2.3");
    stage.send(startMessage("walk", 1));
    EXPECT_EQ(stage.handled(1).from_others, 1);
    EXPECT_EQ(stage.names(), "");
    Stage local("127.0.0.1");
    local.send(startMessage("walk", 1));
    EXPECT_EQ(local.handled(1).told, 1);
}

TEST(RemoteTriggerTest, RefusesWhatCannotBe) {
    Stage stage;
    const auto taken = RemoteTrigger::listen({stage.trigger->port(), ""}, [](const CaptureMessage&) {});
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().kind, ErrorKind::kDevice);
    EXPECT_NE(taken.error().message.find(std::to_string(stage.trigger->port())), std::string::npos);
    const auto nonsense = RemoteTrigger::listen({0, "next door"}, [](const CaptureMessage&) {});
    ASSERT_FALSE(nonsense);
    EXPECT_EQ(nonsense.error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace noctule
