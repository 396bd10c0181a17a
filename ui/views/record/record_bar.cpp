// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/record_bar.h"

#include <QCheckBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>

#include "ui/models/countdown_setting.h"
#include "ui/style/keys.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/key_hint.h"
#include "ui/widgets/label.h"
#include "ui/widgets/record_button.h"

namespace noctule::ui {
namespace {

constexpr int kPreRolls_s[] = {0, 2, 5, 10};
constexpr int kBarHeight = 88;
constexpr int kRoomForWords = 760;  ///< below it choices are short, and keys are in the tooltips

QString countdownText(int seconds, int pre_roll_s) {
    const QString text =
        seconds == 0 ? RecordBar::tr("No countdown") : RecordBar::tr("Countdown %1\u00A0s").arg(seconds);
    return pre_roll_s == 0 ? text : RecordBar::tr("%1, pre-roll %2\u00A0s").arg(text).arg(pre_roll_s);
}

/// A heading that every style draws: not all show the text of a section.
void addHeading(QMenu& menu, const QString& title) {
    if (!menu.isEmpty())
        menu.addSeparator();
    menu.addAction(title)->setEnabled(false);
}

/// One of some lengths in seconds, 0 for none.
template <class Choose>
void addSeconds(QMenu& menu, const QString& title, const int (&choices_s)[4], int chosen_s, Choose choose) {
    addHeading(menu, title);
    for (const int seconds : choices_s) {
        QAction* action =
            menu.addAction(RecordBar::secondsChoice(seconds), &menu, [choose, seconds] { choose(seconds); });
        action->setCheckable(true);
        action->setChecked(seconds == chosen_s);
    }
}

RecordButton::State look(RecordRun::State state) {
    switch (state) {
        case RecordRun::State::kReady:
            return RecordButton::State::kReady;
        case RecordRun::State::kCountdown:
            return RecordButton::State::kCountdown;
        case RecordRun::State::kRecording:
            return RecordButton::State::kRecording;
        case RecordRun::State::kSaving:
            return RecordButton::State::kSaving;
        default:
            return RecordButton::State::kRefused;
    }
}

/// `suits`: that the take records.
QString verbOf(RecordRun::State state, int suits) {
    switch (state) {
        case RecordRun::State::kCountdown:
            return RecordBar::tr("Cancel", "the countdown");
        case RecordRun::State::kRecording:
            return suits < 2    ? RecordBar::tr("Stop")
                   : suits == 2 ? RecordBar::tr("Stop both")
                                : RecordBar::tr("Stop all %1").arg(suits);
        case RecordRun::State::kSaving:
            return RecordBar::tr("Saving");
        default:
            return suits < 2    ? RecordBar::tr("Record")
                   : suits == 2 ? RecordBar::tr("Record both")
                                : RecordBar::tr("Record all %1").arg(suits);
    }
}

/// By the mouse they leave the keyboard with the page.
Button* keyboardFree(Button* button) {
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

}  // namespace

RecordBar::RecordBar(RecordRun& run, QWidget* parent) : QWidget(parent), run_(run) {
    auto* row = makeRow(this, {16, 0, 16, 0}, 6);
    row->addWidget(makeLeft(), 1);
    row->addWidget(makeMiddle());
    row->addWidget(makeRight(), 1);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, &RecordBar::showChoices);
    connect(&Keys::get(), &Keys::changed, this, &RecordBar::showChoices);
    connect(&run, &RecordRun::changed, this, &RecordBar::refresh);
    connect(&run, &RecordRun::ticked, this, [this] {
        if (run_.state() == RecordRun::State::kCountdown)
            button_->setCountdown(run_.countdownLeft(), run_.countdownSeconds());
    });
    refresh();
}

QString RecordBar::secondsChoice(int seconds) {
    return seconds == 0 ? tr("None") : tr("%n second(s)", nullptr, seconds);
}

QWidget* RecordBar::makeLeft() {
    auto* left = new QWidget;
    auto* column = makeColumn(left, {}, 2);
    column->addStretch();
    auto* label = new Label(tr("Take name"), TextRole::kCaption, Ink::kHint);
    name_ = new QLineEdit;
    label->setBuddy(name_);
    name_->setAccessibleName(tr("Take name"));
    followKey(*name_, "record/take_name", Qt::Key_T, [this](const QKeySequence& key) {
        name_->setToolTip(
            tr("Take name (%1). Numbers count by themselves, and nothing is overwritten.", "a key")
                .arg(keysText(key)));
    });
    keepMinimumWidth(*name_, 108);
    keepMaximumWidth(*name_, 180);
    next_ = new Label({}, TextRole::kSecondary, Ink::kHint);
    countdown_ = keyboardFree(makeButton(ButtonKind::kText, {}, "clock"));
    tones_ = keyboardFree(makeButton(ButtonKind::kText, {}, "sound"));
    auto* menu = new QMenu(countdown_);
    countdown_->setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });
    countdown_->setToolTip(
        tr("The countdown gives you time after the button. With a pre-roll the take begins that much earlier "
           "than the recording; be in the rest pose by then."));
    connect(tones_, &QPushButton::clicked, this, [this] { run_.setTones(!run_.tones()); });
    tones_->setToolTip(tr("The system's bell with each second of the countdown, at start and at stop"));
    connect(name_, &QLineEdit::returnPressed, this, &RecordBar::fieldLeft);
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        if (name_->isModified())
            run_.setName(name_->text());
        refresh();
    });
    name_->installEventFilter(this);
    column->addWidget(label);
    auto* field = addRow(column, 8);
    field->addWidget(name_, 1);
    field->addWidget(next_);
    field->addStretch(1);
    auto* choices = addRow(column, 4);
    choices->addWidget(countdown_);
    choices->addWidget(tones_);
    choices->addStretch();
    column->addStretch();
    return left;
}

QWidget* RecordBar::makeMiddle() {
    auto* middle = new QWidget;
    auto* row = makeRow(middle, {}, 16);
    button_ = new RecordButton;
    connect(button_, &QAbstractButton::clicked, &run_, &RecordRun::press);
    verb_ = new Label({}, TextRole::kSection, Ink::kValue, true);
    auto* words = new QWidget;
    auto* column = makeColumn(words, {}, 4);
    column->addStretch();
    column->addWidget(verb_);
    auto* key = new KeyHint(Qt::Key_Space);
    followKey(*key, "record/record", Qt::Key_Space, [key](const QKeySequence& keys) { key->setKeys(keys); });
    column->addWidget(key, 0, Qt::AlignLeft);
    column->addStretch();
    keepMinimumWidth(*words, 64);
    row->addWidget(button_);
    row->addWidget(words);
    return middle;
}

QWidget* RecordBar::makeRight() {
    auto* right = new QWidget;
    auto* outer = makeRow(right);
    outer->addStretch();
    auto* content = new QWidget;
    outer->addWidget(content);
    auto* column = makeColumn(content, {}, 2);
    column->addStretch();
    column->addWidget(new Label(tr("While it runs"), TextRole::kCaption, Ink::kHint));
    marker_ = keyboardFree(makeButton(ButtonKind::kOutlined, tr("Marker"), "marker"));
    note_button_ = keyboardFree(makeButton(ButtonKind::kOutlined, tr("Note"), "note"));
    connect(marker_, &QPushButton::clicked, &run_, &RecordRun::addMarker);
    connect(note_button_, &QPushButton::clicked, this, &RecordBar::writeNote);
    auto* buttons = addRow(column, 8);
    buttons->addWidget(marker_);
    buttons->addWidget(note_button_);
    buttons->addStretch();
    review_ = new QCheckBox(tr("Open in Review after stop"));
    review_->setFocusPolicy(Qt::TabFocus);
    connect(review_, &QCheckBox::clicked, &run_, &RecordRun::setOpensReview);
    note_ = new QLineEdit;
    note_->setAccessibleName(tr("Note"));
    note_->setPlaceholderText(tr("Note at this moment; Enter keeps it"));
    note_->installEventFilter(this);
    connect(note_, &QLineEdit::returnPressed, this, [this] {
        run_.addNote(note_->text());
        closeNote();
    });
    below_ = new QStackedWidget;
    below_->addWidget(review_);
    below_->addWidget(note_);
    below_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    column->addWidget(below_);
    column->addStretch();
    return right;
}

void RecordBar::fillMenu(QMenu& menu) {
    menu.clear();
    addSeconds(menu, tr("Countdown"), CountdownSetting::kChoices_s, run_.countdownSeconds(),
               [](int seconds) { CountdownSetting::get().setSeconds(seconds); });
    if (run_.canPreRoll())
        addSeconds(menu, tr("Pre-roll, from before the recording begins"), kPreRolls_s, run_.preRollSeconds(),
                   [this](int seconds) { run_.setPreRollSeconds(seconds); });
    else if (run_.suitCount() > 1)
        addHeading(menu, tr("No pre-roll: several suits begin together"));
    else
        addHeading(menu, tr("No pre-roll: each stream of this suit begins in the rest pose"));
}

void RecordBar::refresh() {
    const RecordRun::State state = run_.state();
    const bool runs = state == RecordRun::State::kRecording || state == RecordRun::State::kSaving;
    if (!name_->hasFocus() || runs)
        name_->setText(run_.takeName());
    name_->setReadOnly(runs);
    showChoices();
    button_->setState(look(state));
    if (state == RecordRun::State::kCountdown)
        button_->setCountdown(run_.countdownLeft(), run_.countdownSeconds());
    verb_->setText(verbOf(state, run_.suitCount()));
    const QString why = state == RecordRun::State::kRecording
                            ? QString()
                            : tr("Markers and notes belong to a take that is being recorded.");
    marker_->setDisabledBecause(why);
    note_button_->setDisabledBecause(why);
    review_->setChecked(run_.opensReview());
    if (!runs && below_->currentWidget() == note_)
        closeNote();
}

QString RecordBar::verb() const {
    return verb_->text();
}

void RecordBar::showChoices() {
    const RecordRun::State state = run_.state();
    const bool runs = state == RecordRun::State::kRecording || state == RecordRun::State::kSaving;
    const bool narrow = is_laid_out_ && width() < Theme::get().px(kRoomForWords);
    next_->setText(runs ? tr("next: %1").arg(run_.nextName()) : QString());
    next_->setVisible(!narrow);
    const QString countdown = countdownText(run_.countdownSeconds(), run_.preRollSeconds());
    const QString tones = run_.tones() ? tr("Tones on") : tr("Tones off");
    countdown_->setText(narrow ? secondsText(run_.countdownSeconds(), 0) : countdown);
    countdown_->setAccessibleName(countdown);
    tones_->setText(!narrow ? tones : run_.tones() ? tr("on", "tones") : tr("off", "tones"));
    tones_->setAccessibleName(tones);
    marker_->setShortcutHint(narrow ? QKeySequence() : Keys::keyOf("record/marker", Qt::Key_M));
    note_button_->setShortcutHint(narrow ? QKeySequence() : Keys::keyOf("record/note", Qt::Key_N));
}

QSize RecordBar::sizeHint() const {
    return {QWidget::sizeHint().width(), minimumSizeHint().height()};
}

QSize RecordBar::minimumSizeHint() const {
    const QSize least = QWidget::minimumSizeHint();
    return {least.width(), std::max(Theme::get().px(kBarHeight), least.height())};
}

void RecordBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    is_laid_out_ = true;
    showChoices();
}

void RecordBar::editName() {
    name_->setFocus(Qt::ShortcutFocusReason);
    name_->selectAll();
}

void RecordBar::writeNote() {
    if (run_.state() != RecordRun::State::kRecording)
        return;
    below_->setCurrentWidget(note_);
    note_->setFocus(Qt::ShortcutFocusReason);
}

void RecordBar::closeNote() {
    note_->clear();
    below_->setCurrentWidget(review_);
    emit fieldLeft();
}

bool RecordBar::eventFilter(QObject* object, QEvent* event) {
    const bool escape =
        event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
    if (!escape)
        return QWidget::eventFilter(object, event);
    if (object == note_) {
        closeNote();
    } else {
        name_->setModified(false);
        name_->setText(run_.takeName());
        emit fieldLeft();
    }
    return true;
}

}  // namespace noctule::ui
