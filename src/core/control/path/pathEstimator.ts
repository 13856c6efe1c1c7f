import { cosine, sine } from '../../elementary/trigonometry.ts';
import type { Estimate, Estimator } from '../../mechanics/forcing.ts';
import { Covariance } from './covariance.ts';
import { turned, type PathCurve, type PathPlace } from './pathCurve.ts';
import { alongThePath, TurnModel, type PathFilter } from './pathFilter.ts';
import type { Plane } from './steadyTurn.ts';

/**
 * The Kalman filter of a follower: it expects what the steady turn of the path's curvature makes of the deviations from it,
 * and corrects the state over the ground by what the sensors read, one after the other. Its covariance goes along, in the
 * path's axes: what a sensor of the ground says about them changes as the path turns (an extended Kalman filter; B. D. O.
 * Anderson and J. B. Moore, Optimal Filtering, section 8.2). Plain arrays; nothing is allocated once it goes.
 */
export class PathEstimator implements Estimator {
  private readonly filter: PathFilter;
  private readonly curve: PathCurve;
  private readonly plane: Plane;

  constructor(filter: PathFilter, curve: PathCurve, plane: Plane) {
    this.filter = filter;
    this.curve = curve;
    this.plane = plane;
  }

  begin(): Estimate {
    return new PathEstimate(this.filter, this.curve, this.plane);
  }
}

class PathEstimate implements Estimate {
  readonly q: Float64Array;
  readonly v: Float64Array;
  private readonly model: TurnModel;
  private readonly sensors: ReturnType<PathFilter['makeSensors']>;
  private readonly place: PathPlace = { x: 0, y: 0, heading: 0, curvature: 0 };
  /** Errors of the sensors that are followed. */
  private readonly bias: Float64Array;
  /** Of the deviations along and across the path, coordinates, then velocities, then of those errors. */
  private readonly covariance: Covariance;
  private readonly walked: readonly number[];
  /** Deviations, and behind them what lagging inputs give. */
  private readonly e: Float64Array;
  private readonly next: Float64Array;
  private readonly given: Float64Array;
  private readonly past: Float64Array;
  private readonly slopes: Float64Array;
  /** Those by the states, without the followed errors. */
  private readonly ofStates: Float64Array;
  private readonly change: Float64Array;
  private readonly read: Float64Array;
  private readonly expected: Float64Array;

  constructor(
    private readonly filter: PathFilter,
    private readonly curve: PathCurve,
    private readonly plane: Plane,
  ) {
    const { start, slow, memory, variances } = filter;
    const n = start.q.length;
    const size = 2 * n + slow.length;
    [this.q, this.v] = [start.q.slice(), start.v.slice()];
    const k = filter.inputs;
    this.model = new TurnModel(n, k, slow.length, memory.acting.length);
    this.sensors = filter.makeSensors();
    [this.e, this.next] = [new Float64Array(size), new Float64Array(size)];
    this.given = new Float64Array(slow.length);
    this.past = new Float64Array(k * (memory.count + 1));
    this.bias = new Float64Array(filter.biases.length);
    const all = 2 * n + this.bias.length;
    [this.slopes, this.change] = [new Float64Array(all), new Float64Array(all)];
    this.ofStates = this.slopes.subarray(0, 2 * n);
    [this.read, this.expected] = [new Float64Array(variances.length), new Float64Array(variances.length)];
    this.settle();
    const { curvatures } = filter;
    const nearest = curvatures.reduce(
      (best, kappa, i) =>
        Math.abs(kappa - this.place.curvature) < Math.abs(curvatures[best]! - this.place.curvature) ? i : best,
      0,
    );
    this.covariance = new Covariance(2 * n, this.bias.length);
    this.covariance.start(
      filter.unknown[nearest]!,
      filter.biases.map(({ first }) => first),
    );
    this.walked = filter.biases.map(({ walk }) => walk * walk * filter.sample);
  }

  measure(k: number, _t: number, q: ArrayLike<number>, v: ArrayLike<number>): void {
    this.sensors.read(k, q, v, this.read);
    this.sensors.exact(this.q, this.v, this.expected);
    for (let i = 0; i < this.read.length; i++) this.read[i]! -= this.expected[i]!;
    this.takeIn();
  }

  correct(t: number, off: ArrayLike<number>): void {
    const { start } = this.filter;
    this.sensors.exact(
      start.q.map((q, i) => q + start.v[i]! * t),
      start.v,
      this.read,
    );
    this.sensors.exact(this.q, this.v, this.expected);
    for (let i = 0; i < this.read.length; i++) this.read[i]! += off[i]! - this.expected[i]!;
    this.takeIn();
  }

  /** Corrects by what was read beyond what was expected, sensor by sensor: their noises are independent. */
  private takeIn(): void {
    const { q, v, bias, covariance, plane, sensors, slopes, change, read, filter } = this;
    const n = q.length;
    const [c, s] = [cosine(this.place.heading), sine(this.place.heading)];
    change.fill(0);
    for (let i = 0; i < read.length; i++) {
      let off = read[i]!;
      sensors.slopes(i, q, v, this.ofStates);
      alongThePath(slopes, plane, n, c, s);
      for (let k = 0; k < bias.length; k++) {
        slopes[2 * n + k] = filter.biases[k]!.place === i ? 1 : 0;
        off -= slopes[2 * n + k]! * bias[k]!;
      }
      covariance.take(slopes, off, filter.variances[i]!, change);
    }
    // From along and across the path to the ground's axes: the turn back.
    alongThePath(change, plane, n, c, -s);
    for (let i = 0; i < n; i++) {
      q[i]! += change[i]!;
      v[i]! += change[n + i]!;
    }
    for (let k = 0; k < bias.length; k++) bias[k]! += change[2 * n + k]!;
  }

  know(_t: number, q: ArrayLike<number>, v: ArrayLike<number>): void {
    this.q.set(q);
    this.v.set(v);
    this.bias.fill(0);
    this.covariance.clear();
    this.settle();
  }

  fill(inputs: ArrayLike<number>): void {
    const k = this.model.u0.length;
    for (let i = 0; i < this.past.length; i++) this.past[i] = inputs[i % k]!;
    this.filter.slow.forEach((i, at) => (this.given[at] = inputs[i]!));
  }

  predict(asked: ArrayLike<number>): void {
    const { model, past, e, next, given, filter } = this;
    const n = this.q.length;
    const size = e.length;
    const k = model.u0.length;
    past.copyWithin(k, 0);
    past.set(asked);
    this.settle();
    this.takeOff();
    filter.slow.forEach((i, at) => (e[2 * n + at] = given[at]! - model.u0[i]!));
    for (let part = 0; part < model.parts.length; part++) {
      const { A, B } = model.parts[part]!;
      const { age } = filter.memory.acting[part]!;
      for (let r = 0; r < size; r++) {
        let sum = 0;
        for (let c = 0; c < size; c++) sum += A[r * size + c]! * e[c]!;
        for (let c = 0; c < k; c++) sum += B[r * k + c]! * (past[age * k + c]! - model.u0[c]!);
        next[r] = sum;
      }
      e.set(next);
    }
    filter.slow.forEach((i, at) => (given[at] = e[2 * n + at]! + model.u0[i]!));
    this.moveOn();
    this.covariance.grow(model.F, model.W, this.walked);
  }

  /** The nearest place of the path, and the model of its turn. */
  private settle(): void {
    const { q, plane, place, model } = this;
    this.curve.nearest(q[plane.x]!, q[plane.y]!, q[plane.heading]!, place);
    this.filter.models.at(place.curvature, model.row);
  }

  /** The deviations from the turn at the place, into e: along the path it is where it is, and so is what rolls. */
  private takeOff(): void {
    const { q, v, plane, place, model, e } = this;
    const n = q.length;
    for (let i = 0; i < n; i++) {
      e[i] = q[i]! - model.q0[i]!;
      e[n + i] = v[i]!;
    }
    [e[plane.x], e[plane.y]] = [q[plane.x]! - place.x, q[plane.y]! - place.y];
    alongThePath(e, plane, n, cosine(place.heading), sine(place.heading));
    e[plane.x] = 0;
    e[plane.heading] = turned(q[plane.heading]! - place.heading - model.q0[plane.heading]!);
    for (const i of this.filter.rolls) e[i] = 0;
    for (let i = 0; i < n; i++) e[n + i]! -= model.v0[i]!;
  }

  /** The turn goes on along its arc for a sample, the deviations e with it: the state over the ground. */
  private moveOn(): void {
    const { q, v, plane, place, model, e, filter } = this;
    const n = q.length;
    const along = model.v0[plane.x]! * filter.sample;
    const half = (place.curvature * along) / 2;
    // The chord of the arc.
    const chord = along * (Math.abs(half) < 1e-4 ? 1 - (half * half) / 6 : sine(half) / half);
    place.x += chord * cosine(place.heading + half);
    place.y += chord * sine(place.heading + half);
    place.heading += 2 * half;
    const heading = q[plane.heading]!;
    for (let i = 0; i < n; i++) e[n + i]! += model.v0[i]!;
    alongThePath(e, plane, n, cosine(place.heading), -sine(place.heading));
    for (const i of filter.rolls) e[i]! += q[i]! + model.v0[i]! * filter.sample - model.q0[i]!;
    for (let i = 0; i < n; i++) {
      q[i] = model.q0[i]! + e[i]!;
      v[i] = e[n + i]!;
    }
    q[plane.x] = place.x + e[plane.x]!;
    q[plane.y] = place.y + e[plane.y]!;
    q[plane.heading] = heading + turned(place.heading + q[plane.heading]! - heading);
  }
}
