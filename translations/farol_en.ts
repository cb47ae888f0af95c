<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
</context>
</TS>
