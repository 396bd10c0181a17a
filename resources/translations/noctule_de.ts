<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CalibrationState</name>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>brauchbar</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>nicht brauchbar</translation>
    </message>
    <message>
        <source>%1 of %2 parts, %3, since %4: due again</source>
        <translation>%1 von %2 Teilen, %3, Stand: %4. Wieder fällig</translation>
    </message>
    <message>
        <source>%1 of %2 parts, %3, since %4</source>
        <translation>%1 von %2 Teilen, %3, Stand: %4</translation>
    </message>
    <message>
        <source>In use; where it comes from is not stated</source>
        <translation>In Gebrauch; woher es stammt, ist nicht angegeben</translation>
    </message>
    <message>
        <source>%1 of %2 parts in use; where they come from is not stated</source>
        <translation>%1 von %2 Teilen in Gebrauch; woher sie stammen, ist nicht angegeben</translation>
    </message>
    <message>
        <source>Not calibrated yet</source>
        <translation>Noch nicht kalibriert</translation>
    </message>
</context>
<context>
    <name>ChannelMenu</name>
    <message>
        <source>Open a take first</source>
        <translation>Zuerst eine Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>Joint angles</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Platinen</translation>
    </message>
    <message>
        <source>Remove added channels</source>
        <translation>Hinzugefügte Kanäle entfernen</translation>
    </message>
</context>
<context>
    <name>ContactBars</name>
    <message>
        <source>%1 stands from %2 to %3, set by hand</source>
        <comment>a foot, two times</comment>
        <translation>%1 steht von %2 bis %3, von Hand gesetzt</translation>
    </message>
    <message>
        <source>%1 stands from %2 to %3, found</source>
        <comment>a foot, two times</comment>
        <translation>%1 steht von %2 bis %3, gefunden</translation>
    </message>
    <message>
        <source>%1 does not stand here. Double-click to set a contact.</source>
        <comment>a foot</comment>
        <translation>%1 steht hier nicht. Ein Doppelklick setzt einen Kontakt.</translation>
    </message>
    <message>
        <source>Set a contact at the cursor</source>
        <translation>Kontakt am Zeiger setzen</translation>
    </message>
    <message>
        <source>Begin at the cursor</source>
        <translation>Am Zeiger beginnen</translation>
    </message>
    <message>
        <source>End at the cursor</source>
        <translation>Am Zeiger enden</translation>
    </message>
    <message>
        <source>Delete contact</source>
        <translation>Kontakt löschen</translation>
    </message>
    <message>
        <source>Back to what was found</source>
        <translation>Zurück zu dem, was gefunden wurde</translation>
    </message>
    <message>
        <source>L foot</source>
        <comment>left foot, short</comment>
        <translation>L Fuß</translation>
    </message>
    <message>
        <source>R foot</source>
        <comment>right foot, short</comment>
        <translation>R Fuß</translation>
    </message>
    <message>
        <source>The contacts are yours now. Reprocess the take to hold the body by them.</source>
        <translation>Die Kontakte sind jetzt von Hand gesetzt. Die Aufnahme neu verarbeiten, damit sie den Körper halten.</translation>
    </message>
</context>
<context>
    <name>CurveNames</name>
    <message>
        <source>flexion</source>
        <translation>Beugung</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>Hebung</translation>
    </message>
    <message>
        <source>protraction</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>pronation</source>
        <translation>Einwärtsdrehung</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Seitneigung</translation>
    </message>
    <message>
        <source>inversion</source>
        <translation>Kippung</translation>
    </message>
    <message>
        <source>turn about x</source>
        <translation>Drehung um x</translation>
    </message>
    <message>
        <source>turn about y</source>
        <translation>Drehung um y</translation>
    </message>
    <message>
        <source>turn about z</source>
        <translation>Drehung um z</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>nach vorn</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Root, %1</source>
        <comment>Root, height</comment>
        <translation>Wurzel, %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>Left knee, flexion</comment>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>FieldText</name>
    <message>
        <source>Tip it over and roll it slowly. Keep it 1 m away from tables, radiators and telephones.</source>
        <translation>Kippen und langsam rollen. 1&#xa0;m Abstand zu Tischen, Heizkörpern und Telefonen halten.</translation>
    </message>
    <message>
        <source>All directions were seen: wait a moment</source>
        <translation>Alle Richtungen gesehen: einen Moment warten</translation>
    </message>
    <message>
        <source>%1 is missing, then it is done</source>
        <translation>%1 fehlt noch, dann ist es fertig</translation>
    </message>
    <message>
        <source>Most is missing on this side: %1</source>
        <translation>Hier fehlt am meisten: %1</translation>
    </message>
    <message>
        <source>the right side</source>
        <translation>die rechte Seite</translation>
    </message>
    <message>
        <source>the left side</source>
        <translation>die linke Seite</translation>
    </message>
    <message>
        <source>the upper side</source>
        <translation>die Oberseite</translation>
    </message>
    <message>
        <source>the lower side</source>
        <translation>die Unterseite</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>die Vorderseite</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>die Rückseite</translation>
    </message>
    <message>
        <source>%1 µT ±%2</source>
        <translation>%1&#xa0;µT ±%2</translation>
    </message>
    <message>
        <source>%1 µT</source>
        <translation>%1&#xa0;µT</translation>
    </message>
    <message>
        <source>Turn it more slowly</source>
        <translation>Langsamer drehen</translation>
    </message>
    <message>
        <source>Roll it slowly</source>
        <translation>Langsam rollen</translation>
    </message>
    <message>
        <source>Turn it upside down</source>
        <translation>Auf den Kopf drehen</translation>
    </message>
    <message>
        <source>Tip it onto another side</source>
        <translation>Auf eine andere Seite kippen</translation>
    </message>
    <message>
        <source>The field of this spot is bent by %1</source>
        <translation>Das Magnetfeld ist an dieser Stelle um %1 verzerrt</translation>
    </message>
    <message>
        <source>Steel is near: a table, a radiator, the floor. Go 1 m away from it and carry the suit about again.</source>
        <translation>Stahl ist in der Nähe: ein Tisch, ein Heizkörper, der Boden. 1&#xa0;m davon weggehen und den Anzug noch einmal umhertragen.</translation>
    </message>
    <message>
        <source>Half a metre to each side and up and down, without turning it.</source>
        <translation>Einen halben Meter zu jeder Seite, auf und ab, ohne zu drehen.</translation>
    </message>
    <message>
        <source>The field is even here</source>
        <translation>Das Magnetfeld ist hier gleichmäßig</translation>
    </message>
    <message>
        <source>Every sensor has enough</source>
        <translation>Jeder Sensor hat genug</translation>
    </message>
    <message>
        <source>Go on carrying it about for a moment.</source>
        <translation>Noch einen Moment weiter umhertragen.</translation>
    </message>
    <message>
        <source>The calibration begins by itself.</source>
        <translation>Die Kalibrierung beginnt von selbst.</translation>
    </message>
    <message>
        <source>No magnetometer is heard</source>
        <translation>Kein Magnetometer ist zu hören</translation>
    </message>
    <message>
        <source>Field even</source>
        <translation>Feld gleichmäßig</translation>
    </message>
    <message>
        <source>%1, limit %2</source>
        <translation>%1, Grenze %2</translation>
    </message>
    <message>
        <source>Turning slowly</source>
        <translation>Langsam gedreht</translation>
    </message>
    <message>
        <source>%1°/s, limit %2</source>
        <translation>%1°/s, Grenze %2</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>%1, good: over 90</source>
        <translation>%1, gut: über 90</translation>
    </message>
    <message>
        <source>Lift it and carry it about a little</source>
        <translation>Anheben und ein wenig umhertragen</translation>
    </message>
    <message>
        <source>The field is even down to the floor</source>
        <translation>Das Feld ist bis zum Boden gleichmäßig</translation>
    </message>
    <message>
        <source>Hold it for a moment more.</source>
        <translation>Noch einen Augenblick so halten.</translation>
    </message>
    <message>
        <source>Near the floor the field is %1</source>
        <translation>Am Boden ist das Feld %1</translation>
    </message>
    <message>
        <source>The floor holds steel. Turn the suit up here, at the height of your chest.</source>
        <translation>Im Boden liegt Stahl. Den Anzug oben drehen, in Brusthöhe.</translation>
    </message>
    <message>
        <source>%1 (sensor %2)</source>
        <translation>%1 (Sensor %2)</translation>
    </message>
    <message>
        <source>%1 weaker</source>
        <translation>%1 schwächer</translation>
    </message>
    <message>
        <source>%1 stronger</source>
        <translation>%1 stärker</translation>
    </message>
    <message>
        <source>%1, even within %2</source>
        <translation>%1, gleichmäßig auf %2</translation>
    </message>
    <message>
        <source>not looked at</source>
        <translation>nicht angesehen</translation>
    </message>
    <message>
        <source>%1 of the directions</source>
        <translation>%1 der Richtungen</translation>
    </message>
    <message>
        <source>No sensor is heard</source>
        <translation>Kein Sensor ist zu hören</translation>
    </message>
    <message>
        <source>Step Connect shows which one is missing and why.</source>
        <translation>Der Schritt Verbinden zeigt, welcher fehlt und warum.</translation>
    </message>
    <message>
        <source>The sensors are heard, but send no field. Step Connect shows what they are.</source>
        <translation>Die Sensoren sind zu hören, senden aber kein Feld. Der Schritt Verbinden zeigt, was für welche es sind.</translation>
    </message>
    <message>
        <source>%1 is not heard</source>
        <translation>%1 ist nicht zu hören</translation>
    </message>
    <message numerus="yes">
        <source>Push its plug in until it clicks, or skip it. %n sensor(s) are missing.</source>
        <translation>
            <numerusform>Den Stecker bis zum Klicken eindrücken oder den Sensor auslassen. %n Sensor fehlt.</numerusform>
            <numerusform>Die Stecker bis zum Klicken eindrücken oder die Sensoren auslassen. %n Sensoren fehlen.</numerusform>
        </translation>
    </message>
    <message>
        <source>It is tilted by %1</source>
        <translation>Er ist um %1 geneigt</translation>
    </message>
    <message>
        <source>Hold it as it was when this step began; it is turned later.</source>
        <translation>So halten wie zu Beginn dieses Schrittes; gedreht wird später.</translation>
    </message>
    <message>
        <source>Hold it a hand’s width above the floor</source>
        <translation>Eine Handbreit über den Boden halten</translation>
    </message>
    <message>
        <source>Without turning it, until the ring is full. Then lift it again.</source>
        <translation>Ohne ihn zu drehen, bis der Ring voll ist. Dann wieder anheben.</translation>
    </message>
    <message>
        <source>Every sensor has been turned</source>
        <translation>Jeder Sensor wurde gedreht</translation>
    </message>
    <message>
        <source>Start one anew, begin anew, or use those that are done.</source>
        <translation>Einen neu beginnen, alles neu beginnen oder die fertigen verwenden.</translation>
    </message>
    <message>
        <source>Sensors heard</source>
        <translation>Gehörte Sensoren</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>HeardSwitch</name>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 zu %2</translation>
    </message>
    <message>
        <source>Room to %1</source>
        <translation>Raum zu %1</translation>
    </message>
</context>
<context>
    <name>JobWords</name>
    <message numerus="yes">
        <source>%n s left</source>
        <comment>seconds</comment>
        <translation>
            <numerusform>noch %n&#xa0;s</numerusform>
            <numerusform>noch %n&#xa0;s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n min left</source>
        <comment>minutes</comment>
        <translation>
            <numerusform>noch %n&#xa0;min</numerusform>
            <numerusform>noch %n&#xa0;min</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>title of a job: time left</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>title of a job: its stage</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>title of a job: its stage, time left</comment>
        <translation>%1: %2, %3</translation>
    </message>
</context>
<context>
    <name>LaneLegend</name>
    <message>
        <source>used</source>
        <translation>verwendet</translation>
    </message>
    <message>
        <source>less weight</source>
        <translation>weniger Gewicht</translation>
    </message>
    <message>
        <source>behind</source>
        <translation>von hinten</translation>
    </message>
    <message>
        <source>unsure</source>
        <translation>unsicher</translation>
    </message>
    <message>
        <source>not tried</source>
        <translation>nicht versucht</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
</context>
<context>
    <name>Lanes</name>
    <message>
        <source>Reading the take</source>
        <translation>Die Aufnahme wird gelesen</translation>
    </message>
    <message>
        <source>Process the take to see its curves</source>
        <translation>Die Aufnahme verarbeiten, um ihre Kurven zu sehen</translation>
    </message>
    <message>
        <source>pulse sent, by source</source>
        <translation>Puls gesendet, nach Quelle</translation>
    </message>
    <message>
        <source>arrival detected</source>
        <translation>Ankunft erkannt</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>Der Ton wird gelesen</translation>
    </message>
    <message>
        <source>samples, full scale 1</source>
        <translation>Abtastwerte, Vollausschlag 1</translation>
    </message>
    <message>
        <source>loudest and quietest, full scale 1</source>
        <translation>lautester und leisester Wert, Vollausschlag 1</translation>
    </message>
    <message>
        <source>sound of %1 (full scale 1)</source>
        <translation>Ton von %1 (Vollausschlag 1)</translation>
    </message>
    <message>
        <source>This board sent nothing</source>
        <translation>Diese Platine hat nichts gesendet</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>übersteuert</translation>
    </message>
    <message>
        <source>Raw sound</source>
        <translation>Rohton</translation>
    </message>
    <message>
        <source>Choose a pair in the heat map to see the sound of its board</source>
        <translation>Ein Paar in der Karte wählen, um den Ton seiner Platine zu sehen</translation>
    </message>
    <message>
        <source>This take holds ranges and readings, but not the sound they were taken from</source>
        <translation>Diese Aufnahme enthält Entfernungen und Messwerte, aber nicht den Ton, aus dem sie stammen</translation>
    </message>
    <message>
        <source>Inertial</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>Choose a pair in the heat map to see how its board moved</source>
        <translation>Ein Paar in der Karte wählen, um zu sehen, wie sich seine Platine bewegt hat</translation>
    </message>
    <message>
        <source>gyroscope %2 (rad/s) of %1</source>
        <translation>Gyroskop %2 (rad/s) von %1</translation>
    </message>
    <message>
        <source>accelerometer %2 (m/s2) of %1</source>
        <translation>Beschleunigungssensor %2 (m/s2) von %1</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>ref %1</source>
        <translation>Ref. %1</translation>
    </message>
    <message>
        <source>%1 with 2 sigma</source>
        <translation>%1 mit 2 Sigma</translation>
    </message>
    <message>
        <source>%1 (m), %2</source>
        <translation>%1 (m), %2</translation>
    </message>
    <message>
        <source>%1 (deg), %2</source>
        <translation>%1 (Grad), %2</translation>
    </message>
    <message>
        <source>Joint angles</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>Choose a joint in the report or add one with + to see its angles</source>
        <translation>Im Bericht ein Gelenk wählen oder mit + eines hinzufügen, um seine Winkel zu sehen</translation>
    </message>
    <message>
        <source>Nothing was seen of it</source>
        <translation>Davon war nichts zu sehen</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Wurzel</translation>
    </message>
    <message>
        <source>Nothing was seen of the root</source>
        <translation>Von der Wurzel war nichts zu sehen</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>Choose a pair in the heat map to see its confidence</source>
        <translation>Ein Paar in der Karte wählen, um seine Konfidenz zu sehen</translation>
    </message>
    <message>
        <source>confidence of %1</source>
        <translation>Konfidenz von %1</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>Entfernungen</translation>
    </message>
    <message>
        <source>Choose a pair in the heat map to see its ranges</source>
        <translation>Ein Paar in der Karte wählen, um seine Entfernungen zu sehen</translation>
    </message>
    <message>
        <source>This board never heard this source</source>
        <translation>Diese Platine hat diese Quelle nie gehört</translation>
    </message>
    <message>
        <source>range (m) of %1</source>
        <translation>Entfernung (m) von %1</translation>
    </message>
    <message>
        <source>measured minus expected (m) of %1</source>
        <translation>gemessen minus erwartet (m) von %1</translation>
    </message>
    <message>
        <source>Raw sound of %1</source>
        <translation>Rohton von %1</translation>
    </message>
    <message>
        <source>Turning rate (°/s) of %1</source>
        <translation>Drehrate (°/s) von %1</translation>
    </message>
    <message>
        <source>Acceleration (m/s²) of %1</source>
        <translation>Beschleunigung (m/s²) von %1</translation>
    </message>
    <message>
        <source>%1 (m)</source>
        <translation>%1 (m)</translation>
    </message>
    <message>
        <source>Range (m), %1</source>
        <translation>Entfernung (m), %1</translation>
    </message>
    <message>
        <source>Measured minus expected (mm), %1</source>
        <translation>Gemessen minus erwartet (mm), %1</translation>
    </message>
    <message>
        <source>result %1</source>
        <translation>Ergebnis %1</translation>
    </message>
    <message>
        <source>%1 of %2 to %3 of %4 (m)</source>
        <translation>%1 von %2 – %3 von %4 (m)</translation>
    </message>
    <message>
        <source>Processing…</source>
        <translation>Wird verarbeitet&#xa0;…</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Between performers</source>
        <translation>Zwischen Darstellern</translation>
    </message>
    <message>
        <source>The shown result holds one performer only</source>
        <translation>Das gezeigte Ergebnis enthält nur einen Darsteller</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>Licences</name>
    <message>
        <source>windows and controls</source>
        <translation>Fenster und Bedienelemente</translation>
    </message>
    <message>
        <source>plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>linear algebra</source>
        <translation>lineare Algebra</translation>
    </message>
    <message>
        <source>public domain</source>
        <translation>gemeinfrei</translation>
    </message>
    <message>
        <source>take files</source>
        <translation>Aufnahmedateien</translation>
    </message>
    <message>
        <source>compression of takes</source>
        <translation>Kompression der Aufnahmen</translation>
    </message>
    <message>
        <source>meshes</source>
        <translation>Körpernetze</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>settings and documents</source>
        <translation>Einstellungen und Dokumente</translation>
    </message>
    <message>
        <source>typeface</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>markers in photographs, films</source>
        <translation>Marken in Fotografien, Filme</translation>
    </message>
</context>
<context>
    <name>LiveText</name>
    <message>
        <source>Board %1, %2, is silent</source>
        <translation>Platine %1, %2, ist stumm</translation>
    </message>
    <message>
        <source>Push its plug in until it clicks; if the light stays dark, change the cable. Or skip it. %1</source>
        <translation>Den Stecker eindrücken, bis er klickt; bleibt das Licht dunkel, das Kabel wechseln. Oder die Platine auslassen. %1</translation>
    </message>
    <message numerus="yes">
        <source>%n other(s) are silent too.</source>
        <translation>
            <numerusform>%n weitere Platine ist auch stumm.</numerusform>
            <numerusform>%n weitere Platinen sind auch stumm.</numerusform>
        </translation>
    </message>
    <message>
        <source>Wait: %1 still moves</source>
        <translation>Warten: %1 noch in Bewegung</translation>
    </message>
    <message>
        <source>Wait: board %1 still moves</source>
        <translation>Warten: Platine %1 bewegt sich noch</translation>
    </message>
    <message>
        <source>Let go of it and wait until it lies still. %1</source>
        <translation>Loslassen und warten, bis sie still liegt. %1</translation>
    </message>
    <message>
        <source>Not yet: board %1 lies on another side</source>
        <translation>Noch nicht: Platine %1 liegt auf einer anderen Seite</translation>
    </message>
    <message>
        <source>Board %1, %2, is turned in its slot. Turn it as its neighbours are and press it in. %3</source>
        <translation>Platine %1, %2, ist in ihrem Fach verdreht. Wie ihre Nachbarn ausrichten und eindrücken. %3</translation>
    </message>
    <message>
        <source>Not yet: board %1 sits %2 askew in its slot</source>
        <translation>Noch nicht: Platine %1 sitzt um %2 schief in ihrem Fach</translation>
    </message>
    <message numerus="yes">
        <source>%n board(s) are level. Press board %1 into its slot until it clicks, then let go of the plate.</source>
        <translation>
            <numerusform>%n Platine sitzt gerade. Platine %1 in ihr Fach drücken, bis sie einrastet, dann die Platte loslassen.</numerusform>
            <numerusform>%n Platinen sitzen gerade. Platine %1 in ihr Fach drücken, bis sie einrastet, dann die Platte loslassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Start the table</source>
        <translation>Den Drehteller starten</translation>
    </message>
    <message>
        <source>33 1/3, 45 or 78 turns a minute, whichever it does best.</source>
        <translation>33 1/3, 45 oder 78 Umdrehungen je Minute, was er am besten kann.</translation>
    </message>
    <message>
        <source>Wait: %1 rpm</source>
        <translation>Warten: %1&#xa0;U/min</translation>
    </message>
    <message>
        <source>The table has not found its speed yet, or something makes it waver.</source>
        <translation>Der Drehteller hat seine Drehzahl noch nicht gefunden, oder etwas lässt ihn schwanken.</translation>
    </message>
    <message>
        <source>Too fast: %1 rpm</source>
        <translation>Zu schnell: %1&#xa0;U/min</translation>
    </message>
    <message>
        <source>That is more than 80 % of what the gyroscope of board %1 can measure. Set the table to a slower speed.</source>
        <translation>Das ist mehr als 80&#xa0;% dessen, was das Gyroskop von Platine %1 messen kann. Den Drehteller langsamer stellen.</translation>
    </message>
    <message>
        <source>%1 rpm: wait</source>
        <translation>%1&#xa0;U/min: warten</translation>
    </message>
    <message>
        <source>That is none of the usual speeds, 33 1/3, 45 and 78. Set the table to one of them.</source>
        <translation>Das ist keine der üblichen Drehzahlen, 33 1/3, 45 und 78. Den Drehteller auf eine davon stellen.</translation>
    </message>
    <message>
        <source>No board is heard</source>
        <translation>Keine Platine ist zu hören</translation>
    </message>
    <message>
        <source>None of the measured placements is heard</source>
        <translation>Keine der gemessenen Aufstellungen ist zu hören</translation>
    </message>
    <message>
        <source>The distances heard differ from all those in the file by more than 2 cm. Put boards and sources as they were measured.</source>
        <translation>Die gehörten Abstände weichen von allen in der Datei um mehr als 2&#xa0;cm ab. Platinen und Quellen so aufstellen, wie sie gemessen wurden.</translation>
    </message>
    <message>
        <source>Turn the plate onto a side</source>
        <translation>Die Platte auf eine Seite drehen</translation>
    </message>
    <message>
        <source>It lies between two sides, or is in somebody’s hands.</source>
        <translation>Sie liegt zwischen zwei Seiten oder ist in jemandes Händen.</translation>
    </message>
    <message>
        <source>Only %1 of the pairs are heard</source>
        <translation>Nur %1 der Paare sind zu hören</translation>
    </message>
    <message>
        <source>Let boards and sources face each other, and take away what stands in between.</source>
        <translation>Platinen und Quellen einander zuwenden und wegnehmen, was dazwischen steht.</translation>
    </message>
    <message>
        <source>%1 is done</source>
        <translation>Fertig: %1</translation>
    </message>
    <message>
        <source>%1 rpm, even. Nothing touches the table.</source>
        <translation>%1&#xa0;U/min, gleichmäßig. Nichts berührt den Drehteller.</translation>
    </message>
    <message numerus="yes">
        <source>All %n board(s) are in place. Nothing touches them.</source>
        <translation>
            <numerusform>%n Platine ist am Platz. Nichts berührt sie.</numerusform>
            <numerusform>Alle %n Platinen sind am Platz. Nichts berührt sie.</numerusform>
        </translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>Erfasst</translation>
    </message>
    <message>
        <source>It is being written to disk.</source>
        <translation>Wird auf den Datenträger geschrieben.</translation>
    </message>
    <message>
        <source>The suit has gone</source>
        <translation>Der Anzug ist nicht mehr da</translation>
    </message>
    <message>
        <source>What has been taken is safe. It goes on when the driver box is back.</source>
        <translation>Was erfasst ist, ist sicher. Es geht weiter, wenn die Steuerbox wieder da ist.</translation>
    </message>
    <message>
        <source>Right. Hold it for %1</source>
        <translation>Richtig. Noch %1 so halten</translation>
    </message>
    <message>
        <source>Plate level</source>
        <translation>Platte waagrecht</translation>
    </message>
    <message>
        <source>%1, limit %2</source>
        <translation>%1, Grenze %2</translation>
    </message>
    <message>
        <source>from the second side on</source>
        <translation>ab der zweiten Seite</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>%1 rpm</source>
        <translation>%1&#xa0;U/min</translation>
    </message>
    <message>
        <source>Pairs heard</source>
        <translation>Gehörte Paare</translation>
    </message>
    <message>
        <source>Still</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>%1 m/s², limit %2</source>
        <translation>%1&#xa0;m/s², Grenze %2</translation>
    </message>
    <message>
        <source>Boards in place</source>
        <translation>Platinen am Platz</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 is left out: each offset rests on one board less.</source>
        <translation>%1 wird ausgelassen: jeder Versatz stützt sich auf eine Platine weniger.</translation>
    </message>
    <message>
        <source>%1 is left out: it keeps the values it had before.</source>
        <translation>%1 wird ausgelassen: ihre früheren Werte bleiben.</translation>
    </message>
    <message>
        <source>%1 is left out: how it sits today stays unknown.</source>
        <translation>%1 wird ausgelassen: wie sie heute sitzt, bleibt unbekannt.</translation>
    </message>
    <message>
        <source>Once more: %1 hardly moved</source>
        <translation>Noch einmal: %1 hat sich kaum bewegt</translation>
    </message>
    <message>
        <source>Stand still in the rest pose, then: %1. %2</source>
        <translation>In der Ruhehaltung still stehen, dann: %1. %2</translation>
    </message>
    <message>
        <source>The file’s distances are %1 times those heard</source>
        <translation>Die Abstände der Datei sind das %1-Fache der gehörten</translation>
    </message>
    <message>
        <source>Stand still for %1</source>
        <translation>%1 lang still stehen</translation>
    </message>
    <message>
        <source>Move now</source>
        <translation>Jetzt bewegen</translation>
    </message>
    <message>
        <source>Smoothly and as far as is comfortable, until the ring is full.</source>
        <translation>Fließend und so weit, wie es angenehm ist, bis der Ring voll ist.</translation>
    </message>
    <message>
        <source>Smoothly and as far as is comfortable.</source>
        <translation>Fließend und so weit, wie es angenehm ist.</translation>
    </message>
    <message>
        <source>Go on for %1</source>
        <translation>Noch %1 weiter</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message numerus="yes">
        <source>%n other(s) are turned too.</source>
        <translation>
            <numerusform>Eine weitere ist auch verdreht.</numerusform>
            <numerusform>%n weitere sind auch verdreht.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other(s) move too.</source>
        <translation>
            <numerusform>Eine weitere bewegt sich auch.</numerusform>
            <numerusform>%n weitere bewegen sich auch.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other(s) hardly moved either.</source>
        <translation>
            <numerusform>Eine weitere hat sich auch kaum bewegt.</numerusform>
            <numerusform>%n weitere haben sich auch kaum bewegt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Step Connect shows which board is missing and why.</source>
        <translation>Der Schritt Verbinden zeigt, welche Platine fehlt und warum.</translation>
    </message>
    <message>
        <source>Go on with what is asked above.</source>
        <translation>Weiter mit dem, was oben steht.</translation>
    </message>
    <message>
        <source>Stay like that, all boards are still.</source>
        <translation>So bleiben, alle Platinen sind ruhig.</translation>
    </message>
    <message>
        <source>Its numbers are in another unit than their heading says. Correct the heading (x_m or x_mm, distance_m or distance_mm), leave and choose the file again.</source>
        <translation>Ihre Zahlen haben eine andere Einheit, als ihre Überschrift sagt. Überschrift berichtigen (x_m oder x_mm, distance_m oder distance_mm), verlassen und die Datei neu wählen.</translation>
    </message>
    <message>
        <source>Stay in the rest pose and breathe calmly. %1</source>
        <translation>In der Ruhehaltung bleiben und ruhig atmen. %1</translation>
    </message>
    <message>
        <source>In the rest pose: arms a little away from the body, elbows slightly bent, palms towards the body.</source>
        <translation>In der Ruhehaltung: Arme etwas vom Körper weg, Ellbogen leicht gebeugt, Handflächen zum Körper.</translation>
    </message>
</context>
<context>
    <name>Measures</name>
    <message>
        <source>Upper arm</source>
        <translation>Oberarm</translation>
    </message>
    <message>
        <source>From the point of the shoulder to the elbow</source>
        <translation>Von der Schulterspitze bis zum Ellbogen</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>Unterarm</translation>
    </message>
    <message>
        <source>From the elbow to the wrist</source>
        <translation>Vom Ellbogen bis zum Handgelenk</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>From the wrist to the tip of the middle finger</source>
        <translation>Vom Handgelenk bis zur Spitze des Mittelfingers</translation>
    </message>
    <message>
        <source>Shoulder width</source>
        <translation>Schulterbreite</translation>
    </message>
    <message>
        <source>From shoulder joint to shoulder joint, about 4 cm less than outside</source>
        <translation>Von Schultergelenk zu Schultergelenk, etwa 4&#xa0;cm weniger als außen</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Rumpf</translation>
    </message>
    <message>
        <source>From the hip joints to the base of the neck</source>
        <translation>Von den Hüftgelenken bis zum Halsansatz</translation>
    </message>
    <message>
        <source>Hip width</source>
        <translation>Hüftbreite</translation>
    </message>
    <message>
        <source>From hip joint to hip joint, about half the width outside</source>
        <translation>Von Hüftgelenk zu Hüftgelenk, etwa halb so breit wie außen</translation>
    </message>
    <message>
        <source>Thigh</source>
        <translation>Oberschenkel</translation>
    </message>
    <message>
        <source>From the hip joint to the middle of the knee</source>
        <translation>Vom Hüftgelenk bis zur Mitte des Knies</translation>
    </message>
    <message>
        <source>Shin</source>
        <translation>Unterschenkel</translation>
    </message>
    <message>
        <source>From the middle of the knee to the ankle</source>
        <translation>Von der Mitte des Knies bis zum Knöchel</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>From the ankle forward to the ball of the foot</source>
        <translation>Vom Knöchel nach vorn bis zum Ballen</translation>
    </message>
</context>
<context>
    <name>PartNames</name>
    <message>
        <source>Room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>Pelvis</source>
        <translation>Becken</translation>
    </message>
    <message>
        <source>pelvis</source>
        <translation>Becken</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Bauch</translation>
    </message>
    <message>
        <source>abdomen</source>
        <translation>Bauch</translation>
    </message>
    <message>
        <source>Chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Left clavicle</source>
        <translation>Linkes Schlüsselbein</translation>
    </message>
    <message>
        <source>left clavicle</source>
        <translation>linkes Schlüsselbein</translation>
    </message>
    <message>
        <source>Left upper arm</source>
        <translation>Linker Oberarm</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>linker Oberarm</translation>
    </message>
    <message>
        <source>Left forearm</source>
        <translation>Linker Unterarm</translation>
    </message>
    <message>
        <source>left forearm</source>
        <translation>linker Unterarm</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>Left thigh</source>
        <translation>Linker Oberschenkel</translation>
    </message>
    <message>
        <source>left thigh</source>
        <translation>linker Oberschenkel</translation>
    </message>
    <message>
        <source>Left shin</source>
        <translation>Linker Unterschenkel</translation>
    </message>
    <message>
        <source>left shin</source>
        <translation>linker Unterschenkel</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Linker Fuß</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>linker Fuß</translation>
    </message>
    <message>
        <source>Left toes</source>
        <translation>Linke Zehen</translation>
    </message>
    <message>
        <source>left toes</source>
        <translation>linke Zehen</translation>
    </message>
    <message>
        <source>Right clavicle</source>
        <translation>Rechtes Schlüsselbein</translation>
    </message>
    <message>
        <source>right clavicle</source>
        <translation>rechtes Schlüsselbein</translation>
    </message>
    <message>
        <source>Right upper arm</source>
        <translation>Rechter Oberarm</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>rechter Oberarm</translation>
    </message>
    <message>
        <source>Right forearm</source>
        <translation>Rechter Unterarm</translation>
    </message>
    <message>
        <source>right forearm</source>
        <translation>rechter Unterarm</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>Right thigh</source>
        <translation>Rechter Oberschenkel</translation>
    </message>
    <message>
        <source>right thigh</source>
        <translation>rechter Oberschenkel</translation>
    </message>
    <message>
        <source>Right shin</source>
        <translation>Rechter Unterschenkel</translation>
    </message>
    <message>
        <source>right shin</source>
        <translation>rechter Unterschenkel</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Rechter Fuß</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>rechter Fuß</translation>
    </message>
    <message>
        <source>Right toes</source>
        <translation>Rechte Zehen</translation>
    </message>
    <message>
        <source>right toes</source>
        <translation>rechte Zehen</translation>
    </message>
    <message>
        <source>Lower back</source>
        <translation>Unterer Rücken</translation>
    </message>
    <message>
        <source>lower back</source>
        <translation>unterer Rücken</translation>
    </message>
    <message>
        <source>Upper back</source>
        <translation>Oberer Rücken</translation>
    </message>
    <message>
        <source>upper back</source>
        <translation>oberer Rücken</translation>
    </message>
    <message>
        <source>Base of the neck</source>
        <translation>Halsansatz</translation>
    </message>
    <message>
        <source>base of the neck</source>
        <translation>Halsansatz</translation>
    </message>
    <message>
        <source>Left shoulder</source>
        <translation>Linke Schulter</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>linke Schulter</translation>
    </message>
    <message>
        <source>Left elbow</source>
        <translation>Linker Ellbogen</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>linker Ellbogen</translation>
    </message>
    <message>
        <source>Left wrist</source>
        <translation>Linkes Handgelenk</translation>
    </message>
    <message>
        <source>left wrist</source>
        <translation>linkes Handgelenk</translation>
    </message>
    <message>
        <source>Left hip</source>
        <translation>Linke Hüfte</translation>
    </message>
    <message>
        <source>left hip</source>
        <translation>linke Hüfte</translation>
    </message>
    <message>
        <source>Left knee</source>
        <translation>Linkes Knie</translation>
    </message>
    <message>
        <source>left knee</source>
        <translation>linkes Knie</translation>
    </message>
    <message>
        <source>Left ankle</source>
        <translation>Linkes Sprunggelenk</translation>
    </message>
    <message>
        <source>left ankle</source>
        <translation>linkes Sprunggelenk</translation>
    </message>
    <message>
        <source>Right shoulder</source>
        <translation>Rechte Schulter</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>rechte Schulter</translation>
    </message>
    <message>
        <source>Right elbow</source>
        <translation>Rechter Ellbogen</translation>
    </message>
    <message>
        <source>right elbow</source>
        <translation>rechter Ellbogen</translation>
    </message>
    <message>
        <source>Right wrist</source>
        <translation>Rechtes Handgelenk</translation>
    </message>
    <message>
        <source>right wrist</source>
        <translation>rechtes Handgelenk</translation>
    </message>
    <message>
        <source>Right hip</source>
        <translation>Rechte Hüfte</translation>
    </message>
    <message>
        <source>right hip</source>
        <translation>rechte Hüfte</translation>
    </message>
    <message>
        <source>Right knee</source>
        <translation>Rechtes Knie</translation>
    </message>
    <message>
        <source>right knee</source>
        <translation>rechtes Knie</translation>
    </message>
    <message>
        <source>Right ankle</source>
        <translation>Rechtes Sprunggelenk</translation>
    </message>
    <message>
        <source>right ankle</source>
        <translation>rechtes Sprunggelenk</translation>
    </message>
    <message>
        <source>Chest, left</source>
        <translation>Brust links</translation>
    </message>
    <message>
        <source>chest, left</source>
        <translation>Brust links</translation>
    </message>
    <message>
        <source>Chest, right</source>
        <translation>Brust rechts</translation>
    </message>
    <message>
        <source>chest, right</source>
        <translation>Brust rechts</translation>
    </message>
    <message>
        <source>Ribs, left</source>
        <translation>Rippen links</translation>
    </message>
    <message>
        <source>ribs, left</source>
        <translation>Rippen links</translation>
    </message>
    <message>
        <source>Ribs, right</source>
        <translation>Rippen rechts</translation>
    </message>
    <message>
        <source>ribs, right</source>
        <translation>Rippen rechts</translation>
    </message>
    <message>
        <source>Navel</source>
        <translation>Nabel</translation>
    </message>
    <message>
        <source>navel</source>
        <translation>Nabel</translation>
    </message>
    <message>
        <source>Belly, left</source>
        <translation>Bauch links</translation>
    </message>
    <message>
        <source>belly, left</source>
        <translation>Bauch links</translation>
    </message>
    <message>
        <source>Belly, right</source>
        <translation>Bauch rechts</translation>
    </message>
    <message>
        <source>belly, right</source>
        <translation>Bauch rechts</translation>
    </message>
    <message>
        <source>Hat</source>
        <translation>Hut</translation>
    </message>
    <message>
        <source>hat</source>
        <translation>Hut</translation>
    </message>
    <message>
        <source>%1 (board %2)</source>
        <comment>Left shin (board 14)</comment>
        <translation>%1 (Platine %2)</translation>
    </message>
    <message>
        <source>board %1 (%2)</source>
        <comment>board 14 (left shin)</comment>
        <translation>Platine %1 (%2)</translation>
    </message>
    <message>
        <source>source %1 (%2)</source>
        <comment>source 8 (hat)</comment>
        <translation>Quelle %1 (%2)</translation>
    </message>
    <message>
        <source>Source %1 (%2)</source>
        <comment>Source 8 (hat)</comment>
        <translation>Quelle %1 (%2)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>source 8 (hat) to left shin</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Rumpf</translation>
    </message>
    <message>
        <source>L arm</source>
        <comment>left arm, short</comment>
        <translation>L Arm</translation>
    </message>
    <message>
        <source>R arm</source>
        <comment>right arm, short</comment>
        <translation>R Arm</translation>
    </message>
    <message>
        <source>L leg</source>
        <comment>left leg, short</comment>
        <translation>L Bein</translation>
    </message>
    <message>
        <source>R leg</source>
        <comment>right leg, short</comment>
        <translation>R Bein</translation>
    </message>
    <message>
        <source>Elsewhere</source>
        <comment>boards that sit on no known part of the body</comment>
        <translation>Anderswo</translation>
    </message>
</context>
<context>
    <name>PerformerSwitch</name>
    <message>
        <source>Performer %1</source>
        <translation>Darsteller %1</translation>
    </message>
</context>
<context>
    <name>PlotPanel</name>
    <message>
        <source>%1 is written</source>
        <translation>%1 ist geschrieben</translation>
    </message>
</context>
<context>
    <name>SceneOverlay</name>
    <message>
        <source>Ray confidence, source to board</source>
        <translation>Konfidenz der Strahlen, Quelle zu Platine</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a distance and between which joints</comment>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>SessionCommands</name>
    <message>
        <source>Open session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>Choose takes</source>
        <translation>Aufnahmen wählen</translation>
    </message>
    <message>
        <source>Takes (*.noctule)</source>
        <translation>Aufnahmen (*.noctule)</translation>
    </message>
    <message>
        <source>Choose a motion</source>
        <translation>Eine Bewegung wählen</translation>
    </message>
    <message>
        <source>Motions (*.bvh *.fbx *.glb *.gltf *.vrm *.dae)</source>
        <translation>Bewegungen (*.bvh *.fbx *.glb *.gltf *.vrm *.dae)</translation>
    </message>
    <message>
        <source>Choose the files of one recording</source>
        <translation>Dateien einer Aufzeichnung wählen</translation>
    </message>
    <message>
        <source>Recordings of sensors (*.mat *.mvnx *.txt *.ximu3 *.sto *.csv *.tsv)</source>
        <translation>Aufzeichnungen von Sensoren (*.mat *.mvnx *.txt *.ximu3 *.sto *.csv *.tsv)</translation>
    </message>
</context>
<context>
    <name>TransportBar</name>
    <message>
        <source>%1×</source>
        <comment>speed of playback</comment>
        <translation>%1×</translation>
    </message>
</context>
<context>
    <name>WizardTask</name>
    <message>
        <source>edge C down</source>
        <translation>Kante C unten</translation>
    </message>
    <message>
        <source>Stand the plate on edge C, against the block</source>
        <translation>Platte auf Kante C stellen, gegen den Block</translation>
    </message>
    <message>
        <source>Stand the plate on edge C and start the table</source>
        <translation>Platte auf Kante C stellen und den Drehteller starten</translation>
    </message>
    <message>
        <source>edge D down</source>
        <translation>Kante D unten</translation>
    </message>
    <message>
        <source>Stand the plate on edge D, against the block</source>
        <translation>Platte auf Kante D stellen, gegen den Block</translation>
    </message>
    <message>
        <source>Stand the plate on edge D and start the table</source>
        <translation>Platte auf Kante D stellen und den Drehteller starten</translation>
    </message>
    <message>
        <source>edge B down</source>
        <translation>Kante B unten</translation>
    </message>
    <message>
        <source>Stand the plate on edge B, against the block</source>
        <translation>Platte auf Kante B stellen, gegen den Block</translation>
    </message>
    <message>
        <source>Stand the plate on edge B and start the table</source>
        <translation>Platte auf Kante B stellen und den Drehteller starten</translation>
    </message>
    <message>
        <source>edge A down</source>
        <translation>Kante A unten</translation>
    </message>
    <message>
        <source>Stand the plate on edge A, against the block</source>
        <translation>Platte auf Kante A stellen, gegen den Block</translation>
    </message>
    <message>
        <source>Stand the plate on edge A and start the table</source>
        <translation>Platte auf Kante A stellen und den Drehteller starten</translation>
    </message>
    <message>
        <source>face up</source>
        <translation>Vorderseite oben</translation>
    </message>
    <message>
        <source>Lay the plate flat, face up</source>
        <translation>Platte flach legen, Vorderseite oben</translation>
    </message>
    <message>
        <source>Lay the plate flat, face up, and start the table</source>
        <translation>Platte flach legen, Vorderseite oben, und den Drehteller starten</translation>
    </message>
    <message>
        <source>face down</source>
        <translation>Vorderseite unten</translation>
    </message>
    <message>
        <source>Lay the plate flat, face down</source>
        <translation>Platte flach legen, Vorderseite unten</translation>
    </message>
    <message>
        <source>Lay the plate flat, face down, and start the table</source>
        <translation>Platte flach legen, Vorderseite unten, und den Drehteller starten</translation>
    </message>
    <message>
        <source>Source offsets</source>
        <translation>Quellenversatz</translation>
    </message>
    <message>
        <source>How late each source sounds, so that distances are right to the millimetre.</source>
        <translation>Wie spät jede Quelle tönt, damit Entfernungen auf den Millimeter stimmen.</translation>
    </message>
    <message>
        <source>Suit on its jig, about 6 minutes; once a year</source>
        <translation>Anzug auf seinem Messgestell, etwa 6 Minuten; einmal im Jahr</translation>
    </message>
    <message>
        <source>The jig with boards and sources in their seats, 30 to 90 cm apart</source>
        <translation>Das Messgestell mit Platinen und Quellen auf ihren Plätzen, 30 bis 90&#xa0;cm voneinander entfernt</translation>
    </message>
    <message>
        <source>The distances between them: points of a digitizer arm or a tape measure, as CSV</source>
        <translation>Die Abstände zwischen ihnen: Punkte eines Messarms oder Maßband, als CSV</translation>
    </message>
    <message>
        <source>A quiet room and a thermometer in the driver box</source>
        <translation>Ein stiller Raum und ein Thermometer in der Steuerbox</translation>
    </message>
    <message>
        <source>Boards and sources face each other and nothing stands between them. Box and wires stay where they are; only the stands move from one placement to the next.</source>
        <translation>Platinen und Quellen sind einander zugewandt, und nichts steht dazwischen. Box und Kabel bleiben, wo sie sind; von einer Aufstellung zur nächsten bewegen sich nur die Ständer.</translation>
    </message>
    <message>
        <source>Placements may come in any order. The page hears by itself which one stands there.</source>
        <translation>Die Reihenfolge der Aufstellungen ist frei. Die Anzeige hört von selbst, welche gerade steht.</translation>
    </message>
    <message>
        <source>Accelerometers</source>
        <translation>Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>Scale, zero and axes of each accelerometer.</source>
        <translation>Maßstab, Nullpunkt und Achsen jedes Beschleunigungssensors.</translation>
    </message>
    <message>
        <source>Boards on the level plate, six sides, about 4 minutes; every three months</source>
        <translation>Platinen auf der waagrechten Platte, sechs Seiten, etwa 4 Minuten; alle drei Monate</translation>
    </message>
    <message>
        <source>The plate with all boards pressed into their slots, up to 32 at once</source>
        <translation>Die Platte mit allen Platinen in ihre Fächer gedrückt, bis zu 32 zugleich</translation>
    </message>
    <message>
        <source>Box and wires lie beside the plate with a metre of slack, so that nothing pulls at it when it is turned.</source>
        <translation>Box und Kabel liegen neben der Platte mit einem Meter Spiel, damit beim Drehen nichts an ihr zieht.</translation>
    </message>
    <message>
        <source>Sides may come in any order. The page sees by itself which one is down.</source>
        <translation>Die Reihenfolge der Seiten ist frei. Die Anzeige erkennt von selbst, welche unten liegt.</translation>
    </message>
    <message>
        <source>Gyroscopes</source>
        <translation>Gyroskope</translation>
    </message>
    <message>
        <source>Scale, zero and axes of each gyroscope.</source>
        <translation>Maßstab, Nullpunkt und Achsen jedes Gyroskops.</translation>
    </message>
    <message>
        <source>Boards on the turntable, six sides, about 5 minutes; every three months</source>
        <translation>Platinen auf dem Drehteller, sechs Seiten, etwa 5 Minuten; alle drei Monate</translation>
    </message>
    <message>
        <source>A turntable at 45, 33 1/3 or 78 turns a minute that carries the plate and the driver box</source>
        <translation>Ein Drehteller mit 45, 33 1/3 oder 78 Umdrehungen je Minute, der Platte und Steuerbox trägt</translation>
    </message>
    <message>
        <source>The plate with all boards pressed into their slots</source>
        <translation>Die Platte mit allen Platinen in ihre Fächer gedrückt</translation>
    </message>
    <message>
        <source>A wireless or battery driver box, or a cable with a swivel</source>
        <translation>Eine Steuerbox mit Funk oder Akku oder ein Kabel mit Drehgelenk</translation>
    </message>
    <message>
        <source>The box rides on the table beside the plate, its wires taped down. With a cable to the computer instead, ten turns wind it up as far as is safe: stop after each side and unwind.</source>
        <translation>Die Box fährt neben der Platte auf dem Drehteller mit, ihre Kabel sind festgeklebt. Mit einem Kabel zum Rechner ist nach zehn Umdrehungen so viel aufgewickelt, wie sicher ist: nach jeder Seite anhalten und abwickeln.</translation>
    </message>
    <message>
        <source>Sides may come in any order. The page sees by itself which one turns.</source>
        <translation>Die Reihenfolge der Seiten ist frei. Die Anzeige erkennt von selbst, welche sich dreht.</translation>
    </message>
    <message>
        <source>Rest pose</source>
        <translation>Ruhehaltung</translation>
    </message>
    <message>
        <source>How the boards sit on the performer today.</source>
        <translation>Wie die Platinen heute am Darsteller sitzen.</translation>
    </message>
    <message>
        <source>Stand still for 5 seconds; each time the suit is put on</source>
        <translation>5 Sekunden still stehen; bei jedem Anlegen des Anzugs</translation>
    </message>
    <message>
        <source>The performer with the suit on, all straps tight</source>
        <translation>Der Darsteller im Anzug, alle Gurte fest</translation>
    </message>
    <message>
        <source>Two metres of free floor</source>
        <translation>Zwei Meter freier Boden</translation>
    </message>
    <message>
        <source>After Begin it counts by itself as soon as the performer stands still.</source>
        <translation>Nach „Beginnen“ zählt es von selbst, sobald der Darsteller still steht.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Kontrolle</translation>
    </message>
    <message>
        <source>Stand still for 3 seconds; before each take that matters</source>
        <translation>3 Sekunden still stehen; vor jeder Aufnahme, auf die es ankommt</translation>
    </message>
    <message>
        <source>The performer with the suit on, and a calibration in force</source>
        <translation>Der Darsteller im Anzug und eine gültige Kalibrierung</translation>
    </message>
    <message>
        <source>Placement %1</source>
        <translation>Aufstellung %1</translation>
    </message>
    <message>
        <source>as it was measured</source>
        <translation>wie gemessen</translation>
    </message>
    <message>
        <source>Put boards and sources as in placement %1</source>
        <translation>Platinen und Quellen wie in Aufstellung %1 aufstellen</translation>
    </message>
    <message>
        <source>Side %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Drehung %1</translation>
    </message>
    <message>
        <source>Stand still</source>
        <translation>Still stehen</translation>
    </message>
    <message>
        <source>rest pose</source>
        <translation>Ruhehaltung</translation>
    </message>
    <message>
        <source>Stand still in the rest pose</source>
        <translation>In der Ruhehaltung still stehen</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Six exercises, about 2 minutes; after the rest pose, each time the suit is put on</source>
        <translation>Sechs Übungen, etwa 2 Minuten; nach der Ruhehaltung, bei jedem Anlegen des Anzugs</translation>
    </message>
    <message>
        <source>The performer with the suit on, all straps tight, the rest pose calibrated</source>
        <translation>Der Darsteller im Anzug, alle Gurte fest, die Ruhehaltung kalibriert</translation>
    </message>
    <message>
        <source>Two metres of free floor in all directions</source>
        <translation>Zwei Meter freier Boden nach allen Seiten</translation>
    </message>
    <message>
        <source>One exercise after the other. The page sees when you stand and when you move.</source>
        <translation>Eine Übung nach der anderen. Die Anzeige erkennt, wann man steht und wann man sich bewegt.</translation>
    </message>
    <message>
        <source>Squats</source>
        <translation>Kniebeugen</translation>
    </message>
    <message>
        <source>Squat, bend the elbows and turn the hands</source>
        <translation>In die Knie gehen, die Ellbogen beugen und die Hände drehen</translation>
    </message>
    <message>
        <source>Arm circles</source>
        <translation>Armkreisen</translation>
    </message>
    <message>
        <source>Circle both arms, large and slowly</source>
        <translation>Beide Arme kreisen, groß und langsam</translation>
    </message>
    <message>
        <source>Leg swings</source>
        <translation>Beinschwingen</translation>
    </message>
    <message>
        <source>Swing one leg, then the other; bend knees and feet</source>
        <translation>Ein Bein schwingen, dann das andere; Knie und Füße beugen</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Rumpf</translation>
    </message>
    <message>
        <source>Bend and turn the trunk to all sides</source>
        <translation>Den Rumpf nach allen Seiten beugen und drehen</translation>
    </message>
    <message>
        <source>Head and shoulders</source>
        <translation>Kopf und Schultern</translation>
    </message>
    <message>
        <source>Nod and turn the head, shrug, roll the wrists</source>
        <translation>Nicken, den Kopf drehen, die Schultern heben, die Handgelenke kreisen</translation>
    </message>
    <message>
        <source>March</source>
        <translation>Marschieren</translation>
    </message>
    <message>
        <source>March on the spot and swing the arms</source>
        <translation>Auf der Stelle marschieren und die Arme schwingen</translation>
    </message>
    <message>
        <source>from the rest pose</source>
        <translation>aus der Ruhehaltung</translation>
    </message>
    <message>
        <source>How each board sits on the moving body; lengths of bones and places of sources too.</source>
        <translation>Wie jede Platine am bewegten Körper sitzt; dazu Längen der Knochen und Orte der Quellen.</translation>
    </message>
    <message>
        <source>Put boards and sources on the jig</source>
        <translation>Platinen und Quellen auf das Messgestell setzen</translation>
    </message>
    <message>
        <source>A level table (use a spirit level), and a square block to lean the plate on</source>
        <translation>Ein waagrechter Tisch (mit der Wasserwaage prüfen) und ein rechtwinkliger Block zum Anlehnen der Platte</translation>
    </message>
    <message>
        <source>Press all boards into the plate</source>
        <translation>Alle Platinen in die Platte drücken</translation>
    </message>
    <message>
        <source>Put the plate and the box on the turntable</source>
        <translation>Platte und Box auf den Drehteller legen</translation>
    </message>
    <message>
        <source>Stand in the rest pose</source>
        <translation>In der Ruhehaltung stehen</translation>
    </message>
    <message>
        <source>Stand ready in the rest pose</source>
        <translation>In der Ruhehaltung bereitstehen</translation>
    </message>
    <message>
        <source>Says whether the calibration still holds, or which strap has slipped.</source>
        <translation>Sagt, ob die Kalibrierung noch gilt oder welcher Gurt verrutscht ist.</translation>
    </message>
    <message>
        <source>Stand still for three seconds</source>
        <translation>Drei Sekunden still stehen</translation>
    </message>
    <message>
        <source>Magnetometers</source>
        <translation>Magnetometer</translation>
    </message>
    <message>
        <source>What the iron of each board does to the Earth’s field, so that headings hold.</source>
        <translation>Was das Eisen jeder Platine mit dem Erdmagnetfeld macht, damit Richtungen halten.</translation>
    </message>
    <message>
        <source>A bag, 1 m from steel, 2 minutes; every three months</source>
        <translation>Ein Beutel, 1&#xa0;m von Stahl entfernt, 2 Minuten; alle drei Monate</translation>
    </message>
    <message>
        <source>The suit, off the body, in a bag or in both hands; one sensor alone will do too</source>
        <translation>Der abgelegte Anzug in einem Beutel oder in beiden Händen; auch ein Sensor allein genügt</translation>
    </message>
    <message>
        <source>A spot 1 m away from steel, radiators, loudspeakers and telephones</source>
        <translation>Eine Stelle 1&#xa0;m entfernt von Stahl, Heizkörpern, Lautsprechern und Telefonen</translation>
    </message>
    <message>
        <source>Take rings, watches and buckles out of the bag. The box lies in it too, or its cable is long enough to be turned.</source>
        <translation>Ringe, Uhren und Schnallen aus dem Beutel nehmen. Die Box liegt mit darin, oder ihr Kabel ist lang genug zum Drehen.</translation>
    </message>
    <message>
        <source>One sensor, several, or all in a bag: each is judged by itself.</source>
        <translation>Ein Sensor, mehrere oder alle im Beutel: Jeder wird für sich beurteilt.</translation>
    </message>
    <message>
        <source>Put all sensors in a bag</source>
        <translation>Alle Sensoren in einen Beutel legen</translation>
    </message>
    <message>
        <source>Field of this spot</source>
        <translation>Feld an dieser Stelle</translation>
    </message>
    <message>
        <source>strength, dip, evenness</source>
        <translation>Stärke, Neigung, Gleichmaß</translation>
    </message>
    <message>
        <source>Carry it about slowly</source>
        <translation>Langsam umhertragen</translation>
    </message>
    <message>
        <source>Turn through all directions</source>
        <translation>In alle Richtungen drehen</translation>
    </message>
    <message>
        <source>each by itself</source>
        <translation>jeder für sich</translation>
    </message>
    <message>
        <source>Field near the floor</source>
        <translation>Feld am Boden</translation>
    </message>
    <message>
        <source>where steel lies in most houses</source>
        <translation>wo in den meisten Häusern Stahl liegt</translation>
    </message>
    <message>
        <source>Lower it to the floor</source>
        <translation>Zum Boden senken</translation>
    </message>
    <message>
        <source>Turn it slowly</source>
        <translation>Langsam drehen</translation>
    </message>
    <message>
        <source>As in the drawing: feet hip-wide and parallel, arms hanging a little away from the body, elbows slightly bent, palms towards the body, eyes straight ahead.</source>
        <translation>Wie in der Zeichnung: Füße hüftbreit und parallel, Arme etwas vom Körper weg hängend, Ellbogen leicht gebeugt, Handflächen zum Körper, Blick geradeaus.</translation>
    </message>
    <message>
        <source>Each exercise begins in the rest pose, as in the drawing: arms hanging a little away from the body, elbows slightly bent, palms towards the body, eyes straight ahead. Then move smoothly, as far as is comfortable, for 8 seconds.</source>
        <translation>Jede Übung beginnt in der Ruhehaltung wie in der Zeichnung: Arme hängen etwas vom Körper weg, Ellbogen leicht gebeugt, Handflächen zum Körper, Blick geradeaus. Dann 8 Sekunden lang fließend bewegen, so weit es angenehm ist.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::AboutDialog</name>
    <message>
        <source>%1. %2. %3</source>
        <comment>what a library is for, its licence, its address</comment>
        <translation>%1. %2. %3</translation>
    </message>
    <message>
        <source>About Noctule</source>
        <translation>Über Noctule</translation>
    </message>
    <message>
        <source>Noctule %1</source>
        <translation>Noctule %1</translation>
    </message>
    <message>
        <source>Motion capture by sound and inertia. After Vlasic et al., Practical motion capture in everyday surroundings, 2007.</source>
        <translation>Bewegungserfassung mit Schall und Trägheit. Nach Vlasic u. a., Practical motion capture in everyday surroundings, 2007.</translation>
    </message>
    <message>
        <source>What it is made of</source>
        <translation>Woraus es besteht</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Alles kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Noctule itself is free under the Apache License 2.0. It is linked with Qt and Qwt under the LGPL; whoever passes the program on passes on their terms too: both libraries may be replaced by other versions of them. Noctule links no library under the GPL itself; OpenCV writes films with ffmpeg, which Debian builds with parts under the GPL: passed on together, the whole is under the terms of the GPL.</source>
        <translation>Noctule selbst ist frei unter der Apache-Lizenz 2.0. Es ist mit Qt und Qwt unter der LGPL gelinkt; wer das Programm weitergibt, gibt auch deren Bedingungen weiter: beide Bibliotheken dürfen durch andere Fassungen ersetzt werden. Noctule selbst bindet keine Bibliothek unter der GPL ein; OpenCV schreibt Filme mit ffmpeg, das Debian mit Teilen unter der GPL baut: zusammen weitergegeben steht das Ganze unter den Bedingungen der GPL.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::AddRobotDialog</name>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>A robot is described by its URDF file. Robots hurt people: keep an emergency stop in reach that does not depend on this program.</source>
        <translation>Ein Roboter wird durch seine URDF-Datei beschrieben. Roboter verletzen Menschen: Ein Not-Halt, der nicht von diesem Programm abhängt, muss in Reichweite sein.</translation>
    </message>
    <message>
        <source>Connect the robot</source>
        <translation>Roboter verbinden</translation>
    </message>
    <message>
        <source>URDF</source>
        <translation>URDF</translation>
    </message>
    <message>
        <source>Robot descriptions (*.urdf);;All files (*)</source>
        <translation>Roboterbeschreibungen (*.urdf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Profiles (*.json)</source>
        <translation>Profile (*.json)</translation>
    </message>
    <message>
        <source>found by the robot’s name</source>
        <translation>nach dem Namen des Roboters</translation>
    </message>
    <message>
        <source>Robonaut 2, Unitree G1 and H1, Panda, UR5 and Baxter have a profile of their own; for others one is made from the URDF.</source>
        <translation>Robonaut 2, Unitree G1 und H1, Panda, UR5 und Baxter haben ein eigenes Profil; für andere entsteht eines aus der URDF-Datei.</translation>
    </message>
    <message>
        <source>rosbridge (ROS)</source>
        <translation>rosbridge (ROS)</translation>
    </message>
    <message>
        <source>UDP</source>
        <translation>UDP</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Schnittstelle</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>The whole posture</source>
        <translation>Die ganze Haltung</translation>
    </message>
    <message>
        <source>Path of the hand only</source>
        <translation>Nur die Bahn der Hand</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Folgt</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Choose the robot’s URDF file.</source>
        <translation>Wählen Sie die URDF-Datei des Roboters.</translation>
    </message>
    <message>
        <source>%1 is not there. Choose another file.</source>
        <translation>%1 ist nicht da. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Gesteuert</translation>
    </message>
</context>
<context>
    <name>noctule::ui::AssignPanel</name>
    <message>
        <source>Find by moving</source>
        <translation>Durch Bewegen finden</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Zuordnen</translation>
    </message>
    <message>
        <source>Worn by</source>
        <translation>Getragen von</translation>
    </message>
    <message>
        <source>Assign boards</source>
        <translation>Platinen zuordnen</translation>
    </message>
    <message>
        <source>Body part of the board that was found</source>
        <translation>Körperteil der gefundenen Platine</translation>
    </message>
    <message>
        <source>Performers belong to a session. The first take makes one by date.</source>
        <translation>Darsteller gehören zu einer Sitzung. Die erste Aufnahme legt eine nach dem Datum an.</translation>
    </message>
    <message>
        <source>%1, suit “%2”</source>
        <comment>height, name</comment>
        <translation>%1, Anzug „%2“</translation>
    </message>
    <message>
        <source>Stop finding</source>
        <translation>Suche beenden</translation>
    </message>
    <message>
        <source>Connect a suit first</source>
        <translation>Zuerst einen Anzug verbinden</translation>
    </message>
    <message>
        <source>Drag a board onto a body part, or press Find and move the limb.</source>
        <translation>Eine Platine auf einen Körperteil ziehen, oder „Durch Bewegen finden“ drücken und das Glied bewegen.</translation>
    </message>
    <message>
        <source>Move one limb, the end of it most, and keep all others still.</source>
        <translation>Ein Glied bewegen, sein Ende am meisten, und alle anderen ruhig halten.</translation>
    </message>
    <message>
        <source>Board %1 moves. Which body part is it?</source>
        <translation>Platine %1 bewegt sich. Welcher Körperteil ist es?</translation>
    </message>
    <message>
        <source>Swap boards %1 and %2</source>
        <translation>Platinen %1 und %2 tauschen</translation>
    </message>
    <message numerus="yes">
        <source>Listening for %n s.</source>
        <translation>
            <numerusform>Hört seit %n&#xa0;s zu.</numerusform>
            <numerusform>Hört seit %n&#xa0;s zu.</numerusform>
        </translation>
    </message>
    <message>
        <source>No board moves more than all others yet. Turn the limb faster; a board that stays silent is not found.</source>
        <translation>Noch bewegt sich keine Platine mehr als alle anderen. Drehen Sie das Glied schneller; eine Platine, die stumm bleibt, wird nicht gefunden.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::AttachDialog</name>
    <message>
        <source>Attach %1</source>
        <translation>%1 anhängen</translation>
    </message>
    <message>
        <source>Another system&apos;s recording of the same performance goes into the take.</source>
        <translation>Die Aufzeichnung derselben Darbietung durch ein anderes System kommt in die Aufnahme.</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Anhängen</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>What results are compared with.</source>
        <translation>Womit Ergebnisse verglichen werden.</translation>
    </message>
    <message>
        <source>External root</source>
        <translation>Wurzel von außen</translation>
    </message>
    <message>
        <source>Hips that processing with root given follows.</source>
        <translation>Hüften, denen die Verarbeitung mit gegebener Wurzel folgt.</translation>
    </message>
    <message>
        <source>Found by motion</source>
        <translation>Aus der Bewegung</translation>
    </message>
    <message>
        <source>Where its movements match the last result best.</source>
        <translation>Wo ihre Bewegungen am besten zum letzten Ergebnis passen.</translation>
    </message>
    <message>
        <source>It begins at</source>
        <translation>Sie beginnt bei</translation>
    </message>
    <message>
        <source>Milliseconds of the take&apos;s clock; may be negative.</source>
        <translation>Millisekunden auf der Uhr der Aufnahme; auch negativ.</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Begin of the recording in milliseconds</source>
        <translation>Beginn der Aufzeichnung in Millisekunden</translation>
    </message>
    <message>
        <source>Use as</source>
        <translation>Verwenden als</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Positions do not say how limbs are twisted; give a BVH file for that.</source>
        <translation>Positionen sagen nicht, wie Glieder verdreht sind; dafür eine BVH-Datei angeben.</translation>
    </message>
    <message>
        <source>Positions cannot be aligned by themselves.</source>
        <translation>Positionen lassen sich nicht von selbst ausrichten.</translation>
    </message>
    <message>
        <source>Process the take first: its result is what motion is matched with.</source>
        <translation>Zuerst die Aufnahme verarbeiten: mit ihrem Ergebnis wird die Bewegung abgeglichen.</translation>
    </message>
    <message>
        <source>The take has a reference already. Attaching replaces it.</source>
        <translation>Die Aufnahme hat schon eine Referenz. Anhängen ersetzt sie.</translation>
    </message>
    <message>
        <source>The take has an external root already. Attaching replaces it.</source>
        <translation>Die Aufnahme hat schon eine Wurzel von außen. Anhängen ersetzt sie.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::BetweenPanel</name>
    <message>
        <source>Between %1 and %2</source>
        <translation>Zwischen %1 und %2</translation>
    </message>
    <message>
        <source>not observed</source>
        <translation>nicht beobachtet</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>error, rms</source>
        <translation>Fehler, RMS</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 zu %2</translation>
    </message>
    <message>
        <source>… nearer than 0.3 m</source>
        <translation>… näher als 0,3&#xa0;m</translation>
    </message>
    <message>
        <source>Facing each other</source>
        <translation>Ausrichtung zueinander</translation>
    </message>
    <message>
        <source>How well distances between the performers are known is told against a reference of each of them.</source>
        <translation>Wie gut die Abstände zwischen den Darstellern bekannt sind, zeigt eine Referenz von jedem von ihnen.</translation>
    </message>
    <message>
        <source>Between the performers</source>
        <translation>Zwischen den Darstellern</translation>
    </message>
</context>
<context>
    <name>noctule::ui::BoardCard</name>
    <message>
        <source>Turning rate of the last five seconds</source>
        <translation>Drehrate der letzten fünf Sekunden</translation>
    </message>
    <message>
        <source>Acceleration of the last five seconds</source>
        <translation>Beschleunigung der letzten fünf Sekunden</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Blinken</translation>
    </message>
    <message>
        <source>Chosen board</source>
        <translation>Gewählte Platine</translation>
    </message>
    <message>
        <source>Pulses heard</source>
        <translation>Gehörte Pulse</translation>
    </message>
    <message>
        <source>confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>Turning rate, 5 s</source>
        <translation>Drehrate, 5&#xa0;s</translation>
    </message>
    <message>
        <source>Acceleration, 5 s</source>
        <translation>Beschleunigung, 5&#xa0;s</translation>
    </message>
    <message>
        <source>No board is chosen</source>
        <translation>Keine Platine ist gewählt</translation>
    </message>
    <message>
        <source>Choose a board on the body or in the pairs to see what arrives from it.</source>
        <translation>Eine Platine am Körper oder in den Paaren wählen, um zu sehen, was von ihr ankommt.</translation>
    </message>
    <message>
        <source>Board %1, %2</source>
        <comment>number, body part</comment>
        <translation>Platine %1, %2</translation>
    </message>
    <message>
        <source>Its serial number is not known</source>
        <translation>Ihre Seriennummer ist nicht bekannt</translation>
    </message>
    <message>
        <source>Serial %1</source>
        <translation>Seriennummer %1</translation>
    </message>
    <message>
        <source>Blink board %1</source>
        <translation>Platine %1 blinken lassen</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 frames a second, %n bit error(s)</source>
        <translation>
            <numerusform>%1 von %2 Rahmen je Sekunde, %n Bitfehler</numerusform>
            <numerusform>%1 von %2 Rahmen je Sekunde, %n Bitfehler</numerusform>
        </translation>
    </message>
    <message>
        <source>Board %1 blinks</source>
        <translation>Platine %1 blinkt</translation>
    </message>
    <message>
        <source>The board is unplugged.</source>
        <translation>Die Platine ist ausgesteckt.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::BoardTable</name>
    <message>
        <source>Boards and their steps</source>
        <translation>Platinen und ihre Schritte</translation>
    </message>
    <message>
        <source>askew</source>
        <translation>schief</translation>
    </message>
</context>
<context>
    <name>noctule::ui::BodyDialog</name>
    <message>
        <source>Body of the view</source>
        <translation>Körper der Ansicht</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Choose a mesh</source>
        <translation>Netz wählen</translation>
    </message>
    <message>
        <source>Noctule&apos;s own</source>
        <translation>Noctules eigener</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Linear, as other programs do</source>
        <translation>Linear, wie in anderen Programmen</translation>
    </message>
    <message>
        <source>Dual quaternions, which keep the volume</source>
        <translation>Duale Quaternionen, die das Volumen erhalten</translation>
    </message>
    <message>
        <source>Skin bends</source>
        <translation>Haut biegt sich</translation>
    </message>
    <message>
        <source>Meshes (*.glb *.gltf *.vrm *.fbx *.dae *.obj *.ply)</source>
        <translation>Netze (*.glb *.gltf *.vrm *.fbx *.dae *.obj *.ply)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Bone of %1</source>
        <translation>Knochen von %1</translation>
    </message>
    <message>
        <source>Noctule&apos;s own, in the performer&apos;s measures</source>
        <translation>Noctules eigener, in den Maßen des Darstellers</translation>
    </message>
    <message>
        <source>Where its joints are</source>
        <translation>Wo seine Gelenke sind</translation>
    </message>
    <message>
        <source>Needed: without it the body cannot move</source>
        <translation>Nötig: ohne ihn kann sich der Körper nicht bewegen</translation>
    </message>
    <message>
        <source>Keeps its place on the bone above</source>
        <translation>Behält seinen Platz am Knochen darüber</translation>
    </message>
    <message>
        <source>The mesh is being read.</source>
        <translation>Das Netz wird gelesen.</translation>
    </message>
    <message>
        <source>The mesh was not read.</source>
        <translation>Das Netz wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>Find again</source>
        <translation>Neu finden</translation>
    </message>
    <message>
        <source>Views, pictures and films of this session show this body, moved by the captured motion.</source>
        <translation>Ansichten, Bilder und Filme dieser Sitzung zeigen diesen Körper, bewegt von der aufgenommenen Bewegung.</translation>
    </message>
    <message>
        <source>Which of its bones is which</source>
        <translation>Welcher seiner Knochen welcher ist</translation>
    </message>
    <message>
        <source>This mesh cannot be used as it is.</source>
        <translation>Dieses Netz lässt sich so nicht verwenden.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::BodyMap</name>
    <message>
        <source>Boards and sources on the body</source>
        <translation>Platinen und Quellen am Körper</translation>
    </message>
    <message>
        <source>Performer’s right</source>
        <translation>Rechts am Darsteller</translation>
    </message>
    <message>
        <source>Performer’s left</source>
        <translation>Links am Darsteller</translation>
    </message>
    <message>
        <source>board %1</source>
        <translation>Platine %1</translation>
    </message>
    <message>
        <source>Anchors of the room, from above</source>
        <translation>Anker des Raums, von oben</translation>
    </message>
    <message>
        <source>The room and its anchors, from above</source>
        <translation>Der Raum und seine Anker, von oben</translation>
    </message>
</context>
<context>
    <name>noctule::ui::CalibratePage</name>
    <message>
        <source>Finish or leave this calibration, then check the suit.</source>
        <translation>Diese Kalibrierung beenden oder verlassen, dann den Anzug kontrollieren.</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation>Kalibrierungen</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Of this session, newest first</source>
        <translation>Dieser Sitzung, neueste zuerst</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Platinen</translation>
    </message>
    <message>
        <source>Against the calibration in force</source>
        <translation>Gegen die gültige Kalibrierung</translation>
    </message>
    <message>
        <source>There is nothing to check yet</source>
        <translation>Noch gibt es nichts zu kontrollieren</translation>
    </message>
    <message>
        <source>There is no calibration to check.</source>
        <translation>Es gibt keine Kalibrierung zu kontrollieren.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Kontrollieren</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Not calibrated</source>
        <translation>Nicht kalibriert</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Als Nächstes: %1</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Kalibriert</translation>
    </message>
    <message>
        <source>All parts of the suit have values that are recent enough. Check them with three seconds of standing still.</source>
        <translation>Alle Teile des Anzugs haben Werte, die neu genug sind. Zur Kontrolle drei Sekunden still stehen.</translation>
    </message>
    <message>
        <source>All parts of the suit have values, but where they come from is not stated. Check them with three seconds of standing still.</source>
        <translation>Alle Teile des Anzugs haben Werte, aber woher sie stammen, ist nicht angegeben. Zur Kontrolle drei Sekunden still stehen.</translation>
    </message>
    <message>
        <source>Prepare: %1</source>
        <translation>Vorbereiten: %1</translation>
    </message>
    <message>
        <source>Continue to Record</source>
        <translation>Weiter zu Aufnehmen</translation>
    </message>
    <message>
        <source>%1, in use</source>
        <translation>%1, verwendet</translation>
    </message>
    <message>
        <source>Go back to this one</source>
        <translation>Zu dieser zurückkehren</translation>
    </message>
    <message>
        <source>Going back to %1</source>
        <translation>Zurück zu %1</translation>
    </message>
    <message>
        <source>None has been saved yet.</source>
        <translation>Noch ist keine gespeichert.</translation>
    </message>
    <message>
        <source>made for another suit, %1</source>
        <comment>its serial number</comment>
        <translation>für einen anderen Anzug erstellt, %1</translation>
    </message>
    <message>
        <source>Until the anchors&apos; sources are calibrated, their places are found to decimetres only. Begin with the source offsets, or import the calibration of this box.</source>
        <translation>Solange die Quellen der Anker nicht kalibriert sind, werden ihre Plätze nur auf Dezimeter gefunden. Mit dem Quellenversatz beginnen oder die Kalibrierung dieser Box importieren.</translation>
    </message>
    <message>
        <source>Calibrated for another suit</source>
        <translation>Für einen anderen Anzug kalibriert</translation>
    </message>
    <message>
        <source>The calibration in use was made for %1: with it the poses of %2 are wrong. Calibrate %2, or import its calibration.</source>
        <comment>two serial numbers</comment>
        <translation>Die verwendete Kalibrierung gehört zu %1: Mit ihr sind die Posen von %2 falsch. %2 kalibrieren oder seine Kalibrierung importieren.</translation>
    </message>
    <message>
        <source>made for an unknown suit</source>
        <translation>für einen unbekannten Anzug erstellt</translation>
    </message>
    <message>
        <source>%1 was made for another suit</source>
        <translation>%1 wurde für einen anderen Anzug erstellt</translation>
    </message>
    <message>
        <source>It belongs to %1; %2 is connected. Sensors and sources differ from suit to suit: with the values of others poses are wrong.</source>
        <comment>serial numbers</comment>
        <translation>Sie gehört zu %1; verbunden ist %2. Sensoren und Quellen unterscheiden sich von Anzug zu Anzug: mit den Werten anderer sind Posen falsch.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Use it all the same</source>
        <translation>Trotzdem verwenden</translation>
    </message>
    <message>
        <source>The other values stay in use; their cards say how good they are.</source>
        <translation>Die übrigen Werte gelten weiter; ihre Karten sagen, wie gut sie sind.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>What differs from the calibration in use</source>
        <translation>Was sich von der verwendeten Kalibrierung unterscheidet</translation>
    </message>
    <message>
        <source>Back to Record</source>
        <translation>Zurück zu Aufnehmen</translation>
    </message>
    <message>
        <source>Back to Calibrate</source>
        <translation>Zurück zu Kalibrieren</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Use a calibration file of this suit</source>
        <translation>Eine Kalibrierdatei dieses Anzugs verwenden</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>Kalibrierung importieren</translation>
    </message>
    <message>
        <source>Calibrations (*.json)</source>
        <translation>Kalibrierungen (*.json)</translation>
    </message>
    <message>
        <source>%1 was not imported</source>
        <translation>%1 wurde nicht importiert</translation>
    </message>
    <message>
        <source>Export the calibration in use</source>
        <translation>Verwendete Kalibrierung exportieren</translation>
    </message>
    <message>
        <source>The calibration was not exported</source>
        <translation>Die Kalibrierung wurde nicht exportiert</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>Nothing moves live and nothing can be processed before the suit is calibrated. Begin with the source offsets, or import its calibration.</source>
        <translation>Live bewegt sich nichts und nichts kann verarbeitet werden, bevor der Anzug kalibriert ist. Mit dem Quellenversatz beginnen oder seine Kalibrierung importieren.</translation>
    </message>
    <message>
        <source>There is no calibration to export.</source>
        <translation>Es gibt keine Kalibrierung zu exportieren.</translation>
    </message>
    <message>
        <source>None yet. The suit&apos;s own values from an earlier session are in use; the rest pose belongs to each wearing.</source>
        <translation>Noch keine. Die Werte des Anzugs aus einer früheren Sitzung sind in Gebrauch; die Ruhehaltung gehört zu jedem Anlegen.</translation>
    </message>
    <message>
        <source>Anchors</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>Needs a take in which somebody walks past the anchors</source>
        <translation>Braucht eine Aufnahme, in der jemand an den Ankern vorbeigeht</translation>
    </message>
    <message>
        <source>From the take that is open, %1</source>
        <translation>Aus der offenen Aufnahme, %1</translation>
    </message>
    <message>
        <source>Survey</source>
        <translation>Vermessen</translation>
    </message>
    <message>
        <source>Known exactly</source>
        <translation>Genau bekannt</translation>
    </message>
    <message>
        <source>The virtual suit says by itself how it measures and how it sits on the body. Calibrating it is for practice only.</source>
        <translation>Der virtuelle Anzug sagt selbst, wie er misst und wie er am Körper sitzt. Ihn zu kalibrieren dient nur der Übung.</translation>
    </message>
    <message>
        <source>Finish or leave this calibration, then choose another suit.</source>
        <translation>Diese Kalibrierung beenden oder verlassen, dann einen anderen Anzug wählen.</translation>
    </message>
    <message>
        <source>%1 is in use; undo with %2.</source>
        <comment>file, key</comment>
        <translation>%1 ist in Gebrauch; rückgängig mit %2.</translation>
    </message>
    <message>
        <source>Somebody can walk past the anchors now</source>
        <translation>Jetzt kann jemand an den Ankern vorbeigehen</translation>
    </message>
    <message>
        <source>Put %1 aside</source>
        <translation>%1 beiseitelegen</translation>
    </message>
    <message>
        <source>%1 is put aside; undo with %2.</source>
        <comment>file, key</comment>
        <translation>%1 liegt beiseite; mit %2 rückgängig.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::CalibrationShelf</name>
    <message>
        <source>No session is open. Open one first.</source>
        <translation>Keine Sitzung ist offen. Zuerst eine öffnen.</translation>
    </message>
    <message>
        <source>The calibration %1 of this session is gone or damaged. Takes are made with what the suit knows of itself; choose another one in step Calibrate.</source>
        <translation>Die Kalibrierung %1 dieser Sitzung ist verschwunden oder beschädigt. Aufgenommen wird mit dem, was der Anzug von sich selbst weiß; wählen Sie im Schritt Kalibrieren eine andere.</translation>
    </message>
    <message>
        <source>The calibration %1 was made with other parts than those connected now: %2. Calibrate those before takes with them can be relied on.</source>
        <translation>Die Kalibrierung %1 entstand mit anderen Teilen als den jetzt verbundenen: %2. Erst wenn diese kalibriert sind, ist auf Aufnahmen mit ihnen Verlass.</translation>
    </message>
    <message>
        <source>The calibration %1 was made for another suit, %2. Calibrate %3 before takes with it can be relied on.</source>
        <comment>file, serial numbers</comment>
        <translation>Die Kalibrierung %1 wurde für einen anderen Anzug erstellt, %2. Erst wenn %3 kalibriert ist, ist auf Aufnahmen damit Verlass.</translation>
    </message>
    <message>
        <source>%1: the calibration of its sensors and sources from an earlier session is in use (made %2).</source>
        <comment>serial number, date</comment>
        <translation>%1: die Kalibrierung seiner Sensoren und Quellen aus einer früheren Sitzung ist in Gebrauch (vom %2).</translation>
    </message>
    <message>
        <source>Parts of %1 were exchanged since it was calibrated: %2. Calibrate those before takes with them can be relied on.</source>
        <translation>Teile von %1 wurden seit der Kalibrierung getauscht: %2. Diese kalibrieren, bevor auf Aufnahmen mit ihnen Verlass ist.</translation>
    </message>
    <message>
        <source>The calibration could not be kept for other sessions. %1.</source>
        <translation>Die Kalibrierung konnte nicht für andere Sitzungen aufbewahrt werden. %1.</translation>
    </message>
    <message>
        <source>Newer values of the suit</source>
        <translation>Neuere Werte des Anzugs</translation>
    </message>
    <message>
        <source>%1 knows none of the boards of %2. Choose the calibration of this suit.</source>
        <translation>%1 kennt keine der Platinen von %2. Die Kalibrierung dieses Anzugs wählen.</translation>
    </message>
    <message>
        <source>There is no session to keep the calibration in, and none could be made. Make one first.</source>
        <translation>Es gibt keine Sitzung für die Kalibrierung, und keine konnte angelegt werden. Zuerst eine anlegen.</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>There is no calibration to export. Calibrate the suit first.</source>
        <translation>Es gibt keine Kalibrierung zu exportieren. Zuerst den Anzug kalibrieren.</translation>
    </message>
    <message>
        <source>Calibration: %1</source>
        <translation>Kalibrierung: %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::CaptureContext</name>
    <message>
        <source>A take is being recorded</source>
        <translation>Es wird gerade aufgenommen</translation>
    </message>
    <message>
        <source>Start the second virtual suit when it has ended</source>
        <translation>Den zweiten virtuellen Anzug danach starten</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ColumnsDialog</name>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>angular rate %1</source>
        <translation>Drehrate %1</translation>
    </message>
    <message>
        <source>acceleration %1</source>
        <translation>Beschleunigung %1</translation>
    </message>
    <message>
        <source>magnetic field %1</source>
        <translation>Magnetfeld %1</translation>
    </message>
    <message>
        <source>attitude %1</source>
        <translation>Lage %1</translation>
    </message>
    <message>
        <source>Columns of %1</source>
        <translation>Spalten von %1</translation>
    </message>
    <message>
        <source>Say what each column is. It was guessed from names and first values; check the units.</source>
        <translation>Sagen Sie, was jede Spalte ist. Geraten wurde nach Namen und ersten Werten; prüfen Sie die Einheiten.</translation>
    </message>
    <message>
        <source>Use these columns</source>
        <translation>Diese Spalten verwenden</translation>
    </message>
    <message>
        <source>Save as a map…</source>
        <translation>Als Zuordnung speichern&#xa0;…</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>First values</source>
        <translation>Erste Werte</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Ist</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>What column %1 is</source>
        <translation>Was Spalte %1 ist</translation>
    </message>
    <message>
        <source>Sensor of column %1</source>
        <translation>Sensor von Spalte %1</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Angular rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Magnetic field</source>
        <translation>Magnetfeld</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>from the time</source>
        <translation>aus der Zeit</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s) in these columns</source>
        <translation>
            <numerusform>%n Sensor in diesen Spalten</numerusform>
            <numerusform>%n Sensoren in diesen Spalten</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the map</source>
        <translation>Zuordnung speichern</translation>
    </message>
    <message>
        <source>Import maps (*.json)</source>
        <translation>Import-Zuordnungen (*.json)</translation>
    </message>
</context>
<context>
    <name>noctule::ui::CompareDialog</name>
    <message>
        <source>Compare calibrations</source>
        <translation>Kalibrierungen vergleichen</translation>
    </message>
    <message>
        <source>%1 of %2, against the one in use, %3</source>
        <translation>%1 vom %2, gegen die verwendete, %3</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>All values are the same.</source>
        <translation>Alle Werte sind gleich.</translation>
    </message>
    <message>
        <source>Going back to %1</source>
        <translation>Zurück zu %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ConfidenceLegend</name>
    <message>
        <source>Colours of confidence from 0 to 1</source>
        <translation>Farben der Konfidenz von 0 bis 1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ConnectPage</name>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Performer and suit</source>
        <translation>Darsteller und Anzug</translation>
    </message>
    <message>
        <source>Put the suit on</source>
        <translation>Anzug anlegen</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>Bereitschaft</translation>
    </message>
    <message>
        <source>Look for devices again</source>
        <translation>Erneut nach Geräten suchen</translation>
    </message>
    <message>
        <source>Blink the chosen board</source>
        <translation>Gewählte Platine blinken lassen</translation>
    </message>
    <message>
        <source>Go on without the chosen board</source>
        <translation>Ohne die gewählte Platine weitermachen</translation>
    </message>
    <message numerus="yes">
        <source>%n board(s) hear it well</source>
        <translation>
            <numerusform>%n Platine hört sie gut</numerusform>
            <numerusform>%n Platinen hören sie gut</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a board first.</source>
        <translation>Zuerst eine Platine wählen.</translation>
    </message>
    <message>
        <source>Board %1 works; there is nothing to go on without.</source>
        <translation>Platine %1 arbeitet; es gibt nichts, worauf zu verzichten wäre.</translation>
    </message>
    <message>
        <source>Board %1 is unplugged and cannot blink.</source>
        <translation>Platine %1 ist ausgesteckt und kann nicht blinken.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ContactEditor</name>
    <message>
        <source>Move a contact</source>
        <translation>Kontakt verschieben</translation>
    </message>
    <message>
        <source>Set a contact</source>
        <translation>Kontakt setzen</translation>
    </message>
    <message>
        <source>Delete a contact</source>
        <translation>Kontakt löschen</translation>
    </message>
    <message>
        <source>Back to the contacts that were found</source>
        <translation>Zurück zu den gefundenen Kontakten</translation>
    </message>
</context>
<context>
    <name>noctule::ui::DeviceCard</name>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Name of the suit</source>
        <translation>Name des Anzugs</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>More about %1</source>
        <translation>Mehr zu %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::DevicesPanel</name>
    <message>
        <source>No driver box is found. Switch one on, or connect it by USB.</source>
        <translation>Keine Steuerbox ist gefunden. Eine einschalten oder über USB anschließen.</translation>
    </message>
    <message>
        <source>Other address or port</source>
        <translation>Andere Adresse oder Schnittstelle</translation>
    </message>
    <message>
        <source>Address or port of a driver box</source>
        <translation>Adresse oder Schnittstelle einer Steuerbox</translation>
    </message>
    <message>
        <source>Ask</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>In the network tcp://ADDRESS:PORT, at a serial port serial:///dev/ttyACM0.</source>
        <translation>Im Netzwerk tcp://ADRESSE:PORT, an einer seriellen Schnittstelle serial:///dev/ttyACM0.</translation>
    </message>
    <message>
        <source>Driver box on USB</source>
        <translation>Steuerbox an USB</translation>
    </message>
    <message>
        <source>Driver box on the network</source>
        <translation>Steuerbox im Netzwerk</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>where a device is; what it has</comment>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n board(s)</source>
        <translation>
            <numerusform>%n Platine</numerusform>
            <numerusform>%n Platinen</numerusform>
        </translation>
    </message>
    <message>
        <source>not here</source>
        <translation>nicht da</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>is being connected</source>
        <translation>wird verbunden</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>antwortet nicht</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>asking</source>
        <translation>wird gefragt</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>%1: no driver box answers</source>
        <comment>an address</comment>
        <translation>%1: keine Steuerbox antwortet</translation>
    </message>
    <message>
        <source>Ask again</source>
        <translation>Erneut anfragen</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>belegt</translation>
    </message>
    <message>
        <source>Another studio uses it</source>
        <translation>Ein anderes Studio verwendet sie</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Virtual suit</source>
        <translation>Virtueller Anzug</translation>
    </message>
    <message>
        <source>A simulated performer, no hardware</source>
        <translation>Ein simulierter Darsteller, ohne Geräte</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Its motion is being prepared, once</source>
        <translation>Seine Bewegung wird vorbereitet, einmal</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>startet</translation>
    </message>
    <message>
        <source>link broken</source>
        <translation>Verbindung unterbrochen</translation>
    </message>
    <message>
        <source>A serial port; a driver box may be connected there</source>
        <translation>Eine serielle Schnittstelle; dort kann eine Steuerbox angeschlossen sein</translation>
    </message>
    <message>
        <source>%1, anchors of the room</source>
        <comment>a device</comment>
        <translation>%1, Anker des Raums</translation>
    </message>
    <message>
        <source>%1, worn by %2 %3</source>
        <comment>a device, letter and name of a performer</comment>
        <translation>%1, getragen von %2 %3</translation>
    </message>
    <message>
        <source>Answers at another address now</source>
        <translation>Antwortet jetzt unter einer anderen Adresse</translation>
    </message>
    <message>
        <source>Connect again</source>
        <translation>Wieder verbinden</translation>
    </message>
    <message>
        <source>Add this suit</source>
        <translation>Anzug hinzunehmen</translation>
    </message>
    <message>
        <source>Second virtual suit</source>
        <translation>Zweiter virtueller Anzug</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzunehmen</translation>
    </message>
    <message>
        <source>Add these anchors</source>
        <translation>Diese Anker hinzufügen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::DialogFrame</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportForm</name>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Joint angles too, in degrees</source>
        <translation>Auch Gelenkwinkel, in Grad</translation>
    </message>
    <message>
        <source>Write one frame and check</source>
        <translation>Ein Bild schreiben und prüfen</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Last of each take</source>
        <translation>Letztes jeder Aufnahme</translation>
    </message>
    <message>
        <source>As shown in Review</source>
        <translation>Wie im Schritt Prüfen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>What and how</source>
        <translation>Was und wie</translation>
    </message>
    <message>
        <source>In to out of each take</source>
        <translation>Anfang bis Ende jeder Aufnahme</translation>
    </message>
    <message>
        <source>Whole takes</source>
        <translation>Ganze Aufnahmen</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>First second</source>
        <translation>Erste Sekunde</translation>
    </message>
    <message>
        <source>Last second</source>
        <translation>Letzte Sekunde</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>%1 per second</source>
        <translation>%1 je Sekunde</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Moves as captured</source>
        <translation>Bewegt sich wie aufgenommen</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>Bleibt am Ort</translation>
    </message>
    <message>
        <source>In place, facing +Z</source>
        <translation>Am Ort, Blick nach +Z</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Wurzel</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wohin</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>Dateiname</translation>
    </message>
    <message>
        <source>{take} {fps} {performer} {run} {date} are filled in. A name that you type is kept for all presets until you clear the field.</source>
        <translation>{take} {fps} {performer} {run} {date} werden eingesetzt. Ein Name, den Sie eingeben, gilt für alle Vorgaben, bis Sie das Feld leeren.</translation>
    </message>
    <message>
        <source>Try first</source>
        <translation>Erst probieren</translation>
    </message>
    <message>
        <source>exports of the session</source>
        <translation>Exporte der Sitzung</translation>
    </message>
    <message>
        <source>%1/%2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>Shown: %1</source>
        <translation>Gezeigt: %1</translation>
    </message>
    <message>
        <source>Folder for exported files</source>
        <translation>Ordner für exportierte Dateien</translation>
    </message>
    <message>
        <source>Chosen for each take</source>
        <translation>Je Aufnahme gewählt</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>HumanIK</source>
        <translation>HumanIK</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Skinned, in the performer&apos;s measures</source>
        <translation>Mit Haut, in den Maßen des Darstellers</translation>
    </message>
    <message>
        <source>Skeleton alone</source>
        <translation>Nur das Skelett</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>%1: always in metres.</source>
        <translation>%1: immer in Metern.</translation>
    </message>
    <message>
        <source>%1: names of its own.</source>
        <translation>%1: eigene Namen.</translation>
    </message>
    <message>
        <source>%1: has no place for a body.</source>
        <translation>%1: hat keinen Platz für einen Körper.</translation>
    </message>
    <message>
        <source>The session&apos;s body</source>
        <translation>Der Körper der Sitzung</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Stands in front</source>
        <translation>Steht davor</translation>
    </message>
    <message>
        <source>Goes along</source>
        <translation>Geht mit</translation>
    </message>
    <message>
        <source>Goes once around</source>
        <translation>Geht einmal herum</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Standing feet keep their place</source>
        <translation>Stehende Füße bleiben an ihrem Ort</translation>
    </message>
    <message>
        <source>On a body of other proportions feet would slide; its legs bend a little instead.</source>
        <translation>Auf einem Körper anderer Maße würden die Füße rutschen; stattdessen beugen sich seine Beine etwas.</translation>
    </message>
    <message>
        <source>Chosen seconds</source>
        <translation>Gewählte Sekunden</translation>
    </message>
    <message>
        <source>Common (Hips, Spine, LeftArm)</source>
        <translation>Übliche (Hips, Spine, LeftArm)</translation>
    </message>
    <message>
        <source>All of each take</source>
        <translation>Alle jeder Aufnahme</translation>
    </message>
    <message>
        <source>Also as</source>
        <translation>Auch als</translation>
    </message>
    <message>
        <source>Each take is written in this format too.</source>
        <translation>Jede Aufnahme wird auch in diesem Format geschrieben.</translation>
    </message>
    <message>
        <source>One file with all takes or performers</source>
        <translation>Eine Datei mit allen Aufnahmen oder Darstellern</translation>
    </message>
    <message>
        <source>Each take is an animation under its name; {take} in the file name becomes the session’s name. Of one take, each performer is a character of its own.</source>
        <translation>Jede Aufnahme ist eine Animation unter ihrem Namen; {take} im Dateinamen wird zum Namen der Sitzung. Aus einer Aufnahme wird jeder Darsteller eine eigene Figur.</translation>
    </message>
    <message>
        <source>The frame at Review’s time cursor; of other takes one in the middle.</source>
        <translation>Das Bild am Zeiger in Prüfen; von anderen Aufnahmen eines aus der Mitte.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportPage</name>
    <message>
        <source>Write again</source>
        <translation>Neu schreiben</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Made for</source>
        <translation>Bestimmt für</translation>
    </message>
    <message>
        <source>No session is open</source>
        <translation>Keine Sitzung ist offen</translation>
    </message>
    <message>
        <source>Open one first</source>
        <translation>Öffnen Sie zuerst eine</translation>
    </message>
    <message>
        <source>No take is chosen</source>
        <translation>Keine Aufnahme ist gewählt</translation>
    </message>
    <message>
        <source>Tick at least one</source>
        <translation>Kreuzen Sie mindestens eine an</translation>
    </message>
    <message>
        <source>The range ends before it begins</source>
        <translation>Der Bereich endet, bevor er beginnt</translation>
    </message>
    <message numerus="yes">
        <source>Write %n files</source>
        <translation>
            <numerusform>%n Datei schreiben</numerusform>
            <numerusform>%n Dateien schreiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Files are being written.</source>
        <translation>Dateien werden geschrieben.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 free.</source>
        <translation>%1 frei.</translation>
    </message>
    <message>
        <source>Took %1. %2</source>
        <translation>Dauerte %1. %2</translation>
    </message>
    <message>
        <source>Writing one frame of %1</source>
        <translation>Ein Bild von %1 wird geschrieben</translation>
    </message>
    <message numerus="yes">
        <source>%n files written and checked.</source>
        <translation>
            <numerusform>%n Datei geschrieben und geprüft.</numerusform>
            <numerusform>%n Dateien geschrieben und geprüft.</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the check</source>
        <translation>Prüfung speichern</translation>
    </message>
    <message>
        <source>check.txt</source>
        <translation>pruefung.txt</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>Save as own preset</source>
        <translation>Als eigene Vorgabe speichern</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Choose a last second after the first</source>
        <translation>Wählen Sie eine letzte Sekunde nach der ersten</translation>
    </message>
    <message>
        <source>Nothing is overwritten: a second export gets _2. %1</source>
        <translation>Nichts wird überschrieben: ein zweiter Export bekommt _2. %1</translation>
    </message>
    <message numerus="yes">
        <source>Writing %n files</source>
        <translation>
            <numerusform>%n Datei wird geschrieben</numerusform>
            <numerusform>%n Dateien werden geschrieben</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportPresetList</name>
    <message>
        <source>Save as own preset</source>
        <translation>Als eigene Vorgabe speichern</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportResultsPanel</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Save the check as text</source>
        <translation>Prüfung als Text speichern</translation>
    </message>
    <message>
        <source>One frame written, read back and deleted</source>
        <translation>Ein Bild geschrieben, zurückgelesen und gelöscht</translation>
    </message>
    <message numerus="yes">
        <source>%n files written and read back</source>
        <translation>
            <numerusform>%n Datei geschrieben und zurückgelesen</numerusform>
            <numerusform>%n Dateien geschrieben und zurückgelesen</numerusform>
        </translation>
    </message>
    <message>
        <source>Each file was opened again and compared with its take.</source>
        <translation>Jede Datei wurde wieder geöffnet und mit ihrer Aufnahme verglichen.</translation>
    </message>
    <message numerus="yes">
        <source>Each file was opened again and compared with its take. %n are not what they should be.</source>
        <translation>
            <numerusform>Jede Datei wurde wieder geöffnet und mit ihrer Aufnahme verglichen. %n ist nicht, was sie sein sollte.</numerusform>
            <numerusform>Jede Datei wurde wieder geöffnet und mit ihrer Aufnahme verglichen. %n sind nicht, was sie sein sollten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each file was opened again and compared with its take. %n have something you should know.</source>
        <translation>
            <numerusform>Jede Datei wurde wieder geöffnet und mit ihrer Aufnahme verglichen. Bei %n ist etwas zu beachten.</numerusform>
            <numerusform>Jede Datei wurde wieder geöffnet und mit ihrer Aufnahme verglichen. Bei %n ist etwas zu beachten.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 frames, %2</source>
        <translation>%1 Bilder, %2</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Blick</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Largest difference</source>
        <translation>Größter Unterschied</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Written files are listed here, each with its check.</source>
        <translation>Geschriebene Dateien stehen hier, jede mit ihrer Prüfung.</translation>
    </message>
    <message>
        <source>Written before</source>
        <translation>Früher geschrieben</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportRun</name>
    <message>
        <source>Writing and checking %1</source>
        <translation>%1 wird geschrieben und geprüft</translation>
    </message>
    <message>
        <source>%1, feet on the floor</source>
        <translation>%1, Füße am Boden</translation>
    </message>
    <message>
        <source>%1, lowest point %2 above the floor</source>
        <translation>%1, tiefster Punkt %2 über dem Boden</translation>
    </message>
    <message>
        <source>%1, lowest point %2 below the floor</source>
        <translation>%1, tiefster Punkt %2 unter dem Boden</translation>
    </message>
    <message>
        <source>+Z, left hand to +X</source>
        <translation>+Z, linke Hand nach +X</translation>
    </message>
    <message>
        <source>%1 to the left of +Z</source>
        <translation>%1 links von +Z</translation>
    </message>
    <message>
        <source>%1 to the right of +Z</source>
        <translation>%1 rechts von +Z</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>All boards were silent from %1 to %2. The pose in those %n frames is a guess.</source>
        <translation>
            <numerusform>Alle Platinen schwiegen von %1 bis %2. Die Pose in diesem %n Bild ist geraten.</numerusform>
            <numerusform>Alle Platinen schwiegen von %1 bis %2. Die Pose in diesen %n Bildern ist geraten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Board %1 (%2) was silent from %3 to %4. It follows its neighbours in those %n frames.</source>
        <translation>
            <numerusform>Platine %1 (%2) schwieg von %3 bis %4. In diesem %n Bild folgt sie ihren Nachbarn.</numerusform>
            <numerusform>Platine %1 (%2) schwieg von %3 bis %4. In diesen %n Bildern folgt sie ihren Nachbarn.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 frames at %3 per second, %4</source>
        <translation>%1 von %2 Bildern, %3 je Sekunde, %4</translation>
    </message>
    <message>
        <source>Height: %1</source>
        <translation>Größe: %1</translation>
    </message>
    <message>
        <source>Facing: %1</source>
        <translation>Blick: %1</translation>
    </message>
    <message>
        <source>Joints: %1 of %2</source>
        <translation>Gelenke: %1 von %2</translation>
    </message>
    <message>
        <source>Largest difference to the take: %1</source>
        <translation>Größter Unterschied zur Aufnahme: %1</translation>
    </message>
    <message>
        <source>under %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>Take %1, result: %2</source>
        <translation>Aufnahme %1, Ergebnis: %2</translation>
    </message>
    <message>
        <source>Export it by itself, or without one file for all</source>
        <translation>Exportieren Sie sie allein oder ohne eine Datei für alle</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>take, performer</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The figure goes %1 below the floor: this result holds no feet on it. If they stood on a level floor, process the take with filter Noctule, gyroscopes and Level floor.</source>
        <translation>Die Figur reicht %1 unter den Boden: Dieses Ergebnis hält keine Füße darauf. Standen sie auf ebenem Boden, verarbeiten Sie die Aufnahme mit Filter Noctule, Gyroskopen und ebenem Boden.</translation>
    </message>
    <message>
        <source>The figure goes %1 below the floor of the rest pose, as it may on uneven ground. If the floor was level, process the take with Level floor.</source>
        <translation>Die Figur reicht %1 unter den Boden der Ruhehaltung, wie es auf unebenem Boden sein kann. War der Boden eben, verarbeiten Sie die Aufnahme mit ebenem Boden.</translation>
    </message>
    <message>
        <source>The figure stands %1 below the floor. Move the motion up by that in the program that reads it.</source>
        <translation>Die Figur steht %1 unter dem Boden. Heben Sie die Bewegung in dem Programm, das sie liest, um so viel an.</translation>
    </message>
    <message>
        <source>The figure stands %1 below the floor: its height is that of the other system. Correct the floor there, or move the motion up in the program that reads it.</source>
        <translation>Die Figur steht %1 unter dem Boden: Ihre Höhe ist die des anderen Systems. Berichtigen Sie dort den Boden, oder heben Sie die Bewegung in dem Programm an, das sie liest.</translation>
    </message>
    <message>
        <source>The figure stands %1 below the floor: its height is that of the anchors. Check how high they hang, or move the motion up in the program that reads it.</source>
        <translation>Die Figur steht %1 unter dem Boden: Ihre Höhe ist die der Anker. Prüfen Sie, wie hoch sie hängen, oder heben Sie die Bewegung in dem Programm an, das sie liest.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportSettings</name>
    <message>
        <source>MotionBuilder and Maya</source>
        <translation>MotionBuilder und Maya</translation>
    </message>
    <message>
        <source>BVH, centimetres, Y up</source>
        <translation>BVH, Zentimeter, Y oben</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Unity</source>
        <translation>Unity</translation>
    </message>
    <message>
        <source>Unreal</source>
        <translation>Unreal</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>CSV of joint positions, metres</source>
        <translation>CSV der Gelenkpositionen, Meter</translation>
    </message>
    <message>
        <source>Numbers with angles</source>
        <translation>Zahlen mit Winkeln</translation>
    </message>
    <message>
        <source>CSV of positions and joint angles</source>
        <translation>CSV: Positionen, Gelenkwinkel</translation>
    </message>
    <message>
        <source>CSV with angles, %1 frames</source>
        <translation>CSV mit Winkeln, %1 Bilder</translation>
    </message>
    <message>
        <source>FBX, centimetres, skinned</source>
        <translation>FBX, Zentimeter, mit Haut</translation>
    </message>
    <message>
        <source>FBX, metres, skinned</source>
        <translation>FBX, Meter, mit Haut</translation>
    </message>
    <message>
        <source>Any animation program</source>
        <translation>Jedes Animationsprogramm</translation>
    </message>
    <message>
        <source>Web and viewers</source>
        <translation>Web und Betrachter</translation>
    </message>
    <message>
        <source>glTF binary, metres, skinned</source>
        <translation>glTF binär, Meter, mit Haut</translation>
    </message>
    <message>
        <source>Biomechanics</source>
        <translation>Biomechanik</translation>
    </message>
    <message>
        <source>OpenSim joint angles, degrees</source>
        <translation>OpenSim-Gelenkwinkel, Grad</translation>
    </message>
    <message>
        <source>glTF binary</source>
        <translation>glTF binär</translation>
    </message>
    <message>
        <source>OpenSim angles</source>
        <translation>OpenSim-Winkel</translation>
    </message>
    <message>
        <source>OpenSim orientations</source>
        <translation>OpenSim-Orientierungen</translation>
    </message>
    <message>
        <source>%1, %2 frames</source>
        <translation>%1, %2 Bilder</translation>
    </message>
    <message>
        <source>%1, metres, %2 frames</source>
        <translation>%1, Meter, %2 Bilder</translation>
    </message>
    <message>
        <source>%1, centimetres, %2 frames</source>
        <translation>%1, Zentimeter, %2 Bilder</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>MP4, the session&apos;s body</source>
        <translation>MP4, der Körper der Sitzung</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>PNG, the session&apos;s body</source>
        <translation>PNG, der Körper der Sitzung</translation>
    </message>
    <message>
        <source>Picture (PNG)</source>
        <translation>Bild (PNG)</translation>
    </message>
    <message>
        <source>Film (MP4)</source>
        <translation>Film (MP4)</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2, %3 frames</source>
        <translation>%1, %2, %3 Bilder</translation>
    </message>
    <message>
        <source>The session&apos;s body is not there yet</source>
        <translation>Der Körper der Sitzung ist noch nicht da</translation>
    </message>
    <message>
        <source>Wait until it is read, or choose another body</source>
        <translation>Warten Sie, bis er gelesen ist, oder wählen Sie einen anderen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ExportTakeList</name>
    <message>
        <source>Takes to export</source>
        <translation>Zu exportierende Aufnahmen</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>Not processed yet: there is no motion to export.</source>
        <translation>Noch nicht verarbeitet: es gibt keine Bewegung zu exportieren.</translation>
    </message>
    <message>
        <source>Result of %1</source>
        <translation>Ergebnis von %1</translation>
    </message>
    <message>
        <source>Looking at results</source>
        <translation>Ergebnisse werden angesehen</translation>
    </message>
    <message numerus="yes">
        <source>%n results</source>
        <translation>
            <numerusform>%n Ergebnis</numerusform>
            <numerusform>%n Ergebnisse</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::FieldDrawing</name>
    <message>
        <source>%1 of 100 directions seen</source>
        <translation>%1 von 100 Richtungen gesehen</translation>
    </message>
    <message>
        <source>%1, %2 still empty</source>
        <translation>%1, noch leer: %2</translation>
    </message>
    <message>
        <source>still empty: %1</source>
        <translation>noch leer: %1</translation>
    </message>
    <message>
        <source>readings few</source>
        <translation>Messwerte wenige</translation>
    </message>
    <message>
        <source>many</source>
        <translation>viele</translation>
    </message>
    <message>
        <source>Seen from behind</source>
        <translation>Von hinten gesehen</translation>
    </message>
    <message>
        <source>Seen from the front</source>
        <translation>Von vorn gesehen</translation>
    </message>
    <message>
        <source>Each field is a direction the Earth’s field was seen from, by the sensor that has seen it least.</source>
        <translation>Jedes Feld ist eine Richtung, aus der das Erdmagnetfeld gesehen wurde, vom Sensor, der sie am wenigsten sah.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::FieldHeights</name>
    <message>
        <source>At the height of the chest: %1. Near the floor: %2.</source>
        <translation>In Brusthöhe: %1. Am Boden: %2.</translation>
    </message>
    <message>
        <source>not looked at yet</source>
        <translation>noch nicht angesehen</translation>
    </message>
    <message>
        <source>even within %1</source>
        <translation>gleichmäßig auf %1</translation>
    </message>
    <message>
        <source>bent by %1</source>
        <translation>um %1 verbogen</translation>
    </message>
    <message>
        <source>%1: bent</source>
        <translation>%1: verbogen</translation>
    </message>
    <message>
        <source>%1: even</source>
        <translation>%1: gleichmäßig</translation>
    </message>
    <message>
        <source>as usual here</source>
        <translation>wie hier üblich</translation>
    </message>
    <message>
        <source>Near the floor</source>
        <translation>Am Boden</translation>
    </message>
    <message>
        <source>At the height of the chest</source>
        <translation>In Brusthöhe</translation>
    </message>
    <message>
        <source>How strong the Earth’s field is, compared with what is usual where you stand. Steel bends it: beyond 5 % a heading is wrong by several degrees.</source>
        <translation>Stärke des Erdfelds, verglichen mit der hier üblichen. Stahl verbiegt es: über 5&#xa0;% weist eine Richtung um Grade falsch.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::FieldLive</name>
    <message>
        <source>The page goes on by itself when every sensor has 90 % of all directions. A sensor that stays behind can be done alone afterwards.</source>
        <translation>Die Anzeige geht von selbst weiter, wenn jeder Sensor 90&#xa0;% aller Richtungen hat. Ein Sensor, der zurückbleibt, kann danach allein an die Reihe kommen.</translation>
    </message>
    <message>
        <source>%1 of 100 directions, all sensors</source>
        <translation>%1 von 100 Richtungen, alle Sensoren</translation>
    </message>
    <message>
        <source>%1 so far</source>
        <translation>bisher %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::FieldSensors</name>
    <message>
        <source>Start it anew</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Skip it</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Begin anew</source>
        <translation>Von vorn beginnen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Field of this spot</source>
        <translation>Feld an dieser Stelle</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>%1 is beyond its range</source>
        <translation>%1 ist außerhalb des Messbereichs</translation>
    </message>
    <message>
        <source>A magnet lies beside it. Take it away; readings begin anew.</source>
        <translation>Ein Magnet liegt daneben. Wegnehmen und den Sensor neu beginnen.</translation>
    </message>
    <message>
        <source>%1 reads no field</source>
        <translation>%1 misst kein Magnetfeld</translation>
    </message>
    <message>
        <source>Its magnetometer seems to be broken or shielded. Skip it.</source>
        <translation>Das Magnetometer ist wohl defekt oder abgeschirmt. Den Sensor auslassen.</translation>
    </message>
    <message>
        <source>%1 carries iron</source>
        <translation>Eisen bei: %1</translation>
    </message>
    <message>
        <source>Its field changes by %1 as it turns, more than that of the others. A ring, a watch or a buckle lies beside it. Take it out; readings begin anew.</source>
        <translation>Das Feld ändert sich beim Drehen um %1, mehr als bei den anderen. Ein Ring, eine Uhr oder eine Schnalle liegt daneben. Herausnehmen und den Sensor neu beginnen.</translation>
    </message>
    <message>
        <source>The field of %1 changes by %2</source>
        <translation>Das Feld von %1 ändert sich um %2</translation>
    </message>
    <message>
        <source>The spot is bent, or iron lies beside it. Go 1 m away from steel; readings begin anew.</source>
        <translation>Das Feld ist hier verzerrt, oder Eisen liegt daneben. 1&#xa0;m von Stahl weggehen und den Sensor neu beginnen.</translation>
    </message>
    <message>
        <source>%1 of %2 have enough</source>
        <translation>%1 von %2 haben genug</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 nach unten</translation>
    </message>
    <message numerus="yes">
        <source>Use the %n that are done</source>
        <translation>
            <numerusform>Den einen fertigen verwenden</numerusform>
            <numerusform>Die %n fertigen verwenden</numerusform>
        </translation>
    </message>
    <message>
        <source>No sensor has 90 % of the directions yet.</source>
        <translation>Noch kein Sensor hat 90&#xa0;% der Richtungen.</translation>
    </message>
    <message>
        <source>Nothing has been turned yet.</source>
        <translation>Noch wurde nichts gedreht.</translation>
    </message>
    <message>
        <source>Leave out the floor</source>
        <translation>Den Boden auslassen</translation>
    </message>
    <message>
        <source>Ask for the skipped ones again</source>
        <translation>Ausgelassene wieder aufnehmen</translation>
    </message>
    <message>
        <source>Near the floor</source>
        <translation>Am Boden</translation>
    </message>
    <message>
        <source>To the field of this spot once more; what was turned stays</source>
        <translation>Noch einmal zum Feld dieser Stelle; was gedreht wurde, bleibt</translation>
    </message>
    <message>
        <source>Nothing is known of the floor then; turn the suit at the height of your chest</source>
        <translation>Vom Boden ist dann nichts bekannt; den Anzug in Brusthöhe drehen</translation>
    </message>
    <message>
        <source>Start sensor %1 anew</source>
        <translation>Sensor %1 neu beginnen</translation>
    </message>
    <message>
        <source>Skip sensor %1</source>
        <translation>Sensor %1 auslassen</translation>
    </message>
    <message>
        <source>%1 is not heard</source>
        <translation>%1 ist nicht zu hören</translation>
    </message>
    <message>
        <source>Push its plug in until it clicks; if its light stays dark, change the cable.</source>
        <translation>Den Stecker bis zum Klicken eindrücken; bleibt sein Licht dunkel, das Kabel wechseln.</translation>
    </message>
    <message>
        <source>This is the first step.</source>
        <translation>Das ist der erste Schritt.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::FieldTable</name>
    <message>
        <source>Sensors, directions seen and unevenness</source>
        <translation>Sensoren, gesehene Richtungen und Ungleichmaß</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>unevenness</source>
        <translation>Ungleichmaß</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>ausgelassen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::FindingList</name>
    <message>
        <source>No board and no source stands out.</source>
        <translation>Keine Platine und keine Quelle fällt auf.</translation>
    </message>
    <message>
        <source>Show the worst only</source>
        <translation>Nur das Schlimmste zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>findings</comment>
        <translation>
            <numerusform>%n weiteres</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::FitWords</name>
    <message>
        <source>the source offsets</source>
        <translation>der Quellenversätze</translation>
    </message>
    <message numerus="yes">
        <source>the offsets of %n source(s)</source>
        <translation>
            <numerusform>der Versätze von %n Quelle</numerusform>
            <numerusform>der Versätze von %n Quellen</numerusform>
        </translation>
    </message>
    <message>
        <source>the accelerometers</source>
        <translation>der Beschleunigungssensoren</translation>
    </message>
    <message numerus="yes">
        <source>the accelerometers of %n board(s)</source>
        <translation>
            <numerusform>der Beschleunigungssensoren von %n Platine</numerusform>
            <numerusform>der Beschleunigungssensoren von %n Platinen</numerusform>
        </translation>
    </message>
    <message>
        <source>the gyroscopes</source>
        <translation>der Gyroskope</translation>
    </message>
    <message numerus="yes">
        <source>the gyroscopes of %n board(s)</source>
        <translation>
            <numerusform>der Gyroskope von %n Platine</numerusform>
            <numerusform>der Gyroskope von %n Platinen</numerusform>
        </translation>
    </message>
    <message>
        <source>the rest pose</source>
        <translation>der Ruhehaltung</translation>
    </message>
    <message numerus="yes">
        <source>the rest pose of %n board(s)</source>
        <translation>
            <numerusform>der Ruhehaltung von %n Platine</numerusform>
            <numerusform>der Ruhehaltung von %n Platinen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>a list and its last part</comment>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>This take has no calibration. Process it with one.</source>
        <translation>Diese Aufnahme hat keine Kalibrierung. Mit einer verarbeiten.</translation>
    </message>
    <message>
        <source>This take was made without calibration of %1. Process it with one that has them.</source>
        <translation>Diese Aufnahme entstand ohne Kalibrierung %1. Mit einer verarbeiten, die sie hat.</translation>
    </message>
    <message>
        <source>Cannot be checked: the rest pose is not calibrated.</source>
        <translation>Keine Kontrolle möglich: die Ruhehaltung ist nicht kalibriert.</translation>
    </message>
    <message>
        <source>Cannot be checked: gyroscopes are not calibrated.</source>
        <translation>Keine Kontrolle möglich: Gyroskope sind nicht kalibriert.</translation>
    </message>
    <message>
        <source>Not calibrated: the body cannot move yet.</source>
        <translation>Nicht kalibriert: der Körper kann sich noch nicht bewegen.</translation>
    </message>
    <message>
        <source>Without calibration of %1: the body cannot move yet.</source>
        <translation>Ohne Kalibrierung %1: der Körper kann sich noch nicht bewegen.</translation>
    </message>
    <message>
        <source>Without calibration of %1.</source>
        <translation>Ohne Kalibrierung %1.</translation>
    </message>
    <message>
        <source>The check found that something has moved.</source>
        <translation>Die Kontrolle fand, dass etwas verrutscht ist.</translation>
    </message>
    <message>
        <source>Not checked since it was put on.</source>
        <translation>Seit dem Anlegen nicht kontrolliert.</translation>
    </message>
    <message>
        <source>Source offsets</source>
        <translation>Quellenversatz</translation>
    </message>
    <message>
        <source>Accelerometers</source>
        <translation>Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>Gyroscopes</source>
        <translation>Gyroskope</translation>
    </message>
    <message>
        <source>Magnetometers</source>
        <translation>Magnetometer</translation>
    </message>
    <message>
        <source>Rest pose</source>
        <translation>Ruhehaltung</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Part of the calibration is not usable.</source>
        <translation>Ein Teil der Kalibrierung ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>The rest pose is old.</source>
        <translation>Die Ruhehaltung ist alt.</translation>
    </message>
    <message>
        <source>Part of the calibration is due again.</source>
        <translation>Ein Teil der Kalibrierung ist wieder fällig.</translation>
    </message>
    <message>
        <source>Recording, with a calibration that is not usable</source>
        <translation>Nimmt auf, mit einer nicht brauchbaren Kalibrierung</translation>
    </message>
    <message>
        <source>Recording, with an old rest pose</source>
        <translation>Nimmt auf, mit einer alten Ruhehaltung</translation>
    </message>
    <message>
        <source>Recording, with an old calibration</source>
        <translation>Nimmt auf, mit einer alten Kalibrierung</translation>
    </message>
    <message>
        <source>Recording, without calibration</source>
        <translation>Nimmt auf, ohne Kalibrierung</translation>
    </message>
    <message>
        <source>Recording, without calibration of %1</source>
        <translation>Nimmt auf, ohne Kalibrierung %1</translation>
    </message>
    <message>
        <source>Recording, though something has moved</source>
        <translation>Nimmt auf, obwohl etwas verrutscht ist</translation>
    </message>
    <message>
        <source>Recording, not checked</source>
        <translation>Nimmt auf, nicht kontrolliert</translation>
    </message>
    <message>
        <source>Recording well</source>
        <translation>Nimmt gut auf</translation>
    </message>
    <message>
        <source>Without calibration of %1: places of the anchors are found to decimetres only.</source>
        <translation>Ohne Kalibrierung %1: Die Plätze der Anker werden nur auf Dezimeter gefunden.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::FullReport</name>
    <message>
        <source>Comparing all results</source>
        <translation>Alle Ergebnisse werden verglichen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::HandPathsView</name>
    <message>
        <source>Hand of the robot, commanded against achieved</source>
        <translation>Hand des Roboters, Soll gegen Ist</translation>
    </message>
    <message>
        <source>The hand is %1 late. Without the delay it is off by %2.</source>
        <translation>Die Hand kommt %1 zu spät. Ohne die Verzögerung weicht sie um %2 ab.</translation>
    </message>
    <message>
        <source>The hand does not move</source>
        <translation>Die Hand bewegt sich nicht</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
</context>
<context>
    <name>noctule::ui::HeatMap</name>
    <message>
        <source>Confidence per pair</source>
        <translation>Konfidenz je Paar</translation>
    </message>
    <message>
        <source>Confidence at the cursor</source>
        <translation>Konfidenz am Zeiger</translation>
    </message>
    <message>
        <source>Source %1 to board %2, %3: %4</source>
        <translation>Quelle %1 zu Platine %2, %3: %4</translation>
    </message>
    <message>
        <source>Board %1, %2, hears no source</source>
        <translation>Platine %1, %2, hört keine Quelle</translation>
    </message>
    <message>
        <source>Source %1 to board %2, %3: not heard</source>
        <translation>Quelle %1 zu Platine %2, %3: nicht gehört</translation>
    </message>
    <message>
        <source>now, at the cursor</source>
        <translation>jetzt, am Zeiger</translation>
    </message>
    <message>
        <source>mean between in and out</source>
        <translation>Mittel zwischen Anfang und Ende</translation>
    </message>
    <message>
        <source>S%1</source>
        <comment>source number</comment>
        <translation>Q%1</translation>
    </message>
    <message>
        <source>Open a take to see how well each board heard each source</source>
        <translation>Eine Aufnahme öffnen, um zu sehen, wie gut jede Platine jede Quelle hörte</translation>
    </message>
    <message>
        <source>Reading ranges</source>
        <translation>Entfernungen werden gelesen</translation>
    </message>
    <message>
        <source>Choose a pair to see its curve and its ray</source>
        <translation>Ein Paar wählen, um Kurve und Strahl zu sehen</translation>
    </message>
    <message>
        <source>%1, residual %2</source>
        <translation>%1, Restfehler %2</translation>
    </message>
    <message>
        <source>%1 ranges heard, none used by this result</source>
        <translation>%1 Entfernungen gehört, von diesem Ergebnis keine verwendet</translation>
    </message>
    <message>
        <source>Board %1, %2: heard, but not usable without source offsets</source>
        <translation>Platine %1, %2: gehört, aber ohne Quellenversätze nicht nutzbar</translation>
    </message>
    <message>
        <source>Source %1 to board %2, %3: heard, but not usable without source offsets</source>
        <translation>Quelle %1 zu Platine %2, %3: gehört, aber ohne Quellenversätze nicht nutzbar</translation>
    </message>
    <message>
        <source>%1 ranges kept, %2 left out</source>
        <translation>%1 behalten, %2 ausgelassen</translation>
    </message>
    <message>
        <source>This take has no result yet. Process it to see which board heard which source.</source>
        <translation>Diese Aufnahme hat noch kein Ergebnis. Verarbeiten Sie sie, um zu sehen, welche Platine welche Quelle gehört hat.</translation>
    </message>
    <message>
        <source>This take is being processed.</source>
        <translation>Diese Aufnahme wird gerade verarbeitet.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::HelpWindow</name>
    <message>
        <source>Noctule’s documents</source>
        <translation>Noctules Dokumente</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Dokumente</translation>
    </message>
    <message>
        <source>The document</source>
        <translation>Das Dokument</translation>
    </message>
    <message>
        <source>Tutorial</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>How it works</source>
        <translation>Wie es funktioniert</translation>
    </message>
    <message>
        <source>Glossary</source>
        <translation>Glossar</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Architecture</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>Security</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Lage der Sensoren</translation>
    </message>
    <message>
        <source>The documents are in English.</source>
        <translation>Die Dokumente sind auf Englisch.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::HoldRing</name>
    <message>
        <source>%1 of %2 seconds</source>
        <translation>%1 von %2 Sekunden</translation>
    </message>
    <message>
        <source>%1 / %2 s</source>
        <translation>%1 / %2&#xa0;s</translation>
    </message>
</context>
<context>
    <name>noctule::ui::Job</name>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::Jobs</name>
    <message>
        <source>The studio made a mistake: %1</source>
        <translation>Das Studio hat einen Fehler gemacht: %1</translation>
    </message>
    <message>
        <source>Nothing was changed. Report it together with the take</source>
        <translation>Nichts wurde verändert. Zusammen mit der Aufnahme melden</translation>
    </message>
</context>
<context>
    <name>noctule::ui::JobsPanel</name>
    <message>
        <source>Jobs</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>Clear finished</source>
        <translation>Beendete entfernen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Processing, imports and exports are listed here while they run, and until they are seen.</source>
        <translation>Verarbeitung, Importe und Exporte stehen hier, solange sie laufen und bis sie gesehen sind.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::JointBars</name>
    <message>
        <source>Joints of the robot</source>
        <translation>Gelenke des Roboters</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>joint: value</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>noctule::ui::JointTable</name>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabelle kopieren</translation>
    </message>
</context>
<context>
    <name>noctule::ui::JointTableModel</name>
    <message>
        <source>%1 backed by ranges</source>
        <translation>%1 durch Entfernungen gestützt</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Max.</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>Gestützt</translation>
    </message>
    <message>
        <source>In the order of the body</source>
        <translation>In der Reihenfolge des Körpers</translation>
    </message>
    <message>
        <source>Mean angle between result and reference</source>
        <translation>Mittlerer Winkel zwischen Ergebnis und Referenz</translation>
    </message>
    <message>
        <source>Largest angle between result and reference</source>
        <translation>Größter Winkel zwischen Ergebnis und Referenz</translation>
    </message>
    <message>
        <source>Share of the time in which ranges backed the joint; in between it follows its gyroscope</source>
        <translation>Anteil der Zeit, in dem Entfernungen das Gelenk stützten; dazwischen folgt es seinem Gyroskop</translation>
    </message>
</context>
<context>
    <name>noctule::ui::LandmarkEditor</name>
    <message>
        <source>Keep both sides alike</source>
        <translation>Beide Seiten gleich halten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>What is moved on one side moves on the other; the middle stays in the middle</source>
        <translation>Was auf einer Seite bewegt wird, bewegt sich auf der anderen; die Mitte bleibt in der Mitte</translation>
    </message>
    <message>
        <source>Nothing was moved.</source>
        <translation>Nichts wurde bewegt.</translation>
    </message>
    <message>
        <source>Nothing was undone.</source>
        <translation>Nichts wurde rückgängig gemacht.</translation>
    </message>
    <message>
        <source>%1, cm</source>
        <translation>%1, cm</translation>
    </message>
    <message>
        <source>%1, %2 in centimetres</source>
        <translation>%1, %2 in Zentimetern</translation>
    </message>
</context>
<context>
    <name>noctule::ui::LandmarkPicture</name>
    <message>
        <source>%1, tip</source>
        <translation>%1, Spitze</translation>
    </message>
    <message>
        <source>%1: %2 to its left, %3 up, %4 forward</source>
        <translation>%1: %2 nach links, %3 nach oben, %4 nach vorn</translation>
    </message>
    <message>
        <source>Where the joints are in the mesh</source>
        <translation>Wo die Gelenke im Netz sind</translation>
    </message>
    <message>
        <source>Arrow keys move the chosen joint, with Shift by a centimetre; Page Up and Page Down move it backward and forward; comma and full stop choose another.</source>
        <translation>Pfeiltasten bewegen das gewählte Gelenk, mit Umschalt um einen Zentimeter; Bild aufwärts und Bild abwärts bewegen es nach hinten und nach vorn; Komma und Punkt wählen ein anderes.</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From its left</source>
        <translation>Von seiner Linken</translation>
    </message>
    <message>
        <source>its left</source>
        <translation>seine Linke</translation>
    </message>
</context>
<context>
    <name>noctule::ui::LaneStack</name>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Plus and minus zoom, %1 and %2 pan, %3 shows the whole take</source>
        <comment>keys</comment>
        <translation>Plus und Minus vergrößern und verkleinern, %1 und %2 verschieben, %3 zeigt die ganze Aufnahme</translation>
    </message>
</context>
<context>
    <name>noctule::ui::LengthField</name>
    <message>
        <source>In proportion to the height again</source>
        <translation>Wieder im Verhältnis zur Größe</translation>
    </message>
    <message>
        <source>cm</source>
        <comment>centimetres</comment>
        <translation>cm</translation>
    </message>
    <message>
        <source>in</source>
        <comment>inches</comment>
        <translation>Zoll</translation>
    </message>
</context>
<context>
    <name>noctule::ui::LevelMeters</name>
    <message>
        <source>Levels of the boards</source>
        <translation>Pegel der Platinen</translation>
    </message>
    <message>
        <source>%1: silent</source>
        <translation>%1: stumm</translation>
    </message>
    <message>
        <source>%1: sound %2, peak %3</source>
        <translation>%1: Ton %2, Spitze %3</translation>
    </message>
    <message>
        <source>%1, motion %2</source>
        <comment>sound of a board, its motion</comment>
        <translation>%1, Bewegung %2</translation>
    </message>
    <message numerus="yes">
        <source>%n board(s)</source>
        <translation>
            <numerusform>%n Platine</numerusform>
            <numerusform>%n Platinen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::LevelsPanel</name>
    <message>
        <source>Levels</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>sound with peak hold, motion as the thin bar</source>
        <translation>Ton mit gehaltener Spitze, Bewegung als schmaler Balken</translation>
    </message>
    <message>
        <source>Pairs heard</source>
        <translation>Gehörte Paare</translation>
    </message>
    <message>
        <source>last 10&#xa0;s, one row per source</source>
        <translation>letzte 10&#xa0;s, eine Zeile je Quelle</translation>
    </message>
    <message>
        <source>%1 of %2 good now</source>
        <translation>%1 von %2 jetzt gut</translation>
    </message>
    <message>
        <source>Lost since %1.</source>
        <comment>a time of the take, or of the day</comment>
        <translation>Verloren seit %1.</translation>
    </message>
    <message>
        <source>Nothing has arrived since %1.</source>
        <comment>a time of the take, or of the day</comment>
        <translation>Seit %1 kommt nichts an.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::LivePairs</name>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>confidence now, source by board</source>
        <translation>Konfidenz jetzt, Quelle zu Platine</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>number and place of a source</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 good</source>
        <comment>pairs</comment>
        <translation>%1 gut</translation>
    </message>
    <message>
        <source>%1: the board sends nothing</source>
        <comment>a pair</comment>
        <translation>%1: die Platine sendet nichts</translation>
    </message>
    <message>
        <source>%1: not heard</source>
        <comment>a pair</comment>
        <translation>%1: nicht gehört</translation>
    </message>
    <message>
        <source>%1: confidence %2, distance %3</source>
        <comment>a pair</comment>
        <translation>%1: Konfidenz %2, Abstand %3</translation>
    </message>
    <message>
        <source>Choose a cell to read it here.</source>
        <translation>Eine Zelle wählen, um sie hier zu lesen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::LiveSuit</name>
    <message>
        <source>Another box answers at %1 now: %2 instead of %3.</source>
        <comment>address, two serial numbers</comment>
        <translation>Unter %1 antwortet jetzt eine andere Box: %2 statt %3.</translation>
    </message>
    <message>
        <source>Nothing was recorded, and the take was removed.</source>
        <translation>Es wurde nichts aufgenommen, die Aufnahme ist entfernt.</translation>
    </message>
    <message>
        <source>Disconnecting %1</source>
        <translation>%1 wird getrennt</translation>
    </message>
    <message>
        <source>Starting the recording</source>
        <translation>Die Aufnahme beginnt</translation>
    </message>
    <message>
        <source>Looking at %1</source>
        <translation>%1 wird angesehen</translation>
    </message>
    <message>
        <source>No suit is connected. Connect one first.</source>
        <translation>Kein Anzug ist verbunden. Zuerst einen verbinden.</translation>
    </message>
    <message>
        <source>The driver box has not answered yet. Wait a moment.</source>
        <translation>Die Steuerbox hat noch nicht geantwortet. Einen Moment warten.</translation>
    </message>
    <message>
        <source>A take is being recorded already.</source>
        <translation>Es wird schon aufgenommen.</translation>
    </message>
    <message>
        <source>The take before is being saved. Wait a moment.</source>
        <translation>Die Aufnahme davor wird gespeichert. Einen Moment warten.</translation>
    </message>
    <message>
        <source>The driver box does not answer. Connect it again.</source>
        <translation>Die Steuerbox antwortet nicht. Noch einmal verbinden.</translation>
    </message>
    <message>
        <source>The link to the driver box is broken. Recording can begin when it is back.</source>
        <translation>Die Verbindung zur Steuerbox ist unterbrochen. Die Aufnahme kann beginnen, wenn sie wieder da ist.</translation>
    </message>
    <message>
        <source>There is no session to record into, and none could be made. Make one first.</source>
        <translation>Es gibt keine Sitzung für die Aufnahme, und keine konnte angelegt werden. Zuerst eine anlegen.</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>The driver box is busy. Wait a moment.</source>
        <translation>Die Steuerbox ist beschäftigt. Einen Moment warten.</translation>
    </message>
    <message>
        <source>There is no session to keep the calibration in, and none could be made. Make one first.</source>
        <translation>Es gibt keine Sitzung für die Kalibrierung, und keine konnte angelegt werden. Zuerst eine anlegen.</translation>
    </message>
    <message>
        <source>Keeping %1</source>
        <translation>%1 wird aufbewahrt</translation>
    </message>
</context>
<context>
    <name>noctule::ui::LiveSuits</name>
    <message>
        <source>A take is being recorded</source>
        <translation>Es wird gerade aufgenommen</translation>
    </message>
    <message>
        <source>Add the suit when it has ended</source>
        <translation>Den Anzug danach hinzunehmen</translation>
    </message>
    <message numerus="yes">
        <source>%n suit(s) are connected, and more cannot be</source>
        <translation>
            <numerusform>%n Anzug ist verbunden, mehr geht nicht</numerusform>
            <numerusform>%n Anzüge sind verbunden, mehr geht nicht</numerusform>
        </translation>
    </message>
    <message>
        <source>Disconnect one of them first</source>
        <translation>Zuerst einen davon trennen</translation>
    </message>
    <message>
        <source>Performer %1</source>
        <translation>Darsteller %1</translation>
    </message>
    <message>
        <source>Room</source>
        <comment>anchors that nobody wears</comment>
        <translation>Raum</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>who wears a suit, what hinders it</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A take is being recorded already.</source>
        <translation>Es wird schon aufgenommen.</translation>
    </message>
    <message>
        <source>There is no session to record into, and none could be made. Make one first.</source>
        <translation>Es gibt keine Sitzung für die Aufnahme, und keine konnte angelegt werden. Zuerst eine anlegen.</translation>
    </message>
    <message>
        <source>Starting the recording</source>
        <translation>Die Aufnahme beginnt</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
</context>
<context>
    <name>noctule::ui::MadeWithPanel</name>
    <message>
        <source>Recorded</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>Source offsets</source>
        <translation>Quellenversatz</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Rest pose</source>
        <translation>Ruhehaltung</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>Skelett</translation>
    </message>
    <message>
        <source>Suit</source>
        <translation>Anzug</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>nominal values</source>
        <translation>Nennwerte</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1, von %2</translation>
    </message>
    <message>
        <source>not marked</source>
        <translation>nicht markiert</translation>
    </message>
    <message>
        <source>%1 joints, %2</source>
        <translation>%1 Gelenke, %2</translation>
    </message>
    <message>
        <source>not in the take</source>
        <translation>nicht in der Aufnahme</translation>
    </message>
    <message>
        <source>%1 boards, %2 sources</source>
        <translation>%1 Platinen, %2 Quellen</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1&#xa0;kHz</translation>
    </message>
    <message>
        <source>not kept</source>
        <translation>nicht behalten</translation>
    </message>
    <message>
        <source>Performer</source>
        <translation>Darsteller</translation>
    </message>
</context>
<context>
    <name>noctule::ui::MainWindow</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>%1 – %2 – Noctule</source>
        <comment>page, session</comment>
        <translation>%1 – %2 – Noctule</translation>
    </message>
    <message>
        <source>Noctule</source>
        <translation>Noctule</translation>
    </message>
    <message>
        <source>%1 – Noctule</source>
        <comment>page</comment>
        <translation>%1 – Noctule</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>%1 is not there</source>
        <translation>%1 ist nicht da</translation>
    </message>
    <message>
        <source>It may have been moved, or its disk is not connected.</source>
        <translation>Vielleicht wurde es verschoben, oder sein Datenträger ist nicht angeschlossen.</translation>
    </message>
    <message>
        <source>%1 holds no session</source>
        <translation>%1 enthält keine Sitzung</translation>
    </message>
    <message>
        <source>A session is a folder with a session.json in it. Choose that folder, or make a new session.</source>
        <translation>Eine Sitzung ist ein Ordner mit einer session.json darin. Diesen Ordner wählen oder eine neue Sitzung anlegen.</translation>
    </message>
    <message>
        <source>%1 belongs to no session</source>
        <translation>%1 gehört zu keiner Sitzung</translation>
    </message>
    <message>
        <source>It can be seen, processed and exported as it is. Ratings, notes and performers are kept in a session.</source>
        <translation>Ansehen, Verarbeiten und Exportieren gehen so. Bewertungen, Notizen und Darsteller werden in einer Sitzung festgehalten.</translation>
    </message>
    <message>
        <source>Import into a session</source>
        <translation>In eine Sitzung importieren</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 ist beschädigt</translation>
    </message>
    <message>
        <source>%1 What can be read goes into a new take; the damaged file is kept.</source>
        <comment>why</comment>
        <translation>%1 Was sich lesen lässt, kommt in eine neue Aufnahme; die beschädigte Datei bleibt erhalten.</translation>
    </message>
    <message>
        <source>Save what can be read</source>
        <translation>Lesbares speichern</translation>
    </message>
    <message>
        <source>Close Noctule</source>
        <translation>Noctule schließen</translation>
    </message>
    <message numerus="yes">
        <source>%n job(s) are still running</source>
        <translation>
            <numerusform>Ein Auftrag läuft noch</numerusform>
            <numerusform>%n Aufträge laufen noch</numerusform>
        </translation>
    </message>
    <message>
        <source>%1

Cancelled jobs leave their takes as they were.</source>
        <comment>list of jobs</comment>
        <translation>%1

Abgebrochene Aufträge lassen ihre Aufnahmen, wie sie waren.</translation>
    </message>
    <message>
        <source>Go on working</source>
        <translation>Weiterarbeiten</translation>
    </message>
    <message>
        <source>Cancel jobs and close</source>
        <translation>Aufträge abbrechen und schließen</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>A tour of the five steps takes two minutes. It can be left at any time, and it is always under Help.</source>
        <translation>Ein Rundgang durch die fünf Schritte dauert zwei Minuten. Er lässt sich jederzeit verlassen und steht immer unter Hilfe.</translation>
    </message>
    <message>
        <source>Start the tour</source>
        <translation>Rundgang beginnen</translation>
    </message>
    <message>
        <source>New to Noctule?</source>
        <translation>Neu bei Noctule?</translation>
    </message>
    <message>
        <source>%1/%2 boards</source>
        <comment>there, of all</comment>
        <translation>%1/%2 Platinen</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>Schaut nach</translation>
    </message>
    <message>
        <source>The take is being recorded</source>
        <translation>Die Aufnahme läuft</translation>
    </message>
    <message>
        <source>It runs for %1. Stopped now, it is complete up to here.</source>
        <translation>Sie läuft seit %1. Jetzt beendet ist sie bis hierher vollständig.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Beenden und schließen</translation>
    </message>
    <message>
        <source>Save diagnosis</source>
        <translation>Diagnose speichern</translation>
    </message>
    <message>
        <source>Text files (*.txt)</source>
        <translation>Textdateien (*.txt)</translation>
    </message>
    <message>
        <source>%1 is written. It holds no names and no folders; read it before you pass it on.</source>
        <translation>%1 ist geschrieben. Darin stehen keine Namen und keine Ordner; vor dem Weitergeben durchlesen.</translation>
    </message>
    <message numerus="yes">
        <source>%n box(es)</source>
        <comment>connected</comment>
        <translation>
            <numerusform>%n Box</numerusform>
            <numerusform>%n Boxen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::MapLegend</name>
    <message>
        <source>board: gyroscope, accelerometer and microphone</source>
        <translation>Platine: Gyroskop, Beschleunigungssensor und Mikrofon</translation>
    </message>
    <message>
        <source>source: sends a pulse every 64 ms</source>
        <translation>Quelle: sendet alle 64&#xa0;ms einen Puls</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>board, sound and motion arrive</source>
        <translation>Platine, Ton und Bewegung kommen an</translation>
    </message>
    <message>
        <source>board, nothing arrives</source>
        <translation>Platine, nichts kommt an</translation>
    </message>
    <message>
        <source>source, sends a pulse every 64 ms</source>
        <translation>Quelle, sendet alle 64&#xa0;ms einen Puls</translation>
    </message>
</context>
<context>
    <name>noctule::ui::MarkList</name>
    <message>
        <source>Markers in this take</source>
        <translation>Marken in dieser Aufnahme</translation>
    </message>
</context>
<context>
    <name>noctule::ui::MarkerEditor</name>
    <message>
        <source>Marker %1</source>
        <comment>name of a marker, a number</comment>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>Name the marker %1</source>
        <translation>Die Marke %1 benennen</translation>
    </message>
    <message>
        <source>Delete the marker %1</source>
        <translation>Die Marke %1 löschen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::MarkersPanel</name>
    <message>
        <source>Markers</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <comment>time, name</comment>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>M sets a marker at the cursor.</source>
        <translation>M setzt eine Marke am Zeiger.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::MotionDialog</name>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>The motion becomes a take of this session: a simulated suit is worn by the person that it shows.</source>
        <translation>Die Bewegung wird eine Aufnahme dieser Sitzung: Die Person, die sie zeigt, trägt einen simulierten Anzug.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Exchange left and right</source>
        <translation>Links und rechts vertauschen</translation>
    </message>
    <message>
        <source>Find again</source>
        <translation>Neu finden</translation>
    </message>
    <message>
        <source>Save as bone map</source>
        <translation>Zuordnung speichern</translation>
    </message>
    <message>
        <source>Frame of the motion</source>
        <translation>Bild der Bewegung</translation>
    </message>
    <message>
        <source>Ideal: no noise at all</source>
        <translation>Ideal: ganz ohne Rauschen</translation>
    </message>
    <message>
        <source>Nominal: as in a good room</source>
        <translation>Nominal: wie in einem guten Raum</translation>
    </message>
    <message>
        <source>Realistic: slipping boards, soft tissue</source>
        <translation>Realistisch: rutschende Platinen, Weichgewebe</translation>
    </message>
    <message>
        <source>Suit and room</source>
        <translation>Anzug und Raum</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Figur</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Zero pose</source>
        <translation>Nullpose</translation>
    </message>
    <message>
        <source>Found by itself</source>
        <translation>Automatisch erkannt</translation>
    </message>
    <message>
        <source>Y is up</source>
        <translation>Y zeigt nach oben</translation>
    </message>
    <message>
        <source>Z is up</source>
        <translation>Z zeigt nach oben</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Hochachse</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Decimetres (MakeHuman)</source>
        <translation>Dezimeter (MakeHuman)</translation>
    </message>
    <message>
        <source>CMU&apos;s unit, 5.64 cm</source>
        <translation>Einheit der CMU, 5,64&#xa0;cm</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>as the file shows</source>
        <translation>wie die Datei zeigt</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Corrections of an earlier import with the same joints are in force.</source>
        <translation>Korrekturen eines früheren Imports mit denselben Gelenken gelten.</translation>
    </message>
    <message>
        <source>Understanding %1</source>
        <translation>%1 wird gedeutet</translation>
    </message>
    <message>
        <source>not in the file</source>
        <translation>nicht in der Datei</translation>
    </message>
    <message>
        <source>Joint of %1</source>
        <translation>Gelenk für: %1</translation>
    </message>
    <message>
        <source>Bone maps (*.json)</source>
        <translation>Knochenzuordnungen (*.json)</translation>
    </message>
    <message>
        <source>no person was found</source>
        <translation>keine Person gefunden</translation>
    </message>
    <message>
        <source>%1 at %2 per second</source>
        <comment>frames, rate</comment>
        <translation>%1 mit %2 je Sekunde</translation>
    </message>
    <message>
        <source>%1 of %2 joints matched</source>
        <translation>%1 von %2 Gelenken zugeordnet</translation>
    </message>
    <message>
        <source>No person was found yet.</source>
        <translation>Noch wurde keine Person gefunden.</translation>
    </message>
    <message>
        <source>The motion is being read.</source>
        <translation>Die Bewegung wird gelesen.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>Die Datei ist nicht lesbar.</translation>
    </message>
    <message>
        <source>Say which joints are which first.</source>
        <translation>Zuerst die Gelenke zuordnen.</translation>
    </message>
    <message>
        <source>%1 tall, %2 points up, 1 unit is %3 m</source>
        <comment>height, axis, length</comment>
        <translation>%1 groß, %2 zeigt nach oben, 1 Einheit ist %3&#xa0;m</translation>
    </message>
</context>
<context>
    <name>noctule::ui::MotionPicture</name>
    <message>
        <source>The figure from the front and from its left</source>
        <translation>Die Figur von vorn und von ihrer linken Seite</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From its left</source>
        <translation>Von seiner Linken</translation>
    </message>
    <message>
        <source>its left</source>
        <translation>seine Linke</translation>
    </message>
</context>
<context>
    <name>noctule::ui::NameField</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
</context>
<context>
    <name>noctule::ui::NewSessionDialog</name>
    <message>
        <source>New session</source>
        <translation>Neue Sitzung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Create session</source>
        <translation>Sitzung anlegen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Takes, calibration and exports go in here. The folder can be copied and moved.</source>
        <translation>Hier liegen Aufnahmen, Kalibrierung und Exporte. Der Ordner lässt sich kopieren und verschieben.</translation>
    </message>
    <message>
        <source>Performer</source>
        <translation>Darsteller</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Other measures follow from the height; they can be set later under Performer and suit.</source>
        <translation>Andere Maße folgen aus der Größe; sie lassen sich später unter Darsteller und Anzug einstellen.</translation>
    </message>
    <message>
        <source>Folder for the new session</source>
        <translation>Ordner für die neue Sitzung</translation>
    </message>
    <message>
        <source>The session needs a folder.</source>
        <translation>Die Sitzung braucht einen Ordner.</translation>
    </message>
    <message>
        <source>The folder needs its whole path, from the root on.</source>
        <translation>Der Ordner braucht seinen ganzen Pfad, von der Wurzel an.</translation>
    </message>
    <message>
        <source>%1 is a file. Choose another name for the folder.</source>
        <translation>%1 ist eine Datei. Einen anderen Namen für den Ordner wählen.</translation>
    </message>
    <message>
        <source>%1 holds a session already. Open it, or choose another name.</source>
        <translation>%1 enthält schon eine Sitzung. Diese öffnen oder einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>%1 holds files already. Choose a new or an empty folder.</source>
        <translation>%1 enthält schon Dateien. Einen neuen oder leeren Ordner wählen.</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 lässt sich nicht beschreiben. Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>The session needs a name.</source>
        <translation>Die Sitzung braucht einen Namen.</translation>
    </message>
    <message>
        <source>The performer needs a name.</source>
        <translation>Der Darsteller braucht einen Namen.</translation>
    </message>
    <message>
        <source>The session could not be made. Choose another folder.</source>
        <translation>Die Sitzung ließ sich nicht anlegen. Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>Name the performer</source>
        <translation>Darsteller benennen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::NewerValues</name>
    <message>
        <source>Newer values of this suit are there</source>
        <translation>Es gibt neuere Werte dieses Anzugs</translation>
    </message>
    <message>
        <source>Another session calibrated its sensors or sources, %1. The rest pose of this session stays.</source>
        <translation>Eine andere Sitzung hat seine Sensoren oder Quellen kalibriert, %1. Die Ruhehaltung dieser Sitzung bleibt.</translation>
    </message>
    <message>
        <source>Use them</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>The newer values are not in use</source>
        <translation>Die neueren Werte sind nicht in Gebrauch</translation>
    </message>
</context>
<context>
    <name>noctule::ui::NewsDialog</name>
    <message>
        <source>What is new</source>
        <translation>Was ist neu</translation>
    </message>
    <message>
        <source>In this version</source>
        <translation>In dieser Version</translation>
    </message>
    <message>
        <source>A virtual suit, so that all of this can be tried without one.</source>
        <translation>Ein virtueller Anzug, damit sich all das ohne Anzug ausprobieren lässt.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Driver boxes are found on USB and in the network; Connect says whether the suit is ready and what to do about it.</source>
        <translation>Steuerboxen werden an USB und im Netzwerk gefunden; der Schritt Verbinden sagt, ob der Anzug bereit ist und was zu tun ist.</translation>
    </message>
    <message>
        <source>Record from a suit: the live body with its rays, levels, a countdown, a shot list, markers and notes; the take opens in Review at once.</source>
        <translation>Von einem Anzug aufnehmen: der Körper live mit seinen Strahlen, Pegel, ein Countdown, eine Szenenliste, Marken und Notizen; die Aufnahme öffnet sich sofort im Schritt Prüfen.</translation>
    </message>
    <message>
        <source>Calibration wizards for source offsets, accelerometers, gyroscopes, rest pose and movement, and a check of three seconds before a take that matters.</source>
        <translation>Assistenten zur Kalibrierung von Quellenversatz, Beschleunigungssensoren, Gyroskopen, Ruhehaltung und Bewegung, und eine Kontrolle von drei Sekunden vor einer wichtigen Aufnahme.</translation>
    </message>
    <message>
        <source>Review with the body in three dimensions and plots of everything a take holds, all on one time; compare with a reference, read the report inside the window.</source>
        <translation>Prüfen mit dem Körper in drei Dimensionen und Diagrammen von allem, was eine Aufnahme enthält, alles auf einer Zeit; mit einer Referenz vergleichen, den Bericht im Fenster lesen.</translation>
    </message>
    <message>
        <source>Process a take again with other sensors or the filter of the paper, and see two results side by side.</source>
        <translation>Eine Aufnahme mit anderen Sensoren oder dem Filter der Veröffentlichung neu verarbeiten und zwei Ergebnisse nebeneinander sehen.</translation>
    </message>
    <message>
        <source>A mesh of your own as the body of the view, with bones or without; where its joints are is found, and can be moved by hand.</source>
        <translation>Ein eigenes Netz als Körper der Ansicht, mit Knochen oder ohne; wo seine Gelenke sind, wird gefunden und lässt sich von Hand verschieben.</translation>
    </message>
    <message>
        <source>Export to FBX, glTF, BVH, CSV and OpenSim, and as pictures and films; every file is read back and checked.</source>
        <translation>Export nach FBX, glTF, BVH, CSV und OpenSim sowie als Bilder und Filme; jede Datei wird zurückgelesen und geprüft.</translation>
    </message>
    <message>
        <source>Several people at once: each suit has its name and colour, one take holds them all, and distances between them and to anchors in the room join the estimate.</source>
        <translation>Mehrere Personen zugleich: Jeder Anzug hat Namen und Farbe, eine Aufnahme enthält alle, und Abstände zwischen ihnen und zu Ankern im Raum gehen in die Schätzung ein.</translation>
    </message>
    <message>
        <source>Recordings of other makers&apos; sensors become takes: Xsens, Movella DOT, x-IMU3, OpenSense, MATLAB, C3D, TRC and tables. Which sensor sits where is found from the movement.</source>
        <translation>Aufzeichnungen von Sensoren anderer Hersteller werden zu Aufnahmen: Xsens, Movella DOT, x-IMU3, OpenSense, MATLAB, C3D, TRC und Tabellen. Welcher Sensor wo sitzt, wird aus der Bewegung gefunden.</translation>
    </message>
    <message>
        <source>A robot&apos;s arms follow a suit live, or a take.</source>
        <translation>Die Arme eines Roboters folgen einem Anzug live oder einer Aufnahme.</translation>
    </message>
    <message>
        <source>Magnetometers have a wizard of their own, and a room is checked for bent fields.</source>
        <translation>Magnetometer haben einen eigenen Assistenten, und ein Raum wird auf verbogene Felder geprüft.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::NoSuit</name>
    <message>
        <source>Connect a suit</source>
        <translation>Anzug verbinden</translation>
    </message>
    <message>
        <source>No suit is connected. The live body, the levels of the boards and the record button appear here as soon as one is.</source>
        <translation>Kein Anzug ist verbunden. Der Körper, die Pegel der Platinen und der Aufnahmeknopf erscheinen hier, sobald einer verbunden ist.</translation>
    </message>
    <message>
        <source>noctule-virtual-suit is not beside this program.</source>
        <translation>noctule-virtual-suit liegt nicht neben diesem Programm.</translation>
    </message>
    <message>
        <source>Start the virtual suit</source>
        <translation>Virtuellen Anzug starten</translation>
    </message>
    <message>
        <source>The virtual suit is starting. The first time its motion is prepared, which takes a while.</source>
        <translation>Der virtuelle Anzug startet. Beim ersten Mal wird seine Bewegung vorbereitet, das dauert eine Weile.</translation>
    </message>
    <message>
        <source>It is starting.</source>
        <translation>Er startet.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::NotesPanel</name>
    <message>
        <source>Notes of this take</source>
        <translation>Notizen zu dieser Aufnahme</translation>
    </message>
    <message>
        <source>What should be remembered of this take</source>
        <translation>Was von dieser Aufnahme in Erinnerung bleiben soll</translation>
    </message>
    <message>
        <source>Takes outside a session keep no notes.</source>
        <translation>Aufnahmen außerhalb einer Sitzung behalten keine Notizen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::Notices</name>
    <message numerus="yes">
        <source>and %n more</source>
        <comment>notices that are not shown</comment>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::PairGrid</name>
    <message>
        <source>Confidence per pair</source>
        <translation>Konfidenz je Paar</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PairsHeard</name>
    <message>
        <source>Pairs heard over the last ten seconds</source>
        <translation>Gehörte Paare der letzten zehn Sekunden</translation>
    </message>
    <message>
        <source>%1: heard with confidence %2 now</source>
        <translation>%1: jetzt mit Konfidenz %2 gehört</translation>
    </message>
    <message>
        <source>%1: not heard now</source>
        <translation>%1: jetzt nicht gehört</translation>
    </message>
    <message>
        <source>S%1</source>
        <comment>number of a source</comment>
        <translation>Q%1</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PanelTab</name>
    <message>
        <source>Show the panel %1</source>
        <translation>Das Feld %1 zeigen</translation>
    </message>
    <message>
        <source>%1: folded away because large text or a small window leaves it no room. A click shows it.</source>
        <translation>%1: weggeklappt, weil große Schrift oder ein kleines Fenster ihm keinen Platz lässt. Ein Klick zeigt es.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PerformerButtons</name>
    <message>
        <source>Show %1</source>
        <comment>a performer</comment>
        <translation>%1 zeigen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PerformerEditor</name>
    <message>
        <source>Performer %1</source>
        <translation>Darsteller %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Height of %1</source>
        <translation>Größe von %1</translation>
    </message>
    <message>
        <source>Measure of %1</source>
        <translation>Maß von %1</translation>
    </message>
    <message>
        <source>Segment of %1</source>
        <translation>Glied von %1</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Lage von %1</translation>
    </message>
    <message>
        <source>Rotation of %1</source>
        <translation>Drehung von %1</translation>
    </message>
    <message>
        <source>Direction of %1</source>
        <translation>Richtung von %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 spiegeln</translation>
    </message>
    <message>
        <source>Put %1 back</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>name of a performer, number</comment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PerformerListPanel</name>
    <message>
        <source>Performers</source>
        <translation>Darsteller</translation>
    </message>
    <message>
        <source>Add a performer</source>
        <translation>Darsteller hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate this performer</source>
        <translation>Diesen Darsteller duplizieren</translation>
    </message>
    <message>
        <source>Rename this performer</source>
        <translation>Diesen Darsteller umbenennen</translation>
    </message>
    <message>
        <source>Remove this performer</source>
        <translation>Diesen Darsteller entfernen</translation>
    </message>
    <message>
        <source>Wears the suit</source>
        <translation>Trägt den Anzug</translation>
    </message>
    <message>
        <source>A session has at least one performer.</source>
        <translation>Eine Sitzung hat mindestens einen Darsteller.</translation>
    </message>
    <message>
        <source>Put the suit on %1</source>
        <translation>%1 den Anzug anziehen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PerformerMeasuresPanel</name>
    <message>
        <source>Measure once more</source>
        <translation>Noch einmal messen</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>What is left empty follows the height.</source>
        <translation>Was leer bleibt, folgt der Größe.</translation>
    </message>
    <message>
        <source>%1: %2 is long for this height, where %3 is usual.</source>
        <translation>%1: %2 ist lang für diese Größe, üblich sind %3.</translation>
    </message>
    <message>
        <source>%1: %2 is short for this height, where %3 is usual.</source>
        <translation>%1: %2 ist kurz für diese Größe, üblich sind %3.</translation>
    </message>
    <message>
        <source>Trunk and legs make a height of %1, not %2.</source>
        <translation>Rumpf und Beine ergeben eine Größe von %1, nicht %2.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PerformerPage</name>
    <message>
        <source>Performers belong to a session. Make one or open one first.</source>
        <translation>Darsteller gehören zu einer Sitzung. Zuerst eine anlegen oder öffnen.</translation>
    </message>
    <message>
        <source>Go to Start</source>
        <translation>Zum Start</translation>
    </message>
    <message>
        <source>Performers</source>
        <translation>Darsteller</translation>
    </message>
    <message>
        <source>Boards and sources</source>
        <translation>Platinen und Quellen</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>Mirror to the other side</source>
        <translation>Auf die andere Seite spiegeln</translation>
    </message>
    <message>
        <source>Back to the suit’s place</source>
        <translation>Zurück an den Platz des Anzugs</translation>
    </message>
    <message>
        <source>Performer and suit</source>
        <translation>Darsteller und Anzug</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PerformerPlacementPanel</name>
    <message>
        <source>Choose a board or a source in the list or on the body to move and turn it.</source>
        <translation>Eine Platine oder Quelle in der Liste oder am Körper wählen, um sie zu bewegen und zu drehen.</translation>
    </message>
    <message>
        <source>A board 5 mm and 3° away from where it is placed here costs about 2° in the joints around it.</source>
        <translation>Eine Platine, die 5&#xa0;mm und 3° anders sitzt als hier angegeben, kostet etwa 2° in den Gelenken ringsum.</translation>
    </message>
    <message>
        <source>Boards and sources</source>
        <translation>Platinen und Quellen</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Glied</translation>
    </message>
    <message>
        <source>X, to the left</source>
        <translation>X, nach links</translation>
    </message>
    <message>
        <source>Y, up</source>
        <translation>Y, nach oben</translation>
    </message>
    <message>
        <source>Z, forward</source>
        <translation>Z, nach vorn</translation>
    </message>
    <message>
        <source> mm</source>
        <comment>unit after a number</comment>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <comment>degrees after a number</comment>
        <translation>°</translation>
    </message>
    <message>
        <source>Mirror to the other side</source>
        <translation>Auf die andere Seite spiegeln</translation>
    </message>
    <message>
        <source>Back to the suit’s place</source>
        <translation>Zurück an den Platz des Anzugs</translation>
    </message>
    <message>
        <source>It has no counterpart on the other side.</source>
        <translation>Auf der anderen Seite gibt es kein Gegenstück.</translation>
    </message>
    <message>
        <source>The suit that comes with Noctule has no such part.</source>
        <translation>Der Anzug, der mit Noctule kommt, hat kein solches Teil.</translation>
    </message>
    <message>
        <source>It is where the suit has it.</source>
        <translation>Es sitzt, wo der Anzug es hat.</translation>
    </message>
    <message>
        <source>Turned about X</source>
        <translation>Gedreht um X</translation>
    </message>
    <message>
        <source>Turned about Y</source>
        <translation>Gedreht um Y</translation>
    </message>
    <message>
        <source>Turned about Z</source>
        <translation>Gedreht um Z</translation>
    </message>
    <message>
        <source>Points to the left</source>
        <translation>Zeigt nach links</translation>
    </message>
    <message>
        <source>Points up</source>
        <translation>Zeigt nach oben</translation>
    </message>
    <message>
        <source>Axes of the segment as they lie in a T pose.</source>
        <translation>Achsen des Glieds, wie sie in der T-Pose liegen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PerformerSwitch</name>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PlaceReset</name>
    <message>
        <source>Reset heading and place</source>
        <translation>Richtung und Platz zurücksetzen</translation>
    </message>
    <message>
        <source>No suit is connected. Connect one first.</source>
        <translation>Kein Anzug ist verbunden. Zuerst einen verbinden.</translation>
    </message>
    <message>
        <source>The room&apos;s anchors give heading and place.</source>
        <translation>Richtung und Platz kommen von den Ankern des Raums.</translation>
    </message>
    <message>
        <source>No sound arrives from the suit.</source>
        <translation>Vom Anzug kommt kein Schall an.</translation>
    </message>
    <message>
        <source>No body is shown live.</source>
        <translation>Live ist kein Körper zu sehen.</translation>
    </message>
    <message>
        <source>Heading and place were not reset</source>
        <translation>Richtung und Platz wurden nicht zurückgesetzt</translation>
    </message>
    <message>
        <source>heading and place reset</source>
        <translation>Richtung und Platz zurückgesetzt</translation>
    </message>
    <message>
        <source>heading and place reset, taken back</source>
        <translation>Zurücksetzen von Richtung und Platz zurückgenommen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>performer, what a marker in the take says</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Heading and place are here</source>
        <translation>Richtung und Platz sind hier</translation>
    </message>
    <message>
        <source>The countdown has ended. Heading and place stay.</source>
        <translation>Der Countdown ist beendet. Richtung und Platz bleiben.</translation>
    </message>
    <message>
        <source>Heading and place are reset in %1&#xa0;s. The same key ends the countdown.</source>
        <translation>In %1&#xa0;s werden Richtung und Platz zurückgesetzt. Dieselbe Taste beendet den Countdown.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PlotLane</name>
    <message>
        <source>%1 ±%2</source>
        <comment>value and two standard deviations</comment>
        <translation>%1 ±%2</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PlotPanel</name>
    <message>
        <source>More plots</source>
        <translation>Weitere Diagramme</translation>
    </message>
    <message>
        <source>Open a take to see its curves.</source>
        <translation>Eine Aufnahme öffnen, um ihre Kurven zu sehen.</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>Entfernungen</translation>
    </message>
    <message>
        <source>Raw sound</source>
        <translation>Rohton</translation>
    </message>
    <message>
        <source>Inertial</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>Joint angles</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Wurzel</translation>
    </message>
    <message>
        <source>Show %1</source>
        <comment>a plot</comment>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Kanal hinzufügen</translation>
    </message>
    <message>
        <source>Picture of the plots</source>
        <translation>Bild der Diagramme</translation>
    </message>
    <message>
        <source>Copy as picture</source>
        <translation>Als Bild kopieren</translation>
    </message>
    <message>
        <source>Save as PNG…</source>
        <translation>Als PNG speichern&#xa0;…</translation>
    </message>
    <message>
        <source>Values of the plots</source>
        <translation>Werte der Diagramme</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern&#xa0;…</translation>
    </message>
    <message>
        <source>%1, lower 2 sigma</source>
        <translation>%1, untere 2 Sigma</translation>
    </message>
    <message>
        <source>%1, upper 2 sigma</source>
        <translation>%1, obere 2 Sigma</translation>
    </message>
    <message>
        <source>%1_plots</source>
        <comment>file name</comment>
        <translation>%1_diagramme</translation>
    </message>
    <message>
        <source>The plots are on the clipboard</source>
        <translation>Die Diagramme sind in der Zwischenablage</translation>
    </message>
    <message>
        <source>Save the plots as a picture</source>
        <translation>Diagramme als Bild speichern</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Bild (*.png)</translation>
    </message>
    <message>
        <source>The values are on the clipboard</source>
        <translation>Die Werte sind in der Zwischenablage</translation>
    </message>
    <message>
        <source>Save the values that are shown</source>
        <translation>Gezeigte Werte speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Zwischen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Every change acts at once and is kept.</source>
        <translation>Jede Änderung wirkt sofort und bleibt erhalten.</translation>
    </message>
    <message>
        <source>A take is being recorded. Change this when it has ended.</source>
        <translation>Gerade läuft eine Aufnahme. Ändern Sie das, wenn sie zu Ende ist.</translation>
    </message>
    <message>
        <source>A calibration is under way. Finish or leave it first.</source>
        <translation>Gerade läuft eine Kalibrierung. Beenden oder verlassen Sie sie erst.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>%1 %</source>
        <comment>size of text in percent</comment>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Size of text</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Reduce motion</source>
        <translation>Bewegung verringern</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>3D picture</source>
        <translation>3D-Bild</translation>
    </message>
    <message>
        <source>As in Blender: middle button</source>
        <translation>Wie in Blender: mittlere Taste</translation>
    </message>
    <message>
        <source>As in Maya: Alt and a button</source>
        <translation>Wie in Maya: Alt und eine Taste</translation>
    </message>
    <message>
        <source>Turn and move</source>
        <translation>Drehen und bewegen</translation>
    </message>
    <message>
        <source>Folders</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Choose the folder for new sessions</source>
        <translation>Ordner für neue Sitzungen wählen</translation>
    </message>
    <message>
        <source>New sessions go into</source>
        <translation>Neue Sitzungen in</translation>
    </message>
    <message>
        <source>Folder for new sessions</source>
        <translation>Ordner für neue Sitzungen</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>There is nothing to save by hand: every change of a session is on disk within a second, and a take is never changed, results are added to it. After a crash the start page says what is safe.</source>
        <translation>Von Hand ist nichts zu speichern: jede Änderung einer Sitzung ist binnen einer Sekunde auf dem Datenträger, und eine Aufnahme wird nie verändert, Ergebnisse kommen hinzu. Nach einem Absturz sagt die Startseite, was sicher ist.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>They send CaptureStart and CaptureStop over UDP, as motion capture systems do.</source>
        <translation>Sie senden CaptureStart und CaptureStop über UDP, wie es Systeme der Bewegungsaufnahme tun.</translation>
    </message>
    <message>
        <source>Countdown</source>
        <translation>Countdown</translation>
    </message>
    <message>
        <source>UDP port</source>
        <translation>UDP-Port</translation>
    </message>
    <message>
        <source>Other programs may start and stop recordings</source>
        <translation>Andere Programme dürfen Aufnahmen starten und beenden</translation>
    </message>
    <message>
        <source>Listening for other programs on this port.</source>
        <translation>Auf diesem Port empfangsbereit für andere Programme.</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Spoken cues</source>
        <translation>Sprachhinweise</translation>
    </message>
    <message>
        <source>Countdown, start and stop of recordings, and the next step of a calibration are spoken.</source>
        <translation>Countdown, Beginn und Ende von Aufnahmen und der nächste Schritt einer Kalibrierung werden gesprochen.</translation>
    </message>
    <message>
        <source>No speech is installed on this computer. On Debian: speech-dispatcher and qtspeech5-speechd-plugin.</source>
        <translation>Auf diesem Rechner ist keine Sprachausgabe installiert. Unter Debian: speech-dispatcher und qtspeech5-speechd-plugin.</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Tones on</source>
        <translation>Töne auf</translation>
    </message>
    <message>
        <source>%1, not there</source>
        <comment>a sound device</comment>
        <translation>%1, nicht da</translation>
    </message>
    <message>
        <source>Spoken cues are played where the desktop plays its speech.</source>
        <translation>Sprachhinweise kommen dort, wo die Arbeitsumgebung spricht.</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Metric: metres, centimetres</source>
        <translation>Metrisch: Meter, Zentimeter</translation>
    </message>
    <message>
        <source>Imperial: feet, inches</source>
        <translation>Angloamerikanisch: Fuß, Zoll</translation>
    </message>
    <message>
        <source>For people and rooms. Errors of measurement stay in millimetres; plots, places of boards and files stay metric. Any unit may be typed: 5&apos;11&quot;, 71 in, 180 cm, 1.8 m.</source>
        <translation>Für Menschen und Räume. Messfehler bleiben in Millimetern; Kurven, Plätze der Platinen und Dateien bleiben metrisch. Getippt werden darf jede Einheit: 5&apos;11&quot;, 71&#xa0;in, 180&#xa0;cm, 1,8&#xa0;m.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ProblemCard</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ProcessTakesDialog</name>
    <message>
        <source>Process</source>
        <translation>Verarbeiten</translation>
    </message>
    <message>
        <source>Takes to process</source>
        <translation>Zu verarbeitende Aufnahmen</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message numerus="yes">
        <source>Process %n take(s)</source>
        <translation>
            <numerusform>%n Aufnahme verarbeiten</numerusform>
            <numerusform>%n Aufnahmen verarbeiten</numerusform>
        </translation>
    </message>
    <message>
        <source>Tick at least one take.</source>
        <translation>Mindestens eine Aufnahme ankreuzen.</translation>
    </message>
    <message>
        <source>Takes of %1 get the bone lengths that this calibration found.</source>
        <translation>Aufnahmen von %1 bekommen die Knochenlängen, die diese Kalibrierung fand.</translation>
    </message>
    <message>
        <source>A result is added to each; recordings and earlier results stay.</source>
        <translation>Jede bekommt ein Ergebnis dazu; Aufzeichnungen und frühere Ergebnisse bleiben.</translation>
    </message>
    <message>
        <source>Each take is processed as accurately as possible, with all sensors and the calibration that it was recorded with.</source>
        <translation>Jede Aufnahme wird so genau wie möglich verarbeitet, mit allen Sensoren und der Kalibrierung, mit der sie aufgenommen wurde.</translation>
    </message>
    <message>
        <source>Each take is processed as accurately as possible, with all sensors and the calibration that it was recorded with; one recorded without gets “%1”.</source>
        <translation>Jede Aufnahme wird so genau wie möglich verarbeitet, mit allen Sensoren und der Kalibrierung, mit der sie aufgenommen wurde; eine ohne bekommt „%1“.</translation>
    </message>
    <message>
        <source>Each take is processed as accurately as possible, with all sensors and the calibration “%1”; takes of several performers keep their own.</source>
        <translation>Jede Aufnahme wird so genau wie möglich verarbeitet, mit allen Sensoren und der Kalibrierung „%1“; Aufnahmen mehrerer Darsteller behalten ihre eigene.</translation>
    </message>
    <message>
        <source>Process takes</source>
        <translation>Aufnahmen verarbeiten</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ProgressLine</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PulseBars</name>
    <message>
        <source>Pulses heard</source>
        <translation>Gehörte Pulse</translation>
    </message>
    <message>
        <source>source %1: not heard</source>
        <translation>Quelle %1: nicht gehört</translation>
    </message>
    <message>
        <source>source %1: %2</source>
        <comment>number, confidence</comment>
        <translation>Quelle %1: %2</translation>
    </message>
</context>
<context>
    <name>noctule::ui::PutOnDialog</name>
    <message>
        <source>Put the suit on</source>
        <translation>Anzug anlegen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number and title of a step</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Tight clothes first</source>
        <translation>Zuerst enge Kleidung</translation>
    </message>
    <message>
        <source>Boards must not slide on cloth. A thin, close layer keeps them on the limb.</source>
        <translation>Platinen dürfen auf Stoff nicht rutschen. Eine dünne, enge Schicht hält sie am Körper.</translation>
    </message>
    <message>
        <source>Vest with the driver box</source>
        <translation>Weste mit der Steuerbox</translation>
    </message>
    <message>
        <source>The box sits on the back. Chest, ribs and belly carry seven sources; nothing may cover their front.</source>
        <translation>Die Box sitzt am Rücken. Brust, Rippen und Bauch tragen sieben Quellen; nichts darf sie vorn verdecken.</translation>
    </message>
    <message>
        <source>Hat</source>
        <translation>Hut</translation>
    </message>
    <message>
        <source>Its source looks down from the brim, so that the shoulders hear it. The board sits on the forehead.</source>
        <translation>Seine Quelle schaut von der Krempe nach unten, damit die Schultern sie hören. Die Platine sitzt auf der Stirn.</translation>
    </message>
    <message>
        <source>Boards from the trunk outwards</source>
        <translation>Platinen vom Rumpf nach außen</translation>
    </message>
    <message>
        <source>Pelvis, abdomen, chest, then clavicles, arms and hands, then thighs, shins and feet. The microphone faces away from the body.</source>
        <translation>Becken, Bauch, Brust, dann Schlüsselbeine, Arme und Hände, dann Oberschenkel, Unterschenkel und Füße. Das Mikrofon zeigt vom Körper weg.</translation>
    </message>
    <message>
        <source>Tight, not painful</source>
        <translation>Fest, nicht schmerzhaft</translation>
    </message>
    <message>
        <source>On muscle a loose strap is the largest error of all. Above the ankle and above the wrist hold best.</source>
        <translation>Auf Muskeln ist ein loser Gurt der größte Fehler von allen. Über Knöchel und Handgelenk sitzt es am besten.</translation>
    </message>
    <message>
        <source>Look once around</source>
        <translation>Einmal ringsum schauen</translation>
    </message>
    <message>
        <source>Cables lie flat and leave the joints free; numbers on boards and drawing agree.</source>
        <translation>Kabel liegen flach und lassen die Gelenke frei; Nummern auf Platinen und Zeichnung stimmen überein.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RailStep</name>
    <message>
        <source>%1, %2, done</source>
        <translation>%1, %2, fertig</translation>
    </message>
    <message>
        <source>%1, %2, now</source>
        <translation>%1, %2, jetzt</translation>
    </message>
    <message>
        <source>%1, %2, to come</source>
        <translation>%1, %2, kommt noch</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RatingStars</name>
    <message>
        <source>Rating</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>Rating, keys 0 to 5</source>
        <translation>Bewertung, Tasten 0 bis 5</translation>
    </message>
    <message numerus="yes">
        <source>%n of 5 stars</source>
        <translation>
            <numerusform>%n von 5 Sternen</numerusform>
            <numerusform>%n von 5 Sternen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReadinessPanel</name>
    <message>
        <source>Boards</source>
        <translation>Platinen</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Good pairs</source>
        <translation>Gute Paare</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Storage</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Start the virtual suit</source>
        <translation>Virtuellen Anzug starten</translation>
    </message>
    <message>
        <source>Performer and suit</source>
        <translation>Darsteller und Anzug</translation>
    </message>
    <message>
        <source>Put the suit on</source>
        <translation>Anzug anlegen</translation>
    </message>
    <message>
        <source>Show the worst only</source>
        <translation>Nur das Schlimmste zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>problems</comment>
        <translation>
            <numerusform>%n weiteres</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n faint</source>
        <translation>
            <numerusform>%1, %n schwach</numerusform>
            <numerusform>%1, %n schwach</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>charge, time left</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Continue without board %1</source>
        <translation>Weiter ohne Platine %1</translation>
    </message>
    <message numerus="yes">
        <source>Continue without %n boards</source>
        <translation>
            <numerusform>Weiter ohne %n Platine</numerusform>
            <numerusform>Weiter ohne %n Platinen</numerusform>
        </translation>
    </message>
    <message>
        <source>Continue anyway</source>
        <translation>Trotzdem weiter</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Connect %1</source>
        <translation>%1 verbinden</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>known exactly</source>
        <translation>genau bekannt</translation>
    </message>
    <message>
        <source>Continue to Calibrate</source>
        <translation>Weiter zu Kalibrieren</translation>
    </message>
    <message>
        <source>of this suit, from an earlier session (%1)</source>
        <comment>an age</comment>
        <translation>dieses Anzugs, aus einer früheren Sitzung (%1)</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReadinessWords</name>
    <message>
        <source>No sound arrives</source>
        <translation>Kein Ton kommt an</translation>
    </message>
    <message>
        <source>The driver box is there and sends nothing. Wait a moment; if it stays so, switch it off and on again.</source>
        <translation>Die Steuerbox ist da und sendet nichts. Einen Moment warten; bleibt es so, sie aus- und wieder einschalten.</translation>
    </message>
    <message>
        <source>The link is broken</source>
        <translation>Die Verbindung ist unterbrochen</translation>
    </message>
    <message>
        <source>The driver box has not answered since %1. The studio tries again by itself; check the cable or the network.</source>
        <translation>Die Steuerbox antwortet seit %1 nicht. Das Studio versucht es von selbst wieder; Kabel oder Netzwerk prüfen.</translation>
    </message>
    <message>
        <source>Push its plug in until it clicks; if the light stays dark, change the cable.</source>
        <translation>Den Stecker eindrücken, bis er klickt; bleibt das Licht dunkel, das Kabel wechseln.</translation>
    </message>
    <message>
        <source>Board %1, %2, fell silent at %3.</source>
        <translation>Platine %1, %2, ist um %3 verstummt.</translation>
    </message>
    <message>
        <source>Nothing has come from board %1, %2, so far.</source>
        <translation>Von Platine %1, %2, ist bisher nichts gekommen.</translation>
    </message>
    <message>
        <source>Blink board %1</source>
        <translation>Platine %1 blinken lassen</translation>
    </message>
    <message>
        <source>Go on without it</source>
        <translation>Ohne sie weitermachen</translation>
    </message>
    <message>
        <source>%1 sends nothing</source>
        <translation>%1 sendet nichts</translation>
    </message>
    <message>
        <source>%1 cannot be understood</source>
        <translation>%1 ist nicht zu verstehen</translation>
    </message>
    <message>
        <source>Board %1 sends something, but hardly a whole frame. Check its plug and its cable; if that does not help, change the board.</source>
        <translation>Platine %1 sendet etwas, aber kaum einen ganzen Rahmen. Stecker und Kabel prüfen; hilft das nicht, die Platine wechseln.</translation>
    </message>
    <message>
        <source>%1 loses frames</source>
        <translation>%1 verliert Rahmen</translation>
    </message>
    <message>
        <source>Board %1 brings %2 of %3 frames a second. Check its plug and its cable.</source>
        <translation>Platine %1 bringt %2 von %3 Rahmen je Sekunde. Stecker und Kabel prüfen.</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Übergehen</translation>
    </message>
    <message>
        <source>%1 reaches its limits</source>
        <translation>%1 stößt an ihre Grenzen</translation>
    </message>
    <message>
        <source>Board %1 was overdriven %2 times in the last second. Fasten it so that it cannot knock against anything.</source>
        <translation>Platine %1 war in der letzten Sekunde %2-mal übersteuert. So befestigen, dass sie nirgends anstößt.</translation>
    </message>
    <message>
        <source>%1 hears no source</source>
        <translation>%1 hört keine Quelle</translation>
    </message>
    <message>
        <source>Source %1 is not heard</source>
        <translation>Quelle %1 wird nicht gehört</translation>
    </message>
    <message>
        <source>Source %1 is faint</source>
        <translation>Quelle %1 ist schwach</translation>
    </message>
    <message>
        <source>%1: no board hears it. Check its plug; a strap or fold may cover it.</source>
        <comment>place of a source</comment>
        <translation>%1: keine Platine hört sie. Den Stecker prüfen; ein Gurt oder eine Falte kann sie verdecken.</translation>
    </message>
    <message>
        <source>%1: only %2 of its %3 pairs are good. A strap or fold probably covers it.</source>
        <comment>place of a source</comment>
        <translation>%1: nur %2 ihrer %3 Paare sind gut. Wahrscheinlich verdeckt sie ein Gurt oder eine Falte.</translation>
    </message>
    <message>
        <source>Play source %1</source>
        <translation>Quelle %1 tönen lassen</translation>
    </message>
    <message>
        <source>The battery is almost empty</source>
        <translation>Der Akku ist fast leer</translation>
    </message>
    <message>
        <source>The battery is low</source>
        <translation>Der Akku ist schwach</translation>
    </message>
    <message>
        <source>The disk is almost full</source>
        <translation>Der Datenträger ist fast voll</translation>
    </message>
    <message>
        <source>There is room for %1 of recording. Free some space, or choose another folder for the session.</source>
        <translation>Es ist Platz für %1 Aufnahme. Platz schaffen oder einen anderen Ordner für die Sitzung wählen.</translation>
    </message>
    <message>
        <source>No suit is connected</source>
        <translation>Kein Anzug ist verbunden</translation>
    </message>
    <message>
        <source>Choose a driver box, or start the virtual suit.</source>
        <translation>Eine Steuerbox wählen oder den virtuellen Anzug starten.</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Looking at the suit</source>
        <translation>Der Anzug wird angesehen</translation>
    </message>
    <message>
        <source>In a moment it is clear what arrives.</source>
        <translation>Gleich ist klar, was ankommt.</translation>
    </message>
    <message>
        <source>Not ready yet</source>
        <translation>Noch nicht bereit</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>board %1</source>
        <translation>Platine %1</translation>
    </message>
    <message>
        <source>no signal since %1</source>
        <translation>kein Signal seit %1</translation>
    </message>
    <message>
        <source>no signal</source>
        <translation>kein Signal</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <comment>that are good</comment>
        <translation>%1 von %2 Paaren</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1&#xa0;min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1&#xa0;h</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1&#xa0;h %2&#xa0;min</translation>
    </message>
    <message>
        <source>Link broken</source>
        <translation>Verbindung unterbrochen</translation>
    </message>
    <message>
        <source>Board %1 has heard no pulse for ten seconds. Check whether a strap or a fold covers its microphone.</source>
        <translation>Platine %1 hat seit zehn Sekunden keinen Puls gehört. Prüfen, ob ein Gurt oder eine Falte ihr Mikrofon verdeckt.</translation>
    </message>
    <message>
        <source>It is not known which board sits where</source>
        <translation>Welche Platine wo sitzt, ist nicht bekannt</translation>
    </message>
    <message>
        <source>The driver box does not tell; the boards are shown in the order of their plugs. Find each by moving, or drag it onto its body part.</source>
        <translation>Die Steuerbox sagt es nicht; die Platinen stehen in der Reihenfolge ihrer Stecker. Jede durch Bewegen finden oder auf ihren Körperteil ziehen.</translation>
    </message>
    <message>
        <source>Board %1 blinks</source>
        <translation>Platine %1 blinkt</translation>
    </message>
    <message>
        <source>%1 is left; the driver box switches off within a minute. Charge it now.</source>
        <translation>%1 sind übrig; die Steuerbox schaltet sich binnen einer Minute ab. Jetzt laden.</translation>
    </message>
    <message>
        <source>%1 is left, about %2. Charge it before a long take.</source>
        <translation>%1 sind übrig, etwa %2. Vor einer langen Aufnahme laden.</translation>
    </message>
    <message>
        <source>%1 is left. Charge it before a long take.</source>
        <translation>%1 sind übrig. Vor einer langen Aufnahme laden.</translation>
    </message>
    <message>
        <source>The suit is not calibrated</source>
        <translation>Der Anzug ist nicht kalibriert</translation>
    </message>
    <message>
        <source>Without calibration of %1</source>
        <translation>Ohne Kalibrierung %1</translation>
    </message>
    <message>
        <source>Takes can be recorded and processed once it is calibrated; until then nobody sees whether they are good. Calibrate it, or import its calibration.</source>
        <translation>Aufnahmen lassen sich machen und verarbeiten, sobald er kalibriert ist; bis dahin sieht niemand, ob sie gut sind. Ihn kalibrieren oder seine Kalibrierung importieren.</translation>
    </message>
    <message>
        <source>The body moves, less exactly than it could. Calibrate what is missing.</source>
        <translation>Der Körper bewegt sich, weniger genau, als er könnte. Kalibrieren, was fehlt.</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>The rest pose is from %1.</source>
        <translation>Die Ruhehaltung ist von: %1.</translation>
    </message>
    <message>
        <source>It is not known when the rest pose was made.</source>
        <translation>Es ist nicht bekannt, wann die Ruhehaltung kalibriert wurde.</translation>
    </message>
    <message>
        <source>Check the suit</source>
        <translation>Anzug kontrollieren</translation>
    </message>
    <message>
        <source>Something has moved since the calibration</source>
        <translation>Etwas ist seit der Kalibrierung verrutscht</translation>
    </message>
    <message>
        <source>Put back what the check named and check again, or calibrate the rest pose again.</source>
        <translation>Zurücksetzen, was die Kontrolle nannte, und wieder kontrollieren oder die Ruhehaltung neu kalibrieren.</translation>
    </message>
    <message>
        <source>Not checked since it was put on</source>
        <translation>Seit dem Anlegen nicht kontrolliert</translation>
    </message>
    <message>
        <source>%1: the calibration is not usable</source>
        <translation>%1: die Kalibrierung ist nicht brauchbar</translation>
    </message>
    <message>
        <source>It was saved all the same. Takes made with it are less exact than they could be, or wrong. Calibrate again.</source>
        <translation>Sie wurde trotzdem gespeichert. Aufnahmen damit sind ungenauer als möglich oder falsch. Neu kalibrieren.</translation>
    </message>
    <message>
        <source>The rest pose is %1 old</source>
        <comment>an age</comment>
        <translation>Die Ruhehaltung ist %1 alt</translation>
    </message>
    <message>
        <source>The suit was probably put on anew since, and its boards sit otherwise. Calibrate the rest pose again, or check the suit if nobody took it off.</source>
        <translation>Der Anzug wurde seither wohl neu angelegt, und seine Platinen sitzen anders. Die Ruhehaltung neu kalibrieren oder den Anzug kontrollieren, wenn ihn niemand ausgezogen hat.</translation>
    </message>
    <message>
        <source>%1: the calibration is %2 old</source>
        <comment>an age</comment>
        <translation>%1: die Kalibrierung ist %2 alt</translation>
    </message>
    <message>
        <source>Offsets of sources hold for a year. Takes can be recorded all the same; calibrate when there is time.</source>
        <translation>Der Versatz der Quellen gilt ein Jahr. Aufnehmen ist trotzdem möglich; kalibrieren, wenn Zeit ist.</translation>
    </message>
    <message>
        <source>Values of sensors hold for three months. Takes can be recorded all the same; calibrate when there is time.</source>
        <translation>Werte der Sensoren gelten drei Monate. Aufnehmen ist trotzdem möglich; kalibrieren, wenn Zeit ist.</translation>
    </message>
    <message>
        <source>Hold still for three seconds: the check says whether boards sit in their places, slipped or were exchanged. Was the suit taken off since, calibrate the rest pose again.</source>
        <translation>Drei Sekunden stillhalten: die Kontrolle sagt, ob Platinen auf ihren Plätzen sitzen, verrutscht oder vertauscht sind. Wurde der Anzug seither ausgezogen, die Ruhehaltung neu kalibrieren.</translation>
    </message>
    <message>
        <source>No board sends anything</source>
        <translation>Keine Platine sendet etwas</translation>
    </message>
    <message numerus="yes">
        <source>%n boards send nothing</source>
        <translation>
            <numerusform>%n Platine sendet nichts</numerusform>
            <numerusform>%n Platinen senden nichts</numerusform>
        </translation>
    </message>
    <message>
        <source>So many at once have one cause: the driver box or the cable that they share. Check its plug, then switch the box off and on again.</source>
        <translation>So viele zugleich haben eine Ursache: die Steuerbox oder das gemeinsame Kabel. Dessen Stecker prüfen, dann die Box aus- und wieder einschalten.</translation>
    </message>
    <message>
        <source>Go on without them</source>
        <translation>Ohne sie weitermachen</translation>
    </message>
    <message numerus="yes">
        <source>%n boards cannot be understood</source>
        <translation>
            <numerusform>%n Platine ist nicht zu verstehen</numerusform>
            <numerusform>%n Platinen sind nicht zu verstehen</numerusform>
        </translation>
    </message>
    <message>
        <source>They send something, but hardly a whole frame. So many at once have one cause: the link or the driver box. Switch the box off and on again.</source>
        <translation>Sie senden etwas, aber kaum einen ganzen Rahmen. So viele zugleich haben eine Ursache: die Verbindung oder die Steuerbox. Die Box aus- und wieder einschalten.</translation>
    </message>
    <message>
        <source>The stream loses frames</source>
        <translation>Der Datenstrom verliert Rahmen</translation>
    </message>
    <message numerus="yes">
        <source>%n boards bring about %1 of %2 frames a second, all alike: the link or this computer is too slow. Use a cable or a nearer access point, and close other programs.</source>
        <translation>
            <numerusform>%n Platine bringt etwa %1 von %2 Rahmen je Sekunde: die Verbindung oder dieser Rechner ist zu langsam. Ein Kabel oder einen näheren Zugangspunkt verwenden und andere Programme schließen.</numerusform>
            <numerusform>%n Platinen bringen etwa %1 von %2 Rahmen je Sekunde, alle gleich: die Verbindung oder dieser Rechner ist zu langsam. Ein Kabel oder einen näheren Zugangspunkt verwenden und andere Programme schließen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boards reach their limits</source>
        <translation>
            <numerusform>%n Platine erreicht ihre Grenzen</numerusform>
            <numerusform>%n Platinen erreichen ihre Grenzen</numerusform>
        </translation>
    </message>
    <message>
        <source>They were overdriven about %1 times each in the last second. Loud noise near the suit or blows do that; look whether the boards are fastened.</source>
        <translation>Sie wurden in der letzten Sekunde je etwa %1-mal übersteuert. Lauter Lärm am Anzug oder Stöße bewirken das; nachsehen, ob die Platinen fest sitzen.</translation>
    </message>
    <message>
        <source>No board hears any source</source>
        <translation>Keine Platine hört eine Quelle</translation>
    </message>
    <message numerus="yes">
        <source>%n boards hear no source</source>
        <translation>
            <numerusform>%n Platine hört keine Quelle</numerusform>
            <numerusform>%n Platinen hören keine Quelle</numerusform>
        </translation>
    </message>
    <message>
        <source>So many at once have one cause: the sources. Check whether they are plugged in and switched on.</source>
        <translation>So viele zugleich haben eine Ursache: die Quellen. Prüfen, ob sie eingesteckt und eingeschaltet sind.</translation>
    </message>
    <message>
        <source>No source is heard</source>
        <translation>Keine Quelle ist zu hören</translation>
    </message>
    <message numerus="yes">
        <source>%n sources are not heard</source>
        <translation>
            <numerusform>%n Quelle ist nicht zu hören</numerusform>
            <numerusform>%n Quellen sind nicht zu hören</numerusform>
        </translation>
    </message>
    <message>
        <source>So many at once have one cause: the plug or the cable of the sources at the driver box. Push it in until it clicks.</source>
        <translation>So viele zugleich haben eine Ursache: Stecker oder Kabel der Quellen an der Steuerbox. Eindrücken, bis es klickt.</translation>
    </message>
    <message>
        <source>One thing to fix.</source>
        <translation>Eines zu beheben.</translation>
    </message>
    <message numerus="yes">
        <source>%n things to fix.</source>
        <translation>
            <numerusform>%n Sache zu beheben.</numerusform>
            <numerusform>%n Sachen zu beheben.</numerusform>
        </translation>
    </message>
    <message>
        <source>One thing to know.</source>
        <translation>Eines zu wissen.</translation>
    </message>
    <message numerus="yes">
        <source>%n things to know.</source>
        <translation>
            <numerusform>%n Sache zu wissen.</numerusform>
            <numerusform>%n Sachen zu wissen.</numerusform>
        </translation>
    </message>
    <message>
        <source>All %1 boards and %2 sources are here.</source>
        <translation>Alle %1 Platinen und %2 Quellen sind da.</translation>
    </message>
    <message>
        <source>%1 of %2 boards and %3 of %4 sources are here.</source>
        <translation>%1 von %2 Platinen und %3 von %4 Quellen sind da.</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>its light blinks</source>
        <translation>ihr Licht blinkt</translation>
    </message>
    <message>
        <source>Recording, with problems</source>
        <translation>Aufnahme läuft, mit Problemen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a performer, sentences</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>last known</source>
        <translation>zuletzt bekannt</translation>
    </message>
    <message>
        <source>Places of the anchors are found to decimetres only. Calibrate the source offsets, or import the calibration of this box.</source>
        <translation>Die Plätze der Anker werden nur auf Dezimeter gefunden. Die Quellenversätze kalibrieren oder die Kalibrierung dieser Box importieren.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecentSessionModel</name>
    <message>
        <source>No takes yet</source>
        <translation>Noch keine Aufnahmen</translation>
    </message>
    <message numerus="yes">
        <source>%n take(s), %1</source>
        <comment>number of takes, their time together</comment>
        <translation>
            <numerusform>%n Aufnahme, %1</numerusform>
            <numerusform>%n Aufnahmen, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged</source>
        <comment>takes</comment>
        <translation>
            <numerusform>%n beschädigt</numerusform>
            <numerusform>%n beschädigt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n interrupted</source>
        <comment>takes</comment>
        <translation>
            <numerusform>%n unterbrochen</numerusform>
            <numerusform>%n unterbrochen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not processed</source>
        <comment>takes</comment>
        <translation>
            <numerusform>%n nicht verarbeitet</numerusform>
            <numerusform>%n nicht verarbeitet</numerusform>
        </translation>
    </message>
    <message>
        <source>Processed</source>
        <translation>Verarbeitet</translation>
    </message>
    <message>
        <source>Can be rebuilt from its takes</source>
        <translation>Lässt sich aus den Aufnahmen neu aufbauen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecentSessions</name>
    <message>
        <source>The folder is not there</source>
        <translation>Der Ordner ist nicht da</translation>
    </message>
    <message>
        <source>Looking at recent sessions</source>
        <translation>Letzte Sitzungen werden angesehen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordActions</name>
    <message>
        <source>Record or stop</source>
        <translation>Aufnehmen oder beenden</translation>
    </message>
    <message>
        <source>End the countdown</source>
        <translation>Countdown abbrechen</translation>
    </message>
    <message>
        <source>Marker now</source>
        <translation>Marke jetzt</translation>
    </message>
    <message>
        <source>Note now</source>
        <translation>Notiz jetzt</translation>
    </message>
    <message>
        <source>Take name</source>
        <translation>Name der Aufnahme</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordBar</name>
    <message>
        <source>No countdown</source>
        <translation>Kein Countdown</translation>
    </message>
    <message>
        <source>Countdown %1&#xa0;s</source>
        <translation>Countdown %1&#xa0;s</translation>
    </message>
    <message>
        <source>Cancel</source>
        <comment>the countdown</comment>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Speichert</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Take name</source>
        <translation>Name der Aufnahme</translation>
    </message>
    <message>
        <source>Take name (%1). Numbers count by themselves, and nothing is overwritten.</source>
        <comment>a key</comment>
        <translation>Name der Aufnahme (%1). Nummern zählen von selbst, und nichts wird überschrieben.</translation>
    </message>
    <message>
        <source>The system&apos;s bell with each second of the countdown, at start and at stop</source>
        <translation>Der Systemton bei jeder Sekunde des Countdowns, am Anfang und am Ende</translation>
    </message>
    <message>
        <source>While it runs</source>
        <translation>Während sie läuft</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Open in Review after stop</source>
        <translation>Danach in Prüfen öffnen</translation>
    </message>
    <message>
        <source>Note at this moment; Enter keeps it</source>
        <translation>Notiz zu diesem Moment; Eingabe behält sie</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message numerus="yes">
        <source>%n second(s)</source>
        <translation>
            <numerusform>%n Sekunde</numerusform>
            <numerusform>%n Sekunden</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, pre-roll %2&#xa0;s</source>
        <translation>%1, Vorlauf %2&#xa0;s</translation>
    </message>
    <message>
        <source>Countdown</source>
        <translation>Countdown</translation>
    </message>
    <message>
        <source>The countdown gives you time after the button. With a pre-roll the take begins that much earlier than the recording; be in the rest pose by then.</source>
        <translation>Der Countdown gibt Zeit nach dem Knopf. Mit Vorlauf beginnt die Aufnahme um so viel früher; dann schon in der Ruhehaltung stehen.</translation>
    </message>
    <message>
        <source>Pre-roll, from before the recording begins</source>
        <translation>Vorlauf, von vor dem Beginn der Aufnahme</translation>
    </message>
    <message>
        <source>No pre-roll: each stream of this suit begins in the rest pose</source>
        <translation>Kein Vorlauf: Jeder Datenstrom dieses Anzugs beginnt in der Ruhehaltung</translation>
    </message>
    <message>
        <source>next: %1</source>
        <translation>dann: %1</translation>
    </message>
    <message>
        <source>Tones on</source>
        <translation>Töne an</translation>
    </message>
    <message>
        <source>Tones off</source>
        <translation>Töne aus</translation>
    </message>
    <message>
        <source>Markers and notes belong to a take that is being recorded.</source>
        <translation>Marken und Notizen gehören zu einer laufenden Aufnahme.</translation>
    </message>
    <message>
        <source>Stop both</source>
        <translation>Beide beenden</translation>
    </message>
    <message>
        <source>Stop all %1</source>
        <translation>Alle %1 beenden</translation>
    </message>
    <message>
        <source>Record both</source>
        <translation>Beide aufnehmen</translation>
    </message>
    <message>
        <source>Record all %1</source>
        <translation>Alle %1 aufnehmen</translation>
    </message>
    <message>
        <source>No pre-roll: several suits begin together</source>
        <translation>Kein Vorlauf: mehrere Anzüge beginnen zusammen</translation>
    </message>
    <message>
        <source>on</source>
        <comment>tones</comment>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <comment>tones</comment>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordButton</name>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Countdown: press to end it</source>
        <translation>Countdown: drücken bricht ihn ab</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>The take is being saved</source>
        <translation>Die Aufnahme wird gespeichert</translation>
    </message>
    <message>
        <source>Record: press to hear what is in the way</source>
        <translation>Aufnehmen: drücken zeigt, was im Weg steht</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordCenter</name>
    <message>
        <source>New session in another folder</source>
        <translation>Neue Sitzung in anderem Ordner</translation>
    </message>
    <message>
        <source>shot %1 of %2, %3</source>
        <translation>Szene %1 von %2, %3</translation>
    </message>
    <message>
        <source>Record anyway</source>
        <translation>Trotzdem aufnehmen</translation>
    </message>
    <message>
        <source>Open Connect</source>
        <translation>Verbinden öffnen</translation>
    </message>
    <message>
        <source>Reset heading and place</source>
        <translation>Richtung und Platz zurücksetzen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordPage</name>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>No session</source>
        <translation>Keine Sitzung</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>Bereitschaft</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordProblems</name>
    <message>
        <source>To look at</source>
        <translation>Anzusehen</translation>
    </message>
    <message>
        <source>The disk has %1 left</source>
        <translation>Der Datenträger reicht noch für %1</translation>
    </message>
    <message>
        <source>Recording stops by itself then, and the take is complete. Free some space, or choose another folder.</source>
        <translation>Dann endet die Aufnahme von selbst und ist vollständig. Platz schaffen oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>%1 are missing in this take</source>
        <translation>%1 fehlen in dieser Aufnahme</translation>
    </message>
    <message numerus="yes">
        <source>They are marked as %n gap(s), and time does not shift.</source>
        <translation>
            <numerusform>Sie sind als eine Lücke markiert, und die Zeit verschiebt sich nicht.</numerusform>
            <numerusform>Sie sind als %n Lücken markiert, und die Zeit verschiebt sich nicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>The take is safe up to here and goes on when the box is back; the gap will be marked.</source>
        <translation>Die Aufnahme ist bis hierher sicher und geht weiter, wenn die Steuerbox zurück ist; die Lücke wird markiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>things to look at</comment>
        <translation>
            <numerusform>eine weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Show on body</source>
        <translation>Am Körper zeigen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordReadiness</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Platinen</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Good pairs</source>
        <translation>Gute Paare</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Storage</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Live view</source>
        <translation>Live-Ansicht</translation>
    </message>
    <message>
        <source>Calibration in use</source>
        <translation>Verwendete Kalibrierung</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Erstellt</translation>
    </message>
    <message>
        <source>Source offsets</source>
        <translation>Quellenversatz</translation>
    </message>
    <message>
        <source>the body hides the others; a quarter is usual</source>
        <translation>die anderen verdeckt der Körper; ein Viertel ist üblich</translation>
    </message>
    <message>
        <source>%1&#xa0;ms behind</source>
        <translation>%1&#xa0;ms dahinter</translation>
    </message>
    <message>
        <source>broken</source>
        <comment>a link</comment>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>%1&#xa0;MB/s</source>
        <translation>%1&#xa0;MB/s</translation>
    </message>
    <message>
        <source>is there</source>
        <comment>a link</comment>
        <translation>steht</translation>
    </message>
    <message>
        <source>%1 blocks lost, %2 damaged</source>
        <translation>%1 Blöcke verloren, %2 beschädigt</translation>
    </message>
    <message>
        <source>%1 at this rate</source>
        <translation>noch %1 bei diesem Verbrauch</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>%1 in this take</source>
        <translation>%1 in dieser Aufnahme</translation>
    </message>
    <message>
        <source>speed of sound %1&#xa0;m/s</source>
        <translation>Schallgeschwindigkeit %1&#xa0;m/s</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>at an unknown time</source>
        <translation>zu unbekannter Zeit</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Kontrolliert</translation>
    </message>
    <message>
        <source>Check the suit</source>
        <translation>Anzug kontrollieren</translation>
    </message>
    <message>
        <source>Stand still for three seconds: says whether a strap has moved</source>
        <translation>Drei Sekunden still stehen: sagt, ob ein Gurt verrutscht ist</translation>
    </message>
    <message>
        <source>not yet</source>
        <comment>a suit was checked</comment>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>good, %1</source>
        <comment>a check, its time</comment>
        <translation>gut, %1</translation>
    </message>
    <message>
        <source>something moved, %1</source>
        <comment>a check, its time</comment>
        <translation>etwas hat sich bewegt, %1</translation>
    </message>
    <message>
        <source>There is no calibration to check.</source>
        <translation>Es gibt keine Kalibrierung zu kontrollieren.</translation>
    </message>
    <message>
        <source>A take is being recorded; check before the next one.</source>
        <translation>Eine Aufnahme läuft; vor der nächsten kontrollieren.</translation>
    </message>
    <message>
        <source>Connect one to see whether it is ready.</source>
        <translation>Einen verbinden, um zu sehen, ob er bereit ist.</translation>
    </message>
    <message>
        <source>Recording, with problems</source>
        <translation>Aufnahme läuft, mit Problemen</translation>
    </message>
    <message>
        <source>Live, performers stand in a row, %1 apart. Where they really are to each other comes with processing, after the take.</source>
        <translation>Live stehen die Darsteller in einer Reihe, %1 auseinander. Wo sie wirklich zueinander sind, ergibt die Verarbeitung nach der Aufnahme.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordRun</name>
    <message>
        <source>There is no room for a take in %1. Free some space, or record into a session in another folder.</source>
        <translation>In %1 ist kein Platz für eine Aufnahme. Platz schaffen oder in eine Sitzung in einem anderen Ordner aufnehmen.</translation>
    </message>
    <message>
        <source>take</source>
        <comment>first part of the names of takes</comment>
        <translation>aufnahme</translation>
    </message>
    <message>
        <source>The driver box has not answered yet</source>
        <translation>Die Steuerbox hat noch nicht geantwortet</translation>
    </message>
    <message>
        <source>It usually takes a second or two.</source>
        <translation>Das dauert meist ein, zwei Sekunden.</translation>
    </message>
    <message>
        <source>The link to the driver box is broken</source>
        <translation>Die Verbindung zur Steuerbox ist unterbrochen</translation>
    </message>
    <message>
        <source>Recording can begin as soon as it is back; the studio tries by itself.</source>
        <translation>Sobald sie zurück ist, kann die Aufnahme beginnen; das Studio versucht es von selbst.</translation>
    </message>
    <message>
        <source>Recording did not begin</source>
        <translation>Die Aufnahme hat nicht begonnen</translation>
    </message>
    <message>
        <source>%1 ended by itself</source>
        <comment>name of a take</comment>
        <translation>%1 endete von selbst</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>Another program asked for a recording, which did not begin</source>
        <translation>Ein anderes Programm wollte eine Aufnahme, die nicht begann</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>The recording has ended by itself</source>
        <translation>Die Aufnahme ist von selbst zu Ende gegangen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>who wears a suit, what hinders it</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordSidebar</name>
    <message>
        <source>%1, %2</source>
        <comment>take, state</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>being saved</source>
        <comment>a take</comment>
        <translation>wird gespeichert</translation>
    </message>
    <message>
        <source>recording</source>
        <comment>a take</comment>
        <translation>läuft</translation>
    </message>
    <message>
        <source>%1 kept, %2</source>
        <comment>number of takes, their time</comment>
        <translation>%1 behalten, %2</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecordingDialog</name>
    <message>
        <source>rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>field</source>
        <translation>Magnetfeld</translation>
    </message>
    <message>
        <source>attitude</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message numerus="yes">
        <source>Import %1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere importieren</numerusform>
            <numerusform>%1 und %n weitere importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording becomes a take of this session. Its files stay as they are; nothing is written before Import.</source>
        <translation>Die Aufzeichnung wird eine Aufnahme dieser Sitzung. Ihre Dateien bleiben, wie sie sind; vor „Importieren“ wird nichts geschrieben.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Find by movement</source>
        <translation>Aus Bewegung finden</translation>
    </message>
    <message>
        <source>Choose a map</source>
        <translation>Zuordnung wählen</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlend</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Weltachsen</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Glied</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Enthält</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>nirgends</translation>
    </message>
    <message>
        <source>Segment of sensor %1</source>
        <translation>Glied von Sensor %1</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1&#xa0;Hz</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1, for %2</source>
        <comment>number of sensors, time</comment>
        <translation>%1, %2 lang</translation>
    </message>
    <message>
        <source>%1 of %2 rows</source>
        <translation>%1 von %2 Zeilen</translation>
    </message>
    <message>
        <source>comes with the recording</source>
        <translation>liegt der Aufzeichnung bei</translation>
    </message>
    <message>
        <source>Finding where each sensor sits</source>
        <translation>Es wird gesucht, wo jeder Sensor sitzt</translation>
    </message>
    <message>
        <source>Sensor %1 is placed on %2 without being sure.</source>
        <comment>id, segment</comment>
        <translation>Sensor %1 gehört vermutlich zu: %2; sicher ist das nicht.</translation>
    </message>
    <message>
        <source>%1 is no import map.</source>
        <translation>%1 ist keine Zuordnung für den Import.</translation>
    </message>
    <message>
        <source>Choose a map of sensors or columns</source>
        <translation>Zuordnung der Sensoren oder Spalten wählen</translation>
    </message>
    <message>
        <source>Import maps (*.json)</source>
        <translation>Import-Zuordnungen (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s) sit nowhere: poses leave them out.</source>
        <translation>
            <numerusform>%n Sensor sitzt nirgends: Posen lassen ihn aus.</numerusform>
            <numerusform>%n Sensoren sitzen nirgends: Posen lassen sie aus.</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording is being read.</source>
        <translation>Die Aufzeichnung wird gelesen.</translation>
    </message>
    <message>
        <source>Nothing was read yet.</source>
        <translation>Es wurde noch nichts gelesen.</translation>
    </message>
    <message>
        <source>One sensor alone sits anywhere.</source>
        <translation>Ein einzelner Sensor kann überall sitzen.</translation>
    </message>
    <message>
        <source>The files cannot be read.</source>
        <translation>Die Dateien sind nicht lesbar.</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>%1 is ready</source>
        <translation>%1 ist bereit</translation>
    </message>
    <message>
        <source>%1 is imported, without poses</source>
        <translation>%1 ist importiert, ohne Posen</translation>
    </message>
    <message>
        <source>East, north, up</source>
        <translation>Ost, Nord, oben</translation>
    </message>
    <message>
        <source>North, west, up (MVN)</source>
        <translation>Nord, West, oben (MVN)</translation>
    </message>
    <message>
        <source>North, east, down</source>
        <translation>Nord, Ost, unten</translation>
    </message>
    <message>
        <source>Forward, up, right (OpenSim)</source>
        <translation>vorn, oben, rechts (OpenSim)</translation>
    </message>
    <message>
        <source>Noctule&apos;s: Y is up</source>
        <translation>wie Noctule: Y ist oben</translation>
    </message>
    <message>
        <source>Say what the columns are</source>
        <translation>Spalten benennen</translation>
    </message>
    <message>
        <source>Looking at the columns</source>
        <translation>Spalten werden angesehen</translation>
    </message>
    <message>
        <source>The columns are being looked at.</source>
        <translation>Die Spalten werden gerade angesehen.</translation>
    </message>
    <message>
        <source>They are as you said for the last table with this header; check the units.</source>
        <translation>Sie sind, wie Sie es für die letzte Tabelle mit dieser Kopfzeile gesagt haben; prüfen Sie die Einheiten.</translation>
    </message>
    <message>
        <source>Nobody has said yet what the columns of this table are</source>
        <translation>Noch hat niemand gesagt, was die Spalten dieser Tabelle sind</translation>
    </message>
    <message>
        <source>Say it here, or choose a map that does</source>
        <translation>Sagen Sie es hier, oder wählen Sie eine Zuordnung</translation>
    </message>
    <message>
        <source>One sensor alone makes no body; the verb orient of the command line finds how it turns.</source>
        <translation>Ein Sensor allein ergibt keinen Körper; der Befehl orient der Befehlszeile findet, wie er sich dreht.</translation>
    </message>
    <message>
        <source>No sensor sits on a segment: the take will show no body.</source>
        <translation>Kein Sensor sitzt auf einem Glied: Die Aufnahme wird keinen Körper zeigen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RecoveryWords</name>
    <message>
        <source>%1. Rebuilding makes a new session.json from what the takes know: performers, suits and the order of recording. Ratings, notes, in and out are not in the takes; a damaged session.json is kept beside the new one.</source>
        <comment>what is wrong and which takes are safe</comment>
        <translation>%1. Neu aufbauen legt eine neue session.json aus dem an, was die Aufnahmen wissen: Darsteller, Anzüge und die Reihenfolge der Aufzeichnung. Bewertungen, Notizen, Anfang und Ende stehen nicht in den Aufnahmen; eine beschädigte session.json bleibt neben der neuen erhalten.</translation>
    </message>
    <message>
        <source>Recover checks it and makes a whole take of it; the recording itself is kept in the trash of the session.</source>
        <translation>Wiederherstellen prüft es und macht eine ganze Aufnahme daraus; die Aufzeichnung selbst bleibt im Papierkorb der Sitzung.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReferencePanel</name>
    <message>
        <source>A motion is being attached.</source>
        <translation>Eine Bewegung wird angehängt.</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Anhängen</translation>
    </message>
    <message>
        <source>Looking at the reference</source>
        <translation>Die Referenz wird angesehen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Open a take first.</source>
        <translation>Zuerst eine Aufnahme öffnen.</translation>
    </message>
    <message>
        <source>Truth of the simulation</source>
        <translation>Wahrheit der Simulation</translation>
    </message>
    <message>
        <source>Attached reference</source>
        <translation>Angehängte Referenz</translation>
    </message>
    <message>
        <source>in the take</source>
        <translation>in der Aufnahme</translation>
    </message>
    <message>
        <source>%1 of %2 joints matched</source>
        <translation>%1 von %2 Gelenken zugeordnet</translation>
    </message>
    <message>
        <source>aligned by %1, %2</source>
        <translation>um %1 verschoben, %2</translation>
    </message>
    <message>
        <source>Choose a recording of the same performance</source>
        <translation>Aufzeichnung derselben Darbietung wählen</translation>
    </message>
    <message>
        <source>Motions and positions (%1)</source>
        <translation>Bewegungen und Positionen (%1)</translation>
    </message>
    <message>
        <source>Attaching %1 to %2</source>
        <translation>%1 wird an %2 angehängt</translation>
    </message>
    <message>
        <source>Aligned by %1, %2 frames lie within the take.</source>
        <translation>Um %1 verschoben; %2 Bilder liegen innerhalb der Aufnahme.</translation>
    </message>
    <message>
        <source>Compare with the reference</source>
        <translation>Mit der Referenz vergleichen</translation>
    </message>
    <message>
        <source>A reference is attached to %1, the first performer of the take.</source>
        <translation>Eine Referenz wird an %1 gehängt, den ersten Darsteller der Aufnahme.</translation>
    </message>
    <message>
        <source>A motion, markers or positions of another system, to compare with.</source>
        <translation>Eine Bewegung, Marker oder Positionen eines anderen Systems, zum Vergleichen.</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>%1 an %2 anhängen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RenderThread</name>
    <message>
        <source>The 3D view cannot be drawn: no OpenGL context could be made.</source>
        <translation>Die 3D-Ansicht kann nicht gezeichnet werden: Es ließ sich kein OpenGL-Kontext anlegen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReportBrowser</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReportPanel</name>
    <message>
        <source>Process</source>
        <translation>Verarbeiten</translation>
    </message>
    <message>
        <source>Open full report</source>
        <translation>Ganzen Bericht öffnen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Foot slide</source>
        <translation>Fußrutschen</translation>
    </message>
    <message>
        <source>Drift of heading</source>
        <translation>Drift der Richtung</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>of time backed
by ranges</source>
        <translation>der Zeit durch
Entfernungen gestützt</translation>
    </message>
    <message>
        <source>Open a take first.</source>
        <translation>Zuerst eine Aufnahme öffnen.</translation>
    </message>
    <message>
        <source>Process the take first.</source>
        <translation>Zuerst die Aufnahme verarbeiten.</translation>
    </message>
    <message>
        <source>The report of the open take will be here.</source>
        <translation>Hier wird der Bericht der offenen Aufnahme stehen.</translation>
    </message>
    <message>
        <source>The take is recorded but not processed yet. Its verdict will be here.</source>
        <translation>Die Aufnahme ist aufgezeichnet, aber noch nicht verarbeitet. Hier wird ihr Urteil stehen.</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Nicht beurteilt</translation>
    </message>
    <message>
        <source>Judging the take</source>
        <translation>Die Aufnahme wird beurteilt</translation>
    </message>
    <message>
        <source>Its sensors and results are being compared.</source>
        <translation>Ihre Sensoren und Ergebnisse werden verglichen.</translation>
    </message>
    <message>
        <source>mean joint error
against the reference</source>
        <translation>mittlerer Gelenkfehler
gegen die Referenz</translation>
    </message>
    <message>
        <source>mean joint error,
no reference</source>
        <translation>mittlerer Gelenkfehler,
keine Referenz</translation>
    </message>
    <message>
        <source>without signal,
longest %1</source>
        <translation>ohne Signal,
am längsten %1</translation>
    </message>
    <message>
        <source>without signal,
no gaps</source>
        <translation>ohne Signal,
keine Lücken</translation>
    </message>
    <message>
        <source>%1 per minute</source>
        <translation>%1 je Minute</translation>
    </message>
    <message>
        <source>unknown without reference</source>
        <translation>ohne Referenz unbekannt</translation>
    </message>
    <message numerus="yes">
        <source>%n more in the full report</source>
        <translation>
            <numerusform>%n weitere im ganzen Bericht</numerusform>
            <numerusform>%n weitere im ganzen Bericht</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 per step</source>
        <translation>%1 je Schritt</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n gefunden</numerusform>
            <numerusform>%n gefunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n, set by hand</source>
        <translation>
            <numerusform>%n, von Hand gesetzt</numerusform>
            <numerusform>%n, von Hand gesetzt</numerusform>
        </translation>
    </message>
    <message>
        <source>range residual,
median; good: under %1</source>
        <translation>Restfehler,
Median; gut: unter %1</translation>
    </message>
    <message>
        <source>Half of the ranges used miss the pose by less. Root mean square, which a few echoes make large: %1.</source>
        <translation>Die Hälfte der verwendeten Entfernungen verfehlt die Pose um weniger. Quadratisches Mittel, das wenige Echos groß machen: %1.</translation>
    </message>
    <message>
        <source>The take is being processed. Its verdict will be here.</source>
        <translation>Die Aufnahme wird gerade verarbeitet. Hier steht dann ihr Urteil.</translation>
    </message>
    <message>
        <source>The file is damaged</source>
        <translation>Die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>Not all of the take can be read. The numbers are of what could be.</source>
        <translation>Nicht alles von der Aufnahme ist lesbar. Die Zahlen gelten für das, was gelesen wurde.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReportView</name>
    <message>
        <source>Find in the report</source>
        <translation>Im Bericht suchen</translation>
    </message>
    <message>
        <source>Parts of the report</source>
        <translation>Teile des Berichts</translation>
    </message>
    <message>
        <source>Back to the take</source>
        <translation>Zur Aufnahme</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Report of %1</source>
        <translation>Bericht zu %1</translation>
    </message>
    <message>
        <source>The report is being made.</source>
        <translation>Der Bericht wird erstellt.</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-Dokumente (*.pdf)</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 ließ sich nicht schreiben.</translation>
    </message>
    <message>
        <source>Choose another folder or free some space.</source>
        <translation>Einen anderen Ordner wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>As HTML</source>
        <translation>Als HTML</translation>
    </message>
    <message>
        <source>As PDF</source>
        <translation>Als PDF</translation>
    </message>
    <message>
        <source>Joints as CSV</source>
        <translation>Gelenke als CSV</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Find</source>
        <comment>in the report</comment>
        <translation>Suchen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReprocessDialog</name>
    <message>
        <source>Made %1</source>
        <translation>Erstellt %1</translation>
    </message>
    <message>
        <source>Nominal values of the suit</source>
        <translation>Nennwerte des Anzugs</translation>
    </message>
    <message>
        <source>Reprocess %1</source>
        <translation>%1 neu verarbeiten</translation>
    </message>
    <message>
        <source>Adds a result to the take. The recording and earlier results stay as they are.</source>
        <translation>Fügt der Aufnahme ein Ergebnis hinzu. Aufzeichnung und frühere Ergebnisse bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translation>Neu verarbeiten</translation>
    </message>
    <message>
        <source>Gyroscopes</source>
        <translation>Gyroskope</translation>
    </message>
    <message>
        <source>How every limb turns: smooth and quick, but drifts by degrees a minute.</source>
        <translation>Wie sich jedes Glied dreht: glatt und schnell, driftet aber um einige Grad je Minute.</translation>
    </message>
    <message>
        <source>Accelerometers</source>
        <translation>Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>Which way is down: holds the tilt of every limb.</source>
        <translation>Wo unten ist: hält die Neigung jedes Glieds.</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Entfernungen</translation>
    </message>
    <message>
        <source>Sound from source to board: holds heading and posture against drift.</source>
        <translation>Schall von Quelle zu Platine: hält Richtung und Haltung gegen Drift.</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Found by the filter, as in a live recording.</source>
        <translation>Vom Filter gefunden, wie bei einer Live-Aufnahme.</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Wurzel</translation>
    </message>
    <message>
        <source>Needs an external root: attach one under Reference first.</source>
        <translation>Braucht eine Wurzel von außen: zuerst unter Referenz anhängen.</translation>
    </message>
    <message>
        <source>Noctule</source>
        <translation>Noctule</translation>
    </message>
    <message>
        <source>Published filter</source>
        <translation>Veröffentlichter Filter</translation>
    </message>
    <message>
        <source>Vlasic 2007 to the letter, as a baseline for comparison.</source>
        <translation>Vlasic 2007 wörtlich, als Grundlage zum Vergleich.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Process sigma</source>
        <translation>Prozess-Sigma</translation>
    </message>
    <message>
        <source> rad/s²</source>
        <translation> rad/s²</translation>
    </message>
    <message>
        <source>In force in the take</source>
        <translation>In der Aufnahme gültig</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>Aus einer Datei</translation>
    </message>
    <message>
        <source>Becomes the one in force.</source>
        <translation>Wird die gültige.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>Kalibrierung wählen</translation>
    </message>
    <message>
        <source>Calibrations (*.json)</source>
        <translation>Kalibrierungen (*.json)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Under this name batch commands and exports find the result. A, G and D stand for accelerometers, gyroscopes and distances.</source>
        <translation>Unter diesem Namen finden Stapelbefehle und Exporte das Ergebnis. A, G und D stehen für Beschleunigungssensoren, Gyroskope und Entfernungen (distances).</translation>
    </message>
    <message>
        <source>Choose at least one kind of sensor.</source>
        <translation>Mindestens eine Art von Sensor wählen.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>As in a live recording.</source>
        <translation>Wie bei einer Live-Aufnahme.</translation>
    </message>
    <message>
        <source>Half a second</source>
        <translation>Eine halbe Sekunde</translation>
    </message>
    <message>
        <source>Whole take</source>
        <translation>Ganze Aufnahme</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>By the rise of the pulse</source>
        <translation>Am Anstieg des Pulses</translation>
    </message>
    <message>
        <source>By the whole pulse</source>
        <translation>Am ganzen Puls</translation>
    </message>
    <message>
        <source>Fits each source’s own pulse: finer where nothing stands in between.</source>
        <translation>Passt den eigenen Puls jeder Quelle an: feiner, wo nichts dazwischensteht.</translation>
    </message>
    <message>
        <source>Distances are measured</source>
        <translation>Entfernungen werden gemessen</translation>
    </message>
    <message>
        <source>Needs the recorded sound, which this take does not hold.</source>
        <translation>Braucht den aufgezeichneten Ton, den diese Aufnahme nicht enthält.</translation>
    </message>
    <message>
        <source>The filter of the paper has no smoother.</source>
        <translation>Der Filter der Veröffentlichung hat keine Glättung.</translation>
    </message>
    <message>
        <source>Each pose knows the 0.3 to 0.5 s that follow.</source>
        <translation>Jede Pose kennt die folgenden 0,3 bis 0,5&#xa0;s.</translation>
    </message>
    <message>
        <source>Level floor</source>
        <translation>Ebener Boden</translation>
    </message>
    <message>
        <source>Uneven, steps</source>
        <translation>Uneben, Stufen</translation>
    </message>
    <message>
        <source>Treadmill</source>
        <translation>Laufband</translation>
    </message>
    <message>
        <source>Contacts are not looked for</source>
        <translation>Kontakte werden nicht gesucht</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Untergrund</translation>
    </message>
    <message>
        <source>When the feet stand is found out; the root is the other system’s.</source>
        <translation>Wann die Füße stehen, wird ermittelt; die Wurzel ist die des anderen Systems.</translation>
    </message>
    <message>
        <source>Feet that stand hold the root: on a level floor their place and height, on uneven ground their place, on a treadmill nothing.</source>
        <translation>Füße, die stehen, halten die Wurzel: auf ebenem Boden an Ort und Höhe, auf unebenem am Ort, auf einem Laufband gar nicht.</translation>
    </message>
    <message>
        <source>Most probable motion</source>
        <translation>Wahrscheinlichste Bewegung</translation>
    </message>
    <message>
        <source>All readings weighed again together until nothing changes: the reference. Takes longer.</source>
        <translation>Alle Messwerte werden gemeinsam neu abgewogen, bis sich nichts mehr ändert: die Referenz. Dauert länger.</translation>
    </message>
    <message>
        <source>Process %1</source>
        <translation>%1 verarbeiten</translation>
    </message>
    <message>
        <source>Makes the motion out of the recording, which stays as it is.</source>
        <translation>Macht aus der Aufzeichnung die Bewegung; die Aufzeichnung bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Verarbeiten</translation>
    </message>
    <message>
        <source>From another system</source>
        <translation>Von einem anderen System</translation>
    </message>
    <message>
        <source>Its hips are used.</source>
        <translation>Dessen Hüfte wird verwendet.</translation>
    </message>
    <message>
        <source>Rotations without singularities; ranges that do not fit are left out.</source>
        <translation>Drehungen ohne Singularitäten; Entfernungen, die nicht passen, werden ausgelassen.</translation>
    </message>
    <message>
        <source>Each pose knows all that came before and after: the usual choice for a recorded take.</source>
        <translation>Jede Pose kennt alles davor und danach: die übliche Wahl für eine fertige Aufnahme.</translation>
    </message>
    <message>
        <source>As published by Vlasic 2007, and as in a live recording.</source>
        <translation>Wie von Vlasic 2007 veröffentlicht und wie bei einer Live-Aufnahme.</translation>
    </message>
    <message>
        <source>In use now</source>
        <translation>Jetzt in Gebrauch</translation>
    </message>
    <message>
        <source>The result will not be usable: there is no calibration of %1. Choose one that has it.</source>
        <translation>Das Ergebnis wird nicht nutzbar sein: es fehlt die Kalibrierung %1. Eine wählen, die sie hat.</translation>
    </message>
    <message>
        <source>The result will be less exact: there is no calibration of %1.</source>
        <translation>Das Ergebnis wird weniger genau sein: es fehlt die Kalibrierung %1.</translation>
    </message>
    <message>
        <source>Independent sensors</source>
        <translation>Unabhängige Sensoren</translation>
    </message>
    <message>
        <source>First how each sensor is turned, then the body. For suits without sound.</source>
        <translation>Erst die Lage jedes Sensors, dann der Körper. Für Anzüge ohne Ton.</translation>
    </message>
    <message>
        <source>Independent sensors are smoothed over the whole take or not at all.</source>
        <translation>Unabhängige Sensoren werden über die ganze Aufnahme geglättet oder gar nicht.</translation>
    </message>
    <message>
        <source>Independent sensors use all that each sensor measures.</source>
        <translation>Unabhängige Sensoren nutzen alles, was jeder Sensor misst.</translation>
    </message>
    <message>
        <source>Independent sensors find the root by the feet.</source>
        <translation>Unabhängige Sensoren finden die Wurzel über die Füße.</translation>
    </message>
    <message>
        <source>All performers together: where they stand to each other is found.</source>
        <translation>Alle Darsteller zusammen: Wo sie zueinander stehen, wird gefunden.</translation>
    </message>
    <message>
        <source>Each pose knows all that came before and after. Each performer for itself: where they stand to each other is not found.</source>
        <translation>Jede Pose kennt alles davor und danach. Jeder Darsteller für sich: Wo sie zueinander stehen, wird nicht gefunden.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>%1: each suit is processed alone, since they measure no distances.</source>
        <translation>%1: Jeder Anzug wird für sich verarbeitet, denn sie messen keine Abstände.</translation>
    </message>
    <message>
        <source>%1: each suit is processed alone, since this filter knows one body only.</source>
        <translation>%1: Jeder Anzug wird für sich verarbeitet, denn dieses Filter kennt nur einen Körper.</translation>
    </message>
    <message>
        <source>%1: each suit is processed alone, since smoothing goes over one body only.</source>
        <translation>%1: Jeder Anzug wird für sich verarbeitet, denn geglättet wird nur über einen Körper.</translation>
    </message>
    <message>
        <source>%1: each suit is processed alone, since another system says where everybody is.</source>
        <translation>%1: Jeder Anzug wird für sich verarbeitet, denn ein anderes System sagt, wo alle sind.</translation>
    </message>
    <message>
        <source>%1: each suit is processed alone, since no distances are used.</source>
        <translation>%1: Jeder Anzug wird für sich verarbeitet, denn es werden keine Abstände verwendet.</translation>
    </message>
    <message>
        <source>%1: all suits are processed together, with the ranges between them, where they heard each other.</source>
        <translation>%1: Alle Anzüge werden gemeinsam verarbeitet, mit den Entfernungen zwischen ihnen, wo sie einander hörten.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ResultSide</name>
    <message>
        <source>Save and use</source>
        <translation>Speichern und verwenden</translation>
    </message>
    <message>
        <source>Repeat steps</source>
        <translation>Schritte wiederholen</translation>
    </message>
    <message>
        <source>Save and use it anyway</source>
        <translation>Trotzdem speichern und verwenden</translation>
    </message>
    <message>
        <source>Nothing is changed by a check.</source>
        <translation>Eine Kontrolle ändert nichts.</translation>
    </message>
    <message>
        <source>Takes made with it would be wrong where the cards say so. Repeat what is named.</source>
        <translation>Aufnahmen damit wären falsch, wo die Karten es sagen. Wiederholen, was genannt ist.</translation>
    </message>
    <message>
        <source>Saved. Takes are made with another calibration now; step Calibrate has the list.</source>
        <translation>Gespeichert. Aufgenommen wird jetzt mit einer anderen Kalibrierung; die Liste steht im Schritt Kalibrieren.</translation>
    </message>
    <message>
        <source>Process takes again</source>
        <translation>Aufnahmen neu verarbeiten</translation>
    </message>
    <message>
        <source>Saved and in use. New takes are made with it; undo with %1.</source>
        <translation>Gespeichert und verwendet. Neue Aufnahmen entstehen damit; rückgängig mit %1.</translation>
    </message>
    <message>
        <source>Will be saved as %1, and later takes are made with it; undo with %2.</source>
        <translation>Wird als %1 gespeichert, und spätere Aufnahmen entstehen mit ihr; rückgängig mit %2.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReviewActions</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Voriges Bild</translation>
    </message>
    <message>
        <source>One second on</source>
        <translation>Eine Sekunde vor</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>Eine Sekunde zurück</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>Nächste Marke</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>Vorige Marke</translation>
    </message>
    <message>
        <source>In here</source>
        <translation>Anfang hier</translation>
    </message>
    <message>
        <source>Out here</source>
        <translation>Ende hier</translation>
    </message>
    <message>
        <source>Go to in</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Go to out</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>In and out at the ends</source>
        <translation>Anfang und Ende ganz außen</translation>
    </message>
    <message>
        <source>Marker here</source>
        <translation>Marke hier</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translation>Neu verarbeiten</translation>
    </message>
    <message>
        <source>Attach reference</source>
        <translation>Referenz anhängen</translation>
    </message>
    <message>
        <source>Open full report</source>
        <translation>Ganzen Bericht öffnen</translation>
    </message>
    <message>
        <source>Results side by side</source>
        <translation>Ergebnisse nebeneinander</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Name marker</source>
        <translation>Marke benennen</translation>
    </message>
    <message>
        <source>Delete marker</source>
        <translation>Marke löschen</translation>
    </message>
    <message>
        <source>Foot contact here</source>
        <translation>Fußkontakt hier</translation>
    </message>
    <message>
        <source>Back to the contacts that were found</source>
        <translation>Zurück zu den gefundenen Kontakten</translation>
    </message>
    <message>
        <source>Next performer</source>
        <translation>Nächster Darsteller</translation>
    </message>
    <message>
        <source>Delete contact</source>
        <translation>Kontakt löschen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReviewCenter</name>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Confidence per pair</source>
        <translation>Konfidenz je Paar</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReviewPage</name>
    <message>
        <source>A take will be seen here: its body, the confidence of its ranges and its curves.</source>
        <translation>Hier wird eine Aufnahme zu sehen sein: ihr Körper, die Konfidenz ihrer Entfernungen und ihre Kurven.</translation>
    </message>
    <message>
        <source>Try the virtual suit</source>
        <translation>Virtuellen Anzug ausprobieren</translation>
    </message>
    <message>
        <source>Save what can be read</source>
        <translation>Lesbares speichern</translation>
    </message>
    <message>
        <source>%1 is damaged: %2 What can be read goes into a new take.</source>
        <comment>take, why</comment>
        <translation>%1 ist beschädigt: %2 Was sich lesen lässt, kommt in eine neue Aufnahme.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>No session</source>
        <translation>Keine Sitzung</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReviewSidebar</name>
    <message>
        <source>Takes</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Session menu</source>
        <translation>Menü der Sitzung</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translation>Neu verarbeiten</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Made with</source>
        <translation>Erstellt mit</translation>
    </message>
    <message>
        <source>Rename session</source>
        <translation>Sitzung umbenennen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Import takes</source>
        <translation>Aufnahmen importieren</translation>
    </message>
    <message>
        <source>Takes (*.noctule)</source>
        <translation>Aufnahmen (*.noctule)</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Performers</source>
        <translation>Darsteller</translation>
    </message>
    <message>
        <source>Results of %1</source>
        <translation>Ergebnisse von %1</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Verarbeiten</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Process all unprocessed takes</source>
        <translation>Alle unverarbeiteten Aufnahmen verarbeiten</translation>
    </message>
    <message>
        <source>The take is being processed.</source>
        <translation>Die Aufnahme wird gerade verarbeitet.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ReviewWords</name>
    <message>
        <source>All sensors</source>
        <translation>Alle Sensoren</translation>
    </message>
    <message>
        <source>Without distances</source>
        <translation>Ohne Entfernungen</translation>
    </message>
    <message>
        <source>Without gyroscopes</source>
        <translation>Ohne Gyroskope</translation>
    </message>
    <message>
        <source>Without accelerometers</source>
        <translation>Ohne Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>Accelerometers only</source>
        <translation>Nur Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>Gyroscopes only</source>
        <translation>Nur Gyroskope</translation>
    </message>
    <message>
        <source>Distances only</source>
        <translation>Nur Entfernungen</translation>
    </message>
    <message>
        <source>No sensors</source>
        <translation>Keine Sensoren</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>%1 is off by %2</source>
        <translation>%1 liegt um %2 daneben</translation>
    </message>
    <message>
        <source>Ranges backed it %1 of the time, least from %2 on. In between it follows its gyroscope, which drifts by 1 to 3° a minute.</source>
        <translation>Entfernungen stützten es %1 der Zeit, am wenigsten ab %2. Dazwischen folgt es seinem Gyroskop, das um 1 bis 3° je Minute driftet.</translation>
    </message>
    <message>
        <source>Ranges backed it %1 of the time. In between it follows its gyroscope, which drifts by 1 to 3° a minute.</source>
        <translation>Entfernungen stützten es %1 der Zeit. Dazwischen folgt es seinem Gyroskop, das um 1 bis 3° je Minute driftet.</translation>
    </message>
    <message>
        <source>Show this board</source>
        <translation>Diese Platine zeigen</translation>
    </message>
    <message>
        <source>All boards lost %1 of their frames</source>
        <translation>Alle Platinen haben %1 ihrer Rahmen verloren</translation>
    </message>
    <message>
        <source>They lost them together: the link to the driver box broke off or was too slow. Check its cable or network before the next take.</source>
        <translation>Sie haben sie zugleich verloren: Die Verbindung zur Steuerbox riss ab oder war zu langsam. Vor der nächsten Aufnahme ihr Kabel oder das Netzwerk prüfen.</translation>
    </message>
    <message>
        <source>Most distances cannot be used</source>
        <translation>Die meisten Abstände sind nicht brauchbar</translation>
    </message>
    <message>
        <source>They lie below 0 or beyond 20 m, or miss the pose by far. Check the unit of recordings from elsewhere, else source offsets and places of boards.</source>
        <translation>Sie liegen unter 0 oder über 20&#xa0;m oder weit neben der Pose. Bei fremden Aufnahmen die Einheit prüfen, sonst die Versätze der Quellen und den Sitz der Platinen.</translation>
    </message>
    <message>
        <source>%1 joined at %2</source>
        <translation>%1 kam bei %2 dazu</translation>
    </message>
    <message>
        <source>%1 left at %2</source>
        <translation>%1 fiel bei %2 weg</translation>
    </message>
    <message>
        <source>Its neighbours carry it while it is not there. See that all boards deliver before the next take begins.</source>
        <translation>Die Nachbarn tragen sie, solange sie fehlt. Darauf achten, dass alle Platinen liefern, bevor die nächste Aufnahme beginnt.</translation>
    </message>
    <message>
        <source>%1 lost %2 of its frames</source>
        <translation>%1 hat %2 ihrer Rahmen verloren</translation>
    </message>
    <message numerus="yes">
        <source>%n other boards lost some too. Their neighbours carry them meanwhile; check plugs and cables before the next take.</source>
        <translation>
            <numerusform>%n weitere Platine hat auch welche verloren. Die Nachbarn tragen sie inzwischen; vor der nächsten Aufnahme Stecker und Kabel prüfen.</numerusform>
            <numerusform>%n weitere Platinen haben auch welche verloren. Die Nachbarn tragen sie inzwischen; vor der nächsten Aufnahme Stecker und Kabel prüfen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Its neighbours carry it meanwhile. Check its plug and cable before the next take.</source>
        <translation>Die Nachbarn tragen sie inzwischen. Vor der nächsten Aufnahme Stecker und Kabel prüfen.</translation>
    </message>
    <message>
        <source>Published filter</source>
        <translation>Veröffentlichter Filter</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>geglättet</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Good take</source>
        <translation>Gute Aufnahme</translation>
    </message>
    <message>
        <source>Usable take</source>
        <translation>Brauchbare Aufnahme</translation>
    </message>
    <message>
        <source>Not usable</source>
        <translation>Nicht brauchbar</translation>
    </message>
    <message>
        <source>It follows the reference from start to end.</source>
        <translation>Sie folgt der Referenz von Anfang bis Ende.</translation>
    </message>
    <message>
        <source>The mean joint error is %1</source>
        <translation>Der mittlere Gelenkfehler ist %1</translation>
    </message>
    <message>
        <source>Good takes stay under %1 against their reference. Another choice of sensors or a newer calibration may bring it down: reprocess and compare.</source>
        <translation>Gute Aufnahmen bleiben unter %1 gegen ihre Referenz. Eine andere Wahl der Sensoren oder eine neuere Kalibrierung kann ihn senken: neu verarbeiten und vergleichen.</translation>
    </message>
    <message>
        <source>A board or a source may sit elsewhere than the performer page says, or the source offsets are another box&apos;s. Check both, then reprocess.</source>
        <translation>Eine Platine oder Quelle sitzt vielleicht anders, als die Darstellerseite sagt, oder der Quellenversatz gehört zu einer anderen Box. Beides prüfen, dann neu verarbeiten.</translation>
    </message>
    <message>
        <source>No signal for %1 in one piece</source>
        <translation>Kein Signal für %1 am Stück</translation>
    </message>
    <message>
        <source>The pose is a guess there. The timeline hatches these gaps; keep them outside in and out.</source>
        <translation>Dort ist die Pose geraten. Die Zeitleiste schraffiert diese Lücken; sie gehören nicht zwischen Anfang und Ende.</translation>
    </message>
    <message>
        <source>This result shows no pose</source>
        <translation>Dieses Ergebnis zeigt keine Pose</translation>
    </message>
    <message>
        <source>The filter found nothing to start from. Reprocess with all sensors, or look whether the take holds sound at all.</source>
        <translation>Der Filter fand nichts, womit er beginnen konnte. Mit allen Sensoren neu verarbeiten oder nachsehen, ob die Aufnahme überhaupt Ton enthält.</translation>
    </message>
    <message>
        <source>Most of it after %1. Check whether the strap moved there; with in and out set around the good part the take stays usable.</source>
        <translation>Das meiste davon nach %1. Prüfen, ob dort der Gurt verrutscht ist; mit Anfang und Ende um den guten Teil bleibt die Aufnahme brauchbar.</translation>
    </message>
    <message>
        <source>It is off throughout. Check on the performer page where its boards sit.</source>
        <translation>Die Abweichung besteht durchgehend. Auf der Darstellerseite prüfen, wo die Platinen sitzen.</translation>
    </message>
    <message>
        <source>Better not used as it is. Why, and what may help, is told below.</source>
        <translation>So besser nicht verwenden. Warum, und was helfen kann, steht unten.</translation>
    </message>
    <message>
        <source>Good enough to work with. What to look at first is told below.</source>
        <translation>Gut genug, um damit zu arbeiten. Worauf zuerst zu achten ist, steht unten.</translation>
    </message>
    <message>
        <source>Without ranges a joint follows its gyroscope, which drifts by 1 to 3° a minute.</source>
        <translation>Ohne Entfernungen folgt ein Gelenk seinem Gyroskop, das um 1 bis 3° je Minute driftet.</translation>
    </message>
    <message>
        <source>No joint was backed by ranges</source>
        <translation>Kein Gelenk wurde von Entfernungen gestützt</translation>
    </message>
    <message>
        <source>Ranges backed the joints only %1 of the time</source>
        <translation>Entfernungen stützten die Gelenke nur %1 der Zeit</translation>
    </message>
    <message>
        <source>Look at the pairs for sources or boards that were not heard.</source>
        <translation>Bei den Paaren nach Quellen oder Platinen sehen, die nicht zu hören waren.</translation>
    </message>
    <message>
        <source>This take has no calibration</source>
        <translation>Diese Aufnahme hat keine Kalibrierung</translation>
    </message>
    <message>
        <source>Without calibration of %1</source>
        <translation>Ohne Kalibrierung %1</translation>
    </message>
    <message>
        <source>The recording itself is whole. Calibrate the suit or find the calibration of that day, then process the take with it.</source>
        <translation>Die Aufzeichnung selbst ist ganz. Den Anzug kalibrieren oder die Kalibrierung jenes Tages suchen und die Aufnahme damit verarbeiten.</translation>
    </message>
    <message>
        <source>Process with a calibration</source>
        <translation>Mit einer Kalibrierung verarbeiten</translation>
    </message>
    <message>
        <source>Made of distances only</source>
        <translation>Nur aus Entfernungen</translation>
    </message>
    <message>
        <source>Made of accelerometers only</source>
        <translation>Nur aus Beschleunigungssensoren</translation>
    </message>
    <message>
        <source>Made without gyroscopes</source>
        <translation>Ohne Gyroskope</translation>
    </message>
    <message>
        <source>No gyroscope was used, so the angles are guesses. Process the take with gyroscopes for a result to work with.</source>
        <translation>Kein Gyroskop wurde verwendet, die Winkel sind daher geraten. Verarbeiten Sie die Aufnahme mit Gyroskopen, um mit dem Ergebnis arbeiten zu können.</translation>
    </message>
    <message>
        <source>Process with gyroscopes</source>
        <translation>Mit Gyroskopen verarbeiten</translation>
    </message>
    <message>
        <source>Ranges backed the joints %1 of the time, and inertia carried them in between; none stands out.</source>
        <translation>Entfernungen stützten die Gelenke %1 der Zeit, dazwischen trug sie die Trägheit; keines fällt auf.</translation>
    </message>
    <message>
        <source>Independent sensors</source>
        <translation>Unabhängige Sensoren</translation>
    </message>
    <message>
        <source>A third of the ranges miss the pose by more than %1</source>
        <translation>Ein Drittel der Entfernungen verfehlt die Pose um mehr als %1</translation>
    </message>
    <message>
        <source>%1: half of its ranges miss the pose by more than %2</source>
        <translation>%1: Die Hälfte der Entfernungen verfehlt die Pose um mehr als %2</translation>
    </message>
    <message>
        <source>It may sit elsewhere than the performer page says, or point elsewhere than when it was calibrated. Check it, then reprocess.</source>
        <translation>Das Teil sitzt vielleicht anders, als die Darstellerseite sagt, oder zeigt anders als beim Kalibrieren. Prüfen Sie es und verarbeiten Sie die Aufnahme neu.</translation>
    </message>
    <message>
        <source>The suit has no sources</source>
        <translation>Der Anzug hat keine Quellen</translation>
    </message>
    <message>
        <source>How far its joints drift is not known without a reference.</source>
        <translation>Wie weit seine Gelenke driften, ist ohne Referenz nicht bekannt.</translation>
    </message>
    <message>
        <source>It follows the reference, which covers %1 of it.</source>
        <translation>Sie folgt der Referenz, die %1 von ihr abdeckt.</translation>
    </message>
    <message>
        <source>%1 was told by no sensor for %2 of the time</source>
        <translation>%1: %2 der Zeit von keinem Sensor erfasst</translation>
    </message>
    <message>
        <source>Where they stand to each other is not known</source>
        <translation>Wo sie zueinander stehen, ist nicht bekannt</translation>
    </message>
    <message>
        <source>No ranges between all performers or to a room were used: distances between them mean nothing. See that every suit has a calibration and heard the others, and process with all sensors.</source>
        <translation>Es wurden keine Entfernungen zwischen allen Darstellern oder zu einem Raum verwendet: Abstände zwischen ihnen sagen nichts aus. Dafür sorgen, dass jeder Anzug eine Kalibrierung hat und die anderen hört, und mit allen Sensoren verarbeiten.</translation>
    </message>
    <message>
        <source>Calibrate what is missing first.</source>
        <translation>Zuerst kalibrieren, was fehlt.</translation>
    </message>
    <message>
        <source>%1 has no sensor</source>
        <translation>%1 hat keinen Sensor</translation>
    </message>
    <message>
        <source>It keeps its usual pose meanwhile. A board on it, or on what it carries, tells it.</source>
        <translation>Die übliche Pose bleibt so lange. Eine Platine darauf, oder auf dem, was daran hängt, erfasst es.</translation>
    </message>
    <message>
        <source>%1 is less certain</source>
        <translation>%1 ist weniger sicher</translation>
    </message>
    <message>
        <source>%1: each alone, placed by another system</source>
        <translation>%1: jeder für sich, gestellt von einem anderen System</translation>
    </message>
    <message>
        <source>%1: each alone, without ranges between them</source>
        <translation>%1: jeder für sich, ohne Entfernungen zwischen ihnen</translation>
    </message>
    <message>
        <source>%1: together, with ranges between them and to the room</source>
        <translation>%1: gemeinsam, mit Entfernungen zwischen ihnen und zum Raum</translation>
    </message>
    <message>
        <source>%1: together, with ranges between them</source>
        <translation>%1: gemeinsam, mit Entfernungen zwischen ihnen</translation>
    </message>
    <message>
        <source>%1: together, with ranges to the room</source>
        <translation>%1: gemeinsam, mit Entfernungen zum Raum</translation>
    </message>
    <message>
        <source>%1; could not be joined: %2</source>
        <translation>%1; nicht zuzuordnen: %2</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RigDrawing</name>
    <message>
        <source>30 to 90 cm</source>
        <translation>30 bis 90&#xa0;cm</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Box</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>nach vorn</translation>
    </message>
    <message>
        <source>down</source>
        <translation>unten</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RobotCenter</name>
    <message>
        <source>Clutch out</source>
        <translation>Ausgekuppelt</translation>
    </message>
    <message>
        <source>Hold now</source>
        <translation>Jetzt halten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Hand of the robot</source>
        <translation>Hand des Roboters</translation>
    </message>
    <message>
        <source>dashed: commanded, line: achieved; a division is 100 mm</source>
        <translation>gestrichelt: Soll, Linie: Ist; ein Teilstrich ist 100&#xa0;mm</translation>
    </message>
    <message>
        <source>Suit to command</source>
        <translation>Anzug bis Befehl</translation>
    </message>
    <message>
        <source>Command to arm</source>
        <translation>Befehl bis Arm</translation>
    </message>
    <message>
        <source>Whole chain</source>
        <translation>Ganze Kette</translation>
    </message>
    <message>
        <source>Rest after delay</source>
        <translation>Rest nach Verzug</translation>
    </message>
    <message>
        <source>Play the take</source>
        <translation>Aufnahme abspielen</translation>
    </message>
    <message>
        <source>Join begin and end</source>
        <translation>Anfang und Ende verbinden</translation>
    </message>
    <message>
        <source>Export commands</source>
        <translation>Befehle exportieren</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>Key is held</source>
        <translation>Taste gehalten</translation>
    </message>
    <message>
        <source>Let go, and the robot holds</source>
        <translation>Loslassen, und der Roboter hält</translation>
    </message>
    <message>
        <source>Hold the key</source>
        <translation>Taste halten</translation>
    </message>
    <message>
        <source>It moves only while held</source>
        <translation>Er bewegt sich nur, solange Sie halten</translation>
    </message>
    <message>
        <source>Clutch in</source>
        <translation>Eingekuppelt</translation>
    </message>
    <message>
        <source>In: postures are compared</source>
        <translation>Ein: Haltungen werden verglichen</translation>
    </message>
    <message>
        <source>Pause the take</source>
        <translation>Aufnahme anhalten</translation>
    </message>
    <message>
        <source>The suit leads. Let the take lead.</source>
        <translation>Der Anzug führt. Lassen Sie die Aufnahme führen.</translation>
    </message>
    <message>
        <source>Connect the robot first.</source>
        <translation>Verbinden Sie zuerst den Roboter.</translation>
    </message>
    <message>
        <source>No commands have been sent yet.</source>
        <translation>Es gingen noch keine Befehle hinaus.</translation>
    </message>
    <message>
        <source>%1, largest %2</source>
        <translation>%1, größter %2</translation>
    </message>
    <message>
        <source>%1, p99.9 %2</source>
        <comment>median, quantile</comment>
        <translation>%1, p99,9 %2</translation>
    </message>
    <message>
        <source>Out: the robot stays</source>
        <translation>Aus: der Roboter bleibt</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Show what was recorded</source>
        <translation>Aufgenommenes zeigen</translation>
    </message>
    <message>
        <source>No suit is connected. Connect one, or let a take lead.</source>
        <translation>Kein Anzug ist verbunden. Verbinden Sie einen, oder lassen Sie eine Aufnahme führen.</translation>
    </message>
    <message>
        <source>No commands were recorded in this session.</source>
        <translation>In dieser Sitzung wurden keine Befehle aufgenommen.</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufnahme beenden</translation>
    </message>
    <message>
        <source>From a reading of the suit to the command: half of all commands take less than the first time, 999 of 1000 less than the second.</source>
        <translation>Von einem Messwert des Anzugs bis zum Befehl: Die Hälfte aller Befehle braucht weniger als die erste Zeit, 999 von 1000 weniger als die zweite.</translation>
    </message>
    <message>
        <source>From a command until the robot’s hand is there.</source>
        <translation>Von einem Befehl, bis die Hand des Roboters dort ist.</translation>
    </message>
    <message>
        <source>Both together.</source>
        <translation>Beides zusammen.</translation>
    </message>
    <message>
        <source>How far the hand is from its command when the delay is left aside: on average, and at most.</source>
        <translation>Wie weit die Hand von ihrem Befehl entfernt ist, wenn der Verzug außer Acht bleibt: im Mittel und höchstens.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RobotDrive</name>
    <message>
        <source>Reading the robot</source>
        <translation>Roboter wird gelesen</translation>
    </message>
    <message>
        <source>No take with a motion is open. Open one in Review.</source>
        <translation>Keine Aufnahme mit Bewegung ist offen. Öffnen Sie eine im Schritt Prüfen.</translation>
    </message>
    <message>
        <source>No suit is connected. Connect one, or let a take lead.</source>
        <translation>Kein Anzug ist verbunden. Verbinden Sie einen, oder lassen Sie eine Aufnahme führen.</translation>
    </message>
    <message>
        <source>The suit is not calibrated: its poses would mislead the robot.</source>
        <translation>Der Anzug ist nicht kalibriert: Seine Posen würden den Roboter irreführen.</translation>
    </message>
    <message>
        <source>The suit leads: its recording holds the robot’s commands, too.</source>
        <translation>Der Anzug führt: Seine Aufnahme enthält auch die Befehle des Roboters.</translation>
    </message>
    <message>
        <source>Connect the robot first.</source>
        <translation>Verbinden Sie zuerst den Roboter.</translation>
    </message>
    <message>
        <source>Saving the robot’s commands</source>
        <translation>Befehle des Roboters werden gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>%n command(s) and states of the robot are not in %1.</source>
        <translation>
            <numerusform>%n Befehl oder Zustand des Roboters fehlt in %1.</numerusform>
            <numerusform>%n Befehle und Zustände des Roboters fehlen in %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The robot’s commands and states are in %1.</source>
        <translation>Befehle und Zustände des Roboters sind in %1.</translation>
    </message>
    <message>
        <source>Reading the robot’s commands</source>
        <translation>Befehle des Roboters werden gelesen</translation>
    </message>
    <message>
        <source>The performer of the take</source>
        <translation>Der Darsteller der Aufnahme</translation>
    </message>
    <message>
        <source>The performer</source>
        <translation>Der Darsteller</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RobotPage</name>
    <message>
        <source>A suit or a take can drive a robot’s arms. The robot appears here once it is chosen.</source>
        <translation>Ein Anzug oder eine Aufnahme kann die Arme eines Roboters führen. Der Roboter erscheint hier, sobald er gewählt ist.</translation>
    </message>
    <message>
        <source>Choose the robot</source>
        <translation>Roboter wählen</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Robot state</source>
        <translation>Zustand des Roboters</translation>
    </message>
    <message>
        <source>Clutch in or out</source>
        <translation>Ein- oder auskuppeln</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Hold now</source>
        <translation>Jetzt halten</translation>
    </message>
    <message>
        <source>Stop the robot</source>
        <translation>Roboter stoppen</translation>
    </message>
    <message>
        <source>Release the stop</source>
        <translation>Stopp aufheben</translation>
    </message>
    <message>
        <source>Export commands</source>
        <translation>Befehle exportieren</translation>
    </message>
    <message>
        <source>Remove the robot</source>
        <translation>Roboter entfernen</translation>
    </message>
    <message>
        <source>Record the robot’s commands, or stop</source>
        <translation>Befehle des Roboters aufnehmen oder die Aufnahme beenden</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RobotSidebar</name>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>looking for the robot</source>
        <translation>Roboter wird gesucht</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>antwortet</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>antwortet nicht</translation>
    </message>
    <message>
        <source>In this session</source>
        <translation>In dieser Sitzung</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Choose another robot</source>
        <translation>Anderen Roboter wählen</translation>
    </message>
    <message>
        <source>Remove the robot</source>
        <translation>Roboter entfernen</translation>
    </message>
    <message>
        <source>Led by</source>
        <translation>Geführt von</translation>
    </message>
    <message>
        <source>The suit, live</source>
        <translation>Anzug, live</translation>
    </message>
    <message>
        <source>The take in Review</source>
        <translation>Aufnahme in Prüfen</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Folgt</translation>
    </message>
    <message>
        <source>The whole posture</source>
        <translation>Die ganze Haltung</translation>
    </message>
    <message>
        <source>Path of the hand only</source>
        <translation>Nur die Bahn der Hand</translation>
    </message>
    <message>
        <source>Speed of the robot</source>
        <translation>Tempo des Roboters</translation>
    </message>
    <message>
        <source>It begins to follow when</source>
        <translation>Er beginnt zu folgen, wenn</translation>
    </message>
    <message>
        <source>each joint is within</source>
        <translation>jedes Gelenk näher ist als</translation>
    </message>
    <message>
        <source>Largest distance of a joint at which following can begin</source>
        <translation>Größter Abstand eines Gelenks, bei dem das Folgen beginnen kann</translation>
    </message>
    <message>
        <source>The robot holds by itself when</source>
        <translation>Der Roboter hält von selbst bei</translation>
    </message>
    <message>
        <source>no pose for</source>
        <translation>keine Pose seit</translation>
    </message>
    <message>
        <source>no answer for</source>
        <translation>keine Antwort seit</translation>
    </message>
    <message>
        <source>joint off by</source>
        <translation>Gelenk daneben um</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) driven</source>
        <translation>
            <numerusform>%n Gelenk geführt</numerusform>
            <numerusform>%n Gelenke geführt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1
%2</source>
        <comment>address, joints</comment>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>The robot gets no commands</source>
        <translation>Der Roboter bekommt keine Befehle</translation>
    </message>
    <message>
        <source>a joint turns by at most %1 a second</source>
        <translation>ein Gelenk dreht höchstens %1 je Sekunde</translation>
    </message>
    <message>
        <source>The robot’s arm is %1 long. The position of your hand is measured from your chest, so walking does not move the arm.</source>
        <translation>Der Arm des Roboters ist %1 lang. Die Lage Ihrer Hand wird von der Brust aus gemessen, Gehen bewegt den Arm also nicht.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>state of the robot: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <comment>time, state</comment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Gesteuert</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RobotStatePanel</name>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>achieved, commanded</source>
        <translation>Ist, Soll</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>No robot</source>
        <translation>Kein Roboter</translation>
    </message>
    <message>
        <source>Choose one, and it appears here.</source>
        <translation>Wählen Sie einen, dann erscheint er hier.</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>The robot gets no commands from here.</source>
        <translation>Der Roboter bekommt von hier keine Befehle.</translation>
    </message>
    <message>
        <source>Looking for the robot</source>
        <translation>Roboter wird gesucht</translation>
    </message>
    <message>
        <source>It has not sent its joint angles yet.</source>
        <translation>Er hat seine Gelenkwinkel noch nicht gesendet.</translation>
    </message>
    <message>
        <source>Bring your arms to the robot’s posture. The outline shows yours.</source>
        <translation>Bringen Sie die Arme in die Haltung des Roboters. Der Umriss zeigt Ihre.</translation>
    </message>
    <message>
        <source>Hold F8 with the clutch in: your posture is compared with the robot’s.</source>
        <translation>Halten Sie F8 und kuppeln Sie ein: Ihre Haltung wird mit der des Roboters verglichen.</translation>
    </message>
    <message>
        <source>Every joint is near enough. Press Follow (A) when nobody is in reach of the robot.</source>
        <translation>Jedes Gelenk ist nah genug. Drücken Sie Folgen (A), wenn niemand in Reichweite des Roboters ist.</translation>
    </message>
    <message>
        <source>The robot moves as the performer does.</source>
        <translation>Der Roboter bewegt sich wie der Darsteller.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>state of the robot: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The robot stands where it is.</source>
        <translation>Der Roboter bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Within a second the robot takes the performer’s posture and follows.</source>
        <translation>Innerhalb einer Sekunde nimmt der Roboter die Haltung des Darstellers an und folgt.</translation>
    </message>
    <message>
        <source>The robot stands still until you press Follow.</source>
        <translation>Der Roboter steht still, bis Sie Folgen drücken.</translation>
    </message>
    <message>
        <source>Choose a robot first.</source>
        <translation>Wählen Sie zuerst einen Roboter.</translation>
    </message>
    <message>
        <source>Release the stop</source>
        <translation>Stopp aufheben</translation>
    </message>
    <message>
        <source>Then hold F8, bring your arms near, and press Follow.</source>
        <translation>Dann F8 halten, die Arme heranbringen und Folgen drücken.</translation>
    </message>
    <message>
        <source>Synchronise again</source>
        <translation>Neu synchronisieren</translation>
    </message>
    <message>
        <source>The robot holds, and you see how far each joint is from yours.</source>
        <translation>Der Roboter hält, und Sie sehen, wie weit jedes Gelenk von Ihrem entfernt ist.</translation>
    </message>
    <message>
        <source>Hold F8 with the clutch in, and bring your arms near to the robot’s posture.</source>
        <translation>Halten Sie F8, kuppeln Sie ein und bringen Sie die Arme nah an die Haltung des Roboters.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RobotView</name>
    <message>
        <source>Robot in 3D</source>
        <translation>Roboter in 3D</translation>
    </message>
    <message>
        <source>filled: achieved, outline: commanded</source>
        <translation>gefüllt: Ist, Umriss: Soll</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RobotWords</name>
    <message>
        <source>the robot does not answer</source>
        <translation>der Roboter antwortet nicht</translation>
    </message>
    <message>
        <source>the robot refuses commands</source>
        <translation>der Roboter lehnt Befehle ab</translation>
    </message>
    <message>
        <source>a joint does not follow</source>
        <translation>ein Gelenk folgt nicht</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>no pose of the performer</source>
        <translation>keine Pose des Darstellers</translation>
    </message>
    <message>
        <source>key released</source>
        <translation>Taste losgelassen</translation>
    </message>
    <message>
        <source>the clutch is out</source>
        <translation>ausgekuppelt</translation>
    </message>
    <message>
        <source>Not synchronised</source>
        <translation>Nicht synchron</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Following</source>
        <translation>Folgt</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Hält</translation>
    </message>
    <message>
        <source>The robot does not answer</source>
        <translation>Der Roboter antwortet nicht</translation>
    </message>
    <message>
        <source>It is told to hold. Check its program and the network.</source>
        <translation>Er soll halten. Prüfen Sie sein Programm und das Netzwerk.</translation>
    </message>
    <message>
        <source>The robot refuses commands</source>
        <translation>Der Roboter lehnt Befehle ab</translation>
    </message>
    <message>
        <source>A command was too far from where it stands. They begin there again: bring your arms near, then press Follow.</source>
        <translation>Ein Befehl war zu weit von dort, wo er steht. Sie beginnen wieder dort: Bringen Sie die Arme heran und drücken Sie Folgen.</translation>
    </message>
    <message>
        <source>%1 does not follow</source>
        <translation>%1 folgt nicht</translation>
    </message>
    <message>
        <source>It is %1 away from its command. Check the joint. Commands begin again where the robot stands: bring your arms near, then press Follow.</source>
        <translation>Es ist %1 von seinem Befehl entfernt. Prüfen Sie das Gelenk. Die Befehle beginnen wieder dort, wo der Roboter steht: Bringen Sie die Arme heran und drücken Sie Folgen.</translation>
    </message>
    <message>
        <source>No fresh pose of the performer</source>
        <translation>Keine frische Pose des Darstellers</translation>
    </message>
    <message>
        <source>The robot holds. Check the suit and its link.</source>
        <translation>Der Roboter hält. Prüfen Sie den Anzug und seine Verbindung.</translation>
    </message>
    <message>
        <source>%1 is %2 from your posture</source>
        <translation>%1 ist %2 von Ihrer Haltung entfernt</translation>
    </message>
    <message>
        <source>Bring the arm nearer to the robot’s posture.</source>
        <translation>Bringen Sie den Arm näher an die Haltung des Roboters.</translation>
    </message>
    <message>
        <source>Too near to each other</source>
        <translation>Zu nah beieinander</translation>
    </message>
    <message>
        <source>%1 would touch, so the robot’s arms slow down. Move your arms apart.</source>
        <translation>%1 würden sich berühren, deshalb werden die Arme des Roboters langsamer. Nehmen Sie Ihre Arme auseinander.</translation>
    </message>
    <message>
        <source>The pose is uncertain</source>
        <translation>Die Pose ist unsicher</translation>
    </message>
    <message>
        <source>The robot moves slowly until the suit is sure again.</source>
        <translation>Der Roboter bewegt sich langsam, bis der Anzug wieder sicher ist.</translation>
    </message>
    <message>
        <source>The hand would leave the allowed box</source>
        <translation>Die Hand würde den erlaubten Raum verlassen</translation>
    </message>
    <message>
        <source>The robot stays at the border of it. Bring your hand back.</source>
        <translation>Der Roboter bleibt an dessen Grenze. Nehmen Sie die Hand zurück.</translation>
    </message>
    <message>
        <source>Both arms</source>
        <translation>Beide Arme</translation>
    </message>
    <message>
        <source>Left arm</source>
        <translation>Linker Arm</translation>
    </message>
    <message>
        <source>Right arm</source>
        <translation>Rechter Arm</translation>
    </message>
    <message>
        <source>Both arms and the trunk</source>
        <translation>Beide Arme und der Rumpf</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RoomDrawing</name>
    <message>
        <source>was moved</source>
        <translation>wurde verschoben</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>not placed</source>
        <translation>ohne Ort</translation>
    </message>
    <message>
        <source>two places fit</source>
        <translation>zwei Orte passen</translation>
    </message>
    <message>
        <source>weak</source>
        <translation>schwach</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>Plan of the room, from above</source>
        <translation>Grundriss des Raums, von oben</translation>
    </message>
    <message>
        <source>The room from the front</source>
        <translation>Der Raum von vorn</translation>
    </message>
    <message>
        <source>anchor %1 at %2, %3, height %4</source>
        <translation>Anker %1 bei %2, %3, Höhe %4</translation>
    </message>
    <message>
        <source>anchor %1, left out, at %2, %3, height %4</source>
        <translation>Anker %1, weggelassen, bei %2, %3, Höhe %4</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1&#xa0;m</translation>
    </message>
    <message>
        <source>Ellipse: uncertainty, drawn %1 times larger. Line: walked.</source>
        <translation>Ellipse: Unsicherheit, %1-mal größer gezeichnet. Linie: gegangen.</translation>
    </message>
    <message>
        <source>Heights above the floor.</source>
        <translation>Höhen über dem Boden.</translation>
    </message>
    <message>
        <source>Plan, from above</source>
        <translation>Grundriss, von oben</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Ellipse: uncertainty. Line: walked.</source>
        <translation>Ellipse: Unsicherheit. Linie: gegangen.</translation>
    </message>
    <message>
        <source>nearly</source>
        <translation>fast gut</translation>
    </message>
    <message>
        <source>%1 ft</source>
        <translation>%1&#xa0;ft</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RoomPage</name>
    <message>
        <source>The room is surveyed</source>
        <translation>Der Raum ist vermessen</translation>
    </message>
    <message>
        <source>The room can be used</source>
        <translation>Der Raum ist brauchbar</translation>
    </message>
    <message>
        <source>The room cannot be used yet</source>
        <translation>Der Raum ist noch nicht brauchbar</translation>
    </message>
    <message>
        <source>Anchor %1</source>
        <translation>Anker %1</translation>
    </message>
    <message>
        <source>height %1</source>
        <translation>Höhe %1</translation>
    </message>
    <message>
        <source>heard %1 of %2</source>
        <translation>gehört %1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>hears anchor %1</source>
        <translation>
            <numerusform>hört Anker %1</numerusform>
            <numerusform>hört die Anker %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>Where the anchors hang, so that place and heading of everybody hold.</source>
        <translation>Wo die Anker hängen, damit Ort und Richtung von allen halten.</translation>
    </message>
    <message>
        <source>Somebody in a suit walks past all anchors, one minute; after an anchor was moved</source>
        <translation>Jemand im Anzug geht an allen Ankern vorbei, eine Minute; nachdem ein Anker bewegt wurde</translation>
    </message>
    <message>
        <source>Survey again</source>
        <translation>Neu vermessen</translation>
    </message>
    <message>
        <source>Use these places</source>
        <translation>Diese Orte verwenden</translation>
    </message>
    <message>
        <source>Process the take again</source>
        <translation>Aufnahme neu verarbeiten</translation>
    </message>
    <message>
        <source>Save as file</source>
        <translation>Als Datei speichern</translation>
    </message>
    <message>
        <source>Back to Calibrate</source>
        <translation>Zurück zu Kalibrieren</translation>
    </message>
    <message>
        <source>It is being surveyed.</source>
        <translation>Er wird gerade vermessen.</translation>
    </message>
    <message>
        <source>Survey</source>
        <translation>Vermessen</translation>
    </message>
    <message>
        <source>Room of %1</source>
        <translation>Raum von %1</translation>
    </message>
    <message>
        <source>Walk slowly past all anchors</source>
        <translation>Langsam an allen Ankern vorbeigehen</translation>
    </message>
    <message>
        <source>Where do the anchors hang?</source>
        <translation>Wo hängen die Anker?</translation>
    </message>
    <message>
        <source>The room is being surveyed</source>
        <translation>Der Raum wird vermessen</translation>
    </message>
    <message>
        <source>The room was not surveyed</source>
        <translation>Der Raum wurde nicht vermessen</translation>
    </message>
    <message>
        <source>Anchors heard</source>
        <translation>Anker gehört</translation>
    </message>
    <message>
        <source>the weakest: %1 of %2</source>
        <translation>der schwächste: %1 von %2</translation>
    </message>
    <message>
        <source>%1, good: up to %2</source>
        <translation>%1, gut: bis %2</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Übereinstimmung</translation>
    </message>
    <message>
        <source>Nobody has to measure: places come from what the anchors and the suit hear. The origin is where %1 stood in the rest pose; the arrow is where %1 faced.</source>
        <translation>Niemand muss messen: Die Orte kommen aus dem, was Anker und Anzug hören. Der Ursprung ist, wo %1 in der Ruhehaltung stand; der Pfeil zeigt, wohin %1 blickte.</translation>
    </message>
    <message>
        <source>Nobody walked past the anchors: place and heading are those of the room&apos;s file.</source>
        <translation>Niemand ging an den Ankern vorbei: Ort und Richtung sind die der Datei des Raums.</translation>
    </message>
    <message>
        <source>Use these places anyway</source>
        <translation>Diese Orte trotzdem verwenden</translation>
    </message>
    <message>
        <source>Poses would be wrong where the cards say so. Mend what is named first.</source>
        <translation>Haltungen wären dort falsch, wo die Karten es sagen. Zuerst beheben, was genannt ist.</translation>
    </message>
    <message>
        <source>The places come into force in %1. Other takes and the box itself get them from the file.</source>
        <translation>Die Orte gelten dann in %1. Andere Aufnahmen und die Box selbst bekommen sie aus der Datei.</translation>
    </message>
    <message>
        <source>Anchors</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>Save the room</source>
        <translation>Raum speichern</translation>
    </message>
    <message>
        <source>Rooms (*.json)</source>
        <translation>Räume (*.json)</translation>
    </message>
    <message>
        <source>The room was not saved</source>
        <translation>Der Raum wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>In use in %1; undo with %2. Results that it has were made with the earlier places.</source>
        <translation>In %1 in Gebrauch; mit %2 rückgängig. Ergebnisse, die sie hat, entstanden mit den früheren Orten.</translation>
    </message>
    <message>
        <source>Go to Connect</source>
        <translation>Zu Verbinden</translation>
    </message>
    <message>
        <source>Walk and survey</source>
        <translation>Gehen und vermessen</translation>
    </message>
    <message>
        <source>The walk did not begin</source>
        <translation>Der Gang hat nicht begonnen</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>Gang beenden</translation>
    </message>
    <message>
        <source>The take is being saved.</source>
        <translation>Die Aufnahme wird gespeichert.</translation>
    </message>
    <message>
        <source>Stand still in the rest pose in the middle, in sight of all anchors, then walk slowly past all of them and turn, for a minute. The places are shown meanwhile; the survey ends by itself when every anchor is good.</source>
        <translation>In der Mitte in der Ruhehaltung still stehen, in Sicht aller Anker, dann eine Minute langsam an allen vorbeigehen und sich drehen. Die Orte erscheinen währenddessen; die Vermessung endet von selbst, wenn jeder Anker gut ist.</translation>
    </message>
    <message>
        <source>Connect a suit and a box of anchors, then walk slowly past all anchors: the room is surveyed meanwhile. Or open a take with anchors in Review.</source>
        <translation>Einen Anzug und eine Box mit Ankern verbinden, dann langsam an allen Ankern vorbeigehen: Der Raum wird währenddessen vermessen. Oder eine Aufnahme mit Ankern in „Prüfen“ öffnen.</translation>
    </message>
    <message>
        <source>The recording begins</source>
        <translation>Die Aufnahme beginnt</translation>
    </message>
    <message>
        <source>Stand still in the rest pose</source>
        <translation>In der Ruhehaltung still stehen</translation>
    </message>
    <message>
        <source>The take is being saved</source>
        <translation>Die Aufnahme wird gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>Walk slowly past all %n anchor(s)</source>
        <translation>
            <numerusform>Langsam an dem einen Anker vorbeigehen</numerusform>
            <numerusform>Langsam an allen %n Ankern vorbeigehen</numerusform>
        </translation>
    </message>
    <message>
        <source>What was recorded is kept as a take when you leave.</source>
        <translation>Was aufgenommen wurde, bleibt beim Verlassen als Aufnahme erhalten.</translation>
    </message>
    <message>
        <source>Nobody has to measure: places come from what the anchors and the suit hear.</source>
        <translation>Niemand muss messen: Die Orte kommen aus dem, was Anker und Anzug hören.</translation>
    </message>
    <message>
        <source>Survey, %1 of %2 s</source>
        <translation>Vermessung, %1 von %2&#xa0;s</translation>
    </message>
    <message>
        <source>Survey, %1 s</source>
        <translation>Vermessung, %1&#xa0;s</translation>
    </message>
    <message>
        <source>In the middle, in sight of all anchors. The origin becomes where you stand, forward is where you face.</source>
        <translation>In der Mitte, in Sicht aller Anker. Der Ursprung wird, wo Sie stehen; vorn ist, wohin Sie blicken.</translation>
    </message>
    <message>
        <source>Nothing is found yet: %1</source>
        <translation>Noch ist nichts gefunden: %1</translation>
    </message>
    <message>
        <source>The first places come after some seconds of walking.</source>
        <translation>Die ersten Orte kommen nach einigen Sekunden Gehen.</translation>
    </message>
    <message>
        <source>Every anchor is good. Walk on until the survey ends by itself.</source>
        <translation>Jeder Anker ist gut. Weitergehen, bis die Vermessung von selbst endet.</translation>
    </message>
    <message numerus="yes">
        <source>Not good yet: anchor %1. Walk slowly past, and turn.</source>
        <translation>
            <numerusform>Noch nicht gut: Anker %1. Langsam vorbeigehen und sich drehen.</numerusform>
            <numerusform>Noch nicht gut: die Anker %1. Langsam vorbeigehen und sich drehen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The walk ended by itself</source>
        <translation>Der Gang endete von selbst</translation>
    </message>
    <message>
        <source>Use anchor %1 again</source>
        <translation>Anker %1 wieder verwenden</translation>
    </message>
    <message>
        <source>Use without anchor %1</source>
        <translation>Ohne Anker %1 verwenden</translation>
    </message>
    <message>
        <source>Mend this, then walk once more.</source>
        <translation>Beheben Sie das und gehen Sie dann noch einmal.</translation>
    </message>
    <message>
        <source>Its take is %1: open it to survey the room from it.</source>
        <translation>Die Aufnahme davon ist %1: Öffnen Sie sie, um den Raum daraus zu vermessen.</translation>
    </message>
    <message>
        <source>The walk brought no take</source>
        <translation>Der Gang ergab keine Aufnahme</translation>
    </message>
    <message>
        <source>Walk again</source>
        <translation>Noch einmal gehen</translation>
    </message>
    <message numerus="yes">
        <source>Without anchor %1: the file lacks it, and in this take its place stays as it was. The other places stay as they were found with it; to find them without it, take it away and walk again.</source>
        <translation>
            <numerusform>Ohne Anker %1: Er fehlt in der Datei, und in dieser Aufnahme bleibt sein Platz, wie er war. Die anderen Plätze bleiben, wie sie mit ihm gefunden wurden; um sie ohne ihn zu finden, ihn wegnehmen und noch einmal gehen.</numerusform>
            <numerusform>Ohne die Anker %1: Sie fehlen in der Datei, und in dieser Aufnahme bleiben ihre Plätze, wie sie waren. Die anderen Plätze bleiben, wie sie mit ihnen gefunden wurden; um sie ohne sie zu finden, sie wegnehmen und noch einmal gehen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::RoomRun</name>
    <message>
        <source>Using the surveyed places of anchors</source>
        <translation>Die vermessenen Orte der Anker verwenden</translation>
    </message>
    <message>
        <source>Surveying the room of %1</source>
        <translation>Den Raum von %1 vermessen</translation>
    </message>
    <message>
        <source>A room needs three anchors that have a place.</source>
        <translation>Ein Raum braucht drei Anker, die einen Platz haben.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RoomWalk</name>
    <message>
        <source>No box of anchors is connected. Connect one first.</source>
        <translation>Keine Box mit Ankern ist verbunden. Zuerst eine verbinden.</translation>
    </message>
    <message>
        <source>No suit is connected. Connect the suit of whoever walks past the anchors.</source>
        <translation>Kein Anzug ist verbunden. Den Anzug dessen verbinden, der an den Ankern vorbeigeht.</translation>
    </message>
    <message>
        <source>The suit is not calibrated, so nobody knows where it hears from. Calibrate it first.</source>
        <translation>Der Anzug ist nicht kalibriert, also weiß niemand, wo er hört. Ihn zuerst kalibrieren.</translation>
    </message>
    <message>
        <source>It runs already.</source>
        <translation>Er läuft schon.</translation>
    </message>
    <message>
        <source>The anchors&apos; sources are not calibrated, so places are found to decimetres only. Import the calibration of their box first.</source>
        <translation>Die Quellen der Anker sind nicht kalibriert, Orte werden also nur auf Dezimeter gefunden. Zuerst die Kalibrierung ihrer Box importieren.</translation>
    </message>
    <message>
        <source>room</source>
        <comment>first part of the names of takes</comment>
        <translation>raum</translation>
    </message>
    <message>
        <source>The recording did not begin, or could not be saved.</source>
        <translation>Die Aufnahme hat nicht begonnen oder konnte nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Stand still</source>
        <translation>Still stehen</translation>
    </message>
    <message>
        <source>Walk slowly past all anchors</source>
        <translation>Langsam an allen Ankern vorbeigehen</translation>
    </message>
    <message>
        <source>The link to %1 broke, so the recording has ended. What it holds is surveyed.</source>
        <comment>name of a performer, or Room</comment>
        <translation>Die Verbindung zu %1 ist abgerissen, darum ist die Aufnahme beendet. Was sie enthält, wird vermessen.</translation>
    </message>
    <message>
        <source>Surveying the room while it is recorded</source>
        <translation>Den Raum während der Aufnahme vermessen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RunList</name>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>%1 mean, shown</source>
        <translation>%1 Mittel, gezeigt</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>%1 mean, compared</source>
        <translation>%1 Mittel, verglichen</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>verglichen</translation>
    </message>
    <message>
        <source>%1 mean, hidden</source>
        <translation>%1 Mittel, verborgen</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>%1, root given</source>
        <translation>%1, Wurzel gegeben</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <comment>use of a result, performers</comment>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>noctule::ui::RunRow</name>
    <message>
        <source>Result %1, %2, %3</source>
        <translation>Ergebnis %1, %2, %3</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SceneArea</name>
    <message>
        <source>Shown and compared result side by side</source>
        <translation>Gezeigtes und verglichenes Ergebnis nebeneinander</translation>
    </message>
    <message>
        <source>Choose a second result or the reference to compare with.</source>
        <translation>Ein zweites Ergebnis oder die Referenz zum Vergleich wählen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SceneCanvas</name>
    <message>
        <source>This computer offers OpenGL %1.%2 only.</source>
        <translation>Dieser Rechner bietet nur OpenGL %1.%2.</translation>
    </message>
    <message>
        <source>This computer offers no OpenGL.</source>
        <translation>Dieser Rechner bietet kein OpenGL.</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.3. %1 Install the driver of the graphics card; plots, processing and export work without it.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.3. %1 Den Treiber der Grafikkarte installieren; Diagramme, Verarbeitung und Export arbeiten auch ohne.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SceneTools</name>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>Skelett</translation>
    </message>
    <message>
        <source>Boards and sources</source>
        <translation>Platinen und Quellen</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Strahlen</translation>
    </message>
    <message>
        <source>Trails of hands and feet</source>
        <translation>Spuren von Händen und Füßen</translation>
    </message>
    <message>
        <source>Ground contacts</source>
        <translation>Bodenkontakte</translation>
    </message>
    <message>
        <source>Second motion as ghost</source>
        <translation>Zweite Bewegung als Umriss</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>More layers</source>
        <translation>Weitere Ebenen</translation>
    </message>
    <message>
        <source>Follow the body</source>
        <translation>Dem Körper folgen</translation>
    </message>
    <message>
        <source>Save as picture</source>
        <translation>Als Bild speichern</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>View from the front (1), the side (3) or above (7)</source>
        <translation>Ansicht von vorn (1), von der Seite (3) oder von oben (7)</translation>
    </message>
    <message>
        <source>Free view</source>
        <translation>Freie Ansicht</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SceneView</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Save as picture</source>
        <translation>Als Bild speichern</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>Picture written: %1</source>
        <translation>Bild geschrieben: %1</translation>
    </message>
    <message>
        <source>The picture could not be written to %1.</source>
        <translation>Das Bild ließ sich nicht nach %1 schreiben.</translation>
    </message>
    <message>
        <source>Free space on the disk or choose another folder.</source>
        <translation>Platz auf dem Datenträger schaffen oder einen anderen Ordner wählen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SceneWords</name>
    <message>
        <source>%1, board %2</source>
        <translation>%1, Platine %2</translation>
    </message>
    <message>
        <source>%1, source %2</source>
        <translation>%1, Quelle %2</translation>
    </message>
    <message>
        <source>Not heard from source %1</source>
        <translation>Quelle %1 nicht gehört</translation>
    </message>
    <message>
        <source>No pulse from source %1 at this time</source>
        <translation>Zu dieser Zeit kein Puls von Quelle %1</translation>
    </message>
    <message>
        <source>%1 of %2 to %3 of %4</source>
        <comment>joints of two performers</comment>
        <translation>%1 von %2 – %3 von %4</translation>
    </message>
    <message>
        <source>Source %1, confidence %2</source>
        <translation>Quelle %1, Konfidenz %2</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Body at %1</source>
        <translation>Körper bei %1</translation>
    </message>
    <message>
        <source>Body at %1, %2 of %3 pairs good</source>
        <translation>Körper bei %1, %2 von %3 Paaren gut</translation>
    </message>
    <message>
        <source>%1. Chosen: %2</source>
        <translation>%1. Gewählt: %2</translation>
    </message>
    <message>
        <source>Performer in the rest pose with %1 boards and %2 sources</source>
        <translation>Darsteller in der Ruhehaltung mit %1 Platinen und %2 Quellen</translation>
    </message>
    <message>
        <source>The body of the take that you open appears here.</source>
        <translation>Hier erscheint der Körper der geöffneten Aufnahme.</translation>
    </message>
    <message>
        <source>%1 was lost at %2, before the rest pose ended</source>
        <comment>a performer, a time</comment>
        <translation>%1 ging bei %2 verloren, vor dem Ende der Ruhehaltung</translation>
    </message>
    <message>
        <source>There is no motion of them.</source>
        <comment>a performer</comment>
        <translation>Davon gibt es keine Bewegung.</translation>
    </message>
    <message>
        <source>This take has no motion yet. Process it, and the body appears here.</source>
        <translation>Diese Aufnahme hat noch keine Bewegung. Nach der Verarbeitung erscheint der Körper hier.</translation>
    </message>
    <message>
        <source>The motion has no pose at this time.</source>
        <translation>Die Bewegung hat zu dieser Zeit keine Pose.</translation>
    </message>
    <message>
        <source>Live body, %1 of %2 pairs good</source>
        <translation>Körper live, %1 von %2 Paaren gut</translation>
    </message>
    <message>
        <source>The live body needs a calibration. Boards and pairs are watched, and a take can be recorded and processed later.</source>
        <translation>Der Körper braucht eine Kalibrierung. Platinen und Paare werden beobachtet, und eine Aufnahme kann gemacht und später verarbeitet werden.</translation>
    </message>
    <message>
        <source>The live body appears here with the suit&apos;s first pose.</source>
        <translation>Der Körper erscheint hier mit der ersten Pose des Anzugs.</translation>
    </message>
    <message>
        <source>Result %1</source>
        <translation>Ergebnis %1</translation>
    </message>
    <message>
        <source>This take is being processed. The body appears here when that is done.</source>
        <translation>Diese Aufnahme wird gerade verarbeitet. Danach erscheint hier der Körper.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SearchField</name>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SessionList</name>
    <message>
        <source>Recent sessions</source>
        <translation>Letzte Sitzungen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Ordner zeigen</translation>
    </message>
    <message>
        <source>Take off this list</source>
        <translation>Von der Liste nehmen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SessionModel</name>
    <message>
        <source>Performer 1</source>
        <translation>Darsteller 1</translation>
    </message>
    <message>
        <source>Rate %1</source>
        <translation>%1 bewerten</translation>
    </message>
    <message>
        <source>Notes of %1</source>
        <translation>Notizen zu %1</translation>
    </message>
    <message>
        <source>In and out of %1</source>
        <translation>Anfang und Ende von %1</translation>
    </message>
    <message>
        <source>Rename the session</source>
        <translation>Sitzung umbenennen</translation>
    </message>
    <message>
        <source>Notes of the session</source>
        <translation>Notizen zur Sitzung</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>Move %1 to the trash</source>
        <translation>%1 in den Papierkorb legen</translation>
    </message>
    <message>
        <source>The session could not be saved. Your takes are safe; the changes are kept here and saved with the next one</source>
        <translation>Die Sitzung ließ sich nicht speichern. Die Aufnahmen sind sicher; die Änderungen bleiben hier und werden mit der nächsten gespeichert</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>what failed and what is safe; why and what to do</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>The session “%1” was not made</source>
        <translation>Die Sitzung „%1“ wurde nicht angelegt</translation>
    </message>
    <message>
        <source>Opening session %1</source>
        <translation>Sitzung %1 wird geöffnet</translation>
    </message>
    <message>
        <source>Rebuilding session %1</source>
        <translation>Sitzung %1 wird neu aufgebaut</translation>
    </message>
    <message>
        <source>The session was not opened</source>
        <translation>Die Sitzung wurde nicht geöffnet</translation>
    </message>
    <message numerus="yes">
        <source>%n take(s) copied into the session</source>
        <translation>
            <numerusform>%n Aufnahme in die Sitzung kopiert</numerusform>
            <numerusform>%n Aufnahmen in die Sitzung kopiert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Importing %n take(s)</source>
        <translation>
            <numerusform>%n Aufnahme wird importiert</numerusform>
            <numerusform>%n Aufnahmen werden importiert</numerusform>
        </translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 wird wiederhergestellt</translation>
    </message>
    <message>
        <source>%1 could not be recovered; its file stays as it is</source>
        <translation>%1 ließ sich nicht wiederherstellen; die Datei bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>%1 is recovered</source>
        <translation>%1 ist wiederhergestellt</translation>
    </message>
    <message>
        <source>%1 was damaged; what could be read of it is saved. %2.</source>
        <comment>how much was saved of it</comment>
        <translation>%1 war beschädigt; was sich lesen ließ, ist gespeichert. %2.</translation>
    </message>
    <message>
        <source>“%1” is open in another window</source>
        <translation>„%1“ ist in einem anderen Fenster offen</translation>
    </message>
    <message>
        <source>Close it there first</source>
        <translation>Zuerst dort schließen</translation>
    </message>
    <message>
        <source>A job works on %1</source>
        <translation>Ein Auftrag arbeitet an %1</translation>
    </message>
    <message>
        <source>Wait until it is done, or cancel it</source>
        <translation>Warten, bis er fertig ist, oder ihn abbrechen</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>%1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>Change the shot list</source>
        <translation>Szenenliste ändern</translation>
    </message>
    <message>
        <source>Change the body of the view</source>
        <translation>Körper der Ansicht ändern</translation>
    </message>
    <message>
        <source>The folder of the session, %1, is not there any more. Put it back; what you change meanwhile is kept here and saved then.</source>
        <translation>Der Ordner der Sitzung, %1, ist nicht mehr da. Legen Sie ihn zurück; Änderungen bleiben bis dahin hier und werden dann gespeichert.</translation>
    </message>
    <message>
        <source>%1 is in “%2”</source>
        <comment>take, session</comment>
        <translation>%1 ist in „%2“</translation>
    </message>
    <message>
        <source>%1 is in “%2” as %3: the name was taken there, and both are kept</source>
        <comment>take, session, name of the take there</comment>
        <translation>%1 ist in „%2“ als %3: Der Name war dort vergeben, beide bleiben erhalten</translation>
    </message>
    <message>
        <source>A copy of %1 is in “%2”; the take also stays where it was</source>
        <comment>take, session</comment>
        <translation>Eine Kopie von %1 ist in „%2“; die Aufnahme bleibt auch, wo sie war</translation>
    </message>
    <message>
        <source>Moving %1 to %2</source>
        <translation>%1 wird nach %2 verschoben</translation>
    </message>
    <message>
        <source>Copying %1 to %2</source>
        <translation>%1 wird nach %2 kopiert</translation>
    </message>
    <message>
        <source>%1 was not moved</source>
        <translation>%1 wurde nicht verschoben</translation>
    </message>
    <message>
        <source>%1 was not copied</source>
        <translation>%1 wurde nicht kopiert</translation>
    </message>
    <message>
        <source>%1 was not moved: its session was closed meanwhile</source>
        <translation>%1 wurde nicht verschoben: Die Sitzung wurde inzwischen geschlossen</translation>
    </message>
    <message>
        <source>Move %1 to “%2”</source>
        <translation>%1 nach „%2“ verschieben</translation>
    </message>
    <message>
        <source>%1 was not moved to %2</source>
        <comment>file, folder</comment>
        <translation>%1 wurde nicht nach %2 verschoben</translation>
    </message>
    <message>
        <source>See whether that folder can be written and has no file of this name</source>
        <translation>Sehen Sie nach, ob der Ordner beschreibbar ist und keine Datei dieses Namens hat</translation>
    </message>
    <message>
        <source>New takes are made with it. Use another calibration for them first.</source>
        <translation>Neue Aufnahmen entstehen mit ihr. Nehmen Sie für sie erst eine andere Kalibrierung.</translation>
    </message>
    <message>
        <source>Put %1 aside</source>
        <translation>%1 beiseitelegen</translation>
    </message>
    <message>
        <source>%1 is in use</source>
        <translation>%1 ist in Gebrauch</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SessionNotices</name>
    <message>
        <source>“%1” is open somewhere else as well</source>
        <translation>„%1“ ist noch an anderer Stelle geöffnet</translation>
    </message>
    <message>
        <source>Takes are safe. Of notes and ratings changed in both places the later ones win; close one of the two.</source>
        <translation>Aufnahmen sind sicher. Von Notizen und Bewertungen, die an beiden Stellen geändert werden, gelten die späteren; am besten eine der beiden schließen.</translation>
    </message>
    <message>
        <source>“%1” can be read but not written</source>
        <translation>„%1“ lässt sich lesen, aber nicht schreiben</translation>
    </message>
    <message>
        <source>Takes can be reviewed and exported to another place; ratings, notes and results cannot be kept. Copy the folder to where you may write.</source>
        <translation>Aufnahmen lassen sich prüfen und an einen anderen Ort exportieren; Bewertungen, Notizen und Ergebnisse bleiben nicht erhalten. Den Ordner dorthin kopieren, wo Schreiben erlaubt ist.</translation>
    </message>
    <message>
        <source>“%1” was not closed last time</source>
        <translation>„%1“ wurde letztes Mal nicht geschlossen</translation>
    </message>
    <message numerus="yes">
        <source>The studio ended unexpectedly. All %n take(s) were looked at again; changes were kept up to the last second.</source>
        <translation>
            <numerusform>Das Studio wurde unerwartet beendet. Die eine Aufnahme wurde neu geprüft; Änderungen sind bis zur letzten Sekunde erhalten.</numerusform>
            <numerusform>Das Studio wurde unerwartet beendet. Alle %n Aufnahmen wurden neu geprüft; Änderungen sind bis zur letzten Sekunde erhalten.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” cannot be opened as it is</source>
        <translation>„%1“ lässt sich so nicht öffnen</translation>
    </message>
    <message>
        <source>Rebuild session</source>
        <translation>Sitzung neu aufbauen</translation>
    </message>
    <message>
        <source>What came in until then is safe on disk: %1. %2</source>
        <comment>names of takes, an offer</comment>
        <translation>Was bis dahin ankam, liegt sicher auf dem Datenträger: %1. %2</translation>
    </message>
    <message>
        <source>Recover %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>Recover all</source>
        <translation>Alle wiederherstellen</translation>
    </message>
    <message>
        <source>Take %1 broke off</source>
        <translation>Aufnahme %1 brach ab</translation>
    </message>
    <message numerus="yes">
        <source>%n takes broke off</source>
        <translation>
            <numerusform>%n Aufnahme brach ab</numerusform>
            <numerusform>%n Aufnahmen brachen ab</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was moved to the trash</source>
        <translation>%1 liegt im Papierkorb</translation>
    </message>
    <message>
        <source>The trash is a folder of the session.</source>
        <translation>Der Papierkorb ist ein Ordner der Sitzung.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>%1 has no poses yet</source>
        <comment>name of a take</comment>
        <translation>%1 hat noch keine Posen</translation>
    </message>
    <message>
        <source>The live view skipped part of the sound; the take holds all of it. Process it.</source>
        <translation>Die Live-Ansicht hat einen Teil des Tons übersprungen; die Aufnahme enthält ihn ganz. Die Aufnahme verarbeiten.</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Verarbeiten</translation>
    </message>
    <message>
        <source>Heading and place of %1 are reset</source>
        <translation>Richtung und Platz von %1 sind zurückgesetzt</translation>
    </message>
    <message>
        <source>The live picture alone changes; takes stay as they are recorded.</source>
        <translation>Nur das Live-Bild ändert sich; Aufnahmen bleiben, wie sie aufgenommen werden.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SessionSaver</name>
    <message>
        <source>Saving the session</source>
        <translation>Die Sitzung wird gespeichert</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SharedContext</name>
    <message>
        <source>The body could not be unpacked</source>
        <translation>Der Körper konnte nicht entpackt werden</translation>
    </message>
    <message>
        <source>Free some space on the disk; until then a skeleton is shown</source>
        <translation>Platz auf dem Datenträger schaffen; bis dahin erscheint ein Skelett</translation>
    </message>
    <message>
        <source>Loading the body</source>
        <translation>Der Körper wird geladen</translation>
    </message>
    <message>
        <source>Picture of %1</source>
        <translation>Bild von %1</translation>
    </message>
    <message>
        <source>Tones cannot be played on %1: the desktop plays them. Connect it, or choose another device in Preferences.</source>
        <translation>Töne lassen sich auf %1 nicht spielen: die Arbeitsumgebung spielt sie. Das Gerät anschließen oder in den Einstellungen ein anderes wählen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ShortcutsDialog</name>
    <message>
        <source> or </source>
        <comment>between two keys for the same</comment>
        <translation> oder </translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Find a key or a command</source>
        <translation>Taste oder Befehl suchen</translation>
    </message>
    <message>
        <source>Plain keys act only while no text field has the keyboard.</source>
        <translation>Einfache Tasten wirken nur, solange kein Textfeld die Tastatur hat.</translation>
    </message>
    <message>
        <source>No key and no command is called that.</source>
        <translation>Keine Taste und kein Befehl heißt so.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>On the 3D picture</source>
        <translation>Auf dem 3D-Bild</translation>
    </message>
    <message>
        <source>Front, side, top</source>
        <translation>Vorn, Seite, oben</translation>
    </message>
    <message>
        <source>Bring the body into the picture</source>
        <translation>Körper ins Bild holen</translation>
    </message>
    <message>
        <source>Follow the body</source>
        <translation>Dem Körper folgen</translation>
    </message>
    <message>
        <source>Rays, ghost</source>
        <translation>Strahlen, Umriss</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Umkreisen</translation>
    </message>
    <message>
        <source>Middle button, or Alt and left button (preferences)</source>
        <translation>Mittlere Taste, oder Alt und linke Taste (Einstellungen)</translation>
    </message>
    <message>
        <source>Move sideways</source>
        <translation>Seitlich bewegen</translation>
    </message>
    <message>
        <source>Shift and middle button, or Alt and middle button</source>
        <translation>Umschalt und mittlere Taste, oder Alt und mittlere Taste</translation>
    </message>
    <message>
        <source>Nearer, further</source>
        <translation>Näher, weiter</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>On the timeline, contacts of the feet</source>
        <translation>Auf der Zeitleiste, Kontakte der Füße</translation>
    </message>
    <message>
        <source>The left or right foot&apos;s contact at the cursor</source>
        <translation>Kontakt des linken oder rechten Fußes am Zeiger</translation>
    </message>
    <message>
        <source>The contact before or after it</source>
        <translation>Der Kontakt davor oder danach</translation>
    </message>
    <message>
        <source>It begins or ends at the cursor</source>
        <translation>Er beginnt oder endet am Zeiger</translation>
    </message>
    <message>
        <source>Delete it, let go of it</source>
        <translation>Löschen, loslassen</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Vorgaben wiederherstellen</translation>
    </message>
    <message>
        <source>On Robot, for safety</source>
        <translation>Auf Roboter, zur Sicherheit</translation>
    </message>
    <message>
        <source>The robot moves only while this key is held</source>
        <translation>Der Roboter bewegt sich nur, solange diese Taste gehalten wird</translation>
    </message>
    <message>
        <source>Click here and press the key for “%1”:</source>
        <translation>Hier klicken und die Taste für „%1“ drücken:</translation>
    </message>
    <message>
        <source>These keys are fixed.</source>
        <translation>Diese Tasten liegen fest.</translation>
    </message>
    <message>
        <source>Choose a command above to give it another key.</source>
        <translation>Oben einen Befehl wählen, um ihm eine andere Taste zu geben.</translation>
    </message>
    <message>
        <source>%1 already means “%2”. Give that command another key first.</source>
        <comment>key, command</comment>
        <translation>%1 bedeutet schon „%2“. Erst diesem Befehl eine andere Taste geben.</translation>
    </message>
    <message>
        <source>%1 already means “%2”, which is fixed.</source>
        <comment>key, what it does</comment>
        <translation>%1 bedeutet schon „%2“, und das liegt fest.</translation>
    </message>
    <message>
        <source>%1 is for texts: to copy, cut, paste or select.</source>
        <comment>key</comment>
        <translation>%1 dient Texten: zum Kopieren, Ausschneiden, Einfügen oder Auswählen.</translation>
    </message>
    <message>
        <source>Keys with Alt open menus. Take one with Ctrl.</source>
        <translation>Tasten mit Alt öffnen Menüs. Eine mit Strg nehmen.</translation>
    </message>
    <message>
        <source>This command acts on every page: it needs a key with Ctrl, or one of F1 to F12.</source>
        <translation>Dieser Befehl wirkt auf jeder Seite: er braucht eine Taste mit Strg oder eine von F1 bis F12.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ShotList</name>
    <message>
        <source>Shot list</source>
        <translation>Szenenliste</translation>
    </message>
    <message>
        <source>What is to be recorded, one shot a line; takes are counted for each.</source>
        <translation>Was aufgenommen werden soll, eine Szene je Zeile; für jede werden die Aufnahmen gezählt.</translation>
    </message>
    <message>
        <source>Paste a list</source>
        <translation>Liste einfügen</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>%1, %2 of %3 takes</source>
        <comment>a shot</comment>
        <translation>%1, %2 von %3 Aufnahmen</translation>
    </message>
    <message>
        <source>A shot list belongs to a session. Make or open one first.</source>
        <translation>Eine Szenenliste gehört zu einer Sitzung. Zuerst eine anlegen oder öffnen.</translation>
    </message>
    <message>
        <source>%1 of %2 takes done</source>
        <translation>%1 von %2 Aufnahmen gemacht</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ShotListDialog</name>
    <message>
        <source>Paste a shot list</source>
        <translation>Szenenliste einfügen</translation>
    </message>
    <message>
        <source>Edit the shot list</source>
        <translation>Szenenliste bearbeiten</translation>
    </message>
    <message>
        <source>One shot a line, in the order in which they are recorded. With &quot;x3&quot; at its end three takes of it are wanted; its first word names them.</source>
        <translation>Eine Szene je Zeile, in der Reihenfolge der Aufnahme. Mit „x3“ am Ende werden drei Aufnahmen gebraucht; ihr erstes Wort gibt ihnen den Namen.</translation>
    </message>
    <message>
        <source>Use this list</source>
        <translation>Diese Liste verwenden</translation>
    </message>
    <message>
        <source>Walk, straight line x2
Reach, high and low
Turn, both ways x3</source>
        <translation>Gehen, geradeaus x2
Greifen, hoch und tief
Drehen, beide Richtungen x3</translation>
    </message>
    <message>
        <source>Shot list</source>
        <translation>Szenenliste</translation>
    </message>
    <message numerus="yes">
        <source>%n shot(s)</source>
        <translation>
            <numerusform>%n Szene</numerusform>
            <numerusform>%n Szenen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n take(s)</source>
        <translation>
            <numerusform>%n Aufnahme</numerusform>
            <numerusform>%n Aufnahmen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::ShowFolder</name>
    <message>
        <source>No file manager could be started</source>
        <translation>Kein Dateiverwalter ließ sich starten</translation>
    </message>
    <message>
        <source>The folder is %1. Open it by hand, or install a file manager.</source>
        <translation>Der Ordner ist %1. Öffnen Sie ihn von Hand, oder installieren Sie einen Dateiverwalter.</translation>
    </message>
    <message>
        <source>No program opened %1</source>
        <translation>Kein Programm hat %1 geöffnet</translation>
    </message>
    <message>
        <source>The file is %1. Open it by hand, or install a program for such files.</source>
        <translation>Die Datei ist %1. Öffnen Sie sie von Hand, oder installieren Sie ein Programm für solche Dateien.</translation>
    </message>
    <message>
        <source>%1 is not there</source>
        <translation>%1 ist nicht da</translation>
    </message>
    <message>
        <source>It may have been moved, or its disk is not connected.</source>
        <translation>Vielleicht wurde es verschoben, oder sein Datenträger ist nicht angeschlossen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ShownBody</name>
    <message>
        <source>Reading the file</source>
        <translation>Datei wird gelesen</translation>
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
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SideDocks</name>
    <message>
        <source>Left panel</source>
        <translation>Linkes Feld</translation>
    </message>
    <message>
        <source>Right panel</source>
        <translation>Rechtes Feld</translation>
    </message>
    <message>
        <source>Let this panel float, or put it back</source>
        <translation>Dieses Feld lösen oder wieder anheften</translation>
    </message>
    <message>
        <source>Close this panel; it comes back through View</source>
        <translation>Dieses Feld schließen; über Ansicht kommt es zurück</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SoundSource</name>
    <message>
        <source>Reading the sound of board %1</source>
        <translation>Der Ton von Platine %1 wird gelesen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::StartPage</name>
    <message>
        <source>Noctule</source>
        <translation>Noctule</translation>
    </message>
    <message>
        <source>Motion capture by sound and inertia</source>
        <translation>Bewegungserfassung mit Schall und Trägheit</translation>
    </message>
    <message>
        <source>New session</source>
        <translation>Neue Sitzung</translation>
    </message>
    <message>
        <source>A folder for takes, calibration and exports</source>
        <translation>Ordner für Aufnahmen und Exporte</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>Any folder with a session.json</source>
        <translation>Jeder Ordner mit einer session.json</translation>
    </message>
    <message>
        <source>Try it with the virtual suit</source>
        <translation>Mit dem virtuellen Anzug probieren</translation>
    </message>
    <message>
        <source>A simulated performer, nothing to plug in</source>
        <translation>Ein simulierter Darsteller, nichts anzuschließen</translation>
    </message>
    <message>
        <source>Suits found</source>
        <translation>Gefundene Anzüge</translation>
    </message>
    <message>
        <source>First time here</source>
        <translation>Zum ersten Mal hier</translation>
    </message>
    <message>
        <source>Tour of the five steps</source>
        <translation>Rundgang durch die fünf Schritte</translation>
    </message>
    <message>
        <source>2 minutes</source>
        <translation>2 Minuten</translation>
    </message>
    <message>
        <source>Put the suit on</source>
        <translation>Anzug anlegen</translation>
    </message>
    <message>
        <source>drawings, 5 minutes</source>
        <translation>Zeichnungen, 5 Minuten</translation>
    </message>
    <message>
        <source>What is new</source>
        <translation>Was ist neu</translation>
    </message>
    <message>
        <source>Recent sessions</source>
        <translation>Letzte Sitzungen</translation>
    </message>
    <message>
        <source>Find a session or take</source>
        <translation>Sitzungen durchsuchen</translation>
    </message>
    <message>
        <source>Sessions that you make or open are listed here, the newest first.</source>
        <translation>Angelegte und geöffnete Sitzungen stehen hier, die neueste zuerst.</translation>
    </message>
    <message>
        <source>No session and no take has “%1” in its name.</source>
        <translation>Keine Sitzung und keine Aufnahme hat „%1“ im Namen.</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Review %1</source>
        <translation>%1 prüfen</translation>
    </message>
    <message>
        <source>Recording in “%1” stopped unexpectedly. %2 are safe on disk; the other takes were not touched.</source>
        <translation>Die Aufnahme in „%1“ brach unerwartet ab. %2 liegen sicher auf dem Datenträger; die anderen Aufnahmen sind unberührt.</translation>
    </message>
    <message>
        <source>“%1” was not closed</source>
        <translation>„%1“ wurde nicht geschlossen</translation>
    </message>
    <message numerus="yes">
        <source>The studio ended unexpectedly while this session was open. Its %n take(s) are safe; changes to notes and ratings were saved up to the last second.</source>
        <translation>
            <numerusform>Das Studio wurde unerwartet beendet, während diese Sitzung offen war. Ihre Aufnahme ist sicher; Änderungen an Notizen und Bewertungen sind bis zur letzten Sekunde gespeichert.</numerusform>
            <numerusform>Das Studio wurde unerwartet beendet, während diese Sitzung offen war. Ihre %n Aufnahmen sind sicher; Änderungen an Notizen und Bewertungen sind bis zur letzten Sekunde gespeichert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Recover %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>Open it as it is</source>
        <translation>So öffnen, wie sie ist</translation>
    </message>
    <message>
        <source>The list of “%1” is damaged</source>
        <translation>Die Liste von „%1“ ist beschädigt</translation>
    </message>
    <message>
        <source>Rebuild session</source>
        <translation>Sitzung neu aufbauen</translation>
    </message>
    <message>
        <source>Connect a suit</source>
        <translation>Anzug verbinden</translation>
    </message>
    <message>
        <source>No driver box is found. Switch one on, or connect it by USB; the virtual suit on Connect stands in for one.</source>
        <translation>Keine Steuerbox ist gefunden. Eine einschalten oder über USB anschließen; der virtuelle Anzug im Schritt Verbinden vertritt sie.</translation>
    </message>
    <message>
        <source>is connected</source>
        <translation>ist verbunden</translation>
    </message>
    <message>
        <source>is being connected</source>
        <translation>wird verbunden</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>another studio uses it</source>
        <translation>ein anderes Studio verwendet ihn</translation>
    </message>
    <message>
        <source>ready to connect</source>
        <translation>bereit zum Verbinden</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Another studio uses it.</source>
        <translation>Ein anderes Studio verwendet ihn.</translation>
    </message>
    <message>
        <source>Take %1 was recovered</source>
        <translation>Aufnahme %1 wurde wiederhergestellt</translation>
    </message>
    <message>
        <source>Take %1 broke off</source>
        <translation>Aufnahme %1 brach ab</translation>
    </message>
    <message>
        <source>Import motion</source>
        <translation>Bewegung importieren</translation>
    </message>
    <message>
        <source>A BVH file, worn by a simulated suit</source>
        <translation>BVH-Datei, simulierter Anzug</translation>
    </message>
</context>
<context>
    <name>noctule::ui::StateStrip</name>
    <message>
        <source>State of the robot</source>
        <translation>Zustand des Roboters</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>state of the robot: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>a joint is more than %1 away</source>
        <translation>ein Gelenk ist mehr als %1 entfernt</translation>
    </message>
    <message>
        <source>every joint within %1</source>
        <translation>jedes Gelenk innerhalb %1</translation>
    </message>
    <message>
        <source>moves as you do</source>
        <translation>bewegt sich wie Sie</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>steht still</translation>
    </message>
</context>
<context>
    <name>noctule::ui::StatusLine</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>%1, %2, complete</source>
        <comment>a take&apos;s file and its size</comment>
        <translation>%1, %2, vollständig</translation>
    </message>
    <message>
        <source>%1, %2, recovered</source>
        <comment>a take&apos;s file and its size</comment>
        <translation>%1, %2, wiederhergestellt</translation>
    </message>
    <message>
        <source>%1, %2, not ended</source>
        <comment>a take&apos;s file and its size</comment>
        <translation>%1, %2, nicht beendet</translation>
    </message>
    <message>
        <source>%1, all changes are kept</source>
        <comment>name of the session</comment>
        <translation>%1, alle Änderungen sind gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>%n jobs running</source>
        <translation>
            <numerusform>%n Auftrag läuft</numerusform>
            <numerusform>%n Aufträge laufen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n job(s) failed</source>
        <translation>
            <numerusform>%n Auftrag fehlgeschlagen</numerusform>
            <numerusform>%n Aufträge fehlgeschlagen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n job(s) finished</source>
        <translation>
            <numerusform>%n Auftrag beendet</numerusform>
            <numerusform>%n Aufträge beendet</numerusform>
        </translation>
    </message>
    <message>
        <source>No jobs running</source>
        <translation>Keine Aufträge</translation>
    </message>
    <message>
        <source>Cancel %1</source>
        <translation>%1 abbrechen</translation>
    </message>
    <message>
        <source>A suit of 18 boards records 5.4 MB a second.</source>
        <translation>Ein Anzug mit 18 Platinen zeichnet 5,4&#xa0;MB in der Sekunde auf.</translation>
    </message>
    <message>
        <source>Noctule %1. Works offline, no account</source>
        <comment>version</comment>
        <translation>Noctule %1. Arbeitet offline, ohne Konto</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1&#xa0;°C</translation>
    </message>
    <message>
        <source>humidity %1</source>
        <translation>Luftfeuchte %1</translation>
    </message>
    <message>
        <source>Storage %1 free, %2 of recording</source>
        <translation>Speicher %1 frei, %2 Aufnahme</translation>
    </message>
    <message>
        <source>What is connected records %1 a second.</source>
        <translation>Was verbunden ist, nimmt %1 in der Sekunde auf.</translation>
    </message>
    <message>
        <source>Jobs (%1)</source>
        <comment>a key</comment>
        <translation>Aufträge (%1)</translation>
    </message>
    <message>
        <source>%1, %2, damaged</source>
        <comment>a take&apos;s file and its size</comment>
        <translation>%1, %2, beschädigt</translation>
    </message>
    <message>
        <source>%1, %2, read only</source>
        <comment>a take&apos;s file and its size</comment>
        <translation>%1, %2, nur lesbar</translation>
    </message>
    <message>
        <source>%1, read only: changes are not kept</source>
        <comment>name of the session</comment>
        <translation>%1, nur lesbar: Änderungen werden nicht behalten</translation>
    </message>
    <message>
        <source>%1 MB/s</source>
        <translation>%1&#xa0;MB/s</translation>
    </message>
    <message>
        <source>%1 is being connected</source>
        <translation>%1 wird verbunden</translation>
    </message>
    <message>
        <source>%1: the link is broken, the studio tries again</source>
        <translation>%1: die Verbindung ist unterbrochen, das Studio versucht es wieder</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 antwortet nicht</translation>
    </message>
    <message>
        <source>%1: no sound arrives</source>
        <translation>%1: kein Ton kommt an</translation>
    </message>
    <message numerus="yes">
        <source>%n boxes streaming</source>
        <translation>
            <numerusform>%n Box sendet</numerusform>
            <numerusform>%n Boxen senden</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 streaming</source>
        <translation>%1 sendet</translation>
    </message>
    <message numerus="yes">
        <source>%n block(s) lost</source>
        <translation>
            <numerusform>%n Block verloren</numerusform>
            <numerusform>%n Blöcke verloren</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noctule::ui::StepBar</name>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Needs attention</source>
        <translation>Braucht Aufmerksamkeit</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
</context>
<context>
    <name>noctule::ui::StorageWatch</name>
    <message>
        <source>Room on %1</source>
        <translation>Platz auf %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::Studio</name>
    <message>
        <source>Waits for another take</source>
        <translation>Wartet auf eine andere Aufnahme</translation>
    </message>
    <message>
        <source>Virtual suit</source>
        <translation>Virtueller Anzug</translation>
    </message>
    <message>
        <source>sample</source>
        <comment>name of takes</comment>
        <translation>probe</translation>
    </message>
    <message>
        <source>%1 is ready</source>
        <translation>%1 ist bereit</translation>
    </message>
    <message>
        <source>Processing %1</source>
        <translation>%1 wird verarbeitet</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 is ready: %n pose(s)</source>
        <comment>name of the result, of the take</comment>
        <translation>
            <numerusform>%1 von %2 ist bereit: %n Pose</numerusform>
            <numerusform>%1 von %2 ist bereit: %n Posen</numerusform>
        </translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SuitCards</name>
    <message>
        <source>%1, %2 kHz</source>
        <comment>serial number and carrier of a driver box</comment>
        <translation>%1, %2&#xa0;kHz</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more</source>
        <comment>what is wrong first</comment>
        <translation>
            <numerusform>%1 und %n weiteres</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Lost at %1</source>
        <comment>a time of the take</comment>
        <translation>Verloren bei %1</translation>
    </message>
    <message>
        <source>Its box is gone. The others are recorded on, and it goes on when the box is back.</source>
        <translation>Die Steuerbox ist weg. Die anderen werden weiter aufgenommen; ist sie wieder da, geht es auch hier weiter.</translation>
    </message>
    <message>
        <source>Its box has ended its part. The others are recorded on.</source>
        <translation>Die Steuerbox hat ihren Teil beendet. Die anderen werden weiter aufgenommen.</translation>
    </message>
    <message>
        <source>Being saved</source>
        <comment>a suit&apos;s part of a take</comment>
        <translation>Wird gespeichert</translation>
    </message>
    <message>
        <source>Records, %1</source>
        <comment>a time of the take</comment>
        <translation>Nimmt auf, %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SuitFinder</name>
    <message>
        <source>Suit %1</source>
        <comment>its serial number</comment>
        <translation>Anzug %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SuitPartsModel</name>
    <message>
        <source>own place</source>
        <translation>eigener Platz</translation>
    </message>
    <message>
        <source>S%1</source>
        <comment>short for source 1</comment>
        <translation>Q%1</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Bewegt</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SuitStateCard</name>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <comment>a performer</comment>
        <translation>%1 zeigen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::SuitSwitch</name>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeChanges</name>
    <message>
        <source>Writing a marker into %1</source>
        <translation>Eine Marke wird in %1 geschrieben</translation>
    </message>
    <message>
        <source>Writing contacts into %1</source>
        <translation>Kontakte werden in %1 geschrieben</translation>
    </message>
    <message>
        <source>Writing the places of anchors into %1</source>
        <translation>Die Orte der Anker werden in %1 geschrieben</translation>
    </message>
    <message>
        <source>Writing the attached motion into %1</source>
        <translation>Die angehängte Bewegung wird in %1 geschrieben</translation>
    </message>
    <message>
        <source>The session can be read but not written</source>
        <translation>Die Sitzung lässt sich lesen, aber nicht schreiben</translation>
    </message>
    <message>
        <source>Copy its folder to where you may write, and open it there.</source>
        <translation>Den Ordner dorthin kopieren, wo Sie schreiben dürfen, und ihn dort öffnen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeClock</name>
    <message>
        <source>On disk up to %1</source>
        <translation>Gespeichert bis %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeDelegate</name>
    <message>
        <source>Name of the take</source>
        <translation>Name der Aufnahme</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeDocument</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Loading the motion</source>
        <translation>Die Bewegung wird geladen</translation>
    </message>
    <message>
        <source>Looking for foot contacts</source>
        <translation>Fußkontakte werden gesucht</translation>
    </message>
    <message>
        <source>Loading the ranges</source>
        <translation>Die Entfernungen werden geladen</translation>
    </message>
    <message>
        <source>Loading the readings</source>
        <translation>Die Messwerte werden geladen</translation>
    </message>
    <message>
        <source>Judging the take</source>
        <translation>Die Aufnahme wird beurteilt</translation>
    </message>
    <message>
        <source>Drawing ranges</source>
        <translation>Entfernungen werden gezeichnet</translation>
    </message>
    <message>
        <source>Drawing readings</source>
        <translation>Messwerte werden gezeichnet</translation>
    </message>
    <message>
        <source>Drawing joint angles</source>
        <translation>Gelenkwinkel werden gezeichnet</translation>
    </message>
    <message>
        <source>Measuring between performers</source>
        <translation>Abstände zwischen Darstellern werden gemessen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeList</name>
    <message>
        <source>Takes</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 lässt sich nicht öffnen: %2</translation>
    </message>
    <message>
        <source>The file stays where it is; nothing in it is changed.</source>
        <translation>Die Datei bleibt, wo sie ist; nichts darin wird verändert.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Save what can be read</source>
        <translation>Lesbares speichern</translation>
    </message>
    <message>
        <source>Rating</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message numerus="yes">
        <source>%n stars</source>
        <translation>
            <numerusform>%n Stern</numerusform>
            <numerusform>%n Sterne</numerusform>
        </translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>In den Papierkorb</translation>
    </message>
    <message>
        <source>Takes appear here as they are recorded. Drop take files here to copy them into the session.</source>
        <translation>Aufnahmen erscheinen hier, sobald sie gemacht sind. Aufnahmedateien hierher ziehen, um sie in die Sitzung zu kopieren.</translation>
    </message>
    <message>
        <source>No session is open.</source>
        <translation>Keine Sitzung ist offen.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Move to session…</source>
        <translation>In andere Sitzung verschieben&#xa0;…</translation>
    </message>
    <message>
        <source>Copy to session…</source>
        <translation>In andere Sitzung kopieren&#xa0;…</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeListModel</name>
    <message numerus="yes">
        <source>%1, %2, %3, %n stars</source>
        <translation>
            <numerusform>%1, %2, %3, %n Stern</numerusform>
            <numerusform>%1, %2, %3, %n Sterne</numerusform>
        </translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>recovered and processed</source>
        <translation>wiederhergestellt und verarbeitet</translation>
    </message>
    <message>
        <source>recovered, not processed yet</source>
        <translation>wiederhergestellt, noch nicht verarbeitet</translation>
    </message>
    <message>
        <source>was not finished</source>
        <translation>wurde nicht beendet</translation>
    </message>
    <message>
        <source>processed</source>
        <translation>verarbeitet</translation>
    </message>
    <message>
        <source>not processed yet</source>
        <translation>noch nicht verarbeitet</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeNotes</name>
    <message>
        <source>%1 (board %2)</source>
        <comment>body part, number</comment>
        <translation>%1 (Platine %2)</translation>
    </message>
    <message>
        <source>%1 %2 fell silent; back at %3</source>
        <comment>time, board, time</comment>
        <translation>%1 %2 verstummte; wieder da bei %3</translation>
    </message>
    <message>
        <source>%1 %2 fell silent</source>
        <comment>time, board</comment>
        <translation>%1 %2 verstummte</translation>
    </message>
    <message>
        <source>%1 driver box: %2</source>
        <comment>time, what it says</comment>
        <translation>%1 Steuerbox: %2</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TakeRange</name>
    <message>
        <source>In is at %1, out at %2.</source>
        <translation>Anfang bei %1, Ende bei %2.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TaskCard</name>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Prepare: %1</source>
        <translation>Vorbereiten: %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>time of the cursor, length of the take</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Marker at %1</source>
        <translation>Marke bei %1</translation>
    </message>
    <message>
        <source>%1, at %2</source>
        <translation>%1, bei %2</translation>
    </message>
    <message>
        <source>Gap of %1: nothing arrived</source>
        <translation>Lücke von %1: nichts kam an</translation>
    </message>
    <message>
        <source>In, %1</source>
        <translation>Anfang, %1</translation>
    </message>
    <message>
        <source>Out, %1</source>
        <translation>Ende, %1</translation>
    </message>
    <message>
        <source>Name marker</source>
        <translation>Marke benennen</translation>
    </message>
    <message>
        <source>Delete marker</source>
        <translation>Marke löschen</translation>
    </message>
    <message>
        <source>Name of the marker</source>
        <translation>Name der Marke</translation>
    </message>
    <message>
        <source>Left and Right step a frame, with Shift a second; Home and End go to in and out; F2 names the chosen marker, Del deletes it. Up and Down choose the contact of the left or right foot at the cursor, with Ctrl Left and Right the one before or after; I and O let it begin or end at the cursor, Ins sets one, Del deletes it</source>
        <translation>Links und Rechts gehen ein Bild weiter, mit Umschalt eine Sekunde; Pos1 und Ende zu Anfang und Ende des Bereichs; F2 benennt die gewählte Marke, Entf löscht sie. Hoch und Herunter wählen den Kontakt des linken oder rechten Fußes am Zeiger, mit Strg Links und Rechts den davor oder danach; mit I und O beginnt oder endet er am Zeiger, Einfg setzt einen, Entf löscht ihn</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ToolButton</name>
    <message>
        <source>%1 (%2)</source>
        <comment>name of a button (its shortcut)</comment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TopBar</name>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Menüs</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>No suit</source>
        <translation>Kein Anzug</translation>
    </message>
    <message>
        <source>No suit is connected. Opens Connect.</source>
        <translation>Kein Anzug verbunden. Öffnet Verbinden.</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>The connected suit. Opens Connect.</source>
        <translation>Der verbundene Anzug. Öffnet Verbinden.</translation>
    </message>
    <message>
        <source>Boards that are there. Opens Connect.</source>
        <translation>Platinen, die da sind. Öffnet Verbinden.</translation>
    </message>
    <message>
        <source>Recording, %1</source>
        <translation>Aufnahme läuft, %1</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Opens Record (%1)</source>
        <comment>a key</comment>
        <translation>Öffnet Aufnehmen (%1)</translation>
    </message>
    <message>
        <source>A take is being recorded. Opens Record; %1 stops it.</source>
        <comment>a key</comment>
        <translation>Eine Aufnahme läuft. Öffnet Aufnehmen; %1 beendet sie.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::Tour</name>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>The suit on the body: what every board hears and feels, and what to do when one is silent. Any step can be opened at any time.</source>
        <translation>Der Anzug am Körper: was jede Platine hört und spürt und was hilft, wenn eine schweigt. Jeder Schritt lässt sich jederzeit öffnen.</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>One large button. A take is on disk while it runs; whatever happens, it is safe up to the last second.</source>
        <translation>Ein großer Knopf. Eine Aufnahme ist schon während des Laufs auf dem Datenträger; was auch geschieht, sie ist bis zur letzten Sekunde sicher.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>The body moves, and every plot follows the same time. Process again with other sensors, compare with a reference, read the report.</source>
        <translation>Der Körper bewegt sich, und jedes Diagramm folgt derselben Zeit. Mit anderen Sensoren neu verarbeiten, mit einer Referenz vergleichen, den Bericht lesen.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Choose what the animation is for. Every file is read back and compared with its take before it counts as written.</source>
        <translation>Wählen, wofür die Animation ist. Jede Datei wird zurückgelesen und mit ihrer Aufnahme verglichen, bevor sie als geschrieben gilt.</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Rundgang verlassen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>number of a card, how many there are</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Wizards find out how the suit measures and how it sits on the body. They go on by themselves and say when something is not good enough.</source>
        <translation>Assistenten finden heraus, wie der Anzug misst und wie er am Körper sitzt. Sie gehen von selbst weiter und sagen, wenn etwas nicht gut genug ist.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TransferDialog</name>
    <message>
        <source>Move %1 to another session</source>
        <translation>%1 in eine andere Sitzung verschieben</translation>
    </message>
    <message>
        <source>Copy %1 to another session</source>
        <translation>%1 in eine andere Sitzung kopieren</translation>
    </message>
    <message>
        <source>Its results, markers, notes, rating and calibration go with it. Where its name is taken, both takes are kept.</source>
        <translation>Ergebnisse, Marken, Notizen, Bewertung und Kalibrierung gehen mit. Wo der Name vergeben ist, bleiben beide Aufnahmen erhalten.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Another session</source>
        <translation>Andere Sitzung</translation>
    </message>
    <message>
        <source>%1   in %2</source>
        <comment>name of a session, folder</comment>
        <translation>%1   in %2</translation>
    </message>
    <message>
        <source>The take is in this session already. Choose another one.</source>
        <translation>Die Aufnahme ist schon in dieser Sitzung. Eine andere wählen.</translation>
    </message>
    <message>
        <source>%1 is no session. Choose the folder of one; it holds session.json.</source>
        <translation>%1 ist keine Sitzung. Den Ordner einer Sitzung wählen; er enthält session.json.</translation>
    </message>
    <message>
        <source>Choose a session</source>
        <translation>Sitzung wählen</translation>
    </message>
    <message>
        <source>Choose a session.</source>
        <translation>Eine Sitzung wählen.</translation>
    </message>
    <message>
        <source>“%1” is open in another window. Close it there first.</source>
        <translation>„%1“ ist in einem anderen Fenster offen. Zuerst dort schließen.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::TransportBar</name>
    <message>
        <source>Previous marker</source>
        <translation>Vorige Marke</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>Nächste Marke</translation>
    </message>
    <message>
        <source>Loop between in and out</source>
        <translation>Schleife zwischen Anfang und Ende</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Length between in and out</source>
        <translation>Länge zwischen Anfang und Ende</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Set a marker at the cursor (%1)</source>
        <comment>a key</comment>
        <translation>Marke an den Zeiger setzen (%1)</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>Anfang %1</translation>
    </message>
    <message>
        <source>Out %1</source>
        <translation>Ende %1</translation>
    </message>
    <message numerus="yes">
        <source>%1, %2 frames</source>
        <comment>length between in and out</comment>
        <translation>
            <numerusform>%1, %2 Bild</numerusform>
            <numerusform>%1, %2 Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Open a take first</source>
        <translation>Zuerst eine Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Set in to the cursor (%1)</source>
        <comment>a key</comment>
        <translation>Anfang an den Zeiger setzen (%1)</translation>
    </message>
    <message>
        <source>Set out to the cursor (%1)</source>
        <comment>a key</comment>
        <translation>Ende an den Zeiger setzen (%1)</translation>
    </message>
</context>
<context>
    <name>noctule::ui::ValueCard</name>
    <message>
        <source>%1 %2</source>
        <comment>value and what it is</comment>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>noctule::ui::VirtualSuit</name>
    <message>
        <source>The virtual suit’s program is not part of this installation</source>
        <translation>Das Programm des virtuellen Anzugs ist nicht Teil dieser Installation</translation>
    </message>
    <message>
        <source>Install Noctule again</source>
        <translation>Noctule neu installieren</translation>
    </message>
    <message>
        <source>Preparing the virtual suit</source>
        <translation>Der virtuelle Anzug wird vorbereitet</translation>
    </message>
    <message>
        <source>The virtual suit’s program %1 could not be started</source>
        <translation>Das Programm %1 des virtuellen Anzugs konnte nicht gestartet werden</translation>
    </message>
    <message>
        <source>The virtual suit broke down</source>
        <translation>Der virtuelle Anzug ist abgestürzt</translation>
    </message>
    <message>
        <source>Start it again; takes of it are safe</source>
        <translation>Ihn neu starten; seine Aufnahmen sind sicher</translation>
    </message>
    <message>
        <source>The virtual suit ended by itself: %1</source>
        <comment>its last words</comment>
        <translation>Der virtuelle Anzug hat sich beendet: %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::WindowActions</name>
    <message>
        <source>New session</source>
        <translation>Neue Sitzung</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>Open take</source>
        <translation>Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Import takes into this session</source>
        <translation>Aufnahmen in diese Sitzung importieren</translation>
    </message>
    <message>
        <source>Show session folder</source>
        <translation>Ordner der Sitzung zeigen</translation>
    </message>
    <message>
        <source>Close session</source>
        <translation>Sitzung schließen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>Next panel</source>
        <translation>Nächstes Feld</translation>
    </message>
    <message>
        <source>Previous panel</source>
        <translation>Voriges Feld</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Reset this layout</source>
        <translation>Diese Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Record or stop</source>
        <translation>Aufnehmen oder beenden</translation>
    </message>
    <message>
        <source>Performer and suit</source>
        <translation>Darsteller und Anzug</translation>
    </message>
    <message>
        <source>Put the suit on</source>
        <translation>Anzug anlegen</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Tour of the five steps</source>
        <translation>Rundgang durch die fünf Schritte</translation>
    </message>
    <message>
        <source>What is new</source>
        <translation>Was ist neu</translation>
    </message>
    <message>
        <source>About Noctule</source>
        <translation>Über Noctule</translation>
    </message>
    <message>
        <source>Body of the view</source>
        <translation>Körper der Ansicht</translation>
    </message>
    <message>
        <source>Guide and documents</source>
        <translation>Handbuch und Dokumente</translation>
    </message>
    <message>
        <source>Save diagnosis</source>
        <translation>Diagnose speichern</translation>
    </message>
    <message>
        <source>Import motion</source>
        <translation>Bewegung importieren</translation>
    </message>
    <message>
        <source>Import recording</source>
        <translation>Aufzeichnung importieren</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Reset heading and place</source>
        <translation>Richtung und Platz zurücksetzen</translation>
    </message>
    <message>
        <source>Reset heading and place after the countdown</source>
        <translation>Richtung und Platz nach dem Countdown zurücksetzen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::WindowMenus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Suit</source>
        <translation>An&amp;zug</translation>
    </message>
    <message>
        <source>&amp;Take</source>
        <translation>Auf&amp;nahme</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Recent sessions</source>
        <translation>Letzte Sitzungen</translation>
    </message>
    <message>
        <source>No session was open before</source>
        <translation>Vorher war keine Sitzung offen</translation>
    </message>
</context>
<context>
    <name>noctule::ui::WizardBoards</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Calibrate with what there is</source>
        <translation>Mit Vorhandenem kalibrieren</translation>
    </message>
    <message>
        <source>The step that was taken last, once more (Backspace)</source>
        <translation>Den zuletzt erfassten Schritt noch einmal (Rücktaste)</translation>
    </message>
    <message>
        <source>%1 of %2 steps</source>
        <translation>%1 von %2 Schritten</translation>
    </message>
    <message>
        <source>Skip a board</source>
        <translation>Platine auslassen</translation>
    </message>
    <message>
        <source>Use board %1 again</source>
        <translation>Platine %1 wieder verwenden</translation>
    </message>
    <message>
        <source>Skip board %1</source>
        <translation>Platine %1 auslassen</translation>
    </message>
    <message>
        <source>Choose a board in the table first.</source>
        <translation>Zuerst eine Platine in der Tabelle wählen.</translation>
    </message>
    <message>
        <source>Repeat step %1</source>
        <translation>Schritt %1 wiederholen</translation>
    </message>
    <message>
        <source>Repeat the last step</source>
        <translation>Letzten Schritt wiederholen</translation>
    </message>
    <message>
        <source>No step has been taken yet.</source>
        <translation>Noch ist kein Schritt erfasst.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::WizardIntro</name>
    <message>
        <source>Better after the gyroscopes</source>
        <translation>Besser nach den Gyroskopen</translation>
    </message>
    <message>
        <source>The gyroscopes of this suit are not calibrated yet. How the boards sit is found all the same; after them, exchanged plugs are noticed more surely, and the zeros found stay in use.</source>
        <translation>Die Gyroskope dieses Anzugs sind noch nicht kalibriert. Wie die Platinen sitzen, wird trotzdem gefunden; danach fallen vertauschte Stecker sicherer auf, und die gefundenen Nullpunkte bleiben in Gebrauch.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Begin anew</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Choose the distances</source>
        <translation>Abstände wählen</translation>
    </message>
    <message>
        <source>Use recorded takes</source>
        <translation>Vorhandene Aufnahmen verwenden</translation>
    </message>
    <message>
        <source>What you need</source>
        <translation>Was gebraucht wird</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortsetzen</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) were taken on %1 and are kept.</source>
        <translation>
            <numerusform>%n Schritt ist schon erfasst und bleibt erhalten (%1).</numerusform>
            <numerusform>%n Schritte sind schon erfasst und bleiben erhalten (%1).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n distance(s)</source>
        <translation>
            <numerusform>%1: %n Abstand</numerusform>
            <numerusform>%1: %n Abstände</numerusform>
        </translation>
    </message>
    <message>
        <source>CSV with placement, kind, id, x_m, y_m, z_m, or with placement, source, board, distance_m</source>
        <translation>CSV mit placement, kind, id, x_m, y_m, z_m oder mit placement, source, board, distance_m</translation>
    </message>
    <message>
        <source>The takes could not be used</source>
        <translation>Die Aufnahmen ließen sich nicht verwenden</translation>
    </message>
    <message>
        <source>The distances could not be read</source>
        <translation>Die Abstände ließen sich nicht lesen</translation>
    </message>
    <message>
        <source>Choose the distances of the jig</source>
        <translation>Abstände des Messgestells wählen</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tabellen (*.csv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose the takes</source>
        <translation>Aufnahmen wählen</translation>
    </message>
    <message>
        <source>Takes (*.noctule)</source>
        <translation>Aufnahmen (*.noctule)</translation>
    </message>
    <message>
        <source>Nothing is measured now: takes of another day or another box are used instead</source>
        <translation>Jetzt wird nichts gemessen: Aufnahmen eines anderen Tages oder einer anderen Box werden verwendet</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>%1 of the directions are kept, too.</source>
        <translation>Auch %1 der Richtungen sind aufgehoben.</translation>
    </message>
    <message>
        <source>%1 of the directions were seen on %2 and are kept.</source>
        <translation>%1 der Richtungen wurden am %2 gesehen und sind aufgehoben.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::WizardLive</name>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>%1 so far</source>
        <translation>Bisher %1</translation>
    </message>
    <message>
        <source>Board %1</source>
        <translation>Platine %1</translation>
    </message>
    <message>
        <source>%1, %2 askew</source>
        <translation>%1, %2 schief</translation>
    </message>
    <message>
        <source>%1, silent</source>
        <translation>%1, stumm</translation>
    </message>
    <message>
        <source>%1, hardly moved</source>
        <translation>%1, kaum bewegt</translation>
    </message>
    <message>
        <source>Stand still. Then: %1</source>
        <translation>Still stehen. Danach: %1</translation>
    </message>
</context>
<context>
    <name>noctule::ui::WizardPage</name>
    <message>
        <source>Calibrating: %1</source>
        <translation>Kalibrierung läuft: %1</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
</context>
<context>
    <name>noctule::ui::WizardRail</name>
    <message>
        <source>Tones</source>
        <translation>Töne</translation>
    </message>
    <message>
        <source>Leave and resume later</source>
        <translation>Verlassen und später fortsetzen</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>A tone when a step is right, another when it has been taken</source>
        <translation>Ein Ton, wenn ein Schritt richtig ist, ein anderer, wenn er erfasst ist</translation>
    </message>
    <message>
        <source>What you need</source>
        <translation>Was gebraucht wird</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>noctule::ui::WizardResult</name>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Usable</source>
        <translation>Brauchbar</translation>
    </message>
    <message>
        <source>Not usable</source>
        <translation>Nicht brauchbar</translation>
    </message>
    <message>
        <source>Nothing need be repeated.</source>
        <translation>Nichts muss wiederholt werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) to look at.</source>
        <translation>
            <numerusform>%n Punkt zum Nachsehen.</numerusform>
            <numerusform>%n Punkte zum Nachsehen.</numerusform>
        </translation>
    </message>
    <message>
        <source>good: %1</source>
        <translation>gut: %1</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>im Mittel %1</translation>
    </message>
    <message>
        <source>mean %1 (blue), with the calibration before %2 (grey)</source>
        <translation>im Mittel %1 (blau), mit der Kalibrierung davor %2 (grau)</translation>
    </message>
    <message>
        <source>A triangle at the end of the scale: this error lies beyond it.</source>
        <translation>Ein Dreieck am Ende der Skala: Dieser Fehler liegt jenseits davon.</translation>
    </message>
</context>
<context>
    <name>noctule::ui::WizardRun</name>
    <message>
        <source>Choose the file with the distances first.</source>
        <translation>Zuerst die Datei mit den Abständen wählen.</translation>
    </message>
    <message>
        <source>There is no calibration to check. Calibrate the rest pose first.</source>
        <translation>Es gibt keine Kalibrierung zu kontrollieren. Zuerst die Ruhehaltung kalibrieren.</translation>
    </message>
    <message>
        <source>No suit is connected. Connect one first, or use takes that were recorded before.</source>
        <translation>Kein Anzug ist verbunden. Zuerst einen verbinden oder frühere Aufnahmen verwenden.</translation>
    </message>
    <message>
        <source>Calibration: %1</source>
        <translation>Kalibrierung: %1</translation>
    </message>
    <message>
        <source>No board of this suit has a magnetometer.</source>
        <translation>Keine Platine dieses Anzugs hat ein Magnetometer.</translation>
    </message>
    <message>
        <source>Keeping %1</source>
        <translation>%1 wird aufbewahrt</translation>
    </message>
</context>
<context>
    <name>noctule::ui::words</name>
    <message>
        <source>Enter</source>
        <comment>a key</comment>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Today, %1</source>
        <translation>Heute, %1</translation>
    </message>
    <message>
        <source>Yesterday</source>
        <translation>Gestern</translation>
    </message>
    <message>
        <source>d MMMM</source>
        <comment>day and month</comment>
        <translation>d. MMMM</translation>
    </message>
    <message>
        <source>d MMMM yyyy</source>
        <comment>day, month and year</comment>
        <translation>d. MMMM yyyy</translation>
    </message>
    <message>
        <source>today, %1</source>
        <comment>within a sentence</comment>
        <translation>heute, %1</translation>
    </message>
    <message>
        <source>yesterday</source>
        <comment>within a sentence</comment>
        <translation>gestern</translation>
    </message>
    <message>
        <source>just now</source>
        <comment>an age</comment>
        <translation>eben erst</translation>
    </message>
    <message>
        <source>%1 min</source>
        <comment>an age</comment>
        <translation>%1&#xa0;min</translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s)</source>
        <comment>an age</comment>
        <translation>
            <numerusform>%n Stunde</numerusform>
            <numerusform>%n Stunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s)</source>
        <comment>an age</comment>
        <translation>
            <numerusform>%n Tag</numerusform>
            <numerusform>%n Tage</numerusform>
        </translation>
    </message>
</context>
</TS>
