<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Sí</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;No</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
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
        <translation>Mayús</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Flecha arriba</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Flecha abajo</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Flecha izquierda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Flecha derecha</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Supr</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message numerus="yes">
        <source>%n features have no id; give each its own</source>
        <translation>
            <numerusform>%n elemento no tiene identificador; dele uno propio</numerusform>
            <numerusform>%n elementos no tienen identificador; dé a cada uno el suyo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features share the id &quot;%1&quot;; give each its own</source>
        <translation>
            <numerusform>%n elemento tiene el identificador “%1”; dé a cada uno el suyo</numerusform>
            <numerusform>%n elementos tienen el mismo identificador “%1”; dé a cada uno el suyo</numerusform>
        </translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has fewer than three corners; draw it again</source>
        <translation>el contorno de la región “%1” tiene menos de tres esquinas; dibújelo de nuevo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a coordinate that is no number; draw it again</source>
        <translation>el contorno de la región “%1” tiene una coordenada que no es un número; dibújelo de nuevo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has no area; draw it again</source>
        <translation>el contorno de la región “%1” no tiene superficie; dibújelo de nuevo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; crosses itself; draw it again</source>
        <translation>el contorno de la región “%1” se cruza a sí mismo; dibújelo de nuevo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has fewer than three corners; draw it again</source>
        <translation>el contorno de la región “%1” tiene un hueco con menos de tres esquinas; dibújelo de nuevo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has a coordinate that is no number; draw it again</source>
        <translation>el contorno de la región “%1” tiene un hueco con una coordenada que no es un número; dibújelo de nuevo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has no area; draw it again</source>
        <translation>el contorno de la región “%1” tiene un hueco sin superficie; dibújelo de nuevo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that crosses itself; draw it again</source>
        <translation>el contorno de la región “%1” tiene un hueco que se cruza a sí mismo; dibújelo de nuevo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that lies outside it; draw it again</source>
        <translation>el contorno de la región “%1” tiene un hueco que queda fuera de él; dibújelo de nuevo</translation>
    </message>
    <message numerus="yes">
        <source>%n regions have neither name nor ref: only its kind is spoken</source>
        <translation>
            <numerusform>%n región no tiene nombre ni número: solo se dice su tipo</numerusform>
            <numerusform>%n regiones no tienen nombre ni número: solo se dice su tipo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions are called &quot;%1&quot; or the like, which is never spoken; give it the name that people use</source>
        <translation>
            <numerusform>%n región se llama “%1”, lo que nunca se dice; dele el nombre que usa la gente</numerusform>
            <numerusform>%n regiones se llaman “%1” o algo parecido, lo que nunca se dice; deles el nombre que usa la gente</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>level %1 is used by %n regions but is not in the layer levels: its name cannot be spoken; add it</source>
        <translation>
            <numerusform>la planta %1 la usa %n región, pero no está en la lista de plantas (levels): su nombre no se puede decir; añádala</numerusform>
            <numerusform>la planta %1 la usan %n regiones, pero no está en la lista de plantas (levels): su nombre no se puede decir; añádala</numerusform>
        </translation>
    </message>
    <message>
        <source>access &quot;%1&quot; names the region &quot;%2&quot;, which does not exist; correct it</source>
        <translation>el paso “%1” nombra la región “%2”, que no existe; corríjala</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; lies more than 1 m from region &quot;%2&quot;; move it to the border</source>
        <translation>el paso “%1” está a más de 1&#xa0;m de la región “%2”; muévalo al límite</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; has the same region on both sides: no route passes it; set region_a and region_b, or move it to a border</source>
        <translation>el paso “%1” tiene la misma región a ambos lados: ninguna ruta pasa por él; indique la región de cada lado (region_a y region_b) o muévalo a un límite</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; does not join two regions: no route passes it; set region_a and region_b, or move it to a border</source>
        <translation>el paso “%1” no une dos regiones: ninguna ruta pasa por él; indique la región de cada lado (region_a y region_b) o muévalo a un límite</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; is no stairs, lift, escalator or ramp but joins regions of levels %2 and %3; correct its kind or regions</source>
        <translation>el paso “%1” no es escalera, ascensor, escalera mecánica ni rampa, pero une regiones de las plantas %2 y %3; corrija su tipo o sus regiones</translation>
    </message>
    <message numerus="yes">
        <source>%n accesses are drawn on more than two regions: see that region_a and region_b are the right ones</source>
        <translation>
            <numerusform>%n paso está dibujado sobre más de dos regiones: compruebe que los dos lados (region_a y region_b) son los correctos</numerusform>
            <numerusform>%n pasos están dibujados sobre más de dos regiones: compruebe que los dos lados (region_a y region_b) son los correctos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n escalators have no direction and count as running both ways: set oneway</source>
        <translation>
            <numerusform>%n escalera mecánica no tiene sentido y cuenta como si funcionara en ambos: indíquelo (oneway)</numerusform>
            <numerusform>%n escaleras mecánicas no tienen sentido y cuentan como si funcionaran en ambos: indíquelo (oneway)</numerusform>
        </translation>
    </message>
    <message>
        <source>shaft &quot;%1&quot; passes level %2 without an access there; add it, unless it does not stop there</source>
        <translation>la escalera o el ascensor “%1” pasa por la planta %2 sin ningún paso allí; añádalo, salvo que no pare en ella</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; belongs to no region; set region_id</source>
        <translation>el punto de referencia “%1” no pertenece a ninguna región; indíquela (region_id)</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; names the region &quot;%2&quot;, which does not exist; correct it</source>
        <translation>el punto de referencia “%1” nombra la región “%2”, que no existe; corríjala</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; is on level %2, its region &quot;%3&quot; on level %4</source>
        <translation>el punto de referencia “%1” está en la planta %2, y su región “%3” en la planta %4</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; lies more than 0.5 m outside its region &quot;%2&quot;; move it or correct region_id</source>
        <translation>el punto de referencia “%1” está más de 0,5&#xa0;m fuera de su región “%2”; muévalo o corrija la región (region_id)</translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2</source>
        <translation>
            <numerusform>%n elemento tiene el tipo desconocido “%1”; se conocen, y entre paréntesis como se escriben en el mapa: %2</numerusform>
            <numerusform>%n elementos tienen el tipo desconocido “%1”; se conocen, y entre paréntesis como se escriben en el mapa: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2 (nobody is led through other)</source>
        <translation>
            <numerusform>%n elemento tiene el tipo desconocido “%1”; se conocen, y entre paréntesis como se escriben en el mapa: %2 (por “other” no se guía a nadie)</numerusform>
            <numerusform>%n elementos tienen el tipo desconocido “%1”; se conocen, y entre paréntesis como se escriben en el mapa: %2 (por “other” no se guía a nadie)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the building falls into %1 parts; %n regions cannot be reached from the largest (%2): accesses are missing or closed</source>
        <translation>
            <numerusform>el edificio se divide en %1 partes; a %n región no se llega desde la mayor (%2): faltan pasos o están cerrados</numerusform>
            <numerusform>el edificio se divide en %1 partes; a %n regiones no se llega desde la mayor (%2): faltan pasos o están cerrados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>%n región</numerusform>
            <numerusform>%n regiones</numerusform>
        </translation>
    </message>
    <message>
        <source>region &quot;%1&quot; is a sliver, about %2 m wide: nobody stands there; join it to its neighbour</source>
        <translation>la región “%1” es una franja de unos %2&#xa0;m de ancho: nadie cabe allí; únala a su vecina</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot; have the same outline; remove one</source>
        <translation>las regiones “%1” y “%2” tienen el mismo contorno; quite una</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot;: the smaller lies inside the larger; cut it out of the larger one, unless it is a part of it</source>
        <translation>regiones “%1” y “%2”: la menor está dentro de la mayor; recórtela de la mayor, salvo que sea parte de ella</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot; overlap by %3 % of the smaller; draw the border between them</source>
        <translation>las regiones “%1” y “%2” se solapan en un %3&#xa0;% de la menor; dibuje el límite entre ellas</translation>
    </message>
    <message>
        <source>so many regions overlap that not all pairs were compared; are all levels drawn on one?</source>
        <translation>se solapan tantas regiones que no se han comparado todos los pares; ¿están todas las plantas dibujadas en una?</translation>
    </message>
    <message numerus="yes">
        <source>%n regions of level %1 have the ref &quot;%2&quot;: people are led to the wrong one; correct it</source>
        <translation>
            <numerusform>%n región de la planta %1 tiene el número “%2”: se lleva a la gente a la que no es; corríjalo</numerusform>
            <numerusform>%n regiones de la planta %1 tienen el número “%2”: se lleva a la gente a la que no es; corríjalo</numerusform>
        </translation>
    </message>
    <message>
        <source>the whole building is smaller than 0.3 m: its coordinates are degrees, not metres; import or reproject it</source>
        <translation>todo el edificio mide menos de 0,3&#xa0;m: sus coordenadas son grados, no metros; impórtelo o reproyéctelo</translation>
    </message>
    <message numerus="yes">
        <source>%n regions have no door or other access that joins another region: nobody can be led there; add it</source>
        <translation>
            <numerusform>%n región no tiene puerta ni otro paso a otra región: no se puede llevar a nadie allí; añádalo</numerusform>
            <numerusform>%n regiones no tienen puerta ni otro paso a otra región: no se puede llevar a nadie allí; añádalo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions have a door drawn on the border, but the door joins two others and nothing leads there: correct region_a or region_b, or draw another door</source>
        <translation>
            <numerusform>%n región tiene una puerta dibujada en el límite, pero une otras dos y nada lleva allí: corrija uno de sus lados (region_a o region_b) o dibuje otra puerta</numerusform>
            <numerusform>%n regiones tienen una puerta dibujada en el límite, pero une otras dos y nada lleva allí: corrija uno de sus lados (region_a o region_b) o dibuje otra puerta</numerusform>
        </translation>
    </message>
    <message>
        <source>features had no id and were given one</source>
        <translation>había elementos sin identificador, que recibieron uno</translation>
    </message>
    <message>
        <source>features shared an id and were given another</source>
        <translation>había elementos con el mismo identificador, que recibieron otro</translation>
    </message>
    <message>
        <source>outlines have corners that are no places; these were left out</source>
        <translation>hay contornos con esquinas que no son lugares; se dejaron fuera</translation>
    </message>
    <message>
        <source>outlines have fewer than three corners; the regions were left out</source>
        <translation>hay contornos con menos de tres esquinas; esas regiones se dejaron fuera</translation>
    </message>
    <message>
        <source>outlines have more than 200,000 corners; the regions were left out</source>
        <translation>hay contornos con más de 200&#xa0;000 esquinas; esas regiones se dejaron fuera</translation>
    </message>
    <message>
        <source>outlines enclose no area; the regions were left out</source>
        <translation>hay contornos que no encierran ninguna superficie; esas regiones se dejaron fuera</translation>
    </message>
    <message>
        <source>outlines crossed or touched themselves and were mended: compare them with the plan</source>
        <translation>había contornos que se cruzaban o tocaban a sí mismos y se corrigieron: compárelos con el plano</translation>
    </message>
    <message>
        <source>regions fell into several parts: each part is a region of its own</source>
        <translation>había regiones en varias partes: cada parte es ahora una región propia</translation>
    </message>
    <message>
        <source>regions repeat the outline of another one on their level and were merged with it</source>
        <translation>hay regiones que repiten el contorno de otra de su planta y se unieron a ella</translation>
    </message>
    <message>
        <source>accesses have points that are no places; these were left out</source>
        <translation>hay pasos con puntos que no son lugares; se dejaron fuera</translation>
    </message>
    <message>
        <source>accesses have no place on the map and were left out</source>
        <translation>hay pasos sin lugar en el mapa, que se dejaron fuera</translation>
    </message>
    <message>
        <source>landmarks have no place on the map and were left out</source>
        <translation>hay puntos de referencia sin lugar en el mapa, que se dejaron fuera</translation>
    </message>
    <message>
        <source>levels are no floors of a building; level 0 is assumed</source>
        <translation>hay plantas que no son plantas de un edificio; se supone la planta 0</translation>
    </message>
    <message>
        <source>levels stand twice in the source; the first name is kept</source>
        <translation>hay plantas que aparecen dos veces en el original; queda el primer nombre</translation>
    </message>
    <message>
        <source>regions had no name and were given one from kind and number, such as &quot;Corridor 3&quot;: rename them</source>
        <translation>había regiones sin nombre, que recibieron uno hecho del tipo y un número, como “Corridor 3”: cámbieles el nombre</translation>
    </message>
    <message>
        <source>landmarks lie outside every region and were given to the nearest one</source>
        <translation>hay puntos de referencia fuera de toda región, que se asignaron a la más cercana</translation>
    </message>
    <message>
        <source>openings were added where regions meet without a wall between them</source>
        <translation>se añadieron aberturas donde hay regiones que se tocan sin pared entre ellas</translation>
    </message>
    <message>
        <source>accesses are drawn on fewer than two regions</source>
        <translation>hay pasos dibujados sobre menos de dos regiones</translation>
    </message>
    <message>
        <source>accesses lie beside more than two regions; the two with the widest border were taken: see that they are right</source>
        <translation>hay pasos junto a más de dos regiones; se tomaron las dos con el límite más ancho: compruebe que son las correctas</translation>
    </message>
    <message>
        <source>accesses run from one region to another and along no border: if one walks along the line, set region_a and region_b</source>
        <translation>hay pasos que van de una región a otra y no siguen ningún límite: si se camina a lo largo de la línea, indique la región de cada lado (region_a y region_b)</translation>
    </message>
    <message>
        <source>stairs, lifts or escalators lead to a level that nothing names: set region_b, or give them and their other end the same shaft</source>
        <translation>hay escaleras, ascensores o escaleras mecánicas que llevan a una planta que nada nombra: indique la región del otro lado (region_b), o deles el mismo hueco (shaft) que a su otro extremo</translation>
    </message>
    <message>
        <source>upper ends of stairs, lifts or escalators were left out: their lower ends lead there already</source>
        <translation>se dejaron fuera extremos superiores de escaleras, ascensores o escaleras mecánicas: los inferiores ya llevan allí</translation>
    </message>
    <message>
        <source>links between levels name regions that do not exist</source>
        <translation>hay enlaces entre plantas que nombran regiones que no existen</translation>
    </message>
    <message>
        <source>stairs, lifts or escalators were joined with the ones above them, because their outlines overlap</source>
        <translation>se unieron escaleras, ascensores o escaleras mecánicas con los que tienen encima, porque sus contornos se solapan</translation>
    </message>
    <message>
        <source>the coordinate reference system of the source cannot be understood</source>
        <translation>no se entiende el sistema de coordenadas del original</translation>
    </message>
    <message>
        <source>the source names a CRS in metres, but its coordinates are degrees: they are taken as WGS 84</source>
        <translation>el original nombra un sistema de coordenadas en metros, pero sus coordenadas son grados: se toman como WGS 84</translation>
    </message>
    <message>
        <source>the source names no CRS; its coordinates look like degrees and are taken as WGS 84</source>
        <translation>el original no nombra el sistema de coordenadas; parecen grados y se toman como WGS 84</translation>
    </message>
    <message>
        <source>the source names a CRS in degrees, but its coordinates are not: they are taken as metres of a local plane</source>
        <translation>el original nombra un sistema de coordenadas en grados, pero sus coordenadas no lo son: se toman como metros de un plano local</translation>
    </message>
    <message>
        <source>the source names no CRS: its coordinates are taken as metres of a local plane; name the CRS if there is one</source>
        <translation>el original no nombra el sistema de coordenadas: se toman como metros de un plano local; nombre el sistema, si lo hay</translation>
    </message>
    <message>
        <source>north and east stand in each other&apos;s place in the source: they were exchanged; export it again to be sure</source>
        <translation>norte y este están intercambiados en el original: se pusieron en su sitio; expórtelo otra vez para estar seguro</translation>
    </message>
    <message>
        <source>coordinates were brought from %1 to %2, in metres</source>
        <translation>las coordenadas se pasaron de %1 a %2, en metros</translation>
    </message>
    <message>
        <source>coordinates were brought from the source&apos;s CRS to %1, in metres</source>
        <translation>las coordenadas se pasaron del sistema del original a %1, en metros</translation>
    </message>
    <message>
        <source>layers hold no rooms, doors, walls or points by their name; a profile can say otherwise</source>
        <translation>hay capas que, por su nombre, no tienen salas, puertas, paredes ni puntos; un perfil puede decir otra cosa</translation>
    </message>
    <message>
        <source>features cannot be brought to the CRS of the other layers</source>
        <translation>hay elementos que no se pueden pasar al sistema de coordenadas de las otras capas</translation>
    </message>
    <message>
        <source>layers tell no level; the ground floor is assumed: name the field that holds the level</source>
        <translation>hay capas que no dicen la planta; se supone la planta baja: nombre el campo que tiene la planta</translation>
    </message>
    <message>
        <source>levels were counted from the heights of the shapes, the one nearest to 0 as the ground floor</source>
        <translation>las plantas se contaron por la altura de las formas, la más cercana a 0 como planta baja</translation>
    </message>
    <message>
        <source>lines of layers that nothing names doors or walls are taken as walls; name the layer or give a profile</source>
        <translation>las líneas de capas que nada nombra como puertas o paredes se toman como paredes; dé nombre a la capa o indique un perfil</translation>
    </message>
    <message>
        <source>features have no geometry and were left out</source>
        <translation>hay elementos sin forma, que se dejaron fuera</translation>
    </message>
    <message>
        <source>features have the code &quot;%1&quot;, which nobody knows: name it under codes in a profile</source>
        <translation>hay elementos con el código “%1”, que nadie conoce: nómbrelo en un perfil, en “codes”</translation>
    </message>
    <message>
        <source>accesses have a direction that nobody knows and are taken to be passed both ways: a_to_b, b_to_a, up or down is wanted</source>
        <translation>hay pasos con un sentido que nadie conoce, que se toman como de doble sentido: se quiere a_to_b, b_to_a, up o down</translation>
    </message>
    <message>
        <source>points name a region that does not exist; the one they lie in is taken</source>
        <translation>hay puntos que nombran una región que no existe; se toma aquella en que están</translation>
    </message>
    <message>
        <source>layers have no features: %1</source>
        <translation>hay capas sin elementos: %1</translation>
    </message>
    <message>
        <source>layers name no CRS; that of the other layers is taken</source>
        <translation>hay capas que no nombran el sistema de coordenadas; se toma el de las otras capas</translation>
    </message>
    <message>
        <source>features left out: their coordinates are missing or no places on Earth</source>
        <translation>elementos dejados fuera: sus coordenadas faltan o no son lugares de la Tierra</translation>
    </message>
    <message>
        <source>features left out: they have no usable shape</source>
        <translation>elementos dejados fuera: no tienen forma utilizable</translation>
    </message>
    <message>
        <source>the value of level or repeat_on is no list of levels such as -1;0 or 1-3: correct it</source>
        <translation>el valor de level o repeat_on no es una lista de plantas como -1;0 o 1-3: corríjalo</translation>
    </message>
    <message>
        <source>there is no readable level; level 0 is assumed: add the level</source>
        <translation>no hay ninguna planta legible; se supone la planta 0: indique la planta (level)</translation>
    </message>
    <message>
        <source>the lift is a point in the source: a square of 1.6 m was drawn for its car</source>
        <translation>el ascensor es un punto en el original: se dibujó un cuadrado de 1,6&#xa0;m para la cabina</translation>
    </message>
    <message>
        <source>left out: it has no level, and it stands over no or several levels&apos; regions</source>
        <translation>se dejó fuera: no tiene planta, y está sobre regiones de varias plantas o de ninguna</translation>
    </message>
    <message>
        <source>left out: no region of its level lies within 3 m</source>
        <translation>se dejó fuera: no hay ninguna región de su planta a menos de 3&#xa0;m</translation>
    </message>
    <message>
        <source>left out: it has no level and stands on no outline of a region</source>
        <translation>se dejó fuera: no tiene planta y no está sobre el contorno de ninguna región</translation>
    </message>
    <message>
        <source>no door is drawn where a way leads into the room: an opening was put there</source>
        <translation>no hay puerta dibujada donde un camino entra en la sala: se puso allí una abertura</translation>
    </message>
    <message>
        <source>nothing tells which end of the steps is up; the first was taken as the lower: add incline</source>
        <translation>nada dice qué extremo de los escalones está arriba; el primero se tomó como el de abajo: indique incline</translation>
    </message>
    <message>
        <source>no region lies at an end of the steps: draw the area or way it leads to</source>
        <translation>no hay ninguna región en un extremo de los escalones: dibuje el área o el camino al que llevan</translation>
    </message>
    <message>
        <source>steps left out: their line has no length</source>
        <translation>escalones dejados fuera: su línea no tiene longitud</translation>
    </message>
    <message>
        <source>nothing tells which way the walkway runs; it is taken to run both ways: set conveying to forward or backward</source>
        <translation>nada dice en qué sentido funciona el pasillo rodante; se supone que en ambos: indique forward o backward en conveying</translation>
    </message>
    <message>
        <source>no region lies at an end of the walkway: draw the area or way it leads to</source>
        <translation>no hay ninguna región en un extremo del pasillo rodante: dibuje el área o el camino al que lleva</translation>
    </message>
    <message>
        <source>the lift has no drawn door; one was put on a side that is open: move it to its place</source>
        <translation>el ascensor no tiene puerta dibujada; se puso una en un lado abierto: muévala a su sitio</translation>
    </message>
    <message>
        <source>features of the type %1 have no place in a building file</source>
        <translation>los elementos del tipo %1 no tienen lugar en un archivo de edificio</translation>
    </message>
    <message>
        <source>levels have no ordinal; they are taken as the ground floor</source>
        <translation>hay plantas sin ordinal, que se toman como planta baja</translation>
    </message>
    <message>
        <source>features name a level that does not exist; the ground floor is assumed</source>
        <translation>hay elementos que nombran una planta que no existe; se supone la planta baja</translation>
    </message>
    <message>
        <source>units have a category that IMDF 1.0 does not list; they are taken as rooms</source>
        <translation>hay unidades con una categoría que IMDF 1.0 no recoge, que se toman como salas</translation>
    </message>
    <message>
        <source>units are walls, columns or voids: they became walls</source>
        <translation>hay unidades que son paredes, columnas o huecos: pasaron a ser paredes</translation>
    </message>
    <message>
        <source>units have no outline and were left out</source>
        <translation>hay unidades sin contorno, que se dejaron fuera</translation>
    </message>
    <message>
        <source>occupants have no anchor in a unit and were left out</source>
        <translation>hay ocupantes sin ancla en una unidad, que se dejaron fuera</translation>
    </message>
    <message>
        <source>openings are emergency exits, for vehicles or out of service: nobody is led through them</source>
        <translation>hay aberturas que son salidas de emergencia, para vehículos o fuera de servicio: no se guía a nadie por ellas</translation>
    </message>
    <message>
        <source>openings have no line and were left out</source>
        <translation>hay aberturas sin línea, que se dejaron fuera</translation>
    </message>
    <message>
        <source>amenities have no point and were left out</source>
        <translation>hay servicios sin punto, que se dejaron fuera</translation>
    </message>
    <message>
        <source>amenities name no unit that tells their level and were left out</source>
        <translation>hay servicios que no nombran ninguna unidad que diga su planta, y se dejaron fuera</translation>
    </message>
    <message>
        <source>relationships do not name two units and were left out</source>
        <translation>hay relaciones que no nombran dos unidades, y se dejaron fuera</translation>
    </message>
    <message>
        <source>the name of the coordinate system is not known; a local plane in metres is assumed</source>
        <translation>el nombre del sistema de coordenadas no se conoce; se supone un plano local en metros</translation>
    </message>
    <message>
        <source>cells left out: they have no outline, no id, or the id of another</source>
        <translation>celdas dejadas fuera: no tienen contorno o identificador, o tienen el de otra</translation>
    </message>
    <message>
        <source>transitions left out: they do not connect two cells that are there</source>
        <translation>transiciones dejadas fuera: no unen dos celdas que existan</translation>
    </message>
    <message>
        <source>storeys are named by words; levels were taken from the heights</source>
        <translation>los pisos se nombran con palabras; se dedujeron de las alturas</translation>
    </message>
    <message>
        <source>nothing tells the levels: all is taken as level 0; name the field that holds the level</source>
        <translation>nada dice las plantas: todo se toma como planta 0; nombre el campo que tiene la planta</translation>
    </message>
    <message>
        <source>levels were counted from the heights of the floors</source>
        <translation>las plantas se contaron por la altura de los suelos</translation>
    </message>
    <message>
        <source>the door&apos;s cell does not lie between two rooms: it stays a region</source>
        <translation>la celda de la puerta no está entre dos salas: sigue siendo una región</translation>
    </message>
    <message>
        <source>features left out: they are no node, link, facility or entrance</source>
        <translation>elementos dejados fuera: no son nodo, enlace, instalación ni entrada</translation>
    </message>
    <message>
        <source>the network has no areas: each node became a region of strips along its links, cut half-way, and each facility a square of 2 m behind its entrance</source>
        <translation>la red no tiene áreas: cada nodo pasó a ser una región de franjas a lo largo de sus enlaces, cortadas a la mitad, y cada instalación un cuadrado de 2&#xa0;m tras su entrada</translation>
    </message>
    <message>
        <source>floor 0 is taken as the ground floor; import it with the level from 1 when it is floor 1</source>
        <translation>el piso 0 se toma como planta baja; impórtelo con la planta desde 1 si es el piso 1</translation>
    </message>
    <message>
        <source>floor 1 is taken as the ground floor; import it with the level from 0 when it is floor 0</source>
        <translation>el piso 1 se toma como planta baja; impórtelo con la planta desde 0 si es el piso 0</translation>
    </message>
    <message>
        <source>nodes left out: they have no place, no id, or the id of another</source>
        <translation>nodos dejados fuera: no tienen lugar o identificador, o tienen el de otro</translation>
    </message>
    <message>
        <source>nodes without a floor are taken to be on the ground</source>
        <translation>los nodos sin planta se toman como de la planta baja</translation>
    </message>
    <message>
        <source>links left out: they do not join two nodes that are there</source>
        <translation>enlaces dejados fuera: no unen dos nodos que existan</translation>
    </message>
    <message>
        <source>no link leads to the node</source>
        <translation>ningún enlace lleva al nodo</translation>
    </message>
    <message>
        <source>no entrance with a known node leads to the facility: it became a landmark</source>
        <translation>ninguna entrada con un nodo conocido lleva a la instalación: pasó a ser un punto de referencia</translation>
    </message>
    <message>
        <source>the facility of the entrance is missing</source>
        <translation>falta la instalación de la entrada</translation>
    </message>
    <message>
        <source>left out: it lies more than 20 m from every node of its floor</source>
        <translation>se dejó fuera: está a más de 20&#xa0;m de todos los nodos de su planta</translation>
    </message>
    <message numerus="yes">
        <source>%n spaces were closed from walls, doors and windows; they have no names, and whether they are rooms, corridors or halls is a guess from their doors and size</source>
        <translation>
            <numerusform>se cerró %n espacio a partir de paredes, puertas y ventanas; no tiene nombre, y si es sala, pasillo o vestíbulo es una suposición por sus puertas y su tamaño</numerusform>
            <numerusform>se cerraron %n espacios a partir de paredes, puertas y ventanas; no tienen nombre, y si son salas, pasillos o vestíbulos es una suposición por sus puertas y su tamaño</numerusform>
        </translation>
    </message>
    <message>
        <source>strips under 0.3 m between walls were left out</source>
        <translation>se dejaron fuera franjas de menos de 0,3&#xa0;m entre paredes</translation>
    </message>
    <message>
        <source>no space lies on one side of the door: it leads outside, or a wall is missing</source>
        <translation>a un lado de la puerta no hay espacio: da al exterior, o falta una pared</translation>
    </message>
    <message>
        <source>%1, layer %2</source>
        <translation>%1, capa %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, feature %2</source>
        <translation>%1, elemento %2</translation>
    </message>
    <message>
        <source>%1, feature number %2</source>
        <translation>%1, elemento número %2</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línea %2</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, planta %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>no existe ese archivo</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>no existe ese archivo o carpeta</translation>
    </message>
    <message>
        <source>is no file or folder</source>
        <translation>no es un archivo ni una carpeta</translation>
    </message>
    <message>
        <source>is a folder; a file is wanted</source>
        <translation>es una carpeta; se quiere un archivo</translation>
    </message>
    <message>
        <source>holds no files</source>
        <translation>no contiene archivos</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>no se puede abrir</translation>
    </message>
    <message>
        <source>cannot be listed (%1)</source>
        <translation>no se puede listar (%1)</translation>
    </message>
    <message>
        <source>is not a map file that can be read</source>
        <translation>no es un archivo de mapa que se pueda leer</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>no se puede leer hasta el final</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>no se puede leer (%1)</translation>
    </message>
    <message>
        <source>cannot be imported (%1)</source>
        <translation>no se puede importar (%1)</translation>
    </message>
    <message>
        <source>the map cannot be put together (%1)</source>
        <translation>no se puede componer el mapa (%1)</translation>
    </message>
    <message>
        <source>reading the map failed: %1</source>
        <translation>la lectura del mapa falló: %1</translation>
    </message>
    <message>
        <source>is empty or cannot be read</source>
        <translation>está vacío o no se puede leer</translation>
    </message>
    <message>
        <source>is no indoor map of a kind that is known: %1 was tried as %2; name its kind, or give a profile with its column names</source>
        <translation>no es un mapa de interiores de un tipo conocido: se probó %1 como %2; indique el tipo, o dé un perfil con los nombres de las columnas</translation>
    </message>
    <message>
        <source>holds no file of the format %1</source>
        <translation>no contiene ningún archivo del formato %1</translation>
    </message>
    <message>
        <source>is larger than 1 GB: too much for a map of a building</source>
        <translation>ocupa más de 1 GB: demasiado para el mapa de un edificio</translation>
    </message>
    <message>
        <source>is larger than %1 MB: no map of a building is</source>
        <translation>ocupa más de %1 MB: ningún mapa de edificio los ocupa</translation>
    </message>
    <message>
        <source>holds more than 10000 files: name the folder of one building</source>
        <translation>contiene más de 10000 archivos: indique la carpeta de un solo edificio</translation>
    </message>
    <message>
        <source>the database cannot be opened</source>
        <translation>no se puede abrir la base de datos</translation>
    </message>
    <message>
        <source>the zip holds more than 10000 files: no map of a building does</source>
        <translation>el zip contiene más de 10000 archivos: ningún mapa de edificio los tiene</translation>
    </message>
    <message>
        <source>a file in the zip has a name that leads out of it; the zip is not trusted</source>
        <translation>un archivo del zip tiene un nombre que lleva fuera de él; el zip no es de fiar</translation>
    </message>
    <message>
        <source>the zip is locked by a password; unpack it first</source>
        <translation>el zip está cerrado con una contraseña; descomprímalo antes</translation>
    </message>
    <message>
        <source>unpacks to %1 MB: too much for a map of a building</source>
        <translation>descomprimido ocupa %1 MB: demasiado para el mapa de un edificio</translation>
    </message>
    <message>
        <source>the zip&apos;s list of files is damaged; make the zip again</source>
        <translation>la lista de archivos del zip está dañada; haga el zip de nuevo</translation>
    </message>
    <message>
        <source>the zip is cut off: its list of files is missing; copy it again</source>
        <translation>el zip está cortado: falta su lista de archivos; cópielo de nuevo</translation>
    </message>
    <message>
        <source>the zip is larger than any map; unpack it and name the folder</source>
        <translation>el zip es mayor que cualquier mapa; descomprímalo e indique la carpeta</translation>
    </message>
    <message>
        <source>the zip&apos;s list of files lies outside it; make the zip again</source>
        <translation>la lista de archivos del zip queda fuera de él; haga el zip de nuevo</translation>
    </message>
    <message>
        <source>is a landmark library without a map: name the file of the building</source>
        <translation>es una biblioteca de puntos de referencia sin mapa: indique el archivo del edificio</translation>
    </message>
    <message>
        <source>is not a Farol map: it has no layer regions; import maps of another kind first</source>
        <translation>no es un mapa de Farol: no tiene la capa regions; importe antes los mapas de otro tipo</translation>
    </message>
    <message>
        <source>the map is in degrees (%1); metres are wanted: import or reproject it</source>
        <translation>el mapa está en grados (%1); se quieren metros: impórtelo o reproyéctelo</translation>
    </message>
    <message>
        <source>the map&apos;s unit is not the metre (%1): reproject it</source>
        <translation>la unidad del mapa no es el metro (%1): reproyéctelo</translation>
    </message>
    <message>
        <source>the field %1 is missing; add and fill it</source>
        <translation>falta el campo %1; añádalo y rellénelo</translation>
    </message>
    <message>
        <source>the schema version &quot;%1&quot; is no version</source>
        <translation>la versión del esquema “%1” no es una versión</translation>
    </message>
    <message>
        <source>the map has schema version %1, this Farol knows %2: use a newer Farol</source>
        <translation>el mapa tiene la versión de esquema %1, y este Farol conoce la %2: use un Farol más nuevo</translation>
    </message>
    <message>
        <source>the map has no regions; draw at least one</source>
        <translation>el mapa no tiene regiones; dibuje al menos una</translation>
    </message>
    <message>
        <source>two features have this id; give each its own</source>
        <translation>dos elementos tienen este identificador; dé a cada uno el suyo</translation>
    </message>
    <message>
        <source>this level is listed twice; remove one</source>
        <translation>esta planta está dos veces en la lista; quite una</translation>
    </message>
    <message>
        <source>oneway is &quot;%1&quot;; a_to_b, b_to_a or nothing is wanted</source>
        <translation>oneway es “%1”; se quiere a_to_b, b_to_a o nada</translation>
    </message>
    <message>
        <source>has no %1; fill it in</source>
        <translation>no tiene %1; rellénelo</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 no es un número</translation>
    </message>
    <message>
        <source>%1 is no whole number within reason</source>
        <translation>%1 no es un número entero razonable</translation>
    </message>
    <message>
        <source>%1 is neither 0 nor 1</source>
        <translation>%1 no es 0 ni 1</translation>
    </message>
    <message>
        <source>level %1 is no floor of a building</source>
        <translation>la planta %1 no es una planta de un edificio</translation>
    </message>
    <message>
        <source>has no geometry; a %1 is wanted</source>
        <translation>no tiene forma; se quiere %1</translation>
    </message>
    <message>
        <source>consists of %1 parts; a single %2 is wanted: split it and give each part its own id</source>
        <translation>tiene %1 partes; se quiere una sola (%2): divídalo y dé a cada parte su identificador</translation>
    </message>
    <message>
        <source>has a coordinate that is no number</source>
        <translation>tiene una coordenada que no es un número</translation>
    </message>
    <message>
        <source>has a coordinate beyond any metric map</source>
        <translation>tiene una coordenada fuera de cualquier mapa en metros</translation>
    </message>
    <message>
        <source>is an outline without an area</source>
        <translation>es un contorno sin superficie</translation>
    </message>
    <message>
        <source>is a %1; a %2 is wanted</source>
        <translation>es %1; se quiere %2</translation>
    </message>
    <message>
        <source>has no outline</source>
        <translation>no tiene contorno</translation>
    </message>
    <message>
        <source>there are no rooms, corridors or other areas in it: nothing to walk through</source>
        <translation>no hay en él salas, pasillos ni otras áreas: nada por donde andar</translation>
    </message>
    <message>
        <source>has %1 levels: no building has; the level stands in another attribute: name that one</source>
        <translation>tiene %1 plantas: ningún edificio las tiene; la planta está en otro atributo: indíquelo</translation>
    </message>
    <message>
        <source>the map has no coordinates</source>
        <translation>el mapa no tiene coordenadas</translation>
    </message>
    <message>
        <source>geocentric coordinates are no plan of a floor; project them</source>
        <translation>las coordenadas geocéntricas no son el plano de una planta; proyéctelas</translation>
    </message>
    <message>
        <source>coordinates are beyond 100,000 km: they are no metres of a building</source>
        <translation>las coordenadas pasan de 100&#xa0;000 km: no son metros de un edificio</translation>
    </message>
    <message>
        <source>the coordinates do not lie where their CRS is defined</source>
        <translation>las coordenadas no están donde su sistema está definido</translation>
    </message>
    <message>
        <source>the CRS cannot be brought to metres</source>
        <translation>no se puede pasar el sistema de coordenadas a metros</translation>
    </message>
    <message>
        <source>holds more than a million features: no building does</source>
        <translation>tiene más de un millón de elementos: ningún edificio los tiene</translation>
    </message>
    <message>
        <source>has more than 500,000 features: no building has</source>
        <translation>tiene más de 500&#xa0;000 elementos: ningún edificio los tiene</translation>
    </message>
    <message>
        <source>the shapes have no heights (z) that levels could be taken from; name a column instead</source>
        <translation>las formas no tienen alturas (z) de las que deducir las plantas; indique en su lugar una columna</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through: name the folder with all layers, or say what they are in a profile</source>
        <translation>no contiene salas, pasillos ni otras áreas por donde andar: indique la carpeta con todas las capas, o diga en un perfil qué son</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; %1 and what else is a door touches no region (access-joins-two-regions): name the folder with all layers, or say what they are in a profile</source>
        <translation>no contiene salas, pasillos ni otras áreas por donde andar; %1 y lo demás que es puerta no tocan ninguna región: indique la carpeta con todas las capas, o diga en un perfil qué son</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; lines alone enclose no rooms (layer-role): name the folder with all layers, or say what they are in a profile</source>
        <translation>no contiene salas, pasillos ni otras áreas por donde andar; las líneas solas no encierran salas: indique la carpeta con todas las capas, o diga en un perfil qué son</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; there are no features in %1 (layer-empty): name the folder with all layers, or say what they are in a profile</source>
        <translation>no contiene salas, pasillos ni otras áreas por donde andar; no hay elementos en %1: indique la carpeta con todas las capas, o diga en un perfil qué son</translation>
    </message>
    <message>
        <source>is no GeoJSON FeatureCollection</source>
        <translation>no es una FeatureCollection de GeoJSON</translation>
    </message>
    <message>
        <source>is nested deeper than any map</source>
        <translation>está anidado más hondo que cualquier mapa</translation>
    </message>
    <message>
        <source>is damaged JSON (%1)</source>
        <translation>es JSON dañado (%1)</translation>
    </message>
    <message>
        <source>is no JSON object with columns, codes, levels or layers</source>
        <translation>no es un objeto JSON con columns, codes, levels o layers</translation>
    </message>
    <message>
        <source>there is no column meaning &quot;%1&quot;</source>
        <translation>no hay ninguna columna que signifique “%1”</translation>
    </message>
    <message>
        <source>the role of layer &quot;%1&quot; is unknown</source>
        <translation>el papel de la capa “%1” es desconocido</translation>
    </message>
    <message>
        <source>makes more than 20,000 regions on its levels, or its ways cross too many of them: cut the building out of it</source>
        <translation>da más de 20&#xa0;000 regiones en sus plantas, o sus caminos cruzan demasiadas: recorte de él el edificio</translation>
    </message>
    <message>
        <source>holds no indoor areas: rooms, corridors and areas must be tagged indoor=* with a level</source>
        <translation>no contiene áreas interiores: salas, pasillos y áreas deben llevar la etiqueta indoor=* con una planta</translation>
    </message>
    <message>
        <source>has more than 500,000 tagged features: cut the building out of it</source>
        <translation>tiene más de 500&#xa0;000 elementos con etiquetas: recorte de él el edificio</translation>
    </message>
    <message>
        <source>is damaged OpenStreetMap data</source>
        <translation>son datos de OpenStreetMap dañados</translation>
    </message>
    <message>
        <source>cannot be read as OpenStreetMap data</source>
        <translation>no se puede leer como datos de OpenStreetMap</translation>
    </message>
    <message>
        <source>holds no OpenStreetMap file (.osm, .osm.pbf or GeoJSON made of one)</source>
        <translation>no contiene ningún archivo de OpenStreetMap (.osm, .osm.pbf o GeoJSON hecho de uno)</translation>
    </message>
    <message>
        <source>holds no unit.geojson: name the folder or zip of an IMDF venue</source>
        <translation>no contiene unit.geojson: indique la carpeta o el zip de un mapa IMDF</translation>
    </message>
    <message>
        <source>holds %1 IMDF venues: name the folder of one of them, such as %2</source>
        <translation>contiene %1 mapas IMDF: indique la carpeta de uno de ellos, como %2</translation>
    </message>
    <message>
        <source>has more than 20,000 nodes or facilities or 50,000 links: cut the building out of it</source>
        <translation>tiene más de 20&#xa0;000 nodos o instalaciones o 50&#xa0;000 enlaces: recorte de él el edificio</translation>
    </message>
    <message>
        <source>holds no node of a route network with a place</source>
        <translation>no contiene ningún nodo de una red de caminos con lugar</translation>
    </message>
    <message>
        <source>has more than 200,000 features</source>
        <translation>tiene más de 200&#xa0;000 elementos</translation>
    </message>
    <message>
        <source>is XML, but not IndoorGML (IndoorFeatures)</source>
        <translation>es XML, pero no IndoorGML (IndoorFeatures)</translation>
    </message>
    <message>
        <source>has more than 50,000 cells</source>
        <translation>tiene más de 50&#xa0;000 celdas</translation>
    </message>
    <message>
        <source>has no cell with a usable outline: Farol needs CellSpace geometry</source>
        <translation>no tiene ninguna celda con contorno utilizable: Farol necesita la geometría de CellSpace</translation>
    </message>
    <message>
        <source>has no cells but doors: rooms and corridors are missing</source>
        <translation>solo tiene celdas de puertas: faltan salas y pasillos</translation>
    </message>
    <message>
        <source>holds no IndoorGML file</source>
        <translation>no contiene ningún archivo IndoorGML</translation>
    </message>
    <message>
        <source>is damaged XML: %1</source>
        <translation>es XML dañado: %1</translation>
    </message>
    <message>
        <source>has more than two million elements</source>
        <translation>tiene más de dos millones de elementos</translation>
    </message>
    <message>
        <source>is nested deeper than 100 elements</source>
        <translation>tiene más de 100 niveles de elementos anidados</translation>
    </message>
    <message>
        <source>declares entities, which no map needs</source>
        <translation>declara entidades, que ningún mapa necesita</translation>
    </message>
    <message>
        <source>lists no levels, as main.json of a WRLD map does</source>
        <translation>no lista plantas, como hace el main.json de un mapa WRLD</translation>
    </message>
    <message>
        <source>lists more than 300 levels</source>
        <translation>lista más de 300 plantas</translation>
    </message>
    <message>
        <source>a level has no z_order of its own</source>
        <translation>una planta no tiene z_order propio</translation>
    </message>
    <message>
        <source>no floor has a room or an outline with walls</source>
        <translation>ninguna planta tiene una sala o un contorno con paredes</translation>
    </message>
    <message>
        <source>the floor&apos;s file &quot;%1&quot; is missing: import the folder or zip that holds it</source>
        <translation>falta el archivo de la planta, “%1”: importe la carpeta o el zip que lo contiene</translation>
    </message>
    <message>
        <source>has more than 10,000 features on a floor or 40,000 in all: no building has</source>
        <translation>tiene más de 10&#xa0;000 elementos en una planta o 40&#xa0;000 en total: ningún edificio los tiene</translation>
    </message>
    <message>
        <source>holds no main.json: name the folder or zip of the WRLD map</source>
        <translation>no contiene main.json: indique la carpeta o el zip del mapa WRLD</translation>
    </message>
    <message>
        <source>is damaged (%1)</source>
        <translation>está dañado (%1)</translation>
    </message>
    <message>
        <source>the region has no outline</source>
        <translation>la región no tiene contorno</translation>
    </message>
    <message>
        <source>the access has no place on the map</source>
        <translation>el paso no tiene lugar en el mapa</translation>
    </message>
    <message>
        <source>both sides are the same region: choose another one</source>
        <translation>ambos lados son la misma región: elija otra</translation>
    </message>
    <message>
        <source>the width must be above 0 m, and the steps 0 or more</source>
        <translation>la anchura debe ser mayor que 0&#xa0;m, y los escalones 0 o más</translation>
    </message>
    <message>
        <source>the landmark has no place on the map</source>
        <translation>el punto de referencia no tiene lugar en el mapa</translation>
    </message>
    <message>
        <source>the width and the height of the object must be above 0 m</source>
        <translation>la anchura y la altura del objeto deben ser mayores que 0&#xa0;m</translation>
    </message>
    <message>
        <source>the map has this name already</source>
        <translation>el mapa ya tiene este nombre</translation>
    </message>
    <message>
        <source>the map does not hold it any more</source>
        <translation>el mapa ya no lo tiene</translation>
    </message>
    <message>
        <source>the map there is of a later Farol; save under another name or use the newer Farol</source>
        <translation>el mapa que hay allí es de un Farol posterior; guarde con otro nombre o use el Farol más nuevo</translation>
    </message>
    <message>
        <source>is another kind of file; save under a name that ends in .gpkg</source>
        <translation>es otro tipo de archivo; guarde con un nombre que acabe en .gpkg</translation>
    </message>
    <message>
        <source>another program has the file open and writes to it; close it there and save again</source>
        <translation>otro programa tiene el archivo abierto y escribe en él; ciérrelo allí y guarde de nuevo</translation>
    </message>
    <message>
        <source>the disk is full: free some space and save again; what was there before is untouched</source>
        <translation>el disco está lleno: libere espacio y guarde de nuevo; lo que había antes está intacto</translation>
    </message>
    <message>
        <source>the map was changed by someone else since it was read; nothing was written: read it again and repeat the change</source>
        <translation>otra persona ha cambiado el mapa desde que se leyó; no se escribió nada: léalo de nuevo y repita el cambio</translation>
    </message>
    <message>
        <source>there is no field level; level 0 is assumed</source>
        <translation>falta el campo level; se supone la planta 0</translation>
    </message>
    <message>
        <source>there is no layer %1</source>
        <translation>falta la capa %1</translation>
    </message>
    <message>
        <source>%1 do not join two regions and are not walked through: %2</source>
        <translation>%1 no unen dos regiones y no se pasa por ellos: %2</translation>
    </message>
    <message>
        <source>unknown kind &quot;%1&quot;, treated as other: %2</source>
        <translation>tipo desconocido “%1”, tratado como otro: %2</translation>
    </message>
    <message>
        <source>no kind, treated as other: %1</source>
        <translation>sin tipo, tratado como otro: %1</translation>
    </message>
    <message>
        <source>a place is empty: give a region&apos;s id, name or ref, or x,y,level</source>
        <translation>el lugar está vacío: indique el identificador, el nombre o la referencia de una región, o x,y,planta</translation>
    </message>
    <message>
        <source>no region of level %1 holds this point</source>
        <translation>ninguna región de la planta %1 contiene este punto</translation>
    </message>
    <message>
        <source>several regions are called so: %1; give one of these ids</source>
        <translation>hay varias regiones con este nombre: %1; indique uno de estos identificadores</translation>
    </message>
    <message>
        <source>no region has this id, name or ref</source>
        <translation>ninguna región tiene este identificador, nombre ni referencia</translation>
    </message>
    <message>
        <source>no region has this id, name or ref; near spellings: %1</source>
        <translation>ninguna región tiene este identificador, nombre ni referencia; parecidos: %1</translation>
    </message>
    <message>
        <source>%1 (level %2)</source>
        <translation>%1 (planta %2)</translation>
    </message>
    <message>
        <source>the map has no region &quot;%1&quot;</source>
        <translation>el mapa no tiene la región “%1”</translation>
    </message>
    <message>
        <source>the position is no number</source>
        <translation>la posición no es un número</translation>
    </message>
    <message>
        <source>is out of its range</source>
        <translation>está fuera de sus límites</translation>
    </message>
    <message>
        <source>has an outline that is none</source>
        <translation>tiene un contorno que no lo es</translation>
    </message>
    <message>
        <source>has no position</source>
        <translation>no tiene posición</translation>
    </message>
    <message>
        <source>a wall has no length</source>
        <translation>una pared no tiene longitud</translation>
    </message>
    <message>
        <source>the map cannot be written there</source>
        <translation>no se puede escribir el mapa allí</translation>
    </message>
    <message>
        <source>cannot be copied before saving</source>
        <translation>no se puede copiar antes de guardar</translation>
    </message>
    <message>
        <source>writing the map failed: %1</source>
        <translation>no se pudo escribir el mapa: %1</translation>
    </message>
    <message>
        <source>the map may not be changed now: someone else is changing it, or the user has no right to; nothing was written, save again in a moment</source>
        <translation>ahora no se puede cambiar el mapa: otra persona lo está cambiando, o el usuario no tiene derecho a ello; no se escribió nada, guarde de nuevo en un momento</translation>
    </message>
    <message>
        <source>the database has no PostGIS: ask its administrator to add that extension</source>
        <translation>la base de datos no tiene PostGIS: pida a su administrador que añada esa extensión</translation>
    </message>
    <message>
        <source>this is no picture that can be read; use PNG, JPEG or GeoTIFF</source>
        <translation>esto no es una imagen que se pueda leer; use PNG, JPEG o GeoTIFF</translation>
    </message>
    <message>
        <source>the picture is damaged: save it anew</source>
        <translation>la imagen está dañada: guárdela de nuevo</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>permiso denegado</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>el archivo o la carpeta no existe</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>el sistema de archivos es de solo lectura</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>no queda espacio en el disco</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>error de lectura o escritura</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>es una carpeta</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>no es una carpeta</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>el nombre del archivo es demasiado largo</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>la operación no está permitida</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>hay demasiados archivos abiertos</translation>
    </message>
    <message>
        <source>cannot be read as a picture</source>
        <translation>no se puede leer como imagen</translation>
    </message>
    <message>
        <source>no source was named: give camera:0, a video file, a folder of pictures or an address</source>
        <translation>no se indicó ninguna fuente: dé camera:0, un archivo de vídeo, una carpeta de imágenes o una dirección</translation>
    </message>
    <message>
        <source>there is no such file or folder (a source is camera:0, a video file, a folder of pictures, or an http or rtsp address)</source>
        <translation>no existe ese archivo ni esa carpeta (una fuente es camera:0, un archivo de vídeo, una carpeta de imágenes o una dirección http o rtsp)</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>no se puede leer la carpeta</translation>
    </message>
    <message>
        <source>there are no pictures in this folder (jpg, png, bmp, webp or tif)</source>
        <translation>no hay imágenes en esta carpeta (jpg, png, bmp, webp o tif)</translation>
    </message>
    <message>
        <source>is neither a picture nor a video that can be opened (tried FFmpeg and GStreamer)</source>
        <translation>no es una imagen ni un vídeo que se pueda abrir (se probaron FFmpeg y GStreamer)</translation>
    </message>
    <message>
        <source>the address does not answer with a video within %1 s (tried FFmpeg): is the camera on, and the address right?</source>
        <translation>la dirección no responde con un vídeo en %1 s (se probó FFmpeg): ¿está encendida la cámara, y es correcta la dirección?</translation>
    </message>
    <message>
        <source>a camera is named by its number or its device, such as camera:0</source>
        <translation>una cámara se indica por su número o dispositivo, como camera:0</translation>
    </message>
    <message>
        <source>the camera cannot be opened (tried Video4Linux at %1): is it plugged in, and not in use by another program?</source>
        <translation>no se puede abrir la cámara (se probó Video4Linux en %1): ¿está conectada, y no la usa otro programa?</translation>
    </message>
    <message>
        <source>%1 delivers no more pictures</source>
        <translation>%1 ya no entrega imágenes</translation>
    </message>
    <message>
        <source>%1 gives no more pictures</source>
        <translation>%1 ha dejado de dar imágenes</translation>
    </message>
    <message>
        <source>%1 is tried again (attempt %2)</source>
        <translation>se intenta de nuevo %1 (intento %2)</translation>
    </message>
    <message>
        <source>%1 is back</source>
        <translation>%1 ha vuelto</translation>
    </message>
    <message>
        <source>%1 broke down: %2</source>
        <translation>%1 falló: %2</translation>
    </message>
    <message>
        <source>the library&apos;s version is not a number: &quot;%1&quot;</source>
        <translation>la versión de la biblioteca no es un número: “%1”</translation>
    </message>
    <message>
        <source>the landmark library is of a later version (%1) than this program knows (%2); update Farol</source>
        <translation>la biblioteca de puntos de referencia es de una versión (%1) posterior a la que conoce este programa (%2); actualice Farol</translation>
    </message>
    <message>
        <source>holds no landmark library (no layers templates and views)</source>
        <translation>no contiene una biblioteca de puntos de referencia (faltan las capas templates y views)</translation>
    </message>
    <message>
        <source>the landmark library cannot be read</source>
        <translation>no se puede leer la biblioteca de puntos de referencia</translation>
    </message>
    <message>
        <source>cannot save the library: %1</source>
        <translation>no se puede guardar la biblioteca: %1</translation>
    </message>
    <message>
        <source>is not a GeoPackage, and a library is kept in one (*.gpkg)</source>
        <translation>no es un GeoPackage, y una biblioteca se guarda en uno (*.gpkg)</translation>
    </message>
    <message>
        <source>a template has no name</source>
        <translation>un punto de referencia no tiene nombre</translation>
    </message>
    <message>
        <source>template %1 stands twice</source>
        <translation>el punto de referencia %1 aparece dos veces</translation>
    </message>
    <message>
        <source>a view belongs to a template that is not in the library</source>
        <translation>una fotografía es de un punto de referencia que no está en la biblioteca</translation>
    </message>
    <message>
        <source>the photograph or its outline is missing</source>
        <translation>falta la fotografía o su contorno</translation>
    </message>
    <message>
        <source>the extractor&apos;s parameters cannot be read: &quot;%1&quot;</source>
        <translation>no se pueden leer los parámetros del extractor: “%1”</translation>
    </message>
    <message>
        <source>the library was trained with %1, but %2; train it again from its photographs</source>
        <translation>la biblioteca se entrenó con %1, pero %2; entrénela de nuevo a partir de sus fotografías</translation>
    </message>
    <message>
        <source>the library was trained with %1, but %2 is in use; train it again from its photographs, or choose its own extractor</source>
        <translation>la biblioteca se entrenó con %1, pero se usa %2; entrénela de nuevo a partir de sus fotografías, o elija su propio extractor</translation>
    </message>
    <message>
        <source>there is no feature extractor &quot;%1&quot;; there are %2</source>
        <translation>no hay ningún extractor “%1”; hay %2</translation>
    </message>
    <message>
        <source>version %1 of %2 is not known, only %3</source>
        <translation>no se conoce la versión %1 de %2, solo la %3</translation>
    </message>
    <message>
        <source>the working size must be between 64 and 4096 pixels</source>
        <translation>el tamaño de trabajo debe estar entre 64 y 4096 píxeles</translation>
    </message>
    <message>
        <source>the number of keypoints must be between 10 and 20000</source>
        <translation>el número de puntos clave debe estar entre 10 y 20000</translation>
    </message>
    <message>
        <source>the contrast threshold must be between 0 and 1</source>
        <translation>el umbral de contraste debe estar entre 0 y 1</translation>
    </message>
    <message>
        <source>%1; the library is damaged: restore it or train this view again</source>
        <translation>%1; la biblioteca está dañada: restáurela o entrene de nuevo esta fotografía</translation>
    </message>
    <message>
        <source>the outline &quot;%1&quot; is not eight numbers</source>
        <translation>el contorno “%1” no son ocho números</translation>
    </message>
    <message>
        <source>the descriptors are not of the width that %1 makes</source>
        <translation>los descriptores no tienen el ancho que produce %1</translation>
    </message>
    <message>
        <source>the photograph&apos;s size is missing</source>
        <translation>falta el tamaño de la fotografía</translation>
    </message>
    <message>
        <source>the checksum does not fit the photograph and its features</source>
        <translation>la suma de control no corresponde a la fotografía y sus características</translation>
    </message>
    <message>
        <source>the keypoints do not begin as they should</source>
        <translation>los puntos clave no empiezan como deben</translation>
    </message>
    <message>
        <source>the keypoints have an impossible size</source>
        <translation>los puntos clave tienen un tamaño imposible</translation>
    </message>
    <message>
        <source>the keypoints are cut off or too long</source>
        <translation>los puntos clave están cortados o son demasiado largos</translation>
    </message>
    <message>
        <source>the keypoints are of another kind</source>
        <translation>los puntos clave son de otro tipo</translation>
    </message>
    <message>
        <source>a keypoint has an impossible value</source>
        <translation>un punto clave tiene un valor imposible</translation>
    </message>
    <message>
        <source>the descriptors do not begin as they should</source>
        <translation>los descriptores no empiezan como deben</translation>
    </message>
    <message>
        <source>the descriptors have an impossible size</source>
        <translation>los descriptores tienen un tamaño imposible</translation>
    </message>
    <message>
        <source>the descriptors are cut off or too long</source>
        <translation>los descriptores están cortados o son demasiado largos</translation>
    </message>
    <message>
        <source>the descriptors are of another kind</source>
        <translation>los descriptores son de otro tipo</translation>
    </message>
    <message>
        <source>there are not as many descriptors as keypoints</source>
        <translation>no hay tantos descriptores como puntos clave</translation>
    </message>
    <message>
        <source>cannot replace the layer</source>
        <translation>no se puede sustituir la capa</translation>
    </message>
    <message>
        <source>cannot make the layer</source>
        <translation>no se puede crear la capa</translation>
    </message>
    <message>
        <source>cannot make the field %1</source>
        <translation>no se puede crear el campo %1</translation>
    </message>
    <message>
        <source>cannot replace the version</source>
        <translation>no se puede sustituir la versión</translation>
    </message>
    <message>
        <source>the layer has no fields key and value: this is not one of Farol&apos;s files</source>
        <translation>la capa no tiene los campos key y value: este archivo no es de Farol</translation>
    </message>
    <message>
        <source>no view is chosen</source>
        <translation>no hay ninguna fotografía elegida</translation>
    </message>
    <message>
        <source>a template needs at least one view; delete it instead</source>
        <translation>un punto de referencia necesita al menos una fotografía; en su lugar, elimínelo</translation>
    </message>
    <message>
        <source>a template needs a name of its own</source>
        <translation>un punto de referencia necesita un nombre propio</translation>
    </message>
    <message>
        <source>this name is taken by another template</source>
        <translation>otro punto de referencia ya tiene este nombre</translation>
    </message>
    <message>
        <source>a template needs at least one view</source>
        <translation>un punto de referencia necesita al menos una fotografía</translation>
    </message>
    <message>
        <source>a real size must be a positive number of metres</source>
        <translation>un tamaño real debe ser un número positivo de metros</translation>
    </message>
    <message>
        <source>a template cannot be merged with itself</source>
        <translation>un punto de referencia no se puede unir consigo mismo</translation>
    </message>
    <message>
        <source>a place and an object cannot be one template; choose two of the same sort</source>
        <translation>un lugar y un objeto no pueden ser un solo punto de referencia; elija dos del mismo tipo</translation>
    </message>
    <message>
        <source>the outline has a corner that is no number</source>
        <translation>el contorno tiene una esquina que no es un número</translation>
    </message>
    <message>
        <source>the outline leaves the picture, which is %1 x %2 pixels</source>
        <translation>el contorno se sale de la imagen, que tiene %1 x %2 píxeles</translation>
    </message>
    <message>
        <source>the outline&apos;s four corners must follow the object&apos;s border clockwise from its top left, without crossing</source>
        <translation>las cuatro esquinas del contorno deben seguir el borde del objeto en el sentido de las agujas del reloj desde arriba a la izquierda, sin cruzarse</translation>
    </message>
    <message>
        <source>the outline&apos;s corners run counter-clockwise; give them clockwise from the object&apos;s top left</source>
        <translation>las esquinas del contorno van en sentido contrario a las agujas del reloj; delas en ese sentido desde arriba a la izquierda del objeto</translation>
    </message>
    <message>
        <source>the outline is only %1 x %2 pixels; photograph the object from nearer</source>
        <translation>el contorno tiene solo %1 x %2 píxeles; fotografíe el objeto desde más cerca</translation>
    </message>
    <message>
        <source>a template needs a name</source>
        <translation>un punto de referencia necesita un nombre</translation>
    </message>
    <message>
        <source>this template is of kind %1, not %2; use another template name</source>
        <translation>este punto de referencia es del tipo %1, no %2; use otro nombre</translation>
    </message>
    <message>
        <source>only %1 features were found in the picture; at least %2 are needed: take a sharp, well lit photograph of something with detail, from nearer</source>
        <translation>solo se encontraron %1 características en la imagen; se necesitan al menos %2: haga una fotografía nítida y bien iluminada de algo con detalles, desde más cerca</translation>
    </message>
    <message>
        <source>only %1 features were found inside the outline; at least %2 are needed: take a sharp, well lit photograph of something with detail, from nearer</source>
        <translation>solo se encontraron %1 características dentro del contorno; se necesitan al menos %2: haga una fotografía nítida y bien iluminada de algo con detalles, desde más cerca</translation>
    </message>
    <message>
        <source>the photograph cannot be read as a picture</source>
        <translation>no se puede leer la fotografía como imagen</translation>
    </message>
    <message>
        <source>the photograph cannot be used: %1</source>
        <translation>no se puede usar la fotografía: %1</translation>
    </message>
    <message>
        <source>template %1</source>
        <translation>punto de referencia %1</translation>
    </message>
    <message>
        <source>%1, template %2</source>
        <translation>%1, punto de referencia %2</translation>
    </message>
    <message>
        <source>%1, view %2</source>
        <translation>%1, fotografía %2</translation>
    </message>
    <message>
        <source>%1, a view of template %2</source>
        <translation>%1, una fotografía del punto de referencia %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, fila %2</translation>
    </message>
    <message>
        <source>cannot reopen for writing</source>
        <translation>no se puede volver a abrir para escribir</translation>
    </message>
    <message>
        <source>cannot write to disk</source>
        <translation>no se puede escribir en el disco</translation>
    </message>
    <message>
        <source>cannot copy before saving</source>
        <translation>no se puede hacer la copia antes de guardar</translation>
    </message>
    <message>
        <source>cannot put the new file in place</source>
        <translation>no se puede poner el archivo nuevo en su sitio</translation>
    </message>
    <message>
        <source>is no ordinary file; name another one</source>
        <translation>no es un archivo común; indique otro</translation>
    </message>
    <message>
        <source>cannot open</source>
        <translation>no se pudo abrir</translation>
    </message>
    <message>
        <source>cannot read</source>
        <translation>no se puede leer</translation>
    </message>
    <message>
        <source>cannot write</source>
        <translation>no se puede escribir</translation>
    </message>
    <message>
        <source>cannot begin to write</source>
        <translation>no se puede empezar a escribir</translation>
    </message>
    <message>
        <source>cannot finish writing</source>
        <translation>no se puede terminar de escribir</translation>
    </message>
    <message>
        <source>cannot create the file</source>
        <translation>no se puede crear el archivo</translation>
    </message>
    <message>
        <source>this GDAL has no GeoPackage driver</source>
        <translation>este GDAL no tiene controlador de GeoPackage</translation>
    </message>
    <message>
        <source>the connection cannot be understood: write PG: and then key=value pairs such as dbname=campus host=maps user=anna, values with blanks in single quotes</source>
        <translation>no se entiende la conexión: escriba PG: y luego pares clave=valor, como dbname=campus host=maps user=anna, con los valores que tienen espacios entre comillas simples</translation>
    </message>
    <message>
        <source>%1; skipped (%2 so far)</source>
        <translation>%1; se saltó (%2 hasta ahora)</translation>
    </message>
    <message>
        <source>%1 cannot be read as a picture</source>
        <translation>%1: no se puede leer como imagen</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>no existe esa carpeta</translation>
    </message>
    <message>
        <source>is not a recording: it holds no recording.json</source>
        <translation>no es una grabación: no contiene recording.json</translation>
    </message>
    <message>
        <source>is not JSON</source>
        <translation>no es JSON</translation>
    </message>
    <message>
        <source>is not the header of a recording</source>
        <translation>no es la cabecera de una grabación</translation>
    </message>
    <message>
        <source>was made by a later version of Farol (recording format %1, this program reads up to %2)</source>
        <translation>la hizo una versión posterior de Farol (formato de grabación %1; este programa lee hasta el %2)</translation>
    </message>
    <message>
        <source>is neither a percept nor a command</source>
        <translation>no es una observación ni una orden</translation>
    </message>
    <message>
        <source>is a file; a new or empty folder is wanted for a recording</source>
        <translation>es un archivo; para una grabación se quiere una carpeta nueva o vacía</translation>
    </message>
    <message>
        <source>is not empty; choose a new folder, so that no recording is overwritten</source>
        <translation>no está vacía; elija una carpeta nueva, para que no se sobrescriba ninguna grabación</translation>
    </message>
    <message>
        <source>cannot create</source>
        <translation>no se puede crear</translation>
    </message>
    <message>
        <source>cannot create the recording</source>
        <translation>no se puede crear la grabación</translation>
    </message>
    <message>
        <source>cannot encode the picture</source>
        <translation>no se puede codificar la imagen</translation>
    </message>
    <message>
        <source>the recording stopped (%1); the walk goes on</source>
        <translation>la grabación se detuvo (%1); el recorrido sigue</translation>
    </message>
    <message>
        <source>the walk broke off: %1</source>
        <translation>el recorrido se interrumpió: %1</translation>
    </message>
    <message>
        <source>frame %1 could not be looked at: %2</source>
        <translation>no se pudo mirar la imagen %1: %2</translation>
    </message>
    <message>
        <source>there is no source of pictures; open one first</source>
        <translation>no hay fuente de imágenes; abra una primero</translation>
    </message>
    <message>
        <source>there is no map; open one first</source>
        <translation>no hay mapa; abra uno primero</translation>
    </message>
</context>
<context>
    <name>farol::Options</name>
    <message>
        <source>%1 needs a number above 0, not “%2”</source>
        <translation>%1 necesita un número mayor que 0, no “%2”</translation>
    </message>
    <message>
        <source>%1 needs a size such as 1280x800, not “%2”</source>
        <translation>%1 necesita un tamaño como 1280x800, no “%2”</translation>
    </message>
    <message>
        <source>“%1” is not known; see --help</source>
        <translation>“%1” no se conoce; vea --help</translation>
    </message>
</context>
<context>
    <name>farol::espeak</name>
    <message>
        <source>The data of the voice are missing: install espeak-ng-data.</source>
        <translation>Faltan los datos de la voz: instale espeak-ng-data.</translation>
    </message>
    <message>
        <source>There is no sound device.</source>
        <translation>No hay dispositivo de sonido.</translation>
    </message>
    <message>
        <source>The sound device cannot play speech: choose another one.</source>
        <translation>El dispositivo de sonido no puede reproducir voz: elija otro.</translation>
    </message>
    <message>
        <source>The sound device does not start.</source>
        <translation>El dispositivo de sonido no arranca.</translation>
    </message>
    <message>
        <source>The sound device stopped in the middle of a text.</source>
        <translation>El dispositivo de sonido se detuvo en medio de un texto.</translation>
    </message>
    <message>
        <source>The voice cannot be loaded: choose another one.</source>
        <translation>La voz no se puede cargar: elija otra.</translation>
    </message>
    <message>
        <source>The text could not be turned into sound.</source>
        <translation>El texto no se pudo convertir en sonido.</translation>
    </message>
</context>
<context>
    <name>farol::ui::AccessDialog</name>
    <message>
        <source>Door or passage %1</source>
        <translation>Puerta o paso %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What sort of passage it is</source>
        <translation>Qué clase de paso es</translation>
    </message>
    <message>
        <source>Type part of a name, room number or level, then choose</source>
        <translation>Escriba parte de un nombre, número de sala o planta y elija</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Un lado</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Otro lado</translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>en ambos sentidos</translation>
    </message>
    <message>
        <source>from the one side to the other only</source>
        <translation>solo del primer lado al segundo</translation>
    </message>
    <message>
        <source>from the other side to the one only</source>
        <translation>solo del segundo lado al primero</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sentido</translation>
    </message>
    <message>
        <source>Which way one can pass</source>
        <translation>En qué sentido se puede pasar</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>How wide the door is</source>
        <translation>Qué ancho tiene la puerta</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Escalones</translation>
    </message>
    <message>
        <source>How many steps the stairs have</source>
        <translation>Cuántos escalones tienen las escaleras</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Este</translation>
    </message>
    <message>
        <source>Place on the map, metres to the east</source>
        <translation>Lugar en el mapa, metros hacia el este</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Norte</translation>
    </message>
    <message>
        <source>Place on the map, metres to the north</source>
        <translation>Lugar en el mapa, metros hacia el norte</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Cerrado</translation>
    </message>
    <message>
        <source>Nobody can pass</source>
        <translation>Nadie puede pasar</translation>
    </message>
</context>
<context>
    <name>farol::ui::Banner</name>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Atención</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problema</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
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
        <translation>%1: encontrado en %2 de %3 vistas</translation>
    </message>
    <message numerus="yes">
        <source>%1 taken for %2: %n time(s)</source>
        <translation>
            <numerusform>%1 tomado por %2: una vez</numerusform>
            <numerusform>%1 tomado por %2: %n veces</numerusform>
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
        <translation>El visitante %1 llegó a %2 en %3. El siguiente viene enseguida.</translation>
    </message>
    <message>
        <source>Visitor %1 did not come to %2 and was fetched. The next one comes in a moment.</source>
        <translation>El visitante %1 no llegó a %2 y fueron a buscarlo. El siguiente viene enseguida.</translation>
    </message>
    <message>
        <source>A simulated building and camera. Visitor %1 wants to go from %2 to %3 (%4 m) and hears only what is said. Choose another destination at any time.</source>
        <translation>Un edificio y una cámara simulados. El visitante %1 quiere ir de %2 a %3 (%4 m) y solo oye lo que se dice. Elija otro destino cuando quiera.</translation>
    </message>
    <message>
        <source>&amp;Demo</source>
        <translation>&amp;Demostración</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Demostración</translation>
    </message>
    <message>
        <source>&amp;Wrong turn</source>
        <translation>&amp;Giro equivocado</translation>
    </message>
    <message>
        <source>Wrong turn</source>
        <translation>Giro equivocado</translation>
    </message>
    <message>
        <source>The walker takes another way than was said</source>
        <translation>Quien camina toma otro camino que el indicado</translation>
    </message>
    <message>
        <source>&amp;Cover the camera</source>
        <translation>&amp;Tapar la cámara</translation>
    </message>
    <message>
        <source>Cover camera</source>
        <translation>Tapar la cámara</translation>
    </message>
    <message>
        <source>A hand lies on the simulated camera</source>
        <translation>Una mano tapa la cámara simulada</translation>
    </message>
    <message>
        <source>&amp;Lights out</source>
        <translation>&amp;Apagar la luz</translation>
    </message>
    <message>
        <source>Lights out</source>
        <translation>Apagar la luz</translation>
    </message>
    <message>
        <source>Nearly dark in the whole building</source>
        <translation>Casi a oscuras en todo el edificio</translation>
    </message>
    <message>
        <source>&amp;Next visitor</source>
        <translation>&amp;Siguiente visitante</translation>
    </message>
    <message>
        <source>Next visitor</source>
        <translation>Siguiente visitante</translation>
    </message>
    <message>
        <source>End this walk; somebody else comes with another destination</source>
        <translation>Terminar este recorrido; viene otra persona con otro destino</translation>
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
        <translation>no aceptado</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Coincidencia</translation>
    </message>
</context>
<context>
    <name>farol::ui::DraftStore</name>
    <message>
        <source>what you are teaching cannot be kept on disk (%1); it would be lost with the program</source>
        <translation>lo que está enseñando no se puede guardar en el disco (%1); se perdería con el programa</translation>
    </message>
    <message>
        <source>the folder for what you are teaching cannot be made; it would be lost with the program</source>
        <translation>no se puede crear la carpeta para lo que está enseñando; se perdería con el programa</translation>
    </message>
</context>
<context>
    <name>farol::ui::EditTemplateDialog</name>
    <message>
        <source>Change “%1”</source>
        <translation>Cambiar “%1”</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>What people call it</source>
        <translation>Cómo lo llama la gente</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Qué es</translation>
    </message>
    <message>
        <source>Real width</source>
        <translation>Ancho real</translation>
    </message>
    <message>
        <source>Lets Farol tell how far away it is</source>
        <translation>Permite a Farol decir a qué distancia está</translation>
    </message>
    <message>
        <source>Real height</source>
        <translation>Alto real</translation>
    </message>
    <message>
        <source>In maps called</source>
        <translation>Nombre en los mapas</translation>
    </message>
    <message>
        <source>Landmarks of the map refer to it by this word: when it changes, change them too</source>
        <translation>Los puntos de referencia del mapa lo citan con esta palabra: si cambia, cámbielos también</translation>
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
        <translation>desconocido</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeatureModel</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Planta</translation>
    </message>
    <message>
        <source>Area (m²)</source>
        <translation>Superficie (m²)</translation>
    </message>
    <message>
        <source>Doors</source>
        <translation>Puertas</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Vecinos</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <source>Restricted</source>
        <translation>Restringido</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identificador</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Un lado</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Otro lado</translation>
    </message>
    <message>
        <source>Width (m)</source>
        <translation>Ancho (m)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Escalones</translation>
    </message>
    <message>
        <source>One way</source>
        <translation>Sentido único</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Cerrado</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Hueco</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
    <message>
        <source>Faces (°)</source>
        <translation>Orientación (°)</translation>
    </message>
    <message>
        <source>Height (m)</source>
        <translation>Altura (m)</translation>
    </message>
    <message>
        <source>Wide (m)</source>
        <translation>Ancho propio (m)</translation>
    </message>
    <message>
        <source>Tall (m)</source>
        <translation>Alto propio (m)</translation>
    </message>
    <message>
        <source>Trained as</source>
        <translation>Entrenado como</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeaturePanel</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>una fila</numerusform>
            <numerusform>%n filas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n row(s)</source>
        <translation>
            <numerusform>%1 de una fila</numerusform>
            <numerusform>%1 de %n filas</numerusform>
        </translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regiones</translation>
    </message>
    <message>
        <source>Doors and passages</source>
        <translation>Puertas y pasos</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <source>What the table lists</source>
        <translation>Qué muestra la tabla</translation>
    </message>
    <message>
        <source>Search the table</source>
        <translation>Buscar en la tabla</translation>
    </message>
    <message>
        <source>Rows that hold every word typed (Ctrl+F)</source>
        <translation>Filas que contienen todas las palabras escritas (Ctrl+F)</translation>
    </message>
    <message>
        <source>This level onl&amp;y</source>
        <translation>Solo esta &amp;planta</translation>
    </message>
    <message>
        <source>This level only</source>
        <translation>Solo esta planta</translation>
    </message>
    <message>
        <source>List only what is on the level that the plan shows</source>
        <translation>Mostrar solo lo que está en la planta del plano</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Atributos</translation>
    </message>
    <message>
        <source>Choose a row to see it on the plan; press Enter to change it</source>
        <translation>Elija una fila para verla en el plano; pulse Intro para cambiarla</translation>
    </message>
    <message>
        <source>No row has what is looked for.</source>
        <translation>Ninguna fila tiene lo que se busca.</translation>
    </message>
    <message>
        <source>The map has none of these.</source>
        <translation>El mapa no tiene ninguno de estos.</translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>No hay ningún mapa abierto.</translation>
    </message>
</context>
<context>
    <name>farol::ui::Figures</name>
    <message>
        <source>Votes over time</source>
        <translation>Votos a lo largo del tiempo</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>segundos</translation>
    </message>
    <message>
        <source>votes</source>
        <translation>votos</translation>
    </message>
    <message>
        <source>Start a walk first.</source>
        <translation>Inicie primero un recorrido.</translation>
    </message>
    <message>
        <source>How long pictures took to understand</source>
        <translation>Cuánto se tardó en comprender las imágenes</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>milisegundos</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>imágenes</translation>
    </message>
    <message>
        <source>How sure, and how right</source>
        <translation>Qué seguro y qué acertado</translation>
    </message>
    <message>
        <source>told confidence</source>
        <translation>confianza declarada</translation>
    </message>
    <message>
        <source>share that was right</source>
        <translation>parte acertada</translation>
    </message>
    <message>
        <source>The truth is known in simulated walks only: start the demonstration.</source>
        <translation>La verdad solo se conoce en recorridos simulados: inicie la demostración.</translation>
    </message>
    <message>
        <source>this walk</source>
        <translation>este recorrido</translation>
    </message>
    <message>
        <source>From how far each landmark is found</source>
        <translation>Desde qué distancia se encuentra cada punto de referencia</translation>
    </message>
    <message>
        <source>landmarks</source>
        <translation>puntos de referencia</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>Check the library on the Landmarks page first (F7); landmarks need a real size.</source>
        <translation>Compruebe primero la biblioteca en la página Puntos de referencia (F7); los puntos de referencia necesitan un tamaño real.</translation>
    </message>
</context>
<context>
    <name>farol::ui::FiguresDialog</name>
    <message>
        <source>Figures</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Which chart is shown</source>
        <translation>Qué gráfico se muestra</translation>
    </message>
    <message>
        <source>&amp;Save as PNG or SVG…</source>
        <translation>&amp;Guardar como PNG o SVG…</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Guardar el gráfico</translation>
    </message>
    <message>
        <source>Save the chart as a picture, or as a drawing that stays sharp</source>
        <translation>Guardar el gráfico como imagen, o como dibujo que sigue nítido</translation>
    </message>
    <message>
        <source>Charts (%1)</source>
        <translation>Gráficos (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>No se puede escribir %1. Elija otra carpeta.</translation>
    </message>
</context>
<context>
    <name>farol::ui::FindingModel</name>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y una más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Rule: %1</source>
        <translation>Regla: %1</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Qué se encontró</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Cuántos</translation>
    </message>
</context>
<context>
    <name>farol::ui::FloorModel</name>
    <message>
        <source>you are here</source>
        <translation>usted está aquí</translation>
    </message>
    <message>
        <source>destination</source>
        <translation>destino</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>cerrado</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
</context>
<context>
    <name>farol::ui::FloorPictures</name>
    <message>
        <source>The image lies where its file says.</source>
        <translation>La imagen está donde indica su archivo.</translation>
    </message>
    <message>
        <source>Now click where this point belongs on the map. Escape gives up.</source>
        <translation>Pulse ahora donde este punto está en el mapa. Escape lo cancela.</translation>
    </message>
    <message>
        <source>Click a point of the image that you know on the map, a corner of the house, say. Escape leaves the image where it is.</source>
        <translation>Pulse un punto de la imagen que conozca en el mapa, una esquina de la casa, por ejemplo. Escape deja la imagen donde está.</translation>
    </message>
    <message>
        <source>Click a second point of the image, far from the first.</source>
        <translation>Pulse un segundo punto de la imagen, lejos del primero.</translation>
    </message>
    <message>
        <source>Placed. A third point straightens a skewed image; Escape ends.</source>
        <translation>Colocada. Un tercer punto endereza una imagen torcida; Escape termina.</translation>
    </message>
    <message>
        <source>That is beside the image. Click a point of the image.</source>
        <translation>Eso está fuera de la imagen. Pulse un punto de la imagen.</translation>
    </message>
    <message>
        <source>These points lie too near each other, or on one line. Click another one.</source>
        <translation>Estos puntos están demasiado cerca unos de otros, o en una misma línea. Pulse otro.</translation>
    </message>
    <message>
        <source>The image is placed by three points.</source>
        <translation>La imagen está colocada con tres puntos.</translation>
    </message>
    <message>
        <source>How strong the floor-plan image is</source>
        <translation>Con qué fuerza se ve la imagen del plano</translation>
    </message>
    <message>
        <source>Place by p&amp;oints</source>
        <translation>Colocar p&amp;or puntos</translation>
    </message>
    <message>
        <source>Place the image by points</source>
        <translation>Colocar la imagen por puntos</translation>
    </message>
    <message>
        <source>Click two or three points of the image and where they belong on the map</source>
        <translation>Pulsar dos o tres puntos de la imagen y donde están en el mapa</translation>
    </message>
    <message>
        <source>Take a&amp;way</source>
        <translation>Qui&amp;tar</translation>
    </message>
    <message>
        <source>Take the image away</source>
        <translation>Quitar la imagen</translation>
    </message>
    <message>
        <source>The floor shows no image any more; its file stays</source>
        <translation>La planta ya no muestra la imagen; su archivo se conserva</translation>
    </message>
    <message>
        <source>Ima&amp;ge:</source>
        <translation>Ima&amp;gen:</translation>
    </message>
</context>
<context>
    <name>farol::ui::FramePanel</name>
    <message>
        <source>What the camera sees</source>
        <translation>Qué ve la cámara</translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation>Imagen de la cámara</translation>
    </message>
    <message>
        <source>The camera&apos;s picture, with what Farol recognised in it</source>
        <translation>La imagen de la cámara, con lo que Farol ha reconocido en ella</translation>
    </message>
    <message>
        <source>Picture %1 at %2</source>
        <translation>Imagen %1 a las %2</translation>
    </message>
    <message>
        <source>Picture %1 at %2 (%3)</source>
        <translation>Imagen %1 a las %2 (%3)</translation>
    </message>
    <message>
        <source>understood in %1 ms</source>
        <translation>comprendida en %1 ms</translation>
    </message>
    <message numerus="yes">
        <source>%n left out because late</source>
        <translation>
            <numerusform>una omitida por tarde</numerusform>
            <numerusform>%n omitidas por tarde</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unreadable</source>
        <translation>
            <numerusform>una ilegible</numerusform>
            <numerusform>%n ilegibles</numerusform>
        </translation>
    </message>
    <message>
        <source>Time from the picture&apos;s arrival to the answer, and how many pictures had to be left out because Farol was still busy with an earlier one</source>
        <translation>Tiempo desde la llegada de la imagen hasta la respuesta, y cuántas imágenes hubo que omitir porque Farol aún estaba ocupado con otra</translation>
    </message>
</context>
<context>
    <name>farol::ui::FrameView</name>
    <message>
        <source>No picture yet</source>
        <translation>Aún no hay imagen</translation>
    </message>
    <message>
        <source>Nothing known is in the picture</source>
        <translation>No hay nada conocido en la imagen</translation>
    </message>
    <message>
        <source>In the picture: %1</source>
        <translation>En la imagen: %1</translation>
    </message>
    <message>
        <source>Spoken: %1</source>
        <translation>Dicho: %1</translation>
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
        <translation>Aún no hay imagen.
Abra una cámara, un vídeo o una carpeta de imágenes y pulse Reproducir.</translation>
    </message>
</context>
<context>
    <name>farol::ui::HelpDialog</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Capítulos</translation>
    </message>
    <message>
        <source>What the help is about</source>
        <translation>De qué trata la ayuda</translation>
    </message>
    <message>
        <source>Walk page</source>
        <translation>Página Recorrido</translation>
    </message>
    <message>
        <source>Map page</source>
        <translation>Página Mapa</translation>
    </message>
    <message>
        <source>Landmarks page</source>
        <translation>Página Puntos de referencia</translation>
    </message>
    <message>
        <source>Kiosk</source>
        <translation>Quiosco</translation>
    </message>
    <message>
        <source>Text of the chapter</source>
        <translation>Texto del capítulo</translation>
    </message>
    <message>
        <source>Here a map of a building is opened or brought in, looked at, checked and changed. The plan and the table show the same: what is chosen in one is chosen in the other.</source>
        <translation>Aquí se abre o se importa el mapa de un edificio, se mira, se comprueba y se cambia. El plano y la tabla muestran lo mismo: lo elegido en uno está elegido en la otra.</translation>
    </message>
    <message>
        <source>F7 looks for what is wrong with the map and says what to do about each finding.</source>
        <translation>F7 busca qué está mal en el mapa y dice qué hacer con cada hallazgo.</translation>
    </message>
    <message>
        <source>Ctrl+U marks places that the landmarks cannot tell apart. A landmark there helps most.</source>
        <translation>Ctrl+U marca los lugares que los puntos de referencia no distinguen. Allí es donde más ayuda uno.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L puts a landmark on the plan, Ctrl+Shift+D a door. Drag what is chosen, or move it with Alt and the arrows.</source>
        <translation>Ctrl+Mayús+L pone un punto de referencia en el plano, Ctrl+Mayús+D una puerta. Arrastre lo elegido, o muévalo con Alt y las flechas.</translation>
    </message>
    <message>
        <source>Ctrl+Z takes every step back. Nothing is written until you save with Ctrl+S.</source>
        <translation>Ctrl+Z retira cada paso. No se escribe nada hasta que guarde con Ctrl+S.</translation>
    </message>
    <message>
        <source>Here Farol is taught what it shall know again. Every change is saved by itself and can be taken back with Ctrl+Z; a landmark that is not finished is kept, also when the computer stops.</source>
        <translation>Aquí se enseña a Farol lo que debe reconocer. Cada cambio se guarda solo y se puede retirar con Ctrl+Z; un punto de referencia sin terminar se conserva, también si el ordenador se apaga.</translation>
    </message>
    <message>
        <source>Ctrl+T teaches a landmark in four steps: what it is, its views, a trial, its place on the map.</source>
        <translation>Ctrl+T enseña un punto de referencia en cuatro pasos: qué es, sus vistas, una prueba, su lugar en el mapa.</translation>
    </message>
    <message>
        <source>Take a view from the front, from the left, from the right and from farther away. The coach says what is wrong with a picture and which one comes next. Drag the four corners onto the landmark; by keys, 1 to 4 choose a corner and the arrows move it.</source>
        <translation>Tome una vista de frente, desde la izquierda, desde la derecha y desde más lejos. El consejo dice qué falla en una imagen y cuál viene después. Arrastre las cuatro esquinas al punto de referencia; con teclas, 1 a 4 eligen una esquina y las flechas la mueven.</translation>
    </message>
    <message>
        <source>F7 checks the whole library: how well each landmark is found, how far away, how far aside, and which are taken for each other. Merge what is the same, and add views to what is lost.</source>
        <translation>F7 comprueba toda la biblioteca: qué tal se encuentra cada punto de referencia, a qué distancia, de lado, y cuáles se confunden. Una lo que es igual y añada vistas a lo que se pierde.</translation>
    </message>
    <message>
        <source>Here somebody is guided, and you watch: what the camera sees, the place on the map, what is said, and why.</source>
        <translation>Aquí se guía a alguien y usted observa: qué ve la cámara, el lugar en el mapa, qué se dice y por qué.</translation>
    </message>
    <message>
        <source>Ctrl+O opens the map of the building.</source>
        <translation>Ctrl+O abre el mapa del edificio.</translation>
    </message>
    <message>
        <source>Ctrl+L opens the landmarks that belong to it.</source>
        <translation>Ctrl+L abre los puntos de referencia que le corresponden.</translation>
    </message>
    <message>
        <source>Ctrl+P chooses a camera, a video or a folder of pictures, and Ctrl+G where to go.</source>
        <translation>Ctrl+P elige una cámara, un vídeo o una carpeta de imágenes, y Ctrl+G adónde ir.</translation>
    </message>
    <message>
        <source>F5 starts and holds the walk, F8 goes on by one picture.</source>
        <translation>F5 inicia y detiene el recorrido, F8 avanza una imagen.</translation>
    </message>
    <message>
        <source>When the place shown is not right, choose the right one on the map and press Ctrl+H.</source>
        <translation>Si el lugar mostrado no es correcto, elija el correcto en el mapa y pulse Ctrl+H.</translation>
    </message>
    <message>
        <source>Ctrl+W gives the place up, so that it is looked for anew.</source>
        <translation>Ctrl+W renuncia al lugar, para que se busque de nuevo.</translation>
    </message>
    <message>
        <source>Ctrl+E speaks a sentence that you type.</source>
        <translation>Ctrl+E dice una frase que usted escribe.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R records the next walk. A recorded walk can be worked out anew in another way and compared, from the Walk menu.</source>
        <translation>Ctrl+Mayús+R graba el próximo recorrido. Un recorrido grabado se puede calcular de nuevo de otro modo y comparar, desde el menú Recorrido.</translation>
    </message>
    <message>
        <source>The timeline at the bottom looks back: drag it, or use the arrow keys. “Why there” explains the vote of the place that is chosen in the list.</source>
        <translation>La línea de tiempo de abajo mira atrás: arrástrela o use las flechas. “Por qué allí” explica el voto del lugar elegido en la lista.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+U marks from where no landmark is seen, and Ctrl+Shift+N lists the routes that are missing. Ctrl+Shift+I lays the image of a floor plan under the floor: click two points of it and where they belong.</source>
        <translation>Ctrl+Mayús+U marca desde dónde no se ve ningún punto de referencia, y Ctrl+Mayús+N enumera las rutas que faltan. Ctrl+Mayús+I pone la imagen de un plano bajo la planta: pulse dos puntos de ella y donde están.</translation>
    </message>
    <message>
        <source>The kiosk is for a blind user who is alone: “farol --kiosk” fills the screen and says everything. Arrows and Enter choose a destination, F searches by name, digits by number; F1 says all keys, Escape goes back.</source>
        <translation>El quiosco es para un usuario ciego que está solo: «farol --kiosk» llena la pantalla y lo dice todo. Las flechas e Intro eligen el destino, F busca por el nombre, las cifras por el número; F1 dice todas las teclas, Escape vuelve atrás.</translation>
    </message>
</context>
<context>
    <name>farol::ui::HistoryModel</name>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
</context>
<context>
    <name>farol::ui::ImportDialog</name>
    <message>
        <source>Import a map</source>
        <translation>Importar un mapa</translation>
    </message>
    <message>
        <source>A file, a folder or a zip: IMDF, OpenStreetMap indoor, IndoorGML, per-floor Shapefiles, GeoJSON, GeoPackage, HULOP, WRLD. What is found wrong is told afterwards; nothing is written until you save.</source>
        <translation>Un archivo, una carpeta o un zip: IMDF, OpenStreetMap de interiores, IndoorGML, Shapefiles por planta, GeoJSON, GeoPackage, HULOP, WRLD. Después se dice qué se encontró mal; no se escribe nada hasta que guarde.</translation>
    </message>
    <message>
        <source>&amp;File…</source>
        <translation>&amp;Archivo…</translation>
    </message>
    <message>
        <source>Fol&amp;der…</source>
        <translation>&amp;Carpeta…</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Elegir un archivo</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Elegir una carpeta</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>por su contenido</translation>
    </message>
    <message>
        <source>as the format has it</source>
        <translation>como lo tiene el formato</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Path of the file, folder or zip</source>
        <translation>Ruta del archivo, carpeta o zip</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Of which kind the map is</source>
        <translation>De qué tipo es el mapa</translation>
    </message>
    <message>
        <source>Language of names</source>
        <translation>Idioma de los nombres</translation>
    </message>
    <message>
        <source>Which of several names is taken, such as en or pt</source>
        <translation>Cuál de varios nombres se toma, por ejemplo en o es</translation>
    </message>
    <message>
        <source>Where the map leaves it open: filename, z, or the name of a column</source>
        <translation>Donde el mapa no lo dice: filename, z o el nombre de una columna</translation>
    </message>
    <message>
        <source>A file with other names of columns and codes</source>
        <translation>Un archivo con otros nombres de columnas y códigos</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importar</translation>
    </message>
    <message>
        <source>none is needed</source>
        <translation>no hace falta</translation>
    </message>
    <message>
        <source>Where the level is</source>
        <translation>Dónde está la planta</translation>
    </message>
    <message>
        <source>File of other names</source>
        <translation>Archivo de otros nombres</translation>
    </message>
</context>
<context>
    <name>farol::ui::InstructionPanel</name>
    <message>
        <source>No destination chosen: places are told, no route.</source>
        <translation>No hay destino elegido: se dicen los lugares, sin ruta.</translation>
    </message>
    <message>
        <source>The route follows as soon as it is known where you are.</source>
        <translation>La ruta llega en cuanto se sepa dónde está.</translation>
    </message>
    <message>
        <source>There is no way to the destination. %1</source>
        <translation>No hay camino hasta el destino. %1</translation>
    </message>
    <message>
        <source>At the destination.</source>
        <translation>En el destino.</translation>
    </message>
    <message>
        <source>On the way to %1</source>
        <translation>De camino a %1</translation>
    </message>
    <message numerus="yes">
        <source>%n more place(s) to pass</source>
        <translation>
            <numerusform>un lugar más por pasar</numerusform>
            <numerusform>%n lugares más por pasar</numerusform>
        </translation>
    </message>
    <message>
        <source>next in %1 m</source>
        <translation>siguiente en %1 m</translation>
    </message>
    <message>
        <source>%1 m to go</source>
        <translation>faltan %1 m</translation>
    </message>
    <message>
        <source>Off the route</source>
        <translation>Fuera de la ruta</translation>
    </message>
    <message>
        <source>Next instruction</source>
        <translation>Próxima instrucción</translation>
    </message>
    <message>
        <source>Said at %1</source>
        <translation>Dicho a las %1</translation>
    </message>
    <message>
        <source>Open a map to begin.</source>
        <translation>Abra un mapa para empezar.</translation>
    </message>
    <message>
        <source>Ready. Press Play to start the walk.</source>
        <translation>Listo. Pulse Reproducir para iniciar el recorrido.</translation>
    </message>
    <message>
        <source>Looking around…</source>
        <translation>Mirando alrededor…</translation>
    </message>
    <message>
        <source>Next instruction: %1</source>
        <translation>Próxima instrucción: %1</translation>
    </message>
    <message>
        <source>No sound: %1</source>
        <translation>Sin sonido: %1</translation>
    </message>
</context>
<context>
    <name>farol::ui::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>In the map: move it</source>
        <translation>En el mapa: moverlo</translation>
    </message>
    <message>
        <source>In the map: larger, smaller, whole floor</source>
        <translation>En el mapa: más grande, más pequeño, toda la planta</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Re Pág, Av Pág</translation>
    </message>
    <message>
        <source>In the map: the floor above, the floor below</source>
        <translation>En el mapa: la planta de arriba, la de abajo</translation>
    </message>
    <message>
        <source>Alt + Arrows</source>
        <translation>Alt + flechas</translation>
    </message>
    <message>
        <source>In the plan: move what is chosen by 10 cm, with Shift by 1 m</source>
        <translation>En el plano: mover lo elegido 10 cm; con Mayús, 1 m</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabulador</translation>
    </message>
    <message>
        <source>The next button or list</source>
        <translation>El siguiente botón o lista</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Tecla</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Qué hace</translation>
    </message>
</context>
<context>
    <name>farol::ui::Kiosk</name>
    <message>
        <source>No map was given (farol --kiosk --map FILE).</source>
        <translation>No se ha indicado ningún mapa (farol --kiosk --map ARCHIVO).</translation>
    </message>
    <message>
        <source>The landmarks cannot be loaded: I will hardly know where you are. Ask for help.</source>
        <translation>No puedo cargar los puntos de referencia: apenas sabré dónde está. Pida ayuda.</translation>
    </message>
    <message>
        <source>The destination cannot be kept for a restart: the folder cannot be written.</source>
        <translation>El destino no se puede guardar para un reinicio: no se puede escribir en la carpeta.</translation>
    </message>
    <message>
        <source>The chosen voice does not work. This is another one.</source>
        <translation>La voz elegida no funciona. Esta es otra.</translation>
    </message>
    <message>
        <source>The map has been changed. The new one is used after this way.</source>
        <translation>El mapa ha cambiado. El nuevo se usa después de este camino.</translation>
    </message>
    <message>
        <source>The file of the map is gone. I keep the map that I have.</source>
        <translation>El archivo del mapa ha desaparecido. Conservo el mapa que tengo.</translation>
    </message>
    <message>
        <source>The new map cannot be opened. I keep the old one.</source>
        <translation>El mapa nuevo no se puede abrir. Me quedo con el anterior.</translation>
    </message>
    <message>
        <source>Another Farol kiosk of this user is running.</source>
        <translation>Ya está en marcha otro Farol de este usuario.</translation>
    </message>
    <message>
        <source>Farol is already running here. I close this one. Goodbye.</source>
        <translation>Farol ya está en marcha aquí. Cierro este. Hasta luego.</translation>
    </message>
    <message>
        <source>The map has been changed, and I use the new one.</source>
        <translation>El mapa ha cambiado, y uso el nuevo.</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskMachine</name>
    <message>
        <source>One moment.</source>
        <translation>Un momento.</translation>
    </message>
    <message>
        <source>Farol. I am opening the map.</source>
        <translation>Farol. Estoy abriendo el mapa.</translation>
    </message>
    <message>
        <source>The new map cannot be opened. I keep the old one.</source>
        <translation>El mapa nuevo no se puede abrir. Me quedo con el anterior.</translation>
    </message>
    <message>
        <source>Farol was interrupted and has started again.</source>
        <translation>Farol se interrumpió y ha empezado de nuevo.</translation>
    </message>
    <message>
        <source>You were last here: %1.</source>
        <translation>Su última posición fue: %1.</translation>
    </message>
    <message>
        <source>The camera works again.</source>
        <translation>La cámara vuelve a funcionar.</translation>
    </message>
    <message>
        <source>Stop, and turn slowly to the right, so that I can look around.</source>
        <translation>Deténgase y gírese despacio hacia la derecha, para que pueda mirar alrededor.</translation>
    </message>
    <message>
        <source>No destination is chosen yet. Choose one first.</source>
        <translation>Aún no hay ningún destino elegido. Elija uno primero.</translation>
    </message>
    <message>
        <source>This is the first place.</source>
        <translation>Este es el primer lugar.</translation>
    </message>
    <message>
        <source>This is the last place.</source>
        <translation>Este es el último lugar.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s). %2.</source>
        <extracomment>%1 &quot;Rooms&quot;, %2 the first of them</extracomment>
        <translation>
            <numerusform>%1: un lugar. %2.</numerusform>
            <numerusform>%1: %n lugares. %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Type part of a name or a number, then press Enter.</source>
        <translation>Escriba parte de un nombre o un número y pulse Intro.</translation>
    </message>
    <message>
        <source>space</source>
        <translation>espacio</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s).</source>
        <comment>while typing</comment>
        <extracomment>%1 the letter just typed</extracomment>
        <translation>
            <numerusform>%1: un lugar.</numerusform>
            <numerusform>%1: %n lugares.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is typed.</source>
        <translation>No hay nada escrito.</translation>
    </message>
    <message>
        <source>Deleted: %1. %2</source>
        <translation>Borrado: %1. %2</translation>
    </message>
    <message>
        <source>%1 %2. Enter: go there. Arrow down: next.</source>
        <translation>%1 %2. Intro: ir allí. Flecha abajo: siguiente.</translation>
    </message>
    <message>
        <source>Nothing is chosen yet. Press arrow down to hear the places.</source>
        <translation>Aún no hay nada elegido. Pulse flecha abajo para oír los lugares.</translation>
    </message>
    <message>
        <source>I try the camera again.</source>
        <translation>Pruebo la cámara otra vez.</translation>
    </message>
    <message>
        <source>Going on. %1</source>
        <translation>Continúo. %1</translation>
    </message>
    <message>
        <source>This key does nothing. Escape: back.</source>
        <translation>Esta tecla no hace nada. Escape: volver.</translation>
    </message>
    <message>
        <source>Back to the kinds of places.</source>
        <translation>Volver a los tipos de lugares.</translation>
    </message>
    <message>
        <source>Leave Farol.</source>
        <translation>Salir de Farol.</translation>
    </message>
    <message>
        <source>Start.</source>
        <translation>Empezar.</translation>
    </message>
    <message>
        <source>Hear the whole way.</source>
        <translation>Oír todo el camino.</translation>
    </message>
    <message>
        <source>Another place.</source>
        <translation>Otro lugar.</translation>
    </message>
    <message>
        <source>Try the camera again.</source>
        <translation>Probar la cámara otra vez.</translation>
    </message>
    <message>
        <source>Stop the guidance.</source>
        <translation>Detener la guía.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Elegir otro lugar.</translation>
    </message>
    <message>
        <source>Yes, stop.</source>
        <translation>Sí, detener.</translation>
    </message>
    <message>
        <source>No, go on.</source>
        <translation>No, continuar.</translation>
    </message>
    <message>
        <source>Yes, leave.</source>
        <translation>Sí, salir.</translation>
    </message>
    <message>
        <source>No, stay.</source>
        <translation>No, quedarse.</translation>
    </message>
    <message>
        <source>Press space to hear what there is, then Enter.</source>
        <translation>Pulse espacio para oír lo que hay y después Intro.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s). Space: first place.</source>
        <translation>
            <numerusform>%1: un lugar. Espacio: primer lugar.</numerusform>
            <numerusform>%1: %n lugares. Espacio: primer lugar.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. %2 of %3.</source>
        <extracomment>%1 a place, then which of how many</extracomment>
        <translation>%1. %2 de %3.</translation>
    </message>
    <message numerus="yes">
        <source>Choose a destination: %n place(s).</source>
        <translation>
            <numerusform>Elija un destino: un lugar.</numerusform>
            <numerusform>Elija un destino: %n lugares.</numerusform>
        </translation>
    </message>
    <message>
        <source>Space: next. Enter: take it.</source>
        <translation>Espacio: siguiente. Intro: elegir.</translation>
    </message>
    <message>
        <source>Arrow down: first place. F: type a name. F1: all keys.</source>
        <translation>Flecha abajo: primer lugar. F: escribir un nombre. F1: todas las teclas.</translation>
    </message>
    <message>
        <source>To: %1.</source>
        <translation>Destino: %1.</translation>
    </message>
    <message>
        <source>I do not know yet where you are, and look for it on the way.</source>
        <translation>Aún no sé dónde está; lo averiguaré por el camino.</translation>
    </message>
    <message>
        <source>Space: choices.</source>
        <translation>Espacio: opciones.</translation>
    </message>
    <message>
        <source>Enter: start. L: the whole way. Escape: another place.</source>
        <translation>Intro: empezar. L: todo el camino. Escape: otro lugar.</translation>
    </message>
    <message>
        <source>Stop the guidance?</source>
        <translation>¿Detener la guía?</translation>
    </message>
    <message>
        <source>Leave Farol?</source>
        <translation>¿Salir de Farol?</translation>
    </message>
    <message>
        <source>Enter or Escape: yes. Any other key: no.</source>
        <translation>Intro o Escape: sí. Cualquier otra tecla: no.</translation>
    </message>
    <message>
        <source>No camera is set up, and I cannot guide you. Ask for help.</source>
        <translation>No hay ninguna cámara configurada y no puedo guiarle. Pida ayuda.</translation>
    </message>
    <message>
        <source>The camera is starting.</source>
        <translation>La cámara se está iniciando.</translation>
    </message>
    <message>
        <source>Stop. The camera gives no pictures, and I cannot guide you. Enter: try again.</source>
        <translation>Deténgase. La cámara no da imágenes y no puedo guiarle. Intro: probar otra vez.</translation>
    </message>
    <message>
        <source>The camera gives no pictures. I try it again when you start.</source>
        <translation>La cámara no da imágenes. La probaré otra vez cuando empiece.</translation>
    </message>
    <message>
        <source>No place fits: %1. Delete letters, or press Escape.</source>
        <translation>Ningún lugar coincide: %1. Borre letras o pulse Escape.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) fit: %1.</source>
        <translation>
            <numerusform>Coincide un lugar: %1.</numerusform>
            <numerusform>Coinciden %n lugares: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>This map has no places to go to. Ask for help.</source>
        <translation>Este mapa no tiene lugares a los que ir. Pida ayuda.</translation>
    </message>
    <message>
        <source>The map cannot be opened. Ask for help.</source>
        <translation>El mapa no se puede abrir. Pida ayuda.</translation>
    </message>
    <message>
        <source>The map is being opened. Please wait.</source>
        <translation>El mapa se está abriendo. Espere, por favor.</translation>
    </message>
    <message>
        <source>On the way to: %1.</source>
        <translation>De camino a: %1.</translation>
    </message>
    <message>
        <source>You have arrived: %1. Enter: another destination.</source>
        <translation>Ha llegado: %1. Intro: otro destino.</translation>
    </message>
    <message>
        <source>You have probably arrived: %1. Enter: another destination.</source>
        <translation>Probablemente ha llegado a su destino: %1. Intro: otro destino.</translation>
    </message>
    <message>
        <source>Goodbye.</source>
        <translation>Adiós.</translation>
    </message>
    <message>
        <source>Quiet: I tell only warnings and what you ask. M: speak again.</source>
        <translation>Silencio: solo digo avisos y lo que pregunte. M: volver a hablar.</translation>
    </message>
    <message>
        <source>I tell everything again.</source>
        <translation>Vuelvo a decirlo todo.</translation>
    </message>
    <message>
        <source>Speed %1 of %2.</source>
        <translation>Velocidad %1 de %2.</translation>
    </message>
    <message>
        <source>I speak English now.</source>
        <translation>Ahora hablo español.</translation>
    </message>
    <message>
        <source>Two keys: space goes through the choices, Enter takes one. F4: all keys again.</source>
        <translation>Dos teclas: espacio recorre las opciones, Intro elige una. F4: otra vez todas las teclas.</translation>
    </message>
    <message>
        <source>All keys are in use again.</source>
        <translation>Todas las teclas vuelven a funcionar.</translation>
    </message>
    <message>
        <source>Farol</source>
        <translation>Farol</translation>
    </message>
    <message>
        <source>Where to? %1</source>
        <translation>¿Adónde? %1</translation>
    </message>
    <message>
        <source>Search: %1</source>
        <translation>Búsqueda: %1</translation>
    </message>
    <message>
        <source>The way to %1</source>
        <translation>Camino a: %1</translation>
    </message>
    <message>
        <source>Walking to %1</source>
        <translation>De camino a: %1</translation>
    </message>
    <message>
        <source>Arrived</source>
        <translation>Ha llegado</translation>
    </message>
    <message>
        <source>Probably arrived</source>
        <translation>Probablemente ha llegado</translation>
    </message>
    <message>
        <source>Stop?</source>
        <translation>¿Detener?</translation>
    </message>
    <message>
        <source>Leave?</source>
        <translation>¿Salir?</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Goodbye</source>
        <translation>Adiós</translation>
    </message>
    <message>
        <source>Space: next   Enter: take   F4: all keys</source>
        <translation>Espacio: siguiente   Intro: elegir   F4: teclas</translation>
    </message>
    <message>
        <source>Arrows: places   Enter: go   F: search   F1: keys</source>
        <translation>Flechas: lugares   Intro: ir   F: buscar   F1: teclas</translation>
    </message>
    <message>
        <source>Enter: done   Esc: back</source>
        <translation>Intro: hecho   Esc: volver</translation>
    </message>
    <message>
        <source>Enter: start   L: whole way   Esc: back</source>
        <translation>Intro: empezar   L: todo el camino   Esc: volver</translation>
    </message>
    <message>
        <source>Space: again   W: where am I   Esc: stop</source>
        <translation>Espacio: repetir   W: dónde estoy   Esc: detener</translation>
    </message>
    <message>
        <source>Enter: another destination</source>
        <translation>Intro: otro destino</translation>
    </message>
    <message>
        <source>Enter: yes   any other key: no</source>
        <translation>Intro: sí   otra tecla: no</translation>
    </message>
    <message>
        <source>Esc: back   F1: number pad</source>
        <translation>Esc: volver   F1: teclado numérico</translation>
    </message>
    <message>
        <source>Esc: leave   F1: keys</source>
        <translation>Esc: salir   F1: teclas</translation>
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
        <translation>Farol, guía</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskPlaces</name>
    <message>
        <source>All places</source>
        <translation>Todos los lugares</translation>
    </message>
    <message>
        <source>Rooms</source>
        <translation>Salas</translation>
    </message>
    <message>
        <source>Toilets</source>
        <translation>Aseos</translation>
    </message>
    <message>
        <source>Halls</source>
        <translation>Vestíbulos</translation>
    </message>
    <message>
        <source>Corridors</source>
        <translation>Pasillos</translation>
    </message>
    <message>
        <source>Lifts</source>
        <translation>Ascensores</translation>
    </message>
    <message>
        <source>Stairs</source>
        <translation>Escaleras</translation>
    </message>
    <message>
        <source>Ways out</source>
        <translation>Salidas</translation>
    </message>
    <message>
        <source>Other places</source>
        <translation>Otros lugares</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskWords</name>
    <message>
        <source>Arrow up</source>
        <translation>Flecha arriba</translation>
    </message>
    <message>
        <source>Arrow down</source>
        <translation>Flecha abajo</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Arrow left</source>
        <translation>Flecha izquierda</translation>
    </message>
    <message>
        <source>Arrow right</source>
        <translation>Flecha derecha</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Tecla Escape</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>Menos</translation>
    </message>
    <message>
        <source>the place before</source>
        <translation>el lugar anterior</translation>
    </message>
    <message>
        <source>the next place</source>
        <translation>el lugar siguiente</translation>
    </message>
    <message>
        <source>the first place</source>
        <translation>el primer lugar</translation>
    </message>
    <message>
        <source>the last place</source>
        <translation>el último lugar</translation>
    </message>
    <message>
        <source>another kind of places, back</source>
        <translation>otro tipo de lugares, hacia atrás</translation>
    </message>
    <message>
        <source>another kind of places, on</source>
        <translation>otro tipo de lugares, hacia delante</translation>
    </message>
    <message>
        <source>choose, start</source>
        <translation>elegir, empezar</translation>
    </message>
    <message>
        <source>back; hold it down to leave</source>
        <translation>volver; manténgala pulsada para salir</translation>
    </message>
    <message>
        <source>say again</source>
        <translation>repetir</translation>
    </message>
    <message>
        <source>where am I</source>
        <translation>dónde estoy</translation>
    </message>
    <message>
        <source>what is around me</source>
        <translation>qué hay a mi alrededor</translation>
    </message>
    <message>
        <source>what comes next</source>
        <translation>qué viene después</translation>
    </message>
    <message>
        <source>the whole way</source>
        <translation>todo el camino</translation>
    </message>
    <message>
        <source>look around</source>
        <translation>mirar alrededor</translation>
    </message>
    <message>
        <source>quiet, or speak again</source>
        <translation>silencio, o volver a hablar</translation>
    </message>
    <message>
        <source>speak faster</source>
        <translation>hablar más deprisa</translation>
    </message>
    <message>
        <source>speak slower</source>
        <translation>hablar más despacio</translation>
    </message>
    <message>
        <source>how much I tell</source>
        <translation>cuánto digo</translation>
    </message>
    <message>
        <source>how I tell directions</source>
        <translation>cómo digo las direcciones</translation>
    </message>
    <message>
        <source>metres, feet or steps</source>
        <translation>metros, pies o pasos</translation>
    </message>
    <message>
        <source>search a place by typing</source>
        <translation>buscar un lugar escribiendo</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>las teclas</translation>
    </message>
    <message>
        <source>everything with two keys</source>
        <translation>todo con dos teclas</translation>
    </message>
    <message>
        <source>Keys. Press one to hear what it does; F1: number pad; Escape: back.</source>
        <translation>Teclas. Pulse una para oír lo que hace; F1: teclado numérico; Escape: volver.</translation>
    </message>
    <message>
        <source>Number pad. 8 and 2: up and down. 4 and 6: left and right. 5 or Enter: choose. 0: say again. 1: where am I. 3: around me. 7: what comes next. 9: the whole way. Plus and minus: speed. Star: keys. Slash: quiet. Point: back.</source>
        <translation>Teclado numérico. 8 y 2: arriba y abajo. 4 y 6: izquierda y derecha. 5 o Intro: elegir. 0: repetir. 1: dónde estoy. 3: qué hay alrededor. 7: qué viene después. 9: todo el camino. Más y menos: velocidad. Asterisco: teclas. Barra: silencio. Punto: volver.</translation>
    </message>
    <message>
        <source>This key does nothing here. F1: all keys.</source>
        <translation>Esta tecla no hace nada aquí. F1: todas las teclas.</translation>
    </message>
    <message>
        <source>I tell directions only.</source>
        <translation>Solo digo las direcciones.</translation>
    </message>
    <message>
        <source>I tell directions and objects.</source>
        <translation>Digo direcciones y objetos.</translation>
    </message>
    <message>
        <source>I tell directions, objects and texts.</source>
        <translation>Digo direcciones, objetos y textos.</translation>
    </message>
    <message>
        <source>Directions as left and right.</source>
        <translation>Direcciones como izquierda y derecha.</translation>
    </message>
    <message>
        <source>Directions as on a clock.</source>
        <translation>Direcciones como en un reloj.</translation>
    </message>
    <message>
        <source>Directions in degrees.</source>
        <translation>Direcciones en grados.</translation>
    </message>
    <message>
        <source>Distances in metres.</source>
        <translation>Distancias en metros.</translation>
    </message>
    <message>
        <source>Distances in feet.</source>
        <translation>Distancias en pies.</translation>
    </message>
    <message>
        <source>Distances in steps.</source>
        <translation>Distancias en pasos.</translation>
    </message>
    <message>
        <source>another language</source>
        <translation>otro idioma</translation>
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
        <translation>Punto de referencia %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Qué es</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>What can be read on it</source>
        <translation>Qué se puede leer en él</translation>
    </message>
    <message>
        <source>Trained as</source>
        <translation>Entrenado como</translation>
    </message>
    <message>
        <source>The name under which its appearance was trained</source>
        <translation>El nombre con que se entrenó su aspecto</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>The way it faces: 0 is east, 90 north, 180 west, 270 south</source>
        <translation>Hacia dónde mira: 0 es este, 90 norte, 180 oeste, 270 sur</translation>
    </message>
    <message>
        <source>Height above the floor</source>
        <translation>Altura sobre el suelo</translation>
    </message>
    <message>
        <source>Of its middle</source>
        <translation>De su centro</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>How wide it is: its distance is told from that</source>
        <translation>Qué ancho tiene: de ello se deduce su distancia</translation>
    </message>
    <message>
        <source>Its own height</source>
        <translation>Su propia altura</translation>
    </message>
    <message>
        <source>How tall it is</source>
        <translation>Qué alto es</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Este</translation>
    </message>
    <message>
        <source>Place on the map, metres to the east</source>
        <translation>Lugar en el mapa, metros hacia el este</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Norte</translation>
    </message>
    <message>
        <source>Place on the map, metres to the north</source>
        <translation>Lugar en el mapa, metros hacia el norte</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryDocument</name>
    <message>
        <source>The library was changed meanwhile; try again.</source>
        <translation>La biblioteca cambió entretanto; inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>another program is writing this library; try again</source>
        <translation>otro programa está escribiendo en esta biblioteca; inténtelo de nuevo</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryModel</name>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
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
        <translation>no comprobado</translation>
    </message>
    <message>
        <source>In maps called “%1”</source>
        <translation>En los mapas se llama “%1”</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Punto de referencia</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Real size</source>
        <translation>Tamaño real</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>How well it is found</source>
        <translation>Qué tal se encuentra</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryPanel</name>
    <message>
        <source>Nothing is chosen</source>
        <translation>No hay nada elegido</translation>
    </message>
    <message>
        <source>Not checked yet. “Check all” looks how well each landmark is found.</source>
        <translation>Aún no comprobado. “Comprobar todo” mira qué tal se encuentra cada punto de referencia.</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>Each view is held back once and looked for with the others; then each landmark is shown smaller and turned.</source>
        <translation>Cada vista se aparta una vez y se busca con las demás; después cada punto de referencia se muestra más pequeño y girado.</translation>
    </message>
    <message>
        <source>Not checked yet. “Check all” looks how well each landmark is found, and which are taken for each other.</source>
        <translation>Aún no comprobado. “Comprobar todo” mira qué tal se encuentra cada punto de referencia y cuáles se confunden entre sí.</translation>
    </message>
    <message>
        <source>All landmarks are found well.</source>
        <translation>Todos los puntos de referencia se encuentran bien.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s) need care.</source>
        <translation>
            <numerusform>Un punto de referencia necesita atención.</numerusform>
            <numerusform>%n puntos de referencia necesitan atención.</numerusform>
        </translation>
    </message>
    <message>
        <source>None is taken for another.</source>
        <translation>Ninguno se toma por otro.</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) are taken for each other.</source>
        <translation>
            <numerusform>Un par se confunde entre sí.</numerusform>
            <numerusform>%n pares se confunden entre sí.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rows: whose picture was shown. Columns: what was seen in it. On the diagonal: views found again.</source>
        <translation>Filas: de quién era la imagen mostrada. Columnas: qué se vio en ella. En la diagonal: vistas encontradas de nuevo.</translation>
    </message>
    <message>
        <source>The library was changed since: check again.</source>
        <translation>La biblioteca cambió desde entonces: compruébela de nuevo.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>un punto de referencia</numerusform>
            <numerusform>%n puntos de referencia</numerusform>
        </translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <source>This library is empty. “Teach” begins with the first landmark.</source>
        <translation>Esta biblioteca está vacía. “Enseñar” empieza con el primer punto de referencia.</translation>
    </message>
    <message>
        <source>Open a landmark library, or make a new one, to teach Farol what it shall know again.</source>
        <translation>Abra una biblioteca de puntos de referencia, o cree una nueva, para enseñar a Farol lo que debe reconocer.</translation>
    </message>
    <message>
        <source>Landmarks of the library</source>
        <translation>Puntos de referencia de la biblioteca</translation>
    </message>
    <message>
        <source>The landmarks that Farol was taught; press Enter to add views to one</source>
        <translation>Los puntos de referencia que se enseñaron a Farol; pulse Intro para añadir vistas a uno</translation>
    </message>
    <message>
        <source>Views of the landmark</source>
        <translation>Vistas del punto de referencia</translation>
    </message>
    <message>
        <source>The photographs it is learnt from; choose some of them to split or to delete them</source>
        <translation>Las fotografías de las que se aprende; elija algunas para separarlas o eliminarlas</translation>
    </message>
    <message>
        <source>&amp;Views:</source>
        <translation>&amp;Vistas:</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Punto de referencia</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>C&amp;heck all</source>
        <translation>C&amp;omprobar todo</translation>
    </message>
    <message>
        <source>Check all landmarks</source>
        <translation>Comprobar todos los puntos de referencia</translation>
    </message>
    <message>
        <source>Look how well each landmark is found and which are taken for each other</source>
        <translation>Mirar qué tal se encuentra cada punto de referencia y cuáles se confunden entre sí</translation>
    </message>
    <message>
        <source>Save as CS&amp;V…</source>
        <translation>Guardar como &amp;CSV…</translation>
    </message>
    <message>
        <source>Save the report as CSV</source>
        <translation>Guardar el informe como CSV</translation>
    </message>
    <message>
        <source>Save the report for a spreadsheet</source>
        <translation>Guardar el informe para una hoja de cálculo</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Avance de la comprobación</translation>
    </message>
    <message>
        <source>Who is taken for whom</source>
        <translation>Quién se toma por quién</translation>
    </message>
    <message>
        <source>Rows: whose picture was shown. Columns: what was seen in it.</source>
        <translation>Filas: de quién era la imagen mostrada. Columnas: qué se vio en ella.</translation>
    </message>
    <message>
        <source>All that have several views are found well.</source>
        <translation>Todos los que tienen varias vistas se encuentran bien.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s) cannot be tried: there is only one view. Add another.</source>
        <translation>
            <numerusform>%n punto de referencia no se puede probar: solo tiene una vista. Añada otra.</numerusform>
            <numerusform>%n puntos de referencia no se pueden probar: solo tienen una vista. Añada otra.</numerusform>
        </translation>
    </message>
    <message>
        <source>The photographs of the chosen landmark are shown here.</source>
        <translation>Aquí se muestran las fotografías del punto elegido.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LivePage</name>
    <message>
        <source>What was said</source>
        <translation>Lo que se dijo</translation>
    </message>
    <message>
        <source>Where it could be</source>
        <translation>Dónde podría estar</translation>
    </message>
    <message>
        <source>Every sentence, when it was due, and what became of it</source>
        <translation>Cada frase, cuándo tocaba y qué fue de ella</translation>
    </message>
    <message>
        <source>The places that fit what was seen, best first</source>
        <translation>Los lugares que encajan con lo visto, el mejor primero</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Visto por última vez</translation>
    </message>
    <message>
        <source>The last objects that the place is worked out from</source>
        <translation>Los últimos objetos de los que se deduce el lugar</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>En la imagen</translation>
    </message>
    <message>
        <source>Everything recognised in the picture shown</source>
        <translation>Todo lo reconocido en la imagen mostrada</translation>
    </message>
    <message>
        <source>On this floor</source>
        <translation>En esta planta</translation>
    </message>
    <message>
        <source>The map as a list; press Enter on a place to go there</source>
        <translation>El mapa como lista; pulse Intro en un lugar para ir allí</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>Listas</translation>
    </message>
    <message>
        <source>Why there</source>
        <translation>Por qué allí</translation>
    </message>
    <message>
        <source>What the vote of the chosen place is made of, and what speaks for it</source>
        <translation>De qué se compone el voto del lugar elegido y qué habla a su favor</translation>
    </message>
    <message>
        <source>Nothing has been said yet.</source>
        <translation>Todavía no se ha dicho nada.</translation>
    </message>
    <message>
        <source>Nothing has been worked out yet.</source>
        <translation>Todavía no se ha calculado nada.</translation>
    </message>
    <message>
        <source>As soon as there is a place, what speaks for it stands here.</source>
        <translation>En cuanto haya un lugar, aquí está lo que habla por él.</translation>
    </message>
    <message>
        <source>Nothing has been recognised yet.</source>
        <translation>Todavía no se ha reconocido nada.</translation>
    </message>
    <message>
        <source>Nothing is recognised in the picture.</source>
        <translation>No se reconoce nada en la imagen.</translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>No hay ningún mapa abierto.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LocaliserMenu</name>
    <message>
        <source>&amp;How the place is worked out</source>
        <translation>Cómo se deduce el luga&amp;r</translation>
    </message>
    <message>
        <source>Filter, for people who are &amp;guided</source>
        <translation>Filtro, para personas &amp;guiadas</translation>
    </message>
    <message>
        <source>Filter, for people who &amp;know their way</source>
        <translation>Filtro, para quien &amp;conoce el camino</translation>
    </message>
    <message>
        <source>&amp;Voting</source>
        <translation>&amp;Votación</translation>
    </message>
    <message>
        <source>Voting as first &amp;printed</source>
        <translation>Votación como se &amp;publicó</translation>
    </message>
    <message>
        <source>From the next start of a walk</source>
        <translation>Desde el próximo inicio de un recorrido</translation>
    </message>
</context>
<context>
    <name>farol::ui::MainWindow</name>
    <message>
        <source>About Farol</source>
        <translation>Acerca de Farol</translation>
    </message>
    <message>
        <source>Farol %1

Guides a blind person through a building with one ordinary camera: it recognises what it was taught, works out the place, and speaks the way.</source>
        <translation>Farol %1

Guía a una persona ciega por un edificio con una cámara corriente: reconoce lo que se le enseñó, deduce el lugar y dice el camino.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Walking</source>
        <translation>En recorrido</translation>
    </message>
    <message>
        <source>The walk has ended</source>
        <translation>El recorrido ha terminado</translation>
    </message>
    <message>
        <source>The walk could not go on</source>
        <translation>El recorrido no pudo continuar</translation>
    </message>
    <message>
        <source>Loading…</source>
        <translation>Cargando…</translation>
    </message>
    <message>
        <source>recorded in %1</source>
        <translation>grabado en %1</translation>
    </message>
    <message>
        <source>The walk has ended: there are no more pictures.</source>
        <translation>El recorrido ha terminado: no hay más imágenes.</translation>
    </message>
    <message>
        <source>Play &amp;again</source>
        <translation>Reproducir &amp;otra vez</translation>
    </message>
    <message>
        <source>Open another &amp;map…</source>
        <translation>Abrir otro &amp;mapa…</translation>
    </message>
    <message>
        <source>Open another &amp;library…</source>
        <translation>Abrir otra &amp;biblioteca…</translation>
    </message>
    <message>
        <source>Open other &amp;pictures…</source>
        <translation>Abrir otras &amp;imágenes…</translation>
    </message>
    <message>
        <source>The walk will be recorded from its next start.</source>
        <translation>El recorrido se grabará desde su próximo inicio.</translation>
    </message>
    <message>
        <source>This walk is recorded to its end; the next one is not.</source>
        <translation>Este recorrido se graba hasta su fin; el próximo no.</translation>
    </message>
    <message>
        <source>Start &amp;again now</source>
        <translation>Empezar ahora de &amp;nuevo</translation>
    </message>
    <message>
        <source>Open a map</source>
        <translation>Abrir un mapa</translation>
    </message>
    <message>
        <source>Maps (%1);;All files (%2)</source>
        <translation>Mapas (%1);;Todos los archivos (%2)</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Abrir una biblioteca de puntos de referencia</translation>
    </message>
    <message>
        <source>Landmark libraries (%1);;All files (%2)</source>
        <translation>Bibliotecas de puntos de referencia (%1);;Todos los archivos (%2)</translation>
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
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>State of the walk</source>
        <translation>Estado del recorrido</translation>
    </message>
    <message>
        <source>Something is being loaded</source>
        <translation>Se está cargando algo</translation>
    </message>
    <message>
        <source>&amp;Next visitor now</source>
        <translation>&amp;Siguiente visitante ahora</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <source>Watch a walk, work on a map, or teach landmarks (Ctrl+1 to Ctrl+3)</source>
        <translation>Observar un recorrido, trabajar en un mapa o enseñar puntos de referencia (Ctrl+1 a Ctrl+3)</translation>
    </message>
    <message>
        <source>The landmark library was changed on the Landmarks page.</source>
        <translation>La biblioteca de puntos de referencia cambió en la página Puntos de referencia.</translation>
    </message>
    <message>
        <source>Start &amp;again with it</source>
        <translation>&amp;Empezar de nuevo con ella</translation>
    </message>
    <message>
        <source>Changes are not saved</source>
        <translation>Los cambios no están guardados</translation>
    </message>
    <message>
        <source>The landmark library could not be written; its last changes would be lost.</source>
        <translation>La biblioteca de puntos de referencia no se pudo escribir; sus últimos cambios se perderían.</translation>
    </message>
    <message>
        <source>&amp;Leave all the same</source>
        <translation>&amp;Salir de todos modos</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>&amp;Quedarse</translation>
    </message>
    <message>
        <source>Saved in %1</source>
        <translation>Guardado en %1</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>No se puede escribir %1. Elija otra carpeta.</translation>
    </message>
    <message>
        <source>There is no walk to correct.</source>
        <translation>No hay ningún recorrido que corregir.</translation>
    </message>
    <message>
        <source>Choose a place on the map, or in the list “Where it could be”, first.</source>
        <translation>Elija primero un lugar en el mapa o en la lista “Dónde podría estar”.</translation>
    </message>
    <message>
        <source>The user is in %1: told by you.</source>
        <translation>El usuario está en %1: lo ha dicho usted.</translation>
    </message>
    <message>
        <source>The place is given up and looked for anew.</source>
        <translation>Se renuncia al lugar y se busca de nuevo.</translation>
    </message>
    <message>
        <source>Say this</source>
        <translation>Decir esto</translation>
    </message>
    <message>
        <source>Sentence that is spoken to the user:</source>
        <translation>Frase que se dice al usuario:</translation>
    </message>
    <message>
        <source>&amp;Say it</source>
        <translation>&amp;Decirlo</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Guardar la imagen</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imágenes (%1)</translation>
    </message>
    <message>
        <source>Save the walk as table</source>
        <translation>Guardar el recorrido como tabla</translation>
    </message>
    <message>
        <source>Tables (%1)</source>
        <translation>Tablas (%1)</translation>
    </message>
    <message>
        <source>Open as &amp;map</source>
        <translation>Abrir como &amp;mapa</translation>
    </message>
    <message>
        <source>Open as landmark &amp;library</source>
        <translation>Abrir como &amp;biblioteca de puntos de referencia</translation>
    </message>
    <message>
        <source>The file of this map was changed.</source>
        <translation>El archivo de este mapa ha cambiado.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>&amp;Cargarlo de nuevo</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapActions</name>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Mapa</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>&amp;Abrir mapa…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open the map of a building to look at it and change it</source>
        <translation>Abrir el mapa de un edificio para verlo y cambiarlo</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importar…</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Bring in a map of another kind</source>
        <translation>Traer un mapa de otro tipo</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Write the changes into the map&apos;s file</source>
        <translation>Escribir los cambios en el archivo del mapa</translation>
    </message>
    <message>
        <source>S&amp;ave as…</source>
        <translation>G&amp;uardar como…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>Write the map into another file</source>
        <translation>Escribir el mapa en otro archivo</translation>
    </message>
    <message>
        <source>&amp;Print as PDF…</source>
        <translation>Im&amp;primir como PDF…</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Write the plan of each level as a page of a PDF</source>
        <translation>Escribir el plano de cada planta como página de un PDF</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Retirar el último cambio</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Make the change again that was taken back</source>
        <translation>Volver a hacer el cambio retirado</translation>
    </message>
    <message>
        <source>Add &amp;landmark</source>
        <translation>Añadir punto de re&amp;ferencia</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Punto de referencia</translation>
    </message>
    <message>
        <source>Put a new landmark on the plan</source>
        <translation>Poner un nuevo punto de referencia en el plano</translation>
    </message>
    <message>
        <source>Add &amp;door or passage</source>
        <translation>Añadir puer&amp;ta o paso</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Puerta</translation>
    </message>
    <message>
        <source>Put a new door or passage on the plan</source>
        <translation>Poner una nueva puerta o paso en el plano</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>&amp;Cambiar…</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambiar</translation>
    </message>
    <message>
        <source>Change name, kind and the like of what is chosen</source>
        <translation>Cambiar nombre, tipo y demás de lo elegido</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Take the chosen landmark, door or passage off the map</source>
        <translation>Quitar del mapa el punto de referencia, puerta o paso elegido</translation>
    </message>
    <message>
        <source>Route &amp;from here</source>
        <translation>Ruta desde a&amp;quí</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>Desde aquí</translation>
    </message>
    <message>
        <source>Let the route begin in the chosen place</source>
        <translation>Que la ruta empiece en el lugar elegido</translation>
    </message>
    <message>
        <source>Route &amp;to here</source>
        <translation>Ruta &amp;hasta aquí</translation>
    </message>
    <message>
        <source>To here</source>
        <translation>Hasta aquí</translation>
    </message>
    <message>
        <source>Let the route end in the chosen place</source>
        <translation>Que la ruta termine en el lugar elegido</translation>
    </message>
    <message>
        <source>Sea&amp;rch the table</source>
        <translation>&amp;Buscar en la tabla</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search the table of attributes</source>
        <translation>Buscar en la tabla de atributos</translation>
    </message>
    <message>
        <source>C&amp;heck the map</source>
        <translation>C&amp;omprobar el mapa</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Comprobar</translation>
    </message>
    <message>
        <source>Look for what is wrong with the map as it is now</source>
        <translation>Buscar qué está mal en el mapa tal como está</translation>
    </message>
    <message>
        <source>&amp;Next feature</source>
        <translation>E&amp;lemento siguiente</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Show the next feature of the chosen finding</source>
        <translation>Mostrar el elemento siguiente del hallazgo elegido</translation>
    </message>
    <message>
        <source>Places that look ali&amp;ke</source>
        <translation>Lugares que &amp;se parecen</translation>
    </message>
    <message>
        <source>Alike</source>
        <translation>Parecidos</translation>
    </message>
    <message>
        <source>Mark the places that the landmarks cannot tell apart, and those without any</source>
        <translation>Marcar los lugares que los puntos de referencia no distinguen y los que no tienen ninguno</translation>
    </message>
    <message>
        <source>&amp;Walk with this map</source>
        <translation>Recorrer co&amp;n este mapa</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Use the saved map on the Walk page</source>
        <translation>Usar el mapa guardado en la página Recorrido</translation>
    </message>
    <message>
        <source>Where landmarks are see&amp;n</source>
        <translation>Dó&amp;nde se ven puntos de referencia</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Visibles</translation>
    </message>
    <message>
        <source>Mark from where landmarks can be seen, and from where none can</source>
        <translation>Marcar desde dónde se ven puntos de referencia, y desde dónde ninguno</translation>
    </message>
    <message>
        <source>&amp;Missing routes…</source>
        <translation>Rutas que &amp;faltan…</translation>
    </message>
    <message>
        <source>Missing routes</source>
        <translation>Rutas que faltan</translation>
    </message>
    <message>
        <source>List the places between which no route leads, and why</source>
        <translation>Enumerar los lugares entre los que no hay ruta, y por qué</translation>
    </message>
    <message>
        <source>Floor-plan ima&amp;ge…</source>
        <translation>&amp;Imagen del plano…</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Lay the image of a floor plan under the floor that is shown</source>
        <translation>Poner la imagen de un plano bajo la planta que se ve</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapDocument</name>
    <message>
        <source>Load the map again</source>
        <translation>Cargar el mapa de nuevo</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapPage</name>
    <message>
        <source>Saved in %1</source>
        <translation>Guardado en %1</translation>
    </message>
    <message>
        <source>Open a map</source>
        <translation>Abrir un mapa</translation>
    </message>
    <message>
        <source>Maps (%1);;All files (%2)</source>
        <translation>Mapas (%1);;Todos los archivos (%2)</translation>
    </message>
    <message>
        <source>Save the map</source>
        <translation>Guardar el mapa</translation>
    </message>
    <message>
        <source>Maps (%1)</source>
        <translation>Mapas (%1)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>The map has changes that are not saved.</source>
        <translation>El mapa tiene cambios que no están guardados.</translation>
    </message>
    <message>
        <source>Save them first?</source>
        <translation>¿Guardarlos antes?</translation>
    </message>
    <message>
        <source>Imported from %1. Look at what was found, then save it as a map of Farol.</source>
        <translation>Importado de %1. Vea lo que se encontró y guárdelo como mapa de Farol.</translation>
    </message>
    <message>
        <source>Sa&amp;ve…</source>
        <translation>&amp;Guardar…</translation>
    </message>
    <message>
        <source>The map is being opened…</source>
        <translation>Se está abriendo el mapa…</translation>
    </message>
    <message>
        <source>The map is being imported and checked…</source>
        <translation>Se está importando y comprobando el mapa…</translation>
    </message>
    <message>
        <source>The map is being saved…</source>
        <translation>Se está guardando el mapa…</translation>
    </message>
    <message>
        <source>The map is being checked…</source>
        <translation>Se está comprobando el mapa…</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Comprobación</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Ruta</translation>
    </message>
    <message>
        <source>Parts of the map</source>
        <translation>Partes del mapa</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>Ca&amp;ncelar</translation>
    </message>
    <message>
        <source>Give up; the map that was open stays</source>
        <translation>Renunciar; se queda el mapa que estaba abierto</translation>
    </message>
    <message>
        <source>Click where the landmark stands, or move the plan under the cross with the arrows and press Enter. Escape gives up.</source>
        <translation>Pulse donde está el punto de referencia, o mueva el plano bajo la cruz con las flechas y pulse Intro. Escape lo cancela.</translation>
    </message>
    <message>
        <source>Click where the door is, or move the plan under the cross with the arrows and press Enter. Escape gives up.</source>
        <translation>Pulse donde está la puerta, o mueva el plano bajo la cruz con las flechas y pulse Intro. Escape lo cancela.</translation>
    </message>
    <message>
        <source>Add a landmark</source>
        <translation>Añadir un punto de referencia</translation>
    </message>
    <message>
        <source>Add a door</source>
        <translation>Añadir una puerta</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Eliminar %1</translation>
    </message>
    <message>
        <source>Deleted: %1. Ctrl+Z brings it back.</source>
        <translation>Eliminado: %1. Ctrl+Z lo recupera.</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>Print the plan</source>
        <translation>Imprimir el plano</translation>
    </message>
    <message>
        <source>PDF (%1)</source>
        <translation>PDF (%1)</translation>
    </message>
    <message>
        <source>Printed in %1</source>
        <translation>Impreso en %1</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>No se puede escribir %1. Elija otra carpeta.</translation>
    </message>
    <message>
        <source>Open the map on which the landmark shall stand.</source>
        <translation>Abra el mapa en el que debe estar el punto de referencia.</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>&amp;Abrir mapa…</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map. You have changes of your own: loading it again puts them aside, and Ctrl+Z brings them back.</source>
        <translation>Otro programa ha cambiado el archivo de este mapa. Usted tiene cambios propios: cargarlo de nuevo los aparta, y Ctrl+Z los recupera.</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map.</source>
        <translation>Otro programa ha cambiado el archivo de este mapa.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>&amp;Cargarlo de nuevo</translation>
    </message>
    <message>
        <source>The file %1 is no longer there. The map stays open here: save it, or it is lost when you leave.</source>
        <translation>El archivo %1 ya no está. El mapa sigue abierto aquí: guárdelo, o se perderá al salir.</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map, and it cannot be read any more (%1). The map stays open here as it was: save it under another name.</source>
        <translation>Otro programa ha cambiado el archivo de este mapa, que ya no se puede leer (%1). El mapa sigue abierto aquí como estaba: guárdelo con otro nombre.</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Aún no guardado</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map since it was read here.</source>
        <translation>Otro programa ha cambiado el archivo de este mapa desde que se leyó aquí.</translation>
    </message>
    <message>
        <source>Saving over it would lose what that program wrote.</source>
        <translation>Guardar encima perdería lo que ese programa escribió.</translation>
    </message>
    <message>
        <source>Save under &amp;another name…</source>
        <translation>Guardar con otro &amp;nombre…</translation>
    </message>
    <message>
        <source>Save &amp;over it</source>
        <translation>Guardar &amp;encima</translation>
    </message>
    <message>
        <source>Floor-plan image</source>
        <translation>Imagen del plano</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (%2)</source>
        <translation>Imágenes (%1);;Todos los archivos (%2)</translation>
    </message>
    <message>
        <source>No landmark is seen from %1 % of the floors.</source>
        <translation>Desde el %1 % de las plantas no se ve ningún punto de referencia.</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapPanel</name>
    <message>
        <source>No map is open.</source>
        <translation>No hay ningún mapa abierto.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) on the map.</source>
        <translation>
            <numerusform>Un lugar en el mapa.</numerusform>
            <numerusform>%n lugares en el mapa.</numerusform>
        </translation>
    </message>
    <message>
        <source>Where you are is not known yet.</source>
        <translation>Aún no se sabe dónde está usted.</translation>
    </message>
    <message>
        <source>You are in %1, %2: %3.</source>
        <translation>Usted está en %1, %2: %3.</translation>
    </message>
    <message>
        <source>You are in %1: %2.</source>
        <translation>Usted está en %1: %2.</translation>
    </message>
    <message>
        <source>&amp;Go to %1</source>
        <translation>&amp;Ir a %1</translation>
    </message>
    <message>
        <source>&amp;Start at %1</source>
        <translation>&amp;Empezar en %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>&amp;Level:</source>
        <translation>&amp;Planta:</translation>
    </message>
    <message>
        <source>Level of the map</source>
        <translation>Planta del mapa</translation>
    </message>
    <message>
        <source>The floor that the map shows (Page Up and Page Down in the map)</source>
        <translation>La planta que muestra el mapa (Re Pág y Av Pág en el mapa)</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>&amp;Seguir</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Switch to the floor where you are whenever it changes</source>
        <translation>Pasar a la planta donde usted está cuando cambia</translation>
    </message>
    <message>
        <source>Larger (+)</source>
        <translation>Más grande (+)</translation>
    </message>
    <message>
        <source>Smaller (-)</source>
        <translation>Más pequeño (-)</translation>
    </message>
    <message>
        <source>Show the whole floor (0)</source>
        <translation>Mostrar toda la planta (0)</translation>
    </message>
    <message>
        <source>Floor map</source>
        <translation>Mapa de la planta</translation>
    </message>
    <message>
        <source>Drag to move, turn the wheel to zoom, double-click a place to go there</source>
        <translation>Arrastre para mover, gire la rueda para ampliar, haga doble clic en un lugar para ir allí</translation>
    </message>
    <message>
        <source>Taken to be in %1: %2. Really in %3.</source>
        <translation>Se le supone en %1: %2. En realidad en %3.</translation>
    </message>
    <message>
        <source>The user &amp;is here, in %1</source>
        <translation>El usuario e&amp;stá aquí, en %1</translation>
    </message>
    <message>
        <source>The assistant had said: %1.</source>
        <translation>El asistente había dicho: %1.</translation>
    </message>
    <message>
        <source>said by the assistant</source>
        <translation>dicho por el asistente</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapView</name>
    <message>
        <source>Less likely</source>
        <translation>Menos probable</translation>
    </message>
    <message>
        <source>More likely</source>
        <translation>Más probable</translation>
    </message>
    <message>
        <source>No map is open.
Open one with Ctrl+O.</source>
        <translation>No hay ningún mapa abierto.
Abra uno con Ctrl+O.</translation>
    </message>
</context>
<context>
    <name>farol::ui::MissingDialog</name>
    <message>
        <source>&amp;Show on the plan</source>
        <translation>&amp;Mostrar en el plano</translation>
    </message>
    <message>
        <source>Missing routes</source>
        <translation>Rutas que faltan</translation>
    </message>
    <message>
        <source>Looking for the way between all places…</source>
        <translation>Buscando el camino entre todos los lugares…</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Falta</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Por qué</translation>
    </message>
    <message>
        <source>Places between which no route leads; Enter shows the chosen one on the plan</source>
        <translation>Lugares entre los que no hay ruta; Intro muestra la elegida en el plano</translation>
    </message>
    <message>
        <source>Show on the plan</source>
        <translation>Mostrar en el plano</translation>
    </message>
    <message>
        <source>Choose both places on the Map page, and see them on the plan</source>
        <translation>Elegir los dos lugares en la página Mapa, y verlos en el plano</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more place(s)</source>
        <translation>
            <numerusform>%1 y %n lugar más</numerusform>
            <numerusform>%1 y %n lugares más</numerusform>
        </translation>
    </message>
    <message>
        <source>From every place there is a route to every other one (%1 pairs of places).</source>
        <translation>Desde cada lugar hay una ruta a todos los demás (%1 pares de lugares).</translation>
    </message>
    <message>
        <source>Of %1 pairs of places, %2 have no route.</source>
        <translation>De %1 pares de lugares, %2 no tienen ruta.</translation>
    </message>
    <message numerus="yes">
        <source>%n more line(s) are not listed: mend these first.</source>
        <translation>
            <numerusform>Queda %n línea más sin mostrar: corrija primero estas.</numerusform>
            <numerusform>Quedan %n líneas más sin mostrar: corrija primero estas.</numerusform>
        </translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>en ambos sentidos</translation>
    </message>
    <message>
        <source>this way</source>
        <translation>en este sentido</translation>
    </message>
</context>
<context>
    <name>farol::ui::NoRouteWords</name>
    <message>
        <source>stairs</source>
        <translation>escaleras</translation>
    </message>
    <message>
        <source>a lift</source>
        <translation>un ascensor</translation>
    </message>
    <message>
        <source>an escalator</source>
        <translation>una escalera mecánica</translation>
    </message>
    <message>
        <source>a moving walkway</source>
        <translation>una cinta transportadora</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>una rampa</translation>
    </message>
    <message>
        <source>a narrow door</source>
        <translation>una puerta estrecha</translation>
    </message>
    <message>
        <source>a restricted region</source>
        <translation>un espacio restringido</translation>
    </message>
    <message>
        <source>a closed door or passage</source>
        <translation>una puerta o un paso cerrado</translation>
    </message>
    <message>
        <source>a one-way door or passage</source>
        <translation>una puerta o un paso de sentido único</translation>
    </message>
    <message>
        <source>%1 (from %2 to %3)</source>
        <translation>%1 (de %2 a %3)</translation>
    </message>
    <message>
        <source>The map joins %1 and %2 in no way.</source>
        <translation>El mapa no une %1 y %2 de ningún modo.</translation>
    </message>
    <message>
        <source>%1 is reached only by what is to be avoided: %2.</source>
        <translation>A %1 solo se llega por lo que se quiere evitar: %2.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> o </translation>
    </message>
    <message>
        <source>On the way to %1 stands %2.</source>
        <translation>En el camino a %1 hay %2.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> y </translation>
    </message>
</context>
<context>
    <name>farol::ui::OptionFields</name>
    <message>
        <source>Announce what comes within</source>
        <translation>Anunciar lo que viene a menos de</translation>
    </message>
    <message>
        <source>Say “now” within</source>
        <translation>Decir “ahora” a menos de</translation>
    </message>
    <message>
        <source>Reassure every</source>
        <translation>Confirmar cada</translation>
    </message>
    <message>
        <source>Reassure, where no distance is known, every</source>
        <translation>Confirmar, donde no se conoce distancia, cada</translation>
    </message>
    <message>
        <source>Repeat an instruction after</source>
        <translation>Repetir una instrucción después de</translation>
    </message>
    <message>
        <source>Tell an object again after</source>
        <translation>Volver a decir un objeto después de</translation>
    </message>
    <message>
        <source>Say that the place is not known after</source>
        <translation>Decir que el lugar no se conoce después de</translation>
    </message>
    <message>
        <source>Say again that the route was left after</source>
        <translation>Volver a decir que se dejó la ruta después de</translation>
    </message>
    <message>
        <source>Avoid stairs</source>
        <translation>Evitar escaleras</translation>
    </message>
    <message>
        <source>Avoid lifts</source>
        <translation>Evitar ascensores</translation>
    </message>
    <message>
        <source>Avoid escalators</source>
        <translation>Evitar escaleras mecánicas</translation>
    </message>
    <message>
        <source>Avoid moving walkways</source>
        <translation>Evitar pasillos rodantes</translation>
    </message>
    <message>
        <source>Avoid ramps</source>
        <translation>Evitar rampas</translation>
    </message>
    <message>
        <source>Avoid narrow doors</source>
        <translation>Evitar puertas estrechas</translation>
    </message>
    <message>
        <source>Avoid restricted places</source>
        <translation>Evitar lugares restringidos</translation>
    </message>
    <message>
        <source>Walking speed</source>
        <translation>Velocidad al caminar</translation>
    </message>
    <message>
        <source>Time to find and pass a door</source>
        <translation>Tiempo para encontrar y pasar una puerta</translation>
    </message>
    <message>
        <source>Time for the stairs of a level</source>
        <translation>Tiempo para las escaleras de una planta</translation>
    </message>
    <message>
        <source>Time to wait for a lift and ride it</source>
        <translation>Tiempo para esperar un ascensor y usarlo</translation>
    </message>
    <message>
        <source>Points that must fit an object</source>
        <translation>Puntos que deben encajar en un objeto</translation>
    </message>
    <message>
        <source>Evidence that an object needs</source>
        <translation>Indicios que necesita un objeto</translation>
    </message>
    <message>
        <source>Points that must fit a known place</source>
        <translation>Puntos que deben encajar en un lugar conocido</translation>
    </message>
    <message>
        <source>Sharpness that a picture needs</source>
        <translation>Nitidez que necesita una imagen</translation>
    </message>
</context>
<context>
    <name>farol::ui::OptionForm</name>
    <message>
        <source>&amp;Defaults</source>
        <translation>&amp;Valores iniciales</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Valores iniciales</translation>
    </message>
    <message>
        <source>Take every figure of this page back to what the program has</source>
        <translation>Devolver todos los valores de esta página a los del programa</translation>
    </message>
    <message>
        <source>Usually %1</source>
        <translation>Normalmente %1</translation>
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
        <translation>Aún no hay imagen</translation>
    </message>
    <message>
        <source>The whole picture counts</source>
        <translation>Cuenta toda la imagen</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>arriba a la izquierda</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>arriba a la derecha</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>abajo a la derecha</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>abajo a la izquierda</translation>
    </message>
    <message>
        <source>Corner %1, %2, is %3 to the right and %4 down</source>
        <translation>La esquina %1, %2, está %3 a la derecha y %4 hacia abajo</translation>
    </message>
</context>
<context>
    <name>farol::ui::Phrasebook</name>
    <message>
        <source>I read: %1. %2.</source>
        <extracomment>%1 what is written there, %2 &quot;left, up&quot;</extracomment>
        <translation>Leo: %1. %2.</translation>
    </message>
    <message>
        <source>I have found the way.</source>
        <translation>He encontrado el camino.</translation>
    </message>
    <message>
        <source>Destination: %1.</source>
        <translation>Destino: %1.</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Primero</translation>
    </message>
    <message>
        <source>First, probably</source>
        <translation>Primero, probablemente</translation>
    </message>
    <message>
        <source>Start slowly: I will tell you if it is the wrong way.</source>
        <translation>Empiece despacio: le avisaré si no es por ahí.</translation>
    </message>
    <message>
        <source>Probably %1 first.</source>
        <extracomment>%1 &quot;turn left&quot;, &quot;turn around&quot;</extracomment>
        <translation>Primero, probablemente: %1.</translation>
    </message>
    <message>
        <source>Soon</source>
        <translation>Pronto</translation>
    </message>
    <message>
        <source>Soon, probably</source>
        <translation>Pronto, probablemente</translation>
    </message>
    <message>
        <source>Keep moving forward. You are probably going the right way.</source>
        <translation>Siga adelante. Probablemente va por el buen camino.</translation>
    </message>
    <message>
        <source>Keep moving forward.</source>
        <translation>Siga adelante.</translation>
    </message>
    <message>
        <source>Now turn slowly to the left, past where you began.</source>
        <translation>Ahora gírese despacio hacia la izquierda, más allá de donde empezó.</translation>
    </message>
    <message>
        <source>Hold still, and tilt the camera slowly up.</source>
        <translation>No se mueva e incline la cámara despacio hacia arriba.</translation>
    </message>
    <message>
        <source>Now tilt it slowly down.</source>
        <translation>Ahora inclínela despacio hacia abajo.</translation>
    </message>
    <message>
        <source>I still do not know where you are. If you can, move a few steps along a wall, or ask for help.</source>
        <translation>Sigo sin saber dónde está. Si puede, avance unos pasos junto a una pared, o pida ayuda.</translation>
    </message>
    <message>
        <source>Thank you, that is enough.</source>
        <translation>Gracias, ya es suficiente.</translation>
    </message>
    <message>
        <source>I am not sure where you are. Stop, and turn slowly to the right, so that I can look around.</source>
        <translation>No sé bien dónde está. Deténgase y gírese despacio hacia la derecha, para que pueda mirar alrededor.</translation>
    </message>
    <message>
        <source>You have arrived.</source>
        <translation>Ha llegado a su destino.</translation>
    </message>
    <message>
        <source>You have probably arrived.</source>
        <translation>Probablemente ha llegado a su destino.</translation>
    </message>
    <message>
        <source>You have arrived: %1.</source>
        <translation>Ha llegado a su destino: %1.</translation>
    </message>
    <message>
        <source>You have probably arrived: %1.</source>
        <translation>Probablemente ha llegado a su destino: %1.</translation>
    </message>
    <message>
        <source>You are walking the wrong way.</source>
        <translation>Va en sentido contrario.</translation>
    </message>
    <message>
        <source>You are probably walking the wrong way.</source>
        <translation>Probablemente va en sentido contrario.</translation>
    </message>
    <message>
        <source>You have gone too far.</source>
        <translation>Ha ido demasiado lejos.</translation>
    </message>
    <message>
        <source>You have probably gone too far.</source>
        <translation>Probablemente ha ido demasiado lejos.</translation>
    </message>
    <message>
        <source>You have left the route.</source>
        <translation>Se ha salido de la ruta.</translation>
    </message>
    <message>
        <source>You have probably left the route.</source>
        <translation>Probablemente se ha salido de la ruta.</translation>
    </message>
    <message>
        <source>Stop. I know no way from here.</source>
        <translation>Deténgase. No conozco ningún camino desde aquí.</translation>
    </message>
    <message>
        <source>Stop for a moment.</source>
        <translation>Deténgase un momento.</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>Desde aquí</translation>
    </message>
    <message>
        <source>From here, probably</source>
        <translation>Desde aquí, probablemente</translation>
    </message>
    <message>
        <source>I do not know yet where you are.</source>
        <translation>Aún no sé dónde está.</translation>
    </message>
    <message>
        <source>You are here: %1.</source>
        <translation>Usted está aquí: %1.</translation>
    </message>
    <message>
        <source>You are probably here, or next to it: %1.</source>
        <translation>Probablemente está aquí, o justo al lado: %1.</translation>
    </message>
    <message>
        <source>up</source>
        <translation>arriba</translation>
    </message>
    <message>
        <source>down</source>
        <translation>abajo</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <extracomment>%1 &quot;extinguisher&quot;, %2 &quot;left, down&quot;</extracomment>
        <translation>%1, %2.</translation>
    </message>
    <message>
        <source>perhaps: %1, %2.</source>
        <translation>quizás: %1, %2.</translation>
    </message>
    <message>
        <source>No destination is chosen yet. Choose one first.</source>
        <translation>Aún no hay ningún destino elegido. Elija uno primero.</translation>
    </message>
    <message>
        <source>I do not know this destination. Choose another one.</source>
        <translation>No conozco este destino. Elija otro.</translation>
    </message>
    <message>
        <source>I do not know this destination: %1. Choose another one.</source>
        <translation>No conozco este destino: %1. Elija otro.</translation>
    </message>
    <message>
        <source>I know no way to your destination. Choose another one, or ask for help.</source>
        <translation>No conozco ningún camino hasta su destino. Elija otro o pida ayuda.</translation>
    </message>
    <message>
        <source>I know no way to: %1. Choose another destination, or ask for help.</source>
        <translation>No conozco ningún camino hasta este destino: %1. Elija otro o pida ayuda.</translation>
    </message>
    <message>
        <source>You are already there.</source>
        <translation>Ya está en su destino.</translation>
    </message>
    <message>
        <source>You are probably there already.</source>
        <translation>Probablemente ya está en su destino.</translation>
    </message>
    <message>
        <source>You are already there: %1.</source>
        <translation>Ya está en su destino: %1.</translation>
    </message>
    <message>
        <source>You are probably there already: %1.</source>
        <translation>Probablemente ya está en su destino: %1.</translation>
    </message>
    <message>
        <source>near you</source>
        <translation>cerca de usted</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>what is around</comment>
        <extracomment>%1 &quot;a door&quot;, %2 a name</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>I know of nothing near you.</source>
        <translation>No conozco nada cerca de usted.</translation>
    </message>
    <message>
        <source>The directions are as you face along your way.</source>
        <translation>Las direcciones son las de quien sigue su camino.</translation>
    </message>
    <message>
        <source>The directions are those of the map.</source>
        <translation>Las direcciones son las del mapa.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what is around</comment>
        <extracomment>%1 &quot;on your left&quot;, %2 &quot;a door, Library; an extinguisher&quot;</extracomment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Stop. The camera gives no picture, and I cannot guide you.</source>
        <translation>Deténgase. La cámara no da imagen y no puedo guiarle.</translation>
    </message>
    <message>
        <source>The camera works again.</source>
        <translation>La cámara vuelve a funcionar.</translation>
    </message>
    <message>
        <source>The recording has stopped. I keep guiding you.</source>
        <translation>La grabación se ha detenido. Sigo guiándole.</translation>
    </message>
    <message>
        <source>Stop. I cannot see. Please uncover the camera.</source>
        <translation>Deténgase. No puedo ver. Destape la cámara, por favor.</translation>
    </message>
    <message>
        <source>One picture could not be used. I keep guiding you.</source>
        <translation>Una imagen no se ha podido usar. Sigo guiándole.</translation>
    </message>
    <message>
        <source>Stop. Something is wrong. Please ask for help.</source>
        <translation>Deténgase. Algo va mal. Pida ayuda, por favor.</translation>
    </message>
    <message numerus="yes">
        <source>About %n foot(feet).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Un pie, más o menos.</numerusform>
            <numerusform>Unos %n pies.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n step(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Un paso, más o menos.</numerusform>
            <numerusform>Unos %n pasos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n metre(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Un metro, más o menos.</numerusform>
            <numerusform>Unos %n metros.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n foot(feet)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>A un pie, más o menos</numerusform>
            <numerusform>A unos %n pies</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n step(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>A un paso, más o menos</numerusform>
            <numerusform>A unos %n pasos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n metre(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>A un metro, más o menos</numerusform>
            <numerusform>A unos %n metros</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n foot(feet).</source>
        <translation>
            <numerusform>Siga adelante un pie, más o menos.</numerusform>
            <numerusform>Siga adelante unos %n pies.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n step(s).</source>
        <translation>
            <numerusform>Siga adelante un paso, más o menos.</numerusform>
            <numerusform>Siga adelante unos %n pasos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n metre(s).</source>
        <translation>
            <numerusform>Siga adelante un metro, más o menos.</numerusform>
            <numerusform>Siga adelante unos %n metros.</numerusform>
        </translation>
    </message>
    <message>
        <source>a door</source>
        <translation>una puerta</translation>
    </message>
    <message>
        <source>an opening</source>
        <translation>una abertura</translation>
    </message>
    <message>
        <source>stairs up</source>
        <translation>escaleras que suben</translation>
    </message>
    <message>
        <source>stairs down</source>
        <translation>escaleras que bajan</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>escaleras</translation>
    </message>
    <message>
        <source>a lift</source>
        <translation>un ascensor</translation>
    </message>
    <message>
        <source>an escalator up</source>
        <translation>una escalera mecánica que sube</translation>
    </message>
    <message>
        <source>an escalator down</source>
        <translation>una escalera mecánica que baja</translation>
    </message>
    <message>
        <source>an escalator</source>
        <translation>una escalera mecánica</translation>
    </message>
    <message>
        <source>a ramp up</source>
        <translation>una rampa que sube</translation>
    </message>
    <message>
        <source>a ramp down</source>
        <translation>una rampa que baja</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>una rampa</translation>
    </message>
    <message>
        <source>The stairs are %1.</source>
        <translation>Las escaleras están %1.</translation>
    </message>
    <message>
        <source>The stairs are probably %1.</source>
        <translation>Las escaleras están probablemente %1.</translation>
    </message>
    <message>
        <source>The lift is %1.</source>
        <translation>El ascensor está %1.</translation>
    </message>
    <message>
        <source>The lift is probably %1.</source>
        <translation>El ascensor está probablemente %1.</translation>
    </message>
    <message>
        <source>The escalator is %1.</source>
        <translation>La escalera mecánica está %1.</translation>
    </message>
    <message>
        <source>The escalator is probably %1.</source>
        <translation>La escalera mecánica está probablemente %1.</translation>
    </message>
    <message>
        <source>The ramp is %1.</source>
        <translation>La rampa está %1.</translation>
    </message>
    <message>
        <source>The ramp is probably %1.</source>
        <translation>La rampa está probablemente %1.</translation>
    </message>
    <message>
        <source>You are probably near the door.</source>
        <translation>Probablemente está cerca de la puerta.</translation>
    </message>
    <message>
        <source>You are probably near the opening.</source>
        <translation>Probablemente está cerca de la abertura.</translation>
    </message>
    <message>
        <source>Careful: you are probably near the stairs.</source>
        <translation>Cuidado: probablemente está cerca de las escaleras.</translation>
    </message>
    <message>
        <source>You are probably near the lift.</source>
        <translation>Probablemente está cerca del ascensor.</translation>
    </message>
    <message>
        <source>Careful: you are probably near the escalator.</source>
        <translation>Cuidado: probablemente está cerca de la escalera mecánica.</translation>
    </message>
    <message>
        <source>You are probably near the ramp.</source>
        <translation>Probablemente está cerca de la rampa.</translation>
    </message>
    <message>
        <source>You are probably where you have to turn.</source>
        <translation>Probablemente está donde tiene que girar.</translation>
    </message>
    <message>
        <source>take the stairs up</source>
        <translation>suba por las escaleras</translation>
    </message>
    <message>
        <source>take the stairs down</source>
        <translation>baje por las escaleras</translation>
    </message>
    <message>
        <source>take the stairs, but feel first whether they go up or down</source>
        <translation>tome las escaleras, pero compruebe primero si suben o bajan</translation>
    </message>
    <message>
        <source>take the lift up</source>
        <translation>suba en el ascensor</translation>
    </message>
    <message>
        <source>take the lift down</source>
        <translation>baje en el ascensor</translation>
    </message>
    <message>
        <source>take the lift</source>
        <translation>tome el ascensor</translation>
    </message>
    <message>
        <source>take the escalator up</source>
        <translation>suba por la escalera mecánica</translation>
    </message>
    <message>
        <source>take the escalator down</source>
        <translation>baje por la escalera mecánica</translation>
    </message>
    <message>
        <source>take the escalator, but feel first whether it goes up or down</source>
        <translation>tome la escalera mecánica, pero compruebe primero si sube o baja</translation>
    </message>
    <message>
        <source>go up the ramp</source>
        <translation>suba por la rampa</translation>
    </message>
    <message>
        <source>go down the ramp</source>
        <translation>baje por la rampa</translation>
    </message>
    <message>
        <source>follow the ramp</source>
        <translation>siga por la rampa</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>de enfrente</translation>
    </message>
    <message>
        <source>next</source>
        <comment>door or opening</comment>
        <translation>próxima</translation>
    </message>
    <message>
        <source>get out of the lift</source>
        <translation>salga del ascensor</translation>
    </message>
    <message>
        <source>go into the lift</source>
        <translation>entre en el ascensor</translation>
    </message>
    <message>
        <source>go into the lift %1</source>
        <translation>entre en el ascensor %1</translation>
    </message>
    <message>
        <source>go straight on through two doors in a row</source>
        <translation>siga recto y cruce dos puertas seguidas</translation>
    </message>
    <message>
        <source>go straight on through two openings in a row</source>
        <translation>siga recto y cruce dos aberturas seguidas</translation>
    </message>
    <message>
        <source>go straight on through the door</source>
        <translation>siga recto y cruce la puerta</translation>
    </message>
    <message>
        <source>go straight on through the opening</source>
        <translation>siga recto y cruce la abertura</translation>
    </message>
    <message>
        <source>go through the door</source>
        <translation>cruce la puerta</translation>
    </message>
    <message>
        <source>go through the opening</source>
        <translation>cruce la abertura</translation>
    </message>
    <message>
        <source>go through the door %1</source>
        <translation>cruce la puerta %1</translation>
    </message>
    <message>
        <source>go through the opening %1</source>
        <translation>cruce la abertura %1</translation>
    </message>
    <message>
        <source>go through the %1 door %2</source>
        <translation>cruce la %1 puerta %2</translation>
    </message>
    <message>
        <source>go through the %1 opening %2</source>
        <translation>cruce la %1 abertura %2</translation>
    </message>
    <message>
        <source>follow the wall on your left and go through the opening</source>
        <translation>siga la pared a su izquierda y cruce la abertura</translation>
    </message>
    <message>
        <source>follow the wall on your right and go through the opening</source>
        <translation>siga la pared a su derecha y cruce la abertura</translation>
    </message>
    <message>
        <source>follow the wall on your left and go through the %1 door</source>
        <extracomment>%1 &quot;second&quot;</extracomment>
        <translation>siga la pared a su izquierda y cruce la %1 puerta</translation>
    </message>
    <message>
        <source>follow the wall on your right and go through the %1 door</source>
        <translation>siga la pared a su derecha y cruce la %1 puerta</translation>
    </message>
    <message>
        <source>%1, then %2</source>
        <extracomment>%1 &quot;go through the door&quot;, %2 &quot;turn left&quot;</extracomment>
        <translation>%1, luego %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 &quot;go through the door&quot;, %2 &quot;turning left&quot;</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>move forward</source>
        <translation>avance</translation>
    </message>
    <message>
        <source>your destination</source>
        <translation>su destino</translation>
    </message>
    <message>
        <source>stay in the lift</source>
        <translation>quédese en el ascensor</translation>
    </message>
    <message>
        <source>stay in the lift until: %1</source>
        <translation>quédese en el ascensor hasta: %1</translation>
    </message>
    <message>
        <source>go straight on through the next door</source>
        <translation>siga recto y cruce la próxima puerta</translation>
    </message>
    <message>
        <source>go straight on through the next opening</source>
        <translation>siga recto y cruce la próxima abertura</translation>
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
        <translation>planta %1</translation>
    </message>
    <message>
        <source>minus %1</source>
        <translation>menos %1</translation>
    </message>
    <message>
        <source>It is a long flight.</source>
        <translation>Son muchos escalones.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s).</source>
        <translation>
            <numerusform>Un escalón.</numerusform>
            <numerusform>%n escalones.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: %1.</source>
        <translation>A continuación: %1.</translation>
    </message>
    <message>
        <source>When you get out: %1.</source>
        <translation>Al salir: %1.</translation>
    </message>
    <message>
        <source>At the top: %1.</source>
        <translation>Arriba: %1.</translation>
    </message>
    <message>
        <source>At the bottom: %1.</source>
        <translation>Abajo: %1.</translation>
    </message>
    <message>
        <source>Inside, choose: %1.</source>
        <translation>Dentro, elija: %1.</translation>
    </message>
    <message>
        <source>Then, straight away, %1.</source>
        <translation>Enseguida, %1.</translation>
    </message>
    <message>
        <source>%1: your destination.</source>
        <translation>%1: su destino.</translation>
    </message>
    <message>
        <source>%1: your destination, %2.</source>
        <translation>%1: su destino, %2.</translation>
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
        <translation>%1, %2.</translation>
    </message>
    <message>
        <source>%1: a bend. Follow it, %2.</source>
        <extracomment>%1 &quot;First&quot;, %2 &quot;turning left&quot;</extracomment>
        <translation>%1: una curva. Sígala, %2.</translation>
    </message>
    <message>
        <source>Your destination is here.</source>
        <translation>Su destino está aquí.</translation>
    </message>
    <message>
        <source>Your destination is probably here.</source>
        <translation>Su destino está probablemente aquí.</translation>
    </message>
    <message>
        <source>Your destination is here: %1.</source>
        <translation>Su destino está aquí: %1.</translation>
    </message>
    <message>
        <source>Your destination is probably here: %1.</source>
        <translation>Su destino está probablemente aquí: %1.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more thing(s) to do after that.</source>
        <translation>
            <numerusform>Y después de eso, una cosa más.</numerusform>
            <numerusform>Y después de eso, %n cosas más.</numerusform>
        </translation>
    </message>
    <message>
        <source>known place</source>
        <translation>lugar conocido</translation>
    </message>
    <message>
        <source>door</source>
        <translation>puerta</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>ascensor</translation>
    </message>
    <message>
        <source>extinguisher</source>
        <translation>extintor</translation>
    </message>
    <message>
        <source>exit sign</source>
        <translation>señal de salida</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>letrero</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texto</translation>
    </message>
    <message>
        <source>rectangular shape</source>
        <translation>forma rectangular</translation>
    </message>
    <message>
        <source>window</source>
        <translation>ventana</translation>
    </message>
    <message>
        <source>locker</source>
        <translation>taquilla</translation>
    </message>
    <message>
        <source>poster</source>
        <translation>cartel</translation>
    </message>
    <message>
        <source>drinking fountain</source>
        <translation>fuente de agua</translation>
    </message>
    <message>
        <source>hydrant</source>
        <translation>boca de incendios</translation>
    </message>
    <message>
        <source>vending machine</source>
        <translation>máquina expendedora</translation>
    </message>
    <message>
        <source>waste bin</source>
        <translation>papelera</translation>
    </message>
    <message>
        <source>plant</source>
        <translation>maceta</translation>
    </message>
    <message>
        <source>piece of furniture</source>
        <translation>mueble</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>cuadro</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objeto</translation>
    </message>
    <message>
        <source>an extinguisher</source>
        <translation>un extintor</translation>
    </message>
    <message>
        <source>an exit sign</source>
        <translation>una señal de salida</translation>
    </message>
    <message>
        <source>a sign</source>
        <translation>un letrero</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>a window</source>
        <translation>una ventana</translation>
    </message>
    <message>
        <source>a locker</source>
        <translation>una taquilla</translation>
    </message>
    <message>
        <source>a poster</source>
        <translation>un cartel</translation>
    </message>
    <message>
        <source>a drinking fountain</source>
        <translation>una fuente de agua</translation>
    </message>
    <message>
        <source>a hydrant</source>
        <translation>una boca de incendios</translation>
    </message>
    <message>
        <source>a vending machine</source>
        <translation>una máquina expendedora</translation>
    </message>
    <message>
        <source>a waste bin</source>
        <translation>una papelera</translation>
    </message>
    <message>
        <source>a plant</source>
        <translation>una maceta</translation>
    </message>
    <message>
        <source>a piece of furniture</source>
        <translation>un mueble</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>un cuadro</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>en el centro</translation>
    </message>
    <message>
        <source>1 o&apos;clock</source>
        <translation>una en punto</translation>
    </message>
    <message>
        <source>2 o&apos;clock</source>
        <translation>dos en punto</translation>
    </message>
    <message>
        <source>3 o&apos;clock</source>
        <translation>tres en punto</translation>
    </message>
    <message>
        <source>4 o&apos;clock</source>
        <translation>cuatro en punto</translation>
    </message>
    <message>
        <source>5 o&apos;clock</source>
        <translation>cinco en punto</translation>
    </message>
    <message>
        <source>6 o&apos;clock</source>
        <translation>seis en punto</translation>
    </message>
    <message>
        <source>7 o&apos;clock</source>
        <translation>siete en punto</translation>
    </message>
    <message>
        <source>8 o&apos;clock</source>
        <translation>ocho en punto</translation>
    </message>
    <message>
        <source>9 o&apos;clock</source>
        <translation>nueve en punto</translation>
    </message>
    <message>
        <source>10 o&apos;clock</source>
        <translation>diez en punto</translation>
    </message>
    <message>
        <source>11 o&apos;clock</source>
        <translation>once en punto</translation>
    </message>
    <message>
        <source>12 o&apos;clock</source>
        <translation>doce en punto</translation>
    </message>
    <message>
        <source>go straight on</source>
        <translation>siga recto</translation>
    </message>
    <message>
        <source>turn to %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>gire hacia la %1</translation>
    </message>
    <message>
        <source>turn to %1</source>
        <translation>gire hacia las %1</translation>
    </message>
    <message>
        <source>turn around</source>
        <translation>dé media vuelta</translation>
    </message>
    <message>
        <source>turn %1 degrees to the left</source>
        <translation>gire %1 grados a la izquierda</translation>
    </message>
    <message>
        <source>turn %1 degrees to the right</source>
        <translation>gire %1 grados a la derecha</translation>
    </message>
    <message>
        <source>turn slightly left</source>
        <translation>gire ligeramente a la izquierda</translation>
    </message>
    <message>
        <source>turn left</source>
        <translation>gire a la izquierda</translation>
    </message>
    <message>
        <source>turn sharply left</source>
        <translation>gire muy cerrado a la izquierda</translation>
    </message>
    <message>
        <source>turn slightly right</source>
        <translation>gire ligeramente a la derecha</translation>
    </message>
    <message>
        <source>turn right</source>
        <translation>gire a la derecha</translation>
    </message>
    <message>
        <source>turn sharply right</source>
        <translation>gire muy cerrado a la derecha</translation>
    </message>
    <message>
        <source>turn slightly left</source>
        <comment>on the spot</comment>
        <translation>gírese un poco hacia la izquierda</translation>
    </message>
    <message>
        <source>turn left</source>
        <comment>on the spot</comment>
        <translation>gírese hacia la izquierda</translation>
    </message>
    <message>
        <source>turn sharply left</source>
        <comment>on the spot</comment>
        <translation>gírese mucho hacia la izquierda</translation>
    </message>
    <message>
        <source>turn slightly right</source>
        <comment>on the spot</comment>
        <translation>gírese un poco hacia la derecha</translation>
    </message>
    <message>
        <source>turn right</source>
        <comment>on the spot</comment>
        <translation>gírese hacia la derecha</translation>
    </message>
    <message>
        <source>turn sharply right</source>
        <comment>on the spot</comment>
        <translation>gírese mucho hacia la derecha</translation>
    </message>
    <message>
        <source>turning to %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>girando hacia la %1</translation>
    </message>
    <message>
        <source>turning to %1</source>
        <translation>girando hacia las %1</translation>
    </message>
    <message>
        <source>turning around</source>
        <translation>dando media vuelta</translation>
    </message>
    <message>
        <source>turning %1 degrees to the left</source>
        <translation>girando %1 grados a la izquierda</translation>
    </message>
    <message>
        <source>turning %1 degrees to the right</source>
        <translation>girando %1 grados a la derecha</translation>
    </message>
    <message>
        <source>turning slightly left</source>
        <translation>girando ligeramente a la izquierda</translation>
    </message>
    <message>
        <source>turning left</source>
        <translation>girando a la izquierda</translation>
    </message>
    <message>
        <source>turning sharply left</source>
        <translation>girando muy cerrado a la izquierda</translation>
    </message>
    <message>
        <source>turning slightly right</source>
        <translation>girando ligeramente a la derecha</translation>
    </message>
    <message>
        <source>turning right</source>
        <translation>girando a la derecha</translation>
    </message>
    <message>
        <source>turning sharply right</source>
        <translation>girando muy cerrado a la derecha</translation>
    </message>
    <message>
        <source>on your left</source>
        <translation>a su izquierda</translation>
    </message>
    <message>
        <source>on your right</source>
        <translation>a su derecha</translation>
    </message>
    <message>
        <source>at %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>a la %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>a las %1</translation>
    </message>
    <message>
        <source>straight ahead</source>
        <translation>justo enfrente</translation>
    </message>
    <message>
        <source>behind you</source>
        <translation>detrás de usted</translation>
    </message>
    <message>
        <source>%1 degrees to your right</source>
        <translation>%1 grados a su derecha</translation>
    </message>
    <message>
        <source>%1 degrees to your left</source>
        <translation>%1 grados a su izquierda</translation>
    </message>
    <message>
        <source>ahead, slightly to your right</source>
        <translation>delante, un poco a su derecha</translation>
    </message>
    <message>
        <source>behind you, on the right</source>
        <translation>detrás de usted, a la derecha</translation>
    </message>
    <message>
        <source>behind you, on the left</source>
        <translation>detrás de usted, a la izquierda</translation>
    </message>
    <message>
        <source>ahead, slightly to your left</source>
        <translation>delante, un poco a su izquierda</translation>
    </message>
    <message>
        <source>first</source>
        <comment>door or opening</comment>
        <translation>primera</translation>
    </message>
    <message>
        <source>second</source>
        <comment>door or opening</comment>
        <translation>segunda</translation>
    </message>
    <message>
        <source>third</source>
        <comment>door or opening</comment>
        <translation>tercera</translation>
    </message>
    <message>
        <source>fourth</source>
        <comment>door or opening</comment>
        <translation>cuarta</translation>
    </message>
    <message>
        <source>fifth</source>
        <comment>door or opening</comment>
        <translation>quinta</translation>
    </message>
    <message>
        <source>sixth</source>
        <comment>door or opening</comment>
        <translation>sexta</translation>
    </message>
    <message>
        <source>seventh</source>
        <comment>door or opening</comment>
        <translation>séptima</translation>
    </message>
    <message>
        <source>eighth</source>
        <comment>door or opening</comment>
        <translation>octava</translation>
    </message>
    <message>
        <source>after the extinguisher</source>
        <translation>después del extintor</translation>
    </message>
    <message>
        <source>after the drinking fountain</source>
        <translation>después de la fuente de agua</translation>
    </message>
    <message>
        <source>after the hydrant</source>
        <translation>después de la boca de incendios</translation>
    </message>
    <message>
        <source>after the vending machine</source>
        <translation>después de la máquina expendedora</translation>
    </message>
    <message>
        <source>after the waste bin</source>
        <translation>después de la papelera</translation>
    </message>
    <message>
        <source>after the plant</source>
        <translation>después de la maceta</translation>
    </message>
    <message>
        <source>after the locker</source>
        <translation>después de la taquilla</translation>
    </message>
    <message>
        <source>a room</source>
        <translation>una sala</translation>
    </message>
    <message>
        <source>a corridor</source>
        <translation>un pasillo</translation>
    </message>
    <message>
        <source>a hall</source>
        <translation>un vestíbulo</translation>
    </message>
    <message>
        <source>a stairwell</source>
        <translation>una escalera</translation>
    </message>
    <message>
        <source>a toilet</source>
        <translation>un aseo</translation>
    </message>
    <message>
        <source>outside the building</source>
        <translation>fuera del edificio</translation>
    </message>
    <message>
        <source>to the north-east</source>
        <translation>al noreste</translation>
    </message>
    <message>
        <source>to the east</source>
        <translation>al este</translation>
    </message>
    <message>
        <source>to the south-east</source>
        <translation>al sureste</translation>
    </message>
    <message>
        <source>to the south</source>
        <translation>al sur</translation>
    </message>
    <message>
        <source>to the south-west</source>
        <translation>al suroeste</translation>
    </message>
    <message>
        <source>to the west</source>
        <translation>al oeste</translation>
    </message>
    <message>
        <source>to the north-west</source>
        <translation>al noroeste</translation>
    </message>
    <message>
        <source>to the north</source>
        <translation>al norte</translation>
    </message>
    <message>
        <source>Stop.</source>
        <extracomment>To somebody who walks, or is opening a door</extracomment>
        <translation>Deténgase.</translation>
    </message>
</context>
<context>
    <name>farol::ui::PictureReel</name>
    <message>
        <source>There are no pictures in %1.</source>
        <translation>No hay imágenes en %1.</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlaceChooser</name>
    <message>
        <source>No such place</source>
        <translation>No existe ese lugar</translation>
    </message>
    <message numerus="yes">
        <source>%n places fit: choose one</source>
        <translation>
            <numerusform>un lugar coincide: elíjalo</numerusform>
            <numerusform>%n lugares coinciden: elija uno</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Go to:</source>
        <translation>&amp;Ir a:</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destino</translation>
    </message>
    <message>
        <source>type a name or room number</source>
        <translation>escriba un nombre o número de sala</translation>
    </message>
    <message>
        <source>Where to go: type part of a name, room number or level, then choose</source>
        <translation>Adónde ir: escriba parte de un nombre, número de sala o planta y elija</translation>
    </message>
    <message>
        <source>Start &amp;at:</source>
        <translation>&amp;Empezar en:</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>not known, Farol looks for it</source>
        <translation>desconocido, Farol lo busca</translation>
    </message>
    <message>
        <source>Where the walk starts, if you know it</source>
        <translation>Dónde empieza el recorrido, si lo sabe</translation>
    </message>
    <message>
        <source>F&amp;rom:</source>
        <translation>&amp;Desde:</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>Where the route begins: type part of a name, room number or level, then choose</source>
        <translation>Dónde empieza la ruta: escriba parte de un nombre, número de sala o planta y elija</translation>
    </message>
    <message>
        <source>&amp;To:</source>
        <translation>&amp;Hasta:</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Where the route ends: type part of a name, room number or level, then choose</source>
        <translation>Dónde termina la ruta: escriba parte de un nombre, número de sala o planta y elija</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Type part of a name, room number or level, then choose</source>
        <translation>Escriba parte de un nombre, número de sala o planta y elija</translation>
    </message>
    <message>
        <source>Clear the line</source>
        <translation>Borrar la línea</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlanLegend</name>
    <message>
        <source>no landmark</source>
        <translation>sin punto de referencia</translation>
    </message>
    <message>
        <source>looks like another place</source>
        <translation>se parece a otro lugar</translation>
    </message>
    <message>
        <source>a landmark here helps most</source>
        <translation>aquí ayuda más un punto de referencia</translation>
    </message>
    <message>
        <source>not joined with the rest</source>
        <translation>no unido con el resto</translation>
    </message>
    <message>
        <source>Legend: %1</source>
        <translation>Leyenda: %1</translation>
    </message>
    <message>
        <source>sees no landmark</source>
        <translation>no ve ninguno</translation>
    </message>
    <message>
        <source>sees one</source>
        <translation>ve un punto de referencia</translation>
    </message>
    <message>
        <source>sees several</source>
        <translation>ve varios</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlanPanel</name>
    <message>
        <source>No map is open.</source>
        <translation>No hay ningún mapa abierto.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n region(s), %2</source>
        <translation>
            <numerusform>%1: una región, %2</numerusform>
            <numerusform>%1: %n regiones, %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>un punto de referencia</numerusform>
            <numerusform>%n puntos de referencia</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Level:</source>
        <translation>&amp;Planta:</translation>
    </message>
    <message>
        <source>Level of the plan</source>
        <translation>Planta del plano</translation>
    </message>
    <message>
        <source>The floor that the plan shows (Page Up and Page Down in the plan)</source>
        <translation>La planta que muestra el plano (Re Pág y Av Pág en el plano)</translation>
    </message>
    <message>
        <source>Larger (+)</source>
        <translation>Más grande (+)</translation>
    </message>
    <message>
        <source>Smaller (-)</source>
        <translation>Más pequeño (-)</translation>
    </message>
    <message>
        <source>Show the whole floor (0)</source>
        <translation>Mostrar toda la planta (0)</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>Drag to move, turn the wheel to zoom. What is chosen can be dragged, or moved by Alt and the arrows</source>
        <translation>Arrastre para mover, gire la rueda para ampliar. Lo elegido se puede arrastrar o mover con Alt y las flechas</translation>
    </message>
</context>
<context>
    <name>farol::ui::ProfileMenu</name>
    <message>
        <source>Usual</source>
        <translation>Habitual</translation>
    </message>
    <message>
        <source>Use the settings of %1</source>
        <translation>Usar los ajustes de %1</translation>
    </message>
    <message>
        <source>&amp;New user…</source>
        <translation>&amp;Nuevo usuario…</translation>
    </message>
    <message>
        <source>New user</source>
        <translation>Nuevo usuario</translation>
    </message>
    <message>
        <source>Name; the new user begins with the settings as they are now:</source>
        <translation>Nombre; el nuevo usuario empieza con los ajustes tal como están:</translation>
    </message>
    <message>
        <source>“%1” cannot be used as a name: it must not hold a slash.</source>
        <translation>“%1” no sirve como nombre: no puede contener una barra.</translation>
    </message>
    <message>
        <source>&amp;User</source>
        <translation>&amp;Usuario</translation>
    </message>
</context>
<context>
    <name>farol::ui::RegionDialog</name>
    <message>
        <source>Region %1</source>
        <translation>Región %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>What is spoken</source>
        <translation>Lo que se dice</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>The number on the door</source>
        <translation>El número de la puerta</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What sort of place it is</source>
        <translation>Qué clase de lugar es</translation>
    </message>
    <message>
        <source>Restricted</source>
        <translation>Restringido</translation>
    </message>
    <message>
        <source>Not open to everyone</source>
        <translation>No abierto a todos</translation>
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
            <numerusform>un error</numerusform>
            <numerusform>%n errores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>un aviso</numerusform>
            <numerusform>%n avisos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>una nota</numerusform>
            <numerusform>%n notas</numerusform>
        </translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>No hay ningún mapa abierto.</translation>
    </message>
    <message>
        <source>The map was changed after this check: %1.</source>
        <translation>El mapa cambió después de esta comprobación: %1.</translation>
    </message>
    <message>
        <source>Nothing is wrong with this map.</source>
        <translation>No hay nada mal en este mapa.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Hallazgos</translation>
    </message>
    <message>
        <source>What is wrong with the map; choose a finding to see its place on the plan</source>
        <translation>Qué está mal en el mapa; elija un hallazgo para ver su lugar en el plano</translation>
    </message>
    <message>
        <source>The finding in words</source>
        <translation>El hallazgo en palabras</translation>
    </message>
    <message>
        <source>The finding in words, and what to do</source>
        <translation>El hallazgo en palabras, y qué hacer</translation>
    </message>
    <message>
        <source>Chec&amp;k again</source>
        <translation>Comprobar de &amp;nuevo</translation>
    </message>
    <message>
        <source>Look for what is wrong with the map as it is now (F7)</source>
        <translation>Buscar qué está mal en el mapa tal como está (F7)</translation>
    </message>
    <message>
        <source>Choose a finding to read what it means and what to do.</source>
        <translation>Elija un resultado para leer qué significa y qué hacer.</translation>
    </message>
    <message>
        <source>Ne&amp;xt place</source>
        <translation>Lugar &amp;siguiente</translation>
    </message>
    <message>
        <source>Show the next place of this finding (F4)</source>
        <translation>Mostrar el lugar siguiente de este resultado (F4)</translation>
    </message>
</context>
<context>
    <name>farol::ui::RevoteDialog</name>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Comparar</translation>
    </message>
    <message>
        <source>Work out a recorded walk anew</source>
        <translation>Calcular de nuevo un recorrido grabado</translation>
    </message>
    <message>
        <source>Folder of the recorded walk</source>
        <translation>Carpeta del recorrido grabado</translation>
    </message>
    <message>
        <source>Where the recorded walk is kept</source>
        <translation>Dónde se guarda el recorrido grabado</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Examinar…</translation>
    </message>
    <message>
        <source>Browse for the recorded walk</source>
        <translation>Buscar el recorrido grabado</translation>
    </message>
    <message>
        <source>Folder of a recorded walk</source>
        <translation>Carpeta de un recorrido grabado</translation>
    </message>
    <message>
        <source>How the place is worked out now</source>
        <translation>Cómo se deduce ahora el lugar</translation>
    </message>
    <message>
        <source>What the recorded walk is worked out with the second time</source>
        <translation>Con qué se calcula el recorrido grabado la segunda vez</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Work the walk out as it was, and once more with the other choice</source>
        <translation>Calcular el recorrido como fue y otra vez con la otra elección</translation>
    </message>
    <message>
        <source>The pictures are not looked at again: what was recognised then is taken, and the place is worked out anew.</source>
        <translation>Las imágenes no se miran otra vez: se toma lo reconocido entonces y se deduce de nuevo el lugar.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Where the two differ</source>
        <translation>Dónde difieren</translation>
    </message>
    <message>
        <source>&amp;Recorded walk:</source>
        <translation>&amp;Recorrido grabado:</translation>
    </message>
    <message>
        <source>&amp;Worked out by:</source>
        <translation>Calculado 34 &amp;Calculado por:por:</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Trabajando…</translation>
    </message>
    <message>
        <source>%1 before, %2 now. The same place on %3 of %4 pictures (%5 %). Sentences: %6 before, %7 now.</source>
        <translation>%1 antes, %2 ahora. El mismo lugar en %3 de %4 imágenes (%5 %). Frases: %6 antes, %7 ahora.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
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
        <translation>Empiece en %1.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Tras</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Qué hacer</translation>
    </message>
</context>
<context>
    <name>farol::ui::RoutePanel</name>
    <message>
        <source>No map is open.</source>
        <translation>No hay ningún mapa abierto.</translation>
    </message>
    <message>
        <source>Looking for the way…</source>
        <translation>Buscando el camino…</translation>
    </message>
    <message>
        <source>There is no way. %1</source>
        <translation>No hay camino. %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 m, about %n minute(s), through %2.</source>
        <translation>
            <numerusform>%1 m, cerca de un minuto, a través de %2.</numerusform>
            <numerusform>%1 m, unos %n minutos, a través de %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n door(s) and passage(s)</source>
        <translation>
            <numerusform>una puerta o paso</numerusform>
            <numerusform>%n puertas y pasos</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose where the route begins and ends, here or by the menu of a place on the plan.</source>
        <translation>Elija dónde empieza y termina la ruta, aquí o con el menú de un lugar en el plano.</translation>
    </message>
    <message>
        <source>Swa&amp;p</source>
        <translation>&amp;Invertir</translation>
    </message>
    <message>
        <source>The way back: exchange where the route begins and ends</source>
        <translation>El camino de vuelta: intercambiar inicio y fin de la ruta</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>Evitar</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>escaleras</translation>
    </message>
    <message>
        <source>Find a way without stairs</source>
        <translation>Buscar un camino sin escaleras</translation>
    </message>
    <message>
        <source>lifts</source>
        <translation>ascensores</translation>
    </message>
    <message>
        <source>Find a way without lifts</source>
        <translation>Buscar un camino sin ascensores</translation>
    </message>
    <message>
        <source>escalators</source>
        <translation>escaleras mecánicas</translation>
    </message>
    <message>
        <source>Find a way without escalators</source>
        <translation>Buscar un camino sin escaleras mecánicas</translation>
    </message>
    <message>
        <source>restricted regions</source>
        <translation>regiones restringidas</translation>
    </message>
    <message>
        <source>Find a way that is open to everyone</source>
        <translation>Buscar un camino abierto a todos</translation>
    </message>
    <message>
        <source>Sentences of the route</source>
        <translation>Frases de la ruta</translation>
    </message>
    <message>
        <source>What the walker hears; choose a sentence to see its place on the plan</source>
        <translation>Lo que oye quien camina; elija una frase para ver su lugar en el plano</translation>
    </message>
</context>
<context>
    <name>farol::ui::RuleWords</name>
    <message>
        <source>Outlines that are no proper outline</source>
        <translation>Contornos que no son contornos válidos</translation>
    </message>
    <message>
        <source>Draw the outline again so that it does not cross itself.</source>
        <translation>Dibuje el contorno de nuevo de modo que no se cruce a sí mismo.</translation>
    </message>
    <message>
        <source>Regions that share an id</source>
        <translation>Regiones que comparten un identificador</translation>
    </message>
    <message>
        <source>Give each region an id of its own.</source>
        <translation>Dé a cada región un identificador propio.</translation>
    </message>
    <message>
        <source>Names that nobody can say</source>
        <translation>Nombres que nadie puede decir</translation>
    </message>
    <message>
        <source>Give the region the name that people use; this one is never spoken.</source>
        <translation>Dé a la región el nombre que usa la gente; este nunca se dice.</translation>
    </message>
    <message>
        <source>Doors that share an id</source>
        <translation>Puertas que comparten un identificador</translation>
    </message>
    <message>
        <source>Give each door or passage an id of its own.</source>
        <translation>Dé a cada puerta o paso un identificador propio.</translation>
    </message>
    <message>
        <source>Landmarks that share an id</source>
        <translation>Puntos de referencia que comparten un identificador</translation>
    </message>
    <message>
        <source>Give each landmark an id of its own.</source>
        <translation>Dé a cada punto de referencia un identificador propio.</translation>
    </message>
    <message>
        <source>Doors that do not join two regions</source>
        <translation>Puertas que no unen dos regiones</translation>
    </message>
    <message>
        <source>Choose the region on each side of the door.</source>
        <translation>Elija la región a cada lado de la puerta.</translation>
    </message>
    <message>
        <source>Doors to regions that do not exist</source>
        <translation>Puertas a regiones que no existen</translation>
    </message>
    <message>
        <source>Choose regions that are on the map for both sides.</source>
        <translation>Elija para ambos lados regiones que estén en el mapa.</translation>
    </message>
    <message>
        <source>Doors far from the regions they join</source>
        <translation>Puertas lejos de las regiones que unen</translation>
    </message>
    <message>
        <source>Move the door to where the two regions meet.</source>
        <translation>Mueva la puerta a donde se tocan las dos regiones.</translation>
    </message>
    <message>
        <source>Doors drawn on fewer or more than two regions</source>
        <translation>Puertas dibujadas sobre menos o más de dos regiones</translation>
    </message>
    <message>
        <source>Doors beside more than two regions</source>
        <translation>Puertas junto a más de dos regiones</translation>
    </message>
    <message>
        <source>See that the two sides are the right ones.</source>
        <translation>Compruebe que los dos lados son los correctos.</translation>
    </message>
    <message>
        <source>Passages drawn along the way instead of across it</source>
        <translation>Pasos dibujados a lo largo del camino y no a través</translation>
    </message>
    <message>
        <source>If one walks along the line, choose its two sides by hand.</source>
        <translation>Si se camina a lo largo de la línea, elija sus dos lados a mano.</translation>
    </message>
    <message>
        <source>Doors without a place on the map</source>
        <translation>Puertas sin lugar en el mapa</translation>
    </message>
    <message>
        <source>Draw them in the source, or put them in here.</source>
        <translation>Dibújelas en el original o póngalas aquí.</translation>
    </message>
    <message>
        <source>Stairs or lifts that do not change the level</source>
        <translation>Escaleras o ascensores que no cambian de planta</translation>
    </message>
    <message>
        <source>Choose regions of two levels, or another kind.</source>
        <translation>Elija regiones de dos plantas, u otro tipo.</translation>
    </message>
    <message>
        <source>Parts of the building that no way joins</source>
        <translation>Partes del edificio que ningún camino une</translation>
    </message>
    <message>
        <source>Put in the door, stairs or lift that joins them.</source>
        <translation>Ponga la puerta, las escaleras o el ascensor que las une.</translation>
    </message>
    <message>
        <source>Regions without any door</source>
        <translation>Regiones sin ninguna puerta</translation>
    </message>
    <message>
        <source>Put in the door that leads there.</source>
        <translation>Ponga la puerta que lleva allí.</translation>
    </message>
    <message>
        <source>Regions without a name</source>
        <translation>Regiones sin nombre</translation>
    </message>
    <message>
        <source>Give them the name that people use.</source>
        <translation>Deles el nombre que usa la gente.</translation>
    </message>
    <message>
        <source>Regions of one level with the same number</source>
        <translation>Regiones de una planta con el mismo número</translation>
    </message>
    <message>
        <source>Correct the number of one of them.</source>
        <translation>Corrija el número de una de ellas.</translation>
    </message>
    <message>
        <source>Regions as narrow as a wall</source>
        <translation>Regiones tan estrechas como una pared</translation>
    </message>
    <message>
        <source>Join them with their neighbour in the source.</source>
        <translation>Únalas con su vecina en el original.</translation>
    </message>
    <message>
        <source>Regions that overlap</source>
        <translation>Regiones que se solapan</translation>
    </message>
    <message>
        <source>Draw the border between them in the source.</source>
        <translation>Dibuje el límite entre ellas en el original.</translation>
    </message>
    <message>
        <source>Regions inside other regions</source>
        <translation>Regiones dentro de otras regiones</translation>
    </message>
    <message>
        <source>Cut the smaller one out of the larger one, unless it is a part of it.</source>
        <translation>Recorte la menor de la mayor, salvo que sea parte de ella.</translation>
    </message>
    <message>
        <source>Regions drawn twice</source>
        <translation>Regiones dibujadas dos veces</translation>
    </message>
    <message>
        <source>Remove one of them in the source.</source>
        <translation>Quite una de ellas en el original.</translation>
    </message>
    <message>
        <source>Regions in several parts</source>
        <translation>Regiones en varias partes</translation>
    </message>
    <message>
        <source>Each part became a region; give the parts names of their own.</source>
        <translation>Cada parte se ha convertido en una región; deles nombres propios.</translation>
    </message>
    <message>
        <source>Landmarks in regions that do not exist</source>
        <translation>Puntos de referencia en regiones que no existen</translation>
    </message>
    <message>
        <source>Move the landmark into a region.</source>
        <translation>Mueva el punto de referencia a una región.</translation>
    </message>
    <message>
        <source>Landmarks outside their region</source>
        <translation>Puntos de referencia fuera de su región</translation>
    </message>
    <message>
        <source>Move the landmark into its region.</source>
        <translation>Mueva el punto de referencia a su región.</translation>
    </message>
    <message>
        <source>Landmarks that were given their region by their place</source>
        <translation>Puntos de referencia cuya región se dedujo de su lugar</translation>
    </message>
    <message>
        <source>Levels that the list of levels does not name</source>
        <translation>Plantas que la lista de plantas no nombra</translation>
    </message>
    <message>
        <source>Add the level to the list in the source.</source>
        <translation>Añada la planta a la lista en el original.</translation>
    </message>
    <message>
        <source>Levels named twice</source>
        <translation>Plantas nombradas dos veces</translation>
    </message>
    <message>
        <source>Levels without a usable number</source>
        <translation>Plantas sin un número utilizable</translation>
    </message>
    <message>
        <source>Give the level a number in the source.</source>
        <translation>Dé a la planta un número en el original.</translation>
    </message>
    <message>
        <source>Features whose level was assumed</source>
        <translation>Elementos cuya planta se ha supuesto</translation>
    </message>
    <message>
        <source>Add the level in the source.</source>
        <translation>Añada la planta en el original.</translation>
    </message>
    <message>
        <source>Links between levels that lead nowhere</source>
        <translation>Enlaces entre plantas que no llevan a ninguna parte</translation>
    </message>
    <message>
        <source>Choose regions that are on the map.</source>
        <translation>Elija regiones que estén en el mapa.</translation>
    </message>
    <message>
        <source>Stairs and lifts joined because they lie above one another</source>
        <translation>Escaleras y ascensores unidos por estar uno sobre otro</translation>
    </message>
    <message>
        <source>See that they really are one.</source>
        <translation>Compruebe que de verdad son uno.</translation>
    </message>
    <message>
        <source>Stairs or lifts that leave out a level</source>
        <translation>Escaleras o ascensores que se saltan una planta</translation>
    </message>
    <message>
        <source>Add the stop, if there is one.</source>
        <translation>Añada la parada, si la hay.</translation>
    </message>
    <message>
        <source>Kinds that are not known</source>
        <translation>Tipos que no se conocen</translation>
    </message>
    <message>
        <source>Choose one of the kinds that Farol knows.</source>
        <translation>Elija uno de los tipos que Farol conoce.</translation>
    </message>
    <message>
        <source>Degrees where metres are meant</source>
        <translation>Grados donde se quieren metros</translation>
    </message>
    <message>
        <source>See that the building has its right size.</source>
        <translation>Compruebe que el edificio tiene su tamaño correcto.</translation>
    </message>
    <message>
        <source>Metres where degrees are meant</source>
        <translation>Metros donde se quieren grados</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not named</source>
        <translation>El sistema de coordenadas no está nombrado</translation>
    </message>
    <message>
        <source>Name the coordinate system in the source.</source>
        <translation>Nombre el sistema de coordenadas en el original.</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not understood</source>
        <translation>El sistema de coordenadas no se entiende</translation>
    </message>
    <message>
        <source>Name a common coordinate system in the source.</source>
        <translation>Nombre un sistema de coordenadas común en el original.</translation>
    </message>
    <message>
        <source>Coordinates were converted to metres</source>
        <translation>Las coordenadas se convirtieron a metros</translation>
    </message>
    <message>
        <source>North and east were exchanged</source>
        <translation>Norte y este estaban intercambiados</translation>
    </message>
    <message>
        <source>Export the map again to be sure.</source>
        <translation>Exporte el mapa otra vez para estar seguro.</translation>
    </message>
    <message>
        <source>Points that are no places</source>
        <translation>Puntos que no son lugares</translation>
    </message>
    <message>
        <source>See whether something is missing there.</source>
        <translation>Vea si falta algo allí.</translation>
    </message>
    <message>
        <source>Features without a shape</source>
        <translation>Elementos sin forma</translation>
    </message>
    <message>
        <source>Draw them in the source if they are needed.</source>
        <translation>Dibújelos en el original si hacen falta.</translation>
    </message>
    <message>
        <source>Features without a usable shape</source>
        <translation>Elementos sin forma utilizable</translation>
    </message>
    <message>
        <source>Layers without features</source>
        <translation>Capas sin elementos</translation>
    </message>
    <message>
        <source>Layers whose meaning is not clear</source>
        <translation>Capas cuyo significado no está claro</translation>
    </message>
    <message>
        <source>Say in a profile what the layer holds.</source>
        <translation>Diga en un perfil qué contiene la capa.</translation>
    </message>
    <message>
        <source>Layers that were not used</source>
        <translation>Capas que no se han usado</translation>
    </message>
    <message>
        <source>Codes without a meaning</source>
        <translation>Códigos sin significado</translation>
    </message>
    <message>
        <source>Say in a profile what the code means.</source>
        <translation>Diga en un perfil qué significa el código.</translation>
    </message>
    <message>
        <source>Openings added where no wall stands between regions</source>
        <translation>Aberturas añadidas donde no hay pared entre regiones</translation>
    </message>
    <message>
        <source>See that one can really walk through.</source>
        <translation>Compruebe que de verdad se puede pasar.</translation>
    </message>
    <message>
        <source>Escalators without a direction</source>
        <translation>Escaleras mecánicas sin sentido</translation>
    </message>
    <message>
        <source>Say which way they run.</source>
        <translation>Diga en qué sentido funcionan.</translation>
    </message>
    <message>
        <source>Amenities without a known level</source>
        <translation>Servicios sin planta conocida</translation>
    </message>
    <message>
        <source>Name the level in the source.</source>
        <translation>Nombre la planta en el original.</translation>
    </message>
    <message>
        <source>Amenities without a place</source>
        <translation>Servicios sin lugar</translation>
    </message>
    <message>
        <source>Give them a point in the source.</source>
        <translation>Deles un punto en el original.</translation>
    </message>
    <message>
        <source>Categories that are not known</source>
        <translation>Categorías que no se conocen</translation>
    </message>
    <message>
        <source>Levels without an id</source>
        <translation>Plantas sin identificador</translation>
    </message>
    <message>
        <source>Give the level an id in the source.</source>
        <translation>Dé a la planta un identificador en el original.</translation>
    </message>
    <message>
        <source>Levels without an ordinal</source>
        <translation>Plantas sin ordinal</translation>
    </message>
    <message>
        <source>Give the level an ordinal in the source.</source>
        <translation>Dé a la planta un ordinal en el original.</translation>
    </message>
    <message>
        <source>Parts of the IMDF archive that were not used</source>
        <translation>Partes del archivo IMDF que no se han usado</translation>
    </message>
    <message>
        <source>Walls, columns and voids drawn as units</source>
        <translation>Paredes, columnas y huecos dibujados como unidades</translation>
    </message>
    <message>
        <source>Occupants without a place</source>
        <translation>Ocupantes sin lugar</translation>
    </message>
    <message>
        <source>Name the anchor in the source.</source>
        <translation>Nombre el ancla en el original.</translation>
    </message>
    <message>
        <source>Openings that are closed</source>
        <translation>Aberturas que están cerradas</translation>
    </message>
    <message>
        <source>Openings without a line</source>
        <translation>Aberturas sin línea</translation>
    </message>
    <message>
        <source>Draw the opening as a line in the source.</source>
        <translation>Dibuje la abertura como línea en el original.</translation>
    </message>
    <message>
        <source>Relationships that do not name two units</source>
        <translation>Relaciones que no nombran dos unidades</translation>
    </message>
    <message>
        <source>Name the two units in the source.</source>
        <translation>Nombre las dos unidades en el original.</translation>
    </message>
    <message>
        <source>Units without an outline</source>
        <translation>Unidades sin contorno</translation>
    </message>
    <message>
        <source>Draw the outline in the source.</source>
        <translation>Dibuje el contorno en el original.</translation>
    </message>
    <message>
        <source>Doors that stand on no outline</source>
        <translation>Puertas que no están sobre ningún contorno</translation>
    </message>
    <message>
        <source>Draw the door on the outline of its room.</source>
        <translation>Dibuje la puerta sobre el contorno de su sala.</translation>
    </message>
    <message>
        <source>Openings put where a way enters a room</source>
        <translation>Aberturas puestas donde un camino entra en una sala</translation>
    </message>
    <message>
        <source>Draw the door in the source.</source>
        <translation>Dibuje la puerta en el original.</translation>
    </message>
    <message>
        <source>Objects whose level is not clear</source>
        <translation>Objetos cuya planta no está clara</translation>
    </message>
    <message>
        <source>Objects far from every region</source>
        <translation>Objetos lejos de toda región</translation>
    </message>
    <message>
        <source>Draw the room they stand in.</source>
        <translation>Dibuje la sala en que están.</translation>
    </message>
    <message>
        <source>Features without a level</source>
        <translation>Elementos sin planta</translation>
    </message>
    <message>
        <source>Levels that cannot be read</source>
        <translation>Plantas que no se pueden leer</translation>
    </message>
    <message>
        <source>Correct the level in the source.</source>
        <translation>Corrija la planta en el original.</translation>
    </message>
    <message>
        <source>Lifts without a door</source>
        <translation>Ascensores sin puerta</translation>
    </message>
    <message>
        <source>Move the door to its place.</source>
        <translation>Mueva la puerta a su sitio.</translation>
    </message>
    <message>
        <source>Lifts that are only a point</source>
        <translation>Ascensores que son solo un punto</translation>
    </message>
    <message>
        <source>Steps that lead nowhere</source>
        <translation>Escalones que no llevan a ninguna parte</translation>
    </message>
    <message>
        <source>Draw the area or way that they lead to.</source>
        <translation>Dibuje el área o camino al que llevan.</translation>
    </message>
    <message>
        <source>Steps that may go up or down</source>
        <translation>Escalones que pueden subir o bajar</translation>
    </message>
    <message>
        <source>Say in the source which end is up.</source>
        <translation>Diga en el original qué extremo está arriba.</translation>
    </message>
    <message>
        <source>Steps without a length</source>
        <translation>Escalones sin longitud</translation>
    </message>
    <message>
        <source>Draw the line of the steps.</source>
        <translation>Dibuje la línea de los escalones.</translation>
    </message>
    <message>
        <source>Cells that could not be used</source>
        <translation>Celdas que no se pudieron usar</translation>
    </message>
    <message>
        <source>Give each cell an outline and an id.</source>
        <translation>Dé a cada celda un contorno y un identificador.</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not known</source>
        <translation>El sistema de coordenadas no se conoce</translation>
    </message>
    <message>
        <source>Doors that do not lie between two rooms</source>
        <translation>Puertas que no están entre dos salas</translation>
    </message>
    <message>
        <source>Levels that nothing tells</source>
        <translation>Plantas que nada indica</translation>
    </message>
    <message>
        <source>Say where the level stands when importing.</source>
        <translation>Diga al importar dónde está la planta.</translation>
    </message>
    <message>
        <source>Levels counted from the heights of the floors</source>
        <translation>Plantas contadas por la altura de los suelos</translation>
    </message>
    <message>
        <source>Storeys named by words</source>
        <translation>Pisos nombrados con palabras</translation>
    </message>
    <message>
        <source>Transitions that do not join two cells</source>
        <translation>Transiciones que no unen dos celdas</translation>
    </message>
    <message>
        <source>Correct the transition in the source.</source>
        <translation>Corrija la transición en el original.</translation>
    </message>
    <message>
        <source>Entrances of facilities that are missing</source>
        <translation>Entradas de instalaciones que faltan</translation>
    </message>
    <message>
        <source>Add the facility in the source.</source>
        <translation>Añada la instalación en el original.</translation>
    </message>
    <message>
        <source>Facilities that no entrance leads to</source>
        <translation>Instalaciones a las que no lleva ninguna entrada</translation>
    </message>
    <message>
        <source>Add the entrance in the source.</source>
        <translation>Añada la entrada en el original.</translation>
    </message>
    <message>
        <source>The number of the ground floor was assumed</source>
        <translation>El número de la planta baja se ha supuesto</translation>
    </message>
    <message>
        <source>Say it when importing, if it is another one.</source>
        <translation>Dígalo al importar, si es otro.</translation>
    </message>
    <message>
        <source>Objects far from every node</source>
        <translation>Objetos lejos de todo nodo</translation>
    </message>
    <message>
        <source>Move the object in the source.</source>
        <translation>Mueva el objeto en el original.</translation>
    </message>
    <message>
        <source>Links that do not join two nodes</source>
        <translation>Enlaces que no unen dos nodos</translation>
    </message>
    <message>
        <source>Correct the link in the source.</source>
        <translation>Corrija el enlace en el original.</translation>
    </message>
    <message>
        <source>Nodes that could not be used</source>
        <translation>Nodos que no se pudieron usar</translation>
    </message>
    <message>
        <source>Give each node a place and an id.</source>
        <translation>Dé a cada nodo un lugar y un identificador.</translation>
    </message>
    <message>
        <source>Nodes that no link leads to</source>
        <translation>Nodos a los que no lleva ningún enlace</translation>
    </message>
    <message>
        <source>Add the link in the source.</source>
        <translation>Añada el enlace en el original.</translation>
    </message>
    <message>
        <source>Nodes without a floor</source>
        <translation>Nodos sin planta</translation>
    </message>
    <message>
        <source>Add the floor in the source.</source>
        <translation>Añada la planta en el original.</translation>
    </message>
    <message>
        <source>Regions made from a network of ways</source>
        <translation>Regiones hechas a partir de una red de caminos</translation>
    </message>
    <message>
        <source>Features of an unknown sort</source>
        <translation>Elementos de una clase desconocida</translation>
    </message>
    <message>
        <source>Spaces closed from walls, doors and windows</source>
        <translation>Espacios cerrados a partir de paredes, puertas y ventanas</translation>
    </message>
    <message>
        <source>Give them names.</source>
        <translation>Deles nombres.</translation>
    </message>
    <message>
        <source>Doors with a space on one side only</source>
        <translation>Puertas con un espacio a un solo lado</translation>
    </message>
    <message>
        <source>See whether a wall is missing, or the door leads outside.</source>
        <translation>Vea si falta una pared o si la puerta da al exterior.</translation>
    </message>
    <message>
        <source>Narrow strips between walls</source>
        <translation>Franjas estrechas entre paredes</translation>
    </message>
    <message>
        <source>Directions of doors that are not understood</source>
        <translation>Sentidos de puertas que no se entienden</translation>
    </message>
    <message>
        <source>Say which way one can pass.</source>
        <translation>Diga en qué sentido se puede pasar.</translation>
    </message>
    <message>
        <source>Stairs or lifts to a level that nothing names</source>
        <translation>Escaleras o ascensores a una planta que nada nombra</translation>
    </message>
    <message>
        <source>Choose the region on the other level.</source>
        <translation>Elija la región de la otra planta.</translation>
    </message>
    <message>
        <source>Upper ends of stairs and lifts that are known already</source>
        <translation>Extremos superiores de escaleras y ascensores ya conocidos</translation>
    </message>
    <message>
        <source>Levels counted from the heights of the shapes</source>
        <translation>Plantas contadas por la altura de las formas</translation>
    </message>
    <message>
        <source>Moving walkways without a direction</source>
        <translation>Pasillos rodantes sin sentido</translation>
    </message>
    <message>
        <source>Say in the source which way they run.</source>
        <translation>Diga en el original en qué sentido funcionan.</translation>
    </message>
    <message>
        <source>Moving walkways that lead nowhere</source>
        <translation>Pasillos rodantes que no llevan a ninguna parte</translation>
    </message>
    <message>
        <source>Regions whose door joins two others</source>
        <translation>Regiones cuya puerta une otras dos</translation>
    </message>
    <message>
        <source>Correct the sides of the door, or put in another one.</source>
        <translation>Corrija los lados de la puerta o ponga otra.</translation>
    </message>
    <message>
        <source>Something to look at</source>
        <translation>Algo que mirar</translation>
    </message>
</context>
<context>
    <name>farol::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>As the computer is set</source>
        <translation>Como el ordenador</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Language of the window and of the voice</source>
        <translation>Idioma de la ventana y de la voz</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Idioma:</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Izquierda y derecha</translation>
    </message>
    <message>
        <source>Hours of a clock</source>
        <translation>Horas de un reloj</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Grados</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Direcciones</translation>
    </message>
    <message>
        <source>How turns are told</source>
        <translation>Cómo se dicen los giros</translation>
    </message>
    <message>
        <source>&amp;Directions:</source>
        <translation>&amp;Direcciones:</translation>
    </message>
    <message>
        <source>The way only</source>
        <translation>Solo el camino</translation>
    </message>
    <message>
        <source>The way and objects</source>
        <translation>El camino y los objetos</translation>
    </message>
    <message>
        <source>The way, objects and texts</source>
        <translation>El camino, los objetos y los textos</translation>
    </message>
    <message>
        <source>What is told</source>
        <translation>Qué se dice</translation>
    </message>
    <message>
        <source>How much is told on the way</source>
        <translation>Cuánto se dice por el camino</translation>
    </message>
    <message>
        <source>&amp;What is told:</source>
        <translation>&amp;Qué se dice:</translation>
    </message>
    <message>
        <source>The first that works</source>
        <translation>El primero que funcione</translation>
    </message>
    <message>
        <source>Speech program</source>
        <translation>Programa de voz</translation>
    </message>
    <message>
        <source>Which speech program of this computer speaks</source>
        <translation>Qué programa de voz de este ordenador habla</translation>
    </message>
    <message>
        <source>&amp;Speech program:</source>
        <translation>&amp;Programa de voz:</translation>
    </message>
    <message>
        <source>What fits the language</source>
        <translation>La que va con el idioma</translation>
    </message>
    <message>
        <source>Voice</source>
        <translation>Voz</translation>
    </message>
    <message>
        <source>Press “List voices” to choose among those of the speech program</source>
        <translation>Pulse “Listar voces” para elegir entre las del programa de voz</translation>
    </message>
    <message>
        <source>List &amp;voices</source>
        <translation>Listar &amp;voces</translation>
    </message>
    <message>
        <source>List voices</source>
        <translation>Listar voces</translation>
    </message>
    <message>
        <source>Ask the speech program for its voices; this can take some seconds</source>
        <translation>Preguntar al programa de voz por sus voces; puede tardar unos segundos</translation>
    </message>
    <message>
        <source>V&amp;oice:</source>
        <translation>V&amp;oz:</translation>
    </message>
    <message>
        <source>Speed of the voice</source>
        <translation>Velocidad de la voz</translation>
    </message>
    <message>
        <source>Slow on the left, fast on the right</source>
        <translation>Lenta a la izquierda, rápida a la derecha</translation>
    </message>
    <message>
        <source>S&amp;peed of the voice:</source>
        <translation>V&amp;elocidad de la voz:</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>How loud the voice is</source>
        <translation>Qué volumen tiene la voz</translation>
    </message>
    <message>
        <source>Lo&amp;udness:</source>
        <translation>Vol&amp;umen:</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Carpeta de grabaciones</translation>
    </message>
    <message>
        <source>Where recorded walks are kept</source>
        <translation>Dónde se guardan los recorridos grabados</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>E&amp;xaminar…</translation>
    </message>
    <message>
        <source>Browse for the folder of recordings</source>
        <translation>Buscar la carpeta de grabaciones</translation>
    </message>
    <message>
        <source>Choose where recorded walks are kept</source>
        <translation>Elegir dónde se guardan los recorridos grabados</translation>
    </message>
    <message>
        <source>&amp;Recordings:</source>
        <translation>&amp;Grabaciones:</translation>
    </message>
    <message>
        <source>Pages of the settings</source>
        <translation>Páginas de los ajustes</translation>
    </message>
    <message>
        <source>General</source>
        <translation>General</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>When something is said. From the next start of a walk.</source>
        <translation>Cuándo se dice algo. Desde el próximo inicio de un recorrido.</translation>
    </message>
    <message>
        <source>Routes</source>
        <translation>Rutas</translation>
    </message>
    <message>
        <source>Which way is chosen. From the next start of a walk.</source>
        <translation>Qué camino se elige. Desde el próximo inicio de un recorrido.</translation>
    </message>
    <message>
        <source>Recognition</source>
        <translation>Reconocimiento</translation>
    </message>
    <message>
        <source>How sure a landmark must be before it counts. Lower figures find more, and more that is wrong: leave them unless you can check. From the next start of a walk.</source>
        <translation>Cuán seguro debe ser un punto de referencia para que cuente. Valores más bajos encuentran más, y más errores: déjelos salvo que pueda comprobarlos. Desde el próximo inicio de un recorrido.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Light or dark windows</source>
        <translation>Ventanas claras u oscuras</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Colores:</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metros</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pies</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distancias</translation>
    </message>
    <message>
        <source>How distances are told</source>
        <translation>Cómo se dicen las distancias</translation>
    </message>
    <message>
        <source>Dis&amp;tances:</source>
        <translation>Dis&amp;tancias:</translation>
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
        <translation>&amp;Número de cámara</translation>
    </message>
    <message>
        <source>&amp;Video file</source>
        <translation>&amp;Archivo de vídeo</translation>
    </message>
    <message>
        <source>&amp;Folder of pictures</source>
        <translation>&amp;Carpeta de imágenes</translation>
    </message>
    <message>
        <source>Network &amp;address</source>
        <translation>&amp;Dirección de red</translation>
    </message>
    <message>
        <source>Open pictures</source>
        <translation>Abrir imágenes</translation>
    </message>
    <message>
        <source>Camera number</source>
        <translation>Número de cámara</translation>
    </message>
    <message>
        <source>0 is the first camera of this computer</source>
        <translation>0 es la primera cámara de este ordenador</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>Archivo de vídeo</translation>
    </message>
    <message>
        <source>Folder of pictures</source>
        <translation>Carpeta de imágenes</translation>
    </message>
    <message>
        <source>Network address</source>
        <translation>Dirección de red</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Imágenes por segundo</translation>
    </message>
    <message>
        <source>How many pictures of the folder make a second</source>
        <translation>Cuántas imágenes de la carpeta hacen un segundo</translation>
    </message>
    <message>
        <source>Pictures a &amp;second:</source>
        <translation>Imágenes por &amp;segundo:</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Examinar…</translation>
    </message>
    <message>
        <source>Browse for a video file</source>
        <translation>Buscar un archivo de vídeo</translation>
    </message>
    <message>
        <source>B&amp;rowse…</source>
        <translation>E&amp;xaminar…</translation>
    </message>
    <message>
        <source>Browse for a folder</source>
        <translation>Buscar una carpeta</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Abrir un vídeo</translation>
    </message>
    <message>
        <source>Videos (%1);;All files (%2)</source>
        <translation>Vídeos (%1);;Todos los archivos (%2)</translation>
    </message>
    <message>
        <source>Open a folder of pictures</source>
        <translation>Abrir una carpeta de imágenes</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechDesk</name>
    <message>
        <source>Voice off: sentences are only shown</source>
        <translation>Voz desactivada: las frases solo se muestran</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechOutput</name>
    <message>
        <source>The voice starts with the first sentence.</source>
        <translation>La voz empieza con la primera frase.</translation>
    </message>
    <message>
        <source>The voice hangs: nothing may be heard. Choose another one in the settings.</source>
        <translation>La voz se ha colgado: quizá no se oiga nada. Elija otra en los ajustes.</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechQueue</name>
    <message>
        <source>There is nothing to repeat.</source>
        <translation>No hay nada que repetir.</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachPanel</name>
    <message>
        <source>Give up?</source>
        <translation>¿Renunciar?</translation>
    </message>
    <message>
        <source>What you have taught of this landmark will be lost.</source>
        <translation>Lo que ha enseñado de este punto de referencia se perderá.</translation>
    </message>
    <message>
        <source>&amp;Give it up</source>
        <translation>&amp;Renunciar</translation>
    </message>
    <message>
        <source>&amp;Keep it</source>
        <translation>&amp;Conservarlo</translation>
    </message>
    <message>
        <source>Add a view first.</source>
        <translation>Añada primero una vista.</translation>
    </message>
    <message>
        <source>Learning…</source>
        <translation>Aprendiendo…</translation>
    </message>
    <message>
        <source>A new landmark</source>
        <translation>Un nuevo punto de referencia</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Qué es</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Prueba</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Paso %1 de %2: %3</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Hecho</translation>
    </message>
    <message>
        <source>&amp;Save it</source>
        <translation>&amp;Guardarlo</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Continuar</translation>
    </message>
    <message>
        <source>Go back to the library</source>
        <translation>Volver a la biblioteca</translation>
    </message>
    <message>
        <source>Put it into the library</source>
        <translation>Ponerlo en la biblioteca</translation>
    </message>
    <message>
        <source>The next step</source>
        <translation>El paso siguiente</translation>
    </message>
    <message>
        <source>“%1” is in the library. Where does it hang? Put it on the map, so that Farol knows where you are when it is seen. The same landmark can hang in several places.</source>
        <translation>“%1” está en la biblioteca. ¿Dónde está colgado? Póngalo en el mapa, para que Farol sepa dónde está usted cuando lo vea. El mismo punto de referencia puede estar en varios lugares.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Atrás</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>The step before</source>
        <translation>El paso anterior</translation>
    </message>
    <message>
        <source>Put as&amp;ide</source>
        <translation>&amp;Dejar aparte</translation>
    </message>
    <message>
        <source>Put aside</source>
        <translation>Dejar aparte</translation>
    </message>
    <message>
        <source>Go back to the library and go on with this landmark later</source>
        <translation>Volver a la biblioteca y seguir después con este punto de referencia</translation>
    </message>
    <message>
        <source>Give &amp;up</source>
        <translation>&amp;Renunciar</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Renunciar</translation>
    </message>
    <message>
        <source>Forget this landmark</source>
        <translation>Olvidar este punto de referencia</translation>
    </message>
    <message>
        <source>Put it on the &amp;map…</source>
        <translation>Ponerlo en el &amp;mapa…</translation>
    </message>
    <message>
        <source>Put it on the map</source>
        <translation>Ponerlo en el mapa</translation>
    </message>
    <message>
        <source>Choose its place on the Map page</source>
        <translation>Elegir su lugar en la página Mapa</translation>
    </message>
    <message>
        <source>Teach an&amp;other</source>
        <translation>Enseñar &amp;otro</translation>
    </message>
    <message>
        <source>Teach another</source>
        <translation>Enseñar otro</translation>
    </message>
    <message>
        <source>Teach the next landmark</source>
        <translation>Enseñar el siguiente punto de referencia</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachSession</name>
    <message>
        <source>Give it a name first.</source>
        <translation>Dele primero un nombre.</translation>
    </message>
    <message>
        <source>Say what maps shall call it: letters and digits.</source>
        <translation>Diga cómo lo llamarán los mapas: letras y cifras.</translation>
    </message>
    <message>
        <source>“%1” is in the library already. Choose another name, or add views to that one.</source>
        <translation>“%1” ya está en la biblioteca. Elija otro nombre, o añada vistas a ese.</translation>
    </message>
    <message>
        <source>there is no view yet</source>
        <translation>todavía no hay ninguna fotografía</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachTry</name>
    <message>
        <source>Folder of a recorded walk, or of pictures</source>
        <translation>Carpeta de un recorrido grabado, o de imágenes</translation>
    </message>
    <message>
        <source>Found, %1 % sure.</source>
        <translation>Encontrado, %1 % seguro.</translation>
    </message>
    <message>
        <source>About %1 m away.</source>
        <translation>A unos %1 m.</translation>
    </message>
    <message>
        <source>Not found.</source>
        <translation>No encontrado.</translation>
    </message>
    <message>
        <source>Not found: %1.</source>
        <translation>No encontrado: %1.</translation>
    </message>
    <message>
        <source>Also seen: %1.</source>
        <translation>También visto: %1.</translation>
    </message>
    <message>
        <source>Found in %1 of %2 pictures looked at.</source>
        <translation>Encontrado en %1 de %2 imágenes miradas.</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Buscando…</translation>
    </message>
    <message>
        <source>No picture yet.</source>
        <translation>Aún no hay imagen.</translation>
    </message>
    <message>
        <source>Looking how well it is found…</source>
        <translation>Mirando qué tal se encuentra…</translation>
    </message>
    <message>
        <source>Walk towards it, past it and away from it, or step through other pictures, and see whether Farol finds it. Go back to add views where it is lost.</source>
        <translation>Acérquese, pase por delante y aléjese, o recorra otras imágenes, y vea si Farol lo encuentra. Vuelva atrás para añadir vistas donde se pierde.</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Cámara</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Look for it with the camera of this computer</source>
        <translation>Buscarlo con la cámara de este ordenador</translation>
    </message>
    <message>
        <source>&amp;Recording…</source>
        <translation>&amp;Grabación…</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>Look for it in a recorded walk, or in any folder of pictures</source>
        <translation>Buscarlo en un recorrido grabado o en cualquier carpeta de imágenes</translation>
    </message>
    <message>
        <source>Pre&amp;vious picture</source>
        <translation>Imagen an&amp;terior</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Imagen anterior</translation>
    </message>
    <message>
        <source>The picture before</source>
        <translation>La imagen de antes</translation>
    </message>
    <message>
        <source>Ne&amp;xt picture</source>
        <translation>Imagen &amp;siguiente</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Imagen siguiente</translation>
    </message>
    <message>
        <source>The picture after</source>
        <translation>La imagen de después</translation>
    </message>
    <message>
        <source>Picture with what was recognised</source>
        <translation>Imagen con lo reconocido</translation>
    </message>
    <message>
        <source>What was recognised in this picture, and what nearly was</source>
        <translation>Lo que se reconoció en esta imagen, y lo que casi</translation>
    </message>
    <message>
        <source>How well it will be found</source>
        <translation>Qué tal se encontrará</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachViews</name>
    <message>
        <source>No outline was found. Set the four corners yourself.</source>
        <translation>No se encontró ningún contorno. Ponga usted las cuatro esquinas.</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>Fotografías</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (%2)</source>
        <translation>Imágenes (%1);;Todos los archivos (%2)</translation>
    </message>
    <message>
        <source>Folder of a recorded walk, or of pictures</source>
        <translation>Carpeta de un recorrido grabado, o de imágenes</translation>
    </message>
    <message>
        <source>Learning this view…</source>
        <translation>Aprendiendo esta vista…</translation>
    </message>
    <message numerus="yes">
        <source>This picture is good: %n point(s).</source>
        <translation>
            <numerusform>Esta imagen es buena: un punto.</numerusform>
            <numerusform>Esta imagen es buena: %n puntos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Coach: %1</source>
        <translation>Consejo: %1</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 de %3)</translation>
    </message>
    <message>
        <source>Looking how well it is found…</source>
        <translation>Mirando qué tal se encuentra…</translation>
    </message>
    <message>
        <source>Nothing yet: add a view.</source>
        <translation>Aún nada: añada una vista.</translation>
    </message>
    <message numerus="yes">
        <source>With the %n view(s) it had before.</source>
        <translation>
            <numerusform>Con la vista que ya tenía.</numerusform>
            <numerusform>Con las %n vistas que ya tenía.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Cámara</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Take photographs with the camera of this computer</source>
        <translation>Hacer fotografías con la cámara de este ordenador</translation>
    </message>
    <message>
        <source>&amp;Pictures…</source>
        <translation>&amp;Imágenes…</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Choose photographs from files</source>
        <translation>Elegir fotografías de archivos</translation>
    </message>
    <message>
        <source>&amp;Recording…</source>
        <translation>&amp;Grabación…</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>Choose the folder of a recorded walk, or any folder of pictures</source>
        <translation>Elegir la carpeta de un recorrido grabado, o cualquier carpeta de imágenes</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>&amp;Retener</translation>
    </message>
    <message>
        <source>Hold the picture</source>
        <translation>Retener la imagen</translation>
    </message>
    <message>
        <source>Keep the picture that the camera shows now</source>
        <translation>Conservar la imagen que muestra ahora la cámara</translation>
    </message>
    <message>
        <source>Pre&amp;vious picture</source>
        <translation>Imagen an&amp;terior</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Imagen anterior</translation>
    </message>
    <message>
        <source>The picture before</source>
        <translation>La imagen de antes</translation>
    </message>
    <message>
        <source>Ne&amp;xt picture</source>
        <translation>Imagen &amp;siguiente</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Imagen siguiente</translation>
    </message>
    <message>
        <source>The picture after</source>
        <translation>La imagen de después</translation>
    </message>
    <message>
        <source>&amp;Find outline</source>
        <translation>&amp;Buscar contorno</translation>
    </message>
    <message>
        <source>Find the outline</source>
        <translation>Buscar el contorno</translation>
    </message>
    <message>
        <source>Look for the outline in this picture</source>
        <translation>Buscar el contorno en esta imagen</translation>
    </message>
    <message>
        <source>Whole p&amp;icture</source>
        <translation>T&amp;oda la imagen</translation>
    </message>
    <message>
        <source>Outline the whole picture</source>
        <translation>Tomar como contorno toda la imagen</translation>
    </message>
    <message>
        <source>Set the corners to those of the picture</source>
        <translation>Poner las esquinas en las de la imagen</translation>
    </message>
    <message>
        <source>&amp;Add this view</source>
        <translation>Aña&amp;dir esta vista</translation>
    </message>
    <message>
        <source>Add this view</source>
        <translation>Añadir esta vista</translation>
    </message>
    <message>
        <source>Learn the landmark from this picture</source>
        <translation>Aprender el punto de referencia de esta imagen</translation>
    </message>
    <message>
        <source>Re&amp;move view</source>
        <translation>Quitar &amp;vista</translation>
    </message>
    <message>
        <source>Remove the chosen view</source>
        <translation>Quitar la vista elegida</translation>
    </message>
    <message>
        <source>Forget the chosen view</source>
        <translation>Olvidar la vista elegida</translation>
    </message>
    <message>
        <source>Coach</source>
        <translation>Consejo</translation>
    </message>
    <message>
        <source>Views so far</source>
        <translation>Vistas hasta ahora</translation>
    </message>
    <message>
        <source>How well it will be found</source>
        <translation>Qué tal se encontrará</translation>
    </message>
    <message>
        <source>The photographs it is learnt from</source>
        <translation>Las fotografías de las que se aprende</translation>
    </message>
    <message>
        <source>Picture with outline</source>
        <translation>Imagen con contorno</translation>
    </message>
    <message>
        <source>Drag the four corners onto the landmark. By keys: 1 to 4 choose a corner, the arrows move it, with Shift by one pixel.</source>
        <translation>Arrastre las cuatro esquinas al punto de referencia. Con teclas: 1 a 4 eligen una esquina, las flechas la mueven, con Mayús un píxel.</translation>
    </message>
    <message>
        <source>No picture yet.
Switch on the camera, or choose pictures or a recording.</source>
        <translation>Aún no hay imagen.
Encienda la cámara, o elija imágenes o una grabación.</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachWhat</name>
    <message>
        <source>What is it that Farol shall know again? A sign, a poster, a door with something on it: flat things with detail are known best. Choose “known place” for the whole view of a spot.</source>
        <translation>¿Qué debe reconocer Farol? Un letrero, un cartel, una puerta con algo encima: lo plano y con detalle se reconoce mejor. Elija “lugar conocido” para la vista entera de un sitio.</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Nombre:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>What people call it</source>
        <translation>Cómo lo llama la gente</translation>
    </message>
    <message>
        <source>&amp;Kind:</source>
        <translation>&amp;Tipo:</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Qué es</translation>
    </message>
    <message>
        <source>Real &amp;width:</source>
        <translation>&amp;Ancho real:</translation>
    </message>
    <message>
        <source>Real width</source>
        <translation>Ancho real</translation>
    </message>
    <message>
        <source>Lets Farol tell how far away it is</source>
        <translation>Permite a Farol decir a qué distancia está</translation>
    </message>
    <message>
        <source>Real &amp;height:</source>
        <translation>A&amp;lto real:</translation>
    </message>
    <message>
        <source>Real height</source>
        <translation>Alto real</translation>
    </message>
    <message>
        <source>In &amp;maps called:</source>
        <translation>Nombre en los &amp;mapas:</translation>
    </message>
    <message>
        <source>In maps called</source>
        <translation>Nombre en los mapas</translation>
    </message>
    <message>
        <source>Landmarks of the map refer to it by this word, so it should not change</source>
        <translation>Los puntos de referencia del mapa lo citan con esta palabra; no debería cambiar</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
</context>
<context>
    <name>farol::ui::TimelineBar</name>
    <message>
        <source>T&amp;imeline:</source>
        <translation>Línea de &amp;tiempo:</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>How sure the place was, and marks where something was said. Drag it, or use the arrow keys, to look back; End goes back to now.</source>
        <translation>Qué seguro era el lugar, y marcas donde se dijo algo. Arrástrela o use las flechas para mirar atrás; Fin vuelve al ahora.</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Back to now</source>
        <translation>Volver al ahora</translation>
    </message>
    <message>
        <source>Show the walk as it is now</source>
        <translation>Mostrar el recorrido como es ahora</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Looking back at %1</source>
        <translation>Mirando atrás, a las %1</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingActions</name>
    <message>
        <source>&amp;Landmarks</source>
        <translation>&amp;Puntos de referencia</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <source>&amp;Open library…</source>
        <translation>A&amp;brir biblioteca…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Abrir una biblioteca de puntos de referencia</translation>
    </message>
    <message>
        <source>&amp;New library…</source>
        <translation>Biblioteca &amp;nueva…</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nueva</translation>
    </message>
    <message>
        <source>Make an empty landmark library</source>
        <translation>Crear una biblioteca de puntos de referencia vacía</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Guardar c&amp;omo…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>Write the library into another file; every change is saved by itself</source>
        <translation>Escribir la biblioteca en otro archivo; cada cambio se guarda solo</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Retirar el último cambio</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Make the change again that was taken back</source>
        <translation>Volver a hacer el cambio retirado</translation>
    </message>
    <message>
        <source>&amp;Teach a landmark</source>
        <translation>&amp;Enseñar un punto de referencia</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Enseñar</translation>
    </message>
    <message>
        <source>Teach Farol a new landmark, step by step</source>
        <translation>Enseñar a Farol un nuevo punto de referencia, paso a paso</translation>
    </message>
    <message>
        <source>Add &amp;views</source>
        <translation>Añadir &amp;vistas</translation>
    </message>
    <message>
        <source>Add views</source>
        <translation>Añadir vistas</translation>
    </message>
    <message>
        <source>Teach more views of the chosen landmark</source>
        <translation>Enseñar más vistas del punto de referencia elegido</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>&amp;Cambiar…</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambiar</translation>
    </message>
    <message>
        <source>Change the name, kind or size of the chosen landmark</source>
        <translation>Cambiar nombre, tipo o tamaño del punto de referencia elegido</translation>
    </message>
    <message>
        <source>&amp;Merge with…</source>
        <translation>&amp;Unir con…</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Unir</translation>
    </message>
    <message>
        <source>Make the chosen landmark and another one the same</source>
        <translation>Hacer uno solo del punto de referencia elegido y otro</translation>
    </message>
    <message>
        <source>&amp;Split…</source>
        <translation>&amp;Separar…</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Separar</translation>
    </message>
    <message>
        <source>Make the chosen views a landmark of their own</source>
        <translation>Hacer de las vistas elegidas un punto de referencia propio</translation>
    </message>
    <message>
        <source>Delete the chosen vie&amp;ws</source>
        <translation>E&amp;liminar las vistas elegidas</translation>
    </message>
    <message>
        <source>Delete views</source>
        <translation>Eliminar vistas</translation>
    </message>
    <message>
        <source>Forget the chosen views of the landmark</source>
        <translation>Olvidar las vistas elegidas del punto de referencia</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>El&amp;iminar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Forget the chosen landmark</source>
        <translation>Olvidar el punto de referencia elegido</translation>
    </message>
    <message>
        <source>&amp;Put on the map…</source>
        <translation>Poner en el &amp;mapa…</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>En el mapa</translation>
    </message>
    <message>
        <source>Put the chosen landmark on the map</source>
        <translation>Poner el punto de referencia elegido en el mapa</translation>
    </message>
    <message>
        <source>C&amp;heck all</source>
        <translation>Comprob&amp;ar todo</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Comprobar</translation>
    </message>
    <message>
        <source>Look how well each landmark is found and which are taken for each other</source>
        <translation>Mirar qué tal se encuentra cada punto de referencia y cuáles se confunden entre sí</translation>
    </message>
    <message>
        <source>Wal&amp;k with this library</source>
        <translation>Recorrer con es&amp;ta biblioteca</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Use this library on the Walk page</source>
        <translation>Usar esta biblioteca en la página Recorrido</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingPage</name>
    <message>
        <source>Open another &amp;library…</source>
        <translation>Abrir otra &amp;biblioteca…</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>No guardado: %1</translation>
    </message>
    <message>
        <source>Save el&amp;sewhere…</source>
        <translation>&amp;Guardar en otro sitio…</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Abrir una biblioteca de puntos de referencia</translation>
    </message>
    <message>
        <source>Landmark libraries (%1);;All files (%2)</source>
        <translation>Bibliotecas de puntos de referencia (%1);;Todos los archivos (%2)</translation>
    </message>
    <message>
        <source>New landmark library</source>
        <translation>Nueva biblioteca de puntos de referencia</translation>
    </message>
    <message>
        <source>Landmark libraries (%1)</source>
        <translation>Bibliotecas de puntos de referencia (%1)</translation>
    </message>
    <message>
        <source>Save the library as</source>
        <translation>Guardar la biblioteca como</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is unfinished, with %n view(s).</source>
        <translation>
            <numerusform>“%1” está sin terminar, con una vista.</numerusform>
            <numerusform>“%1” está sin terminar, con %n vistas.</numerusform>
        </translation>
    </message>
    <message>
        <source>A new landmark</source>
        <translation>Un nuevo punto de referencia</translation>
    </message>
    <message>
        <source>Go &amp;on with it</source>
        <translation>&amp;Seguir con él</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>Enseñar “%1”</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar el informe</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>Tabla (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>No se puede escribir %1. Elija otra carpeta.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Trabajando…</translation>
    </message>
    <message>
        <source>%1 · being saved</source>
        <translation>%1 · se está guardando</translation>
    </message>
    <message>
        <source>%1 · saved</source>
        <translation>%1 · guardado</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>Cambiar “%1”</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Merge landmarks</source>
        <translation>Unir puntos de referencia</translation>
    </message>
    <message>
        <source>The views of this landmark go to “%1”, and it is deleted:</source>
        <translation>Las vistas de este punto de referencia pasan a “%1”, y este se elimina:</translation>
    </message>
    <message>
        <source>Split the landmark</source>
        <translation>Separar el punto de referencia</translation>
    </message>
    <message numerus="yes">
        <source>Name of the landmark that the %n chosen view(s) become:</source>
        <translation>
            <numerusform>Nombre del punto de referencia en que se convierte la vista elegida:</numerusform>
            <numerusform>Nombre del punto de referencia en que se convierten las %n vistas elegidas:</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete views</source>
        <translation>Eliminar vistas</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>Eliminar “%1”</translation>
    </message>
    <message>
        <source>Not saved: another program has changed the same landmarks in %1. Save yours under another name; what the other program wrote stays.</source>
        <translation>No guardado: otro programa ha cambiado los mismos puntos de referencia en %1. Guarde los suyos con otro nombre; lo que escribió el otro programa se queda.</translation>
    </message>
    <message>
        <source>Another program has changed %1 meanwhile: its changes and yours are both saved. Earlier steps can no longer be undone.</source>
        <translation>Entretanto otro programa ha cambiado %1: sus cambios y los de usted están guardados. Los pasos anteriores ya no se pueden deshacer.</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Otro programa ha cambiado %1.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>&amp;Cargar de nuevo</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingWords</name>
    <message>
        <source>Too dark. Switch on a light.</source>
        <translation>Demasiado oscuro. Encienda una luz.</translation>
    </message>
    <message>
        <source>Too bright. Turn away from the window or the lamp.</source>
        <translation>Demasiada luz. Apártese de la ventana o de la lámpara.</translation>
    </message>
    <message>
        <source>Blurred. Hold the camera still, or wait until it is sharp.</source>
        <translation>Borroso. Mantenga quieta la cámara o espere a que se vea nítido.</translation>
    </message>
    <message>
        <source>Too small in the picture. Go nearer.</source>
        <translation>Demasiado pequeño en la imagen. Acérquese.</translation>
    </message>
    <message>
        <source>Too little detail inside the outline. Go nearer, or choose something with more detail.</source>
        <translation>Muy poco detalle dentro del contorno. Acérquese, o elija algo con más detalle.</translation>
    </message>
    <message>
        <source>The corners cross. Set them clockwise from the top left.</source>
        <translation>Las esquinas se cruzan. Póngalas en el sentido del reloj desde arriba a la izquierda.</translation>
    </message>
    <message>
        <source>Next: straight from the front, about 2 metres away.</source>
        <translation>Siguiente: de frente, a unos 2 metros.</translation>
    </message>
    <message>
        <source>Next: from farther away, about twice as far.</source>
        <translation>Siguiente: desde más lejos, cerca del doble.</translation>
    </message>
    <message>
        <source>Next: the same view from a step aside, or a step nearer.</source>
        <translation>Siguiente: la misma vista desde un paso al lado, o un paso más cerca.</translation>
    </message>
    <message>
        <source>These views are enough. More do no harm.</source>
        <translation>Estas vistas bastan. Más no hacen daño.</translation>
    </message>
    <message>
        <source>Found in %1 of its %2 views by the others.</source>
        <translation>Encontrado en %1 de sus %2 vistas por las demás.</translation>
    </message>
    <message>
        <source>Found from up to about %1 m (%2 pixels).</source>
        <translation>Encontrado hasta unos %1 m (%2 píxeles).</translation>
    </message>
    <message>
        <source>Found down to a size of %1 pixels in the picture; give its real size to learn how far that is.</source>
        <translation>Encontrado hasta un tamaño de %1 píxeles en la imagen; indique su tamaño real para saber a qué distancia es eso.</translation>
    </message>
    <message>
        <source>Never found when shown smaller or turned. Choose something with more detail.</source>
        <translation>Nunca encontrado más pequeño o girado. Elija algo con más detalle.</translation>
    </message>
    <message>
        <source>Taken for another: %1.</source>
        <translation>Se toma por otro: %1.</translation>
    </message>
    <message>
        <source>Others are taken for it: %1.</source>
        <translation>Otros se toman por él: %1.</translation>
    </message>
    <message>
        <source>Confused with none of the others.</source>
        <translation>No se confunde con ninguno de los otros.</translation>
    </message>
    <message>
        <source>confused with %1</source>
        <translation>se confunde con %1</translation>
    </message>
    <message>
        <source>hard to find</source>
        <translation>difícil de encontrar</translation>
    </message>
    <message>
        <source>found from near only</source>
        <translation>solo se encuentra de cerca</translation>
    </message>
    <message>
        <source>%1 of %2 views found again</source>
        <translation>%1 de %2 vistas encontradas de nuevo</translation>
    </message>
    <message>
        <source>one view only</source>
        <translation>una sola vista</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bueno</translation>
    </message>
    <message>
        <source>No view is straight from the front: add one, to learn from how far it is found.</source>
        <translation>Ninguna vista es de frente: añada una, para saber desde qué distancia se encuentra.</translation>
    </message>
    <message>
        <source>Next: from the left, at an angle.</source>
        <translation>Ahora: desde la izquierda, en ángulo.</translation>
    </message>
    <message>
        <source>Next: from the right, at an angle.</source>
        <translation>Ahora: desde la derecha, en ángulo.</translation>
    </message>
    <message>
        <source>There is only one view: add another, so that it can be tried.</source>
        <translation>Solo hay una vista: añada otra, para poder probarlo.</translation>
    </message>
    <message>
        <source>Found at angles of up to %1 degrees.</source>
        <translation>Se encuentra en ángulos de hasta %1 grados.</translation>
    </message>
    <message>
        <source>Not found at an angle. Add views from the left and the right.</source>
        <translation>No se encuentra en ángulo. Añada vistas desde la izquierda y la derecha.</translation>
    </message>
</context>
<context>
    <name>farol::ui::UtteranceLog</name>
    <message>
        <source>What is said cannot be written to %1: %2. Choose another file.</source>
        <translation>Lo que se dice no se puede escribir en %1: %2. Elija otro archivo.</translation>
    </message>
</context>
<context>
    <name>farol::ui::UtteranceModel</name>
    <message>
        <source>Caused by picture %1</source>
        <translation>Causado por la imagen %1</translation>
    </message>
    <message>
        <source>Shown as text, not heard</source>
        <translation>Mostrado como texto, no oído</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Sentence</source>
        <translation>Frase</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Because</source>
        <translation>Porque</translation>
    </message>
</context>
<context>
    <name>farol::ui::Voice</name>
    <message>
        <source>The voice &quot;%1&quot; is not installed. Choose another one in the settings.</source>
        <translation>La voz &quot;%1&quot; no está instalada. Elija otra en los ajustes.</translation>
    </message>
    <message>
        <source>The voice &quot;%1&quot; does not start: %2</source>
        <translation>La voz &quot;%1&quot; no arranca: %2</translation>
    </message>
    <message>
        <source>The voice &quot;%1&quot; does not speak this language. Choose another one in the settings.</source>
        <translation>La voz &quot;%1&quot; no habla este idioma. Elija otra en los ajustes.</translation>
    </message>
    <message>
        <source>No voice is installed.</source>
        <translation>No hay ninguna voz instalada.</translation>
    </message>
    <message>
        <source>There is no sound device. Connect headphones or a loudspeaker.</source>
        <translation>No hay dispositivo de sonido. Conecte unos auriculares o un altavoz.</translation>
    </message>
    <message>
        <source>The voice does not work. Choose another one in the settings.</source>
        <translation>La voz no funciona. Elija otra en los ajustes.</translation>
    </message>
</context>
<context>
    <name>farol::ui::VoteDetailModel</name>
    <message>
        <source>seen at %1</source>
        <translation>visto a las %1</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>filtro</translation>
    </message>
    <message>
        <source>speaks for it</source>
        <translation>habla a su favor</translation>
    </message>
    <message>
        <source>none of the objects last seen stands there</source>
        <translation>ninguno de los últimos objetos vistos está allí</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Término</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Significado</translation>
    </message>
</context>
<context>
    <name>farol::ui::VoteModel</name>
    <message numerus="yes">
        <source>%n matching object(s)</source>
        <translation>
            <numerusform>un objeto que encaja</numerusform>
            <numerusform>%n objetos que encajan</numerusform>
        </translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Votes</source>
        <translation>Votos</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Compuesto de</translation>
    </message>
</context>
<context>
    <name>farol::ui::Walk</name>
    <message numerus="yes">
        <source>%n remark(s) about the map: %1</source>
        <translation>
            <numerusform>una observación sobre el mapa: %1</numerusform>
            <numerusform>%n observaciones sobre el mapa: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Abriendo %1…</translation>
    </message>
    <message>
        <source>Loading…</source>
        <translation>Cargando…</translation>
    </message>
    <message>
        <source>Open a map first (Ctrl+O).</source>
        <translation>Abra primero un mapa (Ctrl+O).</translation>
    </message>
    <message>
        <source>Open a camera, a video or a folder of pictures first (Ctrl+P).</source>
        <translation>Abra primero una cámara, un vídeo o una carpeta de imágenes (Ctrl+P).</translation>
    </message>
    <message>
        <source>No trained landmarks: only doors and texts are recognised. Open a library of landmarks to recognise more.</source>
        <translation>No hay puntos de referencia entrenados: solo se reconocen puertas y textos. Abra una biblioteca de puntos de referencia para reconocer más.</translation>
    </message>
    <message>
        <source>the folder for recordings cannot be made; choose another one in the settings</source>
        <translation>no se puede crear la carpeta de las grabaciones; elija otra en los ajustes</translation>
    </message>
</context>
<context>
    <name>farol::ui::WelcomeDialog</name>
    <message>
        <source>Welcome to Farol</source>
        <translation>Bienvenido a Farol</translation>
    </message>
    <message>
        <source>Farol guides a blind person through a building with one camera. It needs a map of the building, and landmarks that it was taught. What do you want to do?</source>
        <translation>Farol guía a una persona ciega por un edificio con una cámara. Necesita un mapa del edificio y puntos de referencia que se le hayan enseñado. ¿Qué quiere hacer?</translation>
    </message>
    <message>
        <source>&amp;Guide somebody</source>
        <translation>&amp;Guiar a alguien</translation>
    </message>
    <message>
        <source>Open a map and a camera, and choose where to go</source>
        <translation>Abrir un mapa y una cámara, y elegir adónde ir</translation>
    </message>
    <message>
        <source>Work on a &amp;map</source>
        <translation>Trabajar en un &amp;mapa</translation>
    </message>
    <message>
        <source>Bring in a floor plan, check it, and put landmarks on it</source>
        <translation>Traer un plano, comprobarlo y ponerle puntos de referencia</translation>
    </message>
    <message>
        <source>Teach &amp;landmarks</source>
        <translation>Enseñar &amp;puntos de referencia</translation>
    </message>
    <message>
        <source>Photograph what Farol shall know again</source>
        <translation>Fotografiar lo que Farol debe reconocer</translation>
    </message>
    <message>
        <source>Read the &amp;help</source>
        <translation>Leer la a&amp;yuda</translation>
    </message>
    <message>
        <source>What each page is for, and its keys; F1 at any time</source>
        <translation>Para qué es cada página y sus teclas; F1 en cualquier momento</translation>
    </message>
    <message>
        <source>For a blind user who is alone, start “farol --kiosk”: full screen, by keys and speech.</source>
        <translation>Para un usuario ciego que está solo, inicie “farol --kiosk”: pantalla completa, con teclas y voz.</translation>
    </message>
</context>
<context>
    <name>farol::ui::WindowActions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Walk</source>
        <translation>&amp;Recorrido</translation>
    </message>
    <message>
        <source>V&amp;oice</source>
        <translation>V&amp;oz</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>R&amp;ecent maps</source>
        <translation>Mapas r&amp;ecientes</translation>
    </message>
    <message>
        <source>Recent landmark li&amp;braries</source>
        <translation>Bi&amp;bliotecas recientes</translation>
    </message>
    <message>
        <source>Recent pi&amp;ctures</source>
        <translation>Imá&amp;genes recientes</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>&amp;Abrir mapa…</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Open the map of a building</source>
        <translation>Abrir el mapa de un edificio</translation>
    </message>
    <message>
        <source>Open landmark &amp;library…</source>
        <translation>Abrir b&amp;iblioteca de puntos de referencia…</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <source>Open the landmarks that Farol was taught</source>
        <translation>Abrir los puntos de referencia que se enseñaron a Farol</translation>
    </message>
    <message>
        <source>&amp;Close landmark library</source>
        <translation>&amp;Cerrar biblioteca</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Walk without taught landmarks</source>
        <translation>Recorrer sin puntos de referencia enseñados</translation>
    </message>
    <message>
        <source>Open &amp;pictures…</source>
        <translation>Abrir im&amp;ágenes…</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Choose a camera, a video, a folder or an address</source>
        <translation>Elegir una cámara, un vídeo, una carpeta o una dirección</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>A&amp;justes…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Language, voice and what is told</source>
        <translation>Idioma, voz y lo que se dice</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Leave Farol</source>
        <translation>Salir de Farol</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>Re&amp;producir</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Hold the walk</source>
        <translation>Detener un momento el recorrido</translation>
    </message>
    <message>
        <source>Start the walk, or go on</source>
        <translation>Empezar el recorrido, o continuar</translation>
    </message>
    <message>
        <source>&amp;One picture</source>
        <translation>&amp;Una imagen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Go on by one picture, then hold</source>
        <translation>Avanzar una imagen y parar</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>Terminar el recorrido</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>&amp;Más rápido</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Más rápido</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>Reproducir más rápido</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>Más &amp;lento</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Más lento</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>Reproducir más despacio</translation>
    </message>
    <message>
        <source>Choose &amp;destination</source>
        <translation>Elegir d&amp;estino</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destino</translation>
    </message>
    <message>
        <source>Choose where to go</source>
        <translation>Elegir adónde ir</translation>
    </message>
    <message>
        <source>&amp;No destination</source>
        <translation>&amp;Sin destino</translation>
    </message>
    <message>
        <source>No destination</source>
        <translation>Sin destino</translation>
    </message>
    <message>
        <source>Give up the destination</source>
        <translation>Renunciar al destino</translation>
    </message>
    <message>
        <source>Choose st&amp;art</source>
        <translation>Elegir ini&amp;cio</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Say where the walk starts</source>
        <translation>Decir dónde empieza el recorrido</translation>
    </message>
    <message>
        <source>&amp;Record the walk</source>
        <translation>&amp;Grabar el recorrido</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Keep the next walk in a folder, to be replayed</source>
        <translation>Guardar el próximo recorrido en una carpeta, para reproducirlo</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Repetir</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Say the last instruction again</source>
        <translation>Decir otra vez la última instrucción</translation>
    </message>
    <message>
        <source>Voice o&amp;ff</source>
        <translation>&amp;Voz desactivada</translation>
    </message>
    <message>
        <source>Voice off</source>
        <translation>Voz desactivada</translation>
    </message>
    <message>
        <source>Show sentences without speaking them</source>
        <translation>Mostrar las frases sin decirlas</translation>
    </message>
    <message>
        <source>Wal&amp;k page</source>
        <translation>Página &amp;Recorrido</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Watch a walk</source>
        <translation>Observar un recorrido</translation>
    </message>
    <message>
        <source>&amp;Map page</source>
        <translation>Página &amp;Mapa</translation>
    </message>
    <message>
        <source>Look at the map of a building, check it and change it</source>
        <translation>Ver el mapa de un edificio, comprobarlo y cambiarlo</translation>
    </message>
    <message>
        <source>&amp;Whole floor</source>
        <translation>&amp;Toda la planta</translation>
    </message>
    <message>
        <source>Whole floor</source>
        <translation>Toda la planta</translation>
    </message>
    <message>
        <source>Show the whole floor</source>
        <translation>Mostrar toda la planta</translation>
    </message>
    <message>
        <source>&amp;Larger map</source>
        <translation>Mapa más &amp;grande</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Más grande</translation>
    </message>
    <message>
        <source>Show the map larger</source>
        <translation>Mostrar el mapa más grande</translation>
    </message>
    <message>
        <source>&amp;Smaller map</source>
        <translation>Mapa más p&amp;equeño</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Más pequeño</translation>
    </message>
    <message>
        <source>Show the map smaller</source>
        <translation>Mostrar el mapa más pequeño</translation>
    </message>
    <message>
        <source>&amp;Follow to other floors</source>
        <translation>&amp;Seguir a otras plantas</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Switch to the floor where you are</source>
        <translation>Pasar a la planta donde usted está</translation>
    </message>
    <message>
        <source>&amp;Grid over the picture</source>
        <translation>&amp;Cuadrícula sobre la imagen</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source>Show the nine parts of the picture</source>
        <translation>Mostrar las nueve partes de la imagen</translation>
    </message>
    <message>
        <source>&amp;What was not accepted</source>
        <translation>Lo &amp;no aceptado</translation>
    </message>
    <message>
        <source>Not accepted</source>
        <translation>No aceptado</translation>
    </message>
    <message>
        <source>Show what was nearly recognised, and why not</source>
        <translation>Mostrar lo que casi se reconoció, y por qué no</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>S&amp;iguiente parte de la ventana</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Go to the next part of the window</source>
        <translation>Ir a la siguiente parte de la ventana</translation>
    </message>
    <message>
        <source>&amp;Previous part of the window</source>
        <translation>Parte &amp;anterior de la ventana</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Go to the previous part of the window</source>
        <translation>Ir a la parte anterior de la ventana</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Teclas</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Every key of this window</source>
        <translation>Todas las teclas de esta ventana</translation>
    </message>
    <message>
        <source>&amp;About Farol</source>
        <translation>&amp;Acerca de Farol</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Acerca de</translation>
    </message>
    <message>
        <source>What Farol is</source>
        <translation>Qué es Farol</translation>
    </message>
    <message>
        <source>&amp;Speed:</source>
        <translation>&amp;Velocidad:</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>How fast pictures from files are played</source>
        <translation>A qué velocidad se reproducen las imágenes de archivos</translation>
    </message>
    <message>
        <source>Landmark&amp;s page</source>
        <translation>Página P&amp;untos de referencia</translation>
    </message>
    <message>
        <source>Teach Farol landmarks, check them and change them</source>
        <translation>Enseñar a Farol puntos de referencia, comprobarlos y cambiarlos</translation>
    </message>
    <message>
        <source>The user is &amp;here</source>
        <translation>El usuario está a&amp;quí</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Aquí</translation>
    </message>
    <message>
        <source>The user is in the place that is chosen on the map or in the list</source>
        <translation>El usuario está en el lugar elegido en el mapa o en la lista</translation>
    </message>
    <message>
        <source>That is &amp;wrong</source>
        <translation>Está equi&amp;vocado</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Mal</translation>
    </message>
    <message>
        <source>The place shown is wrong: look for it anew</source>
        <translation>El lugar mostrado es incorrecto: buscarlo de nuevo</translation>
    </message>
    <message>
        <source>&amp;Work out a recorded walk anew…</source>
        <translation>Calcul&amp;ar de nuevo un recorrido grabado…</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>De nuevo</translation>
    </message>
    <message>
        <source>Compare a recorded walk with the same walk worked out otherwise</source>
        <translation>Comparar un recorrido grabado con el mismo calculado de otro modo</translation>
    </message>
    <message>
        <source>&amp;Say this…</source>
        <translation>Decir es&amp;to…</translation>
    </message>
    <message>
        <source>Say</source>
        <translation>Decir</translation>
    </message>
    <message>
        <source>Type a sentence that is spoken to the user</source>
        <translation>Escribir una frase que se dice al usuario</translation>
    </message>
    <message>
        <source>Sa&amp;ve the picture…</source>
        <translation>Guardar la &amp;imagen…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Save what the camera sees, with what was recognised</source>
        <translation>Guardar lo que ve la cámara, con lo reconocido</translation>
    </message>
    <message>
        <source>Save the walk as &amp;table…</source>
        <translation>Guardar el recorrido como ta&amp;bla…</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <source>Save times, places and sentences of this walk for a spreadsheet</source>
        <translation>Guardar horas, lugares y frases de este recorrido para una hoja de cálculo</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>How the page that is shown is used</source>
        <translation>Cómo se usa la página que se muestra</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Bienvenida</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenida</translation>
    </message>
    <message>
        <source>The page of the first start</source>
        <translation>La página del primer inicio</translation>
    </message>
    <message>
        <source>Fi&amp;gures…</source>
        <translation>&amp;Gráficos…</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Charts of the votes, of the time that pictures took, and of how far landmarks are found</source>
        <translation>Gráficos de los votos, del tiempo que tardaron las imágenes y de la distancia a que se encuentran los puntos de referencia</translation>
    </message>
</context>
<context>
    <name>farol::ui::Words</name>
    <message>
        <source>room</source>
        <translation>sala</translation>
    </message>
    <message>
        <source>corridor</source>
        <translation>pasillo</translation>
    </message>
    <message>
        <source>hall</source>
        <translation>vestíbulo</translation>
    </message>
    <message>
        <source>stairwell</source>
        <translation>caja de escaleras</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>ascensor</translation>
    </message>
    <message>
        <source>toilet</source>
        <translation>aseo</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>exterior</translation>
    </message>
    <message>
        <source>place</source>
        <translation>lugar</translation>
    </message>
    <message>
        <source>door</source>
        <translation>puerta</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>abertura</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>escaleras</translation>
    </message>
    <message>
        <source>escalator</source>
        <translation>escalera mecánica</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampa</translation>
    </message>
    <message>
        <source>window</source>
        <translation>ventana</translation>
    </message>
    <message>
        <source>passage</source>
        <translation>paso</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>planta %1</translation>
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
        <translation>%1 entre %2 y %3</translation>
    </message>
    <message>
        <source>%1 (closed)</source>
        <translation>%1 (cerrado)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, in %3</source>
        <translation>%1: %2, en %3</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en espera</translation>
    </message>
    <message>
        <source>speaking</source>
        <translation>hablando</translation>
    </message>
    <message>
        <source>spoken</source>
        <translation>dicho</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrumpido</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>demasiado tarde</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>mostrado</translation>
    </message>
    <message>
        <source>new route</source>
        <translation>nueva ruta</translation>
    </message>
    <message>
        <source>coming up</source>
        <translation>se acerca</translation>
    </message>
    <message>
        <source>do it now</source>
        <translation>hágalo ahora</translation>
    </message>
    <message>
        <source>keep going</source>
        <translation>continúe</translation>
    </message>
    <message>
        <source>arrived</source>
        <translation>llegada</translation>
    </message>
    <message>
        <source>left the route</source>
        <translation>ha dejado la ruta</translation>
    </message>
    <message>
        <source>place not known</source>
        <translation>lugar desconocido</translation>
    </message>
    <message>
        <source>place found</source>
        <translation>lugar encontrado</translation>
    </message>
    <message>
        <source>object seen</source>
        <translation>objeto visto</translation>
    </message>
    <message>
        <source>text read</source>
        <translation>texto leído</translation>
    </message>
    <message>
        <source>no route</source>
        <translation>sin ruta</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>ya en el destino</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>pedido</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>aviso</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>seguro</translation>
    </message>
    <message>
        <source>fairly sure</source>
        <translation>bastante seguro</translation>
    </message>
    <message>
        <source>not sure</source>
        <translation>no seguro</translation>
    </message>
    <message>
        <source>too few points fit</source>
        <translation>encajan muy pocos puntos</translation>
    </message>
    <message>
        <source>outline folded</source>
        <translation>contorno plegado</translation>
    </message>
    <message>
        <source>looks too different</source>
        <translation>se ve demasiado distinto</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>objetos</translation>
    </message>
    <message>
        <source>best object</source>
        <translation>mejor objeto</translation>
    </message>
    <message>
        <source>near the last place</source>
        <translation>cerca del último lugar</translation>
    </message>
    <message>
        <source>on the way</source>
        <translation>por el camino</translation>
    </message>
    <message>
        <source>seen together</source>
        <translation>vistos juntos</translation>
    </message>
    <message>
        <source>weight of the place</source>
        <translation>peso del lugar</translation>
    </message>
    <message>
        <source>share seen here</source>
        <translation>parte vista aquí</translation>
    </message>
    <message>
        <source>share seen next door</source>
        <translation>parte vista al lado</translation>
    </message>
    <message>
        <source>vote</source>
        <translation>voto</translation>
    </message>
    <message>
        <source>does not reach the floor</source>
        <translation>no llega al suelo</translation>
    </message>
    <message>
        <source>two places look alike</source>
        <translation>dos lugares se parecen</translation>
    </message>
    <message>
        <source>part of the number may be hidden</source>
        <translation>parte del número puede estar oculta</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>borroso</translation>
    </message>
    <message>
        <source>too many lines for a door</source>
        <translation>demasiadas líneas para una puerta</translation>
    </message>
    <message>
        <source>looked at again, it was something else</source>
        <translation>mirado de nuevo, era otra cosa</translation>
    </message>
    <message>
        <source>the scene changed</source>
        <translation>la escena cambió</translation>
    </message>
    <message>
        <source>lines evenly apart, as of a shelf</source>
        <translation>líneas a igual distancia, como de una estantería</translation>
    </message>
    <message>
        <source>too few step edges</source>
        <translation>muy pocos bordes de escalón</translation>
    </message>
    <message>
        <source>lines, but no steps</source>
        <translation>líneas, pero no escalones</translation>
    </message>
    <message>
        <source>lines apart as of floor tiles</source>
        <translation>líneas separadas como de baldosas</translation>
    </message>
    <message>
        <source>pictures too far apart to follow it</source>
        <translation>imágenes demasiado separadas para seguirlo</translation>
    </message>
    <message>
        <source>a grid, as of tiles or windows</source>
        <translation>una cuadrícula, como de baldosas o ventanas</translation>
    </message>
    <message>
        <source>too high for steps</source>
        <translation>demasiado alto para escaleras</translation>
    </message>
    <message>
        <source>impossible size</source>
        <translation>tamaño imposible</translation>
    </message>
    <message>
        <source>does not move as one thing</source>
        <translation>no se mueve como una sola cosa</translation>
    </message>
    <message>
        <source>its sides go on above it</source>
        <translation>sus lados siguen por encima</translation>
    </message>
    <message>
        <source>of a kind that is not looked for</source>
        <translation>de un tipo que no se busca</translation>
    </message>
    <message>
        <source>told by its trained look instead</source>
        <translation>reconocido por su aspecto entrenado</translation>
    </message>
    <message>
        <source>left the picture</source>
        <translation>salió de la imagen</translation>
    </message>
    <message>
        <source>a line goes across it</source>
        <translation>una línea lo atraviesa</translation>
    </message>
    <message>
        <source>a line goes up its middle</source>
        <translation>una línea sube por el medio</translation>
    </message>
    <message>
        <source>a stroke rather than a letter</source>
        <translation>un trazo más que una letra</translation>
    </message>
    <message>
        <source>looks different now</source>
        <translation>ahora se ve distinto</translation>
    </message>
    <message>
        <source>a letter was missed</source>
        <translation>faltó una letra</translation>
    </message>
    <message>
        <source>a point was missed</source>
        <translation>faltó un punto</translation>
    </message>
    <message>
        <source>a space was missed</source>
        <translation>faltó un espacio</translation>
    </message>
    <message>
        <source>reading not sure</source>
        <translation>lectura insegura</translation>
    </message>
    <message>
        <source>too pale</source>
        <translation>demasiado pálido</translation>
    </message>
    <message>
        <source>too low for stairs</source>
        <translation>demasiado bajo para escaleras</translation>
    </message>
    <message>
        <source>not sure enough</source>
        <translation>no bastante seguro</translation>
    </message>
    <message>
        <source>seen as in a mirror</source>
        <translation>visto como en un espejo</translation>
    </message>
    <message>
        <source>too narrow</source>
        <translation>demasiado estrecho</translation>
    </message>
    <message>
        <source>only a small part fits</source>
        <translation>solo encaja una parte pequeña</translation>
    </message>
    <message>
        <source>the points fit no outline</source>
        <translation>los puntos no encajan en ningún contorno</translation>
    </message>
    <message>
        <source>no letters</source>
        <translation>sin letras</translation>
    </message>
    <message>
        <source>readings do not agree yet</source>
        <translation>las lecturas aún no coinciden</translation>
    </message>
    <message>
        <source>outline without numbers</source>
        <translation>contorno sin números</translation>
    </message>
    <message>
        <source>mostly outside the picture</source>
        <translation>en su mayor parte fuera de la imagen</translation>
    </message>
    <message>
        <source>lost from sight</source>
        <translation>perdido de vista</translation>
    </message>
    <message>
        <source>seen only once so far</source>
        <translation>visto solo una vez hasta ahora</translation>
    </message>
    <message>
        <source>only a sliver</source>
        <translation>solo una franja</translation>
    </message>
    <message>
        <source>too few letters</source>
        <translation>muy pocas letras</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>demasiado pequeño</translation>
    </message>
    <message>
        <source>not seen again</source>
        <translation>no visto de nuevo</translation>
    </message>
    <message>
        <source>step edges of uneven contrast</source>
        <translation>bordes de escalón de contraste desigual</translation>
    </message>
    <message>
        <source>step edges unevenly apart</source>
        <translation>bordes de escalón a distancias desiguales</translation>
    </message>
    <message>
        <source>read differently each time</source>
        <translation>leído cada vez de otro modo</translation>
    </message>
    <message>
        <source>no top of a door frame</source>
        <translation>sin parte superior de un marco de puerta</translation>
    </message>
    <message>
        <source>wider above than below</source>
        <translation>más ancho arriba que abajo</translation>
    </message>
    <message>
        <source>in the way of walking</source>
        <translation>en la dirección de la marcha</translation>
    </message>
    <message>
        <source>on your level</source>
        <translation>en su planta</translation>
    </message>
    <message>
        <source>matching objects</source>
        <translation>objetos que encajan</translation>
    </message>
    <message>
        <source>matching objects next door</source>
        <translation>objetos que encajan al lado</translation>
    </message>
    <message>
        <source>objects seen</source>
        <translation>objetos vistos</translation>
    </message>
    <message>
        <source>share of the likelihood</source>
        <translation>parte de la verosimilitud</translation>
    </message>
    <message>
        <source>could be anywhere</source>
        <translation>podría estar en cualquier parte</translation>
    </message>
    <message>
        <source>evidence against all of this</source>
        <translation>indicios contra todo esto</translation>
    </message>
    <message>
        <source>a likeness within one already found</source>
        <translation>un parecido dentro de otro ya encontrado</translation>
    </message>
</context>
</TS>
