// SPDX-License-Identifier: Apache-2.0
// Sets the landmarks of a mesh by hand: picture and numbers that follow each other, both sides alike unless
// that is switched off, undo and redo, and all back to where they were found.
#pragma once

#include <QWidget>
#include <array>
#include <map>

#include "core/mesh/rig/body_landmarks.h"
#include "core/mesh/skinned_mesh.h"

class QCheckBox;
class QGridLayout;

namespace noctule::ui {

class Label;
class LandmarkPicture;
class NumberBox;
class ScrollArea;
class ToolButton;

class LandmarkEditor : public QWidget {
    Q_OBJECT
public:
    /// `found`: by themselves; `places`: to begin with.
    LandmarkEditor(std::shared_ptr<const SkinnedMesh> surface, Landmarks found, const Landmarks& places,
                   QWidget* parent = nullptr);

    const Landmarks& places() const { return places_; }
    bool isAsFound() const { return places_ == found_; }

    // For the operator and tests.
    LandmarkPicture* picture;
    QCheckBox* both_sides;
    ToolButton *undo_button, *redo_button;
    /// Along an axis (0: x), centimetres; null for an unknown landmark.
    NumberBox* placeOf(const std::string& landmark, int axis) const;

public slots:
    void undo();
    void redo();
    void findAgain();

signals:
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Row {
        Label* name;
        std::array<NumberBox*, 3> places;
    };
    QWidget* makeRows();
    void addNumbers(QGridLayout& grid, const std::string& landmark);
    void choose(const std::string& landmark);
    void remember();
    void put(const std::string& landmark, const Vector3d& p_m);
    void take(std::vector<Landmarks>& from, std::vector<Landmarks>& into);
    void present();

    Landmarks found_, places_;
    std::vector<Landmarks> undo_, redo_;
    std::map<std::string, Row> rows_;
    ScrollArea* list_ = nullptr;
};

}  // namespace noctule::ui
