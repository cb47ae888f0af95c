<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>core</name>
    <message numerus="yes">
        <source>%n features have no id; give each its own</source>
        <translation>
            <numerusform>%n feature has no id; give each its own</numerusform>
            <numerusform>%n features have no id; give each its own</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features share the id &quot;%1&quot;; give each its own</source>
        <translation>
            <numerusform>%n features share the id &quot;%1&quot;; give each its own</numerusform>
            <numerusform>%n features share the id &quot;%1&quot;; give each its own</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions have neither name nor ref: only its kind is spoken</source>
        <translation>
            <numerusform>%n region has neither name nor ref: only its kind is spoken</numerusform>
            <numerusform>%n regions have neither name nor ref: only its kind is spoken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions are called &quot;%1&quot; or the like, which is never spoken; give it the name that people use</source>
        <translation>
            <numerusform>%n region is called &quot;%1&quot;, which is never spoken; give it the name that people use</numerusform>
            <numerusform>%n regions are called &quot;%1&quot; or the like, which is never spoken; give it the name that people use</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>level %1 is used by %n regions but is not in the layer levels: its name cannot be spoken; add it</source>
        <translation>
            <numerusform>level %1 is used by %n region but is not in the layer levels: its name cannot be spoken; add it</numerusform>
            <numerusform>level %1 is used by %n regions but is not in the layer levels: its name cannot be spoken; add it</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n accesses are drawn on more than two regions: see that region_a and region_b are the right ones</source>
        <translation>
            <numerusform>%n access is drawn on more than two regions: see that region_a and region_b are the right ones</numerusform>
            <numerusform>%n accesses are drawn on more than two regions: see that region_a and region_b are the right ones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n escalators have no direction and count as running both ways: set oneway</source>
        <translation>
            <numerusform>%n escalator has no direction and count as running both ways: set oneway</numerusform>
            <numerusform>%n escalators have no direction and count as running both ways: set oneway</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2</source>
        <translation>
            <numerusform>%n feature has the unknown kind &quot;%1&quot;; known are %2</numerusform>
            <numerusform>%n features have the unknown kind &quot;%1&quot;; known are %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2 (nobody is led through other)</source>
        <translation>
            <numerusform>%n feature has the unknown kind &quot;%1&quot;; known are %2 (nobody is led through other)</numerusform>
            <numerusform>%n features have the unknown kind &quot;%1&quot;; known are %2 (nobody is led through other)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the building falls into %1 parts; %n regions cannot be reached from the largest (%2): accesses are missing or closed</source>
        <translation>
            <numerusform>the building falls into %1 parts; %n region cannot be reached from the largest (%2): accesses are missing or closed</numerusform>
            <numerusform>the building falls into %1 parts; %n regions cannot be reached from the largest (%2): accesses are missing or closed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>%n region</numerusform>
            <numerusform>%n regions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions of level %1 have the ref &quot;%2&quot;: people are led to the wrong one; correct it</source>
        <translation>
            <numerusform>%n regions of level %1 have the ref &quot;%2&quot;: people are led to the wrong one; correct it</numerusform>
            <numerusform>%n regions of level %1 have the ref &quot;%2&quot;: people are led to the wrong one; correct it</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions have no door or other access that joins another region: nobody can be led there; add it</source>
        <translation>
            <numerusform>%n region has no door or other access that joins another region: nobody can be led there; add it</numerusform>
            <numerusform>%n regions have no door or other access that joins another region: nobody can be led there; add it</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions have a door drawn on the border, but the door joins two others and nothing leads there: correct region_a or region_b, or draw another door</source>
        <translation>
            <numerusform>%n region has a door drawn on the border, but the door joins two others and nothing leads there: correct region_a or region_b, or draw another door</numerusform>
            <numerusform>%n regions have a door drawn on the border, but the door joins two others and nothing leads there: correct region_a or region_b, or draw another door</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spaces were closed from walls, doors and windows; they have no names, and whether they are rooms, corridors or halls is a guess from their doors and size</source>
        <translation>
            <numerusform>%n spaces were closed from walls, doors and windows; they have no names, and whether they are rooms, corridors or halls is a guess from their doors and size</numerusform>
            <numerusform>%n spaces were closed from walls, doors and windows; they have no names, and whether they are rooms, corridors or halls is a guess from their doors and size</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::ConfusionModel</name>
    <message numerus="yes">
        <source>%1 taken for %2: %n time(s)</source>
        <translation>
            <numerusform>%1 taken for %2: %n time</numerusform>
            <numerusform>%1 taken for %2: %n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::FeaturePanel</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n row</numerusform>
            <numerusform>%n rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n row(s)</source>
        <translation>
            <numerusform>%1 of %n row</numerusform>
            <numerusform>%1 of %n rows</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::FindingModel</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::FramePanel</name>
    <message numerus="yes">
        <source>%n left out because late</source>
        <translation>
            <numerusform>%n left out because late</numerusform>
            <numerusform>%n left out because late</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unreadable</source>
        <translation>
            <numerusform>%n unreadable</numerusform>
            <numerusform>%n unreadable</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::InstructionPanel</name>
    <message numerus="yes">
        <source>%n more place(s) to pass</source>
        <translation>
            <numerusform>%n more place to pass</numerusform>
            <numerusform>%n more places to pass</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskMachine</name>
    <message numerus="yes">
        <source>%1: %n place(s). %2.</source>
        <extracomment>%1 &quot;Rooms&quot;, %2 the first of them</extracomment>
        <translation>
            <numerusform>%1: %n place. %2.</numerusform>
            <numerusform>%1: %n places. %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s).</source>
        <comment>while typing</comment>
        <extracomment>%1 the letter just typed</extracomment>
        <translation>
            <numerusform>%1: %n place.</numerusform>
            <numerusform>%1: %n places.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s). Space: first place.</source>
        <translation>
            <numerusform>%1: %n place. Space: first place.</numerusform>
            <numerusform>%1: %n places. Space: first place.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Choose a destination: %n place(s).</source>
        <translation>
            <numerusform>Choose a destination: %n place.</numerusform>
            <numerusform>Choose a destination: %n places.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) fit: %1.</source>
        <translation>
            <numerusform>%n place fits: %1.</numerusform>
            <numerusform>%n places fit: %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryPanel</name>
    <message numerus="yes">
        <source>%n landmark(s) need care.</source>
        <translation>
            <numerusform>%n landmark needs care.</numerusform>
            <numerusform>%n landmarks need care.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) are taken for each other.</source>
        <translation>
            <numerusform>%n pair is taken for each other.</numerusform>
            <numerusform>%n pairs are taken for each other.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>%n landmark</numerusform>
            <numerusform>%n landmarks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s) cannot be tried: there is only one view. Add another.</source>
        <translation>
            <numerusform>%n landmark cannot be tried: there is only one view. Add another.</numerusform>
            <numerusform>%n landmarks cannot be tried: there is only one view. Add another.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::MapPanel</name>
    <message numerus="yes">
        <source>%n place(s) on the map.</source>
        <translation>
            <numerusform>%n place on the map.</numerusform>
            <numerusform>%n places on the map.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::MissingDialog</name>
    <message numerus="yes">
        <source>%1 and %n more place(s)</source>
        <translation>
            <numerusform>%1 and %n more place</numerusform>
            <numerusform>%1 and %n more places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more line(s) are not listed: mend these first.</source>
        <translation>
            <numerusform>%n more line is not listed: mend these first.</numerusform>
            <numerusform>%n more lines are not listed: mend these first.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::Phrasebook</name>
    <message numerus="yes">
        <source>In about %n metre(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>In about %n metre</numerusform>
            <numerusform>In about %n metres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n metre(s).</source>
        <translation>
            <numerusform>Keep moving forward for about %n metre.</numerusform>
            <numerusform>Keep moving forward for about %n metres.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n step(s).</source>
        <translation>
            <numerusform>%n step.</numerusform>
            <numerusform>%n steps.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n metre(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>About %n metre.</numerusform>
            <numerusform>About %n metres.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>And %n more thing(s) to do after that.</source>
        <translation>
            <numerusform>And %n more thing to do after that.</numerusform>
            <numerusform>And %n more things to do after that.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n foot(feet).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>About %n foot.</numerusform>
            <numerusform>About %n feet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n step(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>About %n step.</numerusform>
            <numerusform>About %n steps.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n foot(feet)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>In about %n foot</numerusform>
            <numerusform>In about %n feet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n step(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>In about %n step</numerusform>
            <numerusform>In about %n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n foot(feet).</source>
        <translation>
            <numerusform>Keep moving forward for about %n foot.</numerusform>
            <numerusform>Keep moving forward for about %n feet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n step(s).</source>
        <translation>
            <numerusform>Keep moving forward for about %n step.</numerusform>
            <numerusform>Keep moving forward for about %n steps.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::PlaceChooser</name>
    <message numerus="yes">
        <source>%n places fit: choose one</source>
        <translation>
            <numerusform>%n place fits: choose it</numerusform>
            <numerusform>%n places fit: choose one</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::PlanPanel</name>
    <message numerus="yes">
        <source>%1: %n region(s), %2</source>
        <translation>
            <numerusform>%1: %n region, %2</numerusform>
            <numerusform>%1: %n regions, %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>%n landmark</numerusform>
            <numerusform>%n landmarks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::ReportPanel</name>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform>
            <numerusform>%n notes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::RoutePanel</name>
    <message numerus="yes">
        <source>%1 m, about %n minute(s), through %2.</source>
        <translation>
            <numerusform>%1 m, about %n minute, through %2.</numerusform>
            <numerusform>%1 m, about %n minutes, through %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n door(s) and passage(s)</source>
        <translation>
            <numerusform>%n door or passage</numerusform>
            <numerusform>%n doors and passages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachViews</name>
    <message numerus="yes">
        <source>This picture is good: %n point(s).</source>
        <translation>
            <numerusform>This picture is good: %n point.</numerusform>
            <numerusform>This picture is good: %n points.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With the %n view(s) it had before.</source>
        <translation>
            <numerusform>With the %n view it had before.</numerusform>
            <numerusform>With the %n views it had before.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingPage</name>
    <message numerus="yes">
        <source>“%1” is unfinished, with %n view(s).</source>
        <translation>
            <numerusform>“%1” is unfinished, with %n view.</numerusform>
            <numerusform>“%1” is unfinished, with %n views.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Name of the landmark that the %n chosen view(s) become:</source>
        <translation>
            <numerusform>Name of the landmark that the chosen view becomes:</numerusform>
            <numerusform>Name of the landmark that the %n chosen views become:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::VoteModel</name>
    <message numerus="yes">
        <source>%n matching object(s)</source>
        <translation>
            <numerusform>%n matching object</numerusform>
            <numerusform>%n matching objects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>farol::ui::Walk</name>
    <message numerus="yes">
        <source>%n remark(s) about the map: %1</source>
        <translation>
            <numerusform>%n remark about the map: %1</numerusform>
            <numerusform>%n remarks about the map: %1</numerusform>
        </translation>
    </message>
</context>
</TS>
