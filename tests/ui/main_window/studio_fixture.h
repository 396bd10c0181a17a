// SPDX-License-Identifier: Apache-2.0
// A studio with a window, settings and a sessions folder of its own, and a virtual suit that is quick: three
// seconds of the sample motion, straight to inertial and range rows.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <memory>

#include "tests/ui/support/wait.h"
#include "ui/main_window/main_window.h"
#include "ui/models/studio.h"

namespace noctule::ui::test {

/// Every page.
inline constexpr auto kEveryStep = {Step::kStart,  Step::kConnect, Step::kCalibrate, Step::kRecord,
                                    Step::kReview, Step::kExport,  Step::kPerformer, Step::kRobot};

Status makeQuickTake(const std::string& path, const JobContext& job);

class StudioWindow : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// Ends the window and the studio and starts both again, as a new start of the program does.
    void restart();
    /// Tries the virtual suit from the start page until its take is under review.
    void openSampleTake();
    /// What the studio is made with.
    virtual StudioParts parts() const;
    QString home() const { return folder_.filePath("sessions"); }

    QTemporaryDir folder_;
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<MainWindow> window_;

private:
    void start();
};

}  // namespace noctule::ui::test
