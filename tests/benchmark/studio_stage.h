// SPDX-License-Identifier: Apache-2.0
// A studio in its window on the screen at hand, with settings and sessions of its own, as a program that
// measures it drives it.
#pragma once

#include <QTemporaryDir>
#include <functional>
#include <memory>

#include "ui/main_window/main_window.h"
#include "ui/models/studio.h"

namespace noctule::ui::bench {

/// The application as the program sets it up: call once, before everything else of Qt.
void prepareApplication();
/// After QApplication has been made.
void dressApplication();

class StudioStage {
public:
    explicit StudioStage(StudioParts parts = {});
    ~StudioStage();

    Studio& studio() { return *studio_; }
    MainWindow& window() { return *window_; }
    QString folder() const { return folder_.path(); }

    /// Lets the event loop run, without pauses of its own, until it holds; false after the time.
    bool until(const std::function<bool()>& done, int timeout_ms = 60'000);
    /// For so long.
    void run(int ms);
    /// Until everything asked for has been read and painted.
    bool settle();

    /// The open take has its body, and every lane of the plots has its curves.
    bool hasBodyAndPlots();
    /// The cursor there, and the event loop until the 3D view and the plots have both been painted since.
    bool show(double t_s);

private:
    class Painted;
    QTemporaryDir folder_;
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace noctule::ui::bench
