// SPDX-License-Identifier: Apache-2.0
#include "ui/models/calibration_shelf.h"

#include <QDir>
#include <algorithm>

#include "core/job/atomic_file.h"
#include "core/processing/outside_files.h"
#include "core/session/body_measures.h"
#include "core/session/placement.h"

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

}  // namespace

QDateTime ShelvedCalibration::made() const {
    return QDateTime::fromString(QString::fromStdString(calibration.created_utc), Qt::ISODate);
}

CalibrationShelf::CalibrationShelf(SessionModel& session, LiveSuit& suit, QObject* parent)
    : QObject(parent), session_(session), suit_(suit) {
    connect(&session_, &SessionModel::opened, this, &CalibrationShelf::follow);
    connect(&session_, &SessionModel::changed, this, &CalibrationShelf::follow);
    connect(&suit_, &LiveSuit::phaseChanged, this, [this] {
        if (suit_.phase() == LiveSuit::Phase::kNone)
            handed_.reset();
        hand();
    });
}

QString CalibrationShelf::folder() const {
    return session_.isOpen() ? QString::fromStdString(session_.session().calibrationFolder().string())
                             : QString();
}

QString CalibrationShelf::fileInForce() const {
    return session_.isOpen() ? QString::fromStdString(session_.session().calibration) : QString();
}

std::optional<Calibration> CalibrationShelf::inForce() const {
    const auto found = std::ranges::find(all_, fileInForce(), &ShelvedCalibration::file);
    return found != all_.end() ? std::optional(found->calibration) : suit_.calibration();
}

void CalibrationShelf::follow() {
    if (folder() == folder_ && fileInForce() == in_force_)
        return;
    folder_ = folder();
    in_force_ = fileInForce();
    read();
    hand();
    emit changed();
}

void CalibrationShelf::read() {
    all_.clear();
    if (folder_.isEmpty())
        return;
    for (const QString& file : QDir(folder_).entryList({"*.json"}, QDir::Files)) {
        if (file.endsWith(kUnfinished))
            continue;
        if (auto calibration = readCalibrationFile(pathIn(folder_, file)))
            all_.push_back({file, std::move(*calibration)});
    }
    if (!in_force_.isEmpty() && std::ranges::find(all_, in_force_, &ShelvedCalibration::file) == all_.end())
        emit warned(
            tr("The calibration %1 of this session is gone or damaged. Takes are made with what the suit "
               "knows of itself; choose another one in step Calibrate.")
                .arg(in_force_));
    std::ranges::stable_sort(all_, std::greater(), [](const ShelvedCalibration& shelved) {
        return std::make_pair(shelved.calibration.created_utc, shelved.file);
    });
}

QStringList CalibrationShelf::strangers(const Calibration& calibration) const {
    QStringList strangers;
    addStrangers(suit_.suit().boards, calibration.boards, strangers);
    addStrangers(suit_.suit().sources, calibration.sources, strangers);
    return strangers;
}

/// A suit that brought its own calibration keeps it until the session has one.
void CalibrationShelf::hand() {
    const bool is_worn = suit_.phase() == LiveSuit::Phase::kLooking;
    const auto found = std::ranges::find(all_, in_force_, &ShelvedCalibration::file);
    const QString path = in_force_.isEmpty() ? QString() : QDir(folder_).filePath(in_force_);
    if (!is_worn || (handed_ && *handed_ == path))
        return;
    if (found == all_.end()) {
        if (std::exchange(handed_, std::nullopt))
            suit_.setCalibration(own_);
        return;
    }
    if (!handed_)
        own_ = suit_.calibration();
    handed_ = path;
    if (const QStringList others = strangers(found->calibration); !others.isEmpty())
        emit warned(tr("The calibration %1 was made with other parts than those connected now: %2. Calibrate "
                       "those before takes with them can be relied on.")
                        .arg(in_force_, others.join(", ")));
    suit_.setCalibration(found->calibration);
}

QString CalibrationShelf::nextName(const QString& task) const {
    const QString day = QDate::currentDate().toString(Qt::ISODate);
    QString name = QStringLiteral("%1-%2").arg(task, day);
    for (int number = 2; QFile::exists(QDir(folder_).filePath(name + ".json")); ++number)
        name = QStringLiteral("%1-%2-%3").arg(task, day).arg(number);
    return name;
}

QString CalibrationShelf::save(const CalibrationResult& result, const QString& task) {
    if (folder_.isEmpty())
        return tr("No session is open. Open one first.");
    QDir().mkpath(folder_);
    const QString name = nextName(task);
    const Status written = writeFileAtomically(pathIn(folder_, name + ".json"),
                                               toJson(result.calibration).dump(2) + "\n", false);
    if (!written)
        return QString::fromStdString(written.error().text());
    // The calibration counts; its report can be made again.
    if (const Status report =
            writeFileAtomically(pathIn(folder_, name + ".html"), calibrationHtml(result.document), true);
        !report)
        emit warned(QString::fromStdString(report.error().text()));
    const QString what =
        tr("Calibration of the %1").arg(QString::fromStdString(result.document.procedure).toLower());
    session_.undoStack().beginMacro(what);
    use(name + ".json", what);
    if (result.actor)
        keepMeasures(*result.actor, what);
    session_.undoStack().endMacro();
    return {};
}

/// Bones that the calibration has found become those of the performer who wears the suit.
void CalibrationShelf::keepMeasures(const Actor& actor, const QString& what) {
    const auto measures = measuresOf(actor);
    const Session& session = session_.session();
    const auto performer = std::ranges::find(session.performers, session.current_performer, &Performer::name);
    if (!measures || performer == session.performers.end() || suit_.known().actor)
        return;
    Performer measured = *performer;
    setMeasures(measured, *measures);
    session_.changePerformer(static_cast<int>(performer - session.performers.begin()), measured, what, {});
}

void CalibrationShelf::use(const QString& file, const QString& what) {
    session_.setCalibration(file, what);
}

}  // namespace noctule::ui
