// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/board_card.h"

#include <QVBoxLayout>
#include <numbers>

#include "core/inertial/reading.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"
#include "ui/views/connect/live_curve.h"
#include "ui/views/connect/pulse_bars.h"
#include "ui/views/readiness_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

constexpr double kTurning_rad_per_s = 200 * std::numbers::pi / 180;
constexpr double kAcceleration_m_per_s2 = 2 * kStandardGravity_m_per_s2;

/// A heading with the range of what is below it at its right end.
void addHeading(QVBoxLayout& column, const QString& words, const QString& range) {
    auto* row = addRow(&column, 8);
    row->addWidget(new Label(words, TextRole::kSecondary, Ink::kLabel), 1);
    row->addWidget(new Label(range, TextRole::kCaption, Ink::kHint));
}

/// Of the axes of one kind, in SI; clipped and lost ones are absent.
std::array<std::optional<double>, 3> inSi(const InertialReading& reading, size_t first,
                                          const AxisCalibration& calibration) {
    std::array<std::optional<double>, 3> values;
    Vector3d counts = calibration.zero_counts;
    for (size_t axis = 0; axis < 3; ++axis)
        counts[static_cast<Eigen::Index>(axis)] =
            reading.counts[first + axis].value_or(counts[static_cast<Eigen::Index>(axis)]);
    const Vector3d si = calibration.apply(counts);
    for (size_t axis = 0; axis < 3; ++axis)
        if (reading.counts[first + axis])
            values[axis] = si[static_cast<Eigen::Index>(axis)];
    return values;
}

}  // namespace

BoardCard::BoardCard(CaptureContext& capture, QWidget* parent)
    : Card(parent),
      capture_(capture),
      title_((new Label({}, TextRole::kSection, Ink::kValue, true))->wrapped()),
      serial_((new Label({}, TextRole::kSecondary, Ink::kLabel))->wrapped()),
      frames_((new Label({}, TextRole::kSecondary, Ink::kLabel))->wrapped()),
      pulses_(new PulseBars),
      turning_(new LiveCurve(tr("Turning rate of the last five seconds"), kTurning_rad_per_s)),
      acceleration_(new LiveCurve(tr("Acceleration of the last five seconds"), kAcceleration_m_per_s2)),
      details_(new QWidget),
      blink_(makeButton(ButtonKind::kOutlined, tr("Blink"), "blink")) {
    setAccessibleName(tr("Chosen board"));
    auto* column = makeColumn(this, {12, 12, 12, 12}, 8);
    column->addWidget(title_);
    column->addWidget(serial_);
    column->addWidget(details_);
    auto* inner = makeColumn(details_, {}, 6);
    addCurves(*inner);
    inner->addWidget(frames_);
    addRow(inner, 0, {0, 4, 0, 0})->addWidget(blink_, 0, Qt::AlignLeft);
    connect(blink_, &QPushButton::clicked, this, [this] { emit blinkRequested(board_); });
    capture.suits().follow(&LiveSuit::frameChanged, this, &BoardCard::showFrame);
    capture.suits().follow(&SuitCheck::changed, this, &BoardCard::showWords);
    capture.suits().follow(&LiveSuit::wearingChanged, this, &BoardCard::showWords);
    capture.suits().follow(&LiveSuit::blinkingChanged, this, &BoardCard::showWords);
    setBoard(-1);
}

void BoardCard::addCurves(QVBoxLayout& column) {
    addHeading(column, tr("Pulses heard"), tr("confidence"));
    column.addWidget(pulses_);
    addHeading(column, tr("Turning rate, 5 s"), QStringLiteral("±200°/s"));
    column.addWidget(turning_);
    addHeading(column, tr("Acceleration, 5 s"), QStringLiteral("±2 g"));
    column.addWidget(acceleration_);
    auto* legend = addRow(&column, 12);
    const std::array letters{"X", "Y", "Z"};
    for (size_t axis = 0; axis < 3; ++axis) {
        auto* letter = new Label({}, TextRole::kSecondary, Ink::kLabel);
        letter->setTextFormat(Qt::RichText);
        const auto paint = [letter, axis, text = QString(letters[axis])] {
            const Tokens& tokens = Theme::get().tokens();
            const QColor color = axis == 0 ? tokens.x : axis == 1 ? tokens.y : tokens.z;
            letter->setText(QStringLiteral("<span style='color:%1'>—</span> %2").arg(color.name(), text));
        };
        paint();
        connect(&Theme::get(), &Theme::changed, letter, paint);
        legend->addWidget(letter);
    }
    legend->addStretch();
}

void BoardCard::setBoard(int board) {
    if (board != board_) {
        turning_->clear();
        acceleration_->clear();
    }
    board_ = board;
    showWords();
    showFrame();
}

void BoardCard::showWords() {
    const Suit& suit = live().suit();
    const bool there = board_ >= 0 && static_cast<size_t>(board_) < suit.boards.size();
    details_->setVisible(there);
    if (!there) {
        title_->setText(tr("No board is chosen"));
        serial_->setText(tr("Choose a board on the body or in the pairs to see what arrives from it."));
        return;
    }
    const Board& board = suit.boards[static_cast<size_t>(board_)];
    title_->setText(
        tr("Board %1, %2", "number, body part").arg(board_ + 1).arg(boardName(board, NameCase::kInside)));
    serial_->setText(board.serial.empty() ? tr("Its serial number is not known")
                                          : tr("Serial %1").arg(QString::fromStdString(board.serial)));
    const bool blinks = live().blinkingBoard() == board_;
    blink_->setText(blinks ? tr("Board %1 blinks").arg(board_ + 1) : tr("Blink board %1").arg(board_ + 1));
    blink_->setDisabledBecause(live().isPlugged(board_) ? QString() : tr("The board is unplugged."));
    const auto frame = live().frame();
    if (!frame || frame->health.boards.size() != suit.boards.size())
        return frames_->setText(boardDetail(check(), board_));
    const BoardHealth& health = frame->health.boards[static_cast<size_t>(board_)];
    frames_->setText(
        tr("%1 of %2 frames a second, %n bit error(s)", nullptr, static_cast<int>(health.bits_corrected))
            .arg(numberText(health.frames_per_s, 0))
            .arg(kInertialFramesPerSecond));
}

void BoardCard::showFrame() {
    const auto frame = live().frame();
    const Suit& suit = live().suit();
    const auto index = static_cast<size_t>(board_);
    if (!isVisible() || !frame || board_ < 0 || index >= suit.boards.size() ||
        frame->health.boards.size() != suit.boards.size())
        return;
    std::vector<double> confidences;
    for (size_t source = 0; source < suit.sources.size(); ++source) {
        const PairHealth& pair = frame->health.pair(static_cast<int>(source), board_);
        constexpr double kRecent_s = 0.15;  // two rounds
        confidences.push_back(pair.age_s && *pair.age_s < kRecent_s ? pair.confidence : -1);
    }
    pulses_->setConfidences(confidences);
    if (index >= frame->readings.size() || !frame->readings[index])
        return;
    const InertialReading& reading = *frame->readings[index];
    const Board& board = suit.boards[index];
    const BoardCalibration* known =
        live().calibration() ? live().calibration()->findBoard(board.id) : nullptr;
    const double t_s = reading.sample / live().status()->hello->sample_rate_hz;
    turning_->add(t_s, inSi(reading, 0,
                            known ? known->gyro : AxisCalibration::nominal(board.gyro_full_scale_rad_per_s)));
    acceleration_->add(
        t_s,
        inSi(reading, 3, known ? known->accel : AxisCalibration::nominal(board.accel_full_scale_m_per_s2)));
}

}  // namespace noctule::ui
