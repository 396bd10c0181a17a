// SPDX-License-Identifier: Apache-2.0
// A recording that another program begins and ends, over a real network socket.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QUdpSocket>

#include "devices/live/record_take.h"
#include "tests/devices/live/fake_device.h"
#include "tests/devices/support/udp_port.h"

namespace noctule {
namespace {

using test::FakeDevice;
using test::Folder;

constexpr int kBoardsOfBox = 2;

/// Another program, with the port that it sends to.
class OtherProgram {
public:
    uint16_t port() const { return port_; }
    void send(const std::string& text) {
        QUdpSocket socket;
        socket.writeDatagram(QByteArray::fromStdString(text), QHostAddress::LocalHost, port_);
    }

private:
    uint16_t port_ = test::freeUdpPort();
};

FakeDevice::Script boxThatStreams() {
    FakeDevice::Script script;
    script.hello = test::madeHello(kBoardsOfBox);
    script.events = test::madeEvents(0, 20 * 150'000, kBoardsOfBox);
    script.speed = 1;
    return script;
}

StreamRequest wishedInto(const Folder& folder) {
    StreamRequest request;
    request.take = RecordingRequest{};
    request.take->folder = folder.path();
    request.take->reserve_bytes = 1'000'000;
    request.process = false;
    request.created_utc = "2026-01-01T00:00:00Z";
    return request;
}

/// Does as told as soon as the job says that it waits, or records.
struct Cue : ProgressSink {
    explicit Cue(std::string awaited) : word(std::move(awaited)) {}
    void progress(double, const std::string& stage) override {
        if (stage.find(word) != std::string::npos)
            seen = true;
    }
    std::string word;
    std::atomic<bool> seen{false};
};

TEST(TriggeredTake, BeginsAndEndsAsAnotherProgramWishes) {
    int argc = 0;
    const QCoreApplication application(argc, nullptr);
    const Folder folder;
    OtherProgram other;
    Cue waiting("Waiting for CaptureStart");
    std::thread director([&] {
        for (int i = 0; i < 1000 && !waiting.seen; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        other.send("<CaptureStop><PacketID VALUE=\"1\"/></CaptureStop>");  // of an earlier recording
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        for (int i = 0; i < 3; ++i)
            other.send(
                "<CaptureStart><Name VALUE=\"../Knee bend\"/><Notes VALUE=\"left first\"/>"
                "<PacketID VALUE=\"2\"/></CaptureStart>");
        std::this_thread::sleep_for(std::chrono::milliseconds(400));
        for (int i = 0; i < 3; ++i)
            other.send("<CaptureStop><PacketID VALUE=\"3\"/></CaptureStop>");
    });
    StreamRequest request = wishedInto(folder);
    request.take->pre_roll_s = 0.1;
    auto report = recordWhenTriggered(std::make_unique<FakeDevice>(boxThatStreams()), request,
                                      {other.port(), "127.0.0.1"}, 15.0, {&waiting, nullptr});
    director.join();
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_FALSE(report->interrupted);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"___Knee_bend_001.noctule"});
    const Result<Take> take = Take::open(report->stream.recording->path);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->meta().at("x_trigger_name"), "../Knee bend");
    EXPECT_EQ(take->notes()->at(0).text, "left first");
    EXPECT_EQ(take->notes()->size(), 1u);
    EXPECT_GE(report->stream.recording->samples, 60'000);
    EXPECT_LT(report->stream.recording->samples, 10 * 150'000) << "it was ended, not its time over";
    EXPECT_EQ(take->markers()->at(0).kind, "start");
    EXPECT_NEAR(static_cast<double>(take->markers()->at(0).sample), 15'000, 600);
}

TEST(TriggeredTake, NoWishNoTake) {
    int argc = 0;
    const QCoreApplication application(argc, nullptr);
    const Folder folder;
    OtherProgram other;
    CancelFlag cancel;
    Cue waiting("Waiting for CaptureStart");
    std::thread operator_([&] {
        for (int i = 0; i < 1000 && !waiting.seen; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        other.send("<CaptureStart><Name VALUE=\"walk\"/>");  // breaks off
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        cancel.cancel();
    });
    const auto report = recordWhenTriggered(std::make_unique<FakeDevice>(boxThatStreams()),
                                            wishedInto(folder), {other.port(), ""}, {}, {&waiting, &cancel});
    operator_.join();
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ErrorKind::kCancelled);
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace noctule
