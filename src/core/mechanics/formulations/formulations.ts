/** A way to get accelerations, as a name: all that a page needs to offer it. `registry.ts` makes it. */
export interface FormulationInfo {
  id: string;
  label: string;
}

/** Every formulation by its permanent id; the first is the default. */
export const formulations = [
  { id: 'multipliers', label: 'Lagrange multipliers' },
  { id: 'nullspace-qr', label: 'Null space (QR)' },
  { id: 'blt', label: 'Block triangular (BLT)' },
] as const satisfies readonly FormulationInfo[];

export type FormulationId = (typeof formulations)[number]['id'];
