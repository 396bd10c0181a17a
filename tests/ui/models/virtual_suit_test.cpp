// SPDX-License-Identifier: Apache-2.0
// The virtual suit's program, started and ended by the studio.
#include "ui/models/virtual_suit.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <QSettings>
#include <QSignalSpy>
#include <QTcpSocket>
#include <algorithm>

#include "tests/support/take_files.h"
#include "tests/ui/support/wait.h"
#include "ui/models/studio.h"

namespace noctule::ui {
namespace {

namespace fs = std::filesystem;

class VirtualSuitTest : public testing::Test {
protected:
    void SetUp() override {
        QSettings().clear();
        start(NOCTULE_PROGRAM);
    }
    void start(const std::string& program) {
        QStandardPaths::setTestModeEnabled(true);
        qputenv("XDG_CACHE_HOME", QByteArray::fromStdString(folder_.file("cache")));
        StudioParts parts;
        parts.software = "noctule test";
        parts.utc_now = [] { return std::string("2026-03-01T10:00:00Z"); };
        parts.make_sample_take = [this](const std::string& path, const JobContext&) -> Status {
            ++made_;
            fs::copy_file(noctule::test::kTinyTake, path);
            return Done{};
        };
        parts.virtual_suit_program = program;
        fs::remove_all(QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString());
        studio_.reset();
        studio_ = std::make_unique<Studio>(parts);
        studio_->settings().setValue("folders/sessions", QString::fromStdString(folder_.file("sessions")));
    }
    VirtualSuit& virtualSuit() { return studio_->virtualSuit(); }
    bool reach(LiveSuit::Phase phase) {
        return waitFor([&] { return studio_->suit().phase() == phase; });
    }
    bool connectIt() {
        studio_->startVirtualSuit();
        return reach(LiveSuit::Phase::kLooking);
    }

    const noctule::test::Folder folder_;
    std::atomic<int> made_ = 0;
    std::unique_ptr<Studio> studio_;
};

TEST_F(VirtualSuitTest, ConnectsWithWhatItsTakeKnows) {
    ASSERT_TRUE(connectIt());
    EXPECT_EQ(virtualSuit().state(), VirtualSuit::State::kOn);
    EXPECT_EQ(studio_->suit().status()->hello->serial, "NB-000777");
    EXPECT_TRUE(studio_->suit().calibration());
    EXPECT_DOUBLE_EQ(studio_->suit().known().rest_s, 0.5);
    ASSERT_TRUE(waitFor([&] { return studio_->suit().frame() && studio_->suit().frame()->pose; }));
    studio_->stopVirtualSuit();
    EXPECT_EQ(virtualSuit().state(), VirtualSuit::State::kOff);
    EXPECT_EQ(studio_->suit().phase(), LiveSuit::Phase::kNone);
    ASSERT_TRUE(connectIt()) << "again";
    EXPECT_EQ(made_, 1) << "the take is used again";
    EXPECT_TRUE(studio_->finder().suits().empty()) << "a program, not a box to remember";
}

TEST_F(VirtualSuitTest, ExchangedBoardsEndThatItIsKnownExactly) {
    ASSERT_TRUE(connectIt());
    ASSERT_TRUE(studio_->suit().isKnownExactly());
    studio_->setChecked(CheckedSuit{QDateTime::currentDateTime(), true});
    const QString control = virtualSuit().controlAddress();
    QTcpSocket socket;
    socket.connectToHost(control.section(':', 0, 0), control.section(':', 1).toUShort());
    ASSERT_TRUE(socket.waitForConnected());
    socket.write("swap 1 2\n");
    EXPECT_TRUE(waitFor([this] { return !studio_->suit().isKnownExactly(); }));
    EXPECT_FALSE(studio_->checked()) << "a check from before the exchange says nothing";
    EXPECT_TRUE(waitFor([this] {
        const auto& problems = studio_->check().readiness().problems;
        return std::ranges::any_of(problems, [](const ReadinessProblem& problem) {
            return problem.kind == ProblemKind::kNotChecked;
        });
    })) << "the check is offered";
    studio_->suit().takeOwnCalibration();
    EXPECT_FALSE(studio_->suit().isKnownExactly()) << "the boards are still exchanged";
}

TEST_F(VirtualSuitTest, StoppingItEndsATakeIntact) {
    ASSERT_TRUE(connectIt());
    ASSERT_EQ(studio_->suit().record({"walk", {}, 0, 0}), "");
    ASSERT_TRUE(waitFor([&] { return studio_->suit().recordedSeconds() > 0.5; }));
    studio_->stopVirtualSuit();
    ASSERT_TRUE(waitFor([&] { return virtualSuit().state() == VirtualSuit::State::kOff; }));
    ASSERT_EQ(studio_->session().session().takes.size(), 1u);
    EXPECT_EQ(studio_->session().session().takes[0].state, TakeState::kComplete);
}

TEST_F(VirtualSuitTest, ACrashIsToldInWords) {
    ASSERT_TRUE(connectIt());
    QSignalSpy failed(studio_.get(), &Studio::failed);
    kill(static_cast<pid_t>(virtualSuit().processId()), SIGKILL);
    ASSERT_TRUE(reach(LiveSuit::Phase::kNone));
    ASSERT_GE(failed.count(), 1);
    EXPECT_TRUE(failed[0][0].toString().contains("virtual suit"));
    EXPECT_FALSE(failed[0][1].toString().isEmpty());
    QSignalSpy settled(studio_.get(), &Studio::settled);
    EXPECT_TRUE(connectIt()) << "and starts again";
    EXPECT_TRUE(std::ranges::any_of(settled, [](const QList<QVariant>& about) {
        return about[0].value<About>() == About::kCapture;
    })) << "what was told of the crash is over";
}

TEST_F(VirtualSuitTest, AProgramThatIsNotThereIsToldInWords) {
    for (const std::string& program : {std::string(), folder_.file("nothing"), std::string("/bin/false")}) {
        start(program);
        QSignalSpy failed(studio_.get(), &Studio::failed);
        studio_->startVirtualSuit();
        ASSERT_TRUE(waitFor([&] { return failed.count() == 1; })) << program;
        EXPECT_EQ(virtualSuit().state(), VirtualSuit::State::kOff);
    }
}

TEST_F(VirtualSuitTest, EndsWithTheStudio) {
    ASSERT_TRUE(connectIt());
    const auto process = static_cast<pid_t>(virtualSuit().processId());
    ASSERT_EQ(kill(process, 0), 0);
    studio_.reset();
    EXPECT_NE(kill(process, 0), 0);
}

}  // namespace
}  // namespace noctule::ui
