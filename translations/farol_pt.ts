<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_PT" sourcelanguage="en">
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
</TS>
