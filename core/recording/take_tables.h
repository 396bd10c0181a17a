// SPDX-License-Identifier: Apache-2.0
// What can be added to a take, to one being made (TakeWriter) and to one that exists (TakeEdit). Tables and
// columns that the file lacks are made on the way; everything unknown in it is kept. Numbers must be finite.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/acoustics/range.h"
#include "core/body/actor.h"
#include "core/inertial/reading.h"
#include "core/motion/foot_contacts.h"
#include "core/motion/timed_poses.h"
#include "core/recording/robot_rows.h"
#include "core/recording/rows.h"
#include "core/recording/schema.h"
#include "core/suit/calibration.h"
#include "core/suit/suit.h"

namespace noctule {

class TakeTables {
public:
    /// Rows that are given no suit belong to this one; 1 until another one is chosen.
    void view(int suit) { view_ = suit; }

    Status setMeta(const std::string& key, const std::string& value);

    // Functions without `suit` leave it to the row; ids are those of the new row.
    Result<int64_t> addSuit(const Suit& suit, const SuitClock& clock = {});
    Result<int64_t> addCalibration(const Calibration& calibration, int suit = kSuitInView);
    Result<int64_t> addActor(const Actor& actor, const std::string& created_utc, int suit = kSuitInView);
    Result<int64_t> addPulse(int64_t sample, int source, int suit = kSuitInView);
    /// Under the pulse's own id, for a copy.
    Status addPulse(const Pulse& pulse, int suit);
    Status addStatus(const StatusRow& row, int suit = kSuitInView);
    Status addGap(const GapRow& row, int suit = kSuitInView);
    Status addMarker(const MarkerRow& row, int suit = kSuitInView);
    Status addNote(const NoteRow& row);

    /// A pose that is absent is stored as not seen.
    Status addReference(const TimedPose& timed, int suit = kSuitInView);
    Status addExternalRoot(const ExternalRootRow& row, int suit = kSuitInView);

    /// Inertial, range and contact rows belong to kPrimaryRun or to a run of TakeEdit::beginRun(), poses to
    /// the latter.
    Status addInertial(int64_t run, const InertialReading& reading, int suit = kSuitInView);
    Status addRange(int64_t run, const RangeMeasurement& range, const std::string& detector,
                    int suit = kSuitInView);
    Status addContacts(int64_t run, const std::vector<FootContacts>& feet, int suit = kSuitInView);
    Status addPose(int64_t run, const TimedPose& timed, int suit = kSuitInView);
    /// Of a run of kind `orientation`.
    Status addOrientation(int64_t run, const OrientationRow& row, int suit = kSuitInView);
    /// Of a run of kind `clock`.
    Status addClock(int64_t run, const ClockRow& row, int suit = kSuitInView);
    /// Of a pose run.
    Status addRelative(int64_t run, const RelativeRow& row, int suit = kSuitInView);

    /// Its number comes back; `row.drive` is ignored.
    Result<int64_t> addRobotDrive(const RobotDriveRow& row);
    /// Also notes what they say of the whole drive.
    Status addRobotRows(int64_t drive, const RobotRows& rows);

protected:
    TakeTables(const Database* database, TakeSchema schema)
        : database_(database), schema_(std::move(schema)) {}
    ~TakeTables() = default;
    TakeTables(TakeTables&&) = default;

    const Database& database() const { return *database_; }
    TakeSchema& schema() { return schema_; }
    /// The INSERT of all the table's columns in the order of the schema, ready to bind.
    Result<Statement*> insertInto(const std::string& table);
    void dropStatements() { inserts_.clear(); }
    int seen(int suit) const { return suit == kSuitInView ? view_ : suit; }

private:
    Result<int64_t> addDocument(const std::string& table, const std::string& json,
                                const std::string& created_utc, int suit);
    Status addRobotCommand(int64_t drive, const RobotCommandRow& row);
    Status addRobotState(int64_t drive, const RobotStateRow& row);

    const Database* database_;
    TakeSchema schema_;
    std::map<std::string, Statement> inserts_;
    int view_ = 1;
};

}  // namespace noctule
