// SPDX-License-Identifier: Apache-2.0
// The bottom line of the window, 26 px: what is open and how safe it is, room for recordings, jobs, and the
// way to the shortcuts. A sentence that a page says stands there for some seconds.
#pragma once

#include <QLabel>
#include <QTimer>
#include <QWidget>

#include "ui/models/studio.h"
#include "ui/style/ink.h"

namespace noctule::ui {

class ElidedLabel;
class Label;
class StatusButton;

class StatusLine : public QWidget {
    Q_OBJECT
public:
    explicit StatusLine(Studio& studio, QWidget* parent = nullptr);

    QString openText() const;
    /// Of the picture before openText().
    Tone tone() const;
    QString jobsText() const;
    QString storageText() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public slots:
    void showJobs();

signals:
    void jobsRequested();
    void shortcutsRequested();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool isReadOnly() const;
    void say(const QString& sentence);
    void showOpen();
    void showStorage();
    QString sessionWords() const;
    QString linkWords() const;
    QString suitWords() const;

    Studio& studio_;
    QLabel* safe_;
    ElidedLabel* open_;
    Label* storage_;
    StatusButton *jobs_, *cancel_, *shortcuts_;
    QTimer said_timer_;
    QString said_;
    QString drawn_;  ///< what safe_ shows
};

}  // namespace noctule::ui
