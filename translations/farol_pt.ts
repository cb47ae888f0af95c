<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_PT" sourcelanguage="en">
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
        <translation>&amp;Sim</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Não</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Não guardar</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ajuda</translation>
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
        <translation>Shift</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Seta para cima</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Seta para baixo</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Seta para a esquerda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Seta para a direita</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espaço</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message numerus="yes">
        <source>%n features have no id; give each its own</source>
        <translation>
            <numerusform>%n elemento não tem identificador; dê-lhe um próprio</numerusform>
            <numerusform>%n elementos não têm identificador; dê a cada um o seu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features share the id &quot;%1&quot;; give each its own</source>
        <translation>
            <numerusform>%n elemento tem o identificador “%1”; dê a cada um o seu</numerusform>
            <numerusform>%n elementos têm o mesmo identificador “%1”; dê a cada um o seu</numerusform>
        </translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has fewer than three corners; draw it again</source>
        <translation>o contorno do espaço “%1” tem menos de três cantos; desenhe-o de novo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a coordinate that is no number; draw it again</source>
        <translation>o contorno do espaço “%1” tem uma coordenada que não é um número; desenhe-o de novo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has no area; draw it again</source>
        <translation>o contorno do espaço “%1” não tem área; desenhe-o de novo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; crosses itself; draw it again</source>
        <translation>o contorno do espaço “%1” cruza-se a si próprio; desenhe-o de novo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has fewer than three corners; draw it again</source>
        <translation>o contorno do espaço “%1” tem um buraco com menos de três cantos; desenhe-o de novo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has a coordinate that is no number; draw it again</source>
        <translation>o contorno do espaço “%1” tem um buraco com uma coordenada que não é um número; desenhe-o de novo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that has no area; draw it again</source>
        <translation>o contorno do espaço “%1” tem um buraco sem área; desenhe-o de novo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that crosses itself; draw it again</source>
        <translation>o contorno do espaço “%1” tem um buraco que se cruza a si próprio; desenhe-o de novo</translation>
    </message>
    <message>
        <source>the outline of region &quot;%1&quot; has a hole that lies outside it; draw it again</source>
        <translation>o contorno do espaço “%1” tem um buraco que fica fora dele; desenhe-o de novo</translation>
    </message>
    <message numerus="yes">
        <source>%n regions have neither name nor ref: only its kind is spoken</source>
        <translation>
            <numerusform>%n espaço não tem nome nem número: só se diz o seu tipo</numerusform>
            <numerusform>%n espaços não têm nome nem número: só se diz o seu tipo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions are called &quot;%1&quot; or the like, which is never spoken; give it the name that people use</source>
        <translation>
            <numerusform>%n espaço chama-se “%1”, o que nunca é dito; dê-lhe o nome que as pessoas usam</numerusform>
            <numerusform>%n espaços chamam-se “%1” ou coisa parecida, o que nunca é dito; dê-lhes o nome que as pessoas usam</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>level %1 is used by %n regions but is not in the layer levels: its name cannot be spoken; add it</source>
        <translation>
            <numerusform>o piso %1 é usado por %n espaço mas não está na lista de pisos (levels): o seu nome não pode ser dito; junte-o</numerusform>
            <numerusform>o piso %1 é usado por %n espaços mas não está na lista de pisos (levels): o seu nome não pode ser dito; junte-o</numerusform>
        </translation>
    </message>
    <message>
        <source>access &quot;%1&quot; names the region &quot;%2&quot;, which does not exist; correct it</source>
        <translation>a passagem “%1” indica o espaço “%2”, que não existe; corrija-o</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; lies more than 1 m from region &quot;%2&quot;; move it to the border</source>
        <translation>a passagem “%1” fica a mais de 1&#xa0;m do espaço “%2”; mova-a para a fronteira</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; has the same region on both sides: no route passes it; set region_a and region_b, or move it to a border</source>
        <translation>a passagem “%1” tem o mesmo espaço dos dois lados: nenhum caminho passa por ela; indique o espaço de cada lado (region_a e region_b) ou mova-a para uma fronteira</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; does not join two regions: no route passes it; set region_a and region_b, or move it to a border</source>
        <translation>a passagem “%1” não liga dois espaços: nenhum caminho passa por ela; indique o espaço de cada lado (region_a e region_b) ou mova-a para uma fronteira</translation>
    </message>
    <message>
        <source>access &quot;%1&quot; is no stairs, lift, escalator or ramp but joins regions of levels %2 and %3; correct its kind or regions</source>
        <translation>a passagem “%1” não é escada, elevador, escada rolante nem rampa, mas liga espaços dos pisos %2 e %3; corrija o seu tipo ou os espaços</translation>
    </message>
    <message numerus="yes">
        <source>%n accesses are drawn on more than two regions: see that region_a and region_b are the right ones</source>
        <translation>
            <numerusform>%n passagem está desenhada em mais de dois espaços: veja se os dois lados (region_a e region_b) são os certos</numerusform>
            <numerusform>%n passagens estão desenhadas em mais de dois espaços: veja se os dois lados (region_a e region_b) são os certos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n escalators have no direction and count as running both ways: set oneway</source>
        <translation>
            <numerusform>%n escada rolante não tem sentido e conta como se andasse nos dois: indique-o (oneway)</numerusform>
            <numerusform>%n escadas rolantes não têm sentido e contam como se andassem nos dois: indique-o (oneway)</numerusform>
        </translation>
    </message>
    <message>
        <source>shaft &quot;%1&quot; passes level %2 without an access there; add it, unless it does not stop there</source>
        <translation>a escada ou o elevador “%1” passa pelo piso %2 sem lá ter passagem; junte-a, a não ser que não pare ali</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; belongs to no region; set region_id</source>
        <translation>o ponto de referência “%1” não pertence a nenhum espaço; indique-o (region_id)</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; names the region &quot;%2&quot;, which does not exist; correct it</source>
        <translation>o ponto de referência “%1” indica o espaço “%2”, que não existe; corrija-o</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; is on level %2, its region &quot;%3&quot; on level %4</source>
        <translation>o ponto de referência “%1” está no piso %2, e o seu espaço “%3” no piso %4</translation>
    </message>
    <message>
        <source>landmark &quot;%1&quot; lies more than 0.5 m outside its region &quot;%2&quot;; move it or correct region_id</source>
        <translation>o ponto de referência “%1” fica mais de 0,5&#xa0;m fora do seu espaço “%2”; mova-o ou corrija o espaço (region_id)</translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2</source>
        <translation>
            <numerusform>%n elemento tem o tipo desconhecido “%1”; conhecem-se, e entre parênteses como se escrevem no mapa: %2</numerusform>
            <numerusform>%n elementos têm o tipo desconhecido “%1”; conhecem-se, e entre parênteses como se escrevem no mapa: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n features have the unknown kind &quot;%1&quot;; known are %2 (nobody is led through other)</source>
        <translation>
            <numerusform>%n elemento tem o tipo desconhecido “%1”; conhecem-se, e entre parênteses como se escrevem no mapa: %2 (por “other” ninguém é levado)</numerusform>
            <numerusform>%n elementos têm o tipo desconhecido “%1”; conhecem-se, e entre parênteses como se escrevem no mapa: %2 (por “other” ninguém é levado)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the building falls into %1 parts; %n regions cannot be reached from the largest (%2): accesses are missing or closed</source>
        <translation>
            <numerusform>o edifício divide-se em %1 partes; %n espaço não se alcança a partir da maior (%2): faltam passagens ou estão fechadas</numerusform>
            <numerusform>o edifício divide-se em %1 partes; %n espaços não se alcançam a partir da maior (%2): faltam passagens ou estão fechadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>%n espaço</numerusform>
            <numerusform>%n espaços</numerusform>
        </translation>
    </message>
    <message>
        <source>region &quot;%1&quot; is a sliver, about %2 m wide: nobody stands there; join it to its neighbour</source>
        <translation>o espaço “%1” é uma tira com cerca de %2&#xa0;m de largura: ninguém lá cabe; junte-o ao vizinho</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot; have the same outline; remove one</source>
        <translation>os espaços “%1” e “%2” têm o mesmo contorno; retire um</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot;: the smaller lies inside the larger; cut it out of the larger one, unless it is a part of it</source>
        <translation>espaços “%1” e “%2”: o menor fica dentro do maior; recorte-o do maior, a não ser que faça parte dele</translation>
    </message>
    <message>
        <source>regions &quot;%1&quot; and &quot;%2&quot; overlap by %3 % of the smaller; draw the border between them</source>
        <translation>os espaços “%1” e “%2” sobrepõem-se em %3&#xa0;% do menor; desenhe a fronteira entre eles</translation>
    </message>
    <message>
        <source>so many regions overlap that not all pairs were compared; are all levels drawn on one?</source>
        <translation>há tantos espaços que se sobrepõem que nem todos os pares foram comparados; estarão todos os pisos desenhados num só?</translation>
    </message>
    <message numerus="yes">
        <source>%n regions of level %1 have the ref &quot;%2&quot;: people are led to the wrong one; correct it</source>
        <translation>
            <numerusform>%n espaço do piso %1 tem o número “%2”: as pessoas são levadas ao errado; corrija-o</numerusform>
            <numerusform>%n espaços do piso %1 têm o número “%2”: as pessoas são levadas ao errado; corrija-o</numerusform>
        </translation>
    </message>
    <message>
        <source>the whole building is smaller than 0.3 m: its coordinates are degrees, not metres; import or reproject it</source>
        <translation>todo o edifício tem menos de 0,3&#xa0;m: as suas coordenadas são graus, não metros; importe-o ou reprojete-o</translation>
    </message>
    <message numerus="yes">
        <source>%n regions have no door or other access that joins another region: nobody can be led there; add it</source>
        <translation>
            <numerusform>%n espaço não tem porta nem outra passagem para outro espaço: ninguém pode ser levado lá; junte-a</numerusform>
            <numerusform>%n espaços não têm porta nem outra passagem para outro espaço: ninguém pode ser levado lá; junte-a</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n regions have a door drawn on the border, but the door joins two others and nothing leads there: correct region_a or region_b, or draw another door</source>
        <translation>
            <numerusform>%n espaço tem uma porta desenhada na fronteira, mas ela liga outros dois e nada leva lá: corrija um dos lados (region_a ou region_b) ou desenhe outra porta</numerusform>
            <numerusform>%n espaços têm uma porta desenhada na fronteira, mas ela liga outros dois e nada leva lá: corrija um dos lados (region_a ou region_b) ou desenhe outra porta</numerusform>
        </translation>
    </message>
    <message>
        <source>features had no id and were given one</source>
        <translation>havia elementos sem identificador, que receberam um</translation>
    </message>
    <message>
        <source>features shared an id and were given another</source>
        <translation>havia elementos com o mesmo identificador, que receberam outro</translation>
    </message>
    <message>
        <source>outlines have corners that are no places; these were left out</source>
        <translation>há contornos com cantos que não são lugares; esses foram deixados de fora</translation>
    </message>
    <message>
        <source>outlines have fewer than three corners; the regions were left out</source>
        <translation>há contornos com menos de três cantos; esses espaços foram deixados de fora</translation>
    </message>
    <message>
        <source>outlines have more than 200,000 corners; the regions were left out</source>
        <translation>há contornos com mais de 200&#xa0;000 cantos; esses espaços foram deixados de fora</translation>
    </message>
    <message>
        <source>outlines enclose no area; the regions were left out</source>
        <translation>há contornos que não encerram nenhuma área; esses espaços foram deixados de fora</translation>
    </message>
    <message>
        <source>outlines crossed or touched themselves and were mended: compare them with the plan</source>
        <translation>havia contornos que se cruzavam ou tocavam a si próprios e foram corrigidos: compare-os com a planta</translation>
    </message>
    <message>
        <source>regions fell into several parts: each part is a region of its own</source>
        <translation>havia espaços em várias partes: cada parte é agora um espaço próprio</translation>
    </message>
    <message>
        <source>regions repeat the outline of another one on their level and were merged with it</source>
        <translation>há espaços que repetem o contorno de outro do mesmo piso e foram unidos a ele</translation>
    </message>
    <message>
        <source>accesses have points that are no places; these were left out</source>
        <translation>há passagens com pontos que não são lugares; esses foram deixados de fora</translation>
    </message>
    <message>
        <source>accesses have no place on the map and were left out</source>
        <translation>há passagens sem lugar no mapa, que foram deixadas de fora</translation>
    </message>
    <message>
        <source>landmarks have no place on the map and were left out</source>
        <translation>há pontos de referência sem lugar no mapa, que foram deixados de fora</translation>
    </message>
    <message>
        <source>levels are no floors of a building; level 0 is assumed</source>
        <translation>há pisos que não são pisos de um edifício; supõe-se o piso 0</translation>
    </message>
    <message>
        <source>levels stand twice in the source; the first name is kept</source>
        <translation>há pisos que aparecem duas vezes na origem; fica o primeiro nome</translation>
    </message>
    <message>
        <source>regions had no name and were given one from kind and number, such as &quot;Corridor 3&quot;: rename them</source>
        <translation>havia espaços sem nome, que receberam um feito do tipo e de um número, como “Corridor 3”: dê-lhes outro</translation>
    </message>
    <message>
        <source>landmarks lie outside every region and were given to the nearest one</source>
        <translation>há pontos de referência fora de todos os espaços, que ficaram no mais próximo</translation>
    </message>
    <message>
        <source>openings were added where regions meet without a wall between them</source>
        <translation>foram postas aberturas onde há espaços que se tocam sem parede entre eles</translation>
    </message>
    <message>
        <source>accesses are drawn on fewer than two regions</source>
        <translation>há passagens desenhadas em menos de dois espaços</translation>
    </message>
    <message>
        <source>accesses lie beside more than two regions; the two with the widest border were taken: see that they are right</source>
        <translation>há passagens junto a mais de dois espaços; foram tomados os dois com a fronteira mais larga: veja se são os certos</translation>
    </message>
    <message>
        <source>accesses run from one region to another and along no border: if one walks along the line, set region_a and region_b</source>
        <translation>há passagens que vão de um espaço a outro e não seguem nenhuma fronteira: se se anda ao longo da linha, indique o espaço de cada lado (region_a e region_b)</translation>
    </message>
    <message>
        <source>stairs, lifts or escalators lead to a level that nothing names: set region_b, or give them and their other end the same shaft</source>
        <translation>há escadas, elevadores ou escadas rolantes que levam a um piso que nada indica: indique o espaço do outro lado (region_b), ou dê-lhes a mesma caixa (shaft) que à outra ponta</translation>
    </message>
    <message>
        <source>upper ends of stairs, lifts or escalators were left out: their lower ends lead there already</source>
        <translation>foram deixadas de fora pontas de cima de escadas, elevadores ou escadas rolantes: as de baixo já levam lá</translation>
    </message>
    <message>
        <source>links between levels name regions that do not exist</source>
        <translation>há ligações entre pisos que indicam espaços que não existem</translation>
    </message>
    <message>
        <source>stairs, lifts or escalators were joined with the ones above them, because their outlines overlap</source>
        <translation>foram ligadas escadas, elevadores ou escadas rolantes às que estão por cima, porque os contornos se sobrepõem</translation>
    </message>
    <message>
        <source>the coordinate reference system of the source cannot be understood</source>
        <translation>não se entende o sistema de coordenadas da origem</translation>
    </message>
    <message>
        <source>the source names a CRS in metres, but its coordinates are degrees: they are taken as WGS 84</source>
        <translation>a origem indica um sistema de coordenadas em metros, mas as suas coordenadas são graus: são tomadas como WGS 84</translation>
    </message>
    <message>
        <source>the source names no CRS; its coordinates look like degrees and are taken as WGS 84</source>
        <translation>a origem não indica o sistema de coordenadas; elas parecem graus e são tomadas como WGS 84</translation>
    </message>
    <message>
        <source>the source names a CRS in degrees, but its coordinates are not: they are taken as metres of a local plane</source>
        <translation>a origem indica um sistema de coordenadas em graus, mas as suas coordenadas não o são: são tomadas como metros de um plano local</translation>
    </message>
    <message>
        <source>the source names no CRS: its coordinates are taken as metres of a local plane; name the CRS if there is one</source>
        <translation>a origem não indica o sistema de coordenadas: são tomadas como metros de um plano local; indique o sistema, se houver</translation>
    </message>
    <message>
        <source>north and east stand in each other&apos;s place in the source: they were exchanged; export it again to be sure</source>
        <translation>norte e este estão trocados na origem: foram postos no seu lugar; exporte-a outra vez para ter a certeza</translation>
    </message>
    <message>
        <source>coordinates were brought from %1 to %2, in metres</source>
        <translation>as coordenadas foram passadas de %1 para %2, em metros</translation>
    </message>
    <message>
        <source>coordinates were brought from the source&apos;s CRS to %1, in metres</source>
        <translation>as coordenadas foram passadas do sistema da origem para %1, em metros</translation>
    </message>
    <message>
        <source>layers hold no rooms, doors, walls or points by their name; a profile can say otherwise</source>
        <translation>há camadas que, pelo nome, não têm salas, portas, paredes nem pontos; um perfil pode dizer o contrário</translation>
    </message>
    <message>
        <source>features cannot be brought to the CRS of the other layers</source>
        <translation>há elementos que não se conseguem passar para o sistema de coordenadas das outras camadas</translation>
    </message>
    <message>
        <source>layers tell no level; the ground floor is assumed: name the field that holds the level</source>
        <translation>há camadas que não dizem o piso; supõe-se o rés do chão: indique o campo que tem o piso</translation>
    </message>
    <message>
        <source>levels were counted from the heights of the shapes, the one nearest to 0 as the ground floor</source>
        <translation>os pisos foram contados pelas alturas das formas, o mais próximo de 0 como rés do chão</translation>
    </message>
    <message>
        <source>lines of layers that nothing names doors or walls are taken as walls; name the layer or give a profile</source>
        <translation>as linhas de camadas que nada indica como portas ou paredes são tomadas como paredes; dê nome à camada ou indique um perfil</translation>
    </message>
    <message>
        <source>features have no geometry and were left out</source>
        <translation>há elementos sem forma, que foram deixados de fora</translation>
    </message>
    <message>
        <source>features have the code &quot;%1&quot;, which nobody knows: name it under codes in a profile</source>
        <translation>há elementos com o código “%1”, que ninguém conhece: indique-o num perfil, em “codes”</translation>
    </message>
    <message>
        <source>accesses have a direction that nobody knows and are taken to be passed both ways: a_to_b, b_to_a, up or down is wanted</source>
        <translation>há passagens com um sentido que ninguém conhece, tomadas como de dois sentidos: quer-se a_to_b, b_to_a, up ou down</translation>
    </message>
    <message>
        <source>points name a region that does not exist; the one they lie in is taken</source>
        <translation>há pontos que indicam um espaço que não existe; toma-se aquele em que ficam</translation>
    </message>
    <message>
        <source>layers have no features: %1</source>
        <translation>há camadas sem elementos: %1</translation>
    </message>
    <message>
        <source>layers name no CRS; that of the other layers is taken</source>
        <translation>há camadas que não indicam o sistema de coordenadas; toma-se o das outras camadas</translation>
    </message>
    <message>
        <source>features left out: their coordinates are missing or no places on Earth</source>
        <translation>elementos deixados de fora: as suas coordenadas faltam ou não são lugares na Terra</translation>
    </message>
    <message>
        <source>features left out: they have no usable shape</source>
        <translation>elementos deixados de fora: não têm forma utilizável</translation>
    </message>
    <message>
        <source>the value of level or repeat_on is no list of levels such as -1;0 or 1-3: correct it</source>
        <translation>o valor de level ou repeat_on não é uma lista de pisos como -1;0 ou 1-3: corrija-o</translation>
    </message>
    <message>
        <source>there is no readable level; level 0 is assumed: add the level</source>
        <translation>não há nenhum piso legível; supõe-se o piso 0: indique o piso (level)</translation>
    </message>
    <message>
        <source>the lift is a point in the source: a square of 1.6 m was drawn for its car</source>
        <translation>o elevador é um ponto na origem: desenhou-se um quadrado de 1,6&#xa0;m para a cabina</translation>
    </message>
    <message>
        <source>left out: it has no level, and it stands over no or several levels&apos; regions</source>
        <translation>deixado de fora: não tem piso, e fica sobre espaços de vários pisos ou de nenhum</translation>
    </message>
    <message>
        <source>left out: no region of its level lies within 3 m</source>
        <translation>deixado de fora: não há nenhum espaço do seu piso a menos de 3&#xa0;m</translation>
    </message>
    <message>
        <source>left out: it has no level and stands on no outline of a region</source>
        <translation>deixada de fora: não tem piso e não está no contorno de nenhum espaço</translation>
    </message>
    <message>
        <source>no door is drawn where a way leads into the room: an opening was put there</source>
        <translation>não há porta desenhada onde um caminho entra na sala: foi lá posta uma abertura</translation>
    </message>
    <message>
        <source>nothing tells which end of the steps is up; the first was taken as the lower: add incline</source>
        <translation>nada diz que ponta dos degraus fica em cima; a primeira foi tomada como a de baixo: indique incline</translation>
    </message>
    <message>
        <source>no region lies at an end of the steps: draw the area or way it leads to</source>
        <translation>não há nenhum espaço numa das pontas dos degraus: desenhe a área ou o caminho a que levam</translation>
    </message>
    <message>
        <source>steps left out: their line has no length</source>
        <translation>degraus deixados de fora: a sua linha não tem comprimento</translation>
    </message>
    <message>
        <source>nothing tells which way the walkway runs; it is taken to run both ways: set conveying to forward or backward</source>
        <translation>nada diz em que sentido anda a passadeira rolante; supõe-se que nos dois: indique forward ou backward em conveying</translation>
    </message>
    <message>
        <source>no region lies at an end of the walkway: draw the area or way it leads to</source>
        <translation>não há nenhum espaço numa das pontas da passadeira rolante: desenhe a área ou o caminho a que leva</translation>
    </message>
    <message>
        <source>the lift has no drawn door; one was put on a side that is open: move it to its place</source>
        <translation>o elevador não tem porta desenhada; foi posta uma num lado aberto: mova-a para o seu lugar</translation>
    </message>
    <message>
        <source>features of the type %1 have no place in a building file</source>
        <translation>os elementos do tipo %1 não têm lugar num ficheiro de edifício</translation>
    </message>
    <message>
        <source>levels have no ordinal; they are taken as the ground floor</source>
        <translation>há pisos sem ordinal, tomados como rés do chão</translation>
    </message>
    <message>
        <source>features name a level that does not exist; the ground floor is assumed</source>
        <translation>há elementos que indicam um piso que não existe; supõe-se o rés do chão</translation>
    </message>
    <message>
        <source>units have a category that IMDF 1.0 does not list; they are taken as rooms</source>
        <translation>há unidades com uma categoria que o IMDF 1.0 não lista, tomadas como salas</translation>
    </message>
    <message>
        <source>units are walls, columns or voids: they became walls</source>
        <translation>há unidades que são paredes, colunas ou vazios: ficaram paredes</translation>
    </message>
    <message>
        <source>units have no outline and were left out</source>
        <translation>há unidades sem contorno, que foram deixadas de fora</translation>
    </message>
    <message>
        <source>occupants have no anchor in a unit and were left out</source>
        <translation>há ocupantes sem âncora numa unidade, que foram deixados de fora</translation>
    </message>
    <message>
        <source>openings are emergency exits, for vehicles or out of service: nobody is led through them</source>
        <translation>há aberturas que são saídas de emergência, para veículos ou fora de serviço: ninguém é levado por elas</translation>
    </message>
    <message>
        <source>openings have no line and were left out</source>
        <translation>há aberturas sem linha, que foram deixadas de fora</translation>
    </message>
    <message>
        <source>amenities have no point and were left out</source>
        <translation>há serviços sem ponto, que foram deixados de fora</translation>
    </message>
    <message>
        <source>amenities name no unit that tells their level and were left out</source>
        <translation>há serviços que não indicam nenhuma unidade que diga o piso, e foram deixados de fora</translation>
    </message>
    <message>
        <source>relationships do not name two units and were left out</source>
        <translation>há relações que não indicam duas unidades, e foram deixadas de fora</translation>
    </message>
    <message>
        <source>the name of the coordinate system is not known; a local plane in metres is assumed</source>
        <translation>o nome do sistema de coordenadas não é conhecido; supõe-se um plano local em metros</translation>
    </message>
    <message>
        <source>cells left out: they have no outline, no id, or the id of another</source>
        <translation>células deixadas de fora: não têm contorno nem identificador, ou têm o de outra</translation>
    </message>
    <message>
        <source>transitions left out: they do not connect two cells that are there</source>
        <translation>transições deixadas de fora: não ligam duas células que existam</translation>
    </message>
    <message>
        <source>storeys are named by words; levels were taken from the heights</source>
        <translation>os pisos são nomeados por palavras; foram tirados das alturas</translation>
    </message>
    <message>
        <source>nothing tells the levels: all is taken as level 0; name the field that holds the level</source>
        <translation>nada diz os pisos: tudo é tomado como piso 0; indique o campo que tem o piso</translation>
    </message>
    <message>
        <source>levels were counted from the heights of the floors</source>
        <translation>os pisos foram contados pelas alturas do chão</translation>
    </message>
    <message>
        <source>the door&apos;s cell does not lie between two rooms: it stays a region</source>
        <translation>a célula da porta não fica entre duas salas: continua a ser um espaço</translation>
    </message>
    <message>
        <source>features left out: they are no node, link, facility or entrance</source>
        <translation>elementos deixados de fora: não são nó, ligação, serviço nem entrada</translation>
    </message>
    <message>
        <source>the network has no areas: each node became a region of strips along its links, cut half-way, and each facility a square of 2 m behind its entrance</source>
        <translation>a rede não tem áreas: de cada nó fez-se um espaço com faixas ao longo das suas ligações, cortadas a meio, e de cada serviço um quadrado de 2&#xa0;m atrás da sua entrada</translation>
    </message>
    <message>
        <source>floor 0 is taken as the ground floor; import it with the level from 1 when it is floor 1</source>
        <translation>o piso 0 é tomado como rés do chão; importe com o piso a partir de 1, se for o piso 1</translation>
    </message>
    <message>
        <source>floor 1 is taken as the ground floor; import it with the level from 0 when it is floor 0</source>
        <translation>o piso 1 é tomado como rés do chão; importe com o piso a partir de 0, se for o piso 0</translation>
    </message>
    <message>
        <source>nodes left out: they have no place, no id, or the id of another</source>
        <translation>nós deixados de fora: não têm lugar nem identificador, ou têm o de outro</translation>
    </message>
    <message>
        <source>nodes without a floor are taken to be on the ground</source>
        <translation>os nós sem piso são tomados como do rés do chão</translation>
    </message>
    <message>
        <source>links left out: they do not join two nodes that are there</source>
        <translation>ligações deixadas de fora: não ligam dois nós que existam</translation>
    </message>
    <message>
        <source>no link leads to the node</source>
        <translation>nenhuma ligação leva ao nó</translation>
    </message>
    <message>
        <source>no entrance with a known node leads to the facility: it became a landmark</source>
        <translation>nenhuma entrada com um nó conhecido leva ao serviço: ficou um ponto de referência</translation>
    </message>
    <message>
        <source>the facility of the entrance is missing</source>
        <translation>falta o serviço da entrada</translation>
    </message>
    <message>
        <source>left out: it lies more than 20 m from every node of its floor</source>
        <translation>deixado de fora: fica a mais de 20&#xa0;m de todos os nós do seu piso</translation>
    </message>
    <message numerus="yes">
        <source>%n spaces were closed from walls, doors and windows; they have no names, and whether they are rooms, corridors or halls is a guess from their doors and size</source>
        <translation>
            <numerusform>fechou-se %n espaço a partir de paredes, portas e janelas; não tem nome, e se é sala, corredor ou átrio é um palpite pelas portas e pelo tamanho</numerusform>
            <numerusform>fecharam-se %n espaços a partir de paredes, portas e janelas; não têm nome, e se são salas, corredores ou átrios é um palpite pelas portas e pelo tamanho</numerusform>
        </translation>
    </message>
    <message>
        <source>strips under 0.3 m between walls were left out</source>
        <translation>tiras com menos de 0,3&#xa0;m entre paredes foram deixadas de fora</translation>
    </message>
    <message>
        <source>no space lies on one side of the door: it leads outside, or a wall is missing</source>
        <translation>de um dos lados da porta não há espaço: dá para fora, ou falta uma parede</translation>
    </message>
    <message>
        <source>%1, layer %2</source>
        <translation>%1, camada %2</translation>
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
        <translation>%1, linha %2</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, piso %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 e mais %2</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>não existe esse ficheiro</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>não existe esse ficheiro ou pasta</translation>
    </message>
    <message>
        <source>is no file or folder</source>
        <translation>não é um ficheiro nem uma pasta</translation>
    </message>
    <message>
        <source>is a folder; a file is wanted</source>
        <translation>é uma pasta; quer-se um ficheiro</translation>
    </message>
    <message>
        <source>holds no files</source>
        <translation>não tem ficheiros</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>não se consegue abrir</translation>
    </message>
    <message>
        <source>cannot be listed (%1)</source>
        <translation>não se consegue listar (%1)</translation>
    </message>
    <message>
        <source>is not a map file that can be read</source>
        <translation>não é um ficheiro de mapa que se possa ler</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>não se consegue ler até ao fim</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>não se consegue ler (%1)</translation>
    </message>
    <message>
        <source>cannot be imported (%1)</source>
        <translation>não se consegue importar (%1)</translation>
    </message>
    <message>
        <source>the map cannot be put together (%1)</source>
        <translation>não se consegue compor o mapa (%1)</translation>
    </message>
    <message>
        <source>reading the map failed: %1</source>
        <translation>a leitura do mapa falhou: %1</translation>
    </message>
    <message>
        <source>is empty or cannot be read</source>
        <translation>está vazio ou não se consegue ler</translation>
    </message>
    <message>
        <source>is no indoor map of a kind that is known: %1 was tried as %2; name its kind, or give a profile with its column names</source>
        <translation>não é um mapa de interiores de um tipo conhecido: experimentou-se %1 como %2; indique o tipo, ou dê um perfil com os nomes das colunas</translation>
    </message>
    <message>
        <source>holds no file of the format %1</source>
        <translation>não tem nenhum ficheiro do formato %1</translation>
    </message>
    <message>
        <source>is larger than 1 GB: too much for a map of a building</source>
        <translation>tem mais de 1 GB: é demais para o mapa de um edifício</translation>
    </message>
    <message>
        <source>is larger than %1 MB: no map of a building is</source>
        <translation>tem mais de %1 MB: nenhum mapa de edifício os tem</translation>
    </message>
    <message>
        <source>holds more than 10000 files: name the folder of one building</source>
        <translation>tem mais de 10000 ficheiros: indique a pasta de um só edifício</translation>
    </message>
    <message>
        <source>the database cannot be opened</source>
        <translation>não se consegue abrir a base de dados</translation>
    </message>
    <message>
        <source>the zip holds more than 10000 files: no map of a building does</source>
        <translation>o zip tem mais de 10000 ficheiros: nenhum mapa de edifício os tem</translation>
    </message>
    <message>
        <source>a file in the zip has a name that leads out of it; the zip is not trusted</source>
        <translation>um ficheiro do zip tem um nome que leva para fora dele; o zip não é de confiança</translation>
    </message>
    <message>
        <source>the zip is locked by a password; unpack it first</source>
        <translation>o zip está fechado com uma palavra-passe; descompacte-o primeiro</translation>
    </message>
    <message>
        <source>unpacks to %1 MB: too much for a map of a building</source>
        <translation>descompactado tem %1 MB: é demais para o mapa de um edifício</translation>
    </message>
    <message>
        <source>the zip&apos;s list of files is damaged; make the zip again</source>
        <translation>a lista de ficheiros do zip está danificada; faça o zip de novo</translation>
    </message>
    <message>
        <source>the zip is cut off: its list of files is missing; copy it again</source>
        <translation>o zip está cortado: falta a lista de ficheiros; copie-o de novo</translation>
    </message>
    <message>
        <source>the zip is larger than any map; unpack it and name the folder</source>
        <translation>o zip é maior do que qualquer mapa; descompacte-o e indique a pasta</translation>
    </message>
    <message>
        <source>the zip&apos;s list of files lies outside it; make the zip again</source>
        <translation>a lista de ficheiros do zip fica fora dele; faça o zip de novo</translation>
    </message>
    <message>
        <source>is a landmark library without a map: name the file of the building</source>
        <translation>é uma biblioteca de pontos de referência sem mapa: indique o ficheiro do edifício</translation>
    </message>
    <message>
        <source>is not a Farol map: it has no layer regions; import maps of another kind first</source>
        <translation>não é um mapa do Farol: não tem a camada regions; importe primeiro os mapas de outro tipo</translation>
    </message>
    <message>
        <source>the map is in degrees (%1); metres are wanted: import or reproject it</source>
        <translation>o mapa está em graus (%1); querem-se metros: importe-o ou reprojete-o</translation>
    </message>
    <message>
        <source>the map&apos;s unit is not the metre (%1): reproject it</source>
        <translation>a unidade do mapa não é o metro (%1): reprojete-o</translation>
    </message>
    <message>
        <source>the field %1 is missing; add and fill it</source>
        <translation>falta o campo %1; junte-o e preencha-o</translation>
    </message>
    <message>
        <source>the schema version &quot;%1&quot; is no version</source>
        <translation>a versão do esquema “%1” não é uma versão</translation>
    </message>
    <message>
        <source>the map has schema version %1, this Farol knows %2: use a newer Farol</source>
        <translation>o mapa tem a versão de esquema %1, e este Farol conhece a %2: use um Farol mais novo</translation>
    </message>
    <message>
        <source>the map has no regions; draw at least one</source>
        <translation>o mapa não tem espaços; desenhe pelo menos um</translation>
    </message>
    <message>
        <source>two features have this id; give each its own</source>
        <translation>dois elementos têm este identificador; dê a cada um o seu</translation>
    </message>
    <message>
        <source>this level is listed twice; remove one</source>
        <translation>este piso está na lista duas vezes; retire um</translation>
    </message>
    <message>
        <source>oneway is &quot;%1&quot;; a_to_b, b_to_a or nothing is wanted</source>
        <translation>oneway é “%1”; quer-se a_to_b, b_to_a ou nada</translation>
    </message>
    <message>
        <source>has no %1; fill it in</source>
        <translation>não tem %1; preencha-o</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 não é um número</translation>
    </message>
    <message>
        <source>%1 is no whole number within reason</source>
        <translation>%1 não é um número inteiro razoável</translation>
    </message>
    <message>
        <source>%1 is neither 0 nor 1</source>
        <translation>%1 não é 0 nem 1</translation>
    </message>
    <message>
        <source>level %1 is no floor of a building</source>
        <translation>o piso %1 não é um piso de um edifício</translation>
    </message>
    <message>
        <source>has no geometry; a %1 is wanted</source>
        <translation>não tem forma; quer-se %1</translation>
    </message>
    <message>
        <source>consists of %1 parts; a single %2 is wanted: split it and give each part its own id</source>
        <translation>tem %1 partes; quer-se uma só (%2): divida-o e dê a cada parte o seu identificador</translation>
    </message>
    <message>
        <source>has a coordinate that is no number</source>
        <translation>tem uma coordenada que não é um número</translation>
    </message>
    <message>
        <source>has a coordinate beyond any metric map</source>
        <translation>tem uma coordenada fora de qualquer mapa em metros</translation>
    </message>
    <message>
        <source>is an outline without an area</source>
        <translation>é um contorno sem área</translation>
    </message>
    <message>
        <source>is a %1; a %2 is wanted</source>
        <translation>é %1; quer-se %2</translation>
    </message>
    <message>
        <source>has no outline</source>
        <translation>não tem contorno</translation>
    </message>
    <message>
        <source>there are no rooms, corridors or other areas in it: nothing to walk through</source>
        <translation>não há nele salas, corredores nem outras áreas: nada por onde andar</translation>
    </message>
    <message>
        <source>has %1 levels: no building has; the level stands in another attribute: name that one</source>
        <translation>tem %1 pisos: nenhum edifício os tem; o piso está noutro atributo: indique-o</translation>
    </message>
    <message>
        <source>the map has no coordinates</source>
        <translation>o mapa não tem coordenadas</translation>
    </message>
    <message>
        <source>geocentric coordinates are no plan of a floor; project them</source>
        <translation>coordenadas geocêntricas não são a planta de um piso; projete-as</translation>
    </message>
    <message>
        <source>coordinates are beyond 100,000 km: they are no metres of a building</source>
        <translation>as coordenadas passam dos 100&#xa0;000 km: não são metros de um edifício</translation>
    </message>
    <message>
        <source>the coordinates do not lie where their CRS is defined</source>
        <translation>as coordenadas não ficam onde o seu sistema está definido</translation>
    </message>
    <message>
        <source>the CRS cannot be brought to metres</source>
        <translation>não se consegue passar o sistema de coordenadas para metros</translation>
    </message>
    <message>
        <source>holds more than a million features: no building does</source>
        <translation>tem mais de um milhão de elementos: nenhum edifício os tem</translation>
    </message>
    <message>
        <source>has more than 500,000 features: no building has</source>
        <translation>tem mais de 500&#xa0;000 elementos: nenhum edifício os tem</translation>
    </message>
    <message>
        <source>the shapes have no heights (z) that levels could be taken from; name a column instead</source>
        <translation>as formas não têm alturas (z) de que se possam tirar os pisos; indique antes uma coluna</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through: name the folder with all layers, or say what they are in a profile</source>
        <translation>não tem salas, corredores nem outras áreas por onde andar: indique a pasta com todas as camadas, ou diga num perfil o que elas são</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; %1 and what else is a door touches no region (access-joins-two-regions): name the folder with all layers, or say what they are in a profile</source>
        <translation>não tem salas, corredores nem outras áreas por onde andar; %1 e o mais que é porta não tocam em nenhum espaço: indique a pasta com todas as camadas, ou diga num perfil o que elas são</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; lines alone enclose no rooms (layer-role): name the folder with all layers, or say what they are in a profile</source>
        <translation>não tem salas, corredores nem outras áreas por onde andar; só as linhas não encerram salas: indique a pasta com todas as camadas, ou diga num perfil o que elas são</translation>
    </message>
    <message>
        <source>holds no rooms, corridors or other areas to walk through; there are no features in %1 (layer-empty): name the folder with all layers, or say what they are in a profile</source>
        <translation>não tem salas, corredores nem outras áreas por onde andar; não há elementos em %1: indique a pasta com todas as camadas, ou diga num perfil o que elas são</translation>
    </message>
    <message>
        <source>is no GeoJSON FeatureCollection</source>
        <translation>não é uma FeatureCollection de GeoJSON</translation>
    </message>
    <message>
        <source>is nested deeper than any map</source>
        <translation>está encaixado mais fundo do que qualquer mapa</translation>
    </message>
    <message>
        <source>is damaged JSON (%1)</source>
        <translation>é JSON danificado (%1)</translation>
    </message>
    <message>
        <source>is no JSON object with columns, codes, levels or layers</source>
        <translation>não é um objeto JSON com columns, codes, levels ou layers</translation>
    </message>
    <message>
        <source>there is no column meaning &quot;%1&quot;</source>
        <translation>não há nenhuma coluna que signifique “%1”</translation>
    </message>
    <message>
        <source>the role of layer &quot;%1&quot; is unknown</source>
        <translation>o papel da camada “%1” é desconhecido</translation>
    </message>
    <message>
        <source>makes more than 20,000 regions on its levels, or its ways cross too many of them: cut the building out of it</source>
        <translation>dá mais de 20&#xa0;000 espaços nos seus pisos, ou os seus caminhos cruzam demasiados: recorte dele o edifício</translation>
    </message>
    <message>
        <source>holds no indoor areas: rooms, corridors and areas must be tagged indoor=* with a level</source>
        <translation>não tem áreas interiores: salas, corredores e áreas têm de ter a etiqueta indoor=* com um piso</translation>
    </message>
    <message>
        <source>has more than 500,000 tagged features: cut the building out of it</source>
        <translation>tem mais de 500&#xa0;000 elementos com etiquetas: recorte dele o edifício</translation>
    </message>
    <message>
        <source>is damaged OpenStreetMap data</source>
        <translation>são dados do OpenStreetMap danificados</translation>
    </message>
    <message>
        <source>cannot be read as OpenStreetMap data</source>
        <translation>não se consegue ler como dados do OpenStreetMap</translation>
    </message>
    <message>
        <source>holds no OpenStreetMap file (.osm, .osm.pbf or GeoJSON made of one)</source>
        <translation>não tem nenhum ficheiro do OpenStreetMap (.osm, .osm.pbf ou GeoJSON feito de um)</translation>
    </message>
    <message>
        <source>holds no unit.geojson: name the folder or zip of an IMDF venue</source>
        <translation>não tem unit.geojson: indique a pasta ou o zip de um mapa IMDF</translation>
    </message>
    <message>
        <source>holds %1 IMDF venues: name the folder of one of them, such as %2</source>
        <translation>tem %1 mapas IMDF: indique a pasta de um deles, como %2</translation>
    </message>
    <message>
        <source>has more than 20,000 nodes or facilities or 50,000 links: cut the building out of it</source>
        <translation>tem mais de 20&#xa0;000 nós ou serviços ou 50&#xa0;000 ligações: recorte dele o edifício</translation>
    </message>
    <message>
        <source>holds no node of a route network with a place</source>
        <translation>não tem nenhum nó de uma rede de caminhos com lugar</translation>
    </message>
    <message>
        <source>has more than 200,000 features</source>
        <translation>tem mais de 200&#xa0;000 elementos</translation>
    </message>
    <message>
        <source>is XML, but not IndoorGML (IndoorFeatures)</source>
        <translation>é XML, mas não IndoorGML (IndoorFeatures)</translation>
    </message>
    <message>
        <source>has more than 50,000 cells</source>
        <translation>tem mais de 50&#xa0;000 células</translation>
    </message>
    <message>
        <source>has no cell with a usable outline: Farol needs CellSpace geometry</source>
        <translation>não tem nenhuma célula com contorno utilizável: o Farol precisa da geometria de CellSpace</translation>
    </message>
    <message>
        <source>has no cells but doors: rooms and corridors are missing</source>
        <translation>só tem células de portas: faltam salas e corredores</translation>
    </message>
    <message>
        <source>holds no IndoorGML file</source>
        <translation>não tem nenhum ficheiro IndoorGML</translation>
    </message>
    <message>
        <source>is damaged XML: %1</source>
        <translation>é XML danificado: %1</translation>
    </message>
    <message>
        <source>has more than two million elements</source>
        <translation>tem mais de dois milhões de elementos</translation>
    </message>
    <message>
        <source>is nested deeper than 100 elements</source>
        <translation>tem mais de 100 níveis de elementos encaixados</translation>
    </message>
    <message>
        <source>declares entities, which no map needs</source>
        <translation>declara entidades, de que nenhum mapa precisa</translation>
    </message>
    <message>
        <source>lists no levels, as main.json of a WRLD map does</source>
        <translation>não lista pisos, como faz o main.json de um mapa WRLD</translation>
    </message>
    <message>
        <source>lists more than 300 levels</source>
        <translation>lista mais de 300 pisos</translation>
    </message>
    <message>
        <source>a level has no z_order of its own</source>
        <translation>um piso não tem z_order próprio</translation>
    </message>
    <message>
        <source>no floor has a room or an outline with walls</source>
        <translation>nenhum piso tem uma sala ou um contorno com paredes</translation>
    </message>
    <message>
        <source>the floor&apos;s file &quot;%1&quot; is missing: import the folder or zip that holds it</source>
        <translation>falta o ficheiro do piso, “%1”: importe a pasta ou o zip que o tem</translation>
    </message>
    <message>
        <source>has more than 10,000 features on a floor or 40,000 in all: no building has</source>
        <translation>tem mais de 10&#xa0;000 elementos num piso ou 40&#xa0;000 ao todo: nenhum edifício os tem</translation>
    </message>
    <message>
        <source>holds no main.json: name the folder or zip of the WRLD map</source>
        <translation>não tem main.json: indique a pasta ou o zip do mapa WRLD</translation>
    </message>
    <message>
        <source>is damaged (%1)</source>
        <translation>está danificado (%1)</translation>
    </message>
    <message>
        <source>the region has no outline</source>
        <translation>o espaço não tem contorno</translation>
    </message>
    <message>
        <source>the access has no place on the map</source>
        <translation>a passagem não tem lugar no mapa</translation>
    </message>
    <message>
        <source>both sides are the same region: choose another one</source>
        <translation>os dois lados são o mesmo espaço: escolha outro</translation>
    </message>
    <message>
        <source>the width must be above 0 m, and the steps 0 or more</source>
        <translation>a largura tem de ser maior do que 0&#xa0;m, e os degraus 0 ou mais</translation>
    </message>
    <message>
        <source>the landmark has no place on the map</source>
        <translation>o ponto de referência não tem lugar no mapa</translation>
    </message>
    <message>
        <source>the width and the height of the object must be above 0 m</source>
        <translation>a largura e a altura do objeto têm de ser maiores do que 0&#xa0;m</translation>
    </message>
    <message>
        <source>the map has this name already</source>
        <translation>o mapa já tem este nome</translation>
    </message>
    <message>
        <source>the map does not hold it any more</source>
        <translation>o mapa já não o tem</translation>
    </message>
    <message>
        <source>the map there is of a later Farol; save under another name or use the newer Farol</source>
        <translation>o mapa que lá está é de um Farol posterior; guarde com outro nome ou use o Farol mais novo</translation>
    </message>
    <message>
        <source>is another kind of file; save under a name that ends in .gpkg</source>
        <translation>é outro tipo de ficheiro; guarde com um nome que acabe em .gpkg</translation>
    </message>
    <message>
        <source>another program has the file open and writes to it; close it there and save again</source>
        <translation>outro programa tem o ficheiro aberto e escreve nele; feche-o lá e guarde de novo</translation>
    </message>
    <message>
        <source>the disk is full: free some space and save again; what was there before is untouched</source>
        <translation>o disco está cheio: liberte espaço e guarde de novo; o que lá estava antes está intacto</translation>
    </message>
    <message>
        <source>the map was changed by someone else since it was read; nothing was written: read it again and repeat the change</source>
        <translation>o mapa foi alterado por outra pessoa desde que foi lido; nada foi escrito: leia-o de novo e repita a alteração</translation>
    </message>
    <message>
        <source>there is no field level; level 0 is assumed</source>
        <translation>falta o campo level; supõe-se o piso 0</translation>
    </message>
    <message>
        <source>there is no layer %1</source>
        <translation>falta a camada %1</translation>
    </message>
    <message>
        <source>%1 do not join two regions and are not walked through: %2</source>
        <translation>%1 não ligam dois espaços e não se passa por eles: %2</translation>
    </message>
    <message>
        <source>unknown kind &quot;%1&quot;, treated as other: %2</source>
        <translation>tipo desconhecido “%1”, tratado como outro: %2</translation>
    </message>
    <message>
        <source>no kind, treated as other: %1</source>
        <translation>sem tipo, tratado como outro: %1</translation>
    </message>
    <message>
        <source>a place is empty: give a region&apos;s id, name or ref, or x,y,level</source>
        <translation>o lugar está vazio: indique o identificador, o nome ou a referência de um espaço, ou x,y,piso</translation>
    </message>
    <message>
        <source>no region of level %1 holds this point</source>
        <translation>nenhum espaço do piso %1 contém este ponto</translation>
    </message>
    <message>
        <source>several regions are called so: %1; give one of these ids</source>
        <translation>há vários espaços com este nome: %1; indique um destes identificadores</translation>
    </message>
    <message>
        <source>no region has this id, name or ref</source>
        <translation>nenhum espaço tem este identificador, nome ou referência</translation>
    </message>
    <message>
        <source>no region has this id, name or ref; near spellings: %1</source>
        <translation>nenhum espaço tem este identificador, nome ou referência; parecidos: %1</translation>
    </message>
    <message>
        <source>%1 (level %2)</source>
        <translation>%1 (piso %2)</translation>
    </message>
    <message>
        <source>the map has no region &quot;%1&quot;</source>
        <translation>o mapa não tem o espaço “%1”</translation>
    </message>
    <message>
        <source>the position is no number</source>
        <translation>a posição não é um número</translation>
    </message>
    <message>
        <source>is out of its range</source>
        <translation>está fora dos limites</translation>
    </message>
    <message>
        <source>has an outline that is none</source>
        <translation>tem um contorno que não o é</translation>
    </message>
    <message>
        <source>has no position</source>
        <translation>não tem posição</translation>
    </message>
    <message>
        <source>a wall has no length</source>
        <translation>uma parede não tem comprimento</translation>
    </message>
    <message>
        <source>the map cannot be written there</source>
        <translation>não se consegue escrever lá o mapa</translation>
    </message>
    <message>
        <source>cannot be copied before saving</source>
        <translation>não se consegue copiar antes de guardar</translation>
    </message>
    <message>
        <source>writing the map failed: %1</source>
        <translation>não se conseguiu escrever o mapa: %1</translation>
    </message>
    <message>
        <source>the map may not be changed now: someone else is changing it, or the user has no right to; nothing was written, save again in a moment</source>
        <translation>o mapa não pode ser mudado agora: outra pessoa está a mudá-lo, ou o utilizador não tem esse direito; nada foi escrito, guarde de novo daqui a pouco</translation>
    </message>
    <message>
        <source>the database has no PostGIS: ask its administrator to add that extension</source>
        <translation>a base de dados não tem o PostGIS: peça ao administrador que acrescente essa extensão</translation>
    </message>
    <message>
        <source>this is no picture that can be read; use PNG, JPEG or GeoTIFF</source>
        <translation>isto não é uma imagem que se consiga ler; use PNG, JPEG ou GeoTIFF</translation>
    </message>
    <message>
        <source>the picture is damaged: save it anew</source>
        <translation>a imagem está danificada: guarde-a de novo</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>permissão recusada</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>o ficheiro ou a pasta não existe</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>o sistema de ficheiros é só de leitura</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>não há espaço no disco</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>erro de leitura ou escrita</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>é uma pasta</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>não é uma pasta</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>o nome do ficheiro é demasiado comprido</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>a operação não é permitida</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>há demasiados ficheiros abertos</translation>
    </message>
    <message>
        <source>cannot be read as a picture</source>
        <translation>não se consegue ler como imagem</translation>
    </message>
    <message>
        <source>no source was named: give camera:0, a video file, a folder of pictures or an address</source>
        <translation>não foi indicada nenhuma fonte: dê camera:0, um ficheiro de vídeo, uma pasta de imagens ou um endereço</translation>
    </message>
    <message>
        <source>there is no such file or folder (a source is camera:0, a video file, a folder of pictures, or an http or rtsp address)</source>
        <translation>não existe esse ficheiro nem essa pasta (uma fonte é camera:0, um ficheiro de vídeo, uma pasta de imagens ou um endereço http ou rtsp)</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>não se consegue ler a pasta</translation>
    </message>
    <message>
        <source>there are no pictures in this folder (jpg, png, bmp, webp or tif)</source>
        <translation>não há imagens nesta pasta (jpg, png, bmp, webp ou tif)</translation>
    </message>
    <message>
        <source>is neither a picture nor a video that can be opened (tried FFmpeg and GStreamer)</source>
        <translation>não é uma imagem nem um vídeo que se consiga abrir (experimentou-se FFmpeg e GStreamer)</translation>
    </message>
    <message>
        <source>the address does not answer with a video within %1 s (tried FFmpeg): is the camera on, and the address right?</source>
        <translation>o endereço não responde com um vídeo em %1 s (experimentou-se FFmpeg): a câmara está ligada, e o endereço certo?</translation>
    </message>
    <message>
        <source>a camera is named by its number or its device, such as camera:0</source>
        <translation>uma câmara indica-se pelo seu número ou dispositivo, como camera:0</translation>
    </message>
    <message>
        <source>the camera cannot be opened (tried Video4Linux at %1): is it plugged in, and not in use by another program?</source>
        <translation>não se consegue abrir a câmara (experimentou-se Video4Linux em %1): está ligada, e não a ser usada por outro programa?</translation>
    </message>
    <message>
        <source>%1 delivers no more pictures</source>
        <translation>%1 já não fornece imagens</translation>
    </message>
    <message>
        <source>%1 gives no more pictures</source>
        <translation>%1 deixou de dar imagens</translation>
    </message>
    <message>
        <source>%1 is tried again (attempt %2)</source>
        <translation>tenta-se de novo %1 (tentativa %2)</translation>
    </message>
    <message>
        <source>%1 is back</source>
        <translation>%1 está de volta</translation>
    </message>
    <message>
        <source>%1 broke down: %2</source>
        <translation>%1 avariou-se: %2</translation>
    </message>
    <message>
        <source>the library&apos;s version is not a number: &quot;%1&quot;</source>
        <translation>a versão da biblioteca não é um número: “%1”</translation>
    </message>
    <message>
        <source>the landmark library is of a later version (%1) than this program knows (%2); update Farol</source>
        <translation>a biblioteca de pontos de referência é de uma versão (%1) posterior à que este programa conhece (%2); atualize o Farol</translation>
    </message>
    <message>
        <source>holds no landmark library (no layers templates and views)</source>
        <translation>não contém uma biblioteca de pontos de referência (faltam as camadas templates e views)</translation>
    </message>
    <message>
        <source>the landmark library cannot be read</source>
        <translation>não se consegue ler a biblioteca de pontos de referência</translation>
    </message>
    <message>
        <source>cannot save the library: %1</source>
        <translation>não se consegue guardar a biblioteca: %1</translation>
    </message>
    <message>
        <source>is not a GeoPackage, and a library is kept in one (*.gpkg)</source>
        <translation>não é um GeoPackage, e uma biblioteca guarda-se num (*.gpkg)</translation>
    </message>
    <message>
        <source>a template has no name</source>
        <translation>um ponto de referência não tem nome</translation>
    </message>
    <message>
        <source>template %1 stands twice</source>
        <translation>o ponto de referência %1 aparece duas vezes</translation>
    </message>
    <message>
        <source>a view belongs to a template that is not in the library</source>
        <translation>uma fotografia é de um ponto de referência que não está na biblioteca</translation>
    </message>
    <message>
        <source>the photograph or its outline is missing</source>
        <translation>falta a fotografia ou o seu contorno</translation>
    </message>
    <message>
        <source>the extractor&apos;s parameters cannot be read: &quot;%1&quot;</source>
        <translation>não se consegue ler os parâmetros do extrator: “%1”</translation>
    </message>
    <message>
        <source>the library was trained with %1, but %2; train it again from its photographs</source>
        <translation>a biblioteca foi treinada com %1, mas %2; treine-a de novo a partir das suas fotografias</translation>
    </message>
    <message>
        <source>the library was trained with %1, but %2 is in use; train it again from its photographs, or choose its own extractor</source>
        <translation>a biblioteca foi treinada com %1, mas está a usar-se %2; treine-a de novo a partir das suas fotografias, ou escolha o extrator dela</translation>
    </message>
    <message>
        <source>there is no feature extractor &quot;%1&quot;; there are %2</source>
        <translation>não há nenhum extrator “%1”; há %2</translation>
    </message>
    <message>
        <source>version %1 of %2 is not known, only %3</source>
        <translation>não se conhece a versão %1 de %2, só a %3</translation>
    </message>
    <message>
        <source>the working size must be between 64 and 4096 pixels</source>
        <translation>o tamanho de trabalho tem de estar entre 64 e 4096 píxeis</translation>
    </message>
    <message>
        <source>the number of keypoints must be between 10 and 20000</source>
        <translation>o número de pontos-chave tem de estar entre 10 e 20000</translation>
    </message>
    <message>
        <source>the contrast threshold must be between 0 and 1</source>
        <translation>o limiar de contraste tem de estar entre 0 e 1</translation>
    </message>
    <message>
        <source>%1; the library is damaged: restore it or train this view again</source>
        <translation>%1; a biblioteca está danificada: reponha-a ou treine de novo esta fotografia</translation>
    </message>
    <message>
        <source>the outline &quot;%1&quot; is not eight numbers</source>
        <translation>o contorno “%1” não tem oito números</translation>
    </message>
    <message>
        <source>the descriptors are not of the width that %1 makes</source>
        <translation>os descritores não têm a largura que %1 produz</translation>
    </message>
    <message>
        <source>the photograph&apos;s size is missing</source>
        <translation>falta o tamanho da fotografia</translation>
    </message>
    <message>
        <source>the checksum does not fit the photograph and its features</source>
        <translation>a soma de controlo não corresponde à fotografia e às suas características</translation>
    </message>
    <message>
        <source>the keypoints do not begin as they should</source>
        <translation>os pontos-chave não começam como devem</translation>
    </message>
    <message>
        <source>the keypoints have an impossible size</source>
        <translation>os pontos-chave têm um tamanho impossível</translation>
    </message>
    <message>
        <source>the keypoints are cut off or too long</source>
        <translation>os pontos-chave estão cortados ou são longos demais</translation>
    </message>
    <message>
        <source>the keypoints are of another kind</source>
        <translation>os pontos-chave são de outro tipo</translation>
    </message>
    <message>
        <source>a keypoint has an impossible value</source>
        <translation>um ponto-chave tem um valor impossível</translation>
    </message>
    <message>
        <source>the descriptors do not begin as they should</source>
        <translation>os descritores não começam como devem</translation>
    </message>
    <message>
        <source>the descriptors have an impossible size</source>
        <translation>os descritores têm um tamanho impossível</translation>
    </message>
    <message>
        <source>the descriptors are cut off or too long</source>
        <translation>os descritores estão cortados ou são longos demais</translation>
    </message>
    <message>
        <source>the descriptors are of another kind</source>
        <translation>os descritores são de outro tipo</translation>
    </message>
    <message>
        <source>there are not as many descriptors as keypoints</source>
        <translation>não há tantos descritores como pontos-chave</translation>
    </message>
    <message>
        <source>cannot replace the layer</source>
        <translation>não se consegue substituir a camada</translation>
    </message>
    <message>
        <source>cannot make the layer</source>
        <translation>não se consegue criar a camada</translation>
    </message>
    <message>
        <source>cannot make the field %1</source>
        <translation>não se consegue criar o campo %1</translation>
    </message>
    <message>
        <source>cannot replace the version</source>
        <translation>não se consegue substituir a versão</translation>
    </message>
    <message>
        <source>the layer has no fields key and value: this is not one of Farol&apos;s files</source>
        <translation>a camada não tem os campos key e value: este ficheiro não é do Farol</translation>
    </message>
    <message>
        <source>no view is chosen</source>
        <translation>não está escolhida nenhuma fotografia</translation>
    </message>
    <message>
        <source>a template needs at least one view; delete it instead</source>
        <translation>um ponto de referência precisa de pelo menos uma fotografia; em vez disso, elimine-o</translation>
    </message>
    <message>
        <source>a template needs a name of its own</source>
        <translation>um ponto de referência precisa de um nome próprio</translation>
    </message>
    <message>
        <source>this name is taken by another template</source>
        <translation>outro ponto de referência já tem este nome</translation>
    </message>
    <message>
        <source>a template needs at least one view</source>
        <translation>um ponto de referência precisa de pelo menos uma fotografia</translation>
    </message>
    <message>
        <source>a real size must be a positive number of metres</source>
        <translation>um tamanho real tem de ser um número positivo de metros</translation>
    </message>
    <message>
        <source>a template cannot be merged with itself</source>
        <translation>um ponto de referência não pode ser unido a si próprio</translation>
    </message>
    <message>
        <source>a place and an object cannot be one template; choose two of the same sort</source>
        <translation>um lugar e um objeto não podem ser um só ponto de referência; escolha dois do mesmo tipo</translation>
    </message>
    <message>
        <source>the outline has a corner that is no number</source>
        <translation>o contorno tem um canto que não é um número</translation>
    </message>
    <message>
        <source>the outline leaves the picture, which is %1 x %2 pixels</source>
        <translation>o contorno sai da imagem, que tem %1 x %2 píxeis</translation>
    </message>
    <message>
        <source>the outline&apos;s four corners must follow the object&apos;s border clockwise from its top left, without crossing</source>
        <translation>os quatro cantos do contorno têm de seguir a borda do objeto no sentido dos ponteiros do relógio a partir do canto superior esquerdo, sem se cruzarem</translation>
    </message>
    <message>
        <source>the outline&apos;s corners run counter-clockwise; give them clockwise from the object&apos;s top left</source>
        <translation>os cantos do contorno vão no sentido contrário ao dos ponteiros do relógio; dê-os nesse sentido a partir do canto superior esquerdo do objeto</translation>
    </message>
    <message>
        <source>the outline is only %1 x %2 pixels; photograph the object from nearer</source>
        <translation>o contorno tem só %1 x %2 píxeis; fotografe o objeto de mais perto</translation>
    </message>
    <message>
        <source>a template needs a name</source>
        <translation>um ponto de referência precisa de um nome</translation>
    </message>
    <message>
        <source>this template is of kind %1, not %2; use another template name</source>
        <translation>este ponto de referência é do tipo %1, não %2; use outro nome</translation>
    </message>
    <message>
        <source>only %1 features were found in the picture; at least %2 are needed: take a sharp, well lit photograph of something with detail, from nearer</source>
        <translation>só se encontraram %1 características na imagem; são precisas pelo menos %2: tire uma fotografia nítida e bem iluminada de algo com pormenores, de mais perto</translation>
    </message>
    <message>
        <source>only %1 features were found inside the outline; at least %2 are needed: take a sharp, well lit photograph of something with detail, from nearer</source>
        <translation>só se encontraram %1 características dentro do contorno; são precisas pelo menos %2: tire uma fotografia nítida e bem iluminada de algo com pormenores, de mais perto</translation>
    </message>
    <message>
        <source>the photograph cannot be read as a picture</source>
        <translation>não se consegue ler a fotografia como imagem</translation>
    </message>
    <message>
        <source>the photograph cannot be used: %1</source>
        <translation>não se consegue usar a fotografia: %1</translation>
    </message>
    <message>
        <source>template %1</source>
        <translation>ponto de referência %1</translation>
    </message>
    <message>
        <source>%1, template %2</source>
        <translation>%1, ponto de referência %2</translation>
    </message>
    <message>
        <source>%1, view %2</source>
        <translation>%1, fotografia %2</translation>
    </message>
    <message>
        <source>%1, a view of template %2</source>
        <translation>%1, uma fotografia do ponto de referência %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, linha %2</translation>
    </message>
    <message>
        <source>cannot reopen for writing</source>
        <translation>não se consegue reabrir para escrever</translation>
    </message>
    <message>
        <source>cannot write to disk</source>
        <translation>não se consegue escrever no disco</translation>
    </message>
    <message>
        <source>cannot copy before saving</source>
        <translation>não se consegue fazer a cópia antes de guardar</translation>
    </message>
    <message>
        <source>cannot put the new file in place</source>
        <translation>não se consegue pôr o novo ficheiro no seu lugar</translation>
    </message>
    <message>
        <source>is no ordinary file; name another one</source>
        <translation>não é um ficheiro comum; indique outro</translation>
    </message>
    <message>
        <source>cannot open</source>
        <translation>não se conseguiu abrir</translation>
    </message>
    <message>
        <source>cannot read</source>
        <translation>não se consegue ler</translation>
    </message>
    <message>
        <source>cannot write</source>
        <translation>não se consegue escrever</translation>
    </message>
    <message>
        <source>cannot begin to write</source>
        <translation>não se consegue começar a escrever</translation>
    </message>
    <message>
        <source>cannot finish writing</source>
        <translation>não se consegue acabar de escrever</translation>
    </message>
    <message>
        <source>cannot create the file</source>
        <translation>não se consegue criar o ficheiro</translation>
    </message>
    <message>
        <source>this GDAL has no GeoPackage driver</source>
        <translation>este GDAL não sabe ler GeoPackage</translation>
    </message>
    <message>
        <source>the connection cannot be understood: write PG: and then key=value pairs such as dbname=campus host=maps user=anna, values with blanks in single quotes</source>
        <translation>não se entende a ligação: escreva PG: e depois pares chave=valor, como dbname=campus host=maps user=anna, com os valores que têm espaços entre plicas</translation>
    </message>
    <message>
        <source>%1; skipped (%2 so far)</source>
        <translation>%1; saltou-se (%2 até agora)</translation>
    </message>
    <message>
        <source>%1 cannot be read as a picture</source>
        <translation>%1: não se consegue ler como imagem</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>não existe essa pasta</translation>
    </message>
    <message>
        <source>is not a recording: it holds no recording.json</source>
        <translation>não é uma gravação: não contém recording.json</translation>
    </message>
    <message>
        <source>is not JSON</source>
        <translation>não é JSON</translation>
    </message>
    <message>
        <source>is not the header of a recording</source>
        <translation>não é o cabeçalho de uma gravação</translation>
    </message>
    <message>
        <source>was made by a later version of Farol (recording format %1, this program reads up to %2)</source>
        <translation>foi feita por uma versão posterior do Farol (formato de gravação %1; este programa lê até ao %2)</translation>
    </message>
    <message>
        <source>is neither a percept nor a command</source>
        <translation>não é uma observação nem um comando</translation>
    </message>
    <message>
        <source>is a file; a new or empty folder is wanted for a recording</source>
        <translation>é um ficheiro; para uma gravação quer-se uma pasta nova ou vazia</translation>
    </message>
    <message>
        <source>is not empty; choose a new folder, so that no recording is overwritten</source>
        <translation>não está vazia; escolha uma pasta nova, para que nenhuma gravação seja substituída</translation>
    </message>
    <message>
        <source>cannot create</source>
        <translation>não se consegue criar</translation>
    </message>
    <message>
        <source>cannot create the recording</source>
        <translation>não se consegue criar a gravação</translation>
    </message>
    <message>
        <source>cannot encode the picture</source>
        <translation>não se consegue codificar a imagem</translation>
    </message>
    <message>
        <source>the recording stopped (%1); the walk goes on</source>
        <translation>a gravação parou (%1); o percurso continua</translation>
    </message>
    <message>
        <source>the walk broke off: %1</source>
        <translation>o percurso interrompeu-se: %1</translation>
    </message>
    <message>
        <source>frame %1 could not be looked at: %2</source>
        <translation>não se conseguiu ver a imagem %1: %2</translation>
    </message>
    <message>
        <source>there is no source of pictures; open one first</source>
        <translation>não há fonte de imagens; abra uma primeiro</translation>
    </message>
    <message>
        <source>there is no map; open one first</source>
        <translation>não há mapa; abra um primeiro</translation>
    </message>
</context>
<context>
    <name>farol::Options</name>
    <message>
        <source>%1 needs a number above 0, not “%2”</source>
        <translation>%1 precisa de um número acima de 0, não “%2”</translation>
    </message>
    <message>
        <source>%1 needs a size such as 1280x800, not “%2”</source>
        <translation>%1 precisa de um tamanho como 1280x800, não “%2”</translation>
    </message>
    <message>
        <source>“%1” is not known; see --help</source>
        <translation>“%1” não é conhecido; veja --help</translation>
    </message>
</context>
<context>
    <name>farol::espeak</name>
    <message>
        <source>The data of the voice are missing: install espeak-ng-data.</source>
        <translation>Faltam os dados da voz: instale o pacote espeak-ng-data.</translation>
    </message>
    <message>
        <source>There is no sound device.</source>
        <translation>Não há dispositivo de som.</translation>
    </message>
    <message>
        <source>The sound device cannot play speech: choose another one.</source>
        <translation>O dispositivo de som não consegue reproduzir fala: escolha outro.</translation>
    </message>
    <message>
        <source>The sound device does not start.</source>
        <translation>O dispositivo de som não arranca.</translation>
    </message>
    <message>
        <source>The sound device stopped in the middle of a text.</source>
        <translation>O dispositivo de som parou a meio de um texto.</translation>
    </message>
    <message>
        <source>The voice cannot be loaded: choose another one.</source>
        <translation>Não foi possível carregar a voz: escolha outra.</translation>
    </message>
    <message>
        <source>The text could not be turned into sound.</source>
        <translation>Não foi possível transformar o texto em som.</translation>
    </message>
</context>
<context>
    <name>farol::ui::AccessDialog</name>
    <message>
        <source>Door or passage %1</source>
        <translation>Porta ou passagem %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What sort of passage it is</source>
        <translation>Que tipo de passagem é</translation>
    </message>
    <message>
        <source>Type part of a name, room number or level, then choose</source>
        <translation>Escreva parte de um nome, número de sala ou piso, e escolha</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Um lado</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Outro lado</translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>nos dois sentidos</translation>
    </message>
    <message>
        <source>from the one side to the other only</source>
        <translation>só do primeiro lado para o outro</translation>
    </message>
    <message>
        <source>from the other side to the one only</source>
        <translation>só do outro lado para o primeiro</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sentido</translation>
    </message>
    <message>
        <source>Which way one can pass</source>
        <translation>Em que sentido se pode passar</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>How wide the door is</source>
        <translation>Que largura tem a porta</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>não se sabe</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Degraus</translation>
    </message>
    <message>
        <source>How many steps the stairs have</source>
        <translation>Quantos degraus tem a escada</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Este</translation>
    </message>
    <message>
        <source>Place on the map, metres to the east</source>
        <translation>Lugar no mapa, metros para este</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Norte</translation>
    </message>
    <message>
        <source>Place on the map, metres to the north</source>
        <translation>Lugar no mapa, metros para norte</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fechada</translation>
    </message>
    <message>
        <source>Nobody can pass</source>
        <translation>Ninguém pode passar</translation>
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
        <translation>Atenção</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problema</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Fechar esta mensagem</translation>
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
        <translation>%1: encontrado em %2 de %3 vistas</translation>
    </message>
    <message numerus="yes">
        <source>%1 taken for %2: %n time(s)</source>
        <translation>
            <numerusform>%1 tomado por %2: %n vez</numerusform>
            <numerusform>%1 tomado por %2: %n vezes</numerusform>
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
        <translation>O visitante %1 chegou a %2 em %3. O próximo vem já a seguir.</translation>
    </message>
    <message>
        <source>Visitor %1 did not come to %2 and was fetched. The next one comes in a moment.</source>
        <translation>O visitante %1 não chegou a %2 e foram buscá-lo. O próximo vem já a seguir.</translation>
    </message>
    <message>
        <source>A simulated building and camera. Visitor %1 wants to go from %2 to %3 (%4 m) and hears only what is said. Choose another destination at any time.</source>
        <translation>Edifício e câmara simulados. O visitante %1 quer ir de %2 para %3 (%4 m) e só ouve o que é dito. Pode escolher outro destino a qualquer momento.</translation>
    </message>
    <message>
        <source>&amp;Demo</source>
        <translation>&amp;Demonstração</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Demonstração</translation>
    </message>
    <message>
        <source>&amp;Wrong turn</source>
        <translation>Caminho &amp;errado</translation>
    </message>
    <message>
        <source>Wrong turn</source>
        <translation>Caminho errado</translation>
    </message>
    <message>
        <source>The walker takes another way than was said</source>
        <translation>O visitante segue por outro lado do que foi dito</translation>
    </message>
    <message>
        <source>&amp;Cover the camera</source>
        <translation>&amp;Tapar a câmara</translation>
    </message>
    <message>
        <source>Cover camera</source>
        <translation>Tapar câmara</translation>
    </message>
    <message>
        <source>A hand lies on the simulated camera</source>
        <translation>Uma mão tapa a câmara simulada</translation>
    </message>
    <message>
        <source>&amp;Lights out</source>
        <translation>Apagar as &amp;luzes</translation>
    </message>
    <message>
        <source>Lights out</source>
        <translation>Apagar luzes</translation>
    </message>
    <message>
        <source>Nearly dark in the whole building</source>
        <translation>Quase às escuras em todo o edifício</translation>
    </message>
    <message>
        <source>&amp;Next visitor</source>
        <translation>&amp;Próximo visitante</translation>
    </message>
    <message>
        <source>Next visitor</source>
        <translation>Próximo visitante</translation>
    </message>
    <message>
        <source>End this walk; somebody else comes with another destination</source>
        <translation>Terminar este percurso; vem outra pessoa com outro destino</translation>
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
        <translation>não aceite</translation>
    </message>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Semelhança</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Onde</translation>
    </message>
</context>
<context>
    <name>farol::ui::DraftStore</name>
    <message>
        <source>what you are teaching cannot be kept on disk (%1); it would be lost with the program</source>
        <translation>o que está a ensinar não se consegue guardar no disco (%1); perder-se-ia com o programa</translation>
    </message>
    <message>
        <source>the folder for what you are teaching cannot be made; it would be lost with the program</source>
        <translation>não se consegue criar a pasta para o que está a ensinar; perder-se-ia com o programa</translation>
    </message>
</context>
<context>
    <name>farol::ui::EditTemplateDialog</name>
    <message>
        <source>Change “%1”</source>
        <translation>Alterar “%1”</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>não se sabe</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>What people call it</source>
        <translation>Como as pessoas lhe chamam</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>O que é</translation>
    </message>
    <message>
        <source>Real width</source>
        <translation>Largura real</translation>
    </message>
    <message>
        <source>Lets Farol tell how far away it is</source>
        <translation>Deixa o Farol saber a que distância está</translation>
    </message>
    <message>
        <source>Real height</source>
        <translation>Altura real</translation>
    </message>
    <message>
        <source>In maps called</source>
        <translation>Nome nos mapas</translation>
    </message>
    <message>
        <source>Landmarks of the map refer to it by this word: when it changes, change them too</source>
        <translation>Os pontos de referência do mapa usam esta palavra: se a mudar, mude-os também</translation>
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
        <translation>não se sabe</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeatureModel</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
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
        <translation>Piso</translation>
    </message>
    <message>
        <source>Area (m²)</source>
        <translation>Área (m²)</translation>
    </message>
    <message>
        <source>Doors</source>
        <translation>Portas</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Vizinhos</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Referências</translation>
    </message>
    <message>
        <source>Restricted</source>
        <translation>Reservado</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identificador</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Um lado</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Outro lado</translation>
    </message>
    <message>
        <source>Width (m)</source>
        <translation>Largura (m)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Degraus</translation>
    </message>
    <message>
        <source>One way</source>
        <translation>Sentido único</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fechada</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Caixa</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Espaço</translation>
    </message>
    <message>
        <source>Faces (°)</source>
        <translation>Virado a (°)</translation>
    </message>
    <message>
        <source>Height (m)</source>
        <translation>Altura (m)</translation>
    </message>
    <message>
        <source>Wide (m)</source>
        <translation>Largo (m)</translation>
    </message>
    <message>
        <source>Tall (m)</source>
        <translation>Alto (m)</translation>
    </message>
    <message>
        <source>Trained as</source>
        <translation>Aprendido como</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sim</translation>
    </message>
</context>
<context>
    <name>farol::ui::FeaturePanel</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n linha</numerusform>
            <numerusform>%n linhas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n row(s)</source>
        <translation>
            <numerusform>%1 de %n linha</numerusform>
            <numerusform>%1 de %n linhas</numerusform>
        </translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Espaços</translation>
    </message>
    <message>
        <source>Doors and passages</source>
        <translation>Portas e passagens</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Pontos de referência</translation>
    </message>
    <message>
        <source>What the table lists</source>
        <translation>O que a tabela mostra</translation>
    </message>
    <message>
        <source>Search the table</source>
        <translation>Procurar na tabela</translation>
    </message>
    <message>
        <source>Rows that hold every word typed (Ctrl+F)</source>
        <translation>Linhas que contêm todas as palavras escritas (Ctrl+F)</translation>
    </message>
    <message>
        <source>This level onl&amp;y</source>
        <translation>Só este p&amp;iso</translation>
    </message>
    <message>
        <source>This level only</source>
        <translation>Só este piso</translation>
    </message>
    <message>
        <source>List only what is on the level that the plan shows</source>
        <translation>Mostrar só o que está no piso que a planta mostra</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Atributos</translation>
    </message>
    <message>
        <source>Choose a row to see it on the plan; press Enter to change it</source>
        <translation>Escolha uma linha para a ver na planta; prima Enter para a alterar</translation>
    </message>
    <message>
        <source>No row has what is looked for.</source>
        <translation>Nenhuma linha tem o que se procura.</translation>
    </message>
    <message>
        <source>The map has none of these.</source>
        <translation>O mapa não tem nenhum destes.</translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>Não há nenhum mapa aberto.</translation>
    </message>
</context>
<context>
    <name>farol::ui::Figures</name>
    <message>
        <source>Votes over time</source>
        <translation>Votos ao longo do tempo</translation>
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
        <translation>Comece primeiro um percurso.</translation>
    </message>
    <message>
        <source>How long pictures took to understand</source>
        <translation>Quanto tempo levou a analisar as imagens</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>milissegundos</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>imagens</translation>
    </message>
    <message>
        <source>How sure, and how right</source>
        <translation>Quão certo, e quão correto</translation>
    </message>
    <message>
        <source>told confidence</source>
        <translation>confiança indicada</translation>
    </message>
    <message>
        <source>share that was right</source>
        <translation>parte que estava certa</translation>
    </message>
    <message>
        <source>The truth is known in simulated walks only: start the demonstration.</source>
        <translation>Só em percursos simulados se sabe a verdade: inicie a demonstração.</translation>
    </message>
    <message>
        <source>this walk</source>
        <translation>este percurso</translation>
    </message>
    <message>
        <source>From how far each landmark is found</source>
        <translation>De que distância se encontra cada ponto</translation>
    </message>
    <message>
        <source>landmarks</source>
        <translation>pontos de referência</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>Check the library on the Landmarks page first (F7); landmarks need a real size.</source>
        <translation>Verifique primeiro a biblioteca na página dos pontos de referência (F7); os pontos precisam do tamanho real.</translation>
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
        <translation>Que gráfico se mostra</translation>
    </message>
    <message>
        <source>&amp;Save as PNG or SVG…</source>
        <translation>&amp;Guardar como PNG ou SVG…</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Guardar o gráfico</translation>
    </message>
    <message>
        <source>Save the chart as a picture, or as a drawing that stays sharp</source>
        <translation>Guardar o gráfico como imagem, ou como desenho que fica nítido</translation>
    </message>
    <message>
        <source>Charts (%1)</source>
        <translation>Gráficos (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>Não é possível escrever %1. Escolha outra pasta.</translation>
    </message>
</context>
<context>
    <name>farol::ui::FindingModel</name>
    <message>
        <source>Error</source>
        <translation>Erro</translation>
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
            <numerusform>e mais %n</numerusform>
            <numerusform>e mais %n</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Rule: %1</source>
        <translation>Regra: %1</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>O que foi encontrado</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Quantos</translation>
    </message>
</context>
<context>
    <name>farol::ui::FloorModel</name>
    <message>
        <source>you are here</source>
        <translation>está aqui</translation>
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
        <translation>fechado</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Onde</translation>
    </message>
</context>
<context>
    <name>farol::ui::FloorPictures</name>
    <message>
        <source>The image lies where its file says.</source>
        <translation>A imagem está onde o seu ficheiro indica.</translation>
    </message>
    <message>
        <source>Now click where this point belongs on the map. Escape gives up.</source>
        <translation>Clique agora onde este ponto fica no mapa. Escape desiste.</translation>
    </message>
    <message>
        <source>Click a point of the image that you know on the map, a corner of the house, say. Escape leaves the image where it is.</source>
        <translation>Clique num ponto da imagem que conhece no mapa, um canto da casa, por exemplo. Escape deixa a imagem onde está.</translation>
    </message>
    <message>
        <source>Click a second point of the image, far from the first.</source>
        <translation>Clique num segundo ponto da imagem, longe do primeiro.</translation>
    </message>
    <message>
        <source>Placed. A third point straightens a skewed image; Escape ends.</source>
        <translation>Colocada. Um terceiro ponto endireita uma imagem torta; Escape termina.</translation>
    </message>
    <message>
        <source>That is beside the image. Click a point of the image.</source>
        <translation>Isso fica fora da imagem. Clique num ponto da imagem.</translation>
    </message>
    <message>
        <source>These points lie too near each other, or on one line. Click another one.</source>
        <translation>Estes pontos estão demasiado perto uns dos outros, ou numa só linha. Clique noutro.</translation>
    </message>
    <message>
        <source>The image is placed by three points.</source>
        <translation>A imagem está colocada por três pontos.</translation>
    </message>
    <message>
        <source>How strong the floor-plan image is</source>
        <translation>Com que força se vê a imagem da planta</translation>
    </message>
    <message>
        <source>Place by p&amp;oints</source>
        <translation>Colocar por p&amp;ontos</translation>
    </message>
    <message>
        <source>Place the image by points</source>
        <translation>Colocar a imagem por pontos</translation>
    </message>
    <message>
        <source>Click two or three points of the image and where they belong on the map</source>
        <translation>Clicar em dois ou três pontos da imagem e onde eles ficam no mapa</translation>
    </message>
    <message>
        <source>Take a&amp;way</source>
        <translation>Retira&amp;r</translation>
    </message>
    <message>
        <source>Take the image away</source>
        <translation>Retirar a imagem</translation>
    </message>
    <message>
        <source>The floor shows no image any more; its file stays</source>
        <translation>O piso deixa de mostrar a imagem; o ficheiro fica</translation>
    </message>
    <message>
        <source>Ima&amp;ge:</source>
        <translation>Ima&amp;gem:</translation>
    </message>
</context>
<context>
    <name>farol::ui::FramePanel</name>
    <message>
        <source>What the camera sees</source>
        <translation>O que a câmara vê</translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation>Imagem da câmara</translation>
    </message>
    <message>
        <source>The camera&apos;s picture, with what Farol recognised in it</source>
        <translation>A imagem da câmara, com o que o Farol reconheceu nela</translation>
    </message>
    <message>
        <source>Picture %1 at %2</source>
        <translation>Imagem %1, %2</translation>
    </message>
    <message>
        <source>Picture %1 at %2 (%3)</source>
        <translation>Imagem %1, %2 (%3)</translation>
    </message>
    <message>
        <source>understood in %1 ms</source>
        <translation>analisada em %1 ms</translation>
    </message>
    <message numerus="yes">
        <source>%n left out because late</source>
        <translation>
            <numerusform>%n omitida por atraso</numerusform>
            <numerusform>%n omitidas por atraso</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unreadable</source>
        <translation>
            <numerusform>%n ilegível</numerusform>
            <numerusform>%n ilegíveis</numerusform>
        </translation>
    </message>
    <message>
        <source>Time from the picture&apos;s arrival to the answer, and how many pictures had to be left out because Farol was still busy with an earlier one</source>
        <translation>Tempo desde a chegada da imagem até à resposta, e quantas imagens foram omitidas porque o Farol ainda estava ocupado com uma anterior</translation>
    </message>
</context>
<context>
    <name>farol::ui::FrameView</name>
    <message>
        <source>No picture yet</source>
        <translation>Ainda sem imagem</translation>
    </message>
    <message>
        <source>Nothing known is in the picture</source>
        <translation>Não há nada conhecido na imagem</translation>
    </message>
    <message>
        <source>In the picture: %1</source>
        <translation>Na imagem: %1</translation>
    </message>
    <message>
        <source>Spoken: %1</source>
        <translation>Dito: %1</translation>
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
        <translation>Ainda sem imagem.
Abra uma câmara, um vídeo ou uma pasta de imagens e depois prima Reproduzir.</translation>
    </message>
</context>
<context>
    <name>farol::ui::HelpDialog</name>
    <message>
        <source>Help</source>
        <translation>Ajuda</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Capítulos</translation>
    </message>
    <message>
        <source>What the help is about</source>
        <translation>De que trata a ajuda</translation>
    </message>
    <message>
        <source>Walk page</source>
        <translation>Página do percurso</translation>
    </message>
    <message>
        <source>Map page</source>
        <translation>Página do mapa</translation>
    </message>
    <message>
        <source>Landmarks page</source>
        <translation>Página dos pontos de referência</translation>
    </message>
    <message>
        <source>Kiosk</source>
        <translation>Quiosque</translation>
    </message>
    <message>
        <source>Text of the chapter</source>
        <translation>Texto do capítulo</translation>
    </message>
    <message>
        <source>Here a map of a building is opened or brought in, looked at, checked and changed. The plan and the table show the same: what is chosen in one is chosen in the other.</source>
        <translation>Aqui abre-se ou importa-se o mapa de um edifício, vê-se, verifica-se e altera-se. A planta e a tabela mostram o mesmo: o que se escolhe numa fica escolhido na outra.</translation>
    </message>
    <message>
        <source>F7 looks for what is wrong with the map and says what to do about each finding.</source>
        <translation>F7 procura o que está errado no mapa e diz o que fazer em cada caso.</translation>
    </message>
    <message>
        <source>Ctrl+U marks places that the landmarks cannot tell apart. A landmark there helps most.</source>
        <translation>Ctrl+U marca lugares que os pontos de referência não distinguem. Um ponto ali é o que mais ajuda.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L puts a landmark on the plan, Ctrl+Shift+D a door. Drag what is chosen, or move it with Alt and the arrows.</source>
        <translation>Ctrl+Shift+L põe um ponto de referência na planta, Ctrl+Shift+D uma porta. Arraste o que está escolhido, ou mova-o com Alt e as setas.</translation>
    </message>
    <message>
        <source>Ctrl+Z takes every step back. Nothing is written until you save with Ctrl+S.</source>
        <translation>Ctrl+Z anula cada passo. Nada é escrito antes de guardar com Ctrl+S.</translation>
    </message>
    <message>
        <source>Here Farol is taught what it shall know again. Every change is saved by itself and can be taken back with Ctrl+Z; a landmark that is not finished is kept, also when the computer stops.</source>
        <translation>Aqui ensina-se ao Farol o que deve reconhecer. Cada alteração guarda-se sozinha e anula-se com Ctrl+Z; um ponto por acabar é mantido, mesmo que o computador pare.</translation>
    </message>
    <message>
        <source>Ctrl+T teaches a landmark in four steps: what it is, its views, a trial, its place on the map.</source>
        <translation>Ctrl+T ensina um ponto de referência em quatro passos: o que é, as vistas, um ensaio, o lugar no mapa.</translation>
    </message>
    <message>
        <source>Take a view from the front, from the left, from the right and from farther away. The coach says what is wrong with a picture and which one comes next. Drag the four corners onto the landmark; by keys, 1 to 4 choose a corner and the arrows move it.</source>
        <translation>Tire uma vista de frente, da esquerda, da direita e de mais longe. Os conselhos dizem o que está mal numa imagem e qual vem a seguir. Arraste os quatro cantos para o ponto; com teclas, 1 a 4 escolhem um canto e as setas movem-no.</translation>
    </message>
    <message>
        <source>F7 checks the whole library: how well each landmark is found, how far away, how far aside, and which are taken for each other. Merge what is the same, and add views to what is lost.</source>
        <translation>F7 verifica a biblioteca toda: como cada ponto é encontrado, a que distância, de que lado, e quais se confundem. Junte o que é igual e acrescente vistas ao que se perde.</translation>
    </message>
    <message>
        <source>Here somebody is guided, and you watch: what the camera sees, the place on the map, what is said, and why.</source>
        <translation>Aqui alguém é guiado e você acompanha: o que a câmara vê, o lugar no mapa, o que é dito e porquê.</translation>
    </message>
    <message>
        <source>F5 starts and holds the walk, F8 goes on by one picture.</source>
        <translation>F5 começa e suspende o percurso, F8 avança uma imagem.</translation>
    </message>
    <message>
        <source>When the place shown is not right, choose the right one on the map and press Ctrl+H.</source>
        <translation>Quando o lugar mostrado não está certo, escolha o certo no mapa e prima Ctrl+H.</translation>
    </message>
    <message>
        <source>Ctrl+W gives the place up, so that it is looked for anew.</source>
        <translation>Ctrl+W abandona o lugar, para que seja procurado de novo.</translation>
    </message>
    <message>
        <source>Ctrl+E speaks a sentence that you type.</source>
        <translation>Ctrl+E diz uma frase que escreva.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R records the next walk. A recorded walk can be worked out anew in another way and compared, from the Walk menu.</source>
        <translation>Ctrl+Shift+R grava o próximo percurso. Um percurso gravado pode ser recalculado de outra forma e comparado, no menu Percurso.</translation>
    </message>
    <message>
        <source>The timeline at the bottom looks back: drag it, or use the arrow keys. “Why there” explains the vote of the place that is chosen in the list.</source>
        <translation>A linha do tempo, em baixo, olha para trás: arraste-a, ou use as setas. “Porquê ali” explica o voto do lugar escolhido na lista.</translation>
    </message>
    <message>
        <source>Ctrl+O opens the map of the building.</source>
        <translation>Ctrl+O abre o mapa do edifício.</translation>
    </message>
    <message>
        <source>Ctrl+L opens the landmarks that belong to it.</source>
        <translation>Ctrl+L abre os pontos de referência que lhe pertencem.</translation>
    </message>
    <message>
        <source>Ctrl+P chooses a camera, a video or a folder of pictures, and Ctrl+G where to go.</source>
        <translation>Ctrl+P escolhe uma câmara, um vídeo ou uma pasta de imagens, e Ctrl+G o destino.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+U marks from where no landmark is seen, and Ctrl+Shift+N lists the routes that are missing. Ctrl+Shift+I lays the image of a floor plan under the floor: click two points of it and where they belong.</source>
        <translation>Ctrl+Shift+U marca de onde não se vê nenhum ponto de referência, e Ctrl+Shift+N lista os caminhos que faltam. Ctrl+Shift+I põe a imagem de uma planta sob o piso: clique em dois pontos dela e onde eles ficam.</translation>
    </message>
    <message>
        <source>The kiosk is for a blind user who is alone: “farol --kiosk” fills the screen and says everything. Arrows and Enter choose a destination, F searches by name, digits by number; F1 says all keys, Escape goes back.</source>
        <translation>O quiosque é para um utilizador cego sozinho: “farol --kiosk” enche o ecrã e diz tudo. As setas e Enter escolhem o destino, F procura pelo nome, os algarismos pelo número; F1 diz todas as teclas, Escape volta atrás.</translation>
    </message>
</context>
<context>
    <name>farol::ui::HistoryModel</name>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Onde</translation>
    </message>
</context>
<context>
    <name>farol::ui::ImportDialog</name>
    <message>
        <source>Import a map</source>
        <translation>Importar um mapa</translation>
    </message>
    <message>
        <source>A file, a folder or a zip: IMDF, OpenStreetMap indoor, IndoorGML, per-floor Shapefiles, GeoJSON, GeoPackage, HULOP, WRLD. What is found wrong is told afterwards; nothing is written until you save.</source>
        <translation>Um ficheiro, uma pasta ou um zip: IMDF, OpenStreetMap interior, IndoorGML, Shapefiles por piso, GeoJSON, GeoPackage, HULOP, WRLD. O que estiver errado é dito depois; nada é escrito até guardar.</translation>
    </message>
    <message>
        <source>&amp;File…</source>
        <translation>&amp;Ficheiro…</translation>
    </message>
    <message>
        <source>Fol&amp;der…</source>
        <translation>&amp;Pasta…</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Escolher um ficheiro</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Escolher uma pasta</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>pelo conteúdo</translation>
    </message>
    <message>
        <source>as the format has it</source>
        <translation>como o formato o diz</translation>
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
        <translation>Caminho do ficheiro, pasta ou zip</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Of which kind the map is</source>
        <translation>De que tipo é o mapa</translation>
    </message>
    <message>
        <source>Language of names</source>
        <translation>Língua dos nomes</translation>
    </message>
    <message>
        <source>Which of several names is taken, such as en or pt</source>
        <translation>Qual de vários nomes se usa, como en ou pt</translation>
    </message>
    <message>
        <source>Where the map leaves it open: filename, z, or the name of a column</source>
        <translation>Onde o mapa o deixa em aberto: filename, z, ou o nome de uma coluna</translation>
    </message>
    <message>
        <source>A file with other names of columns and codes</source>
        <translation>Um ficheiro com outros nomes de colunas e códigos</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importar</translation>
    </message>
    <message>
        <source>none is needed</source>
        <translation>não é preciso</translation>
    </message>
    <message>
        <source>Where the level is</source>
        <translation>Onde está o piso</translation>
    </message>
    <message>
        <source>File of other names</source>
        <translation>Ficheiro de outros nomes</translation>
    </message>
</context>
<context>
    <name>farol::ui::InstructionPanel</name>
    <message>
        <source>No destination chosen: places are told, no route.</source>
        <translation>Sem destino escolhido: são ditos os lugares, sem percurso.</translation>
    </message>
    <message>
        <source>The route follows as soon as it is known where you are.</source>
        <translation>O percurso aparece assim que se souber onde está.</translation>
    </message>
    <message>
        <source>There is no way to the destination. %1</source>
        <translation>Não há caminho para o destino. %1</translation>
    </message>
    <message>
        <source>At the destination.</source>
        <translation>No destino.</translation>
    </message>
    <message>
        <source>On the way to %1</source>
        <translation>A caminho de: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n more place(s) to pass</source>
        <translation>
            <numerusform>falta passar por %n lugar</numerusform>
            <numerusform>falta passar por %n lugares</numerusform>
        </translation>
    </message>
    <message>
        <source>next in %1 m</source>
        <translation>seguinte a %1 m</translation>
    </message>
    <message>
        <source>%1 m to go</source>
        <translation>faltam %1 m</translation>
    </message>
    <message>
        <source>Off the route</source>
        <translation>Fora do percurso</translation>
    </message>
    <message>
        <source>Next instruction</source>
        <translation>Próxima instrução</translation>
    </message>
    <message>
        <source>Open a map to begin.</source>
        <translation>Abra um mapa para começar.</translation>
    </message>
    <message>
        <source>Ready. Press Play to start the walk.</source>
        <translation>Pronto. Prima Reproduzir para iniciar o percurso.</translation>
    </message>
    <message>
        <source>Looking around…</source>
        <translation>A olhar em volta…</translation>
    </message>
    <message>
        <source>Next instruction: %1</source>
        <translation>Próxima instrução: %1</translation>
    </message>
    <message>
        <source>No sound: %1</source>
        <translation>Sem som: %1</translation>
    </message>
    <message>
        <source>Said at %1</source>
        <translation>Dito em %1</translation>
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
        <translation>Setas</translation>
    </message>
    <message>
        <source>In the map: move it</source>
        <translation>No mapa: movê-lo</translation>
    </message>
    <message>
        <source>In the map: larger, smaller, whole floor</source>
        <translation>No mapa: maior, menor, piso inteiro</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Page Up, Page Down</translation>
    </message>
    <message>
        <source>In the map: the floor above, the floor below</source>
        <translation>No mapa: o piso acima, o piso abaixo</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>The next button or list</source>
        <translation>O botão ou lista seguinte</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Tecla</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>O que faz</translation>
    </message>
    <message>
        <source>Alt + Arrows</source>
        <translation>Alt + setas</translation>
    </message>
    <message>
        <source>In the plan: move what is chosen by 10 cm, with Shift by 1 m</source>
        <translation>Na planta: mover o escolhido 10 cm, com Shift 1 m</translation>
    </message>
</context>
<context>
    <name>farol::ui::Kiosk</name>
    <message>
        <source>No map was given (farol --kiosk --map FILE).</source>
        <translation>Não foi indicado um mapa (farol --kiosk --map FICHEIRO).</translation>
    </message>
    <message>
        <source>The landmarks cannot be loaded: I will hardly know where you are. Ask for help.</source>
        <translation>Não consigo carregar os pontos de referência: dificilmente saberei onde está. Peça ajuda.</translation>
    </message>
    <message>
        <source>The destination cannot be kept for a restart: the folder cannot be written.</source>
        <translation>O destino não pode ser guardado para um reinício: não é possível escrever na pasta.</translation>
    </message>
    <message>
        <source>The chosen voice does not work. This is another one.</source>
        <translation>A voz escolhida não funciona. Esta é outra.</translation>
    </message>
    <message>
        <source>The map has been changed. The new one is used after this way.</source>
        <translation>O mapa foi alterado. O novo é usado depois deste percurso.</translation>
    </message>
    <message>
        <source>The file of the map is gone. I keep the map that I have.</source>
        <translation>O ficheiro do mapa desapareceu. Mantenho o mapa que tenho.</translation>
    </message>
    <message>
        <source>The new map cannot be opened. I keep the old one.</source>
        <translation>O novo mapa não pode ser aberto. Fico com o anterior.</translation>
    </message>
    <message>
        <source>Another Farol kiosk of this user is running.</source>
        <translation>Já está a funcionar outro Farol deste utilizador.</translation>
    </message>
    <message>
        <source>Farol is already running here. I close this one. Goodbye.</source>
        <translation>O Farol já está a funcionar aqui. Fecho este. Até à próxima.</translation>
    </message>
    <message>
        <source>The map has been changed, and I use the new one.</source>
        <translation>O mapa foi alterado, e uso o novo.</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskMachine</name>
    <message>
        <source>One moment.</source>
        <translation>Um momento.</translation>
    </message>
    <message>
        <source>Farol. I am opening the map.</source>
        <translation>Farol. Estou a abrir o mapa.</translation>
    </message>
    <message>
        <source>The new map cannot be opened. I keep the old one.</source>
        <translation>O novo mapa não pode ser aberto. Fico com o anterior.</translation>
    </message>
    <message>
        <source>Farol was interrupted and has started again.</source>
        <translation>O Farol foi interrompido e começou de novo.</translation>
    </message>
    <message>
        <source>You were last here: %1.</source>
        <translation>A última posição foi: %1.</translation>
    </message>
    <message>
        <source>The camera works again.</source>
        <translation>A câmara voltou a funcionar.</translation>
    </message>
    <message>
        <source>Stop, and turn slowly to the right, so that I can look around.</source>
        <translation>Pare e vire-se devagar para a direita, para eu poder olhar em volta.</translation>
    </message>
    <message>
        <source>No destination is chosen yet. Choose one first.</source>
        <translation>Ainda não escolheu um destino. Escolha um primeiro.</translation>
    </message>
    <message>
        <source>This is the first place.</source>
        <translation>Este é o primeiro lugar.</translation>
    </message>
    <message>
        <source>This is the last place.</source>
        <translation>Este é o último lugar.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s). %2.</source>
        <extracomment>%1 &quot;Rooms&quot;, %2 the first of them</extracomment>
        <translation>
            <numerusform>%1: %n lugar. %2.</numerusform>
            <numerusform>%1: %n lugares. %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Type part of a name or a number, then press Enter.</source>
        <translation>Escreva parte de um nome ou número e prima Enter.</translation>
    </message>
    <message>
        <source>space</source>
        <translation>espaço</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s).</source>
        <comment>while typing</comment>
        <extracomment>%1 the letter just typed</extracomment>
        <translation>
            <numerusform>%1: %n lugar.</numerusform>
            <numerusform>%1: %n lugares.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is typed.</source>
        <translation>Nada foi escrito.</translation>
    </message>
    <message>
        <source>Deleted: %1. %2</source>
        <translation>Apagado: %1. %2</translation>
    </message>
    <message>
        <source>%1 %2. Enter: go there. Arrow down: next.</source>
        <translation>%1 %2. Enter: ir para lá. Seta para baixo: seguinte.</translation>
    </message>
    <message>
        <source>Nothing is chosen yet. Press arrow down to hear the places.</source>
        <translation>Ainda nada foi escolhido. Prima a seta para baixo para ouvir os lugares.</translation>
    </message>
    <message>
        <source>I try the camera again.</source>
        <translation>Vou tentar a câmara outra vez.</translation>
    </message>
    <message>
        <source>Going on. %1</source>
        <translation>Continuo. %1</translation>
    </message>
    <message>
        <source>This key does nothing. Escape: back.</source>
        <translation>Esta tecla não faz nada. Escape: voltar.</translation>
    </message>
    <message>
        <source>Back to the kinds of places.</source>
        <translation>Voltar aos tipos de lugares.</translation>
    </message>
    <message>
        <source>Leave Farol.</source>
        <translation>Sair do Farol.</translation>
    </message>
    <message>
        <source>Start.</source>
        <translation>Começar.</translation>
    </message>
    <message>
        <source>Hear the whole way.</source>
        <translation>Ouvir o caminho todo.</translation>
    </message>
    <message>
        <source>Another place.</source>
        <translation>Outro lugar.</translation>
    </message>
    <message>
        <source>Try the camera again.</source>
        <translation>Tentar a câmara outra vez.</translation>
    </message>
    <message>
        <source>Stop the guidance.</source>
        <translation>Parar a orientação.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Escolher outro lugar.</translation>
    </message>
    <message>
        <source>Yes, stop.</source>
        <translation>Sim, parar.</translation>
    </message>
    <message>
        <source>No, go on.</source>
        <translation>Não, continuar.</translation>
    </message>
    <message>
        <source>Yes, leave.</source>
        <translation>Sim, sair.</translation>
    </message>
    <message>
        <source>No, stay.</source>
        <translation>Não, ficar.</translation>
    </message>
    <message>
        <source>Press space to hear what there is, then Enter.</source>
        <translation>Prima espaço para ouvir o que há e depois Enter.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n place(s). Space: first place.</source>
        <translation>
            <numerusform>%1: %n lugar. Espaço: primeiro lugar.</numerusform>
            <numerusform>%1: %n lugares. Espaço: primeiro lugar.</numerusform>
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
            <numerusform>Escolha um destino: %n lugar.</numerusform>
            <numerusform>Escolha um destino: %n lugares.</numerusform>
        </translation>
    </message>
    <message>
        <source>Space: next. Enter: take it.</source>
        <translation>Espaço: seguinte. Enter: escolher.</translation>
    </message>
    <message>
        <source>Arrow down: first place. F: type a name. F1: all keys.</source>
        <translation>Seta para baixo: primeiro lugar. F: escrever um nome. F1: todas as teclas.</translation>
    </message>
    <message>
        <source>To: %1.</source>
        <translation>Destino: %1.</translation>
    </message>
    <message>
        <source>I do not know yet where you are, and look for it on the way.</source>
        <translation>Ainda não sei onde está e vou procurar pelo caminho.</translation>
    </message>
    <message>
        <source>Space: choices.</source>
        <translation>Espaço: opções.</translation>
    </message>
    <message>
        <source>Enter: start. L: the whole way. Escape: another place.</source>
        <translation>Enter: começar. L: o caminho todo. Escape: outro lugar.</translation>
    </message>
    <message>
        <source>Stop the guidance?</source>
        <translation>Parar a orientação?</translation>
    </message>
    <message>
        <source>Leave Farol?</source>
        <translation>Sair do Farol?</translation>
    </message>
    <message>
        <source>Enter or Escape: yes. Any other key: no.</source>
        <translation>Enter ou Escape: sim. Qualquer outra tecla: não.</translation>
    </message>
    <message>
        <source>No camera is set up, and I cannot guide you. Ask for help.</source>
        <translation>Não há câmara configurada e não posso orientar. Peça ajuda.</translation>
    </message>
    <message>
        <source>The camera is starting.</source>
        <translation>A câmara está a começar.</translation>
    </message>
    <message>
        <source>Stop. The camera gives no pictures, and I cannot guide you. Enter: try again.</source>
        <translation>Pare. A câmara não dá imagens e não posso orientar. Enter: tentar outra vez.</translation>
    </message>
    <message>
        <source>The camera gives no pictures. I try it again when you start.</source>
        <translation>A câmara não dá imagens. Tento outra vez quando começar.</translation>
    </message>
    <message>
        <source>No place fits: %1. Delete letters, or press Escape.</source>
        <translation>Nenhum lugar corresponde: %1. Apague letras ou prima Escape.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) fit: %1.</source>
        <translation>
            <numerusform>%n lugar corresponde: %1.</numerusform>
            <numerusform>%n lugares correspondem: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>This map has no places to go to. Ask for help.</source>
        <translation>Este mapa não tem lugares aonde ir. Peça ajuda.</translation>
    </message>
    <message>
        <source>The map cannot be opened. Ask for help.</source>
        <translation>O mapa não pode ser aberto. Peça ajuda.</translation>
    </message>
    <message>
        <source>The map is being opened. Please wait.</source>
        <translation>O mapa está a ser aberto. Aguarde.</translation>
    </message>
    <message>
        <source>On the way to: %1.</source>
        <translation>A caminho de: %1.</translation>
    </message>
    <message>
        <source>You have arrived: %1. Enter: another destination.</source>
        <translation>Chegou: %1. Enter: outro destino.</translation>
    </message>
    <message>
        <source>You have probably arrived: %1. Enter: another destination.</source>
        <translation>Provavelmente chegou ao destino: %1. Enter: outro destino.</translation>
    </message>
    <message>
        <source>Goodbye.</source>
        <translation>Adeus.</translation>
    </message>
    <message>
        <source>Quiet: I tell only warnings and what you ask. M: speak again.</source>
        <translation>Silêncio: digo só avisos e o que perguntar. M: voltar a falar.</translation>
    </message>
    <message>
        <source>I tell everything again.</source>
        <translation>Volto a dizer tudo.</translation>
    </message>
    <message>
        <source>Speed %1 of %2.</source>
        <translation>Velocidade %1 de %2.</translation>
    </message>
    <message>
        <source>I speak English now.</source>
        <translation>Falo português agora.</translation>
    </message>
    <message>
        <source>Two keys: space goes through the choices, Enter takes one. F4: all keys again.</source>
        <translation>Duas teclas: espaço percorre as opções, Enter escolhe. F4: outra vez todas as teclas.</translation>
    </message>
    <message>
        <source>All keys are in use again.</source>
        <translation>Todas as teclas voltam a funcionar.</translation>
    </message>
    <message>
        <source>Farol</source>
        <translation>Farol</translation>
    </message>
    <message>
        <source>Where to? %1</source>
        <translation>Para onde? %1</translation>
    </message>
    <message>
        <source>Search: %1</source>
        <translation>Procura: %1</translation>
    </message>
    <message>
        <source>The way to %1</source>
        <translation>Caminho: %1</translation>
    </message>
    <message>
        <source>Walking to %1</source>
        <translation>A caminho: %1</translation>
    </message>
    <message>
        <source>Arrived</source>
        <translation>Chegou</translation>
    </message>
    <message>
        <source>Probably arrived</source>
        <translation>Provavelmente chegou</translation>
    </message>
    <message>
        <source>Stop?</source>
        <translation>Parar?</translation>
    </message>
    <message>
        <source>Leave?</source>
        <translation>Sair?</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Goodbye</source>
        <translation>Adeus</translation>
    </message>
    <message>
        <source>Space: next   Enter: take   F4: all keys</source>
        <translation>Espaço: seguinte   Enter: escolher   F4: teclas</translation>
    </message>
    <message>
        <source>Arrows: places   Enter: go   F: search   F1: keys</source>
        <translation>Setas: lugares   Enter: ir   F: procurar   F1: teclas</translation>
    </message>
    <message>
        <source>Enter: done   Esc: back</source>
        <translation>Enter: feito   Esc: voltar</translation>
    </message>
    <message>
        <source>Enter: start   L: whole way   Esc: back</source>
        <translation>Enter: começar   L: caminho todo   Esc: voltar</translation>
    </message>
    <message>
        <source>Space: again   W: where am I   Esc: stop</source>
        <translation>Espaço: repetir   W: onde estou   Esc: parar</translation>
    </message>
    <message>
        <source>Enter: another destination</source>
        <translation>Enter: outro destino</translation>
    </message>
    <message>
        <source>Enter: yes   any other key: no</source>
        <translation>Enter: sim   outra tecla: não</translation>
    </message>
    <message>
        <source>Esc: back   F1: number pad</source>
        <translation>Esc: voltar   F1: teclado numérico</translation>
    </message>
    <message>
        <source>Esc: leave   F1: keys</source>
        <translation>Esc: sair   F1: teclas</translation>
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
        <translation>Farol, orientação</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskPlaces</name>
    <message>
        <source>All places</source>
        <translation>Todos os lugares</translation>
    </message>
    <message>
        <source>Rooms</source>
        <translation>Salas</translation>
    </message>
    <message>
        <source>Toilets</source>
        <translation>Casas de banho</translation>
    </message>
    <message>
        <source>Halls</source>
        <translation>Átrios</translation>
    </message>
    <message>
        <source>Corridors</source>
        <translation>Corredores</translation>
    </message>
    <message>
        <source>Lifts</source>
        <translation>Elevadores</translation>
    </message>
    <message>
        <source>Stairs</source>
        <translation>Escadas</translation>
    </message>
    <message>
        <source>Ways out</source>
        <translation>Saídas</translation>
    </message>
    <message>
        <source>Other places</source>
        <translation>Outros lugares</translation>
    </message>
</context>
<context>
    <name>farol::ui::KioskWords</name>
    <message>
        <source>Arrow up</source>
        <translation>Seta para cima</translation>
    </message>
    <message>
        <source>Arrow down</source>
        <translation>Seta para baixo</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Tecla Home</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Tecla End</translation>
    </message>
    <message>
        <source>Arrow left</source>
        <translation>Seta para a esquerda</translation>
    </message>
    <message>
        <source>Arrow right</source>
        <translation>Seta para a direita</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Tecla Enter</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Tecla Escape</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espaço</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Mais</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>Menos</translation>
    </message>
    <message>
        <source>the place before</source>
        <translation>o lugar anterior</translation>
    </message>
    <message>
        <source>the next place</source>
        <translation>o lugar seguinte</translation>
    </message>
    <message>
        <source>the first place</source>
        <translation>o primeiro lugar</translation>
    </message>
    <message>
        <source>the last place</source>
        <translation>o último lugar</translation>
    </message>
    <message>
        <source>another kind of places, back</source>
        <translation>outro tipo de lugares, para trás</translation>
    </message>
    <message>
        <source>another kind of places, on</source>
        <translation>outro tipo de lugares, para a frente</translation>
    </message>
    <message>
        <source>choose, start</source>
        <translation>escolher, começar</translation>
    </message>
    <message>
        <source>back; hold it down to leave</source>
        <translation>voltar; manter premida para sair</translation>
    </message>
    <message>
        <source>say again</source>
        <translation>dizer outra vez</translation>
    </message>
    <message>
        <source>where am I</source>
        <translation>onde estou</translation>
    </message>
    <message>
        <source>what is around me</source>
        <translation>o que há à minha volta</translation>
    </message>
    <message>
        <source>what comes next</source>
        <translation>o que vem a seguir</translation>
    </message>
    <message>
        <source>the whole way</source>
        <translation>o caminho todo</translation>
    </message>
    <message>
        <source>look around</source>
        <translation>olhar em volta</translation>
    </message>
    <message>
        <source>quiet, or speak again</source>
        <translation>silêncio, ou voltar a falar</translation>
    </message>
    <message>
        <source>speak faster</source>
        <translation>falar mais depressa</translation>
    </message>
    <message>
        <source>speak slower</source>
        <translation>falar mais devagar</translation>
    </message>
    <message>
        <source>how much I tell</source>
        <translation>quanto digo</translation>
    </message>
    <message>
        <source>how I tell directions</source>
        <translation>como digo as direções</translation>
    </message>
    <message>
        <source>metres, feet or steps</source>
        <translation>metros, pés ou passos</translation>
    </message>
    <message>
        <source>search a place by typing</source>
        <translation>procurar um lugar escrevendo</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>as teclas</translation>
    </message>
    <message>
        <source>everything with two keys</source>
        <translation>tudo com duas teclas</translation>
    </message>
    <message>
        <source>Keys. Press one to hear what it does; F1: number pad; Escape: back.</source>
        <translation>Teclas. Prima uma para ouvir o que faz; F1: teclado numérico; Escape: voltar.</translation>
    </message>
    <message>
        <source>Number pad. 8 and 2: up and down. 4 and 6: left and right. 5 or Enter: choose. 0: say again. 1: where am I. 3: around me. 7: what comes next. 9: the whole way. Plus and minus: speed. Star: keys. Slash: quiet. Point: back.</source>
        <translation>Teclado numérico. 8 e 2: para cima e para baixo. 4 e 6: esquerda e direita. 5 ou Enter: escolher. 0: dizer outra vez. 1: onde estou. 3: à minha volta. 7: o que vem a seguir. 9: o caminho todo. Mais e menos: velocidade. Asterisco: teclas. Barra: silêncio. Ponto: voltar.</translation>
    </message>
    <message>
        <source>This key does nothing here. F1: all keys.</source>
        <translation>Esta tecla não faz nada aqui. F1: todas as teclas.</translation>
    </message>
    <message>
        <source>I tell directions only.</source>
        <translation>Digo só as direções.</translation>
    </message>
    <message>
        <source>I tell directions and objects.</source>
        <translation>Digo direções e objetos.</translation>
    </message>
    <message>
        <source>I tell directions, objects and texts.</source>
        <translation>Digo direções, objetos e textos.</translation>
    </message>
    <message>
        <source>Directions as left and right.</source>
        <translation>Direções como esquerda e direita.</translation>
    </message>
    <message>
        <source>Directions as on a clock.</source>
        <translation>Direções como num relógio.</translation>
    </message>
    <message>
        <source>Directions in degrees.</source>
        <translation>Direções em graus.</translation>
    </message>
    <message>
        <source>Distances in metres.</source>
        <translation>Distâncias em metros.</translation>
    </message>
    <message>
        <source>Distances in feet.</source>
        <translation>Distâncias em pés.</translation>
    </message>
    <message>
        <source>Distances in steps.</source>
        <translation>Distâncias em passos.</translation>
    </message>
    <message>
        <source>another language</source>
        <translation>outro idioma</translation>
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
        <translation>Ponto de referência %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>O que é</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>What can be read on it</source>
        <translation>O que nele se lê</translation>
    </message>
    <message>
        <source>Trained as</source>
        <translation>Aprendido como</translation>
    </message>
    <message>
        <source>The name under which its appearance was trained</source>
        <translation>O nome com que o seu aspeto foi aprendido</translation>
    </message>
    <message>
        <source>any</source>
        <translation>qualquer</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Virado a</translation>
    </message>
    <message>
        <source>The way it faces: 0 is east, 90 north, 180 west, 270 south</source>
        <translation>Para onde está virado: 0 é este, 90 norte, 180 oeste, 270 sul</translation>
    </message>
    <message>
        <source>Height above the floor</source>
        <translation>Altura acima do chão</translation>
    </message>
    <message>
        <source>Of its middle</source>
        <translation>Do seu meio</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>How wide it is: its distance is told from that</source>
        <translation>Que largura tem: dela se calcula a distância</translation>
    </message>
    <message>
        <source>Its own height</source>
        <translation>Altura própria</translation>
    </message>
    <message>
        <source>How tall it is</source>
        <translation>Que altura tem</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Este</translation>
    </message>
    <message>
        <source>Place on the map, metres to the east</source>
        <translation>Lugar no mapa, metros para este</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Norte</translation>
    </message>
    <message>
        <source>Place on the map, metres to the north</source>
        <translation>Lugar no mapa, metros para norte</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryDocument</name>
    <message>
        <source>The library was changed meanwhile; try again.</source>
        <translation>Entretanto a biblioteca mudou; tente outra vez.</translation>
    </message>
    <message>
        <source>another program is writing this library; try again</source>
        <translation>outro programa está a escrever nesta biblioteca; tente de novo</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryModel</name>
    <message>
        <source>not known</source>
        <translation>não se sabe</translation>
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
        <translation>por verificar</translation>
    </message>
    <message>
        <source>In maps called “%1”</source>
        <translation>Nos mapas chama-se “%1”</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Ponto de referência</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Real size</source>
        <translation>Tamanho real</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>How well it is found</source>
        <translation>Como é encontrado</translation>
    </message>
</context>
<context>
    <name>farol::ui::LibraryPanel</name>
    <message>
        <source>Nothing is chosen</source>
        <translation>Nada está escolhido</translation>
    </message>
    <message>
        <source>Not checked yet. “Check all” looks how well each landmark is found.</source>
        <translation>Ainda por verificar. “Verificar tudo” mede como cada ponto é encontrado.</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>Each view is held back once and looked for with the others; then each landmark is shown smaller and turned.</source>
        <translation>Cada vista é retirada uma vez e procurada com as outras; depois cada ponto é mostrado mais pequeno e rodado.</translation>
    </message>
    <message>
        <source>Not checked yet. “Check all” looks how well each landmark is found, and which are taken for each other.</source>
        <translation>Ainda por verificar. “Verificar tudo” mede como cada ponto é encontrado e quais se confundem.</translation>
    </message>
    <message>
        <source>All landmarks are found well.</source>
        <translation>Todos os pontos de referência se encontram bem.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s) need care.</source>
        <translation>
            <numerusform>%n ponto de referência precisa de atenção.</numerusform>
            <numerusform>%n pontos de referência precisam de atenção.</numerusform>
        </translation>
    </message>
    <message>
        <source>None is taken for another.</source>
        <translation>Nenhum é tomado por outro.</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) are taken for each other.</source>
        <translation>
            <numerusform>%n par confunde-se.</numerusform>
            <numerusform>%n pares confundem-se.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rows: whose picture was shown. Columns: what was seen in it. On the diagonal: views found again.</source>
        <translation>Linhas: de quem é a imagem mostrada. Colunas: o que nela se viu. Na diagonal: vistas reencontradas.</translation>
    </message>
    <message>
        <source>The library was changed since: check again.</source>
        <translation>A biblioteca mudou desde então: verifique outra vez.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>%n ponto de referência</numerusform>
            <numerusform>%n pontos de referência</numerusform>
        </translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Pontos de referência</translation>
    </message>
    <message>
        <source>This library is empty. “Teach” begins with the first landmark.</source>
        <translation>Esta biblioteca está vazia. “Ensinar” começa pelo primeiro ponto de referência.</translation>
    </message>
    <message>
        <source>Open a landmark library, or make a new one, to teach Farol what it shall know again.</source>
        <translation>Abra uma biblioteca de pontos de referência, ou crie uma, para ensinar ao Farol o que deve reconhecer.</translation>
    </message>
    <message>
        <source>Landmarks of the library</source>
        <translation>Pontos de referência da biblioteca</translation>
    </message>
    <message>
        <source>The landmarks that Farol was taught; press Enter to add views to one</source>
        <translation>Os pontos ensinados ao Farol; Enter junta vistas a um deles</translation>
    </message>
    <message>
        <source>Views of the landmark</source>
        <translation>Vistas do ponto de referência</translation>
    </message>
    <message>
        <source>The photographs it is learnt from; choose some of them to split or to delete them</source>
        <translation>As fotografias de que é aprendido; escolha algumas para as separar ou eliminar</translation>
    </message>
    <message>
        <source>&amp;Views:</source>
        <translation>&amp;Vistas:</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Ponto de referência</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Pormenores</translation>
    </message>
    <message>
        <source>C&amp;heck all</source>
        <translation>&amp;Verificar tudo</translation>
    </message>
    <message>
        <source>Check all landmarks</source>
        <translation>Verificar todos os pontos de referência</translation>
    </message>
    <message>
        <source>Look how well each landmark is found and which are taken for each other</source>
        <translation>Medir como cada ponto é encontrado e quais se confundem</translation>
    </message>
    <message>
        <source>Save as CS&amp;V…</source>
        <translation>Guardar como C&amp;SV…</translation>
    </message>
    <message>
        <source>Save the report as CSV</source>
        <translation>Guardar o relatório como CSV</translation>
    </message>
    <message>
        <source>Save the report for a spreadsheet</source>
        <translation>Guardar o relatório para uma folha de cálculo</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Progresso da verificação</translation>
    </message>
    <message>
        <source>Who is taken for whom</source>
        <translation>Quem é tomado por quem</translation>
    </message>
    <message>
        <source>Rows: whose picture was shown. Columns: what was seen in it.</source>
        <translation>Linhas: de quem é a imagem mostrada. Colunas: o que nela se viu.</translation>
    </message>
    <message>
        <source>All that have several views are found well.</source>
        <translation>Todos os que têm várias vistas se encontram bem.</translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s) cannot be tried: there is only one view. Add another.</source>
        <translation>
            <numerusform>%n ponto de referência não pode ser experimentado: só tem uma vista. Junte outra.</numerusform>
            <numerusform>%n pontos de referência não podem ser experimentados: só têm uma vista. Junte outra.</numerusform>
        </translation>
    </message>
    <message>
        <source>The photographs of the chosen landmark are shown here.</source>
        <translation>Aqui mostram-se as fotografias do ponto escolhido.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LivePage</name>
    <message>
        <source>What was said</source>
        <translation>O que foi dito</translation>
    </message>
    <message>
        <source>Where it could be</source>
        <translation>Onde pode ser</translation>
    </message>
    <message>
        <source>Every sentence, when it was due, and what became of it</source>
        <translation>Cada frase, quando era devida e o que lhe aconteceu</translation>
    </message>
    <message>
        <source>The places that fit what was seen, best first</source>
        <translation>Os lugares que condizem com o que foi visto, o melhor primeiro</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Visto por último</translation>
    </message>
    <message>
        <source>The last objects that the place is worked out from</source>
        <translation>Os últimos objetos a partir dos quais se determina o lugar</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>Na imagem</translation>
    </message>
    <message>
        <source>Everything recognised in the picture shown</source>
        <translation>Tudo o que foi reconhecido na imagem mostrada</translation>
    </message>
    <message>
        <source>On this floor</source>
        <translation>Neste piso</translation>
    </message>
    <message>
        <source>The map as a list; press Enter on a place to go there</source>
        <translation>O mapa em lista; prima Enter num lugar para ir até lá</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>Listas</translation>
    </message>
    <message>
        <source>Why there</source>
        <translation>Porquê ali</translation>
    </message>
    <message>
        <source>What the vote of the chosen place is made of, and what speaks for it</source>
        <translation>De que é feito o voto do lugar escolhido, e o que fala por ele</translation>
    </message>
    <message>
        <source>Nothing has been said yet.</source>
        <translation>Ainda nada foi dito.</translation>
    </message>
    <message>
        <source>Nothing has been worked out yet.</source>
        <translation>Ainda nada foi calculado.</translation>
    </message>
    <message>
        <source>As soon as there is a place, what speaks for it stands here.</source>
        <translation>Assim que houver um lugar, aqui se vê o que fala por ele.</translation>
    </message>
    <message>
        <source>Nothing has been recognised yet.</source>
        <translation>Ainda nada foi reconhecido.</translation>
    </message>
    <message>
        <source>Nothing is recognised in the picture.</source>
        <translation>Nada se reconhece na imagem.</translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>Não há nenhum mapa aberto.</translation>
    </message>
</context>
<context>
    <name>farol::ui::LocaliserMenu</name>
    <message>
        <source>&amp;How the place is worked out</source>
        <translation>Como se determina o &amp;lugar</translation>
    </message>
    <message>
        <source>Filter, for people who are &amp;guided</source>
        <translation>Filtro, para pessoas &amp;guiadas</translation>
    </message>
    <message>
        <source>Filter, for people who &amp;know their way</source>
        <translation>Filtro, para quem &amp;conhece o caminho</translation>
    </message>
    <message>
        <source>&amp;Voting</source>
        <translation>&amp;Votação</translation>
    </message>
    <message>
        <source>Voting as first &amp;printed</source>
        <translation>Votação como foi &amp;publicada</translation>
    </message>
    <message>
        <source>From the next start of a walk</source>
        <translation>A partir do próximo início de um percurso</translation>
    </message>
</context>
<context>
    <name>farol::ui::MainWindow</name>
    <message>
        <source>About Farol</source>
        <translation>Acerca do Farol</translation>
    </message>
    <message>
        <source>Farol %1

Guides a blind person through a building with one ordinary camera: it recognises what it was taught, works out the place, and speaks the way.</source>
        <translation>Farol %1

Guia uma pessoa cega por um edifício com uma câmara comum: reconhece o que lhe foi ensinado, determina o lugar e diz o caminho.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Pronto</translation>
    </message>
    <message>
        <source>Walking</source>
        <translation>A percorrer</translation>
    </message>
    <message>
        <source>The walk has ended</source>
        <translation>O percurso terminou</translation>
    </message>
    <message>
        <source>The walk could not go on</source>
        <translation>O percurso não pôde continuar</translation>
    </message>
    <message>
        <source>Loading…</source>
        <translation>A carregar…</translation>
    </message>
    <message>
        <source>recorded in %1</source>
        <translation>gravado em %1</translation>
    </message>
    <message>
        <source>The walk has ended: there are no more pictures.</source>
        <translation>O percurso terminou: não há mais imagens.</translation>
    </message>
    <message>
        <source>Play &amp;again</source>
        <translation>Reproduzir &amp;outra vez</translation>
    </message>
    <message>
        <source>Open another &amp;map…</source>
        <translation>Abrir outro &amp;mapa…</translation>
    </message>
    <message>
        <source>Open another &amp;library…</source>
        <translation>Abrir outra &amp;biblioteca…</translation>
    </message>
    <message>
        <source>Open other &amp;pictures…</source>
        <translation>Abrir outras &amp;imagens…</translation>
    </message>
    <message>
        <source>The walk will be recorded from its next start.</source>
        <translation>O percurso será gravado a partir do próximo início.</translation>
    </message>
    <message>
        <source>This walk is recorded to its end; the next one is not.</source>
        <translation>Este percurso é gravado até ao fim; o próximo não.</translation>
    </message>
    <message>
        <source>Start &amp;again now</source>
        <translation>&amp;Recomeçar agora</translation>
    </message>
    <message>
        <source>Open a map</source>
        <translation>Abrir um mapa</translation>
    </message>
    <message>
        <source>Maps (%1);;All files (%2)</source>
        <translation>Mapas (%1);;Todos os ficheiros (%2)</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Abrir uma biblioteca de pontos de referência</translation>
    </message>
    <message>
        <source>Landmark libraries (%1);;All files (%2)</source>
        <translation>Bibliotecas de pontos de referência (%1);;Todos os ficheiros (%2)</translation>
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
        <source>State of the walk</source>
        <translation>Estado do percurso</translation>
    </message>
    <message>
        <source>Something is being loaded</source>
        <translation>Está a ser carregado algo</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Percurso</translation>
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
        <source>&amp;Next visitor now</source>
        <translation>&amp;Próximo visitante já</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Pontos de referência</translation>
    </message>
    <message>
        <source>Watch a walk, work on a map, or teach landmarks (Ctrl+1 to Ctrl+3)</source>
        <translation>Ver um percurso, trabalhar num mapa ou ensinar pontos de referência (Ctrl+1 a Ctrl+3)</translation>
    </message>
    <message>
        <source>The landmark library was changed on the Landmarks page.</source>
        <translation>A biblioteca mudou na página dos pontos de referência.</translation>
    </message>
    <message>
        <source>Start &amp;again with it</source>
        <translation>&amp;Recomeçar com ela</translation>
    </message>
    <message>
        <source>Changes are not saved</source>
        <translation>Há alterações por guardar</translation>
    </message>
    <message>
        <source>The landmark library could not be written; its last changes would be lost.</source>
        <translation>Não foi possível escrever a biblioteca; as últimas alterações perdiam-se.</translation>
    </message>
    <message>
        <source>&amp;Leave all the same</source>
        <translation>&amp;Sair mesmo assim</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>&amp;Ficar</translation>
    </message>
    <message>
        <source>Saved in %1</source>
        <translation>Guardado em %1</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>Não é possível escrever %1. Escolha outra pasta.</translation>
    </message>
    <message>
        <source>There is no walk to correct.</source>
        <translation>Não há percurso para corrigir.</translation>
    </message>
    <message>
        <source>Choose a place on the map, or in the list “Where it could be”, first.</source>
        <translation>Escolha primeiro um lugar no mapa, ou na lista “Onde pode ser”.</translation>
    </message>
    <message>
        <source>The user is in %1: told by you.</source>
        <translation>O utilizador está em %1: indicado por si.</translation>
    </message>
    <message>
        <source>The place is given up and looked for anew.</source>
        <translation>O lugar é abandonado e procurado de novo.</translation>
    </message>
    <message>
        <source>Say this</source>
        <translation>Dizer isto</translation>
    </message>
    <message>
        <source>Sentence that is spoken to the user:</source>
        <translation>Frase a dizer ao utilizador:</translation>
    </message>
    <message>
        <source>&amp;Say it</source>
        <translation>&amp;Dizer</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Guardar a imagem</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imagens (%1)</translation>
    </message>
    <message>
        <source>Save the walk as table</source>
        <translation>Guardar o percurso como tabela</translation>
    </message>
    <message>
        <source>Tables (%1)</source>
        <translation>Tabelas (%1)</translation>
    </message>
    <message>
        <source>Open as &amp;map</source>
        <translation>Abrir como &amp;mapa</translation>
    </message>
    <message>
        <source>Open as landmark &amp;library</source>
        <translation>Abrir como &amp;biblioteca de pontos de referência</translation>
    </message>
    <message>
        <source>The file of this map was changed.</source>
        <translation>O ficheiro deste mapa foi alterado.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>Carregar de no&amp;vo</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Em pausa</translation>
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
        <translation>Abrir o mapa de um edifício para o ver e alterar</translation>
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
        <translation>Trazer um mapa de outro tipo</translation>
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
        <translation>Escrever as alterações no ficheiro do mapa</translation>
    </message>
    <message>
        <source>S&amp;ave as…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>Write the map into another file</source>
        <translation>Escrever o mapa noutro ficheiro</translation>
    </message>
    <message>
        <source>&amp;Print as PDF…</source>
        <translation>Im&amp;primir em PDF…</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Write the plan of each level as a page of a PDF</source>
        <translation>Escrever a planta de cada piso como página de um PDF</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>A&amp;nular</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Anular</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Anular a última alteração</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Refazer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Refazer</translation>
    </message>
    <message>
        <source>Make the change again that was taken back</source>
        <translation>Voltar a fazer a alteração anulada</translation>
    </message>
    <message>
        <source>Add &amp;landmark</source>
        <translation>Juntar ponto de &amp;referência</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Referência</translation>
    </message>
    <message>
        <source>Put a new landmark on the plan</source>
        <translation>Pôr um novo ponto de referência na planta</translation>
    </message>
    <message>
        <source>Add &amp;door or passage</source>
        <translation>Juntar por&amp;ta ou passagem</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Porta</translation>
    </message>
    <message>
        <source>Put a new door or passage on the plan</source>
        <translation>Pôr uma nova porta ou passagem na planta</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>A&amp;lterar…</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Alterar</translation>
    </message>
    <message>
        <source>Change name, kind and the like of what is chosen</source>
        <translation>Alterar o nome, o tipo e o resto do que está escolhido</translation>
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
        <translation>Tirar do mapa o ponto de referência, a porta ou a passagem escolhida</translation>
    </message>
    <message>
        <source>Route &amp;from here</source>
        <translation>Caminho a partir &amp;daqui</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>A partir daqui</translation>
    </message>
    <message>
        <source>Let the route begin in the chosen place</source>
        <translation>O caminho começa no local escolhido</translation>
    </message>
    <message>
        <source>Route &amp;to here</source>
        <translation>Caminho até aq&amp;ui</translation>
    </message>
    <message>
        <source>To here</source>
        <translation>Até aqui</translation>
    </message>
    <message>
        <source>Let the route end in the chosen place</source>
        <translation>O caminho acaba no local escolhido</translation>
    </message>
    <message>
        <source>Sea&amp;rch the table</source>
        <translation>Pr&amp;ocurar na tabela</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Procurar</translation>
    </message>
    <message>
        <source>Search the table of attributes</source>
        <translation>Procurar na tabela de atributos</translation>
    </message>
    <message>
        <source>C&amp;heck the map</source>
        <translation>&amp;Verificar o mapa</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Verificar</translation>
    </message>
    <message>
        <source>Look for what is wrong with the map as it is now</source>
        <translation>Ver o que está errado no mapa como está agora</translation>
    </message>
    <message>
        <source>&amp;Next feature</source>
        <translation>Elemento &amp;seguinte</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Seguinte</translation>
    </message>
    <message>
        <source>Show the next feature of the chosen finding</source>
        <translation>Mostrar o elemento seguinte do achado escolhido</translation>
    </message>
    <message>
        <source>Places that look ali&amp;ke</source>
        <translation>Locais &amp;parecidos</translation>
    </message>
    <message>
        <source>Alike</source>
        <translation>Parecidos</translation>
    </message>
    <message>
        <source>Mark the places that the landmarks cannot tell apart, and those without any</source>
        <translation>Marcar os locais que os pontos de referência não distinguem, e os que não têm nenhum</translation>
    </message>
    <message>
        <source>&amp;Walk with this map</source>
        <translation>Percurso com este mapa</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>Use the saved map on the Walk page</source>
        <translation>Usar o mapa guardado na página do percurso</translation>
    </message>
    <message>
        <source>Where landmarks are see&amp;n</source>
        <translation>O&amp;nde se veem pontos de referência</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Visíveis</translation>
    </message>
    <message>
        <source>Mark from where landmarks can be seen, and from where none can</source>
        <translation>Marcar de onde se veem pontos de referência, e de onde não se vê nenhum</translation>
    </message>
    <message>
        <source>&amp;Missing routes…</source>
        <translation>Caminhos em &amp;falta…</translation>
    </message>
    <message>
        <source>Missing routes</source>
        <translation>Caminhos em falta</translation>
    </message>
    <message>
        <source>List the places between which no route leads, and why</source>
        <translation>Listar os locais entre os quais não há caminho, e porquê</translation>
    </message>
    <message>
        <source>Floor-plan ima&amp;ge…</source>
        <translation>Ima&amp;gem da planta…</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Imagem</translation>
    </message>
    <message>
        <source>Lay the image of a floor plan under the floor that is shown</source>
        <translation>Pôr a imagem de uma planta sob o piso que se vê</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapDocument</name>
    <message>
        <source>Load the map again</source>
        <translation>Carregar o mapa de novo</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapPage</name>
    <message>
        <source>Saved in %1</source>
        <translation>Guardado em %1</translation>
    </message>
    <message>
        <source>Open a map</source>
        <translation>Abrir um mapa</translation>
    </message>
    <message>
        <source>Maps (%1);;All files (%2)</source>
        <translation>Mapas (%1);;Todos os ficheiros (%2)</translation>
    </message>
    <message>
        <source>Save the map</source>
        <translation>Guardar o mapa</translation>
    </message>
    <message>
        <source>Maps (%1)</source>
        <translation>Mapas (%1)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Alterações por guardar</translation>
    </message>
    <message>
        <source>The map has changes that are not saved.</source>
        <translation>O mapa tem alterações que não estão guardadas.</translation>
    </message>
    <message>
        <source>Save them first?</source>
        <translation>Guardá-las primeiro?</translation>
    </message>
    <message>
        <source>Imported from %1. Look at what was found, then save it as a map of Farol.</source>
        <translation>Importado de %1. Veja o que foi encontrado, e guarde-o como mapa do Farol.</translation>
    </message>
    <message>
        <source>Sa&amp;ve…</source>
        <translation>&amp;Guardar…</translation>
    </message>
    <message>
        <source>The map is being opened…</source>
        <translation>O mapa está a ser aberto…</translation>
    </message>
    <message>
        <source>The map is being imported and checked…</source>
        <translation>O mapa está a ser importado e verificado…</translation>
    </message>
    <message>
        <source>The map is being saved…</source>
        <translation>O mapa está a ser guardado…</translation>
    </message>
    <message>
        <source>The map is being checked…</source>
        <translation>O mapa está a ser verificado…</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabela</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Verificar</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Caminho</translation>
    </message>
    <message>
        <source>Parts of the map</source>
        <translation>Partes do mapa</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>Ca&amp;ncelar</translation>
    </message>
    <message>
        <source>Give up; the map that was open stays</source>
        <translation>Desistir; o mapa que estava aberto fica</translation>
    </message>
    <message>
        <source>Click where the landmark stands, or move the plan under the cross with the arrows and press Enter. Escape gives up.</source>
        <translation>Clique onde está o ponto de referência, ou mova a planta sob a cruz com as setas e prima Enter. Escape desiste.</translation>
    </message>
    <message>
        <source>Click where the door is, or move the plan under the cross with the arrows and press Enter. Escape gives up.</source>
        <translation>Clique onde está a porta, ou mova a planta sob a cruz com as setas e prima Enter. Escape desiste.</translation>
    </message>
    <message>
        <source>Add a landmark</source>
        <translation>Juntar um ponto de referência</translation>
    </message>
    <message>
        <source>Add a door</source>
        <translation>Juntar uma porta</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Alterar %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Eliminar %1</translation>
    </message>
    <message>
        <source>Deleted: %1. Ctrl+Z brings it back.</source>
        <translation>Eliminado: %1. Ctrl+Z trá-lo de volta.</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>Print the plan</source>
        <translation>Imprimir a planta</translation>
    </message>
    <message>
        <source>PDF (%1)</source>
        <translation>PDF (%1)</translation>
    </message>
    <message>
        <source>Printed in %1</source>
        <translation>Impresso em %1</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>Não é possível escrever %1. Escolha outra pasta.</translation>
    </message>
    <message>
        <source>Open the map on which the landmark shall stand.</source>
        <translation>Abra o mapa onde o ponto de referência vai ficar.</translation>
    </message>
    <message>
        <source>&amp;Open map…</source>
        <translation>&amp;Abrir mapa…</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map. You have changes of your own: loading it again puts them aside, and Ctrl+Z brings them back.</source>
        <translation>Outro programa alterou o ficheiro deste mapa. Tem alterações suas: carregar de novo põe-nas de lado, e Ctrl+Z trá-las de volta.</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map.</source>
        <translation>Outro programa alterou o ficheiro deste mapa.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>Carregar de no&amp;vo</translation>
    </message>
    <message>
        <source>The file %1 is no longer there. The map stays open here: save it, or it is lost when you leave.</source>
        <translation>O ficheiro %1 já não existe. O mapa continua aberto aqui: guarde-o, ou perde-se quando sair.</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map, and it cannot be read any more (%1). The map stays open here as it was: save it under another name.</source>
        <translation>Outro programa alterou o ficheiro deste mapa, que já não pode ser lido (%1). O mapa continua aberto aqui como estava: guarde-o com outro nome.</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Ainda não guardado</translation>
    </message>
    <message>
        <source>Another program has changed the file of this map since it was read here.</source>
        <translation>Outro programa alterou o ficheiro deste mapa depois de ter sido lido aqui.</translation>
    </message>
    <message>
        <source>Saving over it would lose what that program wrote.</source>
        <translation>Guardar por cima perderia o que esse programa escreveu.</translation>
    </message>
    <message>
        <source>Save under &amp;another name…</source>
        <translation>Guardar com outro &amp;nome…</translation>
    </message>
    <message>
        <source>Save &amp;over it</source>
        <translation>Guardar por &amp;cima</translation>
    </message>
    <message>
        <source>Floor-plan image</source>
        <translation>Imagem da planta</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (%2)</source>
        <translation>Imagens (%1);;Todos os ficheiros (%2)</translation>
    </message>
    <message>
        <source>No landmark is seen from %1 % of the floors.</source>
        <translation>De %1 % dos pisos não se vê nenhum ponto de referência.</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapPanel</name>
    <message>
        <source>No map is open.</source>
        <translation>Não há nenhum mapa aberto.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) on the map.</source>
        <translation>
            <numerusform>%n lugar no mapa.</numerusform>
            <numerusform>%n lugares no mapa.</numerusform>
        </translation>
    </message>
    <message>
        <source>Where you are is not known yet.</source>
        <translation>Ainda não se sabe onde está.</translation>
    </message>
    <message>
        <source>You are in %1, %2: %3.</source>
        <translation>Está aqui: %1, %2 (%3).</translation>
    </message>
    <message>
        <source>You are in %1: %2.</source>
        <translation>Está aqui: %1 (%2).</translation>
    </message>
    <message>
        <source>&amp;Go to %1</source>
        <translation>&amp;Ir para: %1</translation>
    </message>
    <message>
        <source>&amp;Start at %1</source>
        <translation>&amp;Começar em: %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>&amp;Level:</source>
        <translation>&amp;Piso:</translation>
    </message>
    <message>
        <source>Level of the map</source>
        <translation>Piso do mapa</translation>
    </message>
    <message>
        <source>The floor that the map shows (Page Up and Page Down in the map)</source>
        <translation>O piso que o mapa mostra (Page Up e Page Down no mapa)</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>S&amp;eguir</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Switch to the floor where you are whenever it changes</source>
        <translation>Mudar para o piso onde está sempre que este mude</translation>
    </message>
    <message>
        <source>Larger (+)</source>
        <translation>Maior (+)</translation>
    </message>
    <message>
        <source>Smaller (-)</source>
        <translation>Menor (-)</translation>
    </message>
    <message>
        <source>Show the whole floor (0)</source>
        <translation>Mostrar o piso inteiro (0)</translation>
    </message>
    <message>
        <source>Floor map</source>
        <translation>Mapa do piso</translation>
    </message>
    <message>
        <source>Drag to move, turn the wheel to zoom, double-click a place to go there</source>
        <translation>Arraste para mover, rode a roda para ampliar, faça duplo clique num lugar para ir até lá</translation>
    </message>
    <message>
        <source>Taken to be in %1: %2. Really in %3.</source>
        <translation>Suposto em %1: %2. Na verdade em %3.</translation>
    </message>
    <message>
        <source>The user &amp;is here, in %1</source>
        <translation>O utilizador es&amp;tá aqui, em %1</translation>
    </message>
    <message>
        <source>The assistant had said: %1.</source>
        <translation>O assistente tinha dito: %1.</translation>
    </message>
    <message>
        <source>said by the assistant</source>
        <translation>dito pelo assistente</translation>
    </message>
</context>
<context>
    <name>farol::ui::MapView</name>
    <message>
        <source>No map is open.
Open one with Ctrl+O.</source>
        <translation>Não há nenhum mapa aberto.
Abra um com Ctrl+O.</translation>
    </message>
    <message>
        <source>Less likely</source>
        <translation>Menos provável</translation>
    </message>
    <message>
        <source>More likely</source>
        <translation>Mais provável</translation>
    </message>
</context>
<context>
    <name>farol::ui::MissingDialog</name>
    <message>
        <source>&amp;Show on the plan</source>
        <translation>&amp;Mostrar na planta</translation>
    </message>
    <message>
        <source>Missing routes</source>
        <translation>Caminhos em falta</translation>
    </message>
    <message>
        <source>Looking for the way between all places…</source>
        <translation>À procura do caminho entre todos os locais…</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Para</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Falta</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Porquê</translation>
    </message>
    <message>
        <source>Places between which no route leads; Enter shows the chosen one on the plan</source>
        <translation>Locais entre os quais não há caminho; Enter mostra o escolhido na planta</translation>
    </message>
    <message>
        <source>Show on the plan</source>
        <translation>Mostrar na planta</translation>
    </message>
    <message>
        <source>Choose both places on the Map page, and see them on the plan</source>
        <translation>Escolher os dois locais na página Mapa, e vê-los na planta</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more place(s)</source>
        <translation>
            <numerusform>%1 e mais %n local</numerusform>
            <numerusform>%1 e mais %n locais</numerusform>
        </translation>
    </message>
    <message>
        <source>From every place there is a route to every other one (%1 pairs of places).</source>
        <translation>De cada local há um caminho para todos os outros (%1 pares de locais).</translation>
    </message>
    <message>
        <source>Of %1 pairs of places, %2 have no route.</source>
        <translation>De %1 pares de locais, %2 não têm caminho.</translation>
    </message>
    <message numerus="yes">
        <source>%n more line(s) are not listed: mend these first.</source>
        <translation>
            <numerusform>Há mais %n linha por listar: corrija primeiro estas.</numerusform>
            <numerusform>Há mais %n linhas por listar: corrija primeiro estas.</numerusform>
        </translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>nos dois sentidos</translation>
    </message>
    <message>
        <source>this way</source>
        <translation>neste sentido</translation>
    </message>
</context>
<context>
    <name>farol::ui::NoRouteWords</name>
    <message>
        <source>stairs</source>
        <translation>escadas</translation>
    </message>
    <message>
        <source>a lift</source>
        <translation>um elevador</translation>
    </message>
    <message>
        <source>an escalator</source>
        <translation>uma escada rolante</translation>
    </message>
    <message>
        <source>a moving walkway</source>
        <translation>um tapete rolante</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>uma rampa</translation>
    </message>
    <message>
        <source>a narrow door</source>
        <translation>uma porta estreita</translation>
    </message>
    <message>
        <source>a restricted region</source>
        <translation>um espaço reservado</translation>
    </message>
    <message>
        <source>a closed door or passage</source>
        <translation>uma porta ou passagem fechada</translation>
    </message>
    <message>
        <source>a one-way door or passage</source>
        <translation>uma porta ou passagem de sentido único</translation>
    </message>
    <message>
        <source>%1 (from %2 to %3)</source>
        <translation>%1 (de %2 para %3)</translation>
    </message>
    <message>
        <source>The map joins %1 and %2 in no way.</source>
        <translation>O mapa não liga %1 e %2 de modo nenhum.</translation>
    </message>
    <message>
        <source>%1 is reached only by what is to be avoided: %2.</source>
        <translation>A %1 só se chega pelo que se quer evitar: %2.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <source>On the way to %1 stands %2.</source>
        <translation>No caminho para %1 está %2.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> e </translation>
    </message>
</context>
<context>
    <name>farol::ui::OptionFields</name>
    <message>
        <source>Announce what comes within</source>
        <translation>Anunciar o que vem a menos de</translation>
    </message>
    <message>
        <source>Say “now” within</source>
        <translation>Dizer “agora” a menos de</translation>
    </message>
    <message>
        <source>Reassure every</source>
        <translation>Tranquilizar a cada</translation>
    </message>
    <message>
        <source>Reassure, where no distance is known, every</source>
        <translation>Tranquilizar, sem distância conhecida, a cada</translation>
    </message>
    <message>
        <source>Repeat an instruction after</source>
        <translation>Repetir uma instrução ao fim de</translation>
    </message>
    <message>
        <source>Tell an object again after</source>
        <translation>Voltar a dizer um objeto ao fim de</translation>
    </message>
    <message>
        <source>Say that the place is not known after</source>
        <translation>Dizer que o lugar é desconhecido ao fim de</translation>
    </message>
    <message>
        <source>Say again that the route was left after</source>
        <translation>Voltar a dizer que saiu do percurso ao fim de</translation>
    </message>
    <message>
        <source>Avoid stairs</source>
        <translation>Evitar escadas</translation>
    </message>
    <message>
        <source>Avoid lifts</source>
        <translation>Evitar elevadores</translation>
    </message>
    <message>
        <source>Avoid escalators</source>
        <translation>Evitar escadas rolantes</translation>
    </message>
    <message>
        <source>Avoid moving walkways</source>
        <translation>Evitar tapetes rolantes</translation>
    </message>
    <message>
        <source>Avoid ramps</source>
        <translation>Evitar rampas</translation>
    </message>
    <message>
        <source>Avoid narrow doors</source>
        <translation>Evitar portas estreitas</translation>
    </message>
    <message>
        <source>Avoid restricted places</source>
        <translation>Evitar lugares reservados</translation>
    </message>
    <message>
        <source>Walking speed</source>
        <translation>Velocidade da marcha</translation>
    </message>
    <message>
        <source>Time to find and pass a door</source>
        <translation>Tempo para encontrar e passar uma porta</translation>
    </message>
    <message>
        <source>Time for the stairs of a level</source>
        <translation>Tempo para as escadas de um piso</translation>
    </message>
    <message>
        <source>Time to wait for a lift and ride it</source>
        <translation>Tempo para esperar e usar um elevador</translation>
    </message>
    <message>
        <source>Points that must fit an object</source>
        <translation>Pontos que têm de condizer num objeto</translation>
    </message>
    <message>
        <source>Evidence that an object needs</source>
        <translation>Indícios de que um objeto precisa</translation>
    </message>
    <message>
        <source>Points that must fit a known place</source>
        <translation>Pontos que têm de condizer num lugar conhecido</translation>
    </message>
    <message>
        <source>Sharpness that a picture needs</source>
        <translation>Nitidez de que uma imagem precisa</translation>
    </message>
</context>
<context>
    <name>farol::ui::OptionForm</name>
    <message>
        <source>&amp;Defaults</source>
        <translation>&amp;Predefinições</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Predefinições</translation>
    </message>
    <message>
        <source>Take every figure of this page back to what the program has</source>
        <translation>Repor todos os valores desta página como o programa os tem</translation>
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
        <translation>Ainda não há imagem</translation>
    </message>
    <message>
        <source>The whole picture counts</source>
        <translation>Conta a imagem toda</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>em cima à esquerda</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>em cima à direita</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>em baixo à direita</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>em baixo à esquerda</translation>
    </message>
    <message>
        <source>Corner %1, %2, is %3 to the right and %4 down</source>
        <translation>O canto %1, %2, está %3 para a direita e %4 para baixo</translation>
    </message>
</context>
<context>
    <name>farol::ui::Phrasebook</name>
    <message>
        <source>I am not sure where you are. Stop, and turn slowly to the right, so that I can look around.</source>
        <translation>Não tenho a certeza de onde está. Pare e vire-se devagar para a direita, para eu poder olhar em volta.</translation>
    </message>
    <message>
        <source>I read: %1. %2.</source>
        <extracomment>%1 what is written there, %2 &quot;left, up&quot;</extracomment>
        <translation>Leio: %1. %2.</translation>
    </message>
    <message>
        <source>Destination: %1.</source>
        <translation>Destino: %1.</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Primeiro</translation>
    </message>
    <message>
        <source>First, probably</source>
        <translation>Primeiro, provavelmente</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Depois</translation>
    </message>
    <message>
        <source>Probably %1 first.</source>
        <extracomment>%1 &quot;turn left&quot;, &quot;turn around&quot;</extracomment>
        <translation>Primeiro, talvez: %1.</translation>
    </message>
    <message numerus="yes">
        <source>In about %n metre(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>Daqui a cerca de %n metro</numerusform>
            <numerusform>Daqui a cerca de %n metros</numerusform>
        </translation>
    </message>
    <message>
        <source>Soon</source>
        <translation>Em breve</translation>
    </message>
    <message>
        <source>Soon, probably</source>
        <translation>Em breve, provavelmente</translation>
    </message>
    <message>
        <source>Keep moving forward. You are probably going the right way.</source>
        <translation>Continue em frente. Provavelmente está no caminho certo.</translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n metre(s).</source>
        <translation>
            <numerusform>Continue em frente durante cerca de %n metro.</numerusform>
            <numerusform>Continue em frente durante cerca de %n metros.</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep moving forward.</source>
        <translation>Continue em frente.</translation>
    </message>
    <message>
        <source>You have arrived.</source>
        <translation>Chegou ao destino.</translation>
    </message>
    <message>
        <source>You have probably arrived.</source>
        <translation>Provavelmente chegou ao destino.</translation>
    </message>
    <message>
        <source>You have arrived: %1.</source>
        <translation>Chegou ao destino: %1.</translation>
    </message>
    <message>
        <source>You have probably arrived: %1.</source>
        <translation>Provavelmente chegou ao destino: %1.</translation>
    </message>
    <message>
        <source>You have left the route.</source>
        <translation>Saiu do percurso.</translation>
    </message>
    <message>
        <source>You have probably left the route.</source>
        <translation>Provavelmente saiu do percurso.</translation>
    </message>
    <message>
        <source>Stop. I know no way from here.</source>
        <translation>Pare. A partir daqui, não conheço caminho.</translation>
    </message>
    <message>
        <source>Stop for a moment.</source>
        <translation>Pare um momento.</translation>
    </message>
    <message>
        <source>I do not know yet where you are.</source>
        <translation>Ainda não sei onde está.</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>piso %1</translation>
    </message>
    <message>
        <source>minus %1</source>
        <translation>menos %1</translation>
    </message>
    <message>
        <source>You are here: %1.</source>
        <translation>Está aqui: %1.</translation>
    </message>
    <message>
        <source>You are probably here, or next to it: %1.</source>
        <translation>Deve estar aqui, ou mesmo ao lado: %1.</translation>
    </message>
    <message>
        <source>up</source>
        <translation>em cima</translation>
    </message>
    <message>
        <source>down</source>
        <translation>em baixo</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <extracomment>%1 &quot;extinguisher&quot;, %2 &quot;left, down&quot;</extracomment>
        <translation>%1, %2.</translation>
    </message>
    <message>
        <source>I do not know this destination. Choose another one.</source>
        <translation>Não conheço este destino. Escolha outro.</translation>
    </message>
    <message>
        <source>I do not know this destination: %1. Choose another one.</source>
        <translation>Não conheço este destino: %1. Escolha outro.</translation>
    </message>
    <message>
        <source>I know no way to your destination. Choose another one, or ask for help.</source>
        <translation>Não conheço caminho para o seu destino. Escolha outro ou peça ajuda.</translation>
    </message>
    <message>
        <source>I know no way to: %1. Choose another destination, or ask for help.</source>
        <translation>Não conheço caminho para este destino: %1. Escolha outro ou peça ajuda.</translation>
    </message>
    <message>
        <source>You are already there.</source>
        <translation>Já está no seu destino.</translation>
    </message>
    <message>
        <source>You are probably there already.</source>
        <translation>Provavelmente já está no seu destino.</translation>
    </message>
    <message>
        <source>You are already there: %1.</source>
        <translation>Já está no seu destino: %1.</translation>
    </message>
    <message>
        <source>You are probably there already: %1.</source>
        <translation>Provavelmente já está no seu destino: %1.</translation>
    </message>
    <message>
        <source>Stop. The camera gives no picture, and I cannot guide you.</source>
        <translation>Pare. A câmara não dá imagem e não posso dar orientações.</translation>
    </message>
    <message>
        <source>The camera works again.</source>
        <translation>A câmara voltou a funcionar.</translation>
    </message>
    <message>
        <source>The recording has stopped. I keep guiding you.</source>
        <translation>A gravação parou. A orientação continua.</translation>
    </message>
    <message>
        <source>Stop. I cannot see. Please uncover the camera.</source>
        <translation>Pare. Não consigo ver. Destape a câmara, por favor.</translation>
    </message>
    <message>
        <source>One picture could not be used. I keep guiding you.</source>
        <translation>Uma imagem não pôde ser usada. A orientação continua.</translation>
    </message>
    <message>
        <source>Stop. Something is wrong. Please ask for help.</source>
        <translation>Pare. Algo correu mal. Peça ajuda, por favor.</translation>
    </message>
    <message>
        <source>a door</source>
        <translation>uma porta</translation>
    </message>
    <message>
        <source>an opening</source>
        <translation>uma abertura</translation>
    </message>
    <message>
        <source>stairs up</source>
        <translation>escadas a subir</translation>
    </message>
    <message>
        <source>stairs down</source>
        <translation>escadas a descer</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>escadas</translation>
    </message>
    <message>
        <source>a lift</source>
        <translation>um elevador</translation>
    </message>
    <message>
        <source>an escalator up</source>
        <translation>uma escada rolante a subir</translation>
    </message>
    <message>
        <source>an escalator down</source>
        <translation>uma escada rolante a descer</translation>
    </message>
    <message>
        <source>an escalator</source>
        <translation>uma escada rolante</translation>
    </message>
    <message>
        <source>a ramp up</source>
        <translation>uma rampa a subir</translation>
    </message>
    <message>
        <source>a ramp down</source>
        <translation>uma rampa a descer</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>uma rampa</translation>
    </message>
    <message>
        <source>The stairs are %1.</source>
        <translation>As escadas estão %1.</translation>
    </message>
    <message>
        <source>The stairs are probably %1.</source>
        <translation>As escadas estão provavelmente %1.</translation>
    </message>
    <message>
        <source>The lift is %1.</source>
        <translation>O elevador está %1.</translation>
    </message>
    <message>
        <source>The lift is probably %1.</source>
        <translation>O elevador está provavelmente %1.</translation>
    </message>
    <message>
        <source>The escalator is %1.</source>
        <translation>A escada rolante está %1.</translation>
    </message>
    <message>
        <source>The escalator is probably %1.</source>
        <translation>A escada rolante está provavelmente %1.</translation>
    </message>
    <message>
        <source>The ramp is %1.</source>
        <translation>A rampa está %1.</translation>
    </message>
    <message>
        <source>The ramp is probably %1.</source>
        <translation>A rampa está provavelmente %1.</translation>
    </message>
    <message>
        <source>You are probably near the door.</source>
        <translation>Deve estar perto da porta.</translation>
    </message>
    <message>
        <source>You are probably near the opening.</source>
        <translation>Deve estar perto da abertura.</translation>
    </message>
    <message>
        <source>You are probably near the lift.</source>
        <translation>Deve estar perto do elevador.</translation>
    </message>
    <message>
        <source>You are probably near the ramp.</source>
        <translation>Deve estar perto da rampa.</translation>
    </message>
    <message>
        <source>You are probably where you have to turn.</source>
        <translation>Deve estar no sítio onde tem de virar.</translation>
    </message>
    <message>
        <source>go through the door</source>
        <translation>atravesse a porta</translation>
    </message>
    <message>
        <source>go through the opening</source>
        <translation>atravesse a abertura</translation>
    </message>
    <message>
        <source>take the stairs up</source>
        <translation>suba as escadas</translation>
    </message>
    <message>
        <source>take the stairs down</source>
        <translation>desça as escadas</translation>
    </message>
    <message>
        <source>take the stairs, but feel first whether they go up or down</source>
        <translation>siga pelas escadas, mas sinta primeiro se sobem ou descem</translation>
    </message>
    <message>
        <source>take the lift up</source>
        <translation>apanhe o elevador para subir</translation>
    </message>
    <message>
        <source>take the lift down</source>
        <translation>apanhe o elevador para descer</translation>
    </message>
    <message>
        <source>take the lift</source>
        <translation>apanhe o elevador</translation>
    </message>
    <message>
        <source>take the escalator up</source>
        <translation>apanhe a escada rolante para subir</translation>
    </message>
    <message>
        <source>take the escalator down</source>
        <translation>apanhe a escada rolante para descer</translation>
    </message>
    <message>
        <source>take the escalator, but feel first whether it goes up or down</source>
        <translation>apanhe a escada rolante, mas sinta primeiro se sobe ou desce</translation>
    </message>
    <message>
        <source>go up the ramp</source>
        <translation>suba a rampa</translation>
    </message>
    <message>
        <source>go down the ramp</source>
        <translation>desça a rampa</translation>
    </message>
    <message>
        <source>follow the ramp</source>
        <translation>siga pela rampa</translation>
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
        <source>It is a long flight.</source>
        <translation>São muitos degraus.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s).</source>
        <translation>
            <numerusform>%n degrau.</numerusform>
            <numerusform>%n degraus.</numerusform>
        </translation>
    </message>
    <message>
        <source>Inside, choose: %1.</source>
        <translation>Lá dentro, escolha: %1.</translation>
    </message>
    <message>
        <source>Next: %1.</source>
        <translation>A seguir: %1.</translation>
    </message>
    <message>
        <source>When you get out: %1.</source>
        <translation>À saída: %1.</translation>
    </message>
    <message>
        <source>At the top: %1.</source>
        <translation>Em cima: %1.</translation>
    </message>
    <message>
        <source>At the bottom: %1.</source>
        <translation>Em baixo: %1.</translation>
    </message>
    <message>
        <source>Then, straight away, %1.</source>
        <translation>Logo a seguir, %1.</translation>
    </message>
    <message>
        <source>%1: your destination.</source>
        <translation>%1: o seu destino.</translation>
    </message>
    <message>
        <source>%1: your destination, %2.</source>
        <translation>%1: o seu destino, %2.</translation>
    </message>
    <message>
        <source>Your destination is here.</source>
        <translation>O seu destino é aqui.</translation>
    </message>
    <message>
        <source>Your destination is probably here.</source>
        <translation>O seu destino é provavelmente aqui.</translation>
    </message>
    <message>
        <source>Your destination is here: %1.</source>
        <translation>O seu destino é aqui: %1.</translation>
    </message>
    <message>
        <source>Your destination is probably here: %1.</source>
        <translation>O seu destino é provavelmente aqui: %1.</translation>
    </message>
    <message>
        <source>known place</source>
        <translation>lugar conhecido</translation>
    </message>
    <message>
        <source>door</source>
        <translation>porta</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>elevador</translation>
    </message>
    <message>
        <source>extinguisher</source>
        <translation>extintor</translation>
    </message>
    <message>
        <source>exit sign</source>
        <translation>sinal de saída</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>placa</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texto</translation>
    </message>
    <message>
        <source>rectangular shape</source>
        <translation>forma retangular</translation>
    </message>
    <message>
        <source>window</source>
        <translation>janela</translation>
    </message>
    <message>
        <source>locker</source>
        <translation>cacifo</translation>
    </message>
    <message>
        <source>poster</source>
        <translation>cartaz</translation>
    </message>
    <message>
        <source>drinking fountain</source>
        <translation>bebedouro</translation>
    </message>
    <message>
        <source>vending machine</source>
        <translation>máquina de venda automática</translation>
    </message>
    <message>
        <source>waste bin</source>
        <translation>caixote do lixo</translation>
    </message>
    <message>
        <source>plant</source>
        <translation>planta</translation>
    </message>
    <message>
        <source>piece of furniture</source>
        <translation>móvel</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>quadro</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objeto</translation>
    </message>
    <message>
        <source>left</source>
        <translation>esquerda</translation>
    </message>
    <message>
        <source>right</source>
        <translation>direita</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>ao centro</translation>
    </message>
    <message>
        <source>1 o&apos;clock</source>
        <translation>uma hora</translation>
    </message>
    <message>
        <source>2 o&apos;clock</source>
        <translation>duas horas</translation>
    </message>
    <message>
        <source>3 o&apos;clock</source>
        <translation>três horas</translation>
    </message>
    <message>
        <source>4 o&apos;clock</source>
        <translation>quatro horas</translation>
    </message>
    <message>
        <source>5 o&apos;clock</source>
        <translation>cinco horas</translation>
    </message>
    <message>
        <source>6 o&apos;clock</source>
        <translation>seis horas</translation>
    </message>
    <message>
        <source>7 o&apos;clock</source>
        <translation>sete horas</translation>
    </message>
    <message>
        <source>8 o&apos;clock</source>
        <translation>oito horas</translation>
    </message>
    <message>
        <source>9 o&apos;clock</source>
        <translation>nove horas</translation>
    </message>
    <message>
        <source>10 o&apos;clock</source>
        <translation>dez horas</translation>
    </message>
    <message>
        <source>11 o&apos;clock</source>
        <translation>onze horas</translation>
    </message>
    <message>
        <source>12 o&apos;clock</source>
        <translation>doze horas</translation>
    </message>
    <message>
        <source>go straight on</source>
        <translation>siga em frente</translation>
    </message>
    <message>
        <source>turn to %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>vire para a %1</translation>
    </message>
    <message>
        <source>turn to %1</source>
        <translation>vire para as %1</translation>
    </message>
    <message>
        <source>turn around</source>
        <translation>dê meia-volta</translation>
    </message>
    <message>
        <source>turn %1 degrees to the left</source>
        <translation>vire %1 graus à esquerda</translation>
    </message>
    <message>
        <source>turn %1 degrees to the right</source>
        <translation>vire %1 graus à direita</translation>
    </message>
    <message>
        <source>turn slightly left</source>
        <translation>vire ligeiramente à esquerda</translation>
    </message>
    <message>
        <source>turn left</source>
        <translation>vire à esquerda</translation>
    </message>
    <message>
        <source>turn sharply left</source>
        <translation>vire acentuadamente à esquerda</translation>
    </message>
    <message>
        <source>turn slightly right</source>
        <translation>vire ligeiramente à direita</translation>
    </message>
    <message>
        <source>turn right</source>
        <translation>vire à direita</translation>
    </message>
    <message>
        <source>turn sharply right</source>
        <translation>vire acentuadamente à direita</translation>
    </message>
    <message>
        <source>turning to %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>virando para a %1</translation>
    </message>
    <message>
        <source>turning to %1</source>
        <translation>virando para as %1</translation>
    </message>
    <message>
        <source>turning around</source>
        <translation>dando meia-volta</translation>
    </message>
    <message>
        <source>turning %1 degrees to the left</source>
        <translation>virando %1 graus à esquerda</translation>
    </message>
    <message>
        <source>turning %1 degrees to the right</source>
        <translation>virando %1 graus à direita</translation>
    </message>
    <message>
        <source>turning slightly left</source>
        <translation>virando ligeiramente à esquerda</translation>
    </message>
    <message>
        <source>turning left</source>
        <translation>virando à esquerda</translation>
    </message>
    <message>
        <source>turning sharply left</source>
        <translation>virando acentuadamente à esquerda</translation>
    </message>
    <message>
        <source>turning slightly right</source>
        <translation>virando ligeiramente à direita</translation>
    </message>
    <message>
        <source>turning right</source>
        <translation>virando à direita</translation>
    </message>
    <message>
        <source>turning sharply right</source>
        <translation>virando acentuadamente à direita</translation>
    </message>
    <message>
        <source>at %1</source>
        <comment>one o&apos;clock</comment>
        <extracomment>%1 is an hour, such as &quot;9 o&apos;clock&quot;</extracomment>
        <translation>à %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>às %1</translation>
    </message>
    <message>
        <source>straight ahead</source>
        <translation>mesmo em frente</translation>
    </message>
    <message>
        <source>behind you</source>
        <translation>atrás de si</translation>
    </message>
    <message>
        <source>%1 degrees to your right</source>
        <translation>%1 graus à sua direita</translation>
    </message>
    <message>
        <source>%1 degrees to your left</source>
        <translation>%1 graus à sua esquerda</translation>
    </message>
    <message>
        <source>ahead, slightly to your right</source>
        <translation>à frente, um pouco à sua direita</translation>
    </message>
    <message>
        <source>behind you, on the right</source>
        <translation>atrás de si, à direita</translation>
    </message>
    <message>
        <source>behind you, on the left</source>
        <translation>atrás de si, à esquerda</translation>
    </message>
    <message>
        <source>ahead, slightly to your left</source>
        <translation>à frente, um pouco à sua esquerda</translation>
    </message>
    <message>
        <source>on your right</source>
        <translation>à sua direita</translation>
    </message>
    <message>
        <source>on your left</source>
        <translation>à sua esquerda</translation>
    </message>
    <message>
        <source>I have found the way.</source>
        <translation>Encontrei o caminho.</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>A partir daqui</translation>
    </message>
    <message>
        <source>From here, probably</source>
        <translation>A partir daqui, provavelmente</translation>
    </message>
    <message>
        <source>hydrant</source>
        <translation>boca de incêndio</translation>
    </message>
    <message numerus="yes">
        <source>About %n metre(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Cerca de %n metro.</numerusform>
            <numerusform>Cerca de %n metros.</numerusform>
        </translation>
    </message>
    <message>
        <source>perhaps: %1, %2.</source>
        <translation>talvez: %1, %2.</translation>
    </message>
    <message>
        <source>Careful: you are probably near the stairs.</source>
        <translation>Cuidado: deve estar perto das escadas.</translation>
    </message>
    <message>
        <source>Careful: you are probably near the escalator.</source>
        <translation>Cuidado: deve estar perto da escada rolante.</translation>
    </message>
    <message>
        <source>%1: a bend. Follow it, %2.</source>
        <extracomment>%1 &quot;First&quot;, %2 &quot;turning left&quot;</extracomment>
        <translation>%1: uma curva. Siga por ela, %2.</translation>
    </message>
    <message>
        <source>your destination</source>
        <translation>o seu destino</translation>
    </message>
    <message>
        <source>Now turn slowly to the left, past where you began.</source>
        <translation>Agora vire-se devagar para a esquerda, passando de onde começou.</translation>
    </message>
    <message>
        <source>Hold still, and tilt the camera slowly up.</source>
        <translation>Não se mexa, e incline a câmara devagar para cima.</translation>
    </message>
    <message>
        <source>Now tilt it slowly down.</source>
        <translation>Agora incline-a devagar para baixo.</translation>
    </message>
    <message>
        <source>I still do not know where you are. If you can, move a few steps along a wall, or ask for help.</source>
        <translation>Ainda não sei onde está. Se puder, avance alguns passos junto a uma parede, ou peça ajuda.</translation>
    </message>
    <message>
        <source>Thank you, that is enough.</source>
        <translation>Obrigado, é suficiente.</translation>
    </message>
    <message>
        <source>Start slowly: I will tell you if it is the wrong way.</source>
        <translation>Comece devagar: eu aviso se for o sentido errado.</translation>
    </message>
    <message>
        <source>You are walking the wrong way.</source>
        <translation>Está a andar no sentido errado.</translation>
    </message>
    <message>
        <source>You are probably walking the wrong way.</source>
        <translation>Está provavelmente a andar no sentido errado.</translation>
    </message>
    <message>
        <source>You have gone too far.</source>
        <translation>Foi longe demais.</translation>
    </message>
    <message>
        <source>You have probably gone too far.</source>
        <translation>Foi provavelmente longe demais.</translation>
    </message>
    <message>
        <source>No destination is chosen yet. Choose one first.</source>
        <translation>Ainda não há destino escolhido. Escolha um primeiro.</translation>
    </message>
    <message>
        <source>near you</source>
        <translation>perto de si</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>what is around</comment>
        <extracomment>%1 &quot;a door&quot;, %2 a name</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>I know of nothing near you.</source>
        <translation>Não conheço nada perto de si.</translation>
    </message>
    <message>
        <source>The directions are as you face along your way.</source>
        <translation>As direções são as de quem segue o seu caminho.</translation>
    </message>
    <message>
        <source>The directions are those of the map.</source>
        <translation>As direções são as do mapa.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what is around</comment>
        <extracomment>%1 &quot;on your left&quot;, %2 &quot;a door, Library; an extinguisher&quot;</extracomment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>em frente</translation>
    </message>
    <message>
        <source>next</source>
        <comment>door or opening</comment>
        <translation>próxima</translation>
    </message>
    <message>
        <source>get out of the lift</source>
        <translation>saia do elevador</translation>
    </message>
    <message>
        <source>go into the lift</source>
        <translation>entre no elevador</translation>
    </message>
    <message>
        <source>go into the lift %1</source>
        <translation>entre no elevador %1</translation>
    </message>
    <message>
        <source>go straight on through the door</source>
        <translation>siga em frente e atravesse a porta</translation>
    </message>
    <message>
        <source>go straight on through the opening</source>
        <translation>siga em frente e atravesse a abertura</translation>
    </message>
    <message>
        <source>go through the door %1</source>
        <translation>atravesse a porta %1</translation>
    </message>
    <message>
        <source>go through the opening %1</source>
        <translation>atravesse a abertura %1</translation>
    </message>
    <message>
        <source>go through the %1 door %2</source>
        <translation>atravesse a %1 porta %2</translation>
    </message>
    <message>
        <source>go through the %1 opening %2</source>
        <translation>atravesse a %1 abertura %2</translation>
    </message>
    <message>
        <source>follow the wall on your left and go through the opening</source>
        <translation>siga a parede à sua esquerda e atravesse a abertura</translation>
    </message>
    <message>
        <source>follow the wall on your right and go through the opening</source>
        <translation>siga a parede à sua direita e atravesse a abertura</translation>
    </message>
    <message>
        <source>follow the wall on your left and go through the %1 door</source>
        <extracomment>%1 &quot;second&quot;</extracomment>
        <translation>siga a parede à sua esquerda e atravesse a %1 porta</translation>
    </message>
    <message>
        <source>follow the wall on your right and go through the %1 door</source>
        <translation>siga a parede à sua direita e atravesse a %1 porta</translation>
    </message>
    <message>
        <source>%1, then %2</source>
        <extracomment>%1 &quot;go through the door&quot;, %2 &quot;turn left&quot;</extracomment>
        <translation>%1, depois %2</translation>
    </message>
    <message>
        <source>stay in the lift</source>
        <translation>fique no elevador</translation>
    </message>
    <message>
        <source>stay in the lift until: %1</source>
        <translation>fique no elevador até: %1</translation>
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
        <source>%1, %2</source>
        <comment>mark</comment>
        <extracomment>%1 &quot;turn left&quot;, %2 &quot;after the extinguisher&quot;</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>And %n more thing(s) to do after that.</source>
        <translation>
            <numerusform>E depois disso, mais %n indicação.</numerusform>
            <numerusform>E depois disso, mais %n indicações.</numerusform>
        </translation>
    </message>
    <message>
        <source>first</source>
        <comment>door or opening</comment>
        <translation>primeira</translation>
    </message>
    <message>
        <source>second</source>
        <comment>door or opening</comment>
        <translation>segunda</translation>
    </message>
    <message>
        <source>third</source>
        <comment>door or opening</comment>
        <translation>terceira</translation>
    </message>
    <message>
        <source>fourth</source>
        <comment>door or opening</comment>
        <translation>quarta</translation>
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
        <translation>sétima</translation>
    </message>
    <message>
        <source>eighth</source>
        <comment>door or opening</comment>
        <translation>oitava</translation>
    </message>
    <message>
        <source>after the extinguisher</source>
        <translation>depois do extintor</translation>
    </message>
    <message>
        <source>after the drinking fountain</source>
        <translation>depois do bebedouro</translation>
    </message>
    <message>
        <source>after the hydrant</source>
        <translation>depois da boca de incêndio</translation>
    </message>
    <message>
        <source>after the vending machine</source>
        <translation>depois da máquina de venda</translation>
    </message>
    <message>
        <source>after the waste bin</source>
        <translation>depois do caixote do lixo</translation>
    </message>
    <message>
        <source>after the plant</source>
        <translation>depois da planta</translation>
    </message>
    <message>
        <source>after the locker</source>
        <translation>depois do cacifo</translation>
    </message>
    <message>
        <source>a room</source>
        <translation>uma sala</translation>
    </message>
    <message>
        <source>a corridor</source>
        <translation>um corredor</translation>
    </message>
    <message>
        <source>a hall</source>
        <translation>um átrio</translation>
    </message>
    <message>
        <source>a stairwell</source>
        <translation>uma caixa de escadas</translation>
    </message>
    <message>
        <source>a toilet</source>
        <translation>uma casa de banho</translation>
    </message>
    <message>
        <source>outside the building</source>
        <translation>fora do edifício</translation>
    </message>
    <message>
        <source>to the north-east</source>
        <translation>a nordeste</translation>
    </message>
    <message>
        <source>to the east</source>
        <translation>a este</translation>
    </message>
    <message>
        <source>to the south-east</source>
        <translation>a sudeste</translation>
    </message>
    <message>
        <source>to the south</source>
        <translation>a sul</translation>
    </message>
    <message>
        <source>to the south-west</source>
        <translation>a sudoeste</translation>
    </message>
    <message>
        <source>to the west</source>
        <translation>a oeste</translation>
    </message>
    <message>
        <source>to the north-west</source>
        <translation>a noroeste</translation>
    </message>
    <message>
        <source>to the north</source>
        <translation>a norte</translation>
    </message>
    <message numerus="yes">
        <source>About %n foot(feet).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Cerca de %n pé.</numerusform>
            <numerusform>Cerca de %n pés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n step(s).</source>
        <comment>length of the route</comment>
        <translation>
            <numerusform>Cerca de %n passo.</numerusform>
            <numerusform>Cerca de %n passos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n foot(feet)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>Daqui a cerca de %n pé</numerusform>
            <numerusform>Daqui a cerca de %n pés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In about %n step(s)</source>
        <comment>then what is there</comment>
        <translation>
            <numerusform>Daqui a cerca de %n passo</numerusform>
            <numerusform>Daqui a cerca de %n passos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n foot(feet).</source>
        <translation>
            <numerusform>Continue em frente cerca de %n pé.</numerusform>
            <numerusform>Continue em frente cerca de %n pés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep moving forward for about %n step(s).</source>
        <translation>
            <numerusform>Continue em frente cerca de %n passo.</numerusform>
            <numerusform>Continue em frente cerca de %n passos.</numerusform>
        </translation>
    </message>
    <message>
        <source>go straight on through two doors in a row</source>
        <translation>siga em frente e atravesse duas portas seguidas</translation>
    </message>
    <message>
        <source>go straight on through two openings in a row</source>
        <translation>siga em frente e atravesse duas aberturas seguidas</translation>
    </message>
    <message>
        <source>go straight on through the next door</source>
        <translation>siga em frente e atravesse a próxima porta</translation>
    </message>
    <message>
        <source>go straight on through the next opening</source>
        <translation>siga em frente e atravesse a próxima abertura</translation>
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
        <source>an extinguisher</source>
        <translation>um extintor</translation>
    </message>
    <message>
        <source>an exit sign</source>
        <translation>um sinal de saída</translation>
    </message>
    <message>
        <source>a sign</source>
        <translation>uma placa</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>um texto</translation>
    </message>
    <message>
        <source>a window</source>
        <translation>uma janela</translation>
    </message>
    <message>
        <source>a locker</source>
        <translation>um cacifo</translation>
    </message>
    <message>
        <source>a poster</source>
        <translation>um cartaz</translation>
    </message>
    <message>
        <source>a drinking fountain</source>
        <translation>um bebedouro</translation>
    </message>
    <message>
        <source>a hydrant</source>
        <translation>uma boca de incêndio</translation>
    </message>
    <message>
        <source>a vending machine</source>
        <translation>uma máquina de venda automática</translation>
    </message>
    <message>
        <source>a waste bin</source>
        <translation>um caixote do lixo</translation>
    </message>
    <message>
        <source>a plant</source>
        <translation>uma planta</translation>
    </message>
    <message>
        <source>a piece of furniture</source>
        <translation>um móvel</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>um quadro</translation>
    </message>
    <message>
        <source>turn slightly left</source>
        <comment>on the spot</comment>
        <translation>vire-se um pouco para a esquerda</translation>
    </message>
    <message>
        <source>turn left</source>
        <comment>on the spot</comment>
        <translation>vire-se para a esquerda</translation>
    </message>
    <message>
        <source>turn sharply left</source>
        <comment>on the spot</comment>
        <translation>vire-se muito para a esquerda</translation>
    </message>
    <message>
        <source>turn slightly right</source>
        <comment>on the spot</comment>
        <translation>vire-se um pouco para a direita</translation>
    </message>
    <message>
        <source>turn right</source>
        <comment>on the spot</comment>
        <translation>vire-se para a direita</translation>
    </message>
    <message>
        <source>turn sharply right</source>
        <comment>on the spot</comment>
        <translation>vire-se muito para a direita</translation>
    </message>
    <message>
        <source>Stop.</source>
        <extracomment>To somebody who walks, or is opening a door</extracomment>
        <translation>Pare.</translation>
    </message>
</context>
<context>
    <name>farol::ui::PictureReel</name>
    <message>
        <source>There are no pictures in %1.</source>
        <translation>Não há imagens em %1.</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlaceChooser</name>
    <message>
        <source>No such place</source>
        <translation>Não há tal lugar</translation>
    </message>
    <message numerus="yes">
        <source>%n places fit: choose one</source>
        <translation>
            <numerusform>%n lugar condiz: escolha-o</numerusform>
            <numerusform>%n lugares condizem: escolha um</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Go to:</source>
        <translation>&amp;Ir para:</translation>
    </message>
    <message>
        <source>Start &amp;at:</source>
        <translation>&amp;Começar em:</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destino</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Início</translation>
    </message>
    <message>
        <source>type a name or room number</source>
        <translation>escreva um nome ou número de sala</translation>
    </message>
    <message>
        <source>not known, Farol looks for it</source>
        <translation>desconhecido, o Farol procura-o</translation>
    </message>
    <message>
        <source>Where to go: type part of a name, room number or level, then choose</source>
        <translation>Para onde ir: escreva parte de um nome, número de sala ou piso e depois escolha</translation>
    </message>
    <message>
        <source>Where the walk starts, if you know it</source>
        <translation>Onde começa o percurso, se o souber</translation>
    </message>
    <message>
        <source>F&amp;rom:</source>
        <translation>&amp;De:</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Where the route begins: type part of a name, room number or level, then choose</source>
        <translation>Onde começa o caminho: escreva parte de um nome, número de sala ou piso, e escolha</translation>
    </message>
    <message>
        <source>&amp;To:</source>
        <translation>Pa&amp;ra:</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Para</translation>
    </message>
    <message>
        <source>Where the route ends: type part of a name, room number or level, then choose</source>
        <translation>Onde acaba o caminho: escreva parte de um nome, número de sala ou piso, e escolha</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
    </message>
    <message>
        <source>Type part of a name, room number or level, then choose</source>
        <translation>Escreva parte de um nome, número de sala ou piso, e escolha</translation>
    </message>
    <message>
        <source>Clear the line</source>
        <translation>Limpar a linha</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlanLegend</name>
    <message>
        <source>no landmark</source>
        <translation>sem ponto de referência</translation>
    </message>
    <message>
        <source>looks like another place</source>
        <translation>parecido com outro local</translation>
    </message>
    <message>
        <source>a landmark here helps most</source>
        <translation>aqui um ponto de referência ajuda mais</translation>
    </message>
    <message>
        <source>not joined with the rest</source>
        <translation>sem ligação ao resto</translation>
    </message>
    <message>
        <source>Legend: %1</source>
        <translation>Legenda: %1</translation>
    </message>
    <message>
        <source>sees no landmark</source>
        <translation>não vê nenhum</translation>
    </message>
    <message>
        <source>sees one</source>
        <translation>vê um ponto de referência</translation>
    </message>
    <message>
        <source>sees several</source>
        <translation>vê vários</translation>
    </message>
</context>
<context>
    <name>farol::ui::PlanPanel</name>
    <message>
        <source>No map is open.</source>
        <translation>Não há nenhum mapa aberto.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n region(s), %2</source>
        <translation>
            <numerusform>%1: %n espaço, %2</numerusform>
            <numerusform>%1: %n espaços, %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n landmark(s)</source>
        <translation>
            <numerusform>%n ponto de referência</numerusform>
            <numerusform>%n pontos de referência</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Level:</source>
        <translation>&amp;Piso:</translation>
    </message>
    <message>
        <source>Level of the plan</source>
        <translation>Piso da planta</translation>
    </message>
    <message>
        <source>The floor that the plan shows (Page Up and Page Down in the plan)</source>
        <translation>O piso que a planta mostra (Page Up e Page Down na planta)</translation>
    </message>
    <message>
        <source>Larger (+)</source>
        <translation>Maior (+)</translation>
    </message>
    <message>
        <source>Smaller (-)</source>
        <translation>Menor (-)</translation>
    </message>
    <message>
        <source>Show the whole floor (0)</source>
        <translation>Mostrar o piso inteiro (0)</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planta</translation>
    </message>
    <message>
        <source>Drag to move, turn the wheel to zoom. What is chosen can be dragged, or moved by Alt and the arrows</source>
        <translation>Arraste para mover, rode a roda para ampliar. O que está escolhido pode ser arrastado, ou movido com Alt e as setas</translation>
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
        <translation>Usar as definições de %1</translation>
    </message>
    <message>
        <source>&amp;New user…</source>
        <translation>&amp;Novo utilizador…</translation>
    </message>
    <message>
        <source>New user</source>
        <translation>Novo utilizador</translation>
    </message>
    <message>
        <source>Name; the new user begins with the settings as they are now:</source>
        <translation>Nome; o novo utilizador começa com as definições atuais:</translation>
    </message>
    <message>
        <source>&amp;User</source>
        <translation>&amp;Utilizador</translation>
    </message>
    <message>
        <source>“%1” cannot be used as a name: it must not hold a slash.</source>
        <translation>“%1” não serve de nome: não pode ter uma barra.</translation>
    </message>
</context>
<context>
    <name>farol::ui::RegionDialog</name>
    <message>
        <source>Region %1</source>
        <translation>Espaço %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>What is spoken</source>
        <translation>O que é dito</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>The number on the door</source>
        <translation>O número na porta</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What sort of place it is</source>
        <translation>Que tipo de local é</translation>
    </message>
    <message>
        <source>Restricted</source>
        <translation>Reservado</translation>
    </message>
    <message>
        <source>Not open to everyone</source>
        <translation>Não está aberto a todos</translation>
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
            <numerusform>%n erro</numerusform>
            <numerusform>%n erros</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n aviso</numerusform>
            <numerusform>%n avisos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n nota</numerusform>
            <numerusform>%n notas</numerusform>
        </translation>
    </message>
    <message>
        <source>No map is open.</source>
        <translation>Não há nenhum mapa aberto.</translation>
    </message>
    <message>
        <source>The map was changed after this check: %1.</source>
        <translation>O mapa foi alterado depois desta verificação: %1.</translation>
    </message>
    <message>
        <source>Nothing is wrong with this map.</source>
        <translation>Não há nada errado neste mapa.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Achados</translation>
    </message>
    <message>
        <source>What is wrong with the map; choose a finding to see its place on the plan</source>
        <translation>O que está errado no mapa; escolha um achado para ver o seu lugar na planta</translation>
    </message>
    <message>
        <source>The finding in words</source>
        <translation>O achado por palavras</translation>
    </message>
    <message>
        <source>The finding in words, and what to do</source>
        <translation>O achado por palavras, e o que fazer</translation>
    </message>
    <message>
        <source>Chec&amp;k again</source>
        <translation>Verificar outra ve&amp;z</translation>
    </message>
    <message>
        <source>Look for what is wrong with the map as it is now (F7)</source>
        <translation>Ver o que está errado no mapa como está agora (F7)</translation>
    </message>
    <message>
        <source>Choose a finding to read what it means and what to do.</source>
        <translation>Escolha um resultado para ler o que significa e o que fazer.</translation>
    </message>
    <message>
        <source>Ne&amp;xt place</source>
        <translation>Lugar se&amp;guinte</translation>
    </message>
    <message>
        <source>Show the next place of this finding (F4)</source>
        <translation>Mostrar o lugar seguinte deste resultado (F4)</translation>
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
        <translation>Recalcular um percurso gravado</translation>
    </message>
    <message>
        <source>Folder of the recorded walk</source>
        <translation>Pasta do percurso gravado</translation>
    </message>
    <message>
        <source>Where the recorded walk is kept</source>
        <translation>Onde está o percurso gravado</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Procurar…</translation>
    </message>
    <message>
        <source>Browse for the recorded walk</source>
        <translation>Procurar o percurso gravado</translation>
    </message>
    <message>
        <source>Folder of a recorded walk</source>
        <translation>Pasta de um percurso gravado</translation>
    </message>
    <message>
        <source>How the place is worked out now</source>
        <translation>Como se calcula agora o lugar</translation>
    </message>
    <message>
        <source>What the recorded walk is worked out with the second time</source>
        <translation>Com que se calcula o percurso gravado da segunda vez</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Work the walk out as it was, and once more with the other choice</source>
        <translation>Calcular o percurso como foi, e outra vez com a outra escolha</translation>
    </message>
    <message>
        <source>The pictures are not looked at again: what was recognised then is taken, and the place is worked out anew.</source>
        <translation>As imagens não são vistas de novo: usa-se o que então se reconheceu, e o lugar é recalculado.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imagens</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Agora</translation>
    </message>
    <message>
        <source>Where the two differ</source>
        <translation>Onde os dois diferem</translation>
    </message>
    <message>
        <source>&amp;Recorded walk:</source>
        <translation>&amp;Percurso gravado:</translation>
    </message>
    <message>
        <source>&amp;Worked out by:</source>
        <translation>Calc&amp;ulado por:</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>A trabalhar…</translation>
    </message>
    <message>
        <source>%1 before, %2 now. The same place on %3 of %4 pictures (%5 %). Sentences: %6 before, %7 now.</source>
        <translation>Antes %1, agora %2. O mesmo lugar em %3 de %4 imagens (%5 %). Frases: %6 antes, %7 agora.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>não se sabe</translation>
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
        <translation>Comece em: %1.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Após</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>O que fazer</translation>
    </message>
</context>
<context>
    <name>farol::ui::RoutePanel</name>
    <message>
        <source>No map is open.</source>
        <translation>Não há nenhum mapa aberto.</translation>
    </message>
    <message>
        <source>Looking for the way…</source>
        <translation>À procura do caminho…</translation>
    </message>
    <message>
        <source>There is no way. %1</source>
        <translation>Não há caminho. %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 m, about %n minute(s), through %2.</source>
        <translation>
            <numerusform>%1 m, cerca de %n minuto, por %2.</numerusform>
            <numerusform>%1 m, cerca de %n minutos, por %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n door(s) and passage(s)</source>
        <translation>
            <numerusform>%n porta ou passagem</numerusform>
            <numerusform>%n portas e passagens</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose where the route begins and ends, here or by the menu of a place on the plan.</source>
        <translation>Escolha onde o caminho começa e acaba, aqui ou no menu de um local na planta.</translation>
    </message>
    <message>
        <source>Swa&amp;p</source>
        <translation>&amp;Trocar</translation>
    </message>
    <message>
        <source>The way back: exchange where the route begins and ends</source>
        <translation>O caminho de volta: trocar o começo e o fim</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>Evitar</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>escadas</translation>
    </message>
    <message>
        <source>Find a way without stairs</source>
        <translation>Procurar um caminho sem escadas</translation>
    </message>
    <message>
        <source>lifts</source>
        <translation>elevadores</translation>
    </message>
    <message>
        <source>Find a way without lifts</source>
        <translation>Procurar um caminho sem elevadores</translation>
    </message>
    <message>
        <source>escalators</source>
        <translation>escadas rolantes</translation>
    </message>
    <message>
        <source>Find a way without escalators</source>
        <translation>Procurar um caminho sem escadas rolantes</translation>
    </message>
    <message>
        <source>restricted regions</source>
        <translation>espaços reservados</translation>
    </message>
    <message>
        <source>Find a way that is open to everyone</source>
        <translation>Procurar um caminho aberto a todos</translation>
    </message>
    <message>
        <source>Sentences of the route</source>
        <translation>Frases do caminho</translation>
    </message>
    <message>
        <source>What the walker hears; choose a sentence to see its place on the plan</source>
        <translation>O que a pessoa ouve; escolha uma frase para ver o seu lugar na planta</translation>
    </message>
</context>
<context>
    <name>farol::ui::RuleWords</name>
    <message>
        <source>Outlines that are no proper outline</source>
        <translation>Contornos que não são contornos corretos</translation>
    </message>
    <message>
        <source>Draw the outline again so that it does not cross itself.</source>
        <translation>Desenhe o contorno de novo, sem que se cruze a si próprio.</translation>
    </message>
    <message>
        <source>Regions that share an id</source>
        <translation>Espaços com o mesmo identificador</translation>
    </message>
    <message>
        <source>Give each region an id of its own.</source>
        <translation>Dê a cada espaço um identificador próprio.</translation>
    </message>
    <message>
        <source>Doors that share an id</source>
        <translation>Portas com o mesmo identificador</translation>
    </message>
    <message>
        <source>Give each door or passage an id of its own.</source>
        <translation>Dê a cada porta ou passagem um identificador próprio.</translation>
    </message>
    <message>
        <source>Landmarks that share an id</source>
        <translation>Pontos de referência com o mesmo identificador</translation>
    </message>
    <message>
        <source>Give each landmark an id of its own.</source>
        <translation>Dê a cada ponto de referência um identificador próprio.</translation>
    </message>
    <message>
        <source>Doors that do not join two regions</source>
        <translation>Portas que não ligam dois espaços</translation>
    </message>
    <message>
        <source>Choose the region on each side of the door.</source>
        <translation>Escolha o espaço de cada lado da porta.</translation>
    </message>
    <message>
        <source>Doors to regions that do not exist</source>
        <translation>Portas para espaços que não existem</translation>
    </message>
    <message>
        <source>Choose regions that are on the map for both sides.</source>
        <translation>Escolha para os dois lados espaços que estejam no mapa.</translation>
    </message>
    <message>
        <source>Doors far from the regions they join</source>
        <translation>Portas longe dos espaços que ligam</translation>
    </message>
    <message>
        <source>Move the door to where the two regions meet.</source>
        <translation>Mova a porta para onde os dois espaços se encontram.</translation>
    </message>
    <message>
        <source>Doors drawn on fewer or more than two regions</source>
        <translation>Portas desenhadas em menos ou mais do que dois espaços</translation>
    </message>
    <message>
        <source>Doors beside more than two regions</source>
        <translation>Portas junto a mais de dois espaços</translation>
    </message>
    <message>
        <source>See that the two sides are the right ones.</source>
        <translation>Veja se os dois lados são os certos.</translation>
    </message>
    <message>
        <source>Passages drawn along the way instead of across it</source>
        <translation>Passagens desenhadas ao longo do caminho em vez de o atravessar</translation>
    </message>
    <message>
        <source>If one walks along the line, choose its two sides by hand.</source>
        <translation>Se se anda ao longo da linha, escolha os dois lados à mão.</translation>
    </message>
    <message>
        <source>Doors without a place on the map</source>
        <translation>Portas sem lugar no mapa</translation>
    </message>
    <message>
        <source>Draw them in the source, or put them in here.</source>
        <translation>Desenhe-as na origem, ou ponha-as aqui.</translation>
    </message>
    <message>
        <source>Stairs or lifts that do not change the level</source>
        <translation>Escadas ou elevadores que não mudam de piso</translation>
    </message>
    <message>
        <source>Choose regions of two levels, or another kind.</source>
        <translation>Escolha espaços de dois pisos, ou outro tipo.</translation>
    </message>
    <message>
        <source>Parts of the building that no way joins</source>
        <translation>Partes do edifício que nenhum caminho liga</translation>
    </message>
    <message>
        <source>Put in the door, stairs or lift that joins them.</source>
        <translation>Ponha a porta, a escada ou o elevador que as liga.</translation>
    </message>
    <message>
        <source>Regions without any door</source>
        <translation>Espaços sem nenhuma porta</translation>
    </message>
    <message>
        <source>Put in the door that leads there.</source>
        <translation>Ponha a porta que lá leva.</translation>
    </message>
    <message>
        <source>Regions without a name</source>
        <translation>Espaços sem nome</translation>
    </message>
    <message>
        <source>Give them the name that people use.</source>
        <translation>Dê-lhes o nome que as pessoas usam.</translation>
    </message>
    <message>
        <source>Regions of one level with the same number</source>
        <translation>Espaços de um piso com o mesmo número</translation>
    </message>
    <message>
        <source>Correct the number of one of them.</source>
        <translation>Corrija o número de um deles.</translation>
    </message>
    <message>
        <source>Regions as narrow as a wall</source>
        <translation>Espaços tão estreitos como uma parede</translation>
    </message>
    <message>
        <source>Join them with their neighbour in the source.</source>
        <translation>Junte-os ao vizinho na origem.</translation>
    </message>
    <message>
        <source>Regions that overlap</source>
        <translation>Espaços que se sobrepõem</translation>
    </message>
    <message>
        <source>Draw the border between them in the source.</source>
        <translation>Desenhe na origem a fronteira entre eles.</translation>
    </message>
    <message>
        <source>Regions inside other regions</source>
        <translation>Espaços dentro de outros espaços</translation>
    </message>
    <message>
        <source>Cut the smaller one out of the larger one, unless it is a part of it.</source>
        <translation>Recorte o menor do maior, a não ser que faça parte dele.</translation>
    </message>
    <message>
        <source>Regions drawn twice</source>
        <translation>Espaços desenhados duas vezes</translation>
    </message>
    <message>
        <source>Remove one of them in the source.</source>
        <translation>Retire um deles na origem.</translation>
    </message>
    <message>
        <source>Regions in several parts</source>
        <translation>Espaços em várias partes</translation>
    </message>
    <message>
        <source>Each part became a region; give the parts names of their own.</source>
        <translation>Cada parte ficou um espaço; dê às partes nomes próprios.</translation>
    </message>
    <message>
        <source>Landmarks in regions that do not exist</source>
        <translation>Pontos de referência em espaços que não existem</translation>
    </message>
    <message>
        <source>Move the landmark into a region.</source>
        <translation>Mova o ponto de referência para um espaço.</translation>
    </message>
    <message>
        <source>Landmarks outside their region</source>
        <translation>Pontos de referência fora do seu espaço</translation>
    </message>
    <message>
        <source>Move the landmark into its region.</source>
        <translation>Mova o ponto de referência para o seu espaço.</translation>
    </message>
    <message>
        <source>Landmarks that were given their region by their place</source>
        <translation>Pontos de referência que receberam o espaço pelo seu lugar</translation>
    </message>
    <message>
        <source>Levels that the list of levels does not name</source>
        <translation>Pisos que a lista de pisos não nomeia</translation>
    </message>
    <message>
        <source>Add the level to the list in the source.</source>
        <translation>Junte o piso à lista na origem.</translation>
    </message>
    <message>
        <source>Levels named twice</source>
        <translation>Pisos nomeados duas vezes</translation>
    </message>
    <message>
        <source>Levels without a usable number</source>
        <translation>Pisos sem número utilizável</translation>
    </message>
    <message>
        <source>Give the level a number in the source.</source>
        <translation>Dê ao piso um número na origem.</translation>
    </message>
    <message>
        <source>Features whose level was assumed</source>
        <translation>Elementos cujo piso foi suposto</translation>
    </message>
    <message>
        <source>Add the level in the source.</source>
        <translation>Indique o piso na origem.</translation>
    </message>
    <message>
        <source>Links between levels that lead nowhere</source>
        <translation>Ligações entre pisos que não levam a lado nenhum</translation>
    </message>
    <message>
        <source>Choose regions that are on the map.</source>
        <translation>Escolha espaços que estejam no mapa.</translation>
    </message>
    <message>
        <source>Stairs and lifts joined because they lie above one another</source>
        <translation>Escadas e elevadores ligados por estarem uns sobre os outros</translation>
    </message>
    <message>
        <source>See that they really are one.</source>
        <translation>Veja se são mesmo os mesmos.</translation>
    </message>
    <message>
        <source>Stairs or lifts that leave out a level</source>
        <translation>Escadas ou elevadores que saltam um piso</translation>
    </message>
    <message>
        <source>Add the stop, if there is one.</source>
        <translation>Junte a paragem, se existir.</translation>
    </message>
    <message>
        <source>Kinds that are not known</source>
        <translation>Tipos que não são conhecidos</translation>
    </message>
    <message>
        <source>Choose one of the kinds that Farol knows.</source>
        <translation>Escolha um dos tipos que o Farol conhece.</translation>
    </message>
    <message>
        <source>Degrees where metres are meant</source>
        <translation>Graus onde se querem metros</translation>
    </message>
    <message>
        <source>See that the building has its right size.</source>
        <translation>Veja se o edifício tem o tamanho certo.</translation>
    </message>
    <message>
        <source>Metres where degrees are meant</source>
        <translation>Metros onde se querem graus</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not named</source>
        <translation>O sistema das coordenadas não é indicado</translation>
    </message>
    <message>
        <source>Name the coordinate system in the source.</source>
        <translation>Indique na origem o sistema de coordenadas.</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not understood</source>
        <translation>O sistema das coordenadas não se entende</translation>
    </message>
    <message>
        <source>Name a common coordinate system in the source.</source>
        <translation>Indique na origem um sistema de coordenadas comum.</translation>
    </message>
    <message>
        <source>Coordinates were converted to metres</source>
        <translation>As coordenadas foram convertidas em metros</translation>
    </message>
    <message>
        <source>North and east were exchanged</source>
        <translation>Norte e este foram trocados</translation>
    </message>
    <message>
        <source>Export the map again to be sure.</source>
        <translation>Exporte o mapa outra vez para ter a certeza.</translation>
    </message>
    <message>
        <source>Points that are no places</source>
        <translation>Pontos que não são lugares</translation>
    </message>
    <message>
        <source>See whether something is missing there.</source>
        <translation>Veja se falta lá alguma coisa.</translation>
    </message>
    <message>
        <source>Features without a shape</source>
        <translation>Elementos sem forma</translation>
    </message>
    <message>
        <source>Draw them in the source if they are needed.</source>
        <translation>Desenhe-os na origem, se forem precisos.</translation>
    </message>
    <message>
        <source>Features without a usable shape</source>
        <translation>Elementos sem forma utilizável</translation>
    </message>
    <message>
        <source>Layers without features</source>
        <translation>Camadas sem elementos</translation>
    </message>
    <message>
        <source>Layers whose meaning is not clear</source>
        <translation>Camadas cujo sentido não é claro</translation>
    </message>
    <message>
        <source>Say in a profile what the layer holds.</source>
        <translation>Diga num perfil o que a camada contém.</translation>
    </message>
    <message>
        <source>Layers that were not used</source>
        <translation>Camadas que não foram usadas</translation>
    </message>
    <message>
        <source>Codes without a meaning</source>
        <translation>Códigos sem significado</translation>
    </message>
    <message>
        <source>Say in a profile what the code means.</source>
        <translation>Diga num perfil o que o código quer dizer.</translation>
    </message>
    <message>
        <source>Openings added where no wall stands between regions</source>
        <translation>Aberturas postas onde não há parede entre espaços</translation>
    </message>
    <message>
        <source>See that one can really walk through.</source>
        <translation>Veja se se pode mesmo passar.</translation>
    </message>
    <message>
        <source>Escalators without a direction</source>
        <translation>Escadas rolantes sem sentido</translation>
    </message>
    <message>
        <source>Say which way they run.</source>
        <translation>Diga em que sentido andam.</translation>
    </message>
    <message>
        <source>Amenities without a known level</source>
        <translation>Serviços sem piso conhecido</translation>
    </message>
    <message>
        <source>Name the level in the source.</source>
        <translation>Indique o piso na origem.</translation>
    </message>
    <message>
        <source>Amenities without a place</source>
        <translation>Serviços sem lugar</translation>
    </message>
    <message>
        <source>Give them a point in the source.</source>
        <translation>Dê-lhes um ponto na origem.</translation>
    </message>
    <message>
        <source>Categories that are not known</source>
        <translation>Categorias que não são conhecidas</translation>
    </message>
    <message>
        <source>Levels without an id</source>
        <translation>Pisos sem identificador</translation>
    </message>
    <message>
        <source>Give the level an id in the source.</source>
        <translation>Dê ao piso um identificador na origem.</translation>
    </message>
    <message>
        <source>Levels without an ordinal</source>
        <translation>Pisos sem ordinal</translation>
    </message>
    <message>
        <source>Give the level an ordinal in the source.</source>
        <translation>Dê ao piso um ordinal na origem.</translation>
    </message>
    <message>
        <source>Parts of the IMDF archive that were not used</source>
        <translation>Partes do arquivo IMDF que não foram usadas</translation>
    </message>
    <message>
        <source>Walls, columns and voids drawn as units</source>
        <translation>Paredes, colunas e vazios desenhados como unidades</translation>
    </message>
    <message>
        <source>Occupants without a place</source>
        <translation>Ocupantes sem lugar</translation>
    </message>
    <message>
        <source>Name the anchor in the source.</source>
        <translation>Indique a âncora na origem.</translation>
    </message>
    <message>
        <source>Openings that are closed</source>
        <translation>Aberturas que estão fechadas</translation>
    </message>
    <message>
        <source>Openings without a line</source>
        <translation>Aberturas sem linha</translation>
    </message>
    <message>
        <source>Draw the opening as a line in the source.</source>
        <translation>Desenhe a abertura como linha na origem.</translation>
    </message>
    <message>
        <source>Relationships that do not name two units</source>
        <translation>Relações que não nomeiam duas unidades</translation>
    </message>
    <message>
        <source>Name the two units in the source.</source>
        <translation>Nomeie as duas unidades na origem.</translation>
    </message>
    <message>
        <source>Units without an outline</source>
        <translation>Unidades sem contorno</translation>
    </message>
    <message>
        <source>Draw the outline in the source.</source>
        <translation>Desenhe o contorno na origem.</translation>
    </message>
    <message>
        <source>Doors that stand on no outline</source>
        <translation>Portas que não estão em nenhum contorno</translation>
    </message>
    <message>
        <source>Draw the door on the outline of its room.</source>
        <translation>Desenhe a porta no contorno da sua sala.</translation>
    </message>
    <message>
        <source>Openings put where a way enters a room</source>
        <translation>Aberturas postas onde um caminho entra numa sala</translation>
    </message>
    <message>
        <source>Draw the door in the source.</source>
        <translation>Desenhe a porta na origem.</translation>
    </message>
    <message>
        <source>Objects whose level is not clear</source>
        <translation>Objetos cujo piso não é claro</translation>
    </message>
    <message>
        <source>Objects far from every region</source>
        <translation>Objetos longe de todos os espaços</translation>
    </message>
    <message>
        <source>Draw the room they stand in.</source>
        <translation>Desenhe a sala em que estão.</translation>
    </message>
    <message>
        <source>Features without a level</source>
        <translation>Elementos sem piso</translation>
    </message>
    <message>
        <source>Levels that cannot be read</source>
        <translation>Pisos que não se conseguem ler</translation>
    </message>
    <message>
        <source>Correct the level in the source.</source>
        <translation>Corrija o piso na origem.</translation>
    </message>
    <message>
        <source>Lifts without a door</source>
        <translation>Elevadores sem porta</translation>
    </message>
    <message>
        <source>Move the door to its place.</source>
        <translation>Mova a porta para o seu lugar.</translation>
    </message>
    <message>
        <source>Lifts that are only a point</source>
        <translation>Elevadores que são só um ponto</translation>
    </message>
    <message>
        <source>Steps that lead nowhere</source>
        <translation>Degraus que não levam a lado nenhum</translation>
    </message>
    <message>
        <source>Draw the area or way that they lead to.</source>
        <translation>Desenhe a área ou o caminho a que levam.</translation>
    </message>
    <message>
        <source>Steps that may go up or down</source>
        <translation>Degraus que podem subir ou descer</translation>
    </message>
    <message>
        <source>Say in the source which end is up.</source>
        <translation>Diga na origem qual é o lado de cima.</translation>
    </message>
    <message>
        <source>Steps without a length</source>
        <translation>Degraus sem comprimento</translation>
    </message>
    <message>
        <source>Draw the line of the steps.</source>
        <translation>Desenhe a linha dos degraus.</translation>
    </message>
    <message>
        <source>Cells that could not be used</source>
        <translation>Células que não se puderam usar</translation>
    </message>
    <message>
        <source>Give each cell an outline and an id.</source>
        <translation>Dê a cada célula um contorno e um identificador.</translation>
    </message>
    <message>
        <source>The coordinates&apos; system is not known</source>
        <translation>O sistema das coordenadas não é conhecido</translation>
    </message>
    <message>
        <source>Doors that do not lie between two rooms</source>
        <translation>Portas que não estão entre duas salas</translation>
    </message>
    <message>
        <source>Levels that nothing tells</source>
        <translation>Pisos que nada indica</translation>
    </message>
    <message>
        <source>Say where the level stands when importing.</source>
        <translation>Diga ao importar onde está o piso.</translation>
    </message>
    <message>
        <source>Levels counted from the heights of the floors</source>
        <translation>Pisos contados pelas alturas do chão</translation>
    </message>
    <message>
        <source>Storeys named by words</source>
        <translation>Pisos nomeados por palavras</translation>
    </message>
    <message>
        <source>Transitions that do not join two cells</source>
        <translation>Transições que não ligam duas células</translation>
    </message>
    <message>
        <source>Correct the transition in the source.</source>
        <translation>Corrija a transição na origem.</translation>
    </message>
    <message>
        <source>Entrances of facilities that are missing</source>
        <translation>Entradas de serviços que não existem</translation>
    </message>
    <message>
        <source>Add the facility in the source.</source>
        <translation>Junte o serviço na origem.</translation>
    </message>
    <message>
        <source>Facilities that no entrance leads to</source>
        <translation>Serviços a que nenhuma entrada leva</translation>
    </message>
    <message>
        <source>Add the entrance in the source.</source>
        <translation>Junte a entrada na origem.</translation>
    </message>
    <message>
        <source>The number of the ground floor was assumed</source>
        <translation>O número do rés do chão foi suposto</translation>
    </message>
    <message>
        <source>Say it when importing, if it is another one.</source>
        <translation>Diga-o ao importar, se for outro.</translation>
    </message>
    <message>
        <source>Objects far from every node</source>
        <translation>Objetos longe de todos os nós</translation>
    </message>
    <message>
        <source>Move the object in the source.</source>
        <translation>Mova o objeto na origem.</translation>
    </message>
    <message>
        <source>Links that do not join two nodes</source>
        <translation>Ligações que não unem dois nós</translation>
    </message>
    <message>
        <source>Correct the link in the source.</source>
        <translation>Corrija a ligação na origem.</translation>
    </message>
    <message>
        <source>Nodes that could not be used</source>
        <translation>Nós que não se puderam usar</translation>
    </message>
    <message>
        <source>Give each node a place and an id.</source>
        <translation>Dê a cada nó um lugar e um identificador.</translation>
    </message>
    <message>
        <source>Nodes that no link leads to</source>
        <translation>Nós a que nenhuma ligação leva</translation>
    </message>
    <message>
        <source>Add the link in the source.</source>
        <translation>Junte a ligação na origem.</translation>
    </message>
    <message>
        <source>Nodes without a floor</source>
        <translation>Nós sem piso</translation>
    </message>
    <message>
        <source>Add the floor in the source.</source>
        <translation>Indique o piso na origem.</translation>
    </message>
    <message>
        <source>Regions made from a network of ways</source>
        <translation>Espaços feitos de uma rede de caminhos</translation>
    </message>
    <message>
        <source>Features of an unknown sort</source>
        <translation>Elementos de um tipo desconhecido</translation>
    </message>
    <message>
        <source>Spaces closed from walls, doors and windows</source>
        <translation>Espaços fechados a partir de paredes, portas e janelas</translation>
    </message>
    <message>
        <source>Give them names.</source>
        <translation>Dê-lhes nomes.</translation>
    </message>
    <message>
        <source>Doors with a space on one side only</source>
        <translation>Portas com espaço só de um lado</translation>
    </message>
    <message>
        <source>See whether a wall is missing, or the door leads outside.</source>
        <translation>Veja se falta uma parede, ou se a porta dá para fora.</translation>
    </message>
    <message>
        <source>Narrow strips between walls</source>
        <translation>Faixas estreitas entre paredes</translation>
    </message>
    <message>
        <source>Something to look at</source>
        <translation>Algo a ver</translation>
    </message>
    <message>
        <source>Directions of doors that are not understood</source>
        <translation>Sentidos de portas que não se entendem</translation>
    </message>
    <message>
        <source>Say which way one can pass.</source>
        <translation>Diga em que sentido se pode passar.</translation>
    </message>
    <message>
        <source>Stairs or lifts to a level that nothing names</source>
        <translation>Escadas ou elevadores para um piso que nada nomeia</translation>
    </message>
    <message>
        <source>Choose the region on the other level.</source>
        <translation>Escolha o espaço no outro piso.</translation>
    </message>
    <message>
        <source>Upper ends of stairs and lifts that are known already</source>
        <translation>Cimos de escadas e elevadores que já são conhecidos</translation>
    </message>
    <message>
        <source>Levels counted from the heights of the shapes</source>
        <translation>Pisos contados pelas alturas das formas</translation>
    </message>
    <message>
        <source>Moving walkways without a direction</source>
        <translation>Tapetes rolantes sem sentido</translation>
    </message>
    <message>
        <source>Say in the source which way they run.</source>
        <translation>Diga na origem em que sentido andam.</translation>
    </message>
    <message>
        <source>Moving walkways that lead nowhere</source>
        <translation>Tapetes rolantes que não levam a lado nenhum</translation>
    </message>
    <message>
        <source>Regions whose door joins two others</source>
        <translation>Espaços cuja porta liga outros dois</translation>
    </message>
    <message>
        <source>Correct the sides of the door, or put in another one.</source>
        <translation>Corrija os lados da porta, ou ponha outra.</translation>
    </message>
    <message>
        <source>Names that nobody can say</source>
        <translation>Nomes que ninguém consegue dizer</translation>
    </message>
    <message>
        <source>Give the region the name that people use; this one is never spoken.</source>
        <translation>Dê ao espaço o nome que as pessoas usam; este nunca é dito.</translation>
    </message>
</context>
<context>
    <name>farol::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Definições</translation>
    </message>
    <message>
        <source>As the computer is set</source>
        <translation>Como no computador</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Língua</translation>
    </message>
    <message>
        <source>Language of the window and of the voice</source>
        <translation>Língua da janela e da voz</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Língua:</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Esquerda e direita</translation>
    </message>
    <message>
        <source>Hours of a clock</source>
        <translation>Horas de um relógio</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Graus</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Direções</translation>
    </message>
    <message>
        <source>How turns are told</source>
        <translation>Como são ditas as mudanças de direção</translation>
    </message>
    <message>
        <source>&amp;Directions:</source>
        <translation>&amp;Direções:</translation>
    </message>
    <message>
        <source>The way only</source>
        <translation>Só o caminho</translation>
    </message>
    <message>
        <source>The way and objects</source>
        <translation>O caminho e os objetos</translation>
    </message>
    <message>
        <source>The way, objects and texts</source>
        <translation>O caminho, os objetos e os textos</translation>
    </message>
    <message>
        <source>What is told</source>
        <translation>O que é dito</translation>
    </message>
    <message>
        <source>How much is told on the way</source>
        <translation>Quanto é dito pelo caminho</translation>
    </message>
    <message>
        <source>&amp;What is told:</source>
        <translation>O &amp;que é dito:</translation>
    </message>
    <message>
        <source>The first that works</source>
        <translation>O primeiro que funcione</translation>
    </message>
    <message>
        <source>Speech program</source>
        <translation>Programa de fala</translation>
    </message>
    <message>
        <source>Which speech program of this computer speaks</source>
        <translation>Que programa de fala deste computador fala</translation>
    </message>
    <message>
        <source>&amp;Speech program:</source>
        <translation>Prog&amp;rama de fala:</translation>
    </message>
    <message>
        <source>What fits the language</source>
        <translation>A que convém à língua</translation>
    </message>
    <message>
        <source>Voice</source>
        <translation>Voz</translation>
    </message>
    <message>
        <source>Press “List voices” to choose among those of the speech program</source>
        <translation>Prima “Listar vozes” para escolher entre as do programa de fala</translation>
    </message>
    <message>
        <source>List &amp;voices</source>
        <translation>Listar &amp;vozes</translation>
    </message>
    <message>
        <source>List voices</source>
        <translation>Listar vozes</translation>
    </message>
    <message>
        <source>Ask the speech program for its voices; this can take some seconds</source>
        <translation>Pedir ao programa de fala as suas vozes; pode demorar alguns segundos</translation>
    </message>
    <message>
        <source>V&amp;oice:</source>
        <translation>V&amp;oz:</translation>
    </message>
    <message>
        <source>Speed of the voice</source>
        <translation>Velocidade da voz</translation>
    </message>
    <message>
        <source>Slow on the left, fast on the right</source>
        <translation>Lenta à esquerda, rápida à direita</translation>
    </message>
    <message>
        <source>S&amp;peed of the voice:</source>
        <translation>V&amp;elocidade da voz:</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>How loud the voice is</source>
        <translation>O volume da voz</translation>
    </message>
    <message>
        <source>Lo&amp;udness:</source>
        <translation>Vol&amp;ume:</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Pasta das gravações</translation>
    </message>
    <message>
        <source>Where recorded walks are kept</source>
        <translation>Onde ficam guardados os percursos gravados</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Procurar…</translation>
    </message>
    <message>
        <source>Browse for the folder of recordings</source>
        <translation>Procurar a pasta das gravações</translation>
    </message>
    <message>
        <source>Choose where recorded walks are kept</source>
        <translation>Escolha onde ficam guardados os percursos gravados</translation>
    </message>
    <message>
        <source>&amp;Recordings:</source>
        <translation>&amp;Gravações:</translation>
    </message>
    <message>
        <source>Pages of the settings</source>
        <translation>Páginas das definições</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Geral</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>Orientação</translation>
    </message>
    <message>
        <source>When something is said. From the next start of a walk.</source>
        <translation>Quando se diz alguma coisa. A partir do próximo início de um percurso.</translation>
    </message>
    <message>
        <source>Routes</source>
        <translation>Caminhos</translation>
    </message>
    <message>
        <source>Which way is chosen. From the next start of a walk.</source>
        <translation>Que caminho se escolhe. A partir do próximo início de um percurso.</translation>
    </message>
    <message>
        <source>Recognition</source>
        <translation>Reconhecimento</translation>
    </message>
    <message>
        <source>How sure a landmark must be before it counts. Lower figures find more, and more that is wrong: leave them unless you can check. From the next start of a walk.</source>
        <translation>Quão certo tem de ser um ponto de referência para contar. Valores mais baixos encontram mais, e mais errado: deixe-os, a não ser que possa verificar. A partir do próximo início de um percurso.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claras</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Escuras</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Cores</translation>
    </message>
    <message>
        <source>Light or dark windows</source>
        <translation>Janelas claras ou escuras</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Cores:</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metros</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pés</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Degraus</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distâncias</translation>
    </message>
    <message>
        <source>How distances are told</source>
        <translation>Como se dizem as distâncias</translation>
    </message>
    <message>
        <source>Dis&amp;tances:</source>
        <translation>Dis&amp;tâncias:</translation>
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
        <translation>Número da &amp;câmara</translation>
    </message>
    <message>
        <source>&amp;Video file</source>
        <translation>Ficheiro de &amp;vídeo</translation>
    </message>
    <message>
        <source>&amp;Folder of pictures</source>
        <translation>Pasta de i&amp;magens</translation>
    </message>
    <message>
        <source>Network &amp;address</source>
        <translation>&amp;Endereço de rede</translation>
    </message>
    <message>
        <source>Open pictures</source>
        <translation>Abrir imagens</translation>
    </message>
    <message>
        <source>Camera number</source>
        <translation>Número da câmara</translation>
    </message>
    <message>
        <source>0 is the first camera of this computer</source>
        <translation>0 é a primeira câmara deste computador</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>Ficheiro de vídeo</translation>
    </message>
    <message>
        <source>Folder of pictures</source>
        <translation>Pasta de imagens</translation>
    </message>
    <message>
        <source>Network address</source>
        <translation>Endereço de rede</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Imagens por segundo</translation>
    </message>
    <message>
        <source>How many pictures of the folder make a second</source>
        <translation>Quantas imagens da pasta perfazem um segundo</translation>
    </message>
    <message>
        <source>Pictures a &amp;second:</source>
        <translation>Imagens por &amp;segundo:</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Procurar…</translation>
    </message>
    <message>
        <source>Browse for a video file</source>
        <translation>Procurar um ficheiro de vídeo</translation>
    </message>
    <message>
        <source>B&amp;rowse…</source>
        <translation>P&amp;rocurar…</translation>
    </message>
    <message>
        <source>Browse for a folder</source>
        <translation>Procurar uma pasta</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>Abrir um vídeo</translation>
    </message>
    <message>
        <source>Videos (%1);;All files (%2)</source>
        <translation>Vídeos (%1);;Todos os ficheiros (%2)</translation>
    </message>
    <message>
        <source>Open a folder of pictures</source>
        <translation>Abrir uma pasta de imagens</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechDesk</name>
    <message>
        <source>Voice off: sentences are only shown</source>
        <translation>Voz desligada: as frases são apenas mostradas</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechOutput</name>
    <message>
        <source>The voice starts with the first sentence.</source>
        <translation>A voz arranca com a primeira frase.</translation>
    </message>
    <message>
        <source>The voice hangs: nothing may be heard. Choose another one in the settings.</source>
        <translation>A voz bloqueou: pode não se ouvir nada. Escolha outra nas definições.</translation>
    </message>
</context>
<context>
    <name>farol::ui::SpeechQueue</name>
    <message>
        <source>There is nothing to repeat.</source>
        <translation>Não há nada para repetir.</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachPanel</name>
    <message>
        <source>Give up?</source>
        <translation>Desistir?</translation>
    </message>
    <message>
        <source>What you have taught of this landmark will be lost.</source>
        <translation>O que ensinou deste ponto de referência perde-se.</translation>
    </message>
    <message>
        <source>&amp;Give it up</source>
        <translation>&amp;Desistir</translation>
    </message>
    <message>
        <source>&amp;Keep it</source>
        <translation>&amp;Manter</translation>
    </message>
    <message>
        <source>Add a view first.</source>
        <translation>Junte primeiro uma vista.</translation>
    </message>
    <message>
        <source>Learning…</source>
        <translation>A aprender…</translation>
    </message>
    <message>
        <source>A new landmark</source>
        <translation>Um novo ponto de referência</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>O que é</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensaio</translation>
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
        <translation>Passo %1 de %2: %3</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Feito</translation>
    </message>
    <message>
        <source>&amp;Save it</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Continuar</translation>
    </message>
    <message>
        <source>Go back to the library</source>
        <translation>Voltar à biblioteca</translation>
    </message>
    <message>
        <source>Put it into the library</source>
        <translation>Pôr na biblioteca</translation>
    </message>
    <message>
        <source>The next step</source>
        <translation>O passo seguinte</translation>
    </message>
    <message>
        <source>“%1” is in the library. Where does it hang? Put it on the map, so that Farol knows where you are when it is seen. The same landmark can hang in several places.</source>
        <translation>“%1” está na biblioteca. Onde se encontra? Ponha-o no mapa, para que o Farol saiba onde está quando o vê. O mesmo ponto pode existir em vários lugares.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Anterior</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>The step before</source>
        <translation>O passo anterior</translation>
    </message>
    <message>
        <source>Put as&amp;ide</source>
        <translation>&amp;Pôr de lado</translation>
    </message>
    <message>
        <source>Put aside</source>
        <translation>Pôr de lado</translation>
    </message>
    <message>
        <source>Go back to the library and go on with this landmark later</source>
        <translation>Voltar à biblioteca e continuar este ponto mais tarde</translation>
    </message>
    <message>
        <source>Give &amp;up</source>
        <translation>&amp;Desistir</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Desistir</translation>
    </message>
    <message>
        <source>Forget this landmark</source>
        <translation>Esquecer este ponto de referência</translation>
    </message>
    <message>
        <source>Put it on the &amp;map…</source>
        <translation>Pôr no &amp;mapa…</translation>
    </message>
    <message>
        <source>Put it on the map</source>
        <translation>Pôr no mapa</translation>
    </message>
    <message>
        <source>Choose its place on the Map page</source>
        <translation>Escolher o lugar na página do mapa</translation>
    </message>
    <message>
        <source>Teach an&amp;other</source>
        <translation>Ensinar &amp;outro</translation>
    </message>
    <message>
        <source>Teach another</source>
        <translation>Ensinar outro</translation>
    </message>
    <message>
        <source>Teach the next landmark</source>
        <translation>Ensinar o ponto de referência seguinte</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachSession</name>
    <message>
        <source>Give it a name first.</source>
        <translation>Dê-lhe primeiro um nome.</translation>
    </message>
    <message>
        <source>Say what maps shall call it: letters and digits.</source>
        <translation>Diga como os mapas lhe chamam: letras e algarismos.</translation>
    </message>
    <message>
        <source>“%1” is in the library already. Choose another name, or add views to that one.</source>
        <translation>“%1” já está na biblioteca. Escolha outro nome, ou junte vistas a esse.</translation>
    </message>
    <message>
        <source>there is no view yet</source>
        <translation>ainda não há nenhuma fotografia</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachTry</name>
    <message>
        <source>Folder of a recorded walk, or of pictures</source>
        <translation>Pasta de um percurso gravado, ou de imagens</translation>
    </message>
    <message>
        <source>Found, %1 % sure.</source>
        <translation>Encontrado, com %1 % de certeza.</translation>
    </message>
    <message>
        <source>About %1 m away.</source>
        <translation>A cerca de %1 m.</translation>
    </message>
    <message>
        <source>Not found.</source>
        <translation>Não encontrado.</translation>
    </message>
    <message>
        <source>Not found: %1.</source>
        <translation>Não encontrado: %1.</translation>
    </message>
    <message>
        <source>Also seen: %1.</source>
        <translation>Também visto: %1.</translation>
    </message>
    <message>
        <source>Found in %1 of %2 pictures looked at.</source>
        <translation>Encontrado em %1 de %2 imagens vistas.</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>A procurar…</translation>
    </message>
    <message>
        <source>No picture yet.</source>
        <translation>Ainda não há imagem.</translation>
    </message>
    <message>
        <source>Looking how well it is found…</source>
        <translation>A medir como é encontrado…</translation>
    </message>
    <message>
        <source>Walk towards it, past it and away from it, or step through other pictures, and see whether Farol finds it. Go back to add views where it is lost.</source>
        <translation>Aproxime-se, passe por ele e afaste-se, ou percorra outras imagens, e veja se o Farol o encontra. Volte atrás para juntar vistas onde se perde.</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Câmara</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Câmara</translation>
    </message>
    <message>
        <source>Look for it with the camera of this computer</source>
        <translation>Procurá-lo com a câmara deste computador</translation>
    </message>
    <message>
        <source>&amp;Recording…</source>
        <translation>&amp;Gravação…</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Gravação</translation>
    </message>
    <message>
        <source>Look for it in a recorded walk, or in any folder of pictures</source>
        <translation>Procurá-lo num percurso gravado ou em qualquer pasta de imagens</translation>
    </message>
    <message>
        <source>Pre&amp;vious picture</source>
        <translation>Imagem an&amp;terior</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Imagem anterior</translation>
    </message>
    <message>
        <source>The picture before</source>
        <translation>A imagem anterior</translation>
    </message>
    <message>
        <source>Ne&amp;xt picture</source>
        <translation>Imagem &amp;seguinte</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Imagem seguinte</translation>
    </message>
    <message>
        <source>The picture after</source>
        <translation>A imagem seguinte</translation>
    </message>
    <message>
        <source>Picture with what was recognised</source>
        <translation>Imagem com o que foi reconhecido</translation>
    </message>
    <message>
        <source>What was recognised in this picture, and what nearly was</source>
        <translation>O que foi reconhecido nesta imagem, e o que quase foi</translation>
    </message>
    <message>
        <source>How well it will be found</source>
        <translation>Como vai ser encontrado</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachViews</name>
    <message>
        <source>No outline was found. Set the four corners yourself.</source>
        <translation>Não se encontrou o contorno. Marque os quatro cantos.</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>Fotografias</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (%2)</source>
        <translation>Imagens (%1);;Todos os ficheiros (%2)</translation>
    </message>
    <message>
        <source>Folder of a recorded walk, or of pictures</source>
        <translation>Pasta de um percurso gravado, ou de imagens</translation>
    </message>
    <message>
        <source>Learning this view…</source>
        <translation>A aprender esta vista…</translation>
    </message>
    <message numerus="yes">
        <source>This picture is good: %n point(s).</source>
        <translation>
            <numerusform>Esta imagem é boa: %n ponto.</numerusform>
            <numerusform>Esta imagem é boa: %n pontos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Coach: %1</source>
        <translation>Conselho: %1</translation>
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
        <translation>A medir como é encontrado…</translation>
    </message>
    <message>
        <source>Nothing yet: add a view.</source>
        <translation>Ainda nada: junte uma vista.</translation>
    </message>
    <message numerus="yes">
        <source>With the %n view(s) it had before.</source>
        <translation>
            <numerusform>Com a vista que já tinha.</numerusform>
            <numerusform>Com as %n vistas que já tinha.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Câmara</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Câmara</translation>
    </message>
    <message>
        <source>Take photographs with the camera of this computer</source>
        <translation>Fotografar com a câmara deste computador</translation>
    </message>
    <message>
        <source>&amp;Pictures…</source>
        <translation>&amp;Imagens…</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imagens</translation>
    </message>
    <message>
        <source>Choose photographs from files</source>
        <translation>Escolher fotografias de ficheiros</translation>
    </message>
    <message>
        <source>&amp;Recording…</source>
        <translation>&amp;Gravação…</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Gravação</translation>
    </message>
    <message>
        <source>Choose the folder of a recorded walk, or any folder of pictures</source>
        <translation>Escolher a pasta de um percurso gravado, ou qualquer pasta de imagens</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>&amp;Parar</translation>
    </message>
    <message>
        <source>Hold the picture</source>
        <translation>Parar a imagem</translation>
    </message>
    <message>
        <source>Keep the picture that the camera shows now</source>
        <translation>Manter a imagem que a câmara mostra agora</translation>
    </message>
    <message>
        <source>Pre&amp;vious picture</source>
        <translation>Imagem an&amp;terior</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Imagem anterior</translation>
    </message>
    <message>
        <source>The picture before</source>
        <translation>A imagem anterior</translation>
    </message>
    <message>
        <source>Ne&amp;xt picture</source>
        <translation>Imagem &amp;seguinte</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Imagem seguinte</translation>
    </message>
    <message>
        <source>The picture after</source>
        <translation>A imagem seguinte</translation>
    </message>
    <message>
        <source>&amp;Find outline</source>
        <translation>Procurar conto&amp;rno</translation>
    </message>
    <message>
        <source>Find the outline</source>
        <translation>Procurar o contorno</translation>
    </message>
    <message>
        <source>Look for the outline in this picture</source>
        <translation>Procurar o contorno nesta imagem</translation>
    </message>
    <message>
        <source>Whole p&amp;icture</source>
        <translation>Imagem &amp;toda</translation>
    </message>
    <message>
        <source>Outline the whole picture</source>
        <translation>Contornar a imagem toda</translation>
    </message>
    <message>
        <source>Set the corners to those of the picture</source>
        <translation>Pôr os cantos nos da imagem</translation>
    </message>
    <message>
        <source>&amp;Add this view</source>
        <translation>&amp;Juntar esta vista</translation>
    </message>
    <message>
        <source>Add this view</source>
        <translation>Juntar esta vista</translation>
    </message>
    <message>
        <source>Learn the landmark from this picture</source>
        <translation>Aprender o ponto de referência desta imagem</translation>
    </message>
    <message>
        <source>Re&amp;move view</source>
        <translation>Retirar &amp;vista</translation>
    </message>
    <message>
        <source>Remove the chosen view</source>
        <translation>Retirar a vista escolhida</translation>
    </message>
    <message>
        <source>Forget the chosen view</source>
        <translation>Esquecer a vista escolhida</translation>
    </message>
    <message>
        <source>Coach</source>
        <translation>Conselhos</translation>
    </message>
    <message>
        <source>Views so far</source>
        <translation>Vistas até agora</translation>
    </message>
    <message>
        <source>How well it will be found</source>
        <translation>Como vai ser encontrado</translation>
    </message>
    <message>
        <source>The photographs it is learnt from</source>
        <translation>As fotografias de que é aprendido</translation>
    </message>
    <message>
        <source>Picture with outline</source>
        <translation>Imagem com contorno</translation>
    </message>
    <message>
        <source>Drag the four corners onto the landmark. By keys: 1 to 4 choose a corner, the arrows move it, with Shift by one pixel.</source>
        <translation>Arraste os quatro cantos para o ponto de referência. Com teclas: 1 a 4 escolhem um canto, as setas movem-no, com Shift um ponto de cada vez.</translation>
    </message>
    <message>
        <source>No picture yet.
Switch on the camera, or choose pictures or a recording.</source>
        <translation>Ainda não há imagem.
Ligue a câmara, ou escolha imagens ou uma gravação.</translation>
    </message>
</context>
<context>
    <name>farol::ui::TeachWhat</name>
    <message>
        <source>What is it that Farol shall know again? A sign, a poster, a door with something on it: flat things with detail are known best. Choose “known place” for the whole view of a spot.</source>
        <translation>O que deve o Farol reconhecer? Um letreiro, um cartaz, uma porta com algo escrito: as coisas planas e com pormenores são as mais fáceis. Escolha “lugar conhecido” para toda a vista de um sítio.</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Nome:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>What people call it</source>
        <translation>Como as pessoas lhe chamam</translation>
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
        <translation>O que é</translation>
    </message>
    <message>
        <source>Real &amp;width:</source>
        <translation>&amp;Largura real:</translation>
    </message>
    <message>
        <source>Real width</source>
        <translation>Largura real</translation>
    </message>
    <message>
        <source>Lets Farol tell how far away it is</source>
        <translation>Deixa o Farol saber a que distância está</translation>
    </message>
    <message>
        <source>Real &amp;height:</source>
        <translation>&amp;Altura real:</translation>
    </message>
    <message>
        <source>Real height</source>
        <translation>Altura real</translation>
    </message>
    <message>
        <source>In &amp;maps called:</source>
        <translation>Nome nos &amp;mapas:</translation>
    </message>
    <message>
        <source>In maps called</source>
        <translation>Nome nos mapas</translation>
    </message>
    <message>
        <source>Landmarks of the map refer to it by this word, so it should not change</source>
        <translation>Os pontos do mapa usam esta palavra, por isso não deve mudar</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>não se sabe</translation>
    </message>
</context>
<context>
    <name>farol::ui::TimelineBar</name>
    <message>
        <source>T&amp;imeline:</source>
        <translation>Linha do &amp;tempo:</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Linha do tempo</translation>
    </message>
    <message>
        <source>How sure the place was, and marks where something was said. Drag it, or use the arrow keys, to look back; End goes back to now.</source>
        <translation>A certeza do lugar, com marcas onde algo foi dito. Arraste, ou use as setas, para olhar para trás; Fim volta ao presente.</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Agora</translation>
    </message>
    <message>
        <source>Back to now</source>
        <translation>Voltar ao presente</translation>
    </message>
    <message>
        <source>Show the walk as it is now</source>
        <translation>Mostrar o percurso como está agora</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Looking back at %1</source>
        <translation>A olhar para trás, em %1</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingActions</name>
    <message>
        <source>&amp;Landmarks</source>
        <translation>Pontos de &amp;referência</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Pontos de referência</translation>
    </message>
    <message>
        <source>&amp;Open library…</source>
        <translation>&amp;Abrir biblioteca…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Abrir uma biblioteca de pontos de referência</translation>
    </message>
    <message>
        <source>&amp;New library…</source>
        <translation>&amp;Nova biblioteca…</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nova</translation>
    </message>
    <message>
        <source>Make an empty landmark library</source>
        <translation>Criar uma biblioteca vazia</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>Write the library into another file; every change is saved by itself</source>
        <translation>Escrever a biblioteca noutro ficheiro; cada alteração guarda-se sozinha</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>An&amp;ular</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Anular</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Anular a última alteração</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Refazer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Refazer</translation>
    </message>
    <message>
        <source>Make the change again that was taken back</source>
        <translation>Refazer a alteração desfeita</translation>
    </message>
    <message>
        <source>&amp;Teach a landmark</source>
        <translation>&amp;Ensinar um ponto de referência</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Ensinar</translation>
    </message>
    <message>
        <source>Teach Farol a new landmark, step by step</source>
        <translation>Ensinar ao Farol um novo ponto de referência, passo a passo</translation>
    </message>
    <message>
        <source>Add &amp;views</source>
        <translation>&amp;Juntar vistas</translation>
    </message>
    <message>
        <source>Add views</source>
        <translation>Juntar vistas</translation>
    </message>
    <message>
        <source>Teach more views of the chosen landmark</source>
        <translation>Ensinar mais vistas do ponto escolhido</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>Al&amp;terar…</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Alterar</translation>
    </message>
    <message>
        <source>Change the name, kind or size of the chosen landmark</source>
        <translation>Mudar o nome, o tipo ou o tamanho do ponto escolhido</translation>
    </message>
    <message>
        <source>&amp;Merge with…</source>
        <translation>J&amp;untar com…</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Juntar</translation>
    </message>
    <message>
        <source>Make the chosen landmark and another one the same</source>
        <translation>Fazer do ponto escolhido e de outro um só</translation>
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
        <translation>Fazer das vistas escolhidas um ponto próprio</translation>
    </message>
    <message>
        <source>Delete the chosen vie&amp;ws</source>
        <translation>Eliminar as &amp;vistas escolhidas</translation>
    </message>
    <message>
        <source>Delete views</source>
        <translation>Eliminar vistas</translation>
    </message>
    <message>
        <source>Forget the chosen views of the landmark</source>
        <translation>Esquecer as vistas escolhidas do ponto</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>A&amp;pagar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Forget the chosen landmark</source>
        <translation>Esquecer o ponto escolhido</translation>
    </message>
    <message>
        <source>&amp;Put on the map…</source>
        <translation>Pôr no &amp;mapa…</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>No mapa</translation>
    </message>
    <message>
        <source>Put the chosen landmark on the map</source>
        <translation>Pôr o ponto escolhido no mapa</translation>
    </message>
    <message>
        <source>C&amp;heck all</source>
        <translation>&amp;Verificar tudo</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Verificar</translation>
    </message>
    <message>
        <source>Look how well each landmark is found and which are taken for each other</source>
        <translation>Medir como cada ponto é encontrado e quais se confundem</translation>
    </message>
    <message>
        <source>Wal&amp;k with this library</source>
        <translation>Percorrer com esta &amp;biblioteca</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>Use this library on the Walk page</source>
        <translation>Usar esta biblioteca na página do percurso</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingPage</name>
    <message>
        <source>Open another &amp;library…</source>
        <translation>Abrir outra &amp;biblioteca…</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Por guardar: %1</translation>
    </message>
    <message>
        <source>Save el&amp;sewhere…</source>
        <translation>Guardar &amp;noutro sítio…</translation>
    </message>
    <message>
        <source>Open a landmark library</source>
        <translation>Abrir uma biblioteca de pontos de referência</translation>
    </message>
    <message>
        <source>Landmark libraries (%1);;All files (%2)</source>
        <translation>Bibliotecas de pontos de referência (%1);;Todos os ficheiros (%2)</translation>
    </message>
    <message>
        <source>New landmark library</source>
        <translation>Nova biblioteca de pontos de referência</translation>
    </message>
    <message>
        <source>Landmark libraries (%1)</source>
        <translation>Bibliotecas de pontos de referência (%1)</translation>
    </message>
    <message>
        <source>Save the library as</source>
        <translation>Guardar a biblioteca como</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is unfinished, with %n view(s).</source>
        <translation>
            <numerusform>“%1” está por acabar, com %n vista.</numerusform>
            <numerusform>“%1” está por acabar, com %n vistas.</numerusform>
        </translation>
    </message>
    <message>
        <source>A new landmark</source>
        <translation>Um novo ponto de referência</translation>
    </message>
    <message>
        <source>Go &amp;on with it</source>
        <translation>&amp;Continuar</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>Ensinar “%1”</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar o relatório</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>Tabela (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>Não é possível escrever %1. Escolha outra pasta.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>A trabalhar…</translation>
    </message>
    <message>
        <source>%1 · being saved</source>
        <translation>%1 · a guardar</translation>
    </message>
    <message>
        <source>%1 · saved</source>
        <translation>%1 · guardado</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>Alterar “%1”</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Merge landmarks</source>
        <translation>Juntar pontos de referência</translation>
    </message>
    <message>
        <source>The views of this landmark go to “%1”, and it is deleted:</source>
        <translation>As vistas deste ponto passam para “%1”, e ele é eliminado:</translation>
    </message>
    <message>
        <source>Split the landmark</source>
        <translation>Separar o ponto de referência</translation>
    </message>
    <message numerus="yes">
        <source>Name of the landmark that the %n chosen view(s) become:</source>
        <translation>
            <numerusform>Nome do ponto em que se torna a vista escolhida:</numerusform>
            <numerusform>Nome do ponto em que se tornam as %n vistas escolhidas:</numerusform>
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
        <translation>Não guardado: outro programa alterou os mesmos pontos de referência em %1. Guarde os seus com outro nome; o que o outro programa escreveu fica.</translation>
    </message>
    <message>
        <source>Another program has changed %1 meanwhile: its changes and yours are both saved. Earlier steps can no longer be undone.</source>
        <translation>Entretanto outro programa alterou %1: as alterações dele e as suas estão ambas guardadas. Os passos anteriores já não se podem anular.</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Outro programa alterou %1.</translation>
    </message>
    <message>
        <source>&amp;Load it again</source>
        <translation>&amp;Carregar de novo</translation>
    </message>
</context>
<context>
    <name>farol::ui::TrainingWords</name>
    <message>
        <source>Too dark. Switch on a light.</source>
        <translation>Escuro de mais. Acenda uma luz.</translation>
    </message>
    <message>
        <source>Too bright. Turn away from the window or the lamp.</source>
        <translation>Claro de mais. Afaste-se da janela ou da lâmpada.</translation>
    </message>
    <message>
        <source>Blurred. Hold the camera still, or wait until it is sharp.</source>
        <translation>Desfocada. Segure a câmara sem a mexer, ou espere que fique nítida.</translation>
    </message>
    <message>
        <source>Too small in the picture. Go nearer.</source>
        <translation>Pequeno de mais na imagem. Aproxime-se.</translation>
    </message>
    <message>
        <source>Too little detail inside the outline. Go nearer, or choose something with more detail.</source>
        <translation>Poucos pormenores dentro do contorno. Aproxime-se, ou escolha algo com mais pormenores.</translation>
    </message>
    <message>
        <source>The corners cross. Set them clockwise from the top left.</source>
        <translation>Os cantos cruzam-se. Marque-os no sentido dos ponteiros, a partir de cima à esquerda.</translation>
    </message>
    <message>
        <source>Next: straight from the front, about 2 metres away.</source>
        <translation>A seguir: bem de frente, a cerca de 2 metros.</translation>
    </message>
    <message>
        <source>Next: from farther away, about twice as far.</source>
        <translation>A seguir: de mais longe, cerca do dobro da distância.</translation>
    </message>
    <message>
        <source>Next: the same view from a step aside, or a step nearer.</source>
        <translation>A seguir: a mesma vista um passo ao lado, ou um passo mais perto.</translation>
    </message>
    <message>
        <source>These views are enough. More do no harm.</source>
        <translation>Estas vistas chegam. Mais não fazem mal.</translation>
    </message>
    <message>
        <source>Found in %1 of its %2 views by the others.</source>
        <translation>Encontrado em %1 das suas %2 vistas pelas outras.</translation>
    </message>
    <message>
        <source>Found from up to about %1 m (%2 pixels).</source>
        <translation>Encontrado até cerca de %1 m (%2 píxeis).</translation>
    </message>
    <message>
        <source>Found down to a size of %1 pixels in the picture; give its real size to learn how far that is.</source>
        <translation>Encontrado até ao tamanho de %1 píxeis na imagem; dê o tamanho real para saber a que distância é.</translation>
    </message>
    <message>
        <source>Never found when shown smaller or turned. Choose something with more detail.</source>
        <translation>Nunca se encontra mais pequeno ou rodado. Escolha algo com mais pormenores.</translation>
    </message>
    <message>
        <source>Taken for another: %1.</source>
        <translation>Tomado por outro: %1.</translation>
    </message>
    <message>
        <source>Others are taken for it: %1.</source>
        <translation>Outros são tomados por ele: %1.</translation>
    </message>
    <message>
        <source>Confused with none of the others.</source>
        <translation>Não se confunde com nenhum dos outros.</translation>
    </message>
    <message>
        <source>confused with %1</source>
        <translation>confunde-se com %1</translation>
    </message>
    <message>
        <source>hard to find</source>
        <translation>difícil de encontrar</translation>
    </message>
    <message>
        <source>found from near only</source>
        <translation>só se encontra de perto</translation>
    </message>
    <message>
        <source>%1 of %2 views found again</source>
        <translation>%1 de %2 vistas reencontradas</translation>
    </message>
    <message>
        <source>one view only</source>
        <translation>só uma vista</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bom</translation>
    </message>
    <message>
        <source>No view is straight from the front: add one, to learn from how far it is found.</source>
        <translation>Nenhuma vista é bem de frente: junte uma, para saber de que distância se encontra.</translation>
    </message>
    <message>
        <source>Next: from the left, at an angle.</source>
        <translation>A seguir: da esquerda, de lado.</translation>
    </message>
    <message>
        <source>Next: from the right, at an angle.</source>
        <translation>A seguir: da direita, de lado.</translation>
    </message>
    <message>
        <source>There is only one view: add another, so that it can be tried.</source>
        <translation>Só há uma vista: junte outra, para se poder experimentar.</translation>
    </message>
    <message>
        <source>Found at angles of up to %1 degrees.</source>
        <translation>Encontrado em ângulos até %1 graus.</translation>
    </message>
    <message>
        <source>Not found at an angle. Add views from the left and the right.</source>
        <translation>Não se encontra de lado. Junte vistas da esquerda e da direita.</translation>
    </message>
</context>
<context>
    <name>farol::ui::UtteranceLog</name>
    <message>
        <source>What is said cannot be written to %1: %2. Choose another file.</source>
        <translation>O que é dito não pode ser escrito em %1: %2. Escolha outro ficheiro.</translation>
    </message>
</context>
<context>
    <name>farol::ui::UtteranceModel</name>
    <message>
        <source>Caused by picture %1</source>
        <translation>Causada pela imagem %1</translation>
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
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Shown as text, not heard</source>
        <translation>Mostrada como texto, não ouvida</translation>
    </message>
</context>
<context>
    <name>farol::ui::Voice</name>
    <message>
        <source>The voice &quot;%1&quot; is not installed. Choose another one in the settings.</source>
        <translation>A voz &quot;%1&quot; não está instalada. Escolha outra nas definições.</translation>
    </message>
    <message>
        <source>The voice &quot;%1&quot; does not start: %2</source>
        <translation>A voz &quot;%1&quot; não arranca: %2</translation>
    </message>
    <message>
        <source>The voice &quot;%1&quot; does not speak this language. Choose another one in the settings.</source>
        <translation>A voz &quot;%1&quot; não fala esta língua. Escolha outra nas definições.</translation>
    </message>
    <message>
        <source>No voice is installed.</source>
        <translation>Não há nenhuma voz instalada.</translation>
    </message>
    <message>
        <source>There is no sound device. Connect headphones or a loudspeaker.</source>
        <translation>Não há dispositivo de som. Ligue auscultadores ou um altifalante.</translation>
    </message>
    <message>
        <source>The voice does not work. Choose another one in the settings.</source>
        <translation>A voz não funciona. Escolha outra nas definições.</translation>
    </message>
</context>
<context>
    <name>farol::ui::VoteDetailModel</name>
    <message>
        <source>seen at %1</source>
        <translation>visto em %1</translation>
    </message>
    <message>
        <source>speaks for it</source>
        <translation>fala por ele</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Termo</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Significado</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>filtro</translation>
    </message>
    <message>
        <source>none of the objects last seen stands there</source>
        <translation>nenhum dos objetos vistos por último está ali</translation>
    </message>
</context>
<context>
    <name>farol::ui::VoteModel</name>
    <message numerus="yes">
        <source>%n matching object(s)</source>
        <translation>
            <numerusform>%n objeto condizente</numerusform>
            <numerusform>%n objetos condizentes</numerusform>
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
        <translation>Composição</translation>
    </message>
</context>
<context>
    <name>farol::ui::Walk</name>
    <message numerus="yes">
        <source>%n remark(s) about the map: %1</source>
        <translation>
            <numerusform>%n observação sobre o mapa: %1</numerusform>
            <numerusform>%n observações sobre o mapa: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>A abrir %1…</translation>
    </message>
    <message>
        <source>Loading…</source>
        <translation>A carregar…</translation>
    </message>
    <message>
        <source>Open a map first (Ctrl+O).</source>
        <translation>Abra primeiro um mapa (Ctrl+O).</translation>
    </message>
    <message>
        <source>Open a camera, a video or a folder of pictures first (Ctrl+P).</source>
        <translation>Abra primeiro uma câmara, um vídeo ou uma pasta de imagens (Ctrl+P).</translation>
    </message>
    <message>
        <source>No trained landmarks: only doors and texts are recognised. Open a library of landmarks to recognise more.</source>
        <translation>Sem pontos de referência treinados: só se reconhecem portas e textos. Abra uma biblioteca de pontos de referência para reconhecer mais.</translation>
    </message>
    <message>
        <source>the folder for recordings cannot be made; choose another one in the settings</source>
        <translation>não se consegue criar a pasta das gravações; escolha outra nas definições</translation>
    </message>
</context>
<context>
    <name>farol::ui::WelcomeDialog</name>
    <message>
        <source>Welcome to Farol</source>
        <translation>Bem-vindo ao Farol</translation>
    </message>
    <message>
        <source>Farol guides a blind person through a building with one camera. It needs a map of the building, and landmarks that it was taught. What do you want to do?</source>
        <translation>O Farol guia uma pessoa cega num edifício com uma câmara. Precisa de um mapa do edifício e de pontos de referência ensinados. O que quer fazer?</translation>
    </message>
    <message>
        <source>&amp;Guide somebody</source>
        <translation>&amp;Guiar alguém</translation>
    </message>
    <message>
        <source>Open a map and a camera, and choose where to go</source>
        <translation>Abrir um mapa e uma câmara, e escolher aonde ir</translation>
    </message>
    <message>
        <source>Work on a &amp;map</source>
        <translation>Trabalhar num &amp;mapa</translation>
    </message>
    <message>
        <source>Bring in a floor plan, check it, and put landmarks on it</source>
        <translation>Importar uma planta, verificá-la e pôr-lhe pontos de referência</translation>
    </message>
    <message>
        <source>Teach &amp;landmarks</source>
        <translation>&amp;Ensinar pontos de referência</translation>
    </message>
    <message>
        <source>Photograph what Farol shall know again</source>
        <translation>Fotografar o que o Farol deve reconhecer</translation>
    </message>
    <message>
        <source>Read the &amp;help</source>
        <translation>Ler a &amp;ajuda</translation>
    </message>
    <message>
        <source>What each page is for, and its keys; F1 at any time</source>
        <translation>Para que serve cada página, e as teclas; F1 a qualquer momento</translation>
    </message>
    <message>
        <source>For a blind user who is alone, start “farol --kiosk”: full screen, by keys and speech.</source>
        <translation>Para um utilizador cego sozinho, inicie “farol --kiosk”: ecrã inteiro, com teclas e voz.</translation>
    </message>
</context>
<context>
    <name>farol::ui::WindowActions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Ficheiro</translation>
    </message>
    <message>
        <source>&amp;Walk</source>
        <translation>&amp;Percurso</translation>
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
        <translation>&amp;Ajuda</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Língua</translation>
    </message>
    <message>
        <source>R&amp;ecent maps</source>
        <translation>Mapas r&amp;ecentes</translation>
    </message>
    <message>
        <source>Recent landmark li&amp;braries</source>
        <translation>Bibliotecas recentes de pontos de re&amp;ferência</translation>
    </message>
    <message>
        <source>Recent pi&amp;ctures</source>
        <translation>Imagens re&amp;centes</translation>
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
        <translation>Abrir o mapa de um edifício</translation>
    </message>
    <message>
        <source>Open landmark &amp;library…</source>
        <translation>Abrir &amp;biblioteca de pontos de referência…</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Pontos de referência</translation>
    </message>
    <message>
        <source>Open the landmarks that Farol was taught</source>
        <translation>Abrir os pontos de referência ensinados ao Farol</translation>
    </message>
    <message>
        <source>&amp;Close landmark library</source>
        <translation>Fec&amp;har a biblioteca de pontos de referência</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Walk without taught landmarks</source>
        <translation>Percorrer sem pontos de referência ensinados</translation>
    </message>
    <message>
        <source>Open &amp;pictures…</source>
        <translation>Abrir &amp;imagens…</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imagens</translation>
    </message>
    <message>
        <source>Choose a camera, a video, a folder or an address</source>
        <translation>Escolher uma câmara, um vídeo, uma pasta ou um endereço</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Definições…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Definições</translation>
    </message>
    <message>
        <source>Language, voice and what is told</source>
        <translation>Língua, voz e o que é dito</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Sair</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Sair</translation>
    </message>
    <message>
        <source>Leave Farol</source>
        <translation>Sair do Farol</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproduzir</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproduzir</translation>
    </message>
    <message>
        <source>Hold the walk</source>
        <translation>Suspender o percurso</translation>
    </message>
    <message>
        <source>Start the walk, or go on</source>
        <translation>Iniciar o percurso ou continuar</translation>
    </message>
    <message>
        <source>&amp;One picture</source>
        <translation>&amp;Uma imagem</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Go on by one picture, then hold</source>
        <translation>Avançar uma imagem e suspender</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Terminar</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>Terminar o percurso</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>Mais &amp;depressa</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Mais depressa</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>Reproduzir mais depressa</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>Mais deva&amp;gar</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Mais devagar</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>Reproduzir mais devagar</translation>
    </message>
    <message>
        <source>Choose &amp;destination</source>
        <translation>&amp;Escolher destino</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destino</translation>
    </message>
    <message>
        <source>Choose where to go</source>
        <translation>Escolher para onde ir</translation>
    </message>
    <message>
        <source>&amp;No destination</source>
        <translation>&amp;Sem destino</translation>
    </message>
    <message>
        <source>No destination</source>
        <translation>Sem destino</translation>
    </message>
    <message>
        <source>Give up the destination</source>
        <translation>Desistir do destino</translation>
    </message>
    <message>
        <source>Choose st&amp;art</source>
        <translation>Escolher &amp;início</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Início</translation>
    </message>
    <message>
        <source>Say where the walk starts</source>
        <translation>Dizer onde começa o percurso</translation>
    </message>
    <message>
        <source>&amp;Record the walk</source>
        <translation>Gra&amp;var o percurso</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Gravar</translation>
    </message>
    <message>
        <source>Keep the next walk in a folder, to be replayed</source>
        <translation>Guardar o próximo percurso numa pasta, para ser reproduzido</translation>
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
        <translation>Dizer outra vez a última instrução</translation>
    </message>
    <message>
        <source>Voice o&amp;ff</source>
        <translation>Voz &amp;desligada</translation>
    </message>
    <message>
        <source>Voice off</source>
        <translation>Voz desligada</translation>
    </message>
    <message>
        <source>Show sentences without speaking them</source>
        <translation>Mostrar as frases sem as dizer</translation>
    </message>
    <message>
        <source>&amp;Whole floor</source>
        <translation>Piso &amp;inteiro</translation>
    </message>
    <message>
        <source>Whole floor</source>
        <translation>Piso inteiro</translation>
    </message>
    <message>
        <source>Show the whole floor</source>
        <translation>Mostrar o piso inteiro</translation>
    </message>
    <message>
        <source>&amp;Larger map</source>
        <translation>Mapa &amp;maior</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Maior</translation>
    </message>
    <message>
        <source>Show the map larger</source>
        <translation>Mostrar o mapa maior</translation>
    </message>
    <message>
        <source>&amp;Smaller map</source>
        <translation>Mapa me&amp;nor</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Menor</translation>
    </message>
    <message>
        <source>Show the map smaller</source>
        <translation>Mostrar o mapa menor</translation>
    </message>
    <message>
        <source>&amp;Follow to other floors</source>
        <translation>&amp;Seguir para outros pisos</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Switch to the floor where you are</source>
        <translation>Mudar para o piso onde está</translation>
    </message>
    <message>
        <source>&amp;Grid over the picture</source>
        <translation>&amp;Grelha sobre a imagem</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grelha</translation>
    </message>
    <message>
        <source>Show the nine parts of the picture</source>
        <translation>Mostrar as nove partes da imagem</translation>
    </message>
    <message>
        <source>&amp;What was not accepted</source>
        <translation>O &amp;que não foi aceite</translation>
    </message>
    <message>
        <source>Not accepted</source>
        <translation>Não aceite</translation>
    </message>
    <message>
        <source>Show what was nearly recognised, and why not</source>
        <translation>Mostrar o que quase foi reconhecido, e porque não</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Parte s&amp;eguinte da janela</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Seguinte</translation>
    </message>
    <message>
        <source>Go to the next part of the window</source>
        <translation>Ir para a parte seguinte da janela</translation>
    </message>
    <message>
        <source>&amp;Previous part of the window</source>
        <translation>Parte &amp;anterior da janela</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Go to the previous part of the window</source>
        <translation>Ir para a parte anterior da janela</translation>
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
        <translation>Todas as teclas desta janela</translation>
    </message>
    <message>
        <source>&amp;About Farol</source>
        <translation>&amp;Acerca do Farol</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Acerca</translation>
    </message>
    <message>
        <source>What Farol is</source>
        <translation>O que é o Farol</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>&amp;Speed:</source>
        <translation>&amp;Velocidade:</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidade</translation>
    </message>
    <message>
        <source>How fast pictures from files are played</source>
        <translation>A que velocidade são reproduzidas as imagens de ficheiros</translation>
    </message>
    <message>
        <source>Wal&amp;k page</source>
        <translation>Página do p&amp;ercurso</translation>
    </message>
    <message>
        <source>Watch a walk</source>
        <translation>Acompanhar um percurso</translation>
    </message>
    <message>
        <source>&amp;Map page</source>
        <translation>Página do &amp;mapa</translation>
    </message>
    <message>
        <source>Look at the map of a building, check it and change it</source>
        <translation>Ver o mapa de um edifício, verificá-lo e alterá-lo</translation>
    </message>
    <message>
        <source>Landmark&amp;s page</source>
        <translation>Página dos pontos de r&amp;eferência</translation>
    </message>
    <message>
        <source>Teach Farol landmarks, check them and change them</source>
        <translation>Ensinar pontos de referência ao Farol, verificá-los e mudá-los</translation>
    </message>
    <message>
        <source>The user is &amp;here</source>
        <translation>O utilizador está a&amp;qui</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Aqui</translation>
    </message>
    <message>
        <source>The user is in the place that is chosen on the map or in the list</source>
        <translation>O utilizador está no lugar escolhido no mapa ou na lista</translation>
    </message>
    <message>
        <source>That is &amp;wrong</source>
        <translation>Está &amp;errado</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Errado</translation>
    </message>
    <message>
        <source>The place shown is wrong: look for it anew</source>
        <translation>O lugar mostrado está errado: procurá-lo de novo</translation>
    </message>
    <message>
        <source>&amp;Work out a recorded walk anew…</source>
        <translation>Recalcular um percurso gra&amp;vado…</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>De novo</translation>
    </message>
    <message>
        <source>Compare a recorded walk with the same walk worked out otherwise</source>
        <translation>Comparar um percurso gravado com o mesmo calculado de outra forma</translation>
    </message>
    <message>
        <source>&amp;Say this…</source>
        <translation>D&amp;izer isto…</translation>
    </message>
    <message>
        <source>Say</source>
        <translation>Dizer</translation>
    </message>
    <message>
        <source>Type a sentence that is spoken to the user</source>
        <translation>Escrever uma frase que é dita ao utilizador</translation>
    </message>
    <message>
        <source>Sa&amp;ve the picture…</source>
        <translation>&amp;Guardar a imagem…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagem</translation>
    </message>
    <message>
        <source>Save what the camera sees, with what was recognised</source>
        <translation>Guardar o que a câmara vê, com o que foi reconhecido</translation>
    </message>
    <message>
        <source>Save the walk as &amp;table…</source>
        <translation>Guardar o percurso como &amp;tabela…</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabela</translation>
    </message>
    <message>
        <source>Save times, places and sentences of this walk for a spreadsheet</source>
        <translation>Guardar tempos, lugares e frases deste percurso para uma folha de cálculo</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ajuda</translation>
    </message>
    <message>
        <source>How the page that is shown is used</source>
        <translation>Como se usa a página mostrada</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Bem-vindo</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bem-vindo</translation>
    </message>
    <message>
        <source>The page of the first start</source>
        <translation>A página do primeiro arranque</translation>
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
        <translation>Gráficos dos votos, do tempo das imagens e da distância a que os pontos se encontram</translation>
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
        <translation>corredor</translation>
    </message>
    <message>
        <source>hall</source>
        <translation>átrio</translation>
    </message>
    <message>
        <source>stairwell</source>
        <translation>caixa de escadas</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>elevador</translation>
    </message>
    <message>
        <source>toilet</source>
        <translation>casa de banho</translation>
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
        <translation>porta</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>abertura</translation>
    </message>
    <message>
        <source>stairs</source>
        <translation>escadas</translation>
    </message>
    <message>
        <source>escalator</source>
        <translation>escada rolante</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampa</translation>
    </message>
    <message>
        <source>window</source>
        <translation>janela</translation>
    </message>
    <message>
        <source>passage</source>
        <translation>passagem</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>piso %1</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>em espera</translation>
    </message>
    <message>
        <source>spoken</source>
        <translation>dita</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompida</translation>
    </message>
    <message>
        <source>new route</source>
        <translation>novo percurso</translation>
    </message>
    <message>
        <source>coming up</source>
        <translation>a seguir</translation>
    </message>
    <message>
        <source>do it now</source>
        <translation>fazer agora</translation>
    </message>
    <message>
        <source>keep going</source>
        <translation>continuar</translation>
    </message>
    <message>
        <source>arrived</source>
        <translation>chegada</translation>
    </message>
    <message>
        <source>left the route</source>
        <translation>saída do percurso</translation>
    </message>
    <message>
        <source>place not known</source>
        <translation>lugar desconhecido</translation>
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
        <translation>texto lido</translation>
    </message>
    <message>
        <source>no route</source>
        <translation>sem percurso</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>já no destino</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>aviso</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>certo</translation>
    </message>
    <message>
        <source>fairly sure</source>
        <translation>bastante certo</translation>
    </message>
    <message>
        <source>not sure</source>
        <translation>incerto</translation>
    </message>
    <message>
        <source>too few points fit</source>
        <translation>poucos pontos condizem</translation>
    </message>
    <message>
        <source>outline folded</source>
        <translation>contorno dobrado</translation>
    </message>
    <message>
        <source>looks too different</source>
        <translation>aspeto demasiado diferente</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>objetos</translation>
    </message>
    <message>
        <source>best object</source>
        <translation>melhor objeto</translation>
    </message>
    <message>
        <source>near the last place</source>
        <translation>perto do último lugar</translation>
    </message>
    <message>
        <source>on the way</source>
        <translation>no caminho</translation>
    </message>
    <message>
        <source>seen together</source>
        <translation>vistos juntos</translation>
    </message>
    <message>
        <source>weight of the place</source>
        <translation>peso do lugar</translation>
    </message>
    <message>
        <source>share seen here</source>
        <translation>parte vista aqui</translation>
    </message>
    <message>
        <source>share seen next door</source>
        <translation>parte vista ao lado</translation>
    </message>
    <message>
        <source>vote</source>
        <translation>voto</translation>
    </message>
    <message>
        <source>speaking</source>
        <translation>a dizer</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>tarde de mais</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>mostrada</translation>
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
        <translation>%1 entre %2 e %3</translation>
    </message>
    <message>
        <source>%1 (closed)</source>
        <translation>%1 (fechado)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, in %3</source>
        <translation>%1: %2, em: %3</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>a pedido</translation>
    </message>
    <message>
        <source>does not reach the floor</source>
        <translation>não chega ao chão</translation>
    </message>
    <message>
        <source>two places look alike</source>
        <translation>dois lugares parecem iguais</translation>
    </message>
    <message>
        <source>part of the number may be hidden</source>
        <translation>parte do número pode estar tapada</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>desfocado</translation>
    </message>
    <message>
        <source>too many lines for a door</source>
        <translation>linhas a mais para uma porta</translation>
    </message>
    <message>
        <source>looked at again, it was something else</source>
        <translation>visto outra vez, era outra coisa</translation>
    </message>
    <message>
        <source>the scene changed</source>
        <translation>a cena mudou</translation>
    </message>
    <message>
        <source>lines evenly apart, as of a shelf</source>
        <translation>linhas igualmente afastadas, como numa estante</translation>
    </message>
    <message>
        <source>too few step edges</source>
        <translation>poucas arestas de degraus</translation>
    </message>
    <message>
        <source>lines, but no steps</source>
        <translation>linhas, mas não degraus</translation>
    </message>
    <message>
        <source>lines apart as of floor tiles</source>
        <translation>linhas como as de mosaicos do chão</translation>
    </message>
    <message>
        <source>pictures too far apart to follow it</source>
        <translation>imagens demasiado afastadas para o seguir</translation>
    </message>
    <message>
        <source>a grid, as of tiles or windows</source>
        <translation>uma grelha, como de azulejos ou janelas</translation>
    </message>
    <message>
        <source>too high for steps</source>
        <translation>alto de mais para degraus</translation>
    </message>
    <message>
        <source>impossible size</source>
        <translation>tamanho impossível</translation>
    </message>
    <message>
        <source>does not move as one thing</source>
        <translation>não se move como uma só coisa</translation>
    </message>
    <message>
        <source>its sides go on above it</source>
        <translation>os lados continuam por cima</translation>
    </message>
    <message>
        <source>of a kind that is not looked for</source>
        <translation>de um tipo que não se procura</translation>
    </message>
    <message>
        <source>told by its trained look instead</source>
        <translation>dito antes pelo aspeto ensinado</translation>
    </message>
    <message>
        <source>left the picture</source>
        <translation>saiu da imagem</translation>
    </message>
    <message>
        <source>a likeness within one already found</source>
        <translation>uma semelhança dentro de um já encontrado</translation>
    </message>
    <message>
        <source>a line goes across it</source>
        <translation>uma linha atravessa-o</translation>
    </message>
    <message>
        <source>a line goes up its middle</source>
        <translation>uma linha sobe-lhe pelo meio</translation>
    </message>
    <message>
        <source>a stroke rather than a letter</source>
        <translation>um traço, não uma letra</translation>
    </message>
    <message>
        <source>looks different now</source>
        <translation>agora parece diferente</translation>
    </message>
    <message>
        <source>a letter was missed</source>
        <translation>falta uma letra</translation>
    </message>
    <message>
        <source>a point was missed</source>
        <translation>falta um ponto</translation>
    </message>
    <message>
        <source>a space was missed</source>
        <translation>falta um espaço</translation>
    </message>
    <message>
        <source>reading not sure</source>
        <translation>leitura incerta</translation>
    </message>
    <message>
        <source>too pale</source>
        <translation>pouco contraste</translation>
    </message>
    <message>
        <source>too low for stairs</source>
        <translation>baixo de mais para escadas</translation>
    </message>
    <message>
        <source>not sure enough</source>
        <translation>certeza insuficiente</translation>
    </message>
    <message>
        <source>seen as in a mirror</source>
        <translation>visto como num espelho</translation>
    </message>
    <message>
        <source>too narrow</source>
        <translation>demasiado estreito</translation>
    </message>
    <message>
        <source>only a small part fits</source>
        <translation>só uma pequena parte condiz</translation>
    </message>
    <message>
        <source>the points fit no outline</source>
        <translation>os pontos não formam um contorno</translation>
    </message>
    <message>
        <source>no letters</source>
        <translation>sem letras</translation>
    </message>
    <message>
        <source>readings do not agree yet</source>
        <translation>as leituras ainda não concordam</translation>
    </message>
    <message>
        <source>outline without numbers</source>
        <translation>contorno sem números</translation>
    </message>
    <message>
        <source>mostly outside the picture</source>
        <translation>quase todo fora da imagem</translation>
    </message>
    <message>
        <source>lost from sight</source>
        <translation>perdido de vista</translation>
    </message>
    <message>
        <source>seen only once so far</source>
        <translation>visto só uma vez até agora</translation>
    </message>
    <message>
        <source>only a sliver</source>
        <translation>só uma lasca</translation>
    </message>
    <message>
        <source>too few letters</source>
        <translation>poucas letras</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>pequeno de mais</translation>
    </message>
    <message>
        <source>not seen again</source>
        <translation>não voltou a ser visto</translation>
    </message>
    <message>
        <source>step edges of uneven contrast</source>
        <translation>arestas de degraus com contraste desigual</translation>
    </message>
    <message>
        <source>step edges unevenly apart</source>
        <translation>arestas de degraus mal espaçadas</translation>
    </message>
    <message>
        <source>read differently each time</source>
        <translation>lido de maneira diferente de cada vez</translation>
    </message>
    <message>
        <source>no top of a door frame</source>
        <translation>sem o cimo de uma moldura de porta</translation>
    </message>
    <message>
        <source>wider above than below</source>
        <translation>mais largo em cima do que em baixo</translation>
    </message>
    <message>
        <source>in the way of walking</source>
        <translation>no sentido da marcha</translation>
    </message>
    <message>
        <source>on your level</source>
        <translation>no seu piso</translation>
    </message>
    <message>
        <source>matching objects</source>
        <translation>objetos que condizem</translation>
    </message>
    <message>
        <source>matching objects next door</source>
        <translation>objetos que condizem ao lado</translation>
    </message>
    <message>
        <source>objects seen</source>
        <translation>objetos vistos</translation>
    </message>
    <message>
        <source>share of the likelihood</source>
        <translation>parte da probabilidade</translation>
    </message>
    <message>
        <source>could be anywhere</source>
        <translation>pode ser em qualquer lado</translation>
    </message>
    <message>
        <source>evidence against all of this</source>
        <translation>indícios contra tudo isto</translation>
    </message>
</context>
</TS>
