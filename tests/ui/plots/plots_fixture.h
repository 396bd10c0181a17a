// SPDX-License-Identifier: Apache-2.0
// A studio with a small take open: two boards, one source, two seconds, a run and a reference.
#pragma once

#include <QApplication>
#include <QTest>
#include <memory>

#include "tests/core/processing/made_take.h"
#include "tests/ui/support/wait.h"
#include "ui/models/studio.h"
#include "ui/style/theme.h"

namespace noctule::ui::test {

class PlotsFixture : public noctule::test::MadeTake {
protected:
    void SetUp() override {
        MadeTake::SetUp();
        addResults();
        Theme::install(*qApp);
        QSettings().clear();
        StudioParts parts;
        parts.software = "test";
        parts.utc_now = [] { return std::string("2026-01-01T00:00:00Z"); };
        studio_ = std::make_unique<Studio>(parts);
    }
    void TearDown() override {
        studio_.reset();
        MadeTake::TearDown();
    }

    virtual void addResults() {
        addRuns("first");
        addReference(0.1);
    }
    bool open() {
        studio_->take().open(QString::fromStdString(path()));
        return waitFor([this] { return studio_->take().isOpen() && studio_->time().duration() > 0; });
    }
    /// Shown on the screen at a size.
    static void show(QWidget& widget, int width, int height) {
        widget.resize(width, height);
        widget.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&widget));
    }

    std::unique_ptr<Studio> studio_;
};

}  // namespace noctule::ui::test
