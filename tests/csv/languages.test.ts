// What people call a column in the commoner languages, for every system that has such a coordinate.
import { describe, expect, test } from 'vitest';
import { conceptsIn } from '../../src/csv/names/phrases.ts';
import { lookUp, vocabularyOf } from '../../src/csv/names/vocabulary.ts';
import { timeRank } from '../../src/csv/time/timeNames.ts';
import { metas } from '../helpers.ts';
import { base, comma, deg, expectCircle, f, motionOf, states, table } from './circle.ts';

/** By quantity: at least three names in every language but English, which other tests have. */
const NAMES: Record<string, Record<string, string>> = {
  yaw: {
    Spanish: 'guiñada; Ángulo de guiñada; rumbo; GUIÑADA; angulo_guinada',
    Italian: 'imbardata; Angolo di imbardata; angolo d’imbardata; prua',
    French: 'lacet; Angle de lacet; cap; angleLacet',
    German: 'Gierwinkel; Gieren; Kurswinkel; Gier-Winkel; Kurs',
    Dutch: 'gierhoek; Gieren; koers; gier',
    Portuguese: 'guinada; Ângulo de guinada; rumo',
    Polish: 'odchylenie; Kąt odchylenia; kąt odchylania; myszkowanie; kurs',
    Swedish: 'gir; Girvinkel; kurs',
    Czech: 'vybočení; Úhel vybočení; zatáčení; úhel stáčení',
    Russian: 'рыскание; Угол рыскания; курс; курсовой угол; угол рысканья',
    Japanese: 'ヨー; ヨー角; 方位角; ヨーイング角',
    Chinese: '偏航; 偏航角; 航向角; 横摆角',
  },
  pitch: {
    Spanish: 'cabeceo; Ángulo de cabeceo; angulo_cabeceo',
    Italian: 'beccheggio; Angolo di beccheggio; angolo beccheggio',
    French: 'tangage; Angle de tangage; Tangage',
    German: 'Nickwinkel; Nicken; Nick-Winkel; nick',
    Dutch: 'stampen; stamphoek; domphoek',
    Portuguese: 'arfagem; Ângulo de arfagem; angulo_arfagem',
    Polish: 'pochylenie; Kąt pochylenia; pochylanie',
    Swedish: 'tippvinkel; stampning; nickvinkel; tipp',
    Czech: 'klopení; Úhel klopení; podélný náklon',
    Russian: 'тангаж; Угол тангажа; дифферент',
    Japanese: 'ピッチ; ピッチ角; ピッチング角',
    Chinese: '俯仰; 俯仰角; 俯仰角度',
  },
  roll: {
    Spanish: 'alabeo; Ángulo de alabeo; balanceo',
    Italian: 'rollio; Angolo di rollio; angolo rollio',
    French: 'roulis; Angle de roulis; Roulis',
    German: 'Rollwinkel; Rollen; Wankwinkel; wanken',
    Dutch: 'rolhoek; rollen; slingerhoek',
    Portuguese: 'rolagem; Ângulo de rolagem; rolamento',
    Polish: 'przechylenie; Kąt przechylenia; przechył',
    Swedish: 'rullning; rollvinkel; krängning; krängningsvinkel',
    Czech: 'klonění; Úhel klonění; klonění úhel',
    Russian: 'крен; Угол крена; угол_крена',
    Japanese: 'ロール; ロール角; ローリング角',
    Chinese: '横滚; 横滚角; 滚转角; 侧倾角',
  },
  steer: {
    Spanish: 'dirección; Ángulo de dirección; ángulo del manillar',
    Italian: 'sterzo; Angolo di sterzo; angolo di sterzata; angolo del manubrio',
    French: 'braquage; Angle de braquage; angle du guidon',
    German: 'Lenkwinkel; Lenkung; Lenkerwinkel; Lenkeinschlag',
    Dutch: 'stuurhoek; stuur; stuur hoek',
    Portuguese: 'direção; Ângulo de direção; esterçamento; ângulo do guiador',
    Polish: 'skręt; Kąt skrętu; kąt kierownicy',
    Swedish: 'styrvinkel; styrning; styr-vinkel',
    Czech: 'řízení; Úhel řízení; natočení řídítek',
    Russian: 'поворот руля; Угол поворота руля; руль; угол руля',
    Japanese: '操舵角; 舵角; ステアリング角; ハンドル角',
    Chinese: '转向角; 转向; 前轮转角; 车把转角',
  },
  lean: {
    Spanish: 'inclinación; Ángulo de inclinación; inclinacion',
    Italian: 'inclinazione; Angolo di inclinazione; angolo d’inclinazione',
    French: 'inclinaison; Angle d’inclinaison; angle inclinaison',
    German: 'Neigung; Neigungswinkel; Schräglage; Schräglagenwinkel',
    Dutch: 'hellingshoek; helling; leunen',
    Portuguese: 'inclinação; Ângulo de inclinação; inclinacao',
    Polish: 'nachylenie; Kąt nachylenia; kąt_nachylenia',
    Swedish: 'lutning; lutningsvinkel; Lutning',
    Czech: 'náklon; Úhel náklonu; úhel_náklonu',
    Russian: 'наклон; Угол наклона; угол_наклона',
    Japanese: '傾き; 傾斜角; リーン角; バンク角',
    Chinese: '倾斜; 倾斜角; 倾斜角度',
  },
};

const RATES: Record<string, Record<string, string>> = {
  yaw: {
    English: 'yaw rate; yaw angular velocity; Yaw Velocity',
    Spanish: 'velocidad de guiñada; Velocidad angular de guiñada; guiñada velocidad',
    Italian: 'velocità di imbardata; Velocità angolare di imbardata; velocità d’imbardata',
    French: 'vitesse de lacet; Vitesse angulaire de lacet; vitesse_lacet',
    German: 'Giergeschwindigkeit; Gierrate; Gierwinkelgeschwindigkeit',
    Dutch: 'giersnelheid; gierhoeksnelheid; Gier snelheid',
    Portuguese: 'velocidade de guinada; Velocidade angular de guinada; velocidade_guinada',
    Polish: 'prędkość odchylania; Prędkość kątowa odchylania; prędkość_odchylenia',
    Swedish: 'girhastighet; girvinkelhastighet; gir-hastighet',
    Czech: 'rychlost vybočení; Úhlová rychlost vybočení; rychlost stáčení',
    Russian: 'скорость рыскания; Угловая скорость рыскания; скорость_рыскания',
    Japanese: 'ヨーレート; ヨー角速度; ヨー 速度',
    Chinese: '偏航角速度; 偏航速率; 横摆角速度',
  },
  steer: {
    Spanish: 'velocidad de dirección; velocidad angular de dirección; velocidad del manillar',
    Italian: 'velocità di sterzo; velocità angolare di sterzo; velocità sterzata',
    French: 'vitesse de braquage; vitesse angulaire de braquage; vitesse du guidon',
    German: 'Lenkrate; Lenkwinkelgeschwindigkeit; Lenkgeschwindigkeit',
    Dutch: 'stuursnelheid; stuurhoeksnelheid; stuur snelheid',
    Portuguese: 'velocidade de direção; velocidade angular de esterçamento; velocidade do guidão',
    Polish: 'prędkość skrętu; prędkość kątowa skrętu; prędkość kierownicy',
    Swedish: 'styrhastighet; styrvinkelhastighet; styr hastighet',
    Czech: 'rychlost řízení; úhlová rychlost řízení; rychlost natočení řídítek',
    Russian: 'скорость руля; угловая скорость руля; скорость поворота руля',
    Japanese: '操舵角速度; 操舵速度; ステアリング角速度',
    Chinese: '转向角速度; 转向速度; 转向速率',
  },
  x: {
    English: 'velocity x; x velocity; X speed',
    Spanish: 'velocidad x; Velocidad en X; velocidad_x',
    Italian: 'velocità x; Velocità X; velocita_x',
    French: 'vitesse x; Vitesse X; vitesse_x; vitesse en x',
    German: 'Geschwindigkeit x; x-Geschwindigkeit; Geschwindigkeit in x',
    Dutch: 'snelheid x; x-snelheid; snelheid_x',
    Portuguese: 'velocidade x; Velocidade X; velocidade em x',
    Polish: 'prędkość x; Prędkość X; predkosc_x',
    Swedish: 'hastighet x; x-hastighet; Hastighet X',
    Czech: 'rychlost x; Rychlost X; rychlost_x',
    Russian: 'скорость x; Скорость X; скорость по x',
    Japanese: 'x速度; 速度x; x方向の速度',
    Chinese: 'x速度; 速度x; x方向速度',
  },
};

const POSITIONS: Record<string, string> = {
  Spanish: 'posición x; Coordenada X; posicion_x',
  Italian: 'posizione x; Coordinata X; posizione_x',
  French: 'position x; Coordonnée X; coordonnee_x',
  German: 'Position x; x-Koordinate; Lage x',
  Dutch: 'positie x; x-coordinaat; positie_x',
  Portuguese: 'posição x; Coordenada X; posicao_x',
  Polish: 'położenie x; Współrzędna x; pozycja_x',
  Swedish: 'läge x; x-koordinat; position x',
  Czech: 'poloha x; Souřadnice x; pozice_x',
  Russian: 'положение x; Координата X; позиция_x',
  Japanese: 'x座標; 位置x; x位置',
  Chinese: 'x坐标; 位置x; x位置',
};

const TIMES: Record<string, string> = {
  Spanish: 'tiempo; Tiempo transcurrido; marca de tiempo; Tiempo de simulación',
  Italian: 'tempo; Tempo trascorso; marca temporale',
  French: 'temps; Temps écoulé; horodatage; temps de simulation',
  German: 'Zeit; Verstrichene Zeit; Zeitstempel; Messzeit; abgelaufene Zeit; Simulationszeit',
  Dutch: 'tijd; verstreken tijd; tijdstempel',
  Portuguese: 'tempo; Tempo decorrido; marca de tempo; tempo de simulação',
  Polish: 'czas; upływ czasu; znacznik czasu',
  Swedish: 'tid; förfluten tid; tidsstämpel',
  Czech: 'čas; uplynulý čas; časové razítko',
  Russian: 'время; прошедшее время; метка времени; временная метка',
  Japanese: '時間; 経過時間; 時刻; タイムスタンプ',
  Chinese: '时间; 经过时间; 时间戳',
};

/** Coordinates by what they are called: those of every system. */
const CALLED: Record<string, Record<string, string>> = {
  yaw: {
    ripstik: 'theta',
    'ripstik-rider': 'theta',
    'rolling-wheel': 'theta',
    'casterboard-robot': 'theta',
    'chaplygin-sleigh': 'theta',
    bicycle: 'yaw',
    'bicycle-rider': 'yaw',
  },
  pitch: { ripstik: 'psi', 'ripstik-rider': 'psi', bicycle: 'pitch', 'bicycle-rider': 'pitch' },
  roll: { ripstik: 'alpha', 'ripstik-rider': 'alpha', bicycle: 'roll', 'bicycle-rider': 'roll' },
  steer: { bicycle: 'steer', 'bicycle-rider': 'steer', 'caster-rotation': 'theta_c' },
  lean: { 'ripstik-rider': 'beta', bicycle: 'roll', 'bicycle-rider': 'lean' },
  x: {
    ripstik: 'X',
    'ripstik-rider': 'X',
    'rolling-wheel': 'X',
    'wheel-pendulum': 'X',
    'cart-pendulum': 'X',
    'casterboard-robot': 'x',
    'chaplygin-sleigh': 'x',
    bicycle: 'x',
    'bicycle-rider': 'x',
  },
};

const meaningIn = (system: string, title: string): string | null =>
  lookUp(title, vocabularyOf(metas[system]!))?.word.name ?? null;
const listed = (names: string): string[] => names.split('; ');
const cases = (all: Record<string, Record<string, string>>): [string, string, string[]][] =>
  Object.entries(all).flatMap(([quantity, languages]) =>
    Object.entries(languages).map(([language, names]): [string, string, string[]] => [
      quantity,
      language,
      listed(names),
    ]),
  );

describe('names', () => {
  test.each([...cases(NAMES), ...cases({ x: POSITIONS })])('%s in %s', (quantity, _, names) => {
    expect(names.length).toBeGreaterThanOrEqual(3);
    for (const name of names)
      for (const [system, coordinate] of Object.entries(CALLED[quantity]!))
        for (const title of [name, `${name} (${quantity === 'x' ? 'mm' : '°'})`])
          expect(meaningIn(system, title), `${title} in ${system}`).toBe(coordinate);
  });

  test.each(cases(RATES))('rates of %s in %s', (quantity, _, names) => {
    expect(names.length).toBeGreaterThanOrEqual(3);
    for (const name of names)
      for (const [system, coordinate] of Object.entries(CALLED[quantity]!))
        expect(meaningIn(system, name), `${name} in ${system}`).toBe(`${coordinate}_dot`);
  });

  test.each(Object.entries(TIMES))('the time in %s', (_, names) => {
    for (const name of listed(names)) expect(timeRank(name), name).toBeLessThan(9);
    for (const name of listed(names)) expect(timeRank(name), name).not.toBeNull();
  });

  test.each([
    [
      'alpha_fp',
      ['front plate roll', 'Rollwinkel vordere Platte', 'alabeo de la placa delantera', 'крен передней платформы'],
    ],
    ['alpha_bp', ['back plate angle', 'Winkel hintere Platte', 'rollio della piastra posteriore', '后板横滚角']],
    ['theta_fc', ['front caster steer', 'Lenkwinkel Vorderrad', 'angle roulette avant', '前輪操舵角']],
    ['theta_bc', ['rear caster angle', 'Lenkwinkel hinten', 'sterzo posteriore', 'ângulo de direção traseiro']],
    [
      'alpha_fp_dot',
      ['front plate roll rate', 'velocidad de alabeo de la placa delantera', 'Rollgeschwindigkeit vordere Platte'],
    ],
    ['Z', ['Höhe', 'altura', 'hauteur', 'высота', '高さ']],
  ])('of the board: %s', (name, titles) => {
    for (const title of titles) expect(meaningIn('ripstik', title), title).toBe(name);
  });

  test.each([
    ['bicycle', 'front_spin', ['rotación rueda delantera', 'rotation roue avant', 'Drehung Vorderrad', '前輪回転角']],
    ['bicycle', 'rear_spin', ['rotazione ruota posteriore', 'rotatie achterwiel', 'вращение заднего колеса']],
    [
      'bicycle',
      'rear_spin_dot',
      ['velocidad de rotación rueda trasera', 'Drehgeschwindigkeit Hinterrad', '后轮转动速度'],
    ],
    ['bicycle', 'steer', ['front steering angle', 'Lenkwinkel vorn', 'angle de braquage avant']],
    ['wheel-pendulum', 'phi', ['wheel angle', 'Radwinkel', 'ángulo de la rueda']],
    ['wheel-pendulum', 'psi', ['pendulum angle', 'Pendelwinkel', 'angolo del pendolo', 'угол маятника']],
    ['cart-pendulum', 'theta', ['pole angle', 'ángulo del péndulo', '摆角', '振り子角度']],
    ['cart-pendulum', 'X', ['cart position', 'Wagenposition', 'posición del carro', 'положение тележки']],
    ['cart-pendulum', 'X_dot', ['cart velocity', 'Wagengeschwindigkeit', 'vitesse du chariot']],
    ['casterboard-robot', 'phi_f', ['front plate angle', 'ángulo de la placa delantera', 'Winkel vordere Platte']],
    ['casterboard-robot', 'phi_r', ['rear plate angle', 'angle plateau arrière', 'угол задней платформы']],
    ['bicycle-rider', 'lean', ['rider lean', 'Neigung Fahrer', 'inclinación del ciclista']],
  ])('of the %s: %s', (system, name, titles) => {
    for (const title of titles) expect(meaningIn(system, title), title).toBe(name);
  });

  test('what could be two things, or is another, is none', () => {
    for (const [system, title] of [
      ['ripstik', 'steer'],
      ['ripstik', 'ángulo'],
      ['ripstik', 'front angle'],
      ['ripstik', 'lean'],
      ['bicycle', 'front wheel angle'],
      ['bicycle', 'speed'],
      ['bicycle', 'velocidad'],
      ['bicycle', 'wheel'],
      ['ripstik', 'roll acceleration'],
      ['chaplygin-sleigh', 'dirección'],
      ['cart-pendulum', 'position'],
      ['cart-pendulum', 'angle'],
    ] as const)
      expect(meaningIn(system, title), `${title} in ${system}`).toBeNull();
    expect(conceptsIn('cappuccino')).toBeNull();
    for (const name of ['temperature', 'temperatura', 'temps réel', 'marca', 'tempomat', 'timer', 'временно да'])
      expect(timeRank(name), name).toBeNull();
  });
});

/** Time, x, y and heading, as whole files of the languages have them. */
const HEADERS: Record<string, readonly [names: string, unit: 'mm' | 'm', angle: '°' | 'rad', decimal: ',' | '.']> = {
  Spanish: ['Tiempo (s);Posición X (mm);Posición Y (mm);Ángulo de guiñada (°)', 'mm', '°', ','],
  Italian: ['Tempo trascorso (s);Posizione x (mm);Posizione y (mm);Imbardata (°)', 'mm', '°', ','],
  French: ['Temps écoulé (s);Coordonnée X (mm);Coordonnée Y (mm);Cap (°)', 'mm', '°', ','],
  German: ['Verstrichene Zeit [s];x-Koordinate [mm];y-Koordinate [mm];Kurswinkel [°]', 'mm', '°', ','],
  Dutch: ['Tijd [s];Positie x [mm];Positie y [mm];Gierhoek [graden]', 'mm', '°', ','],
  Portuguese: ['Tempo decorrido (s);Posição X (milímetros);Posição Y (milímetros);Guinada (graus)', 'mm', '°', ','],
  Polish: ['Czas [s];Położenie x [mm];Położenie y [mm];Kąt odchylenia [stopnie]', 'mm', '°', ','],
  Swedish: ['Tid (s);Läge x (mm);Läge y (mm);Girvinkel (grader)', 'mm', '°', ','],
  Czech: ['Čas (s);Poloha x (mm);Poloha y (mm);Vybočení (stupně)', 'mm', '°', ','],
  Russian: ['Время, с;Координата X, мм;Координата Y, мм;Угол рыскания, град', 'mm', '°', ','],
  Japanese: ['経過時間 [秒];x座標 [mm];y座標 [mm];ヨー角 [度]', 'mm', '°', '.'],
  Chinese: ['时间(秒);x坐标(米);y坐标(米);偏航角(弧度)', 'm', 'rad', '.'],
};

describe('whole files', () => {
  test.each(Object.entries(HEADERS))('%s', (_, [names, length, angle, decimal]) => {
    const rows = states.map(([, x, y, a], i) => [
      base[i]![0]!,
      f(length === 'mm' ? 1000 * x : x),
      f(length === 'mm' ? 1000 * y : y),
      angle === '°' ? deg(a) : f(a),
    ]);
    const text = table(`${names}\n`, rows, ';');
    const [head, ...body] = text.split('\n');
    expectCircle(motionOf(decimal === ',' ? [head, comma(body.join('\n'))].join('\n') : text));
  });
});
