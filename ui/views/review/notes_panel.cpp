// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/notes_panel.h"

#include <QAbstractTextDocumentLayout>
#include <QEvent>
#include <QTextDocument>
#include <utility>

#include "ui/views/open_take.h"
#include "ui/views/review/take_notes.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

namespace {
constexpr int kPause_ms = 1500, kLeastLines = 2, kMostLines = 8;
}

NotesPanel::NotesPanel(ReviewContext& review, QWidget* parent)
    : QWidget(parent),
      review_(review),
      of_take_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      editor_(new QPlainTextEdit) {
    auto* column = makeColumn(this, {12, 0, 12, 0}, 4);
    column->addWidget(of_take_->wrapped()->selectable());
    column->addWidget(editor_);
    editor_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);  // else the panel takes free height
    editor_->setTabChangesFocus(true);
    editor_->setAccessibleName(tr("Notes of this take"));
    editor_->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    editor_->installEventFilter(this);
    editor_->setUndoRedoEnabled(true);
    pause_.setSingleShot(true);
    pause_.setInterval(kPause_ms);
    connect(&pause_, &QTimer::timeout, this, &NotesPanel::save);
    connect(editor_, &QPlainTextEdit::textChanged, this, [this] {
        fitHeight();
        written_ = true;
        pause_.start();
    });
    connect(&review.take(), &TakeDocument::opened, this, &NotesPanel::readTake);
    connect(&review.shared().session(), &SessionModel::changed, this, &NotesPanel::readNotes);
    connect(&review.shared().session(), &SessionModel::opened, this, &NotesPanel::readTake);
    connect(&Theme::get(), &Theme::changed, this, &NotesPanel::fitHeight);
    connect(editor_->document()->documentLayout(), &QAbstractTextDocumentLayout::documentSizeChanged, this,
            &NotesPanel::fitHeight);
    readTake();
}

void NotesPanel::edit() {
    editor_->setFocus(Qt::OtherFocusReason);
}

void NotesPanel::readTake() {
    save();
    take_ = openTakeIndex(review_);
    take_name_ = take_ >= 0 ? review_.shared().session().session().takes[static_cast<size_t>(take_)].name
                            : std::string();
    const auto overview = review_.take().overview();
    const QStringList lines = overview ? takeNoteLines(*overview) : QStringList();
    of_take_->setText(lines.join('\n'));
    of_take_->setVisible(!lines.isEmpty());
    editor_->setEnabled(take_ >= 0);
    editor_->setPlaceholderText(take_ >= 0 ? tr("What should be remembered of this take")
                                : overview ? tr("Takes outside a session keep no notes.")
                                           : QString());
    readNotes();
}

void NotesPanel::readNotes() {
    const bool same_take =
        take_ >= 0 && review_.shared().session().isOpen() &&
        take_ < static_cast<int>(review_.shared().session().session().takes.size()) &&
        review_.shared().session().session().takes[static_cast<size_t>(take_)].name == take_name_;
    if (!same_take && take_ >= 0) {  // one before it was trashed or restored
        take_ = openTakeIndex(review_);
        return;
    }
    const QString notes =
        take_ >= 0 ? QString::fromStdString(
                         review_.shared().session().session().takes[static_cast<size_t>(take_)].notes)
                   : QString();
    if (written_ || notes == editor_->toPlainText())
        return;
    const QSignalBlocker quiet(editor_);
    editor_->setPlainText(notes);
    fitHeight();
}

void NotesPanel::save() {
    pause_.stop();
    if (!std::exchange(written_, false))
        return;
    if (take_ < 0 || !review_.shared().session().isOpen())
        return;
    const auto& takes = review_.shared().session().session().takes;
    const auto found = std::find_if(takes.begin(), takes.end(),
                                    [this](const SessionTake& take) { return take.name == take_name_; });
    const QString notes = editor_->toPlainText();
    if (found != takes.end() && QString::fromStdString(found->notes) != notes)
        review_.shared().session().setTakeNotes(static_cast<int>(found - takes.begin()), notes);
}

void NotesPanel::fitHeight() {
    const int line = QFontMetrics(editor_->document()->defaultFont()).lineSpacing();
    const int lines =
        std::clamp(static_cast<int>(editor_->document()->size().height()), kLeastLines, kMostLines);
    editor_->setFixedHeight(lines * line + Theme::get().px(14));
}

bool NotesPanel::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::FocusOut)
        QTimer::singleShot(0, this, [this] { save(); });
    if (event->type() == QEvent::Resize)
        fitHeight();
    return QWidget::eventFilter(object, event);
}

}  // namespace noctule::ui
