// SPDX-License-Identifier: Apache-2.0
// What another system recorded of the open take: its name, how it was aligned and what of it matches; a
// switch that compares with it; and attaching one.
#pragma once

#include <QPointer>
#include <QWidget>

#include "core/processing/outside_files.h"
#include "ui/models/review_context.h"
#include "ui/views/review/attach_dialog.h"

namespace noctule::ui {

class Button;
class ElidedLabel;
class JobProgress;
class Label;
class ToolButton;

class ReferencePanel : public QWidget {
    Q_OBJECT
public:
    explicit ReferencePanel(ReviewContext& review, QWidget* parent = nullptr);

    /// Asks for a file, then how.
    void chooseFile();
    /// As a job; the take is read again afterwards.
    void attach(const AttachChoice& choice);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    QString whyNotAttached() const;
    void refresh();
    void readFacts();
    void showFacts();
    void ask(const QString& path);

    ReviewContext& review_;
    ElidedLabel* name_;
    Label* detail_;
    QWidget* present_;
    Label* absent_;
    Button* attach_;
    ToolButton* compare_;
    JobProgress* progress_;
    QString attached_to_;  ///< the take that progress_ is about
    std::optional<ReferenceFacts> facts_;
    uint64_t ticket_ = 0;
};

}  // namespace noctule::ui
