// SPDX-License-Identifier: Apache-2.0
// Which body the session's views show: a mesh, how its skin bends, and which of its bones is which of our
// joints; of a mesh without bones where its joints are. Read by a job; the session changes with "Use it",
// which undo takes back.
#pragma once

#include <map>

#include "ui/models/shared_context.h"
#include "ui/views/dialog_frame.h"

class QComboBox;

namespace noctule::ui {

class Button;
class JobProgress;
class Label;
class LandmarkEditor;

class BodyDialog : public DialogFrame {
    Q_OBJECT
public:
    /// Only while a session is open.
    explicit BodyDialog(SharedContext& shared, QWidget* parent = nullptr);

    /// What the session gets.
    const SessionBody& draft() const { return draft_; }
    void setMesh(const QString& path);

    // For the operator and tests.
    Button *choose, *ours, *find_again;
    QComboBox* blending;
    /// The bone of a joint; null while no rigged mesh is read.
    QComboBox* boneOf(const std::string& joint) const;
    /// Null while no mesh without bones is read.
    LandmarkEditor* landmarks() const { return landmarks_; }

public slots:
    void accept() override;

protected:
    void fitHeight() override;

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
    void makeLandmarks(const StandingMesh& standing);
    void showRows(QWidget* rows, int dialog_width);
    void takeBones();
    void takeLandmarks();
    void findAgain();
    void refresh();
    BoneMap shownBones() const;

    SharedContext& shared_;
    SessionBody draft_;
    std::shared_ptr<const RiggedMesh> mesh_;
    std::optional<Error> problem_;
    std::optional<Error> problem_of_found_;  ///< of landmarks that were not set by hand
    BoneMap found_;
    std::map<std::string, BoneRow> bones_;
    Label *name_, *heading_;
    QWidget* rows_ = nullptr;
    LandmarkEditor* landmarks_ = nullptr;
    QBoxLayout* rows_column_;
    JobProgress* progress_;
    QPointer<Job> reading_;
};

}  // namespace noctule::ui
