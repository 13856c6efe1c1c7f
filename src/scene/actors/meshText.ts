/**
 * Checks Wavefront text before it is parsed, because the parsers themselves let a broken file pass as an empty or
 * torn body. Pure text work: what comes back holds only statements that the scene draws.
 */

/** A mesh file that cannot be drawn; the message names the file and the line. */
export class MeshError extends Error {
  override name = 'MeshError';
}

const KEPT = new Set(['v', 'vn', 'vt', 'f', 'l', 'p', 'o', 'g', 's', 'usemtl']);
/** Statements of the format that have no meaning here: other files, free-form curves, display hints. */
const IGNORED = new Set([
  'mtllib',
  'usemap',
  'maplib',
  'mg',
  'vp',
  'cstype',
  'deg',
  'bmat',
  'step',
  'curv',
  'curv2',
  'surf',
  'parm',
  'trim',
  'hole',
  'scrv',
  'sp',
  'end',
  'con',
  'bevel',
  'c_interp',
  'd_interp',
  'lod',
  'shadow_obj',
  'trace_obj',
  'ctech',
  'stech',
]);
const WIDTH = { v: 3, vn: 3, vt: 1 } as const;

const shorten = (line: string): string => (line.length > 40 ? `${line.slice(0, 40)}…` : line);

function statements(text: string): { line: number; text: string; words: string[] }[] {
  const list: { line: number; text: string; words: string[] }[] = [];
  text.split(/\r\n|\r|\n/).forEach((raw, i) => {
    const clean = raw.replace(/#.*$/, '').replace(/\0/g, '').trim();
    if (clean !== '') list.push({ line: i + 1, text: clean, words: clean.split(/\s+/) });
  });
  return list;
}

/** Checks one OBJ text; `file` is the name used in messages. Returns the text to parse. Throws `MeshError`. */
export function checkMesh(text: string, file: string): string {
  const kept: string[] = [];
  const counts = { v: 0, vn: 0, vt: 0 };
  let faces = 0;
  for (const { line, text: statement, words } of statements(text.replace(/\\\r?\n/g, ' '))) {
    const fail = (what: string): never => {
      throw new MeshError(`${file}, line ${line}: ${what}`);
    };
    const key = words[0]!;
    if (IGNORED.has(key)) continue;
    if (!KEPT.has(key)) fail(`“${shorten(statement)}” is not a statement of an OBJ mesh`);
    if (key === 'v' || key === 'vn' || key === 'vt') {
      const numbers = words.slice(1).map(Number);
      if (numbers.length < WIDTH[key]) fail(`“${key}” needs ${WIDTH[key]} numbers and has ${numbers.length}`);
      const bad = numbers.findIndex((x) => !Number.isFinite(x));
      if (bad >= 0) fail(`“${words[bad + 1]}” is not a number`);
      counts[key]++;
    } else if (key === 'f') {
      if (words.length < 4) fail(`a face needs 3 points and has ${words.length - 1}`);
      for (const corner of words.slice(1)) checkCorner(corner, counts, fail);
      faces++;
    }
    kept.push(key === 'o' || key === 'g' || key === 'usemtl' ? statement : words.join(' '));
  }
  if (faces === 0) throw new MeshError(`${file}: there are no faces to draw (${counts.v} points)`);
  return kept.join('\n');
}

function checkCorner(
  corner: string,
  counts: Readonly<Record<'v' | 'vn' | 'vt', number>>,
  fail: (what: string) => never,
): void {
  const indices = corner.split('/');
  (['v', 'vt', 'vn'] as const).forEach((kind, i) => {
    const word = indices[i];
    if (word === undefined || (word === '' && i > 0)) return;
    const index = Number(word);
    if (!Number.isInteger(index) || index === 0) fail(`“${corner}” does not name a point`);
    // A negative index counts back from the last one so far.
    if (index > counts[kind] || -index > counts[kind])
      fail(`“${corner}” names point ${index} of ${counts[kind]} (${kind})`);
  });
}

/** Checks one MTL text and leaves out texture maps, which would ask the network. Throws `MeshError`. */
export function checkMaterials(text: string, file: string): string {
  const kept: string[] = [];
  let named = false;
  for (const { line, text: statement, words } of statements(text)) {
    const fail = (what: string): never => {
      throw new MeshError(`${file}, line ${line}: ${what}`);
    };
    const key = words[0]!.toLowerCase();
    if (/^(map_|bump|disp|decal|refl|norm)/.test(key)) continue;
    if (key === 'newmtl') {
      if (words.length < 2) fail('“newmtl” has no name');
      named = true;
    } else if (!named) {
      fail(`“${shorten(statement)}” stands before the first “newmtl”`);
    } else if (/^(k[ade]|ks|n[is]|d|tr)$/.test(key)) {
      const numbers = words.slice(1).filter((word) => word !== '-halo');
      const bad = numbers.find((word) => !Number.isFinite(Number(word)));
      if (bad !== undefined || numbers.length === 0) fail(`“${shorten(statement)}” is not a number`);
    } else continue;
    kept.push(statement);
  }
  return kept.join('\n');
}
