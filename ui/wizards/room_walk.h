// SPDX-License-Identifier: Apache-2.0
// The live survey of a room: while somebody in a suit walks past the anchors a take is recorded, and what it
// holds so far is surveyed again and again. It ends when every anchor is good, when the operator ends it, or
// when a box is lost; the take stays in each case.
#pragma once

#include <QPointer>
#include <QTimer>
#include <memory>

#include "core/processing/survey_room.h"
#include "ui/models/studio.h"

namespace noctule::ui {

class RoomWalk : public QObject {
    Q_OBJECT
public:
    enum class Phase {
        kIdle,
        kStarting,
        kStanding,  ///< in the rest pose, which the room's frame comes from
        kWalking,
        kSaving
    };
    /// Seconds of the take.
    struct Times {
        double stand_s = 3;
        double first_s = 8;   ///< sound in the first survey; with less the clocks of boxes are seldom found
        double every_s = 4;   ///< between beginnings of surveys, when each is done by then
        double least_s = 23;  ///< it does not end by itself before
        double usual_s = 60;  ///< that the ring shows
        double most_s = 180;
    };

    explicit RoomWalk(Studio& studio, QObject* parent = nullptr);
    ~RoomWalk() override;

    void setTimes(const Times& times) { times_ = times; }
    const Times& times() const { return times_; }

    /// In words; empty: it can begin.
    QString whyNotBegin() const;
    /// A suit that can walk and a box of anchors are connected.
    bool isPossible() const { return whoIsMissing().isEmpty(); }
    /// What makes the result worse and can be mended first, as sentences; empty: nothing.
    QString caution() const;
    void begin();
    /// In good order; the take is saved.
    void end();

    Phase phase() const;
    bool isRunning() const { return runs_; }
    double seconds() const;
    int anchorCount() const;
    /// In the take so far; null: nothing yet.
    const SurveyedTake* found() const { return found_.get(); }
    /// Why the last survey has found nothing.
    const std::optional<Error>& hindrance() const { return hindrance_; }
    /// Why it did not begin, or ended by itself before its time; empty: nothing went wrong.
    const QString& trouble() const { return trouble_; }
    /// What the last walk recorded; empty: no take came to be.
    const QString& takeName() const { return take_name_; }
    /// Every anchor is good.
    static bool isEnough(const room_survey::RoomSurvey& survey);

signals:
    /// phase(), found(), hindrance() or trouble().
    void changed();
    void ticked();  ///< five times a second while it runs
    /// The take is in the session.
    void ended(const QString& take_name);

private:
    QString whoIsMissing() const;
    void follow();
    void settle();
    void tick();
    void lookForLost();
    void surveyWhenDue();
    void startSurvey(const std::string& path);
    struct SoFar;
    void accept(SoFar so_far);
    void onEnded(const QString& take, const QString& trouble);
    void stopSurvey();

    Studio& studio_;
    Times times_;
    bool runs_ = false, ends_ = false;
    Phase told_ = Phase::kIdle;
    QTimer tick_;
    QPointer<Job> job_;
    int surveying_ = 0;      ///< what jobs of an earlier one bring is void
    double surveyed_s_ = 0;  ///< where the last survey began
    std::shared_ptr<const SurveyedTake> found_;
    std::optional<Error> hindrance_;
    QString trouble_, take_name_;
    QString not_begun_;  ///< why the recording did not begin, as it was told
};

}  // namespace noctule::ui
