// SPDX-License-Identifier: Apache-2.0
// A motion file before it becomes a take: the figure as it was understood, from the front and from its left,
// and what one click corrects. The suit is simulated on the person it shows.
#pragma once

#include <map>

#include "ui/models/motion_file.h"
#include "ui/models/studio.h"
#include "ui/views/dialog_frame.h"

class QComboBox;
class QSlider;

namespace noctule::ui {

class Button;
class JobProgress;
class Label;
class LengthBox;
class MotionPicture;

class MotionDialog : public DialogFrame {
    Q_OBJECT
public:
    MotionDialog(Studio& studio, const QString& path, QWidget* parent = nullptr);

    /// As it is understood now; null while it is read, or without a person in it.
    std::shared_ptr<const figure::UnderstoodMotion> motion() const { return file_.motion; }
    const figure::MotionHints& hints() const { return hints_; }
    /// "ideal", "nominal" or "realistic"
    std::string scenarioName() const;
    bool isBusy() const;
    /// Which of the file's joints is this one of ours; null while nothing is read.
    QComboBox* boneOf(const std::string& joint) const;
    /// As a file for --bones; false and a problem shown when it could not be written.
    bool saveBones(const QString& path);

    // For the operator and tests.
    QComboBox *up, *unit, *scenario;
    LengthBox* height;
    Button *exchange_sides, *find_again, *save_bones;
    QSlider* frame;

public slots:
    void accept() override;

private:
    QWidget* makePicture();
    QWidget* makeFacts();
    void read();
    void present(const Result<MotionFile>& file);
    void understand();
    void makeRows();
    void takeBone(const std::string& joint, int index);
    void exchangeSides();
    void askWhereToSave();
    void showFacts();
    void showRows();
    void refresh();
    int jointOf(const std::string& joint) const;

    Studio& studio_;
    const QString path_;
    figure::MotionHints hints_;
    MotionFile file_;
    std::optional<Error> unread_;
    std::map<std::string, QComboBox*> bones_;
    MotionPicture* picture_;
    Label *figure_, *frames_, *rest_, *kept_, *matched_, *warnings_;
    QWidget* rows_ = nullptr;
    QBoxLayout* rows_column_ = nullptr;
    JobProgress* progress_;
    QPointer<Job> job_;
    bool asks_again_ = false;  ///< a correction came while the one before was worked out
    bool fills_ = false;       ///< the fields are being filled, nobody corrects
};

}  // namespace noctule::ui
