<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_PT" sourcelanguage="en">
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
        <source>Held</source>
        <translation>Em pausa</translation>
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
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
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
        <source>%1: %2, in %3</source>
        <translation>%1: %2, em: %3</translation>
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
        <source>Keep moving forward. You are probably on the right way.</source>
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
        <source>The door is %1.</source>
        <translation>A porta está %1.</translation>
    </message>
    <message>
        <source>The door is probably %1.</source>
        <translation>A porta está provavelmente %1.</translation>
    </message>
    <message>
        <source>The opening is %1.</source>
        <translation>A abertura está %1.</translation>
    </message>
    <message>
        <source>The opening is probably %1.</source>
        <translation>A abertura está provavelmente %1.</translation>
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
        <source>go through it</source>
        <comment>the door</comment>
        <translation>passe por ela</translation>
    </message>
    <message>
        <source>go through it</source>
        <comment>the opening</comment>
        <translation>passe por ela</translation>
    </message>
    <message>
        <source>take them up</source>
        <comment>the stairs</comment>
        <translation>suba-as</translation>
    </message>
    <message>
        <source>take them down</source>
        <comment>the stairs</comment>
        <translation>desça-as</translation>
    </message>
    <message>
        <source>take them, but feel first whether they go up or down</source>
        <comment>the stairs</comment>
        <translation>siga por elas, mas sinta primeiro se sobem ou descem</translation>
    </message>
    <message>
        <source>take it up</source>
        <comment>the lift</comment>
        <translation>apanhe-o para subir</translation>
    </message>
    <message>
        <source>take it down</source>
        <comment>the lift</comment>
        <translation>apanhe-o para descer</translation>
    </message>
    <message>
        <source>take it</source>
        <comment>the lift</comment>
        <translation>apanhe-o</translation>
    </message>
    <message>
        <source>take it up</source>
        <comment>the escalator</comment>
        <translation>apanhe-a para subir</translation>
    </message>
    <message>
        <source>take it down</source>
        <comment>the escalator</comment>
        <translation>apanhe-a para descer</translation>
    </message>
    <message>
        <source>take it, but feel first whether it goes up or down</source>
        <comment>the escalator</comment>
        <translation>apanhe-a, mas sinta primeiro se sobe ou desce</translation>
    </message>
    <message>
        <source>go up it</source>
        <comment>the ramp</comment>
        <translation>suba-a</translation>
    </message>
    <message>
        <source>go down it</source>
        <comment>the ramp</comment>
        <translation>desça-a</translation>
    </message>
    <message>
        <source>follow it</source>
        <comment>the ramp</comment>
        <translation>siga por ela</translation>
    </message>
    <message>
        <source>go through the door</source>
        <translation>passe a porta</translation>
    </message>
    <message>
        <source>go through the opening</source>
        <translation>passe a abertura</translation>
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
        <source>%1 and straight on</source>
        <extracomment>%1 &quot;go through the door&quot;</extracomment>
        <translation>%1 e siga em frente</translation>
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
        <translation>Depois, logo a seguir, %1.</translation>
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
        <source>%1: %2, %3.</source>
        <extracomment>%1 &quot;Soon&quot;, %2 &quot;a door&quot;, %3 &quot;on your left&quot;</extracomment>
        <translation>%1: %2, %3.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
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
        <translation>vire %1 graus para a esquerda</translation>
    </message>
    <message>
        <source>turn %1 degrees to the right</source>
        <translation>vire %1 graus para a direita</translation>
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
        <translation>virando %1 graus para a esquerda</translation>
    </message>
    <message>
        <source>turning %1 degrees to the right</source>
        <translation>virando %1 graus para a direita</translation>
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
        <translation>Obrigado, já chega.</translation>
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
        <translation>Porque</translation>
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
</context>
</TS>
