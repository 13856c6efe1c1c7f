export const GREEK: Readonly<Record<string, string>> = {
  alpha: 'α',
  beta: 'β',
  gamma: 'γ',
  delta: 'δ',
  epsilon: 'ε',
  zeta: 'ζ',
  eta: 'η',
  theta: 'θ',
  kappa: 'κ',
  lambda: 'λ',
  mu: 'μ',
  nu: 'ν',
  xi: 'ξ',
  rho: 'ρ',
  sigma: 'σ',
  tau: 'τ',
  phi: 'φ',
  chi: 'χ',
  psi: 'ψ',
  omega: 'ω',
  Delta: 'Δ',
  Theta: 'Θ',
  Omega: 'Ω',
  Phi: 'Φ',
  Psi: 'Ψ',
  Lambda: 'Λ',
  Sigma: 'Σ',
};

/**
 * The letter that a name is typeset by: `theta_fc` is θ_fc.
 *
 * @param name as typed
 */
export function symbolOf(name: string): string {
  const [first, ...rest] = name.split('_');
  return [GREEK[first!] ?? first, ...rest].join('_');
}

/**
 * The letter of a name in LaTeX: `theta_fc` is `\theta_{\mathrm{fc}}`, `m1` is `m_{1}`.
 *
 * @param name as typed: letters, digits and underscores
 */
export function latexName(name: string): string {
  const [, first, digits, rest] = /^([^_0-9]*)(\d*)_*(.*)$/.exec(name)!;
  const base = Object.hasOwn(GREEK, first!)
    ? `\\${first === 'phi' ? 'varphi' : first}`
    : first!.length > 1
      ? `\\mathrm{${first}}`
      : first || '\\square';
  const index = [digits, ...rest!.split('_')].filter(Boolean);
  const set = index.map((x) => (Object.hasOwn(GREEK, x!) ? `\\${x}` : /^\w$|^\d+$/.test(x!) ? x : `\\mathrm{${x}}`));
  return set.length > 0 ? `${base}_{${set.join(',')}}` : base;
}
