// SPDX-License-Identifier: Apache-2.0
#include "ui/models/calibration_shelf.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>

#include "core/job/atomic_file.h"
#include "core/processing/outside_files.h"
#include "core/session/body_measures.h"
#include "core/session/placement.h"
#include "ui/language/core_words.h"

namespace noctule::ui {
namespace {

constexpr const char* kUnfinished = ".unfinished.json";

std::string pathIn(const QString& folder, const QString& file) {
    return QDir(folder).filePath(file).toStdString();
}

template <class Parts, class Calibrations>
void addStrangers(const Parts& parts, const Calibrations& calibrations, QStringList& strangers) {
    for (const auto& part : parts)
        for (const auto& calibrated : calibrations)
            if (calibrated.id == part.id && !calibrated.serial.empty() && !part.serial.empty() &&
                calibrated.serial != part.serial)
                strangers.append(QString::fromStdString(part.id));
}

/// The first serial number that the calibration names and that is not `other_than`.
QString nameOfOwner(const Calibration& calibration, const QString& other_than) {
    QStringList serials{QString::fromStdString(calibration.box_serial)};
    for (const BoardCalibration& board : calibration.boards)
        serials.append(QString::fromStdString(board.serial));
    for (const SourceCalibration& source : calibration.sources)
        serials.append(QString::fromStdString(source.serial));
    serials.removeAll({});
    serials.removeAll(other_than);
    return serials.value(0);
}

/// Adds the suit's serial numbers to the calibration that it brought itself, where none is stated.
void nameSuit(Calibration& calibration, const LiveSuit& suit) {
    if (calibration.box_serial.empty())
        calibration.box_serial = suit.serial().toStdString();
    for (BoardCalibration& board : calibration.boards)
        if (const int index = suit.suit().findBoard(board.id); index >= 0 && board.serial.empty())
            board.serial = suit.suit().boards[static_cast<size_t>(index)].serial;
    for (SourceCalibration& source : calibration.sources)
        if (const int index = suit.suit().findSource(source.id); index >= 0 && source.serial.empty())
            source.serial = suit.suit().sources[static_cast<size_t>(index)].serial;
}

}  // namespace

QDateTime ShelvedCalibration::made() const {
    return QDateTime::fromString(QString::fromStdString(calibration.created_utc), Qt::ISODate);
}

CalibrationShelf::CalibrationShelf(SessionModel& session, LiveSuit& suit, const QString& suits_folder,
                                   QObject* parent)
    : QObject(parent), session_(session), suit_(suit), memory_(suits_folder) {
    connect(&session_, &SessionModel::opened, this, &CalibrationShelf::follow);
    connect(&session_, &SessionModel::changed, this, &CalibrationShelf::follow);
    connect(&suit_, &LiveSuit::phaseChanged, this, [this] {
        if (suit_.phase() == LiveSuit::Phase::kNone) {
            handed_.reset();
            remembered_.reset();
            newer_.reset();
        }
        follow();  // the session may name a file for this suit alone
        hand();
    });
}

QString CalibrationShelf::folder() const {
    return session_.isOpen() ? QString::fromStdString(session_.session().calibrationFolder().string())
                             : QString();
}

QString CalibrationShelf::fileInForce() const {
    if (!session_.isOpen())
        return {};
    const auto& own = session_.session().suit_calibrations;
    const auto found = own.find(suit_.serial().toStdString());
    return QString::fromStdString(found != own.end() ? found->second : session_.session().calibration);
}

/// The session names a file for this suit alone.
bool CalibrationShelf::isOwnFile() const {
    return session_.isOpen() && session_.session().suit_calibrations.contains(suit_.serial().toStdString());
}

CalibrationOwner CalibrationShelf::ownerOf(const Calibration& calibration) const {
    return noctule::ownerOf(calibration, suit_.suit(), suit_.serial().toStdString());
}

void CalibrationShelf::setBeside(bool beside) {
    if (std::exchange(is_beside_, beside) != beside)
        hand();
}

std::optional<Calibration> CalibrationShelf::inForce() const {
    const ShelvedCalibration* chosen = chosenFile();
    return chosen ? std::optional(chosen->calibration) : suit_.calibration();
}

/// The session names it for no suit in particular, and it is not this one's.
bool CalibrationShelf::isLeftToOthers(const Calibration& calibration) const {
    const CalibrationOwner owner = ownerOf(calibration);
    return !isOwnFile() &&
           (is_beside_ ? owner != CalibrationOwner::kThisSuit : owner == CalibrationOwner::kAnotherSuit);
}

/// Null: the session has none for this suit.
const ShelvedCalibration* CalibrationShelf::chosenFile() const {
    const auto found = std::ranges::find(all_, fileInForce(), &ShelvedCalibration::file);
    return found == all_.end() || isLeftToOthers(found->calibration) ? nullptr : &*found;
}

bool CalibrationShelf::isInForce(const ShelvedCalibration& shelved) const {
    const ShelvedCalibration* chosen = chosenFile();
    return chosen && chosen->file == shelved.file;
}

void CalibrationShelf::follow() {
    if (folder() == folder_ && fileInForce() == in_force_) {
        // Another suit of the session has saved one, or somebody put one there.
        if (const QStringList found = files(); found != files_) {
            const bool was_there = isInForceThere();
            read(found);
            if (was_there)
                warnIfGone();
            emit changed();
        }
        hand();  // it may have become this suit's own, or not be any more
        return;
    }
    const bool is_same_session = folder() == folder_;
    const QString before = std::exchange(in_force_, fileInForce());
    folder_ = folder();
    emit replaced();
    read(files());
    warnIfGone();
    if (is_same_session)
        noteWhatWasTakenBack(before);
    else
        taken_back_.clear();
    hand();
    emit changed();
}

/// Undone, or gone back from: then none is in force, or one that was made earlier. `before`: what was in
/// force.
void CalibrationShelf::noteWhatWasTakenBack(const QString& before) {
    const auto placeOf = [this](const QString& file) {
        return std::ranges::find(all_, file, &ShelvedCalibration::file);
    };
    const auto was = placeOf(before), is = placeOf(in_force_);
    if (was != all_.end() && was < is)  // the latest stand first
        taken_back_.push_back(was->calibration);
}

QStringList CalibrationShelf::files() const {
    QStringList files = folder_.isEmpty() ? QStringList() : QDir(folder_).entryList({"*.json"}, QDir::Files);
    const auto is_unfinished = [](const QString& file) { return file.endsWith(kUnfinished); };
    files.erase(std::remove_if(files.begin(), files.end(), is_unfinished), files.end());
    return files;
}

void CalibrationShelf::read(const QStringList& files) {
    all_.clear();
    files_ = files;
    if (folder_.isEmpty())
        return;
    for (const QString& file : files_) {
        if (auto calibration = readCalibrationFile(pathIn(folder_, file)))
            all_.push_back({file, std::move(*calibration)});
    }
    std::ranges::stable_sort(all_, std::greater(), [](const ShelvedCalibration& shelved) {
        return std::make_pair(shelved.calibration.created_utc, shelved.file);
    });
}

bool CalibrationShelf::isInForceThere() const {
    return in_force_.isEmpty() || std::ranges::find(all_, in_force_, &ShelvedCalibration::file) != all_.end();
}

void CalibrationShelf::warnIfGone() {
    if (!folder_.isEmpty() && !isInForceThere())
        emit warned(
            tr("The calibration %1 of this session is gone or damaged. Takes are made with what the suit "
               "knows of itself; choose another one in step Calibrate.")
                .arg(in_force_));
}

QStringList CalibrationShelf::strangers(const Calibration& calibration) const {
    QStringList strangers;
    addStrangers(suit_.suit().boards, calibration.boards, strangers);
    addStrangers(suit_.suit().sources, calibration.sources, strangers);
    return strangers;
}

bool CalibrationShelf::isOfAnotherSuit(const ShelvedCalibration& shelved) const {
    if (isInForce(shelved))
        return false;
    const std::string own = suit_.serial().toStdString();
    for (const auto& [serial, file] : session_.session().suit_calibrations)
        if (serial != own && file == shelved.file.toStdString())
            return !own.empty();
    return ownerOf(shelved.calibration) == CalibrationOwner::kAnotherSuit;
}

QString CalibrationShelf::otherSuitOf(const QString& path) const {
    const auto calibration = readCalibrationFile(path.toStdString());
    return calibration ? otherSuitOf(*calibration) : QString();
}

QString CalibrationShelf::otherSuitOf(const Calibration& calibration) const {
    return ownerOf(calibration) == CalibrationOwner::kAnotherSuit ? nameOfOwner(calibration, suit_.serial())
                                                                  : QString();
}

/// A suit that brought its own calibration keeps it until the session has one; one that brought none gets
/// what earlier sessions found of its parts.
void CalibrationShelf::hand() {
    if (suit_.phase() != LiveSuit::Phase::kLooking)
        return;
    const ShelvedCalibration* found = chosenFile();
    if (!found) {
        newer_.reset();
        if (std::exchange(handed_, std::nullopt))
            suit_.takeOwnCalibration();
        if (!suit_.calibration())
            recall();
        return;
    }
    const QString path = QDir(folder_).filePath(in_force_);
    if (handed_ && *handed_ == path)
        return;
    handed_ = path;
    emit replaced();
    remembered_.reset();
    newer_ = found->calibration;
    if (const auto kept = memory_.latest(suit_.serial()); !kept || !takeNewerParts(*newer_, *kept))
        newer_.reset();
    warnOfStrangers(found->calibration);
    suit_.setCalibration(found->calibration);
}

void CalibrationShelf::warnOfStrangers(const Calibration& calibration) {
    if (const QStringList others = strangers(calibration); !others.isEmpty())
        emit warned(tr("The calibration %1 was made with other parts than those connected now: %2. Calibrate "
                       "those before takes with them can be relied on.")
                        .arg(in_force_, others.join(", ")));
    else if (const QString other = otherSuitOf(calibration); !other.isEmpty())
        emit warned(
            tr("The calibration %1 was made for another suit, %2. Calibrate %3 before takes with it can be "
               "relied on.",
               "file, serial numbers")
                .arg(in_force_, other, suit_.serial()));
}

void CalibrationShelf::recall() {
    remembered_ = memory_.latest(suit_.serial(), taken_back_);
    if (!remembered_)
        return;
    const QDateTime made = ShelvedCalibration{{}, *remembered_}.made();
    suit_.setCalibration(remembered_);
    emit told(
        tr("%1: the calibration of its sensors and sources from an earlier session is in use (made %2).",
           "serial number, date")
            .arg(suit_.serial(), QLocale().toString(made.toLocalTime().date(), QLocale::ShortFormat)));
    if (const QStringList others = strangers(*remembered_); !others.isEmpty())
        emit warned(tr("Parts of %1 were exchanged since it was calibrated: %2. Calibrate those before takes "
                       "with them can be relied on.")
                        .arg(suit_.serial(), others.join(", ")));
    emit changed();
}

void CalibrationShelf::remember(const Calibration& calibration) {
    if (suit_.phase() == LiveSuit::Phase::kNone || ownerOf(calibration) == CalibrationOwner::kAnotherSuit)
        return;
    if (const Status kept = memory_.keep(suit_.serial(), calibration); !kept)
        emit warned(
            tr("The calibration could not be kept for other sessions. %1.").arg(coreWords(kept.error())));
}

QString CalibrationShelf::write(const Calibration& calibration, const QString& name) const {
    QDir().mkpath(folder_);
    const Status written =
        writeFileAtomically(pathIn(folder_, name), toJson(calibration).dump(2) + "\n", false);
    return written ? QString() : coreWords(written.error());
}

QString CalibrationShelf::useNewer() {
    if (!newer_ || folder_.isEmpty())
        return tr("No session is open. Open one first.");
    const QString name = nextName("sensors") + ".json";
    const QString trouble = write(*newer_, name);
    if (trouble.isEmpty())
        use(name, tr("Newer values of the suit"));
    return trouble;
}

QString CalibrationShelf::importFile(const QString& path) {
    const auto calibration = readCalibrationFile(path.toStdString());
    if (!calibration)
        return coreWords(calibration.error()) + '.';
    const auto& boards = suit_.suit().boards;
    const bool knows_some = std::ranges::any_of(
        boards, [&](const Board& board) { return calibration->findBoard(board.id) != nullptr; });
    if (!boards.empty() && !knows_some)
        return tr("%1 knows none of the boards of %2. Choose the calibration of this suit.")
            .arg(QFileInfo(path).fileName(), suit_.serial());
    if (!session_.makeSure())
        return tr("There is no session to keep the calibration in, and none could be made. Make one first.");
    const QString name = nextName(QFileInfo(path).completeBaseName()) + ".json";
    if (const QString trouble = write(*calibration, name); !trouble.isEmpty())
        return trouble + '.';
    remember(*calibration);
    use(name, tr("Importing %1").arg(QFileInfo(path).fileName()));
    return {};
}

QString CalibrationShelf::exportFile(const QString& path) const {
    auto calibration = inForce();
    if (!calibration)
        return tr("There is no calibration to export. Calibrate the suit first.");
    if (!chosenFile())
        nameSuit(*calibration, suit_);
    const Status written = writeFileAtomically(path.toStdString(), toJson(*calibration).dump(2) + "\n", true);
    return written ? QString() : coreWords(written.error()) + '.';
}

QString CalibrationShelf::nextName(const QString& task) const {
    const QString day = QDate::currentDate().toString(Qt::ISODate);
    QString name = QStringLiteral("%1-%2").arg(task, day);
    const auto is_taken = [this](const QString& file) {  // one that was put aside may come back
        return QFile::exists(QDir(folder_).filePath(file)) ||
               (session_.isOpen() && QFile::exists(QString::fromStdString(
                                         (session_.session().asideFolder() / file.toStdString()).string())));
    };
    for (int number = 2; is_taken(name + ".json"); ++number)
        name = QStringLiteral("%1-%2-%3").arg(task, day).arg(number);
    return name;
}

QString CalibrationShelf::save(const CalibrationResult& result, const QString& task) {
    if (folder_.isEmpty())
        return tr("No session is open. Open one first.");
    const QString name = nextName(task);
    Calibration calibration = result.calibration;
    if (calibration.box_serial.empty())
        calibration.box_serial = suit_.serial().toStdString();
    if (const QString trouble = write(calibration, name + ".json"); !trouble.isEmpty())
        return trouble;
    remember(calibration);
    // The calibration counts; its report can be made again.
    if (const Status report = writeFileAtomically(pathIn(folder_, name + ".html"),
                                                  coreMarkup(calibrationHtml(result.document)), true);
        !report)
        emit warned(coreWords(report.error()));
    const QString what = tr("Calibration: %1").arg(coreWords(result.document.procedure));
    session_.undoStack().beginMacro(what);
    use(name + ".json", what);
    if (result.actor)
        keepMeasures(*result.actor, what);
    session_.undoStack().endMacro();
    emit saved(task, result.grade() == Grade::kGood || result.grade() == Grade::kUsable);
    return {};
}

/// Bones that the calibration has found become those of the performer who wears the suit.
void CalibrationShelf::keepMeasures(const Actor& actor, const QString& what) {
    const auto measures = measuresOf(actor);
    const Session& session = session_.session();
    const auto performer = std::ranges::find(session.performers, suit_.wearing().performer, &Performer::name);
    if (!measures || performer == session.performers.end() || suit_.known().actor)
        return;
    Performer measured = *performer;
    setMeasures(measured, *measures);
    session_.changePerformer(static_cast<int>(performer - session.performers.begin()), measured, what, {});
}

void CalibrationShelf::use(const QString& file, const QString& what) {
    const auto calibration = readCalibrationFile(pathIn(folder(), file));
    const bool is_others = calibration && ownerOf(*calibration) == CalibrationOwner::kAnotherSuit;
    if (is_beside_ || isOwnFile() || is_others)  // for this suit alone
        session_.setSuitCalibration(suit_.serial(), file, what);
    else
        session_.setCalibration(file, what);
}

}  // namespace noctule::ui
