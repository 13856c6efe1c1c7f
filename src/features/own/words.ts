/** Words of the editor of one's own systems. */
export const words = {
  intro:
    'Type a vehicle: coordinates, bodies, energies, constraints, one statement a line. It is derived as you type, and everything on this page works on it.',
  begin: 'Begin with',
  choose: 'a template …',
  open: 'Open a file',
  save: 'Save as a file',
  duplicate: (title: string) => `Duplicate ${title}`,
  editor: 'Description of your own system',
  defined: (kind: string, line: number) => `${kind} of line ${line}`,
  fine: (title: string) => `${title} is in the panel and on the stage.`,
  untouched: (title: string) => `This is ${title}, typed. Change a line, and the system is yours.`,
  empty: 'Nothing is typed yet.',
  faults: (count: number) =>
    count === 1
      ? 'One line is not right yet; the last right system stays on the stage:'
      : `${count} lines are not right yet; the last right system stays on the stage:`,
  fault: (line: number, reason: string) => (line > 0 ? `Line ${line}: ${reason}` : reason),
  refused: (reason: string) => `It cannot run: ${reason}`,
  equations: 'Its equations',
  formula: 'Formula',
  more: 'M, h, Ω, γ and the bodies stand in Equations.',
  long: 'They are long: they stand in Equations, part by part.',
  label: 'own system',
  file: (title: string) => `${title.replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-|-$/g, '') || 'system'}.system.txt`,
} as const;
