<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Pfeil hoch</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Pfeil runter</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Pfeil links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Pfeil rechts</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message numerus="yes">
        <source>%n features have no id; give each its own</source>
        <translation>
            <numerusform>%n Objekt hat keine Kennung; geben Sie ihm eine eigene</numerusform>
            <numerusform>%n Objekte haben keine Kennung; geben Sie jedem eine eigene</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features share the id &quot;%1&quot;; give each its own</source>
        <translation>
            <numerusform>%n Objekt hat die Kennung „%1“; geben Sie jedem eine eigene</numerusform>
            <numerusform>%n Objekte haben dieselbe Kennung „%1“; geben Sie jedem eine eigene</numerusform>
        </translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has fewer than three corners; draw it again</source>
        <translation>der Umriss der Region „%1“ hat weniger als drei Ecken; zeichnen Sie ihn neu</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a coordinate that is no number; draw it again</source>
        <translation>der Umriss der Region „%1“ hat eine Koordinate, die keine Zahl ist; zeichnen Sie ihn neu</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has no area; draw it again</source>
        <translation>der Umriss der Region „%1“ hat keine Fläche; zeichnen Sie ihn neu</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; crosses itself; draw it again</source>
        <translation>der Umriss der Region „%1“ kreuzt sich selbst; zeichnen Sie ihn neu</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has fewer than three corners; draw it again</source>
        <translation>der Umriss der Region „%1“ hat ein Loch mit weniger als drei Ecken; zeichnen Sie ihn neu</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has a coordinate that is no number; draw it again</source>
        <translation>der Umriss der Region „%1“ hat ein Loch mit einer Koordinate, die keine Zahl ist; zeichnen Sie ihn neu</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has no area; draw it again</source>
        <translation>der Umriss der Region „%1“ hat ein Loch ohne Fläche; zeichnen Sie ihn neu</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that crosses itself; draw it again</source>
        <translation>der Umriss der Region „%1“ hat ein Loch, das sich selbst kreuzt; zeichnen Sie ihn neu</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that lies outside it; draw it again</source>
        <translation>der Umriss der Region „%1“ hat ein Loch, das außerhalb liegt; zeichnen Sie ihn neu</translation>
    </message>
    <message numerus="yes">
        <source>%n regions have neither name nor ref: only its kind is spoken</source>
        <translation>
            <numerusform>%n Region hat weder Namen noch Nummer: nur ihre Art wird gesprochen</numerusform>
            <numerusform>%n Regionen haben weder Namen noch Nummer: nur ihre Art wird gesprochen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions are called &quot;%1&quot; or the like, which is never spoken; give it the name that people use</source>
        <translation>
            <numerusform>%n Region heißt „%1“, was nie gesprochen wird; geben Sie ihr den Namen, den die Leute benutzen</numerusform>
            <numerusform>%n Regionen heißen „%1“ oder ähnlich, was nie gesprochen wird; geben Sie ihnen den Namen, den die Leute benutzen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>level %1 is used by %n regions but is not in the layer levels: its name cannot be spoken; add it</source>
        <translation>
            <numerusform>die Ebene %1 wird von %n Region benutzt, fehlt aber in der Liste der Ebenen (levels): ihr Name kann nicht gesprochen werden; fügen Sie sie hinzu</numerusform>
            <numerusform>die Ebene %1 wird von %n Regionen benutzt, fehlt aber in der Liste der Ebenen (levels): ihr Name kann nicht gesprochen werden; fügen Sie sie hinzu</numerusform>
        </translation>
    </message>
    <message>
        <source>access &quot;%1&quot; names the region &quot;%2&quot;, which does not exist; correct it</source>
        <translation>der Durchgang „%1“ nennt die Region „%2“, die es nicht gibt; berichtigen Sie sie</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; lies more than 1 m from region &quot;%2&quot;; move it to the border</source>
        <translation>der Durchgang „%1“ liegt mehr als 1&#xa0;m von der Region „%2“ entfernt; schieben Sie ihn an die Grenze</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; has the same region on both sides: no route passes it; set region_a and region_b, or move it to a border</source>
        <translation>der Durchgang „%1“ hat auf beiden Seiten dieselbe Region: kein Weg führt hindurch; geben Sie die Region auf jeder Seite an (region_a und region_b), oder schieben Sie ihn an eine Grenze</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; does not join two regions: no route passes it; set region_a and region_b, or move it to a border</source>
        <translation>der Durchgang „%1“ verbindet nicht zwei Regionen: kein Weg führt hindurch; geben Sie die Region auf jeder Seite an (region_a und region_b), oder schieben Sie ihn an eine Grenze</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; is no stairs, lift, escalator or ramp but joins regions of levels %2 and %3; correct its kind or regions</source>
        <translation>der Durchgang „%1“ ist weder Treppe noch Aufzug, Rolltreppe oder Rampe, verbindet aber Regionen der Ebenen %2 und %3; berichtigen Sie seine Art oder die Regionen</translation>
    </message>
    <message numerus="yes">
        <source>%n accesses are drawn on more than two regions: see that region_a and region_b are the right ones</source>
        <translation>
            <numerusform>%n Durchgang liegt auf mehr als zwei Regionen: sehen Sie nach, ob die beiden Seiten (region_a und region_b) stimmen</numerusform>
            <numerusform>%n Durchgänge liegen auf mehr als zwei Regionen: sehen Sie nach, ob die beiden Seiten (region_a und region_b) stimmen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n escalators have no direction and count as running both ways: set oneway</source>
        <translation>
            <numerusform>%n Rolltreppe hat keine Richtung und gilt als in beide Richtungen laufend: geben Sie sie an (oneway)</numerusform>
            <numerusform>%n Rolltreppen haben keine Richtung und gelten als in beide Richtungen laufend: geben Sie sie an (oneway)</numerusform>
        </translation>
    </message>
    <message>
        <source>shaft &quot;%1&quot; passes level %2 without an access there; add it, unless it does not stop there</source>
        <translation>die Treppe oder der Aufzug „%1“ führt an der Ebene %2 vorbei, ohne dass es dort einen Durchgang gibt; fügen Sie ihn hinzu, wenn dort gehalten wird</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; belongs to no region; set region_id</source>
        <translation>die Landmarke „%1“ gehört zu keiner Region; geben Sie sie an (region_id)</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; names the region &quot;%2&quot;, which does not exist; correct it</source>
        <translation>die Landmarke „%1“ nennt die Region „%2“, die es nicht gibt; berichtigen Sie sie</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; is on level %2, its region &quot;%3&quot; on level %4</source>
        <translation>die Landmarke „%1“ ist auf Ebene %2, ihre Region „%3“ auf Ebene %4</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; lies more than 0.5 m outside its region &quot;%2&quot;; move it or correct region_id</source>
        <translation>die Landmarke „%1“ liegt mehr als 0,5&#xa0;m außerhalb ihrer Region „%2“; verschieben Sie sie, oder berichtigen Sie die Region (region_id)</translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2</source>
        <translation>
            <numerusform>%n Objekt hat die unbekannte Art „%1“; bekannt sind, in Klammern wie sie in der Karte stehen: %2</numerusform>
            <numerusform>%n Objekte haben die unbekannte Art „%1“; bekannt sind, in Klammern wie sie in der Karte stehen: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2 (nobody is led through other)</source>
        <translation>
            <numerusform>%n Objekt hat die unbekannte Art „%1“; bekannt sind, in Klammern wie sie in der Karte stehen: %2 (durch „other“ wird niemand geführt)</numerusform>
            <numerusform>%n Objekte haben die unbekannte Art „%1“; bekannt sind, in Klammern wie sie in der Karte stehen: %2 (durch „other“ wird niemand geführt)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the building falls into %1 parts; %n regions cannot be reached from the largest (%2): accesses are missing or closed</source>
        <translation>
            <numerusform>das Gebäude zerfällt in %1 Teile; %n Region ist vom größten (%2) aus nicht zu erreichen: Durchgänge fehlen oder sind gesperrt</numerusform>
            <numerusform>das Gebäude zerfällt in %1 Teile; %n Regionen sind vom größten (%2) aus nicht zu erreichen: Durchgänge fehlen oder sind gesperrt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>%n Region</numerusform>
            <numerusform>%n Regionen</numerusform>
        </translation>
    </message>
    <message>
        <source>region &quot;%1&quot; is a sliver, about %2 m wide: nobody stands there; join it to its neighbour</source>
        <translation>die Region „%1“ ist ein Streifen, etwa %2&#xa0;m breit: niemand steht dort; vereinigen Sie sie mit ihrer Nachbarregion</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot; have the same outline; remove one</source>
        <translation>die Regionen „%1“ und „%2“ haben denselben Umriss; entfernen Sie eine</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot;: the smaller lies inside the larger; cut it out of the larger one, unless it is a part of it</source>
        <translation>Regionen „%1“ und „%2“: die kleinere liegt in der größeren; schneiden Sie sie aus der größeren, wenn sie kein Teil davon ist</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot; overlap by %3 % of the smaller; draw the border between them</source>
        <translation>die Regionen „%1“ und „%2“ überlappen sich auf %3&#xa0;% der kleineren; zeichnen Sie die Grenze zwischen ihnen</translation>
    </message>
    <message>
        <source>so many regions overlap that not all pairs were compared; are all levels drawn on one?</source>
        <translation>so viele Regionen überlappen sich, dass nicht alle Paare verglichen wurden; sind alle Ebenen auf einer gezeichnet?</translation>
    </message>
    <message numerus="yes">
        <source>%n regions of level %1 have the ref &quot;%2&quot;: people are led to the wrong one; correct it</source>
        <translation>
            <numerusform>%n Region der Ebene %1 hat die Nummer „%2“: man wird zur falschen geführt; berichtigen Sie sie</numerusform>
            <numerusform>%n Regionen der Ebene %1 haben die Nummer „%2“: man wird zur falschen geführt; berichtigen Sie sie</numerusform>
        </translation>
    </message>
    <message>
        <source>the whole building is smaller than 0.3 m: its coordinates are degrees, not metres; import or reproject it</source>
        <translation>das ganze Gebäude ist kleiner als 0,3&#xa0;m: seine Koordinaten sind Grad, keine Meter; importieren oder projizieren Sie es</translation>
    </message>
    <message numerus="yes">
        <source>%n regions have no door or other access that joins another region: nobody can be led there; add it</source>
        <translation>
            <numerusform>%n Region hat keine Tür und keinen anderen Durchgang zu einer anderen Region: niemand kann dorthin geführt werden; fügen Sie ihn hinzu</numerusform>
            <numerusform>%n Regionen haben keine Tür und keinen anderen Durchgang zu einer anderen Region: niemand kann dorthin geführt werden; fügen Sie ihn hinzu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions have a door drawn on the border, but the door joins two others and nothing leads there: correct region_a or region_b, or draw another door</source>
        <translation>
            <numerusform>%n Region hat eine Tür an der Grenze, doch die verbindet zwei andere, und nichts führt dorthin: berichtigen Sie eine ihrer Seiten (region_a oder region_b), oder zeichnen Sie eine andere Tür</numerusform>
            <numerusform>%n Regionen haben eine Tür an der Grenze, doch die verbindet zwei andere, und nichts führt dorthin: berichtigen Sie eine ihrer Seiten (region_a oder region_b), oder zeichnen Sie eine andere Tür</numerusform>
        </translation>
    </message>
    <message>
        <source>features had no id and were given one</source>
        <translation>Objekte hatten keine Kennung und bekamen eine</translation>
    </message>
    <message>
        <source>features shared an id and were given another</source>
        <translation>Objekte hatten dieselbe Kennung und bekamen eine andere</translation>
    </message>
    <message>
        <source>outlines have corners that are no places; these were left out</source>
        <translation>Umrisse haben Ecken, die keine Orte sind; diese wurden weggelassen</translation>
    </message>
    <message>
        <source>outlines have fewer than three corners; the regions were left out</source>
        <translation>Umrisse haben weniger als drei Ecken; die Regionen wurden weggelassen</translation>
    </message>
    <message>
        <source>outlines have more than 200,000 corners; the regions were left out</source>
        <translation>Umrisse haben mehr als 200&#xa0;000 Ecken; die Regionen wurden weggelassen</translation>
    </message>
    <message>
        <source>outlines enclose no area; the regions were left out</source>
        <translation>Umrisse umschließen keine Fläche; die Regionen wurden weggelassen</translation>
    </message>
    <message>
        <source>outlines crossed or touched themselves and were mended: compare them with the plan</source>
        <translation>Umrisse kreuzten oder berührten sich selbst und wurden ausgebessert: vergleichen Sie sie mit dem Plan</translation>
    </message>
    <message>
        <source>regions fell into several parts: each part is a region of its own</source>
        <translation>Regionen zerfielen in mehrere Teile: jeder Teil ist eine eigene Region</translation>
    </message>
    <message>
        <source>regions repeat the outline of another one on their level and were merged with it</source>
        <translation>Regionen wiederholen den Umriss einer anderen auf ihrer Ebene und wurden mit ihr vereinigt</translation>
    </message>
    <message>
        <source>accesses have points that are no places; these were left out</source>
        <translation>Durchgänge haben Punkte, die keine Orte sind; diese wurden weggelassen</translation>
    </message>
    <message>
        <source>accesses have no place on the map and were left out</source>
        <translation>Durchgänge haben keinen Ort auf der Karte und wurden weggelassen</translation>
    </message>
    <message>
        <source>landmarks have no place on the map and were left out</source>
        <translation>Landmarken haben keinen Ort auf der Karte und wurden weggelassen</translation>
    </message>
    <message>
        <source>levels are no floors of a building; level 0 is assumed</source>
        <translation>Ebenen sind keine Stockwerke eines Gebäudes; Ebene 0 wird angenommen</translation>
    </message>
    <message>
        <source>levels stand twice in the source; the first name is kept</source>
        <translation>Ebenen stehen zweimal in der Quelle; der erste Name bleibt</translation>
    </message>
    <message>
        <source>regions had no name and were given one from kind and number, such as &quot;Corridor 3&quot;: rename them</source>
        <translation>Regionen hatten keinen Namen und bekamen einen aus Art und Nummer, wie „Corridor 3“: benennen Sie sie um</translation>
    </message>
    <message>
        <source>landmarks lie outside every region and were given to the nearest one</source>
        <translation>Landmarken liegen außerhalb aller Regionen und wurden der nächsten zugeteilt</translation>
    </message>
    <message>
        <source>openings were added where regions meet without a wall between them</source>
        <translation>Öffnungen wurden eingesetzt, wo Regionen ohne Wand dazwischen aneinanderstoßen</translation>
    </message>
    <message>
        <source>accesses are drawn on fewer than two regions</source>
        <translation>Durchgänge liegen auf weniger als zwei Regionen</translation>
    </message>
    <message>
        <source>accesses lie beside more than two regions; the two with the widest border were taken: see that they are right</source>
        <translation>Durchgänge liegen neben mehr als zwei Regionen; die beiden mit der breitesten Grenze wurden genommen: sehen Sie nach, ob sie stimmen</translation>
    </message>
    <message>
        <source>accesses run from one region to another and along no border: if one walks along the line, set region_a and region_b</source>
        <translation>Durchgänge führen von einer Region zur anderen und an keiner Grenze entlang: wenn man an der Linie entlanggeht, geben Sie die Region auf jeder Seite an (region_a und region_b)</translation>
    </message>
    <message>
        <source>stairs, lifts or escalators lead to a level that nothing names: set region_b, or give them and their other end the same shaft</source>
        <translation>Treppen, Aufzüge oder Rolltreppen führen zu einer Ebene, die nirgends genannt ist: geben Sie die Region auf der anderen Seite an (region_b), oder geben Sie ihnen und ihrem anderen Ende denselben Schacht (shaft)</translation>
    </message>
    <message>
        <source>upper ends of stairs, lifts or escalators were left out: their lower ends lead there already</source>
        <translation>obere Enden von Treppen, Aufzügen oder Rolltreppen wurden weggelassen: ihre unteren Enden führen schon dorthin</translation>
    </message>
    <message>
        <source>links between levels name regions that do not exist</source>
        <translation>Verbindungen zwischen Ebenen nennen Regionen, die es nicht gibt</translation>
    </message>
    <message>
        <source>stairs, lifts or escalators were joined with the ones above them, because their outlines overlap</source>
        <translation>Treppen, Aufzüge oder Rolltreppen wurden mit denen darüber verbunden, weil ihre Umrisse sich überlappen</translation>
    </message>
    <message>
        <source>the coordinate reference system of the source cannot be understood</source>
        <translation>das Koordinatensystem der Quelle wird nicht verstanden</translation>
    </message>
    <message>
        <source>the source names a CRS in metres, but its coordinates are degrees: they are taken as WGS 84</source>
        <translation>die Quelle nennt ein Koordinatensystem in Metern, ihre Koordinaten sind aber Grad: sie werden als WGS 84 genommen</translation>
    </message>
    <message>
        <source>the source names no CRS; its coordinates look like degrees and are taken as WGS 84</source>
        <translation>die Quelle nennt kein Koordinatensystem; die Koordinaten sehen wie Grad aus und werden als WGS 84 genommen</translation>
    </message>
    <message>
        <source>the source names a CRS in degrees, but its coordinates are not: they are taken as metres of a local plane</source>
        <translation>die Quelle nennt ein Koordinatensystem in Grad, ihre Koordinaten sind aber keine: sie werden als Meter einer örtlichen Ebene genommen</translation>
    </message>
    <message>
        <source>the source names no CRS: its coordinates are taken as metres of a local plane; name the CRS if there is one</source>
        <translation>die Quelle nennt kein Koordinatensystem: die Koordinaten werden als Meter einer örtlichen Ebene genommen; nennen Sie das System, wenn es eines gibt</translation>
    </message>
    <message>
        <source>north and east stand in each other&apos;s place in the source: they were exchanged; export it again to be sure</source>
        <translation>Nord und Ost sind in der Quelle vertauscht: sie wurden zurückgetauscht; exportieren Sie sie zur Sicherheit noch einmal</translation>
    </message>
    <message>
        <source>coordinates were brought from %1 to %2, in metres</source>
        <translation>die Koordinaten wurden von %1 nach %2 umgerechnet, in Meter</translation>
    </message>
    <message>
        <source>coordinates were brought from the source&apos;s CRS to %1, in metres</source>
        <translation>die Koordinaten wurden aus dem System der Quelle nach %1 umgerechnet, in Meter</translation>
    </message>
    <message>
        <source>layers hold no rooms, doors, walls or points by their name; a profile can say otherwise</source>
        <translation>Layer enthalten dem Namen nach keine Räume, Türen, Wände oder Punkte; ein Profil kann es anders sagen</translation>
    </message>
    <message>
        <source>features cannot be brought to the CRS of the other layers</source>
        <translation>Objekte lassen sich nicht in das Koordinatensystem der anderen Layer bringen</translation>
    </message>
    <message>
        <source>layers tell no level; the ground floor is assumed: name the field that holds the level</source>
        <translation>Layer sagen keine Ebene; das Erdgeschoss wird angenommen: nennen Sie das Feld, das die Ebene enthält</translation>
    </message>
    <message>
        <source>levels were counted from the heights of the shapes, the one nearest to 0 as the ground floor</source>
        <translation>Ebenen wurden nach der Höhe der Formen gezählt, die 0 am nächsten als Erdgeschoss</translation>
    </message>
    <message>
        <source>lines of layers that nothing names doors or walls are taken as walls; name the layer or give a profile</source>
        <translation>Linien von Layern, die nichts als Türen oder Wände bezeichnet, werden als Wände genommen; benennen Sie den Layer, oder geben Sie ein Profil an</translation>
    </message>
    <message>
        <source>features have no geometry and were left out</source>
        <translation>Objekte haben keine Form und wurden weggelassen</translation>
    </message>
    <message>
        <source>features have the code &quot;%1&quot;, which nobody knows: name it under codes in a profile</source>
        <translation>Objekte haben den Code „%1“, den niemand kennt: nennen Sie ihn in einem Profil unter „codes“</translation>
    </message>
    <message>
        <source>accesses have a direction that nobody knows and are taken to be passed both ways: a_to_b, b_to_a, up or down is wanted</source>
        <translation>Durchgänge haben eine Richtung, die niemand kennt, und gelten als in beide Richtungen offen: verlangt ist a_to_b, b_to_a, up oder down</translation>
    </message>
    <message>
        <source>points name a region that does not exist; the one they lie in is taken</source>
        <translation>Punkte nennen eine Region, die es nicht gibt; genommen wird die, in der sie liegen</translation>
    </message>
    <message>
        <source>layers have no features: %1</source>
        <translation>Layer ohne Objekte: %1</translation>
    </message>
    <message>
        <source>layers name no CRS; that of the other layers is taken</source>
        <translation>Layer nennen kein Koordinatensystem; das der anderen Layer wird genommen</translation>
    </message>
    <message>
        <source>features left out: their coordinates are missing or no places on Earth</source>
        <translation>Objekte weggelassen: ihre Koordinaten fehlen oder sind keine Orte auf der Erde</translation>
    </message>
    <message>
        <source>features left out: they have no usable shape</source>
        <translation>Objekte weggelassen: sie haben keine brauchbare Form</translation>
    </message>
    <message>
        <source>the value of level or repeat_on is no list of levels such as -1;0 or 1-3: correct it</source>
        <translation>der Wert von level oder repeat_on ist keine Liste von Ebenen wie -1;0 oder 1-3: berichtigen Sie ihn</translation>
    </message>
    <message>
        <source>there is no readable level; level 0 is assumed: add the level</source>
        <translation>es gibt keine lesbare Ebene; Ebene 0 wird angenommen: fügen Sie die Ebene (level) hinzu</translation>
    </message>
    <message>
        <source>the lift is a point in the source: a square of 1.6 m was drawn for its car</source>
        <translation>der Aufzug ist in der Quelle ein Punkt: für seine Kabine wurde ein Quadrat von 1,6&#xa0;m gezeichnet</translation>
    </message>
    <message>
        <source>left out: it has no level, and it stands over no or several levels&apos; regions</source>
        <translation>weggelassen: es hat keine Ebene und steht über Regionen mehrerer oder keiner Ebene</translation>
    </message>
    <message>
        <source>left out: no region of its level lies within 3 m</source>
        <translation>weggelassen: keine Region seiner Ebene liegt näher als 3&#xa0;m</translation>
    </message>
    <message>
        <source>left out: it has no level and stands on no outline of a region</source>
        <translation>weggelassen: sie hat keine Ebene und steht auf keinem Umriss einer Region</translation>
    </message>
    <message>
        <source>no door is drawn where a way leads into the room: an opening was put there</source>
        <translation>wo ein Weg in den Raum führt, ist keine Tür gezeichnet: dort wurde eine Öffnung eingesetzt</translation>
    </message>
    <message>
        <source>nothing tells which end of the steps is up; the first was taken as the lower: add incline</source>
        <translation>nichts sagt, welches Ende der Stufen oben ist; das erste wurde als das untere genommen: fügen Sie incline hinzu</translation>
    </message>
    <message>
        <source>no region lies at an end of the steps: draw the area or way it leads to</source>
        <translation>an einem Ende der Stufen liegt keine Region: zeichnen Sie die Fläche oder den Weg, zu dem sie führen</translation>
    </message>
    <message>
        <source>steps left out: their line has no length</source>
        <translation>Stufen weggelassen: ihre Linie hat keine Länge</translation>
    </message>
    <message>
        <source>nothing tells which way the walkway runs; it is taken to run both ways: set conveying to forward or backward</source>
        <translation>nichts sagt, in welche Richtung der Rollsteig läuft; angenommen werden beide: setzen Sie conveying auf forward oder backward</translation>
    </message>
    <message>
        <source>no region lies at an end of the walkway: draw the area or way it leads to</source>
        <translation>an einem Ende des Rollsteigs liegt keine Region: zeichnen Sie die Fläche oder den Weg, zu dem er führt</translation>
    </message>
    <message>
        <source>the lift has no drawn door; one was put on a side that is open: move it to its place</source>
        <translation>der Aufzug hat keine gezeichnete Tür; eine wurde an eine offene Seite gesetzt: schieben Sie sie an ihren Ort</translation>
    </message>
    <message>
        <source>features of the type %1 have no place in a building file</source>
        <translation>Objekte der Art %1 haben in einer Gebäudedatei keinen Platz</translation>
    </message>
    <message>
        <source>levels have no ordinal; they are taken as the ground floor</source>
        <translation>Ebenen haben keine Ordnungszahl; sie gelten als Erdgeschoss</translation>
    </message>
    <message>
        <source>features name a level that does not exist; the ground floor is assumed</source>
        <translation>Objekte nennen eine Ebene, die es nicht gibt; das Erdgeschoss wird angenommen</translation>
    </message>
    <message>
        <source>units have a category that IMDF 1.0 does not list; they are taken as rooms</source>
        <translation>Einheiten haben eine Kategorie, die IMDF 1.0 nicht aufführt; sie gelten als Räume</translation>
    </message>
    <message>
        <source>units are walls, columns or voids: they became walls</source>
        <translation>Einheiten sind Wände, Säulen oder Lufträume: sie wurden Wände</translation>
    </message>
    <message>
        <source>units have no outline and were left out</source>
        <translation>Einheiten haben keinen Umriss und wurden weggelassen</translation>
    </message>
    <message>
        <source>occupants have no anchor in a unit and were left out</source>
        <translation>Nutzer haben keinen Anker in einer Einheit und wurden weggelassen</translation>
    </message>
    <message>
        <source>openings are emergency exits, for vehicles or out of service: nobody is led through them</source>
        <translation>Öffnungen sind Notausgänge, für Fahrzeuge oder außer Betrieb: niemand wird hindurchgeführt</translation>
    </message>
    <message>
        <source>openings have no line and were left out</source>
        <translation>Öffnungen haben keine Linie und wurden weggelassen</translation>
    </message>
    <message>
        <source>amenities have no point and were left out</source>
        <translation>Einrichtungen haben keinen Punkt und wurden weggelassen</translation>
    </message>
    <message>
        <source>amenities name no unit that tells their level and were left out</source>
        <translation>Einrichtungen nennen keine Einheit, die ihre Ebene sagt, und wurden weggelassen</translation>
    </message>
    <message>
        <source>relationships do not name two units and were left out</source>
        <translation>Beziehungen nennen nicht zwei Einheiten und wurden weggelassen</translation>
    </message>
    <message>
        <source>the name of the coordinate system is not known; a local plane in metres is assumed</source>
        <translation>der Name des Koordinatensystems ist nicht bekannt; eine örtliche Ebene in Metern wird angenommen</translation>
    </message>
    <message>
        <source>cells left out: they have no outline, no id, or the id of another</source>
        <translation>Zellen weggelassen: sie haben keinen Umriss, keine Kennung oder die einer anderen</translation>
    </message>
    <message>
        <source>transitions left out: they do not connect two cells that are there</source>
        <translation>Übergänge weggelassen: sie verbinden nicht zwei Zellen, die es gibt</translation>
    </message>
    <message>
        <source>storeys are named by words; levels were taken from the heights</source>
        <translation>Stockwerke sind mit Worten benannt; die Ebenen wurden den Höhen entnommen</translation>
    </message>
    <message>
        <source>nothing tells the levels: all is taken as level 0; name the field that holds the level</source>
        <translation>nichts sagt die Ebenen: alles gilt als Ebene 0; nennen Sie das Feld, das die Ebene enthält</translation>
    </message>
    <message>
        <source>levels were counted from the heights of the floors</source>
        <translation>Ebenen wurden nach der Höhe der Böden gezählt</translation>
    </message>
    <message>
        <source>the door&apos;s cell does not lie between two rooms: it stays a region</source>
        <translation>die Zelle der Tür liegt nicht zwischen zwei Räumen: sie bleibt eine Region</translation>
    </message>
    <message>
        <source>features left out: they are no node, link, facility or entrance</source>
        <translation>Objekte weggelassen: sie sind weder Knoten noch Verbindung, Einrichtung oder Eingang</translation>
    </message>
    <message>
        <source>the network has no areas: each node became a region of strips along its links, cut half-way, and each facility a square of 2 m behind its entrance</source>
        <translation>das Netz hat keine Flächen: jeder Knoten wurde eine Region aus Streifen entlang seiner Verbindungen, auf halbem Weg geschnitten, und jede Einrichtung ein Quadrat von 2&#xa0;m hinter ihrem Eingang</translation>
    </message>
    <message>
        <source>floor 0 is taken as the ground floor; import it with the level from 1 when it is floor 1</source>
        <translation>Stockwerk 0 gilt als Erdgeschoss; importieren Sie mit der Ebene ab 1, wenn es Stockwerk 1 ist</translation>
    </message>
    <message>
        <source>floor 1 is taken as the ground floor; import it with the level from 0 when it is floor 0</source>
        <translation>Stockwerk 1 gilt als Erdgeschoss; importieren Sie mit der Ebene ab 0, wenn es Stockwerk 0 ist</translation>
    </message>
    <message>
        <source>nodes left out: they have no place, no id, or the id of another</source>
        <translation>Knoten weggelassen: sie haben keinen Ort, keine Kennung oder die eines anderen</translation>
    </message>
    <message>
        <source>nodes without a floor are taken to be on the ground</source>
        <translation>Knoten ohne Stockwerk gelten als im Erdgeschoss</translation>
    </message>
    <message>
        <source>links left out: they do not join two nodes that are there</source>
        <translation>Verbindungen weggelassen: sie verbinden nicht zwei Knoten, die es gibt</translation>
    </message>
    <message>
        <source>no link leads to the node</source>
        <translation>keine Verbindung führt zu dem Knoten</translation>
    </message>
    <message>
        <source>no entrance with a known node leads to the facility: it became a landmark</source>
        <translation>kein Eingang mit bekanntem Knoten führt zu der Einrichtung: sie wurde eine Landmarke</translation>
    </message>
    <message>
        <source>the facility of the entrance is missing</source>
        <translation>die Einrichtung des Eingangs fehlt</translation>
    </message>
    <message>
        <source>left out: it lies more than 20 m from every node of its floor</source>
        <translation>weggelassen: es liegt mehr als 20&#xa0;m von jedem Knoten seines Stockwerks entfernt</translation>
    </message>
    <message numerus="yes">
        <source>%n spaces were closed from walls, doors and windows; they have no names, and whether they are rooms, corridors or halls is a guess from their doors and size</source>
        <translation>
            <numerusform>%n Raum wurde aus Wänden, Türen und Fenstern geschlossen; er hat keinen Namen, und ob er Zimmer, Flur oder Halle ist, ist nach Türen und Größe geraten</numerusform>
            <numerusform>%n Räume wurden aus Wänden, Türen und Fenstern geschlossen; sie haben keine Namen, und ob sie Zimmer, Flure oder Hallen sind, ist nach Türen und Größe geraten</numerusform>
        </translation>
    </message>
    <message>
        <source>strips under 0.3 m between walls were left out</source>
        <translation>Streifen unter 0,3&#xa0;m zwischen Wänden wurden weggelassen</translation>
    </message>
    <message>
        <source>no space lies on one side of the door: it leads outside, or a wall is missing</source>
        <translation>auf einer Seite der Tür liegt kein Raum: sie führt nach draußen, oder eine Wand fehlt</translation>
    </message>
    <message>
        <source>%1, layer %2</source>
        <translation>%1, Layer %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, feature %2</source>
        <translation>%1, Objekt %2</translation>
    </message>
    <message>
        <source>%1, feature number %2</source>
        <translation>%1, Objekt Nummer %2</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, Ebene %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>diese Datei oder diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>is no file or folder</source>
        <translation>ist weder Datei noch Ordner</translation>
    </message>
    <message>
        <source>is a folder; a file is wanted</source>
        <translation>ist ein Ordner; verlangt ist eine Datei</translation>
    </message>
    <message>
        <source>holds no files</source>
        <translation>enthält keine Dateien</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>cannot be listed (%1)</source>
        <translation>lässt sich nicht auflisten (%1)</translation>
    </message>
    <message>
        <source>is not a map file that can be read</source>
        <translation>ist keine lesbare Kartendatei</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>lässt sich nicht bis zum Ende lesen</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>lässt sich nicht lesen (%1)</translation>
    </message>
    <message>
        <source>cannot be imported (%1)</source>
        <translation>lässt sich nicht importieren (%1)</translation>
    </message>
    <message>
        <source>the map cannot be put together (%1)</source>
        <translation>die Karte lässt sich nicht zusammensetzen (%1)</translation>
    </message>
    <message>
        <source>reading the map failed: %1</source>
        <translation>das Lesen der Karte ist fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>is empty or cannot be read</source>
        <translation>ist leer oder nicht lesbar</translation>
    </message>
    <message>
        <source>is no indoor map of a kind that is known: %1 was tried as %2; name its kind, or give a profile with its column names</source>
        <translation>ist keine Gebäudekarte einer bekannten Art: versucht wurde %1 als %2; nennen Sie die Art, oder geben Sie ein Profil mit den Spaltennamen an</translation>
    </message>
    <message>
        <source>holds no file of the format %1</source>
        <translation>enthält keine Datei des Formats %1</translation>
    </message>
    <message>
        <source>is larger than 1 GB: too much for a map of a building</source>
        <translation>ist größer als 1 GB: zu viel für die Karte eines Gebäudes</translation>
    </message>
    <message>
        <source>is larger than %1 MB: no map of a building is</source>
        <translation>ist größer als %1 MB: so groß ist keine Karte eines Gebäudes</translation>
    </message>
    <message>
        <source>holds more than 10000 files: name the folder of one building</source>
        <translation>enthält mehr als 10000 Dateien: nennen Sie den Ordner eines einzigen Gebäudes</translation>
    </message>
    <message>
        <source>the database cannot be opened</source>
        <translation>die Datenbank lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the zip holds more than 10000 files: no map of a building does</source>
        <translation>das Zip enthält mehr als 10000 Dateien: so viele hat keine Karte eines Gebäudes</translation>
    </message>
    <message>
        <source>a file in the zip has a name that leads out of it; the zip is not trusted</source>
        <translation>eine Datei im Zip hat einen Namen, der aus ihm hinausführt; dem Zip wird nicht getraut</translation>
    </message>
    <message>
        <source>the zip is locked by a password; unpack it first</source>
        <translation>das Zip ist mit einem Passwort gesperrt; entpacken Sie es zuerst</translation>
    </message>
    <message>
        <source>unpacks to %1 MB: too much for a map of a building</source>
        <translation>ist entpackt %1 MB groß: zu viel für die Karte eines Gebäudes</translation>
    </message>
    <message>
        <source>the zip&apos;s list of files is damaged; make the zip again</source>
        <translation>die Dateiliste des Zips ist beschädigt; machen Sie das Zip neu</translation>
    </message>
    <message>
        <source>the zip is cut off: its list of files is missing; copy it again</source>
        <translation>das Zip ist abgeschnitten: seine Dateiliste fehlt; kopieren Sie es neu</translation>
    </message>
    <message>
        <source>the zip is larger than any map; unpack it and name the folder</source>
        <translation>das Zip ist größer als jede Karte; entpacken Sie es, und nennen Sie den Ordner</translation>
    </message>
    <message>
        <source>the zip&apos;s list of files lies outside it; make the zip again</source>
        <translation>die Dateiliste des Zips liegt außerhalb; machen Sie das Zip neu</translation>
    </message>
    <message>
        <source>is a landmark library without a map: name the file of the building</source>
        <translation>ist eine Sammlung von Landmarken ohne Karte: nennen Sie die Datei des Gebäudes</translation>
    </message>
    <message>
        <source>is not a Farol map: it has no layer regions; import maps of another kind first</source>
        <translation>ist keine Farol-Karte: der Layer regions fehlt; importieren Sie Karten anderer Art zuerst</translation>
    </message>
    <message>
        <source>the map is in degrees (%1); metres are wanted: import or reproject it</source>
        <translation>die Karte ist in Grad (%1); verlangt sind Meter: importieren oder projizieren Sie sie</translation>
    </message>
    <message>
        <source>the map&apos;s unit is not the metre (%1): reproject it</source>
        <translation>die Einheit der Karte ist nicht der Meter (%1): projizieren Sie sie</translation>
    </message>
    <message>
        <source>the field %1 is missing; add and fill it</source>
        <translation>das Feld %1 fehlt; fügen Sie es hinzu, und füllen Sie es aus</translation>
    </message>
    <message>
        <source>the schema version &quot;%1&quot; is no version</source>
        <translation>die Schemaversion „%1“ ist keine Version</translation>
    </message>
    <message>
        <source>the map has schema version %1, this Farol knows %2: use a newer Farol</source>
        <translation>die Karte hat Schemaversion %1, dieses Farol kennt %2: benutzen Sie ein neueres Farol</translation>
    </message>
    <message>
        <source>the map has no regions; draw at least one</source>
        <translation>die Karte hat keine Regionen; zeichnen Sie mindestens eine</translation>
    </message>
    <message>
        <source>two features have this id; give each its own</source>
        <translation>zwei Objekte haben diese Kennung; geben Sie jedem eine eigene</translation>
    </message>
    <message>
        <source>this level is listed twice; remove one</source>
        <translation>diese Ebene steht zweimal in der Liste; entfernen Sie eine</translation>
    </message>
    <message>
        <source>oneway is &quot;%1&quot;; a_to_b, b_to_a or nothing is wanted</source>
        <translation>oneway ist „%1“; verlangt ist a_to_b, b_to_a oder nichts</translation>
    </message>
    <message>
        <source>has no %1; fill it in</source>
        <translation>hat kein %1; füllen Sie es aus</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 is no whole number within reason</source>
        <translation>%1 ist keine vernünftige ganze Zahl</translation>
    </message>
    <message>
        <source>%1 is neither 0 nor 1</source>
        <translation>%1 ist weder 0 noch 1</translation>
    </message>
    <message>
        <source>level %1 is no floor of a building</source>
        <translation>Ebene %1 ist kein Stockwerk eines Gebäudes</translation>
    </message>
    <message>
        <source>has no geometry; a %1 is wanted</source>
        <translation>hat keine Form; verlangt ist %1</translation>
    </message>
    <message>
        <source>consists of %1 parts; a single %2 is wanted: split it and give each part its own id</source>
        <translation>besteht aus %1 Teilen; verlangt ist ein einziger (%2): teilen Sie es, und geben Sie jedem Teil eine eigene Kennung</translation>
    </message>
    <message>
        <source>has a coordinate that is no number</source>
        <translation>hat eine Koordinate, die keine Zahl ist</translation>
    </message>
    <message>
        <source>has a coordinate beyond any metric map</source>
        <translation>hat eine Koordinate jenseits jeder Karte in Metern</translation>
    </message>
    <message>
        <source>is an outline without an area</source>
        <translation>ist ein Umriss ohne Fläche</translation>
    </message>
    <message>
        <source>is a %1; a %2 is wanted</source>
        <translation>ist %1; verlangt ist %2</translation>
    </message>
    <message>
        <source>has no outline</source>
        <translation>hat keinen Umriss</translation>
    </message>
    <message>
        <source>there are no rooms, corridors or other areas in it: nothing to walk through</source>
        <translation>es gibt darin keine Räume, Flure oder anderen Flächen: nichts, wo man gehen kann</translation>
    </message>
    <message>
        <source>has %1 levels: no building has; the level stands in another attribute: name that one</source>
        <translation>hat %1 Ebenen: so viele hat kein Gebäude; die Ebene steht in einem anderen Attribut: nennen Sie es</translation>
    </message>
    <message>
        <source>the map has no coordinates</source>
        <translation>die Karte hat keine Koordinaten</translation>
    </message>
    <message>
        <source>geocentric coordinates are no plan of a floor; project them</source>
        <translation>geozentrische Koordinaten sind kein Plan eines Stockwerks; projizieren Sie sie</translation>
    </message>
    <message>
        <source>coordinates are beyond 100,000 km: they are no metres of a building</source>
        <translation>die Koordinaten liegen jenseits von 100&#xa0;000 km: das sind keine Meter eines Gebäudes</translation>
    </message>
    <message>
        <source>the coordinates do not lie where their CRS is defined</source>
        <translation>die Koordinaten liegen nicht, wo ihr System definiert ist</translation>
    </message>
    <message>
        <source>the CRS cannot be brought to metres</source>
        <translation>das Koordinatensystem lässt sich nicht in Meter bringen</translation>
    </message>
    <message>
        <source>holds more than a million features: no building does</source>
        <translation>enthält mehr als eine Million Objekte: so viele hat kein Gebäude</translation>
    </message>
    <message>
        <source>has more than 500,000 features: no building has</source>
        <translation>enthält mehr als 500&#xa0;000 Objekte: so viele hat kein Gebäude</translation>
    </message>
    <message>
        <source>the shapes have no heights (z) that levels could be taken from; name a column instead</source>
        <translation>die Formen haben keine Höhen (z), denen man Ebenen entnehmen könnte; nennen Sie stattdessen eine Spalte</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through: name the folder with all layers, or say what they are in a profile</source>
        <translation>enthält keine Räume, Flure oder anderen Flächen, auf denen man gehen kann: nennen Sie den Ordner mit allen Layern, oder sagen Sie in einem Profil, was sie sind</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; %1 and what else is a door touches no region (access-joins-two-regions): name the folder with all layers, or say what they are in a profile</source>
        <translation>enthält keine Räume, Flure oder anderen Flächen, auf denen man gehen kann; %1 und was sonst eine Tür ist, berührt keine Region: nennen Sie den Ordner mit allen Layern, oder sagen Sie in einem Profil, was sie sind</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; lines alone enclose no rooms (layer-role): name the folder with all layers, or say what they are in a profile</source>
        <translation>enthält keine Räume, Flure oder anderen Flächen, auf denen man gehen kann; Linien allein umschließen keine Räume: nennen Sie den Ordner mit allen Layern, oder sagen Sie in einem Profil, was sie sind</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; there are no features in %1 (layer-empty): name the folder with all layers, or say what they are in a profile</source>
        <translation>enthält keine Räume, Flure oder anderen Flächen, auf denen man gehen kann; in %1 gibt es keine Objekte: nennen Sie den Ordner mit allen Layern, oder sagen Sie in einem Profil, was sie sind</translation>
    </message>
    <message>
        <source>is no GeoJSON FeatureCollection</source>
        <translation>ist keine GeoJSON-FeatureCollection</translation>
    </message>
    <message>
        <source>is nested deeper than any map</source>
        <translation>ist tiefer verschachtelt als jede Karte</translation>
    </message>
    <message>
        <source>is damaged JSON (%1)</source>
        <translation>ist beschädigtes JSON (%1)</translation>
    </message>
    <message>
        <source>is no JSON object with columns, codes, levels or layers</source>
        <translation>ist kein JSON-Objekt mit columns, codes, levels oder layers</translation>
    </message>
    <message>
        <source>there is no column meaning &quot;%1&quot;</source>
        <translation>es gibt keine Spalte mit der Bedeutung „%1“</translation>
    </message>
    <message>
        <source>the role of layer &quot;%1&quot; is unknown</source>
        <translation>die Rolle des Layers „%1“ ist unbekannt</translation>
    </message>
    <message>
        <source>makes more than 20,000 regions on its levels, or its ways cross too many of them: cut the building out of it</source>
        <translation>ergibt mehr als 20&#xa0;000 Regionen auf seinen Ebenen, oder seine Wege kreuzen zu viele: schneiden Sie das Gebäude heraus</translation>
    </message>
    <message>
        <source>holds no indoor areas: rooms, corridors and areas must be tagged indoor=* with a level</source>
        <translation>enthält keine Innenflächen: Räume, Flure und Flächen müssen mit indoor=* und einer Ebene ausgezeichnet sein</translation>
    </message>
    <message>
        <source>has more than 500,000 tagged features: cut the building out of it</source>
        <translation>enthält mehr als 500&#xa0;000 ausgezeichnete Objekte: schneiden Sie das Gebäude heraus</translation>
    </message>
    <message>
        <source>is damaged OpenStreetMap data</source>
        <translation>ist eine beschädigte OpenStreetMap-Datei</translation>
    </message>
    <message>
        <source>cannot be read as OpenStreetMap data</source>
        <translation>lässt sich nicht als OpenStreetMap-Daten lesen</translation>
    </message>
    <message>
        <source>holds no OpenStreetMap file (.osm, .osm.pbf or GeoJSON made of one)</source>
        <translation>enthält keine OpenStreetMap-Datei (.osm, .osm.pbf oder daraus gemachtes GeoJSON)</translation>
    </message>
    <message>
        <source>holds no unit.geojson: name the folder or zip of an IMDF venue</source>
        <translation>enthält kein unit.geojson: nennen Sie den Ordner oder das Zip einer IMDF-Karte</translation>
    </message>
    <message>
        <source>holds %1 IMDF venues: name the folder of one of them, such as %2</source>
        <translation>enthält %1 IMDF-Karten: nennen Sie den Ordner einer davon, etwa %2</translation>
    </message>
    <message>
        <source>has more than 20,000 nodes or facilities or 50,000 links: cut the building out of it</source>
        <translation>enthält mehr als 20&#xa0;000 Knoten oder Einrichtungen oder 50&#xa0;000 Verbindungen: schneiden Sie das Gebäude heraus</translation>
    </message>
    <message>
        <source>holds no node of a route network with a place</source>
        <translation>enthält keinen Knoten eines Wegenetzes mit einem Ort</translation>
    </message>
    <message>
        <source>has more than 200,000 features</source>
        <translation>enthält mehr als 200&#xa0;000 Objekte</translation>
    </message>
    <message>
        <source>is XML, but not IndoorGML (IndoorFeatures)</source>
        <translation>ist XML, aber kein IndoorGML (IndoorFeatures)</translation>
    </message>
    <message>
        <source>has more than 50,000 cells</source>
        <translation>enthält mehr als 50&#xa0;000 Zellen</translation>
    </message>
    <message>
        <source>has no cell with a usable outline: Farol needs CellSpace geometry</source>
        <translation>hat keine Zelle mit brauchbarem Umriss: Farol braucht die Geometrie von CellSpace</translation>
    </message>
    <message>
        <source>has no cells but doors: rooms and corridors are missing</source>
        <translation>hat nur Zellen von Türen: Räume und Flure fehlen</translation>
    </message>
    <message>
        <source>holds no IndoorGML file</source>
        <translation>enthält keine IndoorGML-Datei</translation>
    </message>
    <message>
        <source>is damaged XML: %1</source>
        <translation>ist beschädigtes XML: %1</translation>
    </message>
    <message>
        <source>has more than two million elements</source>
        <translation>enthält mehr als zwei Millionen Elemente</translation>
    </message>
    <message>
        <source>is nested deeper than 100 elements</source>
        <translation>ist über mehr als 100 Elemente verschachtelt</translation>
    </message>
    <message>
        <source>declares entities, which no map needs</source>
        <translation>erklärt Entitäten, die keine Karte braucht</translation>
    </message>
    <message>
        <source>lists no levels, as main.json of a WRLD map does</source>
        <translation>listet keine Ebenen auf, wie es das main.json einer WRLD-Karte tut</translation>
    </message>
    <message>
        <source>lists more than 300 levels</source>
        <translation>listet mehr als 300 Ebenen auf</translation>
    </message>
    <message>
        <source>a level has no z_order of its own</source>
        <translation>eine Ebene hat kein eigenes z_order</translation>
    </message>
    <message>
        <source>no floor has a room or an outline with walls</source>
        <translation>kein Stockwerk hat einen Raum oder einen Umriss mit Wänden</translation>
    </message>
    <message>
        <source>the floor&apos;s file &quot;%1&quot; is missing: import the folder or zip that holds it</source>
        <translation>die Datei des Stockwerks, „%1“, fehlt: importieren Sie den Ordner oder das Zip, das sie enthält</translation>
    </message>
    <message>
        <source>has more than 10,000 features on a floor or 40,000 in all: no building has</source>
        <translation>enthält mehr als 10&#xa0;000 Objekte auf einem Stockwerk oder 40&#xa0;000 insgesamt: so viele hat kein Gebäude</translation>
    </message>
    <message>
        <source>holds no main.json: name the folder or zip of the WRLD map</source>
        <translation>enthält kein main.json: nennen Sie den Ordner oder das Zip der WRLD-Karte</translation>
    </message>
    <message>
        <source>is damaged (%1)</source>
        <translation>ist beschädigt (%1)</translation>
    </message>
    <message>
        <source>the region has no outline</source>
        <translation>die Region hat keinen Umriss</translation>
    </message>
    <message>
        <source>the access has no place on the map</source>
        <translation>der Durchgang hat keinen Ort auf der Karte</translation>
    </message>
    <message>
        <source>both sides are the same region: choose another one</source>
        <translation>beide Seiten sind dieselbe Region: wählen Sie eine andere</translation>
    </message>
    <message>
        <source>the width must be above 0 m, and the steps 0 or more</source>
        <translation>die Breite muss über 0&#xa0;m liegen, die Stufen bei 0 oder mehr</translation>
    </message>
    <message>
        <source>the landmark has no place on the map</source>
        <translation>die Landmarke hat keinen Ort auf der Karte</translation>
    </message>
    <message>
        <source>the width and the height of the object must be above 0 m</source>
        <translation>Breite und Höhe des Gegenstands müssen über 0&#xa0;m liegen</translation>
    </message>
    <message>
        <source>the map has this name already</source>
        <translation>die Karte hat diesen Namen schon</translation>
    </message>
    <message>
        <source>the map does not hold it any more</source>
        <translation>die Karte enthält es nicht mehr</translation>
    </message>
    <message>
        <source>the map there is of a later Farol; save under another name or use the newer Farol</source>
        <translation>die Karte dort ist von einem späteren Farol; speichern Sie unter einem anderen Namen, oder benutzen Sie das neuere Farol</translation>
    </message>
    <message>
        <source>is another kind of file; save under a name that ends in .gpkg</source>
        <translation>ist eine andere Art von Datei; speichern Sie unter einem Namen, der auf .gpkg endet</translation>
    </message>
    <message>
        <source>another program has the file open and writes to it; close it there and save again</source>
        <translation>ein anderes Programm hat die Datei offen und schreibt hinein; schließen Sie sie dort, und speichern Sie noch einmal</translation>
    </message>
    <message>
        <source>the disk is full: free some space and save again; what was there before is untouched</source>
        <translation>die Platte ist voll: schaffen Sie Platz, und speichern Sie noch einmal; was vorher da war, ist unberührt</translation>
    </message>
    <message>
        <source>the map was changed by someone else since it was read; nothing was written: read it again and repeat the change</source>
        <translation>jemand anderes hat die Karte geändert, seit sie gelesen wurde; nichts wurde geschrieben: lesen Sie sie neu, und wiederholen Sie die Änderung</translation>
    </message>
    <message>
        <source>there is no field level; level 0 is assumed</source>
        <translation>das Feld level fehlt; Ebene 0 wird angenommen</translation>
    </message>
    <message>
        <source>there is no layer %1</source>
        <translation>der Layer %1 fehlt</translation>
    </message>
    <message>
        <source>%1 do not join two regions and are not walked through: %2</source>
        <translation>%1 verbinden nicht zwei Regionen, und niemand wird hindurchgeführt: %2</translation>
    </message>
    <message>
        <source>unknown kind &quot;%1&quot;, treated as other: %2</source>
        <translation>unbekannte Art „%1“, als sonstige behandelt: %2</translation>
    </message>
    <message>
        <source>no kind, treated as other: %1</source>
        <translation>ohne Art, als sonstige behandelt: %1</translation>
    </message>
    <message>
        <source>a place is empty: give a region&apos;s id, name or ref, or x,y,level</source>
        <translation>der Ort ist leer: nennen Sie Kennung, Namen oder Nummer einer Region, oder x,y,Ebene</translation>
    </message>
    <message>
        <source>no region of level %1 holds this point</source>
        <translation>keine Region der Ebene %1 enthält diesen Punkt</translation>
    </message>
    <message>
        <source>several regions are called so: %1; give one of these ids</source>
        <translation>mehrere Regionen heißen so: %1; nennen Sie eine dieser Kennungen</translation>
    </message>
    <message>
        <source>no region has this id, name or ref</source>
        <translation>keine Region hat diese Kennung, diesen Namen oder diese Nummer</translation>
    </message>
    <message>
        <source>no region has this id, name or ref; near spellings: %1</source>
        <translation>keine Region hat diese Kennung, diesen Namen oder diese Nummer; ähnlich: %1</translation>
    </message>
    <message>
        <source>%1 (level %2)</source>
        <translation>%1 (Ebene %2)</translation>
    </message>
    <message>
        <source>the map has no region &quot;%1&quot;</source>
        <translation>die Karte hat keine Region „%1“</translation>
    </message>
    <message>
        <source>the position is no number</source>
        <translation>die Position ist keine Zahl</translation>
    </message>
    <message>
        <source>is out of its range</source>
        <translation>liegt außerhalb seines Bereichs</translation>
    </message>
    <message>
        <source>has an outline that is none</source>
        <translation>hat einen Umriss, der keiner ist</translation>
    </message>
    <message>
        <source>has no position</source>
        <translation>hat keine Position</translation>
    </message>
    <message>
        <source>a wall has no length</source>
        <translation>eine Wand hat keine Länge</translation>
    </message>
    <message>
        <source>the map cannot be written there</source>
        <translation>die Karte lässt sich dort nicht schreiben</translation>
    </message>
    <message>
        <source>cannot be copied before saving</source>
        <translation>lässt sich vor dem Speichern nicht kopieren</translation>
    </message>
    <message>
        <source>writing the map failed: %1</source>
        <translation>das Schreiben der Karte ist gescheitert: %1</translation>
    </message>
    <message>
        <source>the map may not be changed now: someone else is changing it, or the user has no right to; nothing was written, save again in a moment</source>
        <translation>die Karte darf jetzt nicht geändert werden: jemand anders ändert sie gerade, oder der Benutzer hat kein Recht dazu; nichts wurde geschrieben, speichern Sie gleich noch einmal</translation>
    </message>
    <message>
        <source>the database has no PostGIS: ask its administrator to add that extension</source>
        <translation>die Datenbank hat kein PostGIS: bitten Sie die Verwaltung, diese Erweiterung einzurichten</translation>
    </message>
    <message>
        <source>this is no picture that can be read; use PNG, JPEG or GeoTIFF</source>
        <translation>das ist kein lesbares Bild; nehmen Sie PNG, JPEG oder GeoTIFF</translation>
    </message>
    <message>
        <source>the picture is damaged: save it anew</source>
        <translation>das Bild ist beschädigt: speichern Sie es neu</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>das Dateisystem ist schreibgeschützt</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>auf der Platte ist kein Platz mehr</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Fehler beim Lesen oder Schreiben</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>es ist kein Ordner</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>der Dateiname ist zu lang</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>das ist nicht erlaubt</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele Dateien sind offen</translation>
    </message>
    <message>
        <source>cannot be read as a picture</source>
        <translation>lässt sich nicht als Bild lesen</translation>
    </message>
    <message>
        <source>no source was named: give camera:0, a video file, a folder of pictures or an address</source>
        <translation>es wurde keine Quelle genannt: geben Sie camera:0, eine Videodatei, einen Ordner mit Bildern oder eine Adresse an</translation>
    </message>
    <message>
        <source>there is no such file or folder (a source is camera:0, a video file, a folder of pictures, or an http or rtsp address)</source>
        <translation>diese Datei oder diesen Ordner gibt es nicht (eine Quelle ist camera:0, eine Videodatei, ein Ordner mit Bildern oder eine Adresse mit http oder rtsp)</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>der Ordner lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>there are no pictures in this folder (jpg, png, bmp, webp or tif)</source>
        <translation>in diesem Ordner sind keine Bilder (jpg, png, bmp, webp oder tif)</translation>
    </message>
    <message>
        <source>is neither a picture nor a video that can be opened (tried FFmpeg and GStreamer)</source>
        <translation>ist weder ein Bild noch ein Video, das sich öffnen lässt (versucht mit FFmpeg und GStreamer)</translation>
    </message>
    <message>
        <source>the address does not answer with a video within %1 s (tried FFmpeg): is the camera on, and the address right?</source>
        <translation>die Adresse antwortet nicht binnen %1 s mit einem Video (versucht mit FFmpeg): ist die Kamera an, und stimmt die Adresse?</translation>
    </message>
    <message>
        <source>a camera is named by its number or its device, such as camera:0</source>
        <translation>eine Kamera nennt man mit ihrer Nummer oder ihrem Gerät, wie camera:0</translation>
    </message>
    <message>
        <source>the camera cannot be opened (tried Video4Linux at %1): is it plugged in, and not in use by another program?</source>
        <translation>die Kamera lässt sich nicht öffnen (versucht mit Video4Linux an %1): ist sie angeschlossen, und benutzt sie kein anderes Programm?</translation>
    </message>
    <message>
        <source>%1 delivers no more pictures</source>
        <translation>%1 liefert keine Bilder mehr</translation>
    </message>
    <message>
        <source>%1 gives no more pictures</source>
        <translation>%1 gibt keine Bilder mehr</translation>
    </message>
    <message>
        <source>%1 is tried again (attempt %2)</source>
        <translation>%1 wird noch einmal versucht (Versuch %2)</translation>
    </message>
    <message>
        <source>%1 is back</source>
        <translation>%1 ist wieder da</translation>
    </message>
    <message>
        <source>%1 broke down: %2</source>
        <translation>%1 ist ausgefallen: %2</translation>
    </message>
    <message>
        <source>the library&apos;s version is not a number: &quot;%1&quot;</source>
        <translation>die Version der Bibliothek ist keine Zahl: „%1“</translation>
    </message>
    <message>
        <source>the landmark library is of a later version (%1) than this program knows (%2); update Farol</source>
        <translation>die Landmarkenbibliothek hat eine spätere Version (%1), als dieses Programm kennt (%2); bringen Sie Farol auf den neuesten Stand</translation>
    </message>
    <message>
        <source>holds no landmark library (no layers templates and views)</source>
        <translation>enthält keine Landmarkenbibliothek (keine Layer templates und views)</translation>
    </message>
    <message>
        <source>the landmark library cannot be read</source>
        <translation>die Landmarkenbibliothek lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>cannot save the library: %1</source>
        <translation>die Bibliothek lässt sich nicht speichern: %1</translation>
    </message>
    <message>
        <source>is not a GeoPackage, and a library is kept in one (*.gpkg)</source>
        <translation>ist kein GeoPackage, und eine Bibliothek liegt in einem solchen (*.gpkg)</translation>
    </message>
    <message>
        <source>a template has no name</source>
        <translation>eine Landmarke hat keinen Namen</translation>
    </message>
    <message>
        <source>template %1 stands twice</source>
        <translation>die Landmarke %1 steht zweimal da</translation>
    </message>
    <message>
        <source>a view belongs to a template that is not in the library</source>
        <translation>ein Foto gehört zu einer Landmarke, die nicht in der Bibliothek ist</translation>
    </message>
    <message>
        <source>the photograph or its outline is missing</source>
        <translation>das Foto oder sein Umriss fehlt</translation>
    </message>
    <message>
        <source>the extractor&apos;s parameters cannot be read: &quot;%1&quot;</source>
        <translation>die Einstellungen des Merkmalverfahrens lassen sich nicht lesen: „%1“</translation>
    </message>
    <message>
        <source>the library was trained with %1, but %2; train it again from its photographs</source>
        <translation>die Bibliothek wurde mit %1 angelernt, aber: %2; lernen Sie sie aus ihren Fotos neu an</translation>
    </message>
    <message>
        <source>the library was trained with %1, but %2 is in use; train it again from its photographs, or choose its own extractor</source>
        <translation>die Bibliothek wurde mit %1 angelernt, benutzt wird aber %2; lernen Sie sie aus ihren Fotos neu an, oder wählen Sie ihr eigenes Merkmalverfahren</translation>
    </message>
    <message>
        <source>there is no feature extractor &quot;%1&quot;; there are %2</source>
        <translation>es gibt kein Merkmalverfahren „%1“; es gibt %2</translation>
    </message>
    <message>
        <source>version %1 of %2 is not known, only %3</source>
        <translation>die Version %1 von %2 ist nicht bekannt, nur %3</translation>
    </message>
    <message>
        <source>the working size must be between 64 and 4096 pixels</source>
        <translation>die Arbeitsgröße muss zwischen 64 und 4096 Pixeln liegen</translation>
    </message>
    <message>
        <source>the number of keypoints must be between 10 and 20000</source>
        <translation>die Zahl der Merkmalspunkte muss zwischen 10 und 20000 liegen</translation>
    </message>
    <message>
        <source>the contrast threshold must be between 0 and 1</source>
        <translation>die Kontrastschwelle muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>%1; the library is damaged: restore it or train this view again</source>
        <translation>%1; die Bibliothek ist beschädigt: stellen Sie sie wieder her, oder lernen Sie dieses Foto neu an</translation>
    </message>
    <message>
        <source>the outline &quot;%1&quot; is not eight numbers</source>
        <translation>der Umriss „%1“ besteht nicht aus acht Zahlen</translation>
    </message>
    <message>
        <source>the descriptors are not of the width that %1 makes</source>
        <translation>die Deskriptoren haben nicht die Breite, die %1 erzeugt</translation>
    </message>
    <message>
        <source>the photograph&apos;s size is missing</source>
        <translation>die Größe des Fotos fehlt</translation>
    </message>
    <message>
        <source>the checksum does not fit the photograph and its features</source>
        <translation>die Prüfsumme passt nicht zum Foto und seinen Merkmalen</translation>
    </message>
    <message>
        <source>the keypoints do not begin as they should</source>
        <translation>die Merkmalspunkte fangen nicht so an, wie sie sollen</translation>
    </message>
    <message>
        <source>the keypoints have an impossible size</source>
        <translation>die Merkmalspunkte haben eine unmögliche Größe</translation>
    </message>
    <message>
        <source>the keypoints are cut off or too long</source>
        <translation>die Merkmalspunkte sind abgeschnitten oder zu lang</translation>
    </message>
    <message>
        <source>the keypoints are of another kind</source>
        <translation>die Merkmalspunkte sind von anderer Art</translation>
    </message>
    <message>
        <source>a keypoint has an impossible value</source>
        <translation>ein Merkmalspunkt hat einen unmöglichen Wert</translation>
    </message>
    <message>
        <source>the descriptors do not begin as they should</source>
        <translation>die Deskriptoren fangen nicht so an, wie sie sollen</translation>
    </message>
    <message>
        <source>the descriptors have an impossible size</source>
        <translation>die Deskriptoren haben eine unmögliche Größe</translation>
    </message>
    <message>
        <source>the descriptors are cut off or too long</source>
        <translation>die Deskriptoren sind abgeschnitten oder zu lang</translation>
    </message>
    <message>
        <source>the descriptors are of another kind</source>
        <translation>die Deskriptoren sind von anderer Art</translation>
    </message>
    <message>
        <source>there are not as many descriptors as keypoints</source>
        <translation>es gibt nicht so viele Deskriptoren wie Merkmalspunkte</translation>
    </message>
    <message>
        <source>cannot replace the layer</source>
        <translation>der Layer lässt sich nicht ersetzen</translation>
    </message>
    <message>
        <source>cannot make the layer</source>
        <translation>der Layer lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>cannot make the field %1</source>
        <translation>das Feld %1 lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>cannot replace the version</source>
        <translation>die Version lässt sich nicht ersetzen</translation>
    </message>
    <message>
        <source>the layer has no fields key and value: this is not one of Farol&apos;s files</source>
        <translation>der Layer hat keine Felder key und value: das ist keine Datei von Farol</translation>
    </message>
    <message>
        <source>no view is chosen</source>
        <translation>es ist kein Foto gewählt</translation>
    </message>
    <message>
        <source>a template needs at least one view; delete it instead</source>
        <translation>eine Landmarke braucht mindestens ein Foto; löschen Sie sie stattdessen</translation>
    </message>
    <message>
        <source>a template needs a name of its own</source>
        <translation>eine Landmarke braucht einen eigenen Namen</translation>
    </message>
    <message>
        <source>this name is taken by another template</source>
        <translation>diesen Namen hat schon eine andere Landmarke</translation>
    </message>
    <message>
        <source>a template needs at least one view</source>
        <translation>eine Landmarke braucht mindestens ein Foto</translation>
    </message>
    <message>
        <source>a real size must be a positive number of metres</source>
        <translation>eine wirkliche Größe muss eine positive Zahl von Metern sein</translation>
    </message>
    <message>
        <source>a template cannot be merged with itself</source>
        <translation>eine Landmarke lässt sich nicht mit sich selbst vereinen</translation>
    </message>
    <message>
        <source>a place and an object cannot be one template; choose two of the same sort</source>
        <translation>ein Ort und ein Gegenstand können nicht eine Landmarke sein; wählen Sie zwei derselben Art</translation>
    </message>
    <message>
        <source>the outline has a corner that is no number</source>
        <translation>der Umriss hat eine Ecke, die keine Zahl ist</translation>
    </message>
    <message>
        <source>the outline leaves the picture, which is %1 x %2 pixels</source>
        <translation>der Umriss ragt aus dem Bild, das %1 x %2 Pixel hat</translation>
    </message>
    <message>
        <source>the outline&apos;s four corners must follow the object&apos;s border clockwise from its top left, without crossing</source>
        <translation>die vier Ecken des Umrisses müssen dem Rand des Gegenstands im Uhrzeigersinn von links oben an folgen, ohne sich zu kreuzen</translation>
    </message>
    <message>
        <source>the outline&apos;s corners run counter-clockwise; give them clockwise from the object&apos;s top left</source>
        <translation>die Ecken des Umrisses laufen gegen den Uhrzeigersinn; geben Sie sie im Uhrzeigersinn von links oben am Gegenstand an</translation>
    </message>
    <message>
        <source>the outline is only %1 x %2 pixels; photograph the object from nearer</source>
        <translation>der Umriss hat nur %1 x %2 Pixel; fotografieren Sie den Gegenstand aus größerer Nähe</translation>
    </message>
    <message>
        <source>a template needs a name</source>
        <translation>eine Landmarke braucht einen Namen</translation>
    </message>
    <message>
        <source>this template is of kind %1, not %2; use another template name</source>
        <translation>diese Landmarke ist von der Art %1, nicht %2; nehmen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>only %1 features were found in the picture; at least %2 are needed: take a sharp, well lit photograph of something with detail, from nearer</source>
        <translation>nur %1 Merkmale wurden im Bild gefunden; nötig sind mindestens %2: machen Sie aus größerer Nähe ein scharfes, gut beleuchtetes Foto von etwas mit Einzelheiten</translation>
    </message>
    <message>
        <source>only %1 features were found inside the outline; at least %2 are needed: take a sharp, well lit photograph of something with detail, from nearer</source>
        <translation>nur %1 Merkmale wurden im Umriss gefunden; nötig sind mindestens %2: machen Sie aus größerer Nähe ein scharfes, gut beleuchtetes Foto von etwas mit Einzelheiten</translation>
    </message>
    <message>
        <source>the photograph cannot be read as a picture</source>
        <translation>das Foto lässt sich nicht als Bild lesen</translation>
    </message>
    <message>
        <source>the photograph cannot be used: %1</source>
        <translation>das Foto lässt sich nicht verwenden: %1</translation>
    </message>
    <message>
        <source>template %1</source>
        <translation>Landmarke %1</translation>
    </message>
    <message>
        <source>%1, template %2</source>
        <translation>%1, Landmarke %2</translation>
    </message>
    <message>
        <source>%1, view %2</source>
        <translation>%1, Foto %2</translation>
    </message>
    <message>
        <source>%1, a view of template %2</source>
        <translation>%1, ein Foto der Landmarke %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>cannot reopen for writing</source>
        <translation>lässt sich nicht noch einmal zum Schreiben öffnen</translation>
    </message>
    <message>
        <source>cannot write to disk</source>
        <translation>lässt sich nicht auf die Platte schreiben</translation>
    </message>
    <message>
        <source>cannot copy before saving</source>
        <translation>die Kopie vor dem Speichern gelingt nicht</translation>
    </message>
    <message>
        <source>cannot put the new file in place</source>
        <translation>die neue Datei lässt sich nicht an ihre Stelle setzen</translation>
    </message>
    <message>
        <source>is no ordinary file; name another one</source>
        <translation>ist keine gewöhnliche Datei; nennen Sie eine andere</translation>
    </message>
    <message>
        <source>cannot open</source>
        <translation>das Öffnen gelingt nicht</translation>
    </message>
    <message>
        <source>cannot read</source>
        <translation>das Lesen gelingt nicht</translation>
    </message>
    <message>
        <source>cannot write</source>
        <translation>das Schreiben gelingt nicht</translation>
    </message>
    <message>
        <source>cannot begin to write</source>
        <translation>das Schreiben kann nicht beginnen</translation>
    </message>
    <message>
        <source>cannot finish writing</source>
        <translation>das Schreiben kommt nicht zu Ende</translation>
    </message>
    <message>
        <source>cannot create the file</source>
        <translation>die Datei lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>this GDAL has no GeoPackage driver</source>
        <translation>dieses GDAL hat keinen Treiber für GeoPackage</translation>
    </message>
    <message>
        <source>the connection cannot be understood: write PG: and then key=value pairs such as dbname=campus host=maps user=anna, values with blanks in single quotes</source>
        <translation>die Verbindung wird nicht verstanden: schreiben Sie PG: und dann Paare aus Schlüssel=Wert wie dbname=campus host=maps user=anna, Werte mit Leerzeichen in einfachen Anführungszeichen</translation>
    </message>
    <message>
        <source>%1; skipped (%2 so far)</source>
        <translation>%1; übersprungen (bisher %2)</translation>
    </message>
    <message>
        <source>%1 cannot be read as a picture</source>
        <translation>%1 lässt sich nicht als Bild lesen</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>is not a recording: it holds no recording.json</source>
        <translation>ist keine Aufnahme: darin fehlt recording.json</translation>
    </message>
    <message>
        <source>is not JSON</source>
        <translation>ist kein JSON</translation>
    </message>
    <message>
        <source>is not the header of a recording</source>
        <translation>ist nicht der Kopf einer Aufnahme</translation>
    </message>
    <message>
        <source>was made by a later version of Farol (recording format %1, this program reads up to %2)</source>
        <translation>wurde von einer späteren Version von Farol gemacht (Aufnahmeformat %1, dieses Programm liest bis %2)</translation>
    </message>
    <message>
        <source>is neither a percept nor a command</source>
        <translation>ist weder eine Beobachtung noch ein Befehl</translation>
    </message>
    <message>
        <source>is a file; a new or empty folder is wanted for a recording</source>
        <translation>ist eine Datei; für eine Aufnahme ist ein neuer oder leerer Ordner verlangt</translation>
    </message>
    <message>
        <source>is not empty; choose a new folder, so that no recording is overwritten</source>
        <translation>ist nicht leer; wählen Sie einen neuen Ordner, damit keine Aufnahme überschrieben wird</translation>
    </message>
    <message>
        <source>cannot create</source>
        <translation>lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>cannot create the recording</source>
        <translation>die Aufnahme lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>cannot encode the picture</source>
        <translation>das Bild lässt sich nicht kodieren</translation>
    </message>
    <message>
        <source>the recording stopped (%1); the walk goes on</source>
        <translation>die Aufnahme ist stehengeblieben (%1); der Gang geht weiter</translation>
    </message>
    <message>
        <source>the walk broke off: %1</source>
        <translation>der Gang ist abgebrochen: %1</translation>
    </message>
    <message>
        <source>frame %1 could not be looked at: %2</source>
        <translation>Bild %1 ließ sich nicht ansehen: %2</translation>
    </message>
    <message>
        <source>there is no source of pictures; open one first</source>
        <translation>es gibt keine Quelle von Bildern; öffnen Sie zuerst eine</translation>
    </message>
    <message>
        <source>there is no map; open one first</source>
        <translation>es gibt keine Karte; öffnen Sie zuerst eine</translation>
    </message>
</context>
<context>
    <name>farol::Options</name>
    <message>
        <source>%1 needs a number above 0, not “%2”</source>
        <translation>%1 braucht eine Zahl über 0, nicht „%2“</translation>
    </message>
    <message>
        <source>%1 needs a size such as 1280x800, not “%2”</source>
        <translation>%1 braucht eine Größe wie 1280x800, nicht „%2“</translation>
    </message>
    <message>
        <source>“%1” is not known; see --help</source>
        <translation>„%1“ ist nicht bekannt; siehe --help</translation>
    </message>
</context>
<context>
    <name>farol::espeak</name>
    <message>
        <source>The data of the voice are missing: install espeak-ng-data.</source>
        <translation>Die Daten der Stimme fehlen: Installieren Sie espeak-ng-data.</translation>
    </message>
    <message>
        <source>There is no sound device.</source>
        <translation>Es gibt kein Audiogerät.</translation>
    </message>
    <message>
        <source>The sound device cannot play speech: choose another one.</source>
        <translation>Das Audiogerät kann keine Sprache ausgeben: Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>The sound device does not start.</source>
        <translation>Das Audiogerät startet nicht.</translation>
    </message>
    <message>
        <source>The sound device stopped in the middle of a text.</source>
        <translation>Das Audiogerät hat mitten im Text aufgehört.</translation>
    </message>
    <message>
        <source>The voice cannot be loaded: choose another one.</source>
        <translation>Die Stimme lässt sich nicht laden: Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>The text could not be turned into sound.</source>
        <translation>Der Text konnte nicht in Ton umgewandelt werden.</translation>
    </message>
</context>
<context>
    <name>farol::ui::AccessDialog</name>
    <message>
        <source>Door or passage %1</source>
        <translation>Tür oder Durchgang %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What sort of passage it is</source>
        <translation>Was für ein Durchgang es ist</translation>
    </message>
    <message>
        <source>Type part of a name, room number or level, then choose</source>
        <translation>Tippen Sie einen Teil eines Namens, einer Raumnummer oder Ebene und wählen Sie</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Eine Seite</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>in beide Richtungen</translation>
    </message>
    <message>
        <source>from the one side to the other only</source>
        <translation>nur von der einen Seite zur anderen</translation>
    </message>
    <message>
        <source>from the other side to the one only</source>
        <translation>nur von der anderen Seite zur einen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Which way one can pass</source>
        <translation>In welche Richtung man durchgehen kann</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>How wide the door is</source>
        <translation>Wie breit die Tür ist</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>How many steps the stairs have</source>
        <translation>Wie viele Stufen die Treppe hat</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Ost</translation>
    </message>
    <message>
        <source>Place on the map, metres to the east</source>
        <translation>Ort auf der Karte, Meter nach Osten</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>Place on the map, metres to the north</source>
        <translation>Ort auf der Karte, Meter nach Norden</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Nobody can pass</source>
        <translation>Niemand kann durchgehen</translation>
    </message>
</context>
<context>
    <name>farol::ui::Banner</name>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Achtung</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>farol::ui::ConfusionModel</name>
    <message>
        <source>%1/%2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1: found in %2 of %3 views</source>
        <translation>%1: in %2 von %3 Ansichten gefunden</translation>
    </message>
    <message numerus="yes">
        <source>%1 taken for %2: %n time(s)</source>
        <translation>
            <numerusform>%1 für %2 gehalten: einmal</numerusform>
            <numerusform>%1 für %2 gehalten: %n-mal</numerusform>
        </translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
</context>
<context>
    <name>farol::ui::DemoBar</name>
    <message>
        <source>Visitor %1 arrived at %2 after %3. The next one comes in a moment.</source>
        <translation>Besucher %1 ist nach %3 bei %2 angekommen. Der nächste kommt gleich.</translation>
    </message>
    <message>
        <source>Visitor %1 did not come to %2 and was fetched. The next one comes in a moment.</source>
        <translation>Besucher %1 kam nicht zu %2 und wurde abgeholt. Der nächste kommt gleich.</translation>
    </message>
    <message>
        <source>A simulated building and camera. Visitor %1 wants to go from %2 to %3 (%4 m) and hears only what is said. Choose another destination at any time.</source>
        <translation>Ein simuliertes Gebäude mit simulierter Kamera. Besucher %1 will von %2 zu %3 (%4 m) und hört nur, was gesagt wird. Ein anderes Ziel kann jederzeit gewählt werden.</translation>
    </message>
    <message>
        <source>&amp;Demo</source>
        <translation>V&amp;orführung</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Vorführung</translation>
    </message>
    <message>
        <source>&amp;Wrong turn</source>
        <translation>&amp;Falsch abbiegen</translation>
    </message>
    <message>
        <source>Wrong turn</source>
        <translation>Falsch abbiegen</translation>
    </message>
    <message>
        <source>The walker takes another way than was said</source>
        <translation>Der Besucher geht einen anderen Weg als gesagt</translation>
    </message>
    <message>
        <source>&amp;Cover the camera</source>
        <translation>Kamera ver&amp;decken</translation>
    </message>
    <message>
        <source>Cover camera</source>
        <translation>Kamera verdecken</translation>
    </message>
    <message>
        <source>A hand lies on the simulated camera</source>
        <translation>Eine Hand liegt auf der simulierten Kamera</translation>
    </message>
    <message>
        <source>&amp;Lights out</source>
        <translation>&amp;Licht aus</translation>
    </message>
    <message>
        <source>Lights out</source>
        <translation>Licht aus</translation>
    </message>
    <message>
        <source>Nearly dark in the whole building</source>
        <translation>Fast dunkel im ganzen Gebäude</translation>
    </message>
    <message>
        <source>&amp;Next visitor</source>
        <translation>&amp;Nächster Besucher</translation>
    </message>
    <message>
        <source>Next visitor</source>
        <translation>Nächster Besucher</translation>
    </message>
    <message>
        <source>End this walk; somebody else comes with another destination</source>
        <translation>Diese Begehung beenden; jemand anders kommt mit einem anderen Ziel</translation>
    </message>
</context>
<context>
    <name>farol::ui::DetectionModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not accepted</source>
        <translation>nicht angenommen</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Übereinstimmung</translation>
    </message>
</context>
<context>
    <name>farol::ui::DraftStore</name>
    <message>
        <source>what you are teaching cannot be kept on disk (%1); it would be lost with the program</source>
        <translation>was Sie gerade lehren, lässt sich nicht auf der Platte festhalten (%1); es ginge mit dem Programm verloren</translation>
    </message>
    <message>
        <source>the folder for what you are teaching cannot be made; it would be lost with the program</source>
        <translation>der Ordner für das, was Sie gerade lehren, lässt sich nicht anlegen; es ginge mit dem Programm verloren</translation>
    </message>
</context>
<context>
    <name>farol::ui::EditTemplateDialog</name>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What people call it</source>
        <translation>Wie die Leute es nennen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>Real width</source>
        <translation>Wirkliche Breite</translation>
    </message>
    <message>
        <source>Lets Farol tell how far away it is</source>
        <translation>Daraus weiß Farol, wie weit es weg ist</translation>
    </message>
    <message>
        <source>Real height</source>
        <translation>Wirkliche Höhe</translation>
    </message>
    <message>
        <source>In maps called</source>
        <translation>In Karten genannt</translation>
    </message>
    <message>
        <source>Landmarks of the map refer to it by this word: when it changes, change them too</source>
        <translation>Landmarken der Karte nennen es mit diesem Wort: Ändert es sich, ändern Sie auch diese</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeatureDialog</name>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeatureModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Area (m²)</source>
        <translation>Fläche (m²)</translation>
    </message>
    <message>
        <source>Doors</source>
        <translation>Türen</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Restricted</source>
        <translation>Eingeschränkt</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Eine Seite</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Width (m)</source>
        <translation>Breite (m)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>One way</source>
        <translation>Einbahn</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Schacht</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Faces (°)</source>
        <translation>Blickrichtung (°)</translation>
    </message>
    <message>
        <source>Height (m)</source>
        <translation>Höhe (m)</translation>
    </message>
    <message>
        <source>Wide (m)</source>
        <translation>Eigene Breite (m)</translation>
    </message>
    <message>
        <source>Tall (m)</source>
        <translation>Eigene Höhe (m)</translation>
    </message>
    <message>
        <source>Trained as</source>
        <translation>Gelernt als</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeaturePanel</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>eine Zeile</numerusform>
            <numerusform>%n Zeilen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n row(s)</source>
        <translation>
            <numerusform>%1 von einer Zeile</numerusform>
            <numerusform>%1 von %n Zeilen</numerusform>
        </translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regionen</translation>
    </message>
    <message>
        <source>Doors and passages</source>
        <translation>Türen und Durchgänge</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>What the table lists</source>
        <translation>Was die Tabelle zeigt</translation>
    </message>
    <message>
        <source>Search the table</source>
        <translation>Die Tabelle durchsuchen</translation>
    </message>
    <message>
        <source>Rows that hold every word typed (Ctrl+F)</source>
        <translation>Zeilen mit allen getippten Wörtern (Strg+F)</translation>
    </message>
    <message>
        <source>This level onl&amp;y</source>
        <translation>Nur diese &amp;Ebene</translation>
    </message>
    <message>
        <source>This level only</source>
        <translation>Nur diese Ebene</translation>
    </message>
    <message>
        <source>List only what is on the level that the plan shows</source>
        <translation>Nur zeigen, was auf der Ebene des Plans liegt</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Attribute</translation>
    </message>
    <message>
        <source>Choose a row to see it on the plan; press Enter to change it</source>
        <translation>Wählen Sie eine Zeile, um sie auf dem Plan zu sehen; drücken Sie Eingabe, um sie zu ändern</translation>
    </message>
    <message>
        <source>No row has what is looked for.</source>
        <translation>Keine Zeile enthält, was gesucht wird.</translation>
    </message>
    <message>
        <source>The map has none of these.</source>
        <translation>Die Karte hat nichts davon.</translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>Es ist keine Karte geöffnet.</translation>
    </message>
</context>
<context>
    <name>farol::ui::Figures</name>
    <message>
        <source>Votes over time</source>
        <translation>Stimmen im Lauf der Zeit</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>votes</source>
        <translation>Stimmen</translation>
    </message>
    <message>
        <source>Start a walk first.</source>
        <translation>Beginnen Sie zuerst eine Begehung.</translation>
    </message>
    <message>
        <source>How long pictures took to understand</source>
        <translation>Wie lange Bilder zum Verstehen brauchten</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>Millisekunden</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>How sure, and how right</source>
        <translation>Wie sicher, und wie richtig</translation>
    </message>
    <message>
        <source>told confidence</source>
        <translation>genannte Sicherheit</translation>
    </message>
    <message>
        <source>share that was right</source>
        <translation>richtiger Anteil</translation>
    </message>
    <message>
        <source>The truth is known in simulated walks only: start the demonstration.</source>
        <translation>Die Wahrheit ist nur bei simulierten Begehungen bekannt: Starten Sie die Vorführung.</translation>
    </message>
    <message>
        <source>this walk</source>
        <translation>diese Begehung</translation>
    </message>
    <message>
        <source>From how far each landmark is found</source>
        <translation>Aus welcher Entfernung jede Landmarke gefunden wird</translation>
    </message>
    <message>
        <source>landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Check the library on the Landmarks page first (F7); landmarks need a real size.</source>
        <translation>Prüfen Sie zuerst die Bibliothek auf der Seite Landmarken (F7); Landmarken brauchen eine wirkliche Größe.</translation>
    </message>
</context>
<context>
    <name>farol::ui::FiguresDialog</name>
    <message>
        <source>Figures</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Which chart is shown</source>
        <translation>Welches Diagramm gezeigt wird</translation>
    </message>
    <message>
        <source>&amp;Save as PNG or SVG…</source>
        <translation>Als PNG oder SVG &amp;speichern…</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Diagramm speichern</translation>
    </message>
    <message>
        <source>Save the chart as a picture, or as a drawing that stays sharp</source>
        <translation>Das Diagramm als Bild speichern, oder als Zeichnung, die scharf bleibt</translation>
    </message>
    <message>
        <source>Charts (%1)</source>
        <translation>Diagramme (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden. Wählen Sie einen anderen Ordner.</translation>
    </message>
</context>
<context>
    <name>farol::ui::FindingModel</name>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und eine weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Rule: %1</source>
        <translation>Regel: %1</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Wie viele</translation>
    </message>
</context>
<context>
    <name>farol::ui::FloorModel</name>
    <message>
        <source>you are here</source>
        <translation>Sie sind hier</translation>
    </message>
    <message>
        <source>destination</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
</context>
<context>
    <name>farol::ui::FloorPictures</name>
    <message>
        <source>The image lies where its file says.</source>
        <translation>Das Bild liegt dort, wo seine Datei es angibt.</translation>
    </message>
    <message>
        <source>Now click where this point belongs on the map. Escape gives up.</source>
        <translation>Klicken Sie jetzt dorthin, wo dieser Punkt auf der Karte liegt. Escape bricht ab.</translation>
    </message>
    <message>
        <source>Click a point of the image that you know on the map, a corner of the house, say. Escape leaves the image where it is.</source>
        <translation>Klicken Sie auf einen Punkt des Bildes, den Sie auf der Karte kennen, etwa eine Hausecke. Escape lässt das Bild, wo es ist.</translation>
    </message>
    <message>
        <source>Click a second point of the image, far from the first.</source>
        <translation>Klicken Sie auf einen zweiten Punkt des Bildes, weit weg vom ersten.</translation>
    </message>
    <message>
        <source>Placed. A third point straightens a skewed image; Escape ends.</source>
        <translation>Eingepasst. Ein dritter Punkt richtet ein schiefes Bild gerade; Escape beendet.</translation>
    </message>
    <message>
        <source>That is beside the image. Click a point of the image.</source>
        <translation>Das ist neben dem Bild. Klicken Sie auf einen Punkt des Bildes.</translation>
    </message>
    <message>
        <source>These points lie too near each other, or on one line. Click another one.</source>
        <translation>Diese Punkte liegen zu nah beieinander oder auf einer Linie. Klicken Sie auf einen anderen.</translation>
    </message>
    <message>
        <source>The image is placed by three points.</source>
        <translation>Das Bild ist mit drei Punkten eingepasst.</translation>
    </message>
    <message>
        <source>How strong the floor-plan image is</source>
        <translation>Wie stark das Planbild zu sehen ist</translation>
    </message>
    <message>
        <source>Place by p&amp;oints</source>
        <translation>Einpa&amp;ssen</translation>
    </message>
    <message>
        <source>Place the image by points</source>
        <translation>Das Bild mit Punkten einpassen</translation>
    </message>
    <message>
        <source>Click two or three points of the image and where they belong on the map</source>
        <translation>Zwei oder drei Punkte des Bildes anklicken und wo sie auf der Karte liegen</translation>
    </message>
    <message>
        <source>Take a&amp;way</source>
        <translation>&amp;Wegnehmen</translation>
    </message>
    <message>
        <source>Take the image away</source>
        <translation>Das Bild wegnehmen</translation>
    </message>
    <message>
        <source>The floor shows no image any more; its file stays</source>
        <translation>Das Stockwerk zeigt kein Bild mehr; die Datei bleibt</translation>
    </message>
    <message>
        <source>Ima&amp;ge:</source>
        <translation>B&amp;ild:</translation>
    </message>
</context>
<context>
    <name>farol::ui::FramePanel</name>
    <message>
        <source>What the camera sees</source>
        <translation>Was die Kamera sieht</translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation>Kamerabild</translation>
    </message>
    <message>
        <source>The camera&apos;s picture, with what Farol recognised in it</source>
        <translation>Das Kamerabild mit dem, was Farol darin erkannt hat</translation>
    </message>
    <message>
        <source>Picture %1 at %2</source>
        <translation>Bild %1 bei %2</translation>
    </message>
    <message>
        <source>Picture %1 at %2 (%3)</source>
        <translation>Bild %1 bei %2 (%3)</translation>
    </message>
    <message>
        <source>understood in %1 ms</source>
        <translation>in %1 ms verstanden</translation>
    </message>
    <message numerus="yes">
        <source>%n left out because late</source>
        <translation>
            <numerusform>eines ausgelassen, weil zu spät</numerusform>
            <numerusform>%n ausgelassen, weil zu spät</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unreadable</source>
        <translation>
            <numerusform>eines unlesbar</numerusform>
            <numerusform>%n unlesbar</numerusform>
        </translation>
    </message>
    <message>
        <source>Time from the picture&apos;s arrival to the answer, and how many pictures had to be left out because Farol was still busy with an earlier one</source>
        <translation>Zeit von der Ankunft des Bildes bis zur Antwort, und wie viele Bilder ausfielen, weil Farol noch mit einem früheren beschäftigt war</translation>
    </message>
</context>
<context>
    <name>farol::ui::FrameView</name>
    <message>
        <source>No picture yet</source>
        <translation>Noch kein Bild</translation>
    </message>
    <message>
        <source>Nothing known is in the picture</source>
        <translation>Nichts Bekanntes im Bild</translation>
    </message>
    <message>
        <source>In the picture: %1</source>
        <translation>Im Bild: %1</translation>
    </message>
    <message>
        <source>Spoken: %1</source>
        <translation>Gesprochen: %1</translation>
    </message>
    <message>
        <source>%1 · %2 %</source>
        <translation>%1 · %2 %</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No picture yet.
Open a camera, a video or a folder of pictures, then press Play.</source>
        <translation>Noch kein Bild.
Öffnen Sie eine Kamera, ein Video oder einen Bilderordner, dann drücken Sie Abspielen.</translation>
    </message>
</context>
<context>
    <name>farol::ui::HelpDialog</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Kapitel</translation>
    </message>
    <message>
        <source>What the help is about</source>
        <translation>Worum es in der Hilfe geht</translation>
    </message>
    <message>
        <source>Walk page</source>
        <translation>Seite Begehung</translation>
    </message>
    <message>
        <source>Map page</source>
        <translation>Seite Karte</translation>
    </message>
    <message>
        <source>Landmarks page</source>
        <translation>Seite Landmarken</translation>
    </message>
    <message>
        <source>Kiosk</source>
        <translation>Kiosk</translation>
    </message>
    <message>
        <source>Text of the chapter</source>
        <translation>Text des Kapitels</translation>
    </message>
    <message>
        <source>Here a map of a building is opened or brought in, looked at, checked and changed. The plan and the table show the same: what is chosen in one is chosen in the other.</source>
        <translation>Hier wird die Karte eines Gebäudes geöffnet oder übernommen, angesehen, geprüft und geändert. Plan und Tabelle zeigen dasselbe: Was in einem gewählt ist, ist auch im anderen gewählt.</translation>
    </message>
    <message>
        <source>F7 looks for what is wrong with the map and says what to do about each finding.</source>
        <translation>F7 sucht, was an der Karte nicht stimmt, und sagt zu jedem Befund, was zu tun ist.</translation>
    </message>
    <message>
        <source>Ctrl+U marks places that the landmarks cannot tell apart. A landmark there helps most.</source>
        <translation>Strg+U markiert Orte, die die Landmarken nicht unterscheiden. Eine Landmarke hilft dort am meisten.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L puts a landmark on the plan, Ctrl+Shift+D a door. Drag what is chosen, or move it with Alt and the arrows.</source>
        <translation>Strg+Umschalt+L setzt eine Landmarke in den Plan, Strg+Umschalt+D eine Tür. Ziehen Sie das Gewählte, oder bewegen Sie es mit Alt und den Pfeilen.</translation>
    </message>
    <message>
        <source>Ctrl+Z takes every step back. Nothing is written until you save with Ctrl+S.</source>
        <translation>Strg+Z nimmt jeden Schritt zurück. Geschrieben wird erst, wenn Sie mit Strg+S speichern.</translation>
    </message>
    <message>
        <source>Here Farol is taught what it shall know again. Every change is saved by itself and can be taken back with Ctrl+Z; a landmark that is not finished is kept, also when the computer stops.</source>
        <translation>Hier wird Farol beigebracht, was es wiedererkennen soll. Jede Änderung wird von selbst gespeichert und lässt sich mit Strg+Z zurücknehmen; eine unfertige Landmarke bleibt erhalten, auch wenn der Computer ausgeht.</translation>
    </message>
    <message>
        <source>Ctrl+T teaches a landmark in four steps: what it is, its views, a trial, its place on the map.</source>
        <translation>Strg+T bringt eine Landmarke in vier Schritten bei: was es ist, ihre Ansichten, eine Probe, ihr Ort auf der Karte.</translation>
    </message>
    <message>
        <source>Take a view from the front, from the left, from the right and from farther away. The coach says what is wrong with a picture and which one comes next. Drag the four corners onto the landmark; by keys, 1 to 4 choose a corner and the arrows move it.</source>
        <translation>Nehmen Sie eine Ansicht von vorn, von links, von rechts und von weiter weg auf. Der Rat sagt, was an einem Bild nicht stimmt und welches als nächstes kommt. Ziehen Sie die vier Ecken auf die Landmarke; mit Tasten wählen 1 bis 4 eine Ecke, und die Pfeile bewegen sie.</translation>
    </message>
    <message>
        <source>F7 checks the whole library: how well each landmark is found, how far away, how far aside, and which are taken for each other. Merge what is the same, and add views to what is lost.</source>
        <translation>F7 prüft die ganze Bibliothek: wie gut jede Landmarke gefunden wird, aus welcher Entfernung, von der Seite, und welche verwechselt werden. Legen Sie zusammen, was gleich ist, und ergänzen Sie Ansichten, wo etwas verloren geht.</translation>
    </message>
    <message>
        <source>Here somebody is guided, and you watch: what the camera sees, the place on the map, what is said, and why.</source>
        <translation>Hier wird jemand geführt, und Sie sehen zu: was die Kamera sieht, der Ort auf der Karte, was gesagt wird und warum.</translation>
    </message>
    <message>
        <source>Ctrl+O opens the map of the building.</source>
        <translation>Strg+O öffnet die Karte des Gebäudes.</translation>
    </message>
    <message>
        <source>Ctrl+L opens the landmarks that belong to it.</source>
        <translation>Strg+L öffnet die Landmarken, die dazugehören.</translation>
    </message>
    <message>
        <source>Ctrl+P chooses a camera, a video or a folder of pictures, and Ctrl+G where to go.</source>
        <translation>Strg+P wählt eine Kamera, ein Video oder einen Bilderordner, und Strg+G, wohin es geht.</translation>
    </message>
    <message>
        <source>F5 starts and holds the walk, F8 goes on by one picture.</source>
        <translation>F5 startet die Begehung und hält sie an, F8 geht ein Bild weiter.</translation>
    </message>
    <message>
        <source>When the place shown is not right, choose the right one on the map and press Ctrl+H.</source>
        <translation>Wenn der gezeigte Ort nicht stimmt, wählen Sie den richtigen auf der Karte und drücken Sie Strg+H.</translation>
    </message>
    <message>
        <source>Ctrl+W gives the place up, so that it is looked for anew.</source>
        <translation>Strg+W gibt den Ort auf, damit er neu gesucht wird.</translation>
    </message>
    <message>
        <source>Ctrl+E speaks a sentence that you type.</source>
        <translation>Strg+E spricht einen Satz, den Sie tippen.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R records the next walk. A recorded walk can be worked out anew in another way and compared, from the Walk menu.</source>
        <translation>Strg+Umschalt+R nimmt die nächste Begehung auf. Eine aufgenommene Begehung lässt sich im Menü Begehung auf andere Weise neu berechnen und vergleichen.</translation>
    </message>
    <message>
        <source>The timeline at the bottom looks back: drag it, or use the arrow keys. “Why there” explains the vote of the place that is chosen in the list.</source>
        <translation>Die Zeitleiste unten schaut zurück: Ziehen Sie sie, oder benutzen Sie die Pfeile. „Warum dort“ erklärt die Stimme für den Ort, der in der Liste gewählt ist.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+U marks from where no landmark is seen, and Ctrl+Shift+N lists the routes that are missing. Ctrl+Shift+I lays the image of a floor plan under the floor: click two points of it and where they belong.</source>
        <translation>Strg+Umschalt+U markiert, von wo keine Landmarke zu sehen ist, und Strg+Umschalt+N listet die Wege auf, die fehlen. Strg+Umschalt+I legt das Bild eines Grundrisses unter das Stockwerk: Klicken Sie auf zwei seiner Punkte und wo sie liegen.</translation>
    </message>
    <message>
        <source>The kiosk is for a blind user who is alone: “farol --kiosk” fills the screen and says everything. Arrows and Enter choose a destination, F searches by name, digits by number; F1 says all keys, Escape goes back.</source>
        <translation>Der Kiosk ist für einen blinden Benutzer, der allein ist: „farol --kiosk“ füllt den Bildschirm und sagt alles. Pfeile und Eingabe wählen ein Ziel, F sucht nach dem Namen, Ziffern nach der Nummer; F1 sagt alle Tasten, Escape geht zurück.</translation>
    </message>
</context>
<context>
    <name>farol::ui::HistoryModel</name>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>farol::ui::ImportDialog</name>
    <message>
        <source>Import a map</source>
        <translation>Karte importieren</translation>
    </message>
    <message>
        <source>A file, a folder or a zip: IMDF, OpenStreetMap indoor, IndoorGML, per-floor Shapefiles, GeoJSON, GeoPackage, HULOP, WRLD. What is found wrong is told afterwards; nothing is written until you save.</source>
        <translation>Eine Datei, ein Ordner oder ein Zip: IMDF, OpenStreetMap für innen, IndoorGML, Shapefiles je Stockwerk, GeoJSON, GeoPackage, HULOP, WRLD. Was nicht stimmt, wird danach gesagt; geschrieben wird erst beim Speichern.</translation>
    </message>
    <message>
        <source>&amp;File…</source>
        <translation>&amp;Datei…</translation>
    </message>
    <message>
        <source>Fol&amp;der…</source>
        <translation>&amp;Ordner…</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>nach dem Inhalt</translation>
    </message>
    <message>
        <source>as the format has it</source>
        <translation>wie im Format</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Path of the file, folder or zip</source>
        <translation>Pfad der Datei, des Ordners oder Zips</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Of which kind the map is</source>
        <translation>Von welcher Art die Karte ist</translation>
    </message>
    <message>
        <source>Language of names</source>
        <translation>Sprache der Namen</translation>
    </message>
    <message>
        <source>Which of several names is taken, such as en or pt</source>
        <translation>Welcher von mehreren Namen gilt, zum Beispiel en oder de</translation>
    </message>
    <message>
        <source>Where the map leaves it open: filename, z, or the name of a column</source>
        <translation>Wo die Karte es offen lässt: filename, z oder der Name einer Spalte</translation>
    </message>
    <message>
        <source>A file with other names of columns and codes</source>
        <translation>Eine Datei mit anderen Namen von Spalten und Codes</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>none is needed</source>
        <translation>nicht nötig</translation>
    </message>
    <message>
        <source>Where the level is</source>
        <translation>Wo die Ebene steht</translation>
    </message>
    <message>
        <source>File of other names</source>
        <translation>Datei anderer Namen</translation>
    </message>
</context>
<context>
    <name>farol::ui::InstructionPanel</name>
    <message>
        <source>No destination chosen: places are told, no route.</source>
        <translation>Kein Ziel gewählt: Orte werden genannt, kein Weg.</translation>
    </message>
    <message>
        <source>The route follows as soon as it is known where you are.</source>
        <translation>Der Weg folgt, sobald bekannt ist, wo Sie sind.</translation>
    </message>
    <message>
        <source>There is no way to the destination. %1</source>
        <translation>Es gibt keinen Weg zum Ziel. %1</translation>
    </message>
    <message>
        <source>At the destination.</source>
        <translation>Am Ziel.</translation>
    </message>
    <message>
        <source>On the way to %1</source>
        <translation>Unterwegs zu: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n more place(s) to pass</source>
        <translation>
            <numerusform>noch ein Ort zu durchqueren</numerusform>
            <numerusform>noch %n Orte zu durchqueren</numerusform>
        </translation>
    </message>
    <message>
        <source>next in %1 m</source>
        <translation>nächste in %1 m</translation>
    </message>
    <message>
        <source>%1 m to go</source>
        <translation>noch %1 m</translation>
    </message>
    <message>
        <source>Off the route</source>
        <translation>Vom Weg abgekommen</translation>
    </message>
    <message>
        <source>Next instruction</source>
        <translation>Nächste Anweisung</translation>
    </message>
    <message>
        <source>Said at %1</source>
        <translation>Gesagt bei %1</translation>
    </message>
    <message>
        <source>Open a map to begin.</source>
        <translation>Öffnen Sie zuerst eine Karte.</translation>
    </message>
    <message>
        <source>Ready. Press Play to start the walk.</source>
        <translation>Bereit. Drücken Sie Abspielen, um die Begehung zu beginnen.</translation>
    </message>
    <message>
        <source>Looking around…</source>
        <translation>Sieht sich um…</translation>
    </message>
    <message>
        <source>Next instruction: %1</source>
        <translation>Nächste Anweisung: %1</translation>
    </message>
    <message>
        <source>No sound: %1</source>
        <translation>Kein Ton: %1</translation>
    </message>
</context>
<context>
    <name>farol::ui::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>In the map: move it</source>
        <translation>In der Karte: verschieben</translation>
    </message>
    <message>
        <source>In the map: larger, smaller, whole floor</source>
        <translation>In der Karte: größer, kleiner, ganzes Stockwerk</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Bild auf, Bild ab</translation>
    </message>
    <message>
        <source>In the map: the floor above, the floor below</source>
        <translation>In der Karte: das Stockwerk darüber, darunter</translation>
    </message>
    <message>
        <source>Alt + Arrows</source>
        <translation>Alt + Pfeile</translation>
    </message>
    <message>
        <source>In the plan: move what is chosen by 10 cm, with Shift by 1 m</source>
        <translation>Im Plan: das Gewählte um 10 cm bewegen, mit Umschalt um 1 m</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>The next button or list</source>
        <translation>Der nächste Knopf oder die nächste Liste</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was sie tut</translation>
    </message>
</context>
<context>
    <name>farol::ui::Kiosk</name>
    <message>
        <source>No map was given (farol --kiosk --map FILE).</source>
        <translation>Es wurde keine Karte angegeben (farol --kiosk --map DATEI).</translation>
    </message>
    <message>
        <source>The landmarks cannot be loaded: I will hardly know where you are. Ask for help.</source>
        <translation>Die Landmarken lassen sich nicht laden: Ich werde kaum wissen, wo Sie sind. Bitten Sie um Hilfe.</translation>
    </message>
    <message>
        <source>The destination cannot be kept for a restart: the folder cannot be written.</source>
        <translation>Das Ziel kann nicht für einen Neustart aufgehoben werden: In den Ordner kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The chosen voice does not work. This is another one.</source>
        <translation>Die gewählte Stimme geht nicht. Dies ist eine andere.</translation>
    </message>
    <message>
        <source>The map has been changed. The new one is used after this way.</source>
        <translation>Die Karte wurde geändert. Die neue gilt nach diesem Weg.</translation>
    </message>
    <message>
        <source>The file of the map is gone. I keep the map that I have.</source>
        <translation>Die Datei der Karte ist weg. Ich behalte die Karte, die ich habe.</translation>
    </message>
    <message>
        <source>The new map cannot be opened. I keep the old one.</source>
        <translation>Die neue Karte lässt sich nicht öffnen. Ich behalte die alte.</translation>
    </message>
    <message>
        <source>Another Farol kiosk of this user is running.</source>
        <translation>Ein anderes Farol dieses Benutzers läuft schon.</translation>
    </message>
    <message>
        <source>Farol is already running here. I close this one. Goodbye.</source>
        <translation>Farol läuft hier schon. Ich schließe dieses. Auf Wiedersehen.</translation>
    </message>
    <message>
        <source>The map has been changed, and I use the new one.</source>
        <translation>Die Karte wurde geändert, und ich verwende die neue.</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskMachine</name>
    <message>
        <source>One moment.</source>
        <translation>Einen Moment.</translation>
    </message>
    <message>
        <source>Farol. I am opening the map.</source>
        <translation>Farol. Ich öffne die Karte.</translation>
    </message>
    <message>
        <source>The new map cannot be opened. I keep the old one.</source>
        <translation>Die neue Karte lässt sich nicht öffnen. Ich behalte die alte.</translation>
    </message>
    <message>
        <source>Farol was interrupted and has started again.</source>
        <translation>Farol wurde unterbrochen und hat neu begonnen.</translation>
    </message>
    <message>
        <source>You were last here: %1.</source>
        <translation>Zuletzt waren Sie hier: %1.</translation>
    </message>
    <message>
        <source>The camera works again.</source>
        <translation>Die Kamera geht wieder.</translation>
    </message>
    <message>
        <source>Stop, and turn slowly to the right, so that I can look around.</source>
        <translation>Bleiben Sie stehen und drehen Sie sich langsam nach rechts, damit ich mich umsehen kann.</translation>
    </message>
    <message>
        <source>No destination is chosen yet. Choose one first.</source>
        <translation>Es ist noch kein Ziel gewählt. Wählen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>This is the first place.</source>
        <translation>Das ist der erste Ort.</translation>
    </message>
    <message>
        <source>This is the last place.</source>
        <translation>Das ist der letzte Ort.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s). %2.</source>
        <extracomment>%1 &quot;Rooms&quot;, %2 the first of them</extracomment>
        <translation>
            <numerusform>%1: ein Ort. %2.</numerusform>
            <numerusform>%1: %n Orte. %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Type part of a name or a number, then press Enter.</source>
        <translation>Tippen Sie einen Teil eines Namens oder einer Nummer, dann drücken Sie Eingabe.</translation>
    </message>
    <message>
        <source>space</source>
        <translation>Leerzeichen</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s).</source>
        <comment>while typing</comment>
        <extracomment>%1 the letter just typed</extracomment>
        <translation>
            <numerusform>%1: ein Ort.</numerusform>
            <numerusform>%1: %n Orte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is typed.</source>
        <translation>Es ist nichts getippt.</translation>
    </message>
    <message>
        <source>Deleted: %1. %2</source>
        <translation>Gelöscht: %1. %2</translation>
    </message>
    <message>
        <source>%1 %2. Enter: go there. Arrow down: next.</source>
        <translation>%1 %2. Eingabe: dorthin gehen. Pfeil runter: nächster.</translation>
    </message>
    <message>
        <source>Nothing is chosen yet. Press arrow down to hear the places.</source>
        <translation>Es ist noch nichts gewählt. Drücken Sie Pfeil runter, um die Orte zu hören.</translation>
    </message>
    <message>
        <source>I try the camera again.</source>
        <translation>Ich versuche es noch einmal mit der Kamera.</translation>
    </message>
    <message>
        <source>Going on. %1</source>
        <translation>Es geht weiter. %1</translation>
    </message>
    <message>
        <source>This key does nothing. Escape: back.</source>
        <translation>Diese Taste tut nichts. Escape: zurück.</translation>
    </message>
    <message>
        <source>Back to the kinds of places.</source>
        <translation>Zurück zu den Arten von Orten.</translation>
    </message>
    <message>
        <source>Leave Farol.</source>
        <translation>Farol verlassen.</translation>
    </message>
    <message>
        <source>Start.</source>
        <translation>Beginnen.</translation>
    </message>
    <message>
        <source>Hear the whole way.</source>
        <translation>Den ganzen Weg hören.</translation>
    </message>
    <message>
        <source>Another place.</source>
        <translation>Ein anderer Ort.</translation>
    </message>
    <message>
        <source>Try the camera again.</source>
        <translation>Die Kamera noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Stop the guidance.</source>
        <translation>Die Führung beenden.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>Yes, stop.</source>
        <translation>Ja, beenden.</translation>
    </message>
    <message>
        <source>No, go on.</source>
        <translation>Nein, weiter.</translation>
    </message>
    <message>
        <source>Yes, leave.</source>
        <translation>Ja, verlassen.</translation>
    </message>
    <message>
        <source>No, stay.</source>
        <translation>Nein, bleiben.</translation>
    </message>
    <message>
        <source>Press space to hear what there is, then Enter.</source>
        <translation>Drücken Sie die Leertaste, um zu hören, was es gibt, dann Eingabe.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s). Space: first place.</source>
        <translation>
            <numerusform>%1: ein Ort. Leertaste: erster Ort.</numerusform>
            <numerusform>%1: %n Orte. Leertaste: erster Ort.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. %2 of %3.</source>
        <extracomment>%1 a place, then which of how many</extracomment>
        <translation>%1. %2 von %3.</translation>
    </message>
    <message numerus="yes">
        <source>Choose a destination: %n place(s).</source>
        <translation>
            <numerusform>Wählen Sie ein Ziel: ein Ort.</numerusform>
            <numerusform>Wählen Sie ein Ziel: %n Orte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Space: next. Enter: take it.</source>
        <translation>Leertaste: weiter. Eingabe: wählen.</translation>
    </message>
    <message>
        <source>Arrow down: first place. F: type a name. F1: all keys.</source>
        <translation>Pfeil runter: erster Ort. F: einen Namen tippen. F1: alle Tasten.</translation>
    </message>
    <message>
        <source>To: %1.</source>
        <translation>Ziel: %1.</translation>
    </message>
    <message>
        <source>I do not know yet where you are, and look for it on the way.</source>
        <translation>Ich weiß noch nicht, wo Sie sind, und suche es unterwegs.</translation>
    </message>
    <message>
        <source>Space: choices.</source>
        <translation>Leertaste: Auswahl.</translation>
    </message>
    <message>
        <source>Enter: start. L: the whole way. Escape: another place.</source>
        <translation>Eingabe: beginnen. L: der ganze Weg. Escape: ein anderer Ort.</translation>
    </message>
    <message>
        <source>Stop the guidance?</source>
        <translation>Die Führung beenden?</translation>
    </message>
    <message>
        <source>Leave Farol?</source>
        <translation>Farol verlassen?</translation>
    </message>
    <message>
        <source>Enter or Escape: yes. Any other key: no.</source>
        <translation>Eingabe oder Escape: ja. Jede andere Taste: nein.</translation>
    </message>
    <message>
        <source>No camera is set up, and I cannot guide you. Ask for help.</source>
        <translation>Es ist keine Kamera eingerichtet, ich kann Sie nicht führen. Bitten Sie um Hilfe.</translation>
    </message>
    <message>
        <source>The camera is starting.</source>
        <translation>Die Kamera startet.</translation>
    </message>
    <message>
        <source>Stop. The camera gives no pictures, and I cannot guide you. Enter: try again.</source>
        <translation>Halt. Die Kamera gibt keine Bilder, ich kann Sie nicht führen. Eingabe: noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The camera gives no pictures. I try it again when you start.</source>
        <translation>Die Kamera gibt keine Bilder. Ich versuche es wieder, wenn Sie beginnen.</translation>
    </message>
    <message>
        <source>No place fits: %1. Delete letters, or press Escape.</source>
        <translation>Kein Ort passt: %1. Löschen Sie Buchstaben oder drücken Sie Escape.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) fit: %1.</source>
        <translation>
            <numerusform>Ein Ort passt: %1.</numerusform>
            <numerusform>%n Orte passen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>This map has no places to go to. Ask for help.</source>
        <translation>Diese Karte hat keine Orte, zu denen man gehen kann. Bitten Sie um Hilfe.</translation>
    </message>
    <message>
        <source>The map cannot be opened. Ask for help.</source>
        <translation>Die Karte lässt sich nicht öffnen. Bitten Sie um Hilfe.</translation>
    </message>
    <message>
        <source>The map is being opened. Please wait.</source>
        <translation>Die Karte wird geöffnet. Bitte warten Sie.</translation>
    </message>
    <message>
        <source>On the way to: %1.</source>
        <translation>Unterwegs nach: %1.</translation>
    </message>
    <message>
        <source>You have arrived: %1. Enter: another destination.</source>
        <translation>Sie sind angekommen: %1. Eingabe: ein anderes Ziel.</translation>
    </message>
    <message>
        <source>You have probably arrived: %1. Enter: another destination.</source>
        <translation>Sie sind wahrscheinlich angekommen: %1. Eingabe: ein anderes Ziel.</translation>
    </message>
    <message>
        <source>Goodbye.</source>
        <translation>Auf Wiederhören.</translation>
    </message>
    <message>
        <source>Quiet: I tell only warnings and what you ask. M: speak again.</source>
        <translation>Stumm: Ich sage nur Warnungen und was Sie fragen. M: wieder sprechen.</translation>
    </message>
    <message>
        <source>I tell everything again.</source>
        <translation>Ich sage wieder alles.</translation>
    </message>
    <message>
        <source>Speed %1 of %2.</source>
        <translation>Tempo %1 von %2.</translation>
    </message>
    <message>
        <source>I speak English now.</source>
        <translation>Ich spreche jetzt Deutsch.</translation>
    </message>
    <message>
        <source>Two keys: space goes through the choices, Enter takes one. F4: all keys again.</source>
        <translation>Zwei Tasten: Die Leertaste geht durch die Auswahl, Eingabe nimmt etwas. F4: wieder alle Tasten.</translation>
    </message>
    <message>
        <source>All keys are in use again.</source>
        <translation>Alle Tasten gelten wieder.</translation>
    </message>
    <message>
        <source>Farol</source>
        <translation>Farol</translation>
    </message>
    <message>
        <source>Where to? %1</source>
        <translation>Wohin? %1</translation>
    </message>
    <message>
        <source>Search: %1</source>
        <translation>Suche: %1</translation>
    </message>
    <message>
        <source>The way to %1</source>
        <translation>Der Weg: %1</translation>
    </message>
    <message>
        <source>Walking to %1</source>
        <translation>Unterwegs: %1</translation>
    </message>
    <message>
        <source>Arrived</source>
        <translation>Angekommen</translation>
    </message>
    <message>
        <source>Probably arrived</source>
        <translation>Wahrscheinlich angekommen</translation>
    </message>
    <message>
        <source>Stop?</source>
        <translation>Beenden?</translation>
    </message>
    <message>
        <source>Leave?</source>
        <translation>Verlassen?</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Goodbye</source>
        <translation>Auf Wiederhören</translation>
    </message>
    <message>
        <source>Space: next   Enter: take   F4: all keys</source>
        <translation>Leertaste: weiter   Eingabe: wählen   F4: Tasten</translation>
    </message>
    <message>
        <source>Arrows: places   Enter: go   F: search   F1: keys</source>
        <translation>Pfeile: Orte   Eingabe: gehen   F: suchen   F1: Tasten</translation>
    </message>
    <message>
        <source>Enter: done   Esc: back</source>
        <translation>Eingabe: fertig   Esc: zurück</translation>
    </message>
    <message>
        <source>Enter: start   L: whole way   Esc: back</source>
        <translation>Eingabe: beginnen   L: ganzer Weg   Esc: zurück</translation>
    </message>
    <message>
        <source>Space: again   W: where am I   Esc: stop</source>
        <translation>Leertaste: nochmal   W: wo bin ich   Esc: beenden</translation>
    </message>
    <message>
        <source>Enter: another destination</source>
        <translation>Eingabe: ein anderes Ziel</translation>
    </message>
    <message>
        <source>Enter: yes   any other key: no</source>
        <translation>Eingabe: ja   andere Taste: nein</translation>
    </message>
    <message>
        <source>Esc: back   F1: number pad</source>
        <translation>Esc: zurück   F1: Ziffernblock</translation>
    </message>
    <message>
        <source>Esc: leave   F1: keys</source>
        <translation>Esc: verlassen   F1: Tasten</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskPage</name>
    <message>
        <source>Farol</source>
        <translation>Farol</translation>
    </message>
    <message>
        <source>Farol, guidance</source>
        <translation>Farol, Führung</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskPlaces</name>
    <message>
        <source>All places</source>
        <translation>Alle Orte</translation>
    </message>
    <message>
        <source>Rooms</source>
        <translation>Räume</translation>
    </message>
    <message>
        <source>Toilets</source>
        <translation>Toiletten</translation>
    </message>
    <message>
        <source>Halls</source>
        <translation>Hallen</translation>
    </message>
    <message>
        <source>Corridors</source>
        <translation>Flure</translation>
    </message>
    <message>
        <source>Lifts</source>
        <translation>Aufzüge</translation>
    </message>
    <message>
        <source>Stairs</source>
        <translation>Treppen</translation>
    </message>
    <message>
        <source>Ways out</source>
        <translation>Ausgänge</translation>
    </message>
    <message>
        <source>Other places</source>
        <translation>Andere Orte</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskWords</name>
    <message>
        <source>Arrow up</source>
        <translation>Pfeil rauf</translation>
    </message>
    <message>
        <source>Arrow down</source>
        <translation>Pfeil runter</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos 1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Arrow left</source>
        <translation>Pfeil links</translation>
    </message>
    <message>
        <source>Arrow right</source>
        <translation>Pfeil rechts</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Escape-Taste</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Plus-Taste</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>Minus-Taste</translation>
    </message>
    <message>
        <source>the place before</source>
        <translation>der vorige Ort</translation>
    </message>
    <message>
        <source>the next place</source>
        <translation>der nächste Ort</translation>
    </message>
    <message>
        <source>the first place</source>
        <translation>der erste Ort</translation>
    </message>
    <message>
        <source>the last place</source>
        <translation>der letzte Ort</translation>
    </message>
    <message>
        <source>another kind of places, back</source>
        <translation>eine andere Art von Orten, zurück</translation>
    </message>
    <message>
        <source>another kind of places, on</source>
        <translation>eine andere Art von Orten, weiter</translation>
    </message>
    <message>
        <source>choose, start</source>
        <translation>wählen, beginnen</translation>
    </message>
    <message>
        <source>back; hold it down to leave</source>
        <translation>zurück; gedrückt halten, um Farol zu verlassen</translation>
    </message>
    <message>
        <source>say again</source>
        <translation>noch einmal sagen</translation>
    </message>
    <message>
        <source>where am I</source>
        <translation>wo bin ich</translation>
    </message>
    <message>
        <source>what is around me</source>
        <translation>was ist um mich herum</translation>
    </message>
    <message>
        <source>what comes next</source>
        <translation>was kommt als Nächstes</translation>
    </message>
    <message>
        <source>the whole way</source>
        <translation>der ganze Weg</translation>
    </message>
    <message>
        <source>look around</source>
        <translation>sich umsehen</translation>
    </message>
    <message>
        <source>quiet, or speak again</source>
        <translation>stumm, oder wieder sprechen</translation>
    </message>
    <message>
        <source>speak faster</source>
        <translation>schneller sprechen</translation>
    </message>
    <message>
        <source>speak slower</source>
        <translation>langsamer sprechen</translation>
    </message>
    <message>
        <source>how much I tell</source>
        <translation>wie viel ich sage</translation>
    </message>
    <message>
        <source>how I tell directions</source>
        <translation>wie ich Richtungen sage</translation>
    </message>
    <message>
        <source>metres, feet or steps</source>
        <translation>Meter, Fuß oder Schritte</translation>
    </message>
    <message>
        <source>search a place by typing</source>
        <translation>einen Ort durch Tippen suchen</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>die Tasten</translation>
    </message>
    <message>
        <source>everything with two keys</source>
        <translation>alles mit zwei Tasten</translation>
    </message>
    <message>
        <source>Keys. Press one to hear what it does; F1: number pad; Escape: back.</source>
        <translation>Tasten. Drücken Sie eine, um zu hören, was sie tut; F1: Ziffernblock; Escape: zurück.</translation>
    </message>
    <message>
        <source>Number pad. 8 and 2: up and down. 4 and 6: left and right. 5 or Enter: choose. 0: say again. 1: where am I. 3: around me. 7: what comes next. 9: the whole way. Plus and minus: speed. Star: keys. Slash: quiet. Point: back.</source>
        <translation>Ziffernblock. 8 und 2: rauf und runter. 4 und 6: links und rechts. 5 oder Eingabe: wählen. 0: noch einmal. 1: wo bin ich. 3: um mich herum. 7: was kommt als Nächstes. 9: der ganze Weg. Plus und minus: Tempo. Stern: Tasten. Schrägstrich: stumm. Komma: zurück.</translation>
    </message>
    <message>
        <source>This key does nothing here. F1: all keys.</source>
        <translation>Diese Taste tut hier nichts. F1: alle Tasten.</translation>
    </message>
    <message>
        <source>I tell directions only.</source>
        <translation>Ich sage nur Richtungen.</translation>
    </message>
    <message>
        <source>I tell directions and objects.</source>
        <translation>Ich sage Richtungen und Gegenstände.</translation>
    </message>
    <message>
        <source>I tell directions, objects and texts.</source>
        <translation>Ich sage Richtungen, Gegenstände und Texte.</translation>
    </message>
    <message>
        <source>Directions as left and right.</source>
        <translation>Richtungen als links und rechts.</translation>
    </message>
    <message>
        <source>Directions as on a clock.</source>
        <translation>Richtungen wie auf einer Uhr.</translation>
    </message>
    <message>
        <source>Directions in degrees.</source>
        <translation>Richtungen in Grad.</translation>
    </message>
    <message>
        <source>Distances in metres.</source>
        <translation>Entfernungen in Metern.</translation>
    </message>
    <message>
        <source>Distances in feet.</source>
        <translation>Entfernungen in Fuß.</translation>
    </message>
    <message>
        <source>Distances in steps.</source>
        <translation>Entfernungen in Schritten.</translation>
    </message>
    <message>
        <source>another language</source>
        <translation>eine andere Sprache</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <extracomment>%1 a key, %2 what it does</extracomment>
        <translation>%1: %2.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LandmarkDialog</name>
    <message>
        <source>Landmark %1</source>
        <translation>Landmarke %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>What can be read on it</source>
        <translation>Was darauf zu lesen ist</translation>
    </message>
    <message>
        <source>Trained as</source>
        <translation>Gelernt als</translation>
    </message>
    <message>
        <source>The name under which its appearance was trained</source>
        <translation>Der Name, unter dem das Aussehen gelernt wurde</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>The way it faces: 0 is east, 90 north, 180 west, 270 south</source>
        <translation>Wohin es zeigt: 0 ist Osten, 90 Norden, 180 Westen, 270 Süden</translation>
    </message>
    <message>
        <source>Height above the floor</source>
        <translation>Höhe über dem Boden</translation>
    </message>
    <message>
        <source>Of its middle</source>
        <translation>Der Mitte</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>How wide it is: its distance is told from that</source>
        <translation>Wie breit es ist: Daraus ergibt sich die Entfernung</translation>
    </message>
    <message>
        <source>Its own height</source>
        <translation>Eigene Höhe</translation>
    </message>
    <message>
        <source>How tall it is</source>
        <translation>Wie hoch es ist</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Ost</translation>
    </message>
    <message>
        <source>Place on the map, metres to the east</source>
        <translation>Ort auf der Karte, Meter nach Osten</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>Place on the map, metres to the north</source>
        <translation>Ort auf der Karte, Meter nach Norden</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryDocument</name>
    <message>
        <source>The library was changed meanwhile; try again.</source>
        <translation>Die Bibliothek wurde inzwischen geändert; versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>another program is writing this library; try again</source>
        <translation>ein anderes Programm schreibt gerade in diese Bibliothek; versuchen Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryModel</name>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>%1 × %2 m</source>
        <translation>%1 × %2 m</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>In maps called “%1”</source>
        <translation>In Karten „%1“ genannt</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Real size</source>
        <translation>Wirkliche Größe</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>How well it is found</source>
        <translation>Wie gut es gefunden wird</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryPanel</name>
    <message>
        <source>Nothing is chosen</source>
        <translation>Nichts gewählt</translation>
    </message>
    <message>
        <source>Not checked yet. “Check all” looks how well each landmark is found.</source>
        <translation>Noch nicht geprüft. „Alle prüfen“ sieht nach, wie gut jede Landmarke gefunden wird.</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Each view is held back once and looked for with the others; then each landmark is shown smaller and turned.</source>
        <translation>Jede Ansicht wird einmal zurückgehalten und mit den anderen gesucht; dann wird jede Landmarke kleiner und gedreht gezeigt.</translation>
    </message>
    <message>
        <source>Not checked yet. “Check all” looks how well each landmark is found, and which are taken for each other.</source>
        <translation>Noch nicht geprüft. „Alle prüfen“ sieht nach, wie gut jede Landmarke gefunden wird und welche verwechselt werden.</translation>
    </message>
    <message>
        <source>All landmarks are found well.</source>
        <translation>Alle Landmarken werden gut gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s) need care.</source>
        <translation>
            <numerusform>Eine Landmarke braucht Pflege.</numerusform>
            <numerusform>%n Landmarken brauchen Pflege.</numerusform>
        </translation>
    </message>
    <message>
        <source>None is taken for another.</source>
        <translation>Keine wird für eine andere gehalten.</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) are taken for each other.</source>
        <translation>
            <numerusform>Ein Paar wird verwechselt.</numerusform>
            <numerusform>%n Paare werden verwechselt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rows: whose picture was shown. Columns: what was seen in it. On the diagonal: views found again.</source>
        <translation>Zeilen: wessen Bild gezeigt wurde. Spalten: was darin gesehen wurde. Auf der Diagonale: wiedergefundene Ansichten.</translation>
    </message>
    <message>
        <source>The library was changed since: check again.</source>
        <translation>Die Bibliothek wurde seitdem geändert: Prüfen Sie noch einmal.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>eine Landmarke</numerusform>
            <numerusform>%n Landmarken</numerusform>
        </translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>This library is empty. “Teach” begins with the first landmark.</source>
        <translation>Diese Bibliothek ist leer. „Beibringen“ beginnt mit der ersten Landmarke.</translation>
    </message>
    <message>
        <source>Open a landmark library, or make a new one, to teach Farol what it shall know again.</source>
        <translation>Öffnen Sie eine Landmarkenbibliothek oder legen Sie eine neue an, um Farol beizubringen, was es wiedererkennen soll.</translation>
    </message>
    <message>
        <source>Landmarks of the library</source>
        <translation>Landmarken der Bibliothek</translation>
    </message>
    <message>
        <source>The landmarks that Farol was taught; press Enter to add views to one</source>
        <translation>Die Landmarken, die Farol gelernt hat; Eingabe fügt einer Ansichten hinzu</translation>
    </message>
    <message>
        <source>Views of the landmark</source>
        <translation>Ansichten der Landmarke</translation>
    </message>
    <message>
        <source>The photographs it is learnt from; choose some of them to split or to delete them</source>
        <translation>Die Fotos, aus denen sie gelernt ist; wählen Sie einige, um sie abzutrennen oder zu löschen</translation>
    </message>
    <message>
        <source>&amp;Views:</source>
        <translation>&amp;Ansichten:</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>C&amp;heck all</source>
        <translation>Alle &amp;prüfen</translation>
    </message>
    <message>
        <source>Check all landmarks</source>
        <translation>Alle Landmarken prüfen</translation>
    </message>
    <message>
        <source>Look how well each landmark is found and which are taken for each other</source>
        <translation>Nachsehen, wie gut jede Landmarke gefunden wird und welche verwechselt werden</translation>
    </message>
    <message>
        <source>Save as CS&amp;V…</source>
        <translation>Als &amp;CSV speichern…</translation>
    </message>
    <message>
        <source>Save the report as CSV</source>
        <translation>Den Bericht als CSV speichern</translation>
    </message>
    <message>
        <source>Save the report for a spreadsheet</source>
        <translation>Den Bericht für eine Tabellenkalkulation speichern</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Fortschritt der Prüfung</translation>
    </message>
    <message>
        <source>Who is taken for whom</source>
        <translation>Wer für wen gehalten wird</translation>
    </message>
    <message>
        <source>Rows: whose picture was shown. Columns: what was seen in it.</source>
        <translation>Zeilen: wessen Bild gezeigt wurde. Spalten: was darin gesehen wurde.</translation>
    </message>
    <message>
        <source>All that have several views are found well.</source>
        <translation>Alle mit mehreren Ansichten werden gut gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s) cannot be tried: there is only one view. Add another.</source>
        <translation>
            <numerusform>%n Landmarke lässt sich nicht prüfen: Es gibt nur eine Ansicht. Fügen Sie eine weitere hinzu.</numerusform>
            <numerusform>%n Landmarken lassen sich nicht prüfen: Es gibt nur eine Ansicht. Fügen Sie eine weitere hinzu.</numerusform>
        </translation>
    </message>
    <message>
        <source>The photographs of the chosen landmark are shown here.</source>
        <translation>Hier erscheinen die Fotos der gewählten Landmarke.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LivePage</name>
    <message>
        <source>What was said</source>
        <translation>Was gesagt wurde</translation>
    </message>
    <message>
        <source>Where it could be</source>
        <translation>Wo es sein könnte</translation>
    </message>
    <message>
        <source>Every sentence, when it was due, and what became of it</source>
        <translation>Jeder Satz, wann er fällig war und was aus ihm wurde</translation>
    </message>
    <message>
        <source>The places that fit what was seen, best first</source>
        <translation>Die Orte, die zum Gesehenen passen, die besten zuerst</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Zuletzt gesehen</translation>
    </message>
    <message>
        <source>The last objects that the place is worked out from</source>
        <translation>Die letzten Gegenstände, aus denen der Ort folgt</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>Im Bild</translation>
    </message>
    <message>
        <source>Everything recognised in the picture shown</source>
        <translation>Alles, was im gezeigten Bild erkannt wurde</translation>
    </message>
    <message>
        <source>On this floor</source>
        <translation>Auf diesem Stockwerk</translation>
    </message>
    <message>
        <source>The map as a list; press Enter on a place to go there</source>
        <translation>Die Karte als Liste; Eingabe auf einem Ort führt dorthin</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>Listen</translation>
    </message>
    <message>
        <source>Why there</source>
        <translation>Warum dort</translation>
    </message>
    <message>
        <source>What the vote of the chosen place is made of, and what speaks for it</source>
        <translation>Woraus die Stimme für den gewählten Ort besteht und was für ihn spricht</translation>
    </message>
    <message>
        <source>Nothing has been said yet.</source>
        <translation>Es wurde noch nichts gesagt.</translation>
    </message>
    <message>
        <source>Nothing has been worked out yet.</source>
        <translation>Es wurde noch nichts berechnet.</translation>
    </message>
    <message>
        <source>As soon as there is a place, what speaks for it stands here.</source>
        <translation>Sobald es einen Ort gibt, steht hier, was für ihn spricht.</translation>
    </message>
    <message>
        <source>Nothing has been recognised yet.</source>
        <translation>Es wurde noch nichts erkannt.</translation>
    </message>
    <message>
        <source>Nothing is recognised in the picture.</source>
        <translation>Im Bild ist nichts erkannt.</translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>Es ist keine Karte geöffnet.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LocaliserMenu</name>
    <message>
        <source>&amp;How the place is worked out</source>
        <translation>Wie der &amp;Ort gefunden wird</translation>
    </message>
    <message>
        <source>Filter, for people who are &amp;guided</source>
        <translation>Filter, für &amp;geführte Personen</translation>
    </message>
    <message>
        <source>Filter, for people who &amp;know their way</source>
        <translation>Filter, für &amp;Ortskundige</translation>
    </message>
    <message>
        <source>&amp;Voting</source>
        <translation>Ab&amp;stimmung</translation>
    </message>
    <message>
        <source>Voting as first &amp;printed</source>
        <translation>Abstimmung wie zuerst ge&amp;druckt</translation>
    </message>
    <message>
        <source>From the next start of a walk</source>
        <translation>Ab dem nächsten Start einer Begehung</translation>
    </message>
</context>
<context>
    <name>farol::ui::MainWindow</name>
    <message>
        <source>About Farol</source>
        <translation>Über Farol</translation>
    </message>
    <message>
        <source>Farol %1

Guides a blind person through a building with one ordinary camera: it recognises what it was taught, works out the place, and speaks the way.</source>
        <translation>Farol %1

Führt einen blinden Menschen mit einer gewöhnlichen Kamera durch ein Gebäude: Es erkennt, was ihm gezeigt wurde, findet den Ort und sagt den Weg an.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Walking</source>
        <translation>Begehung läuft</translation>
    </message>
    <message>
        <source>The walk has ended</source>
        <translation>Die Begehung ist zu Ende</translation>
    </message>
    <message>
        <source>The walk could not go on</source>
        <translation>Die Begehung konnte nicht weitergehen</translation>
    </message>
    <message>
        <source>Loading…</source>
        <translation>Lädt…</translation>
    </message>
    <message>
        <source>recorded in %1</source>
        <translation>aufgenommen in %1</translation>
    </message>
    <message>
        <source>The walk has ended: there are no more pictures.</source>
        <translation>Die Begehung ist zu Ende: Es gibt keine Bilder mehr.</translation>
    </message>
    <message>
        <source>Play &amp;again</source>
        <translation>&amp;Noch einmal abspielen</translation>
    </message>
    <message>
        <source>Open another &amp;map…</source>
        <translation>Andere &amp;Karte öffnen…</translation>
    </message>
    <message>
        <source>Open another &amp;library…</source>
        <translation>Andere &amp;Bibliothek öffnen…</translation>
    </message>
    <message>
        <source>Open other &amp;pictures…</source>
        <translation>Andere B&amp;ilder öffnen…</translation>
    </message>
    <message>
        <source>The walk will be recorded from its next start.</source>
        <translation>Die Begehung wird ab ihrem nächsten Start aufgenommen.</translation>
    </message>
    <message>
        <source>This walk is recorded to its end; the next one is not.</source>
        <translation>Diese Begehung wird bis zum Ende aufgenommen, die nächste nicht.</translation>
    </message>
    <message>
        <source>Start &amp;again now</source>
        <translation>Jetzt &amp;neu beginnen</translation>
    </message>
    <message>
        <source>Open a map</source>
        <translation>Karte öffnen</translation>
    </message>
    <message>
        <source>Maps (%1);;All files (%2)</source>
        <translation>Karten (%1);;Alle Dateien (%2)</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Landmarkenbibliothek öffnen</translation>
    </message>
    <message>
        <source>Landmark libraries (%1);;All files (%2)</source>
        <translation>Landmarkenbibliotheken (%1);;Alle Dateien (%2)</translation>
    </message>
    <message>
        <source>Farol</source>
        <translation>Farol</translation>
    </message>
    <message>
        <source>%1 – Farol</source>
        <translation>%1 – Farol</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Begehung</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>State of the walk</source>
        <translation>Stand der Begehung</translation>
    </message>
    <message>
        <source>Something is being loaded</source>
        <translation>Etwas wird geladen</translation>
    </message>
    <message>
        <source>&amp;Next visitor now</source>
        <translation>&amp;Nächster Besucher jetzt</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Watch a walk, work on a map, or teach landmarks (Ctrl+1 to Ctrl+3)</source>
        <translation>Eine Begehung verfolgen, an einer Karte arbeiten oder Landmarken beibringen (Strg+1 bis Strg+3)</translation>
    </message>
    <message>
        <source>The landmark library was changed on the Landmarks page.</source>
        <translation>Die Landmarkenbibliothek wurde auf der Seite Landmarken geändert.</translation>
    </message>
    <message>
        <source>Start &amp;again with it</source>
        <translation>&amp;Neu beginnen damit</translation>
    </message>
    <message>
        <source>Changes are not saved</source>
        <translation>Änderungen sind nicht gespeichert</translation>
    </message>
    <message>
        <source>The landmark library could not be written; its last changes would be lost.</source>
        <translation>Die Landmarkenbibliothek konnte nicht geschrieben werden; ihre letzten Änderungen gingen verloren.</translation>
    </message>
    <message>
        <source>&amp;Leave all the same</source>
        <translation>&amp;Trotzdem verlassen</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>&amp;Bleiben</translation>
    </message>
    <message>
        <source>Saved in %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>There is no walk to correct.</source>
        <translation>Es gibt keine Begehung zu berichtigen.</translation>
    </message>
    <message>
        <source>Choose a place on the map, or in the list “Where it could be”, first.</source>
        <translation>Wählen Sie zuerst einen Ort auf der Karte oder in der Liste „Wo es sein könnte“.</translation>
    </message>
    <message>
        <source>The user is in %1: told by you.</source>
        <translation>Der Benutzer ist bei %1: von Ihnen gesagt.</translation>
    </message>
    <message>
        <source>The place is given up and looked for anew.</source>
        <translation>Der Ort wird aufgegeben und neu gesucht.</translation>
    </message>
    <message>
        <source>Say this</source>
        <translation>Dies sagen</translation>
    </message>
    <message>
        <source>Sentence that is spoken to the user:</source>
        <translation>Satz, der dem Benutzer gesagt wird:</translation>
    </message>
    <message>
        <source>&amp;Say it</source>
        <translation>&amp;Sagen</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Save the walk as table</source>
        <translation>Begehung als Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (%1)</source>
        <translation>Tabellen (%1)</translation>
    </message>
    <message>
        <source>Open as &amp;map</source>
        <translation>Als &amp;Karte öffnen</translation>
    </message>
    <message>
        <source>Open as landmark &amp;library</source>
        <translation>Als Landmarken&amp;bibliothek öffnen</translation>
    </message>
    <message>
        <source>The file of this map was changed.</source>
        <translation>Die Datei dieser Karte wurde geändert.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>Neu &amp;laden</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapActions</name>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Karte</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>Karte ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open the map of a building to look at it and change it</source>
        <translation>Die Karte eines Gebäudes öffnen, um sie anzusehen und zu ändern</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Bring in a map of another kind</source>
        <translation>Eine Karte anderer Art übernehmen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Write the changes into the map&apos;s file</source>
        <translation>Die Änderungen in die Datei der Karte schreiben</translation>
    </message>
    <message>
        <source>S&amp;ave as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Write the map into another file</source>
        <translation>Die Karte in eine andere Datei schreiben</translation>
    </message>
    <message>
        <source>&amp;Print as PDF…</source>
        <translation>Als PDF &amp;drucken…</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Write the plan of each level as a page of a PDF</source>
        <translation>Den Plan jeder Ebene als Seite eines PDF schreiben</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Make the change again that was taken back</source>
        <translation>Die zurückgenommene Änderung wieder vornehmen</translation>
    </message>
    <message>
        <source>Add &amp;landmark</source>
        <translation>&amp;Landmarke hinzufügen</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>Put a new landmark on the plan</source>
        <translation>Eine neue Landmarke in den Plan setzen</translation>
    </message>
    <message>
        <source>Add &amp;door or passage</source>
        <translation>&amp;Tür oder Durchgang hinzufügen</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Tür</translation>
    </message>
    <message>
        <source>Put a new door or passage on the plan</source>
        <translation>Eine neue Tür oder einen Durchgang in den Plan setzen</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>Ä&amp;ndern…</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Change name, kind and the like of what is chosen</source>
        <translation>Name, Art und anderes des Gewählten ändern</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>L&amp;öschen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Take the chosen landmark, door or passage off the map</source>
        <translation>Die gewählte Landmarke, Tür oder den Durchgang aus der Karte nehmen</translation>
    </message>
    <message>
        <source>Route &amp;from here</source>
        <translation>Weg &amp;von hier</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>Von hier</translation>
    </message>
    <message>
        <source>Let the route begin in the chosen place</source>
        <translation>Den Weg am gewählten Ort beginnen lassen</translation>
    </message>
    <message>
        <source>Route &amp;to here</source>
        <translation>Weg &amp;hierher</translation>
    </message>
    <message>
        <source>To here</source>
        <translation>Hierher</translation>
    </message>
    <message>
        <source>Let the route end in the chosen place</source>
        <translation>Den Weg am gewählten Ort enden lassen</translation>
    </message>
    <message>
        <source>Sea&amp;rch the table</source>
        <translation>Tabelle dur&amp;chsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the table of attributes</source>
        <translation>In der Attributtabelle suchen</translation>
    </message>
    <message>
        <source>C&amp;heck the map</source>
        <translation>Karte &amp;prüfen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Look for what is wrong with the map as it is now</source>
        <translation>Suchen, was an der Karte jetzt nicht stimmt</translation>
    </message>
    <message>
        <source>&amp;Next feature</source>
        <translation>Nächstes &amp;Objekt</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächstes</translation>
    </message>
    <message>
        <source>Show the next feature of the chosen finding</source>
        <translation>Das nächste Objekt des gewählten Befunds zeigen</translation>
    </message>
    <message>
        <source>Places that look ali&amp;ke</source>
        <translation>Orte, die &amp;gleich aussehen</translation>
    </message>
    <message>
        <source>Alike</source>
        <translation>Gleiche</translation>
    </message>
    <message>
        <source>Mark the places that the landmarks cannot tell apart, and those without any</source>
        <translation>Orte markieren, die die Landmarken nicht unterscheiden, und solche ohne Landmarken</translation>
    </message>
    <message>
        <source>&amp;Walk with this map</source>
        <translation>Mit dieser Karte &amp;begehen</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Begehung</translation>
    </message>
    <message>
        <source>Use the saved map on the Walk page</source>
        <translation>Die gespeicherte Karte auf der Seite Begehung verwenden</translation>
    </message>
    <message>
        <source>Where landmarks are see&amp;n</source>
        <translation>Wo L&amp;andmarken zu sehen sind</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Mark from where landmarks can be seen, and from where none can</source>
        <translation>Markieren, von wo Landmarken zu sehen sind und von wo keine</translation>
    </message>
    <message>
        <source>&amp;Missing routes…</source>
        <translation>&amp;Fehlende Wege…</translation>
    </message>
    <message>
        <source>Missing routes</source>
        <translation>Fehlende Wege</translation>
    </message>
    <message>
        <source>List the places between which no route leads, and why</source>
        <translation>Die Orte auflisten, zwischen denen kein Weg führt, und warum</translation>
    </message>
    <message>
        <source>Floor-plan ima&amp;ge…</source>
        <translation>Bild d&amp;es Grundrisses…</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Lay the image of a floor plan under the floor that is shown</source>
        <translation>Das Bild eines Grundrisses unter das gezeigte Stockwerk legen</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapDocument</name>
    <message>
        <source>Load the map again</source>
        <translation>Karte neu laden</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapPage</name>
    <message>
        <source>Saved in %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
    <message>
        <source>Open a map</source>
        <translation>Karte öffnen</translation>
    </message>
    <message>
        <source>Maps (%1);;All files (%2)</source>
        <translation>Karten (%1);;Alle Dateien (%2)</translation>
    </message>
    <message>
        <source>Save the map</source>
        <translation>Karte speichern</translation>
    </message>
    <message>
        <source>Maps (%1)</source>
        <translation>Karten (%1)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The map has changes that are not saved.</source>
        <translation>Die Karte hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Save them first?</source>
        <translation>Zuerst speichern?</translation>
    </message>
    <message>
        <source>Imported from %1. Look at what was found, then save it as a map of Farol.</source>
        <translation>Importiert aus %1. Sehen Sie sich die Befunde an, dann speichern Sie sie als Karte von Farol.</translation>
    </message>
    <message>
        <source>Sa&amp;ve…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>The map is being opened…</source>
        <translation>Die Karte wird geöffnet…</translation>
    </message>
    <message>
        <source>The map is being imported and checked…</source>
        <translation>Die Karte wird importiert und geprüft…</translation>
    </message>
    <message>
        <source>The map is being saved…</source>
        <translation>Die Karte wird gespeichert…</translation>
    </message>
    <message>
        <source>The map is being checked…</source>
        <translation>Die Karte wird geprüft…</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Parts of the map</source>
        <translation>Teile der Karte</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>Give up; the map that was open stays</source>
        <translation>Aufgeben; die geöffnete Karte bleibt</translation>
    </message>
    <message>
        <source>Click where the landmark stands, or move the plan under the cross with the arrows and press Enter. Escape gives up.</source>
        <translation>Klicken Sie auf den Ort der Landmarke, oder schieben Sie den Plan mit den Pfeilen unter das Kreuz und drücken Sie Eingabe. Escape bricht ab.</translation>
    </message>
    <message>
        <source>Click where the door is, or move the plan under the cross with the arrows and press Enter. Escape gives up.</source>
        <translation>Klicken Sie auf den Ort der Tür, oder schieben Sie den Plan mit den Pfeilen unter das Kreuz und drücken Sie Eingabe. Escape bricht ab.</translation>
    </message>
    <message>
        <source>Add a landmark</source>
        <translation>Landmarke hinzufügen</translation>
    </message>
    <message>
        <source>Add a door</source>
        <translation>Tür hinzufügen</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Deleted: %1. Ctrl+Z brings it back.</source>
        <translation>Gelöscht: %1. Strg+Z holt es zurück.</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message>
        <source>Print the plan</source>
        <translation>Plan drucken</translation>
    </message>
    <message>
        <source>PDF (%1)</source>
        <translation>PDF (%1)</translation>
    </message>
    <message>
        <source>Printed in %1</source>
        <translation>Gedruckt in %1</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Open the map on which the landmark shall stand.</source>
        <translation>Öffnen Sie die Karte, auf der die Landmarke stehen soll.</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>Karte ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map. You have changes of your own: loading it again puts them aside, and Ctrl+Z brings them back.</source>
        <translation>Ein anderes Programm hat die Datei dieser Karte geändert. Sie haben eigene Änderungen: Neu laden legt sie beiseite, und Strg+Z holt sie zurück.</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map.</source>
        <translation>Ein anderes Programm hat die Datei dieser Karte geändert.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>Neu &amp;laden</translation>
    </message>
    <message>
        <source>The file %1 is no longer there. The map stays open here: save it, or it is lost when you leave.</source>
        <translation>Die Datei %1 ist nicht mehr da. Die Karte bleibt hier offen: Speichern Sie sie, sonst ist sie beim Beenden verloren.</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map, and it cannot be read any more (%1). The map stays open here as it was: save it under another name.</source>
        <translation>Ein anderes Programm hat die Datei dieser Karte geändert, und sie ist nicht mehr lesbar (%1). Die Karte bleibt hier offen, wie sie war: Speichern Sie sie unter einem anderen Namen.</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Noch nicht gespeichert</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map since it was read here.</source>
        <translation>Ein anderes Programm hat die Datei dieser Karte geändert, seit sie hier gelesen wurde.</translation>
    </message>
    <message>
        <source>Saving over it would lose what that program wrote.</source>
        <translation>Darüber zu speichern würde verlieren, was jenes Programm geschrieben hat.</translation>
    </message>
    <message>
        <source>Save under &amp;another name…</source>
        <translation>Unter &amp;anderem Namen speichern…</translation>
    </message>
    <message>
        <source>Save &amp;over it</source>
        <translation>&amp;Darüber speichern</translation>
    </message>
    <message>
        <source>Floor-plan image</source>
        <translation>Bild des Grundrisses</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (%2)</source>
        <translation>Bilder (%1);;Alle Dateien (%2)</translation>
    </message>
    <message>
        <source>No landmark is seen from %1 % of the floors.</source>
        <translation>Von %1 % der Stockwerke aus ist keine Landmarke zu sehen.</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapPanel</name>
    <message>
        <source>No map is open.</source>
        <translation>Es ist keine Karte geöffnet.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) on the map.</source>
        <translation>
            <numerusform>Ein Ort auf der Karte.</numerusform>
            <numerusform>%n Orte auf der Karte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Where you are is not known yet.</source>
        <translation>Es ist noch nicht bekannt, wo Sie sind.</translation>
    </message>
    <message>
        <source>You are in %1, %2: %3.</source>
        <translation>Sie sind hier: %1, %2: %3.</translation>
    </message>
    <message>
        <source>You are in %1: %2.</source>
        <translation>Sie sind hier: %1: %2.</translation>
    </message>
    <message>
        <source>&amp;Go to %1</source>
        <translation>&amp;Gehe zu: %1</translation>
    </message>
    <message>
        <source>&amp;Start at %1</source>
        <translation>&amp;Beginne bei: %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>&amp;Level:</source>
        <translation>&amp;Ebene:</translation>
    </message>
    <message>
        <source>Level of the map</source>
        <translation>Ebene der Karte</translation>
    </message>
    <message>
        <source>The floor that the map shows (Page Up and Page Down in the map)</source>
        <translation>Das Stockwerk, das die Karte zeigt (Bild auf und Bild ab in der Karte)</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>&amp;Folgen</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Switch to the floor where you are whenever it changes</source>
        <translation>Zum Stockwerk wechseln, auf dem Sie sind, sobald es sich ändert</translation>
    </message>
    <message>
        <source>Larger (+)</source>
        <translation>Größer (+)</translation>
    </message>
    <message>
        <source>Smaller (-)</source>
        <translation>Kleiner (-)</translation>
    </message>
    <message>
        <source>Show the whole floor (0)</source>
        <translation>Das ganze Stockwerk zeigen (0)</translation>
    </message>
    <message>
        <source>Floor map</source>
        <translation>Karte des Stockwerks</translation>
    </message>
    <message>
        <source>Drag to move, turn the wheel to zoom, double-click a place to go there</source>
        <translation>Ziehen zum Verschieben, Rad drehen zum Vergrößern, Doppelklick auf einen Ort, um dorthin zu gehen</translation>
    </message>
    <message>
        <source>Taken to be in %1: %2. Really in %3.</source>
        <translation>Angenommen bei %1: %2. Wirklich bei %3.</translation>
    </message>
    <message>
        <source>The user &amp;is here, in %1</source>
        <translation>Der Benutzer &amp;ist hier: %1</translation>
    </message>
    <message>
        <source>The assistant had said: %1.</source>
        <translation>Der Begleiter hatte gesagt: %1.</translation>
    </message>
    <message>
        <source>said by the assistant</source>
        <translation>vom Begleiter gesagt</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapView</name>
    <message>
        <source>Less likely</source>
        <translation>Weniger wahrscheinlich</translation>
    </message>
    <message>
        <source>More likely</source>
        <translation>Wahrscheinlicher</translation>
    </message>
    <message>
        <source>No map is open.
Open one with Ctrl+O.</source>
        <translation>Es ist keine Karte geöffnet.
Öffnen Sie eine mit Strg+O.</translation>
    </message>
</context>
<context>
    <name>farol::ui::MissingDialog</name>
    <message>
        <source>&amp;Show on the plan</source>
        <translation>Im Plan &amp;zeigen</translation>
    </message>
    <message>
        <source>Missing routes</source>
        <translation>Fehlende Wege</translation>
    </message>
    <message>
        <source>Looking for the way between all places…</source>
        <translation>Die Wege zwischen allen Orten werden gesucht…</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Es fehlt</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Places between which no route leads; Enter shows the chosen one on the plan</source>
        <translation>Orte, zwischen denen kein Weg führt; Eingabe zeigt den gewählten im Plan</translation>
    </message>
    <message>
        <source>Show on the plan</source>
        <translation>Im Plan zeigen</translation>
    </message>
    <message>
        <source>Choose both places on the Map page, and see them on the plan</source>
        <translation>Beide Orte auf der Seite Karte wählen und im Plan sehen</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more place(s)</source>
        <translation>
            <numerusform>%1 und %n weiterer Ort</numerusform>
            <numerusform>%1 und %n weitere Orte</numerusform>
        </translation>
    </message>
    <message>
        <source>From every place there is a route to every other one (%1 pairs of places).</source>
        <translation>Von jedem Ort führt ein Weg zu jedem anderen (%1 Paare von Orten).</translation>
    </message>
    <message>
        <source>Of %1 pairs of places, %2 have no route.</source>
        <translation>Von %1 Paaren von Orten haben %2 keinen Weg.</translation>
    </message>
    <message numerus="yes">
        <source>%n more line(s) are not listed: mend these first.</source>
        <translation>
            <numerusform>%n weitere Zeile ist nicht aufgeführt: Beheben Sie zuerst diese.</numerusform>
            <numerusform>%n weitere Zeilen sind nicht aufgeführt: Beheben Sie zuerst diese.</numerusform>
        </translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>hin und zurück</translation>
    </message>
    <message>
        <source>this way</source>
        <translation>nur hin</translation>
    </message>
</context>
<context>
    <name>farol::ui::NoRouteWords</name>
    <message>
        <source>stairs</source>
        <translation>Treppen</translation>
    </message>
    <message>
        <source>a lift</source>
        <translation>ein Aufzug</translation>
    </message>
    <message>
        <source>an escalator</source>
        <translation>eine Rolltreppe</translation>
    </message>
    <message>
        <source>a moving walkway</source>
        <translation>ein Fahrsteig</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>eine Rampe</translation>
    </message>
    <message>
        <source>a narrow door</source>
        <translation>eine schmale Tür</translation>
    </message>
    <message>
        <source>a restricted region</source>
        <translation>ein nicht öffentlicher Bereich</translation>
    </message>
    <message>
        <source>a closed door or passage</source>
        <translation>eine geschlossene Tür oder Passage</translation>
    </message>
    <message>
        <source>a one-way door or passage</source>
        <translation>eine Tür oder Passage nur für die andere Richtung</translation>
    </message>
    <message>
        <source>%1 (from %2 to %3)</source>
        <translation>%1 (von %2 nach %3)</translation>
    </message>
    <message>
        <source>The map joins %1 and %2 in no way.</source>
        <translation>Die Karte verbindet %1 und %2 durch nichts.</translation>
    </message>
    <message>
        <source>%1 is reached only by what is to be avoided: %2.</source>
        <translation>%1 ist nur über das zu erreichen, was gemieden werden soll: %2.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>On the way to %1 stands %2.</source>
        <translation>Auf dem Weg nach %1 steht: %2.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
</context>
<context>
    <name>farol::ui::OptionFields</name>
    <message>
        <source>Announce what comes within</source>
        <translation>Ankündigen, was näher ist als</translation>
    </message>
    <message>
        <source>Say “now” within</source>
        <translation>„Jetzt“ sagen, wenn es näher ist als</translation>
    </message>
    <message>
        <source>Reassure every</source>
        <translation>Bestätigen alle</translation>
    </message>
    <message>
        <source>Reassure, where no distance is known, every</source>
        <translation>Bestätigen, wo keine Entfernung bekannt ist, alle</translation>
    </message>
    <message>
        <source>Repeat an instruction after</source>
        <translation>Eine Anweisung wiederholen nach</translation>
    </message>
    <message>
        <source>Tell an object again after</source>
        <translation>Einen Gegenstand wieder nennen nach</translation>
    </message>
    <message>
        <source>Say that the place is not known after</source>
        <translation>Sagen, dass der Ort nicht bekannt ist, nach</translation>
    </message>
    <message>
        <source>Say again that the route was left after</source>
        <translation>Wieder sagen, dass der Weg verlassen ist, nach</translation>
    </message>
    <message>
        <source>Avoid stairs</source>
        <translation>Treppen vermeiden</translation>
    </message>
    <message>
        <source>Avoid lifts</source>
        <translation>Aufzüge vermeiden</translation>
    </message>
    <message>
        <source>Avoid escalators</source>
        <translation>Rolltreppen vermeiden</translation>
    </message>
    <message>
        <source>Avoid moving walkways</source>
        <translation>Rollsteige vermeiden</translation>
    </message>
    <message>
        <source>Avoid ramps</source>
        <translation>Rampen vermeiden</translation>
    </message>
    <message>
        <source>Avoid narrow doors</source>
        <translation>Schmale Türen vermeiden</translation>
    </message>
    <message>
        <source>Avoid restricted places</source>
        <translation>Eingeschränkte Orte vermeiden</translation>
    </message>
    <message>
        <source>Walking speed</source>
        <translation>Gehgeschwindigkeit</translation>
    </message>
    <message>
        <source>Time to find and pass a door</source>
        <translation>Zeit, eine Tür zu finden und zu durchqueren</translation>
    </message>
    <message>
        <source>Time for the stairs of a level</source>
        <translation>Zeit für die Treppe einer Ebene</translation>
    </message>
    <message>
        <source>Time to wait for a lift and ride it</source>
        <translation>Zeit, auf einen Aufzug zu warten und zu fahren</translation>
    </message>
    <message>
        <source>Points that must fit an object</source>
        <translation>Punkte, die zu einem Gegenstand passen müssen</translation>
    </message>
    <message>
        <source>Evidence that an object needs</source>
        <translation>Hinweise, die ein Gegenstand braucht</translation>
    </message>
    <message>
        <source>Points that must fit a known place</source>
        <translation>Punkte, die zu einem bekannten Ort passen müssen</translation>
    </message>
    <message>
        <source>Sharpness that a picture needs</source>
        <translation>Schärfe, die ein Bild braucht</translation>
    </message>
</context>
<context>
    <name>farol::ui::OptionForm</name>
    <message>
        <source>&amp;Defaults</source>
        <translation>&amp;Vorgaben</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Take every figure of this page back to what the program has</source>
        <translation>Alle Werte dieser Seite auf die des Programms zurücksetzen</translation>
    </message>
    <message>
        <source>Usually %1</source>
        <translation>Üblich: %1</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
</context>
<context>
    <name>farol::ui::OutlineView</name>
    <message>
        <source>No picture yet</source>
        <translation>Noch kein Bild</translation>
    </message>
    <message>
        <source>The whole picture counts</source>
        <translation>Das ganze Bild zählt</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>Corner %1, %2, is %3 to the right and %4 down</source>
        <translation>Ecke %1, %2, liegt %3 nach rechts und %4 nach unten</translation>
    </message>
</context>
<context>
    <name>farol::ui::Phrasebook</name>
    <message>
        <source>I read: %1. %2.</source>
        <extracomment>%1 what is written there, %2 &quot;left, up&quot;</extracomment>
        <translation>Ich lese: %1. %2.</translation>
    </message>
    <message>
        <source>I have found the way.</source>
        <translation>Ich habe den Weg gefunden.</translation>
    </message>
    <message>
        <source>Destination: %1.</source>
        <translation>Ziel: %1.</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Dann</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Zuerst</translation>
    </message>
    <message>
        <source>First, probably</source>
        <translation>Wahrscheinlich als Erstes</translation>
    </message>
    <message>
        <source>Start slowly: I will tell you if it is the wrong way.</source>
        <translation>Beginnen Sie langsam: Ich sage es, wenn es die falsche Richtung ist.</translation>
    </message>
    <message>
        <source>Probably %1 first.</source>
        <extracomment>%1 &quot;turn left&quot;, &quot;turn around&quot;</extracomment>
        <translation>Wahrscheinlich zuerst: %1.</translation>
    </message>
    <message>
        <source>Soon</source>
        <translation>Bald</translation>
    </message>
    <message>
        <source>Soon, probably</source>
        <translation>Wahrscheinlich schon bald</translation>
    </message>
    <message>
        <source>Keep moving forward. You are probably going the right way.</source>
        <translation>Gehen Sie weiter geradeaus. Sie sind wahrscheinlich auf dem richtigen Weg.</translation>
    </message>
    <message>
        <source>Keep moving forward.</source>
        <translation>Gehen Sie weiter geradeaus.</translation>
    </message>
    <message>
        <source>Now turn slowly to the left, past where you began.</source>
        <translation>Drehen Sie sich jetzt langsam nach links, über den Anfang hinaus.</translation>
    </message>
    <message>
        <source>Hold still, and tilt the camera slowly up.</source>
        <translation>Bleiben Sie ruhig stehen und neigen Sie die Kamera langsam nach oben.</translation>
    </message>
    <message>
        <source>Now tilt it slowly down.</source>
        <translation>Neigen Sie sie jetzt langsam nach unten.</translation>
    </message>
    <message>
        <source>I still do not know where you are. If you can, move a few steps along a wall, or ask for help.</source>
        <translation>Ich weiß immer noch nicht, wo Sie sind. Gehen Sie, wenn möglich, ein paar Schritte an einer Wand entlang, oder bitten Sie um Hilfe.</translation>
    </message>
    <message>
        <source>Thank you, that is enough.</source>
        <translation>Danke, das genügt.</translation>
    </message>
    <message>
        <source>I am not sure where you are. Stop, and turn slowly to the right, so that I can look around.</source>
        <translation>Ich bin nicht sicher, wo Sie sind. Bleiben Sie stehen und drehen Sie sich langsam nach rechts, damit ich mich umsehen kann.</translation>
    </message>
    <message>
        <source>You have arrived.</source>
        <translation>Sie sind angekommen.</translation>
    </message>
    <message>
        <source>You have probably arrived.</source>
        <translation>Sie sind wahrscheinlich angekommen.</translation>
    </message>
    <message>
        <source>You have arrived: %1.</source>
        <translation>Sie sind angekommen: %1.</translation>
    </message>
    <message>
        <source>You have probably arrived: %1.</source>
        <translation>Sie sind wahrscheinlich angekommen: %1.</translation>
    </message>
    <message>
        <source>You are walking the wrong way.</source>
        <translation>Sie gehen in die falsche Richtung.</translation>
    </message>
    <message>
        <source>You are probably walking the wrong way.</source>
        <translation>Sie gehen wahrscheinlich in die falsche Richtung.</translation>
    </message>
    <message>
        <source>You have gone too far.</source>
        <translation>Sie sind zu weit gegangen.</translation>
    </message>
    <message>
        <source>You have probably gone too far.</source>
        <translation>Sie sind wahrscheinlich zu weit gegangen.</translation>
    </message>
    <message>
        <source>You have left the route.</source>
        <translation>Sie haben den Weg verlassen.</translation>
    </message>
    <message>
        <source>You have probably left the route.</source>
        <translation>Sie haben wahrscheinlich den Weg verlassen.</translation>
    </message>
    <message>
        <source>Stop. I know no way from here.</source>
        <translation>Halt. Ich kenne keinen Weg von hier.</translation>
    </message>
    <message>
        <source>Stop for a moment.</source>
        <translation>Bleiben Sie einen Moment stehen.</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>Von hier aus</translation>
    </message>
    <message>
        <source>From here, probably</source>
        <translation>Wahrscheinlich von hier aus</translation>
    </message>
    <message>
        <source>I do not know yet where you are.</source>
        <translation>Ich weiß noch nicht, wo Sie sind.</translation>
    </message>
    <message>
        <source>You are here: %1.</source>
        <translation>Sie sind hier: %1.</translation>
    </message>
    <message>
        <source>You are probably here, or next to it: %1.</source>
        <translation>Sie sind wahrscheinlich hier oder gleich daneben: %1.</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>down</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <extracomment>%1 &quot;extinguisher&quot;, %2 &quot;left, down&quot;</extracomment>
        <translation>%1, %2.</translation>
    </message>
    <message>
        <source>perhaps: %1, %2.</source>
        <translation>vielleicht: %1, %2.</translation>
    </message>
    <message>
        <source>No destination is chosen yet. Choose one first.</source>
        <translation>Es ist noch kein Ziel gewählt. Wählen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>I do not know this destination. Choose another one.</source>
        <translation>Ich kenne dieses Ziel nicht. Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>I do not know this destination: %1. Choose another one.</source>
        <translation>Ich kenne dieses Ziel nicht: %1. Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>I know no way to your destination. Choose another one, or ask for help.</source>
        <translation>Ich kenne keinen Weg zu Ihrem Ziel. Wählen Sie ein anderes oder bitten Sie um Hilfe.</translation>
    </message>
    <message>
        <source>I know no way to: %1. Choose another destination, or ask for help.</source>
        <translation>Ich kenne keinen Weg zu diesem Ziel: %1. Wählen Sie ein anderes oder bitten Sie um Hilfe.</translation>
    </message>
    <message>
        <source>You are already there.</source>
        <translation>Sie sind schon am Ziel.</translation>
    </message>
    <message>
        <source>You are probably there already.</source>
        <translation>Sie sind wahrscheinlich schon am Ziel.</translation>
    </message>
    <message>
        <source>You are already there: %1.</source>
        <translation>Sie sind schon am Ziel: %1.</translation>
    </message>
    <message>
        <source>You are probably there already: %1.</source>
        <translation>Sie sind wahrscheinlich schon am Ziel: %1.</translation>
    </message>
    <message>
        <source>near you</source>
        <translation>in Ihrer Nähe</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>what is around</comment>
        <extracomment>%1 &quot;a door&quot;, %2 a name</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>I know of nothing near you.</source>
        <translation>Ich kenne nichts in Ihrer Nähe.</translation>
    </message>
    <message>
        <source>The directions are as you face along your way.</source>
        <translation>Die Richtungen gelten mit Blick entlang Ihres Weges.</translation>
    </message>
    <message>
        <source>The directions are those of the map.</source>
        <translation>Die Richtungen sind die der Karte.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what is around</comment>
        <extracomment>%1 &quot;on your left&quot;, %2 &quot;a door, Library; an extinguisher&quot;</extracomment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Stop. The camera gives no picture, and I cannot guide you.</source>
        <translation>Halt. Die Kamera gibt kein Bild, ich kann Sie nicht führen.</translation>
    </message>
    <message>
        <source>The camera works again.</source>
        <translation>Die Kamera geht wieder.</translation>
    </message>
    <message>
        <source>The recording has stopped. I keep guiding you.</source>
        <translation>Die Aufnahme ist abgebrochen. Ich führe Sie weiter.</translation>
    </message>
    <message>
        <source>Stop. I cannot see. Please uncover the camera.</source>
        <translation>Halt. Ich kann nichts sehen. Bitte decken Sie die Kamera auf.</translation>
    </message>
    <message>
        <source>One picture could not be used. I keep guiding you.</source>
        <translation>Ein Bild war nicht zu gebrauchen. Ich führe Sie weiter.</translation>
    </message>
    <message>
        <source>Stop. Something is wrong. Please ask for help.</source>
        <translation>Halt. Etwas stimmt nicht. Bitte holen Sie Hilfe.</translation>
    </message>
    <message numerus="yes">
        <source>About %n foot(feet).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Etwa ein Fuß.</numerusform>
            <numerusform>Etwa %n Fuß.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n step(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Etwa ein Schritt.</numerusform>
            <numerusform>Etwa %n Schritte.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n metre(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Etwa ein Meter.</numerusform>
            <numerusform>Etwa %n Meter.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n foot(feet)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>In etwa einem Fuß</numerusform>
            <numerusform>In etwa %n Fuß</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n step(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>In etwa einem Schritt</numerusform>
            <numerusform>In etwa %n Schritten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n metre(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>In etwa einem Meter</numerusform>
            <numerusform>In etwa %n Metern</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n foot(feet).</source>
        <translation>
            <numerusform>Gehen Sie etwa einen Fuß weiter geradeaus.</numerusform>
            <numerusform>Gehen Sie etwa %n Fuß weiter geradeaus.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n step(s).</source>
        <translation>
            <numerusform>Gehen Sie etwa einen Schritt weiter geradeaus.</numerusform>
            <numerusform>Gehen Sie etwa %n Schritte weiter geradeaus.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n metre(s).</source>
        <translation>
            <numerusform>Gehen Sie etwa einen Meter weiter geradeaus.</numerusform>
            <numerusform>Gehen Sie etwa %n Meter weiter geradeaus.</numerusform>
        </translation>
    </message>
    <message>
        <source>a door</source>
        <translation>eine Tür</translation>
    </message>
    <message>
        <source>an opening</source>
        <translation>eine Öffnung</translation>
    </message>
    <message>
        <source>stairs up</source>
        <translation>eine Treppe nach oben</translation>
    </message>
    <message>
        <source>stairs down</source>
        <translation>eine Treppe nach unten</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>Treppe</translation>
    </message>
    <message>
        <source>a lift</source>
        <translation>ein Aufzug</translation>
    </message>
    <message>
        <source>an escalator up</source>
        <translation>eine Rolltreppe nach oben</translation>
    </message>
    <message>
        <source>an escalator down</source>
        <translation>eine Rolltreppe nach unten</translation>
    </message>
    <message>
        <source>an escalator</source>
        <translation>eine Rolltreppe</translation>
    </message>
    <message>
        <source>a ramp up</source>
        <translation>eine Rampe nach oben</translation>
    </message>
    <message>
        <source>a ramp down</source>
        <translation>eine Rampe nach unten</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>eine Rampe</translation>
    </message>
    <message>
        <source>The stairs are %1.</source>
        <translation>Die Treppe ist %1.</translation>
    </message>
    <message>
        <source>The stairs are probably %1.</source>
        <translation>Die Treppe ist wahrscheinlich %1.</translation>
    </message>
    <message>
        <source>The lift is %1.</source>
        <translation>Der Aufzug ist %1.</translation>
    </message>
    <message>
        <source>The lift is probably %1.</source>
        <translation>Der Aufzug ist wahrscheinlich %1.</translation>
    </message>
    <message>
        <source>The escalator is %1.</source>
        <translation>Die Rolltreppe ist %1.</translation>
    </message>
    <message>
        <source>The escalator is probably %1.</source>
        <translation>Die Rolltreppe ist wahrscheinlich %1.</translation>
    </message>
    <message>
        <source>The ramp is %1.</source>
        <translation>Die Rampe ist %1.</translation>
    </message>
    <message>
        <source>The ramp is probably %1.</source>
        <translation>Die Rampe ist wahrscheinlich %1.</translation>
    </message>
    <message>
        <source>You are probably near the door.</source>
        <translation>Die Tür ist wahrscheinlich nah.</translation>
    </message>
    <message>
        <source>You are probably near the opening.</source>
        <translation>Die Öffnung ist wahrscheinlich nah.</translation>
    </message>
    <message>
        <source>Careful: you are probably near the stairs.</source>
        <translation>Vorsicht: Die Treppe ist wahrscheinlich nah.</translation>
    </message>
    <message>
        <source>You are probably near the lift.</source>
        <translation>Der Aufzug ist wahrscheinlich nah.</translation>
    </message>
    <message>
        <source>Careful: you are probably near the escalator.</source>
        <translation>Vorsicht: Die Rolltreppe ist wahrscheinlich nah.</translation>
    </message>
    <message>
        <source>You are probably near the ramp.</source>
        <translation>Die Rampe ist wahrscheinlich nah.</translation>
    </message>
    <message>
        <source>You are probably where you have to turn.</source>
        <translation>Sie müssen wahrscheinlich hier abbiegen.</translation>
    </message>
    <message>
        <source>take the stairs up</source>
        <translation>gehen Sie die Treppe hinauf</translation>
    </message>
    <message>
        <source>take the stairs down</source>
        <translation>gehen Sie die Treppe hinunter</translation>
    </message>
    <message>
        <source>take the stairs, but feel first whether they go up or down</source>
        <translation>nehmen Sie die Treppe, aber ertasten Sie zuerst, ob sie hinauf oder hinunter führt</translation>
    </message>
    <message>
        <source>take the lift up</source>
        <translation>fahren Sie mit dem Aufzug nach oben</translation>
    </message>
    <message>
        <source>take the lift down</source>
        <translation>fahren Sie mit dem Aufzug nach unten</translation>
    </message>
    <message>
        <source>take the lift</source>
        <translation>nehmen Sie den Aufzug</translation>
    </message>
    <message>
        <source>take the escalator up</source>
        <translation>fahren Sie mit der Rolltreppe nach oben</translation>
    </message>
    <message>
        <source>take the escalator down</source>
        <translation>fahren Sie mit der Rolltreppe nach unten</translation>
    </message>
    <message>
        <source>take the escalator, but feel first whether it goes up or down</source>
        <translation>nehmen Sie die Rolltreppe, aber ertasten Sie zuerst, ob sie hinauf oder hinunter führt</translation>
    </message>
    <message>
        <source>go up the ramp</source>
        <translation>gehen Sie die Rampe hinauf</translation>
    </message>
    <message>
        <source>go down the ramp</source>
        <translation>gehen Sie die Rampe hinunter</translation>
    </message>
    <message>
        <source>follow the ramp</source>
        <translation>folgen Sie der Rampe</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>vor Ihnen</translation>
    </message>
    <message>
        <source>next</source>
        <comment>door or opening</comment>
        <translation>nächste</translation>
    </message>
    <message>
        <source>get out of the lift</source>
        <translation>verlassen Sie den Aufzug</translation>
    </message>
    <message>
        <source>go into the lift</source>
        <translation>betreten Sie den Aufzug</translation>
    </message>
    <message>
        <source>go into the lift %1</source>
        <translation>betreten Sie den Aufzug %1</translation>
    </message>
    <message>
        <source>go straight on through two doors in a row</source>
        <translation>gehen Sie geradeaus durch zwei Türen hintereinander</translation>
    </message>
    <message>
        <source>go straight on through two openings in a row</source>
        <translation>gehen Sie geradeaus durch zwei Öffnungen hintereinander</translation>
    </message>
    <message>
        <source>go straight on through the door</source>
        <translation>gehen Sie geradeaus durch die Tür</translation>
    </message>
    <message>
        <source>go straight on through the opening</source>
        <translation>gehen Sie geradeaus durch die Öffnung</translation>
    </message>
    <message>
        <source>go through the door</source>
        <translation>gehen Sie durch die Tür</translation>
    </message>
    <message>
        <source>go through the opening</source>
        <translation>gehen Sie durch die Öffnung</translation>
    </message>
    <message>
        <source>go through the door %1</source>
        <translation>gehen Sie durch die Tür %1</translation>
    </message>
    <message>
        <source>go through the opening %1</source>
        <translation>gehen Sie durch die Öffnung %1</translation>
    </message>
    <message>
        <source>go through the %1 door %2</source>
        <translation>gehen Sie durch die %1 Tür %2</translation>
    </message>
    <message>
        <source>go through the %1 opening %2</source>
        <translation>gehen Sie durch die %1 Öffnung %2</translation>
    </message>
    <message>
        <source>follow the wall on your left and go through the opening</source>
        <translation>folgen Sie der Wand links von Ihnen und gehen Sie durch die Öffnung</translation>
    </message>
    <message>
        <source>follow the wall on your right and go through the opening</source>
        <translation>folgen Sie der Wand rechts von Ihnen und gehen Sie durch die Öffnung</translation>
    </message>
    <message>
        <source>follow the wall on your left and go through the %1 door</source>
        <extracomment>%1 &quot;second&quot;</extracomment>
        <translation>folgen Sie der Wand links von Ihnen und gehen Sie durch die %1 Tür</translation>
    </message>
    <message>
        <source>follow the wall on your right and go through the %1 door</source>
        <translation>folgen Sie der Wand rechts von Ihnen und gehen Sie durch die %1 Tür</translation>
    </message>
    <message>
        <source>%1, then %2</source>
        <extracomment>%1 &quot;go through the door&quot;, %2 &quot;turn left&quot;</extracomment>
        <translation>%1, dann %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 &quot;go through the door&quot;, %2 &quot;turning left&quot;</extracomment>
        <translation>%1, dabei %2</translation>
    </message>
    <message>
        <source>move forward</source>
        <translation>gehen Sie vorwärts</translation>
    </message>
    <message>
        <source>your destination</source>
        <translation>Ihr Ziel</translation>
    </message>
    <message>
        <source>stay in the lift</source>
        <translation>bleiben Sie im Aufzug</translation>
    </message>
    <message>
        <source>stay in the lift until: %1</source>
        <translation>bleiben Sie im Aufzug bis: %1</translation>
    </message>
    <message>
        <source>go straight on through the next door</source>
        <translation>gehen Sie geradeaus durch die nächste Tür</translation>
    </message>
    <message>
        <source>go straight on through the next opening</source>
        <translation>gehen Sie geradeaus durch die nächste Öffnung</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>what and where</comment>
        <extracomment>%1 &quot;a door&quot;, %2 &quot;on your left&quot;
----------
%1 &quot;after the extinguisher&quot;, %2 &quot;on your left&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>Ebene %1</translation>
    </message>
    <message>
        <source>minus %1</source>
        <translation>minus %1</translation>
    </message>
    <message>
        <source>It is a long flight.</source>
        <translation>Es sind viele Stufen.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s).</source>
        <translation>
            <numerusform>Eine Stufe.</numerusform>
            <numerusform>%n Stufen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: %1.</source>
        <translation>Danach: %1.</translation>
    </message>
    <message>
        <source>When you get out: %1.</source>
        <translation>Beim Aussteigen: %1.</translation>
    </message>
    <message>
        <source>At the top: %1.</source>
        <translation>Oben: %1.</translation>
    </message>
    <message>
        <source>At the bottom: %1.</source>
        <translation>Unten: %1.</translation>
    </message>
    <message>
        <source>Inside, choose: %1.</source>
        <translation>Wählen Sie drinnen: %1.</translation>
    </message>
    <message>
        <source>Then, straight away, %1.</source>
        <translation>Gleich danach %1.</translation>
    </message>
    <message>
        <source>%1: your destination.</source>
        <translation>%1: Ihr Ziel.</translation>
    </message>
    <message>
        <source>%1: your destination, %2.</source>
        <translation>%1: Ihr Ziel, %2.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>mark</comment>
        <extracomment>%1 &quot;turn left&quot;, %2 &quot;after the extinguisher&quot;</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>when, what comes</comment>
        <extracomment>%1 &quot;Soon&quot;, %2 &quot;stairs up&quot;</extracomment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <comment>when, what to do</comment>
        <extracomment>%1 &quot;Soon&quot;, %2 &quot;go through the door&quot;</extracomment>
        <translation>%1 %2.</translation>
    </message>
    <message>
        <source>%1: a bend. Follow it, %2.</source>
        <extracomment>%1 &quot;First&quot;, %2 &quot;turning left&quot;</extracomment>
        <translation>%1: eine Biegung. Folgen Sie ihr %2.</translation>
    </message>
    <message>
        <source>Your destination is here.</source>
        <translation>Ihr Ziel ist hier.</translation>
    </message>
    <message>
        <source>Your destination is probably here.</source>
        <translation>Ihr Ziel ist wahrscheinlich hier.</translation>
    </message>
    <message>
        <source>Your destination is here: %1.</source>
        <translation>Ihr Ziel ist hier: %1.</translation>
    </message>
    <message>
        <source>Your destination is probably here: %1.</source>
        <translation>Ihr Ziel ist wahrscheinlich hier: %1.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more thing(s) to do after that.</source>
        <translation>
            <numerusform>Danach ist noch eines zu tun.</numerusform>
            <numerusform>Danach sind noch %n Dinge zu tun.</numerusform>
        </translation>
    </message>
    <message>
        <source>known place</source>
        <translation>bekannter Ort</translation>
    </message>
    <message>
        <source>door</source>
        <translation>Tür</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>Aufzug</translation>
    </message>
    <message>
        <source>extinguisher</source>
        <translation>Feuerlöscher</translation>
    </message>
    <message>
        <source>exit sign</source>
        <translation>Ausgangsschild</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>Schild</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>rectangular shape</source>
        <translation>rechteckige Form</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>locker</source>
        <translation>Spind</translation>
    </message>
    <message>
        <source>poster</source>
        <translation>Plakat</translation>
    </message>
    <message>
        <source>drinking fountain</source>
        <translation>Trinkbrunnen</translation>
    </message>
    <message>
        <source>hydrant</source>
        <translation>Hydrant</translation>
    </message>
    <message>
        <source>vending machine</source>
        <translation>Verkaufsautomat</translation>
    </message>
    <message>
        <source>waste bin</source>
        <translation>Abfalleimer</translation>
    </message>
    <message>
        <source>plant</source>
        <translation>Pflanze</translation>
    </message>
    <message>
        <source>piece of furniture</source>
        <translation>Möbelstück</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>object</source>
        <translation>Gegenstand</translation>
    </message>
    <message>
        <source>an extinguisher</source>
        <translation>ein Feuerlöscher</translation>
    </message>
    <message>
        <source>an exit sign</source>
        <translation>ein Ausgangsschild</translation>
    </message>
    <message>
        <source>a sign</source>
        <translation>ein Schild</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a window</source>
        <translation>ein Fenster</translation>
    </message>
    <message>
        <source>a locker</source>
        <translation>ein Spind</translation>
    </message>
    <message>
        <source>a poster</source>
        <translation>ein Plakat</translation>
    </message>
    <message>
        <source>a drinking fountain</source>
        <translation>ein Trinkbrunnen</translation>
    </message>
    <message>
        <source>a hydrant</source>
        <translation>ein Hydrant</translation>
    </message>
    <message>
        <source>a vending machine</source>
        <translation>ein Verkaufsautomat</translation>
    </message>
    <message>
        <source>a waste bin</source>
        <translation>ein Abfalleimer</translation>
    </message>
    <message>
        <source>a plant</source>
        <translation>eine Pflanze</translation>
    </message>
    <message>
        <source>a piece of furniture</source>
        <translation>ein Möbelstück</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>in der Mitte</translation>
    </message>
    <message>
        <source>1 o&apos;clock</source>
        <translation>ein Uhr</translation>
    </message>
    <message>
        <source>2 o&apos;clock</source>
        <translation>zwei Uhr</translation>
    </message>
    <message>
        <source>3 o&apos;clock</source>
        <translation>drei Uhr</translation>
    </message>
    <message>
        <source>4 o&apos;clock</source>
        <translation>vier Uhr</translation>
    </message>
    <message>
        <source>5 o&apos;clock</source>
        <translation>fünf Uhr</translation>
    </message>
    <message>
        <source>6 o&apos;clock</source>
        <translation>sechs Uhr</translation>
    </message>
    <message>
        <source>7 o&apos;clock</source>
        <translation>sieben Uhr</translation>
    </message>
    <message>
        <source>8 o&apos;clock</source>
        <translation>acht Uhr</translation>
    </message>
    <message>
        <source>9 o&apos;clock</source>
        <translation>neun Uhr</translation>
    </message>
    <message>
        <source>10 o&apos;clock</source>
        <translation>zehn Uhr</translation>
    </message>
    <message>
        <source>11 o&apos;clock</source>
        <translation>elf Uhr</translation>
    </message>
    <message>
        <source>12 o&apos;clock</source>
        <translation>zwölf Uhr</translation>
    </message>
    <message>
        <source>go straight on</source>
        <translation>gehen Sie geradeaus weiter</translation>
    </message>
    <message>
        <source>turn to %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>drehen Sie sich in Richtung %1</translation>
    </message>
    <message>
        <source>turn to %1</source>
        <translation>drehen Sie sich in Richtung %1</translation>
    </message>
    <message>
        <source>turn around</source>
        <translation>drehen Sie sich um</translation>
    </message>
    <message>
        <source>turn %1 degrees to the left</source>
        <translation>drehen Sie sich um %1 Grad nach links</translation>
    </message>
    <message>
        <source>turn %1 degrees to the right</source>
        <translation>drehen Sie sich um %1 Grad nach rechts</translation>
    </message>
    <message>
        <source>turn slightly left</source>
        <translation>biegen Sie leicht links ab</translation>
    </message>
    <message>
        <source>turn left</source>
        <translation>biegen Sie links ab</translation>
    </message>
    <message>
        <source>turn sharply left</source>
        <translation>biegen Sie scharf links ab</translation>
    </message>
    <message>
        <source>turn slightly right</source>
        <translation>biegen Sie leicht rechts ab</translation>
    </message>
    <message>
        <source>turn right</source>
        <translation>biegen Sie rechts ab</translation>
    </message>
    <message>
        <source>turn sharply right</source>
        <translation>biegen Sie scharf rechts ab</translation>
    </message>
    <message>
        <source>turn slightly left</source>
        <comment>on the spot</comment>
        <translation>drehen Sie sich leicht nach links</translation>
    </message>
    <message>
        <source>turn left</source>
        <comment>on the spot</comment>
        <translation>drehen Sie sich nach links</translation>
    </message>
    <message>
        <source>turn sharply left</source>
        <comment>on the spot</comment>
        <translation>drehen Sie sich weit nach links</translation>
    </message>
    <message>
        <source>turn slightly right</source>
        <comment>on the spot</comment>
        <translation>drehen Sie sich leicht nach rechts</translation>
    </message>
    <message>
        <source>turn right</source>
        <comment>on the spot</comment>
        <translation>drehen Sie sich nach rechts</translation>
    </message>
    <message>
        <source>turn sharply right</source>
        <comment>on the spot</comment>
        <translation>drehen Sie sich weit nach rechts</translation>
    </message>
    <message>
        <source>turning to %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>in Richtung %1</translation>
    </message>
    <message>
        <source>turning to %1</source>
        <translation>in Richtung %1</translation>
    </message>
    <message>
        <source>turning around</source>
        <translation>zurück</translation>
    </message>
    <message>
        <source>turning %1 degrees to the left</source>
        <translation>um %1 Grad nach links</translation>
    </message>
    <message>
        <source>turning %1 degrees to the right</source>
        <translation>um %1 Grad nach rechts</translation>
    </message>
    <message>
        <source>turning slightly left</source>
        <translation>leicht nach links</translation>
    </message>
    <message>
        <source>turning left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>turning sharply left</source>
        <translation>scharf nach links</translation>
    </message>
    <message>
        <source>turning slightly right</source>
        <translation>leicht nach rechts</translation>
    </message>
    <message>
        <source>turning right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>turning sharply right</source>
        <translation>scharf nach rechts</translation>
    </message>
    <message>
        <source>on your left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>on your right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>at %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>straight ahead</source>
        <translation>geradeaus</translation>
    </message>
    <message>
        <source>behind you</source>
        <translation>hinter Ihnen</translation>
    </message>
    <message>
        <source>%1 degrees to your right</source>
        <translation>%1 Grad rechts von Ihnen</translation>
    </message>
    <message>
        <source>%1 degrees to your left</source>
        <translation>%1 Grad links von Ihnen</translation>
    </message>
    <message>
        <source>ahead, slightly to your right</source>
        <translation>vor Ihnen, leicht rechts</translation>
    </message>
    <message>
        <source>behind you, on the right</source>
        <translation>hinter Ihnen rechts</translation>
    </message>
    <message>
        <source>behind you, on the left</source>
        <translation>hinter Ihnen links</translation>
    </message>
    <message>
        <source>ahead, slightly to your left</source>
        <translation>vor Ihnen, leicht links</translation>
    </message>
    <message>
        <source>first</source>
        <comment>door or opening</comment>
        <translation>erste</translation>
    </message>
    <message>
        <source>second</source>
        <comment>door or opening</comment>
        <translation>zweite</translation>
    </message>
    <message>
        <source>third</source>
        <comment>door or opening</comment>
        <translation>dritte</translation>
    </message>
    <message>
        <source>fourth</source>
        <comment>door or opening</comment>
        <translation>vierte</translation>
    </message>
    <message>
        <source>fifth</source>
        <comment>door or opening</comment>
        <translation>fünfte</translation>
    </message>
    <message>
        <source>sixth</source>
        <comment>door or opening</comment>
        <translation>sechste</translation>
    </message>
    <message>
        <source>seventh</source>
        <comment>door or opening</comment>
        <translation>siebte</translation>
    </message>
    <message>
        <source>eighth</source>
        <comment>door or opening</comment>
        <translation>achte</translation>
    </message>
    <message>
        <source>after the extinguisher</source>
        <translation>nach dem Feuerlöscher</translation>
    </message>
    <message>
        <source>after the drinking fountain</source>
        <translation>nach dem Trinkbrunnen</translation>
    </message>
    <message>
        <source>after the hydrant</source>
        <translation>nach dem Hydranten</translation>
    </message>
    <message>
        <source>after the vending machine</source>
        <translation>nach dem Verkaufsautomaten</translation>
    </message>
    <message>
        <source>after the waste bin</source>
        <translation>nach dem Abfalleimer</translation>
    </message>
    <message>
        <source>after the plant</source>
        <translation>nach der Pflanze</translation>
    </message>
    <message>
        <source>after the locker</source>
        <translation>nach dem Spind</translation>
    </message>
    <message>
        <source>a room</source>
        <translation>ein Raum</translation>
    </message>
    <message>
        <source>a corridor</source>
        <translation>ein Flur</translation>
    </message>
    <message>
        <source>a hall</source>
        <translation>eine Halle</translation>
    </message>
    <message>
        <source>a stairwell</source>
        <translation>ein Treppenhaus</translation>
    </message>
    <message>
        <source>a toilet</source>
        <translation>eine Toilette</translation>
    </message>
    <message>
        <source>outside the building</source>
        <translation>außerhalb des Gebäudes</translation>
    </message>
    <message>
        <source>to the north-east</source>
        <translation>im Nordosten</translation>
    </message>
    <message>
        <source>to the east</source>
        <translation>im Osten</translation>
    </message>
    <message>
        <source>to the south-east</source>
        <translation>im Südosten</translation>
    </message>
    <message>
        <source>to the south</source>
        <translation>im Süden</translation>
    </message>
    <message>
        <source>to the south-west</source>
        <translation>im Südwesten</translation>
    </message>
    <message>
        <source>to the west</source>
        <translation>im Westen</translation>
    </message>
    <message>
        <source>to the north-west</source>
        <translation>im Nordwesten</translation>
    </message>
    <message>
        <source>to the north</source>
        <translation>im Norden</translation>
    </message>
    <message>
        <source>Stop.</source>
        <extracomment>To somebody who walks, or is opening a door</extracomment>
        <translation>Halt.</translation>
    </message>
</context>
<context>
    <name>farol::ui::PictureReel</name>
    <message>
        <source>There are no pictures in %1.</source>
        <translation>In %1 sind keine Bilder.</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlaceChooser</name>
    <message>
        <source>No such place</source>
        <translation>Diesen Ort gibt es nicht</translation>
    </message>
    <message numerus="yes">
        <source>%n places fit: choose one</source>
        <translation>
            <numerusform>ein Ort passt: wählen Sie ihn</numerusform>
            <numerusform>%n Orte passen: wählen Sie einen</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Go to:</source>
        <translation>&amp;Gehe zu:</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>type a name or room number</source>
        <translation>Name oder Raumnummer tippen</translation>
    </message>
    <message>
        <source>Where to go: type part of a name, room number or level, then choose</source>
        <translation>Wohin: Tippen Sie einen Teil eines Namens, einer Raumnummer oder Ebene und wählen Sie</translation>
    </message>
    <message>
        <source>Start &amp;at:</source>
        <translation>&amp;Beginne bei:</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>not known, Farol looks for it</source>
        <translation>nicht bekannt, Farol sucht ihn</translation>
    </message>
    <message>
        <source>Where the walk starts, if you know it</source>
        <translation>Wo die Begehung beginnt, wenn Sie es wissen</translation>
    </message>
    <message>
        <source>F&amp;rom:</source>
        <translation>&amp;Von:</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Where the route begins: type part of a name, room number or level, then choose</source>
        <translation>Wo der Weg beginnt: Tippen Sie einen Teil eines Namens, einer Raumnummer oder Ebene und wählen Sie</translation>
    </message>
    <message>
        <source>&amp;To:</source>
        <translation>&amp;Nach:</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Where the route ends: type part of a name, room number or level, then choose</source>
        <translation>Wo der Weg endet: Tippen Sie einen Teil eines Namens, einer Raumnummer oder Ebene und wählen Sie</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Type part of a name, room number or level, then choose</source>
        <translation>Tippen Sie einen Teil eines Namens, einer Raumnummer oder Ebene und wählen Sie</translation>
    </message>
    <message>
        <source>Clear the line</source>
        <translation>Zeile leeren</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlanLegend</name>
    <message>
        <source>no landmark</source>
        <translation>ohne Landmarke</translation>
    </message>
    <message>
        <source>looks like another place</source>
        <translation>sieht aus wie ein anderer Ort</translation>
    </message>
    <message>
        <source>a landmark here helps most</source>
        <translation>hier hilft eine Landmarke am meisten</translation>
    </message>
    <message>
        <source>not joined with the rest</source>
        <translation>nicht mit dem Rest verbunden</translation>
    </message>
    <message>
        <source>Legend: %1</source>
        <translation>Legende: %1</translation>
    </message>
    <message>
        <source>sees no landmark</source>
        <translation>sieht keine Landmarke</translation>
    </message>
    <message>
        <source>sees one</source>
        <translation>sieht eine</translation>
    </message>
    <message>
        <source>sees several</source>
        <translation>sieht mehrere</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlanPanel</name>
    <message>
        <source>No map is open.</source>
        <translation>Es ist keine Karte geöffnet.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n region(s), %2</source>
        <translation>
            <numerusform>%1: eine Region, %2</numerusform>
            <numerusform>%1: %n Regionen, %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>eine Landmarke</numerusform>
            <numerusform>%n Landmarken</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Level:</source>
        <translation>&amp;Ebene:</translation>
    </message>
    <message>
        <source>Level of the plan</source>
        <translation>Ebene des Plans</translation>
    </message>
    <message>
        <source>The floor that the plan shows (Page Up and Page Down in the plan)</source>
        <translation>Das Stockwerk, das der Plan zeigt (Bild auf und Bild ab im Plan)</translation>
    </message>
    <message>
        <source>Larger (+)</source>
        <translation>Größer (+)</translation>
    </message>
    <message>
        <source>Smaller (-)</source>
        <translation>Kleiner (-)</translation>
    </message>
    <message>
        <source>Show the whole floor (0)</source>
        <translation>Das ganze Stockwerk zeigen (0)</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Drag to move, turn the wheel to zoom. What is chosen can be dragged, or moved by Alt and the arrows</source>
        <translation>Ziehen zum Verschieben, Rad drehen zum Vergrößern. Das Gewählte lässt sich ziehen oder mit Alt und den Pfeilen bewegen</translation>
    </message>
</context>
<context>
    <name>farol::ui::ProfileMenu</name>
    <message>
        <source>Usual</source>
        <translation>Üblich</translation>
    </message>
    <message>
        <source>Use the settings of %1</source>
        <translation>Die Einstellungen von %1 verwenden</translation>
    </message>
    <message>
        <source>&amp;New user…</source>
        <translation>&amp;Neuer Benutzer…</translation>
    </message>
    <message>
        <source>New user</source>
        <translation>Neuer Benutzer</translation>
    </message>
    <message>
        <source>Name; the new user begins with the settings as they are now:</source>
        <translation>Name; der neue Benutzer beginnt mit den jetzigen Einstellungen:</translation>
    </message>
    <message>
        <source>“%1” cannot be used as a name: it must not hold a slash.</source>
        <translation>„%1“ geht nicht als Name: Er darf keinen Schrägstrich enthalten.</translation>
    </message>
    <message>
        <source>&amp;User</source>
        <translation>Ben&amp;utzer</translation>
    </message>
</context>
<context>
    <name>farol::ui::RegionDialog</name>
    <message>
        <source>Region %1</source>
        <translation>Region %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What is spoken</source>
        <translation>Was gesprochen wird</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>The number on the door</source>
        <translation>Die Nummer an der Tür</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What sort of place it is</source>
        <translation>Was für ein Ort es ist</translation>
    </message>
    <message>
        <source>Restricted</source>
        <translation>Eingeschränkt</translation>
    </message>
    <message>
        <source>Not open to everyone</source>
        <translation>Nicht für alle offen</translation>
    </message>
</context>
<context>
    <name>farol::ui::ReportPanel</name>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>ein Fehler</numerusform>
            <numerusform>%n Fehler</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>eine Warnung</numerusform>
            <numerusform>%n Warnungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>ein Hinweis</numerusform>
            <numerusform>%n Hinweise</numerusform>
        </translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>Es ist keine Karte geöffnet.</translation>
    </message>
    <message>
        <source>The map was changed after this check: %1.</source>
        <translation>Die Karte wurde nach dieser Prüfung geändert: %1.</translation>
    </message>
    <message>
        <source>Nothing is wrong with this map.</source>
        <translation>An dieser Karte ist nichts falsch.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>What is wrong with the map; choose a finding to see its place on the plan</source>
        <translation>Was an der Karte nicht stimmt; wählen Sie einen Befund, um seinen Ort auf dem Plan zu sehen</translation>
    </message>
    <message>
        <source>The finding in words</source>
        <translation>Der Befund in Worten</translation>
    </message>
    <message>
        <source>The finding in words, and what to do</source>
        <translation>Der Befund in Worten, und was zu tun ist</translation>
    </message>
    <message>
        <source>Chec&amp;k again</source>
        <translation>Noch einmal &amp;prüfen</translation>
    </message>
    <message>
        <source>Look for what is wrong with the map as it is now (F7)</source>
        <translation>Suchen, was an der Karte jetzt nicht stimmt (F7)</translation>
    </message>
    <message>
        <source>Choose a finding to read what it means and what to do.</source>
        <translation>Wählen Sie einen Befund, um zu lesen, was er bedeutet und was zu tun ist.</translation>
    </message>
    <message>
        <source>Ne&amp;xt place</source>
        <translation>Näch&amp;ster Ort</translation>
    </message>
    <message>
        <source>Show the next place of this finding (F4)</source>
        <translation>Den nächsten Ort dieses Befunds zeigen (F4)</translation>
    </message>
</context>
<context>
    <name>farol::ui::RevoteDialog</name>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>Work out a recorded walk anew</source>
        <translation>Eine aufgenommene Begehung neu berechnen</translation>
    </message>
    <message>
        <source>Folder of the recorded walk</source>
        <translation>Ordner der aufgenommenen Begehung</translation>
    </message>
    <message>
        <source>Where the recorded walk is kept</source>
        <translation>Wo die aufgenommene Begehung liegt</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse for the recorded walk</source>
        <translation>Die aufgenommene Begehung suchen</translation>
    </message>
    <message>
        <source>Folder of a recorded walk</source>
        <translation>Ordner einer aufgenommenen Begehung</translation>
    </message>
    <message>
        <source>How the place is worked out now</source>
        <translation>Wie der Ort jetzt gefunden wird</translation>
    </message>
    <message>
        <source>What the recorded walk is worked out with the second time</source>
        <translation>Womit die aufgenommene Begehung das zweite Mal berechnet wird</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Work the walk out as it was, and once more with the other choice</source>
        <translation>Die Begehung berechnen, wie sie war, und noch einmal mit der anderen Wahl</translation>
    </message>
    <message>
        <source>The pictures are not looked at again: what was recognised then is taken, and the place is worked out anew.</source>
        <translation>Die Bilder werden nicht noch einmal angesehen: Was damals erkannt wurde, gilt, und der Ort wird neu berechnet.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Where the two differ</source>
        <translation>Wo sich beide unterscheiden</translation>
    </message>
    <message>
        <source>&amp;Recorded walk:</source>
        <translation>&amp;Aufgenommene Begehung:</translation>
    </message>
    <message>
        <source>&amp;Worked out by:</source>
        <translation>&amp;Berechnet durch:</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Arbeitet…</translation>
    </message>
    <message>
        <source>%1 before, %2 now. The same place on %3 of %4 pictures (%5 %). Sentences: %6 before, %7 now.</source>
        <translation>%1 vorher, %2 jetzt. Derselbe Ort auf %3 von %4 Bildern (%5 %). Sätze: %6 vorher, %7 jetzt.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>farol::ui::RouteModel</name>
    <message>
        <source>Start in %1.</source>
        <translation>Beginnen Sie hier: %1.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
</context>
<context>
    <name>farol::ui::RoutePanel</name>
    <message>
        <source>No map is open.</source>
        <translation>Es ist keine Karte geöffnet.</translation>
    </message>
    <message>
        <source>Looking for the way…</source>
        <translation>Der Weg wird gesucht…</translation>
    </message>
    <message>
        <source>There is no way. %1</source>
        <translation>Es gibt keinen Weg. %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 m, about %n minute(s), through %2.</source>
        <translation>
            <numerusform>%1 m, etwa eine Minute, durch %2.</numerusform>
            <numerusform>%1 m, etwa %n Minuten, durch %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n door(s) and passage(s)</source>
        <translation>
            <numerusform>eine Tür oder einen Durchgang</numerusform>
            <numerusform>%n Türen und Durchgänge</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose where the route begins and ends, here or by the menu of a place on the plan.</source>
        <translation>Wählen Sie Anfang und Ende des Weges, hier oder im Menü eines Ortes auf dem Plan.</translation>
    </message>
    <message>
        <source>Swa&amp;p</source>
        <translation>&amp;Tauschen</translation>
    </message>
    <message>
        <source>The way back: exchange where the route begins and ends</source>
        <translation>Der Rückweg: Anfang und Ende des Weges tauschen</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>Vermeiden</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>Treppen</translation>
    </message>
    <message>
        <source>Find a way without stairs</source>
        <translation>Einen Weg ohne Treppen suchen</translation>
    </message>
    <message>
        <source>lifts</source>
        <translation>Aufzüge</translation>
    </message>
    <message>
        <source>Find a way without lifts</source>
        <translation>Einen Weg ohne Aufzüge suchen</translation>
    </message>
    <message>
        <source>escalators</source>
        <translation>Rolltreppen</translation>
    </message>
    <message>
        <source>Find a way without escalators</source>
        <translation>Einen Weg ohne Rolltreppen suchen</translation>
    </message>
    <message>
        <source>restricted regions</source>
        <translation>eingeschränkte Regionen</translation>
    </message>
    <message>
        <source>Find a way that is open to everyone</source>
        <translation>Einen Weg suchen, der allen offen steht</translation>
    </message>
    <message>
        <source>Sentences of the route</source>
        <translation>Sätze des Weges</translation>
    </message>
    <message>
        <source>What the walker hears; choose a sentence to see its place on the plan</source>
        <translation>Was man unterwegs hört; wählen Sie einen Satz, um seinen Ort auf dem Plan zu sehen</translation>
    </message>
</context>
<context>
    <name>farol::ui::RuleWords</name>
    <message>
        <source>Outlines that are no proper outline</source>
        <translation>Umrisse, die keine richtigen Umrisse sind</translation>
    </message>
    <message>
        <source>Draw the outline again so that it does not cross itself.</source>
        <translation>Zeichnen Sie den Umriss neu, sodass er sich nicht selbst kreuzt.</translation>
    </message>
    <message>
        <source>Regions that share an id</source>
        <translation>Regionen mit gleicher Kennung</translation>
    </message>
    <message>
        <source>Give each region an id of its own.</source>
        <translation>Geben Sie jeder Region eine eigene Kennung.</translation>
    </message>
    <message>
        <source>Names that nobody can say</source>
        <translation>Namen, die niemand sagen kann</translation>
    </message>
    <message>
        <source>Give the region the name that people use; this one is never spoken.</source>
        <translation>Geben Sie der Region den Namen, den die Leute benutzen; dieser wird nie gesprochen.</translation>
    </message>
    <message>
        <source>Doors that share an id</source>
        <translation>Türen mit gleicher Kennung</translation>
    </message>
    <message>
        <source>Give each door or passage an id of its own.</source>
        <translation>Geben Sie jeder Tür oder jedem Durchgang eine eigene Kennung.</translation>
    </message>
    <message>
        <source>Landmarks that share an id</source>
        <translation>Landmarken mit gleicher Kennung</translation>
    </message>
    <message>
        <source>Give each landmark an id of its own.</source>
        <translation>Geben Sie jeder Landmarke eine eigene Kennung.</translation>
    </message>
    <message>
        <source>Doors that do not join two regions</source>
        <translation>Türen, die nicht zwei Regionen verbinden</translation>
    </message>
    <message>
        <source>Choose the region on each side of the door.</source>
        <translation>Wählen Sie die Region auf jeder Seite der Tür.</translation>
    </message>
    <message>
        <source>Doors to regions that do not exist</source>
        <translation>Türen zu Regionen, die es nicht gibt</translation>
    </message>
    <message>
        <source>Choose regions that are on the map for both sides.</source>
        <translation>Wählen Sie für beide Seiten Regionen der Karte.</translation>
    </message>
    <message>
        <source>Doors far from the regions they join</source>
        <translation>Türen weit weg von den Regionen, die sie verbinden</translation>
    </message>
    <message>
        <source>Move the door to where the two regions meet.</source>
        <translation>Schieben Sie die Tür dorthin, wo die beiden Regionen sich treffen.</translation>
    </message>
    <message>
        <source>Doors drawn on fewer or more than two regions</source>
        <translation>Türen, die auf weniger oder mehr als zwei Regionen liegen</translation>
    </message>
    <message>
        <source>Doors beside more than two regions</source>
        <translation>Türen neben mehr als zwei Regionen</translation>
    </message>
    <message>
        <source>See that the two sides are the right ones.</source>
        <translation>Sehen Sie nach, ob die beiden Seiten stimmen.</translation>
    </message>
    <message>
        <source>Passages drawn along the way instead of across it</source>
        <translation>Durchgänge, die längs statt quer zum Weg gezeichnet sind</translation>
    </message>
    <message>
        <source>If one walks along the line, choose its two sides by hand.</source>
        <translation>Wenn man an der Linie entlanggeht, wählen Sie ihre beiden Seiten von Hand.</translation>
    </message>
    <message>
        <source>Doors without a place on the map</source>
        <translation>Türen ohne Ort auf der Karte</translation>
    </message>
    <message>
        <source>Draw them in the source, or put them in here.</source>
        <translation>Zeichnen Sie sie in der Quelle, oder setzen Sie sie hier ein.</translation>
    </message>
    <message>
        <source>Stairs or lifts that do not change the level</source>
        <translation>Treppen oder Aufzüge, die die Ebene nicht wechseln</translation>
    </message>
    <message>
        <source>Choose regions of two levels, or another kind.</source>
        <translation>Wählen Sie Regionen zweier Ebenen oder eine andere Art.</translation>
    </message>
    <message>
        <source>Parts of the building that no way joins</source>
        <translation>Teile des Gebäudes, die kein Weg verbindet</translation>
    </message>
    <message>
        <source>Put in the door, stairs or lift that joins them.</source>
        <translation>Setzen Sie die Tür, die Treppe oder den Aufzug dazwischen ein.</translation>
    </message>
    <message>
        <source>Regions without any door</source>
        <translation>Regionen ohne Tür</translation>
    </message>
    <message>
        <source>Put in the door that leads there.</source>
        <translation>Setzen Sie die Tür ein, die dorthin führt.</translation>
    </message>
    <message>
        <source>Regions without a name</source>
        <translation>Regionen ohne Namen</translation>
    </message>
    <message>
        <source>Give them the name that people use.</source>
        <translation>Geben Sie ihnen den Namen, den die Leute benutzen.</translation>
    </message>
    <message>
        <source>Regions of one level with the same number</source>
        <translation>Regionen einer Ebene mit gleicher Nummer</translation>
    </message>
    <message>
        <source>Correct the number of one of them.</source>
        <translation>Berichtigen Sie die Nummer einer von ihnen.</translation>
    </message>
    <message>
        <source>Regions as narrow as a wall</source>
        <translation>Regionen so schmal wie eine Wand</translation>
    </message>
    <message>
        <source>Join them with their neighbour in the source.</source>
        <translation>Vereinigen Sie sie in der Quelle mit der Nachbarregion.</translation>
    </message>
    <message>
        <source>Regions that overlap</source>
        <translation>Regionen, die sich überlappen</translation>
    </message>
    <message>
        <source>Draw the border between them in the source.</source>
        <translation>Zeichnen Sie die Grenze zwischen ihnen in der Quelle.</translation>
    </message>
    <message>
        <source>Regions inside other regions</source>
        <translation>Regionen in anderen Regionen</translation>
    </message>
    <message>
        <source>Cut the smaller one out of the larger one, unless it is a part of it.</source>
        <translation>Schneiden Sie die kleinere aus der größeren, wenn sie kein Teil davon ist.</translation>
    </message>
    <message>
        <source>Regions drawn twice</source>
        <translation>Doppelt gezeichnete Regionen</translation>
    </message>
    <message>
        <source>Remove one of them in the source.</source>
        <translation>Entfernen Sie eine davon in der Quelle.</translation>
    </message>
    <message>
        <source>Regions in several parts</source>
        <translation>Regionen aus mehreren Teilen</translation>
    </message>
    <message>
        <source>Each part became a region; give the parts names of their own.</source>
        <translation>Jeder Teil wurde eine Region; geben Sie den Teilen eigene Namen.</translation>
    </message>
    <message>
        <source>Landmarks in regions that do not exist</source>
        <translation>Landmarken in Regionen, die es nicht gibt</translation>
    </message>
    <message>
        <source>Move the landmark into a region.</source>
        <translation>Schieben Sie die Landmarke in eine Region.</translation>
    </message>
    <message>
        <source>Landmarks outside their region</source>
        <translation>Landmarken außerhalb ihrer Region</translation>
    </message>
    <message>
        <source>Move the landmark into its region.</source>
        <translation>Schieben Sie die Landmarke in ihre Region.</translation>
    </message>
    <message>
        <source>Landmarks that were given their region by their place</source>
        <translation>Landmarken, deren Region sich aus ihrem Ort ergab</translation>
    </message>
    <message>
        <source>Levels that the list of levels does not name</source>
        <translation>Ebenen, die in der Liste der Ebenen fehlen</translation>
    </message>
    <message>
        <source>Add the level to the list in the source.</source>
        <translation>Fügen Sie die Ebene in der Quelle zur Liste hinzu.</translation>
    </message>
    <message>
        <source>Levels named twice</source>
        <translation>Doppelt genannte Ebenen</translation>
    </message>
    <message>
        <source>Levels without a usable number</source>
        <translation>Ebenen ohne brauchbare Nummer</translation>
    </message>
    <message>
        <source>Give the level a number in the source.</source>
        <translation>Geben Sie der Ebene in der Quelle eine Nummer.</translation>
    </message>
    <message>
        <source>Features whose level was assumed</source>
        <translation>Objekte, deren Ebene angenommen wurde</translation>
    </message>
    <message>
        <source>Add the level in the source.</source>
        <translation>Fügen Sie die Ebene in der Quelle hinzu.</translation>
    </message>
    <message>
        <source>Links between levels that lead nowhere</source>
        <translation>Verbindungen zwischen Ebenen, die nirgends hinführen</translation>
    </message>
    <message>
        <source>Choose regions that are on the map.</source>
        <translation>Wählen Sie Regionen der Karte.</translation>
    </message>
    <message>
        <source>Stairs and lifts joined because they lie above one another</source>
        <translation>Treppen und Aufzüge, die verbunden wurden, weil sie übereinander liegen</translation>
    </message>
    <message>
        <source>See that they really are one.</source>
        <translation>Sehen Sie nach, ob sie wirklich eins sind.</translation>
    </message>
    <message>
        <source>Stairs or lifts that leave out a level</source>
        <translation>Treppen oder Aufzüge, die eine Ebene auslassen</translation>
    </message>
    <message>
        <source>Add the stop, if there is one.</source>
        <translation>Fügen Sie den Halt hinzu, wenn es ihn gibt.</translation>
    </message>
    <message>
        <source>Kinds that are not known</source>
        <translation>Unbekannte Arten</translation>
    </message>
    <message>
        <source>Choose one of the kinds that Farol knows.</source>
        <translation>Wählen Sie eine der Arten, die Farol kennt.</translation>
    </message>
    <message>
        <source>Degrees where metres are meant</source>
        <translation>Grad, wo Meter gemeint sind</translation>
    </message>
    <message>
        <source>See that the building has its right size.</source>
        <translation>Sehen Sie nach, ob das Gebäude die richtige Größe hat.</translation>
    </message>
    <message>
        <source>Metres where degrees are meant</source>
        <translation>Meter, wo Grad gemeint sind</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not named</source>
        <translation>Das Koordinatensystem ist nicht genannt</translation>
    </message>
    <message>
        <source>Name the coordinate system in the source.</source>
        <translation>Nennen Sie das Koordinatensystem in der Quelle.</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not understood</source>
        <translation>Das Koordinatensystem wird nicht verstanden</translation>
    </message>
    <message>
        <source>Name a common coordinate system in the source.</source>
        <translation>Nennen Sie in der Quelle ein gebräuchliches Koordinatensystem.</translation>
    </message>
    <message>
        <source>Coordinates were converted to metres</source>
        <translation>Koordinaten wurden in Meter umgerechnet</translation>
    </message>
    <message>
        <source>North and east were exchanged</source>
        <translation>Nord und Ost waren vertauscht</translation>
    </message>
    <message>
        <source>Export the map again to be sure.</source>
        <translation>Exportieren Sie die Karte zur Sicherheit noch einmal.</translation>
    </message>
    <message>
        <source>Points that are no places</source>
        <translation>Punkte, die keine Orte sind</translation>
    </message>
    <message>
        <source>See whether something is missing there.</source>
        <translation>Sehen Sie nach, ob dort etwas fehlt.</translation>
    </message>
    <message>
        <source>Features without a shape</source>
        <translation>Objekte ohne Form</translation>
    </message>
    <message>
        <source>Draw them in the source if they are needed.</source>
        <translation>Zeichnen Sie sie in der Quelle, wenn sie gebraucht werden.</translation>
    </message>
    <message>
        <source>Features without a usable shape</source>
        <translation>Objekte ohne brauchbare Form</translation>
    </message>
    <message>
        <source>Layers without features</source>
        <translation>Layer ohne Objekte</translation>
    </message>
    <message>
        <source>Layers whose meaning is not clear</source>
        <translation>Layer mit unklarer Bedeutung</translation>
    </message>
    <message>
        <source>Say in a profile what the layer holds.</source>
        <translation>Sagen Sie in einem Profil, was der Layer enthält.</translation>
    </message>
    <message>
        <source>Layers that were not used</source>
        <translation>Layer, die nicht verwendet wurden</translation>
    </message>
    <message>
        <source>Codes without a meaning</source>
        <translation>Codes ohne Bedeutung</translation>
    </message>
    <message>
        <source>Say in a profile what the code means.</source>
        <translation>Sagen Sie in einem Profil, was der Code bedeutet.</translation>
    </message>
    <message>
        <source>Openings added where no wall stands between regions</source>
        <translation>Öffnungen, wo zwischen Regionen keine Wand steht</translation>
    </message>
    <message>
        <source>See that one can really walk through.</source>
        <translation>Sehen Sie nach, ob man wirklich hindurchgehen kann.</translation>
    </message>
    <message>
        <source>Escalators without a direction</source>
        <translation>Rolltreppen ohne Richtung</translation>
    </message>
    <message>
        <source>Say which way they run.</source>
        <translation>Sagen Sie, in welche Richtung sie laufen.</translation>
    </message>
    <message>
        <source>Amenities without a known level</source>
        <translation>Einrichtungen ohne bekannte Ebene</translation>
    </message>
    <message>
        <source>Name the level in the source.</source>
        <translation>Nennen Sie die Ebene in der Quelle.</translation>
    </message>
    <message>
        <source>Amenities without a place</source>
        <translation>Einrichtungen ohne Ort</translation>
    </message>
    <message>
        <source>Give them a point in the source.</source>
        <translation>Geben Sie ihnen in der Quelle einen Punkt.</translation>
    </message>
    <message>
        <source>Categories that are not known</source>
        <translation>Unbekannte Kategorien</translation>
    </message>
    <message>
        <source>Levels without an id</source>
        <translation>Ebenen ohne Kennung</translation>
    </message>
    <message>
        <source>Give the level an id in the source.</source>
        <translation>Geben Sie der Ebene in der Quelle eine Kennung.</translation>
    </message>
    <message>
        <source>Levels without an ordinal</source>
        <translation>Ebenen ohne Ordnungszahl</translation>
    </message>
    <message>
        <source>Give the level an ordinal in the source.</source>
        <translation>Geben Sie der Ebene in der Quelle eine Ordnungszahl.</translation>
    </message>
    <message>
        <source>Parts of the IMDF archive that were not used</source>
        <translation>Teile des IMDF-Archivs, die nicht verwendet wurden</translation>
    </message>
    <message>
        <source>Walls, columns and voids drawn as units</source>
        <translation>Wände, Säulen und Lufträume, die als Einheiten gezeichnet sind</translation>
    </message>
    <message>
        <source>Occupants without a place</source>
        <translation>Nutzer ohne Ort</translation>
    </message>
    <message>
        <source>Name the anchor in the source.</source>
        <translation>Nennen Sie den Anker in der Quelle.</translation>
    </message>
    <message>
        <source>Openings that are closed</source>
        <translation>Öffnungen, die gesperrt sind</translation>
    </message>
    <message>
        <source>Openings without a line</source>
        <translation>Öffnungen ohne Linie</translation>
    </message>
    <message>
        <source>Draw the opening as a line in the source.</source>
        <translation>Zeichnen Sie die Öffnung in der Quelle als Linie.</translation>
    </message>
    <message>
        <source>Relationships that do not name two units</source>
        <translation>Beziehungen, die nicht zwei Einheiten nennen</translation>
    </message>
    <message>
        <source>Name the two units in the source.</source>
        <translation>Nennen Sie die beiden Einheiten in der Quelle.</translation>
    </message>
    <message>
        <source>Units without an outline</source>
        <translation>Einheiten ohne Umriss</translation>
    </message>
    <message>
        <source>Draw the outline in the source.</source>
        <translation>Zeichnen Sie den Umriss in der Quelle.</translation>
    </message>
    <message>
        <source>Doors that stand on no outline</source>
        <translation>Türen, die auf keinem Umriss stehen</translation>
    </message>
    <message>
        <source>Draw the door on the outline of its room.</source>
        <translation>Zeichnen Sie die Tür auf den Umriss ihres Raums.</translation>
    </message>
    <message>
        <source>Openings put where a way enters a room</source>
        <translation>Öffnungen, wo ein Weg in einen Raum führt</translation>
    </message>
    <message>
        <source>Draw the door in the source.</source>
        <translation>Zeichnen Sie die Tür in der Quelle.</translation>
    </message>
    <message>
        <source>Objects whose level is not clear</source>
        <translation>Gegenstände, deren Ebene unklar ist</translation>
    </message>
    <message>
        <source>Objects far from every region</source>
        <translation>Gegenstände weit weg von jeder Region</translation>
    </message>
    <message>
        <source>Draw the room they stand in.</source>
        <translation>Zeichnen Sie den Raum, in dem sie stehen.</translation>
    </message>
    <message>
        <source>Features without a level</source>
        <translation>Objekte ohne Ebene</translation>
    </message>
    <message>
        <source>Levels that cannot be read</source>
        <translation>Ebenen, die nicht lesbar sind</translation>
    </message>
    <message>
        <source>Correct the level in the source.</source>
        <translation>Berichtigen Sie die Ebene in der Quelle.</translation>
    </message>
    <message>
        <source>Lifts without a door</source>
        <translation>Aufzüge ohne Tür</translation>
    </message>
    <message>
        <source>Move the door to its place.</source>
        <translation>Schieben Sie die Tür an ihren Ort.</translation>
    </message>
    <message>
        <source>Lifts that are only a point</source>
        <translation>Aufzüge, die nur ein Punkt sind</translation>
    </message>
    <message>
        <source>Steps that lead nowhere</source>
        <translation>Stufen, die nirgends hinführen</translation>
    </message>
    <message>
        <source>Draw the area or way that they lead to.</source>
        <translation>Zeichnen Sie die Fläche oder den Weg, zu dem sie führen.</translation>
    </message>
    <message>
        <source>Steps that may go up or down</source>
        <translation>Stufen, die hinauf oder hinunter führen können</translation>
    </message>
    <message>
        <source>Say in the source which end is up.</source>
        <translation>Sagen Sie in der Quelle, welches Ende oben ist.</translation>
    </message>
    <message>
        <source>Steps without a length</source>
        <translation>Stufen ohne Länge</translation>
    </message>
    <message>
        <source>Draw the line of the steps.</source>
        <translation>Zeichnen Sie die Linie der Stufen.</translation>
    </message>
    <message>
        <source>Cells that could not be used</source>
        <translation>Zellen, die nicht zu brauchen waren</translation>
    </message>
    <message>
        <source>Give each cell an outline and an id.</source>
        <translation>Geben Sie jeder Zelle einen Umriss und eine Kennung.</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not known</source>
        <translation>Das Koordinatensystem ist nicht bekannt</translation>
    </message>
    <message>
        <source>Doors that do not lie between two rooms</source>
        <translation>Türen, die nicht zwischen zwei Räumen liegen</translation>
    </message>
    <message>
        <source>Levels that nothing tells</source>
        <translation>Ebenen, die nirgends stehen</translation>
    </message>
    <message>
        <source>Say where the level stands when importing.</source>
        <translation>Sagen Sie beim Importieren, wo die Ebene steht.</translation>
    </message>
    <message>
        <source>Levels counted from the heights of the floors</source>
        <translation>Ebenen, nach der Höhe der Böden gezählt</translation>
    </message>
    <message>
        <source>Storeys named by words</source>
        <translation>Stockwerke, die mit Worten benannt sind</translation>
    </message>
    <message>
        <source>Transitions that do not join two cells</source>
        <translation>Übergänge, die nicht zwei Zellen verbinden</translation>
    </message>
    <message>
        <source>Correct the transition in the source.</source>
        <translation>Berichtigen Sie den Übergang in der Quelle.</translation>
    </message>
    <message>
        <source>Entrances of facilities that are missing</source>
        <translation>Eingänge von Einrichtungen, die fehlen</translation>
    </message>
    <message>
        <source>Add the facility in the source.</source>
        <translation>Fügen Sie die Einrichtung in der Quelle hinzu.</translation>
    </message>
    <message>
        <source>Facilities that no entrance leads to</source>
        <translation>Einrichtungen, zu denen kein Eingang führt</translation>
    </message>
    <message>
        <source>Add the entrance in the source.</source>
        <translation>Fügen Sie den Eingang in der Quelle hinzu.</translation>
    </message>
    <message>
        <source>The number of the ground floor was assumed</source>
        <translation>Die Nummer des Erdgeschosses wurde angenommen</translation>
    </message>
    <message>
        <source>Say it when importing, if it is another one.</source>
        <translation>Sagen Sie sie beim Importieren, wenn es eine andere ist.</translation>
    </message>
    <message>
        <source>Objects far from every node</source>
        <translation>Gegenstände weit weg von jedem Knoten</translation>
    </message>
    <message>
        <source>Move the object in the source.</source>
        <translation>Bewegen Sie den Gegenstand in der Quelle.</translation>
    </message>
    <message>
        <source>Links that do not join two nodes</source>
        <translation>Verbindungen, die nicht zwei Knoten verbinden</translation>
    </message>
    <message>
        <source>Correct the link in the source.</source>
        <translation>Berichtigen Sie die Verbindung in der Quelle.</translation>
    </message>
    <message>
        <source>Nodes that could not be used</source>
        <translation>Knoten, die nicht zu brauchen waren</translation>
    </message>
    <message>
        <source>Give each node a place and an id.</source>
        <translation>Geben Sie jedem Knoten einen Ort und eine Kennung.</translation>
    </message>
    <message>
        <source>Nodes that no link leads to</source>
        <translation>Knoten, zu denen keine Verbindung führt</translation>
    </message>
    <message>
        <source>Add the link in the source.</source>
        <translation>Fügen Sie die Verbindung in der Quelle hinzu.</translation>
    </message>
    <message>
        <source>Nodes without a floor</source>
        <translation>Knoten ohne Stockwerk</translation>
    </message>
    <message>
        <source>Add the floor in the source.</source>
        <translation>Fügen Sie das Stockwerk in der Quelle hinzu.</translation>
    </message>
    <message>
        <source>Regions made from a network of ways</source>
        <translation>Regionen, die aus einem Wegenetz entstanden</translation>
    </message>
    <message>
        <source>Features of an unknown sort</source>
        <translation>Objekte unbekannter Art</translation>
    </message>
    <message>
        <source>Spaces closed from walls, doors and windows</source>
        <translation>Räume, aus Wänden, Türen und Fenstern geschlossen</translation>
    </message>
    <message>
        <source>Give them names.</source>
        <translation>Geben Sie ihnen Namen.</translation>
    </message>
    <message>
        <source>Doors with a space on one side only</source>
        <translation>Türen mit einem Raum auf nur einer Seite</translation>
    </message>
    <message>
        <source>See whether a wall is missing, or the door leads outside.</source>
        <translation>Sehen Sie nach, ob eine Wand fehlt oder die Tür nach draußen führt.</translation>
    </message>
    <message>
        <source>Narrow strips between walls</source>
        <translation>Schmale Streifen zwischen Wänden</translation>
    </message>
    <message>
        <source>Directions of doors that are not understood</source>
        <translation>Richtungen von Türen, die nicht verstanden werden</translation>
    </message>
    <message>
        <source>Say which way one can pass.</source>
        <translation>Sagen Sie, in welche Richtung man durchgehen kann.</translation>
    </message>
    <message>
        <source>Stairs or lifts to a level that nothing names</source>
        <translation>Treppen oder Aufzüge zu einer Ebene, die nirgends genannt ist</translation>
    </message>
    <message>
        <source>Choose the region on the other level.</source>
        <translation>Wählen Sie die Region auf der anderen Ebene.</translation>
    </message>
    <message>
        <source>Upper ends of stairs and lifts that are known already</source>
        <translation>Obere Enden von Treppen und Aufzügen, die schon bekannt sind</translation>
    </message>
    <message>
        <source>Levels counted from the heights of the shapes</source>
        <translation>Ebenen, nach der Höhe der Formen gezählt</translation>
    </message>
    <message>
        <source>Moving walkways without a direction</source>
        <translation>Rollsteige ohne Richtung</translation>
    </message>
    <message>
        <source>Say in the source which way they run.</source>
        <translation>Sagen Sie in der Quelle, in welche Richtung sie laufen.</translation>
    </message>
    <message>
        <source>Moving walkways that lead nowhere</source>
        <translation>Rollsteige, die nirgends hinführen</translation>
    </message>
    <message>
        <source>Regions whose door joins two others</source>
        <translation>Regionen, deren Tür zwei andere verbindet</translation>
    </message>
    <message>
        <source>Correct the sides of the door, or put in another one.</source>
        <translation>Berichtigen Sie die Seiten der Tür, oder setzen Sie eine andere ein.</translation>
    </message>
    <message>
        <source>Something to look at</source>
        <translation>Etwas zum Nachsehen</translation>
    </message>
</context>
<context>
    <name>farol::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>As the computer is set</source>
        <translation>Wie der Computer</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Language of the window and of the voice</source>
        <translation>Sprache des Fensters und der Stimme</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Sprache:</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Links und rechts</translation>
    </message>
    <message>
        <source>Hours of a clock</source>
        <translation>Stunden einer Uhr</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>How turns are told</source>
        <translation>Wie Richtungen gesagt werden</translation>
    </message>
    <message>
        <source>&amp;Directions:</source>
        <translation>&amp;Richtungen:</translation>
    </message>
    <message>
        <source>The way only</source>
        <translation>Nur der Weg</translation>
    </message>
    <message>
        <source>The way and objects</source>
        <translation>Der Weg und Gegenstände</translation>
    </message>
    <message>
        <source>The way, objects and texts</source>
        <translation>Der Weg, Gegenstände und Texte</translation>
    </message>
    <message>
        <source>What is told</source>
        <translation>Was gesagt wird</translation>
    </message>
    <message>
        <source>How much is told on the way</source>
        <translation>Wie viel unterwegs gesagt wird</translation>
    </message>
    <message>
        <source>&amp;What is told:</source>
        <translation>&amp;Was gesagt wird:</translation>
    </message>
    <message>
        <source>The first that works</source>
        <translation>Das erste, das geht</translation>
    </message>
    <message>
        <source>Speech program</source>
        <translation>Sprachprogramm</translation>
    </message>
    <message>
        <source>Which speech program of this computer speaks</source>
        <translation>Welches Sprachprogramm dieses Computers spricht</translation>
    </message>
    <message>
        <source>&amp;Speech program:</source>
        <translation>S&amp;prachprogramm:</translation>
    </message>
    <message>
        <source>What fits the language</source>
        <translation>Was zur Sprache passt</translation>
    </message>
    <message>
        <source>Voice</source>
        <translation>Stimme</translation>
    </message>
    <message>
        <source>Press “List voices” to choose among those of the speech program</source>
        <translation>Drücken Sie „Stimmen auflisten“, um eine des Sprachprogramms zu wählen</translation>
    </message>
    <message>
        <source>List &amp;voices</source>
        <translation>Stimmen auf&amp;listen</translation>
    </message>
    <message>
        <source>List voices</source>
        <translation>Stimmen auflisten</translation>
    </message>
    <message>
        <source>Ask the speech program for its voices; this can take some seconds</source>
        <translation>Das Sprachprogramm nach seinen Stimmen fragen; das kann einige Sekunden dauern</translation>
    </message>
    <message>
        <source>V&amp;oice:</source>
        <translation>S&amp;timme:</translation>
    </message>
    <message>
        <source>Speed of the voice</source>
        <translation>Tempo der Stimme</translation>
    </message>
    <message>
        <source>Slow on the left, fast on the right</source>
        <translation>Links langsam, rechts schnell</translation>
    </message>
    <message>
        <source>S&amp;peed of the voice:</source>
        <translation>T&amp;empo der Stimme:</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>How loud the voice is</source>
        <translation>Wie laut die Stimme ist</translation>
    </message>
    <message>
        <source>Lo&amp;udness:</source>
        <translation>La&amp;utstärke:</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Ordner der Aufnahmen</translation>
    </message>
    <message>
        <source>Where recorded walks are kept</source>
        <translation>Wo aufgenommene Begehungen liegen</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse for the folder of recordings</source>
        <translation>Den Ordner der Aufnahmen suchen</translation>
    </message>
    <message>
        <source>Choose where recorded walks are kept</source>
        <translation>Wählen, wo aufgenommene Begehungen liegen</translation>
    </message>
    <message>
        <source>&amp;Recordings:</source>
        <translation>&amp;Aufnahmen:</translation>
    </message>
    <message>
        <source>Pages of the settings</source>
        <translation>Seiten der Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>When something is said. From the next start of a walk.</source>
        <translation>Wann etwas gesagt wird. Ab dem nächsten Start einer Begehung.</translation>
    </message>
    <message>
        <source>Routes</source>
        <translation>Wege</translation>
    </message>
    <message>
        <source>Which way is chosen. From the next start of a walk.</source>
        <translation>Welcher Weg gewählt wird. Ab dem nächsten Start einer Begehung.</translation>
    </message>
    <message>
        <source>Recognition</source>
        <translation>Erkennung</translation>
    </message>
    <message>
        <source>How sure a landmark must be before it counts. Lower figures find more, and more that is wrong: leave them unless you can check. From the next start of a walk.</source>
        <translation>Wie sicher eine Landmarke sein muss, damit sie zählt. Niedrigere Werte finden mehr, auch mehr Falsches: Lassen Sie sie, wenn Sie es nicht prüfen können. Ab dem nächsten Start einer Begehung.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Light or dark windows</source>
        <translation>Helle oder dunkle Fenster</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Farben:</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Entfernungen</translation>
    </message>
    <message>
        <source>How distances are told</source>
        <translation>Wie Entfernungen gesagt werden</translation>
    </message>
    <message>
        <source>Dis&amp;tances:</source>
        <translation>E&amp;ntfernungen:</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>+%1</source>
        <translation>+%1</translation>
    </message>
    <message>
        <source>−%1</source>
        <translation>−%1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>farol::ui::SourceDialog</name>
    <message>
        <source>&amp;Camera number</source>
        <translation>&amp;Kameranummer</translation>
    </message>
    <message>
        <source>&amp;Video file</source>
        <translation>&amp;Videodatei</translation>
    </message>
    <message>
        <source>&amp;Folder of pictures</source>
        <translation>&amp;Bilderordner</translation>
    </message>
    <message>
        <source>Network &amp;address</source>
        <translation>Netz&amp;adresse</translation>
    </message>
    <message>
        <source>Open pictures</source>
        <translation>Bilder öffnen</translation>
    </message>
    <message>
        <source>Camera number</source>
        <translation>Kameranummer</translation>
    </message>
    <message>
        <source>0 is the first camera of this computer</source>
        <translation>0 ist die erste Kamera dieses Computers</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>Videodatei</translation>
    </message>
    <message>
        <source>Folder of pictures</source>
        <translation>Bilderordner</translation>
    </message>
    <message>
        <source>Network address</source>
        <translation>Netzadresse</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>How many pictures of the folder make a second</source>
        <translation>Wie viele Bilder des Ordners eine Sekunde sind</translation>
    </message>
    <message>
        <source>Pictures a &amp;second:</source>
        <translation>Bilder je &amp;Sekunde:</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse for a video file</source>
        <translation>Eine Videodatei suchen</translation>
    </message>
    <message>
        <source>B&amp;rowse…</source>
        <translation>Durchs&amp;uchen…</translation>
    </message>
    <message>
        <source>Browse for a folder</source>
        <translation>Einen Ordner suchen</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Video öffnen</translation>
    </message>
    <message>
        <source>Videos (%1);;All files (%2)</source>
        <translation>Videos (%1);;Alle Dateien (%2)</translation>
    </message>
    <message>
        <source>Open a folder of pictures</source>
        <translation>Bilderordner öffnen</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechDesk</name>
    <message>
        <source>Voice off: sentences are only shown</source>
        <translation>Stimme aus: Sätze werden nur gezeigt</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechOutput</name>
    <message>
        <source>The voice starts with the first sentence.</source>
        <translation>Die Stimme beginnt mit dem ersten Satz.</translation>
    </message>
    <message>
        <source>The voice hangs: nothing may be heard. Choose another one in the settings.</source>
        <translation>Die Stimme hängt: Vielleicht ist nichts zu hören. Wählen Sie in den Einstellungen eine andere.</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechQueue</name>
    <message>
        <source>There is nothing to repeat.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachPanel</name>
    <message>
        <source>Give up?</source>
        <translation>Aufgeben?</translation>
    </message>
    <message>
        <source>What you have taught of this landmark will be lost.</source>
        <translation>Was Sie von dieser Landmarke beigebracht haben, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Give it up</source>
        <translation>&amp;Aufgeben</translation>
    </message>
    <message>
        <source>&amp;Keep it</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>Add a view first.</source>
        <translation>Fügen Sie zuerst eine Ansicht hinzu.</translation>
    </message>
    <message>
        <source>Learning…</source>
        <translation>Lernt…</translation>
    </message>
    <message>
        <source>A new landmark</source>
        <translation>Eine neue Landmarke</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Fertig</translation>
    </message>
    <message>
        <source>&amp;Save it</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>Go back to the library</source>
        <translation>Zurück zur Bibliothek</translation>
    </message>
    <message>
        <source>Put it into the library</source>
        <translation>In die Bibliothek aufnehmen</translation>
    </message>
    <message>
        <source>The next step</source>
        <translation>Der nächste Schritt</translation>
    </message>
    <message>
        <source>“%1” is in the library. Where does it hang? Put it on the map, so that Farol knows where you are when it is seen. The same landmark can hang in several places.</source>
        <translation>„%1“ ist in der Bibliothek. Wo hängt es? Setzen Sie es auf die Karte, damit Farol weiß, wo Sie sind, wenn es gesehen wird. Dieselbe Landmarke kann an mehreren Orten hängen.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>The step before</source>
        <translation>Der vorige Schritt</translation>
    </message>
    <message>
        <source>Put as&amp;ide</source>
        <translation>Beiseite&amp;legen</translation>
    </message>
    <message>
        <source>Put aside</source>
        <translation>Beiseitelegen</translation>
    </message>
    <message>
        <source>Go back to the library and go on with this landmark later</source>
        <translation>Zurück zur Bibliothek und später mit dieser Landmarke weitermachen</translation>
    </message>
    <message>
        <source>Give &amp;up</source>
        <translation>A&amp;ufgeben</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Aufgeben</translation>
    </message>
    <message>
        <source>Forget this landmark</source>
        <translation>Diese Landmarke vergessen</translation>
    </message>
    <message>
        <source>Put it on the &amp;map…</source>
        <translation>Auf die &amp;Karte setzen…</translation>
    </message>
    <message>
        <source>Put it on the map</source>
        <translation>Auf die Karte setzen</translation>
    </message>
    <message>
        <source>Choose its place on the Map page</source>
        <translation>Den Ort auf der Seite Karte wählen</translation>
    </message>
    <message>
        <source>Teach an&amp;other</source>
        <translation>Ei&amp;ne weitere beibringen</translation>
    </message>
    <message>
        <source>Teach another</source>
        <translation>Eine weitere beibringen</translation>
    </message>
    <message>
        <source>Teach the next landmark</source>
        <translation>Die nächste Landmarke beibringen</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachSession</name>
    <message>
        <source>Give it a name first.</source>
        <translation>Geben Sie ihr zuerst einen Namen.</translation>
    </message>
    <message>
        <source>Say what maps shall call it: letters and digits.</source>
        <translation>Sagen Sie, wie Karten es nennen sollen: Buchstaben und Ziffern.</translation>
    </message>
    <message>
        <source>“%1” is in the library already. Choose another name, or add views to that one.</source>
        <translation>„%1“ ist schon in der Bibliothek. Wählen Sie einen anderen Namen, oder fügen Sie dort Ansichten hinzu.</translation>
    </message>
    <message>
        <source>there is no view yet</source>
        <translation>es gibt noch kein Foto</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachTry</name>
    <message>
        <source>Folder of a recorded walk, or of pictures</source>
        <translation>Ordner einer aufgenommenen Begehung oder von Bildern</translation>
    </message>
    <message>
        <source>Found, %1 % sure.</source>
        <translation>Gefunden, zu %1 % sicher.</translation>
    </message>
    <message>
        <source>About %1 m away.</source>
        <translation>Etwa %1 m entfernt.</translation>
    </message>
    <message>
        <source>Not found.</source>
        <translation>Nicht gefunden.</translation>
    </message>
    <message>
        <source>Not found: %1.</source>
        <translation>Nicht gefunden: %1.</translation>
    </message>
    <message>
        <source>Also seen: %1.</source>
        <translation>Auch gesehen: %1.</translation>
    </message>
    <message>
        <source>Found in %1 of %2 pictures looked at.</source>
        <translation>In %1 von %2 angesehenen Bildern gefunden.</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Sucht…</translation>
    </message>
    <message>
        <source>No picture yet.</source>
        <translation>Noch kein Bild.</translation>
    </message>
    <message>
        <source>Looking how well it is found…</source>
        <translation>Sieht nach, wie gut es gefunden wird…</translation>
    </message>
    <message>
        <source>Walk towards it, past it and away from it, or step through other pictures, and see whether Farol finds it. Go back to add views where it is lost.</source>
        <translation>Gehen Sie darauf zu, daran vorbei und davon weg, oder blättern Sie durch andere Bilder, und sehen Sie, ob Farol es findet. Gehen Sie zurück, um Ansichten zu ergänzen, wo es verloren geht.</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Look for it with the camera of this computer</source>
        <translation>Mit der Kamera dieses Computers danach suchen</translation>
    </message>
    <message>
        <source>&amp;Recording…</source>
        <translation>&amp;Aufnahme…</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Look for it in a recorded walk, or in any folder of pictures</source>
        <translation>In einer aufgenommenen Begehung oder einem Bilderordner danach suchen</translation>
    </message>
    <message>
        <source>Pre&amp;vious picture</source>
        <translation>&amp;Voriges Bild</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Voriges Bild</translation>
    </message>
    <message>
        <source>The picture before</source>
        <translation>Das Bild davor</translation>
    </message>
    <message>
        <source>Ne&amp;xt picture</source>
        <translation>&amp;Nächstes Bild</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>The picture after</source>
        <translation>Das Bild danach</translation>
    </message>
    <message>
        <source>Picture with what was recognised</source>
        <translation>Bild mit dem Erkannten</translation>
    </message>
    <message>
        <source>What was recognised in this picture, and what nearly was</source>
        <translation>Was in diesem Bild erkannt wurde, und was beinahe</translation>
    </message>
    <message>
        <source>How well it will be found</source>
        <translation>Wie gut es gefunden wird</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachViews</name>
    <message>
        <source>No outline was found. Set the four corners yourself.</source>
        <translation>Es wurde kein Umriss gefunden. Setzen Sie die vier Ecken selbst.</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (%2)</source>
        <translation>Bilder (%1);;Alle Dateien (%2)</translation>
    </message>
    <message>
        <source>Folder of a recorded walk, or of pictures</source>
        <translation>Ordner einer aufgenommenen Begehung oder von Bildern</translation>
    </message>
    <message>
        <source>Learning this view…</source>
        <translation>Lernt diese Ansicht…</translation>
    </message>
    <message numerus="yes">
        <source>This picture is good: %n point(s).</source>
        <translation>
            <numerusform>Dieses Bild ist gut: ein Punkt.</numerusform>
            <numerusform>Dieses Bild ist gut: %n Punkte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Coach: %1</source>
        <translation>Rat: %1</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 von %3)</translation>
    </message>
    <message>
        <source>Looking how well it is found…</source>
        <translation>Sieht nach, wie gut es gefunden wird…</translation>
    </message>
    <message>
        <source>Nothing yet: add a view.</source>
        <translation>Noch nichts: Fügen Sie eine Ansicht hinzu.</translation>
    </message>
    <message numerus="yes">
        <source>With the %n view(s) it had before.</source>
        <translation>
            <numerusform>Mit der einen Ansicht von vorher.</numerusform>
            <numerusform>Mit den %n Ansichten von vorher.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Take photographs with the camera of this computer</source>
        <translation>Mit der Kamera dieses Computers fotografieren</translation>
    </message>
    <message>
        <source>&amp;Pictures…</source>
        <translation>&amp;Bilder…</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Choose photographs from files</source>
        <translation>Fotos aus Dateien wählen</translation>
    </message>
    <message>
        <source>&amp;Recording…</source>
        <translation>&amp;Aufnahme…</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Choose the folder of a recorded walk, or any folder of pictures</source>
        <translation>Den Ordner einer aufgenommenen Begehung oder einen Bilderordner wählen</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>Festha&amp;lten</translation>
    </message>
    <message>
        <source>Hold the picture</source>
        <translation>Das Bild festhalten</translation>
    </message>
    <message>
        <source>Keep the picture that the camera shows now</source>
        <translation>Das Bild behalten, das die Kamera jetzt zeigt</translation>
    </message>
    <message>
        <source>Pre&amp;vious picture</source>
        <translation>&amp;Voriges Bild</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Voriges Bild</translation>
    </message>
    <message>
        <source>The picture before</source>
        <translation>Das Bild davor</translation>
    </message>
    <message>
        <source>Ne&amp;xt picture</source>
        <translation>&amp;Nächstes Bild</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>The picture after</source>
        <translation>Das Bild danach</translation>
    </message>
    <message>
        <source>&amp;Find outline</source>
        <translation>&amp;Umriss suchen</translation>
    </message>
    <message>
        <source>Find the outline</source>
        <translation>Den Umriss suchen</translation>
    </message>
    <message>
        <source>Look for the outline in this picture</source>
        <translation>In diesem Bild nach dem Umriss suchen</translation>
    </message>
    <message>
        <source>Whole p&amp;icture</source>
        <translation>&amp;Ganzes Bild</translation>
    </message>
    <message>
        <source>Outline the whole picture</source>
        <translation>Das ganze Bild als Umriss nehmen</translation>
    </message>
    <message>
        <source>Set the corners to those of the picture</source>
        <translation>Die Ecken auf die des Bildes setzen</translation>
    </message>
    <message>
        <source>&amp;Add this view</source>
        <translation>Ansicht &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Add this view</source>
        <translation>Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Learn the landmark from this picture</source>
        <translation>Die Landmarke aus diesem Bild lernen</translation>
    </message>
    <message>
        <source>Re&amp;move view</source>
        <translation>Ansicht &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen view</source>
        <translation>Die gewählte Ansicht entfernen</translation>
    </message>
    <message>
        <source>Forget the chosen view</source>
        <translation>Die gewählte Ansicht vergessen</translation>
    </message>
    <message>
        <source>Coach</source>
        <translation>Rat</translation>
    </message>
    <message>
        <source>Views so far</source>
        <translation>Ansichten bisher</translation>
    </message>
    <message>
        <source>How well it will be found</source>
        <translation>Wie gut es gefunden wird</translation>
    </message>
    <message>
        <source>The photographs it is learnt from</source>
        <translation>Die Fotos, aus denen gelernt wird</translation>
    </message>
    <message>
        <source>Picture with outline</source>
        <translation>Bild mit Umriss</translation>
    </message>
    <message>
        <source>Drag the four corners onto the landmark. By keys: 1 to 4 choose a corner, the arrows move it, with Shift by one pixel.</source>
        <translation>Ziehen Sie die vier Ecken auf die Landmarke. Mit Tasten: 1 bis 4 wählen eine Ecke, die Pfeile bewegen sie, mit Umschalt um ein Pixel.</translation>
    </message>
    <message>
        <source>No picture yet.
Switch on the camera, or choose pictures or a recording.</source>
        <translation>Noch kein Bild.
Schalten Sie die Kamera ein, oder wählen Sie Bilder oder eine Aufnahme.</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachWhat</name>
    <message>
        <source>What is it that Farol shall know again? A sign, a poster, a door with something on it: flat things with detail are known best. Choose “known place” for the whole view of a spot.</source>
        <translation>Was soll Farol wiedererkennen? Ein Schild, ein Plakat, eine Tür mit etwas darauf: Flaches mit vielen Einzelheiten wird am besten erkannt. Wählen Sie „bekannter Ort“ für die ganze Ansicht einer Stelle.</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Name:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What people call it</source>
        <translation>Wie die Leute es nennen</translation>
    </message>
    <message>
        <source>&amp;Kind:</source>
        <translation>A&amp;rt:</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>Real &amp;width:</source>
        <translation>Wirkliche &amp;Breite:</translation>
    </message>
    <message>
        <source>Real width</source>
        <translation>Wirkliche Breite</translation>
    </message>
    <message>
        <source>Lets Farol tell how far away it is</source>
        <translation>Daraus weiß Farol, wie weit es weg ist</translation>
    </message>
    <message>
        <source>Real &amp;height:</source>
        <translation>Wirkliche &amp;Höhe:</translation>
    </message>
    <message>
        <source>Real height</source>
        <translation>Wirkliche Höhe</translation>
    </message>
    <message>
        <source>In &amp;maps called:</source>
        <translation>In Kar&amp;ten genannt:</translation>
    </message>
    <message>
        <source>In maps called</source>
        <translation>In Karten genannt</translation>
    </message>
    <message>
        <source>Landmarks of the map refer to it by this word, so it should not change</source>
        <translation>Landmarken der Karte nennen es mit diesem Wort; es sollte sich nicht ändern</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
</context>
<context>
    <name>farol::ui::TimelineBar</name>
    <message>
        <source>T&amp;imeline:</source>
        <translation>&amp;Zeitleiste:</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>How sure the place was, and marks where something was said. Drag it, or use the arrow keys, to look back; End goes back to now.</source>
        <translation>Wie sicher der Ort war, mit Marken, wo etwas gesagt wurde. Ziehen Sie sie oder benutzen Sie die Pfeile, um zurückzuschauen; Ende kehrt zum Jetzt zurück.</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Back to now</source>
        <translation>Zurück zum Jetzt</translation>
    </message>
    <message>
        <source>Show the walk as it is now</source>
        <translation>Die Begehung zeigen, wie sie jetzt ist</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Looking back at %1</source>
        <translation>Rückblick auf %1</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingActions</name>
    <message>
        <source>&amp;Landmarks</source>
        <translation>&amp;Landmarken</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>&amp;Open library…</source>
        <translation>Bibliothek ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Eine Landmarkenbibliothek öffnen</translation>
    </message>
    <message>
        <source>&amp;New library…</source>
        <translation>&amp;Neue Bibliothek…</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Make an empty landmark library</source>
        <translation>Eine leere Landmarkenbibliothek anlegen</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Write the library into another file; every change is saved by itself</source>
        <translation>Die Bibliothek in eine andere Datei schreiben; jede Änderung wird von selbst gespeichert</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Make the change again that was taken back</source>
        <translation>Die zurückgenommene Änderung wieder vornehmen</translation>
    </message>
    <message>
        <source>&amp;Teach a landmark</source>
        <translation>Landmarke &amp;beibringen</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Beibringen</translation>
    </message>
    <message>
        <source>Teach Farol a new landmark, step by step</source>
        <translation>Farol eine neue Landmarke Schritt für Schritt beibringen</translation>
    </message>
    <message>
        <source>Add &amp;views</source>
        <translation>&amp;Ansichten hinzufügen</translation>
    </message>
    <message>
        <source>Add views</source>
        <translation>Ansichten hinzufügen</translation>
    </message>
    <message>
        <source>Teach more views of the chosen landmark</source>
        <translation>Weitere Ansichten der gewählten Landmarke beibringen</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>Än&amp;dern…</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Change the name, kind or size of the chosen landmark</source>
        <translation>Name, Art oder Größe der gewählten Landmarke ändern</translation>
    </message>
    <message>
        <source>&amp;Merge with…</source>
        <translation>&amp;Zusammenlegen mit…</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Zusammenlegen</translation>
    </message>
    <message>
        <source>Make the chosen landmark and another one the same</source>
        <translation>Die gewählte Landmarke und eine andere zu einer machen</translation>
    </message>
    <message>
        <source>&amp;Split…</source>
        <translation>Ab&amp;trennen…</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Abtrennen</translation>
    </message>
    <message>
        <source>Make the chosen views a landmark of their own</source>
        <translation>Aus den gewählten Ansichten eine eigene Landmarke machen</translation>
    </message>
    <message>
        <source>Delete the chosen vie&amp;ws</source>
        <translation>Gewählte An&amp;sichten löschen</translation>
    </message>
    <message>
        <source>Delete views</source>
        <translation>Ansichten löschen</translation>
    </message>
    <message>
        <source>Forget the chosen views of the landmark</source>
        <translation>Die gewählten Ansichten der Landmarke vergessen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>L&amp;öschen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Forget the chosen landmark</source>
        <translation>Die gewählte Landmarke vergessen</translation>
    </message>
    <message>
        <source>&amp;Put on the map…</source>
        <translation>Auf die &amp;Karte setzen…</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>Auf die Karte</translation>
    </message>
    <message>
        <source>Put the chosen landmark on the map</source>
        <translation>Die gewählte Landmarke auf die Karte setzen</translation>
    </message>
    <message>
        <source>C&amp;heck all</source>
        <translation>Alle &amp;prüfen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Look how well each landmark is found and which are taken for each other</source>
        <translation>Nachsehen, wie gut jede Landmarke gefunden wird und welche verwechselt werden</translation>
    </message>
    <message>
        <source>Wal&amp;k with this library</source>
        <translation>Mit dieser Bibliothek be&amp;gehen</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Begehung</translation>
    </message>
    <message>
        <source>Use this library on the Walk page</source>
        <translation>Diese Bibliothek auf der Seite Begehung verwenden</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingPage</name>
    <message>
        <source>Open another &amp;library…</source>
        <translation>Andere &amp;Bibliothek öffnen…</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Save el&amp;sewhere…</source>
        <translation>Anderswo &amp;speichern…</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Landmarkenbibliothek öffnen</translation>
    </message>
    <message>
        <source>Landmark libraries (%1);;All files (%2)</source>
        <translation>Landmarkenbibliotheken (%1);;Alle Dateien (%2)</translation>
    </message>
    <message>
        <source>New landmark library</source>
        <translation>Neue Landmarkenbibliothek</translation>
    </message>
    <message>
        <source>Landmark libraries (%1)</source>
        <translation>Landmarkenbibliotheken (%1)</translation>
    </message>
    <message>
        <source>Save the library as</source>
        <translation>Bibliothek speichern unter</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is unfinished, with %n view(s).</source>
        <translation>
            <numerusform>„%1“ ist unfertig, mit einer Ansicht.</numerusform>
            <numerusform>„%1“ ist unfertig, mit %n Ansichten.</numerusform>
        </translation>
    </message>
    <message>
        <source>A new landmark</source>
        <translation>Eine neue Landmarke</translation>
    </message>
    <message>
        <source>Go &amp;on with it</source>
        <translation>Damit &amp;weitermachen</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>„%1“ beibringen</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>Tabelle (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Arbeitet…</translation>
    </message>
    <message>
        <source>%1 · being saved</source>
        <translation>%1 · wird gespeichert</translation>
    </message>
    <message>
        <source>%1 · saved</source>
        <translation>%1 · gespeichert</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Merge landmarks</source>
        <translation>Landmarken zusammenlegen</translation>
    </message>
    <message>
        <source>The views of this landmark go to “%1”, and it is deleted:</source>
        <translation>Die Ansichten dieser Landmarke gehen an „%1“, und sie wird gelöscht:</translation>
    </message>
    <message>
        <source>Split the landmark</source>
        <translation>Landmarke abtrennen</translation>
    </message>
    <message numerus="yes">
        <source>Name of the landmark that the %n chosen view(s) become:</source>
        <translation>
            <numerusform>Name der Landmarke, zu der die gewählte Ansicht wird:</numerusform>
            <numerusform>Name der Landmarke, zu der die %n gewählten Ansichten werden:</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete views</source>
        <translation>Ansichten löschen</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>„%1“ löschen</translation>
    </message>
    <message>
        <source>Not saved: another program has changed the same landmarks in %1. Save yours under another name; what the other program wrote stays.</source>
        <translation>Nicht gespeichert: Ein anderes Programm hat dieselben Landmarken in %1 geändert. Speichern Sie Ihre unter einem anderen Namen; was das andere Programm geschrieben hat, bleibt.</translation>
    </message>
    <message>
        <source>Another program has changed %1 meanwhile: its changes and yours are both saved. Earlier steps can no longer be undone.</source>
        <translation>Inzwischen hat ein anderes Programm %1 geändert: Seine Änderungen und Ihre sind gespeichert. Frühere Schritte lassen sich nicht mehr zurücknehmen.</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Ein anderes Programm hat %1 geändert.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>Neu &amp;laden</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingWords</name>
    <message>
        <source>Too dark. Switch on a light.</source>
        <translation>Zu dunkel. Schalten Sie ein Licht ein.</translation>
    </message>
    <message>
        <source>Too bright. Turn away from the window or the lamp.</source>
        <translation>Zu hell. Wenden Sie sich vom Fenster oder von der Lampe ab.</translation>
    </message>
    <message>
        <source>Blurred. Hold the camera still, or wait until it is sharp.</source>
        <translation>Unscharf. Halten Sie die Kamera ruhig, oder warten Sie, bis es scharf ist.</translation>
    </message>
    <message>
        <source>Too small in the picture. Go nearer.</source>
        <translation>Zu klein im Bild. Gehen Sie näher heran.</translation>
    </message>
    <message>
        <source>Too little detail inside the outline. Go nearer, or choose something with more detail.</source>
        <translation>Zu wenig Einzelheiten im Umriss. Gehen Sie näher heran, oder wählen Sie etwas mit mehr Einzelheiten.</translation>
    </message>
    <message>
        <source>The corners cross. Set them clockwise from the top left.</source>
        <translation>Die Ecken überkreuzen sich. Setzen Sie sie im Uhrzeigersinn von oben links.</translation>
    </message>
    <message>
        <source>Next: straight from the front, about 2 metres away.</source>
        <translation>Als Nächstes: gerade von vorn, aus etwa 2 Metern.</translation>
    </message>
    <message>
        <source>Next: from farther away, about twice as far.</source>
        <translation>Als Nächstes: von weiter weg, etwa doppelt so weit.</translation>
    </message>
    <message>
        <source>Next: the same view from a step aside, or a step nearer.</source>
        <translation>Als Nächstes: dieselbe Ansicht einen Schritt daneben oder einen Schritt näher.</translation>
    </message>
    <message>
        <source>These views are enough. More do no harm.</source>
        <translation>Diese Ansichten genügen. Mehr schadet nicht.</translation>
    </message>
    <message>
        <source>Found in %1 of its %2 views by the others.</source>
        <translation>In %1 seiner %2 Ansichten durch die anderen gefunden.</translation>
    </message>
    <message>
        <source>Found from up to about %1 m (%2 pixels).</source>
        <translation>Bis etwa %1 m gefunden (%2 Pixel).</translation>
    </message>
    <message>
        <source>Found down to a size of %1 pixels in the picture; give its real size to learn how far that is.</source>
        <translation>Bis zu einer Größe von %1 Pixeln im Bild gefunden; geben Sie die wirkliche Größe an, um zu erfahren, wie weit das ist.</translation>
    </message>
    <message>
        <source>Never found when shown smaller or turned. Choose something with more detail.</source>
        <translation>Kleiner oder gedreht nie gefunden. Wählen Sie etwas mit mehr Einzelheiten.</translation>
    </message>
    <message>
        <source>Taken for another: %1.</source>
        <translation>Für etwas anderes gehalten: %1.</translation>
    </message>
    <message>
        <source>Others are taken for it: %1.</source>
        <translation>Andere werden dafür gehalten: %1.</translation>
    </message>
    <message>
        <source>Confused with none of the others.</source>
        <translation>Mit keinem der anderen verwechselt.</translation>
    </message>
    <message>
        <source>confused with %1</source>
        <translation>verwechselt mit %1</translation>
    </message>
    <message>
        <source>hard to find</source>
        <translation>schwer zu finden</translation>
    </message>
    <message>
        <source>found from near only</source>
        <translation>nur aus der Nähe gefunden</translation>
    </message>
    <message>
        <source>%1 of %2 views found again</source>
        <translation>%1 von %2 Ansichten wiedergefunden</translation>
    </message>
    <message>
        <source>one view only</source>
        <translation>nur eine Ansicht</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>No view is straight from the front: add one, to learn from how far it is found.</source>
        <translation>Keine Ansicht ist gerade von vorn: Fügen Sie eine hinzu, um zu erfahren, aus welcher Entfernung es gefunden wird.</translation>
    </message>
    <message>
        <source>Next: from the left, at an angle.</source>
        <translation>Als Nächstes: von links, schräg.</translation>
    </message>
    <message>
        <source>Next: from the right, at an angle.</source>
        <translation>Als Nächstes: von rechts, schräg.</translation>
    </message>
    <message>
        <source>There is only one view: add another, so that it can be tried.</source>
        <translation>Es gibt nur eine Ansicht: Fügen Sie eine weitere hinzu, damit sie sich prüfen lässt.</translation>
    </message>
    <message>
        <source>Found at angles of up to %1 degrees.</source>
        <translation>Bis zu einem Winkel von %1 Grad gefunden.</translation>
    </message>
    <message>
        <source>Not found at an angle. Add views from the left and the right.</source>
        <translation>Schräg nicht gefunden. Fügen Sie Ansichten von links und rechts hinzu.</translation>
    </message>
</context>
<context>
    <name>farol::ui::UtteranceLog</name>
    <message>
        <source>What is said cannot be written to %1: %2. Choose another file.</source>
        <translation>Was gesagt wird, kann nicht in %1 geschrieben werden: %2. Wählen Sie eine andere Datei.</translation>
    </message>
</context>
<context>
    <name>farol::ui::UtteranceModel</name>
    <message>
        <source>Caused by picture %1</source>
        <translation>Ausgelöst durch Bild %1</translation>
    </message>
    <message>
        <source>Shown as text, not heard</source>
        <translation>Als Text gezeigt, nicht gehört</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Sentence</source>
        <translation>Satz</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Because</source>
        <translation>Weil</translation>
    </message>
</context>
<context>
    <name>farol::ui::Voice</name>
    <message>
        <source>The voice &quot;%1&quot; is not installed. Choose another one in the settings.</source>
        <translation>Die Stimme &quot;%1&quot; ist nicht installiert. Wählen Sie in den Einstellungen eine andere.</translation>
    </message>
    <message>
        <source>The voice &quot;%1&quot; does not start: %2</source>
        <translation>Die Stimme &quot;%1&quot; startet nicht: %2</translation>
    </message>
    <message>
        <source>The voice &quot;%1&quot; does not speak this language. Choose another one in the settings.</source>
        <translation>Die Stimme &quot;%1&quot; spricht diese Sprache nicht. Wählen Sie in den Einstellungen eine andere.</translation>
    </message>
    <message>
        <source>No voice is installed.</source>
        <translation>Es ist keine Stimme installiert.</translation>
    </message>
    <message>
        <source>There is no sound device. Connect headphones or a loudspeaker.</source>
        <translation>Es gibt kein Audiogerät. Schließen Sie Kopfhörer oder einen Lautsprecher an.</translation>
    </message>
    <message>
        <source>The voice does not work. Choose another one in the settings.</source>
        <translation>Die Stimme geht nicht. Wählen Sie in den Einstellungen eine andere.</translation>
    </message>
</context>
<context>
    <name>farol::ui::VoteDetailModel</name>
    <message>
        <source>seen at %1</source>
        <translation>gesehen bei %1</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>speaks for it</source>
        <translation>spricht dafür</translation>
    </message>
    <message>
        <source>none of the objects last seen stands there</source>
        <translation>keiner der zuletzt gesehenen Gegenstände steht dort</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Begriff</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
</context>
<context>
    <name>farol::ui::VoteModel</name>
    <message numerus="yes">
        <source>%n matching object(s)</source>
        <translation>
            <numerusform>ein passender Gegenstand</numerusform>
            <numerusform>%n passende Gegenstände</numerusform>
        </translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Votes</source>
        <translation>Stimmen</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Besteht aus</translation>
    </message>
</context>
<context>
    <name>farol::ui::Walk</name>
    <message numerus="yes">
        <source>%n remark(s) about the map: %1</source>
        <translation>
            <numerusform>eine Bemerkung zur Karte: %1</numerusform>
            <numerusform>%n Bemerkungen zur Karte: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet…</translation>
    </message>
    <message>
        <source>Loading…</source>
        <translation>Lädt…</translation>
    </message>
    <message>
        <source>Open a map first (Ctrl+O).</source>
        <translation>Öffnen Sie zuerst eine Karte (Strg+O).</translation>
    </message>
    <message>
        <source>Open a camera, a video or a folder of pictures first (Ctrl+P).</source>
        <translation>Öffnen Sie zuerst eine Kamera, ein Video oder einen Bilderordner (Strg+P).</translation>
    </message>
    <message>
        <source>No trained landmarks: only doors and texts are recognised. Open a library of landmarks to recognise more.</source>
        <translation>Keine trainierten Landmarken: Nur Türen und Texte werden erkannt. Öffnen Sie eine Bibliothek von Landmarken, um mehr zu erkennen.</translation>
    </message>
    <message>
        <source>the folder for recordings cannot be made; choose another one in the settings</source>
        <translation>der Ordner für Aufnahmen lässt sich nicht anlegen; wählen Sie in den Einstellungen einen anderen</translation>
    </message>
</context>
<context>
    <name>farol::ui::WelcomeDialog</name>
    <message>
        <source>Welcome to Farol</source>
        <translation>Willkommen bei Farol</translation>
    </message>
    <message>
        <source>Farol guides a blind person through a building with one camera. It needs a map of the building, and landmarks that it was taught. What do you want to do?</source>
        <translation>Farol führt einen blinden Menschen mit einer Kamera durch ein Gebäude. Es braucht eine Karte des Gebäudes und Landmarken, die ihm beigebracht wurden. Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>&amp;Guide somebody</source>
        <translation>&amp;Jemanden führen</translation>
    </message>
    <message>
        <source>Open a map and a camera, and choose where to go</source>
        <translation>Eine Karte und eine Kamera öffnen und wählen, wohin es geht</translation>
    </message>
    <message>
        <source>Work on a &amp;map</source>
        <translation>An einer &amp;Karte arbeiten</translation>
    </message>
    <message>
        <source>Bring in a floor plan, check it, and put landmarks on it</source>
        <translation>Einen Grundriss übernehmen, prüfen und Landmarken daraufsetzen</translation>
    </message>
    <message>
        <source>Teach &amp;landmarks</source>
        <translation>&amp;Landmarken beibringen</translation>
    </message>
    <message>
        <source>Photograph what Farol shall know again</source>
        <translation>Fotografieren, was Farol wiedererkennen soll</translation>
    </message>
    <message>
        <source>Read the &amp;help</source>
        <translation>Die &amp;Hilfe lesen</translation>
    </message>
    <message>
        <source>What each page is for, and its keys; F1 at any time</source>
        <translation>Wozu jede Seite dient, und ihre Tasten; F1 jederzeit</translation>
    </message>
    <message>
        <source>For a blind user who is alone, start “farol --kiosk”: full screen, by keys and speech.</source>
        <translation>Für einen blinden Benutzer, der allein ist, starten Sie „farol --kiosk“: ganzer Bildschirm, mit Tasten und Sprache.</translation>
    </message>
</context>
<context>
    <name>farol::ui::WindowActions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Walk</source>
        <translation>&amp;Begehung</translation>
    </message>
    <message>
        <source>V&amp;oice</source>
        <translation>&amp;Stimme</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>R&amp;ecent maps</source>
        <translation>Zuletzt geöffnete K&amp;arten</translation>
    </message>
    <message>
        <source>Recent landmark li&amp;braries</source>
        <translation>Zuletzt geöffnete B&amp;ibliotheken</translation>
    </message>
    <message>
        <source>Recent pi&amp;ctures</source>
        <translation>&amp;Zuletzt geöffnete Bilder</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>Karte ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Open the map of a building</source>
        <translation>Die Karte eines Gebäudes öffnen</translation>
    </message>
    <message>
        <source>Open landmark &amp;library…</source>
        <translation>&amp;Landmarkenbibliothek öffnen…</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Open the landmarks that Farol was taught</source>
        <translation>Die Landmarken öffnen, die Farol gelernt hat</translation>
    </message>
    <message>
        <source>&amp;Close landmark library</source>
        <translation>Landmarkenbibliothek s&amp;chließen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Walk without taught landmarks</source>
        <translation>Ohne gelernte Landmarken gehen</translation>
    </message>
    <message>
        <source>Open &amp;pictures…</source>
        <translation>&amp;Bilder öffnen…</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Choose a camera, a video, a folder or an address</source>
        <translation>Eine Kamera, ein Video, einen Ordner oder eine Adresse wählen</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Language, voice and what is told</source>
        <translation>Sprache, Stimme und was gesagt wird</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Been&amp;den</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Leave Farol</source>
        <translation>Farol verlassen</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Hold the walk</source>
        <translation>Die Begehung anhalten</translation>
    </message>
    <message>
        <source>Start the walk, or go on</source>
        <translation>Die Begehung beginnen oder fortsetzen</translation>
    </message>
    <message>
        <source>&amp;One picture</source>
        <translation>&amp;Ein Bild</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Go on by one picture, then hold</source>
        <translation>Ein Bild weiter, dann anhalten</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>Die Begehung beenden</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>S&amp;chneller</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>Schneller abspielen</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>Langsamer abspielen</translation>
    </message>
    <message>
        <source>Choose &amp;destination</source>
        <translation>&amp;Ziel wählen</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Choose where to go</source>
        <translation>Wählen, wohin es geht</translation>
    </message>
    <message>
        <source>&amp;No destination</source>
        <translation>&amp;Kein Ziel</translation>
    </message>
    <message>
        <source>No destination</source>
        <translation>Kein Ziel</translation>
    </message>
    <message>
        <source>Give up the destination</source>
        <translation>Das Ziel aufgeben</translation>
    </message>
    <message>
        <source>Choose st&amp;art</source>
        <translation>&amp;Start wählen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Say where the walk starts</source>
        <translation>Sagen, wo die Begehung beginnt</translation>
    </message>
    <message>
        <source>&amp;Record the walk</source>
        <translation>Begehung auf&amp;nehmen</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Keep the next walk in a folder, to be replayed</source>
        <translation>Die nächste Begehung in einem Ordner festhalten, um sie wiederzugeben</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Say the last instruction again</source>
        <translation>Die letzte Anweisung noch einmal sagen</translation>
    </message>
    <message>
        <source>Voice o&amp;ff</source>
        <translation>Stimme &amp;aus</translation>
    </message>
    <message>
        <source>Voice off</source>
        <translation>Stimme aus</translation>
    </message>
    <message>
        <source>Show sentences without speaking them</source>
        <translation>Sätze zeigen, ohne sie zu sprechen</translation>
    </message>
    <message>
        <source>Wal&amp;k page</source>
        <translation>Seite &amp;Begehung</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Begehung</translation>
    </message>
    <message>
        <source>Watch a walk</source>
        <translation>Eine Begehung verfolgen</translation>
    </message>
    <message>
        <source>&amp;Map page</source>
        <translation>Seite &amp;Karte</translation>
    </message>
    <message>
        <source>Look at the map of a building, check it and change it</source>
        <translation>Die Karte eines Gebäudes ansehen, prüfen und ändern</translation>
    </message>
    <message>
        <source>&amp;Whole floor</source>
        <translation>&amp;Ganzes Stockwerk</translation>
    </message>
    <message>
        <source>Whole floor</source>
        <translation>Ganzes Stockwerk</translation>
    </message>
    <message>
        <source>Show the whole floor</source>
        <translation>Das ganze Stockwerk zeigen</translation>
    </message>
    <message>
        <source>&amp;Larger map</source>
        <translation>Karte g&amp;rößer</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Show the map larger</source>
        <translation>Die Karte größer zeigen</translation>
    </message>
    <message>
        <source>&amp;Smaller map</source>
        <translation>Karte k&amp;leiner</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Show the map smaller</source>
        <translation>Die Karte kleiner zeigen</translation>
    </message>
    <message>
        <source>&amp;Follow to other floors</source>
        <translation>Auf andere Stockwerke &amp;folgen</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Switch to the floor where you are</source>
        <translation>Zum Stockwerk wechseln, auf dem Sie sind</translation>
    </message>
    <message>
        <source>&amp;Grid over the picture</source>
        <translation>Raster über dem Bil&amp;d</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Show the nine parts of the picture</source>
        <translation>Die neun Teile des Bildes zeigen</translation>
    </message>
    <message>
        <source>&amp;What was not accepted</source>
        <translation>&amp;Was nicht angenommen wurde</translation>
    </message>
    <message>
        <source>Not accepted</source>
        <translation>Nicht angenommen</translation>
    </message>
    <message>
        <source>Show what was nearly recognised, and why not</source>
        <translation>Zeigen, was fast erkannt wurde, und warum nicht</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>&amp;Nächster Teil des Fensters</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächster</translation>
    </message>
    <message>
        <source>Go to the next part of the window</source>
        <translation>Zum nächsten Teil des Fensters gehen</translation>
    </message>
    <message>
        <source>&amp;Previous part of the window</source>
        <translation>&amp;Voriger Teil des Fensters</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Voriger</translation>
    </message>
    <message>
        <source>Go to the previous part of the window</source>
        <translation>Zum vorigen Teil des Fensters gehen</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Every key of this window</source>
        <translation>Alle Tasten dieses Fensters</translation>
    </message>
    <message>
        <source>&amp;About Farol</source>
        <translation>&amp;Über Farol</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>What Farol is</source>
        <translation>Was Farol ist</translation>
    </message>
    <message>
        <source>&amp;Speed:</source>
        <translation>&amp;Tempo:</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast pictures from files are played</source>
        <translation>Wie schnell Bilder aus Dateien abgespielt werden</translation>
    </message>
    <message>
        <source>Landmark&amp;s page</source>
        <translation>Seite &amp;Landmarken</translation>
    </message>
    <message>
        <source>Teach Farol landmarks, check them and change them</source>
        <translation>Farol Landmarken beibringen, sie prüfen und ändern</translation>
    </message>
    <message>
        <source>The user is &amp;here</source>
        <translation>Der Benutzer ist &amp;hier</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Hier</translation>
    </message>
    <message>
        <source>The user is in the place that is chosen on the map or in the list</source>
        <translation>Der Benutzer ist an dem Ort, der auf der Karte oder in der Liste gewählt ist</translation>
    </message>
    <message>
        <source>That is &amp;wrong</source>
        <translation>Das ist &amp;falsch</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Falsch</translation>
    </message>
    <message>
        <source>The place shown is wrong: look for it anew</source>
        <translation>Der gezeigte Ort ist falsch: neu suchen</translation>
    </message>
    <message>
        <source>&amp;Work out a recorded walk anew…</source>
        <translation>Aufgenommene Begehung neu &amp;berechnen…</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Compare a recorded walk with the same walk worked out otherwise</source>
        <translation>Eine aufgenommene Begehung mit derselben, anders berechnet, vergleichen</translation>
    </message>
    <message>
        <source>&amp;Say this…</source>
        <translation>&amp;Dies sagen…</translation>
    </message>
    <message>
        <source>Say</source>
        <translation>Sagen</translation>
    </message>
    <message>
        <source>Type a sentence that is spoken to the user</source>
        <translation>Einen Satz tippen, der dem Benutzer gesagt wird</translation>
    </message>
    <message>
        <source>Sa&amp;ve the picture…</source>
        <translation>Bild s&amp;peichern…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Save what the camera sees, with what was recognised</source>
        <translation>Speichern, was die Kamera sieht, mit dem Erkannten</translation>
    </message>
    <message>
        <source>Save the walk as &amp;table…</source>
        <translation>Begehung als Tabelle speiche&amp;rn…</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Save times, places and sentences of this walk for a spreadsheet</source>
        <translation>Zeiten, Orte und Sätze dieser Begehung für eine Tabellenkalkulation speichern</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>How the page that is shown is used</source>
        <translation>Wie die gezeigte Seite benutzt wird</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Willkommen</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>The page of the first start</source>
        <translation>Die Seite des ersten Starts</translation>
    </message>
    <message>
        <source>Fi&amp;gures…</source>
        <translation>Dia&amp;gramme…</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Charts of the votes, of the time that pictures took, and of how far landmarks are found</source>
        <translation>Diagramme der Stimmen, der Zeit für die Bilder und der Entfernung, aus der Landmarken gefunden werden</translation>
    </message>
</context>
<context>
    <name>farol::ui::Words</name>
    <message>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>corridor</source>
        <translation>Flur</translation>
    </message>
    <message>
        <source>hall</source>
        <translation>Halle</translation>
    </message>
    <message>
        <source>stairwell</source>
        <translation>Treppenhaus</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>Aufzug</translation>
    </message>
    <message>
        <source>toilet</source>
        <translation>Toilette</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>draußen</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>door</source>
        <translation>Tür</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>Treppe</translation>
    </message>
    <message>
        <source>escalator</source>
        <translation>Rolltreppe</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>passage</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>Ebene %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>%1 between %2 and %3</source>
        <translation>%1 zwischen %2 und %3</translation>
    </message>
    <message>
        <source>%1 (closed)</source>
        <translation>%1 (gesperrt)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, in %3</source>
        <translation>%1: %2, in %3</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>speaking</source>
        <translation>wird gesprochen</translation>
    </message>
    <message>
        <source>spoken</source>
        <translation>gesprochen</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>zu spät</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>new route</source>
        <translation>neuer Weg</translation>
    </message>
    <message>
        <source>coming up</source>
        <translation>kommt bald</translation>
    </message>
    <message>
        <source>do it now</source>
        <translation>jetzt zu tun</translation>
    </message>
    <message>
        <source>keep going</source>
        <translation>weitergehen</translation>
    </message>
    <message>
        <source>arrived</source>
        <translation>angekommen</translation>
    </message>
    <message>
        <source>left the route</source>
        <translation>Weg verlassen</translation>
    </message>
    <message>
        <source>place not known</source>
        <translation>Ort nicht bekannt</translation>
    </message>
    <message>
        <source>place found</source>
        <translation>Ort gefunden</translation>
    </message>
    <message>
        <source>object seen</source>
        <translation>Gegenstand gesehen</translation>
    </message>
    <message>
        <source>text read</source>
        <translation>Text gelesen</translation>
    </message>
    <message>
        <source>no route</source>
        <translation>kein Weg</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>schon da</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>gefragt</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>fairly sure</source>
        <translation>ziemlich sicher</translation>
    </message>
    <message>
        <source>not sure</source>
        <translation>nicht sicher</translation>
    </message>
    <message>
        <source>too few points fit</source>
        <translation>zu wenige Punkte passen</translation>
    </message>
    <message>
        <source>outline folded</source>
        <translation>Umriss gefaltet</translation>
    </message>
    <message>
        <source>looks too different</source>
        <translation>sieht zu anders aus</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>Gegenstände</translation>
    </message>
    <message>
        <source>best object</source>
        <translation>bester Gegenstand</translation>
    </message>
    <message>
        <source>near the last place</source>
        <translation>nahe dem letzten Ort</translation>
    </message>
    <message>
        <source>on the way</source>
        <translation>auf dem Weg</translation>
    </message>
    <message>
        <source>seen together</source>
        <translation>zusammen gesehen</translation>
    </message>
    <message>
        <source>weight of the place</source>
        <translation>Gewicht des Ortes</translation>
    </message>
    <message>
        <source>share seen here</source>
        <translation>hier gesehener Anteil</translation>
    </message>
    <message>
        <source>share seen next door</source>
        <translation>nebenan gesehener Anteil</translation>
    </message>
    <message>
        <source>vote</source>
        <translation>Stimme</translation>
    </message>
    <message>
        <source>does not reach the floor</source>
        <translation>reicht nicht bis zum Boden</translation>
    </message>
    <message>
        <source>two places look alike</source>
        <translation>zwei Orte sehen gleich aus</translation>
    </message>
    <message>
        <source>part of the number may be hidden</source>
        <translation>ein Teil der Nummer kann verdeckt sein</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>unscharf</translation>
    </message>
    <message>
        <source>too many lines for a door</source>
        <translation>zu viele Linien für eine Tür</translation>
    </message>
    <message>
        <source>looked at again, it was something else</source>
        <translation>noch einmal angesehen, war es etwas anderes</translation>
    </message>
    <message>
        <source>the scene changed</source>
        <translation>die Szene hat gewechselt</translation>
    </message>
    <message>
        <source>lines evenly apart, as of a shelf</source>
        <translation>Linien in gleichem Abstand, wie von einem Regal</translation>
    </message>
    <message>
        <source>too few step edges</source>
        <translation>zu wenige Stufenkanten</translation>
    </message>
    <message>
        <source>lines, but no steps</source>
        <translation>Linien, aber keine Stufen</translation>
    </message>
    <message>
        <source>lines apart as of floor tiles</source>
        <translation>Linienabstand wie bei Bodenfliesen</translation>
    </message>
    <message>
        <source>pictures too far apart to follow it</source>
        <translation>Bilder zu weit auseinander, um ihm zu folgen</translation>
    </message>
    <message>
        <source>a grid, as of tiles or windows</source>
        <translation>ein Gitter, wie von Fliesen oder Fenstern</translation>
    </message>
    <message>
        <source>too high for steps</source>
        <translation>zu hoch für eine Treppe</translation>
    </message>
    <message>
        <source>impossible size</source>
        <translation>unmögliche Größe</translation>
    </message>
    <message>
        <source>does not move as one thing</source>
        <translation>bewegt sich nicht als Ganzes</translation>
    </message>
    <message>
        <source>its sides go on above it</source>
        <translation>seine Seiten gehen darüber weiter</translation>
    </message>
    <message>
        <source>of a kind that is not looked for</source>
        <translation>von einer Art, die nicht gesucht wird</translation>
    </message>
    <message>
        <source>told by its trained look instead</source>
        <translation>stattdessen am gelernten Aussehen erkannt</translation>
    </message>
    <message>
        <source>left the picture</source>
        <translation>aus dem Bild verschwunden</translation>
    </message>
    <message>
        <source>a line goes across it</source>
        <translation>eine Linie geht quer hindurch</translation>
    </message>
    <message>
        <source>a line goes up its middle</source>
        <translation>eine Linie geht durch die Mitte hinauf</translation>
    </message>
    <message>
        <source>a stroke rather than a letter</source>
        <translation>eher ein Strich als ein Buchstabe</translation>
    </message>
    <message>
        <source>looks different now</source>
        <translation>sieht jetzt anders aus</translation>
    </message>
    <message>
        <source>a letter was missed</source>
        <translation>ein Buchstabe fehlte</translation>
    </message>
    <message>
        <source>a point was missed</source>
        <translation>ein Punkt fehlte</translation>
    </message>
    <message>
        <source>a space was missed</source>
        <translation>ein Leerzeichen fehlte</translation>
    </message>
    <message>
        <source>reading not sure</source>
        <translation>Lesung nicht sicher</translation>
    </message>
    <message>
        <source>too pale</source>
        <translation>zu blass</translation>
    </message>
    <message>
        <source>too low for stairs</source>
        <translation>zu niedrig für eine Treppe</translation>
    </message>
    <message>
        <source>not sure enough</source>
        <translation>nicht sicher genug</translation>
    </message>
    <message>
        <source>seen as in a mirror</source>
        <translation>wie im Spiegel gesehen</translation>
    </message>
    <message>
        <source>too narrow</source>
        <translation>zu schmal</translation>
    </message>
    <message>
        <source>only a small part fits</source>
        <translation>nur ein kleiner Teil passt</translation>
    </message>
    <message>
        <source>the points fit no outline</source>
        <translation>die Punkte passen zu keinem Umriss</translation>
    </message>
    <message>
        <source>no letters</source>
        <translation>keine Buchstaben</translation>
    </message>
    <message>
        <source>readings do not agree yet</source>
        <translation>Lesungen stimmen noch nicht überein</translation>
    </message>
    <message>
        <source>outline without numbers</source>
        <translation>Umriss ohne Zahlen</translation>
    </message>
    <message>
        <source>mostly outside the picture</source>
        <translation>größtenteils außerhalb des Bildes</translation>
    </message>
    <message>
        <source>lost from sight</source>
        <translation>aus den Augen verloren</translation>
    </message>
    <message>
        <source>seen only once so far</source>
        <translation>bisher nur einmal gesehen</translation>
    </message>
    <message>
        <source>only a sliver</source>
        <translation>nur ein Streifen</translation>
    </message>
    <message>
        <source>too few letters</source>
        <translation>zu wenige Buchstaben</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>zu klein</translation>
    </message>
    <message>
        <source>not seen again</source>
        <translation>nicht wieder gesehen</translation>
    </message>
    <message>
        <source>step edges of uneven contrast</source>
        <translation>Stufenkanten mit ungleichem Kontrast</translation>
    </message>
    <message>
        <source>step edges unevenly apart</source>
        <translation>Stufenkanten in ungleichem Abstand</translation>
    </message>
    <message>
        <source>read differently each time</source>
        <translation>jedes Mal anders gelesen</translation>
    </message>
    <message>
        <source>no top of a door frame</source>
        <translation>kein oberer Türrahmen</translation>
    </message>
    <message>
        <source>wider above than below</source>
        <translation>oben breiter als unten</translation>
    </message>
    <message>
        <source>in the way of walking</source>
        <translation>in Gehrichtung</translation>
    </message>
    <message>
        <source>on your level</source>
        <translation>auf Ihrer Ebene</translation>
    </message>
    <message>
        <source>matching objects</source>
        <translation>passende Gegenstände</translation>
    </message>
    <message>
        <source>matching objects next door</source>
        <translation>passende Gegenstände nebenan</translation>
    </message>
    <message>
        <source>objects seen</source>
        <translation>gesehene Gegenstände</translation>
    </message>
    <message>
        <source>share of the likelihood</source>
        <translation>Anteil der Wahrscheinlichkeit</translation>
    </message>
    <message>
        <source>could be anywhere</source>
        <translation>könnte überall sein</translation>
    </message>
    <message>
        <source>evidence against all of this</source>
        <translation>Hinweise gegen all dies</translation>
    </message>
    <message>
        <source>a likeness within one already found</source>
        <translation>eine Ähnlichkeit in etwas schon Gefundenem</translation>
    </message>
</context>
</TS>
