// SPDX-License-Identifier: Apache-2.0
// A studio with a small take and a 3D view that is on the screen.
#pragma once

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "tests/core/processing/made_take.h"
#include "tests/ui/support/wait.h"
#include "ui/scene/scene_canvas.h"
#include "ui/scene/scene_view.h"
#include "ui/style/theme.h"

namespace noctule::ui::test {

class SceneFixture : public noctule::test::MadeTake {
protected:
    void SetUp() override {
        MadeTake::SetUp();
        addRuns("result");
        addReference(0.4);
        Theme::install(*qApp);
        Theme::get().setReduceMotion(true);
        if (!SceneCanvas::missing().isEmpty())
            GTEST_SKIP() << SceneCanvas::missing().toStdString();
        studio_ = std::make_unique<Studio>(StudioParts{});
        studio_->settings().clear();
        ASSERT_TRUE(waitFor([this] { return studio_->body() != nullptr; }));
        makeView();
    }
    void TearDown() override {
        view_.reset();
        studio_.reset();
        MadeTake::TearDown();
    }

    void makeView() {
        view_ = std::make_unique<SceneView>(*studio_);
        view_->resize(640, 520);
        view_->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(view_.get()));
        view_->activateWindow();
        view_->setFocus();
        settle();
    }
    /// Until nothing moves any more and the last picture is on the screen.
    void settle() {
        QTest::qWait(120);
        EXPECT_TRUE(waitFor([this] { return !canvas() || canvas()->isUpToDate(); }));
    }

    void openTake() {
        studio_->take().open(QString::fromStdString(path()));
        ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen() && studio_->take().shownMotion(); }));
        studio_->time().setTime(0.8);
        ASSERT_TRUE(waitFor([this] { return studio_->take().ranges() && studio_->take().contacts(); }));
        settle();
    }
    SceneCanvas* canvas() const { return view_->findChild<SceneCanvas*>(); }
    QImage picture() const { return view_->picture(); }

    std::unique_ptr<Studio> studio_;
    std::unique_ptr<SceneView> view_;
};

/// Pixels that differ clearly.
inline int differing(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            count += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) +
                         std::abs(qBlue(p) - qBlue(q)) >
                     24;
        }
    return count;
}

}  // namespace noctule::ui::test
