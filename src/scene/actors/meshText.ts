/**
 * Reads Wavefront text: what a body is drawn from, or the line that is wrong, so that a broken file is no empty or torn
 * body. Pure text work. Faces alone are drawn, with a material's colour and opacity: lines, points, textures and curves
 * are left out, and no other file is asked for.
 */

/** A mesh file that cannot be drawn; the message names the file and the line. */
export class MeshError extends Error {
  override name = 'MeshError';
}

/** Faces under one name, as triangles: 9 numbers each. */
export interface MeshPart {
  name: string;
  /** m. */
  positions: number[];
  /** Of the corners; where a face gives none, its own. */
  normals: number[];
  /** Whose material the corners from `start` on have, in their order. */
  uses: { material: string; start: number }[];
}

/** A material as its file has it. */
export interface MeshMaterial {
  /** Diffuse (Kd), sRGB 0 to 1. */
  color: readonly [number, number, number];
  opacity: number;
}

/** Statements of the format that have no meaning here: other files, free-form curves, display hints. */
const IGNORED = new Set([
  'l',
  'p',
  's',
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

function* statements(text: string): Generator<{ line: number; text: string; words: string[] }> {
  let line = 0;
  for (const raw of text.split(/\r\n|\r|\n/)) {
    line++;
    const clean = raw.replace(/#.*$/, '').replace(/\0/g, '').trim();
    if (clean !== '') yield { line, text: clean, words: clean.split(/\s+/) };
  }
}

type Fail = (what: string) => never;

/** Throws `MeshError`. @param file the name used in messages */
export function readMesh(text: string, file: string): MeshPart[] {
  const given = { v: [] as number[], vn: [] as number[], vt: [] as number[] };
  const parts: MeshPart[] = [];
  let part: MeshPart | null = null;
  let [name, material] = ['', ''];
  for (const { line, text: statement, words } of statements(text.replace(/\\\r?\n/g, ' '))) {
    const fail: Fail = (what) => {
      throw new MeshError(`${file}, line ${line}: ${what}`);
    };
    const key = words[0]!;
    if (key === 'v' || key === 'vn' || key === 'vt') readNumbers(words, WIDTH[key], given[key], fail);
    else if (key === 'f') {
      if (words.length < 4) fail(`a face needs 3 points and has ${words.length - 1}`);
      if (!part) parts.push((part = { name, positions: [], normals: [], uses: [] }));
      if (part.uses.at(-1)?.material !== material) part.uses.push({ material, start: part.positions.length / 3 });
      addFace(
        part,
        words.slice(1).map((corner) => cornerOf(corner, given, fail)),
        given,
      );
    } else if (key === 'usemtl') material = statement.slice(key.length).trim();
    else if (key === 'o' || key === 'g') [name, part] = [statement.slice(1).trim(), null];
    else if (!IGNORED.has(key)) fail(`“${shorten(statement)}” is not a statement of an OBJ mesh`);
  }
  if (parts.length === 0) throw new MeshError(`${file}: there are no faces to draw (${given.v.length / 3} points)`);
  return parts;
}

/** The first of a statement's numbers; whatever stands behind them must be one too. */
function readNumbers(words: readonly string[], width: number, into: number[], fail: Fail): void {
  if (words.length - 1 < width) fail(`“${words[0]}” needs ${width} numbers and has ${words.length - 1}`);
  for (let i = 1; i < words.length; i++) {
    const number = Number(words[i]);
    if (!Number.isFinite(number)) fail(`“${words[i]}” is not a number`);
    if (i <= width) into.push(number);
  }
}

type Given = Readonly<Record<keyof typeof WIDTH, readonly number[]>>;
const KINDS = ['v', 'vt', 'vn'] as const;

/** Where a corner's point and normal begin among the numbers; -1: it names no normal. */
function cornerOf(corner: string, given: Given, fail: Fail): { point: number; normal: number } {
  const words = corner.split('/');
  const at = (k: number): number => {
    const kind = KINDS[k]!;
    const count = given[kind].length / WIDTH[kind];
    const word = words[k];
    if (word === undefined || (word === '' && k > 0)) return -1;
    const index = Number(word);
    if (!Number.isInteger(index) || index === 0) fail(`“${corner}” does not name a point`);
    // A negative index counts back from the last one so far.
    if (index > count || -index > count) fail(`“${corner}” names point ${index} of ${count} (${kind})`);
    return WIDTH[kind] * (index > 0 ? index - 1 : count + index);
  };
  const point = at(0);
  at(1);
  return { point, normal: at(2) };
}

/** A face as triangles about its first corner. */
function addFace(
  { positions, normals }: MeshPart,
  corners: readonly { point: number; normal: number }[],
  { v, vn }: Given,
): void {
  for (let i = 2; i < corners.length; i++) {
    const triangle = [corners[0]!, corners[i - 1]!, corners[i]!] as const;
    for (const { point } of triangle) positions.push(v[point]!, v[point + 1]!, v[point + 2]!);
    const flat = triangle.some(({ normal }) => normal < 0) ? normalOf(positions.slice(-9)) : null;
    for (const { normal: at } of triangle) normals.push(...(flat ?? vn.slice(at, at + 3)));
  }
}

/** Of a triangle, 9 numbers; zero where it has no area. */
function normalOf(p: readonly number[]): readonly number[] {
  const side = (i: number): readonly number[] => [0, 1, 2].map((k) => p[3 * i + k]! - p[k]!);
  const [a, b] = [side(1), side(2)];
  const cross = [a[1]! * b[2]! - a[2]! * b[1]!, a[2]! * b[0]! - a[0]! * b[2]!, a[0]! * b[1]! - a[1]! * b[0]!];
  const size = Math.hypot(...cross);
  return cross.map((x) => (size > 0 ? x / size : 0));
}

const share = (x: number): number => Math.min(1, Math.max(0, x));

/** Materials by name; texture maps, which would ask the network, are left out. Throws `MeshError`. */
export function readMaterials(text: string, file: string): ReadonlyMap<string, MeshMaterial> {
  const found = new Map<string, MeshMaterial>();
  let current: MeshMaterial | null = null;
  for (const { line, text: statement, words } of statements(text)) {
    const fail: Fail = (what) => {
      throw new MeshError(`${file}, line ${line}: ${what}`);
    };
    const key = words[0]!.toLowerCase();
    if (/^(map_|bump|disp|decal|refl|norm)/.test(key)) continue;
    if (key === 'newmtl') {
      if (words.length < 2) fail('“newmtl” has no name');
      found.set(statement.slice(key.length).trim(), (current = { color: [1, 1, 1], opacity: 1 }));
    } else if (!current) {
      fail(`“${shorten(statement)}” stands before the first “newmtl”`);
    } else if (/^(k[ade]|ks|n[is]|d|tr)$/.test(key)) {
      const numbers = words
        .slice(1)
        .filter((word) => word !== '-halo')
        .map(Number);
      if (numbers.length === 0 || !numbers.every(Number.isFinite)) fail(`“${shorten(statement)}” is not a number`);
      const [x, y = x, z = x] = numbers as [number, number?, number?];
      if (key === 'kd') current.color = [x, y, z];
      else if (key === 'd') current.opacity = share(x);
      else if (key === 'tr') current.opacity = share(1 - x);
    }
  }
  return found;
}
