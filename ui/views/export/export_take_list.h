// SPDX-License-Identifier: Apache-2.0
// The takes of the session to tick for an export and, when asked for, the result of each that goes out.
#pragma once

#include <QTreeWidget>
#include <filesystem>
#include <map>
#include <vector>

#include "core/review/take_review.h"
#include "ui/models/review_context.h"

class QComboBox;

namespace noctule::ui {

class ExportTakeList : public QTreeWidget {
    Q_OBJECT
public:
    explicit ExportTakeList(ReviewContext& review, QWidget* parent = nullptr);

    /// Names of the takes that are ticked, in the order of the session.
    QStringList ticked() const;
    void tick(const QStringList& names);
    /// Whether every take shows its results, to choose one of them when `choosable`; a job reads those of
    /// takes that were written since.
    void setResultsShown(bool shown, bool choosable);
    /// Of all results of a take; one empty name, its last, until they are known.
    QStringList resultNames(const QString& take) const;
    /// Name of the result chosen for a take; empty: its last.
    QString chosenResult(const QString& take) const { return chosen_.value(take); }
    /// The choice of a take, for the operator and tests; null until its results are known, or when there is
    /// one only.
    QComboBox* resultsOf(const QString& take) const;

signals:
    void changed();  ///< by the operator, or the takes

private:
    struct Results {
        std::vector<ReviewRun> runs;
        std::filesystem::file_time_type written;  ///< when the take's file was, as they were read
    };
    using ResultsOfTakes = std::map<QString, Results>;
    static Result<ResultsOfTakes> newResults(const std::vector<std::pair<QString, std::string>>& takes,
                                             const ResultsOfTakes& known, const JobContext& job);
    void readTakes();
    void readResults();
    void fitHeight();
    void addTake(const SessionTake& take, bool is_ticked);
    void addResults(QTreeWidgetItem* item);
    void followRename(const QString& old_path, const QString& new_path);

    ReviewContext& review_;
    bool results_shown_ = false, choosable_ = false;
    int ticket_ = 0;                 ///< what an earlier reading found is dropped
    ResultsOfTakes results_;         ///< by take
    QMap<QString, QString> chosen_;  ///< by take
};

}  // namespace noctule::ui
