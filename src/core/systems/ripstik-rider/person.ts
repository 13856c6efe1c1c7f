/**
 * A rider by height and mass: the body's segments by P. de Leva, Adjustments to Zatsiorsky-Seluyanov's segment inertia
 * parameters, Journal of Biomechanics 29 (1996) 1223-1230, table 4, men of 1.741 m and 73.0 kg on the mean. Heights of ankle and
 * shoulder and the distance between the hips: D. A. Winter, Biomechanics and Motor Control of Human Movement, 4th ed. (2009), figure 4.1.
 */

/** Share of the body's mass; length, mm; centre from the upper end and radii of gyration (back to front, side to side, along), shares of the length. */
type Segment = readonly [mass: number, length: number, centre: number, front: number, side: number, along: number];

const HEAD: Segment = [0.0694, 203.3, 0.5976, 0.362, 0.376, 0.312];
const TRUNK: Segment = [0.4346, 531.9, 0.4486, 0.372, 0.347, 0.191];
const UPPER_ARM: Segment = [0.0271, 281.7, 0.5772, 0.285, 0.269, 0.158];
const FOREARM: Segment = [0.0162, 268.9, 0.4574, 0.276, 0.265, 0.121];
const HAND: Segment = [0.0061, 86.2, 0.79, 0.628, 0.513, 0.401];
const THIGH: Segment = [0.1416, 422.2, 0.4095, 0.329, 0.329, 0.149];
const SHANK: Segment = [0.0433, 434.0, 0.4459, 0.255, 0.249, 0.103];
const FOOT: Segment = [0.0137, 258.1, 0.4415, 0.257, 0.245, 0.124];
/** Of the table's body, mm. */
const TALL = 1741;
/** Shares of the height. */
const ANKLE = 0.039;
const SHOULDER = 0.818;
const SHOULDERS = 0.129;

/** Of thigh and shank against the vertical on a board and in a deep crouch, rad: knees bent by twice as much. */
const BENT = Math.PI / 6;
const CROUCHED = Math.PI / 3;

export interface Person {
  /** m, upright. */
  height: number;
  /** kg. */
  mass: number;
}

const ABOVE_HIPS = new Set([HEAD, TRUNK, UPPER_ARM, FOREARM, HAND]);

interface Piece {
  aboveHips: boolean;
  mass: number;
  /** To the front, to the side, up from the soles, m. */
  at: readonly [number, number, number];
  /** About its own centre, front to back, side to side, up, kg·m². */
  inertia: readonly [number, number, number];
}

/**
 * Mass, height of the centre above the soles and moments of inertia about it (front to back, side to side, up) of somebody
 * whose arms hang; and what of the last is of hips and above about an axis of their own.
 *
 * @param person height and mass
 * @param bent of thigh and shank against the vertical, rad
 * @param stance from the middle to each foot, to the side, m
 */
export function bodyOf({ height, mass }: Person, bent: number, stance: number) {
  const pieces: Piece[] = [];
  /** @param lean of the segment against the vertical, to the front with its upper end */
  const put = (segment: Segment, top: Piece['at'], lean = 0): Piece['at'] => {
    const [share, length, centre, front, side, along] = segment;
    const l = (length / TALL) * height;
    const [c, s] = [Math.cos(lean), Math.sin(lean)];
    const m = share * mass;
    const [x, y, z] = [front, side, along].map((k) => m * (k * l) ** 2) as [number, number, number];
    const at = (part: number): Piece['at'] => [top[0] - part * l * s, top[1], top[2] - part * l * c];
    const inertia = [c * c * x + s * s * z, y, c * c * z + s * s * x] as const;
    pieces.push({ aboveHips: ABOVE_HIPS.has(segment), mass: m, at: at(centre), inertia });
    return at(1);
  };
  const leg = ((THIGH[1] + SHANK[1]) / TALL) * height * Math.cos(bent);
  const hip = ANKLE * height + leg;
  // Hips above the ankles: the knees stand before them.
  const kneeAhead = (SHANK[1] / TALL) * height * Math.sin(bent);
  const hipAhead = kneeAhead - (THIGH[1] / TALL) * height * Math.sin(bent);
  const lower = hip - (ANKLE + (THIGH[1] + SHANK[1]) / TALL) * height;
  for (const side of [-1, 1]) {
    const knee = put(THIGH, [hipAhead, side * stance, hip], -bent);
    put(SHANK, knee, bent);
    // Horizontal: from the heel, a quarter of it behind the ankle, to the toes.
    const foot = (FOOT[1] / TALL) * height;
    put(FOOT, [0.75 * foot, side * stance, (ANKLE * height) / 2], Math.PI / 2);
    const shoulder: Piece['at'] = [hipAhead, side * SHOULDERS * height, SHOULDER * height + lower];
    put(HAND, put(FOREARM, put(UPPER_ARM, shoulder)));
  }
  const trunk = (TRUNK[1] / TALL) * height;
  put(TRUNK, [hipAhead, 0, hip + trunk]);
  put(HEAD, [hipAhead, 0, height + lower]);
  const { mass: total, centre, inertia } = together(pieces);
  const upper = together(pieces.filter(({ aboveHips }) => aboveHips));
  return { mass: total, centre: centre[2]!, inertia, hips: upper.inertia[2] };
}

/** Mass, centre and moments of inertia about it. */
function together(pieces: readonly Piece[]) {
  const mass = pieces.reduce((sum, piece) => sum + piece.mass, 0);
  const centre = [0, 1, 2].map((i) => pieces.reduce((sum, piece) => sum + piece.mass * piece.at[i]!, 0) / mass);
  const inertia = [0, 1, 2].map((i) =>
    pieces.reduce((sum, piece) => {
      const [j, k] = [(i + 1) % 3, (i + 2) % 3] as const;
      return (
        sum + piece.inertia[i]! + piece.mass * ((piece.at[j]! - centre[j]!) ** 2 + (piece.at[k]! - centre[k]!) ** 2)
      );
    }, 0),
  );
  return { mass, centre, inertia: inertia as [number, number, number] };
}

/**
 * The rider's parameters, SI: sideways on the board with bent knees, so that the board's roll turns the body about the axis from
 * side to side.
 *
 * @param person height and mass
 * @param plateOffset from the board's middle to each foot, m
 * @param plateThickness m: the soles stand half of it above the rod's centre
 */
export function riderOf(person: Person, plateOffset = 0.26, plateThickness = 0.05): Record<string, number> {
  const { mass, centre, inertia, hips } = bodyOf(person, BENT, plateOffset);
  const round = (x: number): number => Math.round(x * 1000) / 1000;
  return {
    riderMass: round(mass),
    riderHeight: round(centre + plateThickness / 2),
    riderIxx: round(inertia[1]),
    riderIyy: round(inertia[0]),
    riderIzz: round(inertia[2]),
    hipIzz: round(hips),
  };
}

/**
 * How far down the centre of mass goes, from knees bent as on a board to knees bent by a right angle and a third of one more, m.
 *
 * @param person height and mass
 */
export const crouchOf = (person: Person): number => bodyOf(person, BENT, 0).centre - bodyOf(person, CROUCHED, 0).centre;
