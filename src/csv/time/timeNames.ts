import { isTimePhrase } from '../names/phrases.ts';
import { plainName } from '../names/plainName.ts';
import { unitBehind } from '../units/titles.ts';

/** Names of a time, in the commoner languages of Europe; the unit is another matter. */
const TIMES = new Set(
  'zeit zeitpunkt temps tiempo tempo tijd tid tidspunkt czas cas aika ido vreme vrijeme laikas laiks aeg zaman время час χρονος 时间 時間 時刻 时刻 시간 messzeit zeitachse laufzeit verstrichenezeit tempsecoule tempodecorrido tiempotranscurrido tempotrascorso timp elapsed elapsedtime secondselapsed timeelapsed seconds secs sec second millis micros timestamp timestamps stamp clock datetime dateandtime zeitstempel horodatage datumzeit runtime simtime simulationtime xvalue tvsec tsec timesec utc utctime unix unixtime unixtimestamp epochtime epoch hora heure uhrzeit ora godzina timeofday time1 ts'.split(
    ' ',
  ),
);
const DATES = new Set('date datum fecha data dato dzien pvm day дата'.split(' '));
const FRAMES = new Set(
  'frame frames frameno framenumber bild image sample samples sampleno samplenumber packetcounter packet scan field item'.split(
    ' ',
  ),
);
const INDICES = new Set(['', 'index', 'idx', 'row', 'n', 'no', 'nr', 'id', 'unnamed:0', '#']);

/** What a name says about time: the surer, the lower its rank. */
export function timeRank(name: string): number | null {
  const plain = plainName(name);
  if (plain === 't' || plain === 'time') return 0;
  if (TIMES.has(plain)) return 1;
  // The unit may follow at once: `TimeUS`, `timestampms`.
  if (
    /^(?:ros|gps|system|unix|sensor|device|world|wall|header\.?)?(?:time(?:stamp)?|stamp)(?:ms|us|ns|sec)?$/.test(plain)
  )
    return 2;
  if (isTimePhrase(name)) return 1;
  return null;
}

export const isDateName = (name: string): boolean => DATES.has(plainName(name));
export const isFrameName = (name: string): boolean => FRAMES.has(plainName(name));
/** A row's own duration. */
const STEP = /^(?:dt|deltat|deltatime|timestep|δt|∆t|elapsedsincelast)$/;
export const isStepName = (name: string): boolean =>
  STEP.test(plainName(name)) || STEP.test(plainName(unitBehind(name)?.name ?? ''));
export const isIndexName = (name: string): boolean => INDICES.has(plainName(name));

/** What a column of a date or a clock counts, where each part has its own. */
export const CALENDAR = ['year', 'month', 'day', 'hour', 'minute', 'second'] as const;
const PARTS: readonly RegExp[] = [
  /^(?:yyyy|yy|year|jahr|année|annee|año|anno|ano)$/,
  /^(?:month|monat|mois|mes|mese|mon)$/,
  /^(?:day|tag|jour|dia|giorno|dd)$/,
  /^(?:hours?|hh|hr|h|stunden?|heures?|horas?|ore)$/,
  /^(?:minutes?|min|mm|minuten?|minutos?|minuti)$/,
  /^(?:seconds?|secs?|ss|s|sekunden?|secondes?|segundos?|secondi)$/,
];

/** Which part of a date or a clock a name says, as an index of `CALENDAR`; -1 for none. */
export const calendarPart = (name: string): number => {
  const plain = plainName(name);
  return PARTS.findIndex((part) => part.test(plain));
};

/** `nsecs` beside `secs`, `stamp.nanosec` beside `stamp.sec`. */
export function isRestOfSecond(seconds: string, rest: string): boolean {
  const whole = /^(.*?)(?:tv_)?(?:s|secs?|seconds)$/i.exec(seconds);
  const part = /^(.*?)(?:tv_)?(?:nsecs?|nanosecs?|nanoseconds|usecs?|microsecs?|microseconds)$/i.exec(rest);
  return whole !== null && part !== null && whole[1] === part[1];
}

/** `timestamp_ms`, `time_ns`, `millis`: the unit that a time's own name holds. */
export function unitInTimeName(name: string): string {
  const plain = plainName(name);
  if (/^(?:millis|milliseconds?)$/.test(plain)) return 'ms';
  if (/^(?:micros|microseconds?)$/.test(plain)) return 'us';
  const behind = /^.*(?:time|stamp)(ms|us|ns)$/.exec(plain)?.[1];
  if (behind) return behind;
  if (/^(?:seconds?|secs?|secondselapsed|tsec|timesec)$/.test(plain)) return 's';
  return '';
}
