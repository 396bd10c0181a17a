<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>app/studio</name>
    <message>
        <source>Install Noctule again</source>
        <translation>Noctule neu installieren</translation>
    </message>
    <message>
        <source>Preparing the motion</source>
        <translation>Bewegung wird vorbereitet</translation>
    </message>
    <message>
        <source>The sample motion is not part of this program</source>
        <translation>Die Beispielbewegung ist nicht Teil dieses Programms</translation>
    </message>
</context>
<context>
    <name>core/acoustics</name>
    <message>
        <source>A pulse interval of %1 samples is not 1 ms to 1 s</source>
        <translation>Ein Pulsabstand von %1 Abtastwerten ist nicht 1 ms bis 1 s</translation>
    </message>
    <message>
        <source>A suit of %1 boards cannot be heard</source>
        <translation>Ein Anzug mit %1 Platinen kann nicht gehört werden</translation>
    </message>
    <message>
        <source>Check the suit: 1 to 32 boards</source>
        <translation>Den Anzug prüfen: 1 bis 32 Platinen</translation>
    </message>
    <message>
        <source>Pulses of %1 cycles are too long for the matched detector (0.45 ms at most)</source>
        <translation>Pulse von %1 Schwingungen sind zu lang für den Detektor am ganzen Puls (höchstens 0,45 ms)</translation>
    </message>
    <message>
        <source>Source %1 yields no ranges: the calibration has %2</source>
        <translation>Quelle %1 liefert keine Entfernungen: die Kalibrierung hat %2</translation>
    </message>
    <message>
        <source>The pulses have no drive frequency or no cycles</source>
        <translation>Die Pulse haben keine Sendefrequenz oder keine Schwingungen</translation>
    </message>
    <message>
        <source>The sample rate of %1 Hz does not suit 40 kHz pulses (100 kHz to 1 MHz do)</source>
        <translation>Die Abtastrate von %1 Hz passt nicht zu Pulsen von 40 kHz (100 kHz bis 1 MHz passen)</translation>
    </message>
    <message>
        <source>Use the inflection detector, or shorter pulses; 10 cycles of 40 kHz are usual</source>
        <translation>Den Detektor am Anstieg des Pulses oder kürzere Pulse verwenden; üblich sind 10 Schwingungen von 40 kHz</translation>
    </message>
    <message>
        <source>inflection</source>
        <translation>am Anstieg des Pulses</translation>
    </message>
    <message>
        <source>matched</source>
        <translation>am ganzen Puls</translation>
    </message>
    <message>
        <source>neither its offset for detector</source>
        <translation>weder ihren Versatz für den Detektor</translation>
    </message>
    <message>
        <source>no such source</source>
        <translation>keine solche Quelle</translation>
    </message>
</context>
<context>
    <name>core/assignment</name>
    <message>
        <source>%1 sensors are no set that a body is known for</source>
        <translation>%1 Sensoren sind kein Satz, für den ein Körper bekannt ist</translation>
    </message>
    <message>
        <source>Give 7 (hips and legs), 8 (and the chest) or 16 (whole body), or assign by names</source>
        <translation>7 (Hüfte und Beine), 8 (dazu die Brust) oder 16 (ganzer Körper) angeben oder nach Namen zuordnen</translation>
    </message>
    <message>
        <source>Import sensors of one recording and rate</source>
        <translation>Sensoren einer einzigen Aufzeichnung und Rate importieren</translation>
    </message>
    <message>
        <source>Joints between sensors</source>
        <translation>Gelenke zwischen Sensoren</translation>
    </message>
    <message>
        <source>Left and right arm could hardly be told apart; turn round and swing the arms</source>
        <translation>Linker und rechter Arm ließen sich kaum unterscheiden; sich umdrehen und die Arme schwingen</translation>
    </message>
    <message>
        <source>Left and right leg could hardly be told apart; walk for ten seconds and more</source>
        <translation>Linkes und rechtes Bein ließen sich kaum unterscheiden; zehn Sekunden und länger gehen</translation>
    </message>
    <message>
        <source>Record both quantities, or assign by names</source>
        <translation>Beide Größen aufnehmen oder nach Namen zuordnen</translation>
    </message>
    <message>
        <source>Sensors cannot be assigned by movement: %1</source>
        <translation>Sensoren lassen sich nicht durch Bewegung zuordnen: %1</translation>
    </message>
    <message>
        <source>Walk for ten seconds and more</source>
        <translation>Zehn Sekunden und länger gehen</translation>
    </message>
    <message>
        <source>nothing moves</source>
        <translation>nichts bewegt sich</translation>
    </message>
    <message>
        <source>sensor %1 lacks too many readings of gyroscope or accelerometer</source>
        <translation>Sensor %1 fehlen zu viele Messwerte von Gyroskop oder Beschleunigungssensor</translation>
    </message>
    <message>
        <source>the recording is shorter than 5 s</source>
        <translation>die Aufzeichnung ist kürzer als 5 s</translation>
    </message>
    <message>
        <source>their rates or lengths differ</source>
        <translation>ihre Raten oder Längen sind verschieden</translation>
    </message>
</context>
<context>
    <name>core/body</name>
    <message>
        <source>%1 by the bone map</source>
        <translation>%1 nach der Knochenzuordnung</translation>
    </message>
    <message>
        <source>%1 by the bone map by name</source>
        <translation>%1 nach der Knochenzuordnung, die anderen nach ihrem Namen</translation>
    </message>
    <message>
        <source>%1 distance</source>
        <translation>%1 Entfernung</translation>
    </message>
    <message>
        <source>%1 distances</source>
        <translation>%1 Entfernungen</translation>
    </message>
    <message>
        <source>%1 frame</source>
        <translation>%1 Bild</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>%1 is free but not the root</source>
        <translation>%1 ist frei, aber nicht die Wurzel</translation>
    </message>
    <message>
        <source>%1 joint</source>
        <translation>%1 Gelenk</translation>
    </message>
    <message>
        <source>%1 joint is</source>
        <translation>%1 Gelenk ist</translation>
    </message>
    <message>
        <source>%1 joints</source>
        <translation>%1 Gelenke</translation>
    </message>
    <message>
        <source>%1 joints are</source>
        <translation>%1 Gelenke sind</translation>
    </message>
    <message>
        <source>%1 joints by name</source>
        <translation>%1 Gelenke nach ihrem Namen</translation>
    </message>
    <message>
        <source>%1 lists %2 freedoms, which does not fit its type</source>
        <translation>%1 führt %2 Freiheiten auf, was nicht zu seiner Art passt</translation>
    </message>
    <message>
        <source>%1 of them by shape</source>
        <translation>%1 davon nach ihrer Gestalt</translation>
    </message>
    <message>
        <source>%1 reading</source>
        <translation>%1 Messwert</translation>
    </message>
    <message>
        <source>%1 readings</source>
        <translation>%1 Messwerte</translation>
    </message>
    <message>
        <source>%1 rest pose</source>
        <translation>%1 Ruhehaltung</translation>
    </message>
    <message>
        <source>%1 rest poses</source>
        <translation>%1 Ruhehaltungen</translation>
    </message>
    <message>
        <source>%1 texture</source>
        <translation>%1 Textur</translation>
    </message>
    <message>
        <source>%1 textures</source>
        <translation>%1 Texturen</translation>
    </message>
    <message>
        <source>%1: an offset is not a finite number</source>
        <translation>%1: ein Versatz ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1: its parent %2 does not come before it</source>
        <translation>%1: das übergeordnete Gelenk %2 kommt nicht davor</translation>
    </message>
    <message>
        <source>%1: the axis of %2 is not a unit vector</source>
        <translation>%1: die Achse von %2 ist kein Einheitsvektor</translation>
    </message>
    <message>
        <source>%1: the limits of %2 are reversed</source>
        <translation>%1: die Grenzen von %2 sind vertauscht</translation>
    </message>
    <message>
        <source>1 unit = %1 m</source>
        <translation>1 Einheit = %1 m</translation>
    </message>
    <message>
        <source>A pose</source>
        <translation>A-Pose</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Bauch</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>Adresse ist schon in Gebrauch</translation>
    </message>
    <message>
        <source>Ball joints have three, universal two, hinges one, free and fixed none</source>
        <translation>Kugelgelenke haben drei, Kardangelenke zwei, Scharniere eine, freie und feste keine</translation>
    </message>
    <message>
        <source>Base of the neck</source>
        <translation>Halsansatz</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>Verbindung ist abgerissen</translation>
    </message>
    <message>
        <source>Cannot assign requested address</source>
        <translation>Adresse ist hier nicht verfügbar</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Verbindung verweigert</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>Verbindung von der Gegenseite beendet</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>Verbindung kam nicht rechtzeitig zustande</translation>
    </message>
    <message>
        <source>Correct the axis</source>
        <translation>Die Achse berichtigen</translation>
    </message>
    <message>
        <source>Correct the joint's offset</source>
        <translation>Den Versatz des Gelenks berichtigen</translation>
    </message>
    <message>
        <source>Correct the limits</source>
        <translation>Die Grenzen berichtigen</translation>
    </message>
    <message>
        <source>Describe at least the root</source>
        <translation>Wenigstens die Wurzel beschreiben</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Gerät ist belegt</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>Ordner ist nicht leer</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>zugeteilter Platz ist verbraucht</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Datei ist schon vorhanden</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname ist zu lang</translation>
    </message>
    <message>
        <source>Give every joint a name</source>
        <translation>Jedem Gelenk einen Namen geben</translation>
    </message>
    <message>
        <source>Give every joint its own name</source>
        <translation>Jedem Gelenk einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Lese- oder Schreibfehler</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>ungültige Angabe</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ein Ordner</translation>
    </message>
    <message>
        <source>Left ankle</source>
        <translation>Linkes Sprunggelenk</translation>
    </message>
    <message>
        <source>Left clavicle</source>
        <translation>Linkes Schlüsselbein</translation>
    </message>
    <message>
        <source>Left elbow</source>
        <translation>Linker Ellbogen</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Linker Fuß</translation>
    </message>
    <message>
        <source>Left forearm</source>
        <translation>Linker Unterarm</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Left hip</source>
        <translation>Linke Hüfte</translation>
    </message>
    <message>
        <source>Left knee</source>
        <translation>Linkes Knie</translation>
    </message>
    <message>
        <source>Left shin</source>
        <translation>Linker Unterschenkel</translation>
    </message>
    <message>
        <source>Left shoulder</source>
        <translation>Linke Schulter</translation>
    </message>
    <message>
        <source>Left thigh</source>
        <translation>Linker Oberschenkel</translation>
    </message>
    <message>
        <source>Left toes</source>
        <translation>Linke Zehen</translation>
    </message>
    <message>
        <source>Left upper arm</source>
        <translation>Linker Oberarm</translation>
    </message>
    <message>
        <source>Left wrist</source>
        <translation>Linkes Handgelenk</translation>
    </message>
    <message>
        <source>List parents first; only joint 0 has parent -1</source>
        <translation>Übergeordnete Gelenke zuerst aufführen; nur Gelenk 0 hat parent -1</translation>
    </message>
    <message>
        <source>Lower back</source>
        <translation>Unterer Rücken</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>Netzwerk ist nicht erreichbar</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>Rechner ist nicht erreichbar</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>Gerät nicht gefunden</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>kein Ordner</translation>
    </message>
    <message>
        <source>Not usable</source>
        <translation>Nicht brauchbar</translation>
    </message>
    <message>
        <source>Only joint 0 may be free</source>
        <translation>Nur Gelenk 0 darf frei sein</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>Pelvis</source>
        <translation>Becken</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Datenträger ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Right ankle</source>
        <translation>Rechtes Sprunggelenk</translation>
    </message>
    <message>
        <source>Right clavicle</source>
        <translation>Rechtes Schlüsselbein</translation>
    </message>
    <message>
        <source>Right elbow</source>
        <translation>Rechter Ellbogen</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Rechter Fuß</translation>
    </message>
    <message>
        <source>Right forearm</source>
        <translation>Rechter Unterarm</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Right hip</source>
        <translation>Rechte Hüfte</translation>
    </message>
    <message>
        <source>Right knee</source>
        <translation>Rechtes Knie</translation>
    </message>
    <message>
        <source>Right shin</source>
        <translation>Rechter Unterschenkel</translation>
    </message>
    <message>
        <source>Right shoulder</source>
        <translation>Rechte Schulter</translation>
    </message>
    <message>
        <source>Right thigh</source>
        <translation>Rechter Oberschenkel</translation>
    </message>
    <message>
        <source>Right toes</source>
        <translation>Rechte Zehen</translation>
    </message>
    <message>
        <source>Right upper arm</source>
        <translation>Rechter Oberarm</translation>
    </message>
    <message>
        <source>Right wrist</source>
        <translation>Rechtes Handgelenk</translation>
    </message>
    <message>
        <source>T pose</source>
        <translation>T-Pose</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Upper back</source>
        <translation>Oberer Rücken</translation>
    </message>
    <message>
        <source>Usable</source>
        <translation>Brauchbar</translation>
    </message>
    <message>
        <source>base of the neck</source>
        <translation>Halsansatz</translation>
    </message>
    <message>
        <source>board %1</source>
        <translation>Platine %1</translation>
    </message>
    <message>
        <source>foot talus</source>
        <translation>foot talus</translation>
    </message>
    <message>
        <source>heard but unused %1</source>
        <translation>gehört, aber nicht verwendet %1</translation>
    </message>
    <message>
        <source>hidden by the body %1</source>
        <translation>vom Körper verdeckt %1</translation>
    </message>
    <message>
        <source>hip leg</source>
        <translation>hip leg</translation>
    </message>
    <message>
        <source>hips pelvis spinebase</source>
        <translation>hips pelvis spinebase</translation>
    </message>
    <message>
        <source>joint number %1 has no name</source>
        <translation>Gelenk Nummer %1 hat keinen Namen</translation>
    </message>
    <message>
        <source>lower back</source>
        <translation>unterer Rücken</translation>
    </message>
    <message>
        <source>missing %1</source>
        <translation>fehlend %1</translation>
    </message>
    <message>
        <source>neck0 neck1 neckbase</source>
        <translation>neck0 neck1 neckbase</translation>
    </message>
    <message>
        <source>rejected by the gate %1</source>
        <translation>vom Filter verworfen %1</translation>
    </message>
    <message>
        <source>root bip01 bip001 bip</source>
        <translation>root bip01 bip001 bip</translation>
    </message>
    <message>
        <source>root given</source>
        <translation>Wurzel vorgegeben</translation>
    </message>
    <message>
        <source>sitting</source>
        <translation>sitzend</translation>
    </message>
    <message>
        <source>source %1</source>
        <translation>Quelle %1</translation>
    </message>
    <message>
        <source>the skeleton has no joints</source>
        <translation>das Skelett hat keine Gelenke</translation>
    </message>
    <message>
        <source>toe1 metatarsals</source>
        <translation>toe1 metatarsals</translation>
    </message>
    <message>
        <source>two joints are named %1</source>
        <translation>zwei Gelenke heißen %1</translation>
    </message>
    <message>
        <source>unit %1</source>
        <translation>Einheit %1</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>Oberarm</translation>
    </message>
    <message>
        <source>upper back</source>
        <translation>oberer Rücken</translation>
    </message>
    <message>
        <source>used %1</source>
        <translation>verwendet %1</translation>
    </message>
</context>
<context>
    <name>core/calibration/accelerometer</name>
    <message>
        <source>Check that nothing shakes or pushes the board, and repeat this position</source>
        <translation>Prüfen, ob etwas die Platine erschüttert oder anstößt, und diese Stellung wiederholen</translation>
    </message>
    <message>
        <source>Check the board's range in the suit description; if that is right, change the board</source>
        <translation>Den Messbereich der Platine in der Anzugbeschreibung prüfen; stimmt er, die Platine wechseln</translation>
    </message>
    <message>
        <source>For a better result leave each side still for longer</source>
        <translation>Für ein besseres Ergebnis jede Seite länger ruhen lassen</translation>
    </message>
    <message>
        <source>Lay it down again and leave it alone for four seconds</source>
        <translation>Noch einmal hinlegen und vier Sekunden lang in Ruhe lassen</translation>
    </message>
    <message>
        <source>Lay it with %1 up and leave it alone for four seconds</source>
        <translation>Mit %1 nach oben hinlegen und vier Sekunden lang in Ruhe lassen</translation>
    </message>
    <message>
        <source>Press it into its seat, check that the plate is level, and repeat both sides</source>
        <translation>In ihr Fach drücken, prüfen, ob die Platte waagrecht ist, und beide Seiten wiederholen</translation>
    </message>
    <message>
        <source>Press it into its seat, check that the plate is level, and repeat this side</source>
        <translation>In ihr Fach drücken, prüfen, ob die Platte waagrecht ist, und diese Seite wiederholen</translation>
    </message>
    <message>
        <source>Push its plug in until it clicks, then repeat its six sides</source>
        <translation>Den Stecker eindrücken, bis er klickt, dann ihre sechs Seiten wiederholen</translation>
    </message>
    <message>
        <source>Repeat its six sides</source>
        <translation>Ihre sechs Seiten wiederholen</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>in a tilted position</source>
        <translation>in einer geneigten Stellung</translation>
    </message>
    <message>
        <source>its %1 and %2 sides are %3 from opposite; one of the two did not lie level</source>
        <translation>ihre Seiten %1 und %2 liegen sich um %3 nicht genau gegenüber; eine der beiden lag nicht waagrecht</translation>
    </message>
    <message>
        <source>its accelerometer reached the end of its range while it lay still</source>
        <translation>ihr Beschleunigungssensor erreichte das Ende seines Messbereichs, während sie still lag</translation>
    </message>
    <message>
        <source>its readings do not settle zero and slope</source>
        <translation>ihre Messwerte legen Nullpunkt und Steigung nicht fest</translation>
    </message>
    <message>
        <source>its zero is known to %1 mg and its slope to %2 %</source>
        <translation>ihr Nullpunkt ist auf %1 mg und ihre Steigung auf %2 % bekannt</translation>
    </message>
    <message>
        <source>lay %1 askew with its %2 side up</source>
        <translation>lag um %1 schief mit ihrer Seite %2 nach oben</translation>
    </message>
    <message>
        <source>never lay still with its %1%2</source>
        <translation>lag nie still mit %1%2</translation>
    </message>
    <message>
        <source>read gravity %1 m/s² off %2</source>
        <translation>maß die Schwerkraft um %1 m/s² falsch, %2</translation>
    </message>
    <message>
        <source>sent no readings</source>
        <translation>sandte keine Messwerte</translation>
    </message>
    <message>
        <source>side up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>sides up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>six sides are needed, but it lay still %1%2</source>
        <translation>sechs Seiten sind nötig, aber sie lag nur %1%2 still</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Mal</translation>
    </message>
    <message>
        <source>times</source>
        <translation>Mal</translation>
    </message>
    <message>
        <source>was moved while its %1 side was up, it lay still for %2 s</source>
        <translation>wurde bewegt, während ihre Seite %1 oben war; sie lag %2 s lang still</translation>
    </message>
    <message>
        <source>with its %1 side up</source>
        <translation>mit ihrer Seite %1 nach oben</translation>
    </message>
</context>
<context>
    <name>core/calibration/gyroscope</name>
    <message>
        <source>%1 is more than 80 % of its gyroscope's range of %2 °/s</source>
        <translation>%1 ist mehr als 80 % vom Messbereich ihres Gyroskops von %2 °/s</translation>
    </message>
    <message>
        <source>%1, as the table turned the other way when the board was turned over</source>
        <translation>%1, da sich der Drehteller andersherum drehte, als die Platine umgedreht war</translation>
    </message>
    <message>
        <source>%1, with its %2 side up</source>
        <translation>%1, mit ihrer Seite %2 nach oben</translation>
    </message>
    <message>
        <source>%1: its zero is known to %2 °/s and its slope to %3 %</source>
        <translation>%1: ihr Nullpunkt ist auf %2 °/s und ihre Steigung auf %3 % bekannt</translation>
    </message>
    <message>
        <source>For a better result tilt the table by a third of a degree and repeat</source>
        <translation>Für ein besseres Ergebnis den Drehteller um ein drittel Grad neigen und wiederholen</translation>
    </message>
    <message>
        <source>Leave box and boards switched on from the first side to the last and repeat: a zero jumped between two takes, as it does when a board is switched off</source>
        <translation>Box und Platinen von der ersten bis zur letzten Seite eingeschaltet lassen und wiederholen: ein Nullpunkt ist zwischen zwei Aufnahmen gesprungen, wie wenn eine Platine ausgeschaltet wird</translation>
    </message>
    <message>
        <source>Push its plug in until it clicks, then repeat its six turns</source>
        <translation>Den Stecker eindrücken, bis er klickt, dann ihre sechs Drehungen wiederholen</translation>
    </message>
    <message>
        <source>Repeat both sides with the table turning one way</source>
        <translation>Beide Seiten bei gleicher Richtung des Drehtellers wiederholen</translation>
    </message>
    <message>
        <source>Set the table to a slower speed, 33 1/3 or 45 rpm, and repeat</source>
        <translation>Den Drehteller auf eine kleinere Drehzahl stellen, 33 1/3 oder 45 U/min, und wiederholen</translation>
    </message>
    <message>
        <source>Set the table's speed with its stroboscope and repeat, to be sure</source>
        <translation>Zur Sicherheit die Drehzahl des Drehtellers mit seinem Stroboskop einstellen und wiederholen</translation>
    </message>
    <message>
        <source>State the speed that the table is set to</source>
        <translation>Die Drehzahl angeben, auf die der Drehteller eingestellt ist</translation>
    </message>
    <message>
        <source>The table turned %1 % %2 than %3; its measured speed counts</source>
        <translation>Der Drehteller drehte sich %1 % %2 als %3; es gilt seine gemessene Drehzahl</translation>
    </message>
    <message>
        <source>The table turned at about %1 rpm, not at %2</source>
        <translation>Der Drehteller drehte sich mit etwa %1 U/min, nicht mit %2</translation>
    </message>
    <message>
        <source>The table's true speed does not show, as it stands level or turned too briefly; %1 counts, which is good to about 0.1 %</source>
        <translation>Die wahre Drehzahl des Drehtellers zeigt sich nicht, da er waagrecht steht oder sich zu kurz drehte; es gilt %1, auf etwa 0,1 % genau</translation>
    </message>
    <message>
        <source>The zeros and slopes of %1 boards are uncertain; worst is %2, whose zero is known to %3 °/s and slope to %4 %</source>
        <translation>Nullpunkte und Steigungen von %1 Platinen sind unsicher; am schlechtesten ist %2: Nullpunkt auf %3 °/s, Steigung auf %4 % bekannt</translation>
    </message>
    <message>
        <source>Turn it with its %1 side up as well, the table turning as before</source>
        <translation>Auch mit ihrer Seite %1 nach oben drehen, der Drehteller dreht wie zuvor</translation>
    </message>
    <message>
        <source>Turn it with its +%1 side up and again with its -%2 side up</source>
        <translation>Mit ihrer Seite +%1 nach oben drehen und noch einmal mit ihrer Seite -%2 nach oben</translation>
    </message>
    <message>
        <source>Turn the six sides one soon after the other, each evenly for nine seconds or more</source>
        <translation>Die sechs Seiten bald nacheinander drehen lassen, jede neun Sekunden oder länger gleichmäßig</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>schneller</translation>
    </message>
    <message>
        <source>its gyroscope reached the end of its range in a turn, which was left out</source>
        <translation>ihr Gyroskop erreichte in einer Drehung das Ende seines Messbereichs; diese wurde ausgelassen</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>langsamer</translation>
    </message>
    <message>
        <source>turned about its</source>
        <translation>drehte sich um ihre Achse</translation>
    </message>
    <message>
        <source>turned about its %1 axis in one direction only</source>
        <translation>drehte sich um ihre Achse %1 nur in einer Richtung</translation>
    </message>
    <message>
        <source>was never turned evenly about its %1 axis</source>
        <translation>drehte sich nie gleichmäßig um ihre Achse %1</translation>
    </message>
</context>
<context>
    <name>core/calibration/motion</name>
    <message>
        <source>%1 of %2 boards are heard in only %3 % of the movement in %4, in the median</source>
        <translation>%1 von %2 Platinen sind im Median nur in %3 % der Bewegung in %4 zu hören</translation>
    </message>
    <message>
        <source>%1, has not settled: the last step still turned it by %2°</source>
        <translation>%1, hat sich nicht eingependelt: der letzte Schritt drehte sie noch um %2°</translation>
    </message>
    <message>
        <source>%1, is found %2° and %3 cm from where the calibration before has it</source>
        <translation>%1, liegt %2° und %3 cm von dort, wo die vorige Kalibrierung sie hat</translation>
    </message>
    <message>
        <source>%1, is heard in only %2 % of the movement in %3</source>
        <translation>%1, ist nur in %2 % der Bewegung in %3 zu hören</translation>
    </message>
    <message>
        <source>%1, keeps its place of the rest pose: with the one that the movement gave it, seconds that were held out fit worse by %2 %</source>
        <translation>%1, behält seinen Platz aus der Ruhehaltung: mit dem, den die Bewegung ergab, passen zurückgehaltene Sekunden um %2 % schlechter</translation>
    </message>
    <message>
        <source>%1: a board or source is not on the performer's body</source>
        <translation>%1: eine Platine oder Quelle sitzt nicht am Körper des Darstellers</translation>
    </message>
    <message>
        <source>%1: there is no second of standing still to begin with</source>
        <translation>%1: am Anfang fehlt eine Sekunde Stillstehen</translation>
    </message>
    <message>
        <source>, keeps its place of the rest pose: the movement does not settle it</source>
        <translation>, behält seinen Platz aus der Ruhehaltung: die Bewegung legt ihn nicht fest</translation>
    </message>
    <message>
        <source>, keeps its place of the rest pose: the movement would turn it farther than a strap can</source>
        <translation>, behält seinen Platz aus der Ruhehaltung: die Bewegung würde es weiter drehen, als ein Gurt nachgibt</translation>
    </message>
    <message>
        <source>Bend forwards and sideways and turn the trunk to both sides</source>
        <translation>Nach vorn und zur Seite beugen und den Rumpf zu beiden Seiten drehen</translation>
    </message>
    <message>
        <source>Bend that ankle up and down and circle the foot</source>
        <translation>Dieses Sprunggelenk auf und ab beugen und den Fuß kreisen</translation>
    </message>
    <message>
        <source>Bend that elbow all the way and turn the palm up and down</source>
        <translation>Diesen Ellbogen ganz beugen und die Handfläche auf und ab drehen</translation>
    </message>
    <message>
        <source>Bend that knee all the way, with the thigh turned in and out</source>
        <translation>Dieses Knie ganz beugen, mit dem Oberschenkel ein- und auswärts gedreht</translation>
    </message>
    <message>
        <source>Bend that wrist up and down and to both sides, and turn the palm up and down</source>
        <translation>Dieses Handgelenk auf, ab und zu beiden Seiten beugen und die Handfläche auf und ab drehen</translation>
    </message>
    <message>
        <source>Calibrate the sources first and see that they are plugged in</source>
        <translation>Zuerst die Quellen kalibrieren und prüfen, ob sie eingesteckt sind</translation>
    </message>
    <message>
        <source>Circle that arm and turn it about its own length</source>
        <translation>Diesen Arm kreisen und um seine Länge drehen</translation>
    </message>
    <message>
        <source>Fitting the movement</source>
        <translation>Bewegung wird angepasst</translation>
    </message>
    <message>
        <source>Move again: squats, arm circles, leg swings, turns of trunk and head, bends of elbows, knees and wrists</source>
        <translation>Noch einmal bewegen: Kniebeugen, Armkreisen, Beinschwingen, Drehen von Rumpf und Kopf, Beugen von Ellbogen, Knien und Handgelenken</translation>
    </message>
    <message>
        <source>Move for 30 to 60 seconds</source>
        <translation>30 bis 60 Sekunden lang bewegen</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>No distance took part in %1, so lengths and places rest on accelerations alone</source>
        <translation>Kein Abstand ging in %1 ein; Längen und Orte beruhen also allein auf Beschleunigungen</translation>
    </message>
    <message>
        <source>Nod, tilt the head to both shoulders and look over both</source>
        <translation>Nicken, den Kopf zu beiden Schultern neigen und über beide blicken</translation>
    </message>
    <message>
        <source>Push its plug in until it clicks and see that its readings stay within their range, then move again</source>
        <translation>Den Stecker eindrücken, bis er klickt, und prüfen, ob ihre Messwerte im Messbereich bleiben, dann noch einmal bewegen</translation>
    </message>
    <message>
        <source>Put its strap right or correct the suit file, then calibrate again</source>
        <translation>Den Gurt richten oder die Anzugdatei berichtigen, dann noch einmal kalibrieren</translation>
    </message>
    <message>
        <source>Record the movement again, from a rest pose that is held still</source>
        <translation>Die Bewegung noch einmal aufnehmen, aus einer ruhig gehaltenen Ruhehaltung</translation>
    </message>
    <message>
        <source>Record with the suit worn, and with an actor that has its segments</source>
        <translation>Mit angezogenem Anzug aufnehmen und mit Körpermaßen, die dessen Glieder enthalten</translation>
    </message>
    <message>
        <source>See that the driver box reaches the computer without loss, and that the take is whole, then move again</source>
        <translation>Sorgen Sie dafür, dass die Steuerbox den Rechner ohne Verlust erreicht und die Aufnahme vollständig ist; bewegen Sie sich dann noch einmal</translation>
    </message>
    <message>
        <source>Shrug and roll that shoulder</source>
        <translation>Diese Schulter heben und rollen</translation>
    </message>
    <message>
        <source>Squat, lean to all sides and turn around</source>
        <translation>In die Hocke gehen, sich nach allen Seiten neigen und umdrehen</translation>
    </message>
    <message>
        <source>Stand still in the rest pose for three seconds, then move</source>
        <translation>Drei Sekunden in der Ruhehaltung still stehen, dann bewegen</translation>
    </message>
    <message>
        <source>Swing that leg forwards and sideways and turn it about its own length</source>
        <translation>Dieses Bein nach vorn und zur Seite schwingen und um seine Länge drehen</translation>
    </message>
    <message>
        <source>Swing that limb to all sides and turn it about its own length</source>
        <translation>Dieses Glied nach allen Seiten schwingen und um seine Längsachse drehen</translation>
    </message>
    <message>
        <source>The fit of the movement did not converge</source>
        <translation>Die Anpassung an die Bewegung fand keine Lösung</translation>
    </message>
    <message>
        <source>There are only %1 s of movement after the rest pose</source>
        <translation>Nach der Ruhehaltung folgen nur %1 s Bewegung</translation>
    </message>
    <message>
        <source>Too little movement to show how boards sit at: %1</source>
        <translation>Zu wenig Bewegung, um zu zeigen, wie Platinen sitzen an: %1</translation>
    </message>
</context>
<context>
    <name>core/calibration/rest_pose</name>
    <message>
        <source>%1 boards sit otherwise than the calibration says</source>
        <translation>%1 Platinen sitzen anders, als die Kalibrierung sagt</translation>
    </message>
    <message>
        <source>%1 seem to be swapped</source>
        <translation>%1 scheinen vertauscht</translation>
    </message>
    <message>
        <source>%1%2 not calibrated</source>
        <translation>%1%2 nicht kalibriert</translation>
    </message>
    <message>
        <source>%1, feels %2 m/s² while it is still instead of %3</source>
        <translation>%1, misst %2 m/s², während sie ruht, statt %3</translation>
    </message>
    <message>
        <source>%1, is silent in the rest pose and keeps its old values</source>
        <translation>%1, schweigt in der Ruhehaltung und behält ihre alten Werte</translation>
    </message>
    <message>
        <source>%1, leans %2° otherwise at the end of the rest pose than at its beginning</source>
        <translation>%1, ist am Ende der Ruhehaltung um %2° anders geneigt als am Anfang</translation>
    </message>
    <message>
        <source>%1, moved at %2</source>
        <translation>%1, bewegte sich bei %2</translation>
    </message>
    <message>
        <source>%1, reads the end of its range while it is still</source>
        <translation>%1, misst das Ende ihres Messbereichs, während sie ruht</translation>
    </message>
    <message>
        <source>%1, sits %2° askew from where the suit file says</source>
        <translation>%1, sitzt um %2° schief gegenüber der Anzugdatei</translation>
    </message>
    <message>
        <source>%1, sits about %2 cm from where the suit file says</source>
        <translation>%1, sitzt etwa %2 cm von dort, wo die Anzugdatei sie hat</translation>
    </message>
    <message>
        <source>%1; only the stillness from %2 to %3 was used</source>
        <translation>%1; nur die Ruhe von %2 bis %3 wurde verwendet</translation>
    </message>
    <message>
        <source>%1; there is no second of standing still in %2</source>
        <translation>%1; keine Sekunde Stillstehen in %2</translation>
    </message>
    <message>
        <source>, nor %1 other pairs</source>
        <translation>, auch nicht %1 weitere Paare</translation>
    </message>
    <message>
        <source>Accelerometers are not calibrated: every tilt found here is uncertain by about %1°</source>
        <translation>Beschleunigungssensoren sind nicht kalibriert: jede hier gefundene Neigung ist um etwa %1° unsicher</translation>
    </message>
    <message>
        <source>Board %1, hears its sources about %2 cm from where the calibration puts it</source>
        <translation>Platine %1, hört ihre Quellen etwa %2 cm von dort, wo die Kalibrierung sie hat</translation>
    </message>
    <message>
        <source>Boards %1 and %2 seem to be exchanged</source>
        <translation>Platinen %1 und %2 scheinen vertauscht</translation>
    </message>
    <message>
        <source>Calibrate its accelerometer</source>
        <translation>Ihren Beschleunigungssensor kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate the accelerometers first</source>
        <translation>Zuerst die Beschleunigungssensoren kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate the rest pose again</source>
        <translation>Die Ruhehaltung neu kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate the sources and plug them in, then hold the rest pose again</source>
        <translation>Kalibrieren Sie die Quellen und stecken Sie sie ein; nehmen Sie dann die Ruhehaltung noch einmal ein</translation>
    </message>
    <message>
        <source>Calibrate them in step Calibrate, then check the suit</source>
        <translation>Diese im Schritt Kalibrieren kalibrieren, dann den Anzug kontrollieren</translation>
    </message>
    <message>
        <source>Change the board</source>
        <translation>Die Platine wechseln</translation>
    </message>
    <message>
        <source>Check whether each sits where it belongs</source>
        <translation>Prüfen, ob jede sitzt, wo sie hingehört</translation>
    </message>
    <message>
        <source>Exchange the two boards, then hold the rest pose again</source>
        <translation>Die beiden Platinen tauschen, dann die Ruhehaltung noch einmal halten</translation>
    </message>
    <message>
        <source>Exchange their plugs at the driver box, or drag the one onto the other on Connect</source>
        <translation>Ihre Stecker an der Steuerbox tauschen oder im Schritt Verbinden die eine auf die andere ziehen</translation>
    </message>
    <message>
        <source>Exchange their two plugs at the box, then hold the rest pose again</source>
        <translation>Ihre beiden Stecker an der Box tauschen, dann die Ruhehaltung noch einmal halten</translation>
    </message>
    <message>
        <source>Exchange them on the body, or drag the one onto the other on Connect</source>
        <translation>Am Körper tauschen oder im Schritt Verbinden die eine auf die andere ziehen</translation>
    </message>
    <message>
        <source>Hold the rest pose again</source>
        <translation>Die Ruhehaltung noch einmal halten</translation>
    </message>
    <message>
        <source>Hold the rest pose again after the gyroscopes</source>
        <translation>Die Ruhehaltung nach den Gyroskopen noch einmal einnehmen</translation>
    </message>
    <message>
        <source>Hold the rest pose again if the other results are poor</source>
        <translation>Die Ruhehaltung noch einmal halten, wenn die anderen Ergebnisse schlecht sind</translation>
    </message>
    <message>
        <source>Made before the gyroscopes were calibrated: boards with exchanged plugs are noticed less surely, and the zeros found here are replaced when the gyroscopes are calibrated</source>
        <translation>Vor dem Kalibrieren der Gyroskope gemacht: Platinen mit vertauschten Steckern fallen weniger sicher auf, und die hier gefundenen Nullpunkte werden ersetzt, wenn die Gyroskope kalibriert werden</translation>
    </message>
    <message>
        <source>No board of the suit is heard in the rest pose</source>
        <translation>Keine Platine des Anzugs ist in der Ruhehaltung zu hören</translation>
    </message>
    <message>
        <source>No distance was measured, so this serves tilts and turns, not distances: %1</source>
        <translation>Kein Abstand wurde gemessen; das taugt für Neigungen und Drehungen, nicht für Abstände: %1</translation>
    </message>
    <message>
        <source>Nothing in this take tells boards %1 apart%2: gravity is alike on both and no sound decides</source>
        <translation>Nichts in dieser Aufnahme unterscheidet die Platinen %1%2: die Schwerkraft ist an beiden gleich, und kein Schall entscheidet</translation>
    </message>
    <message>
        <source>Push its plug in until it clicks, then hold the rest pose again</source>
        <translation>Den Stecker eindrücken, bis er klickt, dann die Ruhehaltung noch einmal halten</translation>
    </message>
    <message>
        <source>Put it back, or calibrate the rest pose again</source>
        <translation>Zurückschieben oder die Ruhehaltung neu kalibrieren</translation>
    </message>
    <message>
        <source>Put it right or correct the suit file, then hold the rest pose again</source>
        <translation>Die Platine richten oder die Anzugdatei berichtigen, dann die Ruhehaltung noch einmal halten</translation>
    </message>
    <message>
        <source>Put its strap right or correct the suit file, then hold the rest pose again</source>
        <translation>Den Gurt richten oder die Anzugdatei berichtigen, dann die Ruhehaltung noch einmal halten</translation>
    </message>
    <message>
        <source>Rest pose</source>
        <translation>Ruhehaltung</translation>
    </message>
    <message>
        <source>Rest pose: comparing boards</source>
        <translation>Ruhehaltung: Platinen werden verglichen</translation>
    </message>
    <message>
        <source>See that each board sits where it belongs, and calibrate the movement, which shows headings</source>
        <translation>Achten Sie darauf, dass jede Platine sitzt, wo sie hingehört, und kalibrieren Sie die Bewegung, die Richtungen zeigt</translation>
    </message>
    <message>
        <source>See that it was made by this performer in this suit, or calibrate the rest pose again</source>
        <translation>Prüfen, ob sie von diesem Darsteller in diesem Anzug stammt, oder die Ruhehaltung neu kalibrieren</translation>
    </message>
    <message>
        <source>See that the box is connected and the boards are plugged in, then record again</source>
        <translation>Prüfen, ob die Box verbunden ist und die Platinen eingesteckt sind, dann noch einmal aufnehmen</translation>
    </message>
    <message>
        <source>See that the performer stands in the rest pose there, or record one</source>
        <translation>Prüfen, ob der Darsteller dort in der Ruhehaltung steht, oder eine aufnehmen</translation>
    </message>
    <message>
        <source>See whether it sits where it belongs, or calibrate the rest pose again</source>
        <translation>Prüfen, ob sie sitzt, wo sie hingehört, oder die Ruhehaltung neu kalibrieren</translation>
    </message>
    <message>
        <source>Stand still in the rest pose for three seconds</source>
        <translation>Drei Sekunden in der Ruhehaltung still stehen</translation>
    </message>
    <message>
        <source>The fit of the rest pose did not converge</source>
        <translation>Die Anpassung an die Ruhehaltung fand keine Lösung</translation>
    </message>
    <message>
        <source>The gyroscope of board %1, %2, has drifted by about %3°/s</source>
        <translation>Das Gyroskop von Platine %1, %2, ist um etwa %3°/s gedriftet</translation>
    </message>
    <message>
        <source>The gyroscopes of %1 boards have drifted, by up to %2°/s</source>
        <translation>Die Gyroskope von %1 Platinen sind gedriftet, um bis zu %2°/s</translation>
    </message>
    <message>
        <source>The strap of board %1, has slipped by about %2°</source>
        <translation>Der Gurt von Platine %1, ist um etwa %2° verrutscht</translation>
    </message>
    <message>
        <source>The suit has no sources: %1</source>
        <translation>Der Anzug hat keine Quellen: %1</translation>
    </message>
    <message>
        <source>The take marks no rest pose; the longest stillness was taken for it, from %1 to %2</source>
        <translation>Die Aufnahme markiert keine Ruhehaltung; als solche gilt die längste Ruhe, von %1 bis %2</translation>
    </message>
    <message>
        <source>There is no second of standing still in %1</source>
        <translation>Keine Sekunde Stillstehen in %1</translation>
    </message>
    <message>
        <source>are</source>
        <translation>sind</translation>
    </message>
    <message>
        <source>headings (sigma %1°) and places are those of the suit's file, and boards swapped left and right pass unseen</source>
        <translation>Richtungen (Sigma %1°) und Orte sind die der Anzugdatei, und links und rechts vertauschte Platinen fallen nicht auf</translation>
    </message>
    <message>
        <source>the marked rest pose</source>
        <translation>der markierten Ruhehaltung</translation>
    </message>
    <message>
        <source>the take, which marks no rest pose</source>
        <translation>der Aufnahme, die keine Ruhehaltung markiert</translation>
    </message>
</context>
<context>
    <name>core/calibration/source_offsets</name>
    <message>
        <source>%1 %2 of placement %3 stands in line %4 already</source>
        <translation>%1 %2 von Aufstellung %3 steht schon in Zeile %4</translation>
    </message>
    <message>
        <source>%1 and %2 look exchanged%3; both are left out</source>
        <translation>%1 und %2 scheinen vertauscht%3; beide sind ausgelassen</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 could not be calibrated and keeps what it had: %2</source>
        <translation>%1 ließ sich nicht kalibrieren und behält, was sie hatte: %2</translation>
    </message>
    <message>
        <source>%1 does not have %2</source>
        <translation>In %1 fehlt %2</translation>
    </message>
    <message>
        <source>%1 has an offset of %2, which no source can have</source>
        <translation>%1 hat einen Versatz von %2, den keine Quelle haben kann</translation>
    </message>
    <message>
        <source>%1 has an offset of %2; 100 to 200 µs are usual</source>
        <translation>%1 hat einen Versatz von %2; üblich sind 100 bis 200 µs</translation>
    </message>
    <message>
        <source>%1 has no distances for these placements of the take: %2</source>
        <translation>%1 hat keine Abstände für diese Aufstellungen der Aufnahme: %2</translation>
    </message>
    <message>
        <source>%1 has no placements marked</source>
        <translation>%1 hat keine markierten Aufstellungen</translation>
    </message>
    <message>
        <source>%1 heard no source in any placement</source>
        <translation>%1 hörte in keiner Aufstellung eine Quelle</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 ist leer</translation>
    </message>
    <message>
        <source>%1 is no plain text</source>
        <translation>%1 ist kein reiner Text</translation>
    </message>
    <message>
        <source>%1 is of another suit or detector than %2</source>
        <translation>%1 ist von einem anderen Anzug oder Detektor als %2</translation>
    </message>
    <message>
        <source>%1 moved while it was measured; those measurements are left out</source>
        <translation>%1 bewegte sich, während gemessen wurde; diese Messungen sind ausgelassen</translation>
    </message>
    <message>
        <source>%1 names parts that this suit does not have: %2</source>
        <translation>%1 nennt Teile, die dieser Anzug nicht hat: %2</translation>
    </message>
    <message>
        <source>%1 than the thermometer says</source>
        <translation>%1 als vom Thermometer angezeigt</translation>
    </message>
    <message>
        <source>%1%2 to %3, in placement %4</source>
        <translation>%1%2 zu %3, in Aufstellung %4</translation>
    </message>
    <message>
        <source>%1: its offset is known to %2 only</source>
        <translation>%1: ihr Versatz ist nur auf %2 bekannt</translation>
    </message>
    <message>
        <source>%1: placement %2 has no row of a %3</source>
        <translation>%1: Aufstellung %2 hat keine Zeile für eine %3</translation>
    </message>
    <message>
        <source>%1: sound says %2%3 than the file, in %4 of %5 measurements; they are left out</source>
        <translation>%1: der Schall sagt %2%3 als die Datei, in %4 von %5 Messungen; sie sind ausgelassen</translation>
    </message>
    <message>
        <source>, in placement %1</source>
        <translation>, in Aufstellung %1</translation>
    </message>
    <message>
        <source>Add one row per measurement</source>
        <translation>Eine Zeile je Messung hinzufügen</translation>
    </message>
    <message>
        <source>Add placements from 30 to 90 cm, or take the speed of sound from the thermometer</source>
        <translation>Aufstellungen von 30 bis 90 cm hinzufügen oder die Schallgeschwindigkeit vom Thermometer nehmen</translation>
    </message>
    <message>
        <source>Add the points or remove the placement</source>
        <translation>Die Punkte hinzufügen oder die Aufstellung entfernen</translation>
    </message>
    <message>
        <source>Calibrate them one by one</source>
        <translation>Einzeln kalibrieren</translation>
    </message>
    <message>
        <source>Close it in the same line</source>
        <translation>Es in derselben Zeile schließen</translation>
    </message>
    <message>
        <source>Compare the box's thermometer with another</source>
        <translation>Das Thermometer der Box mit einem anderen vergleichen</translation>
    </message>
    <message>
        <source>Compare the thermometer with another, or let the distances tell the speed of sound</source>
        <translation>Das Thermometer mit einem anderen vergleichen oder die Schallgeschwindigkeit aus den Abständen bestimmen</translation>
    </message>
    <message>
        <source>Correct the heading or the values, then calibrate again</source>
        <translation>Die Überschrift oder die Werte berichtigen, dann noch einmal kalibrieren</translation>
    </message>
    <message>
        <source>Correct the labels, or measure these placements too</source>
        <translation>Die Bezeichnungen berichtigen oder auch diese Aufstellungen messen</translation>
    </message>
    <message>
        <source>Correct the labels, or record these placements too</source>
        <translation>Die Bezeichnungen berichtigen oder auch diese Aufstellungen aufnehmen</translation>
    </message>
    <message>
        <source>Correct the names in the file; until then their rows are left out</source>
        <translation>Die Namen in der Datei berichtigen; bis dahin bleiben ihre Zeilen ausgelassen</translation>
    </message>
    <message>
        <source>Distances are off by %1 on average, %2 at worst; good is under %3</source>
        <translation>Abstände liegen im Mittel um %1 daneben, im schlechtesten Fall um %2; gut ist weniger als %3</translation>
    </message>
    <message>
        <source>Exchange the two labels in the file, or the two parts on the suit, and calibrate again</source>
        <translation>Die beiden Bezeichnungen in der Datei oder die beiden Teile am Anzug tauschen und noch einmal kalibrieren</translation>
    </message>
    <message>
        <source>Fill it in or remove the row</source>
        <translation>Die Spalte ausfüllen oder die Zeile entfernen</translation>
    </message>
    <message>
        <source>Give a number such as 0.512</source>
        <translation>Eine Zahl wie 0.512 angeben</translation>
    </message>
    <message>
        <source>Give a table with a header and one row per measurement</source>
        <translation>Eine Tabelle mit Kopfzeile und einer Zeile je Messung angeben</translation>
    </message>
    <message>
        <source>Give the distance from the source to the microphone's opening</source>
        <translation>Den Abstand von der Quelle zur Öffnung des Mikrofons angeben</translation>
    </message>
    <message>
        <source>Give the placements the same labels in the file and in the take</source>
        <translation>Den Aufstellungen in der Datei und in der Aufnahme dieselben Bezeichnungen geben</translation>
    </message>
    <message>
        <source>In %1, placement %2, source %3 and board %4 are at the same point</source>
        <translation>In %1, Aufstellung %2, sind Quelle %3 und Platine %4 am selben Punkt</translation>
    </message>
    <message>
        <source>Keep one of the rows, or correct the name in the other</source>
        <translation>Eine der Zeilen behalten oder den Namen in der anderen berichtigen</translation>
    </message>
    <message>
        <source>Keep one of them</source>
        <translation>Eine davon behalten</translation>
    </message>
    <message>
        <source>Keep one unit</source>
        <translation>Bei einer Einheit bleiben</translation>
    </message>
    <message>
        <source>Look for a wrong scale in the distances, then for a wrong thermometer</source>
        <translation>Nach einem falschen Maßstab der Abstände suchen, dann nach einem falschen Thermometer</translation>
    </message>
    <message>
        <source>Look for what stands in the sound's way, then measure the points again</source>
        <translation>Suchen, was dem Schall im Weg steht, dann die Punkte noch einmal messen</translation>
    </message>
    <message>
        <source>Mark the begin and end of every placement while the jig is recorded</source>
        <translation>Anfang und Ende jeder Aufstellung markieren, während das Messgestell aufgenommen wird</translation>
    </message>
    <message>
        <source>Measure it again, in at least %1 pairs</source>
        <translation>Noch einmal messen, in mindestens %1 Paaren</translation>
    </message>
    <message>
        <source>Measure it too, so that the other boards need not stand for it</source>
        <translation>Auch messen, damit die anderen Platinen sie nicht vertreten müssen</translation>
    </message>
    <message>
        <source>Measure the points again</source>
        <translation>Die Punkte noch einmal messen</translation>
    </message>
    <message>
        <source>Measure the points again, where the sound leaves the source and enters the microphone</source>
        <translation>Die Punkte noch einmal messen, dort, wo der Schall die Quelle verlässt und ins Mikrofon eintritt</translation>
    </message>
    <message>
        <source>Measure the two points again</source>
        <translation>Die beiden Punkte noch einmal messen</translation>
    </message>
    <message>
        <source>Mend what the other lines name and calibrate again</source>
        <translation>Beheben, was die anderen Zeilen nennen, und noch einmal kalibrieren</translation>
    </message>
    <message>
        <source>Name the columns</source>
        <translation>Die Spalten benennen</translation>
    </message>
    <message>
        <source>Name the columns %1</source>
        <translation>Die Spalten %1 nennen</translation>
    </message>
    <message>
        <source>No placement of %1 (%2) is marked in the take (%3)</source>
        <translation>Keine Aufstellung von %1 (%2) ist in der Aufnahme (%3) markiert</translation>
    </message>
    <message>
        <source>No source could be calibrated</source>
        <translation>Keine Quelle ließ sich kalibrieren</translation>
    </message>
    <message>
        <source>No suit is that large: remove the rows that do not belong to it</source>
        <translation>So groß ist kein Anzug: die Zeilen entfernen, die nicht zu ihm gehören</translation>
    </message>
    <message>
        <source>Record it again and leave the jig alone between the markers</source>
        <translation>Noch einmal aufnehmen und das Messgestell zwischen den Marken in Ruhe lassen</translation>
    </message>
    <message>
        <source>Record more placements, 30 to 90 cm apart</source>
        <translation>Mehr Aufstellungen aufnehmen, 30 bis 90 cm auseinander</translation>
    </message>
    <message>
        <source>Record one with every placement marked</source>
        <translation>Eine aufnehmen, in der jede Aufstellung markiert ist</translation>
    </message>
    <message>
        <source>Remove what is too much</source>
        <translation>Entfernen, was zu viel ist</translation>
    </message>
    <message>
        <source>Save the table as CSV in UTF-8</source>
        <translation>Die Tabelle als CSV in UTF-8 speichern</translation>
    </message>
    <message>
        <source>See that it sounds and that the file has its point</source>
        <translation>Prüfen, ob sie tönt und die Datei ihren Punkt hat</translation>
    </message>
    <message>
        <source>See that its plug sits and that its microphone's opening is free</source>
        <translation>Prüfen, ob ihr Stecker sitzt und die Öffnung ihres Mikrofons frei ist</translation>
    </message>
    <message>
        <source>See that its point was touched where the sound leaves it</source>
        <translation>Prüfen, ob ihr Punkt dort angetastet wurde, wo der Schall sie verlässt</translation>
    </message>
    <message>
        <source>See that the distances reach from the source's face to the microphone's opening</source>
        <translation>Prüfen, ob die Abstände von der Vorderseite der Quelle zur Öffnung des Mikrofons reichen</translation>
    </message>
    <message>
        <source>See that the file belongs to this take and that its labels are right</source>
        <translation>Prüfen, ob die Datei zu dieser Aufnahme gehört und ihre Bezeichnungen stimmen</translation>
    </message>
    <message>
        <source>The distances are too much alike to tell the speed of sound; it is known to %1 %</source>
        <translation>Die Abstände sind einander zu ähnlich, um die Schallgeschwindigkeit zu bestimmen; sie ist auf %1 % bekannt</translation>
    </message>
    <message>
        <source>The distances fit the flight times as if the air were %1 %2</source>
        <translation>Die Abstände passen zu den Laufzeiten, als wäre die Luft %1 %2</translation>
    </message>
    <message>
        <source>The distances of %1 are %2 times too %3%4</source>
        <translation>Die Abstände von %1 sind %2-mal zu %3%4</translation>
    </message>
    <message>
        <source>The flight times do not follow the distances: they differ by %1 on the whole</source>
        <translation>Die Laufzeiten folgen den Abständen nicht: sie weichen im Ganzen um %1 ab</translation>
    </message>
    <message>
        <source>The take has no marker for these placements of %1: %2</source>
        <translation>Die Aufnahme hat keine Marke für diese Aufstellungen von %1: %2</translation>
    </message>
    <message>
        <source>There is no take of the jig</source>
        <translation>Es gibt keine Aufnahme des Messgestells</translation>
    </message>
    <message>
        <source>This looks like the other kind of table,</source>
        <translation>Das sieht nach der anderen Art von Tabelle aus,</translation>
    </message>
    <message>
        <source>This looks like the other kind of table, %1; give it as such</source>
        <translation>Das sieht nach der anderen Art von Tabelle aus, %1; sie als solche angeben</translation>
    </message>
    <message>
        <source>Write decimals with a point, or put semicolons between the cells</source>
        <translation>Dezimalzahlen mit Punkt schreiben oder Strichpunkte zwischen die Zellen setzen</translation>
    </message>
    <message>
        <source>Write source or board</source>
        <translation>source oder board schreiben</translation>
    </message>
    <message>
        <source>a quotation mark stays open</source>
        <translation>ein Anführungszeichen bleibt offen</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>as if centimetres stood under a heading in metres</source>
        <translation>als stünden Zentimeter unter einer Überschrift in Metern</translation>
    </message>
    <message>
        <source>as if centimetres stood under a heading in millimetres</source>
        <translation>als stünden Zentimeter unter einer Überschrift in Millimetern</translation>
    </message>
    <message>
        <source>as if feet stood under a heading in metres</source>
        <translation>als stünden Fuß unter einer Überschrift in Metern</translation>
    </message>
    <message>
        <source>as if feet stood under a heading in millimetres</source>
        <translation>als stünden Fuß unter einer Überschrift in Millimetern</translation>
    </message>
    <message>
        <source>as if inches had been turned into millimetres twice</source>
        <translation>als wären Zoll zweimal in Millimeter umgerechnet</translation>
    </message>
    <message>
        <source>as if inches stood under a heading in metres</source>
        <translation>als stünden Zoll unter einer Überschrift in Metern</translation>
    </message>
    <message>
        <source>as if inches stood under a heading in millimetres</source>
        <translation>als stünden Zoll unter einer Überschrift in Millimetern</translation>
    </message>
    <message>
        <source>as if metres stood under a heading in millimetres</source>
        <translation>als stünden Meter unter einer Überschrift in Millimetern</translation>
    </message>
    <message>
        <source>as if millimetres stood under a heading in metres</source>
        <translation>als stünden Millimeter unter einer Überschrift in Metern</translation>
    </message>
    <message>
        <source>as if they were in another unit than the heading says</source>
        <translation>als wären sie in einer anderen Einheit, als die Überschrift sagt</translation>
    </message>
    <message>
        <source>board</source>
        <translation>Platine</translation>
    </message>
    <message>
        <source>colder</source>
        <translation>kälter</translation>
    </message>
    <message>
        <source>column %1 is %2</source>
        <translation>Spalte %1 ist %2</translation>
    </message>
    <message>
        <source>column %1 is empty</source>
        <translation>Spalte %1 ist leer</translation>
    </message>
    <message>
        <source>in placement %1</source>
        <translation>in Aufstellung %1</translation>
    </message>
    <message>
        <source>its label looks exchanged</source>
        <translation>ihre Bezeichnung scheint vertauscht</translation>
    </message>
    <message>
        <source>kind is %1</source>
        <translation>kind ist %1</translation>
    </message>
    <message>
        <source>large,</source>
        <translation>groß,</translation>
    </message>
    <message>
        <source>less</source>
        <translation>weniger</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mehr</translation>
    </message>
    <message>
        <source>no board heard it where its distance is known</source>
        <translation>keine Platine hörte sie dort, wo ihr Abstand bekannt ist</translation>
    </message>
    <message>
        <source>no row follows the header</source>
        <translation>nach der Kopfzeile folgt keine Zeile</translation>
    </message>
    <message>
        <source>only %1 of %2 measurements can be used</source>
        <translation>nur %1 von %2 Messungen sind brauchbar</translation>
    </message>
    <message>
        <source>placement %1</source>
        <translation>Aufstellung %1</translation>
    </message>
    <message>
        <source>placement %1 has more than %2 points of kind %3</source>
        <translation>Aufstellung %1 hat mehr als %2 Punkte der Art %3</translation>
    </message>
    <message>
        <source>small,</source>
        <translation>klein,</translation>
    </message>
    <message>
        <source>some columns are in metres and some in millimetres</source>
        <translation>einige Spalten sind in Metern und einige in Millimetern</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>the distance is not above 0</source>
        <translation>der Abstand ist nicht größer als 0</translation>
    </message>
    <message>
        <source>there are %1 cells under %2 columns</source>
        <translation>unter %2 Spalten stehen %1 Zellen</translation>
    </message>
    <message>
        <source>there is no column %1</source>
        <translation>es gibt keine Spalte %1</translation>
    </message>
    <message>
        <source>this pair of placement %1 stands in line %2 already</source>
        <translation>dieses Paar von Aufstellung %1 steht schon in Zeile %2</translation>
    </message>
    <message>
        <source>two columns are named %1</source>
        <translation>zwei Spalten heißen %1</translation>
    </message>
    <message>
        <source>warmer</source>
        <translation>wärmer</translation>
    </message>
</context>
<context>
    <name>core/estimation</name>
    <message>
        <source>Calibrate from movement with this performer</source>
        <translation>Mit diesem Darsteller aus Bewegung kalibrieren</translation>
    </message>
    <message>
        <source>Check that the disk has room, or process without smoothing</source>
        <translation>Prüfen, ob auf dem Datenträger Platz ist, oder ohne Glättung verarbeiten</translation>
    </message>
    <message>
        <source>calibration of board %1: its soft tissue moves with joint '%2', which the performer does not have</source>
        <translation>Kalibrierung von Platine %1: ihr Weichgewebe bewegt sich mit Gelenk „%2“, das der Darsteller nicht hat</translation>
    </message>
    <message>
        <source>what the smoother had put aside could not be read back</source>
        <translation>was die Glättung zur Seite gelegt hatte, ließ sich nicht zurücklesen</translation>
    </message>
</context>
<context>
    <name>core/figure</name>
    <message>
        <source>%1 are %2 and %3, which no person has; --bones MAP.json corrects a joint that was taken wrongly</source>
        <translation>%1 sind %2 und %3, was kein Mensch hat; --bones MAP.json berichtigt ein falsch gewähltes Gelenk</translation>
    </message>
    <message>
        <source>%1 are exchanged in the file, as toes, knees and elbows show; the sides are set right. --bones MAP.json says otherwise</source>
        <translation>%1 sind in der Datei vertauscht, wie Zehen, Knie und Ellbogen zeigen; die Seiten werden richtiggestellt. --bones MAP.json bestimmt es anders</translation>
    </message>
    <message>
        <source>%1 points up in the file; the motion is turned so that Y does</source>
        <translation>%1 zeigt in der Datei nach oben; die Bewegung wird so gedreht, dass Y es tut</translation>
    </message>
    <message>
        <source>%1 seem to be exchanged in the bone map: toes, knees and elbows point the other way</source>
        <translation>%1 scheinen in der Knochenzuordnung vertauscht: Zehen, Knie und Ellbogen zeigen andersherum</translation>
    </message>
    <message>
        <source>%1, which no person is%2</source>
        <translation>%1; so groß ist kein Mensch%2</translation>
    </message>
    <message>
        <source>%1: %2 at %3 per second; a figure %4 m tall (%5), %6 up; %7; zero pose: %8</source>
        <translation>%1: %2 mit %3 je Sekunde; eine Figur von %4 m Größe (%5), %6 nach oben; %7; Nullpose: %8</translation>
    </message>
    <message>
        <source>%1: a %2, or another unit%3</source>
        <translation>%1: ein %2 oder eine andere Einheit%3</translation>
    </message>
    <message>
        <source>%1: its limbs have no length</source>
        <translation>%1: die Glieder haben keine Länge</translation>
    </message>
    <message>
        <source>%1: no joint was recognised as %2</source>
        <translation>%1: kein Gelenk wurde erkannt als %2</translation>
    </message>
    <message>
        <source>%1: the bone map gives %2 to two joints</source>
        <translation>%1: die Knochenzuordnung gibt %2 zwei Gelenken</translation>
    </message>
    <message>
        <source>%1: the bone map says that %2 is %3, and the file has no such joint</source>
        <translation>%1: die Knochenzuordnung sagt, dass %2 %3 ist, und die Datei hat kein solches Gelenk</translation>
    </message>
    <message>
        <source>%1: the bone map speaks of a joint %2</source>
        <translation>%1: die Knochenzuordnung spricht von einem Gelenk %2</translation>
    </message>
    <message>
        <source>%1: tracking is lost in %2 of %3 frames: all their angles are zero</source>
        <translation>%1: das Tracking ist in %2 von %3 Bildern verloren: all ihre Winkel sind null</translation>
    </message>
    <message>
        <source>%1; a child in centimetres would look the same%2</source>
        <translation>%1; ein Kind in Zentimetern sähe genauso aus%2</translation>
    </message>
    <message>
        <source>'%1' is no axis that can point up</source>
        <translation>„%1“ ist keine Achse, die nach oben zeigen kann</translation>
    </message>
    <message>
        <source>, %1 by the bone map</source>
        <translation>, %1 durch die Knochenzuordnung</translation>
    </message>
    <message>
        <source>, %1 of them by shape</source>
        <translation>, %1 davon nach der Gestalt</translation>
    </message>
    <message>
        <source>; --height M or --bvh-unit corrects it</source>
        <translation>; --height M oder --bvh-unit berichtigt es</translation>
    </message>
    <message>
        <source>Cut the part out in which the subject was seen</source>
        <translation>Den Teil ausschneiden, in dem die Person zu sehen war</translation>
    </message>
    <message>
        <source>Export the motion with the skeleton's OFFSETs or position channels</source>
        <translation>Die Bewegung mit den OFFSETs oder Positionskanälen des Skeletts exportieren</translation>
    </message>
    <message>
        <source>Forearm and upper arm</source>
        <translation>Unterarm und Oberarm</translation>
    </message>
    <message>
        <source>Frame Time %1 would make hands and feet move at %2 mm/s; it is taken as milliseconds (%3 frames per second)</source>
        <translation>Mit Frame Time %1 bewegten sich Hände und Füße mit %2 mm/s; der Wert wird als Millisekunden gelesen (%3 Bilder je Sekunde)</translation>
    </message>
    <message>
        <source>Give every joint another one of the file</source>
        <translation>Jedem Gelenk ein anderes der Datei geben</translation>
    </message>
    <message>
        <source>Give y, z or auto</source>
        <translation>y, z oder auto angeben</translation>
    </message>
    <message>
        <source>Hands and feet move at %1 m/s on the mean: is the file's Frame Time right, and its unit?</source>
        <translation>Hände und Füße bewegen sich im Mittel mit %1 m/s: stimmen Frame Time und Einheit der Datei?</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Links und rechts</translation>
    </message>
    <message>
        <source>Left and right arm</source>
        <translation>Linker und rechter Arm</translation>
    </message>
    <message>
        <source>Left and right leg</source>
        <translation>Linkes und rechtes Bein</translation>
    </message>
    <message>
        <source>Names do not say which joint is which of these, the figure's shape does: %1. --bones MAP.json corrects it</source>
        <translation>Bei diesen sagen nicht die Namen, welches Gelenk welches ist, sondern die Gestalt der Figur: %1. --bones MAP.json berichtigt es</translation>
    </message>
    <message>
        <source>No joint was recognised as %1; these parts stay still. --bones MAP.json names them</source>
        <translation>Kein Gelenk wurde erkannt als %1; diese Teile bleiben unbewegt. --bones MAP.json benennt sie</translation>
    </message>
    <message>
        <source>Say which joint is which with --bones MAP.json, or rename the file's joints after HumanIK, for example LeftUpLeg, LeftLeg, LeftArm, LeftForeArm</source>
        <translation>Mit --bones MAP.json angeben, welches Gelenk welches ist, oder die Gelenke der Datei nach HumanIK umbenennen, zum Beispiel LeftUpLeg, LeftLeg, LeftArm, LeftForeArm</translation>
    </message>
    <message>
        <source>Shin and thigh</source>
        <translation>Unterschenkel und Oberschenkel</translation>
    </message>
    <message>
        <source>Shoulders and height</source>
        <translation>Schultern und Größe</translation>
    </message>
    <message>
        <source>Take one of LeftUpLeg, LeftLeg, LeftFoot, LeftArm, LeftForeArm, LeftHand, Hips, Spine, Chest, Neck, Head and the like</source>
        <translation>Eines von LeftUpLeg, LeftLeg, LeftFoot, LeftArm, LeftForeArm, LeftHand, Hips, Spine, Chest, Neck, Head und so weiter nehmen</translation>
    </message>
    <message>
        <source>The %1 is %2 long on the left and %3 on the right; --bones MAP.json corrects a joint that was taken wrongly</source>
        <translation>%1 ist links %2 lang und rechts %3; --bones MAP.json berichtigt ein falsch gewähltes Gelenk</translation>
    </message>
    <message>
        <source>The %1%2 changes its length by %3 on the mean; its median is taken</source>
        <translation>%1%2: die Länge ändert sich im Mittel um %3; es gilt ihr Median</translation>
    </message>
    <message>
        <source>The figure is %1 tall with the unit %2</source>
        <translation>Die Figur ist mit der Einheit %2 %1 groß</translation>
    </message>
    <message>
        <source>The first %1 hold zeros only and are cut off</source>
        <translation>Die ersten %1 enthalten nur Nullen und werden abgeschnitten</translation>
    </message>
    <message>
        <source>The last %1 hold zeros only and are cut off</source>
        <translation>Die letzten %1 enthalten nur Nullen und werden abgeschnitten</translation>
    </message>
    <message>
        <source>The position channels of %1 are about zero; they are added to the OFFSETs</source>
        <translation>Die Positionskanäle von %1 sind etwa null; sie werden zu den OFFSETs addiert</translation>
    </message>
    <message>
        <source>Tracking of %1 was lost in %2; they are bridged between their neighbours</source>
        <translation>Das Tracking ging in %2 verloren (%1); sie werden zwischen ihren Nachbarn überbrückt</translation>
    </message>
    <message>
        <source>Tracking was lost in %1 (all angles zero, at most %2 in a row); they are bridged between their neighbours</source>
        <translation>Das Tracking ging in %1 verloren (alle Winkel null, höchstens %2 hintereinander); sie werden zwischen ihren Nachbarn überbrückt</translation>
    </message>
    <message>
        <source>Upper arm and thigh</source>
        <translation>Oberarm und Oberschenkel</translation>
    </message>
    <message>
        <source>Whether %1 points up is not certain; --up y or --up z says it</source>
        <translation>Ob %1 nach oben zeigt, ist nicht sicher; --up y oder --up z bestimmt es</translation>
    </message>
    <message>
        <source>With %1 up the body lies, sits low or stands on its head most of the time; if it does not, --up z or --up y turns it</source>
        <translation>Mit %1 nach oben liegt der Körper, sitzt tief oder steht meist auf dem Kopf; trifft das nicht zu, dreht ihn --up z oder --up y</translation>
    </message>
    <message>
        <source>Write the joint's name as the file has it</source>
        <translation>Den Namen des Gelenks so schreiben, wie er in der Datei steht</translation>
    </message>
    <message>
        <source>arms down</source>
        <translation>Arme hängen</translation>
    </message>
    <message>
        <source>bent trunk</source>
        <translation>Rumpf gebeugt</translation>
    </message>
    <message>
        <source>bones along one axis</source>
        <translation>Knochen entlang einer Achse</translation>
    </message>
    <message>
        <source>by name</source>
        <translation>nach Namen</translation>
    </message>
    <message>
        <source>child</source>
        <translation>Kind</translation>
    </message>
    <message>
        <source>giant</source>
        <translation>Riese</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>not a standing pose</source>
        <translation>keine stehende Pose</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>the place of %1</source>
        <translation>der Ort von %1</translation>
    </message>
</context>
<context>
    <name>core/film</name>
    <message>
        <source>%1 frames instead of %2</source>
        <translation>%1 Bilder statt %2</translation>
    </message>
    <message>
        <source>%1: %2 of %3 cannot be decoded and will not be drawn</source>
        <translation>%1: nicht dekodierbar und darum nicht gezeichnet: %2 von %3</translation>
    </message>
    <message>
        <source>%1: cannot be written: No space left on device</source>
        <translation>%1: lässt sich nicht schreiben: Auf dem Datenträger ist kein Platz mehr</translation>
    </message>
    <message>
        <source>%1: its textures are not drawn: %2</source>
        <translation>%1: Die Texturen werden nicht gezeichnet: %2</translation>
    </message>
    <message>
        <source>%1: what was written does not read back the same (%2)</source>
        <translation>%1: das Geschriebene liest sich nicht gleich zurück (%2)</translation>
    </message>
    <message>
        <source>Check the disk and try again</source>
        <translation>Den Datenträger prüfen und erneut versuchen</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>%1 wird gezeichnet</translation>
    </message>
    <message>
        <source>Free some space there or choose another folder</source>
        <translation>Dort Platz schaffen oder einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>Reading %1 again</source>
        <translation>%1 wird zurückgelesen</translation>
    </message>
    <message>
        <source>Save them again as PNG or JPEG</source>
        <translation>Speichern Sie sie neu als PNG oder JPEG</translation>
    </message>
    <message>
        <source>another frame rate</source>
        <translation>eine andere Bildrate</translation>
    </message>
    <message>
        <source>another size</source>
        <translation>eine andere Größe</translation>
    </message>
    <message>
        <source>it is no film</source>
        <translation>es ist kein Film</translation>
    </message>
    <message>
        <source>other colours</source>
        <translation>andere Farben</translation>
    </message>
    <message>
        <source>other pictures</source>
        <translation>andere Bilder</translation>
    </message>
</context>
<context>
    <name>core/formats</name>
    <message>
        <source>%1 begins inside joint %2</source>
        <translation>%1 beginnt mitten in Gelenk %2</translation>
    </message>
    <message>
        <source>%1 has no name</source>
        <translation>%1 hat keinen Namen</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 is not a unit of BVH lengths</source>
        <translation>%1 ist keine Einheit für BVH-Längen</translation>
    </message>
    <message>
        <source>%1 of %2 (number %3 of the row) is %4</source>
        <translation>%1 von %2 (Zahl %3 der Zeile) ist %4</translation>
    </message>
    <message>
        <source>%1 where %2 should stand</source>
        <translation>%1, wo %2 stehen sollte</translation>
    </message>
    <message>
        <source>%1, but %2 complete rows follow; these are used</source>
        <translation>%1, aber %2 vollständige Zeilen folgen; diese werden verwendet</translation>
    </message>
    <message>
        <source>%1, but no complete row follows</source>
        <translation>%1, aber keine vollständige Zeile folgt</translation>
    </message>
    <message>
        <source>%1, line %2: %3 does not rise (%4)%5</source>
        <translation>%1, Zeile %2: %3 steigt nicht (%4)%5</translation>
    </message>
    <message>
        <source>%1: a GLB file holds 4 GiB at most</source>
        <translation>%1: Eine GLB-Datei fasst höchstens 4 GiB</translation>
    </message>
    <message>
        <source>%1: frame %2 is not a finite number</source>
        <translation>%1: Bild %2 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1: frame %2 of joint %3 is not a finite number</source>
        <translation>%1: Bild %2 von Gelenk %3 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1: it cannot be read again (%2)</source>
        <translation>%1: lässt sich nicht zurücklesen (%2)</translation>
    </message>
    <message>
        <source>%1: its animation is too long to be read</source>
        <translation>%1: die Animation ist zu lang zum Lesen</translation>
    </message>
    <message>
        <source>%1: no animation moves its skeleton</source>
        <translation>%1: keine Animation bewegt das Skelett</translation>
    </message>
    <message>
        <source>%1: the clock jumps at %2 of %3 rows, first by %4 s in line %5.</source>
        <translation>%1: die Uhr springt bei %2 von %3 Zeilen, zuerst um %4 s in Zeile %5.</translation>
    </message>
    <message>
        <source>%1: the disk does not give back the bytes that were written to it</source>
        <translation>%1: der Datenträger gibt die Bytes nicht zurück, die auf ihn geschrieben wurden</translation>
    </message>
    <message>
        <source>%1: the figure cannot be written as glTF: %2</source>
        <translation>%1: die Figur lässt sich nicht als glTF schreiben: %2</translation>
    </message>
    <message>
        <source>%1: the motion has no frames</source>
        <translation>%1: die Bewegung hat keine Bilder</translation>
    </message>
    <message>
        <source>%1: the motion is too long for one FBX file</source>
        <translation>%1: die Bewegung ist zu lang für eine FBX-Datei</translation>
    </message>
    <message>
        <source>%1: there is no motion of a body with Hips, which OpenSim calls pelvis</source>
        <translation>%1: keine Bewegung eines Körpers mit Hips (in OpenSim pelvis) ist vorhanden</translation>
    </message>
    <message>
        <source>%1: this kind of file would not hold the motion as it is (%2); nothing was written</source>
        <translation>%1: diese Art Datei gäbe die Bewegung nicht so wieder, wie sie ist (%2); nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>%1: what was written does not read back the same%2</source>
        <translation>%1: das Geschriebene liest sich nicht gleich zurück%2</translation>
    </message>
    <message>
        <source>, nor in %1 other rows</source>
        <translation>, auch nicht in %1 weiteren Zeilen</translation>
    </message>
    <message>
        <source>Add a line OFFSET with the joint's place in its parent</source>
        <translation>Eine Zeile OFFSET mit dem Ort des Gelenks in seinem übergeordneten hinzufügen</translation>
    </message>
    <message>
        <source>Angles are in degrees.</source>
        <translation>Angles are in degrees.</translation>
    </message>
    <message>
        <source>Check that this is a BVH file and that no space is missing here</source>
        <translation>Prüfen, ob dies eine BVH-Datei ist und hier kein Leerzeichen fehlt</translation>
    </message>
    <message>
        <source>Choose a file with motion</source>
        <translation>Eine Datei mit Bewegung wählen</translation>
    </message>
    <message>
        <source>Choose a longer part of it</source>
        <translation>Einen längeren Teil davon wählen</translation>
    </message>
    <message>
        <source>Cut it into parts</source>
        <translation>In Teile schneiden</translation>
    </message>
    <message>
        <source>Export fewer takes or performers into one file, or a part of the time</source>
        <translation>Weniger Aufnahmen oder Darsteller in eine Datei exportieren, oder einen Teil der Zeit</translation>
    </message>
    <message>
        <source>Export it in parts, or at fewer frames per second</source>
        <translation>In Teilen oder mit weniger Bildern je Sekunde exportieren</translation>
    </message>
    <message>
        <source>Export the animation too (in Blender: Bake Animation), or choose another file</source>
        <translation>Auch die Animation exportieren (in Blender: Bake Animation) oder eine andere Datei wählen</translation>
    </message>
    <message>
        <source>Export the motion again</source>
        <translation>Die Bewegung noch einmal exportieren</translation>
    </message>
    <message>
        <source>Export the motion again; the file is damaged</source>
        <translation>Die Bewegung noch einmal exportieren; die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>Frame Time is %1</source>
        <translation>Frame Time ist %1</translation>
    </message>
    <message>
        <source>Frame Time is %1, more than %2 seconds; it is taken as milliseconds</source>
        <translation>Frame Time ist %1, mehr als %2 Sekunden; der Wert wird als Millisekunden gelesen</translation>
    </message>
    <message>
        <source>Frames is %1</source>
        <translation>Frames ist %1</translation>
    </message>
    <message>
        <source>Give a finite number with a decimal point, or leave the row out</source>
        <translation>Eine endliche Zahl mit Dezimalpunkt angeben oder die Zeile auslassen</translation>
    </message>
    <message>
        <source>Give at least one row of positions</source>
        <translation>Wenigstens eine Zeile mit Positionen angeben</translation>
    </message>
    <message>
        <source>Give every row one cell per column</source>
        <translation>Jeder Zeile eine Zelle je Spalte geben</translation>
    </message>
    <message>
        <source>Give m, cm, mm, inch, cmu, dm or auto</source>
        <translation>m, cm, mm, inch, cmu, dm oder auto angeben</translation>
    </message>
    <message>
        <source>Give x, y and z of every joint</source>
        <translation>x, y und z jedes Gelenks angeben</translation>
    </message>
    <message>
        <source>Keep one figure per file</source>
        <translation>Eine Figur je Datei behalten</translation>
    </message>
    <message>
        <source>Keep one of the two lines</source>
        <translation>Eine der beiden Zeilen behalten</translation>
    </message>
    <message>
        <source>Name every channel once</source>
        <translation>Jeden Kanal einmal nennen</translation>
    </message>
    <message>
        <source>Name the columns LeftHand.x, LeftHand.y, LeftHand.z and so on</source>
        <translation>Die Spalten LeftHand.x, LeftHand.y, LeftHand.z und so weiter nennen</translation>
    </message>
    <message>
        <source>Process the take again or leave this part out</source>
        <translation>Die Aufnahme neu verarbeiten oder diesen Teil auslassen</translation>
    </message>
    <message>
        <source>Process the take on a body with the canonical joints</source>
        <translation>Die Aufnahme mit einem Körper mit den üblichen Gelenken verarbeiten</translation>
    </message>
    <message>
        <source>Repair this value in the program that made the motion, or delete the row</source>
        <translation>Diesen Wert in dem Programm berichtigen, das die Bewegung erstellt hat, oder die Zeile löschen</translation>
    </message>
    <message>
        <source>Report this with the take</source>
        <translation>Dies mit der Aufnahme melden</translation>
    </message>
    <message>
        <source>Sort the rows by time, each time once; where the clock was set anew, cut the table there</source>
        <translation>Die Zeilen nach der Zeit ordnen, jede Zeit einmal; wo die Uhr neu gestellt wurde, die Tabelle dort teilen</translation>
    </message>
    <message>
        <source>Units are S.I. units (second, meters, Newtons, ...)</source>
        <translation>Units are S.I. units (second, meters, Newtons, ...)</translation>
    </message>
    <message>
        <source>Use as many of Xposition, Yposition, Zposition, Xrotation, Yrotation and Zrotation as CHANNELS says</source>
        <translation>So viele von Xposition, Yposition, Zposition, Xrotation, Yrotation und Zrotation verwenden, wie CHANNELS sagt</translation>
    </message>
    <message>
        <source>Write OFFSET and three numbers</source>
        <translation>OFFSET und drei Zahlen schreiben</translation>
    </message>
    <message>
        <source>Write OFFSET and three numbers into it, and nothing else</source>
        <translation>OFFSET und drei Zahlen hineinschreiben und sonst nichts</translation>
    </message>
    <message>
        <source>Write OFFSET and three numbers on one line</source>
        <translation>OFFSET und drei Zahlen in eine Zeile schreiben</translation>
    </message>
    <message>
        <source>Write a count from 0 to 6, a space and the channels' names</source>
        <translation>Eine Anzahl von 0 bis 6, ein Leerzeichen und die Namen der Kanäle schreiben</translation>
    </message>
    <message>
        <source>Write a number here; a space may be missing</source>
        <translation>Hier eine Zahl schreiben; vielleicht fehlt ein Leerzeichen</translation>
    </message>
    <message>
        <source>Write another kind of file (GLB or FBX), and report this with the body and the take</source>
        <translation>Eine andere Art Datei (GLB oder FBX) schreiben und dies mit Körper und Aufnahme melden</translation>
    </message>
    <message>
        <source>Write it to a file of its own</source>
        <translation>In eine eigene Datei schreiben</translation>
    </message>
    <message>
        <source>Write numbers with a decimal point and put spaces between them</source>
        <translation>Zahlen mit Dezimalpunkt schreiben und Leerzeichen dazwischensetzen</translation>
    </message>
    <message>
        <source>Write one frame per line with one number per channel</source>
        <translation>Ein Bild je Zeile mit einer Zahl je Kanal schreiben</translation>
    </message>
    <message>
        <source>Write the file again</source>
        <translation>Die Datei noch einmal schreiben</translation>
    </message>
    <message>
        <source>Write the joint's name behind it on the same line</source>
        <translation>Den Namen des Gelenks in derselben Zeile dahinter schreiben</translation>
    </message>
    <message>
        <source>Write the number of rows that follow</source>
        <translation>Die Anzahl der folgenden Zeilen schreiben</translation>
    </message>
    <message>
        <source>Write the seconds from one frame to the next, for example 0.00833333 for 120 frames a second</source>
        <translation>Die Sekunden von einem Bild zum nächsten schreiben, zum Beispiel 0.00833333 für 120 Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Write the table again with its angles</source>
        <translation>Die Tabelle mit ihren Winkeln noch einmal schreiben</translation>
    </message>
    <message>
        <source>Y is not up in it</source>
        <translation>Y zeigt darin nicht nach oben</translation>
    </message>
    <message>
        <source>a motion belongs to %1, which is no joint</source>
        <translation>eine Bewegung gehört zu %1, das kein Gelenk ist</translation>
    </message>
    <message>
        <source>a row of numbers follows, but no joint has CHANNELS</source>
        <translation>eine Zeile mit Zahlen folgt, aber kein Gelenk hat CHANNELS</translation>
    </message>
    <message>
        <source>a second ROOT %1 begins</source>
        <translation>ein zweites ROOT %1 beginnt</translation>
    </message>
    <message>
        <source>a second joint is named %1; it is called %2 here</source>
        <translation>ein zweites Gelenk heißt %1; hier heißt es %2</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>fbx</source>
        <translation>fbx</translation>
    </message>
    <message>
        <source>frame %1 stands at another time</source>
        <translation>Bild %1 steht zu einer anderen Zeit</translation>
    </message>
    <message>
        <source>glb</source>
        <translation>glb</translation>
    </message>
    <message>
        <source>has another frame rate than %1</source>
        <translation>hat eine andere Bildrate als %1</translation>
    </message>
    <message>
        <source>has other bones than %1</source>
        <translation>hat andere Knochen als %1</translation>
    </message>
    <message>
        <source>is the name of two motions</source>
        <translation>ist der Name zweier Bewegungen</translation>
    </message>
    <message>
        <source>is the name of two performers</source>
        <translation>ist der Name von zwei Darstellern</translation>
    </message>
    <message>
        <source>it ends before the first row of numbers</source>
        <translation>sie endet vor der ersten Zeile mit Zahlen</translation>
    </message>
    <message>
        <source>it holds %1 frames instead of %2</source>
        <translation>sie enthält %1 Bilder statt %2</translation>
    </message>
    <message>
        <source>it holds %1 numbers instead of %2</source>
        <translation>sie enthält %1 Zahlen statt %2</translation>
    </message>
    <message>
        <source>it runs at another frame rate</source>
        <translation>sie läuft mit einer anderen Bildrate</translation>
    </message>
    <message>
        <source>its body has %1 materials instead of %2</source>
        <translation>der Körper hat %1 Materialien statt %2</translation>
    </message>
    <message>
        <source>its body has %1 triangles instead of %2</source>
        <translation>der Körper hat %1 Dreiecke statt %2</translation>
    </message>
    <message>
        <source>its body has another colour</source>
        <translation>der Körper hat eine andere Farbe</translation>
    </message>
    <message>
        <source>its materials cover other triangles</source>
        <translation>die Materialien decken andere Dreiecke ab</translation>
    </message>
    <message>
        <source>its skin hangs on %1, which is no joint</source>
        <translation>die Haut hängt an %1, das kein Gelenk ist</translation>
    </message>
    <message>
        <source>its texture is another</source>
        <translation>die Textur ist eine andere</translation>
    </message>
    <message>
        <source>its texture lies elsewhere</source>
        <translation>die Textur liegt woanders</translation>
    </message>
    <message>
        <source>joint %1 hangs on no joint</source>
        <translation>Gelenk %1 hängt an keinem Gelenk</translation>
    </message>
    <message>
        <source>joint %1 has %2 CHANNELS</source>
        <translation>Gelenk %1 hat %2 CHANNELS</translation>
    </message>
    <message>
        <source>joint %1 has %2 where a keyword should stand</source>
        <translation>Gelenk %1 hat %2, wo ein Schlüsselwort stehen sollte</translation>
    </message>
    <message>
        <source>joint %1 has CHANNELS twice</source>
        <translation>Gelenk %1 hat CHANNELS zweimal</translation>
    </message>
    <message>
        <source>joint %1 has a second End Site, which is left out</source>
        <translation>Gelenk %1 hat ein zweites End Site, das ausgelassen wird</translation>
    </message>
    <message>
        <source>joint %1 has no OFFSET</source>
        <translation>Gelenk %1 hat kein OFFSET</translation>
    </message>
    <message>
        <source>joint %1 has no column %2.%3</source>
        <translation>Gelenk %1 hat keine Spalte %2.%3</translation>
    </message>
    <message>
        <source>joint %1 has the channel %2</source>
        <translation>Gelenk %1 hat den Kanal %2</translation>
    </message>
    <message>
        <source>joint %1 has the channel %2 twice</source>
        <translation>Gelenk %1 hat den Kanal %2 zweimal</translation>
    </message>
    <message>
        <source>joint %1 is missing</source>
        <translation>Gelenk %1 fehlt</translation>
    </message>
    <message>
        <source>joint%1</source>
        <translation>joint%1</translation>
    </message>
    <message>
        <source>jpg</source>
        <translation>jpg</translation>
    </message>
    <message>
        <source>line %1:</source>
        <translation>Zeile %1:</translation>
    </message>
    <message>
        <source>mm at most can be allowed</source>
        <translation>mm sind höchstens erlaubt</translation>
    </message>
    <message>
        <source>mm off,</source>
        <translation>mm daneben,</translation>
    </message>
    <message>
        <source>no motion in it is called %1</source>
        <translation>keine Bewegung darin heißt %1</translation>
    </message>
    <message>
        <source>of its %1 animations the one that moves most bones is taken: %2</source>
        <translation>von ihren %1 Animationen gilt die, die die meisten Knochen bewegt: %2</translation>
    </message>
    <message>
        <source>one joint has %1 frames, another %2</source>
        <translation>ein Gelenk hat %1 Bilder, ein anderes %2</translation>
    </message>
    <message>
        <source>png</source>
        <translation>png</translation>
    </message>
    <message>
        <source>the End Site of %1</source>
        <translation>das End Site von %1</translation>
    </message>
    <message>
        <source>the End Site of %1 has no OFFSET</source>
        <translation>das End Site von %1 hat kein OFFSET</translation>
    </message>
    <message>
        <source>the OFFSET of %1 has %2 for a number</source>
        <translation>das OFFSET von %1 hat %2 statt einer Zahl</translation>
    </message>
    <message>
        <source>the OFFSET of %1 has %2 of 3 numbers</source>
        <translation>das OFFSET von %1 hat %2 von 3 Zahlen</translation>
    </message>
    <message>
        <source>the OFFSET of %1 has more than 3 numbers</source>
        <translation>das OFFSET von %1 hat mehr als 3 Zahlen</translation>
    </message>
    <message>
        <source>the file ends inside joint %1</source>
        <translation>die Datei endet mitten in Gelenk %1</translation>
    </message>
    <message>
        <source>the file ends where %1 should follow</source>
        <translation>die Datei endet, wo %1 folgen sollte</translation>
    </message>
    <message>
        <source>the first column is not time</source>
        <translation>die erste Spalte ist nicht time</translation>
    </message>
    <message>
        <source>the last row has only %1 of %2 numbers and is left out</source>
        <translation>die letzte Zeile hat nur %1 von %2 Zahlen und wird ausgelassen</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>die Haut</translation>
    </message>
    <message>
        <source>there is no column JOINT.x</source>
        <translation>es gibt keine Spalte JOINT.x</translation>
    </message>
    <message>
        <source>this row has %1 cells, but the header has %2</source>
        <translation>diese Zeile hat %1 Zellen, aber die Kopfzeile %2</translation>
    </message>
    <message>
        <source>this row has %1 numbers, but the channels add up to %2</source>
        <translation>diese Zeile hat %1 Zahlen, aber die Kanäle ergeben zusammen %2</translation>
    </message>
    <message>
        <source>this row has more than %1 numbers, which the channels add up to</source>
        <translation>diese Zeile hat mehr als %1 Zahlen, die Summe aller Kanäle</translation>
    </message>
    <message>
        <source>two columns hold the time</source>
        <translation>zwei Spalten enthalten die Zeit</translation>
    </message>
</context>
<context>
    <name>core/import</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 holds %2, which is no number</source>
        <translation>%1 enthält %2, was keine Zahl ist</translation>
    </message>
    <message>
        <source>%1 is '%2', serial number %3%4</source>
        <translation>%1 ist „%2“, Seriennummer %3%4</translation>
    </message>
    <message>
        <source>%1 is no file of this kind and was left out</source>
        <translation>%1 ist keine Datei dieser Art und wurde ausgelassen</translation>
    </message>
    <message>
        <source>%1 is no list of %2 columns</source>
        <translation>%1 ist keine Liste von %2 Spalten</translation>
    </message>
    <message>
        <source>%1 names column %2, which the table lacks</source>
        <translation>%1 nennt Spalte %2, die in der Tabelle fehlt</translation>
    </message>
    <message>
        <source>%1 sensors are named for %2; none of them was put there</source>
        <translation>%1 Sensoren sind nach %2 benannt; keiner davon wurde dort angebracht</translation>
    </message>
    <message>
        <source>%1 states a calibration of %2: its readings contain it, nothing was applied again</source>
        <translation>%1 gibt eine Kalibrierung vom %2 an: Die Messwerte enthalten sie, nichts wurde noch einmal angewandt</translation>
    </message>
    <message>
        <source>%1 states an inertial message rate divisor of %2; the rate was taken from its time stamps</source>
        <translation>%1 gibt den Teiler %2 der Rate inertialer Nachrichten an; die Rate stammt aus den Zeitstempeln</translation>
    </message>
    <message>
        <source>%1 states that its attitudes are in %2, and so they were taken</source>
        <translation>%1 gibt an, dass seine Lagen in %2 stehen, und so wurden sie genommen</translation>
    </message>
    <message>
        <source>%1 turns its axes itself (axes alignment %2): its readings were taken as they are</source>
        <translation>%1 dreht seine Achsen selbst (axes alignment %2): Die Messwerte wurden genommen, wie sie sind</translation>
    </message>
    <message>
        <source>%1: %2 messages are damaged and were left out</source>
        <translation>%1: %2 Nachrichten sind beschädigt und wurden ausgelassen</translation>
    </message>
    <message>
        <source>%1: %2 of %3 are beyond any sensor's range and were left out</source>
        <translation>%1: %2 von %3 liegen außerhalb des Messbereichs jedes Sensors und wurden ausgelassen</translation>
    </message>
    <message>
        <source>%1: %2 of %3 are missing</source>
        <translation>%1: %2 von %3 fehlen</translation>
    </message>
    <message>
        <source>%1: %2 of %3 attitudes are missing or of no unit length</source>
        <translation>%1: %2 von %3 Lagen fehlen oder haben nicht die Länge eins</translation>
    </message>
    <message>
        <source>%1: %2 of %3 lack an axis and were left out</source>
        <translation>%1: %2 von %3 fehlt eine Achse, sie wurden ausgelassen</translation>
    </message>
    <message>
        <source>%1: %2 of %3 rows lack a marker of a joint and were left out.</source>
        <translation>%1: in %2 von %3 Zeilen fehlt ein Marker eines Gelenks; sie wurden ausgelassen.</translation>
    </message>
    <message>
        <source>%1: %2 places are farther than 1 km and were left out; check the unit</source>
        <translation>%1: %2 Orte sind weiter als 1 km entfernt und wurden ausgelassen; die Einheit prüfen</translation>
    </message>
    <message>
        <source>%1: a recording of the kind %2 is one file</source>
        <translation>%1: eine Aufzeichnung der Art %2 ist eine einzige Datei</translation>
    </message>
    <message>
        <source>%1: a table needs a map of its columns; they are %2</source>
        <translation>%1: eine Tabelle braucht eine Zuordnung ihrer Spalten; sie sind %2</translation>
    </message>
    <message>
        <source>%1: accelerations have a median of %2, which is gravity in no known unit</source>
        <translation>%1: Beschleunigungen haben einen Median von %2, was in keiner bekannten Einheit die Schwerkraft ist</translation>
    </message>
    <message>
        <source>%1: accelerations were read as %2 and converted to m/s^2</source>
        <translation>%1: Beschleunigungen wurden als %2 gelesen und in m/s^2 umgerechnet</translation>
    </message>
    <message>
        <source>%1: belongs to no device and was left out</source>
        <translation>%1: gehört zu keinem Gerät und wurde ausgelassen</translation>
    </message>
    <message>
        <source>%1: device %2 has no inertial messages</source>
        <translation>%1: Gerät %2 hat keine Inertial-Nachrichten</translation>
    </message>
    <message>
        <source>%1: does not say which axes its attitudes have; NWU was taken, its factory setting (--world replaces it)</source>
        <translation>%1: sagt nicht, welche Achsen die Lagen haben; NWU wurde angenommen, die Werkseinstellung (--world ersetzt sie)</translation>
    </message>
    <message>
        <source>%1: does not say which axis points up</source>
        <translation>%1: sagt nicht, welche Achse nach oben zeigt</translation>
    </message>
    <message>
        <source>%1: ends in the middle; the whole frames before were taken</source>
        <translation>%1: endet mittendrin; die ganzen Bilder davor wurden übernommen</translation>
    </message>
    <message>
        <source>%1: fields were read as %2 and converted to microtesla</source>
        <translation>%1: Felder wurden als %2 gelesen und in Mikrotesla umgerechnet</translation>
    </message>
    <message>
        <source>%1: gravity turns against the gyroscope; check the gyroscope's axes</source>
        <translation>%1: die Schwerkraft dreht sich gegen das Gyroskop; die Achsen des Gyroskops prüfen</translation>
    </message>
    <message>
        <source>%1: has %2 sensors</source>
        <translation>%1: hat %2 Sensoren</translation>
    </message>
    <message>
        <source>%1: has no marker %2</source>
        <translation>%1: hat keinen Marker %2</translation>
    </message>
    <message>
        <source>%1: holds more than %2 files</source>
        <translation>%1: enthält mehr als %2 Dateien</translation>
    </message>
    <message>
        <source>%1: holds no frame of a motion</source>
        <translation>%1: enthält kein Bild einer Bewegung</translation>
    </message>
    <message>
        <source>%1: holds no reading that can be used%2</source>
        <translation>%1: enthält keinen brauchbaren Messwert%2</translation>
    </message>
    <message>
        <source>%1: holds one row, a pose to calibrate with and no recording</source>
        <translation>%1: enthält eine einzige Zeile, eine Pose zum Kalibrieren und keine Aufzeichnung</translation>
    </message>
    <message>
        <source>%1: in no row all of these markers are seen</source>
        <translation>%1: in keiner Zeile sind alle diese Marker zu sehen</translation>
    </message>
    <message>
        <source>%1: its columns are %2</source>
        <translation>%1: die Spalten sind %2</translation>
    </message>
    <message>
        <source>%1: its sensors state different rates</source>
        <translation>%1: die Sensoren nennen verschiedene Raten</translation>
    </message>
    <message>
        <source>%1: its times of day have no date and jump back by %2 h; the clock was probably set back, but the next day is possible too</source>
        <translation>%1: seine Uhrzeiten haben kein Datum und springen um %2 h zurück; wahrscheinlich wurde die Uhr zurückgestellt, aber auch der nächste Tag ist möglich</translation>
    </message>
    <message>
        <source>%1: its times of day have no date, so a hole of %2 h is a guess; it may be longer by whole days</source>
        <translation>%1: seine Uhrzeiten haben kein Datum, eine Lücke von %2 h ist also geschätzt; sie kann um ganze Tage länger sein</translation>
    </message>
    <message>
        <source>%1: more than half of %2 repeat the one before; the sensor may stand still or the file may hold fewer</source>
        <translation>%1: mehr als die Hälfte von %2 wiederholen den Wert davor; der Sensor steht vielleicht still, oder die Datei enthält weniger Werte</translation>
    </message>
    <message>
        <source>%1: no device has inertial messages</source>
        <translation>%1: kein Gerät hat Inertial-Nachrichten</translation>
    </message>
    <message>
        <source>%1: no line has the names of columns or numbers</source>
        <translation>%1: keine Zeile enthält die Namen von Spalten oder Zahlen</translation>
    </message>
    <message>
        <source>%1: no marker carries a joint's name; they are %2</source>
        <translation>%1: kein Marker trägt den Namen eines Gelenks; es sind %2</translation>
    </message>
    <message>
        <source>%1: rates are stated as deg/s, but gravity shows rad/s; they were taken as rad/s</source>
        <translation>%1: Drehraten sind als deg/s angegeben, die Schwerkraft zeigt aber rad/s; sie gelten als rad/s</translation>
    </message>
    <message>
        <source>%1: rates reach %2 rad/s, which no gyroscope measures; they look like deg/s and were left as they are. Give the file as a table with a map that states deg/s</source>
        <translation>%1: Drehraten erreichen %2 rad/s, was kein Gyroskop misst; sie sehen nach deg/s aus und blieben, wie sie sind. Die Datei als Tabelle mit einer Zuordnung angeben, die deg/s nennt</translation>
    </message>
    <message>
        <source>%1: rates were read as deg/s and converted to rad/s</source>
        <translation>%1: Drehraten wurden als deg/s gelesen und in rad/s umgerechnet</translation>
    </message>
    <message>
        <source>%1: states %2 frames and holds %3; %4 were taken</source>
        <translation>%1: nennt %2 Bilder und enthält %3; %4 wurden übernommen</translation>
    </message>
    <message>
        <source>%1: states %2 rows and holds %3; the rows were taken</source>
        <translation>%1: nennt %2 Zeilen und enthält %3; die Zeilen wurden übernommen</translation>
    </message>
    <message>
        <source>%1: states no rate and brings no clock, as MT Manager writes since 2019.2</source>
        <translation>%1: nennt keine Rate und bringt keine Uhr mit, wie MT Manager sie seit 2019.2 schreibt</translation>
    </message>
    <message>
        <source>%1: states no unit; mm was taken</source>
        <translation>%1: nennt keine Einheit; mm wurde angenommen</translation>
    </message>
    <message>
        <source>%1: states no usable frameRate</source>
        <translation>%1: nennt keine brauchbare frameRate</translation>
    </message>
    <message>
        <source>%1: states the unit %2; mm was taken</source>
        <translation>%1: nennt die Einheit %2; mm wurde angenommen</translation>
    </message>
    <message>
        <source>%1: the clock stands still or jumps back at %2 rows, which were left out</source>
        <translation>%1: die Uhr steht still oder springt zurück bei %2 Zeilen, die ausgelassen wurden</translation>
    </message>
    <message>
        <source>%1: the folder holds no file</source>
        <translation>%1: der Ordner enthält keine Datei</translation>
    </message>
    <message>
        <source>%1: the header states %2 %3, the parameters %4; the parameters were believed</source>
        <translation>%1: der Kopf nennt %2 %3, die Parameter %4; den Parametern wurde geglaubt</translation>
    </message>
    <message>
        <source>%1: the last line has no end and was left out</source>
        <translation>%1: die letzte Zeile hat kein Ende und wurde ausgelassen</translation>
    </message>
    <message>
        <source>%1: the magnetometer reads zero throughout and is left out</source>
        <translation>%1: das Magnetometer misst durchgehend null und wird ausgelassen</translation>
    </message>
    <message>
        <source>%1: the recording was cut in the middle of a message or line, which was left out</source>
        <translation>%1: die Aufzeichnung wurde mitten in einer Nachricht oder Zeile abgeschnitten; diese wurde ausgelassen</translation>
    </message>
    <message>
        <source>%1: there is a header and no row below it</source>
        <translation>%1: Unter der Kopfzeile steht keine Zeile</translation>
    </message>
    <message>
        <source>%1: two sensors are named %2</source>
        <translation>%1: zwei Sensoren heißen %2</translation>
    </message>
    <message>
        <source>%1: what it states of itself cannot be read and was left out</source>
        <translation>%1: Was es über sich selbst angibt, kann nicht gelesen werden und wurde ausgelassen</translation>
    </message>
    <message>
        <source>, by its clock at %1</source>
        <translation>, nach seiner Uhr am %1</translation>
    </message>
    <message>
        <source>: %zu of %zu rows are lost in %zu gaps, the longest of %.2f s</source>
        <translation>: %zu von %zu Zeilen fehlen in %zu Lücken, die längste von %.2f s</translation>
    </message>
    <message>
        <source>A recording has 1 to 10000 rows a second; check the unit of the time</source>
        <translation>Eine Aufzeichnung hat 1 bis 10000 Zeilen je Sekunde; die Einheit der Zeit prüfen</translation>
    </message>
    <message>
        <source>A take holds 1 to 32 in one suit; import fewer at a time</source>
        <translation>Eine Aufnahme enthält 1 bis 32 in einem Anzug; weniger auf einmal importieren</translation>
    </message>
    <message>
        <source>A take lasts a week at most; check the rate</source>
        <translation>Eine Aufnahme dauert höchstens eine Woche; die Rate prüfen</translation>
    </message>
    <message>
        <source>Attitudes take frames to %1</source>
        <translation>Lagen führen Koordinaten nach %1</translation>
    </message>
    <message>
        <source>Attitudes take the sensor's frame to %1</source>
        <translation>Lagen führen das Koordinatensystem des Sensors nach %1</translation>
    </message>
    <message>
        <source>Check the folder and its permissions</source>
        <translation>Den Ordner und seine Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>Choose a .mat file of level 5</source>
        <translation>Eine .mat-Datei der Stufe 5 wählen</translation>
    </message>
    <message>
        <source>Choose another meaning for one of them</source>
        <translation>Wählen Sie für eine davon eine andere Bedeutung</translation>
    </message>
    <message>
        <source>Choose other markers</source>
        <translation>Andere Marker wählen</translation>
    </message>
    <message>
        <source>Choose the column of the time, or give the rate</source>
        <translation>Wählen Sie die Spalte der Zeit, oder geben Sie die Rate an</translation>
    </message>
    <message>
        <source>Choose the column, or nothing for the others</source>
        <translation>Wählen Sie die Spalte, oder nichts für die anderen</translation>
    </message>
    <message>
        <source>Columns, units and axes are those of the map</source>
        <translation>Spalten, Einheiten und Achsen sind die der Zuordnung</translation>
    </message>
    <message>
        <source>Coordinate system:</source>
        <translation>Coordinate system:</translation>
    </message>
    <message>
        <source>Copy the file again, or save it again with -v7</source>
        <translation>Die Datei noch einmal kopieren oder noch einmal mit -v7 speichern</translation>
    </message>
    <message>
        <source>Cut the recording at the jump</source>
        <translation>Die Aufzeichnung am Sprung teilen</translation>
    </message>
    <message>
        <source>Cut the recording at the jump and import the parts</source>
        <translation>Die Aufzeichnung am Sprung teilen und die Teile importieren</translation>
    </message>
    <message>
        <source>DataRate is %1</source>
        <translation>DataRate ist %1</translation>
    </message>
    <message>
        <source>ENU (X east, Y north, Z up)</source>
        <translation>ENU (X Osten, Y Norden, Z oben)</translation>
    </message>
    <message>
        <source>Each of %1 sensors</source>
        <translation>Jeder der %1 Sensoren</translation>
    </message>
    <message>
        <source>Export the markers again</source>
        <translation>Die Marker noch einmal exportieren</translation>
    </message>
    <message>
        <source>Export the recording again</source>
        <translation>Die Aufzeichnung noch einmal exportieren</translation>
    </message>
    <message>
        <source>Export the recording again with the x-IMU3 GUI or x-IMU3 CSV</source>
        <translation>Die Aufzeichnung noch einmal mit x-IMU3 GUI oder x-IMU3 CSV exportieren</translation>
    </message>
    <message>
        <source>Export the recording again, so that all arrays of a sensor have one length</source>
        <translation>Die Aufzeichnung noch einmal so exportieren, dass alle Felder eines Sensors gleich lang sind</translation>
    </message>
    <message>
        <source>Export the recording again, with rates and accelerations or attitudes of unit length</source>
        <translation>Die Aufzeichnung neu exportieren, mit Drehraten und Beschleunigungen oder Lagen der Länge eins</translation>
    </message>
    <message>
        <source>Export the recording as MVNX again</source>
        <translation>Die Aufzeichnung noch einmal als MVNX exportieren</translation>
    </message>
    <message>
        <source>Export the recording as text in MT Manager again, with inertial data and the packet counter</source>
        <translation>Die Aufzeichnung noch einmal als Text in MT Manager exportieren, mit Inertialdaten und Paketzähler</translation>
    </message>
    <message>
        <source>From frame %1 to %2 its time goes on by %3 s; frames were placed by their numbers, %4 s</source>
        <translation>Von Bild %1 zu %2 läuft die Zeit um %3 s weiter; die Bilder wurden nach ihren Nummern gelegt, %4 s</translation>
    </message>
    <message>
        <source>Give a map of the columns with --map MAP.json; noctule --batch import --help shows one</source>
        <translation>Mit --map MAP.json eine Zuordnung der Spalten angeben; noctule --batch import --help zeigt eine</translation>
    </message>
    <message>
        <source>Give a table with comma, semicolon, tab or blank between its cells</source>
        <translation>Eine Tabelle mit Komma, Strichpunkt, Tabulator oder Leerzeichen zwischen den Zellen angeben</translation>
    </message>
    <message>
        <source>Give a table with numbers</source>
        <translation>Geben Sie eine Tabelle mit Zahlen an</translation>
    </message>
    <message>
        <source>Give each sensor an id</source>
        <translation>Jedem Sensor eine id geben</translation>
    </message>
    <message>
        <source>Give each sensor one segment</source>
        <translation>Jedem Sensor ein Glied geben</translation>
    </message>
    <message>
        <source>Give each sensor's file once, and the files of one recording only</source>
        <translation>Die Datei jedes Sensors einmal angeben, und nur die Dateien einer einzigen Aufzeichnung</translation>
    </message>
    <message>
        <source>Give it, 1 to 10000 Hz (--rate HZ)</source>
        <translation>Die Rate angeben, 1 bis 10000 Hz (--rate HZ)</translation>
    </message>
    <message>
        <source>Give it: --up y (OpenSim) or --up z (most laboratories)</source>
        <translation>Die Achse angeben: --up y (OpenSim) oder --up z (die meisten Labore)</translation>
    </message>
    <message>
        <source>Give the folder that holds Inertial.csv, or the .ximu3 file</source>
        <translation>Den Ordner, der Inertial.csv enthält, oder die .ximu3-Datei angeben</translation>
    </message>
    <message>
        <source>Give the folder that the recording was written to</source>
        <translation>Den Ordner angeben, in den die Aufzeichnung geschrieben wurde</translation>
    </message>
    <message>
        <source>Give the rate of the recording (--rate HZ)</source>
        <translation>Die Rate der Aufzeichnung angeben (--rate HZ)</translation>
    </message>
    <message>
        <source>Gyroscopes are deg/s and accelerometers g in x-IMU3's messages; they were converted to rad/s and m/s^2</source>
        <translation>In den Nachrichten von x-IMU3 stehen Gyroskope in deg/s und Beschleunigungssensoren in g; sie wurden in rad/s und m/s^2 umgerechnet</translation>
    </message>
    <message>
        <source>Import one recording at a time</source>
        <translation>Eine Aufzeichnung nach der anderen importieren</translation>
    </message>
    <message>
        <source>Import the sensors of one recording at a time</source>
        <translation>Die Sensoren einer einzigen Aufzeichnung auf einmal importieren</translation>
    </message>
    <message>
        <source>Import the trial's table instead</source>
        <translation>Stattdessen die Tabelle des Versuchs importieren</translation>
    </message>
    <message>
        <source>Its columns are: %1</source>
        <translation>Ihre Spalten sind: %1</translation>
    </message>
    <message>
        <source>Its markers are: %1</source>
        <translation>Ihre Marker sind: %1</translation>
    </message>
    <message>
        <source>Its sensors are: %1</source>
        <translation>Ihre Sensoren sind: %1</translation>
    </message>
    <message>
        <source>Known units: %1</source>
        <translation>Bekannte Einheiten: %1</translation>
    </message>
    <message>
        <source>MATLAB files of level 5 (BROAD, qmt)</source>
        <translation>MATLAB-Dateien der Stufe 5 (BROAD, qmt)</translation>
    </message>
    <message>
        <source>MT Manager's text export, one file per sensor</source>
        <translation>Textexport von MT Manager, eine Datei je Sensor</translation>
    </message>
    <message>
        <source>MVNX holds no gyroscope, and this file no sensorFreeAcceleration: its sensors have attitudes alone</source>
        <translation>MVNX enthält kein Gyroskop und diese Datei keine sensorFreeAcceleration: Ihre Sensoren haben nur Lagen</translation>
    </message>
    <message>
        <source>MVNX holds no gyroscope; accelerations were derived from sensorFreeAcceleration, gravity and the sensors' attitudes</source>
        <translation>MVNX enthält kein Gyroskop; Beschleunigungen wurden aus sensorFreeAcceleration, Schwerkraft und den Lagen der Sensoren abgeleitet</translation>
    </message>
    <message>
        <source>MVNX version %1</source>
        <translation>MVNX-Version %1</translation>
    </message>
    <message>
        <source>NED (X north, Y east, Z down)</source>
        <translation>NED (X Norden, Y Osten, Z unten)</translation>
    </message>
    <message>
        <source>NWU (X north or forward, Y west or left, Z up)</source>
        <translation>NWU (X Norden oder vorn, Y Westen oder links, Z oben)</translation>
    </message>
    <message>
        <source>Name at least one of them</source>
        <translation>Wenigstens eines davon nennen</translation>
    </message>
    <message>
        <source>Name the N x 3 arrays of each sensor so that they end in gyr, acc and mag</source>
        <translation>Die N x 3 großen Felder jedes Sensors so benennen, dass sie auf gyr, acc und mag enden</translation>
    </message>
    <message>
        <source>Name the files or the folder of one recording</source>
        <translation>Die Dateien oder den Ordner einer einzigen Aufzeichnung nennen</translation>
    </message>
    <message>
        <source>Name the sensor</source>
        <translation>Benennen Sie den Sensor</translation>
    </message>
    <message>
        <source>No coordinate system is stated; attitudes were taken as ENU, MT Manager's usual one (--world replaces it)</source>
        <translation>Kein Koordinatensystem ist genannt; Lagen gelten als ENU, das übliche von MT Manager (--world ersetzt es)</translation>
    </message>
    <message>
        <source>No file given is of the kind %1</source>
        <translation>Keine angegebene Datei ist von der Art %1</translation>
    </message>
    <message>
        <source>No frame has the orientations of all segments, so the file brings no reference</source>
        <translation>Kein Einzelbild hat die Orientierungen aller Glieder; die Datei bringt darum keine Referenz mit</translation>
    </message>
    <message>
        <source>Noctule's (X west or left, Y up, Z north or forward)</source>
        <translation>Boden von Noctule (X Westen oder links, Y oben, Z Norden oder vorn)</translation>
    </message>
    <message>
        <source>Not imported: %1</source>
        <translation>Nicht importiert: %1</translation>
    </message>
    <message>
        <source>OpenSense's table of quaternions</source>
        <translation>Quaternionentabelle von OpenSense</translation>
    </message>
    <message>
        <source>OpenSim's ground (X forward, Y up, Z right)</source>
        <translation>Boden von OpenSim (X vorn, Y oben, Z rechts)</translation>
    </message>
    <message>
        <source>Put one sensor on each segment</source>
        <translation>Auf jedes Glied einen Sensor setzen</translation>
    </message>
    <message>
        <source>Rates are deg/s in Movella DOT's tables; they were converted to rad/s</source>
        <translation>Drehraten sind in Movella DOTs Tabellen deg/s; sie wurden in rad/s umgerechnet</translation>
    </message>
    <message>
        <source>Rates are rad/s, accelerations m/s^2 with gravity, as MT Manager writes them</source>
        <translation>Drehraten sind rad/s, Beschleunigungen m/s^2 mit Schwerkraft, wie MT Manager sie schreibt</translation>
    </message>
    <message>
        <source>Read from %1; left out is the same quantity in %2, which a map can name instead</source>
        <translation>Gelesen aus %1; ausgelassen ist dieselbe Größe in %2, die eine Zuordnung stattdessen nennen kann</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Record with inertial messages switched on</source>
        <translation>Mit eingeschalteten Inertial-Nachrichten aufnehmen</translation>
    </message>
    <message>
        <source>Save it again in MATLAB or Octave with -v7</source>
        <translation>In MATLAB oder Octave noch einmal mit -v7 speichern</translation>
    </message>
    <message>
        <source>Say which columns are rates, accelerations or attitudes</source>
        <translation>Sagen Sie, welche Spalten Drehraten, Beschleunigungen oder Lagen sind</translation>
    </message>
    <message>
        <source>Segments are those of the map</source>
        <translation>Glieder sind die der Zuordnung</translation>
    </message>
    <message>
        <source>Segments are: %1</source>
        <translation>Glieder sind: %1</translation>
    </message>
    <message>
        <source>Sensors are aligned by their packet counters</source>
        <translation>Sensoren sind nach ihren Paketzählern ausgerichtet</translation>
    </message>
    <message>
        <source>The devices' clocks do not run together; all were taken to begin at the same instant. Switch on synchronisation before recording</source>
        <translation>Die Uhren der Geräte laufen nicht gemeinsam; für alle wurde derselbe Anfang angenommen. Vor der Aufzeichnung die Synchronisierung einschalten</translation>
    </message>
    <message>
        <source>The devices' clocks run together and were taken as one, as network synchronisation makes them</source>
        <translation>Die Uhren der Geräte laufen gemeinsam und gelten als eine, wie die Synchronisierung im Netzwerk sie macht</translation>
    </message>
    <message>
        <source>The file has no attitudes of sensors; those of its segments stand for them</source>
        <translation>Die Datei enthält keine Lagen von Sensoren; die ihrer Glieder stehen dafür</translation>
    </message>
    <message>
        <source>The file has no positions: its reference tells orientations alone, and its root stays in place</source>
        <translation>Die Datei hat keine Positionen: Ihre Referenz kennt nur Orientierungen, und ihre Wurzel bleibt am Ort</translation>
    </message>
    <message>
        <source>The file has no whole body with positions, so it brings no reference</source>
        <translation>Die Datei enthält keinen ganzen Körper mit Positionen und bringt daher keine Referenz mit</translation>
    </message>
    <message>
        <source>The header states %1 rows a second, SampleTimeFine shows %2; the header's was taken (--rate HZ replaces it)</source>
        <translation>Der Kopf nennt %1 Zeilen je Sekunde, SampleTimeFine zeigt %2; die des Kopfes gilt (--rate HZ ersetzt sie)</translation>
    </message>
    <message>
        <source>The header states %1 rows a second, the times show %2; the times were believed</source>
        <translation>Der Kopf nennt %1 Zeilen je Sekunde, die Zeiten zeigen %2; den Zeiten wurde geglaubt</translation>
    </message>
    <message>
        <source>The map: %1</source>
        <translation>Die Zuordnung: %1</translation>
    </message>
    <message>
        <source>The markers of %1 are no list of names</source>
        <translation>Die Marker von %1 sind keine Liste von Namen</translation>
    </message>
    <message>
        <source>The sensors are of different lengths: %1 to %2 s</source>
        <translation>Die Sensoren sind verschieden lang: %1 bis %2 s</translation>
    </message>
    <message>
        <source>The table does not say what its ground is; ENU was assumed, as MT Manager's data have it (--world opensim for tables in OpenSim's axes)</source>
        <translation>Die Tabelle sagt nicht, was ihr Boden ist; ENU wurde angenommen, wie in Daten von MT Manager (--world opensim für Tabellen in den Achsen von OpenSim)</translation>
    </message>
    <message>
        <source>The table holds attitudes only: no rates, accelerations or field</source>
        <translation>Die Tabelle enthält nur Lagen: keine Drehraten, Beschleunigungen oder Magnetfeld</translation>
    </message>
    <message>
        <source>Timestamp (us)</source>
        <translation>Timestamp (us)</translation>
    </message>
    <message>
        <source>Timestamp (us),</source>
        <translation>Timestamp (us),</translation>
    </message>
    <message>
        <source>Timestamp (us),Gyroscope X</source>
        <translation>Timestamp (us),Gyroscope X</translation>
    </message>
    <message>
        <source>Write enu, nwu, ned, opensim or noctule</source>
        <translation>enu, nwu, ned, opensim oder noctule schreiben</translation>
    </message>
    <message>
        <source>Write it as ["name", ...]</source>
        <translation>Als ["name", ...] schreiben</translation>
    </message>
    <message>
        <source>Write the table with OpenSense again</source>
        <translation>Die Tabelle noch einmal mit OpenSense schreiben</translation>
    </message>
    <message>
        <source>Write three different axes that keep right-handed: ["y", "-x", "z"]</source>
        <translation>Drei verschiedene Achsen schreiben, die rechtshändig bleiben: ["y", "-x", "z"]</translation>
    </message>
    <message>
        <source>Xsens MVN: attitudes, and MVN's result as reference</source>
        <translation>Xsens MVN: Lagen, und das Ergebnis von MVN als Referenz</translation>
    </message>
    <message>
        <source>a compressed array is damaged or cut off</source>
        <translation>ein komprimiertes Feld ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>a sensor has no id</source>
        <translation>ein Sensor hat keine id</translation>
    </message>
    <message>
        <source>a small element claims %1 bytes; at most 4 fit</source>
        <translation>ein kleines Element gibt %1 Bytes an; höchstens 4 passen hinein</translation>
    </message>
    <message>
        <source>an array without flags or dimensions</source>
        <translation>ein Feld ohne Flags oder Dimensionen</translation>
    </message>
    <message>
        <source>an element of %1 bytes is cut off</source>
        <translation>ein Element von %1 Bytes ist abgeschnitten</translation>
    </message>
    <message>
        <source>an element of frame %1 never ends</source>
        <translation>ein Element von Bild %1 endet nie</translation>
    </message>
    <message>
        <source>an element's header is cut off</source>
        <translation>der Kopf eines Elements ist abgeschnitten</translation>
    </message>
    <message>
        <source>any table of numbers</source>
        <translation>eine Tabelle von Zahlen</translation>
    </message>
    <message>
        <source>array %1 holds %2 numbers, its dimensions ask for another count</source>
        <translation>Feld %1 enthält %2 Zahlen, seine Dimensionen verlangen eine andere Anzahl</translation>
    </message>
    <message>
        <source>as first block</source>
        <translation>als ersten Block</translation>
    </message>
    <message>
        <source>as scale</source>
        <translation>als Maßstab</translation>
    </message>
    <message>
        <source>axes %1 are no turn</source>
        <translation>die Achsen %1 sind keine Drehung</translation>
    </message>
    <message>
        <source>cm/s^2</source>
        <translation>cm/s^2</translation>
    </message>
    <message>
        <source>column %1 belongs to no sensor</source>
        <translation>Spalte %1 gehört zu keinem Sensor</translation>
    </message>
    <message>
        <source>column %1 holds %2, which is no number</source>
        <translation>Spalte %1 enthält %2, was keine Zahl ist</translation>
    </message>
    <message>
        <source>deg/s</source>
        <translation>deg/s</translation>
    </message>
    <message>
        <source>does not state where its data begin or their scale</source>
        <translation>sagt nicht, wo ihre Daten beginnen oder welchen Maßstab sie haben</translation>
    </message>
    <message>
        <source>frame %1, %2: %3 is no number</source>
        <translation>Bild %1, %2: %3 ist keine Zahl</translation>
    </message>
    <message>
        <source>frame %1, %2: %3 numbers instead of %4</source>
        <translation>Bild %1, %2: %3 Zahlen statt %4</translation>
    </message>
    <message>
        <source>frames a second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>has %1 numbers in a row for %2 quaternions</source>
        <translation>hat %1 Zahlen in einer Zeile für %2 Quaternionen</translation>
    </message>
    <message>
        <source>holds %1 points</source>
        <translation>enthält %1 Punkte</translation>
    </message>
    <message>
        <source>holds fewer than two rows with an instant</source>
        <translation>enthält weniger als zwei Zeilen mit einem Zeitpunkt</translation>
    </message>
    <message>
        <source>holds fewer than two rows with rising instants</source>
        <translation>enthält weniger als zwei Zeilen mit steigenden Zeitpunkten</translation>
    </message>
    <message>
        <source>holds no whole frame</source>
        <translation>enthält kein ganzes Bild</translation>
    </message>
    <message>
        <source>is %1</source>
        <translation>ist %1</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is no C3D file: its second byte is not 50 (hexadecimal)</source>
        <translation>ist keine C3D-Datei: ihr zweites Byte ist nicht 50 (hexadezimal)</translation>
    </message>
    <message>
        <source>it declares a document type, which MVNX files do not have</source>
        <translation>sie deklariert einen Dokumenttyp, den MVNX-Dateien nicht haben</translation>
    </message>
    <message>
        <source>it does not begin with PathFileType</source>
        <translation>sie beginnt nicht mit PathFileType</translation>
    </message>
    <message>
        <source>it ends before the first whole row of numbers</source>
        <translation>sie endet vor der ersten ganzen Zeile mit Zahlen</translation>
    </message>
    <message>
        <source>it has %1 cells instead of %2</source>
        <translation>sie hat %1 Zellen statt %2</translation>
    </message>
    <message>
        <source>it has more rows than any recording</source>
        <translation>sie hat mehr Zeilen als irgendeine Aufzeichnung</translation>
    </message>
    <message>
        <source>it has more segments, sensors, joints or frames than any suit</source>
        <translation>sie hat mehr Glieder, Sensoren, Gelenke oder Bilder als irgendein Anzug</translation>
    </message>
    <message>
        <source>it has no list of 1 to 100 sensors</source>
        <translation>sie hat keine Liste von 1 bis 100 Sensoren</translation>
    </message>
    <message>
        <source>it holds no row of markers</source>
        <translation>sie enthält keine Zeile mit Markern</translation>
    </message>
    <message>
        <source>it is XML, but no MVNX</source>
        <translation>es ist XML, aber kein MVNX</translation>
    </message>
    <message>
        <source>it names %1 markers</source>
        <translation>sie nennt %1 Marker</translation>
    </message>
    <message>
        <source>it states no usable DataRate</source>
        <translation>sie nennt keine brauchbare DataRate</translation>
    </message>
    <message>
        <source>it unpacks to more than %1 MiB</source>
        <translation>entpackt ist es mehr als %1 MiB groß</translation>
    </message>
    <message>
        <source>its clock jumps by days</source>
        <translation>die Uhr springt um Tage</translation>
    </message>
    <message>
        <source>its clock jumps: %1 rows would be spread over %2</source>
        <translation>die Uhr springt: %1 Zeilen wären über %2 verteilt</translation>
    </message>
    <message>
        <source>its first row has no packet counter</source>
        <translation>die erste Zeile hat keinen Paketzähler</translation>
    </message>
    <message>
        <source>its packet counter is empty</source>
        <translation>der Paketzähler ist leer</translation>
    </message>
    <message>
        <source>line %1 is neither a // line nor the names of the columns</source>
        <translation>Zeile %1 ist weder eine //-Zeile noch die Namen der Spalten</translation>
    </message>
    <message>
        <source>no column belongs to a sensor</source>
        <translation>keine Spalte gehört zu einem Sensor</translation>
    </message>
    <message>
        <source>no column is the time</source>
        <translation>keine Spalte ist die Zeit</translation>
    </message>
    <message>
        <source>no numeric arrays</source>
        <translation>keine Zahlenfelder</translation>
    </message>
    <message>
        <source>no sensor was found; the file holds %1</source>
        <translation>kein Sensor wurde gefunden; die Datei enthält %1</translation>
    </message>
    <message>
        <source>numbers of the unknown type %1</source>
        <translation>Zahlen des unbekannten Typs %1</translation>
    </message>
    <message>
        <source>one sensor</source>
        <translation>ein Sensor</translation>
    </message>
    <message>
        <source>orientation of the recording</source>
        <translation>Lage der Sensoren der Aufzeichnung</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>sensor %1</source>
        <translation>Sensor %1</translation>
    </message>
    <message>
        <source>sensor %1 has %2 rows of gyr and %3 of %4</source>
        <translation>Sensor %1 hat %2 Zeilen gyr und %3 Zeilen %4</translation>
    </message>
    <message>
        <source>sensor %1 has neither gyro, accel nor quaternion</source>
        <translation>Sensor %1 hat weder gyro noch accel noch quaternion</translation>
    </message>
    <message>
        <source>sensor %1 is not in the recording</source>
        <translation>Sensor %1 kommt in der Aufzeichnung nicht vor</translation>
    </message>
    <message>
        <source>sensor %1 is put on %2, which no body has</source>
        <translation>Sensor %1 sitzt auf %2, das kein Körper hat</translation>
    </message>
    <message>
        <source>sensor %1 lacks %2 of its %3</source>
        <translation>Sensor %1 fehlt %2 von %3</translation>
    </message>
    <message>
        <source>sensor %1 stands there twice</source>
        <translation>Sensor %1 steht zweimal da</translation>
    </message>
    <message>
        <source>sensors %1 and %2 are both put on %3</source>
        <translation>Sensoren %1 und %2 sitzen beide auf %3</translation>
    </message>
    <message>
        <source>states no usable rate</source>
        <translation>nennt keine brauchbare Rate</translation>
    </message>
    <message>
        <source>structs are nested deeper than %1</source>
        <translation>Strukturen sind tiefer verschachtelt als %1</translation>
    </message>
    <message>
        <source>the decompressor does not start</source>
        <translation>das Entpacken beginnt nicht</translation>
    </message>
    <message>
        <source>the file states no usable sampling rate</source>
        <translation>die Datei nennt keine brauchbare Abtastrate</translation>
    </message>
    <message>
        <source>the line of names does not begin with Frame#</source>
        <translation>die Zeile mit den Namen beginnt nicht mit Frame#</translation>
    </message>
    <message>
        <source>the usual step of its clock is %1 s</source>
        <translation>der übliche Schritt der Uhr ist %1 s</translation>
    </message>
    <message>
        <source>there is no line with the columns' names</source>
        <translation>es gibt keine Zeile mit den Namen der Spalten</translation>
    </message>
    <message>
        <source>this is a MATLAB file of version 7.3 (HDF5), which is not read</source>
        <translation>dies ist eine MATLAB-Datei der Version 7.3 (HDF5), die nicht gelesen wird</translation>
    </message>
    <message>
        <source>this is no MATLAB file of level 5: the byte order mark is missing</source>
        <translation>dies ist keine MATLAB-Datei der Stufe 5: die Kennung der Bytefolge fehlt</translation>
    </message>
    <message>
        <source>this is no MATLAB file: it is too short</source>
        <translation>dies ist keine MATLAB-Datei: sie ist zu kurz</translation>
    </message>
    <message>
        <source>time names no column</source>
        <translation>time nennt keine Spalte</translation>
    </message>
    <message>
        <source>two columns are the same axis of sensor %1, the second is %2</source>
        <translation>zwei Spalten sind dieselbe Achse von Sensor %1, die zweite ist %2</translation>
    </message>
    <message>
        <source>two columns are the time, the second is %1</source>
        <translation>zwei Spalten sind die Zeit, die zweite ist %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>world is %1</source>
        <translation>world ist %1</translation>
    </message>
    <message>
        <source>x-IMU3: folders of CSV tables, or .ximu3</source>
        <translation>x-IMU3: Ordner mit CSV-Tabellen oder .ximu3</translation>
    </message>
</context>
<context>
    <name>core/job</name>
    <message>
        <source>%1 exists already</source>
        <translation>%1 gibt es schon</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 ist keine Datei</translation>
    </message>
    <message>
        <source>%1: %2 cannot be kept there</source>
        <translation>%1: %2 lässt sich dort nicht ablegen</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2</source>
        <translation>%1: lässt sich nicht lesen: %2</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: lässt sich nicht schreiben: %2</translation>
    </message>
    <message>
        <source>%1: holds more than %2 MB, the most that is read</source>
        <translation>%1: enthält mehr als %2 MB, das Höchste, was gelesen wird</translation>
    </message>
    <message>
        <source>Check that it is a file that you may read</source>
        <translation>Prüfen, ob es eine Datei mit Leserecht ist</translation>
    </message>
    <message>
        <source>Check that it is the right file, or cut it into parts</source>
        <translation>Prüfen, ob es die richtige Datei ist, oder sie in Teile schneiden</translation>
    </message>
    <message>
        <source>Check the disk or choose another folder</source>
        <translation>Den Datenträger prüfen oder einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Den Pfad prüfen</translation>
    </message>
    <message>
        <source>Choose a folder that you may write to</source>
        <translation>Einen Ordner mit Schreibrecht wählen</translation>
    </message>
    <message>
        <source>Choose a shorter name</source>
        <translation>Einen kürzeren Namen wählen</translation>
    </message>
    <message>
        <source>Choose another name or give --overwrite</source>
        <translation>Einen anderen Namen wählen oder --overwrite angeben</translation>
    </message>
    <message>
        <source>Create the folder %1 first or correct the path</source>
        <translation>Zuerst den Ordner %1 anlegen oder den Pfad berichtigen</translation>
    </message>
    <message>
        <source>Give the path of a file</source>
        <translation>Den Pfad einer Datei angeben</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>nicht brauchbar</translation>
    </message>
    <message>
        <source>the output has no name</source>
        <translation>die Ausgabe hat keinen Namen</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>unbenannt</translation>
    </message>
</context>
<context>
    <name>core/live</name>
    <message>
        <source>1: the paper to the letter. Unused ranges shrink the covariance, covariances between reference users are dropped, the share is by ratio.</source>
        <translation>1: die Veröffentlichung wörtlich. Ungenutzte Entfernungen verkleinern die Kovarianz, Kovarianzen zwischen Bezugspersonen entfallen, der Anteil geht nach dem Verhältnis.</translation>
    </message>
    <message>
        <source>A range farther off than this many standard deviations is left out.</source>
        <translation>Eine Entfernung, die um mehr als so viele Standardabweichungen abweicht, wird ausgelassen.</translation>
    </message>
    <message>
        <source>Check that you may write there, or process without smoothing</source>
        <translation>Prüfen, ob dort Schreibrecht besteht, oder ohne Glättung verarbeiten</translation>
    </message>
    <message>
        <source>Did you mean %1? `noctule --batch estimators` lists all</source>
        <translation>War %1 gemeint? `noctule --batch estimators` führt alle auf</translation>
    </message>
    <message>
        <source>Initial standard deviation of each point about the rest pose, per axis.</source>
        <translation>Anfängliche Standardabweichung jedes Punktes um die Ruhehaltung, je Achse.</translation>
    </message>
    <message>
        <source>Initial standard deviation of each point's velocity, per axis.</source>
        <translation>Anfängliche Standardabweichung der Geschwindigkeit jedes Punktes, je Achse.</translation>
    </message>
    <message>
        <source>Process noise: white acceleration of each point; 0.03 fits a calm handshake, 0.3 a dance. Larger: faster motion is followed, less is smoothed.</source>
        <translation>Prozessrauschen: weiße Beschleunigung jedes Punktes; 0,03 passt zu einem ruhigen Händedruck, 0,3 zu einem Tanz. Größer: schnellere Bewegung wird verfolgt, weniger geglättet.</translation>
    </message>
    <message>
        <source>Record first, then process the take with --estimator %1</source>
        <translation>Erst aufnehmen, dann die Aufnahme mit --estimator %1 verarbeiten</translation>
    </message>
    <message>
        <source>Rows of the table of points per second.</source>
        <translation>Zeilen der Punktetabelle je Sekunde.</translation>
    </message>
    <message>
        <source>Share of the ranges of each pulse that are used.</source>
        <translation>Anteil der Entfernungen jedes Pulses, die genutzt werden.</translation>
    </message>
    <message>
        <source>Standard deviation added to the stated one of each range: survey, mounting, offsets of sources.</source>
        <translation>Standardabweichung, die zur angegebenen jeder Entfernung hinzukommt: Vermessung, Anbringung, Versatz der Quellen.</translation>
    </message>
    <message>
        <source>Welch 2018, equations 17 to 24; greedy: ours</source>
        <translation>Welch 2018, Gleichungen 17 bis 24; gierig: eigenes</translation>
    </message>
    <message>
        <source>Welch 2018, equations 7 to 9</source>
        <translation>Welch 2018, Gleichungen 7 bis 9</translation>
    </message>
    <message>
        <source>Welch 2018, section 3</source>
        <translation>Welch 2018, Abschnitt 3</translation>
    </message>
    <message>
        <source>Welch 2018, section 3.3</source>
        <translation>Welch 2018, Abschnitt 3.3</translation>
    </message>
    <message>
        <source>Welch 2018: comocap with a share of the ranges</source>
        <translation>Welch 2018: comocap mit einem Teil der Entfernungen</translation>
    </message>
    <message>
        <source>Welch 2018: microphones and sources of several people as free points, from the ranges to the room, within and between people; a table of points, no poses</source>
        <translation>Welch 2018: Mikrofone und Quellen mehrerer Personen als freie Punkte, aus den Entfernungen zum Raum, am Körper und zwischen Personen; eine Tabelle von Punkten, keine Posen</translation>
    </message>
    <message>
        <source>Welch 2018: the same points from the ranges to the room alone</source>
        <translation>Welch 2018: dieselben Punkte allein aus den Entfernungen zum Raum</translation>
    </message>
    <message>
        <source>Which ranges the share keeps: 0 by Welch's ratio, 1 greedy by the trace of the places' covariance, 2 greedy by its determinant.</source>
        <translation>Welche Entfernungen der Anteil behält: 0 nach Welchs Verhältnis, 1 gierig nach der Spur der Kovarianz der Orte, 2 gierig nach ihrer Determinante.</translation>
    </message>
    <message>
        <source>`noctule --batch estimators` lists all</source>
        <translation>`noctule --batch estimators` zeigt alle</translation>
    </message>
    <message>
        <source>a sample rate of %1 Hz is outside what boards can be received at</source>
        <translation>eine Abtastrate von %1 Hz liegt außerhalb dessen, womit Platinen empfangen werden können</translation>
    </message>
    <message>
        <source>estimator %1 needs a whole take</source>
        <translation>der Schätzer %1 braucht eine ganze Aufnahme</translation>
    </message>
    <message>
        <source>extended Kalman filter with rotations on the manifold, adaptive noise and smoothers</source>
        <translation>erweiterter Kalman-Filter mit Drehungen auf der Mannigfaltigkeit, anpassendem Rauschen und Glättung</translation>
    </message>
    <message>
        <source>suits of independent inertial sensors: each one's orientation, then the body's pose; whole takes</source>
        <translation>Anzüge aus unabhängigen Inertialsensoren: die Lage jedes einzelnen, dann die Pose des Körpers; ganze Aufnahmen</translation>
    </message>
    <message>
        <source>the Kalman filter of Vlasic 2007 to the letter, as a baseline</source>
        <translation>der Kalman-Filter von Vlasic 2007 buchstabengetreu, als Vergleichsgrundlage</translation>
    </message>
    <message>
        <source>there is no estimator '%1'</source>
        <translation>es gibt keinen Schätzer „%1“</translation>
    </message>
    <message>
        <source>what smoothing puts aside</source>
        <translation>was die Glättung zur Seite legt</translation>
    </message>
</context>
<context>
    <name>core/media</name>
    <message>
        <source>%1, which reads and writes pictures and films, cannot be loaded</source>
        <translation>%1, das Bilder und Filme liest und schreibt, kann nicht geladen werden</translation>
    </message>
    <message>
        <source>%1: OpenCV finds no encoder for it</source>
        <translation>%1: OpenCV findet keinen Encoder dafür</translation>
    </message>
    <message>
        <source>%1: a film of %2 x %3 pixels cannot be encoded</source>
        <translation>%1: ein Film von %2 x %3 Pixeln lässt sich nicht kodieren</translation>
    </message>
    <message>
        <source>%1: cannot be written</source>
        <translation>%1: lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>%1: films of this kind cannot be written</source>
        <translation>%1: Filme dieser Art lassen sich nicht schreiben</translation>
    </message>
    <message>
        <source>%1: is no film that can be read</source>
        <translation>%1: ist kein lesbarer Film</translation>
    </message>
    <message>
        <source>%1: is no picture that can be read</source>
        <translation>%1: ist kein lesbares Bild</translation>
    </message>
    <message>
        <source>Choose an even width and an even height</source>
        <translation>Eine gerade Breite und eine gerade Höhe wählen</translation>
    </message>
    <message>
        <source>End its name with .mp4, .mkv or .avi</source>
        <translation>Den Namen auf .mp4, .mkv oder .avi enden lassen</translation>
    </message>
    <message>
        <source>Install ffmpeg's libraries, or write an .avi file</source>
        <translation>Die Bibliotheken von ffmpeg installieren oder eine .avi-Datei schreiben</translation>
    </message>
    <message>
        <source>Install the program again; this file belongs beside it</source>
        <translation>Das Programm neu installieren; diese Datei gehört daneben</translation>
    </message>
    <message>
        <source>Write it again</source>
        <translation>Noch einmal schreiben</translation>
    </message>
</context>
<context>
    <name>core/mesh</name>
    <message>
        <source>%1 hangs on a bone that does not exist</source>
        <translation>%1 hängt an einem Knochen, den es nicht gibt</translation>
    </message>
    <message>
        <source>%1 has a weight outside 0 to 1</source>
        <translation>%1 hat ein Gewicht außerhalb von 0 bis 1</translation>
    </message>
    <message>
        <source>%1 has no place on its texture</source>
        <translation>%1 hat keinen Ort auf der Textur</translation>
    </message>
    <message>
        <source>%1 has weights that do not sum to 1</source>
        <translation>%1 hat Gewichte, deren Summe nicht 1 ist</translation>
    </message>
    <message>
        <source>%1 stands nowhere</source>
        <translation>%1 steht nirgends</translation>
    </message>
    <message>
        <source>%1: %2 %3; %4 at most can be used</source>
        <translation>%1: %2 %3; höchstens %4 sind möglich</translation>
    </message>
    <message>
        <source>an animation has no usable name or length</source>
        <translation>eine Animation hat keinen brauchbaren Namen oder keine brauchbare Länge</translation>
    </message>
    <message>
        <source>an animation moves a node that does not exist, or has no keys</source>
        <translation>eine Animation bewegt einen Knoten, den es nicht gibt, oder hat keine Schlüsselbilder</translation>
    </message>
    <message>
        <source>animation keys</source>
        <translation>Schlüsselbilder von Animationen</translation>
    </message>
    <message>
        <source>bone %1 has no node</source>
        <translation>Knochen %1 hat keinen Knoten</translation>
    </message>
    <message>
        <source>bone %1 is bound by a matrix without inverse</source>
        <translation>Knochen %1 ist durch eine Matrix ohne Inverse gebunden</translation>
    </message>
    <message>
        <source>bones and their nodes do not match</source>
        <translation>Knochen und ihre Knoten passen nicht zusammen</translation>
    </message>
    <message>
        <source>bytes of texture</source>
        <translation>Bytes einer Textur</translation>
    </message>
    <message>
        <source>bytes of textures</source>
        <translation>Bytes von Texturen</translation>
    </message>
    <message>
        <source>its colour is none</source>
        <translation>die Farbe ist keine</translation>
    </message>
    <message>
        <source>its materials do not hold its triangles</source>
        <translation>die Materialien enthalten nicht die Dreiecke</translation>
    </message>
    <message>
        <source>its parts do not hold its triangles</source>
        <translation>die Teile enthalten nicht die Dreiecke</translation>
    </message>
    <message>
        <source>its texture has another size than it says</source>
        <translation>die Textur hat eine andere Größe, als sie angibt</translation>
    </message>
    <message>
        <source>its texture is neither PNG nor JPEG</source>
        <translation>die Textur ist weder PNG noch JPEG</translation>
    </message>
    <message>
        <source>key %1 of the animation of %2 is no place or time</source>
        <translation>Schlüsselbild %1 der Animation von %2 ist kein Ort oder keine Zeit</translation>
    </message>
    <message>
        <source>node %1 has a name of %2 bytes</source>
        <translation>Knoten %1 hat einen Namen von %2 Bytes</translation>
    </message>
    <message>
        <source>node %1 stands before its parent</source>
        <translation>Knoten %1 steht vor seinem übergeordneten Knoten</translation>
    </message>
    <message>
        <source>node %1 stands nowhere</source>
        <translation>Knoten %1 steht nirgends</translation>
    </message>
</context>
<context>
    <name>core/mesh/import</name>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 lässt sich nicht starten: %2</translation>
    </message>
    <message>
        <source>%1 has fewer matrices than joints</source>
        <translation>%1 hat weniger Matrizen als Gelenke</translation>
    </message>
    <message>
        <source>%1 has no joints</source>
        <translation>%1 hat keine Gelenke</translation>
    </message>
    <message>
        <source>%1 holds too many numbers</source>
        <translation>%1 enthält zu viele Zahlen</translation>
    </message>
    <message>
        <source>%1 is none</source>
        <translation>%1 ist keines</translation>
    </message>
    <message>
        <source>%1 names a joint that does not exist</source>
        <translation>%1 nennt ein Gelenk, das es nicht gibt</translation>
    </message>
    <message>
        <source>%1 of %2 vertices of %3 hang on no bone</source>
        <translation>%1 von %2 Eckpunkten von %3 hängen an keinem Knochen</translation>
    </message>
    <message>
        <source>%1 points outside of its buffer</source>
        <translation>%1 zeigt über seinen Puffer hinaus</translation>
    </message>
    <message>
        <source>%1: bones belong to no joint: %2</source>
        <translation>%1: Knochen gehören zu keinem Gelenk: %2</translation>
    </message>
    <message>
        <source>%1: it has more than %2 vertices</source>
        <translation>%1: mehr als %2 Eckpunkte</translation>
    </message>
    <message>
        <source>%1: it has too many bones</source>
        <translation>%1: zu viele Knochen</translation>
    </message>
    <message>
        <source>%1: it needs the extension %2, which cannot be read</source>
        <translation>%1: die Erweiterung %2 ist nötig, die sich nicht lesen lässt</translation>
    </message>
    <message>
        <source>%1: its animations hold too many keys</source>
        <translation>%1: die Animationen enthalten zu viele Schlüsselbilder</translation>
    </message>
    <message>
        <source>%1: meshes of this kind cannot be read</source>
        <translation>%1: Netze dieser Art sind nicht lesbar</translation>
    </message>
    <message>
        <source>%1: no mesh in it has a skin</source>
        <translation>%1: kein Netz darin hat eine Haut</translation>
    </message>
    <message>
        <source>%1: no pipe to a reader: %2</source>
        <translation>%1: keine Pipe zu einem Leseprogramm: %2</translation>
    </message>
    <message>
        <source>%1: reading it broke off</source>
        <translation>%1: das Lesen brach ab</translation>
    </message>
    <message>
        <source>%1: the file %2, which holds its data, is not beside it</source>
        <translation>%1: die Datei %2, die die Daten enthält, liegt nicht daneben</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1: diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>%1: there is no triangle in it</source>
        <translation>%1: kein Dreieck ist darin</translation>
    </message>
    <message>
        <source>%1: this is no mesh that can be read (%2)</source>
        <translation>%1: das ist kein lesbares Netz (%2)</translation>
    </message>
    <message>
        <source>%1: vertex %2 hangs on no bone</source>
        <translation>%1: Eckpunkt %2 hängt an keinem Knochen</translation>
    </message>
    <message>
        <source>Choose a .glb or .gltf file</source>
        <translation>Eine .glb- oder .gltf-Datei wählen</translation>
    </message>
    <message>
        <source>Choose a .glb, .gltf, .vrm, .fbx, .dae, .obj or .ply file</source>
        <translation>Eine .glb-, .gltf-, .vrm-, .fbx-, .dae-, .obj- oder .ply-Datei wählen</translation>
    </message>
    <message>
        <source>Close other programs and try again</source>
        <translation>Andere Programme schließen und erneut versuchen</translation>
    </message>
    <message>
        <source>Copy that file into the same folder, or export the body as .glb, which is one file</source>
        <translation>Diese Datei in denselben Ordner kopieren oder den Körper als .glb exportieren, das eine einzige Datei ist</translation>
    </message>
    <message>
        <source>Export the body again without compression</source>
        <translation>Den Körper noch einmal ohne Komprimierung exportieren</translation>
    </message>
    <message>
        <source>Export the body again, best as binary glTF (.glb)</source>
        <translation>Den Körper noch einmal exportieren, am besten als binäres glTF (.glb)</translation>
    </message>
    <message>
        <source>Export the body as .glb, .fbx, .dae, .obj or .ply</source>
        <translation>Den Körper als .glb, .fbx, .dae, .obj oder .ply exportieren</translation>
    </message>
    <message>
        <source>Export the body as binary glTF (.glb)</source>
        <translation>Den Körper als binäres glTF (.glb) exportieren</translation>
    </message>
    <message>
        <source>Export the body together with its armature and skin weights</source>
        <translation>Den Körper zusammen mit Armature und Hautgewichten exportieren</translation>
    </message>
    <message>
        <source>Export the body with fewer bones</source>
        <translation>Den Körper mit weniger Knochen exportieren</translation>
    </message>
    <message>
        <source>Export the body without its animations</source>
        <translation>Den Körper ohne Animationen exportieren</translation>
    </message>
    <message>
        <source>Export the body's surface as a mesh</source>
        <translation>Die Oberfläche des Körpers als Netz exportieren</translation>
    </message>
    <message>
        <source>Export the mesh again, best as binary glTF (.glb)</source>
        <translation>Das Netz noch einmal exportieren, am besten als binäres glTF (.glb)</translation>
    </message>
    <message>
        <source>Export the mesh again, simpler if it is very large; the file may be damaged</source>
        <translation>Das Netz noch einmal exportieren, einfacher, falls es sehr groß ist; die Datei kann beschädigt sein</translation>
    </message>
    <message>
        <source>Export the mesh again; the file is damaged</source>
        <translation>Das Netz noch einmal exportieren; die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>Export the mesh again; this file is damaged or was written wrongly</source>
        <translation>Das Netz noch einmal exportieren; diese Datei ist beschädigt oder wurde falsch geschrieben</translation>
    </message>
    <message>
        <source>Give every vertex a weight (in Blender: Parent, With Automatic Weights), and export again</source>
        <translation>Jedem Eckpunkt ein Gewicht geben (in Blender: Parent, With Automatic Weights) und noch einmal exportieren</translation>
    </message>
    <message>
        <source>Give every vertex of the skin a weight</source>
        <translation>Jedem Eckpunkt der Haut ein Gewicht geben</translation>
    </message>
    <message>
        <source>Install the program again; this one belongs beside it</source>
        <translation>Das Programm neu installieren; dieses gehört daneben</translation>
    </message>
    <message>
        <source>Name the bones as HumanIK or Mixamo do: Hips, Spine, LeftArm, LeftForeArm</source>
        <translation>Die Knochen wie HumanIK oder Mixamo benennen: Hips, Spine, LeftArm, LeftForeArm</translation>
    </message>
    <message>
        <source>Simplify the mesh in the program that made it</source>
        <translation>Das Netz in dem Programm vereinfachen, mit dem es erstellt wurde</translation>
    </message>
    <message>
        <source>a chunk of it ends early</source>
        <translation>ein Abschnitt darin endet zu früh</translation>
    </message>
    <message>
        <source>a node shows a mesh that does not exist</source>
        <translation>ein Knoten zeigt ein Netz, das es nicht gibt</translation>
    </message>
    <message>
        <source>a triangle uses a vertex that does not exist</source>
        <translation>ein Dreieck verwendet einen Eckpunkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>a vertex hangs on a joint that its skin does not have</source>
        <translation>ein Eckpunkt hängt an einem Gelenk, das die Haut nicht hat</translation>
    </message>
    <message>
        <source>accessor %1 holds elements of %2 numbers instead of %3</source>
        <translation>Accessor %1 enthält Elemente von %2 Zahlen statt %3</translation>
    </message>
    <message>
        <source>accessor %1 holds what is no index</source>
        <translation>Accessor %1 enthält, was kein Index ist</translation>
    </message>
    <message>
        <source>accessor %1 replaces what is not there</source>
        <translation>Accessor %1 ersetzt, was nicht da ist</translation>
    </message>
    <message>
        <source>an animation of it holds no usable keys</source>
        <translation>eine Animation darin enthält keine brauchbaren Schlüsselbilder</translation>
    </message>
    <message>
        <source>bone %1 has a weight that is negative or no number</source>
        <translation>Knochen %1 hat ein Gewicht, das negativ oder keine Zahl ist</translation>
    </message>
    <message>
        <source>bone %1 is not in its tree</source>
        <translation>Knochen %1 ist nicht in seinem Baum</translation>
    </message>
    <message>
        <source>bone %1 weighs a vertex that does not exist</source>
        <translation>Knochen %1 gewichtet einen Eckpunkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>it cannot be read; the reader broke down over it</source>
        <translation>sie ist nicht lesbar; das Leseprogramm ist daran abgestürzt</translation>
    </message>
    <message>
        <source>it ends early: %1 of %2 bytes are there</source>
        <translation>sie endet zu früh: %1 von %2 Bytes sind da</translation>
    </message>
    <message>
        <source>it has fewer normals than vertices</source>
        <translation>es hat weniger Normalen als Eckpunkte</translation>
    </message>
    <message>
        <source>it has fewer texture coordinates than vertices</source>
        <translation>es hat weniger Texturkoordinaten als Eckpunkte</translation>
    </message>
    <message>
        <source>it has fewer weights than vertices</source>
        <translation>es hat weniger Gewichte als Eckpunkte</translation>
    </message>
    <message>
        <source>it has more than %1 nodes</source>
        <translation>es hat mehr als %1 Knoten</translation>
    </message>
    <message>
        <source>it has more than %1 vertices</source>
        <translation>es hat mehr als %1 Eckpunkte</translation>
    </message>
    <message>
        <source>it is glTF of version %1, not 2</source>
        <translation>es ist glTF der Version %1, nicht 2</translation>
    </message>
    <message>
        <source>its nodes hang on each other in a circle</source>
        <translation>die Knoten hängen im Kreis aneinander</translation>
    </message>
    <message>
        <source>node %1 hangs on two others</source>
        <translation>Knoten %1 hängt an zwei anderen</translation>
    </message>
    <message>
        <source>node %1 has a child that does not exist</source>
        <translation>Knoten %1 hat einen untergeordneten Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>reading it takes more than %1 MB of memory</source>
        <translation>das Lesen braucht mehr als %1 MB Speicher</translation>
    </message>
    <message>
        <source>reading it took longer than %1 s</source>
        <translation>das Lesen dauerte länger als %1 s</translation>
    </message>
    <message>
        <source>this is no mesh that can be read: it holds no glTF</source>
        <translation>das ist kein lesbares Netz: es enthält kein glTF</translation>
    </message>
    <message>
        <source>triangle %1 uses a vertex that does not exist</source>
        <translation>Dreieck %1 verwendet einen Eckpunkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>vertex %1 holds something that is no number</source>
        <translation>Eckpunkt %1 enthält etwas, das keine Zahl ist</translation>
    </message>
</context>
<context>
    <name>core/mesh/retarget</name>
    <message>
        <source>%1: its legs have no length</source>
        <translation>%1: die Beine haben keine Länge</translation>
    </message>
    <message>
        <source>%1: the performer's skeleton has no %2 for the bone %3</source>
        <translation>%1: das Skelett des Darstellers hat kein %2 für den Knochen %3</translation>
    </message>
    <message>
        <source>Choose other bones for thighs, shins and feet</source>
        <translation>Andere Knochen für Oberschenkel, Unterschenkel und Füße wählen</translation>
    </message>
    <message>
        <source>Use a skeleton with the canonical joints, or leave that bone out</source>
        <translation>Ein Skelett mit den üblichen Gelenken verwenden oder diesen Knochen auslassen</translation>
    </message>
</context>
<context>
    <name>core/mesh/rig</name>
    <message>
        <source>%1: %2 has no place</source>
        <translation>%1: %2 hat keinen Ort</translation>
    </message>
    <message>
        <source>%1: a newer version of the program wrote this map of bones</source>
        <translation>%1: eine neuere Version des Programms schrieb diese Knochenzuordnung</translation>
    </message>
    <message>
        <source>%1: no part of its surface hangs on the bone %2 (%3%4) or below it</source>
        <translation>%1: kein Teil der Oberfläche hängt am Knochen %2 (%3%4) oder darunter</translation>
    </message>
    <message>
        <source>%1: these are no landmarks of a body; %2 is missing</source>
        <translation>%1: das sind keine Orte der Gelenke eines Körpers; %2 fehlt</translation>
    </message>
    <message>
        <source>%1: this is no map of bones</source>
        <translation>%1: das ist keine Knochenzuordnung</translation>
    </message>
    <message>
        <source>: no bones are found for %1</source>
        <translation>: keine Knochen wurden gefunden für %1</translation>
    </message>
    <message>
        <source>: no human skeleton is found in it</source>
        <translation>: kein menschliches Skelett wurde darin gefunden</translation>
    </message>
    <message>
        <source>Choose a file that was saved as a bone map</source>
        <translation>Eine Datei wählen, die als Knochenzuordnung gespeichert wurde</translation>
    </message>
    <message>
        <source>Choose a file that was saved as landmarks</source>
        <translation>Eine Datei wählen, in der Orte der Gelenke gespeichert wurden</translation>
    </message>
    <message>
        <source>Choose another bone for it</source>
        <translation>Einen anderen Knochen dafür wählen</translation>
    </message>
    <message>
        <source>Finding bones</source>
        <translation>Knochen werden gesucht</translation>
    </message>
    <message>
        <source>Fitting a skeleton</source>
        <translation>Skelett wird eingepasst</translation>
    </message>
    <message>
        <source>Give the skin weights, or say in a map of bones which bones move it</source>
        <translation>Der Haut Gewichte geben oder in einer Knochenzuordnung angeben, welche Knochen sie bewegen</translation>
    </message>
    <message>
        <source>Looking for each point's bone</source>
        <translation>Zu jedem Punkt wird der Knochen gesucht</translation>
    </message>
    <message>
        <source>Name its bones as HumanIK, Mixamo, VRM or Rigify do, or say which bone is which in a map of bones</source>
        <translation>Die Knochen wie HumanIK, Mixamo, VRM oder Rigify benennen oder in einer Knochenzuordnung angeben, welcher Knochen welcher ist</translation>
    </message>
    <message>
        <source>Open it with that version, or map the bones again</source>
        <translation>Mit dieser Version öffnen oder die Knochen neu zuordnen</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Repair the mesh: it must be the closed surface of a body</source>
        <translation>Das Netz reparieren: es muss die geschlossene Oberfläche eines Körpers sein</translation>
    </message>
    <message>
        <source>Set all joints of the body</source>
        <translation>Alle Gelenke des Körpers setzen</translation>
    </message>
    <message>
        <source>Spreading heat</source>
        <translation>Wärme wird verteilt</translation>
    </message>
    <message>
        <source>Use a figure that stands upright with its arms away from its body, or set the joints by hand</source>
        <translation>Eine Figur verwenden, die aufrecht steht und die Arme vom Körper weghält, oder die Gelenke von Hand setzen</translation>
    </message>
    <message>
        <source>Weights cannot be found: parts of the surface stay cold</source>
        <translation>Gewichte lassen sich nicht finden: Teile der Oberfläche bleiben kalt</translation>
    </message>
    <message>
        <source>Weights cannot be found: the surface has no area</source>
        <translation>Gewichte lassen sich nicht finden: die Oberfläche hat keine Fläche</translation>
    </message>
    <message>
        <source>no ankle was found</source>
        <translation>kein Knöchel wurde gefunden</translation>
    </message>
    <message>
        <source>no arm was found on the %1</source>
        <translation>kein Arm wurde gefunden: %1</translation>
    </message>
    <message>
        <source>no bone is %1</source>
        <translation>kein Knochen ist %1</translation>
    </message>
    <message>
        <source>no thigh was found</source>
        <translation>kein Oberschenkel wurde gefunden</translation>
    </message>
    <message>
        <source>no two legs were found</source>
        <translation>keine zwei Beine wurden gefunden</translation>
    </message>
    <message>
        <source>the bone %1 is to be both %2 and %3</source>
        <translation>der Knochen %1 soll sowohl %2 als auch %3 sein</translation>
    </message>
    <message>
        <source>the bone %1, which is to be %2, does not hang below %3</source>
        <translation>der Knochen %1, der %2 sein soll, hängt nicht unter %3</translation>
    </message>
    <message>
        <source>the figure does not stand upright</source>
        <translation>die Figur steht nicht aufrecht</translation>
    </message>
    <message>
        <source>the mesh has no bone %1, which is to be %2</source>
        <translation>das Netz hat keinen Knochen %1, der %2 sein soll</translation>
    </message>
    <message>
        <source>there is no joint %1</source>
        <translation>es gibt kein Gelenk %1</translation>
    </message>
</context>
<context>
    <name>core/motion</name>
    <message>
        <source>%1 does not fit its skeleton of %2 joints</source>
        <translation>%1 passt nicht zum Skelett von %2 Gelenken</translation>
    </message>
    <message>
        <source>%1 is not later than the one before it</source>
        <translation>%1 ist nicht später als der davor</translation>
    </message>
    <message>
        <source>Align their times first, or look at the part where both were recorded</source>
        <translation>Zuerst ihre Zeiten ausrichten oder den Teil ansehen, in dem beide aufgenommen wurden</translation>
    </message>
    <message>
        <source>Name the reference's joints as the actor does, or give the actor aliases for them</source>
        <translation>Die Gelenke der Referenz wie in den Körpermaßen benennen oder dort Aliasnamen dafür angeben</translation>
    </message>
    <message>
        <source>Use the actor that the poses were made with</source>
        <translation>Die Körpermaße verwenden, mit denen die Posen entstanden</translation>
    </message>
    <message>
        <source>Write the poses in the order of their times</source>
        <translation>Die Posen in der Reihenfolge ihrer Zeiten schreiben</translation>
    </message>
    <message>
        <source>does not match at any shift (best correlation</source>
        <translation>passt bei keiner Verschiebung (beste Korrelation</translation>
    </message>
    <message>
        <source>does not match at any shift (best correlation %1)</source>
        <translation>passt bei keiner Verschiebung (beste Korrelation %1)</translation>
    </message>
    <message>
        <source>moves too little to tell the shift better than within %1</source>
        <translation>bewegt sich zu wenig, um die Verschiebung genauer als auf %1 zu bestimmen</translation>
    </message>
    <message>
        <source>repeats itself: %1 fit about as well as %2</source>
        <translation>wiederholt sich: %1 passen etwa so gut wie %2</translation>
    </message>
    <message>
        <source>repeats itself: %1 fits about as well as %2</source>
        <translation>wiederholt sich: %1 passt etwa so gut wie %2</translation>
    </message>
    <message>
        <source>the estimate</source>
        <translation>die Schätzung</translation>
    </message>
    <message>
        <source>the estimate and the reference have no instant in common</source>
        <translation>die Schätzung und die Referenz haben keinen Zeitpunkt gemeinsam</translation>
    </message>
    <message>
        <source>the estimate and the reference share no joint that moves</source>
        <translation>die Schätzung und die Referenz haben kein bewegtes Gelenk gemeinsam</translation>
    </message>
    <message>
        <source>the reference</source>
        <translation>die Referenz</translation>
    </message>
</context>
<context>
    <name>core/orientation</name>
    <message>
        <source>Orientation</source>
        <translation>Lage der Sensoren</translation>
    </message>
    <message>
        <source>complementary filter of Miller 2004, equations 1 to 14</source>
        <translation>Komplementärfilter von Miller 2004, Gleichungen 1 bis 14</translation>
    </message>
    <message>
        <source>complementary filter with a Gauss-Newton correction (Miller 2004, equation 15)</source>
        <translation>Komplementärfilter mit Gauß-Newton-Korrektur (Miller 2004, Gleichung 15)</translation>
    </message>
    <message>
        <source>error-state Kalman filter with biases, scale and the magnetometer's lag</source>
        <translation>Fehlerzustands-Kalman-Filter mit Nullpunktfehlern, Maßstab und Verzögerung des Magnetometers</translation>
    </message>
</context>
<context>
    <name>core/posing</name>
    <message>
        <source>Import the recording again and say where each sensor sits (--assign names or auto)</source>
        <translation>Die Aufzeichnung neu importieren und angeben, wo jeder Sensor sitzt (--assign names oder auto)</translation>
    </message>
    <message>
        <source>No walking was found: the performer is believed to stand upright in the first still second.</source>
        <translation>Kein Gehen wurde gefunden: es wird angenommen, dass der Darsteller in der ersten ruhigen Sekunde aufrecht steht.</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Posen</translation>
    </message>
    <message>
        <source>Sensor %1 does not read while the performer stands and is left out.</source>
        <translation>Sensor %1 misst nichts, während der Darsteller steht, und wird ausgelassen.</translation>
    </message>
    <message>
        <source>Sensor %1 sits on no segment of the actor and is left out.</source>
        <translation>Sensor %1 sitzt auf keinem Glied des Körpers und wird ausgelassen.</translation>
    </message>
    <message>
        <source>Stand still for a second, then move</source>
        <translation>Eine Sekunde still stehen, dann bewegen</translation>
    </message>
    <message>
        <source>The heading of sensor %1 is hardly known: neither its field nor its joints' movement tells it. Walk for ten seconds and more.</source>
        <translation>Die Richtung von Sensor %1 ist kaum bekannt: weder sein Magnetfeld noch die Bewegung seiner Gelenke verrät sie. Zehn Sekunden und länger gehen.</translation>
    </message>
    <message>
        <source>Which way the body faces is hardly known: record ten seconds of walking, or bend the knees</source>
        <translation>Wohin der Körper blickt, ist kaum bekannt: zehn Sekunden Gehen aufnehmen oder die Knie beugen</translation>
    </message>
    <message>
        <source>no sensor sits on a segment of the actor</source>
        <translation>kein Sensor sitzt auf einem Glied des Körpers</translation>
    </message>
    <message>
        <source>the recording is shorter than 2 s</source>
        <translation>die Aufzeichnung ist kürzer als 2 s</translation>
    </message>
</context>
<context>
    <name>core/processing</name>
    <message>
        <source>%.0f ms later</source>
        <translation>%.0f ms später</translation>
    </message>
    <message>
        <source>%1 (is %2, calibrated was %3)</source>
        <translation>%1 (ist %2, kalibriert wurde %3)</translation>
    </message>
    <message>
        <source>%1 and %2 sound on</source>
        <translation>%1 und %2 senden auf</translation>
    </message>
    <message>
        <source>%1 cannot be joined to the others: while the rest pose was held, too few distances to them or to the room fit. These poses are their own.</source>
        <translation>%1 lässt sich nicht mit den anderen verbinden: während der Ruhehaltung passten zu wenige Entfernungen zu ihnen oder zum Raum. Diese Posen stehen für sich.</translation>
    </message>
    <message>
        <source>%1 does not say which axis points up; %2 was taken, along which its markers reach farthest.</source>
        <translation>%1 sagt nicht, welche Achse nach oben zeigt; %2 wurde genommen, längs der ihre Marker am weitesten reichen.</translation>
    </message>
    <message>
        <source>%1 holds its first pose until %2 s.</source>
        <translation>%1 hält bis %2 s die erste Pose.</translation>
    </message>
    <message>
        <source>%1 holds its last pose from %2 s on.</source>
        <translation>%1 hält ab %2 s die letzte Pose.</translation>
    </message>
    <message>
        <source>%1 led by the %2, %3: %4 commands, %5 following, %6 states</source>
        <translation>%1, geführt von %2, %3: %4 Befehle, davon %5 folgend, %6 Zustände</translation>
    </message>
    <message>
        <source>%1 names anchor '%2', which the room does not have</source>
        <translation>%1 nennt den Anker „%2“, den der Raum nicht hat</translation>
    </message>
    <message>
        <source>%1 neither hears anybody nor is heard after %2: out of reach, or its box was lost. From there on the others are estimated without it.</source>
        <translation>%1 hört ab %2 niemanden mehr und wird nicht gehört: außer Reichweite, oder die Box ist verloren. Von da an werden die anderen ohne sie geschätzt.</translation>
    </message>
    <message>
        <source>%1 of %2 rows lie outside the take of %3</source>
        <translation>%1 von %2 Zeilen liegen außerhalb der Aufnahme von %3</translation>
    </message>
    <message>
        <source>%1 of 100 directions were seen</source>
        <translation>%1 von 100 Richtungen wurden gesehen</translation>
    </message>
    <message>
        <source>%1 rows of %2 could not be used, first %3.</source>
        <translation>%1 Zeilen von %2 waren nicht brauchbar, die erste: %3.</translation>
    </message>
    <message>
        <source>%1 sent no readings %2: the box was lost. The poses there are guesses; the others go on without it.</source>
        <translation>%1 hat %2 keine Messwerte gesendet: die Box ging verloren. Die Posen dort sind geraten; die anderen gehen ohne sie weiter.</translation>
    </message>
    <message>
        <source>%1 times %2</source>
        <translation>%1 mal %2</translation>
    </message>
    <message>
        <source>%1 was skipped and keeps what it had</source>
        <translation>%1 wurde ausgelassen und behält, was sie hatte</translation>
    </message>
    <message>
        <source>%1 wears several suits: only suit %2 is used yet.</source>
        <translation>%1 trägt mehrere Anzüge: bisher wird nur Anzug %2 verwendet.</translation>
    </message>
    <message>
        <source>%1%2. `noctule --batch calibrate sources --detector matched` says better.</source>
        <translation>%1%2. Genauer sagt es `noctule --batch calibrate sources --detector matched`.</translation>
    </message>
    <message>
        <source>%1, and the reference is aligned with one</source>
        <translation>%1, und die Referenz wird an einem ausgerichtet</translation>
    </message>
    <message>
        <source>%1, or say at which time of the take the file begins (--align MILLISECONDS)</source>
        <translation>%1, oder angeben, zu welcher Zeit der Aufnahme die Datei beginnt (--align MILLISECONDS)</translation>
    </message>
    <message>
        <source>%1: %2 and were left out.</source>
        <translation>%1: %2 und wurden ausgelassen.</translation>
    </message>
    <message>
        <source>%1: %2 has no pose in this result</source>
        <translation>%1: %2 hat in diesem Ergebnis keine Pose</translation>
    </message>
    <message>
        <source>%1: %2 of the take's %3 moving joints were recognised.</source>
        <translation>%1: %2 der %3 beweglichen Gelenke der Aufnahme wurden erkannt.</translation>
    </message>
    <message>
        <source>%1: %2; the times look like %3</source>
        <translation>%1: %2; die Zeiten sehen aus wie %3</translation>
    </message>
    <message>
        <source>%1: --between on needs two subjects, there is one</source>
        <translation>%1: --between on braucht zwei Darsteller, es gibt einen</translation>
    </message>
    <message>
        <source>%1: --room on needs anchors, the take has none</source>
        <translation>%1: --room on braucht Anker, die Aufnahme hat keine</translation>
    </message>
    <message>
        <source>%1: compared with result '%2', the motion %3</source>
        <translation>%1: Verglichen mit Ergebnis „%2“: Die Bewegung %3</translation>
    </message>
    <message>
        <source>%1: has %2 already</source>
        <translation>%1: hat schon %2</translation>
    </message>
    <message>
        <source>%1: has no result %2</source>
        <translation>%1: hat kein Ergebnis %2 mit Posen</translation>
    </message>
    <message>
        <source>%1: has no result '%2'</source>
        <translation>%1: hat kein Ergebnis „%2“</translation>
    </message>
    <message>
        <source>%1: has no room: none of its suits is made of anchors alone</source>
        <translation>%1: hat keinen Raum: keiner der Anzüge besteht nur aus Ankern</translation>
    </message>
    <message>
        <source>%1: has no subject '%2'</source>
        <translation>%1: hat keinen Darsteller „%2“</translation>
    </message>
    <message>
        <source>%1: has no subject of that name</source>
        <translation>%1: hat keinen Darsteller dieses Namens</translation>
    </message>
    <message>
        <source>%1: has not been processed, there is no result</source>
        <translation>%1: ist nicht verarbeitet, es gibt kein Ergebnis mit Posen</translation>
    </message>
    <message>
        <source>%1: has other boards than %2</source>
        <translation>%1: hat andere Platinen als %2</translation>
    </message>
    <message>
        <source>%1: holds %2 joints of the hips, three are needed to see how they are turned</source>
        <translation>%1: enthält %2 Gelenke der Hüfte; drei sind nötig, um ihre Drehung zu sehen</translation>
    </message>
    <message>
        <source>%1: holds no reference</source>
        <translation>%1: enthält keine Referenz</translation>
    </message>
    <message>
        <source>%1: holds the sound of anchors alone, whose clocks nobody joins</source>
        <translation>%1: enthält nur den Ton von Ankern, deren Uhren niemand verbindet</translation>
    </message>
    <message>
        <source>%1: is not JSON</source>
        <translation>%1: ist kein JSON</translation>
    </message>
    <message>
        <source>%1: it holds more distances between suits than fit into memory</source>
        <translation>%1: enthält mehr Abstände zwischen Anzügen, als in den Speicher passen</translation>
    </message>
    <message>
        <source>%1: it is too short or holds no sound: no pose came out</source>
        <translation>%1: zu kurz oder ohne Ton: es kam keine Pose heraus</translation>
    </message>
    <message>
        <source>%1: its columns are not those of the take's body</source>
        <translation>%1: die Spalten sind nicht die des Körpers der Aufnahme</translation>
    </message>
    <message>
        <source>%1: its suits are not counted from 1</source>
        <translation>%1: seine Anzüge sind nicht ab 1 gezählt</translation>
    </message>
    <message>
        <source>%1: no board has readings of a magnetometer</source>
        <translation>%1: keine Platine hat Messwerte eines Magnetometers</translation>
    </message>
    <message>
        <source>%1: no instant of the table has a reference after the rest pose</source>
        <translation>%1: kein Zeitpunkt der Tabelle hat nach der Ruhehaltung eine Referenz</translation>
    </message>
    <message>
        <source>%1: no joint that it shares with result '%2' moves for two seconds, so the shift cannot be told</source>
        <translation>%1: Kein Gelenk, das auch Ergebnis „%2“ hat, bewegt sich zwei Sekunden lang; die Verschiebung ist nicht zu bestimmen</translation>
    </message>
    <message>
        <source>%1: none of its rows within the take shows how the hips are turned</source>
        <translation>%1: keine der Zeilen innerhalb der Aufnahme zeigt, wie die Hüfte gedreht ist</translation>
    </message>
    <message>
        <source>%1: positions cannot be aligned in time by themselves</source>
        <translation>%1: Positionen lassen sich nicht von selbst zeitlich ausrichten</translation>
    </message>
    <message>
        <source>%1: positions do not say how the limbs are twisted, so angles cannot be compared with them</source>
        <translation>%1: Positionen sagen nicht, wie die Glieder verdreht sind; Winkel lassen sich also nicht damit vergleichen</translation>
    </message>
    <message>
        <source>%1: subjects cannot be estimated together: %2</source>
        <translation>%1: Darsteller lassen sich nicht gemeinsam schätzen: %2</translation>
    </message>
    <message>
        <source>%1: the clocks of %2 and of the room cannot be found from their sound</source>
        <translation>%1: Die Uhren von %2 und vom Raum lassen sich aus ihrem Schall nicht finden</translation>
    </message>
    <message>
        <source>%1: the field is bent for %2 of the time</source>
        <translation>%1: das Magnetfeld ist %2 der Zeit verzerrt</translation>
    </message>
    <message>
        <source>%1: the recording ends before the rest pose does. There are no poses of it.</source>
        <translation>%1: die Aufnahme endet, bevor die Ruhehaltung zu Ende ist. Es gibt davon keine Posen.</translation>
    </message>
    <message>
        <source>%1: the recording of a subject ends before the rest pose does</source>
        <translation>%1: die Aufnahme eines Darstellers endet, bevor die Ruhehaltung zu Ende ist</translation>
    </message>
    <message>
        <source>%1: the room's file has none of its anchors (%2)</source>
        <translation>%1: die Raumdatei kennt keinen der Anker (%2)</translation>
    </message>
    <message>
        <source>%1: the table's point '%2' of suit %3 is no device of this take</source>
        <translation>%1: der Punkt „%2“ von Anzug %3 in der Tabelle ist kein Gerät dieser Aufnahme</translation>
    </message>
    <message>
        <source>%1: the take holds %2</source>
        <translation>%1: Die Aufnahme enthält %2</translation>
    </message>
    <message>
        <source>%1: the unit of its lengths is not one that can be checked</source>
        <translation>%1: die Einheit der Längen lässt sich nicht prüfen</translation>
    </message>
    <message>
        <source>%1: there is no pose in the part to export</source>
        <translation>%1: im zu exportierenden Teil ist keine Pose</translation>
    </message>
    <message>
        <source>%1: there is no reading from %2 to %3, and no pose can be carried over that</source>
        <translation>%1: Von %2 bis %3 gibt es keinen Messwert, und darüber hinweg kann keine Pose geführt werden</translation>
    </message>
    <message>
        <source>%1: there is no reference of %2, points cannot be judged</source>
        <translation>%1: es gibt keine Referenz von %2, Punkte sind nicht zu beurteilen</translation>
    </message>
    <message>
        <source>%1; its names, axes and zero pose are taken as they are (Y up, unit %2)</source>
        <translation>%1; ihre Namen, Achsen und Nullpose werden übernommen, wie sie sind (Y nach oben, Einheit %2)</translation>
    </message>
    <message>
        <source>%1carriers only %2 apart: their pulses disturb each other. 5 kHz are needed.</source>
        <translation>%1Trägerfrequenzen, die nur %2 auseinanderliegen: ihre Pulse stören einander. 5 kHz sind nötig.</translation>
    </message>
    <message>
        <source>%1it is too short or holds no sound: no pose came out</source>
        <translation>%1zu kurz oder ohne Ton: es kam keine Pose heraus</translation>
    </message>
    <message>
        <source>%1one carrier, %2: nobody can tell whose pulse was heard</source>
        <translation>%1einer Trägerfrequenz, %2: niemand kann sagen, wessen Puls gehört wurde</translation>
    </message>
    <message>
        <source>'%1' is no number in range</source>
        <translation>„%1“ ist keine Zahl im Bereich</translation>
    </message>
    <message>
        <source>, %1 could not be written</source>
        <translation>, %1 konnten nicht geschrieben werden</translation>
    </message>
    <message>
        <source>, rest %.1f mm</source>
        <translation>, Rest %.1f mm</translation>
    </message>
    <message>
        <source>: a contact of</source>
        <translation>: ein Kontakt von</translation>
    </message>
    <message>
        <source>: a marker at</source>
        <translation>: eine Marke bei</translation>
    </message>
    <message>
        <source>: it has no drive %1</source>
        <translation>: sie hat keine Fahrt %1</translation>
    </message>
    <message>
        <source>: no drive of a robot is recorded in it</source>
        <translation>: darin ist keine Fahrt eines Roboters aufgenommen</translation>
    </message>
    <message>
        <source>Accelerometers and gyroscopes of %1 boards</source>
        <translation>Beschleunigungssensoren und Gyroskope von %1 Platinen</translation>
    </message>
    <message>
        <source>Aligning</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Anchor %1 contradicts the other anchors: it was moved, or its place was surveyed wrongly. Survey the room again.</source>
        <translation>Anker %1 widerspricht den anderen Ankern: er wurde bewegt, oder sein Ort wurde falsch vermessen. Den Raum neu vermessen.</translation>
    </message>
    <message>
        <source>Attach one first</source>
        <translation>Zuerst eine anhängen</translation>
    </message>
    <message>
        <source>Attach one with `noctule --batch attach`</source>
        <translation>Eine mit `noctule --batch attach` anhängen</translation>
    </message>
    <message>
        <source>Board %1 has no readings and was left out</source>
        <translation>Platine %1 hat keine Messwerte und wurde ausgelassen</translation>
    </message>
    <message>
        <source>Board %1 has no row with both gyroscope and accelerometer and was left out</source>
        <translation>Platine %1 hat keine Zeile mit Gyroskop und Beschleunigungssensor zugleich und wurde ausgelassen</translation>
    </message>
    <message>
        <source>Board %1 paused for %2 s in all, first at %3 s. How it turned meanwhile is a guess from the readings around</source>
        <translation>Platine %1 pausierte insgesamt %2 s, zuerst bei %3 s. Wie sie sich währenddessen drehte, ist aus den Messwerten davor und danach geschätzt</translation>
    </message>
    <message>
        <source>Board %1: the clock stands still or jumps back at %2 readings, which were left out</source>
        <translation>Platine %1: Die Uhr steht oder springt zurück bei %2 Messwerten, die ausgelassen wurden</translation>
    </message>
    <message>
        <source>Calibrate takes of one suit at a time</source>
        <translation>Aufnahmen eines einzigen Anzugs auf einmal kalibrieren</translation>
    </message>
    <message>
        <source>Check that it is the right file</source>
        <translation>Prüfen, ob es die richtige Datei ist</translation>
    </message>
    <message>
        <source>Check that it shows this take, or say at which time of it the file begins (--align MILLISECONDS)</source>
        <translation>Prüfen, ob sie diese Aufnahme zeigt, oder angeben, zu welcher Zeit der Aufnahme die Datei beginnt (--align MILLISECONDS)</translation>
    </message>
    <message>
        <source>Check that the suits heard each other</source>
        <translation>Prüfen, ob die Anzüge einander gehört haben</translation>
    </message>
    <message>
        <source>Check that they heard each other, or process with %1</source>
        <translation>Prüfen, ob sie einander gehört haben, oder mit %1 verarbeiten</translation>
    </message>
    <message>
        <source>Check that you may write there and that it has room</source>
        <translation>Prüfen, ob dort geschrieben werden darf und Platz ist</translation>
    </message>
    <message>
        <source>Check the calibration and the actor; another choice of sensors may work</source>
        <translation>Kalibrierung und Körpermaße prüfen; eine andere Wahl der Sensoren kann helfen</translation>
    </message>
    <message>
        <source>Check when it begins (--align)</source>
        <translation>Prüfen, wann sie beginnt (--align)</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Choose --from and --to within the take's duration</source>
        <translation>--from und --to innerhalb der Dauer der Aufnahme wählen</translation>
    </message>
    <message>
        <source>Choose a table that process --estimator comocap --points wrote</source>
        <translation>Eine Tabelle wählen, die process --estimator comocap --points geschrieben hat</translation>
    </message>
    <message>
        <source>Choose one of %1 (--subjects NAME)</source>
        <translation>Einen von %1 wählen (--subjects NAME)</translation>
    </message>
    <message>
        <source>Choose one that was made of this suit; its boards begin with %1</source>
        <translation>Eine wählen, die mit diesem Anzug entstand; dessen Platinen beginnen mit %1</translation>
    </message>
    <message>
        <source>Choose the table that was made of this take</source>
        <translation>Die Tabelle wählen, die aus dieser Aufnahme entstand</translation>
    </message>
    <message>
        <source>Commands while following</source>
        <translation>Befehle beim Folgen</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Comparing results</source>
        <translation>Ergebnisse werden verglichen</translation>
    </message>
    <message>
        <source>Counting pulses</source>
        <translation>Pulse werden gezählt</translation>
    </message>
    <message>
        <source>Data to command, median</source>
        <translation>Von den Daten zum Befehl, Median</translation>
    </message>
    <message>
        <source>Distance of the nearest two points</source>
        <translation>Abstand der nächsten zwei Punkte</translation>
    </message>
    <message>
        <source>Distances between suits are not used, each one's poses are its own: %1. %2.</source>
        <translation>Abstände zwischen Anzügen werden nicht genutzt, jeder hat nur seine eigenen Posen: %1. %2.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Error after the rest poses, root mean square.</source>
        <translation>Fehler nach der Ruhehaltung, quadratisches Mittel.</translation>
    </message>
    <message>
        <source>Error of all points</source>
        <translation>Fehler aller Punkte</translation>
    </message>
    <message>
        <source>Error of the vector between them</source>
        <translation>Fehler des Vektors zwischen ihnen</translation>
    </message>
    <message>
        <source>Error over time</source>
        <translation>Fehler über der Zeit</translation>
    </message>
    <message>
        <source>Export a file for each of the others</source>
        <translation>Exportieren Sie für jeden der anderen eine Datei</translation>
    </message>
    <message>
        <source>Export the take again</source>
        <translation>Die Aufnahme noch einmal exportieren</translation>
    </message>
    <message>
        <source>Fewer than three anchors agree with each other: several were moved, or the room was surveyed wrongly. Places and headings in the room cannot be trusted. Survey the room again.</source>
        <translation>Weniger als drei Anker stimmen miteinander überein: Mehrere wurden bewegt, oder der Raum wurde falsch vermessen. Orten und Richtungen im Raum ist nicht zu trauen. Den Raum neu vermessen.</translation>
    </message>
    <message>
        <source>Finding the clocks</source>
        <translation>Uhren werden gesucht</translation>
    </message>
    <message>
        <source>Following %1</source>
        <translation>%1 wird verfolgt</translation>
    </message>
    <message>
        <source>Free some space there and process the take</source>
        <translation>Dort Platz schaffen und die Aufnahme verarbeiten</translation>
    </message>
    <message>
        <source>Give columns for Hips, Spine, LeftUpLeg and RightUpLeg, or a BVH file</source>
        <translation>Spalten für Hips, Spine, LeftUpLeg und RightUpLeg oder eine BVH-Datei angeben</translation>
    </message>
    <message>
        <source>Give columns of joints that do not lie on a line</source>
        <translation>Spalten von Gelenken angeben, die nicht auf einer Geraden liegen</translation>
    </message>
    <message>
        <source>Give it a calibration; for readings in rad/s and m/s^2 one with zero 0 and the identity</source>
        <translation>Eine Kalibrierung dazu geben; für Messwerte in rad/s und m/s^2 eine mit Nullpunkt 0 und der Einheitsmatrix</translation>
    </message>
    <message>
        <source>Give the calibration of this suit</source>
        <translation>Die Kalibrierung dieses Anzugs angeben</translation>
    </message>
    <message>
        <source>Give the file of this room</source>
        <translation>Geben Sie die Datei dieses Raums an</translation>
    </message>
    <message>
        <source>Give the motion as BVH, or attach the positions as the root's (--as external-root)</source>
        <translation>Die Bewegung als BVH geben oder die Positionen als die der Wurzel anhängen (--as external-root)</translation>
    </message>
    <message>
        <source>Gravity: rms error of its length at rest. Turns: rms angle between gravity carried by the gyroscope and gravity seen.</source>
        <translation>Schwerkraft: quadratisches Mittel des Fehlers ihrer Länge in Ruhe. Drehungen: quadratisches Mittel des Winkels zwischen der vom Gyroskop mitgeführten und der gemessenen Schwerkraft.</translation>
    </message>
    <message>
        <source>Import a recording that brings one, as BROAD's trials do</source>
        <translation>Eine Aufzeichnung importieren, die eine mitbringt, wie die Versuche von BROAD</translation>
    </message>
    <message>
        <source>In the take</source>
        <translation>In der Aufnahme</translation>
    </message>
    <message>
        <source>Inertial sensors by hand</source>
        <translation>Inertialsensoren von Hand</translation>
    </message>
    <message>
        <source>It holds anchors alone</source>
        <translation>Sie enthält nur Anker</translation>
    </message>
    <message>
        <source>It is of one performer: leave out the subjects</source>
        <translation>Sie ist von einer Person: die Darsteller weglassen</translation>
    </message>
    <message>
        <source>Its anchors are %1</source>
        <translation>Die Anker sind %1</translation>
    </message>
    <message>
        <source>Its magnetometer may be broken or shielded; skip it</source>
        <translation>Das Magnetometer ist vielleicht defekt oder abgeschirmt; den Sensor auslassen</translation>
    </message>
    <message>
        <source>Its results are %1</source>
        <translation>Ihre Ergebnisse sind %1</translation>
    </message>
    <message>
        <source>Its subjects are %1</source>
        <translation>Ihre Darsteller sind %1</translation>
    </message>
    <message>
        <source>Joints in the file are elsewhere than in the take.</source>
        <translation>Gelenke in der Datei sind an anderen Orten als in der Aufnahme.</translation>
    </message>
    <message>
        <source>Joints in the file are turned otherwise than in the take.</source>
        <translation>Gelenke in der Datei sind anders gedreht als in der Aufnahme.</translation>
    </message>
    <message>
        <source>Keep away from iron, magnets and cables, or expect a worse heading there</source>
        <translation>Von Eisen, Magneten und Kabeln fernhalten oder dort mit einer schlechteren Richtung rechnen</translation>
    </message>
    <message>
        <source>Learning the sources' pulses</source>
        <translation>Die Pulse der Quellen werden gelernt</translation>
    </message>
    <message>
        <source>Leave it out with --subjects, or record again</source>
        <translation>Lassen Sie sie mit --subjects weg, oder nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>Leave out --between on and --room on, or what stands in their way</source>
        <translation>--between on und --room on weglassen oder das, was ihnen im Weg steht</translation>
    </message>
    <message>
        <source>Leave out --between, or name more of them with --subjects</source>
        <translation>--between weglassen oder mit --subjects mehr davon nennen</translation>
    </message>
    <message>
        <source>Leave out --room</source>
        <translation>--room weglassen</translation>
    </message>
    <message>
        <source>Leave the root free (--root free), or attach the other system's motion (--as external-root)</source>
        <translation>Die Wurzel frei lassen (--root free) oder die Bewegung des anderen Systems anhängen (--as external-root)</translation>
    </message>
    <message>
        <source>Leave this subject out with --subjects, or record again</source>
        <translation>Diesen Darsteller mit --subjects auslassen oder neu aufnehmen</translation>
    </message>
    <message>
        <source>Listening</source>
        <translation>Zuhören</translation>
    </message>
    <message>
        <source>Look at the take with inspect</source>
        <translation>Die Aufnahme mit inspect ansehen</translation>
    </message>
    <message>
        <source>Look at the take with inspect; a take of sound is processed by the others</source>
        <translation>Die Aufnahme mit inspect ansehen; eine Aufnahme mit Ton wird von den anderen verarbeitet</translation>
    </message>
    <message>
        <source>Made again by</source>
        <translation>Neu erzeugen mit</translation>
    </message>
    <message>
        <source>Magnetometer of %1</source>
        <translation>Magnetometer von %1</translation>
    </message>
    <message>
        <source>Measuring the sound</source>
        <translation>Ton wird gemessen</translation>
    </message>
    <message>
        <source>Name the column %1, or give the times in seconds</source>
        <translation>Die Spalte %1 nennen oder die Zeiten in Sekunden angeben</translation>
    </message>
    <message>
        <source>No distances from a source: %1.</source>
        <translation>Keine Entfernungen von einer Quelle: %1.</translation>
    </message>
    <message>
        <source>No rest pose is marked: the motion is believed to begin in it.</source>
        <translation>Keine Ruhehaltung ist markiert: es wird angenommen, dass die Bewegung in ihr beginnt.</translation>
    </message>
    <message>
        <source>No unit makes the figure in %1 as tall as a person</source>
        <translation>Keine Einheit macht die Figur in %1 so groß wie einen Menschen</translation>
    </message>
    <message>
        <source>Nobody hears the anchors of the room, and they hear nobody: where people are in the room is not known. Check that the room's box sounded and has a calibration.</source>
        <translation>Niemand hört die Anker des Raums, und sie hören niemanden: Wo im Raum jemand steht, ist nicht bekannt. Prüfen, ob die Box des Raums getönt hat und eine Kalibrierung hat.</translation>
    </message>
    <message>
        <source>Not usable: %1</source>
        <translation>Nicht brauchbar: %1</translation>
    </message>
    <message>
        <source>Nothing corrected the heading in the %1 minutes after the rest pose: estimator %2 keeps the gyroscopes' zeros of then. The heading drifts by 1 to 3° a minute, and so do joints that ranges do not back. Estimator manifold follows the zeros.</source>
        <translation>In den %1 Minuten nach der Ruhehaltung hat nichts die Richtung berichtigt: Der Schätzer %2 behält die Nullpunkte der Gyroskope von damals. Die Richtung driftet um 1 bis 3° je Minute, ebenso Gelenke, die keine Entfernungen stützen. Der Schätzer manifold folgt den Nullpunkten.</translation>
    </message>
    <message>
        <source>Of %1 %2 only the first %3 are listed.</source>
        <translation>Von %1 %2 sind nur die ersten %3 aufgeführt.</translation>
    </message>
    <message>
        <source>Offsets for detector matched were derived from those for inflection for</source>
        <translation>Versätze für den Detektor matched wurden aus denen für inflection abgeleitet für</translation>
    </message>
    <message>
        <source>One anchor alone does not tell how everybody is turned about it: places and headings in the room are guesses, those of people to each other are not. Hang up two more anchors.</source>
        <translation>Ein Anker allein sagt nicht, wie alle um ihn gedreht sind: Orte und Richtungen im Raum sind geraten, die der Personen zueinander nicht. Zwei weitere Anker aufhängen.</translation>
    </message>
    <message>
        <source>Only %1 joints of the reference were recognised by their names.</source>
        <translation>Nur %1 Gelenke der Referenz wurden an ihren Namen erkannt.</translation>
    </message>
    <message>
        <source>Open the take again to see its results</source>
        <translation>Aufnahme erneut öffnen, um ihre Ergebnisse zu sehen</translation>
    </message>
    <message>
        <source>Orientation needs 10 to 10000 readings a second</source>
        <translation>Die Lage braucht 10 bis 10000 Messwerte je Sekunde</translation>
    </message>
    <message>
        <source>Orientation of %1</source>
        <translation>Lage von %1</translation>
    </message>
    <message>
        <source>Orientation of each sensor</source>
        <translation>Lage jedes Sensors</translation>
    </message>
    <message>
        <source>Points need them: take one that was recorded with anchors</source>
        <translation>Punkte brauchen sie: eine Aufnahme mit Ankern nehmen</translation>
    </message>
    <message>
        <source>Points report</source>
        <translation>Bericht über Punkte</translation>
    </message>
    <message>
        <source>Points that too few devices heard were lost %1 times; while one is lost, its sigma tells how far off it may be.</source>
        <translation>Punkte, die zu wenige Geräte hörten, gingen %1-mal verloren; solange einer verloren ist, sagt sein Sigma, wie weit er daneben liegen kann.</translation>
    </message>
    <message>
        <source>Process a part of the take, or with --between off</source>
        <translation>Einen Teil der Aufnahme verarbeiten oder mit --between off</translation>
    </message>
    <message>
        <source>Process it again</source>
        <translation>Neu verarbeiten</translation>
    </message>
    <message>
        <source>Process it as independent sensors, by attitudes and accelerations (--estimator orientation)</source>
        <translation>Als unabhängige Sensoren verarbeiten, nach Lagen und Beschleunigungen (--estimator orientation)</translation>
    </message>
    <message>
        <source>Process sigma</source>
        <translation>Prozess-Sigma</translation>
    </message>
    <message>
        <source>Processing readings</source>
        <translation>Messwerte werden verarbeitet</translation>
    </message>
    <message>
        <source>Processing sound</source>
        <translation>Ton wird verarbeitet</translation>
    </message>
    <message>
        <source>Processing together</source>
        <translation>Gemeinsam wird verarbeitet</translation>
    </message>
    <message>
        <source>Reading poses</source>
        <translation>Posen werden gelesen</translation>
    </message>
    <message>
        <source>Reading sound</source>
        <translation>Ton wird gelesen</translation>
    </message>
    <message>
        <source>Record again or import a file whose time rises from row to row</source>
        <translation>Neu aufnehmen oder eine Datei importieren, deren Zeit von Zeile zu Zeile steigt</translation>
    </message>
    <message>
        <source>Record it again</source>
        <translation>Noch einmal aufnehmen</translation>
    </message>
    <message>
        <source>Record it again, or process each subject with --between off --room off</source>
        <translation>Neu aufnehmen oder jeden Darsteller mit --between off --room off verarbeiten</translation>
    </message>
    <message>
        <source>Record one with `noctule --batch drive --record`, or name one that `inspect` lists</source>
        <translation>Nehmen Sie eine mit `noctule --batch drive --record` auf, oder nennen Sie eine, die `inspect` aufzählt</translation>
    </message>
    <message>
        <source>Record or import it as two takes; if the take is damaged, correct the instants of its readings</source>
        <translation>Als zwei Aufnahmen aufzeichnen oder importieren; ist die Aufnahme beschädigt, die Zeitpunkte ihrer Messwerte berichtigen</translation>
    </message>
    <message>
        <source>Record somebody in a suit who walks past them</source>
        <translation>Jemanden im Anzug aufnehmen, der an ihnen vorbeigeht</translation>
    </message>
    <message>
        <source>Record the anchors' box as a device of its own, with a suit whose segments are null</source>
        <translation>Nehmen Sie die Box der Anker als eigenes Gerät auf, mit einem Anzug, dessen Glieder null sind</translation>
    </message>
    <message>
        <source>Record with magnetometers switched on</source>
        <translation>Mit eingeschalteten Magnetometern aufnehmen</translation>
    </message>
    <message>
        <source>Recorded in a take; times are those at which commands were made and states arrived.</source>
        <translation>In einer Aufnahme festgehalten; Zeiten sind die, zu denen Befehle entstanden und Zustände ankamen.</translation>
    </message>
    <message>
        <source>Repeat its steps when it is to be calibrated</source>
        <translation>Ihre Schritte wiederholen, wenn sie kalibriert werden soll</translation>
    </message>
    <message>
        <source>Robot %1, led by the %2</source>
        <translation>Roboter %1, geführt von %2</translation>
    </message>
    <message>
        <source>Root mean square over all points, as figure 3 of Welch 2018.</source>
        <translation>Quadratisches Mittel über alle Punkte, wie Abbildung 3 von Welch 2018.</translation>
    </message>
    <message>
        <source>Rows that could not be written</source>
        <translation>Zeilen, die nicht geschrieben werden konnten</translation>
    </message>
    <message>
        <source>Run `noctule --batch inspect %1` to see what it holds</source>
        <translation>Mit `noctule --batch inspect %1` ansehen, was sie enthält</translation>
    </message>
    <message>
        <source>Run `noctule --batch process %1 --estimator orientation`: it gives the motion of the body from them</source>
        <translation>`noctule --batch process %1 --estimator orientation` ausführen: Es ergibt aus ihnen die Bewegung des Körpers</translation>
    </message>
    <message>
        <source>Run `noctule --batch process %1` first</source>
        <translation>Zuerst `noctule --batch process %1` ausführen</translation>
    </message>
    <message>
        <source>Run `noctule --batch process %1`: it decodes the sound and gives the motion of the whole body</source>
        <translation>`noctule --batch process %1` ausführen: Es entschlüsselt den Ton und ergibt die Bewegung des ganzen Körpers</translation>
    </message>
    <message>
        <source>Say at which time of the take the file begins (--align MILLISECONDS)</source>
        <translation>Angeben, zu welcher Zeit der Aufnahme die Datei beginnt (--align MILLISECONDS)</translation>
    </message>
    <message>
        <source>Say where they sit when it is imported (--map); single sensors need no body (verb orient)</source>
        <translation>Beim Import angeben, wo sie sitzen (--map); einzelne Sensoren brauchen keinen Körper (Befehl orient)</translation>
    </message>
    <message>
        <source>Sensor %1</source>
        <translation>Sensor %1</translation>
    </message>
    <message>
        <source>Sensor %1 has neither readings nor attitudes and is left out.</source>
        <translation>Sensor %1 hat weder Messwerte noch Lagen und wird ausgelassen.</translation>
    </message>
    <message>
        <source>Sensors laid down and turned by hand</source>
        <translation>Sensoren von Hand hingelegt und gedreht</translation>
    </message>
    <message>
        <source>Set it between the take's start and end</source>
        <translation>Ihn zwischen Anfang und Ende der Aufnahme setzen</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Speed of sound</source>
        <translation>Schallgeschwindigkeit</translation>
    </message>
    <message>
        <source>Stand still in sight of the anchors first, and see that the room's file has each of them right to 0.2 m: without that, their pulses cannot be told apart</source>
        <translation>Zuerst in Sicht der Anker still stehen, und darauf achten, dass die Datei des Raums jeden von ihnen auf 0,2 m genau nennt: sonst sind ihre Pulse nicht auseinanderzuhalten</translation>
    </message>
    <message>
        <source>Stand still in the rest pose first, in sight of the others. Anchors that hang in a square look alike from four sides: hang one of them half a metre lower</source>
        <translation>Zuerst in Sicht der anderen in der Ruhehaltung still stehen. Anker, die im Quadrat hängen, sehen von vier Seiten gleich aus: einen davon einen halben Meter tiefer hängen</translation>
    </message>
    <message>
        <source>Stated uncertainty of all points</source>
        <translation>Angegebene Unsicherheit aller Punkte</translation>
    </message>
    <message>
        <source>States of the robot</source>
        <translation>Zustände des Roboters</translation>
    </message>
    <message>
        <source>Suit %1 has an actor, but the take's subjects do not name it: it is left out.</source>
        <translation>Anzug %1 hat Körpermaße, aber die Darsteller der Aufnahme nennen ihn nicht: Er wird ausgelassen.</translation>
    </message>
    <message>
        <source>Take --estimator comocap</source>
        <translation>--estimator comocap nehmen</translation>
    </message>
    <message>
        <source>Take away the magnet that lies beside it and turn it again</source>
        <translation>Den Magneten daneben entfernen und es noch einmal drehen</translation>
    </message>
    <message>
        <source>The boxes' clocks are known from the rest pose alone, since no transceivers of all suits hear each other both ways: ranges between suits drift.</source>
        <translation>Die Uhren der Boxen sind nur aus der Ruhehaltung bekannt, da keine Sendeempfänger aller Anzüge einander in beiden Richtungen hören: Entfernungen zwischen Anzügen driften.</translation>
    </message>
    <message>
        <source>The calibration is of other parts: %1. Its values are used all the same; calibrate these parts.</source>
        <translation>Die Kalibrierung gehört zu anderen Teilen: %1. Ihre Werte werden trotzdem verwendet; diese Teile kalibrieren.</translation>
    </message>
    <message>
        <source>The calibration lacks the shape of pulses; it was learnt from this take's sound for</source>
        <translation>Der Kalibrierung fehlt die Form der Pulse; sie wurde aus dem Ton dieser Aufnahme gelernt für</translation>
    </message>
    <message>
        <source>The calibration was made for another suit, box %1; the take is of %2. Its values are used all the same; give the calibration of this suit.</source>
        <translation>Die Kalibrierung wurde für einen anderen Anzug erstellt, Box %1; die Aufnahme ist von %2. Ihre Werte werden trotzdem verwendet; die Kalibrierung dieses Anzugs angeben.</translation>
    </message>
    <message>
        <source>The clock of suit %1 cannot be found from the sound: it and the others do not hear each other well enough. Distances to it are not used.</source>
        <translation>Die Uhr des Anzugs %1 lässt sich aus dem Schall nicht finden: Er und die anderen hören einander nicht gut genug. Abstände zu ihm werden nicht verwendet.</translation>
    </message>
    <message>
        <source>The clock of suit %1 cannot be joined to that of suit %2: no transceivers of both hear each other well enough. It stands alone, at the recorder's guess, which may be 5 ms off.</source>
        <translation>Die Uhr von Anzug %1 lässt sich nicht mit der von Anzug %2 verbinden: keine Sender und Empfänger beider hören einander gut genug. Sie steht für sich, nach der Schätzung des Rekorders, die um 5 ms abweichen kann.</translation>
    </message>
    <message>
        <source>The default actor is kept in the take, with the poses.</source>
        <translation>Die Standardmaße bleiben mit den Posen in der Aufnahme.</translation>
    </message>
    <message>
        <source>The figure in the file faces another way than the performer.</source>
        <translation>Die Figur in der Datei blickt in eine andere Richtung als der Darsteller.</translation>
    </message>
    <message>
        <source>The figure in the file has another height than the performer.</source>
        <translation>Die Figur in der Datei hat eine andere Größe als der Darsteller.</translation>
    </message>
    <message>
        <source>The file holds %1 frames, the take has %2 in this range.</source>
        <translation>Die Datei enthält %1 Bilder, die Aufnahme hat in diesem Bereich %2.</translation>
    </message>
    <message>
        <source>The file name asks for %1, which is not known</source>
        <translation>Der Dateiname verlangt %1, was nicht bekannt ist</translation>
    </message>
    <message>
        <source>The file name is empty</source>
        <translation>Der Dateiname ist leer</translation>
    </message>
    <message>
        <source>The file names %1 of the take's %2 joints.</source>
        <translation>Die Datei nennt %1 der %2 Gelenke der Aufnahme.</translation>
    </message>
    <message>
        <source>The file runs at another frame rate than asked for.</source>
        <translation>Die Datei läuft mit einer anderen Bildrate als verlangt.</translation>
    </message>
    <message>
        <source>The nearest two points of different people: distance, and error of the vector between them, as figure 4 of Welch 2018.</source>
        <translation>Die nächsten zwei Punkte verschiedener Personen: Abstand und Fehler des Vektors zwischen ihnen, wie Abbildung 4 von Welch 2018.</translation>
    </message>
    <message>
        <source>The performers do not hear each other: where they stand to each other comes from the room alone.</source>
        <translation>Die Darsteller hören einander nicht: Wie sie zueinander stehen, kommt allein aus dem Raum.</translation>
    </message>
    <message>
        <source>The pictures have another size than asked for.</source>
        <translation>Die Bilder haben eine andere Größe als verlangt.</translation>
    </message>
    <message>
        <source>The reference has other axes or another rest pose, and its bones do not show how %1 segments are turned. That was taken from the result: constant errors of these are not counted: %2.</source>
        <translation>Die Referenz hat andere Achsen oder eine andere Ruhehaltung, und ihre Knochen zeigen nicht, wie %1 Glieder gedreht sind. Das wurde dem Ergebnis entnommen: ihre konstanten Fehler zählen nicht mit: %2.</translation>
    </message>
    <message>
        <source>The room</source>
        <translation>Der Raum</translation>
    </message>
    <message>
        <source>The room has no calibration: its anchors are believed to hang where the suit's file says.</source>
        <translation>Der Raum hat keine Kalibrierung: es wird angenommen, dass seine Anker hängen, wo die Anzugdatei es sagt.</translation>
    </message>
    <message>
        <source>The room's file had the anchors elsewhere: they are believed to face where the performer walked.</source>
        <translation>In der Raumdatei hingen die Anker woanders: Es wird angenommen, dass sie dorthin weisen, wo der Darsteller ging.</translation>
    </message>
    <message>
        <source>The room's file lacks %1: their places stay as they were.</source>
        <translation>In der Raumdatei fehlen %1: deren Plätze bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>The take has %1; the poses are made without.</source>
        <translation>In der Aufnahme: %1; die Posen entstehen ohne.</translation>
    </message>
    <message>
        <source>The take has more ranges between suits than are used for its clocks: their last rates are carried on to the end.</source>
        <translation>Die Aufnahme hat mehr Entfernungen zwischen Anzügen, als für ihre Uhren verwendet werden: deren letzte Raten werden bis zum Ende fortgeführt.</translation>
    </message>
    <message>
        <source>The take names no actor: the default actor of 1.75 m is used.</source>
        <translation>Die Aufnahme nennt keine Körpermaße: die Standardmaße für 1,75 m werden verwendet.</translation>
    </message>
    <message>
        <source>The take was never closed: it is being recorded, or the recording was cut short.</source>
        <translation>Die Aufnahme wurde nie abgeschlossen: sie läuft noch, oder sie wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There are no anchors: the common place and turn of all points is that of the start, and drifts.</source>
        <translation>Es gibt keine Anker: gemeinsamer Ort und gemeinsame Drehung aller Punkte sind die des Anfangs und driften.</translation>
    </message>
    <message>
        <source>There is no reference: how far the angles are off cannot be said.</source>
        <translation>Es gibt keine Referenz: wie weit die Winkel danebenliegen, lässt sich nicht sagen.</translation>
    </message>
    <message>
        <source>Tracking points</source>
        <translation>Punkte werden verfolgt</translation>
    </message>
    <message>
        <source>Turn it again away from magnets and steel</source>
        <translation>Drehen Sie sie noch einmal, weit weg von Magneten und Stahl</translation>
    </message>
    <message>
        <source>Turn it again through all directions, away from iron</source>
        <translation>Noch einmal in alle Richtungen drehen, fern von Eisen</translation>
    </message>
    <message>
        <source>Turn it again until 90 were seen</source>
        <translation>Noch einmal drehen, bis 90 gesehen wurden</translation>
    </message>
    <message>
        <source>Turn it again, slowly and through all directions</source>
        <translation>Drehen Sie sie noch einmal, langsam und durch alle Richtungen</translation>
    </message>
    <message>
        <source>Two people near each other</source>
        <translation>Zwei Personen nahe beieinander</translation>
    </message>
    <message>
        <source>Use --overwrite to replace it</source>
        <translation>Mit --overwrite ersetzen</translation>
    </message>
    <message>
        <source>Without anchors nothing measures the common place and turn of all points: they are those of the start, drift, and count in the error of all points. How sure the filter is of them means nothing.</source>
        <translation>Ohne Anker misst nichts, wo alle Punkte gemeinsam stehen und wie sie gedreht sind: Beides ist das vom Anfang, driftet und zählt zum Fehler aller Punkte. Wie sicher sich der Filter darin ist, sagt nichts aus.</translation>
    </message>
    <message>
        <source>Write metres, centimetres, millimetres or inches</source>
        <translation>Meter, Zentimeter, Millimeter oder Zoll schreiben</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>`noctule --batch inspect` lists its subjects</source>
        <translation>`noctule --batch inspect` zählt ihre Darsteller auf</translation>
    </message>
    <message>
        <source>`noctule --batch inspect` shows what is in it</source>
        <translation>`noctule --batch inspect` zeigt, was darin ist</translation>
    </message>
    <message>
        <source>a reference</source>
        <translation>eine Referenz</translation>
    </message>
    <message>
        <source>all points, mm</source>
        <translation>alle Punkte, mm</translation>
    </message>
    <message>
        <source>an external root</source>
        <translation>eine Wurzel von außen</translation>
    </message>
    <message>
        <source>batch</source>
        <translation>batch</translation>
    </message>
    <message>
        <source>between, mm</source>
        <translation>dazwischen, mm</translation>
    </message>
    <message>
        <source>board %1 is said to read other than 140 times a second, which sound cannot carry</source>
        <translation>Platine %1 soll anders als 140-mal je Sekunde messen, was der Schall nicht übertragen kann</translation>
    </message>
    <message>
        <source>board %1 reads at %2 Hz</source>
        <translation>Platine %1 misst mit %2 Hz</translation>
    </message>
    <message>
        <source>board %1: the time stamps stand still or jump back, which would leave out %2 of %3 readings</source>
        <translation>Platine %1: Die Zeitstempel stehen oder springen zurück; damit fielen %2 von %3 Messwerten weg</translation>
    </message>
    <message>
        <source>estimator %1 knows one body only</source>
        <translation>der Schätzer %1 kennt nur einen Körper</translation>
    </message>
    <message>
        <source>estimator environment needs anchors in the room, the take has none</source>
        <translation>der Schätzer environment braucht Anker im Raum, die Aufnahme hat keine</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>from %.1f s to %.1f s of %.1f s</source>
        <translation>von %.1f s bis %.1f s von %.1f s</translation>
    </message>
    <message>
        <source>full</source>
        <translation>voll</translation>
    </message>
    <message>
        <source>given</source>
        <translation>gegeben</translation>
    </message>
    <message>
        <source>gravity before m/s^2</source>
        <translation>Schwerkraft vorher m/s^2</translation>
    </message>
    <message>
        <source>holds attitudes that came with it; the orientation of each sensor needs readings of gyroscope and accelerometer</source>
        <translation>enthält Lagen, die mit ihr kamen; die Lage jedes Sensors braucht Messwerte von Gyroskop und Beschleunigungssensor</translation>
    </message>
    <message>
        <source>holds the sound of a driver box; the orientation of each sensor needs a take of inertial sensors</source>
        <translation>enthält den Ton einer Steuerbox; die Lage jedes Sensors braucht eine Aufnahme von Inertialsensoren</translation>
    </message>
    <message>
        <source>imu6</source>
        <translation>imu6</translation>
    </message>
    <message>
        <source>imu9</source>
        <translation>imu9</translation>
    </message>
    <message>
        <source>it has %1 cells, not 8</source>
        <translation>sie hat %1 Zellen, nicht 8</translation>
    </message>
    <message>
        <source>it has %1, so this estimator has too little to go by</source>
        <translation>in ihr: %1; damit hat dieser Schätzer zu wenig in der Hand</translation>
    </message>
    <message>
        <source>it has no calibration, and its readings are no counts: some are negative</source>
        <translation>sie hat keine Kalibrierung, und ihre Messwerte sind keine Zählwerte: einige sind negativ</translation>
    </message>
    <message>
        <source>it has no readings</source>
        <translation>sie hat keine Messwerte</translation>
    </message>
    <message>
        <source>it holds no ranges between its suits or to a room</source>
        <translation>sie enthält keine Entfernungen zwischen ihren Anzügen oder zu einem Raum</translation>
    </message>
    <message>
        <source>it reads no field</source>
        <translation>es misst kein Feld</translation>
    </message>
    <message>
        <source>its field is beyond its range</source>
        <translation>sein Feld liegt jenseits seines Messbereichs</translation>
    </message>
    <message>
        <source>its readings were dropped while it was processed</source>
        <translation>ihre Messwerte wurden während der Verarbeitung verworfen</translation>
    </message>
    <message>
        <source>its time does not increase</source>
        <translation>ihre Zeit nimmt nicht zu</translation>
    </message>
    <message>
        <source>lag</source>
        <translation>lag</translation>
    </message>
    <message>
        <source>length of the vector's error</source>
        <translation>Länge des Fehlers des Vektors</translation>
    </message>
    <message>
        <source>linear in temperature</source>
        <translation>linear in der Temperatur</translation>
    </message>
    <message>
        <source>microseconds</source>
        <translation>Mikrosekunden</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>Millisekunden</translation>
    </message>
    <message>
        <source>nanoseconds</source>
        <translation>Nanosekunden</translation>
    </message>
    <message>
        <source>near, mm</source>
        <translation>nahe, mm</translation>
    </message>
    <message>
        <source>no accelerometers</source>
        <translation>keine Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>no board has readings of gyroscope and accelerometer, which the orientation of each sensor needs</source>
        <translation>keine Platine hat Messwerte von Gyroskop und Beschleunigungssensor, welche die Lage jedes Sensors braucht</translation>
    </message>
    <message>
        <source>no distances</source>
        <translation>keine Entfernungen</translation>
    </message>
    <message>
        <source>no distances between its subjects</source>
        <translation>keine Entfernungen zwischen ihren Darstellern</translation>
    </message>
    <message>
        <source>no distances between its suits are known, since their clocks cannot be found from their sound</source>
        <translation>keine Abstände zwischen ihren Anzügen sind bekannt, da sich ihre Uhren aus ihrem Schall nicht finden lassen</translation>
    </message>
    <message>
        <source>no distances to its room</source>
        <translation>keine Entfernungen zu ihrem Raum</translation>
    </message>
    <message>
        <source>no gyroscopes</source>
        <translation>keine Gyroskope</translation>
    </message>
    <message>
        <source>no instant of the result has a reference</source>
        <translation>kein Zeitpunkt des Ergebnisses hat eine Referenz</translation>
    </message>
    <message>
        <source>no point came out: its ranges end before the rest pose does</source>
        <translation>es ergab sich kein Punkt: die Entfernungen enden vor der Ruhehaltung</translation>
    </message>
    <message>
        <source>no sensor has readings or attitudes</source>
        <translation>kein Sensor hat Messwerte oder Lagen</translation>
    </message>
    <message>
        <source>noctule --batch process %1</source>
        <translation>noctule --batch process %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>none of its boards sits on a segment of the body</source>
        <translation>keine ihrer Platinen sitzt auf einem Glied des Körpers</translation>
    </message>
    <message>
        <source>not observed</source>
        <translation>nicht beobachtet</translation>
    </message>
    <message>
        <source>nothing tells where %1 stands: while the rest pose was held, too few ranges fit</source>
        <translation>nichts sagt, wo %1 steht: während der Ruhehaltung passten zu wenige Entfernungen</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>one calibration or actor cannot be that of several subjects</source>
        <translation>eine Kalibrierung oder Körpermaße können nicht für mehrere Darsteller gelten</translation>
    </message>
    <message>
        <source>ours</source>
        <translation>ours</translation>
    </message>
    <message>
        <source>own</source>
        <translation>own</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>rms error of all points over time</source>
        <translation>quadratisches Mittel des Fehlers aller Punkte über der Zeit</translation>
    </message>
    <message>
        <source>s does not lie in the take of</source>
        <translation>s liegt nicht in der Aufnahme von</translation>
    </message>
    <message>
        <source>s lies outside the take of</source>
        <translation>s liegt außerhalb der Aufnahme von</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>geglättet</translation>
    </message>
    <message>
        <source>square root of the mean trace of the covariances</source>
        <translation>Wurzel der mittleren Spur der Kovarianzen</translation>
    </message>
    <message>
        <source>the calibration knows none of its boards</source>
        <translation>die Kalibrierung kennt keine ihrer Platinen</translation>
    </message>
    <message>
        <source>the calibration knows none of the suit's boards (%1)</source>
        <translation>die Kalibrierung kennt keine der Platinen des Anzugs (%1)</translation>
    </message>
    <message>
        <source>the columns are not</source>
        <translation>die Spalten sind nicht</translation>
    </message>
    <message>
        <source>the columns are not %1</source>
        <translation>die Spalten sind nicht %1</translation>
    </message>
    <message>
        <source>the estimator lost its state at %1 s: the data contradict each other</source>
        <translation>der Schätzer verlor seinen Zustand bei %1 s: die Daten widersprechen einander</translation>
    </message>
    <message>
        <source>the field has %1 µT there, which the Earth's has nowhere</source>
        <translation>das Feld hat dort %1 µT, die das der Erde nirgends hat</translation>
    </message>
    <message>
        <source>the field's strength differs by %1 between directions</source>
        <translation>die Feldstärke unterscheidet sich zwischen den Richtungen um %1</translation>
    </message>
    <message>
        <source>the hand as it was commanded</source>
        <translation>die Hand, wie sie befohlen wurde</translation>
    </message>
    <message>
        <source>the hand as the robot tells it</source>
        <translation>die Hand, wie der Roboter sie meldet</translation>
    </message>
    <message>
        <source>the results could not be kept beside the take</source>
        <translation>die Ergebnisse ließen sich nicht neben der Aufnahme ablegen</translation>
    </message>
    <message>
        <source>the room (suit %1)</source>
        <translation>der Raum (Anzug %1)</translation>
    </message>
    <message>
        <source>the sound holds %1 boards, the suit describes %2</source>
        <translation>der Ton enthält %1 Platinen, der Anzug beschreibt %2</translation>
    </message>
    <message>
        <source>the standard deviation of its zero is %1 µT</source>
        <translation>die Standardabweichung ihres Nullpunkts ist %1 µT</translation>
    </message>
    <message>
        <source>the take holds no distances between its suits</source>
        <translation>die Aufnahme enthält keine Abstände zwischen ihren Anzügen</translation>
    </message>
    <message>
        <source>there is no reference of a single sensor to compare with</source>
        <translation>es gibt keine Referenz eines einzelnen Sensors zum Vergleichen</translation>
    </message>
    <message>
        <source>there is no row</source>
        <translation>es gibt keine Zeile</translation>
    </message>
    <message>
        <source>true distance of the nearest two points</source>
        <translation>wahrer Abstand der nächsten zwei Punkte</translation>
    </message>
    <message>
        <source>turns before deg</source>
        <translation>Drehungen vorher deg</translation>
    </message>
    <message>
        <source>with --root given another system says where everybody is</source>
        <translation>mit --root given sagt ein anderes System, wo alle sind</translation>
    </message>
</context>
<context>
    <name>core/recording</name>
    <message>
        <source>%1 from others</source>
        <translation>%1 von anderen</translation>
    </message>
    <message>
        <source>%1 has no name or no list of suits</source>
        <translation>%1 hat keinen Namen oder keine Liste von Anzügen</translation>
    </message>
    <message>
        <source>%1 has suit %2, which the take does not describe</source>
        <translation>%1 hat Anzug %2, den die Aufnahme nicht beschreibt</translation>
    </message>
    <message>
        <source>%1 of suit %2</source>
        <translation>%1 von Anzug %2</translation>
    </message>
    <message>
        <source>%1 s of %2 s of the sound</source>
        <translation>%1 s von %2 s des Tons</translation>
    </message>
    <message>
        <source>%1. Characters that could not be read were replaced in so many texts: %2</source>
        <translation>%1. Nicht lesbare Zeichen wurden in so vielen Texten ersetzt: %2</translation>
    </message>
    <message>
        <source>%1. The list of what it had is damaged too, so more may be lost</source>
        <translation>%1. Auch das Verzeichnis ihres Inhalts ist beschädigt, es kann also mehr verloren sein</translation>
    </message>
    <message>
        <source>%1: %2%3 stands beside it, so it is in use</source>
        <translation>%1: %2%3 liegt daneben, die Datei ist also in Gebrauch</translation>
    </message>
    <message>
        <source>%1: a number to be stored is not finite</source>
        <translation>%1: eine zu speichernde Zahl ist nicht endlich</translation>
    </message>
    <message>
        <source>%1: a row contradicts another one%2</source>
        <translation>%1: eine Zeile widerspricht einer anderen%2</translation>
    </message>
    <message>
        <source>%1: another program holds a lock on the file</source>
        <translation>%1: ein anderes Programm hält eine Sperre auf die Datei</translation>
    </message>
    <message>
        <source>%1: cannot be opened%2</source>
        <translation>%1: lässt sich nicht öffnen%2</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1: lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>%1: cannot be read to its end</source>
        <translation>%1: lässt sich nicht bis zum Ende lesen</translation>
    </message>
    <message>
        <source>%1: exists already</source>
        <translation>%1: gibt es schon</translation>
    </message>
    <message>
        <source>%1: is a folder, not a take</source>
        <translation>%1: ist ein Ordner, keine Aufnahme</translation>
    </message>
    <message>
        <source>%1: is a take of format version %2, this program reads version %3</source>
        <translation>%1: ist eine Aufnahme der Formatversion %2, dieses Programm liest Version %3</translation>
    </message>
    <message>
        <source>%1: is being recorded, so it is left alone</source>
        <translation>%1: wird gerade aufgenommen und bleibt deshalb unberührt</translation>
    </message>
    <message>
        <source>%1: is damaged: %2</source>
        <translation>%1: ist beschädigt: %2</translation>
    </message>
    <message>
        <source>%1: is damaged: it was cut off</source>
        <translation>%1: ist beschädigt: ein Teil am Ende fehlt</translation>
    </message>
    <message>
        <source>%1: is empty: nothing was written into it</source>
        <translation>%1: ist leer: es wurde nichts hineingeschrieben</translation>
    </message>
    <message>
        <source>%1: is not a take</source>
        <translation>%1: ist keine Aufnahme</translation>
    </message>
    <message>
        <source>%1: is not a take, it is a database of another kind</source>
        <translation>%1: ist keine Aufnahme, es ist eine Datenbank anderer Art</translation>
    </message>
    <message>
        <source>%1: is not a take, its '%2' is a %3%4 instead of a table of rows</source>
        <translation>%1: ist keine Aufnahme, „%2“ ist %3%4 statt einer Tabelle mit Zeilen</translation>
    </message>
    <message>
        <source>%1: is not a take, its format is '%2'</source>
        <translation>%1: ist keine Aufnahme, das Format ist „%2“</translation>
    </message>
    <message>
        <source>%1: its -wal file cannot be used in this folder</source>
        <translation>%1: die -wal-Datei lässt sich in diesem Ordner nicht verwenden</translation>
    </message>
    <message>
        <source>%1: meta subjects: %2</source>
        <translation>%1: meta subjects: %2</translation>
    </message>
    <message>
        <source>%1: nothing in it can be read</source>
        <translation>%1: darin lässt sich nichts lesen</translation>
    </message>
    <message>
        <source>%1: reading one row takes too long</source>
        <translation>%1: eine Zeile zu lesen dauert zu lange</translation>
    </message>
    <message>
        <source>%1: reading or writing the disk failed%2</source>
        <translation>%1: Lesen oder Schreiben auf dem Datenträger schlug fehl%2</translation>
    </message>
    <message>
        <source>%1: run 0 is the recording itself and is never dropped</source>
        <translation>%1: Ergebnis 0 ist die Aufzeichnung selbst und wird nie verworfen</translation>
    </message>
    <message>
        <source>%1: the beginning of the file is damaged, which says where the rest is; nothing can be read</source>
        <translation>%1: der Anfang der Datei ist beschädigt, in dem steht, wo das Übrige ist; nichts lässt sich lesen</translation>
    </message>
    <message>
        <source>%1: the disk is full</source>
        <translation>%1: der Datenträger ist voll</translation>
    </message>
    <message>
        <source>%1: the file is damaged</source>
        <translation>%1: die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>%1: the file is damaged at its beginning</source>
        <translation>%1: die Datei ist an ihrem Anfang beschädigt</translation>
    </message>
    <message>
        <source>%1: the pose at %2 ns is not finite</source>
        <translation>%1: die Pose bei %2 ns ist nicht endlich</translation>
    </message>
    <message>
        <source>%1: there is no such marker any more</source>
        <translation>%1: diese Marke gibt es nicht mehr</translation>
    </message>
    <message>
        <source>%1: too little of it can be read to make a take of it</source>
        <translation>%1: davon lässt sich zu wenig für eine Aufnahme lesen</translation>
    </message>
    <message>
        <source>%1: unexpected content%2</source>
        <translation>%1: unerwarteter Inhalt%2</translation>
    </message>
    <message>
        <source>AND (pulse.id IS NULL OR %1)</source>
        <translation>AND (pulse.id IS NULL OR %1)</translation>
    </message>
    <message>
        <source>AND range.pulse BETWEEN %1 AND %2</source>
        <translation>AND range.pulse BETWEEN %1 AND %2</translation>
    </message>
    <message>
        <source>AND run=%1</source>
        <translation>AND run=%1</translation>
    </message>
    <message>
        <source>AND sample BETWEEN %1 AND %2</source>
        <translation>AND sample BETWEEN %1 AND %2</translation>
    </message>
    <message>
        <source>Add the number of boards (1 to 32) to its meta table</source>
        <translation>Die Anzahl der Platinen (1 bis 32) in ihre Tabelle meta eintragen</translation>
    </message>
    <message>
        <source>Add the rate with which the take was recorded to its meta table</source>
        <translation>Die Rate, mit der aufgenommen wurde, in die Tabelle meta der Aufnahme eintragen</translation>
    </message>
    <message>
        <source>All of it could be read</source>
        <translation>Alles ließ sich lesen</translation>
    </message>
    <message>
        <source>All that was found could be read</source>
        <translation>Alles Gefundene ließ sich lesen</translation>
    </message>
    <message>
        <source>Ask its author what is in it; `noctule --batch recover` may save the rest</source>
        <translation>Beim Ersteller nachfragen, was darin ist; `noctule --batch recover` kann den Rest retten</translation>
    </message>
    <message>
        <source>Check that the folder has room</source>
        <translation>Prüfen, ob der Ordner Platz hat</translation>
    </message>
    <message>
        <source>Check that the same data is not added twice</source>
        <translation>Prüfen, ob dieselben Daten zweimal hinzugefügt werden</translation>
    </message>
    <message>
        <source>Check that you may write there</source>
        <translation>Prüfen, ob dort geschrieben werden darf</translation>
    </message>
    <message>
        <source>Check the disk</source>
        <translation>Den Datenträger prüfen</translation>
    </message>
    <message>
        <source>Check the path and its permissions</source>
        <translation>Den Pfad und seine Rechte prüfen</translation>
    </message>
    <message>
        <source>Check the path and the permissions of the file and its folder</source>
        <translation>Pfad und Rechte von Datei und Ordner prüfen</translation>
    </message>
    <message>
        <source>Choose a .noctule file</source>
        <translation>Eine .noctule-Datei wählen</translation>
    </message>
    <message>
        <source>Choose a .noctule file from a source that you trust</source>
        <translation>Eine .noctule-Datei aus vertrauenswürdiger Quelle wählen</translation>
    </message>
    <message>
        <source>Choose another .noctule file</source>
        <translation>Eine andere .noctule-Datei wählen</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>Choose another name, or run `noctule --batch recover` on it first</source>
        <translation>Einen anderen Namen wählen oder zuerst `noctule --batch recover` darauf ausführen</translation>
    </message>
    <message>
        <source>Copy both files to a folder where you may write</source>
        <translation>Beide Dateien in einen Ordner kopieren, in dem geschrieben werden darf</translation>
    </message>
    <message>
        <source>Copy the file to a folder where you may write</source>
        <translation>Die Datei in einen Ordner kopieren, in dem geschrieben werden darf</translation>
    </message>
    <message>
        <source>Copying</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Correct subjects in the take's meta table, or remove it</source>
        <translation>subjects in der Tabelle meta der Aufnahme berichtigen oder entfernen</translation>
    </message>
    <message>
        <source>FROM range LEFT JOIN pulse ON pulse.id=range.pulse%1 AND +%2</source>
        <translation>FROM range LEFT JOIN pulse ON pulse.id=range.pulse%1 AND +%2</translation>
    </message>
    <message>
        <source>Free some space and try again</source>
        <translation>Platz schaffen und erneut versuchen</translation>
    </message>
    <message>
        <source>Give one to process, with --%1</source>
        <translation>Bei process eines mit --%1 angeben</translation>
    </message>
    <message>
        <source>Install a newer Noctule</source>
        <translation>Ein neueres Noctule installieren</translation>
    </message>
    <message>
        <source>Keep the file and its -wal; nothing was changed</source>
        <translation>Die Datei und ihre -wal-Datei aufbewahren; nichts wurde verändert</translation>
    </message>
    <message>
        <source>Look at the take again</source>
        <translation>Die Aufnahme erneut ansehen</translation>
    </message>
    <message>
        <source>Name a derived run</source>
        <translation>Ein abgeleitetes Ergebnis nennen</translation>
    </message>
    <message>
        <source>PRIMARY KEY(drive, sequence)</source>
        <translation>PRIMARY KEY(drive, sequence)</translation>
    </message>
    <message>
        <source>PRIMARY KEY(run, pulse, suit, board)</source>
        <translation>PRIMARY KEY(run, pulse, suit, board)</translation>
    </message>
    <message>
        <source>PRIMARY KEY(run, suit, board, frame)</source>
        <translation>PRIMARY KEY(run, suit, board, frame)</translation>
    </message>
    <message>
        <source>Please report this with the take</source>
        <translation>Zusammen mit der Aufnahme melden</translation>
    </message>
    <message>
        <source>Process the take first</source>
        <translation>Zuerst die Aufnahme verarbeiten</translation>
    </message>
    <message>
        <source>Run `noctule --batch inspect` on it to see what is there</source>
        <translation>`noctule --batch inspect` darauf ausführen, um zu sehen, was da ist</translation>
    </message>
    <message>
        <source>Run `noctule --batch recover` on it, which saves what can be read into a new file</source>
        <translation>`noctule --batch recover` darauf ausführen, das alles Lesbare in eine neue Datei rettet</translation>
    </message>
    <message>
        <source>Saved of it: %1; everything else is complete</source>
        <translation>Davon gespeichert: %1; alles Übrige ist vollständig</translation>
    </message>
    <message>
        <source>Use a copy of it, if there is one</source>
        <translation>Eine Kopie davon verwenden, falls es eine gibt</translation>
    </message>
    <message>
        <source>Use a take whose suit table has it</source>
        <translation>Eine Aufnahme verwenden, deren Tabelle suit ihn enthält</translation>
    </message>
    <message>
        <source>WHERE id=%1</source>
        <translation>WHERE id=%1</translation>
    </message>
    <message>
        <source>WHERE rowid=%1</source>
        <translation>WHERE rowid=%1</translation>
    </message>
    <message>
        <source>WHERE run=%1</source>
        <translation>WHERE run=%1</translation>
    </message>
    <message>
        <source>WHERE run=%1 AND %2=%3</source>
        <translation>WHERE run=%1 AND %2=%3</translation>
    </message>
    <message>
        <source>Wait until the other program is done, or close it, and try again</source>
        <translation>Warten, bis das andere Programm fertig ist, oder es schließen, dann erneut versuchen</translation>
    </message>
    <message>
        <source>Wait until the recording has ended</source>
        <translation>Warten, bis die Aufnahme beendet ist</translation>
    </message>
    <message>
        <source>Write the take again</source>
        <translation>Die Aufnahme erneut schreiben</translation>
    </message>
    <message>
        <source>a count is not a number or out of range</source>
        <translation>ein Zählwert ist keine Zahl oder liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>a number is missing or out of range</source>
        <translation>eine Zahl fehlt oder liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>a value is missing or out of range, or a sigma is not greater than zero</source>
        <translation>ein Wert fehlt oder liegt außerhalb des Bereichs, oder ein Sigma ist nicht größer als null</translation>
    </message>
    <message>
        <source>a value is missing, or it ends before it begins</source>
        <translation>ein Wert fehlt, oder es endet, bevor es beginnt</translation>
    </message>
    <message>
        <source>about %1 of %2</source>
        <translation>etwa %1 von %2</translation>
    </message>
    <message>
        <source>actor: the performer's measures</source>
        <translation>actor: die Maße des Darstellers</translation>
    </message>
    <message>
        <source>an unknown part of %1</source>
        <translation>ein unbekannter Teil von %1</translation>
    </message>
    <message>
        <source>board %1 frame %2</source>
        <translation>Platine %1 Rahmen %2</translation>
    </message>
    <message>
        <source>board is not in the suit</source>
        <translation>die Platine gehört nicht zum Anzug</translation>
    </message>
    <message>
        <source>calibration: how counts become values</source>
        <translation>calibration: wie aus Zählwerten Messwerte werden</translation>
    </message>
    <message>
        <source>cannot be unpacked:</source>
        <translation>lässt sich nicht entpacken:</translation>
    </message>
    <message>
        <source>cannot be unpacked: %1</source>
        <translation>lässt sich nicht entpacken: %1</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>contacts</translation>
    </message>
    <message>
        <source>contacts_%1</source>
        <translation>contacts_%1</translation>
    </message>
    <message>
        <source>data has %1 bytes instead of %2</source>
        <translation>data hat %1 Bytes statt %2</translation>
    </message>
    <message>
        <source>data is missing</source>
        <translation>data fehlt</translation>
    </message>
    <message>
        <source>drive is not 1, 2, ...</source>
        <translation>drive ist nicht 1, 2, ...</translation>
    </message>
    <message>
        <source>frame is not a count</source>
        <translation>frame ist keine Anzahl</translation>
    </message>
    <message>
        <source>id is not 1, 2, ...</source>
        <translation>id ist nicht 1, 2, ...</translation>
    </message>
    <message>
        <source>inertial</source>
        <translation>inertial</translation>
    </message>
    <message>
        <source>inertial: readings</source>
        <translation>inertial: Messwerte</translation>
    </message>
    <message>
        <source>is no list of subjects</source>
        <translation>ist keine Liste von Darstellern</translation>
    </message>
    <message>
        <source>is not a number from %1 to %2</source>
        <translation>ist keine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>its codec is not known to this program</source>
        <translation>sein Codec ist diesem Programm nicht bekannt</translation>
    </message>
    <message>
        <source>its joints or arms are not listed, or are too many</source>
        <translation>seine Gelenke oder Arme sind nicht aufgezählt oder zu viele</translation>
    </message>
    <message>
        <source>its pulse is missing or out of range</source>
        <translation>ihr Puls fehlt oder liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>key or value is missing</source>
        <translation>key oder value fehlt</translation>
    </message>
    <message>
        <source>meta says %1 boards, the suit describes %2</source>
        <translation>meta nennt %1 Platinen, der Anzug beschreibt %2</translation>
    </message>
    <message>
        <source>names nobody but the room</source>
        <translation>nennt niemanden außer dem Raum</translation>
    </message>
    <message>
        <source>nearly all are: they look like millimetres</source>
        <translation>fast alle liegen dort: Sie sehen nach Millimetern aus</translation>
    </message>
    <message>
        <source>nothing of %1</source>
        <translation>nichts von %1</translation>
    </message>
    <message>
        <source>of another board</source>
        <translation>einer anderen Platine</translation>
    </message>
    <message>
        <source>of suit %1</source>
        <translation>von Anzug %1</translation>
    </message>
    <message>
        <source>overlaps the block before</source>
        <translation>überschneidet sich mit dem Block davor</translation>
    </message>
    <message>
        <source>position or rotations are not those of %1 joints</source>
        <translation>Position oder Drehungen passen nicht zu %1 Gelenken</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>pulse</translation>
    </message>
    <message>
        <source>pulse: what the sources sent</source>
        <translation>pulse: was die Quellen sendeten</translation>
    </message>
    <message>
        <source>q or tips do not fit the drive's joints and arms</source>
        <translation>q oder tips passen nicht zu Gelenken und Armen der Fahrt</translation>
    </message>
    <message>
        <source>q, v or tips do not fit the drive's joints and arms</source>
        <translation>q, v oder tips passen nicht zu Gelenken und Armen der Fahrt</translation>
    </message>
    <message>
        <source>range</source>
        <translation>range</translation>
    </message>
    <message>
        <source>range: distances</source>
        <translation>range: Entfernungen</translation>
    </message>
    <message>
        <source>run is not 1, 2, ...</source>
        <translation>run ist nicht 1, 2, ...</translation>
    </message>
    <message>
        <source>sample is missing or out of range</source>
        <translation>sample fehlt oder liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>sample lies far beyond those around it</source>
        <translation>sample liegt weit jenseits der umgebenden</translation>
    </message>
    <message>
        <source>sequence or time is missing or out of range</source>
        <translation>Nummer oder Zeit fehlt oder liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>sigma does not hold three numbers per joint</source>
        <translation>sigma enthält nicht drei Zahlen je Gelenk</translation>
    </message>
    <message>
        <source>source is not in the suit</source>
        <translation>die Quelle gehört nicht zum Anzug</translation>
    </message>
    <message>
        <source>source or board is not in its suit</source>
        <translation>Quelle oder Platine gehört nicht zum Anzug</translation>
    </message>
    <message>
        <source>source or board is not in the suit</source>
        <translation>Quelle oder Platine gehört nicht zum Anzug</translation>
    </message>
    <message>
        <source>subject '%1'</source>
        <translation>Darsteller „%1“</translation>
    </message>
    <message>
        <source>subject '%1' has no actor: suit %2 carries none</source>
        <translation>Darsteller „%1“ hat keine Körpermaße: Anzug %2 enthält keine</translation>
    </message>
    <message>
        <source>suit %1 is named twice</source>
        <translation>Anzug %1 ist zweimal genannt</translation>
    </message>
    <message>
        <source>suit %1 is not described</source>
        <translation>Anzug %1 ist nicht beschrieben</translation>
    </message>
    <message>
        <source>suit is not 1, 2, ...</source>
        <translation>suit ist nicht 1, 2, ...</translation>
    </message>
    <message>
        <source>suit: which boards and sources there are</source>
        <translation>suit: welche Platinen und Quellen es gibt</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>text is missing</source>
        <translation>text fehlt</translation>
    </message>
    <message>
        <source>the boards' orientations</source>
        <translation>den Lagen der Platinen</translation>
    </message>
    <message>
        <source>the body measures</source>
        <translation>den Körpermaßen</translation>
    </message>
    <message>
        <source>the box's reports</source>
        <translation>den Meldungen der Steuerbox</translation>
    </message>
    <message>
        <source>the clocks' offsets</source>
        <translation>den Abweichungen der Uhren</translation>
    </message>
    <message>
        <source>the computed poses</source>
        <translation>den berechneten Posen</translation>
    </message>
    <message>
        <source>the distance is below 0</source>
        <translation>der Abstand liegt unter 0</translation>
    </message>
    <message>
        <source>the distance is beyond 20 m, farther than sound carries</source>
        <translation>der Abstand liegt über 20 m, weiter als der Schall trägt</translation>
    </message>
    <message>
        <source>the external root</source>
        <translation>der Wurzel von außen</translation>
    </message>
    <message>
        <source>the ground contacts</source>
        <translation>den Bodenkontakten</translation>
    </message>
    <message>
        <source>the inertial readings</source>
        <translation>den Trägheitsmesswerten</translation>
    </message>
    <message>
        <source>the list of calibrations</source>
        <translation>der Liste der Kalibrierungen</translation>
    </message>
    <message>
        <source>the list of gaps</source>
        <translation>der Liste der Lücken</translation>
    </message>
    <message>
        <source>the list of markers</source>
        <translation>der Liste der Marken</translation>
    </message>
    <message>
        <source>the list of notes</source>
        <translation>der Liste der Notizen</translation>
    </message>
    <message>
        <source>the list of results</source>
        <translation>der Liste der Ergebnisse</translation>
    </message>
    <message>
        <source>the list of robot drives</source>
        <translation>der Liste der Roboterfahrten</translation>
    </message>
    <message>
        <source>the measured distances</source>
        <translation>den gemessenen Entfernungen</translation>
    </message>
    <message>
        <source>the places of performers among each other</source>
        <translation>den Orten der Darsteller zueinander</translation>
    </message>
    <message>
        <source>the quaternion is not a unit</source>
        <translation>das Quaternion hat nicht die Länge eins</translation>
    </message>
    <message>
        <source>the reference motion</source>
        <translation>der Referenzbewegung</translation>
    </message>
    <message>
        <source>the robot's commands</source>
        <translation>den Befehlen an den Roboter</translation>
    </message>
    <message>
        <source>the robot's states</source>
        <translation>den Zuständen des Roboters</translation>
    </message>
    <message>
        <source>the room</source>
        <translation>der Raum</translation>
    </message>
    <message>
        <source>the sound</source>
        <translation>dem Ton</translation>
    </message>
    <message>
        <source>the sources' pulses</source>
        <translation>den Pulsen der Quellen</translation>
    </message>
    <message>
        <source>the suit's description</source>
        <translation>der Beschreibung des Anzugs</translation>
    </message>
    <message>
        <source>the table has more than %1 rows</source>
        <translation>die Tabelle hat mehr als %1 Zeilen</translation>
    </message>
    <message>
        <source>the take has more than 64 suits</source>
        <translation>die Aufnahme hat mehr als 64 Anzüge</translation>
    </message>
    <message>
        <source>the take's details</source>
        <translation>den Angaben zur Aufnahme</translation>
    </message>
    <message>
        <source>there are more than %1 rows</source>
        <translation>es sind mehr als %1 Zeilen</translation>
    </message>
    <message>
        <source>there are more than four pulses in a millisecond</source>
        <translation>es gibt mehr als vier Pulse in einer Millisekunde</translation>
    </message>
    <message>
        <source>there is no %1 %2</source>
        <translation>es gibt kein %1 %2</translation>
    </message>
    <message>
        <source>there is no result %1</source>
        <translation>es gibt kein Ergebnis %1 mit Posen</translation>
    </message>
    <message>
        <source>time is missing or out of range</source>
        <translation>die Zeit fehlt oder liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>time or quaternion is missing</source>
        <translation>Zeit oder Quaternion fehlt</translation>
    </message>
    <message>
        <source>two subjects are called '%1'</source>
        <translation>zwei Darsteller heißen „%1“</translation>
    </message>
    <message>
        <source>with id %1</source>
        <translation>mit id %1</translation>
    </message>
</context>
<context>
    <name>core/render</name>
    <message>
        <source>A picture of %1 x %2 pixels cannot be drawn</source>
        <translation>Ein Bild von %1 x %2 Pixeln lässt sich nicht zeichnen</translation>
    </message>
    <message>
        <source>Choose 1 to %1 pixels</source>
        <translation>1 bis %1 Pixel wählen</translation>
    </message>
    <message>
        <source>EGL does not start</source>
        <translation>EGL startet nicht</translation>
    </message>
    <message>
        <source>EGL offers no OpenGL</source>
        <translation>EGL bietet kein OpenGL</translation>
    </message>
    <message>
        <source>EGL's surfaceless platform is missing</source>
        <translation>die Plattform surfaceless von EGL fehlt</translation>
    </message>
    <message>
        <source>Install Mesa's EGL (libegl1 and libgl1-mesa-dri)</source>
        <translation>EGL von Mesa installieren (libegl1 und libgl1-mesa-dri)</translation>
    </message>
    <message>
        <source>Install the driver of the graphics card; everything but the 3D view works without it</source>
        <translation>Den Treiber der Grafikkarte installieren; alles außer der 3D-Ansicht läuft auch ohne ihn</translation>
    </message>
    <message>
        <source>Pictures cannot be drawn without a window: %1</source>
        <translation>Ohne Fenster lassen sich keine Bilder zeichnen: %1</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.3, and this computer offers %1</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.3, und dieser Rechner bietet %1</translation>
    </message>
    <message>
        <source>The graphics driver could not link the shaders "%1"</source>
        <translation>Der Grafiktreiber konnte die Shader „%1“ nicht verbinden</translation>
    </message>
    <message>
        <source>The graphics driver refused the shader "%1": %2</source>
        <translation>Der Grafiktreiber wies den Shader „%1“ ab: %2</translation>
    </message>
    <message>
        <source>Update the graphics driver</source>
        <translation>Den Grafiktreiber aktualisieren</translation>
    </message>
    <message>
        <source>another OpenGL context is in use in this thread</source>
        <translation>in diesem Thread ist ein anderer OpenGL-Kontext in Gebrauch</translation>
    </message>
    <message>
        <source>there is no OpenGL 3.3</source>
        <translation>es gibt kein OpenGL 3.3</translation>
    </message>
</context>
<context>
    <name>core/report</name>
    <message>
        <source>%1 (board %2)</source>
        <translation>%1 (Platine %2)</translation>
    </message>
    <message>
        <source>%1 against the reference</source>
        <translation>%1 gegen die Referenz</translation>
    </message>
    <message>
        <source>%1 and %2 were each estimated alone.</source>
        <translation>%1 und %2 wurden je allein geschätzt.</translation>
    </message>
    <message>
        <source>%1 and %2 were estimated together.</source>
        <translation>%1 und %2 wurden gemeinsam geschätzt.</translation>
    </message>
    <message>
        <source>%1 frames could not be compared because the reference has none near them.</source>
        <translation>%1 Bilder ließen sich nicht vergleichen, weil die Referenz keines in ihrer Nähe hat.</translation>
    </message>
    <message>
        <source>%1 has no sensor and keeps its usual pose.</source>
        <translation>%1 hat keinen Sensor und behält die übliche Pose.</translation>
    </message>
    <message>
        <source>%1 is less certain from %2 on: ranges stopped backing it. %3</source>
        <translation>%1 ist ab %2 weniger sicher: Entfernungen stützten es nicht mehr. %3</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 more than %2 off on average, worst %3 with %4.</source>
        <translation>%1 im Mittel um mehr als %2 daneben, am weitesten %3 mit %4.</translation>
    </message>
    <message>
        <source>%1 of %2 anchors are placed, the weakest to ±%3 mm. %4</source>
        <translation>%1 von %2 Ankern sind vermessen, der schwächste auf ±%3 mm. %4</translation>
    </message>
    <message>
        <source>%1 of %2 magnetometers calibrated; the field's strength is even to %3 %</source>
        <translation>%1 von %2 Magnetometern kalibriert; die Feldstärke ist auf %3 % gleichmäßig</translation>
    </message>
    <message>
        <source>%1 of %2 were backed by ranges in at least 90 % of the frames. Less: %3.</source>
        <translation>%1 von %2 wurden in mindestens 90 % der Bilder von Entfernungen gestützt. Weniger: %3.</translation>
    </message>
    <message>
        <source>%1 of the readings are present</source>
        <translation>%1 der Messwerte sind vorhanden</translation>
    </message>
    <message>
        <source>%1 of the take's distances cannot be: they lie below 0 or beyond 20 m. Give them in metres.</source>
        <translation>%1 der Abstände der Aufnahme sind unmöglich: Sie liegen unter 0 oder über 20 m. Sie in Metern angeben.</translation>
    </message>
    <message>
        <source>%1 s of movement</source>
        <translation>%1 s Bewegung</translation>
    </message>
    <message>
        <source>%1 was estimated alone.</source>
        <translation>%1 wurde allein geschätzt.</translation>
    </message>
    <message>
        <source>%1 was told by no sensor for %2 of the time.</source>
        <translation>%1 wurde %2 der Zeit von keinem Sensor erfasst.</translation>
    </message>
    <message>
        <source>%1, angle</source>
        <translation>%1, Winkel</translation>
    </message>
    <message>
        <source>%1, heard by %2</source>
        <translation>%1, gehört von %2</translation>
    </message>
    <message>
        <source>%1, mean %2</source>
        <translation>%1, im Mittel %2</translation>
    </message>
    <message>
        <source>%1, orientation difference</source>
        <translation>%1, Unterschied der Orientierung</translation>
    </message>
    <message>
        <source>%1. Calibrate what is missing first.</source>
        <translation>%1. Zuerst kalibrieren, was fehlt.</translation>
    </message>
    <message>
        <source>%1. It sits or points elsewhere than when it was calibrated.</source>
        <translation>%1. Es sitzt oder zeigt anders als bei der Kalibrierung.</translation>
    </message>
    <message>
        <source>%1. Mean joint error %2 against %3.</source>
        <translation>%1. Mittlerer Gelenkfehler %2 gegen %3.</translation>
    </message>
    <message>
        <source>%1. The recording ends before the rest pose does. There is no motion.</source>
        <translation>%1. Die Aufnahme endet, bevor die Ruhehaltung zu Ende ist. Es gibt keine Bewegung.</translation>
    </message>
    <message>
        <source>%1. Without a reference the error of this take is not known.</source>
        <translation>%1. Ohne Referenz ist der Fehler dieser Aufnahme nicht bekannt.</translation>
    </message>
    <message>
        <source>%1: a board or a source sits elsewhere than its calibration says, or the source offsets are another box's.</source>
        <translation>%1: Eine Platine oder Quelle sitzt anders, als ihre Kalibrierung sagt, oder der Quellenversatz gehört zu einer anderen Box.</translation>
    </message>
    <message>
        <source>%1: half of its ranges miss the pose by more than %2</source>
        <translation>%1: Die Hälfte der Entfernungen verfehlt die Pose um mehr als %2</translation>
    </message>
    <message>
        <source>%1: mean %2, %3 ranges used, %4 rejected, %5</source>
        <translation>%1: im Mittel %2, %3 Entfernungen verwendet, %4 verworfen, %5</translation>
    </message>
    <message>
        <source>%1delivered %2 of its readings. Check its plug and cable.</source>
        <translation>%1lieferte %2 ihrer Messwerte. Stecker und Kabel prüfen.</translation>
    </message>
    <message>
        <source>%1joined at %2 and left at %3.</source>
        <translation>%1von %2 bis %3 dabei.</translation>
    </message>
    <message>
        <source>%1joined at %2.</source>
        <translation>%1ab %2 dabei.</translation>
    </message>
    <message>
        <source>%1left at %2.</source>
        <translation>%1nur bis %2 dabei.</translation>
    </message>
    <message>
        <source>%1lost %2 of its frames. Check its plug and cable.</source>
        <translation>%1verlor %2 ihrer Rahmen. Stecker und Kabel prüfen.</translation>
    </message>
    <message>
        <source>%1was clipped in %2: the motion was faster than its range.</source>
        <translation>%1war übersteuert (%2): die Bewegung war schneller als ihr Messbereich.</translation>
    </message>
    <message>
        <source>, its nominal speed</source>
        <translation>, seine Nenndrehzahl</translation>
    </message>
    <message>
        <source>, measured by the accelerometers</source>
        <translation>, gemessen von den Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>, root given</source>
        <translation>, Wurzel gegeben</translation>
    </message>
    <message>
        <source>. Anchors left out: %1</source>
        <translation>. Weggelassene Anker: %1</translation>
    </message>
    <message>
        <source>1, good from 0.5</source>
        <translation>1, gut ab 0,5</translation>
    </message>
    <message>
        <source>A joint is backed by ranges in a frame when, a moment before, a range in use lay across it. Otherwise it goes on by its boards' inertia, and without these by the model. The rest pose at the beginning does not count.</source>
        <translation>Ein Gelenk ist in einem Bild von Entfernungen gestützt, wenn einen Augenblick zuvor eine verwendete Entfernung über ihm lag. Sonst läuft es mit der Trägheit seiner Platinen weiter und ohne diese mit dem Modell. Die Ruhehaltung am Anfang zählt nicht.</translation>
    </message>
    <message>
        <source>A stands for accelerometers, G for gyroscopes and D for distances.</source>
        <translation>A steht für Beschleunigungssensoren, G für Gyroskope und D für Entfernungen (distances).</translation>
    </message>
    <message>
        <source>A third of the ranges miss the pose by more than %1</source>
        <translation>Ein Drittel der Entfernungen verfehlt die Pose um mehr als %1</translation>
    </message>
    <message>
        <source>AGD</source>
        <translation>AGD</translation>
    </message>
    <message>
        <source>Acceleration and rate of turning, as the boards measure them</source>
        <translation>Beschleunigung und Drehrate, wie die Platinen sie messen</translation>
    </message>
    <message>
        <source>Accelerometers</source>
        <translation>Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>Accelerometers of %1 boards</source>
        <translation>Beschleunigungssensoren von %1 Platinen</translation>
    </message>
    <message>
        <source>Accelerometers, gyroscopes and distances; A+G+D means all three</source>
        <translation>Beschleunigungssensoren, Gyroskope und Entfernungen; A+G+D heißt alle drei</translation>
    </message>
    <message>
        <source>Actor</source>
        <translation>Körpermaße</translation>
    </message>
    <message>
        <source>Against the calibration in force.</source>
        <translation>Gegen die gültige Kalibrierung.</translation>
    </message>
    <message>
        <source>All boards</source>
        <translation>Alle Platinen</translation>
    </message>
    <message>
        <source>All boards lost %1 of their frames together: the link to the driver box broke off or was too slow. Check its cable or network.</source>
        <translation>Alle Platinen haben zugleich %1 ihrer Rahmen verloren: Die Verbindung zur Steuerbox riss ab oder war zu langsam. Ihr Kabel oder Netzwerk prüfen.</translation>
    </message>
    <message>
        <source>All joints</source>
        <translation>Alle Gelenke</translation>
    </message>
    <message>
        <source>All joints °</source>
        <translation>Alle Gelenke °</translation>
    </message>
    <message>
        <source>All pairs</source>
        <translation>Alle Paare</translation>
    </message>
    <message>
        <source>All that these numbers were made with.</source>
        <translation>Alles, womit diese Zahlen entstanden.</translation>
    </message>
    <message>
        <source>Anchors</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>Angle between the estimated and the reference orientation of a joint</source>
        <translation>Winkel zwischen der geschätzten Orientierung eines Gelenks und der der Referenz</translation>
    </message>
    <message>
        <source>Angle between the estimated and the reference orientation over time</source>
        <translation>Winkel zwischen geschätzter und Referenzorientierung über die Zeit</translation>
    </message>
    <message>
        <source>Angle between the estimated and the reference rotation of each joint, of result %1. Curves are Cardan angles in the order Z, X, Y from the T pose, named as the ISB names them; an angle is positive in the direction of its name.</source>
        <translation>Winkel zwischen geschätzter und Referenzdrehung jedes Gelenks, von Ergebnis %1. Kurven sind Kardanwinkel in der Reihenfolge Z, X, Y ab der T-Pose, benannt wie von der ISB; ein Winkel ist positiv in der Richtung seines Namens.</translation>
    </message>
    <message>
        <source>Angle, degrees</source>
        <translation>Winkel, Grad</translation>
    </message>
    <message>
        <source>Angles in degrees, lengths in metres unless a column says otherwise, time in minutes and seconds of the take.</source>
        <translation>Winkel in Grad, Längen in Metern, wenn eine Spalte nichts anderes sagt, Zeit in Minuten und Sekunden der Aufnahme.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>Bits repaired</source>
        <translation>Berich­tigte Bits</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Platine</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Platinen</translation>
    </message>
    <message>
        <source>Boards aligned by gravity alone: %1</source>
        <translation>Platinen allein durch die Schwerkraft ausgerichtet: %1</translation>
    </message>
    <message>
        <source>Boards aligned: %1 with %2</source>
        <translation>Ausgerichtete Platinen: %1 mit %2</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>By how much a measured distance differs from that in the estimated pose</source>
        <translation>Um wie viel ein gemessener Abstand von dem in der geschätzten Pose abweicht</translation>
    </message>
    <message>
        <source>By source</source>
        <translation>Nach Quelle</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Cannot be checked: %1</source>
        <translation>Keine Kontrolle möglich: %1</translation>
    </message>
    <message>
        <source>Cardan angles</source>
        <translation>Kardanwinkel</translation>
    </message>
    <message>
        <source>Change: standard deviation of the field's strength over the directions, in percent of its mean.</source>
        <translation>Änderung: Standardabweichung der Feldstärke über die Richtungen, in Prozent ihres Mittels.</translation>
    </message>
    <message>
        <source>Chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>Clipped, accelerometer</source>
        <translation>Über­steuert, Beschleuni­gungssensor</translation>
    </message>
    <message>
        <source>Clipped, gyroscope</source>
        <translation>Über­steuert, Gyroskop</translation>
    </message>
    <message>
        <source>Compared over %1 in %2 after %3 s of rest. Good: mean under %4 and no joint over %5; usable: mean under %6.</source>
        <translation>Verglichen über %1 in %2 nach %3 s Ruhe. Gut: Mittel unter %4 und kein Gelenk über %5; brauchbar: Mittel unter %6.</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>Confidence of each pulse over time as dots, 0 when not heard, and its mean over a second</source>
        <translation>Konfidenz jedes Pulses über die Zeit als Punkte, 0 wenn nicht gehört, und ihr Mittel über eine Sekunde</translation>
    </message>
    <message>
        <source>Curves follow of the head, the right shoulder, the left hip and the three joints that err most; those of all others are folded below them, by body part. Estimates are whole lines, the reference is dashed; a curve breaks where it passes 180°.</source>
        <translation>Es folgen Kurven von Kopf, rechter Schulter, linker Hüfte und den drei Gelenken mit dem größten Fehler; die aller anderen sind darunter nach Körperteilen eingeklappt. Schätzungen sind durchgezogen, die Referenz ist gestrichelt; eine Kurve bricht ab, wo sie 180° überschreitet.</translation>
    </message>
    <message>
        <source>Determined by measurements and not by the model of the body alone</source>
        <translation>Durch Messungen bestimmt und nicht allein durch das Modell des Körpers</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abwei­chung</translation>
    </message>
    <message>
        <source>Difference of the field's strength from its mean, a dot per direction</source>
        <translation>Abweichung der Feldstärke von ihrem Mittel, ein Punkt je Richtung</translation>
    </message>
    <message>
        <source>Difference to the reference over time</source>
        <translation>Unterschied zur Referenz über die Zeit</translation>
    </message>
    <message>
        <source>Distance from a source to a board, found from the time that a pulse takes</source>
        <translation>Abstand von einer Quelle zu einer Platine, aus der Zeit bestimmt, die ein Puls braucht</translation>
    </message>
    <message>
        <source>Distances between anchors</source>
        <translation>Abstände zwischen Ankern</translation>
    </message>
    <message>
        <source>Distances of single pairs</source>
        <translation>Entfernungen einzelner Paare</translation>
    </message>
    <message>
        <source>Drawn are the last %1 of %2 results.</source>
        <translation>Gezeichnet sind die letzten %1 von %2 Ergebnissen.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Drift °/min</source>
        <translation>Drift °/min</translation>
    </message>
    <message>
        <source>Each distance measured with offsets made without it. The paper had 2.35 mm in the mean, 1.92 mm deviation.</source>
        <translation>Jede Entfernung, gemessen mit Versätzen, die ohne sie entstanden. Die Veröffentlichung nannte 2,35 mm im Mittel, 1,92 mm Abweichung.</translation>
    </message>
    <message>
        <source>Error of every distance</source>
        <translation>Fehler jeder Entfernung</translation>
    </message>
    <message>
        <source>Error of every joint</source>
        <translation>Fehler jedes Gelenks</translation>
    </message>
    <message>
        <source>Error of gravity in every position</source>
        <translation>Fehler der Schwerkraft in jeder Stellung</translation>
    </message>
    <message>
        <source>Error of the rate in every turn and rest</source>
        <translation>Fehler der Drehrate bei jeder Drehung und Ruhe</translation>
    </message>
    <message>
        <source>Error that grows with time</source>
        <translation>Fehler, der mit der Zeit wächst</translation>
    </message>
    <message>
        <source>Errors of distances that took no part</source>
        <translation>Fehler der Entfernungen, die nicht beteiligt waren</translation>
    </message>
    <message>
        <source>Estimate and reference over time</source>
        <translation>Schätzung und Referenz über die Zeit</translation>
    </message>
    <message>
        <source>Estimate and reference over time; the band is two sigma of the estimate</source>
        <translation>Schätzung und Referenz über die Zeit; das Band ist zwei Sigma der Schätzung</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>Every joint was backed by ranges in at least 90 % of the frames.</source>
        <translation>Jedes Gelenk wurde in mindestens 90 % der Bilder von Entfernungen gestützt.</translation>
    </message>
    <message>
        <source>Extended Kalman filter</source>
        <translation>Erweiterter Kalman-Filter</translation>
    </message>
    <message>
        <source>Factor on the length that the performer's measures give.</source>
        <translation>Faktor auf die Länge, die sich aus den Maßen des Darstellers ergibt.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>ForeArm</source>
        <translation>ForeArm</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>Aus %1.</translation>
    </message>
    <message>
        <source>From microphone and source of a housing to those of the other, middle to middle.</source>
        <translation>Von Mitte zu Mitte der Gehäuse, zwischen Mikrofon und Quelle.</translation>
    </message>
    <message>
        <source>From the start of the drive to what the detector reports at distance 0.</source>
        <translation>Vom Beginn der Ansteuerung bis zu dem, was der Detektor bei Entfernung 0 meldet.</translation>
    </message>
    <message>
        <source>Gyroscopes</source>
        <translation>Gyroskope</translation>
    </message>
    <message>
        <source>Gyroscopes of %1 boards; the table turned at %2 rpm%3</source>
        <translation>Gyroskope von %1 Platinen; der Drehteller lief mit %2 U/min%3</translation>
    </message>
    <message>
        <source>Half of the values lie below it</source>
        <translation>Die Hälfte der Werte liegt darunter</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Heading and position of the root cannot be observed by the suit: nothing on it measures them absolutely, so they drift.</source>
        <translation>Richtung und Position der Wurzel kann der Anzug nicht beobachten: nichts an ihm misst sie absolut, also driften sie.</translation>
    </message>
    <message>
        <source>Heading, root mean square</source>
        <translation>Richtung, quadratisches Mittel</translation>
    </message>
    <message>
        <source>Heard</source>
        <translation>Gehört</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ver­deckt</translation>
    </message>
    <message>
        <source>How each result of this take compares with the reference: the angle between the two orientations of a joint, its mean and its standard deviation over the take.</source>
        <translation>Wie jedes Ergebnis dieser Aufnahme gegen die Referenz abschneidet: der Winkel zwischen den beiden Orientierungen eines Gelenks, sein Mittel und seine Standardabweichung über die Aufnahme.</translation>
    </message>
    <message>
        <source>How each sits on its segment. A turn about the vertical cannot be seen in a rest pose: headings stay as the suit's file has them.</source>
        <translation>Wie jede auf ihrem Glied sitzt. Eine Drehung um die Senkrechte ist in einer Ruhehaltung nicht zu sehen: Richtungen bleiben, wie die Anzugdatei sie hat.</translation>
    </message>
    <message>
        <source>How each sits on its segment. A turn that no movement shows keeps the sigma that the rest pose leaves it: of hands, feet and head, and of a limb about its own bone.</source>
        <translation>Wie jede auf ihrem Glied sitzt. Eine Drehung, die keine Bewegung zeigt, behält das Sigma, das die Ruhehaltung ihr lässt: bei Händen, Füßen und Kopf und bei einem Glied um den eigenen Knochen.</translation>
    </message>
    <message>
        <source>How far a range is trusted, from 0 to 1</source>
        <translation>Wie weit einer Entfernung getraut wird, von 0 bis 1</translation>
    </message>
    <message>
        <source>How far each board could trust what it heard of each source: strength, continuity and angle, multiplied. Pulses that were not heard count as 0. Dots are single pulses, curves their mean over a second.</source>
        <translation>Wie weit jede Platine dem trauen konnte, was sie von jeder Quelle hörte: Stärke, Stetigkeit und Winkel, multipliziert. Nicht gehörte Pulse zählen als 0. Punkte sind einzelne Pulse, Kurven ihr Mittel über eine Sekunde.</translation>
    </message>
    <message>
        <source>How far each board leans from its place on the performer</source>
        <translation>Wie weit jede Platine von ihrem Sitz am Darsteller abgeneigt ist</translation>
    </message>
    <message>
        <source>How far other results are from the shown one, in degrees</source>
        <translation>Wie weit andere Ergebnisse vom gezeigten abweichen, in Grad</translation>
    </message>
    <message>
        <source>How far the hips wander from the reference after heading and position were made equal in the first compared frame.</source>
        <translation>Wie weit die Hüfte von der Referenz wegwandert, nachdem Richtung und Position im ersten verglichenen Bild gleichgesetzt wurden.</translation>
    </message>
    <message>
        <source>How far the values are apart.</source>
        <translation>Wie weit die Werte auseinanderliegen.</translation>
    </message>
    <message>
        <source>How far values usually lie from their mean</source>
        <translation>Wie weit Werte gewöhnlich von ihrem Mittel entfernt sind</translation>
    </message>
    <message>
        <source>How much later the other one takes each for; 1 µs is a third of a millimetre.</source>
        <translation>Wie viel später die andere jede ansetzt; 1 µs ist ein drittel Millimeter.</translation>
    </message>
    <message>
        <source>How often ranges backed each joint is not known for this result.</source>
        <translation>Wie oft Entfernungen jedes Gelenk stützten, ist für dieses Ergebnis nicht bekannt.</translation>
    </message>
    <message>
        <source>How the performer stood, against the rest pose asked for.</source>
        <translation>Wie der Darsteller stand, verglichen mit der verlangten Ruhehaltung.</translation>
    </message>
    <message>
        <source>ISB</source>
        <translation>ISB</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Inertia alone</source>
        <translation>Trägheit allein</translation>
    </message>
    <message>
        <source>Inertial readings</source>
        <translation>Trägheitsmesswerte</translation>
    </message>
    <message>
        <source>Inertial stream by board</source>
        <translation>Trägheitsdaten je Platine</translation>
    </message>
    <message>
        <source>International Society of Biomechanics, which names the angles of joints</source>
        <translation>Internationale Gesellschaft für Biomechanik, nach der die Gelenkwinkel benannt sind</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>Joint error</source>
        <translation>Gelenkfehler</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Judged by what the angles rest on. Good: ranges back the joints %1 of the time and fit the pose within %2 mm; usable: %3 and %4 mm.</source>
        <translation>Beurteilt danach, worauf die Winkel beruhen. Gut: Entfernungen stützen die Gelenke %1 der Zeit und passen auf %2 mm zur Pose; brauchbar: %3 und %4 mm.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Left arm</source>
        <translation>Linker Arm</translation>
    </message>
    <message>
        <source>Left hip °</source>
        <translation>Linke Hüfte °</translation>
    </message>
    <message>
        <source>Left leg</source>
        <translation>Linkes Bein</translation>
    </message>
    <message>
        <source>LeftFoot</source>
        <translation>LeftFoot</translation>
    </message>
    <message>
        <source>LeftUpLeg</source>
        <translation>LeftUpLeg</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Bein</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Datenart</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>M%1h0</source>
        <translation>M%1h0</translation>
    </message>
    <message>
        <source>M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 4.8v3.9M8 11v.1</source>
        <translation>M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 4.8v3.9M8 11v.1</translation>
    </message>
    <message>
        <source>M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 7.3v4M8 4.8v.1</source>
        <translation>M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 7.3v4M8 4.8v.1</translation>
    </message>
    <message>
        <source>M8 2.2L14.5 13.5H1.5zM8 6.5v3.2M8 11.6v.1</source>
        <translation>M8 2.2L14.5 13.5H1.5zM8 6.5v3.2M8 11.6v.1</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Erstellt</translation>
    </message>
    <message>
        <source>Made by Noctule. %1</source>
        <translation>Mit Noctule erstellt. %1</translation>
    </message>
    <message>
        <source>Made of %1: no gyroscope was used, so the angles are guesses. Process the take with gyroscopes for a result to work with.</source>
        <translation>Gerechnet aus: %1. Kein Gyroskop wurde verwendet, die Winkel sind daher geraten. Verarbeiten Sie die Aufnahme mit Gyroskopen, um mit dem Ergebnis arbeiten zu können.</translation>
    </message>
    <message>
        <source>Magnetometers</source>
        <translation>Magnetometer</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean confidence of every pair</source>
        <translation>Mittlere Konfidenz jedes Paars</translation>
    </message>
    <message>
        <source>Mean joint error over time, results with gyroscopes</source>
        <translation>Mittlerer Gelenkfehler über die Zeit, Ergebnisse mit Gyroskopen</translation>
    </message>
    <message>
        <source>Mean joint error over time, results without gyroscopes</source>
        <translation>Mittlerer Gelenkfehler über die Zeit, Ergebnisse ohne Gyroskope</translation>
    </message>
    <message>
        <source>Mean of all joints</source>
        <translation>Mittel aller Gelenke</translation>
    </message>
    <message>
        <source>Mean over all joints of the angle to the reference, one curve per result</source>
        <translation>Mittel des Winkels zur Referenz über alle Gelenke, eine Kurve je Ergebnis</translation>
    </message>
    <message>
        <source>Mean over the take</source>
        <translation>Mittel über die Aufnahme</translation>
    </message>
    <message>
        <source>Mean, against the worst joint</source>
        <translation>Mittel, gegen das schlech­teste Gelenk</translation>
    </message>
    <message>
        <source>Measured distances over time by what became of them</source>
        <translation>Gemessene Entfernungen über die Zeit, danach, was aus ihnen wurde</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Method that predicts the pose and corrects it with each measurement, weighted by how uncertain both are</source>
        <translation>Verfahren, das die Pose vorhersagt und mit jeder Messung berichtigt, gewichtet danach, wie unsicher beide sind</translation>
    </message>
    <message>
        <source>Model alone</source>
        <translation>Modell allein</translation>
    </message>
    <message>
        <source>Mounting of %1 boards from %2 with %3 and %4</source>
        <translation>Sitz von %1 Platinen aus %2 mit %3 und %4</translation>
    </message>
    <message>
        <source>NEES</source>
        <translation>NEES</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>Neck °</source>
        <translation>Hals °</translation>
    </message>
    <message>
        <source>No joint was backed by ranges.</source>
        <translation>Kein Gelenk wurde von Entfernungen gestützt.</translation>
    </message>
    <message>
        <source>No joint was backed by ranges. %1</source>
        <translation>Kein Gelenk wurde von Entfernungen gestützt. %1</translation>
    </message>
    <message>
        <source>No result of this take has been compared: it has no reference, or was not processed yet.</source>
        <translation>Kein Ergebnis dieser Aufnahme wurde verglichen: sie hat keine Referenz oder ist noch nicht verarbeitet.</translation>
    </message>
    <message>
        <source>No signal for %1 s in one piece: the pose is a guess there.</source>
        <translation>%1 s am Stück ohne Signal: Die Pose ist dort geraten.</translation>
    </message>
    <message>
        <source>Noctule</source>
        <translation>Noctule</translation>
    </message>
    <message>
        <source>None of the magnetometers could be calibrated</source>
        <translation>Keines der Magnetometer konnte kalibriert werden</translation>
    </message>
    <message>
        <source>Not heard</source>
        <translation>Nicht gehört</translation>
    </message>
    <message>
        <source>Not measured where they stand to the others: %1. Too few ranges fit while the rest pose was held. Distances to them mean nothing.</source>
        <translation>Nicht gemessen, wo sie zu den anderen stehen: %1. Während der Ruhehaltung passten zu wenige Entfernungen. Abstände zu ihnen sagen nichts aus.</translation>
    </message>
    <message>
        <source>Not processed yet. The take holds no result to judge.</source>
        <translation>Noch nicht verarbeitet. Die Aufnahme enthält kein Ergebnis zum Beurteilen.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Nothing could be found from %1</source>
        <translation>Nichts ließ sich finden aus: %1</translation>
    </message>
    <message>
        <source>Nothing has moved</source>
        <translation>Nichts ist verrutscht</translation>
    </message>
    <message>
        <source>Nothing measured where the performers stand to each other: no ranges between them or to a room were used. Distances between them mean nothing.</source>
        <translation>Nichts hat gemessen, wie die Darsteller zueinander stehen: Es wurden keine Entfernungen zwischen ihnen oder zu einem Raum verwendet. Abstände zwischen ihnen sagen nichts aus.</translation>
    </message>
    <message>
        <source>Observable</source>
        <translation>Beobachtbar</translation>
    </message>
    <message>
        <source>Offsets</source>
        <translation>Versätze</translation>
    </message>
    <message>
        <source>Offsets of %1 sources; %2</source>
        <translation>Versätze von %1 Quellen; %2</translation>
    </message>
    <message>
        <source>One row per board; gaps are pale</source>
        <translation>Eine Zeile je Platine; Lücken sind blass</translation>
    </message>
    <message>
        <source>One row per source, one column per board; each cell names its figures</source>
        <translation>Eine Zeile je Quelle, eine Spalte je Platine; jede Zelle nennt ihre Zahlen</translation>
    </message>
    <message>
        <source>Orientation differences to the reference by sensors, in degrees</source>
        <translation>Unterschiede der Orientierung zur Referenz nach Sensoren, in Grad</translation>
    </message>
    <message>
        <source>Other joints</source>
        <translation>Andere Gelenke</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Über die Zeit</translation>
    </message>
    <message>
        <source>Performer</source>
        <translation>Darsteller</translation>
    </message>
    <message>
        <source>Place and heading are those of the room's file</source>
        <translation>Ort und Richtung sind die der Raumdatei</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position mm</source>
        <translation>Position mm</translation>
    </message>
    <message>
        <source>Position, root mean square</source>
        <translation>Position, quadratisches Mittel</translation>
    </message>
    <message>
        <source>Process the take, then evaluate it again.</source>
        <translation>Die Aufnahme verarbeiten, dann erneut auswerten.</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>Pulse</translation>
    </message>
    <message>
        <source>Pulses by board</source>
        <translation>Pulse nach Platine</translation>
    </message>
    <message>
        <source>Pulses by source</source>
        <translation>Pulse nach Quelle</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>Entfernungen</translation>
    </message>
    <message>
        <source>Ranges backed the joints only %1 of the time. %2</source>
        <translation>Entfernungen stützten die Gelenke nur %1 der Zeit. %2</translation>
    </message>
    <message>
        <source>Readings present</source>
        <translation>Vor­handene Messwerte</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Reference time added</source>
        <translation>Zur Referenzzeit addiert</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Ver­worfen</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Residual mm</source>
        <translation>Rest­fehler mm</translation>
    </message>
    <message>
        <source>Rest at its start</source>
        <translation>Ruhe am Anfang</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Result %1</source>
        <translation>Ergebnis %1</translation>
    </message>
    <message>
        <source>Result %1: sensors %2, estimator %3, smoothing %4, root %5.</source>
        <translation>Ergebnis %1: Sensoren %2, Schätzer %3, Glättung %4, Wurzel %5.</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Right arm</source>
        <translation>Rechter Arm</translation>
    </message>
    <message>
        <source>Right leg</source>
        <translation>Rechtes Bein</translation>
    </message>
    <message>
        <source>Right shoulder °</source>
        <translation>Rechte Schulter °</translation>
    </message>
    <message>
        <source>RightArm</source>
        <translation>RightArm</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Wurzel</translation>
    </message>
    <message>
        <source>Root mean square (RMS)</source>
        <translation>Quadratisches Mittel (RMS)</translation>
    </message>
    <message>
        <source>SD is the standard deviation, RMS the root mean square. Half of the time a joint errs less than its median, 95 % of the time less than the value so headed. NEES compares the errors with what the filter says about them: 1 is honest, more is too sure. Position is that of the joint in the frame of the pelvis, so it gathers the errors of all joints above.</source>
        <translation>SD ist die Standardabweichung, RMS das quadratische Mittel. Die Hälfte der Zeit irrt ein Gelenk um weniger als seinen Median, 95 % der Zeit um weniger als den Wert dieser Überschrift. NEES vergleicht die Fehler mit dem, was der Filter über sie sagt: 1 ist ehrlich, mehr ist zu sicher. Position ist die des Gelenks im Bezugssystem des Beckens, sammelt also die Fehler aller Gelenke darüber.</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>Sensor unit on a limb, with accelerometer, gyroscope and microphone</source>
        <translation>Messeinheit an einem Glied, mit Beschleunigungssensor, Gyroskop und Mikrofon</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Sensors A, G and D</source>
        <translation>Sensoren A, G und D</translation>
    </message>
    <message>
        <source>Sensors and results</source>
        <translation>Sensoren und Ergebnisse</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Settings, calibration and versions</source>
        <translation>Einstellungen, Kalibrierung und Versionen</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Share of frames</source>
        <translation>Anteil der Bilder</translation>
    </message>
    <message>
        <source>Shares</source>
        <translation>Anteile</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>Sigma is that against the other anchors, along the worst axis.</source>
        <translation>Sigma gilt gegen die anderen Anker, entlang der schlechtesten Achse.</translation>
    </message>
    <message>
        <source>Small ultrasonic loudspeaker on the body that sends short pulses</source>
        <translation>Kleiner Ultraschall-Lautsprecher am Körper, der kurze Pulse sendet</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Source offsets</source>
        <translation>Quellenversatz</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Sources in use by board over time</source>
        <translation>Verwendete Quellen je Platine über der Zeit</translation>
    </message>
    <message>
        <source>Sources in use, by board over time</source>
        <translation>Verwendete Quellen, nach Platine über die Zeit</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>Wirbelsäule</translation>
    </message>
    <message>
        <source>Squared errors over what the filter expects of them: 1 is honest, more is too sure</source>
        <translation>Quadrierte Fehler im Verhältnis zu dem, was der Filter von ihnen erwartet: 1 ist ehrlich, mehr ist zu sicher</translation>
    </message>
    <message>
        <source>Standard deviation (SD)</source>
        <translation>Standardabweichung (SD)</translation>
    </message>
    <message>
        <source>Standard deviations are those that the recording itself implies.</source>
        <translation>Standardabweichungen sind die, die aus der Aufzeichnung selbst folgen.</translation>
    </message>
    <message>
        <source>Standard deviations of the worst axis. Good: zeros within 0.02 °/s, slopes within 0.03 %.</source>
        <translation>Standardabweichungen der schlechtesten Achse. Gut: Nullpunkte auf 0,02 °/s, Steigungen auf 0,03 %.</translation>
    </message>
    <message>
        <source>Standard deviations of the worst axis. Good: zeros within 2 mg, slopes within 0.04 %.</source>
        <translation>Standardabweichungen der schlechtesten Achse. Gut: Nullpunkte auf 2 mg, Steigungen auf 0,04 %.</translation>
    </message>
    <message>
        <source>Still check</source>
        <translation>Kontrolle im Stehen</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>Zusammenfassung</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Take report</source>
        <translation>Bericht zur Aufnahme</translation>
    </message>
    <message>
        <source>The angle between a joint's two orientations, in the mean and below what it is for 95 % of the time. The shown result is %1. Which of two results is right only a reference tells.</source>
        <translation>Der Winkel zwischen den beiden Orientierungen eines Gelenks, im Mittel und der Wert, unter dem er 95 % der Zeit liegt. Das gezeigte Ergebnis ist %1. Welches von zwei Ergebnissen stimmt, sagt nur eine Referenz.</translation>
    </message>
    <message>
        <source>The calibration no longer holds</source>
        <translation>Die Kalibrierung gilt nicht mehr</translation>
    </message>
    <message>
        <source>The clocks of take and reference were not aligned: the reference's motion %1. Check that the reference shows this take.</source>
        <translation>Die Uhren von Aufnahme und Referenz wurden nicht angeglichen: die Bewegung der Referenz %1. Prüfen, ob die Referenz diese Aufnahme zeigt.</translation>
    </message>
    <message>
        <source>The filter is too sure of itself: its errors are %1 times as large as it says (NEES %2 instead of 1).</source>
        <translation>Der Filter ist sich zu sicher: seine Fehler sind %1-mal so groß, wie er sagt (NEES %2 statt 1).</translation>
    </message>
    <message>
        <source>The filter rejected %1 of the ranges it tried: a wrong source offset, a board out of place or a pose that has been lost.</source>
        <translation>Der Filter verwarf %1 der Entfernungen, die er prüfte: ein falscher Quellenversatz, eine verrutschte Platine oder eine verlorene Pose.</translation>
    </message>
    <message>
        <source>The method that makes poses of readings and ranges: Noctule (manifold) is this program's own, Vlasic 2007 (paper) is that of a publication</source>
        <translation>Das Verfahren, das aus Messwerten und Entfernungen Posen macht: Noctule (manifold) ist das eigene dieses Programms, Vlasic 2007 (paper) das einer Veröffentlichung</translation>
    </message>
    <message>
        <source>The origin is where %1 stood in the rest pose, facing +z; level to %2°, floor to %3 mm</source>
        <translation>Der Ursprung ist, wo %1 in der Ruhehaltung stand, mit Blick nach +z; waagrecht auf %2°, Boden auf %3 mm</translation>
    </message>
    <message>
        <source>The paper's rows are its Table 1: another motion, performer and suit, 30 s against an optical system. They are a scale to read ours by and no contest. Its neck is our head joint.</source>
        <translation>Die Zeilen der Veröffentlichung sind ihre Tabelle 1: andere Bewegung, anderer Darsteller und Anzug, 30 s gegen ein optisches System. Sie sind ein Maßstab, um unsere zu lesen, und kein Wettstreit. Ihr Hals ist unser Kopfgelenk.</translation>
    </message>
    <message>
        <source>The pelvis, which carries the body: free is estimated, given is measured by another system</source>
        <translation>Das Becken, das den Körper trägt: frei heißt geschätzt, gegeben heißt von einem anderen System gemessen</translation>
    </message>
    <message>
        <source>The reference has errors of its own, which are contained in every error of this report.</source>
        <translation>Die Referenz hat eigene Fehler, die in jedem Fehler dieses Berichts enthalten sind.</translation>
    </message>
    <message>
        <source>The reference is the simulation's own truth: errors contain what the simulation models and nothing that it leaves out.</source>
        <translation>Die Referenz ist die Wahrheit der Simulation selbst: Fehler enthalten, was die Simulation nachbildet, und nichts, was sie auslässt.</translation>
    </message>
    <message>
        <source>The root came from another system; this report says nothing about how well the suit alone would know it.</source>
        <translation>Die Wurzel kam von einem anderen System; dieser Bericht sagt nichts darüber, wie gut der Anzug allein sie kennen würde.</translation>
    </message>
    <message>
        <source>The same motion as another system or a simulation knows it</source>
        <translation>Dieselbe Bewegung, wie ein anderes System oder eine Simulation sie kennt</translation>
    </message>
    <message>
        <source>The shown result used no gyroscopes: rotation between two ranges or readings is a guess of the model.</source>
        <translation>Das gezeigte Ergebnis verwendete keine Gyroskope: die Drehung zwischen zwei Entfernungen oder Messwerten ist eine Vermutung des Modells.</translation>
    </message>
    <message>
        <source>The shown result used no ranges: every joint rested on inertia alone and nothing held the angles between segments over long times.</source>
        <translation>Das gezeigte Ergebnis verwendete keine Entfernungen: jedes Gelenk beruhte allein auf Trägheit, und nichts hielt die Winkel zwischen Gliedern über lange Zeit.</translation>
    </message>
    <message>
        <source>The suit has no sources. How far its joints drift is not known without a reference.</source>
        <translation>Der Anzug hat keine Quellen. Wie weit seine Gelenke driften, ist ohne Referenz nicht bekannt.</translation>
    </message>
    <message>
        <source>The take describes no boards.</source>
        <translation>Die Aufnahme beschreibt keine Platinen.</translation>
    </message>
    <message>
        <source>The take holds no pulses, so there is no confidence to show.</source>
        <translation>Die Aufnahme enthält keine Pulse, also gibt es keine Konfidenz zu zeigen.</translation>
    </message>
    <message>
        <source>The take holds no ranges.</source>
        <translation>Die Aufnahme enthält keine Entfernungen.</translation>
    </message>
    <message>
        <source>Three turns about axes, one after the other, that make up a rotation</source>
        <translation>Drei Drehungen um Achsen nacheinander, die zusammen eine Rotation ergeben</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Tilt of each board against the calibration</source>
        <translation>Neigung jeder Platine gegen die Kalibrierung</translation>
    </message>
    <message>
        <source>Tilt of the root is held by gravity in the accelerometers.</source>
        <translation>Die Neigung der Wurzel hält die Schwerkraft in den Beschleunigungssensoren.</translation>
    </message>
    <message>
        <source>Tilt, root mean square</source>
        <translation>Neigung, quadratisches Mittel</translation>
    </message>
    <message>
        <source>ToeBase</source>
        <translation>ToeBase</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Rumpf</translation>
    </message>
    <message>
        <source>Trunk and head</source>
        <translation>Rumpf und Kopf</translation>
    </message>
    <message>
        <source>Unused</source>
        <translation>Ungenutzt</translation>
    </message>
    <message>
        <source>UpLeg</source>
        <translation>UpLeg</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Ver­wendet</translation>
    </message>
    <message>
        <source>Usual size of an error, large ones counting more</source>
        <translation>Übliche Größe eines Fehlers, wobei große mehr zählen</translation>
    </message>
    <message>
        <source>Vlasic 2007</source>
        <translation>Vlasic 2007</translation>
    </message>
    <message>
        <source>What became of every pulse at every board: heard or not, used by the filter or thrown out because it did not fit the pose.</source>
        <translation>Was aus jedem Puls an jeder Platine wurde: gehört oder nicht, vom Filter verwendet oder verworfen, weil er nicht zur Pose passte.</translation>
    </message>
    <message>
        <source>What each board's stream delivered. A lost frame silences its axes until their next absolute value; a clipped reading lies at the end of its range and is never used.</source>
        <translation>Was der Datenstrom jeder Platine lieferte. Ein verlorener Rahmen lässt seine Achsen bis zu ihrem nächsten absoluten Wert verstummen; ein übersteuerter Messwert liegt am Ende seines Bereichs und wird nie verwendet.</translation>
    </message>
    <message>
        <source>What each joint rested on</source>
        <translation>Worauf jedes Gelenk beruhte</translation>
    </message>
    <message>
        <source>What is left over of each board's distances</source>
        <translation>Was von den Entfernungen jeder Platine übrig bleibt</translation>
    </message>
    <message>
        <source>What one processing of the take with its own settings has made</source>
        <translation>Was eine Verarbeitung der Aufnahme mit eigenen Einstellungen ergeben hat</translation>
    </message>
    <message>
        <source>What the technical words mean.</source>
        <translation>Was die Fachwörter bedeuten.</translation>
    </message>
    <message>
        <source>What was observable</source>
        <translation>Was beobachtbar war</translation>
    </message>
    <message>
        <source>Where each sits on its segment, and what its distances are too long by.</source>
        <translation>Wo jede auf ihrem Glied sitzt und um wie viel ihre Entfernungen zu lang sind.</translation>
    </message>
    <message>
        <source>Whether a pose also uses later readings: none, lag (half a second), full (the whole take) or batch (the whole take, solved anew)</source>
        <translation>Ob eine Pose auch spätere Messwerte nutzt: keine, Nachlauf (lag, eine halbe Sekunde), voll (full, die ganze Aufnahme) oder batch (die ganze Aufnahme, neu gelöst)</translation>
    </message>
    <message>
        <source>Without a reference the drift is not known.</source>
        <translation>Ohne Referenz ist die Drift nicht bekannt.</translation>
    </message>
    <message>
        <source>Without a reference the joints cannot be scored.</source>
        <translation>Ohne Referenz lassen sich die Gelenke nicht bewerten.</translation>
    </message>
    <message>
        <source>Without accelerometers nothing holds the tilt of the root.</source>
        <translation>Ohne Beschleunigungssensoren hält nichts die Neigung der Wurzel.</translation>
    </message>
    <message>
        <source>Without ranges a joint follows its gyroscope, which drifts by 1 to 3° a minute.</source>
        <translation>Ohne Entfernungen folgt ein Gelenk seinem Gyroskop, das um 1 bis 3° je Minute driftet.</translation>
    </message>
    <message>
        <source>Words of this report</source>
        <translation>Wörter dieses Berichts</translation>
    </message>
    <message>
        <source>Written by</source>
        <translation>Geschrieben von</translation>
    </message>
    <message>
        <source>a distance is right within %1 mm in the mean</source>
        <translation>eine Entfernung stimmt im Mittel auf %1 mm</translation>
    </message>
    <message>
        <source>accelerometer's zero, mg</source>
        <translation>Nullpunkt des Beschleunigungssensors, mg</translation>
    </message>
    <message>
        <source>accelerometers alone</source>
        <translation>nur Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>accelerometers and distances</source>
        <translation>Beschleunigungssensoren und Entfernungen</translation>
    </message>
    <message>
        <source>accelerometers and gyroscopes</source>
        <translation>Beschleunigungssensoren und Gyroskope</translation>
    </message>
    <message>
        <source>accelerometers, gyroscopes and distances</source>
        <translation>Beschleunigungssensoren, Gyroskope und Entfernungen</translation>
    </message>
    <message>
        <source>agreement of the distances, median</source>
        <translation>Übereinstimmung der Abstände, Median</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>at least %1 %</source>
        <translation>mindestens %1 %</translation>
    </message>
    <message>
        <source>at least 1</source>
        <translation>mindestens 1</translation>
    </message>
    <message>
        <source>axes seen</source>
        <translation>gesehene Achsen</translation>
    </message>
    <message>
        <source>backed by ranges</source>
        <translation>von Entfernungen gestützt</translation>
    </message>
    <message>
        <source>bending to the right</source>
        <translation>Neigung nach rechts</translation>
    </message>
    <message>
        <source>between %1 and %2 µT</source>
        <translation>zwischen %1 und %2 µT</translation>
    </message>
    <message>
        <source>boards heard</source>
        <translation>gehörte Platinen</translation>
    </message>
    <message>
        <source>by inertia alone</source>
        <translation>von Trägheit allein</translation>
    </message>
    <message>
        <source>by the model alone</source>
        <translation>vom Modell allein</translation>
    </message>
    <message>
        <source>change before, %</source>
        <translation>Änderung vorher, %</translation>
    </message>
    <message>
        <source>change now, %</source>
        <translation>Änderung jetzt, %</translation>
    </message>
    <message>
        <source>change of the speed of sound</source>
        <translation>Änderung der Schallgeschwindigkeit</translation>
    </message>
    <message>
        <source>class="word"</source>
        <translation>class="word"</translation>
    </message>
    <message>
        <source>deviation, mm</source>
        <translation>Abweichung, mm</translation>
    </message>
    <message>
        <source>directions of 100</source>
        <translation>Richtungen von 100</translation>
    </message>
    <message>
        <source>distances alone</source>
        <translation>nur Entfernungen</translation>
    </message>
    <message>
        <source>distances heard</source>
        <translation>gehörte Entfernungen</translation>
    </message>
    <message>
        <source>distances, mm</source>
        <translation>Entfernungen, mm</translation>
    </message>
    <message>
        <source>dot faint</source>
        <translation>dot faint</translation>
    </message>
    <message>
        <source>dot rejected</source>
        <translation>dot rejected</translation>
    </message>
    <message>
        <source>dot unused</source>
        <translation>dot unused</translation>
    </message>
    <message>
        <source>error of a distance left out, mean</source>
        <translation>Fehler einer ausgelassenen Entfernung, Mittel</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>Schätzung</translation>
    </message>
    <message>
        <source>estimate with 2 sigma</source>
        <translation>Schätzung mit 2 Sigma</translation>
    </message>
    <message>
        <source>extended Kalman filter</source>
        <translation>erweiterter Kalman-Filter</translation>
    </message>
    <message>
        <source>external rotation</source>
        <translation>Außendrehung</translation>
    </message>
    <message>
        <source>field's strength, µT</source>
        <translation>Feldstärke, µT</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>forward rotation</source>
        <translation>Vorwärtsdrehung</translation>
    </message>
    <message>
        <source>four and more</source>
        <translation>vier und mehr</translation>
    </message>
    <message>
        <source>freedoms of the whole room that were measured</source>
        <translation>Freiheitsgrade des ganzen Raums, die gemessen wurden</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>from, to</source>
        <translation>von, nach</translation>
    </message>
    <message>
        <source>given by another system</source>
        <translation>von einem anderen System gegeben</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>gyroscope's zero, counts</source>
        <translation>Gyroskop, Zählwerte</translation>
    </message>
    <message>
        <source>gyroscope's zero, °/s</source>
        <translation>Nullpunkt des Gyroskops, °/s</translation>
    </message>
    <message>
        <source>gyroscopes alone</source>
        <translation>nur Gyroskope</translation>
    </message>
    <message>
        <source>gyroscopes and distances</source>
        <translation>Gyroskope und Entfernungen</translation>
    </message>
    <message>
        <source>hands, feet and head, mean position error in the frame of the pelvis</source>
        <translation>Hände, Füße und Kopf, mittlerer Positionsfehler im Bezugssystem des Beckens</translation>
    </message>
    <message>
        <source>heading, sigma, °</source>
        <translation>Richtung, Sigma, °</translation>
    </message>
    <message>
        <source>heard but unused</source>
        <translation>gehört, aber nicht verwendet</translation>
    </message>
    <message>
        <source>height, m</source>
        <translation>Höhe, m</translation>
    </message>
    <message>
        <source>hidden by the body</source>
        <translation>vom Körper verdeckt</translation>
    </message>
    <message>
        <source>horizontal extension</source>
        <translation>horizontale Streckung</translation>
    </message>
    <message>
        <source>horizontal flexion</source>
        <translation>horizontale Beugung</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>internal rotation</source>
        <translation>Innendrehung</translation>
    </message>
    <message>
        <source>its deviation</source>
        <translation>seine Abweichung</translation>
    </message>
    <message>
        <source>its slopes, %</source>
        <translation>seine Steigungen, %</translation>
    </message>
    <message>
        <source>joint at the lower end</source>
        <translation>Gelenk am unteren Ende</translation>
    </message>
    <message>
        <source>joint is</source>
        <translation>Gelenk liegt</translation>
    </message>
    <message>
        <source>joints are</source>
        <translation>Gelenke liegen</translation>
    </message>
    <message>
        <source>leans, °</source>
        <translation>geneigt, °</translation>
    </message>
    <message>
        <source>leg</source>
        <translation>Bein</translation>
    </message>
    <message>
        <source>magnetometer's zero, µT</source>
        <translation>Nullpunkt des Magnetometers, µT</translation>
    </message>
    <message>
        <source>mean joint error against the reference</source>
        <translation>mittlerer Gelenkfehler gegen die Referenz</translation>
    </message>
    <message>
        <source>mean, mm</source>
        <translation>Mittel, mm</translation>
    </message>
    <message>
        <source>measured, m</source>
        <translation>gemessen, m</translation>
    </message>
    <message>
        <source>mounting, °</source>
        <translation>Sitz, °</translation>
    </message>
    <message>
        <source>no distance could be judged</source>
        <translation>keine Entfernung ließ sich beurteilen</translation>
    </message>
    <message>
        <source>no distances to compare</source>
        <translation>keine Entfernungen zum Vergleichen</translation>
    </message>
    <message>
        <source>no pulses recorded</source>
        <translation>keine Pulse aufgenommen</translation>
    </message>
    <message>
        <source>no residual</source>
        <translation>kein Restfehler</translation>
    </message>
    <message>
        <source>no source</source>
        <translation>keine Quelle</translation>
    </message>
    <message>
        <source>not heard</source>
        <translation>nicht gehört</translation>
    </message>
    <message>
        <source>not heard, though in sight</source>
        <translation>nicht gehört, obwohl in Sicht</translation>
    </message>
    <message>
        <source>of all directions, the sensor that has seen least</source>
        <translation>aller Richtungen, der Sensor mit den wenigsten</translation>
    </message>
    <message>
        <source>of frames backed by ranges, mean over joints</source>
        <translation>der Bilder von Entfernungen gestützt, Mittel über die Gelenke</translation>
    </message>
    <message>
        <source>off, °</source>
        <translation>daneben, °</translation>
    </message>
    <message>
        <source>offset known to, worst source</source>
        <translation>Versatz bekannt auf, schlechteste Quelle</translation>
    </message>
    <message>
        <source>offset, µs</source>
        <translation>Versatz, µs</translation>
    </message>
    <message>
        <source>performer</source>
        <translation>Darsteller</translation>
    </message>
    <message>
        <source>place, mm</source>
        <translation>Ort, mm</translation>
    </message>
    <message>
        <source>place, sigma, mm</source>
        <translation>Ort, Sigma, mm</translation>
    </message>
    <message>
        <source>radial deviation</source>
        <translation>Radialabduktion</translation>
    </message>
    <message>
        <source>range residual, median of the ranges used</source>
        <translation>Restfehler der Entfernungen, Median der verwendeten</translation>
    </message>
    <message>
        <source>ranges %1, inertia alone %2</source>
        <translation>Entfernungen %1, Trägheit allein %2</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>rejected by the gate</source>
        <translation>vom Filter verworfen</translation>
    </message>
    <message>
        <source>residual %1 mm</source>
        <translation>Restfehler %1 mm</translation>
    </message>
    <message>
        <source>residual rms, mm</source>
        <translation>Restfehler RMS, mm</translation>
    </message>
    <message>
        <source>rest pose</source>
        <translation>Ruhehaltung</translation>
    </message>
    <message>
        <source>rest poses</source>
        <translation>Ruhehaltungen</translation>
    </message>
    <message>
        <source>scale known to, worst axis</source>
        <translation>Maßstab bekannt auf, schlechteste Achse</translation>
    </message>
    <message>
        <source>scope="row"</source>
        <translation>scope="row"</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>sigma about x y z, °</source>
        <translation>Sigma um x y z, °</translation>
    </message>
    <message>
        <source>sigma of headings, which are the suit file's</source>
        <translation>Sigma der Richtungen, die aus der Anzugdatei sind</translation>
    </message>
    <message>
        <source>sigma of the turns that the movement shows</source>
        <translation>Sigma der Drehungen, die die Bewegung zeigt</translation>
    </message>
    <message>
        <source>sigma of the weakest anchor</source>
        <translation>Sigma des schwächsten Ankers</translation>
    </message>
    <message>
        <source>sigma, mm</source>
        <translation>Sigma, mm</translation>
    </message>
    <message>
        <source>sigma, °</source>
        <translation>Sigma, °</translation>
    </message>
    <message>
        <source>source %1%2</source>
        <translation>Quelle %1%2</translation>
    </message>
    <message>
        <source>standard deviation of the field's strength over the directions, worst sensor</source>
        <translation>Standardabweichung der Feldstärke über die Richtungen, schlechtester Sensor</translation>
    </message>
    <message>
        <source>strength of the field, mean</source>
        <translation>Stärke des Feldes, Mittel</translation>
    </message>
    <message>
        <source>surveyed, m</source>
        <translation>vermessen, m</translation>
    </message>
    <message>
        <source>the %1 reference</source>
        <translation>die Referenz von %1</translation>
    </message>
    <message>
        <source>the board that has tilted most</source>
        <translation>die am stärksten gekippte Platine</translation>
    </message>
    <message>
        <source>the board that leans most</source>
        <translation>die am stärksten geneigte Platine</translation>
    </message>
    <message>
        <source>the largest change of distances</source>
        <translation>die größte Änderung der Entfernungen</translation>
    </message>
    <message>
        <source>the paper</source>
        <translation>die Veröffentlichung</translation>
    </message>
    <message>
        <source>the same, rms without echoes</source>
        <translation>dasselbe, quadratisches Mittel ohne Echos</translation>
    </message>
    <message>
        <source>the simulated truth</source>
        <translation>die simulierte Wahrheit</translation>
    </message>
    <message>
        <source>the table, measured by the accelerometers</source>
        <translation>der Drehteller, gemessen von den Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>the table, nominal</source>
        <translation>der Drehteller, Nennwert</translation>
    </message>
    <message>
        <source>tick end</source>
        <translation>tick end</translation>
    </message>
    <message>
        <source>tick mid</source>
        <translation>tick mid</translation>
    </message>
    <message>
        <source>tilt, °</source>
        <translation>Neigung, °</translation>
    </message>
    <message>
        <source>tissue, °</source>
        <translation>Gewebe, °</translation>
    </message>
    <message>
        <source>too long, mm</source>
        <translation>zu lang, mm</translation>
    </message>
    <message>
        <source>turn to the left</source>
        <translation>Drehung nach links</translation>
    </message>
    <message>
        <source>turned, °</source>
        <translation>gedreht, °</translation>
    </message>
    <message>
        <source>turns and rests</source>
        <translation>Drehungen und Ruhe</translation>
    </message>
    <message>
        <source>turns shown</source>
        <translation>gezeigte Drehungen</translation>
    </message>
    <message>
        <source>ulnar deviation</source>
        <translation>Ulnarabduktion</translation>
    </message>
    <message>
        <source>uncertainty of the vertical, worst board</source>
        <translation>Unsicherheit der Senkrechten, schlechteste Platine</translation>
    </message>
    <message>
        <source>under %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>under %1 %</source>
        <translation>unter %1 %</translation>
    </message>
    <message>
        <source>under %1 mm</source>
        <translation>unter %1 mm</translation>
    </message>
    <message>
        <source>under %1 µT</source>
        <translation>unter %1 µT</translation>
    </message>
    <message>
        <source>with outliers</source>
        <translation>mit Ausreißern</translation>
    </message>
    <message>
        <source>worst deviation from g, m/s²</source>
        <translation>größte Abweichung von g, m/s²</translation>
    </message>
    <message>
        <source>worst, mm</source>
        <translation>größter, mm</translation>
    </message>
    <message>
        <source>zero known to, worst axis</source>
        <translation>Nullpunkt bekannt auf, schlechteste Achse</translation>
    </message>
    <message>
        <source>zero known to, worst sensor</source>
        <translation>Nullpunkt bekannt auf, schlechtester Sensor</translation>
    </message>
    <message>
        <source>zero, sigma, µT</source>
        <translation>Nullpunkt, Sigma, µT</translation>
    </message>
    <message>
        <source>σ of slope, %</source>
        <translation>σ der Steigung, %</translation>
    </message>
    <message>
        <source>σ of zero, mg</source>
        <translation>σ des Nullpunkts, mg</translation>
    </message>
    <message>
        <source>σ of zero, °/s</source>
        <translation>σ des Nullpunkts, °/s</translation>
    </message>
</context>
<context>
    <name>core/review</name>
    <message>
        <source>%1: an overview of the sound needs a column</source>
        <translation>%1: eine Übersicht des Tons braucht eine Spalte</translation>
    </message>
    <message>
        <source>%1: has no board %2</source>
        <translation>%1: hat keine Platine %2</translation>
    </message>
    <message>
        <source>%1: holds no sound</source>
        <translation>%1: enthält keinen Ton</translation>
    </message>
    <message>
        <source>%1: holds readings, not sound</source>
        <translation>%1: enthält Messwerte, keinen Ton</translation>
    </message>
    <message>
        <source>%1: sound can be shown for 10 s at most</source>
        <translation>%1: Ton lässt sich für höchstens 10 s zeigen</translation>
    </message>
    <message>
        <source>: holds no reference</source>
        <translation>: enthält keine Referenz</translation>
    </message>
    <message>
        <source>: the result %1 holds no poses</source>
        <translation>: Ergebnis %1 enthält keine Posen</translation>
    </message>
    <message>
        <source>Attach a reference first</source>
        <translation>Zuerst eine Referenz anhängen</translation>
    </message>
    <message>
        <source>Choose a take that was recorded with it</source>
        <translation>Eine Aufnahme wählen, die mit Ton aufgenommen wurde</translation>
    </message>
    <message>
        <source>Choose one of its %1 boards</source>
        <translation>Eine ihrer %1 Platinen wählen</translation>
    </message>
    <message>
        <source>Loading ranges</source>
        <translation>Entfernungen werden geladen</translation>
    </message>
    <message>
        <source>Loading readings</source>
        <translation>Messwerte werden geladen</translation>
    </message>
    <message>
        <source>Look at its ranges and readings instead</source>
        <translation>Stattdessen ihre Entfernungen und Messwerte ansehen</translation>
    </message>
    <message>
        <source>Process the take again</source>
        <translation>Aufnahme neu verarbeiten</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>Der Ton wird gelesen</translation>
    </message>
    <message>
        <source>The take lacks a part: %1.</source>
        <translation>Der Aufnahme fehlt ein Teil: %1.</translation>
    </message>
    <message>
        <source>Widen the plot</source>
        <translation>Das Diagramm breiter machen</translation>
    </message>
    <message>
        <source>Zoom in on a shorter time</source>
        <translation>Auf eine kürzere Zeit vergrößern</translation>
    </message>
</context>
<context>
    <name>core/robot</name>
    <message>
        <source>%1 is floating or planar, or of no known type</source>
        <translation>%1 ist floating oder planar oder von unbekanntem Typ</translation>
    </message>
    <message>
        <source>%1 joints move between "%2" and "%3"</source>
        <translation>%1 Gelenke bewegen sich zwischen „%2“ und „%3“</translation>
    </message>
    <message>
        <source>%1 would come too near; the arms brake. Move them apart.</source>
        <translation>%1 kämen sich zu nah; die Arme bremsen. Die Arme auseinandernehmen.</translation>
    </message>
    <message>
        <source>%1: is no usable URDF%2</source>
        <translation>%1: ist keine brauchbare URDF-Datei%2</translation>
    </message>
    <message>
        <source>%1: its shoulders and hips stand in one line</source>
        <translation>%1: Schultern und Hüften liegen auf einer Linie</translation>
    </message>
    <message>
        <source>%1: no bone is known as %2%3</source>
        <translation>%1: kein Knochen ist als %2%3 bekannt</translation>
    </message>
    <message>
        <source>%1: the arm on the %2 has a bone without length</source>
        <translation>%1: der Arm auf der Seite %2 hat einen Knochen ohne Länge</translation>
    </message>
    <message>
        <source>Apart at one instant, rms</source>
        <translation>Abstand zum selben Zeitpunkt, RMS</translation>
    </message>
    <message>
        <source>Choose a chain of 1 to %1 moving joints</source>
        <translation>Eine Kette mit 1 bis %1 beweglichen Gelenken wählen</translation>
    </message>
    <message>
        <source>Choose a chain of joints that are driven</source>
        <translation>Eine Kette aus angetriebenen Gelenken wählen</translation>
    </message>
    <message>
        <source>Choose another motion</source>
        <translation>Eine andere Bewegung wählen</translation>
    </message>
    <message>
        <source>Choose another with --arms</source>
        <translation>Einen anderen mit --arms wählen</translation>
    </message>
    <message>
        <source>Choose the robot's .urdf file</source>
        <translation>Die .urdf-Datei des Roboters wählen</translation>
    </message>
    <message>
        <source>Correct its mimic element</source>
        <translation>Sein Element mimic berichtigen</translation>
    </message>
    <message>
        <source>Correct its origin</source>
        <translation>Den Ursprung berichtigen</translation>
    </message>
    <message>
        <source>Correct the joint or add the link</source>
        <translation>Das Gelenk berichtigen oder den Link hinzufügen</translation>
    </message>
    <message>
        <source>Correct the profile, or leave it out to have one made</source>
        <translation>Das Profil berichtigen oder weglassen, damit eines erstellt wird</translation>
    </message>
    <message>
        <source>Dashed: %1. Line: %2. Axes of the chest: X to the left, Y up, Z ahead. A division is 100 mm.</source>
        <translation>Gestrichelt: %1. Linie: %2. Achsen der Brust: X nach links, Y nach oben, Z nach vorn. Ein Teilstrich ist 100 mm.</translation>
    </message>
    <message>
        <source>Drive its arms alone, or name the joints in the profile</source>
        <translation>Steuern Sie nur die Arme, oder nennen Sie die Gelenke im Profil</translation>
    </message>
    <message>
        <source>Exchange the two</source>
        <translation>Die beiden vertauschen</translation>
    </message>
    <message>
        <source>Give a profile that names the joints (core/robot/README.md)</source>
        <translation>Ein Profil angeben, das die Gelenke nennt (core/robot/README.md)</translation>
    </message>
    <message>
        <source>Give every part a name</source>
        <translation>Jedem Teil einen Namen geben</translation>
    </message>
    <message>
        <source>Give it an axis such as 0 0 1</source>
        <translation>Eine Achse wie 0 0 1 angeben</translation>
    </message>
    <message>
        <source>Joint %1 is %2 from its command. Commands go back to where the robot is; check the joint, then engage again.</source>
        <translation>Gelenk %1 ist %2 von seinem Befehl entfernt. Die Befehle gehen dorthin zurück, wo der Roboter ist; das Gelenk prüfen, dann erneut einkuppeln.</translation>
    </message>
    <message>
        <source>Joint %1 is %2 from the performer; bring the arm nearer to the robot's posture.</source>
        <translation>Gelenk %1 ist %2 vom Darsteller entfernt; den Arm näher an die Haltung des Roboters bringen.</translation>
    </message>
    <message>
        <source>Leave --legs out, or describe them in the profile</source>
        <translation>Lassen Sie --legs weg, oder beschreiben Sie sie im Profil</translation>
    </message>
    <message>
        <source>Leave --legs out, or take a motion of a whole body</source>
        <translation>Lassen Sie --legs weg, oder nehmen Sie eine Bewegung eines ganzen Körpers</translation>
    </message>
    <message>
        <source>Let it mimic the joint that leads</source>
        <translation>Es das führende Gelenk nachahmen lassen</translation>
    </message>
    <message>
        <source>Let the base of both arms lie above what they share, or choose one with --arms</source>
        <translation>Die Basis beider Arme über das legen, was sie teilen, oder einen mit --arms wählen</translation>
    </message>
    <message>
        <source>Let the motion begin and end in about one posture, and at rest</source>
        <translation>Die Bewegung in etwa gleicher Haltung und in Ruhe beginnen und enden lassen</translation>
    </message>
    <message>
        <source>Name a base nearer to the root</source>
        <translation>Eine Basis näher an der Wurzel nennen</translation>
    </message>
    <message>
        <source>Name a link of the URDF</source>
        <translation>Einen Link der URDF-Datei nennen</translation>
    </message>
    <message>
        <source>No fresh pose of the performer; the robot holds. Check the suit.</source>
        <translation>Keine frische Pose des Darstellers; der Roboter hält. Den Anzug prüfen.</translation>
    </message>
    <message>
        <source>Open the loop at one of the two; only trees of links can be followed</source>
        <translation>Die Schleife an einem von beiden öffnen; nur Bäume von Links werden unterstützt</translation>
    </message>
    <message>
        <source>Open the loop; only trees of links can be followed</source>
        <translation>Die Schleife öffnen; nur Bäume von Links werden unterstützt</translation>
    </message>
    <message>
        <source>Points compared</source>
        <translation>Verglichene Punkte</translation>
    </message>
    <message>
        <source>Rename or remove one of them</source>
        <translation>Eines davon umbenennen oder entfernen</translation>
    </message>
    <message>
        <source>Rest after the delay, largest</source>
        <translation>Rest nach der Verzögerung, größter</translation>
    </message>
    <message>
        <source>Rest after the delay, rms</source>
        <translation>Rest nach der Verzögerung, RMS</translation>
    </message>
    <message>
        <source>Run `xacro FILE -o robot.urdf` and choose the result</source>
        <translation>`xacro FILE -o robot.urdf` ausführen und das Ergebnis wählen</translation>
    </message>
    <message>
        <source>Shorten it to 1000 characters</source>
        <translation>Ihn auf 1000 Zeichen kürzen</translation>
    </message>
    <message>
        <source>Take --mapping posture</source>
        <translation>--mapping posture verwenden</translation>
    </message>
    <message>
        <source>Take a longer motion, or leave the loop out</source>
        <translation>Eine längere Bewegung verwenden oder die Schleife weglassen</translation>
    </message>
    <message>
        <source>Take a motion whose skeleton has a trunk</source>
        <translation>Eine Bewegung verwenden, deren Skelett einen Rumpf hat</translation>
    </message>
    <message>
        <source>Take a motion with both arms, or rename its joints</source>
        <translation>Eine Bewegung mit beiden Armen verwenden oder ihre Gelenke umbenennen</translation>
    </message>
    <message>
        <source>Take a motion with whole arms</source>
        <translation>Eine Bewegung mit vollständigen Armen verwenden</translation>
    </message>
    <message>
        <source>Take a simpler model</source>
        <translation>Ein einfacheres Modell verwenden</translation>
    </message>
    <message>
        <source>Take the URDF that the commands were made for</source>
        <translation>Die URDF-Datei verwenden, für die die Befehle entstanden</translation>
    </message>
    <message>
        <source>The hand leaves the robot's workspace; the robot stays at its border.</source>
        <translation>Die Hand verlässt den Arbeitsraum des Roboters; der Roboter bleibt an dessen Rand.</translation>
    </message>
    <message>
        <source>The hand moves too little, or was seen too briefly, to tell a delay.</source>
        <translation>Die Hand bewegt sich zu wenig oder wurde zu kurz gesehen, um eine Verzögerung zu nennen.</translation>
    </message>
    <message>
        <source>The pose is uncertain; the robot moves slowly.</source>
        <translation>Die Pose ist unsicher; der Roboter bewegt sich langsam.</translation>
    </message>
    <message>
        <source>The robot does not answer; it is told to hold. Check its program and the network.</source>
        <translation>Der Roboter antwortet nicht; er soll halten. Sein Programm und das Netzwerk prüfen.</translation>
    </message>
    <message>
        <source>The robot refuses: the command is too far from where it is. Commands go back to it; then engage again.</source>
        <translation>Der Roboter weigert sich: der Befehl ist zu weit von seiner Haltung entfernt. Die Befehle gehen dorthin zurück; dann erneut einkuppeln.</translation>
    </message>
    <message>
        <source>Use fixed, revolute, continuous and prismatic joints</source>
        <translation>Gelenke vom Typ fixed, revolute, continuous und prismatic verwenden</translation>
    </message>
    <message>
        <source>Write the limit from the robot's data sheet</source>
        <translation>Die Grenze aus dem Datenblatt des Roboters eintragen</translation>
    </message>
    <message>
        <source>a %1 has no name</source>
        <translation>ein %1 hat keinen Namen</translation>
    </message>
    <message>
        <source>arm %1 has %2 joints, its reference or speeds have another number</source>
        <translation>Arm %1 hat %2 Gelenke, seine Referenz oder seine Geschwindigkeiten haben eine andere Anzahl</translation>
    </message>
    <message>
        <source>arm %1: its shoulder has %2 joints, the mapping of Miller needs three</source>
        <translation>Arm %1: seine Schulter hat %2 Gelenke, die Abbildung nach Miller braucht drei</translation>
    </message>
    <message>
        <source>arm %1: the axes of its shoulder are no Euler sequence</source>
        <translation>Arm %1: die Achsen seiner Schulter sind keine Euler-Folge</translation>
    </message>
    <message>
        <source>has more than 2000 links</source>
        <translation>hat mehr als 2000 Links</translation>
    </message>
    <message>
        <source>is a xacro file, from which a URDF has yet to be made</source>
        <translation>ist eine xacro-Datei, aus der erst noch eine URDF-Datei zu erstellen ist</translation>
    </message>
    <message>
        <source>is no URDF</source>
        <translation>ist keine URDF-Datei</translation>
    </message>
    <message>
        <source>its legs have two bases</source>
        <translation>seine Beine haben zwei Basen</translation>
    </message>
    <message>
        <source>joint "%1" in the chain follows another joint</source>
        <translation>Gelenk „%1“ in der Kette folgt einem anderen Gelenk</translation>
    </message>
    <message>
        <source>joint "%1" is not in arm %2</source>
        <translation>Gelenk „%1“ gehört nicht zu Arm %2</translation>
    </message>
    <message>
        <source>joint "%1" mimics a joint that mimics too</source>
        <translation>Gelenk „%1“ ahmt ein Gelenk nach, das selbst nachahmt</translation>
    </message>
    <message>
        <source>joint "%1" mimics no joint that is there</source>
        <translation>Gelenk „%1“ ahmt kein vorhandenes Gelenk nach</translation>
    </message>
    <message>
        <source>joint %1 names no %2 link that is there%3</source>
        <translation>Gelenk %1 nennt als %2 keinen vorhandenen Link%3</translation>
    </message>
    <message>
        <source>joint %1 states no %2 limit, %3 is assumed</source>
        <translation>Gelenk %1 nennt keine Grenze %2, %3 wird angenommen</translation>
    </message>
    <message>
        <source>link "%1" does not hang below link "%2"</source>
        <translation>Link „%1“ hängt nicht unter Link „%2“</translation>
    </message>
    <message>
        <source>link %1 hangs below itself: the robot has a loop</source>
        <translation>Link %1 hängt unter sich selbst: der Roboter hat eine Schleife</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>Übertragen</translation>
    </message>
    <message>
        <source>no arm of 4 to 7 joints is known by its names (%1 found)</source>
        <translation>kein Arm mit 4 bis 7 Gelenken ist an seinen Namen zu erkennen (%1 gefunden)</translation>
    </message>
    <message>
        <source>robot %1 has no arm on the side asked for</source>
        <translation>Roboter %1 hat auf der verlangten Seite keinen Arm</translation>
    </message>
    <message>
        <source>robot %1 has no joints in its trunk</source>
        <translation>Roboter %1 hat keine Gelenke im Rumpf</translation>
    </message>
    <message>
        <source>robot %1 has no two legs</source>
        <translation>der Roboter %1 hat keine zwei Beine</translation>
    </message>
    <message>
        <source>robot %1: joint "%2" belongs to two driven parts</source>
        <translation>Roboter %1: Das Gelenk „%2“ gehört zu zwei gesteuerten Teilen</translation>
    </message>
    <message>
        <source>shoulder, elbow and wrist of arm %1 do not follow one another</source>
        <translation>Schulter, Ellbogen und Handgelenk von Arm %1 folgen nicht aufeinander</translation>
    </message>
    <message>
        <source>the %1 %2 stands in it twice</source>
        <translation>%1 %2 steht zweimal darin</translation>
    </message>
    <message>
        <source>the %1 limit of joint %2 is no finite number (%3)</source>
        <translation>die Grenze %1 von Gelenk %2 ist keine endliche Zahl (%3)</translation>
    </message>
    <message>
        <source>the axis of %1 has no direction</source>
        <translation>die Achse von %1 hat keine Richtung</translation>
    </message>
    <message>
        <source>the commands have fewer than three frames</source>
        <translation>die Befehle haben weniger als drei Bilder</translation>
    </message>
    <message>
        <source>the joints %1 and %2 both hold link %3: the robot has a loop</source>
        <translation>die Gelenke %1 und %2 halten beide Link %3: der Roboter hat eine Schleife</translation>
    </message>
    <message>
        <source>the lower limit of joint %1 is above its upper limit</source>
        <translation>die untere Grenze von Gelenk %1 liegt über der oberen</translation>
    </message>
    <message>
        <source>the motion cannot be closed to a loop within the robot's limits</source>
        <translation>die Bewegung lässt sich innerhalb der Grenzen des Roboters nicht zur Schleife schließen</translation>
    </message>
    <message>
        <source>the name of a</source>
        <translation>der Name von</translation>
    </message>
    <message>
        <source>the name of a %1 is too long</source>
        <translation>der Name von %1 ist zu lang</translation>
    </message>
    <message>
        <source>the origin of %1 is no place</source>
        <translation>der Ursprung von %1 ist kein Ort</translation>
    </message>
    <message>
        <source>the performer has no two whole legs</source>
        <translation>der Darsteller hat keine zwei ganzen Beine</translation>
    </message>
    <message>
        <source>the profile does not fit the robot: %1</source>
        <translation>das Profil passt nicht zum Roboter: %1</translation>
    </message>
    <message>
        <source>the reference of joint "%1" is outside its limits</source>
        <translation>die Referenz von Gelenk „%1“ liegt außerhalb seiner Grenzen</translation>
    </message>
    <message>
        <source>the robot has no joint "%1"</source>
        <translation>der Roboter hat kein Gelenk „%1“</translation>
    </message>
    <message>
        <source>the velocity limit of joint "%1" is beyond 100 rad/s and says nothing; the profile's limit holds</source>
        <translation>die Geschwindigkeitsgrenze von Gelenk „%1“ liegt über 100 rad/s und besagt nichts; es gilt die Grenze des Profils</translation>
    </message>
    <message>
        <source>the velocity limit of joint %1 is not above 0</source>
        <translation>die Geschwindigkeitsgrenze von Gelenk %1 liegt nicht über 0</translation>
    </message>
    <message>
        <source>there is no link "%1"</source>
        <translation>es gibt keinen Link „%1“</translation>
    </message>
    <message>
        <source>upper arm or forearm of arm %1 is shorter than 1 cm</source>
        <translation>Ober- oder Unterarm von Arm %1 ist kürzer als 1 cm</translation>
    </message>
</context>
<context>
    <name>core/robot_film</name>
    <message>
        <source>%1 of %2 meshes are not there; capsules stand for their links</source>
        <translation>%1 von %2 Netzen fehlen; Kapseln stehen für ihre Links</translation>
    </message>
    <message>
        <source>Reading meshes of the robot</source>
        <translation>Netze des Roboters werden gelesen</translation>
    </message>
</context>
<context>
    <name>core/room_survey</name>
    <message>
        <source>%1: it hears %2</source>
        <translation>%1: er hört %2</translation>
    </message>
    <message>
        <source>%1: it hears %2, but not %3</source>
        <translation>%1: er hört %2, aber nicht %3</translation>
    </message>
    <message>
        <source>Anchor %1 is weak, ±%2 mm</source>
        <translation>Anker %1 ist schwach, ±%2 mm</translation>
    </message>
    <message>
        <source>Anchor %1 may as well hang at a second place, its mirror image: the ranges do not tell which</source>
        <translation>Anker %1 kann ebenso an einem zweiten Platz hängen, seinem Spiegelbild: Die Entfernungen sagen nicht, an welchem</translation>
    </message>
    <message>
        <source>Anchor %1 was heard too rarely to be placed</source>
        <translation>Anker %1 wurde zu selten gehört, um vermessen zu werden</translation>
    </message>
    <message>
        <source>Anchor %1 was moved by %2 m, %3 s into the take</source>
        <translation>Anker %1 wurde um %2 m bewegt, %3 s nach Beginn der Aufnahme</translation>
    </message>
    <message>
        <source>Anchor %1 was never heard</source>
        <translation>Anker %1 wurde nie gehört</translation>
    </message>
    <message>
        <source>Calibrate the suit, and see that straps sit tight</source>
        <translation>Kalibrieren Sie den Anzug und achten Sie darauf, dass die Gurte fest sitzen</translation>
    </message>
    <message>
        <source>Check its cable and what stands in front of it, or take it out of the room's file</source>
        <translation>Prüfen Sie sein Kabel und was vor ihm steht, oder nehmen Sie ihn aus der Raumdatei</translation>
    </message>
    <message>
        <source>Fasten it and record again</source>
        <translation>Befestigen Sie ihn und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>Nobody in a suit walked past the anchors, and the room's file does not say roughly where they hang: place and heading of the room cannot be known</source>
        <translation>Niemand ist im Anzug an den Ankern vorbeigegangen, und die Raumdatei sagt nicht ungefähr, wo sie hängen: Ort und Richtung des Raums sind nicht bestimmbar</translation>
    </message>
    <message>
        <source>Nobody walked past the anchors: place, heading and which of two mirror images it is are taken from the room's file</source>
        <translation>Niemand ist an den Ankern vorbeigegangen: Ort, Richtung und welches der beiden Spiegelbilder es ist, stammen aus der Raumdatei</translation>
    </message>
    <message>
        <source>Nobody walked past the anchors: place, heading, level and which of two mirror images it is are taken from the room's file</source>
        <translation>Niemand ist an den Ankern vorbeigegangen: Ort, Richtung, Waagrechte und welches der beiden Spiegelbilder es ist, stammen aus der Raumdatei</translation>
    </message>
    <message>
        <source>Only %1 anchors were heard well enough, a survey needs three; hardly heard: %2</source>
        <translation>Nur %1 Anker wurden gut genug gehört, eine Vermessung braucht drei; kaum gehört: %2</translation>
    </message>
    <message>
        <source>Only %1 of the six freedoms of the whole room are held</source>
        <translation>Nur %1 der sechs Freiheitsgrade des ganzen Raums sind festgelegt</translation>
    </message>
    <message>
        <source>Record a take in which somebody in a suit stands still and then walks past all anchors</source>
        <translation>Nehmen Sie auf, wie jemand im Anzug still steht und dann an allen Ankern vorbeigeht</translation>
    </message>
    <message>
        <source>Record a take in which somebody in a suit stands still and then walks past all anchors, or bring the anchors nearer together</source>
        <translation>Nehmen Sie auf, wie jemand im Anzug still steht und dann an allen Ankern vorbeigeht, oder rücken Sie die Anker näher zusammen</translation>
    </message>
    <message>
        <source>Record a take with a performer, or put rough places into the room's file</source>
        <translation>Nehmen Sie mit einem Darsteller auf, oder tragen Sie ungefähre Plätze in die Raumdatei ein</translation>
    </message>
    <message>
        <source>Record a take with somebody in a suit, or measure the heights of three anchors (--height)</source>
        <translation>Eine Aufnahme mit jemandem im Anzug machen, oder die Höhen von drei Ankern messen (--height)</translation>
    </message>
    <message>
        <source>Record again, slowly past all anchors</source>
        <translation>Nehmen Sie noch einmal auf, langsam an allen Ankern vorbei</translation>
    </message>
    <message>
        <source>Set up another anchor and record again</source>
        <translation>Stellen Sie einen weiteren Anker auf und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>Stand still in the rest pose at the beginning, in sight of all anchors</source>
        <translation>Stehen Sie zu Beginn still in der Ruhehaltung, in Sicht aller Anker</translation>
    </message>
    <message>
        <source>Surveying the room</source>
        <translation>Der Raum wird vermessen</translation>
    </message>
    <message>
        <source>The anchors hardly hear each other, and nobody in a suit walked past them</source>
        <translation>Die Anker hören einander kaum, und niemand ist im Anzug an ihnen vorbeigegangen</translation>
    </message>
    <message>
        <source>The anchors have no sources, and nobody in a suit walked past them</source>
        <translation>Die Anker haben keine Quellen, und niemand ist im Anzug an ihnen vorbeigegangen</translation>
    </message>
    <message>
        <source>The clocks of %1 and the room are known from this walk alone</source>
        <translation>Die Uhren von %1 und dem Raum sind nur aus diesem Gang bekannt</translation>
    </message>
    <message>
        <source>The distances disagree by %1 mm in the median</source>
        <translation>Die Abstände widersprechen sich im Median um %1 mm</translation>
    </message>
    <message>
        <source>The distances do not hold the anchors together</source>
        <translation>Die Abstände halten die Anker nicht zusammen</translation>
    </message>
    <message>
        <source>The room has %1 anchors, a survey needs three</source>
        <translation>Der Raum hat %1 Anker, eine Vermessung braucht drei</translation>
    </message>
    <message>
        <source>The survey did not come to an end</source>
        <translation>Die Vermessung kam zu keinem Ende</translation>
    </message>
    <message>
        <source>Use it, or walk once more past the others</source>
        <translation>Diesen verwenden oder noch einmal an den anderen vorbeigehen</translation>
    </message>
    <message>
        <source>Walk more widely and turn, or measure heights of anchors (--height)</source>
        <translation>Weiter umhergehen und sich drehen, oder Höhen von Ankern messen (--height)</translation>
    </message>
    <message>
        <source>Walk slowly past all anchors, turn towards each of them, and see that nothing hides them</source>
        <translation>Gehen Sie langsam an allen Ankern vorbei, drehen Sie sich zu jedem hin und achten Sie darauf, dass nichts sie verdeckt</translation>
    </message>
    <message>
        <source>Walk slowly past it, face it from several sides, and see that nothing hides it</source>
        <translation>Gehen Sie langsam an ihm vorbei, wenden Sie sich ihm von mehreren Seiten zu und achten Sie darauf, dass nichts ihn verdeckt</translation>
    </message>
    <message>
        <source>Wear a suit whose boards and sources share housings, or join the boxes with a sync cable</source>
        <translation>Tragen Sie einen Anzug, bei dem Platinen und Quellen Gehäuse teilen, oder verbinden Sie die Boxen mit einem Synchronkabel</translation>
    </message>
    <message>
        <source>Without anchor %1 fewer than three anchors would have a place</source>
        <translation>Ohne Anker %1 hätten weniger als drei Anker einen Platz</translation>
    </message>
</context>
<context>
    <name>core/sensor_calibration</name>
    <message>
        <source>Lay it down for two seconds each in 12 positions or more, also with %1 upward</source>
        <translation>Je zwei Sekunden lang in 12 oder mehr Stellungen hinlegen, auch mit %1 nach oben</translation>
    </message>
    <message>
        <source>Lay it down with %1 upward too</source>
        <translation>Auch mit %1 nach oben hinlegen</translation>
    </message>
    <message>
        <source>Lay it on something firm and let go of it</source>
        <translation>Auf etwas Festes legen und loslassen</translation>
    </message>
    <message>
        <source>Record a minute in which the board is turned through all directions</source>
        <translation>Eine Minute aufnehmen, in der die Platine durch alle Richtungen gedreht wird</translation>
    </message>
    <message>
        <source>Stay in one place, away from iron, and turn the board again</source>
        <translation>An einem Ort bleiben, fern von Eisen, und die Platine erneut drehen</translation>
    </message>
    <message>
        <source>Stay in one place, away from iron, magnets and cables, and turn the board again</source>
        <translation>An einem Ort bleiben, fern von Eisen, Magneten und Kabeln, und die Platine erneut drehen</translation>
    </message>
    <message>
        <source>Turn it by half a turn and more about each axis between positions</source>
        <translation>Zwischen den Stellungen um jede Achse eine halbe Umdrehung oder mehr drehen</translation>
    </message>
    <message>
        <source>Turn it more slowly, below its full scale, and about all axes</source>
        <translation>Langsamer drehen, unterhalb des Messbereichsendes, und um alle Achsen</translation>
    </message>
    <message>
        <source>Turn the board about all its axes, slowly, in one place</source>
        <translation>Die Platine langsam um alle ihre Achsen drehen, am selben Ort</translation>
    </message>
    <message>
        <source>Turn the board until its field has pointed along %1</source>
        <translation>Die Platine drehen, bis ihr Feld entlang %1 gezeigt hat</translation>
    </message>
    <message>
        <source>gravity differs between positions by %1 m/s^2 after the fit</source>
        <translation>die Schwerkraft unterscheidet sich nach der Anpassung zwischen Stellungen um %1 m/s^2</translation>
    </message>
    <message>
        <source>it lay still in %1 different positions</source>
        <translation>sie lag in %1 verschiedenen Stellungen still</translation>
    </message>
    <message>
        <source>it was turned too little about</source>
        <translation>sie wurde zu wenig gedreht um</translation>
    </message>
    <message>
        <source>it was turned too little about %1</source>
        <translation>sie wurde zu wenig um %1 gedreht</translation>
    </message>
    <message>
        <source>the field changed while the board was turned</source>
        <translation>das Feld änderte sich, während die Platine gedreht wurde</translation>
    </message>
    <message>
        <source>the field was read in %1 different directions or fewer</source>
        <translation>das Feld wurde in %1 verschiedenen Richtungen oder weniger gelesen</translation>
    </message>
    <message>
        <source>the field was seen along %1 of %2 main directions, %3 are needed</source>
        <translation>das Feld war in %1 von %2 Hauptrichtungen zu sehen, nötig sind %3</translation>
    </message>
    <message>
        <source>the positions do not determine the accelerometer</source>
        <translation>die Stellungen bestimmen den Beschleunigungssensor nicht</translation>
    </message>
    <message>
        <source>the readings lie on no ellipsoid that soft iron makes</source>
        <translation>die Messwerte liegen auf keinem Ellipsoid, wie weiches Eisen es erzeugt</translation>
    </message>
    <message>
        <source>the turns do not determine the fit</source>
        <translation>die Drehungen bestimmen die Anpassung nicht</translation>
    </message>
    <message>
        <source>the turns do not fit the positions: %1 deg remain</source>
        <translation>die Drehungen passen nicht zu den Stellungen: %1 Grad bleiben</translation>
    </message>
</context>
<context>
    <name>core/session</name>
    <message>
        <source>%1 is in the list already</source>
        <translation>%1 steht schon in der Liste</translation>
    </message>
    <message>
        <source>%1 is not there any more. Put it back, or remove the take from the list.</source>
        <translation>%1 ist nicht mehr da. Wieder zurücklegen oder die Aufnahme aus der Liste entfernen.</translation>
    </message>
    <message>
        <source>%1: a take cannot be called "%2"</source>
        <translation>%1: eine Aufnahme kann nicht „%2“ heißen</translation>
    </message>
    <message>
        <source>%1: another take has this name by now</source>
        <translation>%1: Inzwischen trägt eine andere Aufnahme diesen Namen</translation>
    </message>
    <message>
        <source>%1: cannot be made: %2</source>
        <translation>%1: lässt sich nicht anlegen: %2</translation>
    </message>
    <message>
        <source>%1: holds no session</source>
        <translation>%1: enthält keine Sitzung</translation>
    </message>
    <message>
        <source>%1: is finished already</source>
        <translation>%1: ist schon abgeschlossen</translation>
    </message>
    <message>
        <source>%1: is in this session already</source>
        <translation>%1: ist schon in dieser Sitzung</translation>
    </message>
    <message>
        <source>%1: is not a session with takes and a damaged list</source>
        <translation>%1: ist keine Sitzung mit Aufnahmen und beschädigter Liste</translation>
    </message>
    <message>
        <source>%1: is not a take of this session</source>
        <translation>%1: ist keine Aufnahme dieser Sitzung</translation>
    </message>
    <message>
        <source>%1: is not empty</source>
        <translation>%1: ist nicht leer</translation>
    </message>
    <message>
        <source>%1: is not there any more</source>
        <translation>%1: ist nicht mehr da</translation>
    </message>
    <message>
        <source>%1: the recording was not finished</source>
        <translation>%1: Die Aufnahme wurde nicht beendet</translation>
    </message>
    <message>
        <source>%1: the recording was not finished. What was written is safe; recover it.</source>
        <translation>%1: die Aufnahme wurde nicht abgeschlossen. Was geschrieben wurde, ist sicher; sie wiederherstellen.</translation>
    </message>
    <message>
        <source>%1: there is a take of that name already, or one in the trash</source>
        <translation>%1: es gibt schon eine Aufnahme dieses Namens, oder eine im Papierkorb</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1: diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>%1: was changed after copying began</source>
        <translation>%1: wurde geändert, nachdem das Kopieren begonnen hatte</translation>
    </message>
    <message>
        <source>. Its %1 takes are safe</source>
        <translation>. Ihre %1 Aufnahmen sind sicher</translation>
    </message>
    <message>
        <source>. Its take is safe</source>
        <translation>. Ihre Aufnahme ist sicher</translation>
    </message>
    <message>
        <source>Choose another name or folder</source>
        <translation>Einen anderen Namen oder Ordner wählen</translation>
    </message>
    <message>
        <source>Choose another one</source>
        <translation>Eine andere wählen</translation>
    </message>
    <message>
        <source>Choose another session</source>
        <translation>Eine andere Sitzung wählen</translation>
    </message>
    <message>
        <source>Choose the folder of a session</source>
        <translation>Den Ordner einer Sitzung wählen</translation>
    </message>
    <message>
        <source>Looking at takes</source>
        <translation>Aufnahmen werden angesehen</translation>
    </message>
    <message>
        <source>Move or copy it again</source>
        <translation>Erneut verschieben oder kopieren</translation>
    </message>
    <message>
        <source>Open it as it is</source>
        <translation>So öffnen, wie sie ist</translation>
    </message>
    <message>
        <source>Put it back</source>
        <translation>Zurücklegen</translation>
    </message>
    <message>
        <source>Rebuild the session from its takes; a damaged session.json is kept beside the new one</source>
        <translation>Die Sitzung aus ihren Aufnahmen neu aufbauen; eine beschädigte session.json bleibt neben der neuen erhalten</translation>
    </message>
    <message>
        <source>Recover it first</source>
        <translation>Zuerst wiederherstellen</translation>
    </message>
    <message>
        <source>Rename or remove the one that is there first</source>
        <translation>Zuerst die vorhandene umbenennen oder entfernen</translation>
    </message>
    <message>
        <source>Rename that one first</source>
        <translation>Zuerst jene umbenennen</translation>
    </message>
    <message>
        <source>There is nothing to recover</source>
        <translation>Es gibt nichts wiederherzustellen</translation>
    </message>
    <message>
        <source>Use letters, digits, hyphens and underscores</source>
        <translation>Buchstaben, Ziffern, Bindestriche und Unterstriche verwenden</translation>
    </message>
    <message>
        <source>dual</source>
        <translation>dual</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
</context>
<context>
    <name>core/simulation</name>
    <message>
        <source>%1 and %2 both sound at %3%4, and only carriers 5 kHz apart can be told from each other</source>
        <translation>%1 und %2 senden beide auf %3%4, und nur Trägerfrequenzen im Abstand von 5 kHz lassen sich unterscheiden</translation>
    </message>
    <message>
        <source>%1 begin in one place in their files and stand in a row instead</source>
        <translation>%1 beginnen in ihren Dateien am selben Ort und stehen stattdessen in einer Reihe</translation>
    </message>
    <message>
        <source>%1 bias walk</source>
        <translation>%1 bias walk</translation>
    </message>
    <message>
        <source>%1 cannot sound at %2</source>
        <translation>%1 kann nicht auf %2 senden</translation>
    </message>
    <message>
        <source>%1 is not a text</source>
        <translation>%1 ist kein Text</translation>
    </message>
    <message>
        <source>%1 must be true or false</source>
        <translation>%1 muss true oder false sein</translation>
    </message>
    <message>
        <source>%1 walks through the wall at %2 s, up to %3 m beyond it; sound is not true there. The room is %4 x %5 m: give another place or a shorter duration</source>
        <translation>%1 geht bei %2 s durch die Wand, bis zu %3 m weit; Schall stimmt dort nicht. Der Raum misst %4 x %5 m: einen anderen Ort oder eine kürzere Dauer angeben</translation>
    </message>
    <message>
        <source>%1: frame %2, joint %3: a value is not a finite number</source>
        <translation>%1: Bild %2, Gelenk %3: ein Wert ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1: its figure would be %2 m tall</source>
        <translation>%1: ihre Figur wäre %2 m groß</translation>
    </message>
    <message>
        <source>%1: pulses of %2 cycles do not fit into their interval of %3 samples</source>
        <translation>%1: Pulse von %2 Schwingungen passen nicht in ihren Abstand von %3 Abtastwerten</translation>
    </message>
    <message>
        <source>%1: subject %2: mag: magnetometers of a cast are not simulated; it is left out</source>
        <translation>%1: Darsteller %2: mag: Magnetometer einer Besetzung werden nicht simuliert; es wird ausgelassen</translation>
    </message>
    <message>
        <source>%1: there is no motion in it</source>
        <translation>%1: es ist keine Bewegung darin</translation>
    </message>
    <message>
        <source>A calibration on the %1 rig does not fit into %2 s</source>
        <translation>Eine Kalibrierung mit dem Aufbau %1 passt nicht in %2 s</translation>
    </message>
    <message>
        <source>A subject is called "room" beside the room</source>
        <translation>Ein Darsteller heißt „room“ neben dem Raum</translation>
    </message>
    <message>
        <source>A take cannot last %1 s</source>
        <translation>Eine Aufnahme kann nicht %1 s dauern</translation>
    </message>
    <message>
        <source>Add --level readings</source>
        <translation>--level readings hinzufügen</translation>
    </message>
    <message>
        <source>Choose a file with frames</source>
        <translation>Eine Datei mit Bildern wählen</translation>
    </message>
    <message>
        <source>Choose ideal, nominal or realistic</source>
        <translation>ideal, nominal oder realistic wählen</translation>
    </message>
    <message>
        <source>Correct it in the cast</source>
        <translation>In der Besetzung berichtigen</translation>
    </message>
    <message>
        <source>Give 0 to 3600 seconds</source>
        <translation>0 bis 3600 Sekunden angeben</translation>
    </message>
    <message>
        <source>Give at least %1 seconds</source>
        <translation>Mindestens %1 Sekunden angeben</translation>
    </message>
    <message>
        <source>Give at most a day (86400 seconds)</source>
        <translation>Höchstens einen Tag angeben (86400 Sekunden)</translation>
    </message>
    <message>
        <source>Give both the same segment in the suit's description</source>
        <translation>Beiden in der Beschreibung des Anzugs dasselbe Glied geben</translation>
    </message>
    <message>
        <source>Give every subject a name of its own</source>
        <translation>Jedem Darsteller einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>Give it one with "motion"</source>
        <translation>Ihm mit „motion“ eine geben</translation>
    </message>
    <message>
        <source>Give the person's height with --height M, or the file's unit with --bvh-unit</source>
        <translation>Die Größe der Person mit --height M oder die Einheit der Datei mit --bvh-unit angeben</translation>
    </message>
    <message>
        <source>Give the subject another name</source>
        <translation>Dem Darsteller einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Leave out a subject: at most eight suits, the room's among them, fit between 24 and 68 kHz</source>
        <translation>Einen Darsteller weglassen: höchstens acht Anzüge, der des Raums eingeschlossen, passen zwischen 24 und 68 kHz</translation>
    </message>
    <message>
        <source>Leave out a subject: no carrier between 24 and 68 kHz is free</source>
        <translation>Einen Darsteller weglassen: zwischen 24 und 68 kHz ist keine Trägerfrequenz frei</translation>
    </message>
    <message>
        <source>Name at least one, with its motion</source>
        <translation>Mindestens einen nennen, mit seiner Bewegung</translation>
    </message>
    <message>
        <source>No carrier is left for %1</source>
        <translation>Für %1 bleibt keine Trägerfrequenz</translation>
    </message>
    <message>
        <source>Repair or cut that frame</source>
        <translation>Dieses Bild reparieren oder herausschneiden</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtasten</translation>
    </message>
    <message>
        <source>Set its segment to null and its position to that in the world</source>
        <translation>segment auf null setzen und position auf die in der Welt</translation>
    </message>
    <message>
        <source>The cast has no subjects</source>
        <translation>Die Besetzung hat keine Darsteller</translation>
    </message>
    <message>
        <source>The rest pose cannot be held for %1 s</source>
        <translation>Die Ruhehaltung lässt sich nicht %1 s lang halten</translation>
    </message>
    <message>
        <source>There is no scenario "%1"</source>
        <translation>Es gibt kein Szenario „%1“</translation>
    </message>
    <message>
        <source>Two subjects are called "%1"</source>
        <translation>Zwei Darsteller heißen „%1“</translation>
    </message>
    <message>
        <source>accel axes</source>
        <translation>accel axes</translation>
    </message>
    <message>
        <source>accel bias</source>
        <translation>accel bias</translation>
    </message>
    <message>
        <source>accel calibration</source>
        <translation>accel calibration</translation>
    </message>
    <message>
        <source>air instruments</source>
        <translation>air instruments</translation>
    </message>
    <message>
        <source>all directions</source>
        <translation>alle Richtungen</translation>
    </message>
    <message>
        <source>and %1</source>
        <translation>und %1</translation>
    </message>
    <message>
        <source>board %1 reads %2 times a second, but sound carries 140 readings a second</source>
        <translation>Platine %1 liest %2-mal je Sekunde, aber der Schall trägt 140 Messwerte je Sekunde</translation>
    </message>
    <message>
        <source>board gain</source>
        <translation>board gain</translation>
    </message>
    <message>
        <source>board mounting</source>
        <translation>board mounting</translation>
    </message>
    <message>
        <source>click times</source>
        <translation>click times</translation>
    </message>
    <message>
        <source>clock offset</source>
        <translation>clock offset</translation>
    </message>
    <message>
        <source>clock rate</source>
        <translation>clock rate</translation>
    </message>
    <message>
        <source>clock rate wander</source>
        <translation>clock rate wander</translation>
    </message>
    <message>
        <source>clock wander</source>
        <translation>clock wander</translation>
    </message>
    <message>
        <source>external root</source>
        <translation>external root</translation>
    </message>
    <message>
        <source>field noise</source>
        <translation>Rauschen des Magnetfelds</translation>
    </message>
    <message>
        <source>first guess of the clock</source>
        <translation>first guess of the clock</translation>
    </message>
    <message>
        <source>gyro axes</source>
        <translation>gyro axes</translation>
    </message>
    <message>
        <source>gyro bias</source>
        <translation>gyro bias</translation>
    </message>
    <message>
        <source>gyro calibration</source>
        <translation>gyro calibration</translation>
    </message>
    <message>
        <source>has more than %1 subjects</source>
        <translation>hat mehr als %1 Darsteller</translation>
    </message>
    <message>
        <source>has no motion</source>
        <translation>hat keine Bewegung</translation>
    </message>
    <message>
        <source>held rest pose</source>
        <translation>held rest pose</translation>
    </message>
    <message>
        <source>is not an object</source>
        <translation>ist kein Objekt</translation>
    </message>
    <message>
        <source>level plate</source>
        <translation>waagrechte Platte</translation>
    </message>
    <message>
        <source>low frequency noise</source>
        <translation>low frequency noise</translation>
    </message>
    <message>
        <source>mic delay</source>
        <translation>mic delay</translation>
    </message>
    <message>
        <source>must be a %snumber from %g to %g</source>
        <translation>muss eine %sZahl von %g bis %g sein</translation>
    </message>
    <message>
        <source>placement</source>
        <translation>placement</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>room %1: %2 '%3' sits on segment '%4', but anchors hang in the room</source>
        <translation>Raum %1: %2 „%3“ sitzt auf Glied „%4“, aber Anker hängen im Raum</translation>
    </message>
    <message>
        <source>soft tissue</source>
        <translation>soft tissue</translation>
    </message>
    <message>
        <source>source gain</source>
        <translation>source gain</translation>
    </message>
    <message>
        <source>source ka</source>
        <translation>source ka</translation>
    </message>
    <message>
        <source>source mounting</source>
        <translation>source mounting</translation>
    </message>
    <message>
        <source>source offset error</source>
        <translation>source offset error</translation>
    </message>
    <message>
        <source>source resonance</source>
        <translation>source resonance</translation>
    </message>
    <message>
        <source>start delay</source>
        <translation>start delay</translation>
    </message>
    <message>
        <source>stream phase</source>
        <translation>stream phase</translation>
    </message>
    <message>
        <source>subject %1 has no motion</source>
        <translation>Darsteller %1 hat keine Bewegung</translation>
    </message>
    <message>
        <source>subjects is no list of performers</source>
        <translation>subjects ist keine Liste von Darstellern</translation>
    </message>
    <message>
        <source>suit %1: source '%2' sits on another segment than board '%3', with which it shares a housing</source>
        <translation>Anzug %1: Quelle „%2“ sitzt auf einem anderen Glied als Platine „%3“, mit der sie ein Gehäuse teilt</translation>
    </message>
    <message>
        <source>turntable speed</source>
        <translation>turntable speed</translation>
    </message>
    <message>
        <source>turntable tilt</source>
        <translation>turntable tilt</translation>
    </message>
    <message>
        <source>two subjects are called "%1"</source>
        <translation>zwei Darsteller heißen „%1“</translation>
    </message>
    <message>
        <source>ultrasonic noise</source>
        <translation>ultrasonic noise</translation>
    </message>
    <message>
        <source>whole</source>
        <translation>ganze</translation>
    </message>
</context>
<context>
    <name>core/suit</name>
    <message>
        <source>%1: %2 '%3' sits on segment '%4', which the actor does not have</source>
        <translation>%1: %2 „%3“ sitzt auf Glied „%4“, das in den Körpermaßen nicht vorkommt</translation>
    </message>
    <message>
        <source>%1: is not a JSON object</source>
        <translation>%1: ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>%1: source '%2' sits on board '%3', which the suit does not have</source>
        <translation>%1: Quelle „%2“ sitzt auf Platine „%3“, die der Anzug nicht hat</translation>
    </message>
    <message>
        <source>Choose a file that was exported as a calibration</source>
        <translation>Eine Datei wählen, die als Kalibrierung exportiert wurde</translation>
    </message>
    <message>
        <source>Choose a file with the description of a suit</source>
        <translation>Eine Datei mit der Beschreibung eines Anzugs wählen</translation>
    </message>
    <message>
        <source>Correct the board in the suit's description</source>
        <translation>Die Platine in der Beschreibung des Anzugs berichtigen</translation>
    </message>
    <message>
        <source>Correct the segment in the suit's description or use an actor that has it</source>
        <translation>Das Glied in der Beschreibung des Anzugs berichtigen oder Körpermaße verwenden, die es enthalten</translation>
    </message>
    <message>
        <source>Correct this member and try again</source>
        <translation>Diesen Eintrag berichtigen und erneut versuchen</translation>
    </message>
    <message>
        <source>See core/recording/README.md for the format</source>
        <translation>Das Format steht in core/recording/README.md</translation>
    </message>
    <message>
        <source>is not a calibration</source>
        <translation>ist keine Kalibrierung</translation>
    </message>
    <message>
        <source>is not a suit</source>
        <translation>ist kein Anzug</translation>
    </message>
    <message>
        <source>is there twice</source>
        <translation>steht zweimal darin</translation>
    </message>
    <message>
        <source>must be %1 in this program</source>
        <translation>muss in diesem Programm %1 sein</translation>
    </message>
    <message>
        <source>must be 10 to 1000 readings a second</source>
        <translation>muss 10 bis 1000 Messwerte je Sekunde sein</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>muss eine Liste sein</translation>
    </message>
    <message>
        <source>must be a unit quaternion w, x, y, z</source>
        <translation>muss ein Einheitsquaternion w, x, y, z sein</translation>
    </message>
    <message>
        <source>must be a whole number from 1 on</source>
        <translation>muss eine ganze Zahl ab 1 sein</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>muss ein Objekt sein</translation>
    </message>
    <message>
        <source>must be cramer, linear or fixed</source>
        <translation>muss cramer, linear oder fixed sein</translation>
    </message>
    <message>
        <source>must be greater than zero</source>
        <translation>muss größer als null sein</translation>
    </message>
    <message>
        <source>must be imu6 or imu9</source>
        <translation>muss imu6 oder imu9 sein</translation>
    </message>
    <message>
        <source>must be invertible</source>
        <translation>muss invertierbar sein</translation>
    </message>
    <message>
        <source>must be six entries of three finite numbers</source>
        <translation>muss aus sechs Einträgen von je drei endlichen Zahlen bestehen</translation>
    </message>
    <message>
        <source>must be text</source>
        <translation>muss Text sein</translation>
    </message>
    <message>
        <source>must be three finite numbers</source>
        <translation>muss aus drei endlichen Zahlen bestehen</translation>
    </message>
    <message>
        <source>must be three rows of three finite numbers</source>
        <translation>muss aus drei Zeilen von je drei endlichen Zahlen bestehen</translation>
    </message>
    <message>
        <source>must be two names, null where there is none</source>
        <translation>muss aus zwei Namen bestehen, null, wo es keinen gibt</translation>
    </message>
    <message>
        <source>must have a direction, its length is zero</source>
        <translation>muss eine Richtung haben, die Länge ist null</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>darf nicht leer sein</translation>
    </message>
    <message>
        <source>must not have more than 32 entries</source>
        <translation>darf nicht mehr als 32 Einträge haben</translation>
    </message>
    <message>
        <source>of '%1' must be a finite number</source>
        <translation>von „%1“ muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>source offsets</source>
        <translation>Quellenversätze</translation>
    </message>
    <message>
        <source>this take has no calibration. Process it with one.</source>
        <translation>diese Aufnahme hat keine Kalibrierung. Mit einer verarbeiten.</translation>
    </message>
    <message>
        <source>this take was made without calibration of %1. Process it with a calibration that has them.</source>
        <translation>diese Aufnahme entstand ohne Kalibrierung für %1. Mit einer verarbeiten, die sie hat.</translation>
    </message>
</context>
<context>
    <name>core/vision</name>
    <message>
        <source>%1 fits badly: %2 px, others %3 px</source>
        <translation>%1 passt schlecht: %2 px, andere %3 px</translation>
    </message>
    <message>
        <source>%1%2 and is not used</source>
        <translation>%1%2 und wird nicht verwendet</translation>
    </message>
    <message>
        <source>%1: its distances in placement %2 are known to %3 mm only</source>
        <translation>%1: die Abstände in Aufstellung %2 sind nur auf %3 mm bekannt</translation>
    </message>
    <message>
        <source>%1: its marker %2 does not lie where the others say in %3%4</source>
        <translation>%1: die zugehörige Marke %2 liegt nicht dort, wo die anderen es in %3 angeben%4</translation>
    </message>
    <message>
        <source>%1: its marker %2 is %3 of placement%4%5</source>
        <translation>%1: die zugehörige Marke %2 ist %3 von Aufstellung%4%5</translation>
    </message>
    <message>
        <source>%1: its marker %2 is seen twice in %3 and is not used in placement %4</source>
        <translation>%1: die zugehörige Marke %2 ist in %3 zweimal zu sehen und wird in Aufstellung %4 nicht verwendet</translation>
    </message>
    <message>
        <source>%1: the file's name does not begin with a placement of the take%2</source>
        <translation>%1: der Dateiname beginnt nicht mit einer Aufstellung der Aufnahme%2</translation>
    </message>
    <message>
        <source>, and is not used in placement %1</source>
        <translation>, und wird in Aufstellung %1 nicht verwendet</translation>
    </message>
    <message>
        <source>, which has none</source>
        <translation>, die keine hat</translation>
    </message>
    <message>
        <source>100 mm: measure it on the paper</source>
        <translation>100 mm: auf dem Papier nachmessen</translation>
    </message>
    <message>
        <source>Add photographs of it from other sides and nearer</source>
        <translation>Fotografien davon von anderen Seiten und aus größerer Nähe hinzufügen</translation>
    </message>
    <message>
        <source>Add photographs that show sources and boards at the same time</source>
        <translation>Fotografien hinzufügen, die Quellen und Platinen zugleich zeigen</translation>
    </message>
    <message>
        <source>Copy it from the camera again, or leave it out and take another photograph</source>
        <translation>Erneut von der Kamera kopieren oder weglassen und eine andere Fotografie machen</translation>
    </message>
    <message>
        <source>Finding where the cameras stood</source>
        <translation>Die Standorte der Kameras werden gesucht</translation>
    </message>
    <message>
        <source>Looking for markers in %1</source>
        <translation>In %1 werden Marken gesucht</translation>
    </message>
    <message>
        <source>Measure the distances with a digitizer or a tape</source>
        <translation>Die Abstände mit Messarm oder Maßband messen</translation>
    </message>
    <message>
        <source>Name photographs PLACEMENT_*.jpg, for example %1_1.jpg</source>
        <translation>Fotografien PLACEMENT_*.jpg nennen, zum Beispiel %1_1.jpg</translation>
    </message>
    <message>
        <source>Noctule: markers of suit %1, page %2 of %3</source>
        <translation>Noctule: Marken von Anzug %1, Seite %2 von %3</translation>
    </message>
    <message>
        <source>Photograph every placement at least twice, all markers in sight</source>
        <translation>Jede Aufstellung mindestens zweimal fotografieren, alle Marken im Blick</translation>
    </message>
    <message>
        <source>Photograph it whole and sharp, from at least two sides</source>
        <translation>Ganz und scharf fotografieren, von mindestens zwei Seiten</translation>
    </message>
    <message>
        <source>Print at 100 % ("actual size"), on matt paper. If the line below is not 100 mm long, give the side measured on</source>
        <translation>Mit 100 % („tatsächliche Größe“) auf mattes Papier drucken. Ist die Linie unten nicht 100 mm lang, die Seite angeben, gemessen auf</translation>
    </message>
    <message>
        <source>See that it is flat, of the same size as the others and does not move between photographs</source>
        <translation>Darauf achten, dass sie flach und so groß wie die anderen ist und sich zwischen den Fotografien nicht bewegt</translation>
    </message>
    <message>
        <source>Take another one from another side while nothing has moved</source>
        <translation>Eine weitere von einer anderen Seite machen, ohne dass sich etwas bewegt hat</translation>
    </message>
    <message>
        <source>Take it again nearer, in better light and sharp</source>
        <translation>Erneut aus größerer Nähe, bei besserem Licht und scharf aufnehmen</translation>
    </message>
    <message>
        <source>Take it again sharp, with the same camera and no zoom</source>
        <translation>Erneut scharf aufnehmen, mit derselben Kamera und ohne Zoom</translation>
    </message>
    <message>
        <source>Take it off the jig, or stick the sheet of this suit on</source>
        <translation>Vom Messgestell nehmen oder den Bogen dieses Anzugs aufkleben</translation>
    </message>
    <message>
        <source>Take photographs that overlap, with nothing moved in between</source>
        <translation>Fotografien machen, die sich überlappen, ohne dazwischen etwas zu bewegen</translation>
    </message>
    <message>
        <source>Take the wrong one off the jig and photograph the placement again</source>
        <translation>Die falsche vom Messgestell nehmen und die Aufstellung erneut fotografieren</translation>
    </message>
    <message>
        <source>Take them sharp, with one camera and without zoom, markers flat and all of one size, nothing moved between those of one placement</source>
        <translation>Scharf aufnehmen, mit einer Kamera und ohne Zoom, Marken flach und alle gleich groß, zwischen den Fotografien einer Aufstellung nichts bewegt</translation>
    </message>
    <message>
        <source>The middle of the marker lies over the middle of the source's face, of a board over its microphone's opening;</source>
        <translation>Die Mitte der Marke liegt über der Mitte der Vorderseite der Quelle, bei einer Platine über der Öffnung ihres Mikrofons;</translation>
    </message>
    <message>
        <source>The photographs do not fit together: %1 px per corner, 0.3 px is usual</source>
        <translation>Die Fotografien passen nicht zusammen: %1 px je Ecke, 0,3 px ist üblich</translation>
    </message>
    <message>
        <source>The photographs give no distance:</source>
        <translation>Die Fotografien ergeben keinen Abstand:</translation>
    </message>
    <message>
        <source>and _ (%1)</source>
        <translation>und _ (%1)</translation>
    </message>
    <message>
        <source>does not fit the others</source>
        <translation>passt nicht zu den anderen</translation>
    </message>
    <message>
        <source>in its middle for the sound. The origin stands anywhere still, where many photographs show it.</source>
        <translation>in ihrer Mitte für den Schall. Der Ursprung steht irgendwo still, wo viele Fotografien ihn zeigen.</translation>
    </message>
    <message>
        <source>in no photograph</source>
        <translation>auf keiner Fotografie</translation>
    </message>
    <message>
        <source>in one photograph only</source>
        <translation>nur auf einer Fotografie</translation>
    </message>
    <message>
        <source>is not a photograph that can be read</source>
        <translation>ist keine lesbare Fotografie</translation>
    </message>
    <message>
        <source>is too small to look for markers</source>
        <translation>ist zu klein, um darin Marken zu suchen</translation>
    </message>
    <message>
        <source>it may be turned any way. Take it off while sound is recorded, or punch a hole of at most %1 mm</source>
        <translation>sie darf beliebig gedreht sein. Beim Aufnehmen von Ton abnehmen oder ein Loch stanzen von höchstens %1 mm</translation>
    </message>
    <message>
        <source>marker %1 stands in the photographs and belongs to no part of the suit</source>
        <translation>Marke %1 steht auf den Fotografien und gehört zu keinem Teil des Anzugs</translation>
    </message>
    <message>
        <source>no marker is found in %1</source>
        <translation>in %1 ist keine Marke zu finden</translation>
    </message>
    <message>
        <source>no placement has markers that two photographs show</source>
        <translation>keine Aufstellung hat Marken, die zwei Fotografien zeigen</translation>
    </message>
    <message>
        <source>no source and board can be measured together</source>
        <translation>keine Quelle und Platine lassen sich zusammen messen</translation>
    </message>
    <message>
        <source>placement %1 has only one photograph, %2</source>
        <translation>Aufstellung %1 hat nur eine Fotografie, %2</translation>
    </message>
    <message>
        <source>shows no marker that ties it to the others</source>
        <translation>zeigt keine Marke, die sie mit den anderen verbindet</translation>
    </message>
    <message>
        <source>suit %1 has %2 sources and %3 boards; there are markers for %4 and %5</source>
        <translation>Anzug %1 hat %2 Quellen und %3 Platinen; es gibt Marken für %4 und %5</translation>
    </message>
    <message>
        <source>the paper as --marker-mm instead of %1. Cut along the grey lines, keep the white margin, stick on flat card.</source>
        <translation>dem Papier, als --marker-mm statt %1. An den grauen Linien schneiden, den weißen Rand lassen, auf flachen Karton kleben.</translation>
    </message>
    <message>
        <source>the photograph is cut off</source>
        <translation>die Fotografie ist abgeschnitten</translation>
    </message>
    <message>
        <source>the photographs</source>
        <translation>die Fotografien</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>ohne Namen</translation>
    </message>
</context>
<context>
    <name>devices/device</name>
    <message>
        <source>'%1' is no address of a device: %2</source>
        <translation>„%1“ ist keine Adresse eines Geräts: %2</translation>
    </message>
    <message>
        <source>'%1' is no name or number of a computer</source>
        <translation>„%1“ ist weder Name noch Nummer eines Rechners</translation>
    </message>
    <message>
        <source>1 is as fast as it was recorded, 2 twice as fast, 0 as fast as possible</source>
        <translation>1 ist so schnell wie aufgenommen, 2 doppelt so schnell, 0 so schnell wie möglich</translation>
    </message>
    <message>
        <source>Addresses look like tcp://10.0.0.7:41941, serial:///dev/ttyACM0 or replay:walk_001.noctule</source>
        <translation>Adressen lauten etwa tcp://10.0.0.7:41941, serial:///dev/ttyACM0 oder replay:walk_001.noctule</translation>
    </message>
    <message>
        <source>Check that the box is switched on, in the same network, and that this is its address and port</source>
        <translation>Prüfen, ob die Box eingeschaltet und im selben Netzwerk ist und ob Adresse und Port stimmen</translation>
    </message>
    <message>
        <source>Check the cable and that the box is switched on</source>
        <translation>Prüfen, ob das Kabel in Ordnung und die Box eingeschaltet ist</translation>
    </message>
    <message>
        <source>Choose a take of sound</source>
        <translation>Eine Aufnahme mit Ton wählen</translation>
    </message>
    <message>
        <source>Choose a take recorded from a suit or simulated with --level signal</source>
        <translation>Eine Aufnahme wählen, die von einem Anzug stammt oder mit --level signal simuliert ist</translation>
    </message>
    <message>
        <source>Choose another take</source>
        <translation>Eine andere Aufnahme wählen</translation>
    </message>
    <message>
        <source>Close the program that uses it, or have your account added to the group dialout</source>
        <translation>Das Programm schließen, das sie verwendet, oder das eigene Konto in die Gruppe dialout aufnehmen lassen</translation>
    </message>
    <message>
        <source>Connect a driver box for that</source>
        <translation>Dafür eine Steuerbox verbinden</translation>
    </message>
    <message>
        <source>Plug the box in, or see with 'noctule --batch devices' which ports there are</source>
        <translation>Die Box einstecken oder mit `noctule --batch devices` ansehen, welche Schnittstellen es gibt</translation>
    </message>
    <message>
        <source>Stop it first</source>
        <translation>Zuerst anhalten</translation>
    </message>
    <message>
        <source>a port is a number from 1 to 65535</source>
        <translation>ein Port ist eine Zahl von 1 bis 65535</translation>
    </message>
    <message>
        <source>a serial port is named by its whole path, after three slashes</source>
        <translation>eine serielle Schnittstelle wird mit ihrem ganzen Pfad genannt, nach drei Schrägstrichen</translation>
    </message>
    <message>
        <source>a take cannot be played at this speed</source>
        <translation>eine Aufnahme lässt sich nicht mit dieser Geschwindigkeit abspielen</translation>
    </message>
    <message>
        <source>a take that is played again can neither be set nor light up</source>
        <translation>eine abgespielte Aufnahme lässt sich weder einstellen noch zum Leuchten bringen</translation>
    </message>
    <message>
        <source>driver box</source>
        <translation>Steuerbox</translation>
    </message>
    <message>
        <source>it begins with none of tcp://, serial:// and replay:</source>
        <translation>sie beginnt weder mit tcp:// noch mit serial:// oder replay:</translation>
    </message>
    <message>
        <source>it holds no sound</source>
        <translation>sie enthält keinen Ton</translation>
    </message>
    <message>
        <source>it holds readings and no sound, which a driver box would send</source>
        <translation>sie enthält Messwerte und keinen Ton, wie ihn eine Steuerbox sendet</translation>
    </message>
    <message>
        <source>it names no computer</source>
        <translation>sie nennt keinen Rechner</translation>
    </message>
    <message>
        <source>it names no take</source>
        <translation>sie nennt keine Aufnahme</translation>
    </message>
    <message>
        <source>its suit has no boards</source>
        <translation>ihr Anzug hat keine Platinen</translation>
    </message>
    <message>
        <source>no connection within 3 s</source>
        <translation>keine Verbindung innerhalb von 3 s</translation>
    </message>
    <message>
        <source>no take is open</source>
        <translation>keine Aufnahme ist geöffnet</translation>
    </message>
    <message>
        <source>take</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>the box has closed the connection</source>
        <translation>die Box hat die Verbindung geschlossen</translation>
    </message>
    <message>
        <source>the take is being played already</source>
        <translation>die Aufnahme wird schon abgespielt</translation>
    </message>
</context>
<context>
    <name>devices/driver_box</name>
    <message>
        <source>%1 names no protocol</source>
        <translation>%1 nennt kein Protokoll</translation>
    </message>
    <message>
        <source>%1: suit of HELLO</source>
        <translation>%1: Anzug in HELLO</translation>
    </message>
    <message>
        <source>%1: the box speaks protocol %2, this program speaks 1</source>
        <translation>%1: die Box spricht Protokoll %2, dieses Programm spricht 1</translation>
    </message>
    <message>
        <source>'%1' is not what it should be</source>
        <translation>„%1“ ist nicht, was es sein soll</translation>
    </message>
    <message>
        <source>ANNOUNCE is no JSON object</source>
        <translation>ANNOUNCE ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>ANNOUNCE: '%1' is missing or not what it should be</source>
        <translation>ANNOUNCE: „%1“ fehlt oder ist nicht, was es sein soll</translation>
    </message>
    <message>
        <source>Check that it is switched on and that this is its address or port</source>
        <translation>Prüfen, ob sie eingeschaltet ist und ob Adresse oder Port stimmt</translation>
    </message>
    <message>
        <source>Check the cable and try again</source>
        <translation>Das Kabel prüfen und erneut versuchen</translation>
    </message>
    <message>
        <source>Check the cable and update the box's firmware</source>
        <translation>Das Kabel prüfen und die Firmware der Box aktualisieren</translation>
    </message>
    <message>
        <source>Choose the suit that is plugged in, or add this serial number to its file</source>
        <translation>Den eingesteckten Anzug wählen oder diese Seriennummer in seine Datei eintragen</translation>
    </message>
    <message>
        <source>Connect first</source>
        <translation>Zuerst verbinden</translation>
    </message>
    <message>
        <source>Connect, or stop the running take first</source>
        <translation>Verbinden oder zuerst die laufende Aufnahme beenden</translation>
    </message>
    <message>
        <source>HELLO describes no board</source>
        <translation>HELLO beschreibt keine Platine</translation>
    </message>
    <message>
        <source>HELLO is no JSON object</source>
        <translation>HELLO ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>HELLO: '%1' is missing or not what it should be</source>
        <translation>HELLO: „%1“ fehlt oder ist nicht, was es sein soll</translation>
    </message>
    <message>
        <source>Is another program connected to it?</source>
        <translation>Ist ein anderes Programm mit ihr verbunden?</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Erneut starten</translation>
    </message>
    <message>
        <source>The studio tries again by itself; check the cable and the box's battery</source>
        <translation>Das Studio versucht es von selbst wieder; das Kabel und den Akku der Box prüfen</translation>
    </message>
    <message>
        <source>The suit '</source>
        <translation>Der Anzug '</translation>
    </message>
    <message>
        <source>The suit '%1' has no %2 with the serial number of '%3' (%4)</source>
        <translation>Der Anzug „%1“ hat keine %2 mit der Seriennummer von „%3“ (%4)</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Update this program or the box's firmware</source>
        <translation>Dieses Programm oder die Firmware der Box aktualisieren</translation>
    </message>
    <message>
        <source>What was recorded until then is complete; start a new take</source>
        <translation>Was bis dahin aufgenommen wurde, ist vollständig; eine neue Aufnahme beginnen</translation>
    </message>
    <message>
        <source>another box, or another suit, has answered</source>
        <translation>eine andere Box oder ein anderer Anzug hat geantwortet</translation>
    </message>
    <message>
        <source>bad payload</source>
        <translation>fehlerhafte Nutzdaten</translation>
    </message>
    <message>
        <source>battery low</source>
        <translation>Akku schwach</translation>
    </message>
    <message>
        <source>board found</source>
        <translation>Platine gefunden</translation>
    </message>
    <message>
        <source>board lost</source>
        <translation>Platine verloren</translation>
    </message>
    <message>
        <source>board restarted</source>
        <translation>Platine neu gestartet</translation>
    </message>
    <message>
        <source>code %1</source>
        <translation>Code %1</translation>
    </message>
    <message>
        <source>hardware fault</source>
        <translation>Hardwarefehler</translation>
    </message>
    <message>
        <source>is no JSON object</source>
        <translation>ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>no box is connected</source>
        <translation>keine Box ist verbunden</translation>
    </message>
    <message>
        <source>no box is ready to start</source>
        <translation>keine Box ist startbereit</translation>
    </message>
    <message>
        <source>no driver box answers</source>
        <translation>keine Steuerbox antwortet</translation>
    </message>
    <message>
        <source>no sound for 3 s</source>
        <translation>seit 3 s kein Ton</translation>
    </message>
    <message>
        <source>not now (busy or wrong state)</source>
        <translation>nicht jetzt (beschäftigt oder falscher Zustand)</translation>
    </message>
    <message>
        <source>not supported</source>
        <translation>nicht unterstützt</translation>
    </message>
    <message>
        <source>shutting down</source>
        <translation>wird ausgeschaltet</translation>
    </message>
    <message>
        <source>the box accepted START but sends no sound</source>
        <translation>die Box nahm START an, sendet aber keinen Ton</translation>
    </message>
    <message>
        <source>the box does not answer</source>
        <translation>die Box antwortet nicht</translation>
    </message>
    <message>
        <source>the box does not answer %1</source>
        <translation>die Box antwortet nicht auf %1</translation>
    </message>
    <message>
        <source>the box has been silent for 3 s</source>
        <translation>die Box ist seit 3 s stumm</translation>
    </message>
    <message>
        <source>the box has restarted</source>
        <translation>die Box hat neu gestartet</translation>
    </message>
    <message>
        <source>the box refuses %1, %2</source>
        <translation>die Box weist %1 ab, %2</translation>
    </message>
    <message>
        <source>the box speaks version %1 of the link, this program speaks 1</source>
        <translation>die Box spricht Version %1 der Verbindung, dieses Programm spricht 1</translation>
    </message>
    <message>
        <source>the client does not read</source>
        <translation>der Client liest nicht</translation>
    </message>
    <message>
        <source>the client has been silent for 10 s</source>
        <translation>der Client ist seit 10 s stumm</translation>
    </message>
    <message>
        <source>the connection was closed</source>
        <translation>die Verbindung wurde geschlossen</translation>
    </message>
    <message>
        <source>the connection was closed before a box answered</source>
        <translation>die Verbindung wurde geschlossen, bevor eine Box antwortete</translation>
    </message>
    <message>
        <source>the link is too slow, sound was dropped</source>
        <translation>die Verbindung ist zu langsam, Ton ging verloren</translation>
    </message>
    <message>
        <source>the link was closed while recording</source>
        <translation>die Verbindung wurde während der Aufnahme geschlossen</translation>
    </message>
    <message>
        <source>type 0x%02x</source>
        <translation>Typ 0x%02x</translation>
    </message>
    <message>
        <source>unknown type</source>
        <translation>unbekannter Typ</translation>
    </message>
</context>
<context>
    <name>devices/live</name>
    <message>
        <source>%1 Driver box: %2</source>
        <translation>%1 Steuerbox: %2</translation>
    </message>
    <message>
        <source>%1 `noctule --batch recover` on it</source>
        <translation>%1 `noctule --batch recover` darauf ausführen</translation>
    </message>
    <message>
        <source>%1 and %2 are the same driver box, %3</source>
        <translation>%1 und %2 sind dieselbe Steuerbox, %3</translation>
    </message>
    <message>
        <source>%1 and %2 both sound at %3, and only carriers 5 kHz apart can be told from each other</source>
        <translation>%1 und %2 senden beide auf %3, und nur Trägerfrequenzen im Abstand von 5 kHz lassen sich unterscheiden</translation>
    </message>
    <message>
        <source>%1 and %2 pulse at the same interval, %3 samples, so the same pulses may collide during the whole take. Set one of the boxes to another interval, such as 1200, 1230 or 1260 samples.</source>
        <translation>%1 und %2 senden Pulse im selben Abstand von %3 Abtastwerten, also können dieselben Pulse während der ganzen Aufnahme zusammenfallen. Eine der Boxen auf einen anderen Abstand einstellen, etwa 1200, 1230 oder 1260 Abtastwerte.</translation>
    </message>
    <message>
        <source>%1%2%3 of sound waited in memory and %4 beside the take%5</source>
        <translation>%1%2%3 Ton warteten im Speicher und %4 neben der Aufnahme%5</translation>
    </message>
    <message>
        <source>%1: all of it is fixed in the room, so nobody wears it, and %2 is given as its performer</source>
        <translation>%1: alles davon ist fest im Raum, niemand trägt es also, und %2 ist als Darsteller angegeben</translation>
    </message>
    <message>
        <source>%1: another program has locked the take for two minutes</source>
        <translation>%1: ein anderes Programm sperrt die Aufnahme seit zwei Minuten</translation>
    </message>
    <message>
        <source>%1: another program reads the take, so a -wal file stands beside it; keep both together until the take is opened again.</source>
        <translation>%1: ein anderes Programm liest die Aufnahme, deshalb liegt eine -wal-Datei daneben; beide zusammenlassen, bis die Aufnahme erneut geöffnet wird.</translation>
    </message>
    <message>
        <source>%1: internal error: %2</source>
        <translation>%1: interner Fehler: %2</translation>
    </message>
    <message>
        <source>%1: is not ready to start</source>
        <translation>%1: ist nicht startbereit</translation>
    </message>
    <message>
        <source>%1: no driver box answers</source>
        <translation>%1: keine Steuerbox antwortet</translation>
    </message>
    <message>
        <source>%1: sends no sound</source>
        <translation>%1: sendet keinen Ton</translation>
    </message>
    <message>
        <source>%1: sends nothing</source>
        <translation>%1: sendet nichts</translation>
    </message>
    <message>
        <source>%1: the sound broke off before the recording ended</source>
        <translation>%1: der Ton brach ab, bevor die Aufnahme endete</translation>
    </message>
    <message>
        <source>(not yet as one file)</source>
        <translation>(noch nicht als eine Datei)</translation>
    </message>
    <message>
        <source>, nothing was lost.</source>
        <translation>, nichts ging verloren.</translation>
    </message>
    <message>
        <source>: another program held the take for up to %.1f s;</source>
        <translation>: ein anderes Programm hielt die Aufnahme bis zu %.1f s lang;</translation>
    </message>
    <message>
        <source>; another program holds the take, what comes waits</source>
        <translation>; ein anderes Programm hält die Aufnahme, was ankommt, wartet</translation>
    </message>
    <message>
        <source>; suit %1 is lost</source>
        <translation>; Anzug %1 ist verloren</translation>
    </message>
    <message>
        <source>; the file could not be completed, the first %1 stand in it and in the -wal file beside it</source>
        <translation>; die Datei ließ sich nicht abschließen, die ersten %1 stehen in ihr und in der -wal-Datei daneben</translation>
    </message>
    <message>
        <source>; the recording has ended, the first %1 are safe in %2</source>
        <translation>; die Aufnahme ist beendet, die ersten %1 sind sicher in %2</translation>
    </message>
    <message>
        <source>Begin while it streams; a take that is played again has an end</source>
        <translation>Beginnen, während es sendet; eine abgespielte Aufnahme hat ein Ende</translation>
    </message>
    <message>
        <source>Check that it has room</source>
        <translation>Prüfen, ob dort Platz ist</translation>
    </message>
    <message>
        <source>Check that it is switched on and that the address is right</source>
        <translation>Prüfen, ob sie eingeschaltet ist und die Adresse stimmt</translation>
    </message>
    <message>
        <source>Check the cable and the box's battery, and record again</source>
        <translation>Kabel und Akku der Box prüfen und noch einmal aufnehmen</translation>
    </message>
    <message>
        <source>Close the other program</source>
        <translation>Das andere Programm schließen</translation>
    </message>
    <message>
        <source>Disconnect the suit and connect it again; check its calibration. What is recorded is complete</source>
        <translation>Den Anzug trennen und neu verbinden; seine Kalibrierung prüfen. Was aufgenommen ist, ist vollständig</translation>
    </message>
    <message>
        <source>Driver box: %1 further errors came too fast to be noted.</source>
        <translation>Steuerbox: %1 weitere Fehler kamen zu schnell, um vermerkt zu werden.</translation>
    </message>
    <message>
        <source>Free some space and run</source>
        <translation>Platz schaffen und</translation>
    </message>
    <message>
        <source>Free some space, or record to another disk</source>
        <translation>Platz schaffen oder auf einen anderen Datenträger aufnehmen</translation>
    </message>
    <message>
        <source>Give each suit a driver box of its own</source>
        <translation>Jedem Anzug eine eigene Steuerbox geben</translation>
    </message>
    <message>
        <source>Nobody wears any of these suits: all of them are fixed in the room</source>
        <translation>Niemand trägt einen dieser Anzüge: alle sind fest im Raum</translation>
    </message>
    <message>
        <source>Nothing is processed live: %1.</source>
        <translation>Nichts wird live verarbeitet: %1.</translation>
    </message>
    <message>
        <source>Please report it</source>
        <translation>Dem Hersteller melden</translation>
    </message>
    <message>
        <source>Record at least one suit of a performer, or give its placement with --suit</source>
        <translation>Mindestens den Anzug eines Darstellers aufnehmen oder mit --suit seinen Sitz angeben</translation>
    </message>
    <message>
        <source>Recording %.1f s, %.2f s missing, disk for %.0f min</source>
        <translation>Nimmt auf %.1f s, %.2f s fehlen, Datenträger reicht für %.0f min</translation>
    </message>
    <message>
        <source>Recording %zu suits %.1f s, disk for %.0f min</source>
        <translation>Nimmt %zu Anzüge auf, %.1f s, Datenträger reicht für %.0f min</translation>
    </message>
    <message>
        <source>Set one of the boxes to another carrier, such as 40, 48 or 58 kHz, in its firmware (virtual suits: start both from one --cast), or record them one after the other</source>
        <translation>Eine der Boxen in ihrer Firmware auf eine andere Trägerfrequenz einstellen, etwa 40, 48 oder 58 kHz (virtuelle Anzüge: beide mit demselben --cast starten), oder nacheinander aufnehmen</translation>
    </message>
    <message>
        <source>Switch the driver box off and on, and record again</source>
        <translation>Die Steuerbox aus- und einschalten und noch einmal aufnehmen</translation>
    </message>
    <message>
        <source>The device stopped before a recording was begun</source>
        <translation>Das Gerät hielt an, bevor eine Aufnahme begann</translation>
    </message>
    <message>
        <source>The driver box did not confirm that it had sent everything.</source>
        <translation>Die Steuerbox hat nicht bestätigt, dass sie alles gesendet hat.</translation>
    </message>
    <message>
        <source>The driver box said at %1: %2%3.</source>
        <translation>Die Steuerbox meldete bei %1: %2%3.</translation>
    </message>
    <message>
        <source>The live results are not in the take: %1.</source>
        <translation>Die Live-Ergebnisse sind nicht in der Aufnahme: %1.</translation>
    </message>
    <message>
        <source>The recording was ended because only %1 are free on the disk of %2; %3 are safe in the file</source>
        <translation>Die Aufnahme wurde beendet, weil auf dem Datenträger von %2 nur %1 frei sind; %3 sind sicher in der Datei</translation>
    </message>
    <message>
        <source>The suit is not calibrated: all of its sound is kept, but no poses. Process the take with a calibration.</source>
        <translation>Der Anzug ist nicht kalibriert: sein Ton wird ganz aufgezeichnet, aber keine Posen. Die Aufnahme mit einer Kalibrierung verarbeiten.</translation>
    </message>
    <message>
        <source>The suit was lost after %.1f s and did not come back; the last %.1f s of the take are missing and marked as a gap.</source>
        <translation>Der Anzug ging nach %.1f s verloren und kam nicht zurück; die letzten %.1f s der Aufnahme fehlen und sind als Lücke vermerkt.</translation>
    </message>
    <message>
        <source>The take ended before its rest pose did. All of its sound is there, but no pose.</source>
        <translation>Die Aufnahme endete vor ihrer Ruhehaltung. Ihr Ton ist vollständig da, aber keine Pose.</translation>
    </message>
    <message>
        <source>Wait until all driver boxes have answered and the take before has ended</source>
        <translation>Warten, bis alle Steuerboxen geantwortet haben und die vorige Aufnahme beendet ist</translation>
    </message>
    <message>
        <source>Wait until the driver box has answered and the stream before has ended</source>
        <translation>Warten, bis die Steuerbox geantwortet hat und der vorige Datenstrom beendet ist</translation>
    </message>
    <message>
        <source>Waiting for CaptureStart on UDP port %1</source>
        <translation>Wartet auf CaptureStart an UDP-Port %1</translation>
    </message>
    <message>
        <source>What is recorded is complete; process the take, and report the mistake</source>
        <translation>Was aufgenommen ist, ist vollständig; die Aufnahme verarbeiten und den Fehler melden</translation>
    </message>
    <message>
        <source>Write `none` in place of this device's actor</source>
        <translation>`none` anstelle der Körpermaße dieses Geräts schreiben</translation>
    </message>
    <message>
        <source>`noctule --batch recover` on it</source>
        <translation>`noctule --batch recover` darauf ausführen</translation>
    </message>
    <message>
        <source>came late: when the recording was stopped, its last %.1f s were not there yet. They are marked as a gap.</source>
        <translation>kam zu spät: Als die Aufnahme beendet wurde, waren die letzten %.1f s noch nicht da. Sie sind als Lücke vermerkt.</translation>
    </message>
    <message>
        <source>processing has ended by a mistake of this program (%1)</source>
        <translation>die Verarbeitung endete durch einen Fehler dieses Programms (%1)</translation>
    </message>
    <message>
        <source>the live estimate was lost: the data contradict each other</source>
        <translation>die Live-Schätzung ist verloren: die Daten widersprechen einander</translation>
    </message>
    <message>
        <source>the live view</source>
        <translation>die Live-Ansicht</translation>
    </message>
    <message>
        <source>was lost after %.1f s and did not come back; the last %.1f s of it are missing and marked as a gap.</source>
        <translation>ging nach %.1f s verloren und kam nicht zurück; die letzten %.1f s davon fehlen und sind als Lücke vermerkt.</translation>
    </message>
    <message>
        <source>was lost after %.1f s and did not come back; the last %.1f s of it are missing and marked as a gap. The other suits were recorded on.</source>
        <translation>ging nach %.1f s verloren und kam nicht zurück; die letzten %.1f s davon fehlen und sind als Lücke vermerkt. Die anderen Anzüge wurden weiter aufgenommen.</translation>
    </message>
</context>
<context>
    <name>devices/remote</name>
    <message>
        <source>%1: is not the address of a computer</source>
        <translation>%1: ist nicht die Adresse eines Rechners</translation>
    </message>
    <message>
        <source>Choose another port; those below 1024 belong to the administrator</source>
        <translation>Einen anderen Port wählen; die unter 1024 gehören dem Administrator</translation>
    </message>
    <message>
        <source>Give it in numbers, such as 10.0.0.5</source>
        <translation>Die Adresse in Zahlen angeben, etwa 10.0.0.5</translation>
    </message>
    <message>
        <source>UDP port %1: cannot be listened to: %2</source>
        <translation>UDP-Port %1: kein Empfang möglich: %2</translation>
    </message>
    <message>
        <source>remote trigger</source>
        <translation>Fernauslöser</translation>
    </message>
</context>
<context>
    <name>devices/robot</name>
    <message>
        <source>%1: %2 has no joint "%3"</source>
        <translation>%1: %2 hat kein Gelenk „%3“</translation>
    </message>
    <message>
        <source>%1: %2 joints cannot be driven</source>
        <translation>%1: %2 Gelenke lassen sich nicht ansteuern</translation>
    </message>
    <message>
        <source>%1: another program has held the take for ten minutes</source>
        <translation>%1: ein anderes Programm hält die Aufnahme seit zehn Minuten fest</translation>
    </message>
    <message>
        <source>%1: as many positions as names are needed, and as many or no velocities</source>
        <translation>%1: es braucht so viele Positionen wie Namen und ebenso viele oder keine Geschwindigkeiten</translation>
    </message>
    <message>
        <source>%1: cannot be written to%2</source>
        <translation>%1: lässt sich nicht beschreiben%2</translation>
    </message>
    <message>
        <source>%1: no UDP port can be had: %2</source>
        <translation>%1: kein UDP-Port ist verfügbar: %2</translation>
    </message>
    <message>
        <source>%1: no robot answers</source>
        <translation>%1: kein Roboter antwortet</translation>
    </message>
    <message>
        <source>%1: no rosbridge answers: %2</source>
        <translation>%1: kein rosbridge antwortet: %2</translation>
    </message>
    <message>
        <source>%1: rosbridge says: %2</source>
        <translation>%1: rosbridge meldet: %2</translation>
    </message>
    <message>
        <source>%1: sends binary messages</source>
        <translation>%1: sendet binäre Nachrichten</translation>
    </message>
    <message>
        <source>%1: sends commands instead of states</source>
        <translation>%1: sendet Befehle statt Zustände</translation>
    </message>
    <message>
        <source>%1: the network knows no computer of this name</source>
        <translation>%1: das Netzwerk kennt keinen Rechner dieses Namens</translation>
    </message>
    <message>
        <source>%1: the robot's joints are others than those that are driven</source>
        <translation>%1: die Gelenke des Roboters sind andere als die angesteuerten</translation>
    </message>
    <message>
        <source>'%1' is not the address of a robot</source>
        <translation>„%1“ ist nicht die Adresse eines Roboters</translation>
    </message>
    <message>
        <source>'%1': no interface is called %2</source>
        <translation>„%1“: keine Schnittstelle heißt %2</translation>
    </message>
    <message>
        <source>Check how the name is written, or give its address in numbers</source>
        <translation>Prüfen Sie die Schreibweise des Namens, oder geben Sie die Adresse in Zahlen an</translation>
    </message>
    <message>
        <source>Check that its program runs and that the address is right</source>
        <translation>Prüfen, ob sein Programm läuft und die Adresse stimmt</translation>
    </message>
    <message>
        <source>Check that the URDF is this robot's, and the topic of its state</source>
        <translation>Prüfen, ob die URDF-Datei zu diesem Roboter gehört und das Topic seines Zustands stimmt</translation>
    </message>
    <message>
        <source>Check that this is the robot's address, not a studio's</source>
        <translation>Prüfen, ob dies die Adresse des Roboters ist und nicht die eines Studios</translation>
    </message>
    <message>
        <source>Check the network and the robot's address</source>
        <translation>Das Netzwerk und die Adresse des Roboters prüfen</translation>
    </message>
    <message>
        <source>Check the topics and their types</source>
        <translation>Die Topics und ihre Typen prüfen</translation>
    </message>
    <message>
        <source>Close programs that hold many ports</source>
        <translation>Programme schließen, die viele Ports belegen</translation>
    </message>
    <message>
        <source>Drive 1 to %1 joints</source>
        <translation>1 bis %1 Gelenke ansteuern</translation>
    </message>
    <message>
        <source>Give the robot the same joint names in the same order</source>
        <translation>Dem Roboter dieselben Gelenknamen in derselben Reihenfolge geben</translation>
    </message>
    <message>
        <source>Give udp://HOST:PORT or rosbridge://HOST:PORT, such as rosbridge://127.0.0.1:9090</source>
        <translation>udp://HOST:PORT oder rosbridge://HOST:PORT angeben, etwa rosbridge://127.0.0.1:9090</translation>
    </message>
    <message>
        <source>Run rosbridge without compression, as JSON</source>
        <translation>rosbridge ohne Kompression betreiben, als JSON</translation>
    </message>
    <message>
        <source>Send datagrams as devices/robot/README.md lays them out, version %1</source>
        <translation>Datagramme senden, wie devices/robot/README.md sie beschreibt, Version %1</translation>
    </message>
    <message>
        <source>Send rosbridge v2 with the message types of devices/robot/README.md</source>
        <translation>rosbridge v2 mit den Nachrichtentypen von devices/robot/README.md senden</translation>
    </message>
    <message>
        <source>Start rosbridge on the robot, and check its address and port (9090 is usual)</source>
        <translation>rosbridge auf dem Roboter starten und Adresse und Port prüfen (9090 ist üblich)</translation>
    </message>
    <message>
        <source>a JointState has no names, or a value that is no number in range</source>
        <translation>ein JointState hat keine Namen oder einen Wert, der keine Zahl im Bereich ist</translation>
    </message>
    <message>
        <source>a JointTrajectory has a value that is no number in range</source>
        <translation>eine JointTrajectory hat einen Wert, der keine Zahl im Bereich ist</translation>
    </message>
    <message>
        <source>a JointTrajectory has no points</source>
        <translation>eine JointTrajectory hat keine Punkte</translation>
    </message>
    <message>
        <source>a PoseStamped has an orientation that is no unit quaternion</source>
        <translation>ein PoseStamped hat eine Orientierung, die kein Einheitsquaternion ist</translation>
    </message>
    <message>
        <source>a PoseStamped has no pose, or a value that is no number in range</source>
        <translation>ein PoseStamped hat keine Pose oder einen Wert, der keine Zahl im Bereich ist</translation>
    </message>
    <message>
        <source>a message has no "op", or "op", "topic" or "type" is no text</source>
        <translation>eine Nachricht hat kein „op“, oder „op“, „topic“ oder „type“ ist kein Text</translation>
    </message>
    <message>
        <source>a message is nested too deeply</source>
        <translation>eine Nachricht ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>a message is no JSON object</source>
        <translation>eine Nachricht ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>a message of %1 bytes is too long</source>
        <translation>eine Nachricht von %1 Bytes ist zu lang</translation>
    </message>
    <message>
        <source>does not begin with NRC1, NRS1 or NRQ1</source>
        <translation>beginnt nicht mit NRC1, NRS1 oder NRQ1</translation>
    </message>
    <message>
        <source>has version %1</source>
        <translation>hat Version %1</translation>
    </message>
    <message>
        <source>holds a joint value that is no number or beyond %1</source>
        <translation>enthält einen Gelenkwert, der keine Zahl ist oder jenseits von %1 liegt</translation>
    </message>
    <message>
        <source>is damaged: its checksum is wrong</source>
        <translation>ist beschädigt: die Prüfsumme ist falsch</translation>
    </message>
    <message>
        <source>of %1 bytes does not fit its %2 joints</source>
        <translation>von %1 Bytes passt nicht zu seinen %2 Gelenken</translation>
    </message>
    <message>
        <source>of %1 bytes is too short</source>
        <translation>von %1 Bytes ist zu kurz</translation>
    </message>
    <message>
        <source>that is a query has joints</source>
        <translation>das eine Abfrage ist, hat Gelenke</translation>
    </message>
    <message>
        <source>that is no query has no joints</source>
        <translation>das keine Abfrage ist, hat keine Gelenke</translation>
    </message>
    <message>
        <source>the connection is closed</source>
        <translation>die Verbindung ist geschlossen</translation>
    </message>
    <message>
        <source>the network does not know its name now</source>
        <translation>das Netzwerk kennt seinen Namen gerade nicht</translation>
    </message>
</context>
<context>
    <name>ui/models</name>
    <message>
        <source>%1: does not say who wears the suit</source>
        <translation>%1: sagt nicht, wer den Anzug trägt</translation>
    </message>
    <message>
        <source>%1: is a log that only Xsens' own programs read</source>
        <translation>%1: ist ein Protokoll, das nur die Programme von Xsens lesen</translation>
    </message>
    <message>
        <source>%1: is no recording of sensors</source>
        <translation>%1: ist keine Aufzeichnung von Sensoren</translation>
    </message>
    <message>
        <source>Choose another folder for sessions in the preferences</source>
        <translation>In den Einstellungen einen anderen Ordner für Sitzungen wählen</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Die Datei löschen</translation>
    </message>
    <message>
        <source>Export it as text in MT Manager, and import that</source>
        <translation>Es in MT Manager als Text exportieren und diesen importieren</translation>
    </message>
    <message>
        <source>It begins again when the suit is back</source>
        <translation>Er beginnt neu, sobald der Anzug wieder da ist</translation>
    </message>
    <message>
        <source>Recordings are MATLAB, MVNX, MT Manager's text, x-IMU3, OpenSense .sto, and tables with a map</source>
        <translation>Aufzeichnungen sind MATLAB, MVNX, Text von MT Manager, x-IMU3, OpenSense .sto und Tabellen mit Zuordnung</translation>
    </message>
    <message>
        <source>Switch it off and on again, then look again</source>
        <translation>Aus- und wieder einschalten, dann erneut suchen</translation>
    </message>
    <message>
        <source>The driver box sends no sound</source>
        <translation>Die Steuerbox sendet keinen Ton</translation>
    </message>
    <message>
        <source>The stream broke off before the step was kept</source>
        <translation>Der Datenstrom brach ab, bevor der Schritt gespeichert war</translation>
    </message>
    <message>
        <source>no performer</source>
        <translation>kein Darsteller</translation>
    </message>
</context>
<context>
    <name>ui/views/export</name>
    <message>
        <source>%1: holds several performers</source>
        <translation>%1: enthält mehrere Darsteller</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made</source>
        <translation>%1: der Ordner lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>Choose another folder, or look at its rights</source>
        <translation>Einen anderen Ordner wählen oder seine Rechte prüfen</translation>
    </message>
    <message>
        <source>Free some space on the disk</source>
        <translation>Platz auf dem Datenträger schaffen</translation>
    </message>
    <message>
        <source>There is no room for a temporary file</source>
        <translation>Für eine temporäre Datei ist kein Platz</translation>
    </message>
</context>
<context>
    <name>ui/views/session</name>
    <message>
        <source>%1 has no result yet</source>
        <translation>%1 hat noch kein Ergebnis</translation>
    </message>
    <message>
        <source>Process it</source>
        <translation>Die Aufnahme verarbeiten</translation>
    </message>
</context>
</TS>
