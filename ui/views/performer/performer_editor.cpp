// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/performer_editor.h"

#include <algorithm>

#include "core/math/rotation.h"
#include "core/suit/default_suit.h"
#include "ui/models/part_names.h"

namespace noctule::ui {
namespace {

QString words(const std::string& text) {
    return QString::fromStdString(text);
}

bool isBoard(SuitPart part) {
    return part.kind == SuitPart::Kind::kBoard;
}

template <class Part>
const Part* partAt(const std::vector<Part>& parts, int index) {
    return index >= 0 && index < static_cast<int>(parts.size()) ? &parts[static_cast<size_t>(index)]
                                                                : nullptr;
}

}  // namespace

PerformerEditor::PerformerEditor(SessionModel& session, QObject* parent)
    : QObject(parent), session_(session) {
    connect(&session, &SessionModel::opened, this, &PerformerEditor::followOpened);
    connect(&session, &SessionModel::changed, this, &PerformerEditor::follow);
    followOpened();
}

const Performer& PerformerEditor::performer() const {
    return session_.session().performers.at(static_cast<size_t>(index_));
}

void PerformerEditor::followOpened() {
    index_ = -1;
    part_ = {};
    if (session_.isOpen()) {
        const Session& session = session_.session();
        const Performer* current = session.findPerformer(session.current_performer);
        index_ = current ? static_cast<int>(current - session.performers.data()) : 0;
    }
    follow();
    emit partChanged();
}

void PerformerEditor::follow() {
    const int count = session_.isOpen() ? static_cast<int>(session_.session().performers.size()) : 0;
    index_ = std::min(index_, count - 1);
    if (hasPerformer()) {
        actor_ = defaultActor(performer().measures);
        suits_places_ = suitOnActor(defaultSuit(), actor_);
        if (!board() && !source() && part_ != SuitPart{})
            choosePart({});
    }
    emit performerChanged();
}

void PerformerEditor::choose(int performer) {
    if (performer == index_ || !session_.isOpen())
        return;
    index_ = performer;
    follow();
    emit partChanged();
}

void PerformerEditor::choosePart(SuitPart part) {
    if (part == part_)
        return;
    part_ = part;
    emit partChanged();
}

const Board* PerformerEditor::board() const {
    return hasPerformer() && isBoard(part_) ? partAt(performer().suit.boards, part_.index) : nullptr;
}

const Source* PerformerEditor::source() const {
    const bool is_source = hasPerformer() && part_.kind == SuitPart::Kind::kSource;
    return is_source ? partAt(performer().suit.sources, part_.index) : nullptr;
}

QString PerformerEditor::partTitle() const {
    if (board())
        return boardTitle(performer().suit, part_.index);
    return source() ? sourceTitle(performer().suit, part_.index) : QString();
}

const Board* PerformerEditor::standardOf(const Board& board) const {
    return partAt(suits_places_.boards, suits_places_.findBoard(board.id));
}

const Source* PerformerEditor::standardOf(const Source& source) const {
    return partAt(suits_places_.sources, suits_places_.findSource(source.id));
}

bool PerformerEditor::isKnownToSuit() const {
    return (board() && standardOf(*board())) || (source() && standardOf(*source()));
}

std::optional<PerformerEditor::Offset> PerformerEditor::offsetOf(SuitPart part) const {
    const Suit& suit = performer().suit;
    if (isBoard(part)) {
        const Board* placed = partAt(suit.boards, part.index);
        const Board* standard = placed ? standardOf(*placed) : nullptr;
        if (!standard || standard->segment != placed->segment)
            return std::nullopt;
        return Offset{(placed->p_segment_board_m - standard->p_segment_board_m).norm(),
                      angleBetween(placed->q_segment_board, standard->q_segment_board)};
    }
    const Source* placed = partAt(suit.sources, part.index);
    const Source* standard = placed ? standardOf(*placed) : nullptr;
    if (!standard || standard->segment != placed->segment)
        return std::nullopt;
    return Offset{(placed->p_segment_source_m - standard->p_segment_source_m).norm(),
                  logQuaternion(smallestRotation(placed->normal_segment, standard->normal_segment)).norm()};
}

bool PerformerEditor::hasOtherSide() const {
    return (board() && boardOnOtherSide(performer().suit, part_.index) >= 0) ||
           (source() && sourceOnOtherSide(performer().suit, part_.index) >= 0);
}

QString PerformerEditor::freeName(const QString& wanted, const std::string& own) const {
    const QString base = wanted.trimmed();
    const auto isTaken = [&](const std::string& name) {
        return name != own && session_.session().findPerformer(name);
    };
    QString name = base;
    for (int number = 2; isTaken(name.toStdString()); ++number)
        name = tr("%1 (%2)", "name of a performer, number").arg(base).arg(number);
    return name;
}

void PerformerEditor::add() {
    if (!session_.isOpen())
        return;
    Performer performer;
    QString name;
    int number = static_cast<int>(session_.session().performers.size());
    do
        name = tr("Performer %1").arg(++number);
    while (session_.session().findPerformer(name.toStdString()));
    performer.name = name.toStdString();
    performer.suit = defaultSuit();
    session_.addPerformer(performer);
    choose(static_cast<int>(session_.session().performers.size()) - 1);
}

void PerformerEditor::duplicate() {
    if (!hasPerformer())
        return;
    Performer copy = performer();
    copy.name = freeName(words(copy.name), {}).toStdString();
    session_.addPerformer(copy);
    choose(static_cast<int>(session_.session().performers.size()) - 1);
}

void PerformerEditor::remove() {
    if (hasPerformer())
        session_.removePerformer(index_);
}

void PerformerEditor::rename(const QString& name) {
    if (!hasPerformer() || name.trimmed().isEmpty() || name.trimmed().toStdString() == performer().name)
        return;
    Performer renamed = performer();
    renamed.name = freeName(name, performer().name).toStdString();
    if (renamed.name == performer().name)
        emit performerChanged();  // the name that was typed is not shown
    else
        session_.changePerformer(index_, renamed, tr("Rename %1").arg(words(performer().name)));
}

void PerformerEditor::wearSuit() {
    if (hasPerformer())
        session_.setCurrentPerformer(words(performer().name));
}

void PerformerEditor::changeMeasures(const BodyMeasures& measures, const QString& what, const QString& key) {
    Performer changed = performer();
    setMeasures(changed, measures);
    session_.changePerformer(index_, changed, what, QString("measure/%1/%2").arg(index_).arg(key));
}

void PerformerEditor::setHeight(double height_m) {
    if (!hasPerformer() || height_m == performer().measures.height_m)
        return;
    BodyMeasures measures = performer().measures;
    measures.height_m = height_m;
    changeMeasures(measures, tr("Height of %1").arg(words(performer().name)), "height");
}

void PerformerEditor::setLength(double BodyMeasures::*length, double length_m) {
    if (!hasPerformer() || length_m == performer().measures.*length)
        return;
    BodyMeasures measures = performer().measures;
    measures.*length = length_m;
    const auto all = bodyMeasures();
    const auto measure =
        std::find_if(all.begin(), all.end(), [&](const Measure& m) { return m.length == length; });
    changeMeasures(measures, tr("Measure of %1").arg(words(performer().name)),
                   measure == all.end() ? "" : measure->key);
}

void PerformerEditor::changePart(const QString& what, const QString& key,
                                 const std::function<void(Board&)>& change_board,
                                 const std::function<void(Source&)>& change_source) {
    if (!board() && !source())
        return;
    Performer changed = performer();
    const auto at = static_cast<size_t>(part_.index);
    if (board())
        change_board(changed.suit.boards[at]);
    else
        change_source(changed.suit.sources[at]);
    const QString merge = key.isEmpty() ? QString()
                                        : QString("place/%1/%2/%3/%4")
                                              .arg(index_)
                                              .arg(static_cast<int>(part_.kind))
                                              .arg(part_.index)
                                              .arg(key);
    session_.changePerformer(index_, changed, what.arg(partTitle()), merge);
}

void PerformerEditor::setSegment(const std::string& segment) {
    changePart(
        tr("Segment of %1"), {}, [&](Board& board) { board.segment = segment; },
        [&](Source& source) { source.segment = segment; });
}

void PerformerEditor::setPosition(const Vector3d& p_segment_m) {
    changePart(
        tr("Position of %1"), "position", [&](Board& board) { board.p_segment_board_m = p_segment_m; },
        [&](Source& source) { source.p_segment_source_m = p_segment_m; });
}

void PerformerEditor::setRotation(const Quaterniond& q_segment_board) {
    if (board())
        changePart(tr("Rotation of %1"), "rotation",
                   [&](Board& board) { board.q_segment_board = q_segment_board.normalized(); }, {});
}

void PerformerEditor::setDirection(const SourceDirection& direction) {
    if (source())
        changePart(tr("Direction of %1"), "direction", {},
                   [&](Source& source) { source.normal_segment = normalFrom(direction); });
}

void PerformerEditor::drag(SuitPart part, const Vector3d& p_segment_m, const Quaterniond& q_segment) {
    choosePart(part);
    changePart(
        tr("Move %1"), QString("drag-%1").arg(drag_),
        [&](Board& board) {
            board.p_segment_board_m = p_segment_m;
            board.q_segment_board = q_segment.normalized();
        },
        [&](Source& source) {
            source.p_segment_source_m = p_segment_m;
            source.normal_segment = (q_segment * Vector3d::UnitZ()).normalized();
        });
}

void PerformerEditor::mirror() {
    if (!hasOtherSide())
        return;
    Performer changed = performer();
    Suit& suit = changed.suit;
    if (const Board* chosen = board()) {
        const Board image = mirrorBoard(*chosen);
        Board& other = suit.boards[static_cast<size_t>(boardOnOtherSide(suit, part_.index))];
        other.segment = image.segment;
        other.p_segment_board_m = image.p_segment_board_m;
        other.q_segment_board = image.q_segment_board;
    } else {
        const Source image = mirrorSource(*source());
        Source& other = suit.sources[static_cast<size_t>(sourceOnOtherSide(suit, part_.index))];
        other.segment = image.segment;
        other.p_segment_source_m = image.p_segment_source_m;
        other.normal_segment = image.normal_segment;
    }
    session_.changePerformer(index_, changed, tr("Mirror %1").arg(partTitle()));
}

void PerformerEditor::backToSuit() {
    if (!isKnownToSuit())
        return;
    changePart(
        tr("Put %1 back"), {},
        [this](Board& board) {
            const Board& standard = *standardOf(board);
            board.segment = standard.segment;
            board.p_segment_board_m = standard.p_segment_board_m;
            board.q_segment_board = standard.q_segment_board;
        },
        [this](Source& source) {
            const Source& standard = *standardOf(source);
            source.segment = standard.segment;
            source.p_segment_source_m = standard.p_segment_source_m;
            source.normal_segment = standard.normal_segment;
        });
}

}  // namespace noctule::ui
