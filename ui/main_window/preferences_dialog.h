// SPDX-License-Identifier: Apache-2.0
// Preferences: every choice acts at once and is kept; there is nothing to confirm.
#pragma once

#include <QDialog>

#include "ui/models/studio.h"

class QComboBox;
class QVBoxLayout;

namespace noctule::ui {

class ElidedLabel;
class FormRows;

class PreferencesDialog : public QDialog {
    Q_OBJECT
public:
    explicit PreferencesDialog(Studio& studio, QWidget* parent = nullptr);

    /// A calibration is under way in the window: it stays as it is, as it does during a take.
    void setCalibrating(bool calibrating);

    QComboBox& scheme() { return *scheme_; }
    QComboBox& textSize() { return *text_size_; }
    QComboBox& language() { return *language_; }
    QComboBox& units() { return *units_; }
    QComboBox& countdown() { return *countdown_; }
    QComboBox& soundDevice() { return *device_; }

signals:
    /// Language or units: the window must be made anew; the dialog closes with it.
    void wordsChanged();

private:
    void fit();
    void showWhyNotAnew();
    void addLook(QVBoxLayout& column);
    void addLanguage(QVBoxLayout& column);
    void addUnits(QVBoxLayout& column);
    void addView3d(QVBoxLayout& column);
    void addFolders(QVBoxLayout& column);
    void addRecording(QVBoxLayout& column);
    void addRemoteStart(FormRows& rows);
    void addSound(QVBoxLayout& column);
    void addSoundDevice(FormRows& rows);
    void addSaving(QVBoxLayout& column);
    void chooseSessionsFolder();

    Studio& studio_;
    bool calibrating_ = false;
    QComboBox *scheme_, *text_size_, *language_, *units_, *countdown_, *device_;
    ElidedLabel* folder_;
};

}  // namespace noctule::ui
