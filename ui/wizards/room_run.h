// SPDX-License-Identifier: Apache-2.0
// The survey of the room of the take that is open: what can be done, its result, and the places put in force
// in the take as a step that can be undone.
#pragma once

#include <QPointer>
#include <memory>
#include <set>

#include "core/processing/survey_room.h"
#include "ui/models/studio.h"

namespace noctule::ui {

/// The error of a survey with the take's name instead of its path.
Error namingTake(Error error, const std::string& take_path);

class RoomRun : public QObject {
    Q_OBJECT
public:
    enum class Phase {
        kNoTake,  ///< none with anchors is open
        kReady,
        kSurveying,
        kFailed,
        kResult
    };

    explicit RoomRun(Studio& studio, QObject* parent = nullptr);

    /// The take that is open has anchors, or a box of anchors is connected.
    static bool hasRoom(Studio& studio);

    Phase phase() const;
    QString takeName() const;
    /// Of kSurveying.
    Job* job() const { return job_; }
    /// Of kResult.
    const SurveyedTake& result() const { return *result_; }
    /// Of kFailed.
    const Error& error() const { return *error_; }
    /// The places of the result hold in the take.
    bool isInUse() const;
    /// Why an anchor of the result cannot be left out, in words; empty: it can.
    QString whyNotWithout(size_t anchor) const;
    /// Leaves it out of the result, or takes it back in.
    void setWithout(size_t anchor, bool is_without);

    void survey();
    void use();
    /// Writes the room's file; in words why not, else empty.
    QString save(const QString& path) const;

signals:
    void changed();

private:
    void follow();
    void forget();
    void accept(Result<SurveyedTake> result);
    void placed(const QString& path, const TakeChange& change);

    Studio& studio_;
    QPointer<Job> job_;
    QString path_;                                      ///< of result or error
    std::shared_ptr<const SurveyedTake> all_, result_;  ///< with all anchors, and as the operator wants it
    std::set<size_t> without_;                          ///< anchors
    std::optional<Error> error_;
    std::optional<Suit> in_force_;  ///< the room in the take, once places were put in force since the survey
};

}  // namespace noctule::ui
