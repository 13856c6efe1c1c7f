import type { Triangle } from './shapes.ts';
import { add, cross, dot, length, scale, subtract, type Vec3 } from './vectors.ts';

/** Faces of one material in one group; normals are smoothed within a part, never across parts. */
export interface Part {
  group: string;
  material: MaterialName;
  triangles: readonly Triangle[];
  /** Edges sharper than this stay hard (degrees). */
  crease?: number;
}

export interface Body {
  name: string;
  about: string;
  parts: readonly Part[];
  accent?: Vec3;
}

interface Material {
  about: string;
  /** Diffuse and specular colour, sRGB 0..1. */
  Kd: Vec3;
  Ks: Vec3;
  /** Specular exponent. */
  Ns: number;
}

const materials = {
  'deck-rubber': { about: 'deck skin', Kd: [0.34, 0.36, 0.39], Ks: [0.08, 0.08, 0.08], Ns: 18 },
  grip: { about: 'traction slats and padded handle', Kd: [0.12, 0.12, 0.135], Ks: [0.14, 0.14, 0.14], Ns: 30 },
  accent: { about: 'bumper; its colour tells front from back', Kd: [0.5, 0.5, 0.5], Ks: [0.25, 0.25, 0.25], Ns: 60 },
  'accent-front': {
    about: 'what belongs to the front, on a body that does not',
    Kd: [0.95, 0.42, 0.05],
    Ks: [0.25, 0.25, 0.25],
    Ns: 60,
  },
  'accent-back': {
    about: 'what belongs to the back, on a body that does not',
    Kd: [0.05, 0.36, 0.88],
    Ks: [0.25, 0.25, 0.25],
    Ns: 60,
  },
  shell: { about: 'moulded underside', Kd: [0.22, 0.225, 0.245], Ks: [0.18, 0.18, 0.18], Ns: 40 },
  aluminium: { about: 'torsion bar and wheel core', Kd: [0.74, 0.74, 0.72], Ks: [0.6, 0.6, 0.6], Ns: 120 },
  steel: { about: 'fork, bearings, screws', Kd: [0.56, 0.58, 0.61], Ks: [0.7, 0.7, 0.7], Ns: 180 },
  urethane: { about: 'tyre', Kd: [0.87, 0.86, 0.8], Ks: [0.3, 0.3, 0.3], Ns: 70 },
  mark: { about: 'print on the tyre that shows the spin', Kd: [0.13, 0.2, 0.3], Ks: [0.15, 0.15, 0.15], Ns: 40 },
  paint: { about: 'painted parts', Kd: [0.8, 0.81, 0.82], Ks: [0.2, 0.2, 0.2], Ns: 50 },
  ink: { about: 'marks of a scale, lines of a construction', Kd: [0.13, 0.14, 0.16], Ks: [0.1, 0.1, 0.1], Ns: 20 },
  cloth: { about: 'clothes of a rider', Kd: [0.46, 0.49, 0.54], Ks: [0.05, 0.05, 0.05], Ns: 10 },
  seal: { about: 'bearing seals and shadow gaps', Kd: [0.04, 0.04, 0.045], Ks: [0.1, 0.1, 0.1], Ns: 20 },
} as const satisfies Record<string, Material>;

export type MaterialName = keyof typeof materials;

const pointDecimals = 5;
const normalDecimals = 5;
const defaultCrease = 38;

/** Fixed decimals, so that the same numbers give the same bytes; minus zero would be a difference of no meaning. */
function fixed(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text;
}

const line = (v: Vec3, decimals: number): string => v.map((x) => fixed(x, decimals)).join(' ');

/** Numbers lines as they are first met, from 1 as OBJ does. */
class LineTable {
  readonly lines: string[] = [];
  private readonly indices = new Map<string, number>();

  index(text: string): number {
    let index = this.indices.get(text);
    if (index === undefined) {
      this.lines.push(text);
      index = this.lines.length;
      this.indices.set(text, index);
    }
    return index;
  }
}

interface Corner {
  key: string;
  angle: number;
}

interface Facet {
  normal: Vec3;
  corners: readonly [Corner, Corner, Corner];
}

const asWritten = (v: Vec3): Vec3 => [round(v[0]), round(v[1]), round(v[2])];
const round = (x: number): number => Number(fixed(x, pointDecimals));

/** Everything is computed from the coordinates as written, so the normals belong to the file, not to its source. */
function facetOf(triangle: Triangle): Facet | undefined {
  const [a, b, c] = [asWritten(triangle[0]), asWritten(triangle[1]), asWritten(triangle[2])];
  const area = cross(subtract(b, a), subtract(c, a));
  const size = length(area);
  if (!(size > 1e-11)) return undefined; // closed up by rounding, or at a pole
  const corner = (at: Vec3, left: Vec3, right: Vec3): Corner => ({
    key: line(at, pointDecimals),
    angle: angleBetween(subtract(left, at), subtract(right, at)),
  });
  return { normal: scale(area, 1 / size), corners: [corner(a, b, c), corner(b, c, a), corner(c, a, b)] };
}

const angleBetween = (a: Vec3, b: Vec3): number => Math.atan2(length(cross(a, b)), dot(a, b));

/** Mean of the facets around a corner, weighted by angle, leaving out those across a hard edge. */
function cornerNormal(facet: Facet, around: readonly { facet: Facet; angle: number }[], cosCrease: number): Vec3 {
  let sum: Vec3 = [0, 0, 0];
  for (const other of around) {
    if (dot(other.facet.normal, facet.normal) >= cosCrease) sum = add(sum, scale(other.facet.normal, other.angle));
  }
  const size = length(sum);
  return size > 1e-9 ? scale(sum, 1 / size) : facet.normal;
}

function faceLines(part: Part, points: LineTable, normals: LineTable): string[] {
  const facets = part.triangles.flatMap((t) => facetOf(t) ?? []);
  const around = new Map<string, { facet: Facet; angle: number }[]>();
  for (const facet of facets) {
    for (const { key, angle } of facet.corners) {
      const list = around.get(key);
      if (list) list.push({ facet, angle });
      else around.set(key, [{ facet, angle }]);
    }
  }
  const cosCrease = Math.cos(((part.crease ?? defaultCrease) * Math.PI) / 180);
  return facets.map((facet) => {
    const corners = facet.corners.map(({ key }) => {
      const normal = cornerNormal(facet, around.get(key) ?? [], cosCrease);
      return `${points.index(key)}//${normals.index(line(normal, normalDecimals))}`;
    });
    return `f ${corners.join(' ')}`;
  });
}

/**
 * Wavefront OBJ; parts of one group must follow one another, so that a reader sees each group once.
 *
 * @param body its parts, m
 */
export function writeMesh(body: Body): string {
  const points = new LineTable();
  const normals = new LineTable();
  const faces: string[] = [];
  let group = '';
  for (const part of body.parts) {
    const lines = faceLines(part, points, normals);
    if (lines.length === 0) continue;
    if (part.group !== group) faces.push(`g ${(group = part.group)}`);
    faces.push(`usemtl ${part.material}`, ...lines);
  }
  return [
    `# ${body.about}`,
    '# Metres, x forward, y to the left, z up. Generated by scripts/write-models.ts: change the generator, not this file.',
    `mtllib ${body.name}.mat`,
    `o ${body.name}`,
    ...points.lines.map((v) => `v ${v}`),
    ...normals.lines.map((v) => `vn ${v}`),
    ...faces,
    '',
  ].join('\n');
}

/**
 * MTL with the materials that the body uses, in a fixed order.
 *
 * @param body its parts
 */
export function writeMaterials(body: Body): string {
  const used = new Set<string>(body.parts.map((part) => part.material));
  const blocks = Object.entries(materials as Record<string, Material>)
    .filter(([name]) => used.has(name))
    .map(([name, material]) => {
      const Kd = name === 'accent' && body.accent ? body.accent : material.Kd;
      return [
        `# ${material.about}`,
        `newmtl ${name}`,
        `Ka ${line(Kd, 3)}`,
        `Kd ${line(Kd, 3)}`,
        `Ks ${line(material.Ks, 3)}`,
        `Ns ${fixed(material.Ns, 1)}`,
        'd 1.0',
        'illum 2',
        '',
      ].join('\n');
    });
  return [`# Materials of ${body.name}.mdl; generated by scripts/write-models.ts`, '', ...blocks].join('\n');
}
