// SPDX-License-Identifier: Apache-2.0
// The window of the studio over time: it is made anew when the language changes, so that every sentence in it
// is in that language.
#pragma once

#include <memory>

#include "ui/main_window/main_window.h"

namespace noctule::ui {

class StudioWindows : public QObject {
    Q_OBJECT
public:
    explicit StudioWindows(Studio& studio, QObject* parent = nullptr);
    ~StudioWindows() override;

    MainWindow& show(Step step);
    /// The present one; null before show().
    MainWindow* window() const { return window_.get(); }

private:
    void renew();

    Studio& studio_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace noctule::ui
