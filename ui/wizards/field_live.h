// SPDX-License-Identifier: Apache-2.0
// The middle of the magnetometers' wizard: what to do in words that are read from three metres, the sphere of
// directions that fills (before that, where the room bends the field), one sentence beside the ring with the
// percentage, and three checks.
#pragma once

#include <QWidget>
#include <array>

namespace noctule::ui {

class FieldDrawing;
class FieldHeights;
class Headline;
class Label;
class MeasureMeter;
class SentenceCard;
class WizardRun;

class FieldLive : public QWidget {
    Q_OBJECT
public:
    explicit FieldLive(QWidget* parent = nullptr);

    void setRun(WizardRun* run);
    QString instruction() const;
    QString sentence() const;

private:
    QWidget* makeChecks();
    void refresh();
    void showChecks();

    WizardRun* run_ = nullptr;
    Label *head_, *so_far_;
    Headline* instruction_;
    FieldDrawing* drawing_;
    FieldHeights* heights_;
    SentenceCard* card_;
    Label* foot_;
    std::array<MeasureMeter*, 3> checks_{};
    QString said_;
    int shown_step_ = -1;
};

}  // namespace noctule::ui
