const GREEK: Readonly<Record<string, string>> = {
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
