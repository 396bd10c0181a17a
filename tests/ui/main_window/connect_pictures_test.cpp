// SPDX-License-Identifier: Apache-2.0
// Pictures of Connect with a suit, well and with faults, for packaging/screenshots.sh: NOCTULE_SCREENSHOTS
// names the folder that they go into, NOCTULE_SCREENSHOT_SUIT the take with sound that the virtual suit
// streams.
#include <QDir>
#include <QTcpSocket>

#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/side_docks.h"
#include "ui/style/theme.h"
#include "ui/views/body_map.h"
#include "ui/views/connect_page.h"
#include "ui/views/readiness_panel.h"

namespace noctule::ui {
namespace {

class ConnectPictures : public test::StudioWindow {
protected:
    void SetUp() override {
        pictures_ = qEnvironmentVariable("NOCTULE_SCREENSHOTS");
        take_ = qEnvironmentVariable("NOCTULE_SCREENSHOT_SUIT").toStdString();
        if (pictures_.isEmpty() || take_.empty())
            GTEST_SKIP() << "NOCTULE_SCREENSHOTS or NOCTULE_SCREENSHOT_SUIT is not set";
        QDir().mkpath(pictures_);
        StudioWindow::SetUp();
    }
    StudioParts parts() const override {
        StudioParts parts = StudioWindow::parts();
        parts.make_sample_take = [take = take_](const std::string& path, const JobContext&) -> Status {
            std::filesystem::copy_file(take, path);
            return Done{};
        };
        return parts;
    }
    ConnectPage& page() { return dynamic_cast<ConnectPage&>(window_->page(Step::kConnect)); }
    void tell(const QByteArray& command) {
        const QStringList control = studio_->virtualSuit().controlAddress().split(':');
        QTcpSocket socket;
        socket.connectToHost(control.value(0), control.value(1).toUShort());
        ASSERT_TRUE(socket.waitForConnected());
        socket.write(command + '\n');
        ASSERT_TRUE(waitFor([&] { return socket.canReadLine(); }));
    }
    void save(const QString& name) {
        for (const QSize size : {QSize(1440, 900), QSize(1280, 800)})
            for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
                Theme::get().setScheme(scheme);
                window_->resize(size);
                window_->sideDocks().reset();
                QTest::qWait(700);
                const QString look = scheme == Scheme::kDark ? "dark" : "light";
                window_->grab().save(
                    QDir(pictures_).filePath(QString("%1-%2-%3.png").arg(name, look).arg(size.width())));
            }
        Theme::get().setScheme(Scheme::kDark);
    }

    QString pictures_;
    std::string take_;
};

TEST_F(ConnectPictures, WellAndWithFaults) {
    window_->goTo(Step::kConnect);
    save("connect-without");
    studio_->startVirtualSuit();
    ASSERT_TRUE(waitFor([this] { return page().readiness().verdict() == "Ready"; }));
    QTest::qWait(6000);
    save("connect-well");
    page().map().boardButton(10)->click();
    tell("unplug 18");
    tell("battery 15");
    ASSERT_TRUE(waitFor([this] { return page().readiness().verdict() == "Not ready yet"; }));
    QTest::qWait(5000);
    save("connect-faults");
    Theme::get().setScale(1.5);
    window_->resize(1920, 1080);
    QTest::qWait(1000);
    window_->grab().save(QDir(pictures_).filePath("connect-faults-150.png"));
    Theme::get().setScale(1);
    tell("cut 6");
    ASSERT_TRUE(waitFor([this] { return studio_->suit().status()->link == LinkState::kLost; }));
    save("connect-cut");
}

}  // namespace
}  // namespace noctule::ui
