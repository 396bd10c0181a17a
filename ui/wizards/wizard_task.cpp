// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_task.h"

#include <QCoreApplication>

#include "core/guide/field_guide.h"
#include "core/guide/movement_guide.h"

namespace noctule::ui {
namespace {

struct TaskText {
    Q_DECLARE_TR_FUNCTIONS(WizardTask)
};

/// +x -x +y -y +z -z of the boards: what lies below then (rig_drawing.h).
struct Side {
    const char *hint, *plate, *table;
};
constexpr Side kSides[] = {
    {QT_TRANSLATE_NOOP("WizardTask", "edge C down"),
     QT_TRANSLATE_NOOP("WizardTask", "Stand the plate on edge C, against the block"),
     QT_TRANSLATE_NOOP("WizardTask", "Stand the plate on edge C and start the table")},
    {QT_TRANSLATE_NOOP("WizardTask", "edge D down"),
     QT_TRANSLATE_NOOP("WizardTask", "Stand the plate on edge D, against the block"),
     QT_TRANSLATE_NOOP("WizardTask", "Stand the plate on edge D and start the table")},
    {QT_TRANSLATE_NOOP("WizardTask", "edge B down"),
     QT_TRANSLATE_NOOP("WizardTask", "Stand the plate on edge B, against the block"),
     QT_TRANSLATE_NOOP("WizardTask", "Stand the plate on edge B and start the table")},
    {QT_TRANSLATE_NOOP("WizardTask", "edge A down"),
     QT_TRANSLATE_NOOP("WizardTask", "Stand the plate on edge A, against the block"),
     QT_TRANSLATE_NOOP("WizardTask", "Stand the plate on edge A and start the table")},
    {QT_TRANSLATE_NOOP("WizardTask", "face up"),
     QT_TRANSLATE_NOOP("WizardTask", "Lay the plate flat, face up"),
     QT_TRANSLATE_NOOP("WizardTask", "Lay the plate flat, face up, and start the table")},
    {QT_TRANSLATE_NOOP("WizardTask", "face down"),
     QT_TRANSLATE_NOOP("WizardTask", "Lay the plate flat, face down"),
     QT_TRANSLATE_NOOP("WizardTask", "Lay the plate flat, face down, and start the table")},
};

WizardWords sources() {
    return {
        TaskText::tr("Source offsets"),
        "jig",
        TaskText::tr("How late each source sounds, so that distances are right to the millimetre."),
        TaskText::tr("Suit on its jig, about 6 minutes; once a year"),
        {TaskText::tr("The jig with boards and sources in their seats, 30 to 90 cm apart"),
         TaskText::tr("The distances between them: points of a digitizer arm or a tape measure, as CSV"),
         TaskText::tr("A quiet room and a thermometer in the driver box")},
        TaskText::tr("Boards and sources face each other and nothing stands between them. Box and wires stay "
                     "where they are; only the stands move from one placement to the next."),
        TaskText::tr("Placements may come in any order. The page hears by itself which one stands there."),
        TaskText::tr("Put boards and sources on the jig")};
}

WizardWords accelerometers() {
    return {
        TaskText::tr("Accelerometers"),
        "plate",
        TaskText::tr("Scale, zero and axes of each accelerometer."),
        TaskText::tr("Boards on the level plate, six sides, about 4 minutes; every three months"),
        {TaskText::tr("The plate with all boards pressed into their slots, up to 32 at once"),
         TaskText::tr("A level table (use a spirit level), and a square block to lean the plate on")},
        TaskText::tr(
            "Box and wires lie beside the plate with a metre of slack, so that nothing pulls at it when it "
            "is turned."),
        TaskText::tr("Sides may come in any order. The page sees by itself which one is down."),
        TaskText::tr("Press all boards into the plate")};
}

WizardWords gyroscopes() {
    return {TaskText::tr("Gyroscopes"),
            "turntable",
            TaskText::tr("Scale, zero and axes of each gyroscope."),
            TaskText::tr("Boards on the turntable, six sides, about 5 minutes; every three months"),
            {TaskText::tr(
                 "A turntable at 45, 33 1/3 or 78 turns a minute that carries the plate and the driver box"),
             TaskText::tr("The plate with all boards pressed into their slots"),
             TaskText::tr("A wireless or battery driver box, or a cable with a swivel")},
            TaskText::tr(
                "The box rides on the table beside the plate, its wires taped down. With a cable to the "
                "computer instead, ten turns wind it up as far as is safe: stop after each side and unwind."),
            TaskText::tr("Sides may come in any order. The page sees by itself which one turns."),
            TaskText::tr("Put the plate and the box on the turntable")};
}

WizardWords magnetometers() {
    return {TaskText::tr("Magnetometers"),
            "magnet",
            TaskText::tr("What the iron of each board does to the Earth’s field, so that headings hold."),
            TaskText::tr("A bag, 1 m from steel, 2 minutes; every three months"),
            {TaskText::tr("The suit, off the body, in a bag or in both hands; one sensor alone will do too"),
             TaskText::tr("A spot 1 m away from steel, radiators, loudspeakers and telephones")},
            TaskText::tr(
                "Take rings, watches and buckles out of the bag. The box lies in it too, or its cable is "
                "long enough to be turned."),
            TaskText::tr("One sensor, several, or all in a bag: each is judged by itself."),
            TaskText::tr("Put all sensors in a bag")};
}

StepWords fieldStep(int step) {
    switch (step) {
        case FieldGuide::kSpot:
            return {TaskText::tr("Field of this spot"), TaskText::tr("strength, dip, evenness"),
                    TaskText::tr("Carry it about slowly")};
        case FieldGuide::kFloor:
            return {TaskText::tr("Field near the floor"), TaskText::tr("where steel lies in most houses"),
                    TaskText::tr("Lower it to the floor")};
        default:
            return {TaskText::tr("Turn through all directions"), TaskText::tr("each by itself"),
                    TaskText::tr("Turn it slowly")};
    }
}

WizardWords restPose() {
    return {TaskText::tr("Rest pose"),
            "rest_pose",
            TaskText::tr("How the boards sit on the performer today."),
            TaskText::tr("Stand still for 5 seconds; each time the suit is put on"),
            {TaskText::tr("The performer with the suit on, all straps tight"),
             TaskText::tr("Two metres of free floor")},
            TaskText::tr(
                "As in the drawing: feet hip-wide and parallel, arms hanging a little away from the body, "
                "elbows slightly bent, palms towards the body, eyes straight ahead."),
            TaskText::tr("After Begin it counts by itself as soon as the performer stands still."),
            TaskText::tr("Stand in the rest pose")};
}

WizardWords movement() {
    return {
        TaskText::tr("Movement"),
        "skeleton",
        TaskText::tr("How each board sits on the moving body; lengths of bones and places of sources too."),
        TaskText::tr("Six exercises, about 2 minutes; after the rest pose, each time the suit is put on"),
        {TaskText::tr("The performer with the suit on, all straps tight, the rest pose calibrated"),
         TaskText::tr("Two metres of free floor in all directions")},
        TaskText::tr("Each exercise begins in the rest pose, as in the drawing: arms hanging a little away "
                     "from the body, elbows slightly bent, palms towards the body, eyes straight ahead. Then "
                     "move smoothly, as far as is comfortable, for 8 seconds."),
        TaskText::tr("One exercise after the other. The page sees when you stand and when you move."),
        TaskText::tr("Stand ready in the rest pose")};
}

/// In the order of Exercise.
struct ExerciseText {
    const char *name, *instruction;
};
constexpr ExerciseText kExercises[kExerciseCount] = {
    {QT_TRANSLATE_NOOP("WizardTask", "Squats"),
     QT_TRANSLATE_NOOP("WizardTask", "Squat, bend the elbows and turn the hands")},
    {QT_TRANSLATE_NOOP("WizardTask", "Arm circles"),
     QT_TRANSLATE_NOOP("WizardTask", "Circle both arms, large and slowly")},
    {QT_TRANSLATE_NOOP("WizardTask", "Leg swings"),
     QT_TRANSLATE_NOOP("WizardTask", "Swing one leg, then the other; bend knees and feet")},
    {QT_TRANSLATE_NOOP("WizardTask", "Trunk"),
     QT_TRANSLATE_NOOP("WizardTask", "Bend and turn the trunk to all sides")},
    {QT_TRANSLATE_NOOP("WizardTask", "Head and shoulders"),
     QT_TRANSLATE_NOOP("WizardTask", "Nod and turn the head, shrug, roll the wrists")},
    {QT_TRANSLATE_NOOP("WizardTask", "March"),
     QT_TRANSLATE_NOOP("WizardTask", "March on the spot and swing the arms")},
};

WizardWords check() {
    return {TaskText::tr("Check"),
            "check",
            TaskText::tr("Says whether the calibration still holds, or which strap has slipped."),
            TaskText::tr("Stand still for 3 seconds; before each take that matters"),
            {TaskText::tr("The performer with the suit on, and a calibration in force")},
            TaskText::tr(
                "As in the drawing: feet hip-wide and parallel, arms hanging a little away from the body, "
                "elbows slightly bent, palms towards the body, eyes straight ahead."),
            TaskText::tr("After Begin it counts by itself as soon as the performer stands still."),
            TaskText::tr("Stand still for three seconds")};
}

}  // namespace

WizardWords wordsOf(WizardTask task) {
    switch (task) {
        case WizardTask::kSources:
            return sources();
        case WizardTask::kAccelerometers:
            return accelerometers();
        case WizardTask::kGyroscopes:
            return gyroscopes();
        case WizardTask::kMagnetometers:
            return magnetometers();
        case WizardTask::kRestPose:
            return restPose();
        case WizardTask::kMovement:
            return movement();
        case WizardTask::kCheck:
            return check();
    }
    return {};
}

std::optional<CalibrationStep> stepOf(WizardTask task) {
    switch (task) {
        case WizardTask::kSources:
            return CalibrationStep::kSources;
        case WizardTask::kAccelerometers:
            return CalibrationStep::kAccelerometers;
        case WizardTask::kGyroscopes:
            return CalibrationStep::kGyroscopes;
        case WizardTask::kMagnetometers:
            return CalibrationStep::kMagnetometers;
        case WizardTask::kRestPose:
            return CalibrationStep::kRestPose;
        case WizardTask::kMovement:
            return CalibrationStep::kMovement;
        case WizardTask::kCheck:
            break;
    }
    return std::nullopt;
}

QString keyOf(WizardTask task) {
    const auto step = stepOf(task);
    return step ? QString(noctule::keyOf(*step)) : QStringLiteral("check");
}

QString takeKindOf(WizardTask task) {
    constexpr const char* kKinds[] = {"jig", "level", "turntable", "motion", "motion", "motion", "motion"};
    return kKinds[static_cast<int>(task)];
}

double holdOf(WizardTask task) {
    // Gravity's ripple shows the table's speed: 6.5 s at 45 rpm are too few turns for "good", 8.5 s are
    // enough.
    constexpr double kHolds_s[] = {6, 4, 9, 1.5, 5, MovementGuide::kMove_s, 3};
    return kHolds_s[static_cast<int>(task)];
}

double leadOf(WizardTask task) {
    return task == WizardTask::kMovement ? MovementGuide::kStand_s : 0;
}

bool isWorn(WizardTask task) {
    return pictureOf(task) == RigPicture::Kind::kStand;
}

StepWords stepWordsOf(WizardTask task, int step, int up, const QString& label) {
    switch (task) {
        case WizardTask::kSources:
            return {TaskText::tr("Placement %1").arg(label), TaskText::tr("as it was measured"),
                    TaskText::tr("Put boards and sources as in placement %1").arg(label)};
        case WizardTask::kAccelerometers:
            return {TaskText::tr("Side %1").arg(step + 1), TaskText::tr(kSides[up].hint),
                    TaskText::tr(kSides[up].plate)};
        case WizardTask::kGyroscopes:
            return {TaskText::tr("Turn %1").arg(step + 1), TaskText::tr(kSides[up].hint),
                    TaskText::tr(kSides[up].table)};
        case WizardTask::kMagnetometers:
            return fieldStep(step);
        case WizardTask::kMovement:
            return {TaskText::tr(kExercises[step].name), TaskText::tr("from the rest pose"),
                    TaskText::tr(kExercises[step].instruction)};
        case WizardTask::kRestPose:
        case WizardTask::kCheck:
            break;
    }
    return {TaskText::tr("Stand still"), TaskText::tr("rest pose"),
            TaskText::tr("Stand still in the rest pose")};
}

RigPicture::Kind pictureOf(WizardTask task) {
    constexpr RigPicture::Kind kKinds[] = {RigPicture::Kind::kJig,       RigPicture::Kind::kPlate,
                                           RigPicture::Kind::kTurntable, RigPicture::Kind::kPlate,
                                           RigPicture::Kind::kStand,     RigPicture::Kind::kStand,
                                           RigPicture::Kind::kStand};
    return kKinds[static_cast<int>(task)];
}

}  // namespace noctule::ui
