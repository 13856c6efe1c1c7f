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

/** `x/value`, `x.position`: the last word says what a coordinate is anyhow. Null where there is none. */
export function withoutSuffix(name: string): string | null {
  return /^(.+)[./:](?:value|val|position|angle|data)$/i.exec(name)?.[1] ?? null;
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
  /^v_?(.+)$/i,
  /^d_?(.+)$/i,
  /^(.+)_d$/i,
];

/** What a name may be the rate of, the likeliest first. */
export const ratesOf = remembered((name): readonly string[] =>
  name.length > 60 ? [] : RATES.flatMap((pattern) => pattern.exec(name)?.[1] ?? []),
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
