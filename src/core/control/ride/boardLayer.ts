import { cosine, sine } from '../../elementary/trigonometry.ts';
import type { SystemMeta } from '../../model/system.ts';
import { place, type Layer } from './layer.ts';

/**
 * A board without a body on it: feet from outside follow targets of the plates' own roll, as in the cases of pumping. Both
 * plates rolled the same way lean the board, against each other they turn it.
 */

/** Of each plate's own roll at a whole command, rad. */
const LEAN = 0.09;
const TWIST = 0.16;
/** Of the stroke: together, a little above the frequency that costs least, so that the board takes up speed. */
const PUMP = 0.4;
const FREQUENCY = 1.2;
/** N·m/rad, N·m·s/rad: as stiff as feet can be that act every 5 ms on plates as light (0.004 kg·m²). */
const KP = 20;
const KD = 0.8;
/** N·m: what a foot gives at most, and what a command asks of it without help. */
const LIMIT = 60;
const DIRECT = 4;

/** @param meta of a system whose feet act from outside */
export function boardLayer(meta: SystemMeta): Layer {
  const rolls = meta.gait!.feet.map((foot) =>
    meta.inputs.find((input) => input.name === foot)!.tracks!.map((name) => place(meta, name)),
  );
  return {
    lean: null,
    body: [],
    limit: LIMIT,
    direct: DIRECT,
    ask({ t, q, v, wish }, feet) {
      const w = 2 * Math.PI * FREQUENCY;
      const target = PUMP * wish.pump * sine(w * t) - LEAN * wish.lean;
      const rate = PUMP * wish.pump * w * cosine(w * t);
      for (let k = 0; k < 2; k++) {
        const own = rolls[k]!;
        let [roll, rolling] = [-(target - (k === 0 ? 1 : -1) * TWIST * wish.twist), -rate];
        for (let i = 0; i < own.length; i++) {
          roll += q[own[i]!]!;
          rolling += v[own[i]!]!;
        }
        feet[k] = -KP * roll - KD * rolling;
      }
    },
  };
}
