// SPDX-License-Identifier: Apache-2.0
// Which body the session's views show: a mesh, how its skin bends, and which of its bones is which of our
// joints; of a mesh without bones where its joints are. Read by a job; the session changes with "Use it",
// which undo takes back.
#pragma once

#include <map>

#include "ui/models/studio.h"
#include "ui/views/dialog_frame.h"

class QComboBox;
class QDoubleSpinBox;

namespace noctule::ui {

class Button;
class JobProgress;
class Label;

class BodyDialog : public DialogFrame {
    Q_OBJECT
public:
    /// Only while a session is open.
    explicit BodyDialog(Studio& studio, QWidget* parent = nullptr);

    /// What the session gets.
    const SessionBody& draft() const { return draft_; }
    void setMesh(const QString& path);

    // For the operator and tests.
    Button *choose, *ours, *find_again;
    QComboBox* blending;
    /// The bone of a joint; null while no rigged mesh is read.
    QComboBox* boneOf(const std::string& joint) const;
    /// Of a landmark along an axis (0: x), centimetres; null while no mesh without bones is read.
    QDoubleSpinBox* placeOf(const std::string& landmark, int axis) const;

public slots:
    void accept() override;

private:
    struct BoneRow {
        QComboBox* bone;
        Label* consequence;
    };
    void chooseFile();
    void readMesh();
    void present(const ReadBody& read);
    void clearRows();
    void makeBoneRows();
    void makeLandmarkRows(const Landmarks& landmarks);
    void takeBones();
    void takeLandmarks();
    void refresh();
    BoneMap shownBones() const;

    Studio& studio_;
    SessionBody draft_;
    std::shared_ptr<const RiggedMesh> mesh_;
    std::optional<Error> problem_;
    BoneMap found_;
    std::map<std::string, BoneRow> bones_;
    std::map<std::string, std::array<QDoubleSpinBox*, 3>> places_;
    Label *name_, *heading_;
    QWidget* rows_ = nullptr;
    QBoxLayout* rows_column_;
    JobProgress* progress_;
    QPointer<Job> reading_;
};

}  // namespace noctule::ui
