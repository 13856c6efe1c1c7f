/**
 * How far a run can be trusted: the same scenario computed a second time, by another method with tighter tolerances, and
 * to how many digits the two agree.
 *
 * With e1 the first run's error and e2 the second's, what is seen is |e1 - e2|. Tolerances a hundredfold tighter make e2
 * small beside e1 as long as both have digits; a method with another tableau, or of another kind, makes it unlikely that
 * e1 and e2 are alike where both are large (a motion that magnifies errors), as they are for one method at two tolerances.
 * Estimating a global error by a second solution: Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I
 * (2nd ed.), section II.4; Shampine, Global error estimation with one-step methods, Comput. Math. Appl. 12A (1986).
 *
 * Not guaranteed: what both runs share (the equations, the formulas of the inputs) is not tested by their difference.
 */
import type { MethodOptions, Scenario } from '../scenario/types.ts';
import type { SystemMeta } from '../model/system.ts';

/** How much tighter the second run's tolerances are. */
const TIGHTER = 1e-2;
/**
 * No looser than this: an error of the second run that is as large as the first's can cancel it for a moment, which would
 * be told as digits. With a method of order 8 it costs about what the first run does.
 */
const LOOSEST = 1e-13;
/** Rounding forbids more: asked for less, steps shrink without a gain. */
const TIGHTEST = 1e-15;
/** Doubles hold no more. */
const MOST_DIGITS = 15;
/** Digits are told to a hundredth, downwards. */
const STEPS_PER_DIGIT = 100;

/** Numbers of digits that are asked for. */
const ASKED = [4, 2, 1] as const;

/** Methods beside which Gauss is the second one. */
const FOR_GAUSS: ReadonlySet<string> = new Set(['dop853', 'radau', 'bdf', 'ida']);

/**
 * The scenario of a second run.
 *
 * @param scenario of the first run
 */
export function secondScenario(scenario: Scenario): Scenario {
  return { ...scenario, method: secondMethod(scenario.method), columns: [] };
}

/**
 * Another method, of order 8: Dormand and Prince's 8(5,3), which solves a stiff motion too, slowly; Gauss with four stages
 * beside that one, and beside methods that are chosen for stiff motions.
 */
function secondMethod({ name, formulation, rtol, atol, maxStep, projection }: MethodOptions): MethodOptions {
  const tolerances = {
    rtol: Math.max(Math.min(TIGHTER * rtol, LOOSEST), TIGHTEST),
    atol: Math.max(Math.min(TIGHTER * atol, LOOSEST), TIGHTEST),
  };
  const other = FOR_GAUSS.has(name) ? { name: 'gauss', stages: 4 } : { name: 'dop853' };
  return {
    ...other,
    ...tolerances,
    projection,
    ...(formulation === undefined ? {} : { formulation }),
    ...(maxStep === undefined ? {} : { maxStep }),
  };
}

/** What two runs agree in. */
export interface Trust {
  /** At every row that was compared: time (s) and digits, 0 to 15. */
  digits: readonly (readonly [number, number])[];
  /** Time (s) up to which so many digits hold. */
  until: Readonly<Record<'4' | '2' | '1', number>>;
  against: MethodOptions;
  /** Time (s) to which was compared. */
  compared: number;
}

/** How a run ended, as far as rows beside each other are concerned. */
type End = { reason: string };

/**
 * Sizes below which a difference of a coordinate counts as it is: 1 rad, 0.1 m, 1 of what is no length.
 *
 * @param meta of the system
 */
export const leastSizes = ({ coordinates, order }: Pick<SystemMeta, 'coordinates' | 'order'>): Float64Array =>
  Float64Array.from(coordinates, ({ kind }) => (kind === 'length' && order !== 1 ? 0.1 : 1));

/** Takes the rows of two runs as they come, and keeps no more of them than one is ahead. */
export class DigitsMeter {
  readonly digits: [number, number][] = [];
  private readonly against: MethodOptions;
  private readonly n: number;
  /** Largest size so far, with the floor below which a difference is absolute. */
  private readonly size: Float64Array;
  private readonly waiting: [Float64Array[], Float64Array[]] = [[], []];
  /** A row of one stands at a time that the other has none at. */
  private apart = false;

  /** @param against the second run's method */
  constructor(meta: Pick<SystemMeta, 'coordinates' | 'order'>, against: MethodOptions) {
    this.against = against;
    this.n = meta.coordinates.length;
    this.size = leastSizes(meta);
  }

  /** Time to which was compared, s; 0 before the first row. */
  get compared(): number {
    return this.digits.at(-1)?.[0] ?? 0;
  }

  /**
   * The next rows of the first or the second run.
   * @param columns t, coordinates, rates, and whatever else the run has
   */
  take(run: 'first' | 'second', columns: readonly Float64Array[], rows: number): void {
    if (this.apart) return;
    const queue = this.waiting[run === 'first' ? 0 : 1];
    const width = 1 + 2 * this.n;
    for (let row = 0; row < rows; row++) queue.push(Float64Array.from({ length: width }, (_, c) => columns[c]![row]!));
    this.compare();
  }

  /** Whether more rows would tell nothing. */
  get over(): boolean {
    return this.apart;
  }

  /**
   * Both runs are over: their last rows are compared too where the same event ended both, at times that differ by the
   * error of the event, from which the second is taken to the first's by its rates.
   */
  finish(first: End, second: End): Trust {
    const [[a, moreA], [b, moreB]] = this.waiting;
    if (a && b && !moreA && !moreB && first.reason === second.reason) {
      const later = a[0]! - b[0]!;
      for (let i = 1; i <= this.n; i++) b[i]! += b[this.n + i]! * later;
      this.row(a, b);
    }
    return this.trust;
  }

  /** As far as is known so far. */
  get trust(): Trust {
    const { digits, against, compared } = this;
    const [four, two, one] = ASKED.map((asked) => {
      const lost = digits.findIndex(([, d]) => d < asked);
      return lost < 0 ? compared : (digits[lost - 1]?.[0] ?? digits[0]![0]);
    });
    return { digits, until: { 4: four!, 2: two!, 1: one! }, against, compared };
  }

  private compare(): void {
    const [first, second] = this.waiting;
    let row = 0;
    while (row < first.length && row < second.length && !this.apart) {
      if (first[row]![0] === second[row]![0]) this.row(first[row]!, second[row++]!);
      else this.apart = true;
    }
    first.splice(0, row);
    second.splice(0, row);
  }

  private row(first: Float64Array, second: Float64Array): void {
    let largest = 0;
    for (let i = 0; i < this.n; i++) {
      const [a, b] = [first[i + 1]!, second[i + 1]!];
      this.size[i] = Math.max(this.size[i]!, Math.abs(b));
      // Not `>`: a number that is none must count as a difference.
      const difference = Math.abs(a - b) / this.size[i]!;
      largest = difference <= largest ? largest : difference;
    }
    this.digits.push([first[0]!, digitsOf(largest)]);
  }
}

function digitsOf(difference: number): number {
  if (Number.isNaN(difference)) return 0;
  const digits = Math.min(Math.max(-Math.log10(difference), 0), MOST_DIGITS);
  return Math.floor(STEPS_PER_DIGIT * digits) / STEPS_PER_DIGIT;
}

/** In words, for people who read a file: until when so many digits hold, and what says so. */
export function trustSentence({ until, against, compared }: Trust): string {
  const held = (['4', '2', '1'] as const).map(
    (d) => `to ${d} ${d === '1' ? 'digit' : 'digits'} until t = ${short(until[d])} s`,
  );
  return `right ${held.join(', ')}; compared to t = ${short(compared)} s with ${against.name} at rtol ${against.rtol}`;
}

/** A time cut, not rounded, to a thousandth: a run is right at least so long. */
const short = (t: number): string => String(Math.floor(t * 1000 + 1e-6) / 1000);
