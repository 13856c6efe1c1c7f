import { type Deck, deckOf, waistHalfWidth } from './deck.ts';
import type { Dimensions } from './dimensions.ts';
import { fan, flipped, skin, type Triangle, turned } from '../../../geometry/shapes.ts';
import {
  clamp,
  mix,
  mixPoints,
  type Placement,
  place,
  smoothStep,
  steps,
  type Vec3,
} from '../../../geometry/vectors.ts';
import type { Body, Part } from '../../../geometry/wavefront.ts';

interface PlateKind {
  name: 'front-plate' | 'back-plate';
  about: string;
  /** +1: the kick points forward. The back plate is the same form turned half a turn about z. */
  direction: 1 | -1;
  /** Kick above the prism's top, in plate thicknesses. */
  kick: number;
  accent: Vec3;
}

const kinds = {
  front: {
    name: 'front-plate',
    about: 'Front plate of the board',
    direction: 1,
    kick: 0.3,
    accent: [0.95, 0.42, 0.05],
  },
  back: { name: 'back-plate', about: 'Back plate of the board', direction: -1, kick: 0.46, accent: [0.05, 0.36, 0.88] },
} as const satisfies Record<string, PlateKind>;

const cells = 12; // across the deck
const dividers = steps(-1, 1, cells);

export const frontPlateBody = (d: Dimensions): Body => plateBody(d, kinds.front);
export const backPlateBody = (d: Dimensions): Body => plateBody(d, kinds.back);

function plateBody(d: Dimensions, kind: PlateKind): Body {
  const deck = deckOf(d, kind.kick * d.plateThickness);
  const turn = (triangles: readonly Triangle[]): Triangle[] =>
    triangles.map((t) => mapTriangle(t, (p) => [kind.direction * p[0], kind.direction * p[1], p[2]]));
  const parts: Part[] = [
    { group: 'deck', material: 'deck-rubber', triangles: turn(topSkin(deck)) },
    {
      group: 'traction',
      material: 'grip',
      triangles: turn([...slats(d, deck), ...sideBands(d, deck), ...kickRibs(d, deck)]),
    },
    { group: 'bumper', material: 'accent', triangles: turn(bumper(deck)) },
    { group: 'handle', material: 'grip', triangles: turn([...tongue(d, deck), ...collar(d)]) },
    { group: 'handle', material: 'seal', triangles: turn(socket(d)) },
    { group: 'shell', material: 'shell', triangles: turn([...underside(deck), ...belly(d, deck, kind.direction)]) },
    { group: 'housing', material: 'shell', triangles: housing(d, deck, kind.direction), crease: 60 },
    { group: 'screws', material: 'steel', triangles: turn(screws(d, deck)) },
  ];
  return {
    name: kind.name,
    about: `${kind.about}: origin at the centre of its prism, length along x.`,
    accent: kind.accent,
    parts: parts.map((part) => insidePrism(part, d)),
  };
}

const mapTriangle = ([a, b, c]: Triangle, map: (p: Vec3) => Vec3): Triangle => [map(a), map(b), map(c)];

/** What is simulated is a prism of this plan: whatever odd parameters do, nothing shows outside it. */
function insidePrism(part: Part, d: Dimensions): Part {
  const [halfX, halfY] = [d.plateLength / 2, d.plateWidth / 2];
  const inside = (p: Vec3): Vec3 => [clamp(p[0], -halfX, halfX), clamp(p[1], -halfY, halfY), p[2]];
  return { ...part, triangles: part.triangles.map((t) => mapTriangle(t, inside)) };
}

/** Rows from the right edge to the left one, waist to tip. */
const surface = (deck: Deck, height: (s: number, t: number) => number): Vec3[][] =>
  deck.inset.map(({ x, y }) => dividers.map((t): Vec3 => [x, t * y, height(deck.along(x), t)]));

const topSkin = (deck: Deck): Triangle[] => flipped(skin(surface(deck, deck.top)));

function underside(deck: Deck): Triangle[] {
  const rows = surface(deck, deck.under);
  // The waist's end is closed, though the collar hides it.
  return [...skin(rows), ...skin([surface(deck, deck.top)[0] ?? [], rows[0] ?? []])];
}

/** A half-round rim from the skin's edge out to the outline and back in to the shell, from waist to waist around the tip. */
function bumper(deck: Deck): Triangle[] {
  const right = deck.outline.map((_, i) => bumperSection(deck, i, -1));
  const left = deck.outline.map((_, i) => bumperSection(deck, i, 1)).reverse();
  return skin([...right, ...left.slice(1)]);
}

function bumperSection(deck: Deck, i: number, side: 1 | -1): Vec3[] {
  const [outer, inner] = [deck.outline[i] ?? { x: 0, y: 0 }, deck.inset[i] ?? { x: 0, y: 0 }];
  const s = deck.along(inner.x);
  const half = deck.bumperHeight(s) / 2;
  return steps(90, -90, 6).map((degrees): Vec3 => {
    const angle = (degrees * Math.PI) / 180;
    // Sections of one tip share their plan, so the cosine has to be a clean zero and one.
    const out = Math.abs(degrees) === 90 ? 0 : degrees === 0 ? 1 : Math.cos(angle);
    return [
      mix(inner.x, outer.x, out),
      side * mix(inner.y, outer.y, out),
      deck.edge(s) - half + half * Math.sin(angle),
    ];
  });
}

// ── waist: collar, tongue and belly around the end of the torsion bar ──

const waistSegments = 12; // per half
/** The height at which the tongue above and the belly below meet, inside the deck. */
const seam = (d: Dimensions): number => 0.16 * d.plateThickness;
const waistTop = (d: Dimensions): number => Math.max(0.53 * d.plateThickness, 1.25 * d.rodRadius);

/** Half a rounded rectangle: a super-ellipse of exponent 3, from y = -a over the top (or bottom) to y = +a. */
function halfSection(x: number, a: number, height: number, base: number): Vec3[] {
  return steps(180, 0, waistSegments).map((degrees): Vec3 => {
    const angle = (degrees * Math.PI) / 180;
    const round = (v: number): number => (Math.abs(v) < 1e-12 ? 0 : Math.sign(v) * Math.abs(v) ** (2 / 3));
    return [x, a * round(Math.cos(angle)), base + height * round(Math.sin(angle))];
  });
}

const endX = (d: Dimensions): number => -d.plateLength / 2;

/** The padded handle's upper half: thick at the bar, running out to a point on the deck. */
function tongue(d: Dimensions, deck: Deck): Triangle[] {
  const reach = 0.4;
  const [a0, rise] = [waistHalfWidth(d), waistTop(d) - seam(d)];
  const rows = steps(0.03, 1, 12).map((k) => {
    const x = endX(d) + k * reach * d.plateLength;
    const crest = mix(waistTop(d), deck.top(k * reach, 0) + 0.06 * d.plateThickness, smoothStep(0, 0.8, k)) - seam(d);
    const closing = (1 - k ** 6) ** 0.5;
    return halfSection(x, a0 * (1 - k ** 1.5) ** 0.8, Math.min(rise, crest) * closing, seam(d));
  });
  return flipped(skin(rows));
}

/** The lower half: a deep hull at the bar that ends before the wheel, or runs out towards the caster's housing. */
function belly(d: Dimensions, deck: Deck, direction: 1 | -1): Triangle[] {
  const reach = bellyReach(d, direction);
  // A short hull ends in a round step, a long one tapers.
  const blunt = mix(3.2, 1.7, smoothStep(0.15, 0.5, reach));
  const depth = waistTop(d) + seam(d);
  const rows = steps(0, 1, 12).map((k) => {
    const s = 1 - (1 - 0.03 - 0.97 * k) ** 1.6; // closer together where the end rounds off
    const x = endX(d) + s * reach * d.plateLength;
    const left = Math.max(0, 1 - s ** blunt) ** (1 / blunt);
    const wide = Math.min(waistHalfWidth(d) * (1 + 0.5 * s), Math.max(deck.halfWidthAt(x), waistHalfWidth(d)));
    return halfSection(x, wide * Math.max(0, 1 - s ** 4) ** 0.5, -depth * left, seam(d));
  });
  return skin(rows);
}

/** In plate lengths from the waist: short of the wheel standing at rest. */
function bellyReach(d: Dimensions, direction: 1 | -1): number {
  const hubX = restingHub(d)[0];
  const wheelNear = direction * hubX - 1.08 * d.wheelRadius;
  return clamp((wheelNear + d.plateLength / 2) / d.plateLength, 0.1, 0.44);
}

/** Hub of the wheel in the plate's frame, caster straight. */
function restingHub(d: Dimensions): Vec3 {
  const [dx, dz] = [d.hub[0] - d.pivot[0], d.hub[2] - d.pivot[2]];
  const [c, s] = [Math.cos(d.casterAngle), Math.sin(d.casterAngle)];
  return [c * dx + s * dz, 0, -d.pivotDrop - s * dx + c * dz];
}

/** A full ring round the waist whose face is the plate's end: here the prism ends. */
function collar(d: Dimensions): Triangle[] {
  const L = d.plateLength;
  const hole = holeRadius(d);
  const rows = [
    [0, 0.9],
    [0.008, 0.99],
    [0.05, 1],
    [0.058, 0.92],
  ].map(([s = 0, k = 1]) => fullSection(endX(d) + s * L, k * waistHalfWidth(d) * 1.03, k * waistTop(d) * 1.02, d));
  const face = (rows[0] ?? []).map((p): Vec3 => holePoint(p, hole, endX(d)));
  const shut = fullSection(endX(d) + 0.058 * L, 0.5 * waistHalfWidth(d), 0.5 * waistTop(d), d);
  return flipped(skin([face, ...rows, shut]));
}

/** A little play around the bar, but never wider than the collar. */
const holeRadius = (d: Dimensions): number =>
  Math.min(1.04 * d.rodRadius, 0.85 * waistHalfWidth(d), 0.85 * waistTop(d));

function holePoint(outer: Vec3, radius: number, x: number): Vec3 {
  const size = Math.hypot(outer[1], outer[2]) || 1;
  return [x, (outer[1] / size) * radius, (outer[2] / size) * radius];
}

/** The dark gap between collar and bar. */
function socket(d: Dimensions): Triangle[] {
  const rim = fullSection(endX(d), 1, 1, d).map((p) => holePoint(p, holeRadius(d), endX(d)));
  const deep = 0.04 * d.plateLength;
  const back = rim.map((p): Vec3 => [p[0] + deep, p[1], p[2]]);
  return skin([rim, back]);
}

/** The whole rounded rectangle, from +y round over the top and back to +y. */
function fullSection(x: number, a: number, height: number, d: Dimensions): Vec3[] {
  const upper = halfSection(x, a, height - seam(d), seam(d));
  const lower = halfSection(x, a, -(height + seam(d)), seam(d));
  return [...upper, ...lower.reverse().slice(1)];
}

// ── traction ──

const slatHeight = (d: Dimensions): number => 0.05 * d.plateThickness;

/** Two curved rows of S-shaped rubber slats, leaning outwards as in Fig. 1. */
function slats(d: Dimensions, deck: Deck): Triangle[] {
  const rows = 8;
  return steps(0.37, 0.8, rows - 1).flatMap((s, i) => {
    const x = (s - 0.5) * d.plateLength;
    const shrink = 0.72 + 0.28 * Math.sin((Math.PI * (i + 0.8)) / (rows + 0.4));
    const middle = 0.47 * deck.halfWidthAt(x);
    const reach = 0.29 * deck.halfWidthAt(x) * shrink;
    return [1, -1].flatMap((side) => slat(d, deck, x, side * middle, reach, side));
  });
}

/** One slat: a leaf whose middle line is an S, drawn over the deck's surface. */
function slat(d: Dimensions, deck: Deck, x: number, y: number, reach: number, side: number): Triangle[] {
  const lean = 0.55; // outer end further forward
  const widest = 0.0165 * d.plateLength;
  const stations = steps(-1, 1, 8).map((v) => {
    const wave = 0.16 * reach * Math.sin(Math.PI * v);
    const half = widest * (1 - Math.abs(v) ** 3) ** 0.7;
    return { x: x + lean * reach * v + wave, y: y + side * reach * v, half };
  });
  return ridge(d, deck, stations);
}

/** Raised borders along the widest part: the hatched black edge of Fig. 1. */
function sideBands(d: Dimensions, deck: Deck): Triangle[] {
  return [1, -1].flatMap((side) => {
    const stations = steps(0.33, 0.84, 18).map((s) => {
      const x = (s - 0.5) * d.plateLength;
      const k = (s - 0.33) / 0.51;
      return {
        x,
        y: side * 0.885 * deck.halfWidthAt(x),
        half: 0.05 * deck.halfWidthAt(x) * (1 - Math.abs(2 * k - 1) ** 4),
        lateral: true,
      };
    });
    return ridge(d, deck, stations);
  });
}

/** Three ribs across the kick. */
function kickRibs(d: Dimensions, deck: Deck): Triangle[] {
  return [0.86, 0.895, 0.93].flatMap((s) => {
    const x = (s - 0.5) * d.plateLength;
    const reach = 0.72 * deck.halfWidthAt(x);
    const stations = steps(-1, 1, 10).map((v) => ({
      x: x - 0.018 * d.plateLength * v * v,
      y: reach * v,
      half: 0.009 * d.plateLength * (1 - Math.abs(v) ** 4) ** 0.6,
    }));
    return ridge(d, deck, stations);
  });
}

interface RidgeStation {
  x: number;
  y: number;
  /** Half width, along x, or along y where `lateral`. */
  half: number;
  lateral?: boolean;
}

/** A raised strip with sloping sides that follows the deck; its foot is let into the skin. */
function ridge(d: Dimensions, deck: Deck, stations: readonly RidgeStation[]): Triangle[] {
  const height = slatHeight(d);
  const rows = stations.map(({ x, y, half, lateral }) => {
    const point = (across: number, above: number): Vec3 => {
      const [px, py] = lateral ? [x, y + across] : [x + across, y];
      return [px, py, deck.topAt(px, py) + above];
    };
    const up = half > 0 ? height : -height;
    return [point(-half, -height), point(-0.68 * half, up), point(0.68 * half, up), point(half, -height)];
  });
  return facingUp(skin(rows));
}

/** Strips run in either direction; the larger part of their area tells which way up they came out. */
function facingUp(triangles: Triangle[]): Triangle[] {
  const plan = triangles.reduce(
    (sum, [a, b, c]) => sum + (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]),
    0,
  );
  return plan < 0 ? flipped(triangles) : triangles;
}

// ── underneath ──

/** The housing that carries the turntable: from a long footprint on the shell down to a round seat square to the steering axis. */
function housing(d: Dimensions, deck: Deck, direction: 1 | -1): Triangle[] {
  const [c, s] = [Math.cos(d.casterAngle), Math.sin(d.casterAngle)];
  const { radius, half, lift } = d.crown;
  const seatHeight = lift + half;
  const seat: Placement = {
    origin: [s * seatHeight, 0, -d.pivotDrop + c * seatHeight],
    ex: [c, 0, -s],
    ey: [0, 1, 0],
    ez: [s, 0, c],
  };
  const under = (x: number, y: number): number => deck.underAt(direction * x, y);
  const drop = under(0, 0) - seat.origin[2];
  if (c < 0.2 || drop < 0.2 * radius) return [];

  const L = d.plateLength;
  const centre = clamp(seat.origin[0] + (drop * s) / c + 0.02 * L, -0.2 * L, 0.2 * L);
  const [reachX, reachY] = [Math.min(2.5 * radius, 0.16 * L), Math.min(1.7 * radius, 0.3 * d.plateWidth)];
  const around = steps(360, 0, 26).map((degrees) => ((degrees % 360) * Math.PI) / 180);
  const rows = [0, 0.06, 0.22, 0.42, 0.64, 0.84, 1].map((k, row) =>
    around.map((angle): Vec3 => {
      const r = (row === 0 ? 0.9 : 0.98) * radius;
      const low = place(seat, r * Math.cos(angle), r * Math.sin(angle), 0);
      const [x, y] = [centre + reachX * Math.cos(angle), reachY * Math.sin(angle)];
      const high: Vec3 = [x, y, under(x, y) + 0.05 * d.plateThickness];
      // Wider than a straight cone near the shell: a fillet, as moulded parts have.
      const p = mixPoints(low, high, k);
      const flare = mixPoints(low, high, k * k * 0.55 + k * 0.45);
      return [flare[0], flare[1], p[2]];
    }),
  );
  return [...flipped(skin(rows)), ...flipped(fan((rows[0] ?? []).slice(0, -1))).map(downward)];
}

/** The seat's disc looks along the steering axis, downwards. */
function downward(t: Triangle): Triangle {
  const [a, b, c] = t;
  const upwards = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
  return upwards ? [a, c, b] : t;
}

/** Screw heads along the rim, as on the underside in Fig. 1. */
function screws(d: Dimensions, deck: Deck): Triangle[] {
  const radius = 0.012 * d.plateLength;
  return [0.36, 0.5, 0.64, 0.78].flatMap((s) => {
    const x = (s - 0.5) * d.plateLength;
    return [1, -1].flatMap((side) => {
      const y = side * 0.84 * deck.halfWidthAt(x);
      const z = deck.underAt(x, y);
      const downwards: Placement = { origin: [x, y, z], ex: [1, 0, 0], ey: [0, -1, 0], ez: [0, 0, -1] };
      return turned(
        [
          [radius, -0.5 * radius],
          [radius, 0.1 * radius],
          [0.7 * radius, 0.3 * radius],
          [0, 0.3 * radius],
        ],
        8,
        downwards,
      );
    });
  });
}
