// SPDX-License-Identifier: Apache-2.0
// The take that is open for review, with the parts that have been loaded so far. Loading runs as jobs;
// signals tell when a part has come. Parts are shared and never change once loaded: views may keep them.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>

#include "core/processing/process_take.h"
#include "core/report/report_data.h"
#include "core/review/series.h"
#include "core/review/take_review.h"
#include "ui/jobs/jobs.h"
#include "ui/models/time_cursor.h"

namespace noctule::ui {

class TakeDocument : public QObject {
    Q_OBJECT
public:
    TakeDocument(Jobs& jobs, TimeCursor& time, QObject* parent = nullptr);

    bool isOpen() const { return overview_ != nullptr; }
    QString path() const { return path_; }
    /// Null until opened().
    std::shared_ptr<const TakeOverview> overview() const { return overview_; }

    /// Result A, the one that is shown, and B, the one that it is compared with (-1: none; kReference: the
    /// take's own).
    static constexpr int kReference = -2;
    int shownRun() const { return shown_; }  ///< index into overview()->runs, -1: none
    int comparedRun() const { return compared_; }
    void setShownRun(int index);
    void setComparedRun(int index);

    /// Null until loaded; asking starts loading. Of the shown or compared run.
    std::shared_ptr<const TimedMotion> shownMotion();
    std::shared_ptr<const TimedMotion> comparedMotion();
    std::shared_ptr<const TimedMotion> reference();
    std::shared_ptr<const RangeTable> ranges();  ///< those that the shown run used
    std::shared_ptr<const ReadingTable> readings();
    std::shared_ptr<const ReportData> report();  ///< of the shown run

public slots:
    void open(const QString& path);
    void close();
    /// Reads the overview again (after processing, attaching) and keeps the choice of runs where it can; the
    /// newest run is shown when `show_newest`.
    void reload(bool show_newest);

signals:
    void opened();  ///< overview is there, or the document was closed
    void failed(const QString& message);
    void runsChanged();    ///< list or choice
    void motionChanged();  ///< a motion has been loaded
    void rangesChanged();
    void readingsChanged();
    void reportChanged();

private:
    template <class T>
    struct Part {
        std::shared_ptr<const T> value;
        bool loading = false, failed = false;
    };
    void forget();

    Jobs& jobs_;
    TimeCursor& time_;
    QString path_;
    int generation_ = 0;  ///< results of an earlier take or choice are dropped
    std::shared_ptr<const TakeOverview> overview_;
    int shown_ = -1, compared_ = -1;
    std::map<int, Part<TimedMotion>> motions_;  ///< by index of run; kReference: the reference
    std::map<int64_t, Part<RangeTable>> ranges_;
    std::map<int64_t, Part<ReadingTable>> readings_;
    std::map<int, Part<ReportData>> reports_;
};

}  // namespace noctule::ui
