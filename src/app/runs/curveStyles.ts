/** Curves that stand in one plot, told apart by colour and dash. */
export const CURVES: readonly { color: string; dash?: readonly number[] }[] = [
  { color: '#0072b2' },
  { color: '#d55e00' },
  { color: '#009e73' },
  { color: '#cc79a7' },
  { color: '#56b4e9', dash: [6, 4] },
  { color: '#e69f00', dash: [6, 4] },
  { color: '#8a8f98', dash: [6, 4] },
  { color: '#0072b2', dash: [2, 3] },
  { color: '#d55e00', dash: [2, 3] },
  { color: '#009e73', dash: [2, 3] },
  { color: '#cc79a7', dash: [2, 3] },
];
