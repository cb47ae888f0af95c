<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Oui</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Non</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message numerus="yes">
        <source>%n features have no id; give each its own</source>
        <translation>
            <numerusform>%n élément n&apos;a pas d&apos;identifiant&#xa0;; donnez-lui le sien</numerusform>
            <numerusform>%n éléments n&apos;ont pas d&apos;identifiant&#xa0;; donnez à chacun le sien</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features share the id &quot;%1&quot;; give each its own</source>
        <translation>
            <numerusform>%n élément a l&apos;identifiant «&#xa0;%1&#xa0;»&#xa0;; donnez à chacun le sien</numerusform>
            <numerusform>%n éléments partagent l&apos;identifiant «&#xa0;%1&#xa0;»&#xa0;; donnez à chacun le sien</numerusform>
        </translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has fewer than three corners; draw it again</source>
        <translation>le contour de la région «&#xa0;%1&#xa0;» a moins de trois angles&#xa0;; redessinez-le</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a coordinate that is no number; draw it again</source>
        <translation>le contour de la région «&#xa0;%1&#xa0;» a une coordonnée qui n&apos;est pas un nombre&#xa0;; redessinez-le</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has no area; draw it again</source>
        <translation>le contour de la région «&#xa0;%1&#xa0;» n&apos;a pas de surface&#xa0;; redessinez-le</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; crosses itself; draw it again</source>
        <translation>le contour de la région «&#xa0;%1&#xa0;» se croise lui-même&#xa0;; redessinez-le</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has fewer than three corners; draw it again</source>
        <translation>le contour de la région «&#xa0;%1&#xa0;» a un trou de moins de trois angles&#xa0;; redessinez-le</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has a coordinate that is no number; draw it again</source>
        <translation>le contour de la région «&#xa0;%1&#xa0;» a un trou dont une coordonnée n&apos;est pas un nombre&#xa0;; redessinez-le</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has no area; draw it again</source>
        <translation>le contour de la région «&#xa0;%1&#xa0;» a un trou sans surface&#xa0;; redessinez-le</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that crosses itself; draw it again</source>
        <translation>le contour de la région «&#xa0;%1&#xa0;» a un trou qui se croise lui-même&#xa0;; redessinez-le</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that lies outside it; draw it again</source>
        <translation>le contour de la région «&#xa0;%1&#xa0;» a un trou qui se trouve à l&apos;extérieur&#xa0;; redessinez-le</translation>
    </message>
    <message numerus="yes">
        <source>%n regions have neither name nor ref: only its kind is spoken</source>
        <translation>
            <numerusform>%n région n&apos;a ni nom ni numéro&#xa0;: seul son type est dit</numerusform>
            <numerusform>%n régions n&apos;ont ni nom ni numéro&#xa0;: seul leur type est dit</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions are called &quot;%1&quot; or the like, which is never spoken; give it the name that people use</source>
        <translation>
            <numerusform>%n région s&apos;appelle «&#xa0;%1&#xa0;», ce qui n&apos;est jamais dit&#xa0;; donnez-lui le nom que les gens emploient</numerusform>
            <numerusform>%n régions s&apos;appellent «&#xa0;%1&#xa0;» ou de façon semblable, ce qui n&apos;est jamais dit&#xa0;; donnez-leur le nom que les gens emploient</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>level %1 is used by %n regions but is not in the layer levels: its name cannot be spoken; add it</source>
        <translation>
            <numerusform>le niveau %1 est utilisé par %n région mais manque dans la liste des niveaux (levels)&#xa0;: son nom ne peut pas être dit&#xa0;; ajoutez-le</numerusform>
            <numerusform>le niveau %1 est utilisé par %n régions mais manque dans la liste des niveaux (levels)&#xa0;: son nom ne peut pas être dit&#xa0;; ajoutez-le</numerusform>
        </translation>
    </message>
    <message>
        <source>access &quot;%1&quot; names the region &quot;%2&quot;, which does not exist; correct it</source>
        <translation>le passage «&#xa0;%1&#xa0;» nomme la région «&#xa0;%2&#xa0;», qui n&apos;existe pas&#xa0;; corrigez-la</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; lies more than 1 m from region &quot;%2&quot;; move it to the border</source>
        <translation>le passage «&#xa0;%1&#xa0;» est à plus de 1&#xa0;m de la région «&#xa0;%2&#xa0;»&#xa0;; déplacez-le sur la limite</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; has the same region on both sides: no route passes it; set region_a and region_b, or move it to a border</source>
        <translation>le passage «&#xa0;%1&#xa0;» a la même région des deux côtés&#xa0;: aucun itinéraire n&apos;y passe&#xa0;; indiquez la région de chaque côté (region_a et region_b) ou déplacez-le sur une limite</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; does not join two regions: no route passes it; set region_a and region_b, or move it to a border</source>
        <translation>le passage «&#xa0;%1&#xa0;» ne relie pas deux régions&#xa0;: aucun itinéraire n&apos;y passe&#xa0;; indiquez la région de chaque côté (region_a et region_b) ou déplacez-le sur une limite</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; is no stairs, lift, escalator or ramp but joins regions of levels %2 and %3; correct its kind or regions</source>
        <translation>le passage «&#xa0;%1&#xa0;» n&apos;est ni escalier, ni ascenseur, ni escalier mécanique, ni rampe, mais relie des régions des niveaux %2 et %3&#xa0;; corrigez son type ou ses régions</translation>
    </message>
    <message numerus="yes">
        <source>%n accesses are drawn on more than two regions: see that region_a and region_b are the right ones</source>
        <translation>
            <numerusform>%n passage est dessiné sur plus de deux régions&#xa0;: vérifiez que les deux côtés (region_a et region_b) sont les bons</numerusform>
            <numerusform>%n passages sont dessinés sur plus de deux régions&#xa0;: vérifiez que les deux côtés (region_a et region_b) sont les bons</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n escalators have no direction and count as running both ways: set oneway</source>
        <translation>
            <numerusform>%n escalier mécanique n&apos;a pas de sens de marche et compte comme allant dans les deux&#xa0;: indiquez-le (oneway)</numerusform>
            <numerusform>%n escaliers mécaniques n&apos;ont pas de sens de marche et comptent comme allant dans les deux&#xa0;: indiquez-le (oneway)</numerusform>
        </translation>
    </message>
    <message>
        <source>shaft &quot;%1&quot; passes level %2 without an access there; add it, unless it does not stop there</source>
        <translation>l&apos;escalier ou l&apos;ascenseur «&#xa0;%1&#xa0;» passe par le niveau %2 sans qu&apos;il y ait de passage&#xa0;; ajoutez-le, sauf s&apos;il ne s&apos;y arrête pas</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; belongs to no region; set region_id</source>
        <translation>le repère «&#xa0;%1&#xa0;» n&apos;appartient à aucune région&#xa0;; indiquez-la (region_id)</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; names the region &quot;%2&quot;, which does not exist; correct it</source>
        <translation>le repère «&#xa0;%1&#xa0;» nomme la région «&#xa0;%2&#xa0;», qui n&apos;existe pas&#xa0;; corrigez-la</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; is on level %2, its region &quot;%3&quot; on level %4</source>
        <translation>le repère «&#xa0;%1&#xa0;» est au niveau %2, et sa région «&#xa0;%3&#xa0;» au niveau %4</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; lies more than 0.5 m outside its region &quot;%2&quot;; move it or correct region_id</source>
        <translation>le repère «&#xa0;%1&#xa0;» est à plus de 0,5&#xa0;m hors de sa région «&#xa0;%2&#xa0;»&#xa0;; déplacez-le ou corrigez la région (region_id)</translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2</source>
        <translation>
            <numerusform>%n élément a le type inconnu «&#xa0;%1&#xa0;»&#xa0;; sont connus, et entre parenthèses tels qu&apos;écrits dans la carte&#xa0;: %2</numerusform>
            <numerusform>%n éléments ont le type inconnu «&#xa0;%1&#xa0;»&#xa0;; sont connus, et entre parenthèses tels qu&apos;écrits dans la carte&#xa0;: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2 (nobody is led through other)</source>
        <translation>
            <numerusform>%n élément a le type inconnu «&#xa0;%1&#xa0;»&#xa0;; sont connus, et entre parenthèses tels qu&apos;écrits dans la carte&#xa0;: %2 (personne n&apos;est guidé par «&#xa0;other&#xa0;»)</numerusform>
            <numerusform>%n éléments ont le type inconnu «&#xa0;%1&#xa0;»&#xa0;; sont connus, et entre parenthèses tels qu&apos;écrits dans la carte&#xa0;: %2 (personne n&apos;est guidé par «&#xa0;other&#xa0;»)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the building falls into %1 parts; %n regions cannot be reached from the largest (%2): accesses are missing or closed</source>
        <translation>
            <numerusform>le bâtiment se divise en %1 parties&#xa0;; %n région est inaccessible depuis la plus grande (%2)&#xa0;: des passages manquent ou sont fermés</numerusform>
            <numerusform>le bâtiment se divise en %1 parties&#xa0;; %n régions sont inaccessibles depuis la plus grande (%2)&#xa0;: des passages manquent ou sont fermés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>%n région</numerusform>
            <numerusform>%n régions</numerusform>
        </translation>
    </message>
    <message>
        <source>region &quot;%1&quot; is a sliver, about %2 m wide: nobody stands there; join it to its neighbour</source>
        <translation>la région «&#xa0;%1&#xa0;» est une bande d&apos;environ %2&#xa0;m de large&#xa0;: personne ne s&apos;y tient&#xa0;; réunissez-la avec sa voisine</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot; have the same outline; remove one</source>
        <translation>les régions «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» ont le même contour&#xa0;; retirez-en une</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot;: the smaller lies inside the larger; cut it out of the larger one, unless it is a part of it</source>
        <translation>régions «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;»&#xa0;: la plus petite est à l&apos;intérieur de la plus grande&#xa0;; découpez-la dans la plus grande, sauf si elle en fait partie</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot; overlap by %3 % of the smaller; draw the border between them</source>
        <translation>les régions «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» se chevauchent sur %3&#xa0;% de la plus petite&#xa0;; dessinez la limite entre elles</translation>
    </message>
    <message>
        <source>so many regions overlap that not all pairs were compared; are all levels drawn on one?</source>
        <translation>tant de régions se chevauchent que toutes les paires n&apos;ont pas été comparées&#xa0;; tous les niveaux sont-ils dessinés sur un seul&#xa0;?</translation>
    </message>
    <message numerus="yes">
        <source>%n regions of level %1 have the ref &quot;%2&quot;: people are led to the wrong one; correct it</source>
        <translation>
            <numerusform>%n région du niveau %1 a le numéro «&#xa0;%2&#xa0;»&#xa0;: les gens sont menés à la mauvaise&#xa0;; corrigez-le</numerusform>
            <numerusform>%n régions du niveau %1 ont le numéro «&#xa0;%2&#xa0;»&#xa0;: les gens sont menés à la mauvaise&#xa0;; corrigez-le</numerusform>
        </translation>
    </message>
    <message>
        <source>the whole building is smaller than 0.3 m: its coordinates are degrees, not metres; import or reproject it</source>
        <translation>tout le bâtiment fait moins de 0,3&#xa0;m&#xa0;: ses coordonnées sont des degrés, pas des mètres&#xa0;; importez-le ou reprojetez-le</translation>
    </message>
    <message numerus="yes">
        <source>%n regions have no door or other access that joins another region: nobody can be led there; add it</source>
        <translation>
            <numerusform>%n région n&apos;a ni porte ni autre passage vers une autre région&#xa0;: personne ne peut y être mené&#xa0;; ajoutez-le</numerusform>
            <numerusform>%n régions n&apos;ont ni porte ni autre passage vers une autre région&#xa0;: personne ne peut y être mené&#xa0;; ajoutez-le</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions have a door drawn on the border, but the door joins two others and nothing leads there: correct region_a or region_b, or draw another door</source>
        <translation>
            <numerusform>%n région a une porte dessinée sur sa limite, mais elle en relie deux autres et rien n&apos;y mène&#xa0;: corrigez un de ses côtés (region_a ou region_b) ou dessinez une autre porte</numerusform>
            <numerusform>%n régions ont une porte dessinée sur leur limite, mais elle en relie deux autres et rien n&apos;y mène&#xa0;: corrigez un de ses côtés (region_a ou region_b) ou dessinez une autre porte</numerusform>
        </translation>
    </message>
    <message>
        <source>features had no id and were given one</source>
        <translation>des éléments n&apos;avaient pas d&apos;identifiant et en ont reçu un</translation>
    </message>
    <message>
        <source>features shared an id and were given another</source>
        <translation>des éléments partageaient un identifiant et en ont reçu un autre</translation>
    </message>
    <message>
        <source>outlines have corners that are no places; these were left out</source>
        <translation>des contours ont des angles qui ne sont pas des lieux&#xa0;; ils ont été laissés de côté</translation>
    </message>
    <message>
        <source>outlines have fewer than three corners; the regions were left out</source>
        <translation>des contours ont moins de trois angles&#xa0;; ces régions ont été laissées de côté</translation>
    </message>
    <message>
        <source>outlines have more than 200,000 corners; the regions were left out</source>
        <translation>des contours ont plus de 200&#xa0;000 angles&#xa0;; ces régions ont été laissées de côté</translation>
    </message>
    <message>
        <source>outlines enclose no area; the regions were left out</source>
        <translation>des contours n&apos;entourent aucune surface&#xa0;; ces régions ont été laissées de côté</translation>
    </message>
    <message>
        <source>outlines crossed or touched themselves and were mended: compare them with the plan</source>
        <translation>des contours se croisaient ou se touchaient eux-mêmes et ont été réparés&#xa0;: comparez-les au plan</translation>
    </message>
    <message>
        <source>regions fell into several parts: each part is a region of its own</source>
        <translation>des régions étaient en plusieurs parties&#xa0;: chaque partie est une région à part</translation>
    </message>
    <message>
        <source>regions repeat the outline of another one on their level and were merged with it</source>
        <translation>des régions répètent le contour d&apos;une autre de leur niveau et ont été réunies avec elle</translation>
    </message>
    <message>
        <source>accesses have points that are no places; these were left out</source>
        <translation>des passages ont des points qui ne sont pas des lieux&#xa0;; ils ont été laissés de côté</translation>
    </message>
    <message>
        <source>accesses have no place on the map and were left out</source>
        <translation>des passages n&apos;ont pas d&apos;emplacement sur la carte et ont été laissés de côté</translation>
    </message>
    <message>
        <source>landmarks have no place on the map and were left out</source>
        <translation>des repères n&apos;ont pas d&apos;emplacement sur la carte et ont été laissés de côté</translation>
    </message>
    <message>
        <source>levels are no floors of a building; level 0 is assumed</source>
        <translation>des niveaux ne sont pas ceux d&apos;un bâtiment&#xa0;; le niveau 0 est supposé</translation>
    </message>
    <message>
        <source>levels stand twice in the source; the first name is kept</source>
        <translation>des niveaux figurent deux fois dans la source&#xa0;; le premier nom est gardé</translation>
    </message>
    <message>
        <source>regions had no name and were given one from kind and number, such as &quot;Corridor 3&quot;: rename them</source>
        <translation>des régions n&apos;avaient pas de nom et en ont reçu un fait du type et d&apos;un numéro, comme «&#xa0;Corridor 3&#xa0;»&#xa0;: renommez-les</translation>
    </message>
    <message>
        <source>landmarks lie outside every region and were given to the nearest one</source>
        <translation>des repères sont hors de toute région et ont été attribués à la plus proche</translation>
    </message>
    <message>
        <source>openings were added where regions meet without a wall between them</source>
        <translation>des ouvertures ont été ajoutées là où des régions se touchent sans mur entre elles</translation>
    </message>
    <message>
        <source>accesses are drawn on fewer than two regions</source>
        <translation>des passages sont dessinés sur moins de deux régions</translation>
    </message>
    <message>
        <source>accesses lie beside more than two regions; the two with the widest border were taken: see that they are right</source>
        <translation>des passages sont à côté de plus de deux régions&#xa0;; les deux à la limite la plus large ont été prises&#xa0;: vérifiez que ce sont les bonnes</translation>
    </message>
    <message>
        <source>accesses run from one region to another and along no border: if one walks along the line, set region_a and region_b</source>
        <translation>des passages vont d&apos;une région à l&apos;autre sans suivre de limite&#xa0;: si l&apos;on marche le long de la ligne, indiquez la région de chaque côté (region_a et region_b)</translation>
    </message>
    <message>
        <source>stairs, lifts or escalators lead to a level that nothing names: set region_b, or give them and their other end the same shaft</source>
        <translation>des escaliers, ascenseurs ou escaliers mécaniques mènent à un niveau que rien ne nomme&#xa0;: indiquez la région de l&apos;autre côté (region_b), ou donnez-leur la même cage (shaft) qu&apos;à leur autre bout</translation>
    </message>
    <message>
        <source>upper ends of stairs, lifts or escalators were left out: their lower ends lead there already</source>
        <translation>des extrémités hautes d&apos;escaliers, d&apos;ascenseurs ou d&apos;escaliers mécaniques ont été laissées de côté&#xa0;: les basses y mènent déjà</translation>
    </message>
    <message>
        <source>links between levels name regions that do not exist</source>
        <translation>des liaisons entre niveaux nomment des régions qui n&apos;existent pas</translation>
    </message>
    <message>
        <source>stairs, lifts or escalators were joined with the ones above them, because their outlines overlap</source>
        <translation>des escaliers, ascenseurs ou escaliers mécaniques ont été reliés à ceux du dessus, parce que leurs contours se chevauchent</translation>
    </message>
    <message>
        <source>the coordinate reference system of the source cannot be understood</source>
        <translation>le système de coordonnées de la source n&apos;est pas compris</translation>
    </message>
    <message>
        <source>the source names a CRS in metres, but its coordinates are degrees: they are taken as WGS 84</source>
        <translation>la source nomme un système de coordonnées en mètres, mais ses coordonnées sont des degrés&#xa0;: elles sont prises comme WGS 84</translation>
    </message>
    <message>
        <source>the source names no CRS; its coordinates look like degrees and are taken as WGS 84</source>
        <translation>la source ne nomme pas de système de coordonnées&#xa0;; elles ressemblent à des degrés et sont prises comme WGS 84</translation>
    </message>
    <message>
        <source>the source names a CRS in degrees, but its coordinates are not: they are taken as metres of a local plane</source>
        <translation>la source nomme un système de coordonnées en degrés, mais ses coordonnées n&apos;en sont pas&#xa0;: elles sont prises comme mètres d&apos;un plan local</translation>
    </message>
    <message>
        <source>the source names no CRS: its coordinates are taken as metres of a local plane; name the CRS if there is one</source>
        <translation>la source ne nomme pas de système de coordonnées&#xa0;: elles sont prises comme mètres d&apos;un plan local&#xa0;; nommez le système s&apos;il y en a un</translation>
    </message>
    <message>
        <source>north and east stand in each other&apos;s place in the source: they were exchanged; export it again to be sure</source>
        <translation>le nord et l&apos;est sont échangés dans la source&#xa0;: ils ont été remis à leur place&#xa0;; exportez-la de nouveau pour en avoir le cœur net</translation>
    </message>
    <message>
        <source>coordinates were brought from %1 to %2, in metres</source>
        <translation>les coordonnées ont été converties de %1 en %2, en mètres</translation>
    </message>
    <message>
        <source>coordinates were brought from the source&apos;s CRS to %1, in metres</source>
        <translation>les coordonnées ont été converties du système de la source en %1, en mètres</translation>
    </message>
    <message>
        <source>layers hold no rooms, doors, walls or points by their name; a profile can say otherwise</source>
        <translation>des couches ne contiennent, d&apos;après leur nom, ni salles, ni portes, ni murs, ni points&#xa0;; un profil peut dire autre chose</translation>
    </message>
    <message>
        <source>features cannot be brought to the CRS of the other layers</source>
        <translation>des éléments ne peuvent pas être convertis dans le système de coordonnées des autres couches</translation>
    </message>
    <message>
        <source>layers tell no level; the ground floor is assumed: name the field that holds the level</source>
        <translation>des couches ne disent pas le niveau&#xa0;; le rez-de-chaussée est supposé&#xa0;: nommez le champ qui contient le niveau</translation>
    </message>
    <message>
        <source>levels were counted from the heights of the shapes, the one nearest to 0 as the ground floor</source>
        <translation>les niveaux ont été comptés d&apos;après la hauteur des formes, le plus proche de 0 comme rez-de-chaussée</translation>
    </message>
    <message>
        <source>lines of layers that nothing names doors or walls are taken as walls; name the layer or give a profile</source>
        <translation>les lignes de couches que rien ne désigne comme portes ou murs sont prises comme murs&#xa0;; nommez la couche ou donnez un profil</translation>
    </message>
    <message>
        <source>features have no geometry and were left out</source>
        <translation>des éléments n&apos;ont pas de forme et ont été laissés de côté</translation>
    </message>
    <message>
        <source>features have the code &quot;%1&quot;, which nobody knows: name it under codes in a profile</source>
        <translation>des éléments ont le code «&#xa0;%1&#xa0;», que personne ne connaît&#xa0;: nommez-le dans un profil, sous «&#xa0;codes&#xa0;»</translation>
    </message>
    <message>
        <source>accesses have a direction that nobody knows and are taken to be passed both ways: a_to_b, b_to_a, up or down is wanted</source>
        <translation>des passages ont un sens que personne ne connaît et sont pris comme allant dans les deux&#xa0;: il faut a_to_b, b_to_a, up ou down</translation>
    </message>
    <message>
        <source>points name a region that does not exist; the one they lie in is taken</source>
        <translation>des points nomment une région qui n&apos;existe pas&#xa0;; celle où ils se trouvent est prise</translation>
    </message>
    <message>
        <source>layers have no features: %1</source>
        <translation>des couches n&apos;ont pas d&apos;éléments&#xa0;: %1</translation>
    </message>
    <message>
        <source>layers name no CRS; that of the other layers is taken</source>
        <translation>des couches ne nomment pas de système de coordonnées&#xa0;; celui des autres couches est pris</translation>
    </message>
    <message>
        <source>features left out: their coordinates are missing or no places on Earth</source>
        <translation>éléments laissés de côté&#xa0;: leurs coordonnées manquent ou ne sont pas des lieux sur Terre</translation>
    </message>
    <message>
        <source>features left out: they have no usable shape</source>
        <translation>éléments laissés de côté&#xa0;: ils n&apos;ont pas de forme utilisable</translation>
    </message>
    <message>
        <source>the value of level or repeat_on is no list of levels such as -1;0 or 1-3: correct it</source>
        <translation>la valeur de level ou repeat_on n&apos;est pas une liste de niveaux comme -1;0 ou 1-3&#xa0;: corrigez-la</translation>
    </message>
    <message>
        <source>there is no readable level; level 0 is assumed: add the level</source>
        <translation>il n&apos;y a pas de niveau lisible&#xa0;; le niveau 0 est supposé&#xa0;: ajoutez le niveau (level)</translation>
    </message>
    <message>
        <source>the lift is a point in the source: a square of 1.6 m was drawn for its car</source>
        <translation>l&apos;ascenseur est un point dans la source&#xa0;: un carré de 1,6&#xa0;m a été dessiné pour sa cabine</translation>
    </message>
    <message>
        <source>left out: it has no level, and it stands over no or several levels&apos; regions</source>
        <translation>laissé de côté&#xa0;: il n&apos;a pas de niveau, et se trouve au-dessus de régions de plusieurs niveaux ou d&apos;aucun</translation>
    </message>
    <message>
        <source>left out: no region of its level lies within 3 m</source>
        <translation>laissé de côté&#xa0;: aucune région de son niveau n&apos;est à moins de 3&#xa0;m</translation>
    </message>
    <message>
        <source>left out: it has no level and stands on no outline of a region</source>
        <translation>laissée de côté&#xa0;: elle n&apos;a pas de niveau et n&apos;est sur le contour d&apos;aucune région</translation>
    </message>
    <message>
        <source>no door is drawn where a way leads into the room: an opening was put there</source>
        <translation>aucune porte n&apos;est dessinée là où un chemin entre dans la salle&#xa0;: une ouverture y a été placée</translation>
    </message>
    <message>
        <source>nothing tells which end of the steps is up; the first was taken as the lower: add incline</source>
        <translation>rien ne dit quel bout des marches est en haut&#xa0;; le premier a été pris comme le bas&#xa0;: ajoutez incline</translation>
    </message>
    <message>
        <source>no region lies at an end of the steps: draw the area or way it leads to</source>
        <translation>aucune région n&apos;est à un bout des marches&#xa0;: dessinez la zone ou le chemin où elles mènent</translation>
    </message>
    <message>
        <source>steps left out: their line has no length</source>
        <translation>marches laissées de côté&#xa0;: leur ligne n&apos;a pas de longueur</translation>
    </message>
    <message>
        <source>nothing tells which way the walkway runs; it is taken to run both ways: set conveying to forward or backward</source>
        <translation>rien ne dit dans quel sens fonctionne le tapis roulant&#xa0;; on suppose les deux&#xa0;: indiquez forward ou backward dans conveying</translation>
    </message>
    <message>
        <source>no region lies at an end of the walkway: draw the area or way it leads to</source>
        <translation>aucune région n&apos;est à un bout du tapis roulant&#xa0;: dessinez la zone ou le chemin où il mène</translation>
    </message>
    <message>
        <source>the lift has no drawn door; one was put on a side that is open: move it to its place</source>
        <translation>l&apos;ascenseur n&apos;a pas de porte dessinée&#xa0;; une a été placée d&apos;un côté ouvert&#xa0;: déplacez-la à sa place</translation>
    </message>
    <message>
        <source>features of the type %1 have no place in a building file</source>
        <translation>les éléments du type %1 n&apos;ont pas de place dans un fichier de bâtiment</translation>
    </message>
    <message>
        <source>levels have no ordinal; they are taken as the ground floor</source>
        <translation>des niveaux n&apos;ont pas d&apos;ordinal&#xa0;; ils sont pris comme rez-de-chaussée</translation>
    </message>
    <message>
        <source>features name a level that does not exist; the ground floor is assumed</source>
        <translation>des éléments nomment un niveau qui n&apos;existe pas&#xa0;; le rez-de-chaussée est supposé</translation>
    </message>
    <message>
        <source>units have a category that IMDF 1.0 does not list; they are taken as rooms</source>
        <translation>des unités ont une catégorie qu&apos;IMDF 1.0 ne liste pas&#xa0;; elles sont prises comme salles</translation>
    </message>
    <message>
        <source>units are walls, columns or voids: they became walls</source>
        <translation>des unités sont des murs, des colonnes ou des vides&#xa0;: elles sont devenues des murs</translation>
    </message>
    <message>
        <source>units have no outline and were left out</source>
        <translation>des unités n&apos;ont pas de contour et ont été laissées de côté</translation>
    </message>
    <message>
        <source>occupants have no anchor in a unit and were left out</source>
        <translation>des occupants n&apos;ont pas d&apos;ancre dans une unité et ont été laissés de côté</translation>
    </message>
    <message>
        <source>openings are emergency exits, for vehicles or out of service: nobody is led through them</source>
        <translation>des ouvertures sont des sorties de secours, réservées aux véhicules ou hors service&#xa0;: personne n&apos;y est guidé</translation>
    </message>
    <message>
        <source>openings have no line and were left out</source>
        <translation>des ouvertures n&apos;ont pas de ligne et ont été laissées de côté</translation>
    </message>
    <message>
        <source>amenities have no point and were left out</source>
        <translation>des équipements n&apos;ont pas de point et ont été laissés de côté</translation>
    </message>
    <message>
        <source>amenities name no unit that tells their level and were left out</source>
        <translation>des équipements ne nomment aucune unité qui dise leur niveau et ont été laissés de côté</translation>
    </message>
    <message>
        <source>relationships do not name two units and were left out</source>
        <translation>des relations ne nomment pas deux unités et ont été laissées de côté</translation>
    </message>
    <message>
        <source>the name of the coordinate system is not known; a local plane in metres is assumed</source>
        <translation>le nom du système de coordonnées est inconnu&#xa0;; un plan local en mètres est supposé</translation>
    </message>
    <message>
        <source>cells left out: they have no outline, no id, or the id of another</source>
        <translation>cellules laissées de côté&#xa0;: elles n&apos;ont pas de contour ou d&apos;identifiant, ou ont celui d&apos;une autre</translation>
    </message>
    <message>
        <source>transitions left out: they do not connect two cells that are there</source>
        <translation>transitions laissées de côté&#xa0;: elles ne relient pas deux cellules existantes</translation>
    </message>
    <message>
        <source>storeys are named by words; levels were taken from the heights</source>
        <translation>les étages sont nommés par des mots&#xa0;; les niveaux ont été déduits des hauteurs</translation>
    </message>
    <message>
        <source>nothing tells the levels: all is taken as level 0; name the field that holds the level</source>
        <translation>rien ne dit les niveaux&#xa0;: tout est pris comme niveau 0&#xa0;; nommez le champ qui contient le niveau</translation>
    </message>
    <message>
        <source>levels were counted from the heights of the floors</source>
        <translation>les niveaux ont été comptés d&apos;après la hauteur des sols</translation>
    </message>
    <message>
        <source>the door&apos;s cell does not lie between two rooms: it stays a region</source>
        <translation>la cellule de la porte n&apos;est pas entre deux salles&#xa0;: elle reste une région</translation>
    </message>
    <message>
        <source>features left out: they are no node, link, facility or entrance</source>
        <translation>éléments laissés de côté&#xa0;: ils ne sont ni nœud, ni liaison, ni équipement, ni entrée</translation>
    </message>
    <message>
        <source>the network has no areas: each node became a region of strips along its links, cut half-way, and each facility a square of 2 m behind its entrance</source>
        <translation>le réseau n&apos;a pas de surfaces&#xa0;: chaque nœud est devenu une région de bandes le long de ses liaisons, coupées à mi-chemin, et chaque équipement un carré de 2&#xa0;m derrière son entrée</translation>
    </message>
    <message>
        <source>floor 0 is taken as the ground floor; import it with the level from 1 when it is floor 1</source>
        <translation>l&apos;étage 0 est pris comme rez-de-chaussée&#xa0;; importez avec le niveau à partir de 1 si c&apos;est l&apos;étage 1</translation>
    </message>
    <message>
        <source>floor 1 is taken as the ground floor; import it with the level from 0 when it is floor 0</source>
        <translation>l&apos;étage 1 est pris comme rez-de-chaussée&#xa0;; importez avec le niveau à partir de 0 si c&apos;est l&apos;étage 0</translation>
    </message>
    <message>
        <source>nodes left out: they have no place, no id, or the id of another</source>
        <translation>nœuds laissés de côté&#xa0;: ils n&apos;ont pas d&apos;emplacement ou d&apos;identifiant, ou ont celui d&apos;un autre</translation>
    </message>
    <message>
        <source>nodes without a floor are taken to be on the ground</source>
        <translation>les nœuds sans étage sont pris comme étant au rez-de-chaussée</translation>
    </message>
    <message>
        <source>links left out: they do not join two nodes that are there</source>
        <translation>liaisons laissées de côté&#xa0;: elles ne relient pas deux nœuds existants</translation>
    </message>
    <message>
        <source>no link leads to the node</source>
        <translation>aucune liaison ne mène au nœud</translation>
    </message>
    <message>
        <source>no entrance with a known node leads to the facility: it became a landmark</source>
        <translation>aucune entrée au nœud connu ne mène à l&apos;équipement&#xa0;: il est devenu un repère</translation>
    </message>
    <message>
        <source>the facility of the entrance is missing</source>
        <translation>l&apos;équipement de l&apos;entrée manque</translation>
    </message>
    <message>
        <source>left out: it lies more than 20 m from every node of its floor</source>
        <translation>laissé de côté&#xa0;: il est à plus de 20&#xa0;m de tous les nœuds de son étage</translation>
    </message>
    <message numerus="yes">
        <source>%n spaces were closed from walls, doors and windows; they have no names, and whether they are rooms, corridors or halls is a guess from their doors and size</source>
        <translation>
            <numerusform>%n espace a été fermé d&apos;après les murs, les portes et les fenêtres&#xa0;; il n&apos;a pas de nom, et savoir s&apos;il est salle, couloir ou hall est une supposition d&apos;après ses portes et sa taille</numerusform>
            <numerusform>%n espaces ont été fermés d&apos;après les murs, les portes et les fenêtres&#xa0;; ils n&apos;ont pas de nom, et savoir s&apos;ils sont salles, couloirs ou halls est une supposition d&apos;après leurs portes et leur taille</numerusform>
        </translation>
    </message>
    <message>
        <source>strips under 0.3 m between walls were left out</source>
        <translation>des bandes de moins de 0,3&#xa0;m entre les murs ont été laissées de côté</translation>
    </message>
    <message>
        <source>no space lies on one side of the door: it leads outside, or a wall is missing</source>
        <translation>d&apos;un côté de la porte il n&apos;y a pas d&apos;espace&#xa0;: elle donne sur l&apos;extérieur, ou un mur manque</translation>
    </message>
    <message>
        <source>%1, layer %2</source>
        <translation>%1, couche %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1, feature %2</source>
        <translation>%1, élément %2</translation>
    </message>
    <message>
        <source>%1, feature number %2</source>
        <translation>%1, élément numéro %2</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, niveau %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n&apos;existe pas</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>ce fichier ou dossier n&apos;existe pas</translation>
    </message>
    <message>
        <source>is no file or folder</source>
        <translation>n&apos;est ni un fichier ni un dossier</translation>
    </message>
    <message>
        <source>is a folder; a file is wanted</source>
        <translation>est un dossier&#xa0;; il faut un fichier</translation>
    </message>
    <message>
        <source>holds no files</source>
        <translation>ne contient aucun fichier</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>cannot be listed (%1)</source>
        <translation>ne peut pas être listé (%1)</translation>
    </message>
    <message>
        <source>is not a map file that can be read</source>
        <translation>n&apos;est pas un fichier de carte lisible</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>ne peut pas être lu jusqu&apos;au bout</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>ne peut pas être lu (%1)</translation>
    </message>
    <message>
        <source>cannot be imported (%1)</source>
        <translation>ne peut pas être importé (%1)</translation>
    </message>
    <message>
        <source>the map cannot be put together (%1)</source>
        <translation>la carte ne peut pas être assemblée (%1)</translation>
    </message>
    <message>
        <source>reading the map failed: %1</source>
        <translation>la lecture de la carte a échoué&#xa0;: %1</translation>
    </message>
    <message>
        <source>is empty or cannot be read</source>
        <translation>est vide ou illisible</translation>
    </message>
    <message>
        <source>is no indoor map of a kind that is known: %1 was tried as %2; name its kind, or give a profile with its column names</source>
        <translation>n&apos;est pas un plan d&apos;intérieur d&apos;un type connu&#xa0;: on a essayé %1 comme %2&#xa0;; indiquez le type, ou donnez un profil avec les noms des colonnes</translation>
    </message>
    <message>
        <source>holds no file of the format %1</source>
        <translation>ne contient aucun fichier du format %1</translation>
    </message>
    <message>
        <source>is larger than 1 GB: too much for a map of a building</source>
        <translation>dépasse 1 Go&#xa0;: c&apos;est trop pour la carte d&apos;un bâtiment</translation>
    </message>
    <message>
        <source>is larger than %1 MB: no map of a building is</source>
        <translation>dépasse %1 Mo&#xa0;: aucune carte de bâtiment n&apos;est si grande</translation>
    </message>
    <message>
        <source>holds more than 10000 files: name the folder of one building</source>
        <translation>contient plus de 10000 fichiers&#xa0;: indiquez le dossier d&apos;un seul bâtiment</translation>
    </message>
    <message>
        <source>the database cannot be opened</source>
        <translation>la base de données ne peut pas être ouverte</translation>
    </message>
    <message>
        <source>the zip holds more than 10000 files: no map of a building does</source>
        <translation>le zip contient plus de 10000 fichiers&#xa0;: aucune carte de bâtiment n&apos;en a autant</translation>
    </message>
    <message>
        <source>a file in the zip has a name that leads out of it; the zip is not trusted</source>
        <translation>un fichier du zip a un nom qui mène hors de lui&#xa0;; le zip n&apos;est pas fiable</translation>
    </message>
    <message>
        <source>the zip is locked by a password; unpack it first</source>
        <translation>le zip est protégé par un mot de passe&#xa0;; décompressez-le d&apos;abord</translation>
    </message>
    <message>
        <source>unpacks to %1 MB: too much for a map of a building</source>
        <translation>fait %1 Mo une fois décompressé&#xa0;: c&apos;est trop pour la carte d&apos;un bâtiment</translation>
    </message>
    <message>
        <source>the zip&apos;s list of files is damaged; make the zip again</source>
        <translation>la liste des fichiers du zip est endommagée&#xa0;; refaites le zip</translation>
    </message>
    <message>
        <source>the zip is cut off: its list of files is missing; copy it again</source>
        <translation>le zip est tronqué&#xa0;: sa liste de fichiers manque&#xa0;; copiez-le de nouveau</translation>
    </message>
    <message>
        <source>the zip is larger than any map; unpack it and name the folder</source>
        <translation>le zip est plus grand que toute carte&#xa0;; décompressez-le et indiquez le dossier</translation>
    </message>
    <message>
        <source>the zip&apos;s list of files lies outside it; make the zip again</source>
        <translation>la liste des fichiers du zip est en dehors de lui&#xa0;; refaites le zip</translation>
    </message>
    <message>
        <source>is a landmark library without a map: name the file of the building</source>
        <translation>est une bibliothèque de repères sans carte&#xa0;: indiquez le fichier du bâtiment</translation>
    </message>
    <message>
        <source>is not a Farol map: it has no layer regions; import maps of another kind first</source>
        <translation>n&apos;est pas une carte de Farol&#xa0;: elle n&apos;a pas la couche regions&#xa0;; importez d&apos;abord les cartes d&apos;un autre type</translation>
    </message>
    <message>
        <source>the map is in degrees (%1); metres are wanted: import or reproject it</source>
        <translation>la carte est en degrés (%1)&#xa0;; il faut des mètres&#xa0;: importez-la ou reprojetez-la</translation>
    </message>
    <message>
        <source>the map&apos;s unit is not the metre (%1): reproject it</source>
        <translation>l&apos;unité de la carte n&apos;est pas le mètre (%1)&#xa0;: reprojetez-la</translation>
    </message>
    <message>
        <source>the field %1 is missing; add and fill it</source>
        <translation>le champ %1 manque&#xa0;; ajoutez-le et remplissez-le</translation>
    </message>
    <message>
        <source>the schema version &quot;%1&quot; is no version</source>
        <translation>la version de schéma «&#xa0;%1&#xa0;» n&apos;en est pas une</translation>
    </message>
    <message>
        <source>the map has schema version %1, this Farol knows %2: use a newer Farol</source>
        <translation>la carte a la version de schéma %1, ce Farol connaît la %2&#xa0;: utilisez un Farol plus récent</translation>
    </message>
    <message>
        <source>the map has no regions; draw at least one</source>
        <translation>la carte n&apos;a pas de régions&#xa0;; dessinez-en au moins une</translation>
    </message>
    <message>
        <source>two features have this id; give each its own</source>
        <translation>deux éléments ont cet identifiant&#xa0;; donnez à chacun le sien</translation>
    </message>
    <message>
        <source>this level is listed twice; remove one</source>
        <translation>ce niveau figure deux fois dans la liste&#xa0;; retirez-en un</translation>
    </message>
    <message>
        <source>oneway is &quot;%1&quot;; a_to_b, b_to_a or nothing is wanted</source>
        <translation>oneway est «&#xa0;%1&#xa0;»&#xa0;; il faut a_to_b, b_to_a ou rien</translation>
    </message>
    <message>
        <source>has no %1; fill it in</source>
        <translation>n&apos;a pas de %1&#xa0;; remplissez-le</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>%1 is no whole number within reason</source>
        <translation>%1 n&apos;est pas un nombre entier raisonnable</translation>
    </message>
    <message>
        <source>%1 is neither 0 nor 1</source>
        <translation>%1 n&apos;est ni 0 ni 1</translation>
    </message>
    <message>
        <source>level %1 is no floor of a building</source>
        <translation>le niveau %1 n&apos;est pas celui d&apos;un bâtiment</translation>
    </message>
    <message>
        <source>has no geometry; a %1 is wanted</source>
        <translation>n&apos;a pas de forme&#xa0;; il faut %1</translation>
    </message>
    <message>
        <source>consists of %1 parts; a single %2 is wanted: split it and give each part its own id</source>
        <translation>a %1 parties&#xa0;; il en faut une seule (%2)&#xa0;: divisez-le et donnez à chaque partie son identifiant</translation>
    </message>
    <message>
        <source>has a coordinate that is no number</source>
        <translation>a une coordonnée qui n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>has a coordinate beyond any metric map</source>
        <translation>a une coordonnée au-delà de toute carte en mètres</translation>
    </message>
    <message>
        <source>is an outline without an area</source>
        <translation>est un contour sans surface</translation>
    </message>
    <message>
        <source>is a %1; a %2 is wanted</source>
        <translation>est %1&#xa0;; il faut %2</translation>
    </message>
    <message>
        <source>has no outline</source>
        <translation>n&apos;a pas de contour</translation>
    </message>
    <message>
        <source>there are no rooms, corridors or other areas in it: nothing to walk through</source>
        <translation>il n&apos;y a ni salles, ni couloirs, ni autres surfaces&#xa0;: rien où marcher</translation>
    </message>
    <message>
        <source>has %1 levels: no building has; the level stands in another attribute: name that one</source>
        <translation>a %1 niveaux&#xa0;: aucun bâtiment n&apos;en a autant&#xa0;; le niveau est dans un autre attribut&#xa0;: indiquez-le</translation>
    </message>
    <message>
        <source>the map has no coordinates</source>
        <translation>la carte n&apos;a pas de coordonnées</translation>
    </message>
    <message>
        <source>geocentric coordinates are no plan of a floor; project them</source>
        <translation>des coordonnées géocentriques ne sont pas le plan d&apos;un étage&#xa0;; projetez-les</translation>
    </message>
    <message>
        <source>coordinates are beyond 100,000 km: they are no metres of a building</source>
        <translation>les coordonnées dépassent 100&#xa0;000 km&#xa0;: ce ne sont pas les mètres d&apos;un bâtiment</translation>
    </message>
    <message>
        <source>the coordinates do not lie where their CRS is defined</source>
        <translation>les coordonnées ne sont pas là où leur système est défini</translation>
    </message>
    <message>
        <source>the CRS cannot be brought to metres</source>
        <translation>le système de coordonnées ne peut pas être converti en mètres</translation>
    </message>
    <message>
        <source>holds more than a million features: no building does</source>
        <translation>contient plus d&apos;un million d&apos;éléments&#xa0;: aucun bâtiment n&apos;en a autant</translation>
    </message>
    <message>
        <source>has more than 500,000 features: no building has</source>
        <translation>contient plus de 500&#xa0;000 éléments&#xa0;: aucun bâtiment n&apos;en a autant</translation>
    </message>
    <message>
        <source>the shapes have no heights (z) that levels could be taken from; name a column instead</source>
        <translation>les formes n&apos;ont pas de hauteurs (z) d&apos;où déduire les niveaux&#xa0;; indiquez plutôt une colonne</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through: name the folder with all layers, or say what they are in a profile</source>
        <translation>ne contient ni salles, ni couloirs, ni autres surfaces où marcher&#xa0;: indiquez le dossier avec toutes les couches, ou dites dans un profil ce qu&apos;elles sont</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; %1 and what else is a door touches no region (access-joins-two-regions): name the folder with all layers, or say what they are in a profile</source>
        <translation>ne contient ni salles, ni couloirs, ni autres surfaces où marcher&#xa0;; %1 et les autres portes ne touchent aucune région&#xa0;: indiquez le dossier avec toutes les couches, ou dites dans un profil ce qu&apos;elles sont</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; lines alone enclose no rooms (layer-role): name the folder with all layers, or say what they are in a profile</source>
        <translation>ne contient ni salles, ni couloirs, ni autres surfaces où marcher&#xa0;; les lignes seules n&apos;entourent pas de salles&#xa0;: indiquez le dossier avec toutes les couches, ou dites dans un profil ce qu&apos;elles sont</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; there are no features in %1 (layer-empty): name the folder with all layers, or say what they are in a profile</source>
        <translation>ne contient ni salles, ni couloirs, ni autres surfaces où marcher&#xa0;; il n&apos;y a pas d&apos;éléments dans %1&#xa0;: indiquez le dossier avec toutes les couches, ou dites dans un profil ce qu&apos;elles sont</translation>
    </message>
    <message>
        <source>is no GeoJSON FeatureCollection</source>
        <translation>n&apos;est pas une FeatureCollection de GeoJSON</translation>
    </message>
    <message>
        <source>is nested deeper than any map</source>
        <translation>est imbriqué plus profondément que toute carte</translation>
    </message>
    <message>
        <source>is damaged JSON (%1)</source>
        <translation>est du JSON endommagé (%1)</translation>
    </message>
    <message>
        <source>is no JSON object with columns, codes, levels or layers</source>
        <translation>n&apos;est pas un objet JSON avec columns, codes, levels ou layers</translation>
    </message>
    <message>
        <source>there is no column meaning &quot;%1&quot;</source>
        <translation>il n&apos;y a pas de colonne de sens «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the role of layer &quot;%1&quot; is unknown</source>
        <translation>le rôle de la couche «&#xa0;%1&#xa0;» est inconnu</translation>
    </message>
    <message>
        <source>makes more than 20,000 regions on its levels, or its ways cross too many of them: cut the building out of it</source>
        <translation>donne plus de 20&#xa0;000 régions sur ses niveaux, ou ses chemins en croisent trop&#xa0;: découpez-en le bâtiment</translation>
    </message>
    <message>
        <source>holds no indoor areas: rooms, corridors and areas must be tagged indoor=* with a level</source>
        <translation>ne contient pas de surfaces intérieures&#xa0;: salles, couloirs et zones doivent porter l&apos;étiquette indoor=* avec un niveau</translation>
    </message>
    <message>
        <source>has more than 500,000 tagged features: cut the building out of it</source>
        <translation>contient plus de 500&#xa0;000 éléments étiquetés&#xa0;: découpez-en le bâtiment</translation>
    </message>
    <message>
        <source>is damaged OpenStreetMap data</source>
        <translation>est un fichier OpenStreetMap endommagé</translation>
    </message>
    <message>
        <source>cannot be read as OpenStreetMap data</source>
        <translation>ne peut pas être lu comme données OpenStreetMap</translation>
    </message>
    <message>
        <source>holds no OpenStreetMap file (.osm, .osm.pbf or GeoJSON made of one)</source>
        <translation>ne contient aucun fichier OpenStreetMap (.osm, .osm.pbf ou GeoJSON fait d&apos;un tel fichier)</translation>
    </message>
    <message>
        <source>holds no unit.geojson: name the folder or zip of an IMDF venue</source>
        <translation>ne contient pas unit.geojson&#xa0;: indiquez le dossier ou le zip d&apos;une carte IMDF</translation>
    </message>
    <message>
        <source>holds %1 IMDF venues: name the folder of one of them, such as %2</source>
        <translation>contient %1 cartes IMDF&#xa0;: indiquez le dossier de l&apos;une d&apos;elles, comme %2</translation>
    </message>
    <message>
        <source>has more than 20,000 nodes or facilities or 50,000 links: cut the building out of it</source>
        <translation>contient plus de 20&#xa0;000 nœuds ou équipements ou 50&#xa0;000 liaisons&#xa0;: découpez-en le bâtiment</translation>
    </message>
    <message>
        <source>holds no node of a route network with a place</source>
        <translation>ne contient aucun nœud d&apos;un réseau de chemins avec un emplacement</translation>
    </message>
    <message>
        <source>has more than 200,000 features</source>
        <translation>contient plus de 200&#xa0;000 éléments</translation>
    </message>
    <message>
        <source>is XML, but not IndoorGML (IndoorFeatures)</source>
        <translation>est du XML, mais pas de l&apos;IndoorGML (IndoorFeatures)</translation>
    </message>
    <message>
        <source>has more than 50,000 cells</source>
        <translation>contient plus de 50&#xa0;000 cellules</translation>
    </message>
    <message>
        <source>has no cell with a usable outline: Farol needs CellSpace geometry</source>
        <translation>n&apos;a aucune cellule au contour utilisable&#xa0;: Farol a besoin de la géométrie de CellSpace</translation>
    </message>
    <message>
        <source>has no cells but doors: rooms and corridors are missing</source>
        <translation>n&apos;a que des cellules de portes&#xa0;: salles et couloirs manquent</translation>
    </message>
    <message>
        <source>holds no IndoorGML file</source>
        <translation>ne contient aucun fichier IndoorGML</translation>
    </message>
    <message>
        <source>is damaged XML: %1</source>
        <translation>est du XML endommagé&#xa0;: %1</translation>
    </message>
    <message>
        <source>has more than two million elements</source>
        <translation>contient plus de deux millions d&apos;éléments</translation>
    </message>
    <message>
        <source>is nested deeper than 100 elements</source>
        <translation>a plus de 100 niveaux d&apos;éléments imbriqués</translation>
    </message>
    <message>
        <source>declares entities, which no map needs</source>
        <translation>déclare des entités, dont aucune carte n&apos;a besoin</translation>
    </message>
    <message>
        <source>lists no levels, as main.json of a WRLD map does</source>
        <translation>ne liste pas de niveaux, comme le fait le main.json d&apos;une carte WRLD</translation>
    </message>
    <message>
        <source>lists more than 300 levels</source>
        <translation>liste plus de 300 niveaux</translation>
    </message>
    <message>
        <source>a level has no z_order of its own</source>
        <translation>un niveau n&apos;a pas de z_order à lui</translation>
    </message>
    <message>
        <source>no floor has a room or an outline with walls</source>
        <translation>aucun étage n&apos;a de salle ou de contour avec des murs</translation>
    </message>
    <message>
        <source>the floor&apos;s file &quot;%1&quot; is missing: import the folder or zip that holds it</source>
        <translation>le fichier de l&apos;étage, «&#xa0;%1&#xa0;», manque&#xa0;: importez le dossier ou le zip qui le contient</translation>
    </message>
    <message>
        <source>has more than 10,000 features on a floor or 40,000 in all: no building has</source>
        <translation>contient plus de 10&#xa0;000 éléments sur un étage ou 40&#xa0;000 en tout&#xa0;: aucun bâtiment n&apos;en a autant</translation>
    </message>
    <message>
        <source>holds no main.json: name the folder or zip of the WRLD map</source>
        <translation>ne contient pas main.json&#xa0;: indiquez le dossier ou le zip de la carte WRLD</translation>
    </message>
    <message>
        <source>is damaged (%1)</source>
        <translation>est endommagé (%1)</translation>
    </message>
    <message>
        <source>the region has no outline</source>
        <translation>la région n&apos;a pas de contour</translation>
    </message>
    <message>
        <source>the access has no place on the map</source>
        <translation>le passage n&apos;a pas d&apos;emplacement sur la carte</translation>
    </message>
    <message>
        <source>both sides are the same region: choose another one</source>
        <translation>les deux côtés sont la même région&#xa0;: choisissez-en une autre</translation>
    </message>
    <message>
        <source>the width must be above 0 m, and the steps 0 or more</source>
        <translation>la largeur doit dépasser 0&#xa0;m, et les marches être 0 ou plus</translation>
    </message>
    <message>
        <source>the landmark has no place on the map</source>
        <translation>le repère n&apos;a pas d&apos;emplacement sur la carte</translation>
    </message>
    <message>
        <source>the width and the height of the object must be above 0 m</source>
        <translation>la largeur et la hauteur de l&apos;objet doivent dépasser 0&#xa0;m</translation>
    </message>
    <message>
        <source>the map has this name already</source>
        <translation>la carte a déjà ce nom</translation>
    </message>
    <message>
        <source>the map does not hold it any more</source>
        <translation>la carte ne le contient plus</translation>
    </message>
    <message>
        <source>the map there is of a later Farol; save under another name or use the newer Farol</source>
        <translation>la carte qui s&apos;y trouve est d&apos;un Farol plus récent&#xa0;; enregistrez sous un autre nom ou utilisez le Farol plus récent</translation>
    </message>
    <message>
        <source>is another kind of file; save under a name that ends in .gpkg</source>
        <translation>est un autre type de fichier&#xa0;; enregistrez sous un nom qui finit par .gpkg</translation>
    </message>
    <message>
        <source>another program has the file open and writes to it; close it there and save again</source>
        <translation>un autre programme a le fichier ouvert et y écrit&#xa0;; fermez-le là et enregistrez de nouveau</translation>
    </message>
    <message>
        <source>the disk is full: free some space and save again; what was there before is untouched</source>
        <translation>le disque est plein&#xa0;: libérez de la place et enregistrez de nouveau&#xa0;; ce qui s&apos;y trouvait avant est intact</translation>
    </message>
    <message>
        <source>the map was changed by someone else since it was read; nothing was written: read it again and repeat the change</source>
        <translation>quelqu&apos;un d&apos;autre a changé la carte depuis qu&apos;elle a été lue&#xa0;; rien n&apos;a été écrit&#xa0;: relisez-la et refaites le changement</translation>
    </message>
    <message>
        <source>there is no field level; level 0 is assumed</source>
        <translation>le champ level manque&#xa0;; le niveau 0 est supposé</translation>
    </message>
    <message>
        <source>there is no layer %1</source>
        <translation>la couche %1 manque</translation>
    </message>
    <message>
        <source>%1 do not join two regions and are not walked through: %2</source>
        <translation>%1 ne relient pas deux régions et on n&apos;y passe pas&#xa0;: %2</translation>
    </message>
    <message>
        <source>unknown kind &quot;%1&quot;, treated as other: %2</source>
        <translation>type inconnu «&#xa0;%1&#xa0;», traité comme autre&#xa0;: %2</translation>
    </message>
    <message>
        <source>no kind, treated as other: %1</source>
        <translation>sans type, traité comme autre&#xa0;: %1</translation>
    </message>
    <message>
        <source>a place is empty: give a region&apos;s id, name or ref, or x,y,level</source>
        <translation>le lieu est vide&#xa0;: indiquez l&apos;identifiant, le nom ou la référence d&apos;une région, ou x,y,niveau</translation>
    </message>
    <message>
        <source>no region of level %1 holds this point</source>
        <translation>aucune région du niveau %1 ne contient ce point</translation>
    </message>
    <message>
        <source>several regions are called so: %1; give one of these ids</source>
        <translation>plusieurs régions portent ce nom&#xa0;: %1&#xa0;; indiquez l&apos;un de ces identifiants</translation>
    </message>
    <message>
        <source>no region has this id, name or ref</source>
        <translation>aucune région n&apos;a cet identifiant, ce nom ou cette référence</translation>
    </message>
    <message>
        <source>no region has this id, name or ref; near spellings: %1</source>
        <translation>aucune région n&apos;a cet identifiant, ce nom ou cette référence&#xa0;; proches&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 (level %2)</source>
        <translation>%1 (niveau %2)</translation>
    </message>
    <message>
        <source>the map has no region &quot;%1&quot;</source>
        <translation>la carte n&apos;a pas de région «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the position is no number</source>
        <translation>la position n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>is out of its range</source>
        <translation>est hors de ses limites</translation>
    </message>
    <message>
        <source>has an outline that is none</source>
        <translation>a un contour qui n&apos;en est pas un</translation>
    </message>
    <message>
        <source>has no position</source>
        <translation>n&apos;a pas de position</translation>
    </message>
    <message>
        <source>a wall has no length</source>
        <translation>un mur n&apos;a pas de longueur</translation>
    </message>
    <message>
        <source>the map cannot be written there</source>
        <translation>la carte ne peut pas y être écrite</translation>
    </message>
    <message>
        <source>cannot be copied before saving</source>
        <translation>ne peut pas être copié avant l&apos;enregistrement</translation>
    </message>
    <message>
        <source>writing the map failed: %1</source>
        <translation>l&apos;écriture de la carte a échoué&#xa0;: %1</translation>
    </message>
    <message>
        <source>the map may not be changed now: someone else is changing it, or the user has no right to; nothing was written, save again in a moment</source>
        <translation>la carte ne peut pas être modifiée maintenant&#xa0;: quelqu&apos;un d&apos;autre la modifie, ou l&apos;utilisateur n&apos;en a pas le droit&#xa0;; rien n&apos;a été écrit, enregistrez de nouveau dans un instant</translation>
    </message>
    <message>
        <source>the database has no PostGIS: ask its administrator to add that extension</source>
        <translation>la base de données n&apos;a pas PostGIS&#xa0;: demandez à son administrateur d&apos;ajouter cette extension</translation>
    </message>
    <message>
        <source>this is no picture that can be read; use PNG, JPEG or GeoTIFF</source>
        <translation>ce n&apos;est pas une image lisible&#xa0;; utilisez PNG, JPEG ou GeoTIFF</translation>
    </message>
    <message>
        <source>the picture is damaged: save it anew</source>
        <translation>l&apos;image est endommagée&#xa0;: enregistrez-la de nouveau</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>permission refusée</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>le fichier ou le dossier n&apos;existe pas</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>le système de fichiers est en lecture seule</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>il n&apos;y a plus de place sur le disque</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>erreur de lecture ou d&apos;écriture</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>c&apos;est un dossier</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ce n&apos;est pas un dossier</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>le nom du fichier est trop long</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>l&apos;opération n&apos;est pas permise</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>trop de fichiers sont ouverts</translation>
    </message>
    <message>
        <source>cannot be read as a picture</source>
        <translation>ne peut pas être lu comme image</translation>
    </message>
    <message>
        <source>no source was named: give camera:0, a video file, a folder of pictures or an address</source>
        <translation>aucune source n&apos;a été indiquée&#xa0;: donnez camera:0, un fichier vidéo, un dossier d&apos;images ou une adresse</translation>
    </message>
    <message>
        <source>there is no such file or folder (a source is camera:0, a video file, a folder of pictures, or an http or rtsp address)</source>
        <translation>ce fichier ou ce dossier n&apos;existe pas (une source est camera:0, un fichier vidéo, un dossier d&apos;images ou une adresse http ou rtsp)</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>le dossier ne peut pas être lu</translation>
    </message>
    <message>
        <source>there are no pictures in this folder (jpg, png, bmp, webp or tif)</source>
        <translation>il n&apos;y a pas d&apos;images dans ce dossier (jpg, png, bmp, webp ou tif)</translation>
    </message>
    <message>
        <source>is neither a picture nor a video that can be opened (tried FFmpeg and GStreamer)</source>
        <translation>n&apos;est ni une image ni une vidéo qui puisse être ouverte (essayé avec FFmpeg et GStreamer)</translation>
    </message>
    <message>
        <source>the address does not answer with a video within %1 s (tried FFmpeg): is the camera on, and the address right?</source>
        <translation>l&apos;adresse ne répond pas par une vidéo en %1 s (essayé avec FFmpeg)&#xa0;: la caméra est-elle allumée, et l&apos;adresse juste&#xa0;?</translation>
    </message>
    <message>
        <source>a camera is named by its number or its device, such as camera:0</source>
        <translation>une caméra s&apos;indique par son numéro ou son périphérique, comme camera:0</translation>
    </message>
    <message>
        <source>the camera cannot be opened (tried Video4Linux at %1): is it plugged in, and not in use by another program?</source>
        <translation>la caméra ne peut pas être ouverte (essayé avec Video4Linux sur %1)&#xa0;: est-elle branchée, et libre de tout autre programme&#xa0;?</translation>
    </message>
    <message>
        <source>%1 delivers no more pictures</source>
        <translation>%1 ne fournit plus d&apos;images</translation>
    </message>
    <message>
        <source>%1 gives no more pictures</source>
        <translation>%1 ne donne plus d&apos;images</translation>
    </message>
    <message>
        <source>%1 is tried again (attempt %2)</source>
        <translation>nouvel essai de %1 (tentative %2)</translation>
    </message>
    <message>
        <source>%1 is back</source>
        <translation>%1 est de retour</translation>
    </message>
    <message>
        <source>%1 broke down: %2</source>
        <translation>%1 est tombé en panne&#xa0;: %2</translation>
    </message>
    <message>
        <source>the library&apos;s version is not a number: &quot;%1&quot;</source>
        <translation>la version de la bibliothèque n&apos;est pas un nombre&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the landmark library is of a later version (%1) than this program knows (%2); update Farol</source>
        <translation>la bibliothèque de repères est d&apos;une version (%1) plus récente que celle que connaît ce programme (%2)&#xa0;; mettez Farol à jour</translation>
    </message>
    <message>
        <source>holds no landmark library (no layers templates and views)</source>
        <translation>ne contient pas de bibliothèque de repères (sans couches templates et views)</translation>
    </message>
    <message>
        <source>the landmark library cannot be read</source>
        <translation>la bibliothèque de repères ne peut pas être lue</translation>
    </message>
    <message>
        <source>cannot save the library: %1</source>
        <translation>la bibliothèque ne peut pas être enregistrée&#xa0;: %1</translation>
    </message>
    <message>
        <source>is not a GeoPackage, and a library is kept in one (*.gpkg)</source>
        <translation>n&apos;est pas un GeoPackage, et une bibliothèque se range dans un tel fichier (*.gpkg)</translation>
    </message>
    <message>
        <source>a template has no name</source>
        <translation>un repère n&apos;a pas de nom</translation>
    </message>
    <message>
        <source>template %1 stands twice</source>
        <translation>le repère %1 figure deux fois</translation>
    </message>
    <message>
        <source>a view belongs to a template that is not in the library</source>
        <translation>une photographie appartient à un repère qui n&apos;est pas dans la bibliothèque</translation>
    </message>
    <message>
        <source>the photograph or its outline is missing</source>
        <translation>la photographie ou son contour manque</translation>
    </message>
    <message>
        <source>the extractor&apos;s parameters cannot be read: &quot;%1&quot;</source>
        <translation>les paramètres de l&apos;extracteur ne peuvent pas être lus&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the library was trained with %1, but %2; train it again from its photographs</source>
        <translation>la bibliothèque a été apprise avec %1, mais %2&#xa0;; faites-la réapprendre à partir de ses photographies</translation>
    </message>
    <message>
        <source>the library was trained with %1, but %2 is in use; train it again from its photographs, or choose its own extractor</source>
        <translation>la bibliothèque a été apprise avec %1, mais %2 est utilisé&#xa0;; faites-la réapprendre à partir de ses photographies, ou choisissez son propre extracteur</translation>
    </message>
    <message>
        <source>there is no feature extractor &quot;%1&quot;; there are %2</source>
        <translation>il n&apos;y a pas d&apos;extracteur «&#xa0;%1&#xa0;»&#xa0;; il y a %2</translation>
    </message>
    <message>
        <source>version %1 of %2 is not known, only %3</source>
        <translation>la version %1 de %2 n&apos;est pas connue, seulement la %3</translation>
    </message>
    <message>
        <source>the working size must be between 64 and 4096 pixels</source>
        <translation>la taille de travail doit être entre 64 et 4096 pixels</translation>
    </message>
    <message>
        <source>the number of keypoints must be between 10 and 20000</source>
        <translation>le nombre de points clés doit être entre 10 et 20000</translation>
    </message>
    <message>
        <source>the contrast threshold must be between 0 and 1</source>
        <translation>le seuil de contraste doit être entre 0 et 1</translation>
    </message>
    <message>
        <source>%1; the library is damaged: restore it or train this view again</source>
        <translation>%1&#xa0;; la bibliothèque est endommagée&#xa0;: restaurez-la ou faites réapprendre cette photographie</translation>
    </message>
    <message>
        <source>the outline &quot;%1&quot; is not eight numbers</source>
        <translation>le contour «&#xa0;%1&#xa0;» n&apos;est pas fait de huit nombres</translation>
    </message>
    <message>
        <source>the descriptors are not of the width that %1 makes</source>
        <translation>les descripteurs n&apos;ont pas la largeur que produit %1</translation>
    </message>
    <message>
        <source>the photograph&apos;s size is missing</source>
        <translation>la taille de la photographie manque</translation>
    </message>
    <message>
        <source>the checksum does not fit the photograph and its features</source>
        <translation>la somme de contrôle ne correspond pas à la photographie et à ses caractéristiques</translation>
    </message>
    <message>
        <source>the keypoints do not begin as they should</source>
        <translation>les points clés ne commencent pas comme il faut</translation>
    </message>
    <message>
        <source>the keypoints have an impossible size</source>
        <translation>les points clés ont une taille impossible</translation>
    </message>
    <message>
        <source>the keypoints are cut off or too long</source>
        <translation>les points clés sont coupés ou trop longs</translation>
    </message>
    <message>
        <source>the keypoints are of another kind</source>
        <translation>les points clés sont d&apos;un autre type</translation>
    </message>
    <message>
        <source>a keypoint has an impossible value</source>
        <translation>un point clé a une valeur impossible</translation>
    </message>
    <message>
        <source>the descriptors do not begin as they should</source>
        <translation>les descripteurs ne commencent pas comme il faut</translation>
    </message>
    <message>
        <source>the descriptors have an impossible size</source>
        <translation>les descripteurs ont une taille impossible</translation>
    </message>
    <message>
        <source>the descriptors are cut off or too long</source>
        <translation>les descripteurs sont coupés ou trop longs</translation>
    </message>
    <message>
        <source>the descriptors are of another kind</source>
        <translation>les descripteurs sont d&apos;un autre type</translation>
    </message>
    <message>
        <source>there are not as many descriptors as keypoints</source>
        <translation>il n&apos;y a pas autant de descripteurs que de points clés</translation>
    </message>
    <message>
        <source>cannot replace the layer</source>
        <translation>la couche ne peut pas être remplacée</translation>
    </message>
    <message>
        <source>cannot make the layer</source>
        <translation>la couche ne peut pas être créée</translation>
    </message>
    <message>
        <source>cannot make the field %1</source>
        <translation>le champ %1 ne peut pas être créé</translation>
    </message>
    <message>
        <source>cannot replace the version</source>
        <translation>la version ne peut pas être remplacée</translation>
    </message>
    <message>
        <source>the layer has no fields key and value: this is not one of Farol&apos;s files</source>
        <translation>la couche n&apos;a pas les champs key et value&#xa0;: ce fichier n&apos;est pas de Farol</translation>
    </message>
    <message>
        <source>no view is chosen</source>
        <translation>aucune photographie n&apos;est choisie</translation>
    </message>
    <message>
        <source>a template needs at least one view; delete it instead</source>
        <translation>un repère a besoin d&apos;au moins une photographie&#xa0;; supprimez-le plutôt</translation>
    </message>
    <message>
        <source>a template needs a name of its own</source>
        <translation>un repère a besoin d&apos;un nom à lui</translation>
    </message>
    <message>
        <source>this name is taken by another template</source>
        <translation>ce nom est déjà celui d&apos;un autre repère</translation>
    </message>
    <message>
        <source>a template needs at least one view</source>
        <translation>un repère a besoin d&apos;au moins une photographie</translation>
    </message>
    <message>
        <source>a real size must be a positive number of metres</source>
        <translation>une taille réelle doit être un nombre positif de mètres</translation>
    </message>
    <message>
        <source>a template cannot be merged with itself</source>
        <translation>un repère ne peut pas être réuni avec lui-même</translation>
    </message>
    <message>
        <source>a place and an object cannot be one template; choose two of the same sort</source>
        <translation>un lieu et un objet ne peuvent pas former un seul repère&#xa0;; choisissez-en deux de la même sorte</translation>
    </message>
    <message>
        <source>the outline has a corner that is no number</source>
        <translation>le contour a un angle qui n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>the outline leaves the picture, which is %1 x %2 pixels</source>
        <translation>le contour sort de l&apos;image, qui fait %1 x %2 pixels</translation>
    </message>
    <message>
        <source>the outline&apos;s four corners must follow the object&apos;s border clockwise from its top left, without crossing</source>
        <translation>les quatre angles du contour doivent suivre le bord de l&apos;objet dans le sens des aiguilles d&apos;une montre depuis le haut à gauche, sans se croiser</translation>
    </message>
    <message>
        <source>the outline&apos;s corners run counter-clockwise; give them clockwise from the object&apos;s top left</source>
        <translation>les angles du contour tournent à l&apos;envers des aiguilles d&apos;une montre&#xa0;; donnez-les dans leur sens depuis le haut à gauche de l&apos;objet</translation>
    </message>
    <message>
        <source>the outline is only %1 x %2 pixels; photograph the object from nearer</source>
        <translation>le contour ne fait que %1 x %2 pixels&#xa0;; photographiez l&apos;objet de plus près</translation>
    </message>
    <message>
        <source>a template needs a name</source>
        <translation>un repère a besoin d&apos;un nom</translation>
    </message>
    <message>
        <source>this template is of kind %1, not %2; use another template name</source>
        <translation>ce repère est du type %1, non %2&#xa0;; utilisez un autre nom</translation>
    </message>
    <message>
        <source>only %1 features were found in the picture; at least %2 are needed: take a sharp, well lit photograph of something with detail, from nearer</source>
        <translation>seules %1 caractéristiques ont été trouvées dans l&apos;image&#xa0;; il en faut au moins %2&#xa0;: prenez une photographie nette et bien éclairée de quelque chose de détaillé, de plus près</translation>
    </message>
    <message>
        <source>only %1 features were found inside the outline; at least %2 are needed: take a sharp, well lit photograph of something with detail, from nearer</source>
        <translation>seules %1 caractéristiques ont été trouvées dans le contour&#xa0;; il en faut au moins %2&#xa0;: prenez une photographie nette et bien éclairée de quelque chose de détaillé, de plus près</translation>
    </message>
    <message>
        <source>the photograph cannot be read as a picture</source>
        <translation>la photographie ne peut pas être lue comme image</translation>
    </message>
    <message>
        <source>the photograph cannot be used: %1</source>
        <translation>la photographie ne peut pas être utilisée&#xa0;: %1</translation>
    </message>
    <message>
        <source>template %1</source>
        <translation>repère %1</translation>
    </message>
    <message>
        <source>%1, template %2</source>
        <translation>%1, repère %2</translation>
    </message>
    <message>
        <source>%1, view %2</source>
        <translation>%1, photographie %2</translation>
    </message>
    <message>
        <source>%1, a view of template %2</source>
        <translation>%1, une photographie du repère %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>cannot reopen for writing</source>
        <translation>ne peut pas être rouvert en écriture</translation>
    </message>
    <message>
        <source>cannot write to disk</source>
        <translation>l&apos;écriture sur le disque est impossible</translation>
    </message>
    <message>
        <source>cannot copy before saving</source>
        <translation>la copie avant l&apos;enregistrement est impossible</translation>
    </message>
    <message>
        <source>cannot put the new file in place</source>
        <translation>le nouveau fichier ne peut pas être mis en place</translation>
    </message>
    <message>
        <source>is no ordinary file; name another one</source>
        <translation>n&apos;est pas un fichier ordinaire&#xa0;; indiquez-en un autre</translation>
    </message>
    <message>
        <source>cannot open</source>
        <translation>l&apos;ouverture a échoué</translation>
    </message>
    <message>
        <source>cannot read</source>
        <translation>la lecture a échoué</translation>
    </message>
    <message>
        <source>cannot write</source>
        <translation>l&apos;écriture a échoué</translation>
    </message>
    <message>
        <source>cannot begin to write</source>
        <translation>l&apos;écriture ne peut pas commencer</translation>
    </message>
    <message>
        <source>cannot finish writing</source>
        <translation>l&apos;écriture ne peut pas s&apos;achever</translation>
    </message>
    <message>
        <source>cannot create the file</source>
        <translation>le fichier ne peut pas être créé</translation>
    </message>
    <message>
        <source>this GDAL has no GeoPackage driver</source>
        <translation>ce GDAL n&apos;a pas de pilote GeoPackage</translation>
    </message>
    <message>
        <source>the connection cannot be understood: write PG: and then key=value pairs such as dbname=campus host=maps user=anna, values with blanks in single quotes</source>
        <translation>la connexion n&apos;est pas comprise&#xa0;: écrivez PG: puis des paires clé=valeur, comme dbname=campus host=maps user=anna, les valeurs avec espaces entre apostrophes</translation>
    </message>
    <message>
        <source>%1; skipped (%2 so far)</source>
        <translation>%1&#xa0;; image sautée (%2 jusqu&apos;ici)</translation>
    </message>
    <message>
        <source>%1 cannot be read as a picture</source>
        <translation>%1&#xa0;: ne peut pas être lu comme image</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>ce dossier n&apos;existe pas</translation>
    </message>
    <message>
        <source>is not a recording: it holds no recording.json</source>
        <translation>n&apos;est pas un enregistrement&#xa0;: il y manque recording.json</translation>
    </message>
    <message>
        <source>is not JSON</source>
        <translation>n&apos;est pas du JSON</translation>
    </message>
    <message>
        <source>is not the header of a recording</source>
        <translation>n&apos;est pas l&apos;en-tête d&apos;un enregistrement</translation>
    </message>
    <message>
        <source>was made by a later version of Farol (recording format %1, this program reads up to %2)</source>
        <translation>a été fait par une version plus récente de Farol (format d&apos;enregistrement %1&#xa0;; ce programme lit jusqu&apos;au %2)</translation>
    </message>
    <message>
        <source>is neither a percept nor a command</source>
        <translation>n&apos;est ni une observation ni une commande</translation>
    </message>
    <message>
        <source>is a file; a new or empty folder is wanted for a recording</source>
        <translation>est un fichier&#xa0;; il faut un dossier nouveau ou vide pour un enregistrement</translation>
    </message>
    <message>
        <source>is not empty; choose a new folder, so that no recording is overwritten</source>
        <translation>n&apos;est pas vide&#xa0;; choisissez un nouveau dossier, pour qu&apos;aucun enregistrement ne soit écrasé</translation>
    </message>
    <message>
        <source>cannot create</source>
        <translation>la création a échoué</translation>
    </message>
    <message>
        <source>cannot create the recording</source>
        <translation>l&apos;enregistrement ne peut pas être créé</translation>
    </message>
    <message>
        <source>cannot encode the picture</source>
        <translation>l&apos;image ne peut pas être encodée</translation>
    </message>
    <message>
        <source>the recording stopped (%1); the walk goes on</source>
        <translation>l&apos;enregistrement s&apos;est arrêté (%1)&#xa0;; le parcours continue</translation>
    </message>
    <message>
        <source>the walk broke off: %1</source>
        <translation>le parcours s&apos;est interrompu&#xa0;: %1</translation>
    </message>
    <message>
        <source>frame %1 could not be looked at: %2</source>
        <translation>l&apos;image %1 n&apos;a pas pu être examinée&#xa0;: %2</translation>
    </message>
    <message>
        <source>there is no source of pictures; open one first</source>
        <translation>il n&apos;y a pas de source d&apos;images&#xa0;; ouvrez-en une d&apos;abord</translation>
    </message>
    <message>
        <source>there is no map; open one first</source>
        <translation>il n&apos;y a pas de carte&#xa0;; ouvrez-en une d&apos;abord</translation>
    </message>
</context>
<context>
    <name>farol::Options</name>
    <message>
        <source>%1 needs a number above 0, not “%2”</source>
        <translation>%1 demande un nombre supérieur à 0, pas «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1 needs a size such as 1280x800, not “%2”</source>
        <translation>%1 demande une taille comme 1280x800, pas «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>“%1” is not known; see --help</source>
        <translation>«&#xa0;%1&#xa0;» est inconnu&#xa0;; voir --help</translation>
    </message>
</context>
<context>
    <name>farol::espeak</name>
    <message>
        <source>The data of the voice are missing: install espeak-ng-data.</source>
        <translation>Les données de la voix manquent&#xa0;: installez espeak-ng-data.</translation>
    </message>
    <message>
        <source>There is no sound device.</source>
        <translation>Il n&apos;y a pas de périphérique audio.</translation>
    </message>
    <message>
        <source>The sound device cannot play speech: choose another one.</source>
        <translation>Le périphérique audio ne peut pas restituer la parole&#xa0;: choisissez-en un autre.</translation>
    </message>
    <message>
        <source>The sound device does not start.</source>
        <translation>Le périphérique audio ne démarre pas.</translation>
    </message>
    <message>
        <source>The sound device stopped in the middle of a text.</source>
        <translation>Le périphérique audio s&apos;est arrêté au milieu d&apos;un texte.</translation>
    </message>
    <message>
        <source>The voice cannot be loaded: choose another one.</source>
        <translation>La voix ne peut pas être chargée&#xa0;: choisissez-en une autre.</translation>
    </message>
    <message>
        <source>The text could not be turned into sound.</source>
        <translation>Le texte n&apos;a pas pu être transformé en son.</translation>
    </message>
</context>
<context>
    <name>farol::ui::AccessDialog</name>
    <message>
        <source>Door or passage %1</source>
        <translation>Porte ou passage %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>What sort of passage it is</source>
        <translation>De quelle sorte de passage il s&apos;agit</translation>
    </message>
    <message>
        <source>Type part of a name, room number or level, then choose</source>
        <translation>Tapez une partie d&apos;un nom, d&apos;un numéro de salle ou d&apos;un niveau, puis choisissez</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Un côté</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Autre côté</translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>dans les deux sens</translation>
    </message>
    <message>
        <source>from the one side to the other only</source>
        <translation>seulement du premier côté au second</translation>
    </message>
    <message>
        <source>from the other side to the one only</source>
        <translation>seulement du second côté au premier</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Which way one can pass</source>
        <translation>Dans quel sens on peut passer</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>How wide the door is</source>
        <translation>Largeur de la porte</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Marches</translation>
    </message>
    <message>
        <source>How many steps the stairs have</source>
        <translation>Nombre de marches de l&apos;escalier</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Est</translation>
    </message>
    <message>
        <source>Place on the map, metres to the east</source>
        <translation>Emplacement sur la carte, mètres vers l&apos;est</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>Place on the map, metres to the north</source>
        <translation>Emplacement sur la carte, mètres vers le nord</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fermé</translation>
    </message>
    <message>
        <source>Nobody can pass</source>
        <translation>Personne ne peut passer</translation>
    </message>
</context>
<context>
    <name>farol::ui::Banner</name>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
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
        <translation>%1&#xa0;: retrouvé dans %2 vues sur %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 taken for %2: %n time(s)</source>
        <translation>
            <numerusform>%1 pris pour %2&#xa0;: %n fois</numerusform>
            <numerusform>%1 pris pour %2&#xa0;: %n fois</numerusform>
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
        <translation>Le visiteur %1 est arrivé à %2 en %3. Le suivant vient dans un instant.</translation>
    </message>
    <message>
        <source>Visitor %1 did not come to %2 and was fetched. The next one comes in a moment.</source>
        <translation>Le visiteur %1 n&apos;est pas arrivé à %2 et on est venu le chercher. Le suivant vient dans un instant.</translation>
    </message>
    <message>
        <source>A simulated building and camera. Visitor %1 wants to go from %2 to %3 (%4 m) and hears only what is said. Choose another destination at any time.</source>
        <translation>Un bâtiment et une caméra simulés. Le visiteur %1 veut aller de %2 à %3 (%4 m) et n&apos;entend que ce qui est dit. Choisissez une autre destination à tout moment.</translation>
    </message>
    <message>
        <source>&amp;Demo</source>
        <translation>Dé&amp;monstration</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Démonstration</translation>
    </message>
    <message>
        <source>&amp;Wrong turn</source>
        <translation>&amp;Mauvais tournant</translation>
    </message>
    <message>
        <source>Wrong turn</source>
        <translation>Mauvais tournant</translation>
    </message>
    <message>
        <source>The walker takes another way than was said</source>
        <translation>Le marcheur prend un autre chemin que celui qui a été dit</translation>
    </message>
    <message>
        <source>&amp;Cover the camera</source>
        <translation>&amp;Couvrir la caméra</translation>
    </message>
    <message>
        <source>Cover camera</source>
        <translation>Couvrir la caméra</translation>
    </message>
    <message>
        <source>A hand lies on the simulated camera</source>
        <translation>Une main couvre la caméra simulée</translation>
    </message>
    <message>
        <source>&amp;Lights out</source>
        <translation>&amp;Éteindre la lumière</translation>
    </message>
    <message>
        <source>Lights out</source>
        <translation>Éteindre la lumière</translation>
    </message>
    <message>
        <source>Nearly dark in the whole building</source>
        <translation>Presque noir dans tout le bâtiment</translation>
    </message>
    <message>
        <source>&amp;Next visitor</source>
        <translation>Visiteur &amp;suivant</translation>
    </message>
    <message>
        <source>Next visitor</source>
        <translation>Visiteur suivant</translation>
    </message>
    <message>
        <source>End this walk; somebody else comes with another destination</source>
        <translation>Terminer ce parcours&#xa0;; une autre personne vient avec une autre destination</translation>
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
        <translation>non accepté</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Concordance</translation>
    </message>
</context>
<context>
    <name>farol::ui::DraftStore</name>
    <message>
        <source>what you are teaching cannot be kept on disk (%1); it would be lost with the program</source>
        <translation>ce que vous enseignez ne peut pas être gardé sur le disque (%1)&#xa0;; ce serait perdu avec le programme</translation>
    </message>
    <message>
        <source>the folder for what you are teaching cannot be made; it would be lost with the program</source>
        <translation>le dossier pour ce que vous enseignez ne peut pas être créé&#xa0;; ce serait perdu avec le programme</translation>
    </message>
</context>
<context>
    <name>farol::ui::EditTemplateDialog</name>
    <message>
        <source>Change “%1”</source>
        <translation>Modifier «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1&#xa0;:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>What people call it</source>
        <translation>Comment les gens l&apos;appellent</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Ce que c&apos;est</translation>
    </message>
    <message>
        <source>Real width</source>
        <translation>Largeur réelle</translation>
    </message>
    <message>
        <source>Lets Farol tell how far away it is</source>
        <translation>Permet à Farol de dire à quelle distance il est</translation>
    </message>
    <message>
        <source>Real height</source>
        <translation>Hauteur réelle</translation>
    </message>
    <message>
        <source>In maps called</source>
        <translation>Appelé dans les cartes</translation>
    </message>
    <message>
        <source>Landmarks of the map refer to it by this word: when it changes, change them too</source>
        <translation>Les repères de la carte s&apos;y réfèrent par ce mot&#xa0;: s&apos;il change, changez-les aussi</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeatureDialog</name>
    <message>
        <source>%1:</source>
        <translation>%1&#xa0;:</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeatureModel</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Area (m²)</source>
        <translation>Surface (m²)</translation>
    </message>
    <message>
        <source>Doors</source>
        <translation>Portes</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Voisins</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>Restricted</source>
        <translation>Restreint</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Un côté</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Autre côté</translation>
    </message>
    <message>
        <source>Width (m)</source>
        <translation>Largeur (m)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Marches</translation>
    </message>
    <message>
        <source>One way</source>
        <translation>Sens unique</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fermé</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Cage</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>Faces (°)</source>
        <translation>Orientation (°)</translation>
    </message>
    <message>
        <source>Height (m)</source>
        <translation>Hauteur (m)</translation>
    </message>
    <message>
        <source>Wide (m)</source>
        <translation>Largeur propre (m)</translation>
    </message>
    <message>
        <source>Tall (m)</source>
        <translation>Hauteur propre (m)</translation>
    </message>
    <message>
        <source>Trained as</source>
        <translation>Appris comme</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeaturePanel</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n ligne</numerusform>
            <numerusform>%n lignes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n row(s)</source>
        <translation>
            <numerusform>%1 sur %n ligne</numerusform>
            <numerusform>%1 sur %n lignes</numerusform>
        </translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Régions</translation>
    </message>
    <message>
        <source>Doors and passages</source>
        <translation>Portes et passages</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>What the table lists</source>
        <translation>Ce que montre le tableau</translation>
    </message>
    <message>
        <source>Search the table</source>
        <translation>Chercher dans le tableau</translation>
    </message>
    <message>
        <source>Rows that hold every word typed (Ctrl+F)</source>
        <translation>Lignes contenant tous les mots tapés (Ctrl+F)</translation>
    </message>
    <message>
        <source>This level onl&amp;y</source>
        <translation>Ce &amp;niveau seulement</translation>
    </message>
    <message>
        <source>This level only</source>
        <translation>Ce niveau seulement</translation>
    </message>
    <message>
        <source>List only what is on the level that the plan shows</source>
        <translation>Ne montrer que ce qui est au niveau affiché par le plan</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Attributs</translation>
    </message>
    <message>
        <source>Choose a row to see it on the plan; press Enter to change it</source>
        <translation>Choisissez une ligne pour la voir sur le plan&#xa0;; appuyez sur Entrée pour la modifier</translation>
    </message>
    <message>
        <source>No row has what is looked for.</source>
        <translation>Aucune ligne ne contient ce qui est cherché.</translation>
    </message>
    <message>
        <source>The map has none of these.</source>
        <translation>La carte n&apos;en a aucun.</translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>Aucune carte n&apos;est ouverte.</translation>
    </message>
</context>
<context>
    <name>farol::ui::Figures</name>
    <message>
        <source>Votes over time</source>
        <translation>Votes au fil du temps</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>secondes</translation>
    </message>
    <message>
        <source>votes</source>
        <translation>voix</translation>
    </message>
    <message>
        <source>Start a walk first.</source>
        <translation>Commencez d&apos;abord un parcours.</translation>
    </message>
    <message>
        <source>How long pictures took to understand</source>
        <translation>Temps mis pour comprendre les images</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>millisecondes</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>images</translation>
    </message>
    <message>
        <source>How sure, and how right</source>
        <translation>Combien sûr, et combien juste</translation>
    </message>
    <message>
        <source>told confidence</source>
        <translation>confiance annoncée</translation>
    </message>
    <message>
        <source>share that was right</source>
        <translation>part juste</translation>
    </message>
    <message>
        <source>The truth is known in simulated walks only: start the demonstration.</source>
        <translation>La vérité n&apos;est connue que dans les parcours simulés&#xa0;: lancez la démonstration.</translation>
    </message>
    <message>
        <source>this walk</source>
        <translation>ce parcours</translation>
    </message>
    <message>
        <source>From how far each landmark is found</source>
        <translation>De quelle distance chaque repère est trouvé</translation>
    </message>
    <message>
        <source>landmarks</source>
        <translation>repères</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <source>Check the library on the Landmarks page first (F7); landmarks need a real size.</source>
        <translation>Vérifiez d&apos;abord la bibliothèque sur la page Repères (F7)&#xa0;; les repères doivent avoir une taille réelle.</translation>
    </message>
</context>
<context>
    <name>farol::ui::FiguresDialog</name>
    <message>
        <source>Figures</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Which chart is shown</source>
        <translation>Quel graphique est montré</translation>
    </message>
    <message>
        <source>&amp;Save as PNG or SVG…</source>
        <translation>&amp;Enregistrer en PNG ou SVG…</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Enregistrer le graphique</translation>
    </message>
    <message>
        <source>Save the chart as a picture, or as a drawing that stays sharp</source>
        <translation>Enregistrer le graphique en image, ou en dessin qui reste net</translation>
    </message>
    <message>
        <source>Charts (%1)</source>
        <translation>Graphiques (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 ne peut pas être écrit. Choisissez un autre dossier.</translation>
    </message>
</context>
<context>
    <name>farol::ui::FindingModel</name>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Rule: %1</source>
        <translation>Règle&#xa0;: %1</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Ce qui a été trouvé</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Combien</translation>
    </message>
</context>
<context>
    <name>farol::ui::FloorModel</name>
    <message>
        <source>you are here</source>
        <translation>vous êtes ici</translation>
    </message>
    <message>
        <source>destination</source>
        <translation>destination</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
</context>
<context>
    <name>farol::ui::FloorPictures</name>
    <message>
        <source>The image lies where its file says.</source>
        <translation>L&apos;image se trouve là où son fichier l&apos;indique.</translation>
    </message>
    <message>
        <source>Now click where this point belongs on the map. Escape gives up.</source>
        <translation>Cliquez maintenant là où ce point se trouve sur la carte. Échap renonce.</translation>
    </message>
    <message>
        <source>Click a point of the image that you know on the map, a corner of the house, say. Escape leaves the image where it is.</source>
        <translation>Cliquez sur un point de l&apos;image connu sur la carte, par exemple un coin de mur. Échap laisse l&apos;image où elle est.</translation>
    </message>
    <message>
        <source>Click a second point of the image, far from the first.</source>
        <translation>Cliquez sur un deuxième point de l&apos;image, loin du premier.</translation>
    </message>
    <message>
        <source>Placed. A third point straightens a skewed image; Escape ends.</source>
        <translation>Placée. Un troisième point redresse une image déformée&#xa0;; Échap termine.</translation>
    </message>
    <message>
        <source>That is beside the image. Click a point of the image.</source>
        <translation>C&apos;est à côté de l&apos;image. Cliquez sur un point de l&apos;image.</translation>
    </message>
    <message>
        <source>These points lie too near each other, or on one line. Click another one.</source>
        <translation>Ces points sont trop proches les uns des autres, ou sur une même ligne. Cliquez sur un autre.</translation>
    </message>
    <message>
        <source>The image is placed by three points.</source>
        <translation>L&apos;image est placée par trois points.</translation>
    </message>
    <message>
        <source>How strong the floor-plan image is</source>
        <translation>Avec quelle force se voit l&apos;image du plan</translation>
    </message>
    <message>
        <source>Place by p&amp;oints</source>
        <translation>Placer par p&amp;oints</translation>
    </message>
    <message>
        <source>Place the image by points</source>
        <translation>Placer l&apos;image par points</translation>
    </message>
    <message>
        <source>Click two or three points of the image and where they belong on the map</source>
        <translation>Cliquer sur deux ou trois points de l&apos;image et là où ils se trouvent sur la carte</translation>
    </message>
    <message>
        <source>Take a&amp;way</source>
        <translation>Retire&amp;r</translation>
    </message>
    <message>
        <source>Take the image away</source>
        <translation>Retirer l&apos;image</translation>
    </message>
    <message>
        <source>The floor shows no image any more; its file stays</source>
        <translation>L&apos;étage ne montre plus d&apos;image&#xa0;; son fichier reste</translation>
    </message>
    <message>
        <source>Ima&amp;ge:</source>
        <translation>Ima&amp;ge&#xa0;:</translation>
    </message>
</context>
<context>
    <name>farol::ui::FramePanel</name>
    <message>
        <source>What the camera sees</source>
        <translation>Ce que voit la caméra</translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation>Image de la caméra</translation>
    </message>
    <message>
        <source>The camera&apos;s picture, with what Farol recognised in it</source>
        <translation>L&apos;image de la caméra, avec ce que Farol y a reconnu</translation>
    </message>
    <message>
        <source>Picture %1 at %2</source>
        <translation>Image %1 à %2</translation>
    </message>
    <message>
        <source>Picture %1 at %2 (%3)</source>
        <translation>Image %1 à %2 (%3)</translation>
    </message>
    <message>
        <source>understood in %1 ms</source>
        <translation>comprise en %1 ms</translation>
    </message>
    <message numerus="yes">
        <source>%n left out because late</source>
        <translation>
            <numerusform>%n omise car en retard</numerusform>
            <numerusform>%n omises car en retard</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unreadable</source>
        <translation>
            <numerusform>%n illisible</numerusform>
            <numerusform>%n illisibles</numerusform>
        </translation>
    </message>
    <message>
        <source>Time from the picture&apos;s arrival to the answer, and how many pictures had to be left out because Farol was still busy with an earlier one</source>
        <translation>Temps entre l&apos;arrivée de l&apos;image et la réponse, et nombre d&apos;images omises parce que Farol traitait encore une image précédente</translation>
    </message>
</context>
<context>
    <name>farol::ui::FrameView</name>
    <message>
        <source>No picture yet</source>
        <translation>Pas encore d&apos;image</translation>
    </message>
    <message>
        <source>Nothing known is in the picture</source>
        <translation>Rien de connu dans l&apos;image</translation>
    </message>
    <message>
        <source>In the picture: %1</source>
        <translation>Dans l&apos;image&#xa0;: %1</translation>
    </message>
    <message>
        <source>Spoken: %1</source>
        <translation>Dit&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 · %2 %</source>
        <translation>%1 · %2 %</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>No picture yet.
Open a camera, a video or a folder of pictures, then press Play.</source>
        <translation>Pas encore d&apos;image.
Ouvrez une caméra, une vidéo ou un dossier d&apos;images, puis appuyez sur Lecture.</translation>
    </message>
</context>
<context>
    <name>farol::ui::HelpDialog</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Chapitres</translation>
    </message>
    <message>
        <source>What the help is about</source>
        <translation>De quoi parle l&apos;aide</translation>
    </message>
    <message>
        <source>Walk page</source>
        <translation>Page Parcours</translation>
    </message>
    <message>
        <source>Map page</source>
        <translation>Page Carte</translation>
    </message>
    <message>
        <source>Landmarks page</source>
        <translation>Page Repères</translation>
    </message>
    <message>
        <source>Kiosk</source>
        <translation>Borne</translation>
    </message>
    <message>
        <source>Text of the chapter</source>
        <translation>Texte du chapitre</translation>
    </message>
    <message>
        <source>Here a map of a building is opened or brought in, looked at, checked and changed. The plan and the table show the same: what is chosen in one is chosen in the other.</source>
        <translation>Ici, on ouvre ou importe la carte d&apos;un bâtiment, on la regarde, la vérifie et la modifie. Le plan et le tableau montrent la même chose&#xa0;: ce qui est choisi dans l&apos;un l&apos;est dans l&apos;autre.</translation>
    </message>
    <message>
        <source>F7 looks for what is wrong with the map and says what to do about each finding.</source>
        <translation>F7 cherche ce qui ne va pas dans la carte et dit que faire de chaque constat.</translation>
    </message>
    <message>
        <source>Ctrl+U marks places that the landmarks cannot tell apart. A landmark there helps most.</source>
        <translation>Ctrl+U marque les lieux que les repères ne distinguent pas. C&apos;est là qu&apos;un repère aide le plus.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L puts a landmark on the plan, Ctrl+Shift+D a door. Drag what is chosen, or move it with Alt and the arrows.</source>
        <translation>Ctrl+Maj+L place un repère sur le plan, Ctrl+Maj+D une porte. Glissez la sélection, ou déplacez-la avec Alt et les flèches.</translation>
    </message>
    <message>
        <source>Ctrl+Z takes every step back. Nothing is written until you save with Ctrl+S.</source>
        <translation>Ctrl+Z annule chaque étape. Rien n&apos;est écrit avant l&apos;enregistrement par Ctrl+S.</translation>
    </message>
    <message>
        <source>Here Farol is taught what it shall know again. Every change is saved by itself and can be taken back with Ctrl+Z; a landmark that is not finished is kept, also when the computer stops.</source>
        <translation>Ici, on apprend à Farol ce qu&apos;il doit reconnaître. Chaque modification s&apos;enregistre d&apos;elle-même et s&apos;annule par Ctrl+Z&#xa0;; un repère inachevé est gardé, même si l&apos;ordinateur s&apos;arrête.</translation>
    </message>
    <message>
        <source>Ctrl+T teaches a landmark in four steps: what it is, its views, a trial, its place on the map.</source>
        <translation>Ctrl+T apprend un repère en quatre étapes&#xa0;: ce que c&apos;est, ses vues, un essai, son emplacement sur la carte.</translation>
    </message>
    <message>
        <source>Take a view from the front, from the left, from the right and from farther away. The coach says what is wrong with a picture and which one comes next. Drag the four corners onto the landmark; by keys, 1 to 4 choose a corner and the arrows move it.</source>
        <translation>Prenez une vue de face, de la gauche, de la droite et de plus loin. Le conseil dit ce qui ne va pas dans une image et laquelle vient ensuite. Glissez les quatre coins sur le repère&#xa0;; au clavier, 1 à 4 choisissent un coin et les flèches le déplacent.</translation>
    </message>
    <message>
        <source>F7 checks the whole library: how well each landmark is found, how far away, how far aside, and which are taken for each other. Merge what is the same, and add views to what is lost.</source>
        <translation>F7 vérifie toute la bibliothèque&#xa0;: si chaque repère est bien trouvé, de quelle distance, de quel côté, et lesquels sont confondus. Fusionnez ce qui est pareil, et ajoutez des vues à ce qui est perdu.</translation>
    </message>
    <message>
        <source>Here somebody is guided, and you watch: what the camera sees, the place on the map, what is said, and why.</source>
        <translation>Ici, quelqu&apos;un est guidé et vous suivez&#xa0;: ce que voit la caméra, le lieu sur la carte, ce qui est dit, et pourquoi.</translation>
    </message>
    <message>
        <source>Ctrl+O opens the map of the building.</source>
        <translation>Ctrl+O ouvre la carte du bâtiment.</translation>
    </message>
    <message>
        <source>Ctrl+L opens the landmarks that belong to it.</source>
        <translation>Ctrl+L ouvre les repères qui vont avec.</translation>
    </message>
    <message>
        <source>Ctrl+P chooses a camera, a video or a folder of pictures, and Ctrl+G where to go.</source>
        <translation>Ctrl+P choisit une caméra, une vidéo ou un dossier d&apos;images, et Ctrl+G où aller.</translation>
    </message>
    <message>
        <source>F5 starts and holds the walk, F8 goes on by one picture.</source>
        <translation>F5 lance et suspend le parcours, F8 avance d&apos;une image.</translation>
    </message>
    <message>
        <source>When the place shown is not right, choose the right one on the map and press Ctrl+H.</source>
        <translation>Si le lieu montré n&apos;est pas le bon, choisissez le bon sur la carte et appuyez sur Ctrl+H.</translation>
    </message>
    <message>
        <source>Ctrl+W gives the place up, so that it is looked for anew.</source>
        <translation>Ctrl+W abandonne le lieu, pour qu&apos;il soit cherché de nouveau.</translation>
    </message>
    <message>
        <source>Ctrl+E speaks a sentence that you type.</source>
        <translation>Ctrl+E dit une phrase que vous tapez.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R records the next walk. A recorded walk can be worked out anew in another way and compared, from the Walk menu.</source>
        <translation>Ctrl+Maj+R enregistre le prochain parcours. Un parcours enregistré peut être recalculé autrement et comparé, par le menu Parcours.</translation>
    </message>
    <message>
        <source>The timeline at the bottom looks back: drag it, or use the arrow keys. “Why there” explains the vote of the place that is chosen in the list.</source>
        <translation>La ligne du temps, en bas, regarde en arrière&#xa0;: glissez-la, ou utilisez les flèches. «&#xa0;Pourquoi là&#xa0;» explique le vote du lieu choisi dans la liste.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+U marks from where no landmark is seen, and Ctrl+Shift+N lists the routes that are missing. Ctrl+Shift+I lays the image of a floor plan under the floor: click two points of it and where they belong.</source>
        <translation>Ctrl+Maj+U marque d&apos;où l&apos;on ne voit aucun repère, et Ctrl+Maj+N énumère les itinéraires qui manquent. Ctrl+Maj+I pose l&apos;image d&apos;un plan sous l&apos;étage&#xa0;: cliquez sur deux de ses points et là où ils se trouvent.</translation>
    </message>
    <message>
        <source>The kiosk is for a blind user who is alone: “farol --kiosk” fills the screen and says everything. Arrows and Enter choose a destination, F searches by name, digits by number; F1 says all keys, Escape goes back.</source>
        <translation>La borne est pour un utilisateur aveugle qui est seul&#xa0;: «&#xa0;farol --kiosk&#xa0;» remplit l&apos;écran et dit tout. Les flèches et Entrée choisissent la destination, F cherche par le nom, les chiffres par le numéro&#xa0;; F1 dit toutes les touches, Échap revient en arrière.</translation>
    </message>
</context>
<context>
    <name>farol::ui::HistoryModel</name>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
</context>
<context>
    <name>farol::ui::ImportDialog</name>
    <message>
        <source>Import a map</source>
        <translation>Importer une carte</translation>
    </message>
    <message>
        <source>A file, a folder or a zip: IMDF, OpenStreetMap indoor, IndoorGML, per-floor Shapefiles, GeoJSON, GeoPackage, HULOP, WRLD. What is found wrong is told afterwards; nothing is written until you save.</source>
        <translation>Un fichier, un dossier ou un zip&#xa0;: IMDF, OpenStreetMap d&apos;intérieur, IndoorGML, Shapefiles par étage, GeoJSON, GeoPackage, HULOP, WRLD. Les défauts trouvés sont dits ensuite&#xa0;; rien n&apos;est écrit avant l&apos;enregistrement.</translation>
    </message>
    <message>
        <source>&amp;File…</source>
        <translation>&amp;Fichier…</translation>
    </message>
    <message>
        <source>Fol&amp;der…</source>
        <translation>&amp;Dossier…</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Choisir un fichier</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>d&apos;après son contenu</translation>
    </message>
    <message>
        <source>as the format has it</source>
        <translation>comme dans le format</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1&#xa0;:</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>Path of the file, folder or zip</source>
        <translation>Chemin du fichier, du dossier ou du zip</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Of which kind the map is</source>
        <translation>De quel type est la carte</translation>
    </message>
    <message>
        <source>Language of names</source>
        <translation>Langue des noms</translation>
    </message>
    <message>
        <source>Which of several names is taken, such as en or pt</source>
        <translation>Lequel de plusieurs noms est pris, par exemple en ou fr</translation>
    </message>
    <message>
        <source>Where the map leaves it open: filename, z, or the name of a column</source>
        <translation>Si la carte ne le dit pas&#xa0;: filename, z ou le nom d&apos;une colonne</translation>
    </message>
    <message>
        <source>A file with other names of columns and codes</source>
        <translation>Un fichier avec d&apos;autres noms de colonnes et de codes</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importer</translation>
    </message>
    <message>
        <source>none is needed</source>
        <translation>pas nécessaire</translation>
    </message>
    <message>
        <source>Where the level is</source>
        <translation>Où est le niveau</translation>
    </message>
    <message>
        <source>File of other names</source>
        <translation>Fichier d&apos;autres noms</translation>
    </message>
</context>
<context>
    <name>farol::ui::InstructionPanel</name>
    <message>
        <source>No destination chosen: places are told, no route.</source>
        <translation>Aucune destination choisie&#xa0;: les lieux sont dits, sans itinéraire.</translation>
    </message>
    <message>
        <source>The route follows as soon as it is known where you are.</source>
        <translation>L&apos;itinéraire viendra dès que l&apos;on saura où vous êtes.</translation>
    </message>
    <message>
        <source>There is no way to the destination. %1</source>
        <translation>Il n&apos;y a pas de chemin vers la destination. %1</translation>
    </message>
    <message>
        <source>At the destination.</source>
        <translation>À destination.</translation>
    </message>
    <message>
        <source>On the way to %1</source>
        <translation>En route vers %1</translation>
    </message>
    <message numerus="yes">
        <source>%n more place(s) to pass</source>
        <translation>
            <numerusform>encore %n lieu à traverser</numerusform>
            <numerusform>encore %n lieux à traverser</numerusform>
        </translation>
    </message>
    <message>
        <source>next in %1 m</source>
        <translation>prochaine dans %1 m</translation>
    </message>
    <message>
        <source>%1 m to go</source>
        <translation>encore %1 m</translation>
    </message>
    <message>
        <source>Off the route</source>
        <translation>Hors de l&apos;itinéraire</translation>
    </message>
    <message>
        <source>Next instruction</source>
        <translation>Prochaine instruction</translation>
    </message>
    <message>
        <source>Said at %1</source>
        <translation>Dit à %1</translation>
    </message>
    <message>
        <source>Open a map to begin.</source>
        <translation>Ouvrez une carte pour commencer.</translation>
    </message>
    <message>
        <source>Ready. Press Play to start the walk.</source>
        <translation>Prêt. Appuyez sur Lecture pour commencer le parcours.</translation>
    </message>
    <message>
        <source>Looking around…</source>
        <translation>Je regarde autour…</translation>
    </message>
    <message>
        <source>Next instruction: %1</source>
        <translation>Prochaine instruction&#xa0;: %1</translation>
    </message>
    <message>
        <source>No sound: %1</source>
        <translation>Pas de son&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>farol::ui::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flèches</translation>
    </message>
    <message>
        <source>In the map: move it</source>
        <translation>Sur la carte&#xa0;: la déplacer</translation>
    </message>
    <message>
        <source>In the map: larger, smaller, whole floor</source>
        <translation>Sur la carte&#xa0;: plus grand, plus petit, tout l&apos;étage</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Page préc., Page suiv.</translation>
    </message>
    <message>
        <source>In the map: the floor above, the floor below</source>
        <translation>Sur la carte&#xa0;: l&apos;étage au-dessus, en dessous</translation>
    </message>
    <message>
        <source>Alt + Arrows</source>
        <translation>Alt + flèches</translation>
    </message>
    <message>
        <source>In the plan: move what is chosen by 10 cm, with Shift by 1 m</source>
        <translation>Sur le plan&#xa0;: déplacer la sélection de 10 cm, avec Maj de 1 m</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabulation</translation>
    </message>
    <message>
        <source>The next button or list</source>
        <translation>Le bouton ou la liste suivante</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Touche</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Ce qu&apos;elle fait</translation>
    </message>
</context>
<context>
    <name>farol::ui::Kiosk</name>
    <message>
        <source>No map was given (farol --kiosk --map FILE).</source>
        <translation>Aucun plan n&apos;a été indiqué (farol --kiosk --map FICHIER).</translation>
    </message>
    <message>
        <source>The landmarks cannot be loaded: I will hardly know where you are. Ask for help.</source>
        <translation>Les repères ne peuvent pas être chargés&#xa0;: je ne saurai guère où vous êtes. Demandez de l&apos;aide.</translation>
    </message>
    <message>
        <source>The destination cannot be kept for a restart: the folder cannot be written.</source>
        <translation>La destination ne peut pas être gardée pour un redémarrage&#xa0;: le dossier n&apos;est pas accessible en écriture.</translation>
    </message>
    <message>
        <source>The chosen voice does not work. This is another one.</source>
        <translation>La voix choisie ne fonctionne pas. En voici une autre.</translation>
    </message>
    <message>
        <source>The map has been changed. The new one is used after this way.</source>
        <translation>Le plan a été modifié. Le nouveau sert après ce trajet.</translation>
    </message>
    <message>
        <source>The file of the map is gone. I keep the map that I have.</source>
        <translation>Le fichier du plan a disparu. Je garde le plan que j’ai.</translation>
    </message>
    <message>
        <source>The new map cannot be opened. I keep the old one.</source>
        <translation>Le nouveau plan ne peut pas être ouvert. Je garde l&apos;ancien.</translation>
    </message>
    <message>
        <source>Another Farol kiosk of this user is running.</source>
        <translation>Un autre Farol de cet utilisateur est en marche.</translation>
    </message>
    <message>
        <source>Farol is already running here. I close this one. Goodbye.</source>
        <translation>Farol est déjà en marche ici. Je ferme celui-ci. Au revoir.</translation>
    </message>
    <message>
        <source>The map has been changed, and I use the new one.</source>
        <translation>Le plan a été modifié, et j’utilise le nouveau.</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskMachine</name>
    <message>
        <source>One moment.</source>
        <translation>Un instant.</translation>
    </message>
    <message>
        <source>Farol. I am opening the map.</source>
        <translation>Farol. J&apos;ouvre le plan.</translation>
    </message>
    <message>
        <source>The new map cannot be opened. I keep the old one.</source>
        <translation>Le nouveau plan ne peut pas être ouvert. Je garde l&apos;ancien.</translation>
    </message>
    <message>
        <source>Farol was interrupted and has started again.</source>
        <translation>Farol s&apos;est interrompu et a redémarré.</translation>
    </message>
    <message>
        <source>You were last here: %1.</source>
        <translation>Votre dernière position était&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The camera works again.</source>
        <translation>La caméra fonctionne de nouveau.</translation>
    </message>
    <message>
        <source>Stop, and turn slowly to the right, so that I can look around.</source>
        <translation>Arrêtez-vous et tournez-vous lentement vers la droite, pour que je puisse regarder autour de vous.</translation>
    </message>
    <message>
        <source>No destination is chosen yet. Choose one first.</source>
        <translation>Aucune destination n&apos;est encore choisie. Choisissez-en une d&apos;abord.</translation>
    </message>
    <message>
        <source>This is the first place.</source>
        <translation>C&apos;est le premier lieu.</translation>
    </message>
    <message>
        <source>This is the last place.</source>
        <translation>C&apos;est le dernier lieu.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s). %2.</source>
        <extracomment>%1 &quot;Rooms&quot;, %2 the first of them</extracomment>
        <translation>
            <numerusform>%1&#xa0;: un lieu. %2.</numerusform>
            <numerusform>%1&#xa0;: %n lieux. %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Type part of a name or a number, then press Enter.</source>
        <translation>Tapez une partie d&apos;un nom ou d&apos;un numéro, puis appuyez sur Entrée.</translation>
    </message>
    <message>
        <source>space</source>
        <translation>espace</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s).</source>
        <comment>while typing</comment>
        <extracomment>%1 the letter just typed</extracomment>
        <translation>
            <numerusform>%1&#xa0;: un lieu.</numerusform>
            <numerusform>%1&#xa0;: %n lieux.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is typed.</source>
        <translation>Rien n&apos;est tapé.</translation>
    </message>
    <message>
        <source>Deleted: %1. %2</source>
        <translation>Effacé&#xa0;: %1. %2</translation>
    </message>
    <message>
        <source>%1 %2. Enter: go there. Arrow down: next.</source>
        <translation>%1 %2. Entrée&#xa0;: y aller. Flèche bas&#xa0;: suivant.</translation>
    </message>
    <message>
        <source>Nothing is chosen yet. Press arrow down to hear the places.</source>
        <translation>Rien n&apos;est encore choisi. Appuyez sur flèche bas pour entendre les lieux.</translation>
    </message>
    <message>
        <source>I try the camera again.</source>
        <translation>J&apos;essaie de nouveau la caméra.</translation>
    </message>
    <message>
        <source>Going on. %1</source>
        <translation>Je continue. %1</translation>
    </message>
    <message>
        <source>This key does nothing. Escape: back.</source>
        <translation>Cette touche ne fait rien. Échap&#xa0;: retour.</translation>
    </message>
    <message>
        <source>Back to the kinds of places.</source>
        <translation>Retour aux types de lieux.</translation>
    </message>
    <message>
        <source>Leave Farol.</source>
        <translation>Quitter Farol.</translation>
    </message>
    <message>
        <source>Start.</source>
        <translation>Commencer.</translation>
    </message>
    <message>
        <source>Hear the whole way.</source>
        <translation>Entendre tout le chemin.</translation>
    </message>
    <message>
        <source>Another place.</source>
        <translation>Un autre lieu.</translation>
    </message>
    <message>
        <source>Try the camera again.</source>
        <translation>Réessayer la caméra.</translation>
    </message>
    <message>
        <source>Stop the guidance.</source>
        <translation>Arrêter le guidage.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Choisir un autre lieu.</translation>
    </message>
    <message>
        <source>Yes, stop.</source>
        <translation>Oui, arrêter.</translation>
    </message>
    <message>
        <source>No, go on.</source>
        <translation>Non, continuer.</translation>
    </message>
    <message>
        <source>Yes, leave.</source>
        <translation>Oui, quitter.</translation>
    </message>
    <message>
        <source>No, stay.</source>
        <translation>Non, rester.</translation>
    </message>
    <message>
        <source>Press space to hear what there is, then Enter.</source>
        <translation>Appuyez sur espace pour entendre les choix, puis sur Entrée.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s). Space: first place.</source>
        <translation>
            <numerusform>%1&#xa0;: un lieu. Espace&#xa0;: premier lieu.</numerusform>
            <numerusform>%1&#xa0;: %n lieux. Espace&#xa0;: premier lieu.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. %2 of %3.</source>
        <extracomment>%1 a place, then which of how many</extracomment>
        <translation>%1. %2 sur %3.</translation>
    </message>
    <message numerus="yes">
        <source>Choose a destination: %n place(s).</source>
        <translation>
            <numerusform>Choisissez une destination&#xa0;: un lieu.</numerusform>
            <numerusform>Choisissez une destination&#xa0;: %n lieux.</numerusform>
        </translation>
    </message>
    <message>
        <source>Space: next. Enter: take it.</source>
        <translation>Espace&#xa0;: suivant. Entrée&#xa0;: choisir.</translation>
    </message>
    <message>
        <source>Arrow down: first place. F: type a name. F1: all keys.</source>
        <translation>Flèche bas&#xa0;: premier lieu. F&#xa0;: taper un nom. F1&#xa0;: toutes les touches.</translation>
    </message>
    <message>
        <source>To: %1.</source>
        <translation>Destination&#xa0;: %1.</translation>
    </message>
    <message>
        <source>I do not know yet where you are, and look for it on the way.</source>
        <translation>Je ne sais pas encore où vous êtes&#xa0;; je le chercherai en chemin.</translation>
    </message>
    <message>
        <source>Space: choices.</source>
        <translation>Espace&#xa0;: choix.</translation>
    </message>
    <message>
        <source>Enter: start. L: the whole way. Escape: another place.</source>
        <translation>Entrée&#xa0;: commencer. L&#xa0;: tout le chemin. Échap&#xa0;: un autre lieu.</translation>
    </message>
    <message>
        <source>Stop the guidance?</source>
        <translation>Arrêter le guidage&#xa0;?</translation>
    </message>
    <message>
        <source>Leave Farol?</source>
        <translation>Quitter Farol&#xa0;?</translation>
    </message>
    <message>
        <source>Enter or Escape: yes. Any other key: no.</source>
        <translation>Entrée ou Échap&#xa0;: oui. Toute autre touche&#xa0;: non.</translation>
    </message>
    <message>
        <source>No camera is set up, and I cannot guide you. Ask for help.</source>
        <translation>Aucune caméra n&apos;est réglée, et je ne peux pas vous guider. Demandez de l&apos;aide.</translation>
    </message>
    <message>
        <source>The camera is starting.</source>
        <translation>La caméra démarre.</translation>
    </message>
    <message>
        <source>Stop. The camera gives no pictures, and I cannot guide you. Enter: try again.</source>
        <translation>Arrêtez-vous. La caméra ne donne pas d&apos;images, et je ne peux pas vous guider. Entrée&#xa0;: réessayer.</translation>
    </message>
    <message>
        <source>The camera gives no pictures. I try it again when you start.</source>
        <translation>La caméra ne donne pas d&apos;images. Je réessaierai quand vous commencerez.</translation>
    </message>
    <message>
        <source>No place fits: %1. Delete letters, or press Escape.</source>
        <translation>Aucun lieu ne correspond&#xa0;: %1. Effacez des lettres ou appuyez sur Échap.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) fit: %1.</source>
        <translation>
            <numerusform>Un lieu correspond&#xa0;: %1.</numerusform>
            <numerusform>%n lieux correspondent&#xa0;: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>This map has no places to go to. Ask for help.</source>
        <translation>Ce plan ne contient aucun lieu où aller. Demandez de l&apos;aide.</translation>
    </message>
    <message>
        <source>The map cannot be opened. Ask for help.</source>
        <translation>Le plan ne peut pas être ouvert. Demandez de l&apos;aide.</translation>
    </message>
    <message>
        <source>The map is being opened. Please wait.</source>
        <translation>Le plan est en cours d&apos;ouverture. Veuillez patienter.</translation>
    </message>
    <message>
        <source>On the way to: %1.</source>
        <translation>En route vers&#xa0;: %1.</translation>
    </message>
    <message>
        <source>You have arrived: %1. Enter: another destination.</source>
        <translation>Vous êtes à destination&#xa0;: %1. Entrée&#xa0;: une autre destination.</translation>
    </message>
    <message>
        <source>You have probably arrived: %1. Enter: another destination.</source>
        <translation>Vous êtes probablement à destination&#xa0;: %1. Entrée&#xa0;: une autre destination.</translation>
    </message>
    <message>
        <source>Goodbye.</source>
        <translation>Au revoir.</translation>
    </message>
    <message>
        <source>Quiet: I tell only warnings and what you ask. M: speak again.</source>
        <translation>Silence&#xa0;: je ne dis que les alertes et ce que vous demandez. M&#xa0;: parler de nouveau.</translation>
    </message>
    <message>
        <source>I tell everything again.</source>
        <translation>Je dis de nouveau tout.</translation>
    </message>
    <message>
        <source>Speed %1 of %2.</source>
        <translation>Vitesse %1 sur %2.</translation>
    </message>
    <message>
        <source>I speak English now.</source>
        <translation>Je parle français maintenant.</translation>
    </message>
    <message>
        <source>Two keys: space goes through the choices, Enter takes one. F4: all keys again.</source>
        <translation>Deux touches&#xa0;: espace parcourt les choix, Entrée en prend un. F4&#xa0;: de nouveau toutes les touches.</translation>
    </message>
    <message>
        <source>All keys are in use again.</source>
        <translation>Toutes les touches servent de nouveau.</translation>
    </message>
    <message>
        <source>Farol</source>
        <translation>Farol</translation>
    </message>
    <message>
        <source>Where to? %1</source>
        <translation>Où aller&#xa0;? %1</translation>
    </message>
    <message>
        <source>Search: %1</source>
        <translation>Recherche&#xa0;: %1</translation>
    </message>
    <message>
        <source>The way to %1</source>
        <translation>Chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Walking to %1</source>
        <translation>En route&#xa0;: %1</translation>
    </message>
    <message>
        <source>Arrived</source>
        <translation>À destination</translation>
    </message>
    <message>
        <source>Probably arrived</source>
        <translation>Probablement à destination</translation>
    </message>
    <message>
        <source>Stop?</source>
        <translation>Arrêter&#xa0;?</translation>
    </message>
    <message>
        <source>Leave?</source>
        <translation>Quitter&#xa0;?</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Goodbye</source>
        <translation>Au revoir</translation>
    </message>
    <message>
        <source>Space: next   Enter: take   F4: all keys</source>
        <translation>Espace&#xa0;: suivant   Entrée&#xa0;: choisir   F4&#xa0;: touches</translation>
    </message>
    <message>
        <source>Arrows: places   Enter: go   F: search   F1: keys</source>
        <translation>Flèches&#xa0;: lieux   Entrée&#xa0;: aller   F&#xa0;: chercher   F1&#xa0;: touches</translation>
    </message>
    <message>
        <source>Enter: done   Esc: back</source>
        <translation>Entrée&#xa0;: terminé   Échap&#xa0;: retour</translation>
    </message>
    <message>
        <source>Enter: start   L: whole way   Esc: back</source>
        <translation>Entrée&#xa0;: commencer   L&#xa0;: tout   Échap&#xa0;: retour</translation>
    </message>
    <message>
        <source>Space: again   W: where am I   Esc: stop</source>
        <translation>Espace&#xa0;: répéter   W&#xa0;: où suis-je   Échap&#xa0;: arrêter</translation>
    </message>
    <message>
        <source>Enter: another destination</source>
        <translation>Entrée&#xa0;: une autre destination</translation>
    </message>
    <message>
        <source>Enter: yes   any other key: no</source>
        <translation>Entrée&#xa0;: oui   autre touche&#xa0;: non</translation>
    </message>
    <message>
        <source>Esc: back   F1: number pad</source>
        <translation>Échap&#xa0;: retour   F1&#xa0;: pavé numérique</translation>
    </message>
    <message>
        <source>Esc: leave   F1: keys</source>
        <translation>Échap&#xa0;: quitter   F1&#xa0;: touches</translation>
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
        <translation>Farol, guidage</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskPlaces</name>
    <message>
        <source>All places</source>
        <translation>Tous les lieux</translation>
    </message>
    <message>
        <source>Rooms</source>
        <translation>Salles</translation>
    </message>
    <message>
        <source>Toilets</source>
        <translation>Toilettes</translation>
    </message>
    <message>
        <source>Halls</source>
        <translation>Halls</translation>
    </message>
    <message>
        <source>Corridors</source>
        <translation>Couloirs</translation>
    </message>
    <message>
        <source>Lifts</source>
        <translation>Ascenseurs</translation>
    </message>
    <message>
        <source>Stairs</source>
        <translation>Escaliers</translation>
    </message>
    <message>
        <source>Ways out</source>
        <translation>Sorties</translation>
    </message>
    <message>
        <source>Other places</source>
        <translation>Autres lieux</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskWords</name>
    <message>
        <source>Arrow up</source>
        <translation>Flèche haut</translation>
    </message>
    <message>
        <source>Arrow down</source>
        <translation>Flèche bas</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Touche fin</translation>
    </message>
    <message>
        <source>Arrow left</source>
        <translation>Flèche gauche</translation>
    </message>
    <message>
        <source>Arrow right</source>
        <translation>Flèche droite</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Touche plus</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>Touche moins</translation>
    </message>
    <message>
        <source>the place before</source>
        <translation>le lieu précédent</translation>
    </message>
    <message>
        <source>the next place</source>
        <translation>le lieu suivant</translation>
    </message>
    <message>
        <source>the first place</source>
        <translation>le premier lieu</translation>
    </message>
    <message>
        <source>the last place</source>
        <translation>le dernier lieu</translation>
    </message>
    <message>
        <source>another kind of places, back</source>
        <translation>un autre type de lieux, en arrière</translation>
    </message>
    <message>
        <source>another kind of places, on</source>
        <translation>un autre type de lieux, en avant</translation>
    </message>
    <message>
        <source>choose, start</source>
        <translation>choisir, commencer</translation>
    </message>
    <message>
        <source>back; hold it down to leave</source>
        <translation>retour&#xa0;; maintenez-la appuyée pour quitter</translation>
    </message>
    <message>
        <source>say again</source>
        <translation>répéter</translation>
    </message>
    <message>
        <source>where am I</source>
        <translation>où suis-je</translation>
    </message>
    <message>
        <source>what is around me</source>
        <translation>qu&apos;y a-t-il autour de moi</translation>
    </message>
    <message>
        <source>what comes next</source>
        <translation>qu&apos;est-ce qui vient ensuite</translation>
    </message>
    <message>
        <source>the whole way</source>
        <translation>tout le chemin</translation>
    </message>
    <message>
        <source>look around</source>
        <translation>regarder autour</translation>
    </message>
    <message>
        <source>quiet, or speak again</source>
        <translation>silence, ou parler de nouveau</translation>
    </message>
    <message>
        <source>speak faster</source>
        <translation>parler plus vite</translation>
    </message>
    <message>
        <source>speak slower</source>
        <translation>parler plus lentement</translation>
    </message>
    <message>
        <source>how much I tell</source>
        <translation>combien j&apos;en dis</translation>
    </message>
    <message>
        <source>how I tell directions</source>
        <translation>comment je dis les directions</translation>
    </message>
    <message>
        <source>metres, feet or steps</source>
        <translation>mètres, pieds ou pas</translation>
    </message>
    <message>
        <source>search a place by typing</source>
        <translation>chercher un lieu en tapant</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>les touches</translation>
    </message>
    <message>
        <source>everything with two keys</source>
        <translation>tout avec deux touches</translation>
    </message>
    <message>
        <source>Keys. Press one to hear what it does; F1: number pad; Escape: back.</source>
        <translation>Touches. Appuyez sur l&apos;une pour entendre ce qu&apos;elle fait&#xa0;; F1&#xa0;: pavé numérique&#xa0;; Échap&#xa0;: retour.</translation>
    </message>
    <message>
        <source>Number pad. 8 and 2: up and down. 4 and 6: left and right. 5 or Enter: choose. 0: say again. 1: where am I. 3: around me. 7: what comes next. 9: the whole way. Plus and minus: speed. Star: keys. Slash: quiet. Point: back.</source>
        <translation>Pavé numérique. 8 et 2&#xa0;: haut et bas. 4 et 6&#xa0;: gauche et droite. 5 ou Entrée&#xa0;: choisir. 0&#xa0;: répéter. 1&#xa0;: où suis-je. 3&#xa0;: autour de moi. 7&#xa0;: ce qui vient ensuite. 9&#xa0;: tout le chemin. Plus et moins&#xa0;: vitesse. Étoile&#xa0;: touches. Barre oblique&#xa0;: silence. Point&#xa0;: retour.</translation>
    </message>
    <message>
        <source>This key does nothing here. F1: all keys.</source>
        <translation>Cette touche ne fait rien ici. F1&#xa0;: toutes les touches.</translation>
    </message>
    <message>
        <source>I tell directions only.</source>
        <translation>Je dis seulement les directions.</translation>
    </message>
    <message>
        <source>I tell directions and objects.</source>
        <translation>Je dis les directions et les objets.</translation>
    </message>
    <message>
        <source>I tell directions, objects and texts.</source>
        <translation>Je dis les directions, les objets et les textes.</translation>
    </message>
    <message>
        <source>Directions as left and right.</source>
        <translation>Directions&#xa0;: gauche et droite.</translation>
    </message>
    <message>
        <source>Directions as on a clock.</source>
        <translation>Directions comme sur une horloge.</translation>
    </message>
    <message>
        <source>Directions in degrees.</source>
        <translation>Directions en degrés.</translation>
    </message>
    <message>
        <source>Distances in metres.</source>
        <translation>Distances en mètres.</translation>
    </message>
    <message>
        <source>Distances in feet.</source>
        <translation>Distances en pieds.</translation>
    </message>
    <message>
        <source>Distances in steps.</source>
        <translation>Distances en pas.</translation>
    </message>
    <message>
        <source>another language</source>
        <translation>une autre langue</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <extracomment>%1 a key, %2 what it does</extracomment>
        <translation>%1&#xa0;: %2.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LandmarkDialog</name>
    <message>
        <source>Landmark %1</source>
        <translation>Repère %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Ce que c&apos;est</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>What can be read on it</source>
        <translation>Ce qu&apos;on peut y lire</translation>
    </message>
    <message>
        <source>Trained as</source>
        <translation>Appris comme</translation>
    </message>
    <message>
        <source>The name under which its appearance was trained</source>
        <translation>Le nom sous lequel son apparence a été apprise</translation>
    </message>
    <message>
        <source>any</source>
        <translation>quelconque</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Orientation</translation>
    </message>
    <message>
        <source>The way it faces: 0 is east, 90 north, 180 west, 270 south</source>
        <translation>Vers où il est tourné&#xa0;: 0 est, 90 nord, 180 ouest, 270 sud</translation>
    </message>
    <message>
        <source>Height above the floor</source>
        <translation>Hauteur au-dessus du sol</translation>
    </message>
    <message>
        <source>Of its middle</source>
        <translation>De son milieu</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>How wide it is: its distance is told from that</source>
        <translation>Sa largeur&#xa0;: sa distance en est déduite</translation>
    </message>
    <message>
        <source>Its own height</source>
        <translation>Sa propre hauteur</translation>
    </message>
    <message>
        <source>How tall it is</source>
        <translation>Quelle est sa hauteur</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Est</translation>
    </message>
    <message>
        <source>Place on the map, metres to the east</source>
        <translation>Emplacement sur la carte, mètres vers l&apos;est</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>Place on the map, metres to the north</source>
        <translation>Emplacement sur la carte, mètres vers le nord</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryDocument</name>
    <message>
        <source>The library was changed meanwhile; try again.</source>
        <translation>La bibliothèque a changé entre-temps&#xa0;; réessayez.</translation>
    </message>
    <message>
        <source>another program is writing this library; try again</source>
        <translation>un autre programme écrit dans cette bibliothèque&#xa0;; réessayez</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryModel</name>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
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
        <translation>non vérifié</translation>
    </message>
    <message>
        <source>In maps called “%1”</source>
        <translation>Appelé «&#xa0;%1&#xa0;» dans les cartes</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Real size</source>
        <translation>Taille réelle</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>How well it is found</source>
        <translation>S&apos;il est bien trouvé</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryPanel</name>
    <message>
        <source>Nothing is chosen</source>
        <translation>Rien n&apos;est choisi</translation>
    </message>
    <message>
        <source>Not checked yet. “Check all” looks how well each landmark is found.</source>
        <translation>Pas encore vérifié. «&#xa0;Tout vérifier&#xa0;» regarde si chaque repère est bien trouvé.</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vue %1</translation>
    </message>
    <message>
        <source>Each view is held back once and looked for with the others; then each landmark is shown smaller and turned.</source>
        <translation>Chaque vue est mise de côté une fois et cherchée avec les autres&#xa0;; ensuite chaque repère est montré plus petit et tourné.</translation>
    </message>
    <message>
        <source>Not checked yet. “Check all” looks how well each landmark is found, and which are taken for each other.</source>
        <translation>Pas encore vérifié. «&#xa0;Tout vérifier&#xa0;» regarde si chaque repère est bien trouvé et lesquels sont confondus.</translation>
    </message>
    <message>
        <source>All landmarks are found well.</source>
        <translation>Tous les repères sont bien trouvés.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s) need care.</source>
        <translation>
            <numerusform>%n repère demande de l&apos;attention.</numerusform>
            <numerusform>%n repères demandent de l&apos;attention.</numerusform>
        </translation>
    </message>
    <message>
        <source>None is taken for another.</source>
        <translation>Aucun n&apos;est pris pour un autre.</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) are taken for each other.</source>
        <translation>
            <numerusform>%n paire est confondue.</numerusform>
            <numerusform>%n paires sont confondues.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rows: whose picture was shown. Columns: what was seen in it. On the diagonal: views found again.</source>
        <translation>Lignes&#xa0;: de qui venait l&apos;image montrée. Colonnes&#xa0;: ce qui y a été vu. Sur la diagonale&#xa0;: vues retrouvées.</translation>
    </message>
    <message>
        <source>The library was changed since: check again.</source>
        <translation>La bibliothèque a changé depuis&#xa0;: vérifiez-la de nouveau.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>%n repère</numerusform>
            <numerusform>%n repères</numerusform>
        </translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>This library is empty. “Teach” begins with the first landmark.</source>
        <translation>Cette bibliothèque est vide. «&#xa0;Apprendre&#xa0;» commence par le premier repère.</translation>
    </message>
    <message>
        <source>Open a landmark library, or make a new one, to teach Farol what it shall know again.</source>
        <translation>Ouvrez une bibliothèque de repères, ou créez-en une, pour apprendre à Farol ce qu&apos;il doit reconnaître.</translation>
    </message>
    <message>
        <source>Landmarks of the library</source>
        <translation>Repères de la bibliothèque</translation>
    </message>
    <message>
        <source>The landmarks that Farol was taught; press Enter to add views to one</source>
        <translation>Les repères appris à Farol&#xa0;; appuyez sur Entrée pour ajouter des vues à l&apos;un d&apos;eux</translation>
    </message>
    <message>
        <source>Views of the landmark</source>
        <translation>Vues du repère</translation>
    </message>
    <message>
        <source>The photographs it is learnt from; choose some of them to split or to delete them</source>
        <translation>Les photographies dont il est appris&#xa0;; choisissez-en pour les séparer ou les supprimer</translation>
    </message>
    <message>
        <source>&amp;Views:</source>
        <translation>&amp;Vues&#xa0;:</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>C&amp;heck all</source>
        <translation>Tout vérif&amp;ier</translation>
    </message>
    <message>
        <source>Check all landmarks</source>
        <translation>Vérifier tous les repères</translation>
    </message>
    <message>
        <source>Look how well each landmark is found and which are taken for each other</source>
        <translation>Regarder si chaque repère est bien trouvé et lesquels sont confondus</translation>
    </message>
    <message>
        <source>Save as CS&amp;V…</source>
        <translation>Enregistrer en &amp;CSV…</translation>
    </message>
    <message>
        <source>Save the report as CSV</source>
        <translation>Enregistrer le rapport en CSV</translation>
    </message>
    <message>
        <source>Save the report for a spreadsheet</source>
        <translation>Enregistrer le rapport pour un tableur</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Avancement de la vérification</translation>
    </message>
    <message>
        <source>Who is taken for whom</source>
        <translation>Qui est pris pour qui</translation>
    </message>
    <message>
        <source>Rows: whose picture was shown. Columns: what was seen in it.</source>
        <translation>Lignes&#xa0;: de qui venait l&apos;image montrée. Colonnes&#xa0;: ce qui y a été vu.</translation>
    </message>
    <message>
        <source>All that have several views are found well.</source>
        <translation>Tous ceux qui ont plusieurs vues se retrouvent bien.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s) cannot be tried: there is only one view. Add another.</source>
        <translation>
            <numerusform>%n repère ne peut pas être essayé&#xa0;: il n&apos;a qu&apos;une vue. Ajoutez-en une.</numerusform>
            <numerusform>%n repères ne peuvent pas être essayés&#xa0;: ils n&apos;ont qu&apos;une vue. Ajoutez-en une.</numerusform>
        </translation>
    </message>
    <message>
        <source>The photographs of the chosen landmark are shown here.</source>
        <translation>Les photographies du repère choisi s&apos;affichent ici.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LivePage</name>
    <message>
        <source>What was said</source>
        <translation>Ce qui a été dit</translation>
    </message>
    <message>
        <source>Where it could be</source>
        <translation>Où cela pourrait être</translation>
    </message>
    <message>
        <source>Every sentence, when it was due, and what became of it</source>
        <translation>Chaque phrase, quand elle était due et ce qu&apos;elle est devenue</translation>
    </message>
    <message>
        <source>The places that fit what was seen, best first</source>
        <translation>Les lieux qui correspondent à ce qui a été vu, le meilleur d&apos;abord</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Vu en dernier</translation>
    </message>
    <message>
        <source>The last objects that the place is worked out from</source>
        <translation>Les derniers objets dont le lieu est déduit</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>Dans l&apos;image</translation>
    </message>
    <message>
        <source>Everything recognised in the picture shown</source>
        <translation>Tout ce qui est reconnu dans l&apos;image montrée</translation>
    </message>
    <message>
        <source>On this floor</source>
        <translation>À cet étage</translation>
    </message>
    <message>
        <source>The map as a list; press Enter on a place to go there</source>
        <translation>La carte sous forme de liste&#xa0;; appuyez sur Entrée sur un lieu pour y aller</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>Listes</translation>
    </message>
    <message>
        <source>Why there</source>
        <translation>Pourquoi là</translation>
    </message>
    <message>
        <source>What the vote of the chosen place is made of, and what speaks for it</source>
        <translation>De quoi se compose le vote du lieu choisi, et ce qui parle pour lui</translation>
    </message>
    <message>
        <source>Nothing has been said yet.</source>
        <translation>Rien n&apos;a encore été dit.</translation>
    </message>
    <message>
        <source>Nothing has been worked out yet.</source>
        <translation>Rien n&apos;a encore été calculé.</translation>
    </message>
    <message>
        <source>As soon as there is a place, what speaks for it stands here.</source>
        <translation>Dès qu&apos;il y a un lieu, ce qui parle pour lui se trouve ici.</translation>
    </message>
    <message>
        <source>Nothing has been recognised yet.</source>
        <translation>Rien n&apos;a encore été reconnu.</translation>
    </message>
    <message>
        <source>Nothing is recognised in the picture.</source>
        <translation>Rien n&apos;est reconnu dans l&apos;image.</translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>Aucune carte n&apos;est ouverte.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LocaliserMenu</name>
    <message>
        <source>&amp;How the place is worked out</source>
        <translation>Comment le lieu est tr&amp;ouvé</translation>
    </message>
    <message>
        <source>Filter, for people who are &amp;guided</source>
        <translation>Filtre, pour personnes &amp;guidées</translation>
    </message>
    <message>
        <source>Filter, for people who &amp;know their way</source>
        <translation>Filtre, pour qui &amp;connaît le chemin</translation>
    </message>
    <message>
        <source>&amp;Voting</source>
        <translation>&amp;Vote</translation>
    </message>
    <message>
        <source>Voting as first &amp;printed</source>
        <translation>Vote, comme d&apos;abord &amp;publié</translation>
    </message>
    <message>
        <source>From the next start of a walk</source>
        <translation>Dès le prochain départ d&apos;un parcours</translation>
    </message>
</context>
<context>
    <name>farol::ui::MainWindow</name>
    <message>
        <source>About Farol</source>
        <translation>À propos de Farol</translation>
    </message>
    <message>
        <source>Farol %1

Guides a blind person through a building with one ordinary camera: it recognises what it was taught, works out the place, and speaks the way.</source>
        <translation>Farol %1

Guide une personne aveugle dans un bâtiment avec une simple caméra&#xa0;: il reconnaît ce qu&apos;on lui a appris, trouve le lieu et dit le chemin.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Walking</source>
        <translation>En parcours</translation>
    </message>
    <message>
        <source>The walk has ended</source>
        <translation>Le parcours est terminé</translation>
    </message>
    <message>
        <source>The walk could not go on</source>
        <translation>Le parcours n&apos;a pas pu continuer</translation>
    </message>
    <message>
        <source>Loading…</source>
        <translation>Chargement…</translation>
    </message>
    <message>
        <source>recorded in %1</source>
        <translation>enregistré dans %1</translation>
    </message>
    <message>
        <source>The walk has ended: there are no more pictures.</source>
        <translation>Le parcours est terminé&#xa0;: il n&apos;y a plus d&apos;images.</translation>
    </message>
    <message>
        <source>Play &amp;again</source>
        <translation>Re&amp;lire</translation>
    </message>
    <message>
        <source>Open another &amp;map…</source>
        <translation>Ouvrir une autre &amp;carte…</translation>
    </message>
    <message>
        <source>Open another &amp;library…</source>
        <translation>Ouvrir une autre &amp;bibliothèque…</translation>
    </message>
    <message>
        <source>Open other &amp;pictures…</source>
        <translation>Ouvrir d&apos;autres &amp;images…</translation>
    </message>
    <message>
        <source>The walk will be recorded from its next start.</source>
        <translation>Le parcours sera enregistré à partir de son prochain départ.</translation>
    </message>
    <message>
        <source>This walk is recorded to its end; the next one is not.</source>
        <translation>Ce parcours est enregistré jusqu&apos;à sa fin&#xa0;; le suivant ne l&apos;est pas.</translation>
    </message>
    <message>
        <source>Start &amp;again now</source>
        <translation>Recommencer &amp;maintenant</translation>
    </message>
    <message>
        <source>Open a map</source>
        <translation>Ouvrir une carte</translation>
    </message>
    <message>
        <source>Maps (%1);;All files (%2)</source>
        <translation>Cartes (%1);;Tous les fichiers (%2)</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Ouvrir une bibliothèque de repères</translation>
    </message>
    <message>
        <source>Landmark libraries (%1);;All files (%2)</source>
        <translation>Bibliothèques de repères (%1);;Tous les fichiers (%2)</translation>
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
        <translation>Parcours</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>State of the walk</source>
        <translation>État du parcours</translation>
    </message>
    <message>
        <source>Something is being loaded</source>
        <translation>Un chargement est en cours</translation>
    </message>
    <message>
        <source>&amp;Next visitor now</source>
        <translation>Visiteur &amp;suivant maintenant</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>Watch a walk, work on a map, or teach landmarks (Ctrl+1 to Ctrl+3)</source>
        <translation>Suivre un parcours, travailler sur une carte ou apprendre des repères (Ctrl+1 à Ctrl+3)</translation>
    </message>
    <message>
        <source>The landmark library was changed on the Landmarks page.</source>
        <translation>La bibliothèque de repères a changé sur la page Repères.</translation>
    </message>
    <message>
        <source>Start &amp;again with it</source>
        <translation>&amp;Recommencer avec elle</translation>
    </message>
    <message>
        <source>Changes are not saved</source>
        <translation>Les modifications ne sont pas enregistrées</translation>
    </message>
    <message>
        <source>The landmark library could not be written; its last changes would be lost.</source>
        <translation>La bibliothèque de repères n&apos;a pas pu être écrite&#xa0;; ses dernières modifications seraient perdues.</translation>
    </message>
    <message>
        <source>&amp;Leave all the same</source>
        <translation>&amp;Quitter quand même</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>&amp;Rester</translation>
    </message>
    <message>
        <source>Saved in %1</source>
        <translation>Enregistré dans %1</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 ne peut pas être écrit. Choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>There is no walk to correct.</source>
        <translation>Il n&apos;y a pas de parcours à corriger.</translation>
    </message>
    <message>
        <source>Choose a place on the map, or in the list “Where it could be”, first.</source>
        <translation>Choisissez d&apos;abord un lieu sur la carte, ou dans la liste «&#xa0;Où cela pourrait être&#xa0;».</translation>
    </message>
    <message>
        <source>The user is in %1: told by you.</source>
        <translation>L&apos;utilisateur est ici&#xa0;: %1&#xa0;: dit par vous.</translation>
    </message>
    <message>
        <source>The place is given up and looked for anew.</source>
        <translation>Le lieu est abandonné et cherché de nouveau.</translation>
    </message>
    <message>
        <source>Say this</source>
        <translation>Dire ceci</translation>
    </message>
    <message>
        <source>Sentence that is spoken to the user:</source>
        <translation>Phrase dite à l&apos;utilisateur&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Say it</source>
        <translation>&amp;La dire</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Images (%1)</translation>
    </message>
    <message>
        <source>Save the walk as table</source>
        <translation>Enregistrer le parcours en tableau</translation>
    </message>
    <message>
        <source>Tables (%1)</source>
        <translation>Tableaux (%1)</translation>
    </message>
    <message>
        <source>Open as &amp;map</source>
        <translation>Ouvrir comme &amp;carte</translation>
    </message>
    <message>
        <source>Open as landmark &amp;library</source>
        <translation>Ouvrir comme &amp;bibliothèque de repères</translation>
    </message>
    <message>
        <source>The file of this map was changed.</source>
        <translation>Le fichier de ce plan a changé.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>&amp;Le charger à nouveau</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapActions</name>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Carte</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>&amp;Ouvrir une carte…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open the map of a building to look at it and change it</source>
        <translation>Ouvrir la carte d&apos;un bâtiment pour la voir et la modifier</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Bring in a map of another kind</source>
        <translation>Reprendre une carte d&apos;un autre type</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Write the changes into the map&apos;s file</source>
        <translation>Écrire les modifications dans le fichier de la carte</translation>
    </message>
    <message>
        <source>S&amp;ave as…</source>
        <translation>E&amp;nregistrer sous…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Write the map into another file</source>
        <translation>Écrire la carte dans un autre fichier</translation>
    </message>
    <message>
        <source>&amp;Print as PDF…</source>
        <translation>Im&amp;primer en PDF…</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Write the plan of each level as a page of a PDF</source>
        <translation>Écrire le plan de chaque niveau comme page d&apos;un PDF</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Revenir sur la dernière modification</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Make the change again that was taken back</source>
        <translation>Refaire la modification annulée</translation>
    </message>
    <message>
        <source>Add &amp;landmark</source>
        <translation>Ajouter &amp;un repère</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Put a new landmark on the plan</source>
        <translation>Placer un nouveau repère sur le plan</translation>
    </message>
    <message>
        <source>Add &amp;door or passage</source>
        <translation>Ajouter une por&amp;te ou un passage</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Porte</translation>
    </message>
    <message>
        <source>Put a new door or passage on the plan</source>
        <translation>Placer une nouvelle porte ou un nouveau passage sur le plan</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>&amp;Modifier…</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Modifier</translation>
    </message>
    <message>
        <source>Change name, kind and the like of what is chosen</source>
        <translation>Modifier nom, type et autres de la sélection</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Take the chosen landmark, door or passage off the map</source>
        <translation>Retirer de la carte le repère, la porte ou le passage choisi</translation>
    </message>
    <message>
        <source>Route &amp;from here</source>
        <translation>Itinéraire &amp;d&apos;ici</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>D&apos;ici</translation>
    </message>
    <message>
        <source>Let the route begin in the chosen place</source>
        <translation>Faire commencer l&apos;itinéraire au lieu choisi</translation>
    </message>
    <message>
        <source>Route &amp;to here</source>
        <translation>Itinéraire &amp;jusqu&apos;ici</translation>
    </message>
    <message>
        <source>To here</source>
        <translation>Jusqu&apos;ici</translation>
    </message>
    <message>
        <source>Let the route end in the chosen place</source>
        <translation>Faire finir l&apos;itinéraire au lieu choisi</translation>
    </message>
    <message>
        <source>Sea&amp;rch the table</source>
        <translation>C&amp;hercher dans le tableau</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>Search the table of attributes</source>
        <translation>Chercher dans le tableau des attributs</translation>
    </message>
    <message>
        <source>C&amp;heck the map</source>
        <translation>&amp;Vérifier la carte</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Look for what is wrong with the map as it is now</source>
        <translation>Chercher ce qui ne va pas dans la carte telle qu&apos;elle est</translation>
    </message>
    <message>
        <source>&amp;Next feature</source>
        <translation>É&amp;lément suivant</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Show the next feature of the chosen finding</source>
        <translation>Montrer l&apos;élément suivant du constat choisi</translation>
    </message>
    <message>
        <source>Places that look ali&amp;ke</source>
        <translation>Lieu&amp;x qui se ressemblent</translation>
    </message>
    <message>
        <source>Alike</source>
        <translation>Semblables</translation>
    </message>
    <message>
        <source>Mark the places that the landmarks cannot tell apart, and those without any</source>
        <translation>Marquer les lieux que les repères ne distinguent pas et ceux qui n&apos;en ont aucun</translation>
    </message>
    <message>
        <source>&amp;Walk with this map</source>
        <translation>Par&amp;courir avec cette carte</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Parcours</translation>
    </message>
    <message>
        <source>Use the saved map on the Walk page</source>
        <translation>Utiliser la carte enregistrée sur la page Parcours</translation>
    </message>
    <message>
        <source>Where landmarks are see&amp;n</source>
        <translation>&amp;Où l&apos;on voit des repères</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Visibles</translation>
    </message>
    <message>
        <source>Mark from where landmarks can be seen, and from where none can</source>
        <translation>Marquer d&apos;où l&apos;on voit des repères, et d&apos;où l&apos;on n&apos;en voit aucun</translation>
    </message>
    <message>
        <source>&amp;Missing routes…</source>
        <translation>Itinéraires man&amp;quants…</translation>
    </message>
    <message>
        <source>Missing routes</source>
        <translation>Itinéraires manquants</translation>
    </message>
    <message>
        <source>List the places between which no route leads, and why</source>
        <translation>Énumérer les lieux qu&apos;aucun itinéraire ne relie, et pourquoi</translation>
    </message>
    <message>
        <source>Floor-plan ima&amp;ge…</source>
        <translation>Ima&amp;ge du plan…</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>L&apos;image</translation>
    </message>
    <message>
        <source>Lay the image of a floor plan under the floor that is shown</source>
        <translation>Poser l&apos;image d&apos;un plan sous l&apos;étage montré</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapDocument</name>
    <message>
        <source>Load the map again</source>
        <translation>Charger le plan à nouveau</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapPage</name>
    <message>
        <source>Saved in %1</source>
        <translation>Enregistré dans %1</translation>
    </message>
    <message>
        <source>Open a map</source>
        <translation>Ouvrir une carte</translation>
    </message>
    <message>
        <source>Maps (%1);;All files (%2)</source>
        <translation>Cartes (%1);;Tous les fichiers (%2)</translation>
    </message>
    <message>
        <source>Save the map</source>
        <translation>Enregistrer la carte</translation>
    </message>
    <message>
        <source>Maps (%1)</source>
        <translation>Cartes (%1)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>The map has changes that are not saved.</source>
        <translation>La carte contient des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>Save them first?</source>
        <translation>Les enregistrer d&apos;abord&#xa0;?</translation>
    </message>
    <message>
        <source>Imported from %1. Look at what was found, then save it as a map of Farol.</source>
        <translation>Importé de %1. Regardez ce qui a été trouvé, puis enregistrez-la comme carte de Farol.</translation>
    </message>
    <message>
        <source>Sa&amp;ve…</source>
        <translation>&amp;Enregistrer…</translation>
    </message>
    <message>
        <source>The map is being opened…</source>
        <translation>La carte s&apos;ouvre…</translation>
    </message>
    <message>
        <source>The map is being imported and checked…</source>
        <translation>La carte est importée et vérifiée…</translation>
    </message>
    <message>
        <source>The map is being saved…</source>
        <translation>La carte est enregistrée…</translation>
    </message>
    <message>
        <source>The map is being checked…</source>
        <translation>La carte est vérifiée…</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Vérification</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Itinéraire</translation>
    </message>
    <message>
        <source>Parts of the map</source>
        <translation>Parties de la carte</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Give up; the map that was open stays</source>
        <translation>Renoncer&#xa0;; la carte ouverte reste</translation>
    </message>
    <message>
        <source>Click where the landmark stands, or move the plan under the cross with the arrows and press Enter. Escape gives up.</source>
        <translation>Cliquez là où se trouve le repère, ou déplacez le plan sous la croix avec les flèches et appuyez sur Entrée. Échap renonce.</translation>
    </message>
    <message>
        <source>Click where the door is, or move the plan under the cross with the arrows and press Enter. Escape gives up.</source>
        <translation>Cliquez là où se trouve la porte, ou déplacez le plan sous la croix avec les flèches et appuyez sur Entrée. Échap renonce.</translation>
    </message>
    <message>
        <source>Add a landmark</source>
        <translation>Ajouter un repère</translation>
    </message>
    <message>
        <source>Add a door</source>
        <translation>Ajouter une porte</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Deleted: %1. Ctrl+Z brings it back.</source>
        <translation>Supprimé&#xa0;: %1. Ctrl+Z le ramène.</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <source>Print the plan</source>
        <translation>Imprimer le plan</translation>
    </message>
    <message>
        <source>PDF (%1)</source>
        <translation>PDF (%1)</translation>
    </message>
    <message>
        <source>Printed in %1</source>
        <translation>Imprimé dans %1</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 ne peut pas être écrit. Choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Open the map on which the landmark shall stand.</source>
        <translation>Ouvrez la carte sur laquelle le repère doit se trouver.</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>&amp;Ouvrir une carte…</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map. You have changes of your own: loading it again puts them aside, and Ctrl+Z brings them back.</source>
        <translation>Un autre programme a modifié le fichier de ce plan. Vous avez vos propres modifications&#xa0;: le charger à nouveau les met de côté, et Ctrl+Z les ramène.</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map.</source>
        <translation>Un autre programme a modifié le fichier de ce plan.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>&amp;Le charger à nouveau</translation>
    </message>
    <message>
        <source>The file %1 is no longer there. The map stays open here: save it, or it is lost when you leave.</source>
        <translation>Le fichier %1 n’est plus là. Le plan reste ouvert ici&#xa0;: enregistrez-le, sinon il sera perdu quand vous quitterez.</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map, and it cannot be read any more (%1). The map stays open here as it was: save it under another name.</source>
        <translation>Un autre programme a modifié le fichier de ce plan, qui n’est plus lisible (%1). Le plan reste ouvert ici tel qu’il était&#xa0;: enregistrez-le sous un autre nom.</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Pas encore enregistré</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map since it was read here.</source>
        <translation>Un autre programme a modifié le fichier de ce plan depuis qu’il a été lu ici.</translation>
    </message>
    <message>
        <source>Saving over it would lose what that program wrote.</source>
        <translation>Enregistrer par-dessus perdrait ce que ce programme a écrit.</translation>
    </message>
    <message>
        <source>Save under &amp;another name…</source>
        <translation>Enregistrer sous un &amp;autre nom…</translation>
    </message>
    <message>
        <source>Save &amp;over it</source>
        <translation>Enregistrer &amp;par-dessus</translation>
    </message>
    <message>
        <source>Floor-plan image</source>
        <translation>Image du plan</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (%2)</source>
        <translation>Images (%1);;Tous les fichiers (%2)</translation>
    </message>
    <message>
        <source>No landmark is seen from %1 % of the floors.</source>
        <translation>De %1 % des étages, on ne voit aucun repère.</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapPanel</name>
    <message>
        <source>No map is open.</source>
        <translation>Aucune carte n&apos;est ouverte.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) on the map.</source>
        <translation>
            <numerusform>%n lieu sur la carte.</numerusform>
            <numerusform>%n lieux sur la carte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Where you are is not known yet.</source>
        <translation>On ne sait pas encore où vous êtes.</translation>
    </message>
    <message>
        <source>You are in %1, %2: %3.</source>
        <translation>Vous êtes ici&#xa0;: %1, %2&#xa0;: %3.</translation>
    </message>
    <message>
        <source>You are in %1: %2.</source>
        <translation>Vous êtes ici&#xa0;: %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>&amp;Go to %1</source>
        <translation>&amp;Aller à&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Start at %1</source>
        <translation>&amp;Partir de&#xa0;: %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>&amp;Level:</source>
        <translation>&amp;Niveau&#xa0;:</translation>
    </message>
    <message>
        <source>Level of the map</source>
        <translation>Niveau de la carte</translation>
    </message>
    <message>
        <source>The floor that the map shows (Page Up and Page Down in the map)</source>
        <translation>L&apos;étage que montre la carte (Page préc. et Page suiv. sur la carte)</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>&amp;Suivre</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Switch to the floor where you are whenever it changes</source>
        <translation>Passer à l&apos;étage où vous êtes dès qu&apos;il change</translation>
    </message>
    <message>
        <source>Larger (+)</source>
        <translation>Plus grand (+)</translation>
    </message>
    <message>
        <source>Smaller (-)</source>
        <translation>Plus petit (-)</translation>
    </message>
    <message>
        <source>Show the whole floor (0)</source>
        <translation>Montrer tout l&apos;étage (0)</translation>
    </message>
    <message>
        <source>Floor map</source>
        <translation>Carte de l&apos;étage</translation>
    </message>
    <message>
        <source>Drag to move, turn the wheel to zoom, double-click a place to go there</source>
        <translation>Glissez pour déplacer, tournez la molette pour zoomer, double-cliquez sur un lieu pour y aller</translation>
    </message>
    <message>
        <source>Taken to be in %1: %2. Really in %3.</source>
        <translation>Supposé ici&#xa0;: %1&#xa0;: %2. En réalité ici&#xa0;: %3.</translation>
    </message>
    <message>
        <source>The user &amp;is here, in %1</source>
        <translation>L&apos;utilisateur &amp;est ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>The assistant had said: %1.</source>
        <translation>L&apos;assistant avait dit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>said by the assistant</source>
        <translation>dit par l&apos;assistant</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapView</name>
    <message>
        <source>Less likely</source>
        <translation>Moins probable</translation>
    </message>
    <message>
        <source>More likely</source>
        <translation>Plus probable</translation>
    </message>
    <message>
        <source>No map is open.
Open one with Ctrl+O.</source>
        <translation>Aucune carte n&apos;est ouverte.
Ouvrez-en une avec Ctrl+O.</translation>
    </message>
</context>
<context>
    <name>farol::ui::MissingDialog</name>
    <message>
        <source>&amp;Show on the plan</source>
        <translation>&amp;Montrer sur le plan</translation>
    </message>
    <message>
        <source>Missing routes</source>
        <translation>Itinéraires manquants</translation>
    </message>
    <message>
        <source>Looking for the way between all places…</source>
        <translation>Recherche du chemin entre tous les lieux…</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Manque</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Pourquoi</translation>
    </message>
    <message>
        <source>Places between which no route leads; Enter shows the chosen one on the plan</source>
        <translation>Lieux qu&apos;aucun itinéraire ne relie&#xa0;; Entrée montre celui qui est choisi sur le plan</translation>
    </message>
    <message>
        <source>Show on the plan</source>
        <translation>Montrer sur le plan</translation>
    </message>
    <message>
        <source>Choose both places on the Map page, and see them on the plan</source>
        <translation>Choisir les deux lieux sur la page Carte, et les voir sur le plan</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more place(s)</source>
        <translation>
            <numerusform>%1 et %n lieu de plus</numerusform>
            <numerusform>%1 et %n lieux de plus</numerusform>
        </translation>
    </message>
    <message>
        <source>From every place there is a route to every other one (%1 pairs of places).</source>
        <translation>De chaque lieu, un itinéraire mène à tous les autres (%1 paires de lieux).</translation>
    </message>
    <message>
        <source>Of %1 pairs of places, %2 have no route.</source>
        <translation>Sur %1 paires de lieux, %2 n&apos;ont pas d&apos;itinéraire.</translation>
    </message>
    <message numerus="yes">
        <source>%n more line(s) are not listed: mend these first.</source>
        <translation>
            <numerusform>%n ligne de plus n&apos;est pas montrée&#xa0;: corrigez d&apos;abord celles-ci.</numerusform>
            <numerusform>%n lignes de plus ne sont pas montrées&#xa0;: corrigez d&apos;abord celles-ci.</numerusform>
        </translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>dans les deux sens</translation>
    </message>
    <message>
        <source>this way</source>
        <translation>dans ce sens</translation>
    </message>
</context>
<context>
    <name>farol::ui::NoRouteWords</name>
    <message>
        <source>stairs</source>
        <translation>des escaliers</translation>
    </message>
    <message>
        <source>a lift</source>
        <translation>un ascenseur</translation>
    </message>
    <message>
        <source>an escalator</source>
        <translation>un escalator</translation>
    </message>
    <message>
        <source>a moving walkway</source>
        <translation>un tapis roulant</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>une rampe</translation>
    </message>
    <message>
        <source>a narrow door</source>
        <translation>une porte étroite</translation>
    </message>
    <message>
        <source>a restricted region</source>
        <translation>un espace réservé</translation>
    </message>
    <message>
        <source>a closed door or passage</source>
        <translation>une porte ou un passage fermé</translation>
    </message>
    <message>
        <source>a one-way door or passage</source>
        <translation>une porte ou un passage à sens unique</translation>
    </message>
    <message>
        <source>%1 (from %2 to %3)</source>
        <translation>%1 (de %2 à %3)</translation>
    </message>
    <message>
        <source>The map joins %1 and %2 in no way.</source>
        <translation>La carte ne relie %1 et %2 d&apos;aucune façon.</translation>
    </message>
    <message>
        <source>%1 is reached only by what is to be avoided: %2.</source>
        <translation>On n&apos;arrive à %1 que par ce qui est à éviter&#xa0;: %2.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <source>On the way to %1 stands %2.</source>
        <translation>Sur le chemin de %1 se trouve %2.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
</context>
<context>
    <name>farol::ui::OptionFields</name>
    <message>
        <source>Announce what comes within</source>
        <translation>Annoncer ce qui vient à moins de</translation>
    </message>
    <message>
        <source>Say “now” within</source>
        <translation>Dire «&#xa0;maintenant&#xa0;» à moins de</translation>
    </message>
    <message>
        <source>Reassure every</source>
        <translation>Rassurer tous les</translation>
    </message>
    <message>
        <source>Reassure, where no distance is known, every</source>
        <translation>Rassurer, sans distance connue, toutes les</translation>
    </message>
    <message>
        <source>Repeat an instruction after</source>
        <translation>Répéter une instruction après</translation>
    </message>
    <message>
        <source>Tell an object again after</source>
        <translation>Redire un objet après</translation>
    </message>
    <message>
        <source>Say that the place is not known after</source>
        <translation>Dire que le lieu est inconnu après</translation>
    </message>
    <message>
        <source>Say again that the route was left after</source>
        <translation>Redire que l&apos;itinéraire est quitté après</translation>
    </message>
    <message>
        <source>Avoid stairs</source>
        <translation>Éviter les escaliers</translation>
    </message>
    <message>
        <source>Avoid lifts</source>
        <translation>Éviter les ascenseurs</translation>
    </message>
    <message>
        <source>Avoid escalators</source>
        <translation>Éviter les escaliers mécaniques</translation>
    </message>
    <message>
        <source>Avoid moving walkways</source>
        <translation>Éviter les tapis roulants</translation>
    </message>
    <message>
        <source>Avoid ramps</source>
        <translation>Éviter les rampes</translation>
    </message>
    <message>
        <source>Avoid narrow doors</source>
        <translation>Éviter les portes étroites</translation>
    </message>
    <message>
        <source>Avoid restricted places</source>
        <translation>Éviter les lieux restreints</translation>
    </message>
    <message>
        <source>Walking speed</source>
        <translation>Vitesse de marche</translation>
    </message>
    <message>
        <source>Time to find and pass a door</source>
        <translation>Temps pour trouver et passer une porte</translation>
    </message>
    <message>
        <source>Time for the stairs of a level</source>
        <translation>Temps pour l&apos;escalier d&apos;un niveau</translation>
    </message>
    <message>
        <source>Time to wait for a lift and ride it</source>
        <translation>Temps pour attendre et prendre un ascenseur</translation>
    </message>
    <message>
        <source>Points that must fit an object</source>
        <translation>Points qui doivent concorder pour un objet</translation>
    </message>
    <message>
        <source>Evidence that an object needs</source>
        <translation>Indices qu&apos;il faut pour un objet</translation>
    </message>
    <message>
        <source>Points that must fit a known place</source>
        <translation>Points qui doivent concorder pour un lieu connu</translation>
    </message>
    <message>
        <source>Sharpness that a picture needs</source>
        <translation>Netteté qu&apos;il faut à une image</translation>
    </message>
</context>
<context>
    <name>farol::ui::OptionForm</name>
    <message>
        <source>&amp;Defaults</source>
        <translation>Valeurs par &amp;défaut</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Valeurs par défaut</translation>
    </message>
    <message>
        <source>Take every figure of this page back to what the program has</source>
        <translation>Ramener tous les chiffres de cette page à ceux du programme</translation>
    </message>
    <message>
        <source>Usually %1</source>
        <translation>D&apos;habitude %1</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1&#xa0;:</translation>
    </message>
</context>
<context>
    <name>farol::ui::OutlineView</name>
    <message>
        <source>No picture yet</source>
        <translation>Pas encore d&apos;image</translation>
    </message>
    <message>
        <source>The whole picture counts</source>
        <translation>Toute l&apos;image compte</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>en haut à gauche</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>en haut à droite</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>en bas à droite</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>en bas à gauche</translation>
    </message>
    <message>
        <source>Corner %1, %2, is %3 to the right and %4 down</source>
        <translation>Le coin %1, %2, est à %3 vers la droite et %4 vers le bas</translation>
    </message>
</context>
<context>
    <name>farol::ui::Phrasebook</name>
    <message>
        <source>I read: %1. %2.</source>
        <extracomment>%1 what is written there, %2 &quot;left, up&quot;</extracomment>
        <translation>Je lis&#xa0;: %1. %2.</translation>
    </message>
    <message>
        <source>I have found the way.</source>
        <translation>J&apos;ai trouvé le chemin.</translation>
    </message>
    <message>
        <source>Destination: %1.</source>
        <translation>Destination&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Puis</translation>
    </message>
    <message>
        <source>First</source>
        <translation>D&apos;abord</translation>
    </message>
    <message>
        <source>First, probably</source>
        <translation>D&apos;abord, probablement</translation>
    </message>
    <message>
        <source>Start slowly: I will tell you if it is the wrong way.</source>
        <translation>Commencez lentement&#xa0;: je vous dirai si c&apos;est le mauvais sens.</translation>
    </message>
    <message>
        <source>Probably %1 first.</source>
        <extracomment>%1 &quot;turn left&quot;, &quot;turn around&quot;</extracomment>
        <translation>D&apos;abord, probablement&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Soon</source>
        <translation>Bientôt</translation>
    </message>
    <message>
        <source>Soon, probably</source>
        <translation>Bientôt, probablement</translation>
    </message>
    <message>
        <source>Keep moving forward. You are probably going the right way.</source>
        <translation>Continuez d&apos;avancer. Vous êtes probablement sur le bon chemin.</translation>
    </message>
    <message>
        <source>Keep moving forward.</source>
        <translation>Continuez d&apos;avancer.</translation>
    </message>
    <message>
        <source>Now turn slowly to the left, past where you began.</source>
        <translation>Maintenant, tournez-vous lentement vers la gauche, au-delà de votre point de départ.</translation>
    </message>
    <message>
        <source>Hold still, and tilt the camera slowly up.</source>
        <translation>Ne bougez plus et inclinez lentement la caméra vers le haut.</translation>
    </message>
    <message>
        <source>Now tilt it slowly down.</source>
        <translation>Maintenant, inclinez-la lentement vers le bas.</translation>
    </message>
    <message>
        <source>I still do not know where you are. If you can, move a few steps along a wall, or ask for help.</source>
        <translation>Je ne sais toujours pas où vous êtes. Si vous pouvez, faites quelques pas le long d&apos;un mur, ou demandez de l&apos;aide.</translation>
    </message>
    <message>
        <source>Thank you, that is enough.</source>
        <translation>Merci, cela suffit.</translation>
    </message>
    <message>
        <source>I am not sure where you are. Stop, and turn slowly to the right, so that I can look around.</source>
        <translation>Je ne sais pas bien où vous êtes. Arrêtez-vous et tournez-vous lentement vers la droite, pour que je puisse regarder autour de vous.</translation>
    </message>
    <message>
        <source>You have arrived.</source>
        <translation>Vous êtes à destination.</translation>
    </message>
    <message>
        <source>You have probably arrived.</source>
        <translation>Vous êtes probablement à destination.</translation>
    </message>
    <message>
        <source>You have arrived: %1.</source>
        <translation>Vous êtes à destination&#xa0;: %1.</translation>
    </message>
    <message>
        <source>You have probably arrived: %1.</source>
        <translation>Vous êtes probablement à destination&#xa0;: %1.</translation>
    </message>
    <message>
        <source>You are walking the wrong way.</source>
        <translation>Vous allez dans le mauvais sens.</translation>
    </message>
    <message>
        <source>You are probably walking the wrong way.</source>
        <translation>Vous allez probablement dans le mauvais sens.</translation>
    </message>
    <message>
        <source>You have gone too far.</source>
        <translation>Vous avez trop avancé.</translation>
    </message>
    <message>
        <source>You have probably gone too far.</source>
        <translation>Vous avez probablement trop avancé.</translation>
    </message>
    <message>
        <source>You have left the route.</source>
        <translation>Vous avez quitté l&apos;itinéraire.</translation>
    </message>
    <message>
        <source>You have probably left the route.</source>
        <translation>Vous avez probablement quitté l&apos;itinéraire.</translation>
    </message>
    <message>
        <source>Stop. I know no way from here.</source>
        <translation>Arrêtez-vous. Je ne connais aucun chemin à partir d&apos;ici.</translation>
    </message>
    <message>
        <source>Stop for a moment.</source>
        <translation>Arrêtez-vous un instant.</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>À partir d&apos;ici</translation>
    </message>
    <message>
        <source>From here, probably</source>
        <translation>À partir d&apos;ici, probablement</translation>
    </message>
    <message>
        <source>I do not know yet where you are.</source>
        <translation>Je ne sais pas encore où vous êtes.</translation>
    </message>
    <message>
        <source>You are here: %1.</source>
        <translation>Vous êtes ici&#xa0;: %1.</translation>
    </message>
    <message>
        <source>You are probably here, or next to it: %1.</source>
        <translation>Vous êtes probablement ici, ou juste à côté&#xa0;: %1.</translation>
    </message>
    <message>
        <source>up</source>
        <translation>en haut</translation>
    </message>
    <message>
        <source>down</source>
        <translation>en bas</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <extracomment>%1 &quot;extinguisher&quot;, %2 &quot;left, down&quot;</extracomment>
        <translation>%1, %2.</translation>
    </message>
    <message>
        <source>perhaps: %1, %2.</source>
        <translation>peut-être&#xa0;: %1, %2.</translation>
    </message>
    <message>
        <source>No destination is chosen yet. Choose one first.</source>
        <translation>Aucune destination n&apos;est encore choisie. Choisissez-en une d&apos;abord.</translation>
    </message>
    <message>
        <source>I do not know this destination. Choose another one.</source>
        <translation>Je ne connais pas cette destination. Choisissez-en une autre.</translation>
    </message>
    <message>
        <source>I do not know this destination: %1. Choose another one.</source>
        <translation>Je ne connais pas cette destination&#xa0;: %1. Choisissez-en une autre.</translation>
    </message>
    <message>
        <source>I know no way to your destination. Choose another one, or ask for help.</source>
        <translation>Je ne connais aucun chemin vers votre destination. Choisissez-en une autre, ou demandez de l&apos;aide.</translation>
    </message>
    <message>
        <source>I know no way to: %1. Choose another destination, or ask for help.</source>
        <translation>Je ne connais aucun chemin vers cette destination&#xa0;: %1. Choisissez-en une autre, ou demandez de l&apos;aide.</translation>
    </message>
    <message>
        <source>You are already there.</source>
        <translation>Vous y êtes déjà.</translation>
    </message>
    <message>
        <source>You are probably there already.</source>
        <translation>Vous y êtes probablement déjà.</translation>
    </message>
    <message>
        <source>You are already there: %1.</source>
        <translation>Vous y êtes déjà&#xa0;: %1.</translation>
    </message>
    <message>
        <source>You are probably there already: %1.</source>
        <translation>Vous y êtes probablement déjà&#xa0;: %1.</translation>
    </message>
    <message>
        <source>near you</source>
        <translation>près de vous</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>what is around</comment>
        <extracomment>%1 &quot;a door&quot;, %2 a name</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>I know of nothing near you.</source>
        <translation>Je ne connais rien tout près.</translation>
    </message>
    <message>
        <source>The directions are as you face along your way.</source>
        <translation>Les directions sont celles de qui suit votre chemin.</translation>
    </message>
    <message>
        <source>The directions are those of the map.</source>
        <translation>Les directions sont celles du plan.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what is around</comment>
        <extracomment>%1 &quot;on your left&quot;, %2 &quot;a door, Library; an extinguisher&quot;</extracomment>
        <translation>%1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Stop. The camera gives no picture, and I cannot guide you.</source>
        <translation>Arrêtez-vous. La caméra ne donne pas d&apos;image, et je ne peux pas vous guider.</translation>
    </message>
    <message>
        <source>The camera works again.</source>
        <translation>La caméra fonctionne de nouveau.</translation>
    </message>
    <message>
        <source>The recording has stopped. I keep guiding you.</source>
        <translation>L&apos;enregistrement s&apos;est arrêté. Je continue de vous guider.</translation>
    </message>
    <message>
        <source>Stop. I cannot see. Please uncover the camera.</source>
        <translation>Arrêtez-vous. Je ne vois rien. Découvrez la caméra, s&apos;il vous plaît.</translation>
    </message>
    <message>
        <source>One picture could not be used. I keep guiding you.</source>
        <translation>Une image n&apos;a pas pu être utilisée. Je continue de vous guider.</translation>
    </message>
    <message>
        <source>Stop. Something is wrong. Please ask for help.</source>
        <translation>Arrêtez-vous. Quelque chose ne va pas. Demandez de l&apos;aide, s&apos;il vous plaît.</translation>
    </message>
    <message numerus="yes">
        <source>About %n foot(feet).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Environ un pied.</numerusform>
            <numerusform>Environ %n pieds.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n step(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Environ un pas.</numerusform>
            <numerusform>Environ %n pas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n metre(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Environ un mètre.</numerusform>
            <numerusform>Environ %n mètres.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n foot(feet)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>Dans environ un pied</numerusform>
            <numerusform>Dans environ %n pieds</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n step(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>Dans environ un pas</numerusform>
            <numerusform>Dans environ %n pas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n metre(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>Dans environ un mètre</numerusform>
            <numerusform>Dans environ %n mètres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n foot(feet).</source>
        <translation>
            <numerusform>Continuez d&apos;avancer sur environ un pied.</numerusform>
            <numerusform>Continuez d&apos;avancer sur environ %n pieds.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n step(s).</source>
        <translation>
            <numerusform>Continuez d&apos;avancer d&apos;environ un pas.</numerusform>
            <numerusform>Continuez d&apos;avancer d&apos;environ %n pas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n metre(s).</source>
        <translation>
            <numerusform>Continuez d&apos;avancer sur environ un mètre.</numerusform>
            <numerusform>Continuez d&apos;avancer sur environ %n mètres.</numerusform>
        </translation>
    </message>
    <message>
        <source>a door</source>
        <translation>une porte</translation>
    </message>
    <message>
        <source>an opening</source>
        <translation>une ouverture</translation>
    </message>
    <message>
        <source>stairs up</source>
        <translation>un escalier qui monte</translation>
    </message>
    <message>
        <source>stairs down</source>
        <translation>un escalier qui descend</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>escalier</translation>
    </message>
    <message>
        <source>a lift</source>
        <translation>un ascenseur</translation>
    </message>
    <message>
        <source>an escalator up</source>
        <translation>un escalier mécanique qui monte</translation>
    </message>
    <message>
        <source>an escalator down</source>
        <translation>un escalier mécanique qui descend</translation>
    </message>
    <message>
        <source>an escalator</source>
        <translation>un escalier mécanique</translation>
    </message>
    <message>
        <source>a ramp up</source>
        <translation>une rampe qui monte</translation>
    </message>
    <message>
        <source>a ramp down</source>
        <translation>une rampe qui descend</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>une rampe</translation>
    </message>
    <message>
        <source>The stairs are %1.</source>
        <translation>L&apos;escalier est %1.</translation>
    </message>
    <message>
        <source>The stairs are probably %1.</source>
        <translation>L&apos;escalier est probablement %1.</translation>
    </message>
    <message>
        <source>The lift is %1.</source>
        <translation>L&apos;ascenseur est %1.</translation>
    </message>
    <message>
        <source>The lift is probably %1.</source>
        <translation>L&apos;ascenseur est probablement %1.</translation>
    </message>
    <message>
        <source>The escalator is %1.</source>
        <translation>L&apos;escalier mécanique est %1.</translation>
    </message>
    <message>
        <source>The escalator is probably %1.</source>
        <translation>L&apos;escalier mécanique est probablement %1.</translation>
    </message>
    <message>
        <source>The ramp is %1.</source>
        <translation>La rampe est %1.</translation>
    </message>
    <message>
        <source>The ramp is probably %1.</source>
        <translation>La rampe est probablement %1.</translation>
    </message>
    <message>
        <source>You are probably near the door.</source>
        <translation>Vous êtes probablement près de la porte.</translation>
    </message>
    <message>
        <source>You are probably near the opening.</source>
        <translation>Vous êtes probablement près de l&apos;ouverture.</translation>
    </message>
    <message>
        <source>Careful: you are probably near the stairs.</source>
        <translation>Attention&#xa0;: vous êtes probablement près de l&apos;escalier.</translation>
    </message>
    <message>
        <source>You are probably near the lift.</source>
        <translation>Vous êtes probablement près de l&apos;ascenseur.</translation>
    </message>
    <message>
        <source>Careful: you are probably near the escalator.</source>
        <translation>Attention&#xa0;: vous êtes probablement près de l&apos;escalier mécanique.</translation>
    </message>
    <message>
        <source>You are probably near the ramp.</source>
        <translation>Vous êtes probablement près de la rampe.</translation>
    </message>
    <message>
        <source>You are probably where you have to turn.</source>
        <translation>Vous êtes probablement là où il faut tourner.</translation>
    </message>
    <message>
        <source>take the stairs up</source>
        <translation>montez l&apos;escalier</translation>
    </message>
    <message>
        <source>take the stairs down</source>
        <translation>descendez l&apos;escalier</translation>
    </message>
    <message>
        <source>take the stairs, but feel first whether they go up or down</source>
        <translation>prenez l&apos;escalier, mais vérifiez d&apos;abord du pied s&apos;il monte ou descend</translation>
    </message>
    <message>
        <source>take the lift up</source>
        <translation>prenez l&apos;ascenseur pour monter</translation>
    </message>
    <message>
        <source>take the lift down</source>
        <translation>prenez l&apos;ascenseur pour descendre</translation>
    </message>
    <message>
        <source>take the lift</source>
        <translation>prenez l&apos;ascenseur</translation>
    </message>
    <message>
        <source>take the escalator up</source>
        <translation>prenez l&apos;escalier mécanique pour monter</translation>
    </message>
    <message>
        <source>take the escalator down</source>
        <translation>prenez l&apos;escalier mécanique pour descendre</translation>
    </message>
    <message>
        <source>take the escalator, but feel first whether it goes up or down</source>
        <translation>prenez l&apos;escalier mécanique, mais vérifiez d&apos;abord s&apos;il monte ou descend</translation>
    </message>
    <message>
        <source>go up the ramp</source>
        <translation>montez la rampe</translation>
    </message>
    <message>
        <source>go down the ramp</source>
        <translation>descendez la rampe</translation>
    </message>
    <message>
        <source>follow the ramp</source>
        <translation>suivez la rampe</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>devant vous</translation>
    </message>
    <message>
        <source>next</source>
        <comment>door or opening</comment>
        <translation>prochaine</translation>
    </message>
    <message>
        <source>get out of the lift</source>
        <translation>sortez de l&apos;ascenseur</translation>
    </message>
    <message>
        <source>go into the lift</source>
        <translation>entrez dans l&apos;ascenseur</translation>
    </message>
    <message>
        <source>go into the lift %1</source>
        <translation>entrez dans l&apos;ascenseur %1</translation>
    </message>
    <message>
        <source>go straight on through two doors in a row</source>
        <translation>continuez tout droit par deux portes qui se suivent</translation>
    </message>
    <message>
        <source>go straight on through two openings in a row</source>
        <translation>continuez tout droit par deux ouvertures qui se suivent</translation>
    </message>
    <message>
        <source>go straight on through the door</source>
        <translation>continuez tout droit par la porte</translation>
    </message>
    <message>
        <source>go straight on through the opening</source>
        <translation>continuez tout droit par l&apos;ouverture</translation>
    </message>
    <message>
        <source>go through the door</source>
        <translation>passez par la porte</translation>
    </message>
    <message>
        <source>go through the opening</source>
        <translation>passez par l&apos;ouverture</translation>
    </message>
    <message>
        <source>go through the door %1</source>
        <translation>passez par la porte %1</translation>
    </message>
    <message>
        <source>go through the opening %1</source>
        <translation>passez par l&apos;ouverture %1</translation>
    </message>
    <message>
        <source>go through the %1 door %2</source>
        <translation>passez par la %1 porte %2</translation>
    </message>
    <message>
        <source>go through the %1 opening %2</source>
        <translation>passez par la %1 ouverture %2</translation>
    </message>
    <message>
        <source>follow the wall on your left and go through the opening</source>
        <translation>suivez le mur à votre gauche et passez par l&apos;ouverture</translation>
    </message>
    <message>
        <source>follow the wall on your right and go through the opening</source>
        <translation>suivez le mur à votre droite et passez par l&apos;ouverture</translation>
    </message>
    <message>
        <source>follow the wall on your left and go through the %1 door</source>
        <extracomment>%1 &quot;second&quot;</extracomment>
        <translation>suivez le mur à votre gauche et passez par la %1 porte</translation>
    </message>
    <message>
        <source>follow the wall on your right and go through the %1 door</source>
        <translation>suivez le mur à votre droite et passez par la %1 porte</translation>
    </message>
    <message>
        <source>%1, then %2</source>
        <extracomment>%1 &quot;go through the door&quot;, %2 &quot;turn left&quot;</extracomment>
        <translation>%1, puis %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 &quot;go through the door&quot;, %2 &quot;turning left&quot;</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>move forward</source>
        <translation>avancez</translation>
    </message>
    <message>
        <source>your destination</source>
        <translation>votre destination</translation>
    </message>
    <message>
        <source>stay in the lift</source>
        <translation>restez dans l&apos;ascenseur</translation>
    </message>
    <message>
        <source>stay in the lift until: %1</source>
        <translation>restez dans l&apos;ascenseur jusqu&apos;à&#xa0;: %1</translation>
    </message>
    <message>
        <source>go straight on through the next door</source>
        <translation>continuez tout droit par la prochaine porte</translation>
    </message>
    <message>
        <source>go straight on through the next opening</source>
        <translation>continuez tout droit par la prochaine ouverture</translation>
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
        <translation>niveau %1</translation>
    </message>
    <message>
        <source>minus %1</source>
        <translation>moins %1</translation>
    </message>
    <message>
        <source>It is a long flight.</source>
        <translation>Il y a beaucoup de marches.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s).</source>
        <translation>
            <numerusform>Une marche.</numerusform>
            <numerusform>%n marches.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: %1.</source>
        <translation>Ensuite&#xa0;: %1.</translation>
    </message>
    <message>
        <source>When you get out: %1.</source>
        <translation>À la sortie&#xa0;: %1.</translation>
    </message>
    <message>
        <source>At the top: %1.</source>
        <translation>En haut&#xa0;: %1.</translation>
    </message>
    <message>
        <source>At the bottom: %1.</source>
        <translation>En bas&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Inside, choose: %1.</source>
        <translation>À l&apos;intérieur, choisissez&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Then, straight away, %1.</source>
        <translation>Aussitôt après, %1.</translation>
    </message>
    <message>
        <source>%1: your destination.</source>
        <translation>%1&#xa0;: votre destination.</translation>
    </message>
    <message>
        <source>%1: your destination, %2.</source>
        <translation>%1&#xa0;: votre destination, %2.</translation>
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
        <translation>%1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <comment>when, what to do</comment>
        <extracomment>%1 &quot;Soon&quot;, %2 &quot;go through the door&quot;</extracomment>
        <translation>%1, %2.</translation>
    </message>
    <message>
        <source>%1: a bend. Follow it, %2.</source>
        <extracomment>%1 &quot;First&quot;, %2 &quot;turning left&quot;</extracomment>
        <translation>%1&#xa0;: un virage. Suivez-le, %2.</translation>
    </message>
    <message>
        <source>Your destination is here.</source>
        <translation>Votre destination est ici.</translation>
    </message>
    <message>
        <source>Your destination is probably here.</source>
        <translation>Votre destination est probablement ici.</translation>
    </message>
    <message>
        <source>Your destination is here: %1.</source>
        <translation>Votre destination est ici&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Your destination is probably here: %1.</source>
        <translation>Votre destination est probablement ici&#xa0;: %1.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more thing(s) to do after that.</source>
        <translation>
            <numerusform>Et après cela, encore une chose à faire.</numerusform>
            <numerusform>Et après cela, encore %n choses à faire.</numerusform>
        </translation>
    </message>
    <message>
        <source>known place</source>
        <translation>lieu connu</translation>
    </message>
    <message>
        <source>door</source>
        <translation>porte</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>ascenseur</translation>
    </message>
    <message>
        <source>extinguisher</source>
        <translation>extincteur</translation>
    </message>
    <message>
        <source>exit sign</source>
        <translation>panneau de sortie</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>panneau</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texte</translation>
    </message>
    <message>
        <source>rectangular shape</source>
        <translation>forme rectangulaire</translation>
    </message>
    <message>
        <source>window</source>
        <translation>fenêtre</translation>
    </message>
    <message>
        <source>locker</source>
        <translation>casier</translation>
    </message>
    <message>
        <source>poster</source>
        <translation>affiche</translation>
    </message>
    <message>
        <source>drinking fountain</source>
        <translation>fontaine à eau</translation>
    </message>
    <message>
        <source>hydrant</source>
        <translation>bouche d&apos;incendie</translation>
    </message>
    <message>
        <source>vending machine</source>
        <translation>distributeur automatique</translation>
    </message>
    <message>
        <source>waste bin</source>
        <translation>poubelle</translation>
    </message>
    <message>
        <source>plant</source>
        <translation>plante</translation>
    </message>
    <message>
        <source>piece of furniture</source>
        <translation>meuble</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>tableau</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objet</translation>
    </message>
    <message>
        <source>an extinguisher</source>
        <translation>un extincteur</translation>
    </message>
    <message>
        <source>an exit sign</source>
        <translation>un panneau de sortie</translation>
    </message>
    <message>
        <source>a sign</source>
        <translation>un panneau</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a window</source>
        <translation>une fenêtre</translation>
    </message>
    <message>
        <source>a locker</source>
        <translation>un casier</translation>
    </message>
    <message>
        <source>a poster</source>
        <translation>une affiche</translation>
    </message>
    <message>
        <source>a drinking fountain</source>
        <translation>une fontaine à eau</translation>
    </message>
    <message>
        <source>a hydrant</source>
        <translation>une bouche d&apos;incendie</translation>
    </message>
    <message>
        <source>a vending machine</source>
        <translation>un distributeur automatique</translation>
    </message>
    <message>
        <source>a waste bin</source>
        <translation>une poubelle</translation>
    </message>
    <message>
        <source>a plant</source>
        <translation>une plante</translation>
    </message>
    <message>
        <source>a piece of furniture</source>
        <translation>un meuble</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>un tableau</translation>
    </message>
    <message>
        <source>left</source>
        <translation>à gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>à droite</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>au centre</translation>
    </message>
    <message>
        <source>1 o&apos;clock</source>
        <translation>une heure</translation>
    </message>
    <message>
        <source>2 o&apos;clock</source>
        <translation>deux heures</translation>
    </message>
    <message>
        <source>3 o&apos;clock</source>
        <translation>trois heures</translation>
    </message>
    <message>
        <source>4 o&apos;clock</source>
        <translation>quatre heures</translation>
    </message>
    <message>
        <source>5 o&apos;clock</source>
        <translation>cinq heures</translation>
    </message>
    <message>
        <source>6 o&apos;clock</source>
        <translation>six heures</translation>
    </message>
    <message>
        <source>7 o&apos;clock</source>
        <translation>sept heures</translation>
    </message>
    <message>
        <source>8 o&apos;clock</source>
        <translation>huit heures</translation>
    </message>
    <message>
        <source>9 o&apos;clock</source>
        <translation>neuf heures</translation>
    </message>
    <message>
        <source>10 o&apos;clock</source>
        <translation>dix heures</translation>
    </message>
    <message>
        <source>11 o&apos;clock</source>
        <translation>onze heures</translation>
    </message>
    <message>
        <source>12 o&apos;clock</source>
        <translation>midi</translation>
    </message>
    <message>
        <source>go straight on</source>
        <translation>continuez tout droit</translation>
    </message>
    <message>
        <source>turn to %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>tournez vers %1</translation>
    </message>
    <message>
        <source>turn to %1</source>
        <translation>tournez vers %1</translation>
    </message>
    <message>
        <source>turn around</source>
        <translation>faites demi-tour</translation>
    </message>
    <message>
        <source>turn %1 degrees to the left</source>
        <translation>tournez de %1 degrés à gauche</translation>
    </message>
    <message>
        <source>turn %1 degrees to the right</source>
        <translation>tournez de %1 degrés à droite</translation>
    </message>
    <message>
        <source>turn slightly left</source>
        <translation>tournez légèrement à gauche</translation>
    </message>
    <message>
        <source>turn left</source>
        <translation>tournez à gauche</translation>
    </message>
    <message>
        <source>turn sharply left</source>
        <translation>tournez fortement à gauche</translation>
    </message>
    <message>
        <source>turn slightly right</source>
        <translation>tournez légèrement à droite</translation>
    </message>
    <message>
        <source>turn right</source>
        <translation>tournez à droite</translation>
    </message>
    <message>
        <source>turn sharply right</source>
        <translation>tournez fortement à droite</translation>
    </message>
    <message>
        <source>turn slightly left</source>
        <comment>on the spot</comment>
        <translation>tournez-vous légèrement vers la gauche</translation>
    </message>
    <message>
        <source>turn left</source>
        <comment>on the spot</comment>
        <translation>tournez-vous vers la gauche</translation>
    </message>
    <message>
        <source>turn sharply left</source>
        <comment>on the spot</comment>
        <translation>tournez-vous fortement vers la gauche</translation>
    </message>
    <message>
        <source>turn slightly right</source>
        <comment>on the spot</comment>
        <translation>tournez-vous légèrement vers la droite</translation>
    </message>
    <message>
        <source>turn right</source>
        <comment>on the spot</comment>
        <translation>tournez-vous vers la droite</translation>
    </message>
    <message>
        <source>turn sharply right</source>
        <comment>on the spot</comment>
        <translation>tournez-vous fortement vers la droite</translation>
    </message>
    <message>
        <source>turning to %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>en tournant vers %1</translation>
    </message>
    <message>
        <source>turning to %1</source>
        <translation>en tournant vers %1</translation>
    </message>
    <message>
        <source>turning around</source>
        <translation>en faisant demi-tour</translation>
    </message>
    <message>
        <source>turning %1 degrees to the left</source>
        <translation>en tournant de %1 degrés à gauche</translation>
    </message>
    <message>
        <source>turning %1 degrees to the right</source>
        <translation>en tournant de %1 degrés à droite</translation>
    </message>
    <message>
        <source>turning slightly left</source>
        <translation>en tournant légèrement à gauche</translation>
    </message>
    <message>
        <source>turning left</source>
        <translation>en tournant à gauche</translation>
    </message>
    <message>
        <source>turning sharply left</source>
        <translation>en tournant fortement à gauche</translation>
    </message>
    <message>
        <source>turning slightly right</source>
        <translation>en tournant légèrement à droite</translation>
    </message>
    <message>
        <source>turning right</source>
        <translation>en tournant à droite</translation>
    </message>
    <message>
        <source>turning sharply right</source>
        <translation>en tournant fortement à droite</translation>
    </message>
    <message>
        <source>on your left</source>
        <translation>à votre gauche</translation>
    </message>
    <message>
        <source>on your right</source>
        <translation>à votre droite</translation>
    </message>
    <message>
        <source>at %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>à %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>à %1</translation>
    </message>
    <message>
        <source>straight ahead</source>
        <translation>droit devant vous</translation>
    </message>
    <message>
        <source>behind you</source>
        <translation>derrière vous</translation>
    </message>
    <message>
        <source>%1 degrees to your right</source>
        <translation>à %1 degrés sur votre droite</translation>
    </message>
    <message>
        <source>%1 degrees to your left</source>
        <translation>à %1 degrés sur votre gauche</translation>
    </message>
    <message>
        <source>ahead, slightly to your right</source>
        <translation>devant vous, légèrement à droite</translation>
    </message>
    <message>
        <source>behind you, on the right</source>
        <translation>derrière vous, à droite</translation>
    </message>
    <message>
        <source>behind you, on the left</source>
        <translation>derrière vous, à gauche</translation>
    </message>
    <message>
        <source>ahead, slightly to your left</source>
        <translation>devant vous, légèrement à gauche</translation>
    </message>
    <message>
        <source>first</source>
        <comment>door or opening</comment>
        <translation>première</translation>
    </message>
    <message>
        <source>second</source>
        <comment>door or opening</comment>
        <translation>deuxième</translation>
    </message>
    <message>
        <source>third</source>
        <comment>door or opening</comment>
        <translation>troisième</translation>
    </message>
    <message>
        <source>fourth</source>
        <comment>door or opening</comment>
        <translation>quatrième</translation>
    </message>
    <message>
        <source>fifth</source>
        <comment>door or opening</comment>
        <translation>cinquième</translation>
    </message>
    <message>
        <source>sixth</source>
        <comment>door or opening</comment>
        <translation>sixième</translation>
    </message>
    <message>
        <source>seventh</source>
        <comment>door or opening</comment>
        <translation>septième</translation>
    </message>
    <message>
        <source>eighth</source>
        <comment>door or opening</comment>
        <translation>huitième</translation>
    </message>
    <message>
        <source>after the extinguisher</source>
        <translation>après l&apos;extincteur</translation>
    </message>
    <message>
        <source>after the drinking fountain</source>
        <translation>après la fontaine à eau</translation>
    </message>
    <message>
        <source>after the hydrant</source>
        <translation>après la bouche d&apos;incendie</translation>
    </message>
    <message>
        <source>after the vending machine</source>
        <translation>après le distributeur automatique</translation>
    </message>
    <message>
        <source>after the waste bin</source>
        <translation>après la poubelle</translation>
    </message>
    <message>
        <source>after the plant</source>
        <translation>après la plante</translation>
    </message>
    <message>
        <source>after the locker</source>
        <translation>après le casier</translation>
    </message>
    <message>
        <source>a room</source>
        <translation>une salle</translation>
    </message>
    <message>
        <source>a corridor</source>
        <translation>un couloir</translation>
    </message>
    <message>
        <source>a hall</source>
        <translation>un hall</translation>
    </message>
    <message>
        <source>a stairwell</source>
        <translation>une cage d&apos;escalier</translation>
    </message>
    <message>
        <source>a toilet</source>
        <translation>des toilettes</translation>
    </message>
    <message>
        <source>outside the building</source>
        <translation>hors du bâtiment</translation>
    </message>
    <message>
        <source>to the north-east</source>
        <translation>au nord-est</translation>
    </message>
    <message>
        <source>to the east</source>
        <translation>à l&apos;est</translation>
    </message>
    <message>
        <source>to the south-east</source>
        <translation>au sud-est</translation>
    </message>
    <message>
        <source>to the south</source>
        <translation>au sud</translation>
    </message>
    <message>
        <source>to the south-west</source>
        <translation>au sud-ouest</translation>
    </message>
    <message>
        <source>to the west</source>
        <translation>à l&apos;ouest</translation>
    </message>
    <message>
        <source>to the north-west</source>
        <translation>au nord-ouest</translation>
    </message>
    <message>
        <source>to the north</source>
        <translation>au nord</translation>
    </message>
    <message>
        <source>Stop.</source>
        <extracomment>To somebody who walks, or is opening a door</extracomment>
        <translation>Arrêtez-vous.</translation>
    </message>
</context>
<context>
    <name>farol::ui::PictureReel</name>
    <message>
        <source>There are no pictures in %1.</source>
        <translation>Il n&apos;y a pas d&apos;images dans %1.</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlaceChooser</name>
    <message>
        <source>No such place</source>
        <translation>Ce lieu n&apos;existe pas</translation>
    </message>
    <message numerus="yes">
        <source>%n places fit: choose one</source>
        <translation>
            <numerusform>%n lieu correspond&#xa0;: choisissez-le</numerusform>
            <numerusform>%n lieux correspondent&#xa0;: choisissez-en un</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Go to:</source>
        <translation>&amp;Aller à&#xa0;:</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destination</translation>
    </message>
    <message>
        <source>type a name or room number</source>
        <translation>tapez un nom ou un numéro de salle</translation>
    </message>
    <message>
        <source>Where to go: type part of a name, room number or level, then choose</source>
        <translation>Où aller&#xa0;: tapez une partie d&apos;un nom, d&apos;un numéro de salle ou d&apos;un niveau, puis choisissez</translation>
    </message>
    <message>
        <source>Start &amp;at:</source>
        <translation>&amp;Partir de&#xa0;:</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>not known, Farol looks for it</source>
        <translation>inconnu, Farol le cherche</translation>
    </message>
    <message>
        <source>Where the walk starts, if you know it</source>
        <translation>Où commence le parcours, si vous le savez</translation>
    </message>
    <message>
        <source>F&amp;rom:</source>
        <translation>&amp;De&#xa0;:</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Where the route begins: type part of a name, room number or level, then choose</source>
        <translation>Où commence l&apos;itinéraire&#xa0;: tapez une partie d&apos;un nom, d&apos;un numéro de salle ou d&apos;un niveau, puis choisissez</translation>
    </message>
    <message>
        <source>&amp;To:</source>
        <translation>&amp;À&#xa0;:</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Where the route ends: type part of a name, room number or level, then choose</source>
        <translation>Où finit l&apos;itinéraire&#xa0;: tapez une partie d&apos;un nom, d&apos;un numéro de salle ou d&apos;un niveau, puis choisissez</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Type part of a name, room number or level, then choose</source>
        <translation>Tapez une partie d&apos;un nom, d&apos;un numéro de salle ou d&apos;un niveau, puis choisissez</translation>
    </message>
    <message>
        <source>Clear the line</source>
        <translation>Effacer la ligne</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlanLegend</name>
    <message>
        <source>no landmark</source>
        <translation>sans repère</translation>
    </message>
    <message>
        <source>looks like another place</source>
        <translation>ressemble à un autre lieu</translation>
    </message>
    <message>
        <source>a landmark here helps most</source>
        <translation>un repère aide le plus ici</translation>
    </message>
    <message>
        <source>not joined with the rest</source>
        <translation>non relié au reste</translation>
    </message>
    <message>
        <source>Legend: %1</source>
        <translation>Légende&#xa0;: %1</translation>
    </message>
    <message>
        <source>sees no landmark</source>
        <translation>n&apos;en voit aucun</translation>
    </message>
    <message>
        <source>sees one</source>
        <translation>voit un repère</translation>
    </message>
    <message>
        <source>sees several</source>
        <translation>en voit plusieurs</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlanPanel</name>
    <message>
        <source>No map is open.</source>
        <translation>Aucune carte n&apos;est ouverte.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n region(s), %2</source>
        <translation>
            <numerusform>%1&#xa0;: %n région, %2</numerusform>
            <numerusform>%1&#xa0;: %n régions, %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>%n repère</numerusform>
            <numerusform>%n repères</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Level:</source>
        <translation>&amp;Niveau&#xa0;:</translation>
    </message>
    <message>
        <source>Level of the plan</source>
        <translation>Niveau du plan</translation>
    </message>
    <message>
        <source>The floor that the plan shows (Page Up and Page Down in the plan)</source>
        <translation>L&apos;étage que montre le plan (Page préc. et Page suiv. sur le plan)</translation>
    </message>
    <message>
        <source>Larger (+)</source>
        <translation>Plus grand (+)</translation>
    </message>
    <message>
        <source>Smaller (-)</source>
        <translation>Plus petit (-)</translation>
    </message>
    <message>
        <source>Show the whole floor (0)</source>
        <translation>Montrer tout l&apos;étage (0)</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Drag to move, turn the wheel to zoom. What is chosen can be dragged, or moved by Alt and the arrows</source>
        <translation>Glissez pour déplacer, tournez la molette pour zoomer. La sélection peut être glissée, ou déplacée par Alt et les flèches</translation>
    </message>
</context>
<context>
    <name>farol::ui::ProfileMenu</name>
    <message>
        <source>Usual</source>
        <translation>Habituel</translation>
    </message>
    <message>
        <source>Use the settings of %1</source>
        <translation>Utiliser les réglages de %1</translation>
    </message>
    <message>
        <source>&amp;New user…</source>
        <translation>&amp;Nouvel utilisateur…</translation>
    </message>
    <message>
        <source>New user</source>
        <translation>Nouvel utilisateur</translation>
    </message>
    <message>
        <source>Name; the new user begins with the settings as they are now:</source>
        <translation>Nom&#xa0;; le nouvel utilisateur commence avec les réglages actuels&#xa0;:</translation>
    </message>
    <message>
        <source>“%1” cannot be used as a name: it must not hold a slash.</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas servir de nom&#xa0;: il ne doit pas contenir de barre oblique.</translation>
    </message>
    <message>
        <source>&amp;User</source>
        <translation>&amp;Utilisateur</translation>
    </message>
</context>
<context>
    <name>farol::ui::RegionDialog</name>
    <message>
        <source>Region %1</source>
        <translation>Région %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>What is spoken</source>
        <translation>Ce qui est dit</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>The number on the door</source>
        <translation>Le numéro sur la porte</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>What sort of place it is</source>
        <translation>De quelle sorte de lieu il s&apos;agit</translation>
    </message>
    <message>
        <source>Restricted</source>
        <translation>Restreint</translation>
    </message>
    <message>
        <source>Not open to everyone</source>
        <translation>Pas ouvert à tous</translation>
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
            <numerusform>%n erreur</numerusform>
            <numerusform>%n erreurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n avertissement</numerusform>
            <numerusform>%n avertissements</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n remarque</numerusform>
            <numerusform>%n remarques</numerusform>
        </translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>Aucune carte n&apos;est ouverte.</translation>
    </message>
    <message>
        <source>The map was changed after this check: %1.</source>
        <translation>La carte a changé après cette vérification&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Nothing is wrong with this map.</source>
        <translation>Rien ne cloche dans cette carte.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>What is wrong with the map; choose a finding to see its place on the plan</source>
        <translation>Ce qui ne va pas dans la carte&#xa0;; choisissez un constat pour voir son emplacement sur le plan</translation>
    </message>
    <message>
        <source>The finding in words</source>
        <translation>Le constat en mots</translation>
    </message>
    <message>
        <source>The finding in words, and what to do</source>
        <translation>Le constat en mots, et que faire</translation>
    </message>
    <message>
        <source>Chec&amp;k again</source>
        <translation>&amp;Vérifier de nouveau</translation>
    </message>
    <message>
        <source>Look for what is wrong with the map as it is now (F7)</source>
        <translation>Chercher ce qui ne va pas dans la carte telle qu&apos;elle est (F7)</translation>
    </message>
    <message>
        <source>Choose a finding to read what it means and what to do.</source>
        <translation>Choisissez un résultat pour lire ce qu&apos;il signifie et que faire.</translation>
    </message>
    <message>
        <source>Ne&amp;xt place</source>
        <translation>Lieu sui&amp;vant</translation>
    </message>
    <message>
        <source>Show the next place of this finding (F4)</source>
        <translation>Montrer le lieu suivant de ce résultat (F4)</translation>
    </message>
</context>
<context>
    <name>farol::ui::RevoteDialog</name>
    <message>
        <source>&amp;Compare</source>
        <translation>C&amp;omparer</translation>
    </message>
    <message>
        <source>Work out a recorded walk anew</source>
        <translation>Recalculer un parcours enregistré</translation>
    </message>
    <message>
        <source>Folder of the recorded walk</source>
        <translation>Dossier du parcours enregistré</translation>
    </message>
    <message>
        <source>Where the recorded walk is kept</source>
        <translation>Où est gardé le parcours enregistré</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Parcourir…</translation>
    </message>
    <message>
        <source>Browse for the recorded walk</source>
        <translation>Chercher le parcours enregistré</translation>
    </message>
    <message>
        <source>Folder of a recorded walk</source>
        <translation>Dossier d&apos;un parcours enregistré</translation>
    </message>
    <message>
        <source>How the place is worked out now</source>
        <translation>Comment le lieu est trouvé maintenant</translation>
    </message>
    <message>
        <source>What the recorded walk is worked out with the second time</source>
        <translation>Avec quoi le parcours enregistré est calculé la seconde fois</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Work the walk out as it was, and once more with the other choice</source>
        <translation>Calculer le parcours tel qu&apos;il était, et encore une fois avec l&apos;autre choix</translation>
    </message>
    <message>
        <source>The pictures are not looked at again: what was recognised then is taken, and the place is worked out anew.</source>
        <translation>Les images ne sont pas regardées de nouveau&#xa0;: on prend ce qui fut reconnu alors, et le lieu est recalculé.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Maintenant</translation>
    </message>
    <message>
        <source>Where the two differ</source>
        <translation>Où les deux diffèrent</translation>
    </message>
    <message>
        <source>&amp;Recorded walk:</source>
        <translation>Parcours &amp;enregistré&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Worked out by:</source>
        <translation>&amp;Calculé par&#xa0;:</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Travail en cours…</translation>
    </message>
    <message>
        <source>%1 before, %2 now. The same place on %3 of %4 pictures (%5 %). Sentences: %6 before, %7 now.</source>
        <translation>%1 avant, %2 maintenant. Le même lieu sur %3 images sur %4 (%5 %). Phrases&#xa0;: %6 avant, %7 maintenant.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
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
        <translation>Partez d&apos;ici&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Que faire</translation>
    </message>
</context>
<context>
    <name>farol::ui::RoutePanel</name>
    <message>
        <source>No map is open.</source>
        <translation>Aucune carte n&apos;est ouverte.</translation>
    </message>
    <message>
        <source>Looking for the way…</source>
        <translation>Recherche du chemin…</translation>
    </message>
    <message>
        <source>There is no way. %1</source>
        <translation>Il n&apos;y a pas de chemin. %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 m, about %n minute(s), through %2.</source>
        <translation>
            <numerusform>%1 m, environ %n minute, par %2.</numerusform>
            <numerusform>%1 m, environ %n minutes, par %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n door(s) and passage(s)</source>
        <translation>
            <numerusform>%n porte ou passage</numerusform>
            <numerusform>%n portes et passages</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose where the route begins and ends, here or by the menu of a place on the plan.</source>
        <translation>Choisissez où l&apos;itinéraire commence et finit, ici ou par le menu d&apos;un lieu sur le plan.</translation>
    </message>
    <message>
        <source>Swa&amp;p</source>
        <translation>In&amp;verser</translation>
    </message>
    <message>
        <source>The way back: exchange where the route begins and ends</source>
        <translation>Le retour&#xa0;: échanger le début et la fin de l&apos;itinéraire</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>Éviter</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>escaliers</translation>
    </message>
    <message>
        <source>Find a way without stairs</source>
        <translation>Trouver un chemin sans escaliers</translation>
    </message>
    <message>
        <source>lifts</source>
        <translation>ascenseurs</translation>
    </message>
    <message>
        <source>Find a way without lifts</source>
        <translation>Trouver un chemin sans ascenseurs</translation>
    </message>
    <message>
        <source>escalators</source>
        <translation>escaliers mécaniques</translation>
    </message>
    <message>
        <source>Find a way without escalators</source>
        <translation>Trouver un chemin sans escaliers mécaniques</translation>
    </message>
    <message>
        <source>restricted regions</source>
        <translation>régions restreintes</translation>
    </message>
    <message>
        <source>Find a way that is open to everyone</source>
        <translation>Trouver un chemin ouvert à tous</translation>
    </message>
    <message>
        <source>Sentences of the route</source>
        <translation>Phrases de l&apos;itinéraire</translation>
    </message>
    <message>
        <source>What the walker hears; choose a sentence to see its place on the plan</source>
        <translation>Ce qu&apos;entend la personne qui marche&#xa0;; choisissez une phrase pour voir son emplacement sur le plan</translation>
    </message>
</context>
<context>
    <name>farol::ui::RuleWords</name>
    <message>
        <source>Outlines that are no proper outline</source>
        <translation>Contours qui n&apos;en sont pas</translation>
    </message>
    <message>
        <source>Draw the outline again so that it does not cross itself.</source>
        <translation>Redessinez le contour pour qu&apos;il ne se croise pas lui-même.</translation>
    </message>
    <message>
        <source>Regions that share an id</source>
        <translation>Régions qui partagent un identifiant</translation>
    </message>
    <message>
        <source>Give each region an id of its own.</source>
        <translation>Donnez à chaque région son propre identifiant.</translation>
    </message>
    <message>
        <source>Names that nobody can say</source>
        <translation>Noms que personne ne peut dire</translation>
    </message>
    <message>
        <source>Give the region the name that people use; this one is never spoken.</source>
        <translation>Donnez à la région le nom que les gens emploient&#xa0;; celui-ci n&apos;est jamais dit.</translation>
    </message>
    <message>
        <source>Doors that share an id</source>
        <translation>Portes qui partagent un identifiant</translation>
    </message>
    <message>
        <source>Give each door or passage an id of its own.</source>
        <translation>Donnez à chaque porte ou passage son propre identifiant.</translation>
    </message>
    <message>
        <source>Landmarks that share an id</source>
        <translation>Repères qui partagent un identifiant</translation>
    </message>
    <message>
        <source>Give each landmark an id of its own.</source>
        <translation>Donnez à chaque repère son propre identifiant.</translation>
    </message>
    <message>
        <source>Doors that do not join two regions</source>
        <translation>Portes qui ne relient pas deux régions</translation>
    </message>
    <message>
        <source>Choose the region on each side of the door.</source>
        <translation>Choisissez la région de chaque côté de la porte.</translation>
    </message>
    <message>
        <source>Doors to regions that do not exist</source>
        <translation>Portes vers des régions qui n&apos;existent pas</translation>
    </message>
    <message>
        <source>Choose regions that are on the map for both sides.</source>
        <translation>Choisissez pour les deux côtés des régions de la carte.</translation>
    </message>
    <message>
        <source>Doors far from the regions they join</source>
        <translation>Portes loin des régions qu&apos;elles relient</translation>
    </message>
    <message>
        <source>Move the door to where the two regions meet.</source>
        <translation>Déplacez la porte là où les deux régions se touchent.</translation>
    </message>
    <message>
        <source>Doors drawn on fewer or more than two regions</source>
        <translation>Portes dessinées sur moins ou plus de deux régions</translation>
    </message>
    <message>
        <source>Doors beside more than two regions</source>
        <translation>Portes à côté de plus de deux régions</translation>
    </message>
    <message>
        <source>See that the two sides are the right ones.</source>
        <translation>Vérifiez que les deux côtés sont les bons.</translation>
    </message>
    <message>
        <source>Passages drawn along the way instead of across it</source>
        <translation>Passages dessinés le long du chemin au lieu d&apos;en travers</translation>
    </message>
    <message>
        <source>If one walks along the line, choose its two sides by hand.</source>
        <translation>Si l&apos;on marche le long de la ligne, choisissez ses deux côtés à la main.</translation>
    </message>
    <message>
        <source>Doors without a place on the map</source>
        <translation>Portes sans emplacement sur la carte</translation>
    </message>
    <message>
        <source>Draw them in the source, or put them in here.</source>
        <translation>Dessinez-les dans la source, ou placez-les ici.</translation>
    </message>
    <message>
        <source>Stairs or lifts that do not change the level</source>
        <translation>Escaliers ou ascenseurs qui ne changent pas de niveau</translation>
    </message>
    <message>
        <source>Choose regions of two levels, or another kind.</source>
        <translation>Choisissez des régions de deux niveaux, ou un autre type.</translation>
    </message>
    <message>
        <source>Parts of the building that no way joins</source>
        <translation>Parties du bâtiment qu&apos;aucun chemin ne relie</translation>
    </message>
    <message>
        <source>Put in the door, stairs or lift that joins them.</source>
        <translation>Placez la porte, l&apos;escalier ou l&apos;ascenseur qui les relie.</translation>
    </message>
    <message>
        <source>Regions without any door</source>
        <translation>Régions sans aucune porte</translation>
    </message>
    <message>
        <source>Put in the door that leads there.</source>
        <translation>Placez la porte qui y mène.</translation>
    </message>
    <message>
        <source>Regions without a name</source>
        <translation>Régions sans nom</translation>
    </message>
    <message>
        <source>Give them the name that people use.</source>
        <translation>Donnez-leur le nom que les gens emploient.</translation>
    </message>
    <message>
        <source>Regions of one level with the same number</source>
        <translation>Régions d&apos;un niveau avec le même numéro</translation>
    </message>
    <message>
        <source>Correct the number of one of them.</source>
        <translation>Corrigez le numéro de l&apos;une d&apos;elles.</translation>
    </message>
    <message>
        <source>Regions as narrow as a wall</source>
        <translation>Régions aussi étroites qu&apos;un mur</translation>
    </message>
    <message>
        <source>Join them with their neighbour in the source.</source>
        <translation>Réunissez-les avec leur voisine dans la source.</translation>
    </message>
    <message>
        <source>Regions that overlap</source>
        <translation>Régions qui se chevauchent</translation>
    </message>
    <message>
        <source>Draw the border between them in the source.</source>
        <translation>Dessinez la limite entre elles dans la source.</translation>
    </message>
    <message>
        <source>Regions inside other regions</source>
        <translation>Régions à l&apos;intérieur d&apos;autres régions</translation>
    </message>
    <message>
        <source>Cut the smaller one out of the larger one, unless it is a part of it.</source>
        <translation>Découpez la plus petite dans la plus grande, sauf si elle en fait partie.</translation>
    </message>
    <message>
        <source>Regions drawn twice</source>
        <translation>Régions dessinées deux fois</translation>
    </message>
    <message>
        <source>Remove one of them in the source.</source>
        <translation>Retirez-en une dans la source.</translation>
    </message>
    <message>
        <source>Regions in several parts</source>
        <translation>Régions en plusieurs parties</translation>
    </message>
    <message>
        <source>Each part became a region; give the parts names of their own.</source>
        <translation>Chaque partie est devenue une région&#xa0;; donnez-leur des noms propres.</translation>
    </message>
    <message>
        <source>Landmarks in regions that do not exist</source>
        <translation>Repères dans des régions qui n&apos;existent pas</translation>
    </message>
    <message>
        <source>Move the landmark into a region.</source>
        <translation>Déplacez le repère dans une région.</translation>
    </message>
    <message>
        <source>Landmarks outside their region</source>
        <translation>Repères hors de leur région</translation>
    </message>
    <message>
        <source>Move the landmark into its region.</source>
        <translation>Déplacez le repère dans sa région.</translation>
    </message>
    <message>
        <source>Landmarks that were given their region by their place</source>
        <translation>Repères dont la région a été déduite de leur emplacement</translation>
    </message>
    <message>
        <source>Levels that the list of levels does not name</source>
        <translation>Niveaux que la liste des niveaux ne nomme pas</translation>
    </message>
    <message>
        <source>Add the level to the list in the source.</source>
        <translation>Ajoutez le niveau à la liste dans la source.</translation>
    </message>
    <message>
        <source>Levels named twice</source>
        <translation>Niveaux nommés deux fois</translation>
    </message>
    <message>
        <source>Levels without a usable number</source>
        <translation>Niveaux sans numéro utilisable</translation>
    </message>
    <message>
        <source>Give the level a number in the source.</source>
        <translation>Donnez un numéro au niveau dans la source.</translation>
    </message>
    <message>
        <source>Features whose level was assumed</source>
        <translation>Éléments dont le niveau a été supposé</translation>
    </message>
    <message>
        <source>Add the level in the source.</source>
        <translation>Ajoutez le niveau dans la source.</translation>
    </message>
    <message>
        <source>Links between levels that lead nowhere</source>
        <translation>Liaisons entre niveaux qui ne mènent nulle part</translation>
    </message>
    <message>
        <source>Choose regions that are on the map.</source>
        <translation>Choisissez des régions de la carte.</translation>
    </message>
    <message>
        <source>Stairs and lifts joined because they lie above one another</source>
        <translation>Escaliers et ascenseurs reliés parce qu&apos;ils sont l&apos;un au-dessus de l&apos;autre</translation>
    </message>
    <message>
        <source>See that they really are one.</source>
        <translation>Vérifiez qu&apos;ils n&apos;en font vraiment qu&apos;un.</translation>
    </message>
    <message>
        <source>Stairs or lifts that leave out a level</source>
        <translation>Escaliers ou ascenseurs qui sautent un niveau</translation>
    </message>
    <message>
        <source>Add the stop, if there is one.</source>
        <translation>Ajoutez l&apos;arrêt, s&apos;il existe.</translation>
    </message>
    <message>
        <source>Kinds that are not known</source>
        <translation>Types inconnus</translation>
    </message>
    <message>
        <source>Choose one of the kinds that Farol knows.</source>
        <translation>Choisissez l&apos;un des types que Farol connaît.</translation>
    </message>
    <message>
        <source>Degrees where metres are meant</source>
        <translation>Des degrés là où il faut des mètres</translation>
    </message>
    <message>
        <source>See that the building has its right size.</source>
        <translation>Vérifiez que le bâtiment a sa vraie taille.</translation>
    </message>
    <message>
        <source>Metres where degrees are meant</source>
        <translation>Des mètres là où il faut des degrés</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not named</source>
        <translation>Le système de coordonnées n&apos;est pas nommé</translation>
    </message>
    <message>
        <source>Name the coordinate system in the source.</source>
        <translation>Nommez le système de coordonnées dans la source.</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not understood</source>
        <translation>Le système de coordonnées n&apos;est pas compris</translation>
    </message>
    <message>
        <source>Name a common coordinate system in the source.</source>
        <translation>Nommez un système de coordonnées courant dans la source.</translation>
    </message>
    <message>
        <source>Coordinates were converted to metres</source>
        <translation>Les coordonnées ont été converties en mètres</translation>
    </message>
    <message>
        <source>North and east were exchanged</source>
        <translation>Nord et est étaient échangés</translation>
    </message>
    <message>
        <source>Export the map again to be sure.</source>
        <translation>Exportez de nouveau la carte pour en avoir le cœur net.</translation>
    </message>
    <message>
        <source>Points that are no places</source>
        <translation>Points qui ne sont pas des lieux</translation>
    </message>
    <message>
        <source>See whether something is missing there.</source>
        <translation>Voyez s&apos;il manque quelque chose à cet endroit.</translation>
    </message>
    <message>
        <source>Features without a shape</source>
        <translation>Éléments sans forme</translation>
    </message>
    <message>
        <source>Draw them in the source if they are needed.</source>
        <translation>Dessinez-les dans la source s&apos;ils sont nécessaires.</translation>
    </message>
    <message>
        <source>Features without a usable shape</source>
        <translation>Éléments sans forme utilisable</translation>
    </message>
    <message>
        <source>Layers without features</source>
        <translation>Couches sans éléments</translation>
    </message>
    <message>
        <source>Layers whose meaning is not clear</source>
        <translation>Couches dont le sens n&apos;est pas clair</translation>
    </message>
    <message>
        <source>Say in a profile what the layer holds.</source>
        <translation>Dites dans un profil ce que contient la couche.</translation>
    </message>
    <message>
        <source>Layers that were not used</source>
        <translation>Couches qui n&apos;ont pas été utilisées</translation>
    </message>
    <message>
        <source>Codes without a meaning</source>
        <translation>Codes sans signification</translation>
    </message>
    <message>
        <source>Say in a profile what the code means.</source>
        <translation>Dites dans un profil ce que signifie le code.</translation>
    </message>
    <message>
        <source>Openings added where no wall stands between regions</source>
        <translation>Ouvertures ajoutées là où aucun mur ne sépare les régions</translation>
    </message>
    <message>
        <source>See that one can really walk through.</source>
        <translation>Vérifiez qu&apos;on peut vraiment passer.</translation>
    </message>
    <message>
        <source>Escalators without a direction</source>
        <translation>Escaliers mécaniques sans sens de marche</translation>
    </message>
    <message>
        <source>Say which way they run.</source>
        <translation>Dites dans quel sens ils fonctionnent.</translation>
    </message>
    <message>
        <source>Amenities without a known level</source>
        <translation>Équipements sans niveau connu</translation>
    </message>
    <message>
        <source>Name the level in the source.</source>
        <translation>Nommez le niveau dans la source.</translation>
    </message>
    <message>
        <source>Amenities without a place</source>
        <translation>Équipements sans emplacement</translation>
    </message>
    <message>
        <source>Give them a point in the source.</source>
        <translation>Donnez-leur un point dans la source.</translation>
    </message>
    <message>
        <source>Categories that are not known</source>
        <translation>Catégories inconnues</translation>
    </message>
    <message>
        <source>Levels without an id</source>
        <translation>Niveaux sans identifiant</translation>
    </message>
    <message>
        <source>Give the level an id in the source.</source>
        <translation>Donnez un identifiant au niveau dans la source.</translation>
    </message>
    <message>
        <source>Levels without an ordinal</source>
        <translation>Niveaux sans ordinal</translation>
    </message>
    <message>
        <source>Give the level an ordinal in the source.</source>
        <translation>Donnez un ordinal au niveau dans la source.</translation>
    </message>
    <message>
        <source>Parts of the IMDF archive that were not used</source>
        <translation>Parties de l&apos;archive IMDF qui n&apos;ont pas été utilisées</translation>
    </message>
    <message>
        <source>Walls, columns and voids drawn as units</source>
        <translation>Murs, colonnes et vides dessinés comme unités</translation>
    </message>
    <message>
        <source>Occupants without a place</source>
        <translation>Occupants sans emplacement</translation>
    </message>
    <message>
        <source>Name the anchor in the source.</source>
        <translation>Nommez l&apos;ancre dans la source.</translation>
    </message>
    <message>
        <source>Openings that are closed</source>
        <translation>Ouvertures qui sont fermées</translation>
    </message>
    <message>
        <source>Openings without a line</source>
        <translation>Ouvertures sans ligne</translation>
    </message>
    <message>
        <source>Draw the opening as a line in the source.</source>
        <translation>Dessinez l&apos;ouverture comme une ligne dans la source.</translation>
    </message>
    <message>
        <source>Relationships that do not name two units</source>
        <translation>Relations qui ne nomment pas deux unités</translation>
    </message>
    <message>
        <source>Name the two units in the source.</source>
        <translation>Nommez les deux unités dans la source.</translation>
    </message>
    <message>
        <source>Units without an outline</source>
        <translation>Unités sans contour</translation>
    </message>
    <message>
        <source>Draw the outline in the source.</source>
        <translation>Dessinez le contour dans la source.</translation>
    </message>
    <message>
        <source>Doors that stand on no outline</source>
        <translation>Portes qui ne sont sur aucun contour</translation>
    </message>
    <message>
        <source>Draw the door on the outline of its room.</source>
        <translation>Dessinez la porte sur le contour de sa salle.</translation>
    </message>
    <message>
        <source>Openings put where a way enters a room</source>
        <translation>Ouvertures placées là où un chemin entre dans une salle</translation>
    </message>
    <message>
        <source>Draw the door in the source.</source>
        <translation>Dessinez la porte dans la source.</translation>
    </message>
    <message>
        <source>Objects whose level is not clear</source>
        <translation>Objets dont le niveau n&apos;est pas clair</translation>
    </message>
    <message>
        <source>Objects far from every region</source>
        <translation>Objets loin de toute région</translation>
    </message>
    <message>
        <source>Draw the room they stand in.</source>
        <translation>Dessinez la salle où ils se trouvent.</translation>
    </message>
    <message>
        <source>Features without a level</source>
        <translation>Éléments sans niveau</translation>
    </message>
    <message>
        <source>Levels that cannot be read</source>
        <translation>Niveaux qui ne peuvent pas être lus</translation>
    </message>
    <message>
        <source>Correct the level in the source.</source>
        <translation>Corrigez le niveau dans la source.</translation>
    </message>
    <message>
        <source>Lifts without a door</source>
        <translation>Ascenseurs sans porte</translation>
    </message>
    <message>
        <source>Move the door to its place.</source>
        <translation>Déplacez la porte à sa place.</translation>
    </message>
    <message>
        <source>Lifts that are only a point</source>
        <translation>Ascenseurs qui ne sont qu&apos;un point</translation>
    </message>
    <message>
        <source>Steps that lead nowhere</source>
        <translation>Marches qui ne mènent nulle part</translation>
    </message>
    <message>
        <source>Draw the area or way that they lead to.</source>
        <translation>Dessinez la zone ou le chemin où elles mènent.</translation>
    </message>
    <message>
        <source>Steps that may go up or down</source>
        <translation>Marches qui peuvent monter ou descendre</translation>
    </message>
    <message>
        <source>Say in the source which end is up.</source>
        <translation>Dites dans la source quel bout est en haut.</translation>
    </message>
    <message>
        <source>Steps without a length</source>
        <translation>Marches sans longueur</translation>
    </message>
    <message>
        <source>Draw the line of the steps.</source>
        <translation>Dessinez la ligne des marches.</translation>
    </message>
    <message>
        <source>Cells that could not be used</source>
        <translation>Cellules inutilisables</translation>
    </message>
    <message>
        <source>Give each cell an outline and an id.</source>
        <translation>Donnez à chaque cellule un contour et un identifiant.</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not known</source>
        <translation>Le système de coordonnées est inconnu</translation>
    </message>
    <message>
        <source>Doors that do not lie between two rooms</source>
        <translation>Portes qui ne sont pas entre deux salles</translation>
    </message>
    <message>
        <source>Levels that nothing tells</source>
        <translation>Niveaux que rien n&apos;indique</translation>
    </message>
    <message>
        <source>Say where the level stands when importing.</source>
        <translation>Dites à l&apos;importation où se trouve le niveau.</translation>
    </message>
    <message>
        <source>Levels counted from the heights of the floors</source>
        <translation>Niveaux comptés d&apos;après la hauteur des sols</translation>
    </message>
    <message>
        <source>Storeys named by words</source>
        <translation>Étages nommés par des mots</translation>
    </message>
    <message>
        <source>Transitions that do not join two cells</source>
        <translation>Transitions qui ne relient pas deux cellules</translation>
    </message>
    <message>
        <source>Correct the transition in the source.</source>
        <translation>Corrigez la transition dans la source.</translation>
    </message>
    <message>
        <source>Entrances of facilities that are missing</source>
        <translation>Entrées d&apos;équipements manquants</translation>
    </message>
    <message>
        <source>Add the facility in the source.</source>
        <translation>Ajoutez l&apos;équipement dans la source.</translation>
    </message>
    <message>
        <source>Facilities that no entrance leads to</source>
        <translation>Équipements auxquels aucune entrée ne mène</translation>
    </message>
    <message>
        <source>Add the entrance in the source.</source>
        <translation>Ajoutez l&apos;entrée dans la source.</translation>
    </message>
    <message>
        <source>The number of the ground floor was assumed</source>
        <translation>Le numéro du rez-de-chaussée a été supposé</translation>
    </message>
    <message>
        <source>Say it when importing, if it is another one.</source>
        <translation>Dites-le à l&apos;importation, si c&apos;en est un autre.</translation>
    </message>
    <message>
        <source>Objects far from every node</source>
        <translation>Objets loin de tout nœud</translation>
    </message>
    <message>
        <source>Move the object in the source.</source>
        <translation>Déplacez l&apos;objet dans la source.</translation>
    </message>
    <message>
        <source>Links that do not join two nodes</source>
        <translation>Liaisons qui ne relient pas deux nœuds</translation>
    </message>
    <message>
        <source>Correct the link in the source.</source>
        <translation>Corrigez la liaison dans la source.</translation>
    </message>
    <message>
        <source>Nodes that could not be used</source>
        <translation>Nœuds inutilisables</translation>
    </message>
    <message>
        <source>Give each node a place and an id.</source>
        <translation>Donnez à chaque nœud un emplacement et un identifiant.</translation>
    </message>
    <message>
        <source>Nodes that no link leads to</source>
        <translation>Nœuds auxquels aucune liaison ne mène</translation>
    </message>
    <message>
        <source>Add the link in the source.</source>
        <translation>Ajoutez la liaison dans la source.</translation>
    </message>
    <message>
        <source>Nodes without a floor</source>
        <translation>Nœuds sans étage</translation>
    </message>
    <message>
        <source>Add the floor in the source.</source>
        <translation>Ajoutez l&apos;étage dans la source.</translation>
    </message>
    <message>
        <source>Regions made from a network of ways</source>
        <translation>Régions faites à partir d&apos;un réseau de chemins</translation>
    </message>
    <message>
        <source>Features of an unknown sort</source>
        <translation>Éléments d&apos;une sorte inconnue</translation>
    </message>
    <message>
        <source>Spaces closed from walls, doors and windows</source>
        <translation>Espaces fermés d&apos;après murs, portes et fenêtres</translation>
    </message>
    <message>
        <source>Give them names.</source>
        <translation>Donnez-leur des noms.</translation>
    </message>
    <message>
        <source>Doors with a space on one side only</source>
        <translation>Portes avec un espace d&apos;un seul côté</translation>
    </message>
    <message>
        <source>See whether a wall is missing, or the door leads outside.</source>
        <translation>Voyez s&apos;il manque un mur ou si la porte donne sur l&apos;extérieur.</translation>
    </message>
    <message>
        <source>Narrow strips between walls</source>
        <translation>Bandes étroites entre des murs</translation>
    </message>
    <message>
        <source>Directions of doors that are not understood</source>
        <translation>Sens de portes qui ne sont pas compris</translation>
    </message>
    <message>
        <source>Say which way one can pass.</source>
        <translation>Dites dans quel sens on peut passer.</translation>
    </message>
    <message>
        <source>Stairs or lifts to a level that nothing names</source>
        <translation>Escaliers ou ascenseurs vers un niveau que rien ne nomme</translation>
    </message>
    <message>
        <source>Choose the region on the other level.</source>
        <translation>Choisissez la région de l&apos;autre niveau.</translation>
    </message>
    <message>
        <source>Upper ends of stairs and lifts that are known already</source>
        <translation>Extrémités hautes d&apos;escaliers et d&apos;ascenseurs déjà connus</translation>
    </message>
    <message>
        <source>Levels counted from the heights of the shapes</source>
        <translation>Niveaux comptés d&apos;après la hauteur des formes</translation>
    </message>
    <message>
        <source>Moving walkways without a direction</source>
        <translation>Tapis roulants sans sens de marche</translation>
    </message>
    <message>
        <source>Say in the source which way they run.</source>
        <translation>Dites dans la source dans quel sens ils fonctionnent.</translation>
    </message>
    <message>
        <source>Moving walkways that lead nowhere</source>
        <translation>Tapis roulants qui ne mènent nulle part</translation>
    </message>
    <message>
        <source>Regions whose door joins two others</source>
        <translation>Régions dont la porte en relie deux autres</translation>
    </message>
    <message>
        <source>Correct the sides of the door, or put in another one.</source>
        <translation>Corrigez les côtés de la porte, ou placez-en une autre.</translation>
    </message>
    <message>
        <source>Something to look at</source>
        <translation>Quelque chose à regarder</translation>
    </message>
</context>
<context>
    <name>farol::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>As the computer is set</source>
        <translation>Comme l&apos;ordinateur</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Language of the window and of the voice</source>
        <translation>Langue de la fenêtre et de la voix</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Langue&#xa0;:</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Gauche et droite</translation>
    </message>
    <message>
        <source>Hours of a clock</source>
        <translation>Heures d&apos;une horloge</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Degrés</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Directions</translation>
    </message>
    <message>
        <source>How turns are told</source>
        <translation>Comment les tournants sont dits</translation>
    </message>
    <message>
        <source>&amp;Directions:</source>
        <translation>&amp;Directions&#xa0;:</translation>
    </message>
    <message>
        <source>The way only</source>
        <translation>Le chemin seulement</translation>
    </message>
    <message>
        <source>The way and objects</source>
        <translation>Le chemin et les objets</translation>
    </message>
    <message>
        <source>The way, objects and texts</source>
        <translation>Le chemin, les objets et les textes</translation>
    </message>
    <message>
        <source>What is told</source>
        <translation>Ce qui est dit</translation>
    </message>
    <message>
        <source>How much is told on the way</source>
        <translation>Combien on en dit en chemin</translation>
    </message>
    <message>
        <source>&amp;What is told:</source>
        <translation>&amp;Ce qui est dit&#xa0;:</translation>
    </message>
    <message>
        <source>The first that works</source>
        <translation>Le premier qui marche</translation>
    </message>
    <message>
        <source>Speech program</source>
        <translation>Programme de parole</translation>
    </message>
    <message>
        <source>Which speech program of this computer speaks</source>
        <translation>Quel programme de parole de cet ordinateur parle</translation>
    </message>
    <message>
        <source>&amp;Speech program:</source>
        <translation>&amp;Programme de parole&#xa0;:</translation>
    </message>
    <message>
        <source>What fits the language</source>
        <translation>Celle qui va avec la langue</translation>
    </message>
    <message>
        <source>Voice</source>
        <translation>Voix</translation>
    </message>
    <message>
        <source>Press “List voices” to choose among those of the speech program</source>
        <translation>Appuyez sur «&#xa0;Lister les voix&#xa0;» pour choisir parmi celles du programme de parole</translation>
    </message>
    <message>
        <source>List &amp;voices</source>
        <translation>Lister les &amp;voix</translation>
    </message>
    <message>
        <source>List voices</source>
        <translation>Lister les voix</translation>
    </message>
    <message>
        <source>Ask the speech program for its voices; this can take some seconds</source>
        <translation>Demander ses voix au programme de parole&#xa0;; cela peut prendre quelques secondes</translation>
    </message>
    <message>
        <source>V&amp;oice:</source>
        <translation>V&amp;oix&#xa0;:</translation>
    </message>
    <message>
        <source>Speed of the voice</source>
        <translation>Vitesse de la voix</translation>
    </message>
    <message>
        <source>Slow on the left, fast on the right</source>
        <translation>Lente à gauche, rapide à droite</translation>
    </message>
    <message>
        <source>S&amp;peed of the voice:</source>
        <translation>Vit&amp;esse de la voix&#xa0;:</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Volume sonore</translation>
    </message>
    <message>
        <source>How loud the voice is</source>
        <translation>À quel volume parle la voix</translation>
    </message>
    <message>
        <source>Lo&amp;udness:</source>
        <translation>Vol&amp;ume&#xa0;:</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Dossier des enregistrements</translation>
    </message>
    <message>
        <source>Where recorded walks are kept</source>
        <translation>Où sont gardés les parcours enregistrés</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>P&amp;arcourir…</translation>
    </message>
    <message>
        <source>Browse for the folder of recordings</source>
        <translation>Chercher le dossier des enregistrements</translation>
    </message>
    <message>
        <source>Choose where recorded walks are kept</source>
        <translation>Choisir où sont gardés les parcours enregistrés</translation>
    </message>
    <message>
        <source>&amp;Recordings:</source>
        <translation>Enre&amp;gistrements&#xa0;:</translation>
    </message>
    <message>
        <source>Pages of the settings</source>
        <translation>Pages des réglages</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>Guidage</translation>
    </message>
    <message>
        <source>When something is said. From the next start of a walk.</source>
        <translation>Quand quelque chose est dit. Dès le prochain départ d&apos;un parcours.</translation>
    </message>
    <message>
        <source>Routes</source>
        <translation>Itinéraires</translation>
    </message>
    <message>
        <source>Which way is chosen. From the next start of a walk.</source>
        <translation>Quel chemin est choisi. Dès le prochain départ d&apos;un parcours.</translation>
    </message>
    <message>
        <source>Recognition</source>
        <translation>Reconnaissance</translation>
    </message>
    <message>
        <source>How sure a landmark must be before it counts. Lower figures find more, and more that is wrong: leave them unless you can check. From the next start of a walk.</source>
        <translation>Combien un repère doit être sûr pour compter. Des chiffres plus bas trouvent davantage, et plus d&apos;erreurs&#xa0;: laissez-les, à moins de pouvoir vérifier. Dès le prochain départ d&apos;un parcours.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Light or dark windows</source>
        <translation>Fenêtres claires ou sombres</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>C&amp;ouleurs&#xa0;:</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distances</translation>
    </message>
    <message>
        <source>How distances are told</source>
        <translation>Comment les distances sont dites</translation>
    </message>
    <message>
        <source>Dis&amp;tances:</source>
        <translation>Dis&amp;tances&#xa0;:</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
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
        <translation>&amp;Numéro de caméra</translation>
    </message>
    <message>
        <source>&amp;Video file</source>
        <translation>&amp;Fichier vidéo</translation>
    </message>
    <message>
        <source>&amp;Folder of pictures</source>
        <translation>&amp;Dossier d&apos;images</translation>
    </message>
    <message>
        <source>Network &amp;address</source>
        <translation>&amp;Adresse réseau</translation>
    </message>
    <message>
        <source>Open pictures</source>
        <translation>Ouvrir des images</translation>
    </message>
    <message>
        <source>Camera number</source>
        <translation>Numéro de caméra</translation>
    </message>
    <message>
        <source>0 is the first camera of this computer</source>
        <translation>0 est la première caméra de cet ordinateur</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>Fichier vidéo</translation>
    </message>
    <message>
        <source>Folder of pictures</source>
        <translation>Dossier d&apos;images</translation>
    </message>
    <message>
        <source>Network address</source>
        <translation>Adresse réseau</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Images par seconde</translation>
    </message>
    <message>
        <source>How many pictures of the folder make a second</source>
        <translation>Combien d&apos;images du dossier font une seconde</translation>
    </message>
    <message>
        <source>Pictures a &amp;second:</source>
        <translation>Images par &amp;seconde&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Parcourir…</translation>
    </message>
    <message>
        <source>Browse for a video file</source>
        <translation>Chercher un fichier vidéo</translation>
    </message>
    <message>
        <source>B&amp;rowse…</source>
        <translation>Pa&amp;rcourir…</translation>
    </message>
    <message>
        <source>Browse for a folder</source>
        <translation>Chercher un dossier</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Ouvrir une vidéo</translation>
    </message>
    <message>
        <source>Videos (%1);;All files (%2)</source>
        <translation>Vidéos (%1);;Tous les fichiers (%2)</translation>
    </message>
    <message>
        <source>Open a folder of pictures</source>
        <translation>Ouvrir un dossier d&apos;images</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechDesk</name>
    <message>
        <source>Voice off: sentences are only shown</source>
        <translation>Voix coupée&#xa0;: les phrases sont seulement montrées</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechOutput</name>
    <message>
        <source>The voice starts with the first sentence.</source>
        <translation>La voix commence avec la première phrase.</translation>
    </message>
    <message>
        <source>The voice hangs: nothing may be heard. Choose another one in the settings.</source>
        <translation>La voix est bloquée&#xa0;: on n&apos;entend peut-être rien. Choisissez-en une autre dans les réglages.</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechQueue</name>
    <message>
        <source>There is nothing to repeat.</source>
        <translation>Il n&apos;y a rien à répéter.</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachPanel</name>
    <message>
        <source>Give up?</source>
        <translation>Renoncer&#xa0;?</translation>
    </message>
    <message>
        <source>What you have taught of this landmark will be lost.</source>
        <translation>Ce que vous avez appris de ce repère sera perdu.</translation>
    </message>
    <message>
        <source>&amp;Give it up</source>
        <translation>&amp;Renoncer</translation>
    </message>
    <message>
        <source>&amp;Keep it</source>
        <translation>Le &amp;garder</translation>
    </message>
    <message>
        <source>Add a view first.</source>
        <translation>Ajoutez d&apos;abord une vue.</translation>
    </message>
    <message>
        <source>Learning…</source>
        <translation>Apprentissage…</translation>
    </message>
    <message>
        <source>A new landmark</source>
        <translation>Un nouveau repère</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Ce que c&apos;est</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Étape %1 sur %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminé</translation>
    </message>
    <message>
        <source>&amp;Save it</source>
        <translation>L&apos;&amp;enregistrer</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Continuer</translation>
    </message>
    <message>
        <source>Go back to the library</source>
        <translation>Revenir à la bibliothèque</translation>
    </message>
    <message>
        <source>Put it into the library</source>
        <translation>Le mettre dans la bibliothèque</translation>
    </message>
    <message>
        <source>The next step</source>
        <translation>L&apos;étape suivante</translation>
    </message>
    <message>
        <source>“%1” is in the library. Where does it hang? Put it on the map, so that Farol knows where you are when it is seen. The same landmark can hang in several places.</source>
        <translation>«&#xa0;%1&#xa0;» est dans la bibliothèque. Où est-il accroché&#xa0;? Mettez-le sur la carte, pour que Farol sache où vous êtes quand il le voit. Le même repère peut se trouver à plusieurs endroits.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Retour</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>The step before</source>
        <translation>L&apos;étape précédente</translation>
    </message>
    <message>
        <source>Put as&amp;ide</source>
        <translation>&amp;Mettre de côté</translation>
    </message>
    <message>
        <source>Put aside</source>
        <translation>Mettre de côté</translation>
    </message>
    <message>
        <source>Go back to the library and go on with this landmark later</source>
        <translation>Revenir à la bibliothèque et continuer plus tard avec ce repère</translation>
    </message>
    <message>
        <source>Give &amp;up</source>
        <translation>Reno&amp;ncer</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Renoncer</translation>
    </message>
    <message>
        <source>Forget this landmark</source>
        <translation>Oublier ce repère</translation>
    </message>
    <message>
        <source>Put it on the &amp;map…</source>
        <translation>Le mettre sur la c&amp;arte…</translation>
    </message>
    <message>
        <source>Put it on the map</source>
        <translation>Le mettre sur la carte</translation>
    </message>
    <message>
        <source>Choose its place on the Map page</source>
        <translation>Choisir son emplacement sur la page Carte</translation>
    </message>
    <message>
        <source>Teach an&amp;other</source>
        <translation>En apprendre un a&amp;utre</translation>
    </message>
    <message>
        <source>Teach another</source>
        <translation>En apprendre un autre</translation>
    </message>
    <message>
        <source>Teach the next landmark</source>
        <translation>Apprendre le repère suivant</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachSession</name>
    <message>
        <source>Give it a name first.</source>
        <translation>Donnez-lui d&apos;abord un nom.</translation>
    </message>
    <message>
        <source>Say what maps shall call it: letters and digits.</source>
        <translation>Dites comment les cartes l&apos;appelleront&#xa0;: lettres et chiffres.</translation>
    </message>
    <message>
        <source>“%1” is in the library already. Choose another name, or add views to that one.</source>
        <translation>«&#xa0;%1&#xa0;» est déjà dans la bibliothèque. Choisissez un autre nom, ou ajoutez des vues à celui-là.</translation>
    </message>
    <message>
        <source>there is no view yet</source>
        <translation>il n&apos;y a pas encore de photographie</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachTry</name>
    <message>
        <source>Folder of a recorded walk, or of pictures</source>
        <translation>Dossier d&apos;un parcours enregistré, ou d&apos;images</translation>
    </message>
    <message>
        <source>Found, %1 % sure.</source>
        <translation>Trouvé, sûr à %1 %.</translation>
    </message>
    <message>
        <source>About %1 m away.</source>
        <translation>À environ %1 m.</translation>
    </message>
    <message>
        <source>Not found.</source>
        <translation>Non trouvé.</translation>
    </message>
    <message>
        <source>Not found: %1.</source>
        <translation>Non trouvé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Also seen: %1.</source>
        <translation>Vu aussi&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Found in %1 of %2 pictures looked at.</source>
        <translation>Trouvé dans %1 images sur %2 regardées.</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>No picture yet.</source>
        <translation>Pas encore d&apos;image.</translation>
    </message>
    <message>
        <source>Looking how well it is found…</source>
        <translation>Vérification s&apos;il est bien trouvé…</translation>
    </message>
    <message>
        <source>Walk towards it, past it and away from it, or step through other pictures, and see whether Farol finds it. Go back to add views where it is lost.</source>
        <translation>Allez vers lui, passez devant et éloignez-vous, ou parcourez d&apos;autres images, et voyez si Farol le trouve. Revenez en arrière pour ajouter des vues là où il est perdu.</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Caméra</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Look for it with the camera of this computer</source>
        <translation>Le chercher avec la caméra de cet ordinateur</translation>
    </message>
    <message>
        <source>&amp;Recording…</source>
        <translation>&amp;Enregistrement…</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Look for it in a recorded walk, or in any folder of pictures</source>
        <translation>Le chercher dans un parcours enregistré, ou dans tout dossier d&apos;images</translation>
    </message>
    <message>
        <source>Pre&amp;vious picture</source>
        <translation>Image &amp;précédente</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Image précédente</translation>
    </message>
    <message>
        <source>The picture before</source>
        <translation>L&apos;image d&apos;avant</translation>
    </message>
    <message>
        <source>Ne&amp;xt picture</source>
        <translation>Image &amp;suivante</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Image suivante</translation>
    </message>
    <message>
        <source>The picture after</source>
        <translation>L&apos;image d&apos;après</translation>
    </message>
    <message>
        <source>Picture with what was recognised</source>
        <translation>Image avec ce qui est reconnu</translation>
    </message>
    <message>
        <source>What was recognised in this picture, and what nearly was</source>
        <translation>Ce qui a été reconnu dans cette image, et ce qui a failli l&apos;être</translation>
    </message>
    <message>
        <source>How well it will be found</source>
        <translation>S&apos;il sera bien trouvé</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachViews</name>
    <message>
        <source>No outline was found. Set the four corners yourself.</source>
        <translation>Aucun contour n&apos;a été trouvé. Placez vous-même les quatre coins.</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>Photographies</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (%2)</source>
        <translation>Images (%1);;Tous les fichiers (%2)</translation>
    </message>
    <message>
        <source>Folder of a recorded walk, or of pictures</source>
        <translation>Dossier d&apos;un parcours enregistré, ou d&apos;images</translation>
    </message>
    <message>
        <source>Learning this view…</source>
        <translation>Apprentissage de cette vue…</translation>
    </message>
    <message numerus="yes">
        <source>This picture is good: %n point(s).</source>
        <translation>
            <numerusform>Cette image est bonne&#xa0;: %n point.</numerusform>
            <numerusform>Cette image est bonne&#xa0;: %n points.</numerusform>
        </translation>
    </message>
    <message>
        <source>Coach: %1</source>
        <translation>Conseil&#xa0;: %1</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vue %1</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 sur %3)</translation>
    </message>
    <message>
        <source>Looking how well it is found…</source>
        <translation>Vérification s&apos;il est bien trouvé…</translation>
    </message>
    <message>
        <source>Nothing yet: add a view.</source>
        <translation>Rien encore&#xa0;: ajoutez une vue.</translation>
    </message>
    <message numerus="yes">
        <source>With the %n view(s) it had before.</source>
        <translation>
            <numerusform>Avec la %n vue qu&apos;il avait déjà.</numerusform>
            <numerusform>Avec les %n vues qu&apos;il avait déjà.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Caméra</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Take photographs with the camera of this computer</source>
        <translation>Prendre des photos avec la caméra de cet ordinateur</translation>
    </message>
    <message>
        <source>&amp;Pictures…</source>
        <translation>&amp;Images…</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Choose photographs from files</source>
        <translation>Choisir des photos dans des fichiers</translation>
    </message>
    <message>
        <source>&amp;Recording…</source>
        <translation>&amp;Enregistrement…</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Choose the folder of a recorded walk, or any folder of pictures</source>
        <translation>Choisir le dossier d&apos;un parcours enregistré, ou tout dossier d&apos;images</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>&amp;Figer</translation>
    </message>
    <message>
        <source>Hold the picture</source>
        <translation>Figer l&apos;image</translation>
    </message>
    <message>
        <source>Keep the picture that the camera shows now</source>
        <translation>Garder l&apos;image que la caméra montre maintenant</translation>
    </message>
    <message>
        <source>Pre&amp;vious picture</source>
        <translation>Image &amp;précédente</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Image précédente</translation>
    </message>
    <message>
        <source>The picture before</source>
        <translation>L&apos;image d&apos;avant</translation>
    </message>
    <message>
        <source>Ne&amp;xt picture</source>
        <translation>Image &amp;suivante</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Image suivante</translation>
    </message>
    <message>
        <source>The picture after</source>
        <translation>L&apos;image d&apos;après</translation>
    </message>
    <message>
        <source>&amp;Find outline</source>
        <translation>&amp;Trouver le contour</translation>
    </message>
    <message>
        <source>Find the outline</source>
        <translation>Trouver le contour</translation>
    </message>
    <message>
        <source>Look for the outline in this picture</source>
        <translation>Chercher le contour dans cette image</translation>
    </message>
    <message>
        <source>Whole p&amp;icture</source>
        <translation>T&amp;oute l&apos;image</translation>
    </message>
    <message>
        <source>Outline the whole picture</source>
        <translation>Prendre toute l&apos;image pour contour</translation>
    </message>
    <message>
        <source>Set the corners to those of the picture</source>
        <translation>Placer les coins sur ceux de l&apos;image</translation>
    </message>
    <message>
        <source>&amp;Add this view</source>
        <translation>&amp;Ajouter cette vue</translation>
    </message>
    <message>
        <source>Add this view</source>
        <translation>Ajouter cette vue</translation>
    </message>
    <message>
        <source>Learn the landmark from this picture</source>
        <translation>Apprendre le repère de cette image</translation>
    </message>
    <message>
        <source>Re&amp;move view</source>
        <translation>Retirer la &amp;vue</translation>
    </message>
    <message>
        <source>Remove the chosen view</source>
        <translation>Retirer la vue choisie</translation>
    </message>
    <message>
        <source>Forget the chosen view</source>
        <translation>Oublier la vue choisie</translation>
    </message>
    <message>
        <source>Coach</source>
        <translation>Conseil</translation>
    </message>
    <message>
        <source>Views so far</source>
        <translation>Vues jusqu&apos;ici</translation>
    </message>
    <message>
        <source>How well it will be found</source>
        <translation>S&apos;il sera bien trouvé</translation>
    </message>
    <message>
        <source>The photographs it is learnt from</source>
        <translation>Les photographies dont il est appris</translation>
    </message>
    <message>
        <source>Picture with outline</source>
        <translation>Image avec contour</translation>
    </message>
    <message>
        <source>Drag the four corners onto the landmark. By keys: 1 to 4 choose a corner, the arrows move it, with Shift by one pixel.</source>
        <translation>Glissez les quatre coins sur le repère. Au clavier&#xa0;: 1 à 4 choisissent un coin, les flèches le déplacent, avec Maj d&apos;un pixel.</translation>
    </message>
    <message>
        <source>No picture yet.
Switch on the camera, or choose pictures or a recording.</source>
        <translation>Pas encore d&apos;image.
Allumez la caméra, ou choisissez des images ou un enregistrement.</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachWhat</name>
    <message>
        <source>What is it that Farol shall know again? A sign, a poster, a door with something on it: flat things with detail are known best. Choose “known place” for the whole view of a spot.</source>
        <translation>Que doit reconnaître Farol&#xa0;? Un panneau, une affiche, une porte qui porte quelque chose&#xa0;: ce qui est plat et détaillé se reconnaît le mieux. Choisissez «&#xa0;lieu connu&#xa0;» pour la vue entière d&apos;un endroit.</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Nom&#xa0;:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>What people call it</source>
        <translation>Comment les gens l&apos;appellent</translation>
    </message>
    <message>
        <source>&amp;Kind:</source>
        <translation>&amp;Type&#xa0;:</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Ce que c&apos;est</translation>
    </message>
    <message>
        <source>Real &amp;width:</source>
        <translation>&amp;Largeur réelle&#xa0;:</translation>
    </message>
    <message>
        <source>Real width</source>
        <translation>Largeur réelle</translation>
    </message>
    <message>
        <source>Lets Farol tell how far away it is</source>
        <translation>Permet à Farol de dire à quelle distance il est</translation>
    </message>
    <message>
        <source>Real &amp;height:</source>
        <translation>&amp;Hauteur réelle&#xa0;:</translation>
    </message>
    <message>
        <source>Real height</source>
        <translation>Hauteur réelle</translation>
    </message>
    <message>
        <source>In &amp;maps called:</source>
        <translation>Appelé dans les c&amp;artes&#xa0;:</translation>
    </message>
    <message>
        <source>In maps called</source>
        <translation>Appelé dans les cartes</translation>
    </message>
    <message>
        <source>Landmarks of the map refer to it by this word, so it should not change</source>
        <translation>Les repères de la carte s&apos;y réfèrent par ce mot&#xa0;; il ne devrait pas changer</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
</context>
<context>
    <name>farol::ui::TimelineBar</name>
    <message>
        <source>T&amp;imeline:</source>
        <translation>L&amp;igne du temps&#xa0;:</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Ligne du temps</translation>
    </message>
    <message>
        <source>How sure the place was, and marks where something was said. Drag it, or use the arrow keys, to look back; End goes back to now.</source>
        <translation>À quel point le lieu était sûr, et des marques là où quelque chose fut dit. Glissez-la ou utilisez les flèches pour regarder en arrière&#xa0;; Fin revient à maintenant.</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Maintenant</translation>
    </message>
    <message>
        <source>Back to now</source>
        <translation>Revenir à maintenant</translation>
    </message>
    <message>
        <source>Show the walk as it is now</source>
        <translation>Montrer le parcours tel qu&apos;il est maintenant</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Looking back at %1</source>
        <translation>Regard en arrière à %1</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingActions</name>
    <message>
        <source>&amp;Landmarks</source>
        <translation>&amp;Repères</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>&amp;Open library…</source>
        <translation>&amp;Ouvrir une bibliothèque…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Ouvrir une bibliothèque de repères</translation>
    </message>
    <message>
        <source>&amp;New library…</source>
        <translation>&amp;Nouvelle bibliothèque…</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouvelle</translation>
    </message>
    <message>
        <source>Make an empty landmark library</source>
        <translation>Créer une bibliothèque de repères vide</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Write the library into another file; every change is saved by itself</source>
        <translation>Écrire la bibliothèque dans un autre fichier&#xa0;; chaque modification s&apos;enregistre d&apos;elle-même</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Revenir sur la dernière modification</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Make the change again that was taken back</source>
        <translation>Refaire la modification annulée</translation>
    </message>
    <message>
        <source>&amp;Teach a landmark</source>
        <translation>A&amp;pprendre un repère</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Apprendre</translation>
    </message>
    <message>
        <source>Teach Farol a new landmark, step by step</source>
        <translation>Apprendre à Farol un nouveau repère, étape par étape</translation>
    </message>
    <message>
        <source>Add &amp;views</source>
        <translation>Ajouter des &amp;vues</translation>
    </message>
    <message>
        <source>Add views</source>
        <translation>Ajouter des vues</translation>
    </message>
    <message>
        <source>Teach more views of the chosen landmark</source>
        <translation>Apprendre d&apos;autres vues du repère choisi</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>&amp;Modifier…</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Modifier</translation>
    </message>
    <message>
        <source>Change the name, kind or size of the chosen landmark</source>
        <translation>Modifier le nom, le type ou la taille du repère choisi</translation>
    </message>
    <message>
        <source>&amp;Merge with…</source>
        <translation>&amp;Fusionner avec…</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Fusionner</translation>
    </message>
    <message>
        <source>Make the chosen landmark and another one the same</source>
        <translation>Ne faire qu&apos;un du repère choisi et d&apos;un autre</translation>
    </message>
    <message>
        <source>&amp;Split…</source>
        <translation>S&amp;éparer…</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Séparer</translation>
    </message>
    <message>
        <source>Make the chosen views a landmark of their own</source>
        <translation>Faire des vues choisies un repère à part</translation>
    </message>
    <message>
        <source>Delete the chosen vie&amp;ws</source>
        <translation>Supprimer les vues cho&amp;isies</translation>
    </message>
    <message>
        <source>Delete views</source>
        <translation>Supprimer des vues</translation>
    </message>
    <message>
        <source>Forget the chosen views of the landmark</source>
        <translation>Oublier les vues choisies du repère</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>S&amp;upprimer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Forget the chosen landmark</source>
        <translation>Oublier le repère choisi</translation>
    </message>
    <message>
        <source>&amp;Put on the map…</source>
        <translation>Mettre sur la &amp;carte…</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>Sur la carte</translation>
    </message>
    <message>
        <source>Put the chosen landmark on the map</source>
        <translation>Mettre le repère choisi sur la carte</translation>
    </message>
    <message>
        <source>C&amp;heck all</source>
        <translation>&amp;Tout vérifier</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Look how well each landmark is found and which are taken for each other</source>
        <translation>Regarder si chaque repère est bien trouvé et lesquels sont confondus</translation>
    </message>
    <message>
        <source>Wal&amp;k with this library</source>
        <translation>Parcourir avec cette bi&amp;bliothèque</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Parcours</translation>
    </message>
    <message>
        <source>Use this library on the Walk page</source>
        <translation>Utiliser cette bibliothèque sur la page Parcours</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingPage</name>
    <message>
        <source>Open another &amp;library…</source>
        <translation>Ouvrir une autre &amp;bibliothèque…</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Non enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>Save el&amp;sewhere…</source>
        <translation>Enregistrer &amp;ailleurs…</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Ouvrir une bibliothèque de repères</translation>
    </message>
    <message>
        <source>Landmark libraries (%1);;All files (%2)</source>
        <translation>Bibliothèques de repères (%1);;Tous les fichiers (%2)</translation>
    </message>
    <message>
        <source>New landmark library</source>
        <translation>Nouvelle bibliothèque de repères</translation>
    </message>
    <message>
        <source>Landmark libraries (%1)</source>
        <translation>Bibliothèques de repères (%1)</translation>
    </message>
    <message>
        <source>Save the library as</source>
        <translation>Enregistrer la bibliothèque sous</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is unfinished, with %n view(s).</source>
        <translation>
            <numerusform>«&#xa0;%1&#xa0;» est inachevé, avec %n vue.</numerusform>
            <numerusform>«&#xa0;%1&#xa0;» est inachevé, avec %n vues.</numerusform>
        </translation>
    </message>
    <message>
        <source>A new landmark</source>
        <translation>Un nouveau repère</translation>
    </message>
    <message>
        <source>Go &amp;on with it</source>
        <translation>&amp;Continuer avec lui</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>Apprendre «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>Tableau (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 ne peut pas être écrit. Choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Travail en cours…</translation>
    </message>
    <message>
        <source>%1 · being saved</source>
        <translation>%1 · enregistrement en cours</translation>
    </message>
    <message>
        <source>%1 · saved</source>
        <translation>%1 · enregistré</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>Modifier «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Merge landmarks</source>
        <translation>Fusionner des repères</translation>
    </message>
    <message>
        <source>The views of this landmark go to “%1”, and it is deleted:</source>
        <translation>Les vues de ce repère vont à «&#xa0;%1&#xa0;», et il est supprimé&#xa0;:</translation>
    </message>
    <message>
        <source>Split the landmark</source>
        <translation>Séparer le repère</translation>
    </message>
    <message numerus="yes">
        <source>Name of the landmark that the %n chosen view(s) become:</source>
        <translation>
            <numerusform>Nom du repère que devient la %n vue choisie&#xa0;:</numerusform>
            <numerusform>Nom du repère que deviennent les %n vues choisies&#xa0;:</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete views</source>
        <translation>Supprimer des vues</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>Supprimer «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Not saved: another program has changed the same landmarks in %1. Save yours under another name; what the other program wrote stays.</source>
        <translation>Non enregistré&#xa0;: un autre programme a modifié les mêmes repères dans %1. Enregistrez les vôtres sous un autre nom&#xa0;; ce que l&apos;autre programme a écrit reste.</translation>
    </message>
    <message>
        <source>Another program has changed %1 meanwhile: its changes and yours are both saved. Earlier steps can no longer be undone.</source>
        <translation>Entre-temps, un autre programme a modifié %1&#xa0;: ses modifications et les vôtres sont toutes enregistrées. Les étapes précédentes ne peuvent plus être annulées.</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Un autre programme a modifié %1.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>&amp;Charger à nouveau</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingWords</name>
    <message>
        <source>Too dark. Switch on a light.</source>
        <translation>Trop sombre. Allumez une lampe.</translation>
    </message>
    <message>
        <source>Too bright. Turn away from the window or the lamp.</source>
        <translation>Trop clair. Détournez-vous de la fenêtre ou de la lampe.</translation>
    </message>
    <message>
        <source>Blurred. Hold the camera still, or wait until it is sharp.</source>
        <translation>Flou. Tenez la caméra immobile, ou attendez que l&apos;image soit nette.</translation>
    </message>
    <message>
        <source>Too small in the picture. Go nearer.</source>
        <translation>Trop petit dans l&apos;image. Approchez-vous.</translation>
    </message>
    <message>
        <source>Too little detail inside the outline. Go nearer, or choose something with more detail.</source>
        <translation>Trop peu de détails dans le contour. Approchez-vous, ou choisissez quelque chose de plus détaillé.</translation>
    </message>
    <message>
        <source>The corners cross. Set them clockwise from the top left.</source>
        <translation>Les coins se croisent. Placez-les dans le sens des aiguilles d&apos;une montre à partir du haut à gauche.</translation>
    </message>
    <message>
        <source>Next: straight from the front, about 2 metres away.</source>
        <translation>Ensuite&#xa0;: bien en face, à environ 2 mètres.</translation>
    </message>
    <message>
        <source>Next: from farther away, about twice as far.</source>
        <translation>Ensuite&#xa0;: de plus loin, environ deux fois plus.</translation>
    </message>
    <message>
        <source>Next: the same view from a step aside, or a step nearer.</source>
        <translation>Ensuite&#xa0;: la même vue, d&apos;un pas de côté ou d&apos;un pas plus près.</translation>
    </message>
    <message>
        <source>These views are enough. More do no harm.</source>
        <translation>Ces vues suffisent. Plus ne nuit pas.</translation>
    </message>
    <message>
        <source>Found in %1 of its %2 views by the others.</source>
        <translation>Retrouvé dans %1 de ses %2 vues par les autres.</translation>
    </message>
    <message>
        <source>Found from up to about %1 m (%2 pixels).</source>
        <translation>Trouvé jusqu&apos;à environ %1 m (%2 pixels).</translation>
    </message>
    <message>
        <source>Found down to a size of %1 pixels in the picture; give its real size to learn how far that is.</source>
        <translation>Trouvé jusqu&apos;à une taille de %1 pixels dans l&apos;image&#xa0;; donnez sa taille réelle pour savoir à quelle distance.</translation>
    </message>
    <message>
        <source>Never found when shown smaller or turned. Choose something with more detail.</source>
        <translation>Jamais trouvé plus petit ou tourné. Choisissez quelque chose de plus détaillé.</translation>
    </message>
    <message>
        <source>Taken for another: %1.</source>
        <translation>Pris pour un autre&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Others are taken for it: %1.</source>
        <translation>D&apos;autres sont pris pour lui&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Confused with none of the others.</source>
        <translation>Confondu avec aucun des autres.</translation>
    </message>
    <message>
        <source>confused with %1</source>
        <translation>confondu avec %1</translation>
    </message>
    <message>
        <source>hard to find</source>
        <translation>difficile à trouver</translation>
    </message>
    <message>
        <source>found from near only</source>
        <translation>trouvé de près seulement</translation>
    </message>
    <message>
        <source>%1 of %2 views found again</source>
        <translation>%1 vues retrouvées sur %2</translation>
    </message>
    <message>
        <source>one view only</source>
        <translation>une seule vue</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bon</translation>
    </message>
    <message>
        <source>No view is straight from the front: add one, to learn from how far it is found.</source>
        <translation>Aucune vue n&apos;est bien de face&#xa0;: ajoutez-en une, pour savoir de quelle distance il est trouvé.</translation>
    </message>
    <message>
        <source>Next: from the left, at an angle.</source>
        <translation>Ensuite&#xa0;: de la gauche, de biais.</translation>
    </message>
    <message>
        <source>Next: from the right, at an angle.</source>
        <translation>Ensuite&#xa0;: de la droite, de biais.</translation>
    </message>
    <message>
        <source>There is only one view: add another, so that it can be tried.</source>
        <translation>Il n&apos;y a qu&apos;une vue&#xa0;: ajoutez-en une, pour pouvoir l&apos;essayer.</translation>
    </message>
    <message>
        <source>Found at angles of up to %1 degrees.</source>
        <translation>Retrouvé sous des angles allant jusqu&apos;à %1 degrés.</translation>
    </message>
    <message>
        <source>Not found at an angle. Add views from the left and the right.</source>
        <translation>Non retrouvé de biais. Ajoutez des vues de la gauche et de la droite.</translation>
    </message>
</context>
<context>
    <name>farol::ui::UtteranceLog</name>
    <message>
        <source>What is said cannot be written to %1: %2. Choose another file.</source>
        <translation>Ce qui est dit ne peut pas être écrit dans %1&#xa0;: %2. Choisissez un autre fichier.</translation>
    </message>
</context>
<context>
    <name>farol::ui::UtteranceModel</name>
    <message>
        <source>Caused by picture %1</source>
        <translation>Causé par l&apos;image %1</translation>
    </message>
    <message>
        <source>Shown as text, not heard</source>
        <translation>Montré en texte, non entendu</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Sentence</source>
        <translation>Phrase</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Because</source>
        <translation>Parce que</translation>
    </message>
</context>
<context>
    <name>farol::ui::Voice</name>
    <message>
        <source>The voice &quot;%1&quot; is not installed. Choose another one in the settings.</source>
        <translation>La voix &quot;%1&quot; n&apos;est pas installée. Choisissez-en une autre dans les réglages.</translation>
    </message>
    <message>
        <source>The voice &quot;%1&quot; does not start: %2</source>
        <translation>La voix &quot;%1&quot; ne démarre pas&#xa0;: %2</translation>
    </message>
    <message>
        <source>The voice &quot;%1&quot; does not speak this language. Choose another one in the settings.</source>
        <translation>La voix &quot;%1&quot; ne parle pas cette langue. Choisissez-en une autre dans les réglages.</translation>
    </message>
    <message>
        <source>No voice is installed.</source>
        <translation>Aucune voix n&apos;est installée.</translation>
    </message>
    <message>
        <source>There is no sound device. Connect headphones or a loudspeaker.</source>
        <translation>Il n&apos;y a pas de périphérique audio. Branchez un casque ou un haut-parleur.</translation>
    </message>
    <message>
        <source>The voice does not work. Choose another one in the settings.</source>
        <translation>La voix ne fonctionne pas. Choisissez-en une autre dans les réglages.</translation>
    </message>
</context>
<context>
    <name>farol::ui::VoteDetailModel</name>
    <message>
        <source>seen at %1</source>
        <translation>vu à %1</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>filtre</translation>
    </message>
    <message>
        <source>speaks for it</source>
        <translation>parle pour lui</translation>
    </message>
    <message>
        <source>none of the objects last seen stands there</source>
        <translation>aucun des derniers objets vus ne s&apos;y trouve</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Terme</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Signification</translation>
    </message>
</context>
<context>
    <name>farol::ui::VoteModel</name>
    <message numerus="yes">
        <source>%n matching object(s)</source>
        <translation>
            <numerusform>%n objet concordant</numerusform>
            <numerusform>%n objets concordants</numerusform>
        </translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lieu</translation>
    </message>
    <message>
        <source>Votes</source>
        <translation>Voix</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Composé de</translation>
    </message>
</context>
<context>
    <name>farol::ui::Walk</name>
    <message numerus="yes">
        <source>%n remark(s) about the map: %1</source>
        <translation>
            <numerusform>%n remarque sur la carte&#xa0;: %1</numerusform>
            <numerusform>%n remarques sur la carte&#xa0;: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Ouverture de %1…</translation>
    </message>
    <message>
        <source>Loading…</source>
        <translation>Chargement…</translation>
    </message>
    <message>
        <source>Open a map first (Ctrl+O).</source>
        <translation>Ouvrez d&apos;abord une carte (Ctrl+O).</translation>
    </message>
    <message>
        <source>Open a camera, a video or a folder of pictures first (Ctrl+P).</source>
        <translation>Ouvrez d&apos;abord une caméra, une vidéo ou un dossier d&apos;images (Ctrl+P).</translation>
    </message>
    <message>
        <source>No trained landmarks: only doors and texts are recognised. Open a library of landmarks to recognise more.</source>
        <translation>Aucun repère entraîné : seules les portes et les inscriptions sont reconnues. Ouvrez une bibliothèque de repères pour en reconnaître davantage.</translation>
    </message>
    <message>
        <source>the folder for recordings cannot be made; choose another one in the settings</source>
        <translation>le dossier des enregistrements ne peut pas être créé&#xa0;; choisissez-en un autre dans les paramètres</translation>
    </message>
</context>
<context>
    <name>farol::ui::WelcomeDialog</name>
    <message>
        <source>Welcome to Farol</source>
        <translation>Bienvenue dans Farol</translation>
    </message>
    <message>
        <source>Farol guides a blind person through a building with one camera. It needs a map of the building, and landmarks that it was taught. What do you want to do?</source>
        <translation>Farol guide une personne aveugle dans un bâtiment avec une caméra. Il lui faut une carte du bâtiment et des repères qu&apos;on lui a appris. Que voulez-vous faire&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Guide somebody</source>
        <translation>&amp;Guider quelqu&apos;un</translation>
    </message>
    <message>
        <source>Open a map and a camera, and choose where to go</source>
        <translation>Ouvrir une carte et une caméra, et choisir où aller</translation>
    </message>
    <message>
        <source>Work on a &amp;map</source>
        <translation>Travailler sur une &amp;carte</translation>
    </message>
    <message>
        <source>Bring in a floor plan, check it, and put landmarks on it</source>
        <translation>Reprendre un plan d&apos;étage, le vérifier et y placer des repères</translation>
    </message>
    <message>
        <source>Teach &amp;landmarks</source>
        <translation>Apprendre des &amp;repères</translation>
    </message>
    <message>
        <source>Photograph what Farol shall know again</source>
        <translation>Photographier ce que Farol doit reconnaître</translation>
    </message>
    <message>
        <source>Read the &amp;help</source>
        <translation>Lire l&apos;&amp;aide</translation>
    </message>
    <message>
        <source>What each page is for, and its keys; F1 at any time</source>
        <translation>À quoi sert chaque page, et ses touches&#xa0;; F1 à tout moment</translation>
    </message>
    <message>
        <source>For a blind user who is alone, start “farol --kiosk”: full screen, by keys and speech.</source>
        <translation>Pour un utilisateur aveugle et seul, lancez «&#xa0;farol --kiosk&#xa0;»&#xa0;: plein écran, par touches et parole.</translation>
    </message>
</context>
<context>
    <name>farol::ui::WindowActions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Walk</source>
        <translation>&amp;Parcours</translation>
    </message>
    <message>
        <source>V&amp;oice</source>
        <translation>V&amp;oix</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ai&amp;de</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>R&amp;ecent maps</source>
        <translation>Cartes r&amp;écentes</translation>
    </message>
    <message>
        <source>Recent landmark li&amp;braries</source>
        <translation>Bi&amp;bliothèques récentes</translation>
    </message>
    <message>
        <source>Recent pi&amp;ctures</source>
        <translation>Ima&amp;ges récentes</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>&amp;Ouvrir une carte…</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>Open the map of a building</source>
        <translation>Ouvrir la carte d&apos;un bâtiment</translation>
    </message>
    <message>
        <source>Open landmark &amp;library…</source>
        <translation>Ouvrir une biblio&amp;thèque de repères…</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>Open the landmarks that Farol was taught</source>
        <translation>Ouvrir les repères appris par Farol</translation>
    </message>
    <message>
        <source>&amp;Close landmark library</source>
        <translation>&amp;Fermer la bibliothèque</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Walk without taught landmarks</source>
        <translation>Parcourir sans repères appris</translation>
    </message>
    <message>
        <source>Open &amp;pictures…</source>
        <translation>Ouvrir des &amp;images…</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Choose a camera, a video, a folder or an address</source>
        <translation>Choisir une caméra, une vidéo, un dossier ou une adresse</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Réglages…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Language, voice and what is told</source>
        <translation>Langue, voix et ce qui est dit</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Leave Farol</source>
        <translation>Quitter Farol</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Suspendre</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Hold the walk</source>
        <translation>Suspendre le parcours</translation>
    </message>
    <message>
        <source>Start the walk, or go on</source>
        <translation>Commencer le parcours, ou continuer</translation>
    </message>
    <message>
        <source>&amp;One picture</source>
        <translation>&amp;Une image</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas à pas</translation>
    </message>
    <message>
        <source>Go on by one picture, then hold</source>
        <translation>Avancer d&apos;une image, puis s&apos;arrêter</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>A&amp;rrêter</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>Terminer le parcours</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>Plus &amp;vite</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Plus vite</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>Lire plus vite</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>Plus le&amp;ntement</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Plus lentement</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>Lire plus lentement</translation>
    </message>
    <message>
        <source>Choose &amp;destination</source>
        <translation>Choisir la &amp;destination</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destination</translation>
    </message>
    <message>
        <source>Choose where to go</source>
        <translation>Choisir où aller</translation>
    </message>
    <message>
        <source>&amp;No destination</source>
        <translation>&amp;Sans destination</translation>
    </message>
    <message>
        <source>No destination</source>
        <translation>Sans destination</translation>
    </message>
    <message>
        <source>Give up the destination</source>
        <translation>Renoncer à la destination</translation>
    </message>
    <message>
        <source>Choose st&amp;art</source>
        <translation>Choisir le dépar&amp;t</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>Say where the walk starts</source>
        <translation>Dire où commence le parcours</translation>
    </message>
    <message>
        <source>&amp;Record the walk</source>
        <translation>&amp;Enregistrer le parcours</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Keep the next walk in a folder, to be replayed</source>
        <translation>Garder le prochain parcours dans un dossier, pour le rejouer</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Répéter</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Say the last instruction again</source>
        <translation>Redire la dernière instruction</translation>
    </message>
    <message>
        <source>Voice o&amp;ff</source>
        <translation>Voix &amp;coupée</translation>
    </message>
    <message>
        <source>Voice off</source>
        <translation>Voix coupée</translation>
    </message>
    <message>
        <source>Show sentences without speaking them</source>
        <translation>Montrer les phrases sans les dire</translation>
    </message>
    <message>
        <source>Wal&amp;k page</source>
        <translation>Page &amp;Parcours</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Parcours</translation>
    </message>
    <message>
        <source>Watch a walk</source>
        <translation>Suivre un parcours</translation>
    </message>
    <message>
        <source>&amp;Map page</source>
        <translation>Page &amp;Carte</translation>
    </message>
    <message>
        <source>Look at the map of a building, check it and change it</source>
        <translation>Voir la carte d&apos;un bâtiment, la vérifier et la modifier</translation>
    </message>
    <message>
        <source>&amp;Whole floor</source>
        <translation>&amp;Tout l&apos;étage</translation>
    </message>
    <message>
        <source>Whole floor</source>
        <translation>Tout l&apos;étage</translation>
    </message>
    <message>
        <source>Show the whole floor</source>
        <translation>Montrer tout l&apos;étage</translation>
    </message>
    <message>
        <source>&amp;Larger map</source>
        <translation>Carte plus &amp;grande</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Plus grand</translation>
    </message>
    <message>
        <source>Show the map larger</source>
        <translation>Montrer la carte plus grande</translation>
    </message>
    <message>
        <source>&amp;Smaller map</source>
        <translation>Carte p&amp;lus petite</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Plus petit</translation>
    </message>
    <message>
        <source>Show the map smaller</source>
        <translation>Montrer la carte plus petite</translation>
    </message>
    <message>
        <source>&amp;Follow to other floors</source>
        <translation>&amp;Suivre aux autres étages</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Switch to the floor where you are</source>
        <translation>Passer à l&apos;étage où vous êtes</translation>
    </message>
    <message>
        <source>&amp;Grid over the picture</source>
        <translation>G&amp;rille sur l&apos;image</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Show the nine parts of the picture</source>
        <translation>Montrer les neuf parties de l&apos;image</translation>
    </message>
    <message>
        <source>&amp;What was not accepted</source>
        <translation>Ce qui &amp;n&apos;a pas été accepté</translation>
    </message>
    <message>
        <source>Not accepted</source>
        <translation>Non accepté</translation>
    </message>
    <message>
        <source>Show what was nearly recognised, and why not</source>
        <translation>Montrer ce qui a failli être reconnu, et pourquoi non</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Partie su&amp;ivante de la fenêtre</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Go to the next part of the window</source>
        <translation>Aller à la partie suivante de la fenêtre</translation>
    </message>
    <message>
        <source>&amp;Previous part of the window</source>
        <translation>Partie précé&amp;dente de la fenêtre</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Go to the previous part of the window</source>
        <translation>Aller à la partie précédente de la fenêtre</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Touches</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Every key of this window</source>
        <translation>Toutes les touches de cette fenêtre</translation>
    </message>
    <message>
        <source>&amp;About Farol</source>
        <translation>À &amp;propos de Farol</translation>
    </message>
    <message>
        <source>About</source>
        <translation>À propos</translation>
    </message>
    <message>
        <source>What Farol is</source>
        <translation>Ce qu&apos;est Farol</translation>
    </message>
    <message>
        <source>&amp;Speed:</source>
        <translation>&amp;Vitesse&#xa0;:</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>How fast pictures from files are played</source>
        <translation>À quelle vitesse sont lues les images des fichiers</translation>
    </message>
    <message>
        <source>Landmark&amp;s page</source>
        <translation>Page &amp;Repères</translation>
    </message>
    <message>
        <source>Teach Farol landmarks, check them and change them</source>
        <translation>Apprendre des repères à Farol, les vérifier et les modifier</translation>
    </message>
    <message>
        <source>The user is &amp;here</source>
        <translation>L&apos;utilisateur est &amp;ici</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Ici</translation>
    </message>
    <message>
        <source>The user is in the place that is chosen on the map or in the list</source>
        <translation>L&apos;utilisateur est dans le lieu choisi sur la carte ou dans la liste</translation>
    </message>
    <message>
        <source>That is &amp;wrong</source>
        <translation>C&apos;est &amp;faux</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Faux</translation>
    </message>
    <message>
        <source>The place shown is wrong: look for it anew</source>
        <translation>Le lieu montré est faux&#xa0;: le chercher de nouveau</translation>
    </message>
    <message>
        <source>&amp;Work out a recorded walk anew…</source>
        <translation>Re&amp;calculer un parcours enregistré…</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>À nouveau</translation>
    </message>
    <message>
        <source>Compare a recorded walk with the same walk worked out otherwise</source>
        <translation>Comparer un parcours enregistré avec le même calculé autrement</translation>
    </message>
    <message>
        <source>&amp;Say this…</source>
        <translation>F&amp;aire dire ceci…</translation>
    </message>
    <message>
        <source>Say</source>
        <translation>Dire</translation>
    </message>
    <message>
        <source>Type a sentence that is spoken to the user</source>
        <translation>Taper une phrase dite à l&apos;utilisateur</translation>
    </message>
    <message>
        <source>Sa&amp;ve the picture…</source>
        <translation>Enre&amp;gistrer l&apos;image…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Save what the camera sees, with what was recognised</source>
        <translation>Enregistrer ce que voit la caméra, avec ce qui est reconnu</translation>
    </message>
    <message>
        <source>Save the walk as &amp;table…</source>
        <translation>Enregistrer le parcours en ta&amp;bleau…</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <source>Save times, places and sentences of this walk for a spreadsheet</source>
        <translation>Enregistrer heures, lieux et phrases de ce parcours pour un tableur</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>How the page that is shown is used</source>
        <translation>Comment on utilise la page montrée</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Bienvenue</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenue</translation>
    </message>
    <message>
        <source>The page of the first start</source>
        <translation>La page du premier démarrage</translation>
    </message>
    <message>
        <source>Fi&amp;gures…</source>
        <translation>&amp;Graphiques…</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Charts of the votes, of the time that pictures took, and of how far landmarks are found</source>
        <translation>Graphiques des votes, du temps pris par les images et de la distance à laquelle les repères sont trouvés</translation>
    </message>
</context>
<context>
    <name>farol::ui::Words</name>
    <message>
        <source>room</source>
        <translation>salle</translation>
    </message>
    <message>
        <source>corridor</source>
        <translation>couloir</translation>
    </message>
    <message>
        <source>hall</source>
        <translation>hall</translation>
    </message>
    <message>
        <source>stairwell</source>
        <translation>cage d&apos;escalier</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>ascenseur</translation>
    </message>
    <message>
        <source>toilet</source>
        <translation>toilettes</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>extérieur</translation>
    </message>
    <message>
        <source>place</source>
        <translation>lieu</translation>
    </message>
    <message>
        <source>door</source>
        <translation>porte</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>ouverture</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>escalier</translation>
    </message>
    <message>
        <source>escalator</source>
        <translation>escalier mécanique</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampe</translation>
    </message>
    <message>
        <source>window</source>
        <translation>fenêtre</translation>
    </message>
    <message>
        <source>passage</source>
        <translation>passage</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>niveau %1</translation>
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
        <translation>%1 entre %2 et %3</translation>
    </message>
    <message>
        <source>%1 (closed)</source>
        <translation>%1 (fermé)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2, in %3</source>
        <translation>%1&#xa0;: %2, dans %3</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>speaking</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>spoken</source>
        <translation>dit</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>trop tard</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>montré</translation>
    </message>
    <message>
        <source>new route</source>
        <translation>nouvel itinéraire</translation>
    </message>
    <message>
        <source>coming up</source>
        <translation>à venir</translation>
    </message>
    <message>
        <source>do it now</source>
        <translation>à faire maintenant</translation>
    </message>
    <message>
        <source>keep going</source>
        <translation>continuez</translation>
    </message>
    <message>
        <source>arrived</source>
        <translation>arrivée</translation>
    </message>
    <message>
        <source>left the route</source>
        <translation>itinéraire quitté</translation>
    </message>
    <message>
        <source>place not known</source>
        <translation>lieu inconnu</translation>
    </message>
    <message>
        <source>place found</source>
        <translation>lieu trouvé</translation>
    </message>
    <message>
        <source>object seen</source>
        <translation>objet vu</translation>
    </message>
    <message>
        <source>text read</source>
        <translation>texte lu</translation>
    </message>
    <message>
        <source>no route</source>
        <translation>pas d&apos;itinéraire</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>déjà sur place</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>demandé</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>sûr</translation>
    </message>
    <message>
        <source>fairly sure</source>
        <translation>assez sûr</translation>
    </message>
    <message>
        <source>not sure</source>
        <translation>pas sûr</translation>
    </message>
    <message>
        <source>too few points fit</source>
        <translation>trop peu de points concordent</translation>
    </message>
    <message>
        <source>outline folded</source>
        <translation>contour replié</translation>
    </message>
    <message>
        <source>looks too different</source>
        <translation>aspect trop différent</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>objets</translation>
    </message>
    <message>
        <source>best object</source>
        <translation>meilleur objet</translation>
    </message>
    <message>
        <source>near the last place</source>
        <translation>près du dernier lieu</translation>
    </message>
    <message>
        <source>on the way</source>
        <translation>en chemin</translation>
    </message>
    <message>
        <source>seen together</source>
        <translation>vus ensemble</translation>
    </message>
    <message>
        <source>weight of the place</source>
        <translation>poids du lieu</translation>
    </message>
    <message>
        <source>share seen here</source>
        <translation>part vue ici</translation>
    </message>
    <message>
        <source>share seen next door</source>
        <translation>part vue à côté</translation>
    </message>
    <message>
        <source>vote</source>
        <translation>voix</translation>
    </message>
    <message>
        <source>does not reach the floor</source>
        <translation>n&apos;atteint pas le sol</translation>
    </message>
    <message>
        <source>two places look alike</source>
        <translation>deux lieux se ressemblent</translation>
    </message>
    <message>
        <source>part of the number may be hidden</source>
        <translation>une partie du numéro est peut-être cachée</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>flou</translation>
    </message>
    <message>
        <source>too many lines for a door</source>
        <translation>trop de lignes pour une porte</translation>
    </message>
    <message>
        <source>looked at again, it was something else</source>
        <translation>regardé de nouveau, c&apos;était autre chose</translation>
    </message>
    <message>
        <source>the scene changed</source>
        <translation>la scène a changé</translation>
    </message>
    <message>
        <source>lines evenly apart, as of a shelf</source>
        <translation>lignes régulières, comme d&apos;une étagère</translation>
    </message>
    <message>
        <source>too few step edges</source>
        <translation>trop peu d&apos;arêtes de marches</translation>
    </message>
    <message>
        <source>lines, but no steps</source>
        <translation>des lignes, mais pas de marches</translation>
    </message>
    <message>
        <source>lines apart as of floor tiles</source>
        <translation>lignes écartées comme d&apos;un carrelage</translation>
    </message>
    <message>
        <source>pictures too far apart to follow it</source>
        <translation>images trop espacées pour le suivre</translation>
    </message>
    <message>
        <source>a grid, as of tiles or windows</source>
        <translation>une grille, comme de carreaux ou de fenêtres</translation>
    </message>
    <message>
        <source>too high for steps</source>
        <translation>trop haut pour un escalier</translation>
    </message>
    <message>
        <source>impossible size</source>
        <translation>taille impossible</translation>
    </message>
    <message>
        <source>does not move as one thing</source>
        <translation>ne bouge pas d&apos;un seul tenant</translation>
    </message>
    <message>
        <source>its sides go on above it</source>
        <translation>ses côtés continuent au-dessus</translation>
    </message>
    <message>
        <source>of a kind that is not looked for</source>
        <translation>d&apos;un type qui n&apos;est pas cherché</translation>
    </message>
    <message>
        <source>told by its trained look instead</source>
        <translation>reconnu plutôt par son apparence apprise</translation>
    </message>
    <message>
        <source>left the picture</source>
        <translation>sorti de l&apos;image</translation>
    </message>
    <message>
        <source>a line goes across it</source>
        <translation>une ligne le traverse</translation>
    </message>
    <message>
        <source>a line goes up its middle</source>
        <translation>une ligne monte en son milieu</translation>
    </message>
    <message>
        <source>a stroke rather than a letter</source>
        <translation>un trait plutôt qu&apos;une lettre</translation>
    </message>
    <message>
        <source>looks different now</source>
        <translation>a changé d&apos;aspect</translation>
    </message>
    <message>
        <source>a letter was missed</source>
        <translation>une lettre a échappé</translation>
    </message>
    <message>
        <source>a point was missed</source>
        <translation>un point a échappé</translation>
    </message>
    <message>
        <source>a space was missed</source>
        <translation>une espace a échappé</translation>
    </message>
    <message>
        <source>reading not sure</source>
        <translation>lecture incertaine</translation>
    </message>
    <message>
        <source>too pale</source>
        <translation>trop pâle</translation>
    </message>
    <message>
        <source>too low for stairs</source>
        <translation>trop bas pour un escalier</translation>
    </message>
    <message>
        <source>not sure enough</source>
        <translation>pas assez sûr</translation>
    </message>
    <message>
        <source>seen as in a mirror</source>
        <translation>vu comme dans un miroir</translation>
    </message>
    <message>
        <source>too narrow</source>
        <translation>trop étroit</translation>
    </message>
    <message>
        <source>only a small part fits</source>
        <translation>seule une petite partie concorde</translation>
    </message>
    <message>
        <source>the points fit no outline</source>
        <translation>les points ne forment aucun contour</translation>
    </message>
    <message>
        <source>no letters</source>
        <translation>pas de lettres</translation>
    </message>
    <message>
        <source>readings do not agree yet</source>
        <translation>les lectures ne concordent pas encore</translation>
    </message>
    <message>
        <source>outline without numbers</source>
        <translation>contour sans chiffres</translation>
    </message>
    <message>
        <source>mostly outside the picture</source>
        <translation>en grande partie hors de l&apos;image</translation>
    </message>
    <message>
        <source>lost from sight</source>
        <translation>perdu de vue</translation>
    </message>
    <message>
        <source>seen only once so far</source>
        <translation>vu une seule fois jusqu&apos;ici</translation>
    </message>
    <message>
        <source>only a sliver</source>
        <translation>seulement une bande</translation>
    </message>
    <message>
        <source>too few letters</source>
        <translation>trop peu de lettres</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>trop petit</translation>
    </message>
    <message>
        <source>not seen again</source>
        <translation>pas revu</translation>
    </message>
    <message>
        <source>step edges of uneven contrast</source>
        <translation>arêtes de marches au contraste inégal</translation>
    </message>
    <message>
        <source>step edges unevenly apart</source>
        <translation>arêtes de marches inégalement espacées</translation>
    </message>
    <message>
        <source>read differently each time</source>
        <translation>lu différemment à chaque fois</translation>
    </message>
    <message>
        <source>no top of a door frame</source>
        <translation>pas de haut d&apos;encadrement de porte</translation>
    </message>
    <message>
        <source>wider above than below</source>
        <translation>plus large en haut qu&apos;en bas</translation>
    </message>
    <message>
        <source>in the way of walking</source>
        <translation>dans le sens de la marche</translation>
    </message>
    <message>
        <source>on your level</source>
        <translation>à votre niveau</translation>
    </message>
    <message>
        <source>matching objects</source>
        <translation>objets concordants</translation>
    </message>
    <message>
        <source>matching objects next door</source>
        <translation>objets concordants à côté</translation>
    </message>
    <message>
        <source>objects seen</source>
        <translation>objets vus</translation>
    </message>
    <message>
        <source>share of the likelihood</source>
        <translation>part de la vraisemblance</translation>
    </message>
    <message>
        <source>could be anywhere</source>
        <translation>pourrait être n&apos;importe où</translation>
    </message>
    <message>
        <source>evidence against all of this</source>
        <translation>indices contre tout cela</translation>
    </message>
    <message>
        <source>a likeness within one already found</source>
        <translation>une ressemblance dans un objet déjà trouvé</translation>
    </message>
</context>
</TS>
