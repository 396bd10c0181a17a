// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/landmark_editor.h"

#include <QCheckBox>
#include <QEvent>
#include <QKeyEvent>
#include <QShortcut>
#include <QSignalBlocker>

#include "ui/views/number_box.h"
#include "ui/views/performer/landmark_picture.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr double kCm = 100, kFarthest_cm = 500;

}  // namespace

LandmarkEditor::LandmarkEditor(std::shared_ptr<const SkinnedMesh> surface, Landmarks found,
                               const Landmarks& places, QWidget* parent)
    : QWidget(parent),
      picture(new LandmarkPicture),
      both_sides(new QCheckBox(tr("Keep both sides alike"))),
      undo_button(new ToolButton("undo", tr("Undo"), QKeySequence::Undo)),
      redo_button(new ToolButton("redo", tr("Redo"), QKeySequence::Redo)),
      found_(std::move(found)),
      places_(places) {
    auto* column = makeColumn(this, {}, 8);
    auto* head = addRow(column, 8);
    both_sides->setChecked(true);
    both_sides->setToolTip(
        tr("What is moved on one side moves on the other; the middle stays in the middle"));
    head->addWidget(both_sides, 1);
    head->addWidget(undo_button);
    head->addWidget(redo_button);
    auto* parts = addRow(column, 16);
    parts->addWidget(picture, 1);
    parts->addWidget(makeRows());
    picture->setSurface(std::move(surface));
    setFocusProxy(picture);

    connect(undo_button, &QAbstractButton::clicked, this, &LandmarkEditor::undo);
    connect(redo_button, &QAbstractButton::clicked, this, &LandmarkEditor::redo);
    connect(new QShortcut(QKeySequence::Undo, this), &QShortcut::activated, this, &LandmarkEditor::undo);
    connect(new QShortcut(QKeySequence::Redo, this), &QShortcut::activated, this, &LandmarkEditor::redo);
    connect(both_sides, &QCheckBox::toggled, this, [this] { choose(picture->chosen()); });
    connect(picture, &LandmarkPicture::landmarkChosen, this,
            [this](const QString& landmark) { choose(landmark.toStdString()); });
    connect(picture, &LandmarkPicture::moveBegins, this, &LandmarkEditor::remember);
    connect(picture, &LandmarkPicture::moveCancelled, this, [this] {
        undo();
        redo_.clear();
        present();
    });
    connect(picture, &LandmarkPicture::moved, this,
            [this](const QString& landmark, double x_m, double y_m, double z_m) {
                put(landmark.toStdString(), {x_m, y_m, z_m});
            });
    present();
}

QWidget* LandmarkEditor::makeRows() {
    auto* list = new QWidget;
    auto* grid = makeGrid(list, {0, 0, 8, 0}, 6);
    for (int axis = 0; axis < 3; ++axis)
        grid->addWidget(new Label(tr("%1, cm").arg(QChar('X' + axis)), TextRole::kCaption, Ink::kHint), 0,
                        1 + axis);
    for (const std::string& landmark : landmarkNames())
        if (places_.contains(landmark))
            addNumbers(*grid, landmark);
    return list_ = new ScrollArea(list);
}

void LandmarkEditor::addNumbers(QGridLayout& grid, const std::string& landmark) {
    const int at = 1 + static_cast<int>(rows_.size());
    Row& row = rows_[landmark];
    row.name = new Label(landmarkName(landmark), TextRole::kBody, Ink::kLabel);
    grid.addWidget(row.name, at, 0);
    for (int axis = 0; axis < 3; ++axis) {
        auto* place = new NumberBox;
        place->setRange(-kFarthest_cm, kFarthest_cm);
        place->setDecimals(1);
        place->setSingleStep(0.5);
        place->setKeyboardTracking(false);
        place->setAccessibleName(tr("%1, %2 in centimetres").arg(landmarkName(landmark), QChar('X' + axis)));
        place->installEventFilter(this);
        grid.addWidget(place, at, 1 + axis);
        row.places[static_cast<size_t>(axis)] = place;
        connect(place, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
                [this, landmark, axis](double value_cm) {
                    remember();
                    Vector3d p_m = places_.at(landmark);
                    p_m[axis] = value_cm / kCm;
                    put(landmark, p_m);
                });
    }
}

/// A box that gets the keyboard chooses its landmark; undo and redo are of all boxes, not of one's text.
bool LandmarkEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn)
        for (const auto& [landmark, row] : rows_)
            for (const NumberBox* place : row.places)
                if (place == watched)
                    choose(landmark);
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<QKeyEvent&>(*event);
        if (key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void LandmarkEditor::choose(const std::string& landmark) {
    picture->choose(landmark, both_sides->isChecked() ? otherSideOf(landmark) : std::string());
    for (const auto& [name, row] : rows_)
        row.name->setInk(name == landmark ? Ink::kAccent : Ink::kLabel);
    if (const auto row = rows_.find(landmark); row != rows_.end())
        list_->ensureWidgetVisible(row->second.places[0]);
}

void LandmarkEditor::remember() {
    undo_.push_back(places_);
    redo_.clear();
}

void LandmarkEditor::put(const std::string& landmark, const Vector3d& p_m) {
    putLandmark(places_, landmark, p_m, both_sides->isChecked());
    present();
    emit changed();
}

void LandmarkEditor::take(std::vector<Landmarks>& from, std::vector<Landmarks>& into) {
    if (from.empty())
        return;
    into.push_back(places_);
    places_ = std::move(from.back());
    from.pop_back();
    present();
    emit changed();
}

void LandmarkEditor::undo() {
    take(undo_, redo_);
}

void LandmarkEditor::redo() {
    take(redo_, undo_);
}

void LandmarkEditor::findAgain() {
    if (isAsFound())
        return;
    remember();
    places_ = found_;
    present();
    emit changed();
}

/// Boxes show millimetres; the places themselves are not rounded.
void LandmarkEditor::present() {
    picture->setLandmarks(places_);
    for (const auto& [landmark, row] : rows_)
        for (size_t axis = 0; axis < row.places.size(); ++axis) {
            const QSignalBlocker blocked(row.places[axis]);
            row.places[axis]->setValue(kCm * places_.at(landmark)[static_cast<Eigen::Index>(axis)]);
        }
    undo_button->setDisabledBecause(undo_.empty() ? tr("Nothing was moved.") : QString());
    redo_button->setDisabledBecause(redo_.empty() ? tr("Nothing was undone.") : QString());
}

NumberBox* LandmarkEditor::placeOf(const std::string& landmark, int axis) const {
    const auto row = rows_.find(landmark);
    return row == rows_.end() ? nullptr : row->second.places[static_cast<size_t>(axis)];
}

}  // namespace noctule::ui
