import { remembered } from './remembered.ts';

const GREEK: Record<string, string> = {
  α: 'alpha',
  β: 'beta',
  ψ: 'psi',
  θ: 'theta',
  ϑ: 'theta',
  φ: 'phi',
  ϕ: 'phi',
  λ: 'lambda',
  τ: 'tau',
};

/** `alpha_fp`, `ALPHA-FP`, `alphaFp` and `α_fp` are one name; a dot above is `_dot`. */
export const plainName = remembered((name) =>
  name
    .normalize('NFD')
    .toLowerCase()
    .replace(/[αβψθϑφϕλτ]/g, (letter) => GREEK[letter]!)
    .replace(/^([a-z]+)\u0307/, '$1dot')
    .replace(/[\u0300-\u036f]/g, '')
    .replace(/^(['"])(.*)\1$/, '$2')
    .replace(/[\s_-]+/g, ''),
);

/** `x/value`, `x.position`: the last word says what a coordinate is anyhow; `x:1` is a block's first output. Null where there is none. */
export function withoutSuffix(name: string): string | null {
  return /^(.+):\d{1,3}$/.exec(name)?.[1] ?? /^(.+)[./:](?:value|val|position|angle|data)$/i.exec(name)?.[1] ?? null;
}

/** Ways to write the rate of something; the first group is what it is the rate of. */
const RATES: readonly RegExp[] = [
  /^der\s*\(\s*(.+?)\s*\)$/i,
  /^d\s*\(\s*(.+?)\s*\)\s*\/\s*dt$/i,
  /^d_?(.+?)\s*\/\s*dt$/i,
  /^d_?(.+?)_?dt$/i,
  /^dot\s*\(\s*(.+?)\s*\)$/i,
  /^(.+?)['′’`]$/,
  /^(.+?)[\s_./:-]*(?:velocity|vel|speed|rate|punto|punkt|geschwindigkeit)$/i,
  /^(?:velocity|vel|speed|omega|geschwindigkeit|velocidad|vitesse|velocit[aà])[\s_.-]*(.+)$/i,
  // A letter stands before a name alone: `vehicle.x` and `data.x` are no rates. (`x_d` is as often the desired value.)
  /^v_?([^./:|\s]+)$/i,
  /^d_?([^./:|\s]+)$/i,
];

/** What a name may be the rate of, the likeliest first. */
export const ratesOf = remembered((name): readonly string[] =>
  name.length > 60 ? [] : RATES.flatMap((pattern) => pattern.exec(name)?.[1] ?? []),
);

/**
 * What has parts along x, y and z, or of each coordinate, and is none: accelerations, forces, fields, deviations; a body's
 * own velocity is not that of its position.
 */
const OTHER_QUANTITY =
  /(?:^|[^a-z])(?:acc(?:el(?:eration|erometer)?s?)?|beschleunigung|aceleraci[oó]n|acc[eé]l[eé]ration|accelerazione|acelera[cç][aã]o|g(?:yro(?:scope)?s?|ravity)?|gyr|mag(?:net(?:ic|ometer)?)?|magneticfield|forces?|kraft|fuerza|forza|torques?|moments?|drehmoment|momentum|pressure|current|voltage|temp(?:erature)?|angular|twist|velocity|vel|speed|rates?|jerk|err(?:or)?s?|std(?:dev)?|sigma|var(?:iance)?|cov(?:ariance)?|noise|bias|residuals?|resid|scale|offset|gain|size|count)(?:$|[^a-z])/i;

/** Whether words before or behind a coordinate's name make it something else. */
export const isOtherQuantity = remembered((words): boolean =>
  OTHER_QUANTITY.test(words.replace(/([a-z])([A-Z])/g, '$1 $2').replace(/\d+/g, ' ')),
);

/** The name behind a common prefix: `board.alpha`, `/ripstik/alpha`, `board:X`, `board X`. */
export function withoutPrefix(name: string): string | null {
  return (
    /^.+[./:|\s]([^./:|\s]+)$|^\/([^/]+)$/
      .exec(name)
      ?.slice(1)
      .find((part) => part !== undefined) ?? null
  );
}
