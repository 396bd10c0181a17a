// SPDX-License-Identifier: Apache-2.0
// What is exported, how and to where.
#pragma once

#include <QMap>
#include <QWidget>

#include "ui/models/review_context.h"
#include "ui/views/export/export_settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;

namespace noctule::ui {

class Button;
class ExportTakeList;
class FormRows;
class Label;

class ExportForm : public QWidget {
    Q_OBJECT
public:
    explicit ExportForm(ReviewContext& review, QWidget* parent = nullptr);

    /// Those of a preset. A file name that was typed stays.
    void setSettings(const ExportSettings& settings);
    const ExportSettings& settings() const { return settings_; }
    /// The same with the preset's own file name.
    ExportSettings ofPreset() const;
    /// Instead of the preset's, until it is cleared; empty: none.
    const QString& typedName() const { return typed_name_; }
    void setTypedName(const QString& name) { typed_name_ = name; }
    /// Names of the takes that are ticked, in the order of the session.
    QStringList takes() const;
    void setTakes(const QStringList& names);
    /// Names of the results of a take that go out; an empty name: its last.
    QStringList resultsOf(const QString& take) const;
    /// Whether several results of a take go out: their files need different names.
    bool sendsAllResults() const;
    ExportTakeList& takeList() { return *takes_; }
    /// Which takes go out and which result of each; stands beside the form, where names have room.
    QWidget* takesPart() { return takes_part_; }
    /// Under the file name: what will be written, or what is wrong with the name.
    void setPreview(const QString& words, bool is_problem);
    QString preview() const;

    // For those who fill it in, the operator and tests.
    QComboBox *range, *format, *frames, *root, *unit, *names, *body, *size, *camera, *run;
    QCheckBox *angles, *one_file, *lock_feet;
    QMap<ExportFormat, QCheckBox*> also;  ///< formats beside the main one
    QLineEdit* name_pattern;
    Button* try_one_frame;

signals:
    void changed();  ///< by the operator
    void tryWanted();

private:
    FormRows* makeRows();
    QWidget* makeWhat();
    void addMotionRows(FormRows& rows);
    void addFigureRows(FormRows& rows);
    void makeTakes();
    QWidget* makeWhere();
    QWidget* makeAlso();
    QWidget* makePictures();
    void read();
    void refresh();
    void refreshWhere();
    void chooseFolder();

    ReviewContext& review_;
    ExportSettings settings_;
    QString preset_name_, typed_name_;
    bool setting_ = false;
    QWidget *takes_part_ = nullptr, *own_range_ = nullptr, *pictures_ = nullptr;
    std::vector<FormRows*> rows_;
    std::vector<QWidget*> not_of_pictures_;
    QDoubleSpinBox *own_from_ = nullptr, *own_to_ = nullptr;
    ExportTakeList* takes_ = nullptr;
    Button* folder_ = nullptr;
    Label* preview_ = nullptr;
};

}  // namespace noctule::ui
