// SPDX-License-Identifier: Apache-2.0
// Below the record bar: how loud each board is and how much it moves, and how the sources were heard over the
// last ten seconds.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/live/heard_window.h"
#include "core/live/levels.h"
#include "ui/models/studio.h"
#include "ui/plots/repaint_limit.h"

namespace noctule::ui {

class Label;
class LevelMeters;
class PairsHeard;

class LevelsPanel : public QWidget {
    Q_OBJECT
public:
    explicit LevelsPanel(Studio& studio, QWidget* parent = nullptr);

    LevelMeters& meters() { return *meters_; }
    PairsHeard& heard() { return *heard_; }
    /// "49 of 144 good now"
    QString pairsInWords() const;

private:
    struct Needles {
        MeterNeedle sound, peak, motion;
    };
    QWidget* makeHalf(const QString& title, const QString& hint, QWidget* content, QWidget* foot);
    void startAnew();
    void followLink();
    void take();
    void show();

    Studio& studio_;
    LevelMeters* meters_;
    PairsHeard* heard_;
    Label* good_;
    RepaintLimit repaint_;
    std::vector<Needles> needles_;
    std::optional<HeardWindow> window_;
    QStringList sources_;
    int64_t last_sample_ = 0;
};

}  // namespace noctule::ui
