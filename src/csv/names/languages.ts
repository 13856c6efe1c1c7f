/**
 * Words for what columns hold, in English, Spanish, Italian, French, German, Dutch, Portuguese, Polish, Swedish, Czech,
 * Russian, Japanese and Chinese: small letters without accents. `*` stands for up to three letters of an ending.
 */
export type Concept =
  | 'yaw'
  | 'pitch'
  | 'roll'
  | 'steer'
  | 'lean'
  | 'spin'
  | 'turn'
  | 'angle'
  | 'position'
  | 'height'
  | 'rate'
  | 'front'
  | 'rear'
  | 'board'
  | 'wheel'
  | 'caster'
  | 'rider'
  | 'pendulum'
  | 'cart'
  | 'x'
  | 'y'
  | 'z'
  | 'of';

export const WORDS: Readonly<Record<Concept, string>> = {
  yaw:
    'yaw yawing heading hdg azimuth guinada rumbo imbardata rotta prua lacet cap gier gieren gierung kurs gierhoek koers gieren guinadas rumo ' +
    'odchyleni* odchylani* myszkowani* kierunek gir girning vyboceni zataceni staceni ryskan* rysk рыскан* курс* курсов* ヨー ヨーイング 方位 方位角 偏航 航向 横摆 橫擺 偏轉',
  pitch:
    'pitch pitching cabeceo beccheggio tangage nick nicken nickung stamp* domp* arfagem arfage* pochyleni* pochylani* tipp* stampning klopeni podelny тангаж* дифферент* ピッチ ピッチング 俯仰 仰俯',
  roll:
    'roll rolling pricny alabeo balanceo rollio roulis rollen wank wanken rol rolbeweging slinger* rolagem rolamento balanco przechyleni* przechylani* przechyl* rullning krangning* kloneni крен* ' +
    'ロール ローリング 横滚 橫滾 滚转 滾轉 侧倾 側傾 横揺れ',
  steer:
    'steer steering steered handlebar* direccion manillar manubrio volante sterzo sterzata sterzat* manubrio braquage guidon volant lenk* lenkung lenkeinschlag*  lenker* stuur* direcao estercamento esterco guidao guiador ' +
    'skret* skrecani* kierownic* styr* styrning rizeni riditek natoceni рулев* рулени* рул* ' +
    '操舵 舵角 ステア ステアリング ハンドル 操向 转向 轉向 前轮转角 前輪轉角 车把 車把',
  lean: 'lean leaning inclinacion inclinazione inclinaison inclinacao neigung* schraglage* leunen helling* nachyleni* pochyl lutning* naklon* наклон* リーン 傾き 傾斜 バンク 倾斜 傾斜',
  spin: 'spin spinning rolled raddreh* rolweg',
  turn: 'rotation rotational rotated rotacion rotazione drehung dreh rotatie draaiing rotacao obrot* rotace otoceni вращени* поворот* 回転 旋转 旋轉 转角 轉角 转动 轉動',
  angle:
    'angle angles angular angulo angolo angolare angulaire winkel hoek* kat katow* vinkel uhel uhlu uhlov* угол угла углов* 角 角度 アングル',
  position:
    'position pos posicion posizione posto lage ort positie posicao polozeni* pozycj* lage laget poloha pozice положени* позици* координат* coordinate coord coordenada coordinata coordonnee coordinaat koordinat* wspolrzedn* souradnice ' +
    '位置 座標 坐标',
  height: 'height altura altezza hauteur hohe hoogte wysokosc hojd vyska высот* 高さ 高度',
  rate: 'rate velocity speed vel velocidad velocita vitesse geschwindigkeit* rate snelheid velocidade predkosc hastighet rychlost скорост* 速度 速率 レート',
  front: 'front delanter* anterior* avant vorn* vorder* voor* dianteir* przedni* fram framre predni* передн* 前 前部',
  rear: 'rear back traser* posterior* arriere hinten hinter* achter* traseir* tyln* bak* bakre zadni* задн* 後 后 後部 后部',
  board:
    'board rod hub blade centre center plate deck tabla placa plato tavola piastra planche plaque plateau brett platte* plank plaat prancha deska deski plyt* brada platta desk* доск* платформ* пластин* ボード プレート 滑板 板',
  wheel: 'wheel rueda ruota roue rad rads wiel roda kol* hjul* kolo kola колес* 轮 輪',
  caster:
    'caster castor ruedecilla rotella roulette laufrolle rolle zwenkwiel* rodizio kolk* lankhjul kolecko kolecka кастер* ролик* キャスター 脚轮 腳輪',
  rider:
    'rider body ciclista conductor jinete ciclista pilota conducente cycliste pilote fahrer* rijder* condutor kierowc* rowerzyst* forare* cyklist* jezdc* райдер* ездок* водител* велосипедист* ライダー 乗り手 骑手 騎手 骑行者',
  pendulum: 'pendulum pole pendulo pendolo pendule pendel* wahadl* kyvadl* маятник* 振り子 摆 擺',
  cart: 'cart carro carrello chariot wagen* karretje* carrinho wozk* vagn* vozik* тележк* каретк* 台車 小车 小車',
  x: 'x',
  y: 'y',
  z: 'z',
  of: 'of the s de del della dello dell di da do das dos des du la le el il lo der die dem den van het von zum po na по の 的 方向',
};

/** Words that are a time, alone or with those of `BESIDE_TIME`. */
export const TIME_WORDS =
  'time tiempo tempo temps zeit tijd czas* tid tiden tids cas casu casov* врем* временн* 時間 时间 時刻 时刻 タイム temporal temporale';
export const BESIDE_TIME =
  'elapsed simulation simulated recording transcurrido de simulacion trascorso decorrido simulazione simulacao ecoule verstrichen* abgelaufen* vergangen* mess messung* verstreken uplyw* uplynu* forfluten прошедш* 経過 经过 計測 测量 采样 stamp stempel sello marca marcacao marcatura razitko znacznik stampel отметк* метк* スタンプ 戳';
