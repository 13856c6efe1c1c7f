/** What the lines above a table say: `name=value`, `name: value`, or pairs of cells. */
export interface Property {
  name: string;
  value: string;
}

const MOST = 100;
const LONGEST = 400;

export function propertiesOf(lines: readonly { text: string; cells: readonly string[] }[]): Property[] {
  const found: Property[] = [];
  for (const { text, cells } of lines) {
    const plain = text.replace(/^[\s#%/*"]+/, '').trim();
    if (plain === '' || found.length >= MOST || plain.length > 10 * LONGEST) continue;
    const filled = cells.map((cell) => cell.trim());
    const pair = /^([^=:,;\t]{1,60}?)\s*[=:]\s*(.{0,200})$/.exec(plain);
    if (filled.length >= 2 && filled[0] !== '' && !pair)
      for (let i = 0; i + 1 < filled.length && found.length < MOST; i += 2)
        found.push({ name: filled[i]!.replace(/:$/, ''), value: filled[i + 1]! });
    else if (pair) found.push({ name: pair[1]!, value: pair[2]!.replace(/[,;\t"]+$/, '') });
    else if (filled.length <= 1) found.push({ name: '', value: plain.slice(0, LONGEST) });
  }
  return found.filter(({ name, value }) => name !== '' || value !== '');
}

export function valueOf(properties: readonly Property[], name: RegExp): string | null {
  return properties.find((property) => name.test(property.name) && property.value !== '')?.value ?? null;
}

/** Seconds between rows, from a rate or an interval that the lines above give. */
export function stepOf(properties: readonly Property[]): number | null {
  for (const name of [
    /^export frame ?rate/i,
    /(?:frame|sampl(?:e|ing)|update|capture|data|output|recording)[\s_-]*(?:rate|freq\w*)/i,
    /^(?:rate|freq\w*|fps|hz|samplerate)\b/i,
  ]) {
    const value = valueOf(properties, name);
    const match = value && /^\s*(\d+(?:[.,]\d+)?)\s*(k?hz|fps|1\/s|s\^?-1|frames\/s)?/i.exec(value);
    if (match && +match[1]!.replace(',', '.') > 0)
      return 1 / (+match[1]!.replace(',', '.') * (/^khz/i.test(match[2] ?? '') ? 1000 : 1));
  }
  const interval = valueOf(
    properties,
    /^(?:sampl(?:e|ing)[\s_-]*(?:interval|period|time)|interval|period|time[\s_-]*step|dt|delta[\s_-]*[tx]|step)\b/i,
  );
  const match = interval && /^\s*(\d+(?:[.,]\d+)?(?:e[+-]?\d+)?)\s*(ms|us|µs|s|min)?/i.exec(interval);
  if (match && +match[1]!.replace(',', '.') > 0)
    return (
      +match[1]!.replace(',', '.') * ({ ms: 1e-3, us: 1e-6, µs: 1e-6, min: 60 }[(match[2] ?? 's').toLowerCase()] ?? 1)
    );
  // Vicon writes the rate alone under the kind of the table.
  const kind = properties.findIndex(
    ({ name, value }) => name === '' && /^(?:trajectories|segments|joints|model outputs|devices)$/i.test(value),
  );
  const below = kind >= 0 ? properties[kind + 1] : undefined;
  return below && below.name === '' && +below.value > 0 ? 1 / +below.value : null;
}
