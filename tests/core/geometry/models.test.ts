import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { type Model, valueOf } from '../../../src/core/geometry/drawing.ts';
import { dimensionsOf } from '../../../src/core/systems/ripstik/drawing/dimensions.ts';
import { drawingOf } from '../../drawings.ts';
import { ripstikMeta } from '../../../src/core/systems/ripstik/meta.ts';

type Point = [number, number, number];
interface Face {
  group: string;
  material: string;
  points: Point[];
  normals: Point[];
}

const defaults: Record<string, number> = Object.fromEntries(ripstikMeta.parameters.map((p) => [p.name, p.default]));
const modelNames = ['rod', 'front-plate', 'back-plate', 'caster'] as const;
const generateModels = (parameters: Record<string, number>) =>
  drawingOf(ripstikMeta, parameters).pairs as Record<(typeof modelNames)[number], Model>;
const models = generateModels(defaults);

const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const size = (a: Point): number => Math.sqrt(dot(a, a));

/** A small reader of its own, strict about every index. */
function read(mdl: string): Face[] {
  const points: Point[] = [];
  const normals: Point[] = [];
  const faces: Face[] = [];
  let group = '';
  let material = '';
  for (const row of mdl.split('\n')) {
    const [word, ...rest] = row.split(' ');
    if (word === 'v') points.push(rest.map(Number) as Point);
    else if (word === 'vn') normals.push(rest.map(Number) as Point);
    else if (word === 'g') group = rest[0] ?? '';
    else if (word === 'usemtl') material = rest[0] ?? '';
    else if (word === 'f') {
      const corners = rest.map((corner) => corner.split('//').map(Number));
      const pick = (list: Point[], index: number | undefined): Point => {
        const found = list[(index ?? 0) - 1];
        if (!found) throw new Error(`index out of range in: ${row}`);
        return found;
      };
      faces.push({
        group,
        material,
        points: corners.map((c) => pick(points, c[0])),
        normals: corners.map((c) => pick(normals, c[1])),
      });
    }
  }
  return faces;
}

const range = (faces: readonly Face[], axis: 0 | 1 | 2): [number, number] => {
  const values = faces.flatMap((f) => f.points.map((p) => p[axis]));
  return [values.reduce((a, b) => Math.min(a, b), Infinity), values.reduce((a, b) => Math.max(a, b), -Infinity)];
};

/** Smallest agreement of a corner's normal with its face's winding, over the mesh. */
function worstAgreement(faces: readonly Face[]): number {
  return faces.reduce((worst, { points, normals }) => {
    const [a, b, c] = points as [Point, Point, Point];
    const area = cross(minus(b, a), minus(c, a));
    return normals.reduce((w, n) => Math.min(w, dot(n, area) / size(area)), worst);
  }, Infinity);
}

/** Six times the enclosed volume of a group, from its own middle: positive when faces look outwards. */
function signedVolume(faces: readonly Face[]): number {
  const middle = [0, 1, 2].map((axis) => {
    const [low, high] = range(faces, axis as 0 | 1 | 2);
    return (low + high) / 2;
  }) as Point;
  return faces.reduce((sum, { points }) => {
    const [a, b, c] = points.map((p) => minus(p, middle)) as [Point, Point, Point];
    return sum + dot(a, cross(b, c));
  }, 0);
}

const parameterSets: Record<string, Record<string, number>> = {
  street: defaults,
  authors: { ...defaults, ...ripstikMeta.parameterSets.authors },
  'all zero': Object.fromEntries(Object.keys(defaults).map((name) => [name, 0])),
  'all negative': Object.fromEntries(Object.entries(defaults).map(([name, x]) => [name, -x])),
  nothing: {},
  'not numbers': { plateLength: NaN, wheelRadius: Infinity, casterAngle: -Infinity },
  'caster flat on its side': { ...defaults, casterAngle: Math.PI / 2 },
  'caster upright': { ...defaults, casterAngle: 0, casterTrail: 0 },
  'short plates, far apart': { ...defaults, plateLength: 0.05, plateOffset: 1 },
  'thick rod, large wheels': { ...defaults, rodRadius: 0.2, wheelRadius: 0.5 },
  'pivot above the deck': { ...defaults, pivotDrop: -0.2, casterDrop: -0.1 },
};

describe('the files of the generated models', () => {
  it.each(modelNames)('%s on disk is what the generator writes', (name) => {
    for (const ending of ['mdl', 'mat'] as const) {
      expect(
        readFileSync(new URL(`../../../public/models/${name}.${ending}`, import.meta.url), 'utf8') ===
          models[name][ending],
      ).toBe(true);
    }
  });

  it.each(modelNames)('%s names its material file, and every material in it', (name) => {
    expect(models[name].mdl).toContain(`mtllib ${name}.mat\n`);
    const known = new Set([...models[name].mat.matchAll(/^newmtl (.+)$/gm)].map((m) => m[1]));
    expect(new Set(read(models[name].mdl).map((f) => f.material))).toEqual(known);
  });

  it('keeps within what software WebGL can draw', () => {
    const budget = { rod: 1500, 'front-plate': 6000, 'back-plate': 6000, caster: 3000 };
    for (const name of modelNames) expect(read(models[name].mdl).length, name).toBeLessThanOrEqual(budget[name]);
  });

  it('tells front from back by the bumper', () => {
    const accent = (mat: string) => /newmtl accent\n.*\nKd (.+)/.exec(mat)?.[1];
    expect(accent(models['front-plate'].mat)).not.toBe(accent(models['back-plate'].mat));
  });
});

describe.each(Object.entries(parameterSets))('meshes for %s', (_, parameters) => {
  const made = generateModels(parameters);

  it.each(modelNames)('%s: finite, indices valid, unit normals on the side of the winding', (name) => {
    expect(`${made[name].mdl}${made[name].mat}`).not.toMatch(/NaN|Infinity|undefined|-0\.0+(\s|$)/);
    const faces = read(made[name].mdl);
    expect(faces.length).toBeGreaterThan(10);
    expect(
      faces.reduce((worst, f) => f.normals.reduce((w, n) => Math.max(w, Math.abs(size(n) - 1)), worst), 0),
    ).toBeLessThan(2e-5);
    expect(worstAgreement(faces)).toBeGreaterThan(0);
  });

  it('is the same text when made again', () => {
    expect(JSON.stringify(generateModels(parameters)) === JSON.stringify(made)).toBe(true);
  });
});

describe.each(['street', 'authors', 'caster upright'])('what is shown is what is simulated (%s)', (set) => {
  const parameters = parameterSets[set] ?? defaults;
  const p = (name: string): number => parameters[name] ?? NaN;
  const made = generateModels(parameters);

  it.each(['front-plate', 'back-plate'] as const)('%s fills the plan of its prism', (name) => {
    const faces = read(made[name].mdl);
    for (const [axis, extent] of [
      [0, p('plateLength')],
      [1, p('plateWidth')],
    ] as const) {
      const [low, high] = range(faces, axis);
      expect(low).toBeCloseTo(-extent / 2, 5);
      expect(high).toBeCloseTo(extent / 2, 5);
    }
  });

  it.each(['front-plate', 'back-plate'] as const)('%s leaves room for the wheel standing under its skin', (name) => {
    const [c, s] = [Math.cos(p('casterAngle')), Math.sin(p('casterAngle'))];
    const skate: Point = [
      -c * p('casterTrail') - s * p('casterDrop'),
      0,
      -p('pivotDrop') + s * p('casterTrail') - c * p('casterDrop'),
    ];
    const hub: Point = [skate[0], 0, skate[2] + p('wheelRadius')];
    const inTheWay = read(made[name].mdl)
      .flatMap((f) => f.points)
      .filter(
        (q) => Math.abs(q[1]) < 0.3 * p('wheelRadius') && Math.hypot(q[0] - hub[0], q[2] - hub[2]) < p('wheelRadius'),
      );
    expect(inTheWay).toEqual([]);
  });

  it('rod is the simulated cylinder', () => {
    const faces = read(made.rod.mdl);
    expect(range(faces, 0)[1]).toBeCloseTo(p('rodLength') / 2, 5);
    expect(range(faces, 0)[0]).toBeCloseTo(-p('rodLength') / 2, 5);
    for (const axis of [1, 2] as const) expect(range(faces, axis)[1]).toBeCloseTo(p('rodRadius'), 5);
  });

  it('wheel has its radius about the hub and stands on the origin', () => {
    const wheel = read(made.caster.mdl)
      .filter((f) => f.group === 'wheel')
      .flatMap((f) => f.points);
    const hub = dimensionsOf(valueOf(ripstikMeta, parameters)).hub as Point;
    const up: Point = [-Math.sin(p('casterAngle')), 0, Math.cos(p('casterAngle'))];
    const radius = Math.max(...wheel.map((q) => Math.hypot(q[0] - hub[0], q[2] - hub[2])));
    expect(Math.abs(radius - p('wheelRadius'))).toBeLessThan(1e-5);
    expect(size(minus(hub, [up[0] * p('wheelRadius'), 0, up[2] * p('wheelRadius')]))).toBeLessThan(1e-12);
    expect(Math.abs(Math.min(...wheel.map((q) => dot(q, up))))).toBeLessThan(1e-5);
    expect(wheel.some((q) => size(q) === 0)).toBe(true);
  });

  it('the wheel is one group, apart from everything else', () => {
    expect(made.caster.mdl.match(/^g .*$/gm)).toEqual(['g fork', 'g wheel']);
  });
});

describe('faces look outwards', () => {
  const whole = [
    'rod:bar',
    'rod:handle',
    'front-plate:handle',
    'front-plate:housing',
    'front-plate:bumper',
    'back-plate:handle',
    'back-plate:housing',
    'back-plate:bumper',
    'caster:fork',
    'caster:wheel',
  ];
  it.each(whole)('%s', (which) => {
    const [name = 'rod', group] = which.split(':') as ['rod', string];
    const faces = read(models[name].mdl).filter((f) => f.group === group);
    expect(faces.length).toBeGreaterThan(0);
    expect(signedVolume(faces)).toBeGreaterThan(0);
  });

  it.each(['front-plate', 'back-plate'] as const)('%s: deck up, shell down', (name) => {
    const faces = read(models[name].mdl);
    const lift = (group: string): number =>
      faces
        .filter((f) => f.group === group)
        .reduce((sum, f) => sum + f.normals.reduce((s, n) => s + n[2], 0) / (3 * faces.length), 0);
    expect(lift('deck')).toBeGreaterThan(0);
    expect(lift('shell')).toBeLessThan(0);
    expect(lift('traction')).toBeGreaterThan(0);
  });
});
