<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>FieldText</name>
    <message numerus="yes">
        <source>Push its plug in until it clicks, or skip it. %n sensor(s) are missing.</source>
        <translation>
            <numerusform>Push its plug in until it clicks, or skip it. %n sensor is missing.</numerusform>
            <numerusform>Push its plug in until it clicks, or skip it. %n sensors are missing.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>JobWords</name>
    <message numerus="yes">
        <source>%n s left</source>
        <comment>seconds</comment>
        <translation>
            <numerusform>%n s left</numerusform>
            <numerusform>%n s left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n min left</source>
        <comment>minutes</comment>
        <translation>
            <numerusform>%n min left</numerusform>
            <numerusform>%n min left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LiveText</name>
    <message numerus="yes">
        <source>%n other(s) are silent too.</source>
        <translation>
            <numerusform>One other is silent too.</numerusform>
            <numerusform>%n others are silent too.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n board(s) are level. Press board %1 into its slot until it clicks, then let go of the plate.</source>
        <translation>
            <numerusform>One board is level. Press board %1 into its slot until it clicks, then let go of the plate.</numerusform>
            <numerusform>%n boards are level. Press board %1 into its slot until it clicks, then let go of the plate.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n board(s) are in place. Nothing touches them.</source>
        <translation>
            <numerusform>The board is in place. Nothing touches it.</numerusform>
            <numerusform>All %n boards are in place. Nothing touches them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other(s) are turned too.</source>
        <translation>
            <numerusform>One other is turned too.</numerusform>
            <numerusform>%n others are turned too.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other(s) move too.</source>
        <translation>
            <numerusform>One other moves too.</numerusform>
            <numerusform>%n others move too.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other(s) hardly moved either.</source>
        <translation>
            <numerusform>One other hardly moved either.</numerusform>
            <numerusform>%n others hardly moved either.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::AssignPanel</name>
    <message numerus="yes">
        <source>Listening for %n s.</source>
        <translation>
            <numerusform>Listening for %n&#xa0;s.</numerusform>
            <numerusform>Listening for %n&#xa0;s.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::BoardCard</name>
    <message numerus="yes">
        <source>%1 of %2 frames a second, %n bit error(s)</source>
        <translation>
            <numerusform>%1 of %2 frames a second, %n bit error</numerusform>
            <numerusform>%1 of %2 frames a second, %n bit errors</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ColumnsDialog</name>
    <message numerus="yes">
        <source>%n sensor(s) in these columns</source>
        <translation>
            <numerusform>%n sensor in these columns</numerusform>
            <numerusform>%n sensors in these columns</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ConnectPage</name>
    <message numerus="yes">
        <source>%n board(s) hear it well</source>
        <translation>
            <numerusform>%n board hears it well</numerusform>
            <numerusform>%n boards hear it well</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::DevicesPanel</name>
    <message numerus="yes">
        <source>%n board(s)</source>
        <translation>
            <numerusform>%n board</numerusform>
            <numerusform>%n boards</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportPage</name>
    <message numerus="yes">
        <source>Write %n files</source>
        <translation>
            <numerusform>Write %n file</numerusform>
            <numerusform>Write %n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files written and checked.</source>
        <translation>
            <numerusform>%n file written and checked.</numerusform>
            <numerusform>%n files written and checked.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Writing %n files</source>
        <translation>
            <numerusform>Writing %n file</numerusform>
            <numerusform>Writing %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportResultsPanel</name>
    <message numerus="yes">
        <source>%n files written and read back</source>
        <translation>
            <numerusform>%n file written and read back</numerusform>
            <numerusform>%n files written and read back</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each file was opened again and compared with its take. %n are not what they should be.</source>
        <translation>
            <numerusform>Each file was opened again and compared with its take. %n is not what it should be.</numerusform>
            <numerusform>Each file was opened again and compared with its take. %n are not what they should be.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each file was opened again and compared with its take. %n have something you should know.</source>
        <translation>
            <numerusform>Each file was opened again and compared with its take. %n has something you should know.</numerusform>
            <numerusform>Each file was opened again and compared with its take. %n have something you should know.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportRun</name>
    <message numerus="yes">
        <source>All boards were silent from %1 to %2. The pose in those %n frames is a guess.</source>
        <translation>
            <numerusform>All boards were silent from %1 to %2. The pose in that %n frame is a guess.</numerusform>
            <numerusform>All boards were silent from %1 to %2. The pose in those %n frames is a guess.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Board %1 (%2) was silent from %3 to %4. It follows its neighbours in those %n frames.</source>
        <translation>
            <numerusform>Board %1 (%2) was silent from %3 to %4. It follows its neighbours in that %n frame.</numerusform>
            <numerusform>Board %1 (%2) was silent from %3 to %4. It follows its neighbours in those %n frames.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportTakeList</name>
    <message numerus="yes">
        <source>%n results</source>
        <translation>
            <numerusform>%n result</numerusform>
            <numerusform>%n results</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::FieldSensors</name>
    <message numerus="yes">
        <source>Use the %n that are done</source>
        <translation>
            <numerusform>Use the %n that is done</numerusform>
            <numerusform>Use the %n that are done</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::FindingList</name>
    <message numerus="yes">
        <source>%n more</source>
        <comment>findings</comment>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::FitWords</name>
    <message numerus="yes">
        <source>the offsets of %n source(s)</source>
        <translation>
            <numerusform>the offsets of %n source</numerusform>
            <numerusform>the offsets of %n sources</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the accelerometers of %n board(s)</source>
        <translation>
            <numerusform>the accelerometers of %n board</numerusform>
            <numerusform>the accelerometers of %n boards</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the gyroscopes of %n board(s)</source>
        <translation>
            <numerusform>the gyroscopes of %n board</numerusform>
            <numerusform>the gyroscopes of %n boards</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the rest pose of %n board(s)</source>
        <translation>
            <numerusform>the rest pose of %n board</numerusform>
            <numerusform>the rest pose of %n boards</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::LevelMeters</name>
    <message numerus="yes">
        <source>%n board(s)</source>
        <translation>
            <numerusform>%n board</numerusform>
            <numerusform>%n boards</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::LiveSuits</name>
    <message numerus="yes">
        <source>%n suit(s) are connected, and more cannot be</source>
        <translation>
            <numerusform>%n suit is connected, and more cannot be</numerusform>
            <numerusform>%n suits are connected, and more cannot be</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::MainWindow</name>
    <message numerus="yes">
        <source>%n job(s) are still running</source>
        <translation>
            <numerusform>One job is still running</numerusform>
            <numerusform>%n jobs are still running</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n box(es)</source>
        <comment>connected</comment>
        <translation>
            <numerusform>%n box</numerusform>
            <numerusform>%n boxes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::Notices</name>
    <message numerus="yes">
        <source>and %n more</source>
        <comment>notices that are not shown</comment>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ProcessTakesDialog</name>
    <message numerus="yes">
        <source>Process %n take(s)</source>
        <translation>
            <numerusform>Process %n take</numerusform>
            <numerusform>Process %n takes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::RatingStars</name>
    <message numerus="yes">
        <source>%n of 5 stars</source>
        <translation>
            <numerusform>%n of 5 stars</numerusform>
            <numerusform>%n of 5 stars</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReadinessPanel</name>
    <message numerus="yes">
        <source>%n more</source>
        <comment>problems</comment>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n faint</source>
        <translation>
            <numerusform>%1, %n faint</numerusform>
            <numerusform>%1, %n faint</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Continue without %n boards</source>
        <translation>
            <numerusform>Continue without %n board</numerusform>
            <numerusform>Continue without %n boards</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReadinessWords</name>
    <message numerus="yes">
        <source>%n boards send nothing</source>
        <translation>
            <numerusform>%n board sends nothing</numerusform>
            <numerusform>%n boards send nothing</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boards cannot be understood</source>
        <translation>
            <numerusform>%n board cannot be understood</numerusform>
            <numerusform>%n boards cannot be understood</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boards bring about %1 of %2 frames a second, all alike: the link or this computer is too slow. Use a cable or a nearer access point, and close other programs.</source>
        <translation>
            <numerusform>%n board brings about %1 of %2 frames a second: the link or this computer is too slow. Use a cable or a nearer access point, and close other programs.</numerusform>
            <numerusform>%n boards bring about %1 of %2 frames a second, all alike: the link or this computer is too slow. Use a cable or a nearer access point, and close other programs.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boards reach their limits</source>
        <translation>
            <numerusform>%n board reaches its limits</numerusform>
            <numerusform>%n boards reach their limits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boards hear no source</source>
        <translation>
            <numerusform>%n board hears no source</numerusform>
            <numerusform>%n boards hear no source</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sources are not heard</source>
        <translation>
            <numerusform>%n source is not heard</numerusform>
            <numerusform>%n sources are not heard</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n things to fix.</source>
        <translation>
            <numerusform>%n thing to fix.</numerusform>
            <numerusform>%n things to fix.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n things to know.</source>
        <translation>
            <numerusform>%n thing to know.</numerusform>
            <numerusform>%n things to know.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecentSessionModel</name>
    <message numerus="yes">
        <source>%n take(s), %1</source>
        <comment>number of takes, their time together</comment>
        <translation>
            <numerusform>%n take, %1</numerusform>
            <numerusform>%n takes, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged</source>
        <comment>takes</comment>
        <translation>
            <numerusform>%n damaged</numerusform>
            <numerusform>%n damaged</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n interrupted</source>
        <comment>takes</comment>
        <translation>
            <numerusform>%n interrupted</numerusform>
            <numerusform>%n interrupted</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not processed</source>
        <comment>takes</comment>
        <translation>
            <numerusform>%n not processed</numerusform>
            <numerusform>%n not processed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordBar</name>
    <message numerus="yes">
        <source>%n second(s)</source>
        <translation>
            <numerusform>%n second</numerusform>
            <numerusform>%n seconds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordProblems</name>
    <message numerus="yes">
        <source>They are marked as %n gap(s), and time does not shift.</source>
        <translation>
            <numerusform>They are marked as one gap, and time does not shift.</numerusform>
            <numerusform>They are marked as %n gaps, and time does not shift.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>things to look at</comment>
        <translation>
            <numerusform>one more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordingDialog</name>
    <message numerus="yes">
        <source>Import %1 and %n more</source>
        <translation>
            <numerusform>Import %1 and %n more</numerusform>
            <numerusform>Import %1 and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s) sit nowhere: poses leave them out.</source>
        <translation>
            <numerusform>%n sensor sits nowhere: poses leave it out.</numerusform>
            <numerusform>%n sensors sit nowhere: poses leave them out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReportPanel</name>
    <message numerus="yes">
        <source>%n more in the full report</source>
        <translation>
            <numerusform>%n more in the full report</numerusform>
            <numerusform>%n more in the full report</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n found</numerusform>
            <numerusform>%n found</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n, set by hand</source>
        <translation>
            <numerusform>%n, set by hand</numerusform>
            <numerusform>%n, set by hand</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReviewWords</name>
    <message numerus="yes">
        <source>%n other boards lost some too. Their neighbours carry them meanwhile; check plugs and cables before the next take.</source>
        <translation>
            <numerusform>%n other board lost some too. Its neighbours carry it meanwhile; check plugs and cables before the next take.</numerusform>
            <numerusform>%n other boards lost some too. Their neighbours carry them meanwhile; check plugs and cables before the next take.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::RobotDrive</name>
    <message numerus="yes">
        <source>%n command(s) and states of the robot are not in %1.</source>
        <translation>
            <numerusform>%n command or state of the robot is not in %1.</numerusform>
            <numerusform>%n commands and states of the robot are not in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::RobotSidebar</name>
    <message numerus="yes">
        <source>%n joint(s) driven</source>
        <translation>
            <numerusform>%n joint driven</numerusform>
            <numerusform>%n joints driven</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::RoomPage</name>
    <message numerus="yes">
        <source>hears anchor %1</source>
        <translation>
            <numerusform>hears anchor %1</numerusform>
            <numerusform>hears anchors %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Walk slowly past all %n anchor(s)</source>
        <translation>
            <numerusform>Walk slowly past the anchor</numerusform>
            <numerusform>Walk slowly past all %n anchors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not good yet: anchor %1. Walk slowly past, and turn.</source>
        <translation>
            <numerusform>Not good yet: anchor %1. Walk slowly past, and turn.</numerusform>
            <numerusform>Not good yet: anchors %1. Walk slowly past, and turn.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Without anchor %1: the file lacks it, and in this take its place stays as it was. The other places stay as they were found with it; to find them without it, take it away and walk again.</source>
        <translation>
            <numerusform>Without anchor %1: the file lacks it, and in this take its place stays as it was. The other places stay as they were found with it; to find them without it, take it away and walk again.</numerusform>
            <numerusform>Without anchors %1: the file lacks them, and in this take their places stay as they were. The other places stay as they were found with them; to find them without them, take them away and walk again.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::SessionModel</name>
    <message numerus="yes">
        <source>%n take(s) copied into the session</source>
        <translation>
            <numerusform>%n take copied into the session</numerusform>
            <numerusform>%n takes copied into the session</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Importing %n take(s)</source>
        <translation>
            <numerusform>Importing %n take</numerusform>
            <numerusform>Importing %n takes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::SessionNotices</name>
    <message numerus="yes">
        <source>The studio ended unexpectedly. All %n take(s) were looked at again; changes were kept up to the last second.</source>
        <translation>
            <numerusform>The studio ended unexpectedly. Its take was looked at again; changes were kept up to the last second.</numerusform>
            <numerusform>The studio ended unexpectedly. All %n takes were looked at again; changes were kept up to the last second.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n takes broke off</source>
        <translation>
            <numerusform>%n take broke off</numerusform>
            <numerusform>%n takes broke off</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ShotListDialog</name>
    <message numerus="yes">
        <source>%n shot(s)</source>
        <translation>
            <numerusform>%n shot</numerusform>
            <numerusform>%n shots</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n take(s)</source>
        <translation>
            <numerusform>%n take</numerusform>
            <numerusform>%n takes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::StartPage</name>
    <message numerus="yes">
        <source>The studio ended unexpectedly while this session was open. Its %n take(s) are safe; changes to notes and ratings were saved up to the last second.</source>
        <translation>
            <numerusform>The studio ended unexpectedly while this session was open. Its take is safe; changes to notes and ratings were saved up to the last second.</numerusform>
            <numerusform>The studio ended unexpectedly while this session was open. Its %n takes are safe; changes to notes and ratings were saved up to the last second.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::StatusLine</name>
    <message numerus="yes">
        <source>%n jobs running</source>
        <translation>
            <numerusform>%n job running</numerusform>
            <numerusform>%n jobs running</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n job(s) failed</source>
        <translation>
            <numerusform>%n job failed</numerusform>
            <numerusform>%n jobs failed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n job(s) finished</source>
        <translation>
            <numerusform>%n job finished</numerusform>
            <numerusform>%n jobs finished</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boxes streaming</source>
        <translation>
            <numerusform>%n box streaming</numerusform>
            <numerusform>%n boxes streaming</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n block(s) lost</source>
        <translation>
            <numerusform>%n block lost</numerusform>
            <numerusform>%n blocks lost</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::Studio</name>
    <message numerus="yes">
        <source>%1 of %2 is ready: %n pose(s)</source>
        <comment>name of the result, of the take</comment>
        <translation>
            <numerusform>%1 of %2 is ready: %n pose</numerusform>
            <numerusform>%1 of %2 is ready: %n poses</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::SuitCards</name>
    <message numerus="yes">
        <source>%1, and %n more</source>
        <comment>what is wrong first</comment>
        <translation>
            <numerusform>%1, and %n more</numerusform>
            <numerusform>%1, and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeList</name>
    <message numerus="yes">
        <source>%n stars</source>
        <translation>
            <numerusform>%n star</numerusform>
            <numerusform>%n stars</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeListModel</name>
    <message numerus="yes">
        <source>%1, %2, %3, %n stars</source>
        <translation>
            <numerusform>%1, %2, %3, %n star</numerusform>
            <numerusform>%1, %2, %3, %n stars</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::TransportBar</name>
    <message numerus="yes">
        <source>%1, %2 frames</source>
        <comment>length between in and out</comment>
        <translation>
            <numerusform>%1, %2 frame</numerusform>
            <numerusform>%1, %2 frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::WizardIntro</name>
    <message numerus="yes">
        <source>%n step(s) were taken on %1 and are kept.</source>
        <translation>
            <numerusform>One step was taken (%1) and is kept.</numerusform>
            <numerusform>%n steps were taken (%1) and are kept.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n distance(s)</source>
        <translation>
            <numerusform>%1: one distance</numerusform>
            <numerusform>%1: %n distances</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::WizardResult</name>
    <message numerus="yes">
        <source>%n thing(s) to look at.</source>
        <translation>
            <numerusform>One thing to look at.</numerusform>
            <numerusform>%n things to look at.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::words</name>
    <message numerus="yes">
        <source>%n hour(s)</source>
        <comment>an age</comment>
        <translation>
            <numerusform>%n hour</numerusform>
            <numerusform>%n hours</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s)</source>
        <comment>an age</comment>
        <translation>
            <numerusform>%n day</numerusform>
            <numerusform>%n days</numerusform>
        </translation>
    </message>
</context>
</TS>
