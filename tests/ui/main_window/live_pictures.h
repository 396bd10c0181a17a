// SPDX-License-Identifier: Apache-2.0
// Pictures of pages with a suit, for packaging/screenshots.sh: NOCTULE_SCREENSHOTS names the folder that they
// go into, NOCTULE_SCREENSHOT_SUIT the take with sound that the virtual suit streams, NOCTULE_SCREENSHOT_PAIR
// one of the subjects "A" and "B" for two of them. Without them nothing is made.
#pragma once

#include <QDir>
#include <QTcpSocket>

#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/side_docks.h"
#include "ui/style/theme.h"

namespace noctule::ui::test {

class LivePictures : public StudioWindow {
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
        if (const std::string pair = qEnvironmentVariable("NOCTULE_SCREENSHOT_PAIR").toStdString();
            !pair.empty())
            parts.make_pair_take = [pair](const std::string& path, const JobContext&) -> Status {
                std::filesystem::copy_file(pair, path);
                return Done{};
            };
        return parts;
    }
    /// To the virtual suit's control port.
    void tell(const QByteArray& command) {
        const QStringList control = studio_->virtualSuit().controlAddress().split(':');
        QTcpSocket socket;
        socket.connectToHost(control.value(0), control.value(1).toUShort());
        ASSERT_TRUE(socket.waitForConnected());
        socket.write(command + '\n');
        ASSERT_TRUE(waitFor([&] { return socket.canReadLine(); }));
    }
    /// Of the window, in both themes.
    void save(const QString& name,
              const std::vector<QSize>& sizes = {{1440, 900}, {1280, 800}, {1920, 1080}}) {
        for (const QSize size : sizes)
            for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
                Theme::get().setScheme(scheme);
                window_->resize(size);
                window_->sideDocks().reset();
                QTest::qWait(700);
                const QString look = scheme == Scheme::kDark ? "dark" : "light";
                saveAs(QString("%1-%2-%3").arg(name, look).arg(size.width()));
            }
        Theme::get().setScheme(Scheme::kDark);
    }

    void saveLarge(const QString& name) {
        Theme::get().setScale(1.5);
        window_->resize(1920, 1080);
        QTest::qWait(1000);
        saveAs(name + "-150");
        Theme::get().setScale(1);
    }
    void saveAs(const QString& name) { saveAs(*window_, name); }
    void saveAs(QWidget& widget, const QString& name) {
        EXPECT_TRUE(widget.grab().save(QDir(pictures_).filePath(name + ".png"))) << name.toStdString();
    }

    QString pictures_;
    std::string take_;
};

}  // namespace noctule::ui::test
