// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/transport_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <array>
#include <cmath>

#include "ui/plots/timeline.h"
#include "ui/style/keys.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr std::array kSpeeds{-1., 0.1, 0.25, 0.5, 1., 2., 4.};

constexpr double kLeastBarWidth = 540;  // pixels at 100 percent: there without words

QString speedText(double speed) {
    return QCoreApplication::translate("TransportBar", "%1×", "speed of playback")
        .arg(QLocale().toString(speed).replace(QLatin1Char('-'), QChar(0x2212)));
}

}  // namespace

TransportBar::TransportBar(ReviewContext& review, Timeline& timeline, QWidget* parent)
    : QWidget(parent), review_(review), timeline_(timeline) {
    build();
    connectStudio();
    refreshRange();
    refreshKeys();
    refreshSettings();
}

void TransportBar::refreshKeys() {
    for (Button* button : {in_, out_, marker_})
        button->setDisabledBecause({});  // the tooltips below are those of enabled ones
    previous_->setMeaning(QStringLiteral("prev"), tr("Previous marker"),
                          Keys::keyOf("review/previous_marker", Qt::Key_Comma));
    next_->setMeaning(QStringLiteral("next"), tr("Next marker"),
                      Keys::keyOf("review/next_marker", Qt::Key_Period));
    loop_->setMeaning(QStringLiteral("loop"), tr("Loop between in and out"),
                      Keys::keyOf("review/loop", QKeySequence("Ctrl+L")));
    const auto key = [](const char* command, const char* usual) {
        return keysText(Keys::keyOf(command, QKeySequence(usual)));
    };
    in_->setToolTip(tr("Set in to the cursor (%1)", "a key").arg(key("review/in", "Ctrl+I")));
    out_->setToolTip(tr("Set out to the cursor (%1)", "a key").arg(key("review/out", "Ctrl+O")));
    marker_->setToolTip(tr("Set a marker at the cursor (%1)", "a key").arg(key("review/marker", "M")));
    marker_->setShortcutHint(Keys::keyOf("review/marker", Qt::Key_M));
    refreshPlaying();
    refreshEnabled();
    fitWords();
}

void TransportBar::build() {
    previous_ = new ToolButton(QStringLiteral("prev"), tr("Previous marker"));
    play_ = new ToolButton(QStringLiteral("play"), tr("Play"));
    play_->setPrimary(true);
    play_->setTargetSize(44, 30);
    next_ = new ToolButton(QStringLiteral("next"), tr("Next marker"));
    loop_ = new ToolButton(QStringLiteral("loop"), tr("Loop between in and out"));
    loop_->setCheckable(true);
    speed_label_ = new Label(tr("Speed"), TextRole::kBody, Ink::kLabel);
    speed_ = new QComboBox;
    for (const double speed : kSpeeds)
        speed_->addItem(speedText(speed), speed);
    speed_->setAccessibleName(tr("Speed"));
    speed_label_->setBuddy(speed_);
    in_ = makeButton(ButtonKind::kOutlined, {}, QStringLiteral("in"));
    out_ = makeButton(ButtonKind::kOutlined, {}, QStringLiteral("out"));
    length_ = new Label({}, TextRole::kBody, Ink::kLabel);
    length_->setAccessibleName(tr("Length between in and out"));
    marker_ = makeButton(ButtonKind::kOutlined, tr("Marker"), QStringLiteral("marker"));
    place();
}

void TransportBar::place() {
    auto* row = new QHBoxLayout(this);
    const auto place = [row] {
        const Theme& theme = Theme::get();
        row->setContentsMargins(theme.px(16), theme.px(8), theme.px(16), theme.px(8));
    };
    place();
    connect(&Theme::get(), &Theme::changed, this, place);
    connect(&Theme::get(), &Theme::changed, this, &TransportBar::fitWords);
    for (QWidget* widget : std::initializer_list<QWidget*>{previous_, play_, next_, loop_})
        row->addWidget(widget);
    row->addSpacing(Theme::get().px(8));
    row->addWidget(speed_label_);
    row->addWidget(speed_);
    row->addStretch(1);
    row->addWidget(in_);
    row->addWidget(out_);
    row->addWidget(length_);
    row->addSpacing(Theme::get().px(8));
    row->addWidget(marker_);
}

void TransportBar::connectStudio() {
    TimeCursor& time = review_.time();
    connect(previous_, &QAbstractButton::clicked, this, [this] { timeline_.goToMarker(-1); });
    connect(next_, &QAbstractButton::clicked, this, [this] { timeline_.goToMarker(1); });
    connect(play_, &QAbstractButton::clicked, &time, &TimeCursor::toggle);
    connect(loop_, &QAbstractButton::clicked, &time, &TimeCursor::setLoop);
    connect(speed_, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { review_.time().setSpeed(speed_->itemData(index).toDouble()); });
    connect(in_, &QAbstractButton::clicked, this, &TransportBar::setIn);
    connect(out_, &QAbstractButton::clicked, this, &TransportBar::setOut);
    connect(marker_, &QAbstractButton::clicked, this, &TransportBar::addMarker);
    connect(&time, &TimeCursor::rangeChanged, this, &TransportBar::refreshRange);
    connect(&time, &TimeCursor::extentChanged, this, &TransportBar::refreshRange);
    connect(&time, &TimeCursor::playingChanged, this, &TransportBar::refreshPlaying);
    connect(&time, &TimeCursor::settingsChanged, this, &TransportBar::refreshSettings);
    connect(&review_.take(), &TakeDocument::opened, this, &TransportBar::refreshEnabled);
    connect(&Keys::get(), &Keys::changed, this, &TransportBar::refreshKeys);
    for (const auto signal : {&TakeDocument::motionChanged, &TakeDocument::runsChanged})
        connect(&review_.take(), signal, this, &TransportBar::refreshRange);
}

void TransportBar::refreshRange() {
    const TimeCursor& time = review_.time();
    const double length_s = time.out() - time.in();
    const auto frames = static_cast<qint64>(std::llround(length_s / time.frameStep()));
    length_->setText(tr("%1, %2 frames", "length between in and out", static_cast<int>(frames))
                         .arg(secondsText(length_s, 2), countText(frames)));
    fitWords();
}

/// As many words as have room: first the length goes, then the label of the speed, then those on buttons,
/// then air.
void TransportBar::fitWords() {
    const TimeCursor& time = review_.time();
    const QString in = timeText(time.in(), 2), out = timeText(time.out(), 2);
    in_->setAccessibleName(tr("In %1").arg(in));
    out_->setAccessibleName(tr("Out %1").arg(out));
    marker_->setAccessibleName(tr("Marker"));
    for (QWidget* part : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        part->ensurePolished();  // else it measures another font
    for (int words = 3; words >= -1; --words) {
        layout()->setSpacing(Theme::get().px(words < 0 ? 4 : 8));
        length_->setVisible(words > 2);
        speed_label_->setVisible(words > 1);
        in_->setText(words > 0 ? tr("In %1").arg(in) : in);
        out_->setText(words > 0 ? tr("Out %1").arg(out) : out);
        marker_->setText(words > 0 ? tr("Marker") : QString());
        layout()->invalidate();
        if (layout()->totalMinimumSize().width() <= width())
            break;
    }
}

void TransportBar::resizeEvent(QResizeEvent*) {
    fitWords();
}

QSize TransportBar::minimumSizeHint() const {
    return {Theme::get().px(kLeastBarWidth), QWidget::minimumSizeHint().height()};
}

void TransportBar::refreshPlaying() {
    const bool playing = review_.time().isPlaying();
    play_->setMeaning(playing ? QStringLiteral("pause") : QStringLiteral("play"),
                      playing ? tr("Pause") : tr("Play"), Keys::keyOf("review/play", Qt::Key_Space));
}

void TransportBar::refreshSettings() {
    const TimeCursor& time = review_.time();
    loop_->setChecked(time.loops());
    int nearest = 0;
    for (int i = 1; i < speed_->count(); ++i)
        if (std::abs(speed_->itemData(i).toDouble() - time.speed()) <
            std::abs(speed_->itemData(nearest).toDouble() - time.speed()))
            nearest = i;
    speed_->setCurrentIndex(nearest);
}

void TransportBar::refreshEnabled() {
    const QString reason = review_.take().isOpen() ? QString() : tr("Open a take first");
    for (ToolButton* button : {previous_, play_, next_, loop_})
        button->setDisabledBecause(reason);
    for (Button* button : {in_, out_, marker_})
        button->setDisabledBecause(reason);
}

void TransportBar::setIn() {
    TimeCursor& time = review_.time();
    time.chooseRange(time.time(), std::max(time.time(), time.out()));
}

void TransportBar::setOut() {
    TimeCursor& time = review_.time();
    time.chooseRange(std::min(time.in(), time.time()), time.time());
}

void TransportBar::addMarker() {
    review_.markers().add(review_.time().time());
}

}  // namespace noctule::ui
