// SPDX-License-Identifier: Apache-2.0
// The Record page in a studio of its own, and a box to record from: it plays the tiny take over TCP.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "core/recording/take.h"
#include "tests/devices/support/test_box.h"
#include "tests/ui/support/wait.h"
#include "ui/models/studio.h"
#include "ui/style/theme.h"
#include "ui/views/record/record_bar.h"
#include "ui/views/record/record_center.h"
#include "ui/views/record/record_page.h"

namespace noctule::ui::test {

class RecordFixture : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        QSettings().clear();
        QSettings().setValue("folders/sessions", folder_.filePath("sessions"));
        QSettings().setValue("folders/suits", folder_.filePath("suits"));
        QSettings().setValue("record/countdown_s", 0);
        QSettings().setValue("record/tones", false);
        studio_ = std::make_unique<Studio>(
            StudioParts{"test", [] { return std::string("2026-01-01T00:00:00Z"); }, {}, {}});
        page_ = std::make_unique<RecordPage>(*studio_);
        page_->resize(1000, 700);
        page_->show();
        QApplication::setActiveWindow(page_.get());
        ASSERT_TRUE(QTest::qWaitForWindowExposed(page_.get()));
        page_->enter();
    }
    void TearDown() override {
        page_.reset();
        studio_.reset();
    }

    void openSession() { ASSERT_TRUE(studio_->session().create(folder_.filePath("here"), "here")); }
    const Session& session() { return studio_->session().session(); }
    RecordRun& run() { return page_->run(); }
    RecordBar& bar() { return page_->center().bar(); }
    bool reach(RecordRun::State state) {
        return waitFor([&] { return run().state() == state; });
    }
    bool connectTo(const noctule::test::TestBox& box, double rest_s = 0.5) {
        const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
        studio_->suit().connectTo(QString::fromStdString(box.address()),
                                  {take.calibrationInForce()->value, take.actorInForce()->value, rest_s});
        return waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; });
    }
    bool recordFor(double seconds) {
        return reach(RecordRun::State::kReady) && (key(Qt::Key_Space), reach(RecordRun::State::kRecording)) &&
               waitFor([&] { return studio_->suit().recordedSeconds() >= seconds; });
    }
    void key(Qt::Key key) { QTest::keyClick(page_.get(), key); }
    std::string pathOf(const char* take) {
        return session().pathOf(session().takes[static_cast<size_t>(session().findTake(take))]).string();
    }

    QTemporaryDir folder_;
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<RecordPage> page_;
};

}  // namespace noctule::ui::test
