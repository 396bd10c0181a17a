// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/studio_windows.h"

#include <QTimer>

#include "ui/language/language.h"

namespace noctule::ui {

StudioWindows::StudioWindows(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {}

StudioWindows::~StudioWindows() = default;

MainWindow& StudioWindows::show(Step step) {
    applyLanguage(studio_.settings());
    window_ = std::make_unique<MainWindow>(studio_);
    // Later: the window that asks is the one that goes.
    connect(window_.get(), &MainWindow::wordsChanged, this, &StudioWindows::renew, Qt::QueuedConnection);
    window_->goTo(step);
    window_->show();
    return *window_;
}

/// The preferences stay open, in the other language or units.
void StudioWindows::renew() {
    const Step step = window_->step();
    window_.reset();
    QTimer::singleShot(0, &show(step), &MainWindow::showPreferences);
}

}  // namespace noctule::ui
