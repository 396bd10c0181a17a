// SPDX-License-Identifier: Apache-2.0
#include "ui/models/remote_start.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/devices/support/udp_port.h"
#include "tests/ui/support/wait.h"

namespace noctule::ui {
namespace {

class RemoteStartTest : public testing::Test {
protected:
    RemoteStartTest() {
        settings_.clear();
        remote_.setPort(noctule::test::freeUdpPort());
    }
    void send(const QByteArray& message) {
        sender_.writeDatagram(message, QHostAddress(QHostAddress::LocalHost),
                              static_cast<quint16>(remote_.port()));
    }

    QSettings settings_;
    RemoteStart remote_{settings_};
    QUdpSocket sender_;
    QSignalSpy starts_{&remote_, &RemoteStart::startWanted}, stops_{&remote_, &RemoteStart::stopWanted};
};

TEST_F(RemoteStartTest, ListensOnlyWhenItIsAllowed) {
    remote_.begin();
    EXPECT_FALSE(remote_.isAllowed());
    EXPECT_FALSE(remote_.isListening());
    remote_.setAllowed(true);
    ASSERT_TRUE(remote_.isListening()) << remote_.problem().toStdString();
    send(
        "<CaptureStart><Name VALUE=\"dance\"/><Notes VALUE=\"second try\"/><PacketID "
        "VALUE=\"1\"/></CaptureStart>");
    ASSERT_TRUE(waitFor([&] { return starts_.count() == 1; }));
    EXPECT_EQ(starts_[0][0].toString(), "dance");
    EXPECT_EQ(starts_[0][1].toString(), "second try");
    send("<CaptureStop><Name VALUE=\"dance\"/><PacketID VALUE=\"2\"/></CaptureStop>");
    ASSERT_TRUE(waitFor([&] { return stops_.count() == 1; }));
    remote_.setAllowed(false);
    EXPECT_FALSE(remote_.isListening());
}

TEST_F(RemoteStartTest, IsRememberedAndSaysWhenThePortIsTaken) {
    remote_.setAllowed(true);
    RemoteStart other(settings_);
    EXPECT_TRUE(other.isAllowed());
    EXPECT_EQ(other.port(), remote_.port());
    other.begin();
    EXPECT_FALSE(other.isListening());
    EXPECT_TRUE(other.problem().contains(QString::number(other.port()))) << other.problem().toStdString();
    remote_.setAllowed(false);
    other.setAllowed(true);
    EXPECT_TRUE(other.isListening()) << other.problem().toStdString();
    EXPECT_EQ(other.problem(), "");
}

}  // namespace
}  // namespace noctule::ui
