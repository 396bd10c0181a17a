// SPDX-License-Identifier: Apache-2.0
// Left dock of Export: for whom the files are made. Own presets can be saved and removed.
#pragma once

#include <QListWidget>
#include <QWidget>

#include "ui/views/export/export_settings.h"

namespace noctule::ui {

class Button;

class ExportPresetList : public QWidget {
    Q_OBJECT
public:
    explicit ExportPresetList(ExportPresets& presets, QWidget* parent = nullptr);

    QString current() const;
    void choose(const QString& key);
    /// After presets were added, removed or changed.
    void refresh();
    QListWidget& list() { return *list_; }

signals:
    void chosen(const QString& key);
    void saveWanted();
    void removeWanted(const QString& key);

private:
    ExportPresets& presets_;
    QListWidget* list_;
    Button *save_, *remove_;
};

}  // namespace noctule::ui
