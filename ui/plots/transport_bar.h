// SPDX-License-Identifier: Apache-2.0
// The row under the timeline: previous marker, play, next marker, loop, speed, in and out with their times,
// the length between them, and a marker at the cursor.
#pragma once

#include <QWidget>

#include "ui/models/review_context.h"

class QComboBox;

namespace noctule::ui {

class Button;
class Label;
class Timeline;
class ToolButton;

class TransportBar : public QWidget {
    Q_OBJECT
public:
    TransportBar(ReviewContext& review, Timeline& timeline, QWidget* parent = nullptr);

    QSize minimumSizeHint() const override;

public slots:
    void setIn();
    void setOut();
    /// At the cursor.
    void addMarker();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void place();
    /// Words that do not fit give way: first the length, then labels; times and icons stay.
    void fitWords();
    void connectStudio();
    void refreshRange();
    void refreshKeys();
    void refreshPlaying();
    void refreshSettings();
    void refreshEnabled();

    ReviewContext& review_;
    Timeline& timeline_;
    ToolButton *previous_ = nullptr, *play_ = nullptr, *next_ = nullptr, *loop_ = nullptr;
    Button *in_ = nullptr, *out_ = nullptr, *marker_ = nullptr;
    QComboBox* speed_ = nullptr;
    Label *speed_label_ = nullptr, *length_ = nullptr;
};

}  // namespace noctule::ui
