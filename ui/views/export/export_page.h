// SPDX-License-Identifier: Apache-2.0
// What is missing for the next program? Takes as files, made for it, written, read again and checked.
#pragma once

#include <filesystem>

#include "ui/models/review_context.h"
#include "ui/views/export/export_run.h"
#include "ui/views/export/export_settings.h"
#include "ui/views/page.h"

class QBoxLayout;

namespace noctule::ui {

class Button;
class ExportForm;
class ExportPresetList;
class ExportResultsPanel;
class JobProgress;
class Label;
class ScrollArea;

/// On small screens and with large type the takes and the written files stand below the form, which scrolls.
class ExportPage : public Page {
    Q_OBJECT
public:
    explicit ExportPage(ReviewContext& review, QWidget* parent = nullptr);

    QString title() const override { return tr("Export"); }
    QWidget* leftDock() override;
    void enter() override;

    ExportForm& form() { return *form_; }
    ExportResultsPanel& resultsPanel() { return *results_panel_; }
    Button* writeButton() { return write_; }
    void choosePreset(const QString& key);
    /// What would be written now; an Error names what is in the way.
    Result<std::vector<ExportJob>> plan() const;
    const std::optional<ExportResults>& results() const { return results_; }

public slots:
    void write();
    void tryOneFrame();
    std::optional<double> cursorIn(const ExportRequest& request) const;
    void openFolder();  ///< by its button alone: no key of the page leaves the studio

signals:
    void finished();  ///< results() is there, or what failed was said

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeSides();
    QWidget* makeFoot();
    void placeSides();
    bool areBeside() const;
    void scrollToResults();
    void refresh();
    /// All that the files depend on, but for their names, which are others once these are written.
    struct Asked {
        ExportSettings settings;
        std::vector<ExportRequest> requests;
        std::vector<std::filesystem::file_time_type> changed;  ///< the takes' files
        bool operator==(const Asked&) const = default;
    };
    void start(const JobTitle& title, const Asked& asked,
               std::function<Result<ExportResults>(const JobContext&)> work, bool is_trial);
    void present(const Result<ExportResults>& results, bool is_trial);
    void noteDamage(const ExportResults& results);
    using Plan = Result<std::vector<ExportJob>>;
    Asked askedBy(const Plan& plan) const;
    /// The files on disk are those that are asked for.
    bool isWritten(const Asked& asked) const;
    void followCursor();
    Result<std::vector<ExportJob>> planOf(const ExportSettings& settings, const QStringList& takes) const;
    void offer(bool folder_first);
    void saveCheck();
    void saveOwnPreset();
    void removeOwnPreset(const QString& key);

    ReviewContext& review_;
    ExportPresets presets_;
    PerformerNames performers_;
    ExportPresetList* preset_list_;
    ExportForm* form_;
    ExportResultsPanel* results_panel_;
    JobProgress* progress_;
    Label* state_;
    QBoxLayout *sides_ = nullptr, *below_form_ = nullptr;
    QWidget *between_ = nullptr, *takes_side_ = nullptr;
    ScrollArea* scroll_ = nullptr;
    Button *again_, *folder_, *write_;
    std::optional<ExportResults> results_;
    std::optional<Asked> written_, started_;  ///< what results_ and the job that runs were asked for
};

}  // namespace noctule::ui
