// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/assign_panel.h"

#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "core/session/placement.h"
#include "ui/models/part_names.h"
#include "ui/style/lengths.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/label.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

constexpr int kLongSearch_s = 10;  ///< without a find: the reason is told

/// Each gets the place of the other.
void exchangePlaces(Board& a, Board& b) {
    std::swap(a.segment, b.segment);
    std::swap(a.p_segment_board_m, b.p_segment_board_m);
    std::swap(a.q_segment_board, b.q_segment_board);
}

}  // namespace

AssignPanel::AssignPanel(CaptureContext& capture, QWidget* parent)
    : QWidget(parent),
      capture_(capture),
      performers_(new QComboBox),
      segments_(new QComboBox),
      measures_((new Label({}, TextRole::kSecondary, Ink::kLabel))->wrapped()),
      explained_((new Label({}, TextRole::kSecondary, Ink::kLabel))->wrapped()),
      find_(makeButton(ButtonKind::kOutlined, tr("Find by moving"), "follow")),
      assign_(makeButton(ButtonKind::kOutlined, tr("Assign"))),
      found_row_(new QWidget) {
    auto* column = makeColumn(this);
    column->addWidget(new Divider);
    addWornBy(*column);
    column->addWidget(new Divider);
    addAssign(*column);
    capture_.suits().follow(&LiveSuit::wearingChanged, this, &AssignPanel::showPerformers);
    connect(&capture_.shared().session(), &SessionModel::changed, this, &AssignPanel::showPerformers);
    connect(&capture_.shared().session(), &SessionModel::opened, this, &AssignPanel::showPerformers);
    capture_.suits().follow(&LiveSuit::wearingChanged, this, &AssignPanel::showSuit);
    capture_.suits().follow(&LiveSuit::phaseChanged, this, &AssignPanel::showSuit);
    capture_.suits().follow(&LiveSuit::frameChanged, this, &AssignPanel::listen);
    connect(&capture_.suits(), &LiveSuits::currentChanged, this, [this] {
        if (isFinding())
            find(false);
    });
    showPerformers();
    showSuit();
}

void AssignPanel::addWornBy(QVBoxLayout& column) {
    auto* part = new QWidget;
    auto* rows = makeColumn(part, {12, 8, 12, 12}, 8);
    rows->addWidget(new SectionHeader(tr("Worn by")));
    rows->addWidget(performers_);
    rows->addWidget(measures_);
    performers_->setAccessibleName(tr("Worn by"));
    column.addWidget(part);
    connect(performers_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        if (capture_.shared().session().isOpen())
            capture_.suits().setPerformer(capture_.suits().current(), performers_->itemText(index));
    });
}

void AssignPanel::addAssign(QVBoxLayout& column) {
    auto* part = new QWidget;
    auto* rows = makeColumn(part, {12, 8, 12, 12}, 8);
    rows->addWidget(new SectionHeader(tr("Assign boards")));
    rows->addWidget(explained_);
    addRow(rows)->addWidget(find_, 0, Qt::AlignLeft);
    auto* found = makeRow(found_row_, {}, 8);
    found->addWidget(segments_, 1);
    found->addWidget(assign_);
    segments_->setAccessibleName(tr("Body part of the board that was found"));
    rows->addWidget(found_row_);
    column.addWidget(part);
    connect(find_, &QPushButton::clicked, this, [this] { find(!isFinding()); });
    connect(assign_, &QPushButton::clicked, this, &AssignPanel::assign);
}

void AssignPanel::showPerformers() {
    const QSignalBlocker quiet(performers_);
    performers_->clear();
    const SessionModel& model = capture_.shared().session();
    if (!model.isOpen()) {
        performers_->addItem(SessionModel::firstPerformer());
        performers_->setEnabled(false);
        measures_->setText(tr("Performers belong to a session. The first take makes one by date."));
        return;
    }
    performers_->setEnabled(true);
    for (const Performer& performer : model.session().performers)
        performers_->addItem(QString::fromStdString(performer.name));
    const std::string current = wearer();
    performers_->setCurrentIndex(performers_->findText(QString::fromStdString(current)));
    if (const Performer* performer = model.session().findPerformer(current))
        measures_->setText(
            tr("%1, suit “%2”", "height, name")
                .arg(lengthText(performer->measures.height_m), QString::fromStdString(performer->suit.name)));
}

/// Of the suit that is looked at; of none the session's current performer.
std::string AssignPanel::wearer() const {
    const std::string& worn_by = capture_.suit().wearing().performer;
    return worn_by.empty() ? capture_.shared().session().session().current_performer : worn_by;
}

void AssignPanel::showSuit() {
    const Suit& suit = capture_.suit().suit();
    const bool there = !suit.boards.empty();
    if (!there && isFinding())
        return find(false);
    find_->setText(isFinding() ? tr("Stop finding") : tr("Find by moving"));
    find_->setDisabledBecause(there ? QString() : tr("Connect a suit first"));
    found_row_->setVisible(isFinding() && found_ >= 0);
    if (!isFinding())
        explained_->setText(tr("Drag a board onto a body part, or press Find and move the limb."));
    else if (found_ < 0)
        explained_->setText(listeningWords());
    else
        explained_->setText(tr("Board %1 moves. Which body part is it?").arg(found_ + 1));
    const int chosen = segments_->currentIndex();
    segments_->clear();
    for (const Board& board : suit.boards)
        segments_->addItem(boardName(board));
    segments_->setCurrentIndex(found_ >= 0 ? found_ : chosen);
}

QString AssignPanel::listeningWords() const {
    const QString what = tr("Move one limb, the end of it most, and keep all others still.");
    const QString heard = tr("Listening for %n s.", nullptr, heard_s_);
    if (heard_s_ < kLongSearch_s)
        return what + ' ' + heard;
    return tr("No board moves more than all others yet. Turn the limb faster; a board that stays silent is "
              "not found.") +
           ' ' + heard;
}

QString AssignPanel::words() const {
    return explained_->text();
}

void AssignPanel::find(bool on) {
    found_ = -1;
    finder_.reset();
    if (on)
        listenAnew();
    emit boardFound(-1);
    showSuit();
}

void AssignPanel::listenAnew() {
    heard_s_ = 0;
    first_sample_.reset();
    const auto hello = capture_.suit().status()->hello;
    if (!hello)
        return;
    sample_rate_hz_ = hello->sample_rate_hz;
    finder_ = std::make_unique<MovingBoard>(capture_.suit().suit(), hello->sample_rate_hz);
}

void AssignPanel::listen() {
    const auto frame = capture_.suit().frame();
    if (!finder_ || !frame || frame->readings.size() != capture_.suit().suit().boards.size())
        return;
    if (first_sample_ && frame->sample < last_sample_)
        listenAnew();  // a stream that begins anew counts from zero
    last_sample_ = frame->sample;
    for (const auto& reading : frame->readings)
        if (reading)
            finder_->add(*reading);
    if (!first_sample_)
        first_sample_ = frame->sample;
    const int heard_s = static_cast<int>((frame->sample - *first_sample_) / sample_rate_hz_);
    if (std::exchange(heard_s_, heard_s) != heard_s && found_ < 0)
        explained_->setText(listeningWords());
    const std::optional<int> moves = finder_->found();
    if (!moves || *moves == found_)
        return;
    found_ = *moves;
    showSuit();
    emit boardFound(found_);
}

void AssignPanel::assign() {
    const int onto = segments_->currentIndex(), board = found_;
    find(false);
    if (board >= 0 && onto >= 0 && onto != board)
        swap(board, onto);
}

void AssignPanel::swap(int board, int with) {
    SessionModel& model = capture_.shared().session();
    Suit suit = capture_.suit().suit();
    const auto count = static_cast<int>(suit.boards.size());
    if (board < 0 || with < 0 || board >= count || with >= count || board == with ||
        !capture_.shared().session().makeSure())
        return;
    suit = capture_.suit().suit();
    const QString names = tr("Swap boards %1 and %2").arg(board + 1).arg(with + 1);
    exchangePlaces(suit.boards[static_cast<size_t>(board)], suit.boards[static_cast<size_t>(with)]);
    const auto& performers = model.session().performers;
    for (size_t i = 0; i < performers.size(); ++i)
        if (performers[i].name == wearer()) {
            Performer performer = performers[i];
            suit.name = performer.suit.name;
            const LiveSuit& live = capture_.suit();
            performer.suit =
                live.known().actor ? suitOnActor(suit, live.actor(), defaultActor(performer.measures)) : suit;
            model.changePerformer(static_cast<int>(i), performer, names);
            return;
        }
}

}  // namespace noctule::ui
