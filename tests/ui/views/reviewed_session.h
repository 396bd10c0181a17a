// SPDX-License-Identifier: Apache-2.0
// A session with takes of a made motion (arms swing, knees bend), processed, and a Studio on it.
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <memory>

#include "core/formats/figure.h"
#include "tests/ui/support/wait.h"
#include "ui/models/studio.h"

namespace noctule::ui::test {

class ReviewedSession : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    QString takePath(const QString& name) const {
        return folder_.filePath("session/takes/" + name + ".noctule");
    }
    QString outsideFile(const QString& name) const { return folder_.filePath(name); }
    /// The first take again, under another name.
    void addTake(const QString& name);
    /// A figure of ours as a mesh of somebody: as good as any. Its path.
    QString writtenFigure(JointNames names = JointNames::kOwn);
    /// Opens the session and a take, and waits for its verdict.
    void openTake(const QString& name);
    bool jobsAreDone() const { return studio_->jobs().idle(); }

    static constexpr double kDuration_s = 4;

    QTemporaryDir folder_;
    std::unique_ptr<Studio> studio_;
};

}  // namespace noctule::ui::test
