// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/review_actions.h"

#include "ui/models/studio.h"
#include "ui/plots/timeline.h"
#include "ui/plots/transport_bar.h"
#include "ui/views/review/performer_switch.h"
#include "ui/views/review/reference_panel.h"
#include "ui/views/review/review_center.h"
#include "ui/views/review/review_page.h"
#include "ui/views/review/review_sidebar.h"
#include "ui/views/review/scene_area.h"

namespace noctule::ui {

ReviewActions::ReviewActions(Studio& studio, ReviewPage& page)
    : PageActions(page), studio_(studio), page_(page) {
    addPlayback();
    addSeparator();
    addRange();
    addSeparator();
    addTake();
    connect(&studio.time(), &TimeCursor::playingChanged, this, &ReviewActions::refresh);
    connect(&studio.time(), &TimeCursor::settingsChanged, this, &ReviewActions::refresh);
    connect(&studio.take(), &TakeDocument::opened, this, &ReviewActions::refresh);
    connect(&studio.take(), &TakeDocument::runsChanged, this, &ReviewActions::refresh);
    connect(&page.center().timeline(), &Timeline::chosenMarkerChanged, this, &ReviewActions::refresh);
    connect(&studio.contacts(), &ContactEditor::changed, this, &ReviewActions::refresh);
    connect(&page.center().scenes(), &SceneArea::sideBySideChanged, this, &ReviewActions::refresh);
    refresh();
}

void ReviewActions::addPlayback() {
    TimeCursor& time = studio_.time();
    Timeline& timeline = page_.center().timeline();
    play_ = add("review/play", tr("Play"), Qt::Key_Space, [&time] { time.toggle(); });
    loop_ = add("review/loop", tr("Loop"), QKeySequence("Ctrl+L"), [&time] { time.setLoop(!time.loops()); });
    loop_->setCheckable(true);
    add("review/next_frame", tr("Next frame"), Qt::Key_Right, [&time] { time.stepFrames(1); });
    add("review/previous_frame", tr("Previous frame"), Qt::Key_Left, [&time] { time.stepFrames(-1); });
    add("review/second_on", tr("One second on"), QKeySequence("Shift+Right"),
        [&time] { time.stepSeconds(1); });
    add("review/second_back", tr("One second back"), QKeySequence("Shift+Left"),
        [&time] { time.stepSeconds(-1); });
    add("review/next_marker", tr("Next marker"), Qt::Key_Period, [&timeline] { timeline.goToMarker(1); });
    add("review/previous_marker", tr("Previous marker"), Qt::Key_Comma,
        [&timeline] { timeline.goToMarker(-1); });
}

void ReviewActions::addRange() {
    TimeCursor& time = studio_.time();
    TransportBar& transport = page_.center().transport();
    add("review/in", tr("In here"), QKeySequence("Ctrl+I"), [&transport] { transport.setIn(); });
    add("review/out", tr("Out here"), QKeySequence("Ctrl+O"), [&transport] { transport.setOut(); });
    add("review/go_to_in", tr("Go to in"), Qt::Key_Home, [&time] { time.setTime(time.in()); });
    add("review/go_to_out", tr("Go to out"), Qt::Key_End, [&time] { time.setTime(time.out()); });
    add("review/whole_range", tr("In and out at the ends"), {},
        [&time] { time.chooseRange(0, time.duration()); });
    add("review/marker", tr("Marker here"), Qt::Key_M, [&transport] { transport.addMarker(); });
    Timeline& timeline = page_.center().timeline();
    name_marker_ =
        add("review/name_marker", tr("Name marker"), Qt::Key_F2, [&timeline] { timeline.nameMarker(); });
    delete_ =
        add("review/delete", tr("Delete marker"), Qt::Key_Delete, [&timeline] { timeline.deleteChosen(); });
    add("review/foot_contact", tr("Foot contact here"), Qt::Key_Insert,
        [&timeline] { timeline.addContact(); });
    found_contacts_ = add("review/found_contacts", tr("Back to the contacts that were found"), {},
                          [&timeline] { timeline.restoreFoundContacts(); });
}

void ReviewActions::addTake() {
    SceneArea& scenes = page_.center().scenes();
    add("review/reprocess", tr("Reprocess"), {}, [this] { page_.reprocess(); });
    add("review/attach_reference", tr("Attach reference"), {},
        [this] { page_.sidebar().reference().chooseFile(); });
    add("review/full_report", tr("Open full report"), {}, [this] { page_.openFullReport(); });
    next_performer_ = add("review/next_performer", tr("Next performer"), QKeySequence("Shift+P"),
                          [this] { PerformerSwitch::showNext(studio_.take()); });
    side_by_side_ = add("review/side_by_side", tr("Results side by side"), {},
                        [&scenes] { scenes.setSideBySide(!scenes.isSideBySide()); });
    side_by_side_->setCheckable(true);
}

void ReviewActions::refresh() {
    const bool is_open = studio_.take().isOpen();
    for (QAction* action : all())
        action->setEnabled(is_open);
    Timeline& timeline = page_.center().timeline();
    const bool has_contact = timeline.contactBars().hasChosen();
    name_marker_->setEnabled(timeline.canEditMarker());
    delete_->setEnabled(has_contact || timeline.canEditMarker());
    delete_->setText(has_contact ? tr("Delete contact") : tr("Delete marker"));
    found_contacts_->setEnabled(studio_.contacts().areEdited());
    play_->setText(studio_.time().isPlaying() ? tr("Pause") : tr("Play"));
    loop_->setChecked(studio_.time().loops());
    side_by_side_->setChecked(page_.center().scenes().isSideBySide());
    next_performer_->setEnabled(studio_.take().isOfSeveral());
    side_by_side_->setEnabled(page_.center().scenes().canCompare());
}

}  // namespace noctule::ui
